"""What a planner is asked and what it answers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Protocol, runtime_checkable

from robolayout._errors import AnswerError, BudgetError, UnavailableError
from robolayout.scene import Layout, Scene
from robolayout.words import Demand

if TYPE_CHECKING:
    from robolayout.planners.sentence import Understanding

USELESS = (AnswerError, BudgetError, UnavailableError)
"""Failures of a model that nobody has to mend first: rules take over from it."""

Pictures = Literal["drawn", "named", "none"]
"""How a planner is shown pictures."""


@dataclass(frozen=True)
class Group:
    """Assets that belong together and are planned at once."""

    label: str  # what the group is ("sleeping")
    rationale: str  # why these belong together, in one sentence
    items: tuple[str, ...]  # names of its assets, most structural first
    # how they stand to each other, one phrase each ("night_stand-0 beside double_bed-0")
    relations: tuple[str, ...] = ()

    def to_dict(self) -> dict[str, object]:
        """Return the group as it is written to `grouping.json`."""
        return {**vars(self), "items": list(self.items), "relations": list(self.relations)}


@dataclass(frozen=True)
class PlanRequest:
    """One question to a planner."""

    scene: Scene  # what is given
    group: Group | None = None  # plan only these assets; None plans everything
    placed: Layout | None = None  # poses that are settled already; they stay where they are
    feedback: str = ""  # what was wrong with earlier answers (rejections, violations), in words; empty at first
    seed: int = 0  # number that settles every choice; same request, same text
    previous: str = ""  # the program text that the feedback is about
    asked: tuple[Demand, ...] = ()  # what the user's words ask of the places of things
    # pictures as PNG bytes: "plan", "top" and "side" of the room as it is, one under each name of an asset to place,
    # and with feedback "failed", what came of the program before
    images: Mapping[str, bytes] = field(default_factory=dict[str, bytes])
    reopen: tuple[str, ...] = ()  # labels of earlier groups that the answer may ask to be planned again


@runtime_checkable
class Planner(Protocol):
    """Anything that writes constraint programs."""

    def group(self, scene: Scene) -> tuple[Group, ...]:
        """Return all assets in groups, structural first, decorative last."""
        ...

    def plan(self, request: PlanRequest) -> str:
        """Return the text of a constraint program for the request."""
        ...


@runtime_checkable
class RoomPlanner(Protocol):
    """A planner that says what a room has of which only words are given."""

    def furnish(self, text: str, *, assets: Path | None = None) -> tuple[Scene, Understanding]:
        """Return a scene for a sentence, and what was understood."""
        ...


@runtime_checkable
class Critic(Protocol):
    """Who looks at a finished room, rates it, and may amend its program."""

    critic: bool  # whether to look at all

    @property
    def pictures(self) -> Pictures:
        """Whether it looks at pictures, as of `GroupPlanner`."""
        ...

    def rate(self, scene: Scene, layout: Layout, images: Mapping[str, bytes], report: str) -> Judgement:
        """Return a rating of a finished room."""
        ...

    def amend(self, request: PlanRequest) -> str:
        """Return the whole program of a finished room, amended."""
        ...


class Judgement(Protocol):
    """A rating from 0 to 10, and what should be otherwise, one sentence each."""

    score: int
    reasons: list[str]


@runtime_checkable
class GroupPlanner(Planner, Protocol):
    """A planner that is asked group by group, for several answers at once, and again with what was wrong."""

    mode: str  # "grouped", "one_shot", "no_image" or "no_constraint"
    samples: int  # programs to ask for per group; the best one is kept
    retries: int  # most further questions per group

    @property
    def pictures(self) -> Pictures:
        """Whether it looks at pictures: at drawn ones, only at their names (a replay), or at none."""
        ...

    @property
    def bill(self) -> str:
        """What it took so far, in words: "$0.0135", or how many answers where no price is known."""
        ...

    def plan_many(self, request: PlanRequest, n: int) -> tuple[str, ...]:
        """Return up to n answers to the same request."""
        ...

    def cut_off(self, text: str) -> bool:
        """Return whether an answer stopped because the model may not say more."""
        ...

    def to_dict(self) -> dict[str, Any]:
        """Return who planned and what it took, for the report."""
        ...
