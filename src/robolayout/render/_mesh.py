"""Scene and layout as one soup of coloured triangles, the common input of both renderers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout._color import linear
from robolayout.assets import Material, Part, parts, room_parts
from robolayout.assets.textures import coordinates, mean
from robolayout.render._style import LIGHT
from robolayout.scene import Layout, Pose, Room, Scene

ROOM = 0  # id of floor and walls; asset k of the scene has id k + 1. The background has id -1.
ROWS = ("corners", "normals", "colors", "gloss", "glow", "uvs", "layers", "ids", "groups")
"""The fields of a mesh that have a row for each triangle."""

CEILING = "/ceiling"
FLOOR_STRIP = "/strip"  # names of parts that the views add to the room; no asset's name has a slash


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles in the world frame."""

    corners: NDArray[np.float32]  # (n, 3, 3) corner positions in metres
    normals: NDArray[np.float32]  # (n, 3, 3) unit shading normals at the corners
    colors: NDArray[np.float32]  # (n, 4) linear colour and opacity
    gloss: NDArray[np.float32]  # (n,) 0 chalk, 1 mirror
    glow: NDArray[np.float32]  # (n,) light given off, as a share of the colour
    uvs: NDArray[np.float32]  # (n, 3, 2) texture coordinates of the corners
    layers: NDArray[np.int32]  # (n,) index of a triangle's texture, whose mean `colors` make up for; -1 for none
    ids: NDArray[np.int32]  # (n,) ROOM or the asset's place in the scene plus 1
    groups: NDArray[np.int32]  # (n,) index of the part a triangle belongs to
    # name of each part: "floor", "wall-0", "door-0", "window-0" for the room, the asset's name for assets
    names: tuple[str, ...]
    convex: tuple[bool, ...]  # whether each part is closed and convex, so that triangles that face away are never seen
    textures: tuple[str | bytes, ...] = ()  # what `layers` count

    def __len__(self) -> int:
        return len(self.corners)

    @property
    def opaque(self) -> NDArray[np.bool_]:
        """Mask of triangles that hide what is behind them."""
        return self.colors[:, 3] > 0.99

    def take(self, which: NDArray[np.bool_] | NDArray[np.intp]) -> Mesh:
        """Return the triangles where a mask holds, or those with the given indices."""
        return replace(self, **{name: getattr(self, name)[which] for name in ROWS})

    def facing(self, eye: Sequence[float]) -> NDArray[np.bool_]:
        """Return the mask of triangles that may be seen from a point: not those of convex parts that face away."""
        first = self.corners[:, 0]
        outward = np.cross(self.corners[:, 1] - first, self.corners[:, 2] - first)
        toward = ((np.asarray(eye, np.float32) - first) * outward).sum(axis=1) > 0
        return toward | ~np.array(self.convex, dtype=np.bool_)[self.groups]

    def named(self, names: Iterable[str]) -> NDArray[np.bool_]:
        """Return the mask of triangles that belong to parts with these names."""
        wanted = set(names)
        return np.array([name in wanted for name in self.names], dtype=np.bool_)[self.groups]


def scene_mesh(scene: Scene, layout: Layout, seed: int = 0) -> Mesh:
    """Return the mesh of the room and of all assets that have a pose."""
    pieces = [(part, part.name, None, ROOM) for part in room_parts(scene.room)]
    for number, asset in enumerate(scene.assets, start=1):
        if asset.name in layout:
            pieces += [(part, asset.name, layout[asset.name], number) for part in parts(asset, seed)]
    return _soup(pieces)


def parts_mesh(pieces: Iterable[Part], name: str, number: int = 1) -> Mesh:
    """Return the mesh of one asset's parts in its own frame."""
    return _soup([(part, name, None, number) for part in pieces])


