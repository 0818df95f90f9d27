"""Agents from MJCF models: the same figures as from a URDF, and links where MuJoCo has them."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import trimesh

from robolayout._errors import AgentError, UnknownNameError
from robolayout.scene import agent_from_dict, agent_to_dict, load_agent
from robolayout.scene._model import Model
from robolayout.scene.agent import horizontal_reach
from robolayout.scene.mjcf import read_mjcf

ARM = """<mujoco model="mobile arm"><compiler angle="radian"/>
<worldbody><geom type="plane" size="5 5 1"/>
<body name="base" pos="3 1 0.2"><freejoint/><geom type="cylinder" size="0.25 0.2"/>{wheels}
  <body name="upper" pos="0 0 0.5"><joint name="shoulder" axis="0 1 0" range="-3 3"/>
    <geom type="box" size="0.25 0.03 0.03" pos="0.25 0 0"/>
    <body name="gripper" pos="0.5 0 0"><joint name="elbow" axis="0 1 0" range="-3 3"/>
      <geom type="box" size="0.25 0.03 0.03" pos="0.25 0 0"/></body></body>
</body></worldbody>{more}</mujoco>"""

TWISTED = """<mujoco><compiler eulerseq="XYz" meshdir="parts"/>
<default><geom size="0.05"/><default class="arm"><joint axis="0 1 0" range="-90 60"/>
  <default class="slim"><geom type="capsule" size="0.02 0.2"/></default></default></default>
<asset><mesh name="wedge" file="wedge.stl" scale="0.1 0.2 0.3" refpos="0.1 0 0" refquat="0.9 0.1 0 0.2"/></asset>
<worldbody><body name="base" pos="0 0 1" euler="10 20 30"><geom/>
  <body name="a" pos="0.1 0.2 0.3" axisangle="1 1 0 40" childclass="arm">
    <joint name="one" ref="20"/><joint name="two" type="slide" axis="1 0 1" range="-0.2 0.3" pos="0.1 0 0"/>
    <geom class="slim" fromto="0 0 0 0.3 0.2 0.1"/><geom contype="0" conaffinity="0" size="9"/>
    <frame pos="0 0.1 0" euler="0 0 45"><geom type="ellipsoid" size="0.1 0.2 0.05" zaxis="1 0 1"/>
      <body name="b" xyaxes="0 1 0 -1 0 0.1"><joint name="three" pos="0.05 0.02 0" axis="0.3 1 0"/>
        <geom type="mesh" mesh="wedge" quat="0.7 0 0.7 0"/></body></frame></body>
  <body name="c" pos="0 0 -0.4"><joint name="four" type="hinge" range="-30 30" axis="1 0 0"/><geom type="box" size=".1 .2 .3"/></body>
