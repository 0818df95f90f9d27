"""`toward`: a thing stands toward one edge of what carries it."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._exact import TOLERANCE, frame, half_size
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class Toward(Relation):
    """`a` stands on the `side` half of what it is on, `b`, as b sees it ("front", "back", "left", "right"), `off` m or more out."""

    name = "toward"
    example = 'solver.toward(monitor[0], desk[0], "back")'

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")
    side: str = argument("text", choices=("front", "back", "left", "right"), default="back")
    off: float = argument("number", unit="m", default=0.0)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row in b's frame: the centre over that half of it."""
        x0, x1, y0, y1 = self._half(scene)
        return (FrameTerm(self.a, self.b, along=Interval(x0, x1), across=Interval(y0, y1)),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The centre at most 5 cm beside that half of b, or beside what of it is `off` m or more from the middle."""
        u, v = frame(scene, layout, self.b).seen(layout[self.a.name].at)
        x0, x1, y0, y1 = self._half(scene)
        off = max(0.0, x0 - u, u - x1, y0 - v, v - y1)
        return Outcome.at_most(TOLERANCE.gap, off, "m", f"{off:.2f} m beside the {self.side} half of {self.b}")

    def _half(self, scene: Scene) -> tuple[float, float, float, float]:
        """Return from where to where that half of b lies along its front and across, in metres."""
        (hx, hy), side, off = half_size(scene, self.b), self.side, self.off
        along = (off if side == "front" else -hx, -off if side == "back" else hx)
        return (*along, off if side == "left" else -hy, -off if side == "right" else hy)
