"""Driving: ways of a rectangular body that cannot slide sideways, in position and heading, with reversals counted.

The body drives straight on, on arcs no tighter than its turning radius, ahead or back, and turns on the spot if that radius
is 0 and its turning circle is free. Its moves join places and headings of a lattice that starts at the door: 16 headings whose
directions are whole numbers of cells, so that every straight or curved move ends on the lattice exactly. A move is open where
the shape that it sweeps meets neither wall nor obstacle (Minkowski sums with the convex hull of what is swept). One
shortest-path search from the door serves all things. Finer ways than the lattice has may exist; one that is found is proved.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray
from scipy.sparse import csr_array
from scipy.sparse.csgraph import breadth_first_order, dijkstra

from robolayout.scene import ROUNDING, Agent, Point, Room
from robolayout.verify._obstacles import Obstacles
from robolayout.verify.heading import Drive, Pose, free_of, rectangle

QUARTER = ((1, 0), (2, 1), (1, 1), (1, 2))  # directions of the headings of a quarter turn, in cells
DIRECTIONS = (*QUARTER, *((-y, x) for x, y in QUARTER), *((-x, -y) for x, y in QUARTER), *((y, -x) for x, y in QUARTER))
ANGLES = tuple(math.atan2(y, x) for x, y in DIRECTIONS)  # the same in radians, in the lattice's frame
TURNS = len(DIRECTIONS)


@dataclass(frozen=True)
class LatticeConfig:
    """How finely drives are looked for."""

    cell: float = 0.10  # metres between places of the lattice at most, unless the room is large
    finest: float = 0.04  # metres between them at least
    rows: int = 3  # rows of places that the middle of a body finds in a straight corridor for its disc
    places: int = 60_000  # places at most: larger rooms get wider cells
    reversal: float = 2.0  # metres of detour that a reversal is worth
    pivot: float = 0.5  # metres that a turn on the spot by one heading is worth
    sample: float = math.radians(2.0)  # radians between the poses that stand for an arc
    entry: float = 0.3  # metres between where a body comes in and the place of the lattice from which it drives
    # metres by which a swept shape is drawn larger than the body: arcs bulge by less between two samples
    bulge: float = 1e-3


LATTICE = LatticeConfig()

Poses = NDArray[np.float64]  # (n, 3): x and y in metres and heading in radians

Places = Callable[[float], Iterable[tuple[str, bytes]]]
"""Yields for a heading in radians, half a turn changing nothing, names of things and from where a body uses them: polygons as WKB."""


@dataclass(frozen=True, eq=False)
class LatticeMove:
    """What a body does from one place of the lattice to the next."""

    step: tuple[int, int]  # cells along x and y
    turn: int  # headings by which it turns to the left: -1, 0 or 1
    cost: float  # metres driven, or what a turn on the spot is worth
    poses: Poses  # the poses on the way in the lattice's frame, the first one aside


@dataclass(frozen=True)
class _Grid:
    """Where the places of a lattice are."""

    origin: Point  # metres
    heading: float  # radians, of its first axis
    cell: float  # metres
    low: tuple[int, int]  # cells from the origin to the first place
    shape: tuple[int, int]  # places along each axis

    @cached_property
    def places(self) -> NDArray[np.float64]:
        """(n, 2) metres."""
        cells = np.indices(self.shape).reshape(2, -1).T + self.low
        return np.asarray(cells * self.cell @ _axes(self.heading) + self.origin, np.float64)


def _axes(heading: float) -> NDArray[np.float64]:
    """Return the axes (2, 2) of a lattice."""
    c, s = math.cos(heading), math.sin(heading)
    return np.array([(c, s), (-s, c)])


@dataclass(frozen=True, eq=False)
class _Sweeps:
    """What a body does from the places of a lattice, and the convex shapes that it sweeps, a move and its way back being one."""

    moves: tuple[tuple[LatticeMove, ...], ...]  # by heading
    shapes: tuple[NDArray[np.float64], ...]  # corners (m, 2) of each, metres from the place where the move begins
    # by heading and move, which shape that is, and how many cells from the place where it begins
    of: tuple[tuple[tuple[int, tuple[int, int]], ...], ...]

    @cached_property
    def sides(self) -> list[NDArray[np.float64]]:
        """Normals (m, 2) of each shape seen from what it meets."""
        return [_sides(-shape) for shape in self.shapes]


def _sides(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the outward normals (m, 2) of a convex shape (m, 2)."""
    along = np.roll(corners, -1, axis=0) - corners
    normals = np.column_stack([along[:, 1], -along[:, 0]])
    out = (normals * (corners - corners.mean(axis=0))).sum(axis=1)
    return np.asarray(normals * np.sign(out)[:, None], np.float64)


