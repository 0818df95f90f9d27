"""A furnished room as plain geometry sees it, from `scene.json` and `layout.json` alone, and how things in it stand to each other.

Nothing here uses the package's reader, statements or checks.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from shapely import LineString, Point, Polygon
from shapely.ops import unary_union

SIDES = {
    "north": "north", "back": "north", "rear": "north", "far": "north", "south": "south", "front": "south",
    "west": "west", "left": "west", "east": "east", "right": "east",
}  # fmt: skip
"""Sides of the plan by the words for them."""

AT_WALL, IN_CORNER = 0.15, 0.35
"""Metres from a wall within which a thing is at it, or at both of a corner."""

TWO_FRONTS = ("desk", "table", "counter")
"""Last words of what faces a thing when who sits at it does."""

LOWEST_SEAT = 0.01
"""Metres above the floor of a thing from which on what is within its box can stand on it: a seat, a mattress, the lowest board."""

ALSO = {"shelf": "shelving unit", "stool": "bar stool", "sink": "washbasin", "toy": "toy box"}
"""Names under which the catalogue keeps what a word says."""


class Room:
    """A furnished room, as its files say.

    Args:
        scene: The content of `scene.json`.
        layout: The content of `layout.json`.
    """

    def __init__(self, scene: Mapping[str, Any], layout: Mapping[str, Any]) -> None:
        self.scene, self.layout = scene, layout
        self.floor = [(x, y) for x, y, *_ in scene["boundary"]["floor_vertices"]]
        self.walls = list(zip(self.floor, self.floor[1:] + self.floor[:1], strict=True))
        self.height = float(scene["boundary"]["wall_height"])

    def find(self, words: str) -> list[str]:
        """Return the placed assets that a word means: those of that very name, else those whose name ends so."""
        exact, ending = list[str](), list[str]()
        for name, asset in self.scene["assets"].items():
            if name not in self.layout:
                continue
            names = {asset["category"].lower(), str(asset.get("like", "")).lower()} - {""}
            for word in [*words.split("|"), *(ALSO[word] for word in words.split("|") if word in ALSO)]:
                exact += [name] * (word in names and name not in exact)
                ending += [name] * (
                    any(n.split()[-1:] == word.split()[-1:] and n.endswith(word) for n in names) and name not in ending
                )
        return exact or ending

    def kind(self, name: str) -> str:
        """Return the category of an asset."""
        return str(self.scene["assets"][name]["category"])

    def box(self, name: str) -> tuple[float, float, float, float]:
        """Return depth, width, bottom and top of an asset in metres."""
        size = self.scene["assets"][name]["assetMetadata"]["boundingBox"]
        z = self.layout[name]["position"][2]
        return size["x"], size["y"], z - size["z"] / 2, z + size["z"] / 2

    def pose(self, name: str) -> tuple[float, float, float]:
        """Return place and heading of an asset, metres and radians."""
        x, y, _ = self.layout[name]["position"]
        return x, y, math.radians(self.layout[name]["rotation"][2])

    def outline(self, name: str) -> Polygon:
        """Return the footprint of an asset."""
        (x, y, yaw), (depth, width, *_) = self.pose(name), self.box(name)
        c, s = math.cos(yaw), math.sin(yaw)
        corners = [(depth / 2, width / 2), (-depth / 2, width / 2), (-depth / 2, -width / 2), (depth / 2, -width / 2)]
        return Polygon([(x + c * u - s * v, y + s * u + c * v) for u, v in corners])

    def seen_from(self, b: str, a: str) -> tuple[float, float]:
        """Return the centre of a in the frame of b: metres ahead and to the left."""
        (x, y, yaw), (ax, ay, _) = self.pose(b), self.pose(a)
        c, s = math.cos(yaw), math.sin(yaw)
        return c * (ax - x) + s * (ay - y), c * (ay - y) - s * (ax - x)

    def gap(self, a: str, b: str) -> float:
        """Return the metres between two footprints."""
        return self.outline(a).distance(self.outline(b))

    def openings(self, kind: str) -> list[LineString]:
        """Return doors or windows on the plan."""
        found: list[LineString] = []
        for item in self.scene.get(kind, []):
            (ax, ay), (bx, by) = self.walls[item["wall"]]
            length = math.dist((ax, ay), (bx, by))
            ends = [item["offset"] / length, (item["offset"] + item["width"]) / length]
            found.append(LineString([(ax + t * (bx - ax), ay + t * (by - ay)) for t in ends]))
        return found

    def wall_gaps(self, a: str) -> list[float]:
        """Return the metres between an asset and each wall, smallest first."""
        shape = self.outline(a)
        return sorted(shape.distance(LineString(wall)) for wall in self.walls)


def resting(room: Room, a: str, b: str) -> bool:
    """Return whether an asset stands on another: on its top, on a seat, mattress or board within its box, or on what does."""
    (x, y, _), (_, _, bottom, _), (_, _, low, top) = room.pose(a), room.box(a), room.box(b)
    if not room.outline(b).buffer(0.02).contains(Point(x, y)):
        return False
    alike = [n for n in room.layout if n != b and room.kind(n) == room.kind(a) and room.box(n)[2] < bottom]
    below = any(abs(bottom - room.box(n)[3]) <= 0.03 and resting(room, n, b) for n in alike)
    return abs(bottom - top) <= 0.03 or low + LOWEST_SEAT <= bottom <= top or below


def _beside(room: Room, a: str, b: str, side: int) -> bool:
    """Whether a is at the left (1) or right (-1) of b."""
    u, v = room.seen_from(b, a)
    depth, width, *_ = room.box(b)
    return v * side > width / 2 - 0.05 and abs(u) <= depth / 2 + 0.4 and room.gap(a, b) <= 2.0


def _before(room: Room, a: str, b: str, most: float, sign: int = 1) -> bool:
    u, v = room.seen_from(b, a)
    depth, width, *_ = room.box(b)
    return u * sign > depth / 2 - 0.05 and abs(v) <= width / 2 + 0.3 and room.gap(a, b) <= most


def _facing(room: Room, a: str, b: str) -> bool:
    """Whether a looks at b; of two desks, who sits at a looks over its back at b."""
    over_its_back = all(room.kind(name).endswith("desk") for name in (a, b))
    return turned_to(room, a, room.outline(b), (math.pi,) if over_its_back else None)


def turned_to(room: Room, a: str, shape: Polygon | LineString, turns: tuple[float, ...] | None = None) -> bool:
    """Return whether a front of an asset, turned by one of some angles, looks at a shape."""
    x, y, yaw = room.pose(a)
    fronts = [yaw + turn for turn in turns or ((0.0, math.pi) if room.kind(a).endswith(TWO_FRONTS) else (0.0,))]
    target = shape.centroid
    for front in fronts:
        ray = LineString([(x, y), (x + 50 * math.cos(front), y + 50 * math.sin(front))])
        off = abs(math.remainder(math.atan2(target.y - y, target.x - x) - front, math.tau))
        if ray.intersects(shape) or off <= math.radians(20):
            return True
    return False


def _over(room: Room, a: str, b: str) -> bool:
    u, v = room.seen_from(b, a)
    depth, width, _, top = room.box(b)
    return -depth / 2 - 0.4 <= u <= depth / 2 + 0.1 and abs(v) <= width / 2 + 0.1 and room.box(a)[2] >= top - 0.05


def _at_desk(room: Room, a: str, b: str, most: float, sign: int) -> bool:
    """Whether a is before b (1) or behind it (-1), or a seat at the other side of a desk, whichever side that has for its front."""
    seated = room.scene["assets"][a]["category"].endswith(("chair", "stool"))
    either = seated and room.scene["assets"][b]["category"].endswith(TWO_FRONTS)
    return _before(room, a, b, most, sign) or (either and _before(room, a, b, most, -sign))


PAIRS: dict[str, Callable[[Room, str, str], bool]] = {
    "on": resting,
    "next": lambda room, a, b: room.gap(a, b) <= 0.8,
    "near": lambda room, a, b: room.gap(a, b) <= 1.5,
    "far": lambda room, a, b: room.gap(a, b) >= 1.0,
    "front": partial(_at_desk, most=2.0, sign=1),
    "behind": partial(_at_desk, most=1.8, sign=-1),
    "left": partial(_beside, side=1),
    "right": partial(_beside, side=-1),
    "around": lambda room, a, b: room.gap(a, b) <= 1.3,
    "facing": _facing,
    "opposite": lambda room, a, b: _before(room, a, b, 15.0) or _before(room, b, a, 15.0),
    "above": _over,
    "under": lambda room, a, b: (
        room.outline(a).intersection(room.outline(b)).area > 0.01
        and (
            room.box(a)[3] <= max(room.box(b)[2] + 0.03, room.box(b)[3] - 0.02)
            or room.kind(a).endswith(("chair", "stool"))
        )
    ),
}


def at_place(room: Room, kind: str, a: str) -> bool:
    """Return whether a thing is at such a place of the room."""
    (x, y, _), shape = room.pose(a), room.outline(a)
    if kind == "wall":
        return room.wall_gaps(a)[0] <= AT_WALL
    if kind == "corner":
        return room.wall_gaps(a)[1] <= IN_CORNER
    if kind in ("path", "diagonal"):
        return _way_to(room, a) if kind == "path" else _is_diagonal(room, a)
    if kind in ("atwindow", "atdoor", "daylight"):
        lines = room.openings("doors" if kind == "atdoor" else "windows")
        return any(line.distance(shape) <= (1.0 if kind == "atwindow" else 2.0) for line in lines)
    xs, ys = zip(*room.floor, strict=True)
    middle = ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2)
    return math.dist((x, y), middle) <= max(0.7, 0.3 * min(max(xs) - min(xs), max(ys) - min(ys)))


def _stacked(room: Room, names: list[str]) -> bool:
    """Whether all but the lowest stand on one of their own kind."""
    return len(names) > 1 and sum(any(resting(room, a, b) for b in names if b != a) for a in names) >= len(names) - 1


def _in_pairs(room: Room, names: list[str]) -> bool:
    """Whether each has one of its own kind within 0.6 m."""
    return all(any(room.gap(a, b) <= 0.6 for b in names if b != a) for a in names)


def _is_diagonal(room: Room, a: str) -> bool:
    return abs(math.remainder(room.pose(a)[2], math.pi / 2)) >= math.radians(20)


def in_half(room: Room, a: str, side: str) -> bool:
    """Return whether the middle of a thing lies in a half of the floor."""
    return in_half_at(room, *room.pose(a)[:2], side)


def in_half_at(room: Room, x: float, y: float, side: str) -> bool:
    """Return whether a point lies in a half of the floor."""
    shape = Polygon(room.floor).bounds
    cx, cy = (shape[0] + shape[2]) / 2, (shape[1] + shape[3]) / 2
    halves = {"west": x < cx, "east": x > cx, "south": y < cy, "north": y > cy}
    return halves[SIDES[side]]


def obstacles(room: Room, but: str = "") -> dict[str, Polygon]:
    """Return the footprints of what a person walks around, by the things."""
    boxes = {name: room.box(name) for name in room.layout if name != but}
    return {name: room.outline(name) for name, (_, _, bottom, top) in boxes.items() if bottom < 1.8 and top > 0.05}


def _way_to(room: Room, a: str) -> bool:
    """Whether a disc 0.5 m wide gets from a door to within 0.5 m of a thing."""
    blocked = unary_union([shape.buffer(0.25) for shape in obstacles(room).values()])
    free = Polygon(room.floor).buffer(-0.25).difference(blocked)
    parts = getattr(free, "geoms", [free])
    doors = room.openings("doors")
    return any(part.distance(d) <= 0.5 and part.distance(room.outline(a)) <= 0.5 for part in parts for d in doors)


def open_middle(room: Room) -> bool:
    """Whether nothing stands within 0.15 of the shorter side of the room from its middle."""
    x0, y0, x1, y1 = Polygon(room.floor).bounds
    disc = Point((x0 + x1) / 2, (y0 + y1) / 2).buffer(0.15 * min(x1 - x0, y1 - y0))
    return not any(disc.intersects(shape) for shape in obstacles(room).values())


def _in_a_row(room: Room, names: list[str]) -> bool:
    """Whether centres lie within 0.4 m of a line along or across the first one's front."""
    spots = [room.seen_from(names[0], name) for name in names]
    return min(max(v) - min(v) for v in zip(*spots, strict=True)) <= 0.4


def between(room: Room, a: str, ends: list[str]) -> bool:
    """Return whether a thing stands between two of the others: at the line of their centres, or where one looks over it to the other."""
    for i, b in enumerate(ends):
        for c in ends[i + 1 :]:
            (bx, by, _), (cx, cy, _) = room.pose(b), room.pose(c)
            line = LineString([(bx, by), (cx, cy)])
            along = line.project(Point(*room.pose(a)[:2]))
            if line.length > 0 and 0.01 < along < line.length - 0.01 and room.outline(a).distance(line) <= 0.6:
                return True
            both = room.outline(b).union(room.outline(c))  # a night stand at the heads of two beds
            if both.convex_hull.contains(room.outline(a).centroid) and not both.intersects(room.outline(a)):
                return True
    return False


WHOLE = {"row": _in_a_row, "stacked": _stacked, "pairs": _in_pairs}
"""Relations of all things of a kind."""
