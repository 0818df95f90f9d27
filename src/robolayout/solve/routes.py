"""Routes on a grid: how the agent would walk if furniture could be pushed aside at a price.

The cost of a cell grows with how much clearance the agent lacks there, so a route goes around furniture where that is cheap and
through it where it is not. Every point of a route that lacks clearance becomes a demand on the things around it; the search
then pushes them aside while their statements pull them back.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon

from robolayout._grid import components
from robolayout.assets.obstacles import pieces, use_sides
from robolayout.scene import Agent
from robolayout.solve.arrays import Routes
from robolayout.solve.compile import Floats, Problem

PUSH_PRICE = 25.0
"""Cost of a metre walked per metre of clearance that is missing, against 1 for a free metre."""

MARGIN = 0.03
"""Metres of clearance asked beyond the agent's radius: half a cell, and what a step of the search may lose."""

SPACING = 0.10
"""Metres between the points of a route that become demands."""

SPARE = 0.15
"""Metres of clearance beyond what the body needs that are still told apart."""

MOST_CELLS = 12_000
"""Cells of a grid: 30 m2 at 5 cm, 120 m2 at 10 cm."""

POCKET = 0.05
"""Square metres of free space cut off from the door that get a route of their own."""


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
    """

    xs: Floats
    ys: Floats
    wall_distance: Floats
    start: tuple[int, int] | None
    agent: Agent
    cell: float

    @property
    def open(self) -> NDArray[np.bool_]:
        """(nx, ny) whether the agent's centre could be there in the empty room."""
        return self.wall_distance >= self.agent.radius


def make_ground(problem: Problem, agent: Agent, cell: float) -> Ground:
    """Return the empty room on a grid; large rooms get larger cells."""
    x0, y0, x1, y1 = problem.scene.room.bounds
    cell = max(cell, ((x1 - x0) * (y1 - y0) / MOST_CELLS) ** 0.5)
    xs, ys = np.arange(x0 + cell / 2, x1, cell), np.arange(y0 + cell / 2, y1, cell)
    room = Polygon(problem.scene.room.vertices)
    points = np.asarray(shapely.points(*np.meshgrid(xs, ys, indexing="ij")))
    shapely.prepare(room)
    distance = shapely.distance(points, room.exterior)
    distance = np.where(shapely.contains(room, points), distance, -distance)
    return Ground(xs, ys, distance, _entry(problem, agent, points, distance), agent, cell)


def _entry(problem: Problem, agent: Agent, points: Floats, distance: Floats) -> tuple[int, int] | None:
    """Return the cell nearest to the first door that holds the agent's centre; the roomiest one without a door."""
    open_cells = distance >= agent.radius
    if not open_cells.any():
        return None
    if not problem.scene.room.doors:
        flat = int(np.argmax(distance))
    else:
        door = problem.scene.room.doors[0]
        wall = problem.scene.room.walls[door.wall]
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


def boxes_of(problem: Problem, slots: tuple[int, ...]) -> Obstacles:
    """Return the whole boxes of some slots."""
    index = np.array(slots, dtype=np.intp)
    return Obstacles(index, np.zeros((len(slots), 2)), problem.half[index].reshape(-1, 2), ())


def obstacles_of(problem: Problem, agent: Agent) -> Obstacles:
    """Return what stands in this agent's way."""
    found = [pieces(asset, problem.guess[asset.name].z, agent) for asset in problem.scene.assets]
    rows = np.concatenate([np.empty((0, 4)), *(rectangles for rectangles, _ in found)])
    slot = np.repeat(np.arange(len(found)), [len(rectangles) for rectangles, _ in found])
    return Obstacles(slot, rows[:, :2], rows[:, 2:], tuple(i for i, (_, passable) in enumerate(found) if passable))


def clearance(ground: Ground, world: Floats, obstacles: Obstacles) -> Floats:
    """Return metres from every cell to the nearest obstacle, negative inside, capped a little above what the body needs."""
    agent = ground.agent
    cap = max(agent.radius, agent.circumradius, (agent.turning_diameter or 0.0) / 2) + SPARE
    field = np.full((len(ground.xs), len(ground.ys)), cap)
    for pose, half in zip(obstacles.poses(world), obstacles.half, strict=True):
        here = _window(ground, pose, half, cap)
        distance = _box_distance(ground.xs[here[0], None], ground.ys[None, here[1]], pose, half)
        np.minimum(field[here], distance, out=field[here])
    return field


def _window(ground: Ground, pose: Floats, half: Floats, reach: float) -> tuple[slice, slice]:
    """Return the cells within `reach` metres of a box's bounds, and some more."""
    x, y, c, s = pose.tolist()
    rx, ry = abs(c) * half[0] + abs(s) * half[1] + reach, abs(s) * half[0] + abs(c) * half[1] + reach
    i, j = np.searchsorted(ground.xs, (x - rx, x + rx)), np.searchsorted(ground.ys, (y - ry, y + ry))
    return slice(int(i[0]), int(i[1])), slice(int(j[0]), int(j[1]))


