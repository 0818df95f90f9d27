"""Which AI2-THOR asset stands for one of ours: the nearest in size of the same type.

The table of 1,653 assets (names, types, boxes) is `data/thor_assets.csv`, derived from the PyPI package procthor
(Allen Institute for AI, Apache License 2.0).
"""

from __future__ import annotations

import csv
import math
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

    def stretch(self, size: Size) -> float:
        """Return the largest factor, as a logarithm, by which one of its sides differs from a box's."""
        return max(abs(math.log(a / b)) for a, b in zip(self.size, size, strict=True))


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


def nearest(asset: Asset) -> ThorAsset | None:
    """Return the THOR asset that stands for one of ours, or None where nothing can.

    It is the nearest in size of the same type. Where no type fits, it is the asset of nearly the same proportions among
    all types, a stand-in that at least takes up the room. THOR has no rugs and nothing that hangs from a ceiling.
    """
    if asset.is_flat or (asset.on_ceiling and not (asset.on_floor or asset.on_object)):
        return None
    kind = thor_type(asset.category)
    if kind is not None:
        return nearest_of([kind], asset.size)
    others = [each for name, assets in catalogue().items() if name not in HOLES for each in assets]
    return min(others, key=lambda each: (each.stretch(asset.size), each.name))


def nearest_of(types: list[str], size: Size) -> ThorAsset:
    """Return the asset of some types whose box is nearest in size; ties go to the first by name."""
    candidates = [asset for name in types for asset in catalogue()[name]]
    return min(candidates, key=lambda asset: (asset.distance(size), asset.name))
