"""A folder of meshes to a catalogue: category, unit, axes and box of every file, found without asking.

What is found comes with how sure it is; `corrections.json` in the folder says what was found wrongly.
"""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from itertools import count
from pathlib import Path
from typing import Any

import numpy as np

from robolayout._errors import AssetError, among
from robolayout._reading import LIMITS, MESH_SUFFIXES, Checker, inside, regular_bytes
from robolayout._reading.syntax import decoded, json_value
from robolayout.assets.category import Category
from robolayout.assets.lexicon import find_category
from robolayout.assets.likeness import WAYS, sampled, stands
from robolayout.assets.own import AXES, Size, extent, fits_y_up, orientation, read_pieces
from robolayout.assets.part import Part
from robolayout.scene import FLAGS, variable_name

UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "inch": 0.0254}
"""Units that mesh files are drawn in, the likeliest first, and their length in metres."""
SCALED = "none"  # the unit of a mesh that fits its category's size in no unit, and is scaled to it
CLEARLY = math.log(2.0)
"""Another unit than metres must fit the category's size better by this log ratio; metres that miss by more fit not at all."""
SURE = 0.3  # how sure an axis or unit must be not to be asked about
CORRECTIONS = "corrections.json"
UNREAD = (".3ds", ".blend", ".dae", ".fbx", ".gltf", ".usd", ".usda", ".usdc", ".usdz")
"""Kinds of mesh file that are not read, and named as skipped."""
PLAUSIBLE = (0.02, 6.0)  # longest edge in metres of a thing of unknown category
VIEWS = ("+z", "+x", "-z", "-x")  # front axis of a y-up mesh by objathor's `frontView`: a quarter turn each
_CHECK = Checker(AssetError)


@dataclass(frozen=True)
class FileGuess:
    """What the words around a mesh file say."""

    text: str  # its category in words
    description: str  # free words about it
    flags: Mapping[str, bool]  # placement flags that the metadata states, by their key in scene files
    size: Size | None = None  # depth, width, height in metres where the metadata states them
    unit: str | None = None  # its unit, where the metadata states it
    up: str | None = None  # axis that points up, where the metadata states it
    front: str | None = None  # axis of its front, where the metadata states it
    sure: Mapping[str, float] = field(default_factory=dict[str, float])  # how sure what was found is, 0 to 1 by field


def import_folder(directory: Path, *, front: str | None = None, up: str | None = None) -> dict[str, Any]:
    """Read all meshes below a folder into a catalogue whose entries can stand in a scene file's "assets".

    Args:
        directory: The folder; LayoutVLM and objathor folders (`<uid>/data.json` with `<uid>.glb`) are read as they are.
            `corrections.json` in it may state category, description, placement flags, unit, up, front and size by path.
        front: Axis of all files that points forward ("+x"); None follows metadata, then the shape.
        up: Axis of all files that points up ("+y"); None finds it.

    Returns:
        {"assets": {name: entry}, "skipped": [{"path", "reason"}], "unsure": [sentence]}; paths are relative to the folder.

    Raises:
        AssetError: The folder does not exist, holds no mesh file, or its corrections cannot be read.
        UnknownNameError: There is no such axis.
    """
    if not directory.is_dir():
        raise AssetError(f"asset folder {directory.name!r} does not exist or is no folder.")
    among("axis", [axis for axis in (front, up) if axis is not None], AXES)
    assets: dict[str, Any] = {}
    skipped: list[dict[str, str]] = []
    files = {path.relative_to(directory).as_posix(): path for path in _mesh_files(directory)}
    corrections = _corrections(directory, files)
    for shown, path in files.items():
        try:
            name, entry = _entry(path, shown, corrections.get(shown), front=front, up=up)
        except AssetError as error:
            skipped.append({"path": shown, "reason": str(error)})
            continue
        assets[next(free for index in count() if (free := f"{name}-{index}") not in assets)] = entry
    if not assets and not skipped:
        raise AssetError(
            f"asset folder {directory.name!r} holds no mesh; put {', '.join(MESH_SUFFIXES)} files into it."
        )
    unsure = [sentence for name, entry in assets.items() for sentence in _unsure(name, entry)]
    return {"assets": assets, "skipped": skipped, "unsure": unsure}


def _corrections(directory: Path, files: Mapping[str, Path]) -> dict[str, Mapping[str, Any]]:
    """Return what the user says of single files, by path."""
    path = directory / CORRECTIONS
    if not os.path.isfile(path):
        return {}
    said = _json(path)
    astray = [name for name in said if name not in files]
    if astray:
        near = get_close_matches(astray[0], files, 1, 0.0)
        raise AssetError(
            f"{CORRECTIONS} corrects {astray[0]!r}, which is no mesh of this folder; nearest: {near[0]!r}."
        )
    return {name: _CHECK.mapping(entry, f"{CORRECTIONS}: {name}") for name, entry in said.items()}


