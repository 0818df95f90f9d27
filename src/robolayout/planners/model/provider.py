"""Which model, and where it is: `openai:gpt-4o`, `ollama:llava`, or a name and the address of a compatible server."""

from __future__ import annotations

import difflib
import os
import re
from collections.abc import AsyncIterator
from dataclasses import dataclass
from decimal import Decimal
from typing import Any
from urllib.parse import urlsplit

import httpx2
from genai_prices import Usage, calc_price
from genai_prices.data_snapshot import get_snapshot
from pydantic_ai.exceptions import UserError
from pydantic_ai.models import Model, create_async_httpx2_client, infer_model, known_model_names
from pydantic_ai.providers import infer_provider_class

from robolayout._errors import InputError, UnavailableError, UnknownNameError
from robolayout._reading import Checker
from robolayout._reading.syntax import decoded, json_value

OLLAMA_URL = "http://localhost:11434/v1"  # where Ollama listens unless told otherwise

PROVIDERS = (
    *("openai", "anthropic", "google", "ollama", "openrouter", "mistral", "groq", "deepseek", "xai", "azure"),
    *("bedrock", "cohere", "together", "fireworks", "huggingface", "moonshotai", "cerebras", "google-cloud"),
)
"""Providers that a message names; every further one of pydantic-ai works too."""

MOST_BYTES = 4_000_000  # bytes of one answer of a server that are read; a program needs a thousandth of that


@dataclass(frozen=True)
class ModelSpec:
    """Which model, and where it is."""

    name: str  # the model as the user wrote it ("openai:gpt-4o")
    # address of a server that speaks Anthropic's protocol (provider "anthropic") or OpenAI's; None asks the provider
    # itself
    base_url: str | None = None
    model: Model | None = None  # A ready model of pydantic-ai, used instead

    @property
    def provider(self) -> str:
        """What stands before the colon."""
        return self.name.partition(":")[0] if ":" in self.name else ""

    @property
    def prompted(self) -> bool:
        """Whether it is a server of one's own, which often has no tools: typed answers are asked for in words."""
        return self.model is None and self.provider != "anthropic" and self.base_url is not None


def spec_of(model: str | Model, base_url: str | None) -> ModelSpec:
    """Return a checked spec; raises `InputError` for a name or an address that cannot be meant."""
    if isinstance(model, Model):
        return ModelSpec(model.model_name, None, model)
    name = model.strip()
    provider, _, rest = name.partition(":")
    if base_url is None:
        if not rest:
            meant = f"openai:{name or 'gpt-4o'}"
            raise InputError(f"the model {name!r} names no provider. Write '{meant}', or give --base-url.")
        if provider in ("openai", "openai-chat"):
            base_url = os.environ.get("OPENAI_BASE_URL") or None
        elif provider == "ollama":
            base_url = os.environ.get("OLLAMA_BASE_URL") or OLLAMA_URL
        else:
            _check_provider(provider)
    if base_url is not None:
        _check_url(base_url)
    return ModelSpec(name, base_url)


def nearest_model(name: str) -> str | None:
    """Return the known model whose name is most like a wrong one, of the same provider."""
    provider = name.partition(":")[0].removesuffix("-chat")
    priced = (f"{entry.id}:{model.id}" for entry in get_snapshot().providers for model in entry.models)
    known = {model for model in (*known_model_names(), *priced) if model.startswith(f"{provider}:") and model != name}
    return next(iter(difflib.get_close_matches(name, sorted(known), n=1, cutoff=0.85)), None)


def _check_provider(provider: str) -> None:
    try:
        infer_provider_class(provider)
    except ValueError:
        raise UnknownNameError("model provider", provider, PROVIDERS) from None
    except ImportError as error:
        raise InputError(_package_sentence(provider, error)) from None


