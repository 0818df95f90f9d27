"""What the named rules measure: ways, doors, where one can turn and pass; clear floor, heights within reach, room for knees."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString
from shapely.geometry.base import BaseGeometry

from robolayout._text import listed
from robolayout.assets import category_of
from robolayout.scene import OPENINGS
from robolayout.verify._approaches import SIDES, needs_no_use, side_edge, strip, use_sides
from robolayout.verify._boxes import corners, room_polygon
from robolayout.verify._knees import is_sat_at, knee_width
from robolayout.verify._space import Space, disc_space, reached_by
from robolayout.verify.agent_report import AgentReport
from robolayout.verify.heading import convex_places
from robolayout.verify.limits import ADA
from robolayout.verify.navigation import Navigation
from robolayout.verify.passages import largest
from robolayout.verify.proofs import exempt_from_reach
from robolayout.verify.routes import Triangulation, find_routes


@dataclass(frozen=True)
class Measured:
    """What was measured for a rule."""

    met: bool  # the verdict
    value: float  # the figure that decides, in the rule's unit
    text: str  # the measurement in words


def route_width(body: AgentReport) -> Measured | None:
    """Measure the clear width of the way to everything that the body is asked to reach."""
    nav = body.navigation
    passages = [p for name, p in nav.passages.items() if name not in exempt_from_reach(nav.scene, nav.agent)]
    if not passages:
        return None
    narrow = {passage.asset for passage in passages} - _reached_by(nav, ADA.route)
    worst, inside = min(passages, key=lambda passage: passage.width), _inside_door(nav)
    tight = inside[inside < ADA.route - ADA.close]
    if not narrow and not len(tight):
        width = max(min(worst.width, float(inside.min(initial=math.inf))), ADA.route)
        return Measured(True, width, f"{width:.2f} m or more to everything")
    entry = float(tight.min(initial=math.inf))
    if narrow and worst.width <= entry:
        width = worst.width
        text = f"{worst.shown if width else 'no way'} to {worst.asset}{worst.sides and f', between {worst.sides}'}"
    else:
        width, text = entry, f"{entry:.2f} m just inside door 0"
    tight_entry = entry < ADA.pinch - ADA.close
    pinches = None if tight_entry else _pinches(nav, narrow) if narrow else []
    if pinches is None:
        return Measured(False, width, text)
    longest = max(*pinches, ADA.fine * len(tight), 0.0)
    if longest > ADA.pinch_length + ADA.close:
        return Measured(False, width, f"{text}, less than {ADA.route} m over {longest:.2f} m")
    return Measured(True, width, f"{text}, over {longest:.2f} m only")


def _inside_door(nav: Navigation) -> NDArray[np.float64]:
    """Return the widths of the way in through the first door's landing: where the ways to things begin, it may lie behind."""
    room = nav.scene.room
    way = [room.walls[d.wall].point(d.center, depth) for d in room.doors[:1] for depth in (0.0, OPENINGS.landing_depth)]
    return _widths(LineString(way), _solid(nav)) if way else np.zeros(0)


def _solid(nav: Navigation) -> BaseGeometry:
    """Return the walls and what is in the body's way."""
    return shapely.union_all([room_polygon(nav.scene.room).exterior, *nav.blocking.shapes])


def _space(nav: Navigation, width: float) -> Space:
    return disc_space(nav.scene.room, nav.blocking, width / 2)


def _reached_by(nav: Navigation, width: float) -> set[str]:
    """Return what a disc of another width reaches with the body's arm."""
    reached = reached_by(nav.boxes, _space(nav, width), replace(nav.agent, radius=width / 2).reach)
    return {nav.boxes.names[row] for row in np.flatnonzero(reached)}


def _pinches(nav: Navigation, names: Iterable[str]) -> list[float] | None:
    """Return the lengths of the narrow parts of the ways to some things; None where even the exception is too wide."""
    slim, wide = _space(nav, ADA.pinch), _space(nav, ADA.route)
    goals = {name: nav.boxes.footprints[nav.boxes.names.index(name)] for name in sorted(names)}
    if not set(goals) <= _reached_by(nav, ADA.pinch):
        return None
    # Where the slim disc lies within a wide one that is free.
    covered = shapely.get_parts(wide.free.buffer((ADA.route - ADA.pinch) / 2))
    mesh, solid = Triangulation(slim.main), _solid(nav)
    found: list[float] = []
    for route in find_routes(nav.scene.room, slim, goals).values():
        found += _narrow(route.line, covered, mesh, solid)
    return found or [0.0]


def _narrow(line: LineString, covered: NDArray[np.object_], mesh: Triangulation, solid: BaseGeometry) -> list[float]:
    """Return the lengths of the narrow stretches of a way, two that are not far enough apart as one."""
    rest = shapely.get_parts(line.difference(shapely.union_all(covered)))
    stretches: list[tuple[float, float]] = []
    for part in (part for part in rest if isinstance(part, LineString) and part.length > 0):
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


def _through(part: LineString, covered: NDArray[np.object_], mesh: Triangulation) -> LineString:
    """Return the shortest way from one covered piece to the next where a part of a way leads from the one to the other."""
    first, last = (int(np.argmin(shapely.distance(covered, shapely.Point(part.coords[i])))) for i in (0, -1))
    if first == last:
        return part
    start, end = shapely.shortest_line(covered[first], covered[last]).coords
    points = mesh.route(mesh.search((start[0], start[1])), shapely.Point(end).buffer(ADA.close))
    return LineString(points) if len(points) > 1 else part


