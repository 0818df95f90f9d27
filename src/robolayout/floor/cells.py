"""What all grids of the floor share: where cells lie, where people come in, and which region a door leads to."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from robolayout.scene import Agent, Room

Floats = NDArray[np.float64]
Mask = NDArray[np.bool_]
Cells = NDArray[np.intp]


def cell_size(room: Room, finest: float, most: int) -> float:
    """Return the metres per cell of a room's grid: `finest`, in larger rooms such that there are no more than `most` cells."""
    x0, y0, x1, y1 = room.bounds
    return max(finest, math.sqrt((x1 - x0) * (y1 - y0) / most))


def cells_of(room: Room, finest: float, most: int) -> tuple[Floats, Floats, float]:
    """Return the middles of cells along x and along y, and their size in metres (see `cell_size`)."""
    x0, y0, x1, y1 = room.bounds
    cell = cell_size(room, finest, most)
    return np.arange(x0 + cell / 2, x1, cell), np.arange(y0 + cell / 2, y1, cell), cell


def entries(room: Room, xs: Floats, ys: Floats, free: Mask) -> Cells:
    """Return for each door the free cell (doors, 2) nearest to the middle of its landing; none where nothing is free."""
    cells = np.argwhere(free)
    if not len(cells) or not room.doors:
        return np.empty((0, 2), np.intp)
    middles = np.array([np.mean(room.landing(door), axis=0) for door in room.doors])
    ways = np.stack([xs[cells[:, 0]], ys[cells[:, 1]]], axis=1)[None] - middles[:, None]
    return cells[np.hypot(*ways.T).argmin(axis=0)]


def entered(labels: NDArray[np.int32], sizes: Cells, landing: Mask | None) -> int:
    """Return the region with most cells of a landing, the largest where there is no door; 0 where it leads nowhere."""
    count = sizes if landing is None else np.bincount(labels[landing], minlength=len(sizes) + 1)[1:]
    return 1 + int(np.argmax(count)) if count.any() else 0


def turning_radius(agent: Agent) -> float:
    """Return the radius in metres of the circle that must be free where a body turns, at least that of its disc."""
    return max(agent.radius, agent.turning_circle / 2)
