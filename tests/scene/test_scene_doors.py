"""Leaves of doors: how they hang is read, kept, and refused where it cannot be."""

from __future__ import annotations

import math

import pytest

from robolayout._errors import SceneError
from robolayout.scene import Leaf, Opening, Room, scene_from_dict, scene_to_dict
from robolayout.scene.room import OPENINGS

SQUARE = {"floor_vertices": [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]], "wall_height": 2.5}

CHAIR = {"chair-0": {"onFloor": True, "assetMetadata": {"boundingBox": {"x": 0.5, "y": 0.5, "z": 0.9}}}}


def scene(**leaf: object) -> dict[str, object]:
    return {"boundary": SQUARE, "doors": [{"wall": 0, "offset": 1.0, "width": 0.9, **leaf}], "assets": CHAIR}


def test_a_door_hangs_left_swings_out_and_is_shut_unless_it_says_otherwise() -> None:
    (door,) = scene_from_dict(scene()).room.doors
    assert (door.hinge, door.swing, door.open) == ("left", "out", False)
    (written,) = scene_to_dict(scene_from_dict(scene()))["doors"]  # type: ignore[misc]
    assert set(written) == {"wall", "offset", "width", "height"}


def test_what_a_door_says_of_its_leaf_comes_back() -> None:
    given = scene_from_dict(scene(hinge="right", swing="in", open=True))
    (door,) = given.room.doors
    assert (door.hinge, door.swing, door.open) == ("right", "in", True)
    assert scene_from_dict(scene_to_dict(given)).room == given.room


@pytest.mark.parametrize(
    ("leaf", "said"),
    [
        ({"hinge": "top"}, "hinge must be 'left' or 'right', but is 'top'"),
        ({"swing": "up"}, "swing must be 'in' or 'out', but is 'up'"),
        ({"swing": ["in"]}, r"swing must be 'in' or 'out', but is \['in'\]"),
        ({"open": "yes"}, "open must be true or false"),
    ],
)
def test_what_cannot_be_is_named(leaf: dict[str, object], said: str) -> None:
    with pytest.raises(SceneError, match=rf"doors\[0\].{said}"):
        scene_from_dict(scene(**leaf))


def test_a_leaf_that_swings_in_needs_its_own_depth_of_landing() -> None:
    room = Room(((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)), 2.5)

    def depth(**leaf: object) -> float:
        near, _, _, beyond = room.landing(Opening(0, 1.0, height=2.0, **leaf))  # type: ignore[arg-type]
        return math.dist(near, beyond)

    assert depth(width=1.2) == OPENINGS.landing_depth
    assert depth(width=1.2, swing="in") == pytest.approx(1.2)
    assert depth(width=1.6, swing="in") == pytest.approx(OPENINGS.landing_depth), "two leaves of 0.8 m"


@pytest.mark.parametrize(
    ("leaf", "hung"),
    [
        ({"hinge": "left", "swing": "out"}, [Leaf(1.9, -1, 0.9, -1)]),
        ({"hinge": "right", "swing": "out"}, [Leaf(1.0, 1, 0.9, -1)]),
        ({"hinge": "left", "swing": "in"}, [Leaf(1.9, -1, 0.9, 1)]),
        ({"hinge": "right", "swing": "in"}, [Leaf(1.0, 1, 0.9, 1)]),
        ({"width": 1.6}, [Leaf(1.0, 1, 0.8, -1), Leaf(2.6, -1, 0.8, -1)]),
        ({"width": 1.6, "hinge": "right", "swing": "in"}, [Leaf(1.0, 1, 0.8, 1), Leaf(2.6, -1, 0.8, 1)]),
    ],
)
def test_left_and_right_are_seen_from_inside_the_room(leaf: dict[str, object], hung: list[Leaf]) -> None:
    assert list(Opening(0, 1.0, **{"width": 0.9, "height": 2.0, **leaf}).hung()) == hung  # type: ignore[arg-type]


def test_a_room_takes_more_ground_where_a_leaf_swings_out() -> None:
    doors = (Opening(0, 1.0, 0.9, 2.0), Opening(1, 1.0, 1.6, 2.0), Opening(2, 1.0, 0.9, 2.0, swing="in"))
    room = Room(((0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)), 2.5, doors)
    assert room.extent() == pytest.approx((0.0, -0.9, 4.8, 3.0))
    assert room.extent(0.3) == pytest.approx((0.0, -0.6, 4.5, 3.0))
    assert room.extent(1.0) == room.bounds
