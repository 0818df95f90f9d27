"""What stands in the way of a body."""

from __future__ import annotations

from robolayout.scene import Agent, Asset


def blocks(asset: Asset, z: float, agent: Agent) -> bool:
    """Return whether an asset whose box centre is `z` metres high intersects what the agent sweeps, [step, height].

    Flat rugs never do (DESIGN section 7).
    """
    low, high = z - asset.size[2] / 2, z + asset.size[2] / 2
    return not asset.is_flat and low < agent.height and high > agent.step
