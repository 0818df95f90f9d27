"""What the user's words ask of the cast: who joins what, and the statements that say it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace

from robolayout.constraints import AssetRef, PointRef, Relation
from robolayout.constraints._sides import SideRelation
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.any_of import AnyOf
from robolayout.constraints.between import BetweenTwo
from robolayout.constraints.distance_constraint import DistanceConstraint
from robolayout.constraints.in_front_of import InFrontOf
from robolayout.constraints.near import Near
from robolayout.constraints.next_to import NextTo
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.constraints.under import Under
from robolayout.planners._knowledge import ON_ANY, Join, usual_say
from robolayout.planners._roles import Cast, chain, elsewhere
from robolayout.planners._said import (
    amidst_the_room,
    audience,
    hung,
    hung_over,
    looked_at,
    ringed,
    said,
    subjects,
)
from robolayout.program import HEAVIEST, Program
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
    elbows: float = 0.12  # metres between those who sit side by side
    touch: float = 0.6
    close: float = 3.0
    thin: float = 0.15
    """Metres up to which what stands near a thing stands beside it, up to which what stands before a thing belongs to it, and up to
    which what stands between two things parts them."""


GAPS = Gaps()

LEFT = ("left_of({a}, {b}, {gap}, {most})", "align_with({a}, {b})")
BEHIND = ("behind({a}, {b}, {gap}, {most})", "align_with({a}, {b})")
PARTING = ("left_of({a}, {b}, {gap}, {most})", "align_with({a}, {b}, 90)")
"""What is said of a thing at the left of another, behind it, and at its left to part it from the next one."""

PILED = replace(ON_ANY, say=(*ON_ANY.say, "centered_on({a}, {b})", "align_with({a}, {b})"))  # straight on each other
BELOW = Join("under", ())  # how a thing stands below another
AROUND = Join("around", (), gap=GAPS.seated, all=("around({items}, {b}, gap={gap})",))  # how seats stand around a thing
# a bench, with chairs at the other sides
AT_ONE_SIDE = Join("front", (), gap=GAPS.seated, faces="anchor", say=usual_say("front"))
FIRESIDE = ("in_front_of({a}, {b}, 0.3, 0.9)", "align_with({a}, {b}, 90)")
# how one of two that face each other stands before a fire
BEFORE_A_FIRE = Join("front", (), gap=0.6, loose=True, say=FIRESIDE)
IN_THE_LIGHT = -3.0  # weight of the wish of what something hangs above to stand at a window


def asked_lines(scene: Scene, demands: Sequence[Demand], known: set[str]) -> dict[str, str]:
    """Return what the user's words ask of known things as statements, each with its first subject; all ways that are open.

    What a thing on a wall is to hang above stands at a wall, and rather beside its windows, with what it is at, unless words put it
    elsewhere.
    """
    program, found = Program(expressions=scene.expressions), list[Relation]()
    placed, of_known = subjects(demands), [demand for demand in demands if demand.names() <= known]
    for demand in of_known:
        found += demand.ways[0] if len(demand.ways) == 1 else [AnyOf(demand.ways)]
        found += [demand.exact] if isinstance(demand.exact, BetweenTwo) else []
    under = hung_over(scene, of_known)
    found += [AgainstWall(AssetRef(name)) for name in under if name not in placed]
    lines = {f"solver.{program.call(relation)}": relation.asset_names()[0] for relation in found}
    sides = [one.asset_names() for one in said(of_known) if isinstance(one, SideRelation | Near | NextTo)]
    beside = [*under, *(two[1] for two in sides if len(two) == 2 and two[0] in under)]
    # several that hang in a row need more wall without a window
    many = Counter(low for _, low in hung(of_known))
    dislike = {name: max(IN_THE_LIGHT * max(many[name], 1) ** 2, -HEAVIEST) for name in beside}
    aside = {name: f"weight={weight:g}" for name, weight in dislike.items()}
    return lines | {f"solver.wish.at_window({scene.expressions[name]}, {aside[name]})": name for name in beside}


def join_as_asked(cast: Mapping[str, Cast], demands: Sequence[Demand], passage: float = 0.0) -> dict[str, Cast]:
    """Return the cast with what is asked to stand on, beside or before something joined to it.

    What is asked to stand elsewhere is not joined to what its kind usually joins. What stands between two things keeps a passage
    of so many metres open.
    """
    found = dict(cast)
    chains = dict(_chains(cast, demands, passage))
    # what is around a table, or at both sides of a thing, comes after it
    tops = {anchor for anchor, join in chains.values() if join.slot in ("around", "beside")} - chains.keys()
    told = {demand.names(): demand.gap.low for demand in demands if demand.gap is not None}
    joins = {
        name: (anchor, replace(join, gap=told.get(frozenset((name, anchor)), join.gap)))  # "1.8 m to the right of it"
        for demand in demands
        for name, (anchor, join) in _joins(demand, cast, passage)
    }
    # two that face each other by the fireplace do not stand beside it with their backs in line
    faced = {one.asset_names()[1] for one in said(demands) if one.name == "facing_pair"}
    beside = {name for name in faced & joins.keys() if joins[name][1].slot == "beside"}
    wanted = {name: join for name, join in joins.items() if name not in tops | beside} | chains
    rings = dict(_in_rings(cast, wanted, demands, passage))
    wanted |= dict(_at_right_angles(cast, wanted, demands)) | rings
    found |= {low: found[low].alone for low, _ in rings.values()}  # in their middle
    placed, central = subjects(demands), amidst_the_room(demands)
    found |= dict(_changed_seats(found, sorted(faced - wanted.keys()), placed | faced | wanted.keys()))
    for name in placed - wanted.keys():
        about = [demand for demand in demands if name in subjects([demand])]
        asset, anchor = found[name].asset, found[name].anchor
        stays = (asset.on_object and not asset.on_floor) or any(anchor in demand.names() for demand in about)
        # what others gather around takes what it belongs to into the middle of the room with it
        leads = anchor not in placed - central and any(one.anchor == name for one in found.values())
        metres = [one for one in said(about) if isinstance(one, DistanceConstraint)]
        near = any(one.max_distance is not None and not (leads and isinstance(one.b, PointRef)) for one in metres)
        stays |= (len(metres) == len(said(about)) and not near) or {name, anchor} <= central  # a table and its chairs
        if not stays or any(relation.name == "mounted_on" for relation in said(about)):
            found[name] = found[name].alone
    wanted |= dict(_only_benches(cast, wanted))
    seated = [wanted[name] for name in wanted if cast[name].role.name.endswith("seat")]
    laid = {(anchor, join.slot) for anchor, join in seated if join.slot in ("around", "front")}
    crowd = audience(cast, demands)
    single = {
        name: to for name, to in looked_at(demands).items() if name not in wanted and name not in placed.union(crowd)
    }
    wanted |= dict(_before_what_they_face(found, single))
    for last in _at_ends_of_rows(found, demands):
        found[last] = found[last] if last in wanted else found[last].alone
    over = (found[high] for high, _ in hung(demands))  # a projector over the table, a television over a minibar
    found |= {one.name: one.alone for one in over if one.asset.on_ceiling or one.asset.on_wall}
    for name, (anchor, join) in wanted.items():
        found[name] = found[name].alone
        if name not in chain(anchor, found):
            found[name] = replace(found[name], anchor=anchor, join=join)
    for name in [name for name in found if name not in wanted]:
        if (found[name].anchor, found[name].join.slot) in laid and found[name].role.name.endswith("seat"):
            found[name] = elsewhere(name, found, {anchor for anchor, _ in laid})  # that table has its own seats
    apart = (*ringed(found, demands), *crowd, *_past_an_end(found, chains, wanted))
    found |= {name: found[name].alone for name in apart}
    found |= dict(_off_piles(found, wanted, demands))
    found |= {name: one for name, one in _at_their_places(found, demands) if name not in wanted}
    return found | dict(_off_the_wall(found, demands))


def _past_an_end(
    cast: Mapping[str, Cast], chains: Mapping[str, tuple[str, Join]], wanted: Collection[str]
) -> Iterator[str]:
    """Yield what usually stands beside one of three that stand in line: a worktop beyond the fridge, for which no wall is long enough."""
    lined = {one for name, (to, join) in chains.items() if join.slot == "beside" for one in (name, to)}
    for one in (one for one in cast.values() if one.name not in wanted):
        if one.anchor in lined and one.join.slot == "beside" and one.join.loose:
            yield one.name


def _only_benches(
    cast: Mapping[str, Cast], wanted: Mapping[str, tuple[str, Join]]
) -> Iterator[tuple[str, tuple[str, Join]]]:
    """Yield how the only bench of a table stands at one side of it, with chairs at the others."""
    benches = {
        name: to for name, (to, join) in wanted.items() if join == AROUND and cast[name].category.name == "bench"
    }
    tables = Counter(benches.values())
    yield from ((name, (to, AT_ONE_SIDE)) for name, to in benches.items() if tables[to] == 1)


def _at_ends_of_rows(cast: Mapping[str, Cast], demands: Sequence[Demand]) -> Iterator[str]:
    """Yield what usually stands in a row that ends at what is asked to be placed by one of the row."""
    for a, b in (pair for relation in said(demands, placing=True) if len(pair := relation.asset_names()) == 2):
        last = next((one for one in chain(b, cast) if cast[one].anchor == a), "")
        yield from [last] * bool(last and cast[last].join.loose)


def _changed_seats(cast: Mapping[str, Cast], faced: Iterable[str], placed: Set[str]) -> Iterator[tuple[str, Cast]]:
    """Yield seats that another one faces, by themselves, and what takes their place before a piano: a seat of which nothing is said."""
    for seat in (cast[name] for name in faced if cast[name].anchor and cast[name].role.name == "seat"):
        yield seat.name, seat.alone
        spare = (one for one in cast.values() if one.role is seat.role and not one.anchor and one.name not in placed)
        yield from ((one.name, replace(one, anchor=seat.anchor, join=seat.join)) for one in list(spare)[:1])


def _off_piles(
    cast: Mapping[str, Cast], wanted: Collection[str], demands: Sequence[Demand]
) -> Iterator[tuple[str, Cast]]:
    """Yield what usually stands on things of a pile on which the next of it stands: elsewhere, or on its top."""
    tops = (one.asset_names() for one in said(demands) if isinstance(one, OnTopOf))
    piled = {b: a for a, b in tops if cast[a].category is cast[b].category}
    for name in [name for name in cast if name not in wanted and cast[name].anchor in piled]:
        moved, top = elsewhere(name, cast, piled.keys()), cast[name].anchor
        while top in piled:
            top = piled[top]
        yield name, moved if moved.anchor or moved.asset.on_floor else replace(cast[name], anchor=top)


def _before_what_they_face(
    cast: Mapping[str, Cast], faced: Mapping[str, str]
) -> Iterator[tuple[str, tuple[str, Join]]]:
    """Yield how single seats join what they face, by their names, if that stands by itself: a stool its easel, not the table."""
    for name, to in faced.items():
        seat, thing = cast[name], cast[to]
        free = thing.asset.on_floor and not thing.anchor
        if free and seat.role.name == "seat" and seat.anchor != to:
            yield name, (to, replace(_before(seat, thing, GAPS.before), say=usual_say("front")))


def _at_their_places(cast: Mapping[str, Cast], demands: Sequence[Demand]) -> Iterator[tuple[str, Cast]]:
    """Yield what stands on a top and is asked to be before or near what stands on one, or sits at one: it is on the same."""
    for a, b in (one.asset_names() for one in said(demands, placing=True) if len(one.asset_names()) == 2):
        top = cast[b].anchor
        at_one = top and cast[top].role.top and (cast[b].join.on_top or cast[b].role.name.endswith("seat"))
        if at_one and cast[a].join.on_top and cast[a].asset.on_object:
            yield a, replace(cast[a], anchor=top)


def _in_rings(
    cast: Mapping[str, Cast], wanted: Mapping[str, tuple[str, Join]], demands: Sequence[Demand], passage: float
) -> Iterator[tuple[str, tuple[str, Join]]]:
    """Yield how more armchairs than two that are asked around a coffee table without a sofa stand around it, with a way in."""
    looks, around = looked_at(demands), dict[str, list[str]]()
    for name, (low, join) in wanted.items():
        if join.slot in ("flank", "around") and looks.get(name) == low:
            around.setdefault(low, []).append(name)
    for low, seats in around.items():
        if len(seats) > 2 - (len(around) > 1) and {cast[name].role.name for name in seats} == {"armchair"}:
            yield from ((name, (low, replace(AROUND, gap=passage))) for name in seats)


def _at_right_angles(
    cast: Mapping[str, Cast], wanted: Mapping[str, tuple[str, Join]], demands: Sequence[Demand]
) -> Iterator[tuple[str, tuple[str, Join]]]:
    """Yield how what stands at a right angle to another one joins the table that both are around, at an end of it; or a sofa's."""
    placed = subjects(other for other in demands if not any(isinstance(one, AlignWith) for one in other.ways[0]))
    for relation in said(demands):
        if isinstance(relation, AlignWith) and relation.angle in (90.0, 270.0) and len(relation.asset_names()) == 2:
            (a, b), nowhere = relation.asset_names(), ("", None)
            table, join = wanted.get(a, nowhere)
            tables = (one for one in cast.values() if one.role.name == "coffee table")
            low = [one for one in tables if wanted.get(one.name, (one.anchor,))[0] in (a, b)]
            if join is not None and join.slot == "around" and wanted.get(b, nowhere)[0] == table:
                yield a, (table, _seated("right_of", GAPS.before / 2, GAPS.before, 90.0))
            elif low and join is None and a not in placed:
                yield from ((low[0].name, (b, known)) for known in low[0].role.joins if cast[b].role.name in known.of)
                yield a, (low[0].name, Join("flank", (), gap=GAPS.before, loose=True, say=usual_say("flank")))


