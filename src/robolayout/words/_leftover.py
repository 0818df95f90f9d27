"""No word is dropped: what no row of the ledger would be about is given back with its clause as not understood."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from robolayout.words._chunk import MARKS, Chunk
from robolayout.words._function_words import LED
from robolayout.words._said import Parsed, same
from robolayout.words._tokens import count_of

PICKING = frozenset(["left", "right", "own", "same", "middle", "other", "front", "back"])
"""Words before a noun that tell one thing from others of its kind."""

_RELATING = "left right between under against above below near inside into onto around sides"
RELATING = frozenset(_RELATING.split())
"""Small words that say where a thing stands."""

SILENT = ("comma", "stop", "colon", "and", "with", "verb", "pron", "filler")
"""Kinds of chunks that ask for nothing by themselves."""


def leftover(chunks: Sequence[Chunk], said: Parsed) -> list[Chunk]:
    """Return every chunk that says something and is part of no row, with its whole clause; one for each clause."""
    noted = [chunk for chunk in (*said.facts, *said.missed) if chunk.kind != "rel"]
    spans = [(part.start, part.end) for part in (*noted, *said.links)]
    spans += [thing.spans[0] for thing in said.things if thing.spans]
    spans += [span for _, span in (*said.refused, *said.openings)]
    covered = said.read.union(*(range(*span) for span in spans))
    found: dict[int, Chunk] = {}
    for clause in _clauses(chunks):
        start, end = clause[0].start, clause[-1].end
        refused = any(start <= at < end for _, (at, _) in said.refused)
        refused = refused or any(start <= k.start < end for k in said.links if k.relation in ("apart", "bare", "far"))
        for i, chunk in enumerate(clause):
            told = _named(chunk, said) or bool(covered.intersection(range(chunk.start, chunk.end)))
            if not told and _says(chunk, clause[i + 1 :]) and not (chunk.kind == "not" and refused):
                found.setdefault(start, replace(chunk, start=start, end=end))
    alone = [c for c in said.missed if c.kind != "rel" and not any(f.start <= c.start < f.end for f in found.values())]
    return [*alone, *found.values()]


def _named(chunk: Chunk, said: Parsed) -> bool:
    """Return whether a noun phrase only names again what another row is about: no more of it, and not otherwise."""
    again = [thing for thing in said.things if (chunk.start, chunk.end) in thing.spans[1:]]
    alike = [thing for thing in said.things if same(thing, chunk)]
    known = {word for thing in alike for word in (*thing.adjectives, *thing.told, *thing.noun.said.split())}
    return any((chunk.number or 1) <= thing.count for thing in again) and {*chunk.adjectives} <= known | PICKING


def _says(chunk: Chunk, after: Sequence[Chunk]) -> bool:
    """Return whether a chunk asks for something: of the small words numbers do, and verbs of place with no relation after them."""
    if chunk.kind == "part" and chunk.value in ("room", "floor"):
        return bool(chunk.number and chunk.number > 1)
    if chunk.kind == "part" and chunk.value == "side" and chunk.det and [other.kind for other in after[:1]] == ["rel"]:
        return False  # "its headboard touches the wall"
    if chunk.kind == "verb" and chunk.value in LED:
        return not any(other.kind == "rel" for other in after)
    where = chunk.value in RELATING and [other.kind for other in after[:1]] not in (
        ["rel"],
        ["measure"],
    )  # "right behind"
    told = chunk.kind == "filler" and ((count_of(chunk.value) or 0) > 1 or where)
    return chunk.kind not in SILENT or told


def _clauses(chunks: Sequence[Chunk]) -> list[list[Chunk]]:
    """Return the chunks between one mark and the next."""
    clauses: list[list[Chunk]] = [[]]
    for chunk in chunks:
        if chunk.kind in MARKS.values():
            clauses.append([])
        else:
            clauses[-1].append(chunk)
    return [clause for clause in clauses if clause]
