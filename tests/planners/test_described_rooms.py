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
