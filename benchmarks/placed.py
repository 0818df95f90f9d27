"""Where things stand to the walls, corners and openings of a room, how far apart, and how large they are, by plain geometry.

Nothing here uses the package's reader, statements or checks.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

from shapely import LineString, Point, Polygon

from benchmarks.seen import AT_WALL, IN_CORNER, SIDES, Room, in_half_at, obstacles, turned_to

ALONG_WALL = 0.35
"""Metres within which a wall is the one along which a thing stands: a chair at a desk, what stands before a shelf."""


def side_of(room: Room, wall: int) -> str:
    """Return the side of the plan at which a wall is, by its outward normal."""
    (ax, ay), (bx, by) = room.walls[wall]
    turn = 1.0 if Polygon(room.floor).exterior.is_ccw else -1.0
    x, y = turn * (by - ay), -turn * (bx - ax)
    if abs(x) > abs(y):
        return "east" if x > 0 else "west"
    return "north" if y > 0 else "south"


def walls_at(room: Room, a: str, within: float = ALONG_WALL) -> list[int]:
    """Return the walls that are at most so far from a thing."""
    shape = room.outline(a)
    return [i for i, wall in enumerate(room.walls) if shape.distance(LineString(wall)) <= within]


def at_side(room: Room, a: str, side: str) -> bool:
    """Return whether a thing stands at a wall of that side."""
    return any(side_of(room, wall) == SIDES[side] for wall in walls_at(room, a, AT_WALL))


def in_corner(room: Room, a: str, corner: str) -> bool:
    """Return whether a thing stands in that corner, "northeast" or "north-east"."""
    sides = {side_of(room, wall) for wall in walls_at(room, a, IN_CORNER)}
    return sides >= {side for side in ("north", "south", "east", "west") if side in corner}


def _length(room: Room, wall: int) -> float:
    return math.dist(*room.walls[wall])


def _at_middle(room: Room, a: str) -> bool:
    """Whether a thing is centred, within 0.25 m or 6 % of its length, along a wall at which it stands."""
    spot = Point(*room.pose(a)[:2])
    lines = [LineString(room.walls[wall]) for wall in walls_at(room, a)]
    return any(abs(line.project(spot) - line.length / 2) <= max(0.25, 0.06 * line.length) for line in lines)


def _at_wall_of(kind: str) -> Callable[[Room, str], bool]:
    def test(room: Room, a: str) -> bool:
        sides = {side_of(room, item["wall"]) for item in room.scene.get(kind, [])}
        return any(side_of(room, wall) in sides for wall in walls_at(room, a, AT_WALL))

    return test


def _at_longest(room: Room, a: str) -> bool:
    longest = max(_length(room, wall) for wall in range(len(room.walls)))
    return any(_length(room, wall) >= longest - 0.05 for wall in walls_at(room, a, AT_WALL))


def _at_shortest(room: Room, a: str) -> bool:
    shortest = min(_length(room, wall) for wall in range(len(room.walls)))
    return any(_length(room, wall) <= shortest + 0.05 for wall in walls_at(room, a, AT_WALL))


def _far_corner(room: Room, a: str) -> bool:
    """Whether a thing stands in the corner that is farthest from the first door."""
    doors = room.openings("doors")
    if not doors:
        return False
    far = max(room.floor, key=lambda corner: doors[0].distance(Point(corner)))
    return room.outline(a).distance(Point(far)) <= 2 * IN_CORNER


AT: dict[str, Callable[[Room, str], bool]] = {
    "wallmiddle": _at_middle,
    "longwall": _at_longest,
    "shortwall": _at_shortest,
    "doorside": _at_wall_of("doors"),
    "windowside": _at_wall_of("windows"),
    "cornerfar": _far_corner,
}
"""Places at the walls and corners of a room."""


def look_alike(room: Room, a: str, b: str) -> bool:
    """Return whether two things look the same way."""
    return abs(math.remainder(room.pose(a)[2] - room.pose(b)[2], math.tau)) <= math.radians(5)


def _at_one_wall(room: Room, a: str, b: str) -> bool:
    return bool(
        {side_of(room, wall) for wall in walls_at(room, a)} & {side_of(room, wall) for wall in walls_at(room, b)}
    )


def _at_other_wall(room: Room, a: str, b: str) -> bool:
    across = {"north": "south", "south": "north", "east": "west", "west": "east"}
    there = {side_of(room, wall) for wall in walls_at(room, b)}
    return any(across[side_of(room, wall)] in there for wall in walls_at(room, a))


def _parallel(room: Room, a: str, b: str) -> bool:
    return abs(math.remainder(room.pose(a)[2] - room.pose(b)[2], math.pi / 2)) <= math.radians(10)


PAIRS: dict[str, Callable[[Room, str, str], bool]] = {
    "samewall": _at_one_wall,
    "otherwall": _at_other_wall,
    "along": _parallel,
}
"""How two things stand to each other by the walls."""


def apart(room: Room, a: str, others: Sequence[str], how: str, metres: float) -> bool:
    """Return whether a thing is so far from the nearest of others, about so far within 0.15 m or 15 %."""
    return _as_far(min((room.gap(a, b) for b in others), default=math.inf), how, metres)


def _as_far(gap: float, how: str, metres: float) -> bool:
    if how == "==":
        return abs(gap - metres) <= max(0.15, 0.15 * metres)
    return gap >= metres - 0.02 if how == ">=" else gap <= metres + 0.02


OPENINGS = ("door", "window", "wall")
"""Nouns that are no things."""


def _lines(room: Room, noun: str) -> list[LineString]:
    return [LineString(wall) for wall in room.walls] if noun == "wall" else room.openings(f"{noun}s")


def to_opening(room: Room, a: str, kind: str, noun: str, told: tuple[str, float]) -> bool:
    """Return whether a thing stands so to a door, a window or a wall; left and right are those of who looks at it from the room."""
    shape, lines = room.outline(a), _lines(room, noun)
    if kind == "facing":
        return any(turned_to(room, a, line) for line in lines)
    gap = min((line.distance(shape) for line in lines), default=math.inf)
    if kind == "apart":
        return _as_far(gap, *told)
    if kind in ("left", "right"):
        return any(_is_beside(room, shape, line, 1 if kind == "left" else -1) for line in lines)
    if kind in ("opposite", "otherwall"):
        return any(_is_across(room, a, line) for line in lines)
    return gap >= 1.0 if kind == "far" else gap <= {"next": 0.8, "near": 1.5, "front": 2.0}.get(kind, 1.5)


def _is_beside(room: Room, shape: Polygon, line: LineString, side: int) -> bool:
    """Whether a thing is at most 4 m to the left (1) or right (-1) of an opening, seen from the room."""
    (ax, ay), (bx, by) = line.coords
    turn = side * (
        1 if Polygon(room.floor).exterior.is_ccw else -1
    )  # an outline that turns left runs to the left of who looks out
    along = turn * ((shape.centroid.x - (ax + bx) / 2) * (bx - ax) + (shape.centroid.y - (ay + by) / 2) * (by - ay))
    return along > 0 and line.distance(shape) <= 4.0


def _is_across(room: Room, a: str, line: LineString) -> bool:
    """Whether a thing stands at the wall across from an opening, or straight before it."""
    (ax, ay), (bx, by) = line.coords
    middle, unit = line.centroid, ((bx - ax) / line.length, (by - ay) / line.length)
    inwards = LineString([(middle.x - t * unit[1], middle.y + t * unit[0]) for t in (-30, 30)])
    walls = [wall for wall in walls_at(room, a) if LineString(room.walls[wall]).distance(line) > 0.5]
    facing = [
        abs(unit[0] * (d[1] - c[1]) - unit[1] * (d[0] - c[0])) < 0.1 for c, d in (room.walls[wall] for wall in walls)
    ]
    return any(facing) or room.outline(a).intersects(inwards)


def opening_is(room: Room, noun: str, kind: str, metres: float, side: str) -> bool:
    """Return whether a door or window is so wide, in the middle of its wall, in a long or short one, or in a half of the room."""
    lines = _lines(room, noun)
    if kind == "half":
        return any(in_half_at(room, line.centroid.x, line.centroid.y, side) for line in lines)
    if kind in ("wallmiddle", "shortwall", "longwall"):
        walls = [LineString(room.walls[item["wall"]]) for item in room.scene.get(f"{noun}s", [])]
        lengths = sorted(_length(room, wall) for wall in range(len(room.walls)))
        if kind != "wallmiddle":
            return any(abs(wall.length - lengths[-(kind == "longwall")]) <= 0.05 for wall in walls)
        pairs = zip(walls, lines, strict=True)
        return any(wall.interpolate(0.5, normalized=True).distance(line.centroid) <= 0.25 for wall, line in pairs)
    return kind == "wide" and any(abs(line.length - metres) <= 0.1 for line in lines)


def measures(room: Room, a: str, kind: str, metres: float, side: str) -> bool:
    """Return whether a thing is so wide, deep or high (within 0.1 m or 5 %), hangs so high, or has so much free floor at a side."""
    depth, width, bottom, top = room.box(a)
    slack = max(0.1, 0.05 * metres)
    if kind == "free":
        return _free(room, a, side, metres)
    if kind == "mounted":
        return min(abs(bottom - metres), abs((bottom + top) / 2 - metres)) <= 0.15
    sizes = (top - bottom,) if kind == "high" else (depth, width)
    return min(abs(size - metres) for size in sizes) <= slack


def _free(room: Room, a: str, side: str, metres: float) -> bool:
    """Whether nothing but seats stands on that much floor at a side of a thing (or around it), and no wall cuts it off."""
    x, y, yaw = room.pose(a)
    depth, width, *_ = room.box(a)
    boxes = {
        "front": (depth / 2, depth / 2 + metres, -width / 2, width / 2),
        "behind": (-depth / 2 - metres, -depth / 2, -width / 2, width / 2),
        "left": (-depth / 2, depth / 2, width / 2, width / 2 + metres),
        "right": (-depth / 2, depth / 2, -width / 2 - metres, -width / 2),
    }
    c, s = math.cos(yaw), math.sin(yaw)
    floor = Polygon(room.floor).buffer(0.02)
    standing = [shape for name, shape in obstacles(room, a).items() if not room.kind(name).endswith(("chair", "stool"))]
    for u0, u1, v0, v1 in boxes.values() if side == "around" else [boxes[side]]:
        corners = [(u0, v0), (u1, v0), (u1, v1), (u0, v1)]
        strip = Polygon([(x + c * u - s * v, y + s * u + c * v) for u, v in corners])
        if not floor.contains(strip) or any(strip.intersection(shape).area > 0.02 for shape in standing):
            return False
    return True


def in_rows(room: Room, names: Sequence[str], rows: int) -> bool:
    """Return whether things stand in so many rows, by their places along or across the front of the first."""
    spots = [room.seen_from(names[0], name) for name in names]
    return any(_groups([spot[axis] for spot in spots]) == rows for axis in (0, 1))


def _groups(values: Sequence[float]) -> int:
    """Return how many groups values make that have no gap above 0.3 m in themselves."""
    ordered = sorted(values)
    return 1 + sum(b - a > 0.3 for a, b in pairwise(ordered))


def _back_to_back(room: Room, names: Sequence[str]) -> bool:
    """Whether each has one of its own kind close behind it that looks the other way."""

    def paired(a: str, b: str) -> bool:
        away = abs(math.remainder(room.pose(a)[2] - room.pose(b)[2] - math.pi, math.tau)) <= math.radians(10)
        return away and room.seen_from(a, b)[0] < 0 and room.seen_from(b, a)[0] < 0 and room.gap(a, b) <= 0.6

    return all(any(paired(a, b) for b in names if b != a) for a in names)


WHOLE = {"back": _back_to_back}
"""Relations of all things of a kind."""
