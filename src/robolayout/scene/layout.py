"""Where everything stands: poses of box centres, and the record of how a solver got there."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace

from robolayout._errors import among
from robolayout._reading import LIMITS
from robolayout.scene.asset import Asset


@dataclass(frozen=True)
class Pose:
    """Where one asset's box centre is and which way it faces."""

    x: float
    y: float
    z: float  # metres, of the box centre
    yaw: float  # radians counter-clockwise about z; 0 faces +x

    @property
    def is_finite(self) -> bool:
        """Whether every coordinate is a number, and none larger than a layout file may give."""
        return all(abs(value) <= LIMITS.farthest for value in (self.x, self.y, self.z, self.yaw))

    @property
    def at(self) -> tuple[float, float]:
        """Its place in plan, metres."""
        return (self.x, self.y)

    @property
    def forward(self) -> tuple[float, float]:
        """Unit vector of the front, in plan."""
        return (math.cos(self.yaw), math.sin(self.yaw))

    def point(self, ahead: float, left: float) -> tuple[float, float]:
        """Return the point so many metres ahead of it and to its left, in the room."""
        c, s = self.forward
        return (self.x + c * ahead - s * left, self.y + s * ahead + c * left)

    def seen(self, at: tuple[float, float]) -> tuple[float, float]:
        """Return how many metres ahead of it and to its left a point of the room is."""
        (c, s), dx, dy = self.forward, at[0] - self.x, at[1] - self.y
        return (c * dx + s * dy, c * dy - s * dx)

    def corners(self, size: tuple[float, float, float]) -> tuple[tuple[float, float], ...]:
        """Return the four footprint corners of a box of `size` at this pose, counter-clockwise."""
        c, s = self.forward
        hx, hy = size[0] / 2, size[1] / 2
        local = ((hx, -hy), (hx, hy), (-hx, hy), (-hx, -hy))
        return tuple((self.x + c * px - s * py, self.y + s * px + c * py) for px, py in local)


@dataclass(frozen=True)
class Layout(Mapping[str, Pose]):
    """Poses by asset name; assets without a pose are unplaced."""

    poses: Mapping[str, Pose]

    def __getitem__(self, name: str) -> Pose:
        return self.poses[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.poses)

    def __len__(self) -> int:
        return len(self.poses)

    def moved(self, name: str, *, by: tuple[float, float] = (0.0, 0.0), turn: float = 0.0) -> Layout:
        """Return the same layout with one asset `by` metres along x and y, and turned counter-clockwise by `turn` degrees.

        What stands on it stays (`generate(start=...)` mends that).
        """
        among("asset in the layout", [name], self.poses)
        pose = self.poses[name]
        there = replace(pose, x=pose.x + by[0], y=pose.y + by[1], yaw=pose.yaw + math.radians(turn))
        return Layout({**self.poses, name: there})

    def __repr__(self) -> str:
        rows = (f"{n}: ({p.x:.2f}, {p.y:.2f}, {p.z:.2f}) {math.degrees(p.yaw):.0f} deg" for n, p in self.items())
        return f"Layout({'; '.join(rows)})"

    def _repr_html_(self) -> str:
        """Return the poses as a table, for notebooks."""
        from robolayout._text import table

        rows = [
            [name, f"{p.x:.3f}", f"{p.y:.3f}", f"{p.z:.3f}", f"{math.degrees(p.yaw) % 360:.1f}"]
            for name, p in self.items()
        ]
        return table(["asset", "x (m)", "y (m)", "z (m)", "yaw (degrees)"], rows)

    def to_dict(self) -> dict[str, dict[str, list[float]]]:
        """Return the content of `layout.json`: metres and degrees, rounded to 1e-6."""
        return {
            name: {
                "position": [round(float(value), 6) + 0.0 for value in (pose.x, pose.y, pose.z)],
                "rotation": [0.0, 0.0, round(math.degrees(pose.yaw) % 360.0, 6) % 360.0 + 0.0],
            }
            for name, pose in self.items()
        }


def vertical_span(asset: Asset, pose: Pose) -> tuple[float, float]:
    """Return the heights in metres of the bottom and the top of an asset's box."""
    return (pose.z - asset.size[2] / 2, pose.z + asset.size[2] / 2)


@dataclass(frozen=True)
class Snapshot:
    """The layout at one moment of the search."""

    step: int  # step counted from the start of the run
    stage: str  # what was running ("search", "routes", "repair", ...)
    poses: Mapping[str, tuple[float, float, float]]  # (x, y, yaw) by asset name, metres and radians


@dataclass(frozen=True)
class Trace:
    """How a run went: loss terms per step and a few snapshots."""

    # one mapping of loss terms per step; terms may be absent (DESIGN section 6)
    losses: tuple[Mapping[str, float], ...] = ()
    snapshots: tuple[Snapshot, ...] = field(default=())  # the layout every few steps, in order
