"""`above`: a thing hangs over another, at the wall behind it or under the ceiling."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._exact import TOLERANCE, frame, half_size
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene, vertical_span


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
        """The centre within b's footprint, or at most 0.3 m behind its back and its bottom over b's middle; its middle over b's top."""
        hx, hy = half_size(scene, self.b)
        pose = layout[self.a.name]
        u, v = frame(scene, layout, self.b).seen(pose.at)
        off = max(0.0, u - hx, -hx - TOLERANCE.behind - u, abs(v) - hy)
        bottom, _ = vertical_span(scene.by_name[self.a.name], pose)
        low, high = vertical_span(scene.by_name[self.b.name], layout[self.b.name])
        sunk = max(0.0, high - pose.z, (low + high) / 2 - bottom if u < -hx else 0.0)
        text = f"{off:.2f} m beside the place over {self.b}"
        text += f", {sunk:.2f} m too low" if sunk > TOLERANCE.gap else ""
        return Outcome.at_most(TOLERANCE.gap, max(off, sunk), "m", text)
