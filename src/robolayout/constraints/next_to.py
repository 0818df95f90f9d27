"""`next_to`: a thing stands close beside another."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation, argument
from robolayout.constraints._sides import SIDES, side_outcome, side_terms
from robolayout.constraints._terms import Term
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class NextTo(Relation):
    """`a` stands close to `b` on a `side` of it ("beside" is left or right), `min_gap` to `max_gap` m from edge to edge."""

    name = "next_to"
    example = 'solver.next_to(night_stand[0], bed[0], "left")'

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")
    side: str = argument("text", choices=SIDES, default="beside")
    max_gap: float = argument("number", unit="m", default=0.3)
    min_gap: float = argument("number", unit="m", default=0.0)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row in b's frame."""
        return side_terms(self.a, self.b, self.side, (self.min_gap, self.max_gap), scene)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Gap within [min_gap - 0.05, max_gap + 0.05] m, centre within b's extent along that side."""
        return side_outcome(self.a, self.b, self.side, (self.min_gap, self.max_gap), scene, layout)
