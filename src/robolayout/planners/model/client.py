"""The one place that talks to a model: provider, pictures, budget, retries, recording; every failure is one sentence.

Questions are asked concurrently, each through an agent of pydantic-ai. The network lives behind `_Taped`, a model that
answers from a recording or asks the real one and records what it said. Retries after 429 and 5xx, with the wait that the
server asks for, are the provider client's own; `timeout` bounds each try and three times that the whole question.
"""

from __future__ import annotations

import asyncio
import warnings
from collections.abc import Callable, Coroutine, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from decimal import Decimal
from typing import TYPE_CHECKING, Any, TypeVar

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
from pydantic_ai.models.function import FunctionModel
from pydantic_ai.models.wrapper import WrapperModel
from pydantic_ai.settings import ModelSettings
from pydantic_ai.usage import RequestUsage

from robolayout._errors import AnswerError, BudgetError, InputError, ModelError, UnavailableError
from robolayout.planners.model.errors import refuses_images, sentence
from robolayout.planners.model.exchange import Question, Tape
from robolayout.planners.model.prompt import PROMPT_VERSION
from robolayout.planners.model.provider import Spec, open_model, price_of

if TYPE_CHECKING:
    from robolayout.planners.model.options import ModelOptions

T = TypeVar("T")
Check = Callable[[Any], str | None]

MOST_CHARACTERS = 400_000  # characters of an answer beyond which it is refused

ASTRAY = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)
"""What a provider's client trips over in an answer that is JSON but of no form that it knows."""
FAILURES = {kind.__name__: kind for kind in (ModelError, BudgetError, AnswerError, UnavailableError)}
"""How a recorded question may have failed."""

PATIENCE = 3.0  # times `timeout` that one question may take with all its tries

CHARACTERS_PER_TOKEN = 4  # characters of English or program text that make one token, where nobody counts them

TOKENS_PER_PICTURE = 1_100
"""Tokens of one of our pictures (768 pixels a side) at the providers that count them in tiles."""

FIRST_ANSWER = 1_200  # tokens that an answer is expected to have before one has come: a program for a dozen things

Price = Callable[[int, int], Decimal | None]
"""Dollars for so many tokens sent and received; None where no price is known."""


@dataclass(frozen=True)
class Usage:
    """What a planner has used so far."""

    requests: int = 0  # answers received
    input_tokens: int = 0  # tokens sent, pictures included
    output_tokens: int = 0  # tokens received
    cost: float | None = None  # US dollars; None where no price is known

    def to_dict(self) -> dict[str, int | float | None]:
        """Return the usage as it is written to the report."""
        return dict(vars(self))


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
    price: Price  # what tokens cost
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

    def settle(self, reserved: Decimal, cost: Decimal | None, received: int) -> None:
        """Give back what was set aside for a question and count what its answer cost; nothing if it never came."""
        self.reserved -= reserved
        if received:
            self._received.append(received)
        if cost is not None:
            self.spent += cost
            self._dearest = max(self._dearest, cost)