def _off_the_wall(cast: Mapping[str, Cast], demands: Sequence[Demand]) -> Iterator[tuple[str, Cast]]:
    """Yield the seats of tables that stand against walls: at both ends and before them, in corners at one end."""
    walled = {(one.name, one.asset_names()[0]) for one in said(demands) if one.name in ("against_wall", "corner")}
    for at, table in sorted(walled):  # of a table that is asked for both, the corner is what counts
        seats = [name for name, one in cast.items() if one.anchor == table and one.join.slot == "around"]
        ends = (2 if at == "against_wall" else 1) * (len(seats) > 1)
        wide = sum(cast[name].asset.size[1] + GAPS.elbows for name in seats[ends:]) - GAPS.elbows
        if wide > cast[table].asset.size[1]:
            continue
        for number, name in enumerate(seats):
            side, angle = (("left_of", 270), ("right_of", 90))[number] if number < ends else ("in_front_of", 180)
            yield name, replace(cast[name], join=_seated(side, -GAPS.touch, GAPS.touch, angle))


def _beside(gap: float, say: tuple[str, ...]) -> Join:
    return Join("beside", (), gap=gap, loose=True, say=say)


def _joins(demand: Demand, cast: Mapping[str, Cast], passage: float) -> Iterator[tuple[str, tuple[str, Join]]]:
    """Yield (name, (anchor, join)) for what a demand puts at another thing."""
    for relation in demand.ways[0] if demand.gap is None else ():
        names = relation.asset_names()
        if len(names) != 2:
            continue
        a, b = (cast[name] for name in names)
        while b.join.on_top and not isinstance(relation, OnTopOf):
            b = cast[b.anchor]  # who sits before a screen sits before its stand
        asked = {one.name: one for one in demand.ways[0] if one.asset_names()[:1] == names[:1]}
        beneath = isinstance(relation, Under) and not a.asset.is_flat
        join = BELOW if beneath else _at_one_side(relation, asked) or _join(relation, a, b, asked, passage)
        if join is not None:
            told = join.say or join.all or (len(demand.ways) == 1 and b.name == names[1])
            yield a.name, (b.name, join if told else replace(join, say=usual_say(join.slot)))


