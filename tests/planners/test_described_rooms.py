"""Rooms laid out as people describe them: what stands where is looked at, not only what the report says."""

from __future__ import annotations

import math

import pytest

import robolayout as rl


def test_what_is_between_two_of_a_kitchen_stands_in_line_with_both() -> None:
    """The stove stood in the middle of the kitchen, its hood hung elsewhere."""
    result = rl.generate("A kitchen with the stove between the sink and the fridge", dress="none")
    stove, sink, fridge = (result.layout[name] for name in ("stove-0", "kitchen_sink-0", "fridge-0"))
    assert result.report.ok
    assert math.isclose(math.cos(stove.yaw - sink.yaw), 1.0, abs_tol=0.01)
    assert math.isclose(math.cos(stove.yaw - fridge.yaw), 1.0, abs_tol=0.01)


def test_two_armchairs_by_the_fire_face_each_other_before_it() -> None:
    """They sat with their backs to the fire."""
    result = rl.generate("A living room with two armchairs by the fireplace and a sofa", dress="none")
    one, two, fire = (result.layout[name] for name in ("armchair-0", "armchair-1", "fireplace-0"))
    assert result.report.ok
    assert math.cos(one.yaw - two.yaw) < -0.98 or max(math.dist(chair.at, fire.at) for chair in (one, two)) < 1.6


def test_four_desks_in_pairs_are_one_block() -> None:
    """The second pair stood where no room was left for half of it."""
    result = rl.generate(
        "An office with four desks facing each other in pairs, a whiteboard and a printer", dress="none"
    )
    desks = [result.layout[f"desk-{i}"] for i in range(4)]
    depth, width, _ = result.scene.by_name["desk-0"].size
    assert result.report.ok
    assert all(min(math.dist(one.at, two.at) for two in desks if two != one) < depth + 0.1 for one in desks)
    assert max(math.dist(one.at, two.at) for one in desks for two in desks) < math.hypot(width, depth) + 0.1


@pytest.mark.parametrize(
    "text",
    [
        "A study with a desk by the window, a bookcase behind the chair and a rug",
        "A home office with a desk, a bookcase behind the desk chair and an armchair in the corner",
    ],
)
def test_what_is_behind_who_sits_at_a_desk_has_its_back_to_a_wall(text: str) -> None:
    """It stood free in the room."""
    result = rl.generate(text, dress="none")
    (chair,) = (
        result.layout[one.name] for one in result.scene.assets if one.category.endswith(("office chair", "desk chair"))
    )
    shelf = result.layout["bookshelf-0"]
    (c, s), half = shelf.forward, result.scene.by_name["bookshelf-0"].size[0] / 2
    back = (shelf.x - half * c, shelf.y - half * s)
    assert result.report.ok
    assert min(wall.distance(back) for wall in result.scene.room.walls) < 0.05
    assert chair.seen(shelf.at)[0] < 0.0


def test_two_double_beds_have_their_heads_at_one_wall() -> None:
    result = rl.generate("A hotel room with two double beds, a desk and an armchair by the window", dress="none")
    one, two = (result.layout[name] for name in ("bed-0", "bed-1"))
    assert result.report.ok
    assert math.cos(one.yaw - two.yaw) > 0.999
    assert abs(one.seen(two.at)[0]) < 0.1


def test_a_sofa_across_from_two_armchairs_is_across_from_both() -> None:
    result = rl.generate("A living room with two armchairs and a sofa across from them", dress="none")
    sofa, *chairs = (result.layout[name] for name in ("sofa-0", "armchair-0", "armchair-1"))
    half = result.scene.by_name["sofa-0"].size[1] / 2
    assert result.report.ok
    for chair in chairs:
        ahead, aside = sofa.seen(chair.at)
        assert ahead > 0.5
        assert abs(aside) < half + 0.5


def test_a_bench_is_at_one_side_of_a_table_and_chairs_are_at_the_others() -> None:
    """The chairs stood along the walls."""
    result = rl.generate("A dining room with a table for eight people and a bench along one side of it", dress="none")
    table = result.layout["dining_table-0"]
    names = [asset.name for asset in result.scene.assets if asset.category in ("chair", "bench")]
    assert result.report.ok
    assert len(names) == 7
    assert max(math.dist(result.layout[name].at, table.at) for name in names) < 1.6


@pytest.mark.slow
@pytest.mark.parametrize(
    "text",
    [
        "A church with eight rows of chairs with an aisle down the middle, facing a lectern",
        "A conference room with 30 chairs in rows facing the stage with an aisle in the middle",
        "A hotel lobby with four groups of two armchairs around small tables",
        "A nail salon with four manicure tables in a row, each with a chair on both sides",
        "A laundromat with eight washing machines along the left wall and eight dryers along the right wall",
        "A small office with the desk in the middle facing the door, a credenza behind it and two guest chairs in front",
        "A music practice room with an upright piano against the wall and two chairs facing each other",
        "A piano in the corner at an angle with its bench",
        "An L-shaped desk in the corner with the chair facing the door",
        "A small cafe with five tables for two along the window and a counter at the back",
    ],
)
def test_a_described_room_is_right_in_all_that_was_asked(text: str) -> None:
    assert rl.generate(text, dress="none").report.ok
