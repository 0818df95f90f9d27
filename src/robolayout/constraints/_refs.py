"""What a statement can be about: an asset, a wall or a fixed point."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, order=True)
class AssetRef:
    """An asset, by its name in the scene ("bed-0")."""

    name: str

    def __str__(self) -> str:
        return self.name


@dataclass(frozen=True, order=True)
class WallRef:
    """A wall, by its index in the room."""

    index: int

    def __str__(self) -> str:
        return f"walls[{self.index}]"


@dataclass(frozen=True, order=True)
class PointRef:
    """A fixed point in metres, world frame; `yaw` (radians) turns the axes of terms in its frame."""

    x: float
    y: float
    z: float = 0.0
    yaw: float = 0.0

    def __str__(self) -> str:
        return f"({self.x:g}, {self.y:g}, {self.z:g})"


Ref = AssetRef | WallRef | PointRef
