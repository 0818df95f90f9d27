"""Implicit `reachable_pairwise`: the paper's clearance between every two things (its section "Reachability Constraint")."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import combinations

from robolayout.assets import place_of
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, PairwiseTerm, Relation, Term
from robolayout.scene import Layout, Scene

ALPHA = 0.01  # the paper's scale of the pairwise reachability loss


@dataclass(frozen=True)
class ReachablePairwise(Relation):
    """Every two floor things leave room for the agent's disc between them: d >= e_i + e_j + 2 r, e half the smaller side; rugs aside."""

    name = "reachable_pairwise"
    implicit = True
    surrogate = True
    example = ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row per pair of floor things; none if the radius is not positive."""
        return tuple(PairwiseTerm(AssetRef(a), AssetRef(b), required, ALPHA) for a, b, required in self._pairs(scene))

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Every pair of centres at least that far apart."""
        worst, text = 0.0, "every two things leave room for the agent"
        for a, b, required in self._pairs(scene):
            if a in layout and b in layout:
                short = required - math.hypot(layout[a].x - layout[b].x, layout[a].y - layout[b].y)
                if short > worst:
                    worst, text = short, f"{a} and {b} are {short:.2f} m too close"
        return Outcome.at_most(0.0, worst, "m", text)

    def _pairs(self, scene: Scene) -> list[tuple[str, str, float]]:
        radius = scene.agent.radius
        if radius <= 0:
            return []
        floor = [a for a in scene.assets if place_of(a) == "floor" and not a.is_flat]
        return [
            (a.name, b.name, min(a.size[:2]) / 2 + min(b.size[:2]) / 2 + 2 * radius) for a, b in combinations(floor, 2)
        ]
