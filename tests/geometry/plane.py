"""Boxes as plain numbers for the geometry tests: drawn by Hypothesis, seen by Shapely and by our array functions."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import jax
import numpy as np
from hypothesis import strategies as st
from shapely import Polygon

from robolayout._geometry import Body


@dataclass(frozen=True)
class Box:
    """A box: centre, yaw in radians, half sizes."""

    x: float
    y: float
    yaw: float
    hx: float
    hy: float

    @property
    def body(self) -> Body:
        row = (self.x, self.y, math.cos(self.yaw), math.sin(self.yaw), self.hx, self.hy, 0.0)
        return Body(*(np.float64(value) for value in row))

    @property
    def polygon(self) -> Polygon:
        c, s = math.cos(self.yaw), math.sin(self.yaw)
        ring = ((self.hx, -self.hy), (self.hx, self.hy), (-self.hx, self.hy), (-self.hx, -self.hy))
        return Polygon([(self.x + c * u - s * v, self.y + s * u + c * v) for u, v in ring])


ANGLES = st.sampled_from([0.0, math.pi / 2, math.pi, -math.pi / 4]) | st.floats(-math.pi, math.pi)
PLACES = st.sampled_from([0.0, 1.0, -1.0]) | st.floats(-3, 3)
BOXES = st.builds(Box, PLACES, PLACES, ANGLES, st.floats(0.05, 2), st.floats(0.05, 2))


def exact(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return the function compiled for float64, giving NumPy arrays."""
    compiled = jax.jit(function)

    def call(*args: Any) -> Any:
        with jax.enable_x64(True):
            return jax.tree.map(np.asarray, compiled(*args))

    return call
