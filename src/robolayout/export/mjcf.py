"""MJCF: what MuJoCo loads; one self-contained XML file, mesh vertices inside.

Every asset is a body of its name. Parts that are boxes become box geoms, other convex parts inline meshes, which MuJoCo collides by
their hulls. Movable things on the floor or on other things have a free joint and a mass; what is fixed, on a wall or at the ceiling has
none. What of a thing moves (doors, drawers, lids) is a body inside its own, with a hinge or a slide and a site at its handle. The
floor collides as a plane. An agent, if asked for, is a planar base: two slides and a hinge whose positions are its world x, y and
yaw; each has an actuator whose control is how far it is to be from its start, so that with all controls at zero nothing moves.
The keyframe `home` is the layout.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from robolayout._reading.syntax import Unreadable, decoded, xml_root
from robolayout.assets import Joint, Material, Part, category_of, parts, prisms_of, room_parts, turned
from robolayout.assets.mass import part_masses
from robolayout.assets.shapes import prism
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
from robolayout.export._mesh import Box, as_box, quaternion, volume
from robolayout.scene import Agent, Asset, Layout, Pose, Scene, vertical_span

THINNEST = 5e-4
"""Half thickness in metres that a collider has at least; thinner parts become boxes of that thickness."""

FOOT = 0.08
"""Share of a mesh's height that is pressed flat where it stands, so that pots and cushions with round bottoms stand."""

SMALLEST_VOLUME = 1e-8
"""Volume in cubic metres below which a part collides as its box."""

LEAF_MASS = 600.0
"""Kilograms per cubic metre of the leaf of a door: wood."""

AGENT = "agent"
AGENT_MASS = 60.0
"""Mass of the planar base in kg (a person; judgement)."""

INSIDE = 0.6
"""Metres inside the door at which a body starts if nothing is said, or more if it is longer."""
STICTION = {"hinge": 1.0, "slide": 5.0}
"""Friction of a joint of furniture in N m or N: what it takes to move a cabinet's door or drawer (judgement); a flap stays shut."""
DRAG = {"hinge": 0.5, "slide": 10.0}
"""Damping of such a joint in N m s/rad or N s/m."""

STIFFNESS, DAMPING = 20_000.0, 2_200.0
"""Gains of the base's actuators in N/m and N s/m (for the hinge N m/rad and N m s/rad): critically damped for its mass."""

Free = Callable[[Asset, Scene, Layout], bool]
"""Says whether an asset has a free joint."""


@dataclass
class _Model:
    """An XML tree with its sections and what was defined so far."""

    root: ET.Element
    assets: ET.Element
    world: ET.Element
    contact: ET.Element
    actuators: ET.Element
    home: list[float] = field(default_factory=list[float])
    known: dict[object, str] = field(default_factory=dict[object, str])


def write(scene: Scene, layout: Layout, options: Options) -> bytes:
    """Return the model with movable assets free."""
    return build(scene, layout, options, free=is_movable)


def build(scene: Scene, layout: Layout, options: Options, *, free: Free) -> bytes:
    """Return the model as XML, with free joints for the assets that `free` says yes to."""
    model = _start(scene)
    own = free_name("room", scene)
    room = ET.SubElement(model.world, "body", name=own)
    plane = {
        "name": f"{own}/floor",
        "type": "plane",
        "size": "0 0 0.1",
        "rgba": "0 0 0 0",
        "friction": "0.6 0.005 0.0001",
    }
    ET.SubElement(room, "geom", plane)
    shown = [part for part in room_parts(scene.room, seed=options.seed) if np.ptp(part.vertices[:, 2]) > THINNEST]
    bodies = _jointed(model, room, own, [_stood(part, options.leaves) for part in shown])
    for number, part in enumerate(shown):
        kind = "look" if is_trim(part) or part.name == "floor" else "fixed"
        note = {"name": f"{own}/{part.name}/{number}", "class": kind}
        weight = {"mass": f"{LEAF_MASS * volume(part):.9g}"} if part.joint in bodies else {}
        _geom(model, bodies.get(part.joint, room), _stood(part, options.leaves), note | weight)
    custom = ET.SubElement(model.root, "custom")
    for asset, pose in placed(scene, layout):
        _asset(model, asset, pose, seed=options.seed, free=free(asset, scene, layout))
        size = " ".join(map(repr, asset.size))
        ET.SubElement(custom, "numeric", name=f"size/{asset.name}", data=size)
        ET.SubElement(custom, "text", name=f"category/{asset.name}", data=asset.category)
    for name, line in options.routes.items():
        flat = " ".join(f"{value:.6g}" for point in line for value in point)
        ET.SubElement(custom, "text", name=f"route/{name}", data=flat or "-")
    _rugs(model, scene, layout)
    if options.agent is not None:
        _agent(model, free_name(AGENT, scene), options.agent, start(scene, options))
    key = {"name": "home", "qpos": " ".join(map(repr, model.home)), "ctrl": " ".join("0" * len(model.actuators))}
    ET.SubElement(ET.SubElement(model.root, "keyframe"), "key", {name: text for name, text in key.items() if text})
    return dump_xml(model.root)