def _chains(
    cast: Mapping[str, Cast], demands: Sequence[Demand], passage: float
) -> Iterator[tuple[str, tuple[str, Join]]]:
    """Yield the joins of two things that face each other, and of what is between two of which nothing else is asked together."""
    between = [demand.exact.asset_names() for demand in demands if isinstance(demand.exact, BetweenTwo)]
    between = [names for names in between if len(names) == 3]
    for names in between:
        others = [*said(demand for demand in demands if demand.names() != frozenset(names))]
        if any(one.name == "in_rows" and {*names[1:]} & {*one.asset_names()} for one in others):
            continue  # "a printer between the two groups of desks"
        together = (demand.ways[0] for demand in demands if {*names[1:]} <= demand.names())
        if any(sum(one.name == "against_wall" for one in way) > 1 for way in together):
            continue  # "beds on opposite walls and a dresser between them"
        placing = (one for one in others if one.name not in ("align_with", "point_towards", "next_to", "near"))
        if not any({*names[1:]} <= {*one.asset_names()} for one in placing):
            yield from _side_by_side([cast[name] for name in names], passage)
    pairs = [(demand, *one.asset_names()) for demand in demands for one in demand.ways[0] if one.name == "facing_pair"]
    distances = [one for one in said(demands) if isinstance(one, DistanceConstraint)]
    symmetric = [one.asset_names() for one in said(demands) if one.name == "symmetric_pair"]
    for demand, a, b in pairs:
        top = next((cast[middle] for middle, *ends in between if {*ends} == {a, b}), _before_both(cast, a, b))
        if top is not None and top.role.name.endswith("table") and top.asset.size[2] > GAPS.sat_at:
            yield from ((name, (top.name, AROUND)) for name in (a, b))
            continue
        held = a in subjects(other for other in demands if other is not demand)
        apart = [one.min_distance or 0.0 for one in distances if {*one.asset_names()} == {a, b}]
        between_edges = max(apart, default=0.0) - (cast[a].asset.size[0] + cast[b].asset.size[0]) / 2
        gaps = [demand.gap.low for demand in demands if demand.gap is not None and demand.names() == frozenset((a, b))]
        told = max(between_edges, *gaps) + GAPS.seated if gaps else between_edges + GAPS.seated
        gap = max(GAPS.across, (top.asset.size[0] if top is not None else 0.0) + 2 * GAPS.before, told)
        fires = [to for one, other, to in symmetric if {one, other} == {a, b}]
        yield a, (b, Join("front", (), gap=gap, loose=held and not fires, faces="anchor", say=usual_say("front")[:1]))
        yield from ((b, (to, BEFORE_A_FIRE)) for to in fires)
        if top is not None and top.join.slot == "beside":  # a side table, here between the two
            half = (gap - top.asset.size[0]) / 2
            say = f"in_front_of({{a}}, {{b}}, {half - GAPS.seated:.2f}, {half + GAPS.seated:.2f})"
            there = Join("front", (), gap=half, loose=True, faces="anchor", say=(say, *usual_say("front")[1:]))
            yield top.name, (b, there)


