"""Checks the entries of a knowledge file against the fields of the class that they become."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import MISSING, fields
from typing import Any, TypeVar

from robolayout._errors import SceneError, UnknownNameError
from robolayout._reading import show

Kind = TypeVar("Kind")


def _is_text(value: object) -> bool:
    return isinstance(value, str)


def _is_whole(value: object) -> bool:
    return isinstance(value, int) and not isinstance(value, bool)


def _is_number(value: object) -> bool:
    return isinstance(value, float) or _is_whole(value)


def _is_list(value: object, holds: Callable[[object], bool]) -> bool:
    return isinstance(value, list | tuple) and all(holds(item) for item in value)


def _is_table(value: object, holds: Callable[[object], bool]) -> bool:
    return isinstance(value, Mapping) and all(holds(item) for item in value.values())


SHAPES: dict[str, tuple[str, Callable[[object], bool]]] = {
    "str": ("a text in quotes", _is_text),
    "str | None": ("a text in quotes", _is_text),
    "int": ("a whole number", _is_whole),
    "float": ("a number", _is_number),
    "bool": ("true or false", lambda value: isinstance(value, bool)),
    "tuple[str, ...]": ("a list of texts", lambda value: _is_list(value, _is_text)),
    "tuple[float, float]": ("two numbers", lambda value: _is_list(value, _is_number) and len(value) == 2),  # type: ignore[arg-type]
    "tuple[float, float, float]": ("three numbers", lambda value: _is_list(value, _is_number) and len(value) == 3),  # type: ignore[arg-type]
    "Mapping[str, float]": ("a table of numbers", lambda value: _is_table(value, _is_number)),
    "Mapping[str, int]": ("a table of whole numbers", lambda value: _is_table(value, _is_whole)),
    "Mapping[str, tuple[str, ...]]": (
        "a table of lists of texts",
        lambda value: _is_table(value, lambda item: _is_list(item, _is_text)),
    ),
}
"""What is asked for, in words and as a test, by the annotation of the field."""


def build(kind: type[Kind], entry: Mapping[str, Any], where: str) -> Kind:
    """Return an entry of a file as its class; lists become tuples.

    Args:
        kind: The dataclass.
        entry: Values by key; those that are no plain values already are left as they are.
        where: What the entry is, for messages ("the role 'harp'").

    Raises:
        SceneError: A key is missing, unknown, or holds a value of the wrong kind.
    """
    known = {field.name: field for field in fields(kind)}  # type: ignore[arg-type]
    for key, value in table(entry, where).items():
        if key not in known:
            raise UnknownNameError(f"key in {where}:", key, known)
        words, holds = SHAPES.get(str(known[key].type), ("", None))
        if holds is not None and not holds(value):
            raise SceneError(f"{where}: {key} must be {words}, but is {show(value)}.")
    for name, field in known.items():
        if name not in entry and field.default is MISSING and field.default_factory is MISSING:
            raise SceneError(f'{where} lacks the key "{name}"; add it.')
    return kind(**{key: tuple(item) if isinstance(item, list) else item for key, item in entry.items()})


def tables(value: object, where: str) -> list[dict[str, Any]]:
    """Return a list of tables ("[[role]]") as it is.

    Raises:
        SceneError: It is something else.
    """
    if not isinstance(value, list) or not all(isinstance(item, dict) for item in value):
        raise SceneError(f"{where} must be a list of tables, but is {show(value)}.")
    return [dict(item) for item in value]


def table(value: object, where: str) -> dict[str, Any]:
    """Return a table as it is.

    Raises:
        SceneError: It is something else.
    """
    if not isinstance(value, Mapping):
        raise SceneError(f"{where} must be a table, but is {show(value)}.")
    return dict(value)


def among(kind: str, names: Iterable[str], known: Iterable[str]) -> None:
    """Refuse the first name that is not known."""
    known = tuple(known)
    for name in names:
        if name not in known:
            raise UnknownNameError(kind, name, known)
