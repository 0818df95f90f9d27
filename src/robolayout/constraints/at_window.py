"""`at_window`: a thing stands at a window."""

from __future__ import annotations

from dataclasses import dataclass, replace

from robolayout.constraints._exact import TOLERANCE, footprint, frame, seen_from
from robolayout.constraints._refs import AssetRef, WallRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, Way, argument
from robolayout.scene import Layout, Opening, Scene


@dataclass(frozen=True)
class AtWindow(Relation):
    """`a` stands at a `window` (its number; None: any): its middle before the window, at most 0.3 m from the wall."""

    name = "at_window"
    example = "solver.at_window(desk[0])"

    a: AssetRef = argument("asset")
    window: int | None = argument("integer", "none", default=None)

    def fault(self, scene: Scene) -> str:
        """Refuse a window that the room does not have."""
        count = len(scene.room.windows)
        return "" if (self.window or 0) in range(count) else f"there is no such window: this room has {count}"

    def ways(self, scene: Scene) -> tuple[Way, ...]:
        """Return one for each window where the program names none."""
        return tuple((replace(self, window=i),) for i in range(len(scene.room.windows))) if self.window is None else ()

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row in the frame of the wall with the nearest window."""
        window = min(self._windows(scene), key=lambda one: self._missed(one, scene, near))
        low, high = _span(window, scene)
        return (
            FrameTerm(
                self.a,
                WallRef(window.wall),
                along=Interval(low, high),
                across=Interval(-TOLERANCE.gap, TOLERANCE.window, 1.0, -1.0),
            ),
        )

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """The centre before a window and the near side at most 0.3 m from its wall, with 5 cm of tolerance."""
        missed = min(self._missed(window, scene, layout) for window in self._windows(scene))
        return Outcome.at_most(TOLERANCE.gap, missed, "m", f"{missed:.2f} m off the nearest window")

    def _windows(self, scene: Scene) -> tuple[Opening, ...]:
        return scene.room.windows if self.window is None else (scene.room.windows[self.window],)

    def _missed(self, window: Opening, scene: Scene, layout: Layout) -> float:
        """Return how many metres it lacks to stand at a window."""
        pose, here = layout[self.a.name], frame(scene, layout, WallRef(window.wall))
        low, high = _span(window, scene)
        u, _ = here.seen(pose.at)
        gap = seen_from(here, footprint(scene, layout, self.a)).bounds[1]
        return max(0.0, low - u, u - high, gap - TOLERANCE.window, -gap)


def _span(window: Opening, scene: Scene) -> tuple[float, float]:
    """Return where a window begins and ends along its wall, in metres from the wall's middle."""
    start = window.offset - scene.room.walls[window.wall].length / 2
    return start, start + window.width
