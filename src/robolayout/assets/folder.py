"""A folder of meshes to a catalogue: units, up axis, box and category of every file, found without asking."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from robolayout._errors import AssetError, UnknownNameError
from robolayout._reading import MESH_SUFFIXES, Checker, is_file, regular_bytes
from robolayout._reading.syntax import decoded, json_value
from robolayout.assets.category import Category
from robolayout.assets.lexicon import find_category
from robolayout.assets.own import AXES, Size, extent, fits_y_up, orientation, read_pieces
from robolayout.scene import variable_name

MAX_FILES = 5000
"""Mesh files that are looked at in one folder."""
MAX_JSON = 1_000_000
"""Largest metadata file in bytes."""
UNITS = (("m", 1.0), ("cm", 0.01), ("mm", 0.001), ("inch", 0.0254))
"""Units that mesh files are drawn in, the likeliest first, and their length in metres."""
CLEARLY = math.log(2.0)
"""Another unit than metres must fit the category's size better by this log ratio."""
PLAUSIBLE = (0.02, 6.0)
"""Longest edge in metres of a thing of unknown category."""
LARGEST = 100.0
"""Largest side of a box in metres."""
FLAGS = {"onFloor": "on_floor", "onWall": "on_wall", "onCeiling": "on_ceiling", "onObject": "on_object"}
VIEWS = ("+z", "+x", "-z", "-x")
"""Front axis of a y-up mesh by objathor's `frontView`: a quarter turn each."""

_CHECK = Checker(AssetError)


@dataclass(frozen=True)
class Guess:
    """What the words around a mesh file say.

    Attributes:
        text: Its category in words.
        description: Free words about it.
        flags: Placement flags that the metadata states, by their key in scene files.
        size: Depth, width, height in metres where the metadata states them.
        front: Axis of its front, where the metadata states it.
    """

    text: str
    description: str
    flags: Mapping[str, bool]
    size: Size | None = None
    front: str | None = None


def import_folder(directory: Path, *, front: str | None = None, up: str | None = None) -> dict[str, Any]:
    """Read all meshes below a folder into a catalogue whose entries can stand in a scene file's "assets".

    Args:
        directory: The folder; LayoutVLM and objathor folders (`<uid>/data.json` with `<uid>.glb`) are read as they are.
        front: Axis of all files that points forward ("+x"); None follows metadata, then the format.
        up: Axis of all files that points up ("+y"); None finds it.

    Returns:
        {"assets": {name: entry}, "skipped": [{"path", "reason"}]}; paths are relative to the folder.

    Raises:
        AssetError: The folder does not exist or holds no mesh file.
        UnknownNameError: There is no such axis.
    """
    if not directory.is_dir():
        raise AssetError(f"asset folder {directory.name!r} does not exist or is no folder.")
    for axis in (front, up):
        if axis is not None and axis not in AXES:
            raise UnknownNameError("axis", axis, AXES)
    assets: dict[str, Any] = {}
    skipped: list[dict[str, str]] = []
    for path in _mesh_files(directory):
        shown = path.relative_to(directory).as_posix()
        try:
            name, entry = _entry(path, shown, front=front, up=up)
        except AssetError as error:
            skipped.append({"path": shown, "reason": str(error)})
            continue
        assets[_free(name, assets)] = entry
    if not assets and not skipped:
        raise AssetError(
            f"asset folder {directory.name!r} holds no mesh; put {', '.join(MESH_SUFFIXES)} files into it."
        )
    return {"assets": assets, "skipped": skipped}


def _mesh_files(directory: Path) -> Iterator[Path]:
    """Yield mesh files below a folder in the order of their names; links are not followed."""
    found = (p for p in directory.rglob("*") if p.suffix.lower() in MESH_SUFFIXES and is_file(p) and not p.is_symlink())
    root = directory.resolve()
    inside = sorted(p for p in found if p.resolve().is_relative_to(root))
    if len(inside) > MAX_FILES:
        raise AssetError(f"asset folder {directory.name!r} holds {len(inside)} meshes; at most {MAX_FILES} are read.")
    yield from inside


def _free(name: str, taken: Mapping[str, Any]) -> str:
    """Return `<name>-<n>` with the first index that is not taken."""
    index = 0
    while f"{name}-{index}" in taken:
        index += 1
    return f"{name}-{index}"


def _entry(path: Path, shown: str, *, front: str | None, up: str | None) -> tuple[str, dict[str, Any]]:
    """Return the variable name and the scene entry of one mesh file."""
    guess = _guess(path)
    pieces = read_pieces(path)
    edges = extent(pieces)
    words = guess.description + " " + " ".join(piece.name for piece in pieces[:20])
    category = find_category(guess.text, description=words)
    unit, factor = ("m", 1.0) if guess.size else _unit(edges, category)
    target = guess.size or category.size
    upward = up or ("+y" if path.suffix.lower() == ".glb" or fits_y_up(edges, target) else "+z")
    forward = front or guess.front or ("+z" if upward[1] == "y" else "+x")
    turned = np.abs(orientation(path, edges, target, up=upward, front=forward)) @ np.array(edges) * factor
    size = guess.size or (float(turned[0]), float(turned[1]), float(turned[2]))
    if category.group == "unknown" or category.name not in guess.text:
        category = find_category(guess.text, description=words, size=size)
    return variable_name(guess.text)[:60], _as_scene(shown, guess, category, size, (unit, upward, forward))


