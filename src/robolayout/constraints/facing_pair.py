"""`facing_pair`: two things look at each other."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._exact import TOLERANCE, facing_error
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class FacingPair(Relation):
    """`a` and `b` look at each other."""

    name = "facing_pair"
    moves = ("a", "b")
    orients = True
    example = "solver.facing_pair(armchair[0], armchair[1])"

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row for each direction to look."""
        return (FrameTerm(self.a, self.b, look=0.0, moves="both"), FrameTerm(self.b, self.a, look=0.0, moves="both"))

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Each front's ray hits the other's footprint, or is within 10 degrees of its centre."""
        off = max(facing_error(scene, layout, self.a, self.b), facing_error(scene, layout, self.b, self.a))
        return Outcome.at_most(TOLERANCE.angle, off, "deg", f"fronts up to {off:.0f} deg off each other")
