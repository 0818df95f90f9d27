"""Rooms of phrases as people type them: two rooms on one floor, tables at walls, blocks of racks, lamps of night stands."""

from __future__ import annotations

import math

import pytest
from said_rooms import at_sides, made, of

from running import slow


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        slow("an open plan kitchen and living room", {"fridge", "stove", "sofa", "coffee_table"}),
        slow("a living/dining room with a sofa", {"sofa", "dining_table", "tv_stand"}),
        slow("living room with a dining area", {"sofa", "dining_table", "chair"}),
        slow("a bedroom and office", {"bed", "desk", "office_chair"}),
        ("a bedroom with an office area", {"bed", "desk", "office_chair"}),
        slow("an office with a lounge area and a meeting area", {"desk", "sofa", "round_table", "stool"}),
        ("a bed and a desk", {"bed", "desk", "wardrobe"}),
    ],
)
def test_what_two_rooms_have_is_there(text: str, kinds: set[str]) -> None:
    result = made(text)
    assert result.report.ok
    missing = {
        kind for kind in kinds if not any(name.startswith(f"{kind}-") or f"_{kind}-" in name for name in result.layout)
    }
    assert not missing


def test_a_bed_a_desk_a_chair_and_a_wardrobe_are_a_bedroom() -> None:
    result = made("bed, desk, chair and wardrobe")
    assert not of(result, "sofa")
    assert not of(result, "dining_table")


@pytest.mark.parametrize(
    ("chairs", "sides"),
    [
        ("two chairs", ["left", "right"]),
        ("three chairs", ["front", "left", "right"]),
        ("four chairs", ["front", "front", "left", "right"]),
    ],
)
def test_no_chair_stands_between_a_table_and_its_wall(chairs: str, sides: list[str]) -> None:
    result = made(f"a dining room with a table against the wall and {chairs}")
    assert result.report.ok
    assert at_sides(result, "chair", "dining_table-0") == sides
    pose, depth = result.layout["dining_table-0"], result.scene.by_name["dining_table-0"].size[0]
    width, height = result.scene.room.bounds[2:]
    x, y = pose.x - depth / 2 * math.cos(pose.yaw), pose.y - depth / 2 * math.sin(pose.yaw)
    assert min(x, y, width - x, height - y) < 0.1


@pytest.mark.parametrize(
    ("text", "kind", "each"),
    [
        slow("a warehouse with 8 racks in two rows", "pallet_rack", 4),
        slow("a warehouse with 8 racks in two rows with an aisle between them", "pallet_rack", 4),
        slow("a warehouse with 6 racks in 2 rows with an aisle in the middle", "pallet_rack", 3),
        slow("a chapel with 6 pews on each side", "pew", 6),
    ],
)
def test_blocks_of_rows_find_a_place(text: str, kind: str, each: int) -> None:
    result = made(text)
    assert result.report.ok
    names = of(result, kind)
    first = result.layout[names[0]]
    seen = [first.seen(result.layout[name].at) for name in names]
    lines = [sorted({round(float(place[axis]), 1) for place in seen}) for axis in (0, 1)]
    assert {len(lines[0]), len(lines[1])} == {2, each}


@pytest.mark.slow
def test_a_crowd_of_desks_in_rows_gets_a_room_that_holds_it() -> None:
    assert made("a classroom with 20 desks in rows facing the whiteboard").report.ok


def test_lamps_named_after_night_stands_stand_on_them() -> None:
    result = made("king size bed with two nightstands and lamps")
    assert result.report.ok
    lamps, stands = of(result, "table_lamp"), of(result, "night_stand")
    assert len(lamps) == 2
    gaps = [math.dist(result.layout[a].at, result.layout[b].at) for a, b in zip(lamps, stands, strict=True)]
    assert max(gaps) < 0.3


def test_a_chest_at_the_foot_of_a_bed_stands_in_its_middle() -> None:
    result = made("a bedroom with a chest at the foot of the bed")
    x, y = result.layout["bed-0"].seen(result.layout["chest-0"].at)
    assert abs(y) < 0.1
    assert x > 1.0


@pytest.mark.slow
def test_two_sofas_in_an_l_are_at_right_angles_and_near() -> None:
    result = made("a living room with two sofas in an L shape")
    assert result.report.ok
    one, two = (result.layout[name] for name in of(result, "sofa"))
    assert abs(math.cos(one.yaw - two.yaw)) < 0.1


def test_shelves_hang_over_both_machines() -> None:
    result = made("a laundry room with a washer and dryer side by side and shelves above")
    assert result.report.ok
    shelves = [result.layout[name].at for name in of(result, "wall_shelf")[:2]]
    machines = [result.layout[name].at for name in ("washing_machine-0", "clothes_dryer-0")]
    assert max(min(math.dist(shelf, machine) for shelf in shelves) for machine in machines) < 0.7


@pytest.mark.slow
def test_counters_on_both_sides_are_at_opposite_walls() -> None:
    result = made("galley kitchen with counters on both sides")
    assert result.report.ok
    one, two = (result.layout[name] for name in of(result, "kitchen_counter")[:2])
    assert math.cos(one.yaw - two.yaw) < -0.9


@pytest.mark.parametrize(
    ("text", "chairs"), [slow("a restaurant with 6 tables of 4", 24), ("a cafe with 3 tables of two", 6)]
)
def test_tables_of_so_many_have_so_many_chairs(text: str, chairs: int) -> None:
    result = made(text)
    assert result.report.ok
    assert sum("chair" in name for name in result.layout) == chairs


@pytest.mark.parametrize(
    ("text", "about", "to", "where"),
    [
        slow("a living room with a sofa and a plant 2 m to the left of it", "plant-0", "sofa-0", "left"),
        slow("a bedroom with a bed and a desk 1.8 m to the right of the bed", "desk-0", "bed-0", "right"),
        ("an office with a desk and a bookshelf 2 m behind it", "bookshelf-0", "desk-0", "back"),
    ],
)
def test_a_side_and_a_distance_are_told_together(text: str, about: str, to: str, where: str) -> None:
    result = made(text)
    assert result.report.ok
    assert at_sides(result, about.split("-")[0], to) == [where]


@pytest.mark.slow
@pytest.mark.parametrize("chairs", [slow("two"), "three"])
def test_no_chair_stands_between_a_table_and_its_corner(chairs: str) -> None:
    result = made(f"a kitchen with a small table in the corner and {chairs} chairs")
    assert result.report.ok
    assert {"front", "left"} >= {*at_sides(result, "chair", "dining_table-0")}
