"""Starts built one thing after the other: each at the best of many places drawn from its statements.

A start drawn blindly leaves the gradient search in a knot of things that block one another. Here each thing takes the place
where it overlaps least with what stands already, with the floor that people need in front of it, and with the doors.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray

from robolayout.assets.obstacles import use_sides
from robolayout.constraints import AssetRef
from robolayout.scene import vertical_span
from robolayout.solve._walked import Walked
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.proposals import Proposals, carry, compose, placing

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

NEEDS = 6
"""Places looked at for each thing that is yet to come and goes by the one that is placed."""

CORNER = 0.3
"""Cost of a metre from the corner that a packed room is filled from."""

GRAIN = 0.002
"""Metres between packed things."""

PACKED = 3000
"""Most places with one heading that packing looks at for a thing."""

Rects = NDArray[np.float64]
"""(n, 4): low x, low y, high x, high y in metres."""


@dataclass(frozen=True, eq=False)
class _Site:
    """A room while it is built.

    Attributes:
        settled: (n,) which slots have their place.
        bodies: (n, 4) bounds of slots.
        ahead: (n, 4) bounds of the floor in front of them.
        walked: The floor that is left to walk on.
    """

    settled: NDArray[np.bool_]
    bodies: Rects
    ahead: Rects
    walked: Walked


class Builder:
    """Builds starts for the things of the first stage of a problem.

    Args:
        problem: The problem.
        rng: Source of randomness.
    """

    def __init__(self, problem: Problem, rng: np.random.Generator) -> None:
        self.problem, self.moving, self.rng = problem, problem.movable(0), rng
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
        self._needs = self._followers()
        self._walked = Walked(problem.scene.room, min(agent.radius, 0.5))
        landings = [np.array(problem.scene.room.landing(door)) for door in problem.scene.room.doors]
        self._landings = np.array([[*corners.min(axis=0), *corners.max(axis=0)] for corners in landings]).reshape(-1, 4)

    def build(self, world: Floats, slots: Collection[int] | None = None) -> Floats:
        """Return one start (n, 4) with some slots placed anew, all that move by default; the others stay as in `world`."""
        slots = self.moving if slots is None else slots
        world = world.copy()
        area = self.problem.half.prod(axis=1) * self.rng.uniform(0.7, 1.4, len(world))
        site = self._site(world, slots)
        free = [not self.proposals.frames.get(s) for s in range(len(world))]
        for slot in sorted(slots, key=lambda s: (self._rank[s], free[s], -area[s], s)):
            carry(self.problem, world, slot, self._place(slot, world, site))
            site.settled[slot] = True
        return world

    def _site(self, world: Floats, slots: Collection[int]) -> _Site:
        """Return the room before slots are placed: what stands on the floor, at walls and at the ceiling beside them."""
        settled = np.array([parent < 0 for parent in self.problem.parent])
        settled[list(slots)] = False
        every = np.arange(len(world))
        site = _Site(settled, self._bodies(every, world), self._strips(every, world), self._walked.copy())
        site.walked.take(site.walked.cells(site.bodies[settled & self._blocks]))
        return site

    def _place(self, slot: int, world: Floats, site: _Site) -> Floats:
        """Return the best of many places of a slot, and take the floor that it needs; where all are bad, look again."""
        best, least = world[slot], math.inf
        for _ in range(LOOKS):
            places = self._places(slot, world)
            bodies = self._bodies(slot, places)
            cost = self._cost(slot, places, bodies, world, site)
            if self._blocks[slot]:
                cells = site.walked.cells(bodies)
                cost += WALKED * site.walked.share(cells)
                k = site.walked.cheapest(cells, cost)
            else:
                k = int(cost.argmin())
            if cost[k] < least:
                best, least = places[k], float(cost[k])
                site.bodies[slot] = bodies[k]
            if least < GOOD:
                break
        site.ahead[slot] = self._strips([slot], best[None])[0]
        if self._blocks[slot]:
            site.walked.take(site.walked.cells(site.bodies[[slot]]))
        return best

    def touched(self, slot: int, places: Floats, world: Floats) -> set[int]:
        """Return the slots whose bounds overlap those of a slot at some places (m, 4), at heights at which they would collide."""
        shared = _shared(self._bodies(slot, places), self._bodies(np.arange(len(world)), world)).max(axis=0)
        return set(np.flatnonzero(self._level(slot) & (shared > 0.0)).tolist()) - {slot}

    def pack(self, world: Floats) -> Floats:
        """Return a start (n, 4) that fills the room from one corner, each thing flush with its neighbours.

        For rooms so full that only this finds a place for everything; edges are those along the axes.
        """
        world = world.copy()
        x0, y0, x1, y1 = self.problem.scene.room.bounds
        corner = np.array([self.rng.choice((x0, x1)), self.rng.choice((y0, y1))])
        area = self.problem.half.prod(axis=1) * self.rng.uniform(0.5, 2.0, len(world))
        site = self._site(world, self.moving)
        for slot in sorted(self.moving, key=lambda s: (-area[s], s)):
            places = self._flush(slot, site.bodies[site.settled])
            bodies = self._bodies(slot, places)
            cost = self._hard_cost(slot, bodies, site)
            for term in self.proposals.frames.get(slot, []):
                cost += MISSED / 3 * np.minimum(self.proposals.misses(term, slot, places, world), 1.0)
            cost += CORNER * np.hypot(*(places[:, :2] - corner).T)
            k = int(cost.argmin())
            carry(self.problem, world, slot, places[k])
            site.settled[slot], site.bodies[slot] = True, bodies[k]
        return world

    def _flush(self, slot: int, bodies: Rects) -> Floats:
        """Return places (m, 4) at which two sides of a slot touch something: walls, landings, what stands already."""
        outline = np.array(self.problem.scene.room.vertices)
        rects = np.concatenate([self._landings, bodies])
        edges = [np.unique(np.round(np.concatenate([outline[:, k], *rects[:, k::2].T]), 4)) for k in (0, 1)]
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
        for slot, terms in self.proposals.mirrors.items():
            ahead[slot] |= {self.problem.slot[t.ref.name] for t in terms if isinstance(t.ref, AssetRef)} - {slot}
            if slot not in self.proposals.frames:
                twins = {self.proposals.twin(term, slot) for term in terms}
                ahead[slot] |= {twin for twin in twins if twin in self.proposals.frames}
        ranks = [0] * len(ahead)
        for _ in range(4):
            ranks = [max((ranks[b] + 1 for b in before), default=0) for before in ahead]
        return ranks

    def _followers(self) -> dict[int, list[tuple[int, Floats]]]:
        """Return for each slot what goes by it, and a few places (m, 4) of that in the slot's frame."""
        needs: dict[int, list[tuple[int, Floats]]] = {}
        origin = np.tile((0.0, 0.0, 1.0, 0.0), (len(self.problem.names), 1))
        for slot, terms in self.proposals.frames.items():
            for term in terms:
                if self.problem.parent[slot] >= 0 or not isinstance(term.b, AssetRef) or not placing(term):
                    continue
                places = self.proposals.placed(slot, term, origin, NEEDS, self.rng)
                needs.setdefault(self.problem.slot[term.b.name], []).append((slot, places))
                for mirror in self.proposals.mirrors.get(slot, []):
                    if mirror.ref == term.b:
                        image = (self.proposals.twin(mirror, slot), places * (1.0, -1.0, 1.0, -1.0))
                        needs[self.problem.slot[term.b.name]].append(image)
        return needs

    def _cramped(self, slot: int, places: Floats, site: _Site) -> Floats:
        """Return how little room each place (m, 4) of a slot leaves to what goes by it."""
        cost = np.zeros(len(places))
        for other, around in self._needs.get(slot, []):
            if not site.settled[other]:
                bodies = self._bodies(other, compose(places[:, None], around).reshape(-1, 4))
                cost += np.minimum(self._hard_cost(other, bodies, site).reshape(len(places), -1).min(axis=1), 1.0)
        return cost

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

    def _cost(self, slot: int, places: Floats, bodies: Rects, world: Floats, site: _Site) -> Floats:
        """Return what each place (m, 4) of a slot costs, given what is settled."""
        cost = self._hard_cost(slot, bodies, site) + self.rng.random(len(places)) * 0.05
        cost += AWAY * np.hypot(*(places[:, :2] - world[slot, :2]).T)
        cost += MISSED * self._cramped(slot, places, site)
        beside = self._beside(slot, site)
        ahead = site.ahead[beside & self._fronts]
        cost += STRIP * (_shared(bodies, ahead) / _area(ahead)).sum(axis=1)
        if self._fronts[slot]:
            front = self._strips(np.full(len(places), slot), places)
            cost += STRIP * np.minimum(_shared(front, site.bodies[beside]).sum(axis=1) / _area(front), 1.0)
            cost += STRIP * self._outside(front)
        for term in self.proposals.frames.get(slot, []):
            if not isinstance(term.b, AssetRef) or site.settled[self.problem.slot[term.b.name]]:
                cost += MISSED * np.minimum(self.proposals.misses(term, slot, places, world), 1.0)
        for term in self.proposals.mirrors.get(slot, []):
            if site.settled[self.proposals.twin(term, slot)]:
                image = self.proposals.image(term, slot, world)
                cost += MISSED * np.minimum(np.hypot(*(places[:, :2] - image[:2]).T), 1.0)
        return cost

    def _hard_cost(self, slot: int, bodies: Rects, site: _Site) -> Floats:
        """Return what each place of a slot, given by its bounds (m, 4), costs by what it overlaps and leaves of the room."""
        cost = OUTSIDE * self._outside(bodies)
        area = float(4 * self.problem.half[slot].prod())
        if self._solid[slot]:
            cost += BODY / area * _shared(bodies, self._landings).sum(axis=1)
        beside = self._beside(slot, site)
        least = np.minimum(area, 4 * self.problem.half[beside].prod(axis=1))
        return cost + BODY * (_shared(bodies, site.bodies[beside]) / least).sum(axis=1)

    def _beside(self, slot: int, site: _Site) -> NDArray[np.bool_]:
        """Return with which of the settled slots (n,) a slot could collide."""
        return site.settled & self._level(slot)

    def _level(self, slot: int) -> NDArray[np.bool_]:
        """Return which slots (n,), itself among them, are solid at heights at which a slot would collide with them."""
        low, high = self._spans.T
        return self._solid & self._solid[slot] & (low < high[slot]) & (high > low[slot])

    def _bodies(self, slots: ArrayLike, poses: Floats) -> Rects:
        """Return the bounds of slots (m,), or of one slot, at their poses (m, 4)."""
        return _bounds(poses[:, :2], poses[:, 2:], *self.problem.half[np.asarray(slots, dtype=np.intp)].T)

    def _outside(self, rects: Rects) -> Floats:
        """Return which share of nine points of each rectangle (m, 4) is not on the floor."""
        shares = np.linspace(0.002, 0.998, 3)
        x = rects[:, 0, None] + shares * (rects[:, 2] - rects[:, 0])[:, None]
        y = rects[:, 1, None] + shares * (rects[:, 3] - rects[:, 1])[:, None]
        if self.problem.scene.room.fills_bounds:
            x0, y0, x1, y1 = self.problem.scene.room.bounds
            return 1.0 - ((x > x0) & (x < x1)).mean(axis=1) * ((y > y0) & (y < y1)).mean(axis=1)
        points = np.broadcast_arrays(x[:, :, None], y[:, None, :])
        return 1.0 - shapely.contains_xy(self._floor, *points).reshape(len(rects), -1).mean(axis=1)

    def _strips(self, slots: ArrayLike, poses: Floats) -> Rects:
        """Return the bounds of the floor in front of slots (m,) at their poses."""
        index = np.asarray(slots, dtype=np.intp)
        hx, hy = self.problem.half[index].T
        middle = poses[:, :2] + (hx + self._depth / 2)[:, None] * poses[:, 2:]
        return _bounds(middle, poses[:, 2:], self._depth / 2, hy)


def _bounds(center: Floats, heading: Floats, hx: Floats | float, hy: Floats | float) -> Rects:
    """Return the bounds of rectangles with these middles and unit headings (m, 2) and half sizes (m,)."""
    c, s = np.abs(heading).T
    reach = np.empty(center.shape)
    reach[:, 0], reach[:, 1] = c * hx + s * hy, s * hx + c * hy
    return np.concatenate([center - reach, center + reach], axis=1)


def _shared(a: Rects, b: Rects) -> Floats:
    """Return the areas (m, n) that rectangles (m, 4) and (n, 4) share."""
    wide, long = (np.minimum(a[:, k + 2, None], b[:, k + 2]) - np.maximum(a[:, k, None], b[:, k]) for k in (0, 1))
    return np.maximum(wide, 0.0) * np.maximum(long, 0.0)


def _area(rects: Rects) -> Floats:
    return np.maximum((rects[:, 2] - rects[:, 0]) * (rects[:, 3] - rects[:, 1]), 1e-9)
