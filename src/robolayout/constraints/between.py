"""`between`: a thing stands between two others."""

from __future__ import annotations

import math
from dataclasses import dataclass

from shapely import LineString

from robolayout.constraints._exact import TOLERANCE, footprint, frame
from robolayout.constraints._refs import AssetRef, PointRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene

ENDS = 0.2  # part of that line, at either end, that the search keeps clear of


@dataclass(frozen=True)
class BetweenTwo(Relation):
    """`a` stands between `b` and `c`: at most 0.5 m from the line between their middles, and not past its ends."""

    name = "between"
    as_guessed = True
    surrogate = True  # its middle near the line as b and c are guessed, where the check takes its edge
    example = "solver.between(side_table[0], armchair[0], armchair[1])"

    a: AssetRef = argument("asset")
    b: AssetRef | PointRef = argument("asset", "point")
    c: AssetRef | PointRef = argument("asset", "point")

    def fault(self, scene: Scene) -> str:
        """Refuse one thing twice."""
        return "a thing stands between two different ones" if self.b == self.c else ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row in the frame of the line between the two as they stand now."""
        one, two = (frame(scene, near, ref) for ref in (self.b, self.c))
        middle = PointRef((one.x + two.x) / 2, (one.y + two.y) / 2, yaw=math.atan2(two.y - one.y, two.x - one.x))
        most = math.dist((one.x, one.y), (two.x, two.y)) * (0.5 - ENDS)
        deep = isinstance(self.b, PointRef) and isinstance(self.c, PointRef)  # windows, to whose wall it has its back
        half = TOLERANCE.aside / 2 + (max(scene.by_name[self.a.name].size[:2]) / 2 if deep else 0.0)
        return (FrameTerm(self.a, middle, along=Interval(-most, most), across=Interval(-half, half)),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Within 0.5 m of the line between the centres, and between them along it."""
        here = layout[self.a.name]
        one, two = (frame(scene, layout, ref) for ref in (self.b, self.c))
        dx, dy = two.x - one.x, two.y - one.y
        length = math.hypot(dx, dy) or 1.0
        along = ((here.x - one.x) * dx + (here.y - one.y) * dy) / length
        aside = footprint(scene, layout, self.a).distance(LineString([(one.x, one.y), (two.x, two.y)]))
        met = 0.0 < along < length and aside <= TOLERANCE.aside
        return Outcome(met, aside, TOLERANCE.aside, "m", f"{aside:.2f} m off the line between {self.b} and {self.c}")
