"""An asset: one thing to be placed, with its box, its placement flags and its name."""

from __future__ import annotations

import keyword
import re
import unicodedata
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Asset:
    """One thing to be placed.

    At zero rotation it faces +x, so x is its depth and y its width.
    """

    name: str  # unique name in the scene, byte for byte as in its file ("night_stand-0", "桌子", "map-0")
    category: str  # what it is, in words ("night stand")
    size: tuple[float, float, float]  # depth (x), width (y) and height (z) of its box in metres
    description: str = ""  # free words about this very asset; data, never code
    on_floor: bool = True  # it may stand on the floor
    on_wall: bool = False  # it is fixed to a wall
    on_ceiling: bool = False  # it hangs from the ceiling
    on_object: bool = False  # it may stand on another asset
    path: Path | None = None  # A GLB file that replaces the parametric mesh
    # sides it is used from ("front", "back", "left", "right"); None leaves it to the category
    use_sides: tuple[str, ...] | None = None
    # words that say instead of `category` what it is drawn, opened and moved like; empty where that is clear
    like: str = ""
    parts: str = ""  # rows that say what it is made of (docs/assets.md); empty where its category says so
    # names of its parts that are left out: what is drawn on a shelf where real things lie
    without: tuple[str, ...] = ()
    synonyms: tuple[str, ...] = ()  # other words by which sentences name it
    # any further keys of the scene file, kept for writing
    metadata: dict[str, object] = field(default_factory=dict[str, object], compare=False)

    @property
    def variable(self) -> str:
        """The name of its list in a constraint program ("night_stand"), valid Python whatever its own name is."""
        return program_variable(self.name)

    @property
    def index(self) -> int:
        """The number at the end of its name; 0 without one."""
        return split_name(self.name)[1]

    @property
    def lies_about(self) -> bool:
        """Whether it is one of the small things that people leave about: counted, but never asked for."""
        return bool(self.metadata.get(LIES_ABOUT))

    @property
    def is_flat(self) -> bool:
        """Whether it is a flat floor covering (below 3 cm), which never stands in the way (DESIGN section 4)."""
        return self.size[2] < FLAT_HEIGHT and self.on_floor and not self.on_object


FLAGS = {"onFloor": "on_floor", "onWall": "on_wall", "onCeiling": "on_ceiling", "onObject": "on_object"}
"""Keys of a scene file that say where a thing may be, and what they are called here."""
LIES_ABOUT = "liesAbout"  # key of the metadata of what people leave about: nobody is asked to get to it
FLAT_HEIGHT = 0.03  # height in metres below which a floor asset is a rug

_LANGUAGE = (
    "solver, walls, room, assets, assetinstance, math, radians, degrees, pi, range, len, enumerate, zip, min, "
    "max, abs, sum, round, print, int, float, str, bool, list, dict, tuple, set, sorted, reversed, any, all, map, filter"
)

RESERVED_NAMES = frozenset(_LANGUAGE.split(", "))
"""Names that mean something else in a constraint program, so that no variable of an asset may take them."""


def variable_name(words: str) -> str:
    """Return the Python variable for a name or category: "night stand" becomes "night_stand", "range" "asset_range".

    Accents are dropped ("Bücherregal": "bucherregal"); letters without a Latin one are written as their code points
    ("桌子": "u684c_u5b50").
    """
    latin = ""
    for letter in words.strip().lower():  # itself, without its accent, or its code point between spaces
        kind = unicodedata.category(letter)[0]
        code = "" if kind == "M" else f" u{ord(letter):x} " if kind in "LNS" else " "
        latin += "".join(part for part in unicodedata.normalize("NFKD", letter) if part.isascii()) or code
    name = re.sub(r"\W+", "_", latin, flags=re.ASCII).strip("_")
    if not name:
        return "asset"
    return f"asset_{name}" if name[0].isdigit() or _is_word(name) else name


def by_variable(assets: Iterable[Asset]) -> dict[str, tuple[Asset, ...]]:
    """Return assets by program variable, in the order of their numbers, whatever their order in the file.

    Where two names come to one variable and number ("bed-0" and "bed"), that of the form `<variable>-<number>` is first.
    """
    groups: dict[str, list[Asset]] = {}
    for asset in assets:
        groups.setdefault(asset.variable, []).append(asset)
    return {
        variable: tuple(sorted(group, key=lambda a: (a.index, a.name != f"{variable}-{a.index}", a.name)))
        for variable, group in groups.items()
    }


def program_variable(name: str) -> str:
    """Return the Python variable for an asset's name: "night stand-1" becomes "night_stand", "map-0" "asset_map"."""
    stem, _ = split_name(name)
    plain = re.fullmatch(r"[A-Za-z]\w*", stem, flags=re.ASCII) and not _is_word(stem)
    return stem if plain else variable_name(stem)


def split_name(name: str) -> tuple[str, int]:
    """Return an asset's name without its number, and the number: "night stand-1" is "night stand" and 1, "bed" "bed" and 0."""
    match = re.fullmatch(r"(.*)-(\d{1,6})", name, flags=re.ASCII | re.DOTALL)
    return (match[1], int(match[2])) if match else (name, 0)


def _is_word(name: str) -> bool:
    """Return whether a name means something else in a program, whatever its case."""
    return keyword.iskeyword(name) or keyword.iskeyword(name.lower()) or name.lower() in RESERVED_NAMES
