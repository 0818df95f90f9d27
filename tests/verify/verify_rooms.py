"""Tiny scenes made by hand, so that every expected figure can be worked out on paper."""

from __future__ import annotations

import math

from robolayout.scene import Agent, Asset, Layout, Opening, Pose, Room, Scene

DISC = Agent(name="disc", radius=0.3, height=1.5)
DOOR = Opening(wall=0, offset=1.0, width=0.9, height=2.05)


def square(side: float = 4.0, *, doors: tuple[Opening, ...] = (DOOR,), height: float = 2.6) -> Room:
    return Room(((0.0, 0.0), (side, 0.0), (side, side), (0.0, side)), height, doors)


def thing(name: str, size: tuple[float, float, float], category: str = "thing", **flags: object) -> Asset:
    return Asset(name, category, size, **flags)  # type: ignore[arg-type]


def on_floor(asset: Asset, x: float, y: float, degrees: float = 0.0, *, bottom: float = 0.0) -> Pose:
    return Pose(x, y, bottom + asset.size[2] / 2, math.radians(degrees))


def furnished(
    room: Room, *placed: tuple[Asset, Pose | None], agents: tuple[Agent, ...] = (DISC,)
) -> tuple[Scene, Layout]:
    scene = Scene(room, tuple(asset for asset, _ in placed), agents=agents)
    return scene, Layout({asset.name: pose for asset, pose in placed if pose is not None})
