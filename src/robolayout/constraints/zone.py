"""`zone`: a thing stays in a part of the room."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from shapely import MultiPoint

from robolayout.constraints._exact import GAP_TOLERANCE, footprint
from robolayout.constraints._refs import AssetRef, PointRef
from robolayout.constraints._relation import Outcome, Relation, argument
from robolayout.constraints._terms import FrameTerm, Interval, Term
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class Zone(Relation):
    """The footprint of `a` stays in the convex `polygon`, a list of points (x, y) in metres."""

    name: ClassVar[str] = "zone"
    surrogate: ClassVar[bool] = True
    example: ClassVar[str] = "solver.zone(toy_box[0], [(0, 0), (2, 0), (2, 2), (0, 2)])"

    a: AssetRef = argument("asset")
    polygon: tuple[PointRef, ...] = argument("point", many=True)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row: inside the polygon's upright bounding box (exact for upright rectangles)."""
        left, bottom, right, top = self._hull().bounds
        here = PointRef((left + right) / 2, (bottom + top) / 2)
        half = ((right - left) / 2, (top - bottom) / 2)
        along, across = (Interval(-h, h, 1.0, 1.0) for h in half)
        return (FrameTerm(self.a, here, along=along, across=across),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The footprint inside the polygon grown by 5 cm."""
        outside = footprint(scene, layout, self.a).difference(self._hull().buffer(GAP_TOLERANCE)).area
        return Outcome(outside < 1e-6, outside, 0.0, "m2", f"{outside:.2f} m2 outside its zone")

    def _hull(self) -> MultiPoint:
        return MultiPoint([(p.x, p.y) for p in self.polygon]).convex_hull  # type: ignore[return-value]
