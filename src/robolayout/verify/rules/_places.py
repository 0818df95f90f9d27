"""Rules of places: clear floor at furniture and beds, heights within reach, room for knees."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np
import shapely
from shapely import LineString
from shapely.geometry.base import BaseGeometry

from robolayout.assets import category_of
from robolayout.verify._ada import ADA
from robolayout.verify._approaches import needs_no_use, use_sides
from robolayout.verify._boxes import corners
from robolayout.verify._knees import is_sat_at, knee_width
from robolayout.verify._sides import SIDES, side_edge, strip
from robolayout.verify.agent_report import AgentReport
from robolayout.verify.heading import convex_places
from robolayout.verify.rules._rule import Measured


def _asked(body: AgentReport) -> Iterator[int]:
    """Yield the rows of the placed things that the body is asked to use."""
    found = body.navigation.boxes
    for row in np.flatnonzero(found.placed & ~needs_no_use(found)).tolist():
        if found.names[row] not in body.exempt:
            yield row


def _all(count: int) -> str:
    return "the one thing" if count == 1 else f"all {count} things"


def _listed(names: list[str]) -> str:
    return ", ".join(names[: ADA.named]) + (f" and {len(names) - ADA.named} more" if len(names) > ADA.named else "")


def floor_space(body: AgentReport) -> Measured | None:
    """Count the furniture on the floor beside which no clear floor space adjoins a side that it is used from."""
    nav, found = body.navigation, body.navigation.boxes
    rows = [
        row for row in _asked(body) if found.carriers[row] < 0 and not found.movable[row] and found.assets[row].on_floor
    ]
    if not rows:
        return None
    sides = use_sides(found.assets)
    short = [nav.boxes.names[r] for r in rows if not any(_has_floor(body, r, side, ways=(0, 1)) for side in sides[r])]
    text = f"none at {_listed(short)}" if short else f"at {_all(len(rows))}"
    return Measured(not short, float(len(short)), text)


def _has_floor(body: AgentReport, row: int, side: str, ways: tuple[int, ...]) -> bool:
    """Tell whether a clear floor space adjoins a side where the body gets to; `ways` 0: parallel to it, 1: straight towards it."""
    nav = body.navigation
    away = nav.blocking.moved_for(nav.boxes, row)
    rest = nav.blocking.of(set(nav.blocking.rows.tolist()) - away)
    edge = side_edge(nav.boxes.footprints[row], side)
    near = rest.shapes[shapely.dwithin(rest.shapes, edge, sum(ADA.floor))]
    (ax, ay), (bx, by) = edge.coords
    length = math.hypot(bx - ax, by - ay)
    out = np.array([by - ay, ax - bx]) / length
    heading = math.atan2(out[1], out[0])
    for way in ways:
        depth, width = ADA.floor[way], ADA.floor[1 - way]
        body_corners = corners(
            np.array([[0.0, 0.0, 0.0, heading]]), np.array([[depth - ADA.contact, width - ADA.contact]])
        )[0]
        middle = LineString(np.array([[ax, ay], [bx, by]]) + out * depth / 2)
        for place in convex_places(nav.scene.room, near, body_corners):
            there: BaseGeometry = middle.intersection(place.buffer(ADA.contact))
            if not there.is_empty and there.distance(nav.main) <= ADA.floor[1] / 2 + nav.space.radius:
                return True
    return False


def bed_transfer(body: AgentReport) -> Measured | None:
    """Measure on how many sides of a bed there is a clear floor space along it; one between two beds is enough."""
    found = body.navigation.boxes
    beds = [row for row in np.flatnonzero(found.placed).tolist() if _is_bed(body, row)]
    if not beds:
        return None
    best: list[tuple[int, str]] = []
    for row in beds:
        sides = [side for side in ("left", "right") if _has_floor(body, row, side, ways=(0,))]
        text = f"{found.names[row]} has it on {len(sides)} of 2 sides"
        if len(sides) < 2 and any(_another_bed(body, row, side, beds) for side in sides):
            best.append((2, f"{text}, between two beds"))
        best.append((len(sides), text))
    count, text = max(best, key=lambda entry: entry[0])
    return Measured(count == 2, float(count), text)


def _is_bed(body: AgentReport, row: int) -> bool:
    kind = category_of(body.navigation.boxes.assets[row])
    lying = kind.group in ("sleeping", "care") and kind.name.split()[-1] == "bed"
    return lying and {"left", "right"} <= set(kind.use_sides)


def _another_bed(body: AgentReport, row: int, side: str, beds: list[int]) -> bool:
    feet = body.navigation.boxes.footprints
    beside = strip(side_edge(feet[row], side), ADA.between)
    return any(other != row and feet[other].intersects(beside) for other in beds)


def reach_range(body: AgentReport) -> Measured | None:
    """Measure by how much the things to use end below or begin above the reach of somebody who sits."""
    found = body.navigation.boxes
    beyond = {found.names[row]: max(ADA.low - found.top[row], found.bottom[row] - ADA.high) for row in _asked(body)}
    if not beyond:
        return None
    out = [name for name, metres in beyond.items() if metres > ADA.contact]
    worst = max(0.0, *beyond.values()) if out else 0.0
    text = f"beyond it by up to {worst:.2f} m: {_listed(out)}" if out else _all(len(beyond))
    return Measured(not out, float(worst), text)


def reach_over(body: AgentReport) -> Measured | None:
    """Measure how far over the edge of what carries them things stand, and how high."""
    found = body.navigation.boxes
    rows = [row for row in _asked(body) if found.carriers[row] >= 0]
    if not rows:
        return None
    out: list[str] = []
    deepest = 0.0
    for row in rows:
        carrier = int(found.carriers[row])
        depth = float(found.footprints[row].distance(found.footprints[carrier].exterior))
        high = ADA.high if depth <= ADA.full_depth else ADA.high_over
        deepest = max(deepest, depth)
        if (
            depth > ADA.over_depth
            or found.top[carrier] > ADA.over_height + ADA.contact
            or found.bottom[row] > high + ADA.contact
        ):
            out.append(found.names[row])
    text = f"too far or too high: {_listed(out)}" if out else f"{_all(len(rows))} on tops"
    return Measured(not out, deepest, text)


def knee_room(body: AgentReport) -> Measured | None:
    """Measure the widest room for knees and toes under what chairs stand at, from its shape."""
    found = body.navigation.boxes
    rows = [row for row in _asked(body) if found.chairs_at(row) and is_sat_at(found.assets[row])]
    if not rows:
        return None
    width, name = max((max(knee_width(found.assets[row], side) for side in SIDES), found.names[row]) for row in rows)
    return Measured(width >= ADA.knee_width - ADA.contact, width, f"{width:.2f} m wide under {name}, by its shape")
