"""`next_to`: a thing stands close beside another."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import argument
from robolayout.constraints._sides import SIDES, BySide


@dataclass(frozen=True)
class NextTo(BySide):
    """`a` stands close to `b` on a `side` of it ("beside" is left or right), `min_gap` to `max_gap` m from edge to edge."""

    name = "next_to"
    example = 'solver.next_to(night_stand[0], bed[0], "left")'

    a: AssetRef = argument("asset")
    b: AssetRef = argument("asset")
    side: str = argument("text", choices=SIDES, default="beside")
    max_gap: float = argument("number", unit="m", default=0.3)
    min_gap: float = argument("number", unit="m", default=0.0)
