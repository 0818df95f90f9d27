"""Rooms in which things stand in a circle, a half circle, a U, or both sides of a fireplace, measured on the poses."""

from __future__ import annotations

import math

import pytest
from said_rooms import at_sides, made, of

import robolayout as rl
from robolayout.run.result import Result
from running import slow


def poses(result: Result, kind: str) -> list[tuple[float, float, float]]:
    return [(pose.x, pose.y, pose.yaw) for pose in (result.layout[name] for name in of(result, kind))]


def middle(places: list[tuple[float, float, float]]) -> tuple[float, float]:
    x, y, _ = (sum(values) / len(places) for values in zip(*places, strict=True))
    return x, y


def off(yaw: float, dx: float, dy: float) -> float:
    """Return degrees between a heading and a direction."""
    return abs(math.degrees(math.remainder(yaw - math.atan2(dy, dx), math.tau)))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        slow("a therapy room with ten chairs in a circle", "chair", 10),
        slow("a support group room with eight armchairs in a circle facing each other", "armchair", 8),
        ("a yoga studio with eight yoga mats in a circle", "yoga_mat", 8),
        slow("a classroom with 12 chairs arranged in a circle", "chair", 12),
        slow("ten chairs in a circle for a wheelchair user", "chair", 10),
    ],
)
def test_things_in_a_circle_surround_its_middle_and_look_there(text: str, kind: str, count: int) -> None:
    result = made(text)
    places = poses(result, kind)
    assert result.report.ok and len(places) == count
    x, y = middle(places)
    assert max(math.dist((x, y), at[:2]) for at in places) - min(math.dist((x, y), at[:2]) for at in places) < 0.3
    assert max(off(yaw, x - a, y - b) for a, b, yaw in places) < 10
    inside = [
        name
        for name in result.layout
        if result.scene.by_name[name].on_floor and math.dist(result.layout[name].at, (x, y)) < 0.6
    ]
    assert not inside  # nothing was put into the middle


@pytest.mark.parametrize(
    ("text", "kind", "watched"),
    [
        ("six armchairs in a half circle in front of the fireplace", "armchair", "fireplace-0"),
        slow("an auditorium with 15 seats in a semicircle facing the stage", "theater_seat", "stage-0"),
        slow("a kindergarten with eight floor cushions in a semicircle facing the board", "floor_cushion", "board-0"),
    ],
)
def test_a_half_circle_is_open_to_what_is_watched(text: str, kind: str, watched: str) -> None:
    result = made(text)
    assert result.report.ok
    places, to = poses(result, kind), result.layout[watched]
    x, y = middle(places)
    ends = [(places[0][k] + places[-1][k]) / 2 for k in (0, 1)]
    assert off(math.atan2(ends[1] - y, ends[0] - x), -math.cos(to.yaw), -math.sin(to.yaw)) < 10
    across = to.seen((ends[0], ends[1]))
    assert across[0] > 0 and abs(across[1]) < result.scene.by_name[watched].size[1] / 2 + 1.0


