"""The rules of the self-consistency filter, one function each.

A rule looks at one relation and at what was accepted before it. It answers None (nothing against it), a sentence (why it
is rejected) or a `Replacement` (another relation in its place, and why).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from robolayout.assets import place_of
from robolayout.assets.beneath import clearance, places_beneath
from robolayout.constraints import TOLERANCE, AssetRef, PointRef, Relation, WallRef
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.any_of import AnyOf
from robolayout.constraints.ceiling_above import CeilingAbove
from robolayout.constraints.centered_on import CenteredOn
from robolayout.constraints.corner import Corner
from robolayout.constraints.distance_constraint import DistanceConstraint
from robolayout.constraints.facing_pair import FacingPair
from robolayout.constraints.grid import Grid
from robolayout.constraints.keep_clear import KeepClear
from robolayout.constraints.mounted_on import MountedOn
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.constraints.point_towards import PointTowards
from robolayout.constraints.row import Row
from robolayout.constraints.symmetric_pair import SymmetricPair
from robolayout.constraints.under import Under
from robolayout.program import _possible as possible
from robolayout.program._program import Program, Statement
from robolayout.scene import OPENINGS, ROUNDING, Scene

OVERHANG = 1.5
"""How many times as large as a top a thing on it may be (a lampshade is wider than what it stands on, a bed is not)."""
AtWall = AgainstWall | MountedOn | Row  # relations that put something at a wall


class Replacement(NamedTuple):
    """Another relation instead of the one asked."""

    relation: Relation
    reason: str  # why, in words


@dataclass
class Accepted:
    """What was accepted so far."""

    scene: Scene
    program: Program  # the program as asked; its guesses decide the wall in paper mode
    paper: bool  # whether a wall is always the one nearest to the guess
    # what was said about what, with the statement
    seen: dict[object, Statement] = field(default_factory=dict[object, Statement])
    parents: dict[str, str] = field(default_factory=dict[str, str])  # what each thing stands on
    walls: dict[str, int] = field(default_factory=dict[str, int])  # wall of each thing that stands or hangs at one
    headings: dict[str, Statement] = field(default_factory=dict[str, Statement])  # the statement that turned each thing
    corners: set[str] = field(default_factory=set[str])  # things that have a corner
    # heights in metres of the middles of wall things
    mounted: dict[str, float] = field(default_factory=dict[str, float])

    def __post_init__(self) -> None:
        for asset in self.scene.assets:
            guess = self.program.guesses.get(asset.name)
            if guess and guess.position and guess.position[2] > asset.size[2] / 2:
                self.mounted[asset.name] = guess.position[2]

    def add(self, statement: Statement) -> None:
        """Remember an accepted statement."""
        relation = statement.relation
        self.seen[topic(relation)] = statement
        if isinstance(relation, OnTopOf):
            self.parents[relation.a.name] = relation.b.name
        if isinstance(relation, MountedOn) and relation.height is not None:
            self.mounted[relation.a.name] = relation.height
        if isinstance(relation, Corner):
            self.corners.add(relation.a.name)
        if isinstance(relation, AtWall) and relation.wall is not None:
            for name in subjects(relation):
                self.walls.setdefault(name, relation.wall.index)
        if relation.orients and not relation.ways(self.scene):
            for name in subjects(relation):
                self.headings.setdefault(name, statement)

    def span(self, name: str) -> tuple[float, float]:
        """Return the heights in metres of a thing's bottom and top."""
        return possible.height_span(self.scene, name, self.parents, self.mounted)

    def collide(self, first: str, second: str) -> bool:
        """Return whether two things could be in each other's way."""
        flat = self.scene.by_name[first].is_flat or self.scene.by_name[second].is_flat
        related = self.parents.get(first) == second or self.parents.get(second) == first
        return not flat and not related and possible.share_height(self.span(first), self.span(second))


def subjects(relation: Relation) -> tuple[str, ...]:
    """Return the names of the assets that a relation may move."""
    names: list[str] = []
    for argument in relation.moves:
        value = getattr(relation, argument)
        names += [item.name for item in (value if isinstance(value, tuple) else (value,)) if isinstance(item, AssetRef)]
    return tuple(names)


