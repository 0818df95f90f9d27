"""Where gradients start from: the guess and slight jitter of it."""

from __future__ import annotations

import numpy as np
import shapely
from shapely import Polygon

from robolayout.solve.compile import Floats, Problem


def near(problem: Problem, world: Floats, moving: tuple[int, ...], count: int, rng: np.random.Generator) -> Floats:
    """Return poses (n, 4) and slight jitter of what moves in them: (count, n, 4)."""
    scale = 0.1 if problem.parent[moving[0]] >= 0 else 1.0
    starts = np.repeat(world[None], count, axis=0)
    for k, start in enumerate(starts[1:], 1):
        sigma = (0.05 + 0.3 * k / count) * scale
        for slot in moving:
            start[slot, :2] += rng.normal(0.0, sigma, 2)
            if rng.random() < sigma / 2:
                start[slot, 2:] = [-start[slot, 3], start[slot, 2]]
    bring_in(problem, starts, moving)
    return starts


def bring_in(problem: Problem, starts: Floats, moving: tuple[int, ...]) -> None:
    """Put things whose centre lies outside the room onto the nearest point of its floor."""
    room = Polygon(problem.scene.room.vertices)
    shapely.prepare(room)
    for slot in moving:
        if problem.parent[slot] < 0:
            points = np.asarray(shapely.points(starts[:, slot, :2]))
            outside = ~shapely.covers(room, points)
            ways = shapely.shortest_line(points[outside], room)
            starts[outside, slot, :2] = shapely.get_coordinates(ways)[1::2]
