"""The objective, and gradient search over a batch of starts, compiled once per size.

The objective is one sum over statements, overlaps, the room, clear boxes and routes. One compiled program serves every room of a
size: steps, rates and all of the scene are arguments. Each step is Adam on the objective along x, y and yaw, then unit-circle and
rectangle projection.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import jax
import jax.numpy as jnp
from jax.lax import cond, stop_gradient
from jaxtyping import Array, Float

from robolayout._geometry import Body, compose, cut_separation, extents, penetration, separation
from robolayout.solve.arrays import (
    HISTORY,
    SNAPSHOTS,
    Arrays,
    Losses,
    Touching,
    boundary_depths,
    hard,
    hard_part,
    route_depths,
    statement_losses,
    within,
)
from robolayout.solve.config import Weights

PAIRS_PER_SLOT, CLEARS_PER_SLOT = 3, 1
"""Nearest pairs that every step looks at."""

FADING, FADED = 0.4, 0.85
"""Share of the steps during which the routes' weight fades, and after which none is left: in narrow passages routes press
things into each other, which then have to part."""

REFRESH = 16
"""Steps between two searches for the nearest pairs."""

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
    """Return the bodies of those indices: the same (M,) for every start, or (starts, M) each start's own."""
    if index.ndim == 1:
        return Body(*(field[..., index] for field in body))
    rows = jnp.arange(index.shape[0])[:, None]
    return Body(*(field[rows, index] for field in body))


def overlap_gaps(body: Body, arrays: Arrays, pairs: Array) -> Array:
    """Return how many metres each pair of prisms is apart, less than 0 where they overlap; infinite for one and itself."""
    prisms, cut = within(take(body, arrays.prism_slot), arrays.prism), arrays.prism[:, 4]
    one, other = pairs[..., 0], pairs[..., 1]
    apart = cut_separation(take(prisms, one), take(prisms, other), cut[one], cut[other])
    return jnp.where(one == other, jnp.inf, apart)


def everything(arrays: Arrays) -> Touching:
    """Return all pairs of prisms, and all of clear boxes and slots."""
    boxes, slots = arrays.clear_weight.shape
    grid = jnp.stack(jnp.meshgrid(jnp.arange(boxes), jnp.arange(slots), indexing="ij"), axis=-1)
    return Touching(arrays.pairs, grid.reshape(-1, 2))


def losses(local: Poses, arrays: Arrays, routes: Array, near: Touching, weights: Weights) -> Losses:
    """Return every term of the objective per start, looking only at what may touch."""
    body = bodies(world_poses(local, arrays), arrays)
    pull = statement_losses(partial(take, body), arrays, weights)
    body = body._replace(c=stop_gradient(body.c), s=stop_gradient(body.s))  # things make way, but do not turn for it
    at = partial(take, body)
    strips = within(take(body, arrays.clear_owner), arrays.clear_box)
    overlap = hard(jnp.maximum(weights.margin - overlap_gaps(body, arrays, near.pairs), 0.0), weights)
    depths = penetration(take(strips, near.clears[..., 0]), at(near.clears[..., 1]), weights.margin)
    clear = hard(depths, weights)

    def boundary() -> Array:
        depths = boundary_depths(at(jnp.arange(len(arrays.half))), arrays)
        return jnp.sum(hard(depths, weights) * arrays.inside, axis=-1)

    def reachability() -> Array:
        return jnp.sum(hard(route_depths(at, routes), weights), axis=-1)

    def nothing() -> Array:
        return jnp.zeros(len(local))

    return Losses(
        overlap=jnp.sum(overlap, axis=-1),
        boundary=cond(jnp.any(arrays.inside > 0.0), boundary, nothing),
        clear=jnp.sum(clear * arrays.clear_weight[near.clears[..., 0], near.clears[..., 1]], axis=-1),
        statements=pull,
        reachability=cond(jnp.any(routes[..., 3] > 0.0), reachability, nothing),
    )


def total(parts: Losses, weights: Weights, routes: Array | float = 1.0) -> Array:
    """Return the weighted sum per start, the term of the routes scaled by `routes`."""
    return parts.statements + hard_part(parts, weights, routes)


def nearest(local: Array, arrays: Arrays) -> Touching:
    """Return for each start the pairs that are nearest to touching: of prisms, and of clear boxes and slots."""
    table = bodies(world_poses(local, arrays), arrays)
    apart = overlap_gaps(table, arrays, arrays.pairs)
    strips = within(take(table, arrays.clear_owner), arrays.clear_box)
    boxes = Body(*(field[:, :, None] for field in strips))
    slots = Body(*(field[:, None, : arrays.half.shape[0]] for field in table))
    out = jnp.where(arrays.clear_weight > 0.0, separation(boxes, slots), jnp.inf)
    whole, count = everything(arrays), arrays.half.shape[0]
    return Touching(
        _smallest(apart, whole.pairs, PAIRS_PER_SLOT * count),
        _smallest(out.reshape(len(local), -1), whole.clears, CLEARS_PER_SLOT * count),
    )


