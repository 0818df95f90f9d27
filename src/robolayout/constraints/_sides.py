"""What stands on one side of another thing: the common form of `next_to`, `in_front_of`, `behind`, `left_of`, `right_of`."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from robolayout.constraints._exact import TOLERANCE, footprint, frame, half_size, seen_from
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FAR, FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene

SIDES = ("front", "back", "left", "right", "beside")  # sides as the thing itself sees them; "beside" is left or right


class BySide(Relation):
    """`a` stands on a `side` of `b`, as b sees it, with `min_gap` to `max_gap` m between their edges."""

    a: AssetRef
    b: AssetRef
    side: str  # one of `SIDES`
    min_gap: float
    max_gap: float

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row in b's frame."""
        a, b, side = self.a, self.b, self.side
        bhx, bhy = half_size(scene, b)
        reach = bhx if side in ("front", "back") else bhy
        out = Interval(reach + self.min_gap, min(reach + self.max_gap, FAR), 1.0, -1.0)
        back = Interval(max(-reach - self.max_gap, -FAR), -reach - self.min_gap, -1.0, 1.0)
        ahx, ahy = _reaches(scene, near, a, b)
        if side in ("front", "back"):
            return (FrameTerm(a, b, along=out if side == "front" else back, across=_level(bhy, bhy, ahy)),)
        across = back if side == "right" else out
        along = _level(bhx, bhx + self._before(scene), ahx)
        return (FrameTerm(a, b, along=along, across=across, fold=side == "beside"),)

    def _before(self, scene: Scene) -> float:
        """Return the metres before b in which what stands on the floor is at the side of a board on its wall."""
        a, b = (scene.by_name[ref.name] for ref in (self.a, self.b))
        return TOLERANCE.before if a.on_floor and b.on_wall and not b.on_floor else 0.0

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Gap within [min_gap - 0.05, max_gap + 0.05] m, one's middle within the other's extent along that side, or before it at a wall."""
        side, low, high = self.side, self.min_gap, self.max_gap
        bhx, bhy = half_size(scene, self.b)
        here = frame(scene, layout, self.b)
        left, bottom, right, top = seen_from(here, footprint(scene, layout, self.a)).bounds
        u, v = here.seen(layout[self.a.name].at)
        gaps = {"front": left - bhx, "back": -bhx - right, "left": bottom - bhy, "right": -bhy - top}
        gaps["beside"] = max(gaps["left"], gaps["right"])
        if side in ("front", "back"):
            slip = min(abs(v) - bhy, max(bottom, -top))
        else:
            slip = min(max(-bhx - u, u - bhx - self._before(scene)), max(left, -right))
        slip = max(0.0, slip)
        met = low - TOLERANCE.gap <= gaps[side] <= high + TOLERANCE.gap and slip <= TOLERANCE.gap
        where = "at the side" if side == "beside" else f"on the {side} side"
        text = f"{gaps[side]:.2f} m {where} of {self.b}"
        text += f", {slip:.2f} m past its end" if slip > TOLERANCE.gap else ""
        return Outcome(met, gaps[side], low if gaps[side] < low else high, "m", text)


def _level(back: float, ahead: float, reach: float) -> Interval:
    """Return where the middle of a lies in the extent of b, or that of b in a's, which reaches so far, if this is the longer one."""
    return Interval(-back, ahead) if reach <= ahead else Interval(0.0, 0.0, -1.0, -1.0)


def _reaches(scene: Scene, layout: Layout, a: AssetRef, b: AssetRef) -> tuple[float, float]:
    """Return how far a thing reaches from its middle along b's axes, in metres."""
    (hx, hy), turn = half_size(scene, a), layout[a.name].yaw - layout[b.name].yaw
    c, s = abs(math.cos(turn)), abs(math.sin(turn))
    return c * hx + s * hy, s * hx + c * hy


@dataclass(frozen=True)
class SideRelation(BySide):
    """`a` stands on the one `side` of `b` that the relation is named for."""

    side: ClassVar[str]  # pyright: ignore[reportIncompatibleVariableOverride]

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")
    min_gap: float = argument("number", unit="m", default=0.0)
    max_gap: float = argument("number", unit="m", default=1.0)
