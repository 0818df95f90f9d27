"""What a program says of each thing, gathered for who places it: how it stands, at what, what it looks at, what it would like.

Everything is read from statements and wishes, whoever wrote them; nothing here knows kinds of rooms.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TypeVar

from robolayout.assets import Category, category_of, sweeps_of
from robolayout.assets.beneath import places_beneath
from robolayout.assets.obstacles import use_sides
from robolayout.constraints import AssetRef, PointRef, Relation
from robolayout.constraints.above import Above
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.any_of import AnyOf
from robolayout.constraints.around import Around
from robolayout.constraints.at_window import AtWindow
from robolayout.constraints.behind import Behind
from robolayout.constraints.ceiling_above import CeilingAbove
from robolayout.constraints.centered_on import CenteredOn
from robolayout.constraints.corner import Corner
from robolayout.constraints.distance_constraint import DistanceConstraint
from robolayout.constraints.grouped import Grouped
from robolayout.constraints.in_front_of import InFrontOf
from robolayout.constraints.in_rows import InRows
from robolayout.constraints.in_shape import InShape
from robolayout.constraints.keep_clear import KeepClear
from robolayout.constraints.left_of import LeftOf
from robolayout.constraints.mounted_on import MountedOn
from robolayout.constraints.near import Near
from robolayout.constraints.next_to import NextTo
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.constraints.point_towards import PointTowards
from robolayout.constraints.right_of import RightOf
from robolayout.constraints.symmetric_pair import SymmetricPair
from robolayout.constraints.toward import Toward
from robolayout.constraints.under import Under
from robolayout.program import Program, Statement
from robolayout.scene import Asset, Scene
from robolayout.solve.build.joining import AIM, BELOW, DEMANDED, Facing, Joining

CLOSE = 3.0
"""Metres up to which what stands before, behind or beside a thing stands at it."""

LOWEST, HIGHEST, SMALLEST = 0.25, 1.3, 0.01
"""Metres between which tops carry what nothing is said of, and square metres below which they all count as equally small."""

LEADS = 0.6
"""Weight of a wish for a corner from which on corners are tried beside the rest of the walls; and of a wall for what has a front."""

ORDER = ("corner", "wall", "facing", "middle", "hang")
"""Ways of standing in the order in which they are tried where nothing tells them apart."""

Kind = TypeVar("Kind", bound=Relation)

Beside = NextTo | LeftOf | RightOf | InFrontOf | Behind
"""Relations that put a thing at a side of another."""

SIDES = {"left_of": "left", "right_of": "right", "in_front_of": "front", "behind": "back"}
"""The side that a relation names."""


@dataclass(frozen=True)
class Want:
    """One thing and all that is said of it."""

    asset: Asset  # the thing
    category: Category  # what the catalogue knows about it
    turn: int  # when it is placed; low first
    kind: str = ""  # what things of which the same is said have in common
    # ways of standing by itself, best first, with what each costs
    stands: Mapping[str, float] = field(default_factory=dict[str, float])
    # weights of wishes about its place, by relation
    weights: Mapping[str, float] = field(default_factory=dict[str, float])
    walls: Mapping[int, float] = field(default_factory=dict[int, float])  # weights of walls that are wished by name
    numbered: tuple[tuple[Corner | AtWindow, float], ...] = ()  # wishes for one corner or window, with weights
    # what it should be near, any of them, with a weight; below 0 far from
    near: tuple[tuple[tuple[str, ...], float], ...] = ()
    # what it is wished to be straight to without standing at it, with weights
    straight: tuple[tuple[str, float], ...] = ()
    points: tuple[tuple[PointRef, float], ...] = ()  # where it is wished to look, with weights
    # metres kept free on some sides; none: as its kind is used
    clear: Mapping[str, float] = field(default_factory=dict[str, float])
    face: Facing | None = None  # what it has in front of it
    at: tuple[str, ...] = ()  # what it is demanded to be near, or at a side of
    over: tuple[str, ...] = ()  # what it hangs over or lies under, best first
    height: float = 0.0  # height in metres of the centre of a hung thing; 0 lets size decide
    anchor: str | None = None  # the thing that it stands at
    join: Joining | None = None  # how it stands there
    loose: bool = False  # whether it may stand by itself if there is no room there
    rows: InRows | None = None  # what it should stand in a block with, if anything
    shape: InShape | None = None  # with what it should stand in a circle or the like

    @property
    def name(self) -> str:
        """The thing's name."""
        return self.asset.name

    @property
    def joined(self) -> Joining:
        """How it stands at its anchor; only for what has one."""
        if self.join is None:
            raise ValueError(f"{self.name} stands by itself")
        return self.join

    @property
    def minds(self) -> tuple[str, ...]:
        """What is there before it, if it stands on the floor: what it looks at, and what it is demanded to be near."""
        return (*(self.face.names if self.face else ()), *self.at) if self.standing else ()

    @property
    def block(self) -> tuple[str, ...]:
        """With what it is demanded to stand in so many rows, or in a circle or the like."""
        told = self.shape or (self.rows if self.rows is not None and self.rows.rows is not None else None)
        return told.asset_names() if told is not None else ()

    @property
    def hung(self) -> bool:
        """Whether it hangs at a wall."""
        return self.asset.on_wall and ("hang" in self.stands or not self.asset.on_floor)

    @property
    def overhead(self) -> bool:
        """Whether it hangs from the ceiling."""
        return self.asset.on_ceiling and not self.asset.on_floor and not self.hung

    @property
    def carried(self) -> bool:
        """Whether it can only stand on others."""
        return self.asset.on_object and not (self.asset.on_floor or self.asset.on_wall or self.asset.on_ceiling)

    @property
    def laid(self) -> bool:
        """Whether it lies wherever what stands leaves room: rugs, but no mats in rows."""
        return self.asset.is_flat and self.rows is None

    @property
    def standing(self) -> bool:
        """Whether it stands on the floor by itself."""
        return not (self.hung or self.overhead or self.laid)