def _start(scene: Scene) -> _Model:
    """Return an empty model with options and classes.

    Solver settings are for quiet furniture: an elliptic cone with a high friction impedance does not creep, and implicit
    integration keeps small light things calm.
    """
    root = ET.Element("mujoco", model=scene.name)
    ET.SubElement(root, "compiler", angle="radian", autolimits="true", boundmass="1e-4", boundinertia="1e-7")
    solver = {"timestep": "0.004", "integrator": "implicitfast", "cone": "elliptic", "impratio": "10"}
    ET.SubElement(root, "option", solver | {"iterations": "50", "tolerance": "1e-8"})
    ET.SubElement(root, "statistic", extent="6")
    lamp = {"ambient": "0.4 0.4 0.4", "diffuse": "0.2 0.2 0.2", "specular": "0.05 0.05 0.05"}
    ET.SubElement(ET.SubElement(root, "visual"), "headlight", lamp)
    classes = ET.SubElement(root, "default")
    for name, look in (
        ("free", {"condim": "4", "solref": "0.02 1", "solimp": "0.95 0.99 0.001"}),
        ("fixed", {"condim": "4", "solref": "0.02 1", "solimp": "0.95 0.99 0.001"}),
        ("look", {"contype": "0", "conaffinity": "0", "group": "2", "mass": "0"}),
    ):
        ET.SubElement(ET.SubElement(classes, "default", {"class": name}), "geom", look)
    assets = ET.SubElement(root, "asset")
    world = ET.SubElement(root, "worldbody")
    sun = {"directional": "true", "pos": "0 0 6", "dir": "0.35 -0.25 -1", "diffuse": "0.4 0.4 0.4"}
    ET.SubElement(world, "light", sun | {"specular": "0.05 0.05 0.05"})
    return _Model(root, assets, world, ET.SubElement(root, "contact"), ET.SubElement(root, "actuator"))


def _asset(model: _Model, asset: Asset, pose: Pose, *, seed: int, free: bool) -> None:
    """Add one asset as a body; its mass is shared among its parts by what they are made of; own meshes collide by their shape."""
    half = pose.yaw / 2
    place = {"pos": f"{pose.x!r} {pose.y!r} {pose.z!r}", "quat": f"{math.cos(half)!r} 0 0 {math.sin(half)!r}"}
    body = ET.SubElement(model.world, "body", {"name": asset.name, **place})
    if free:
        ET.SubElement(body, "freejoint", name=asset.name)
        model.home += [pose.x, pose.y, pose.z, math.cos(half), 0.0, 0.0, math.sin(half)]
    pieces = tuple(_footed(part, -asset.size[2] / 2) for part in parts(asset, seed=seed))
    bodies = _jointed(model, body, asset.name, pieces)
    weights = part_masses(pieces)[0]
    shares = (mass(asset) * weights / weights.sum()).tolist()
    friction = f"{category_of(asset).friction:.6g} 0.005 0.0001"
    kind = "look" if asset.is_flat else "free" if free else "fixed"
    for number, (part, share) in enumerate(zip(pieces, shares, strict=True)):
        note = {"name": f"{asset.name}/{part.name}/{number}", "class": kind if part.convex else "look"}
        if not asset.is_flat:
            note |= {"mass": f"{share:.9g}", "friction": friction}
        _geom(model, bodies.get(part.joint, body), part, note)
    if not (asset.is_flat or all(part.convex for part in pieces)):
        for number, shape in enumerate(prisms_of(asset)):
            span = (shape.low - asset.size[2] / 2, shape.high - asset.size[2] / 2)
            solid = prism("solid", pieces[0].material, [*dict.fromkeys(shape.outline)], span)
            note = {"name": f"{asset.name}/solid/{number}", "class": kind, "group": "3", "mass": "0"}
            _geom(model, body, solid, note | {"friction": friction})


def _stood(part: Part, leaves: str) -> Part:
    """Return a part of the room as its door stands: fixed, open or shut, unless it swings."""
    if part.joint is None or leaves == "swinging":
        return part
    far = part.joint.span[leaves == "open"]
    return replace(part, vertices=turned(part.joint, part.vertices, far), joint=None)