def topic(relation: Relation) -> object:
    """Return what a second statement may not be about again: the relation and its pair, in any order where it has none."""
    refs = relation.refs()
    if isinstance(relation, DistanceConstraint | FacingPair):
        return (relation.name, frozenset(refs))
    if isinstance(relation, AnyOf | KeepClear):  # a thing has several sides
        return relation
    if isinstance(relation, SymmetricPair):
        return (relation.name, frozenset(refs[:2]), refs[2])
    return (relation.name, refs) if len(refs) > 1 else relation


def where(statement: Statement) -> str:
    """Return words for an earlier statement."""
    line = f" (line {statement.line})" if statement.line else ""
    return f"{statement.relation.sentence()}{line}"


Answer = None | str | Replacement


def known(so_far: Accepted, relation: Relation) -> Answer:
    """Reject what is not in the scene."""
    for ref in relation.refs():
        if isinstance(ref, AssetRef) and ref.name not in so_far.scene.by_name:
            return f"{ref.name} is not in this scene"
        if isinstance(ref, WallRef) and not 0 <= ref.index < len(so_far.scene.room.walls):
            return f"{ref} does not exist: the room has {len(so_far.scene.room.walls)} walls"
    return None


def not_itself(so_far: Accepted, relation: Relation) -> Answer:
    """Reject a relation of a thing to itself."""
    names = relation.asset_names()
    twice = next((name for i, name in enumerate(names) if name in names[:i]), None)
    return f"{twice} is named twice; nothing stands in a relation to itself" if twice else None


def rug_below(so_far: Accepted, relation: Relation) -> Answer:
    """Put a rug under what is said to stand on it: furniture on a rug stands on the floor."""
    if isinstance(relation, OnTopOf) and so_far.scene.by_name[relation.b.name].is_flat:
        change = Under(relation.b, (relation.a,))
        return Replacement(change, f"{relation.b} is flat: {relation.a} stands on the floor and the rug lies under it")
    return None


def suits(so_far: Accepted, relation: Relation) -> Answer:
    """Reject what a ceiling, wall or floor thing cannot do."""
    assets = so_far.scene.by_name
    moved = [assets[name] for name in subjects(relation)]
    at_wall = isinstance(relation, Row) and relation.wall is not None
    needs_standing = at_wall or isinstance(relation, AgainstWall | MountedOn | OnTopOf | Corner | Under)
    if needs_standing and (hung := next((asset for asset in moved if place_of(asset) == "ceiling"), None)):
        return f"{hung.name} hangs from the ceiling, so {relation.name} does not apply to it"
    first = moved[0] if moved else None
    if isinstance(relation, MountedOn) and first and not first.on_wall:
        return f"{first.name} does not hang at walls; against_wall puts it there"
    if isinstance(relation, CeilingAbove) and first and not first.on_ceiling:
        return f"{first.name} does not hang from the ceiling"
    if isinstance(relation, Under):
        return _fits_below(so_far, relation)
    if isinstance(relation, CenteredOn) and first and isinstance(relation.b, AssetRef) and relation.axis == "both":
        hung = first.on_wall or assets[relation.b.name].on_wall
        same_place = not hung and so_far.collide(first.name, relation.b.name)
        return f"{first.name} and {relation.b} would be in the same place" if same_place else None
    if isinstance(relation, MountedOn | CeilingAbove) and relation.a.name in so_far.parents:
        return f"{relation.a} already stands on {so_far.parents[relation.a.name]}"
    return None


def _fits_below(so_far: Accepted, relation: Under) -> Answer:
    low, above = so_far.scene.by_name[relation.a.name], [so_far.scene.by_name[item.name] for item in relation.items]
    hung = next((one for one in above if place_of(one) == "ceiling"), None)
    if hung is not None:
        return f"{hung.name} hangs from the ceiling; nothing lies under it"
    tight = next((one for one in above if not low.is_flat and not places_beneath(one, low)), None)
    if tight is None:
        return None
    free = clearance(tight, low.size[:2])
    room = f"only things up to {free:.2f} m high do" if free > 0.0 else "nothing that wide and deep does"
    return f"{low.name} is {low.size[2]:.2f} m high and does not fit under {tight.name}: {room}"


