"""What surfaces are made of, seen close: small tiles made by code, and the pictures that own meshes bring.

A tile is a grey picture that goes on without a seam; a material's colour is multiplied by it, so one tile serves every wood.
Tiles lie on a part as if it were wrapped: each triangle takes the plane that it faces most, grain along the part's longest edge.
"""

from __future__ import annotations

import io
import zlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache, partial

import numpy as np
from numpy.typing import NDArray

from robolayout._color import encoded, linear
from robolayout.assets.part import Part

Array = NDArray[np.float64]


@dataclass(frozen=True)
class TileConfig:
    """How the tile of a texture is made."""

    side: int = 256  # pixels along a side of a tile
    # mean of every tile, in linear light: what is darker and what is lighter than the plain colour both have room
    mean: float = 0.8
    darkest: float = 1e-3  # least mean of a picture that is reckoned with, in linear light
    quality: int = 82  # JPEG quality of tiles in files: 10 to 30 kB each


TILE = TileConfig()
Noise = Callable[[float, float], Array]  # seamless noise with features so many parts of the tile long and wide


@dataclass(frozen=True)
class Tile:
    """A texture made by code."""

    metres: float  # edge of the square that one tile covers
    contrast: float  # standard deviation of its linear values, as a share of their mean
    # makes its values (SIDE, SIDE) of any scale from two ramps u, v in [0, 1) and a source of noise
    draw: Callable[[Array, Array, Noise], Array]


def _noise(rng: np.random.Generator, along: float, across: float) -> Array:
    """Return seamless noise (SIDE, SIDE) of unit deviation whose features are so many parts of the tile long and wide."""
    waves = np.fft.fftfreq(TILE.side) * TILE.side
    v, u = np.meshgrid(waves, waves, indexing="ij")
    keep = np.exp(-0.5 * ((u * along) ** 2 + (v * across) ** 2))
    field = np.fft.ifft2(np.fft.fft2(rng.normal(size=(TILE.side, TILE.side))) * keep).real
    return field / max(float(field.std()), 1e-12)


def _wood(u: Array, v: Array, noise: Noise) -> Array:
    """Return growth rings cut lengthwise, with fibres."""
    del u
    rings = np.sin(2 * np.pi * (9 * v + 0.55 * noise(0.5, 0.08)))
    return rings + 0.5 * noise(0.12, 0.004) + 0.6 * noise(0.5, 0.03)


def _weave(u: Array, v: Array, noise: Noise) -> Array:
    """Return threads over and under each other."""
    threads = 32
    over = (np.floor(u * threads) + np.floor(v * threads)) % 2
    warp, weft = np.abs(np.sin(np.pi * threads * u)), np.abs(np.sin(np.pi * threads * v))
    return np.where(over > 0, warp, 0.85 * weft) + 0.12 * noise(0.1, 0.004) + 0.12 * noise(0.004, 0.1)


def _grains(*layers: tuple[float, float, float]) -> Callable[[Array, Array, Noise], Array]:
    """Return what draws noise of several weights, lengths and widths: tufts, a rolled wall, fine scratches."""
    return lambda u, v, noise: np.sum([weight * noise(along, across) for weight, along, across in layers], axis=0)


def _marble(u: Array, v: Array, noise: Noise) -> Array:
    """Return dark veins along folded lines."""
    lines = np.abs(np.sin(np.pi * (2 * u + v + 0.4 * noise(0.28, 0.28) + 0.03 * noise(0.06, 0.06))))
    return -np.exp(-8 * lines) + 0.12 * noise(0.15, 0.15)


def _brick(u: Array, v: Array, noise: Noise) -> Array:
    """Return courses of bricks, every other one shifted by half, in light mortar."""
    rows, columns = 8, 4
    row = np.floor(v * rows)
    along = u * columns + 0.5 * (row % 2)
    x, y = (np.minimum(part % 1, 1 - part % 1) for part in (along, v * rows))  # how far from a joint
    brick = 0.35 * np.sin(12.9 * row + 78.2 * np.floor(along) % columns) + 0.25 * noise(0.01, 0.01)
    joint = (x * 0.25 < 0.011) | (y * 0.125 < 0.011)
    return np.where(joint, 1.6, brick)


