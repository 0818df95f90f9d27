"""Rectangular bodies with a heading: where can they stand, which way round, and where can they turn?

For each heading of a lattice the free space of the rectangle is exact: the room minus all walls and obstacles grown by it
(Minkowski sums of convex shapes). Headings are joined where the body can turn from one to the next: in place, where the
shape that it sweeps is free; a body with a turning circle only where the whole circle is free. What is joined to the door,
coming in along its normal, can be stood in. Here bodies slide sideways as well as ahead; `driving.py` finds the ways of those that cannot.

A drive is a way with the heading all along it: taut within a piece of the free space of one heading, and with turns on spots where
the shape that is swept is free. So the footprint swept along it meets nothing, and it proves that the body gets there.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache, partial
from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry

from robolayout.scene import ROUNDING, Agent, Layout, Point, Room, Scene
from robolayout.verify._boxes import boxes, room_polygon
from robolayout.verify._obstacles import Obstacles, obstacles
from robolayout.verify._space import all_free, components, disc_space, opened
from robolayout.verify.limits import FINE, JUDGE
from robolayout.verify.routes import Triangulation, cheapest, nearest_place

Region = tuple[float, BaseGeometry]  # a heading in radians (0 for a disc), and where the centre can be
Node = tuple[int, int]  # a piece of free space: number of its heading, and its own among those of that heading


Pose = tuple[float, float, float]  # x and y of a body's centre in metres and its heading in radians


@dataclass(frozen=True)
class Drive:
    """A way of a body with its heading."""

    asset: str  # what is used at its end
    # x and y of the body's centre in metres and its heading in radians; it moves straight between two places and turns
    # where two poses share one, or both on an arc
    poses: tuple[Pose, ...]
    reversals: int = 0  # how often it changes between driving ahead and back; 0 for a body that slides sideways

    @cached_property
    def length(self) -> float:
        """Metres that the centre moves."""
        return sum(math.dist(a[:2], b[:2]) for a, b in pairwise(self.poses))

    @cached_property
    def turned(self) -> float:
        """Radians that the body turns in all."""
        return sum(abs(b[2] - a[2]) for a, b in pairwise(self.poses))


@dataclass(frozen=True, eq=False)
class HeadingSpace:
    """Where a rectangular body can get to."""

    headings: tuple[float, ...]  # radians; the first is the door's normal (no door: the first wall's)
    # the pieces of free space that its centre can get to from the door; none if the door is too narrow
    pieces: Mapping[Node, Polygon]
    turning: MultiPolygon  # where the body can get to and turn right round
    # pieces between which it can turn by one heading to the left, and where its centre may be meanwhile
    links: tuple[tuple[Node, Node, Polygon], ...]
    start: Node | None  # the piece that it comes into; None if there is none

    @cached_property
    def standing(self) -> tuple[MultiPolygon, ...]:
        """For each heading, where the centre can get to from the door."""
        parts = [[piece for (k, _), piece in self.pieces.items() if k == at] for at in range(len(self.headings))]
        return tuple(map(MultiPolygon, parts))

    @property
    def regions(self) -> tuple[Region, ...]:
        """The same with its headings, without those at which it gets nowhere."""
        both = zip(self.headings, self.standing, strict=True)
        return tuple((heading, region) for heading, region in both if not region.is_empty)


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
        self._pieces, self._further = cache(self._free), cache(self._beyond)

    def _free(self, number: int) -> list[Polygon]:
        """Return the pieces of the free space of one heading."""
        return convex_places(self._room, self._blocking.shapes, rectangle(self._agent, self.headings[number]))

    @cached_property
    def space(self) -> HeadingSpace:
        """All of it."""
        return self._joined(range(FINE.headings))

    @cached_property
    def surely(self) -> tuple[Region, ...]:
        """Parts of where it can get to that take little time to find."""
        if not self._room.doors:
            return ()
        two = self._agent.turning_diameter is not None
        return self._joined((0, FINE.headings // 2) if two else (0,)).regions

    @cached_property
    def at_most(self) -> BaseGeometry:
        """A region that takes little time to find and holds all of where the body gets to: a small disc's free space."""
        least = min(self._agent.length or 0.0, self._agent.width or 0.0) / 2
        found = all_free(self._room, self._blocking, least * math.cos(math.pi / 64))
        shapely.prepare(found)
        return found

    def opened(self, rows: frozenset[int]) -> Iterator[Region]:
        """Yield what the body gets to beyond that, sliding in without a turn, once some assets are moved away; by heading."""
        for number, heading in enumerate(self.headings):
            yield from ((heading, part) for part in self._further(number, rows))

    def _beyond(self, number: int, rows: frozenset[int]) -> NDArray[np.object_]:
        """Return the same at one heading."""
        body = rectangle(self._agent, self.headings[number])
        spaces = (_empty(self._room, body.tobytes()), MultiPolygon(self._pieces(number)), self.space.standing[number])
        return opened(self._blocking, rows, spaces, partial(_larger, body), self._agent.circumradius)

    def _joined(self, numbers: Sequence[int]) -> HeadingSpace:
        """Return where the body gets to with these headings alone."""
        pairs = [(k, numbers[(i + 1) % len(numbers)]) for i, k in enumerate(numbers)] if len(numbers) > 1 else []
        around = self._turning if pairs else ()
        turns = [(*pair, place) for place in around for pair in pairs]
        if self._agent.turning_diameter is None:
            turns += [(*pair, place) for pair in pairs for place in self._swept(self.headings[pair[0]])]
        ends = [(self._holding(before, place), self._holding(after, place), place) for before, after, place in turns]
        links = [(a, b, place) for a, b, place in ends if a is not None and b is not None]
        pieces = {(k, i): piece for k in numbers for i, piece in enumerate(self._pieces(k))}
        start = self._start(pieces, links)
        group = set[Node]() if start is None else _group(links, start)
        return HeadingSpace(
            headings=self.headings,
            pieces={node: pieces[node] for node in sorted(group)},
            turning=MultiPolygon([place for place in around if self._holding(0, place) in group]),
            links=tuple(link for link in links if link[0] in group),
            start=start,
        )

    def _holding(self, number: int, place: BaseGeometry) -> Node | None:
        """Return the piece of a heading that holds a place."""
        point = place.representative_point()
        return next(((number, i) for i, piece in enumerate(self._pieces(number)) if piece.intersects(point)), None)

    def _start(self, pieces: Mapping[Node, Polygon], links: Sequence[tuple[Node, Node, Polygon]]) -> Node | None:
        """Return the piece in which the body comes in by the first door, heading along its normal; without one, of the most floor."""
        room, agent = self._room, self._agent
        if not room.doors:
            area = {node: math.fsum(pieces[other].area for other in _group(links, node)) for node in pieces}
            return max(pieces, key=lambda node: area[node], default=None)
        if (agent.width or 0.0) > room.doors[0].width + ROUNDING:
            return None
        inside = Polygon(room.way_in(agent.length or 0.0, agent.width or 0.0, JUDGE.touch))
        shared = [piece.intersection(inside).area for piece in self._pieces(0)]
        return (0, int(np.argmax(shared))) if shared and max(shared) > 0 else None

    @cached_property
    def _turning(self) -> NDArray[np.object_]:
        """Return the places where the body can turn right round."""
        return components(disc_space(self._room, self._blocking, self._agent.turning_circle / 2).free)

    def _swept(self, heading: float) -> list[Polygon]:
        """Return the places where the body can turn from a heading to the next, within a convex shape that holds it meanwhile."""
        corners = [rectangle(self._agent, heading + part * self._step) for part in (0.0, 0.5, 1.0)]
        swept = np.concatenate(corners) / math.cos(self._step / 4)
        return convex_places(self._room, self._blocking.shapes, swept)


