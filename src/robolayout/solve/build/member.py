"""One asset of a cluster, in the cluster's frame."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from shapely import Polygon

from robolayout.scene import Pose

Poses = NDArray[np.float64]
"""(n, 3) metres and radians."""

Size = tuple[float, float, float]
Rect = tuple[float, float, float, float]
"""Smallest x, smallest y, largest x, largest y in metres."""

MARGIN = 0.02
"""Metres left between neighbours, so that rounding never makes them touch."""


@dataclass(frozen=True)
class Member:
    """One asset of a cluster."""

    name: str  # the asset
    x: float = 0.0  # metres, of its centre
    y: float = 0.0
    yaw: float = 0.0  # radians
    bottom: float = 0.0  # metres above what the anchor stands on
    side: str = ""  # side of the thing it joins ("left", "right", "front", "back", "")

    def moved(self, x: float, y: float, yaw: float) -> Member:
        """Return the member after the frame it is in was put at (x, y, yaw) of another frame."""
        c, s = math.cos(yaw), math.sin(yaw)
        return replace(self, x=x + c * self.x - s * self.y, y=y + s * self.x + c * self.y, yaw=self.yaw + yaw)

    def everywhere(self, poses: Poses) -> Poses:
        """Return its poses (n, 3) where the frame it is in has these (n, 3)."""
        x, y, yaw = poses.T
        c, s = np.cos(yaw), np.sin(yaw)
        return np.column_stack([x + c * self.x - s * self.y, y + s * self.x + c * self.y, yaw + self.yaw])

    def mirrored(self) -> Member:
        """Return its image left to right."""
        side = {"left": "right", "right": "left"}.get(self.side, self.side)
        return replace(self, y=-self.y, yaw=-self.yaw, side=side)


@dataclass(frozen=True)
class GridPlan:
    """A block of equal clusters in rows."""

    names: tuple[str, ...]  # anchors, row by row
    rows: int  # number of rows
    columns: int  # number of columns
    aisle: float  # metres between the boxes of one row and the next
    gap: float  # metres between neighbours in a row
    # whether every second row is turned: back to back with the one before ("paired") or "facing" it
    backs: str = "alike"
    tight: bool = False  # whether neighbours stand closer than they should
    central: float = 0.0  # metres between the left and the right half of each row
    cells: tuple[tuple[float, float, float], ...] = ()  # where they stand as seen from the first, if in no rows


def box_of(member: Member, size: Size) -> Rect:
    """Return the upright bounds of a member's footprint in its cluster's frame."""
    c, s = abs(math.cos(member.yaw)), abs(math.sin(member.yaw))
    hx, hy = (c * size[0] + s * size[1]) / 2, (s * size[0] + c * size[1]) / 2
    return (member.x - hx, member.y - hy, member.x + hx, member.y + hy)


def outline_of(member: Member, size: Size) -> Polygon:
    """Return a member's footprint in its cluster's frame."""
    return Polygon(Pose(member.x, member.y, 0.0, member.yaw).corners(size))


def overlaps(a: Rect, b: Rect, margin: float = 0.0) -> bool:
    """Whether two rectangles come closer than `margin`."""
    return a[0] < b[2] + margin and b[0] < a[2] + margin and a[1] < b[3] + margin and b[1] < a[3] + margin
