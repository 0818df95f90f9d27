"""What the user's words ask of the cast: who joins what, and the statements that say it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, replace

from robolayout.constraints import AssetRef, Relation
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.any_of import AnyOf
from robolayout.constraints.in_front_of import InFrontOf
from robolayout.constraints.near import Near
from robolayout.constraints.next_to import NextTo
from robolayout.planners._knowledge import ON_ANY, Join, usual_say
from robolayout.planners._roles import Cast, chain
from robolayout.program import Program
from robolayout.scene import Scene
from robolayout.words import Demand


@dataclass(frozen=True)
class Gaps:
    """Metres between what words put together."""

    seated: float = 0.05
    before: float = 0.4
    backs: float = 0.02
    across: float = 1.0
    watching: float = 1.2
    sat_at: float = 0.6
    """Metres between a seat and what it stands at, other things and what they stand before, things back to back, face to face, and
    a seat and the stand of a screen; height from which on one sits at a table."""
    touch: float = 0.6
    close: float = 3.0
    """Metres up to which what stands near a thing stands beside it, and up to which what stands before a thing belongs to it."""


GAPS = Gaps()

LEFT = ("left_of({a}, {b}, {gap}, {most})", "align_with({a}, {b})")
BEHIND = ("behind({a}, {b}, {gap}, {most})", "align_with({a}, {b})")
PARTING = ("left_of({a}, {b}, {gap}, {most})", "align_with({a}, {b}, 90)")
BACK_TO_BACK = ('centered_on({a}, {b}, "side")',)
"""What is said of a thing at the left of another, behind it, at its left to part it from the next one, and back to back with it."""

AROUND = Join("around", (), gap=GAPS.seated, all=("around({items}, {b}, gap={gap})",))  # how seats stand around a thing
IN_THE_LIGHT = -3.0  # weight of the wish of what something hangs above to stand at a window


def asked_lines(scene: Scene, demands: Sequence[Demand], known: set[str]) -> dict[str, str]:
    """Return what the user's words ask of known things as statements, each with its first subject; all ways that are open.

    What a thing on a wall is to hang above stands at a wall, and rather beside its windows, unless words put it elsewhere.
    """
    program, found, under = Program(expressions=scene.expressions), list[Relation](), list[str]()
    placed = {name for demand in demands for name in subjects(demand)}
    for demand in demands:
        if not demand.names() <= known:
            continue
        found += demand.ways[0] if len(demand.ways) == 1 else [AnyOf(demand.ways)]
        if demand.exact is not None:
            found.append(demand.exact)
        pairs = (one.asset_names() for one in demand.ways[0] if one.name == "above")
        hung = (low for high, low in pairs if scene.by_name[high].on_wall and scene.by_name[low].on_floor)
        under += [name for name in hung if name not in placed]
    found += [AgainstWall(AssetRef(name)) for name in under]
    lines = {f"solver.{program.call(relation)}": relation.asset_names()[0] for relation in found}
    aside = f"weight={IN_THE_LIGHT:g}"
    return lines | {f"solver.wish.at_window({scene.expressions[name]}, {aside})": name for name in under}


def join_as_asked(cast: Mapping[str, Cast], demands: Sequence[Demand], passage: float = 0.0) -> dict[str, Cast]:
    """Return the cast with what is asked to stand on, beside or before something joined to it.

    What is asked to stand elsewhere is not joined to what its kind usually joins. What stands between two things keeps a passage
    of so many metres open.
    """
    found = dict(cast)
    wanted = {name: join for demand in demands for name, join in _joins(demand, cast, passage)}
    chains = _chains(cast, demands, passage)
    # what is around a table comes after it
    tops = {anchor for anchor, join in chains.values() if join.slot == "around"}
    wanted = {name: join for name, join in wanted.items() if name not in tops} | chains
    placed = {first for demand in demands for first in subjects(demand)}
    for name in placed - set(wanted):
        item = found[name]
        others = {other for demand in demands if name in subjects(demand) for other in demand.names()}
        hung = any(r.name == "mounted_on" for demand in demands if name in subjects(demand) for r in demand.ways[0])
        if hung or (item.anchor not in others and not _only_on(item)):
            found[name] = item.alone
    seats = (name for name in wanted if cast[name].role.name.endswith("seat"))
    told = {anchor for anchor, join in (wanted[name] for name in seats) if join.slot == "around"}
    for name in found.keys() - set(wanted):
        if found[name].join.slot == "around" and found[name].anchor in told:
            found[name] = found[name].alone  # that table has its own seats
    for a, b in (pair for demand in demands for relation in demand.ways[0] if len(pair := relation.asset_names()) == 2):
        if a in found and b in found:
            _loosen(b, a, found, set(wanted))
    for name, (anchor, join) in wanted.items():
        found[name] = found[name].alone
        if name not in chain(anchor, found):
            found[name] = replace(found[name], anchor=anchor, join=join)
    return found


def _loosen(name: str, root: str, cast: dict[str, Cast], held: Set[str]) -> None:
    """Let what usually stands in a row that ends at `root` stand by itself, where `root` is asked to be placed by `name`."""
    last = next((one for one in chain(name, cast) if cast[one].anchor == root), "")
    if last and cast[last].join.loose and last not in held:
        cast[last] = cast[last].alone


def _only_on(item: Cast) -> bool:
    return item.asset.on_object and not item.asset.on_floor


def subjects(demand: Demand) -> set[str]:
    """Return what is asked to be somewhere; looking at something moves nothing."""
    return {
        name
        for relation in demand.ways[0]
        if relation.name not in ("point_towards", "under", "above")
        for name in relation.asset_names()[: None if relation.name == "in_rows" else 1]
    }


def cornered(demand: Demand) -> set[str]:
    """Return what is asked to be in one corner and no other."""
    only = demand.ways[0] if len(demand.ways) == 1 else ()
    return {relation.asset_names()[0] for relation in only if relation.name == "corner"}


def _joins(demand: Demand, cast: Mapping[str, Cast], passage: float) -> list[tuple[str, tuple[str, Join]]]:
    """Return (name, (anchor, join)) for what a demand puts at another thing."""
    found: list[tuple[str, tuple[str, Join]]] = []
    relations = {relation.name: relation for relation in demand.ways[0]}
    around = "near" in relations and "point_towards" in relations
    for relation in demand.ways[0]:
        names = relation.asset_names()
        if len(names) != 2 or not all(name in cast for name in names):
            continue
        a, b = cast[names[0]], cast[names[1]]
        if relation.name != "on_top_of":
            b = _bearer(b, cast)
        join = _join(relation, a, b, passage, around=around, turned=getattr(relations.get("align_with"), "angle", 0.0))
        if join is not None:
            said = join.say or join.all or (len(demand.ways) == 1 and b.name == names[1])
            found.append((a.name, (b.name, join if said else replace(join, say=usual_say(join.slot)))))
    return found


def _bearer(item: Cast, cast: Mapping[str, Cast]) -> Cast:
    """Return what a thing stands on, down to the floor: who sits before a screen sits before its stand."""
    while item.join.on_top:
        item = cast[item.anchor]
    return item


def _chains(cast: Mapping[str, Cast], demands: Sequence[Demand], passage: float) -> dict[str, tuple[str, Join]]:
    """Return the joins of two things that face each other, and of what is between two of which nothing else is asked together."""
    found: dict[str, tuple[str, Join]] = {}
    between = [demand.exact.asset_names() for demand in demands if demand.exact is not None]
    between = [names for names in between if len(names) == 3 and cast.keys() >= {*names}]
    pairs = [(demand, *one.asset_names()) for demand in demands for one in demand.ways[0] if one.name == "facing_pair"]
    for names in between:
        others = (one for demand in demands for one in demand.ways[0] if demand.names() != frozenset(names))
        placing = (one for one in others if one.name not in ("align_with", "point_towards", "next_to", "near"))
        if not any({*names[1:]} <= {*one.asset_names()} for one in placing):
            found |= _side_by_side([cast[name] for name in names], passage)
    for demand, a, b in pairs:
        held = any(a in subjects(other) for other in demands if other is not demand)
        if not cast.keys() >= {a, b}:
            continue
        top = next((cast[middle] for middle, *ends in between if {*ends} == {a, b}), None)
        if top is not None and top.role.name.endswith("table") and top.asset.size[2] > GAPS.sat_at:
            found |= dict.fromkeys((a, b), (top.name, AROUND))
            continue
        gap = max(GAPS.across, (top.asset.size[0] if top is not None else 0.0) + 2 * GAPS.before)
        found[a] = (b, Join("front", (), gap=gap, loose=held, faces="anchor", say=usual_say("front")))
    return found


def _side_by_side(three: Sequence[Cast], passage: float) -> list[tuple[str, tuple[str, Join]]]:
    """Return how all three stand side by side where one is to stand between two of a kind that it usually stands beside."""
    middle, first, last = three
    if first.anchor == last.name:
        first, last = last, first
    usual = any(join.slot == "beside" and first.role.name in join.of for join in middle.role.joins)
    if middle.role.name == "privacy screen" and first.role is last.role:
        gap = GAPS.before + middle.asset.size[0] / 2
        beside = Join("beside", (), gap=2 * gap, loose=True, say=LEFT)
        along = Join("beside", (), gap=GAPS.before, loose=True, say=PARTING)
        return [(last.name, (first.name, beside)), (middle.name, (first.name, along))]
    if not usual or first.role is not last.role:
        return []
    row, gap = ((middle, first), (last, middle)), max(GAPS.seated, (passage - middle.asset.size[1]) / 2)
    return [(a.name, (b.name, Join("beside", (), gap=gap, loose=True, say=LEFT))) for a, b in row]


def _join(relation: Relation, a: Cast, b: Cast, passage: float, *, around: bool, turned: float) -> Join | None:
    """Return how a thing joins another, None where it is placed by itself."""
    if relation.name == "on_top_of":
        return next((join for join in a.role.joins if join.on_top), ON_ANY)
    if _only_on(a) or (a.asset.on_wall and not a.asset.on_floor):
        return None
    known = next((join for join in a.role.joins if b.role.name in join.of), None)
    if relation.name == "near" and (around or (a.role.name.endswith("seat") and b.role.name.endswith("table"))):
        return known or AROUND
    if relation.name == "near" and known is not None:
        return known
    if (said := _at_its_side(relation, b)) is not None:
        return Join("beside", (), gap=GAPS.seated, loose=True, say=said)
    if isinstance(relation, InFrontOf) and relation.max_gap < GAPS.close:
        if known is not None and known.slot in ("front", "around"):
            return known
        gap = GAPS.watching if b.role.name == "tv" else GAPS.seated if a.role.name == "seat" else GAPS.before
        return Join("front", (), gap=gap, loose=True, faces="anchor")
    if relation.name != "behind":
        return None
    return known if known is not None and known.slot == "behind" else _at_its_back(a, b, passage, turned)


def _at_its_back(a: Cast, b: Cast, passage: float, turned: float) -> Join:
    """Return how a thing joins another that it is asked to be behind: back to back, or with room for who stands between."""
    if turned == 180.0:
        return Join("behind", (), gap=GAPS.backs, loose=True, faces="away", say=BACK_TO_BACK)
    # who takes something from a shelf or cabinet stands between
    gap = passage if {"wall", "grid"} & {*a.role.stands} else GAPS.before
    return Join("behind", (), gap=gap, loose=True, say=BEHIND)


def _at_its_side(relation: Relation, b: Cast) -> tuple[str, ...] | None:
    """Return what is said of a thing that is asked to be close to another, or at a side of it; None where it is not."""
    if isinstance(relation, NextTo) and relation.side in ("left", "right", "beside"):
        return ()
    if relation.name in ("left_of", "right_of"):
        return usual_say("beside")[1:]
    close = isinstance(relation, Near) and relation.max_gap <= GAPS.touch and not b.asset.is_flat
    return usual_say("beside") if close else None
