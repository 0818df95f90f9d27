"""Who plans: rules, a file, or a model, and the options of whatever asks a model."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from shutil import copytree
from typing import TYPE_CHECKING, Annotated, Any

import typer

from robolayout._errors import InputError

if TYPE_CHECKING:
    from robolayout.planners import Planner
    from robolayout.run.folder import RunFolder

ModelOption = Annotated[str | None, typer.Option("--model", help="Let a model plan: openai:gpt-4o, ollama:llava, ...")]
ModeOption = Annotated[str, typer.Option("--mode", help="grouped, one_shot, no_image or no_constraint (with --model).")]
SamplesOption = Annotated[int, typer.Option("--samples", min=1, max=16, help="Programs asked for per group.")]
RetriesOption = Annotated[int, typer.Option("--retries", min=0, max=10, help="Further questions per group.")]
BaseUrlOption = Annotated[
    str | None,
    typer.Option("--base-url", help="A server that speaks OpenAI's protocol; anthropic:... asks for its own."),
]
MaxCostOption = Annotated[float | None, typer.Option("--max-cost", help="Most dollars to spend on a model.")]
TimeoutOption = Annotated[float, typer.Option("--timeout", help="Seconds to wait for a model's answer.")]
CriticOption = Annotated[bool, typer.Option("--critic", help="Let the model rate the room and amend it once.")]
ThinkingOption = Annotated[
    str | None, typer.Option("--thinking", help="How much a model thinks first: minimal, low, medium or high.")
]
FallbackOption = Annotated[
    list[str] | None, typer.Option("--fallback", help="A model to ask where the first fails; may be repeated.")
]
AtOnceOption = Annotated[int | None, typer.Option("--at-once", min=1, max=64, help="Most questions at the same time.")]
CacheOption = Annotated[
    bool, typer.Option("--cache/--no-cache", help="Ask the provider to keep what all questions share.")
]
ReplayOption = Annotated[Path | None, typer.Option("--replay", help="Answer from recorded exchanges, offline.")]


def exchanges(run: RunFolder, replay: Path | None) -> Path | None:
    """Return where answers are recorded; None where a run replays its own, which are taken over as they are."""
    from robolayout.run.folder import ANSWERS

    folder = run.path / ANSWERS
    if replay is None or replay.resolve() != (run.target / ANSWERS).resolve():
        return folder
    if replay.is_dir():
        copytree(replay, folder)
    return None


@dataclass(frozen=True)
class Who:
    """Who plans.

    Attributes:
        program: A constraint program's file.
        model: A model's name.
        knowledge: Files of the user's own, for the planner by rules.
        asked: What a model is asked for (`ModelPlanner`).
        limits: How it is asked (`ModelOptions`).
    """

    program: Path | None
    model: str | None
    knowledge: tuple[Path, ...]
    asked: Mapping[str, Any]
    limits: Mapping[str, Any]

    def __post_init__(self) -> None:
        """Refuse what excludes each other, before any work."""
        if self.program is not None and self.asks_a_model:
            raise InputError("--program and --model (or --base-url, --replay) exclude each other: give one of them.")
        if self.knowledge and (self.program is not None or self.asks_a_model):
            raise InputError(
                "--knowledge is for the offline planner: leave it out, or leave --program and --model out."
            )
        if self.knowledge:
            self.by_rules()

    @property
    def asks_a_model(self) -> bool:
        """Whether a model plans, or a recording of one."""
        return bool(self.model or self.limits["base_url"] or self.limits["replay"])

    def by_rules(self) -> Planner:
        """Return the offline planner, with the user's own knowledge."""
        from robolayout.planners import OfflinePlanner

        return OfflinePlanner(self.knowledge)

    def planner(self, run: RunFolder, seed: int) -> Planner:
        """Return the planner of one run."""
        from robolayout.planners import FilePlanner, ModelPlanner

        if self.program is not None:
            return FilePlanner(self.program)
        if not self.asks_a_model:
            return self.by_rules()
        record = exchanges(run, self.limits["replay"])
        return ModelPlanner(self.model, **self.asked, **self.limits, exchanges=record, seed=seed)
