"""Rooms that a name arranges: kitchens by their counters, two rooms that open to each other, as many beds as children."""

from __future__ import annotations

import math

import pytest
from said_rooms import made, of

from robolayout.run.result import Result
from running import slow


def walls_of(result: Result, kind: str) -> list[int]:
    """Return the index of the wall that each of a kind has its back to."""
    found = list[int]()
    for name in of(result, kind):
        pose, depth = result.layout[name], result.scene.by_name[name].size[0]
        back = (pose.x - depth / 2 * math.cos(pose.yaw), pose.y - depth / 2 * math.sin(pose.yaw))
        gaps = {
            wall.index: abs(sum((b - s) * n for b, s, n in zip(back, wall.start, wall.normal, strict=True)))
            for wall in result.scene.room.walls
        }
        found.append(min(gaps, key=lambda index: gaps[index]))
        assert gaps[found[-1]] < 0.1
    return found


@pytest.mark.parametrize(
    ("text", "walls", "apart"),
    [
        slow("an L-shaped kitchen", 2, {1, 3}),
        ("a galley kitchen", 2, {2}),
        slow("a U-shaped kitchen", 3, {1, 2, 3}),
        slow("a one-wall kitchen", 1, {0}),
    ],
)
def test_the_name_of_a_kitchen_says_where_its_counters_are(text: str, walls: int, apart: set[int]) -> None:
    result = made(text)
    assert result.report.ok and len(result.scene.room.vertices) == 4
    found = walls_of(result, "kitchen_counter")
    assert len({*found}) == walls
    assert {abs(one - other) for one in found for other in found if one != other or walls == 1} <= apart
    assert any(row.kind == "relation" and row.verdict == "met" for row in result.report.asked)


@pytest.mark.slow
def test_an_l_shaped_room_that_is_no_kitchen_is_one() -> None:
    assert len(made("an L-shaped living room").scene.room.vertices) == 6


@pytest.mark.slow
def test_all_of_a_one_wall_kitchen_is_at_one_wall() -> None:
    result = made("a one-wall kitchen")
    kinds = ("kitchen_counter", "kitchen_sink", "stove", "fridge")
    assert len({wall for kind in kinds for wall in walls_of(result, kind)}) == 1


def test_adjoining_walls_meet() -> None:
    one, other = walls_of(made("a study with two bookshelves on adjoining walls"), "bookshelf")
    assert abs(one - other) in (1, 3)


@pytest.mark.slow
@pytest.mark.parametrize("text", [slow("a kitchen open to the living room"), "a living room that opens to the kitchen"])
def test_a_room_that_opens_to_another_has_what_both_have(text: str) -> None:
    result = made(text)
    assert result.report.ok and of(result, "stove") and of(result, "sofa")


@pytest.mark.parametrize(
    ("text", "chairs"),
    [slow("a kitchen-diner", 4), ("an eat-in kitchen", 4), ("a kitchen-diner with a table for six", 6)],
)
def test_one_eats_in_a_kitchen_diner(text: str, chairs: int) -> None:
    result = made(text)
    assert result.report.ok and of(result, "stove")
    assert (len(of(result, "dining_table")), len(of(result, "chair"))) == (1, chairs)


@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        slow("a kids room for a boy and a girl", "bed", 2),
        slow("a bedroom for my son and my daughter", "bed", 2),
        ("a kids room for one boy and one girl", "bed", 2),
        ("a bedroom for two boys and a girl", "bed", 3),
        ("a nursery for twins", "crib", 2),
        slow("a yoga studio for eight", "yoga_mat", 8),
        ("a yoga studio", "yoga_mat", 4),
        slow("a coworking space for ten", "desk", 10),
        slow("a bar with six stools", "bar_stool", 6),
        slow("a laundry room with a folding table", "chair", 0),
    ],
)
def test_there_is_as_much_as_people_need(text: str, kind: str, count: int) -> None:
    result = made(text)
    assert result.report.ok
    assert sum(name.rsplit("-", 1)[0].endswith(kind) for name in result.layout) == count


@pytest.mark.slow
def test_two_sofas_in_an_l_around_a_table_stand_at_a_right_angle() -> None:
    result = made("two sofas in an L around a coffee table")
    assert result.report.ok
    first, second = (result.layout[name] for name in of(result, "sofa"))
    turn = math.degrees(second.yaw - first.yaw) % 180
    assert abs(turn - 90) < 10


@pytest.mark.slow
def test_dumbbells_do_not_lie_on_a_rack_that_is_full() -> None:
    assert made("a gym with dumbbells").report.ok


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        slow("a classroom with desks", {"student_desk": 12}),
        slow("a classroom with desks in pairs", {"student_desk": 12}),
        ("a classroom with two desks", {"student_desk": 2}),
        slow("a cafe with tables", {"round_table": 4}),
        slow("a church with pews", {"pew": 8}),
        slow("a library with bookshelves", {"bookshelf": 8}),
        slow("an open office with desks", {"desk": 6}),
        slow("a conference room with chairs along the wall", {"office_chair": 8}),
        slow("a study with a desk and two chairs", {"monitor": 1}),
        slow("an office with a desk and two guest chairs", {"guest_chair": 2}),
        slow("an office with a desk and two guest chairs", {"office_chair": 1}),
        slow("a classroom with desks for 20 students", {"student_desk": 20, "chair": 20}),
        slow("an office with desks for six", {"desk": 6, "office_chair": 6, "monitor": 6}),
        slow("a waiting room with seats for 20", {"seat": 20, "chair": 0}),
        slow("a cinema with seats for 40", {"theater_seat": 40, "chair": 0}),
        slow("a cafe with tables for 20", {"round_table": 10, "chair": 20}),
        slow("a restaurant with tables for 30 guests", {"dining_table": 8, "chair": 32}),
        slow("a church with pews for 60", {"pew": 20, "chair": 0}),
        slow("a bedroom with beds for three", {"bed": 3, "chair": 0}),
        slow("a yoga studio with mats for ten", {"yoga_mat": 10}),
        slow("a living room with a sofa for four", {"sofa": 1, "chair": 0}),
        slow("a library with tables for 12", {"dining_table": 2, "chair": 12}),
        slow("a dining room seating ten", {"dining_table": 1, "chair": 10}),
        slow("a conference room with seating for 12", {"office_chair": 12}),
        slow("a classroom with two dozen desks", {"student_desk": 24}),
        slow("half a dozen stools at the bar", {"bar_stool": 6}),
        slow("a call center for 20 agents", {"desk": 20}),
        slow("a bedroom for a family of four", {"single_bed": 4}),
    ],
)
def test_a_plural_without_a_number_is_what_is_usual_or_what_so_many_need(text: str, counts: dict[str, int]) -> None:
    """Twenty desks for twenty had twenty chairs each; a cinema for forty was refused for its 3,454 things."""
    result = made(text)
    assert result.report.ok
    assert {kind: len(of(result, kind)) for kind in counts} == counts
