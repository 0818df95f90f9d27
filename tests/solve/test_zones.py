"""The bounds of things and of the floor that they need, against polygons and against what the judge looks at."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import strategies as st
from solve_rooms import BED, TABLE, problem_of, room_of

from robolayout.scene import Asset, Room
from robolayout.solve._zones import Zones

SQUARE = Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.5)
U_SHAPED = Room(((0, 0), (5, 0), (5, 4), (3, 4), (3, 1.5), (2, 1.5), (2, 4), (0, 4)), 2.5)
SLANTED = Room(((0, 0), (4, 0), (4, 3), (0, 4)), 2.5)
WARDROBE = Asset("wardrobe-0", "wardrobe", (0.6, 1.6, 2.1))
RUG = Asset("rug-0", "rug", (2.0, 1.4, 0.01))
AXIS, SIDE = st.floats(-1.0, 5.0), st.floats(0.05, 3.0)


def zones(*assets: Asset, room: Room = SQUARE) -> Zones:
    problem = problem_of(room_of(*assets, room=room))
    return Zones(problem, problem.scene.agents[0])


def test_what_a_thing_needs_lies_before_it() -> None:
    made = zones(WARDROBE, BED, RUG)
    poses = np.array([[2.0, 1.0, math.cos(math.pi / 2), math.sin(math.pi / 2)]])
    bx0, _, bx1, top = made.bodies(0, poses)[0]
    stands = made.stands(0, poses)[0]
    assert (stands[0], stands[1], stands[2]) == pytest.approx((bx0, top, bx1)), "it is used from the front"
    around = made.stands(1, poses)[0]
    assert (around[:2] < made.bodies(1, poses)[0, :2]).all(), "a bed from its sides"
    assert np.ptp(made.stands(2, poses)[0].reshape(2, 2), axis=0).max() == 0.0, "nobody needs to get to a rug"


def test_things_at_other_heights_do_not_meet() -> None:
    shelf = Asset("shelf-0", "wall shelf", (0.25, 0.8, 0.3), on_floor=False, on_wall=True)
    made = zones(TABLE, BED, RUG, shelf)
    assert made.level(0).tolist() == [True, True, False, False]
