"""Lists of what things have and hold: what belongs to a list, and what it leads to."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import dropwhile, takewhile

from robolayout.words import _function_words as small
from robolayout.words._chunk import NOTHING, Chunk
from robolayout.words._said import Item, Link, Mention, mentions, named
from robolayout.words._spaces import Spaces


class Holding(Spaces):
    """Reads lists of what something has or holds."""

    def _list_goes_on(self, had: int) -> bool:
        """Return whether a plain list goes on from a comma, to the end (", a keyboard and a chair.") or to what goes with others."""
        kinds = takewhile(lambda kind: kind != "stop", (chunk.kind for chunk in self.chunks[self.at :]))
        rest = re.sub(
            " filler (?:thing|other|function)", "", " ".join(kinds)
        ).split()  # "a box of slides", "a glass of water"
        more = "*" if had > 1 else "+"  # ", a keyboard and a chair, a plant by the door"; ", and a chair, ..."
        inner = re.match(f"(comma thing ){more}(comma )?and thing (?=comma|and)", " ".join(rest))
        listed = self.chunks[self.at : self.at + len(inner[0].split())] if inner else []
        goes_with = [kind for chunk in listed if chunk.noun is not None for kind in chunk.noun.categories[:1]]
        if goes_with and all(kind.on_object or kind.name.split()[-1] in small.SEATS for kind in goes_with):
            return True
        while rest[-1:] in (["rel"], ["pron"]):  # "..., a keyboard and a chair in front of it"
            rest.pop()
        return (
            rest[-2:] == ["and", "thing"]
            and (had > 1 or rest[1:2] != ["and"])  # "each with a lamp, and a sofa"
            and re.fullmatch("(comma thing )*(comma )?and thing", " ".join(rest).replace(" with thing", "")) is not None
        )

    def _list_closes(self) -> bool:
        """Return whether a list of what something holds ends before what is said of it: "a desk holding a lamp and a mug is ...".

        Before another relation it does where all can stand on something: not "holding a lamp, and a chair by the door".
        """
        part = ("comma", "and", "thing", "filler", "other")
        ahead = [*takewhile(lambda c: c.kind in part and c.value not in small.MODAL, self.chunks[self.at :])]
        kinds = re.sub(r" ?filler (?:thing|other)\b", "", " ".join(c.kind for c in ahead)).strip()
        after = self._ahead(len(ahead))
        if re.fullmatch("(?:(?:comma thing )+(?:comma )?)?and thing", kinds) is None:
            return False
        on = all(any(kind.on_object for kind in c.noun.categories) for c in ahead if c.noun is not None)
        return after.kind == "verb" or after.value in small.ORDERS or (on and after.kind == "rel")

    def _past_contents(self, one: Mention) -> None:
        """Go past what a small thing has in it, where a list goes on: "holding a bottle of detergent and a box"."""
        of, what, joins, more = (self._ahead(i) for i in range(4))
        contents = of.value == "of" and what.kind in ("thing", "other") and not what.det
        if contents and joins.kind in ("and", "comma") and more.kind == "thing":
            if what.noun is not None and what.noun.category.on_object and one.thing.head in small.CONTAINERS:
                self.said.links.append(Link("on", (self._mention(what),), (one,), what.start, what.end))
            else:
                self.said.facts.append(replace(what, kind="function"))
            self.at += 2

    def _reversed(self, chunk: Chunk, subjects: list[Mention], objects: Sequence[Item]) -> None:
        """Link what is said from the other side: "flanked by two lamps"."""
        moved = mentions(objects)
        # "holding a bowl, two candles and a clock"
        closed = chunk.value == "holds" and self._list_closes()
        listed = closed or (chunk.value == "holds" and self._list_goes_on(1))
        for one in moved[-1:]:
            self._past_contents(one)
        joins = ("and", "comma") if listed else ("and",)
        while chunk.value in ("holds", "flanked") and self._ahead().kind in joins:
            self.at += listed and self._ahead(1).kind == "and"  # "a bowl, a candle, and a clock"
            if (also := self._ahead(1).noun) is None:
                break
            there = any(kind.on_object for kind in also.categories)
            if not (closed or there) and self._ahead(2).kind not in ("", "stop"):
                break
            ends = listed and self._ahead().kind == "and"
            self.at += 2
            moved.append(self._mention(self._ahead(-1)))
            self._past_contents(moved[-1])
            if ends:
                break
        if chunk.value == "flanked" and self._ahead().value in ("left", "right"):
            self.holder, self.group, self.verb = subjects[:1], moved, False  # "flanked by a lamp on the left and ..."
            self._understood(chunk)
        elif moved and subjects:
            full = not {"filled", "full", "stocked", "containing", "contains", "holding", "holds"}.isdisjoint(
                chunk.adjectives
            )
            filled = full and subjects[0].thing.head == "bookshelf"
            named = Chunk("rel", chunk.start, chunk.end, "in" if filled else small.REVERSED[chunk.value])
            each = chunk.value == "holds" and subjects[0].det == "each"  # "each holding a lamp and a clock"
            large = [m for m in moved if closed and not any(kind.on_object for kind in m.thing.noun.categories)]
            on = [m for m in moved if m not in large]  # "a counter displaying a cash register and a pastry case"
            for together in [[mention] for mention in on] if each else [on] * bool(on):
                self._link(named, together, list(subjects))
            if large:
                self._link(replace(named, value="next"), large, list(subjects))
            self.target = None if filled or closed else self.target
            held = chunk.value == "holds" and self._ahead().kind == "rel"
            held = held and self._ahead().value not in ("on", *small.ORDERS)
            self.group = self.acted = list(subjects) if held else moved  # "a shelf full of toys along the wall"

    def _parted_from(self, chunk: Chunk) -> bool:
        """Read what stands between two things: "the bed is separated from the desk by a bookshelf"; else they are far apart."""
        if chunk.value != "partedfrom":
            return False
        ends = [*self._subjects(chunk.value), *self._objects(chunk)]
        if self._ahead().value in ("by", "with") or self._ahead().kind == "with":
            self._understood(self._ahead())
            self.at += 1
            parting = mentions(self._objects(chunk))
            self.said.links.append(Link("amid", tuple(parting), tuple(ends), chunk.start, chunk.end))
        else:
            self._link(replace(chunk, value="far"), mentions(ends[:1]), ends[1:])
        return True

    def _has_more(self) -> bool:
        """Return whether a list of what a table has goes on after its seats: "a table with four chairs around it, a jug and a bowl"."""
        what = self._ahead(self._ahead().kind == "and").noun
        around = self._ahead(-2).kind == "pron" and named(self.said.last.objects) == named(self.holder)
        tops = bool(self.holder) and self.holder[0].thing.head in small.TOPS
        return around and tops and what is not None and "floor" not in what.category.places and what.category.on_object

    def _put_on(self, mention: Mention, holder: Mention, *, joined: bool) -> bool:
        """Return whether what another thing has is on it or at it: what can stand nowhere else, what a table has first, seats."""
        tops, told = holder.thing.head in ("table", "desk", "counter", "island"), self._ahead(-2).kind == "with"
        if self._ahead().value in small.HANGING and self._ahead(1).value == "above":
            return False  # "a counter with pans hanging above it"
        rest = [*dropwhile(lambda c: c.kind in ("filler", "body", "people"), self.chunks[self.at : self.at + 4])]
        apart = "comma" in [c.kind for c in self.chunks[max(self.at - 3, 0) : self.at - 1]]  # ", a" or ", and a"
        if apart and [c.kind for c in rest[:2]] == ["rel", "part"] and rest[1].value in small.OPENINGS_AND_CORNERS:
            return False  # "a cabinet with a sink, a scale for dogs by the door"
        if joined and [c.kind for c in rest[:2]] == ["rel", "thing"] and rest[0].value in ("opposite", "facing"):
            return rest[1].noun == holder.thing.noun  # "a desk with a chair, a TV opposite the bed"
        closes = self._ahead().kind in ("comma", "stop", "") and mention.thing.noun.said in small.WORKED_AT
        goes_with = tops and (closes or not joined) and is_accessory(mention)
        had = joined and (self.said.last.relation, self.said.last.objects) == ("with", (holder,))
        clock = had and "floor" not in mention.thing.places  # "a table with a bowl and a clock"
        on = mention.topped or (mention.can_be_on_a_top and (clock or self._on_it_follows()))
        return (on or goes_with or told) and not holder.topped

    def _on_it_follows(self) -> bool:
        """Return whether a list of small things ends with "on it"."""
        rest = [*dropwhile(lambda c: c.kind in ("thing", "and", "comma", "filler", "style"), self.chunks[self.at :])]
        return [c.value for c in rest[:2]] == ["on", "it"]

    def _of_people(self) -> bool:
        """Return whether this clause is about somebody: "guests are received near the door" moves no furniture."""
        before = self.chunks[: self.at - 1]
        ends = [i for i, chunk in enumerate(before) if chunk.kind in ("comma", "and", "stop", "colon")]
        clause = before[ends[-1] + 1 if ends else 0 :]
        if [chunk.value for chunk in clause] in (["everybody"], ["everyone"]) or self._ahead(-2).value == "everything":
            return True  # "everybody looks at the board", "everything along one wall"
        to = next((chunk.kind for chunk in self.chunks[self.at :] if chunk.kind != "filler"), "")
        if clause and clause[0].value in small.SPEAKING and to in ("other", "function"):
            return True  # "where we do the crossword over our tea"
        clause = [chunk for chunk in clause if chunk.kind != "filler"]
        if [chunk.kind for chunk in clause[-1:]] == ["people"] and "sitting" in self._ahead(-1).adjectives:
            return True  # "a lamp such that a person sitting on the sofa sees it"
        if len(clause) < 2 or any(chunk.kind in ("thing", "pron") for chunk in clause):
            return False
        who, does = clause[0], clause[1].kind in ("verb", "other")
        unknown = who.kind == "other" and who.value.endswith("s") and not who.value.endswith("ss")
        return does and (unknown or who.kind in ("function", "people", "body"))

    def _of_what_is_unknown(self) -> bool:
        """Return whether a relation is about words that say nothing: "..., and sound panels on the wall"."""
        before = [*dropwhile(lambda c: c.kind == "style", reversed(self.chunks[: self.at - 1]))]
        known = next(dropwhile(lambda c: c.kind in ("other", "function"), before), NOTHING)
        # "a cabinet with gadgets along the wall", but not "a cabinet with gadgets on it"
        having = self.having and known.kind != "comma"  # but "a pool table, cues on the wall"
        held = self.group and (known.kind == "with" or having) and self._ahead().kind != "pron"
        return known not in (*before[:1], NOTHING) and known.kind in ("and", "comma", "with") and not held


def is_accessory(mention: Mention) -> bool:
    """Return whether a thing goes with another: a seat, or what can stand on a top."""
    kind = mention.thing.category
    return mention.thing.head in small.SEATS or kind.on_object or kind.built_in
