"""Implicit `no_overlap`: no two things are in the same place."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import ClassVar

from robolayout.constraints._exact import common_area, footprint
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation
from robolayout.constraints._terms import OverlapTerm, Term
from robolayout.scene import Asset, Layout, Scene, vertical_span

OVERLAP_AREA = 1e-4
"""Square metres of common footprint from which on two things collide (DESIGN section 4)."""

OVERLAP_HEIGHT = 0.01
"""Metres of common height from which on two things collide (DESIGN section 4)."""


def share_height(a: Asset, b: Asset, layout: Layout) -> bool:
    """Return whether two things are at the same height somewhere; rugs never count."""
    if a.is_flat or b.is_flat:
        return False
    (low_a, high_a), (low_b, high_b) = vertical_span(a, layout[a.name]), vertical_span(b, layout[b.name])
    return min(high_a, high_b) - max(low_a, low_b) > OVERLAP_HEIGHT


@dataclass(frozen=True)
class NoOverlap(Relation):
    """No two things at the same height overlap in plan; flat rugs may lie under furniture."""

    name: ClassVar[str] = "no_overlap"
    hard: ClassVar[bool] = True
    implicit: ClassVar[bool] = True
    example: ClassVar[str] = ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row per pair of things that share a height."""
        return tuple(
            OverlapTerm(AssetRef(a.name), AssetRef(b.name))
            for a, b in combinations(scene.assets, 2)
            if share_height(a, b, near)
        )

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """At most 1e-4 m2 of common footprint for every pair that shares more than 1 cm of height."""
        worst, text = 0.0, "nothing overlaps"
        placed = [asset for asset in scene.assets if asset.name in layout]
        shapes = {asset.name: footprint(scene, layout, AssetRef(asset.name)) for asset in placed}
        for a, b in combinations(placed, 2):
            if share_height(a, b, layout):
                area = common_area(shapes[a.name], shapes[b.name])
                if area > max(worst, OVERLAP_AREA):
                    worst, text = area, f"{a.name} and {b.name} overlap by {area:.4f} m2"
        return Outcome(worst <= OVERLAP_AREA, worst, OVERLAP_AREA, "m2", text)
