"""Who plans: rules, a file, or a model, and how a model is asked."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path
from shutil import copytree
from typing import TYPE_CHECKING, Annotated

from typer import Option

from robolayout._errors import InputError
from robolayout.cli.options import BaseUrlOption, KnowledgeOption, MaxCostOption, ReplayOption

if TYPE_CHECKING:
    from robolayout.planners import Planner
    from robolayout.run.folder import RunFolder


@dataclass(frozen=True, kw_only=True)
class Who:
    """Who plans."""

    program: Annotated[Path | None, Option(help="Use this constraint program instead of planning.")] = None
    knowledge: KnowledgeOption = None
    model: Annotated[str | None, Option(help="Let a model plan: openai:gpt-4o, ollama:llava, ...")] = None
    mode: Annotated[str, Option(help="grouped, one_shot, no_image or no_constraint (with --model).")] = "grouped"
    samples: Annotated[int, Option(min=1, max=16, help="Programs asked for per group.")] = 1
    retries: Annotated[int, Option(min=0, max=10, help="Further questions per group.")] = 3
    critic: Annotated[bool, Option("--critic", help="Let the model rate the room and amend it once.")] = False
    base_url: BaseUrlOption = None
    max_cost: MaxCostOption = None
    timeout: Annotated[float, Option(help="Seconds to wait for a model's answer.")] = 60.0
    thinking: Annotated[str | None, Option(help="How much a model thinks first: minimal, low, medium or high.")] = None
    fallback: Annotated[list[str] | None, Option(help="A model to ask where the first fails; may be repeated.")] = None
    at_once: Annotated[int | None, Option(min=1, max=64, help="Most questions at the same time.")] = None
    cache: Annotated[bool, Option(help="Ask the provider to keep what all questions share.")] = True
    replay: ReplayOption = None

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
        return bool(self.model or self.base_url or self.replay)

    def by_rules(self) -> Planner:
        """Return the offline planner, with the user's own knowledge."""
        from robolayout.planners import OfflinePlanner

        return OfflinePlanner(self.knowledge or ())

    def planner(self, run: RunFolder, seed: int) -> Planner:
        """Return the planner of one run."""
        from robolayout.planners import FilePlanner, ModelPlanner

        if self.program is not None:
            return FilePlanner(self.program)
        if not self.asks_a_model:
            return self.by_rules()
        given = {one.name: getattr(self, one.name) for one in fields(Who) if one.name not in ("program", "knowledge")}
        given |= {"fallback": tuple(self.fallback or ()), "exchanges": self._exchanges(run), "seed": seed}
        return ModelPlanner(**given)

    def _exchanges(self, run: RunFolder) -> Path | None:
        """Return where answers are recorded; None where a run replays its own, which are taken over as they are."""
        from robolayout.run.folder import ANSWERS

        folder = run.path / ANSWERS
        if self.replay is None or self.replay.resolve() != (run.target / ANSWERS).resolve():
            return folder
        if self.replay.is_dir():
            copytree(self.replay, folder)
        return None
