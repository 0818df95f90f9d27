"""Oriented boxes in plan.

A box is a centre, a unit heading (cos, sin of its yaw) and two half sizes. All functions take arrays of any batch shape and
broadcast; none has a branch, so gradients exist everywhere (one-sided at kinks).
"""

from __future__ import annotations

import functools
from typing import NamedTuple

import jax.numpy as jnp
from jax.lax import stop_gradient
from jaxtyping import Array, Float

SLANT = 0.5**0.5
"""Cosine of 45 degrees."""

TINY = 1.0e-12
"""Added under square roots so that gradients stay finite at 0."""


class Body(NamedTuple):
    """A batch of oriented boxes; all fields share one batch shape."""

    x: Float[Array, "*batch"]  # centre, metres
    y: Float[Array, "*batch"]  # centre, metres
    c: Float[Array, "*batch"]  # cosine of the yaw
    s: Float[Array, "*batch"]  # sine of the yaw
    hx: Float[Array, "*batch"]  # half size along the heading, metres
    hy: Float[Array, "*batch"]  # half size across the heading, metres
    # half length along the heading of the segment that distances are measured to, metres (0: the centre)
    core: Float[Array, "*batch"]


def yielding(box: Body, move: Float[Array, "*#batch"]) -> Body:
    """Return the same boxes, with the gradient along their pose scaled by `move`: 0 holds them, 1 changes nothing."""

    def scaled(value: Array) -> Array:
        still = stop_gradient(value)
        return still + move * (value - still)

    return box._replace(x=scaled(box.x), y=scaled(box.y), c=scaled(box.c), s=scaled(box.s))


def compose(outer: Float[Array, "*batch 4"], inner: Float[Array, "*batch 4"]) -> Float[Array, "*batch 4"]:
    """Return the pose (x, y, cos, sin) of `inner`, given in the frame of `outer`, in the frame that `outer` is given in."""
    ox, oy, oc, os = (outer[..., i] for i in range(4))
    x, y, c, s = (inner[..., i] for i in range(4))
    return jnp.stack([ox + oc * x - os * y, oy + os * x + oc * y, oc * c - os * s, os * c + oc * s], axis=-1)


def extents(box: Body) -> tuple[Float[Array, "*batch"], Float[Array, "*batch"]]:
    """Return the half sizes along x and y of the smallest upright box around each box."""
    c, s = jnp.abs(box.c), jnp.abs(box.s)
    return c * box.hx + s * box.hy, s * box.hx + c * box.hy


def corners(box: Body) -> tuple[Float[Array, "*batch 4"], Float[Array, "*batch 4"]]:
    """Return x and y of the four corners, counter-clockwise."""
    px = jnp.stack([box.hx, box.hx, -box.hx, -box.hx], axis=-1)
    py = jnp.stack([-box.hy, box.hy, box.hy, -box.hy], axis=-1)
    c, s = box.c[..., None], box.s[..., None]
    return box.x[..., None] + c * px - s * py, box.y[..., None] + s * px + c * py


def separation(a: Body, b: Body) -> Float[Array, "*batch"]:
    """Return the separating-axis distance of two boxes in metres.

    Positive: a gap (exact where it is between parallel faces, a lower bound between corners). Negative: the smallest shift
    along a face normal that parts them.
    """
    dx, dy = b.x - a.x, b.y - a.y
    rc = jnp.abs(a.c * b.c + a.s * b.s)
    rs = jnp.abs(a.s * b.c - a.c * b.s)
    along_a = jnp.abs(a.c * dx + a.s * dy) - (a.hx + rc * b.hx + rs * b.hy)
    across_a = jnp.abs(a.c * dy - a.s * dx) - (a.hy + rs * b.hx + rc * b.hy)
    along_b = jnp.abs(b.c * dx + b.s * dy) - (b.hx + rc * a.hx + rs * a.hy)
    across_b = jnp.abs(b.c * dy - b.s * dx) - (b.hy + rs * a.hx + rc * a.hy)
    return jnp.maximum(jnp.maximum(along_a, across_a), jnp.maximum(along_b, across_b))


def cut_separation(
    a: Body, b: Body, cut_a: Float[Array, "*batch"], cut_b: Float[Array, "*batch"]
) -> Float[Array, "*batch"]:
    """Return the separating-axis distance of two boxes whose corners are cut off at 45 degrees, in metres.

    A box reaches hx |n.x| + hy |n.y| along a unit normal n in its frame, less cut min(|n.x|, |n.y|); the normals are those of
    its sides and of its cut corners.

    Args:
        cut_a: How much of either side each cut corner of `a` takes, metres.
        cut_b: The same of `b`.
    """
    dx, dy = b.x - a.x, b.y - a.y
    cos, sin = a.c * b.c + a.s * b.s, a.c * b.s - a.s * b.c
    rc, rs = jnp.abs(cos), jnp.abs(sin)
    p, q = jnp.abs(cos + sin) * SLANT, jnp.abs(cos - sin) * SLANT
    least, less = jnp.minimum(rc, rs), jnp.minimum(p, q)
    gaps: list[Array] = []
    for one, other, cut, cut_other, (along, over) in ((a, b, cut_a, cut_b, (p, q)), (b, a, cut_b, cut_a, (q, p))):
        u, v = one.c * dx + one.s * dy, one.c * dy - one.s * dx
        gaps += [
            jnp.abs(u) - (one.hx + rc * other.hx + rs * other.hy - cut_other * least),
            jnp.abs(v) - (one.hy + rs * other.hx + rc * other.hy - cut_other * least),
        ]
        own = (one.hx + one.hy - cut) * SLANT - cut_other * less
        gaps += [
            jnp.abs(u + v) * SLANT - (own + along * other.hx + over * other.hy),
            jnp.abs(u - v) * SLANT - (own + over * other.hx + along * other.hy),
        ]
    return functools.reduce(jnp.maximum, gaps)


def penetration(a: Body, b: Body, margin: float) -> Float[Array, "*batch"]:
    """Return by how many metres two boxes, kept `margin` apart, go into each other; 0 if they do not."""
    return jnp.maximum(margin - separation(a, b), 0.0)


def point_to_box(px: Float[Array, "*batch"], py: Float[Array, "*batch"], box: Body) -> Float[Array, "*batch"]:
    """Return the signed distance of points to boxes in metres; negative inside."""
    dx, dy = px - box.x, py - box.y
    u = jnp.abs(box.c * dx + box.s * dy) - box.hx
    v = jnp.abs(box.c * dy - box.s * dx) - box.hy
    outside = jnp.sqrt(jnp.maximum(u, 0.0) ** 2 + jnp.maximum(v, 0.0) ** 2 + TINY)
    return outside + jnp.minimum(jnp.maximum(u, v), 0.0)
