"""What the user's words ask of the cast: who joins what, and the statements that say it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import replace

from robolayout.constraints import Relation
from robolayout.constraints.above import Above
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.any_of import AnyOf
from robolayout.constraints.in_front_of import InFrontOf
from robolayout.constraints.in_rows import InRows
from robolayout.planners._knowledge import Join
from robolayout.planners._roles import Cast, depends
from robolayout.program import Program
from robolayout.scene import Scene
from robolayout.words import Demand

SEATED, BEFORE, BACKS = 0.05, 0.4, 0.02
"""Metres between a seat and what it stands at, other things and what they stand before, and things back to back."""

CLOSE = 3.0
"""Metres up to which what stands before a thing belongs to it."""


def asked_lines(scene: Scene, demands: Sequence[Demand], known: set[str]) -> dict[str, str]:
    """Return what the user's words ask of known things as statements, each with its first subject; all ways that are open.

    What a thing on a wall is to hang above stands at a wall, unless words put it elsewhere.
    """
    program, found = Program(expressions=scene.expressions), list[Relation]()
    placed = {name for demand in demands for name in subjects(demand)}
    for demand in demands:
        if not demand.names() <= known:
            continue
        found += demand.ways[0] if len(demand.ways) == 1 else [AnyOf(demand.ways)]
        if demand.exact is not None:
            found.append(demand.exact)
        found += [
            AgainstWall(relation.b)
            for relation in demand.ways[0]
            if isinstance(relation, Above) and relation.b.name not in placed
            if scene.by_name[relation.a.name].on_wall and scene.by_name[relation.b.name].on_floor
        ]
    return {f"solver.{program.call(relation)}": relation.asset_names()[0] for relation in found}


def join_as_asked(cast: Mapping[str, Cast], demands: Sequence[Demand]) -> dict[str, Cast]:
    """Return the cast with what is asked to stand on, beside or before something joined to it.

    What is asked to stand elsewhere is not joined to what its kind usually joins.
    """
    found = dict(cast)
    wanted = {name: join for demand in demands for name, join in _joins(demand, cast)}
    placed = {first for demand in demands for first in subjects(demand)}
    for name in placed - set(wanted):
        item = found[name]
        others = {other for demand in demands if name in subjects(demand) for other in demand.names()}
        hung = any(r.name == "mounted_on" for demand in demands if name in subjects(demand) for r in demand.ways[0])
        if item.anchor is not None and item.anchor not in others and (hung or not _only_on(item)):
            found[name] = replace(item, anchor=None, join=None)
    for a, b in (pair for demand in demands for relation in demand.ways[0] if len(pair := relation.asset_names()) == 2):
        if a in found and b in found:
            _loosen(b, a, found, set(wanted))
    for name, (anchor, join) in wanted.items():
        found[name] = replace(found[name], anchor=None, join=None)
        if not depends(anchor, name, found):
            found[name] = replace(found[name], anchor=anchor, join=join)
    return found


def _loosen(name: str, root: str, cast: dict[str, Cast], held: Set[str]) -> None:
    """Let what usually stands in a row that ends at `root` stand by itself, where `root` is asked to be placed by `name`."""
    while name in cast and (anchor := cast[name].anchor) is not None:
        join = cast[name].join
        if anchor == root and join is not None and join.loose and name not in held:
            cast[name] = replace(cast[name], anchor=None, join=None)
        name = anchor


def _only_on(item: Cast) -> bool:
    return item.asset.on_object and not item.asset.on_floor


def subjects(demand: Demand) -> set[str]:
    """Return what is asked to be somewhere; looking at something moves nothing."""
    return {
        name
        for relation in demand.ways[0]
        if relation.name not in ("point_towards", "under", "above")
        for name in (relation.asset_names() if isinstance(relation, InRows) else relation.asset_names()[:1])
    }


def _joins(demand: Demand, cast: Mapping[str, Cast]) -> list[tuple[str, tuple[str, Join]]]:
    """Return (name, (anchor, join)) for what a demand puts at another thing."""
    found: list[tuple[str, tuple[str, Join]]] = []
    relations = {relation.name: relation for relation in demand.ways[0]}
    around = "near" in relations and "point_towards" in relations
    for relation in demand.ways[0]:
        names = relation.asset_names()
        if len(names) != 2 or not all(name in cast for name in names):
            continue
        a, b = names
        join = _join(
            relation, cast[a], cast[b], around=around, turned=getattr(relations.get("align_with"), "angle", 0.0)
        )
        if join is not None:
            found.append((a, (b, join)))
    return found


def _join(relation: Relation, a: Cast, b: Cast, *, around: bool, turned: float) -> Join | None:
    """Return how a thing joins another, None where it is placed by itself."""
    if relation.name == "on_top_of":
        known = next((join for join in a.role.joins if join.slot in ("on", "setting")), None)
        return known or Join("on", ("*",), say=("on_top_of({a}, {b})",))
    if _only_on(a) or (a.asset.on_wall and not a.asset.on_floor):
        return None
    known = next((join for join in a.role.joins if b.role.name in join.of), None)
    if relation.name == "near" and around:
        return known or Join("around", (b.role.name,), gap=SEATED, all=("around({items}, {b}, gap={gap})",))
    if relation.name == "near" and known is not None:
        return known
    if relation.name == "next_to" and getattr(relation, "side", "") in ("left", "right", "beside"):
        return Join("beside", (b.role.name,), gap=SEATED, loose=True)
    if isinstance(relation, InFrontOf) and relation.max_gap < CLOSE:
        if known is not None and known.slot in ("front", "around"):
            return known
        seated = a.role.name == "seat"
        return Join("front", (b.role.name,), gap=SEATED if seated else BEFORE, loose=True, faces="anchor")
    if relation.name == "behind":
        if turned == 180.0:
            straight = ('centered_on({a}, {b}, "side")',)
            return Join("behind", (b.role.name,), gap=BACKS, loose=True, faces="away", say=straight)
        return Join("behind", (b.role.name,), gap=BEFORE, loose=True)
    return None
