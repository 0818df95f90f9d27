"""`snug`: nothing but a crack is left beside a thing."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._exact import TOLERANCE
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation, Term, Way, argument, best_way
from robolayout.constraints.corner import Corner, convex_corners
from robolayout.constraints.next_to import NextTo
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class Snug(Relation):
    """`a` stands in a corner or close beside something else that stands on the floor, at most 0.15 m from it."""

    name = "snug"
    example = "solver.snug(wardrobe[0])"

    a: AssetRef = argument("asset")

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return the rows of the way of which least lacks."""
        return tuple(
            term for one in best_way(self._ways(scene, near), scene, near)[0] for term in one.terms(scene, near)
        )

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """As `corner`, or as `next_to` at its left or right."""
        return best_way(self._ways(scene, layout), scene, layout)[1]

    def _ways(self, scene: Scene, layout: Layout) -> list[Way]:
        """Return each corner and each neighbour as a way."""
        others = [
            a for a in scene.assets if a.on_floor and not a.is_flat and a.name != self.a.name and a.name in layout
        ]
        corners: list[Way] = [(Corner(self.a, vertex),) for vertex in convex_corners(scene.room)]
        return corners + [(NextTo(self.a, AssetRef(other.name), "beside", TOLERANCE.corner),) for other in others]