@lru_cache(maxsize=16)
def _swept(agent: Agent, heading: float, cell: float) -> _Sweeps:
    """Return the moves of a body on a lattice at a heading in radians, and what they sweep."""
    every = tuple(tuple(_moves(k, cell, agent.turning_radius or 0.0)) for k in range(TURNS))
    hulls, of = list[NDArray[np.float64]](), list[tuple[tuple[int, tuple[int, int]], ...]]()
    known: dict[tuple[int, int, bool], int] = {}
    for k, moves in enumerate(every):
        numbers = list[tuple[int, tuple[int, int]]]()
        for move in moves:
            on_spot = not any(move.step)
            half = TURNS // 2 if on_spot else TURNS  # on the spot a rectangle sweeps the same half a turn later
            own, back = (
                (k % half, move.turn, on_spot),
                known.get(((k + move.turn + TURNS // 2) % half, -move.turn, on_spot)),
            )
            if back is None and own not in known:
                known[own] = len(hulls)
                poses = np.concatenate([[(0.0, 0.0, ANGLES[k])], move.poses])
                rings = [rectangle(agent, heading + turn, LATTICE.bulge) + at @ _axes(heading) for *at, turn in poses]
                hull = shapely.MultiPoint(np.concatenate(rings)).convex_hull
                hulls.append(shapely.get_coordinates(hull)[:-1])
            numbers.append((known[own], (0, 0)) if back is None else (back, (-move.step[0], -move.step[1])))
        of.append(tuple(numbers))
    return _Sweeps(every, tuple(hulls), tuple(of))


@lru_cache(maxsize=512)  # while a layout is mended one thing moves, and all others meet what they met before
def _met(grid: _Grid, sweeps: _Sweeps, ring: bytes) -> NDArray[np.intp]:
    """Return where sweeps meet a rectangle, corners (4, 2) as bytes: flat indices of (sweep, place).

    Two convex shapes meet where none of their sides has them apart.
    """
    corners, met = np.frombuffer(ring).reshape(4, 2), list[NDArray[np.intp]]()
    own, every = _sides(corners), np.concatenate(sweeps.shapes)
    low, high = corners.min(axis=0) - every.max(axis=0), corners.max(axis=0) - every.min(axis=0)
    near = np.flatnonzero(((grid.places >= low) & (grid.places <= high)).all(axis=1))
    places = grid.places[near].T
    for number, (shape, sides) in enumerate(zip(sweeps.shapes, sweeps.sides, strict=True)):
        normals = np.concatenate([own, sides])
        reach = (normals @ corners.T).max(axis=1) + (normals @ -shape.T).max(axis=1)
        hit = (normals @ places <= reach[:, None]).all(axis=0)
        met.append(number * len(grid.places) + near[hit])
    return np.concatenate(met)


def _inside(grid: _Grid, room: Room, body: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return (n,) at which places a convex body, corners (m, 2), stands in the empty room."""
    free = free_of(room, np.array([], dtype=object), body)
    shapely.prepare(free)
    return np.asarray(shapely.contains_xy(free, *grid.places.T))


@lru_cache(maxsize=4096)
def _among(grid: _Grid, zone: bytes) -> NDArray[np.intp]:
    """Return which places lie in a zone, WKB."""
    area = shapely.from_wkb(zone)
    x0, y0, x1, y1 = area.bounds
    x, y = grid.places.T
    shapely.prepare(area)
    near = np.flatnonzero((x >= x0) & (x <= x1) & (y >= y0) & (y <= y1))
    return near[shapely.intersects_xy(area, x[near], y[near])]


@dataclass(frozen=True, eq=False)
class _Graph:
    """What of a lattice is open in the empty room: nodes are (heading, place), edges are listed node after node."""

    free: NDArray[np.bool_]  # flat (sweep, place): where nothing of the room is met; one more that is always free
    first: NDArray[np.intp]  # (nodes + 1,) the number of each node's first edge
    after: NDArray[np.int32]  # (edges,) the node to which each leads
    needs: NDArray[np.int32]  # (edges,) what has to be free for it
    kind: NDArray[np.uint8]  # (edges,) which of the costs it has
    costs: NDArray[np.float64]  # of each move, and of a reversal
    # edges of moves from or to a place at the first heading, and these places
    entering: tuple[NDArray[np.intp], NDArray[np.intp]]


@lru_cache(maxsize=2)
def _graph(grid: _Grid, room: Room, agent: Agent) -> _Graph:
    """Return the lattice of a body in an empty room: its moves, and reversals where it stands."""
    sweeps, count, half = _swept(agent, grid.heading, grid.cell), len(grid.places), TURNS // 2
    free = np.append(np.concatenate([_inside(grid, room, shape) for shape in sweeps.shapes]), True)
    places, edges, costs = np.arange(count, dtype=np.int32), list[NDArray[np.int32]](), list[float]()
    for k, (moves, of) in enumerate(zip(sweeps.moves, sweeps.of, strict=True)):
        for move, (shape, back) in zip(moves, of, strict=True):
            there = places + move.step[0] * grid.shape[1] + move.step[1]
            needs = shape * count + (there if any(back) else places)
            nodes = k * count + places, (k + move.turn) % TURNS * count + there
            held = (needs >= shape * count) & (needs < (shape + 1) * count)
            held[held] = free[needs[held]]
            edges.append(np.stack([*nodes, needs, np.full_like(needs, len(costs))])[:, held])
            costs.append(move.cost)
    stands = np.unique(np.concatenate([ends[:2].ravel() for ends in edges]))
    turned = (stands + half * count) % (TURNS * count)
    edges.append(np.stack([stands, turned, np.full_like(stands, len(free) - 1), np.full_like(stands, len(costs))]))
    table = np.concatenate(edges, axis=1)
    before, after, needs, kind = table[:, np.argsort(table[0], kind="stable")]
    first = np.searchsorted(before, np.arange(TURNS * count + 1))
    ends = [np.flatnonzero((end < count) & (kind < len(costs))) for end in (before, after)]
    entering = np.concatenate(ends), np.concatenate([before[ends[0]], after[ends[1]]])
    return _Graph(free, first, after, needs, kind.astype(np.uint8), np.array([*costs, LATTICE.reversal]), entering)


class Lattice:
    """Where a body with length, width and turning radius can drive from the door; its places do not depend on what stands there.

    Its centre comes in at `start`, metres, if nothing is in the way, else beside that as far as the door is wide; its heading is
    then `heading`, radians.
    """

    def __init__(self, room: Room, blocking: Obstacles, agent: Agent, start: Point, heading: float) -> None:
        self._room, self._blocking, self._agent = room, blocking, agent
        cell, self._axes = _cell(agent, room), _axes(heading)
        corners = (np.array(room.vertices) - start) @ self._axes.T / cell
        (left, bottom), (right, top) = np.floor(corners.min(axis=0)), np.ceil(corners.max(axis=0))
        shape = (int(right - left) + 1, int(top - bottom) + 1)
        self._grid = _Grid(start, heading, cell, (int(left), int(bottom)), shape)
        self._places, self._angle, self._graph = self._grid.places, heading, _graph(self._grid, room, agent)
        self._sweeps = _swept(agent, heading, cell)

    @cached_property
    def _open(self) -> NDArray[np.bool_]:
        """(edges,) which of the empty room's are open as things stand."""
        free = self._graph.free.copy()
        for ring in shapely.get_coordinates(self._blocking.shapes).reshape(-1, 5, 2)[:, :4]:
            free[_met(self._grid, self._sweeps, ring.tobytes())] = False
        return free[self._graph.needs]

    def _links(self, values: NDArray[np.generic]) -> csr_array:
        """Return which node (heading, place) leads to which as things stand; values of the empty room's edges (edges,) to go with that."""
        graph, nodes = self._graph, TURNS * len(self._places)
        first = np.concatenate([[0], np.cumsum(self._open)]).astype(np.int32)[graph.first]
        return csr_array((values[self._open], graph.after[self._open], first), shape=(nodes, nodes))

    @cached_property
    def _start(self) -> int | None:
        """The place nearest to where the body comes in at which it can stand, heading into the room; None where there is none."""
        (edges, places), doors = self._graph.entering, self._room.doors
        here = np.unique(places[self._open[edges]])
        offset = np.abs((self._places[here] - self._grid.origin) @ self._axes.T)  # ahead and aside
        if doors:
            aside = max(0.0, doors[0].width - (self._agent.width or 0.0)) / 2
            here, offset = (values[offset[:, 1] <= aside + ROUNDING] for values in (here, offset))
        away = np.hypot(*offset.T)
        return int(here[np.argmin(away)]) if len(here) and away.min() <= LATTICE.entry else None

    @cached_property
    def _found(self) -> tuple[NDArray[np.float64], NDArray[np.intp]]:
        """Cost in metres from the start to every (heading, place), and the node before it; negative where there is none."""
        graph, nodes = self._graph, TURNS * len(self._places)
        if self._start is None:
            return np.full(nodes, np.inf), np.full(nodes, -1, dtype=np.intp)
        links = self._links(graph.costs[graph.kind])
        cost, previous = dijkstra(links, indices=self._start, return_predecessors=True)
        return cost, previous

    def reached(self, places: Places) -> set[str]:
        """Return what the body gets to."""
        there = np.zeros((2, TURNS // 2, len(self._places)), dtype=bool)
        if self._start is not None:
            found = breadth_first_order(self._links(self._graph.kind), self._start, return_predecessors=False)
            there.ravel()[found] = True
        either = there[0] | there[1]
        names = set[str]()
        for k in range(TURNS // 2):
            zones = ((name, zone) for name, zone in places(self._angle + ANGLES[k]) if name not in names)
            names |= {name for name, zone in zones if either[k, _among(self._grid, zone)].any()}
        return names

    def drives(self, places: Places) -> dict[str, Drive]:
        """Return the cheapest drive to each thing that the body gets to."""
        cost, _ = self._found
        by_heading, count = cost.reshape(TURNS, -1), len(self._places)
        best: dict[str, tuple[float, int]] = {}
        for k in range(TURNS // 2):
            both = by_heading[[k, k + TURNS // 2]]
            ahead, least = both.argmin(axis=0), both.min(axis=0)
            for name, zone in places(self._angle + ANGLES[k]):
                there = _among(self._grid, zone)
                near = least[there]
                if len(there) and math.isfinite(lowest := float(near.min())):
                    nodes = (k + ahead[there] * (TURNS // 2)) * count + there
                    found = (lowest, int(nodes[near == lowest].min()))
                    best[name] = min(best.get(name, found), found)
        return {name: self._drive(name, node) for name, (_, node) in best.items()}

    def _drive(self, name: str, node: int) -> Drive:
        """Return the way to a node; the body drives forwards until it first changes direction."""
        _, previous = self._found
        count, chain = len(self._places), [node]
        while previous[chain[-1]] >= 0:
            chain.append(int(previous[chain[-1]]))
        chain.reverse()
        heading, reversals = self._angle, 0
        poses = [(*self._places[chain[0] % count].tolist(), heading)]
        for (before, here), (after, there) in pairwise(divmod(node, count) for node in chain):
            turn = (after - before + TURNS // 2) % TURNS - TURNS // 2
            if here == there and abs(turn) == TURNS // 2:
                reversals += 1
            else:
                move = next(m for m in self._sweeps.moves[before] if m.turn == turn and any(m.step) == (here != there))
                spots = self._places[here] + move.poses[:, :2] @ self._axes
                turned = heading + move.poses[:, 2] - ANGLES[before]
                poses += [(x, y, yaw) for (x, y), yaw in zip(spots.tolist(), turned.tolist(), strict=True)]
                heading = poses[-1][2]
        return Drive(name, tuple(_straightened(poses)), reversals)


def _cell(agent: Agent, room: Room) -> float:
    """Return how far apart places are: so that a corridor for the body's disc holds rows of them, and arcs are tight."""
    slack = 2 * (agent.radius - LATTICE.bulge) - (agent.width or 0.0)
    low_x, low_y, high_x, high_y = room.bounds
    tight = (agent.turning_radius or 0.0) * math.tan(ANGLES[1] / 2)
    widest = math.sqrt((high_x - low_x) * (high_y - low_y) / LATTICE.places)
    cell = max(min(LATTICE.cell, slack / LATTICE.rows), LATTICE.finest, widest)
    return tight / math.ceil(tight / cell) if tight > 0 else cell


def _moves(number: int, cell: float, radius: float) -> Iterator[LatticeMove]:
    """Yield the moves from a heading: straight on; to either side a line, an arc of at least a radius, and a line, or on the spot."""
    ahead, angle = np.array(DIRECTIONS[number]), ANGLES[number]
    straight = ahead * cell
    yield LatticeMove(DIRECTIONS[number], 0, math.hypot(*straight), np.array([(*straight, angle)]))
    for turn in (1, -1):
        after = np.array(DIRECTIONS[(number + turn) % TURNS])
        bend = math.remainder(ANGLES[(number + turn) % TURNS] - angle, math.tau)
        part = np.linspace(0.0, bend, math.ceil(abs(bend) / LATTICE.sample) + 1)
        if radius == 0.0:
            yield LatticeMove((0, 0), turn, LATTICE.pivot, np.column_stack([0.0 * part, 0.0 * part, angle + part])[1:])
        units = [math.hypot(*way) * cell for way in (ahead, after)]
        tangent = radius * math.tan(abs(bend) / 2)
        counts = [max(1, math.ceil(tangent / unit - 1e-9)) for unit in units]
        near = min(count * unit for count, unit in zip(counts, units, strict=True))
        true = near / math.tan(abs(bend) / 2)
        first = ahead / math.hypot(*ahead) * (counts[0] * units[0] - near)
        left = np.array([-math.sin(angle), math.cos(angle)]) * math.copysign(true, turn)
        c, s = np.cos(part)[:, None], np.sin(part)[:, None]
        arc = first + left - c * left - s * np.array([-left[1], left[0]])
        step = counts[0] * ahead + counts[1] * after
        poses = [*np.column_stack([arc, angle + part]), (*(step * cell), angle + bend)]
        length = sum(count * unit - near for count, unit in zip(counts, units, strict=True)) + true * abs(bend)
        yield LatticeMove((int(step[0]), int(step[1])), turn, length, np.array(poses))


def _straightened(poses: Sequence[Pose]) -> Iterator[Pose]:
    """Yield poses without those in the midst of a straight piece that is driven one way, and without repeats."""
    poses = [*poses[:1], *(pose for before, pose in pairwise(poses) if math.dist(pose, before) > 1e-9)]
    for number, pose in enumerate(poses):
        if 0 < number < len(poses) - 1:
            (ax, ay, a), (x, y, yaw), (bx, by, b) = poses[number - 1], pose, poses[number + 1]
            level = abs(a - yaw) < 1e-9 and abs(b - yaw) < 1e-9
            if level and (x - ax) * (bx - x) + (y - ay) * (by - y) > 0:
                continue
        yield pose
