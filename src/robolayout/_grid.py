"""Connected components, distances and windows on grids of cells.

The same as `scipy.ndimage` gives (a test compares them); importing that costs a third of a second of every run.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

Mask = NDArray[np.bool_]

SHORT = 100  # cells up to which squared distances fit in 16 bits, which are twice as fast
CHECK = 4  # steps between two looks whether all distances are final


def components(mask: Mask) -> tuple[NDArray[np.int32], NDArray[np.intp]]:
    """Return the 8-connected components where `mask` (m, n) holds: labels (m, n) from 1 in row order, 0 outside; and their cell counts."""
    rows, columns = mask.shape
    width = columns + 2  # a gap before and after each row keeps runs apart
    line = np.zeros((rows, width), dtype=np.bool_)
    line[:, 1:-1] = mask
    line = line.ravel()
    edges = np.flatnonzero(line[1:] != line[:-1]) + 1
    start, stop = edges[::2], edges[1::2]
    low = np.searchsorted(stop, start + width, side="left")  # runs of the next row that touch, corners included
    high = np.searchsorted(start, stop + width, side="right")
    count = np.maximum(high - low, 0)
    above = np.repeat(np.arange(len(start)), count)
    below = np.arange(len(above)) - np.repeat(np.cumsum(count) - count, count) + np.repeat(low, count)
    root = joined(len(start), above, below)
    first = root == np.arange(len(root))  # roots are first runs, so their order is row order
    number = np.cumsum(first)[root]
    numbers = np.zeros(2 * len(start) + 1, dtype=np.int32)  # of gaps and runs in turn
    numbers[1::2] = number
    labels = np.repeat(numbers, np.diff(edges, prepend=0, append=len(line)))
    sizes = np.bincount(number, stop - start, minlength=1)[1:].astype(np.intp)
    return labels.reshape(rows, width)[:, 1:-1], sizes


def joined(size: int, a: NDArray[np.intp], b: NDArray[np.intp]) -> NDArray[np.intp]:
    """Return for each of `size` things the smallest one joined to it by the pairs (a, b)."""
    root = np.arange(size)
    while True:
        smaller = np.minimum(root[a], root[b])
        if np.array_equal(smaller, root[a]) and np.array_equal(smaller, root[b]):
            return root
        np.minimum.at(root, root[a], smaller)
        np.minimum.at(root, root[b], smaller)
        while not np.array_equal(root, root[root]):
            root = root[root]


def distance(mask: Mask, limit: float = math.inf) -> NDArray[np.float64]:
    """Return for each cell (m, n) the distance in cells to the nearest one where `mask` does not hold.

    Where it holds everywhere, all distances are infinite. Distances above `limit` cells are only known to be above it.
    """
    rows, columns = mask.shape
    kind, far = (np.int16, 127) if limit <= SHORT else (np.int32, 1 << 14)
    row = np.arange(rows, dtype=np.int32)[:, None]
    before = np.maximum.accumulate(np.where(mask, np.int32(-far), row), axis=0)
    after = np.minimum.accumulate(np.where(mask, np.int32(far + rows), row)[::-1], axis=0)[::-1]
    across = np.minimum(np.minimum(row - before, after - row), far).astype(kind)
    across *= across
    best = across.copy()
    aside = np.empty_like(across)
    for step in range(1, columns):
        if step > limit or (step % CHECK == 0 and step * step >= best.max()):
            break
        np.add(across, kind(step * step), out=aside)
        np.minimum(best[:, step:], aside[:, :-step], out=best[:, step:])
        np.minimum(best[:, :-step], aside[:, step:], out=best[:, :-step])
    return np.where(best < far * far, np.sqrt(best, dtype=np.float64), np.inf)


def within(mask: Mask, radius: float) -> Mask:
    """Return the cells (m, n) at most `radius` cells away from one where `mask` holds, itself among them."""
    (rows, columns), rim = mask.shape, int(radius)
    width = columns + rim  # a gap after each row, so that a step aside never gets into another one
    start, stop = rim * width, (rim + rows) * width
    given = np.zeros((rows + 2 * rim) * width, np.bool_)
    given[start:stop].reshape(rows, width)[:, :columns] = mask
    column, found = given.copy(), np.zeros_like(given)
    spread = 0
    for aside in range(rim, -1, -1):
        height = int(math.sqrt(max(radius**2 - aside**2, 0.0)))
        for step in range((spread + 1) * width, (height + 1) * width, width):
            column[start:stop] |= given[start - step : stop - step]
            column[start:stop] |= given[start + step : stop + step]
        spread = height
        found[start:stop] |= column[start - aside : stop - aside]
        found[start:stop] |= column[start + aside : stop + aside]
    return found[start:stop].reshape(rows, width)[:, :columns]


def window_count(mask: Mask, side: int) -> NDArray[np.intp]:
    """Return how many cells hold in the window of `side` cells about each cell; outside the grid none does."""
    before, after = side // 2, side - 1 - side // 2
    total = np.pad(mask, ((before + 1, after), (before + 1, after))).astype(np.intp).cumsum(axis=0).cumsum(axis=1)
    return total[side:, side:] - total[:-side, side:] - total[side:, :-side] + total[:-side, :-side]