def once(so_far: Accepted, relation: Relation) -> Answer:
    """Reject a second statement about the same pair, and a second corner."""
    earlier = so_far.seen.get(topic(relation))
    if earlier is not None:
        return f"it repeats {where(earlier)}; the first one counts"
    if isinstance(relation, Corner) and relation.a.name in so_far.corners:
        return f"{relation.a} already has a corner"
    return None


def one_wall(so_far: Accepted, relation: Relation) -> Answer:
    """Reject a second wall for the same thing."""
    if isinstance(relation, AgainstWall | MountedOn) and relation.wall and relation.a.name in so_far.walls:
        return f"{relation.a} is already at walls[{so_far.walls[relation.a.name]}]; a thing has one wall"
    return None


def one_heading(so_far: Accepted, relation: Relation) -> Answer:
    """Reject a second heading that may contradict the first; of two that should face each other, let the free one turn.

    Free rows and grids only say how their things stand to each other, so one of them may be aligned with something else.
    """
    if not relation.orients or relation.ways(so_far.scene):
        return None
    turned = [name for name in subjects(relation) if _is_turned(so_far, name, relation)]
    if not turned:
        return None
    earlier = so_far.headings[turned[0]]
    loose = isinstance(relation, Grid | Row) and getattr(relation, "wall", None) is None
    if loose and len(turned) == 1 and isinstance(earlier.relation, AlignWith):
        return None
    if isinstance(relation, FacingPair) and len(turned) == 1:
        free = relation.b if relation.a.name == turned[0] else relation.a
        change = PointTowards(free, AssetRef(turned[0]))
        return Replacement(change, f"{turned[0]} is already turned by {where(earlier)}, so only {free} turns")
    for name in turned:
        gap = possible.heading_gap(so_far, relation, name)
        if gap is None or gap > TOLERANCE.angle:
            away = "" if gap is None else f", {gap:.0f} degrees away"
            return f"{name} is already turned by {where(so_far.headings[name])}{away}; the first one counts"
    return None


def _is_turned(so_far: Accepted, name: str, relation: Relation) -> bool:
    """Return whether something else turned it: a chair that looks at the table may still stand around that table."""
    earlier = so_far.headings.get(name)
    if earlier is None:
        return False
    several = isinstance(getattr(relation, relation.moves[0]), tuple)
    others = {ref for ref in earlier.relation.refs() if ref != AssetRef(name)}
    agrees = several and others <= set(relation.refs()) and not getattr(earlier.relation, "angle", 0.0)
    return not agrees


def wall_holds(so_far: Accepted, relation: Relation) -> Answer:
    """Replace a wall that cannot hold the thing by the nearest one that can."""
    if not isinstance(relation, AtWall) or relation.wall is None or not subjects(relation):
        return None
    asked = so_far.scene.room.walls[relation.wall.index]
    trouble = _trouble(so_far, relation, asked.index)
    place = so_far.program.place(relation.a.name) if so_far.paper and not isinstance(relation, Row) else None
    if trouble is None and place is None:
        return None
    able = [wall for wall in so_far.scene.room.walls if _trouble(so_far, relation, wall.index) is None]
    if not able:
        why = f"{trouble}, and no other wall can hold {'it' if len(subjects(relation)) == 1 else 'them'}"
        if isinstance(relation, Row):
            return Replacement(replace(relation, wall=None), f"{why}, so the row has none")
        return why
    if place is None:
        best = min(able, key=lambda wall: (round(math.dist(wall.midpoint, asked.midpoint), 9), wall.index))
        why = f"{trouble}; walls[{best.index}] is the nearest that can hold it"
    else:
        best = min(able, key=lambda wall: (round(wall.distance(place), 9), wall.index))
        why = f"walls[{best.index}] is the nearest to the first guess"
    return Replacement(replace(relation, wall=WallRef(best.index)), why) if best.index != asked.index else None


