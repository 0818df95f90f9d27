"""Scene state JSON, checked against what SceneEval's own loader does with it.

Its loader (scenes/scene_state.py, architecture.py, trimesh_scene.py, MIT): demands "format": "sceneState" and version scene@1.0.2;
sorts elements into Floor, Ceiling, Wall; loads `<root>/<id>/<id>.glb` as one mesh in glTF's frame and applies
`reshape(data, 4, 4).T`; cuts holes from the wall's first point on, min and max as (along, up).
"""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest
import shapely
import trimesh

import robolayout as rl
from robolayout._errors import LayoutError
from robolayout.assets import CATALOGUE, parts
from robolayout.export import Options, export, sceneeval
from robolayout.export._rugs import laid_parts
from robolayout.export.glb import document
from robolayout.scene import Asset, Layout, Pose, Room, Scene

NEEDED = "bpy, python-fcl, omegaconf, mapbox_earcut, pydantic and trimesh"
BALLS = {"ball", "exercise ball"}
"""They touch by a point, which holds nothing by its rule."""


@pytest.fixture(scope="module")
def state(scene: Scene, layout: Layout) -> dict[str, object]:
    return json.loads(sceneeval.SCENEEVAL.write(scene, layout, Options()))


def test_it_is_the_format_that_the_loader_demands(state: dict, scene: Scene) -> None:
    assert state["format"] == "sceneState"
    assert state["scene"]["version"] == "scene@1.0.2"
    assert state["scene"]["arch"]["version"] == "arch@1.0.2"
    kinds = [element["type"] for element in state["scene"]["arch"]["elements"]]
    assert set(kinds) <= {"Floor", "Ceiling", "Wall"}
    assert (kinds.count("Floor"), kinds.count("Wall")) == (1, len(scene.room.walls))
    for entry in state["scene"]["object"]:
        assert {"index", "modelId", "transform"} <= set(entry)
        assert len(entry["transform"]["data"]) == 16
    assert [entry["index"] for entry in state["scene"]["object"]] == list(range(9))


def test_walls_run_on_and_holes_are_along_them(state: dict, scene: Scene) -> None:
    walls = [element for element in state["scene"]["arch"]["elements"] if element["type"] == "Wall"]
    for wall, after in zip(walls, walls[1:] + walls[:1], strict=True):
        assert wall["points"][1] == after["points"][0]
        assert wall["height"] == scene.room.wall_height
    holes = {hole["type"]: hole["box"] for hole in walls[0]["holes"]}
    assert holes["Door"] == {"min": [3.6, 0.0], "max": [4.5, 2.05]}
    assert holes["Window"] == {"min": [1.0, 0.9], "max": [2.2, 2.1]}
    assert len(walls[1]["holes"]) == 1


@pytest.fixture
def written(scene: Scene, layout: Layout, tmp_path: Path) -> Path:
    """A scene state with its meshes beside it."""
    return export(scene, layout, "sceneeval", folder=tmp_path)


def test_meshes_land_where_the_layout_says_facing_as_it_says(written: Path, scene: Scene, layout: Layout) -> None:
    for entry in json.loads(written.read_text())["scene"]["object"]:
        prefix, kind = entry["modelId"].split(".")  # as it does
        mesh = trimesh.load(written.parent / "sceneeval" / kind / f"{kind}.glb", force="mesh")
        mesh.apply_transform(np.asarray(entry["transform"]["data"]).reshape(4, 4).T)
        name = entry["id"]
        pose, size = layout[name], scene.by_name[name].size
        corners = np.array(pose.corners(size))
        low = pose.z - size[2] / 2
        assert prefix == "robolayout"
        assert np.allclose(mesh.bounds[:, 2], [low, low + size[2]], atol=1e-5)
        assert (mesh.bounds[0, :2] >= corners.min(axis=0) - 1e-5).all()
        assert (mesh.bounds[1, :2] <= corners.max(axis=0) + 1e-5).all()
        matrix = np.asarray(entry["transform"]["data"]).reshape(4, 4).T
        assert np.allclose(matrix[:3, :3] @ [0, 0, 1], [*pose.forward, 0])
        assert np.allclose(matrix[:3, :3] @ [0, 1, 0], [0, 0, 1])
        assert np.linalg.det(matrix[:3, :3]) == pytest.approx(1)


def test_a_mesh_is_one_node_that_nothing_turns(written: Path) -> None:
    for path in written.parent.rglob("*.glb"):
        (node,) = document(path.read_bytes())["nodes"]
        assert "mesh" in node and not {"rotation", "matrix", "children"} & set(node)


def test_descriptions_lie_where_its_layoutvlm_data_set_looks(written: Path, scene: Scene, state: dict) -> None:
    kind = next(e["modelId"] for e in state["scene"]["object"] if e["id"] == "double_bed-0").partition(".")[2]
    notes = json.loads((written.parent / "sceneeval" / kind / "data.json").read_text())
    assert {"category", "description", "materials"} <= set(notes["annotations"])
    assert notes["annotations"]["description"] == scene.by_name["double_bed-0"].description
    assert notes["assetMetadata"]["boundingBox"] == {"x": 1.6, "y": 2.0, "z": 0.9}