def ceiling_mesh(room: Room) -> Mesh:
    """Return a plain ceiling at wall height named CEILING, for views from inside the room."""
    polygon = shapely.Polygon(room.vertices).buffer(0.1, join_style="mitre")
    triangles = shapely.get_parts(shapely.constrained_delaunay_triangles(polygon))
    rings = shapely.get_coordinates(shapely.orient_polygons(triangles, exterior_cw=True)).reshape(-1, 4, 2)[:, :3]
    corners = np.dstack([rings, np.full((*rings.shape[:2], 1), room.wall_height)])
    return flat_mesh(corners, (0.97, 0.97, 0.96), CEILING)


def flat_mesh(corners: NDArray[np.floating], color: tuple[float, float, float], name: str) -> Mesh:
    """Return flat triangles (n, 3, 3) of one sRGB colour that belong to the room."""
    faces = np.arange(3 * len(corners), dtype=np.int32).reshape(-1, 3)
    vertices = np.asarray(corners, np.float64).reshape(-1, 3)
    return parts_mesh([Part(name, vertices, faces, Material(name, color, roughness=1.0), convex=False)], name, ROOM)


def merge(first: Mesh, second: Mesh) -> Mesh:
    """Return two meshes as one."""
    textures = tuple(dict.fromkeys(first.textures + second.textures))
    layers = np.array([*map(textures.index, second.textures), -1], np.int32)[second.layers]
    second = replace(second, groups=second.groups + np.int32(len(first.names)), layers=layers)
    joined = {name: np.concatenate([getattr(first, name), getattr(second, name)]) for name in ROWS}
    return Mesh(**joined, names=first.names + second.names, convex=first.convex + second.convex, textures=textures)


def refined(mesh: Mesh, longest: float, most: int = 120_000) -> Mesh:
    """Return the mesh with edges halved until none is longer than `longest` metres, or there are `most` triangles.

    Always the longest edge is halved, so neighbours are cut at the same points. Slivers stay as they are.
    """
    corners, parent = mesh.corners, np.arange(len(mesh))
    rest = np.concatenate([mesh.normals, mesh.uvs], axis=2)
    for _ in range(40):
        edges = np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2)
        area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
        split = (edges.max(axis=1, initial=0) > longest) & (area > LIGHT.sliver * longest**2)
        if not split.any() or len(corners) + split.sum() > most:
            break
        turn = (np.argmax(edges[split], axis=1)[:, None] + np.arange(3)) % 3
        rows = np.arange(len(turn))[:, None]
        corners = np.concatenate([corners[~split], *_halves(corners[split][rows, turn])])
        rest = np.concatenate([rest[~split], *_halves(rest[split][rows, turn])])
        parent = np.concatenate([parent[~split], parent[split], parent[split]])
    normals = rest[..., :3] / np.maximum(np.linalg.norm(rest[..., :3], axis=2, keepdims=True), 1e-12)
    return replace(mesh.take(parent), corners=corners, normals=normals.astype(np.float32), uvs=rest[..., 3:])


def welded(mesh: Mesh) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return one corner's index per distinct (position, normal, texture place, part), and (n, 3) places in that list."""
    columns = [
        np.round(mesh.corners.reshape(-1, 3) * 1e4),
        np.round(mesh.normals.reshape(-1, 3) * 30),
        np.round(mesh.uvs.reshape(-1, 2) * 1e3),
    ]
    keys = np.column_stack([*columns, np.repeat(mesh.groups, 3)]).astype(np.int64)
    _, first, place = np.unique(_hash(keys), return_index=True, return_inverse=True)
    return first, place.reshape(-1, 3)


