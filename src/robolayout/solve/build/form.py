"""What a cluster fills of the floor and which strips beside it want to stay clear, in its own frame."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray

from robolayout.floor import Points, placed, rect_points
from robolayout.scene import Scene
from robolayout.solve.build.cluster import Cluster
from robolayout.solve.build.member import Member, Rect, Size, box_of, overlaps
from robolayout.solve.build.wants import Want


@dataclass(frozen=True)
class Strip:
    """A strip before one side of a floor thing, as points in its cluster's frame; one strip of a `group` is enough."""

    group: tuple[str, str]
    points: Points


class Forms:
    """The forms of clusters, each found once.

    Args:
        scene: The scene.
        wants: What is said of every asset.
        corridor: Metres that the agent needs to pass.
    """

    def __init__(self, scene: Scene, wants: Mapping[str, Want], corridor: float) -> None:
        self.scene = scene
        self.wants = wants
        self.corridor = corridor
        self.bodies = cache(self._filled)
        self.strips = cache(self._wanted)

    def on_floor(self, member: Member) -> bool:
        """Whether a member takes floor space."""
        return member.bottom < 0.01 and not self.wants[member.name].laid

    def _filled(self, cluster: Cluster) -> list[tuple[Points, float]]:
        """Return the footprint points and area of every floor member, in the cluster's frame."""
        found: list[tuple[Points, float]] = []
        for member in cluster.members:
            if self.on_floor(member):
                depth, width, _ = self.scene.by_name[member.name].size
                step = 0.12 if depth * width < 1.0 else 0.2
                rect = (-depth / 2, -width / 2, depth / 2, width / 2)
                found.append((at(member, rect_points(rect, 0.022, step)), depth * width))
        return found

    def _wanted(self, cluster: Cluster) -> list[Strip]:
        """Return the strips that the floor members want clear, less what the cluster itself fills."""
        boxes = [box_of(m, self.scene.by_name[m.name].size) for m in cluster.members if self.on_floor(m)]
        found: list[Strip] = []
        for member in cluster.members:
            if not self.on_floor(member):
                continue
            for side, depth, group in self._wishes(self.wants[member.name]):
                rect = side_rect(self.scene.by_name[member.name].size, side, depth)
                points = at(member, rect_points(rect, 0.04, 0.15))
                own = np.zeros(len(points), np.bool_)
                (left, bottom), (right, top) = points.min(0).tolist(), points.max(0).tolist()
                for box in boxes:
                    if overlaps(box, (left, bottom, right, top)):
                        own |= _within(points, box)
                if own.mean() < 0.6:
                    found.append(Strip((member.name, group), points[~own]))
        return found

    def _wishes(self, item: Want) -> list[tuple[str, float, str]]:
        """Return the sides that an asset wants clear, each with its depth in metres and a group of which one is enough."""
        if not item.clear:
            sides = item.asset.use_sides or item.category.use_sides
            front = max(item.category.open_depth, self.corridor)
            return [(side, front if side == "front" else self.corridor, "any") for side in sides]
        return [(side, depth, side) for side, depth in item.clear.items()]


def at(member: Member, points: Points) -> Points:
    """Return points (k, 2) of a member's own frame in the frame it is in."""
    return placed(points, member.x, member.y, member.yaw)


def _within(points: Points, rect: Rect) -> NDArray[np.bool_]:
    x, y = points[:, 0], points[:, 1]
    return (x > rect[0]) & (x < rect[2]) & (y > rect[1]) & (y < rect[3])


def side_rect(size: Size, side: str, depth: float) -> Rect:
    """Return the rectangle of so many metres before one side of a box at the origin."""
    hx, hy = size[0] / 2, size[1] / 2
    return {
        "front": (hx, -hy, hx + depth, hy),
        "back": (-hx - depth, -hy, -hx, hy),
        "left": (-hx, hy, hx, hy + depth),
        "right": (-hx, -hy - depth, hx, -hy),
    }[side]


def corners_of(member: Member, size: tuple[float, float, float]) -> Points:
    """Return the four corners (4, 2) of a member's footprint, counter-clockwise."""
    hx, hy = size[0] / 2, size[1] / 2
    return at(member, np.array([(hx, -hy), (hx, hy), (-hx, hy), (-hx, -hy)]))
