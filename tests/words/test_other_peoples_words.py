"""What others said in words of their own: semicircles around things, lamps over bars, what is refused, the latter, things on rugs."""

from __future__ import annotations

from collections import Counter

import pytest

import robolayout as rl
from robolayout.assets import category_of
from robolayout.planners.sentence import scene_from_sentence
from robolayout.words import read_words


@pytest.mark.parametrize(
    ("text", "words", "understood"),
    [
        ("an art studio with three easels forming a semicircle around a platform", "semicircle", "half circle"),
        ("a music room with six chairs in a semicircle around a piano", "semicircle", "half circle"),
        ("a playroom with a toy shelf against the wall, flanked by a bean bag and a dollhouse", "flanked", "next_to"),
        (
            "a dining room where five plates are set on the table, along with a vase in the center",
            "along with",
            "on_top_of(vase-0, dining_table-0), centered_on(vase-0, dining_table-0)",
        ),
        ("a bathroom with a bathtub and a bath mat in front of the latter", "bath mat", "in_front_of(bath_mat-0, bathtub-0"),
        (
            "a bathroom with a toilet and a sink; a bath mat is in front of the former",
            "bath mat",
            "in_front_of(bath_mat-0, toilet-0",
        ),
        (
            "a nursery with a round rug in the middle and a toy box on the rug",
            "toy box on",
            "under(round_rug-0, [toy_box-0]), distance_constraint(toy_box-0, round_rug-0",
        ),
        ("a warehouse. A pallet jack waits in the corner", "pallet jack", "corner(pallet_jack-0"),
        ("a living room. A tall plant marks the southwest corner", "plant", "corner(plant-0, 0)"),
        ("a living room. Dominating the north wall is a bookshelf", "bookshelf", "against_wall(bookshelf-0, walls[2])"),
        ("a living room where a sofa faces a TV stand across a coffee table", "across", "coffee_table-0 between sofa-0 and"),
        ("a living room with two sofas facing each other, a coffee table in between", "between", "between sofa-0 and sofa-1"),
        ("a nursery with a round rug; a teddy bear sits on the rug", "teddy", "distance_constraint(teddy_bear-0, round_rug-0"),
    ],
)  # fmt: skip
def test_it_is_read_as_it_is_meant(text: str, words: str, understood: str) -> None:
    found = read_words(scene_from_sentence(text)[0]).rows
    assert any(understood in row.understanding for row in found if words in row.words), found
    assert not [row.words for row in found if row.kind == "not understood"]


def test_a_sofa_on_a_rug_has_only_its_legs_on_it_and_several_make_a_ring() -> None:
    for text in (
        "a living room with a sofa on a rug in the middle of the room",
        "a playroom with a rug in the middle and four bean bags on it",
    ):
        on = [
            row.understanding for row in read_words(scene_from_sentence(text)[0]).rows if "under(" in row.understanding
        ]
        assert on and not any("distance_constraint" in said for said in on)


def test_no_chairs_means_no_office_chair_either() -> None:
    scene = scene_from_sentence("an office with a desk. No chairs, please.")[0]
    there = Counter(category_of(asset).name for asset in scene.assets)
    assert there["desk"] == 1 and not [kind for kind in there if kind.endswith("chair")]
    with_one = scene_from_sentence("an office with a desk and an armchair, but no chairs")[0]
    assert Counter(category_of(asset).name for asset in with_one.assets)["armchair"] == 1


def test_lamps_that_are_asked_over_a_bar_hang_over_none_of_the_tables() -> None:
    result = rl.generate(
        "a restaurant with a bar along the east wall and two tables. Two pendant lights hang above the bar."
    )
    assert result.report.ok, result.report.violations
    lamps = [asset.name for asset in result.scene.assets if category_of(asset).name == "pendant lamp"]
    assert len(lamps) == 2
    assert not [line for line in result.program.text.splitlines() if "ceiling_above(pendant_lamp" in line]


@pytest.mark.parametrize("seed", [0, 1])
def test_what_stands_on_a_rug_in_the_middle_is_brought_there(seed: int) -> None:
    text = "a nursery with a round rug in the middle; a toy box and a rocking chair stand on the rug, a crib is at the wall"
    result = rl.generate(text, seed=seed)
    assert result.report.ok, result.report.violations
    rug = result.layout["round_rug-0"]
    across = result.scene.by_name["round_rug-0"].size[0]
    for name in ("toy_box-0", "rocking_chair-0"):
        pose = result.layout[name]
        assert (pose.x - rug.x) ** 2 + (pose.y - rug.y) ** 2 <= (across / 2 + 0.05) ** 2
