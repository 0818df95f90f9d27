"""Snap: what is all but at its wall, or all but aligned, is put there exactly."""

from __future__ import annotations

import math

from robolayout.constraints import AssetRef, FrameTerm, WallRef
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.proposals import carry, compose, frame_of
from robolayout.solve.stage import relative

NEAR = 0.4
"""Metres from its wall within which a thing is snapped to it."""

ALMOST = math.radians(35.0)
"""Radians off its heading within which a thing is snapped to it."""


def snapped(problem: Problem, world: Floats, only: frozenset[str] | None = None) -> Floats:
    """Return poses (n, 4) with things exactly at their walls and at their headings; what stands on them follows.

    Args:
        problem: The problem.
        world: (n, 4) poses.
        only: Names of the assets to snap; None snaps all.
    """
    result = world.copy()
    for terms in (*problem.statement_terms, problem.wall_terms):
        for term in terms:
            if not isinstance(term, FrameTerm) or term.heading is None or term.moves == "b":
                continue
            if not isinstance(term.a, AssetRef):
                continue
            slot = problem.slot[term.a.name]
            if (only is not None and term.a.name not in only) or term.a.name in problem.pinned:
                continue
            pose = _target(problem, result, term, slot)
            if pose is not None:
                carry(problem, result, slot, pose)
    return result


def _target(problem: Problem, world: Floats, term: FrameTerm, slot: int) -> Floats | None:
    """Return the exact pose that a row asks for, if the thing is close to it."""
    assert term.heading is not None
    frame = frame_of(problem, term.b, world)
    local = relative(frame, world[slot])
    if abs(math.remainder(math.atan2(local[3], local[2]) - term.heading, math.tau)) > ALMOST:
        return None
    local[2:] = math.cos(term.heading), math.sin(term.heading)
    if isinstance(term.b, WallRef) and term.across.low == term.across.high:
        hx, hy = problem.half[slot]
        end = max(problem.scene.room.walls[term.b.index].length / 2 - hy, 0.0)
        if abs(local[1] - hx) > NEAR:
            return None
        local[:2] = min(max(local[0], -end), end), hx
    return compose(frame, local)