@dataclass(frozen=True)
class Plan:
    """Routes for one layout.

    Attributes:
        demands: (m, 4) rows (x, y, slot, metres to keep).
        blocked: How many goals cannot be reached without pushing.
        blockers: Slots that take clearance from a route, the worst first.
    """

    demands: Floats
    blocked: int
    blockers: tuple[int, ...] = ()


def plan_routes(
    problem: Problem, ground: Ground, world: Floats, obstacles: Obstacles, *, everywhere: bool = False
) -> Plan:
    """Return what must yield so that the agent gets from the door to everything and into every pocket of free space.

    Args:
        problem: The problem.
        ground: The empty room on a grid.
        world: (n, 4) poses.
        obstacles: What stands in the agent's way.
        everywhere: Whether routes that are free ask to stay so.
    """
    if ground.start is None:
        return Plan(np.empty((0, 4)), 0)
    from skimage.graph import MCP_Geometric

    need = ground.agent.radius + MARGIN
    field = clearance(ground, world, obstacles)
    lacking = np.maximum(need - field, 0.0)
    cost = np.where(ground.open, 1.0 + PUSH_PRICE * lacking, -1.0)
    walk = MCP_Geometric(cost, fully_connected=True)
    reach, _ = walk.find_costs([ground.start])
    passable = ground.open & (field >= ground.agent.radius - ground.cell / 4)
    regions, _ = components(passable)
    here = int(regions[ground.start])
    home = (regions == here) if here else np.zeros_like(passable)
    goals = _goals(problem, ground, world, reach, np.zeros_like(home) if everywhere else home)
    sheltered = clearance(ground, world, boxes_of(problem, obstacles.shelter)) < 0.0
    goals += _pockets(ground, np.where(sheltered, 0, regions), here, field)
    points: set[tuple[int, int]] = set()
    for goal in goals:
        if np.isfinite(reach[goal]):
            points.update(walk.traceback(goal))
    demands, blockers = _demands(ground, world, obstacles, problem.half, sorted(points))
    turning, turn_blockers = _turning(ground, world, obstacles, problem.half, np.where(home, field, -np.inf))
    blocked = len(goals) + bool(len(turning))
    return Plan(np.concatenate([turning, demands]), blocked, (*blockers, *turn_blockers))


def _goals(
    problem: Problem, ground: Ground, world: Floats, reach: Floats, home: NDArray[np.bool_]
) -> list[tuple[int, int]]:
    """Return for each asset that is out of reach from `home` the cheapest cell from which it is within reach."""
    goals: list[tuple[int, int]] = []
    for slot, asset in enumerate(problem.scene.assets):
        if asset.is_flat or (asset.on_ceiling and not asset.on_floor):
            continue
        pose, half = world[slot], problem.half[slot]
        here = _window(ground, pose, half, ground.agent.reach)
        xs, ys = ground.xs[here[0], None], ground.ys[None, here[1]]
        near = _box_distance(xs, ys, pose, half) <= ground.agent.reach - ground.cell / 2
        near &= _beyond_use_sides(problem, (xs, ys), pose, slot)
        if (carrier := int(problem.parent[slot])) >= 0:
            near &= _box_distance(xs, ys, world[carrier], problem.half[carrier]) >= 0.0
        if (near & home[here]).any():
            continue
        costs = np.where(near & ground.open[here], reach[here], np.inf)
        if np.isfinite(costs).any():
            i, j = np.unravel_index(int(np.argmin(costs)), costs.shape)
            goals.append((here[0].start + int(i), here[1].start + int(j)))
    return goals


def _beyond_use_sides(problem: Problem, cells: tuple[Floats, Floats], pose: Floats, slot: int) -> NDArray[np.bool_]:
    """Return which cells lie beyond a side that a thing is used from; all of them where any side will do."""
    sides = use_sides(problem.scene.assets[slot])
    if problem.parent[slot] >= 0 or not sides or len(sides) == 4:
        return np.ones((len(cells[0]), cells[1].shape[1]), dtype=bool)
    x, y, c, s = pose
    dx, dy = cells[0] - x, cells[1] - y
    u, v = c * dx + s * dy, c * dy - s * dx
    hx, hy = problem.half[slot]
    beyond = {"front": u > hx, "back": u < -hx, "left": v > hy, "right": v < -hy}
    return np.logical_or.reduce([beyond[side] for side in sides])


def _pockets(ground: Ground, regions: NDArray[np.intp], here: int, field: Floats) -> list[tuple[int, int]]:
    """Return the roomiest cell of every region of free space that is cut off."""
    pockets: list[tuple[int, int]] = []
    sizes = np.bincount(regions.ravel())
    for region in range(1, len(sizes)):
        if region != here and sizes[region] * ground.cell**2 >= POCKET:
            room = np.where(regions == region, np.minimum(field, ground.wall_distance), -np.inf)
            best = np.unravel_index(int(np.argmax(room)), room.shape)
            pockets.append((int(best[0]), int(best[1])))
    return pockets