@pytest.mark.slow
@pytest.mark.parametrize(
    "text",
    [
        "eight desks in a U shape facing the board",
        slow("twelve desks in a horseshoe facing the whiteboard"),
        slow("an office where eight desks form a U"),
    ],
)
def test_who_sits_at_a_u_of_desks_looks_inward(text: str) -> None:
    result = made(text)
    assert result.report.ok
    places = poses(result, "desk")
    sides = {round(math.degrees(yaw - places[len(places) // 2][2])) % 360 for *_, yaw in places}
    assert sides == {0, 90, 270}
    x, y = middle(places)
    for chair, desk in zip(poses(result, "office_chair") or poses(result, "chair"), places, strict=False):
        assert math.dist(chair[:2], (x, y)) > math.dist(desk[:2], (x, y))  # outside


@pytest.mark.slow
@pytest.mark.parametrize("things", [slow("sofas"), "armchairs", slow("loveseats")])
def test_two_that_face_each_other_before_a_fireplace_are_at_both_sides_of_it(things: str) -> None:
    result = made(f"a living room with a fireplace and two {things} facing each other in front of it")
    assert result.report.ok
    hearth = result.layout["fireplace-0"]
    (ahead, left), (also, right) = (hearth.seen(at[:2]) for at in poses(result, things.removesuffix("s")))
    assert ahead > 0.5 and abs(ahead - also) < 0.2 and abs(left + right) < 0.2 and abs(left) > 0.6


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        slow(
            "a hospital room with two beds separated by a curtain, each with a bedside table and a visitor chair",
            {"night_stand": 2, "visitor_chair": 2},
        ),
        slow("a classroom with a teacher's desk and three tables, each with four chairs", {"chair": 12}),
        slow("a living room with a coffee table between two sofas, each with two cushions", {"cushion": 4}),
        slow("a classroom with 12 desks with a chair each", {"chair": 12}),
        ("a bed and a desk, each with a lamp", {"table_lamp": 2}),
    ],
)
def test_each_is_each_of_several(text: str, counts: dict[str, int]) -> None:
    result = made(text)
    assert {kind: len(of(result, kind)) for kind in counts} == counts
    assert all(row.verdict == "met" for row in result.report.asked)


@pytest.mark.slow
def test_shelves_above_machines_keep_both_of_these_from_the_window() -> None:
    result = made(
        "a laundry room with a washer and dryer side by side, a laundry sink, an ironing board and shelves above the machines"
    )
    assert result.report.ok


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        ("a plant far from the window and the door", {"plant far from window and door"}),
        ("a crib away from the door and the radiator", {"crib away from door and radiator"}),
        ("a bed far from the door, the window and the radiator", {"bed far from door and window and radiator"}),
        slow("a bed separated from the sofa by a bookshelf", {"bookshelf separated from bed and sofa"}),
    ],
)
def test_everything_that_a_relation_leads_to_is_asked(text: str, rows: set[str]) -> None:
    result = made(text)
    asked = {row.words: row.verdict for row in result.report.asked if row.kind == "relation"}
    assert asked == dict.fromkeys(rows, "met")


@pytest.mark.parametrize(
    ("text", "body"),
    [
        ("a bathroom accessible by wheelchair", "wheelchair"),
        ("a bedroom where a wheelchair can turn in front of the wardrobe", "wheelchair"),
        ("a living room for somebody with a walker", "elder_walker"),
        ("a bedroom for my grandmother, who walks with a walker", "elder_walker"),
        ("a living room for two people, one in a wheelchair", "wheelchair"),
        ("a bedroom for my father, who sits in a wheelchair", "wheelchair"),
        ("a bathroom with wheelchair access", "wheelchair"),
        ("a bedroom with a bed and a wheelchair next to it", None),
    ],
)
def test_a_wheelchair_that_somebody_moves_with_is_no_thing(text: str, body: str | None) -> None:
    scene, understood = rl.scene_from_sentence(text)
    assert understood.agent == body
    assert any(asset.category in ("wheelchair", "walker") for asset in scene.assets) is (body is None)


def test_an_odd_seat_is_at_the_head_of_a_table() -> None:
    result = made("a dining room with a table and seven chairs")
    sides = at_sides(result, "chair", "dining_table-0")
    assert sorted(sides.count(side) for side in {*sides}) == [1, 3, 3]


@pytest.mark.slow
def test_a_projector_above_a_table_hangs_from_the_ceiling() -> None:
    result = made("a conference room with a projector above the table")
    lamp, table = result.layout["projector-0"], result.layout["conference_table-0"]
    assert result.report.ok and lamp.z > 2.0
    assert math.dist(lamp.at, table.at) < 0.2


@pytest.mark.slow
def test_a_printer_stand_between_two_desks_keeps_these_apart() -> None:
    result = made("an office with two desks facing each other, a printer stand between them")
    assert result.report.ok
    (one, other), (stand,) = poses(result, "desk"), poses(result, "printer_stand")
    span = math.dist(one[:2], other[:2])
    share = sum((s - a) * (b - a) for a, b, s in zip(one[:2], other[:2], stand[:2], strict=True)) / span**2
    assert 0.2 < share < 0.8


@pytest.mark.parametrize("name", ["terrace", "patio", "balcony"])
def test_outdoors_is_no_cafe(name: str) -> None:
    result = made(f"a {name}")
    assert result.report.ok and of(result, "round_table") and of(result, "chaise_longue")
    assert not of(result, "cash_register")
