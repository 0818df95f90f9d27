"""`align_with`: two things face the same way, or at a given angle."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from robolayout.constraints._exact import TOLERANCE, angle_between, frame
from robolayout.constraints._refs import AssetRef, WallRef
from robolayout.constraints._relation import FrameTerm, Outcome, Relation, Term, Way, argument, best_way
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class AlignWith(Relation):
    """The front of `a` is turned by `angle` degrees (counter-clockwise) from that of `b`, or a wall's direction; room: square to any."""

    name = "align_with"
    orients = True
    example = "solver.align_with(monitor[0], desk[0])"

    a: AssetRef = argument("asset")
    b: AssetRef | WallRef | None = argument("asset", "wall", "room", default=None)
    angle: float = argument("number", unit="deg", default=0.0)

    def ways(self, scene: Scene) -> tuple[Way, ...]:
        """Return those along and across each wall where it is aligned with the room."""
        if self.b is not None:
            return ()
        turns = range(0, 360, 90)
        return tuple(
            (replace(self, b=WallRef(wall.index), angle=self.angle + turn),)
            for wall in scene.room.walls
            for turn in turns
        )

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row that sets the heading."""
        if self.b is None:
            return best_way(self.ways(scene), scene, near)[0][0].terms(scene, near)
        return (FrameTerm(self.a, self.b, heading=math.radians(self.angle)),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Within 10 degrees."""
        if self.b is None:
            return best_way(self.ways(scene), scene, layout)[1]
        wanted = frame(scene, layout, self.b).yaw + math.radians(self.angle)
        off = angle_between(layout[self.a.name].yaw, wanted)
        return Outcome.at_most(TOLERANCE.angle, off, "deg", f"heading {off:.0f} deg off")
