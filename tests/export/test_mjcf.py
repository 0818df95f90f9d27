"""MJCF, loaded by MuJoCo."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh

from robolayout._errors import LayoutError
from robolayout.assets import category_of, parts
from robolayout.export import EXPORTERS, Options
from robolayout.export._exporter import is_movable, mass
from robolayout.export._mesh import as_box
from robolayout.export._mujoco import load
from robolayout.export.mjcf import AGENT, BASE, build, start
from robolayout.scene import DEFAULT_AGENT, Agent, Asset, Layout, Pose, Room, Scene

ROUTES = {"wardrobe-0": [(4.0, 0.5), (4.0, 2.0)]}
GIVEN = Options(agent=DEFAULT_AGENT, routes=ROUTES, start=Pose(4.0, 0.5, 0.0, math.pi / 2))
FREE = {"table_lamp-0", "dining_chair-0", "potted_plant-0"}


def loaded(scene: Scene, layout: Layout, options: Options) -> tuple[mujoco.MjModel, mujoco.MjData]:
    model, data = load(build(scene, layout, options, free=is_movable))
    mujoco.mj_forward(model, data)
    return model, data


@pytest.fixture(scope="module")
def sim(scene: Scene, layout: Layout) -> tuple[mujoco.MjModel, mujoco.MjData]:
    return loaded(scene, layout, GIVEN)


def test_every_asset_is_a_body_at_its_pose(sim: tuple, scene: Scene, layout: Layout) -> None:
    model, data = sim
    moving = {part.joint for asset in scene.assets for part in parts(asset) if part.joint is not None}
    assert model.nbody == 1 + 1 + len(scene.room.doors) + len(layout) + len(moving) + 1
    for name, pose in layout.items():
        assert data.body(name).xpos == pytest.approx((pose.x, pose.y, pose.z), abs=1e-9)
        w, x, y, z = data.body(name).xquat
        assert (x, y) == pytest.approx((0, 0), abs=1e-12)
        assert math.remainder(2 * math.atan2(z, w) - pose.yaw, 2 * math.pi) == pytest.approx(0, abs=1e-9)


def test_movable_things_are_free_and_weigh_what_they_should(sim: tuple, scene: Scene, layout: Layout) -> None:
    model, _ = sim
    free = {
        model.body(model.jnt_bodyid[j]).name
        for j in range(model.njnt)
        if model.jnt_type[j] == mujoco.mjtJoint.mjJNT_FREE
    }
    assert free == FREE
    for asset in scene.assets:
        if not asset.is_flat:
            assert model.body(asset.name).subtreemass == pytest.approx(mass(asset), rel=1e-5)


def test_a_mesh_of_ones_own_weighs_what_its_kind_does(tmp_path: Path) -> None:
    seat, back = (trimesh.creation.box((0.52, 0.47, side)) for side in (0.05, 0.88))
    trimesh.util.concatenate([seat, back.apply_scale((0.1, 1, 1))]).export(
        tmp_path / "chair.stl"
    )  # in one concave piece
    chair = Asset("chair-0", "chair", (0.52, 0.47, 0.88), path=tmp_path / "chair.stl")
    scene = Scene(Room(((0, 0), (3, 0), (3, 3), (0, 3)), 2.5), (chair,))
    model, _ = loaded(scene, Layout({"chair-0": Pose(1.5, 1.5, 0.44, 0.0)}), Options())
    assert model.body("chair-0").mass == pytest.approx(6.0)  # kg of a chair of the usual size, not of as much water


def test_friction_is_that_of_the_category(sim: tuple, scene: Scene) -> None:
    model, _ = sim
    for geom in (model.geom(i) for i in range(model.ngeom)):
        name = geom.name.partition("/")[0]
        if name in scene.by_name and name != "rug-0":
            assert geom.friction[0] == pytest.approx(category_of(scene.by_name[name]).friction)


def test_boxes_stay_boxes(sim: tuple, scene: Scene) -> None:
    model, _ = sim
    kinds = {model.geom(i).name: model.geom_type[i] for i in range(model.ngeom)}
    for asset in scene.assets:
        for number, part in enumerate(parts(asset)):
            if as_box(part) is not None and not asset.is_flat:
                assert kinds[f"{asset.name}/{part.name}/{number}"] == mujoco.mjtGeom.mjGEOM_BOX


def test_geoms_fill_the_assets_box(sim: tuple, scene: Scene) -> None:
    model, _ = sim
    for asset in scene.assets:
        low, high = np.full(3, np.inf), np.full(3, -np.inf)
        body = model.body(asset.name)
        for i in range(body.geomadr[0], body.geomadr[0] + body.geomnum[0]):
            corners = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T * model.geom_size[i]
            if model.geom_type[i] == mujoco.mjtGeom.mjGEOM_MESH:
                mesh = model.mesh(model.geom_dataid[i])
                corners = model.mesh_vert[mesh.vertadr[0] : mesh.vertadr[0] + mesh.vertnum[0]].astype(float)
            matrix = np.zeros(9)
            mujoco.mju_quat2Mat(matrix, model.geom_quat[i])
            points = corners @ matrix.reshape(3, 3).T + model.geom_pos[i]
            low, high = np.minimum(low, points.min(axis=0)), np.maximum(high, points.max(axis=0))
        assert high - low == pytest.approx(asset.size, abs=2e-3), asset.name


def test_nothing_collides_before_it_moves(scene: Scene, layout: Layout) -> None:
    model, data = loaded(scene, layout, Options())
    assert data.ncon == 0 or float(np.min(data.contact.dist[: data.ncon])) > -1e-3
    assert not any("rug-0" in model.geom(int(g)).name for pair in data.contact.geom[: data.ncon] for g in pair)


def test_the_agent_is_a_planar_base_with_world_coordinates(sim: tuple, scene: Scene) -> None:
    model, data = sim
    joints = [int(model.joint(f"{AGENT}/{axis}").qposadr[0]) for axis in ("x", "y", "yaw")]
    assert data.qpos[joints] == pytest.approx((4.0, 0.5, math.pi / 2))
    assert model.nu == 3
    assert model.body(AGENT).mass == pytest.approx(BASE.mass)
    data.qpos[joints] = (2.0, 1.0, -0.4)
    mujoco.mj_forward(model, data)
    assert data.body(AGENT).xpos[:2] == pytest.approx((2.0, 1.0))
    assert data.body(AGENT).xquat == pytest.approx((math.cos(-0.2), 0, 0, math.sin(-0.2)))
    mujoco.mj_resetData(model, data)


def test_the_base_goes_where_its_actuators_say(scene: Scene) -> None:
    model, data = loaded(scene, Layout({}), GIVEN)
    data.ctrl[:] = (-0.5, 1.0, 0.3)
    for _ in range(int(3 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert data.qpos[-3:] == pytest.approx((3.5, 1.5, math.pi / 2 + 0.3), abs=0.01)


@pytest.mark.parametrize("length", [None, 1.2])
def test_the_base_has_the_bodys_shape(length: float | None, scene: Scene, layout: Layout) -> None:
    agent = Agent("body", 0.45, 1.4, length=length, width=None if length is None else 0.76, step=0.02)
    model, data = loaded(scene, layout, Options(agent=agent))
    geom = model.geom(f"{AGENT}/body")
    low, high = data.geom(geom.id).xpos[2] + np.array([-1, 1]) * (geom.size[1] if length is None else geom.size[2])
    assert (low, high) == pytest.approx((0.02, 1.4))
    assert geom.size[0] == pytest.approx(0.45 if length is None else 0.6)


def test_unsaid_the_base_starts_inside_the_door(scene: Scene) -> None:
    pose = start(scene, Options())
    assert (pose.x, pose.y, pose.yaw) == pytest.approx((4.05, 0.6, math.pi / 2))
    mid = start(Scene(type(scene.room)(scene.room.vertices, 2.5), ()), Options())
    assert (mid.x, mid.y) == (2.5, 2.0)


def test_facts_are_kept_as_custom_data(scene: Scene, layout: Layout) -> None:
    root = ET.fromstring(EXPORTERS["mjcf"].write(scene, layout, Options(routes=ROUTES)))
    texts = {entry.get("name"): entry.get("data") for entry in root.iter("text")}
    assert texts["category/double_bed-0"] == "double bed"
    assert texts["route/wardrobe-0"] == "4 0.5 4 2"


@pytest.mark.parametrize("name", ["mjcf", "urdf", "sdf"])
def test_entities_are_refused(name: str) -> None:
    bomb = b'<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;">]><mujoco>&b;</mujoco>'
    with pytest.raises(LayoutError, match="has a document type or entities"):
        EXPORTERS[name].read(bomb)
