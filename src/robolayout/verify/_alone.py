"""What a body cannot use wherever it stands: a thing by itself in the middle of an empty room."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

from robolayout.scene import Agent, Asset, Layout, Opening, Pose, Room, Scene
from robolayout.verify.limits import FINE
from robolayout.verify.use import usage


def unusable_alone(asset: Asset, agent: Agent) -> str:
    """Return why a body cannot use a thing that stands on the floor, with nothing around it; empty where it can."""
    return _reason(replace(asset, name="it", description=""), replace(agent, turning_radius=None))


@lru_cache(maxsize=1024)
def _reason(asset: Asset, agent: Agent) -> str:
    half = max(asset.size[:2]) / 2 + 2 * agent.circumradius + agent.reach + FINE.spare
    door = Opening(0, half - agent.radius - 0.1, 2 * agent.radius + 0.2, agent.height + 0.1)
    room = Room(((0.0, 0.0), (2 * half, 0.0), (2 * half, 2 * half), (0.0, 2 * half)), agent.height + 1.0, (door,))
    layout = Layout({asset.name: Pose(half, half, asset.size[2] / 2, 0.0)})
    found = usage(Scene(room, (asset,)).with_agents(agent), layout, agent)
    return "" if found.usable[asset.name] else found.uses[asset.name].reason
