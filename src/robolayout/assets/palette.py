"""Materials that go together: a room's seed picks a palette, an asset's list picks among its fabrics."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass

from robolayout._text import utf8
from robolayout.assets.part import Material

Color = tuple[float, float, float]


def material(name: str, color: Color, roughness: float = 0.8, metallic: float = 0.0, opacity: float = 1.0) -> Material:
    """Return a material."""
    return Material(name, color, roughness, metallic, opacity)


WHITE = material("white lacquer", (0.93, 0.93, 0.91), 0.45)
IVORY = material("ivory", (0.93, 0.90, 0.83), 0.6)
LIGHT_GREY = material("light grey", (0.78, 0.79, 0.79), 0.6)
GREY = material("grey", (0.56, 0.57, 0.58), 0.6)
DARK = material("anthracite", (0.19, 0.20, 0.21), 0.55)
BLACK = material("black", (0.09, 0.09, 0.10), 0.4)
RUBBER = material("rubber", (0.13, 0.13, 0.14), 0.95)
STEEL = material("brushed steel", (0.72, 0.73, 0.75), 0.35, 1.0)
CHROME = material("chrome", (0.82, 0.83, 0.85), 0.15, 1.0)
BRASS = material("brass", (0.80, 0.64, 0.36), 0.3, 1.0)
IRON = material("iron", (0.24, 0.24, 0.26), 0.5, 1.0)
CERAMIC = material("ceramic", (0.96, 0.96, 0.94), 0.2)
GLASS = material("glass", (0.78, 0.88, 0.90), 0.05, 0.0, 0.35)
WATER = material("water", (0.42, 0.66, 0.76), 0.05, 0.0, 0.55)
SCREEN = material("screen", (0.07, 0.09, 0.13), 0.12)
GLOW = material("lit screen", (0.30, 0.52, 0.72), 0.3)
MIRROR = material("mirror", (0.80, 0.87, 0.90), 0.04, 1.0)
PAPER = material("paper", (0.95, 0.94, 0.90), 0.9)
LINEN = material("linen", (0.93, 0.91, 0.86), 0.95)
CARDBOARD = material("cardboard", (0.74, 0.58, 0.40), 0.9)
LAMPSHADE = material("lampshade", (0.97, 0.91, 0.78), 0.9)
WICKER = material("wicker", (0.74, 0.60, 0.42), 0.95)
TERRACOTTA = material("terracotta", (0.74, 0.45, 0.32), 0.9)
SOIL = material("soil", (0.27, 0.20, 0.15), 1.0)
LEAF = material("leaf", (0.31, 0.48, 0.27), 0.7)
LEAF_LIGHT = material("young leaf", (0.45, 0.60, 0.33), 0.7)
LEAF_DARK = material("old leaf", (0.21, 0.37, 0.23), 0.7)
RED = material("red", (0.72, 0.24, 0.21), 0.5)
ORANGE = material("orange", (0.87, 0.51, 0.22), 0.5)
YELLOW = material("yellow", (0.91, 0.75, 0.32), 0.6)
GREEN = material("green", (0.33, 0.55, 0.40), 0.6)
BLUE = material("blue", (0.26, 0.42, 0.62), 0.6)
PINK = material("pink", (0.87, 0.62, 0.63), 0.8)
FELT = material("felt", (0.16, 0.42, 0.32), 1.0)
SLATE = material("slate", (0.17, 0.25, 0.22), 0.9)
STONE = material("stone", (0.70, 0.68, 0.64), 0.85)
BRICK = material("brick", (0.62, 0.38, 0.30), 0.95)
EMBER = material("ember", (0.95, 0.50, 0.16), 0.6)
CORK = material("cork", (0.72, 0.56, 0.39), 1.0)
CONCRETE = material("concrete", (0.63, 0.62, 0.60), 0.95)
PINE = material("pine", (0.82, 0.68, 0.48), 0.8)
BREAD = material("crust", (0.76, 0.54, 0.30), 0.9)
COFFEE = material("coffee", (0.26, 0.16, 0.11), 0.5)

BRIGHT = (RED, ORANGE, YELLOW, GREEN, BLUE, PINK)
"""Toy and packaging colours."""
SPINES = (
    material("oxblood cloth", (0.50, 0.22, 0.20), 0.8),
    material("navy cloth", (0.20, 0.28, 0.40), 0.8),
    material("forest cloth", (0.25, 0.38, 0.31), 0.8),
    material("mustard cloth", (0.79, 0.62, 0.31), 0.8),
    material("cream cloth", (0.90, 0.86, 0.76), 0.8),
    material("slate cloth", (0.43, 0.48, 0.53), 0.8),
    material("rust cloth", (0.70, 0.42, 0.29), 0.8),
)
"""Book covers."""


@dataclass(frozen=True)
class Palette:
    """Materials of one room.

    Attributes:
        wood: The main wood.
        wood_dark: A darker companion, for legs and frames.
        front: Cabinet fronts.
        fabrics: Upholstery colours.
        accents: Cushions, rugs, small things.
        metal: Handles and thin legs.
        bedding: Sheets and duvets.
    """

    wood: Material
    wood_dark: Material
    front: Material
    fabrics: tuple[Material, ...]
    accents: tuple[Material, ...]
    metal: Material
    bedding: tuple[Material, ...]


def _fabrics(*colors: Color) -> tuple[Material, ...]:
    """Return fabrics of the given colours."""
    return tuple(material(f"fabric {i}", color, 0.95) for i, color in enumerate(colors))


PALETTES = (
    Palette(  # light oak, linen, sage
        material("oak", (0.80, 0.66, 0.47)), material("smoked oak", (0.55, 0.42, 0.29)), WHITE,
        _fabrics((0.72, 0.70, 0.65), (0.55, 0.61, 0.54), (0.50, 0.57, 0.64)),
        _fabrics((0.82, 0.64, 0.34), (0.62, 0.69, 0.60), (0.79, 0.53, 0.42)), DARK,
        _fabrics((0.88, 0.86, 0.81), (0.63, 0.70, 0.66)),
    ),
    Palette(  # walnut, camel, petrol
        material("walnut", (0.47, 0.32, 0.21)), material("dark walnut", (0.32, 0.21, 0.14)),
        material("walnut front", (0.52, 0.36, 0.24)),
        _fabrics((0.27, 0.40, 0.43), (0.70, 0.55, 0.40), (0.58, 0.57, 0.55)),
        _fabrics((0.80, 0.48, 0.30), (0.86, 0.78, 0.62), (0.36, 0.50, 0.52)), BRASS,
        _fabrics((0.86, 0.82, 0.75), (0.42, 0.53, 0.56)),
    ),
    Palette(  # beech, dusty blue, terracotta
        material("beech", (0.84, 0.69, 0.52)), material("chestnut", (0.58, 0.40, 0.26)),
        material("cream front", (0.92, 0.89, 0.82), 0.5),
        _fabrics((0.46, 0.55, 0.66), (0.77, 0.73, 0.67), (0.68, 0.47, 0.38)),
        _fabrics((0.82, 0.60, 0.46), (0.88, 0.82, 0.68), (0.40, 0.50, 0.62)), STEEL,
        _fabrics((0.90, 0.89, 0.87), (0.60, 0.68, 0.77)),
    ),
    Palette(  # ash, charcoal, ochre
        material("ash", (0.86, 0.78, 0.65)), material("black oak", (0.21, 0.19, 0.18)),
        material("grey front", (0.74, 0.74, 0.72), 0.5),
        _fabrics((0.36, 0.38, 0.40), (0.66, 0.65, 0.63), (0.50, 0.53, 0.47)),
        _fabrics((0.85, 0.66, 0.26), (0.90, 0.89, 0.86), (0.55, 0.38, 0.36)), BLACK,
        _fabrics((0.85, 0.85, 0.84), (0.52, 0.55, 0.58)),
    ),
    Palette(  # teak, forest, rose
        material("teak", (0.66, 0.46, 0.29)), material("mahogany", (0.40, 0.23, 0.17)), IVORY,
        _fabrics((0.33, 0.43, 0.36), (0.78, 0.68, 0.62), (0.62, 0.58, 0.52)),
        _fabrics((0.78, 0.55, 0.52), (0.88, 0.78, 0.58), (0.44, 0.54, 0.45)), BRASS,
        _fabrics((0.92, 0.89, 0.85), (0.80, 0.66, 0.62)),
    ),
)  # fmt: skip


@dataclass(frozen=True)
class Piece:
    """What a builder needs: the box to fill and the materials chosen for it.

    Attributes:
        d: Depth (x) in metres.
        w: Width (y) in metres.
        h: Height (z) in metres.
        palette: The room's materials.
        fabric: Upholstery of this asset.
        accent: Second colour of this asset.
        bedding: Duvet or blanket of this asset.
        kind: Name of the category.
        variant: A number from 0 to 11 that picks the style.
        key: Text that seeds what differs between two assets of one list (books on shelves).
    """

    d: float
    w: float
    h: float
    palette: Palette
    fabric: Material
    accent: Material
    bedding: Material
    kind: str
    variant: int
    key: str

    @property
    def x(self) -> tuple[float, float]:
        """Back and front."""
        return (-self.d / 2, self.d / 2)

    @property
    def y(self) -> tuple[float, float]:
        """Right and left."""
        return (-self.w / 2, self.w / 2)

    @property
    def z(self) -> tuple[float, float]:
        """Bottom and top."""
        return (0.0, self.h)

    @property
    def wood(self) -> Material:
        """The main wood."""
        return self.palette.wood

    @property
    def dark(self) -> Material:
        """The darker wood."""
        return self.palette.wood_dark

    @property
    def front(self) -> Material:
        """Cabinet fronts."""
        return self.palette.front

    @property
    def metal(self) -> Material:
        """Handles and thin legs."""
        return self.palette.metal

    def rng(self) -> random.Random:
        """Return a fresh generator for the details of this very asset."""
        return random.Random(utf8(self.key))

    def thin(self, most: float, share: float = 0.12) -> float:
        """Return a thickness: `most` metres, but no more than `share` of the smallest edge."""
        return min(most, share * min(self.d, self.w, self.h))


def _shared() -> dict[str, Callable[[Piece], Material]]:
    """Return what chooses a material that depends on the room or on the thing itself, by name."""
    return {
        "wood": lambda p: p.wood,
        "dark": lambda p: p.dark,
        "front": lambda p: p.front,
        "metal": lambda p: p.metal,
        "fabric": lambda p: p.fabric,
        "accent": lambda p: p.accent,
        "bedding": lambda p: p.bedding,
        "fabric0": lambda p: p.palette.fabrics[0],
        "accent0": lambda p: p.palette.accents[0],
        "accent1": lambda p: p.palette.accents[1],
        "accent2": lambda p: p.palette.accents[2],
        "cloth": lambda p: p.rng().choice(SPINES),
    }


def _always(it: Material) -> Callable[[Piece], Material]:
    """Return what chooses the same material for every thing."""
    return lambda _: it


MATERIALS: dict[str, Callable[[Piece], Material]] = (
    {
        ("anthracite" if key == "DARK" else key.lower().replace("_", "-")): _always(value)
        for key, value in tuple(globals().items())
        if isinstance(value, Material)
    }
    | {cloth.name.replace(" ", "-"): _always(cloth) for cloth in SPINES}
    | _shared()
)
"""What rows may name: what is the same everywhere, and what the room or the thing chooses."""


def make_piece(kind: str, variable: str, name: str, size: tuple[float, float, float], seed: int) -> Piece:
    """Choose materials: the palette by seed, the rest by the asset's list, so that chairs of one list match."""
    rng = random.Random(utf8(f"{seed}/{variable}"))
    palette = PALETTES[seed % len(PALETTES)]
    fabric, accent, bedding = (rng.choice(row) for row in (palette.fabrics, palette.accents, palette.bedding))
    return Piece(*size, palette, fabric, accent, bedding, kind, rng.randrange(12), f"{seed}/{name}")
