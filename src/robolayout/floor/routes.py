"""Routes on a grid: how the agent would walk if furniture could be pushed aside at a price.

The cost of a cell grows with how much clearance the agent lacks there, so a route goes around furniture where that is cheap and
through it where it is not. Every point of a route that lacks clearance becomes a demand on the things around it; the search
then pushes them aside while their statements pull them back.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robolayout._grid import components
from robolayout.floor.cells import Cells, Floats, turning_radius
from robolayout.floor.config import FLOOR
from robolayout.floor.goals import cheapest, missed
from robolayout.floor.ground import Ground, box_distance, clearance


@dataclass(frozen=True)
class Plan:
    """Routes for one layout."""

    demands: Floats  # (m, 4) rows (x, y, slot, metres to keep)
    blocked: int  # how many goals cannot be reached without pushing


def plan_routes(ground: Ground, world: Floats, *, everywhere: bool = False) -> Plan:
    """Return what must yield so that the agent gets from the door to everything and into every pocket of free space.

    With `everywhere`, routes that are free ask to stay so.
    """
    if ground.start is None:
        return Plan(np.empty((0, 4)), 0)
    field = clearance(ground, world, ground.obstacles)
    passable = ground.passable(field)
    regions, _ = components(passable)
    here = int(regions[ground.start])
    home = (regions == here) & (here > 0)
    rows = missed(ground, world, passable, np.zeros_like(home) if everywhere else home)
    sheltered = clearance(ground, world, ground.shelter) < 0.0
    pockets = _pockets(ground, np.where(sheltered, 0, regions), here, field)
    pockets += [(i, j) for i, j in ground.doors[1:].tolist() if not home[i, j]]
    goals, points = _walks(ground, world, field, rows, pockets)
    demands = _demands(ground, world, points)
    turning = _turning(ground, world, np.where(home, field, -np.inf))
    return Plan(np.concatenate([turning, demands]), goals + bool(len(turning)))


def _walks(
    ground: Ground, world: Floats, field: Floats, rows: Cells, pockets: list[tuple[int, int]]
) -> tuple[int, Cells]:
    """Return to how many goals there are cheapest ways, and the cells (m, 2) on them, in row order."""
    if not len(rows) and not pockets:
        return 0, np.empty((0, 2), dtype=np.intp)
    from skimage.graph import MCP_Geometric

    lacking = np.maximum(ground.agent.radius + FLOOR.route_margin - field, 0.0)
    walk = MCP_Geometric(np.where(ground.open, 1.0 + FLOOR.push_price * lacking, -1.0), fully_connected=True)
    cost, step = walk.find_costs([ground.start])
    goals = cheapest(ground, world, rows, cost) + pockets
    ways = [goal for goal in goals if np.isfinite(cost[goal])]
    offset = np.asarray(walk.offsets) @ (field.shape[1], 1)
    before = (np.arange(field.size) - np.where(step < 0, 0, offset[step]).ravel()).tolist()
    seen: set[int] = set()
    for i, j in ways:
        cell = i * field.shape[1] + j
        while cell not in seen:
            seen.add(cell)
            cell = before[cell]
    return len(goals), np.stack(np.divmod(sorted(seen), field.shape[1]), axis=1)


def _pockets(ground: Ground, regions: NDArray[np.intp], here: int, field: Floats) -> list[tuple[int, int]]:
    """Return the roomiest cell of every region of free space that is cut off."""
    pockets: list[tuple[int, int]] = []
    sizes = np.bincount(regions.ravel())
    for region in range(1, len(sizes)):
        if region != here and sizes[region] * ground.cell**2 >= FLOOR.pocket:
            room = np.where(regions == region, np.minimum(field, ground.wall_distance), -np.inf)
            best = np.unravel_index(int(np.argmax(room)), room.shape)
            pockets.append((int(best[0]), int(best[1])))
    return pockets


def _turning(ground: Ground, world: Floats, field: Floats) -> Floats:
    """Return what must yield so that a body with a turning circle can turn at the roomiest place it gets to."""
    need = turning_radius(ground.agent)
    room = np.minimum(field, np.where(ground.wall_distance >= need + FLOOR.route_margin, np.inf, -np.inf))
    if ground.agent.length is None or room.max() >= need + FLOOR.route_margin or not np.isfinite(room.max()):
        return np.empty((0, 4))
    best = np.unravel_index(int(np.argmax(room)), room.shape)
    px, py = ground.xs[best[0]], ground.ys[best[1]]
    distance = box_distance(px, py, ground.obstacles.poses(world).T, ground.obstacles.half.T)
    near = np.flatnonzero(distance < need + FLOOR.nearby)
    points = np.full((len(near), 2), (px, py))
    return _rows(ground, world, points, near, need + FLOOR.route_margin)


def _demands(ground: Ground, world: Floats, cells: Cells) -> Floats:
    """Return (x, y, slot, metres) for every point and everything near it."""
    obstacles = ground.obstacles
    if not len(cells) or not len(obstacles.slot):
        return np.empty((0, 4))
    stride = max(1, round(FLOOR.route_spacing / ground.cell))
    spaced = cells[(cells.sum(axis=1) % stride) == 0]
    cells = spaced if len(spaced) else cells
    points = np.stack([ground.xs[cells[:, 0]], ground.ys[cells[:, 1]]], axis=1)
    poses, need = obstacles.poses(world), ground.agent.radius + FLOOR.route_margin
    far = np.hypot(*obstacles.half.T) + need + FLOOR.nearby
    about = np.abs(points[:, :1] - poses[:, 0]) <= far
    about &= np.abs(points[:, 1:] - poses[:, 1]) <= far
    point, near = np.nonzero(about)
    distance = box_distance(points[point, 0], points[point, 1], poses[near].T, obstacles.half[near].T)
    close = distance < need + FLOOR.nearby
    return _rows(ground, world, points[point[close]], near[close], need)


def _rows(ground: Ground, world: Floats, points: Floats, near: Cells, need: float) -> Floats:
    """Return rows (x, y, slot, metres) which keep the rectangles `near` so far from points.

    The search knows only whole boxes, so the point is moved within the slot's frame to where it is as far from the box as it
    is from the rectangle, in the same direction. A rectangle that is its whole box leaves the point where it is.
    """
    things = ground.obstacles
    slot = things.slot[near]
    x, y, c, s = world[slot].astype(float).T
    dx, dy = points[:, 0] - x, points[:, 1] - y
    apart = np.stack([c * dx + s * dy, c * dy - s * dx], axis=1) - things.offset[near, :2]
    u, v = (np.copysign(np.abs(apart) - things.half[near] + ground.targets.half[slot], apart)).T
    return np.stack([x + c * u - s * v, y + s * u + c * v, slot.astype(float), np.full(len(slot), need)], axis=1)
