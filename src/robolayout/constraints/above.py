"""`above`: a thing hangs over another, at the wall behind it or under the ceiling."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._exact import TOLERANCE, frame, half_size
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class Above(Relation):
    """The centre of `a` is over `b`, or over the wall right behind it; the height is that at which such a thing hangs."""

    name = "above"
    example = "solver.above(picture[0], bed[0])"

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row in b's frame."""
        hx, hy = half_size(scene, self.b)
        return (FrameTerm(self.a, self.b, along=Interval(-hx - TOLERANCE.behind, hx), across=Interval(-hy, hy)),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The centre within b's footprint, or at most 0.3 m behind its back, with 5 cm of tolerance."""
        hx, hy = half_size(scene, self.b)
        pose = layout[self.a.name]
        u, v = frame(scene, layout, self.b).seen(pose.at)
        off = max(0.0, u - hx, -hx - TOLERANCE.behind - u, abs(v) - hy)
        return Outcome.at_most(TOLERANCE.gap, off, "m", f"{off:.2f} m beside the place over {self.b}")
