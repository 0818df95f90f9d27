"""What the user's words say of single things and groups: who is placed, who stands in rows, rings or the middle, who is looked at."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from robolayout.constraints import AssetRef, PointRef, Relation
from robolayout.constraints.above import Above
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.between import BetweenTwo
from robolayout.constraints.distance_constraint import DistanceConstraint
from robolayout.constraints.in_rows import InRows
from robolayout.constraints.in_shape import InShape, circle_across
from robolayout.constraints.keep_clear import KeepClear
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.constraints.point_towards import PointTowards
from robolayout.constraints.under import Under
from robolayout.planners._knowledge import Role
from robolayout.planners._roles import Cast
from robolayout.planners._room_size import SIZES, rows_ahead
from robolayout.scene import Scene
from robolayout.words import CROWD, Demand

AWAY = 180.0  # degrees by which what has its back to something is turned from it

PLACELESS = ("point_towards", "align_with", "under", "above", "keep_clear")
"""Relations that say nothing of where their thing stands on the floor: looking at something, or as something, moves nothing."""


def said(demands: Iterable[Demand], *, placing: bool = False) -> list[Relation]:
    """Return the statements of the first ways of some demands, all or those that put something on the floor."""
    if not placing:
        return [relation for demand in demands for relation in demand.ways[0]]
    # in one of several parts of the room a thing stands as is usual
    firsts = [one.ways[0] for one in demands if not one.ways[1:] or any(way[0].name != "zone" for way in one.ways)]
    # how something is turned, and how far off a wall it is then, moves nothing, either
    turned = ((way, [one for one in way if one.name == "align_with"]) for way in firsts)
    placed = (way for way, looks in turned if all(len(one.asset_names()) > 1 for one in looks))
    return [relation for way in placed for relation in way if relation.name not in PLACELESS]


def subjects(demands: Iterable[Demand]) -> set[str]:
    """Return what is asked to be somewhere."""
    several = {"in_rows": None, "in_shape": None, "symmetric_pair": 2}
    placing = said(demands, placing=True)
    return {name for one in placing for name in one.asset_names()[: several.get(one.name, 1)]}


def formed(demands: Iterable[Demand]) -> set[str]:
    """Return what is asked to stand in a circle or the like."""
    return {name for one in said(demands) if isinstance(one, InShape) for name in one.asset_names()}


def audience(cast: Mapping[str, Cast], demands: Sequence[Demand]) -> list[str]:
    """Return the crowd of seats of which no more is asked than that they face a thing: they sit in rows before it."""
    turned = [({one.name for one in demand.ways[0]}, demand) for demand in demands]
    looks = {one.asset_names()[0] for names, demand in turned if names == {"point_towards"} for one in demand.ways[0]}
    placed = subjects(demand for names, demand in turned if names not in ({"point_towards"}, {"align_with"}))
    for demand in (demand for names, demand in turned if names == {"align_with"} and len(demand.ways) == 1):
        pairs = [names for one in demand.ways[0] if len(names := one.asset_names()) == 2]
        like, crowd = {to for _, to in pairs}, {name for pair in pairs for name in pair}
        if len(crowd) >= CROWD and len(like) == 1 and like <= looks and not crowd & placed:
            return [name for name in cast if name in crowd]
    return []


def seated_in_rows(cast: Mapping[str, Cast], demands: Iterable[Demand], role: Role) -> dict[str, Cast]:
    """Return the cast with lounge seats that are asked into rows in the role of an audience, if there is something for one to watch."""
    blocks = [one for one in said(demands) if isinstance(one, InRows)]
    rows = [one.asset_names() for one in blocks if one.rows != 1 or len(one.items) >= CROWD]
    shown = any(one.role.name in role.face.roles for one in cast.values())
    seats = {name for row in rows for name in row if shown and cast[name].role.name in ("armchair", "sofa")}
    return {name: replace(one.alone, role=role) if name in seats else one for name, one in cast.items()}


def rowed(demands: Iterable[Demand]) -> set[str]:
    """Return what is asked to stand in rows of which no number is said."""
    return {name for one in said(demands) if isinstance(one, InRows) and one.rows is None for name in one.asset_names()}


def in_blocks(demands: Iterable[Demand]) -> list[tuple[str, ...]]:
    """Return what is asked to stand in so many rows, block by block."""
    found = (one.asset_names() for one in said(demands) if isinstance(one, InRows) and one.rows is not None)
    return [*dict.fromkeys(found)]


def too_shallow(scene: Scene, demands: Iterable[Demand]) -> list[int]:
    """Return the walls before which not as many rows fit as are asked: there hangs no board at which all look."""
    x0, y0, x1, y1 = scene.room.bounds
    for block in (one for one in said(demands) if isinstance(one, InRows) and (one.rows or 0) > 1):
        names = block.asset_names()
        if len(names) < CROWD:
            continue
        ahead = rows_ahead(block.rows or 1, scene.by_name[names[0]].size[0]) - SIZES.around  # the last may be at a wall
        deep = {
            wall.index: (y1 - y0) if abs(wall.normal[1]) > abs(wall.normal[0]) else (x1 - x0)
            for wall in scene.room.walls
        }
        return [index for index, depth in deep.items() if depth < ahead]
    return []


def looked_at(demands: Iterable[Demand]) -> dict[str, str]:
    """Return what is asked to look at another thing, with that; what has its back to it does not."""
    pairs = (one.asset_names() for one in said(demands) if isinstance(one, PointTowards) and one.angle != AWAY)
    return {pair[0]: pair[1] for pair in pairs if len(pair) == 2}


def watching(cast: Mapping[str, Cast], demands: Sequence[Demand]) -> dict[str, str]:
    """Return the seats in rows of which one looks at a thing on the floor, with that thing."""
    looks, crowd = looked_at(demands), audience(cast, demands)
    blocks = [one.asset_names() for one in said(demands) if isinstance(one, InRows)] + [crowd] * bool(crowd)
    seen = [(block, [looks[name] for name in block if name in looks]) for block in blocks]
    sat_on = ((block, to[0]) for block, to in seen if to and cast[block[0]].role.name.endswith("seat"))
    return {name: to for block, to in sat_on if cast[to].asset.on_floor for name in block}


def lain_at(demands: Iterable[Demand]) -> dict[str, str]:
    """Return what is only asked to be before, beside or near one other thing, with that: a rug there lies below what belongs to it."""
    at = dict[str, set[tuple[str, ...]]]()
    for one in said(demands, placing=True):
        to = one.asset_names()[1:] if one.name in ("in_front_of", "next_to", "near") else ()
        for name in one.asset_names()[:1]:
            at.setdefault(name, set()).add(to)
    return {name: others[0] for name, (others, *more) in at.items() if others and not more}


def ringed(cast: Mapping[str, Cast], demands: Sequence[Demand]) -> dict[str, tuple[str, InShape]]:
    """Return seats of one kind of which no more is asked than to stand on a rug that holds a ring of them, with rug and ring.

    They stand at nothing but the rug; seats of a table stand there, if that is not the one of a sofa beside the rug.
    """
    placed, on = subjects(one for one in demands if not isinstance(one.ways[0][0], Under)), dict[str, list[str]]()
    for one in said(demands):
        if isinstance(one, Under):
            on.setdefault(one.a.name, []).extend(item.name for item in one.items)
    found = dict[str, tuple[str, InShape]]()
    for rug, names in on.items():
        free = [n for n in names if cast[n].role.in_a_ring and n not in placed]
        at, others = {n: cast[n].anchor for n in free}, {*names}.difference(free)
        free = [n for n in free if at[n] not in others and (cast[n].join.slot != "around" or cast[at[n]].anchor)]
        for kind in dict.fromkeys(cast[name].asset.category for name in free):
            ring = [name for name in free if cast[name].asset.category == kind]
            depth, width, _ = cast[ring[0]].asset.size
            if len(ring) > 2 and circle_across(len(ring), depth, width) <= min(cast[rug].asset.size[:2]):
                found |= {name: (rug, InShape(tuple(map(AssetRef, ring)), "circle")) for name in ring}
    return found


def in_the_middle(demands: Iterable[Demand]) -> set[str]:
    """Return the only thing that is asked into the middle of the room, which is rather right there than only near it."""
    found = amidst_the_room(demands)
    return found if len(found) == 1 else set()


def amidst_the_room(demands: Iterable[Demand]) -> set[str]:
    """Return what is asked to be near the middle of the room."""
    within = (one for one in said(demands) if isinstance(one, DistanceConstraint) and one.min_distance is None)
    return {one.a.name for one in within if isinstance(one.b, PointRef)}


def open_beside(demands: Iterable[Demand]) -> dict[str, str]:
    """Return what is asked to keep its left or its right clear, with the other side: what goes beside it stands there."""
    clear = [one for one in said(demands) if isinstance(one, KeepClear) and one.side in ("left", "right")]
    return {one.a.name: "left" if one.side == "right" else "right" for one in clear}


def hung(demands: Iterable[Demand]) -> list[tuple[str, str]]:
    """Return each thing that is asked to hang above another one, with that."""
    return [(one.a.name, one.b.name) for one in said(demands) if isinstance(one, Above)]


def hung_over(scene: Scene, demands: Iterable[Demand]) -> dict[str, str]:
    """Return what stands on the floor below what is asked to hang above it, or above what it bears, on a wall, with the first of that."""
    found = dict[str, str]()
    on = (one.asset_names() for one in said(demands) if isinstance(one, OnTopOf))
    bearers = {thing: bearer for thing, bearer in on}
    for high, over in hung(demands):
        low = bearers.get(over, over)
        if scene.by_name[high].on_wall and scene.by_name[low].on_floor:
            found.setdefault(low, high)
    return found


def held_by_walls(demands: Sequence[Demand]) -> set[str]:
    """Return what is asked into corners, parts of the room or near doors and windows alone, which leaves its wall to it.

    What something is to be behind stands free of the wall, and what is to stand askew.
    """
    asked = [(one.name, *one.asset_names()) for one in said(demands, placing=True)]
    free = {name for how, name, *others in asked if how not in ("corner", "zone", "near") or others}
    free |= {others[0] for how, _, *others in asked if how == "behind"}
    free |= {one.a.name for one in said(demands) if isinstance(one, AlignWith) and one.angle % 90.0}
    return {name for _, name, *_ in asked} - free


def needing_room(cast: Mapping[str, Cast], demands: Sequence[Demand]) -> set[str]:
    """Return what is placed first: what is asked into one corner and no other, in one row or a circle, or with two others at its sides."""
    only = said(demand for demand in demands if len(demand.ways) == 1)
    between = [demand.exact.asset_names() for demand in demands if isinstance(demand.exact, BetweenTwo)]
    found = {middle for middle, *ends in between if {cast[end].anchor for end in ends} == {middle}}
    for one in only:
        names = {*one.asset_names()}
        alone = all(demand.names() <= names for demand in demands if names & demand.names())
        if one.name == "corner":
            found.add(one.asset_names()[0])
        elif isinstance(one, InShape) or (isinstance(one, InRows) and one.rows == 1 and alone):
            found |= names
    return found
