"""The words of a text against the closed lists: where a relation begins, what bounds a count, which words go on."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import cached_property
from itertools import takewhile

from robolayout.words import _function_words as small
from robolayout.words._chunk import ROWS, SOME
from robolayout.words._lexicon import LONGEST, Lexicon, grammar
from robolayout.words._speech import classes
from robolayout.words._tokens import MARKS, Measure, Token, count_of

UNREAD = "unreadable"
"""What stands for a phrase that is not to be understood, see `reworded.toml`."""


def heaped(words: Sequence[str]) -> list[str]:
    """Return how what follows some words stands: nothing where they say nothing of it.

    >>> heaped(["a", "half", "circle", "of", "six"])
    ['halfcircle']
    """
    before = f" {' '.join(words)} "
    return [how for phrase, how in small.HEAPS.items() if f" {phrase} of " in before][:1]


class ClosedWords:
    """The words of a text."""

    def __init__(self, words: Sequence[Token], found: Sequence[Measure], lexicon: Lexicon) -> None:
        self.words = [word.text for word in words]
        self.owners = {i for i, w in enumerate(words) if w.text.endswith("s") and w.end - w.start == len(w.text) + 1}
        self.lexicon = lexicon
        self.grammar = grammar()
        self.measured = {
            next((i for i, w in enumerate(words) if w.end > measure.start), len(words)): measure for measure in found
        }
        within = {
            i: takewhile(lambda w, m=m: m.start < w.end and w.start < m.end, words[i:])
            for i, m in self.measured.items()
        }
        self.after = {i: i + sum(1 for _ in inner) for i, inner in within.items()}
        meant = {i: word.measure for i, word in enumerate(words) if word.measure is not None}
        self.measured |= meant
        self.after |= {i: i + 1 for i in meant}

    @cached_property
    def _classes(self) -> list[str]:
        return classes(self.words)

    def _class(self, i: int) -> str:
        """Return the word class of a word that no list has, as it is used here; "" for all others."""
        word, known = self._word(i), self.grammar
        if not word.isalpha() or word in MARKS or count_of(word) is not None or self._begins_relation(i):
            return ""
        lists = (known.phrases, known.adjectives, known.parts, known.functions, known.places, self.lexicon.room_words)
        small_words = (
            *(small.BREAKING, small.DETERMINERS, small.WITH, small.JOINING, small.PEOPLE, small.REFUSING),
            *(small.REACHED, small.USING, small.ABLE, (UNREAD,)),
        )
        nouns = (self.words[a : i + b] for a, b in ((i, 1), (max(i - 1, 0), 1), (i, 2)))
        if any(word in words for words in (*lists, *small_words)) or any(map(self.lexicon.noun, nouns)):
            return ""
        return self._classes[i]

    def _goes_on(self, i: int, run: Sequence[str]) -> bool:
        """Return whether a word that no list has says what the thing before it does, or is joined to: "a palm softens"."""
        told, after = self._class(i), (self.words[i + 1 : i + 1 + size] for size in (1, 2, 3))
        before_noun = any(self.lexicon.noun(words) is not None for words in after if words)
        if self.words[i].endswith("ed") and before_noun:
            return False  # "a paint splattered table"
        done = told in ("done", "doing") and self.lexicon.noun(run[-1:]) is not None and not before_noun
        return done or told in ("does", "joining", "placing")

    def _is_noun(self, i: int, det: str) -> bool:
        """Return whether a word that no list has can be a thing here: not "every morning", "the spacious"."""
        told = self._class(i)
        return not told or (told == "noun" and det != "each") or (told == "name" and det not in ("each", "the"))

    def _word(self, i: int) -> str:
        """Return the word at a place, "" outside of the text."""
        return self.words[i] if 0 <= i < len(self.words) else ""

    def _clause(self, at: int, end: int) -> bool:
        """Return whether words begin a clause and what they are about follows: "..., on the right a desk"."""
        before, following = (["", *self.words, ""][i] for i in (at, end + 1))
        starts = not before or before in MARKS or before in small.JOINING
        return starts and (following in small.DETERMINERS or bool(count_of(following)))

    def _overlaid(self, at: int, size: int) -> bool:
        """Return whether a relation that begins within this one goes on beyond it: "placed on either side of"."""
        left = min(LONGEST - 1, len(self.words) - at - size)
        spans = ((i, at + size + more + 1) for i in range(at + 1, at + size) for more in range(left))
        phrases = ((" ".join(self.words[i:end]), end) for i, end in spans)
        known = ((phrase, end) for phrase, end in phrases if self.grammar.phrases.get(phrase, ("", ""))[0] == "rel")
        return any(self._is_relation(phrase, end) for phrase, end in known)  # none in "parallel to the left wall"

    def _is_relation(self, phrase: str, end: int) -> bool:
        """Return whether a phrase is a relation here: "opposite walls", "left bank" and "to the left wall" are none."""
        following = self._word(end)
        places = ("wall", "side", "end", "corner")
        if phrase in ("opposite", "across", "adjoining") and following.removesuffix("s") in places:
            return False
        sided = phrase.endswith(("left", "right", "middle", "center", "centre")) and " its " not in phrase
        sided = sided and not phrase.startswith("from ")  # "from left to right"
        if sided and following and following not in MARKS:
            if re.match("and (the )?(left|right) walls?( |$)", " ".join(self.words[end : end + 4])):
                return False  # "on the left and right walls"
            told = following in (*small.JOINING, *small.ALONE_DOES, "there", "with", "are", "stand")
            return told or self._leads(end)
        if re.search("long side|oppos[a-z]* (sides|ends)", phrase) and "room" in self.words[end : end + 3]:
            return False
        if phrase in ("round", "all round"):
            walked = self._word(end - len(phrase.split()) - 1) in ("walk", "move", "go", "get", "way")
            return not walked and following in ("the", "it", "them", "each", "both", "that", "this")
        if phrase in small.LEADING:
            counted = phrase in ("line", "lines") and count_of(following) is not None
            return following in small.DETERMINERS or following in ("it", "them") or counted
        if phrase in ("at", "around", "over", "about") and (following.isdigit() or following in ("least", "most")):
            return False
        if phrase in ("before", "besides", "row"):
            begins = phrase == "besides" and self._word(end - 2) in ("", *MARKS)  # "besides the bed there is a desk"
            return phrase != "row" and not begins and (following in small.DETERMINERS or following in ("it", "them"))
        if phrase in small.HEAPS.values() or phrase in ("diagonal", "angled"):
            return not self._continues(end - 1) or following in small.JOINING
        return True

    def _bound(self, at: int) -> tuple[str, int]:
        """Return a bound on a count that begins here, and its length."""
        for phrase, bound in small.BOUNDS.items():
            if tuple(self.words[at : at + len(phrase)]) == phrase:
                return bound, len(phrase)
        return "", 0

    def _leads(self, i: int) -> bool:
        """Return whether the word at a place is an article or a number."""
        return self._word(i) in small.DETERMINERS or count_of(self._word(i)) is not None

    def _begins_relation(self, i: int) -> bool:
        for size in range(min(LONGEST, len(self.words) - i), 0, -1):
            phrase = " ".join(self.words[i : i + size])
            kind = self.grammar.phrases.get(phrase, ("", ""))[0]
            if kind in ("and", "alone", "not") or (kind == "rel" and self._is_relation(phrase, i + size)):
                return True
        return False

    def _continues(self, i: int) -> bool:
        """Return whether a noun may follow: "hanging chair"."""
        following = self._word(i + 1)
        closed = not following or following in MARKS or following in small.DETERMINERS
        return not closed and not self._begins_relation(i + 1)

    def _seats(self, i: int) -> bool:
        """Return whether a number is part of a name here: "two-seater", "twin bed"."""
        following, beyond = (*self.words[i + 1 : i + 3], "", "")[:2]
        counted = following in ("door", "drawer", "person", "tier") and beyond.isalpha()
        counted = counted and beyond not in (*small.JOINING, *small.WITH, *small.DETERMINERS)
        return self.words[i] == "twin" or following in ("seat", "seater", "poster") or counted

    def _told_after(self, end: int) -> tuple[str, ...]:
        """Return what is said of a noun in brackets after it: "a bed (double)", "a sofa (3-seater)"."""
        closing = self.words[end : end + 4].index(")") if ")" in self.words[end : end + 4] else 0
        told = tuple(self.words[end + 1 : end + closing]) if self._word(end) == "(" else ()
        known = self.grammar.adjectives - self.grammar.fillers - self.grammar.parts.keys() if told else ()
        return told if all(word in known for word in told) else ()

    def _counted_after(self, end: int, number: int | None) -> tuple[int, int | None]:
        """Return how many words after a noun say its number, and that: "chairs (4)", "chairs: 4", "chairs x 4"."""
        mark, rest = self._word(end), [word for word in self.words[end + 1 : end + 5] if word != "x"]  # "cabinets (x3)"
        count = count_of(rest[0]) if rest and mark in ("(", ":", "x") else None
        if number is not None or count is None or end + 1 in self.measured or (mark == "(") != (")" in rest):
            return 0, number
        if mark == "(" and rest[1] not in (")", "in", "pcs", "pieces"):
            return 0, number  # "a wardrobe (3 doors)"
        if mark == "(":  # "the chairs (four in total)"
            return self.words.index(")", end) + 1 - end, count
        ends = self._word(end + 2) or "."
        return (2, count) if rest[0].isdecimal() and ends in MARKS else (0, number)

    def _some_of(self, word: str, rest: list[str]) -> tuple[str, int | None, str, int, int] | None:
        """Return the same of what says which share of several is meant: "half of", "every other", "all but one of"."""
        here = " ".join((word, *rest, ""))
        share = next((name for name in small.SHARES if here.startswith(f"{name} of ")), "")
        if share or (word == "half" and rest[:1] == ["the"]):
            return (share or word, None, "", 0, len(share.split()) + 1)
        if word == "every" and rest[:1] in (["other"], ["second"]):
            return ("half", None, "", 0, 2)
        but = count_of(rest[1]) if word == "all" and rest[:1] == ["but"] and rest[1:] else None
        return ("one", -but, "", 0, 3 + (rest[2:3] == ["of"])) if but else None

    def _of(self, word: str, rest: list[str], number: int | None) -> tuple[str, int | None, str, int, int] | None:
        """Return the same of what ends in "of": "two rows of", "each one of", "a pair of"."""
        count = count_of(word)
        each, grouped = count_of((*rest[2:], "")[0]), rest[0].removesuffix("s")
        if rest[0] in ("rows", "row", "columns", "column") and count:
            rows = (each or SOME) if rest[0].startswith("column") else count
            return ("", count * each if each else None, "", rows, 4 if each else 3)
        if count and each and grouped in (*small.SETS, *small.GROUPS):
            return ("", count * each, "", -each * (grouped in small.GROUPS), 4)  # "six groups of four desks"
        if count and count > 1 and grouped in small.GROUPS and rest[1:2] == ["of"]:
            return ("", count * ROWS, "vague", -ROWS, 3)  # "four groups of armchairs"
        if word in ("each", "every") and rest[0] in ("one", "of"):
            return ("each", None, "", 0, 3 if rest[0] == "one" else 2)
        if rest[0] != "of":
            return None
        each = count_of((*rest[1:], "")[0])
        if each and word.endswith("s") and word.removesuffix("s") in small.GROUPS:
            return ("", 2 * each, "vague", -each, 3)  # "clusters of four desks"
        if word.removesuffix("s") in small.SETS and not (word == "wall" and rest[1:2] and rest[1] in small.DETERMINERS):
            of_one = rest[1:2] and rest[1].removesuffix("s") in small.PAIRED  # "two pairs of shoes"
            twos = (number or 1) * (1 if of_one else 2) if word.startswith(("pair", "couple")) else None
            return ("", twos, "", SOME if word == "rows" and number is None else 0, 2)
        if word in ("both", "all"):
            return ("all", None, "", 0, 2)
        return ("one", count, "", 0, 2) if count and {*rest[1:2]} & {"the", "these", "those", "his", "her"} else None

    def _promises(self, run: list[str]) -> bool:
        """Return whether an article before such words promises a thing."""
        last, known = run[-1], self.grammar
        kinds = (known.styles, known.functions, known.fillers, known.sizes, known.walls)
        closed = any(last in words for words in (*kinds, small.COMPARING, small.NO_THINGS))
        return not closed and len(last) > 2 and not last.endswith(("ly", "wards"))
