"""The reference's scene files: uids looked up in a folder of assets."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from robolayout._errors import AssetError, InputError, SceneError
from robolayout.scene import Scene, load_scene, scene_from_dict, scene_to_dict
from robolayout.scene._asset_io import look_up

DESK, CHAIR, SEAT, LAMP = "0a1b", "fe-77", "c3", "d4"


def put(folder: Path, uid: str, category: str, box: tuple[float, float, float], **flags: object) -> None:
    """Write one asset folder as the reference has it: boundingBox x is the width, y the depth."""
    (folder / uid).mkdir(parents=True)
    x, y, z = box
    annotations = {"category": category, "description": f"a {category}", "frontView": 3, **(flags or {"onFloor": True})}
    data = {"annotations": annotations, "assetMetadata": {"boundingBox": {"x": x, "y": y, "z": z}, "assetId": uid}}
    (folder / uid / "data.json").write_text(json.dumps(data))
    (folder / uid / f"{uid}.glb").write_bytes(b"glTF")


@pytest.fixture
def assets(tmp_path: Path) -> Path:
    folder = tmp_path / "assets"
    put(folder, DESK, "desk", (1.4, 0.7, 0.75))
    put(folder, CHAIR, "chair", (0.5, 0.55, 0.9))
    put(folder, SEAT, "Chair", (0.6, 0.65, 1.1))
    put(folder, LAMP, "desk lamp", (0.2, 0.25, 0.4), onFloor=False, onObject=True, onWall=False, onCeiling=False)
    return folder


def scene_file(*keys: str) -> dict[str, Any]:
    return {
        "task_description": "an office",
        "boundary": {"floor_vertices": [[0, 0, 0], [4, 0, 0], [4, 5, 0], [0, 5, 0]], "wall_height": 2.6},
        "assets": {key: {} for key in keys},
    }


KEYS = (f"{DESK}-0", f"{CHAIR}-0", f"{CHAIR}-1", f"{SEAT}-0", f"{LAMP}-0")


def read(tmp_path: Path, assets: Path, *keys: str) -> Scene:
    path = tmp_path / "office.json"
    path.write_text(json.dumps(scene_file(*keys)))
    return load_scene(path, asset_dir=assets)


def test_assets_are_looked_up_and_their_boxes_swapped(tmp_path: Path, assets: Path) -> None:
    scene = read(tmp_path, assets, *KEYS)
    assert [asset.name for asset in scene.assets] == ["desk-0", "chair_A-0", "chair_A-1", "chair_B-0", "desk_lamp-0"]
    desk, _, _, seat, lamp = scene.assets
    assert desk.size == (0.7, 1.4, 0.75)
    assert (desk.category, desk.description, desk.on_floor) == ("desk", "a desk", True)
    assert desk.metadata == {"uid": DESK, "frontView": 3}
    assert desk.path == assets / DESK / f"{DESK}.glb"
    assert seat.size == (0.65, 0.6, 1.1)
    assert (lamp.on_floor, lamp.on_object) == (False, True)
    assert scene.warnings == ()


def test_the_normalised_scene_reads_back(tmp_path: Path, assets: Path) -> None:
    scene = read(tmp_path, assets, *KEYS)
    assert scene_from_dict(scene_to_dict(scene), name="office", asset_dir=assets) == scene


def test_one_uid_keeps_the_plain_name(tmp_path: Path, assets: Path) -> None:
    scene = read(tmp_path, assets, f"{CHAIR}-3", f"{CHAIR}-5")
    assert [asset.name for asset in scene.assets] == ["chair-0", "chair-1"]


def test_own_keys_come_first_and_plain_assets_may_stand_beside(tmp_path: Path, assets: Path) -> None:
    data = scene_file(f"{CHAIR}-0")
    data["assets"][f"{CHAIR}-0"] = {"useSides": ["left"], "description": "mine"}
    data["assets"]["rug-0"] = {"onFloor": True, "assetMetadata": {"boundingBox": {"x": 2, "y": 1, "z": 0.01}}}
    chair, rug = scene_from_dict(data, asset_dir=assets).assets
    assert (chair.use_sides, chair.description, chair.category) == (("left",), "mine", "chair")
    assert rug.size == (2, 1, 0.01)


def test_a_missing_mesh_leaves_the_built_in_shape(tmp_path: Path, assets: Path) -> None:
    (assets / DESK / f"{DESK}.glb").unlink()
    assert read(tmp_path, assets, f"{DESK}-0").assets[0].path is None


def test_more_than_26_of_a_category(tmp_path: Path) -> None:
    for i in range(28):
        put(tmp_path, f"u{i}", "chair", (0.5, 0.5, 0.9))
    names = [name for name, _ in look_up([f"u{i}-0" for i in range(28)], tmp_path).values()]
    assert (names[0], names[25], names[26], names[27]) == ("chair_A-0", "chair_Z-0", "chair_AA-0", "chair_AB-0")


def test_a_missing_uid_is_named(tmp_path: Path, assets: Path) -> None:
    with pytest.raises(
        AssetError, match=r"asset 'nope' is missing: there is no .*nope/data\.json; check --asset-dir\."
    ):
        read(tmp_path, assets, *KEYS, "nope-0")


def test_a_missing_folder_is_named(tmp_path: Path) -> None:
    with pytest.raises(AssetError, match=r"asset folder .*nowhere does not exist or is no folder; check --asset-dir\."):
        read(tmp_path, tmp_path / "nowhere", *KEYS)
    with pytest.raises(SceneError, match=r"asset '0a1b-0' has no assetMetadata: give its boundingBox .*--asset-dir"):
        scene_from_dict(scene_file(*KEYS))


@pytest.mark.parametrize("uid", ["..", ".", "", "../assets", "/etc", "a/b", "link", "x\0y", "x" * 300, "\ud800"])
def test_a_uid_is_a_folder_inside(tmp_path: Path, assets: Path, uid: str) -> None:
    outside = tmp_path / "outside"
    put(outside, "u", "bomb", (1, 1, 1))
    (assets / "link").symlink_to(outside / "u")
    with pytest.raises(InputError, match=r"is not the name of a folder inside|is missing"):
        look_up([f"{uid}-0"], assets)


@pytest.mark.parametrize(
    ("data", "message"),
    [
        ([], "u/data.json must be an object with named values, but is []."),
        ({}, 'u/data.json has no "annotations"; add it.'),
        ({"annotations": {}}, 'u/data.json: annotations has no "category"; add it.'),
        ({"annotations": {"category": 5}}, "u/data.json: category must be a text, but is 5."),
        ({"annotations": {"category": "x"}}, 'u/data.json has no "assetMetadata"; add it.'),
        (
            {"annotations": {"category": "x"}, "assetMetadata": {"boundingBox": {"x": 1, "y": 1}}},
            'u/data.json: assetMetadata.boundingBox has no "z"; add it.',
        ),
    ],
)
def test_wrong_asset_files(tmp_path: Path, data: object, message: str) -> None:
    (tmp_path / "u").mkdir()
    (tmp_path / "u" / "data.json").write_text(json.dumps(data))
    with pytest.raises(AssetError) as caught:
        look_up(["u-0"], tmp_path)
    assert str(caught.value) == message


def test_a_bad_size_names_the_asset(tmp_path: Path) -> None:
    put(tmp_path, "u", "chair", (0.5, -1, 0.9))
    with pytest.raises(SceneError, match=r"asset 'chair-0': depth \(boundingBox\.x\) must be above 0, but is -1"):
        scene_from_dict(scene_file("u-0"), asset_dir=tmp_path)
