"""The signed distance to a room's outline against Shapely."""

from __future__ import annotations

import math

import jax
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from plane import exact
from shapely import Point, Polygon

from robolayout._geometry import signed_distance

CORNERS = 8
"""Every outline has this many edges, the last ones of zero length, as the solver pads them."""

distance = exact(signed_distance)


def edges(vertices: list[tuple[float, float]]) -> np.ndarray:
    ring = [(*a, *b) for a, b in zip(vertices, vertices[1:] + vertices[:1], strict=True)]
    ring += [(*vertices[0], *vertices[0])] * (CORNERS - len(ring))
    return np.array(ring, np.float64)


def star(radii: list[float], turn: float) -> list[tuple[float, float]]:
    """Return a simple, mostly concave polygon around the origin."""
    angles = [turn + math.tau * i / len(radii) for i in range(len(radii))]
    return [(r * math.cos(t), r * math.sin(t)) for r, t in zip(radii, angles, strict=True)]


SHAPES = st.one_of(
    st.builds(star, st.lists(st.floats(0.3, 4), min_size=3, max_size=CORNERS), st.floats(0, math.tau)),
    st.sampled_from([[(0, 0), (3, 0), (3, 2), (0, 2)], [(0, 0), (4, 0), (4, 2), (2, 2), (2, 3), (0, 3)]]),
)
PLACES = st.sampled_from([0.0, 1.0, 2.0, 3.0]) | st.floats(-5, 5)


@settings(max_examples=200, deadline=None)
@given(SHAPES, PLACES, PLACES)
def test_it_is_the_distance_to_the_outline_negative_inside(
    vertices: list[tuple[float, float]], x: float, y: float
) -> None:
    polygon, point = Polygon(vertices), Point(x, y)
    away = polygon.exterior.distance(point)
    found = float(distance(np.float64(x), np.float64(y), edges(vertices)))
    assert abs(found) == pytest.approx(away, abs=2e-6)
    if away > 1e-6:
        assert (found < 0) == polygon.contains(point)


def test_gradients_are_finite_on_edges_and_corners() -> None:
    vertices = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 3.0), (0.0, 3.0)]
    slope = exact(jax.vmap(jax.grad(signed_distance, argnums=(0, 1)), in_axes=(0, 0, None)))
    points = np.array([*vertices, (2.0, 0.0), (1.0, 1.0), (9.0, 9.0)])
    gx, gy = slope(points[:, 0], points[:, 1], edges(vertices))
    assert np.isfinite(gx).all() and np.isfinite(gy).all()
    assert (gx[-1], gy[-1]) == pytest.approx((1 / math.sqrt(74) * 5, 7 / math.sqrt(74)), abs=1e-6)


def test_many_points_at_once() -> None:
    square = edges([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    xs, ys = np.meshgrid(np.linspace(-1, 2, 5), np.linspace(-1, 2, 7))
    together = distance(xs, ys, square)
    assert together.shape == (7, 5)
    assert together[3, 2] == pytest.approx(-0.5, abs=1e-6)
