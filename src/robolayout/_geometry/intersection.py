r"""Area that two oriented boxes share, exactly and with its gradient.

The outline of the intersection of two convex shapes consists of the pieces of each outline that lie inside the other shape, all
run through counter-clockwise, so Green's theorem gives the area without sorting any corner:

    area = 1/2 sum over pieces (x1 y2 - x2 y1)

Each edge is clipped to the other box by the two pairs of sides of that box, in that box's own frame, where they are upright.
An edge on the other's outline is no piece where the boxes touch from outside, and counts once where they lie on the same side
of it: as an edge of the first box, never as one of the second.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from robolayout._geometry.boxes import Array, Body, backend, corners

if TYPE_CHECKING:
    from jaxtyping import Float

TOUCH = 1.0e-9  # metres within which an edge lies on an outline
LEVEL = 1.0e-6  # metres of rise within which an edge runs alongside a side


def intersection_over_union(a: Body, b: Body) -> Float[Array, "*batch"]:
    """Return the shared area over the area that the two cover together: 0 apart, 1 for the same box."""
    xp = backend(a.x, b.x)
    # The pieces are measured from a's centre, so that far from the origin no digits are lost.
    ax, ay = (value - centre[..., None] for value, centre in zip(corners(a), (a.x, a.y), strict=True))
    bx, by = (value - centre[..., None] for value, centre in zip(corners(b), (a.x, a.y), strict=True))
    of_a = _pieces(ax, ay, b._replace(x=b.x - a.x, y=b.y - a.y), first=True)
    of_b = _pieces(bx, by, a._replace(x=xp.zeros_like(a.x), y=xp.zeros_like(a.y)), first=False)
    shared = xp.maximum(0.5 * (of_a + of_b), 0.0)
    return shared / (4.0 * (a.hx * a.hy + b.hx * b.hy) - shared)


def _pieces(px: Array, py: Array, box: Body, *, first: bool) -> Array:
    """Return the sum of x1 y2 - x2 y1 over the parts of a ring's edges that lie in a box."""
    xp = backend(px)
    dx, dy = px - box.x[..., None], py - box.y[..., None]
    c, s = box.c[..., None], box.s[..., None]
    u, v = c * dx + s * dy, c * dy - s * dx
    run_u, run_v = (xp.roll(place, -1, axis=-1) - place for place in (u, v))
    begin, end = xp.zeros_like(u), xp.ones_like(u)
    # The box's own outline runs up its side u = +hx and backwards along its side v = +hy.
    for place, run, along, half in ((u, run_u, run_v, box.hx), (v, run_v, -run_u, box.hy)):
        half = half[..., None]
        level = xp.abs(run) < LEVEL
        within = xp.abs(place) < half - TOUCH
        if first:
            within |= (xp.abs(place) <= half + TOUCH) & (place * along > 0)
        steps = xp.where(level, 1.0, run)
        near, far = (-half - place) / steps, (half - place) / steps
        begin = xp.maximum(begin, xp.where(level, xp.where(within, 0.0, 2.0), xp.minimum(near, far)))
        end = xp.minimum(end, xp.where(level, 1.0, xp.maximum(near, far)))
    nx, ny = xp.roll(px, -1, axis=-1), xp.roll(py, -1, axis=-1)
    # (p + t1 e) x (p + t2 e) = (t2 - t1) p x e for an edge e = n - p, and p x e = p x n
    return xp.sum(xp.maximum(end - begin, 0.0) * (px * ny - nx * py), axis=-1)
