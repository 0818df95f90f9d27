"""Rectangles along the axes that say what a thing takes of a room wherever it stands, and what it needs before it."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robolayout.assets.obstacles import blocks, use_sides
from robolayout.floor import SIDES, targets_of
from robolayout.scene import Agent, vertical_span
from robolayout.solve.compile import Floats, Problem

ARM = 0.9
"""Share of the reach within which people are said to stand, so that corners are no matter."""

Rects = NDArray[np.float64]
"""(n, 4): low x, low y, high x, high y in metres."""


class Zones:
    """The bounds of things and of the floor that they need, for the widest body.

    Args:
        problem: The problem.
        agent: The body.

    Attributes:
        solid: (n,) which slots are no rugs.
        blocks: (n,) which of them are in the body's way.
        fronts: (n,) which are used from the front.
        landings: (d, 4) the floor that doors need.
    """

    def __init__(self, problem: Problem, agent: Agent) -> None:
        assets, room = problem.scene.assets, problem.scene.room
        self._half = problem.half
        spans = [vertical_span(asset, problem.guess[asset.name]) for asset in assets]
        self._low, self._high = np.array(spans).reshape(-1, 2).T
        self.solid = np.array([not asset.is_flat for asset in assets])
        self.blocks = np.array([blocks(asset, problem.guess[asset.name].z, agent) for asset in assets])
        targets = targets_of(problem.contents, agent)
        sides, self._reach = np.zeros((len(assets), len(SIDES)), np.bool_), np.zeros(len(assets))
        sides[targets.slots], self._reach[targets.slots] = targets.sides, ARM * targets.reach
        self.fronts = np.array(["front" in use_sides(asset) for asset in assets])
        self._ahead_only = sides[:, 0] & ~sides[:, 1:].any(axis=1)
        landings = [np.array(room.landing(door)) for door in room.doors]
        self.landings = np.array([[*corners.min(axis=0), *corners.max(axis=0)] for corners in landings]).reshape(-1, 4)

    def level(self, slot: int) -> NDArray[np.bool_]:
        """Return which slots (n,), itself among them, are solid at heights at which a slot would collide with them."""
        return self.solid & self.solid[slot] & (self._low < self._high[slot]) & (self._high > self._low[slot])

    def bodies(self, slots: ArrayLike, poses: Floats) -> Rects:
        """Return the bounds of slots (m,), or of one slot, at their poses (m, 4)."""
        return _bounds(poses[:, :2], poses[:, 2:], *self._half[np.asarray(slots, dtype=np.intp)].T)

    def stands(self, slots: ArrayLike, poses: Floats) -> Rects:
        """Return the bounds of where a body has slots (m,), or one slot, within reach; nothing of what needs no reaching."""
        index = np.asarray(slots, dtype=np.intp)
        (hx, hy), reach = self._half[index].T, self._reach[index]
        around = _bounds(poses[:, :2], poses[:, 2:], hx + reach, hy + reach)
        around[..., 2:] = np.where((reach > 0)[..., None], around[..., 2:], around[..., :2])
        middle = poses[:, :2] + np.asarray(hx + reach / 2)[..., None] * poses[:, 2:]
        return np.where(self._ahead_only[index][..., None], _bounds(middle, poses[:, 2:], reach / 2, hy), around)


def _bounds(center: Floats, heading: Floats, hx: Floats | float, hy: Floats | float) -> Rects:
    """Return the bounds of rectangles with these middles and unit headings (m, 2) and half sizes (m,)."""
    c, s = np.abs(heading).T
    reach = np.empty(center.shape)
    reach[:, 0], reach[:, 1] = c * hx + s * hy, s * hx + c * hy
    return np.concatenate([center - reach, center + reach], axis=1)
