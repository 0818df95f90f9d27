"""Where a rectangular body gets to along and across the way in by the first door.

It drives ahead and back in lanes, comes from one lane to the next where it has room to swerve, and turns across where its whole
turning circle is free; a body that slides sideways needs no room for the first. The verifier knows more headings, so nearly all
that is reached here is reached there; a swerve is taken for a disc, which is too little where the way is short.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from robolayout._grid import components, distance, joined
from robolayout.floor.cells import Mask, turning_radius
from robolayout.floor.furnished import Floor
from robolayout.scene import Agent

SWERVE = math.atan2(1, 2)
"""Radians by which a body turns to come from one lane to the next: the least turn that the verifier knows."""

Labels = NDArray[np.int32]


def either_way(floor: Floor, agent: Agent) -> tuple[Mask, Mask]:
    """Return where a body can stand along and across the door's direction, having come in straight."""
    length, width = agent.length or 0.0, agent.width or 0.0
    free, clear = free_ways(floor, ~floor.inside | (floor.body > 0), agent), floor.clear * floor.cell
    swerve = clear >= (width * math.cos(SWERVE) + length * math.sin(SWERVE)) / 2
    lanes = [_lanes(floor, agent, way, across=k == 1) for k, way in enumerate(free)]
    aside = [components(way & swerve)[0] for way in free]
    turning = aside[0] * (clear >= turning_radius(agent) + floor.cell)
    first = np.cumsum([0, *(int(grid.max(initial=0)) for grid in (*lanes, *aside))])
    pairs = [
        _met(one, other) + first[[a, b]]
        for one, other, a, b in ((lanes[0], aside[0], 0, 2), (lanes[1], aside[1], 1, 3), (turning, aside[1], 2, 3))
    ]
    root = joined(int(first[-1]) + 1, *np.concatenate(pairs).T)
    if floor.room.doors:
        door = floor.cells(np.array(floor.room.way_in(length, width, 2 * floor.cell)))
        begins = root[lanes[0][free[0] & door]]
    else:  # where there is most room
        begins = np.bincount(root[lanes[0][free[0]]], minlength=1).argmax()
    there = np.isin(root, begins)
    return there[lanes[0]] & free[0], there[lanes[1] + first[1]] & free[1]


def _met(one: Labels, other: Labels) -> NDArray[np.intp]:
    """Return the pairs (n, 2) of labels that some cells have on both of two grids."""
    wide = int(other.max(initial=0)) + 1
    there = (one > 0) & (other > 0)
    codes = np.flatnonzero(np.bincount(one[there] * wide + other[there]))
    return np.stack(np.divmod(codes, wide), axis=1)


def _lanes(floor: Floor, agent: Agent, free: Mask, *, across: bool) -> Labels:
    """Return for each free cell the number, from 1, of the lane in which a body drives there: its region where it slides sideways.

    In a room that stands askew lanes are not told apart.
    """
    nx, ny = _inward(floor)
    if agent.turning_radius is None or min(abs(nx), abs(ny)) > 1e-6:
        return components(free)[0]
    grid = free if (abs(nx) < abs(ny)) != across else free.T
    begins = grid.copy()
    begins[:, 1:] &= ~grid[:, :-1]
    lanes = begins.ravel().cumsum(dtype=np.int32).reshape(grid.shape) * grid
    return lanes if grid is free else lanes.T


def _inward(floor: Floor) -> tuple[float, float]:
    """Return the direction in which bodies come in by the first door."""
    return floor.room.walls[floor.room.doors[0].wall if floor.room.doors else 0].normal


def free_ways(floor: Floor, taken: Mask, agent: Agent) -> tuple[Mask, ...]:
    """Return where a body touches none of the cells taken, of the grid or a part of it: a disc; along and across the door."""
    if agent.length is None:
        limit = agent.radius / floor.cell + 1.0
        return (distance(np.pad(~taken, 1), limit + 1.0)[1:-1, 1:-1] >= limit,)
    nx, ny = _inward(floor)
    return _fits(floor.cell, taken, agent, (nx, ny)), _fits(floor.cell, taken, agent, (-ny, nx))


def _fits(cell: float, taken: Mask, agent: Agent, heading: tuple[float, float]) -> Mask:
    """Return the cells on which a rectangular body with a heading touches nothing."""
    (nx, ny), rim = taken.shape, math.ceil(agent.circumradius / cell) + 2
    blocked = np.pad(taken, rim, constant_values=True)
    width, blocked = ny + 2 * rim, blocked.ravel()
    for (dx, dy), extent in ((heading, agent.length or 0.0), ((-heading[1], heading[0]), agent.width or 0.0)):
        spread = blocked.copy()
        for step in range(1, int(extent / 2 / cell + 0.5) + 1):
            shift = abs(round(step * dx) * width + round(step * dy))  # the rim keeps one row's steps out of the next
            spread[shift:] |= blocked[:-shift]
            spread[:-shift] |= blocked[shift:]
        blocked = spread
    return ~blocked.reshape(nx + 2 * rim, width)[rim:-rim, rim:-rim]
