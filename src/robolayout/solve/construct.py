"""Starts built one thing after the other: each at the best of many places drawn from its statements.

A start drawn blindly leaves the gradient search in a knot of things that block one another. Here each thing takes the place
where it overlaps nothing, keeps to its statements, and leaves to the others what they need: the floor in front of them, room
to open, room for what goes by them, and a way from the door to all of them.
"""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robolayout._geometry import compose
from robolayout.constraints import AssetRef, WallRef
from robolayout.floor import FLOOR, Blocks, Walked
from robolayout.solve._zones import Rects, Zones
from robolayout.solve.compile import Floats
from robolayout.solve.config import Weights
from robolayout.solve.proposals import Proposals, carry, placing
from robolayout.solve.push import nearest
from robolayout.solve.score import Score
from robolayout.solve.stage import Stage


@dataclass(frozen=True)
class Building:
    """How places are looked for and weighed where a room is built."""

    candidates: int = 64
    put: int = 32
    """Places looked at for each thing, and how many of them are put where all of its statements hold."""
    looks: int = 4
    again: int = 1
    """Most times that it looks at so many, and in a room in which only some things are placed anew."""
    good: float = 1.0  # cost of a place at which it looks no further
    closest: float = 0.02  # metres between a thing and the wall behind it
    broken: float = 100.0
    said: float = 4.0
    """Cost of each hard demand that is not met: no statement outweighs it; and factor on the statements against the floor."""
    away: float = 0.02
    tight: float = 0.1
    """Cost of a metre from where it was, and of a metre left empty beside a thing at a wall."""
    cramped: float = 4.0  # cost of a place that leaves no room to what goes by it
    walked: float = 1.0  # cost of taking only floor that people could walk on until then
    needs: int = 6  # places looked at for each thing that is yet to come and goes by the one that is placed
    grain: float = 0.002  # metres between things that stand side by side


BUILDING = Building()


@dataclass(frozen=True, eq=False)
class _Site:
    """A room while it is built."""

    settled: NDArray[np.bool_]  # (n,) which slots have their place
    bodies: Rects  # (n, 4) bounds of slots
    stands: Blocks  # (n, 4) cells of `walked` from which they are within reach
    walked: Walked  # the floor that is left to walk on


