"""Scene state JSON, which SceneEval loads (format `scene@1.0.2`, from its scene_state_template.json and GUIDE.md).

SceneEval places each object's mesh by a column-major 4 x 4 matrix; meshes are glTF files, y up with the front along +z.
Model ids are `robolayout.<name>`, the name escaped where no file may have it.
`write_meshes` writes the meshes in the folder form of its LayoutVLM data set
(`<name>/<name>.glb`, `<name>/data.json`), so a data set entry with the prefix "robolayout" and that folder as its root
is all that SceneEval needs.
"""

from __future__ import annotations

import hashlib
import math
from pathlib import Path
from typing import cast
from urllib.parse import quote

from robolayout._errors import LayoutError
from robolayout._files import write_atomic
from robolayout._reading.syntax import decoded, json_value
from robolayout.export._exporter import (
    Contents,
    Exporter,
    Json,
    Options,
    dump_json,
    facts,
    is_movable,
    placed,
    reader,
    supporter,
)
from robolayout.export._rugs import laid_parts
from robolayout.export.glb import asset_glb
from robolayout.scene import Layout, Opening, Pose, Room, Scene

PREFIX = "robolayout"
ROOM = "room"
LONGEST_NAME = 120
"""Characters of a file's name, beyond which an asset's name is shortened."""
THICKNESS = 0.1
"""Thickness of walls in metres, as in the files that SceneEval ships."""


def write(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the scene state of a layout."""
    rows = placed(scene, layout)
    index = {asset.name: i for i, (asset, _) in enumerate(rows)}
    objects: list[Json] = []
    for asset, pose in rows:
        parent = supporter(asset, scene, layout)
        objects.append(
            {
                "id": asset.name,
                "index": index[asset.name],
                "modelId": f"{PREFIX}.{_file_name(asset.name)}",
                "parentId": parent or "",
                "parentIndex": -1 if parent is None else index[parent],
                "transform": {"rows": 4, "cols": 4, "data": _matrix(pose)},
                "metadata": facts(asset, movable=is_movable(asset, scene, layout)),
            }
        )
    return dump_json(
        {
            "format": "sceneState",
            "scene": {
                "version": "scene@1.0.2",
                "id": scene.name,
                "up": [0, 0, 1],
                "front": [0, 1, 0],
                "unit": 1.0,
                "assetSource": [PREFIX],
                "arch": _architecture(scene.room),
                "object": objects,
            },
            "selected": [],
        }
    )


def _file_name(name: str) -> str:
    """Return an asset's name as that of a file: as it is, unless it has a slash or the like, then escaped as in addresses."""
    escaped = quote(name, safe=" ").replace(".", "%2E") if not name.strip(".") else quote(name, safe=" ")
    return (
        escaped if len(escaped) <= LONGEST_NAME else f"{escaped[:80]}-{hashlib.sha256(name.encode()).hexdigest()[:16]}"
    )


def _matrix(pose: Pose) -> list[float]:
    """Return the column-major matrix from a mesh (front +z, up +y) to the world (yaw 0 faces +x, z up)."""
    cosine, sine = pose.forward
    left, up, front = (-sine, cosine, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (cosine, sine, 0.0, 0.0)
    return [*left, *up, *front, pose.x, pose.y, pose.z, 1.0]


def _architecture(room: Room) -> Json:
    """Return floor and walls with their holes; a hole is a rectangle along its wall and up from the floor."""
    floor: Json = {
        "id": f"{ROOM}|floor",
        "roomId": ROOM,
        "type": "Floor",
        "depth": 0.05,
        "points": [[x, y, 0.0] for x, y in room.vertices],
    }
    walls: list[Json] = []
    for wall in room.walls:
        holes = [("Door", door) for door in room.doors if door.wall == wall.index]
        holes += [("Window", window) for window in room.windows if window.wall == wall.index]
        walls.append(
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
    return {
        "version": "arch@1.0.2",
        "id": "robolayout-arch",
        "up": [0, 0, 1],
        "front": [0, 1, 0],
        "coords2d": [0, 1],
        "scaleToMeters": 1.0,
        "defaults": {"Wall": {"depth": THICKNESS, "extraHeight": 0.0}, "Floor": {"depth": 0.05}},
        "elements": [floor, *walls],
        "regions": [{"id": ROOM, "type": "Other", "walls": [wall["id"] for wall in walls]}],
    }


def _hole(kind: str, number: int, opening: Opening) -> Json:
    """Return one door or window."""
    low, high = [opening.offset, opening.sill], [opening.offset + opening.width, opening.sill + opening.height]
    return {"id": f"{kind.lower()}-{opening.wall}-{number}", "type": kind, "box": {"min": low, "max": high}}


def write_meshes(scene: Scene, folder: Path, layout: Layout | None = None, *, seed: int = 0) -> Path:
    """Write every asset's mesh and description below a folder, as SceneEval looks for them below a data set's root.

    Args:
        scene: The scene.
        folder: The folder.
        layout: Where everything stands: rugs are cut out around what stands through them.
        seed: Seed of the parametric meshes.

    Returns:
        The folder.
    """
    for asset in scene.assets:
        depth, width, height = asset.size
        notes: Json = {"category": asset.category, "description": asset.description, "materials": []}
        notes |= {"onFloor": asset.on_floor, "onWall": asset.on_wall, "onCeiling": asset.on_ceiling}
        box: Json = {"boundingBox": {"x": width, "y": depth, "z": height}}
        content: Json = {"annotations": {**notes, "onObject": asset.on_object}, "assetMetadata": box}
        name = _file_name(asset.name)
        write_atomic(
            folder / name / f"{name}.glb", asset_glb(asset, laid_parts(asset, scene, layout or Layout({}), seed=seed))
        )
        write_atomic(folder / name / "data.json", dump_json(content))
    return folder


@reader("scene state")
def read(data: bytes) -> Contents:
    """Return the names, poses and sizes in a scene state that this package wrote."""
    content = cast(Json, json_value(decoded(data)))
    if content.get("format") != "sceneState":
        raise LayoutError(f'a scene state says "format": "sceneState", this one {content.get("format")!r}.')
    poses: dict[str, Pose] = {}
    sizes: dict[str, tuple[float, float, float]] = {}
    for entry in cast(list[Json], cast(Json, content["scene"])["object"]):
        m = cast(list[float], cast(Json, entry["transform"])["data"])
        name = str(entry["id"])
        poses[name] = Pose(m[12], m[13], m[14], math.atan2(m[9], m[8]))
        depth, width, height = cast(list[float], cast(Json, entry["metadata"])["size"])
        sizes[name] = (depth, width, height)
    return Contents(Layout(poses), sizes)


SCENEEVAL = Exporter("sceneeval", ".sceneeval.json", "scene state JSON, which SceneEval loads", None, write, read)
