"""`toward`: a thing stands toward one edge of what carries it."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._exact import TOLERANCE, frame
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class Toward(Relation):
    """`a` stands on the `side` half of what it is on, `b`, as b sees it: "front", "back", "left" or "right"."""

    name = "toward"
    example = 'solver.toward(monitor[0], desk[0], "back")'

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")
    side: str = argument("text", choices=("front", "back", "left", "right"), default="back")

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row in b's frame: the centre beyond its middle."""
        half = Interval(low=0.0) if self.side in ("front", "left") else Interval(high=0.0)
        if self.side in ("front", "back"):
            return (FrameTerm(self.a, self.b, along=half),)
        return (FrameTerm(self.a, self.b, across=half),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The centre at most 5 cm past b's middle."""
        pose = layout[self.a.name]
        u, v = frame(scene, layout, self.b).seen(pose.at)
        off = max(0.0, {"front": -u, "back": u, "left": -v, "right": v}[self.side])
        return Outcome.at_most(TOLERANCE.gap, off, "m", f"{off:.2f} m past the middle of {self.b}")
