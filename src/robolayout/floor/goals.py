"""Goals: what a body does not get to in a layout, on the grid, and where it would get to it at least cost.

A body with an arm moves chairs away from what they stand at; these bar no goal there.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout._geometry import Body, corners
from robolayout._grid import components
from robolayout.floor.cells import Cells, Floats, Mask
from robolayout.floor.config import FLOOR
from robolayout.floor.ground import Ground, box_distance, cells_about, clearance, used_from
from robolayout.floor.targets import Targets


def missed(ground: Ground, world: Floats, home: Mask) -> Cells:
    """Return the targets, by their rows, that are within reach neither from `home` nor from where a chair was moved away.

    `home` is where (nx, ny) the body gets to; nothing is opened where that is nowhere.
    """
    rows = np.arange(len(ground.targets.slots))
    if not home.any():
        return rows
    for stride in (FLOOR.coarse, 1):
        rows = _still(ground, world, home, rows, stride)
    if not len(rows) or not len(ground.targets.chairs):
        return rows
    at = _chairs_at(ground.targets, world, rows)
    kept = [rows[~at.any(axis=1)]]
    for some in np.unique(at[at.any(axis=1)], axis=0):
        others = ground.obstacles.without(ground.targets.chairs[some])
        regions, _ = components(ground.passable(clearance(ground, world, others)))
        opened = regions == regions[ground.start]
        kept.append(_still(ground, world, opened, rows[(at == some).all(axis=1)]))
    return np.sort(np.concatenate(kept))


def _still(ground: Ground, world: Floats, home: Mask, rows: Cells, stride: int = 1) -> Cells:
    """Return which of some targets are not within reach of any cell of `home`, looking at every so many cells."""
    met = [bool((near & home[here]).any()) for here, near in _near(ground, world, rows, stride)]
    return rows[~np.array(met, np.bool_)]


def _near(ground: Ground, world: Floats, rows: Cells, stride: int = 1) -> Iterator[tuple[tuple[slice, slice], Mask]]:
    """Yield the cells about each of some targets and from which of them it is within reach, half a cell to spare."""
    targets, xs, ys = ground.targets, ground.xs, ground.ys
    for row in rows.tolist():
        slot, carrier, reach = targets.slots[row], targets.carrier[row], float(targets.reach[row])
        i, j = cells_about(xs, ys, world[slot], targets.half[slot], reach, stride)
        at, spare = (xs[i, None], ys[j]), ground.cell / 2
        near = used_from(*at, world[slot], targets.half[slot], reach - spare, targets.sides[row])
        if carrier >= 0:
            near &= box_distance(*at, world[carrier], targets.half[carrier]) >= 0.0
        yield (i, j), near


def _chairs_at(targets: Targets, world: Floats, rows: Cells) -> Mask:
    """Return (r, c) which chairs stand at some targets, or at what carries these; none at a chair."""
    slots = targets.slots[rows]
    chairs, things = _feet(targets, world, targets.chairs), _feet(targets, world, slots)
    below = np.where(targets.parent[slots] >= 0, targets.parent[slots], slots)
    near = shapely.dwithin(things[:, None], chairs, FLOOR.chair_at)
    near |= shapely.dwithin(_feet(targets, world, below)[:, None], chairs, FLOOR.chair_at)
    return near & ~np.isin(slots, targets.chairs)[:, None]


def _feet(targets: Targets, world: Floats, slots: Cells) -> NDArray[np.object_]:
    """Return the outlines of some slots in plan."""
    boxes = Body(*np.hstack([world[slots], targets.half[slots], np.zeros((len(slots), 1))]).T)
    return np.asarray(shapely.polygons(np.stack(corners(boxes), axis=-1)), dtype=object)


def cheapest(ground: Ground, world: Floats, rows: Cells, cost: Floats) -> list[tuple[int, int]]:
    """Return for some targets the cell within reach that costs least to get to; none for what is never within reach."""
    goals: list[tuple[int, int]] = []
    for (i, j), near in _near(ground, world, rows):
        costs = np.where(near, cost[i, j], np.inf)
        if np.isfinite(costs).any():
            across, along = divmod(int(costs.argmin()), near.shape[1])
            goals.append((i.start + across, j.start + along))
    return goals
