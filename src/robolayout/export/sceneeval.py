"""Scene state JSON, which SceneEval loads (format `scene@1.0.2`, from its scene_state_template.json and GUIDE.md).

SceneEval places each object's mesh by a column-major 4 x 4 matrix; meshes are glTF files, y up with the front along +z.
Model ids are `robolayout.<kind>`, one for all things that are alike. Their meshes lie beside the state in the folder form of
its LayoutVLM data set (`sceneeval/<kind>/<kind>.glb`, `data.json`), so a data set entry with the prefix "robolayout" and that
folder as its root is all that SceneEval needs. It takes whatever touches for a collision, and tells a touch by moving the
later of two things away: rugs have holes where furniture stands, and come first.
"""

from __future__ import annotations

import json
import math
from dataclasses import replace
from typing import Any, cast

from robolayout._errors import LayoutError
from robolayout._reading.syntax import decoded, json_value
from robolayout.assets import Part
from robolayout.constraints import hangs, supporter
from robolayout.export._exporter import (
    Bundle,
    Exporter,
    Json,
    Options,
    Rows,
    data_file,
    dump_json,
    facts,
    is_movable,
    kind_name,
    placed,
    reader,
)
from robolayout.export._rugs import laid_parts
from robolayout.export.glb import asset_glb
from robolayout.scene import Asset, Layout, Opening, Pose, Room, Scene

PREFIX = "robolayout"
ROOM = "room"
FOLDER = "sceneeval"  # folder of the meshes, beside the scene state
THICKNESS = 0.1  # thickness of walls in metres, as in the files that SceneEval ships


def make(scene: Scene, layout: Layout, options: Options) -> Bundle:
    """Return the scene state of a layout, and mesh and description of every kind of thing, below a data set's root."""
    rows = sorted(placed(scene, layout), key=lambda row: not row[0].is_flat)
    index = {asset.name: i for i, (asset, _) in enumerate(rows)}
    objects: list[Json] = []
    files: dict[str, bytes] = {}
    for asset, pose in rows:
        pieces = laid_parts(asset, scene, layout, seed=options.seed)
        kind = kind_name(asset.category, pieces, asset.description, asset.size)  # without a dot in it
        files |= {} if f"{FOLDER}/{kind}/data.json" in files else _described(asset, kind, pieces)
        parent = supporter(asset, scene, layout)
        held = ""
        if parent is None and hangs(asset, scene, layout):
            wall = min(scene.room.walls, key=lambda wall: wall.distance((pose.x, pose.y)))
            held = f"{ROOM}|wall|{wall.index}" if asset.on_wall else f"{ROOM}|ceiling"
        entry: Json = {"id": asset.name, "index": index[asset.name], "modelId": f"{PREFIX}.{kind}"}
        entry |= {"parentId": parent or held, "parentIndex": -1 if parent is None else index[parent]}
        entry["transform"] = {"rows": 4, "cols": 4, "data": _matrix(pose)}
        entry["metadata"] = facts(asset, movable=is_movable(asset, scene, layout))
        objects.append(entry)
    state: dict[str, Any] = json.loads(data_file("scene_state.json"))
    state["scene"] |= {"id": scene.name, "object": objects}
    _build(state["scene"]["arch"], scene.room)
    return dump_json(state), files


def _matrix(pose: Pose) -> list[float]:
    """Return the column-major matrix from a mesh (front +z, up +y) to the world (yaw 0 faces +x, z up)."""
    cosine, sine = pose.forward
    left, up, front = (-sine, cosine, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (cosine, sine, 0.0, 0.0)
    return [*left, *up, *front, pose.x, pose.y, pose.z, 1.0]


def _build(arch: dict[str, Any], room: Room) -> None:
    """Add floor and walls with their holes; a hole is a rectangle along its wall and up from the floor."""
    arch["elements"][0]["points"] = [[x, y, 0.0] for x, y in room.vertices]
    for wall in room.walls:
        holes = [("Door", door) for door in room.doors if door.wall == wall.index]
        holes += [("Window", window) for window in room.windows if window.wall == wall.index]
        arch["elements"].append(
            {
                "id": f"{ROOM}|wall|{wall.index}",
                "roomId": ROOM,
                "type": "Wall",
                "height": room.wall_height,
                "depth": THICKNESS,
                "points": [[*wall.start, 0.0], [*wall.end, 0.0]],
                "holes": [_hole(kind, number, opening) for number, (kind, opening) in enumerate(holes)],
            }
        )
    arch["regions"][0]["walls"] = [element["id"] for element in arch["elements"][1:]]


def _hole(kind: str, number: int, opening: Opening) -> Json:
    """Return one door or window."""
    low, high = [opening.offset, opening.sill], [opening.offset + opening.width, opening.sill + opening.height]
    return {"id": f"{kind.lower()}-{opening.wall}-{number}", "type": kind, "box": {"min": low, "max": high}}


def _described(asset: Asset, kind: str, pieces: tuple[Part, ...]) -> dict[str, bytes]:
    """Return the mesh and the description of a kind of thing, as SceneEval looks for them."""
    depth, width, height = asset.size
    notes: Json = {"category": asset.category, "description": asset.description, "materials": []}
    notes |= {"onFloor": asset.on_floor, "onWall": asset.on_wall, "onCeiling": asset.on_ceiling}
    box: Json = {"boundingBox": {"x": width, "y": depth, "z": height}}
    content: Json = {"annotations": {**notes, "onObject": asset.on_object}, "assetMetadata": box}
    mesh = asset_glb(replace(asset, name=kind), pieces)
    return {f"{FOLDER}/{kind}/{kind}.glb": mesh, f"{FOLDER}/{kind}/data.json": dump_json(content)}


@reader("scene state")
def read(data: bytes) -> Rows:
    """Yield the names, poses and sizes in a scene state that this package wrote."""
    content = cast(Json, json_value(decoded(data)))
    if content.get("format") != "sceneState":
        raise LayoutError(f'a scene state says "format": "sceneState", this one {content.get("format")!r}.')
    for entry in cast(list[Json], cast(Json, content["scene"])["object"]):
        m = cast(list[float], cast(Json, entry["transform"])["data"])
        size = cast(list[float], cast(Json, entry["metadata"])["size"])
        yield str(entry["id"]), Pose(m[12], m[13], m[14], math.atan2(m[9], m[8])), size


SCENEEVAL = Exporter(
    "sceneeval", ".sceneeval.json", "scene state JSON and meshes, which SceneEval loads", None, make, read
)
