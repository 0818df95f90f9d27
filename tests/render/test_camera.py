"""The camera is an exact pinhole."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from robolayout.render.camera import Camera, eye_camera, fitted_camera, room_points, spherical_camera
from robolayout.scene import Agent, Pose

coordinate = st.floats(-5, 5)
cameras = st.builds(
    lambda x, y, z, fov, w, h: Camera((x, y, z + 8.0), (0.1, 0.2, 0.3), (0, 1, 0), fov, w, h),
    coordinate, coordinate, coordinate, st.floats(0.3, 1.5), st.integers(16, 900), st.integers(16, 900),
)  # fmt: skip


@given(cameras, st.tuples(coordinate, coordinate, st.floats(-2, 2)))
@settings(max_examples=60, deadline=None)
def test_a_ray_through_a_projected_point_hits_the_point(camera, point):
    pixel, depth = camera.project(point)
    assume(depth > 0.05)
    assert np.allclose(np.array(camera.position) + camera.rays(pixel) * depth, point, atol=1e-9)


@given(cameras, st.tuples(coordinate, coordinate, st.floats(-2, 2)))
@settings(max_examples=60, deadline=None)
def test_opengl_matrix_agrees_with_project(camera, point):
    assume(camera.project(point)[1] > 0.05)
    clip = camera.matrix(100.0).astype(float) @ [*point, 1.0]
    screen = (clip[:2] / clip[3] * [1, -1] + 1) / 2 * [camera.width, camera.height]
    pixel, depth = camera.project(point)
    assert clip[3] == pytest.approx(float(depth), rel=1e-4)
    assert np.allclose(screen, pixel, atol=0.05 + 1e-3 * np.abs(pixel).max())


def test_target_is_in_the_middle():
    camera = Camera((3, -4, 5), (1, 2, 0), (0, 0, 1), 0.8, 320, 200)
    pixel, depth = camera.project((1, 2, 0))
    assert np.allclose(pixel, (160, 100)) and depth == pytest.approx(math.sqrt(4 + 36 + 25))


def test_paper_camera_stands_where_the_formula_says(room):
    polar, azimuth = math.radians(45), math.radians(-60)
    camera = spherical_camera(room, polar, azimuth, (400, 300))
    reach = 1.5 * 5.0
    direction = np.array([math.sin(polar) * math.cos(azimuth), math.sin(polar) * math.sin(azimuth), math.cos(polar)])
    assert np.allclose(camera.position, np.array([2.0, 2.5, 0.0]) + reach * direction)
    assert np.allclose(camera.target, (2.0, 2.5, 0.0))


def test_seen_from_above_x_is_right_and_y_is_up(room):
    camera = spherical_camera(room, 0.0, -math.pi / 2, (400, 400))
    (origin, east, north), _ = camera.project([(2, 2.5, 0), (3, 2.5, 0), (2, 3.5, 0)])
    assert east[0] > origin[0] and east[1] == pytest.approx(origin[1])
    assert north[1] < origin[1] and north[0] == pytest.approx(origin[0])


@pytest.mark.parametrize("polar", [0.0, 45.0, 80.0])
@pytest.mark.parametrize("size", [(300, 300), (500, 200), (200, 500)])
def test_fitted_camera_fills_the_picture(room, polar, size):
    points = room_points(room)
    camera = fitted_camera(points, math.radians(polar), math.radians(-70), size, margin=0.05)
    pixels, depth = camera.project(points)
    assert (depth > 0).all()
    free = np.array(size) * 0.05
    assert (pixels >= free - 1e-6).all() and (pixels <= np.array(size) - free + 1e-6).all()
    touches = np.abs(pixels - free).min(axis=0) < 1e-6
    assert touches.any()


def test_spherical_camera_shows_the_whole_room(room):
    camera = spherical_camera(room, math.radians(45), 0.3, (300, 300), margin=0.1)
    pixels, _ = camera.project(room_points(room))
    assert pixels.min() == pytest.approx(30, abs=1e-6) or pixels.max() == pytest.approx(270, abs=1e-6)


def test_eyes_are_at_eye_height_and_look_at_the_asset():
    camera = eye_camera(Agent("child", 0.2, 1.2), (1.0, 1.0), Pose(3.0, 2.0, 0.4, 0.0), (200, 200))
    assert camera.position == (1.0, 1.0, pytest.approx(0.94 * 1.2))
    pixel, depth = camera.project((3.0, 2.0, 0.4))
    assert depth > 0 and pixel[0] == pytest.approx(100)


def test_standing_inside_the_asset_still_gives_a_camera():
    camera = eye_camera(Agent("child", 0.2, 1.2), (3.0, 2.0), Pose(3.0, 2.0, 0.4, 0.0), (200, 200))
    assert np.isfinite(camera.axes).all()
