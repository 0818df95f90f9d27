"""Where a thing stands under another one: between its legs, below its top."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from robolayout.assets.lexicon import category_of
from robolayout.assets.obstacles import use_sides
from robolayout.assets.prisms import Prism, prisms_of
from robolayout.scene import Asset


@dataclass(frozen=True)
class BeneathConfig:
    """How things stand under others."""

    ease: float = 0.01  # metres left between a thing and what it stands under
    step: float = 0.05  # metres between places that are tried
    back: float = 10.0  # cost of a metre behind the edge for what is used from its front; a quarter turn costs 1, a metre aside -1
    forward: float = 0.5  # cost of a metre forward for the rest
    least: float = 0.5  # share of its footprint that is under a thing that stands under another
    smaller: tuple[float, ...] = (0.9, 0.8, 0.7, 0.6)  # by how much a thing is made smaller that does not fit
    beside: float = 0.03  # metres that a worktop is larger than what is under it
    # what is drawn as an open worktop then
    worktops: tuple[str, ...] = ("kitchen counter", "kitchen cabinet", "workbench")
    # parts without which a thing has room below it
    left_out: tuple[str, ...] = ("shelf", "basket", "drawer", "pedestal")


BENEATH = BeneathConfig()

Place = tuple[float, float, float]
"""Metres, metres and radians in the frame of what is above."""


@lru_cache(maxsize=1024)
def places_beneath(upper: Asset, lower: Asset) -> tuple[Place, ...]:
    """Return the places on the floor where a thing stands wholly under another and touches none of its parts, the best first.

    What is used from its front has that at an edge, best at the front of the other; the rest stands out of the way, at the sides and
    behind. Only things that stand at right angles to each other are looked at.
    """
    (depth, width, height), (long, wide, _) = lower.size, upper.size
    barred = [prism for prism in prisms_of(upper) if prism.low < height + BENEATH.ease]
    fronted, found = "front" in use_sides(lower) and category_of(lower).open_depth > 0, list[tuple[float, Place]]()
    for quarter in range(4):
        hx, hy = (depth / 2, width / 2) if quarter % 2 == 0 else (width / 2, depth / 2)
        if hx > long / 2 + 1e-6 or hy > wide / 2 + 1e-6:
            continue
        x, y = (each.ravel() for each in np.meshgrid(_along(long / 2 - hx), _along(wide / 2 - hy), indexing="ij"))
        free = np.ones(len(x), np.bool_)
        for prism in barred:
            free &= ~_touches(prism, x, y, hx, hy)
        behind = (
            (long, wide)[quarter % 2] / 2 - depth / 2 - (x, y, -x, -y)[quarter]
        )  # from its front to the edge before it
        cost = quarter - np.abs(y) + (BENEATH.back * behind if fronted else BENEATH.forward * x)
        turn = (0.0, math.pi / 2, math.pi, -math.pi / 2)[quarter]
        found += [(float(cost[i]), (float(x[i]), float(y[i]), turn)) for i in np.flatnonzero(free)]
    return tuple(place for _, place in sorted(found))


def with_room_below(upper: Asset, held: Sequence[Asset], each: int) -> Asset:
    """Return a thing under which there is room for others, `each` of them below one such thing, as far as that can be.

    Counters are worktops then, as wide as it takes; other things lose what is drawn below their top.
    """
    if all(places_beneath(upper, low) for low in held):
        return upper
    if upper.category in BENEATH.worktops:
        deep, wide, tall = (max(low.size[k] for low in held) + BENEATH.beside for k in range(3))
        d, w, h = map(max, upper.size, (deep, each * wide + BENEATH.beside, tall + BENEATH.beside))
        return replace(upper, like="open worktop", size=(d, w, h))
    bare = replace(upper, without=(*upper.without, *BENEATH.left_out))
    return bare if clearance(bare, held[0].size[:2]) > clearance(upper, held[0].size[:2]) else upper


def low_enough(lower: Asset, upper: Asset) -> Asset:
    """Return a thing that fits under another: a little smaller where it has to be; as it is where that is not enough."""
    made = (replace(lower, size=tuple(round(by * side, 3) for side in lower.size)) for by in (1.0, *BENEATH.smaller))
    return next((one for one in made if places_beneath(upper, one)), lower)


def clearance(upper: Asset, size: tuple[float, float]) -> float:
    """Return the greatest height in metres up to which a thing of a depth and width stands under another; 0 where nowhere."""
    heights = sorted({prism.low for prism in prisms_of(upper) if prism.low > BENEATH.ease}, reverse=True)
    tried = (height - 2 * BENEATH.ease for height in heights if height > 2 * BENEATH.ease)
    return next((high for high in tried if places_beneath(upper, Asset("box", "box", (*size, high)))), 0.0)


def _along(free: float) -> NDArray[np.float64]:
    """Return middles along one axis between two ends, both among them."""
    return np.linspace(-free, free, 2 * math.ceil(free / BENEATH.step) + 1)


def _touches(prism: Prism, x: NDArray[np.float64], y: NDArray[np.float64], hx: float, hy: float) -> NDArray[np.bool_]:
    """Return which boxes come too near to a prism in plan."""
    aside = BENEATH.ease
    return (np.abs(x - prism.x) < hx + prism.hx + aside) & (np.abs(y - prism.y) < hy + prism.hy + aside)
