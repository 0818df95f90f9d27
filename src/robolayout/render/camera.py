"""The camera: an exact pinhole, so that a point of the room has exactly one place in the picture.

A camera looks from `position` to `target`; its picture plane has x to the right and y down, its depth is the distance
in metres along the line of sight. Two cameras matter: the paper's (room centre, height 1.5 times the room's width,
spherical angles) and the fitted one, which looks the same way but stands where the room fills the picture.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from robolayout.render._style import VIEW
from robolayout.scene import Agent, Pose, Room

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Camera:
    """A pinhole camera."""

    position: Vector  # pinhole, metres, world frame
    target: Vector  # point in the middle of the picture, metres
    up: Vector  # direction that is up in the picture; not parallel to the line of sight
    fov: float  # vertical field of view, radians
    width: int  # picture width, pixels
    height: int  # picture height, pixels

    @cached_property
    def axes(self) -> NDArray[np.float64]:
        """Rows: right, down and forward unit vectors in the world frame."""
        forward = np.subtract(self.target, self.position)
        forward = forward / np.linalg.norm(forward)
        right = np.cross(forward, self.up)
        right = right / np.linalg.norm(right)
        return np.stack([right, np.cross(forward, right), forward])

    @property
    def focal(self) -> float:
        """Focal length in pixels."""
        return self.height / 2 / math.tan(self.fov / 2)

    def project(self, points: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return where world points (..., 3) land: pixels (..., 2) and depths (...) in metres.

        Pixel (0, 0) is the upper left corner of the upper left pixel. Points with depth <= 0 are behind the camera and
        have no meaningful pixel.
        """
        local = (np.asarray(points, dtype=np.float64) - self.position) @ self.axes.T
        depth = local[..., 2]
        safe = np.where(np.abs(depth) < 1e-9, 1e-9, depth)
        pixels = local[..., :2] / safe[..., None] * self.focal + (self.width / 2, self.height / 2)
        return pixels, depth

    def rays(self, pixels: ArrayLike) -> NDArray[np.float64]:
        """Return the world directions (..., 3) through pixels (..., 2), scaled to depth 1."""
        plane = (np.asarray(pixels, dtype=np.float64) - (self.width / 2, self.height / 2)) / self.focal
        local = np.concatenate([plane, np.ones((*plane.shape[:-1], 1))], axis=-1)
        return local @ self.axes

    def matrix(self, far: float, near: float = VIEW.near) -> NDArray[np.float32]:
        """Return the (4, 4) world-to-clip matrix of OpenGL, row-major, for depths from `near` to `far`."""
        view = np.eye(4)
        view[:3, :3] = self.axes * [[1], [-1], [-1]]
        view[:3, 3] = -view[:3, :3] @ np.asarray(self.position)
        f = 1 / math.tan(self.fov / 2)
        clip = np.zeros((4, 4))
        clip[0, 0], clip[1, 1] = f * self.height / self.width, f
        clip[2, 2:] = -(far + near) / (far - near), -2 * far * near / (far - near)
        clip[3, 2] = -1.0
        return (clip @ view).astype(np.float32)


def spherical_camera(room: Room, polar: float, azimuth: float, size: tuple[int, int], margin: float = 0.05) -> Camera:
    """Return the paper's camera: c_floor + H (sin polar cos azimuth, sin polar sin azimuth, cos polar), H = 1.5 W.

    It looks at the middle of the floor; its field of view is as wide as the whole room needs. `size` is the picture's
    (width, height) in pixels, angles are in radians, `margin` is the share of the picture left free at each edge.
    """
    x0, y0, x1, y1 = room.bounds
    target = np.array([(x0 + x1) / 2, (y0 + y1) / 2, 0.0])
    reach = VIEW.alpha * max(x1 - x0, y1 - y0)
    reach = max(reach, (room.wall_height + 0.5) / max(math.cos(polar), 0.5))
    position = target + reach * _direction(polar, azimuth)
    camera = _look(position, target, azimuth, math.radians(60), size)
    pixels, _ = camera.project(room_points(room))
    half = np.abs(pixels - (size[0] / 2, size[1] / 2)).max(axis=0)
    share = max(half[0] / (size[0] / 2), half[1] / (size[1] / 2)) / (1 - 2 * margin)
    return replace(camera, fov=2 * math.atan(math.tan(camera.fov / 2) * share))


