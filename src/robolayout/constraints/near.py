"""`near`: a thing stands close to another, on any side of it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from robolayout.constraints._exact import TOLERANCE, footprint, half_size, shape
from robolayout.constraints._refs import AssetRef, PointRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class Near(Relation):
    """`a` stands near `b`, on any side of it, at most `max_gap` m from edge to edge."""

    name = "near"
    surrogate = True  # its gap along either axis of b is so small that past a corner it is enough, too
    example = "solver.near(armchair[0], bookshelf[0], 0.8)"

    a: AssetRef = argument("asset")
    b: AssetRef | PointRef = argument("asset", "point")
    max_gap: float = argument("number", unit="m", default=0.5)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row: in b's frame both gaps at most g / sqrt(2), g being max_gap; of a point (u, v), in a's frame.

        |u| <= hx + g, |v| <= hy + g and |(u, v)| <= sqrt(hx^2 + hy^2 + g^2 + 2 g min(hx, hy)): all such points are within g of a.
        """
        if isinstance(self.b, PointRef):
            hx, hy = half_size(scene, self.a)
            most = math.sqrt(hx**2 + hy**2 + self.max_gap**2 + 2.0 * self.max_gap * min(hx, hy))
            along, across = (Interval(-half - self.max_gap, half + self.max_gap) for half in (hx, hy))
            return (FrameTerm(self.b, self.a, along=along, across=across, distance=(0.0, most), moves="b"),)
        hx, hy = half_size(scene, self.b)
        gap = self.max_gap / math.sqrt(2)
        along, across = (Interval(-half - gap, half + gap, -1.0, -1.0) for half in (hx, hy))
        return (FrameTerm(self.a, self.b, along=along, across=across),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Footprints at most max_gap + 0.05 m apart."""
        gap = footprint(scene, layout, self.a).distance(shape(scene, layout, self.b))
        return Outcome(gap <= self.max_gap + TOLERANCE.gap, gap, self.max_gap, "m", f"{gap:.2f} m from {self.b}")
