"""Signed distance to a simple polygon."""

from __future__ import annotations

import jax.numpy as jnp
from jaxtyping import Array, Float

from robolayout._geometry.boxes import TINY


def signed_distance(
    px: Float[Array, "*batch"], py: Float[Array, "*batch"], edges: Float[Array, "edges 4"]
) -> Float[Array, "*batch"]:
    """Return the signed distance of points to a polygon in metres: negative inside.

    Args:
        edges: (x1, y1, x2, y2) of each edge, a closed ring; repeated edges of zero length do no harm.
    """
    x1, y1, x2, y2 = (edges[:, i] for i in range(4))
    ex, ey = x2 - x1, y2 - y1
    wx, wy = px[..., None] - x1, py[..., None] - y1
    t = jnp.clip((wx * ex + wy * ey) / (ex * ex + ey * ey + TINY), 0.0, 1.0)
    squared = jnp.min((wx - t * ex) ** 2 + (wy - t * ey) ** 2, axis=-1)
    above1, above2 = py[..., None] >= y1, py[..., None] >= y2
    crosses = (above1 != above2) & ((ex * wy - ey * wx > 0) == (y2 > y1))
    inside = jnp.sum(crosses, axis=-1) % 2 == 1
    return jnp.where(inside, -1.0, 1.0) * jnp.sqrt(squared + TINY)
