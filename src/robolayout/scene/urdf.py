"""An agent from a robot's URDF model: footprint and height of its collision geometry, arm folded, and where its hand gets to.

Boxes, cylinders, spheres and meshes become convex hulls in the frame of the root link (x ahead, z up). A body whose farthest
point is hardly farther than its sides is a disc, every other a rectangle. The file is hostile: entities and document types
are refused, and meshes are read only from the model's own package.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import Element

import numpy as np
from numpy.typing import NDArray

from robolayout._errors import AgentError, MissingExtraError, UnknownNameError
from robolayout._reading import Checker, inside, is_file, regular_bytes, show
from robolayout._reading.syntax import xml_root
from robolayout.scene.agent import Agent, Source
from robolayout.scene.kinematics import BAND, POSES, Joint, Kind, Robot

MAX_PARTS = 2000
"""Most links, most joints and most collision shapes of a model."""
MAX_MESH_BYTES = 50_000_000
"""Bytes of meshes read in all."""
MAX_POINTS = 5_000_000
"""Points on all collision shapes together."""
ROUND = 1.1
"""A body is a disc if its farthest point is at most this many times as far as its farthest side."""
CLEARANCE = 0.03
"""Metres kept free on each side of a rectangular body (rule of thumb)."""
STEP = 0.03
"""Metres that the body is taken to drive over; a URDF does not say."""
MESH_SUFFIXES = (".stl", ".obj", ".ply", ".dae")
"""Kinds of mesh that are read."""

Matrix = NDArray[np.float64]

_CHECK = Checker(AgentError)
_CIRCLE = 64


@dataclass
class _Model:
    """The URDF that is being read, and what it may still use.

    Attributes:
        path: The file.
        bytes_left: Bytes of meshes that may still be read.
        points_left: Points that its shapes may still have.
        meshes: Vertices of the meshes read so far, metres before scaling.
    """

    path: Path
    bytes_left: int = MAX_MESH_BYTES
    points_left: int = MAX_POINTS
    meshes: dict[Path, Matrix] = field(default_factory=dict[Path, Matrix])

    def fail(self, message: str) -> AgentError:
        """Return an error about this file."""
        return AgentError(f"agent file {self.path}: {message}")


def load_urdf(path: Path, pose: Mapping[str, float] | None = None) -> Agent:
    """Return the agent whose body is the collision geometry of a URDF file.

    Args:
        path: The file.
        pose: Values of joints in which it drives about, radians and metres, by name; None folds its arms by itself.
    """
    model = _Model(path)
    robot = _robot(model)
    elements = _children(robot, "link", model)
    links = {link.get("name") or "": link for link in elements}
    if len(links) < len(elements):
        raise model.fail("has two links of one name; give each its own.")
    root, joints = _tree(robot, links, model)
    if not _children(robot, "link/collision", model):
        raise model.fail("no link has collision geometry, so the body has no size; add <collision> elements.")
    hulls: dict[str, Matrix] = {}
    for name, element in links.items():
        if clouds := [_points(collision, model) for collision in element.findall("collision")]:
            hulls[name] = _hull(np.concatenate(clouds), model)
    body = Robot(root, joints, hulls)
    values, how = (
        (body.folded(), "its arms folded") if pose is None else (_given(body, pose, model), "in the pose given")
    )
    points = body.points({name: np.array([value]) for name, value in values.items()})[0]
    return _agent(points, robot.get("name") or path.stem, how if body.arms else "joints at zero", body)


def _hull(points: Matrix, model: _Model) -> Matrix:
    """Return the corners of the convex hull of points (n, 3); flat ones stay as they are."""
    from scipy.spatial import ConvexHull, QhullError

    if not np.isfinite(points).all():
        raise model.fail("its collision geometry has coordinates that are not finite.")
    try:
        return points[ConvexHull(points).vertices]
    except (QhullError, ValueError):
        return np.unique(points, axis=0)


def _given(body: Robot, pose: Mapping[str, float], model: _Model) -> dict[str, float]:
    """Return the pose that the user gives, checked."""
    movable = {joint.name: joint for joint in body.joints if joint.kind != "fixed" and joint.mimics is None}
    for name, value in pose.items():
        if name not in movable:
            raise UnknownNameError(f"joint of {model.path.name}", name[:100], movable)
        low, high = movable[name].low, movable[name].high
        _CHECK.number(value, f"pose of joint {show(name)}", least=low, most=high)
    return {**body.rest, **pose}


def _robot(model: _Model) -> Element:
    """Return the root element, refusing whatever could expand or point elsewhere."""
    text = _CHECK.read_text(model.path, "agent file")
    robot = _CHECK.parse(xml_root, text, f"agent file {model.path}")
    if robot.tag != "robot":
        raise model.fail(f"starts with <{show(robot.tag)}>, but a URDF starts with <robot>.")
    plain = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
    if command := re.search(r"<xacro:|\$\{|\$\(", plain):
        line = text[: text.index(command[0])].count("\n") + 1
        raise model.fail(f"has xacro commands ({command[0]}, line {line}); run xacro first and give the plain URDF.")
    return robot


def _children(element: Element, tag: str, model: _Model) -> list[Element]:
    found = element.findall(tag)
    if len(found) > MAX_PARTS:
        raise model.fail(f"has {len(found)} <{tag}> elements; at most {MAX_PARTS} are allowed.")
    return found


def _numbers(text: str | None, where: str, count: int) -> list[float]:
    """Return the numbers of an attribute; zeros if it is not there."""
    parts = (text or " ".join(["0"] * count)).split()
    try:
        values = [float(part) for part in parts]
    except ValueError:
        raise AgentError(f"{where} must be {count} numbers, but is {show(text)}.") from None
    return list(_CHECK.numbers(values, where, (count,)))


def _origin(element: Element, model: _Model) -> Matrix:
    """Return the 4 x 4 transform of an element's <origin>: fixed-axis roll, pitch, yaw and translation."""
    origin = element.find("origin")
    pose = np.eye(4)
    if origin is None:
        return pose
    where = f"agent file {model.path}: origin of <{element.tag}>"
    roll, pitch, yaw = _numbers(origin.get("rpy"), f"{where}, rpy", 3)
    cr, sr, cp, sp, cy, sy = (f(a) for a in (roll, pitch, yaw) for f in (math.cos, math.sin))
    pose[:3, :3] = (
        np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
        @ np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
        @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    )
    pose[:3, 3] = _numbers(origin.get("xyz"), f"{where}, xyz", 3)
    return pose


