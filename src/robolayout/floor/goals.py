"""Goals: what a body does not get to in a layout, on the grid, and where it would get to it at least cost.

A body with an arm moves chairs away from what they stand at; these bar no goal there.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout._geometry import Body, corners
from robolayout._grid import components
from robolayout.floor.cells import Cells, Floats, Mask
from robolayout.floor.config import FLOOR
from robolayout.floor.ground import Ground, Patch, box_distance, clearance, patches
from robolayout.floor.targets import Targets


def missed(ground: Ground, world: Floats, passable: Mask, home: Mask) -> Cells:
    """Return the targets, by their rows, that are within reach neither from `home` nor from where a chair was moved away.

    `passable` is where (nx, ny) the body's centre can be, `home` where it gets to; nothing is opened where that is nowhere.
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
        there, chairs = rows[(at == some).all(axis=1)], ground.targets.chairs[some]
        opened = _opened(ground, world, chairs, (passable, home))
        kept.append(there if opened is None else _still(ground, world, opened, there))
    return np.sort(np.concatenate(kept))


def _opened(ground: Ground, world: Floats, chairs: Cells, spaces: tuple[Mask, Mask]) -> Mask | None:
    """Return where the body gets to once some chairs are moved away; None where that is nowhere new."""
    passable, home = spaces
    part, here = ground.around(world[chairs, :2], np.hypot(*ground.targets.half[chairs].T))
    if not home[here].any():
        return None
    free = part.passable(clearance(part, world, ground.obstacles.without(chairs)))
    if not (free & ~passable[here]).any():
        return None
    passable = passable.copy()
    passable[here] |= free
    regions, _ = components(passable)
    return regions == regions[ground.start]


def _still(ground: Ground, world: Floats, home: Mask, rows: Cells, stride: int = 1) -> Cells:
    """Return which of some targets are not within reach of any cell of `home`, looking at every so many cells."""
    met = np.zeros(len(ground.targets.slots), dtype=np.bool_)
    for patch, near in _near(ground, world, rows, stride):
        met[patch.rows] = (near & patch.of(home)).any(axis=(1, 2))
    return rows[~met[rows]]


def _near(ground: Ground, world: Floats, rows: Cells, stride: int = 1) -> Iterator[tuple[Patch, Mask]]:
    """Yield the cells about some targets and from which of them each is within reach, half a cell to spare."""
    targets = ground.targets
    slots = targets.slots[rows]
    for patch in patches(ground.xs, ground.ys, world[slots], targets.half[slots], targets.reach[rows], stride):
        patch = replace(patch, rows=rows[patch.rows])
        near = patch.used_from(targets.reach[patch.rows], targets.sides[patch.rows], ground.cell)
        for k, carrier in enumerate(targets.carrier[patch.rows].tolist()):
            if carrier >= 0:
                px, py = ground.xs[patch.i[k], None], ground.ys[None, patch.j[k]]
                near[k] &= box_distance(px, py, world[carrier], targets.half[carrier]) >= 0.0
        yield patch, near


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
    for patch, near in _near(ground, world, rows):
        costs = np.where(near, patch.of(cost), np.inf).reshape(len(near), -1)
        best = np.argmin(costs, axis=1)
        found = np.flatnonzero(np.isfinite(costs[np.arange(len(best)), best]))
        across, along = np.divmod(best[found], near.shape[2])
        goals += zip(patch.i[found, across].tolist(), patch.j[found, along].tolist(), strict=True)
    return goals
