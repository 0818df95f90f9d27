"""The room on a grid as one body meets it: the floor, what stands in its way, and how far every cell is from that."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from robolayout._geometry import Body, compose, extents
from robolayout.assets.obstacles import pieces
from robolayout.floor.cells import Cells, Floats, Mask, cells_of, entries, turning_radius
from robolayout.floor.config import FLOOR
from robolayout.floor.targets import RoomContents, Targets, targets_of
from robolayout.scene import Agent


@dataclass(frozen=True, eq=False)
class FloorObstacles:
    """Rectangles that belong to things and go with these."""

    slot: NDArray[np.intp]  # (m,) slot that each rectangle belongs to
    offset: Floats  # (m, 4) pose (x, y, cos, sin) of the rectangle in the frame of its slot, metres
    half: Floats  # (m, 2) half its depth and half its width in metres

    def poses(self, world: Floats) -> Floats:
        """Return (m, 4) poses x, y, cos, sin of the rectangles."""
        return compose(world[self.slot], self.offset)

    def without(self, slots: Cells) -> FloorObstacles:
        """Return what is left when some slots are not there."""
        kept = ~np.isin(self.slot, slots)
        return FloorObstacles(self.slot[kept], self.offset[kept], self.half[kept])


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
    obstacles: FloorObstacles  # boxes, or the parts of them that it cannot pass
    shelter: FloorObstacles  # boxes that it may come under or into

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


def make_ground(contents: RoomContents, agent: Agent, cell: float) -> Ground:
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
    obstacles = FloorObstacles(slot, np.concatenate([rows[:, :2], square], axis=1), rows[:, 2:])
    under = np.flatnonzero([passable for _, passable in found])
    shelter = FloorObstacles(under, np.tile([0.0, 0.0, 1.0, 0.0], (len(under), 1)), contents.half[under])
    return Ground(xs, ys, distance, doors, agent, cell, targets_of(contents, agent), obstacles, shelter)


def clearance(ground: Ground, world: Floats, obstacles: FloorObstacles) -> Floats:
    """Return metres from every cell to the nearest obstacle, negative inside, capped a little above what the body needs."""
    cap = turning_radius(ground.agent) + FLOOR.spare
    field = np.full((len(ground.xs), len(ground.ys)), cap)
    for pose, half in zip(obstacles.poses(world), obstacles.half, strict=True):
        i, j = cells_about(ground.xs, ground.ys, pose, half, cap)
        distance = box_distance(ground.xs[i, None], ground.ys[j], pose, half)
        np.minimum(field[i, j], distance, out=field[i, j])
    return field


def cells_about(
    xs: Floats, ys: Floats, pose: Floats, half: Floats, reach: float, stride: int = 1
) -> tuple[slice, slice]:
    """Return the cells in x and in y within so many metres of the bounds of a box (4,), or every so many of them."""
    x, y, c, s = pose
    ex, ey = extents(Body(x, y, c, s, half[0], half[1], np.float64(0.0)))
    (x0, x1), (y0, y1) = (
        np.searchsorted(cells, (middle - extent - reach, middle + extent + reach)).tolist()
        for cells, middle, extent in ((xs, x, ex), (ys, y, ey))
    )
    return slice(x0, x1, stride), slice(y0, y1, stride)


def used_from(px: Floats, py: Floats, pose: Floats, half: Floats, reach: float, sides: Mask) -> Mask:
    """Return from which points a box is used: within `reach` metres, beyond one of its sides (4,), or from all around if none.

    The sides are in the order of `SIDES`.
    """
    near, (u, v), (ahead, left) = box_distance(px, py, pose, half) <= reach, seen_from(px, py, pose), half
    beyond = np.array([u > ahead, v > left, u < -ahead, v < -left])
    return near & beyond[sides].any(axis=0) if sides.any() else near


def box_distance(px: Floats, py: Floats, pose: Floats, half: Floats) -> Floats:
    """Return the signed distance in metres of points to a box; negative inside, round about its corners."""
    u, v = seen_from(px, py, pose)
    u, v = np.abs(u) - half[0], np.abs(v) - half[1]
    distance = np.maximum(u, v)
    corner = np.minimum(u, v) > 0.0
    distance[corner] = np.hypot(u[corner], v[corner])
    return distance


def seen_from(px: Floats, py: Floats, pose: Floats) -> tuple[Floats, Floats]:
    """Return how many metres points lie ahead and to the left of a pose."""
    x, y, c, s = pose
    dx, dy = px - x, py - y
    return c * dx + s * dy, c * dy - s * dx
