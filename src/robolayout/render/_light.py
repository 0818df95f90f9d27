"""The light of every picture: a soft sun, a sky, and what floor and walls throw back. Both renderers share it.

Radiance of a surface with linear colour a and normal n:
    a (SUN mean_i[visible_i max(0, n . sun_i)] + SKY s + BOUNCE (LIGHT.bounce - LIGHT.bounce_tilt n_z)),
    s = (2 / K) sum_k[visible_k max(0, n . sky_k)], computed at the corners of a refined mesh and interpolated,
plus a small highlight of the sun for glossy surfaces; then exposure, a soft shoulder above 0.75, and sRGB.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from robolayout._color import encoded
from robolayout.render._style import LIGHT
from robolayout.render.camera import Camera

SUN = np.array([0.98, 0.90, 0.78])
SKY = np.array([0.60, 0.66, 0.74])
BOUNCE = np.array([0.36, 0.345, 0.32])  # linear irradiance over pi of sun, open sky and reflected light


@lru_cache(maxsize=1)
def sky_directions() -> NDArray[np.float32]:
    """Return (`LIGHT.sky`, 3) unit vectors spread evenly over the upper hemisphere (golden spiral)."""
    k = np.arange(LIGHT.sky)
    z = 0.06 + 0.94 * (k + 0.5) / LIGHT.sky
    angle = k * math.pi * (3 - math.sqrt(5)) + 0.4
    r = np.sqrt(1 - z * z)
    return np.column_stack([r * np.cos(angle), r * np.sin(angle), z]).astype(np.float32)


def sun_directions(camera: Camera) -> NDArray[np.float32]:
    """Return (`LIGHT.sun`, 3) unit vectors to the sun: over the viewer's left shoulder; upper left when seen from above."""
    right, down, forward = camera.axes
    from_above = abs(forward[2]) > 0.9
    behind = _unit(-down[:2] if from_above else -forward[:2])
    level = (0.7 if from_above else 0.95) * behind - (0.7 if from_above else 0.31) * _unit(right[:2])
    center = np.array([*(level / np.linalg.norm(level) * 0.62), 0.78])
    center /= np.linalg.norm(center)
    side = _unit(np.cross(center, (0.0, 0.0, 1.0)))
    other = np.cross(center, side)
    angles = 2 * math.pi * np.arange(LIGHT.sun) / LIGHT.sun
    spread = 0.035 * (np.cos(angles)[:, None] * side + np.sin(angles)[:, None] * other)
    rays = center + spread
    return (rays / np.linalg.norm(rays, axis=1, keepdims=True)).astype(np.float32)


def _unit(vector: NDArray[np.float64]) -> NDArray[np.float64]:
    return vector / max(float(np.linalg.norm(vector)), 1e-9)


def encode(radiance: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return display values in [0, 1]: shoulder, then sRGB. The same curve is in the shader of `_gl`."""
    over = np.maximum(radiance - LIGHT.shoulder, 0)
    bent = np.minimum(radiance, LIGHT.shoulder) + (1 - LIGHT.shoulder) * (1 - np.exp(-over / (1 - LIGHT.shoulder)))
    return encoded(bent).astype(np.float32)
