"""The critic: a model looks at the finished room once, may amend its program once, and its rating decides with the judge."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from robolayout._errors import ModelError, ProgramError
from robolayout.planners import Critic, Feedback, Judgement, PlanRequest, score_samples
from robolayout.program import Program, read_salvaged
from robolayout.run.given import guesses_of
from robolayout.run.result import Attempt, joined_traces
from robolayout.run.sight import finished_pictures, room_pictures
from robolayout.verify import Report, verify

if TYPE_CHECKING:
    from robolayout.run.flow import Run


@dataclass(frozen=True)
class CriticConfig:
    """What is taken of a critic's answer."""

    full_marks: int = 10  # rating at which nothing is amended
    reasons: int = 5  # reasons that are kept
    longest: int = 300  # characters of one


CRITIC = CriticConfig()


@dataclass(frozen=True)
class Critique:
    """What the critic said and what came of it."""

    outcome: str  # what happened, in one sentence
    kept: bool = False  # whether the amended room was taken
    before: int | None = None  # rating of the room as it was, 0 to 10; None if there was no answer
    after: int | None = None  # rating of the amended room; None if it was not rated
    reasons: tuple[str, ...] = ()  # what the critic wanted otherwise

    def to_dict(self) -> dict[str, Any]:
        """Return what the report says of it, also in sentences."""
        found = vars(self) | {"reasons": list(self.reasons)}
        return {"critic": found, "sentences": [self.outcome, *(f"Critic: {reason}" for reason in self.reasons)]}


@dataclass(frozen=True)
class CriticPass:
    """One look at a finished room."""

    whole: Run  # the run that the room is of
    critic: Critic  # who looks

    def run(self, room: Attempt) -> tuple[Attempt, Critique]:
        """Return the better of the room and its amendment: no worse by the judge, and rated higher by the critic."""
        self.whole.say("critic")
        try:
            return self._run(room)
        except ModelError as error:
            return room, Critique(f"The critic did not answer: {error}")

    def _run(self, room: Attempt) -> tuple[Attempt, Critique]:
        report = self._verified(room)
        first = self._rating(room, report)
        reasons = tuple(" ".join(reason.split())[: CRITIC.longest] for reason in first.reasons[: CRITIC.reasons])
        said = Critique(f"The critic gave {first.score} of 10", before=first.score, reasons=reasons)
        if first.score >= CRITIC.full_marks:
            return room, replace(said, outcome=f"{said.outcome} and had nothing to amend.")
        try:
            asked = read_salvaged(self._amended(room, report, reasons), self.whole.scene)
        except ModelError as error:
            return room, replace(said, outcome=f"{said.outcome} and was asked for an amendment in vain: {error}")
        except ProgramError as error:
            why = str(error).splitlines()[0]
            return room, replace(said, outcome=f"{said.outcome}; its program could not be read ({why}).")
        found = replace(self._solved(asked, room), asked=asked)
        after = self._verified(found)
        old, new = (score.key for score in score_samples([report.figures, after.figures], [room.asked, asked]))
        names = ("the hard demands", "reach and use", "the statements met")
        if worse := next((name for name, was, now in zip(names, old, new, strict=False) if now < was), ""):
            return room, replace(said, outcome=f"{said.outcome}; its amendment made {worse} worse and was dropped.")
        try:
            second = self._rating(found, after).score
        except ModelError as error:
            return room, replace(said, outcome=f"{said.outcome}; its amendment was not rated and was dropped: {error}")
        kept = second > first.score
        fate = "was kept" if kept else "was dropped, as it is no better"
        outcome = f"{said.outcome} and {second} after its amendment, which {fate}."
        trace = joined_traces([room.solution.trace, found.solution.trace])
        found = replace(found, solution=replace(found.solution, trace=trace))
        return (found if kept else room), replace(said, outcome=outcome, kept=kept, after=second)

    def _verified(self, room: Attempt) -> Report:
        with self.whole.clock.station("verify"):
            return verify(self.whole.scene, room.solution.layout, room.asked)

    def _rating(self, room: Attempt, report: Report) -> Judgement:
        with self.whole.clock.station("pictures"):
            images = finished_pictures(self.whole.scene, room.solution.layout, self.critic.pictures)
        with self.whole.clock.station("plan"):
            return self.critic.rate(self.whole.scene, room.solution.layout, images, summary(report))

    def _amended(self, room: Attempt, report: Report, reasons: Sequence[str]) -> str:
        with self.whole.clock.station("pictures"):
            images = room_pictures(self.whole.scene, room.solution.layout, (), self.critic.pictures)
        request = PlanRequest(
            self.whole.scene,
            placed=room.solution.layout,
            feedback=Feedback(wishes=reasons, violations=report.violations).text(self.whole.scene.expressions),
            previous=room.asked.text,
            images=images,
        )
        with self.whole.clock.station("plan"):
            return self.critic.amend(request)

    def _solved(self, asked: Program, room: Attempt) -> Attempt:
        """Solve the amendment with everything pinned that it says nothing new about; if that does not do, without pins."""
        elsewhere = dict(item for item in asked.guesses.items() if item not in room.asked.guesses.items())
        asked = replace(asked, guesses=guesses_of(room.solution.layout) | elsewhere)
        pinned = {name: room.solution.layout[name] for name in _unchanged(room.asked, asked, room)}
        (found,) = self.whole.finished([asked], self.whole.scene, pinned)
        if found.solution.verdict.ok or not pinned:
            return found
        (free,) = self.whole.finished([asked], self.whole.scene, {})
        return min((found, free), key=lambda attempt: attempt.solution.verdict.merit)


def summary(report: Report) -> str:
    """Return what the judge measured, for the critic: the short table and what is wrong."""
    lines = [
        f"- {name}: {value}{' (short of what is demanded)' if met is False else ''}"
        for name, value, met in report.rows()
    ]
    wrong = Feedback(violations=report.violations).text(report.scene.expressions)
    return "\n".join([*lines, "", wrong or "Nothing is wrong."])


def _unchanged(before: Program, after: Program, room: Attempt) -> list[str]:
    """Return the things about which two programs say the same."""
    changed: set[str] = set()
    for one, other in ((before, after), (after, before)):
        said = [statement.relation for statement in other.statements]
        changed |= {name for s in one.statements if s.relation not in said for name in s.relation.asset_names()}
    here = guesses_of(room.solution.layout).items()
    return [name for name, guess in here if name not in changed and after.guesses.get(name) == guess]
