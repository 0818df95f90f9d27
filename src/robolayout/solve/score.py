"""The objective of one thing: what many poses of it cost, what is settled standing where it does.

Rows, weights and formulas are those of the compiled search (`stage`, `arrays`); only the rows that concern the thing are worked out,
by NumPy, so that a batch of places costs a few milliseconds and nothing is compiled for it.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from robolayout._geometry import Array, Body, cut_separation
from robolayout.solve.arrays import (
    Arrays,
    Take,
    boundary_depths,
    clear_depths,
    hard,
    route_depths,
    statement_losses,
    within,
)
from robolayout.solve.compile import Floats
from robolayout.solve.config import Weights
from robolayout.solve.stage import FAR_AWAY, Stage

Mask = NDArray[np.bool_]
Index = NDArray[np.intp]

EXACT = 1e-3
"""Metres by which a hard demand may be missed before it counts as broken, as the judge has it."""


class _SlotRows(NamedTuple):
    """The rows of the objective that concern one slot."""

    frames: Index
    mirrors: Index
    pairs: NDArray[np.int32]  # (p, 2) a prism of the slot and one of another
    clears: Index  # (c, 2) clear boxes and slots that should stay out of them, one of both its own


class Score:
    """The objective of the things of one stage."""

    def __init__(self, stage: Stage, weights: Weights) -> None:
        arrays = Arrays(*(a.astype(np.float64) if a.dtype.kind == "f" else a for a in stage.arrays))
        walls, inner = len(stage.problem.scene.room.walls), np.abs(arrays.inner).max(axis=1) < FAR_AWAY
        self._arrays = arrays._replace(edges=arrays.edges[:walls], inner=arrays.inner[inner])
        self._weights, self._count = weights, len(stage.problem.names)
        self._radius = np.hypot(*self._arrays.half.T)
        self._about = cache(self._sought)

    def hard(self, slot: int, poses: Floats, world: Floats, settled: Mask) -> tuple[Floats, Index]:
        """Return what poses (m, 4) of a slot cost by the hard terms, beside the settled slots (n,) of a world (n, 4).

        Second, how many hard demands each of them breaks.
        """
        rows, take, known = self._about(slot), self._taking(slot, poses, world), self._known(slot, settled)
        arrays, weights, allowed = self._arrays, self._weights, self._weights.margin + EXACT
        pairs = rows.pairs[known[arrays.prism_slot[rows.pairs[:, 1]]]]
        clears = rows.clears[known[arrays.clear_owner[rows.clears[:, 0]]] & known[rows.clears[:, 1]]]
        weight = arrays.clear_weight[tuple(clears.T)]
        overlaps, depth = self._overlaps(slot, poses, world, pairs), clear_depths(take, arrays, clears, weights)
        outside = boundary_depths(take(np.array([slot])), arrays)[:, 0]
        cost = weights.overlap * hard(overlaps, weights).sum(axis=1) + weights.inside * hard(outside, weights)
        broken = (overlaps > allowed).sum(axis=1) + ((depth > allowed) & (weight >= 1.0)).sum(axis=1)
        return cost + weights.clear * (hard(depth, weights) @ weight), broken + (outside > EXACT)

    def statements(self, slot: int, poses: Floats, world: Floats, settled: Mask) -> Floats:
        """Return the weighted sum (m,) of what statements about a slot miss at poses (m, 4); see `hard`."""
        rows, arrays, known = self._about(slot), self._arrays, self._known(slot, settled)
        framed = rows.frames[known[arrays.frame_index[rows.frames]].all(axis=1)]
        mirrored = rows.mirrors[known[arrays.mirror_index[rows.mirrors]].all(axis=1)]
        some = arrays._replace(
            **{name: getattr(arrays, name)[framed] for name in ("frame_index", "frame_row")},
            **{name: getattr(arrays, name)[mirrored] for name in ("mirror_index", "mirror_weight", "mirror_normal")},
        )
        return statement_losses(self._taking(slot, poses, world), some, self._weights)

    def routes(self, slot: int, poses: Floats, demands: Floats) -> Floats:
        """Return what poses (m, 4) of a slot cost by the clearance that they take from routes; see `Plan.demands`."""
        take = self._taking(slot, poses, np.zeros((self._count, 4)))
        short = route_depths(take, demands[demands[:, 2] == slot])
        return self._weights.routes * hard(short, self._weights).sum(axis=1)

    def touched(self, slot: int, poses: Floats, world: Floats) -> set[int]:
        """Return the slots that a slot at some of the poses (m, 4) would go into."""
        pairs = self._about(slot).pairs
        hit = (self._overlaps(slot, poses, world, pairs) > self._weights.margin + EXACT).any(axis=0)
        return set(self._arrays.prism_slot[pairs[hit, 1]].tolist())

    def _sought(self, slot: int) -> _SlotRows:
        """Return the rows of a slot; `_about` looks for them once."""
        arrays = self._arrays
        framed = (arrays.frame_index == slot).any(axis=1) & (arrays.frame_row[:, -1] > 0.0)
        mirrored = (arrays.mirror_index == slot).any(axis=1) & (arrays.mirror_weight > 0.0)
        of, real = arrays.prism_slot[arrays.pairs], arrays.pairs[:, 0] != arrays.pairs[:, 1]
        ours = [arrays.pairs[real & (of[:, side] == slot)][:, [side, 1 - side]] for side in (0, 1)]
        clears = np.argwhere(arrays.clear_weight > 0.0)
        clears = clears[(clears[:, 1] == slot) | (arrays.clear_owner[clears[:, 0]] == slot)]
        return _SlotRows(np.flatnonzero(framed), np.flatnonzero(mirrored), np.concatenate(ours), clears)

    def _known(self, slot: int, settled: Mask) -> Mask:
        """Return which slots, padding included, and fixed bodies have their place."""
        padding, fixed = len(self._arrays.half) - self._count, len(self._arrays.fixed)
        known = np.concatenate([settled, np.zeros(padding, np.bool_), np.ones(fixed, np.bool_)])
        known[slot] = True
        return known

    def _taking(self, slot: int, poses: Floats, world: Floats) -> Take:
        """Return what gives bodies (m, r) beside each pose (m, 4) of a slot, the other slots standing as in a world (n, 4)."""
        half, slots = self._arrays.half, np.zeros((len(self._arrays.half), 7))
        slots[: self._count, :4] = world
        slots[:, 4:6] = half
        table = np.concatenate([slots, self._arrays.fixed]).T
        own = (*poses.T[..., None], *half[slot], 0.0)

        def take(index: Array) -> Body:
            mine = index == slot
            return Body(*(np.where(mine, at, field[index]) for at, field in zip(own, table, strict=True)))

        return take

    def _overlaps(self, slot: int, poses: Floats, world: Floats, pairs: NDArray[np.int32]) -> Floats:
        """Return how deep the prisms of pairs are in each other, plus the margin (m, p)."""
        arrays, depth = self._arrays, np.zeros((len(poses), len(pairs)))
        other, of = np.unique(arrays.prism_slot[pairs[:, 1]], return_inverse=True)
        near = self._radius[slot] + self._radius[other] + self._weights.margin
        apart = np.hypot(poses[:, 0, None] - world[other, 0], poses[:, 1, None] - world[other, 1])
        at, which = np.nonzero((apart < near)[:, of])
        mine, theirs = (arrays.prism[pairs[which, side]] for side in (0, 1))
        one, two = (Body(*place.T, *np.zeros((3, 1))) for place in (poses[at], world[other[of[which]]]))
        gap = cut_separation(within(one, mine), within(two, theirs), mine[:, 4], theirs[:, 4])
        depth[at, which] = np.maximum(self._weights.margin - gap, 0.0)
        return depth
