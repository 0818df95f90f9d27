"""MJCF: what MuJoCo loads; an XML file, and beside it the meshes that it shares with SDF and URDF.

Every asset is a body of its name. Parts that are boxes become box geoms, other convex parts meshes, which MuJoCo collides by
their hulls. Movable things on the floor or on other things have a free joint and a mass; what is fixed, on a wall or at the ceiling has
none. What of a thing moves (doors, drawers, lids) is a body inside its own, with a hinge or a slide and a site at its handle. The
floor collides as a plane. An agent, if asked for, is a planar base: two slides and a hinge whose positions are its world x, y and
yaw; each has an actuator whose control is how far it is to be from its start, so that with all controls at zero nothing moves.
The keyframe `home` is the layout.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from dataclasses import dataclass

import numpy as np

from robolayout.assets import Material
from robolayout.export._bodies import BODIES, DRAG, STICTION, BodyLink, BodyShape, BodyTree, Free, things
from robolayout.export._exporter import Exporter, Options, Rows, free_name, is_movable, reader, unique
from robolayout.export._mesh import numbers, quaternion
from robolayout.export._xml import dump_xml, parse_xml, rgba
from robolayout.scene import Agent, Figure, Layout, Pose, Scene

AGENT = "agent"


@dataclass(frozen=True)
class BaseConfig:
    """The planar base that moves a body in MuJoCo."""

    mass: float = 60.0  # kilograms of the planar base (a person; judgement)
    inside: float = 0.6  # metres inside the door at which a body starts if nothing is said, or more if it is longer
    stiffness: float = 20_000.0  # gain of its actuators in N/m (for the hinge N m/rad)
    damping: float = 2_200.0  # gain in N s/m (for the hinge N m s/rad): critically damped for its mass
    # metres by which its collider is smaller than the body: what a controller may stray from the planned line
    margin: float = 0.01


BASE = BaseConfig()


EMPTY = """
<mujoco>
  <compiler angle="radian" autolimits="true" boundmass="1e-4" boundinertia="1e-7"/>
  <option timestep="0.004" integrator="implicitfast" cone="elliptic" impratio="10" iterations="50" tolerance="1e-8"/>
  <statistic extent="6"/>
  <visual><headlight ambient="0.4 0.4 0.4" diffuse="0.2 0.2 0.2" specular="0.05 0.05 0.05"/></visual>
  <default>
    <default class="solid"><geom condim="4" solref="0.02 1" solimp="0.95 0.99 0.001"/></default>
    <default class="look"><geom contype="0" conaffinity="0" group="2" mass="0"/></default>
  </default>
  <asset/>
  <worldbody>
    <light directional="true" pos="0 0 6" dir="0.35 -0.25 -1" diffuse="0.4 0.4 0.4" specular="0.05 0.05 0.05"/>
  </worldbody>
  <contact/>
  <actuator/>
  <custom/>
