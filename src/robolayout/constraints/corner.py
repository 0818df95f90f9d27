"""`corner`: a thing stands in a corner of the room."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from robolayout.constraints._exact import TOLERANCE, footprint, frame, seen_from, shape
from robolayout.constraints._refs import AssetRef, WallRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, Way, argument
from robolayout.scene import Layout, Room, Scene


def convex_corners(room: Room) -> tuple[int, ...]:
    """Return the vertices at which the room's inner angle is below 180 degrees."""
    walls = room.walls
    return tuple(
        i
        for i, wall in enumerate(walls)
        if walls[i - 1].direction[0] * wall.direction[1] - walls[i - 1].direction[1] * wall.direction[0] > 1e-6
    )


@dataclass(frozen=True)
class Corner(Relation):
    """`a` stands in a corner of the room, close to both walls; `vertex` picks the corner, None takes the nearest one."""

    name = "corner"
    example = "solver.corner(plant[0])"

    a: AssetRef = argument("asset")
    vertex: int | None = argument("integer", "none", default=None)

    def fault(self, scene: Scene) -> str:
        """Refuse a vertex that is no inner corner of the room."""
        corners = convex_corners(scene.room)
        if self.vertex is None or self.vertex in corners:
            return ""
        return f"vertex {self.vertex} is no corner to stand in; this room has {', '.join(map(str, corners))}"

    def ways(self, scene: Scene) -> tuple[Way, ...]:
        """Return one for each corner where the program names none."""
        return tuple((replace(self, vertex=i),) for i in convex_corners(scene.room)) if self.vertex is None else ()

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row per wall of the corner: the near side close to it."""
        vertex = self.vertex
        if vertex is None:
            pose = near[self.a.name]
            vertex = min(convex_corners(scene.room), key=lambda i: math.dist(scene.room.vertices[i], (pose.x, pose.y)))
        close = Interval(0.0, TOLERANCE.corner / 3, 1.0, -1.0)
        half = [scene.room.walls[i].length / 2 for i in (vertex - 1, vertex)]
        count = len(scene.room.walls)
        return tuple(
            FrameTerm(self.a, WallRef(i % count), along=Interval(-h, h, 1.0, 1.0), across=close)
            for i, h in zip((vertex - 1, vertex), half, strict=True)
        )

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Within 15 cm of both walls of one inner corner, and at most 5 cm into them."""
        vertices = convex_corners(scene.room) if self.vertex is None else (self.vertex,)
        gap, depth = min(self._measured(vertex, scene, layout) for vertex in vertices)
        text = f"{gap:.2f} m from the walls of its corner" + (f", {depth:.2f} m into them" if depth > 0.0 else "")
        if depth > TOLERANCE.gap:
            return Outcome(False, depth, TOLERANCE.gap, "m", text)
        return Outcome.at_most(TOLERANCE.corner, gap, "m", text)

    def _measured(self, vertex: int, scene: Scene, layout: Layout) -> tuple[float, float]:
        """Return how far it is from the farther wall of a corner, and how far it reaches through one of them, in metres."""
        body, count = footprint(scene, layout, self.a), len(scene.room.walls)
        walls = [WallRef(i % count) for i in (vertex - 1, vertex)]
        gap = max(shape(scene, layout, wall).distance(body) for wall in walls)
        return gap, max(0.0, *(-seen_from(frame(scene, layout, wall), body).bounds[1] for wall in walls))
