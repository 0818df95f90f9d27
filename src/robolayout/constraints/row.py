"""`row`: things stand side by side in one line."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

from robolayout.constraints._exact import TOLERANCE, angle_between, frame
from robolayout.constraints._refs import AssetRef, WallRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.constraints.against_wall import wall_outcome, wall_term
from robolayout.scene import Layout, Scene

Link = tuple[AssetRef, AssetRef, float, float]
"""A thing, its neighbour, and where the thing's centre belongs in the neighbour's frame (metres)."""


def link_terms(links: list[Link]) -> tuple[FrameTerm, ...]:
    """Return one row per link: place and heading in the neighbour's frame."""
    return tuple(
        FrameTerm(a, b, along=Interval(x, x), across=Interval(y, y), heading=0.0, moves="both") for a, b, x, y in links
    )


def links_outcome(links: list[Link], scene: Scene, layout: Layout) -> Outcome:
    """Measure the worst place and heading of all links: within 5 cm along each axis and 10 degrees."""
    off, turned = 0.0, 0.0
    for a, b, x, y in links:
        here = frame(scene, layout, b)
        u, v = here.seen(layout[a.name].at)
        off = max(off, abs(u - x), abs(v - y))
        turned = max(turned, angle_between(layout[a.name].yaw, here.yaw))
    met = off <= TOLERANCE.gap and turned <= TOLERANCE.angle
    return Outcome(met, off, TOLERANCE.gap, "m", f"up to {off:.2f} m off its place, {turned:.0f} deg off its heading")


@dataclass(frozen=True)
class Row(Relation):
    """The `items` stand side by side (each at the right hand of the one before), `gap` m apart, backs in line, at `wall`."""

    name = "row"
    moves = ("items",)
    orients = True
    surrogate = True  # at a wall, as against_wall
    example = "solver.row([shelf[0], shelf[1], shelf[2]], walls[1], gap=0.02)"

    items: tuple[AssetRef, ...] = argument("asset", many=True)
    wall: WallRef | None = argument("wall", "none", default=None)
    gap: float = argument("number", unit="m", default=0.0)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row per neighbour, and one per item for the wall."""
        links = link_terms(self._links(scene))
        if self.wall is None:
            return links
        return (*links, *(wall_term(item, self.wall, scene, 1.0) for item in self.items))

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Each within 5 cm and 10 degrees of its place beside its neighbour, and at the wall as `against_wall`."""
        outcome = links_outcome(self._links(scene), scene, layout)
        for item in self.items if self.wall is not None else ():
            at_wall = wall_outcome(item, self.wall, scene, layout)  # type: ignore[arg-type]
            if not at_wall.met:
                return replace(at_wall, text=f"{item}: {at_wall.text}")
        return outcome

    def _links(self, scene: Scene) -> list[Link]:
        links: list[Link] = []
        for before, item in pairwise(self.items):
            (bd, bw, _), (d, w, _) = (scene.by_name[ref.name].size for ref in (before, item))
            links.append((item, before, (d - bd) / 2, -(bw + w) / 2 - self.gap))
        return links
