"""Links and joints of a robot's URDF model."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import replace
from xml.etree.ElementTree import Element

import numpy as np
from scipy.spatial.transform import Rotation

from robolayout._reading import show
from robolayout.scene._model import Matrix, Model, ball, box, cylinder, transform
from robolayout.scene.kinematics import Kind, Robot, RobotJoint, hulls


def read_urdf(robot: Element, text: str, model: Model) -> Robot:
    """Return the robot of a URDF file, given as its root element and its text."""
    plain = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
    if command := re.search(r"<xacro:|\$\{|\$\(", plain):
        line = text[: text.index(command[0])].count("\n") + 1
        raise model.fail(f"has xacro commands ({command[0]}, line {line}); run xacro first and give the plain URDF.")
    elements = _children(robot, "link", model)
    links = {link.get("name") or "": link for link in elements}
    if len(links) < len(elements):
        raise model.fail("has two links of one name; give each its own.")
    root, joints = _tree(robot, links, model)
    if not _children(robot, "link/collision", model):
        raise model.fail("no link has collision geometry, so the body has no size; add <collision> elements.")
    clouds = {name: [_points(shape, model) for shape in link.findall("collision")] for name, link in links.items()}
    return Robot(robot.get("name") or model.path.stem, root, joints, hulls(clouds))


def _children(element: Element, tag: str, model: Model) -> list[Element]:
    found = element.findall(tag)
    model.count(tag, len(found))
    return found


def _origin(element: Element, model: Model) -> Matrix:
    """Return the 4 x 4 transform of an element's <origin>: fixed-axis roll, pitch, yaw and translation."""
    origin = element.find("origin")
    if origin is None:
        return np.eye(4)
    where = f"origin of <{element.tag}>"
    turn = Rotation.from_euler("xyz", model.numbers(origin.get("rpy"), f"{where}, rpy", 3))
    return transform(model.numbers(origin.get("xyz"), f"{where}, xyz", 3), turn)


def _tree(robot: Element, links: Mapping[str, Element], model: Model) -> tuple[str, tuple[RobotJoint, ...]]:
    joints: dict[str, list[RobotJoint]] = {}
    parents: dict[str, str] = {}
    for element in _children(robot, "joint", model):
        joint = _joint(element, model)
        for end in (joint.parent, joint.child):
            if end not in links:
                raise model.fail(f"joint {show(joint.name)} names the link {show(end)}, which does not exist.")
        if joint.child in parents:
            raise model.fail(f"link {show(joint.child)} has two parents; a URDF is a tree.")
        parents[joint.child] = joint.parent
        joints.setdefault(joint.parent, []).append(joint)
    roots = [name for name in links if name not in parents]
    if len(roots) != 1:
        raise model.fail(f"has {len(roots)} root links; a URDF has exactly one link that is no joint's child.")
    if roots[0] == "world" and len(held := joints.get("world", [])) == 1 and links["world"].find("collision") is None:
        at = held[0].origin.copy()
        at[:3, 3] = 0.0  # where in a world it is put is not of the robot
        joints["world"] = [replace(held[0], origin=at)]
    ordered, waiting = list[RobotJoint](), [roots[0]]
    while waiting:
        further = joints.get(waiting.pop(), [])
        ordered += further
        waiting += [joint.child for joint in further]
    if len(ordered) + 1 < len(links):
        found = {roots[0], *(joint.child for joint in ordered)}
        raise model.fail(f"link {show(next(n for n in links if n not in found))} is part of a loop of joints.")
    return roots[0], tuple(ordered)


def _joint(element: Element, model: Model) -> RobotJoint:
    """Return one joint; what has no range does not move, and floating and planar joints are fixed."""
    ends = [(end.get("link") or "") if (end := element.find(tag)) is not None else "" for tag in ("parent", "child")]
    name, kind = element.get("name") or "", element.get("type")
    where = f"joint {show(name)}"
    axis, limit, mimic = (element.find(tag) for tag in ("axis", "limit", "mimic"))
    along = np.array(model.numbers(None if axis is None else axis.get("xyz"), f"{where}, axis", 3))
    along = along / length if (length := float(np.linalg.norm(along))) > 0 else np.array([1.0, 0.0, 0.0])
    turn = (-math.pi, math.pi) if kind == "continuous" else (0.0, 0.0)
    low, high = (
        turn
        if limit is None or kind == "continuous"
        else (model.numbers(limit.get(end) or "0", f"{where}, limit", 1)[0] for end in ("lower", "upper"))
    )
    follows = None
    if mimic is not None:
        usual = {"multiplier": "1", "offset": "0"}
        factor, offset = (
            model.numbers(mimic.get(key) or plain, f"{where}, mimic", 1)[0] for key, plain in usual.items()
        )
        follows = (mimic.get("joint") or "", factor, offset)
    moves: Kind = "prismatic" if kind == "prismatic" else "revolute" if kind in ("revolute", "continuous") else "fixed"
    return RobotJoint(name, ends[0], ends[1], _origin(element, model), moves, along, low, max(low, high), follows)


def _points(collision: Element, model: Model) -> Matrix:
    """Return points (n, 3) on a collision shape, in the frame of its link."""
    geometry = collision.find("geometry")
    shape = next(iter(geometry), None) if geometry is not None else None
    if shape is None:
        raise model.fail("a <collision> has no <geometry>.")
    where = f"<{show(shape.tag)}>"
    if shape.tag == "box":
        local = box([side / 2 for side in model.sizes(shape.get("size"), f"{where}: size", 3)])
    elif shape.tag in ("cylinder", "sphere"):
        (radius,) = model.sizes(shape.get("radius"), f"{where}: radius", 1)
        length = model.sizes(shape.get("length"), f"{where}: length", 1) if shape.tag == "cylinder" else None
        local = cylinder(radius, length[0] / 2) if length else ball((radius, radius, radius))
    elif shape.tag == "mesh":
        scale = model.numbers(shape.get("scale") or "1 1 1", f"{where}: scale", 3)
        local = model.mesh(shape.get("filename") or "") * np.array(scale)
    else:
        raise model.fail(f"<{show(shape.tag)}> is no shape; allowed are box, cylinder, sphere and mesh.")
    return model.placed(local, _origin(collision, model))
