"""The whole flow, one function a reader can follow: scene, groups, program, problem, solution, report."""

from __future__ import annotations

import math
from collections.abc import Callable, Generator, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from robolayout._errors import SceneError
from robolayout._reading import whole
from robolayout.floor import FLOOR, cell_size
from robolayout.planners import Critic, Group, GroupPlanner, OfflinePlanner, Planner, PlanRequest
from robolayout.program import Program, Reconciled, read_program, reconcile
from robolayout.run.bettering import bettered
from robolayout.run.editing import as_it_was, hung, supported, told
from robolayout.run.given import as_scene, as_start, as_text, completed, guesses_of, pinned_poses
from robolayout.run.result import Attempt, Clock, Progress, Result
from robolayout.run.verdict import make_judge
from robolayout.scene import DRESSINGS, Layout, Pose, Scene, load_agents
from robolayout.solve import (
    PAPER,
    UNREFINED,
    Solution,
    SolverConfig,
    compile_problem,
    dress,
    silent,
    solve_samples,
    solve_with,
    warm_up,
)
from robolayout.verify import AgentSpec, Report, overfull, physics, verify
from robolayout.words import Wishes, read_words


@dataclass(frozen=True)
class FlowConfig:
    """How many rooms are looked at, and how long one is tried."""

    ahead: int = 3  # rooms that are looked at before one is searched that is not right as it is built or guessed
    nearly: float = 4.0  # `Verdict.promise` up to which a room is mended at once: two things out of reach
    forlorn: float = 0.25  # share of assets amiss after all these programs from which on no other is asked for
    many: int = 70  # things from which on two programs are asked for at most
    coarse: float = 0.25  # metres of a cell of the search's floor from which on the report says so
    attempt_stride: int = 1000  # added to the planner's seed for each further attempt


FLOW = FlowConfig()


def generate(  # noqa: PLR0913 - the public page of everything that can be chosen
    scene: Scene | Mapping[str, Any] | str | Path,
    *,
    program: Program | str | Path | None = None,
    planner: Planner | None = None,
    agent: AgentSpec | Iterable[AgentSpec] | None = None,
    seed: int = 0,
    attempts: int = 4,
    solver: str = "default",
    config: SolverConfig | None = None,
    progress: Progress | None = None,
    start: Layout | Mapping[str, Any] | str | Path | None = None,
    keep: Sequence[str] = (),
    free: Sequence[str] = (),
    dress: str | None = None,
) -> Result:
    """Lay out a scene and verify the result.

    Args:
        scene: A scene, its dictionary, its file, or words that say what the room should be.
        program: A constraint program to use instead of planning: itself, its text, or its file as a `Path`.
        planner: Who writes the program; the offline planner if None.
        agent: The body or bodies to lay out for; the scene's own if None.
        seed: Settles every choice: same input and seed, same layout.
        attempts: Most programs that are asked for, while demands stay unmet and the offline planner's get better; the best is kept.
        solver: Name of a solver: "default", "paper", "paper-unrefined", "trust-constr" or "dual-annealing".
        config: Constants of the default solver.
        progress: Called with the name of each phase.
        start: A layout, its dictionary or its file, to mend with the least change; what it does not place is fitted in.
        keep: With `start`: names of assets that do not move at all.
        free: With `start`: names of the only ones that do, in place of `keep`.
        dress: How much lies about in the end: "none", "some" or "full"; what the scene says if None.

    Raises:
        SceneError: What must stand on the floor covers more than the floor; nothing is searched for.
    """
    whole(attempts, "attempts", 1)
    clock, say = Clock(), progress or silent
    with clock.station("scene"):
        planner = planner or OfflinePlanner()
        scene = as_scene(scene, planner, agent, seed=seed, dress=dress)
        if isinstance(planner, OfflinePlanner):
            scene = planner.recognised(scene)
        if too_full := overfull(scene):
            raise SceneError(too_full[0])  # counted before any search
        text = None if program is None else as_text(program)
    if solver == "default":
        traced = (config or SolverConfig()).trace  # a right guess needs no search, unless it is recorded
        warm_up(scene, config, missing_only=text is None and attempts > 1 and not traced)
    run = Run(scene, seed, solver, config, clock, say, read_words(scene))
    given = None if start is None else as_start(scene, start)
    pinned = pinned_poses(scene, given, keep, free)
    with clock.station("plan"):
        say("plan")
        groups = planner.group(scene)
    if given is None and text is None and isinstance(planner, GroupPlanner):
        return run.by_groups(planner, groups)
    if given is None:
        return run.result(run.whole(planner, text, attempts), groups)
    return run.result(told(run.edited(planner, text, given, pinned), given, pinned), groups)


