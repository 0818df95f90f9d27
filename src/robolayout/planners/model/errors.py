"""What goes wrong with a provider, in one sentence each: what happened, with which model, and what to do next."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import Any, cast
from urllib.parse import urlsplit

from pydantic_ai.exceptions import (
    ModelAuthenticationError,
    ModelConnectionError,
    ModelContextWindowExceededError,
    ModelHTTPError,
    ModelNotFoundError,
    ModelQuotaExceededError,
    ModelRateLimitError,
    ModelRequestTimeout,
    ModelTimeoutError,
)

from robolayout._errors import AnswerError, ModelError, UnavailableError
from robolayout.planners.model.provider import ModelSpec, nearest_model

SEES = re.compile(r"image|vision|multi-?modal|picture|mmproj", re.IGNORECASE)
"""Words of a provider that says it does not take pictures."""

BUSY = (408, 409, 425, 429)
"""Refusals of a server that pass by themselves; others need the user: a key, a name, a smaller room."""

LONGEST_REASON = 300  # characters of a provider's own message that are shown

QUOTED = re.compile(r"\s*[:,]?\s*(body: )?([{<]|\[(?!secret\])).*$")
"""The raw JSON or page that a library quotes in its message."""

REFUSALS: tuple[tuple[type[Exception], str], ...] = (
    (
        ModelAuthenticationError,
        "{name} refused the key ({status}): {reason}. Check the key in the environment and what it allows.",
    ),
    (ModelNotFoundError, "there is no model {name!r} ({status}): {reason}.{near} Check the name."),
    (ModelQuotaExceededError, "the account for {name} has no credit left ({status}): {reason}."),
    (
        ModelRateLimitError,
        "{name} is still busy after several tries ({status}): {reason}. Try again later, or with fewer --samples.",
    ),
    (
        ModelContextWindowExceededError,
        "the room is too large for {name} ({status}): {reason}. Use --mode grouped or no_image, or a larger model.",
    ),
    (ModelHTTPError, "{name}{tried} ({status}): {reason}."),
)
"""What a server's refusal means, the first that fits."""


def refuses_images(error: ModelHTTPError) -> bool:
    """Return whether a server turned a request down because of its pictures."""
    return 400 <= error.status_code <= 501 and error.status_code != 429 and bool(SEES.search(_reason(error)))


def sentence(error: Exception, spec: ModelSpec, timeout: float, scrub: Callable[[str], str]) -> ModelError:
    """Return an error of the model client as one of ours."""
    name = spec.name
    if isinstance(error, ModelTimeoutError | ModelRequestTimeout):
        late = f"{name} did not answer within {timeout:g} s"
        return UnavailableError(f"{late}. Raise --timeout, or choose a faster model.")
    causes = _chain(error)
    ours = next((cause for cause in causes if isinstance(cause, UnavailableError)), None)
    if ours is not None:  # what we refuse to read is no broken connection, whatever a client makes of it
        return ours
    if isinstance(error, ModelConnectionError):
        # "connection refused" under three wrappings: the system's words, if it spoke
        root = next((cause for cause in reversed(causes) if isinstance(cause, OSError)), causes[-1])
        parts = urlsplit(spec.base_url or "")  # without any password
        host = f"{parts.hostname}:{parts.port}" if parts.port else parts.hostname or spec.provider
        return ModelError(
            f"cannot connect to {host} for {name}: {_one_line(str(root))}. Is the server running, and the address right?"
        )
    reason = QUOTED.sub("", scrub(_reason(error)))[:LONGEST_REASON] or "it does not have the form asked for"
    if not isinstance(error, ModelHTTPError):
        return AnswerError(f"{name} gave no usable answer: {reason}.")
    status, near = error.status_code, ""
    if isinstance(error, ModelNotFoundError):
        suggestion = error.suggested_model_id or nearest_model(name)
        near = f" Did you mean {suggestion!r}?" if suggestion else ""
    tried = " failed after several tries" if status >= 500 else ""
    meaning = next(words for kind, words in REFUSALS if isinstance(error, kind))
    passes = (status >= 500 or status in BUSY) and not isinstance(error, ModelQuotaExceededError)
    return (UnavailableError if passes else ModelError)(
        meaning.format(name=name, status=status, reason=reason, near=near, tried=tried)
    )


def _reason(error: Exception) -> str:
    """Return the provider's own message, on one line: OpenAI's body has a message, Anthropic's an error with a message."""
    body: Any = getattr(error, "body", None)
    if isinstance(body, dict):
        told = cast("dict[str, Any]", body)
        inner = told.get("error")
        words = told.get("message") or (inner.get("message") if isinstance(inner, dict) else inner)
        body = words if isinstance(words, str) else json.dumps(words or told, default=str)
    return _one_line(str(body or getattr(error, "message", "") or error))


def _one_line(text: str) -> str:
    return " ".join(text.split()).rstrip(".") or "no reason given"


def _chain(error: BaseException) -> list[BaseException]:
    """Return an error and its causes, the first cause last."""
    chain = [error]
    while len(chain) < 20 and (cause := chain[-1].__cause__ or chain[-1].__context__):
        chain.append(cause)
    return chain
