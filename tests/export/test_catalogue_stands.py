"""Every record of the catalogue stands for five seconds of gravity by itself."""

from __future__ import annotations

import pytest

from robolayout.assets import CATALOGUE
from robolayout.export import settle
from robolayout.scene import Asset, Layout, Pose, Room, Scene

EACH = 24
"""Things that stand in one hall, far apart."""
ROCKS = 0.09
"""Radians by which what stands on runners may rock before it rests."""
STANDING = [name for name, kind in CATALOGUE.items() if kind.on_floor or kind.on_object]


@pytest.mark.slow
@pytest.mark.parametrize("start", range(0, len(STANDING), EACH))
def test_no_record_falls_over_by_itself(start: int) -> None:
    names = STANDING[start : start + EACH]
    assets = tuple(Asset(f"thing-{i}", name, CATALOGUE[name].size) for i, name in enumerate(names))
    poses = {a.name: Pose(5.0 + 10.0 * i, 5.0, a.size[2] / 2, 0.0) for i, a in enumerate(assets)}
    hall = Room(((0.0, 0.0), (10.0 * EACH, 0.0), (10.0 * EACH, 10.0), (0.0, 10.0)), 6.0)
    found = settle(Scene(hall, assets), Layout(poses))
    fallen = {names[int(name.split("-")[1])]: motion for name, motion in found.motions.items() if not motion.stable}
    rocking = {name for name, motion in fallen.items() if name.startswith("rocking") and motion.tilt < ROCKS}
    assert not set(fallen) - rocking
