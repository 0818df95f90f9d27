"""Oriented boxes in plan.

A box is a centre, a unit heading (cos, sin of its yaw) and two half sizes. All functions take arrays of any batch shape and
broadcast; none has a branch, so gradients exist everywhere (one-sided at kinks).
"""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from jaxtyping import Float

Array = Any  # A NumPy or JAX array

SLANT = 0.5**0.5  # cosine of 45 degrees
TINY = 1.0e-12  # added under square roots so that gradients stay finite at 0


def backend(*values: Any) -> Any:
    """Return the module whose functions take some arrays: `numpy` for its own, else `jax.numpy`, loaded when it is needed."""
    if all(isinstance(value, np.ndarray | np.generic) for value in values):
        return np
    import jax.numpy as jnp

    return jnp


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


def compose(outer: Float[Array, "*batch 4"], inner: Float[Array, "*batch 4"]) -> Float[Array, "*batch 4"]:
    """Return the pose (x, y, cos, sin) of `inner`, given in the frame of `outer`, in the frame that `outer` is given in."""
    xp = backend(outer)
    ox, oy, oc, os = (outer[..., i] for i in range(4))
    x, y, c, s = (inner[..., i] for i in range(4))
    return xp.stack([ox + oc * x - os * y, oy + os * x + oc * y, oc * c - os * s, os * c + oc * s], axis=-1)


def extents(box: Body) -> tuple[Float[Array, "*batch"], Float[Array, "*batch"]]:
    """Return the half sizes along x and y of the smallest upright box around each box."""
    xp = backend(box.c)
    c, s = xp.abs(box.c), xp.abs(box.s)
    return c * box.hx + s * box.hy, s * box.hx + c * box.hy


def corners(box: Body) -> tuple[Float[Array, "*batch 4"], Float[Array, "*batch 4"]]:
    """Return x and y of the four corners, counter-clockwise."""
    xp = backend(box.x)
    px = xp.stack([box.hx, box.hx, -box.hx, -box.hx], axis=-1)
    py = xp.stack([-box.hy, box.hy, box.hy, -box.hy], axis=-1)
    c, s = box.c[..., None], box.s[..., None]
    return box.x[..., None] + c * px - s * py, box.y[..., None] + s * px + c * py


def separation(a: Body, b: Body) -> Float[Array, "*batch"]:
    """Return the separating-axis distance of two boxes in metres.

    Positive: a gap (exact where it is between parallel faces, a lower bound between corners). Negative: the smallest shift
    along a face normal that parts them.
    """
    xp = backend(a.x, b.x)
    dx, dy = b.x - a.x, b.y - a.y
    rc = xp.abs(a.c * b.c + a.s * b.s)
    rs = xp.abs(a.s * b.c - a.c * b.s)
    along_a = xp.abs(a.c * dx + a.s * dy) - (a.hx + rc * b.hx + rs * b.hy)
    across_a = xp.abs(a.c * dy - a.s * dx) - (a.hy + rs * b.hx + rc * b.hy)
    along_b = xp.abs(b.c * dx + b.s * dy) - (b.hx + rc * a.hx + rs * a.hy)
    across_b = xp.abs(b.c * dy - b.s * dx) - (b.hy + rs * a.hx + rc * a.hy)
    return xp.maximum(xp.maximum(along_a, across_a), xp.maximum(along_b, across_b))


def cut_separation(
    a: Body, b: Body, cut_a: Float[Array, "*batch"], cut_b: Float[Array, "*batch"]
) -> Float[Array, "*batch"]:
    """Return the separating-axis distance of two boxes whose corners are cut off at 45 degrees, in metres.

    A box reaches hx |n.x| + hy |n.y| along a unit normal n in its frame, less cut min(|n.x|, |n.y|), where its cut is how much
    of either side a corner takes; the normals are those of its sides and of its cut corners.
    """
    xp = backend(a.x, b.x)
    dx, dy = b.x - a.x, b.y - a.y
    cos, sin = a.c * b.c + a.s * b.s, a.c * b.s - a.s * b.c
    rc, rs = xp.abs(cos), xp.abs(sin)
    p, q = xp.abs(cos + sin) * SLANT, xp.abs(cos - sin) * SLANT
    least, less = xp.minimum(rc, rs), xp.minimum(p, q)
    gaps: list[Array] = []
    for one, other, cut, cut_other, (along, over) in ((a, b, cut_a, cut_b, (p, q)), (b, a, cut_b, cut_a, (q, p))):
        u, v = one.c * dx + one.s * dy, one.c * dy - one.s * dx
        gaps += [
            xp.abs(u) - (one.hx + rc * other.hx + rs * other.hy - cut_other * least),
            xp.abs(v) - (one.hy + rs * other.hx + rc * other.hy - cut_other * least),
        ]
        own = (one.hx + one.hy - cut) * SLANT - cut_other * less
        gaps += [
            xp.abs(u + v) * SLANT - (own + along * other.hx + over * other.hy),
            xp.abs(u - v) * SLANT - (own + over * other.hx + along * other.hy),
        ]
    return functools.reduce(xp.maximum, gaps)


def penetration(a: Body, b: Body, margin: float) -> Float[Array, "*batch"]:
    """Return by how many metres two boxes, kept `margin` apart, go into each other; 0 if they do not."""
    xp = backend(a.x, b.x)
    return xp.maximum(margin - separation(a, b), 0.0)


def point_to_box(px: Float[Array, "*batch"], py: Float[Array, "*batch"], box: Body) -> Float[Array, "*batch"]:
    """Return the signed distance of points to boxes in metres; negative inside."""
    xp = backend(px, box.x)
    dx, dy = px - box.x, py - box.y
    u = xp.abs(box.c * dx + box.s * dy) - box.hx
    v = xp.abs(box.c * dy - box.s * dx) - box.hy
    outside = xp.sqrt(xp.maximum(u, 0.0) ** 2 + xp.maximum(v, 0.0) ** 2 + TINY)
    return outside + xp.minimum(xp.maximum(u, v), 0.0)


def signed_distance(
    px: Float[Array, "*batch"], py: Float[Array, "*batch"], edges: Float[Array, "edges 4"]
) -> Float[Array, "*batch"]:
    """Return the signed distance of points to a polygon in metres, negative inside; `edges` (x1, y1, x2, y2) may have no length."""
    xp = backend(px)
    x1, y1, x2, y2 = (edges[:, i] for i in range(4))
    ex, ey = x2 - x1, y2 - y1
    wx, wy = px[..., None] - x1, py[..., None] - y1
    t = xp.clip((wx * ex + wy * ey) / (ex * ex + ey * ey + TINY), 0.0, 1.0)
    squared = xp.min((wx - t * ex) ** 2 + (wy - t * ey) ** 2, axis=-1)
    above1, above2 = py[..., None] >= y1, py[..., None] >= y2
    crosses = (above1 != above2) & ((ex * wy - ey * wx > 0) == (y2 > y1))
    inside = xp.sum(crosses, axis=-1) % 2 == 1
    return xp.where(inside, -1.0, 1.0) * xp.sqrt(squared + TINY)