</mujoco>"""
"""A model with options and classes only. Its solver is for quiet furniture: an elliptic cone with a high friction impedance does not
creep, and implicit integration keeps small light things calm."""


class _Model:
    """An XML tree and what was defined in it so far."""

    def __init__(self) -> None:
        self.root = ET.fromstring(EMPTY)
        self.home: list[float] = []
        self.looks: dict[Material, str] = {}
        self.meshes: dict[str, tuple[str, bytes]] = {}  # path and content by name

    def add(self, tag: str, element: str, said: dict[str, str]) -> ET.Element:
        """Add an element to a section."""
        return ET.SubElement(section(self.root, tag), element, said)


def section(root: ET.Element, tag: str) -> ET.Element:
    """Return a section of a model, which is added where it has none."""
    found = root.find(tag)
    return ET.SubElement(root, tag) if found is None else found


def build(
    scene: Scene, layout: Layout, options: Options, *, free: Free | None = is_movable
) -> tuple[bytes, dict[str, bytes]]:
    """Return the model as XML, with free joints for the assets that `free` says yes to, and its meshes by path.

    Where it is None all furniture holds still, and is one body with the world: MuJoCo takes a tenth of the time for that.
    """
    model = _Model()
    model.root.set("model", scene.name)
    if free is None:
        section(model.root, "compiler").set("fusestatic", "true")
    for thing in things(scene, layout, options, free=free):
        _body(model, thing)
        if thing.asset is not None:
            size = " ".join(map(repr, thing.asset.size))
            model.add("custom", "numeric", {"name": f"size/{thing.name}", "data": size})
            model.add("custom", "text", {"name": f"category/{thing.name}", "data": thing.asset.category})
    for name, line in options.routes.items():
        flat = " ".join(f"{value:.6g}" for point in line for value in point)
        model.add("custom", "text", {"name": f"route/{name}", "data": flat or "-"})
    if options.agent is not None:
        _agent(model, free_name(AGENT, scene), options.agent, options.whole, start(scene, options))
    controls = " ".join("0" * len(section(model.root, "actuator")))
    key = {"name": "home", "qpos": " ".join(map(repr, model.home)), "ctrl": controls}
    model.add("keyframe", "key", {name: text for name, text in key.items() if text})
    return dump_xml(model.root), dict(model.meshes.values())


def _body(model: _Model, thing: BodyTree) -> None:
    """Add a thing as a body, and one inside it for each joint; what moves does not collide with its own thing."""
    pose, half = thing.pose, thing.pose.yaw / 2
    place = {"pos": f"{pose.x!r} {pose.y!r} {pose.z!r}", "quat": f"{math.cos(half)!r} 0 0 {math.sin(half)!r}"}
    outer, folder = model.add("worldbody", "body", {"name": thing.name, **place}), thing.folder
    if thing.free:
        ET.SubElement(outer, "freejoint", name=thing.name)
        model.home += [pose.x, pose.y, pose.z, math.cos(half), 0.0, 0.0, math.sin(half)]
    names: list[str] = []
    for link in thing.links:
        body = outer if link.joint is None else _jointed(model, outer, f"{thing.name}/{link.joint.name}", link)
        own = body.get("name", "")
        for other in names:
            model.add("contact", "exclude", {"body1": own, "body2": other})
        names.append(own)
        for shape in link.shapes:
            _geom(model, body, thing, shape, folder)


def _jointed(model: _Model, outer: ET.Element, own: str, link: BodyLink) -> ET.Element:
    """Return the body of a link, with its joint and a site at its handle."""
    joint = link.joint
    assert joint is not None
    body = ET.SubElement(outer, "body", name=own, pos=numbers(joint.at))
    turns = {"range": numbers(joint.span), "axis": numbers(joint.axis), "damping": f"{DRAG[joint.kind]:g}"}
    stiff = {"frictionloss": f"{STICTION[joint.kind]:g}", "armature": "0.01"}
    ET.SubElement(body, "joint", {"name": own, "type": joint.kind, **turns, **stiff})
    handle = numbers((np.array(joint.handle) - link.at).tolist())
    ET.SubElement(body, "site", name=f"{own}/handle", pos=handle, size="0.01")
    model.home.append(0.0)
    return body


def _geom(model: _Model, body: ET.Element, thing: BodyTree, shape: BodyShape, folder: str) -> None:
    """Add a shape as a box or a mesh; the floor is a plane of the world, since Drake crashes at one of a body."""
    note = {"name": f"{thing.name}/{shape.name}", "class": "solid" if shape.touched else "look"}
    if shape.touched:
        note["friction"] = f"{thing.friction:.6g} 0.005 0.0001"
    if thing.asset is not None or shape.mass:  # a solid of an own mesh has none: what is seen of it has all
        note["mass"] = f"{shape.mass:.9g}"
    note |= {"material": _material(model, shape.part.material)} if shape.seen else {"rgba": "0 0 0 0"}
    box = shape.box
    if thing.asset is None and not shape.seen:
        body, note = section(model.root, "worldbody"), {**note, "type": "plane", "size": "0 0 0.1"}
    elif box is None:
        note |= {"type": "mesh", "mesh": shape.mesh}
        if shape.mesh not in model.meshes:
            path = f"{folder}/{shape.mesh}"
            model.meshes[shape.mesh] = path, shape.data
            model.add("asset", "mesh", {"name": shape.mesh, "file": path, "inertia": "convex"})
    else:
        note |= {"type": "box", "size": numbers(box.half.tolist()), "pos": numbers(box.center.tolist())}
        if not np.allclose(box.rotation, np.eye(3), atol=1e-12):
            note["quat"] = numbers(quaternion(box.rotation))
    ET.SubElement(body, "geom", note)


def _material(model: _Model, material: Material) -> str:
    """Return the name of a material; equal ones are stored once."""
    if material not in model.looks:
        name = model.looks[material] = unique(material.name, {*model.looks.values()}, "-")
        gloss = f"{(1 - material.roughness) / 2:.4g}"
        look = {"name": name, "rgba": rgba(material), "specular": gloss, "shininess": gloss}
        model.add("asset", "material", look)
    return model.looks[material]


def start(scene: Scene, options: Options) -> Pose:
    """Return where the agent starts: as it is said, else wholly inside the first door, or mid-room without one."""
    agent, room = options.agent, scene.room
    if options.start is not None:
        return options.start
    if room.doors:
        wall = room.walls[room.doors[0].wall]
        depth = max(BASE.inside, (agent.length or 2 * agent.radius) / 2 + BODIES.thinnest if agent else 0.0)
        return Pose(*wall.point(room.doors[0].center, depth), 0.0, math.atan2(wall.normal[1], wall.normal[0]))
    low_x, low_y, high_x, high_y = room.bounds
    return Pose((low_x + high_x) / 2, (low_y + high_y) / 2, 0.0, 0.0)


def _agent(model: _Model, own: str, agent: Agent, whole: bool, pose: Pose) -> None:
    """Add the planar base of an agent, and on it a robot's model if that is asked for, else its shape."""
    half, cosine, sine = pose.yaw / 2, math.cos(pose.yaw), math.sin(pose.yaw)
    turn = f"{math.cos(half)!r} 0 0 {math.sin(half)!r}"
    body = model.add("worldbody", "body", {"name": own, "pos": f"{pose.x!r} {pose.y!r} 0", "quat": turn})
    for name, kind, value, axis in (
        ("x", "slide", pose.x, f"{cosine!r} {-sine!r} 0"),
        ("y", "slide", pose.y, f"{sine!r} {cosine!r} 0"),
        ("yaw", "hinge", pose.yaw, "0 0 1"),
    ):
        joint = f"{own}/{name}"
        ET.SubElement(body, "joint", name=joint, type=kind, axis=axis, ref=repr(value))
        bias = f"{BASE.stiffness * value:.17g} {-BASE.stiffness:.6g} {-BASE.damping:.6g}"
        drive = {"gaintype": "fixed", "biastype": "affine", "joint": joint}
        model.add("actuator", "general", {"name": joint, **drive, "gainprm": f"{BASE.stiffness:.6g}", "biasprm": bias})
        model.home.append(value)
    if whole and agent.figure is not None:
        _robot(model, body, agent, agent.figure)
    else:
        _shape(body, own, agent)


