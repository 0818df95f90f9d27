"""`mounted_on`: a wall thing hangs at a wall, at a height."""

from __future__ import annotations

from dataclasses import dataclass, replace

from robolayout.assets import category_of
from robolayout.constraints._exact import TOLERANCE, footprint, frame, seen_from
from robolayout.constraints._refs import AssetRef, WallRef
from robolayout.constraints._relation import Interval, Outcome, Relation, Term, Way, argument, best_way
from robolayout.constraints.against_wall import AgainstWall, wall_outcome, wall_term
from robolayout.scene import Layout, Scene

EYE_HEIGHT = 1.5  # metres above the floor of the middle of a wall thing that nobody gave a height


@dataclass(frozen=True)
class MountedOn(Relation):
    """`a` hangs at `wall` (None: any wall), facing into the room, its centre `height` m up (None: as usual for such a thing).

    What hangs has a wall behind it, no door and no window; curtains and blinds may hang before windows.
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
        """Return one row in the wall's frame, for the stretch of it beside doors and windows that is nearest; the height is kept."""
        if self.wall is None:
            return best_way(self.ways(scene), scene, near)[0][0].terms(scene, near)
        low, high = self._stretch(self.wall, scene, near)
        return (replace(wall_term(self.a, self.wall, scene, 1.0), along=Interval(low, high, 1.0, 1.0)),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """At the wall as `against_wall`, its centre within 5 cm of the height, and no door or window behind it."""
        if self.wall is None:
            return best_way(self.ways(scene), scene, layout)[1]
        outcome = wall_outcome(self.a, self.wall, scene, layout)
        off = 0.0 if self.height is None else abs(layout[self.a.name].z - self.height)
        left, _, right, _ = seen_from(frame(scene, layout, self.wall), footprint(scene, layout, self.a)).bounds
        openings = self._openings(self.wall, scene, layout)
        before = max((min(right, high) - max(left, low) for low, high in openings), default=0.0)
        text = outcome.text + (f", {off:.2f} m off its height" if off > TOLERANCE.gap else "")
        text += f", {before:.2f} m of it before a door or window" if before > TOLERANCE.gap else ""
        hangs = scene.by_name[self.a.name].on_wall
        met = outcome.met and hangs and max(off, before) <= TOLERANCE.gap
        text += "" if hangs else ", it does not hang at walls"
        return Outcome(met, max(outcome.value, off, before), TOLERANCE.gap, "m", text)

    def _openings(self, wall: WallRef, scene: Scene, layout: Layout) -> list[tuple[float, float]]:
        """Return where doors and windows at its height begin and end, in metres from the wall's middle."""
        middle, z, half = scene.room.walls[wall.index].length / 2, layout[self.a.name].z, self._size(scene)[2] / 2
        dresses = category_of(scene.by_name[self.a.name]).dresses_windows
        openings = (*scene.room.doors, *(() if dresses else scene.room.windows))
        found = [opening for opening in openings if opening.wall == wall.index]
        level = [o for o in found if z - half < o.sill + o.height and z + half > o.sill]
        return sorted((o.offset - middle, o.offset + o.width - middle) for o in level)

    def _stretch(self, wall: WallRef, scene: Scene, near: Layout) -> tuple[float, float]:
        """Return the nearest stretch of the wall beside its openings that is wide enough, else the whole wall."""
        half, width = scene.room.walls[wall.index].length / 2, self._size(scene)[1]
        openings, pose = self._openings(wall, scene, near), near[self.a.name]
        ends = [-half, *(end for opening in openings for end in opening), half]
        free = [(low, high) for low, high in zip(ends[::2], ends[1::2], strict=True) if high - low >= width]
        along = frame(scene, near, wall).seen(pose.at)[0]
        return min(free, key=lambda s: max(s[0] + width / 2 - along, along - s[1] + width / 2), default=(-half, half))

    def _size(self, scene: Scene) -> tuple[float, float, float]:
        return scene.by_name[self.a.name].size
