"""What a model answered for one group, what came of it, and what it is told when it is asked again."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from robolayout.planners import Feedback, Group, SampleScore, poses_text, score_samples
from robolayout.program import Statement
from robolayout.run.diff import without_figures
from robolayout.run.result import Attempt
from robolayout.scene import Layout, Pose, Scene
from robolayout.verify import Report

REOPEN = re.compile(r"^[ \t]*#[ \t]*reopen:?[ \t]+(.{1,300}?):[ \t]*(.{1,300})", re.IGNORECASE | re.MULTILINE)
"""A line by which an answer asks for an earlier group to be planned again: its label, and what should be otherwise."""


@dataclass(frozen=True)
class Sample:
    """One answer of a model and what came of it."""

    group: str  # label of the group that it was asked for
    attempt: int  # how often the group was asked for before, plus one
    number: int  # which of the answers to that question, from 1
    text: str
    score: SampleScore | None = None  # what it achieves; None if it could not be read
    error: str = ""  # why it, or what was left out of it, could not be read
    layout: Layout | None = None  # where it puts the things of the group
    kept: bool = False  # whether this one was taken

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
class Candidate:
    """One readable answer for a group, or what the offline planner says of it, solved and verified."""

    sample: Sample
    attempt: Attempt  # what came of it
    report: Report  # what the judge says
    # what the judge finds wrong that was not wrong before this group, and what of the brief is not met, in sentences
    wrong: tuple[str, ...] = ()
    forgotten: tuple[str, ...] = ()  # things of the group that it says nothing about, as programs write them
    strays: tuple[
        str, ...
    ] = ()  # statements about things that are not this group's business, and why they were left out
    own: frozenset[int] = frozenset()  # numbers of its own statements
    cut: bool = False  # whether it was cut off at its end

    @property
    def done(self) -> bool:
        """Whether there is nothing that this group could be asked to mend."""
        return not self.wrong and not self.forgotten and not self.attempt.asked.dropped

    @property
    def unmet(self) -> int:
        """How many phrases of the brief are not met."""
        return sum(row.verdict == "unmet" for row in self.report.asked)

    @property
    def previous(self) -> str:
        """Its text as the model is shown it: with the lines that messages name."""
        return self.sample.text if self.attempt.asked.dropped else self.attempt.asked.text

    def left_out(self) -> Iterator[str]:
        """Yield what the report says of what it does not say, or says in vain."""
        for message in self.attempt.asked.dropped:
            yield f"Left out of the program: {' '.join(message.split())}"
        if self.forgotten:
            yield f"The program says nothing about {', '.join(self.forgotten)}; the solver found places for them."

    def feedback(self, question: GroupQuestion) -> str:
        """Return what to tell the model about it: only what this group can change."""
        decisions = self.attempt.reconciled.decisions
        rejected = [d.sentence for d in decisions if d.verdict == "rejected" and d.statement.number in self.own]
        layout, scene = self.attempt.solution.layout, question.here
        mine = Layout({name: pose for name, pose in layout.items() if name in question.group.items})
        found = Feedback(
            cut=self.cut,
            dropped=self.attempt.asked.dropped,
            rejections=[*rejected, *self.strays],
            violations=self.wrong,
            forgotten=self.forgotten,
            stands=poses_text(scene, mine),
            moved=[move.sentence for move in self.report.moved if move.asset in mine],
        )
        return found.text(scene.expressions)


@dataclass
class GroupQuestion:
    """One group in the room as it stands."""

    here: Scene  # the scene with the things of this group and those before it
    group: Group
    placed: Mapping[str, Pose]  # where the things before it stand
    before: tuple[Statement, ...]  # what was said about them
    known: frozenset[str] = frozenset()  # what was wrong before this group, without figures
    earlier: tuple[str, ...] = ()  # labels of earlier groups that may be asked to be planned again
    # the room as it stands, and the things to place
    images: Mapping[str, bytes] = field(default_factory=dict[str, bytes])
    samples: list[Sample] = field(default_factory=list[Sample])
    candidates: list[Candidate] = field(default_factory=list[Candidate])  # those that could be read

    def wrong(self, report: Report) -> tuple[str, ...]:
        """Return what is wrong that was not wrong before this group, in sentences."""
        return tuple(text for text in report.violations if without_figures(text) not in self.known)

    def best(self) -> Candidate | None:
        """Return the candidate that the judge likes best: hard demands, access, the brief, statements; then few forgotten."""
        if not self.candidates:
            return None
        keys = [
            (*(-part for part in score.key[:2]), one.unmet, -score.key[2], len(one.forgotten), -score.key[3], i)
            for i, (score, one) in enumerate(zip(self.scores(), self.candidates, strict=True))
        ]
        return self.candidates[min(keys)[-1]]

    def reopening(self, texts: Sequence[str]) -> tuple[str, str, str] | None:
        """Return which earlier group an answer asks to plan again, what should be otherwise there, and that answer."""
        labels = {label.casefold(): label for label in self.earlier}
        for text in texts:
            for said, why in REOPEN.findall(text):
                label = labels.get(said.strip("`'\" ").casefold())
                if label is not None:
                    return label, " ".join(why.split()), text
        return None

    def scores(self) -> tuple[SampleScore, ...]:
        """Return the scores of all candidates."""
        asked = [one.attempt.asked for one in self.candidates]
        return score_samples([one.report.figures for one in self.candidates], asked)

    def records(self) -> Iterator[Sample]:
        """Yield all answers with their scores."""
        best = self.best()
        scored: dict[int, Sample] = {}
        for one, score in zip(self.candidates, self.scores(), strict=True):
            mine = {name: pose for name, pose in one.attempt.solution.layout.items() if name in self.group.items}
            scored[id(one.sample)] = replace(one.sample, score=score, layout=Layout(mine), kept=one is best)
        yield from (scored.get(id(sample), sample) for sample in self.samples)
