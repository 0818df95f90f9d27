"""Where rectangular bodies get to along and across the way in: no sideways slide for what drives, and hardly more than is proved."""

from __future__ import annotations

import math
import random
from dataclasses import replace

import numpy as np
import pytest
import shapely

from robolayout.floor.furnished import Floor
from robolayout.floor.lanes import either_way
from robolayout.scene import Asset, Layout, Opening, Pose, Room, Scene, load_agent
from robolayout.verify._boxes import boxes
from robolayout.verify._obstacles import obstacles
from robolayout.verify.driving import Lattice

ROOM = Room(((0, 0), (6, 0), (6, 5), (0, 5)), 2.5, doors=(Opening(0, 0.8, 1.0, 2.05),))
WHEELCHAIR = load_agent("wheelchair")


def furnished(room: Room, rects: list[tuple[float, float, float, float]]) -> tuple[Floor, Scene, Layout]:
    """Return a room with boxes between low and high corners: its floor, and it as a scene with a layout."""
    floor = Floor.of(room, 1.0, WHEELCHAIR.turning_circle / 2)
    assets = [Asset(f"box-{i}", "box", (x1 - x0, y1 - y0, 0.8)) for i, (x0, y0, x1, y1) in enumerate(rects)]
    poses = {
        asset.name: Pose((x0 + x1) / 2, (y0 + y1) / 2, 0.4, 0.0)
        for asset, (x0, y0, x1, y1) in zip(assets, rects, strict=True)
    }
    for x0, y0, x1, y1 in rects:
        floor.take(floor.shadow(np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])))
    return floor, Scene(room, tuple(assets)), Layout(poses)


def gets_to(ways: tuple[np.ndarray, np.ndarray], floor: Floor, x: float, y: float) -> tuple[bool, bool]:
    """Return whether a body gets to a point along and across its way in."""
    i, j = int(x / floor.cell), int(y / floor.cell)
    return bool(ways[0][i, j]), bool(ways[1][i, j])


def test_an_empty_room_is_driven_all_over() -> None:
    floor, *_ = furnished(ROOM, [])
    ways = either_way(floor, WHEELCHAIR)
    assert gets_to(ways, floor, 3.0, 2.5) == (True, True)
    assert gets_to(ways, floor, 0.7, 2.5) == (True, True)
    assert gets_to(ways, floor, 0.4, 2.5) == (False, False), "so near to the wall it could only come sideways"


def test_from_lane_to_lane_needs_room_to_swerve_unless_the_body_slides() -> None:
    """The way on is beside the way in, at the end of a corridor as wide as a swerve takes, or not."""

    def corridor(left: float, right: float) -> Floor:
        slot = [(0.0, 3.0, 1.2, 5.0), (2.1, 3.0, 6.0, 5.0)]
        return furnished(ROOM, [(0.0, 0.0, left, 3.0), (right, 0.0, 6.0, 3.0), *slot])[0]

    slides, there = replace(WHEELCHAIR, turning_radius=None), (1.64, 4.2)
    narrow, wide = corridor(0.9, 2.1), corridor(0.5, 2.4)
    assert gets_to(either_way(narrow, slides), narrow, *there)[0]
    assert gets_to(either_way(narrow, WHEELCHAIR), narrow, *there) == (False, False)
    assert gets_to(either_way(wide, WHEELCHAIR), wide, *there)[0]


def test_without_a_door_the_largest_part_counts() -> None:
    floor, *_ = furnished(replace(ROOM, doors=()), [(1.9, 0.0, 2.0, 5.0)])
    ways = either_way(floor, WHEELCHAIR)
    assert any(gets_to(ways, floor, 4.0, 2.5)) and not any(gets_to(ways, floor, 0.95, 2.5))


@pytest.mark.parametrize("seed", range(12))
def test_what_is_reached_is_proved_by_driving(seed: int) -> None:
    """The verifier's lattice, which shares no code with it, finds a way to within two of its cells of each such place."""
    rng = random.Random(seed)
    rects = list[tuple[float, float, float, float]]()
    for _ in range(7):
        x, y, depth, width = rng.uniform(0, 5), rng.uniform(1.7, 4.2), rng.uniform(0.3, 1.2), rng.uniform(0.3, 1.2)
        rects.append((x, y, min(x + depth, 6.0), min(y + width, 5.0)))
    floor, scene, layout = furnished(ROOM, rects)
    ways = either_way(floor, WHEELCHAIR)
    door = ROOM.walls[0].point(1.3, (WHEELCHAIR.length or 0.0) / 2 + 0.05)
    lattice = Lattice(ROOM, obstacles(boxes(scene, layout), WHEELCHAIR), WHEELCHAIR, door, math.pi / 2)
    cells = {  # at the door it may come in elsewhere, too
        name: [at for at in np.argwhere(way)[::97] if floor.ys[at[1]] > 1.2]
        for name, way in zip(("along", "across"), ways, strict=True)
    }

    def places(heading: float) -> list[tuple[str, bytes]]:
        wanted = "along" if abs(math.cos(heading)) < 1e-6 else "across" if abs(math.sin(heading)) < 1e-6 else None
        here = cells.get(wanted or "", [])
        return [(f"{wanted} {i},{j}", shapely.Point(floor.xs[i], floor.ys[j]).buffer(0.2).wkb) for i, j in here]

    asked = {name for heading in (0.0, math.pi / 2) for name, _ in places(heading)}
    assert len(asked) > 3
    missing = asked - lattice.reached(places)
    assert len(missing) <= 1, "its places are 0.1 m apart: a lane with less slack may be none of its own"
