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


@dataclass(frozen=True)
class KeepClear(Relation):
    """The strip `depth` m deep before one `side` of `a` stays free of other things at its height, those `besides` aside."""

    name = "keep_clear"
    example = 'solver.keep_clear(wardrobe[0], "front", 0.7)'

    a: AssetRef = argument("asset")
    side: str = argument("text", choices=("front", "back", "left", "right"), default="front")
    depth: float = argument("number", unit="m", default=0.6)
    besides: tuple[AssetRef, ...] = argument("asset", many=True, default=())

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one strip in a's frame."""
        center, half = self._strip(scene)
        return (ClearTerm(self.a, center, half, strip_span(scene, near, self.a), self._aside(scene), hard=False),)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """At most 0.01 m2 of other footprints (rugs aside) in the strip."""
        (x, y), (hx, hy) = self._strip(scene)
        strip = box(x - hx, y - hy, x + hx, y + hy)
        return region_outcome(scene, layout, self.a, strip, strip_span(scene, layout, self.a), self._aside(scene))

    def _aside(self, scene: Scene) -> frozenset[str]:
        """Return the names of what may stand there, with what only stands on other things: its bearer is counted, or may be there."""
        borne = (asset.name for asset in scene.assets if asset.on_object and not asset.on_floor)
        return frozenset((*(ref.name for ref in self.besides), *borne)) if self.besides else frozenset()

    def _strip(self, scene: Scene) -> tuple[tuple[float, float], tuple[float, float]]:
        """Return its centre and half its size in a's frame."""
        (hx, hy), sign = half_size(scene, self.a), 1 if self.side in ("front", "left") else -1
        if self.side in ("front", "back"):
            return (sign * (hx + self.depth / 2), 0.0), (self.depth / 2, hy)
        return (0.0, sign * (hy + self.depth / 2)), (hx, self.depth / 2)


def strip_span(scene: Scene, layout: Layout, owner: AssetRef) -> tuple[float, float]:
    """Return between which heights in metres a thing's strip is to be free: its own, a threshold of 2 cm aside."""
    low, high = vertical_span(scene.by_name[owner.name], layout[owner.name])
    return (low + 0.02, high)


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
    x0, y0, x1, y1 = strip.bounds
    middle, reach = ((x0 + x1) / 2, (y0 + y1) / 2), math.hypot(x1 - x0, y1 - y0) / 2
    low, high = heights
    taken = dict[str, float]()
    for asset in scene.assets:
        if asset.name == owner.name or asset.is_flat or asset.name not in layout or asset.name in exempt:
            continue
        bottom, top = vertical_span(asset, layout[asset.name])
        far = math.dist(middle, layout[asset.name].at) > reach + math.hypot(*asset.size[:2]) / 2
        if far or bottom >= high or top <= low:
            continue
        taken[asset.name] = common_area(strip, footprint(scene, layout, AssetRef(asset.name)))
    blamed = tuple(name for name, area in taken.items() if area > TOLERANCE.strip)
    worst = max(blamed, key=taken.__getitem__, default="")
    text = f"{taken[worst]:.2f} m2 of {worst} in the strip" if blamed else "free"
    return Outcome(not blamed, max(taken.values(), default=0.0), TOLERANCE.strip, "m2", text, blamed)
