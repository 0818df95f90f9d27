"""`mounted_on`: a wall thing hangs at a wall, at a height."""

from __future__ import annotations

from dataclasses import dataclass, replace

from robolayout.constraints._exact import TOLERANCE
from robolayout.constraints._refs import AssetRef, WallRef
from robolayout.constraints._relation import Outcome, Relation, Term, Way, argument
from robolayout.constraints.against_wall import AgainstWall
from robolayout.scene import Layout, Scene

EYE_HEIGHT = 1.5  # metres above the floor of the middle of a wall thing that nobody gave a height


@dataclass(frozen=True)
class MountedOn(Relation):
    """`a` hangs at `wall` (None: any wall), facing into the room, its centre `height` m up (None: as usual for such a thing)."""

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
        """At the wall as `against_wall`, and its centre within 5 cm of the height."""
        outcome = AgainstWall(self.a, self.wall).check(scene, layout)
        off = 0.0 if self.height is None else abs(layout[self.a.name].z - self.height)
        text = outcome.text + (f", {off:.2f} m off its height" if off > TOLERANCE.gap else "")
        return Outcome(outcome.met and off <= TOLERANCE.gap, max(outcome.value, off), TOLERANCE.gap, "m", text)
