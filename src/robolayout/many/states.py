"""Scene states, as SceneEval loads them, read as a scene and a layout: whoever wrote them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, cast

from robolayout._errors import InputError
from robolayout.assets import find_category
from robolayout.assets.folder import FLAGS
from robolayout.scene import Layout, Pose, Scene, scene_from_dict
from robolayout.scene.reference import look_up

FORMAT = "sceneState"  # what such a file says in "format"

_ASTRAY = (ArithmeticError, AttributeError, LookupError, TypeError, ValueError)
"""What is tripped over in a file of another form."""

Json = Mapping[str, Any]


def read_state(data: Json, name: str, asset_dir: Path | None = None) -> tuple[Scene, Layout]:
    """Return what a scene state of one room holds; sizes that it does not give are looked up in a folder (`<id>/data.json`)."""
    try:
        return _read(data, name, asset_dir)
    except _ASTRAY as error:
        raise InputError(f"the scene state {name!r} has another form than scene@1.0.2 ({error}).") from None


def _read(data: Json, name: str, asset_dir: Path | None) -> tuple[Scene, Layout]:
    state = data["scene"]
    elements = state["arch"]["elements"]
    floors = [element for element in elements if element["type"] == "Floor"]
    if len(floors) != 1:
        raise InputError(f"the scene state {name!r} has {len(floors)} floors; one room at a time is evaluated.")
    floor = [(float(point[0]), float(point[1])) for point in floors[0]["points"]]
    walls = [element for element in elements if element["type"] == "Wall"]
    content: dict[str, Any] = {
        "boundary": {
            "floor_vertices": [[x, y, 0.0] for x, y in floor],
            "wall_height": max((float(wall["height"]) for wall in walls), default=2.6),
        }
    }
    for kind in ("Door", "Window"):
        content[f"{kind.lower()}s"] = [
            _opening(hole["box"], wall["points"], floor)
            for wall in walls
            for hole in wall.get("holes", ())
            if hole["type"] == kind
        ]
    assets: dict[str, Any] = {}
    poses: dict[str, Pose] = {}
    for thing in state["object"]:
        matrix = [float(value) for value in thing["transform"]["data"]]
        scales = [math.hypot(*matrix[4 * axis : 4 * axis + 3]) for axis in (2, 0, 1)]  # depth, width, height
        key = str(thing.get("id") or thing["index"])
        assets[key] = _asset(thing, scales, asset_dir)
        poses[key] = Pose(matrix[12], matrix[13], matrix[14], math.atan2(matrix[9], matrix[8]))
    scene = scene_from_dict({**content, "assets": assets}, name=name, asset_dir=asset_dir)
    return scene, Layout(poses)


def _asset(thing: Json, scales: Sequence[float], asset_dir: Path | None) -> dict[str, Any]:
    """Return one thing as a scene file gives it."""
    told = cast("dict[str, Any]", thing.get("metadata") or {})
    uid = str(thing["modelId"]).partition(".")[2]
    if "size" in told:
        size, entry = told["size"], {"category": told.get("category", uid)}
    elif asset_dir is not None:
        (_, found) = look_up([f"{uid}-0"], asset_dir)[f"{uid}-0"]
        entry = dict(found)
        box = cast("Any", entry["assetMetadata"])["boundingBox"]
        size = [box[axis] for axis in "xyz"]
    else:
        raise InputError(f"{thing['modelId']!r} has no size in its metadata; name the folder of assets (--asset-dir).")
    kind = find_category(str(entry["category"]), size=(size[0], size[1], size[2]))
    box = {axis: side * scale for axis, side, scale in zip("xyz", size, scales, strict=True)}
    flags = {key: getattr(kind, name) for key, name in FLAGS.items()}
    return {**flags, **entry, "assetMetadata": {"boundingBox": box}}


def _opening(box: Json, points: Sequence[Sequence[float]], floor: Sequence[tuple[float, float]]) -> dict[str, Any]:
    """Return a hole of a wall as an opening of the nearest side of the floor."""
    (low, sill), (high, top) = box["min"], box["max"]
    (ax, ay), (bx, by) = (point[:2] for point in points)
    length = math.dist((ax, ay), (bx, by))
    along = (low + high) / 2 / length
    middle = (ax + (bx - ax) * along, ay + (by - ay) * along)
    sides = list(zip(floor, [*floor[1:], floor[0]], strict=True))
    number = min(range(len(sides)), key=lambda i: _apart(middle, *sides[i])[0])
    offset = _apart(middle, *sides[number])[1] - (high - low) / 2
    return {"wall": number, "offset": max(offset, 0.0), "width": high - low, "height": top - sill, "sill": sill}


def _apart(point: tuple[float, float], start: tuple[float, float], end: tuple[float, float]) -> tuple[float, float]:
    """Return how far a point is from a side, and how far along it."""
    length = math.dist(start, end)
    dx, dy = (end[0] - start[0]) / length, (end[1] - start[1]) / length
    along = (point[0] - start[0]) * dx + (point[1] - start[1]) * dy
    held = min(max(along, 0.0), length)
    return math.dist(point, (start[0] + dx * held, start[1] + dy * held)), along
