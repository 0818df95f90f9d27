"""Which prisms of two things would collide: those that share a height."""

from __future__ import annotations

import math
from functools import lru_cache

from shapely import Polygon

from robolayout.assets import Prism, prisms_of
from robolayout.constraints._exact import TOLERANCE
from robolayout.scene import Asset, Layout, Pose, vertical_span


def share_height(a: Asset, b: Asset, layout: Layout) -> bool:
    """Return whether the boxes of two things are at the same height somewhere; rugs never count."""
    if a.is_flat or b.is_flat:
        return False
    (low_a, high_a), (low_b, high_b) = vertical_span(a, layout[a.name]), vertical_span(b, layout[b.name])
    return min(high_a, high_b) - max(low_a, low_b) > TOLERANCE.height


def meeting_prisms(a: Asset, b: Asset, layout: Layout) -> tuple[tuple[Prism, Prism], ...]:
    """Return the prisms of two things that would collide over one another: pairs of one height, but none that others imply."""
    if not share_height(a, b, layout):
        return ()
    apart = vertical_span(b, layout[b.name])[0] - vertical_span(a, layout[a.name])[0]
    return _meeting(a, b, round(apart, 4))


@lru_cache(maxsize=1 << 14)
def _meeting(a: Asset, b: Asset, apart: float) -> tuple[tuple[Prism, Prism], ...]:
    """Return the pairs of prisms of one height where b stands `apart` metres higher than a."""
    pairs = [
        (p, q)
        for p in prisms_of(a)
        for q in prisms_of(b)
        if min(p.high, q.high + apart) - max(p.low, q.low + apart) > TOLERANCE.height
    ]
    kept: list[tuple[Prism, Prism]] = []
    for pair in sorted(pairs, key=lambda pair: -pair[0].hx * pair[0].hy * pair[1].hx * pair[1].hy):
        if not any(pair[0].within(p) and pair[1].within(q) for p, q in kept):
            kept.append(pair)
    return tuple(kept)


def prisms_meet(one: tuple[Asset, Pose], other: tuple[Asset, Pose], margin: float = 0.0) -> bool:
    """Return whether prisms of two things are less than `margin` metres apart in plan at one height."""
    (a, here), (b, there) = one, other
    reach = (math.hypot(*a.size[:2]) + math.hypot(*b.size[:2])) / 2  # of their boxes, however they are turned
    if math.dist((here.x, here.y), (there.x, there.y)) >= reach + margin:
        return False
    apart = vertical_span(b, there)[0] - vertical_span(a, here)[0]
    return any(_placed(p, here).distance(_placed(q, there)) < margin for p, q in _meeting(a, b, round(apart, 4)))


def _placed(prism: Prism, pose: Pose) -> Polygon:
    """Return the outline of a prism in the room."""
    (c, s), x, y = pose.forward, pose.x, pose.y
    return Polygon([(x + c * u - s * v, y + s * u + c * v) for u, v in prism.outline])