def _length(line: LineString, solid: BaseGeometry) -> float:
    """Return on how much of a way walls or obstacles on its left and right leave less than the clear width between them."""
    return float((_widths(line, solid) < ADA.route - ADA.close).sum()) * ADA.fine


def _widths(line: LineString, solid: BaseGeometry) -> NDArray[np.float64]:
    """Return how much walls or obstacles left and right of a way leave between them, up to twice the clear width."""
    at = np.arange(ADA.fine / 2, line.length, ADA.fine)
    points = shapely.get_coordinates(shapely.line_interpolate_point(line, at))
    ahead = shapely.get_coordinates(shapely.line_interpolate_point(line, at + ADA.close)) - points
    across = ADA.route * np.stack([-ahead[:, 1], ahead[:, 0]], axis=1) / np.hypot(*ahead.T)[:, None]
    width = np.zeros(len(points))
    for side in (across, -across):
        hit = shapely.intersection(shapely.linestrings(np.stack([points, points + side], axis=1)), solid)
        away = shapely.distance(shapely.points(points), hit)
        width += np.where(np.isnan(away), ADA.route, away)
    return width


def door_width(body: AgentReport, least: float = ADA.pinch) -> Measured | None:
    """Measure the narrowest door, in metres."""
    doors = body.navigation.scene.room.doors
    if not doors:
        return None
    number = min(range(len(doors)), key=lambda i: doors[i].width)
    width = doors[number].width
    return Measured(width >= least - 1e-9, width, f"door {number} is {width:.2f} m wide")


door_width_iso = partial(door_width, least=0.8)


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

    def free(step: int) -> bool:
        return bool(_space(nav, step * ADA.fine).free.intersects(nav.main))

    return ADA.fine * largest(free, round(ADA.circle / ADA.fine))


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


def _asked(body: AgentReport) -> NDArray[np.intp]:
    """Return the rows of the placed things that the body is asked to use."""
    found = body.navigation.boxes
    exempt = np.array([name in body.exempt for name in found.names], dtype=bool)
    return np.flatnonzero(found.placed & ~needs_no_use(found) & ~exempt)


def _all(count: int) -> str:
    return "the one thing" if count == 1 else f"all {count} things"


def _listed(body: AgentReport, rows: NDArray[np.intp]) -> str:
    names = [body.navigation.boxes.names[row] for row in rows]
    return listed(names, ADA.named)


def floor_space(body: AgentReport) -> Measured | None:
    """Count the furniture on the floor beside which no clear floor space adjoins a side that it is used from."""
    found, rows = body.navigation.boxes, _asked(body)
    on_floor = np.array([asset.on_floor for asset in found.assets], dtype=bool)
    rows = rows[((found.carriers < 0) & ~found.movable & on_floor)[rows]]
    if not len(rows):
        return None
    sides = use_sides(found.assets)
    has = [any(_has_floor(body, row, side, ways=(0, 1)) for side in sides[row]) for row in rows.tolist()]
    short = rows[~np.array(has)]
    text = f"none at {_listed(body, short)}" if len(short) else f"at {_all(len(rows))}"
    return Measured(not len(short), float(len(short)), text)


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
    found, rows = body.navigation.boxes, _asked(body)
    if not len(rows):
        return None
    beyond = np.maximum(ADA.low - found.top[rows], found.bottom[rows] - ADA.high)
    out = rows[beyond > ADA.contact]
    worst = float(beyond.max()) if len(out) else 0.0
    text = f"beyond it by up to {worst:.2f} m: {_listed(body, out)}" if len(out) else _all(len(rows))
    return Measured(not len(out), worst, text)


def reach_over(body: AgentReport) -> Measured | None:
    """Measure how far over what carries them things stand from where the body gets to, and how high."""
    found, main, rows = body.navigation.boxes, body.navigation.main, _asked(body)
    rows = rows[found.carriers[rows] >= 0]
    if not len(rows) or main.is_empty:
        return None
    under = found.carriers[rows]
    arms = shapely.shortest_line(main, found.footprints[rows])
    depth = shapely.length(shapely.intersection(arms, found.footprints[under]))
    deep = depth > ADA.full_depth
    high = np.where(deep, ADA.high_over, ADA.high)
    too_far = (depth > ADA.over_depth) | (deep & (found.top[under] > ADA.over_height + ADA.contact))
    out = rows[too_far | (found.bottom[rows] > high + ADA.contact)]
    text = f"too far or too high: {_listed(body, out)}" if len(out) else f"{_all(len(rows))} on tops"
    return Measured(not len(out), float(depth.max()), text)


def knee_room(body: AgentReport) -> Measured | None:
    """Measure the widest room for knees and toes under what chairs stand at, from its shape."""
    found = body.navigation.boxes
    rows = [row for row in _asked(body).tolist() if found.chairs_at(row) and is_sat_at(found.assets[row])]
    if not rows:
        return None
    width, name = max((max(knee_width(found.assets[row], side) for side in SIDES), found.names[row]) for row in rows)
    return Measured(width >= ADA.knee_width - ADA.contact, width, f"{width:.2f} m wide under {name}, by its shape")
