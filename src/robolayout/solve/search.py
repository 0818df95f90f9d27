"""Gradient search over a batch of starts, compiled once per size.

One compiled program serves every room of a size: steps, rates and all of the scene are arguments. Each step is Adam on
the objective along x, y and yaw, then unit-circle and rectangle projection.
"""

from __future__ import annotations

from typing import NamedTuple

import jax
import jax.numpy as jnp
from jaxtyping import Array, Float

from robolayout._geometry import Body, extents, separation
from robolayout.solve.arrays import HISTORY, SNAPSHOTS, Arrays, Found, Losses, Near, Routes, Schedule
from robolayout.solve.config import Weights
from robolayout.solve.objective import bodies, everything, losses, overlap_gaps, prisms, strips, total, world_poses

PAIRS_PER_SLOT, CLEARS_PER_SLOT = 3, 1
"""Nearest pairs that every step looks at."""

FADING, FADED = 0.4, 0.85
"""Share of the steps during which the routes' weight fades, and after which none is left: in narrow passages routes press
things into each other, which then have to part."""

REFRESH = 16
"""Steps between two searches for the nearest pairs."""


class _State(NamedTuple):
    local: Float[Array, "starts slots 4"]
    first: Float[Array, "starts slots 3"]
    second: Float[Array, "starts slots 3"]
    near: Near
    history: Array
    shots: Array
    parts: Losses


def nearest(local: Array, arrays: Arrays) -> Near:
    """Return for each start the pairs that are nearest to touching: of prisms, and of clear boxes and slots."""
    table = bodies(world_poses(local, arrays), arrays)
    apart = overlap_gaps(prisms(table, arrays), arrays.pairs, arrays.prism[:, 4])
    boxes = Body(*(field[:, :, None] for field in strips(table, arrays)))
    slots = Body(*(field[:, None, : arrays.half.shape[0]] for field in table))
    out = jnp.where(arrays.clear_weight > 0.0, separation(boxes, slots), jnp.inf)
    whole, count = everything(arrays), arrays.half.shape[0]
    return Near(
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


def advance(local: Array, arrays: Arrays, routes: Routes, schedule: Schedule, *, weights: Weights) -> Found:
    """Run the search from variables (K, A, 4)."""
    steps = schedule.steps

    def objective(value: Array, near: Near, fade: Array) -> tuple[Array, Losses]:
        parts = losses(value, arrays, routes, near, weights)
        return jnp.sum(total(parts, weights, fade)), parts

    def step(i: Array, state: _State) -> _State:
        done = i / jnp.maximum(steps, 1)
        rate = schedule.final_rate + (schedule.rate - schedule.final_rate) * 0.5 * (1.0 + jnp.cos(jnp.pi * done))
        renew = (i % REFRESH == 0) | (i == steps)
        fade = jnp.clip((FADED - done) / FADING, 0.0, 1.0)
        near = jax.lax.cond(renew, lambda: nearest(state.local, arrays), lambda: state.near)
        gradient, parts = jax.grad(objective, has_aux=True)(state.local, near, fade)
        gradient = _tangent(state.local, gradient) * arrays.free
        first = 0.9 * state.first + 0.1 * gradient
        second = 0.98 * state.second + 0.02 * gradient * gradient
        t = i + 1.0
        move = rate * (first / (1.0 - 0.9**t)) / (jnp.sqrt(second / (1.0 - 0.98**t)) + 1e-4)
        local = _project(_moved(state.local, move * arrays.free * (i < steps)), arrays)
        history = state.history.at[jnp.minimum(i, HISTORY - 1)].set(jnp.stack(parts, axis=-1))
        shots = state.shots.at[jnp.minimum(i * SNAPSHOTS // jnp.maximum(steps, 1), SNAPSHOTS - 1)].set(state.local)
        return _State(local, first, second, near, history, shots, parts)

    zero = jnp.zeros((*local.shape[:2], 3))
    begin = _State(
        _project(local, arrays),
        zero,
        zero,
        Near(*(jnp.zeros(list_.shape, list_.dtype) for list_ in jax.eval_shape(nearest, local, arrays))),
        jnp.zeros((HISTORY, local.shape[0], 5)),
        jnp.zeros((SNAPSHOTS, *local.shape)),
        Losses(*(jnp.zeros(local.shape[0]) for _ in Losses._fields)),
    )
    # One more turn than there are steps: it moves nothing and leaves the losses of the result.
    end = jax.lax.fori_loop(0, steps + 1, step, begin)
    best = jnp.argmin(total(end.parts, weights))
    shots = world_poses(end.shots[:, best], arrays)
    return Found(end.local, world_poses(end.local, arrays), end.parts, end.history[:, best], shots)