def _smallest(value: Array, index: Array, count: int) -> Array:
    """Return the rows of `index` (M, 2) with the smallest values (starts, M): (starts, at most `count`, 2)."""
    return index[jax.lax.top_k(-value, min(count, index.shape[0]))[1]]


def _tangent(local: Array, gradient: Array) -> Array:
    """Return the gradient along x, y and the yaw: of (cos, sin) only what turns the heading counts."""
    turn = local[..., 2] * gradient[..., 3] - local[..., 3] * gradient[..., 2]
    return jnp.stack([gradient[..., 0], gradient[..., 1], turn], axis=-1)


def _moved(local: Array, move: Array) -> Array:
    """Return the variables after a step against `move` (x, y, yaw); for small steps tan(yaw) stands for yaw."""
    x, y, c, s = (local[..., i] for i in range(4))
    turn = -move[..., 2]
    return jnp.stack([x - move[..., 0], y - move[..., 1], c - s * turn, s + c * turn], axis=-1)


def _project(local: Array, arrays: Arrays) -> Array:
    """Return the variables with headings on the unit circle and boxes within their rectangle."""
    x, y, c, s = (local[..., i] for i in range(4))
    norm = jnp.sqrt(c * c + s * s + 1e-12)
    c, s = c / norm, s / norm
    hx, hy = (jnp.broadcast_to(arrays.half[:, i], x.shape) for i in range(2))
    ex, ey = extents(Body(x, y, c, s, hx, hy, jnp.zeros_like(x)))
    lx, ly = jnp.maximum(arrays.limit[:, 0] - ex, 0.0), jnp.maximum(arrays.limit[:, 1] - ey, 0.0)
    moved = jnp.stack([jnp.clip(x, -lx, lx), jnp.clip(y, -ly, ly), c, s], axis=-1)
    return jnp.where(arrays.free[:, :1] > 0, moved, local)


def advance(local: Array, arrays: Arrays, routes: Array, phase: Array, *, weights: Weights) -> tuple[Any, ...]:
    """Run the search from variables (K, A, 4), by the numbers of a `SearchConfig`.

    Returns variables and poses in the room (K, A, 4), and the terms there; of the start with the lowest final objective the terms
    of each step (HISTORY, 5), unused rows 0, and its poses evenly spaced over the steps (SNAPSHOTS, A, 4).
    """
    steps, first_rate, final_rate = phase[0].astype(jnp.int32), phase[1], phase[2]

    def objective(value: Array, near: Touching, fade: Array) -> tuple[Array, Losses]:
        parts = losses(value, arrays, routes, near, weights)
        return jnp.sum(total(parts, weights, fade)), parts

    def step(i: Array, state: tuple[Any, ...]) -> tuple[Any, ...]:
        local, first, second, near, history, shots, _ = state
        done = i / jnp.maximum(steps, 1)
        rate = final_rate + (first_rate - final_rate) * 0.5 * (1.0 + jnp.cos(jnp.pi * done))
        renew = (i % REFRESH == 0) | (i == steps)
        fade = jnp.clip((FADED - done) / FADING, 0.0, 1.0)
        near = cond(renew, partial(nearest, local, arrays), partial(Touching, *near))
        gradient, parts = jax.grad(objective, has_aux=True)(local, near, fade)
        gradient = _tangent(local, gradient) * arrays.free
        first = 0.9 * first + 0.1 * gradient
        second = 0.98 * second + 0.02 * gradient * gradient
        t = i + 1.0
        move = rate * (first / (1.0 - 0.9**t)) / (jnp.sqrt(second / (1.0 - 0.98**t)) + 1e-4)
        history = history.at[jnp.minimum(i, HISTORY - 1)].set(jnp.stack(parts, axis=-1))
        shots = shots.at[jnp.minimum(i * SNAPSHOTS // jnp.maximum(steps, 1), SNAPSHOTS - 1)].set(local)
        local = _project(_moved(local, move * arrays.free * (i < steps)), arrays)
        return local, first, second, near, history, shots, parts

    zero = jnp.zeros((*local.shape[:2], 3))
    begin = (
        _project(local, arrays),
        zero,
        zero,
        jax.tree.map(jnp.zeros_like, jax.eval_shape(nearest, local, arrays)),
        jnp.zeros((HISTORY, local.shape[0], 5)),
        jnp.zeros((SNAPSHOTS, *local.shape)),
        Losses(*jnp.zeros((5, local.shape[0]))),
    )
    # One more turn than there are steps: it moves nothing and leaves the losses of the result.
    local, _, _, _, history, shots, parts = jax.lax.fori_loop(0, steps + 1, step, begin)
    best = jnp.argmin(total(parts, weights))
    shots = world_poses(shots[:, best], arrays)
    return local, world_poses(local, arrays), parts, history[:, best], shots
