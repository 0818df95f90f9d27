"""House JSON, which AI2-THOR's `CreateHouse` loads (schema 1.0.0, that of ProcTHOR-10k).

Unity is y up and left-handed: our (x, y, z) is its (x, z, y), and a yaw counter-clockwise from +x is a rotation
clockwise from +z, that is 90 degrees minus the yaw. Every asset becomes the THOR asset of the same type that is nearest in
size, on the same floor, thing or wall; `metadata.robolayout.assets` says which one, and how far its box is from the asked one.
What THOR has no type for, rugs and ceiling lamps among it, is left out and has no id there; lights shine where the lamps hang. A
wall of THOR holds one door or window, so walls with more are cut into pieces. The table of THOR's 1,653 assets (names, types,
boxes) is `data/thor_assets.csv`, derived from the PyPI package procthor (Allen Institute for AI, Apache License 2.0).
"""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from typing import Any, cast

from robolayout._errors import LayoutError
from robolayout._reading.syntax import decoded, json_value
from robolayout.assets import parts
from robolayout.constraints import supporter
from robolayout.export._exporter import (
    Exporter,
    Json,
    Options,
    Rows,
    data_file,
    dump_json,
    is_movable,
    placed,
    reader,
)
from robolayout.export._scenery import lamp
from robolayout.export.mjcf import start
from robolayout.scene import Asset, Layout, Opening, Pose, Room, Scene, Wall

ROOM = "room|2"  # rooms of THOR are numbered from 2; 1 is outside
AGENT_HEIGHT = 0.95  # height in metres of the middle of THOR's default agent

ROOM_TYPES = {"kitchen": "Kitchen", "bath": "Bathroom", "bed": "Bedroom"}  # by words; all others are living rooms
WALL_MATERIAL, OUTSIDE_MATERIAL = "PureWhite", "BrownDrywall"

Hole = tuple[str, int, Opening]  # kind ("door", "window"), number and opening
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
    return list(csv.DictReader(line for line in data_file(name).splitlines() if not line.startswith("#")))


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
    return _nearest_of(kind, asset.size)


def _kept(asset: Asset) -> str:
    """Return what is kept of an asset's height in THOR: its bottom where it stands, else its middle."""
    return "bottom" if asset.on_floor or asset.on_object else "middle"


def _rise(asset: Asset, size: Size) -> float:
    """Return how far up its middle moves in metres where an asset takes the size of THOR's."""
    return (size[2] - asset.size[2]) / 2 if _kept(asset) == "bottom" else 0.0


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
            poses[asset.name] = replace(pose, z=pose.z + _rise(asset, assets[-1].size))
    return replace(scene, assets=tuple(assets)), Layout(poses)


def _nearest_of(kind: str, size: Size) -> ThorAsset:
    """Return the asset of a type whose box is nearest in size; ties go to the first by name."""
    return min(catalogue()[kind], key=lambda asset: (asset.distance(size), asset.name))


