"""No word is dropped: what no row of the ledger would be about is given back with its clause as not understood."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import pairwise

from robolayout.words import _function_words as small
from robolayout.words._acting import ACTING, is_somebody
from robolayout.words._chunk import Chunk
from robolayout.words._closed import UNREAD
from robolayout.words._lexicon import grammar
from robolayout.words._said import NamedThing, Parsed, named
from robolayout.words._tokens import MARKS, count_of


def leftover(chunks: Sequence[Chunk], said: Parsed) -> list[Chunk]:
    """Return every chunk that says something and is part of no row, with its whole clause; one for each clause."""
    spans = [(part.start, part.end) for part in (*said.facts, *said.missed, *said.links)]
    spans += [thing.spans[0] for thing in said.things]
    spans += [span for _, span in (*said.refused, *said.openings)]
    covered = said.read.union(*(range(*span) for span in spans))
    found: dict[int, Chunk] = {}
    idle = _idle(chunks, said)
    named = 0  # where the last clause that names something begins
    for clause in _clauses(chunks):
        start, end = clause[0].start, clause[-1].end
        kinds = {chunk.kind for chunk in clause}
        named = start if kinds & {*small.NAMING} and "pron" not in kinds else named
        refused = any(start <= at < end for _, (at, _) in said.refused)
        refused = refused or any(start <= k.start < end for k in said.links if k.relation in small.KEPT_AWAY)
        for i, chunk in enumerate(clause):
            told = _named(chunk, said) or bool(covered.intersection(range(chunk.start, chunk.end)))
            told = told and chunk.start not in idle
            told = told or (chunk.value in ACTING and any(is_somebody(before) for before in clause[:i]))
            if not told and _says(chunk, clause[i + 1 :]) and not (chunk.kind == "not" and refused):
                if _is_of_somebody(clause) and not _asks(clause):
                    said.facts.append(Chunk("aside", start, end))
                    break
                found.setdefault(start, replace(chunk, start=named, end=end))
    apart = (*found.values(), *(fact for fact in said.facts if fact.kind == "aside"))
    alone = [c for c in said.missed if not any(f.start <= c.start < f.end for f in apart)]
    return [*alone, *found.values()]


def asides(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Return the clauses that ask nothing of a room: no thing, place, figure or refusal is in them, or only what somebody does there."""
    found: list[Chunk] = []
    for clause in _clauses(chunks, small.REASONS):
        others, kinds = [c for c in clause if c.kind == "other"], {chunk.kind for chunk in clause}
        asks = _asks(clause)
        named = next((k for k, chunk in enumerate(clause) if chunk.kind == "room"), 0)
        before = {chunk.kind for chunk in clause[:named]}
        acts = any(chunk.value in ACTING for chunk in clause)
        of_somebody = _is_done_by_somebody(clause) or (bool(others) and _is_of_somebody(clause))
        if (others or acts) and not asks and (kinds <= {*small.ASIDE} or of_somebody):
            found.append(Chunk("aside", clause[0].start, clause[-1].end))
        elif not asks and kinds <= {*small.ASIDE, "room", "measure"}:  # "our hallway is pure chaos"
            found += [replace(other, kind="aside") for other in others]
        elif not asks and before and before <= {*small.ASIDE, "rel"}:  # "our trials are in a lab with a sink"
            found += [replace(other, kind="aside") for other in others if other in clause[:named]]
        parts = (part for part, verb in pairwise(clause) if part.kind == "part" and verb.value in ("done", "doing"))
        found += [replace(part, kind="aside") for part in parts]  # "its walls wrapped in felt"
    return found


def unasked(aside: Sequence[Chunk], said: Parsed) -> list[NamedThing]:
    """Return what nobody knows and only clauses name that ask nothing of a room: "my brother hates the noise"."""
    about = {thing for link in said.links for thing in named((*link.subjects, *link.objects))}
    strange = [thing for thing in said.things if thing.noun.guessed and thing.definite and thing not in about]
    return [one for one in strange if all(any(a.start <= at < a.end for a in aside) for at, _ in one.spans)]


def _asks(clause: Sequence[Chunk]) -> bool:
    """Return whether a clause has a number, or words that must not be passed over."""
    number = any(chunk.number or (count_of(chunk.value) or 0) > 1 for chunk in clause)
    return number or any(chunk.value in (UNREAD, *small.REACHED) for chunk in clause)


