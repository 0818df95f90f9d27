"""Several programs for one scene, solved together.

Their starts share the compiled batches that one program would have for itself: every call of `advance_many` holds a few starts
of a few programs. Each program gets fewer starts, so that four of them cost little more than one; repair, which is expensive,
is for those alone that the judge likes best.
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout.scene import Layout, Scene, Trace
from robolayout.solve import programs
from robolayout.solve.arrays import Arrays, Found, Losses, Routes, Schedule
from robolayout.solve.compile import Floats, Problem, compile_problem
from robolayout.solve.config import SearchConfig, SolverConfig
from robolayout.solve.judge import Judge, Verdict
from robolayout.solve.proposals import make_starts
from robolayout.solve.refine import Solver
from robolayout.solve.routes import pack
from robolayout.solve.runner import NOISE_BLOCK, PROCESSORS, STILL, Run, Runner
from robolayout.solve.solution import Progress, Solution, conclude, silent
from robolayout.solve.stage import Stage, make_stage, no_routes, stages

Singles = NDArray[np.float32]

PROGRAM = "search_many:advance_many"
"""What all phases run."""

LANES, STARTS = 4, 2
"""Lanes of one compiled batch and starts in a lane; a lane belongs to one program."""

LEAST_STARTS = 4
"""Starts that every program gets, however many programs there are."""

REPAIRED = 2
"""Programs that are repaired, at most: the best, and the next one if the best still breaks a hard demand."""


@dataclass
class _Job:
    """Starts of one program that run on together with those of others."""

    one: _One
    stage: Stage
    world: Floats
    routes: Routes | None = None


class _LaneRunner(Runner):
    """The record of one program's runs in lanes."""

    def settle(self, job: _Job, part: slice, found: Found) -> Run:
        """Return what one lane left."""
        return self._run(job.stage, job.world[part], found)

    def keep(self, job: _Job, label: str, steps: int, found: Found) -> None:
        """Keep the record of a lane."""
        if self.config.trace and steps:
            self._record(job.stage, label, steps, found)


class _One(Solver):
    """One of several programs: what `Solver` does, between the runs that all programs make together."""

    def __init__(self, problem: Problem, judge: Judge, config: SolverConfig, seed: int, progress: Progress) -> None:
        super().__init__(problem, judge, config, seed=seed, progress=progress)
        self.lanes = _LaneRunner(config)
        self.runner = self.lanes
        self._survey()
        self.best = self._judged(problem.start.copy(), -1)

    @property
    def merit(self) -> float:
        """What the judge says of the best layout so far; smaller is better."""
        return self.best.verdict.merit

    def begin(self, number: int, starts: int) -> _Job | None:
        """Return the starts of a stage; None if it moves nothing."""
        if number not in stages(self.problem):
            return None
        stage = make_stage(self.problem, number, self.best.world)
        if not stage.moving:
            self.best = self._judged(self.best.world, number)
            return None
        return _Job(self, stage, make_starts(self.problem, self.best.world, stage.moving, starts, self.rng))

    def choose(self, run: Run, number: int, count: int) -> None:
        """Judge the first few layouts of a run and take the best."""
        found = [self._judged(run.world[k], number) for k in run.order()[:count]]
        self.best = min(found, key=lambda best: best.verdict.merit)

    def improve(self, run: Run) -> None:
        """Judge all layouts of a run of the first stage, and take one that is better than the best."""
        for k in run.order():
            found = self._judged(run.world[k], 0)
            if found.verdict.merit < self.merit:
                self.best = found

    def blocked(self, job: _Job, kept: list[list[Floats]]) -> _Job | None:
        """Return a job with what must yield to the agents' routes; None if they are free."""
        plans = [self._planned(world, before) for world, before in zip(job.world, kept, strict=True)]
        if not any(plan.blocked for plan in plans):
            return None
        return _Job(self, job.stage, job.world, pack(plans, 8 * job.stage.slots))

    def snap(self) -> None:
        """Put what is all but right exactly right."""
        self.best = self._snap(self.best)

    def repair(self) -> None:
        """Remove and reinsert what is to blame, while that helps."""
        self.best = self._snap(self._repair(self.best))

    def conclusion(self) -> Solution:
        """Return the best layout found."""
        trace = self.runner.trace(self.problem) if self.config.trace else Trace()
        return conclude(self.problem.layout(self.best.world), self.best.verdict, trace)


