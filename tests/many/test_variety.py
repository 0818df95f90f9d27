"""Laws of the difference of two rooms."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from robolayout.many.variety import VARIETY, Plan, Thing, nearest

number = st.floats(-5, 5).map(lambda value: round(value, 2))
thing = st.tuples(st.sampled_from(["chair", "desk", "bed"]), number, number, number)
room = st.lists(thing, max_size=8)


def turned(things: list[Thing]) -> list[Thing]:
    return [(kind, -y, x, yaw + math.pi / 2) for kind, x, y, yaw in things]


def mirrored(things: list[Thing]) -> list[Thing]:
    return [(kind, -x, y, math.pi - yaw) for kind, x, y, yaw in things]


@given(room, room)
def test_it_is_a_share_and_never_below_its_bound(a: list[Thing], b: list[Thing]) -> None:
    one, other = Plan(a), Plan(b)
    assert 0.0 <= one.least(other) <= one.difference(other) <= 1.0
    assert one.least(other) == other.least(one)


@given(room)
def test_a_room_is_like_itself_turned_and_mirrored(things: list[Thing]) -> None:
    plan = Plan(things)
    for seen in (things, turned(things), mirrored(things), turned(turned(mirrored(things)))):
        assert plan.difference(Plan(seen)) == pytest.approx(0.0)


def test_what_moved_turned_or_is_another_kind_has_no_counterpart() -> None:
    before = [("bed", 1.0, 0.0, 0.0), ("desk", -1.0, 1.0, 0.0), ("chair", -1.0, 0.5, 1.0), ("lamp", 0.3, 2.0, 0.0)]
    for after, difference in (
        (("bed", 1.0, VARIETY.near * 0.9, 0.0), 0.0),
        (("bed", 1.0, VARIETY.near * 1.1, 0.0), 0.25),
        (("bed", 1.0, 0.0, 0.5), 0.25),
        (("sofa", 1.0, 0.0, 0.0), 0.25),
    ):
        assert Plan(before).difference(Plan([after, *before[1:]])) == pytest.approx(difference)
    assert Plan(before).difference(Plan([])) == 1.0
    assert Plan([]).difference(Plan([])) == 0.0 < VARIETY.least


def test_the_nearest_of_several() -> None:
    rooms = [[("bed", float(i), 0.0, 0.0), ("desk", 0.0, 0.0, 0.0)] for i in range(4)]
    others = [(i, Plan(room)) for i, room in enumerate(rooms)]
    assert nearest(Plan(rooms[2]), others) == (0.0, 2)
    assert nearest(Plan([("bed", 9.0, 0.0, 0.0), ("desk", 0.0, 0.0, 0.0)]), others) == (0.5, 0)
    assert nearest(Plan(rooms[0]), []) == (1.0, -1)
    assert nearest(Plan(rooms[0]), [(7, Plan([("sofa", 0.0, 0.0, 0.0)]))]) == (1.0, -1)
