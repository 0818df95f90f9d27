"""What stands in the way of a body, and from where it is used."""

from __future__ import annotations

from functools import cache

from robolayout.assets.lexicon import category_of
from robolayout.scene import Agent, Asset


@cache
def use_sides(asset: Asset) -> tuple[str, ...]:
    """Return the sides an asset is used from; empty where any side will do (a chair) or none is needed (a picture)."""
    if asset.use_sides is not None:
        return tuple(asset.use_sides)
    category = category_of(asset)
    return () if category.movable else tuple(category.use_sides)


def blocks(asset: Asset, z: float, agent: Agent) -> bool:
    """Return whether an asset whose box centre is `z` metres high intersects what the agent sweeps, [step, height].

    Flat rugs never do (DESIGN section 7).
    """
    low, high = z - asset.size[2] / 2, z + asset.size[2] / 2
    return not asset.is_flat and low < agent.height and high > agent.step
