"""Rooms of sentences with beds, seats and desks in rows: judged by poses and sizes alone."""

from __future__ import annotations

import math

import pytest
from shapely import Point, Polygon
from tests.planners.said_rooms import at_sides, made, of

from robolayout.planners.sentence import scene_from_sentence
from robolayout.run.result import Result
from running import slow


def head_to_wall(result: Result, name: str) -> float:
    """Return the metres between the middle of a thing's back and the nearest wall."""
    pose, (depth, *_) = result.layout[name], result.scene.by_name[name].size
    back = Point(pose.x - depth / 2 * math.cos(pose.yaw), pose.y - depth / 2 * math.sin(pose.yaw))
    return float(back.distance(Polygon(result.scene.room.vertices).exterior))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        ("a dormitory with six single beds in two rows", "single_bed", 6),
        slow("a ward with six hospital beds in two rows", "hospital_bed", 6),
        slow("a barracks with ten bunk beds in two rows and a locker next to each", "bunk_bed", 10),
    ],
)
def test_beds_in_two_rows_have_their_heads_at_opposite_walls(text: str, kind: str, count: int) -> None:
    result = made(text)
    beds = of(result, kind)
    assert result.report.ok
    assert len(beds) == count
    assert max(head_to_wall(result, name) for name in beds) < 0.15
    yaws = sorted(round(math.degrees(result.layout[name].yaw)) % 360 for name in beds)
    assert yaws[: count // 2] == [yaws[0]] * (count // 2)
    assert {yaw - yaws[0] for yaw in yaws[count // 2 :]} == {180}


def test_beds_of_a_row_leave_room_to_get_into_them() -> None:
    result = made("a dorm with four beds in a row")
    first, *others = sorted(of(result, "bed"), key=lambda name: result.layout["bed-0"].seen(result.layout[name].at)[1])
    assert result.report.ok
    for one, two in zip([first, *others], others, strict=False):
        apart = abs(result.layout[one].seen(result.layout[two].at)[1]) - result.scene.by_name[one].size[1]
        assert apart > 0.65


def test_beds_side_by_side_are_as_far_apart_as_is_said() -> None:
    result = made("a bedroom with two single beds side by side with 80 cm between them")
    one, two = of(result, "single_bed")
    apart = abs(result.layout[one].seen(result.layout[two].at)[1]) - result.scene.by_name[one].size[1]
    assert result.report.ok
    assert 0.75 < apart < 1.15


@pytest.mark.slow
def test_each_bed_of_a_ward_has_its_curtain() -> None:
    result = made("a ward with eight hospital beds in two rows, each with a curtain")
    assert result.report.ok
    assert {row.verdict for row in result.report.asked} == {"met"}


@pytest.mark.parametrize(
    ("text", "kind", "foot"),
    [
        ("a kid's room with three beds in a row and a toy chest at the foot of each", "single_bed", "toy_box"),
        slow(
            "a bunk room with six single beds in two rows and a locker at the foot of each bed", "single_bed", "locker"
        ),
    ],
)
def test_what_opens_at_the_foot_of_a_bed_opens_away_from_it(text: str, kind: str, foot: str) -> None:
    result = made(text)
    assert result.report.ok
    for name in of(result, foot):
        bed = min(of(result, kind), key=lambda one: math.dist(result.layout[one].at, result.layout[name].at))
        assert math.cos(result.layout[bed].yaw - result.layout[name].yaw) > 0.99
        assert result.layout[bed].seen(result.layout[name].at)[0] > result.scene.by_name[bed].size[0] / 2


@pytest.mark.parametrize(
    ("text", "watched"),
    [
        slow("a press room with twenty chairs in four rows facing a podium", "lectern-0"),
        ("a chapel with fifteen chairs facing the altar", "altar-0"),
    ],
)
def test_an_audience_sits_near_what_it_listens_to(text: str, watched: str) -> None:
    result = made(text)
    assert result.report.ok
    nearest = min(math.dist(result.layout[name].at, result.layout[watched].at) for name in of(result, "chair"))
    assert 1.0 < nearest < 4.1


def test_sofas_that_face_each_other_around_a_table_are_across_it() -> None:
    result = made("a lobby with two sofas facing each other around a coffee table")
    assert result.report.ok
    assert at_sides(result, "sofa", "coffee_table-0") == ["back", "front"]


@pytest.mark.slow
def test_a_room_with_islands_of_desks_is_no_larger_than_they_need() -> None:
    result = made("an office with three islands of four desks each")
    assert result.report.ok
    assert result.scene.room.area < 100.0


def test_what_is_said_of_the_middle_of_a_hall_keeps_it_free() -> None:
    scene, _ = scene_from_sentence("a hall with ten round tables and a dance floor in the middle")
    assert not [asset.name for asset in scene.assets if "dance" in asset.name or "box" in asset.category]


@pytest.mark.slow
def test_an_altar_bears_candles_and_a_flag_stands_on_the_floor() -> None:
    chapel = made("a chapel with an altar, a lectern to the right of the altar and candles on both sides")
    altar = chapel.layout["altar-0"]
    x, y = (side / 2 for side in chapel.scene.by_name["altar-0"].size[:2])
    assert chapel.report.ok
    for name in of(chapel, "candle"):
        ahead, left = altar.seen(chapel.layout[name].at)
        assert abs(ahead) < x
        assert abs(left) < y
    office, _ = scene_from_sentence("an office with a flag on each side of the desk")
    assert [asset.on_floor for asset in office.assets if "flag" in asset.name] == [True, True]
    bedroom, _ = scene_from_sentence("a bedroom with a flag on the wall above the bed")
    assert [asset.on_wall for asset in bedroom.assets if "flag" in asset.category or "tapestry" in asset.category] == [
        True
    ]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        slow("a laboratory with three lab benches in parallel", "lab_bench", 3),
        ("a laboratory with three parallel lab benches", "lab_bench", 3),
        slow(
            "a lab with six lab benches arranged in parallel to each other and a fume hood in the corner",
            "lab_bench",
            6,
        ),
    ],
)
def test_what_stands_in_parallel_is_beside_its_like_and_not_end_to_end(text: str, kind: str, count: int) -> None:
    result = made(text)
    benches = of(result, kind)
    assert result.report.ok
    assert len(benches) == count
    first = result.layout[benches[0]]
    assert all(math.cos(result.layout[name].yaw - first.yaw) > 0.999 for name in benches)
    lines = {round(first.seen(result.layout[name].at)[0], 1) for name in benches}
    assert len(lines) in (3, count), "two columns, or one"


@pytest.mark.slow
def test_two_parallel_rows_are_two_rows() -> None:
    assert len(of(made("an office with two parallel rows of four desks"), "desk")) == 8


@pytest.mark.slow
def test_rows_across_a_told_aisle_stand_across_it_and_not_across_the_room() -> None:
    result = made("A server room with two rows of four racks facing each other across a cold aisle of 1.2 m.")
    racks = of(result, "server_rack")
    depth = result.scene.by_name[racks[0]].size[0]
    ahead = [result.layout[racks[0]].seen(result.layout[name].at)[0] - depth for name in racks[4:]]
    assert result.report.ok and all(1.19 < gap < 1.51 for gap in ahead)


def test_recliners_in_rows_watch_the_screen_of_their_room() -> None:
    result = made("A home theater with two rows of three recliners and a big screen on the front wall.")
    (screen,) = of(result, "screen")
    for name in of(result, "recliner"):
        ahead, left = result.layout[name].seen(result.layout[screen].at)
        assert ahead > abs(left), name


@pytest.mark.slow
def test_seats_on_both_sides_of_a_row_can_be_got_to() -> None:
    result = made("A nail salon with four manicure tables in a row, each with two chairs facing each other.")
    assert result.report.ok, result.report.violations
