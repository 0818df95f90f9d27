"""SDF: a world for Gazebo and Drake, and a model folder for each kind of thing beside it.

The world says where everything is; `models/<kind>/` holds a kind's `model.config`, `model.sdf` and meshes. What nobody can move is
static, or welded to the world where something of it moves.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

from robolayout._text import xml
from robolayout.export._bodies import DRAG, STICTION, BodyLink, BodyShape, BodyTree, things
from robolayout.export._exporter import Bundle, Exporter, Options, Rows, reader, unique
from robolayout.export._mesh import numbers
from robolayout.export._xml import DRAKE, STIFF, Tree, dump_xml, facts, moments, parse_xml, pose_of, put, rgba
from robolayout.scene import Layout, Scene

VERSION = "1.7"
OURS = "https://robolayout.invalid/sdf"  # XML namespace of what only we read
BASE = "body"  # name of the link that stays


def make(scene: Scene, layout: Layout, options: Options) -> Bundle:
    """Return the world, and the model folders by path."""
    root, taken, files = _root(), {"world"}, dict[str, bytes]()
    world = put(root, "world", {"@name": _legal(scene.name, set())})
    for thing in things(scene, layout, options):
        pose, name, folder = thing.pose, _legal(thing.name, taken), thing.folder
        place = f"{pose.x!r} {pose.y!r} {pose.z!r} 0 0 {pose.yaw!r}"
        kept = {} if thing.asset is None else {"robolayout:thing": facts(thing.asset)}
        put(world, "include", {"uri": f"model://{folder}", "name": name, "pose": place, **kept})
        if not thing.free and len(thing.links) > 1:
            _joint(world, f"{name}::{BASE}", "world", {"@type": "fixed"})
        if f"{folder}/model.sdf" not in files:
            config = ET.Element("model")
            put(config, "name", folder.rpartition("/")[2])
            put(config, "sdf", "model.sdf").set("version", VERSION)
            files |= {f"{folder}/{path}": data for path, data in thing.meshes().items()}
            files |= {f"{folder}/model.config": dump_xml(config), f"{folder}/model.sdf": _model(thing, folder)}
    put(world, "light", {"@name": "sun", "@type": "directional", "pose": "0 0 6 0 0 0", "direction": "0.35 -0.25 -1"})
    return dump_xml(root), files


def _root() -> ET.Element:
    return ET.Element("sdf", {"version": VERSION, "xmlns:drake": DRAKE, "xmlns:robolayout": OURS})


def _legal(name: str, taken: set[str]) -> str:
    """Return a new name as SDF can hold it, without its own separators."""
    return unique(re.sub(r"[^\w .()-]", "_", xml(name)).strip("_ ") or "thing", taken)


def _model(thing: BodyTree, folder: str) -> bytes:
    """Return the model of a thing; nothing of it collides with the rest of it."""
    root = _root()
    model = put(root, "model", {"@name": folder.rpartition("/")[2]})
    if len(thing.links) == 1 and not thing.free:
        put(model, "static", "1")
    group = put(model, "drake:collision_filter_group", {"@name": "own"})
    put(group, "drake:ignored_collision_filter_group", "own")
    for link in thing.links:
        joint = link.joint
        name = BASE if joint is None else joint.name
        element = put(model, "link", {"@name": name, "pose": f"{numbers(link.at.tolist())} 0 0 0", **_inertial(link)})
        for shape in link.shapes:
            _shape(element, shape, folder, thing.friction)
        put(group, "drake:member", name)
        if joint is not None:
            dynamics = {"damping": f"{DRAG[joint.kind]:g}", "friction": f"{STICTION[joint.kind]:g}"}
            limit = {"lower": numbers(joint.span[:1]), "upper": numbers(joint.span[1:])}
            axis = {"xyz": numbers(joint.axis), "limit": limit, "dynamics": dynamics}
            _joint(model, name, BASE, {"@type": "revolute" if joint.kind == "hinge" else "prismatic", "axis": axis})
    return dump_xml(root)


def _joint(parent: ET.Element, child: str, still: str, rest: Tree) -> None:
    """Add a joint between two links."""
    put(parent, "joint", {"@name": f"{child.partition('::')[0]} joint", "parent": still, "child": child, **rest})


def _inertial(link: BodyLink) -> Tree:
    weight, middle, inertia = link.inertia()
    pose = f"{numbers(middle.tolist())} 0 0 0"
    return {"inertial": {"pose": pose, "mass": numbers([weight]), "inertia": moments(inertia)}} if weight else {}


def _shape(link: ET.Element, shape: BodyShape, folder: str, friction: float) -> None:
    """Add what is seen and what is touched of a shape."""
    color, grip = rgba(shape.part.material), numbers([friction])
    more: dict[str, Tree] = {
        "visual": {"material": {"ambient": color, "diffuse": color}},
        "collision": {
            "surface": {"friction": {"ode": {"mu": grip, "mu2": grip}}},
            "drake:proximity_properties": {"drake:compliant_hydroelastic": "", "drake:hydroelastic_modulus": STIFF},
        },
    }
    uri = {"uri": f"model://{folder}/{shape.mesh}", "drake:declare_convex": ""}
    at, turn, size = shape.place()
    for kind in shape.kinds:
        geometry = {"box": {"size": size}} if size else {"mesh": uri}
        content = {"@name": f"{shape.name}/{kind}", "pose": f"{at} {turn}", "geometry": geometry}
        put(link, kind, {**content, **more[kind]})


@reader("SDF file")
def read(data: bytes) -> Rows:
    """Yield the names, poses and sizes in a world that this package wrote."""
    for include in parse_xml(data, "sdf").iter("include"):
        if (thing := include.find(f"{{{OURS}}}thing")) is not None:
            yield thing.attrib["name"], pose_of(include.findtext("pose", "")), map(float, thing.attrib["size"].split())


SDF = Exporter("sdf", ".sdf", "SDF world with a model folder for each kind of thing", None, make, read)
