"""The one place that talks to a model: provider, pictures, budget, retries, recording; every failure is one sentence.

Questions are asked concurrently, each through an agent of pydantic-ai. The network lives behind `_Taped`, a model that
answers from a recording or asks the real one and records what it said. Retries after 429 and 5xx, with the wait that the
server asks for, are the provider client's own; `timeout` bounds each try and three times that the whole question.
"""

from __future__ import annotations

import asyncio
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from decimal import Decimal
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar, cast

from anyio.from_thread import start_blocking_portal
from pydantic import BaseModel
from pydantic_ai import (
    Agent,
    BinaryContent,
    ModelMessage,
    ModelResponse,
    ModelRetry,
    PromptedOutput,
    RunContext,
    RunUsage,
    TextPart,
    ToolCallPart,
    ToolOutput,
    UsageLimits,
    UserContent,
)
from pydantic_ai.exceptions import (
    AgentRunError,
    FallbackExceptionGroup,
    ModelAPIError,
    ModelHTTPError,
    UnexpectedModelBehavior,
)
from pydantic_ai.models import Model, ModelRequestParameters
from pydantic_ai.models.concurrency import ConcurrencyLimitedModel
from pydantic_ai.models.fallback import FallbackModel
from pydantic_ai.models.test import TestModel
from pydantic_ai.models.wrapper import WrapperModel
from pydantic_ai.settings import ModelSettings
from pydantic_ai.usage import RequestUsage

from robolayout._errors import AnswerError, BudgetError, InputError, ModelError, UnavailableError
from robolayout._reading.syntax import ASTRAY
from robolayout.planners.model.errors import refuses_images, sentence
from robolayout.planners.model.exchange import Question, Tape
from robolayout.planners.model.prompt import PROMPT_VERSION
from robolayout.planners.model.provider import ModelSpec, open_model, price_of, spec_of

if TYPE_CHECKING:
    from robolayout.planners.model.options import ModelOptions

T = TypeVar("T")
Check = Callable[[Any], str | None]

MOST_CHARACTERS = 400_000  # characters of an answer beyond which it is refused

FAILURES = {kind.__name__: kind for kind in (ModelError, BudgetError, AnswerError, UnavailableError)}
"""How a recorded question may have failed."""

PATIENCE = 3.0  # times `timeout` that one question may take with all its tries

CHARACTERS_PER_TOKEN = 4  # characters of English or program text that make one token, where nobody counts them

TOKENS_PER_PICTURE = 1_100
"""Tokens of one of our pictures (768 pixels a side) at the providers that count them in tiles."""

FIRST_ANSWER = 1_200  # tokens that an answer is expected to have before one has come: a program for a dozen things


@dataclass(frozen=True)
class TokenUsage:
    """What a planner has used so far."""

    requests: int  # answers received
    input_tokens: int  # tokens sent, pictures included
    output_tokens: int  # tokens received
    cost: float | None  # US dollars; None where no price is known


def tokens_of(question: Question) -> int:
    """Return about how many tokens a question has."""
    words = sum(map(len, (question.instructions, *question.texts)))
    return words // CHARACTERS_PER_TOKEN + TOKENS_PER_PICTURE * len(question.images)


@dataclass
class Budget:
    """What may be spent, what is spent, and what is set aside for questions that are being answered.

    An answer that was paid for is always used, so a job overspends by at most what its last answer costs above its estimate.
    """

    most: Decimal | None  # US dollars; None is without limit
    price: Callable[[int, int], Decimal | None]  # dollars for so many tokens sent and received, where a price is known
    spent: Decimal = Decimal(0)  # US dollars so far
    reserved: Decimal = Decimal(0)  # US dollars set aside
    _received: list[int] = field(default_factory=list[int])
    _dearest: Decimal = Decimal(0)

    def reserve(self, question: Question, name: str) -> Decimal:
        """Set aside what a question will most likely cost, and return it; raises `BudgetError` if it does not fit.

        That is by the price list, with an answer as long as those so far, else as much as the dearest answer so far.
        """
        expected = sum(self._received) // len(self._received) if self._received else FIRST_ANSWER
        priced = self.price(tokens_of(question), expected)
        cost = self._dearest if priced is None else priced
        if self.most is not None and self.spent + self.reserved + cost > self.most:
            raise BudgetError(
                f"stopped at the budget: {name} has cost ${self.spent:.4f}, the next answer would most likely cost ${cost:.4f}, "
                f"--max-cost allows ${self.most:.4f}. Raise it to go on."
            )
        self.reserved += cost
        return cost

    def settle(self, reserved: Decimal, used: RequestUsage) -> None:
        """Give back what was set aside for a question and count what its answer took; nothing if it never came."""
        self.reserved -= reserved
        self._received += [used.output_tokens] * (used.output_tokens > 0)
        self.spent += used.cost or 0
        self._dearest = max(self._dearest, used.cost or Decimal(0))


