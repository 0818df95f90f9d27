"""What stands in the way of a body, as the solver sees it, and from where it is used.

The judge in `verify` works out for itself what stands in the way; a law test holds the two together.
"""

from __future__ import annotations

from functools import cache, lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout.assets.lexicon import category_of
from robolayout.assets.prisms import prisms_of
from robolayout.scene import ROUNDING, Agent, Asset

SOLID = 0.9  # share of a box's footprint from which on its prisms count as the whole box
Pieces = NDArray[np.float64]
"""(m, 4): how far a rectangle's middle lies ahead and left of its asset's, half its depth, half its width; metres."""


@cache
def use_sides(asset: Asset) -> tuple[str, ...]:
    """Return the sides an asset is used from; empty where any side will do (a chair) or none is needed (a picture)."""
    if asset.use_sides is not None:
        return tuple(asset.use_sides)
    category = category_of(asset)
    return () if category.movable else tuple(category.use_sides)


def only_seen(asset: Asset) -> bool:
    """Return whether an asset hangs on a wall to be looked at (a picture, a clock), so that nobody needs to get to it."""
    return asset.on_wall and not (asset.on_floor or asset.on_object or asset.use_sides) and category_of(asset).only_seen


def blocks(asset: Asset, z: float, agent: Agent) -> bool:
    """Return whether an asset whose box centre is `z` metres high intersects what the agent sweeps, [step, height]."""
    low, high = z - asset.size[2] / 2, z + asset.size[2] / 2
    return not asset.is_flat and low < agent.height and high > agent.step


def pieces(asset: Asset, z: float, agent: Agent) -> tuple[Pieces, bool]:
    """Return what of an asset stands in a body's way, and whether the body may come under or into its box."""
    whole = np.array([[0.0, 0.0, asset.size[0] / 2, asset.size[1] / 2]])
    if not blocks(asset, z, agent):
        return whole[:0], False
    bottom = z - asset.size[2] / 2
    found = _met(asset, round(agent.step - bottom, 6), round(agent.height - bottom, 6))
    return (whole, False) if found is None else (found, True)


@lru_cache(maxsize=4096)
def _met(asset: Asset, low: float, high: float) -> Pieces | None:
    """Return the prisms of an asset between two heights above its bottom; None where they are as good as its box."""
    met = [p for p in prisms_of(asset) if p.high - low > ROUNDING and high - p.low > ROUNDING]
    bounds = np.array([(p.x - p.hx, p.y - p.hy, p.x + p.hx, p.y + p.hy) for p in met]).reshape(-1, 4)
    boxes = shapely.box(*np.unique(bounds, axis=0).T)
    kept = boxes[shapely.covers(boxes[:, None], boxes).sum(axis=0) == 1]
    if shapely.union_all(kept).area >= SOLID * asset.size[0] * asset.size[1]:
        return None
    least, most = np.split(shapely.bounds(kept), 2, axis=1)
    return np.hstack([(least + most) / 2, (most - least) / 2])
