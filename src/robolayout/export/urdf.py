"""URDF: the room as a robot description, for tools that load nothing else.

URDF cannot hold mesh vertices, and one file should be enough, so every part is a box: its own if it is one, else the box around it
in the asset's frame. The root link `room` is the floor and the walls; every asset is a link, fixed or floating, and what of it moves is
a link on a revolute or prismatic joint.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from robolayout.assets import Material, Part, parts, room_parts
from robolayout.export._exporter import (
    Contents,
    Exporter,
    Options,
    dump_xml,
    free_name,
    is_movable,
    is_trim,
    mass,
    placed,
    reader,
)
from robolayout.export._mesh import as_box, volume
from robolayout.export.mjcf import DRAG, LEAF_MASS, SMALLEST_VOLUME, STICTION, THINNEST, parse_xml
from robolayout.scene import Layout, Pose, Room, Scene

EFFORT, SPEED = 100.0, 2.0
"""Greatest force or torque and speed of a joint of furniture (N or N m, m/s or rad/s), which URDF asks for; nothing comes near."""

SLAB = 0.1
"""Thickness of the floor in metres."""


def write(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the room and all placed assets as one robot description."""
    robot = ET.Element("robot", name=scene.name)
    hints = ET.SubElement(robot, "mujoco")
    ET.SubElement(hints, "compiler", discardvisual="false", balanceinertia="true")
    own = free_name("room", scene)
    room = ET.SubElement(robot, "link", name=own)
    pieces = room_parts(scene.room, seed=options.seed)
    _floor(room, scene.room, next(part.material for part in pieces if part.name == "floor"))
    for part in pieces:
        if part.name != "floor" and not is_trim(part):
            _shapes(room, part, f"room/{part.name}")
    for asset, pose in placed(scene, layout):
        link = ET.SubElement(robot, "link", name=asset.name)
        _inertial(link, mass(asset), asset.size)
        for part in _hung(robot, asset.name, parts(asset, seed=options.seed)):
            _shapes(link, part, f"{asset.name}/{part.name}")
        kind = "floating" if is_movable(asset, scene, layout) else "fixed"
        joint = ET.SubElement(robot, "joint", name=f"{asset.name}/joint", type=kind)
        ET.SubElement(joint, "parent", link=own)
        ET.SubElement(joint, "child", link=asset.name)
        ET.SubElement(joint, "origin", xyz=f"{pose.x!r} {pose.y!r} {pose.z!r}", rpy=f"0 0 {pose.yaw!r}")
    return dump_xml(robot)


def _hung(robot: ET.Element, name: str, pieces: tuple[Part, ...]) -> list[Part]:
    """Add a link and its joint for each group of parts that moves, and return the parts that do not."""
    for joint in dict.fromkeys(part.joint for part in pieces if part.joint is not None):
        own, group = f"{name}/{joint.name}", [part for part in pieces if part.joint == joint]
        link = ET.SubElement(robot, "link", name=own)
        points = np.concatenate([part.vertices for part in group])
        weight = LEAF_MASS * sum(max(volume(part), SMALLEST_VOLUME) for part in group)
        x, y, z = np.ptp(points, axis=0).tolist()
        _inertial(link, weight, (x, y, z), (points.min(axis=0) + points.max(axis=0)) / 2 - joint.at)
        for part in group:
            _shapes(link, replace(part, vertices=part.vertices - joint.at), f"{name}/{part.name}")
        turns = joint.kind == "hinge"
        made = ET.SubElement(robot, "joint", name=f"{own}/joint", type="revolute" if turns else "prismatic")
        ET.SubElement(made, "parent", link=name)
        ET.SubElement(made, "child", link=own)
        ET.SubElement(made, "origin", xyz=_numbers(joint.at), rpy="0 0 0")
        ET.SubElement(made, "axis", xyz=_numbers(joint.axis))
        low, high = joint.span
        limits = {"lower": f"{low:.9g}", "upper": f"{high:.9g}", "effort": f"{EFFORT:g}", "velocity": f"{SPEED:g}"}
        ET.SubElement(made, "limit", limits)
        ET.SubElement(made, "dynamics", damping=f"{DRAG[joint.kind]:g}", friction=f"{STICTION[joint.kind]:g}")
    return [part for part in pieces if part.joint is None]


