"""Where the search starts from: the guess, jitter of it, and rooms built anew."""

from __future__ import annotations

import numpy as np
import shapely
from shapely import Polygon

from robolayout.solve.compile import Floats, Problem
from robolayout.solve.construct import Builder
from robolayout.solve.proposals import Proposals


def make_starts(
    problem: Problem, world: Floats, moving: tuple[int, ...], count: int, rng: np.random.Generator
) -> Floats:
    """Return `count` starts (count, n, 4), the most promising first.

    A quarter each: the guess and slight jitter of it, rooms built anew, wide jitter, draws from the statements.
    """
    starts = np.repeat(world[None], count, axis=0)
    on_tops = problem.parent[moving[0]] >= 0
    builder, proposals = None if on_tops else Builder(problem, moving, rng), Proposals.of(problem)
    scale = 0.1 if on_tops else 1.0
    for k in range(1, count):
        quarter = 4 * k // count
        if quarter in (0, 2):
            _jitter(starts[k], moving, (0.05 + 1.2 * k / count) * scale, rng)
        elif quarter == 1 and builder:
            starts[k] = builder.build(world)
        else:
            for slot in moving:
                if slot == moving[0] or rng.random() < 0.7:
                    starts[k, slot] = proposals.draw(slot, starts[k], 1, rng)[0]
    _bring_in(problem, starts, moving)
    return starts


def _bring_in(problem: Problem, starts: Floats, moving: tuple[int, ...]) -> None:
    """Put things whose centre lies outside the room onto the nearest point of its floor."""
    room = Polygon(problem.scene.room.vertices)
    shapely.prepare(room)
    for slot in moving:
        if problem.parent[slot] < 0:
            points = np.asarray(shapely.points(starts[:, slot, :2]))
            outside = ~shapely.covers(room, points)
            ways = shapely.shortest_line(points[outside], room)
            starts[outside, slot, :2] = shapely.get_coordinates(ways)[1::2]


def _jitter(world: Floats, moving: tuple[int, ...], sigma: float, rng: np.random.Generator) -> None:
    for slot in moving:
        world[slot, :2] += rng.normal(0.0, sigma, 2)
        if rng.random() < sigma / 2:
            world[slot, 2:] = [-world[slot, 3], world[slot, 2]]
