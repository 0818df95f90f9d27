"""`grouped`: a thing stands near one of several others."""

from __future__ import annotations

from dataclasses import dataclass

from shapely.ops import nearest_points

from robolayout.constraints._exact import footprint, half_size
from robolayout.constraints._refs import AssetRef, PointRef
from robolayout.constraints._relation import FrameTerm, Outcome, Relation, Term, Way, argument, best_way
from robolayout.constraints.near import Near
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class Grouped(Relation):
    """`a` stands near one of `items`, whichever, at most `max_gap` m from edge to edge."""

    name = "grouped"
    as_guessed = True
    surrogate = True  # the disc inside a close to one point of it, where the check takes the nearest edges
    example = "solver.grouped(armchair[0], [bookshelf[0], bookshelf[1]], 0.8)"

    a: AssetRef = argument("asset")
    items: tuple[AssetRef, ...] = argument("asset", many=True)
    max_gap: float = argument("number", unit="m", default=0.5)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row: close to the point of the nearest of them that is next to a as they stand now."""
        here = footprint(scene, near, self.a)
        there = min((footprint(scene, near, item) for item in self.items), key=here.distance)
        point = nearest_points(there, here)[0]
        return (
            FrameTerm(self.a, PointRef(point.x, point.y), distance=(0.0, self.max_gap + min(half_size(scene, self.a)))),
        )

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """As `near`, to one of them."""
        return best_way(self.ways(scene), scene, layout)[1]

    def ways(self, scene: Scene) -> tuple[Way, ...]:
        """Return one for each of them."""
        return tuple((Near(self.a, item, self.max_gap),) for item in self.items)
