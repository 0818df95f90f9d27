"""Starts built one thing after the other: each at the best of many places drawn from its statements.

A start drawn blindly leaves the gradient search in a knot of things that block one another. Here each thing takes the place
where it overlaps least with what stands already, with the floor that people need in front of it, and with the doors.
"""

from __future__ import annotations

import math
from collections.abc import Collection

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray

from robolayout._grid import components
from robolayout.assets.obstacles import use_sides
from robolayout.constraints import AssetRef
from robolayout.scene import Room, vertical_span
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.proposals import Proposals, carry

CANDIDATES = 64
"""Places looked at for each thing."""

LOOKS = 4
"""Most times that it looks at so many."""

GOOD = 1.5
"""Cost of a place at which it looks no further."""

CLOSEST = 0.02
"""Metres between a thing and the wall behind it."""

OUTSIDE, BODY, STRIP, MISSED, AWAY = 20.0, 10.0, 2.0, 3.0, 0.02
"""Costs: of lying outside the room and of overlap, whole; of blocked floor in front, whole; of a row missed by a metre or
more; per metre from the guess."""

WALKED = 1.0
"""Cost of taking only floor that people could walk on until then."""

CUT = 4.0
"""Cost of cutting the floor in two, or of shutting a door."""

CUTS = 24
"""Places of a thing of which this is looked at, the cheapest first."""

GRID = 0.1
"""Metres per cell of the floor that people can walk on."""

CORNER = 0.3
"""Cost of a metre from the corner that a packed room is filled from."""

GRAIN = 0.002
"""Metres between packed things."""

PACKED = 3000
"""Most places with one heading that packing looks at for a thing."""

Rects = NDArray[np.float64]
"""(n, 4): low x, low y, high x, high y in metres."""


