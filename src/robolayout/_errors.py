"""All errors of RoboLayout, sorted by who must act.

RoboLayoutError
├── InputError                 the user's input is wrong (exit code 2)
│   ├── SceneError             a scene file cannot be read or makes no sense
│   ├── LayoutError            a layout file cannot be read or does not fit its scene
│   ├── AgentError             an agent profile is unknown or makes no sense
│   ├── AssetError             an asset's mesh, metadata or folder is unusable
│   ├── ProgramError           a constraint program cannot be read (line and caret)
│   │   └── ProgramLimitError  a constraint program ran over its time, memory or size
│   ├── UnknownNameError       a name is not one of those known
│   ├── OutputError            the output cannot be written
│   └── MissingExtraError      an optional dependency is not installed
└── ModelError                 a model provider failed or its answers stayed unusable
    ├── BudgetError            the money allowed for a model does not reach for its next answer
    ├── UnavailableError       a model's server is busy, broken, slow, or answers what is no answer
    └── AnswerError            a model answered, but its answers stayed unusable
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from typing import Any

MOST = 100  # characters of an unknown name, and known names, that a message shows


def did_you_mean(name: str, known: Iterable[str]) -> str:
    """Return the question whether the known name most like a wrong one was meant, after a blank; nothing if none is."""
    near = difflib.get_close_matches(name, list(known), n=1)
    return f" Did you mean {near[0]!r}?" if near else ""


class RoboLayoutError(Exception):
    """Base of every error that RoboLayout raises on purpose."""

    def __reduce__(self) -> tuple[Any, ...]:
        """Return how to make it again in another process; its own arguments are not those of `Exception`."""
        return _again, (type(self), self.args, vars(self))


def _again(kind: type[RoboLayoutError], args: tuple[Any, ...], attributes: dict[str, Any]) -> RoboLayoutError:
    error = kind.__new__(kind, *args)
    vars(error).update(attributes)
    return error


class InputError(RoboLayoutError):
    """The user's input is wrong; the message names the thing, the value, what is allowed and the next step."""


class SceneError(InputError):
    """A scene file cannot be read or describes an impossible room."""


class LayoutError(InputError):
    """A layout file cannot be read or does not fit its scene."""


class AgentError(InputError):
    """An agent profile is unknown or its figures make no sense."""


class AssetError(InputError):
    """An asset's mesh, metadata or folder is unusable."""


class ProgramError(InputError):
    """A constraint program cannot be read.

    Args:
        message: What is wrong, in one sentence.
        line: Line of the program text, counted from 1; None when no line is to blame.
        source: That line's text, shown under the message.
        column: Column of the caret, counted from 0.
    """

    def __init__(
        self, message: str, *, line: int | None = None, source: str | None = None, column: int | None = None
    ) -> None:
        self.line = line
        self.source = source
        self.column = column
        text = message if line is None else f"line {line}: {message}"
        if source is not None:
            text += f"\n    {source}"
            if column is not None:
                text += f"\n    {' ' * column}^"
        super().__init__(text)


class ProgramLimitError(ProgramError):
    """A constraint program ran over its limit of time, memory, steps or output."""


class UnknownNameError(InputError):
    """A name is not one of those known."""

    def __init__(self, kind: str, name: str, known: Iterable[str]) -> None:
        self.kind = kind
        self.name = name
        self.known = sorted(known)
        shown = name if len(name) <= MOST else f"{name[:MOST]}..."
        more = f", ... ({len(self.known)} in all)" if len(self.known) > MOST else ""
        super().__init__(
            f"unknown {kind} {shown!r}.{did_you_mean(shown, self.known)} Known: {', '.join(self.known[:MOST])}{more}."
        )


def among(kind: str, names: Iterable[str], known: Iterable[str]) -> None:
    """Refuse the first name that is not known."""
    known = tuple(known)
    for name in (name for name in names if name not in known):
        raise UnknownNameError(kind, name, known)


class OutputError(InputError):
    """The output folder or file cannot be written."""


class MissingExtraError(InputError):
    """An optional dependency is not installed."""

    def __init__(self, feature: str, extra: str, *, package: bool = False) -> None:
        self.extra = extra
        if package:
            super().__init__(f"{feature} needs the package {extra!r}: pip install {extra}.")
        else:
            super().__init__(f"{feature} needs the extra {extra!r}: pip install 'robolayout[{extra}]'.")


class ModelError(RoboLayoutError):
    """A model provider failed, refused, or its answers stayed unusable."""


class BudgetError(ModelError):
    """The money allowed for a model does not reach for its next answer; a room is made all the same."""


class UnavailableError(ModelError):
    """A model's server is busy, broken, slow, or answers what is no answer; a room is made all the same."""


class AnswerError(ModelError):
    """A model answered, but its answers stayed unusable (refused, cut off, no JSON); a room is made all the same."""
