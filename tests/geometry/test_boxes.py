"""Boxes in plan against Shapely, which shares no code with them."""

from __future__ import annotations

import math

import jax
import numpy as np
import pytest
import shapely
import shapely.affinity
from hypothesis import example, given, settings
from hypothesis import strategies as st
from plane import ANGLES, BOXES, PLACES, Box, exact
from shapely import Point
from shapely.affinity import translate

from robolayout._geometry import compose, corners, cut_separation, extents, penetration, point_to_box, separation
from robolayout.scene import Pose

TINY = 1e-6
"""Metres that rounding may cost."""

separated = exact(separation)
penetrated = exact(penetration)
cut_apart = exact(cut_separation)
to_box = exact(point_to_box)
composed = exact(compose)
around = exact(extents)
ring = exact(corners)
quick = settings(max_examples=150, deadline=None)


@quick
@given(BOXES, BOXES)
@example(Box(0, 0, 0, 1, 1), Box(2, 0, 0, 1, 1))
@example(Box(0, 0, 0, 1, 1), Box(0, 0, 0, 0.1, 0.1))
def test_separation_tells_whether_boxes_overlap(a: Box, b: Box) -> None:
    gap = float(separated(a.body, b.body))
    distance, common = a.polygon.distance(b.polygon), a.polygon.intersection(b.polygon).area
    assert gap <= distance + TINY, "it promises more room than there is"
    if gap > TINY:
        assert distance > 0.0
    if gap < -TINY:
        assert common > 0.0
    assert float(separated(b.body, a.body)) == pytest.approx(gap, abs=1e-9)


def octagon(box: Box, cut: float) -> shapely.Polygon:
    """The box without its corners."""
    u, v = box.hx - cut, box.hy - cut
    ring = [(box.hx, -v), (box.hx, v), (u, box.hy), (-u, box.hy)]
    outline = shapely.Polygon([*ring, *((-x, -y) for x, y in ring)])
    turned = shapely.affinity.rotate(outline, box.yaw, origin=(0, 0), use_radians=True)
    return shapely.affinity.translate(turned, box.x, box.y)


@quick
@given(BOXES, BOXES, st.floats(0.0, 1.0), st.floats(0.0, 1.0))
@example(Box(0, 0, 0, 1, 1), Box(1.8, 1.8, 0, 1, 1), 0.3, 0.3)
def test_cut_corners_are_apart_as_octagons_are(a: Box, b: Box, first: float, second: float) -> None:
    cuts = first * min(a.hx, a.hy), second * min(b.hx, b.hy)
    gap = float(cut_apart(a.body, b.body, *map(np.float64, cuts)))
    one, other = octagon(a, cuts[0]), octagon(b, cuts[1])
    assert gap <= one.distance(other) + TINY
    if gap > TINY:
        assert one.distance(other) > 0.0
    if gap < -TINY:
        assert one.intersection(other).area > 0.0
    if first == second == 0.0:
        assert gap >= float(separated(a.body, b.body)) - TINY


@quick
@given(BOXES, BOXES)
def test_the_penetration_is_the_smallest_shift_along_a_face_that_parts_them(a: Box, b: Box) -> None:
    depth = float(penetrated(a.body, b.body, 0.0))
    assert not all(still_in(a, b, depth, way) for way in ways(a, b))
    if depth > 1e-3:
        assert all(still_in(a, b, 0.99 * depth, way) for way in ways(a, b))


def ways(a: Box, b: Box) -> list[float]:
    """Return the directions of all face normals."""
    return [box.yaw + k * math.pi / 2 for box in (a, b) for k in range(4)]


def still_in(a: Box, b: Box, shift: float, way: float) -> bool:
    """Return whether b, moved that way, is still more than a hair in a."""
    moved = translate(b.polygon, shift * math.cos(way), shift * math.sin(way))
    return a.polygon.buffer(-TINY).intersects(moved)


@quick
@given(BOXES, BOXES, st.floats(0.0, 0.3))
def test_with_a_margin_what_comes_closer_than_that_penetrates(a: Box, b: Box, margin: float) -> None:
    depth = float(penetrated(a.body, b.body, margin))
    assert depth >= 0.0
    if a.polygon.distance(b.polygon) < margin - TINY:
        assert depth > 0.0
    if depth == 0.0 and margin > 0.0:
        grown = a.polygon.buffer(margin - TINY, join_style="round")
        assert grown.intersection(b.polygon).area < TINY


