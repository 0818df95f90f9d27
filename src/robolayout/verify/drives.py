"""Drives: how a rectangular body gets from the door to where it uses each thing, with its heading all along the way.

Within a piece of the free space of one heading it moves along a taut way, ahead or sideways; from one heading to the next
it turns on a spot where the shape that it sweeps (or its whole turning circle) is free. So the footprint swept along a
drive meets nothing, and a drive proves that the body gets there.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import shapely
from shapely import Polygon

from robolayout.scene import Point, Room
from robolayout.verify.heading import HeadingSpace, Node
from robolayout.verify.limits import FINE
from robolayout.verify.routes import Mesh, nearest_place

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


def find_drives(room: Room, space: HeadingSpace, stands: Mapping[str, Point]) -> dict[str, Drive]:
    """Return a drive from the door to each of these places to stand; none where the body does not get there."""
    if space.start is None:
        return {}
    planner = _Planner(space, entry(room, space.pieces[space.start]))
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

    def __init__(self, space: HeadingSpace, start: Point) -> None:
        self._space = space
        self._meshes: dict[Node, Mesh] = {}
        assert space.start is not None
        self._origin = (space.start, start)
        self._before: dict[Node, tuple[Node, Polygon, int] | None] = {space.start: None}
        self._spot: dict[Node, Point] = {space.start: start}
        self._search()

    def _search(self) -> None:
        links: dict[Node, list[tuple[Node, Polygon, int]]] = {}
        for a, b, place in self._space.links:
            links.setdefault(a, []).append((b, place, 1))
            links.setdefault(b, []).append((a, place, -1))
        node, start = self._origin
        queue: list[tuple[float, Node, Point]] = [(0.0, node, start)]
        cost, done = {node: 0.0}, set[Node]()
        while queue:
            spent, node, at = heapq.heappop(queue)
            if node in done:
                continue
            done.add(node)
            for other, place, turn in links.get(node, ()):
                spot = _nearest(place, at)
                further = spent + math.dist(at, spot) + FINE.turn
                if further < cost.get(other, math.inf):
                    cost[other], self._spot[other] = further, spot
                    self._before[other] = (node, place, turn)
                    heapq.heappush(queue, (further, other, spot))

    def drive(self, name: str, stand: Point) -> Drive | None:
        """Return the drive to a place to stand, in the heading with the fewest turns."""
        spot = shapely.Point(stand)
        near = [
            node for node, piece in self._space.pieces.items() if node in self._spot and piece.distance(spot) < 1e-6
        ]
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
        chain: list[tuple[Node, Point, int]] = []
        at: Node | None = node
        while at is not None:
            step = self._before[at]
            chain.append((at, self._spot[at], step[2] if step else 0))
            at = step[0] if step else None
        return chain[::-1]

    def _way(self, node: Node, start: Point, goal: Point) -> tuple[Point, ...]:
        """Return the taut way within a piece, without its start."""
        if math.dist(start, goal) < 1e-9:
            return ()
        piece = self._space.pieces[node]
        if shapely.covers(piece.buffer(1e-9), shapely.LineString((start, goal))):
            return (goal,)
        mesh = self._meshes.get(node) or self._meshes.setdefault(node, Mesh(piece))
        points = mesh.route(mesh.search(start), shapely.Point(goal).buffer(FINE.inside))
        return (*points[1:], goal)


def _nearest(place: Polygon, point: Point) -> Point:
    """Return the spot in a place, a little inside its edge, that is nearest to a point."""
    inner = place.buffer(-FINE.inside)
    return nearest_place(place if inner.is_empty else inner, shapely.Point(point))
