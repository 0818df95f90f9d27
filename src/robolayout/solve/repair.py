"""Repair: what is to blame goes elsewhere, near its guess while that is worth anything, else where its statements want it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from robolayout._geometry import compose
from robolayout.constraints import WallRef
from robolayout.floor import RoutePlan
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.config import SolverConfig
from robolayout.solve.construct import Builder
from robolayout.solve.proposals import carry, placing
from robolayout.solve.push import nearest
from robolayout.solve.runner import BATCH, Runner
from robolayout.solve.score import Score
from robolayout.solve.stage import Stage, on_top, relative


@dataclass(frozen=True)
class Mending:
    """Where a thing to blame is tried."""

    ways: int = 4
    """Ways to place one thing anew: where there is room; where it wants to be, others making way; once what nothing holds is
    out; together with what stands around it."""
    places: int = 24  # places of a thing about which others are taken out
    rings: tuple[float, float, float, float, float, float] = (0.1, 0.25, 0.45, 0.8, 1.4, 2.2)
    """Metres from where a thing was or should be at which it is tried."""
    turning: int = 2  # of these, so many where it is also turned by quarters, if nothing says where it faces
    on_a_top: int = 5  # places along each side of a top at which what stands there is tried, as it looks and across
    same: float = 0.04
    """Metres, or parts of a unit heading vector, to which tries are rounded to find those that are there twice."""
    alike: float = 0.15  # metres, or parts of a unit heading, below which two poses are the same try
    few: tuple[int, int] = (3, 9)
    """How many of the things around one are placed anew with it: at least so many, fewer than so many."""


MENDING = Mending()

QUARTERS = np.array([(0.0, 0.0, -1.0, 0.0), (0.0, 0.0, 0.0, 1.0), (0.0, 0.0, 0.0, -1.0)])
"""Turns in place by half, a quarter, and three quarters."""


class Repair:
    """Makes better candidates of one problem's layouts."""

    def __init__(self, stages: Sequence[Stage], runner: Runner, config: SolverConfig, rng: np.random.Generator) -> None:
        self.stages, self.problem, self.runner, self.config, self.rng = stages, stages[0].problem, runner, config, rng
        self.builder = Builder(stages[0], rng, config.weights)
        self.proposals = self.builder.proposals
        self.groups = self.proposals.followers

    def near(self, world: Floats, slot: int, plan_for: Callable[[Floats], RoutePlan]) -> Iterator[Floats]:
        """Yield layouts in which one thing is elsewhere, as near to its guess as can be, the others of its stage making way."""
        stage, plan = self.stages[self.problem.stage[slot]].at(world), plan_for(world)
        score, group = Score(stage, self.config.weights), frozenset(self.groups[slot])
        found = [self._elsewhere(score, world, slot, plan, along) for along in dict.fromkeys((frozenset[int](), group))]
        tries, costs = (np.concatenate(parts) for parts in zip(*found, strict=True))
        yield from tries
        picked = tries[_unlike(tries[:, slot], costs, 0, BATCH)]
        run = self.runner.advance(stage, picked, self.config.polish, "mend", plans=[*map(plan_for, picked)])
        yield from run.ranked()

    def _elsewhere(
        self, score: Score, world: Floats, slot: int, plan: RoutePlan, along: frozenset[int]
    ) -> tuple[Floats, Floats]:
        """Return the most promising layouts with a thing, and what goes along with it, elsewhere near its guess; and their costs."""
        free = not any(term.heading is not None or term.look is not None for term in self.proposals.rows(slot))
        turned = compose(world[slot], QUARTERS[: 3 * free])
        poses = np.concatenate([turned, self._around(slot, world)])
        there = np.array(self.problem.stage) <= self.problem.stage[slot]
        there[list(along)] = False
        cost, _ = score.hard(slot, poses, world, there)
        cost += score.statements(slot, poses, world, there) + score.routes(slot, poses, plan.demands)
        # first as it stands, only turned: a guess is sooner wrong in this than in its place
        chosen = _unlike(poses, cost, len(turned), self.config.effort.looked_at)
        tries = np.repeat(world[None], len(chosen), axis=0)
        for one, pose in zip(tries, poses[chosen], strict=True):
            carry(self.problem, one, slot, pose, along)
        return tries, cost[chosen]

    def _around(self, slot: int, world: Floats) -> Floats:
        """Return poses (m, 4) around the guess of a slot, if it has one, and where it is: where its rows hold, its walls, or free."""
        rows = self.proposals.rows(slot)
        middle = self.problem.start if self.problem.names[slot] in self.problem.guessed else world
        free = [_rings(middle[slot], MENDING.rings), _rings(world[slot], MENDING.rings[: MENDING.turning])]
        walls, whole = np.concatenate(free), np.concatenate(free)
        for term in rows:
            walls = nearest(self.problem, term, slot, walls, world) if isinstance(term.b, WallRef) else walls
        for term in rows * 2:
            whole = nearest(self.problem, term, slot, whole, world)
        poses = np.concatenate([whole, walls, *free])
        if self.problem.parent[slot] >= 0:
            poses = _on_its_top(self.problem, slot, poses, world)
        _, first = np.unique(np.round(poses / MENDING.same), axis=0, return_index=True)
        return poses[np.sort(first)]

    def mended(self, world: Floats, slot: int, way: int) -> Floats:
        """Return a layout (n, 4) with one thing to blame placed anew, and what goes by it, in one of `MENDING.ways`."""
        if way == 1:
            return self._ejected(world, slot)
        moved = {slot} | self.groups[slot]
        if way == 2:
            moved |= self._loose_about(slot, world)
        if way == 3:
            moved |= self._near(slot, world)
        return self.builder.build(world, moved & set(self.builder.moving))

    def _ejected(self, world: Floats, slot: int) -> Floats:
        """Return a layout with a thing where its statements want it, and what stands there or goes by it somewhere else."""
        world = world.copy()
        carry(self.problem, world, slot, self.proposals.draw(slot, world, 1, self.rng)[0])
        there = self.builder.score.touched(slot, world[[slot]], world)
        moved = there | self.groups[slot].union(*(self.groups[other] for other in there))
        return self.builder.build(world, (moved & set(self.builder.moving)) - {slot})

    def _loose_about(self, slot: int, world: Floats) -> set[int]:
        """Return what no statement holds and what stands where those of a slot would have it."""
        rows = [term for term in self.proposals.frames.get(slot, []) if placing(term)]
        places = [self.proposals.placed(slot, term, world, MENDING.places, self.rng) for term in rows]
        there = self.builder.score.touched(slot, np.concatenate(places), world) if places else set[int]()
        return {other for other in there if other not in self.proposals.frames and not self.groups[other]}

    def _near(self, slot: int, world: Floats) -> set[int]:
        """Return the things that stand nearest to a slot, a few of them, with what goes by them."""
        moving = np.array(self.builder.moving)
        away = np.hypot(*(world[moving, :2] - world[slot, :2]).T)
        near = moving[np.argsort(away, kind="stable")[: int(self.rng.integers(*MENDING.few))]].tolist()
        return set(near).union(*(self.groups[other] for other in near))