def wants_of(scene: Scene, program: Program) -> dict[str, Want]:
    """Return what a program says of every thing, in the order in which they are placed."""
    about: dict[str, list[Statement]] = {}
    for one in sorted((*program.statements, *program.wishes), key=lambda statement: statement.line):
        for name in _subjects(one.relation):
            if name in scene.by_name:
                about.setdefault(name, []).append(one)
    order = {name: turn for turn, name in enumerate(about)}
    found: dict[str, Want] = {}
    for asset in sorted(scene.assets, key=lambda asset: order.get(asset.name, len(order))):
        said = about.get(asset.name, [])
        want = Want(asset, category_of(asset), order.get(asset.name, len(order)), _kind(asset, said))
        found[asset.name] = _Gathered(scene, want, said).want()
    for want in [want for want in found.values() if want.carried and want.anchor is None]:
        found[want.name] = replace(want, anchor=_top(want, found), join=Joining("on"))
    _pair(found, program.statements)
    return _seen_first(_acyclic(found))


def _seen_first(wants: dict[str, Want]) -> dict[str, Want]:
    """Return the same with what hangs, and others look at or stand at, right before the first of these."""
    turns = {name: float(want.turn) for name, want in wants.items()}
    for want in wants.values():
        for name in (name for name in want.minds if name in wants and wants[name].hung):
            turns[name] = min(turns[name], min(wants[one].turn for one in want.block or (want.name,)) - 0.5)
    return dict(sorted(wants.items(), key=lambda item: turns[item[0]]))


def _pair(wants: dict[str, Want], said: Sequence[Statement]) -> None:
    """Let the twin of what stands beside a thing stand at its other side, in place, where nothing else says where it stands."""
    for one in said:
        pair = one.relation
        if not isinstance(pair, SymmetricPair) or not isinstance(pair.ref, AssetRef):
            continue
        for mine, other in ((pair.a.name, pair.b.name), (pair.b.name, pair.a.name)):
            join = wants[other].join
            if wants[mine].anchor is None and join is not None and wants[other].anchor == pair.ref.name:
                side = {"left": "right", "right": "left"}.get(join.side, join.side)
                wants[mine] = replace(wants[mine], anchor=pair.ref.name, join=replace(join, side=side), loose=True)


def _top(want: Want, wants: Mapping[str, Want]) -> str | None:
    """Return on what a thing that stands on others is put where nothing says it: the largest top with the least on it."""
    load = Counter(other.anchor for other in wants.values())
    tops = {n: one.asset.size for n, one in wants.items() if one.standing and not one.carried}
    high = [name for name, size in tops.items() if LOWEST <= size[2] <= HIGHEST]
    return min(high, key=lambda name: (load[name] / max(math.prod(tops[name][:2]), SMALLEST), name), default=None)


def late(wants: Mapping[str, Want]) -> set[str]:
    """Return what is hung and laid once the floor is furnished: all but what others look or stand at or what is named first."""
    minded = {name for want in wants.values() for name in want.minds}
    first = min((want.turn for want in wants.values() if want.standing), default=0)
    return {name for name, want in wants.items() if not want.standing and name not in minded and want.turn >= first}


