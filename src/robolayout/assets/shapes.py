"""Convex pieces to build furniture from: boxes, cushions, prisms, cylinders, balls.

All take ranges in metres in the furniture's building frame: x forward, y left, z up from the floor, origin on the floor
under the middle of the box. Faces are counter-clockwise seen from outside.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout.assets.part import Material, Part

Range = Sequence[float]
Array = NDArray[np.float64]
Faces = NDArray[np.int32]

ORDER = {"z": [0, 1, 2], "x": [2, 0, 1], "y": [1, 2, 0]}
"""By the axis along which a thing is drawn out: where the coordinates go of one that is drawn out along z."""
_BOX_FACES = (
    (0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
    (1, 5, 7), (1, 7, 3),
)  # fmt: skip


def box(name: str, material: Material, x: Range, y: Range, z: Range, *, top: Range | None = None) -> Part:
    """Return a box over three ranges, its upper face scaled about its middle by `top`; vertex i has bits x, y, z from the most
    significant."""
    points = np.array(list(product(sorted(x), sorted(y), sorted(z))), dtype=np.float64)
    if top is not None:
        middle, upper = points[:, :2].mean(axis=0), points[:, 2] > points[:, 2].mean()
        points[upper, :2] = middle + (points[upper, :2] - middle) * np.array(top)
    return Part(name, points, np.array(_BOX_FACES, dtype=np.int32), material)


def soft(name: str, material: Material, x: Range, y: Range, z: Range, *, bevel: float = 0.03) -> Part:
    """Return a box with bevelled edges: a cushion, a mattress, a casing."""
    low, high = _corners(x, y, z)
    cut = np.minimum(bevel, 0.45 * (high - low))
    far = np.repeat(np.array(list(product((False, True), repeat=3))), 3, axis=0)
    corner, inner = np.where(far, high, low), np.where(far, high - cut, low + cut)
    return Part(name, np.where(np.tile(np.eye(3), (8, 1)) > 0, corner, inner), _soft_faces(), material)


def prism(name: str, material: Material, outline: Sequence[Range], span: Range, *, axis: str = "z") -> Part:
    """Return a convex outline, counter-clockwise, drawn out along an axis over `span`.

    The outline's two coordinates are (x, y) for axis z, (y, z) for axis x and (z, x) for axis y.
    """
    low = [(u, v, span[0]) for u, v in outline]
    high = [(u, v, span[1]) for u, v in outline]
    return Part(name, np.array(low + high)[:, ORDER[axis]], _drum_faces(len(outline)), material)


def cylinder(
    name: str,
    material: Material,
    center: Range,
    radii: Sequence[Range],
    span: Range,
    *,
    axis: str = "z",
    sides: float = 16,
) -> Part:
    """Return an elliptic frustum; `radii` are the two half-axes at the start and at the end of its span.

    `center` is in the plane across the axis: (x, y) for axis z, (y, z) for axis x, (z, x) for axis y.
    """
    sides = round(sides)
    turn = [2 * math.pi * (i + 0.5) / sides for i in range(sides)]
    stretch = 1 / math.cos(math.pi / sides)
    rows = [
        (center[0] + a * stretch * math.cos(t), center[1] + b * stretch * math.sin(t), level)
        for (a, b), level in zip(radii, span, strict=True)
        for t in turn
    ]
    points = np.array(rows)
    reach = np.repeat(np.array(radii), sides, axis=0)
    points[:, :2] = np.clip(points[:, :2], np.array(center) - reach, np.array(center) + reach)
    faces = _drum_faces(sides) if radii[0] == radii[1] else _bulging(points, _drum_faces(sides))
    return Part(name, points[:, ORDER[axis]], faces, material)


def ball(name: str, material: Material, x: Range, y: Range, z: Range, *, rings: float = 5, sides: float = 12) -> Part:
    """Return a low-poly ellipsoid that fills the three ranges."""
    low, high = _corners(x, y, z)
    points, faces = _unit_ball(round(rings), round(sides))
    return Part(name, (low + high) / 2 + points * (high - low) / 2, faces, material)


def spun(part: Part, turn: float) -> Part:
    """Return a part turned by `turn` radians about the z axis through the origin."""
    c, s = math.cos(turn), math.sin(turn)
    return replace(part, vertices=part.vertices @ [[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])


def _corners(x: Range, y: Range, z: Range) -> tuple[Array, Array]:
    """Return the low and the high corner of three ranges."""
    return np.array([min(r) for r in (x, y, z)]), np.array([max(r) for r in (x, y, z)])


@cache
def _drum_faces(sides: int) -> Faces:
    """Return the faces of two rings of `sides` points, the lower first."""
    ring = [(i, (i + 1) % sides) for i in range(sides)]
    walls = [(i, j, j + sides) for i, j in ring] + [(i, j + sides, i + sides) for i, j in ring]
    fan = range(1, sides - 1)
    caps = [(0, i + 1, i) for i in fan] + [(sides, sides + i, sides + i + 1) for i in fan]
    return np.array(walls + caps, dtype=np.int32)


def _bulging(points: Array, faces: Faces) -> Faces:
    """Turn the diagonals of a drum's side quads outwards, so that two different ellipses make a convex piece."""
    sides = len(points) // 2
    low = np.arange(sides)
    a, b, c, d = low, (low + 1) % sides, (low + 1) % sides + sides, low + sides
    normal = np.cross(points[b] - points[a], points[c] - points[a])
    hollow = np.einsum("ij,ij->i", normal, points[d] - points[a]) > 1e-12
    turned = faces.copy()
    turned[:sides][hollow] = np.stack([a, b, d], axis=1)[hollow]
    turned[sides : 2 * sides][hollow] = np.stack([b, c, d], axis=1)[hollow]
    return turned


