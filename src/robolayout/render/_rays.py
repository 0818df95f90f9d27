"""The fallback renderer: ray casting with Embree on one core, same mesh, same camera, same light as `_gl`.

It needs no driver at all; a 512 x 512 picture takes about a second. The light of every picture is here: a soft sun, a sky, and what
floor and walls throw back. Radiance of a surface with linear colour a and normal n:
    a (SUN mean_i[visible_i max(0, n . sun_i)] + SKY s + BOUNCE (LIGHT.bounce - LIGHT.bounce_tilt n_z)),
    s = (2 / K) sum_k[visible_k max(0, n . sky_k)], computed at the corners of a refined mesh, once for all cameras, and interpolated,
plus a small highlight of the sun for glossy surfaces; then exposure, a soft shoulder above 0.75, and sRGB.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from robolayout._color import encoded, linear
from robolayout.assets.textures import pixels
from robolayout.render._mesh import Mesh, refined, welded
from robolayout.render._style import LIGHT, VIEW
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


Floats = NDArray[np.float32]

SUBSAMPLES = np.array([(-0.125, -0.375), (0.375, -0.125), (-0.375, 0.125), (0.125, 0.375)])
"""Offsets in pixels of the four samples that smooth edges (the usual pattern of 4x multisampling)."""


@dataclass(frozen=True, eq=False)
class Lit:
    """A refined mesh and the sky's light at its corners."""

    mesh: Mesh  # the refined mesh, n triangles
    first: NDArray[np.intp]  # (v,) for each distinct corner, where it is first found in `mesh.corners.reshape(-1, 3)`
    places: NDArray[np.intp]  # (n, 3) the distinct corner of each corner
    sky: Floats  # (v,) irradiance of the sky, 1 under an open one


def lit_by_sky(mesh: Mesh, blockers: Floats) -> Lit:
    """Return the mesh, refined, with the sky's light; `blockers` are the triangles (n, 3, 3) that take it away."""
    extent = np.ptp(mesh.corners.reshape(-1, 3), axis=0).max() if len(mesh) else 0.0
    fine = refined(mesh, max(LIGHT.longest, float(extent) / 30))
    first, places = welded(fine)
    points, normals = fine.corners.reshape(-1, 3)[first], fine.normals.reshape(-1, 3)[first]
    return Lit(fine, first, places, _sky(points, normals, _scene(blockers)))


