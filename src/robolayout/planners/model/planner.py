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
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypeVar, cast, get_args

from robolayout._errors import AnswerError, BudgetError, InputError, MissingExtraError, UnknownNameError
from robolayout.planners._types import Group, Pictures, PlanRequest
from robolayout.planners.model import prompt as texts
from robolayout.planners.model.exchange import Question, Tape
from robolayout.planners.model.grouping import Grouping, Rating, complaint, groups_of
from robolayout.planners.offline import OfflinePlanner
from robolayout.scene import Layout, Scene

if TYPE_CHECKING:
    from pydantic_ai.models import Model

    from robolayout.planners.model.client import Client, Usage

T = TypeVar("T")

Mode = Literal["grouped", "one_shot", "no_image", "no_constraint"]
MODES: tuple[Mode, ...] = get_args(Mode)
"""How a model is asked: group by group, all at once, without pictures, for poses alone (each but one_shot in groups)."""

EVERYTHING = "everything"
"""Label of the one group of a one-shot plan."""


class ModelPlanner:
    """Asks a model for groups and programs.

    Args:
        model: "openai:gpt-4o", "anthropic:...", "google:...", "ollama:...", a name at `base_url`, or a model of pydantic-ai. A
            replay needs none.
        mode: One of `MODES`.
        samples: Programs to draw per group; the pipeline keeps the best.
        critic: Whether the model looks at the finished room and may amend its program once.
        retries: Further attempts that the pipeline may ask for per group.
        base_url: Address of an OpenAI-compatible server.
        max_cost: US dollars that may be spent; what the next answer will most likely cost is set aside before it is asked for.
        exchanges: Folder to which every exchange is written, without secrets.
        replay: Folder of such exchanges to answer from, without any network.
        timeout: Seconds for one try of one question.
        seed: Settles the answers, where the provider can.
    """

    def __init__(  # noqa: PLR0913 - the command line's options, keyword-only
        self,
        model: str | Model | None = None,
        *,
        mode: Mode = "grouped",
        samples: int = 1,
        retries: int = 3,
        critic: bool = False,
        base_url: str | None = None,
        max_cost: float | None = None,
        exchanges: str | Path | None = None,
        replay: str | Path | None = None,
        timeout: float = 60.0,
        seed: int = 0,
    ) -> None:
        if mode not in MODES:
            raise UnknownNameError("mode", mode, MODES)
        _check_numbers(samples=samples, retries=retries, timeout=timeout, max_cost=max_cost)
        if model is None and replay is None:
            raise InputError("a model is needed: give one such as openai:gpt-4o, or a recording to replay.")
        self.mode: Mode = mode
        self.samples, self.retries, self.critic, self.seed = samples, retries, critic, seed
        tape = Tape(Path(exchanges) if exchanges else None, Path(replay) if replay else None)
        self._client = _client(model, tape, base_url, timeout, max_cost)
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
    def usage(self) -> Usage:
        """Requests, tokens and cost so far."""
        return self._client.usage

    @property
    def warnings(self) -> tuple[str, ...]:
        """What did not go as asked, one sentence each."""
        return tuple(dict.fromkeys([*self._client.notes, *self._client.tape.notes]))

    def to_dict(self) -> dict[str, Any]:
        """Return who planned, for the report: model, mode, prompts, usage, warnings."""
        return {
            "model": self.model,
            "mode": self.mode,
            "samples": self.samples,
            "prompt_version": texts.PROMPT_VERSION,
            "usage": self.usage.to_dict(),
            "warnings": list(self.warnings),
            "sentences": [self._summary(), *self.warnings],
        }

    def _summary(self) -> str:
        """Return who planned and what it took, in one sentence."""
        used = self.usage
        cost = "an unknown sum" if used.cost is None else f"${used.cost:.4f}"
        return (
            f"{self.model} planned in mode {self.mode} (prompts of version {texts.PROMPT_VERSION}): {used.requests} answers, "
            f"{used.input_tokens} tokens sent and {used.output_tokens} received, for {cost}."
        )

    def group(self, scene: Scene) -> tuple[Group, ...]:
        """Return all assets in groups, structural first, decorative last; in the mode one_shot in one group."""
        self._asked.clear()
        if self.mode == "one_shot" or len(scene.assets) < 2:
            return (Group(EVERYTHING, "All at once.", tuple(asset.name for asset in scene.assets)),)
        question = self._question(
            scene, None, "group", instructions="group", parts=(texts.request_text(scene, None, names=True),)
        )
        (answer,) = self._client.ask([question], Grouping, lambda given: complaint(scene, given))
        if isinstance(answer, BudgetError | AnswerError):
            self._client.note(f"The offline planner's groups are asked for: {answer}")
            return OfflinePlanner().group(scene)
        return groups_of(scene, _sound(answer))

    def plan(self, request: PlanRequest) -> str:
        """Return one answer to the request: program text, in fences."""
        return self.plan_many(request, 1)[0]

    def plan_many(self, request: PlanRequest, n: int) -> tuple[str, ...]:
        """Return up to n answers to the same request, asked for at the same time; those that failed are left out.

        Raises:
            ModelError: None of them came.
        """
        if request.group and request.group.label == EVERYTHING:
            request = replace(request, group=None)
        guess = "guess" if self.mode == "no_constraint" else "plan"
        first = self._question(
            request.scene,
            request.group,
            "plan",
            instructions=guess,
            parts=(texts.request_text(request.scene, request.group), texts.state_text(request)),
            images=request.images,
        )
        free = 0.3 if n == 1 else 0.8
        seed = (self.seed + request.seed) * 1000 + first.attempt * 100
        questions = [replace(first, sample=i + 1, seed=seed + i, temperature=free) for i in range(n)]
        ahead = 1 if self._client.budget.most is not None else n  # what one costs tells how many more fit
        answers = [
            answer for part in (questions[:ahead], questions[ahead:]) if part for answer in self._client.ask(part, str)
        ]
        texts_ = tuple(answer for answer in answers if isinstance(answer, str))
        failures = [answer for answer in answers if not isinstance(answer, str)]
        if not texts_:
            raise failures[0]
        for failure in failures:
            self._client.note(f"one of {n} samples is missing: {failure}")
        return texts_

    def cut_off(self, text: str) -> bool:
        """Return whether an answer stopped because the model may not say more."""
        return text in self._client.cut

    def rate(self, scene: Scene, layout: Layout, images: Mapping[str, bytes], report: str) -> Rating:
        """Return the model's own rating of a finished room.

        Args:
            scene: The scene.
            layout: Where its things stand.
            images: "finished top" and "finished side" as PNG bytes.
            report: What the judge measured, in words.
        """
        parts = (
            texts.request_text(scene, None),
            f"# Where everything stands\n\n{texts.poses_text(scene, layout)}\n\n# What was measured\n\n{report}",
        )
        question = self._question(scene, None, "rate", instructions="rate", parts=parts, images=images)
        (answer,) = self._client.ask([question], Rating)
        return _sound(answer)

    def amend(self, request: PlanRequest) -> str:
        """Return the whole program, amended: `previous` is the program, `placed` the room, `feedback` what is wished for."""
        parts = (texts.request_text(request.scene, None), texts.amend_text(request))
        question = self._question(request.scene, None, "amend", instructions="plan", parts=parts, images=request.images)
        (answer,) = self._client.ask([question], str)
        return _sound(answer)

    def _question(
        self,
        scene: Scene,
        group: Group | None,
        kind: str,
        *,
        instructions: str,
        parts: tuple[str, ...],
        images: Mapping[str, bytes] | None = None,
    ) -> Question:
        """Return a question with its place in the job: the same one asked again is the next attempt."""
        data = {"mode": self.mode, **texts.given_data(scene, group, kind)}
        label = group.label if group else EVERYTHING
        key = texts.digest(data)
        self._asked[kind, label, key] += 1
        shown = () if self.pictures == "none" else texts.images_in_order(images or {})
        return Question(
            kind,
            label,
            self._asked[kind, label, key],
            1,
            texts.prompt(instructions),
            parts,
            tuple((texts.image_label(name), data) for name, data in shown),
            key,
            seed=self.seed,
        )


