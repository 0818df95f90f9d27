"""Planning with a model: one group after the other, samples, feedback and retries, and the offline planner as the last resort.

Every answer is read, filtered, solved and verified; the samples of one question are solved together. What could not be read,
was rejected, was forgotten, or is not met goes back to the model. The best verified answer of a group is kept, whenever it came.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from robolayout._errors import AnswerError, BudgetError, ModelError, ProgramError
from robolayout._text import printable
from robolayout.planners import Group, GroupPlanner, OfflinePlanner, PlanRequest, Score, feedback_text, score_samples
from robolayout.program import Guess, Program, Statement, read_program, read_salvaged
from robolayout.run.attempt import Attempt, Clock, Finisher, Progress, joined_traces
from robolayout.scene import Layout, Pose, Scene, Trace
from robolayout.verify import Report, verify


@dataclass(frozen=True)
class Sample:
    """One answer of a model and what came of it.

    Attributes:
        group: Label of the group that it was asked for.
        attempt: How often the group was asked for before, plus one.
        number: Which of the answers to that question, from 1.
        text: The answer.
        score: What it achieves; None if it could not be read.
        error: Why it, or what was left out of it, could not be read.
        layout: Where it puts the things of the group.
        kept: Whether this one was taken.
    """

    group: str
    attempt: int
    number: int
    text: str
    score: Score | None = None
    error: str = ""
    layout: Layout | None = None
    kept: bool = False

    def to_dict(self) -> dict[str, Any]:
        """Return the sample as it is written to `samples.json`."""
        return {
            "group": self.group,
            "attempt": self.attempt,
            "sample": self.number,
            "kept": self.kept,
            "score": self.score and self.score.to_dict(),
            "error": self.error or None,
            "program": self.text,
            "layout": self.layout and self.layout.to_dict(),
        }


@dataclass(frozen=True)
class Planned:
    """What came of planning with a model.

    Attributes:
        attempt: The whole program and its solution.
        groups: The groups as they were planned.
        samples: All answers, in the order in which they were given.
        taken_over: Why the offline planner planned a group, by its label.
        given_up: Why a group was not asked for again though something was wrong, by its label.
        left_out: What the kept answers say that could not be read, and what they say nothing about, in sentences.
    """

    attempt: Attempt
    groups: tuple[Group, ...]
    samples: tuple[Sample, ...]
    taken_over: Mapping[str, str]
    given_up: Mapping[str, str]
    left_out: tuple[str, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return what the report says of it: what was taken over, and all of it in sentences."""
        readable = sum(sample.score is not None for sample in self.samples)
        sentences = [
            f"{len(self.samples)} programs were given for {len(self.groups)} groups, {readable} of them could be read.",
            *(f"The offline planner took over group {label!r}: {why}" for label, why in self.taken_over.items()),
            *(f"Group {label!r} was not asked for again: {why}" for label, why in self.given_up.items()),
            *self.left_out,
        ]
        return {"taken_over": dict(self.taken_over), "given_up": dict(self.given_up), "sentences": sentences}


@dataclass(frozen=True)
class _Candidate:
    """One readable answer for a group, solved and verified."""

    sample: Sample
    attempt: Attempt
    report: Report
    forgotten: tuple[str, ...]
    strays: tuple[str, ...]
    own: frozenset[int]
    cut: bool

    @property
    def done(self) -> bool:
        """Whether there is nothing to ask for again."""
        return self.attempt.solution.verdict.ok and not self.forgotten and not self.attempt.asked.dropped

    def left_out(self) -> Iterator[str]:
        """Yield what the report says of what it does not say, or says in vain."""
        for message in self.attempt.asked.dropped:
            yield f"Left out of the program: {' '.join(message.split())}"
        if self.forgotten:
            yield f"The program says nothing about {', '.join(self.forgotten)}; the solver found places for them."

    def feedback(self) -> str:
        """Return what to tell the model about it."""
        decisions = self.attempt.reconciled.decisions
        rejected = [d.sentence for d in decisions if d.verdict == "rejected" and d.statement.number in self.own]
        return feedback_text(
            cut=self.cut,
            dropped=self.attempt.asked.dropped,
            rejections=[*rejected, *self.strays],
            violations=self.report.violations,
            forgotten=self.forgotten,
        )