def write(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the house of a layout."""
    pieces = [piece for wall in scene.room.walls for piece in _cut(scene.room, wall)]
    inside = [_wall(scene.room, index, piece, outside=False) for index, piece in enumerate(pieces)]
    outside = [_wall(scene.room, index, piece, outside=True) for index, piece in enumerate(pieces)]
    covers: dict[str, list[Json]] = {"door": [], "window": []}
    for index, (_, _, end, hole) in enumerate(pieces):
        if hole is not None:
            covers[hole[0]].append(_cover(index, end, *hole))
    house: dict[str, Any] = json.loads(data_file("house.json"))
    house["objects"], assets = _objects(scene, layout)
    first = house["metadata"]["agent"] | _pose(replace(start(scene, Options()), z=AGENT_HEIGHT))
    house["metadata"] |= {"agent": first, "agentPoses": dict.fromkeys(house["metadata"]["agentPoses"], first)}
    house["metadata"]["robolayout"] = {"scene": scene.name, "assets": assets, "leftOut": list(options.left_out)}
    house["proceduralParameters"]["lights"] = list(_lights(scene, layout, *house["proceduralParameters"]["lights"]))
    words = f"{scene.name} {scene.task_description}".lower()
    house["rooms"][0] |= {
        "roomType": next((kind for word, kind in ROOM_TYPES.items() if word in words), "LivingRoom"),
        "floorPolygon": [_vector(x, y, 0.0) for x, y in reversed(scene.room.vertices)],  # clockwise in plan
    }
    return dump_json(house | {"doors": covers["door"], "walls": inside + outside, "windows": covers["window"]})


def _lights(scene: Scene, layout: Layout, sun: Json, bulb: Json) -> Iterator[Json]:
    """Yield a soft sun, and a light like `bulb` where our lamps hang (without any, under the ceiling's middle)."""
    yield sun
    low_x, low_y, high_x, high_y = scene.room.bounds
    spots = [layout[a.name] for a in scene.assets if a.name in layout and a.on_ceiling and lamp(parts(a))]
    spots = spots or [Pose((low_x + high_x) / 2, (low_y + high_y) / 2, scene.room.wall_height - 0.2, 0.0)]
    for number, spot in enumerate(spots, 2):
        place = {"id": f"light_{number}", "position": _vector(spot.x, spot.y, spot.z)}
        yield {**bulb, **place, "intensity": 0.75 / len(spots)}


def _vector(x: float, y: float, z: float) -> Json:
    """Return a Unity vector from our coordinates."""
    return {"x": x + 0.0, "y": z + 0.0, "z": y + 0.0}


Piece = tuple[Wall, float, float, Hole | None]
"""A wall, the metres along it where the piece starts and ends, and the hole in it."""


def _cut(room: Room, wall: Wall) -> list[Piece]:
    """Return a wall in pieces with at most one hole each, cut half-way between the holes."""
    holes = [("door", i, door) for i, door in enumerate(room.doors) if door.wall == wall.index]
    holes += [("window", i, window) for i, window in enumerate(room.windows) if window.wall == wall.index]
    holes.sort(key=lambda hole: hole[2].offset)
    between = ((a.offset + a.width + b.offset) / 2 for (_, _, a), (_, _, b) in pairwise(holes))
    cuts = pairwise([0.0, *between, wall.length])
    return [(wall, start, end, hole) for (start, end), hole in zip(cuts, holes or [None], strict=True)]


def _wall_id(index: int, *, outside: bool) -> str:
    return f"wall|exterior|{index}" if outside else f"wall|2|{index}"


def _wall(room: Room, index: int, piece: Piece, *, outside: bool) -> Json:
    """Return one face of a wall; seen from the room its lower corners run clockwise in plan, ours counter-clockwise."""
    wall, start, end, _ = piece
    low, high = wall.point(end), wall.point(start)
    corners = [(low, 0.0), (high, 0.0), (low, room.wall_height), (high, room.wall_height)]
    if outside:
        corners.reverse()
    return {
        "id": _wall_id(index, outside=outside),
        "material": {"name": OUTSIDE_MATERIAL if outside else WALL_MATERIAL},
        "polygon": [_vector(x, y, z) for (x, y), z in corners],
        "roomId": "exterior" if outside else ROOM,
    }


def _cover(index: int, end: float, kind: str, number: int, opening: Opening) -> Json:
    """Return a door or window: the nearest THOR asset, scaled to the hole, placed along its wall from the wall's first corner."""
    thor = _nearest_of("Doorway" if kind == "door" else "Window", (0.1, opening.width, opening.height))
    near, top = end - opening.offset - opening.width, opening.sill + opening.height
    cover: Json = {
        "id": f"{kind}|1|2|{number}",
        "assetId": thor.name,
        "room0": ROOM,
        "room1": ROOM,
        "wall0": _wall_id(index, outside=False),
        "wall1": _wall_id(index, outside=True),
        "holePolygon": [{"x": near, "y": opening.sill, "z": 0.0}, {"x": near + opening.width, "y": top, "z": 0.0}],
        "assetPosition": {"x": near + opening.width / 2, "y": opening.sill + opening.height / 2, "z": 0.0},
        "scale": {"x": opening.width / thor.size[1], "y": opening.height / thor.size[2], "z": 1.0},
    }
    return {**cover, "openable": False, "openness": 0.0} if kind == "door" else cover


def _objects(scene: Scene, layout: Layout) -> tuple[list[Json], dict[str, Json]]:
    """Return the objects, those on others as their children, and what is known about each of our assets."""
    objects: dict[str, Json] = {}
    assets: dict[str, Json] = {}
    for number, (asset, pose) in enumerate(placed(scene, layout)):
        thor = nearest(asset)
        assets[asset.name] = {"category": asset.category, "size": list(asset.size), **_pose(pose)}
        if thor is None:
            assets[asset.name]["id"] = None
            continue
        objects[asset.name] = {
            "assetId": thor.name,
            "id": f"{thor.type}|2|{number}",
            "kinematic": not is_movable(asset, scene, layout),
            **_pose(replace(pose, z=pose.z + _rise(asset, thor.size))),
            "room": ROOM,
            "children": [],
        }
        assets[asset.name] |= {
            "id": objects[asset.name]["id"],
            "thorSize": list(thor.size),
            "sizeDistance": round(thor.distance(asset.size), 4),
            "anchor": _kept(asset),
        }
    roots: list[Json] = []
    for name, entry in objects.items():
        parent = supporter(scene.by_name[name], scene, layout)
        children = cast(list[Json], objects[parent]["children"]) if parent in objects else roots
        children.append(entry)
    return roots, assets


def _pose(pose: Pose) -> Json:
    """Return a Unity position and rotation."""
    turn = (90.0 - math.degrees(pose.yaw)) % 360.0
    return {"position": _vector(pose.x, pose.y, pose.z), "rotation": {"x": 0.0, "y": turn, "z": 0.0}}


@reader("house")
def read(data: bytes) -> Rows:
    """Yield our names, poses and sizes in a house that this package wrote."""
    house: Any = json_value(decoded(data))
    notes = house.get("metadata", {}).get("robolayout", {})
    if "assets" not in notes:
        raise LayoutError("this house was not written by robolayout: it has no metadata.robolayout.assets.")
    objects = {str(entry["id"]): entry for entry in _flat(house["objects"])}
    for name, note in notes["assets"].items():
        entry = note if note["id"] is None else objects[str(note["id"])]
        size = note["size"]
        grown = note.get("thorSize", size)[2] - size[2]
        shift = grown / 2 if note.get("anchor") == "bottom" else 0.0
        at, yaw = entry["position"], math.radians(90.0 - entry["rotation"]["y"])
        yield name, Pose(at["x"], at["z"], at["y"] - shift, yaw), size


def _flat(objects: list[Any]) -> list[Any]:
    return [each for entry in objects for each in (entry, *_flat(entry["children"]))]


PROCTHOR = Exporter(
    "procthor", ".procthor.json", "AI2-THOR house JSON with the nearest THOR assets", None, write, read, fit=as_in_thor
)
