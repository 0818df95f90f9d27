"""Several programs for one scene, solved together.

Each program has a solver of its own, in a thread of its own, with a share of the starts. Whenever all of them wait for the
compiled search, what they ask for runs as one batch (`lanes`), a few starts of a few programs each: four programs cost
about what one does. As soon as one of them is met entirely, no further effort is spent on the others; repair, which is
expensive, is for the best alone. Which thread is faster decides nothing: choices are made only when all wait.
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import replace
from functools import partial
from threading import Condition
from typing import Any

from robolayout.scene import Layout, Scene, Trace
from robolayout.solve.arrays import Found
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.config import SolverConfig
from robolayout.solve.judge import Judge, Verdict
from robolayout.solve.lanes import STARTS, LaneRunner, Request, prepare, run_together
from robolayout.solve.refine import Solver
from robolayout.solve.solution import Progress, Solution, conclude, silent
from robolayout.solve.stage import sizes_of, stages

REPAIRED = 2
"""Programs that are repaired, at most: the best, and the next one if the best still breaks a hard demand."""


class _Enough(Exception):
    """Another program is met already: no more effort for this stage."""


class _Closed(Exception):
    """The meeting has ended early."""


class _One(Solver):
    """The solver of one program among several; it leaves the repair for later.

    Attributes:
        index: Which program it is.
        number: Stage that it works on.
        best: Best layout of that stage so far.
        met: Stages for which everything was met.
        lanes: Who runs its phases.
    """

    def __init__(self, index: int, problem: Problem, judge: Judge, config: SolverConfig, seed: int) -> None:
        super().__init__(problem, judge, config, seed=seed)
        self.index, self.number = index, 0
        self.best: Any = None
        self.met = set[int]()
        self.lanes = LaneRunner(config, lambda request: run_together([request], config.weights)[0])
        self.runner = self.lanes

    @property
    def merit(self) -> float:
        """What the judge says of the best layout; smaller is better."""
        return self.best.verdict.merit

    def repair(self) -> None:
        """Mend what is to blame, and remove and reinsert it, while that helps, without the others."""
        self.best = super()._repair(super()._near(max(stages(self.problem)), self.best))

    def conclusion(self) -> Solution:
        """Return the best layout found."""
        trace = self.runner.trace(self.problem) if self.config.trace else Trace()
        return conclude(self.problem.layout(self.best.world), self.best.verdict, trace)

    def _stage(self, number: int, world: Floats) -> Any:
        self.number, self.best = number, None
        with suppress(_Enough):
            self.best = super()._stage(number, world)
        return self.best

    def _judged(self, world: Floats, number: int, best: Any = None) -> Any:
        found = super()._judged(world, number, best)
        if self.best is None or found.verdict.merit < self.merit:
            self.best = found
        if found.verdict.ok:
            self.met.add(number)
        return found

    def _near(self, number: int, best: Any) -> Any:
        return best

    def _repair(self, best: Any) -> Any:
        self.best = best
        return best


class _Meeting:
    """Where solvers wait until all of them have asked for a run, and get their answers.

    Args:
        ones: The solvers.
    """

    def __init__(self, ones: Sequence[_One]) -> None:
        self.ones = ones
        self._state = Condition()
        self._live = len(ones)
        self._closed = False
        self._asked: dict[int, Request] = {}
        self._answers: dict[int, list[Found] | None] = {}

    def attend(self, one: _One) -> None:
        """Let a solver work, in its own thread, to its end."""
        try:
            with suppress(_Closed):
                one.solve()
        finally:
            with self._state:
                self._live -= 1
                self._state.notify_all()

    def ask(self, one: _One, request: Request) -> list[Found]:
        """Wait for the answer to a request."""
        with self._state:
            self._asked[one.index] = request
            self._state.notify_all()
            self._state.wait_for(lambda: self._closed or one.index in self._answers)
            if self._closed:
                raise _Closed
            answer = self._answers.pop(one.index)
        if answer is None:
            raise _Enough
        return answer

    def close(self) -> None:
        """Send home whoever still waits."""
        with self._state:
            self._closed = True
            self._state.notify_all()

    def preside(self, config: SolverConfig, progress: Progress) -> None:
        """Answer requests until all have left."""
        while True:
            with self._state:
                self._state.wait_for(lambda: len(self._asked) == self._live)
                if not self._live:
                    return
            chosen, refused = self._agenda()
            if chosen and not refused:
                progress(self._asked[chosen[0]].label)
                found = run_together([self._asked[i] for i in chosen], config.weights)
                answers: dict[int, list[Found] | None] = dict(zip(chosen, found, strict=True))
            else:
                answers = dict.fromkeys(refused)
            with self._state:
                for index in answers:
                    del self._asked[index]
                self._answers |= answers
                self._state.notify_all()

    def _agenda(self) -> tuple[list[int], list[int]]:
        """Return whose requests to run and whose to refuse: the earliest stage first, and no more than is needed."""
        number = min(self.ones[i].number for i in self._asked)
        chosen = sorted(i for i in self._asked if self.ones[i].number == number)
        if any(number in one.met for one in self.ones):
            return chosen, [i for i in chosen if self.ones[i].best is not None]
        return chosen, []


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
        config: Constants of the search; the starts are shared out among the programs.
        progress: Called with the name of each phase.
    """
    if not problems:
        return []
    if not problems[0].names:
        return [conclude(Layout({}), Verdict(0.0, 0.0, 0.0), Trace()) for _ in problems]
    config = config or SolverConfig()
    starts, kept = (_share(count, len(problems)) for count in (config.starts, config.kept))
    shared = replace(config, starts=starts, kept=kept)
    pairs = zip(problems, judges, strict=True)
    ones = [_One(i, problem, judge, shared, seed + 1009 * i) for i, (problem, judge) in enumerate(pairs)]
    _search(ones, shared, progress or silent)
    for one in sorted(ones, key=lambda one: one.merit)[:REPAIRED]:
        if any(other.best.verdict.ok for other in ones):
            break
        (progress or silent)("repair")
        one.config = config
        one.repair()
        if not one.best.verdict.hard:
            break
    return [one.conclusion() for one in ones]


def _share(count: int, among: int) -> int:
    """Return how many of so many starts one program gets, in whole lanes."""
    return STARTS * max(1, round(count / among / STARTS))


def _search(ones: Sequence[_One], config: SolverConfig, progress: Progress) -> None:
    """Let all solvers work at the same time, up to the repair."""
    meeting = _Meeting(ones)
    alone = [one.lanes.send for one in ones]
    for one in ones:
        one.lanes.send = partial(meeting.ask, one)
    with ThreadPoolExecutor(len(ones), thread_name_prefix="robolayout-sample") as pool:
        working = [pool.submit(meeting.attend, one) for one in ones]
        try:
            meeting.preside(config, progress)
        finally:
            meeting.close()
        for work in working:
            work.result()
    for one, send in zip(ones, alone, strict=True):
        one.lanes.send = send


def warm_up_samples(scene: Scene, config: SolverConfig | None = None) -> None:
    """Start to load or compile, in the background, the program that solving samples for this scene will need."""
    if scene.assets:
        prepare(sizes_of(scene), (config or SolverConfig()).weights)
