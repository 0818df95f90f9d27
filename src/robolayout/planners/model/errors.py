"""What goes wrong with a provider, in one sentence each: what happened, with which model, and what to do next."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from typing import cast

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
from robolayout.planners.model.provider import Spec, nearest_model

SEES = re.compile(r"image|vision|multi-?modal|picture|mmproj", re.IGNORECASE)
"""Words of a provider that says it does not take pictures."""

BUSY = (408, 409, 425, 429)
"""Refusals of a server that pass by themselves; others need the user: a key, a name, a smaller room."""

LONGEST_REASON = 300  # characters of a provider's own message that are shown


def refuses_images(error: ModelHTTPError) -> bool:
    """Return whether a server turned a request down because of its pictures."""
    return 400 <= error.status_code <= 501 and error.status_code != 429 and bool(SEES.search(_reason(error)))


def sentence(error: Exception, spec: Spec, timeout: float, scrub: Callable[[str], str]) -> ModelError:
    """Return an error of the model client as one of ours."""
    name = spec.name
    if isinstance(error, ModelTimeoutError | ModelRequestTimeout):
        late = f"{name} did not answer within {timeout:g} s"
        return UnavailableError(f"{late}. Raise --timeout, or choose a faster model.")
    ours = next((cause for cause in _chain(error) if isinstance(cause, UnavailableError)), None)
    if ours is not None:  # what we refuse to read is no broken connection, whatever a client makes of it
        return ours
    if isinstance(error, ModelConnectionError):
        return ModelError(
            f"cannot connect to {spec.address} for {name}: {_first_line(str(_root(error)))}. Is the server running, and the address right?"
        )
    reason = unquoted(scrub(_reason(error)))[:LONGEST_REASON]
    if not isinstance(error, ModelHTTPError):
        return AnswerError(f"{name} gave no usable answer: {reason}.")
    busy = error.status_code >= 500 or error.status_code in BUSY
    kind = UnavailableError if busy and not isinstance(error, ModelQuotaExceededError) else ModelError
    return kind(_http_sentence(error, name, reason))


def unquoted(reason: str) -> str:
    """Return a reason without the raw JSON or page that a library quotes in it."""
    return re.sub(r"\s*[:,]?\s*(body: )?([{<]|\[(?!secret\])).*$", "", reason) or "it does not have the form asked for"


def _http_sentence(error: ModelHTTPError, name: str, reason: str) -> str:
    status = error.status_code
    if isinstance(error, ModelAuthenticationError):
        return f"{name} refused the key ({status}): {reason}. Check the key in the environment and what it allows."
    if isinstance(error, ModelNotFoundError):
        suggestion = error.suggested_model_id or nearest_model(name)
        near = f" Did you mean {suggestion!r}?" if suggestion else ""
        return f"there is no model {name!r} ({status}): {reason}.{near} Check the name."
    if isinstance(error, ModelQuotaExceededError):
        return f"the account for {name} has no credit left ({status}): {reason}."
    if isinstance(error, ModelRateLimitError):
        busy = f"{name} is still busy after several tries ({status})"
        return f"{busy}: {reason}. Try again later, or with fewer --samples."
    if isinstance(error, ModelContextWindowExceededError):
        large = f"the room is too large for {name} ({status})"
        return f"{large}: {reason}. Use --mode grouped or no_image, or a larger model."
    return f"{name}{' failed after several tries' if status >= 500 else ''} ({status}): {reason}."


def _reason(error: Exception) -> str:
    """Return the provider's own message, on one line."""
    body = getattr(error, "body", None)
    if isinstance(body, dict):
        body = _message(cast("dict[str, object]", body))
    return _first_line(str(body or getattr(error, "message", "") or error))


def _message(body: dict[str, object]) -> str:
    """Return the words in an error's body: OpenAI's has a message, Anthropic's an error with a message."""
    inner = body.get("error")
    words = cast("dict[str, object]", inner).get("message") if isinstance(inner, dict) else inner
    found = body.get("message") or words
    return found if isinstance(found, str) else json.dumps(found or body, default=str)


def _first_line(text: str) -> str:
    return " ".join(text.split()).rstrip(".") or "no reason given"


def _chain(error: BaseException) -> list[BaseException]:
    """Return an error and its causes, the first cause last."""
    chain = [error]
    for _ in range(20):
        cause = chain[-1].__cause__ or chain[-1].__context__
        if cause is None:
            break
        chain.append(cause)
    return chain


def _root(error: BaseException) -> BaseException:
    """Return the first cause of an error ("connection refused" under three wrappings): the system's, if it spoke."""
    chain = _chain(error)
    return next((cause for cause in reversed(chain) if isinstance(cause, OSError)), chain[-1])
