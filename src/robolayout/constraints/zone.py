"""`zone`: a thing stays in a part of the room."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise

from shapely import MultiPoint, Polygon, get_coordinates
from shapely import Point as ShapelyPoint
from shapely.geometry.polygon import orient

from robolayout.constraints._exact import TOLERANCE, footprint
from robolayout.constraints._refs import AssetRef, PointRef
from robolayout.constraints._relation import FAR, FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Point, Scene


@dataclass(frozen=True)
class Zone(Relation):
    """The footprint of `a` stays in the convex `polygon`, a list of points (x, y) in metres."""

    name = "zone"
    example = "solver.zone(toy_box[0], [(0, 0), (2, 0), (2, 2), (0, 2)])"

    a: AssetRef = argument("asset")
    polygon: tuple[PointRef, ...] = argument("point", many=True)

    def fault(self, scene: Scene) -> str:
        """Refuse points that lie on one line, and an outline with a dent."""
        hull = self._hull()
        if hull.area <= 1e-6:
            return "the points of a zone lie on one line; a zone has an area"
        dents = [p for p in self.polygon if hull.exterior.distance(ShapelyPoint(p.x, p.y)) > TOLERANCE.outside]
        return f"a zone is convex, and {dents[0]} is a dent in it; state any_of its convex parts" if dents else ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row for the smallest rectangle around the polygon, and one for each edge that cuts into it."""
        frame = Polygon(get_coordinates(self._hull().minimum_rotated_rectangle))
        (p, q), (_, r) = list(pairwise(_ring(frame)))[:2]
        here = PointRef(frame.centroid.x, frame.centroid.y, yaw=_yaw(p, q))
        along, across = (Interval(-side / 2, side / 2, 1.0, 1.0) for side in (math.dist(p, q), math.dist(q, r)))
        inner = Interval(0.0, FAR, 1.0, 0.0)
        cuts = [
            FrameTerm(self.a, PointRef(*start, yaw=_yaw(start, end)), across=inner)
            for start, end in pairwise(_ring(self._hull()))
            if frame.exterior.distance(MultiPoint([start, end]).centroid) > 1e-6
        ]
        return (FrameTerm(self.a, here, along=along, across=across), *cuts)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The footprint inside the polygon grown by 5 cm."""
        outside = footprint(scene, layout, self.a).difference(self._hull().buffer(TOLERANCE.gap)).area
        return Outcome(outside < 1e-6, outside, 0.0, "m2", f"{outside:.2f} m2 outside its zone")

    def _hull(self) -> Polygon:
        hull = MultiPoint([(p.x, p.y) for p in self.polygon]).convex_hull
        return hull if isinstance(hull, Polygon) else Polygon()


def _ring(polygon: Polygon) -> list[Point]:
    """Return the closed ring of a polygon, counter-clockwise."""
    return [(x, y) for x, y in orient(polygon).exterior.coords]


def _yaw(start: Point, end: Point) -> float:
    return math.atan2(end[1] - start[1], end[0] - start[0])
