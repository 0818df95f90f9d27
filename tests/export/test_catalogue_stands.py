"""Every record of the catalogue stands by itself, small or large: by its centre of mass, and for five seconds of gravity."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from robolayout.assets import CATALOGUE, parts
from robolayout.assets.mass import part_masses
from robolayout.export import settle
from robolayout.export._bodies import BODIES
from robolayout.scene import Asset, Layout, Pose, Room, Scene

EACH = 24
"""Things that stand in one hall, far apart."""
SIZES = (0.7, 0.83, 1.0, 1.2)
"""Factors of the typical size: a thing is no steadier because it is smaller."""
STANDING = [name for name, kind in CATALOGUE.items() if kind.on_floor or kind.on_object]
LEVEL = 0.005
"""Metres within which feet end at one height."""
TILT = np.radians(0.5)
"""By which each may be tilted before it falls."""


def scaled(size: tuple[float, float, float], factor: float) -> tuple[float, float, float]:
    depth, width, height = size
    return (depth * factor, width * factor, height * factor)


@pytest.mark.parametrize("name", STANDING)
def test_the_middle_of_every_mass_is_over_what_stands_on_the_floor(name: str) -> None:
    for factor in SIZES:
        asset = Asset("thing-0", name, scaled(CATALOGUE[name].size, factor))
        made, bottom = parts(asset), -asset.size[2] / 2
        low = [part.vertices for part in made if part.vertices[:, 2].min() < bottom + LEVEL]
        feet = [v[v[:, 2] < bottom + LEVEL + BODIES.foot * np.ptp(v[:, 2]), :2] for v in low]
        weights, middles = part_masses(made)
        x, y, z = weights @ middles / weights.sum()
        hull = shapely.MultiPoint(np.concatenate(feet)).convex_hull
        room = hull.boundary.distance(shapely.Point(x, y)) * (1 if hull.covers(shapely.Point(x, y)) else -1)
        assert room > np.tan(TILT) * (z - bottom), (factor, room)


@pytest.mark.slow
@pytest.mark.parametrize("factor", SIZES)
@pytest.mark.parametrize("start", range(0, len(STANDING), EACH))
def test_no_record_falls_over_by_itself(start: int, factor: float) -> None:
    names = STANDING[start : start + EACH]
    assets = tuple(Asset(f"thing-{i}", name, scaled(CATALOGUE[name].size, factor)) for i, name in enumerate(names))
    poses = {a.name: Pose(5.0 + 10.0 * i, 5.0, a.size[2] / 2, 0.0) for i, a in enumerate(assets)}
    hall = Room(((0.0, 0.0), (10.0 * EACH, 0.0), (10.0 * EACH, 10.0), (0.0, 10.0)), 6.0)
    found = settle(Scene(hall, assets), Layout(poses))
    fallen = {names[int(name.split("-")[1])]: motion for name, motion in found.motions.items() if not motion.stable}
    assert not fallen
