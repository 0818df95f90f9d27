"""The whole solve: search, routes in the loop, repair, one stage of support after the other."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from robolayout.scene import Agent, Layout, Trace
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.config import SolverConfig
from robolayout.solve.construct import Builder
from robolayout.solve.judge import Judge, Verdict
from robolayout.solve.repair import Repair
from robolayout.solve.routes import Ground, Obstacles, Plan, make_ground, obstacles_of, pack, plan_routes
from robolayout.solve.runner import Run, Runner
from robolayout.solve.snap import snapped
from robolayout.solve.solution import Progress, Solution, conclude, silent
from robolayout.solve.stage import Stage, make_stage, stages
from robolayout.solve.starts import make_starts

ROUTE_PATIENCE = 2
"""Rounds of routes without success after which repair has its turn."""


FULL = 0.5
"""Share of the floor above which packing comes before repair; below it, a few collisions are cheaper to repair."""

PACKINGS = 24
"""Orders in which a room is packed before it is given up as too full."""


@dataclass
class _Best:
    """The best world poses so far, by the judge."""

    world: Floats
    verdict: Verdict


class Solver:
    """Solves one problem with one configuration and seed.

    Args:
        problem: The problem.
        judge: The exact verifier, as an order on layouts.
        config: Constants.
        seed: Seed of all randomness.
        progress: Called with the name of each phase.
    """

    def __init__(
        self,
        problem: Problem,
        judge: Judge,
        config: SolverConfig | None = None,
        *,
        seed: int = 0,
        progress: Progress | None = None,
    ) -> None:
        self.problem = problem
        self.judge = judge
        self.config = config or SolverConfig()
        self.rng = np.random.default_rng(seed)
        self.progress = progress or silent
        self.runner = Runner(self.config)
        self.grounds: list[tuple[Ground, Obstacles]] = []

    def solve(self) -> Solution:
        """Return the best layout found."""
        if not self.problem.names:
            return conclude(Layout({}), Verdict(0.0, 0.0, 0.0), Trace())
        self._survey()
        world = self.problem.start.copy()
        best: _Best | None = None
        for number in stages(self.problem):
            best = self._stage(number, world)
            world = best.world
        assert best is not None
        best = self._snap(self._repair(self._snap(best)))
        trace = self.runner.trace(self.problem) if self.config.trace else Trace()
        return conclude(self.problem.layout(best.world), best.verdict, trace)

    def _survey(self) -> None:
        """Lay the grids on which routes are planned."""
        self.grounds = [
            (make_ground(self.problem, a, self.config.cell), obstacles_of(self.problem, a)) for a in self._bodies()
        ]

    def _bodies(self) -> tuple[Agent, ...]:
        """Return the agents to plan for, widest first."""
        return tuple(sorted(self.problem.scene.agents, key=lambda a: -a.radius))

    def _judged(self, world: Floats, number: int) -> _Best:
        """Judge a layout of everything placed up to a stage."""
        layout = self.problem.layout(world)
        placed = {
            name: layout[name]
            for name, stage in zip(self.problem.names, self.problem.stage, strict=True)
            if stage <= number
        }
        return _Best(world, self.judge(Layout(placed)))

    def _stage(self, number: int, world: Floats) -> _Best:
        """Place what belongs to a stage."""
        self.progress("search")
        stage = make_stage(self.problem, number, world)
        if not stage.moving:
            return self._judged(world, number)
        starts = make_starts(self.problem, world, stage.moving, self.config.starts, self.rng)
        near, far = starts[: self.config.kept], starts[self.config.kept :]
        run = self.runner.advance(stage, near, self.config.polish, "polish")
        best = self._best_of(run.ranked(), number, None)
        if len(far) and not best.verdict.ok:
            phase = self.config.tops if number else self.config.search
            more = self.runner.advance(stage, far, phase, "search", rng=self.rng)
            more = self.runner.advance(stage, more.world, self.config.polish, "polish")
            best, run = self._best_of(more.ranked(), number, best), run.joined(more).best(self.config.kept)
        if number == 0 and best.verdict.hard and self.config.repair_rounds and self._fill() > FULL:
            best = self._pack(stage, best)
        if number == 0 and self.config.route_rounds and best.verdict.access:
            best = self._route(stage, run, best)
        return best

    def _fill(self) -> float:
        """Return the share of the floor that things standing on it take."""
        standing = [i for i, a in enumerate(self.problem.scene.assets) if self.problem.parent[i] < 0 and not a.is_flat]
        return float(4 * self.problem.half[standing].prod(axis=1).sum()) / self.problem.scene.room.area

    def _pack(self, stage: Stage, best: _Best) -> _Best:
        """Fill the room from a corner, in several orders, where nothing else has found a place for everything."""
        builder = Builder(self.problem, stage.moving, self.rng)
        for _ in range(PACKINGS):
            if not best.verdict.hard:
                break
            found = self._judged(builder.pack(best.world), 0)
            if found.verdict.merit < best.verdict.merit:
                best = found
        return best

    def _best_of(self, worlds: Iterable[Floats], number: int, best: _Best | None) -> _Best:
        """Return the best of some layouts and of what was best before, by the judge; nobody looks past a perfect one."""
        for world in worlds:
            if best and best.verdict.ok:
                break
            found = self._judged(world, number)
            if best is None or found.verdict.merit < best.verdict.merit:
                best = found
        assert best is not None
        return best

    def _route(self, stage: Stage, run: Run, best: _Best) -> _Best:
        """Push furniture out of the agents' routes, replanning as it moves."""
        world, kept = run.world, [[] for _ in run.world]
        fruitless = 0
        for _ in range(self.config.route_rounds):
            if not (best.verdict.hard or best.verdict.access) or fruitless == ROUTE_PATIENCE:
                break
            before = best.verdict.merit
            self.progress("routes")
            plans = [self._planned(world[k], kept[k]) for k in range(len(world))]
            if not any(plan.blocked for plan in plans):
                break
            routes = pack(plans, 8 * stage.slots)
            run = self.runner.advance(stage, world, self.config.reroute, "routes", routes=routes)
            world = run.world
            best = self._best_of(run.ranked()[: self.config.judged], 0, best)
            fruitless = 0 if best.verdict.merit < before else fruitless + 1
        return best

    def _plan(self, world: Floats) -> Plan:
        return self._planned(world, [])

    def _planned(self, world: Floats, kept: list[Floats]) -> Plan:
        """Plan for every agent; demands of the two rounds before stay, so that furniture does not swing back."""
        plans = [plan_routes(self.problem, ground, world, things) for ground, things in self.grounds]
        demands = np.concatenate([plan.demands for plan in plans])
        kept.append(demands)
        del kept[:-3]
        blockers = tuple(dict.fromkeys(slot for plan in plans for slot in plan.blockers))
        return Plan(np.concatenate(kept), sum(plan.blocked for plan in plans), blockers)

    def _snap(self, best: _Best) -> _Best:
        """Put what is all but right exactly right: everything at once, else one culprit after the other."""
        last = max(stages(self.problem))
        found = self._judged(snapped(self.problem, best.world), last)
        if found.verdict.merit <= best.verdict.merit:
            return found
        for name in best.verdict.culprits:
            found = self._judged(snapped(self.problem, best.world, frozenset({name})), last)
            if found.verdict.merit < best.verdict.merit:
                best = found
        return best

    def _repair(self, best: _Best) -> _Best:
        """Remove and reinsert what is to blame, while that helps."""
        last = max(stages(self.problem))
        repair = Repair(self.problem, self.runner, self.config, self.rng)
        fruitless = 0
        for round_number in range(self.config.repair_rounds):
            if best.verdict.ok or fruitless == self.config.patience:
                break
            before = best.verdict.merit
            self.progress("repair")
            made = repair.candidates(best.world, best.verdict.culprits, round_number, self._plan)
            best = self._best_of(made[: self.config.judged], last, best)
            fruitless = 0 if best.verdict.merit < before else fruitless + 1
        return best
