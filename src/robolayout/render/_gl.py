"""The fast renderer: OpenGL on EGL, without window or display.

Every direction of the sun gets a depth map in one atlas; one pass then shades with 4x multisampling. In software (llvmpipe)
a 512 x 512 picture takes about 0.1 s.
"""

from __future__ import annotations

import os
import threading
from collections.abc import Sequence
from functools import lru_cache
from importlib.resources import files
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from robolayout._color import linear
from robolayout.assets.textures import pixels
from robolayout.render._mesh import Mesh
from robolayout.render._rays import BOUNCE, SKY, SUN, lit_by_sky, sun_directions
from robolayout.render._style import LIGHT, VIEW
from robolayout.render.camera import Camera


@lru_cache(maxsize=8)
def _context(process: int, thread: int) -> Any:
    """Return the context of this process and thread; GL contexts survive neither fork nor change of thread."""
    import moderngl

    del process, thread
    return moderngl.create_context(require=330, standalone=True, backend="egl")  # pyright: ignore[reportArgumentType]


def why_unavailable() -> str | None:
    """Return why OpenGL on EGL does not work here, or None where it does."""
    try:
        _programs(_context(os.getpid(), threading.get_ident()))
    except Exception as error:  # noqa: BLE001  (glcontext raises plain Exception when EGL is missing)
        return str(error) or type(error).__name__
    return None


@lru_cache(maxsize=8)
def _programs(context: Any) -> dict[str, Any]:
    words: dict[str, object] = {
        "bias": LIGHT.bias,
        "shoulder": LIGHT.shoulder,
        "level": LIGHT.bounce,
        "tilt": LIGHT.bounce_tilt,
    }
    for name, light in (("sun", SUN), ("sky", SKY), ("bounce", BOUNCE)):
        words[name] = ", ".join(f"{channel:.6f}" for channel in light)
    suns = {"count": LIGHT.sun, "columns": LIGHT.sun_columns, "half": 0.5 / LIGHT.sun_tile}
    vertex = _shader("shade.vert")
    return {
        "shade": context.program(vertex, _shader("lookup.frag") % suns + _shader("shade.frag") % words),
        "marks": context.program(vertex, _shader("marks.frag")),
        "depth": context.program(_shader("depth.vert"), _shader("depth.frag")),
    }


def _shader(name: str) -> str:
    return (files("robolayout.render") / "shaders" / name).read_text(encoding="utf-8")


