"""Routes: a short collision-free way from the door to each asset, inside the free space.

The main component is cut into triangles (constrained Delaunay), so that the way cannot leave it and no gap is ever
missed, however thin. One search over the triangles from the door serves all assets; pulling the string tight in each
row of triangles gives the shortest way of its kind (past the same obstacles on the same sides).
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Generic, TypeVar

import numpy as np
import shapely
from shapely import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from robolayout.scene import Point, Room
from robolayout.scene.agent import BODY
from robolayout.verify._boxes import room_polygon
from robolayout.verify._space import Space
from robolayout.verify.limits import FINE

Node = TypeVar("Node", int, tuple[int, int])
Link = TypeVar("Link")
Edge = tuple[int, int]  # the numbers of its ends
Portal = tuple[Point, Point]  # the ends of an edge that a way crosses: left and right


@dataclass(frozen=True)
class Route:
    """A way of the agent's centre."""

    asset: str  # where it leads
    # corners of the way in metres, from the door to the first place that is near enough to the asset
    points: tuple[Point, ...]

    @cached_property
    def length(self) -> float:
        """Length in metres."""
        return sum(math.dist(a, b) for a, b in zip(self.points, self.points[1:], strict=False))

    @property
    def line(self) -> LineString:
        """The way as a line; two equal points where the agent already stands there."""
        return LineString(self.points if len(self.points) > 1 else self.points * 2)


def entry_point(room: Room, space: Space) -> Point | None:
    """Return the place in the main component nearest to the middle of the first door; without a door, of the room."""
    if space.main.is_empty:
        return None
    if space.door is None:
        target, area = room_polygon(room).centroid, space.main
    else:
        door = room.doors[0]
        target, area = shapely.Point(room.walls[door.wall].point(door.center)), space.main.intersection(space.door)
    return nearest_place(area, target)


def nearest_place(area: BaseGeometry, target: BaseGeometry) -> Point:
    """Return the place in an area that is nearest to something."""
    x, y = shapely.get_coordinates(shapely.shortest_line(area, target))[0]
    return (float(x), float(y))


def find_routes(room: Room, space: Space, goals: Mapping[str, Polygon]) -> dict[str, Route]:
    """Return a route from the entry to touching distance of each goal's footprint, or as near to it as possible."""
    start = entry_point(room, space)
    if start is None or not goals:
        return {}
    mesh = Triangulation(space.main)
    tree = mesh.search(start)
    result: dict[str, Route] = {}
    for name, footprint in goals.items():
        near = 1.002 * max(space.main.distance(footprint), space.radius + BODY.touch) + 1e-4
        result[name] = Route(name, mesh.route(tree, footprint.buffer(near, quad_segs=FINE.quad_segs)))
    return result


@dataclass(frozen=True)
class Tree(Generic[Node, Link]):
    """The cheapest ways from a start to some nodes."""

    start: Point
    cost: dict[Node, tuple[float, Point]]  # what each costs, and where the way comes into it
    before: dict[Node, tuple[Node, Link]]  # from where, and by which link, the way comes into all but the first


def cheapest(
    source: Node, start: Point, steps: Callable[[Node, Point], Iterable[tuple[Node, Point, Link]]], each: float = 0.0
) -> Tree[Node, Link]:
    """Return the cheapest ways from a node; `steps` from where one is lead to further nodes, and cost their metres and `each`."""
    tree = Tree[Node, Link](start, {source: (0.0, start)}, {})
    queue: list[tuple[float, Node, Point]] = [(0.0, source, start)]
    done: set[Node] = set()
    while queue:
        spent, node, at = heapq.heappop(queue)
        if node in done:
            continue
        done.add(node)
        for other, spot, link in steps(node, at):
            further = spent + math.dist(at, spot) + each
            if further < tree.cost.get(other, (math.inf,))[0]:
                tree.cost[other] = (further, spot)
                tree.before[other] = (node, link)
                heapq.heappush(queue, (further, other, spot))
    return tree