@pytest.mark.slow
def test_its_own_code_finds_everything_upright_held_and_apart(tmp_path: Path) -> None:
    home, python = os.environ.get("ROBOLAYOUT_SCENEEVAL", ""), os.environ.get("ROBOLAYOUT_BLENDER_PYTHON", "")
    if not (home and python):
        pytest.skip(
            "set ROBOLAYOUT_SCENEEVAL to a clone of it and ROBOLAYOUT_BLENDER_PYTHON to a Python with " + NEEDED
        )
    result = rl.generate(Path(__file__).parents[2] / "examples" / "bedroom.json")
    path = export(result.scene, result.layout, "sceneeval", folder=tmp_path)
    judge, out = Path(__file__).with_name("sceneeval_judge.py"), tmp_path / "out.json"
    told = [python, str(judge), str(path.parent / "sceneeval"), str(out), str(path)]
    subprocess.run(told, cwd=home, env={**os.environ, "PYTHONPATH": home}, check=True, capture_output=True)
    found = json.loads(out.read_text())[path.name]
    assert found["trimesh"].keys() == set(result.layout)
    for name, bounds in found["trimesh"].items():
        assert np.allclose(bounds, found["blender"][name], atol=1e-5), name
    assert not any(found["collisions"].values())
    assert all(found["supported"].values())


def test_tops_name_what_they_stand_on(state: dict) -> None:
    parents = {entry["id"]: entry["parentId"] for entry in state["scene"]["object"]}
    assert parents["table_lamp-0"] == "night_stand-0"
    held = {name: parent for name, parent in parents.items() if parent and name != "table_lamp-0"}
    assert held["ceiling_lamp-0"] == "room|ceiling"
    assert all(parent.startswith("room|wall|") for name, parent in held.items() if name != "ceiling_lamp-0")


def test_rugs_come_first(state: dict, scene: Scene) -> None:
    assert scene.by_name[state["scene"]["object"][0]["id"]].is_flat


def test_other_json_is_refused() -> None:
    with pytest.raises(LayoutError, match="a scene state says"):
        sceneeval.read(b'{"format": "else"}')


@pytest.mark.parametrize("own", [False, True])
def test_rugs_are_cut_out_around_what_stands_through_them(own: bool, tmp_path: Path) -> None:
    trimesh.creation.box((1.6, 2.2, 0.012)).export(tmp_path / "rug.obj")
    rug = Asset("rug-0", "rug", (1.6, 2.2, 0.012), path=tmp_path / "rug.obj" if own else None)
    table = Asset("dining_table-0", "dining table", (0.9, 1.6, 0.75))
    scene = Scene(Room(((0, 0), (5, 0), (5, 4), (0, 4)), 2.6), (rug, table))
    for turn in (0.0, 0.4):
        layout = Layout({"rug-0": Pose(2.5, 2, 0.006, turn), "dining_table-0": Pose(2.7, 2.1, 0.375, 0.2)})
        found = trimesh.collision.CollisionManager()
        for asset in scene.assets:
            pieces = laid_parts(asset, scene, layout)
            mesh = trimesh.util.concatenate([trimesh.Trimesh(p.vertices, p.faces, process=False) for p in pieces])
            if asset.path is None:
                assert all(trimesh.Trimesh(p.vertices, p.faces).is_watertight for p in pieces)
            else:
                assert mesh.area == pytest.approx(2 * 1.6 * 2.2, rel=0.05), "no more than the holes and edges is gone"
            place = trimesh.transformations.rotation_matrix(layout[asset.name].yaw, (0, 0, 1))
            place[:3, 3] = (layout[asset.name].x, layout[asset.name].y, layout[asset.name].z)
            found.add_object(asset.name, mesh, place)
            assert np.ptp(mesh.vertices, axis=0) == pytest.approx(asset.size)
        assert not found.in_collision_internal()


def test_a_rug_of_which_nothing_would_be_left_stays_whole() -> None:
    mat, chest = Asset("rug-0", "rug", (0.4, 0.6, 0.012)), Asset("chest-0", "chest", (0.8, 1.2, 0.5))
    scene = Scene(Room(((0, 0), (5, 0), (5, 4), (0, 4)), 2.6), (mat, chest))
    layout = Layout({"rug-0": Pose(2.5, 2, 0.006, 0.0), "chest-0": Pose(2.5, 2, 0.25, 0.0)})
    whole = laid_parts(mat, scene, Layout({}))
    assert len(whole) and len(laid_parts(mat, scene, layout)) == len(whole)


@pytest.mark.parametrize("name", sorted({n for n, k in CATALOGUE.items() if k.on_floor or k.on_object} - BALLS))
def test_by_its_rule_the_middle_of_what_is_seen_is_over_the_foot(name: str) -> None:
    made = parts(Asset("thing-0", name, CATALOGUE[name].size))
    mesh = trimesh.util.concatenate([trimesh.Trimesh(p.vertices, p.faces, process=False) for p in made])
    foot = mesh.vertices[mesh.vertices[:, 2] < mesh.bounds[0, 2] + 0.01, :2]
    assert shapely.MultiPoint(foot).convex_hull.covers(shapely.Point(mesh.centroid[:2]))
