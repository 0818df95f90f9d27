"""Signed distance to a simple polygon."""

from __future__ import annotations

from typing import TYPE_CHECKING

from robolayout._geometry._backend import Array, backend
from robolayout._geometry.boxes import TINY

if TYPE_CHECKING:
    from jaxtyping import Float


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
