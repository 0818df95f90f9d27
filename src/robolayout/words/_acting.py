"""Verbs that no list has, by what stands before and after them: "a palm softens the corner" is one that is in the corner."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import takewhile

from robolayout.words._chunk import NOTHING, Chunk
from robolayout.words._function_words import SPEAKING

ACTING = ("does", "done", "doing")
"""Values of verbs that no list has: finite ones, and participles."""
AT = {"corner": "in", "middle": "in", "side": "in", "wall": "wall", "window": "near", "door": "near"}
"""Relations in which a thing is that does something to such a place."""
NEW = ("a", "", "new", "each")
"""Articles of what is named for the first time."""


def acted(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Return phrases with a relation in place of a verb that no list has, between two of which it says where they are."""
    chunks = [*_each_with([_of_a_reason(chunks, i) for i in range(len(chunks))])]
    found = [_of_matter(chunks, i) for i in range(len(chunks))]
    for i, verb in enumerate(chunks):
        if verb.kind == "verb" and "where" not in _said(chunks, i):  # "a lamp stands where the desk meets the bed"
            found[i : i + 2] = _instead(verb, found[i + 1 : i + 2], _subject(chunks, i), _next(chunks, i + 2))
    return _places_first(found)


def _places_first(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Return phrases with a place that holds something as where that is: "the corner by the door holds a lamp"."""
    found = list(chunks)
    holds = [i for i, chunk in enumerate(chunks) if chunk.value == "holds" and _next(chunks, i + 1).kind == "thing"]
    for i in reversed(holds):
        since = [k for k, chunk in enumerate(chunks[:i]) if chunk.kind in ("stop", "colon", "comma", "and")]
        first = since[-1] + 1 if since else 0
        place = chunks[first]
        if place.value in ("corner", "middle", "side") and "thing" not in {c.kind for c in chunks[first:i]}:
            found[i] = replace(chunks[i], kind="verb", value="is", adjectives=())
            found.insert(first, replace(NOTHING, kind="rel", start=place.start, end=place.end, value="in"))
    return found


def _of_a_reason(chunks: Sequence[Chunk], i: int) -> Chunk:
    """Return a phrase, no thing where it is of none that is known and in a clause that gives a reason, no refusal of what is done."""
    chunk = chunks[i]
    unknown = chunk.noun is not None and bool(chunk.noun.guessed)
    here = [*takewhile(lambda value: value != ",", _said(chunks, i))]
    told = {"because", "since"} & {*here} or ("where" in here and SPEAKING & {*here})
    if unknown and told:  # "because the heat ruins the tuning", "where we do the crossword"
        return replace(chunk, kind="other", noun=None, value="reason")
    does = _next(chunks, i + 1).value in ACTING and i > 0 and is_somebody(chunks[i - 1])
    return replace(chunk, kind="filler") if chunk.kind == "not" and does else chunk  # "I dont trust the window"


def _each_with(chunks: Sequence[Chunk]) -> Iterator[Chunk]:
    """Yield phrases without a participle between "each" and "with": "two tables, each crowned with a lamp"."""
    for i, chunk in enumerate(chunks):
        each = i > 0 and chunk.value == "done" and chunks[i - 1].value == "each"
        before = chunks[i - 1] if i > 1 and chunks[i - 2].value == "each" else NOTHING
        if not (each and _next(chunks, i + 1).kind == "with"):
            yield replace(chunk, start=before.start) if before.value == "done" and chunk.kind == "with" else chunk


def _of_matter(chunks: Sequence[Chunk], i: int) -> Chunk:
    """Return a phrase, no relation where it leads to what a thing is made of: "topped with honed oak", "lit from within"."""
    led, before = chunks[i], chunks[i - 1] if i else NOTHING
    made = before.value in ACTING or (before.kind == "style" and before.value.endswith("ed"))
    made = led.value == "holds" or (led.value == "in" and made)  # "upholstered in leather"
    matter = made and _next(chunks, i + 1).kind in ("style", "other")
    within = led.adjectives == ("within",) and _next(chunks, i + 1).kind in ("comma", "stop", "and", "verb", "")
    return replace(led, kind="filler") if led.kind == "rel" and (matter or within) else led


def _instead(verb: Chunk, rest: list[Chunk], before: Chunk, beyond: Chunk) -> list[Chunk]:
    """Return what a verb and the phrase after it say, by who or what does it and what it is done to."""
    after = rest[0] if rest else NOTHING
    used = after.kind == "rel" and beyond.kind == "thing" and beyond.det in NEW
    if is_somebody(before) and used and (verb.value in ACTING or after.value in ("on", "in")):
        return [replace(verb, value="is"), replace(after, kind="filler")]  # "customers wait on a sofa"
    if verb.value not in ACTING:
        return [verb, *rest]
    if before.kind in (NOTHING.kind, "stop", "colon") and verb.value == "does" and after.kind == "thing":
        return [replace(verb, value="place"), after]  # "scatter two plants in the room"
    if verb.value == "done" and after.value == "by" and beyond.kind in ("thing", "part"):
        return [verb, replace(after, kind="with", value="with")]  # "lit by a floor lamp"
    if after.value in ("toward", "towards"):
        return [verb, _relation(after, "facing")]  # "oriented toward the door"
    return [_between(verb, before, after), *rest]


def _between(verb: Chunk, before: Chunk, after: Chunk) -> Chunk:
    """Return a verb, or the relation that it is between a thing and a place, or two things."""
    places = [chunk.kind == "part" and chunk.value in AT for chunk in (before, after)]
    if before.kind == "thing" and places[1]:
        return _relation(verb, AT[after.value])
    if places[0] and after.kind == "thing" and after.det in NEW:
        return _relation(verb, "holds")  # "the corner shelters an armchair"
    if before.kind == "thing" and after.kind == "thing" and verb.value != "done":
        return replace(verb, kind="with", value="with") if after.det in NEW else _relation(verb, "near")
    return verb


def is_somebody(chunk: Chunk) -> bool:
    """Return whether a phrase names people, or is a word for them."""
    return chunk.kind in ("people", "body") or chunk.value in SPEAKING


def _said(chunks: Sequence[Chunk], at: int) -> list[str]:
    """Return the values of what stands before a phrase in its sentence."""
    here = takewhile(lambda chunk: chunk.kind not in ("stop", "colon"), reversed(chunks[:at]))
    return [chunk.value for chunk in here]


def _relation(verb: Chunk, name: str) -> Chunk:
    return replace(verb, kind="rel", value=name, adjectives=(name,))


def _next(chunks: Sequence[Chunk], at: int) -> Chunk:
    return chunks[at] if at < len(chunks) else NOTHING


def _subject(chunks: Sequence[Chunk], at: int) -> Chunk:
    """Return the thing or place before a verb, over other verbs and small words; after a comma or "and" what begins the sentence."""
    ended = [k for k, chunk in enumerate(chunks[:at]) if chunk.kind in ("stop", "colon")]
    for chunk in reversed(chunks[:at]):
        if chunk.kind in ("comma", "and", "with", "measure", "style"):
            return _next(chunks, ended[-1] + 1 if ended else 0)
        if chunk.kind not in ("verb", "filler") or is_somebody(chunk):
            return chunk
    return NOTHING
