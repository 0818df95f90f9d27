"""What the judge found, as shapes and words for drawings and the page."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

from shapely import LineString, Polygon, get_parts, maximum_inscribed_circle, union_all
from shapely.geometry.base import BaseGeometry

from robolayout.render import PlanMarks, SheetNotes
from robolayout.render.contents import Rings
from robolayout.scene import Point, vertical_span
from robolayout.verify import AgentReport, Passage, Report, exempt_from_reach, horizontal_reach


@dataclass(frozen=True)
class MarkConfig:
    """What the plan marks for a body."""

    arc: float = math.radians(16)  # half the angle of the arcs that show how far an arm reaches on the plan
    apart: float = 0.4  # metres between the places to stand that the plan shows
    circles: int = 3  # turning circles that the plan shows: the roomiest places
    passages: int = 8  # most passages that a sheet shows: the narrowest


MARKS = MarkConfig()


def plan_marks(report: AgentReport) -> PlanMarks:
    """Return what one agent can do as shapes for the plan: free space, routes to what it is asked to reach, reach."""
    nav = report.navigation
    aside = exempt_from_reach(nav.scene, report.agent)
    routes = {name: route.points for name, route in nav.routes.items() if name not in aside}
    return PlanMarks(
        free=_rings(nav.main),
        islands=tuple(rings for rings in _rings(nav.free) if rings not in _rings(nav.main)),
        routes=routes,
        passages=tuple(_span(passage) for passage in _narrow(report)[:1]),
        blocked=report.short,
        agent_at=nav.entry,
        under=_rings(nav.main.intersection(union_all(nav.blocking.shelter))),
        parts=tuple(rings[0] for shape in nav.blocking.shapes[nav.blocking.partial] for rings in _rings(shape)),
        circles=_circles(report),
        arcs=_arcs(report),
    )


def sheet_marks(report: AgentReport) -> PlanMarks:
    """Return the same for a sheet to print: not one passage but the narrow ones, one between two things."""
    widths: dict[frozenset[str], Passage] = {}
    for passage in _narrow(report):
        widths.setdefault(frozenset(passage.between), passage)
    shown = list(widths.values())[: MARKS.passages]
    return replace(plan_marks(report), passages=tuple(_span(passage) for passage in shown))


def _narrow(report: AgentReport) -> list[Passage]:
    """Return the passages on the ways to what the agent is asked to reach that have a place, narrowest first."""
    aside = exempt_from_reach(report.navigation.scene, report.agent)
    ways = [p for name, p in report.navigation.passages.items() if name not in aside]
    return sorted((p for p in ways if p.point is not None and p.between), key=lambda p: p.width)


def _circles(report: AgentReport) -> tuple[tuple[Point, float], ...]:
    """Return the turning circle of a rectangular body at the roomiest spot of each place where it can turn."""
    agent, space = report.agent, report.headings
    if space is None:
        return ()
    spots = [maximum_inscribed_circle(place, 0.01).coords[0] for place in list(space.turning.geoms)[: MARKS.circles]]
    return tuple(((float(x), float(y)), agent.turning_circle) for x, y in spots)


def _arcs(report: AgentReport) -> tuple[tuple[Point, ...], ...]:
    """Return where the body stands to use things and how far its arm reaches there: a short arc towards each."""
    agent, nav = report.agent, report.navigation
    room = Polygon(nav.scene.room.vertices)
    found: list[tuple[Point, ...]] = []
    for name, use in report.usage.uses.items() if agent.reach_distance is not None else ():
        reach = horizontal_reach(agent, *vertical_span(nav.scene.by_name[name], nav.layout[name]))
        if use.stand is not None and reach is not None and all(math.dist(use.stand, a[0]) > MARKS.apart for a in found):
            (x, y), pose = use.stand, nav.layout[name]
            middle = math.atan2(pose.y - y, pose.x - x)
            turns = [middle + MARKS.arc * (step / 8 - 1) for step in range(17)]
            rays = [LineString([(x, y), (x + reach * math.cos(t), y + reach * math.sin(t))]) for t in turns]
            ends = [_inside(room, ray) for ray in rays if room.covers(LineString(ray.coords[:1] * 2))]
            found.append(((x, y), *ends))
    return tuple(found)


def _inside(room: Polygon, ray: LineString) -> Point:
    """Return where a ray that begins in a room first leaves it, or its end."""
    parts = [part.coords for part in get_parts(room.intersection(ray)) if part.geom_type == "LineString"]
    first = min(parts or [ray.coords], key=lambda coords: math.dist(coords[0], ray.coords[0]))
    x, y = first[-1]
    return (float(x), float(y))


def _span(passage: Passage) -> tuple[Point, Point, float]:
    """Return the ends of the narrowest place and its width in metres."""
    return (passage.ends[0], passage.ends[-1], passage.width)


def _rings(shape: BaseGeometry) -> tuple[Rings, ...]:
    """Return the polygons of a shape as rings of points, outer ring first."""
    return tuple(
        tuple(tuple((float(x), float(y)) for x, y in ring.coords) for ring in (part.exterior, *part.interiors))
        for part in get_parts(shape)
        if part.geom_type == "Polygon" and not part.is_empty
    )


STANDS = 0.05  # metres above the floor up to which a thing stands on it


def sheet_notes(report: Report, date: str = "") -> SheetNotes:
    """Return areas, findings and rules for the first body of a report; `date` is what the title block says."""
    first = report.agents[0]
    helps = first.remedies.sentences(first.agent)
    rules = tuple(
        (row["name"], f"{row['measured']} ({row['source']})", row["met"])
        for row in rule_rows(report)
        if row["agent"] == first.agent.name
    )
    findings = (*report.violations, *helps)
    return SheetNotes(date, _areas(first), report.verdict, findings, rules, first.navigation.boxes.carried)


def rule_rows(report: Report) -> list[dict[str, Any]]:
    """Return the named rules of a report as plain data: for whom, what, its source, what was measured, and whether it is met."""
    return [
        {
            "agent": found.agent,
            "name": found.rule.name.replace("_", " "),
            "asks": found.rule.asks,
            "source": found.rule.origin,
            "measured": found.measured.text,
            "met": found.met,
        }
        for found in report.rules
    ]


def _areas(first: AgentReport) -> tuple[tuple[str, str], ...]:
    """Return the areas of a room, and how much of it is furnished and free."""
    nav = first.navigation
    room = Polygon(nav.scene.room.vertices)
    placed = [(nav.scene.by_name[name], pose) for name, pose in nav.layout.items()]
    standing = [
        Polygon(pose.corners(asset.size))
        for asset, pose in placed
        if not asset.is_flat and vertical_span(asset, pose)[0] < STANDS
    ]
    furnished = union_all(standing).intersection(room).area
    return (
        ("Floor", f"{room.area:.2f} m2"),
        ("under furniture", f"{furnished:.2f} m2"),
        ("free floor", f"{room.area - furnished:.2f} m2"),
        ("where the body's centre gets to", f"{nav.main.area:.2f} m2"),
        ("Height of the walls", f"{nav.scene.room.wall_height:.2f} m"),
    )