def fitted_camera(
    points: NDArray[np.float64],
    polar: float,
    azimuth: float,
    size: tuple[int, int],
    *,
    fov: float = math.radians(28.0),
    margin: float = 0.05,
) -> Camera:
    """Return the camera that looks along (polar, azimuth) and stands where `points` (n, 3) just fill the picture.

    In the camera's axes, points (x, y, z) are in the picture of a camera at (cx, cy, -d) if |x - cx| <= t (z + d); so
    d >= (max(x - t z) - min(x + t z)) / 2t, and the same for y; the larger d wins and the other axis is centred.
    """
    probe = _look(_direction(polar, azimuth), np.zeros(3), azimuth, fov, size)
    x, y, z = probe.axes @ points.T
    tan_y = math.tan(fov / 2) * (1 - 2 * margin)
    tan_x = tan_y * size[0] / size[1]
    spans = [((a - t * z).max(), (a + t * z).min(), t) for a, t in ((x, tan_x), (y, tan_y))]
    distance = max((low - high) / (2 * t) for low, high, t in spans)
    distance = max(distance, float(-z.min()) + 2 * VIEW.near)
    eye = np.array([(low + high) / 2 for low, high, _ in spans] + [-distance]) @ probe.axes
    middle = float(np.median(z)) + distance
    return _look(eye, eye + probe.axes[2] * middle, azimuth, fov, size)


def eye_camera(agent: Agent, stand: tuple[float, float], pose: Pose, size: tuple[int, int]) -> Camera:
    """Return what the agent sees from `stand` (metres, in plan) when it looks at an asset's pose.

    The eye is at 0.94 of its height (adult eye height to stature: 0.94, ANSUR II), at least 5 cm up.
    """
    eye = (stand[0], stand[1], max(0.94 * agent.height, 0.05))
    distance = max(math.dist(stand, (pose.x, pose.y)), 1e-6)
    drop = max(min(pose.z - eye[2], 0.5 * distance), -0.5 * distance)
    if distance < 1e-3:
        return Camera(eye, (eye[0] + pose.forward[0], eye[1] + pose.forward[1], eye[2]), (0, 0, 1), 1.2, *size)
    return Camera(eye, (pose.x, pose.y, eye[2] + drop), (0, 0, 1), math.radians(65), *size)


def room_points(room: Room) -> NDArray[np.float64]:
    """Return the corners of the room at floor and ceiling, (2n, 3) in metres."""
    return np.array([(x, y, z) for x, y in room.vertices for z in (0.0, room.wall_height)])


def _direction(polar: float, azimuth: float) -> NDArray[np.float64]:
    """Return the unit vector with that angle from the vertical and that azimuth, radians."""
    return np.array([math.sin(polar) * math.cos(azimuth), math.sin(polar) * math.sin(azimuth), math.cos(polar)])


def _look(
    position: NDArray[np.float64], target: NDArray[np.float64], azimuth: float, fov: float, size: tuple[int, int]
) -> Camera:
    """Return a camera whose up is away from the azimuth in plan, so that it is defined even straight from above."""
    up = (-math.cos(azimuth), -math.sin(azimuth), 0.0)
    forward = (target - position) / np.linalg.norm(target - position)
    if abs(forward[2]) < 0.7:
        up = (0.0, 0.0, 1.0)
    to_tuple = tuple[float, float, float]
    return Camera(to_tuple(map(float, position)), to_tuple(map(float, target)), up, fov, *size)
