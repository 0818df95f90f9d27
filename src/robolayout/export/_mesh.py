"""Triangles with normals, and boxes recognised among convex parts."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robolayout import _color
from robolayout.assets import Material, Part
from robolayout.assets.textures import coordinates, mean

CREASE = math.cos(math.radians(40.0))  # cosine of the angle between two faces above which their edge is drawn sharp

SMALLEST_FACE = 1e-12  # area in square metres below which a triangle is dropped: it has no direction

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class DrawnSurface:
    """Triangles of one material, ready to be drawn."""

    positions: FloatArray  # (n, 3) metres
    normals: FloatArray  # (n, 3) unit vectors, one for each position unless said otherwise
    indices: IntArray  # (m, 3) counter-clockwise seen from outside
    uvs: FloatArray  # texture coordinates, as many as normals; all 0 where the material is plain


@dataclass(frozen=True, eq=False)
class Box:
    """An oriented box."""

    center: FloatArray  # (3,) metres
    half: FloatArray  # (3,) half extents in metres along its own axes
    rotation: FloatArray  # (3, 3) whose columns are its axes; right-handed


def welded(part: Part) -> DrawnSurface:
    """Return a part's triangles with equal corners joined; normals are (3 m, 3), one for each corner of each face."""
    positions, inverse = _unique_rows(np.asarray(part.vertices, np.float64))
    faces = inverse[np.asarray(part.faces, np.int64)]
    cross = np.cross(positions[faces[:, 1]] - positions[faces[:, 0]], positions[faces[:, 2]] - positions[faces[:, 0]])
    area = np.linalg.norm(cross, axis=1) / 2
    keep = area > SMALLEST_FACE
    faces, units = faces[keep], cross[keep] / (2 * area[keep, None])
    uvs = coordinates(part)[keep].reshape(-1, 2).astype(np.float64)
    return DrawnSurface(positions, _corner_normals(positions, faces, units), faces, uvs)


def surface(part: Part) -> DrawnSurface:
    """Return a part's triangles with one normal for each vertex; vertices on sharp edges are repeated."""
    shape = welded(part)
    rows = np.hstack([shape.positions[shape.indices.reshape(-1)], shape.normals, shape.uvs])
    corners, indices = _unique_rows(np.round(rows, 9))
    lengths = np.linalg.norm(corners[:, 3:6], axis=1, keepdims=True)
    return DrawnSurface(corners[:, :3], corners[:, 3:6] / lengths, indices.reshape(-1, 3), corners[:, 6:])


def _unique_rows(rows: FloatArray) -> tuple[FloatArray, IntArray]:
    """Return the distinct rows, sorted, and the place of every row among them."""
    distinct, _, places = np.unique(rows, axis=0, return_index=True, return_inverse=True)  # of equal rows the first
    return distinct, places.reshape(-1)


def _corner_normals(positions: FloatArray, faces: IntArray, units: FloatArray) -> FloatArray:
    """Return (3 m, 3) unit normals of face corners.

    Each is the mean of the face normals around its vertex that lie within the crease, weighted by the faces' angles there,
    so that it does not depend on how a flat side is cut into triangles.
    """
    owner = np.repeat(np.arange(len(faces)), 3)
    here = positions[faces]
    ahead, behind = np.roll(here, -1, axis=1) - here, np.roll(here, 1, axis=1) - here
    lengths = np.linalg.norm(ahead, axis=2) * np.linalg.norm(behind, axis=2)
    cosine = np.einsum("ijk,ijk->ij", ahead, behind) / np.maximum(lengths, SMALLEST_FACE)
    weighted = units[owner] * np.arccos(np.clip(cosine, -1.0, 1.0)).reshape(-1, 1)
    order = np.argsort(faces.reshape(-1), kind="stable")
    starts = np.flatnonzero(np.diff(faces.reshape(-1)[order], prepend=-1))
    total = np.zeros((len(owner), 3))
    for ring in np.split(order, starts[1:]):
        around = units[owner[ring]]
        total[ring] = (around @ around.T >= CREASE) @ weighted[ring]
    length = np.linalg.norm(total, axis=1, keepdims=True)
    return np.where(length > SMALLEST_FACE, total / np.maximum(length, SMALLEST_FACE), units[owner])


def merged(parts: tuple[Part, ...]) -> tuple[tuple[Material, bool, DrawnSurface], ...]:
    """Return one surface per material, in order of appearance, and whether all its parts are closed and convex."""
    groups: dict[Material, list[Part]] = {}
    for part in parts:
        groups.setdefault(part.material, []).append(part)
    return tuple(
        (material, all(part.convex for part in group), _joined([surface(part) for part in group]))
        for material, group in groups.items()
    )


