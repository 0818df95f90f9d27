"""Implicit `inside_room`: everything is within the walls."""

from __future__ import annotations

from dataclasses import dataclass

from shapely import Polygon

from robolayout.constraints._exact import TOLERANCE, footprint
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import InsideTerm, Outcome, Relation, Term
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class InsideRoom(Relation):
    """Every footprint lies inside the room."""

    name = "inside_room"
    hard = True
    implicit = True
    example = ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row per asset."""
        return tuple(InsideTerm(AssetRef(asset.name)) for asset in scene.assets)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Every footprint inside the room polygon grown by 1 cm."""
        room = Polygon(scene.room.vertices).buffer(TOLERANCE.outside, join_style="mitre")
        worst, text = 0.0, "everything is inside"
        for name in layout:
            area = footprint(scene, layout, AssetRef(name)).difference(room).area
            if area > max(worst, 1e-9):
                worst, text = area, f"{name} is outside by {area:.4f} m2"
        return Outcome(worst <= 1e-9, worst, 0.0, "m2", text)