@dataclass
class _Question:
    """One group in the room as it stands."""

    here: Scene
    group: Group
    placed: Mapping[str, Pose]
    before: tuple[Statement, ...]
    images: Mapping[str, bytes] = field(default_factory=dict[str, bytes])
    samples: list[Sample] = field(default_factory=list[Sample])
    candidates: list[_Candidate] = field(default_factory=list[_Candidate])

    def best(self) -> _Candidate | None:
        """Return the candidate that the judge likes best: hard demands, access, statements; then few things forgotten."""
        if not self.candidates:
            return None
        scores = self.scores()
        keys = [
            (*(-part for part in score.key[:3]), len(one.forgotten), -score.key[3], i)
            for i, (score, one) in enumerate(zip(scores, self.candidates, strict=True))
        ]
        return self.candidates[min(keys)[-1]]

    def scores(self) -> tuple[Score, ...]:
        """Return the scores of all candidates."""
        return score_samples(
            [one.report.figures for one in self.candidates], [one.attempt.asked for one in self.candidates]
        )

    def records(self) -> Iterator[Sample]:
        """Yield all answers with their scores."""
        best = self.best()
        scored = {id(one.sample): (one, score) for one, score in zip(self.candidates, self.scores(), strict=True)}
        for sample in self.samples:
            if id(sample) not in scored:
                yield sample
                continue
            one, score = scored[id(sample)]
            mine = {name: pose for name, pose in one.attempt.solution.layout.items() if name in self.group.items}
            yield replace(sample, score=score, layout=Layout(mine), kept=one is best)