def _jointed(model: _Model, body: ET.Element, name: str, pieces: Sequence[Part]) -> Mapping[Joint | None, ET.Element]:
    """Add a body for each joint of a thing and return it by the joint; what moves does not collide with its own thing."""
    bodies: dict[Joint | None, ET.Element] = {}
    for joint in dict.fromkeys(part.joint for part in pieces if part.joint is not None):
        own = f"{name}/{joint.name}"
        bodies[joint] = ET.SubElement(body, "body", name=own)
        place = {"axis": _numbers(np.array(joint.axis)), "pos": _numbers(np.array(joint.at))}
        turns = {"range": _numbers(np.array(joint.span)), "damping": f"{DRAG[joint.kind]:g}"}
        stiff = {"frictionloss": f"{STICTION[joint.kind]:g}", "armature": "0.01"}
        ET.SubElement(bodies[joint], "joint", {"name": own, "type": joint.kind, **place, **turns, **stiff})
        ET.SubElement(bodies[joint], "site", name=f"{own}/handle", pos=_numbers(np.array(joint.handle)), size="0.01")
        for other in (name, *(str(item.get("name")) for key, item in bodies.items() if key != joint)):
            ET.SubElement(model.contact, "exclude", body1=own, body2=other)
        model.home.append(0.0)
    return bodies


def _geom(model: _Model, body: ET.Element, part: Part, note: dict[str, str]) -> None:
    """Add a part as a box if it is one or is too thin for a hull, else as an inline mesh."""
    box = as_box(part) or (_bounds(part) if volume(part) < SMALLEST_VOLUME or _is_thin(part) else None)
    note |= {"material": _material(model, part.material)}
    if box is None:
        ET.SubElement(body, "geom", {**note, "type": "mesh", "mesh": _mesh(model, part)})
        return
    half = np.maximum(box.half, THINNEST)
    place = {"type": "box", "size": _numbers(half), "pos": _numbers(box.center)}
    if not np.allclose(box.rotation, np.eye(3), atol=1e-12):
        place["quat"] = _numbers(np.array(quaternion(box.rotation)))
    ET.SubElement(body, "geom", {**note, **place})


def _footed(part: Part, bottom: float) -> Part:
    """Return a part that stands on the bottom of its asset with a flat foot; any other part as it is."""
    heights = part.vertices[:, 2]
    if heights.min() > bottom + THINNEST:
        return part
    low = heights < heights.min() + FOOT * np.ptp(heights)
    vertices = part.vertices.copy()
    vertices[low, 2] = heights.min()
    return replace(part, vertices=vertices)


def _is_thin(part: Part) -> bool:
    """Return whether a part is thinner than a collider may be."""
    return bool(np.ptp(part.vertices, axis=0).min() < 2 * THINNEST)


def _bounds(part: Part) -> Box:
    """Return the axis-aligned box around a part."""
    low, high = part.vertices.min(axis=0), part.vertices.max(axis=0)
    return Box((low + high) / 2, (high - low) / 2, np.eye(3))


