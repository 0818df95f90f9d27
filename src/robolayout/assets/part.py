"""What meshes are made of: coloured convex parts."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Material:
    """How a surface looks."""

    name: str  # what it is ("oak", "linen")
    # sRGB colour, each channel 0 to 1; with a texture that of the whole, so that it serves where there are no textures
    color: tuple[float, float, float]
    roughness: float = 0.8  # 0 mirror, 1 chalk
    metallic: float = 0.0  # 0 or 1
    opacity: float = 1.0  # 1 opaque; glass below
    glow: float = 0.0  # light that it gives off, as a share of its colour: shades of lamps, screens
    texture: str | bytes | None = None  # A tile by name ("wood"), or the picture of an own mesh; None is plain


@dataclass(frozen=True)
class Joint:
    """How some parts of a thing, or of a room, move together."""

    name: str  # what moves ("door 0"); unique in its thing
    kind: str  # "hinge" (turns about the axis) or "slide" (moves along it)
    axis: tuple[float, float, float]  # unit vector; the positive way opens
    at: tuple[float, float, float]  # A point on the axis, in the frame of the parts; metres
    span: tuple[float, float]  # how far it goes from where it is drawn, (0, open) where that is shut; radians or metres
    handle: tuple[float, float, float]  # where it is taken hold of, as it is drawn; metres
    # between which heights a hand can take hold of it: those of its handle, else of all of it; metres
    hold: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Part:
    """One piece of a mesh."""

    name: str  # what it is ("mattress", "leg")
    # (n, 3) metres, in the frame of its asset: origin in the middle of its box, front along +x, z up
    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]  # (m, 3) vertex indices, counter-clockwise seen from outside
    material: Material  # how it looks
    convex: bool = True  # whether it may serve as a collider as it is
    # (n, 2) where its vertices lie in its material's picture; None for tiles, which are laid on by shape
    uv: NDArray[np.float64] | None = None
    joint: Joint | None = None  # with what it moves; None where it stays

    @property
    def ends(self) -> NDArray[np.float64]:
        """The low and the high corner (2, 3) of its box."""
        return np.stack([self.vertices.min(axis=0), self.vertices.max(axis=0)])


def fit(pieces: Iterable[Part], size: tuple[float, float, float]) -> tuple[Part, ...]:
    """Scale and move parts, axis by axis, so that together they fill a box of `size` about the origin."""
    built = tuple(pieces)
    points = np.concatenate([part.vertices for part in built])
    low, high = points.min(axis=0), points.max(axis=0)
    half = np.array(size) / 2
    scale = np.array(size) / np.maximum(high - low, 1e-12)
    fitted = np.clip((points - (low + high) / 2) * scale, -half, half)
    own = np.split(fitted, np.cumsum([len(part.vertices) for part in built])[:-1])
    return tuple(replace(part, vertices=vertices) for part, vertices in zip(built, own, strict=True))