class Builder:
    """Builds starts for the things of the first stage of a problem.

    Args:
        stage: The first stage of the problem.
        rng: Source of randomness.
        weights: Factors of the terms of the objective.
    """

    def __init__(self, stage: Stage, rng: np.random.Generator, weights: Weights | None = None) -> None:
        problem = stage.problem
        self.problem, self.moving, self.rng = problem, problem.movable(0), rng
        self.score = Score(stage, weights or Weights())
        self.proposals = Proposals(problem)
        widest = max(problem.scene.agents, key=lambda agent: agent.radius)
        self.zones = Zones(problem, widest)
        self._walked = Walked(problem.scene.room, min(widest.radius, 0.5))
        self._needs = self._followers()
        every = range(len(problem.names))
        self._free = [not self.proposals.frames.get(slot) for slot in every]
        self._pushed = [slot not in self._needs and self._at_wall(slot) for slot in every]

    def build(self, world: Floats, slots: Collection[int] | None = None) -> Floats:
        """Return one start (n, 4) with some slots placed anew, all that move by default; the others stay as in `world`."""
        slots = self.moving if slots is None else slots
        looks = BUILDING.looks if len(slots) == len(self.moving) else BUILDING.again
        world = world.copy()
        size = self.problem.half.prod(axis=1) * self.rng.uniform(0.7, 1.4, len(world))
        site = self._site(world, slots)
        for slot in self._in_turn(sorted(slots, key=lambda s: (self.proposals.ranks[s], self._free[s], -size[s], s))):
            carry(self.problem, world, slot, self._place(slot, world, site, looks))
            site.settled[slot] = True
        return world

    def _at_wall(self, slot: int) -> bool:
        """Return whether a slot belongs at a wall, by its statements or because nothing says where it goes."""
        if self._free[slot]:
            return bool(self.zones.fronts[slot])
        return any(isinstance(term.b, WallRef) for term in self.proposals.frames[slot])

    def _in_turn(self, slots: list[int]) -> list[int]:
        """Return slots, what goes by others right after these, before its place is gone."""
        left, found = dict.fromkeys(slots), list[int]()

        def take(slot: int) -> None:
            del left[slot]
            found.append(slot)
            for other in [one for one in left if slot in self.proposals.leaders[one]]:
                if other in left and not self.proposals.leaders[other] & left.keys():
                    take(other)

        for slot in slots:
            if slot in left:
                take(slot)
        return found

    def _site(self, world: Floats, slots: Collection[int]) -> _Site:
        """Return the room before slots are placed: what stands on the floor, at walls and at the ceiling beside them."""
        settled = np.array([parent < 0 for parent in self.problem.parent])
        settled[list(slots)] = False
        walked, every = self._walked.copy(), np.arange(len(world))
        bodies = self.zones.bodies(every, world)
        walked.take(walked.taken(bodies[settled & self.zones.blocks]))
        return _Site(settled, bodies, walked.cells(self.zones.stands(every, world)), walked)

    def _place(self, slot: int, world: Floats, site: _Site, looks: int) -> Floats:
        """Return the best of many places of a slot, and take the floor that it needs; where all are bad, look again."""
        best, least = world[slot], math.inf
        for _ in range(looks):
            places, gaps = self._places(slot, world, site)
            bodies = self.zones.bodies(slot, places)
            cost = self._cost(slot, places, world, site) + BUILDING.tight * gaps
            blocks = self.zones.blocks[slot]
            k = self._cheapest(slot, places, bodies, cost, site, least) if blocks else int(cost.argmin())
            if cost[k] < least:
                best, least = places[k], float(cost[k])
                site.bodies[slot] = bodies[k]
            if least < BUILDING.good:
                break
        site.stands[slot] = site.walked.cells(self.zones.stands([slot], best[None]))[0]
        if self.zones.blocks[slot]:
            site.walked.take(site.walked.taken(site.bodies[[slot]]))
        return best

    def _cheapest(self, slot: int, places: Floats, bodies: Rects, cost: Floats, site: _Site, limit: float) -> int:
        """Return the cheapest place (m, 4) of a slot by what it does to those who walk, too, which `cost` then tells."""
        walked, cells = site.walked, site.walked.taken(bodies)
        own = walked.cells(self.zones.stands(slot, places))
        cost += BUILDING.walked * walked.share(cells) + FLOOR.lost * (walked.left(own, cells) == 0)
        return walked.cheapest(cells, cost, site.stands[site.settled], limit)

    def _followers(self) -> dict[int, list[tuple[int, Floats]]]:
        """Return for each slot what goes by it, and a few places (m, 4) of that in the slot's frame."""
        needs: dict[int, list[tuple[int, Floats]]] = {}
        origin = np.tile((0.0, 0.0, 1.0, 0.0), (len(self.problem.names), 1))
        for slot, terms in self.proposals.frames.items():
            for term in terms:
                if self.problem.parent[slot] >= 0 or not isinstance(term.b, AssetRef) or not placing(term):
                    continue
                places = self.proposals.placed(slot, term, origin, BUILDING.needs, self.rng)
                needs.setdefault(self.problem.slot[term.b.name], []).append((slot, places))
                for mirror in self.proposals.mirrors.get(slot, []):
                    if mirror.ref == term.b:
                        image = (self.proposals.twin(mirror, slot), places * (1.0, -1.0, 1.0, -1.0))
                        needs[self.problem.slot[term.b.name]].append(image)
        return needs

    def _cramped(self, slot: int, places: Floats, world: Floats, site: _Site) -> Floats:
        """Return how little room each place (m, 4) of a slot leaves to what goes by it."""
        cost = np.zeros(len(places))
        for other, around in self._needs.get(slot, []):
            if not site.settled[other]:
                there = compose(places[:, None], around).reshape(-1, 4)
                cost_there, broken = self.score.hard(other, there, world, site.settled)
                each = (cost_there + broken).reshape(len(places), -1)
                cost += np.minimum(np.partition(each, 1, axis=1)[:, 1], 1.0)  # one place alone may fit by a hair
        return cost

    def _places(self, slot: int, world: Floats, site: _Site) -> tuple[Floats, Floats | float]:
        """Return places (m, 4) and the metres (m,) left empty beside them at walls.

        They are drawn from the slot's statements, half of them then put where all of these hold, and along the walls if nothing
        says where it goes.
        """
        places = self.proposals.draw(slot, world, BUILDING.candidates, self.rng)
        for term in self.proposals.rows(slot) * 2:
            if not isinstance(term.b, AssetRef) or site.settled[self.problem.slot[term.b.name]]:
                places[: BUILDING.put] = nearest(self.problem, term, slot, places[: BUILDING.put], world)
        if self._free[slot] and self.zones.fronts[slot]:
            places = np.concatenate([places[: BUILDING.candidates // 4], self._along_walls(slot, BUILDING.candidates)])
        return self._push(slot, places, site) if self._pushed[slot] else (places, 0.0)

    def _push(self, slot: int, places: Floats, site: _Site) -> tuple[Floats, Floats]:
        """Return places (m, 4), every second one pushed sideways to what is next there, and metres (m,) left beside them."""
        rows = np.arange(len(places))
        side = (np.abs(places[:, 2]) >= np.abs(places[:, 3])).astype(np.intp)  # the axis to push along: x or y
        bodies = self.zones.bodies(slot, places)
        low, high = bodies[rows, side, None], bodies[rows, side + 2, None]
        others = np.concatenate([self.zones.landings, site.bodies[site.settled & self.zones.level(slot)]]).T
        meets = (others[1 - side] < bodies[rows, 3 - side, None] - BUILDING.grain) & (
            others[3 - side] > bodies[rows, 1 - side, None] + BUILDING.grain
        )
        before = others[side] + others[side + 2] < low + high
        x0, y0, x1, y1 = self.problem.scene.room.bounds
        left = np.where(meets & before, others[side + 2], -np.inf).max(axis=1, initial=-np.inf)
        right = np.where(meets & ~before, others[side], np.inf).min(axis=1, initial=np.inf)
        left = low[:, 0] - np.maximum(left, np.array((x0, y0))[side])
        right = np.minimum(right, np.array((x1, y1))[side]) - high[:, 0]
        push = np.where(left < right, BUILDING.grain - left, right - BUILDING.grain)
        push[(rows % 2 == 0) | (left + right < 2 * BUILDING.grain)] = 0.0
        places[rows, side] += push
        return places, np.clip(np.minimum(left + push, right - push), 0.0, 1.0)

    def _along_walls(self, slot: int, count: int) -> Floats:
        """Return places with the back to a wall."""
        hx, hy = self.problem.half[slot]
        walls = [wall for wall in self.problem.scene.room.walls if wall.length >= 2 * hy]
        if not walls:
            return np.empty((0, 4))
        lengths = np.array([wall.length for wall in walls])
        which = self.rng.choice(len(walls), count, p=lengths / lengths.sum())
        along = hy + self.rng.random(count) * (lengths[which] - 2 * hy)
        along = np.where(self.rng.random(count) < 0.3, hy + BUILDING.closest, along)
        lines = np.array([(wall.start, wall.direction, wall.normal) for wall in walls])
        starts, ways, normals = lines[which].transpose(1, 0, 2)
        return np.concatenate([starts + along[:, None] * ways + (hx + BUILDING.closest) * normals, normals], axis=1)

    def _cost(self, slot: int, places: Floats, world: Floats, site: _Site) -> Floats:
        """Return what each place (m, 4) of a slot costs, given what is settled."""
        cost, broken = self.score.hard(slot, places, world, site.settled)
        missed = self.score.statements(slot, places, world, site.settled)
        cost = cost + BUILDING.broken * broken + BUILDING.said * missed + self.rng.random(len(places)) * 0.01
        cost += BUILDING.away * np.hypot(*(places[:, :2] - world[slot, :2]).T)
        least = broken == broken.min()  # what breaks more is not taken, however much room it leaves
        cost[least] += BUILDING.cramped * self._cramped(slot, places[least], world, site)
        return cost
