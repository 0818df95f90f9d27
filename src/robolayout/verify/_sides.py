"""Sides of boxes: their edges, the strips in front of them, and from where an arm gets to them."""

from __future__ import annotations

import math

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon

from robolayout.verify.limits import FINE

SIDES = ("front", "left", "back", "right")
"""Sides in counter-clockwise order, starting with the one that faces +x at zero rotation."""


def side_edge(footprint: Polygon, side: str) -> LineString:
    """Return a side's edge, counter-clockwise, so that outside is on its right."""
    ring = shapely.get_coordinates(footprint)
    at = SIDES.index(side)
    return LineString((ring[at], ring[at + 1]))


def strip(edge: LineString, depth: float) -> Polygon:
    """Return the rectangle `depth` metres deep on the right of an edge."""
    return strips(shapely.get_coordinates(edge)[None], np.array([depth]))[0]


def strips(edges: NDArray[np.float64], depth: NDArray[np.float64], margin: float = 0.0) -> NDArray[np.object_]:
    """Return the rectangles on the right of edges (n, 2, 2): `depth` (n,) metres deep, `margin` longer at both ends."""
    along, outward = _axes(edges)
    a, b = edges[:, 0] - along * margin, edges[:, 1] + along * margin
    out = outward * depth[:, None]
    return np.asarray(shapely.polygons(np.stack([a, a + out, b + out, b], axis=1)), dtype=object)


def within(edges: NDArray[np.float64], reach: NDArray[np.float64]) -> NDArray[np.object_]:
    """Return everything on the right of edges (n, 2, 2) that is no farther from them than `reach` (n,) metres."""
    along, outward = (axis[:, None] * reach[:, None, None] for axis in _axes(edges))
    turn = np.linspace(0.0, math.pi / 2, FINE.quad_segs + 1)[:, None]
    before = edges[:, :1] - along * np.cos(turn) + outward * np.sin(turn)
    after = edges[:, 1:] + outward * np.cos(turn) + along * np.sin(turn)
    return np.asarray(shapely.polygons(np.concatenate([before, after], axis=1)), dtype=object)


def _axes(edges: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return unit vectors (n, 2) along edges and outward from them."""
    along = edges[:, 1] - edges[:, 0]
    along = along / np.linalg.norm(along, axis=1, keepdims=True)
    return along, np.stack([along[:, 1], -along[:, 0]], axis=1)
