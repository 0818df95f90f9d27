"""Drake and PyBullet themselves load SDF and URDF: poses, masses, joints, and rest, compared with MuJoCo's."""

from __future__ import annotations

import math
from importlib.util import find_spec
from pathlib import Path

import pytest
from benchmarks.simulators import SIMULATORS

from robolayout.export import export, settle
from robolayout.export._exporter import mass
from robolayout.scene import Layout, Scene

FREE = {"table_lamp-0", "dining_chair-0", "potted_plant-0"}
STILL = 0.002
"""Metres; PyBullet lifts everything by its margin of 1 mm."""


@pytest.mark.slow
@pytest.mark.parametrize("format", ["sdf", "urdf"])
@pytest.mark.parametrize("simulator", SIMULATORS)
def test_rooms_load_and_rest_as_in_mujoco(
    simulator: str, format: str, scene: Scene, layout: Layout, tmp_path: Path
) -> None:
    package, load = SIMULATORS[simulator]
    if find_spec(package) is None:
        pytest.skip(f"{simulator} is not installed: pip install {'drake' if package == 'pydrake' else package}")
    found = load(export(scene, layout, format, folder=tmp_path), 5.0)
    assert set(found.poses) == set(layout)
    for name, (x, y, z, yaw) in found.poses.items():
        pose = layout[name]
        assert (x, y, z) == pytest.approx((pose.x, pose.y, pose.z), abs=1e-5)
        assert math.remainder(yaw - pose.yaw, 2 * math.pi) == pytest.approx(0.0, abs=1e-5)
    assert set(found.masses) == FREE
    for name, weight in found.masses.items():
        assert weight == pytest.approx(mass(scene.by_name[name]), rel=1e-5)
    assert found.joints == 4
    assert max(found.moved.values()) < STILL
    still = settle(scene, layout, 5.0).motions
    assert max(abs(found.moved[name] - still[name].displacement) for name in FREE) < STILL
