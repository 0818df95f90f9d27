"""The paper's loss as data: who must not overlap, who stands on whom, who leaves room for the agent, what is said."""

from __future__ import annotations

from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from robolayout.constraints import FrameTerm, MirrorTerm, PairwiseTerm, ReachablePairwise
from robolayout.constraints.no_overlap import share_height
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.solve.compile import Problem
from robolayout.solve.stage import Bodies, bucket, padded

Array = Any


class Table(NamedTuple):
    """The loss of one scene, rows padded with weight 0. A slots, F fixed bodies, P pairs, S stacks, R frame and M mirror rows."""

    half: Array  # (A, 2) half depth and half width in metres
    fixed: Array  # (F, 7) walls and points as bodies (x, y, cos, sin, half x, half y, core)
    pairs: Array  # (P, 2) slots that must not overlap
    pair_weight: Array  # (P,) 1 for real pairs
    required: Array  # (P,) metres between the centres of each pair that let the agent pass; 0 where it need not
    stacks: Array  # (S, 2) upper and lower slot of each stack
    stack_weight: Array  # (S,) 1 for real stacks
    frame_index: Array  # (R, 2) bodies a and b of each frame row (slots first, then fixed bodies)
    frame_row: Array  # (R, 20) numbers of each frame row
    mirror_index: Array  # (M, 3) bodies a, b and axis
    mirror_weight: Array  # (M,) weight of each mirror row
    mirror_normal: Array  # (M,) 1 where the axis is a wall
    held: Array  # 1 if statements only move what they are about, 0 if also what they refer to


def make_table(problem: Problem, *, held: bool) -> Table:
    """Return the paper's loss of a problem: its statements, overlaps and the pairwise reach, but no term of our own.

    `held` lets the gradient of a statement leave alone what it refers to, as in the paper's algorithm.
    """
    bodies = Bodies(problem)
    size = bodies.size
    half = np.ones((size, 2))
    half[: len(problem.names)] = problem.half
    stacks = [[i, parent] for i, parent in enumerate(problem.parent) if parent >= 0]
    overlaps, required = overlap_pairs(problem), reach_pairs(problem)
    pairs = sorted({*overlaps, *required})
    said = [t for r in problem.relations if not isinstance(r, OnTopOf) for t in r.terms(problem.scene, problem.guess)]
    frames = [term for term in said if isinstance(term, FrameTerm)]
    mirrors = [term for term in said if isinstance(term, MirrorTerm)]
    everyone = size * (size - 1) // 2
    rows = {
        **bodies.frames(frames, bucket(len(frames), (4 * size, 16 * size))),
        **bodies.mirrors(mirrors, bucket(len(mirrors), (size, 4 * size))),
    }
    return Table(
        half=half,
        fixed=bodies.fixed_bodies(),
        pairs=padded(pairs, everyone, [0, 0], np.int32),
        pair_weight=padded([float(pair in overlaps) for pair in pairs], everyone, 0.0),
        required=padded([required.get(pair, 0.0) for pair in pairs], everyone, 0.0),
        stacks=padded(stacks, size, [0, 0], np.int32),
        stack_weight=padded([1.0] * len(stacks), size, 0.0),
        held=np.float64(held),
        **rows,
    )


def overlap_pairs(problem: Problem) -> set[tuple[int, int]]:
    """Return the pairs of slots whose boxes must not overlap: those at one height, stacks aside."""
    assets = problem.scene.assets
    pairs = combinations(range(len(assets)), 2)
    return {(a, b) for a, b in pairs if _apart(problem, a, b) and share_height(assets[a], assets[b], problem.guess)}


def reach_pairs(problem: Problem) -> dict[tuple[int, int], float]:
    """Return the pairs that must let the agent pass, with the metres between their centres that this takes."""
    terms = ReachablePairwise().terms(problem.scene, problem.guess)
    rows = ((problem.slot[t.a.name], problem.slot[t.b.name], t.required) for t in terms if isinstance(t, PairwiseTerm))
    return {(a, b): required for a, b, required in rows if _apart(problem, a, b)}


def _apart(problem: Problem, a: int, b: int) -> bool:
    """Return whether neither of two slots stands on the other."""
    return problem.parent[a] != b and problem.parent[b] != a
