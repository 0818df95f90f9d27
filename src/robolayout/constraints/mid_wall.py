"""`mid_wall`: a thing stands in the middle of its wall."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation, Term, Way, argument, best_way
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.centered_on import CenteredOn
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class MidWall(Relation):
    """`a` stands with its back in the middle of a wall, whichever."""

    name = "mid_wall"
    surrogate = True  # as against_wall
    example = "solver.mid_wall(bed[0])"

    a: AssetRef = argument("asset")

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return the rows of `against_wall` and `centered_on` for the wall where least lacks."""
        return tuple(term for one in best_way(self.ways(scene), scene, near)[0] for term in one.terms(scene, near))

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """At a wall as `against_wall`, and within 10 cm of its middle."""
        return best_way(self.ways(scene), scene, layout)[1]

    def ways(self, scene: Scene) -> tuple[Way, ...]:
        """Return both statements for each wall."""
        return tuple((one, CenteredOn(self.a, one.refs()[1])) for (one,) in AgainstWall(self.a).ways(scene))
