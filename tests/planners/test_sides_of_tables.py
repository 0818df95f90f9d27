"""Seats at the sides of a table stand in equal shares where they are asked for, counted from the poses alone."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace

import pytest
from said_rooms import at_sides, made, of

import robolayout as rl
from robolayout.words import read_words
from running import slow

EIGHT = "a meeting room with a table with eight chairs, four on each side"


@pytest.mark.parametrize(
    ("text", "kinds", "longer", "ends"),
    [
        slow("a conference room with a table for twelve, six chairs on each side", "office_chair", [6, 6], [0, 0]),
        (
            "a dining room with a long table, three chairs on each long side and one at each end",
            "chair",
            [3, 3],
            [1, 1],
        ),
        ("a meeting room with a long table and four chairs on either side", "office_chair", [4, 4], [0, 0]),
        ("a dining room with a square table with one chair on each side", "chair", [1, 1], [1, 1]),
        (
            "a dining room with a long table, a bench on each side of it and a chair at each end",
            "bench",
            [1, 1],
            [0, 0],
        ),
        ("a dining room with a table with six chairs, two on each side and two at the ends", "chair", [2, 2], [1, 1]),
        (
            "a dining room with a table. Three chairs on each side of the table and one at the head",
            "chair",
            [3, 3],
            [0, 1],
        ),
        ("a kitchen with an island, two stools on each side of it", "bar_stool", [2, 2], [0, 0]),
    ],
)
def test_seats_stand_at_the_sides_that_are_told(text: str, kinds: str, longer: list[int], ends: list[int]) -> None:
    result = made(text)
    (table,) = (name for name in result.layout if name.rsplit("-", 1)[0].endswith(("table", "island")))
    depth, width, _ = result.scene.by_name[table].size
    counts = Counter(at_sides(result, kinds, table))
    pairs = [sorted(counts[side] for side in pair) for pair in (("front", "back"), ("left", "right"))]
    assert (pairs if width >= depth else pairs[::-1]) == [longer, ends]
    assert all(row.verdict != "unmet" for row in result.report.asked)


def test_each_of_three_tables_has_five_chairs_on_each_side() -> None:
    scene, _ = rl.scene_from_sentence("a refectory with three long tables, five chairs on each side of every table")
    assert sum(asset.category == "chair" for asset in scene.assets) == 30


def test_seats_at_the_ends_are_not_on_each_side() -> None:
    result = made(EIGHT)
    (table,), chair = of(result, "conference_table"), of(result, "office_chair")[0]
    here, out = result.layout[table], result.scene.by_name[table].size[1] / 2 + 0.3
    x, y = here.x - out * math.sin(here.yaw), here.y + out * math.cos(here.yaw)
    moved = replace(result.layout[chair], x=x, y=y, yaw=here.yaw - math.pi / 2)
    layout = rl.Layout({**result.layout, chair: moved})
    for there, verdict in ((result.layout, "met"), (layout, "unmet")):
        (row,) = (row for row in read_words(result.scene).judged(result.scene, there) if "each side" in row.words)
        assert row.verdict == verdict


def test_what_a_table_with_chairs_at_its_ends_has_is_on_the_table() -> None:
    text = (
        "a dining room with a table with three chairs on each long side and one at each end, with a vase in the middle"
    )
    result = made(text)
    (vase,), (table,) = of(result, "vase"), of(result, "dining_table")
    assert math.dist(result.layout[vase].at, result.layout[table].at) < 0.6


@pytest.mark.parametrize(
    ("text", "count"),
    [("a bedroom with no windows", 0), ("a windowless office", 0), ("an office with three windows", 3)],
)
def test_so_many_windows_as_are_told(text: str, count: int) -> None:
    scene, _ = rl.scene_from_sentence(text)
    assert len(scene.room.windows) == count
    (row,) = (row for row in read_words(scene).judged(scene, rl.Layout({})) if row.kind == "opening")
    assert row.verdict == "met"


@pytest.mark.parametrize(
    ("text", "words", "understood"),
    [
        (
            "a bedroom with a desk between 50 and 80 cm from the bed",
            "desk between 50",
            "desk-0 0.5 to 0.8 m from bed-0",
        ),
        ("a bedroom with a bed 1 to 2 m from the window", "bed 1 to 2 m", "bed-0 1 to 2 m from"),
        ("a living room with a sofa 50 cm off the wall", "sofa 50 cm off", "sofa-0 0.5 to 0.65 m from"),
        ("a living room with two armchairs 1 m from each other", "1 m from each other", "armchair-0 1 to 1.3 m from"),
        (
            "a laundry room with a dryer, a washing machine and a sink to their right",
            "sink to their right",
            "right_of(washbasin-0",
        ),
        (
            "a bathroom with a vanity with a mirror above it, opposite the door",
            "opposite door",
            "point_towards(bathroom_vanity-0",
        ),
        (
            "a reading nook with an armchair, a side table within reach and a floor lamp behind",
            "behind",
            "floor_lamp-0, armchair-0",
        ),
        (
            "a music room with a stool and a music stand 1 m from the stool",
            "music stand 1 m",
            "music_stand-0 1 to 1.3 m",
        ),
    ],
)
def test_what_is_said_of_metres_and_sides_is_read(text: str, words: str, understood: str) -> None:
    scene, _ = rl.scene_from_sentence(text)
    (row,) = (row for row in read_words(scene).rows if row.kind == "relation" and words in row.words)
    assert understood in row.understanding


def test_metres_of_height_are_given_back() -> None:
    scene, _ = rl.scene_from_sentence("a living room with a lamp hanging 1 m above the coffee table")
    rows = [(row.kind, row.words) for row in read_words(scene).rows]
    assert ("not understood", "1 m") in rows and ("relation", "lamp above coffee table") in rows


def test_what_is_had_after_a_comma_and_stands_elsewhere_is_not_at_what_has_it() -> None:
    scene, _ = rl.scene_from_sentence(
        "a bathroom where the toilet is by the wall, with a double vanity opposite the shower"
    )
    relations = [row.understanding for row in read_words(scene).rows if row.kind == "relation"]
    assert any("bathroom_vanity-0, shower-0" in said for said in relations)
    assert not any("bathroom_vanity-0, toilet-0" in said for said in relations)


@pytest.mark.slow
def test_chairs_all_at_one_side_are_not_around_a_table() -> None:
    result = made("a dining room of 6 x 6 m with a table with six chairs around it")
    (table,), chairs = of(result, "dining_table"), of(result, "chair")
    here, (depth, width, _) = result.layout[table], result.scene.by_name[table].size
    c, sin = math.cos(here.yaw), math.sin(here.yaw)
    moved = {
        name: replace(
            result.layout[name], x=here.x + out * c - v * sin, y=here.y + out * sin + v * c, yaw=here.yaw + math.pi
        )
        for out, v, name in ((depth / 2 + 0.3, width * (i - 2.5) / 30, name) for i, name in enumerate(chairs))
    }
    for there, verdict in ((result.layout, "met"), (rl.Layout({**result.layout, **moved}), "unmet")):
        (row,) = (row for row in read_words(result.scene).judged(result.scene, there) if "around" in row.words)
        assert row.verdict == verdict


def test_a_table_by_a_window_leaves_room_for_the_chairs_around_it() -> None:
    result = made("a dining room with a table by the window and eight chairs around it")
    assert result.report.ok
    assert [row.verdict for row in result.report.asked if row.kind == "relation"] == ["met", "met"]
    ((wall, window),) = ((result.scene.room.walls[w.wall], w) for w in result.scene.room.windows)
    (table,) = of(result, "dining_table")
    middle = wall.point(window.offset + window.width / 2)
    assert math.dist(middle, result.layout[table].at) < 1.2 + result.scene.by_name[table].size[1] / 2
