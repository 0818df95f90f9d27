"""The planner that asks a model: any provider, with pictures, samples, a budget, and a record of every exchange.

```
planner = ModelPlanner("openai:gpt-4o", samples=4, max_cost=0.50, exchanges=Path("out/exchanges"))
groups = planner.group(scene)                                   # typed, every asset exactly once
texts = planner.plan_many(PlanRequest(scene, groups[0], images=pictures), planner.samples)
```

It asks and remembers; it never loops. Retries with feedback, choosing among samples and the offline planner as the last
resort are the pipeline's.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, get_args

from robolayout._errors import InputError, SceneError, UnknownNameError
from robolayout.planners._types import USELESS, Group, Pictures, PlanRequest
from robolayout.planners.model import prompt as texts
from robolayout.planners.model.exchange import Question
from robolayout.planners.model.grouping import Grouping, Rating, complaint, groups_of
from robolayout.planners.model.options import ModelOptions
from robolayout.planners.model.prompt import Picture
from robolayout.planners.model.rooms import Furnisher, Furnishing, choices_text, has_catalogue
from robolayout.planners.offline import OfflinePlanner
from robolayout.planners.sentence import Understanding, scene_from_sentence
from robolayout.scene import Layout, Scene

if TYPE_CHECKING:
    from pydantic_ai.models import Model

    from robolayout.planners.model.client import TokenUsage

Mode = Literal["grouped", "one_shot", "no_image", "no_constraint"]
MODES: tuple[Mode, ...] = get_args(Mode)
"""How a model is asked: group by group, all at once, without pictures, for poses alone (each but one_shot in groups)."""

EVERYTHING = "everything"  # label of the one group of a one-shot plan


class ModelPlanner:
    """Asks a model for groups and programs.

    Args:
        model: "openai:gpt-4o", "anthropic:...", "google:...", "ollama:...", a name at `base_url`, or a model of pydantic-ai. A
            replay needs none.
        mode: One of `MODES`.
        samples: Programs to draw per group; the pipeline keeps the best.
        retries: Further attempts that the pipeline may ask for per group.
        critic: Whether the model looks at the finished room and may amend its program once.
        seed: Settles the answers, where the provider can.
        options: How the model is asked, as the attributes of `ModelOptions` (`max_cost=0.5`, `replay=folder`).
    """

    def __init__(
        self,
        model: str | Model | None = None,
        *,
        mode: Mode = "grouped",
        samples: int = 1,
        retries: int = 3,
        critic: bool = False,
        seed: int = 0,
        **options: Any,
    ) -> None:
        if mode not in MODES:
            raise UnknownNameError("mode", mode, MODES)
        if not 1 <= samples <= 64:
            raise InputError(f"samples is {samples}; give a number from 1 to 64.")
        if not 0 <= retries <= 20:
            raise InputError(f"retries is {retries}; give a number from 0 to 20.")
        self.mode: Mode = mode
        self.samples, self.retries, self.critic, self.seed = samples, retries, critic, seed
        self._client = ModelOptions(**options).open(model)
        self._asked: Counter[tuple[str, str, str]] = Counter()

    def __repr__(self) -> str:
        return f"<planner {self.model}, {self.mode}, {self.samples} sample{'s' if self.samples > 1 else ''}>"

    @property
    def model(self) -> str:
        """The model's name."""
        return self._client.spec.name

    @property
    def pictures(self) -> Pictures:
        """Whether it looks at pictures: not in mode no_image or with a model that does not see; a replay knows them by name."""
        if self.mode == "no_image" or not self._client.sees:
            return "none"
        return "named" if self._client.tape.replay else "drawn"

    @property
    def usage(self) -> TokenUsage:
        """Requests, tokens and cost so far."""
        return self._client.usage

    @property
    def warnings(self) -> tuple[str, ...]:
        """What did not go as asked, one sentence each."""
        return self._client.warnings

    @property
    def bill(self) -> str:
        """What it took so far, in words."""
        used = self.usage
        return f"{used.requests} answers" if used.cost is None else f"${used.cost:.4f}"

    def to_dict(self) -> dict[str, Any]:
        """Return who planned, for the report: model, mode, prompts, usage, warnings."""
        return {
            "model": self.model,
            "mode": self.mode,
            "samples": self.samples,
            "prompt_version": texts.PROMPT_VERSION,
            "usage": dict(vars(self.usage)),
            "warnings": list(self.warnings),
            "sentences": [self._client.summary(f"planned in mode {self.mode}"), *self.warnings],
        }

    def furnish(self, text: str, *, assets: Path | None = None) -> tuple[Scene, Understanding]:
        """Return a scene for a sentence, and what was understood; by rules where the model cannot.

        The things of a catalogue in a user's own folder of assets are offered beside the built-in ones.
        """
        reader = Furnisher(text, assets)
        key = texts.digest({"kind": "room", "text": text, "kinds": list(reader.known)})
        parts = (choices_text(reader.known), f"# The words\n\n{texts.quoted(text)}")
        question = Question("room", EVERYTHING, 1, 1, texts.prompt("room"), parts, key, seed=self.seed)
        try:
            (answer,), _ = self._client.ask(question, Furnishing, reader.complaint)
            return reader.scene(answer), reader.understanding(answer)
        except (*USELESS, SceneError) as error:
            self._client.note(f"The words were read by rules instead of by {self.model}: {error}")
        return scene_from_sentence(text, seed=self.seed, assets=assets if has_catalogue(assets) else None)

    def group(self, scene: Scene) -> tuple[Group, ...]:
        """Return all assets in groups, structural first, decorative last; in the mode one_shot in one group."""
        self._asked.clear()
        if self.mode == "one_shot" or len(scene.assets) < 2:
            return (Group(EVERYTHING, "All at once.", tuple(asset.name for asset in scene.assets)),)
        parts = [texts.request_text(scene, None, names=True)]
        question = self._question("group", scene, parts)
        try:
            (answer,), _ = self._client.ask(question, Grouping, lambda given: complaint(scene, given))
            return groups_of(scene, answer)
        except USELESS as error:
            self._client.note(f"The offline planner's groups are asked for: {error}")
            return OfflinePlanner().group(scene)

    def plan(self, request: PlanRequest) -> str:
        """Return one answer to the request: program text, in fences."""
        return self.plan_many(request, 1)[0]

    def plan_many(self, request: PlanRequest, n: int) -> tuple[str, ...]:
        """Return up to n answers to the same request, asked for at once; those that failed are left out, unless all did."""
        if request.group and request.group.label == EVERYTHING:
            request = replace(request, group=None)
        guess = "guess" if self.mode == "no_constraint" else "plan"
        images = dict(request.images)
        failed = images.pop("failed", None)
        parts = [
            texts.request_text(request.scene, request.group),
            texts.state_text(request),
            *self._shown(images),
            texts.retry_text(request),
            *self._shown({} if failed is None else {"failed": failed}),
        ]
        question = self._question("plan", request.scene, parts, request.group, instructions=guess)
        seed = (self.seed + request.seed) * 1000 + question.attempt * 100
        question = replace(question, seed=seed, temperature=0.3 if n == 1 else 0.8)
        answers, failures = self._client.ask(question, str, n=n)
        for failure in failures:
            self._client.note(f"one of {n} samples is missing: {failure}")
        return answers

    def cut_off(self, text: str) -> bool:
        """Return whether an answer stopped because the model may not say more."""
        return text in self._client.cut

    def rate(self, scene: Scene, layout: Layout, images: Mapping[str, bytes], report: str) -> Rating:
        """Return the model's own rating of a finished room, seen from its top and side, and of what the judge measured."""
        parts = [
            texts.request_text(scene, None),
            f"# Where everything stands\n\n{texts.poses_text(scene, layout)}\n\n# What was measured\n\n{report}",
            *self._shown(images),
        ]
        return self._client.ask(self._question("rate", scene, parts), Rating)[0][0]

    def amend(self, request: PlanRequest) -> str:
        """Return the whole program, amended: `previous` is the program, `placed` the room, `feedback` what is wished for."""
        parts = [texts.request_text(request.scene, None), texts.amend_text(request), *self._shown(request.images)]
        return self._client.ask(self._question("amend", request.scene, parts, instructions="plan"), str)[0][0]

    def _shown(self, images: Mapping[str, bytes]) -> list[Picture]:
        """Return pictures with the lines above them; none for a model that does not look."""
        return [] if self.pictures == "none" else texts.shown(images)

    def _question(
        self,
        kind: str,
        scene: Scene,
        parts: Sequence[str | Picture],
        group: Group | None = None,
        instructions: str | None = None,
    ) -> Question:
        """Return a question with its place in the job: the same one asked again is the next attempt."""
        key = texts.digest({"mode": self.mode, **texts.given_data(scene, group, kind)})
        label = group.label if group else EVERYTHING
        self._asked[kind, label, key] += 1
        said, attempt = tuple(part for part in parts if part), self._asked[kind, label, key]
        return Question(kind, label, attempt, 1, texts.prompt(instructions or kind), said, key, seed=self.seed)
