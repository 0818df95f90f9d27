"""A model as judge: LayoutVLM's positional and rotational coherence of a finished room, by several votes.

The published evaluation shows a model the room from above and from the side and asks for scores from 0 to 100. Its prompt and its
formula of PSA are not published as code; ours are `prompts/judge.md` and: PSA = mean of both scores if every thing is inside the
room and overlaps nothing, else 0. Figures compare only where model and prompt are the same.
"""

from __future__ import annotations

import statistics
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from pydantic import BaseModel, Field

from robolayout._errors import InputError
from robolayout.planners._types import Pictures
from robolayout.planners.model import prompt as texts
from robolayout.planners.model.exchange import Question
from robolayout.planners.model.options import ModelOptions
from robolayout.scene import Layout, Scene

if TYPE_CHECKING:
    from pydantic_ai.models import Model

MOST_VOTES = 32  # votes on one room
FREEDOM = 0.8  # temperature of a vote: votes without freedom are one vote
LONGEST_REASON = 300  # characters of a reason that are kept


class Vote(BaseModel):
    """One vote on a finished room."""

    positional: int = Field(ge=0, le=100, description="whether everything stands where it belongs")
    rotational: int = Field(ge=0, le=100, description="whether everything is turned as it is used")
    reasons: list[str] = Field(default_factory=list, description="at most five sentences, the weightiest first")


@dataclass(frozen=True)
class Opinion:
    """What a model thinks of a room."""

    model: str  # its name
    votes: tuple[Vote, ...]  # every vote that came
    valid: bool  # whether every thing is inside the room and overlaps nothing, by the published rule
    notes: tuple[str, ...] = ()  # what did not go as asked, and what it took, in sentences

    @property
    def psa(self) -> float:
        """The mean of both scores, weighted by physical plausibility: 0 where a thing overlaps or is outside."""
        return self.valid * statistics.fmean((vote.positional + vote.rotational) / 2 for vote in self.votes)

    def to_dict(self) -> dict[str, Any]:
        """Return it as it is written to the report, also in sentences."""
        scores: dict[str, dict[str, float | int]] = {}
        for name in ("positional", "rotational"):
            given = [getattr(vote, name) for vote in self.votes]
            mean, deviation = statistics.fmean(given), statistics.pstdev(given)
            scores[name] = {"mean": mean, "lowest": min(given), "highest": max(given), "deviation": deviation}
        told = (
            f"{name} coherence {s['mean']:.0f} of 100 ({s['lowest']} to {s['highest']}, standard deviation {s['deviation']:.1f})"
            for name, s in scores.items()
        )
        count = f"{len(self.votes)} vote{'s' if len(self.votes) > 1 else ''}"
        sentence = f"{self.model} in {count}: {', '.join(told)}; PSA {self.psa:.0f}, as defined in docs/vlm.md."
        reasons = dict.fromkeys(" ".join(r.split())[:LONGEST_REASON] for vote in self.votes for r in vote.reasons[:5])
        return {
            "model": self.model,
            "prompt_version": texts.PROMPT_VERSION,
            **scores,
            "psa": self.psa,
            "votes": [vote.model_dump() for vote in self.votes],
            "sentences": [sentence, *reasons, *self.notes],
        }


class ModelJudge:
    """Asks a model what it thinks of finished rooms.

    Args:
        model: As of `ModelPlanner`.
        votes: How often each room is voted on.
        seed: Settles the votes, where the provider can.
        options: How the model is asked, as the attributes of `ModelOptions`.
    """

    def __init__(self, model: str | Model | None = None, *, votes: int = 3, seed: int = 0, **options: Any) -> None:
        if not 1 <= votes <= MOST_VOTES:
            raise InputError(f"{votes} votes; give a number from 1 to {MOST_VOTES}.")
        self.votes, self.seed = votes, seed
        self._client = ModelOptions(**options).open(model)

    @property
    def pictures(self) -> Pictures:
        """Whether pictures are drawn for it; a replay knows them by name."""
        return "named" if self._client.tape.replay else "drawn"

    def opinion(self, scene: Scene, layout: Layout, images: Mapping[str, bytes], *, valid: bool) -> Opinion:
        """Return what the model thinks of a finished room, or raise the first error where no vote came.

        Args:
            layout: Where everything stands; a recorded vote belongs to it, to the centimetre.
            images: "finished top" and "finished side" as PNG bytes.
            valid: Whether every thing is inside the room and overlaps nothing.
        """
        words = f"# What was asked for\n\n{texts.quoted(scene.task_description)}\n{texts.quoted(scene.layout_criteria)}"
        key = texts.digest([texts.given_data(scene, None, "judge"), texts.poses_text(scene, layout)])
        parts, system = (words, *texts.shown(images)), texts.prompt("judge")
        question = Question("judge", scene.name, 1, 1, system, parts, key, FREEDOM, self.seed * 1000)
        votes, failures = self._client.ask(question, Vote, n=self.votes)
        notes = (*self._client.warnings, *(f"A vote is missing: {error}" for error in failures))
        return Opinion(self._client.spec.name, votes, valid, (*notes, self._client.summary("judged")))