def _unsure(name: str, entry: Mapping[str, Any]) -> Iterator[str]:
    """Yield a sentence for each thing that was guessed and may be wrong."""
    doubts = [f"{key} {entry[key]} ({sure:.0%})" for key, sure in entry["sure"].items() if sure < SURE]
    if find_category(entry["category"]).group == "unknown":
        doubts.insert(0, "what it is")
    if doubts:
        yield f"{name} ({entry['path']}): {', '.join(doubts)} may be wrong; look at --pictures, correct it in {CORRECTIONS}."


def _mesh_files(directory: Path) -> list[Path]:
    """Return mesh files below a folder in the order of their names, those that are not read too; links are not followed."""
    named = (path for path in directory.rglob("*") if path.suffix.lower() in (*MESH_SUFFIXES, *UNREAD))
    found = (path for path in named if os.path.isfile(path) and not path.is_symlink())
    files = sorted(path for path in found if inside(path, [directory]))
    if len(files) > LIMITS.folder_files:
        raise AssetError(
            f"asset folder {directory.name!r} holds {len(files)} meshes; at most {LIMITS.folder_files} are read."
        )
    return files


def _entry(
    path: Path, shown: str, said: Mapping[str, Any] | None, *, front: str | None, up: str | None
) -> tuple[str, dict[str, Any]]:
    """Return the variable name and the scene entry of one mesh file."""
    guess = _guess(path)
    guess = replace(guess, up=up or guess.up, front=front or guess.front)
    guess = guess if said is None else _corrected(guess, said, f"{CORRECTIONS}: {shown}")
    pieces = read_pieces(path)
    words = guess.description + " " + " ".join(piece.name for piece in pieces[:20])
    category = find_category(guess.text, description=words)
    guess = _completed(guess, path, pieces, category)
    edges = extent(pieces)
    turned = np.abs(orientation(path, edges, category.size, up=guess.up, front=guess.front)) @ np.array(edges)
    scale = np.exp(np.log(np.array(category.size) / np.maximum(turned, 1e-9)).mean())
    depth, width, height = guess.size or (turned * UNITS.get(guess.unit or SCALED, scale)).tolist()
    if category.group == "unknown" or category.name not in guess.text:
        category = find_category(guess.text, description=words, size=(depth, width, height))
    x, y, z = (round(max(edge, 0.001), 4) for edge in (depth, width, height))
    return variable_name(guess.text)[:60], {
        "category": guess.text if category.group == "unknown" else category.name,
        "description": guess.description or guess.text,
        "path": shown,
        **{key: bool(guess.flags.get(key, getattr(category, name))) for key, name in FLAGS.items()},
        "assetMetadata": {"boundingBox": {"x": x, "y": y, "z": z}},
        **{key: getattr(guess, key) for key in ("unit", "up", "front")},
        "sure": dict(guess.sure),
    }


def _corrected(guess: FileGuess, said: Mapping[str, Any], where: str) -> FileGuess:
    """Return a guess with what the user says instead."""
    known = ("category", "description", "unit", "up", "front", "size", *FLAGS)
    for key in said:
        if key not in known:
            raise AssetError(f"{where} has an unknown field {key!r}; known: {', '.join(known)}.")
    for key, choices in (("unit", [*UNITS, SCALED]), ("up", sorted(AXES)), ("front", sorted(AXES))):
        if key in said and said[key] not in choices:
            raise AssetError(f"{where}: {key} {said[key]!r} is none of {', '.join(choices)}.")
    text, words, flags = _said(said, where)
    size = said.get("size")
    edges = None if size is None else _CHECK.numbers(size, f"{where}: size", (3,))
    for edge in edges or ():
        _CHECK.number(edge, f"{where}: size", above=0.0, most=LIMITS.largest_side)
    units = {key: said.get(key) or getattr(guess, key) for key in ("unit", "up", "front")}
    own = guess.size if edges is None else (edges[0], edges[1], edges[2])
    return FileGuess(text or guess.text, words or guess.description, {**guess.flags, **flags}, own, **units)


