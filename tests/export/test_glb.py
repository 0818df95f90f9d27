"""GLB: what Khronos' validator and an independent loader say about it."""

from __future__ import annotations

import json
import math
import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh
from benchmarks import browser

from robolayout._errors import AssetError
from robolayout.assets import Material, Part, parts
from robolayout.export import Options, export
from robolayout.export._mesh import as_box, linear, quaternion, surface, volume, welded
from robolayout.export.glb import GLB, asset_glb, document
from robolayout.scene import Asset, Layout, Pose, Room, Scene

TOOLS = Path(__file__).parents[1] / "tools"
OAK = Material("oak", (0.6, 0.4, 0.2))


def validated(*paths: Path) -> dict[str, dict[str, object]]:
    """Run Khronos' validator; without it, skip - or fail where it is demanded, as `make test` does."""
    node = shutil.which("node")
    if node is None or not (TOOLS / "node_modules" / "gltf-validator").is_dir():
        if os.environ.get("ROBOLAYOUT_NODE_TOOLS") == "1":
            pytest.fail("gltf-validator is not installed: npm --prefix tests/tools install")
        pytest.skip("needs node and gltf-validator: npm --prefix tests/tools install")
    done = subprocess.run(
        [node, str(TOOLS / "validate_gltf.mjs"), *map(str, paths)], capture_output=True, text=True, check=False
    )
    return json.loads(done.stdout)


def cylinder(sides: int = 24) -> Part:
    mesh = trimesh.creation.cylinder(radius=0.1, height=0.4, sections=sides)
    return Part("can", np.asarray(mesh.vertices), np.asarray(mesh.faces, np.int32), OAK)


def box(angle: float = 0.3, extents: tuple[float, float, float] = (0.2, 0.3, 0.4)) -> Part:
    mesh = trimesh.creation.box(extents, transform=trimesh.transformations.rotation_matrix(angle, (1, 2, 3)))
    return Part("box", np.asarray(mesh.vertices), np.asarray(mesh.faces, np.int32), OAK)


def test_khronos_finds_no_error_and_no_warning(scene: Scene, layout: Layout, tmp_path: Path) -> None:
    routes = {"double_bed-0": [(4.0, 0.5), (2.6, 1.0)]}
    paths = [
        export(scene, layout, tmp_path / "room.glb", options=Options(routes=routes)),
        export(Scene(scene.room, ()), Layout({}), tmp_path / "empty.glb"),
    ]
    for asset in scene.assets[:3]:
        paths.append(tmp_path / f"{asset.name}.glb")
        paths[-1].write_bytes(asset_glb(asset, parts(asset)))
    for path, result in validated(*paths).items():
        assert (result["errors"], result["warnings"]) == (0, 0), (path, result["messages"])


def test_an_independent_loader_finds_every_asset_in_its_place(scene: Scene, layout: Layout, tmp_path: Path) -> None:
    loaded = trimesh.load_scene(export(scene, layout, tmp_path / "room.glb"))
    y_up = trimesh.transformations.rotation_matrix(math.pi / 2, (1, 0, 0))
    for name, pose in layout.items():
        nodes = [node for node in loaded.graph.nodes_geometry if node.startswith(f"{name}.")]
        points = []
        for node in nodes:
            transform, geometry = loaded.graph[node]
            points.append(trimesh.transform_points(loaded.geometry[geometry].vertices, y_up @ transform))
        turn = trimesh.transformations.rotation_matrix(-pose.yaw, (0, 0, 1))[:3, :3]
        local = (np.vstack(points) - [pose.x, pose.y, pose.z]) @ turn.T
        assert np.allclose(np.ptp(local, axis=0), scene.by_name[name].size, atol=1e-5)
        assert np.allclose(local.max(axis=0), np.array(scene.by_name[name].size) / 2, atol=1e-5)


