"""Lists of what things have and hold: what belongs to a list, and what it leads to."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

from robolayout.words import _function_words as small
from robolayout.words._chunk import Chunk
from robolayout.words._said import Item, Mention, mentions
from robolayout.words._spaces import Spaces


class Holding(Spaces):
    """Reads lists of what something has or holds."""

    def _list_goes_on(self, had: int) -> bool:
        """Return whether a plain list goes on from a comma, to the end (", a keyboard and a chair.") or to what goes with others."""
        kinds = takewhile(lambda kind: kind != "stop", (chunk.kind for chunk in self.chunks[self.at :]))
        rest = " ".join(kinds).replace(" filler thing", "").split()  # "a box of slides"
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

    def _past_contents(self) -> None:
        """Go past what a small thing has in it, where a list goes on: "holding a bottle of detergent and a box"."""
        of, what, joins, more = (self._ahead(i) for i in range(4))
        contents = of.value == "of" and what.kind in ("thing", "other") and not what.det
        if contents and joins.kind in ("and", "comma") and more.kind == "thing":
            self.said.facts.append(replace(what, kind="function"))
            self.at += 2

    def _reversed(self, chunk: Chunk, subjects: list[Mention], objects: Sequence[Item]) -> None:
        """Link what is said from the other side: "flanked by two lamps"."""
        moved = mentions(objects)
        # "holding a bowl, two candles and a clock"
        closed = chunk.value == "holds" and self._list_closes()
        listed = closed or (chunk.value == "holds" and self._list_goes_on(1))
        self._past_contents()
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
            self._past_contents()
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
