"""`right_of`: a thing stands at the right hand of another."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._sides import SideRelation


@dataclass(frozen=True)
class RightOf(SideRelation):
    """`a` stands on the right of `b` (as b sees it), with `min_gap` to `max_gap` m between their edges."""

    name = "right_of"
    side = "right"
    example = "solver.right_of(knife[0], plate[0], 0.0, 0.1)"