def _numbers(values: Iterable[float]) -> str:
    return " ".join(f"{value + 0.0:.9g}" for value in values)


def _floor(link: ET.Element, room: Room, material: Material) -> None:
    """Add the floor as one slab under the whole room's bounds, its top at zero."""
    low_x, low_y, high_x, high_y = room.bounds
    for kind in ("visual", "collision"):
        shape = ET.SubElement(link, kind)
        middle = f"{(low_x + high_x) / 2:.9g} {(low_y + high_y) / 2:.9g} {-SLAB / 2:.9g}"
        ET.SubElement(shape, "origin", xyz=middle, rpy="0 0 0")
        size = f"{high_x - low_x + SLAB:.9g} {high_y - low_y + SLAB:.9g} {SLAB:.9g}"
        ET.SubElement(ET.SubElement(shape, "geometry"), "box", size=size)
        _color(shape, "room/floor", material)


def _inertial(
    link: ET.Element, weight: float, size: tuple[float, float, float], middle: Iterable[float] = (0.0, 0.0, 0.0)
) -> None:
    """Add mass and inertia of a solid box of some size."""
    x, y, z = size
    inertial = ET.SubElement(link, "inertial")
    ET.SubElement(inertial, "origin", xyz=_numbers(middle), rpy="0 0 0")
    ET.SubElement(inertial, "mass", value=f"{weight:.9g}")
    moments = {"ixx": y * y + z * z, "iyy": x * x + z * z, "izz": x * x + y * y}
    rows = {name: f"{weight * value / 12:.9g}" for name, value in moments.items()}
    ET.SubElement(inertial, "inertia", rows | {"ixy": "0", "ixz": "0", "iyz": "0"})


def _shapes(link: ET.Element, part: Part, name: str) -> None:
    """Add a part as the same box to be seen and to be touched."""
    box = as_box(part)
    low, high = part.vertices.min(axis=0), part.vertices.max(axis=0)
    center, half, turn = (low + high) / 2, (high - low) / 2, (0.0, 0.0, 0.0)
    if box is not None:
        center, half, turn = box.center, box.half, _angles(box.rotation)
    size = " ".join(f"{value:.9g}" for value in (2 * np.maximum(half, THINNEST)).tolist())
    place = {"xyz": " ".join(f"{value + 0.0:.9g}" for value in center.tolist())}
    place["rpy"] = " ".join(f"{value + 0.0:.9g}" for value in turn)
    for kind in ("visual", "collision"):
        shape = ET.SubElement(link, kind)
        ET.SubElement(shape, "origin", place)
        ET.SubElement(ET.SubElement(shape, "geometry"), "box", size=size)
        _color(shape, name, part.material)


def _color(shape: ET.Element, name: str, material: Material) -> None:
    """Give a visual its colour."""
    if shape.tag == "visual":
        look = ET.SubElement(shape, "material", name=f"{name}/{material.name}")
        rgba = " ".join(f"{value:.4g}" for value in (*material.color, material.opacity))
        ET.SubElement(look, "color", rgba=rgba)


def _angles(rotation: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> tuple[float, float, float]:
    """Return roll, pitch and yaw in radians of a rotation matrix (turned about the fixed x, then y, then z)."""
    pitch = math.asin(min(1.0, max(-1.0, -float(rotation[2, 0]))))
    if abs(rotation[2, 0]) > 1 - 1e-12:
        return (0.0, pitch, math.atan2(-float(rotation[0, 1]), float(rotation[1, 1])))
    roll = math.atan2(float(rotation[2, 1]), float(rotation[2, 2]))
    return (roll, pitch, math.atan2(float(rotation[1, 0]), float(rotation[0, 0])))


@reader("URDF file")
def read(data: bytes) -> Contents:
    """Return the names and poses in a description that this package wrote."""
    poses: dict[str, Pose] = {}
    for joint in parse_xml(data, "robot").iter("joint"):
        origin, child = joint.find("origin"), joint.find("child")
        if origin is not None and child is not None and joint.get("type") in ("fixed", "floating"):
            x, y, z = map(float, origin.get("xyz", "0 0 0").split())
            yaw = float(origin.get("rpy", "0 0 0").split()[2])
            poses[child.get("link", "")] = Pose(x, y, z, yaw)
    return Contents(Layout(poses))


URDF = Exporter("urdf", ".urdf", "the room as a robot description made of boxes", None, write, read)
