"""URDF: the room as a robot that is welded to the world, and each thing that a person can move as one of its own.

URDF has no scenes, so `<place>` elements, which other readers pass over, say where every asset is, and which file a movable one is
loaded from. What is fixed is part of the room's robot. Meshes are files in the folders of the things.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET

from robolayout.export._bodies import DRAG, STICTION, BodyLink, BodyShape, BodyTree, things
from robolayout.export._exporter import Bundle, Exporter, Options, Rows, free_name, reader
from robolayout.export._mesh import numbers
from robolayout.export._xml import DRAKE, STIFF, Tree, dump_xml, facts, moments, parse_xml, pose_of, put, rgba
from robolayout.scene import Layout, Scene

LIMIT = {"@effort": "100", "@velocity": "2"}
"""Greatest force or torque and speed of a joint of furniture (N or N m, m/s or rad/s), which URDF asks for; nothing comes near."""

MUJOCO = {"@discardvisual": "false", "@strippath": "false", "@balanceinertia": "true", "@fusestatic": "false"}
"""What MuJoCo is told: to look for meshes where they are, and to keep every link."""


def make(scene: Scene, layout: Layout, options: Options) -> Bundle:
    """Return the room with all that is fixed to it, and by path the meshes of all things and the robots of those that are free."""
    robot, world, files = _robot(scene.name), free_name("world", scene), dict[str, bytes]()
    put(robot, "link", {"@name": world})
    for thing in things(scene, layout, options):
        pose, folder = thing.pose, thing.folder
        origin = {"@xyz": f"{pose.x!r} {pose.y!r} {pose.z!r}", "@rpy": f"0 0 {pose.yaw!r}"}
        if thing.asset is not None:
            file = {"@file": f"{folder}/model.urdf"} if thing.free else {}
            put(robot, "place", {**facts(thing.asset), **origin, **file})
        files |= {f"{folder}/{path}": data for path, data in thing.meshes().items()}
        if thing.free:
            own = _robot(folder.rpartition("/")[2])
            _links(own, thing, "body", "")
            files[f"{folder}/model.urdf"] = dump_xml(own)
        else:
            _links(robot, thing, thing.name, f"{folder}/")
            _joint(robot, thing.name, world, {"@type": "fixed", "origin": origin})
    return dump_xml(robot), files


def _robot(name: str) -> ET.Element:
    robot = ET.Element("robot", {"name": name, "xmlns:drake": DRAKE})
    put(robot, "mujoco", {"compiler": MUJOCO})
    return robot


def _links(robot: ET.Element, thing: BodyTree, base: str, folder: str) -> None:
    """Add the links of a thing and the joints between them."""
    for link in thing.links:
        joint = link.joint
        name = base if joint is None else f"{base}/{joint.name}"
        grip = {"contact": {"lateral_friction": {"@value": numbers([thing.friction])}}}
        element = put(robot, "link", {"@name": name, **_inertial(link), **grip})
        for shape in link.shapes:
            _shape(element, shape, folder, thing.friction)
        if joint is not None:
            rest = {
                "@type": "revolute" if joint.kind == "hinge" else "prismatic",
                "origin": {"@xyz": numbers(joint.at), "@rpy": "0 0 0"},
                "axis": {"@xyz": numbers(joint.axis)},
                "limit": {"@lower": numbers(joint.span[:1]), "@upper": numbers(joint.span[1:]), **LIMIT},
                "dynamics": {"@damping": f"{DRAG[joint.kind]:g}", "@friction": f"{STICTION[joint.kind]:g}"},
            }
            _joint(robot, name, base, rest)


def _joint(robot: ET.Element, child: str, parent: str, rest: Tree) -> None:
    """Add a joint between two links."""
    put(robot, "joint", {"@name": f"{child}/joint", "parent": {"@link": parent}, "child": {"@link": child}, **rest})


def _inertial(link: BodyLink) -> Tree:
    weight, middle, inertia = link.inertia()
    origin, values = {"@xyz": numbers(middle.tolist()), "@rpy": "0 0 0"}, moments(inertia)
    entries = {f"@{name}": value for name, value in values.items()}
    return {"inertial": {"origin": origin, "mass": {"@value": numbers([weight])}, "inertia": entries}} if weight else {}


def _shape(link: ET.Element, shape: BodyShape, folder: str, friction: float) -> None:
    """Add what is seen and what is touched of a shape."""
    material, grip = shape.part.material, {"@value": numbers([friction])}
    name = f"{link.get('name')}/{shape.name}"
    more: dict[str, Tree] = {
        "visual": {"material": {"@name": f"{name}/{material.name}", "color": {"@rgba": rgba(material)}}},
        "collision": {
            "drake:proximity_properties": {
                "drake:mu_static": grip,
                "drake:mu_dynamic": grip,
                "drake:compliant_hydroelastic": {},
                "drake:hydroelastic_modulus": {"@value": STIFF},
            }
        },
    }
    mesh = {"@filename": f"{folder}{shape.mesh}", "drake:declare_convex": {}}
    at, turn, size = shape.place()
    for kind in shape.kinds:
        geometry = {"box": {"@size": size}} if size else {"mesh": mesh}
        origin = {"@xyz": at, "@rpy": turn}
        put(link, kind, {"@name": f"{name}/{kind}", "origin": origin, "geometry": geometry, **more[kind]})


@reader("URDF file")
def read(data: bytes) -> Rows:
    """Yield the names, poses and sizes in a description that this package wrote."""
    for place in parse_xml(data, "robot").iter("place"):
        row = place.attrib
        yield row["name"], pose_of(f"{row['xyz']} {row['rpy']}"), map(float, row["size"].split())


URDF = Exporter("urdf", ".urdf", "robots: the room with what is fixed, and each movable thing", None, make, read)
