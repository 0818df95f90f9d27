"""`grouped`: a thing stands near one of several others."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation, Way, argument, best_way
from robolayout.constraints._terms import Term
from robolayout.constraints.near import Near
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class Grouped(Relation):
    """`a` stands near one of `items`, whichever, at most `max_gap` m from edge to edge."""

    name: ClassVar[str] = "grouped"
    surrogate: ClassVar[bool] = True  # as near
    example: ClassVar[str] = "solver.grouped(armchair[0], [bookshelf[0], bookshelf[1]], 0.8)"

    a: AssetRef = argument("asset")
    items: tuple[AssetRef, ...] = argument("asset", many=True)
    max_gap: float = argument("number", unit="m", default=0.5)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return the row of `near` for the nearest of them."""
        return best_way(self.ways(scene), scene, near)[0][0].terms(scene, near)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """As `near`, to one of them."""
        return best_way(self.ways(scene), scene, layout)[1]

    def ways(self, scene: Scene) -> tuple[Way, ...]:
        """Return one for each of them."""
        return tuple((Near(self.a, item, self.max_gap),) for item in self.items)