def _turning(
    ground: Ground, world: Floats, obstacles: Obstacles, boxes: Floats, field: Floats
) -> tuple[Floats, tuple[int, ...]]:
    """Return what must yield so that a body with a turning circle can turn at the roomiest place it gets to."""
    need = max(ground.agent.circumradius, (ground.agent.turning_diameter or 0.0) / 2)
    room = np.minimum(field, np.where(ground.wall_distance >= need + MARGIN, np.inf, -np.inf))
    if ground.agent.length is None or room.max() >= need + MARGIN or not np.isfinite(room.max()):
        return np.empty((0, 4)), ()
    best = np.unravel_index(int(np.argmax(room)), room.shape)
    px, py = ground.xs[best[0]], ground.ys[best[1]]
    distance = _box_distance(px, py, obstacles.poses(world).T, obstacles.half.T)
    near = np.flatnonzero(distance < need + 0.3)
    points = np.full((len(near), 2), (px, py))
    blocking = dict.fromkeys(obstacles.slot[distance < need].tolist())
    return _rows(points, near, need + MARGIN, world, obstacles, boxes), tuple(blocking)


def _box_distance(px: Floats, py: Floats, pose: Floats, half: Floats) -> Floats:
    """Return the signed distance in metres of points to a box; negative inside."""
    x, y, c, s = pose
    u, v = np.abs(c * (px - x) + s * (py - y)) - half[0], np.abs(c * (py - y) - s * (px - x)) - half[1]
    return np.hypot(np.maximum(u, 0.0), np.maximum(v, 0.0)) + np.minimum(np.maximum(u, v), 0.0)


def _demands(
    ground: Ground, world: Floats, obstacles: Obstacles, boxes: Floats, cells: list[tuple[int, int]]
) -> tuple[Floats, tuple[int, ...]]:
    """Return (x, y, slot, metres) for every point and everything near it, and what lacks clearance, the worst first."""
    if not cells or not len(obstacles.slot):
        return np.empty((0, 4)), ()
    picked = np.array(cells)
    stride = max(1, round(SPACING / ground.cell))
    spaced = picked[(picked.sum(axis=1) % stride) == 0]
    picked = spaced if len(spaced) else picked
    points = np.stack([ground.xs[picked[:, 0]], ground.ys[picked[:, 1]]], axis=1)
    poses = obstacles.poses(world)
    distance = _box_distance(points[:, :1], points[:, 1:], poses.T[:, None], obstacles.half.T[:, None])
    need = ground.agent.radius + MARGIN
    point, near = np.nonzero(distance < need + 0.3)
    lacking = np.maximum(need - MARGIN - distance, 0.0).max(axis=0)
    worst = np.argsort(-lacking, kind="stable")[: int((lacking > 0).sum())]
    blockers = dict.fromkeys(obstacles.slot[worst].tolist())
    return _rows(points[point], near, need, world, obstacles, boxes), tuple(blockers)


def _rows(
    points: Floats, near: NDArray[np.intp], need: float, world: Floats, obstacles: Obstacles, boxes: Floats
) -> Floats:
    """Return rows (x, y, slot, metres) which keep the rectangles `near` so far from points.

    The search knows only whole boxes, so the point is moved within the slot's frame to where it is as far from the box as it
    is from the rectangle, in the same direction. A rectangle that is its whole box leaves the point where it is.
    """
    slot = obstacles.slot[near]
    x, y, c, s = world[slot].astype(float).T
    dx, dy = points[:, 0] - x, points[:, 1] - y
    apart = np.stack([c * dx + s * dy, c * dy - s * dx], axis=1) - obstacles.offset[near]
    u, v = (np.copysign(np.abs(apart) - obstacles.half[near] + boxes[slot], apart)).T
    return np.stack([x + c * u - s * v, y + s * u + c * v, slot.astype(float), np.full(len(slot), need)], axis=1)


def pack(plans: list[Plan], size: int) -> Routes:
    """Return the demands of all starts as padded arrays of `size` rows; the most pressing ones come first."""
    point = np.full((len(plans), size, 2), 1.0e4, np.float32)
    slot = np.zeros((len(plans), size), np.int32)
    need = np.full((len(plans), size), -1.0e4, np.float32)
    for k, plan in enumerate(plans):
        rows = plan.demands
        if len(rows) > size:
            rows = rows[np.linspace(0, len(rows) - 1, size).astype(int)]
        point[k, : len(rows)] = rows[:, :2]
        slot[k, : len(rows)] = rows[:, 2]
        need[k, : len(rows)] = rows[:, 3]
    return Routes(point, slot, need)
