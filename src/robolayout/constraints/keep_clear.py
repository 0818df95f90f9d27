"""`keep_clear`: the floor before one side of a thing stays free."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

from shapely import box
from shapely.affinity import rotate, translate
from shapely.geometry.base import BaseGeometry

from robolayout.constraints._exact import TOLERANCE, common_area, footprint, half_size
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import ClearTerm, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene, vertical_span


def side_box(half: tuple[float, float], side: str, depth: float) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return centre and half size, in the owner's frame, of the strip `depth` metres deep before one side."""
    hx, hy = half
    if side in ("front", "back"):
        return ((math.copysign(hx + depth / 2, 1 if side == "front" else -1), 0.0), (depth / 2, hy))
    return ((0.0, math.copysign(hy + depth / 2, 1 if side == "left" else -1)), (hx, depth / 2))


@dataclass(frozen=True)
class KeepClear(Relation):
    """The strip `depth` m deep before one `side` of `a` stays free of other things that stand at its height."""

    name = "keep_clear"
    example = 'solver.keep_clear(wardrobe[0], "front", 0.7)'

    a: AssetRef = argument("asset")
    side: str = argument("text", choices=("front", "back", "left", "right"), default="front")
    depth: float = argument("number", unit="m", default=0.6)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one strip in a's frame."""
        center, half = side_box(half_size(scene, self.a), self.side, self.depth)
        return (ClearTerm(self.a, center, half, strip_span(scene, near, self.a), hard=False),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """At most 0.01 m2 of other footprints (rugs aside) in the strip."""
        return strip_outcome(scene, layout, self.a, side_box(half_size(scene, self.a), self.side, self.depth))


def strip_span(scene: Scene, layout: Layout, owner: AssetRef) -> tuple[float, float]:
    """Return between which heights in metres a thing's strip is to be free: its own, a threshold of 2 cm aside."""
    low, high = vertical_span(scene.by_name[owner.name], layout[owner.name])
    return (low + 0.02, high)


def strip_outcome(
    scene: Scene,
    layout: Layout,
    owner: AssetRef,
    place: tuple[tuple[float, float], tuple[float, float]],
    exempt: Collection[str] = (),
) -> Outcome:
    """Return how much of a strip, given by centre and half size in its owner's frame, is taken by the worst thing."""
    (x, y), (hx, hy) = place
    return region_outcome(
        scene, layout, owner, box(x - hx, y - hy, x + hx, y + hy), strip_span(scene, layout, owner), exempt
    )


def region_outcome(
    scene: Scene,
    layout: Layout,
    owner: AssetRef,
    region: BaseGeometry,
    heights: tuple[float, float],
    exempt: Collection[str] = (),
) -> Outcome:
    """Return how much of a region in its owner's frame, between two heights of the room, is taken by the worst thing."""
    pose = layout[owner.name]
    strip = translate(rotate(region, pose.yaw, origin=(0, 0), use_radians=True), pose.x, pose.y)
    low, high = heights
    taken, culprit = 0.0, ""
    for asset in scene.assets:
        if asset.name == owner.name or asset.is_flat or asset.name not in layout or asset.name in exempt:
            continue
        bottom, top = vertical_span(asset, layout[asset.name])
        area = common_area(strip, footprint(scene, layout, AssetRef(asset.name)))
        if area > taken and bottom < high and top > low:
            taken, culprit = area, asset.name
    text = f"{taken:.2f} m2 of {culprit} in the strip" if taken > TOLERANCE.strip else "free"
    return Outcome(taken <= TOLERANCE.strip, taken, TOLERANCE.strip, "m2", text)
