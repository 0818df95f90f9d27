"""`symmetric_pair`: two things are mirror images."""

from __future__ import annotations

import math
from dataclasses import dataclass

from robolayout.constraints._exact import TOLERANCE, frame
from robolayout.constraints._refs import AssetRef, WallRef
from robolayout.constraints._relation import MirrorTerm, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class SymmetricPair(Relation):
    """`a` and `b` are mirror images left and right of `ref` (about its front axis; for a wall: its middle normal)."""

    name = "symmetric_pair"
    moves = ("a", "b")
    surrogate = True  # mirrored headings too, which the check leaves free
    example = "solver.symmetric_pair(night_stand[0], night_stand[1], bed[0])"

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")
    ref: AssetRef | WallRef = argument("asset", "wall")

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one mirror row."""
        return (MirrorTerm(self.a, self.b, self.ref),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The mirror image of a within 10 cm of b."""
        axis = frame(scene, layout, self.ref)
        first, second = (axis.seen(layout[r.name].at) for r in (self.a, self.b))
        flip = (-1.0, 1.0) if isinstance(self.ref, WallRef) else (1.0, -1.0)
        error = math.dist((first[0] * flip[0], first[1] * flip[1]), second)
        text = f"{error:.2f} m from the mirror image about {self.ref}"
        return Outcome.at_most(TOLERANCE.mirror, error, "m", text)
