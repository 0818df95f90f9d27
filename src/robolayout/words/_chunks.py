"""From words to chunks: things with article, number and adjectives; places of the room; relations; what joins them.

A noun phrase is an article or a number, then a run of words up to the next word of the closed lists. The longest end of the run
that names something says what it is: "two leather office chairs" are two office chairs, "home office" is a room.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from robolayout.words import _function_words as small
from robolayout.words._chunk import Chunk, without_noun
from robolayout.words._closed import ClosedWords, heaped
from robolayout.words._lexicon import LONGEST, Noun
from robolayout.words._tokens import MARKS, VAGUE, count_of

Before = tuple[str, int | None, str, int]
"""What stands before a noun: article, number, bound, rows."""

SHORT = 5
"""Letters up to which a word is no slip of spelling where no article promises a thing."""


class Chunker(ClosedWords):
    """Cuts a text into chunks."""

    def chunks(self) -> list[Chunk]:
        """Return all chunks, in order; together they cover every word."""
        found: list[Chunk] = []
        at = 0
        while at < len(self.words):
            chunk = self._next(at)
            # "place a bar at the back"
            put = bool(found) and found[-1].kind == "verb" and found[-1].value in small.PLACING
            if chunk.kind == "room" and (put or any(c.kind == "room" and c.value != chunk.value for c in found)):
                chunk = self._in_room(chunk, found)
            found.append(self._reshaped(without_noun(self.words, at, found, self._run)) or chunk)
            at = found[-1].end
        return found

    def _reshaped(self, chunk: Chunk | None) -> Chunk | None:
        """Return a phrase without a noun whose noun is not of the shape that it tells: "a round table and a square one"."""
        if chunk is None or chunk.noun is None:
            return chunk
        told, words = {*chunk.adjectives}, chunk.noun.said.split()
        other = any(group & told and group & {*words} - told for group in self.grammar.exclusive)
        noun = self.lexicon.noun([*chunk.adjectives, words[-1]]) if other else None
        return replace(chunk, noun=noun) if noun else chunk

    def _in_room(self, chunk: Chunk, found: Sequence[Chunk]) -> Chunk:
        """Return a further room as a thing of the first, where its name is one: "a studio with a kitchenette"."""
        words = self.words[chunk.start : chunk.end]
        noun = next((n for i in range(len(words)) if (n := self.lexicon.noun(words[i:]))), None)
        if (
            noun is not None
            and noun.said in small.SHARING
            and all(c.value in small.SHARING for c in found if c.kind == "room")
        ):
            return chunk  # "a living room with a kitchen"
        return chunk if noun is None or chunk.det == "the" else replace(chunk, kind="thing", value="", noun=noun)

    def _next(self, at: int) -> Chunk:
        if at in self.measured:
            named = any(" ".join(self.words[max(at - n, 0) : at]) in self.lexicon.room_words for n in (1, 2))
            of_room = named and self.measured[at].kind == "size"  # "bedroom 3 x 4 m double bed"
            thing = None if of_room else self._noun_phrase(at)  # "2.2 m wide sofa"
            if thing is not None and thing.kind == "thing":
                return thing
            measure, end = self.measured[at], max(self.after[at], at + 1)
            gap = measure.kind in ("apart", "between")
            return Chunk("rel" if gap else "measure", at, end, measure.kind if gap else "", measure=measure)
        if self.words[at] in MARKS:
            return Chunk(MARKS[self.words[at]], at, at + 1, self.words[at])
        shared = self._role(at) or self._fixed(at) or self._noun_later(at)
        return shared or self._noun_phrase(at) or self._single(at)

    def _noun_later(self, at: int) -> Chunk | None:
        """Return a phrase that shares the noun of the next one: "a blue and a red chair", "one large and two small desks"."""
        end = first = at + 1 + (self._word(at) in ("both", "either") and self._leads(at + 1))
        models = {model.split()[0] for model in self.grammar.models} - self.grammar.parts.keys()
        while any(self._word(end) in words for words in (self.grammar.styles, self.grammar.sizes, models)):
            end += 1
        end = max(end, first + self._sizes(first))
        begins = end + 1 + (self._word(end) == "," and self._word(end + 1) == "and")
        joined = end > first and self._word(end) in ("and", ",") and self._leads(at) and self._leads(begins)
        chunk = (self._noun_later(begins) or self._noun_phrase(begins)) if joined else None
        named = any(self.lexicon.noun(self.words[i:end]) for i in (first, end - 1))  # "a wide mirror, a large tub"
        if chunk is None or chunk.noun is None or named:
            return None
        *more, head = chunk.noun.said.split()
        if not (more or chunk.adjectives or chunk.sizes):
            return None
        det, number = small.DETERMINERS.get(self.words[first - 1], ""), count_of(self.words[first - 1])
        number, own = None if det else number, self.lexicon.noun([*self.words[first:end], head])
        alone = self.lexicon.noun([head]) if {*self.words[first:end]} & models else None
        chunk = replace(chunk, noun=alone or chunk.noun)
        same = replace(chunk, start=at, end=end, det=det, number=number, plural=(number or 1) > 1)
        return replace(same, noun=own, adjectives=(), sizes=()) if own else self._told(same, range(first, end), ())

    def _told(self, chunk: Chunk, sized: Sequence[int], adjectives: Sequence[str]) -> Chunk:
        """Return a phrase with measures and adjectives at some places, before some more."""
        inner = {k for j in sized if j in self.measured for k in range(j, self.after[j])}
        words = tuple(self.words[j] for j in sized if j not in inner)
        sizes = tuple(self.measured[j] for j in sized if j in self.measured)
        return replace(chunk, sizes=sizes, adjectives=(*words, *adjectives))

    def _role(self, at: int) -> Chunk | None:
        """Return what a thing is to serve as ("as an island"), what a shop sells, or how many a table seats: no more things."""
        before, word, following = (["", *self.words, "", ""][at + i] for i in range(3))
        if word in ("seat", "seats", "seating") and count_of(following):
            return Chunk("people", at, at + 2, "people", number=count_of(following))
        role = word == "as" and following in ("a", "an", "the") and before not in ("well", "such", "same", "wall")
        role = role or (f"{before} {word}" in small.SERVING and following in ("a", "an", "one"))
        named = self._noun_phrase(at + 1) if role or word in small.SELLING else None
        return Chunk("filler", at, named.end, word) if named else None

    def _fixed(self, at: int) -> Chunk | None:
        """Return a relation or another phrase of the closed lists that begins here."""
        for size in range(min(LONGEST, len(self.words) - at), 0, -1):
            words = self.words[at : at + size]
            phrase = " ".join(words)
            counted = " ".join("n" if (count_of(word) or 0) > 1 else word for word in words)  # "in three rows"
            kind, value = self.grammar.phrases.get(phrase) or self.grammar.phrases.get(counted, ("", ""))
            measured = any(inner in self.measured for inner in range(at + 1, at + size))  # "in 3 rows and 4 columns"
            if kind == "rel" and not measured and self._is_relation(phrase, at + size) and not self._overlaid(at, size):
                rows = next((number for word in words if (number := count_of(word))), 0)
                of = rows > 1 and self.words[at + size : at + size + 1] == ["of"]  # "in three rows of four"
                each = count_of(self.words[at + size + 1]) if of and self.words[at + size + 1 :] else None
                size += 2 * bool(each)
                of_it = words[-1] in ("left", "right") and phrase != words[-1] and self._clause(at, at + size)
                of_it = of_it or phrase in ("at the foot", "at the feet")
                its = "its" if (re.search(" (its|their) ", phrase) and value != "wall") or of_it else ""
                number = rows * each if each else None
                return Chunk("rel", at, at + size, value, None, its, number, adjectives=tuple(words), rows=rows)
            counted = (self._word(at + size + 1) or ".") in (*MARKS, *small.JOINING)
            if kind == "not" and counted and count_of(self._word(at + size)):
                return Chunk("filler", at, at + size + 1, phrase)  # "with six chairs instead of four"
            if kind in ("and", "alone", "not") or (kind == "pron" and size > 1 and phrase != "the two"):
                return Chunk(kind, at, at + size, phrase)
        word = self.words[at]
        doing = self.words[at + 1 : at + 2] if word == "without" else []
        if doing and doing[0].endswith("ing") and not self.lexicon.noun(doing):
            what = self._noun_phrase(at + 2)  # "without hitting the bed"
            return Chunk("other", at, what.end if what else at + 2, word)
        if word == "nothing" or (word in small.REFUSING and not self._bound(at)[0]):
            return Chunk("not", at, at + 1, word)
        if word in small.WITH:
            return Chunk("with", at, at + 1)
        if word == "to" and (owned := self._noun_phrase(at + 1)) is not None and owned.kind == "thing" and owned.value:
            return Chunk("rel", at, at + 1, "by")
        return Chunk("and", at, at + 1, word) if word in small.JOINING else None

    def _noun_phrase(self, at: int) -> Chunk | None:
        """Return a noun phrase that begins here: a thing, a place, a room, a body or people."""
        bound, skip = self._bound(at)
        i = at + skip
        det, number, total, rows = "", None, None, 0
        sized: list[int] = []
        while i < len(self.words):
            sized += range(i, i + self._sizes(i))
            i = sized[-1] + 1 if sized and sized[-1] >= i else i
            step = self._before_noun(i, det, number) if i < len(self.words) else None
            if step is None:
                break
            det = det if det in ("each", "one", "all", *small.SHARES) else step[0] or det
            if det == "one" and number is not None:
                total = total or step[1]
            else:
                number = number if step[1] is None else step[1]
            bound, rows = step[2] or bound, step[3] or rows
            i += step[4]
        run = self._run(i, many=(number or 1) > 1)
        end = i + len(run)
        first = f"{run[-1]} {self._word(end + 2)}" if run and self._word(end) == "and" else ""
        if first in self.lexicon.room_words:  # "a living and dining room"
            return Chunk("room", at, end, self.lexicon.room_words[first], None, det, adjectives=tuple(run[:-1]))
        if not run:
            return Chunk("pron", at, i, "the two") if det == "the" and (number or 0) > 1 else None
        told = bool(det or number is not None or bound)
        who = at - 1 - (self._word(at - 1) in ("only", "always", "often", "usually", "mostly", "just"))
        does = self._word(who) in small.SPEAKING and self.lexicon.noun(run[:1]) is not None  # "where I paint"
        if not told and (does or self._word(at - 1) in small.MODAL):
            return Chunk("filler", at, at + 1, run[0])
        chunk = self._named(at, i, run, told, (det, number, bound, rows))
        chunk = replace(chunk, total=total) if chunk and total else chunk
        if not sized or chunk is None:
            return chunk
        return self._told(chunk, sized, chunk.adjectives) if chunk.kind == "thing" else None

    def _sizes(self, i: int) -> int:
        """Return how many words from here on say how large what follows is: "wooden 6-foot", "1 m wide, 2 m high"."""
        first = i
        while self.words[i : i + 1] and (self.words[i] in self.grammar.styles or self.words[i] in self.grammar.sizes):
            i += 1
        while i in self.measured and self.measured[i].kind not in ("apart", "between", "grid", "area"):
            i = max(self.after[i], i + 1)
            i += self.words[i : i + 1] in ([","], ["and"]) and i + 1 in self.measured
        return i - first if any(j in self.measured for j in range(first, i)) else 0

    def _before_noun(self, i: int, det: str, number: int | None) -> tuple[str, int | None, str, int, int] | None:
        """Return (article, number, bound, rows, length) of what stands before a noun here."""
        word, rest = self.words[i], self.words[i + 1 : i + 5]
        # "next to that a lamp", "a kitchen that opens to the hall"
        that = word == "that" and bool(rest) and (rest[0] in ("a", "an") or _plural(rest[0], None))
        if that or i in self.measured or (word == "first" and self.lexicon.noun(self.words[i : i + 3])):
            return None  # "first aid kit"
        walls = (
            rest[:1] == ["wall"] and rest[2:3] != [] and rest[2] in small.DETERMINERS
        )  # "the longest wall of the hall"
        grouped = rest[1:2] == ["of"] and rest[0] in small.SETS and not walls
        if grouped and word not in small.DETERMINERS and not count_of(word):
            return ("", None, "", 0, 3)  # "a seating group of"
        if (some := self._some_of(word, rest)) is not None:
            return some
        if "of" in rest[:2] and (of := self._of(word, rest, number)) is not None:
            return of
        if word in small.DETERMINERS and (det == "the" or word not in small.ORDINALS):
            return (small.DETERMINERS[word], None, "", 0, 1)
        if word in small.ADDING:
            new = "new" if number is not None and word in ("more", "additional", "further", "extra") else ""
            return (new, None, "", 0, 1) if self._run(i + 1) or count_of(rest[0] if rest else "") else None
        count = None if self._seats(i) or (rest[:1] and rest[0] in small.SCALES) else count_of(word)
        alone = det == "a" and count and count > 1 and word not in (*VAGUE, "couple", "dozen", "pair", "trio", "twin")
        if alone and self.lexicon.noun(rest[:1]) is None and self._run(i + 2):
            return ("", None, "", 0, 2)  # "a six-axis robot arm"
        if count and (number is None or det == "one") and word not in ("a", "an", "twin", "couple"):
            unit = rest[:1] in (["of"], ["x"]) or (rest[:1] in (["pcs"], ["pc"], ["nos"]) and bool(self._run(i + 2)))
            return ("", count, "vague" if word in VAGUE else "", 0, 1 + unit)
        return None

    def _run(self, i: int, *, many: bool = False) -> list[str]:
        """Return the words from here up to the next one that cannot be part of a noun phrase."""
        run: list[str] = []
        while i < len(self.words) and len(run) < LONGEST + 2:
            word = self.words[i]
            pair = self.words[i - 1 : i] + self.words[i + 1 : i + 2]
            alike = (self.grammar.walls, (*self.grammar.styles, *self.grammar.sizes))
            both = word == "and" and bool(run) and any(all(one in words for one in pair) for words in alike)
            figure = word[0].isdecimal() and not self._seats(i)
            stops = i in self.measured or figure or word in (*MARKS, *small.WITH, *small.REFUSING)
            stops = stops or (word in small.JOINING and not both)  # "the left and right walls"
            of_it = bool(run) and self.lexicon.noun([run[-1], *self.words[i : i + 2]]) is not None  # "chest of drawers"
            stops = stops or (word in (*small.BREAKING, *small.SELLING) and not of_it)
            stops = stops or (word in small.REACHED and {"by", *small.USING} & {*self.words[i + 1 : i + 2]})
            counts = count_of(word) is not None and word != "couple" and not self._seats(i)
            named = not run and self.lexicon.noun(self.words[i : i + 3]) is not None  # "first aid kit"
            if stops or counts or (word in small.DETERMINERS and not named) or self._closed(i, run, many):
                break
            if run and self._goes_on(i, run):
                break
            run.append(word)
            i += 1
        return run

    def _closed(self, i: int, run: Sequence[str], many: bool) -> bool:
        """Return whether a word here begins a relation or is a verb, not a part of what is named."""
        if self.words[i] in ("seat", "seats") and run and (count_of(self._word(i + 1)) or 0) > 1:
            return True  # "the dining table seats six"
        word, known = self.words[i], bool(run) and self.lexicon.noun(run[-1:]) is not None
        if self._begins_relation(i):
            return True
        known = known or run[-1:] in (["couple"], ["people"], ["persons"])  # "a couple renting a flat"
        if known and word.endswith("ing") and self.lexicon.noun([run[-1], word]) is None:
            return bool(self._word(i + 1)) and self.lexicon.noun(self.words[i : i + 2]) is None  # "a desk bearing"
        if word in ("left", "hanging", "standing", "built"):
            return not self._continues(i)
        if self.grammar.phrases.get(word, ("", ""))[0] not in ("verb", "pron"):
            return bool(run) and run[-1] in ("people", "persons")  # "two people read"
        if not run and self.words[i - 1] in ("a", "an", "the") and self.lexicon.noun([word]) is not None:
            return False  # "a watch"
        ends = self._word(i + 1) in ("", *MARKS, *small.JOINING)
        if word == "stands" and not run and self.words[i - 1] == "on" and ends:
            return False  # "guitars on stands"
        article, before = (self._word(i - len(run) - back) for back in (1, 2))
        if word == "stand" and run and article in ("a", "an") and before not in small.JOINING:
            return False  # "on a keyboard stand"
        area = word in small.DONE_THERE and self._word(i + 1).removesuffix("s") in small.AREA_NOUNS  # "a sitting area"
        area = area or f"{word} {self._word(i + 1)}" in self.lexicon.room_words  # "a sitting room"
        if area or (self.lexicon.noun(self.words[i : i + 2]) is not None and self._continues(i)):
            return False
        known = bool(run) and self.lexicon.noun([run[-1], word]) is not None
        # "a lamp and a plant stand next to each other"
        mutual = bool({("each", "other"), ("one", "another")} & {*pairwise(self.words[i + 1 : i + 6])})
        told = i == len(run) or self._leads(i - len(run) - 1)
        return (
            not known
            or (word == "stands" and self._word(i + 1) in ("", *MARKS) and self.words[i - len(run) - 1] in ("a", "an"))
            or (word == "stands" and not many and self._begins_relation(i + 1) and told)
            # "a cup and a printer stand on it"
            or (
                word == "stand"
                and before == "and"
                and self.lexicon.noun(run[-1:]) is not None  # "and a music stand beside it"
                and self._begins_relation(i + 1)
                and self._word(i + 2) in ("it", "them")
            )
            # "before the plant stand two chairs"
            or (word in ("stand", "stands") and article not in ("a", "an") and self._leads(i + 1))
            or (word == "stand" and (run[-1].endswith("s") or (mutual and self._begins_relation(i + 1))))
        )

    def _named(self, at: int, i: int, run: list[str], told: bool, before: Before) -> Chunk | None:
        """Return what a run names; the longest end that is known says what, else what an article promises is a thing."""
        det, number, bound, rows = before
        whole = told and not self._does(run, i + len(run))
        if (
            owned := self._owned(at, i, run, before)
            or self._bedded(at, i, run, before)
            or self._slip(at, i, run, before)
        ):
            return owned
        noun = self.lexicon.noun(run) if det in ("a", "each") and run[0] in self.grammar.styles else None
        if len(run) == 1 and noun is not None:  # "a glass"
            return Chunk("thing", at, i + 1, "", noun, det, number, bound, _plural(run[0], noun))
        for end in range(len(run), 0, -1):
            for start in range(end):
                tail = run[start:end]
                chunk = self._known(tail)
                if chunk and end < len(run) and not told and chunk[0] != "thing":
                    continue  # "a sofa today"
                if chunk and not (chunk[0] == "function" and start and self.lexicon.noun(run[start - 1 : start])):
                    kind, value, noun = chunk
                    after, number = self._counted_after(i + end, number) if kind == "thing" else (0, number)
                    owner = i + end - 1 in self.owners or kind not in ("thing", "part", "corner")
                    plural = not owner and _plural(tail[-3 if "of" in tail else -1], noun)
                    adjectives = (*run[:start], *heaped(self.words[at:i]))
                    adjectives += (
                        tuple(tail[-1:]) if value == "side" and tail[-1] in (*small.HALVES, "ends", "headboard") else ()
                    )
                    inner = self._told_after(i + end) if kind == "thing" and not after else ()
                    adjectives, end = (*adjectives, *inner), end + after + len(inner) + 2 * bool(inner)
                    return Chunk(kind, at, i + end, value, noun, det, number, bound, plural, adjectives, rows=rows)
            if end == len(run) and whole and (room := self.lexicon.room_like(run)):
                return Chunk("room", at, i + end, room, None, det, number, bound)
            basement = det == "the" and run[-1] in self.grammar.places
            if end == len(run) and whole and (part := "room" if basement else self.lexicon.part_like(run)):
                return Chunk("part", at, i + end, part, None, det, number, bound, adjectives=tuple(run[:-1]))
            if end == len(run) and whole and self._promises(run) and self._is_noun(i + end - 1, det):
                noun = self.lexicon.guess(run)
                return Chunk("thing", at, i + end, "", noun, det, number, bound, _plural(run[-1], noun), (), rows=rows)
        return None

    def _owned(self, at: int, i: int, run: list[str], before: Before) -> Chunk | None:
        """Return a thing whose side is named: "the sofa's left side", "the table's centre"."""
        k = next((k for k in range(len(run)) if i + k in self.owners), -1)
        noun = self.lexicon.noun(run[: k + 1][-2:]) or self.lexicon.noun(run[k : k + 1]) if k >= 0 else None
        end = i + k + 1
        side = self._word(end) if noun is not None else ""
        part = self.grammar.parts.get(side) in ("side", "middle", "corner")
        if side not in small.OF_A_SIDE and not part:
            return None
        while self._word(end) in ("hand", *small.OF_A_SIDE, *self.grammar.parts):
            end += 1
        return Chunk("thing", at, end, small.OF_A_SIDE.get(side, ""), noun, *before[:3], adjectives=tuple(run[:k]))

    def _bedded(self, at: int, i: int, run: list[str], before: Before) -> Chunk | None:
        """Return what a room has so many of by its name: "a four-bed ward", "a 12 desk classroom"."""
        noun = self.lexicon.noun(run[:1]) if (before[1] or 1) > 1 else None
        rooms = (" ".join(run[k:]) in self.lexicon.room_words for k in range(1, len(run)))
        own = noun is not None and noun.said in small.OWN and any(rooms)
        return Chunk("thing", at, i + 1, "", noun, "", *before[1:3], plural=True) if own else None

    def _slip(self, at: int, i: int, run: list[str], before: Before) -> Chunk | None:
        """Return a thing whose name is misspelt, and before the first thing of a text the room: "bedroom twin beds"."""
        first = at == i == 0 and not self.lexicon.noun(run)
        for k in range(1, len(run) if first else 0):
            if (room := self.lexicon.room_words.get(" ".join(run[:k]))) and self.lexicon.noun(run[k:]):
                return Chunk("room", at, k, room)
        odd = [k for k, word in enumerate(run) if word not in self.grammar.adjectives and not self.lexicon.noun([word])]
        item = at == i and self._word(at - 1) in ("", *MARKS, *small.JOINING) and odd and len(run[odd[0]]) > SHORT
        item = item and self._class(i + odd[0]) in ("", "noun", "name", "adjective")  # not "ranged along the wall"
        noun = self.lexicon.slip(run[odd[0] :]) if item else None
        known = any(self._known(run[k:]) for k in range(len(run)))
        if noun is None or self.lexicon.noun(run[odd[0] :]) or (known and noun.kind.split()[-1:] != run[-1:]):
            return None  # "wardrope on the left wall", "a dumbell rack"
        return Chunk("thing", at, i + len(run), "", noun, *before[:3], _plural(run[-1], noun), tuple(run[: odd[0]]))

    def _does(self, run: list[str], end: int) -> bool:
        """Return whether the last word of a run is what the thing or place before it does: "the armchair makes", "armchairs join"."""
        noun = self.lexicon.noun(run[-2:-1]) if len(run) > 1 else None
        # "this bedroom comprises a bed", but not "the kitchen utensils"
        if noun is None and (self._leads(end) or self._word(end) in ("you", "us", "it", "them")):
            return any(self._known(run[k:-1]) for k in range(len(run) - 1)) and _plural(run[-1], None)
        return noun is not None and run[-1].endswith("s") != _plural(run[-2], noun)

    def _known(self, tail: list[str]) -> tuple[str, str, Noun | None] | None:
        """Return (kind, value, noun) of a phrase that is known as it stands."""
        phrase = " ".join(tail)
        single = phrase.removesuffix("s")
        if phrase in self.lexicon.bodies and phrase not in ("wheelchair", "rollator", "walker", "accessible"):
            return "body", self.lexicon.bodies[phrase], None
        if phrase in self.lexicon.room_words:
            return "room", self.lexicon.room_words[phrase], None
        if phrase in self.grammar.functions:
            return "function", phrase, None
        part = tail[-1].removesuffix("s") in small.AREA_NOUNS or tail[-1] == "group"
        done = " ".join(tail[:-1]) if part else phrase.removesuffix("space")
        if done != phrase and done in small.DONE_THERE:
            return "corner", small.DONE_THERE[done], None
        if phrase in self.grammar.parts or single in self.grammar.parts:
            return "part", self.grammar.parts.get(phrase, self.grammar.parts.get(single, "")), None
        if len(tail) == 1 and phrase in small.PEOPLE:
            return "people", phrase, None
        if len(tail) == 1 and (phrase in self.grammar.styles or phrase in self.grammar.fillers):
            return None  # "of glass"
        noun = self.lexicon.noun(tail)
        return ("thing", "", noun) if noun else None

    def _single(self, at: int) -> Chunk:
        """Return a word that is part of nothing larger."""
        word = self.words[at]
        if word in small.COMPASS and self._word(at - 1) in ("facing", "faces", "face", "the"):
            return Chunk("part", at, at + 1, "wall", det="the", adjectives=(word,))
        if word[0].isdecimal() and self.words[at + 1 : at + 2] and self.words[at + 1] in small.SCALES:
            return Chunk("other", at, at + 2, word)  # "a 65 inch TV"
        for size in range(min(3, len(self.words) - at), 0, -1):
            phrase = " ".join(self.words[at : at + size])
            if phrase in self.grammar.styles or (size == 1 and word in self.grammar.sizes):
                return Chunk("style", at, at + size, phrase)
        kind, value = self.grammar.phrases.get(word, ("", ""))
        if kind in ("verb", "pron"):
            return Chunk(kind, at, at + 1, value)
        closed = word in small.DETERMINERS or word in self.grammar.fillers or count_of(word) is not None
        if self._word(at - 1) == "for" and not closed:
            return Chunk("function", at, at + 1, word)  # "a bowl for keys"
        closed = closed or word in small.BREAKING
        told = "joining" if closed else self._class(at)
        if told == "joining" or (told == "name" and self._word(at - 1) in small.DETERMINERS):
            return Chunk("filler", at, at + 1, word)
        if told in ("does", "done", "doing"):
            return Chunk("verb", at, at + 1, word if word in small.WALKING else told)
        ends = self._word(at + 1) in ("", *MARKS, *small.JOINING)
        led = self._class(at + 1) in ("adjective", "done") or self._word(at + 1) in self.grammar.styles
        # "clad in slate", "softly lit", but not "symmetrically"
        style = told == "adjective" or (told == "adverb" and led)
        style = style or (told == "noun" and ends and self._word(at - 1) in ("in", "with", "and"))
        return Chunk("style" if style else "other", at, at + 1, word)


def _plural(word: str, noun: Noun | None) -> bool:
    """Return whether a noun's last word stands in the plural."""
    ends = word.endswith("s") and not word.endswith(("ss", "us", "is")) and len(word) > 3
    return (ends or word in ("shelves", "knives", "people")) and (noun is None or not noun.words.endswith(word))
