"""Repair: remove what is to blame and put it elsewhere.

Each round makes a batch of candidate layouts by discrete moves (reinsert one thing at a place drawn from its statements, swap
two, turn one, move a thing with everything that is bound to it), evaluates them as one batch and polishes the best few with
only the moved things free.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial

import numpy as np

from robolayout._geometry import compose
from robolayout.constraints import AssetRef, FrameTerm, MirrorTerm, WallRef
from robolayout.floor import Plan
from robolayout.solve.arrays import Routes
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.config import SolverConfig
from robolayout.solve.construct import Builder
from robolayout.solve.judge import Verdict
from robolayout.solve.proposals import carry, placing
from robolayout.solve.push import nearest
from robolayout.solve.routes import pack
from robolayout.solve.runner import BATCH, Runner
from robolayout.solve.score import Score
from robolayout.solve.stage import make_stage

WAYS = 4
"""Ways to place one thing anew: where there is room; where it wants to be, others making way; once what nothing holds is out;
together with what stands around it."""

PLACES = 24
"""Places of a thing about which others are taken out."""

RINGS = (0.1, 0.25, 0.45, 0.8, 1.4, 2.2)
"""Metres from where a thing was or should be at which it is tried."""

TURNING = 2
"""Of these, so many where it is also turned by quarters, if nothing says where it faces."""

SAME = 0.04
"""Metres, or parts of a unit heading vector, to which tries are rounded to find those that are there twice."""

ALIKE = 0.15
"""Metres, or parts of a unit heading, below which two poses are the same try."""

FEW = (3, 9)
"""How many of the things around one are placed anew with it: at least so many, fewer than so many."""


class Repair:
    """Makes better candidates of one problem's layouts.

    Args:
        problem: The problem.
        runner: Runs the compiled search.
        config: Constants.
        builder: Builds the room anew.
    """

    def __init__(self, problem: Problem, runner: Runner, config: SolverConfig, builder: Builder) -> None:
        self.problem = problem
        self.runner = runner
        self.config = config
        self.builder = builder
        self.rng = builder.rng
        self.proposals = builder.proposals
        self.groups = _groups(problem)

    def candidates(
        self, world: Floats, verdict: Verdict, round_number: int, plan_for: Callable[[Floats], Plan]
    ) -> list[Floats]:
        """Return polished candidates, most promising first.

        Args:
            world: (n, 4) the best layout so far.
            verdict: What the judge says of it.
            round_number: Later rounds move more.
            plan_for: Plans routes in a layout.
        """
        plan = plan_for(world)
        named = [self.problem.slot[name] for name in verdict.culprits if name in self.problem.slot]
        slots = [s for s in dict.fromkeys([*plan.blockers, *named]) if self.problem.names[s] not in self.problem.pinned]
        if not slots:
            return []
        number = min(self.problem.stage[s] for s in slots)
        slots = [s for s in slots if self.problem.stage[s] == number]
        stage = make_stage(self.problem, number, world)
        batch = np.repeat(world[None], self.config.candidates, axis=0)
        turned = self._turns(batch, slots)
        rebuilt = 1 + turned
        if number == 0:
            rebuilt = max(rebuilt, self.config.candidates // 2)
            colliding = set(named[: int(verdict.hard)]) & set(slots)
            for k in range(1 + turned, rebuilt):
                if k % 3 == 0:
                    self._eject(batch[k], self._pressing(slots))
                    continue
                ruined = self._ruined(slots, stage.moving, round_number)
                batch[k] = self.builder.build(world, ruined | colliding if k % 3 == 1 else ruined)
        for k in range(rebuilt, self.config.candidates):
            for _ in range(1 + (self.rng.random() < 0.15 * (1 + round_number))):
                self._move(batch[k], slots, stage.moving)
        size = 8 * stage.slots

        def same(part: slice) -> Routes:
            return pack([plan] * len(batch[part]), size)

        def own(part: slice) -> Routes:
            return pack([plan_for(one) for one in picked[part]], size)

        order = self.runner.evaluate(stage, batch, None if number else same).order()
        kept = min(self.config.kept, self.config.candidates)
        also = self.rng.choice(order[kept // 2 : 4 * kept], kept - kept // 2, replace=False)
        picked = batch[[*order[: kept // 2], *(int(k) for k in also)]]
        run = self.runner.advance(stage, picked, self.config.polish, "repair", routes=None if number else own)
        return [run.world[k] for k in run.order()]

    def near(self, world: Floats, slot: int, plan_for: Callable[[Floats], Plan]) -> Iterator[Floats]:
        """Yield layouts in which one thing is elsewhere, as near to its guess as can be, the others making way.

        Args:
            world: (n, 4) poses.
            slot: The thing; what is placed in its stage makes way.
            plan_for: Plans routes in a layout.
        """
        stage, plan = make_stage(self.problem, self.problem.stage[slot], world), plan_for(world)
        score, group = Score(stage, self.config.weights), frozenset(self.groups[slot])
        found = [self._elsewhere(score, world, slot, plan, along) for along in dict.fromkeys((frozenset[int](), group))]
        tries, costs = (np.concatenate(parts) for parts in zip(*found, strict=True))
        yield from tries
        picked = tries[_unlike(tries[:, slot], costs, [], BATCH)]
        routes = partial(self._open, picked, plan_for, 8 * stage.slots)
        yield from self.runner.advance(stage, picked, self.config.polish, "mend", routes=routes).ranked()

    def _elsewhere(
        self, score: Score, world: Floats, slot: int, plan: Plan, along: frozenset[int]
    ) -> tuple[Floats, Floats]:
        """Return the most promising layouts with a thing, and what goes along with it, elsewhere near its guess; and their costs."""
        free = not any(term.heading is not None or term.look is not None for term in self.proposals.rows(slot))
        turned = [_turned(world[[slot]], quarter) for quarter in (2, 1, 3) if free]
        poses = np.concatenate([*turned, self._around(slot, world)])
        there = np.array(self.problem.stage) <= self.problem.stage[slot]
        there[list(along)] = False
        cost, _ = score.hard(slot, poses, world, there)
        cost += score.statements(slot, poses, world, there) + score.routes(slot, poses, plan.demands)
        first = list(range(len(turned)))  # as it stands, only turned: a guess is sooner wrong in this than in its place
        chosen = _unlike(poses, cost, first, self.config.effort.looked_at)
        tries = np.repeat(world[None], len(chosen), axis=0)
        for one, pose in zip(tries, poses[chosen], strict=True):
            carry(self.problem, one, slot, pose, along)
        return tries, cost[chosen]

    def _open(self, worlds: Floats, plan_for: Callable[[Floats], Plan], size: int, part: slice) -> Routes:
        """Return what keeps ways open in some layouts."""
        return pack([plan_for(world) for world in worlds[part]], size)

    def _around(self, slot: int, world: Floats) -> Floats:
        """Return poses (m, 4) around the guess of a slot and around where it is: where its rows hold, its walls, or free."""
        rows = self.proposals.rows(slot)
        free = [_rings(self.problem.start[slot], RINGS), _rings(world[slot], RINGS[:TURNING])]
        walls, whole = np.concatenate(free), np.concatenate(free)
        for term in rows:
            walls = nearest(self.problem, term, slot, walls, world) if isinstance(term.b, WallRef) else walls
        for term in rows * 2:
            whole = nearest(self.problem, term, slot, whole, world)
        found = [whole, walls, *free]
        poses = np.concatenate(found)
        _, first = np.unique(np.round(poses / SAME), axis=0, return_index=True)
        return poses[np.sort(first)]

    def _ruined(self, slots: list[int], moving: tuple[int, ...], round_number: int) -> set[int]:
        """Return what to take out and place anew: one or two to blame and a few others, more of them in later rounds."""
        count = int(self.rng.integers(1, 3 + round_number))
        others = self.rng.choice(moving, min(count, len(moving)), replace=False).tolist()
        blamed = [self._pressing(slots) for _ in range(2)]
        return {*blamed, *others}

    def mended(self, world: Floats, slot: int, way: int) -> Floats:
        """Return a layout (n, 4) with one thing to blame placed anew, and what goes by it, in one of `WAYS`."""
        if way == 1:
            world = world.copy()
            self._eject(world, slot)
            return world
        moved = {slot} | self.groups[slot]
        if way == 2:
            moved |= self._loose_about(slot, world)
        if way == 3:
            moved |= self._near(slot, world)
        return self.builder.build(world, moved & set(self.builder.moving))

    def _eject(self, world: Floats, slot: int) -> None:
        """Put a thing, in place, where its statements want it, and what stands there or goes by it somewhere else."""
        carry(self.problem, world, slot, self.proposals.draw(slot, world, 1, self.rng)[0])
        there = self.builder.score.touched(slot, world[[slot]], world)
        moved = there | self.groups[slot].union(*(self.groups[other] for other in there))
        world[:] = self.builder.build(world, (moved & set(self.builder.moving)) - {slot})

    def _loose_about(self, slot: int, world: Floats) -> set[int]:
        """Return what no statement holds and what stands where those of a slot would have it."""
        rows = [term for term in self.proposals.frames.get(slot, []) if placing(term)]
        places = [self.proposals.placed(slot, term, world, PLACES, self.rng) for term in rows]
        there = self.builder.score.touched(slot, np.concatenate(places), world) if places else set[int]()
        return {other for other in there if other not in self.proposals.frames and not self.groups[other]}

    def _near(self, slot: int, world: Floats) -> set[int]:
        """Return the things that stand nearest to a slot, a few of them, with what goes by them."""
        moving = np.array(self.builder.moving)
        away = np.hypot(*(world[moving, :2] - world[slot, :2]).T)
        near = moving[np.argsort(away, kind="stable")[: int(self.rng.integers(*FEW))]].tolist()
        return set(near).union(*(self.groups[other] for other in near))

    def _pressing(self, slots: list[int]) -> int:
        """Draw one of the slots to blame, those named first far more often."""
        return slots[min(int(self.rng.exponential(1.5)), len(slots) - 1)]

    def _with(self, slot: int, whole: bool) -> frozenset[int]:
        """Return what moves along with a slot: everything bound to it, or nothing."""
        return frozenset(self.groups[slot]) if whole else frozenset()

    def _turns(self, batch: Floats, slots: list[int]) -> int:
        """Turn each of the most pressing things by 90, 180 and 270 degrees, alone and with what is bound to it."""
        k = 0
        for slot in slots[: self.config.candidates // 16]:
            for quarter in (1, 2, 3):
                yaw = quarter * math.pi / 2
                for whole in (False, True):
                    k += 1
                    turn = np.array([0.0, 0.0, math.cos(yaw), math.sin(yaw)])
                    carry(self.problem, batch[k], slot, compose(batch[k, slot], turn), self._with(slot, whole))
        return k

    def _move(self, world: Floats, slots: list[int], moving: tuple[int, ...]) -> None:
        """Apply one random move in place."""
        slot = self._pressing(slots)
        chance = self.rng.random()
        before = world[slot].copy()
        if chance < 0.55:
            pose = self.proposals.draw(slot, world, 1, self.rng)[0]
            carry(self.problem, world, slot, pose, self._with(slot, self.rng.random() < 0.5))
            for term in self.proposals.mirrors.get(slot, []):
                if (twin := self.proposals.twin(term, slot)) in moving and self.rng.random() < 0.5:
                    carry(self.problem, world, twin, self.proposals.image(term, twin, world))
        elif chance < 0.7:
            other = moving[int(self.rng.integers(len(moving)))]
            carry(self.problem, world, slot, world[other].copy())
            carry(self.problem, world, other, before)
        elif chance < 0.85:
            yaw = math.pi / 2 * int(self.rng.integers(1, 4))
            turned = compose(before, np.array([0.0, 0.0, math.cos(yaw), math.sin(yaw)]))
            carry(self.problem, world, slot, turned, self._with(slot, self.rng.random() < 0.5))
        else:
            shifted = before.copy()
            shifted[:2] += self.rng.normal(0.0, 0.4, 2)
            carry(self.problem, world, slot, shifted, self._with(slot, True))


def _rings(pose: Floats, radii: Sequence[float]) -> Floats:
    """Return a pose (4,) and the same shifted to eight places on each ring around it (m, 4)."""
    around = np.arange(8) * (math.pi / 4)
    steps = np.concatenate([[(0.0, 0.0)], *(np.column_stack([r * np.cos(around), r * np.sin(around)]) for r in radii)])
    return compose(pose, np.column_stack([steps, np.ones(len(steps)), np.zeros(len(steps))]))


def _unlike(poses: Floats, cost: Floats, first: Sequence[int], most: int) -> list[int]:
    """Return which of some poses (m, 4) to try: the first ones, and so many of the cheapest that are not the same try."""
    chosen = list(first)
    for k in np.argsort(cost, kind="stable").tolist():
        if len(chosen) == len(first) + most:
            break
        if not chosen or np.abs(poses[chosen] - poses[k]).max(axis=1).min() > ALIKE:
            chosen.append(k)
    return chosen


def _turned(poses: Floats, quarter: int) -> Floats:
    """Return poses (m, 4) turned in place by quarters of a full turn."""
    c, s = round(math.cos(quarter * math.pi / 2)), round(math.sin(quarter * math.pi / 2))
    return compose(poses, np.array([0.0, 0.0, c, s]))


def _groups(problem: Problem) -> list[set[int]]:
    """Return for each slot the slots whose statements are about it (a chair for its table), and theirs in turn."""
    followers: list[set[int]] = [set() for _ in problem.names]
    for terms in problem.statement_terms:
        for term in terms:
            if isinstance(term, FrameTerm) and isinstance(term.a, AssetRef) and isinstance(term.b, AssetRef):
                followers[problem.slot[term.b.name]].add(problem.slot[term.a.name])
            elif isinstance(term, MirrorTerm) and isinstance(term.ref, AssetRef):
                followers[problem.slot[term.ref.name]] |= {
                    problem.slot[ref.name] for ref in (term.a, term.b) if isinstance(ref, AssetRef)
                }
    for slot, direct in enumerate(followers):
        for other in sorted(direct):
            direct |= followers[other]
        direct.discard(slot)
    return followers