def _numbers(values: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> str:
    """Return numbers with nine digits, separated by blanks."""
    return " ".join(f"{value + 0.0:.9g}" for value in values.reshape(-1).tolist())


def _mesh(model: _Model, part: Part) -> str:
    """Return the name of an inline mesh; equal ones are stored once."""
    vertices = _numbers(part.vertices)
    key = ("mesh", vertices)
    if key not in model.known:
        model.known[key] = f"mesh-{sum(isinstance(k, tuple) and 'mesh' in k for k in model.known)}"
        faces = " ".join(map(str, part.faces.reshape(-1).tolist()))
        content = {"name": model.known[key], "vertex": vertices, "face": faces, "inertia": "convex"}
        ET.SubElement(model.assets, "mesh", content)
    return model.known[key]


def _material(model: _Model, material: Material) -> str:
    """Return the name of a material; equal ones are stored once."""
    if material not in model.known:
        taken = set(model.known.values())
        name, number = material.name, 2
        while name in taken:
            name, number = f"{material.name}-{number}", number + 1
        model.known[material] = name
        color = " ".join(f"{value:.4g}" for value in (*material.color, material.opacity))
        gloss = f"{(1 - material.roughness) / 2:.4g}"
        ET.SubElement(model.assets, "material", name=name, rgba=color, specular=gloss, shininess=gloss)
    return model.known[material]


def _rugs(model: _Model, scene: Scene, layout: Layout) -> None:
    """Let things that stand on a rug touch it; rugs collide with nothing else, since furniture stands through them."""
    rows = placed(scene, layout)
    for rug, place in rows:
        top = vertical_span(rug, place)[1]
        for asset, pose in rows:
            if (
                rug.is_flat
                and not asset.is_flat
                and top > THINNEST * 4
                and abs(vertical_span(asset, pose)[0] - top) < 0.003
            ):
                _pair(model, rug, asset)


def _pair(model: _Model, rug: Asset, asset: Asset) -> None:
    """Add contacts between all geoms of a rug and all of an asset."""
    geoms = {
        body.get("name"): [str(geom.get("name")) for geom in body.iter("geom")] for body in model.world.iter("body")
    }
    for first in geoms[rug.name]:
        for second in geoms[asset.name]:
            ET.SubElement(model.contact, "pair", geom1=first, geom2=second, condim="4")


def start(scene: Scene, options: Options) -> Pose:
    """Return where the agent starts: as it is said, else wholly inside the first door, or mid-room without one."""
    agent, room = options.agent, scene.room
    if options.start is not None:
        return options.start
    if room.doors:
        wall = room.walls[room.doors[0].wall]
        depth = max(INSIDE, (agent.length or 2 * agent.radius) / 2 + THINNEST if agent else 0.0)
        return Pose(*wall.point(room.doors[0].center, depth), 0.0, math.atan2(wall.normal[1], wall.normal[0]))
    low_x, low_y, high_x, high_y = room.bounds
    return Pose((low_x + high_x) / 2, (low_y + high_y) / 2, 0.0, 0.0)


def _agent(model: _Model, own: str, agent: Agent, pose: Pose) -> None:
    """Add the planar base of an agent, above what it drives over, without friction: its joints carry it."""
    low = max(agent.step, 0.01)
    half = (agent.height - low) / 2
    half_yaw = pose.yaw / 2
    turn = f"{math.cos(half_yaw)!r} 0 0 {math.sin(half_yaw)!r}"
    body = ET.SubElement(model.world, "body", name=own, pos=f"{pose.x!r} {pose.y!r} 0", quat=turn)
    joints = {"x": ("slide", pose.x), "y": ("slide", pose.y), "yaw": ("hinge", pose.yaw)}
    axes = {
        "x": f"{math.cos(pose.yaw)!r} {-math.sin(pose.yaw)!r} 0",
        "y": f"{math.sin(pose.yaw)!r} {math.cos(pose.yaw)!r} 0",
    }
    for name, (kind, value) in joints.items():
        axis = axes.get(name, "0 0 1")
        ET.SubElement(body, "joint", name=f"{own}/{name}", type=kind, axis=axis, ref=repr(value))
        gains = {"gainprm": f"{STIFFNESS:.6g}", "biasprm": f"{STIFFNESS * value:.17g} {-STIFFNESS:.6g} {-DAMPING:.6g}"}
        drive = {"gaintype": "fixed", "biastype": "affine", "joint": f"{own}/{name}"}
        ET.SubElement(model.actuators, "general", {"name": f"{own}/{name}", **drive, **gains})
        model.home.append(value)
    shape = {"type": "cylinder", "size": f"{agent.radius:.9g} {half:.9g}"}
    if agent.length is not None and agent.width is not None:
        shape = {"type": "box", "size": f"{agent.length / 2:.9g} {agent.width / 2:.9g} {half:.9g}"}
    look = {"rgba": "0.15 0.45 0.75 0.6", "friction": "0 0 0", "condim": "1", "mass": f"{AGENT_MASS:.6g}"}
    ET.SubElement(body, "geom", {"name": f"{own}/body", "pos": f"0 0 {low + half:.9g}", **shape, **look})


@reader("MJCF file")
def read(data: bytes) -> Contents:
    """Return the names, poses and sizes in a model that this package wrote.

    Raises:
        LayoutError: The bytes are no MJCF, or declare entities.
    """
    root = parse_xml(data, "mujoco")
    sizes: dict[str, tuple[float, float, float]] = {}
    for entry in root.iter("numeric"):
        kind, _, name = entry.get("name", "").partition("/")
        if kind == "size":
            depth, width, height = map(float, entry.get("data", "").split())
            sizes[name] = (depth, width, height)
    poses: dict[str, Pose] = {}
    for body in root.iter("body"):
        name = body.get("name", "")
        if name in sizes:
            x, y, z = map(float, body.get("pos", "0 0 0").split())
            w, _, _, turn = map(float, body.get("quat", "1 0 0 0").split())
            poses[name] = Pose(x, y, z, 2 * math.atan2(turn, w))
    return Contents(Layout(poses), sizes)


def parse_xml(data: bytes, root: str) -> ET.Element:
    """Return the root element of XML text that declares no document type (and so no entities).

    Raises:
        Unreadable: It does, or it is no such XML.
    """
    element = xml_root(decoded(data))
    if element.tag != root:
        raise Unreadable(f"must start with <{root}>, not <{element.tag[:60]}>")
    return element


MJCF = Exporter(
    "mjcf", ".xml", "MuJoCo's XML: colliders, free joints, masses, the agent as a planar base", None, write, read
)
