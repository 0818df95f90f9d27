"""House JSON, checked against the published format (ProcTHOR-10k, schema 1.0.0, and AI2-THOR's ProceduralData)."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import pytest

from robolayout.assets import CATALOGUE
from robolayout.export import Options, procthor
from robolayout.export.procthor import as_in_thor, catalogue, nearest, thor_type
from robolayout.scene import Asset, Layout, Opening, Pose, Room, Scene


@pytest.fixture(scope="module")
def house(scene: Scene, layout: Layout) -> dict:
    return json.loads(procthor.PROCTHOR.write(scene, layout, Options()))


def flat(objects: list[dict]) -> list[dict]:
    return [each for entry in objects for each in (entry, *flat(entry.get("children", [])))]


def turning(points: list[dict]) -> float:
    """Return the signed area in plan; negative for clockwise rings, seen with x to the right and z up."""
    ring = zip(points, points[1:] + points[:1], strict=True)
    return sum(a["x"] * b["z"] - b["x"] * a["z"] for a, b in ring) / 2


def test_it_has_the_sections_of_a_house(house: dict) -> None:
    assert set(house) == {"doors", "metadata", "objects", "proceduralParameters", "rooms", "walls", "windows"}
    assert house["metadata"]["schema"] == "1.0.0"
    assert set(house["metadata"]["agentPoses"]) == {"default", "arm", "locobot", "stretch"}
    assert {
        "ceilingMaterial",
        "lights",
        "skyboxId",
        "floorColliderThickness",
        "receptacleHeight",
        "reflections",
    } <= set(house["proceduralParameters"])


def test_every_asset_exists_in_thor(house: dict) -> None:
    known = {asset.name for assets in catalogue().values() for asset in assets}
    assert {entry["assetId"] for entry in flat(house["objects"])} <= known
    assert {cover["assetId"] for cover in house["doors"]} <= {asset.name for asset in catalogue()["Doorway"]}
    assert {cover["assetId"] for cover in house["windows"]} <= {asset.name for asset in catalogue()["Window"]}


def test_floor_and_walls_run_clockwise_in_plan_as_in_the_published_houses(house: dict) -> None:
    floor = house["rooms"][0]["floorPolygon"]
    assert turning(floor) == pytest.approx(-(5 * 3.5 + 2 * 0.5))
    inside = [wall for wall in house["walls"] if wall["roomId"] == "room|2"]
    outside = [wall for wall in house["walls"] if wall["roomId"] == "exterior"]
    assert turning([wall["polygon"][0] for wall in reversed(inside)]) == pytest.approx(turning(floor))
    for here, there in zip(inside, outside, strict=True):
        assert there["polygon"] == here["polygon"][::-1]
        low, top = here["polygon"][:2], here["polygon"][2:]
        assert [corner["y"] for corner in low + top] == [0, 0, 2.6, 2.6]
        assert all((a["x"], a["z"]) == (b["x"], b["z"]) for a, b in zip(low, top, strict=True))


def test_no_wall_has_two_holes_and_each_is_inside_its_wall(house: dict) -> None:
    covers = house["doors"] + house["windows"]
    walls = {wall["id"]: wall for wall in house["walls"]}
    assert len({cover["wall0"] for cover in covers}) == len(covers) == 3
    for cover in covers:
        start, end = walls[cover["wall0"]]["polygon"][:2]
        length = math.dist((start["x"], start["z"]), (end["x"], end["z"]))
        low, high = cover["holePolygon"]
        assert 0 <= low["x"] < high["x"] <= length
        assert cover["assetPosition"]["x"] == pytest.approx((low["x"] + high["x"]) / 2)
        assert walls[cover["wall1"]]["roomId"] == "exterior"


def test_the_door_is_where_it_is_in_our_room(house: dict, scene: Scene) -> None:
    (door,) = house["doors"]
    (wall,) = [wall for wall in house["walls"] if wall["id"] == door["wall0"]]
    start, end = wall["polygon"][:2]
    length = math.dist((start["x"], start["z"]), (end["x"], end["z"]))
    along = door["assetPosition"]["x"] / length
    x, z = (start[k] + along * (end[k] - start[k]) for k in ("x", "z"))
    assert (x, z) == pytest.approx(scene.room.walls[0].point(scene.room.doors[0].center))
    assert door["holePolygon"][1]["x"] - door["holePolygon"][0]["x"] == pytest.approx(0.9)


def test_fronts_and_places_are_kept(house: dict, scene: Scene, layout: Layout) -> None:
    objects = {entry["id"]: entry for entry in flat(house["objects"])}
    for name, note in house["metadata"]["robolayout"]["assets"].items():
        entry, pose = objects.get(note["id"], note), layout[name]
        turn = math.radians(entry["rotation"]["y"])
        assert (math.sin(turn), math.cos(turn)) == pytest.approx(pose.forward, abs=1e-9)
        assert (entry["position"]["x"], entry["position"]["z"]) == (pose.x, pose.y)
        if note["id"] and (scene.by_name[name].on_floor or scene.by_name[name].on_object):
            bottom = entry["position"]["y"] - note["thorSize"][2] / 2
            assert bottom == pytest.approx(pose.z - note["size"][2] / 2)


def test_rugs_and_ceiling_lamps_are_left_out_and_named_and_lamps_shine(house: dict, layout: Layout) -> None:
    notes = house["metadata"]["robolayout"]["assets"]
    left = {name for name, note in notes.items() if note["id"] is None}
    assert left == {"ceiling_lamp-0", "rug-0", "wardrobe-0"}
    assert len(flat(house["objects"])) == len(layout) - len(left)
    (lamp,) = [light for light in house["proceduralParameters"]["lights"] if light["type"] == "point"]
    pose = layout["ceiling_lamp-0"]
    assert lamp["position"] == {"x": pose.x, "y": pose.z, "z": pose.y}


def test_what_stands_on_something_is_its_child(house: dict) -> None:
    children = {
        entry["id"].split("|")[0]: [c["id"].split("|")[0] for c in entry["children"]] for entry in house["objects"]
    }
    assert children["SideTable"] == ["DeskLamp"]
    assert sum(map(len, children.values())) == 1


def test_distances_are_reported(house: dict) -> None:
    notes = house["metadata"]["robolayout"]["assets"]
    for note in (note for note in notes.values() if note["id"]):
        largest = max(abs(a - b) for a, b in zip(note["size"], note["thorSize"], strict=True))
        assert note["sizeDistance"] == pytest.approx(largest, abs=1e-4)
    assert notes["double_bed-0"]["sizeDistance"] < 0.3


@pytest.mark.parametrize("category", ["bathtub", "printer", "wardrobe", "pool table", "wall shelf", "monitor", "oven"])
def test_what_is_not_the_same_is_left_out(category: str) -> None:
    assert nearest(Asset("a-0", category, (0.7, 1.7, 0.6))) is None


def test_a_room_as_thor_has_it_keeps_where_things_stand(scene: Scene, layout: Layout) -> None:
    printer = Asset("printer-0", "printer", (0.4, 0.5, 0.3))
    room, there = as_in_thor(
        replace(scene, assets=(*scene.assets, printer)), Layout({**layout, "printer-0": Pose(1, 1, 0.15, 0)})
    )
    assert set(layout) - {"wardrobe-0"} == set(there) == set(room.by_name)
    for name, asset in room.by_name.items():
        thor = nearest(scene.by_name[name])
        assert asset.size == (thor.size if thor else scene.by_name[name].size)
        if thor and asset.on_floor:
            assert there[name].z - asset.size[2] / 2 == pytest.approx(layout[name].z - scene.by_name[name].size[2] / 2)
    house = json.loads(procthor.PROCTHOR.write(room, there, Options(left_out=("printer-0",))))
    notes = house["metadata"]["robolayout"]
    assert notes["leftOut"] == ["printer-0"]
    assert all(note["sizeDistance"] == 0 for note in notes["assets"].values() if note["id"])


def test_the_nearest_of_the_type_is_taken() -> None:
    for size in ((2.0, 1.6, 0.9), (2.1, 0.9, 0.5)):
        found = nearest(Asset("bed-0", "bed", size))
        assert found.type == "Bed"
        assert all(found.distance(size) <= other.distance(size) for other in catalogue()["Bed"])


@pytest.mark.parametrize(
    ("category", "kind"),
    [("office chair", "Chair"), ("desk lamp", "DeskLamp"), ("Night-Stand", "SideTable"), ("round dining table", "DiningTable"),
     ("rug", None), ("spaceship", None)],
)  # fmt: skip
def test_words_lead_to_types(category: str, kind: str | None) -> None:
    assert thor_type(category) == kind


def test_the_tables_are_sound() -> None:
    assert sum(map(len, catalogue().values())) == 1653
    assert len(catalogue()) == 109
    assert all(min(asset.size) > 0 for assets in catalogue().values() for asset in assets)
    kinds = {thor_type(name) for name in CATALOGUE} - {None}
    assert kinds <= set(catalogue())
    assert len(kinds) > 40


def test_a_room_without_doors_starts_the_agent_in_the_middle() -> None:
    room = Room(((0, 0), (4, 0), (4, 2), (0, 2)), 2.5, (), (Opening(1, 0.5, 1.0, 1.0, 0.9),))
    house = json.loads(procthor.PROCTHOR.write(Scene(room, (), name="kitchen"), Layout({}), Options()))
    assert house["metadata"]["agent"]["position"] == {"x": 2.0, "y": 0.95, "z": 1.0}
    assert house["rooms"][0]["roomType"] == "Kitchen"
    assert house["doors"] == []