def _completed(guess: FileGuess, path: Path, pieces: Sequence[Part], category: Category) -> FileGuess:
    """Return in which unit and axes a mesh is drawn: as is said, else as the format has it unless the shape says otherwise."""
    edges, standard = extent(pieces), ("+y", "+z") if path.suffix.lower() == ".glb" else None
    unit, unit_sure = (guess.unit, 1.0) if guess.unit else ("m", 1.0) if guess.size else _unit(edges, category)
    fitting = [way for way in WAYS if guess.up in (None, way[0]) and guess.front in (None, way[1])]
    if not fitting:
        raise AssetError(f"up {guess.up!r} and front {guess.front!r} must be different axes.")
    if category.group == "unknown":
        up = guess.up or ("+y" if standard or fits_y_up(edges, guess.size or category.size) else "+z")
        front = guess.front or ("+z" if up[1] == "y" else "+x")
        up_sure, front_sure = float(bool(guess.up or standard)), float(bool(guess.front))
    else:
        points = sampled((piece.vertices, piece.faces) for piece in pieces)
        up, front, up_sure, front_sure = stands(points, category, standard, fitting)
    sure = {"unit": unit_sure, "up": up_sure, "front": front_sure}
    return replace(guess, unit=unit, up=up, front=front, sure=sure)


def _unit(edges: Size, category: Category) -> tuple[str, float]:
    """Return the unit in which the mesh's size is most plausible for its category, and how sure that is."""
    longest = max(edges)
    if longest <= 0.0:
        raise AssetError("the mesh has no extent; export it again.")
    if category.group == "unknown":
        fits = [unit for unit, factor in UNITS.items() if PLAUSIBLE[0] <= longest * factor <= PLAUSIBLE[1]]
        return (fits[0], 1.0 / len(fits)) if fits else ("m", 0.0)
    own = sorted(edges)[1:]
    typical = sorted(category.size)[1:]

    def misfit(factor: float) -> float:
        return sum(abs(math.log(max(a, 1e-9) * factor / b)) for a, b in zip(own, typical, strict=True)) / 2

    misfits = {unit: misfit(factor) for unit, factor in UNITS.items()}
    best = min(misfits, key=lambda unit: misfits[unit])
    best = best if misfits[best] < misfits["m"] - CLEARLY else "m"
    if misfits[best] > CLEARLY:
        return SCALED, 0.0
    return best, round(1.0 - misfits[best] / CLEARLY, 2)


def _guess(path: Path) -> FileGuess:
    """Collect the words about a mesh: objathor's data.json, a JSON file beside it, else its file and folder names."""
    beside = path.with_name("data.json")
    if os.path.isfile(beside) and path.stem == path.parent.name:
        return _objathor(path, _json(beside))
    words = _words(path.stem) or _words(path.parent.name)
    sidecar = path.with_suffix(".json")
    if not os.path.isfile(sidecar):
        return FileGuess(words or "asset", words, {})
    category, description, flags = _said(_json(sidecar), sidecar.name)
    return FileGuess(category or words or "asset", description or words, flags)


def _said(data: Mapping[str, object], where: str) -> tuple[str, str, dict[str, bool]]:
    """Return category, description and placement flags of a metadata file; empty where it says nothing."""
    category = _CHECK.text(data.get("category") or "", f"{where}: category", most=200)
    description = _CHECK.text(data.get("description") or "", f"{where}: description")
    return category, description, {key: _CHECK.flag(data[key], f"{where}: {key}") for key in FLAGS if key in data}


def _words(name: str) -> str:
    """Return the words of a file name, without numbers and hashes."""
    if re.fullmatch(r"[0-9a-fA-F\-]{12,}", name):
        return ""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name)
    return " ".join(word for word in re.split(r"[\W\d_]+", spaced) if len(word) > 1)


def _json(path: Path) -> Mapping[str, Any]:
    """Read a metadata file within bounds."""
    what = f"metadata {path.parent.name}/{path.name}"
    read = _CHECK.parse(lambda file: json_value(decoded(regular_bytes(file, LIMITS.folder_json))), path, what)
    return _CHECK.mapping(read, what)


def _objathor(path: Path, data: Mapping[str, Any]) -> FileGuess:
    """Read LayoutVLM's and objathor's metadata; there bounding-box x is the width and y the depth.

    Where `frontView` says that the front is a quarter turn away, width and depth change places.
    """
    where = f"{path.parent.name}/data.json"
    notes = _CHECK.inner(data, "annotations", where)
    across, along, height = (
        _CHECK.number(edge, f"{where}: assetMetadata.boundingBox.{key}", above=0.0, most=LIMITS.largest_side)
        for key, edge in zip("xyz", _CHECK.bounding_box(data, where), strict=True)
    )
    turns = _CHECK.number(notes.get("frontView", 0), f"{where}: annotations.frontView", least=0.0, most=1000.0)
    view = VIEWS[int(turns) % 4]
    size = (along, across, height) if view[1] == "z" else (across, along, height)
    _CHECK.required(notes, "category", f"{where}: annotations")
    text, words, flags = _said(notes, f"{where}: annotations")
    return FileGuess(text, words, flags, size, up="+y", front=view)
