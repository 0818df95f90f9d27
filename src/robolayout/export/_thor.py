"""Which AI2-THOR asset stands for one of ours: the nearest in size of the same type.

The table of 1,653 assets (names, types, boxes) is `data/thor_assets.csv`, derived from the PyPI package procthor
(Allen Institute for AI, Apache License 2.0).
"""

from __future__ import annotations

import csv
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files

from robolayout.scene import Asset, Layout, Pose, Scene

Size = tuple[float, float, float]


@dataclass(frozen=True)
class ThorAsset:
    """One asset of AI2-THOR."""

    type: str  # its object type ("SideTable")
    name: str  # its asset id
    size: Size  # depth (along its front), width and height in metres

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
def _phrases() -> dict[str, str]:
    """Return the THOR type of every known phrase; empty where there is none."""
    return {row["words"]: row["type"] for row in _rows("thor_types.csv")}


def thor_type(category: str) -> str | None:
    """Return the THOR type that a category in words is, or None.

    The head of an English compound comes last ("desk chair" is a chair), so the longest known phrase at its end decides.
    """
    words = category.lower().replace("_", " ").replace("-", " ").split()
    ends = [f"={' '.join(words)}", *(" ".join(words[start:]) for start in range(len(words)))]
    return next((_phrases()[phrase] or None for phrase in ends if phrase in _phrases()), None)


def nearest(asset: Asset) -> ThorAsset | None:
    """Return the THOR asset that stands for one of ours, the nearest in size of the same type; None where there is none."""
    kind = thor_type(asset.category)
    if kind is None or asset.is_flat or (asset.on_ceiling and not (asset.on_floor or asset.on_object)):
        return None
    return nearest_of([kind], asset.size)


def kept(asset: Asset) -> str:
    """Return what is kept of an asset's height in THOR: its bottom where it stands, else its middle."""
    return "bottom" if asset.on_floor or asset.on_object else "middle"


def rise(asset: Asset, size: Size) -> float:
    """Return how far up its middle moves in metres where an asset takes the size of THOR's."""
    return (size[2] - asset.size[2]) / 2 if kept(asset) == "bottom" else 0.0


def as_in_thor(scene: Scene, layout: Layout) -> tuple[Scene, Layout]:
    """Return a room with the boxes of THOR's assets, each where ours is, and without what has no counterpart.

    Rugs and what hangs from the ceiling stay: they take no room, and lamps shine.
    """
    assets: list[Asset] = []
    poses: dict[str, Pose] = {}
    for asset in scene.assets:
        thor = nearest(asset)
        if thor is None and not (asset.is_flat or asset.on_ceiling):
            continue
        assets.append(asset if thor is None else replace(asset, size=thor.size))
        if (pose := layout.get(asset.name)) is not None:
            poses[asset.name] = replace(pose, z=pose.z + rise(asset, assets[-1].size))
    return replace(scene, assets=tuple(assets)), Layout(poses)


def nearest_of(types: list[str], size: Size) -> ThorAsset:
    """Return the asset of some types whose box is nearest in size; ties go to the first by name."""
    candidates = [asset for name in types for asset in catalogue()[name]]
    return min(candidates, key=lambda asset: (asset.distance(size), asset.name))
