"""A square picture of the floor, 256 x 256, as published metrics draw it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from robolayout._grid import window_count
from robolayout.scene import Room
from robolayout.verify._boxes import room_polygon

PIXELS = 256  # pixels of a side


@dataclass(frozen=True, eq=False)
class Raster:
    """Pixel centres of a square around the middle of the room's bounds."""

    x: NDArray[np.float64]  # (256, 256) metres
    y: NDArray[np.float64]  # (256, 256) metres
    pixel: float  # side of a pixel in metres
    floor: NDArray[np.bool_]  # (256, 256) whether the centre is on the floor

    def mask(self, shape: BaseGeometry) -> NDArray[np.bool_]:
        """Return which pixel centres a shape covers."""
        result = np.zeros((PIXELS, PIXELS), dtype=np.bool_)
        if shape.is_empty:
            return result
        low_x, low_y, high_x, high_y = shape.bounds
        columns = slice(*np.searchsorted(self.x[0], (low_x, high_x + self.pixel)))
        rows = slice(*np.searchsorted(self.y[:, 0], (low_y, high_y + self.pixel)))
        shapely.prepare(shape)
        result[rows, columns] = shapely.intersects_xy(shape, self.x[rows, columns], self.y[rows, columns])
        return result

    def eroded_floor(self, width: float) -> NDArray[np.bool_]:
        """Return the floor eroded with a square kernel as wide as the robot."""
        side = max(1, round(width / self.pixel))
        return window_count(self.floor, side) == side**2


def raster(room: Room, margin: float) -> Raster:
    """Return the picture whose half side is the largest coordinate from the middle of the room, plus a margin in metres."""
    low_x, low_y, high_x, high_y = room.bounds
    center = ((low_x + high_x) / 2, (low_y + high_y) / 2)
    half = max(high_x - low_x, high_y - low_y) / 2 + margin
    pixel = 2 * half / PIXELS
    ticks = (np.arange(PIXELS, dtype=np.float64) + 0.5) * pixel - half
    x: NDArray[np.float64] = np.tile(center[0] + ticks, (PIXELS, 1))
    y: NDArray[np.float64] = np.tile((center[1] + ticks)[:, None], (1, PIXELS))
    blank = Raster(x, y, pixel, np.zeros((PIXELS, PIXELS), dtype=np.bool_))
    return replace(blank, floor=blank.mask(room_polygon(room)))
