"""Several things of one kind in one sentence, each as it is said to be: coordinate adjectives, appositions, "both"."""

from __future__ import annotations

import pytest

from robolayout.words import Lexicon, Mention, Reading, read_rooms, read_text

LEXICON = Lexicon(read_rooms())

Told = list[tuple[int, str, str]]
"""Counts, adjectives and nouns, in the order in which they are said."""


def read(text: str) -> Reading:
    return read_text(text, LEXICON)


def told(text: str) -> Told:
    return [(t.count, " ".join(t.adjectives), t.noun.words) for t in read(text).parsed.things]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a blue and a red chair", [(1, "blue", "chair"), (1, "red", "chair")]),
        ("a red, a blue, and a green chair", [(1, "red", "chair"), (1, "blue", "chair"), (1, "green", "chair")]),
        ("one large and two small desks", [(1, "large", "desk"), (2, "small", "desk")]),
        ("the big and the small wardrobe", [(1, "big", "wardrobe"), (1, "small", "wardrobe")]),
        ("a round and a square table", [(1, "", "round table"), (1, "", "dining table")]),
        ("a round table and a square one", [(1, "", "round table"), (1, "square", "dining table")]),
        ("a single and a double bed", [(1, "", "single bed"), (1, "", "bed")]),
        ("a light and a table", [(1, "", "ceiling lamp"), (1, "", "dining table")]),
        ("a black and white rug", [(1, "black and white", "rug")]),
    ],
)
def test_adjectives_that_share_a_noun_are_each_of_a_thing_of_its_own(text: str, said: Told) -> None:
    assert told(text) == said


def test_measures_that_share_a_noun_are_each_of_a_thing_of_its_own() -> None:
    things = read("a 90 cm wide and a 160 cm wide desk").parsed.things
    assert [[size.values for size in thing.sizes] for thing in things] == [[(0.9,)], [(1.6,)]]


@pytest.mark.parametrize(
    ("text", "index"),
    [
        ("a red chair and a blue chair. The red chair is by the window.", 0),
        ("a red and a blue chair. The red one is by the window.", 0),
        ("a tall lamp and a lamp. The tall lamp is by the window.", 0),
        ("a large desk. The small desk is by the window.", 1),
    ],
)
def test_what_is_named_again_is_what_looks_as_it_is_said(text: str, index: int) -> None:
    parsed = read(text).parsed
    assert [parsed.things.index(subject.thing) for subject in parsed.links[0].subjects] == [index]


def test_what_a_relation_leads_to_is_another_thing_where_its_look_excludes_the_first() -> None:
    (link,) = read("a rug between a red chair and a blue chair").parsed.links
    assert [item.thing.look for item in link.objects if isinstance(item, Mention)] == [("red",), ("blue",)]
