"""Parts of a room by what one does there, and further rooms on its floor: what stands there, and where, measured on poses."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import replace

import pytest
from said_rooms import made, of
from shapely import Point, Polygon

import robolayout as rl
from robolayout.run.result import Result
from robolayout.words import read_words
from running import slow


def there(text: str) -> Counter[str]:
    scene, _ = rl.scene_from_sentence(text)
    return Counter(asset.name.rsplit("-", 1)[0] for asset in scene.assets)


def away(result: Result, name: str, point: tuple[float, float]) -> float:
    """Return metres from the middle of a thing to a point."""
    return math.dist(result.layout[name].at, point)


def windows(result: Result) -> list[tuple[float, float]]:
    room = result.scene.room
    return [room.walls[window.wall].point(window.center) for window in room.windows]


@pytest.mark.parametrize(
    ("text", "things"),
    [
        ("a bedroom with a sitting area", {"armchair": 2, "side_table": 1}),
        ("a bedroom with a gaming corner", {"desk": 1, "office_chair": 1, "monitor": 2}),
        ("a bedroom with a vanity area", {"vanity_table": 1, "stool": 1}),
        ("a living room with a home office corner", {"desk": 1, "office_chair": 1, "monitor": 1}),
        ("an office with a meeting area and two desks", {"desk": 2, "round_table": 1}),
        ("an office with a reception area", {"desk": 1, "reception_desk": 1, "office_chair": 2}),
        ("a cafe with a waiting area", {"bench": 1, "chair": 8, "round_table": 4}),
        ("a library with a reading area", {"bookshelf": 8, "armchair": 2}),
        ("a bedroom with a dining area", {"bed": 1, "dining_table": 1, "chair": 4}),  # four single beds
        ("a bedroom and office", {"bed": 1, "desk": 1, "office_chair": 1}),
        ("a living room with a kitchen", {"kitchen_counter": 2, "kitchen_sink": 1, "stove": 1, "range_hood": 1}),
        ("a play area with a rug and two bean bags", {"bean_bag": 2, "rug": 1}),
        ("a reading nook with an armchair", {"armchair": 1}),
        ("a living room with two sitting areas", {"armchair": 4, "side_table": 2}),
        ("a bedroom with no sitting area", {"armchair": 0, "side_table": 0}),
        ("an office without a meeting area", {"round_table": 0, "stool": 0}),
        ("a living room with no dining area", {"dining_table": 0}),
        ("a sitting area but no side table", {"armchair": 2, "side_table": 0}),
        ("a room with a desk by the window and a work area by the door", {"desk": 2}),
        ("a bar area with three stools", {"bar_counter": 1, "bar_stool": 3}),
        ("a piano in the music corner", {"piano": 1, "digital_piano": 0}),
        ("a living room with a sofa and a dining area", {"dining_table": 1, "chair": 4}),
        ("a living room with a side table and a play area", {"kids_table": 1}),
    ],
)
def test_what_belongs_in_a_part_of_a_room_is_there_besides_what_is_usual(text: str, things: dict[str, int]) -> None:
    found = there(text)
    assert {kind: found[kind] for kind in things} == things


def test_what_is_said_to_be_in_a_part_of_a_room_is_all_that_it_has() -> None:
    found = there("an office with a lounge area with two beanbags")
    assert (found["bean_bag"], found["sofa"], found["armchair"]) == (2, 0, 0)


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        slow("a bedroom with a sitting area by the window", "armchair"),
        ("a living room with a reading nook by the window", "armchair"),
        ("a bedroom with a workspace by the window", "desk"),
        slow("a living room with a dining area by the window", "dining_table"),
    ],
)
def test_a_part_of_a_room_is_at_its_window(text: str, kind: str) -> None:
    result = made(text)
    assert result.report.ok
    for name in of(result, kind)[: 2 if "sitting" in text else 1]:
        depth = max(result.scene.by_name[name].size[:2])
        assert min(away(result, name, window) for window in windows(result)) < 0.95 + depth / 2
    assert not [row for row in result.report.asked if row.verdict in ("unmet", "not understood")]


@pytest.mark.slow
def test_all_of_a_kitchen_is_in_its_half_of_the_room() -> None:
    result = made("a living room with an open kitchen at the back")
    _, y0, _, y1 = result.scene.room.bounds
    kitchen = [name for kind in ("kitchen_counter", "kitchen_sink", "stove", "fridge") for name in of(result, kind)]
    assert len(kitchen) == 5
    assert all(result.layout[name].y > (y0 + y1) / 2 for name in kitchen)


@pytest.mark.slow
def test_a_kitchen_along_a_wall_is_at_that_wall() -> None:
    result = made("a living room with an open kitchen along the left wall")
    x0 = result.scene.room.bounds[0]
    for kind in ("kitchen_counter", "kitchen_sink", "stove", "fridge"):
        for name in of(result, kind):
            assert result.layout[name].x - x0 < 0.1 + result.scene.by_name[name].size[0] / 2


@pytest.mark.slow
def test_a_relation_leads_to_what_stands_for_a_part_of_the_room() -> None:
    result = made("a studio with a dining area near the kitchen")
    (table,), (sink,) = of(result, "dining_table"), of(result, "kitchen_sink")
    reach = sum(max(result.scene.by_name[name].size[:2]) for name in (table, sink)) / 2
    assert away(result, table, result.layout[sink].at) < 1.2 + reach


@pytest.mark.slow
def test_what_a_later_sentence_puts_there_stands_for_it() -> None:
    scene, _ = rl.scene_from_sentence(
        "An office with two desks. A screen is next to the meeting area. The meeting area has a long table with six chairs."
    )
    kinds = Counter(asset.name.rsplit("-", 1)[0] for asset in scene.assets)
    assert kinds["round_table"] == 0
    rows = {
        row.understanding.split("(")[0]: row.words for row in rl.generate(scene).report.asked if row.kind == "relation"
    }
    assert "table" in rows["near"]


@pytest.mark.slow
@pytest.mark.parametrize("kinds", [("desk", "desk"), slow(("armchair", "side_table"))])
def test_several_in_the_corner_are_in_one_corner(kinds: tuple[str, str]) -> None:
    words = "two desks" if kinds[0] == kinds[1] else "an armchair and a side table"
    result = made(f"a room with {words} in the corner")
    names = [*of(result, kinds[0]), *of(result, kinds[1])][:2]
    one, two = (Polygon(result.layout[name].corners(result.scene.by_name[name].size)) for name in names)
    corner = min(result.scene.room.vertices, key=lambda vertex: Point(vertex).distance(one.union(two)))
    assert Point(corner).distance(one.union(two)) < 0.5 and one.distance(two) < 0.65


@pytest.mark.slow
def test_each_half_has_what_is_done_there() -> None:
    result = made("the left side is the sleeping area and the right side is the living area")
    x0, _, x1, _ = result.scene.room.bounds
    middle = (x0 + x1) / 2
    assert result.layout["bed-0"].x < middle < result.layout["sofa-0"].x
    assert result.layout["coffee_table-0"].x > middle


@pytest.mark.parametrize(
    ("text", "things", "lost"),
    [
        ("a living room divided into a sitting area and a dining area", {"armchair": 2, "dining_table": 1}, False),
        ("a bedroom with a treatment area", {}, True),
        ("a classroom with a reading rug area", {}, True),
    ],
)
def test_a_part_of_which_nothing_is_known_is_given_back(text: str, things: dict[str, int], lost: bool) -> None:
    scene, _ = rl.scene_from_sentence(text)
    found = Counter(asset.name.rsplit("-", 1)[0] for asset in scene.assets)
    assert {kind: found[kind] for kind in things} == things
    assert any(row.kind == "not understood" for row in read_words(scene).rows) == lost


def test_two_parts_stand_each_at_its_own_place() -> None:
    result = made("an office with a gaming area in the left corner and a work area in the right corner")
    x0, _, x1, _ = result.scene.room.bounds
    left, right = sorted(result.layout[name].x for name in of(result, "desk"))
    assert left < x0 + 1.2 and right > x1 - 1.2 and result.report.ok


def test_a_part_of_a_room_is_so_many_metres_from_a_window() -> None:
    result = made("a bedroom with a work area 1 m from the window")
    depth = max(result.scene.by_name["desk-0"].size[:2])
    near = min(away(result, "desk-0", window) for window in windows(result))
    assert 0.95 < near < 1.35 + depth and result.report.ok


def test_what_is_beside_an_opening_that_is_not_there_is_given_back() -> None:
    scene, _ = rl.scene_from_sentence("a bedroom with a desk to the left of the window")
    bare = replace(scene, room=replace(scene.room, windows=()))
    assert [row.kind for row in read_words(bare).rows if "left" in row.words] == ["not understood"]
