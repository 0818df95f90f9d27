"""Rooms found in a folder, whoever made them: a scene and a layout each, in the forms that docs/many.md lists."""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, cast

from robolayout._errors import InputError
from robolayout._reading import Checker
from robolayout._reading.syntax import ASTRAY
from robolayout.assets import find_category
from robolayout.many.room import NOTE
from robolayout.run.result import Result, judge, load_judged
from robolayout.scene import FLAGS, Agent, Layout, Pose, Room, Scene, load_layout, load_scene, scene_from_dict
from robolayout.scene._asset_io import look_up

_CHECK = Checker(InputError)
FORMAT = "sceneState"  # what such a file says in "format"
DRAWN = ("source", "style", "dress", "solver", "reach", "seed")  # what a batch drew for a room

Json = Mapping[str, Any]


@dataclass(frozen=True)
class Found:
    """A room that was found."""

    name: str  # where, from the folder that was looked through; rooms of two folders are paired by it
    layout: Path  # its layout file, scene state or run folder
    scene: Path | None = None  # its scene file; None where the layout brings the scene along
    facts: dict[str, Any] = field(default_factory=dict[str, Any])  # what a batch says of it

    def judged(self, agents: Sequence[Agent], asset_dir: Path | None) -> Result:
        """Return the room judged, for other bodies than its own if any are given."""

        def read(file: str | Path) -> Scene:
            scene = load_scene(file, asset_dir)
            return scene.with_agents(*agents) if agents else scene

        if self.layout.is_dir():
            return load_judged(self.layout, None, read)
        if self.scene is not None:
            scene = read(self.scene)
            return judge(scene, load_layout(self.layout, scene))
        state = _CHECK.mapping(_CHECK.read_json(self.layout, "scene state"), f"scene state {self.layout}")
        try:
            scene, layout = _read(state, self.layout.stem, asset_dir)
        except ASTRAY as error:
            raise InputError(
                f"the scene state {self.layout.stem!r} has another form than scene@1.0.2 ({error})."
            ) from None
        return judge(scene.with_agents(*agents) if agents else scene, layout)


def find_rooms(folder: Path, scenes: Path | None = None) -> list[Found]:
    """Return all rooms below a folder, by name; `scenes` is a folder of scene files whose layouts are in folders of their names."""
    for place in (place for place in (folder, scenes) if place is not None and not place.is_dir()):
        raise InputError(f"{place} is no folder; name one with scenes and layouts in it.")
    found = [room for here, names, files in os.walk(folder) for room in _here(Path(here), names, files, scenes)]
    if not found:
        raise InputError(
            f"{folder} holds no room: neither scene.json with layout.json, nor X.json with X.layout.json, nor a scene state"
            + ("." if scenes else "; name the folder of the scene files with --scenes if they are elsewhere.")
        )
    named: list[Found] = []
    for room in found:
        path = room.layout if room.layout.name != "layout.json" else room.layout.parent
        name = path.relative_to(folder).as_posix()
        for end in (".sceneeval.json", ".layout.json", "_layout.json", ".json"):
            name = name.removesuffix(end)
        named.append(replace(room, name=name if name != "." else folder.resolve().name))
    return sorted(named, key=lambda room: room.name)


def _here(here: Path, names: list[str], files: Sequence[str], scenes: Path | None) -> Iterator[Found]:
    """Yield the rooms of one folder."""
    if "scene.json" in files and "layout.json" in files:
        note, facts = here / NOTE, dict[str, Any]()
        if os.path.isfile(note):
            said = _CHECK.mapping(_CHECK.read_json(note, "room"), f"room {note}")
            row = cast("dict[str, Any]", said.get("row", {}))
            facts = {key: row[key] for key in DRAWN if row.get(key) not in (None, "")}
        yield Found("", here, None, facts)
        return
    if scenes is not None and "layout.json" in files and os.path.isfile(scenes / f"{here.name}.json"):
        yield Found("", here / "layout.json", scenes / f"{here.name}.json")
    for file in sorted(files):
        path = here / file
        if not file.endswith(".json") or file.endswith("layout.json"):
            continue
        places = (f"{path.stem}.layout.json", f"{path.stem}_layout.json", f"{path.stem}/layout.json")
        layout = next((here / place for place in places if os.path.isfile(here / place)), None)
        if layout is not None:
            yield Found("", layout, path)
            names[:] = [name for name in names if here / name != layout.parent]
            continue
        with path.open("rb") as opened:
            if f'"{FORMAT}"'.encode() in opened.read(200):
                yield Found("", path)


def _read(data: Json, name: str, asset_dir: Path | None) -> tuple[Scene, Layout]:
    """Return what a scene state of one room holds; sizes that it does not give are looked up in a folder (`<id>/data.json`)."""
    state = data["scene"]
    elements = state["arch"]["elements"]
    floors = [element for element in elements if element["type"] == "Floor"]
    if len(floors) != 1:
        raise InputError(f"the scene state {name!r} has {len(floors)} floors; one room at a time is evaluated.")
    walls = [element for element in elements if element["type"] == "Wall"]
    height = max((float(wall["height"]) for wall in walls), default=2.6)
    room = Room(tuple((float(point[0]), float(point[1])) for point in floors[0]["points"]), height)
    content: dict[str, Any] = {
        "boundary": {"floor_vertices": [[x, y, 0.0] for x, y in room.vertices], "wall_height": height}
    }
    holes = [(hole["type"], hole["box"], wall["points"]) for wall in walls for hole in wall.get("holes", ())]
    for kind in ("Door", "Window"):
        content[f"{kind.lower()}s"] = [_opening(box, points, room) for known, box, points in holes if known == kind]
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


def _opening(box: Json, points: Sequence[Sequence[float]], room: Room) -> dict[str, Any]:
    """Return a hole of a wall as an opening of the nearest side of the floor."""
    (low, sill), (high, top) = box["min"], box["max"]
    (ax, ay), (bx, by) = (point[:2] for point in points)
    along = (low + high) / 2 / math.dist((ax, ay), (bx, by))
    middle = (ax + (bx - ax) * along, ay + (by - ay) * along)
    side = min(room.walls, key=lambda wall: wall.distance(middle))
    offset = side.place(middle)[0] - (high - low) / 2
    return {"wall": side.index, "offset": max(offset, 0.0), "width": high - low, "height": top - sill, "sill": sill}
