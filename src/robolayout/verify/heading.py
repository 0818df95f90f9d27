"""Rectangular bodies with a heading: where can they stand, which way round, and where can they turn?

For each heading of a lattice the free space of the rectangle is exact: the room minus all walls and obstacles grown by it
(Minkowski sums of convex shapes). Headings are joined where the body can turn from one to the next: in place, where the
shape that it sweeps is free; a body with a turning circle only where the whole circle is free. What is joined to the door,
coming in along its normal, can be stood in. Here bodies slide sideways as well as ahead; `driving.py` finds the ways of those that cannot.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache, partial

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry

from robolayout.scene import OPENINGS, ROUNDING, Agent, Layout, Room, Scene
from robolayout.verify._boxes import boxes, room_polygon
from robolayout.verify._obstacles import Obstacles, obstacles
from robolayout.verify._space import all_free, components, disc_space, opened
from robolayout.verify.limits import FINE

Node = tuple[int, int]  # a piece of free space: number of its heading, and its own among those of that heading


@dataclass(frozen=True, eq=False)
class HeadingSpace:
    """Where a rectangular body can get to."""

    headings: tuple[float, ...]  # radians, one per region; the first is the door's normal (no door: the first wall's)
    # for each heading, where the centre can get to from the door; nowhere if the door is too narrow
    standing: tuple[MultiPolygon, ...]
    turning: MultiPolygon  # where the body can get to and turn right round
    # the pieces of `standing`, by (number of the heading, number among its free pieces)
    pieces: Mapping[Node, Polygon] = field(default_factory=dict[Node, Polygon], repr=False)
    # pieces between which it can turn by one heading to the left, and where its centre may be meanwhile
    links: tuple[tuple[Node, Node, Polygon], ...] = field(default=(), repr=False)
    start: Node | None = None  # the piece that it comes into; None if there is none


def heading_space(scene: Scene, layout: Layout, agent: Agent) -> HeadingSpace:
    """Return where a rectangular body can get to and which way round; its length and width must be given."""
    return Headings(scene.room, obstacles(boxes(scene, layout), agent), agent).space


class Headings:
    """The free space of a rectangular body by heading, each worked out when first asked for."""

    def __init__(self, room: Room, blocking: Obstacles, agent: Agent) -> None:
        self._room, self._blocking, self._agent = room, blocking, agent
        wall, self._step = room.walls[room.doors[0].wall if room.doors else 0], math.pi / FINE.headings
        first = math.atan2(wall.normal[1], wall.normal[0])
        self.headings = tuple(first + self._step * k for k in range(FINE.headings))
        self._free: dict[int, list[Polygon]] = {}
        self._opened: dict[frozenset[int], tuple[tuple[int, Polygon], ...]] = {}

    @cached_property
    def space(self) -> HeadingSpace:
        """All of it."""
        return self._joined(range(FINE.headings))

    @cached_property
    def surely(self) -> tuple[MultiPolygon, ...]:
        """Parts of where it can get to that take little time to find, one region per heading."""
        if not self._room.doors:
            return ()
        two = self._agent.turning_diameter is not None
        return self._joined((0, FINE.headings // 2) if two else (0,)).standing

    @cached_property
    def at_most(self) -> BaseGeometry:
        """A region that takes little time to find and holds all of where the body gets to: a small disc's free space."""
        least = min(self._agent.length or 0.0, self._agent.width or 0.0) / 2
        return all_free(self._room, self._blocking, least * math.cos(math.pi / 64))

    def opened(self, rows: frozenset[int]) -> tuple[tuple[int, Polygon], ...]:
        """Return what the body gets to beyond that, sliding in without a turn, once some assets are moved away; by heading."""
        if rows not in self._opened:
            size = self._agent.circumradius
            found: list[tuple[int, Polygon]] = []
            for k, heading in enumerate(self.headings):
                body = rectangle(self._agent, heading)
                spaces = (_empty(self._room, _key(body)), MultiPolygon(self._pieces(k)), self.space.standing[k])
                parts = opened(self._blocking, rows, spaces, partial(_larger, body), size)
                found += [(k, part) for part in parts]
            self._opened[rows] = tuple(found)
        return self._opened[rows]

    def _joined(self, numbers: Sequence[int]) -> HeadingSpace:
        """Return where the body gets to with these headings alone."""
        room, agent, shapes = self._room, self._agent, self._blocking.shapes
        free = [self._pieces(k) if k in numbers else [] for k in range(FINE.headings)]
        joined = _Joined(free)
        pairs = [(k, numbers[(i + 1) % len(numbers)]) for i, k in enumerate(numbers)] if len(numbers) > 1 else []
        for place in self._turning if pairs else ():
            for before, after in pairs:
                joined.join(before, after, place)
        if agent.turning_diameter is None:
            for before, after in pairs:
                for place in convex_places(room, shapes, _swept(agent, self.headings[before], self._step)):
                    joined.join(before, after, place)
        start = self._start(joined)
        group = joined.group(start)
        return HeadingSpace(
            headings=self.headings,
            standing=tuple(
                MultiPolygon([p for i, p in enumerate(free[k]) if (k, i) in group]) for k in range(FINE.headings)
            ),
            turning=MultiPolygon([place for place in self._turning if joined.node(0, place) in group] if pairs else []),
            pieces={(k, i): free[k][i] for k, i in sorted(group)},
            links=tuple(link for link in joined.links if link[0] in group),
            start=start,
        )

    def _start(self, joined: _Joined) -> Node | None:
        room, agent = self._room, self._agent
        if room.doors and (agent.width or 0.0) > room.doors[0].width + ROUNDING:
            return None
        return joined.entry(room, max(OPENINGS.landing_depth, agent.length or 0.0))

    def _pieces(self, number: int) -> list[Polygon]:
        """Return the pieces of the free space of one heading."""
        if number not in self._free:
            body = rectangle(self._agent, self.headings[number])
            self._free[number] = convex_places(self._room, self._blocking.shapes, body)
        return self._free[number]

    @cached_property
    def _turning(self) -> NDArray[np.object_]:
        """Return the places where the body can turn right round."""
        circle = max(self._agent.circumradius, (self._agent.turning_diameter or 0.0) / 2)
        return components(disc_space(self._room, self._blocking, circle).free)


