"""How a thing stands at another one, and what it has in front of it."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.assets import Surface

AIM = 0.06
"""Metres above the least gap that a statement allows at which things are put side by side, if it allows as much."""

DEMANDED = 2.0
"""Weight of looking at something, where that is demanded."""


@dataclass(frozen=True)
class Joining:
    """How a thing stands at another."""

    slot: str  # "beside", "flank", "front", "behind", "around", "under", "on" or "setting"
    gap: float = AIM  # metres between the two boxes
    yaw: float | None = None  # radians between the two fronts; None where nothing says
    side: str = ""  # the side of the other thing, where it is said
    at: str = ""  # where on a top: its halves as `toward` names them; for a setting its place beside the plate
    seat: str = ""  # who a setting is laid for
    tops: tuple[Surface, ...] = ()  # the places of the other thing on which it may lie, the best first


BELOW = Joining("under")
"""How a thing stands below another."""


@dataclass(frozen=True)
class Facing:
    """What a thing should have in front of it."""

    names: tuple[str, ...]  # the things, the nearest counts
    away: bool = False  # whether its back looks there
    distance: tuple[float, float] = (0.0, 20.0)  # lowest and highest distance of centres in metres
    weight: float = DEMANDED  # how much it matters
