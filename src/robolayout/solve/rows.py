"""By how much a batch of poses misses a row of a statement, without the compiled search: for building and proposing."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from robolayout.constraints import FAR, FrameTerm, Interval, WallRef

Floats = NDArray[np.float64]

CLOSEST = 0.1
"""Metres of distance below which what a thing looks at seems no wider."""


def missed(term: FrameTerm, local: Floats, half: tuple[float, float], other: tuple[float, float]) -> Floats:
    """Return by how many metres poses of a thing miss a row (n,); a radian of its heading counts as a metre.

    Args:
        term: The row.
        local: (n, 3) its place in metres and heading in radians in the frame of what the row refers to.
        half: Half of its depth and width, metres.
        other: The same of what the row refers to; half the length of a wall, 0 of a point.
    """
    u, v, turn = local.T
    c, s = np.abs(np.cos(turn)), np.abs(np.sin(turn))
    short = _beyond(u, term.along, c * half[0] + s * half[1])
    short += _beyond(np.abs(v) if term.fold else v, term.across, s * half[0] + c * half[1])
    low, high = term.distance
    away = np.hypot(np.maximum(np.abs(u) - other[0], 0.0) if isinstance(term.b, WallRef) else u, v)
    short += np.maximum(low - away, 0.0) + (np.maximum(away - high, 0.0) if high < FAR else 0.0)
    if term.heading is not None:
        short += np.abs(_wrapped(turn - term.heading))
    if term.look is not None:
        off = np.abs(_wrapped(turn + term.look - np.arctan2(-v, -u)))
        short += np.maximum(0.0, off - np.arctan2(min(other), np.maximum(away, CLOSEST)))
    return short


def _beyond(value: Floats, interval: Interval, extent: Floats) -> Floats:
    """Return by how much values leave an interval that shrinks with the extent of the thing."""
    low = np.maximum(interval.low - (value - interval.low_extent * extent), 0.0)
    return low + np.maximum(value + interval.high_extent * extent - interval.high, 0.0)


def _wrapped(angle: Floats) -> Floats:
    """Return angles in [-pi, pi)."""
    return (angle + math.pi) % math.tau - math.pi
