"""`under`: a rug lies under things."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from robolayout.constraints._exact import footprint, half_size
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation, argument
from robolayout.constraints._terms import FrameTerm, Interval, Term
from robolayout.scene import Layout, Scene

OVERLAP = 0.10
"""Metres by which each thing should reach over the rug."""


@dataclass(frozen=True)
class Under(Relation):
    """The rug `a` lies under `items`: each of them stands at least partly on it."""

    name: ClassVar[str] = "under"
    example: ClassVar[str] = "solver.under(rug[0], [sofa[0], coffee_table[0]])"

    a: AssetRef = argument("asset")
    items: tuple[AssetRef, ...] = argument("asset", many=True)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row per thing: its near side reaches over the rug's edge; the rug moves."""
        hx, hy = (max(half - OVERLAP, half / 2) for half in half_size(scene, self.a))
        along, across = Interval(-hx, hx, -1.0, -1.0), Interval(-hy, hy, -1.0, -1.0)
        return tuple(FrameTerm(item, self.a, along=along, across=across, moves="b") for item in self.items)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The rug's footprint overlaps each thing's."""
        rug = footprint(scene, layout, self.a)
        covered = {item.name: rug.intersection(footprint(scene, layout, item)).area for item in self.items}
        beside = [name for name, area in covered.items() if area < 1e-4]
        least = min(covered.values())
        text = f"{', '.join(beside)} beside it" if beside else f"at least {least:.2f} m2 of each thing on it"
        return Outcome(not beside, least, 1e-4, "m2", text)
