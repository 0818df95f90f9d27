"""URDF and SDF: the same bodies as in MJCF, meshes as files, what is fixed welded and the rest free."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from pathlib import Path

import mujoco
import numpy as np
import pytest

from robolayout.export import EXPORTERS, Options, export, export_all
from robolayout.export._bodies import BodyTree, things
from robolayout.export._exporter import is_movable, mass
from robolayout.export._mujoco import load
from robolayout.export.mjcf import build
from robolayout.scene import Asset, Layout, Pose, Room, Scene

FREE = {"table_lamp-0", "dining_chair-0", "potted_plant-0"}
ROOM = Room(((0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)), 2.6)


@pytest.fixture(scope="module")
def folder(scene: Scene, layout: Layout, tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("robots")
    export_all(scene, layout, ["urdf", "sdf"], folder=found)
    return found


def described(scene: Scene, layout: Layout) -> dict[str, BodyTree]:
    return {thing.name: thing for thing in things(scene, layout, Options())}


def test_inertias_are_what_mujoco_makes_of_the_same_shapes(scene: Scene, layout: Layout) -> None:
    model, _ = load(build(scene, layout, Options(), free=is_movable))
    compared = 0
    for thing in described(scene, layout).values():
        if thing.asset is None or thing.asset.is_flat:
            continue
        for link in thing.links:
            body = model.body(thing.name if link.joint is None else f"{thing.name}/{link.joint.name}").id
            weight, middle, moments = link.inertia()
            assert weight == pytest.approx(model.body_mass[body], rel=1e-5)
            assert middle == pytest.approx(model.body_ipos[body], abs=1e-5)
            assert np.linalg.eigvalsh(moments) == pytest.approx(sorted(model.body_inertia[body]), rel=1e-3, abs=3e-7)
            compared += 1
    assert compared > len(layout) - 2


def test_the_room_of_a_urdf_holds_what_is_fixed(folder: Path, scene: Scene, layout: Layout) -> None:
    model = mujoco.MjModel.from_xml_path(str(folder / "den.urdf"))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    names = {model.body(i).name for i in range(1, model.nbody)}
    moving = {name for name in names if "/" in name}
    assert names - moving == {"room", *layout} - FREE
    assert {model.joint(i).name for i in range(model.njnt)} == {f"{name}/joint" for name in moving}
    assert "room/door-0" in moving and len(moving) > 3
    for name in set(layout) - FREE:
        pose = layout[name]
        assert data.body(name).xpos == pytest.approx((pose.x, pose.y, pose.z), abs=1e-6)
        assert data.body(name).xmat.reshape(3, 3)[:2, 0] == pytest.approx(pose.forward, abs=1e-6)


def test_what_is_free_is_a_robot_of_its_own_with_its_mass(folder: Path, scene: Scene) -> None:
    places = {place.get("name"): place for place in ET.parse(folder / "den.urdf").getroot().iter("place")}
    assert {name for name, place in places.items() if place.get("file")} == FREE
    for name in FREE:
        robot = folder / places[name].get("file")
        assert not [joint for joint in ET.parse(robot).getroot().iter("joint") if joint.get("type") == "floating"]
        weights = [float(entry.get("value")) for entry in ET.parse(robot).getroot().iter("mass")]
        assert sum(weights) == pytest.approx(mass(scene.by_name[name]), rel=1e-6)
        assert mujoco.MjModel.from_xml_path(str(robot)).ngeom > 1


def test_every_mesh_that_is_named_is_there(folder: Path) -> None:
    named = 0
    for path in [*folder.rglob("*.urdf"), *folder.rglob("*.sdf")]:
        text = path.read_text()
        files = [folder / uri for uri in re.findall(r"<uri>model://(.*?)</uri>", text)]
        files += [path.parent / name for name in re.findall(r'filename="(.*?)"', text)]
        assert all(file.is_file() or (file / "model.config").is_file() for file in files), path
        named += len(files)
    meshes = {file.read_bytes().count(b"\nf ") for file in folder.rglob("*.obj")}
    assert named > 20 and min(meshes) >= 4


def test_a_world_refers_to_each_kind_once_and_welds_what_opens(folder: Path, layout: Layout) -> None:
    world = ET.parse(folder / "den.sdf").getroot().find("world")
    includes = {include.findtext("name"): include.findtext("uri") for include in world.iter("include")}
    assert set(includes) == {"room", *layout}
    welded = {joint.findtext("child").partition("::")[0] for joint in world.findall("joint")}
    assert {"room", "wardrobe-0", "night_stand-0"} == welded
    for name, uri in includes.items():
        model = ET.parse(folder / uri.removeprefix("model://") / "model.sdf").getroot().find("model")
        assert (model.findtext("static") == "1") == (name not in FREE | welded)
        assert (model.find(".//mass") is None) == (model.find(".//joint") is None and name == "room")


def test_equal_things_share_a_folder_and_names_are_made_legal(tmp_path: Path) -> None:
    names = ("a::b", "a__b", "world", "__x__", "")
    stools = tuple(Asset(name, "stool", (0.4, 0.4, 0.45)) for name in names)
    places = Layout({name: Pose(1.0 + 0.6 * i, 1.0, 0.225, 0.0) for i, name in enumerate(names)})
    path = export(Scene(ROOM, stools, name="world"), places, "sdf", folder=tmp_path)
    given = [include.findtext("name") for include in ET.parse(path).getroot().iter("include")]
    assert len(set(given)) == 6 and not [name for name in given if "::" in name or "__" in name[:2] or name == "world"]
    assert set(EXPORTERS["sdf"].read(path.read_bytes()).layout) == set(names)
    assert len(list((tmp_path / "models").iterdir())) < 1 + len(names)


def test_a_rug_is_touched_only_where_something_stands_on_it() -> None:
    rug, table = Asset("rug-0", "rug", (2.0, 3.0, 0.012)), Asset("dining_table-0", "dining table", (0.9, 1.6, 0.75))
    vase = Asset("vase-0", "vase", (0.2, 0.3, 0.3), on_object=True)
    poses = {"rug-0": Pose(2.5, 2, 0.006, 0.5), "dining_table-0": Pose(2.5, 2, 0.375, 0.2)}
    places = Layout(poses | {"vase-0": Pose(3.0, 2.6, 0.162, 1.0)})
    shapes = described(Scene(ROOM, (rug, table, vase)), places)["rug-0"].links[0].shapes
    (patch,) = [shape for shape in shapes if shape.touched]
    assert patch.box is not None and not patch.seen
    assert patch.box.half == pytest.approx((0.1, 0.15, 0.006))
    turn = np.array([[math.cos(0.5), -math.sin(0.5)], [math.sin(0.5), math.cos(0.5)]])
    assert turn @ patch.box.center[:2] == pytest.approx((0.5, 0.6))
    beyond = Layout(poses | {"vase-0": Pose(0.5, 0.5, 0.162, 0.0)})
    again = described(Scene(ROOM, (rug, table, vase)), beyond)["rug-0"]
    assert not [shape for shape in again.links[0].shapes if shape.touched]
