"""A phrase of a text, and phrases that leave out their noun."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, takewhile

from robolayout.words._function_words import DETERMINERS, LATTER, LEVELS, REST
from robolayout.words._lexicon import Noun, grammar
from robolayout.words._tokens import Measure, count_of

WITHOUT_NOUN = re.compile(
    r"(?:(?:the |a )?\b(another|(?<=\ba )(?:second|third|fourth|fifth|sixth)(?! of)"
    r"|(?<=the )(?:other half(?! of)|others?|remaining|rest|first|second|third|last|former|latter))"
    r"(?: (two|three|four|five|six|[2-9]))?( ones?)?"
    r"|(?:the|an?|(two|three|four|five|six|[2-9])(?= (?:\w+ ){0,2}ones )) (?:(?!other)((?:\w+ )?\w+) )?ones?"
    r"|all but (one|two|three)(?! of)) "
)
"""Phrases that leave out their noun: what picks, how many, whether "one" stands for the noun, an adjective."""


SOME, ROWS = -1, 3
"""Rows that are not counted, where their things are, and how many there are where neither is."""


@dataclass(frozen=True)
class Framed:
    """What is said of a door or window besides its wall."""

    width: float = 0.0  # metres, 0 if nothing is said
    height: float = 0.0
    along: str = ""  # where along its wall: "middle", "left", "right" or a point of the compass
    off: float = 0.0  # metres between it and that end of the wall

    def __str__(self) -> str:
        metres = [f"{self.width:g} m wide"] * (self.width > 0) + [f"{self.height:g} m high"] * (self.height > 0)
        off = f"{self.off:g} m from " if self.off else "at "
        along = "in the middle of it" if self.along == "middle" else f"{off}its {self.along} end"
        return ", ".join((*metres, *[along] * bool(self.along)))


@dataclass(frozen=True)
class Chunk:
    """A phrase."""

    # "thing", "part", "room", "body", "people", "corner", "measure", "rel", "verb", "with", "and", "comma", "colon",
    # "stop", "pron", "not", "style", "function", "filler" or "other"
    kind: str
    start: int  # first token
    end: int  # token after the last one
    value: str = ""  # A relation's name, a part's name, a room type
    noun: Noun | None = None  # what a thing is
    det: str = ""  # its article: "a", "the", "each", "all", "both", "new", "other", "first" or ""
    number: int | None = None  # its count, if one is said
    bound: str = ""  # "least", "most", "more", or "" for exactly so many; "vague" for "some"
    plural: bool = False  # whether the noun stands in the plural
    adjectives: tuple[str, ...] = ()  # the words before the noun
    # rows that it stands in ("three rows of four"), `SOME` if they are not counted; less for so many in each group
    rows: int = 0
    measure: Measure | None = None  # A measure of the room
    sizes: tuple[Measure, ...] = ()  # measures of the thing
    total: int | None = None  # of how many these are some: "two of the three stools"
    opening: Framed | None = None  # what is said of a door or window
    held: tuple[Chunk, ...] = ()  # what a container has in it

    @property
    def level(self) -> int:
        """Which shelf of a thing is meant, from below, or -1 for the highest one; 0 for none or any."""
        of_shelf = "shelf" in self.adjectives or (self.noun is not None and self.noun.said == "shelf")
        return next((LEVELS[word] for word in (*self.adjectives, self.det) if of_shelf and word in LEVELS), 0)

    @property
    def sided(self) -> str:
        """At which sides of a table seats are: "four chairs on each long side", "one at each end", "a bench on one long side"."""
        words = {*self.adjectives}
        if {"exact", "even"} & words:  # "in the exact middle of the room", "in an even row along the wall"
            return "exact"
        if self.value == "row":  # "from left to right", as one sees them who looks at their fronts
            return self.adjectives[1] if "from" in words else ""
        if "outer" in words:  # "on the outer sides of" two beds side by side
            return "outer"
        each = not words.isdisjoint(("each", "either", "both", "opposite", "opposing", "sides", "ends"))
        both = self.value == "around" or (self.value == "flank" and not {"left", "right"} & words)
        if not (self.value == "oneside" or (both and each)) or "all" in words:
            return ""
        return "end" if {"end", "ends", "short", "head"} & words else "long" if "long" in words else "each" * each


NOTHING = Chunk("", 0, 0)
"""What stands before the first phrase and after the last one."""


def without_noun(
    words: Sequence[str], at: int, found: Sequence[Chunk], run: Callable[[int], Sequence[str]]
) -> Chunk | None:
    """Return a phrase whose noun was said before: "another", "the round ones", "two low ones", "the remaining two"."""
    if [*words[at : at + 3]] == ["the", "other", "two"] and [chunk.value for chunk in found[-1:]] == ["amid"]:
        return Chunk("pron", at, at + 3, "the other two")
    match = WITHOUT_NOUN.match(" ".join(words[at : at + 4]) + " ")
    if match is None:
        return None
    picks, some, one, counted, told, but = match.groups()
    number = some or counted
    end = at + len(match.group().split())
    if (picks and not one and run(end)) or not _looks(told or ""):
        return None
    if picks in LATTER:
        here = takewhile(lambda c: c.kind not in ("stop", "comma", "and"), reversed(found))
        # not the mat of "a mat by the latter"
        led = [c for c in here if c.kind == "thing"] if [c.kind for c in found[-1:]] == ["rel"] else []
        named = [c for c in found if c.kind == "thing" and not {*words[c.start : c.end]} & {*LATTER}]
        two = [c for c in named if c not in led][-2:]
        meant = two[max(LATTER.index(picks) - 2, -len(two))] if two[not led :] else None
        return None if meant is None else replace(meant, start=at, end=end, det="the", adjectives=())
    new = bool(counted) or words[at] in ("a", "an", "another")
    told, looks = told or "", {*(told or "").split()}
    nouns = [c for c in found if c.kind in ("thing", "part") and (new or looks & {*c.adjectives} or _of_several(c))]
    nouns = [c for c in nouns if not told or c.plural or c.number or c.kind == "thing"]  # "the upper one" is no corner
    values = " ".join(c.value for c in found)
    shared = picks == "another" and "one of them" in values  # "a lamp on one of them and a vase on another"
    nouns = [c for c in nouns if c.kind == "thing" and _of_several(c)] or nouns if shared else nouns
    led = [c for before, c in pairwise(found) if before.kind == "rel" and c in nouns]
    alike = [c for c in nouns if c.noun is not None and looks & {*c.adjectives, *c.noun.said.split()}]
    sided = any({"side", "left", "right"} & {*c.adjectives} for c in found if c.kind == "rel")
    leads = [c.kind for c in found[-1:]] == ["rel"] and (sided or [c.value for c in found[-2:-1]] != ["one"])
    again = [c for c in nouns if new and told and sum(c.noun is other.noun for other in found) > 1]  # "and a low one"
    last = (alike or again or [c for c in nouns if (c in led) == leads] or nouns or [None])[-1]
    many = " ones " in match.group() or picks in ("others", "rest", "other half")
    many = many or bool(but or (number and count_of(number) != 1))
    det = "one" if but else "new" if new and picks else DETERMINERS.get(picks or "", "new" if new else "the")
    det = "other" if shared or (picks or "").removesuffix(" half") in REST else det
    side = words[end + 2] if words[end : end + 2] == ["on", "the"] and end + 2 < len(words) else ""
    told, end = (side, end + 3) if one is None and not picks and side in ("left", "right") else (told, end)
    if leads and picks == "other" and sided:
        return Chunk("part", at, end, "side", det="other")  # "stools on one side, the stove on the other"
    if last is None:
        return None
    count = -(count_of(but) or 0) if but else count_of(number or "")
    chunk = replace(last, start=at, end=end, det=det, number=count, bound="", plural=many, rows=0)
    return replace(chunk, adjectives=tuple(told.split()) if told else last.adjectives if last.kind == "part" else ())


def opening_before(chunks: Sequence[Chunk]) -> Chunk | None:
    """Return the door or window that one thing after it may be related to: "a window in the north wall and a desk under it"."""
    since = [*takewhile(lambda chunk: chunk.kind not in ("stop", "colon", "verb"), reversed(chunks))]
    ahead = [*takewhile(lambda chunk: chunk.value not in ("window", "door"), since)]
    things = [chunk for chunk in ahead if chunk.kind == "thing"]
    led = [chunk.kind for chunk in since[len(ahead) + 1 : len(ahead) + 2]] == ["rel"]  # "a bed by the window, ..."
    return since[len(ahead)] if len(things) == 1 and len(ahead) < len(since) and not led else None


def _looks(told: str) -> bool:
    """Return whether words before "one" are an adjective, or several that say how a thing looks: "a low wide one"."""
    lists = grammar()
    known = lists.adjectives if " " not in told else {*lists.styles, *lists.sizes}
    return all(word in known for word in told.split())


def _of_several(chunk: Chunk) -> bool:
    """Return whether a phrase names several things, or one of them."""
    sided = {"left", "right", *grammar().walls} & {*chunk.adjectives}
    return bool(chunk.plural or chunk.number or sided or chunk.det in ("one", "both", "each", "first"))
