"""`keep_clear`: the floor before one side of a thing stays free."""

from __future__ import annotations

import math
from dataclasses import dataclass

from shapely import Polygon

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
        here, (low, high) = layout[self.a.name], strip_span(scene, layout, self.a)
        strip = Polygon([here.point(x + i * hx, y + j * hy) for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))])
        middle, reach, aside = here.point(x, y), math.hypot(hx, hy), {self.a.name, *self._aside(scene)}
        taken = dict[str, float]()
        for asset in scene.assets:
            if asset.is_flat or asset.name not in layout or asset.name in aside:
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
