"""A square picture of the floor, 256 x 256, as published metrics draw it."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from robolayout._grid import Mask, window_count
from robolayout.scene import Room
from robolayout.verify._boxes import room_polygon

PIXELS = 256  # pixels of a side


class Raster:
    """Pixel centres of a square around the middle of the room's bounds.

    Half a side is the largest coordinate from there, plus a margin in metres.
    """

    def __init__(self, room: Room, margin: float) -> None:
        low_x, low_y, high_x, high_y = room.bounds
        half = max(high_x - low_x, high_y - low_y) / 2 + margin
        self.pixel = 2 * half / PIXELS  # side of a pixel in metres
        ticks = (np.arange(PIXELS) + 0.5) * self.pixel - half
        self.x, self.y = (low_x + high_x) / 2 + ticks, (low_y + high_y) / 2 + ticks  # (256,) metres each
        self.floor = self.mask(room_polygon(room))

    def mask(self, shape: BaseGeometry) -> Mask:
        """Return which pixel centres (256, 256) a shape covers, rows along y."""
        result = np.zeros((PIXELS, PIXELS), dtype=np.bool_)
        if shape.is_empty:
            return result
        low_x, low_y, high_x, high_y = shape.bounds
        columns = slice(*np.searchsorted(self.x, (low_x, high_x + self.pixel)))
        rows = slice(*np.searchsorted(self.y, (low_y, high_y + self.pixel)))
        shapely.prepare(shape)
        result[rows, columns] = shapely.intersects_xy(shape, self.x[columns], self.y[rows, None])
        return result

    def free(self, width: float, footprints: Iterable[BaseGeometry]) -> tuple[Mask, list[Mask]]:
        """Return where a robot so many metres wide may be, and what each footprint takes with half the robot around it.

        The floor is eroded with a square kernel as wide as the robot.
        """
        side = max(1, round(width / self.pixel))
        taken = [self.mask(footprint.buffer(width / 2)) for footprint in footprints]
        free: NDArray[np.bool_] = window_count(self.floor, side) == side**2
        for mask in taken:
            free &= ~mask
        return free, taken
