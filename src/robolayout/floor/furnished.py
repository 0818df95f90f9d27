"""The floor as a fine grid: what is outside, taken, or wanted by others."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout._grid import distance, window_count
from robolayout.floor.cells import Cells, Mask, cells_of
from robolayout.floor.config import FLOOR
from robolayout.scene import Room

Rect = tuple[float, float, float, float]
"""Smallest x, smallest y, largest x, largest y in metres."""
Points = NDArray[np.float64]
Window = tuple[slice, slice]
"""A part of the grid."""


@lru_cache(maxsize=4096)
def rect_points(rect: Rect, shrink: float, step: float = 0.1) -> Points:
    """Return points (k, 2) that cover a rectangle, `shrink` metres inside its edges."""
    axes: list[Points] = []
    for low, high in ((rect[0], rect[2]), (rect[1], rect[3])):
        inset = min(shrink, (high - low) / 2)
        count = max(2, math.ceil((high - low - 2 * inset) / step) + 1)
        axes.append(np.linspace(low + inset, high - inset, count))
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 2)
    points.flags.writeable = False
    return points


def placed(points: Points, x: float, y: float, yaw: float) -> Points:
    """Return points (k, 2) of a frame that was put at (x, y, yaw)."""
    c, s = np.cos(yaw), np.sin(yaw)
    found = np.empty_like(points)
    found[:, 0] = x + c * points[:, 0] - s * points[:, 1]
    found[:, 1] = y + s * points[:, 0] + c * points[:, 1]
    return found


@dataclass(frozen=True)
class Maps:
    """Flat maps of the floor for `Floor.under`, each 0 or 1 but the last."""

    taken: NDArray[np.float32]  # outside or under a body
    barred: NDArray[np.float32]  # the same or in a door's landing
    wanted: NDArray[np.float32]  # how much others want the cell to stay free, at most 2


@dataclass(frozen=True, eq=False)
class Shadow:
    """What a rectangle takes of the floor."""

    under: Window  # A part of the grid that holds it
    covered: Mask  # cells of that part under it
    around: Window  # A part that holds all from where it may count as the nearest thing
    near: NDArray[np.float64]  # cells from those of that part to the nearest one that is taken


@dataclass
class Floor:
    """The state of the floor while things are being placed."""

    room: Room
    cell: float  # size of a cell in metres
    xs: Points  # (nx,) cell centres in metres
    ys: Points  # (ny,) cell centres in metres
    origin: tuple[float, float]  # world point of the grid's corner
    inside: Mask  # cells in the room, (nx, ny)
    body: NDArray[np.int16]  # how many things stand on each cell
    wanted: NDArray[np.float32]  # how much each cell should stay free: landings and strips before furniture
    landing: Mask  # cells of the door landings
    door: Mask | None  # cells of the landing by which bodies come in, that of the first door; None without one
    # cells to the nearest one that is taken or outside; above `near` only known to be above it
    clear: NDArray[np.float64]
    near: float  # cells up to which `clear` is exact
    middle: tuple[float, float]  # world point of the cell in the room that is nearest to its middle
    _maps: Maps | None = field(default=None, init=False, repr=False)

    @staticmethod
    def of(room: Room, corridor: float, radius: float) -> Floor:
        """Return the empty floor of a room; doors want `corridor` metres of depth, bodies have at most `radius`."""
        xs, ys, cell = cells_of(room, FLOOR.planned_cell, FLOOR.planned_cells)
        origin = room.bounds[:2]
        inside = shapely.contains_xy(shapely.Polygon(room.vertices), *np.meshgrid(xs, ys, indexing="ij"))
        shape, near = inside.shape, radius / cell + 2.0
        floor = Floor(
            room,
            cell,
            xs,
            ys,
            origin,
            inside,
            np.zeros(shape, np.int16),
            np.zeros(shape, np.float32),
            np.zeros(shape, np.bool_),
            None,
            distance(np.pad(inside, 1), near)[1:-1, 1:-1],
            near,
            _middle(inside, cell, origin),
        )
        depth = max(corridor, FLOOR.door_depth if room.area < FLOOR.small_room else FLOOR.wide_door_depth)
        for door in reversed(room.doors):
            landing, wide = (floor.cells(np.array(room.landing(door, deep))) for deep in (None, radius + 2 * cell))
            floor.door = landing | wide  # a body wider than the landing is deep stands beyond it
            floor.landing |= landing
            floor.wanted[floor.cells(np.array(room.landing(door, depth)))] += FLOOR.door_want
        return floor

    def copy(self) -> Floor:
        """Return an independent copy."""
        return replace(self, body=self.body.copy(), wanted=self.wanted.copy(), clear=self.clear.copy())

    def shadow(self, corners: Points, *, flat: bool = False) -> Shadow:
        """Return what a rectangle with these corners (4, 2) takes of the floor; what is flat is in no body's way."""
        local = (corners - np.asarray(self.origin)) / self.cell - 0.5
        center, sides = local.mean(axis=0), local[1:3] - local[0:2]
        lengths = np.hypot(sides[:, 0], sides[:, 1])
        low = np.maximum(np.floor(local.min(axis=0) - self.near - 1), 0).astype(int)
        high = np.maximum(np.ceil(local.max(axis=0) + self.near + 2), 0).astype(int)
        window = (slice(low[0], high[0]), slice(low[1], high[1]))
        nx, ny = self.clear[window].shape
        dx, dy = np.arange(low[0], low[0] + nx)[:, None] - center[0], np.arange(low[1], low[1] + ny)[None] - center[1]
        out = [
            np.maximum(np.abs(dx * side[0] + dy * side[1]) / length - length / 2, 0.0)
            for side, length in zip(sides, lengths, strict=True)
        ]
        near = np.hypot(*out) + 0.5  # half a cell: from the edge to a taken cell's centre
        return Shadow(*self._covered(corners), window, np.full_like(near, np.inf) if flat else near)

    def take(self, shadow: Shadow) -> None:
        """Mark what a rectangle takes."""
        self.body[shadow.under] += shadow.covered
        window = self.clear[shadow.around]
        np.minimum(window, shadow.near, out=window)
        self._maps = None

    def want(self, points: Points, weight: float) -> None:
        """Mark the cells in the room around points (k, 2) that are 0.15 m apart as wanted, each once."""
        cells, on_grid = self.flat(points)
        mask = np.zeros_like(self.inside)
        mask.ravel()[cells[on_grid & self.inside.ravel()[cells]]] = True
        self.wanted[window_count(mask, 2 * max(1, round(0.075 / self.cell)) + 1) > 0] += weight
        self._maps = None

    def cells(self, polygon: Points) -> Mask:
        """Return the cells whose centres lie in a convex polygon (k, 2)."""
        mask = np.zeros(self.inside.shape, np.bool_)
        window, covered = self._covered(polygon)
        mask[window] = covered
        return mask

    def _covered(self, polygon: Points) -> tuple[Window, Mask]:
        """Return a part of the grid and its cells whose centres lie in a convex polygon (k, 2)."""
        low = np.maximum(np.floor((polygon.min(0) - self.origin) / self.cell).astype(int), 0)
        high = np.maximum(np.ceil((polygon.max(0) - self.origin) / self.cell).astype(int) + 1, 0)
        window = (slice(low[0], high[0]), slice(low[1], high[1]))
        nx, ny = self.inside[window].shape
        xs = (self.origin[0] + self.cell * (low[0] + np.arange(nx) + 0.5))[:, None]
        ys = (self.origin[1] + self.cell * (low[1] + np.arange(ny) + 0.5))[None]
        covered = np.ones((nx, ny), np.bool_)
        corners = polygon.tolist()
        for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True):
            covered &= (bx - ax) * (ys - ay) - (by - ay) * (xs - ax) >= 0
        return window, covered

    def flat(self, points: Points) -> tuple[Cells, Mask]:
        """Return the cells of points (k, 2), clipped to the grid, and whether each point is on it."""
        raw = np.floor((points - np.asarray(self.origin)) / self.cell).astype(np.intp)
        held = np.minimum(np.maximum(raw, 0), np.array(self.inside.shape) - 1)
        return held[:, 0] * self.inside.shape[1] + held[:, 1], (raw == held).all(axis=1)

    def under(self, points: Points, poses: NDArray[np.float64]) -> NDArray[np.intp]:
        """Return, for points (k, 2) in each of the frames (n, 3), flat indices (n, k) into the maps of `Maps`."""
        c, s = np.cos(poses[:, 2, None]) / self.cell, np.sin(poses[:, 2, None]) / self.cell
        x0 = (poses[:, 0, None] - self.origin[0]) / self.cell + 1.0
        y0 = (poses[:, 1, None] - self.origin[1]) / self.cell + 1.0
        nx, ny = self.inside.shape
        i = (x0 + c * points[:, 0] - s * points[:, 1]).clip(0, nx + 1.5).astype(np.intp)
        j = (y0 + s * points[:, 0] + c * points[:, 1]).clip(0, ny + 1.5).astype(np.intp)
        return i * (ny + 2) + j

    def maps(self) -> Maps:
        """Return the state of the floor as flat maps with a rim of one cell that is outside."""
        if self._maps is None:
            taken = np.pad(~self.inside | (self.body > 0), 1, constant_values=True)
            barred = taken | np.pad(self.landing, 1)
            wanted = np.minimum(np.pad(self.wanted, 1), 2.0)
            self._maps = Maps(*(grid.ravel().astype(np.float32) for grid in (taken, barred, wanted)))
        return self._maps


def _middle(inside: Mask, cell: float, origin: tuple[float, float]) -> tuple[float, float]:
    i, j = np.nonzero(inside)
    k = int(np.argmin((i - i.mean()) ** 2 + (j - j.mean()) ** 2))
    return (origin[0] + cell * (float(i[k]) + 0.5), origin[1] + cell * (float(j[k]) + 0.5))
