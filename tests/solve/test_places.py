"""Places that are tried: as many along a long wall as along one of 30 m."""

from __future__ import annotations

import itertools
from types import SimpleNamespace
from typing import Any

import pytest

from robolayout.scene import Room
from robolayout.solve.build.places import WALL_STEP, WALL_STEPS, _offsets


@pytest.mark.parametrize(("side", "step"), [(5.0, WALL_STEP), (30.0, WALL_STEP), (500.0, 500.0 / WALL_STEPS)])
def test_places_along_a_wall_are_bounded(side: float, step: float) -> None:
    room = Room(((0, 0), (side, 0), (side, side), (0, side)), 2.6)
    site: Any = SimpleNamespace(room=room, spans=())
    found = _offsets(site, room.walls[0], 1.0)
    assert len(found) <= WALL_STEPS + 3
    assert max(b - a for a, b in itertools.pairwise(found)) == pytest.approx(step, abs=2e-3)