def _subjects(relation: Relation) -> tuple[str, ...]:
    """Return the names of the things that a relation says where to stand."""
    if isinstance(relation, AnyOf):
        return tuple(dict.fromkeys(name for way in relation.choices for one in way for name in _subjects(one)))
    first = getattr(relation, relation.moves[0]) if relation.moves else ()
    refs = first if isinstance(first, tuple) else (first,)
    return tuple(ref.name for ref in refs if isinstance(ref, AssetRef))


def _kind(asset: Asset, said: Sequence[Statement]) -> str:
    """Return what is said of a thing but for whom it is about; what it is where nothing is said; its block where one is demanded."""
    for one in said:
        rows = isinstance(one.relation, InRows) and one.wish is None and one.relation.rows is not None
        if rows or isinstance(one.relation, InShape):
            return " ".join(one.relation.asset_names())
    alone = [one for one in said if not isinstance(one.relation, SymmetricPair)]
    parts = [f"{one.relation.name} {_plain(one.relation)} {one.wish}" for one in alone]
    return "; ".join(sorted(parts)) or asset.category


def _plain(relation: Relation) -> str:
    """Return the numbers and words of a relation."""
    return " ".join(str(v) for v in vars(relation).values() if isinstance(v, int | float | str))


def _acyclic(wants: dict[str, Want]) -> dict[str, Want]:
    """Return the same without joins that end where they begin, or at what has no place on the floor or a top."""
    for name, want in wants.items():
        seen, at = {name}, want.anchor
        while at is not None and at not in seen:
            seen.add(at)
            at = wants[at].anchor if at in wants else None
        to = wants.get(want.anchor or "")
        hung = to is not None and to.hung and want.joined.slot not in ("on", "setting")  # a dog bed by the radiator
        if at is not None or hung or (want.anchor is not None and to is None):
            wants[name] = replace(want, anchor=None, join=None)
    return wants