class _Taped(WrapperModel):
    """Answers one question from the recording, or asks the wrapped model and records its answer."""

    def __init__(self, wrapped: Model, client: Client, question: Question) -> None:
        super().__init__(wrapped)
        self._client, self._tape, self._question, self._spent = client, client.tape, question, client.spent
        self._turn, self._feedback = 0, ""
        self._answer: dict[str, Any] | None = None

    async def request(
        self,
        messages: list[ModelMessage],
        model_settings: ModelSettings | None,
        model_request_parameters: ModelRequestParameters,
    ) -> ModelResponse:
        """Return the answer to the next turn of the question."""
        self._turn, self._feedback, self._answer = self._turn + 1, _feedback(messages), None
        if self._tape.replay:
            return self._recalled()
        budget, cost, received = self._client.budget, None, 0
        reserved = budget.reserve(self._question, self._client.spec.name)
        try:
            response = await self.wrapped.request(messages, model_settings, model_request_parameters)
            length = sum(len(part.content) for part in response.parts if isinstance(part, TextPart))
            if not (response.usage.input_tokens or response.usage.output_tokens):
                name, sent = self._client.spec.name, tokens_of(self._question)
                self._client.note(f"{name} tells no token counts; they are estimated from characters.")
                response.usage = RequestUsage(input_tokens=sent, output_tokens=length // CHARACTERS_PER_TOKEN)
            self._answer = to_answer(response, self._tape.scrub)
            if response.finish_reason == "length":
                self._client.cut |= {part["content"] for part in self._answer["parts"]}
            told = self._answer["usage"]["cost"]
            cost, received = None if told is None else Decimal(told), response.usage.output_tokens
        except ASTRAY as error:
            told = self._tape.scrub(" ".join(f"{type(error).__name__} {error}".split()))[:100]
            raise UnexpectedModelBehavior(f"an answer of another form than asked for ({told})") from error
        finally:
            budget.settle(reserved, cost, received)
        if length > MOST_CHARACTERS:
            raise UnexpectedModelBehavior(f"an answer of {length} characters, at most {MOST_CHARACTERS} are read")
        self._tape.write(self._question, self._turn, self._answer, self._feedback)
        return from_answer(self._answer)

    def _recalled(self) -> ModelResponse:
        """Return the recorded answer, or fail as it did then."""
        entry = self._tape.recall(self._question, self._turn)
        if not entry.get("failure"):
            return from_answer(entry["answer"])
        if entry["answer"]:
            self._spent.incr(RunUsage(requests=1))
            self._spent.incr(from_answer(entry["answer"]).usage)
        raise FAILURES.get(entry.get("failed_as", ""), ModelError)(entry["failure"])

    def fail(self, failure: ModelError) -> None:
        """Record that the question failed, so that a replay fails alike."""
        if not self._tape.replay:
            self._tape.write(self._question, max(self._turn, 1), self._answer, self._feedback, failure)


class Client:
    """Asks questions of the first of some models, concurrently, and keeps count; the others stand in for it."""

    def __init__(self, specs: tuple[Spec, ...], tape: Tape, options: ModelOptions) -> None:
        self.specs, self.spec, self.tape, self.options = specs, specs[0], tape, options
        most = options.max_cost
        self.budget = Budget(None if most is None else Decimal(str(most)), self._price)
        self.sees = True
        self.notes: list[str] = []
        self.cut = set[str]()
        self.spent = RunUsage()
        self._models: tuple[Model, ...] = ()

    def note(self, sentence: str) -> None:
        """Say once what did not go as asked."""
        if sentence not in self.notes:
            self.notes.append(sentence)

    def _price(self, sent: int, received: int) -> Decimal | None:
        """Return the price at the dearest of the models that may answer; None where none has one."""
        prices = (price_of(model, sent, received) for model in self._models)
        return max((price for price in prices if price is not None), default=None)

    @property
    def usage(self) -> Usage:
        """What was used so far."""
        spent = self.spent
        cost = None if spent.cost is None else float(spent.cost)
        return Usage(spent.requests, spent.input_tokens, spent.output_tokens, cost)

    def summary(self, did: str) -> str:
        """Return who did something and what that took, in one sentence."""
        used = self.usage
        cost = "an unknown sum" if used.cost is None else f"${used.cost:.4f}"
        return (
            f"{self.spec.name} {did} (prompts of version {PROMPT_VERSION}): {used.requests} answers, "
            f"{used.input_tokens} tokens sent and {used.output_tokens} received, for {cost}."
        )

    def ask(
        self, questions: Sequence[Question], answer: type[T], check: Check | None = None
    ) -> list[T | InputError | ModelError]:
        """Return one answer of a type, or one error, per question, in order.

        Under a budget one is asked first: its cost tells how many more fit. What is wrong with an answer, as `check` tells it in
        words, goes back to the model, at most twice.
        """
        ahead = 1 if self.budget.most is not None else len(questions)
        parts = [part for part in (questions[:ahead], questions[ahead:]) if part]
        return [found for part in parts for found in _run(self._ask_all(part, answer, check))]

    async def _ask_all(
        self, questions: Sequence[Question], answer: type[T], check: Check | None
    ) -> list[T | InputError | ModelError]:
        model = self._opened()
        async with model:
            asked = [self._settled(model, question, answer, check) for question in questions]
            return list(await asyncio.gather(*asked))

    def _opened(self) -> Model:
        """Return the model to ask: with those that stand in for it, and no more questions at once than allowed."""
        if self.tape.replay:
            return FunctionModel(_never)
        self._models = tuple(open_model(spec, priced=self.budget.most is not None) for spec in self.specs)
        model = self._models[0]
        if len(self._models) > 1:
            model = FallbackModel(*self._models, fallback_on=self._falls)
        at_once = self.options.at_once
        return model if at_once is None else ConcurrencyLimitedModel(model, at_once)

    def _falls(self, error: Exception) -> bool:
        """Return whether the next model is asked after an error, and note that it is."""
        if isinstance(error, ModelAPIError):
            self.note(f"{sentence(error, self.spec, self.options.timeout, self.tape.scrub)} The next model was asked.")
        return isinstance(error, ModelAPIError)

    async def _settled(
        self, model: Model, question: Question, answer: type[T], check: Check | None
    ) -> T | InputError | ModelError:
        """Ask one question; without pictures if the model turns out not to see."""
        if question.images and not self._takes_pictures(model, question):
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
            last = group.exceptions[-1]
            failure = sentence(last, self.specs[-1], self.options.timeout, self.tape.scrub)
        except AgentRunError as error:
            if question.images and isinstance(error, ModelHTTPError) and refuses_images(error):
                self._blind()
                return await self._settled(model, question, answer, check)
            failure = sentence(error, self.spec, self.options.timeout, self.tape.scrub)
        taped.fail(failure)
        return failure

    def _takes_pictures(self, model: Model, question: Question) -> bool:
        return self.sees and model.profile.get("supports_image_input", True) and not self.tape.without_images(question)

    def _blind(self) -> None:
        """Note that the model does not see; it is never shown a picture again."""
        if self.sees:
            self.notes.append(f"{self.spec.name} does not take pictures; it plans from the text alone (mode no_image).")
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

        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # what the library has to say is nothing that a user can act on
            told, limits = self._settings(question), UsageLimits(request_limit=None)
            result = await agent.run(_content(question), model_settings=told, usage=self.spent, usage_limits=limits)
        return result.output

    def _output(self, question: Question, answer: type[Any]) -> Any:
        """Return how the answer is typed: text, a tool's arguments, or JSON for servers without tools."""
        if not issubclass(answer, BaseModel):
            return answer
        tools = not self.spec.prompted
        if self.tape.replay:
            tools = any(part["kind"] == "tool-call" for part in self.tape.recorded_parts(question))
        return ToolOutput(answer) if tools else PromptedOutput(answer)

    def _settings(self, question: Question) -> ModelSettings:
        options = self.options
        whole = PATIENCE * options.timeout
        settings = ModelSettings(timeout=options.timeout, request_timeout=whole, temperature=question.temperature)
        if options.thinking is not None:
            settings["thinking"] = options.thinking
        if options.cache:
            settings["cache"] = {"messages": False}
        if self.spec.seeded:
            settings["seed"] = question.seed
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


def _content(question: Question) -> list[UserContent]:
    content: list[UserContent] = []
    for part in question.parts:
        content += [part] if isinstance(part, str) else [part[0], BinaryContent(part[1], media_type="image/png")]
    return content


def _feedback(messages: Sequence[ModelMessage]) -> str:
    """Return what was wrong with the answer before; empty at the first turn."""
    parts = messages[-1].parts if len(messages) > 1 else ()
    return "\n".join(content for part in parts if isinstance(content := getattr(part, "content", None), str))


def _never(messages: list[ModelMessage], info: Any) -> ModelResponse:
    raise ModelError("a replay never asks a model")


def _run(coroutine: Coroutine[Any, Any, T]) -> T:
    """Run a coroutine to its end, also where an event loop is running already (a notebook)."""
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return asyncio.run(coroutine)
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(asyncio.run, coroutine).result()
