"""Words that no list has: by their class they are verbs, adjectives or nouns, and say where things are, or nothing."""

from __future__ import annotations

import pytest

from robolayout.planners.sentence import scene_from_sentence
from robolayout.words import AskedRow, read_words
from robolayout.words._speech import classes


def _rows(text: str) -> list[tuple[str, str, str]]:
    scene, _ = scene_from_sentence(text)
    return [(row.kind, row.words, row.understanding) for row in read_words(scene).rows]


def _kinds(text: str) -> dict[str, int]:
    scene, _ = scene_from_sentence(text)
    counts: dict[str, int] = {}
    for asset in scene.assets:
        counts[asset.category] = counts.get(asset.category, 0) + 1
    return counts


def test_words_have_their_classes() -> None:
    words = ["the", "robot", "wanders", "through", "a", "gleaming", "lobby", "."]
    assert classes(words)[2:6] == ["does", "placing", "noun", "adjective"]
    assert classes([]) == [] and len(classes(["a" * 5000, "b"])) == 2


@pytest.mark.parametrize(
    ("text", "relation"),
    [
        ("An office. A potted palm softens each of the two northern corners.", "corner(plant-0, 2); corner(plant-1, 3)"),
        ("A kitchen. A generous island, topped with honed oak, anchors the center of the room.", "distance_constraint(kitchen_island-0"),
        ("A kitchen. The counter brightens the north wall and carries a coffee maker.", "on_top_of(coffee_machine-0, kitchen_counter-0)"),
        ("A living room. A sofa, lit by a floor lamp, dominates the west wall.", "near(floor_lamp-0, sofa-0"),
        ("A library. The corner shelters a leather armchair.", "corner(armchair-0"),
        ("A shop. Customers wait on a sofa near the door.", "near(sofa-0"),
        ("A clinic. The desk is oriented toward the door.", "point_towards(desk-0"),
        ("A yoga studio. Twelve yoga mats are unrolled in three orderly rows.", "in_rows(["),
        ("A bathroom with a mirror, its lower edge 1.2 m from the floor.", "mounted_on(mirror-0, height=1.65)"),
        ("Against the longest wall of the library stand five bookcases.", "against_wall(bookshelf-0"),
        ("A bedroom for twins. They each get a bed. Beside each bed is a nightstand.", "near(night_stand-1, single_bed-1"),
        ("A kitchen. Leave one meter of clear floor between the island and the sink.", "kitchen_island-0 1 to 1.3 m from"),
    ],
)  # fmt: skip
def test_what_an_unknown_verb_says_of_where_things_are(text: str, relation: str) -> None:
    rows = _rows(text)
    assert any(kind == "relation" and relation in understood for kind, _, understood in rows), rows
    assert not [row for row in rows if row[0] == "not understood"]


@pytest.mark.parametrize(
    "text",
    [
        "A bedroom with a bed. My daughter loves to chew gum.",
        "A dining room with a table. Every Sunday the whole family eats at my place.",
        "A nursery with a crib. I don't trust the old window.",
        "For our fetch-and-carry trials we need a kitchen with a table.",
        "Now that I'm eighty-three I need a sitting room with a sofa.",
        "A bedroom with a desk at the window because I read all day.",
        "A podcast studio of 5 by 4 meters, its walls wrapped in charcoal felt.",
        "A living room with a sofa, dressed in linen and weathered teak, lit from within.",
    ],
)
def test_what_asks_nothing_of_a_room_is_no_thing_and_no_demand(text: str) -> None:
    rows = _rows(text)
    assert not [row for row in rows if row[0] == "not understood"], rows
    assert not any("unknown furniture" in understood for _, _, understood in rows)


def test_what_somebody_does_puts_no_box_into_the_room() -> None:
    assert _kinds("A bedroom. The whole family eats here and my daughter loves it.").keys() <= _kinds(
        "A bedroom."
    ).keys() | {"armchair"}


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("A bed. Hang the lamp symmetrically.", "symmetrically"),
        ("A bed and a desk. A lamp stands where the desk meets the bed.", "meets"),
        ("A table with gizmos on it.", "gizmos"),
        ("Everything in this bedroom is easily accessible.", "accessible"),
    ],
)
def test_what_may_ask_for_something_is_still_given_back(text: str, words: str) -> None:
    assert any(kind == "not understood" and words in said for kind, said, _ in _rows(text))


def test_an_aside_is_a_row_that_is_not_judged() -> None:
    scene, _ = scene_from_sentence("A bedroom with a bed, which they chew.")
    rows: list[AskedRow] = [
        row for row in read_words(scene).rows if row.understanding == "nothing that is asked of a room"
    ]  # type: ignore[misc]
    assert [row.words for row in rows] == ["which they chew"]
