"""Room for knees and toes below a top: from where a seated body uses it frontally, and where only sideways (ADA 2010, 306)."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from robolayout.assets import Prism, category_of, prisms_of
from robolayout.scene import Asset
from robolayout.verify.limits import ADA

SAT_AT = ("table", "desk", "workbench", "counter", "basin", "washbasin", "sink", "vanity", "island")
"""Last words of the kinds of things that one sits at."""
LOW_TABLES = ("coffee", "side", "console", "bedside", "overbed", "changing")  # first words of those that one does not


@lru_cache(maxsize=1024)
def is_sat_at(asset: Asset) -> bool:
    """Return whether a seated person works or washes at a thing."""
    words = category_of(asset).name.split()
    return words[-1] in SAT_AT and words[0] not in LOW_TABLES


@lru_cache(maxsize=4096)
def knee_width(asset: Asset, side: str) -> float:
    """Return how many metres wide the widest free strip under the edge of a side is, as high and deep as knees and toes need."""
    half = np.array(asset.size[:2]) / 2
    axis = 0 if side in ("front", "back") else 1  # the axis that leads inwards
    sign = 1.0 if side in ("front", "left") else -1.0
    spans: list[tuple[float, float]] = []
    for prism in prisms_of(asset):
        middle, reach = ((prism.x, prism.hx), (prism.y, prism.hy))[axis]
        across, wide = ((prism.y, prism.hy), (prism.x, prism.hx))[axis]
        inwards = float(half[axis]) - sign * middle - reach
        if inwards < min(_needed(prism), 2 * float(half[axis])) - ADA.contact:
            spans.append((across - wide, across + wide))
    widest, at, end = 0.0, -float(half[1 - axis]), float(half[1 - axis])
    for low, high in (*sorted(spans), (end, end)):
        widest, at = max(widest, low - at), max(at, high)
    return widest


def frontal(asset: Asset, side: str) -> bool:
    """Return whether knees and toes have room below a side."""
    return knee_width(asset, side) >= ADA.knee_width - ADA.contact


def _needed(prism: Prism) -> float:
    """Return how many metres inwards of the edge a prism must begin to leave room for knees and toes."""
    if prism.low >= ADA.knee_height - ADA.contact:
        return 0.0
    if prism.low < ADA.toe_height and prism.high > ADA.contact:
        return ADA.toe_depth
    return ADA.deep - (ADA.deep - ADA.shallow) * (prism.low - ADA.toe_height) / (ADA.knee_height - ADA.toe_height)
