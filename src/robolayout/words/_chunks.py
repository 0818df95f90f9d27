"""From words to chunks: things with article, number and adjectives; places of the room; relations; what joins them.

A noun phrase is an article or a number, then a run of words up to the next word of the closed lists. The longest end of the run
that names something says what it is: "two leather office chairs" are two office chairs, "home office" is a room.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from robolayout.words._chunk import MARKS, Chunk, without_noun
from robolayout.words._function_words import (
    BOUNDS,
    BREAKING,
    DETERMINERS,
    JOINING,
    ORDINALS,
    PEOPLE,
    REFUSING,
    SETS,
    WITH,
)
from robolayout.words._lexicon import LONGEST, Lexicon, Noun, grammar
from robolayout.words._tokens import VAGUE, Measure, Token, count_of

SOME = -1
"""Rows of which no number is said."""

HALVES = ("back", "rear", "front", "left", "right")
"""Sides of the room that are halves of it."""

SCALES = ("inch", "inches", "in", "cm", "mm", "m", "metre", "metres", "meter", "meters", "ft", "foot", "feet")
"""Words after a number that is no count."""

HEAPS, HEAPED = ("stack", "pile"), ("stacked", "piled")
"""Words for things one on top of the other: before "of", and of the things."""


Before = tuple[str, int | None, str, int]
"""What stands before a noun: article, number, bound, rows."""


class Chunker:
    """Cuts a text into chunks.

    Args:
        words: The text's words.
        found: The measures in it.
        lexicon: The nouns that are known.
    """

    def __init__(self, words: Sequence[Token], found: Sequence[Measure], lexicon: Lexicon) -> None:
        self.words = [word.text for word in words]
        self.lexicon = lexicon
        self.grammar = grammar()
        self.measured = {
            next((i for i, w in enumerate(words) if w.end > measure.start), len(words)): measure for measure in found
        }
        self.after = {i: sum(1 for w in words if w.start < m.end) for i, m in self.measured.items()}

    def chunks(self) -> list[Chunk]:
        """Return all chunks, in order; together they cover every word."""
        found: list[Chunk] = []
        at = 0
        while at < len(self.words):
            chunk = self._next(at)
            if chunk.kind == "room" and chunk.det == "a" and any(c.kind == "room" for c in found):
                chunk = self._in_room(chunk)
            found.append(without_noun(self.words, at, found, self._run) or chunk)
            at = found[-1].end
        return found

    def _in_room(self, chunk: Chunk) -> Chunk:
        """Return a further room as a thing of the first, where its name is one: "a studio with a kitchenette"."""
        words = self.words[chunk.start : chunk.end]
        noun = next((n for i in range(1, len(words)) if (n := self.lexicon.noun(words[i:]))), None)
        return chunk if noun is None else replace(chunk, kind="thing", value="", noun=noun)

    def _next(self, at: int) -> Chunk:
        if at in self.measured:
            thing = self._noun_phrase(at)  # "2.2 m wide sofa"
            if thing is not None and thing.kind == "thing":
                return thing
            measure, end = self.measured[at], max(self.after[at], at + 1)
            gap = measure.kind in ("apart", "between")
            return Chunk("rel" if gap else "measure", at, end, measure.kind if gap else "", measure=measure)
        if self.words[at] in MARKS:
            return Chunk(MARKS[self.words[at]], at, at + 1, self.words[at])
        return self._role(at) or self._fixed(at) or self._noun_phrase(at) or self._single(at)

    def _role(self, at: int) -> Chunk | None:
        """Return what a thing is to serve as ("as an island"), or how many a table seats: neither is one more thing."""
        before, word, following = (["", *self.words, "", ""][at + i] for i in range(3))
        if word in ("seat", "seats", "seating") and count_of(following):
            return Chunk("people", at, at + 2, "people", number=count_of(following))
        role = word == "as" and following in ("a", "an", "the") and before not in ("well", "such", "same", "wall")
        named = self._noun_phrase(at + 1) if role else None
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
                each = rows > 1 and self.words[at + size : at + size + 1] == ["of"]  # "in three rows of four"
                size += 2 * bool(each and count_of(*self.words[at + size + 1 : at + size + 2] or [""]))
                of_it = words[-1] in ("left", "right") and phrase != words[-1] and self._clause(at, at + size)
                its = "its" if (" its " in phrase and value != "wall") or of_it else ""
                return Chunk("rel", at, at + size, value, det=its, rows=rows, adjectives=tuple(words))
            if kind == "and" or (kind == "pron" and size > 1 and phrase != "the two"):
                return Chunk(kind, at, at + size, phrase)
        word = self.words[at]
        if word in REFUSING and not self._bound(at)[0]:
            return Chunk("not", at, at + 1, word)
        if word in WITH:
            return Chunk("with", at, at + 1)
        return Chunk("and", at, at + 1, word) if word in JOINING else None

    def _clause(self, at: int, end: int) -> bool:
        """Return whether words begin a clause and what they are about follows: "..., on the right a desk"."""
        before, following = (["", *self.words, ""][i] for i in (at, end + 1))
        starts = not before or before in MARKS or before in JOINING
        return starts and (following in DETERMINERS or bool(count_of(following)))

    def _overlaid(self, at: int, size: int) -> bool:
        """Return whether a relation that begins within this one goes on beyond it: "placed on either side of"."""
        phrases = (self.words[i : at + size + more] for i in range(at + 1, at + size) for more in range(1, LONGEST))
        return any(self.grammar.phrases.get(" ".join(words), ("", ""))[0] == "rel" for words in phrases)

    def _is_relation(self, phrase: str, end: int) -> bool:
        """Return whether a phrase is a relation here: "opposite walls", "left bank" and "to the left wall" are none."""
        following = self.words[end] if end < len(self.words) else ""
        if phrase in ("opposite", "across") and following.removesuffix("s") in ("wall", "side", "end", "corner"):
            return False
        sided = phrase.endswith(("left", "right", "middle", "center", "centre")) and " its " not in phrase
        if sided and following and following not in MARKS:
            leads = following in DETERMINERS or count_of(following) is not None
            return leads or following in (*JOINING, "there", "is", "stands", "with", "sits", "are", "stand", "hangs")
        if "long side" in phrase and "room" in self.words[end : end + 3]:
            return False
        if phrase in ("line", "lines"):
            return following in DETERMINERS or count_of(following) is not None
        if phrase in ("nearest", "flank", "block", "blocks"):
            return following in DETERMINERS
        if phrase in ("at", "around", "over", "about") and (following.isdigit() or following in ("least", "most")):
            return False
        if phrase in ("before", "row"):
            return phrase == "before" and (following in DETERMINERS or following in ("it", "them"))
        if phrase in HEAPED or phrase in ("diagonal", "angled"):
            return not self._continues(end - 1) or following in JOINING
        return True

    def _bound(self, at: int) -> tuple[str, int]:
        """Return a bound on a count that begins here, and its length."""
        for phrase, bound in BOUNDS.items():
            if tuple(self.words[at : at + len(phrase)]) == phrase:
                return bound, len(phrase)
        return "", 0

    def _noun_phrase(self, at: int) -> Chunk | None:
        """Return a noun phrase that begins here: a thing, a place, a room, a body or people."""
        bound, skip = self._bound(at)
        i = at + skip
        det, number, rows = "", None, 0
        sized: list[int] = []
        while i < len(self.words):
            sized += range(i, i + self._sizes(i))
            i = sized[-1] + 1 if sized and sized[-1] >= i else i
            step = self._before_noun(i, det, number) if i < len(self.words) else None
            if step is None:
                break
            det, number, bound, rows = (
                det if det in ("each", "one") else step[0] or det,
                step[1] if step[1] is not None else number,
                step[2] or bound,
                step[3] or rows,
            )
            i += step[4]
        run = self._run(i, many=(number or 1) > 1)
        if not run:
            return Chunk("pron", at, i, "the two") if det == "the" and (number or 0) > 1 else None
        told = bool(det or number is not None or bound)
        chunk = self._named(at, i, run, told, (det, number, bound, rows))
        if not sized or chunk is None:
            return chunk
        inner = {k for j in sized if j in self.measured for k in range(j, self.after[j])}
        adjectives = tuple(self.words[j] for j in sized if j not in inner)
        sizes = tuple(self.measured[j] for j in sized if j in self.measured)
        same = replace(chunk, sizes=sizes, adjectives=(*adjectives, *chunk.adjectives))
        return same if chunk.kind == "thing" else None

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
        seats = word == "that" and rest[:1] == ["seats"]
        if seats or i in self.measured or (word == "first" and self.lexicon.noun(self.words[i : i + 3])):
            return None  # "first aid kit"
        if rest[:1] == ["of"] and word.removesuffix("s") in SETS:
            twos = 2 * (number or 1) if word.startswith(("pair", "couple")) else None
            return ("", twos, "", SOME if word == "rows" and number is None else 0, 2)
        if len(rest) > 2 and rest[0] in ("rows", "row") and rest[1] == "of" and count_of(rest[2]) and count_of(word):
            rows, each = count_of(word) or 1, count_of(rest[2]) or 1
            return ("", rows * each, "", rows, 4)
        if len(rest) > 1 and rest[0] == "rows" and rest[1] == "of" and count_of(word):
            return ("", None, "", count_of(word) or 1, 3)
        if word in ("couple", "both", "all", "each") and rest[:1] == ["of"]:
            return ("each" if word == "each" else "all", None, "", 0, 2)
        if count_of(word) and rest[:1] == ["of"] and {*rest[1:2]} & {"the", "these", "those", "his", "her"}:
            return ("one", count_of(word), "", 0, 2)
        if word in DETERMINERS and (det == "the" or word not in ORDINALS):
            return (DETERMINERS[word], None, "", 0, 1)
        if word in ("only", "just", "exactly", "about", "additional", "more"):
            return ("", None, "", 0, 1) if self._run(i + 1) or count_of(rest[0] if rest else "") else None
        count = None if self._seats(i) or (rest[:1] and rest[0] in SCALES) else count_of(word)
        if count and number is None and word not in ("a", "an", "twin", "couple"):
            return ("", count, "vague" if word in VAGUE else "", 0, 1 + (rest[:1] in (["of"], ["x"])))
        return None

    def _run(self, i: int, *, many: bool = False) -> list[str]:
        """Return the words from here up to the next one that cannot be part of a noun phrase."""
        run: list[str] = []
        while i < len(self.words) and len(run) < LONGEST + 2:
            word = self.words[i]
            pair = self.words[i - 1 : i] + self.words[i + 1 : i + 2]
            both = word == "and" and bool(run) and all(side in self.grammar.walls for side in pair)
            stops = (
                word in MARKS
                or (word in JOINING and not both)  # "the left and right walls"
                or word in WITH
                or (word in BREAKING and not self._named_of(i, run))
                or word in REFUSING
                or i in self.measured
                or word[0].isdecimal()
            )
            counts = count_of(word) is not None and word != "couple" and not self._seats(i)
            named = not run and self.lexicon.noun(self.words[i : i + 3]) is not None  # "first aid kit"
            if stops or counts or (word in DETERMINERS and not named) or self._closed(i, run, many):
                break
            run.append(word)
            i += 1
        return run

    def _named_of(self, i: int, run: Sequence[str]) -> bool:
        """Return whether "of" is part of a name here: "chest of drawers"."""
        return bool(run) and self.lexicon.noun([run[-1], *self.words[i : i + 2]]) is not None

    def _seats(self, i: int) -> bool:
        """Return whether a number is part of a name here: "two-seater", "twin bed"."""
        following, beyond = (*self.words[i + 1 : i + 3], "", "")[:2]
        counted = following in ("door", "drawer", "person", "tier") and beyond not in MARKS and beyond.isalpha()
        counted = counted and beyond not in (*JOINING, *WITH, *DETERMINERS)
        return self.words[i] == "twin" or following in ("seat", "seater", "poster") or counted

    def _closed(self, i: int, run: Sequence[str], many: bool) -> bool:
        """Return whether a word here begins a relation or is a verb, not a part of what is named."""
        word = self.words[i]
        if self._begins_relation(i):
            return True
        if word in ("left", "hanging", "standing", "built"):
            return not self._continues(i)
        if self.grammar.phrases.get(word, ("", ""))[0] not in ("verb", "pron"):
            return bool(run) and run[-1] in ("people", "persons")  # "two people read"
        if not run and self.words[i - 1] in ("a", "an") and self.lexicon.noun([word]) is not None:
            return False  # "a watch"
        if self.lexicon.noun(self.words[i : i + 2]) is not None and self._continues(i):
            return False
        known = bool(run) and self.lexicon.noun([run[-1], word]) is not None
        following = (*self.words[i + 1 : i + 2], ".")[0]
        # "a lamp and a plant stand next to each other"
        mutual = bool({"each", "another"} & {*self.words[i + 1 : i + 5]})
        leads = following in DETERMINERS or count_of(following) is not None  # "before the plant stand two chairs"
        return (
            not known
            or (word == "stands" and following in MARKS and self.words[i - len(run) - 1] in ("a", "an"))
            or (word == "stands" and not many and self._begins_relation(i + 1) and self._told(i - len(run) - 1))
            or (word in ("stand", "stands") and leads)
            or (word == "stand" and (run[-1].endswith("s") or (mutual and self._begins_relation(i + 1))))
        )

    def _told(self, i: int) -> bool:
        """Return whether a word is an article or a number, or stands before the text."""
        return i < 0 or self.words[i] in DETERMINERS or count_of(self.words[i]) is not None

    def _begins_relation(self, i: int) -> bool:
        for size in range(min(LONGEST, len(self.words) - i), 0, -1):
            phrase = " ".join(self.words[i : i + size])
            kind = self.grammar.phrases.get(phrase, ("", ""))[0]
            if kind == "and" or (kind == "rel" and self._is_relation(phrase, i + size)):
                return True
        return False

    def _continues(self, i: int) -> bool:
        """Return whether a noun may follow: "hanging chair"."""
        following = self.words[i + 1] if i + 1 < len(self.words) else ""
        return (
            bool(following)
            and following not in MARKS
            and following not in DETERMINERS
            and not self._begins_relation(i + 1)
        )

    def _named(self, at: int, i: int, run: list[str], told: bool, before: Before) -> Chunk | None:
        """Return what a run names; the longest end that is known says what, else what an article promises is a thing."""
        det, number, bound, rows = before
        whole = told and not self._does(run)
        for end in range(len(run), 0, -1):
            for start in range(end):
                tail = run[start:end]
                chunk = self._known(tail)
                if chunk and end < len(run) and not whole and chunk[0] != "thing":
                    continue  # "a sofa today"
                if chunk and not (chunk[0] == "function" and start and self.lexicon.noun(run[start - 1 : start])):
                    kind, value, noun = chunk
                    owner = self.lexicon.noun(run[:start][-2:]) or self.lexicon.noun(run[:start][-1:])
                    if value == "side" and owner is not None:  # "the bed's headboard"
                        return Chunk("thing", at, i + end, "", owner, det, number, bound)
                    after, number = self._counted_after(i + end, number) if kind == "thing" else (0, number)
                    plural = kind in ("thing", "part") and _plural(tail[-3 if "of" in tail else -1], noun)
                    adjectives = (*run[:start], *(HEAPED[:1] if set(HEAPS) & set(self.words[at:i]) else ()))
                    adjectives += tuple(tail[-1:]) if value == "side" and tail[-1] in HALVES else ()  # "at the back"
                    end += after
                    return Chunk(kind, at, i + end, value, noun, det, number, bound, plural, adjectives, rows=rows)
            if end == len(run) and whole and (room := self.lexicon.room_like(run)):
                return Chunk("room", at, i + end, room, None, det, number, bound)
            if end == len(run) and whole and self._promises(run):
                noun = self.lexicon.guess(run)
                return Chunk("thing", at, i + end, "", noun, det, number, bound, _plural(run[-1], noun), (), rows=rows)
        return None

    def _counted_after(self, end: int, number: int | None) -> tuple[int, int | None]:
        """Return how many words after a noun say its number, and that: "chairs (4)", "chairs: 4", "chairs x 4"."""
        mark, count, ends = (*self.words[end : end + 3], "", "", ".")[:3] if end < len(self.words) else ("", "", "")
        if number is not None or mark not in ("(", ":", "x") or not count.isdecimal() or ends not in MARKS:
            return 0, number
        return 2 + (ends == ")"), int(count)

    def _does(self, run: list[str]) -> bool:
        """Return whether the last word of a run is what the thing before it does: "the armchair makes", "armchairs join"."""
        noun = self.lexicon.noun(run[-2:-1]) if len(run) > 1 else None
        return noun is not None and run[-1].endswith("s") != _plural(run[-2], noun)

    def _known(self, tail: list[str]) -> tuple[str, str, Noun | None] | None:
        """Return (kind, value, noun) of a phrase that is known as it stands."""
        phrase = " ".join(tail)
        single = phrase.removesuffix("s")
        if phrase in self.lexicon.bodies and phrase not in ("wheelchair", "rollator", "walker"):
            return "body", self.lexicon.bodies[phrase], None
        if phrase in self.lexicon.corners:
            return "corner", self.lexicon.corners[phrase], None
        if phrase in self.lexicon.room_words:
            return "room", self.lexicon.room_words[phrase], None
        if phrase in self.grammar.functions:
            return "function", phrase, None
        if phrase in self.grammar.parts or single in self.grammar.parts:
            return "part", self.grammar.parts.get(phrase, self.grammar.parts.get(single, "")), None
        if len(tail) == 1 and phrase in PEOPLE:
            return "people", phrase, None
        if len(tail) == 1 and (phrase in self.grammar.styles or phrase in self.grammar.fillers):
            return None
        noun = self.lexicon.noun(tail)
        return ("thing", "", noun) if noun else None

    def _promises(self, run: list[str]) -> bool:
        """Return whether an article before such words promises a thing."""
        last = run[-1]
        closed = (
            last in self.grammar.styles
            or last in self.grammar.functions
            or last in self.grammar.fillers
            or last in self.grammar.sizes
            or last in self.grammar.walls
        )
        return (
            not closed
            and len(last) > 2
            and not last.endswith("ly")
            and last not in ("total", "style", "kind", "row", "rows", "grid", "line")
        )

    def _single(self, at: int) -> Chunk:
        """Return a word that is part of nothing larger."""
        word = self.words[at]
        if word[0].isdecimal() and self.words[at + 1 : at + 2] and self.words[at + 1] in SCALES:
            return Chunk("other", at, at + 2, word)  # "a 65 inch TV"
        for size in range(min(3, len(self.words) - at), 0, -1):
            phrase = " ".join(self.words[at : at + size])
            if phrase in self.grammar.styles or (size == 1 and word in self.grammar.sizes):
                return Chunk("style", at, at + size, phrase)
        kind, value = self.grammar.phrases.get(word, ("", ""))
        if kind in ("verb", "pron"):
            return Chunk(kind, at, at + 1, value)
        if word in self.grammar.fillers or word in DETERMINERS or count_of(word) is not None or word in BREAKING:
            return Chunk("filler", at, at + 1, word)
        return Chunk("other", at, at + 1, word)


def _plural(word: str, noun: Noun | None) -> bool:
    """Return whether a noun's last word stands in the plural."""
    ends = word.endswith("s") and not word.endswith(("ss", "us", "is")) and len(word) > 3
    return (ends or word in ("shelves", "knives", "people")) and (noun is None or not noun.words.endswith(word))
