"""What a phrase asks of a scene: one thing that must hold, with every way in which it can be met."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from shapely import LineString

from robolayout.constraints import AssetRef, Outcome, PointRef, Relation
from robolayout.constraints._exact import footprint, frame
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class Between:
    """That a thing stands between two others: its centre within half a metre of the line between theirs, and not past their ends.

    Attributes:
        a: What stands there.
        b: One of the two.
        c: The other one, or a point.
    """

    a: AssetRef
    b: AssetRef | PointRef
    c: AssetRef | PointRef

    SLACK = 0.5

    def asset_names(self) -> tuple[str, ...]:
        """Return the names of the assets that it is about."""
        return tuple(ref.name for ref in (self.a, self.b, self.c) if isinstance(ref, AssetRef))

    def sentence(self) -> str:
        """Return it as text."""
        return f"{self.a} between {self.b} and {self.c}"

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Within 0.5 m of the line between the centres, and between them along it."""
        here = layout[self.a.name]
        one, two = (frame(scene, layout, ref) for ref in (self.b, self.c))
        dx, dy = two.x - one.x, two.y - one.y
        length = math.hypot(dx, dy) or 1.0
        along = ((here.x - one.x) * dx + (here.y - one.y) * dy) / length
        aside = footprint(scene, layout, self.a).distance(LineString([(one.x, one.y), (two.x, two.y)]))
        met = 0.0 < along < length and aside <= self.SLACK
        return Outcome(met, aside, self.SLACK, "m", f"{aside:.2f} m off the line between {self.b} and {self.c}")


Way = tuple[Relation, ...]
"""Statements that meet a demand together."""


@dataclass(frozen=True)
class Demand:
    """One thing that must hold, and the ways in which it can.

    Attributes:
        ways: Statements of the public vocabulary; one of these ways is enough.
        exact: What is judged instead, where no statement says it.
    """

    ways: tuple[Way, ...]
    exact: Between | None = None

    def measure(self, scene: Scene, layout: Layout) -> Outcome:
        """Return how the demand stands: the outcome of the worst statement of its best way."""
        if self.exact is not None:
            return self.exact.check(scene, layout)
        worst = [_worst([relation.check(scene, layout) for relation in way]) for way in self.ways]
        return min(worst, key=lambda outcome: (not outcome.met, outcome.value - outcome.limit))

    def names(self) -> frozenset[str]:
        """Return the names of all assets that it is about."""
        found = {name for way in self.ways for relation in way for name in relation.asset_names()}
        return frozenset(found | set(self.exact.asset_names() if self.exact else ()))


def _worst(outcomes: Sequence[Outcome]) -> Outcome:
    return max(outcomes, key=lambda outcome: (not outcome.met, outcome.value - outcome.limit))