def _hash(keys: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return one number per row of up to 9 integers."""
    factors = (
        1_000_003, 73_856_093, 153_230_071_873, 8_743_746_210_143, 15_485_863, 982_451_653, 32_416_190_071,
        2_971_215_073, 433_494_437,
    )  # fmt: skip
    return keys @ np.array(factors[: keys.shape[1]], dtype=np.int64)


def _halves(values: NDArray[np.float32]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Return both halves of triangles (n, 3, 3) cut at the middle of their first edge."""
    middle = (values[:, 0] + values[:, 1]) * np.float32(0.5)
    first = np.stack([values[:, 0], middle, values[:, 2]], axis=1)
    return first, np.stack([middle, values[:, 1], values[:, 2]], axis=1)


def _soup(pieces: Sequence[tuple[Part, str, Pose | None, int]]) -> Mesh:
    """Return one mesh of parts placed at poses (None: already in the world frame)."""
    of = np.repeat(np.arange(len(pieces), dtype=np.int32), [len(piece[0].faces) for piece in pieces])
    corners = np.concatenate([np.asarray(part.vertices, np.float64)[part.faces] for part, *_ in pieces])
    poses = np.array([(0, 0, 0, 0) if p is None else (p.x, p.y, p.z, p.yaw) for _, _, p, _ in pieces], dtype=np.float64)
    c, s = np.cos(poses[of, 3])[:, None], np.sin(poses[of, 3])[:, None]
    x, y = corners[..., 0], corners[..., 1]
    world = np.stack([c * x - s * y, s * x + c * y, corners[..., 2]], axis=-1) + poses[of, None, :3]
    materials = [part.material for part, *_ in pieces]
    tints = [1.0 if m.texture is None else 1.0 / np.array(mean(m.texture)) for m in materials]
    plain = [linear(np.clip(np.array(m.color[:3]), 0, 1)) for m in materials]
    tinted = [(*(color * tint), m.opacity) for color, tint, m in zip(plain, tints, materials, strict=True)]
    colors = np.array(tinted, dtype=np.float32)
    textures = tuple(dict.fromkeys(m.texture for m in materials if m.texture is not None))
    layers = np.array([-1 if m.texture is None else textures.index(m.texture) for m in materials], dtype=np.int32)
    uvs = np.concatenate([coordinates(part) for part, *_ in pieces])
    gloss = np.array([max(1 - m.roughness, 0.6 * m.metallic) for m in materials], dtype=np.float32)
    ids = np.array([number for *_, number in pieces], dtype=np.int32)
    normals = _normals(world, of).astype(np.float32)
    names = tuple(name for _, name, _, _ in pieces)
    convex = tuple(piece[0].convex for piece in pieces)
    glow = np.array([m.glow for m in materials], dtype=np.float32)
    rows = (world.astype(np.float32), normals, colors[of], gloss[of], glow[of], uvs, layers[of], ids[of], of)
    return Mesh(*rows, names, convex, textures)


def _normals(corners: NDArray[np.float64], of: NDArray[np.int32]) -> NDArray[np.float64]:
    """Return shading normals (n, 3, 3): the mean over faces of the same part that share the corner within `LIGHT.crease`.

    Corners are matched by position (0.1 mm); at most 16 faces around a corner are looked at.
    """
    face = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    unit = face / np.maximum(np.linalg.norm(face, axis=-1, keepdims=True), 1e-12)
    keys = _hash(np.column_stack([np.repeat(of, 3), np.round(corners.reshape(-1, 3) * 1e4)]).astype(np.int64))
    order = np.argsort(keys, kind="stable")
    group = keys[order]
    own, weighted = np.repeat(unit, 3, axis=0)[order], np.repeat(face, 3, axis=0)[order]
    total = weighted.copy()
    for shift in range(1, 16):
        same = group[shift:] == group[:-shift]
        if not same.any():
            break
        near = same & ((own[shift:] * own[:-shift]).sum(axis=-1) > LIGHT.crease)
        total[shift:][near] += weighted[:-shift][near]
        total[:-shift][near] += weighted[shift:][near]
    smooth = np.empty_like(total)
    smooth[order] = total / np.maximum(np.linalg.norm(total, axis=-1, keepdims=True), 1e-12)
    return smooth.reshape(-1, 3, 3)
