"""Meshes: GLB, OBJ, PLY, STL and, of robots, COLLADA from bytes, within bounds, as placed triangles with their looks.

What a file promises is counted before its parser makes room for it. Nothing outside the given bytes is opened: materials
and textures in separate files are ignored.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout._color import encoded, linear
from robolayout._reading.glb import check_glb
from robolayout._reading.limits import LIMITS
from robolayout._reading.syntax import FOREIGN_ERRORS, Unreadable, decoded, xml_root

Array = NDArray[np.float64]

_PIECES = {
    ".obj": re.compile(rb"^[ \t]*(?:[og]|usemtl)\b", re.MULTILINE),
    ".stl": re.compile(rb"^\s*solid", re.MULTILINE),
}
_FACES = {".obj": re.compile(rb"^[ \t]*f\b", re.MULTILINE), ".stl": re.compile(rb"^\s*facet\b", re.MULTILINE)}

UNSAID = [102, 102, 102, 255]
"""The colour that trimesh gives to what has none, for example where an OBJ's material file is missing."""


@dataclass(frozen=True)
class Look:
    """What a piece looks like."""

    # red, green, blue (sRGB) and opacity from 0 to 1: of the whole, if there is a picture
    color: tuple[float, float, float, float]
    roughness: float = 0.8  # 0 mirror, 1 chalk
    metallic: float = 0.0  # 0 or 1, or between
    picture: bytes | None = None  # A JPEG of its surface; None for none


@dataclass(frozen=True, eq=False)
class Piece:
    """One piece of a mesh file in the file's own axes and units."""

    name: str  # name in the file
    vertices: Array  # (n, 3) in file units, placed by the file's scene
    faces: NDArray[np.int64]  # (m, 3) vertex indices
    look: Look | None  # what it looks like; None where the file says nothing
    # (n, 2) where its vertices lie in the picture, (0, 0) at the top left; None without a picture
    uv: Array | None = None


def mesh_pieces(data: bytes, suffix: str) -> tuple[Piece, ...]:
    """Return the triangle pieces of a mesh file of a kind of `MESH_SUFFIXES`; raises `Unreadable` for a broken one."""
    try:
        _check_promises(data, suffix)
        pieces = tuple(_pieces(data, suffix[1:]))
    except FOREIGN_ERRORS as error:
        short = " ".join(str(error).split())[:120].rstrip(".") or type(error).__name__
        raise Unreadable(f"is broken and cannot be used: {short}") from None
    if not pieces:
        raise Unreadable("holds no triangles; export it again as a triangle mesh")
    return pieces


def _check_promises(data: bytes, suffix: str) -> None:
    """Refuse a file that promises more than is read, before anything is unpacked."""
    if suffix == ".glb":
        check_glb(data)
    elif suffix == ".ply":
        _check_ply(data)
    elif suffix == ".dae":
        xml_root(decoded(data))
    else:
        for what, found, most in (("pieces", _PIECES, LIMITS.pieces), ("triangles", _FACES, LIMITS.triangles)):
            if (count := sum(1 for _ in found[suffix].finditer(data))) > most:
                raise Unreadable(f"has {count} {what}; at most {most} are read. Simplify it and export it again")


def _check_ply(data: bytes) -> None:
    head = data[:65_536].split(b"end_header")[0]
    rows = [line.split() for line in head.splitlines()]
    counts = [row[2] for row in rows if len(row) == 3 and row[0] == b"element"]
    if not all(count.isdigit() and len(count) < 16 for count in counts):
        raise Unreadable("is broken and cannot be used: its header counts elements with what is no number")
    count = sum(map(int, counts))
    if count > len(data):
        raise Unreadable(f"is broken and cannot be used: its header promises {count} elements")
    if count > 3 * LIMITS.triangles:
        raise Unreadable(
            f"has {count} elements; at most {3 * LIMITS.triangles} are read. Simplify it and export it again"
        )