def _group(links: Sequence[tuple[Node, Node, Polygon]], start: Node) -> set[Node]:
    """Return all that is joined to a piece, itself among it."""
    found = {start}
    while further := {node for a, b, _ in links if (a in found) != (b in found) for node in (a, b)}:
        found |= further
    return found


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


def convex_places(room: Room, shapes: NDArray[np.object_], body: NDArray[np.float64]) -> list[Polygon]:
    """Return the pieces of the free space of a convex body, largest first; a passage just as wide as the body is none."""
    even = shapely.set_precision(free_of(room, shapes, body), FINE.grain)
    return list(components(shapely.set_precision(even, 0.0)))  # what is worked out from them next is not on a grid


def free_of(room: Room, shapes: NDArray[np.object_], body: NDArray[np.float64]) -> BaseGeometry:
    """Return where the reference point of a convex body (m, 2) may be among rectangles."""
    free = _empty(room, body.tobytes())
    return free.difference(shapely.union_all(_larger(body, shapes))) if len(shapes) else free


def _larger(body: NDArray[np.float64], shapes: NDArray[np.object_], more: float = 0.0) -> NDArray[np.object_]:
    """Return rectangles grown by a body around its centre, and by so many metres more."""
    corners = shapely.get_coordinates(shapes).reshape(-1, 5, 2)[:, :4]
    return grown(corners, body + np.copysign(more, body) if more else body)