def _on_its_top(problem: Problem, slot: int, poses: Floats, world: Floats) -> Floats:
    """Return some poses of a slot (m, 4), those beside what carries it at the nearest place on it, and such all over that top."""
    middle, half = on_top(problem, slot, world[problem.parent[slot]])
    spread = np.linspace(-1.0, 1.0, MENDING.on_a_top)
    at = np.array([(x * half[0], y * half[1]) for x in spread for y in spread])
    here = relative(middle, world[[slot]])[0, 2:]
    ways = [np.column_stack([at, np.tile(way, (len(at), 1))]) for way in (here, (-here[1], here[0]))]
    local = np.concatenate([relative(middle, poses), *ways])
    hx, hy = problem.half[slot]
    c, s = np.abs(local[:, 2:]).T
    slack = np.maximum(half - np.column_stack([c * hx + s * hy, s * hx + c * hy]), 0.0)
    beside = (np.abs(local[:, :2]) > half).any(axis=1) | (np.arange(len(local)) >= len(poses))
    local[beside, :2] = np.clip(local[beside, :2], -slack[beside], slack[beside])
    return compose(middle, local)


def _rings(pose: Floats, radii: Sequence[float]) -> Floats:
    """Return a pose (4,) and the same shifted to eight places on each ring around it (m, 4)."""
    around = np.arange(8) * (math.pi / 4)
    steps = np.concatenate([[(0.0, 0.0)], *(np.column_stack([r * np.cos(around), r * np.sin(around)]) for r in radii)])
    return compose(pose, np.column_stack([steps, np.ones(len(steps)), np.zeros(len(steps))]))


def _unlike(poses: Floats, cost: Floats, first: int, most: int) -> list[int]:
    """Return which of some poses (m, 4) to try: the first ones, and so many of the cheapest that are not the same try."""
    chosen = list(range(first))
    for k in np.argsort(cost, kind="stable").tolist():
        if len(chosen) == first + most:
            break
        if not chosen or np.abs(poses[chosen] - poses[k]).max(axis=1).min() > MENDING.alike:
            chosen.append(k)
    return chosen