def _tree(robot: Element, links: Mapping[str, Element], model: _Model) -> tuple[str, tuple[Joint, ...]]:
    """Return the root link, and all joints from it outwards."""
    joints: dict[str, list[Joint]] = {}
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
    ordered, waiting = list[Joint](), [roots[0]]
    while waiting:
        further = joints.get(waiting.pop(), [])
        ordered += further
        waiting += [joint.child for joint in further]
    if len(ordered) + 1 < len(links):
        found = {roots[0], *(joint.child for joint in ordered)}
        raise model.fail(f"link {show(next(n for n in links if n not in found))} is part of a loop of joints.")
    return roots[0], tuple(ordered)


def _joint(element: Element, model: _Model) -> Joint:
    """Return one joint; what has no range does not move, and floating and planar joints are fixed."""
    ends = [(end.get("link") or "") if (end := element.find(tag)) is not None else "" for tag in ("parent", "child")]
    name, kind = element.get("name") or "", element.get("type")
    where = f"agent file {model.path}: joint {show(name)}"
    axis, limit, mimic = (element.find(tag) for tag in ("axis", "limit", "mimic"))
    along = np.array(_numbers(None if axis is None else axis.get("xyz"), f"{where}, axis", 3))
    along = along / length if (length := float(np.linalg.norm(along))) > 0 else np.array([1.0, 0.0, 0.0])
    turn = (-math.pi, math.pi) if kind == "continuous" else (0.0, 0.0)
    low, high = (
        turn
        if limit is None or kind == "continuous"
        else (_numbers(limit.get(end) or "0", f"{where}, limit", 1)[0] for end in ("lower", "upper"))
    )
    follows = None
    if mimic is not None:
        usual = {"multiplier": "1", "offset": "0"}
        factor, offset = (_numbers(mimic.get(key) or plain, f"{where}, mimic", 1)[0] for key, plain in usual.items())
        follows = (mimic.get("joint") or "", factor, offset)
    moves: Kind = "prismatic" if kind == "prismatic" else "revolute" if kind in ("revolute", "continuous") else "fixed"
    return Joint(name, ends[0], ends[1], _origin(element, model), moves, along, low, max(low, high), follows)