@dataclass(frozen=True)
class _Try:
    """A program that is to be solved, from where it is `built` if that is known."""

    amiss: float  # how much is wrong with where its search starts
    seed: int
    asked: Program
    built: Layout | None = None


@dataclass(frozen=True)
class Run:
    """One call of `generate`: the loop over attempts; the loop over groups is in `groups`."""

    scene: Scene
    seed: int
    solver: str
    config: SolverConfig | None
    clock: Clock
    say: Progress
    wishes: Wishes = field(default_factory=Wishes)

    def result(self, best: Attempt, groups: tuple[Group, ...], who: Mapping[str, Any] | None = None) -> Result:
        """Return the judged result of what was found, with who planned where that was a model."""
        layout, report = best.solution.layout, self.reported(best)
        if who is not None:
            report = replace(report, planner=who)
        elif forgotten := best.asked.forgotten():
            report = report.with_notes((f"The program says nothing about {', '.join(forgotten)}.",))
        report = report.with_notes(best.asked.remarks)
        found = Result(self.scene, layout, report, best.asked, best.reconciled, groups, best.solution)
        return dressed(found, self.scene.dress, seed=self.seed)

    def whole(self, planner: Planner, program: str | None, attempts: int) -> Attempt:
        """Plan all assets at once; while demands stay unmet ask again, and keep the best."""
        best: Attempt | None = None
        least, seed = (math.inf, True), self.seed
        texts = self._texts(planner, program, attempts, lambda: best)
        waiting: list[_Try] = []
        for number in range(attempts):
            ahead = FLOW.ahead if best is None and attempts > 1 else 1
            while len(waiting) < ahead and (found := next(texts, None)) is not None:
                waiting.append(self._tried(*found, judged=ahead > 1))
                if waiting[-1].amiss <= FLOW.nearly:
                    break
            if not waiting:
                break
            waiting.sort(key=lambda entry: entry.amiss)
            tried = waiting.pop(0)
            found = self.finished(
                [tried.asked], self.scene, {}, seed=tried.seed, built=tried.built, ways=attempts == 1
            )[0]
            report = verify(self.scene, found.solution.layout, found.asked)
            # A thing that stands too high is nothing that the solver could move, but another program may put it lower,
            # and meet what the words ask for beside its statements: a way for the body.
            fine = report.ok and (not isinstance(planner, OfflinePlanner) or self._meant(found.solution.layout, report))
            rank = (found.solution.verdict.merit, not fine)
            if best is None or rank < least:
                best, least, seed = found, rank, tried.seed
            elif isinstance(planner, OfflinePlanner) and not best.solution.verdict.ok:
                break  # the search no longer gains; who hears what was wrong may do better the next time
            verdict = found.solution.verdict
            served = fine and not verdict.barred  # the judge asks for more free floor than the report demands
            if served or (verdict.ok and (any(one.impossible for one in report.agents) or found.denied(report))):
                break
            lost, things = best.solution.verdict.hard + best.solution.verdict.access, len(self.scene.assets)
            if (number and things > FLOW.many) or (number + 1 >= FLOW.ahead and lost > FLOW.forlorn * things):
                break
        assert best is not None
        if attempts == 1 or self.solver != "default":
            return best
        with self.clock.station("solve"):
            given: dict[str, Any] = {"seed": seed, "config": self.config, "progress": self.say}
            return replace(best, solution=bettered(self.scene, best.reconciled.program, best.solution, **given))

    def _meant(self, layout: Layout, report: Report) -> bool:
        """Return whether a layout leaves nothing unmet that the words ask for."""
        asked = self.wishes.judged(self.scene, layout, report.agents[0].navigation.main)
        return all(row.verdict != "unmet" for row in asked)

    def edited(self, planner: Planner, program: str | None, start: Layout, pinned: Mapping[str, Pose]) -> Attempt:
        """Mend a layout with the least change; what it does not place is planned and fitted in."""
        start = hung(self.scene, start, pinned, seed=self.seed)
        if program is None:
            with self.clock.station("plan"):
                placed = supported(self.scene, start, pinned)
                program = planner.plan(
                    PlanRequest(self.scene, placed=placed, seed=self.seed, asked=self.wishes.demands)
                )
        asked = self._read(program, start)
        (least,) = self.finished([asked], self.scene, pinned)
        if self.solver != "default" or not least.solution.verdict.moved:
            return least
        usual = as_it_was(asked, self.scene, start, seed=self.seed)
        return min((least, *self.finished([usual], self.scene, pinned)), key=lambda one: one.solution.verdict.worth)

    def _texts(
        self, planner: Planner, program: str | None, attempts: int, best: Callable[[], Attempt | None]
    ) -> Generator[tuple[int, Program]]:
        """Yield programs with seeds: what a planner answers to the same question, as long as there is anything new in it."""
        known = set[str]()
        for number in range(attempts):
            seed, text = self.seed + FLOW.attempt_stride * number, program
            if text is None:
                with self.clock.station("plan"):
                    before = best()
                    feedback = before.solution.message if before else ""
                    text = planner.plan(
                        PlanRequest(self.scene, seed=seed, feedback=feedback, asked=self.wishes.demands)
                    )
            asked = self._read(text)
            if text in known and asked.complete:
                return
            known.add(text)
            yield seed, asked

    def _read(self, text: str, start: Layout | None = None) -> Program:
        with self.clock.station("program"):
            self.say("program")
            asked = self.wishes.marked(read_program(text, self.scene))
            asked = replace(asked, guesses={**asked.guesses, **guesses_of(start or {})}, mends=start is not None)
            return completed(asked, self.scene, seed=self.seed) if self.solver == "default" else asked

    def _tried(self, seed: int, asked: Program, *, judged: bool) -> _Try:
        """Return a program with the room that is built from it, or that it gives, and how much is wrong with that."""
        if not judged:
            return _Try(0.0, seed, asked)
        with self.clock.station("program"):
            program = self.filtered(asked, self.scene).program
        with self.clock.station("solve"):
            built = compile_problem(self.scene, program, seed=seed).guess
            return _Try(make_judge(self.scene, program)(built).promise, seed, asked, built)

    def by_groups(self, planner: GroupPlanner, groups: tuple[Group, ...]) -> Result:
        """Plan with a model, group by group; the report says who planned."""
        from robolayout.run.groups import GroupedRun

        planned = GroupedRun(self, planner)
        best, groups, told = planned.run(groups)
        parts = [told]
        if isinstance(planner, Critic) and planner.critic:
            from robolayout.run.critic import CriticPass

            best, said = CriticPass(self, planner).run(best)
            parts.append(said.to_dict())
        parts = [planner.to_dict(), *parts]  # what all of it cost is known now
        sentences = [sentence for part in parts for sentence in part["sentences"]]
        who = {key: value for part in parts for key, value in part.items()} | {"sentences": sentences}
        return replace(self.result(best, groups, who), samples=tuple(planned.samples))

    def reported(self, best: Attempt) -> Report:
        """Judge the whole layout, and look what unmet statements lost to."""
        self.say("verify")
        layout = best.solution.layout
        report = verify(self.scene, layout, best.asked)
        against: dict[int, str] = {}
        if any(not item.met for item in report.statements):
            from robolayout.run.conflicts import conflicts

            with self.clock.station("conflicts"):
                against = conflicts(self.scene, best.reconciled, layout, self.wishes.said, seed=self.seed)
                report = report.with_conflicts(against)
        lost = {s.relation: against[s.number] for s in best.asked.statements if s.number in against}
        report = replace(report, asked=self.wishes.judged(self.scene, layout, report.agents[0].navigation.main, lost))
        cell = cell_size(self.scene.room, (self.config or SolverConfig()).cell, FLOOR.route_cells)
        if cell > FLOW.coarse:
            note = f"The room is so large that the search looks for ways on cells of {cell:.2f} m: it may miss narrower gaps."
            report = report.with_notes((f"{note} This report measures exactly.",))
        return report.with_timing(self.clock.seconds)

    def prepare(self, here: Scene) -> None:
        """Warm up for solving programs of a scene."""
        if self.solver == "default":
            warm_up(here, self.config)

    def filtered(self, asked: Program, here: Scene) -> Reconciled:
        """Filter a program for a scene, as the solver wants it."""
        return reconcile(asked, here, paper=self.solver in (PAPER, UNREFINED))

    def finished(
        self,
        asked: Sequence[Program],
        here: Scene,
        placed: Mapping[str, Pose],
        *,
        seed: int | None = None,
        built: Layout | None = None,
        ways: bool = True,
    ) -> list[Attempt]:
        """Filter and solve programs for a scene, together; the poses given stay."""
        seed = self.seed if seed is None else seed
        given: dict[str, Any] = {"seed": seed, "config": self.config, "progress": self.say}
        known: dict[str, Any] = {"pinned": placed, "built": built}
        with self.clock.station("program"):
            reconciled = [self.filtered(program, here) for program in asked]
            programs = [found.program for found in reconciled]
        with self.clock.station("solve"):
            if self.solver != "default" or len(programs) == 1:
                given |= {"solver": self.solver, "ways": ways, **known}
                solutions = [solve(here, program, **given) for program in programs]
            else:  # most of the effort goes into the best of them
                problems = [compile_problem(here, program, seed=seed, **known) for program in programs]
                solutions = solve_samples(problems, [make_judge(here, program) for program in programs], **given)
        return [Attempt(*parts) for parts in zip(asked, reconciled, solutions, strict=True)]


