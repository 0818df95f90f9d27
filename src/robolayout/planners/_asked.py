"""What the user's words ask of places: who joins what, what a place costs that misses it, and which way to meet it is written.

A demand often has several ways ("at a wall": one for each wall). While the room is furnished the cheapest way counts; in the
program the way stands that holds best in the furnished room.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from robolayout.constraints import FAR, AssetRef, FrameTerm, Interval, PointRef, Relation, Term, WallRef
from robolayout.constraints.in_front_of import InFrontOf
from robolayout.planners._knowledge import Join
from robolayout.planners._member import Member
from robolayout.planners._roles import Cast, depends
from robolayout.scene import Layout, Pose, Scene
from robolayout.words import Between, Demand

Poses = NDArray[np.float64]
"""(n, 3) metres and radians."""

MISSED, PER_METRE, FARTHEST = 12.0, 6.0, 2.0
"""Cost of a place that misses a demand, and of each metre (or radian) by which it does, up to so many."""

SLACK = 0.04
"""Metres by which a place may miss a demand and still count as meeting it."""

SEATED, BEFORE = 0.05, 0.4
"""Metres between a seat and what it stands at, and between other things and what they stand before."""

CLOSE = 3.0
"""Metres up to which what stands before a thing belongs to it."""

BLIND = ("on_top_of", "under")
"""Relations that places are not weighed by: who stands on what is settled by joining."""


class Placed(Protocol):
    """Something that has its place."""

    @property
    def member(self) -> Member:
        """The asset in the world frame."""
        ...


@dataclass(frozen=True)
class _Way:
    terms: tuple[FrameTerm, ...]


@dataclass(frozen=True, eq=False)
class Asked:
    """The demands of a scene, ready to be weighed.

    Attributes:
        scene: The scene.
        demands: The demands.
        ways: The rows of each way of each demand, in the same order.
    """

    scene: Scene
    demands: tuple[Demand, ...] = ()
    ways: tuple[tuple[_Way, ...], ...] = ()

    @staticmethod
    def of(scene: Scene, demands: Sequence[Demand]) -> Asked:
        """Return the demands with their rows."""
        rows = [tuple(_Way(_rows(scene, way)) for way in demand.ways) for demand in demands]
        return Asked(scene, tuple(demands), tuple(rows))

    def about(self, names: Sequence[str]) -> list[int]:
        """Return the numbers of the demands that have to do with some assets and can be weighed."""
        known = set(names)
        return [i for i, d in enumerate(self.demands) if known & d.names() and any(way.terms for way in self.ways[i])]

    def missed(self, members: Sequence[Member], poses: Poses, spots: Mapping[str, Placed]) -> Poses:
        """Return the cost (n,) of putting some things, given in one frame, where that frame has these poses (n, 3)."""
        if not self.about([member.name for member in members]):
            return np.zeros(len(poses))
        c, s = np.cos(poses[:, 2]), np.sin(poses[:, 2])
        moving = {
            m.name: np.column_stack(
                [poses[:, 0] + c * m.x - s * m.y, poses[:, 1] + s * m.x + c * m.y, poses[:, 2] + m.yaw]
            )
            for m in members
        }
        return self.cost(moving, {name: spot.member for name, spot in spots.items()})

    def cost(self, moving: Mapping[str, Poses], placed: Mapping[str, Member]) -> Poses:
        """Return the cost (n,) of places by the demands that they miss; what is not placed yet is not asked about.

        Args:
            moving: Poses of the assets that are put down together.
            placed: What stands already.
        """
        count = len(next(iter(moving.values())))
        total = np.zeros(count)
        there = {*moving, *placed}
        for i in self.about(list(moving)):
            if not self.demands[i].names() <= there:
                continue
            best = np.full(count, np.inf)
            for way in self.ways[i]:
                missed = sum((self._missed(term, moving, placed) for term in way.terms), np.zeros(count))
                best = np.minimum(best, missed)
            exact = self.demands[i].exact
            if exact is not None:
                best = best + self._aside(exact, moving, placed)
            total += MISSED * (best > SLACK) + PER_METRE * np.minimum(best, FARTHEST)
        return total

    def _missed(self, term: FrameTerm, moving: Mapping[str, Poses], placed: Mapping[str, Member]) -> Poses:
        """Return by how many metres or radians (n,) a row is missed."""
        a, half_a = self._poses(term.a, moving, placed)
        b, half_b = self._poses(term.b, moving, placed)
        c, s = np.cos(b[:, 2]), np.sin(b[:, 2])
        dx, dy = a[:, 0] - b[:, 0], a[:, 1] - b[:, 1]
        u, v, turn = c * dx + s * dy, c * dy - s * dx, a[:, 2] - b[:, 2]
        ec, es = np.abs(np.cos(turn)), np.abs(np.sin(turn))
        across = np.abs(v) if term.fold else v
        missed = _beyond(u, term.along, ec * half_a[0] + es * half_a[1])
        missed = missed + _beyond(across, term.across, es * half_a[0] + ec * half_a[1])
        low, high = term.distance
        away = np.hypot(np.maximum(np.abs(u) - half_b[0], 0.0) if isinstance(term.b, WallRef) else u, v)
        missed += np.maximum(low - away, 0.0) + (np.maximum(away - high, 0.0) if high < FAR else 0.0)
        if term.heading is not None:
            missed += np.abs(_wrapped(turn - term.heading))
        if term.look is not None:
            off = np.abs(_wrapped(turn + term.look - np.arctan2(-v, -u)))
            missed += np.maximum(0.0, off - np.arctan2(min(half_b), np.maximum(away, 0.1)))
        return missed

    def _aside(self, asked: Between, moving: Mapping[str, Poses], placed: Mapping[str, Member]) -> Poses:
        """Return by how many metres (n,) a thing is off the middle part of the line between two others."""
        (here, _), (one, _), (two, _) = (self._poses(ref, moving, placed) for ref in (asked.a, asked.b, asked.c))
        line, away = two[:, :2] - one[:, :2], here[:, :2] - one[:, :2]
        length = np.maximum(np.hypot(line[:, 0], line[:, 1]), 1e-6)
        share = (away * line).sum(axis=1) / length**2
        aside = np.abs(away[:, 0] * line[:, 1] - away[:, 1] * line[:, 0]) / length
        past = np.maximum(0.2 - share, 0.0) + np.maximum(share - 0.8, 0.0)
        return np.maximum(aside - asked.SLACK / 2, 0.0) + past * length

    def _poses(
        self, ref: AssetRef | WallRef | PointRef, moving: Mapping[str, Poses], placed: Mapping[str, Member]
    ) -> tuple[Poses, tuple[float, float]]:
        """Return poses (n or 1, 3) and half extents of what a row is about."""
        if isinstance(ref, WallRef):
            wall = self.scene.room.walls[ref.index]
            yaw = math.atan2(wall.direction[1], wall.direction[0])
            return np.array([[*wall.midpoint, yaw]]), (wall.length / 2, 0.0)
        if isinstance(ref, PointRef):
            return np.array([[ref.x, ref.y, ref.yaw]]), (0.0, 0.0)
        depth, width, _ = self.scene.by_name[ref.name].size
        if ref.name in moving:
            return moving[ref.name], (depth / 2, width / 2)
        member = placed[ref.name]
        return np.array([[member.x, member.y, member.yaw]]), (depth / 2, width / 2)

    def written(self, placed: Mapping[str, Member]) -> list[tuple[tuple[Relation, ...], bool]]:
        """Return for each demand the way that holds best in a furnished room, and whether it holds there."""
        poses = {
            name: Pose(m.x, m.y, m.bottom + self.scene.by_name[name].size[2] / 2, m.yaw) for name, m in placed.items()
        }
        layout = Layout(poses)
        found: list[tuple[tuple[Relation, ...], bool]] = []
        for demand in self.demands:
            if demand.names() <= set(poses):
                found.append(self._best_way(demand, layout))
        return found

    def _best_way(self, demand: Demand, layout: Layout) -> tuple[tuple[Relation, ...], bool]:
        measured: list[tuple[bool, float, int]] = []
        for i, way in enumerate(demand.ways):
            outcomes = [relation.check(self.scene, layout) for relation in way]
            measured.append((not all(o.met for o in outcomes), sum(max(0.0, o.value - o.limit) for o in outcomes), i))
        unmet, _, best = min(measured)
        return demand.ways[best], not unmet


def _rows(scene: Scene, way: Sequence[Relation]) -> tuple[FrameTerm, ...]:
    """Return the rows of a way that can be weighed; an empty room is near enough for what they are made of."""
    terms: list[Term] = []
    for relation in way:
        if relation.name not in BLIND:
            terms += relation.terms(scene, Layout({}))
    return tuple(term for term in terms if isinstance(term, FrameTerm))


def _beyond(value: Poses, bounds: Interval, extent: Poses) -> Poses:
    low = np.maximum(bounds.low - (value - bounds.low_extent * extent), 0.0)
    return low + np.maximum(value + bounds.high_extent * extent - bounds.high, 0.0)


def _wrapped(angle: Poses) -> Poses:
    return (angle + math.pi) % (2 * math.pi) - math.pi


def join_as_asked(cast: Mapping[str, Cast], demands: Sequence[Demand]) -> dict[str, Cast]:
    """Return the cast with what is asked to stand on, beside or before something joined to it.

    What is asked to stand elsewhere is not joined to what its kind usually joins.
    """
    found = dict(cast)
    wanted = {name: join for demand in demands for name, join in _joins(demand, cast)}
    placed = {first for demand in demands for first in _subjects(demand)}
    for name in placed - set(wanted):
        item = found[name]
        others = {other for demand in demands if name in _subjects(demand) for other in demand.names()}
        if item.anchor is not None and item.anchor not in others and not _only_on(item):
            found[name] = replace(item, anchor=None, join=None)
    for name, (anchor, join) in wanted.items():
        found[name] = replace(found[name], anchor=None, join=None)
        if not depends(anchor, name, found):
            found[name] = replace(found[name], anchor=anchor, join=join)
    return found


def _only_on(item: Cast) -> bool:
    return item.asset.on_object and not item.asset.on_floor


def _subjects(demand: Demand) -> set[str]:
    """Return what is asked to be somewhere; looking at something moves nothing."""
    return {
        relation.asset_names()[0]
        for relation in demand.ways[0]
        if relation.name not in ("point_towards", "under", "above")
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
        join = _join(relation, cast[a], cast[b], around=around)
        if join is not None:
            found.append((a, (b, join)))
    return found


def _join(relation: Relation, a: Cast, b: Cast, *, around: bool) -> Join | None:
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
        return Join("behind", (b.role.name,), gap=BEFORE, loose=True)
    return None
