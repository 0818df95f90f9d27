"""Rooms of everyday sentences, as somebody looks at them: everything is met, nothing stands askew, and what belongs together is in line.

The checks look at poses and sizes alone.
"""

from __future__ import annotations

import math

import pytest
from said_rooms import made, of

from robolayout.run.result import Result
from running import slow

SENTENCES = (
    slow("a living room with two sofas facing each other and a fireplace"),
    slow("a living room with a TV stand between two bookshelves"),
    slow("a living room with two armchairs in front of the TV"),
    slow("a living room with an L-shaped sofa, two poufs and a floor lamp behind the sofa"),
    slow("a bedroom with a bed between two wardrobes"),
    slow("a bedroom with a dressing table, a stool in front of it and a mirror above it"),
    "a bedroom with a night stand between two single beds",
    slow("a bedroom with a desk and chair in the left corner and a bed in the right corner"),
    slow("a hotel room with two queen beds, a desk, a TV and a luggage rack"),
    slow("a guest room with a single bed and a small desk"),
    slow("a nursery with a crib, a changing table, a rocking chair and a toy chest"),
    slow("a bathroom with a bathtub, a toilet, a sink and a mirror above the sink"),
    slow("a bathroom with a sink between two cabinets"),
    slow("a dining table with eight chairs, and a chandelier above it"),
    slow("a cafe with five round tables, each with two chairs, and a counter"),
    slow("a study with two desks side by side facing the wall"),
    slow("an office with a desk between two filing cabinets"),
    slow("a gym with three treadmills side by side facing the window"),
    slow("a classroom with twelve desks facing the whiteboard"),
    slow("a science lab with three lab benches and six stools"),
    slow("a church with ten pews facing an altar"),
    "a hallway with a shoe rack, a coat rack and a bench",
    slow("a dressing room with a vanity, a stool and three wardrobes in a row"),
    slow("a shop with four clothing racks, a checkout counter near the door and a mirror"),
    slow("a reception with a bench, a coffee machine and a plant in each corner"),
    slow("a kitchen with a breakfast bar and four stools, and a fridge beside the stove"),
    slow("a home office with a desk by the window, a chair and two bookshelves on the opposite wall"),
    slow("a meeting room with a table and eight chairs by the window"),
    slow("a living room with a sofa under the window, a TV on the opposite wall and a coffee table in between"),
    slow("a living room with three bookshelves in a row along the back wall and a reading chair next to them"),
    slow("a gym with five treadmills in a row facing the mirrors"),
    slow("a computer lab with twelve computers in three rows and a teacher's desk in front"),
    slow("a classroom with twenty desks and a teacher's desk"),
)


@pytest.mark.parametrize("text", SENTENCES)
def test_everything_is_met_and_nothing_stands_askew(text: str) -> None:
    result = made(text)
    assert result.report.ok, result.report.violations
    assert [row["words"] for row in result.report.to_dict()["asked"] if row["verdict"] != "met"] == []
    askew = [name for name in result.layout if abs(math.sin(2 * result.layout[name].yaw)) > 0.02]
    assert askew == []


def along(result: Result, name: str, one: str) -> float:
    """Return how far a thing is in front of another one, centre to centre."""
    return result.layout[one].seen(result.layout[name].at)[0]


@pytest.mark.parametrize(
    ("text", "outer", "middle"),
    [
        slow("a living room with a TV stand between two bookshelves", "bookshelf", "tv_stand"),
        slow("a bathroom with a sink between two cabinets", "cabinet", "washbasin"),
        ("a hall with a console table between two chairs", "chair", "console_table"),
    ],
)
def test_what_is_between_two_of_a_kind_has_its_back_to_their_wall(text: str, outer: str, middle: str) -> None:
    result = made(text)
    (centre,), ends = of(result, middle), of(result, outer)
    depth = result.scene.by_name[centre].size[0]
    for end in ends:
        assert math.cos(result.layout[end].yaw - result.layout[centre].yaw) > 0.99
        backs = along(result, end, centre) - (result.scene.by_name[end].size[0] - depth) / 2
        assert abs(backs) < 0.1, end


@pytest.mark.parametrize(
    ("text", "kind", "rows"),
    [
        slow("a cinema with twenty seats facing the screen", "theater_seat", 4),
        slow("a classroom with twelve desks facing the whiteboard", "student_desk", 3),
        slow("a church with ten pews facing an altar", "pew", 5),
    ],
)
def test_a_crowd_looks_one_way_in_straight_rows(text: str, kind: str, rows: int) -> None:
    result = made(text)
    crowd = of(result, kind)
    assert {round(result.layout[name].forward[0], 1) for name in crowd} == {
        round(result.layout[crowd[0]].forward[0], 1)
    }
    assert len({round(along(result, name, crowd[0]), 1) for name in crowd}) == rows


@pytest.mark.slow
def test_seats_before_a_fireplace_look_at_it() -> None:
    result = made("a living room with a fireplace and two armchairs in front of the fireplace")
    (fire,) = of(result, "fireplace")
    assert of(result, "television") == []
    for chair in of(result, "armchair")[:2]:
        ahead, left = result.layout[chair].seen(result.layout[fire].at)
        assert ahead / math.hypot(ahead, left) > math.cos(math.radians(50)), chair


def test_shelves_on_both_long_walls_are_on_both() -> None:
    result = made("a storage room of 6 x 4 m with shelves on both long walls")
    assert sorted(round(result.layout[name].y) for name in of(result, "shelving_unit")) == [0, 4]


