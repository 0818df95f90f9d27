"""Room for knees and toes below a top: from where a seated body uses it frontally, and where only sideways (ADA 2010, 306)."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from robolayout.assets import Prism, category_of, prisms_of
from robolayout.scene import Asset

KNEE_HEIGHT, KNEE_WIDTH = 0.685, 0.76  # metres of height and width of room for knees (306.3.3, 306.3.5)
TOE_HEIGHT, TOE_DEPTH = 0.23, 0.43
"""Metres of height up to which room is for toes, and how deep it is (306.2.1, 306.2.3)."""
DEEP, SHALLOW = 0.28, 0.205
"""Metres of depth of room for knees at `TOE_HEIGHT` and at `KNEE_HEIGHT`; between them it shrinks evenly (306.3.3, 306.3.4)."""
CONTACT = 1e-3  # metres by which room is measured more kindly, so that rounding decides nothing
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
    """Return how many metres wide the widest free strip under the edge of a side is, as high and deep as knees and toes need.

    Args:
        side: "front", "back", "left" or "right".
    """
    half = np.array(asset.size[:2]) / 2
    axis = 0 if side in ("front", "back") else 1  # the axis that leads inwards
    sign = 1.0 if side in ("front", "left") else -1.0
    spans: list[tuple[float, float]] = []
    for prism in prisms_of(asset):
        middle, reach = ((prism.x, prism.hx), (prism.y, prism.hy))[axis]
        across, wide = ((prism.y, prism.hy), (prism.x, prism.hx))[axis]
        inwards = float(half[axis]) - sign * middle - reach
        if inwards < min(_needed(prism), 2 * float(half[axis])) - CONTACT:
            spans.append((across - wide, across + wide))
    widest, at, end = 0.0, -float(half[1 - axis]), float(half[1 - axis])
    for low, high in (*sorted(spans), (end, end)):
        widest, at = max(widest, low - at), max(at, high)
    return widest


def frontal(asset: Asset, side: str) -> bool:
    """Return whether knees and toes have room below a side."""
    return knee_width(asset, side) >= KNEE_WIDTH - CONTACT


def _needed(prism: Prism) -> float:
    """Return how many metres inwards of the edge a prism must begin to leave room for knees and toes."""
    if prism.low >= KNEE_HEIGHT - CONTACT:
        return 0.0
    if prism.low < TOE_HEIGHT and prism.high > CONTACT:
        return TOE_DEPTH
    return DEEP - (DEEP - SHALLOW) * (prism.low - TOE_HEIGHT) / (KNEE_HEIGHT - TOE_HEIGHT)
