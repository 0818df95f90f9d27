"""Push: every thing goes to the nearest pose at which its own statements hold, one after the other.

A guess is rough where it says numbers and right where it says relations: a bed a hand's breadth off its wall belongs at the
wall, and keeps its place along it. Each row of a statement allows a set of poses in the frame of what it refers to; a thing is
projected onto these sets in turn, what others refer to first, its wall last.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from robolayout._geometry import compose
from robolayout.constraints import FAR, AssetRef, FrameTerm, Interval, WallRef
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.proposals import Proposals, at_wall, carry, frame_of
from robolayout.solve.stage import relative

PASSES = 3
"""Times that all rows of a thing are gone through: they pull at one another."""

ALMOST = math.radians(8.0)
"""Radians off the direction in which a thing should look that are left as they are: the checks allow 10 degrees."""


def pushed(
    proposals: Proposals, world: Floats, slots: Iterable[int], *, walls_only: bool = False, most: float = math.inf
) -> Floats:
    """Return poses (n, 4) with some slots where their statements hold, if these can; what stands on them follows.

    Args:
        proposals: The rows of the problem.
        world: (n, 4) poses.
        slots: What may move; what others refer to is pushed first.
        walls_only: Whether only walls and headings along them are minded.
        most: Metres that a thing may go; what had to go farther stays.
    """
    problem, world = proposals.problem, world.copy()
    for slot in sorted(slots, key=proposals.ranks.__getitem__):
        before = world.copy()
        rows = [term for term in proposals.rows(slot) if not walls_only or isinstance(term.b, WallRef)]
        _project(problem, world, slot, rows, PASSES)
        if not walls_only:
            for mirror in proposals.mirrors.get(slot, []):
                if mirror.b == AssetRef(problem.names[slot]):
                    carry(problem, world, slot, proposals.image(mirror, slot, world))
                    _project(problem, world, slot, [term for term in rows if at_wall(term)], 1)
        if math.dist(world[slot, :2], before[slot, :2]) > most:
            world = before
    return world


def _project(problem: Problem, world: Floats, slot: int, rows: list[FrameTerm], passes: int) -> None:
    """Put a slot, in place, where rows hold, the last of them for certain."""
    if rows:
        pose = world[[slot]]
        for term in rows * (passes if len(rows) > 1 else 1):
            pose = nearest(problem, term, slot, pose, world)
        carry(problem, world, slot, pose[0])


def nearest(problem: Problem, term: FrameTerm, slot: int, poses: Floats, world: Floats) -> Floats:
    """Return the poses (m, 4) nearest to some of a slot (m, 4) at which a row holds, the others standing as in `world`."""
    frame = frame_of(problem, term.b, world)
    local = relative(frame, poses)
    if term.heading is not None:
        local[:, 2:] = math.cos(term.heading), math.sin(term.heading)
    hx, hy = problem.half[slot]
    c, s = np.abs(local[:, 2:]).T
    local[:, 0] = _within(local[:, 0], term.along, c * hx + s * hy)
    side = np.where(local[:, 1] < 0.0, -1.0, 1.0) if term.fold else 1.0
    local[:, 1] = side * _within(side * local[:, 1], term.across, s * hx + c * hy)
    core = problem.scene.room.walls[term.b.index].length / 2 if isinstance(term.b, WallRef) else 0.0
    _at_distance(local, term.distance, core)
    if term.look is not None:
        wanted = np.arctan2(-local[:, 1], -local[:, 0]) - term.look
        off = np.arctan2(local[:, 3], local[:, 2]) - wanted
        turned = np.cos(off) < math.cos(ALMOST)
        local[turned, 2:] = np.column_stack([np.cos(wanted), np.sin(wanted)])[turned]
    return compose(frame, local)


def _within(value: Floats, interval: Interval, extent: Floats) -> Floats:
    """Return the numbers nearest to some in an interval that shrinks with the extent of the thing; its middle if empty."""
    low = interval.low + interval.low_extent * extent
    high = interval.high - interval.high_extent * extent
    return np.where(low > high, (low + high) / 2, np.clip(value, low, high))


def _at_distance(local: Floats, distance: tuple[float, float], core: float) -> None:
    """Move places straight away from, or to, the segment from -core to core on the x axis, in place."""
    low, high = distance
    if low <= 0.0 and high >= FAR:
        return
    apart = np.column_stack([np.copysign(np.maximum(np.abs(local[:, 0]) - core, 0.0), local[:, 0]), local[:, 1]])
    apart[~apart.any(axis=1)] = (1e-9, 0.0)  # right on it: any direction will do
    away = np.hypot(*apart.T)
    local[:, :2] += apart * (np.clip(away, low, high) / away - 1.0)[:, None]