def _before_both(cast: Mapping[str, Cast], a: str, b: str) -> Cast | None:
    """Return the coffee table that stands before one of two things, and so between them where they face each other."""
    before = (one for one in cast.values() if one.anchor in (a, b) and one.join.slot == "front")
    return next((one for one in before if one.role.name == "coffee table"), None)


def _side_by_side(three: Sequence[Cast], passage: float) -> Iterator[tuple[str, tuple[str, Join]]]:
    """Yield how all three stand side by side where one is to stand between two of a kind that it usually stands beside.

    So do three that have their backs to walls (a bed between two bookshelves), unless the outer ones usually stand at the middle one.
    """
    middle, first, last = three
    if first.anchor == last.name:
        first, last = last, first
    usual = middle.role.stands_beside(first.role.name)
    if not first.role.stands_beside(middle.role.name) and middle.asset.size[0] > GAPS.thin:
        usual = usual or all(one.asset.on_floor and one.role.stands[0] == "wall" for one in three)
    parting = {"privacy screen": GAPS.before, "partition": GAPS.seated}.get(middle.role.name)
    if first.role is last.role and parting is not None:
        yield last.name, (first.name, _beside(2 * parting + middle.asset.size[0], LEFT))
        yield middle.name, (first.name, _beside(parting, PARTING))
    elif first.role is last.role and usual:
        gap = max(GAPS.seated, (passage - middle.asset.size[1]) / 2)
        if middle.role.stands_beside(first.role.name):
            yield from ((a.name, (b.name, _beside(gap, LEFT))) for a, b in ((middle, first), (last, middle)))
        else:
            yield from ((one.name, (middle.name, _beside(gap, usual_say("beside")))) for one in (first, last))
    elif usual and all(one.asset.on_floor and one.role.stands[:1] == ("wall",) for one in (first, last)):
        # "the stove between the sink and the fridge"
        yield from ((a.name, (b.name, _beside(GAPS.seated, LEFT))) for a, b in ((middle, first), (last, middle)))