class GroupedRun:
    """The loop over groups.

    Args:
        scene: What is given.
        planner: Who is asked.
        finisher: Filters and solves programs.
        seed: Settles every choice.
        clock: Where seconds are counted.
        say: Told the name of each phase.
    """

    def __init__(
        self,
        scene: Scene,
        planner: GroupPlanner,
        finisher: Finisher,
        *,
        seed: int,
        clock: Clock,
        say: Progress,
    ) -> None:
        self.scene, self.planner, self.finisher = scene, planner, finisher
        self.seed, self.clock, self.say = seed, clock, say
        self._answered = False
        self._samples: list[Sample] = []
        self._taken_over: dict[str, str] = {}
        self._given_up: dict[str, str] = {}
        self._left_out: list[str] = []

    def run(self, groups: tuple[Group, ...]) -> Planned:
        """Plan one group after the other; what is placed stays, and what is said stays said."""
        placed: dict[str, Pose] = {}
        best: Attempt | None = None
        parts: list[tuple[Group, Program]] = []
        traces: list[Trace] = []
        self._answered = len(groups) > 1
        for group in groups:
            names = {*placed, *group.items}
            here = replace(self.scene, assets=tuple(asset for asset in self.scene.assets if asset.name in names))
            before = best.asked.statements if best else ()
            best = self._group(_Question(here, group, placed, before))
            parts.append((group, replace(best.asked, statements=best.asked.statements[len(before) :])))
            placed = dict(best.solution.layout)
            traces.append(best.solution.trace)
        assert best is not None
        if not best.solution.verdict.ok and (len(parts) > 1 or self.planner.samples > 1):
            best = self._once_more(best, traces, alone=len(parts) == 1)
        if len(parts) > 1 or self.planner.mode == "no_constraint":
            best = self._joint(best, parts, traces)
        done = tuple(replace(group, rationale=self._rationale(group)) for group in groups)
        return Planned(best, done, tuple(self._samples), self._taken_over, self._given_up, tuple(self._left_out))

    def _rationale(self, group: Group) -> str:
        taken = group.label in self._taken_over
        return group.rationale + (" Planned by the offline planner in place of the model." if taken else "")

    def _joint(self, last: Attempt, parts: list[tuple[Group, Program]], traces: list[Trace]) -> Attempt:
        """Return the whole program, in plain statements, with its layout."""
        whole = joined(parts)
        return Attempt(
            whole, self.finisher.filtered(whole, self.scene), replace(last.solution, trace=joined_traces(traces))
        )

    def _once_more(self, last: Attempt, traces: list[Trace], *, alone: bool) -> Attempt:
        """Return the same program solved once more by itself, if that is better.

        From where its things are, with all free to move; one that is `alone`, first as it would be without other samples.
        """
        guesses = {name: Guess((p.x, p.y, p.z), p.yaw) for name, p in last.solution.layout.items()}
        there = replace(last.asked, guesses=guesses)
        for asked in (last.asked, there) if alone else (there,):
            (again,) = self.finisher.finished([asked], self.scene, {})
            if again.solution.verdict.merit < last.solution.verdict.merit:
                traces.append(again.solution.trace)
                return replace(last, solution=replace(again.solution, trace=joined_traces(traces)))
        return last

    def _group(self, question: _Question) -> Attempt:
        """Ask for one group, tell what was wrong, and ask again; the offline planner takes over if nothing is usable."""
        self.finisher.prepare(question.here, self.planner.samples)
        feedback, previous, failure = "", "", ""
        question.images = self._images(question)
        for number in range(1, 2 + self.planner.retries):
            request = self._request(question, feedback, previous)
            try:
                with self.clock.station("plan"):
                    self.say("plan")
                    texts = self.planner.plan_many(request, self.planner.samples)
            except AnswerError as error:
                failure = str(error)
                continue
            except ModelError as error:
                if not (self._answered or failure or isinstance(error, BudgetError)):
                    raise
                failure = str(error)
                break
            failure = ""
            self._answered = True
            wrong = self._try(question, texts, number)
            best = question.best()
            if best is None:
                previous, feedback = wrong
                continue
            if best.done:
                break
            asked = best.attempt.asked
            previous, feedback = best.sample.text if asked.dropped else asked.text, best.feedback()
        best = question.best()
        self._samples += question.records()
        if best is None:
            self._taken_over[question.group.label] = failure or "none of its programs could be read."
            return self._offline(question)
        if failure:
            self._given_up[question.group.label] = failure
        self._left_out += best.left_out()
        return best.attempt

    def _offline(self, question: _Question) -> Attempt:
        """Plan a group by rules."""
        text = OfflinePlanner().plan(PlanRequest(self.scene, question.group, Layout(question.placed), seed=self.seed))
        asked = about(read_program(text, self.scene), question.group, question.here, question.before)
        return self.finisher.finished([asked], question.here, question.placed)[0]

    def _request(self, question: _Question, feedback: str, previous: str) -> PlanRequest:
        placed = Layout(question.placed)
        return PlanRequest(self.scene, question.group, placed, feedback, self.seed, previous, images=question.images)

    def _try(self, question: _Question, texts: Sequence[str], attempt: int) -> tuple[str, str]:
        """Solve and verify the answers that can be read, together; return the last one that cannot be, and why."""
        wrong = ("", "")
        readable: list[tuple[Sample, Program, Program]] = []
        for number, text in enumerate(texts, 1):
            sample = Sample(question.group.label, attempt, number, text)
            try:
                with self.clock.station("program"):
                    self.say("program")
                    read = read_salvaged(text, self.scene)
                if self.planner.mode == "no_constraint":
                    read = replace(read, statements=())
                sample = replace(sample, error="\n".join(read.dropped))
                readable.append((sample, read, about(read, question.group, question.here, question.before)))
            except ProgramError as error:
                sample = replace(sample, error=str(error))
                wrong = (text, feedback_text(error=error, cut=self.planner.cut_off(text)))
            question.samples.append(sample)
        if readable:
            found = self.finisher.finished([asked for *_, asked in readable], question.here, question.placed)
            question.candidates += [
                self._candidate(question, sample, read, attempt)
                for (sample, read, _), attempt in zip(readable, found, strict=True)
            ]
        return wrong

    def _candidate(self, question: _Question, sample: Sample, read: Program, attempt: Attempt) -> _Candidate:
        with self.clock.station("verify"):
            report = verify(question.here, attempt.solution.layout, attempt.asked)
        own = attempt.asked.statements[len(question.before) :]
        said = {name for statement in own for name in statement.relation.asset_names()} | set(attempt.asked.guesses)
        return _Candidate(
            sample,
            attempt,
            report,
            tuple(read.expressions.get(name, name) for name in question.group.items if name not in said),
            tuple(_strays(read, question.group, question.here)),
            frozenset(statement.number for statement in own),
            self.planner.cut_off(sample.text),
        )

    def _images(self, question: _Question) -> dict[str, bytes]:
        """Return the annotated room as it stands and one picture per new kind of asset."""
        here, layout = question.here, Layout(question.placed)
        kinds = {here.by_name[name].variable: name for name in reversed(question.group.items)}
        if self.planner.pictures == "none":
            return {}
        if self.planner.pictures == "named":
            return dict.fromkeys(("top", "side", *sorted(kinds.values())), b"")
        from robolayout.render import annotate, png_bytes, render_asset

        with self.clock.station("pictures"):
            images = {view: png_bytes(annotate(here, layout, view=view)) for view in ("top", "side")}
            return images | {name: png_bytes(render_asset(here.by_name[name])) for name in sorted(kinds.values())}