class GLRenderer:
    """Draws one mesh from any camera with OpenGL, in the thread that made it."""

    def __init__(self, mesh: Mesh, sky_blockers: NDArray[np.bool_], sun_blockers: NDArray[np.bool_]) -> None:
        """Upload `mesh`; the masks say which of its triangles take the sky's and the sun's light away."""
        import moderngl

        self._gl = moderngl
        self._context: Any = _context(os.getpid(), threading.get_ident())
        self._program = _programs(self._context)
        self._coarse = mesh
        points = mesh.corners.reshape(-1, 3) if len(mesh) else np.zeros((1, 3))
        self._bounds = points.min(axis=0), points.max(axis=0)
        self._sun_blockers = sun_blockers
        lit = lit_by_sky(mesh, mesh.corners[sky_blockers])
        fine, face = lit.mesh, lit.first // 3
        columns = [  # of the distinct corners of the fine mesh
            ("3f4", "position", fine.corners.reshape(-1, 3)[lit.first]),
            ("3f4", "normal", fine.normals.reshape(-1, 3)[lit.first]),
            ("4f4", "color", fine.colors[face]),
            ("f4", "gloss", fine.gloss[face]),
            ("f4", "glow", fine.glow[face]),
            ("f4", "sky", lit.sky),
            ("2f4", "uv", fine.uvs.reshape(-1, 2)[lit.first]),
            ("i4", "layer", fine.layers[face]),
            ("i4", "id", fine.ids[face]),
        ]
        self._content = [(self._buffer(data), kind, name) for kind, name, data in columns]
        self._fine, self._places = fine, lit.places
        self._tiles = self._texture_array(mesh.textures)

    def color(self, camera: Camera, keep: NDArray[np.bool_]) -> NDArray[np.uint8]:
        """Return the picture (height, width, 3) of the parts where `keep` (parts) holds."""
        context, gl = self._context, self._gl
        toward = sun_directions(camera)
        shadows = self._coarse.corners[self._sun_blockers & keep[self._coarse.groups]]
        matrices, atlas = self._atlas(shadows, toward)
        size, samples = (camera.width, camera.height), min(4, context.max_samples)
        colors = context.renderbuffer(size, 4, samples=samples)
        depths = context.depth_renderbuffer(size, samples=samples)
        canvas = context.framebuffer([colors], depths)
        canvas.use()
        canvas.clear(*LIGHT.background, 1.0)
        context.enable(gl.DEPTH_TEST)
        program = self._program["shade"]
        atlas.use(0)
        program["lights"].write(np.ascontiguousarray(matrices.transpose(0, 2, 1)).tobytes())
        program["toward"].write(toward.tobytes())
        self._tiles.use(1)
        program["tiles"].value = 1
        shown = keep[self._fine.groups] & self._fine.facing(camera.position)
        context.enable(gl.BLEND)
        context.blend_func = gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA
        for mask in (self._fine.opaque, ~self._fine.opaque):
            which = np.flatnonzero(shown & mask)
            away = np.linalg.norm(self._fine.corners[which].mean(axis=1) - camera.position, axis=1)
            self._draw("shade", camera, which[np.argsort(away, kind="stable")])  # what is hidden then is not shaded
        context.disable(gl.BLEND)
        plain_color = context.renderbuffer(size, 4)
        plain = context.framebuffer([plain_color])
        context.copy_framebuffer(plain, canvas)
        data = np.frombuffer(plain.read(components=3, alignment=1), np.uint8)
        for thing in (canvas, colors, depths, plain, plain_color, atlas):
            thing.release()
        return data.reshape(camera.height, camera.width, 3)[::-1].copy()

    def marks(self, camera: Camera, keep: NDArray[np.bool_]) -> tuple[NDArray[np.int32], NDArray[np.float32]]:
        """Return ids and depths in metres (height, width); the background has id -1 and depth inf."""
        context = self._context
        size, shape = (camera.width, camera.height), (camera.height, camera.width)
        ids, depth = context.texture(size, 1, dtype="i4"), context.texture(size, 1, dtype="f4")
        depths = context.depth_renderbuffer(size)
        canvas = context.framebuffer([ids, depth], depths)
        canvas.use()
        canvas.clear()
        context.enable(self._gl.DEPTH_TEST)
        self._program["marks"]["forward"].value = tuple(float(v) for v in camera.axes[2])
        self._draw("marks", camera, np.flatnonzero(keep[self._fine.groups]))
        far = np.frombuffer(depth.read(), np.float32).reshape(shape)[::-1]
        names = np.frombuffer(ids.read(), np.int32).reshape(shape)[::-1]
        for thing in (canvas, ids, depth, depths):
            thing.release()
        return np.where(far > 0, names, -1).astype(np.int32), np.where(far > 0, far, np.inf).astype(np.float32)

    def _texture_array(self, textures: Sequence[str | bytes]) -> Any:
        """Return all textures, in linear light and of one size, with their smaller copies."""
        pictures = [Image.fromarray(pixels(texture)) for texture in textures] or [Image.new("RGB", (1, 1))]
        side = min(max(max(picture.size) for picture in pictures), LIGHT.texture)
        layers = [np.asarray(p if p.size == (side, side) else p.resize((side, side))) / 255.0 for p in pictures]
        data = linear(np.array(layers)).astype(np.float16)
        array = self._context.texture_array((side, side, len(layers)), 3, data.tobytes(), dtype="f2", alignment=2)
        array.build_mipmaps()
        array.filter = (self._gl.LINEAR_MIPMAP_LINEAR, self._gl.LINEAR)
        return array

    def _buffer(self, data: NDArray[Any]) -> Any:
        return self._context.buffer(np.ascontiguousarray(data).tobytes())

    def _draw(self, name: str, camera: Camera, which: NDArray[np.intp]) -> None:
        """Draw the fine triangles with these indices, in this order; of glass only the nearest layer stays."""
        if not len(which):
            return
        program = self._program[name]
        program["camera"].write(np.ascontiguousarray(camera.matrix(*self._depths(camera)).T).tobytes())
        program["eye"].value = camera.position
        content = [row for row in self._content if row[2] in program]
        order = self._buffer(self._places[which].astype(np.int32))
        array = self._context.vertex_array(program, content, index_buffer=order)
        array.render(self._gl.TRIANGLES)
        array.release()
        order.release()

    def _depths(self, camera: Camera) -> tuple[float, float]:
        """Return metres to a plane behind everything and to one before it, close together: layers of a rug lie 1 mm apart."""
        low, high = self._bounds
        _, depth = camera.project(np.array(list(product(*zip(low, high, strict=True)))))
        return max(float(depth.max()) * 1.01, 1.0), max(float(depth.min()) * 0.99, VIEW.near)

    def _atlas(self, shadows: NDArray[np.float32], toward: NDArray[np.float32]) -> tuple[NDArray[np.float32], Any]:
        """Return the (lights, 4, 4) world-to-tile matrices that hold `shadows`, and the texture of depth maps."""
        context, gl, columns, tile = self._context, self._gl, LIGHT.sun_columns, LIGHT.sun_tile
        atlas = context.depth_texture((columns * tile, columns * tile))
        atlas.compare_func = "<="
        atlas.filter = (gl.LINEAR, gl.LINEAR)
        canvas = context.framebuffer(depth_attachment=atlas)
        canvas.use()
        canvas.clear()
        points = np.ascontiguousarray(shadows.reshape(-1, 3).T) if len(shadows) else np.zeros((3, 1), np.float32)
        matrices = np.stack([_fit_light(points, direction) for direction in toward])
        if len(shadows):
            context.enable(gl.DEPTH_TEST)
            buffer, program = self._buffer(shadows), self._program["depth"]
            array = context.vertex_array(program, [(buffer, "3f4", "position")])
            for k, matrix in enumerate(matrices):
                canvas.viewport = (k % columns * tile, k // columns * tile, tile, tile)
                program["light"].write(np.ascontiguousarray(matrix.T).tobytes())
                array.render(gl.TRIANGLES)
            array.release()
            buffer.release()
        canvas.release()
        return matrices, atlas


def _fit_light(points: NDArray[np.float32], direction: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the orthographic (4, 4) matrix that looks against `direction` and holds all points (3, n) in [-1, 1]."""
    side = np.cross(direction, (0.0, 1.0, 0.0) if abs(direction[1]) < 0.9 else (1.0, 0.0, 0.0))
    side = side / np.linalg.norm(side)
    axes = np.stack([side, np.cross(direction, side), -direction])
    local = axes.astype(np.float32) @ points
    low, high = local.min(axis=1), local.max(axis=1)
    scale = 2 / np.maximum(high - low, 1e-3) * 0.98
    matrix = np.eye(4)
    matrix[:3, :3] = axes * scale[:, None]
    matrix[:3, 3] = -(low + high) / 2 * scale
    return matrix.astype(np.float32)