def _join(relation: Relation, a: Cast, b: Cast, asked: Mapping[str, Relation], passage: float) -> Join | None:
    """Return how a thing joins another of which so much is asked together, None where it is placed by itself."""
    if isinstance(relation, OnTopOf):
        own = next((join for join in a.role.joins if join.on_top), ON_ANY)
        own = own if relation.name == "on_top_of" else replace(own, say=(f"{relation.name}({{a}}, {{b}})",))
        return PILED if a.category is b.category else own
    if not a.asset.on_floor and (a.asset.on_object or a.asset.on_wall):
        return None
    known = next((join for join in a.role.joins if b.role.name in join.of), None)
    around = "point_towards" in asked or (a.role.name.endswith("seat") and b.role.name.endswith("table"))
    if relation.name == "near" and (known is not None or around):
        free = b.role.name.endswith("table") or "middle" in b.role.stands  # else a fireplace
        if free and (known is None or (known.slot == "front" and "point_towards" in asked)):  # not only before a piano
            return AROUND
        return known
    match relation:
        case NextTo(side="left" | "right" | "beside"):
            return _beside(GAPS.seated, ())
        case Relation(name="left_of" | "right_of"):
            return _beside(GAPS.seated, usual_say("beside")[1:])
        case Near(max_gap=gap) if gap <= GAPS.touch and not b.asset.is_flat:
            return _beside(GAPS.seated, usual_say("beside"))
        case InFrontOf(max_gap=most) if most < GAPS.close:
            gap = GAPS.watching if b.role.name == "tv" else GAPS.seated if a.role.name == "seat" else GAPS.before
            usual = known if known is not None and known.slot in ("front", "around") else None
            return usual or _before(a, b, gap)
        case Relation(name="behind"):
            usual = known is not None and known.slot == "behind"
            return known if usual else _at_its_back(a, passage, getattr(asked.get("align_with"), "angle", 0.0))
        case _:
            return None


