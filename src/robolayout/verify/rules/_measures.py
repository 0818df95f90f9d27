"""What the named rules measure: ways, doors, where one can turn and pass; clear floor, heights within reach, room for knees."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString
from shapely.geometry.base import BaseGeometry

from robolayout.assets import category_of
from robolayout.verify._ada import ADA
from robolayout.verify._approaches import needs_no_use, use_sides
from robolayout.verify._boxes import corners, room_polygon
from robolayout.verify._knees import is_sat_at, knee_width
from robolayout.verify._sides import SIDES, side_edge, strip
from robolayout.verify._space import Space, disc_space, plan_distances, reached_rows
from robolayout.verify.agent_report import AgentReport
from robolayout.verify.heading import convex_places
from robolayout.verify.navigation import Navigation
from robolayout.verify.passages import Passage, largest
from robolayout.verify.proofs import exempt_from_reach
from robolayout.verify.routes import Mesh, find_routes
from robolayout.verify.rules._rule import Measured


def route_width(body: AgentReport) -> Measured | None:
    """Measure the clear width of the way to everything that the body is asked to reach."""
    nav = body.navigation
    passages = [p for name, p in nav.passages.items() if name not in exempt_from_reach(nav.scene, nav.agent)]
    if not passages:
        return None
    names = {passage.asset for passage in passages}
    narrow = names - _reached_by(nav, ADA.route)
    worst = min(passages, key=lambda passage: passage.width)
    if not narrow:
        return Measured(True, max(worst.width, ADA.route), f"{max(worst.width, ADA.route):.2f} m or more to everything")
    pinches = _pinches(nav, narrow)
    where = f", between {worst.sides}" if worst.sides else ""
    if pinches is None or not all(length <= ADA.pinch_length for length in pinches):
        longest = "" if pinches is None else f", less than {ADA.route} m over {max(pinches):.2f} m"
        return Measured(False, worst.width, f"{_shown(worst)} to {worst.asset}{where}{longest}")
    return Measured(True, worst.width, f"{_shown(worst)} to {worst.asset}{where}, over {max(pinches):.2f} m only")


def _shown(passage: Passage) -> str:
    return "no way" if passage.width == 0 else passage.shown


def _space(nav: Navigation, width: float) -> Space:
    return disc_space(nav.scene.room, nav.blocking, width / 2)


def _reached_by(nav: Navigation, width: float) -> set[str]:
    """Return what a disc of another width reaches with the body's arm."""
    distances = plan_distances(nav.boxes, _space(nav, width), nav.agent.reach)
    return {nav.boxes.names[row] for row in np.flatnonzero(reached_rows(nav.boxes, distances, nav.agent.reach))}


def _pinches(nav: Navigation, names: Iterable[str]) -> list[float] | None:
    """Return the lengths of the narrow parts of the ways to some things; None where even the exception is too wide."""
    slim, wide = _space(nav, ADA.pinch), _space(nav, ADA.route)
    goals = {name: nav.boxes.footprints[nav.boxes.names.index(name)] for name in sorted(names)}
    if not set(goals) <= _reached_by(nav, ADA.pinch):
        return None
    # Where the slim disc lies within a wide one that is free.
    covered = shapely.get_parts(wide.free.buffer((ADA.route - ADA.pinch) / 2))
    mesh, solid = Mesh(slim.main), shapely.union_all([room_polygon(nav.scene.room).exterior, *nav.blocking.shapes])
    found: list[float] = []
    for route in find_routes(nav.scene.room, slim, goals).values():
        found += _narrow(route.line, covered, mesh, solid)
    return found or [0.0]


def _narrow(line: LineString, covered: NDArray[np.object_], mesh: Mesh, solid: BaseGeometry) -> list[float]:
    """Return the lengths of the narrow stretches of a way, two that are not far enough apart as one."""
    rest = shapely.get_parts(line.difference(shapely.union_all(covered)))
    stretches: list[tuple[float, float]] = []
    for part in (part for part in rest if isinstance(part, LineString)):
        middle = line.project(part.interpolate(0.5, normalized=True))
        half = _length(_through(part, covered, mesh), solid) / 2
        if half > ADA.close:
            stretches.append((middle - half, middle + half))
    joined: list[tuple[float, float]] = []
    for start, end in sorted(stretches):
        if joined and start - joined[-1][1] < ADA.pinch_apart:
            start = joined.pop()[0]
        joined.append((start, end))
    return [end - start for start, end in joined]


def _through(part: LineString, covered: NDArray[np.object_], mesh: Mesh) -> LineString:
    """Return the shortest way from one covered piece to the next where a part of a way leads from the one to the other."""
    first, last = (int(np.argmin(shapely.distance(covered, shapely.Point(part.coords[i])))) for i in (0, -1))
    if first == last:
        return part
    start, end = shapely.shortest_line(covered[first], covered[last]).coords
    points = mesh.route(mesh.search((start[0], start[1])), shapely.Point(end).buffer(ADA.close))
    return LineString(points) if len(points) > 1 else part


