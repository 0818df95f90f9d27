"""Implicit `room_to_open`: what has doors or drawers can be opened."""

from __future__ import annotations

from dataclasses import dataclass

from robolayout.assets import category_of, sweeps_of
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import ClearTerm, Outcome, Relation, Term
from robolayout.constraints.keep_clear import region_outcome, strip_span
from robolayout.scene import Asset, Layout, Scene


@dataclass(frozen=True)
class RoomToOpen(Relation):
    """Nothing that stays put stands where doors and drawers open; movable things (chairs) may stand there."""

    name = "room_to_open"
    implicit = True
    example = ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one strip per thing that opens: what holds all that it sweeps."""
        exempt = _movable(scene)
        return tuple(
            ClearTerm(AssetRef(a.name), *_strip(a), strip_span(scene, near, AssetRef(a.name)), exempt, hard=False)
            for a in _opening(scene)
        )

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """At most 0.01 m2 of the footprint of anything that stays put in what any door, drawer or flap sweeps."""
        outcomes = [
            region_outcome(scene, layout, AssetRef(asset.name), sweep.region, heights, _movable(scene))
            for asset in _opening(scene)
            if asset.name in layout
            for sweep in sweeps_of(asset)
            for z in (layout[asset.name].z,)
            for heights in ((z + sweep.heights[0], z + sweep.heights[1]),)
        ]
        return max(outcomes, key=lambda o: o.value, default=Outcome(True, 0.0, 0.0, "m2", "nothing opens"))


def _opening(scene: Scene) -> list[Asset]:
    return [asset for asset in scene.assets if sweeps_of(asset) and not asset.on_ceiling]


def _movable(scene: Scene) -> frozenset[str]:
    return frozenset(asset.name for asset in scene.assets if category_of(asset).movable)


def _strip(asset: Asset) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return centre and half size, in the thing's frame, of the rectangle around what it sweeps."""
    bounds = [sweep.region.bounds for sweep in sweeps_of(asset)]
    (x0, y0), (x1, y1) = (
        tuple(pick(box[i] for box in bounds) for i in axes) for pick, axes in ((min, (0, 1)), (max, (2, 3)))
    )
    return ((x0 + x1) / 2, (y0 + y1) / 2), ((x1 - x0) / 2, (y1 - y0) / 2)
