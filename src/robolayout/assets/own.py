"""A user's own meshes: read within bounds, turned upright and forwards, scaled into an asset's box.

glTF files are y-up and face +z by their standard; other files are taken z-up facing +x unless their shape or the caller
says otherwise. Nothing outside the given file is opened: materials and textures in separate files are ignored, those in the file kept.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from robolayout._errors import AssetError
from robolayout._reading import LIMITS, MESH_SUFFIXES, Checker, regular_bytes
from robolayout._reading.mesh import Look, mesh_pieces
from robolayout.assets.part import Material, Part, fit
from robolayout.assets.rows import check_rows
from robolayout.scene import Scene

Array = NDArray[np.float64]
Size = tuple[float, float, float]

PLAIN = Material("own mesh", (0.72, 0.70, 0.67), 0.8)
AXES: dict[str, tuple[float, float, float]] = {
    sign + axis: tuple((1.0 if sign == "+" else -1.0) * (axis == other) for other in "xyz")  # type: ignore[misc]
    for sign in "+-"
    for axis in "xyz"
}
"""Unit vectors by name: "+x", "-y", ..."""
_CHECK = Checker(AssetError)


def load_mesh_parts(path: Path, size: Size, *, up: str | None = None, front: str | None = None) -> tuple[Part, ...]:
    """Load a mesh file and fit it into a box of `size` (depth, width, height) about the origin, facing +x.

    Args:
        path: A GLB, OBJ, STL or PLY file of at most 100 MB.
        size: Depth, width and height of the box in metres.
        up: The file's axis that points up ("+y"); None follows the format, or the shape where the format has no rule.
        front: The file's axis that points forward ("+z"); None follows the format.
    """
    edges, pieces = _thin_pieces(path)
    matrix = orientation(path, edges, size, up=up, front=front)
    return fit((replace(piece, vertices=piece.vertices @ matrix.T) for piece in pieces), size)


def orientation(path: Path, edges: Size, size: Size, *, up: str | None, front: str | None) -> Array:
    """Return the rotation from the file's axes to depth, width, height."""
    for axis in (up, front):
        if axis is not None and axis not in AXES:
            raise AssetError(f"mesh {path.name}: {axis!r} is no axis; use one of {', '.join(sorted(AXES))}.")
    upward = up or ("+y" if path.suffix.lower() == ".glb" or fits_y_up(edges, size) else "+z")
    forward = front or ("+x" if upward[1] == "z" else "+z" if upward[1] == "y" else "+y")
    if upward[1] == forward[1]:
        raise AssetError(f"mesh {path.name}: up {upward!r} and front {forward!r} must be different axes.")
    u, f = np.array(AXES[upward]), np.array(AXES[forward])
    return np.array([f, np.cross(u, f), u])


def fits_y_up(edges: Size, size: Size) -> bool:
    """Return whether a mesh with these edges fills the box clearly better when its y axis is taken as up: is scaled less unevenly."""
    stretch = np.log(np.maximum(np.array(edges), 1e-9))[[[0, 1, 2], [1, 0, 2], [2, 0, 1], [0, 2, 1]]] - np.log(size)
    z_up, y_up = np.ptp(stretch, axis=1).reshape(2, 2).min(axis=1)
    return bool(y_up < z_up - 0.1)


def extent(pieces: Iterable[Part]) -> Size:
    """Return the edges of the box around all pieces, in file units and axes."""
    depth, width, height = np.ptp(np.concatenate([piece.vertices for piece in pieces]), axis=0).tolist()
    return (depth, width, height)


def read_pieces(path: Path) -> tuple[Part, ...]:
    """Read a mesh file into its pieces, in the file's axes and units."""
    suffix = path.suffix.lower()
    if suffix not in MESH_SUFFIXES:
        raise AssetError(f"mesh {path.name}: format {suffix!r} is not read; use one of {', '.join(MESH_SUFFIXES)}.")
    data = _CHECK.parse(lambda file: regular_bytes(file, LIMITS.mesh_bytes), path, f"mesh {path.name}")
    pieces = _CHECK.parse(lambda content: mesh_pieces(content, suffix), data, f"mesh {path.name}")
    return tuple(Part(p.name, p.vertices, p.faces.astype(np.int32), _material(p.look), False, p.uv) for p in pieces)


def _material(look: Look | None) -> Material:
    if look is None:
        return PLAIN
    return Material(PLAIN.name, look.color[:3], look.roughness, look.metallic, look.color[3], texture=look.picture)


