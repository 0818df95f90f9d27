"""`in_front_of`: a thing stands before the front of another."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._sides import SideRelation


@dataclass(frozen=True)
class InFrontOf(SideRelation):
    """`a` stands in front of `b` (as b sees it), with `min_gap` to `max_gap` m between their edges."""

    name = "in_front_of"
    side = "front"
    example = "solver.in_front_of(coffee_table[0], sofa[0], 0.3, 0.5)"