class _Taped(WrapperModel):
    """Answers one question from the recording, or asks the wrapped model and records its answer."""

    def __init__(self, wrapped: Model, client: Client, question: Question) -> None:
        super().__init__(wrapped)
        self._client, self._question, self._turn, self._feedback = client, question, 0, ""
        self._answer: dict[str, Any] | None = None

    async def request(
        self,
        messages: list[ModelMessage],
        model_settings: ModelSettings | None,
        model_request_parameters: ModelRequestParameters,
    ) -> ModelResponse:
        """Return the answer to the next turn of the question."""
        contents = [getattr(part, "content", None) for part in (messages[-1].parts if len(messages) > 1 else ())]
        self._feedback = "\n".join(content for content in contents if isinstance(content, str))
        self._turn, self._answer = self._turn + 1, None
        client, used = self._client, RequestUsage()
        if client.tape.replay:
            return self._recalled()
        reserved = client.budget.reserve(self._question, client.spec.name)
        try:
            response = await self.wrapped.request(messages, model_settings, model_request_parameters)
            length = sum(len(part.content) for part in response.parts if isinstance(part, TextPart))
            if not (response.usage.input_tokens or response.usage.output_tokens):
                client.note(f"{client.spec.name} tells no token counts; they are estimated from characters.")
                sent = tokens_of(self._question)
                response.usage = RequestUsage(input_tokens=sent, output_tokens=length // CHARACTERS_PER_TOKEN)
            self._answer = to_answer(response, client.tape.scrub)
            answered = from_answer(self._answer)
            used = answered.usage
        except ASTRAY as error:
            told = client.tape.scrub(" ".join(f"{type(error).__name__} {error}".split()))[:100]
            raise UnexpectedModelBehavior(f"an answer of another form than asked for ({told})") from error
        finally:
            client.budget.settle(reserved, used)
        if response.finish_reason == "length":
            client.cut |= {part["content"] for part in self._answer["parts"]}
        if length > MOST_CHARACTERS:
            raise UnexpectedModelBehavior(f"an answer of {length} characters, at most {MOST_CHARACTERS} are read")
        client.tape.write(self._question, self._turn, self._answer, self._feedback)
        return answered

    def _recalled(self) -> ModelResponse:
        """Return the recorded answer, or fail as it did then."""
        entry = self._client.tape.recall(self._question, self._turn)
        answered = from_answer(entry["answer"]) if entry["answer"] else None
        if answered and not entry.get("failure"):
            return answered
        if answered:
            self._client.spent.incr(RunUsage(requests=1))
            self._client.spent.incr(answered.usage)
        raise FAILURES.get(entry.get("failed_as", ""), ModelError)(entry["failure"])

    def fail(self, failure: ModelError) -> None:
        """Record that the question failed, so that a replay fails alike."""
        if not self._client.tape.replay:
            self._client.tape.write(self._question, max(self._turn, 1), self._answer, self._feedback, failure)


class Client:
    """Asks questions of the first of some models, concurrently, and keeps count; the others stand in for it."""

    def __init__(self, model: str | Model | None, options: ModelOptions) -> None:
        record, replay = (Path(folder) if folder else None for folder in (options.exchanges, options.replay))
        self.options, self.tape = options, Tape(record, replay)
        if replay:
            self.specs = [ModelSpec(self.tape.model)]
        else:
            self.specs = [spec_of(cast("str | Model", model), options.base_url)]
            self.specs += [spec_of(name, None) for name in options.fallback]
        self.spec = self.specs[0]
        self.tape.model = self.spec.name
        most = options.max_cost
        self.budget = Budget(None if most is None else Decimal(str(most)), self._price)
        self.sees = True
        self.notes: list[str] = []
        self.cut = set[str]()
        self.spent = RunUsage()
        self._models: list[Model] = []

    def note(self, sentence: str) -> None:
        """Say once what did not go as asked."""
        if sentence not in self.notes:
            self.notes.append(sentence)

    @property
    def warnings(self) -> tuple[str, ...]:
        """What did not go as asked, and what was odd in a replay, one sentence each."""
        return tuple(dict.fromkeys([*self.notes, *self.tape.notes]))

    def _price(self, sent: int, received: int) -> Decimal | None:
        """Return the price at the dearest of the models that may answer; None where none has one."""
        prices = (price_of(model, sent, received) for model in self._models)
        return max((price for price in prices if price is not None), default=None)

    @property
    def usage(self) -> TokenUsage:
        """What was used so far."""
        spent = self.spent
        cost = None if spent.cost is None else float(spent.cost)
        return TokenUsage(spent.requests, spent.input_tokens, spent.output_tokens, cost)

    def summary(self, did: str) -> str:
        """Return who did something and what that took, in one sentence."""
        used = self.usage
        cost = "an unknown sum" if used.cost is None else f"${used.cost:.4f}"
        return (
            f"{self.spec.name} {did} (prompts of version {PROMPT_VERSION}): {used.requests} answers, "
            f"{used.input_tokens} tokens sent and {used.output_tokens} received, for {cost}."
        )

    def ask(
        self, question: Question, answer: type[T], check: Check | None = None, n: int = 1
    ) -> tuple[tuple[T, ...], tuple[InputError | ModelError, ...]]:
        """Return the answers of a type that came to a question that is asked n times at once, and the errors of the others.

        Under a budget one is asked first: its cost tells how many more fit. What is wrong with an answer, as `check` tells it in
        words, goes back to the model, at most twice. Where no answer came, the first error is raised.
        """
        questions = [replace(question, sample=i + 1, seed=question.seed + i) for i in range(n)]
        ahead = 1 if self.budget.most is not None else n
        with start_blocking_portal() as portal:  # an event loop of its own: one may be running here (a notebook)
            found = portal.call(self._ask_all, questions[:ahead], answer, check)
            if n > ahead:
                found += portal.call(self._ask_all, questions[ahead:], answer, check)
        failures = tuple(one for one in found if isinstance(one, InputError | ModelError))
        answers = tuple(one for one in found if not isinstance(one, InputError | ModelError))
        if not answers:
            raise failures[0]
        return answers, failures

    async def _ask_all(
        self, questions: Sequence[Question], answer: type[T], check: Check | None
    ) -> list[T | InputError | ModelError]:
        async with self._opened() as model:
            return await asyncio.gather(*(self._settled(model, question, answer, check) for question in questions))

    def _opened(self) -> Model:
        """Return the model to ask: with those that stand in for it, and no more questions at once than allowed."""
        if self.tape.replay:
            self._models = [TestModel()]  # it is never asked
        else:
            self._models = [open_model(spec, priced=self.budget.most is not None) for spec in self.specs]
        model = self._models[0] if len(self._models) == 1 else FallbackModel(*self._models, fallback_on=self._falls)
        at_once = self.options.at_once
        return model if at_once is None else ConcurrencyLimitedModel(model, at_once)

    def _falls(self, error: Exception) -> bool:
        """Return whether the next model is asked after an error, and note that it is."""
        if isinstance(error, ModelAPIError):
            self.note(f"{self._sentence(error, self.spec)} The next model was asked.")
        return isinstance(error, ModelAPIError)

    def _sentence(self, error: Exception, spec: ModelSpec) -> ModelError:
        return sentence(error, spec, self.options.timeout, self.tape.scrub)

    async def _settled(
        self, model: Model, question: Question, answer: type[T], check: Check | None
    ) -> T | InputError | ModelError:
        """Ask one question; without pictures if the model turns out not to see."""
        recorded = self.tape.recorded(question)
        unseen = bool(recorded) and "request" in recorded and not recorded["request"]["images"]
        if question.images and (
            unseen or not self.sees or not self._models[0].profile.get("supports_image_input", True)
        ):
            self._blind()
            question = replace(question, parts=question.texts)
        taped = _Taped(model, self, question)
        try:
            return await self._run_agent(taped, question, answer, check)
        except (InputError, ModelError) as error:
            failure = type(error)(self.tape.scrub(str(error)))
            if isinstance(failure, InputError):
                return failure
        except FallbackExceptionGroup as group:
            failure = self._sentence(group.exceptions[-1], self.specs[-1])
        except AgentRunError as error:
            if question.images and isinstance(error, ModelHTTPError) and refuses_images(error):
                self._blind()
                return await self._settled(model, question, answer, check)
            failure = self._sentence(error, self.spec)
        taped.fail(failure)
        return failure

    def _blind(self) -> None:
        """Note that the model does not see; it is never shown a picture again."""
        self.note(f"{self.spec.name} does not take pictures; it plans from the text alone (mode no_image).")
        self.sees = False

    async def _run_agent(self, taped: _Taped, question: Question, answer: type[T], check: Check | None) -> T:
        typed = self._output(question, answer)
        agent = Agent(taped, output_type=typed, instructions=question.instructions, retries={"output": 2})

        @agent.output_validator
        def validate(context: RunContext[Any], output: Any) -> Any:
            wrong = check(output) if check and context.retry < context.max_retries else None
            if wrong:
                raise ModelRetry(wrong)
            return output

        content: list[UserContent] = []
        for part in question.parts:
            content += [part] if isinstance(part, str) else [part[0], BinaryContent(part[1], media_type="image/png")]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # what the library has to say is nothing that a user can act on
            told, limits = self._settings(question), UsageLimits(request_limit=None)
            result = await agent.run(content, model_settings=told, usage=self.spent, usage_limits=limits)
        return result.output

    def _output(self, question: Question, answer: type[Any]) -> Any:
        """Return how the answer is typed: text, a tool's arguments, or JSON for servers without tools."""
        if not issubclass(answer, BaseModel):
            return answer
        tools = not self.spec.prompted
        if self.tape.replay:
            said = (self.tape.recorded(question) or {}).get("answer") or {"parts": ()}
            tools = any(part["kind"] == "tool-call" for part in said["parts"])
        return ToolOutput(answer) if tools else PromptedOutput(answer)

    def _settings(self, question: Question) -> ModelSettings:
        options = self.options
        whole = PATIENCE * options.timeout
        settings = ModelSettings(timeout=options.timeout, request_timeout=whole, temperature=question.temperature)
        if options.thinking is not None:
            settings["thinking"] = options.thinking
        if options.cache:
            settings["cache"] = {"messages": False}
        if self.spec.prompted or (self.spec.model is None and self.spec.provider in ("openai-chat", "google")):
            settings["seed"] = question.seed  # others take none
        return settings


def to_answer(response: ModelResponse, scrub: Callable[[str], str]) -> dict[str, Any]:
    """Return what a model said as plain data, without secrets: text and tool calls, name, tokens, cost."""
    parts: list[dict[str, Any]] = []
    for part in response.parts:
        if isinstance(part, TextPart):
            parts.append({"kind": "text", "content": scrub(part.content)})
        elif isinstance(part, ToolCallPart):
            parts.append({"kind": "tool-call", "content": scrub(part.args_as_json_str()), "tool": part.tool_name})
    try:
        cost: str | None = str(response.cost().total_price)
    except (LookupError, ValueError, AssertionError):
        cost = None
    used = response.usage
    return {
        "parts": parts,
        "model": response.model_name,
        "finish_reason": response.finish_reason,
        "usage": {"input_tokens": used.input_tokens, "output_tokens": used.output_tokens, "cost": cost},
    }


def from_answer(answer: Mapping[str, Any]) -> ModelResponse:
    """Return plain data as a model's response."""
    parts = [
        TextPart(part["content"])
        if part["kind"] == "text"
        else ToolCallPart(part["tool"], part["content"], tool_call_id=f"call_{number}")
        for number, part in enumerate(answer["parts"])
    ]
    used = answer["usage"]
    cost = None if used["cost"] is None else Decimal(used["cost"])
    usage = RequestUsage(input_tokens=used["input_tokens"], output_tokens=used["output_tokens"], cost=cost)
    return ModelResponse(parts, usage=usage, model_name=answer["model"], finish_reason=answer["finish_reason"])
