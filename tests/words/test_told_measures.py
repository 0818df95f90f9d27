"""Sizes, distances and exact places that a text tells: whose they are, and what they ask for."""

from __future__ import annotations

from collections import Counter

import pytest

from robolayout.planners.sentence import scene_from_sentence
from robolayout.words import read_words


def _said(text: str) -> str:
    """Return how the relations of a text are understood."""
    scene, _ = scene_from_sentence(text)
    return " | ".join(row.understanding for row in read_words(scene).rows)


@pytest.mark.parametrize(
    ("text", "name", "size"),
    [
        ("My bedroom is a 4.2 m by 3.8 m room. Her bed, 90 by 200 cm, stands in the corner.", "bed-0", (2.0, 0.9)),
        (
            "In a music room an upright piano, 1.5 m wide and 60 cm deep, stands against the wall. The music room is 4.5 by 4 m.",
            "piano-0",
            (0.6, 1.5),
        ),
        ("A dining room with a table for 4, 1.4 m x 0.8 m, in the middle.", "dining_table-0", (0.8, 1.4)),
        ("A dining room with a round table, 1.4 m in diameter, and four chairs.", "round_table-0", (1.4, 1.4)),
        ("A dining room. A credenza, 0.5 m deep, stands by the wall.", "sideboard-0", (0.5, None)),
        ("A conference room with an oval table, 3 m long, and ten chairs.", "round_table-0", (None, 3.0)),
    ],
)
def test_a_size_after_a_comma_is_that_of_the_thing(text: str, name: str, size: tuple[float | None, ...]) -> None:
    """Such a size was taken for that of the room, which could then not be furnished, or was not understood."""
    scene, _ = scene_from_sentence(text)
    given = [(a, b) for a, b in zip(scene.by_name[name].size, size, strict=False) if b is not None]
    assert all(a == b for a, b in given), scene.by_name[name].size
    assert not [row for row in read_words(scene).rows if row.kind == "not understood"]


def test_all_of_several_things_have_a_height_and_not_the_room() -> None:
    scene, _ = scene_from_sentence("A study with three bookcases, all of them 2 m tall.")
    assert scene.room.wall_height > 2.0
    assert {asset.size[2] for asset in scene.assets if asset.category == "bookshelf"} == {2.0}


@pytest.mark.parametrize(
    ("text", "sides"),
    [
        ("A bedroom, 4 by 3 m, with a bed.", (4.0, 3.0)),
        ("A living room with a sofa, 5 x 4 m.", (5.0, 4.0)),
        ("A bedroom with a bed, 4 x 3 m, two windows and a rug.", (4.0, 3.0)),
    ],
)
def test_a_size_that_can_only_be_the_rooms_stays_the_rooms(text: str, sides: tuple[float, float]) -> None:
    scene, _ = scene_from_sentence(text)
    x0, y0, x1, y1 = scene.room.bounds
    assert sorted((round(x1 - x0, 2), round(y1 - y0, 2))) == sorted(sides)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        (
            "a living room where a sofa faces a TV stand from a distance of about 2.5 m",
            "sofa-0 2.5 to 2.8 m from tv_stand-0",
        ),
        ("A table is in the middle. Facing the table, at 1 m distance, stands a tripod.", "tripod-0 1 to 1.3 m from"),
        (
            "A living room with a sofa and a TV. Between the sofa and the TV I want about 2.5 m.",
            "sofa-0 2.5 to 2.8 m from television-0",
        ),
        ("a living room with a sofa at a distance of 3 m from the TV", "sofa-0 3 to 3.3 m from television-0"),
        (
            "a salon with three styling chairs in a row, each facing its own mirror on the west wall, 1.2 m apart",
            "in_rows([salon_chair-0, salon_chair-1, salon_chair-2], aisle=0, gap=1.2, 1)",
        ),
        ("a room with two armchairs facing each other 1.5 m apart", "facing_pair(armchair-1, armchair-0)"),
        ("a bathroom with a toilet and a turning circle of 1.5 m in the middle", "a free disc of 1.5 m there"),
        ("a studio with a microphone in the exact center of the room", "max_distance=0.2)"),
        (
            "a classroom with twelve desks in three rows of four, each with a chair behind it",
            "in_front_of(chair-0, student_desk-0, min_gap=-0.6, max_gap=1.2)",
        ),
        (
            "a hotel room with two beds and a nightstand between the beds",
            "night_stand-0 between bed-0 and bed-1; against_wall(night_stand-0)",
        ),
    ],
)
def test_distances_are_asked_of_what_they_are_said_of(text: str, meant: str) -> None:
    assert meant in _said(text)


