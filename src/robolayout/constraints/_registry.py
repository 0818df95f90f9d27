"""The relations that programs may use: the built-in ones, those of installed packages, and those a user registers."""

from __future__ import annotations

import dataclasses
import importlib.util
import inspect
import os
import sys
import traceback
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import MappingProxyType, ModuleType
from typing import TypeVar

from robolayout._errors import InputError
from robolayout._reading.syntax import FOREIGN_ERRORS
from robolayout.constraints._relation import Relation

_KNOWN: dict[str, type[Relation]] = {}

RELATIONS: Mapping[str, type[Relation]] = MappingProxyType(_KNOWN)
"""All relations by the word that names them in a program."""

AnyRelation = TypeVar("AnyRelation", bound=type[Relation])


def register(relation: AnyRelation) -> AnyRelation:
    """Make a relation known to every reader and planner of this process, and return it (so it may stand as a decorator)."""
    faults = list(_faults(relation))
    if faults:
        raise InputError(f"the relation {relation.__name__} cannot be registered: {'; '.join(faults)}.")
    _KNOWN[relation.name] = relation
    return relation


def register_file(path: str | Path) -> tuple[type[Relation], ...]:
    """Run a Python file of your own and register every relation that it defines.

    The file runs with all your rights: load only what you wrote or read.
    """
    path = Path(path)
    name = f"robolayout_relations_{path.stem}"
    spec = importlib.util.spec_from_file_location(name, path)
    if not os.path.isfile(path) or spec is None or spec.loader is None:
        raise InputError(
            f"{path} is no Python file, or not there; relations are read from a file such as my_relations.py."
        )
    module = sys.modules[name] = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(module)
    except FOREIGN_ERRORS as error:
        lines = [frame.lineno for frame in traceback.extract_tb(error.__traceback__) if frame.filename == str(path)]
        line = error.lineno if isinstance(error, SyntaxError) else lines[-1] if lines else None
        reason = " ".join(f"{type(error).__name__}: {error}".split())[:300]
        raise InputError(f"{path} cannot be run (line {line}): {reason}. Correct the file.") from error
    found = own_relations(module)
    if not found:
        raise InputError(f"{path} defines no relation, that is, no class derived from robolayout.constraints.Relation.")
    return tuple(register(relation) for relation in found)


def own_relations(module: ModuleType) -> list[type[Relation]]:
    """Return the relations that a module defines, in its order."""
    found = (value for value in vars(module).values() if inspect.isclass(value) and issubclass(value, Relation))
    return [relation for relation in found if relation.__module__ == module.__name__]


def _faults(relation: type[Relation]) -> Iterator[str]:
    """Yield what keeps a class from being a relation, in words."""
    if not dataclasses.is_dataclass(relation) or not relation.__dataclass_params__.frozen:  # type: ignore[attr-defined]
        yield "it is not a frozen dataclass"
        return
    for method in sorted(relation.__abstractmethods__):
        yield f"it has no {method}()"
    name = getattr(relation, "name", "")
    earlier = _KNOWN.get(name)
    if not name.isidentifier() or name.startswith("_"):
        yield f"its name {name!r} is no word for a program, such as 'next_to'"
    elif earlier is not None and _origin(earlier) != _origin(relation):
        yield f"the word {name!r} is taken by {earlier.__module__}.{earlier.__name__}"
    if not getattr(relation, "example", ""):
        yield "it has no example, one line of program text"
    yield from _argument_faults(relation)


def _argument_faults(relation: type[Relation]) -> Iterator[str]:
    fields = relation.arguments()
    for field in fields:
        if "takes" not in field.metadata:
            yield f"{field.name} is not declared with argument(...)"
        if f"`{field.name}`" not in relation.meaning():
            yield f"the first line of its docstring does not explain `{field.name}`"
    for name in relation.moves:
        if name not in {field.name for field in fields}:
            yield f"moves names {name!r}, which is no argument"


def _origin(relation: type[Relation]) -> tuple[str, str]:
    return (relation.__module__, relation.__qualname__)
