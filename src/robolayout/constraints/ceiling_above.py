"""`ceiling_above`: a ceiling thing hangs above another."""

from __future__ import annotations

import math
from dataclasses import dataclass

from robolayout.constraints._exact import TOLERANCE, frame, point_ref
from robolayout.constraints._refs import AssetRef, Ref
from robolayout.constraints._relation import FrameTerm, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene, vertical_span


@dataclass(frozen=True)
class CeilingAbove(Relation):
    """`a` hangs from the ceiling above the middle of `b`; None is the middle of the room."""

    name = "ceiling_above"
    example = "solver.ceiling_above(pendant_lamp[0], dining_table[0])"

    a: AssetRef = argument("asset")
    b: Ref | None = argument("asset", "point", "room", default=None)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row that pins the centre of a to the centre of b."""
        return (FrameTerm(self.a, point_ref(self.b, scene), distance=(0.0, 0.0)),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Within 15 cm in plan, its top within 2 cm of the ceiling."""
        target, pose = frame(scene, layout, point_ref(self.b, scene)), layout[self.a.name]
        off = math.dist(pose.at, target.at)
        below = scene.room.wall_height - vertical_span(scene.by_name[self.a.name], pose)[1]
        where = "the middle of the room" if self.b is None else str(self.b)
        text = f"{off:.2f} m off the place above {where}"
        if below > TOLERANCE.support:
            return Outcome(False, below, TOLERANCE.support, "m", f"{text}, {below:.2f} m below the ceiling")
        return Outcome.at_most(TOLERANCE.hanging, off, "m", text)
