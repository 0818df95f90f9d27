"""Materials that go together: a room's seed picks a palette, an asset's list picks among its fabrics."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from robolayout._text import utf8
from robolayout.assets.category import CATALOGUE, read_data
from robolayout.assets.part import Material

CLOTH = 0.95  # roughness of fabrics
SOFT = ("seating", "textiles")  # groups whose colour is that of their cloth, as it is of beds


@dataclass(frozen=True)
class Palette:
    """Materials of one room."""

    wood: Material  # the main wood
    wood_dark: Material  # A darker companion, for legs and frames
    front: Material  # cabinet fronts
    fabrics: tuple[Material, ...]  # upholstery colours
    accents: tuple[Material, ...]  # cushions, rugs, small things
    metal: Material  # handles and thin legs
    bedding: tuple[Material, ...]  # sheets and duvets


def material_from(entry: str | Mapping[str, Any]) -> Material:
    """Return a material of a data file: one of `PLAIN` by its name, or one that is written out."""
    if isinstance(entry, str):
        return PLAIN[entry]
    found: dict[str, Any] = {**entry, "color": tuple(entry["color"])}
    return Material(**found)


def _palette(entry: Mapping[str, Any]) -> Palette:
    """Return a palette; single materials are named or written out, cloths are rows of colours."""

    def read(value: Any) -> Material | tuple[Material, ...]:
        if not isinstance(value, list):
            return material_from(value)
        return tuple(Material(f"fabric {i}", tuple(color), CLOTH, texture="weave") for i, color in enumerate(value))

    return Palette(**{key: read(value) for key, value in entry.items()})  # type: ignore[arg-type]


_FILE = read_data("materials.toml")
PLAIN: Mapping[str, Material] = {key: material_from(entry) for key, entry in _FILE["materials"].items()}
"""Materials that are the same in every room, by the names that rows use."""
PALETTES = tuple(_palette(entry) for entry in _FILE["palettes"])  # the palettes that a seed picks from
STYLED: Mapping[str, Palette] = {palette.wood.name: palette for palette in PALETTES} | {
    word: palette
    for entry in _FILE["styled"]
    for palette in [_palette({key: value for key, value in entry.items() if key != "words"})]
    for word in entry["words"]
}
"""Palettes by the words that a look names them with: a style, or the main wood of one that seeds pick."""
COLORS: Mapping[str, Material] = {word: Material(word, tuple(color), CLOTH) for word, color in _FILE["colors"].items()}
"""Colours that a look may name."""
WOODS: Mapping[str, Material] = {word: material_from(entry) for word, entry in _FILE["woods"].items()}
"""What a look may say that tables and cupboards are made of."""
CLOTHS: Mapping[str, Material] = {word: material_from(entry) for word, entry in _FILE["cloths"].items()}
"""What a look may say that seats are covered with."""
LOOKS = frozenset((*STYLED, *COLORS, *WOODS, *CLOTHS))  # every word that a look may name
GROUPS: Mapping[str, tuple[str, ...]] = {name: tuple(names) for name, names in _FILE["groups"].items()}
"""Names of several materials that rows name together."""


@dataclass(frozen=True)
class Brief:
    """What a builder needs: the box to fill and the materials chosen for it."""

    d: float  # depth (x) in metres
    w: float  # width (y) in metres
    h: float  # height (z) in metres
    palette: Palette  # the room's materials
    fabric: Material  # upholstery of this asset
    accent: Material  # second colour of this asset
    bedding: Material  # duvet or blanket of this asset
    kind: str  # name of the category
    variant: int  # A number from 0 to 11 that picks the style
    key: str  # text that seeds what differs between two assets of one list (books on shelves)


CHOSEN: Mapping[str, Callable[[Brief], Material]] = {
    "wood": lambda p: p.palette.wood,
    "dark": lambda p: p.palette.wood_dark,
    "front": lambda p: p.palette.front,
    "metal": lambda p: p.palette.metal,
    "fabric": lambda p: p.fabric,
    "accent": lambda p: p.accent,
    "bedding": lambda p: p.bedding,
    "cloth": lambda p: PLAIN[random.Random(utf8(p.key)).choice(GROUPS["spines"])],
}
"""What the room or the thing itself chooses, by the names that rows use."""
MATERIALS = (*PLAIN, *CHOSEN)  # everything that rows may name


def material_of(name: str, p: Brief) -> Material:
    """Return the material of that name for a piece."""
    return CHOSEN[name](p) if name in CHOSEN else PLAIN[name]


def make_piece(
    kind: str, variable: str, name: str, size: tuple[float, float, float], seed: int, look: str = ""
) -> Brief:
    """Choose materials: as its look (words of `LOOKS`) says, else the palette by seed, the rest by the asset's list: chairs match."""
    rng = random.Random(utf8(f"{seed}/{variable}"))
    said = [word.strip() for word in look.split(",")]
    palette = next((STYLED[word] for word in said if word in STYLED), PALETTES[seed % len(PALETTES)])
    wood = next((WOODS[word] for word in said[1:] if word in WOODS), None)
    palette = palette if wood is None else replace(palette, wood=wood, front=wood)
    fabric, accent, bedding = (rng.choice(row) for row in (palette.fabrics, palette.accents, palette.bedding))
    cloth = next((CLOTHS[word] for word in said if word in CLOTHS), fabric)
    color = next((COLORS[word] for word in said if word in COLORS), None)
    if color is not None:
        soft = kind.endswith("bed") or (kind in CATALOGUE and CATALOGUE[kind].group in SOFT)
        palette = palette if soft or wood is not None else replace(palette, wood=color, front=color)
        cloth, accent, bedding = (replace(m, name=color.name, color=color.color) for m in (cloth, accent, bedding))
    return Brief(*size, palette, cloth, accent, bedding, kind, rng.randrange(12), f"{seed}/{name}")
