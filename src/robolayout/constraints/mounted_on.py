"""`mounted_on`: a wall thing hangs at a wall, at a height."""

from __future__ import annotations

from dataclasses import dataclass, replace

from robolayout.constraints._exact import TOLERANCE, footprint, frame
from robolayout.constraints._refs import AssetRef, WallRef
from robolayout.constraints._relation import Outcome, Relation, Term, Way, argument, best_way
from robolayout.constraints.against_wall import AgainstWall, wall_outcome
from robolayout.scene import Layout, Scene

EYE_HEIGHT = 1.5  # metres above the floor of the middle of a wall thing that nobody gave a height


@dataclass(frozen=True)
class MountedOn(Relation):
    """`a` hangs at `wall` (None: any wall), facing into the room, its centre `height` m up (None: as usual for such a thing).

    What hangs has a wall behind it, no door and no window.
    """

    name = "mounted_on"
    orients = True
    surrogate = True  # as against_wall
    example = "solver.mounted_on(picture[0], walls[2], height=1.5)"

    a: AssetRef = argument("asset")
    wall: WallRef | None = argument("wall", "none", default=None)
    height: float | None = argument("number", "none", unit="m", default=None)

    def ways(self, scene: Scene) -> tuple[Way, ...]:
        """Return one for each wall where the program names none."""
        walls = (one.refs()[1] for (one,) in AgainstWall(self.a, self.wall).ways(scene))
        return tuple((replace(self, wall=wall),) for wall in walls if isinstance(wall, WallRef))

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row in the wall's frame; the height is kept by construction."""
        return AgainstWall(self.a, self.wall).terms(scene, near)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """At the wall as `against_wall`, its centre within 5 cm of the height, and no door or window behind it."""
        if self.wall is None:
            return best_way(self.ways(scene), scene, layout)[1]
        outcome = wall_outcome(self.a, self.wall, scene, layout)
        off = 0.0 if self.height is None else abs(layout[self.a.name].z - self.height)
        before = self._before(self.wall, scene, layout)
        text = outcome.text + (f", {off:.2f} m off its height" if off > TOLERANCE.gap else "")
        text += f", {before:.2f} m of it before a door or window" if before > TOLERANCE.gap else ""
        value = max(outcome.value, off, before)
        return Outcome(outcome.met and max(off, before) <= TOLERANCE.gap, value, TOLERANCE.gap, "m", text)

    def _before(self, wall: WallRef, scene: Scene, layout: Layout) -> float:
        """Return how many metres of its width are before a door or window of its wall."""
        half = scene.by_name[self.a.name].size[2] / 2
        left, _, right, _ = frame(scene, layout, wall).local(footprint(scene, layout, self.a)).bounds
        middle, z = scene.room.walls[wall.index].length / 2, layout[self.a.name].z
        return max(
            (
                min(right + middle, o.offset + o.width) - max(left + middle, o.offset)
                for o in (*scene.room.doors, *scene.room.windows)
                if o.wall == wall.index and z - half < o.sill + o.height and z + half > o.sill
            ),
            default=0.0,
        )
