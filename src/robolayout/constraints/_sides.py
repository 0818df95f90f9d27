"""What stands on one side of another thing: the common form of `next_to`, `in_front_of`, `behind`, `left_of`, `right_of`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from robolayout.constraints._exact import GAP_TOLERANCE, footprint, frame, half_size
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation, argument
from robolayout.constraints._terms import FAR, FrameTerm, Interval, Term
from robolayout.scene import Layout, Scene

SIDES = ("front", "back", "left", "right", "beside")
"""Sides as the thing itself sees them; "beside" is left or right."""


def side_terms(a: AssetRef, b: AssetRef, side: str, gap: tuple[float, float], scene: Scene) -> tuple[Term, ...]:
    """Return the row for "a stands on that side of b, `gap` (low, high) metres away, its centre within b's extent"."""
    low, high = gap
    bhx, bhy = half_size(scene, b)
    reach = bhx if side in ("front", "back") else bhy
    out = Interval(reach + low, min(reach + high, FAR), 1.0, -1.0)
    back = Interval(max(-reach - high, -FAR), -reach - low, -1.0, 1.0)
    if side in ("front", "back"):
        return (FrameTerm(a, b, along=out if side == "front" else back, across=Interval(-bhy, bhy)),)
    across = back if side == "right" else out
    return (FrameTerm(a, b, along=Interval(-bhx, bhx), across=across, fold=side == "beside"),)


def side_outcome(
    a: AssetRef, b: AssetRef, side: str, gap: tuple[float, float], scene: Scene, layout: Layout
) -> Outcome:
    """Measure the gap between a and that side of b, with 5 cm of tolerance on it and on the centre's place along it."""
    bhx, bhy = half_size(scene, b)
    seen = frame(scene, layout, b)
    left, bottom, right, top = seen.local(footprint(scene, layout, a)).bounds
    u, v = seen.point(layout[a.name].x, layout[a.name].y)
    gaps = {"front": left - bhx, "back": -bhx - right, "left": bottom - bhy, "right": -bhy - top}
    gaps["beside"] = max(gaps["left"], gaps["right"])
    slip = max(0.0, abs(v) - bhy if side in ("front", "back") else abs(u) - bhx)
    low, high = gap
    met = low - GAP_TOLERANCE <= gaps[side] <= high + GAP_TOLERANCE and slip <= GAP_TOLERANCE
    limit = low if gaps[side] < low else high
    where = "at the side" if side == "beside" else f"on the {side} side"
    text = f"{gaps[side]:.2f} m {where} of {b}" + (f", {slip:.2f} m past its end" if slip > GAP_TOLERANCE else "")
    return Outcome(met, gaps[side], limit, "m", text)


@dataclass(frozen=True)
class SideRelation(Relation):
    """`a` stands on one `side` of `b`, as b sees it, with `min_gap` to `max_gap` m between their edges."""

    side: ClassVar[str]

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")
    min_gap: float = argument("number", unit="m", default=0.0)
    max_gap: float = argument("number", unit="m", default=1.0)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row in b's frame."""
        return side_terms(self.a, self.b, self.side, (self.min_gap, self.max_gap), scene)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Gap within [min_gap - 0.05, max_gap + 0.05] m, centre within b's extent along that side."""
        return side_outcome(self.a, self.b, self.side, (self.min_gap, self.max_gap), scene, layout)
