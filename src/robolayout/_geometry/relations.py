r"""Residuals of one thing in the frame of another.

With (u, v) the centre of a in the frame of b, e_u and e_v the half extents of a along b's axes, d the distance of a's centre to
b's core, psi the heading of a in b's frame and phi the angle from a's turned front to the direction of b's centre:

    r = h(low_u - (u - k e_u)) + h((u + k e_u) - high_u) + the same for v
      + h(low_d - d) + h(d - high_d) + [heading] (1 - cos(psi - psi0)) + [look] (1 - cos phi, or 0 if the ray hits b)

where h is a hinge, rounded at 0 over 2 cm so that the gradient fades as the statement becomes true.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from robolayout._geometry.boxes import TINY, Array, Body, backend

if TYPE_CHECKING:
    from jaxtyping import Bool, Float

ROUNDING = 0.02  # metres over which hinges are rounded


class FrameRow(NamedTuple):
    """The numbers of a batch of frame residuals; see the module's equation."""

    low_u: Float[Array, "*batch"]
    high_u: Float[Array, "*batch"]
    low_u_extent: Float[Array, "*batch"]
    high_u_extent: Float[Array, "*batch"]
    low_v: Float[Array, "*batch"]
    high_v: Float[Array, "*batch"]
    low_v_extent: Float[Array, "*batch"]
    high_v_extent: Float[Array, "*batch"]
    low_d: Float[Array, "*batch"]
    high_d: Float[Array, "*batch"]
    heading: Float[Array, "*batch"]
    heading_c: Float[Array, "*batch"]
    heading_s: Float[Array, "*batch"]
    look: Float[Array, "*batch"]
    look_c: Float[Array, "*batch"]
    look_s: Float[Array, "*batch"]
    fold: Float[Array, "*batch"]
    move_a: Float[Array, "*batch"]
    move_b: Float[Array, "*batch"]
    weight: Float[Array, "*batch"]


def soft_abs(x: Float[Array, "*batch"]) -> Float[Array, "*batch"]:
    """Return |x| rounded at 0: sqrt(x^2 + eps^2) - eps with eps = 2 cm."""
    xp = backend(x)
    return xp.sqrt(x * x + ROUNDING**2) - ROUNDING


def _hinge(x: Float[Array, "*batch"]) -> Float[Array, "*batch"]:
    xp = backend(x)
    return soft_abs(xp.maximum(x, 0.0))


def _ray_hits(
    u: Float[Array, "*batch"], v: Float[Array, "*batch"], c: Float[Array, "*batch"], s: Float[Array, "*batch"], b: Body
) -> Bool[Array, "*batch"]:
    """Return whether the ray from (u, v) along (c, s), in b's frame, hits b's box."""
    xp = backend(u)
    inverse_c = 1.0 / xp.where(xp.abs(c) < 1e-9, 1e-9, c)
    inverse_s = 1.0 / xp.where(xp.abs(s) < 1e-9, 1e-9, s)
    t1, t2 = (-b.hx - u) * inverse_c, (b.hx - u) * inverse_c
    t3, t4 = (-b.hy - v) * inverse_s, (b.hy - v) * inverse_s
    enter = xp.maximum(xp.minimum(t1, t2), xp.minimum(t3, t4))
    leave = xp.minimum(xp.maximum(t1, t2), xp.maximum(t3, t4))
    return (leave >= enter) & (leave >= 0.0)


def frame_residual(a: Body, b: Body, row: FrameRow) -> Float[Array, "*batch"]:
    """Return how far `a` is from where `row` wants it in the frame of `b`; 0 when satisfied (metres plus 1 - cos)."""
    xp = backend(a.x, b.x)
    dx, dy = a.x - b.x, a.y - b.y
    u = b.c * dx + b.s * dy
    v = b.c * dy - b.s * dx
    rc = a.c * b.c + a.s * b.s
    rs = a.s * b.c - a.c * b.s
    eu = xp.abs(rc) * a.hx + xp.abs(rs) * a.hy
    ev = xp.abs(rs) * a.hx + xp.abs(rc) * a.hy
    side = xp.where(row.fold > 0, xp.abs(v), v)
    distance = xp.sqrt(xp.maximum(xp.abs(u) - b.core, 0.0) ** 2 + v * v + TINY)
    place = (
        _hinge(row.low_u - (u - row.low_u_extent * eu))
        + _hinge(u + row.high_u_extent * eu - row.high_u)
        + _hinge(row.low_v - (side - row.low_v_extent * ev))
        + _hinge(side + row.high_v_extent * ev - row.high_v)
        + _hinge(row.low_d - distance)
        + _hinge(distance - row.high_d)
    )
    heading = 1.0 - (rc * row.heading_c + rs * row.heading_s)
    fc = rc * row.look_c - rs * row.look_s
    fs = rs * row.look_c + rc * row.look_s
    away = xp.sqrt(u * u + v * v + TINY)
    look = xp.where(_ray_hits(u, v, fc, fs, b), 0.0, 1.0 + (fc * u + fs * v) / away)
    return place + row.heading * heading + row.look * look


def mirror_residual(a: Body, b: Body, axis: Body, along_normal: Float[Array, "*batch"]) -> Float[Array, "*batch"]:
    """Return how far `b` is from the mirror image of `a`: metres plus half of 1 - cos between the headings.

    The mirror runs through `axis` along its front; where `along_normal` is 1, along its normal (walls).
    """
    xp = backend(a.x, b.x)
    ac = xp.where(along_normal > 0, -axis.s, axis.c)
    as_ = xp.where(along_normal > 0, axis.c, axis.s)
    image_x, image_y = _mirrored(a.x - axis.x, a.y - axis.y, ac, as_)
    image_c, image_s = _mirrored(a.c, a.s, ac, as_)
    error = xp.sqrt((image_x - (b.x - axis.x)) ** 2 + (image_y - (b.y - axis.y)) ** 2 + TINY)
    return soft_abs(error) + 0.5 * (1.0 - (image_c * b.c + image_s * b.s))


def _mirrored(
    x: Float[Array, "*batch"], y: Float[Array, "*batch"], c: Float[Array, "*batch"], s: Float[Array, "*batch"]
) -> tuple[Float[Array, "*batch"], Float[Array, "*batch"]]:
    """Return the mirror image of a vector about the unit direction (c, s)."""
    along, across = c * x + s * y, c * y - s * x
    return c * along + s * across, s * along - c * across
