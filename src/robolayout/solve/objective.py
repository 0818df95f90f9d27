"""The objective: one sum over statements, overlaps, the room, clear boxes and routes, for a whole batch of starts."""

from __future__ import annotations

import jax.numpy as jnp
from jax.lax import stop_gradient
from jaxtyping import Array, Float

from robolayout._geometry import (
    Body,
    FrameRow,
    compose,
    corners,
    frame_residual,
    mirror_residual,
    penetration,
    point_to_box,
    signed_distance,
)
from robolayout.solve.arrays import Arrays, Losses, Routes
from robolayout.solve.config import Weights

Poses = Float[Array, "starts slots 4"]


def world_poses(local: Poses, arrays: Arrays) -> Poses:
    """Return poses in the room: variables composed with their anchor or with the slot that carries them."""
    placed = compose(jnp.broadcast_to(arrays.anchor, local.shape), local)
    carried = compose(placed[:, jnp.maximum(arrays.carrier, 0)], local)
    return jnp.where((arrays.carrier >= 0)[None, :, None], carried, placed)


def bodies(world: Poses, arrays: Arrays) -> Body:
    """Return slots and fixed bodies as one batch of shape (starts, slots + fixed)."""
    starts = world.shape[0]
    zero = jnp.zeros((starts, world.shape[1]))
    half = jnp.broadcast_to(arrays.half, (starts, *arrays.half.shape))
    columns = [*(world[..., i] for i in range(4)), half[..., 0], half[..., 1], zero]
    fixed = jnp.broadcast_to(arrays.fixed, (starts, *arrays.fixed.shape))
    return Body(*(jnp.concatenate([column, fixed[..., i]], axis=1) for i, column in enumerate(columns)))


def take(body: Body, index: Array) -> Body:
    """Return the bodies of those indices, for every start."""
    return Body(*(field[:, index] for field in body))


def _yielding(body: Body, move: Float[Array, " rows"]) -> Body:
    """Return the same bodies, with the gradient of their pose scaled by `move`."""

    def scaled(value: Array) -> Array:
        still = stop_gradient(value)
        return still + move * (value - still)

    return body._replace(x=scaled(body.x), y=scaled(body.y), c=scaled(body.c), s=scaled(body.s))


def hard(depth: Array, weights: Weights) -> Array:
    """Return d^2 + hinge d for a depth of violation in metres."""
    return depth * depth + weights.hinge * depth


def statement_residuals(body: Body, arrays: Arrays) -> tuple[Array, Array]:
    """Return the residuals of all frame rows (starts, R) and mirror rows (starts, M), unweighted."""
    row = FrameRow(*(arrays.frame_row[:, i] for i in range(arrays.frame_row.shape[1])))
    a = _yielding(take(body, arrays.frame_index[:, 0]), row.move_a)
    b = _yielding(take(body, arrays.frame_index[:, 1]), row.move_b)
    left, right = take(body, arrays.mirror_index[:, 0]), take(body, arrays.mirror_index[:, 1])
    axis = _yielding(take(body, arrays.mirror_index[:, 2]), jnp.zeros_like(arrays.mirror_weight))
    return frame_residual(a, b, row), mirror_residual(left, right, axis, arrays.mirror_normal)


def overlap_depths(body: Body, pairs: Array, weights: Weights) -> Array:
    """Return by how many metres each pair goes into each other, margin included."""
    if pairs.ndim == 2:
        return penetration(take(body, pairs[:, 0]), take(body, pairs[:, 1]), weights.margin)
    rows = jnp.arange(pairs.shape[0])[:, None]
    first = Body(*(field[rows, pairs[..., 0]] for field in body))
    second = Body(*(field[rows, pairs[..., 1]] for field in body))
    return penetration(first, second, weights.margin)


def boundary_depths(slots: Body, arrays: Arrays) -> Array:
    """Return by how many metres each slot leaves the room (starts, A): corners outside, or inner corners inside it."""
    px, py = corners(slots)
    outside = jnp.maximum(signed_distance(px, py, arrays.edges), 0.0)
    spread = Body(*(field[..., None] for field in slots))
    pierced = jnp.maximum(-point_to_box(arrays.inner[:, 0], arrays.inner[:, 1], spread), 0.0)
    return jnp.sum(outside, axis=-1) + jnp.sum(pierced, axis=-1)


def clear_depths(body: Body, arrays: Arrays, weights: Weights) -> Array:
    """Return by how many metres each slot is in each clear box (starts, G, A)."""
    owner = take(body, arrays.clear_owner)
    cx, cy, hx, hy = (arrays.clear_box[:, i] for i in range(4))
    strip = Body(
        owner.x + owner.c * cx - owner.s * cy,
        owner.y + owner.s * cx + owner.c * cy,
        owner.c,
        owner.s,
        jnp.broadcast_to(hx, owner.x.shape),
        jnp.broadcast_to(hy, owner.x.shape),
        jnp.zeros_like(owner.x),
    )
    slots = take(body, jnp.arange(arrays.half.shape[0]))
    left = Body(*(field[:, :, None] for field in strip))
    right = Body(*(field[:, None, :] for field in slots))
    return penetration(left, right, weights.margin)


def route_depths(body: Body, routes: Routes) -> Array:
    """Return by how many metres each route point lacks clearance from its slot (starts, T)."""
    rows = jnp.arange(routes.slot.shape[0])[:, None]
    near = Body(*(field[rows, routes.slot] for field in body))
    distance = point_to_box(routes.point[..., 0], routes.point[..., 1], near)
    return jnp.maximum(routes.need - distance, 0.0)


def losses(local: Poses, arrays: Arrays, routes: Routes, pairs: Array, weights: Weights) -> Losses:
    """Return every term of the objective per start; `pairs` are indices into slots, (P, 2) or per start (starts, M, 2).

    Statements saturate: s log(1 + r / s), so that one that cannot be met stops pulling at the others.
    """
    body = bodies(world_poses(local, arrays), arrays)
    slots = take(body, jnp.arange(arrays.half.shape[0]))
    overlap = hard(overlap_depths(body, pairs, weights), weights)
    weight = arrays.pair_weight if pairs.ndim == 2 else _pair_weights(pairs, arrays)
    framed, mirrored = statement_residuals(body, arrays)
    scale = weights.saturation
    pull = jnp.sum(scale * jnp.log1p(framed / scale) * arrays.frame_row[:, -1], axis=-1)
    pull += jnp.sum(scale * jnp.log1p(mirrored / scale) * arrays.mirror_weight, axis=-1)
    return Losses(
        overlap=jnp.sum(overlap * weight, axis=-1),
        boundary=jnp.sum(hard(boundary_depths(slots, arrays), weights) * arrays.inside, axis=-1),
        clear=jnp.sum(hard(clear_depths(body, arrays, weights), weights) * arrays.clear_weight, axis=(1, 2)),
        statements=pull,
        reachability=jnp.sum(hard(route_depths(body, routes), weights), axis=-1),
    )


def _pair_weights(pairs: Array, arrays: Arrays) -> Array:
    """Return 1 for real pairs of a neighbour list, 0 for its padding (a slot paired with itself)."""
    return jnp.where(pairs[..., 0] == pairs[..., 1], 0.0, 1.0)


def total(parts: Losses, ramp: Array, weights: Weights) -> Array:
    """Return the weighted sum per start, hard terms scaled by `ramp`."""
    hard_sum = (
        weights.overlap * parts.overlap
        + weights.inside * parts.boundary
        + weights.clear * parts.clear
        + weights.routes * parts.reachability
    )
    return parts.statements + ramp * hard_sum
