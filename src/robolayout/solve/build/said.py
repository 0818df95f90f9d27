"""What statements ask of places: what a place costs that misses them.

A statement often has several ways ("at a wall": one for each wall); while the room is furnished the cheapest way counts.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from robolayout._geometry import Body, FrameRow, frame_residual, mirror_residual
from robolayout.constraints import AssetRef, FrameTerm, MirrorTerm, PointRef, Relation, WallRef, Way
from robolayout.constraints.above import Above
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.keep_clear import KeepClear
from robolayout.constraints.mounted_on import MountedOn
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.constraints.under import Under
from robolayout.program import Program
from robolayout.scene import Layout, Pose, Scene
from robolayout.solve.build.member import Member, Poses

MISSED, PER_METRE, FARTHEST = 12.0, 6.0, 2.0
"""Cost of a place that misses a statement, and of each metre of its residual, up to so many."""

SLACK = 0.015
"""Residual up to which a place counts as meeting a statement: 3 cm, or 10 degrees."""


@dataclass(frozen=True)
class SaidStatement:
    """One statement."""

    names: frozenset[str]  # what it is about
    ways: tuple[Way, ...]  # the relations of each way in which it can hold


@dataclass(frozen=True, eq=False)
class Said:
    """The statements of a program that places are weighed by."""

    scene: Scene
    asked: tuple[SaidStatement, ...] = ()  # the statements

    @staticmethod
    def of(scene: Scene, program: Program, behind: Collection[str], first: Collection[str]) -> Said:
        """Return the statements of a program but those that hold by how places are found.

        Those of what is `behind` others do not, and those of a rug that is laid `first`.
        """
        told = {*behind, *first}
        relations = [one.relation for one in program.statements if not _built_in(one.relation, told)]
        asked = (SaidStatement(frozenset(one.asset_names()), one.ways(scene) or ((one,),)) for one in relations)
        return Said(scene, tuple(asked))

    def about(self, names: Sequence[str]) -> list[SaidStatement]:
        """Return the statements that have to do with some assets."""
        known = set(names)
        return [one for one in self.asked if known & one.names]

    def may_go_first(self, names: Sequence[str]) -> bool:
        """Return whether others make way if some things are placed first: nothing that hangs is asked of them, no floor is kept."""
        others = (self.scene.by_name[name] for one in self.about(names) for name in one.names)
        return not self.keeps_clear and all(asset.on_floor or asset.on_object for asset in others)

    @cached_property
    def keeps_clear(self) -> bool:
        """Whether floor beside some thing is demanded clear."""
        return any(isinstance(part, KeepClear) for one in self.asked for way in one.ways for part in way)

    @cached_property
    def above(self) -> Mapping[str, Sequence[str]]:
        """What each thing is asked to hang above."""
        found: dict[str, list[str]] = {}
        for part in (part for one in self.asked for way in one.ways for part in way if isinstance(part, Above)):
            found.setdefault(part.a.name, []).append(part.b.name)
        return found

    def missed(self, members: Sequence[Member], poses: Poses, placed: Mapping[str, Member]) -> Poses:
        """Return the cost (n,) of places by the statements that they miss; what is not placed yet is not asked about.

        Args:
            members: What is put down together, in one frame.
            poses: (n, 3) of that frame.
            placed: What stands already.
        """
        total, about = np.zeros(len(poses)), self.about([member.name for member in members])
        if not about:
            return total
        moving = {member.name: member.everywhere(poses) for member in members}
        there = {*moving, *placed}
        first = {name: Member(name, *poses[0].tolist()) for name, poses in moving.items()}
        now = Layout({name: _pose(self.scene, member) for name, member in (first | dict(placed)).items()})
        for one in about:
            if one.names <= moving.keys() and len(one.names) > 1:
                continue
            best = np.full(len(poses), np.inf)
            for way in one.ways:
                known = [part for part in way if there.issuperset(part.asset_names())]
                terms = (term for part in known for term in part.terms(self.scene, now))
                rows = [term for term in terms if isinstance(term, FrameTerm | MirrorTerm)]
                best = np.minimum(best, sum((self._missed(row, moving, placed) for row in rows), np.zeros(len(poses))))
            total += MISSED * (best > SLACK) + PER_METRE * np.minimum(best, FARTHEST)
        return total

    def _missed(self, term: FrameTerm | MirrorTerm, moving: Mapping[str, Poses], placed: Mapping[str, Member]) -> Poses:
        """Return the residual (n,) of a row."""
        if isinstance(term, MirrorTerm):
            a, b, axis = (self._body(ref, moving, placed) for ref in (term.a, term.b, term.ref))
            return mirror_residual(a, b, axis, np.array([float(isinstance(term.ref, WallRef))]))
        row = FrameRow(*np.array(term.row()))
        return frame_residual(self._body(term.a, moving, placed), self._body(term.b, moving, placed), row)

    def _body(
        self, ref: AssetRef | WallRef | PointRef, moving: Mapping[str, Poses], placed: Mapping[str, Member]
    ) -> Body:
        """Return what a row is about at its poses (n or 1,)."""
        depth, width, core = 0.0, 0.0, 0.0
        if isinstance(ref, WallRef):
            wall = self.scene.room.walls[ref.index]
            poses = np.array([[*wall.midpoint, math.atan2(wall.direction[1], wall.direction[0])]])
            depth, core = wall.length, wall.length / 2
        elif isinstance(ref, PointRef):
            poses = np.array([[ref.x, ref.y, ref.yaw]])
        else:
            depth, width, _ = self.scene.by_name[ref.name].size
            at = placed.get(ref.name)
            poses = moving[ref.name] if at is None or ref.name in moving else np.array([[at.x, at.y, at.yaw]])
        x, y, yaw = poses.T
        return Body(x, y, np.cos(yaw), np.sin(yaw), *np.array([[depth / 2], [width / 2], [core]]))


def rugs_first(scene: Scene, program: Program) -> frozenset[str]:
    """Return the rugs whose places are asked for by themselves, and on which things stand."""
    said = [one.relation for one in program.statements]
    placed = [one for one in said if not isinstance(one, AlignWith)]
    alone = {one.asset_names()[0] for one in placed if len({*one.asset_names()}) == 1}
    rugs = {one.a.name for one in said if isinstance(one, Under)}
    return frozenset(rug for rug in rugs & alone if scene.by_name[rug].is_flat)


def _built_in(relation: Relation, told: Collection[str]) -> bool:
    """Whether a relation holds by the way in which places are found: on tops, under things, at any wall, square to the room."""
    if isinstance(relation, AgainstWall | MountedOn):
        return relation.wall is None and relation.a.name not in told
    if isinstance(relation, Under):
        return relation.a.name not in told
    return isinstance(relation, OnTopOf) or (isinstance(relation, AlignWith) and relation.b is None)


def _pose(scene: Scene, member: Member) -> Pose:
    return Pose(member.x, member.y, member.bottom + scene.by_name[member.name].size[2] / 2, member.yaw)