def about(program: Program, group: Group, here: Scene, before: tuple[Statement, ...]) -> Program:
    """Return what a program says about a group and things already there, after the earlier groups' statements."""
    mine = set(group.items)
    new = [statement for statement in program.statements if _concerns(statement, mine, here)]
    numbered = tuple(replace(statement, number=i) for i, statement in enumerate((*before, *new), 1))
    return replace(program, statements=numbered, guesses={n: g for n, g in program.guesses.items() if n in mine})


def joined(parts: Sequence[tuple[Group, Program]]) -> Program:
    """Return one program that says what the groups' programs say, in plain statements under a heading for each group.

    Args:
        parts: Each group with its own statements and guesses.
    """
    lines: list[str] = []
    statements: list[Statement] = []
    guesses: dict[str, Guess] = {}
    for group, part in parts:
        heading = printable(f"{group.label}: {group.rationale}")
        lines.append(f"# {heading.strip(': ')}")
        lines += part.to_text().splitlines()
        for i, statement in enumerate(part.statements):
            line = len(lines) - len(part.statements) + 1 + i
            statements.append(Statement(statement.relation, line, lines[line - 1], len(statements) + 1))
        guesses |= part.guesses
    text = "".join(f"{line}\n" for line in lines)
    expressions = {name: text for _, part in parts for name, text in part.expressions.items()}
    notes = tuple(note for _, part in parts for note in part.notes)
    dropped = tuple(message for _, part in parts for message in part.dropped)
    return Program(text, tuple(statements), guesses, notes, dropped, expressions)


def _concerns(statement: Statement, mine: set[str], here: Scene) -> bool:
    """Return whether a statement is about things of a group, and about nothing that is not there yet."""
    names = set(statement.relation.asset_names())
    return bool(names & mine) and names <= set(here.by_name)


def _strays(program: Program, group: Group, here: Scene) -> Iterator[str]:
    """Yield what is wrong with statements that are left out because of the things that they are about."""
    mine = set(group.items)
    for statement in program.statements:
        if not _concerns(statement, mine, here):
            later = [n for n in statement.relation.asset_names() if n not in here.by_name]
            names = ", ".join(program.expressions.get(name, name) for name in later)
            reason = f"{names} comes later" if later else "it is not about a thing of this group"
            yield f"line {statement.line}: {statement.source}: {reason}."