def test_nodes_carry_what_is_known(scene: Scene, layout: Layout) -> None:
    content = document(GLB.write(scene, layout, Options(routes={"wardrobe-0": [(4.0, 0.5), (4.0, 2.0)]})))
    nodes = {node["name"]: node for node in content["nodes"]}
    assert {name: nodes[name]["extras"]["movable"] for name in ("dining_chair-0", "picture-0", "rug-0")} == {
        "dining_chair-0": True,
        "picture-0": False,
        "rug-0": False,
    }
    assert nodes["double_bed-0"]["extras"]["description"] == scene.assets[0].description
    root = content["nodes"][content["scenes"][0]["nodes"][0]]
    assert root["rotation"] == [-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)]
    assert root["extras"]["routes"] == {"wardrobe-0": [[4.0, 0.5], [4.0, 2.0]]}
    assert len(root["children"]) == 2 + len(layout)  # the room and a camera


def test_lamps_give_light(scene: Scene, layout: Layout) -> None:
    content = document(GLB.write(scene, layout, Options()))
    lights = [node["name"] for node in content["nodes"] if "KHR_lights_punctual" in node.get("extensions", {})]
    lamps = [asset.name for asset in scene.assets if "lamp" in asset.category and asset.name in layout]
    assert lights == [f"{name}.light" for name in lamps]
    assert lights


def test_textures_come_once_and_only_where_they_are_used(scene: Scene, layout: Layout) -> None:
    content = document(GLB.write(scene, layout, Options()))
    used = [m["pbrMetallicRoughness"].get("baseColorTexture", {}).get("index") for m in content["materials"]]
    assert set(used) - {None} == set(range(len(content["textures"])))
    assert len(content["textures"]) == len(content["images"]) > 2
    for mesh in content["meshes"]:
        (primitive,) = mesh["primitives"]
        assert ("TEXCOORD_0" in primitive["attributes"]) == (used[primitive["material"]] is not None)


def test_equal_assets_share_their_meshes() -> None:
    room = Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.5)
    chairs = tuple(Asset(f"chair-{i}", "chair", (0.5, 0.45, 0.9)) for i in range(4))
    one = GLB.write(Scene(room, chairs[:1]), Layout({"chair-0": Pose(1, 1, 0.45, 0)}), Options())
    four = GLB.write(
        Scene(room, chairs), Layout({c.name: Pose(i, 1, 0.45, 0) for i, c in enumerate(chairs)}), Options()
    )
    assert len(document(four)["meshes"]) == len(document(one)["meshes"])


def test_colours_are_linear() -> None:
    assert linear((0.0, 1.0, 0.5)) == pytest.approx((0.0, 1.0, 0.21404114), abs=1e-6)
    assert linear((0.04045, 0.04, 0.2))[0] == pytest.approx(0.0031308, abs=1e-6)


def test_glass_is_blended(scene: Scene, layout: Layout) -> None:
    for material in document(GLB.write(scene, layout, Options()))["materials"]:
        opacity = material["pbrMetallicRoughness"]["baseColorFactor"][3]
        assert (material.get("alphaMode") == "BLEND") == (opacity < 1)


def test_a_box_has_flat_faces_and_a_cylinder_a_smooth_side() -> None:
    flat = surface(box(0.0))
    assert len(flat.positions) == 24
    assert np.allclose(np.abs(flat.normals).max(axis=1), 1)
    can = surface(cylinder())
    side = np.abs(can.normals[:, 2]) < 0.5
    radial = can.positions[side, :2] / np.linalg.norm(can.positions[side, :2], axis=1, keepdims=True)
    assert np.allclose(can.normals[side, :2], radial, atol=1e-6)
    assert side.sum() == 48


def test_normals_point_outwards_and_are_unit() -> None:
    for part in (box(), cylinder()):
        shape = surface(part)
        assert np.allclose(np.linalg.norm(shape.normals, axis=1), 1)
        assert (np.einsum("ij,ij->i", shape.normals, shape.positions) > 0).all()


