"""Rugs as they are exported: cut out around what stands on the floor through them, so that nothing goes through anything."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from robolayout.assets import Part, parts, prisms_of
from robolayout.assets.prisms import clipped
from robolayout.assets.rooms import extruded
from robolayout.export._mesh import FloatArray
from robolayout.scene import Asset, Layout, Pose, Scene, vertical_span

CLEAR = 0.001  # metres between a rug and what stands in its holes


def laid_parts(asset: Asset, scene: Scene, layout: Layout, *, seed: int = 0) -> tuple[Part, ...]:
    """Return the parts of a thing as they lie in a room: those of a rug have holes where others stand through it."""
    made = parts(asset, seed=seed)
    if not asset.is_flat or asset.name not in layout:
        return made
    holes = shapely.union_all([*_feet(asset, scene, layout)])
    cut = _cut if asset.path is None else _cut_mesh
    return tuple(piece for part in made for piece in cut(part, holes)) or made


def _feet(rug: Asset, scene: Scene, layout: Layout) -> Iterator[BaseGeometry]:
    """Yield what stands below the top of a rug, in plan, in its frame."""
    place, top = layout[rug.name], vertical_span(rug, layout[rug.name])[1]
    reach = math.hypot(*rug.size[:2]) / 2
    for other in scene.assets:
        pose = layout.get(other.name)
        if pose is None or other.is_flat or vertical_span(other, pose)[0] > top - CLEAR:
            continue
        if math.hypot(pose.x - place.x, pose.y - place.y) < reach + math.hypot(*other.size[:2]) / 2:
            for points in _low(other, top - pose.z):
                yield shapely.MultiPoint(_seen(points, pose, place)).convex_hull.buffer(CLEAR, join_style="mitre")


def _low(asset: Asset, top: float) -> Iterator[FloatArray]:
    """Yield the points in plan of each part of a thing below a height in its frame."""
    bottom = -asset.size[2] / 2
    if asset.path is not None:
        yield from (np.array(prism.outline) for prism in prisms_of(asset) if prism.low + bottom < top)
        return
    for part in parts(asset):
        if part.vertices[:, 2].min() < top - CLEAR:
            met = [points.reshape(-1, 3) for points in clipped(part.vertices[part.faces], bottom, top, math.inf)]
            yield np.concatenate([np.zeros((0, 3)), *met])[:, :2]


def _seen(points: FloatArray, pose: Pose, place: Pose) -> FloatArray:
    """Return points (n, 2) of one thing's frame in that of another."""
    (c, s), (a, b) = pose.forward, place.forward
    world = points @ np.array([[c, s], [-s, c]]) + (pose.x - place.x, pose.y - place.y)
    return world @ np.array([[a, -b], [b, a]])


def _cut(part: Part, holes: BaseGeometry) -> Iterator[Part]:
    """Yield what is left of a level part; the part itself where nothing stands in it."""
    whole = shapely.MultiPoint(part.vertices[:, :2]).convex_hull
    if not whole.intersects(holes):
        yield part
        return
    span = (float(part.vertices[:, 2].min()), float(part.vertices[:, 2].max()))
    for piece in shapely.get_parts(shapely.set_precision(whole.difference(holes), 1e-6)):
        if piece.geom_type == "Polygon" and piece.area > CLEAR**2:
            yield extruded(part.name, part.material, piece, span)


def _cut_mesh(part: Part, holes: BaseGeometry) -> Iterator[Part]:
    """Yield what is left of a mesh of one's own, triangle by triangle, with its texture; the part itself where nothing stands in it."""
    corners = part.vertices[part.faces]
    plans = [shapely.MultiPoint(triangle[:, :2]).convex_hull for triangle in corners]
    met = np.array([plan.intersects(holes) for plan in plans])
    if not met.any():
        yield part
        return
    given = part.vertices if part.uv is None else np.hstack([part.vertices, part.uv])
    found = [*given[part.faces[~met]]]
    for plan, face in ((plan, face) for plan, face, hit in zip(plans, part.faces, met, strict=True) if hit):
        if plan.area > CLEAR**2:  # one that stands upright goes with what it bounds
            kept = shapely.constrained_delaunay_triangles(plan.difference(holes))
            found += [_on(given[face], np.array(piece.exterior.coords)[2::-1]) for piece in shapely.get_parts(kept)]
    if found:
        rows = np.concatenate(found)
        faces = np.arange(len(rows), dtype=np.int32).reshape(-1, 3)
        yield replace(part, vertices=rows[:, :3], faces=faces, uv=None if part.uv is None else rows[:, 3:])


def _on(face: FloatArray, points: FloatArray) -> FloatArray:
    """Return what a triangle's corners say of each of three points in plan, wound as the triangle is."""
    shares = np.linalg.solve(np.vstack([face[:, :2].T, np.ones(3)]), np.vstack([points.T, np.ones(3)]))
    made = shares.T @ face
    turns = [np.linalg.det(corner[1:, :2] - corner[0, :2]) > 0 for corner in (face, made)]
    return made if turns[0] == turns[1] else made[::-1]