</body></worldbody>
<equality><joint joint1="four" joint2="one" polycoef="0.1 0.5 0 0 0"/></equality></mujoco>"""


def write(folder: Path, text: str, name: str = "robot.xml") -> Path:
    path = folder / name
    path.parent.mkdir(exist_ok=True, parents=True)
    path.write_text(text)
    return path


def arm(folder: Path, more: str = "", wheels: str = "") -> Path:
    return write(folder, ARM.format(more=more, wheels=wheels))


def test_an_arm_is_folded_and_reaches_by_bands(tmp_path: Path) -> None:
    agent = load_agent(arm(tmp_path))
    assert (agent.name, agent.circumradius < 0.45) == ("mobile arm", True)
    assert "MJCF model mobile arm, its arms folded" in agent.sources["height"].text
    assert agent.reach_distance == pytest.approx(0.5, abs=0.01)  # the gripper's own joint, 0.5 m from the shoulder
    level = horizontal_reach(agent, 0.68, 0.72)
    assert level is not None and level > 0.48
    high = horizontal_reach(agent, 1.15, 1.15)
    assert high is not None and high < 0.40
    assert horizontal_reach(agent, 1.4, 2.0) is None
    again = agent_from_dict(agent_to_dict(agent))
    assert again == agent


def test_a_keyframe_says_the_pose_and_a_given_one_is_stronger(tmp_path: Path) -> None:
    key = '<keyframe><key name="home" qpos="0 0 0 1 0 0 0 -1.5708 0"/></keyframe>'
    agent = load_agent(arm(tmp_path, key))
    assert "in its keyframe" in agent.sources["height"].text
    assert agent.height == pytest.approx(0.2 + 0.5 + 1.0, abs=2e-3)  # straight up
    profile = write(tmp_path, 'model = "robot.xml"\nreach = 0.4\n[pose]\nshoulder = 0.0\n', "mine.toml")
    agent = load_agent(profile)
    assert agent.length == pytest.approx(1.25, abs=1e-3)
    assert (agent.reach_distance, agent.reach_bands) == (0.4, ())
    with pytest.raises(UnknownNameError, match="shoulder"):
        load_agent(write(tmp_path, 'model = "robot.xml"\n[pose]\nsholder = 0\n', "mine.toml"))
    with pytest.raises(AgentError, match="keyframe, qpos must have 9 numbers, but has 3"):
        load_agent(arm(tmp_path, '<keyframe><key name="home" qpos="0 0 0"/></keyframe>'))


@pytest.mark.parametrize(
    ("axes", "radius"),
    [(["0 1 0", "0 1 0"], 0.0), (["1 1 0", "-1 1 0"], None), (["0 1 0"], None)],
    ids=["differential", "omni", "one"],
)
def test_wheels_say_whether_it_slides(tmp_path: Path, axes: list[str], radius: float | None) -> None:
    wheels = "".join(
        f'<body pos="0.1 {0.3 - 0.6 * i} -0.1"><joint axis="{axis}"/><geom size="0.1"/></body>'
        for i, axis in enumerate(axes)
    )
    agent = load_agent(arm(tmp_path, wheels=wheels))
    assert agent.turning_radius == radius


def test_links_are_where_mujoco_has_them(tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    (tmp_path / "parts").mkdir()
    wedge = trimesh.convex.convex_hull(np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0.2)]))
    wedge.export(tmp_path / "parts" / "wedge.stl")
    path = write(tmp_path, TWISTED)
    robot = read_mjcf(Model(path).root(path)[0], Model(path))
    simulated = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(simulated)
    values = {"one": 0.3, "two": 0.15, "three": -0.4, "four": 0.1 + 0.5 * 0.3}
    for name, value in values.items():
        data.joint(name).qpos = value
    mujoco.mj_kinematics(simulated, data)
    poses = robot.poses({name: np.array([value]) for name, value in values.items() if name != "four"})
    for link, hull in robot.hulls.items():
        body = data.body(link)
        np.testing.assert_allclose(poses[link][0][:3, :3], body.xmat.reshape(3, 3), atol=1e-9)
        np.testing.assert_allclose(poses[link][0][:3, 3], body.xpos - (0, 0, 1), atol=1e-9)
        assert np.isfinite(hull).all()
    geom = next(i for i in range(simulated.ngeom) if simulated.geom_dataid[i] >= 0)
    vertices = simulated.mesh_vert @ data.geom_xmat[geom].reshape(3, 3).T + data.geom_xpos[geom]
    hull = robot.hulls["b"] @ poses["b"][0][:3, :3].T + poses["b"][0][:3, 3] + (0, 0, 1)
    np.testing.assert_allclose(np.sort(vertices, axis=0), np.sort(hull, axis=0), atol=1e-6)


def test_included_files_are_read_once_and_from_the_folder_only(tmp_path: Path) -> None:
    home = tmp_path / "models" / "robot"
    write(home, '<mujocoinclude><body name="b"><geom size="0.2"/></body></mujocoinclude>', "b.xml")
    whole = '<mujoco model="r"><worldbody><include file="{}"/></worldbody></mujoco>'
    assert load_agent(write(home, whole.format("b.xml"))).radius == pytest.approx(0.2, abs=2e-4)
    write(tmp_path, "<mujocoinclude/>", "far.xml")
    with pytest.raises(AgentError, match=r"included file '../../far\.xml' is not in the model's folder or package"):
        load_agent(write(home, whole.format("../../far.xml")))
    with pytest.raises(AgentError, match=r"includes robot\.xml twice; MuJoCo reads a file once"):
        load_agent(write(home, whole.format("robot.xml")))
    write(home, '<!DOCTYPE x [<!ENTITY a "b">]><mujocoinclude/>', "b.xml")
    with pytest.raises(AgentError, match="has a document type or entities, which are not allowed"):
        load_agent(write(home, whole.format("b.xml")))


BODY = '<mujoco><worldbody><body name="b">{}</body></worldbody></mujoco>'


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("<mujoco/>", "no body has a shape that collides, so the robot has no size; add geoms."),
        (BODY.format('<geom type="mesh" mesh="m"/>'), "geom 'mesh' has the mesh 'm', which no <asset> describes."),
        (BODY.format('<geom type="sdf"/>'), "geom type 'sdf' is not read; allowed are mesh, sphere, capsule,"),
        (BODY.format('<geom type="box" size="1 1"/>'), "geom 'box': size must have 3 numbers, but has 2."),
        (BODY.format('<geom size="x"/>'), "geom 'sphere': size must be 1 numbers, but is 'x'."),
        (BODY.format('<geom size="nan"/>'), "size[0] must be a finite number, but is nan."),
        (BODY.format('<geom size="1" class="k"/>'), "<geom> has the class 'k', which no <default> describes."),
        (BODY.format('<geom size="1" quat="0 0 0 0"/>'), "geom 'sphere': quat is no rotation"),
        (BODY.format('<replicate count="3"/>'), "has <replicate>, which is not read; load it in MuJoCo and save it"),
        (BODY.format('<body name="b"/>'), "has two of the name 'b' (<body>); give each its own."),
        (BODY.format('<joint type="screw"/>'), "joint type 'screw' is none; allowed are free, ball, slide, hinge."),
        (BODY.format('<geom size="1"/>' * 2001), "has 2001 <geom> elements; at most 2000 are allowed."),
        (BODY.format("<body>" * 70 + "</body>" * 70), "is nested too deeply. At most 64 levels are read"),
        (
            "<mujoco><worldbody>" + 2 * '<body><geom size="1"/></body>' + "</worldbody></mujoco>",
            "has 2 bodies with joints in its world ('body', 'body'); leave one robot in it.",
        ),
        (
            '<mujoco><asset><mesh file="m.msh"/></asset>' + BODY[8:].format('<geom mesh="m"/>'),
            "mesh 'm.msh' is of no kind that is read (.stl, .obj, .ply, .dae); convert it.",
        ),
        (
            '<mujoco><asset><mesh file="m.stl"/></asset>' + BODY[8:].format('<geom mesh="m"/>'),
            "mesh 'm.stl' is not in the model's folder or package; put it there.",
        ),
    ],
    ids=lambda value: "" if value.startswith("<") else value[:50],
)
def test_wrong_models(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(AgentError) as caught:
        load_agent(write(tmp_path, text))
    assert message in str(caught.value)


def test_a_body_turned_in_the_world_keeps_its_turn(tmp_path: Path) -> None:
    text = BODY.replace('name="b"', f'name="b" pos="5 5 5" zaxis="{math.sin(0.5)} 0 {math.cos(0.5)}"')
    agent = load_agent(write(tmp_path, text.format('<geom type="box" size="0.4 0.1 0.1"/>')))
    assert agent.length == pytest.approx(0.8 * math.cos(0.5) + 0.2 * math.sin(0.5), abs=1e-3)
