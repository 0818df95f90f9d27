"""The objective of one thing: what many poses of it cost, what is settled standing where it does.

Rows, weights and formulas are those of the compiled search (`stage`, `terms`); only the rows that concern the thing are worked out,
by NumPy, so that a batch of places costs a few milliseconds and nothing is compiled for it.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from robolayout._geometry import (
    Body,
    FrameRow,
    cut_separation,
    frame_residual,
    mirror_residual,
    penetration,
    point_to_box,
)
from robolayout.solve.arrays import Arrays
from robolayout.solve.compile import Floats
from robolayout.solve.config import Weights
from robolayout.solve.stage import FAR_AWAY, Stage
from robolayout.solve.terms import boundary_depths, hard, saturated, within

Mask = NDArray[np.bool_]
Index = NDArray[np.intp]

EXACT = 1e-3
"""Metres by which a hard demand may be missed before it counts as broken, as the judge has it."""


class _Rows(NamedTuple):
    """The rows of the objective that concern one slot."""

    frames: tuple[Index, Index]  # frame rows that place it, and those that place another by it
    mirrors: Index
    pairs: NDArray[np.int32]  # (p, 2) a prism of the slot and one of another
    held: Index  # (c, 2) clear boxes that it should stay out of, and itself
    kept: Index  # (c, 2) its own clear boxes and who should stay out of them


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
        rows, table, known = self._about(slot), self._table(world), self._known(slot, settled)
        own, arrays, clear = self._own(slot, poses), self._arrays, self._weights.clear
        overlaps = self._overlaps(slot, poses, table, rows.pairs[known[arrays.prism_slot[rows.pairs[:, 1]]]])
        cost = self._weights.overlap * hard(overlaps, self._weights).sum(axis=1)
        broken = (overlaps > self._weights.margin + EXACT).sum(axis=1)
        held = rows.held[known[arrays.clear_owner[rows.held[:, 0]]]]
        kept = rows.kept[known[rows.kept[:, 1]]]
        owners, others = _at(table, arrays.clear_owner[held[:, 0]]), _at(table, kept[:, 1])
        for clears, owner, other in ((held, owners, own), (kept, own, others)):
            if len(clears):
                depth = penetration(within(owner, arrays.clear_box[clears[:, 0]]), other, self._weights.margin)
                weight = arrays.clear_weight[tuple(clears.T)]
                cost += clear * (hard(depth, self._weights) @ weight)
                broken += ((depth > self._weights.margin + EXACT) & (weight >= 1.0)).sum(axis=1)
        outside = boundary_depths(Body(*(field[:, 0] for field in own)), arrays)
        return cost + self._weights.inside * hard(outside, self._weights), broken + (outside > EXACT)

    def statements(self, slot: int, poses: Floats, world: Floats, settled: Mask) -> Floats:
        """Return the weighted sum (m,) of what statements about a slot miss at poses (m, 4); see `hard`."""
        rows, table, known = self._about(slot), self._table(world), self._known(slot, settled)
        own, arrays, total = self._own(slot, poses), self._arrays, np.zeros(len(poses))
        for side, frames in enumerate(rows.frames):
            others = arrays.frame_index[frames, 1 - side]
            some, others = frames[known[others]], others[known[others]]
            if len(some):
                pair = (own, _at(table, others)) if side == 0 else (_at(table, others), own)
                missed = frame_residual(*pair, FrameRow(*arrays.frame_row[some].T))
                total += saturated(missed, self._weights) @ arrays.frame_row[some, -1]
        some = rows.mirrors[known[arrays.mirror_index[rows.mirrors]].all(axis=1)]
        if len(some):
            left, right, axis = (self._taken(index, slot, own, table) for index in arrays.mirror_index[some].T)
            missed = mirror_residual(left, right, axis, arrays.mirror_normal[some])
            total += saturated(missed, self._weights) @ arrays.mirror_weight[some]
        return total

    def routes(self, slot: int, poses: Floats, demands: Floats) -> Floats:
        """Return what poses (m, 4) of a slot cost by the clearance that they take from routes; see `Plan.demands`."""
        x, y, _, need = demands[demands[:, 2] == slot].T
        short = np.maximum(need - point_to_box(x, y, self._own(slot, poses)), 0.0)
        return self._weights.routes * hard(short, self._weights).sum(axis=1)

    def touched(self, slot: int, poses: Floats, world: Floats) -> set[int]:
        """Return the slots that a slot at some of the poses (m, 4) would go into."""
        pairs = self._about(slot).pairs
        hit = (self._overlaps(slot, poses, self._table(world), pairs) > self._weights.margin + EXACT).any(axis=0)
        return set(self._arrays.prism_slot[pairs[hit, 1]].tolist())

    def _sought(self, slot: int) -> _Rows:
        """Return the rows of a slot; `_about` looks for them once."""
        arrays = self._arrays
        weighed = arrays.frame_row[:, -1] > 0.0
        first, second = (np.flatnonzero((arrays.frame_index[:, side] == slot) & weighed) for side in (0, 1))
        mirrored = (arrays.mirror_index == slot).any(axis=1) & (arrays.mirror_weight > 0.0)
        of, real = arrays.prism_slot[arrays.pairs], arrays.pairs[:, 0] != arrays.pairs[:, 1]
        ours = [arrays.pairs[real & (of[:, side] == slot)][:, [side, 1 - side]] for side in (0, 1)]
        clears = np.argwhere(arrays.clear_weight > 0.0)
        held, kept = clears[:, 1] == slot, arrays.clear_owner[clears[:, 0]] == slot
        return _Rows((first, second), np.flatnonzero(mirrored), np.concatenate(ours), clears[held], clears[kept])

    def _known(self, slot: int, settled: Mask) -> Mask:
        """Return which slots, padding included, and fixed bodies have their place."""
        known = np.ones(len(self._arrays.half) + len(self._arrays.fixed), np.bool_)
        known[: len(self._arrays.half)] = False
        known[: self._count] = settled
        known[slot] = True
        return known

    def _table(self, world: Floats) -> Body:
        """Return slots, padding included, and fixed bodies."""
        slots = np.zeros((len(self._arrays.half), 7))
        slots[: self._count, :4] = world
        slots[:, 4:6] = self._arrays.half
        return Body(*np.concatenate([slots, self._arrays.fixed]).T)

    def _own(self, slot: int, poses: Floats) -> Body:
        """Return a slot at its poses (m, 1)."""
        half, none = self._arrays.half[slot], np.zeros((len(poses), 1))
        x, y, c, s = poses.T[..., None]
        return Body(x, y, c, s, none + half[0], none + half[1], none)

    def _taken(self, index: Index, slot: int, own: Body, table: Body) -> Body:
        """Return the bodies of some indices (r,) for each pose of a slot (m, r)."""
        mine = index == slot
        return Body(*(np.where(mine, at, field[index]) for at, field in zip(own, table, strict=True)))

    def _overlaps(self, slot: int, poses: Floats, table: Body, pairs: NDArray[np.int32]) -> Floats:
        """Return how deep the prisms of pairs are in each other, plus the margin (m, p)."""
        arrays, depth = self._arrays, np.zeros((len(poses), len(pairs)))
        other = arrays.prism_slot[pairs[:, 1]]
        near = self._radius[slot] + self._radius[other] + self._weights.margin
        apart = np.hypot(poses[:, 0, None] - table.x[other], poses[:, 1, None] - table.y[other])
        at, which = np.nonzero(apart < near)
        mine, theirs = pairs[which].T
        own = Body(*(field[at, 0] for field in self._own(slot, poses)))
        shapes = within(own, arrays.prism[mine]), within(_at(table, other[which]), arrays.prism[theirs])
        gap = cut_separation(*shapes, arrays.prism[mine, 4], arrays.prism[theirs, 4])
        depth[at, which] = np.maximum(self._weights.margin - gap, 0.0)
        return depth


def _at(table: Body, index: Index) -> Body:
    """Return the bodies of some indices."""
    return Body(*(field[index] for field in table))
