"""The whole solve: push, polish, routes in the loop, mend, and only then build; one stage of support after the other.

What was asked for is kept: the guess is judged as it is, pushed to where its own statements hold, polished by gradients, with
what a body needs as demands on the furniture in its way, and mended thing by thing, nearest first. A room is built anew only if
hard demands or access are still not met then, or if there was nothing to keep. What a room that was built lacks, if that is
little, is mended before gradients move the rest.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import KW_ONLY, dataclass, field, replace
from functools import cached_property

import numpy as np

from robolayout.floor import Ground, RoutePlan, make_ground, plan_routes
from robolayout.scene import Layout
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.config import SolverConfig
from robolayout.solve.push import pushed
from robolayout.solve.repair import MENDING, Repair
from robolayout.solve.restore import once_more, restored, squared
from robolayout.solve.runner import BATCH, STILL, Runner, SearchRun
from robolayout.solve.solution import Judge, Progress, Solution, Verdict, silent
from robolayout.solve.stage import Stage, make_stage, stages

NEAR = 0.4
"""Metres that a polished thing may be put where its statements hold exactly."""

WORST = Verdict(math.inf, math.inf, math.inf)
"""What any layout is better than."""


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
        self.blind, self.stuck = False, WORST  # whether the guess is worth nothing; what mending has not bettered
        self.stages = [make_stage(self.problem, number, self.problem.start) for number in stages(self.problem)]
        self.number, self.phase = 0, ""  # the stage and the phase under way
        self.hold(self.problem.start, WORST, "guess" if self.problem.guessed else "built")

    def hold(self, world: Floats, verdict: Verdict, phase: str) -> None:
        """Make a layout the incumbent: poses (n, 4), what the judge says of them, and the phase that made them."""
        self.world, self.verdict, self.made_by = world, verdict, phase

    def solve(self) -> Solution:
        """Return the best layout found."""
        for stage in self.stages:
            self.phase = self.made_by
            self._stage(stage.at(self.world))
        # a search for a room without guesses leaves to whoever has the best of several what takes hundreds of layouts
        given_up = self.effort.hopeless(self.verdict.broken, len(self.problem.names)) or self.verdict is self.stuck
        if self.problem.guessed or not given_up:
            self._repair()
        return self._found()

    def mend(self) -> Solution:
        """Return the best layout found by placing single things of the problem's own one anew, as long as that gains something."""
        self.number = len(self.stages) - 1
        self._judged(self.world, WORST.worth)
        self._repair()
        return self._found()

    def _found(self) -> Solution:
        """Return the incumbent, with what was moved without need put back."""
        self._restore()
        return Solution(self.problem.layout(self.world), self.verdict, self.made_by, self.runner.trace())

    @property
    def spent(self) -> bool:
        """Whether the judge has looked at as many layouts as the effort allows, of this stage or since one was better."""
        return self.judgements >= min(self.effort.layouts, self.gained + self.effort.stale)

    def _say(self, phase: str) -> None:
        """Begin a phase."""
        self.phase = phase
        self.progress(phase)

    @cached_property
    def repair(self) -> Repair:
        """Makes better candidates, and builds rooms anew."""
        return Repair(self.stages, self.runner, self.config, self.rng)

    @cached_property
    def grounds(self) -> list[Ground]:
        """The grids on which routes are planned, one for each agent, widest first; none where no routes are."""
        bodies = sorted(self.problem.scene.agents, key=lambda agent: -agent.radius) if self.config.route_rounds else ()
        return [make_ground(self.problem.contents, agent, self.config.cell) for agent in bodies]

    def _judged(self, world: Floats, limit: tuple[float, ...]) -> bool:
        """Judge a layout of everything placed up to this stage, as far as its worth may be below a limit; keep it if it is."""
        layout, moved = self.problem.layout(world), self.problem.moved(world)
        stages = zip(self.problem.names, self.problem.stage, strict=True)
        placed = {name: layout[name] for name, stage in stages if stage <= self.number}

        def enough(verdict: Verdict) -> bool:
            return replace(verdict, moved=moved).worth >= limit

        self.judgements += 1
        found = replace(self.judge(Layout(placed), enough), moved=moved)
        if found.worth[:3] < self.verdict.worth[:3]:
            self.gained = self.judgements
        if found.worth < limit:
            self.hold(world, found, self.made_by if self.number else self.phase)
        return found.worth < limit

    def _try(self, worlds: Iterable[Floats]) -> None:
        """Judge layouts, and keep the best; nobody looks past a perfect one."""
        for world in worlds:
            if self.verdict.ok:
                break
            self._judged(world, self.verdict.worth)

    def _blamed(self, number: int) -> list[int]:
        """Return the slots to blame that a stage may move, the most pressing first; with what stands on them they are to blame, too."""
        moving, blamed = self.problem.movable(number), list[int]()
        for slot in (self.problem.slot[name] for name in self.verdict.culprits):
            while self.problem.stage[slot] > number:
                slot = self.problem.parent[slot]
            blamed += [slot] * (slot in moving)
        return [*dict.fromkeys(blamed)]

    def _stage(self, stage: Stage) -> None:
        """Place what belongs to a stage."""
        self.judgements, self.gained, self.number, self.verdict = 0, 0, stage.number, WORST
        self._judged(stage.world, WORST.worth)
        if not stage.moving:
            return
        if self.verdict.ok:
            self._still(stage, self.phase)
            return
        self._say("push")
        push = pushed(self.repair.proposals, stage.world, stage.moving)
        self._try([push])
        if self.number and not self._blamed(self.number):
            return
        if not self.problem.guessed and self.verdict.broken <= self.effort.few:
            self._near(math.ceil(self.verdict.broken))
            self.gained = self.judgements
            if self.verdict.ok:
                return
        run = self._polished(stage, push)
        off = self.problem.moved(self.world) / len(stage.moving) if self.problem.guessed else math.inf
        unmet = self.verdict.soft / max(len(self.problem.relations), 1)
        amiss = self.verdict.broken / len(stage.moving)  # share that is out of place or out of reach
        self.blind |= amiss > self.effort.lost[0] and off + unmet > self.effort.lost[1]
        if self._shut and not self.blind:
            self._opened(stage, run)
        if self.number or not self.blind:  # on a top a few centimetres are enough
            self._near()
        self.blind |= self.effort.hopeless(self.verdict.broken, len(stage.moving))
        self.blind |= self.verdict.soft > self.effort.blind * len(self.problem.relations)
        if self.config.starts and (self.blind or self.verdict.broken):
            self._anew(stage)

    @property
    def _shut(self) -> bool:
        """Whether routes are planned for what stands in the room, and some are blocked."""
        return not self.number and self.config.route_rounds > 0 and self.verdict.barred > 0.0

    def _polished(self, stage: Stage, push: Floats) -> SearchRun:
        """Follow gradients from the guess and from where it is pushed."""
        self._say("polish")
        proposals = self.repair.proposals
        walls = pushed(proposals, stage.world, stage.moving, walls_only=True)
        starts = np.array([push, walls, *proposals.near(stage.world, stage.moving, BATCH, self.rng)])
        _, first = np.unique(starts.reshape(len(starts), -1), axis=0, return_index=True)
        run = self.runner.advance(stage, starts[np.sort(first)][:BATCH], self.config.polish, "polish")
        self._sharpen(stage, run)
        return run

    def _opened(self, stage: Stage, run: SearchRun) -> None:
        """Go on with ways kept open to everything, and with what stands in them pushed aside."""
        plans = [self._planned(world, everywhere=True) for world in run.world]
        more = self.runner.advance(stage, run.world, self.config.polish, "routes", plans=plans)
        self._say("routes")
        self._sharpen(stage, more)
        self._route(stage, run.joined(more))

    def _sharpen(self, stage: Stage, run: SearchRun) -> None:
        """Try the layouts of a run, best first, each also with what is all but right put exactly right."""
        rows, moving = self.repair.proposals, stage.moving
        self._try(one for world in run.ranked() for one in (pushed(rows, world, moving, most=NEAR), world))

    def _near(self, most: float = math.inf) -> None:
        """Place some things to blame anew, as near to their guesses as can be, as long as the judge likes that better."""
        self._say("mend")
        hopeless = set[int]()
        for _ in range(int(min(most, self.effort.nearby))):
            slots = [slot for slot in self._blamed(self.number) if slot not in hopeless]
            if self.verdict.ok or not slots or self.spent:
                break
            before = self.verdict.worth[:3]
            for world in self.repair.near(self.world, slots[0], self._planned):
                self._try([world])
                if self.verdict.worth[:3] < before:
                    break
            else:
                hopeless.add(slots[0])

    @property
    def _guided(self) -> bool:
        """Whether there is a guess that is worth keeping."""
        return bool(self.problem.guessed) and not self.blind

    @property
    def _kept(self) -> bool:
        """Whether no further room is built: hard demands and access are met, and all statements unless a guess is kept."""
        return not self.verdict.broken if self._guided else self.verdict.right

    def _anew(self, stage: Stage) -> None:
        """Build rooms and search for them."""
        self._say("build")
        self.gained = self.judgements
        count = self.config.starts // 4
        run = None if self.number else self._built(stage, count)
        if self.verdict.ok:
            self._still(stage, self.made_by)
            return
        if not self._kept:
            if run is None:
                nearby = self.repair.proposals.near(stage.world, stage.moving, max(count, 1), self.rng)
                run = self.runner.advance(stage, nearby, self.config.polish, "polish")
                self._try(run.ranked())
            if self._shut:
                self._route(stage, run)
        if not self.verdict.broken:
            self._near()

    def _built(self, stage: Stage, count: int) -> SearchRun | None:
        """Build and polish so many starts in each batch, and mend single things."""
        if not self.blind:
            self._mend(self.effort.mendings)
        run: SearchRun | None = None
        for _ in range(self.effort.built if count else 0):
            if self._kept or self.spent:
                break
            before, made = self.verdict, list[Floats]()
            while len(made) < count and not self._kept:
                made.append(self.repair.builder.build(stage.world, stage.moving))
                self.repair.proposals.bring_in(made[-1][None], stage.moving)
                self._try(made[-1:])
            if self.verdict.promise <= self.effort.nearly or self.verdict is before:
                self._mend(self.effort.mendings)
            if self._kept:
                break
            plans = [self._planned(world, everywhere=True) for world in made]
            more = self.runner.advance(stage, np.array(made), self.config.polish, "polish", plans=plans)
            self._try(more.ranked())
            run = run.joined(more).best(self.config.kept) if run else more
            self._mend(self.effort.mendings)
        return run

    def _still(self, stage: Stage, label: str) -> None:
        """Record the incumbent as it stands, where a record is asked for."""
        if self.config.trace:
            self.runner.advance(stage, self.world[None], STILL, label)

    def _route(self, stage: Stage, run: SearchRun) -> None:
        """Push furniture out of the agents' routes, replanning as it moves."""
        rounds = list[list[RoutePlan]]()
        for _ in range(self.config.route_rounds):
            if not self.verdict.broken or self.spent:
                break
            before = self.gained
            self._say("routes")
            rounds.append([self._planned(world) for world in run.world])
            # what the two rounds before asked for stays: furniture shall not swing back
            plans = [_joined(lately) for lately in zip(*rounds[-3:], strict=True)]
            run = self.runner.advance(stage, run.world, self.config.reroute, "routes", plans=plans)
            if not any(plan.blocked for plan in rounds[-1]):
                break
            self._try(run.ranked())
            if self.gained == before:
                break

    def _planned(self, world: Floats, *, everywhere: bool = False) -> RoutePlan:
        """Plan for every agent."""
        return _joined([plan_routes(ground, world, everywhere=everywhere) for ground in self.grounds])

    def _mend(self, most: int) -> None:
        """Place single things to blame anew while all else stays, in turn, as long as the judge likes that better."""
        if self.verdict is self.stuck:
            return
        turn = 0
        for _ in range(most):
            slots = self._blamed(0)
            if self.verdict.ok or not slots or self.spent:
                break
            world = self.repair.mended(self.world, slots[turn // MENDING.ways % len(slots)], turn % MENDING.ways)
            turn = 0 if self._judged(world, self.verdict.worth) else turn + 1
        if turn == most:
            self.stuck = self.verdict

    def _repair(self) -> None:
        """Place what is to blame anew for longer, now that all stages are there; statements of a guess that is kept get a few tries."""
        few = self.effort.anywhere if self._guided else 0
        most = self.effort.layouts if self.verdict.broken else few
        if most and self.effort.mendings and not self.verdict.ok:
            self._say("repair")
            self.gained, self.number, self.stuck = self.judgements, len(self.stages) - 1, WORST
            self._mend(most)

    def _restore(self) -> None:
        """Put back where it was at first what was moved without need, if that is worth anything, and square what is askew."""
        self.progress("restore")
        self.phase = self.made_by

        def no_worse(world: Floats) -> bool:
            return self._judged(world, (*self.verdict.worth[:3], math.inf))

        if not self.blind:
            restored(self.problem, self.world, no_worse, self.effort.put_back, self.repair.groups)
        squared(self.problem, self.world, no_worse)
        if not self.blind:
            once_more(self.problem, self.world, no_worse)


def _joined(plans: Sequence[RoutePlan]) -> RoutePlan:
    """Return several plans as one."""
    demands = [np.empty((0, 4)), *(plan.demands for plan in plans)]
    return RoutePlan(np.concatenate(demands), sum(plan.blocked for plan in plans))
