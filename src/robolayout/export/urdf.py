"""URDF: the room as a robot description, for tools that load nothing else.

URDF cannot hold mesh vertices, and one file should be enough, so every part is a box: its own if it is one, else the box around it
in the asset's frame. The root link `room` is the floor and the walls; every asset is a link, fixed or floating.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET

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
from robolayout.export._mesh import as_box
from robolayout.export.mjcf import THINNEST, parse_xml
from robolayout.scene import Asset, Layout, Pose, Room, Scene

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
        _inertial(link, asset)
        for part in parts(asset, seed=options.seed):
            _shapes(link, part, f"{asset.name}/{part.name}")
        kind = "floating" if is_movable(asset, scene, layout) else "fixed"
        joint = ET.SubElement(robot, "joint", name=f"{asset.name}/joint", type=kind)
        ET.SubElement(joint, "parent", link=own)
        ET.SubElement(joint, "child", link=asset.name)
        ET.SubElement(joint, "origin", xyz=f"{pose.x!r} {pose.y!r} {pose.z!r}", rpy=f"0 0 {pose.yaw!r}")
    return dump_xml(robot)


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


def _inertial(link: ET.Element, asset: Asset) -> None:
    """Add mass and inertia of a solid box of the asset's size."""
    weight, (x, y, z) = mass(asset), asset.size
    inertial = ET.SubElement(link, "inertial")
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
        if origin is not None and child is not None:
            x, y, z = map(float, origin.get("xyz", "0 0 0").split())
            yaw = float(origin.get("rpy", "0 0 0").split()[2])
            poses[child.get("link", "")] = Pose(x, y, z, yaw)
    return Contents(Layout(poses))


URDF = Exporter("urdf", ".urdf", "the room as a robot description made of boxes", None, write, read)
