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
from robolayout.floor.ground import Ground, box_distance, clearance, seen_from


@dataclass(frozen=True)
class RoutePlan:
    """Routes for one layout."""

    demands: Floats  # (m, 4) rows (x, y, slot, metres to keep)
    blocked: int  # how many goals cannot be reached without pushing


def plan_routes(ground: Ground, world: Floats, *, everywhere: bool = False) -> RoutePlan:
    """Return what must yield so that the agent gets from the door to everything and into every pocket of free space.

    With `everywhere`, routes that are free ask to stay so.
    """
    if ground.start is None:
        return RoutePlan(np.empty((0, 4)), 0)
    field = clearance(ground, world, ground.obstacles)
    regions, _ = components(ground.passable(field))
    here = int(regions[ground.start])
    home = (regions == here) & (here > 0)
    rows = missed(ground, world, np.zeros_like(home) if everywhere else home)
    sheltered = clearance(ground, world, ground.shelter) < 0.0
    pockets = _pockets(ground, np.where(sheltered, 0, regions), here, field)
    pockets += [(i, j) for i, j in ground.doors[1:].tolist() if not home[i, j]]
    goals, points = _walks(ground, world, field, rows, pockets)
    need = ground.agent.radius + FLOOR.route_margin
    demands = _demands(ground, world, points, need, need + FLOOR.nearby)
    turning = _turning(ground, world, np.where(home, field, -np.inf))
    return RoutePlan(np.concatenate([turning, demands]), goals + bool(len(turning)))


def _walks(
    ground: Ground, world: Floats, field: Floats, rows: Cells, pockets: list[tuple[int, int]]
) -> tuple[int, Cells]:
    """Return to how many goals there are cheapest ways, and the cells (m, 2) on them, in row order."""
    if not len(rows) and not pockets:
        return 0, np.empty((0, 2), dtype=np.intp)
    from skimage.graph import MCP_Geometric

    lacking = np.maximum(ground.agent.radius + FLOOR.route_margin - field, 0.0)
    walk = MCP_Geometric(np.where(ground.open, 1.0 + FLOOR.push_price * lacking, -1.0), fully_connected=True)
    cost, _ = walk.find_costs([ground.start])
    goals = cheapest(ground, world, rows, cost) + pockets
    walked = np.zeros(field.shape, np.bool_)
    for goal in goals:
        if np.isfinite(cost[goal]):
            walked[tuple(np.transpose(walk.traceback(goal)))] = True
    return len(goals), np.argwhere(walked)


def _pockets(ground: Ground, regions: NDArray[np.intp], here: int, field: Floats) -> list[tuple[int, int]]:
    """Return the roomiest cell of every region of free space that is cut off."""
    room = np.minimum(field, ground.wall_distance)
    large = np.flatnonzero(np.bincount(regions.ravel()) * ground.cell**2 >= FLOOR.pocket).tolist()
    best = (np.where(regions == region, room, -np.inf).argmax() for region in large if region not in (0, here))
    return [divmod(int(cell), room.shape[1]) for cell in best]


def _turning(ground: Ground, world: Floats, field: Floats) -> Floats:
    """Return what must yield so that a body with a turning circle can turn at the roomiest place it gets to."""
    radius = turning_radius(ground.agent)
    need = radius + FLOOR.route_margin
    room = np.minimum(field, np.where(ground.wall_distance >= need, np.inf, -np.inf))
    if ground.agent.length is None or room.max() >= need or not np.isfinite(room.max()):
        return np.empty((0, 4))
    return _demands(ground, world, np.argwhere(room == room.max())[:1], need, radius + FLOOR.nearby)


def _demands(ground: Ground, world: Floats, cells: Cells, need: float, near: float) -> Floats:
    """Return (x, y, slot, metres `need`) for points on some cells and everything that is `near` metres from them."""
    stride = max(1, round(FLOOR.route_spacing / ground.cell))
    spaced = cells[(cells.sum(axis=1) % stride) == 0]
    cells = spaced if len(spaced) else cells
    points, things = np.stack([ground.xs[cells[:, 0]], ground.ys[cells[:, 1]]], axis=1), ground.obstacles
    distance = box_distance(points[:, :1], points[:, 1:], things.poses(world).T, things.half.T)
    point, thing = np.nonzero(distance < near)
    return _rows(ground, world, points[point], thing, need)


def _rows(ground: Ground, world: Floats, points: Floats, near: Cells, need: float) -> Floats:
    """Return rows (x, y, slot, metres) which keep the rectangles `near` so far from points.

    The search knows only whole boxes, so the point is moved within the slot's frame to where it is as far from the box as it
    is from the rectangle, in the same direction. A rectangle that is its whole box leaves the point where it is.
    """
    things = ground.obstacles
    slot = things.slot[near]
    x, y, c, s = world[slot].T
    apart = np.stack(seen_from(points[:, 0], points[:, 1], world[slot].T), axis=1) - things.offset[near, :2]
    u, v = (np.copysign(np.abs(apart) - things.half[near] + ground.targets.half[slot], apart)).T
    return np.stack([x + c * u - s * v, y + s * u + c * v, slot.astype(float), np.full(len(slot), need)], axis=1)
