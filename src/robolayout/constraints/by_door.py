"""`by_door`: a thing stands close to a door."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._refs import AssetRef, PointRef
from robolayout.constraints._relation import Outcome, Relation, Term, Way, argument, best_way
from robolayout.constraints.near import Near
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class ByDoor(Relation):
    """`a` stands by a door, whichever: at most `max_gap` m from the middle of its threshold."""

    name = "by_door"
    surrogate = True  # the disc inside a within the distance, where the check takes its nearest edge
    example = "solver.by_door(coat_rack[0])"

    a: AssetRef = argument("asset")
    max_gap: float = argument("number", unit="m", default=1.4)

    def fault(self, scene: Scene) -> str:
        """Refuse a room without a door."""
        return "" if scene.room.doors else "this room has no door"

    def ways(self, scene: Scene) -> tuple[Way, ...]:
        """Return one for each door."""
        return tuple((Near(self.a, door, self.max_gap),) for door in doorways(scene))

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return the row of `near` for the nearest door."""
        return best_way(self.ways(scene), scene, near)[0][0].terms(scene, near)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The nearest door at most max_gap + 0.05 m from the footprint."""
        return best_way(self.ways(scene), scene, layout)[1]


def doorways(scene: Scene) -> list[PointRef]:
    """Return the middles of all thresholds."""
    return [PointRef(*scene.room.walls[door.wall].point(door.center)) for door in scene.room.doors]
