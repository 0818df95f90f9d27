"""Can each asset stand in the room at all, alone, at any heading?

A box at one heading fits where its centre keeps clear of every wall widened by the box (a Minkowski sum), so it fits at
that heading if anything of the floor is left. A box that fits at heading h holds a slightly smaller one that fits at h + d
too; if even the box shrunk for a whole interval of headings finds no place at its middle, none of the interval fits.
Intervals that may fit are halved, so no asset is refused that fits at a heading nobody thought of.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
import shapely

from robolayout._errors import SceneError
from robolayout._reading import LIMITS
from robolayout.scene.asset import Asset
from robolayout.scene.room import Room

LEEWAY = 0.01
"""Metres by which a box may stick out on each side: the tolerance of the boundary check (DESIGN section 4)."""
FINEST = math.radians(0.05)  # half an interval of headings, in radians, that is taken to fit if it cannot be ruled out


def check_fit(room: Room, assets: Iterable[Asset]) -> None:
    """Raise a SceneError for the first asset that is too large for the room."""
    work = LIMITS.tested_walls
    fitting: list[tuple[float, float]] = []
    for asset in assets:
        depth, width, height = asset.size
        if height > room.wall_height + LEEWAY:
            raise SceneError(
                f"asset {asset.name!r} is {height:.2f} m high, but the walls are {room.wall_height:.2f} m high; "
                "make it lower or the walls higher (sizes are in metres)."
            )
        short, long = sorted((depth, width))
        if work <= 0 or any(short <= a and long <= b for a, b in fitting):
            continue
        fits, used = _fits(room, depth, width)
        work -= used
        if not fits:
            raise SceneError(
                f"asset {asset.name!r} ({depth:.2f} x {width:.2f} m) is larger than the room: it fits at no heading; "
                "make it smaller or the room larger (sizes are in metres)."
            )
        fitting.append((short, long))


def _fits(room: Room, depth: float, width: float) -> tuple[bool, int]:
    """Return whether a box fits into the room at some heading, and how many walls were tested for it."""
    half = (max(depth / 2 - LEEWAY, LEEWAY / 2), max(width / 2 - LEEWAY, LEEWAY / 2))
    along = {round(math.atan2(w.direction[1], w.direction[0]) % (math.pi / 2), 9) for w in room.walls}
    for tried, heading in enumerate(sorted(h + quarter for h in along for quarter in (0, math.pi / 2)), start=1):
        if _fits_at(room, half, heading):
            return True, tried * len(room.walls)
    tried = 2 * len(along)
    eighth = math.pi / 16
    intervals = [((2 * i + 1) * eighth, eighth) for i in range(8)]
    while intervals:
        middle, reach = intervals.pop()
        tried += 1
        if not _fits_at(room, _shrunk(half, reach), middle):
            continue
        if reach < FINEST or tried * len(room.walls) > LIMITS.tested_walls or _fits_at(room, half, middle):
            return True, tried * len(room.walls)
        intervals += [(middle + reach / 2, reach / 2), (middle - reach / 2, reach / 2)]
    return False, tried * len(room.walls)


def _shrunk(half: tuple[float, float], reach: float) -> tuple[float, float]:
    """Return half sides of a box that lies in one of half sides `half` turned by any angle up to `reach` radians."""
    s, long, short = math.sin(reach), max(half), min(half)
    inner = min(long - short * s, short / (2 * s))
    return (inner, short - inner * s) if half[0] >= half[1] else (short - inner * s, inner)


def _fits_at(room: Room, half: tuple[float, float], heading: float) -> bool:
    """Return whether a box with half sides `half` fits at one heading."""
    c, s = math.cos(heading), math.sin(heading)
    corners = np.asarray(room.vertices) @ np.array([[c, -s], [s, c]])
    offsets = np.array([(half[0], half[1]), (half[0], -half[1]), (-half[0], -half[1]), (-half[0], half[1])])
    ends = np.stack([corners, np.roll(corners, -1, axis=0)], axis=1)
    hulls = shapely.convex_hull(shapely.multipoints((ends[:, :, None] + offsets).reshape(len(corners), 8, 2)))
    free = shapely.difference(shapely.Polygon(corners), shapely.union_all(hulls))
    return float(free.area) > 0.0
