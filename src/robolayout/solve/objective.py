"""The objective: one sum over statements, overlaps, the room, clear boxes and routes, for a whole batch of starts."""

from __future__ import annotations

import jax.numpy as jnp
from jax.lax import cond, stop_gradient
from jaxtyping import Array, Float

from robolayout._geometry import (
    Body,
    FrameRow,
    compose,
    cut_separation,
    frame_residual,
    intersection_over_union,
    mirror_residual,
    penetration,
    point_to_box,
)
from robolayout.solve.arrays import Arrays, Losses, Near, Routes
from robolayout.solve.config import Weights
from robolayout.solve.terms import boundary_depths, hard, hard_part, saturated, within

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


def yielding(box: Body, move: Float[Array, "*#batch"]) -> Body:
    """Return the same boxes, with the gradient along their pose scaled by `move`: 0 holds them, 1 changes nothing."""

    def scaled(value: Array) -> Array:
        still = stop_gradient(value)
        return still + move * (value - still)

    return box._replace(x=scaled(box.x), y=scaled(box.y), c=scaled(box.c), s=scaled(box.s))


def take(body: Body, index: Array) -> Body:
    """Return the bodies of those indices: the same (M,) for every start, or (starts, M) each start's own."""
    if index.ndim == 1:
        return Body(*(field[:, index] for field in body))
    rows = jnp.arange(index.shape[0])[:, None]
    return Body(*(field[rows, index] for field in body))


def statement_residuals(body: Body, arrays: Arrays) -> tuple[Array, Array]:
    """Return the residuals of all frame rows (starts, R) and mirror rows (starts, M), unweighted."""
    row = FrameRow(*(arrays.frame_row[:, i] for i in range(arrays.frame_row.shape[1])))
    a = yielding(take(body, arrays.frame_index[:, 0]), row.move_a)
    b = yielding(take(body, arrays.frame_index[:, 1]), row.move_b)
    left, right = take(body, arrays.mirror_index[:, 0]), take(body, arrays.mirror_index[:, 1])
    axis = yielding(take(body, arrays.mirror_index[:, 2]), jnp.zeros_like(arrays.mirror_weight))
    return frame_residual(a, b, row), mirror_residual(left, right, axis, arrays.mirror_normal)


def prisms(body: Body, arrays: Arrays) -> Body:
    """Return the prisms (starts, S) where their slots are."""
    return within(take(body, arrays.prism_slot), arrays.prism)


def overlap_gaps(prisms: Body, pairs: Array, cut: Array) -> Array:
    """Return how many metres each pair of prisms is apart, less than 0 where they overlap; infinite for one and itself."""
    a, b = take(prisms, pairs[..., 0]), take(prisms, pairs[..., 1])
    apart = cut_separation(a, b, cut[pairs[..., 0]], cut[pairs[..., 1]])
    return jnp.where(pairs[..., 0] == pairs[..., 1], jnp.inf, apart)


def overlap_losses(body: Body, arrays: Arrays, pairs: Array, weights: Weights) -> Array:
    """Return the loss of each pair of prisms by how deep they are in each other, or by their intersection over union."""
    shapes = prisms(body, arrays)
    if not weights.iou:
        return hard(jnp.maximum(weights.margin - overlap_gaps(shapes, pairs, arrays.prism[:, 4]), 0.0), weights)
    same = pairs[..., 0] == pairs[..., 1]
    first, second = take(shapes, pairs[..., 0]), take(shapes, pairs[..., 1])
    # A slot that is only there to fill a list has no size: its share of itself is 0 / 0, whose slope spoils all others.
    sized = first._replace(hx=jnp.where(same, 1.0, first.hx), hy=jnp.where(same, 1.0, first.hy))
    shared = intersection_over_union(sized, second)
    return weights.iou * jnp.where(same, 0.0, shared)


def strips(body: Body, arrays: Arrays) -> Body:
    """Return the clear boxes (starts, G) where their owners are."""
    return within(take(body, arrays.clear_owner), arrays.clear_box)


def clear_depths(body: Body, arrays: Arrays, clears: Array, weights: Weights) -> Array:
    """Return by how many metres slots are in clear boxes, for pairs (..., 2) of a box and a slot."""
    return penetration(take(strips(body, arrays), clears[..., 0]), take(body, clears[..., 1]), weights.margin)


def route_depths(body: Body, routes: Routes) -> Array:
    """Return by how many metres each route point lacks clearance from its slot (starts, T)."""
    distance = point_to_box(routes.point[..., 0], routes.point[..., 1], take(body, routes.slot))
    return jnp.maximum(routes.need - distance, 0.0)


def everything(arrays: Arrays) -> Near:
    """Return all pairs of prisms, and all of clear boxes and slots."""
    boxes, slots = arrays.clear_weight.shape
    grid = jnp.stack(jnp.meshgrid(jnp.arange(boxes), jnp.arange(slots), indexing="ij"), axis=-1)
    return Near(arrays.pairs, grid.reshape(-1, 2))


def losses(local: Poses, arrays: Arrays, routes: Routes, near: Near, weights: Weights) -> Losses:
    """Return every term of the objective per start, looking only at what may touch."""
    body = bodies(world_poses(local, arrays), arrays)
    framed, mirrored = statement_residuals(body, arrays)
    body = body._replace(c=stop_gradient(body.c), s=stop_gradient(body.s))  # things make way, but do not turn for it
    pull = jnp.sum(saturated(framed, weights) * arrays.frame_row[:, -1], axis=-1)
    pull += jnp.sum(saturated(mirrored, weights) * arrays.mirror_weight, axis=-1)
    clear = hard(clear_depths(body, arrays, near.clears, weights), weights)
    return Losses(
        overlap=jnp.sum(overlap_losses(body, arrays, near.pairs, weights), axis=-1),
        boundary=_boundary(body, arrays, weights),
        clear=jnp.sum(clear * arrays.clear_weight[near.clears[..., 0], near.clears[..., 1]], axis=-1),
        statements=pull,
        reachability=_reachability(body, routes, weights),
    )


def _boundary(body: Body, arrays: Arrays, weights: Weights) -> Array:
    """Return the boundary term, without work where nothing can leave the room."""

    def whole(body: Body) -> Array:
        slots = take(body, jnp.arange(arrays.half.shape[0]))
        return jnp.sum(hard(boundary_depths(slots, arrays), weights) * arrays.inside, axis=-1)

    return cond(jnp.any(arrays.inside > 0.0), whole, _nothing, body)


def _reachability(body: Body, routes: Routes, weights: Weights) -> Array:
    """Return the routes' term, without work where there are none."""

    def whole(body: Body) -> Array:
        return jnp.sum(hard(route_depths(body, routes), weights), axis=-1)

    return cond(jnp.any(routes.need > 0.0), whole, _nothing, body)


def _nothing(body: Body) -> Array:
    return jnp.zeros(body.x.shape[0])


def total(parts: Losses, weights: Weights, routes: Array | float = 1.0) -> Array:
    """Return the weighted sum per start, the term of the routes scaled by `routes`."""
    return parts.statements + hard_part(parts, weights, routes)