def solve(  # noqa: PLR0913 - as `generate`
    scene: Scene,
    program: Program | str,
    *,
    seed: int = 0,
    solver: str = "default",
    config: SolverConfig | None = None,
    pinned: Mapping[str, Pose] | None = None,
    progress: Progress | None = None,
    built: Layout | None = None,
    ways: bool = True,
) -> Solution:
    """Solve a program, selecting by exact verification.

    Args:
        solver: Name of a solver: "default", "paper", "paper-unrefined", "trust-constr" or "dual-annealing".
        ways: Whether what is left of a room that is not right is mended for longer, and other ways of statements that leave one open
            are tried by themselves.
    """
    if isinstance(program, str):
        program = reconcile(read_program(program, scene), scene, paper=solver in (PAPER, UNREFINED)).program
    problem = compile_problem(scene, program, seed=seed, pinned=pinned, built=built)
    judge = make_judge(scene, program)
    best = solve_with(solver, problem, judge, seed=seed, config=config, progress=progress)
    if not ways or solver != "default":
        return best
    return bettered(scene, program, best, seed=seed, config=config, pinned=pinned, progress=progress)


def compare(scene: Scene, agents: AgentSpec | Iterable[AgentSpec], **options: Any) -> tuple[Result, ...]:
    """Lay out one scene for several bodies, one after the other; the options are those of `generate`."""
    return tuple(generate(scene, agent=agent, **options) for agent in load_agents(agents))


def dressed(result: Result, amount: str, *, seed: int) -> Result:
    """Return a run's room with small things on its surfaces (`DRESSINGS`); what the judge does not pass is left out."""
    clock, before = Clock(), result.layout
    with clock.station("dress"):
        found = dress(result.scene, before, amount, seed=seed)
        astray = set(physics(found.scene, found.layout).failing) - set(before)
    if not set(found.names) - astray:
        return result
    assets = tuple(asset for asset in found.scene.assets if asset.name not in astray)
    layout = Layout({name: pose for name, pose in found.layout.items() if name not in astray})
    scene = replace(found.scene, assets=assets, dress=DRESSINGS[0])  # it is done
    new = verify(scene, layout)
    report = replace(result.report, scene=scene, layout=layout, physics=new.physics, agents=new.agents)
    return replace(result, scene=scene, layout=layout, report=report.with_timing(clock.seconds))
