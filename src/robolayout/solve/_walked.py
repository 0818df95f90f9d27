"""The floor that people can walk on while a room is built, on a grid: what a place takes of it, and whether it cuts it in two."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout._grid import components
from robolayout.scene import Room
from robolayout.solve.compile import Floats

GRID = 0.1
"""Metres per cell."""

CUT = 4.0
"""Cost of cutting the floor in two, or of shutting a door."""

CUTS = 24
"""Places of a thing of which this is looked at, the cheapest first."""

Cells = NDArray[np.intp]
"""(m, 4): low x, low y, high x, high y."""


class Walked:
    """The floor on which the centre of a disc can be.

    Args:
        room: The room, empty.
        radius: Of the disc, metres.
    """

    def __init__(self, room: Room, radius: float) -> None:
        x0, y0, x1, y1 = room.bounds
        self._origin, self._radius = np.array((x0, y0)), radius
        x, y = np.arange(x0 + GRID / 2, x1, GRID), np.arange(y0 + GRID / 2, y1, GRID)
        inner = shapely.Polygon(room.vertices).buffer(-radius)
        shapely.prepare(inner)
        free = np.asarray(shapely.contains_xy(inner, *np.meshgrid(x, y, indexing="ij")))
        self._free = np.pad(free, 1)  # so that every place has a ring of cells around it
        self._sums = _sums(self._free)
        self._entries = self._nearest(room)

    def _nearest(self, room: Room) -> NDArray[np.intp]:
        """Return the cells (doors, 2) to walk on that are nearest to where people come in."""
        free = np.argwhere(self._free)
        if not len(free) or not room.doors:
            return np.empty((0, 2), np.intp)
        middles = np.array([np.mean(room.landing(door), axis=0) for door in room.doors])
        ways = (free[None] - 0.5) * GRID + self._origin - middles[:, None]
        return free[np.hypot(*ways.T).argmin(axis=0)]

    def copy(self) -> Walked:
        """Return the same floor, of which something else may be taken."""
        twin = copy.copy(self)
        twin._free = self._free.copy()
        return twin

    def cells(self, bodies: Floats) -> Cells:
        """Return the cells (m, 4) that bodies with these bounds (m, 4) and the way around them take."""
        found = np.empty(bodies.shape, np.intp)
        found[:, :2] = np.floor((bodies[:, :2] - self._radius - self._origin) / GRID)
        found[:, 2:] = np.ceil((bodies[:, 2:] + self._radius - self._origin) / GRID)
        rows, columns = self._free.shape
        return np.minimum(np.maximum(found + 1, 1), (rows - 1, columns - 1, rows - 1, columns - 1))

    def take(self, cells: Cells) -> None:
        """Take cells (m, 4) from those who walk."""
        for x0, y0, x1, y1 in cells.tolist():
            self._free[x0:x1, y0:y1] = False
        self._sums = _sums(self._free)

    def share(self, cells: Cells) -> Floats:
        """Return which share of the cells (m, 4) of each place is floor to walk on now."""
        x0, y0, x1, y1 = cells.T
        taken = self._sums[x1, y1] - self._sums[x0, y1] - self._sums[x1, y0] + self._sums[x0, y0]
        return taken / np.maximum((x1 - x0) * (y1 - y0), 1)

    def cheapest(self, cells: Cells, cost: Floats) -> int:
        """Return the cheapest place; one that cuts the floor in two or shuts a door costs more, which `cost` then tells."""
        looked_at: set[int] = set()
        while True:
            best = int(cost.argmin())
            if best in looked_at or len(looked_at) == CUTS:
                return best
            looked_at.add(best)
            if self._cuts(*cells[best].tolist()):
                cost[best] += CUT

    def _cuts(self, x0: int, y0: int, x1: int, y1: int) -> bool:
        """Return whether taking cells cuts the floor in two or shuts a door."""
        ex, ey = self._entries.T
        if ((ex >= x0) & (ex < x1) & (ey >= y0) & (ey < y1)).any():
            return True
        if _pieces(_ring(self._free, x0, y0, x1, y1)) <= 1:
            return False
        left = self._free.copy()
        left[x0:x1, y0:y1] = False
        labels, _ = components(left)
        return len(set(_ring(labels, x0, y0, x1, y1).tolist()) - {0}) > 1


def _sums(free: NDArray[np.bool_]) -> NDArray[np.int32]:
    """Return how many cells hold below and to the left of each corner."""
    rows, columns = free.shape
    sums = np.zeros((rows + 1, columns + 1), np.int32)
    np.cumsum(free, axis=0, dtype=np.int32, out=sums[1:, 1:])
    np.cumsum(sums[1:, 1:], axis=1, out=sums[1:, 1:])
    return sums


def _ring(grid: NDArray[Any], x0: int, y0: int, x1: int, y1: int) -> NDArray[Any]:
    """Return the values right around cells, in order."""
    return np.concatenate(
        [
            grid[x0 - 1, y0 - 1 : y1 + 1],
            grid[x0:x1, y1],
            grid[x1, y0 - 1 : y1 + 1][::-1],
            grid[x0:x1, y0 - 1][::-1],
        ]
    )


def _pieces(ring: NDArray[np.bool_]) -> int:
    """Return in how many pieces a closed ring of cells is free."""
    return int((ring & ~np.concatenate([ring[-1:], ring[:-1]])).sum())
