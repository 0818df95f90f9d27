"""Implicit `door_clear`: nothing stands before a door."""

from __future__ import annotations

import math
from dataclasses import dataclass

from shapely import Polygon

from robolayout.constraints._exact import TOLERANCE, common_area, footprint
from robolayout.constraints._refs import AssetRef, WallRef
from robolayout.constraints._relation import ClearTerm, Outcome, Relation, Term
from robolayout.scene import OPENINGS, Layout, Opening, Room, Scene, vertical_span


@dataclass(frozen=True)
class DoorClear(Relation):
    """Nothing below 2 m stands within a door's width and 0.9 m of it, nor where a leaf swings in; rugs may lie there."""

    name = "door_clear"
    hard = True
    implicit = True
    example = ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one strip per door, in the frame of its wall."""
        return tuple(
            ClearTerm(
                WallRef(door.wall),
                (door.center - scene.room.walls[door.wall].length / 2, _depth(scene.room, door) / 2),
                (door.width / 2, _depth(scene.room, door) / 2),
                (0.0, OPENINGS.landing_height),
            )
            for door in scene.room.doors
        )

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """At most 1e-4 m2 of any footprint in any landing."""
        worst, text = 0.0, "all doors are clear"
        for number, door in enumerate(scene.room.doors):
            landing = Polygon(scene.room.landing(door))
            for name, pose in layout.items():
                asset = scene.by_name[name]
                if asset.is_flat or vertical_span(asset, pose)[0] >= OPENINGS.landing_height:
                    continue
                area = common_area(landing, footprint(scene, layout, AssetRef(name)))
                if area > max(worst, TOLERANCE.area):
                    worst, text = area, f"{name} takes {area:.3f} m2 of the landing of door {number}"
        return Outcome.at_most(TOLERANCE.area, worst, "m2", text)


def _depth(room: Room, door: Opening) -> float:
    """Return how deep a door's landing is, in metres."""
    near, _, _, beyond = room.landing(door)
    return math.dist(near, beyond)
