"""`under`: a rug lies under things, or a thing stands under another: a bin under a desk."""

from __future__ import annotations

import math
from dataclasses import dataclass

from robolayout.assets.beneath import BENEATH
from robolayout.constraints._exact import TOLERANCE, common_area, footprint, half_size
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene

OVERLAP = 0.10  # metres by which each thing should reach over the rug


@dataclass(frozen=True)
class Under(Relation):
    """The rug `a` lies under `items`, each at least partly on it; another thing stands below them, half of it or more."""

    name = "under"
    surrogate = True  # things reach 10 cm over the rug, where the check takes 5
    example = "solver.under(rug[0], [sofa[0], coffee_table[0]])"

    a: AssetRef = argument("asset")
    items: tuple[AssetRef, ...] = argument("asset", many=True)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return two rows per thing: each reaches over the other's edge, as the rug sees it and as the thing sees it.

        Two boxes overlap if and only if they do along the axes of both. The rug moves. Of what is no rug, one row: it is wholly
        below the other, in the middle of it where it is longer.
        """
        if not scene.by_name[self.a.name].is_flat:
            return tuple(self._below(scene, near, item) for item in self.items)
        rows: list[Term] = []
        for item in self.items:
            along, across = _reach(half_size(scene, self.a))
            rows.append(FrameTerm(item, self.a, along=along, across=across, moves="b"))
            along, across = _reach(half_size(scene, item))
            rows.append(FrameTerm(self.a, item, along=along, across=across))
        return tuple(rows)

    def _below(self, scene: Scene, near: Layout, item: AssetRef) -> Term:
        turned = near[self.a.name].yaw - near[item.name].yaw
        c, s, (hx, hy) = abs(math.cos(turned)), abs(math.sin(turned)), half_size(scene, self.a)
        free = (
            max(own - half, 0.0)
            for own, half in zip(half_size(scene, item), (c * hx + s * hy, s * hx + c * hy), strict=True)
        )
        along, across = (Interval(-far, far) for far in free)
        return FrameTerm(self.a, item, along=along, across=across)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Each reaches at least 5 cm over the rug, or a quarter of its shorter side where that is less; half of another thing is below."""
        if not scene.by_name[self.a.name].is_flat:
            own = footprint(scene, layout, self.a)
            below = min(common_area(own, footprint(scene, layout, item)) for item in self.items) / own.area
            return Outcome.at_most(1.0 - BENEATH.least, 1.0 - below, "", f"{below:.0%} of it below")
        rug = footprint(scene, layout, self.a)
        inner = rug.buffer(-min(TOLERANCE.gap, min(half_size(scene, self.a)) / 2), join_style="mitre")
        short = {item.name: inner.distance(footprint(scene, layout, item)) for item in self.items}
        beside = [name for name, gap in short.items() if gap > 0.0]
        least = min(common_area(rug, footprint(scene, layout, item)) for item in self.items)
        text = (
            f"{', '.join(beside)} beside it or hardly on it"
            if beside
            else f"at least {least:.2f} m2 of each thing on it"
        )
        return Outcome.at_most(0.0, max(short.values()), "m", text)


def _reach(half: tuple[float, float]) -> tuple[Interval, Interval]:
    """Return the intervals of what reaches over the edges of a thing of that half size."""
    hx, hy = (max(side - OVERLAP, side / 2) for side in half)
    return Interval(-hx, hx, -1.0, -1.0), Interval(-hy, hy, -1.0, -1.0)
