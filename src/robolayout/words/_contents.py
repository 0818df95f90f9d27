"""What a tray or a basket has in it belongs to its own phrase: "a kettle, a tray with four cups and a jar" are three things in a row."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from robolayout.words._chunk import NOTHING, Chunk
from robolayout.words._function_words import CONTAINERS


def contained(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Return phrases with what containers have in their own: "with", "that holds", "holding" and small things up to a comma."""
    found: list[Chunk] = []
    at = 0
    while at < len(chunks):
        held, end = _held(chunks, at)
        found.append(replace(chunks[at], held=tuple(held), end=chunks[end - 1].end) if held else chunks[at])
        at = end if held else at + 1
    return found


def _held(chunks: Sequence[Chunk], at: int) -> tuple[list[Chunk], int]:
    """Return what a container has in it, and the place after that."""
    container, i = chunks[at], at + 1
    kind = container.noun.category if container.noun is not None else None
    if kind is None or kind.name.split()[-1] not in CONTAINERS or kind.on_floor or container.det == "the":
        return [], i
    i += _next(chunks, i).value in ("that", "which")
    if not (_next(chunks, i).kind == "with" or _next(chunks, i).value == "holds"):
        return [], i
    before = chunks[at - 1].kind if at else ""
    held = [_next(chunks, i + 1)] if _is_small(_next(chunks, i + 1)) else []
    i += 2
    if held and _next(chunks, i).kind == "and" and before != "comma" and _is_small(_next(chunks, i + 1)):
        held.append(chunks[i + 1])  # of what comes after "and" in a list that began before, the list is
        i += 2
    ends = [_next(chunks, i + k).value for k in range(4)]
    listed = before in ("and", "comma") and ends[2:] != ["on", "it"]
    if ends[:2] == ["in", "it"] or (ends[:2] == ["on", "it"] and not listed):
        return held, i + 2
    if _next(chunks, i).kind in ("rel", "verb", "with") and len(held) > 1 and ends[:2] != ["on", "it"]:
        return [], at + 1  # "a tray with a cup and a lamp beside it"
    return held, i


def _is_small(chunk: Chunk) -> bool:
    return chunk.noun is not None and chunk.det != "the" and any(kind.on_object for kind in chunk.noun.categories[:1])


def _next(chunks: Sequence[Chunk], at: int) -> Chunk:
    return chunks[at] if at < len(chunks) else NOTHING
