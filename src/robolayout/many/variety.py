"""How much two rooms differ: the share of their things that have no counterpart in the other one.

Rooms are laid over each other by their middles and compared turned and mirrored in all eight ways. A thing has a counterpart
where a thing of its kind stands within `VARIETY.near` metres and faces the same way within `VARIETY.alike` degrees; each counts once.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class VarietyConfig:
    """When two rooms are alike."""

    near: float = 0.25  # metres between two things that stand at the same place
    alike: float = 20.0  # degrees between two fronts that face the same way
    least: float = 0.15  # share of things at other places below which two rooms are near-duplicates
    varied: float = 0.4  # share from which on they are variants worth having
    draws: int = 4  # times that a variant is drawn until it is not much like those before it


VARIETY = VarietyConfig()

Thing = tuple[str, float, float, float]  # kind, x and y in metres from the middle of the room, heading in radians


def things(scene: Scene, layout: Layout) -> tuple[Thing, ...]:
    """Return what stands where in a room, sorted."""
    left, front, right, back = scene.room.bounds
    x, y = (left + right) / 2, (front + back) / 2
    kinds = {name: asset.category for name, asset in scene.by_name.items()}
    return tuple(sorted((kinds[n], round(p.x - x, 3), round(p.y - y, 3), round(p.yaw, 3)) for n, p in layout.items()))


class Plan:
    """What stands where in one room, ready to be compared."""

    def __init__(self, found: Sequence[Sequence[Any]]) -> None:
        self.counts = Counter(str(thing[0]) for thing in found)
        self.kinds = np.array([thing[0] for thing in found], dtype=object)
        poses = np.array([thing[1:] for thing in found], dtype=float).reshape(-1, 3)
        seen: list[NDArray[np.float64]] = []  # after a mirroring at the y axis, and so many quarter turns
        for mirrored in (False, True):
            x, y, yaw = poses.T
            x, yaw = (-x, math.pi - yaw) if mirrored else (x, yaw)
            for _ in range(4):
                seen.append(np.stack([x, y, yaw], axis=1))
                x, y, yaw = -y, x, yaw + math.pi / 2
        self.seen = np.stack(seen)

    def least(self, other: Plan) -> float:
        """Return a bound that the difference is never below: the share of things whose kind the other one lacks."""
        return self._share((self.counts & other.counts).total(), other)

    def difference(self, other: Plan, below: float = 2.0) -> float:
        """Return the difference of two rooms, 0 (all at the same places) to 1; from `below` on it may be a bound that is no less."""
        apart = self.seen[0][None, :, None] - other.seen[:, None, :]
        turned = np.abs((apart[..., 2] + math.pi) % (2 * math.pi) - math.pi)
        metres = np.hypot(apart[..., 0], apart[..., 1])
        near = (metres <= VARIETY.near) & (turned <= math.radians(VARIETY.alike))
        near &= self.kinds[:, None] == other.kinds[None, :]
        most = np.minimum(near.any(axis=2).sum(axis=1), near.any(axis=1).sum(axis=1))
        if (bound := self._share(int(most.max()), other)) >= below:
            return bound
        return self._share(max(_pairs(np.where(n, m, np.inf)) for n, m in zip(near, metres, strict=True)), other)

    def _share(self, met: int, other: Plan) -> float:
        both = self.counts.total() + other.counts.total()
        return 1.0 - 2.0 * met / both if both else 0.0


def nearest(plan: Plan, others: Sequence[tuple[int, Plan]]) -> tuple[float, int]:
    """Return the least difference of a room from others, and the number of that one; 1 and -1 where there are none."""
    best = (1.0, -1)
    for bound, number, other in sorted(((plan.least(one), n, one) for n, one in others), key=lambda item: item[:2]):
        if bound >= best[0]:
            break
        if (found := plan.difference(other, best[0])) < best[0]:
            best = (found, number)
    return best


def _pairs(apart: NDArray[np.float64]) -> int:
    """Return how many things can be paired one to one, the nearest first; those that cannot are endlessly far apart."""
    found = 0
    while apart.size and np.isfinite(least := apart.min()):
        row, column = np.argwhere(apart == least)[0]
        apart[row, :] = apart[:, column] = np.inf
        found += 1
    return found
