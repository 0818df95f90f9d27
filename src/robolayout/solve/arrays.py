"""The arrays that a compiled search takes, and what single terms of the objective make of them, for NumPy and JAX alike.

Everything about a scene is data, padded to a few sizes; the fields say the shapes: K starts, A asset slots, F fixed bodies, S
prisms, P pairs, R frame rows, M mirror rows, G clear boxes, E room edges, Q inner corners. Terms are told of rows by the indices
of what these are about, and `take` says where that stands: in each of a batch of layouts, or at each pose that one thing might
have among others that stay.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from robolayout._geometry import (
    Array,
    Body,
    FrameRow,
    backend,
    corners,
    frame_residual,
    mirror_residual,
    penetration,
    point_to_box,
    signed_distance,
)
from robolayout.solve.config import Weights


class Arrays(NamedTuple):
    """One stage of a problem as arrays."""

    half: Array  # (A, 2) half depth and half width in metres; 0 for padding
    anchor: Array  # (A, 4) pose (x, y, cos, sin) that each slot's variables are relative to
    carrier: Array  # (A,) slot whose moving pose a slot is rigidly attached to; -1 for none
    limit: Array  # (A, 2) half sizes in metres of the rectangle around the anchor that a slot's box stays in
    free: Array  # (A, 3) 1 where the slot moves in this stage along x and y, and turns
    fixed: Array  # (F, 7) walls and points as bodies (x, y, cos, sin, half x, half y, core)
    prism_slot: Array  # (S,) slot that each prism belongs to
    prism: Array  # (S, 5) centre and half size in the frame of the slot, and how much its corners are cut, metres
    pairs: Array  # (P, 2) prisms that must not overlap; twice the same for padding
    edges: Array  # (E, 4) room outline
    inner: Array  # (Q, 2) corners of the room that point inwards
    inside: Array  # (A,) weight of staying in the room, where the rectangle alone does not keep a slot in it
    frame_index: Array  # (R, 2) bodies a and b of each frame row (slots first, then fixed bodies)
    frame_row: Array  # (R, 20) numbers of each frame row
    mirror_index: Array  # (M, 3) bodies a, b and axis
    mirror_weight: Array  # (M,) 0 for padding
    mirror_normal: Array  # (M,) 1 where the axis is a wall
    clear_owner: Array  # (G,) body that each clear box belongs to
    clear_box: Array  # (G, 4) centre and half size in the owner's frame, metres
    clear_weight: Array  # (G, A) weight of keeping each slot out of each box


class Touching(NamedTuple):
    """What may touch within the next steps."""

    pairs: Array  # (M, 2) prisms, or (K, M, 2) each start's own
    clears: Array  # (C, 2) clear box and slot, or (K, C, 2) each start's own


class Losses(NamedTuple):
    """The terms of the objective for each start, each (K,)."""

    overlap: Array
    boundary: Array
    clear: Array
    statements: Array
    reachability: Array


SNAPSHOTS = 40
"""Poses that one run records."""

HISTORY = 512
"""Steps whose losses one run records."""

Take = Callable[[Array], Body]
"""Gives the bodies of those indices: the same (M,) for every start, or (starts, M) each start's own."""


def hard(depth: Array, weights: Weights) -> Array:
    """Return d^2 + hinge d for a depth of violation in metres."""
    return depth * depth + weights.hinge * depth


def hard_part(parts: Losses, weights: Weights, routes: Array | float = 1.0) -> Array:
    """Return the weighted sum of the hard terms per start, that of the routes scaled by `routes`."""
    kept = weights.overlap * parts.overlap + weights.inside * parts.boundary
    return kept + weights.clear * parts.clear + weights.routes * routes * parts.reachability


def yielding(box: Body, move: Array | float) -> Body:
    """Return the same boxes, with the gradient along their pose scaled by `move`: 0 holds them, 1 changes nothing."""
    if backend(box.x) is np:
        return box
    from jax.lax import stop_gradient

    def scaled(value: Array) -> Array:
        still = stop_gradient(value)
        return still + move * (value - still)

    return box._replace(x=scaled(box.x), y=scaled(box.y), c=scaled(box.c), s=scaled(box.s))


def statement_residuals(take: Take, rows: Any, loose: Array | float = 0.0) -> tuple[Array, Array]:
    """Return the residuals of all frame rows (starts, R) and mirror rows (starts, M) of arrays, unweighted.

    What a statement refers to yields as far as `loose` says: 0 where only the row itself says who moves, 1 wholly.
    """
    row = FrameRow(*rows.frame_row.T)
    xp = backend(row.weight)
    a = yielding(take(rows.frame_index[:, 0]), xp.maximum(row.move_a, loose))
    b = yielding(take(rows.frame_index[:, 1]), xp.maximum(row.move_b, loose))
    left, right, axis = (take(index) for index in rows.mirror_index.T)
    return frame_residual(a, b, row), mirror_residual(left, right, yielding(axis, loose), rows.mirror_normal)


def statement_losses(take: Take, arrays: Arrays, weights: Weights) -> Array:
    """Return the weighted sum (starts,) of s log(1 + r / s) of all residuals: one that cannot be met stops pulling at the others."""
    framed, mirrored = statement_residuals(take, arrays)
    xp, most = backend(framed), weights.saturation
    pull = xp.sum(most * xp.log1p(framed / most) * arrays.frame_row[:, -1], axis=-1)
    return pull + xp.sum(most * xp.log1p(mirrored / most) * arrays.mirror_weight, axis=-1)


def boundary_depths(slots: Body, arrays: Arrays) -> Array:
    """Return by how many metres each slot leaves the room: corners outside, or inner corners inside it."""
    xp = backend(slots.x)
    px, py = corners(slots)
    outside = xp.maximum(signed_distance(px, py, arrays.edges), 0.0)
    spread = Body(*(field[..., None] for field in slots))
    pierced = xp.maximum(-point_to_box(arrays.inner[:, 0], arrays.inner[:, 1], spread), 0.0)
    return xp.sum(outside, axis=-1) + xp.sum(pierced, axis=-1)


def clear_depths(take: Take, arrays: Arrays, clears: Array, weights: Weights) -> Array:
    """Return by how many metres slots are in clear boxes, for pairs (..., 2) of a box and a slot."""
    boxes = clears[..., 0]
    strips = within(take(arrays.clear_owner[boxes]), arrays.clear_box[boxes])
    return penetration(strips, take(clears[..., 1]), weights.margin)


def route_depths(take: Take, demands: Array) -> Array:
    """Return by how many metres each route point lacks clearance from its slot (starts, T); see `Plan.demands`."""
    x, y, slot, need = (demands[..., i] for i in range(4))
    short = need - point_to_box(x, y, take(slot.astype("int32")))
    return backend(short).maximum(short, 0.0)


def within(owner: Body, box: Array) -> Body:
    """Return boxes, rows (..., n, 4 or more) of centre and half size in the frames of their owners, where these are."""
    xp = backend(owner.x)
    cx, cy, hx, hy = (box[..., i] for i in range(4))
    x = owner.x + owner.c * cx - owner.s * cy
    return owner._replace(
        x=x,
        y=owner.y + owner.s * cx + owner.c * cy,
        hx=xp.broadcast_to(hx, x.shape),
        hy=xp.broadcast_to(hy, x.shape),
        core=xp.zeros_like(x),
    )
