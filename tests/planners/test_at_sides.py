"""Rooms of sentences that say at which side of a thing others are, what is between which, and as one sees it who looks."""

from __future__ import annotations

import math

import pytest
from said_rooms import at_sides, made, of

from robolayout.run.result import Result
from running import slow


def seen(result: Result, name: str, other: str) -> tuple[float, float]:
    """Return where a thing is in the frame of another: metres ahead of it and to its left."""
    x, y = result.layout[other].seen(result.layout[name].at)
    return float(x), float(y)


def looks_at(result: Result, name: str, other: str) -> float:
    """Return how much the front of a thing looks towards the line along another one's near side: 1 squarely."""
    x, y = seen(result, name, other)
    depth, width, _ = result.scene.by_name[other].size
    turned = result.layout[name].yaw - result.layout[other].yaw
    ahead = abs(x) - depth / 2 > abs(y) - width / 2
    return -math.copysign(1.0, x if ahead else y) * (math.cos(turned) if ahead else math.sin(turned))


def sides(result: Result, kind: str, table: str) -> set[str]:
    """Return at which sides of a table things of a kind are."""
    return {*at_sides(result, kind, table)}


@pytest.mark.parametrize(
    ("text", "kind", "table", "count"),
    [
        slow(
            "a kitchen with an island in the middle and four stools along one side", "bar_stool", "kitchen_island-0", 4
        ),
        ("a dining room with a table and three chairs on the same side of it", "chair", "dining_table-0", 3),
        slow(
            "a meeting room with a table with five chairs along one long side", "office_chair", "conference_table-0", 5
        ),
    ],
)
def test_seats_are_all_at_one_side(text: str, kind: str, table: str, count: int) -> None:
    result = made(text)
    assert result.report.ok
    assert len(of(result, kind)) == count
    assert len(sides(result, kind, table)) == 1
    assert min(looks_at(result, name, table) for name in of(result, kind)) > 0.95


@pytest.mark.parametrize("kitchen", [slow("a kitchen"), "a dining room"])
def test_a_bench_and_chairs_are_at_two_sides_of_a_table(kitchen: str) -> None:
    result = made(f"{kitchen} with a table, a bench on one side of it and two chairs on the other")
    assert result.report.ok
    across = {"front": "back", "back": "front", "left": "right", "right": "left"}
    (bench,) = sides(result, "bench", "dining_table-0")
    assert sides(result, "chair", "dining_table-0") == {across[bench]}
    assert looks_at(result, "bench-0", "dining_table-0") > 0.95


@pytest.mark.slow
def test_floor_around_it_is_around_what_was_named_last() -> None:
    result = made(
        "a workshop with a drill press in the corner and a table saw in the middle with 1 m of free space around it"
    )
    assert result.report.ok
    saw = result.scene.by_name["table_saw-0"].size
    for name in of(result, "drill_press") + of(result, "workbench"):
        x, y = seen(result, name, "table_saw-0")
        assert max(abs(x) - saw[0] / 2, abs(y) - saw[1] / 2) > 1.0


@pytest.mark.slow
def test_a_table_between_them_is_between_what_stands_along_two_walls() -> None:
    result = made(
        "a dorm with three bunk beds along the left wall, three lockers along the right wall and a table with six chairs between them"
    )
    assert result.report.ok
    x0, _, x1, _ = result.scene.room.bounds
    assert x0 + 1.0 < result.layout["dining_table-0"].x < x1 - 1.0
    assert len(of(result, "chair")) == 6


@pytest.mark.slow
def test_a_small_table_with_tissues_is_midway_between_two_armchairs() -> None:
    result = made(
        "a room with two armchairs facing each other 1.5 m apart and a box of tissues on a small table between them"
    )
    assert result.report.ok
    assert len(of(result, "tissue_box")) == 1
    assert not of(result, "storage_box")
    one, two = (result.layout[name] for name in of(result, "armchair"))
    table = result.layout["side_table-0"]
    assert math.dist(table.at, ((one.x + two.x) / 2, (one.y + two.y) / 2)) < 0.3
    assert math.cos(one.yaw - two.yaw) < -0.99
    deep = result.scene.by_name["armchair-0"].size[0]
    assert math.dist(one.at, two.at) - deep == pytest.approx(1.5, abs=0.2)