@cache
def _unit_ball(rings: int, sides: int) -> tuple[Array, Faces]:
    """Return vertices and faces of a unit ball: two poles and `rings` rings, scaled to touch all six sides."""
    rows = [(0.0, 0.0, -1.0)]
    for level in np.linspace(0.0, math.pi, rings + 2)[1:-1].tolist():
        around = [2 * math.pi * i / sides for i in range(sides)]
        rows += [(math.sin(level) * math.cos(a), math.sin(level) * math.sin(a), -math.cos(level)) for a in around]
    points = np.array([*rows, (0.0, 0.0, 1.0)])
    points /= np.abs(points).max(axis=0)
    ends = [(0, 1 + i, 1 + (i + 1) % sides) for i in range(sides)]
    ends += [(len(points) - 1 - a, len(points) - 1 - b, len(points) - 1 - c) for a, b, c in ends]
    walls = [_drum_faces(sides)[: 2 * sides] + 1 + ring * sides for ring in range(rings - 1)]
    return points, _outward(points, np.concatenate([ends, *walls]))


@cache
def _soft_faces() -> Faces:
    """Return the 44 triangles of a bevelled box, vertex 3 c + axis that of corner c at its end along an axis (see `soft`)."""
    corners = np.repeat(np.array(list(product((-1.0, 1.0), repeat=3))), 3, axis=0)
    quads = list[tuple[int, int, int, int]]()
    for axis in range(3):
        u, v = (other for other in range(3) if other != axis)
        far, ring = 4 >> axis, [0, 4 >> u, (4 >> u) + (4 >> v), 4 >> v]
        for end in (0, far):
            a, b, c, d = (3 * (end + corner) + axis for corner in ring)
            quads.append((a, b, c, d))
        quads += [(3 * c + u, 3 * c + v, 3 * (c + far) + v, 3 * (c + far) + u) for c in ring]
    faces = [(3 * corner, 3 * corner + 1, 3 * corner + 2) for corner in range(8)]
    faces += [face for a, b, c, d in quads for face in ((a, b, c), (a, c, d))]
    return _outward(corners * np.where(np.tile(np.eye(3), (8, 1)) > 0, 1.0, 0.7), np.array(faces))


def _outward(points: Array, faces: NDArray[np.signedinteger[Any]]) -> Faces:
    """Turn the triangles of a convex shape about the origin counter-clockwise, seen from outside."""
    a, b, c = np.moveaxis(points[faces], 1, 0)
    inside_out = (np.cross(b - a, c - a) * a).sum(axis=1) < 0
    return np.where(inside_out[:, None], faces[:, ::-1], faces).astype(np.int32)


def wrapped(points: Array) -> Faces:
    """Return the triangles of the convex hull of points, counter-clockwise seen from outside."""
    from scipy.spatial import ConvexHull  # takes a sixth of a second to import

    return _outward(points - points.mean(axis=0), ConvexHull(points).simplices)
