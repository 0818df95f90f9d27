"""The room on a grid as one body meets it: the floor, what stands in its way, and how far every cell is from that."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from robolayout.assets.obstacles import pieces
from robolayout.floor.targets import Contents, Floats, Targets, targets_of
from robolayout.scene import Agent, Room

SPARE = 0.15
"""Metres of clearance beyond what the body needs that are still told apart."""

MOST_CELLS = 12_000
"""Cells of a grid: 30 m2 at 5 cm, 120 m2 at 10 cm."""

TOGETHER = 8192
"""Cells that are worked out as one array: larger ones take more time a cell."""

Cells = NDArray[np.intp]


@dataclass(frozen=True)
class Ground:
    """The empty room on a grid, for one agent.

    Attributes:
        xs: (nx,) cell centres in metres.
        ys: (ny,) cell centres in metres.
        wall_distance: (nx, ny) metres to the nearest wall; negative outside.
        start: Cell where the agent comes in; None where no cell holds it.
        agent: The body.
        cell: Metres per cell.
        targets: What it must get to.
    """

    xs: Floats
    ys: Floats
    wall_distance: Floats
    start: tuple[int, int] | None
    agent: Agent
    cell: float
    targets: Targets

    @property
    def open(self) -> NDArray[np.bool_]:
        """(nx, ny) whether the agent's centre could be there in the empty room."""
        return self.wall_distance >= self.agent.radius

    def passable(self, field: Floats) -> NDArray[np.bool_]:
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


def cell_size(room: Room, cell: float) -> float:
    """Return the metres per cell of a room's grid: as asked for, or more where there would be too many cells."""
    x0, y0, x1, y1 = room.bounds
    return max(cell, ((x1 - x0) * (y1 - y0) / MOST_CELLS) ** 0.5)


def make_ground(contents: Contents, agent: Agent, cell: float) -> Ground:
    """Return the empty room on a grid; large rooms get larger cells."""
    x0, y0, x1, y1 = contents.scene.room.bounds
    cell = cell_size(contents.scene.room, cell)
    xs, ys = np.arange(x0 + cell / 2, x1, cell), np.arange(y0 + cell / 2, y1, cell)
    room = Polygon(contents.scene.room.vertices)
    points = np.asarray(shapely.points(*np.meshgrid(xs, ys, indexing="ij")))
    shapely.prepare(room)
    distance = shapely.distance(points, room.exterior)
    distance = np.where(shapely.contains(room, points), distance, -distance)
    start = _entry(contents, agent, points, distance)
    return Ground(xs, ys, distance, start, agent, cell, targets_of(contents, agent))


def _entry(contents: Contents, agent: Agent, points: Floats, distance: Floats) -> tuple[int, int] | None:
    """Return the cell nearest to the first door that holds the agent's centre; the roomiest one without a door."""
    open_cells = distance >= agent.radius
    if not open_cells.any():
        return None
    if not contents.scene.room.doors:
        flat = int(np.argmax(distance))
    else:
        door = contents.scene.room.doors[0]
        wall = contents.scene.room.walls[door.wall]
        far = shapely.distance(points, shapely.Point(wall.point(door.center, max(0.45, agent.radius + 0.05))))
        flat = int(np.argmin(np.where(open_cells, far, np.inf)))
    return tuple(int(i) for i in np.unravel_index(flat, distance.shape))  # type: ignore[return-value]


@dataclass(frozen=True, eq=False)
class Obstacles:
    """What stands in one agent's way: boxes, or the parts of them that it cannot pass.

    Attributes:
        slot: (m,) slot that each rectangle belongs to.
        offset: (m, 2) metres from the slot's middle to the rectangle's, ahead and to the left.
        half: (m, 2) half its depth and half its width in metres.
        shelter: Slots that the agent may come under or into.
    """

    slot: NDArray[np.intp]
    offset: Floats
    half: Floats
    shelter: tuple[int, ...]

    def poses(self, world: Floats) -> Floats:
        """Return (m, 4) poses x, y, cos, sin of the rectangles."""
        pose = world[self.slot].astype(float)
        x, y, c, s = pose.T
        ahead, left = self.offset.T
        return np.stack([x + c * ahead - s * left, y + s * ahead + c * left, c, s], axis=1)

    def without(self, slots: Cells) -> Obstacles:
        """Return what is left when some slots are not there."""
        kept = ~np.isin(self.slot, slots)
        return Obstacles(self.slot[kept], self.offset[kept], self.half[kept], self.shelter)


