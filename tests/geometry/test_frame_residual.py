"""The kernels of statements: values by hand, rays and mirrors against Shapely and complex numbers."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from plane import ANGLES, BOXES, Box, exact
from shapely import LineString

from robolayout._geometry import FrameRow, frame_residual, mirror_residual, soft_abs
from robolayout.constraints import FAR, FrameTerm, Interval, PointRef

residual = exact(frame_residual)
mirror = exact(mirror_residual)
rounded = exact(soft_abs)
HERE = PointRef(0.0, 0.0)


def row(**options: object) -> FrameRow:
    """Return the numbers of a term between two things that do not matter."""
    return FrameRow(*(np.float64(value) for value in FrameTerm(HERE, HERE, **options).row()))


def hinge(metres: float) -> float:
    """Return a hinge's value: 0 below 0, rounded over 2 cm."""
    return math.sqrt(max(metres, 0.0) ** 2 + 0.02**2) - 0.02


A = Box(1.0, 2.0, 0.0, 0.3, 0.5)
B = Box(0.0, 0.0, 0.0, 0.4, 0.8)


@pytest.mark.parametrize(
    ("options", "short"),
    [
        ({}, 0.0),
        ({"along": Interval(low=1.0)}, 0.0),
        ({"along": Interval(low=1.5)}, 0.5),
        ({"along": Interval(low=1.0, low_extent=1.0)}, 0.3),
        ({"along": Interval(high=0.2)}, 0.8),
        ({"along": Interval(high=0.2, high_extent=1.0)}, 1.1),
        ({"across": Interval(low=2.0, low_extent=1.0)}, 0.5),
        ({"across": Interval(high=1.0)}, 1.0),
        ({"across": Interval(low=1.0, high=3.0)}, 0.0),
        ({"distance": (3.0, FAR)}, 3.0 - math.sqrt(5)),
        ({"distance": (0.0, 1.0)}, math.sqrt(5) - 1.0),
    ],
)
def test_places_by_hand(options: dict[str, object], short: float) -> None:
    assert float(residual(A.body, B.body, row(**options))) == pytest.approx(hinge(short), abs=1e-6)


def test_far_things_are_pulled() -> None:
    """The published distance loss is clamped, so that it does not pull at what is far away."""
    term = row(distance=(0.0, 1.0))
    values = [float(residual(Box(x, 0, 0, 0.1, 0.1).body, B.body, term)) for x in (2.0, 20.0, 200.0)]
    assert values == pytest.approx([hinge(1.0), hinge(19.0), hinge(199.0)])


def test_either_side_will_do_where_it_is_folded() -> None:
    term = row(across=Interval(low=1.5), fold=True)
    up, down = Box(0, 2, 0, 0.1, 0.1), Box(0, -2, 0, 0.1, 0.1)
    assert float(residual(up.body, B.body, term)) == float(residual(down.body, B.body, term)) == 0.0


def test_distances_to_a_wall_are_to_its_segment() -> None:
    wall = Box(0, 0, 0, 3.0, 0.0).body._replace(core=np.float64(3.0))
    term = row(distance=(0.0, 1.0))
    for x, y, expected in ((1.0, 2.0, 1.0), (6.0, 4.0, 4.0), (-2.9, 0.5, 0.0)):
        assert float(residual(Box(x, y, 0, 0.1, 0.1).body, wall, term)) == pytest.approx(hinge(expected), abs=1e-6)


@settings(max_examples=100, deadline=None)
@given(ANGLES, ANGLES, ANGLES)
def test_headings_are_one_minus_the_cosine(first: float, second: float, wanted: float) -> None:
    a, b = Box(1, 1, first, 0.2, 0.2), Box(0, 0, second, 0.2, 0.2)
    value = float(residual(a.body, b.body, row(heading=wanted)))
    assert value == pytest.approx(1 - math.cos(first - second - wanted), abs=1e-9)


@settings(max_examples=200, deadline=None)
@given(BOXES, BOXES, ANGLES)
def test_a_look_is_satisfied_where_the_ray_hits(a: Box, b: Box, turn: float) -> None:
    value = float(residual(a.body, b.body, row(look=turn)))
    yaw = a.yaw + turn
    ray = LineString([(a.x, a.y), (a.x + 50 * math.cos(yaw), a.y + 50 * math.sin(yaw))])
    if ray.intersects(b.polygon.buffer(-1e-6)):
        assert value == 0.0
    if not ray.intersects(b.polygon.buffer(1e-6)):
        off = math.atan2(b.y - a.y, b.x - a.x) - yaw
        assert value == pytest.approx(1 - math.cos(off), abs=1e-6)


@settings(max_examples=100, deadline=None)
@given(BOXES, BOXES, st.booleans())
def test_the_mirror_image_is_satisfied_and_nothing_else(a: Box, axis: Box, wall: bool) -> None:
    line = axis.yaw + (math.pi / 2 if wall else 0.0)
    turn = complex(math.cos(line), math.sin(line))
    image = complex(axis.x, axis.y) + turn * ((complex(a.x - axis.x, a.y - axis.y) / turn).conjugate())
    twin = Box(image.real, image.imag, 2 * line - a.yaw, a.hx, a.hy)
    along = np.float64(wall)
    assert float(mirror(a.body, twin.body, axis.body, along)) == pytest.approx(0.0, abs=1e-6)
    off = Box(twin.x + 0.3, twin.y + 0.4, twin.yaw, a.hx, a.hy)
    assert float(mirror(a.body, off.body, axis.body, along)) == pytest.approx(hinge(0.5), abs=1e-6)
    turned = Box(twin.x, twin.y, twin.yaw + math.pi, a.hx, a.hy)
    assert float(mirror(a.body, turned.body, axis.body, along)) == pytest.approx(1.0, abs=1e-6)


def test_left_and_right_of_a_bed_are_mirror_images() -> None:
    """The published code mirrors front and back."""
    bed, left, right = Box(0, 0, 0, 1.0, 0.8), Box(-0.7, 1.1, 0, 0.2, 0.2), Box(-0.7, -1.1, 0, 0.2, 0.2)
    front = Box(0.7, 1.1, math.pi, 0.2, 0.2)
    assert float(mirror(left.body, right.body, bed.body, np.float64(0))) == pytest.approx(0.0, abs=1e-6)
    assert float(mirror(left.body, front.body, bed.body, np.float64(0))) > 1.0


@given(st.floats(-50, 50))
@settings(max_examples=50, deadline=None)
def test_the_rounded_absolute_value(x: float) -> None:
    value = float(rounded(np.float64(x)))
    assert abs(x) - 0.02 <= value <= abs(x)
    assert value == pytest.approx(float(rounded(np.float64(-x))))