class Samples:
    """Solves several programs of one scene.

    Args:
        problems: One problem per program.
        judges: The exact verifier for each, as an order on layouts.
        config: Constants; the starts are shared out among the programs.
        seed: Seed of all randomness.
        progress: Called with the name of each phase.
    """

    def __init__(
        self,
        problems: Sequence[Problem],
        judges: Sequence[Judge],
        config: SolverConfig | None = None,
        *,
        seed: int = 0,
        progress: Progress | None = None,
    ) -> None:
        self.config = config or SolverConfig()
        self.progress = progress or silent
        pairs = zip(problems, judges, strict=True)
        self.ones = [_One(p, judge, self.config, seed + 1009 * i, self.progress) for i, (p, judge) in enumerate(pairs)]
        share = max(LEAST_STARTS, self.config.starts // len(self.ones))
        self.starts = share + share % STARTS
        self.kept = max(STARTS, self.config.kept // len(self.ones))

    def solve(self) -> list[Solution]:
        """Return the best layout found for each program."""
        for number in range(max(len(stages(one.problem)) for one in self.ones)):
            self._stage(number)
        settled = [one for one in self.ones if one.best.verdict.ok]
        for one in settled or self.ones:
            one.snap()
        for one in sorted(self.ones, key=lambda one: one.merit)[:REPAIRED]:
            if self._done():
                break
            one.repair()
            if not one.best.verdict.hard:
                break
        return [one.conclusion() for one in self.ones]

    def _done(self) -> bool:
        """Return whether one program is met entirely: then no effort is spent on the others."""
        return any(one.best.verdict.ok for one in self.ones)

    def _stage(self, number: int) -> None:
        """Place what belongs to a stage, for all programs at once."""
        self.progress("search")
        jobs = [job for one in self.ones if (job := one.begin(number, self.starts)) is not None]
        phase = self.config.tops if number else self.config.search
        runs = self._advance(jobs, phase, "search", noise=True)
        jobs = [
            _Job(job.one, job.stage, run.world[run.order()[: self.kept]]) for job, run in zip(jobs, runs, strict=True)
        ]
        runs = self._advance(jobs, self.config.polish, "polish")
        for job, run in zip(jobs, runs, strict=True):
            job.one.choose(run, number, self.kept)
        if number == 0:
            self._route([_Job(job.one, job.stage, run.world) for job, run in zip(jobs, runs, strict=True)])

    def _route(self, jobs: list[_Job]) -> None:
        """Push furniture out of the agents' routes, replanning as it moves."""
        kept = {id(job.one): [list[Floats]() for _ in job.world] for job in jobs}
        for _ in range(self.config.route_rounds):
            if self._done():
                break
            jobs = [job for job in jobs if job.one.best.verdict.access]
            self.progress("routes")
            blocked = [found for job in jobs if (found := job.one.blocked(job, kept[id(job.one)])) is not None]
            if not blocked:
                break
            runs = self._advance(blocked, self.config.reroute, "routes")
            jobs = []
            for job, run in zip(blocked, runs, strict=True):
                job.one.improve(run)
                jobs.append(_Job(job.one, job.stage, run.world))

    def _advance(self, jobs: Sequence[_Job], phase: SearchConfig, label: str, *, noise: bool = False) -> list[Run]:
        """Run one phase of all jobs; lanes of one size share a batch."""
        lanes = [
            (j, slice(begin, begin + STARTS))
            for j, job in enumerate(jobs)
            for begin in range(0, len(job.world), STARTS)
        ]
        filled = [_lane(jobs[j], part, noise=noise) for j, part in lanes]
        found: list[Run | None] = [None] * len(lanes)
        batches = _batches([_shapes(lane) for lane in filled])
        results = self._call([[filled[i] for i in batch] for batch in batches], phase)
        for batch, lane_results in zip(batches, results, strict=True):
            for i, result in zip(batch, lane_results, strict=False):
                j, part = lanes[i]
                if part.start == 0:
                    jobs[j].one.lanes.keep(jobs[j], label, phase.steps, result)
                found[i] = jobs[j].one.lanes.settle(jobs[j], part, result)
        return [_joined([found[i] for i, (owner, _) in enumerate(lanes) if owner == j]) for j in range(len(jobs))]

    def _call(self, batches: list[list[_Lane]], phase: SearchConfig) -> list[list[Found]]:
        """Run batches side by side, one on each processor, and return what each lane left."""
        schedule = _schedule(phase)

        def run(batch: list[_Lane]) -> list[Found]:
            local, arrays, routes, noise = _stacked(batch)
            values = programs.call(PROGRAM, local, arrays, routes, schedule, noise, weights=self.config.weights)
            return [_found([value[i] for value in values]) for i in range(len(batch))]

        if len(batches) <= 1:
            return [run(batch) for batch in batches]
        with ThreadPoolExecutor(min(len(batches), PROCESSORS)) as pool:
            return list(pool.map(run, batches))


_Lane = tuple[Singles, Arrays, Routes, Singles]
"""Variables, arrays, routes and noise of a few starts of one program."""


def _lane(job: _Job, part: slice, *, noise: bool) -> _Lane:
    """Return a few starts of a job, filled up by repeating the last one."""
    world = job.world[part]
    fill = np.minimum(np.arange(STARTS), len(world) - 1)
    local = job.stage.local(world[fill]).astype(np.float32)
    shape = (NOISE_BLOCK, STARTS, job.stage.slots, 2)
    shake = job.one.rng.standard_normal(shape, np.float32) if noise else np.zeros(shape, np.float32)
    routes = no_routes(STARTS, 8 * job.stage.slots)
    if job.routes is not None:
        routes = Routes(*(field[part][fill] for field in job.routes))
    return local, job.stage.arrays, routes, shake


def _shapes(lane: _Lane) -> tuple[tuple[int, ...], ...]:
    return tuple(leaf.shape for leaf in programs.leaves(lane))


def _batches(kinds: Sequence[tuple[tuple[int, ...], ...]]) -> list[list[int]]:
    """Return the numbers of lanes that run together: of one size, at most `LANES` of them."""
    by_kind: dict[tuple[tuple[int, ...], ...], list[int]] = {}
    for i, kind in enumerate(kinds):
        by_kind.setdefault(kind, []).append(i)
    return [alike[begin : begin + LANES] for alike in by_kind.values() for begin in range(0, len(alike), LANES)]


def _stacked(batch: list[_Lane]) -> Any:
    """Return the arrays of lanes with a leading axis of `LANES`, filled up by repeating the last lane."""
    columns = [programs.leaves(batch[min(i, len(batch) - 1)]) for i in range(LANES)]
    return programs.rebuilt(batch[0], [np.stack(leaves) for leaves in zip(*columns, strict=True)])


def _found(values: list[Any]) -> Found:
    local, world, *terms, history, shots = values
    return Found(local, world, Losses(*terms), history, shots)


def _joined(runs: Sequence[Run | None]) -> Run:
    fields = [run.fields() for run in runs if run is not None]
    return Run(*(np.concatenate(column) for column in zip(*fields, strict=True)))


def solve_samples(
    problems: Sequence[Problem],
    judges: Sequence[Judge],
    *,
    seed: int = 0,
    config: SolverConfig | None = None,
    progress: Progress | None = None,
) -> list[Solution]:
    """Solve several programs of one scene together; what each costs is shared.

    Args:
        problems: One problem per program, all of one scene.
        judges: The exact verifier for each, as an order on layouts.
        seed: Settles every choice.
        config: Constants of the search.
        progress: Called with the name of each phase.
    """
    if not problems:
        return []
    if not problems[0].names:
        return [conclude(Layout({}), Verdict(0.0, 0.0, 0.0), Trace()) for _ in problems]
    return Samples(problems, judges, config, seed=seed, progress=progress).solve()


def warm_up_samples(scene: Scene, config: SolverConfig | None = None) -> None:
    """Start to load or compile, in the background, the program that solving samples for this scene will need."""
    if scene.assets:
        problem = compile_problem(scene)
        stage = make_stage(problem, 0, problem.start)
        lane = _blank(stage)
        weights = (config or SolverConfig()).weights
        local, arrays, routes, noise = _stacked([lane])
        programs.prepare(PROGRAM, local, arrays, routes, _schedule(STILL), noise, weights=weights)


def _schedule(phase: SearchConfig) -> Schedule:
    rates = (phase.rate, phase.final_rate, phase.noise, phase.ramp)
    return Schedule(np.int32(phase.steps), *(np.float32(rate) for rate in rates))


def _blank(stage: Stage) -> _Lane:
    """Return a lane in which nothing happens."""
    local = stage.local(np.repeat(stage.problem.start[None], STARTS, axis=0)).astype(np.float32)
    noise = np.zeros((NOISE_BLOCK, STARTS, stage.slots, 2), np.float32)
    return local, stage.arrays, no_routes(STARTS, 8 * stage.slots), noise
