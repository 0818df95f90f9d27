"""Agents from URDF models: the footprint and height of their collision geometry."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
import trimesh

from robolayout._errors import AgentError
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
        (link('<mesh filename="x.dae"/>'), "mesh 'x.dae' is of no kind that is read (.stl, .obj, .ply); convert it."),
        (link('<mesh filename="x.stl"/>'), "mesh 'x.stl' is not in the model's folder or package; put it there."),
        (link('<mesh filename="/../../etc/x.stl"/>'), "is not in the model's folder or package; put it there."),
        (link('<mesh filename="package://../../x.stl"/>'), "is not in the model's folder or package; put it there."),
        (
            link('<mesh filename="broken.stl"/>'),
            "mesh broken.stl holds no triangles; export it again as a triangle mesh.",
        ),
        (link('<mesh filename="broken.ply"/>'), "mesh broken.ply is broken and cannot be used: "),
        (
            '<xacro:macro xmlns:xacro="x"/>' + link(CYLINDER),
            "has xacro commands; run xacro first and give the plain URDF.",
        ),
        ("<link", "is not XML: not well-formed"),
        (link('<sphere radius="15"/>'), "height (metres) must be at most 20, but is 30"),
    ],
    ids=lambda value: value[:60] if not value.startswith("<") else "",
)
def test_wrong_models(tmp_path: Path, body: str, message: str) -> None:
    (tmp_path / "broken.stl").write_bytes(b"solid x\nfacet normal\n" + bytes(range(200)))
    (tmp_path / "broken.ply").write_bytes(b"ply\nformat")
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
    path.write_text("<mujoco/>")
    with pytest.raises(AgentError, match="starts with <'mujoco'>, but a URDF starts with <robot>"):
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
