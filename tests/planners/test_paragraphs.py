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
        slow(
            "A hotel room has two queen beds with one nightstand between them, facing a long dresser with a TV on it."
        ),
        "A bar with a counter on the left wall, four stools in front of it and shelves of bottles behind it.",
        "A meeting booth with two benches facing each other and a table between them.",
        "A laundry room with a washer and a dryer next to each other along one wall. A utility sink is to the right of the dryer.",
        "A photo studio with a backdrop on the far wall. A stool is in front of the backdrop. A camera on a tripod stands two "
        "meters in front of the stool. Softboxes are on both sides of the camera.",
        "A break room with a bulletin board next to the door. A recycling bin stands under it.",
        "A bathroom with a small stool that holds a stack of towels.",
        "A living room with a sofa against the back wall. A bookshelf is on the left wall next to the door.",
        slow(
            "A bank lobby with a counter along the back wall. Two desks are along the left wall, each with an office chair behind "
            "it and two visitor chairs in front."
        ),
    ],
)
def test_a_room_is_laid_out_as_it_is_described(text: str) -> None:
    """Mats without room for ways between them, shelves behind a bar, a sink that parted two machines, a stand apart from its camera."""
    result = made(text)
    assert result.report.ok, result.report.violations
    assert not [row.words for row in result.report.asked if row.verdict in ("unmet", "not understood")]


def test_a_reading_area_is_together() -> None:
    """Its round table once had four chairs of its own, at the other end of the shop."""
    result = made(
        "A bookstore with a checkout counter. A reading area with two armchairs and a round table is in a corner."
    )
    chairs = [result.layout[name] for name in of(result, "armchair")]
    (table,) = (result.layout[name] for name in of(result, "side_table"))
    assert max(math.dist(table.at, chair.at) for chair in chairs) < 3 and not of(result, "chair")


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