def check_meshes(scene: Scene) -> None:
    """Read the mesh file and the parts of every asset that has them, so that what is broken is known before any work."""
    for asset in scene.assets:
        if asset.parts:
            check_rows(asset.parts, f"asset {asset.name!r}", asset.size)
        if asset.path is not None:
            try:
                _thin_pieces(asset.path)
            except AssetError as error:
                raise AssetError(f"asset {asset.name!r}: {error} Or leave path out for a built-in shape.") from error


def _thin_pieces(path: Path) -> tuple[Size, tuple[Part, ...]]:
    """Return the edges of a file's mesh and its pieces, thinned; each version of a file is read once."""
    try:
        changed = path.stat().st_mtime_ns
    except OSError as error:
        raise AssetError(f"mesh {path.name} cannot be read: {error.strerror or error}.") from error
    return _thin_version(path, changed)


@lru_cache(maxsize=64)
def _thin_version(path: Path, changed: int) -> tuple[Size, tuple[Part, ...]]:
    """Read one version of a file; `changed` tells versions apart."""
    pieces = read_pieces(path)
    return extent(pieces), tuple(_thinned(pieces))


def _thinned(pieces: Sequence[Part]) -> list[Part]:
    """Merge and thin pieces so that neither their number nor their triangles exceed the bounds."""
    if len(pieces) > LIMITS.drawn_parts:
        pieces = _by_material(pieces)
    total = sum(len(piece.faces) for piece in pieces)
    if total <= LIMITS.drawn_triangles:
        return list(pieces)
    return [_clustered(piece, max(200, int(LIMITS.drawn_triangles * len(piece.faces) / total))) for piece in pieces]


def _by_material(pieces: Sequence[Part]) -> list[Part]:
    """Merge pieces of one look; where there are still too many looks, the smallest take the nearest plain colour of the others."""
    groups: dict[Material, list[Part]] = {}
    for piece in pieces:
        groups.setdefault(piece.material, []).append(piece)
    if len(groups) > LIMITS.drawn_parts:
        looks = sorted(groups, key=lambda look: -sum(len(piece.faces) for piece in groups[look]))
        kept = looks[: LIMITS.drawn_parts - 1]
        plain = [look for look in kept if look.texture is None] or [replace(kept[0], texture=None)]
        for look in looks[LIMITS.drawn_parts - 1 :]:
            near, rest = min(plain, key=lambda other: math.dist(other.color, look.color)), groups.pop(look)
            groups.setdefault(near, []).extend(replace(piece, material=near, uv=None) for piece in rest)
    return [_joined(row) for row in groups.values()]


def _joined(row: Sequence[Part]) -> Part:
    """Join pieces into one with the first one's name and material."""
    starts = np.cumsum([0] + [len(piece.vertices) for piece in row])
    faces = np.concatenate([piece.faces + start for piece, start in zip(row, starts, strict=False)]).astype(np.int32)
    uvs = [piece.uv for piece in row if piece.uv is not None]
    points = np.concatenate([piece.vertices for piece in row])
    return replace(row[0], vertices=points, faces=faces, uv=np.concatenate(uvs) if uvs else None)


def _clustered(piece: Part, most: int) -> Part:
    """Thin a piece to at most `most` triangles: vertices in one cell of a grid become one, at their mean."""
    if len(piece.faces) <= most:
        return piece
    low, cells = piece.vertices.min(axis=0), float(np.sqrt(most))
    edge = float(np.ptp(piece.vertices, axis=0).max()) or 1.0
    while True:
        grid = np.floor((piece.vertices - low) / edge * cells).astype(np.int64) @ (1 << 42, 1 << 21, 1)
        _, first, index, counts = np.unique(grid, return_index=True, return_inverse=True, return_counts=True)
        faces = index[piece.faces]
        ordered = np.sort(faces, axis=1)
        alive = (np.diff(ordered, axis=1) > 0).all(axis=1)  # what is collapsed or stands twice is dropped
        _, once = np.unique(ordered[alive], axis=0, return_index=True)
        faces = faces[alive][np.sort(once)].astype(np.int32)
        if len(faces) <= most:
            break
        cells *= min(0.9, 0.97 * float(np.sqrt(most / len(faces))))
    points = np.stack([np.bincount(index, weights=row) / counts for row in piece.vertices.T], axis=1)
    return replace(piece, vertices=points, faces=faces, uv=None if piece.uv is None else piece.uv[first])