def _trouble(so_far: Accepted, relation: AtWall, index: int) -> str | None:
    """Return why a wall cannot hold the things of a relation, None if it can."""
    wall, names = so_far.scene.room.walls[index], subjects(relation)
    elsewhere = next((name for name in names if so_far.walls.get(name, index) != index), None)
    if elsewhere:
        return f"{elsewhere} is already at walls[{so_far.walls[elsewhere]}]"
    spans = {name: so_far.span(name) for name in (*names, *so_far.walls)}
    widths = {name: so_far.scene.by_name[name].size[1] for name in spans}
    low = min(spans[name][0] for name in names)
    free = wall.between(so_far.scene.room.doors if low < OPENINGS.landing_height else ())
    needed = sum(widths[name] for name in names) + getattr(relation, "gap", 0.0) * (len(names) - 1)
    room = max((far - near for near, far in free), default=0.0)
    if needed > room + ROUNDING:
        beside = " beside its door" if room < wall.length - ROUNDING else ""
        return f"walls[{index}] has {room:.2f} m{beside}, {' and '.join(names[:3])} need{'s' * (len(names) == 1)} {needed:.2f} m"
    there = [
        name
        for name, where_at in so_far.walls.items()
        if where_at == index
        and name not in names
        and any(possible.share_height(spans[name], spans[new]) for new in names)
    ]
    taken = sum(widths[name] for name in there)
    total = sum(far - near for near, far in free)
    if needed + taken > total + ROUNDING and not so_far.paper:
        take = "takes" if len(there) == 1 else "take"
        return f"walls[{index}] has {total:.2f} m, of which {', '.join(there)} {take} {taken:.2f} m"
    return None


def stands(so_far: Accepted, relation: Relation) -> Answer:
    """Reject what cannot stand on something: a second carrier, a circle, a top too small, a ceiling too low."""
    if not isinstance(relation, OnTopOf):
        return None
    a, b = so_far.scene.by_name[relation.a.name], so_far.scene.by_name[relation.b.name]
    if a.name in so_far.parents:
        return f"{a.name} already stands on {so_far.parents[a.name]}"
    if place_of(a) == "wall":
        return f"{a.name} hangs at a wall; it does not stand on things"
    if place_of(b) == "ceiling":
        return f"{b.name} hangs from the ceiling and carries nothing"
    chain = [b.name]
    while chain[-1] in so_far.parents:
        chain.append(so_far.parents[chain[-1]])
    if a.name in chain:
        return f"{' stands on '.join(chain[: chain.index(a.name) + 1])}, so {a.name} cannot stand on {b.name}"
    (small, large), (short, long) = sorted(a.size[:2]), sorted(b.size[:2])
    if small > OVERHANG * short and small * large > OVERHANG * short * long:
        return (
            f"{a.name} ({large:.2f} x {small:.2f} m) is too large for the top of {b.name} ({long:.2f} x {short:.2f} m)"
        )
    top = so_far.span(b.name)[1] + a.size[2]
    if top > so_far.scene.room.wall_height + ROUNDING:
        return (
            f"on {b.name}, {a.name} would reach {top:.2f} m, above the ceiling at {so_far.scene.room.wall_height:.2f} m"
        )
    return None


def distance(so_far: Accepted, relation: Relation) -> Answer:
    """Widen a distance that excludes everything possible, and only to the nearest possible one."""
    if not isinstance(relation, DistanceConstraint):
        return None
    asset = so_far.scene.by_name[relation.a.name]
    other = relation.b
    collide = isinstance(other, AssetRef) and so_far.collide(asset.name, other.name)
    least, most = possible.distance_range(so_far.scene, asset, other, collide=collide)
    least, most = math.ceil(least * 100 - ROUNDING) / 100, math.floor(most * 100 + ROUNDING) / 100
    low, high, reasons = relation.min_distance, relation.max_distance, list[str]()
    if high is not None and high < least - ROUNDING:
        reasons.append(f"{_apart(asset.name, other)} are at least {least:.2f} m apart, so max_distance becomes that")
        high = least
    if low is not None and low > most + ROUNDING:
        reasons.append(f"{_apart(asset.name, other)} are at most {most:.2f} m apart here, so min_distance becomes that")
        low = most
    if low is not None and high is not None and low > high:
        return f"no distance between {asset.name} and {other} is possible in this room"
    return Replacement(replace(relation, min_distance=low, max_distance=high), "; ".join(reasons)) if reasons else None


def _apart(name: str, other: AssetRef | WallRef | PointRef) -> str:
    return f"the centres of {name} and {other}" if isinstance(other, AssetRef) else f"the centre of {name} and {other}"


RULES: tuple[Callable[[Accepted, Relation], Answer], ...] = (
    known, not_itself, rug_below, suits, once, one_wall, one_heading, wall_holds, stands, distance,
)  # fmt: skip
"""All rules, in the order in which they are asked."""