def test_as_far_as_possible_is_farther_than_far() -> None:
    """Half of the room's diagonal, less half of the thing's own, can always be met; two metres were enough."""
    near, far = (
        next(
            one.min_distance
            for row in read_words(scene_from_sentence(f"a 5 x 4 m bedroom with a bed and a litter box {how}")[0]).rows
            for one in row.said
            if one.name == "distance_constraint"
        )
        for how in ("far from the bed", "as far from the bed as possible")
    )
    assert near == 2.0
    assert far > 2.8


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        (
            "a workshop with a workbench and a vise at one end of the workbench",
            "toward(vise-0, workbench-0, left, off=",
        ),
        ("a workshop with a workbench with a vise on its left end", "toward(vise-0, workbench-0, right, off="),
        (
            "a study with a desk. A laptop stands at its left end and a lamp at its right end.",
            "toward(table_lamp-0, desk-0, left, off=",
        ),
        (
            "a dining room with a table and candles at both ends of the table",
            "toward(candle-0, dining_table-0, right, off=",
        ),
        ("a dining room with a TV on the wall at one end of the table", "left_of(television-0, dining_table-0"),
        ("a kitchen with a counter and a fridge at the end of the counter", "next_to(fridge-0, kitchen_counter-0"),
    ],
)
def test_what_is_at_an_end_of_a_top_is_in_its_outer_third(text: str, meant: str) -> None:
    """In the middle of the top was as good."""
    assert meant in _said(text)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("a waiting room with six chairs. A clock hangs above the door.", "max_distance=0.1)"),
        (
            "a studio. Four acoustic panels are evenly spaced along the west wall.",
            "in_rows([acoustic_panel-0, acoustic_panel-1",
        ),
        (
            "a nursery with a crib. A dresser is against the wall opposite the crib.",
            "against_wall(crib-0, walls[0]), against_wall",
        ),
        (
            "a bathroom with a vanity on the east wall. A bathtub occupies the wall opposite.",
            "against_wall(bathtub-0, walls[",
        ),
        (
            "a kitchen with a table and a bowl of three apples on it",
            "on_top_of(fruit-0, bowl-0); on_top_of(fruit-1, bowl-0)",
        ),
        ("a kitchen with a table and a bowl of three apples on it", "on_top_of(bowl-0, dining_table-0)"),
        ("a nursery with a table and a box of crayons on the table", "on_top_of(pen-0, storage_box-0)"),
    ],
)
def test_things_hang_and_lie_where_they_are_said_to(text: str, meant: str) -> None:
    assert meant in _said(text)


def test_what_is_in_a_vase_or_a_jar_stands_nowhere_else() -> None:
    text = "A living room with a coffee table with jars of brushes. A vase with orchids stands on the coffee table."
    scene, _ = scene_from_sentence(text)
    there = Counter(asset.category for asset in scene.assets)
    assert there["vase"] == 1
    assert there["brush"] == there["potted plant"] == 0


def test_seats_on_each_side_are_those_of_each_table() -> None:
    scene, _ = scene_from_sentence("a dining hall with two long tables, each with six chairs, three on each side")
    rows = [row for row in read_words(scene).rows if row.kind == "relation"]
    seats = {one.asset_names()[0] for row in rows for one in row.said if one.name in ("in_front_of", "behind")}
    assert len(seats) == 12
