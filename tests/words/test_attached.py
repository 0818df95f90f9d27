"""What a clause, a list, "each", "it" and "the other" belong to."""

from __future__ import annotations

from collections import Counter

import pytest

from robolayout.planners.sentence import scene_from_sentence
from robolayout.words import read_words


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (
            "An office with six workstations. Each workstation consists of a desk, an office chair and a monitor.",
            {"desk": 6, "office chair": 6, "monitor": 6},
        ),
        ("A library where two reading tables are each accompanied by six chairs", {"chair": 12}),
        ("A bedroom with two beds. At the foot of each bed stands a desk with a chair.", {"desk": 2, "chair": 2}),
        ("A bedroom with two beds and a nightstand with a lamp next to each bed", {"night stand": 2, "table lamp": 2}),
        (
            "A bedroom with two beds and next to each bed a nightstand with a lamp, and a wardrobe",
            {"table lamp": 2, "wardrobe": 1},
        ),
        ("An office with one desk under the window and another by the door, each with a chair", {"office chair": 2}),
        (
            "A bathroom with a double vanity with two sinks, over each of which a round mirror is hung",
            {"bathroom vanity": 2, "mirror": 2},
        ),
        ("A waiting room. One armchair is by the door, the other by the window.", {"armchair": 2}),
        ("A waiting room with two chairs, one chair by the door, the other by the window", {"chair": 2}),
        (
            "A room with a table for four. Two of the chairs are at the table and the remaining two by the window.",
            {"chair": 4},
        ),
        (
            "A nursery with a rug. Toys lie on the rug: three blocks, a ball and a teddy bear.",
            {"toy": 3, "ball": 1, "teddy bear": 1},
        ),
        ("I want to see the TV from the bed. Put a double bed against the wall.", {"bed": 1}),
    ],
)
def test_as_many_are_there_as_are_told(text: str, count: dict[str, int]) -> None:
    """What each of some things has was there once, the other one not at all, and what was told again twice."""
    scene, _ = scene_from_sentence(text)
    there = Counter(asset.category for asset in scene.assets)
    assert {kind: there[kind] for kind in count} == count


@pytest.mark.parametrize(
    ("text", "meant", "never"),
    [
        ("A sofa faces the TV, which hangs on the east wall.", "mounted_on(television-0, walls[1])", "wall(sofa"),
        ("Two armchairs are next to a table, which face the window.", "point_towards(armchair-0", "towards(coffee"),
        (
            "A sofa against the south wall facing a TV stand on the north wall",
            "against_wall(tv_stand-0, walls[2])",
            "against_wall(sofa-0, walls[2])",
        ),
        (
            "A sofa along the south wall, facing a TV stand on the opposite wall",
            "against_wall(tv_stand-0, walls[2])",
            "against_wall(sofa-0, walls[2])",
        ),
        (
            "A shop with a counter holding a bottle of detergent and a box",
            "on_top_of(storage_box-0, checkout_counter-0)",
            "not understood",
        ),
        (
            "A small desk holding two monitors, a keyboard and a mouse is located against the south wall.",
            "against_wall(desk-0, walls[0])",
            "wall(computer_mouse",
        ),
        (
            "A cafe with a counter displaying a cash register, a coffee machine, and a pastry case from left to right",
            "on_top_of(coffee_machine-0, bar_counter-0)",
            "zone",
        ),
        (
            "A kitchen. Along the wall run the counter, the oven and the dishwasher, from left to right.",
            "next_to(dishwasher-0, oven-0, left",
            "zone",
        ),
        (
            "A kitchen. Along the north wall, from right to left: a fridge and a stove.",
            "next_to(stove-0, fridge-0, right",
            "zone",
        ),
        (
            "A floor lamp stands to the left of the sofa, and a painting hangs above it.",
            "above(picture-0, sofa-0)",
            "above(picture-0, floor_lamp",
        ),
        (
            "A sideboard rests against the east wall, on which a vase of flowers stands between two candlesticks.",
            "vase-0 between candlestick-0 and candlestick-1",
            "sideboard-0 between",
        ),
        (
            "A workbench with a toolbox in the middle. The wall is lined with two shelving units, between which a pegboard is hung.",
            "pegboard-0 between shelving_unit-0 and shelving_unit-1",
            "and workbench-0",
        ),
        (
            "A workshop. Along the north wall I want two shelves, and a workbench with a stool against the east wall.",
            "against_wall(workbench-0, walls[1])",
            "against_wall(workbench-0, walls[2])",
        ),
        (
            "An office with a desk. Behind the desk there should be a bookcase, and the printer can go on a small cabinet.",
            "on_top_of(printer-0, cabinet-0)",
            "(printer-0, desk-0",
        ),
        (
            "A kitchen with a low cupboard for the coffee machine under the window",
            "on_top_of(coffee_machine-0, cabinet-0)",
            "near(coffee_machine",
        ),
        (
            "A waiting room with two armchairs. There is a low table with magazines in front of them.",
            "in_front_of(low_table-0, armchair-0",
            "in_front_of(magazine",
        ),
        (
            "In front of the sofa there are two coffee tables: one is round and has a bowl on it, the other is square.",
            "in_front_of(coffee_table-1, sofa-0",
            "not understood",
        ),
        (
            "A table. Four chairs: two on the north side of the table and two on the south side.",
            "in_front_of(chair-2, dining_table-0",
            "near(chair-2",
        ),
        (
            "A waiting room. One armchair is in the corner to the left of the door, the other in the corner to the right.",
            "against_wall(armchair-1, walls[",
            "right side",
        ),
        ("A bedroom with a bed. I'd rather not have it opposite the door.", "align_with(bed-0", "point_towards(bed-0"),
    ],
)
def test_clauses_are_about_what_they_belong_to(text: str, meant: str, never: str) -> None:
    """They were about the subject of the sentence, the last of a list or what was named last, whichever was wrong."""
    scene, _ = scene_from_sentence(text)
    rows = "; ".join(f"{row.kind}: {row.words}: {row.understanding}" for row in read_words(scene).rows)
    assert meant in rows
    assert never not in rows