def boxes_of(half: Floats, slots: tuple[int, ...]) -> Obstacles:
    """Return the whole boxes of some slots, given half the sizes (n, 2) of all."""
    index = np.array(slots, dtype=np.intp)
    return Obstacles(index, np.zeros((len(slots), 2)), half[index].reshape(-1, 2), ())


def obstacles_of(contents: Contents, agent: Agent) -> Obstacles:
    """Return what stands in this agent's way."""
    heights = contents.heights.tolist()
    found = [pieces(asset, z, agent) for asset, z in zip(contents.scene.assets, heights, strict=True)]
    rows = np.concatenate([np.empty((0, 4)), *(rectangles for rectangles, _ in found)])
    slot = np.repeat(np.arange(len(found)), [len(rectangles) for rectangles, _ in found])
    return Obstacles(slot, rows[:, :2], rows[:, 2:], tuple(i for i, (_, passable) in enumerate(found) if passable))


def clearance(ground: Ground, world: Floats, obstacles: Obstacles) -> Floats:
    """Return metres from every cell to the nearest obstacle, negative inside, capped a little above what the body needs."""
    agent = ground.agent
    cap = max(agent.radius, agent.circumradius, (agent.turning_diameter or 0.0) / 2) + SPARE
    field = np.full((len(ground.xs), len(ground.ys)), cap)
    for patch in patches(ground, obstacles.poses(world), obstacles.half, cap):
        _, wide, high = patch.u.shape
        for i, j, distance in zip(patch.i[:, 0].tolist(), patch.j[:, 0].tolist(), patch.distance, strict=True):
            here = field[i : i + wide, j : j + high]
            np.minimum(here, distance, out=here)
    return field


@dataclass(frozen=True, eq=False)
class Patch:
    """The cells about some rectangles, and where they lie in the frames of these.

    Attributes:
        rows: (k,) the rectangles.
        i: (k, w) cells in x.
        j: (k, h) cells in y.
        u: (k, w, h) metres ahead of the rectangle's middle.
        v: (k, w, h) metres to its left.
        half: (k, 2) half its depth and half its width in metres.
    """

    rows: Cells
    i: Cells
    j: Cells
    u: Floats
    v: Floats
    half: Floats

    @property
    def distance(self) -> Floats:
        """(k, w, h) metres from the rectangle; negative inside."""
        return _outside(self.u, self.v, self.half.T[:, :, None, None])

    def of(self, field: NDArray[Any]) -> NDArray[Any]:
        """Return (k, w, h) what a field (nx, ny) says of the cells."""
        return field[self.i[:, :, None], self.j[:, None, :]]


def patches(ground: Ground, poses: Floats, half: Floats, reach: Floats | float, stride: int = 1) -> Iterator[Patch]:
    """Yield all cells within reach of the bounds of rectangles, and some more, rectangles of like size together.

    Args:
        ground: The room on a grid.
        poses: (m, 4) poses of the rectangles.
        half: (m, 2) half their depths and widths in metres.
        reach: Metres; one figure, or (m,).
        stride: Every how many cells, in x and in y.
    """
    (x, y), (c, s) = poses[:, :2].T, np.abs(poses[:, 2:].T)
    i, wide = _span(ground.xs, x, c * half[:, 0] + s * half[:, 1] + reach, stride)
    j, high = _span(ground.ys, y, s * half[:, 0] + c * half[:, 1] + reach, stride)
    order = np.lexsort((wide * high, wide > high))
    order = order[(wide * high)[order] > 0]
    block = np.cumsum((wide * high)[order]) // TOGETHER
    for rows in np.split(order, np.flatnonzero(np.diff(block)) + 1) if len(order) else ():
        across, along = (
            _run(first[rows], int(count[rows].max()), size, stride)
            for first, count, size in ((i, wide, len(ground.xs)), (j, high, len(ground.ys)))
        )
        x, y, c, s = (value[:, None] for value in poses[rows].T)
        dx, dy = ground.xs[across] - x, ground.ys[along] - y
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