def test_faces_without_area_are_dropped() -> None:
    part = box(0.0)
    broken = Part("box", part.vertices, np.vstack([part.faces, [[0, 0, 1], [2, 2, 2]]]).astype(np.int32), OAK)
    assert len(welded(broken).indices) == 12


@pytest.mark.parametrize("angle", [0.0, 0.3, 2.0])
def test_boxes_are_recognised(angle: float) -> None:
    found = as_box(box(angle))
    assert found is not None
    assert sorted(2 * found.half) == pytest.approx([0.2, 0.3, 0.4])
    assert np.linalg.det(found.rotation) == pytest.approx(1.0)
    corners = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T * found.half
    again = corners @ found.rotation.T + found.center
    distances = np.linalg.norm(again[:, None] - box(angle).vertices[None], axis=2).min(axis=1)
    assert distances.max() < 1e-9


def test_what_is_no_box_is_not_taken_for_one() -> None:
    tapered = box(0.0)
    points = tapered.vertices.copy()
    points[points[:, 2] > 0, :2] *= 0.8
    assert as_box(Part("leg", points, tapered.faces, OAK)) is None
    assert as_box(cylinder(8)) is None


def test_volumes_and_quaternions() -> None:
    assert volume(box()) == pytest.approx(0.2 * 0.3 * 0.4)
    turns = [(angle, (1, -2, 0.5)) for angle in (0.0, 0.5, math.pi, -2.0)] + [
        (math.pi, (0, 1, -1)),
        (math.pi, (-1, 1, 0)),
    ]
    for angle, axis in turns:
        matrix = trimesh.transformations.rotation_matrix(angle, axis)
        same = trimesh.transformations.quaternion_matrix(quaternion(matrix[:3, :3]))
        assert np.allclose(same, matrix, atol=1e-7)


@pytest.mark.parametrize("content", [b"", b"not a mesh", b"glTF\x02\x00\x00\x00\xff\xff\xff\xff"])
def test_a_broken_mesh_of_an_asset_is_an_error_and_writes_nothing(content: bytes, tmp_path: Path) -> None:
    mesh = tmp_path / "broken.glb"
    mesh.write_bytes(content)
    scene = Scene(Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.5), (Asset("vase-0", "vase", (0.2, 0.2, 0.3), path=mesh),))
    with pytest.raises(AssetError, match=r"broken\.glb"):
        export(scene, Layout({"vase-0": Pose(1, 1, 0.15, 0)}), "glb", folder=tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_huge_mesh_of_an_asset_is_refused_before_it_is_read(tmp_path: Path) -> None:
    mesh = tmp_path / "huge.glb"
    with mesh.open("wb") as file:
        file.write(b"glTF\x02\x00\x00\x00")
        file.truncate(200_000_000)
    scene = Scene(Room(((0, 0), (4, 0), (4, 4), (0, 4)), 2.5), (Asset("vase-0", "vase", (0.2, 0.2, 0.3), path=mesh),))
    with pytest.raises(AssetError, match=r"huge\.glb"):
        export(scene, Layout({"vase-0": Pose(1, 1, 0.15, 0)}), "glb", folder=tmp_path / "out")


@pytest.mark.slow
def test_three_js_finds_and_draws_what_the_file_holds(scene: Scene, layout: Layout, tmp_path: Path) -> None:
    if reason := browser.missing():
        pytest.skip(reason)
    path = export(scene, layout, tmp_path / "room.glb")
    found = browser.in_three(path)
    assert found["said"] == []
    assert {name: found[name] for name in ("lights", "cameras", "textures", "triangles")} == browser.held(path)
    assert found["triangles"] > 1000 and found["lights"] and found["textures"]
    assert set(found["things"]) == set(layout)
    for name, row in found["things"].items():
        pose = layout[name]
        assert row[:3] == pytest.approx((pose.x, pose.y, pose.z), abs=1e-5)
        assert math.remainder(row[3] - pose.yaw, 2 * math.pi) == pytest.approx(0.0, abs=1e-5)
        assert row[4:] == pytest.approx(scene.by_name[name].size, abs=1e-5)