def rectangle(agent: Agent, heading: float, more: float = 0.0) -> NDArray[np.float64]:
    """Return the four corners of a rectangular body around its centre, `more` metres larger on each side."""
    half_length, half_width = (agent.length or 0.0) / 2 + more, (agent.width or 0.0) / 2 + more
    corners = np.array([(1, -1), (1, 1), (-1, 1), (-1, -1)]) * (half_length, half_width)
    c, s = math.cos(heading), math.sin(heading)
    return corners @ np.array([(c, s), (-s, c)])


def grown(shapes: NDArray[np.float64], body: NDArray[np.float64]) -> NDArray[np.object_]:
    """Return where the reference point of a convex body (m, 2) is while it meets convex shapes (n, corners, 2)."""
    sums = (shapes[:, :, None, :] - body[None, None, :, :]).reshape(len(shapes), shapes.shape[1] * len(body), 2)
    return np.asarray(shapely.convex_hull(shapely.multipoints(sums)), dtype=object)


def _swept(agent: Agent, heading: float, step: float) -> NDArray[np.float64]:
    """Return corners of a convex shape that holds the body at every heading between this one and the next."""
    corners = np.concatenate([rectangle(agent, heading + part * step) for part in (0.0, 0.5, 1.0)])
    return corners / math.cos(step / 4)


def convex_places(room: Room, shapes: NDArray[np.object_], body: NDArray[np.float64]) -> list[Polygon]:
    """Return the pieces of the free space of a convex body, largest first; a passage just as wide as the body is none."""
    even = shapely.set_precision(free_of(room, shapes, body), FINE.grain)
    return list(components(shapely.set_precision(even, 0.0)))  # what is worked out from them next is not on a grid


def free_of(room: Room, shapes: NDArray[np.object_], body: NDArray[np.float64]) -> BaseGeometry:
    """Return where the reference point of a convex body (m, 2) may be among rectangles."""
    free = _empty(room, _key(body))
    return free.difference(shapely.union_all(_larger(body, shapes))) if len(shapes) else free


def _larger(body: NDArray[np.float64], shapes: NDArray[np.object_], more: float = 0.0) -> NDArray[np.object_]:
    """Return rectangles grown by a body around its centre, and by so many metres more."""
    corners = shapely.get_coordinates(shapes).reshape(-1, 5, 2)[:, :4]
    return grown(corners, body + np.copysign(more, body) if more else body)


def _key(body: NDArray[np.float64]) -> tuple[tuple[float, ...], ...]:
    return tuple(map(tuple, body.tolist()))


@lru_cache(maxsize=256)
def _empty(room: Room, body: tuple[tuple[float, ...], ...]) -> BaseGeometry:
    """Return where the centre of a convex body may be in the empty room; the same for every layout of it."""
    walls = np.array([(wall.start, wall.end) for wall in room.walls])
    return room_polygon(room).difference(shapely.union_all(grown(walls, np.array(body))))


class _Joined:
    """Pieces of free space, by (heading, index), and which of them the body can change between."""

    def __init__(self, free: Sequence[Sequence[Polygon]]) -> None:
        self._free = free
        self._leader = {(k, i): (k, i) for k, pieces in enumerate(free) for i in range(len(pieces))}
        self.links: list[tuple[Node, Node, Polygon]] = []

    def node(self, heading: int, place: BaseGeometry) -> Node | None:
        """Return the piece of a heading that holds a place."""
        point = place.representative_point()
        return next(((heading, i) for i, piece in enumerate(self._free[heading]) if piece.intersects(point)), None)

    def join(self, before: int, after: int, place: Polygon) -> None:
        """Join the pieces of two headings that hold a place where the body can turn from one to the other."""
        a, b = self.node(before, place), self.node(after, place)
        if a is not None and b is not None:
            self._leader[self._root(b)] = self._root(a)
            self.links.append((a, b, place))

    def group(self, start: Node | None) -> set[Node]:
        """Return everything joined to a piece."""
        return set() if start is None else {node for node in self._leader if self._root(node) == self._root(start)}

    def entry(self, room: Room, depth: float) -> Node | None:
        """Return the piece in which a body comes in by the first door, heading along its normal."""
        if not room.doors:
            return max(self._leader, key=self._area, default=None)
        landing = Polygon(room.landing(room.doors[0], depth))
        shared = [piece.intersection(landing).area for piece in self._free[0]]
        return (0, int(np.argmax(shared))) if shared and max(shared) > 0 else None

    def _area(self, node: Node) -> float:
        return sum(self._free[k][i].area for k, i in self.group(node))

    def _root(self, node: Node) -> Node:
        while self._leader[node] != node:
            node = self._leader[node]
        return node
