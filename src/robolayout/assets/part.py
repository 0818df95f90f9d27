"""What meshes are made of: coloured convex parts."""

from __future__ import annotations

from dataclasses import dataclass

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
    """

    name: str
    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]
    material: Material
    convex: bool = True
    uv: NDArray[np.float64] | None = None
