"""Phrases in words that the parser knows: "a wheelchair can reach both sides of the bed" asks for free floor there."""

from __future__ import annotations

import re
import tomllib
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import replace
from importlib.resources import files
from itertools import accumulate

from robolayout.words._tokens import Measure, Token, measures

METRES = {"WIDTH": 0.0, "TURNING": 1.5, "EYES": 1.5, "YOUNG": 1.0}
"""Metres by the word of a rule: of free floor as much as the body needs to pass (0), or a wheelchair to turn round (ISO 21542);
above the floor where adults and children look."""

_FIGURED = ("LENGTH", "WIDE", "SPARES")
"""Parts that have a length in figures."""

_DATA: dict[str, dict[str, str]] = tomllib.loads((files("robolayout.words") / "reworded.toml").read_text("utf-8"))


def _compiled(phrase: str) -> re.Pattern[str]:
    for name, part in _DATA["parts"].items():
        phrase = phrase.replace(name, part)
    return re.compile(rf"(?<!\S)(?<!of ){phrase}(?!\S)")


RULES = tuple(
    (_compiled(phrase), said.split(), any(part in phrase for part in _FIGURED))
    for phrase, said in _DATA["said"].items()
)


def reworded(words: list[Token]) -> list[Token]:
    """Return the words of a text with such phrases as the parser knows them, each in the place of what it stands for."""
    text = " ".join(word.text for word in words)
    for rule, said, figures in RULES:
        found = [*rule.finditer(text)]
        starts = [0, *accumulate(len(word.text) + 1 for word in words)] if found else []
        for match in reversed(found):
            spans = [slice(*(bisect_left(starts, at) for at in span)) for span in match.regs if span[0] >= 0]
            words = [*words[: spans[0].start], *_put(said, words, spans, figures=figures), *words[spans[0].stop :]]
        text = " ".join(word.text for word in words) if found else text
    return words


def _put(said: Sequence[str], words: Sequence[Token], spans: Sequence[slice], *, figures: bool) -> Iterator[Token]:
    """Yield what is said instead of a phrase whose groups are at some places among the words.

    It stands for the whole phrase; where that has `figures`, which are found by their places, for nothing of it.
    """
    at, end = words[spans[0].start].start, words[spans[0].stop - 1].end
    last = max((i for i, word in enumerate(said) if word.startswith("{")), default=-1)
    for i, word in enumerate(said):
        if word.startswith("{"):
            group = words[spans[int(word[1])]]
            figured = figures and group[0].text != "the"
            length = " ".join((*(one.text for one in group), word[3:].lower()))
            if figured and (told := measures(length)):  # one token with its measure
                first, beyond = group[0], group[-1].end
                group = [replace(first, end=beyond, measure=replace(told[0], start=first.start, end=beyond))]
            yield from group
            at = group[-1].end if figures else at
        else:
            meant = Measure("length", (METRES[word],), at, at) if word in METRES else None
            there = (end, end) if figures and i > last >= 0 else (at, at if figures else end)
            yield Token(word.lower(), *there, meant)