@lru_cache(maxsize=256)
def _empty(room: Room, body: bytes) -> BaseGeometry:
    """Return where the centre of a convex body, corners (m, 2) as bytes, may be in the empty room; the same for every layout."""
    walls = np.array([(wall.start, wall.end) for wall in room.walls])
    return room_polygon(room).difference(shapely.union_all(grown(walls, np.frombuffer(body).reshape(-1, 2))))


def find_drives(room: Room, space: HeadingSpace, stands: Mapping[str, Point]) -> dict[str, Drive]:
    """Return a drive from the door to each of these places to stand; none where the body does not get there."""
    if space.start is None:
        return {}
    planner = _Planner(room, space, space.start)
    found = {name: planner.drive(name, stand) for name, stand in stands.items()}
    return {name: drive for name, drive in found.items() if drive is not None}


def entry(room: Room, piece: Polygon) -> Point:
    """Return the place in a piece that is nearest to the first door; without one, to the middle of the piece."""
    if not room.doors:
        x, y = piece.representative_point().coords[0]
        return (float(x), float(y))
    door = room.doors[0]
    return nearest_place(piece, shapely.Point(room.walls[door.wall].point(door.center)))


class _Planner:
    """The cheapest ways over pieces and turns from a start, found once for all places."""

    def __init__(self, room: Room, space: HeadingSpace, source: Node) -> None:
        self._space, self._mesh = space, cache(Triangulation)
        links = [link for a, b, place in space.links for link in ((a, b, place, 1), (b, a, place, -1))]

        def turns(node: Node, at: Point) -> Iterator[tuple[Node, Point, int]]:
            return ((other, _nearest(place, at), turn) for here, other, place, turn in links if here == node)

        self._tree = cheapest(source, entry(room, space.pieces[source]), turns, FINE.turn)

    def drive(self, name: str, stand: Point) -> Drive | None:
        """Return the drive to a place to stand, in the heading with the fewest turns."""
        spot = shapely.Point(stand)
        pieces = self._space.pieces.items()
        near = [node for node, piece in pieces if node in self._tree.cost and piece.distance(spot) < 1e-6]
        if not near:
            return None
        chains = [self._chain(node) for node in near]
        chain = min(chains, key=lambda c: (len(c), sum(math.dist(a[1], b[1]) for a, b in pairwise(c))))
        heading, at = self._space.headings[chain[0][0][0]], chain[0][1]
        poses = [(*at, heading)]
        for (node, _, _), (_, goal, turn) in pairwise(chain):
            poses += [(*point, heading) for point in self._way(node, poses[-1][:2], goal)]
            heading += turn * math.pi / FINE.headings
            poses.append((*poses[-1][:2], heading))
        poses += [(*point, heading) for point in self._way(chain[-1][0], poses[-1][:2], stand)]
        return Drive(name, tuple(pose for pose, before in zip(poses, [None, *poses], strict=False) if pose != before))

    def _chain(self, node: Node) -> list[tuple[Node, Point, int]]:
        """Return the pieces from the start to this one, each with the spot where it is entered and how it turns there."""
        spot = self._tree.cost[node][1]
        if node not in self._tree.before:
            return [(node, spot, 0)]
        before, turn = self._tree.before[node]
        return [*self._chain(before), (node, spot, turn)]

    def _way(self, node: Node, start: Point, goal: Point) -> tuple[Point, ...]:
        """Return the taut way within a piece, without its start."""
        if math.dist(start, goal) < 1e-9:
            return ()
        piece = self._space.pieces[node]
        if shapely.covers(piece.buffer(1e-9), shapely.LineString((start, goal))):
            return (goal,)
        mesh = self._mesh(piece)
        points = mesh.route(mesh.search(start), shapely.Point(goal).buffer(FINE.inside))
        return (*points[1:], goal)


def _nearest(place: Polygon, point: Point) -> Point:
    """Return the spot in a place, a little inside its edge, that is nearest to a point."""
    inner = place.buffer(-FINE.inside)
    return nearest_place(place if inner.is_empty else inner, shapely.Point(point))
