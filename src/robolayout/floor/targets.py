"""Targets: what a body must get to, and what of it tells from where it is within reach, by the rules of the judge.

A thing is used from beyond one of its sides, within reach at its height; what is carried or moved about, and what needs no use,
counts from all around. The judge in `verify` works all this out for itself; a law test holds the two together.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robolayout.assets import category_of
from robolayout.assets.obstacles import only_seen
from robolayout.floor.cells import Floats
from robolayout.scene import Agent, Asset, Scene
from robolayout.scene.agent import BODY, horizontal_reach
from robolayout.scene.asset import FLAT_HEIGHT

SIDES = ("front", "left", "back", "right")
"""Order of the sides of a target."""


@dataclass(frozen=True, eq=False)
class RoomContents:
    """What a room holds, but not where: the same in every layout of a problem."""

    scene: Scene  # the room, its things and its bodies
    parent: tuple[int, ...]  # index of what carries each thing; -1 where it is the room
    heights: Floats  # (n,) height of each box's centre in metres
    half: Floats  # (n, 2) half depth and half width in metres


@dataclass(frozen=True, eq=False)
class Targets:
    """What a body must get to, the same in every layout of a problem."""

    slots: NDArray[np.intp]  # (k,) what
    reach: Floats  # (k,) metres in plan within which the body's centre must come
    sides: NDArray[np.bool_]  # (k, 4) beyond which sides; none where it counts from all around
    # (k,) slot of what carries it higher than the body, so that nobody takes it from below; -1 where none
    carrier: NDArray[np.intp]
    chairs: NDArray[np.intp]  # (c,) slots that this body moves away from what they stand at
    parent: NDArray[np.intp]  # (n,) slot that carries each slot; -1 where none
    half: Floats  # (n, 2) half depth and half width of each slot in metres


def use_of(asset: Asset, bottom: float, agent: Agent, *, carried: bool) -> tuple[float, tuple[str, ...]] | None:
    """Return how near in plan a body's centre must come to use a thing, and beyond which sides of it.

    No sides where it is used from all around; None where no use is asked of it, or it is out of the body's height. Its
    bottom is `bottom` metres above the floor.
    """
    kind = category_of(asset)
    asked = kind.use_sides if asset.use_sides is None else asset.use_sides
    reach = horizontal_reach(agent, bottom, bottom + asset.size[2]) if asked else None
    return None if reach is None else (reach, () if carried or kind.movable else tuple(asked))


def targets_of(contents: RoomContents, agent: Agent) -> Targets:
    """Return what a body must get to; rugs, pictures and what hangs from the ceiling need no reaching.

    A body with an arm moves chairs away: movable things that stand on the floor and carry nothing.
    """
    assets, parent = contents.scene.assets, np.array(contents.parent, dtype=np.intp)
    rise = np.array([asset.size[2] for asset in assets]) / 2
    bottom, top = contents.heights - rise, contents.heights + rise
    slots = np.array(
        [i for i, a in enumerate(assets) if not (a.is_flat or a.on_ceiling or only_seen(a))], dtype=np.intp
    )
    reach, sides = np.full(len(slots), agent.reach), np.zeros((len(slots), len(SIDES)), dtype=np.bool_)
    for row, slot in enumerate(slots.tolist()):
        use = use_of(assets[slot], float(bottom[slot]), agent, carried=bool(parent[slot] >= 0))
        if use is not None:
            reach[row] = max(use[0], agent.radius + BODY.touch)  # nearer than that no disc is asked to come
            sides[row] = [side in use[1] for side in SIDES]
    under = parent[slots]
    carrier = np.where((under >= 0) & (top[under] > agent.height), under, -1)
    low = [] if agent.reach_distance is None else np.flatnonzero(bottom <= FLAT_HEIGHT).tolist()
    chairs = [i for i in low if not assets[i].is_flat and i not in contents.parent and category_of(assets[i]).movable]
    return Targets(slots, reach, sides, carrier, np.array(chairs, dtype=np.intp), parent, contents.half)
