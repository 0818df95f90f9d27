"""The floor that people can walk on while a room is built, on a grid: what a place takes of it, and what it cuts off."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout._grid import components
from robolayout.floor.cells import Cells, Floats, Mask, cells_of, entries
from robolayout.floor.config import FLOOR
from robolayout.scene import Room

Blocks = NDArray[np.intp]
"""(m, 4): low x, low y, high x, high y."""


class Walked:
    """The floor on which the centre of a disc can be, as far as it gets there from the first door."""

    def __init__(self, room: Room, radius: float) -> None:
        xs, ys, self._cell = cells_of(room, FLOOR.walked_cell, FLOOR.walked_cells)
        self._origin, self._radius = np.array(room.bounds[:2]), radius
        inner = shapely.Polygon(room.vertices).buffer(-radius)
        shapely.prepare(inner)
        free = np.asarray(shapely.contains_xy(inner, *np.meshgrid(xs, ys, indexing="ij")))
        self._entries = entries(room, xs, ys, free) + 1
        self._free = np.pad(free, 1)  # so that every place has a ring of cells around it
        self._sums = _sums(self._free)

    def copy(self) -> Walked:
        """Return the same floor, of which something else may be taken."""
        twin = copy.copy(self)
        twin._free = self._free.copy()
        return twin

    def cells(self, rects: Floats) -> Blocks:
        """Return the cells (m, 4) with their middle in rectangles (m, 4)."""
        rows, columns = self._free.shape
        found = np.empty(rects.shape, np.intp)
        found[:, :2] = np.ceil((rects[:, :2] - self._origin) / self._cell + 0.5)
        found[:, 2:] = np.floor((rects[:, 2:] - self._origin) / self._cell + 0.5) + 1
        found = np.minimum(np.maximum(found, 1), (rows - 1, columns - 1, rows - 1, columns - 1))
        found[:, 2:] = np.maximum(found[:, 2:], found[:, :2])
        return found

    def taken(self, bodies: Floats) -> Blocks:
        """Return the cells (m, 4) that bodies with these bounds (m, 4) and the way around them take."""
        return self.cells(bodies + self._radius * np.array((-1.0, -1.0, 1.0, 1.0)))

    def take(self, cells: Blocks) -> None:
        """Take cells (m, 4), and what they cut off, from those who walk."""
        whole = len(cells) == 1 and _pieces(_ring(self._free, *cells[0].tolist())) <= 1
        for x0, y0, x1, y1 in cells.tolist():
            self._free[x0:x1, y0:y1] = False
        if not whole:
            self._free = self._main(self._free)
        self._sums = _sums(self._free)

    def share(self, cells: Blocks) -> Floats:
        """Return which share of the cells (m, 4) of each place is floor to walk on now."""
        x0, y0, x1, y1 = cells.T
        return _count(self._sums, cells) / np.maximum((x1 - x0) * (y1 - y0), 1)

    def left(self, near: Blocks, cells: Blocks) -> NDArray[np.int32]:
        """Return how many cells to walk on are left of some (m, 4) when others (4,) or (m, 4) are taken."""
        low, high = np.maximum(near[:, :2], cells[..., :2]), np.minimum(near[:, 2:], cells[..., 2:])
        both = np.concatenate([low, high], axis=1)
        both[:, 2:] = np.maximum(both[:, 2:], both[:, :2])
        return _count(self._sums, near) - _count(self._sums, both)

    def cheapest(self, cells: Blocks, cost: Floats, near: Blocks, limit: float) -> int:
        """Return the cheapest place by its cost and by what it puts out of reach and cuts off, which `cost` then tells.

        Args:
            cells: (m, 4) what each place takes.
            cost: (m,) what else it costs; changed.
            near: (n, 4) the cells from which things are within reach.
            limit: Cost from which on no place is of any use.
        """
        near = near[_count(self._sums, near) > 0]
        looked_at: set[int] = set()
        while (best := int(cost.argmin())) not in looked_at and cost[best] < limit:
            looked_at.add(best)
            cost[best] += self._loss(cells[best], near)
        return best

    def _loss(self, cells: Cells, near: Blocks) -> float:
        """Return the cost of taking cells (4,): of what is out of reach then, of floor that is cut off, of shut doors."""
        x0, y0, x1, y1 = cells.tolist()
        ex, ey = self._entries.T
        shut = float(((ex >= x0) & (ex < x1) & (ey >= y0) & (ey < y1)).sum())
        if _pieces(_ring(self._free, x0, y0, x1, y1)) <= 1:
            return FLOOR.cut * shut + FLOOR.lost * float((self.left(near, cells) == 0).sum())
        rest = self._free.copy()
        rest[x0:x1, y0:y1] = False
        main = self._main(rest)
        cut_off = 1.0 - main.sum() / max(rest.sum(), 1)
        return FLOOR.cut * (shut + cut_off) + FLOOR.lost * float((_count(_sums(main), near) == 0).sum())

    def _main(self, free: Mask) -> Mask:
        """Return the piece of the floor that the first door leads to, or the largest if that is shut."""
        labels, sizes = components(free)
        if len(sizes) < 2:
            return free
        entered = int(labels[tuple(self._entries[0])]) if len(self._entries) else 0
        return labels == (entered or int(sizes.argmax()) + 1)


def _sums(free: Mask) -> NDArray[np.int32]:
    """Return how many cells hold below and to the left of each corner."""
    rows, columns = free.shape
    sums = np.zeros((rows + 1, columns + 1), np.int32)
    np.cumsum(free, axis=0, dtype=np.int32, out=sums[1:, 1:])
    np.cumsum(sums[1:, 1:], axis=1, out=sums[1:, 1:])
    return sums


def _count(sums: NDArray[np.int32], cells: Blocks) -> NDArray[np.int32]:
    """Return how many of the cells (m, 4) of each place hold."""
    x0, y0, x1, y1 = cells.T
    return sums[x1, y1] - sums[x0, y1] - sums[x1, y0] + sums[x0, y0]


def _ring(grid: NDArray[Any], x0: int, y0: int, x1: int, y1: int) -> NDArray[Any]:
    """Return the values right around cells, in order."""
    before, after = grid[x0 - 1, y0 - 1 : y1 + 1], grid[x1, y0 - 1 : y1 + 1]
    return np.concatenate([before, grid[x0:x1, y1], after[::-1], grid[x0:x1, y0 - 1][::-1]])


def _pieces(ring: Mask) -> int:
    """Return in how many pieces a closed ring of cells is free."""
    return int((ring & ~np.concatenate([ring[-1:], ring[:-1]])).sum())
