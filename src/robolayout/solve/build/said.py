"""What statements ask of places: what a place costs that misses them.

A statement often has several ways ("at a wall": one for each wall); while the room is furnished the cheapest way counts.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from robolayout.constraints import AssetRef, FrameTerm, PointRef, Relation, WallRef, Way
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.mounted_on import MountedOn
from robolayout.constraints.on_top_of import OnTopOf
from robolayout.constraints.under import Under
from robolayout.program import Program
from robolayout.scene import Layout, Pose, Scene
from robolayout.solve.build.member import Member
from robolayout.solve.rows import missed

Poses = NDArray[np.float64]
"""(n, 3) metres and radians."""

MISSED, PER_METRE, FARTHEST = 12.0, 6.0, 2.0
"""Cost of a place that misses a statement, and of each metre (or radian) by which it does, up to so many."""

SLACK = 0.04
"""Metres by which a place may miss a statement and still count as meeting it."""


class Placed(Protocol):
    """Something that has its place."""

    @property
    def member(self) -> Member:
        """The asset in the world frame."""
        ...


@dataclass(frozen=True)
class Asked:
    """One statement."""

    names: frozenset[str]  # what it is about
    ways: tuple[Way, ...]  # the relations of each way in which it can hold


@dataclass(frozen=True, eq=False)
class Said:
    """The statements of a program that places are weighed by."""

    scene: Scene
    asked: tuple[Asked, ...] = ()  # the statements

    @staticmethod
    def of(scene: Scene, program: Program) -> Said:
        """Return the statements of a program but those that hold by the way in which places are found."""
        relations = [one.relation for one in program.statements if not _built_in(one.relation)]
        return Said(
            scene, tuple(Asked(frozenset(one.asset_names()), one.ways(scene) or ((one,),)) for one in relations)
        )

    def about(self, names: Sequence[str]) -> list[Asked]:
        """Return the statements that have to do with some assets."""
        known = set(names)
        return [one for one in self.asked if known & one.names]

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
        """Return the cost (n,) of places by the statements that they miss; what is not placed yet is not asked about.

        Args:
            moving: Poses of the assets that are put down together.
            placed: What stands already.
        """
        count = len(next(iter(moving.values())))
        total = np.zeros(count)
        there = {*moving, *placed}
        first = {name: Member(name, *poses[0].tolist()) for name, poses in moving.items()}
        now = Layout({name: _pose(self.scene, member) for name, member in (first | dict(placed)).items()})
        for one in self.about(list(moving)):
            if not one.names <= there or len(one.names & moving.keys()) == len(one.names) > 1:
                continue
            best = np.full(count, np.inf)
            for way in one.ways:
                rows = [term for part in way for term in part.terms(self.scene, now) if isinstance(term, FrameTerm)]
                best = np.minimum(best, sum((self._missed(row, moving, placed) for row in rows), np.zeros(count)))
            total += MISSED * (best > SLACK) + PER_METRE * np.minimum(best, FARTHEST)
        return total

    def _missed(self, term: FrameTerm, moving: Mapping[str, Poses], placed: Mapping[str, Member]) -> Poses:
        """Return by how many metres or radians (n,) a row is missed."""
        a, half = self._poses(term.a, moving, placed)
        b, other = self._poses(term.b, moving, placed)
        c, s = np.cos(b[:, 2]), np.sin(b[:, 2])
        dx, dy = a[:, 0] - b[:, 0], a[:, 1] - b[:, 1]
        return missed(term, np.column_stack([c * dx + s * dy, c * dy - s * dx, a[:, 2] - b[:, 2]]), half, other)

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


def _built_in(relation: Relation) -> bool:
    """Whether a relation holds by the way in which places are found: on tops, at any wall, square to the room."""
    anywhere = isinstance(relation, AgainstWall | MountedOn) and relation.wall is None
    return anywhere or isinstance(relation, OnTopOf | Under) or (isinstance(relation, AlignWith) and relation.b is None)


def _pose(scene: Scene, member: Member) -> Pose:
    return Pose(member.x, member.y, member.bottom + scene.by_name[member.name].size[2] / 2, member.yaw)
