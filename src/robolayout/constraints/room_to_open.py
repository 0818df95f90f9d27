"""Implicit `room_to_open`: what has doors or drawers can be opened."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from robolayout.assets import category_of
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import Outcome, Relation
from robolayout.constraints._terms import ClearTerm, Term
from robolayout.constraints.keep_clear import side_box, strip_outcome, strip_span
from robolayout.scene import Asset, Layout, Scene


@dataclass(frozen=True)
class RoomToOpen(Relation):
    """Nothing that stays put stands where doors and drawers open; movable things (chairs) may stand there."""

    name: ClassVar[str] = "room_to_open"
    implicit: ClassVar[bool] = True
    example: ClassVar[str] = ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one strip per thing that opens."""
        exempt = _movable(scene)
        return tuple(
            ClearTerm(AssetRef(a.name), *_strip(a), strip_span(scene, near, AssetRef(a.name)), exempt, hard=False)
            for a in _opening(scene)
        )

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """At most 0.01 m2 of the footprint of anything that stays put in any strip."""
        outcomes = [
            strip_outcome(scene, layout, AssetRef(asset.name), _strip(asset), _movable(scene))
            for asset in _opening(scene)
            if asset.name in layout
        ]
        return max(outcomes, key=lambda o: o.value, default=Outcome(True, 0.0, 0.0, "m2", "nothing opens"))


def _opening(scene: Scene) -> list[Asset]:
    return [asset for asset in scene.assets if category_of(asset).open_depth > 0 and not asset.on_ceiling]


def _movable(scene: Scene) -> frozenset[str]:
    return frozenset(asset.name for asset in scene.assets if category_of(asset).movable)


def _strip(asset: Asset) -> tuple[tuple[float, float], tuple[float, float]]:
    return side_box((asset.size[0] / 2, asset.size[1] / 2), "front", category_of(asset).open_depth)
