"""`on_top_of`: a thing stands on another."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from shapely import Point

from robolayout.assets import Surface, resting_place, surfaces_of
from robolayout.assets.surfaces import hung_from, named_surfaces, outer_surfaces
from robolayout.constraints._exact import TOLERANCE, frame
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Asset, Layout, Scene, vertical_span

AT_HAND = 1.0
"""Metres above the floor at which things are taken from a shelf most easily."""

LARGER = 0.3
"""Share of a disc's radius within which the centre of what is larger than the disc stays."""


@dataclass(frozen=True)
class OnTopOf(Relation):
    """`a` stands on top of `b`: on its highest place that can hold it (a cushion on the seat), or on the `surface` named so."""

    name = "on_top_of"
    surrogate = True  # its whole footprint stays over the place, where the check wants the centre
    example = "solver.on_top_of(lamp[0], night_stand[0])"

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")
    surface: str | int = argument("text", "integer", default="")

    def meant(self, scene: Scene) -> tuple[Surface, ...]:
        """Return the surfaces of b that will do."""
        lower = scene.by_name[self.b.name]
        return named_surfaces(lower, str(self.surface)) if self.surface else self.usual(lower)

    @staticmethod
    def usual(lower: Asset) -> tuple[Surface, ...]:
        """Return the surfaces that are meant where none is named."""
        return outer_surfaces(lower)

    def places(self, scene: Scene) -> tuple[Surface, ...]:
        """Return the surfaces of b on which a is put, the best first: of several shelves that hold it the one nearest to a hand."""
        lower, upper, meant = scene.by_name[self.b.name], scene.by_name[self.a.name], self.meant(scene)
        shelves = [surface for surface in meant if surface.covered and surface.holds(upper.size)]
        reach = min((agent.reach_high for agent in scene.agents if agent.reach_distance is not None), default=math.inf)
        at_hand = sorted(shelves, key=lambda surface: (surface.height > reach, abs(surface.height - AT_HAND)))
        return tuple(at_hand) or (resting_place(lower, upper, meant),)

    def place(self, scene: Scene, near: Layout) -> Surface:
        """Return the surface of b on which a is: the one that it is on in a layout, else the best."""
        lower, upper, meant = scene.by_name[self.b.name], scene.by_name[self.a.name], self.meant(scene)
        if len(meant) > 1:
            bottom = vertical_span(upper, near[upper.name])[0] - vertical_span(lower, near[lower.name])[0]
            level = [s for s in meant if abs(s.height - bottom) <= TOLERANCE.support and s.holds(upper.size)]
            if level:
                centre = Point(frame(scene, near, self.b).seen(near[upper.name].at))
                return min(level, key=lambda surface: surface.region.distance(centre))
        return self.places(scene)[0]

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row: a's footprint inside the largest rectangle of its place, its disc or an oval's box.

        Where a is the larger one, it is a's centre.
        """
        place, size = self.place(scene, near), scene.by_name[self.a.name].size
        if place.radius:
            within = max(place.radius - max(size[:2]) / 2, place.radius * LARGER)
            return (FrameTerm(self.a, self.b, distance=(0.0, within)),)
        x0, y0, x1, y1 = place.box
        inside = float(all(np.less_equal(np.sort(size[:2]), np.sort([x1 - x0, y1 - y0]))))
        along, across = Interval(x0, x1, inside, inside), Interval(y0, y1, inside, inside)
        return (FrameTerm(self.a, self.b, along=along, across=across),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Its bottom within 2 cm of a surface that will do, and its centre over that."""
        bottom, _ = vertical_span(scene.by_name[self.a.name], layout[self.a.name])
        low, _ = vertical_span(scene.by_name[self.b.name], layout[self.b.name])
        centre = Point(frame(scene, layout, self.b).seen(layout[self.a.name].at))
        upper = scene.by_name[self.a.name]
        found = [
            (s.region.distance(centre) > 1e-6, abs(bottom - low - s.height), s.name)
            for s in (*(hung_from(s, upper) for s in self.meant(scene)), *self.places(scene)[:1])
        ]
        beside, gap, name = min(found)
        text = f"bottom {gap:.3f} m from the {name} of {self.b}" + (", centre not over it" if beside else "")
        return Outcome(gap <= TOLERANCE.support and not beside, gap, TOLERANCE.support, "m", text)

    def fault(self, scene: Scene) -> str:
        """Return which surfaces there are, where the named one is none of them."""
        if not self.surface or self.meant(scene):
            return ""
        known = ", ".join(s.name for s in surfaces_of(scene.by_name[self.b.name]))
        return f"{self.b} has no surface {self.surface!r}; it has {known or 'none'}"
