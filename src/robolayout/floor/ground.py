"""The room on a grid as one body meets it: the floor, what stands in its way, and how far every cell is from that."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from robolayout._geometry import compose
from robolayout.assets.obstacles import pieces
from robolayout.floor.cells import Cells, Floats, Mask, cells_of, entries, turning_radius
from robolayout.floor.config import FLOOR
from robolayout.floor.targets import Contents, Targets, targets_of
from robolayout.scene import Agent


@dataclass(frozen=True, eq=False)
class Obstacles:
    """Rectangles that belong to things and go with these."""

    slot: NDArray[np.intp]  # (m,) slot that each rectangle belongs to
    offset: Floats  # (m, 4) pose (x, y, cos, sin) of the rectangle in the frame of its slot, metres
    half: Floats  # (m, 2) half its depth and half its width in metres

    def poses(self, world: Floats) -> Floats:
        """Return (m, 4) poses x, y, cos, sin of the rectangles."""
        return compose(world[self.slot], self.offset)

    def without(self, slots: Cells) -> Obstacles:
        """Return what is left when some slots are not there."""
        kept = ~np.isin(self.slot, slots)
        return Obstacles(self.slot[kept], self.offset[kept], self.half[kept])


@dataclass(frozen=True, eq=False)
class Ground:
    """The empty room on a grid, for one agent, and what will stand in its way there."""

    xs: Floats  # (nx,) cell centres in metres
    ys: Floats  # (ny,) cell centres in metres
    wall_distance: Floats  # (nx, ny) metres to the nearest wall; negative outside
    doors: Cells  # (doors, 2) cell where the agent comes in by each door; none where no cell holds it
    agent: Agent  # the body
    cell: float  # metres per cell
    targets: Targets  # what it must get to
    obstacles: Obstacles  # boxes, or the parts of them that it cannot pass
    shelter: Obstacles  # boxes that it may come under or into

    @property
    def start(self) -> tuple[int, int] | None:
        """Cell where the agent comes in by the first door; None where no cell holds it."""
        return (int(self.doors[0, 0]), int(self.doors[0, 1])) if len(self.doors) else None

    @property
    def open(self) -> Mask:
        """(nx, ny) whether the agent's centre could be there in the empty room."""
        return self.wall_distance >= self.agent.radius

    def passable(self, field: Floats) -> Mask:
        """Return where the agent's centre can be, given the clearance (nx, ny) that its obstacles leave."""
        return self.open & (field >= self.agent.radius - self.cell / 4)

    def around(self, points: Floats, reach: Floats) -> tuple[Ground, tuple[slice, slice]]:
        """Return the part of the room where things so far about some points keep the agent off, and which cells that is."""
        reach = reach + self.agent.radius + 2 * self.cell
        spans = [
            slice(*np.searchsorted(cells, ((middle - reach).min(), (middle + reach).max())).tolist())
            for cells, middle in ((self.xs, points[:, 0]), (self.ys, points[:, 1]))
        ]
        here = (spans[0], spans[1])
        return replace(self, xs=self.xs[here[0]], ys=self.ys[here[1]], wall_distance=self.wall_distance[here]), here


def make_ground(contents: Contents, agent: Agent, cell: float) -> Ground:
    """Return the empty room on a grid; large rooms get larger cells."""
    xs, ys, cell = cells_of(contents.scene.room, cell, FLOOR.route_cells)
    room = Polygon(contents.scene.room.vertices)
    points = np.asarray(shapely.points(*np.meshgrid(xs, ys, indexing="ij")))
    shapely.prepare(room)
    distance = shapely.distance(points, room.exterior)
    distance = np.where(shapely.contains(room, points), distance, -distance)
    free = distance >= agent.radius
    doors = entries(contents.scene.room, xs, ys, free)
    if free.any() and not len(doors):  # a room without a door is entered where there is most room
        doors = np.argwhere(distance == distance.max())[:1]
    heights = contents.heights.tolist()
    found = [pieces(asset, z, agent) for asset, z in zip(contents.scene.assets, heights, strict=True)]
    rows = np.concatenate([np.empty((0, 4)), *(rectangles for rectangles, _ in found)])
    slot = np.repeat(np.arange(len(found)), [len(rectangles) for rectangles, _ in found])
    square = np.tile([1.0, 0.0], (len(rows), 1))
    obstacles = Obstacles(slot, np.concatenate([rows[:, :2], square], axis=1), rows[:, 2:])
    under = np.flatnonzero([passable for _, passable in found])
    shelter = Obstacles(under, np.tile([0.0, 0.0, 1.0, 0.0], (len(under), 1)), contents.half[under])
    return Ground(xs, ys, distance, doors, agent, cell, targets_of(contents, agent), obstacles, shelter)


