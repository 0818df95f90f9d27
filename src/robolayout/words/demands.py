"""What a phrase asks of a scene: one thing that must hold, with every way in which it can be met."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from robolayout.constraints import RELATIONS, AssetRef, Outcome, Relation
from robolayout.constraints.between import BetweenTwo
from robolayout.scene import Layout, Scene
from robolayout.words._ways import Ways

Way = tuple[Relation, ...]
"""Statements that meet a demand together."""


@dataclass(frozen=True)
class Demand:
    """One thing that must hold, and the ways in which it can."""

    ways: tuple[Way, ...]  # statements of the public vocabulary; one of these ways is enough
    exact: BetweenTwo | None = None  # what is judged instead, where the ways only lead there

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


def stated(relation: str, *arguments: object) -> Relation:
    """Return a statement by its name."""
    return RELATIONS[relation](*arguments)


def by_ways(ways: Ways, a: str, b: str) -> Demand:
    """Return a demand on two things from its ways."""
    return Demand(
        tuple(tuple(stated(str(name), AssetRef(a), AssetRef(b), *more) for name, *more in way) for way in ways)
    )


def single(*relations: Relation) -> Demand:
    """Return a demand that a single statement meets, any of these."""
    return Demand(tuple((relation,) for relation in relations))