@pytest.mark.slow
def test_each_of_some_chairs_that_face_mirrors_has_its_own() -> None:
    result = made("a hair salon with four styling chairs facing mirrors along one wall")
    assert result.report.ok
    chairs, mirrors = of(result, "salon_chair"), of(result, "floor_mirror")
    assert len(mirrors) == len(chairs) == 4
    before = [min(mirrors, key=lambda mirror: abs(seen(result, mirror, chair)[1])) for chair in chairs]
    assert sorted(before) == sorted(mirrors)


@pytest.mark.slow
def test_what_stands_back_to_back_in_pairs_is_asked_once() -> None:
    result = made("a library with six bookcases back to back in pairs")
    assert result.report.ok
    assert all(row.verdict == "met" for row in result.report.asked)


def test_what_is_opposite_is_opposite_what_was_named_before() -> None:
    result = made("a laundry room with a washing machine and a dryer side by side and an ironing board opposite")
    assert result.report.ok
    ahead, aside = seen(result, "ironing_board-0", "washing_machine-0")
    assert ahead > 0.8 > abs(aside)


@pytest.mark.slow
def test_none_of_some_tables_is_closer_to_the_door_than_is_said() -> None:
    result = made("a cafe with five round tables with two chairs each, none closer than 1.5 m to the door")
    assert result.report.ok
    assert any("1.5" in row.words for row in result.report.asked if row.kind == "relation")
    room = result.scene.room
    door = room.walls[room.doors[0].wall].point(room.doors[0].center)
    half = max(result.scene.by_name["round_table-0"].size[:2]) / 2
    assert min(math.dist(result.layout[name].at, door) for name in of(result, "round_table")) > 1.45 + half


@pytest.mark.slow
def test_left_of_a_board_is_left_for_who_looks_at_it() -> None:
    result = made(
        "a classroom with a whiteboard, a teacher's desk to the left of the whiteboard and six desks facing it"
    )
    assert result.report.ok
    assert seen(result, "teacher_desk-0", "whiteboard-0")[1] < -0.5
    hearth = made("a living room with a fireplace, an armchair to the left of it and a bookcase to the right of it")
    assert seen(hearth, "armchair-0", "fireplace-0")[1] < -0.3
    assert seen(hearth, "bookshelf-0", "fireplace-0")[1] > 0.3


def test_the_opposite_wall_is_across_from_the_door_that_was_named() -> None:
    result = made(
        "a hallway with a shoe rack to the right of the door, a coat rack above it and a mirror on the opposite wall"
    )
    assert result.report.ok
    room = result.scene.room
    inward, forward = room.walls[room.doors[0].wall].normal, result.layout["mirror-0"].forward
    assert inward[0] * forward[0] + inward[1] * forward[1] < -0.99


@pytest.mark.slow
def test_rows_of_a_large_warehouse_stand_as_asked_for_a_small_robot_too() -> None:
    result = made("a warehouse with four rows of pallet racks 2.5 m apart for a robot")
    assert result.report.agents[0].agent.reach_distance is None
    assert result.report.ok


@pytest.mark.parametrize(
    "text",
    [
        slow("a bedroom with a bed and a night stand on each side"),
        "a bed whose headboard is against the wall and a night stand on each side",
    ],
)
def test_a_night_stand_is_a_thing_at_the_end_of_a_sentence_too(text: str) -> None:
    result = made(text)
    assert result.report.ok
    assert sides(result, "night_stand", "bed-0") == {"left", "right"}
    assert all(row.verdict == "met" for row in result.report.asked)


