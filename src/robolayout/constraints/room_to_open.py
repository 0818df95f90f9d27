"""Implicit `room_to_open`: what has doors or drawers can be opened."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import ClassVar

from robolayout.assets import Category, category_of
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation
from robolayout.constraints._terms import ClearTerm, Term
from robolayout.constraints.keep_clear import KeepClear, side_box
from robolayout.scene import Asset, Layout, Scene, vertical_span


@cache
def _category(asset: Asset) -> Category:
    """Return an asset's category; its words are looked up once."""
    return category_of(asset)


@dataclass(frozen=True)
class RoomToOpen(Relation):
    """Nothing that stays put stands where doors and drawers open; movable things (chairs) may stand there."""

    name: ClassVar[str] = "room_to_open"
    implicit: ClassVar[bool] = True
    surrogate: ClassVar[bool] = True
    example: ClassVar[str] = ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one strip per thing that opens."""
        exempt = frozenset(asset.name for asset in scene.assets if _category(asset).movable)
        rows: list[Term] = []
        for asset in self._opening(scene):
            low, high = vertical_span(asset, near[asset.name])
            center, half = side_box((asset.size[0] / 2, asset.size[1] / 2), "front", _category(asset).open_depth)
            rows.append(ClearTerm(AssetRef(asset.name), center, half, (low + 0.02, high), exempt, hard=False))
        return tuple(rows)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """At most 0.01 m2 of any footprint in any strip (movable things counted, so a surrogate)."""
        outcomes = [
            KeepClear(AssetRef(asset.name), "front", _category(asset).open_depth).check(scene, layout)
            for asset in self._opening(scene)
            if asset.name in layout
        ]
        return max(outcomes, key=lambda o: o.value, default=Outcome(True, 0.0, 0.0, "m2", "nothing opens"))

    def _opening(self, scene: Scene) -> list[Asset]:
        return [asset for asset in scene.assets if _category(asset).open_depth > 0 and not asset.on_ceiling]