@quick
@given(BOXES, BOXES, st.integers(0, 3))
def test_between_parallel_faces_the_gap_is_exact(a: Box, b: Box, quarter: int) -> None:
    b = Box(b.x, b.y, a.yaw + quarter * math.pi / 2, b.hx, b.hy)
    gap, distance = float(separated(a.body, b.body)), a.polygon.distance(b.polygon)
    c, s = math.cos(a.yaw), math.sin(a.yaw)
    u, v = abs(c * (b.x - a.x) + s * (b.y - a.y)), abs(c * (b.y - a.y) - s * (b.x - a.x))
    reach = (b.hx, b.hy) if quarter % 2 == 0 else (b.hy, b.hx)
    faces = u < a.hx + reach[0] or v < a.hy + reach[1]
    if faces and distance > TINY:
        assert gap == pytest.approx(distance, abs=TINY)


@quick
@given(PLACES, PLACES, BOXES)
@example(0.0, 0.0, Box(0, 0, 0, 1, 1))
@example(1.0, 0.0, Box(0, 0, 0, 1, 1))
def test_the_signed_distance_of_a_point_to_a_box(x: float, y: float, box: Box) -> None:
    point, polygon = Point(x, y), box.polygon
    expected = polygon.distance(point) or -polygon.exterior.distance(point)
    assert float(to_box(x, y, box.body)) == pytest.approx(expected, abs=2e-6)


@quick
@given(BOXES)
def test_extents_and_corners(box: Box) -> None:
    left, bottom, right, top = box.polygon.bounds
    ex, ey = around(box.body)
    assert (2 * ex, 2 * ey) == pytest.approx((right - left, top - bottom), abs=1e-9)
    px, py = ring(box.body)
    pose = Pose(box.x, box.y, 0.0, box.yaw)
    assert np.stack([px, py], axis=-1) == pytest.approx(np.array(pose.corners((2 * box.hx, 2 * box.hy, 1))), abs=1e-9)


POSES = st.builds(lambda x, y, yaw: np.array([x, y, math.cos(yaw), math.sin(yaw)]), PLACES, PLACES, ANGLES)


@quick
@given(POSES, POSES, POSES)
def test_frames_in_frames(first: np.ndarray, second: np.ndarray, third: np.ndarray) -> None:
    together = composed(first, composed(second, third))
    assert together == pytest.approx(composed(composed(first, second), third), abs=1e-9)
    place = complex(*first[:2]) + complex(*first[2:]) * complex(*second[:2])
    heading = complex(*first[2:]) * complex(*second[2:])
    expected = [place.real, place.imag, heading.real, heading.imag]
    assert composed(first, second) == pytest.approx(np.array(expected), abs=1e-9)


def test_a_box_inside_another_is_pushed_out() -> None:
    """The overlap loss of the published code has no gradient here."""
    a, b = Box(0, 0, 0, 2, 1), Box(0.3, 0.2, 0.4, 0.3, 0.2)

    def depth(x: float, y: float) -> jax.Array:
        return penetration(a.body, b.body._replace(x=x, y=y), 0.015)

    slope = exact(jax.grad(depth, argnums=(0, 1)))(b.x, b.y)
    assert np.hypot(*slope) == pytest.approx(1.0, abs=1e-6)
    assert slope[1] < 0.0, "up is the shortest way out"


def test_a_batch_of_pairs_broadcasts() -> None:
    boxes = [Box(x, 0.0, 0.1 * x, 0.5, 0.3) for x in (0.0, 0.7, 5.0)]
    table = type(boxes[0].body)(*(np.array(column) for column in zip(*(box.body for box in boxes), strict=True)))
    rows = type(table)(*(field[:, None] for field in table))
    grid = separated(rows, type(table)(*(field[None] for field in table)))
    assert grid.shape == (3, 3)
    for i, a in enumerate(boxes):
        for j, b in enumerate(boxes):
            assert grid[i, j] == pytest.approx(float(separated(a.body, b.body)), abs=1e-12)
