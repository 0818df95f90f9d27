"""Which AI2-THOR asset stands for one of ours: the nearest in size of the same type.

The table of 1,653 assets (names, types, boxes) is `data/thor_assets.csv`, derived from the PyPI package procthor
(Allen Institute for AI, Apache License 2.0).
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

from robolayout.scene import Asset

HOLES = ("Doorway", "Doorframe", "Window")
"""Types that belong into walls, never onto a floor."""

Size = tuple[float, float, float]


@dataclass(frozen=True)
class ThorAsset:
    """One asset of AI2-THOR.

    Attributes:
        type: Its object type ("SideTable").
        name: Its asset id.
        size: Depth (along its front), width and height in metres.
    """

    type: str
    name: str
    size: Size

    def distance(self, size: Size) -> float:
        """Return the largest difference in metres between its sides and those of a box."""
        return max(abs(a - b) for a, b in zip(self.size, size, strict=True))


def _rows(name: str) -> list[dict[str, str]]:
    """Return the rows of a table of this package, without its comment lines."""
    text = files("robolayout.export").joinpath("data", name).read_text(encoding="utf-8")
    return list(csv.DictReader(line for line in text.splitlines() if not line.startswith("#")))


@cache
def catalogue() -> dict[str, tuple[ThorAsset, ...]]:
    """Return all assets of AI2-THOR by type."""
    found: dict[str, list[ThorAsset]] = {}
    for row in _rows("thor_assets.csv"):
        size = (float(row["depth"]), float(row["width"]), float(row["height"]))
        found.setdefault(row["type"], []).append(ThorAsset(row["type"], row["asset"], size))
    return {name: tuple(assets) for name, assets in found.items()}


@cache
def _phrases() -> dict[tuple[str, ...], str]:
    """Return the THOR type of every known phrase, as words."""
    return {tuple(row["words"].split()): row["type"] for row in _rows("thor_types.csv")}


def thor_type(category: str) -> str | None:
    """Return the THOR type of a category in words, or None.

    The longest known phrase within the category wins; of equally long ones the last, since the head of an English
    compound comes last ("desk chair" is a chair).
    """
    words = category.lower().replace("_", " ").replace("-", " ").split()
    for length in range(len(words), 0, -1):
        for start in range(len(words) - length, -1, -1):
            found = _phrases().get(tuple(words[start : start + length]))
            if found is not None:
                return found
    return None


def nearest(asset: Asset) -> ThorAsset:
    """Return the THOR asset of the same type whose box is nearest in size; of all types where the type is unknown."""
    kind = thor_type(asset.category)
    types = [kind] if kind is not None else [name for name in catalogue() if name not in HOLES]
    return nearest_of(types, asset.size)


def nearest_of(types: list[str], size: Size) -> ThorAsset:
    """Return the asset of some types whose box is nearest in size; ties go to the first by name."""
    candidates = [asset for name in types for asset in catalogue()[name]]
    return min(candidates, key=lambda asset: (asset.distance(size), asset.name))
