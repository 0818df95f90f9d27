"""`behind`: a thing stands behind the back of another."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.constraints._sides import SideRelation


@dataclass(frozen=True)
class Behind(SideRelation):
    """`a` stands behind `b` (as b sees it), with `min_gap` to `max_gap` m between their edges."""

    name = "behind"
    side = "back"
    example = "solver.behind(floor_lamp[0], armchair[0])"
