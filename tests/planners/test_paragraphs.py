"""Rooms of sentences that models and people write, laid out as they say it: each of these once was unmet or silly."""

from __future__ import annotations

import math

import pytest
from tests.planners.said_rooms import made, of

from running import slow


def test_two_beds_on_opposite_walls_have_a_desk_between_them_under_the_window() -> None:
    result = made("A kids room with two single beds on opposite walls and a desk between them under the window.")
    assert result.report.ok, result.report.violations
    one, other = (result.layout[name] for name in of(result, "single_bed"))
    desk = result.layout[of(result, "desk")[0]]
    assert math.dist(desk.at, ((one.x + other.x) / 2, (one.y + other.y) / 2)) < 1.2


def test_chairs_along_a_wall_stand_before_their_mirrors_there() -> None:
    result = made("A barbershop: three barber chairs along the right wall, each in front of a mirror.")
    assert result.report.ok, result.report.violations
    walls = {round(result.layout[name].x, 1) for name in of(result, "mirror")}
    assert len(walls) == 1


@pytest.mark.parametrize(
    "text",
    [
        "A small prayer room with five rows of prayer mats facing the east wall and a lectern in front of the mats.",
        "A prayer room with five rows of prayer mats facing the east wall.",
        slow("A yoga studio with nine mats in three rows facing the instructor's mat."),
    ],
)
def test_mats_lie_in_rows_where_no_way_between_them_has_room(text: str) -> None:
    result = made(text)
    assert result.report.ok, result.report.violations


@pytest.mark.slow
def test_two_beds_face_one_dresser() -> None:
    result = made(
        "A hotel room has two queen beds with one nightstand between them, facing a long dresser with a TV on it."
    )
    assert result.report.ok, result.report.violations


def test_a_bar_on_a_wall_leaves_room_for_the_shelves_behind_it() -> None:
    result = made("A bar with a counter on the left wall, four stools in front of it and shelves of bottles behind it.")
    assert result.report.ok, result.report.violations


def test_desks_of_a_cluster_at_which_people_face_each_other_are_one_island() -> None:
    result = made(
        "A startup office. Four standing desks form a cluster in the middle, so that the people face each other."
    )
    assert result.report.ok, result.report.violations
    poses = [result.layout[name] for name in of(result, "standing_desk")]
    assert len({round(math.degrees(pose.yaw)) % 180 for pose in poses}) == 1


def test_a_toilet_between_others_is_at_a_wall() -> None:
    result = made("A bathroom with a sink on the left wall, a bathtub along the back wall and the toilet between them.")
    said = [one.relation for one in result.program.statements if one.wish is None]
    assert any(one.name == "against_wall" and one.asset_names() == ("toilet-0",) for one in said)


def test_who_looks_at_the_desks_from_the_corner_sits_in_it() -> None:
    """The desk once had its back to the corner's walls and faced away (unmet in 7 s)."""
    result = made("An office with four desks in the center. The manager's desk is in the corner, facing the desks.")
    assert result.report.ok, result.report.violations
    (desk,) = (result.layout[name] for name in of(result, "executive_desk"))
    x, y = result.scene.room.bounds[2:]
    ahead = (x / 2 - desk.x) * math.cos(desk.yaw) + (y / 2 - desk.y) * math.sin(desk.yaw)
    assert ahead < 0, "who sits before its front looks at the room"


def test_benches_that_face_each_other_go_under_the_table_between_them() -> None:
    result = made("A meeting booth with two benches facing each other and a table between them.")
    assert result.report.ok, result.report.violations