def _is_of_somebody(clause: Sequence[Chunk]) -> bool:
    """Return whether a clause says what somebody is or does, of no thing or place: "we have just moved in", "we had no space"."""
    who = next((k for k, chunk in enumerate(clause) if is_somebody(chunk)), None)
    if who is None or not {chunk.kind for chunk in clause[:who]} <= {"filler", "other", "and", "pron"}:
        return False
    named = any(c.kind in ("thing", "room", "corner", "measure") or (c.kind == "part" and c.det) for c in clause)
    leads_back = any(a.kind == "rel" and b.kind == "pron" for a, b in pairwise(clause))
    return not named and not leads_back and any(c.kind in ("verb", "with", "other") for c in clause[who + 1 :])


def _is_done_by_somebody(clause: Sequence[Chunk]) -> bool:
    """Return whether a clause says what somebody does, of no new thing: "I don't trust the old window", "I trip over them"."""
    words = [chunk for chunk in clause if chunk.kind not in ("and", "not")]
    who = next((k for k, chunk in enumerate(words) if is_somebody(chunk)), None)
    does = next((k for k, chunk in enumerate(words) if chunk.value in ACTING), -1)
    if who == 0 and {chunk.kind for chunk in words} <= {*small.ASIDE, "rel"}:
        return True
    if who is None or any(chunk.kind not in ("filler", "verb", "style") for chunk in words[who + 1 : does]):
        return False
    return does > who and not any(c.kind in ("rel", "with", "measure") or c.det in ("a", "new") for c in words)


def _idle(chunks: Sequence[Chunk], said: Parsed) -> set[int]:
    """Return the first tokens of what is named again in a sentence of which no row is about it."""
    stops = [0, *(chunk.end for chunk in chunks if chunk.kind == "stop"), chunks[-1].end if chunks else 0]
    found: set[int] = set()
    for start, end in pairwise(stops):
        links = [link for link in said.links if start <= link.start < end]
        about = {thing for link in links for thing in named((*link.subjects, *link.objects))}
        facts = any(start <= fact.start < end and fact.kind in small.OF_A_THING for fact in said.facts)
        others = [thing.spans for thing in said.things if thing not in about]
        again = {span[0] for first, *more in others for span in more if span != first}
        told = (c.start for c in chunks if c.start in again and c.det not in ("a", ""))
        found |= {first for first in told if start <= first < end and not facts}
    return found


def _named(chunk: Chunk, said: Parsed) -> bool:
    """Return whether a noun phrase only names again what another row is about: no more of it, and not otherwise."""
    again = [thing for thing in said.things if (chunk.start, chunk.end) in thing.spans[1:]]
    alike = [thing for thing in said.things if thing.same(chunk)]
    known = {word for thing in alike for word in (*thing.adjectives, *thing.told, *thing.noun.said.split())}
    return any((chunk.number or 1) <= thing.count for thing in again) and {*chunk.adjectives} <= known | small.PICKING


def _says(chunk: Chunk, after: Sequence[Chunk]) -> bool:
    """Return whether a chunk asks for something: of the small words numbers do, and verbs of place with no relation after them."""
    if chunk.kind == "part" and chunk.value in ("room", "floor"):
        unknown = chunk.value == "room" and chunk.det == "a" and {*chunk.adjectives} - grammar().adjectives
        return bool(unknown) or (chunk.number or 1) > 1  # "a treatment area"
    led, side = [other.kind for other in after[:2]], (chunk.kind, chunk.value) == ("part", "side")
    bare = not chunk.det and not after and chunk.adjectives in (("back",), ("front",))  # "what we would put back"
    if side and (bare or led == ["verb", "rel"] or (chunk.det and led[:1] == ["rel"])):
        return False  # "its headboard touches the wall", "a bed whose headboard is against the wall"
    if chunk.kind == "verb" and chunk.value in small.LED:
        return not any(other.kind == "rel" for other in after)
    to = next((other.kind for other in after if other.kind != "filler"), "")
    if chunk.kind == "verb" and chunk.value in ACTING:
        return to in ("thing", "part")
    if chunk.kind == "rel" and to in small.OF_NO_THING:
        return False  # "clad in slate", "in my second year"
    leads = [other.kind for other in after[:1]] in (["rel"], ["measure"])  # "right behind"
    where = chunk.value in small.RELATING and not leads
    told = chunk.kind == "filler" and ((count_of(chunk.value) or 0) > 1 or where)
    return chunk.kind not in small.SILENT or told


def _clauses(chunks: Sequence[Chunk], begin: Collection[str] = ()) -> list[list[Chunk]]:
    """Return the chunks between one mark and the next, or from a word with which a clause begins."""
    clauses: list[list[Chunk]] = [[]]
    for chunk in chunks:
        if chunk.kind in MARKS.values():
            clauses.append([])
        else:
            if chunk.value in begin:
                clauses.append([])
            clauses[-1].append(chunk)
    return [clause for clause in clauses if clause]
