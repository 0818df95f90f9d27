"""A robot's whole model on its base, stepped by MuJoCo."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh

from robolayout._errors import AgentError
from robolayout.export import Options
from robolayout.export._exporter import is_movable
from robolayout.export._mujoco import load
from robolayout.export.mjcf import AGENT, build
from robolayout.scene import Agent, Asset, Layout, Pose, Room, Scene, load_agent

ROOM = Room(((0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)), 2.6)

URDF = """<robot name="armed">
<link name="base"><collision><origin xyz="0.1 0 0.15"/><geometry><mesh filename="hull.stl"/></geometry></collision>
 <inertial><mass value="20"/><inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/></inertial></link>
<link name="arm"><collision><origin xyz="0.25 0 0"/><geometry><box size="0.5 0.06 0.06"/></geometry></collision></link>
<link name="hand"><collision><origin xyz="0.2 0 0"/><geometry><box size="0.4 0.05 0.05"/></geometry></collision></link>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="arm"/><origin xyz="0.3 0 0.4"/>
 <axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="5" velocity="1"/></joint>
<joint name="elbow" type="revolute"><parent link="arm"/><child link="hand"/><origin xyz="0.5 0 0"/>
 <axis xyz="0 0 1"/><limit lower="-3.1" upper="3.1" effort="5" velocity="1"/></joint>
</robot>"""

MJCF = """<mujoco model="armed">
<worldbody><light pos="0 0 3"/><geom name="ground" type="plane" size="1 1 1"/>
 <body name="base" pos="0 0 0.5"><freejoint/><geom type="box" size="0.3 0.2 0.1" mass="20"/>
  <body name="arm" pos="0.2 0 0.1"><joint name="shoulder" axis="0 1 0" range="-180 180"/>
   <joint name="twist" axis="1 0 0" range="-90 90"/>
   <geom type="capsule" fromto="0 0 0 0.5 0 0" size="0.03" mass="2"/>
   <geom type="mesh" mesh="hull" contype="0" conaffinity="0" mass="0"/>
   <body name="hand" pos="0.5 0 0"><joint name="elbow" axis="0 0 1" range="-178 178"/>
    <geom type="box" size="0.2 0.03 0.03" pos="0.2 0 0" mass="1"/></body></body></body>
</worldbody>
<asset><mesh name="hull" file="hull.stl"/></asset>
<actuator><position joint="shoulder" kp="100"/></actuator>
<keyframe><key name="home" qpos="0 0 0.5 1 0 0 0 -1.2 0.4 2.9"/></keyframe>
</mujoco>"""


@pytest.fixture(params=["robot.urdf", "robot.xml"])
def robot(request: pytest.FixtureRequest, tmp_path: Path) -> Agent:
    trimesh.creation.box((0.6, 0.4, 0.3)).export(tmp_path / "hull.stl")
    path = tmp_path / request.param
    path.write_text(URDF if path.suffix == ".urdf" else MJCF)
    return load_agent(path)


def loaded(agent: Agent, assets: Sequence[Asset] = (), *, whole: bool = True) -> tuple[mujoco.MjModel, mujoco.MjData]:
    layout = Layout({asset.name: Pose(2.0, 2.0, asset.size[2] / 2, 0.0) for asset in assets})
    options = Options(agent=agent, whole=whole, start=Pose(2.0, 2.0, 0.0, 0.7))
    model, data = load(build(Scene(ROOM, tuple(assets)), layout, options, free=is_movable))
    mujoco.mj_forward(model, data)
    return model, data


def test_nothing_moves_while_all_controls_are_zero(robot: Agent) -> None:
    model, data = loaded(robot)
    assert data.qpos == pytest.approx(model.key_qpos[0])
    places = data.geom_xpos.copy()
    for _ in range(int(5 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert np.abs(data.geom_xpos - places).max() < 1e-4
    assert model.nu == 3 + model.njnt - 3 > 4


def test_it_stands_in_its_pose_on_the_floor_where_the_base_is(robot: Agent) -> None:
    model, data = loaded(replace(robot))
    figure = robot.figure
    assert figure is not None
    assert robot.circumradius < 0.75  # stretched out its hand is 1.2 m ahead
    for name, value in figure.pose.items():
        assert data.qpos[model.joint(f"{AGENT}/{name}").qposadr[0]] == pytest.approx(value)
    solid = [g for g in range(model.ngeom) if model.geom_contype[g] == 2]
    corners = np.concatenate([corner_points(model, data, g) for g in solid])
    assert (corners[:, 2].min(), corners[:, 2].max()) == pytest.approx((0.0, robot.height), abs=2e-3)
    away = (corners[:, :2] - (2.0, 2.0)) @ np.array([[np.cos(0.7), -np.sin(0.7)], [np.sin(0.7), np.cos(0.7)]])
    half = np.array([robot.length, robot.width]) / 2 if robot.length and robot.width else np.full(2, robot.radius)
    assert (np.abs(away).max(axis=0) <= half + 2e-3).all()


def corner_points(model: mujoco.MjModel, data: mujoco.MjData, geom: int) -> np.ndarray:
    """Return points on a geom, in the world."""
    turn = data.geom_xmat[geom].reshape(3, 3)
    if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_MESH:
        mesh = model.mesh(model.geom_dataid[geom])
        local = model.mesh_vert[mesh.vertadr[0] : mesh.vertadr[0] + mesh.vertnum[0]]
    elif model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_CAPSULE:
        radius, half = model.geom_size[geom][:2]
        ways = np.random.default_rng(0).normal(size=(500, 3))
        local = radius * ways / np.linalg.norm(ways, axis=1)[:, None] + np.array([0, 0, half]) * np.sign(ways[:, 2:])
    else:
        local = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T * model.geom_size[geom]
    return local @ turn.T + data.geom_xpos[geom]


def test_its_joints_go_where_their_controls_say(robot: Agent) -> None:
    model, data = loaded(robot)
    elbow = model.joint(f"{AGENT}/elbow").qposadr[0]
    before = float(data.qpos[elbow])
    data.ctrl[model.actuator(f"{AGENT}/elbow").id] = -0.4 if before > 0 else 0.4
    for _ in range(int(3 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert abs(float(data.qpos[elbow]) - before) == pytest.approx(0.4, abs=0.01)


WORLD = """<link name="world"/><joint name="put" type="fixed"><parent link="world"/><child link="base"/>
 <origin xyz="1 2 0.5"/></joint></robot>"""


def test_where_a_urdf_puts_its_robot_in_a_world_is_not_of_the_robot(tmp_path: Path) -> None:
    trimesh.creation.box((0.6, 0.4, 0.3)).export(tmp_path / "hull.stl")
    (tmp_path / "plain.urdf").write_text(URDF)
    (tmp_path / "put.urdf").write_text(URDF.replace("</robot>", WORLD))
    plain, put = (load_agent(tmp_path / f"{name}.urdf") for name in ("plain", "put"))
    for figure in ("height", "radius", "length", "width", "turning_diameter", "reach_distance", "reach_bands"):
        assert getattr(put, figure) == getattr(plain, figure)
    places = [data.body(f"{AGENT}/hand").xpos for _, data in (loaded(plain), loaded(put))]
    assert places[1] == pytest.approx(places[0], abs=1e-9)


FINGERS = """<link name="left"/><link name="right"/>
<joint name="grip" type="prismatic"><parent link="hand"/><child link="left"/><origin xyz="0.4 0 0"/>
 <axis xyz="0 1 0"/><limit lower="0" upper="0.04" effort="5" velocity="1"/></joint>
