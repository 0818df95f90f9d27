"""What lists as many of several things as there are says what each of them is: "two shelves, a tall one and a low one"."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import pairwise

from robolayout.words import _function_words as small
from robolayout.words._chunk import NOTHING, Chunk
from robolayout.words._lexicon import grammar
from robolayout.words._tokens import count_of

LISTED = "listed"
"""What joins things that were counted before they were listed: what is said after them is about all."""

Item = tuple[Chunk, int, int]
"""A thing of a list, its first chunk and the one after its last."""


def described(chunks: Sequence[Chunk]) -> list[Chunk]:
    """Return phrases with the things that are listed in place of what counts them."""
    found = list(chunks)
    for i in reversed(range(len(found))):
        items = _listed(found, i)
        first, end = (items[0][1], items[-1][2]) if items else (0, 0)
        between = [chunk.kind for (_, _, one), (_, two, _) in pairwise(items) for chunk in found[one:two]]
        close = first == i + 2 and found[i + 1].kind != "stop"
        more = (found[i].number or 0) - sum(item.number or 1 for item, _, _ in items)
        rest = [replace(found[i], number=more, plural=more > 1)] if items and more > 0 else []
        named = [*rest, *(item for item, _, _ in items)]
        marks = (replace(NOTHING, kind="and", start=item.start, end=item.start, value=LISTED) for item in named)
        joined = [chunk for two in zip(marks, named, strict=True) for chunk in two]
        if items and {*between} <= {"and", "comma"} and (close or _at(found, end).kind in ("", "stop", "comma")):
            end += close and (_at(found, end).kind, _at(found, end + 1).kind) == ("comma", "rel")
            found[i:end] = [*joined[1:], *found[i + 1 : first - 1]]
        # "in front of the sofa are two tables: one is round and has a bowl on it, the other is ..."
        elif close and _led(found, i):
            for item, start, after in reversed(items):
                found[start:after] = [replace(item, det="the", number=None)]
            found[i:first] = [*joined[1:], replace(found[i + 1], kind="stop")]
        elif close:  # with where each of them is
            for item, start, after in reversed(items):
                found[start:after] = [item]
            found[i : first - bool(rest)] = rest
    for i, (top, of, seats) in enumerate(zip(found, found[1:], found[2:], strict=False)):
        if of.value == "of" and seats.number and _is(top, small.TOPS) and _is(seats, small.SEATS):
            each = 1 if "each" in _at(found, i + 3).value.split() else top.number or 1  # "six tables of four chairs"
            found[i + 1 : i + 3] = [replace(of, kind="with", value="with"), replace(seats, number=seats.number * each)]
    return found


def _led(chunks: Sequence[Chunk], at: int) -> bool:
    """Return whether the sentence of a chunk begins with where things are."""
    ends = [k for k in range(at) if chunks[k].kind in ("stop", "colon")]
    return chunks[ends[-1] + 1 if ends else 0].kind == "rel"


def _is(chunk: Chunk, heads: Collection[str]) -> bool:
    return chunk.kind == "thing" and chunk.noun is not None and chunk.noun.said.split()[-1] in heads


def _listed(chunks: Sequence[Chunk], at: int) -> list[Item]:
    """Return what is listed after several things, in their sentence or all over the next one, where it is all of them."""
    several = chunks[at]
    opening = several.value in ("window", "door")
    if not (several.kind == "thing" or opening) or not (several.plural or several.det == "both"):
        return []
    stops = [*(k for k in range(at, len(chunks)) if chunks[k].kind == "stop"), len(chunks), len(chunks)]
    items = _items(chunks, at + 2, stops[0], several)
    if not items and _items(chunks, stops[0] + 1, stops[0] + 2, several):
        items = _items(chunks, stops[0] + 1, stops[1], several)
    others = any(item.noun is not several.noun for item, _, _ in items)
    if others and several.number is None and several.det != "both" and _at(chunks, at + 1).value == ",":
        return []  # "a shelf full of toys, two teddy bears and a ball"
    total = sum(item.number or 1 for item, _, _ in items)
    share = [_at(chunks, start + 1).value for _, start, _ in items[:1]]
    many = several.number or (2 if several.det == "both" else total)
    some = share in (["of"], ["of them"]) and total < many  # "two chairs, one of them red"
    return items if some or (len(items) > 1 and total == many) else []


def _items(chunks: Sequence[Chunk], at: int, end: int, several: Chunk) -> list[Item]:
    """Return what of several things is listed from one chunk to another."""
    found: list[Item] = []
    while at < min(end, len(chunks)):
        item = _item(chunks, at, several) if chunks[at - 1].kind in small.BEFORE_AN_ITEM else None
        found += [item] if item is not None else []
        at = item[2] if item is not None else at + 1
    return found


def _item(chunks: Sequence[Chunk], at: int, several: Chunk) -> Item | None:
    """Return what a list names of several things here: one or so many of them by a look, or one of a kind of its own."""
    one, end, words, sizes = chunks[at], at + 1, list[str](), list(chunks[at].sizes)
    other = (one.value, _at(chunks, end).value) == ("the", "other")
    elided = one.kind == "thing" and one.noun is several.noun and one.det in ("new", "the", "other")
    half = int(small.SHARES.get(one.value, 0.0) * (several.number or 0))
    number = one.number if one.kind == "thing" else count_of(one.value) or half
    if not elided and one.kind == "thing":  # "two beds: a crib and a bunk bed"
        return (one, at, end) if _kind_of(one, several) and chunks[at - 1].value in (":", "(", "and", ",") else None
    if not (elided or other or (number and one.kind in ("filler", "other"))):
        return None
    end += other
    while (chunk := _at(chunks, end)).kind in ("style", "measure") or chunk.value in small.SAYING:
        words += [chunk.value] * (chunk.kind == "style")
        sizes += [chunk.measure] if chunk.measure is not None else []
        end += 1
    words += one.adjectives
    span = {"start": one.start, "end": chunks[end - 1].end, "number": number or 1, "plural": (number or 1) > 1}
    looks = {"adjectives": (*words, *several.adjectives), "sizes": (*sizes, *several.sizes), "bound": "", "rows": 0}
    same = replace(several, det="new" if several.noun else "a", **span, **looks)
    placed = several.noun is None and _at(chunks, end).kind == "rel"  # "two doors, one in the north wall and one ..."
    return (same, at, end) if words or sizes or placed else None


def _kind_of(one: Chunk, several: Chunk) -> bool:
    """Return whether a noun is one of the kinds that another means: a crib is a bed, an armchair a seat."""
    if one.noun is None or several.noun is None or one.noun == several.noun:
        return False
    said, head = several.noun.said.split()[-1], one.noun.said.split()[-1]
    return head == said or small.KIN.get(head) == said or one.noun.kind.split()[-1] in grammar().groups.get(said, ())


def _at(chunks: Sequence[Chunk], at: int) -> Chunk:
    return chunks[at] if at < len(chunks) else NOTHING
