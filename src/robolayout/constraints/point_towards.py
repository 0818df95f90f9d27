"""`point_towards`: a thing looks at another."""

from __future__ import annotations

import math
from dataclasses import dataclass

from robolayout.constraints._exact import TOLERANCE, facing_error
from robolayout.constraints._refs import AssetRef, Ref
from robolayout.constraints._relation import FrameTerm, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class PointTowards(Relation):
    """`a` is turned by `angle` degrees (counter-clockwise) from looking at `b`; at 0 its front points at `b`.

    The published function's convention: with f the front of a and R(-angle) the turn by minus angle, the ray along
    R(-angle) f hits b's footprint, else 1 - cos between R(-angle) f and the direction from a to b's centre counts.
    """

    name = "point_towards"
    orients = True
    example = "solver.point_towards(sofa[0], tv[0])"

    a: AssetRef = argument("asset")
    b: Ref = argument("asset", "wall", "point")
    angle: float = argument("number", unit="deg", default=0.0)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row that sets where the front looks."""
        return (FrameTerm(self.a, self.b, look=-math.radians(self.angle)),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The ray along the front, turned back by `angle`, hits b's footprint, or is within 10 degrees of its centre."""
        off = facing_error(scene, layout, self.a, self.b, -math.radians(self.angle))
        return Outcome.at_most(TOLERANCE.angle, off, "deg", f"front {off:.0f} deg off {self.b}")
