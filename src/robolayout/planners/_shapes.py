"""Checks the entries of a knowledge file against the fields of the class that they become."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import MISSING, fields
from functools import cache
from typing import Any, TypeVar, cast, get_args, get_origin, get_type_hints

from robolayout._errors import SceneError, among
from robolayout._reading import show

Kind = TypeVar("Kind")
_KINDS = cache(get_type_hints)

WORDS = {
    "str": "a text in quotes",
    "str | None": "a text in quotes",
    "int": "a whole number",
    "float": "a number",
    "bool": "true or false",
    "tuple[str, ...]": "a list of texts",
    "tuple[float, float]": "two numbers",
    "tuple[float, float, float]": "three numbers",
    "Mapping[str, float]": "a table of numbers",
    "Mapping[str, int]": "a table of whole numbers",
    "Mapping[str, tuple[str, ...]]": "a table of lists of texts",
}
"""What is asked for, by the annotation of the field; fields of other kinds hold what was made before."""


def _fits(value: object, kind: Any) -> bool:
    """Return whether a value is of an annotated kind: a list for a tuple, a whole number for any number."""
    inner = get_args(kind)
    if get_origin(kind) is tuple:
        sized = isinstance(value, list | tuple) and (inner[-1] is ... or len(value) == len(inner))
        return sized and all(_fits(item, inner[0]) for item in cast("Sequence[object]", value))
    if get_origin(kind) is Mapping:
        return isinstance(value, Mapping) and all(_fits(item, inner[1]) for item in value.values())
    return isinstance(value, bool) == (kind is bool) and isinstance(value, int | float if kind is float else kind)


def build(kind: type[Kind], entry: Mapping[str, Any], where: str) -> Kind:
    """Return an entry of a file as a dataclass; a key that is missing, unknown or of the wrong kind is refused."""
    known, kinds = {field.name: field for field in fields(kind)}, _KINDS(kind)  # type: ignore[arg-type]
    among(f"key in {where}:", table(entry, where), known)
    for key, field in known.items():
        words = WORDS.get(str(field.type))
        if key in entry and words is not None and not _fits(entry[key], kinds[key]):
            raise SceneError(f"{where}: {key} must be {words}, but is {show(entry[key])}.")
        if key not in entry and field.default is MISSING and field.default_factory is MISSING:
            raise SceneError(f'{where} lacks the key "{key}"; add it.')
    return kind(**{key: tuple(item) if isinstance(item, list) else item for key, item in entry.items()})


def tables(value: object, where: str) -> list[dict[str, Any]]:
    """Return a list of tables ("[[role]]") as it is; anything else is refused."""
    if not isinstance(value, list) or not all(isinstance(item, dict) for item in value):
        raise SceneError(f"{where} must be a list of tables, but is {show(value)}.")
    return [dict(item) for item in value]


def table(value: object, where: str) -> dict[str, Any]:
    """Return a table as it is; anything else is refused."""
    if not isinstance(value, Mapping):
        raise SceneError(f"{where} must be a table, but is {show(value)}.")
    return dict(value)