def _pieces(data: bytes, kind: str) -> Iterator[Piece]:
    """Yield the triangle pieces of a file, placed by its scene graph."""
    import trimesh

    scene = trimesh.load_scene(io.BytesIO(data), file_type=kind, process=False)
    total, looks = 0, dict[int, Look | None]()
    for node in sorted(scene.graph.nodes_geometry):
        matrix, key = scene.graph[node]
        mesh = scene.geometry[key]
        if not isinstance(mesh, trimesh.Trimesh) or len(mesh.faces) == 0:
            continue
        total += len(mesh.faces)
        if total > LIMITS.triangles:
            raise Unreadable(f"unfolds to more than {LIMITS.triangles} triangles. Simplify it and export it again")
        piece = _cleaned(str(key), mesh, np.asarray(matrix), looks, kind)
        if piece is not None:
            yield piece


def _cleaned(name: str, mesh: Any, matrix: Array, looks: dict[int, Look | None], kind: str) -> Piece | None:
    """Place a piece and drop triangles with unusable numbers; None where nothing is left."""
    points, faces = np.asarray(mesh.vertices), np.asarray(mesh.faces)
    with np.errstate(all="ignore"):
        placed = points @ matrix[:3, :3].T + matrix[:3, 3]
        usable = np.asarray((np.isfinite(placed) & (np.abs(placed) < LIMITS.coordinate)).all(axis=1))
        mirrored = np.linalg.det(matrix[:3, :3]) < 0
    inside = ((faces >= 0) & (faces < len(points))).all(axis=1)
    faces = faces[inside]
    faces = faces[usable[faces].all(axis=1)]
    if len(faces) == 0:
        return None
    if mirrored:
        faces = faces[:, ::-1]
    used, index = np.unique(faces, return_inverse=True)
    visual = mesh.visual
    key = id(getattr(visual, "material", mesh))
    if key not in looks:
        looks[key] = _look(visual, kind)
    look, uv = looks[key], getattr(visual, "uv", None)
    if look is None or look.picture is None:
        return Piece(name, placed[used], index.reshape(-1, 3), look)
    far = LIMITS.coordinate
    flipped = np.nan_to_num(np.clip(np.asarray(uv, np.float64)[used], -far, far)) * (1, -1) + (0, 1)
    return Piece(name, placed[used], index.reshape(-1, 3), look, flipped)


def _look(visual: Any, kind: str) -> Look | None:
    """Return what a mesh looks like: its material with its picture, or its mean vertex colour; None if it does not say.

    Factors are in linear light in a GLB, as its standard says, and sRGB in other files.
    """
    if visual is None or not getattr(visual, "defined", False):
        return None
    if visual.kind != "texture":
        return Look(_color(np.asarray(visual.main_color, dtype=np.float64)[:4] / 255.0))
    surface = visual.material
    if list(getattr(surface, "diffuse", ())) == UNSAID:
        return None
    surface = surface.to_pbr() if hasattr(surface, "to_pbr") else surface
    factor = getattr(surface, "baseColorFactor", None)
    color = np.ones(4) if factor is None else np.asarray(factor, dtype=np.float64)
    color = color / 255.0 if color.max() > 1.0 else color
    light = color[:3] if kind == "glb" else linear(color[:3])
    image = getattr(surface, "baseColorTexture", None)
    if image is not None:
        light = light * linear(np.asarray(image.convert("RGB"), dtype=np.float64) / 255.0).mean(axis=(0, 1))
    content = io.BytesIO()
    if image is not None and getattr(visual, "uv", None) is not None:
        picture = image.convert("RGB")
        picture.thumbnail((LIMITS.picture, LIMITS.picture))
        picture.save(content, "JPEG", quality=88)
    rough, metal = (getattr(surface, f"{name}Factor", None) for name in ("roughness", "metallic"))
    return Look(
        _color(np.append(encoded(light), color[3:4])),
        0.8 if rough is None else float(np.clip(np.nan_to_num(rough), 0.0, 1.0)),
        0.0 if metal is None else float(np.clip(np.nan_to_num(metal), 0.0, 1.0)),
        content.getvalue() or None,
    )


def _color(color: Array) -> tuple[float, float, float, float]:
    """Return three or four channels as usable ones, from 0 to 1."""
    red, green, blue = (round(float(channel), 4) for channel in np.clip(np.nan_to_num(color[:3]), 0.0, 1.0))
    opacity = float(np.clip(np.nan_to_num(color[3], nan=1.0), 0.05, 1.0)) if len(color) > 3 else 1.0
    return red, green, blue, round(opacity, 4)
