"""`right_of`: a thing stands at the right hand of another."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation, argument
from robolayout.constraints._sides import side_outcome, side_terms
from robolayout.constraints._terms import Term
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class RightOf(Relation):
    """`a` stands on the right of `b` (as b sees it), with `min_gap` to `max_gap` m between their edges."""

    name: ClassVar[str] = "right_of"
    example: ClassVar[str] = "solver.right_of(knife[0], plate[0], 0.0, 0.1)"

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")
    min_gap: float = argument("number", unit="m", default=0.0)
    max_gap: float = argument("number", unit="m", default=1.0)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row in b's frame."""
        return side_terms(self.a, self.b, "right", (self.min_gap, self.max_gap), scene)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Gap within [min_gap - 0.05, max_gap + 0.05] m, centre within b's extent along that side."""
        return side_outcome(self.a, self.b, "right", (self.min_gap, self.max_gap), scene, layout)
