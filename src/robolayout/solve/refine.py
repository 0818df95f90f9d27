"""The whole solve: search, routes in the loop, repair, one stage of support after the other."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np

from robolayout.floor import Ground, Obstacles, Plan, make_ground, obstacles_of, plan_routes
from robolayout.scene import Layout, Trace
from robolayout.solve.arrays import Routes
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.config import SolverConfig
from robolayout.solve.construct import Builder
from robolayout.solve.judge import Judge, Verdict
from robolayout.solve.repair import WAYS, Repair
from robolayout.solve.restore import restored
from robolayout.solve.routes import pack
from robolayout.solve.runner import STILL, Run, Runner
from robolayout.solve.snap import snapped
from robolayout.solve.solution import Progress, Solution, conclude, silent
from robolayout.solve.stage import Stage, make_stage, stages
from robolayout.solve.starts import Starts

ROUTE_PATIENCE = 2
"""Rounds of routes without success after which repair has its turn."""

FULL = 0.5
"""Share of the floor above which packing comes before repair; below it, a few collisions are cheaper to repair."""

PACKINGS = 24
"""Orders in which a room is packed before it is given up as too full."""

BLIND = 0.25
"""Share of the assets out of place or out of reach in a guess from which on it is not worth going back to."""

CLOSE, URGENT = 0.4, 0.5
"""Share of the floor, and assets in wrong places or out of reach, from which on repair goes on for longer without success."""

STUBBORN = 2
"""How many times longer."""

BUILT = 2
"""Batches of starts that are built one thing after the other."""

NEARLY = 3.0
"""Promise of a built start up to which single things in it are placed anew before it is polished."""

MENDINGS = 32
"""Most layouts with one thing placed anew that are judged in a row; fewer in rounds of repair after fruitless ones."""


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
        self.lead: _Best | None = None
        self.astray = 0.0

    def solve(self) -> Solution:
        """Return the best layout found."""
        if not self.problem.names:
            return conclude(Layout({}), Verdict(0.0, 0.0, 0.0), Trace())
        world = self.problem.start.copy()
        best: _Best | None = None
        for number in stages(self.problem):
            best = self._stage(number, world)
            world = best.world
        assert best is not None
        best = self._snap(self._restored(self._repair(self._snap(best))))
        trace = self.runner.trace(self.problem) if self.config.trace else Trace()
        return conclude(self.problem.layout(best.world), best.verdict, trace)

    @cached_property
    def builder(self) -> Builder:
        """Builds rooms anew."""
        return Builder(self.problem, self.rng)

    @cached_property
    def repairer(self) -> Repair:
        """Makes better candidates."""
        return Repair(self.problem, self.runner, self.config, self.builder)

    @cached_property
    def grounds(self) -> list[tuple[Ground, Obstacles]]:
        """The grids on which routes are planned, one for each agent, widest first."""
        bodies, held = sorted(self.problem.scene.agents, key=lambda agent: -agent.radius), self.problem.contents
        return [(make_ground(held, a, self.config.cell), obstacles_of(held, a)) for a in bodies]

    def _judged(self, world: Floats, number: int, best: _Best | None = None) -> _Best:
        """Judge a layout of everything placed up to a stage, as far as it may be better than what is best so far."""
        layout = self.problem.layout(world)
        placed = {
            name: layout[name]
            for name, stage in zip(self.problem.names, self.problem.stage, strict=True)
            if stage <= number
        }

        def enough(verdict: Verdict) -> bool:
            if best is None or verdict.merit < best.verdict.merit:
                return False
            return self.lead is None or verdict.promise >= self.lead.verdict.promise

        found = _Best(world, self.judge(Layout(placed), enough))
        if self.lead is None or found.verdict.promise < self.lead.verdict.promise:
            self.lead = found
        return found

    def _stage(self, number: int, world: Floats) -> _Best:
        """Place what belongs to a stage."""
        self.progress("search")
        self.lead = None
        stage = make_stage(self.problem, number, world)
        if not stage.moving:
            return self._judged(world, number)
        best, run = self._started(stage, number)
        if number == 0 and best.verdict.hard and self.config.repair_rounds and self._fill() > FULL:
            best = self._pack(best)
        if number == 0 and self.config.route_rounds and best.verdict.access:
            best = self._route(stage, run, best)
        return best

    def _started(self, stage: Stage, number: int) -> tuple[_Best, Run]:
        """Return the guess, or else the best that polishing it and, where that is not perfect, other starts lead to."""
        best = self._judged(stage.world, number)
        self.astray = max(self.astray, best.verdict.hard + best.verdict.access)
        if best.verdict.ok:
            return best, self._still(stage, best, "guess")
        starts = Starts(self.problem, stage.world, stage.moving, self.builder)
        quarter, several = max(self.config.starts // 4, 1), self.config.starts > 1
        blind = number == 0 and several and self._blind
        run: Run | None = None
        if not blind:
            run = self.runner.advance(stage, starts.near(quarter), self.config.polish, "polish")
            best = self._best_of(run.ranked(), number, best)
        if number == 0:
            best = best if blind else self._mended(best, number)
            best, run = self._built(stage, starts, quarter if several else 0, best, run)
        assert run is not None
        if several and not blind and not best.verdict.ok:
            phase = self.config.tops if number else self.config.search
            far = starts.far(quarter * (3 if number else 1))
            more = self.runner.advance(stage, far, phase, "search", rng=self.rng)
            more = self.runner.advance(stage, more.world, self.config.polish, "polish")
            best, run = self._with(more, number, best, run)
        return best, run

    def _built(
        self, stage: Stage, starts: Starts, count: int, best: _Best, run: Run | None
    ) -> tuple[_Best, Run | None]:
        """Return the best after so many starts of each batch are built and polished, and single things mended."""
        for _ in range(BUILT if count else 0):
            if best.verdict.ok:
                break
            made = list[Floats]()
            while len(made) < count and not best.verdict.ok:
                made.append(starts.built())
                best = self._best_of(made[-1:], 0, best)
            best = self._mended(best, 0) if best.verdict.promise <= NEARLY else best
            if best.verdict.ok:
                return best, self._still(stage, best, "built")
            worlds = np.array(made)
            routes = partial(self._open, stage, worlds) if self.config.route_rounds else None
            more = self.runner.advance(stage, worlds, self.config.polish, "polish", routes=routes)
            best, run = self._with(more, 0, best, run)
            best = self._mended(best, 0)
        return best, run

    def _still(self, stage: Stage, best: _Best, label: str) -> Run:
        """Return a layout as a run in which nothing moves; it is only run where a record is asked for."""
        still = Run(best.world[None], np.zeros(1), np.zeros(1))
        return self.runner.advance(stage, still.world, STILL, label) if self.config.trace else still

    def _with(self, more: Run, number: int, best: _Best, run: Run | None) -> tuple[_Best, Run]:
        """Return the best layout with what another run found, and the best starts of both runs."""
        return self._best_of(more.ranked(), number, best), run.joined(more).best(self.config.kept) if run else more

    @property
    def _blind(self) -> bool:
        """Whether the program had no idea where things go."""
        return self.astray > BLIND * len(self.problem.names)

    def _open(self, stage: Stage, worlds: Floats, part: slice) -> Routes:
        """Return what keeps ways to everything open in some layouts."""
        plans = [self._planned(one, [], everywhere=True) for one in worlds[part]]
        return pack(plans, 8 * stage.slots)

    def _fill(self) -> float:
        """Return the share of the floor that things standing on it take."""
        standing = [i for i, a in enumerate(self.problem.scene.assets) if self.problem.parent[i] < 0 and not a.is_flat]
        return float(4 * self.problem.half[standing].prod(axis=1).sum()) / self.problem.scene.room.area

    def _pack(self, best: _Best) -> _Best:
        """Fill the room from a corner, in several orders, where nothing else has found a place for everything."""
        for _ in range(PACKINGS):
            if not best.verdict.hard:
                break
            found = self._judged(self.builder.pack(best.world), 0, best)
            if found.verdict.merit < best.verdict.merit:
                best = found
        return best

    def _best_of(self, worlds: Iterable[Floats], number: int, best: _Best | None) -> _Best:
        """Return the best of some layouts and of what was best before, by the judge; nobody looks past a perfect one."""
        for world in worlds:
            if best and best.verdict.ok:
                break
            found = self._judged(world, number, best)
            if best is None or found.verdict.merit < best.verdict.merit:
                best = found
        assert best is not None
        return best

    def _route(self, stage: Stage, run: Run, best: _Best) -> _Best:
        """Push furniture out of the agents' routes, replanning as it moves."""
        world = run.world
        kept: list[list[Floats]] = [[] for _ in run.world]
        fruitless = 0
        for _ in range(self.config.route_rounds):
            if not (best.verdict.hard or best.verdict.access) or fruitless == ROUTE_PATIENCE:
                break
            before = self._standing(best)
            self.progress("routes")
            blocked: list[int] = []

            def routes(part: slice, now: Floats = world, blocked: list[int] = blocked) -> Routes:
                plans = [self._planned(one, before) for one, before in zip(now[part], kept[part], strict=True)]
                blocked += [plan.blocked for plan in plans]
                return pack(plans, 8 * stage.slots)

            run = self.runner.advance(stage, world, self.config.reroute, "routes", routes=routes)
            world = run.world
            if not any(blocked):
                break
            best = self._best_of(run.ranked()[: self.config.judged], 0, best)
            fruitless = fruitless + 1 if self._standing(best) == before else 0
        return best

    def _standing(self, best: _Best) -> tuple[float, float]:
        """Return how good the best layout is, and the one to go on from."""
        return best.verdict.merit, self.lead.verdict.promise if self.lead else math.inf

    def _plan(self, world: Floats) -> Plan:
        return self._planned(world, [])

    def _planned(self, world: Floats, kept: list[Floats], *, everywhere: bool = False) -> Plan:
        """Plan for every agent; demands of the two rounds before stay, so that furniture does not swing back."""
        plans = [plan_routes(ground, world, things, everywhere=everywhere) for ground, things in self.grounds]
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
            world = snapped(self.problem, best.world, frozenset({name}))
            if np.array_equal(world, best.world):
                continue
            found = self._judged(world, last, best)
            if found.verdict.merit < best.verdict.merit:
                best = found
        return best

    def _restored(self, best: _Best) -> _Best:
        """Put back where the program had it what was moved without need, unless the program had no idea."""
        if self._blind:
            return best

        def no_worse(world: Floats) -> bool:
            nonlocal best
            layout = self.problem.layout(world)
            verdict = self.judge(layout, lambda found: found.merit > best.verdict.merit)
            if verdict.merit > best.verdict.merit:
                return False
            best = _Best(world, verdict)
            return True

        restored(self.problem, best.world, no_worse)
        return best

    def _mended(self, best: _Best, number: int, most: int = MENDINGS) -> _Best:
        """Place single things to blame anew while all else stays, in turn, as long as the judge likes that better."""
        turn = 0
        for _ in range(most if self.config.repair_rounds else 0):
            slots = [self.problem.slot[name] for name in best.verdict.culprits]
            slots = [slot for slot in slots if slot in self.builder.moving]
            if best.verdict.ok or not slots:
                break
            world = self.repairer.mended(best.world, slots[turn // WAYS % len(slots)], turn % WAYS)
            found = self._judged(world, number, best)
            turn += 1
            if found.verdict.merit < best.verdict.merit:
                best, turn = found, 0
        return best

    def _repair(self, best: _Best) -> _Best:
        """Remove and reinsert what is to blame, while that helps."""
        last = max(stages(self.problem))
        if last > 0 or self.lead is None:
            self.lead = best
        fruitless, close = 0, self._fill() > CLOSE
        for round_number in range(self.config.repair_rounds):
            urgent = close and best.verdict.hard + best.verdict.access >= URGENT
            if best.verdict.ok or fruitless == self.config.patience * (STUBBORN if urgent else 1):
                break
            before = self._standing(best)
            self.progress("repair")
            best = self._mended(best, last, MENDINGS // (1 + fruitless))
            if best.verdict.ok:
                break
            lead = self.lead or best
            made = self.repairer.candidates(lead.world, lead.verdict, round_number, self._plan)
            best = self._best_of(made[: self.config.judged], last, best)
            fruitless = fruitless + 1 if self._standing(best) == before else 0
        return best
