"""Which words of a text are verbs, adjectives or nouns, by the Hanover Tagger: of use for words that no list of ours has.

C. Wartena, "A Probabilistic Morphology Model for German Lemmatization", KONVENS 2019; its English model is one of the BNC, with
its word classes (C5: "VVZ" a finite verb, "AJ0" an adjective, "NN1" a noun).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

from robolayout.words._tokens import MARKS

LONGEST_WORD = 30
"""Letters of a word of which the class is asked; the time grows with their square."""

CLASSES = {
    "VVZ": "does", "VVB": "does", "VVD": "does", "VVI": "does", "VVN": "done", "VVG": "doing",
    "AJ0": "adjective", "AJC": "adjective", "AJS": "adjective", "AV0": "adverb",
    "CJS": "joining", "PRP": "placing", "NP0": "name",
}  # fmt: skip
"""What some word classes of the model are here; "does" is a finite verb or an infinitive, the others are nouns."""


@cache
def _tagger() -> Any:
    """The model; 0.1 s."""
    from HanTa.HanoverTagger import HanoverTagger

    return HanoverTagger("morphmodel_en.pgz")


def is_english(word: str) -> bool:
    """Return whether a word stands in the lexicon of the model, and so is no slip of spelling."""
    return word in _tagger().cache or any(word in stems for stems in _tagger().LP_m_t.values())


def classes(words: Sequence[str]) -> list[str]:
    """Return the class of each word of a text: "does", "done", "doing", "adjective", "adverb", "joining" ("since"), "placing"
    ("through"), "name" or "noun"."""
    found: list[str] = []
    sentence: list[str] = []
    for word in (*words, "."):
        sentence.append(word[:LONGEST_WORD])
        if MARKS.get(word) == "stop":
            found += [CLASSES.get(tag, "noun") for _, _, tag in _tagger().tag_sent(sentence, casesensitive=False)]
            sentence = []
    return found[: len(words)]