class _Gathered:
    """Gathers what is said of one thing.

    Args:
        scene: The scene.
        want: The thing.
        said: Statements and wishes of which it is the subject, in order.
    """

    def __init__(self, scene: Scene, want: Want, said: Sequence[Statement]) -> None:
        self.scene, self.bare, self.said = scene, want, said

    def want(self) -> Want:
        """Return the thing with all of it."""
        anchor, join, demanded = self._join()
        rows = any(wish is None for _, wish in self._all(InRows))
        shape = next((one for one, wish in self._all(InShape) if wish is None or not rows), None)
        bare = replace(self.bare, rows=self._rows(), shape=shape)
        if anchor in bare.block:
            anchor, join = None, None  # its place is in the block
        face, weights = self._face(anchor), dict[str, float]()
        for one in self.said:
            several = any(getattr(one.relation, key, None) is not None for key in ("vertex", "window"))
            word = "one of several" if several else one.relation.name
            if one.wish is not None and word in ("mid_wall", "corner", "at_window", "by_door", "snug"):
                weights[word] = weights.get(word, 0.0) + one.wish
            elif one.wish is not None and isinstance(one.relation, CenteredOn) and one.relation.b is None:
                weights["middle"] = one.wish
        return replace(
            bare,
            stands=self._stands(face),
            weights=weights,
            walls={one.wall.index: w for kind in (AgainstWall, MountedOn) for one, w in self._wished(kind) if one.wall},
            numbered=(*self._wished(Corner), *self._wished(AtWindow)),
            near=tuple((names, w) for one, w in self._wished(Grouped) if (names := one.asset_names()[1:])),
            points=tuple((one.b, w) for one, w in self._wished(PointTowards) if isinstance(one.b, PointRef)),
            clear={one.side: one.depth for one, _ in self._all(KeepClear)},
            face=face,
            at=tuple(self._at()),
            over=tuple(self._over()),
            height=next((one.height for one, _ in self._all(MountedOn) if one.height is not None), 0.0),
            straight=tuple(
                (one.b.name, wish)
                for one, wish in self._all(AlignWith)
                if wish is not None and isinstance(one.b, AssetRef) and join is None
            ),
            anchor=anchor,
            join=join,
            loose=join is not None and (not demanded or bool(self._modes())),
        )

    def _rows(self) -> InRows | None:
        """Return the block that it belongs to: with rows as they are demanded, as far apart as is said."""
        found = sorted(self._all(InRows), key=lambda one: one[1] is None)
        looks = self._face(None) or any(w is None and isinstance(one.b, AssetRef) for one, w in self._all(AlignWith))
        told = (one.backs for one, wish in reversed(found) if wish is None or not looks)  # else all look one way
        spaced = any(wish is None and one.backs == "alike" and one.aisle > 0 for one, wish in found)
        turned = "alike" if spaced else next((backs for backs in told if backs != "alike"), "alike")
        own = set(found[-1][0].items) if found else set[AssetRef]()
        said = [one for one, _ in found if own <= {*one.items} and len(one.items) < 2 * len(own)]  # groups stand closer
        aisle, gap = (max((getattr(one, name) for one in said), default=0.0) for name in ("aisle", "gap"))
        return replace(said[-1], aisle=aisle, gap=gap, backs=turned) if said else None

    def _all(self, kind: type[Kind]) -> Iterator[tuple[Kind, float | None]]:
        """Yield what is said with a relation, with its weight if it is a wish."""
        yield from ((one.relation, one.wish) for one in self.said if isinstance(one.relation, kind))

    def _wished(self, kind: type[Kind]) -> Iterator[tuple[Kind, float]]:
        yield from ((one, weight) for one, weight in self._all(kind) if weight is not None)

    def _modes(self) -> dict[str, float]:
        """Return the ways of standing by itself that are named, with weights; infinite where it is demanded."""
        found: dict[str, float] = {}
        for kind, mode in ((AgainstWall, "wall"), (Corner, "corner"), (MountedOn, "hang")):
            for one, weight in self._all(kind):
                if weight is None or getattr(one, "wall", None) is None:
                    found[mode] = max(found.get(mode, -math.inf), math.inf if weight is None else weight)
        return found

    def _stands(self, face: Facing | None) -> dict[str, float]:
        """Return the ways of standing by itself with what each costs, the best first."""
        modes = self._modes()
        if "hang" in modes:
            return {"hang": 0.0}
        walled = math.isinf(modes.get("wall", 0))
        if (corner := modes.get("corner")) is not None and (corner <= 0 or (walled and corner < LEADS)):
            del modes["corner"]  # a wall's ends are corners, too
        if not any(math.isinf(weight) for weight in modes.values()):
            modes["facing" if face is not None and not face.away else "middle"] = 0.0
            if not self.said and "front" in use_sides(self.bare.asset):
                modes["wall"] = LEADS
        best = max(weight for weight in modes.values())
        cost = {mode: 0.0 if weight == best or math.isinf(best) else best - weight for mode, weight in modes.items()}
        return dict(sorted(cost.items(), key=lambda entry: (entry[1], ORDER.index(entry[0]))))

    def _join(self) -> tuple[str | None, Joining | None, bool]:
        """Return what it stands at, how, and whether that is demanded."""
        for one in self.said:
            relation, demanded = one.relation, one.wish is None
            if isinstance(relation, Around):
                return relation.b.name, Joining("around", relation.gap or AIM), demanded
            if isinstance(relation, Under) and not self.bare.asset.is_flat:
                (over, *_) = relation.items
                if places_beneath(self.scene.by_name[over.name], self.bare.asset):
                    return over.name, BELOW, demanded
            if isinstance(relation, OnTopOf):
                return relation.b.name, replace(self._on(relation.b), tops=relation.places(self.scene)), demanded
            if self.bare.asset.is_flat and isinstance(relation, NextTo | Toward):
                return None, Joining("beside" if isinstance(relation, NextTo) else "on"), False
            if isinstance(relation, Beside) and self._joins(relation):
                same = [other for other, _ in self._all(type(relation)) if other.b == relation.b]
                apart = max(same, key=lambda other: getattr(other, "min_gap", 0.0))  # a wish may leave more room
                return relation.b.name, self._beside(apart), demanded
        return None, None, False

    def _joins(self, relation: Beside) -> bool:
        """Whether a thing that is said to be at a side of another stands right at it."""
        other = self.scene.by_name.get(relation.b.name)
        here, least = self.bare.asset, getattr(relation, "min_gap", 0.0)
        on_floor = other is not None and all(one.on_floor and not one.is_flat for one in (other, here))
        return on_floor and relation.max_gap <= CLOSE and least < CLOSE / 2

    def _beside(self, relation: Beside) -> Joining:
        side, low = getattr(relation, "side", "") or SIDES[relation.name], max(getattr(relation, "min_gap", 0.0), 0.0)
        gap, yaw = min(low + AIM, (low + relation.max_gap) / 2), self._turned(relation.b)
        looks = any(one.b == relation.b for one, _ in self._all(PointTowards))
        if side in ("front", "back"):
            facing = math.pi if side == "front" else 0.0
            if yaw in (None, facing):
                gap = min(max(gap, self._to_open()), relation.max_gap)
            return Joining("front" if side == "front" else "behind", gap, facing if yaw is None else yaw)
        fixed = "" if side == "beside" else side
        across = looks or (yaw is not None and abs(math.sin(yaw)) > math.sqrt(0.5))
        return Joining("flank" if across else "beside", gap, yaw, fixed)

    def _to_open(self) -> float:
        """Return the metres before its front that its doors and drawers sweep, with the widest body behind them; 0 without any."""
        asset = self.bare.asset
        swept = [sweep.region.bounds[2] - asset.size[0] / 2 for sweep in sweeps_of(asset) if sweep.joint is not None]
        return max(swept) + 2 * max(agent.radius for agent in self.scene.agents) if swept else 0.0

    def _turned(self, b: AssetRef) -> float | None:
        """Return the angle to a thing's front, in radians, that is said."""
        return next((math.radians(one.angle) for one, _ in self._all(AlignWith) if one.b == b), None)

    def _on(self, carrier: AssetRef) -> Joining:
        """Return where on a top it belongs."""
        for one in self.said:
            other = one.relation.b if isinstance(one.relation, InFrontOf | DistanceConstraint) else None
            if isinstance(other, AssetRef) and other != carrier and self.scene.by_name[other.name].on_floor:
                return Joining("setting", at=self._place(), seat=other.name)
        halves = sorted(f"{one.side} end" if one.off > 0 else one.side for one, _ in self._all(Toward))
        middle = any(one.b == carrier for one, wish in self._all(CenteredOn) if wish is None)
        return Joining("on", yaw=self._turned(carrier), at="middle" if middle else " ".join(halves))

    def _place(self) -> str:
        """Return the place of a setting: by the plate that it is said to be beside, else that of a plate."""
        for one in self.said:
            relation = one.relation
            if isinstance(relation, Beside) and not self.scene.by_name[relation.b.name].on_floor:
                far = getattr(relation, "min_gap", 0.0) >= AIM
                if isinstance(relation, RightOf):
                    return "far right" if far else "right"
                return {"left_of": "left", "in_front_of": "beyond"}.get(relation.name, "glass")
        return "plate"

    def _face(self, anchor: str | None) -> Facing | None:
        """Return what it should have in front of it."""
        looks = [(one.b, one.angle, weight) for one, weight in self._all(PointTowards)]
        distance, weights = [0.0, 20.0], [DEMANDED if weight is None else weight for *_, weight in looks]
        for one in self.said:
            ways = one.relation.choices if isinstance(one.relation, AnyOf) else ()
            several = [part for way in ways for part in way]
            if several and all(isinstance(part, PointTowards) for part in several):
                looks += [(part.b, part.angle, one.wish) for part in several if isinstance(part, PointTowards)]
                weights.append(DEMANDED if one.wish is None else one.wish)
        targets = tuple(dict.fromkeys(b.name for b, *_ in looks if isinstance(b, AssetRef) and b.name != anchor))
        for one, _ in self._all(InFrontOf):
            if targets and one.b.name == targets[0]:
                apart = (self.bare.asset.size[0] + self.scene.by_name[one.b.name].size[0]) / 2
                distance = [one.min_gap + apart, one.max_gap + apart]
        if not targets:
            return None
        return Facing(targets, abs(looks[0][1]) > 90.0, (distance[0], distance[1]), max(weights))

    def _at(self) -> Iterator[str]:
        """Yield what it is demanded to be near, or at a side of, in any way."""
        for one in self.said:
            ways = one.relation.choices if isinstance(one.relation, AnyOf) else ((one.relation,),)
            mine = (part for way in ways for part in way if one.wish is None and self.bare.name in _subjects(part))
            to = (part.b for part in mine if isinstance(part, Beside | Near))
            yield from (ref.name for ref in to if isinstance(ref, AssetRef))

    def _over(self) -> Iterator[str]:
        """Yield what it hangs over or lies under, best first."""
        for one in self.said:
            ways = one.relation.choices if isinstance(one.relation, AnyOf) else ((one.relation,),)
            for relation in (part for way in ways for part in way):
                if isinstance(relation, Above | CeilingAbove | CenteredOn | Under):
                    yield from relation.asset_names()[1:]