def _wicker(u: Array, v: Array, noise: Noise) -> Array:
    canes = 16
    stakes = np.abs(np.sin(np.pi * (canes / 2 * u + 0.5 * (np.floor(v * canes) % 2))))
    return stakes * np.abs(np.sin(np.pi * canes * v)) + 0.1 * noise(0.02, 0.02)


TILES: Mapping[str, Tile] = {
    "wood": Tile(0.8, 0.075, _wood),
    "weave": Tile(0.16, 0.10, _weave),
    "pile": Tile(0.5, 0.16, _grains((1.0, 0.006, 0.006), (0.35, 0.06, 0.06))),
    "plaster": Tile(0.7, 0.018, _grains((1.0, 0.012, 0.012), (0.7, 0.1, 0.1))),
    "stone": Tile(1.2, 0.07, _grains((1.0, 0.2, 0.2), (0.6, 0.05, 0.05), (0.35, 0.008, 0.008))),
    "marble": Tile(1.6, 0.09, _marble),
    "brushed": Tile(0.4, 0.06, _grains((1.0, 0.3, 0.003))),
    "brick": Tile(1.0, 0.16, _brick),
    "wicker": Tile(0.16, 0.22, _wicker),
}
"""The textures that materials may name."""


@lru_cache(maxsize=64)
def pixels(texture: str | bytes) -> NDArray[np.uint8]:
    """Return a texture's sRGB pixels (height, width, 3), the first row at the top: a tile by name, or an encoded picture."""
    if isinstance(texture, bytes):
        from PIL import Image

        with Image.open(io.BytesIO(texture)) as picture:
            return np.asarray(picture.convert("RGB"))
    tile = TILES[texture]
    ramp = (np.arange(TILE.side) + 0.5) / TILE.side
    v, u = np.meshgrid(ramp, ramp, indexing="ij")
    values = tile.draw(u, v, partial(_noise, np.random.default_rng(zlib.crc32(texture.encode()))))
    values = TILE.mean * (1 + tile.contrast * (values - values.mean()) / max(float(values.std()), 1e-12))
    grey = encoded(np.clip(values, 0.0031308, 1.0))
    return np.repeat(np.round(grey * 255).astype(np.uint8)[..., None], 3, axis=2)


@lru_cache(maxsize=64)
def picture(texture: str | bytes) -> bytes:
    """Return a texture as the bytes of a picture file: tiles as grey JPEG, pictures of own meshes as they came."""
    if isinstance(texture, bytes):
        return texture
    from PIL import Image

    content = io.BytesIO()
    Image.fromarray(pixels(texture)[..., 0]).save(content, "JPEG", quality=TILE.quality)
    return content.getvalue()


def media_type(data: bytes) -> str:
    """Return the media type of a picture file."""
    return "image/png" if data.startswith(b"\x89PNG") else "image/jpeg"


@lru_cache(maxsize=64)
def mean(texture: str | bytes) -> tuple[float, float, float]:
    """Return by how much a texture darkens red, green and blue on the whole, in linear light."""
    if isinstance(texture, str):
        return (TILE.mean, TILE.mean, TILE.mean)
    light = linear(pixels(texture) / 255.0).mean(axis=(0, 1))
    red, green, blue = np.maximum(light, TILE.darkest).tolist()
    return (red, green, blue)


def coordinates(part: Part) -> NDArray[np.float32]:
    """Return texture coordinates (m, 3, 2) of the corners of a part's faces; (0, 0) is the top left of the picture.

    Own meshes bring theirs. Tiles are laid on along the two axes across the normal's largest component, the first along the
    part's longest edge there, from a corner that differs from part to part.
    """
    faces = part.faces
    texture = part.material.texture
    if part.uv is not None:
        return part.uv[faces].astype(np.float32)
    if not isinstance(texture, str):
        return np.zeros((len(faces), 3, 2), np.float32)
    corners = part.vertices[faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    extent = np.ptp(part.vertices, axis=0)
    plane = np.array(
        [sorted((i for i in range(3) if i != axis), key=lambda i: (-round(extent[i], 4), i)) for axis in range(3)]
    )
    axes = plane[np.abs(np.round(normal, 9)).argmax(axis=1)]
    flat = np.take_along_axis(corners, axes[:, None, :].repeat(3, axis=1), axis=2)
    start = np.modf(np.abs(part.vertices[0]) * 7.31)[0][axes][:, None, :]
    return (flat / TILES[texture].metres + start).astype(np.float32)