def _points(collision: Element, model: _Model) -> Matrix:
    """Return points (n, 3) on a collision shape, in the frame of its link."""
    geometry = collision.find("geometry")
    shape = next(iter(geometry), None) if geometry is not None else None
    if shape is None:
        raise model.fail("a <collision> has no <geometry>.")
    where = f"agent file {model.path}: <{show(shape.tag)}>"
    if shape.tag == "box":
        half = np.array(_sizes(shape, "size", where, 3)) / 2
        local = half * np.array([(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    elif shape.tag == "cylinder":
        (radius,), (length,) = _sizes(shape, "radius", where, 1), _sizes(shape, "length", where, 1)
        ring = _circle(radius)
        rise = np.array([0.0, 0.0, length / 2])
        local = np.concatenate([ring + rise, ring - rise])
    elif shape.tag == "sphere":
        (radius,) = _sizes(shape, "radius", where, 1)
        center = _origin(collision, model)[:3, 3]
        return np.concatenate([_circle(radius), [(0, 0, radius), (0, 0, -radius)]]) + center
    elif shape.tag == "mesh":
        scale = _numbers(shape.get("scale") or "1 1 1", f"{where}: scale", 3)
        local = _mesh(shape.get("filename") or "", model) * np.array(scale)
    else:
        raise model.fail(f"<{show(shape.tag)}> is no shape; allowed are box, cylinder, sphere and mesh.")
    model.points_left -= len(local)
    if model.points_left < 0:
        raise model.fail(f"its collision shapes have more than {MAX_POINTS} points; simplify its meshes.")
    pose = _origin(collision, model)
    return local @ pose[:3, :3].T + pose[:3, 3]


def _sizes(shape: Element, key: str, where: str, count: int) -> list[float]:
    sizes = _numbers(_CHECK.text(shape.get(key, ""), f"{where}: {key}") or "nothing", f"{where}: {key}", count)
    return [_CHECK.number(size, f"{where}: {key} (metres)", above=0.0) for size in sizes]


def _circle(radius: float) -> Matrix:
    turns = np.arange(_CIRCLE) * (2 * math.pi / _CIRCLE)
    return np.stack([radius * np.cos(turns), radius * np.sin(turns), np.zeros(_CIRCLE)], axis=1)


def _mesh(filename: str, model: _Model) -> Matrix:
    """Return the vertices (n, 3) of a mesh file of the model's package."""
    path = _find_mesh(filename, model)
    if path not in model.meshes:
        model.meshes[path] = _vertices(path, model)
    return model.meshes[path]


def _vertices(path: Path, model: _Model) -> Matrix:
    from robolayout._reading.mesh import mesh_pieces

    what = f"agent file {model.path}: mesh {path.name}"
    if path.suffix.lower() == ".dae" and find_spec("collada") is None:
        raise MissingExtraError(f"{what}, a COLLADA file,", "sim")
    content = _CHECK.parse(lambda file: regular_bytes(file, MAX_MESH_BYTES), path, what)
    model.bytes_left -= len(content)
    if model.bytes_left < 0:
        raise model.fail(f"its meshes are larger than {MAX_MESH_BYTES // 1_000_000} MB together; simplify them.")
    pieces = _CHECK.parse(lambda data: mesh_pieces(data, path.suffix.lower()), content, what)
    return np.concatenate([piece.vertices for piece in pieces])


def _find_mesh(filename: str, model: _Model) -> Path:
    """Return the file of a mesh: relative to the URDF, or `package://<package>/...` in a folder of that name above."""
    if Path(filename).suffix.lower() not in MESH_SUFFIXES or "\0" in filename:
        allowed = ", ".join(MESH_SUFFIXES)
        raise model.fail(f"mesh {show(filename)} is of no kind that is read ({allowed}); convert it.")
    home = model.path.resolve().parent
    folders = [home, home.parent]
    rest = filename.removeprefix("file://")
    if filename.startswith("package://"):
        package, _, rest = filename.removeprefix("package://").partition("/")
        folders = [folder for folder in (home, *home.parents[:4]) if folder.name == package] or folders
    for folder in folders:
        if inside(folder / rest, folders) and is_file(folder / rest):
            return (folder / rest).resolve()
    raise model.fail(f"mesh {show(filename)} is not in the model's folder or package; put it there.")


def _reach(body: Robot, floor: float, within: float, about: str) -> dict[str, Any]:
    """Return the figures of a reach that its hand has at every height: the largest sphere about a shoulder inside its reach map.

    Heights count at which the hand gets farther than the body itself, `within` metres.
    """
    bands = [(height, away) for height, away in body.reach(floor) if away > within]
    if not bands:
        return {}
    shoulder, _ = max(bands, key=lambda band: band[1])
    inside = min(math.hypot(away, height - shoulder) for height, away in bands)
    source = Source(f"{POSES} random poses of the arm to {body.hand}, {about}", verified=True)
    figures = {
        "reach_distance": math.floor(inside * 1e3) / 1e3,
        "reach_low": max(round(bands[0][0] - BAND / 2, 2), 0.0),
        "reach_high": round(bands[-1][0] + BAND / 2, 2),
        "shoulder_height": round(shoulder, 2),
    }
    return {**figures, "sources": dict.fromkeys(figures, source)}


def _agent(points: Matrix, name: str, how: str, body: Robot) -> Agent:
    """Return the agent that just holds the points, given in the frame of the root link."""
    low, high = points.min(axis=0), points.max(axis=0)
    size = high - low
    farthest = float(np.hypot(points[:, 0], points[:, 1]).max())
    height = _round(size[2])
    about = f"collision geometry of the URDF model {name}, {how}"
    reach = _reach(body, float(low[2]), farthest, about)
    known = Source(about, verified=True)
    sources = {
        **reach.pop("sources", {}),
        "height": known,
        "radius": known,
        "step": Source("not in a URDF; the general default", verified=False),
    }
    if farthest <= ROUND * max(abs(low[0]), abs(low[1]), high[0], high[1]) and max(size[:2]) < 1.25 * min(size[:2]):
        return Agent(name, _round(farthest), height, step=STEP, title=name, sources=sources, **reach)
    length, width = _round(size[0]), _round(size[1])
    steered = body.steering()
    circle = _round(2 * farthest if steered is None else 2 * math.hypot(steered + width / 2, length))
    sources |= {"length": known, "width": known, "turning_diameter": known}
    sources["radius"] = Source(f"half the width and {CLEARANCE} m, {about}", verified=False)
    return Agent(
        name,
        radius=_round(width / 2 + CLEARANCE),
        height=height,
        length=length,
        width=width,
        turning_diameter=circle if circle > 1.05 * math.hypot(length, width) else None,
        step=STEP,
        title=name,
        sources=sources,
        **reach,
    )


def _round(value: float) -> float:
    """Return a length rounded up to a tenth of a millimetre."""
    return math.ceil(float(value) * 1e4 - 1e-6) / 1e4
