"""What meshes are made of: coloured convex parts."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from itertools import accumulate, pairwise

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Material:
    """How a surface looks.

    Attributes:
        name: What it is ("oak", "linen").
        color: sRGB colour, each channel 0 to 1; with a texture that of the whole, so that it serves where there are no textures.
        roughness: 0 mirror, 1 chalk.
        metallic: 0 or 1.
        opacity: 1 opaque; glass below.
        glow: Light that it gives off, as a share of its colour: shades of lamps, screens.
        texture: A tile by name ("wood"), or the picture of an own mesh; None is plain.
    """

    name: str
    color: tuple[float, float, float]
    roughness: float = 0.8
    metallic: float = 0.0
    opacity: float = 1.0
    glow: float = 0.0
    texture: str | bytes | None = None


@dataclass(frozen=True)
class Joint:
    """How some parts of a thing, or of a room, move together.

    Attributes:
        name: What moves ("door 0"); unique in its thing.
        kind: "hinge" (turns about the axis) or "slide" (moves along it).
        axis: Unit vector; the positive way opens.
        at: A point on the axis, in the frame of the parts; metres.
        span: How far it goes from where it is drawn, (0, open) where that is shut; radians or metres.
        handle: Where it is taken hold of, as it is drawn; metres.
        hold: Between which heights a hand can take hold of it: those of its handle, else of all of it; metres.
    """

    name: str
    kind: str
    axis: tuple[float, float, float]
    at: tuple[float, float, float]
    span: tuple[float, float]
    handle: tuple[float, float, float]
    hold: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Part:
    """One piece of a mesh.

    Attributes:
        name: What it is ("mattress", "leg").
        vertices: (n, 3) metres, in the frame of its asset: origin in the middle of its box, front along +x, z up.
        faces: (m, 3) vertex indices, counter-clockwise seen from outside.
        material: How it looks.
        convex: Whether it may serve as a collider as it is.
        uv: (n, 2) where its vertices lie in its material's picture; None for tiles, which are laid on by shape.
        joint: With what it moves; None where it stays.
    """

    name: str
    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]
    material: Material
    convex: bool = True
    uv: NDArray[np.float64] | None = None
    joint: Joint | None = None


def fit(pieces: Iterable[Part], size: tuple[float, float, float]) -> tuple[Part, ...]:
    """Scale and move parts, axis by axis, so that together they fill a box of `size` about the origin."""
    built = tuple(pieces)
    points = np.concatenate([part.vertices for part in built])
    low, high = points.min(axis=0), points.max(axis=0)
    half = np.array(size) / 2
    scale = np.array(size) / np.maximum(high - low, 1e-12)
    fitted = np.clip((points - (low + high) / 2) * scale, -half, half)
    ends = [*accumulate((len(part.vertices) for part in built), initial=0)]
    return tuple(
        replace(part, vertices=fitted[start:end]) for part, (start, end) in zip(built, pairwise(ends), strict=True)
    )