def _check_url(base_url: str) -> None:
    try:
        parts = urlsplit(base_url)
        sound = parts.scheme in ("http", "https") and bool(parts.hostname) and parts.port != 0
    except ValueError:
        sound = False
    if not sound:
        raise InputError(f"{base_url!r} is no address of a server. Give one like http://localhost:8000/v1.")


def open_model(spec: ModelSpec, *, priced: bool) -> Model:
    """Return a model ready to be asked; raises `InputError` for a missing key, package or price."""
    try:
        model = spec.model or _inferred(spec)
    except ImportError as error:
        raise InputError(_package_sentence(spec.provider, error)) from None
    except UserError as error:
        variable = re.search(r"\b[A-Z][A-Z0-9]*_(?:API_KEY|KEY|TOKEN)\b", str(error))
        if variable:
            raise InputError(
                f"{spec.provider} needs a key: set the environment variable {variable[0]} to ask {spec.name}."
            ) from None
        raise InputError(f"the model {spec.name!r} cannot be used: {str(error).split('. ')[0]}.") from None
    if priced and price_of(model, 1, 1) is None:
        raise InputError(
            f"no price is known for {spec.name}, so --max-cost cannot be kept. Leave it out, or name a model with a price."
        )
    return model


def _inferred(spec: ModelSpec) -> Model:
    """Return a model of OpenAI's or Anthropic's protocol, whose answers are bounded, or of another of pydantic-ai's."""
    if spec.base_url is None and spec.provider not in ("openai", "openai-chat", "anthropic"):
        return infer_model(spec.name)
    name = (
        spec.name.partition(":")[2] if spec.provider in ("openai", "openai-chat", "anthropic", "ollama") else spec.name
    )
    protocol = spec.provider if spec.provider in ("anthropic", "ollama") else "openai-chat"
    client = create_async_httpx2_client()
    client.headers["Accept-Encoding"] = "identity"
    client.event_hooks = {**client.event_hooks, "response": [_cap]}
    opened: Any = infer_provider_class(protocol)
    return infer_model(f"{protocol}:{name}", lambda _: opened(base_url=spec.base_url, http_client=client))


def _package_sentence(provider: str, error: ImportError) -> str:
    extra = re.search(r"pydantic-ai-slim\[([a-z-]+)\]", str(error))
    package = f"pydantic-ai-slim[{extra[1] if extra else provider}]"
    return f"{provider} models need a further package: pip install '{package}'."


def price_of(model: Model, sent: int, received: int) -> Decimal | None:
    """Return dollars for so many tokens by the price list that the client library brings; None for an unknown model."""
    try:
        tokens = Usage(input_tokens=sent, output_tokens=received)
        return calc_price(tokens, model.model_name, provider_id=model.system).total_price
    except (LookupError, ValueError):
        return None


async def _cap(response: httpx2.Response) -> None:
    """Let never more of an answer be read than `MOST_BYTES`, nor packed bytes, nor JSON that is none."""
    if response.headers.get("Content-Encoding", "identity") != "identity":
        raise UnavailableError(
            "the server answered with packed bytes, though it was asked for plain ones; they were not read."
        )
    stream = response.stream
    assert isinstance(stream, httpx2.AsyncByteStream)
    response.stream = _CappedStream(stream)
    if response.is_success and "json" in response.headers.get("Content-Type", ""):
        content = await response.aread()
        Checker(UnavailableError).parse(lambda body: json_value(decoded(body)), content, "the server's answer")


class _CappedStream(httpx2.AsyncByteStream):
    """A stream that ends in an error beyond `MOST_BYTES`."""

    def __init__(self, stream: httpx2.AsyncByteStream) -> None:
        self._stream, self.aclose = stream, stream.aclose

    async def __aiter__(self) -> AsyncIterator[bytes]:
        total = 0
        async for chunk in self._stream:
            total += len(chunk)
            if total > MOST_BYTES:
                raise UnavailableError(
                    f"the server answered with more than {MOST_BYTES // 1_000_000} MB, which is no program; it was not read."
                )
            yield chunk
