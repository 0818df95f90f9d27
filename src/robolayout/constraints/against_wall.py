"""`against_wall`: the back of a thing stands at a wall."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from robolayout.constraints._exact import TOLERANCE, angle_between, footprint, frame, seen_from
from robolayout.constraints._refs import AssetRef, WallRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, Way, argument, best_way
from robolayout.scene import Layout, Scene


def wall_term(a: AssetRef, wall: WallRef, scene: Scene, weight: float) -> FrameTerm:
    """Return the row for "a's back touches the wall, within its ends, and a faces into the room"."""
    half = scene.room.walls[wall.index].length / 2
    return FrameTerm(
        a,
        wall,
        along=Interval(-half, half, 1.0, 1.0),
        across=Interval(0.0, 0.0, 1.0, -1.0),
        heading=math.pi / 2,
        weight=weight,
    )


def wall_outcome(a: AssetRef, wall: WallRef, scene: Scene, layout: Layout) -> Outcome:
    """Measure how far a's back edge is from the wall's line and its front from the inward normal."""
    segment = scene.room.walls[wall.index]
    pose = layout[a.name]
    depth = scene.by_name[a.name].size[0]
    back = (pose.x - depth / 2 * pose.forward[0], pose.y - depth / 2 * pose.forward[1])
    gap = abs(frame(scene, layout, wall).seen(back)[1])
    turned = angle_between(pose.yaw, math.atan2(segment.normal[1], segment.normal[0]))
    left, _, right, _ = seen_from(frame(scene, layout, wall), footprint(scene, layout, a)).bounds
    overlaps = left < segment.length / 2 and right > -segment.length / 2
    met = gap <= TOLERANCE.gap and turned <= TOLERANCE.angle and overlaps
    text = f"back edge {gap:.2f} m from {wall}, front {turned:.0f} deg off" + ("" if overlaps else ", beside the wall")
    return Outcome(met, gap, TOLERANCE.gap, "m", text)


@dataclass(frozen=True)
class AgainstWall(Relation):
    """The back of `a` stands at `wall` (None: any wall) and `a` faces into the room; `weight` says how much it matters."""

    name = "against_wall"
    orients = True
    surrogate = True  # its whole width stays within the ends of the wall, where the check wants some of it
    example = "solver.against_wall(bed[0], walls[2])"

    a: AssetRef = argument("asset")
    wall: WallRef | None = argument("wall", "none", default=None)
    weight: float = argument("number", default=1.0)

    def ways(self, scene: Scene) -> tuple[Way, ...]:
        """Return one for each wall where the program names none, of those that are wide enough for it if any is."""
        if self.wall is not None:
            return ()
        walls, width = scene.room.walls, scene.by_name[self.a.name].size[1]
        able = [wall for wall in walls if wall.length >= width] or walls
        return tuple((replace(self, wall=WallRef(wall.index)),) for wall in able)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row in the wall's frame."""
        if self.wall is None:
            return best_way(self.ways(scene), scene, near)[0][0].terms(scene, near)
        return (wall_term(self.a, self.wall, scene, self.weight),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Within 5 cm of the wall's line, over its segment, front within 10 degrees of its inward normal."""
        if self.wall is None:
            return best_way(self.ways(scene), scene, layout)[1]
        return wall_outcome(self.a, self.wall, scene, layout)