@pytest.mark.slow
def test_stools_stand_at_the_bar_and_shelves_across_from_the_window() -> None:
    kitchen = made("a kitchen with a breakfast bar and four stools, and a fridge beside the stove")
    (bar,) = of(kitchen, "kitchen_island")
    assert all(abs(along(kitchen, stool, bar)) < 1.0 for stool in of(kitchen, "bar_stool"))
    office = made("a home office with a desk by the window, a chair and two bookshelves on the opposite wall")
    (desk,) = of(office, "desk")
    assert all(math.cos(office.layout[n].yaw - office.layout[desk].yaw) < -0.99 for n in of(office, "bookshelf"))


@pytest.mark.slow
def test_a_bed_in_a_corner_has_one_night_stand_and_tables_in_pairs_no_rug() -> None:
    assert len(of(made("a bedroom with the bed in the corner"), "night_stand")) == 1
    assert of(made("a library with two reading tables with four chairs each"), "rug") == []


def test_cushions_lie_around_a_low_table() -> None:
    result = made("a tatami room with a low table and four floor cushions")
    table = result.layout["low_table-0"]
    away = [math.hypot(result.layout[n].x - table.x, result.layout[n].y - table.y) for n in of(result, "floor_cushion")]
    assert len(away) == 4
    assert max(away) < 1.0


@pytest.mark.slow
def test_every_desk_of_an_internet_cafe_and_every_table_has_chairs() -> None:
    result = made("an internet cafe with ten computer desks in two rows back to back")
    assert len(of(result, "office_chair")) == 10
    assert len(of(result, "chair")) >= 2 * len(of(result, "round_table"))


@pytest.mark.slow
def test_a_rug_lies_under_both_of_two_armchairs_that_face_each_other() -> None:
    result = made("a reading room with two armchairs facing each other with a small table between them")
    (rug,) = of(result, "rug")
    depth, width, _ = result.scene.by_name[rug].size
    for chair in of(result, "armchair"):
        x, y = result.layout[rug].seen(result.layout[chair].at)
        assert max(abs(x) - depth / 2, abs(y) - width / 2) < 0.0, chair


@pytest.mark.slow
def test_nobody_watches_from_sofas_that_face_each_other() -> None:
    result = made("a living room with two sofas facing each other, a coffee table and a rug")
    assert of(result, "television") == of(result, "tv_stand") == []


@pytest.mark.slow
def test_a_television_hangs_right_above_a_fireplace() -> None:
    result = made("a living room with a sofa, TV above the fireplace")
    ahead, left = result.layout["fireplace-0"].seen(result.layout["television-0"].at)
    assert abs(left) < 0.05
    assert ahead < 0.0


def test_a_night_stand_between_two_beds_is_at_their_heads() -> None:
    result = made("a twin bedroom with two single beds and a nightstand between them")
    assert result.report.ok
    (stand,) = of(result, "night_stand")
    for bed in of(result, "single_bed"):
        deeper = result.scene.by_name[bed].size[0] - result.scene.by_name[stand].size[0]
        assert along(result, bed, stand) == pytest.approx(deeper / 2, abs=0.05)


@pytest.mark.slow
def test_barber_chairs_stand_in_a_row_before_their_mirrors() -> None:
    result = made("a barber shop with three barber chairs, mirrors and a waiting bench")
    chairs = of(result, "salon_chair")
    assert len(chairs) == len(of(result, "mirror")) == 3
    assert all(abs(along(result, chair, chairs[0])) < 0.05 for chair in chairs)
    for chair in chairs:
        aside = [abs(result.layout[chair].seen(result.layout[mirror].at)[1]) for mirror in of(result, "mirror")]
        assert min(aside) < 0.1, chair


def test_two_basins_stand_side_by_side() -> None:
    result = made("a bathroom with a bathtub, double sinks and a toilet")
    one, other = of(result, "bathroom_vanity")
    ahead, left = result.layout[one].seen(result.layout[other].at)
    assert abs(ahead) < 0.02
    assert abs(left) < result.scene.by_name[one].size[1] + 0.1


@pytest.mark.slow
def test_a_bar_along_the_window_has_its_back_to_its_wall() -> None:
    result = made("a small kitchen with a breakfast bar along the window")
    (bar,) = of(result, "kitchen_island")
    room, forward = result.scene.room, result.layout[bar].forward
    normals = [room.walls[one.wall].normal for one in room.windows]
    assert max(x * forward[0] + y * forward[1] for x, y in normals) > 0.99


@pytest.mark.slow
def test_pupils_leave_room_before_the_desk_of_their_teacher() -> None:
    result = made("a classroom with twelve desks, a whiteboard and a teacher's desk")
    (teacher,) = of(result, "teacher_desk")
    pupils = of(result, "student_desk")
    deep = (result.scene.by_name[teacher].size[0] + result.scene.by_name[pupils[0]].size[0]) / 2
    assert min(-along(result, desk, teacher) for desk in pupils) - deep > 0.5


@pytest.mark.slow
def test_rows_of_chairs_look_at_the_wall_of_the_screen() -> None:
    result = made("a lecture room with five rows of chairs, a lectern and a screen")
    wall = result.layout["projection_screen-0"].forward
    for chair in of(result, "chair"):
        forward = result.layout[chair].forward
        assert forward[0] * wall[0] + forward[1] * wall[1] < -0.99, chair


@pytest.mark.slow
def test_where_all_sit_around_a_coffee_table_no_sofa_takes_their_place() -> None:
    result = made("a lounge with three armchairs around a coffee table and a rug")
    assert result.report.ok
    assert of(result, "sofa") == of(result, "television") == []