class RayRenderer:
    """Draws one mesh from any camera by ray casting."""

    def __init__(self, mesh: Mesh, sky_blockers: NDArray[np.bool_], sun_blockers: NDArray[np.bool_]) -> None:
        """Prepare `mesh`; the masks say which of its triangles take the sky's and the sun's light away."""
        self._coarse, self._sun_blockers = mesh, sun_blockers
        lit = lit_by_sky(mesh, mesh.corners[sky_blockers])
        self._fine, self._sky = lit.mesh, lit.sky[lit.places]
        self._textures = [_levels(texture) for texture in mesh.textures]

    def color(self, camera: Camera, keep: NDArray[np.bool_]) -> NDArray[np.uint8]:
        """Return the picture (height, width, 3) of the parts where `keep` (parts) holds."""
        shown = keep[self._fine.groups]
        shadows = _scene(self._coarse.corners[self._sun_blockers & keep[self._coarse.groups]])
        layers = [np.flatnonzero(shown & self._fine.opaque), np.flatnonzero(shown & ~self._fine.opaque)]
        scenes = [(_scene(self._fine.corners[which]), which) for which in layers]
        centers = _centers(camera)
        flat, surface = self._shade(camera, centers, scenes, shadows)
        image = flat.reshape(camera.height, camera.width, 3)
        edges = _edges(surface.reshape(camera.height, camera.width, -1))
        fine = (centers[edges.reshape(-1)][:, None] + SUBSAMPLES).reshape(-1, 2)
        smooth, _ = self._shade(camera, fine, scenes, shadows)
        image[edges] = smooth.reshape(-1, len(SUBSAMPLES), 3).mean(axis=1)
        return np.round(np.clip(image, 0, 1) * 255).astype(np.uint8)

    def marks(self, camera: Camera, keep: NDArray[np.bool_]) -> tuple[NDArray[np.int32], NDArray[np.float32]]:
        """Return ids and depths in metres (height, width); the background has id -1 and depth inf."""
        which = np.flatnonzero(keep[self._fine.groups])
        rays = camera.rays(_centers(camera))
        triangle, _, far = _hits(_scene(self._fine.corners[which]), camera, rays)
        shape = (camera.height, camera.width)
        missed = triangle < 0
        ids = np.where(missed, -1, self._fine.ids[which[triangle]] if len(which) else -1).astype(np.int32)
        return ids.reshape(shape), np.where(missed, np.inf, far).astype(np.float32).reshape(shape)

    def _shade(
        self, camera: Camera, pixels: NDArray[Any], scenes: list[tuple[Any, NDArray[np.intp]]], shadows: Any
    ) -> tuple[Floats, Floats]:
        """Return display colours (n, 3) at pixels (n, 2), and what was hit there: part, normal (n, 4)."""
        rays = camera.rays(pixels)
        colors = np.tile(np.array(LIGHT.background, np.float32), (len(pixels), 1))
        surface = np.full((len(pixels), 4), -1, np.float32)
        nearest = np.full(len(pixels), np.inf, np.float32)
        for (scene, which), glass in zip(scenes, (False, True), strict=True):
            triangle, shares, far = _hits(scene, camera, rays)
            hit = (triangle >= 0) & (far < nearest)
            if not hit.any():
                continue
            face, weights = which[triangle[hit]], shares[hit]
            points = (camera.position + rays[hit] * far[hit, None]).astype(np.float32)
            lit, normals = self._radiance(camera, (face, weights, points), shadows)
            opacity = self._fine.colors[face, 3:]
            colors[hit] = encode(lit) * opacity + colors[hit] * (1 - opacity)
            surface[hit] = np.column_stack([self._fine.groups[face] + 1e4 * glass, normals])
            nearest[hit] = far[hit]
        return colors, surface

    def _radiance(
        self, camera: Camera, surface: tuple[NDArray[np.intp], Floats, Floats], shadows: Any
    ) -> tuple[Floats, Floats]:
        """Return linear radiance (n, 3) and normals (n, 3) of points: their faces, barycentric weights, positions."""
        face, weights, points = surface
        normals = np.einsum("nk,nkd->nd", weights, self._fine.normals[face])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
        sky = (weights * self._sky[face]).sum(axis=1)
        look = np.array(camera.position, np.float32) - points
        look /= np.linalg.norm(look, axis=1, keepdims=True)
        gloss = self._fine.gloss[face]
        toward = sun_directions(camera)
        lifted = points + normals * np.float32(LIGHT.bias)
        sun, seen = np.zeros(len(points), np.float32), np.zeros(len(points), np.float32)
        for direction in toward:
            slope = np.maximum(normals @ direction, 0)
            here = _visible(shadows, lifted, direction, slope > 0)
            sun += here * slope
            seen += np.where(slope > 0, here, 0)
        middle = toward.sum(axis=0)
        half = middle / np.linalg.norm(middle) + look
        half /= np.linalg.norm(half, axis=1, keepdims=True)
        shine = seen * np.maximum((normals * half).sum(axis=1), 0) ** (8 + 56 * gloss)
        bounce = (LIGHT.bounce - LIGHT.bounce_tilt * normals[:, 2])[:, None] * BOUNCE
        light = SUN * (sun / len(toward))[:, None] + SKY * sky[:, None] + bounce
        away = np.linalg.norm(np.array(camera.position, np.float32) - points, axis=1)
        tint = textured(self._fine, self._textures, face, weights, away * 2 * np.tan(camera.fov / 2) / camera.height)
        light = light + self._fine.glow[face][:, None]
        lit = self._fine.colors[face, :3] * tint * light + (0.25 * gloss**2 * shine / len(toward))[:, None]
        return lit.astype(np.float32), normals


def _levels(texture: str | bytes) -> list[Floats]:
    """Return a texture in linear light, and halved again and again down to one pixel."""
    full = Image.fromarray(pixels(texture))
    levels = max(full.size).bit_length()
    halved = [full.reduce(2**k) if 2**k <= min(full.size) else full.resize((1, 1)) for k in range(levels)]
    return [linear(np.asarray(picture) / 255.0).astype(np.float32) for picture in halved]


def textured(
    mesh: Mesh, textures: list[list[Floats]], face: NDArray[np.intp], weights: Floats, pixel: Floats
) -> Floats:
    """Return what textures multiply colours (n, 3) with, at faces (n,) and barycentric weights (n, 3).

    `pixel` (n,) is how many metres a pixel shows; the level is taken whose pixels are as large.
    """
    tint = np.ones((len(face), 3), np.float32)
    for number, levels in enumerate(textures):
        here = np.flatnonzero(mesh.layers[face] == number)
        if not len(here):
            continue
        corners, uvs = mesh.corners[face[here]], mesh.uvs[face[here]]
        at = np.einsum("nk,nkd->nd", weights[here], uvs)
        along = np.linalg.norm(np.diff(corners, axis=1), axis=2).max(axis=1)
        scale = np.linalg.norm(np.diff(uvs, axis=1), axis=2).max(axis=1) / np.maximum(along, 1e-9)
        texels = np.maximum(pixel[here] * scale * max(levels[0].shape[:2]), 1.0)
        level = np.minimum(np.log2(texels).round().astype(int), len(levels) - 1)
        for k in np.unique(level):
            picture, which = levels[k], level == k
            height, width = picture.shape[:2]
            column, row = (np.floor(at[which] % 1.0 * (width, height)).astype(int) % (width, height)).T
            tint[here[which]] = picture[row, column]
    return tint


