"""Rectangles along the axes that say what a thing takes of a room wherever it stands, and what it needs before it."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray

from robolayout.assets import category_of
from robolayout.assets.obstacles import blocks, use_sides
from robolayout.floor import SIDES, targets_of
from robolayout.scene import Agent, Room, vertical_span
from robolayout.solve.compile import Floats, Problem

ARM = 0.9
"""Share of the reach within which people are said to stand, so that corners are no matter."""

DEEPEST = 1.0
"""Metres of floor in front of a thing beyond which nothing is in the way of its use."""

SQUARE = 1e-9
"""Metres by which a wall along an axis may slant."""

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
        fixed: (n,) which slots nobody moves in daily use.
        fronts: (n,) which are used from the front.
        opens: (n,) which need room in front to be opened.
        landings: (d, 4) the floor that doors need.
    """

    def __init__(self, problem: Problem, agent: Agent) -> None:
        assets, kinds = problem.scene.assets, [category_of(asset) for asset in problem.scene.assets]
        self._half, self._room = problem.half, problem.scene.room
        self._floor = shapely.Polygon(self._room.vertices)
        shapely.prepare(self._floor)
        self._missing = _missing(self._room)
        spans = [vertical_span(asset, problem.guess[asset.name]) for asset in assets]
        self._low, self._high = np.array(spans).reshape(-1, 2).T
        self.solid = np.array([not asset.is_flat for asset in assets])
        self.blocks = np.array([blocks(asset, problem.guess[asset.name].z, agent) for asset in assets])
        self.fixed = np.array([not kind.movable for kind in kinds])
        self._opening = np.array([kind.open_depth for kind in kinds])
        self.opens = self._opening > 0
        self._depth = min(2 * agent.radius + 0.05, DEEPEST)
        targets = targets_of(problem.contents, agent)
        sides, self._reach = np.zeros((len(assets), len(SIDES)), np.bool_), np.zeros(len(assets))
        sides[targets.slots], self._reach[targets.slots] = targets.sides, ARM * targets.reach
        self.fronts = np.array(["front" in use_sides(asset) for asset in assets])
        self._ahead_only = sides[:, 0] & ~sides[:, 1:].any(axis=1)
        landings = [np.array(self._room.landing(door)) for door in self._room.doors]
        self.landings = np.array([[*corners.min(axis=0), *corners.max(axis=0)] for corners in landings]).reshape(-1, 4)

    def level(self, slot: int) -> NDArray[np.bool_]:
        """Return which slots (n,), itself among them, are solid at heights at which a slot would collide with them."""
        return self.solid & self.solid[slot] & (self._low < self._high[slot]) & (self._high > self._low[slot])

    def bodies(self, slots: ArrayLike, poses: Floats) -> Rects:
        """Return the bounds of slots (m,), or of one slot, at their poses (m, 4)."""
        return _bounds(poses[:, :2], poses[:, 2:], *self._half[np.asarray(slots, dtype=np.intp)].T)

    def ahead(self, slots: ArrayLike, poses: Floats) -> Rects:
        """Return the bounds of the floor on which people stand in front of slots (m,), or of one slot, at their poses."""
        return self._before(slots, poses, self._depth)

    def openings(self, slots: ArrayLike, poses: Floats) -> Rects:
        """Return the bounds of what slots (m,), or one slot, need at their poses to be opened."""
        return self._before(slots, poses, self._opening[np.asarray(slots, dtype=np.intp)])

    def stands(self, slots: ArrayLike, poses: Floats) -> Rects:
        """Return the bounds of where a body has slots (m,), or one slot, within reach; nothing of what needs no reaching."""
        index = np.asarray(slots, dtype=np.intp)
        (hx, hy), reach = self._half[index].T, self._reach[index]
        around = _bounds(poses[:, :2], poses[:, 2:], hx + reach, hy + reach)
        around[..., 2:] = np.where((reach > 0)[..., None], around[..., 2:], around[..., :2])
        return np.where(self._ahead_only[index][..., None], self._before(slots, poses, reach), around)

    def outside(self, rects: Rects) -> Floats:
        """Return which share of each rectangle (m, 4) is not on the floor; where walls slant, of nine points of it."""
        if self._missing is not None:
            inside = shared(rects, np.array([self._room.bounds]))[:, 0] - shared(rects, self._missing).sum(axis=1)
            return np.maximum(1.0 - inside / area(rects), 0.0)
        shares = np.linspace(0.002, 0.998, 3)
        x = rects[:, 0, None] + shares * (rects[:, 2] - rects[:, 0])[:, None]
        y = rects[:, 1, None] + shares * (rects[:, 3] - rects[:, 1])[:, None]
        points = np.broadcast_arrays(x[:, :, None], y[:, None, :])
        return 1.0 - shapely.contains_xy(self._floor, *points).reshape(len(rects), -1).mean(axis=1)

    def _before(self, slots: ArrayLike, poses: Floats, depth: Floats | float) -> Rects:
        """Return the bounds of rectangles of some depth (m,) in front of slots (m,), as wide as these."""
        hx, hy = self._half[np.asarray(slots, dtype=np.intp)].T
        middle = poses[:, :2] + np.asarray(hx + depth / 2)[..., None] * poses[:, 2:]
        return _bounds(middle, poses[:, 2:], depth / 2, hy)


def _missing(room: Room) -> Rects | None:
    """Return what a room with square corners lacks of its bounds, as rectangles (k, 4); None if its walls slant."""
    corners = np.array(room.vertices)
    if np.abs(corners - np.roll(corners, 1, axis=0)).min(axis=1).max() > SQUARE:
        return None
    (x, y), floor = (sorted(set(at)) for at in corners.T.tolist()), shapely.Polygon(corners)
    cells = np.array([(x0, y0, x1, y1) for x0, x1 in pairwise(x) for y0, y1 in pairwise(y)])
    return cells[~shapely.contains_xy(floor, *((cells[:, :2] + cells[:, 2:]) / 2).T)]


def shared(a: Rects, b: Rects) -> Floats:
    """Return the areas (m, n) that rectangles (m, 4) and (n, 4) share."""
    wide, long = (np.minimum(a[:, k + 2, None], b[:, k + 2]) - np.maximum(a[:, k, None], b[:, k]) for k in (0, 1))
    return np.maximum(wide, 0.0) * np.maximum(long, 0.0)


def area(rects: Rects) -> Floats:
    """Return the areas (n,) of rectangles (n, 4), never nothing."""
    return np.maximum((rects[:, 2] - rects[:, 0]) * (rects[:, 3] - rects[:, 1]), 1e-9)


def _bounds(center: Floats, heading: Floats, hx: Floats | float, hy: Floats | float) -> Rects:
    """Return the bounds of rectangles with these middles and unit headings (m, 2) and half sizes (m,)."""
    c, s = np.abs(heading).T
    reach = np.empty(center.shape)
    reach[:, 0], reach[:, 1] = c * hx + s * hy, s * hx + c * hy
    return np.concatenate([center - reach, center + reach], axis=1)
