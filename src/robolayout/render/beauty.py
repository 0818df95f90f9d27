"""The picture for a cover: path tracing with Mitsuba, noise removed by Open Image Denoise (extra `beauty`).

Same mesh, same camera and same cut walls as the fast views; light truly bounces, so it takes seconds instead of tenths.
"""

from __future__ import annotations

import importlib
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from robolayout._color import linear
from robolayout._errors import MissingExtraError
from robolayout.assets.textures import pixels
from robolayout.render._mesh import CEILING, Mesh
from robolayout.render._rays import SKY, SUN, encode, sun_directions, surfaces
from robolayout.render._style import LIGHT
from robolayout.render.camera import Camera
from robolayout.render.view import Studio, picture_size
from robolayout.scene import Agent, Layout, Scene


def render_beauty(  # noqa: PLR0913 - what `render_view` takes, and the paths of light
    scene: Scene,
    layout: Layout,
    *,
    view: str = "side",
    size: int | tuple[int, int] = 1024,
    samples: int = 16,
    agent: Agent | None = None,
    stand: tuple[float, float] | None = None,
    seed: int = 0,
) -> Image.Image:
    """Return a path-traced picture of the room, `samples` light paths per pixel; the other arguments are those of `render_view`."""
    mitsuba, denoise = _load()
    studio = Studio(scene, layout, renderer="rays")
    camera = studio.camera(view, picture_size(size), agent=agent, stand=stand)
    mesh = studio.shown(camera, inside=view.startswith("eye:"))
    return _trace(mitsuba, denoise, mesh, camera, samples, seed)


def _load() -> tuple[Any, Any]:
    """Return mitsuba and the denoiser's function."""
    try:
        mitsuba = importlib.import_module("mitsuba")
        denoiser = importlib.import_module("pyoidn")
    except ImportError as error:
        raise MissingExtraError("a path-traced picture", "beauty") from error
    mitsuba.set_variant("scalar_rgb")
    return mitsuba, denoiser.denoise


def _trace(mi: Any, denoise: Any, mesh: Mesh, camera: Camera, samples: int, seed: int) -> Image.Image:
    """Return the picture of a mesh."""
    world = mi.load_dict(_world(mi, mesh, camera, samples))
    data = np.array(mi.render(world, spp=samples, seed=seed), dtype=np.float32)
    color, alpha = np.ascontiguousarray(data[..., :3]), data[..., 3:4]
    albedo, normal = surfaces(mesh, camera)
    clean = denoise(color, albedo=albedo, normal=normal, hdr=True)
    alpha = np.clip(denoise(np.repeat(alpha, 3, axis=2))[..., :1], 0, 1)
    shown = encode(np.asarray(clean, np.float32) / np.maximum(alpha, 0.05) * LIGHT.exposure)
    picture = shown * alpha + np.array(LIGHT.background, np.float32) * (1 - alpha)
    return Image.fromarray(np.round(np.clip(picture, 0, 1) * 255).astype(np.uint8))


def _world(mi: Any, mesh: Mesh, camera: Camera, samples: int) -> dict[str, Any]:
    """Return the Mitsuba scene: camera, light and one shape per material."""
    transform = mi.ScalarTransform4f
    toward = sun_directions(camera).mean(axis=0)
    middle = mesh.corners.reshape(-1, 3).mean(axis=0) if len(mesh) else np.zeros(3)
    sun = middle + toward * LIGHT.sun_distance
    size = {"width": camera.width, "height": camera.height}
    power = SUN * np.pi / (np.pi * (LIGHT.sun_radius / LIGHT.sun_distance) ** 2)
    world: dict[str, Any] = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 6, "rr_depth": 4, "hide_emitters": True},
        "sensor": {
            "type": "perspective",
            "fov": float(np.degrees(camera.fov)),
            "fov_axis": "y",
            "near_clip": 0.02,
            "to_world": transform().look_at(origin=camera.position, target=camera.target, up=camera.up),
            "film": {"type": "hdrfilm", **size, "pixel_format": "rgba", "rfilter": {"type": "box"}},
            "sampler": {"type": "independent", "sample_count": samples},
        },
        "sky": {"type": "constant", "radiance": {"type": "rgb", "value": (SKY * 1.15).tolist()}},
        "sun": {
            "type": "disk",
            "to_world": transform().look_at(origin=sun.tolist(), target=middle.tolist(), up=[0, 0.3, 1])
            @ transform().scale(LIGHT.sun_radius),
            "emitter": {"type": "area", "radiance": {"type": "rgb", "value": power.tolist()}},
        },
    }
    above = mesh.named({CEILING})
    if above.any():
        world["integrator"]["hide_emitters"] = False
        white = np.array([0.8, 0.8, 0.8, 1.0, 0.0, -1.0])
        world["ceiling"] = _shape(mi, mesh.take(above), white, "ceiling", LIGHT.indoors)
        mesh = mesh.take(~above)
    looks, of = np.unique(np.column_stack([mesh.colors, mesh.gloss, mesh.layers]).round(4), axis=0, return_inverse=True)
    for number, look in enumerate(looks):
        world[f"shape{number}"] = _shape(mi, mesh.take(of.reshape(-1) == number), look, f"shape{number}")
    return world


def _shape(mi: Any, mesh: Mesh, look: NDArray[np.float64], name: str, radiance: float | None = None) -> Any:
    """Return the Mitsuba mesh of all triangles of one look (linear colour, opacity, gloss, texture), shining if it has a radiance."""
    color: dict[str, Any] = {"type": "rgb", "value": [float(v) for v in look[:3]]}
    if look[5] >= 0:
        tile = linear(pixels(mesh.textures[int(look[5])]) / 255.0) * look[:3]
        color = {"type": "bitmap", "bitmap": mi.Bitmap(tile.astype(np.float32)), "raw": True}
    surface: dict[str, Any] = {"type": "diffuse", "reflectance": color}
    if look[4] > 0.35:
        roughness = float(max(1 - look[4], 0.12))
        surface = {"type": "principled", "base_color": color, "specular": 0.35, "roughness": roughness}
    bsdf: dict[str, Any] = {"type": "twosided", "bsdf": surface}
    if look[3] < 0.99:
        bsdf = {"type": "mask", "opacity": float(look[3]), "nested": bsdf}
    properties = mi.Properties()
    properties["mesh_bsdf"] = mi.load_dict(bsdf)
    if radiance is not None:
        light = {"type": "area", "radiance": {"type": "rgb", "value": [radiance] * 3}}
        properties["mesh_emitter"] = mi.load_dict(light)
    count = len(mesh)
    shape = mi.Mesh(name, 3 * count, count, has_vertex_normals=True, has_vertex_texcoords=True, props=properties)
    values = mi.traverse(shape)
    values["vertex_positions"] = mesh.corners.reshape(-1)
    values["vertex_normals"] = mesh.normals.reshape(-1)
    values["vertex_texcoords"] = (mesh.uvs * (1, -1) + (0, 1)).astype(np.float32).reshape(-1)
    values["faces"] = np.arange(3 * count, dtype=np.uint32)
    values.update()
    return shape
