"""`on_top_of`: a thing stands on another."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from shapely import Point

from robolayout.constraints._exact import footprint, half_size
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation, argument
from robolayout.constraints._terms import FrameTerm, Interval, Term
from robolayout.scene import Layout, Scene, vertical_span

SUPPORT_TOLERANCE = 0.02
"""Metres between a thing's bottom and the top that carries it (DESIGN section 4)."""


@dataclass(frozen=True)
class OnTopOf(Relation):
    """`a` stands on top of `b`, its footprint over b's."""

    name: ClassVar[str] = "on_top_of"
    hard: ClassVar[bool] = True
    surrogate: ClassVar[bool] = True  # its whole footprint stays over b, where the check wants the centre
    example: ClassVar[str] = "solver.on_top_of(lamp[0], night_stand[0])"

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row: a's footprint inside b's (its centre, where a is the larger one)."""
        ahx, ahy = half_size(scene, self.a)
        bhx, bhy = half_size(scene, self.b)
        inside = 1.0 if max(ahx, ahy) <= min(bhx, bhy) or (ahx <= bhx and ahy <= bhy) else 0.0
        along, across = Interval(-bhx, bhx, inside, inside), Interval(-bhy, bhy, inside, inside)
        return (FrameTerm(self.a, self.b, along=along, across=across),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Its bottom within 2 cm of the top of b, and its centre over b's footprint."""
        bottom, _ = vertical_span(scene.by_name[self.a.name], layout[self.a.name])
        _, top = vertical_span(scene.by_name[self.b.name], layout[self.b.name])
        pose = layout[self.a.name]
        over = footprint(scene, layout, self.b).distance(Point(pose.x, pose.y)) < 1e-6
        gap = abs(bottom - top)
        text = f"bottom {gap:.3f} m from the top of {self.b}" + ("" if over else ", centre not over it")
        return Outcome(gap <= SUPPORT_TOLERANCE and over, gap, SUPPORT_TOLERANCE, "m", text)
