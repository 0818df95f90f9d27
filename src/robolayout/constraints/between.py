"""`between`: a thing stands between two others."""

from __future__ import annotations

import math
from dataclasses import dataclass

from shapely import LineString, Point

from robolayout.constraints._exact import TOLERANCE, footprint, frame, half_size, seen_from, shape
from robolayout.constraints._refs import AssetRef, PointRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Pose, Scene

NEAR = 1.5  # metres before a front up to which something is right before it
ENDS = 0.2  # part of what is free of that line, at either end, that the search keeps clear of


@dataclass(frozen=True)
class BetweenTwo(Relation):
    """`a` stands between `b` and `c`: on the line of their middles or little aside (0.5 m, or as both reach), or right before both."""

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
        """Return one row in the frame of what is free of the line between the two as they stand now."""
        free = self._free(scene, near)
        (x, y), (u, v) = free.coords[0], free.coords[-1]
        middle = PointRef((x + u) / 2, (y + v) / 2, yaw=math.atan2(v - y, u - x))
        most = free.length * (0.5 - ENDS)
        deep = isinstance(self.b, PointRef) and isinstance(self.c, PointRef)  # windows, to whose wall it has its back
        half = TOLERANCE.aside / 2 + (max(scene.by_name[self.a.name].size[:2]) / 2 if deep else 0.0)
        return (FrameTerm(self.a, middle, along=Interval(-most, most), across=Interval(-half, half)),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """On the line of the centres, or its middle no farther aside than b or c reaches, between their edges; or before both fronts."""
        here, free = layout[self.a.name], self._free(scene, layout)
        (x, y), (u, v) = free.coords[0], free.coords[-1]
        along = ((here.x - x) * (u - x) + (here.y - y) * (v - y)) / (free.length or 1.0)
        past = max(-along, along - free.length)
        most, line = self._most(scene, layout), self._line(scene, layout)
        aside = footprint(scene, layout, self.a).distance(line)
        if most is not None and aside > TOLERANCE.gap:
            aside = line.distance(Point(here.at))
        text = f"{aside:.2f} m off the line between {self.b} and {self.c}"
        text += f", {past:.2f} m past the edge of one" if past > TOLERANCE.gap else ""
        limit = TOLERANCE.aside if most is None else most
        if self._before_both(scene, layout):
            return Outcome(True, 0.0, limit, "m", f"before {self.b} and {self.c}")
        return Outcome(past <= TOLERANCE.gap and aside <= limit, aside, limit, "m", text)

    def _most(self, scene: Scene, layout: Layout) -> float | None:
        """Return how far aside the middle may be; None beside points and what hangs.

        As far as b or c reaches, 0.25 to 0.5 m; farther where a does not stand out past both: a night stand at two bed heads.
        """
        ends = [ref for ref in (self.b, self.c) if isinstance(ref, AssetRef) and not scene.by_name[ref.name].on_wall]
        if len(ends) < 2:
            return None
        (x, y), (u, v) = self._line(scene, layout).coords
        along = Pose(x, y, 0.0, math.atan2(v - y, u - x))
        sides = [seen_from(along, footprint(scene, layout, ref)).bounds for ref in (*ends, self.a)]
        first, second = (max(-low, high) for _, low, _, high in sides[:2])
        within = min(first, second) - (sides[2][3] - sides[2][1]) / 2
        return max(min(max(TOLERANCE.aside / 2, first, second), TOLERANCE.aside), within)

    def _before_both(self, scene: Scene, layout: Layout) -> bool:
        """Return whether the middle of a is at most `NEAR` before the fronts of b and c, no farther aside than these reach.

        So is a coffee table before a sofa and an armchair that form an L.
        """
        at = layout[self.a.name].at
        for ref in (self.b, self.c):
            if not isinstance(ref, AssetRef) or scene.by_name[ref.name].on_wall:
                return False
            (ahead, aside), (deep, wide) = frame(scene, layout, ref).seen(at), half_size(scene, ref)
            if not (deep < ahead <= deep + NEAR and abs(aside) <= wide):
                return False
        return True

    def _line(self, scene: Scene, layout: Layout) -> LineString:
        return LineString([frame(scene, layout, ref).at for ref in (self.b, self.c)])

    def _free(self, scene: Scene, layout: Layout) -> LineString:
        """Return what of the line between their middles lies in neither; all of it where nothing does."""
        line = self._line(scene, layout)
        free = line.difference(shape(scene, layout, self.b)).difference(shape(scene, layout, self.c))
        return free if isinstance(free, LineString) and free.length > 0.0 else line