def clearance(ground: Ground, world: Floats, obstacles: Obstacles) -> Floats:
    """Return metres from every cell to the nearest obstacle, negative inside, capped a little above what the body needs."""
    cap = turning_radius(ground.agent) + FLOOR.spare
    field = np.full((len(ground.xs), len(ground.ys)), cap)
    for patch in patches(ground.xs, ground.ys, obstacles.poses(world), obstacles.half, cap):
        _, wide, high = patch.u.shape
        for i, j, distance in zip(patch.i[:, 0].tolist(), patch.j[:, 0].tolist(), patch.distance, strict=True):
            here = field[i : i + wide, j : j + high]
            np.minimum(here, distance, out=here)
    return field


@dataclass(frozen=True, eq=False)
class Patch:
    """The cells about some rectangles, and where they lie in the frames of these."""

    rows: Cells  # (k,) the rectangles
    i: Cells  # (k, w) cells in x
    j: Cells  # (k, h) cells in y
    u: Floats  # (k, w, h) metres ahead of the rectangle's middle
    v: Floats  # (k, w, h) metres to its left
    half: Floats  # (k, 2) half its depth and half its width in metres

    @property
    def distance(self) -> Floats:
        """(k, w, h) metres from the rectangle; negative inside."""
        return _outside(self.u, self.v, self.half.T[:, :, None, None])

    def used_from(self, reach: Floats | float, sides: Mask, cell: float) -> Mask:
        """Return from which cells (k, w, h) things are used: within reach, half a cell to spare, beyond one of their sides.

        Args:
            reach: Metres in plan; one figure, or (k,).
            sides: (k, 4) in the order of `SIDES`; none where a thing is used from all around.
            cell: Metres per cell.
        """
        near = self.distance <= np.reshape(reach, (-1, 1, 1)) - cell / 2
        whole = ~np.any(sides, axis=1, keepdims=True)
        if whole.all():
            return near
        (ahead, left), u, v = self.half.T[:, :, None, None], self.u, self.v
        beyond = np.broadcast_to(whole[:, :, None], u.shape)
        for number, outside in enumerate((u > ahead, v > left, u < -ahead, v < -left)):
            beyond = beyond | (sides[:, number, None, None] & outside)
        return near & beyond

    def of(self, field: NDArray[Any]) -> NDArray[Any]:
        """Return (k, w, h) what a field (nx, ny) says of the cells."""
        return field[self.i[:, :, None], self.j[:, None, :]]


def patches(
    xs: Floats, ys: Floats, poses: Floats, half: Floats, reach: Floats | float, stride: int = 1
) -> Iterator[Patch]:
    """Yield all cells within reach of the bounds of rectangles, and some more, rectangles of like size together.

    Args:
        xs: (nx,) cell centres in metres.
        ys: (ny,) cell centres in metres.
        poses: (m, 4) poses of the rectangles.
        half: (m, 2) half their depths and widths in metres.
        reach: Metres; one figure, or (m,).
        stride: Every how many cells, in x and in y.
    """
    (x, y), (c, s) = poses[:, :2].T, np.abs(poses[:, 2:].T)
    i, wide = _span(xs, x, c * half[:, 0] + s * half[:, 1] + reach, stride)
    j, high = _span(ys, y, s * half[:, 0] + c * half[:, 1] + reach, stride)
    order = np.lexsort((wide * high, wide > high))
    order = order[(wide * high)[order] > 0]
    block = np.cumsum((wide * high)[order]) // FLOOR.together
    for rows in np.split(order, np.flatnonzero(np.diff(block)) + 1) if len(order) else ():
        across, along = (
            _run(first[rows], int(count[rows].max()), size, stride)
            for first, count, size in ((i, wide, len(xs)), (j, high, len(ys)))
        )
        x, y, c, s = (value[:, None] for value in poses[rows].T)
        dx, dy = xs[across] - x, ys[along] - y
        u = (c * dx)[:, :, None] + (s * dy)[:, None, :]
        v = (c * dy)[:, None, :] - (s * dx)[:, :, None]
        yield Patch(rows, across, along, u, v, half[rows])


def _span(cells: Floats, middle: Floats, reach: Floats, stride: int) -> tuple[Cells, Cells]:
    """Return the first cell within reach of each middle, and how many there are, counting by the stride."""
    first, end = np.searchsorted(cells, middle - reach), np.searchsorted(cells, middle + reach)
    return first, -((first - end) // stride)


def _run(first: Cells, count: int, size: int, stride: int) -> Cells:
    """Return (k, count) cells from each first one on, from an earlier one where they would run out of the grid."""
    first = np.minimum(first, size - 1 - stride * (count - 1))
    return first[:, None] + stride * np.arange(count)


def box_distance(px: Floats, py: Floats, pose: Floats, half: Floats) -> Floats:
    """Return the signed distance in metres of points to a box; negative inside."""
    x, y, c, s = pose
    return _outside(c * (px - x) + s * (py - y), c * (py - y) - s * (px - x), half)


def _outside(u: Floats, v: Floats, half: Floats) -> Floats:
    """Return the signed distance of places in a box's frame to the box: negative inside, round about its corners."""
    u, v = np.abs(u) - half[0], np.abs(v) - half[1]
    distance = np.maximum(u, v)
    corner = np.minimum(u, v) > 0.0
    distance[corner] = np.hypot(u[corner], v[corner])
    return distance
