"""How a model is asked: where it is, what it may cost, what stands in for it; the same for planner, critic and judge."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal, get_args

from robolayout._errors import InputError, MissingExtraError, UnknownNameError

if TYPE_CHECKING:
    from pydantic_ai.models import Model

    from robolayout.planners.model.client import Client

Thinking = Literal["minimal", "low", "medium", "high"]
THINKING: tuple[Thinking, ...] = get_args(Thinking)  # how much a model may think before it answers, where it can


@dataclass(frozen=True)
class ModelOptions:
    """How a model is asked."""

    base_url: str | None = None  # address of a server: Anthropic's protocol for "anthropic:...", else OpenAI's
    # US dollars that may be spent; what the next answer will most likely cost is set aside before it is asked for
    max_cost: float | None = None
    exchanges: str | Path | None = None  # folder to which every exchange is written, without secrets
    replay: str | Path | None = None  # folder of such exchanges to answer from, without any network
    timeout: float = 60.0  # seconds for one try of one question
    thinking: Thinking | None = None  # one of `THINKING`; None is the model's own habit
    fallback: tuple[str, ...] = ()  # models to ask, in order, where the first one cannot be had
    at_once: int | None = None  # questions under way at the same time, at most; None is as many as there are
    cache: bool = True  # whether the provider is asked to keep what all questions share, where that must be asked for

    def __post_init__(self) -> None:
        """Refuse numbers and names that cannot be meant."""
        if not 0 < self.timeout <= 3600:
            raise InputError(f"the timeout is {self.timeout:g} s; give more than 0 and at most 3600.")
        if self.max_cost is not None and not 0 < self.max_cost < 1e6:
            raise InputError(f"the maximum cost is {self.max_cost:g} dollars; give more than 0.")
        if self.at_once is not None and not 1 <= self.at_once <= 64:
            raise InputError(f"{self.at_once} questions at once; give a number from 1 to 64.")
        if self.thinking is not None and self.thinking not in THINKING:
            raise UnknownNameError("level of thinking", self.thinking, THINKING)

    def open(self, model: str | Model | None) -> Client:
        """Return a client for a model; a replay needs none."""
        if model is None and self.replay is None:
            raise InputError("a model is needed: give one such as openai:gpt-4o, or a recording to replay.")
        try:
            from robolayout.planners.model.client import Client
        except ModuleNotFoundError:
            raise MissingExtraError("asking a model", "vlm") from None
        return Client(model, self)