def _before(a: Cast, b: Cast, gap: float) -> Join:
    """Return how a thing joins another that it is asked to be in front of: looking at it; sofas and what opens look away from a bed."""
    opens = a.category.open_depth > 0 and a.role.name != "tv"
    if (opens or a.role.name == "sofa") and b.role.name.endswith("bed"):
        return Join("front", (), gap=gap, loose=True, faces="same", say=usual_say("front")[1:])
    return Join("front", (), gap=gap, loose=True, faces="anchor")


def _at_one_side(relation: Relation, asked: Mapping[str, Relation]) -> Join | None:
    """Return how seats join a table that are all at one side of it, under it and turned to it; None for others at a side."""
    turned = asked.get("align_with")
    if not isinstance(relation, SideRelation) or relation.min_gap >= 0.0 or not isinstance(turned, AlignWith):
        return None
    return _seated(relation.name, relation.min_gap, relation.max_gap, turned.angle)


def _seated(side: str, least: float, most: float, angle: float) -> Join:
    """Return how a seat joins a table at one side of it, as a relation names that, turned by so many degrees."""
    at = {"in_front_of": "front", "behind": "behind"}.get(side, "flank")
    say = (f"{side}({{a}}, {{b}}, {least:g}, {most:g})", f"align_with({{a}}, {{b}}, {angle:g})")
    return Join(at, (), gap=GAPS.seated, faces="anchor", say=say)


def _at_its_back(a: Cast, passage: float, turned: float) -> Join:
    """Return how a thing joins another that it is asked to be behind: back to back, or with room for who stands between."""
    if turned == 180.0:
        return Join("behind", (), gap=GAPS.backs, loose=True, faces="away", say=('centered_on({a}, {b}, "side")',))
    # who takes something from a shelf or cabinet stands between
    gap = passage if {"wall", "grid"} & {*a.role.stands} else GAPS.before
    return Join("behind", (), gap=gap, loose=True, say=BEHIND)