def _robot(model: _Model, body: ET.Element, agent: Agent, figure: Figure) -> None:
    """Add a robot's model to its base."""
    from robolayout.export._whole import whole

    sections, robot, home, files = whole(agent, figure, body.get("name", ""))
    body.append(robot)
    for part in sections:
        section(model.root, part.tag).extend(part)
    for compiler in model.root.iter("compiler"):
        compiler.set("balanceinertia", "true")  # real files have inertias that no thing can have
    model.home += home
    model.meshes |= {path: (path, content) for path, content in files.items()}


def _shape(body: ET.Element, own: str, agent: Agent) -> None:
    """Add the shape of an agent above what it drives over, without friction: its joints carry it."""
    low = max(agent.step, 0.01)
    half = (agent.height - low) / 2
    shape = {"type": "cylinder", "size": f"{agent.radius:.9g} {half:.9g}"}
    if agent.length is not None and agent.width is not None:
        shape = {"type": "box", "size": f"{agent.length / 2:.9g} {agent.width / 2:.9g} {half:.9g}"}
    look = {"rgba": "0.15 0.45 0.75 0.6", "friction": "0 0 0", "condim": "1", "mass": f"{BASE.mass:.6g}"}
    ET.SubElement(body, "geom", {"name": f"{own}/body", "pos": f"0 0 {low + half:.9g}", **shape, **look})


@reader("MJCF file")
def read(data: bytes) -> Rows:
    """Yield the names, poses and sizes in a model that this package wrote."""
    root = parse_xml(data, "mujoco")
    kept = ((*entry.get("name", "").partition("/"), entry.get("data", "")) for entry in root.iter("numeric"))
    sizes = {name: size for kind, _, name, size in kept if kind == "size"}
    for body in root.iter("body"):
        name = body.get("name", "")
        if name in sizes:
            x, y, z = map(float, body.get("pos", "0 0 0").split())
            w, _, _, turn = map(float, body.get("quat", "1 0 0 0").split())
            yield name, Pose(x, y, z, 2 * math.atan2(turn, w)), map(float, sizes[name].split())


MJCF = Exporter(
    "mjcf", ".xml", "MuJoCo's XML: colliders, free joints, masses, the agent as a planar base", None, build, read
)