def _joined(surfaces: list[DrawnSurface]) -> DrawnSurface:
    offsets = np.cumsum([0] + [len(s.positions) for s in surfaces[:-1]])
    return DrawnSurface(
        np.vstack([s.positions for s in surfaces]),
        np.vstack([s.normals for s in surfaces]),
        np.vstack([s.indices + offset for s, offset in zip(surfaces, offsets, strict=True)]),
        np.vstack([s.uvs for s in surfaces]),
    )


def as_box(part: Part, tolerance: float = 1e-6) -> Box | None:
    """Return the oriented box that a part is, or None if it is no box."""
    corners, _ = _unique_rows(np.round(np.asarray(part.vertices, np.float64), 9))
    if len(corners) != 8:
        return None
    center = corners.mean(axis=0)
    offsets = corners[1:] - corners[0]
    edges = _right_edges(offsets[np.argsort(np.linalg.norm(offsets, axis=1), kind="stable")])
    if edges is None:
        return None
    lengths = np.linalg.norm(edges, axis=1)
    axes = edges / lengths[:, None]
    local = np.abs((corners - center) @ axes.T)
    if np.abs(local - lengths / 2).max() > tolerance:
        return None
    return _upright(Box(center, lengths / 2, axes.T))


def _right_edges(offsets: FloatArray) -> FloatArray | None:
    """Return the first three mutually orthogonal offsets (shortest first), or None."""
    chosen: list[FloatArray] = []
    for offset in offsets:
        length = float(np.linalg.norm(offset))
        if all(abs(offset @ other) <= 1e-6 * length * float(np.linalg.norm(other)) for other in chosen):
            chosen.append(offset)
        if len(chosen) == 3:
            return np.array(chosen)
    return None


def _upright(box: Box) -> Box:
    """Return the same box with its axes ordered as near to x, y, z as they can be, and right-handed."""
    order: list[int] = []
    for row in range(3):
        free = [axis for axis in range(3) if axis not in order]
        order.append(max(free, key=lambda axis: (round(abs(float(box.rotation[row, axis])), 9), -axis)))
    rotation = box.rotation[:, order]
    signs = np.array([1.0 if rotation[i, i] >= 0 else -1.0 for i in range(3)])
    rotation = rotation * signs
    if np.linalg.det(rotation) < 0:
        rotation = rotation * np.array([1.0, 1.0, -1.0])
    return Box(box.center, box.half[order], rotation + 0.0)


def quaternion(rotation: FloatArray) -> tuple[float, float, float, float]:
    """Return (w, x, y, z) of a rotation matrix, with w >= 0."""
    from scipy.spatial.transform import Rotation

    x, y, z, w = (Rotation.from_matrix(rotation).as_quat(canonical=True) + 0.0).tolist()
    return (w, x, y, z)


def linear(color: tuple[float, float, float]) -> tuple[float, float, float]:
    """Return an sRGB colour as linear light, which is what GLB and USD store (IEC 61966-2-1)."""
    red, green, blue = _color.linear(np.array(color)).tolist()
    return (red, green, blue)


def base_color(material: Material) -> tuple[float, float, float]:
    """Return the linear colour that a material's texture is multiplied by, so that both together look like its colour."""
    share = (1.0, 1.0, 1.0) if material.texture is None else mean(material.texture)
    red, green, blue = (min(channel / part, 1.0) for channel, part in zip(linear(material.color), share, strict=True))
    return (red, green, blue)


def volume(part: Part) -> float:
    """Return the volume in cubic metres that a part's faces enclose; for open surfaces, that of its bounding box."""
    if not part.convex:
        return float(np.ptp(part.vertices, axis=0).prod())
    a, b, c = (part.vertices[part.faces[:, corner]] for corner in range(3))
    return abs(float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum())) / 6


def numbers(values: Iterable[float]) -> str:
    """Return numbers with nine digits, separated by blanks."""
    return " ".join(f"{value + 0.0:.9g}" for value in values)


def roll_pitch_yaw(rotation: FloatArray) -> FloatArray:
    """Return roll, pitch and yaw in radians of a rotation matrix (turned about the fixed x, then y, then z)."""
    from scipy.spatial.transform import Rotation

    return Rotation.from_matrix(rotation).as_euler("xyz")


def obj(vertices: FloatArray, faces: NDArray[np.int32]) -> bytes:
    """Return triangles as a Wavefront OBJ file, without a look."""
    lines = [f"v {numbers(point)}" for point in vertices.tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (faces + 1).tolist()]
    return "\n".join([*lines, ""]).encode()
