"""`left_of`: a thing stands at the left hand of another."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._sides import SideRelation


@dataclass(frozen=True)
class LeftOf(SideRelation):
    """`a` stands on the left of `b` (as b sees it), with `min_gap` to `max_gap` m between their edges."""

    name = "left_of"
    side = "left"
    example = "solver.left_of(fork[0], plate[0], 0.0, 0.1)"
