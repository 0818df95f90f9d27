"""How much two rooms differ: the share of their things that have no counterpart in the other one.

Rooms are laid over each other by their middles and compared turned and mirrored in all eight ways. A thing has a counterpart
where a thing of its kind stands within `NEAR` metres and faces the same way within `ALIKE` degrees; each counts once.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout.scene import Layout, Scene

NEAR = 0.25
"""Metres between two things that stand at the same place."""

ALIKE = 20.0
"""Degrees between two fronts that face the same way."""

LEAST = 0.15
"""Difference below which two rooms are near-duplicates."""

Thing = tuple[str, float, float, float]
"""Kind, x and y in metres from the middle of the room, heading in radians."""

_WAYS = [(turn, mirrored) for mirrored in (False, True) for turn in range(4)]


def things(scene: Scene, layout: Layout) -> tuple[Thing, ...]:
    """Return what stands where in a room, sorted."""
    xs, ys = zip(*scene.room.vertices, strict=True)
    middle = ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2)
    found = [
        (scene.by_name[name].category, round(p.x - middle[0], 3), round(p.y - middle[1], 3), round(p.yaw, 3))
        for name, p in layout.items()
    ]
    return tuple(sorted(found))


class Plan:
    """What stands where in one room, ready to be compared.

    Args:
        found: Its things.
    """

    def __init__(self, found: Sequence[Sequence[Any]]) -> None:
        kinds = [str(thing[0]) for thing in found]
        self.counts = Counter(kinds)
        poses = np.array([thing[1:] for thing in found], dtype=float).reshape(-1, 3)
        self.poses = {kind: poses[[k == kind for k in kinds]] for kind in self.counts}

    def least(self, other: Plan) -> float:
        """Return a bound that the difference is never below: the share of things whose kind the other one lacks."""
        return _share((self.counts & other.counts).total(), self.counts.total() + other.counts.total())

    def difference(self, other: Plan) -> float:
        """Return the difference of two rooms: 0 where the same stands at the same places, 1 where nothing does."""
        shared = self.counts.keys() & other.counts.keys()
        both = self.counts.total() + other.counts.total()
        met = (sum(_pairs(self.poses[k], _seen(other.poses[k], *way)) for k in shared) for way in _WAYS)
        return _share(max(met), both)


def nearest(plan: Plan, others: Sequence[tuple[int, Plan]]) -> tuple[float, int]:
    """Return the least difference of a room from others, and the number of that one; 1 and -1 where there are none."""
    best = (1.0, -1)
    for bound, number, other in sorted(((plan.least(one), n, one) for n, one in others), key=lambda item: item[:2]):
        if bound >= best[0]:
            break
        best = min(best, (plan.difference(other), number))
    return best


def _share(met: int, both: int) -> float:
    return 1.0 - 2.0 * met / both if both else 0.0


def _seen(poses: NDArray[np.float64], turn: int, mirrored: bool) -> NDArray[np.float64]:
    """Return poses after a mirroring at the y axis and so many quarter turns."""
    x, y, yaw = poses.T
    if mirrored:
        x, yaw = -x, math.pi - yaw
    for _ in range(turn):
        x, y, yaw = -y, x, yaw + math.pi / 2
    return np.stack([x, y, yaw], axis=1)


def _pairs(here: NDArray[np.float64], there: NDArray[np.float64]) -> int:
    """Return how many things can be paired one to one with a near one that faces the same way, the nearest first."""
    apart = np.hypot(here[:, None, 0] - there[None, :, 0], here[:, None, 1] - there[None, :, 1])
    turned = np.abs((here[:, None, 2] - there[None, :, 2] + math.pi) % (2 * math.pi) - math.pi)
    apart = np.where(turned <= math.radians(ALIKE), apart, np.inf)
    found = 0
    while apart.size and apart.min() <= NEAR:
        row, column = divmod(int(apart.argmin()), apart.shape[1])
        apart[row, :] = apart[:, column] = np.inf
        found += 1
    return found