def test_mats_for_prayer_lie_in_rows_and_look_where_they_are_told() -> None:
    result = made("a prayer room with six mats in two rows facing the north wall")
    assert result.report.ok
    mats = [result.layout[name] for name in of(result, "prayer_mat")]
    assert len(mats) == 6
    assert min(math.sin(mat.yaw) for mat in mats) > 0.99


@pytest.mark.slow
def test_cushions_around_low_tables_and_on_a_rug_lie_on_the_floor() -> None:
    result = made("a tea room with four low tables, each with four cushions around it")
    assert result.report.ok
    cushions = of(result, "floor_cushion")
    assert len(cushions) == 16
    assert (
        max(min(math.dist(result.layout[a].at, result.layout[b].at) for b in of(result, "low_table")) for a in cushions)
        < 1.2
    )
    assert of(made("a playroom with a rug with cushions in the corner"), "floor_cushion")


@pytest.mark.slow
def test_a_mattress_is_the_bed_and_a_small_table_for_two_is_sat_at() -> None:
    attic = made("an attic bedroom with a mattress on the floor in the middle of the room")
    assert not [name for name in attic.layout if name.startswith(("bed-", "double_bed", "single_bed"))]
    kitchen = made("a kitchen with a small table for two in the corner")
    assert kitchen.report.ok
    assert math.dist(kitchen.layout["chair-0"].at, kitchen.layout["dining_table-0"].at) < 1.2


@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        ("a bedroom with a bed and two matching nightstands either side", "night_stand", 2),
        ("a dining room with a table and six chairs around", "chair", 6),
        slow("a cafe with tables for two along the window", "chair", 8),
    ],
)
def test_what_is_said_without_its_object_is_there(text: str, kind: str, count: int) -> None:
    result = made(text)
    assert result.report.ok
    assert len(of(result, kind)) == count
    assert all(row.verdict in ("met", "not judged") for row in result.report.asked)


@pytest.mark.slow
def test_what_is_left_and_right_on_a_desk_is_so_for_who_sits_there() -> None:
    result = made("a study with a desk with a lamp on the left, a computer in the middle and books on the right")
    assert result.report.ok
    assert seen(result, "table_lamp-0", "desk-0")[1] < 0.0 < seen(result, "book-0", "desk-0")[1]
    assert all(looks_at(result, name, "desk-0") > 0.9 for name in of(result, "office_chair"))


@pytest.mark.slow
def test_two_chairs_opposite_stand_side_by_side_and_a_told_distance_ahead_is_kept() -> None:
    result = made("a living room with a sofa, two chairs opposite and a table in between")
    assert result.report.ok
    assert math.dist(result.layout["chair-0"].at, result.layout["chair-1"].at) < 1.2
    far = made("a living room with a TV unit, a sofa 2.5 m in front of it and a rug between them")
    assert far.report.ok
    deep = (far.scene.by_name["sofa-0"].size[0] + far.scene.by_name["tv_stand-0"].size[0]) / 2
    assert seen(far, "sofa-0", "tv_stand-0")[0] - deep == pytest.approx(2.5, abs=0.35)


@pytest.mark.slow
def test_rooms_that_nobody_names_are_what_their_things_say() -> None:
    lounge = made("There is a sofa in the middle of the room. In front of it is a coffee table.")
    assert of(lounge, "tv_stand")
    assert not of(lounge, "reception_desk")
    work = made("a workspace with a standing desk, a monitor, a chair and a whiteboard on the wall")
    assert not of(work, "server_rack")


@pytest.mark.slow
def test_chairs_on_all_sides_and_things_on_opposite_walls() -> None:
    dining = made("a dining room with a table and chairs on all sides")
    assert dining.report.ok
    assert (len(of(dining, "dining_table")), len(of(dining, "chair"))) == (1, 4)
    bedroom = made("a bedroom with a wardrobe and a dresser on opposite walls")
    assert bedroom.report.ok
    assert math.cos(bedroom.layout["wardrobe-0"].yaw - bedroom.layout["dresser-0"].yaw) < -0.99
