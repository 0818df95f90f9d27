"""A small furnished bedroom, and the comparison with golden pictures."""

from __future__ import annotations

import math
import os
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from robolayout.render import PlanMarks
from robolayout.scene import Agent, Asset, Layout, Opening, Pose, Room, Scene, Snapshot, Trace

GOLDEN = Path(__file__).parent.parent / "golden"


def pose(x, y, z, degrees):
    return Pose(x, y, z, math.radians(degrees))


@pytest.fixture(scope="session")
def room():
    return Room(
        ((0, 0), (4, 0), (4, 5), (0, 5)),
        2.6,
        doors=(Opening(0, 2.9, 0.9, 2.05),),
        windows=(Opening(2, 1.0, 1.4, 1.2, 0.9),),
    )


@pytest.fixture(scope="session")
def bedroom(room):
    assets = (
        Asset("bed-0", "bed", (2.1, 1.6, 0.9)),
        Asset("night_stand-0", "night stand", (0.4, 0.45, 0.5)),
        Asset("night_stand-1", "night stand", (0.4, 0.45, 0.5)),
        Asset("table_lamp-0", "table lamp", (0.25, 0.25, 0.4), on_floor=False, on_object=True),
        Asset("wardrobe-0", "wardrobe", (0.6, 1.6, 2.1)),
        Asset("rug-0", "rug", (1.6, 2.2, 0.02)),
        Asset("picture-0", "picture", (0.04, 0.8, 0.6), on_floor=False, on_wall=True),
        Asset("ceiling_lamp-0", "ceiling lamp", (0.4, 0.4, 0.3), on_floor=False, on_ceiling=True),
    )
    agent = Agent("walker", 0.35, 1.5, title="adult with a walker")
    return Scene(room, assets, agents=(agent,), name="bedroom")


@pytest.fixture(scope="session")
def layout():
    return Layout(
        {
            "bed-0": pose(1.1, 3.0, 0.45, 0),
            "night_stand-0": pose(0.25, 1.9, 0.25, 0),
            "night_stand-1": pose(0.25, 4.1, 0.25, 0),
            "table_lamp-0": pose(0.25, 1.9, 0.7, 0),
            "wardrobe-0": pose(3.68, 2.6, 1.05, 180),
            "rug-0": pose(1.9, 3.0, 0.01, 0),
            "picture-0": pose(0.03, 3.0, 1.7, 0),
            "ceiling_lamp-0": pose(2.0, 1.2, 2.45, 0),
        }
    )


@pytest.fixture(scope="session")
def marks():
    free = ((0.35, 0.35), (3.65, 0.35), (3.65, 1.4), (0.8, 1.4), (0.8, 1.0), (0.35, 1.0))
    hole = ((1.5, 0.6), (2.0, 0.6), (2.0, 0.9), (1.5, 0.9))
    return PlanMarks(
        free=((free, hole),),
        islands=((((2.6, 4.2), (3.4, 4.2), (3.4, 4.6), (2.6, 4.6)),),),
        routes={"wardrobe-0": ((3.3, 0.4), (3.0, 1.0), (2.9, 1.4)), "bed-0": ((3.3, 0.4), (2.2, 1.4))},
        passages=(((2.15, 2.6), (3.38, 2.6), 1.23),),
        blocked=("night_stand-1",),
        agent_at=(3.3, 0.4),
    )


@pytest.fixture(scope="session")
def trace():
    losses = tuple(
        {"overlap": 2.0 / (k + 1), "boundary": -0.1 * 0.9**k, "total": 2.0 / (k + 1) + 0.02} for k in range(60)
    )
    losses = losses[:20] + tuple({"overlap": step["overlap"], "total": step["total"]} for step in losses[20:])
    snapshots = tuple(
        Snapshot(
            k, "search" if k < 30 else "polish", {"bed-0": (1.0 + 0.01 * k, 3.0, 0.02 * k), "rug-0": (2.0, 3.0, 0.0)}
        )
        for k in range(60)
    )
    return Trace(losses, snapshots)


@pytest.fixture
def golden():
    return compare_with_golden


def compare_with_golden(image: Image.Image, name: str, *, mean: float = 1.0, share: float = 0.01) -> None:
    """Compare with tests/golden/NAME.png; on failure keep both pictures in tests/golden/failed.

    `mean` is the largest mean difference of a channel (of 255), `share` that of pixels that differ by more than 32.
    ROBOLAYOUT_UPDATE_GOLDEN=1 writes the golden pictures anew.
    """
    path = GOLDEN / f"{name}.png"
    if os.environ.get("ROBOLAYOUT_UPDATE_GOLDEN") == "1":
        image.save(path, optimize=True)
    expected = Image.open(path).convert("RGB")
    actual = image.convert("RGB")
    problem = f"size {actual.size}, golden {expected.size}" if actual.size != expected.size else ""
    if not problem:
        difference = np.abs(np.asarray(actual, dtype=int) - np.asarray(expected, dtype=int))
        differing = (difference.max(axis=2) > 32).mean()
        if difference.mean() > mean or differing > share:
            problem = f"mean difference {difference.mean():.2f} (at most {mean}), {differing:.2%} of pixels differ"
    if problem:
        failed = GOLDEN / "failed"
        failed.mkdir(exist_ok=True)
        actual.save(failed / f"{name}.actual.png")
        expected.save(failed / f"{name}.expected.png")
        pytest.fail(f"{name}: {problem}; see tests/golden/failed")
