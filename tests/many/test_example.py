"""The example environment: every reset is another certified room, and a body drives in it to what it is said to reach."""

from __future__ import annotations

import importlib.util
from types import ModuleType

import numpy as np
import pytest

from running import ROOT

pytest.importorskip("mujoco")


@pytest.fixture(scope="module")
def example() -> ModuleType:
    spec = importlib.util.spec_from_file_location("room_env", ROOT / "examples" / "room_env.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_a_body_drives_along_a_certified_route_without_a_bump(example: ModuleType) -> None:
    env = example.RoomEnv({"rooms": ["bathroom"], "bodies": ["turtlebot4"], "count": 4})
    seen, info = env.reset(seed=1)
    again, _ = env.reset(seed=1)
    assert seen.shape == again.shape == (3 + example.RAYS,) and info["room"] == 1 and np.all(seen[3:] > 0)
    total, there, late = 0.0, False, False
    while not (there or late):
        _, reward, there, late, told = env.step(example.along(env))
        assert not told["bumped"]
        total += reward
    assert there and total > 10.0


def test_walls_and_things_stop_it(example: ModuleType) -> None:
    env = example.RoomEnv({"rooms": ["bathroom"], "bodies": ["turtlebot4"], "count": 4})
    env.reset(seed=0)
    places = []
    for _ in range(200):
        env.step(np.array([1.0, 0.0]))
        places.append(env.place)
    low_x, low_y, high_x, high_y = env.rooms[0].scene.room.bounds
    assert np.array_equal(places[-1], places[-2]) and low_x < env.place[0] < high_x and low_y < env.place[1] < high_y