def surfaces(mesh: Mesh, camera: Camera) -> tuple[Floats, Floats]:
    """Return linear colour and normal (height, width, 3) of what each pixel shows, smoothed; 0 where there is nothing."""
    samples = (_centers(camera)[:, None] + SUBSAMPLES).reshape(-1, 2)
    triangle, shares, far = _hits(_scene(mesh.corners), camera, camera.rays(samples))
    hit = triangle >= 0
    face, weights = triangle[hit], shares[hit]
    colors, normals = np.zeros((len(hit), 3), np.float32), np.zeros((len(hit), 3), np.float32)
    pixel = far[hit] * np.float32(2 * np.tan(camera.fov / 2) / camera.height)
    tint = textured(mesh, [_levels(texture) for texture in mesh.textures], face, weights, pixel)
    colors[hit] = mesh.colors[face, :3] * tint
    normals[hit] = np.einsum("nk,nkd->nd", weights, mesh.normals[face])
    shape = (camera.height, camera.width, len(SUBSAMPLES), 3)
    return colors.reshape(shape).mean(axis=2), normals.reshape(shape).mean(axis=2)


def _centers(camera: Camera) -> NDArray[Any]:
    """Return the middles of all pixels (n, 2), row by row."""
    columns, rows = np.meshgrid(np.arange(camera.width), np.arange(camera.height))
    return np.stack([columns, rows], axis=-1).reshape(-1, 2) + 0.5


def _scene(corners: Floats) -> Any:
    """Return the Embree scene of triangles (n, 3, 3), or None without triangles."""
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    if not len(corners):
        return None
    scene: Any = EmbreeScene()
    TriangleMesh(scene, np.ascontiguousarray(corners, dtype=np.float32))
    return scene


def _hits(scene: Any, camera: Camera, rays: NDArray[np.float64]) -> tuple[NDArray[np.intp], Floats, Floats]:
    """Return triangle (-1: none), barycentric weights (n, 3) and depth in metres of the first hit of each ray from the camera."""
    n = len(rays)
    if scene is None or not n:
        return np.full(n, -1), np.zeros((n, 3), np.float32), np.zeros(n, np.float32)
    start = (np.asarray(camera.position) + rays * VIEW.near).astype(np.float32)
    answer = scene.run(start, rays.astype(np.float32), query="INTERSECT", output=True)
    u, v = answer["u"], answer["v"]
    return answer["primID"].astype(np.intp), np.column_stack([1 - u - v, u, v]), answer["tfar"] + np.float32(VIEW.near)


def _visible(scene: Any, points: Floats, direction: Floats, which: NDArray[np.bool_]) -> Floats:
    """Return 1 where nothing stands between points (n, 3) and the light, 0 elsewhere; looked up where `which`."""
    seen = np.ones(len(points), np.float32)
    if scene is not None and which.any():
        rays = np.tile(direction, (int(which.sum()), 1))
        blocked = scene.run(np.ascontiguousarray(points[which]), rays, query="OCCLUDED")
        seen[which] = blocked < 0
    return seen


def _sky(points: Floats, normals: Floats, scene: Any) -> Floats:
    """Return the irradiance (n,) of the sky at points (n, 3) with unit normals (n, 3); 1 under an open sky."""
    total = np.zeros(len(points), np.float32)
    directions = sky_directions()
    lifted = (points + normals * LIGHT.bias).astype(np.float32)
    for direction in directions:
        slope = np.maximum(normals @ direction, 0).astype(np.float32)
        total += slope * _visible(scene, lifted, direction, slope > 0)
    return (total * 2 / len(directions)).astype(np.float32)


def _edges(surface: Floats) -> NDArray[np.bool_]:
    """Return where the part or the normal differs from a neighbour's, (height, width)."""
    edges = np.zeros(surface.shape[:2], np.bool_)
    for found, values in ((edges, surface), (edges.T, surface.swapaxes(0, 1))):
        differs = (np.abs(np.diff(values, axis=0)) > 0.2).any(axis=-1)
        found[:-1] |= differs
        found[1:] |= differs
    return edges
