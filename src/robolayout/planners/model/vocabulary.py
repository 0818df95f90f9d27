"""The relations as a section of the prompt, made from the vocabulary itself, so that a new relation is known at once."""

from __future__ import annotations

import dataclasses
from typing import Any

from robolayout.constraints import RELATIONS, Relation

WORDS = {"none": "None", "room": "None", "point": "(x, y)"}
"""How kinds of arguments are written, where not by their own name."""


WISHES = (
    "Each of these is a demand. As a wish it is only weighed against others, with a weight (below 0: rather not): "
    "`solver.wish.at_window(desk[0], weight=0.8)`"
)
"""What a model must know of wishes."""


def vocabulary() -> str:
    """Return signature, meaning and example of every relation that a program may state, and how it becomes a wish."""
    return "\n\n".join([*(entry(relation) for relation in RELATIONS.values() if not relation.implicit), WISHES])


def entry(relation: type[Relation]) -> str:
    """Return what a model must know of one relation."""
    moving = f" Both `{relation.moves[0]}` and `{relation.moves[1]}` move." if len(relation.moves) == 2 else ""
    heading = " Settles the heading." if relation.orients else ""
    shown = ", ".join(_argument(field) for field in relation.arguments())
    return f"`solver.{relation.name}({shown})`\n{relation.meaning()}{moving}{heading}\nExample: `{relation.example}`"


def _argument(field: dataclasses.Field[Any]) -> str:
    """Return an argument as it is written in a signature: `max_gap: number in m = 0.3`."""
    meta = field.metadata
    takes: tuple[str, ...] = meta["takes"]
    kinds = [f'"{choice}"' for choice in meta["choices"]] or [WORDS.get(kind, kind) for kind in takes]
    text = " | ".join(kinds)
    if meta["many"]:
        text = f"list of {text}"
    if meta["unit"]:
        text = text.replace("number", f"number in {meta['unit']}")
    if field.default is dataclasses.MISSING:
        return f"{field.name}: {text}"
    default = f"{field.default:g}" if isinstance(field.default, float) else repr(field.default)
    return f"{field.name}: {text} = {default}"
