"""What single terms of the objective are, for NumPy and for the compiled search alike."""

from __future__ import annotations

from robolayout._geometry import Array, Body, backend, corners, point_to_box, signed_distance
from robolayout.solve.arrays import Arrays, Losses
from robolayout.solve.config import Weights


def hard(depth: Array, weights: Weights) -> Array:
    """Return d^2 + hinge d for a depth of violation in metres."""
    return depth * depth + weights.hinge * depth


def hard_part(parts: Losses, weights: Weights, routes: Array | float = 1.0) -> Array:
    """Return the weighted sum of the hard terms per start, that of the routes scaled by `routes`."""
    kept = weights.overlap * parts.overlap + weights.inside * parts.boundary
    return kept + weights.clear * parts.clear + weights.routes * routes * parts.reachability


def saturated(residual: Array, weights: Weights) -> Array:
    """Return s log(1 + r / s) of a statement's residual: one that cannot be met stops pulling at the others."""
    return weights.saturation * backend(residual).log1p(residual / weights.saturation)


def boundary_depths(slots: Body, arrays: Arrays) -> Array:
    """Return by how many metres each slot leaves the room: corners outside, or inner corners inside it."""
    xp = backend(slots.x)
    px, py = corners(slots)
    outside = xp.maximum(signed_distance(px, py, arrays.edges), 0.0)
    spread = Body(*(field[..., None] for field in slots))
    pierced = xp.maximum(-point_to_box(arrays.inner[:, 0], arrays.inner[:, 1], spread), 0.0)
    return xp.sum(outside, axis=-1) + xp.sum(pierced, axis=-1)


def within(owner: Body, box: Array) -> Body:
    """Return boxes, rows (n, 4 or more) of centre and half size in the frames of their owners, where these are."""
    xp = backend(owner.x)
    cx, cy, hx, hy = (box[:, i] for i in range(4))
    x = owner.x + owner.c * cx - owner.s * cy
    return owner._replace(
        x=x,
        y=owner.y + owner.s * cx + owner.c * cy,
        hx=xp.broadcast_to(hx, x.shape),
        hy=xp.broadcast_to(hy, x.shape),
        core=xp.zeros_like(x),
    )
