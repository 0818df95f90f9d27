"""What a phrase asks of a scene: one thing that must hold, with every way in which it can be met."""

from __future__ import annotations

import math
from dataclasses import dataclass

from shapely import Point, Polygon, get_parts, maximum_inscribed_circle, union_all

from robolayout.constraints import RELATIONS, TOLERANCE, AssetRef, Outcome, PointRef, Relation, WallRef
from robolayout.constraints._exact import footprint, shape
from robolayout.constraints._relation import Way, best_way
from robolayout.constraints.around import Around
from robolayout.constraints.between import BetweenTwo
from robolayout.scene import Layout, Scene
from robolayout.words._ways import Ways


@dataclass(frozen=True)
class EdgeGap:
    """So many metres lie between the edges of a thing and another one, a point, or the nearest of some walls."""

    a: AssetRef
    to: tuple[AssetRef | PointRef | WallRef, ...]
    low: float  # least metres
    high: float  # most metres
    nearest: bool = True  # whether none of the others may be nearer; else one of them is so far

    @property
    def asked(self) -> str:
        """What is asked, in words."""
        return f"{self.low:g} to {self.high:g} m" if self.high < math.inf else f"at least {self.low:g} m"

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Footprints within [low - 0.05, high + 0.05] m of each other."""
        here = footprint(scene, layout, self.a)
        gaps = [here.distance(shape(scene, layout, ref)) for ref in self.to]
        gap = min(gaps) if self.nearest else min(gaps, key=lambda gap: max(self.low - gap, gap - self.high))
        met = self.low - TOLERANCE.gap <= gap <= self.high + TOLERANCE.gap
        return Outcome(
            met, gap, self.low if gap < self.low else self.high, "m", f"{gap:.2f} m between, asked {self.asked}"
        )


@dataclass(frozen=True)
class FreeDisc:
    """So much free floor that a body turns round on it: a disc, anywhere or with its middle near one of some points."""

    diameter: float  # metres
    near: tuple[PointRef, ...] = ()  # points, in metres; none leaves it anywhere
    within: float = 0.0  # metres from one of them to the middle of the disc

    def asset_names(self) -> tuple[str, ...]:
        """It is about the floor, and no thing."""
        return ()

    def sentence(self) -> str:
        """What is asked, in words."""
        return f"a free disc of {self.diameter:g} m" + " there" * bool(self.near)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The largest disc that touches neither walls nor what stands there below the body's height is at most 0.05 m smaller."""
        tall = max(agent.height for agent in scene.agents)
        there = (one for one in scene.assets if one.name in layout and not one.is_flat)
        low = (one.name for one in there if layout[one.name].z - one.size[2] / 2 < tall)
        taken = union_all([footprint(scene, layout, AssetRef(name)) for name in low])
        radius = self.diameter / 2 - TOLERANCE.gap / 2
        room = Polygon(scene.room.vertices)
        around = [Point(at.x, at.y).buffer(self.within + radius) for at in self.near]
        free = (room.intersection(union_all(around)) if around else room).difference(taken)
        parts: list[Polygon] = [part for part in get_parts(free).tolist() if isinstance(part, Polygon)]
        widest = max((2 * maximum_inscribed_circle(part, 0.005).length for part in parts), default=0.0)
        return Outcome(
            widest >= 2 * radius, widest, self.diameter, "m", f"the largest free disc is {widest:.2f} m wide"
        )


@dataclass(frozen=True)
class Demand:
    """One thing that must hold, and the ways in which it can."""

    ways: tuple[Way, ...]  # statements of the public vocabulary; one of these ways is enough
    exact: BetweenTwo | Around | FreeDisc | None = None  # what is judged instead, where the ways only lead there
    gap: EdgeGap | None = None  # the same of metres between edges
    also: tuple[Way, ...] = ()  # further ways that are as good, of which planners need not know

    def measure(self, scene: Scene, layout: Layout) -> Outcome:
        """Return how the demand stands: the outcome of the worst statement of its best way."""
        if (judged := self.exact or self.gap) is not None:
            return judged.check(scene, layout)
        return best_way((*self.ways, *self.also), scene, layout)[1]

    def names(self) -> frozenset[str]:
        """Return the names of all assets that it is about."""
        found = {name for way in self.ways for relation in way for name in relation.asset_names()}
        return frozenset(found | set(self.exact.asset_names() if self.exact else ()))


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