def _length(line: LineString, solid: BaseGeometry) -> float:
    """Return on how much of a way walls or obstacles on its left and right leave less than the clear width between them."""
    at = np.arange(ADA.fine / 2, line.length, ADA.fine)
    points = shapely.get_coordinates(shapely.line_interpolate_point(line, at))
    ahead = shapely.get_coordinates(shapely.line_interpolate_point(line, at + ADA.close)) - points
    across = ADA.route * np.stack([-ahead[:, 1], ahead[:, 0]], axis=1) / np.hypot(*ahead.T)[:, None]
    width = np.zeros(len(points))
    for side in (across, -across):
        hit = shapely.intersection(shapely.linestrings(np.stack([points, points + side], axis=1)), solid)
        away = shapely.distance(shapely.points(points), hit)
        width += np.where(np.isnan(away), ADA.route, away)
    return float((width < ADA.route - ADA.close).sum()) * ADA.fine


def door_width(body: AgentReport, least: float = ADA.pinch) -> Measured | None:
    """Measure the narrowest door, in metres."""
    doors = body.navigation.scene.room.doors
    if not doors:
        return None
    number = min(range(len(doors)), key=lambda i: doors[i].width)
    width = doors[number].width
    return Measured(width >= least - 1e-9, width, f"door {number} is {width:.2f} m wide")


def door_width_iso(body: AgentReport) -> Measured | None:
    """Measure the narrowest door against 0.80 m."""
    return door_width(body, 0.8)


def turning_space(body: AgentReport) -> Measured:
    """Measure the largest circle to turn in that the body gets to, and whether a T will do instead."""
    largest = _largest_circle(body.navigation)
    if largest >= ADA.circle:
        return Measured(True, largest, f"a circle of {ADA.circle} m is free")
    if _has_t(body.navigation):
        text = f"a T-shaped space in a square of {ADA.circle} m is free; the largest circle is {largest:.2f} m"
        return Measured(True, ADA.circle, text)
    return Measured(False, largest, f"the largest free circle is {largest:.2f} m, and there is no T-shaped space")


def turning_space_iso(body: AgentReport) -> Measured:
    """Measure the largest circle to turn in against 1.50 m."""
    largest = _largest_circle(body.navigation)
    whole = largest >= ADA.circle
    text = f"a circle of {ADA.circle} m is free" if whole else f"the largest free circle is {largest:.2f} m"
    return Measured(largest >= 1.5 - ADA.fine, largest, text)


def _largest_circle(nav: Navigation) -> float:
    """Return the diameter of the largest circle whose middle the body gets to, up to what is asked for."""

    def free(diameter: float) -> bool:
        return bool(_space(nav, diameter).free.intersects(nav.main))

    if nav.main.is_empty:
        return 0.0
    return ADA.fine * largest(lambda step: free(step * ADA.fine), round(ADA.circle / ADA.fine))


def _has_t(nav: Navigation) -> bool:
    """Tell whether a T-shaped turning space is free somewhere, its middle where the body gets to."""
    room, shapes = nav.scene.room, nav.blocking.shapes
    wall = room.walls[0].direction
    first = math.atan2(wall[1], wall[0])
    for turn in range(ADA.turns):
        heading = first + turn * 2 * math.pi / ADA.turns
        depth = ADA.arm / 2 + ADA.base
        bar = _box(0.0, 0.0, heading, ADA.arm, ADA.circle)
        base = _box(depth / 2 * math.cos(heading), depth / 2 * math.sin(heading), heading, depth, ADA.arm)
        places = shapely.union_all(convex_places(room, shapes, bar))
        places = places.intersection(shapely.union_all(convex_places(room, shapes, -base)))
        if places.intersects(nav.main):
            return True
    return False


def _box(x: float, y: float, heading: float, depth: float, width: float) -> NDArray[np.float64]:
    """Return the corners (4, 2) of a rectangle around a place, turned by a heading in radians."""
    return corners(np.array([[x, y, 0.0, heading]]), np.array([[depth, width]]))[0]


def passing_space(body: AgentReport) -> Measured | None:
    """Measure the longest way, which needs no passing space up to some length."""
    routes = body.navigation.routes
    if not routes:
        return None
    longest = max(route.length for route in routes.values())
    wide = longest <= ADA.interval or set(routes) <= _reached_by(body.navigation, ADA.circle)
    return Measured(wide, longest, f"the longest way is {longest:.1f} m")


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
    standing = (found.carriers < 0) & ~found.movable
    rows = [row for row in _asked(body) if standing[row] and found.assets[row].on_floor]
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
        space = _box(0.0, 0.0, heading, depth - ADA.contact, width - ADA.contact)
        middle = LineString(np.array([[ax, ay], [bx, by]]) + out * depth / 2)
        for place in convex_places(nav.scene.room, near, space):
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