def _as_scene(shown: str, guess: Guess, category: Category, size: Size, axes: tuple[str, str, str]) -> dict[str, Any]:
    """Return one asset as a scene file writes it, with what was found about the mesh."""
    depth, width, height = (round(max(edge, 0.001), 4) for edge in size)
    return {
        "category": category.name,
        "description": guess.description or guess.text,
        "path": shown,
        **{key: bool(guess.flags.get(key, getattr(category, name))) for key, name in FLAGS.items()},
        "assetMetadata": {"boundingBox": {"x": depth, "y": width, "z": height}},
        "unit": axes[0],
        "up": axes[1],
        "front": axes[2],
    }


def _unit(edges: Size, category: Category) -> tuple[str, float]:
    """Return the unit in which the mesh's size is most plausible for its category; metres unless clearly not."""
    longest = max(edges)
    if longest <= 0.0:
        raise AssetError("the mesh has no extent; export it again.")
    if category.group == "unknown":
        fits = [pair for pair in UNITS if PLAUSIBLE[0] <= longest * pair[1] <= PLAUSIBLE[1]]
        return fits[0] if fits else UNITS[0]
    own = sorted(edges)[1:]
    typical = sorted(category.size)[1:]

    def misfit(factor: float) -> float:
        return sum(abs(math.log(max(a, 1e-9) * factor / b)) for a, b in zip(own, typical, strict=True)) / 2

    best = min(UNITS[:3], key=lambda pair: misfit(pair[1]))
    return best if misfit(best[1]) < misfit(1.0) - CLEARLY else UNITS[0]


def _guess(path: Path) -> Guess:
    """Collect the words about a mesh: objathor's data.json, a JSON file beside it, else its file and folder names."""
    beside = path.with_name("data.json")
    if is_file(beside) and path.stem == path.parent.name:
        return _objathor(path, _json(beside))
    words = _words(path.stem) or _words(path.parent.name)
    sidecar = path.with_suffix(".json")
    if not is_file(sidecar):
        return Guess(words or "asset", words, {})
    category, description, flags = _said(_json(sidecar), sidecar.name)
    return Guess(category or words or "asset", description or words, flags)


def _said(data: Mapping[str, object], where: str) -> tuple[str, str, dict[str, bool]]:
    """Return category, description and placement flags of a metadata file; empty where it says nothing."""
    category = _CHECK.text(data.get("category") or "", f"{where}: category", most=200)
    description = _CHECK.text(data.get("description") or "", f"{where}: description")
    return category, description, {key: _CHECK.flag(data[key], f"{where}: {key}") for key in FLAGS if key in data}


def _words(name: str) -> str:
    """Return the words of a file name, without numbers and hashes."""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
    words = [word for word in re.split(r"[^A-Za-z]+", spaced) if len(word) > 1]
    looks_like_hash = re.fullmatch(r"[0-9a-fA-F\-]{12,}", name) is not None
    return "" if looks_like_hash else " ".join(words)


def _json(path: Path) -> Mapping[str, Any]:
    """Read a metadata file within bounds."""
    what = f"metadata {path.parent.name}/{path.name}"
    text = _CHECK.parse(lambda file: decoded(regular_bytes(file, MAX_JSON)), path, what)
    return _CHECK.mapping(_CHECK.parse(json_value, text, what), what)


def _objathor(path: Path, data: Mapping[str, Any]) -> Guess:
    """Read LayoutVLM's and objathor's metadata; there bounding-box x is the width and y the depth.

    Where `frontView` says that the front is a quarter turn away, width and depth change places.
    """
    where = f"{path.parent.name}/data.json"
    notes = _CHECK.mapping(_CHECK.required(data, "annotations", where), f"{where}: annotations")
    metadata = _CHECK.mapping(_CHECK.required(data, "assetMetadata", where), f"{where}: assetMetadata")
    place = f"{where}: assetMetadata.boundingBox"
    edges = _CHECK.mapping(_CHECK.required(metadata, "boundingBox", f"{where}: assetMetadata"), place)
    across, along, height = (
        _CHECK.number(_CHECK.required(edges, key, place), f"{place}.{key}", above=0.0, most=LARGEST) for key in "xyz"
    )
    turns = _CHECK.number(notes.get("frontView", 0), f"{where}: annotations.frontView", least=0.0, most=1000.0)
    view = VIEWS[int(turns) % 4]
    size = (along, across, height) if view[1] == "z" else (across, along, height)
    _CHECK.required(notes, "category", f"{where}: annotations")
    text, words, flags = _said(notes, f"{where}: annotations")
    return Guess(text, words, flags, size, view)