class Triangulation:
    """The triangles of a polygon and who neighbours whom."""

    def __init__(self, polygon: Polygon) -> None:
        even = shapely.set_precision(polygon, FINE.grain)
        self._triangles = shapely.orient_polygons(shapely.get_parts(shapely.constrained_delaunay_triangles(even)))
        self._tree = shapely.STRtree(self._triangles)
        rings = shapely.get_coordinates(self._triangles).reshape(-1, 4, 2)[:, :3]
        self._points, index = np.unique(rings.reshape(-1, 2), axis=0, return_inverse=True)
        around: list[list[Edge]] = [[(a, b), (b, c), (c, a)] for a, b, c in index.reshape(-1, 3).tolist()]
        owner = {edge: row for row, edges in enumerate(around) for edge in edges}
        # for each triangle its neighbours and the edges to them, counter-clockwise
        self._edges = [[(owner[b, a], (a, b)) for a, b in edges if (b, a) in owner] for edges in around]

    def search(self, start: Point) -> Tree[int, Edge]:
        """Return the shortest ways over edge midpoints from a point to all triangles; links are the edges."""

        def across(row: int, _: Point) -> Iterator[tuple[int, Point, Edge]]:
            for neighbour, (a, b) in self._edges[row]:
                x, y = ((self._points[a] + self._points[b]) / 2).tolist()
                yield neighbour, (x, y), (a, b)

        return cheapest(int(self._tree.nearest(shapely.Point(start))), start, across)

    def route(self, tree: Tree[int, Edge], zone: Polygon) -> tuple[Point, ...]:
        """Return the taut way from the tree's start into a zone."""
        last = self._nearest(tree, zone)
        target = shapely.intersection(self._triangles[last], zone)
        if target.is_empty:
            target = shapely.Point(shapely.get_coordinates(shapely.shortest_line(self._triangles[last], zone))[0])
        portals = self._portals(tree, last)
        points: tuple[Point, ...] = (tree.cost[last][1], tree.cost[last][1])
        last_aim: Point | None = None
        for _ in range(FINE.aims):
            x, y = shapely.get_coordinates(shapely.shortest_line(target, shapely.Point(points[-2:][0])))[0].tolist()
            if (x, y) == last_aim:
                break
            last_aim = (x, y)
            points = _pull(tree.start, portals, last_aim)
        return points

    def _portals(self, tree: Tree[int, Edge], row: int) -> list[Portal]:
        """Return the edges that the way to a triangle crosses, each as (left, right)."""
        portals: list[Portal] = []
        while row in tree.before:
            row, (a, b) = tree.before[row]
            left, right = self._points[[b, a]].tolist()
            portals.append(((left[0], left[1]), (right[0], right[1])))
        return portals[::-1]

    def _nearest(self, tree: Tree[int, Edge], zone: Polygon) -> int:
        """Return the triangle through which the way into a zone is shortest."""
        rows = [row for row in np.sort(self._tree.query(zone, predicate="intersects")).tolist() if row in tree.cost]
        if not rows:  # by rounding, a zone that touches the free space meets none of its triangles
            known = sorted(tree.cost)
            return known[int(np.argmin(shapely.distance(self._triangles[known], zone)))]
        doors = shapely.points([tree.cost[row][1] for row in rows])
        lines = shapely.shortest_line(shapely.intersection(self._triangles[rows], zone), doors)
        best = int(np.argmin(np.array([tree.cost[row][0] for row in rows]) + shapely.length(lines)))
        return rows[best]


def _turn(a: Point, b: Point, c: Point) -> float:
    """Return twice the signed area of a, b, c: positive when c is left of the line from a to b."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _pull(start: Point, portals: list[Portal], goal: Point) -> tuple[Point, ...]:
    """Pull a string tight through portals (the funnel algorithm); returns its corners."""
    gates = [*portals, (goal, goal)]
    apex, points, at = start, [start], 0
    # left and right side of the cone that is seen from the apex, and the gates they are from
    ends, since = list(gates[0]), [0, 0]
    while at < len(gates):
        for side, sign in ((1, 1.0), (0, -1.0)):
            new, other = gates[at][side], ends[1 - side]
            if sign * _turn(apex, ends[side], new) < 0:
                continue
            if apex != ends[side] and sign * _turn(apex, other, new) >= 0:  # the sides cross: a corner of the way
                points.append(other)
                apex, at = other, since[1 - side] + 1
                ends, since = [apex, apex], [at - 1, at - 1]
                break
            ends[side], since[side] = new, at
        else:
            at += 1
    points.append(goal)
    return tuple(point for point, before in zip(points, [None, *points], strict=False) if point != before)
