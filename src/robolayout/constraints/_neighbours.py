"""What stands in a fixed place beside its neighbour: the common form of `row` and `grid`."""

from __future__ import annotations

from robolayout.constraints._exact import TOLERANCE, angle_between, frame
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome
from robolayout.scene import Layout, Scene

Link = tuple[AssetRef, AssetRef, float, float]
"""A thing, its neighbour, and where the thing's centre belongs in the neighbour's frame (metres)."""


def link_terms(links: list[Link]) -> tuple[FrameTerm, ...]:
    """Return one row per link: place and heading in the neighbour's frame."""
    return tuple(
        FrameTerm(a, b, along=Interval(x, x), across=Interval(y, y), heading=0.0, moves="both") for a, b, x, y in links
    )


def links_outcome(links: list[Link], scene: Scene, layout: Layout) -> Outcome:
    """Measure the worst place and heading of all links: within 5 cm along each axis and 10 degrees."""
    off, turned = 0.0, 0.0
    for a, b, x, y in links:
        seen = frame(scene, layout, b)
        u, v = seen.point(layout[a.name].x, layout[a.name].y)
        off = max(off, abs(u - x), abs(v - y))
        turned = max(turned, angle_between(layout[a.name].yaw, seen.yaw))
    met = off <= TOLERANCE.gap and turned <= TOLERANCE.angle
    return Outcome(met, off, TOLERANCE.gap, "m", f"up to {off:.2f} m off its place, {turned:.0f} deg off its heading")
