"""A scene that takes its assets from a catalogue file, and what is said where it cannot."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import robolayout as rl
from robolayout._errors import SceneError
from robolayout.scene.io import scene_to_dict
from running import Ran

TETRAHEDRON = "v 0 0 0\nv 0.6 0 0\nv 0 0.6 0\nv 0 0 0.9\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n"
ROOM = {"boundary": {"floor_vertices": [[0, 0, 0], [4, 0, 0], [4, 3, 0], [0, 3, 0]], "wall_height": 2.5}}
CHAIR = {"category": "chair", "onFloor": True, "assetMetadata": {"boundingBox": {"x": 0.5, "y": 0.5, "z": 0.9}}}


def written(folder: Path, scene: dict[str, Any], catalogue: object = None) -> Path:
    """Write a scene beside a catalogue."""
    (folder / "own.json").write_text(json.dumps(catalogue or {"assets": {"oak_chair-0": CHAIR}}))
    (folder / "room.json").write_text(json.dumps(ROOM | scene))
    return folder / "room.json"


def test_entries_come_from_the_catalogue_and_the_scene_has_the_last_word(tmp_path: Path) -> None:
    assets = {
        "chair-0": {"from": "oak_chair-0"},
        "chair-1": {"from": "oak_chair-0", "description": "with arms"},
        "oak_chair-0": {},
    }
    scene = rl.load_scene(written(tmp_path, {"catalogue": "own.json", "assets": assets}))
    assert [asset.size for asset in scene.assets] == [(0.5, 0.5, 0.9)] * 3
    assert [asset.description for asset in scene.assets] == ["", "with arms", ""]
    assert not scene.warnings and not any(asset.metadata.get("from") for asset in scene.assets)
    assert rl.scene_from_dict(scene_to_dict(scene), name="room").assets == scene.assets


def test_an_imported_folder_furnishes_a_scene_beside_its_catalogue(
    tmp_path: Path, command: Callable[..., Ran], monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "meshes" / "new").mkdir(parents=True)
    (tmp_path / "meshes" / "new" / "chair.obj").write_text(TETRAHEDRON)
    monkeypatch.chdir(tmp_path)
    assert command("assets", "import", "meshes").code == 0
    scene = {"catalogue": "catalogue.json", "assets": {"chair-0": {"from": "chair-0"}}}
    path = written(tmp_path, scene)
    (asset,) = rl.load_scene(path).assets
    assert asset.path == (tmp_path / "meshes" / "new" / "chair.obj").resolve()
    assert asset.size == pytest.approx((0.6, 0.6, 0.9))
    (tmp_path / "else").mkdir()
    elsewhere = written(tmp_path / "else", scene)
    assert rl.load_scene(elsewhere, asset_dir=tmp_path).assets == (asset,)


@pytest.mark.parametrize(
    ("scene", "answer"),
    [
        ({"assets": {"chair-0": {"from": "oak_chair-0"}}}, "is taken from a catalogue, but the scene names none"),
        ({"catalogue": "other.json", "assets": {"chair-0": {}}}, "catalogue 'other.json' is no file in the scene"),
        ({"catalogue": "../own.json", "assets": {"chair-0": {}}}, "catalogue '../own.json' is no file in the scene"),
        (
            {"catalogue": "own\0.json", "assets": {"chair-0": {}}},
            "has a null character, which no text has, at catalogue.",
        ),
        ({"catalogue": 3, "assets": {"chair-0": {}}}, "catalogue must be a text, but is 3"),
        (
            {"catalogue": "own.json", "assets": {"chair-0": {"from": "oak_chair"}}},
            "own.json has no 'oak_chair'. Did you mean 'oak_chair-0'? It has: oak_chair-0.",
        ),
        ({"catalogue": "own.json", "assets": {"chair-0": {"from": 3}}}, "asset 'chair-0': from must be a text"),
        ({"catalogue": "own.json", "assets": {"chair-0": {}}}, "asset 'chair-0' has no assetMetadata"),
    ],
)
def test_what_cannot_be_looked_up_is_said(tmp_path: Path, scene: dict[str, Any], answer: str) -> None:
    (tmp_path / "own.json").write_text("{}")
    (tmp_path / "room").mkdir()
    with pytest.raises(SceneError) as caught:
        rl.load_scene(written(tmp_path / "room", scene))
    assert answer in str(caught.value)


@pytest.mark.parametrize(
    ("catalogue", "answer"),
    [
        ({"assets": []}, "own.json: assets must be an object"),
        ({"skipped": []}, 'catalogue own.json has no "assets"'),
        ({"assets": {"oak_chair-0": 7}}, "own.json: 'oak_chair-0' must be an object"),
        ({"assets": {"oak_chair-0": CHAIR | {"path": "../../etc/x.obj"}}}, "lies outside the scene file's folder"),
    ],
)
def test_a_hostile_catalogue_is_refused(tmp_path: Path, catalogue: object, answer: str) -> None:
    scene = {"catalogue": "own.json", "assets": {"chair-0": {"from": "oak_chair-0"}}}
    with pytest.raises(SceneError) as caught:
        rl.load_scene(written(tmp_path, scene, catalogue))
    assert answer in str(caught.value)