<joint name="grip too" type="prismatic"><parent link="hand"/><child link="right"/><origin xyz="0.4 0 0"/>
 <axis xyz="0 -1 0"/><limit lower="0" upper="0.04" effort="5" velocity="1"/><mimic joint="grip"/></joint>
</robot>"""

TIPS = """<body name="left" pos="0.4 0 0"><joint name="grip" type="slide" axis="0 1 0" range="0 0.04"/>
 <geom size="0.01" mass="0.1"/></body>
<body name="right" pos="0.4 0 0"><joint name="grip too" type="slide" axis="0 -1 0" range="0 0.04"/>
 <geom size="0.01" mass="0.1"/></body></body></body></body>"""

EQUALITY = '<equality><joint joint1="grip too" joint2="grip"/></equality></mujoco>'


@pytest.mark.parametrize("suffix", [".urdf", ".xml"])
def test_a_joint_that_follows_another_has_no_control_and_goes_all_the_way_with_it(suffix: str, tmp_path: Path) -> None:
    trimesh.creation.box((0.6, 0.4, 0.3)).export(tmp_path / "hull.stl")
    path = (tmp_path / "robot").with_suffix(suffix)
    mjcf = MJCF.replace("</body></body></body>", TIPS).replace("2.9", "2.9 0 0").replace("</mujoco>", EQUALITY)
    path.write_text(URDF.replace("</robot>", FINGERS) if suffix == ".urdf" else mjcf)
    model, data = loaded(load_agent(path))
    controls = [model.actuator(number).name for number in range(model.nu)]
    assert f"{AGENT}/grip" in controls and f"{AGENT}/grip too" not in controls
    data.ctrl[controls.index(f"{AGENT}/grip")] = 0.03
    for _ in range(int(3 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    opened = [float(data.joint(f"{AGENT}/{name}").qpos[0]) for name in ("grip", "grip too")]
    assert opened == pytest.approx([0.03, 0.03], abs=1e-3)


def test_it_collides_with_the_room_and_not_with_itself(robot: Agent) -> None:
    _, alone = loaded(robot)
    assert alone.ncon == 0
    model, data = loaded(robot, [Asset("shelf-0", "bookshelf", (0.3, 0.8, 1.8))])
    met = {model.body(model.geom_bodyid[g]).name.partition("/")[0] for g in data.contact.geom[: data.ncon].flat}
    assert met == {AGENT, "shelf-0"}


def test_a_body_without_a_file_is_its_base() -> None:
    full, base = (loaded(load_agent("stretch3"), whole=whole)[0] for whole in (True, False))
    assert full.nbody == base.nbody and full.ngeom == base.ngeom


def test_a_mesh_that_is_gone_is_named(robot: Agent) -> None:
    assert robot.figure is not None
    (robot.figure.path.parent / "hull.stl").unlink()
    with pytest.raises(AgentError, match=r"hull\.stl.* is not in the model's folder or package; put it there"):
        loaded(robot)
