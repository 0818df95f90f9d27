"""Agents from URDF models: the footprint and height of their collision geometry."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
import trimesh

from robolayout._errors import AgentError, UnknownNameError
from robolayout.scene import load_agent


def write(folder: Path, body: str, name: str = "robot") -> Path:
    path = folder / f"{name}.urdf"
    path.write_text(f'<?xml version="1.0"?>\n<robot name="{name}">{body}</robot>')
    return path


def link(shape: str, name: str = "base", origin: str = "") -> str:
    return f'<link name="{name}"><collision>{origin}<geometry>{shape}</geometry></collision></link>'


def joint(parent: str, child: str, xyz: str, rpy: str = "0 0 0") -> str:
    return (
        f'<joint name="{parent}-{child}" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{xyz}" rpy="{rpy}"/></joint>'
    )


CYLINDER = '<cylinder radius="0.2" length="0.3"/>'


def test_a_cylinder_is_a_disc(tmp_path: Path) -> None:
    agent = load_agent(write(tmp_path, link(CYLINDER), "can"))
    assert (agent.name, agent.length) == ("can", None)
    assert agent.radius == pytest.approx(0.2, abs=2e-4)
    assert agent.height == pytest.approx(0.3, abs=2e-4)
    assert agent.sources["radius"].text == "collision geometry of the URDF model can, joints at zero"


def test_a_box_is_a_rectangle_and_turns_in_place(tmp_path: Path) -> None:
    agent = load_agent(write(tmp_path, link('<box size="0.8 0.5 0.4"/>')))
    assert (agent.length, agent.width, agent.height) == pytest.approx((0.8, 0.5, 0.4), abs=2e-4)
    assert agent.radius == pytest.approx(0.28, abs=2e-4)
    assert agent.turning_diameter is None


def test_a_body_behind_its_axle_needs_a_turning_circle(tmp_path: Path) -> None:
    agent = load_agent(write(tmp_path, link('<box size="0.8 0.5 0.4"/>', origin='<origin xyz="0.3 0 0"/>')))
    assert agent.length == pytest.approx(0.8, abs=2e-4)
    assert agent.turning_diameter == pytest.approx(2 * math.hypot(0.7, 0.25), abs=2e-4)


def test_joints_carry_links_at_zero(tmp_path: Path) -> None:
    arm = link('<box size="0.6 0.1 0.1"/>', "arm", '<origin xyz="0.3 0 0"/>')
    body = link(CYLINDER) + arm + joint("base", "arm", "0 0 1", f"0 0 {math.pi / 2}")
    agent = load_agent(write(tmp_path, body))
    assert agent.height == pytest.approx(0.15 + 1.05, abs=2e-4)
    assert agent.length == pytest.approx(0.4, abs=2e-4)
    assert agent.width == pytest.approx(0.6 + 0.2, abs=2e-4)


def test_roll_pitch_and_yaw_turn_about_fixed_axes(tmp_path: Path) -> None:
    lying = link('<cylinder radius="0.1" length="2"/>', origin=f'<origin rpy="{math.pi / 2} 0 {math.pi / 2}"/>')
    agent = load_agent(write(tmp_path, lying))
    assert (agent.length, agent.width, agent.height) == pytest.approx((2.0, 0.2, 0.2), abs=2e-3)


def test_spheres_and_height_above_the_lowest_point(tmp_path: Path) -> None:
    agent = load_agent(write(tmp_path, link('<sphere radius="0.25"/>', origin='<origin xyz="0 0 -3"/>')))
    assert (agent.radius, agent.height) == pytest.approx((0.25, 0.5), abs=2e-4)


@pytest.mark.parametrize("filename", ["package://bot/meshes/can.stl", "../meshes/can.stl", "../meshes/can.obj"])
def test_meshes(tmp_path: Path, filename: str) -> None:
    (tmp_path / "bot" / "urdf").mkdir(parents=True)
    (tmp_path / "bot" / "meshes").mkdir()
    trimesh.creation.cylinder(radius=0.4, height=1, sections=64).export(
        tmp_path / "bot" / "meshes" / filename.rpartition("/")[2]
    )
    mesh = link(f'<mesh filename="{filename}" scale="0.5 0.5 2"/>')
    agent = load_agent(write(tmp_path / "bot" / "urdf", mesh))
    assert (agent.radius, agent.height) == pytest.approx((0.2, 2.0), abs=2e-3)


@pytest.mark.parametrize(
    ("body", "message"),
    [
        ('<link name="base"/>', "no link has collision geometry, so the body has no size; add <collision> elements."),
        ("", "has 0 root links; a URDF has exactly one link that is no joint's child."),
        (link(CYLINDER) + link(CYLINDER, "b"), "has 2 root links"),
        (link(CYLINDER) + link(CYLINDER), "has two links of one name; give each its own."),
        (link(CYLINDER) + joint("base", "x", "0 0 0"), "joint 'base-x' names the link 'x', which does not exist."),
        (
            link(CYLINDER, "a") + link(CYLINDER, "b") + joint("a", "b", "0 0 0") * 2,
            "link 'b' has two parents; a URDF is a tree.",
        ),
        (
            link(CYLINDER)
            + link(CYLINDER, "a")
            + link(CYLINDER, "b")
            + joint("a", "b", "0 0 0")
            + joint("b", "a", "0 0 0"),
            "link 'a' is part of a loop of joints.",
        ),
        (link('<box size="1 1"/>'), "<'box'>: size must have 3 numbers, but has 2."),
        (link('<box size="1 1 x"/>'), "<'box'>: size must be 3 numbers, but is '1 1 x'."),
        (link('<box size="1 1 nan"/>'), "<'box'>: size[2] must be a finite number, but is nan."),
        (link('<box size="1 1 -1"/>'), "<'box'>: size (metres) must be above 0, but is -1.0."),
        (link("<box/>"), "<'box'>: size must be 3 numbers, but is 'nothing'."),
        (link('<cone radius="1"/>'), "<'cone'> is no shape; allowed are box, cylinder, sphere and mesh."),
        (link(""), "a <collision> has no <geometry>."),
        (link(CYLINDER, origin='<origin rpy="a b c"/>'), "rpy must be 3 numbers, but is 'a b c'."),
        (
            link('<mesh filename="x.fbx"/>'),
            "mesh 'x.fbx' is of no kind that is read (.stl, .obj, .ply, .dae); convert it.",
        ),
        (link('<mesh filename="bomb.dae"/>'), "mesh bomb.dae has a document type or entities, which are not allowed"),
        (link('<mesh filename="broken.dae"/>'), "mesh broken.dae is broken and cannot be used"),
        (link('<mesh filename="x.stl"/>'), "mesh 'x.stl' is not in the model's folder or package; put it there."),
        (link('<mesh filename="/../../etc/x.stl"/>'), "is not in the model's folder or package; put it there."),
        (link('<mesh filename="package://../../x.stl"/>'), "is not in a folder '..' around the model; put it there."),
        (
            link('<mesh filename="package://fetch/x.stl"/>'),
            "is not in a folder 'fetch' around the model; put it there.",
        ),
        (
            link('<mesh filename="broken.stl"/>'),
            "mesh broken.stl holds no triangles; export it again as a triangle mesh.",
        ),
        (link('<mesh filename="broken.ply"/>'), "mesh broken.ply is broken and cannot be used: "),
        (
            '<xacro:macro xmlns:xacro="x"/>' + link(CYLINDER),
            "has xacro commands (<xacro:, line 2); run xacro first and give the plain URDF.",
        ),
        ("<link", "is not XML: not well-formed"),
        (link('<sphere radius="15"/>'), "height (metres) must be at most 20, but is 30"),
    ],
    ids=lambda value: value[:60] if not value.startswith("<") else "",
)
def test_wrong_models(tmp_path: Path, body: str, message: str) -> None:
    (tmp_path / "broken.stl").write_bytes(b"solid x\nfacet normal\n" + bytes(range(200)))
    (tmp_path / "broken.ply").write_bytes(b"ply\nformat")
    (tmp_path / "broken.dae").write_bytes(b"<COLLADA/>")
    (tmp_path / "bomb.dae").write_bytes(b'<!DOCTYPE x [<!ENTITY a "b">]><COLLADA>&a;</COLLADA>')
    with pytest.raises(AgentError) as caught:
        load_agent(write(tmp_path, body))
    assert message in str(caught.value)


def test_entities_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "bomb.urdf"
    path.write_text('<!DOCTYPE r [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;&a;">]><robot name="&b;"/>')
    with pytest.raises(AgentError, match="has a document type or entities, which are not allowed; remove them"):
        load_agent(path)


def test_other_encodings_do_not_smuggle_entities(tmp_path: Path) -> None:
    path = tmp_path / "bomb.urdf"
    path.write_bytes('<?xml version="1.0" encoding="utf-16"?><!DOCTYPE r [<!ENTITY a "a">]><robot/>'.encode("utf-16"))
    with pytest.raises(AgentError, match="is not UTF-8 text"):
        load_agent(path)


def test_not_a_robot(tmp_path: Path) -> None:
    path = tmp_path / "x.urdf"
    path.write_text("<sdf/>")
    with pytest.raises(
        AgentError, match="starts with <'sdf'>, but a URDF starts with <robot> and an MJCF with <mujoco>"
    ):
        load_agent(path)
    with pytest.raises(AgentError, match=r"agent file .*none\.urdf does not exist; check the path\."):
        load_agent(tmp_path / "none.urdf")


def test_a_deep_or_crowded_model_is_refused(tmp_path: Path) -> None:
    deep = tmp_path / "deep.urdf"
    deep.write_text("<robot>" + "<a>" * 100_000 + "</a>" * 100_000 + "</robot>")
    with pytest.raises(AgentError, match=r"is nested too deeply\. At most 64 levels are read"):
        load_agent(deep)
    many = '<link name="base">' + f"<collision><geometry>{CYLINDER}</geometry></collision>" * 2001 + "</link>"
    with pytest.raises(AgentError, match="has 2001 <link/collision> elements; at most 2000 are allowed"):
        load_agent(write(tmp_path, many))


def arm(limits: str, xyz: str = "0 0 0.5") -> str:
    """A disc with an arm of two boxes of 0.5 m; at zero it is stretched out ahead."""
    limit = f'<limit lower="{limits.split()[0]}" upper="{limits.split()[1]}" effort="1" velocity="1"/>'
    box = link('<box size="0.5 0.06 0.06"/>', "{}", '<origin xyz="0.25 0 0"/>')

    def hinge(parent: str, child: str, at: str) -> str:
        return (
            f'<joint name="{child}_joint" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="{at}"/><axis xyz="0 1 0"/>{limit}</joint>'
        )

    body = link('<cylinder radius="0.25" length="0.4"/>')
    return (
        body
        + box.format("upper")
        + box.format("gripper")
        + hinge("base", "upper", xyz)
        + hinge("upper", "gripper", "0.5 0 0")
    )


def test_an_arm_is_folded_over_the_base(tmp_path: Path) -> None:
    agent = load_agent(write(tmp_path, arm("-3.0 3.0")))
    assert agent.circumradius < 0.45  # stretched out it is 1 m
    assert "its arms folded" in agent.sources["radius"].text


def test_an_arm_that_cannot_fold_stays_out(tmp_path: Path) -> None:
    agent = load_agent(write(tmp_path, arm("-0.1 0.1")))
    assert agent.length == pytest.approx(1.25, abs=0.02)


def test_reach_is_what_the_hand_gets_to(tmp_path: Path) -> None:
    agent = load_agent(write(tmp_path, arm("-3.0 3.0")))
    assert agent.reach_distance is not None
    assert 0.3 < agent.reach_distance <= 0.5  # the gripper's own joint is 0.5 m from the shoulder
    assert max(agent.reach_bands, key=lambda band: band[2])[0] == pytest.approx(0.7, abs=0.11)
    assert agent.reach_high == pytest.approx(1.1, abs=0.1)
    assert "gripper" in agent.sources["reach_distance"].text


def test_an_arm_whose_last_link_has_no_telling_name_reaches_to_its_far_end(tmp_path: Path) -> None:
    agent = load_agent(write(tmp_path, arm("-3.0 3.0").replace("gripper", "link_2")))
    assert agent.reach_distance == pytest.approx(1.0, abs=0.03)  # two links of half a metre from the middle of the base
    assert agent.reach_high == pytest.approx(1.6, abs=0.1)


def test_a_profile_names_a_model_and_its_pose(tmp_path: Path) -> None:
    write(tmp_path, arm("-3.0 3.0"))
    profile = tmp_path / "mine.toml"
    profile.write_text('model = "robot.urdf"\nheight = 1.7\n[pose]\nupper_joint = -1.5708\n')
    agent = load_agent(profile)
    assert agent.height == 1.7
    assert agent.circumradius < 0.32  # straight up, 3 cm to each side
    profile.write_text('model = "robot.urdf"\n[pose]\nuper_joint = 0\n')
    with pytest.raises(UnknownNameError, match="upper_joint"):
        load_agent(profile)
    profile.write_text('model = "robot.urdf"\n[pose]\nupper_joint = 4\n')
    with pytest.raises(AgentError, match=r"upper_joint' \(radians or metres\) must be at most 3, but is 4\.0\.$"):
        load_agent(profile)


def test_a_car_needs_the_circle_that_it_steers(tmp_path: Path) -> None:
    def wheel(name: str, x: float, y: float, parent: str) -> str:
        return link('<cylinder radius="0.1" length="0.04"/>', name, '<origin rpy="1.5708 0 0"/>') + (
            f'<joint name="{name}_turn" type="continuous"><parent link="{parent}"/><child link="{name}"/>'
            f'<origin xyz="{x} {y} 0"/><axis xyz="0 1 0"/></joint>'
        )

    body = link('<box size="0.9 0.4 0.1"/>', origin='<origin xyz="0.3 0 0.1"/>') + wheel("rear", 0, 0.2, "base")
    body += '<link name="knuckle"/>' + wheel("front", 0, 0, "knuckle")
    body += (
        '<joint name="steer" type="revolute"><parent link="base"/><child link="knuckle"/><origin xyz="0.6 0.2 0"/>'
        '<axis xyz="0 0 1"/><limit lower="-0.5" upper="0.5" effort="1" velocity="1"/></joint>'
    )
    agent = load_agent(write(tmp_path, body))
    assert agent.turning_diameter is not None
    assert agent.turning_diameter > 2 * 0.6 / math.tan(0.5)
    assert agent.turning_radius == pytest.approx(0.6 / math.tan(0.5), abs=1e-3)
