"""Planning with a model: one group after the other, samples, feedback and retries, and the offline planner as the last resort.

Every answer is read, filtered, solved and verified; the samples of one question are solved together. What could not be read,
was rejected, was forgotten, or is not met goes back to the model, with a picture of what came of it. The best verified answer
of a group is kept, whenever it came. A group may ask for an earlier one to be planned again, each at most once.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from robolayout._errors import AnswerError, ModelError, ProgramError, UnavailableError
from robolayout._text import printable
from robolayout.planners import USELESS, Feedback, Group, GroupPlanner, OfflinePlanner, PlanRequest
from robolayout.program import Guess, Program, Statement, read_program, read_salvaged
from robolayout.run.answers import Candidate, GroupQuestion, Sample
from robolayout.run.diff import without_figures
from robolayout.run.given import guesses_of
from robolayout.run.result import Attempt, joined_traces
from robolayout.run.sight import failed_picture, room_pictures
from robolayout.scene import Layout, Scene, Trace
from robolayout.verify import Report, verify

if TYPE_CHECKING:
    from robolayout.run.flow import Run


Stand = tuple[GroupQuestion, Candidate]  # a group that is planned: what was asked, in which room, and what was kept


class GroupedRun:
    """The loop over groups of one run."""

    def __init__(self, whole: Run, planner: GroupPlanner) -> None:
        self.whole, self.planner = whole, planner
        self.scene, self.wishes, self.clock, self.say = whole.scene, whole.wishes, whole.clock, whole.say
        self._answered = False
        self._tries = Counter[str]()
        self.samples: list[Sample] = []  # all answers, in the order in which they were given
        self._said: dict[str, str] = {}
        self._taken_over: dict[str, str] = {}  # why the offline planner planned a group, by its label
        self._given_up: dict[str, str] = {}  # why a group was not asked for again though something was wrong
        self._reopened: dict[str, str] = {}  # why a group was planned again for the sake of a later one
        self._gone: ModelError | None = None  # nobody waits for a dead server once for each group

    def run(self, groups: tuple[Group, ...]) -> tuple[Attempt, tuple[Group, ...], dict[str, Any]]:
        """Plan one group after the other; what is placed stays, and what is said stays said.

        Return the whole program with its solution, the groups as they were planned, and what the report says of it.
        """
        stands: list[Stand] = []
        self._answered = len(groups) > 1
        while len(stands) < len(groups):
            question = self._question(groups[: len(stands) + 1], stands)
            planned = self._group(question)
            self.samples += question.records()
            if isinstance(planned, Candidate):
                stands.append((question, planned))
            else:
                self._reopen(groups, stands, *planned)
        best, traces = stands[-1][1].attempt, [one.attempt.solution.trace for _, one in stands]
        if not best.solution.verdict.ok and (len(groups) > 1 or self.planner.samples > 1):
            best = self._once_more(best, traces, alone=len(groups) == 1)
        if len(groups) > 1 or self.planner.mode == "no_constraint":
            said = [(question, one.attempt.asked) for question, one in stands]
            whole = joined([(q.group, replace(p, statements=p.statements[len(q.before) :])) for q, p in said])
            found = replace(best.solution, trace=joined_traces(traces))
            best = Attempt(whole, self.whole.filtered(whole, self.scene), found)
        other = " Planned by the offline planner in place of the model."
        done = tuple(replace(g, rationale=g.rationale + other * (g.label in self._taken_over)) for g in groups)
        return best, done, self._told(stands)

    def _told(self, stands: Sequence[Stand]) -> dict[str, Any]:
        """Return what the report says: what was taken over, and all of it in sentences."""
        readable = sum(sample.score is not None for sample in self.samples)
        sentences = [
            f"{len(self.samples)} programs were given for {len(stands)} groups, {readable} of them could be read.",
            *(f"The offline planner took over group {label!r}: {why}" for label, why in self._taken_over.items()),
            *(f"Group {label!r} was not asked for again: {why}" for label, why in self._given_up.items()),
            *(f"Group {label!r} was planned again: {why}" for label, why in self._reopened.items()),
            *(sentence for _, one in stands for sentence in one.left_out()),
        ]
        return {"taken_over": self._taken_over, "given_up": self._given_up, "sentences": sentences}

    def _question(self, groups: tuple[Group, ...], stands: list[Stand]) -> GroupQuestion:
        """Return the question for the last of the groups, in the room as the earlier ones left it."""
        names = {name for group in groups for name in group.items}
        here = replace(self.scene, assets=tuple(asset for asset in self.scene.assets if asset.name in names))
        if not stands:
            return GroupQuestion(here, groups[-1], {}, ())
        last = stands[-1][1]
        known = frozenset(map(without_figures, last.report.violations))
        earlier = tuple(group.label for group in groups[:-1] if group.label not in self._reopened)
        placed, before = dict(last.attempt.solution.layout), last.attempt.asked.statements
        return GroupQuestion(here, groups[-1], placed, before, known, earlier)

    def _reopen(self, groups: tuple[Group, ...], stands: list[Stand], wanted: str, why: str, text: str) -> None:
        """Go back to before an earlier group; what was said of the groups after it is tried again before they are asked."""
        first = next(i for i, group in enumerate(groups) if group.label == wanted)
        asking = groups[len(stands)].label
        self._reopened[wanted] = f"group {asking!r}, which comes later, asks for it: {why}"
        self._said |= {question.group.label: one.sample.text for question, one in stands if one.sample.text}
        self._said[asking] = text
        again = {group.label for group in groups[first:]}
        self.samples = [replace(s, kept=s.kept and s.group not in again) for s in self.samples]
        for label in again:
            self._taken_over.pop(label, None)
            self._given_up.pop(label, None)
        del stands[first:]

    def _once_more(self, last: Attempt, traces: list[Trace], *, alone: bool) -> Attempt:
        """Return the same program solved once more by itself, if that is better."""
        there = replace(last.asked, guesses=guesses_of(last.solution.layout))
        for asked in (last.asked, there) if alone else (there,):
            (again,) = self.whole.finished([asked], self.scene, {})
            if again.solution.verdict.merit < last.solution.verdict.merit:
                traces.append(again.solution.trace)
                return replace(last, solution=replace(again.solution, trace=joined_traces(traces)))
        return last

    def _group(self, question: GroupQuestion) -> Candidate | tuple[str, str, str]:
        """Ask for one group, tell what was wrong, and ask again; the offline planner takes over if nothing is usable.

        Where it wishes that an earlier group be planned again, return that one's label, why, and its own program.
        """
        label, failure = question.group.label, ""
        self.whole.prepare(question.here)
        feedback, said = self._reopened.get(label, ""), self._said.pop(label, "")
        previous = said
        if said and not feedback:  # it was said before an earlier group was planned again, and may still do
            feedback, previous = self._try(question, [said], self._tries[label])
        with self.clock.station("pictures"):
            new, drawn = question.group.items, self.planner.pictures
            question.images = room_pictures(question.here, Layout(question.placed), new, drawn)
        for _ in range(1 + self.planner.retries):
            if (best := question.best()) and best.done:
                break
            answer = self._gone or self._asked(question, feedback, previous)
            if isinstance(answer, ModelError):
                if not (self._answered or failure or isinstance(answer, USELESS)):
                    raise answer
                failure = str(answer)
                if isinstance(answer, AnswerError):
                    continue
                self._gone = answer if isinstance(answer, UnavailableError) and best is None else self._gone
                break
            failure, self._answered = "", True
            feedback, previous = self._try(question, answer, self._tries[label])
            best, wish = question.best(), question.reopening(answer)
            if wish is not None and not (best and best.done):
                return wish
        if question.best() is None and said:
            self._try(question, [said], self._tries[label])
        return self._kept(question, failure)

    def _kept(self, question: GroupQuestion, failure: str) -> Candidate:
        """Return the best of the answers to a question, or what the offline planner makes of the group."""
        label, best = question.group.label, question.best()
        if best is not None:
            self._given_up |= {label: failure} if failure else {}
            return best
        self._taken_over[label] = failure or "none of its programs could be read."
        placed = Layout(question.placed)
        request = PlanRequest(self.scene, question.group, placed, seed=self.whole.seed, asked=self.wishes.demands)
        read = read_program(OfflinePlanner().plan(request), self.scene)
        asked = about(read, question.group, question.here, question.before)
        (attempt,) = self.whole.finished([asked], question.here, question.placed)
        return Candidate(Sample(label, 0, 0, ""), attempt, self._judged(question, attempt))

    def _asked(self, question: GroupQuestion, feedback: str, previous: str) -> tuple[str, ...] | ModelError:
        """Ask for programs once; the failure if none came."""
        group = question.group
        self._tries[group.label] += 1
        request = PlanRequest(
            self.scene,
            group,
            Layout(question.placed),
            feedback,
            self.whole.seed,
            previous=previous,
            images=question.images if feedback else {k: v for k, v in question.images.items() if k != "failed"},
            reopen=question.earlier if feedback else (),
        )
        try:
            with self.clock.station("plan"):
                self.say(f"plan {group.label}, attempt {self._tries[group.label]}, {self.planner.bill} so far")
                return self.planner.plan_many(request, self.planner.samples)
        except ModelError as error:
            return error

    def _try(self, question: GroupQuestion, texts: Sequence[str], attempt: int) -> tuple[str, str]:
        """Solve and verify the answers that can be read, together; return what to tell of them, and the program it is about."""
        wrong = ("", "")
        readable: list[tuple[Sample, Program, Program]] = []
        for number, text in enumerate(texts, 1):
            sample = Sample(question.group.label, attempt, number, text)
            try:
                with self.clock.station("program"):
                    self.say("program")
                    read = read_salvaged(text, self.scene)
                if self.planner.mode == "no_constraint":
                    read = replace(read, statements=(), wishes=())
                sample = replace(sample, error="\n".join(read.dropped))
                readable.append((sample, read, about(read, question.group, question.here, question.before)))
            except ProgramError as error:
                sample = replace(sample, error=str(error))
                wrong = (Feedback(error=error, cut=self.planner.cut_off(text)).text(), text)
            question.samples.append(sample)
        if readable:
            found = self.whole.finished([asked for *_, asked in readable], question.here, question.placed)
            question.candidates += [
                self._candidate(question, sample, read, attempt)
                for (sample, read, _), attempt in zip(readable, found, strict=True)
            ]
        best = question.best()
        if best is None or best.done:
            return wrong
        if self.planner.pictures != "none":
            drawn, mine = self.planner.pictures == "drawn", set(question.group.items)
            with self.clock.station("pictures"):
                failed = failed_picture(best.report, best.attempt.asked, mine) if drawn else b""
            question.images = {**question.images, "failed": failed}
        return best.feedback(question), best.previous

    def _candidate(self, question: GroupQuestion, sample: Sample, read: Program, attempt: Attempt) -> Candidate:
        report = self._judged(question, attempt)
        own: tuple[Statement, ...] = attempt.asked.statements[len(question.before) :]
        told = (*own, *attempt.asked.wishes)
        said = {name for one in told for name in one.relation.asset_names()} | set(attempt.asked.guesses)
        return Candidate(
            sample,
            attempt,
            report,
            () if attempt.solution.verdict.ok and not report.asked else question.wrong(report),
            tuple(read.expressions.get(name, name) for name in question.group.items if name not in said),
            tuple(strays(read, question.group, question.here)),
            frozenset(statement.number for statement in own),
            self.planner.cut_off(sample.text),
        )

    def _judged(self, question: GroupQuestion, attempt: Attempt) -> Report:
        """Return what the judge says, and with everything placed what is met of the places that the user's words ask for."""
        layout = attempt.solution.layout
        with self.clock.station("verify"):
            report = verify(question.here, layout, attempt.asked)
            if len(layout) < len(self.scene.assets):
                return report
            rows = self.wishes.judged(self.scene, layout)
        return replace(report, asked=tuple(row for row in rows if row.kind == "relation"))


