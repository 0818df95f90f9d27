"""`centered_on`: a thing stands in the middle of a wall, of another thing or of the room."""

from __future__ import annotations

import math
from dataclasses import dataclass

from robolayout.constraints._exact import TOLERANCE, frame, point_ref
from robolayout.constraints._refs import AssetRef, PointRef, Ref, WallRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene

MIDDLE = Interval(0.0, 0.0)


@dataclass(frozen=True)
class CenteredOn(Relation):
    """`a` is centred on `b`: along a wall, over an asset (at a wall and `axis` "side": sideways only), on a point or the room (None)."""

    name = "centered_on"
    example = "solver.centered_on(picture[0], bed[0])"

    a: AssetRef = argument("asset")
    b: Ref | None = argument("asset", "wall", "point", "room", default=None)
    axis: str = argument("text", choices=("both", "side"), default="both")

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row that pins the bound axes of b's frame to 0."""
        target = point_ref(self.b, scene)
        if isinstance(target, PointRef):
            return (FrameTerm(self.a, target, distance=(0.0, 0.0)),)
        along, across = self._bound(scene)
        row = FrameTerm(self.a, target, along=MIDDLE if along else Interval(), across=MIDDLE if across else Interval())
        return (row,)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Within 10 cm along each bound axis; of a point, within 10 cm."""
        pose, target = layout[self.a.name], point_ref(self.b, scene)
        u, v = frame(scene, layout, target).seen(pose.at)
        along, across = self._bound(scene)
        off = math.hypot(u, v) if isinstance(target, PointRef) else max(abs(u) * along, abs(v) * across)
        where = "the middle of the room" if self.b is None else f"the middle of {self.b}"
        return Outcome.at_most(TOLERANCE.center, off, "m", f"{off:.2f} m off {where}")

    def _bound(self, scene: Scene) -> tuple[bool, bool]:
        """Return which axes of the frame of an asset or wall are bound: along, across."""
        if isinstance(self.b, WallRef):
            return (True, False)
        hung = isinstance(self.b, AssetRef) and any(scene.by_name[ref.name].on_wall for ref in (self.a, self.b))
        return (not hung and self.axis != "side", True)
