"""An asset: one thing to be placed, with its box, its placement flags and its name."""

from __future__ import annotations

import keyword
import re
from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Asset:
    """One thing to be placed.

    At zero rotation it faces +x, so x is its depth and y its width.

    Attributes:
        name: Unique name in the scene, `<variable>-<index>` ("night_stand-0").
        category: What it is, in words ("night stand").
        size: Depth (x), width (y) and height (z) of its box in metres.
        description: Free words about this very asset; data, never code.
        on_floor: It may stand on the floor.
        on_wall: It is fixed to a wall.
        on_ceiling: It hangs from the ceiling.
        on_object: It may stand on another asset.
        path: A GLB file that replaces the parametric mesh.
        use_sides: Sides it is used from ("front", "back", "left", "right"); None leaves it to the category.
        like: Words that say instead of `category` what it is drawn, opened and moved like; empty where that is clear.
        metadata: Any further keys of the scene file, kept for writing.
    """

    name: str
    category: str
    size: tuple[float, float, float]
    description: str = ""
    on_floor: bool = True
    on_wall: bool = False
    on_ceiling: bool = False
    on_object: bool = False
    path: Path | None = None
    use_sides: tuple[str, ...] | None = None
    like: str = ""
    metadata: dict[str, object] = field(default_factory=dict[str, object], compare=False)

    @property
    def variable(self) -> str:
        """The name of its list in a constraint program ("night_stand")."""
        return self.name.rpartition("-")[0]

    @property
    def index(self) -> int:
        """Its place in that list."""
        return int(self.name.rpartition("-")[2])

    @property
    def is_flat(self) -> bool:
        """Whether it is a flat floor covering (below 3 cm), which never stands in the way (DESIGN section 4)."""
        return self.size[2] < FLAT_HEIGHT and self.on_floor and not self.on_object


FLAT_HEIGHT = 0.03
"""Height in metres below which a floor asset is a rug."""


_LANGUAGE = (
    "solver, walls, room, assets, assetinstance, math, radians, degrees, pi, range, len, enumerate, zip, min, "
    "max, abs, sum, round, print, int, float, str, bool, list, dict, tuple, set, sorted, reversed, any, all, map, filter"
)

RESERVED_NAMES = frozenset(_LANGUAGE.split(", "))
"""Names that mean something else in a constraint program, so that no asset may take them."""


def variable_name(category: str) -> str:
    """Return the Python variable for a category: "night stand" becomes "night_stand", "range" "asset_range"."""
    name = re.sub(r"\W+", "_", category.strip().lower(), flags=re.ASCII).strip("_")
    taken = not name or name[0].isdigit() or name in RESERVED_NAMES or keyword.iskeyword(name)
    return f"asset_{name}" if taken else name
