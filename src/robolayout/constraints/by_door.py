"""`by_door`: a thing stands close to a door."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from robolayout.constraints._exact import GAP_TOLERANCE, footprint, half_size, shape
from robolayout.constraints._refs import AssetRef, PointRef
from robolayout.constraints._relation import Outcome, Relation, argument
from robolayout.constraints._terms import FrameTerm, Term
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class ByDoor(Relation):
    """`a` stands by a door, whichever: at most `max_gap` m from the middle of its threshold."""

    name: ClassVar[str] = "by_door"
    surrogate: ClassVar[bool] = True  # the disc inside a within the distance, where the check takes its nearest edge
    example: ClassVar[str] = "solver.by_door(coat_rack[0])"

    a: AssetRef = argument("asset")
    max_gap: float = argument("number", unit="m", default=1.4)

    def fault(self, scene: Scene) -> str:
        """Refuse a room without a door."""
        return "" if scene.room.doors else "this room has no door"

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row: the distance to the nearest door."""
        pose = near[self.a.name]
        door = min(doorways(scene), key=lambda ref: math.dist((ref.x, ref.y), (pose.x, pose.y)))
        return (FrameTerm(self.a, door, distance=(0.0, self.max_gap + min(half_size(scene, self.a)))),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The nearest door at most max_gap + 0.05 m from the footprint."""
        body = footprint(scene, layout, self.a)
        gap = min(body.distance(shape(scene, layout, door)) for door in doorways(scene))
        return Outcome(gap <= self.max_gap + GAP_TOLERANCE, gap, self.max_gap, "m", f"{gap:.2f} m from the nearest door")


def doorways(scene: Scene) -> list[PointRef]:
    """Return the middles of all thresholds."""
    return [PointRef(*scene.room.walls[door.wall].point(door.center)) for door in scene.room.doors]
