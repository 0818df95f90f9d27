"""Drives: how a rectangular body gets from the door to where it uses each thing, with its heading all along the way.

Within a piece of the free space of one heading it moves along a taut way, ahead or sideways; from one heading to the next
it turns on a spot where the shape that it sweeps (or its whole turning circle) is free. So the footprint swept along a
drive meets nothing, and a drive proves that the body gets there.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import shapely
from shapely import Polygon

from robolayout.scene import Point, Room
from robolayout.verify.heading import HeadingSpace, Node
from robolayout.verify.limits import FINE
from robolayout.verify.routes import Mesh, cheapest, nearest_place

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
        self._space, self._meshes = space, dict[Node, Mesh]()
        links: dict[Node, list[tuple[Node, Polygon, int]]] = {}
        for a, b, place in space.links:
            links.setdefault(a, []).append((b, place, 1))
            links.setdefault(b, []).append((a, place, -1))

        def turns(node: Node, at: Point) -> Iterator[tuple[Node, Point, int]]:
            return ((other, _nearest(place, at), turn) for other, place, turn in links.get(node, ()))

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
        mesh = self._meshes.get(node) or self._meshes.setdefault(node, Mesh(piece))
        points = mesh.route(mesh.search(start), shapely.Point(goal).buffer(FINE.inside))
        return (*points[1:], goal)


def _nearest(place: Polygon, point: Point) -> Point:
    """Return the spot in a place, a little inside its edge, that is nearest to a point."""
    inner = place.buffer(-FINE.inside)
    return nearest_place(place if inner.is_empty else inner, shapely.Point(point))
