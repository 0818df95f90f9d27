"""The whole solve: push, polish, routes in the loop, mend, and only then build; one stage of support after the other.

What was asked for is kept: the guess is judged as it is, pushed to where its own statements hold, polished by gradients, with
what a body needs as demands on the furniture in its way, and mended thing by thing, nearest first. A room is built anew only if
hard demands or access are still not met then, or if there was nothing to keep.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import KW_ONLY, dataclass, field, replace
from functools import cached_property, partial

import numpy as np
import shapely
from shapely import Polygon

from robolayout.floor import Ground, Plan, make_ground, plan_routes
from robolayout.scene import Layout
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.config import SolverConfig
from robolayout.solve.construct import Builder
from robolayout.solve.judge import Judge, Verdict
from robolayout.solve.push import pushed
from robolayout.solve.repair import MENDING, Repair
from robolayout.solve.restore import restored, squared
from robolayout.solve.runner import BATCH, STILL, Run, Runner
from robolayout.solve.solution import Progress, Solution, conclude, silent
from robolayout.solve.stage import Stage, make_stage, stages

NEAR = 0.4
"""Metres that a polished thing may be put where its statements hold exactly."""


@dataclass
class _Best:
    """The best world poses so far, by the judge, and what made them."""

    world: Floats
    verdict: Verdict
    phase: str = ""


@dataclass(eq=False)
class Solver:
    """Solves one problem with one configuration and seed."""

    problem: Problem
    judge: Judge  # the exact verifier, as an order on layouts
    config: SolverConfig = field(default_factory=SolverConfig)
    _: KW_ONLY
    seed: int = 0  # of all randomness
    progress: Progress = silent  # called with the name of each phase

    def __post_init__(self) -> None:
        self.effort, self.judgements, self.gained = self.config.effort, 0, 0
        self.rng = np.random.default_rng(self.seed)
        self.runner = Runner(self.config)
        self.phase = "guess" if self.problem.guessed else "built"
        self.blind = False

    def solve(self) -> Solution:
        """Return the best layout found."""
        best = self._stage(self.stages[0])
        for stage in self.stages[1:]:
            self.phase = best.phase
            best = self._stage(stage.at(best.world))
        self.phase = best.phase
        if best.verdict.broken:
            best = self._repair(best)
        best = self._restored(best)
        return conclude(self.problem.layout(best.world), best.verdict, self.runner.trace(self.problem), best.phase)

    @property
    def spent(self) -> bool:
        """Whether the judge has looked at as many layouts as the effort allows, of this stage or since one was better."""
        return self.judgements >= min(self.effort.layouts, self.gained + self.effort.stale)

    def _say(self, phase: str) -> None:
        """Begin a phase."""
        self.phase = phase
        self.progress(phase)

    @cached_property
    def stages(self) -> list[Stage]:
        """All stages of the problem."""
        return [make_stage(self.problem, number, self.problem.start) for number in stages(self.problem)]

    @cached_property
    def builder(self) -> Builder:
        """Builds rooms anew."""
        return Builder(self.stages[0], self.rng, self.config.weights)

    @cached_property
    def repairer(self) -> Repair:
        """Makes better candidates."""
        return Repair(self.stages, self.runner, self.config, self.builder)

    @cached_property
    def grounds(self) -> list[Ground]:
        """The grids on which routes are planned, one for each agent, widest first."""
        bodies = sorted(self.problem.scene.agents, key=lambda agent: -agent.radius)
        return [make_ground(self.problem.contents, agent, self.config.cell) for agent in bodies]

    def _judged(self, world: Floats, number: int, best: _Best | None = None) -> _Best:
        """Judge a layout of everything placed up to a stage, as far as it may be better than what is best so far."""
        layout = self.problem.layout(world)
        stages = zip(self.problem.names, self.problem.stage, strict=True)
        placed = {name: layout[name] for name, stage in stages if stage <= number}
        moved = self.problem.moved(world)

        def enough(verdict: Verdict) -> bool:
            return best is not None and replace(verdict, moved=moved).worth >= best.verdict.worth

        self.judgements += 1
        phase = best.phase if best and number else self.phase
        found = _Best(world, replace(self.judge(Layout(placed), enough), moved=moved), phase)
        if best is None or found.verdict.worth[:3] < best.verdict.worth[:3]:
            self.gained = self.judgements
        return found

    def _stage(self, stage: Stage) -> _Best:
        """Place what belongs to a stage."""
        self.judgements, self.gained, number = 0, 0, stage.number
        best = self._judged(stage.world, number)
        if not stage.moving or best.verdict.ok:
            if stage.moving:
                self._still(stage, best, self.phase)
            return best
        best = self._pushed(stage, best)
        if number and not any(self._at(number, name) for name in best.verdict.culprits):
            return best
        best, run = self._polished(stage, best)
        off = self.problem.moved(best.world) / len(stage.moving) if self.problem.guessed else math.inf
        unmet = best.verdict.soft / max(len(self.problem.relations), 1)
        self.blind |= self._amiss(stage, best) > self.effort.lost[0] and off + unmet > self.effort.lost[1]
        if number == 0 and self.config.route_rounds and best.verdict.barred and not self.blind:
            best, run = self._opened(stage, run, best)
            best = self._route(stage, run, best)
        best = best if self.blind and not number else self._near(number, best)  # on a top a few centimetres are enough
        self.blind |= self._amiss(stage, best) > self.effort.blind
        self.blind |= best.verdict.soft > self.effort.blind * len(self.problem.relations)
        if not self.config.starts or not (self.blind or best.verdict.broken):
            return best
        best = self._anew(stage, best)
        return best if best.verdict.broken else self._near(number, best)

    def _amiss(self, stage: Stage, best: _Best) -> float:
        """Return the share of what a stage moves that is out of place or out of reach."""
        return best.verdict.broken / len(stage.moving)

    def _pushed(self, stage: Stage, best: _Best) -> _Best:
        """Return the best of the guess and of what its own statements make of it."""
        self._say("push")
        return self._best_of([pushed(self.builder.proposals, stage.world, self._order(stage))], stage.number, best)

    def _order(self, stage: Stage) -> list[int]:
        """Return what a stage moves, what others refer to first."""
        ranks = self.builder.proposals.ranks
        return sorted(stage.moving, key=lambda slot: ranks[slot])

    def _polished(self, stage: Stage, best: _Best) -> tuple[_Best, Run]:
        """Return the best after following gradients from the guess and from where it is pushed."""
        self._say("polish")
        proposals, order = self.builder.proposals, self._order(stage)
        push = pushed(proposals, stage.world, order)
        walls = pushed(proposals, stage.world, order, walls_only=True)
        starts = near(self.problem, stage.world, stage.moving, BATCH, self.rng)
        worlds = _different([push, walls, *starts])[:BATCH]
        run = self.runner.advance(stage, worlds, self.config.polish, "polish")
        return self._best_of(self._sharpened(run, order), stage.number, best), run

    def _opened(self, stage: Stage, run: Run, best: _Best) -> tuple[_Best, Run]:
        """Return the best after going on with ways kept open to everything."""
        plan = partial(self._open, run.world)
        more = self.runner.advance(stage, run.world, self.config.polish, "routes", plan=plan)
        self._say("routes")
        return self._best_of(self._sharpened(more, self._order(stage)), 0, best), run.joined(more)

    def _sharpened(self, run: Run, order: list[int]) -> Iterable[Floats]:
        """Yield the layouts of a run, best first, each also with what is all but right put exactly right."""
        for world in run.ranked():
            yield pushed(self.builder.proposals, world, order, most=NEAR)
            yield world

    def _near(self, number: int, best: _Best) -> _Best:
        """Place single things to blame anew, as near to their guesses as can be, as long as the judge likes that better."""
        self._say("mend")
        hopeless = set[str]()
        for _ in range(self.effort.nearby):
            names = [name for name in best.verdict.culprits if name not in hopeless and self._at(number, name)]
            if best.verdict.ok or not names or self.spent:
                break
            before = best.verdict.worth[:3]
            for world in self.repairer.near(best.world, self.problem.slot[names[0]], self._planned):
                best = self._best_of([world], number, best)
                if best.verdict.worth[:3] < before:
                    break
            else:
                hopeless.add(names[0])
        return best

    def _at(self, number: int, name: str) -> bool:
        """Return whether a stage may move a thing."""
        return self.problem.stage[self.problem.slot[name]] == number and name not in self.problem.pinned

    def _anew(self, stage: Stage, best: _Best) -> _Best:
        """Return the best of what is there and of rooms that are built and searched for."""
        self._say("build")
        self.gained = self.judgements
        count, run = self.config.starts // 4, None
        if stage.number == 0:
            best = self._mended(best, 0, self.effort.mendings)
            best, run = self._built(stage, count, best)
        if run is None:
            nearby = near(self.problem, stage.world, stage.moving, max(count, 1), self.rng)
            run = self.runner.advance(stage, nearby, self.config.polish, "polish")
            best = self._best_of(run.ranked(), stage.number, best)
        if stage.number == 0 and self.config.route_rounds and best.verdict.barred:
            best = self._route(stage, run, best)
        return best

    def _built(self, stage: Stage, count: int, best: _Best) -> tuple[_Best, Run | None]:
        """Return the best after so many starts of each batch are built and polished, and single things mended."""
        run: Run | None = None
        for _ in range(self.effort.built if count else 0):
            if best.verdict.ok or self.spent:
                break
            made = list[Floats]()
            while len(made) < count and not best.verdict.ok:
                made.append(self.builder.build(stage.world, stage.moving))
                bring_in(self.problem, made[-1][None], stage.moving)
                best = self._best_of(made[-1:], 0, best)
            best = self._mended(best, 0, self.effort.mendings) if best.verdict.promise <= self.effort.nearly else best
            if best.verdict.ok:
                return best, self._still(stage, best, "built")
            worlds = np.array(made)
            more = self.runner.advance(stage, worlds, self.config.polish, "polish", plan=partial(self._open, worlds))
            best, run = self._best_of(more.ranked(), 0, best), run.joined(more).best(self.config.kept) if run else more
            best = self._mended(best, 0, self.effort.mendings)
        return best, run

    def _still(self, stage: Stage, best: _Best, label: str) -> Run:
        """Return a layout as a run in which nothing moves; it is only run where a record is asked for."""
        still = Run(best.world[None], np.zeros(1), np.zeros(1))
        return self.runner.advance(stage, still.world, STILL, label) if self.config.trace else still

    def _open(self, worlds: Floats, start: int) -> Plan:
        """Return what keeps ways to everything open in one of some layouts."""
        return self._planned(worlds[start], everywhere=True)

    def _best_of(self, worlds: Iterable[Floats], number: int, best: _Best) -> _Best:
        """Return the best of some layouts and of what was best before, by the judge; nobody looks past a perfect one."""
        for world in worlds:
            if best.verdict.ok:
                break
            found = self._judged(world, number, best)
            if found.verdict.worth < best.verdict.worth:
                best = found
        return best

    def _route(self, stage: Stage, run: Run, best: _Best) -> _Best:
        """Push furniture out of the agents' routes, replanning as it moves."""
        world = run.world
        kept: list[list[Floats]] = [[] for _ in run.world]
        fruitless = False
        for _ in range(self.config.route_rounds):
            if not best.verdict.broken or fruitless or self.spent:
                break
            before = self.gained
            self._say("routes")
            blocked: list[int] = []

            def plan(start: int, now: Floats = world, blocked: list[int] = blocked) -> Plan:
                found = self._planned(now[start], kept[start])
                blocked.append(found.blocked)
                return found

            run = self.runner.advance(stage, world, self.config.reroute, "routes", plan=plan)
            world = run.world
            if not any(blocked):
                break
            best = self._best_of(run.ranked()[: self.config.judged], 0, best)
            fruitless = self.gained == before
        return best

    def _planned(self, world: Floats, kept: list[Floats] | None = None, *, everywhere: bool = False) -> Plan:
        """Plan for every agent; of what is `kept`, the demands of two rounds before stay: furniture shall not swing back."""
        if not self.config.route_rounds:
            return Plan(np.empty((0, 4)), 0)
        plans = [plan_routes(ground, world, everywhere=everywhere) for ground in self.grounds]
        kept = [] if kept is None else kept
        kept.append(np.concatenate([plan.demands for plan in plans]))
        del kept[:-3]
        return Plan(np.concatenate(kept), sum(plan.blocked for plan in plans))

    def _restored(self, best: _Best) -> _Best:
        """Put back where it was at first what was moved without need, if that is worth anything, and square what is askew."""
        self._say("restore")

        def no_worse(world: Floats) -> bool:
            nonlocal best
            layout = self.problem.layout(world)
            verdict = self.judge(layout, lambda found: found.worth[:3] > best.verdict.worth[:3])
            if verdict.worth[:3] > best.verdict.worth[:3]:
                return False
            best = _Best(world, replace(verdict, moved=self.problem.moved(world)), best.phase)
            return True

        if not self.blind:
            restored(self.problem, best.world, no_worse, self.effort.put_back)
        squared(self.problem, best.world, no_worse)
        return best

    def _mended(self, best: _Best, number: int, most: int) -> _Best:
        """Place single things to blame anew while all else stays, in turn, as long as the judge likes that better."""
        turn = 0
        for _ in range(most):
            slots = [self.problem.slot[name] for name in best.verdict.culprits]
            slots = [slot for slot in slots if slot in self.builder.moving]
            if best.verdict.ok or not slots or self.spent:
                break
            world = self.repairer.mended(best.world, slots[turn // MENDING.ways % len(slots)], turn % MENDING.ways)
            found = self._judged(world, number, best)
            turn += 1
            if found.verdict.worth < best.verdict.worth:
                best, turn = found, 0
        return best

    def _repair(self, best: _Best) -> _Best:
        """Place what is to blame anew for longer, whatever stage it is of."""
        self._say("repair")
        self.gained = self.judgements
        return self._mended(best, len(self.stages) - 1, 4 * self.effort.mendings)


def _different(worlds: Iterable[Floats]) -> Floats:
    """Return layouts (k, n, 4) without those that are there twice, in order."""
    found = np.array(list(worlds))
    _, first = np.unique(found.reshape(len(found), -1), axis=0, return_index=True)
    return found[np.sort(first)]


def near(problem: Problem, world: Floats, moving: tuple[int, ...], count: int, rng: np.random.Generator) -> Floats:
    """Return poses (n, 4) and slight jitter of what moves in them: (count, n, 4)."""
    scale = 0.1 if problem.parent[moving[0]] >= 0 else 1.0
    starts = np.repeat(world[None], count, axis=0)
    for k, start in enumerate(starts[1:], 1):
        sigma = (0.05 + 0.3 * k / count) * scale
        for slot in moving:
            start[slot, :2] += rng.normal(0.0, sigma, 2)
            if rng.random() < sigma / 2 and problem.guessed:
                start[slot, 2:] = [-start[slot, 3], start[slot, 2]]
    bring_in(problem, starts, moving)
    return starts


def bring_in(problem: Problem, starts: Floats, moving: tuple[int, ...]) -> None:
    """Put things whose centre lies outside the room onto the nearest point of its floor."""
    room = Polygon(problem.scene.room.vertices)
    shapely.prepare(room)
    for slot in moving:
        if problem.parent[slot] < 0:
            points = np.asarray(shapely.points(starts[:, slot, :2]))
            outside = ~shapely.covers(room, points)
            ways = shapely.shortest_line(points[outside], room)
            starts[outside, slot, :2] = shapely.get_coordinates(ways)[1::2]