class Builder:
    """Builds starts for the things of the first stage of a problem.

    Args:
        problem: The problem.
        moving: Slots to place.
        rng: Source of randomness.
    """

    def __init__(self, problem: Problem, moving: tuple[int, ...], rng: np.random.Generator) -> None:
        self.problem, self.moving, self.rng = problem, moving, rng
        self.proposals = Proposals.of(problem)
        self._floor = shapely.Polygon(problem.scene.room.vertices)
        shapely.prepare(self._floor)
        self._depth = min(2 * max(agent.radius for agent in problem.scene.agents) + 0.05, 1.0)
        spans = [vertical_span(a, problem.guess[a.name]) for a in problem.scene.assets]
        self._spans = np.array(spans).reshape(-1, 2)
        self._solid = np.array([not asset.is_flat for asset in problem.scene.assets])
        self._fronts = np.array(["front" in use_sides(a) for a in problem.scene.assets])
        self._rank = self._ranks()
        agent = max(problem.scene.agents, key=lambda a: a.radius)
        low, high = self._spans.T
        self._blocks = self._solid & (low < agent.height) & (high > agent.step)
        self._radius = min(agent.radius, 0.5)
        self._walkable = _walkable(problem.scene.room, self._radius)
        self._entries = _entries(problem.scene.room, self._walkable)

    def build(self, world: Floats, slots: Collection[int] | None = None) -> Floats:
        """Return one start (n, 4) with some slots placed anew, all that move by default; the others stay as in `world`."""
        slots = self.moving if slots is None else slots
        world = world.copy()
        area = self.problem.half.prod(axis=1) * self.rng.uniform(0.7, 1.4, len(world))
        settled = self._standing(slots)
        walkable = self._walkable.copy()
        for cells in self._cells(self._bodies(settled, world[settled]))[self._blocks[settled]]:
            _take(walkable, cells)
        free = [not self.proposals.frames.get(s) for s in range(len(world))]
        for slot in sorted(slots, key=lambda s: (self._rank[s], free[s], -area[s], s)):
            carry(self.problem, world, slot, self._place(slot, world, settled, walkable))
            settled.append(slot)
        return world

    def _place(self, slot: int, world: Floats, settled: list[int], walkable: NDArray[np.bool_]) -> Floats:
        """Return the best of many places of a slot, and take the floor that it needs; where all are bad, look again."""
        best, least = world[slot], math.inf
        for _ in range(LOOKS):
            places = self._places(slot, world)
            cost = self._cost(slot, places, world, settled)
            if self._blocks[slot]:
                cells = self._cells(self._bodies(slot, places))
                cost += WALKED * _share(walkable, cells)
                k = _uncut(walkable, cells, cost, self._entries)
            else:
                k = int(np.argmin(cost))
            if cost[k] < least:
                best, least = places[k], float(cost[k])
            if least < GOOD:
                break
        if self._blocks[slot]:
            _take(walkable, self._cells(self._bodies([slot], best[None]))[0])
        return best

    def _cells(self, bodies: Rects) -> NDArray[np.intp]:
        """Return the cells (m, 4), low x, low y, high x, high y, that bodies and the way around them take."""
        x0, y0, _, _ = self.problem.scene.room.bounds
        reach = np.array([-1.0, -1.0, 1.0, 1.0]) * self._radius
        cells = (bodies + reach - (x0, y0, x0, y0)) / GRID
        cells = np.concatenate([np.floor(cells[:, :2]), np.ceil(cells[:, 2:])], axis=1)
        return np.clip(cells.astype(np.intp), 0, np.tile(self._walkable.shape, 2))

    def pack(self, world: Floats) -> Floats:
        """Return a start (n, 4) that fills the room from one corner, each thing flush with its neighbours.

        For rooms so full that only this finds a place for everything; edges are those along the axes.
        """
        world = world.copy()
        x0, y0, x1, y1 = self.problem.scene.room.bounds
        corner = np.array([self.rng.choice((x0, x1)), self.rng.choice((y0, y1))])
        area = self.problem.half.prod(axis=1) * self.rng.uniform(0.5, 2.0, len(world))
        settled = self._standing(self.moving)
        for slot in sorted(self.moving, key=lambda s: (-area[s], s)):
            places = self._flush(slot, world, settled)
            cost = self._hard_cost(slot, places, world, settled)
            for term in self.proposals.frames.get(slot, []):
                cost += MISSED / 3 * np.minimum(self.proposals.misses(term, slot, places, world), 1.0)
            cost += CORNER * np.hypot(*(places[:, :2] - corner).T)
            carry(self.problem, world, slot, places[int(np.argmin(cost))])
            settled.append(slot)
        return world

    def _standing(self, placed: Collection[int]) -> list[int]:
        """Return the slots on the floor, at walls and at the ceiling that stay while others are placed."""
        return [s for s, parent in enumerate(self.problem.parent) if s not in placed and parent < 0]

    def _flush(self, slot: int, world: Floats, settled: list[int]) -> Floats:
        """Return places (m, 4) at which two sides of a slot touch something: walls, landings, what stands already."""
        room = self.problem.scene.room
        outline = np.array(room.vertices)
        landings = [np.array(room.landing(door)) for door in room.doors]
        bodies = self._bodies(settled, world[settled])
        edges = [
            np.unique(np.round(np.concatenate([outline[:, k], *(p[:, k] for p in landings), *bodies[:, k::2].T]), 4))
            for k in (0, 1)
        ]
        quarters = self.rng.permutation(4) * (np.pi / 2)
        found: list[Floats] = []
        for yaw in quarters:
            c, s = np.cos(yaw), np.sin(yaw)
            reach = np.abs([[c, s], [s, c]]) @ self.problem.half[slot] + GRAIN
            x, y = (np.concatenate([e + r, e - r]) for e, r in zip(edges, reach, strict=True))
            grid = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
            if len(grid) > PACKED:
                grid = grid[self.rng.choice(len(grid), PACKED, replace=False)]
            found.append(np.column_stack([grid, np.broadcast_to((c, s), grid.shape)]))
        return np.concatenate(found)

    def _ranks(self) -> list[int]:
        """Return how many things stand between a slot and what it is placed by: what others refer to comes first."""
        ahead: list[set[int]] = [set() for _ in self.problem.names]
        for slot, terms in self.proposals.frames.items():
            ahead[slot] |= {self.problem.slot[t.b.name] for t in terms if isinstance(t.b, AssetRef)} - {slot}
        ranks = [0] * len(ahead)
        for _ in range(4):
            ranks = [max((ranks[b] + 1 for b in before), default=0) for before in ahead]
        return ranks

    def _places(self, slot: int, world: Floats) -> Floats:
        """Return places (m, 4): drawn from its statements, and along the walls if nothing says where it goes."""
        drawn = self.proposals.draw(slot, world, CANDIDATES, self.rng)
        if self.proposals.frames.get(slot) or not self._fronts[slot]:
            return drawn
        return np.concatenate([drawn[: CANDIDATES // 4], self._along_walls(slot, CANDIDATES)])

    def _along_walls(self, slot: int, count: int) -> Floats:
        """Return places with the back to a wall."""
        hx, hy = self.problem.half[slot]
        walls = [wall for wall in self.problem.scene.room.walls if wall.length >= 2 * hy]
        if not walls:
            return np.empty((0, 4))
        lengths = np.array([wall.length for wall in walls])
        which = self.rng.choice(len(walls), count, p=lengths / lengths.sum())
        along = hy + self.rng.random(count) * (lengths[which] - 2 * hy)
        along = np.where(self.rng.random(count) < 0.3, hy + CLOSEST, along)
        starts, ways, normals = (
            np.array([getattr(w, name) for w in walls])[which] for name in ("start", "direction", "normal")
        )
        return np.concatenate([starts + along[:, None] * ways + (hx + CLOSEST) * normals, normals], axis=1)

    def _cost(self, slot: int, places: Floats, world: Floats, settled: list[int]) -> Floats:
        """Return what each place (m, 4) of a slot costs, given what is settled."""
        front = self._strips(np.full(len(places), slot), places)
        cost = self._hard_cost(slot, places, world, settled) + self.rng.random(len(places)) * 0.05
        cost += AWAY * np.hypot(*(places[:, :2] - world[slot, :2]).T)
        mine, others = self._bodies(slot, places), self._beside(slot, settled)
        if others:
            bodies = self._bodies(others, world[others])
            if self._fronts[slot]:
                cost += STRIP * np.minimum(_shared(front, bodies).sum(axis=1) / _area(front), 1.0)
            facing = [s for s in others if self._fronts[s]]
            ahead = self._strips(facing, world[facing])
            cost += STRIP * (_shared(mine, ahead) / _area(ahead)).sum(axis=1)
        if self._fronts[slot]:
            cost += STRIP * self._outside(front)
        for term in self.proposals.frames.get(slot, []):
            if not isinstance(term.b, AssetRef) or self.problem.slot[term.b.name] in settled:
                cost += MISSED * np.minimum(self.proposals.misses(term, slot, places, world), 1.0)
        return cost

    def _hard_cost(self, slot: int, places: Floats, world: Floats, settled: list[int]) -> Floats:
        """Return what each place (m, 4) costs by what it overlaps and how far it lies outside."""
        mine, others = self._bodies(slot, places), self._beside(slot, settled)
        area = float(4 * self.problem.half[slot].prod())
        cost = OUTSIDE * self._outside(mine)
        if self._solid[slot]:
            for door in self.problem.scene.room.doors:
                landing = np.array(self.problem.scene.room.landing(door))
                cost += BODY * _shared(mine, np.array([[*landing.min(axis=0), *landing.max(axis=0)]]))[:, 0] / area
        if others:
            least = np.minimum(area, 4 * self.problem.half[others].prod(axis=1))
            cost += BODY * (_shared(mine, self._bodies(others, world[others])) / least).sum(axis=1)
        return cost

    def _beside(self, slot: int, settled: list[int]) -> list[int]:
        """Return which of the settled slots a slot could collide with."""
        low, high = self._spans[slot]
        if not self._solid[slot]:
            return []
        return [s for s in settled if self._solid[s] and self._spans[s, 0] < high and self._spans[s, 1] > low]

    def _bodies(self, slots: ArrayLike, poses: Floats) -> Rects:
        """Return the bounds of slots (m,), or of one slot, at their poses (m, 4)."""
        return _bounds(poses[:, :2], poses[:, 2:], *self.problem.half[np.asarray(slots, dtype=np.intp)].T)

    def _outside(self, rects: Rects) -> Floats:
        """Return which share of nine points of each rectangle (m, 4) is not on the floor."""
        shares = np.linspace(0.002, 0.998, 3)
        x = rects[:, 0, None] + shares * (rects[:, 2] - rects[:, 0])[:, None]
        y = rects[:, 1, None] + shares * (rects[:, 3] - rects[:, 1])[:, None]
        points = np.broadcast_arrays(x[:, :, None], y[:, None, :])
        return 1.0 - shapely.contains_xy(self._floor, *points).reshape(len(rects), -1).mean(axis=1)

    def _strips(self, slots: ArrayLike, poses: Floats) -> Rects:
        """Return the bounds of the floor in front of slots (m,) at their poses."""
        index = np.asarray(slots, dtype=np.intp)
        hx, hy = self.problem.half[index].T
        middle = poses[:, :2] + (hx + self._depth / 2)[:, None] * poses[:, 2:]
        return _bounds(middle, poses[:, 2:], self._depth / 2, hy)


def _walkable(room: Room, radius: float) -> NDArray[np.bool_]:
    """Return in which cells of the empty room the centre of a disc can be."""
    x0, y0, x1, y1 = room.bounds
    x, y = np.arange(x0 + GRID / 2, x1, GRID), np.arange(y0 + GRID / 2, y1, GRID)
    inner = shapely.Polygon(room.vertices).buffer(-radius)
    shapely.prepare(inner)
    return np.asarray(shapely.contains_xy(inner, *np.meshgrid(x, y, indexing="ij")))


def _entries(room: Room, walkable: NDArray[np.bool_]) -> NDArray[np.intp]:
    """Return the cells (doors, 2) to walk on that are nearest to where people come in."""
    x0, y0, _, _ = room.bounds
    free = np.argwhere(walkable)
    if not len(free) or not room.doors:
        return np.empty((0, 2), np.intp)
    middles = np.array([np.mean(room.landing(door), axis=0) for door in room.doors])
    return free[[int(np.argmin(np.hypot(*((free + 0.5) * GRID + (x0, y0) - middle).T))) for middle in middles]]


def _take(walkable: NDArray[np.bool_], cells: NDArray[np.intp]) -> None:
    """Mark cells as taken from those who walk."""
    x0, y0, x1, y1 = cells
    walkable[x0:x1, y0:y1] = False


def _share(walkable: NDArray[np.bool_], cells: NDArray[np.intp]) -> Floats:
    """Return which share of the cells (m, 4) of each place is floor to walk on now."""
    sums = np.pad(walkable.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    x0, y0, x1, y1 = cells.T
    taken = sums[x1, y1] - sums[x0, y1] - sums[x1, y0] + sums[x0, y0]
    return taken / np.maximum((x1 - x0) * (y1 - y0), 1)


def _uncut(walkable: NDArray[np.bool_], cells: NDArray[np.intp], cost: Floats, entries: NDArray[np.intp]) -> int:
    """Return the cheapest place, where one that cuts the floor in two or shuts a door costs more than one that does not."""
    looked_at: set[int] = set()
    while True:
        best = int(np.argmin(cost))
        if best in looked_at or len(looked_at) == CUTS:
            return best
        looked_at.add(best)
        if _cuts(walkable, cells[best], entries):
            cost[best] += CUT


def _cuts(walkable: NDArray[np.bool_], cells: NDArray[np.intp], entries: NDArray[np.intp]) -> bool:
    """Return whether taking cells cuts the floor in two or shuts a door."""
    x0, y0, x1, y1 = cells
    if ((entries >= (x0, y0)) & (entries < (x1, y1))).all(axis=1).any():
        return True
    around = np.pad(walkable, 1)
    x, y = np.arange(x0, x1 + 2), np.arange(y0, y1 + 2)  # one cell more on each side, in the padded grid
    ring = np.concatenate(
        [
            np.stack([x[:-1], np.full(len(x) - 1, y[0])], axis=1),
            np.stack([np.full(len(y) - 1, x[-1]), y[:-1]], axis=1),
            np.stack([x[:0:-1], np.full(len(x) - 1, y[-1])], axis=1),
            np.stack([np.full(len(y) - 1, x[0]), y[:0:-1]], axis=1),
        ]
    )
    free = around[ring[:, 0], ring[:, 1]]
    if (free & ~np.roll(free, 1)).sum() <= 1:
        return False
    around[x0 + 1 : x1 + 1, y0 + 1 : y1 + 1] = False
    labels, _ = components(around)
    return len(np.unique(labels[ring[free, 0], ring[free, 1]])) > 1


def _bounds(center: Floats, heading: Floats, hx: Floats | float, hy: Floats | float) -> Rects:
    """Return the bounds of rectangles with these middles and unit headings (m, 2) and half sizes (m,)."""
    c, s = np.abs(heading).T
    reach = np.stack([c * hx + s * hy, s * hx + c * hy], axis=1)
    return np.concatenate([center - reach, center + reach], axis=1)


def _shared(a: Rects, b: Rects) -> Floats:
    """Return the areas (m, n) that rectangles (m, 4) and (n, 4) share."""
    low, high = np.maximum(a[:, None, :2], b[None, :, :2]), np.minimum(a[:, None, 2:], b[None, :, 2:])
    return np.maximum(high - low, 0.0).prod(axis=2)


def _area(rects: Rects) -> Floats:
    return np.maximum((rects[:, 2:] - rects[:, :2]).prod(axis=1), 1e-9)