def about(program: Program, group: Group, here: Scene, before: tuple[Statement, ...]) -> Program:
    """Return what a program says about a group and things already there, after the earlier groups' statements."""
    mine = set(group.items)
    new = [statement for statement in program.statements if _concerns(statement, mine, here)]
    numbered = tuple(replace(statement, number=i) for i, statement in enumerate((*before, *new), 1))
    guesses = {name: guess for name, guess in program.guesses.items() if name in mine}
    wishes = tuple(wish for wish in program.wishes if _concerns(wish, mine, here))
    return replace(program, statements=numbered, wishes=wishes, guesses=guesses)


def joined(parts: Sequence[tuple[Group, Program]]) -> Program:
    """Return one program that says what the groups' programs say, in plain statements under a heading for each group."""
    lines, statements, wishes = list[str](), list[Statement](), list[Statement]()
    guesses: dict[str, Guess] = {}
    for group, part in parts:
        lines.append(f"# {printable(f'{group.label}: {group.rationale}').strip(': ')}")
        lines += part.to_text().splitlines()
        own = (*part.statements, *part.wishes)
        for line, statement in enumerate(own, len(lines) - len(own) + 1):
            kept = statements if statement.wish is None else wishes
            kept.append(replace(statement, line=line, source=lines[line - 1], number=len(kept) + 1))
        guesses |= part.guesses
    text = "".join(f"{line}\n" for line in lines)
    expressions = {name: text for _, part in parts for name, text in part.expressions.items()}
    notes = tuple(note for _, part in parts for note in part.notes)
    dropped = tuple(message for _, part in parts for message in part.dropped)
    remarks = tuple(remark for _, part in parts for remark in part.remarks)
    return Program(text, tuple(statements), guesses, notes, dropped, expressions, tuple(wishes), remarks)


def _concerns(statement: Statement, mine: set[str], here: Scene) -> bool:
    """Return whether a statement is about things of a group, and about nothing that is not there yet."""
    names = set(statement.relation.asset_names())
    return bool(names & mine) and names <= set(here.by_name)


def strays(program: Program, group: Group, here: Scene) -> Iterator[str]:
    """Yield what is wrong with statements of a program that are left out because of the things that they are about."""
    mine = set(group.items)
    for statement in program.statements:
        if not _concerns(statement, mine, here):
            later = [n for n in statement.relation.asset_names() if n not in here.by_name]
            names = ", ".join(program.expressions.get(name, name) for name in later)
            reason = f"{names} comes later" if later else "it is not about a thing of this group"
            yield f"line {statement.line}: {statement.source}: {reason}."
