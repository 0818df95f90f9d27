"""Where things stand under others: only where the judge finds them to touch nothing, in front where that has to be."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from robolayout.assets import CATALOGUE
from robolayout.assets.beneath import clearance, low_enough, places_beneath, with_room_below
from robolayout.scene import Asset, Layout, Pose, Room, Scene
from robolayout.verify.physics import physics

ROOM = Room(((0, 0), (9, 0), (9, 9), (0, 9)), 2.8)


def thing(kind: str, name: str = "low-0", **options: object) -> Asset:
    return replace(Asset(name, kind, CATALOGUE[kind].size), **options)


def touching(upper: Asset, lower: Asset, place: tuple[float, float, float]) -> int:
    x, y, yaw = place
    there = {upper.name: Pose(4.5, 4.5, upper.size[2] / 2, 0.0)}
    there |= {lower.name: Pose(4.5 + x, 4.5 + y, lower.size[2] / 2, yaw)}
    return len(physics(Scene(ROOM, (upper, lower)), Layout(there)).collisions)


@given(
    st.sampled_from(["desk", "dining table", "loft bed", "console table", "workbench", "bench", "kitchen counter"]),
    st.tuples(st.floats(0.1, 0.9), st.floats(0.1, 0.9), st.floats(0.1, 1.0)),
    st.integers(0, 10_000),
)
def test_what_stands_beneath_touches_nothing(kind: str, size: tuple[float, float, float], pick: int) -> None:
    upper, lower = thing(kind, "high-0"), Asset("low-0", "box", size)
    places = places_beneath(upper, lower)
    if places:
        place = places[pick % len(places)]
        assert touching(upper, lower, place) == 0
        assert size[2] <= clearance(upper, size[:2]) + 0.021


def test_nothing_stands_beneath_what_is_solid() -> None:
    assert not places_beneath(thing("kitchen counter", "high-0"), thing("dishwasher"))
    assert not places_beneath(thing("sofa", "high-0"), thing("trash can"))


def test_what_opens_to_its_front_stands_at_the_front() -> None:
    desk, fridge = thing("desk", "high-0"), low_enough(thing("mini fridge"), thing("desk"))
    x, _, yaw = places_beneath(desk, fridge)[0]
    assert yaw == 0.0 and math.isclose(x + fridge.size[0] / 2, desk.size[0] / 2, abs_tol=1e-6)


def test_a_counter_over_machines_is_a_worktop_as_wide_as_they_are() -> None:
    machines = [thing("washing machine"), thing("clothes dryer")]
    top = with_room_below(thing("kitchen counter", "high-0"), machines, 2)
    assert top.size[1] >= sum(one.size[1] for one in machines) and all(places_beneath(top, one) for one in machines)
    assert with_room_below(thing("dining table", "high-0"), [thing("trash can")], 1) == thing("dining table", "high-0")


@pytest.mark.parametrize(("kind", "smaller"), [("trash can", False), ("mini fridge", True), ("wardrobe", False)])
def test_what_is_a_little_too_large_is_smaller(kind: str, smaller: bool) -> None:
    found = low_enough(thing(kind), thing("desk", "high-0"))
    assert (found.size != thing(kind).size) is smaller
