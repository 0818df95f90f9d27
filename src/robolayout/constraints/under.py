"""`under`: a rug lies under things."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._exact import common_area, footprint, half_size
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene

OVERLAP = 0.10  # metres by which each thing should reach over the rug


@dataclass(frozen=True)
class Under(Relation):
    """The rug `a` lies under `items`: each of them stands at least partly on it."""

    name = "under"
    surrogate = True  # things reach 10 cm over the rug, where the check takes any overlap
    example = "solver.under(rug[0], [sofa[0], coffee_table[0]])"

    a: AssetRef = argument("asset")
    items: tuple[AssetRef, ...] = argument("asset", many=True)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return two rows per thing: each reaches over the other's edge, as the rug sees it and as the thing sees it.

        Two boxes overlap if and only if they do along the axes of both. The rug moves.
        """
        rows: list[Term] = []
        for item in self.items:
            along, across = _reach(half_size(scene, self.a))
            rows.append(FrameTerm(item, self.a, along=along, across=across, moves="b"))
            along, across = _reach(half_size(scene, item))
            rows.append(FrameTerm(self.a, item, along=along, across=across))
        return tuple(rows)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The rug's footprint overlaps each thing's."""
        rug = footprint(scene, layout, self.a)
        covered = {item.name: common_area(rug, footprint(scene, layout, item)) for item in self.items}
        beside = [name for name, area in covered.items() if area < 1e-4]
        least = min(covered.values())
        text = f"{', '.join(beside)} beside it" if beside else f"at least {least:.2f} m2 of each thing on it"
        return Outcome(not beside, least, 1e-4, "m2", text)


def _reach(half: tuple[float, float]) -> tuple[Interval, Interval]:
    """Return the intervals of what reaches over the edges of a thing of that half size."""
    hx, hy = (max(side - OVERLAP, side / 2) for side in half)
    return Interval(-hx, hx, -1.0, -1.0), Interval(-hy, hy, -1.0, -1.0)
