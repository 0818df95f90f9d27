"""Where the search starts from: the guess, jitter of it, and rooms built anew."""

from __future__ import annotations

import numpy as np
import shapely
from shapely import Polygon

from robolayout.solve.compile import Floats, Problem
from robolayout.solve.construct import Builder


class Starts:
    """Makes starts for one stage, each kind when it is asked for.

    Args:
        problem: The problem.
        world: (n, 4) the guess.
        moving: Slots that the stage moves.
        builder: Builds the room anew.
    """

    def __init__(self, problem: Problem, world: Floats, moving: tuple[int, ...], builder: Builder) -> None:
        self.problem, self.world, self.moving, self.builder = problem, world, moving, builder
        self.rng = builder.rng
        self.scale = 0.1 if problem.parent[moving[0]] >= 0 else 1.0

    def near(self, count: int) -> Floats:
        """Return the guess and slight jitter of it (count, n, 4)."""
        return self._jittered(0.05 + 0.3 * np.arange(count) / max(count, 1), first=1)

    def built(self) -> Floats:
        """Return a room built one thing after the other (n, 4)."""
        start = self.builder.build(self.world, self.moving)
        _bring_in(self.problem, start[None], self.moving)
        return start

    def far(self, count: int) -> Floats:
        """Return wide jitter, and draws from the statements (count, n, 4), half of each."""
        jittered = self._jittered(np.linspace(0.65, 1.0, (count + 1) // 2), first=0)
        drawn = np.repeat(self.world[None], count // 2, axis=0)
        proposals = self.builder.proposals
        for start in drawn:
            for slot in self.moving:
                if slot == self.moving[0] or self.rng.random() < 0.7:
                    start[slot] = proposals.draw(slot, start, 1, self.rng)[0]
        _bring_in(self.problem, drawn, self.moving)
        return np.concatenate([jittered, drawn])

    def _jittered(self, sigmas: Floats, first: int) -> Floats:
        """Return the guess moved about, from the `first` on; sigmas in metres."""
        starts = np.repeat(self.world[None], len(sigmas), axis=0)
        for start, sigma in zip(starts[first:], sigmas[first:], strict=True):
            _jitter(start, self.moving, float(sigma) * self.scale, self.rng)
        _bring_in(self.problem, starts, self.moving)
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