def _client(
    model: str | Model | None, tape: Tape, base_url: str | None, timeout: float, max_cost: float | None
) -> Client:
    """Return the client; raises `MissingExtraError` without the model library."""
    try:
        from robolayout.planners.model.client import Client
        from robolayout.planners.model.provider import Spec, spec_of
    except ImportError as error:
        if (error.name or "").partition(".")[0] not in ("pydantic_ai", "genai_prices", "httpx2", "openai"):
            raise
        raise MissingExtraError("the planner with a model", "vlm") from None
    spec = Spec(tape.model) if tape.replay else spec_of(cast("str | Model", model), base_url)
    tape.model = spec.name
    return Client(spec, tape, timeout=timeout, max_cost=max_cost)


def _sound(answer: T | Exception) -> T:
    if isinstance(answer, Exception):
        raise answer
    return answer


def _check_numbers(*, samples: int, retries: int, timeout: float, max_cost: float | None) -> None:
    if not 1 <= samples <= 64:
        raise InputError(f"samples is {samples}; give a number from 1 to 64.")
    if not 0 <= retries <= 20:
        raise InputError(f"retries is {retries}; give a number from 0 to 20.")
    if not 0 < timeout <= 3600:
        raise InputError(f"the timeout is {timeout:g} s; give more than 0 and at most 3600.")
    if max_cost is not None and not 0 < max_cost < 1e6:
        raise InputError(f"the maximum cost is {max_cost:g} dollars; give more than 0.")
