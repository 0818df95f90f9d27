"""`distance_constraint`: two things keep a distance."""

from __future__ import annotations

import math
from dataclasses import dataclass

from shapely import Point

from robolayout.constraints._exact import TOLERANCE, frame, shape
from robolayout.constraints._refs import AssetRef, Ref, WallRef
from robolayout.constraints._relation import FAR, FrameTerm, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class DistanceConstraint(Relation):
    """The centre of `a` is `min_distance` to `max_distance` m from `b` (from a wall: its segment); None is open; `weight`."""

    name = "distance_constraint"
    example = "solver.distance_constraint(armchair[0], coffee_table[0], 0.8, 1.4)"

    a: AssetRef = argument("asset")
    b: Ref = argument("asset", "wall", "point")
    min_distance: float | None = argument("number", "none", unit="m", default=None)
    max_distance: float | None = argument("number", "none", unit="m", default=None)
    weight: float = argument("number", default=1.0)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row that bounds the distance."""
        return (FrameTerm(self.a, self.b, distance=self._bounds(), weight=self.weight),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Within [min - 0.05, max + 0.05] m, centres in plan."""
        low, high = self._bounds()
        pose = layout[self.a.name]
        if isinstance(self.b, WallRef):
            distance = shape(scene, layout, self.b).distance(Point(pose.x, pose.y))
        else:
            other = frame(scene, layout, self.b)
            distance = math.hypot(pose.x - other.x, pose.y - other.y)
        met = low - TOLERANCE.gap <= distance <= high + TOLERANCE.gap
        limit = low if distance < low else high
        wanted = f"{low:g} to {high:g} m" if high < FAR else f"at least {low:g} m"
        return Outcome(met, distance, limit, "m", f"{distance:.2f} m apart, asked {wanted}")

    def _bounds(self) -> tuple[float, float]:
        return (self.min_distance or 0.0, FAR if self.max_distance is None else self.max_distance)
