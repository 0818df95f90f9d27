"""Links and joints of a robot's MJCF model: the form of MuJoCo, with classes of defaults and included files.

The world may hold other things: the robot is the one body with joints inside it. How it moves as a whole (its free joint,
or slides) is left out, and floors, sites, tendons and what only is seen are passed over.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
from scipy.spatial.transform import Rotation

from robolayout._reading import LIMITS, show
from robolayout.scene._model import Matrix, Model, ball, box, capsule, cylinder, transform
from robolayout.scene.kinematics import Kind, Robot, RobotJoint, hulls

Attributes = Mapping[str, str]

ROOT = "world"  # the link that stands for the middle of the robot's own first body, turned as the world
STOWED = ("stow", "home")  # names of the keyframe in which it drives about, best first
GROWN = ("replicate", "attach", "composite", "flexcomp")  # elements that MuJoCo's compiler turns into bodies
SPACE = {"free": 7, "ball": 4, "slide": 1, "hinge": 1}  # values of each kind of joint in a keyframe


@dataclass
class _Body:
    """One of the bodies in the world, with all on it."""

    name: str
    inner: int = 0  # joints inside it, beside those by which it moves as a whole
    joints: list[RobotJoint] = field(default_factory=list[RobotJoint])  # all that holds links together, outwards
    # points on each link's collision shapes
    clouds: dict[str, list[Matrix]] = field(default_factory=dict[str, list[Matrix]])


def read_mjcf(root: Element, model: Model) -> Robot:
    """Return the robot of an MJCF file, given as its root element."""
    whole = Element("mujoco", root.attrib)
    whole.extend(list(_expanded(root, model, {model.path.resolve()}, 0)))
    return _Reader(whole, model).robot()


def _expanded(element: Element, model: Model, read: set[Path], depth: int) -> Iterator[Element]:
    """Yield an element's children, those of included files in their place."""
    if depth > LIMITS.depth:
        raise model.fail(f"is nested too deeply. At most {LIMITS.depth} levels are read.")
    for child in list(element):
        if child.tag in GROWN:
            raise model.fail(f"has <{child.tag}>, which is not read; load it in MuJoCo and save it (mj_saveLastXML).")
        if child.tag == "include":
            path = model.find(child.get("file") or "", "included file", (".xml", ".mjcf"))
            if path in read:
                raise model.fail(f"includes {path.name} twice; MuJoCo reads a file once.")
            read.add(path)
            yield from _expanded(model.root(path)[0], model, read, depth + 1)
        else:
            inner = list(_expanded(child, model, read, depth + 1))
            child[:] = inner
            yield child


class _Reader:
    """What a model says for all its bodies."""

    def __init__(self, whole: Element, model: Model) -> None:
        self.whole, self.model = whole, model
        said = {key: value for each in whole.iter("compiler") for key, value in each.attrib.items()}
        self.turn = math.pi / 180 if said.get("angle", "degree") == "degree" else 1.0
        self.sequence = said.get("eulerseq", "xyz")
        self.limits = said.get("autolimits", "true") == "true"
        self.folder = said.get("meshdir", said.get("assetdir", ""))
        self.classes: dict[str, dict[str, Attributes]] = {"main": {}}
        for each in whole.findall("default"):
            self._class(each, self.classes["main"], each.get("class") or "main")
        meshes = (self._of(mesh, "main") for mesh in whole.iterfind("asset/mesh"))
        self.meshes = {mesh.get("name") or Path(mesh.get("file", "")).stem: mesh for mesh in meshes}
        self.follows = dict(self._followers())
        self.slots: list[str | None] = []
        self.names: set[str] = set()

    def robot(self) -> Robot:
        """Return the robot."""
        bodies: list[_Body] = []
        for element, frame in (found for world in self.whole.iterfind("worldbody") for found in self._bodies(world)):
            bodies.append(_Body(element.get("name") or "body"))
            pose = frame @ self._pose(element.attrib, f"body {show(bodies[-1].name)}")
            pose[:3, 3] = 0.0
            self._body(element, ROOT, pose, "main", bodies[-1])
        solid = [body for body in bodies if body.clouds]
        able = [body for body in solid if body.inner] or solid
        if not able:
            raise self.model.fail("no body has a shape that collides, so the robot has no size; add geoms.")
        if len(able) > 1:
            names = ", ".join(show(body.name) for body in able[:5])
            raise self.model.fail(f"has {len(able)} bodies with joints in its world ({names}); leave one robot in it.")
        name = self.whole.get("model") or self.model.path.stem
        return Robot(name, ROOT, tuple(able[0].joints), hulls(able[0].clouds), self._home())

    def _class(self, element: Element, inherited: Mapping[str, Attributes], name: str) -> None:
        known = {**inherited}
        for child in element:
            if child.tag != "default":
                known[child.tag] = {**known.get(child.tag, {}), **child.attrib}
        self.classes[name] = known
        for child in element.findall("default"):
            self._class(child, known, child.get("class") or "")

    def _of(self, element: Element, child_class: str) -> Attributes:
        """Return an element's attributes, with those of its class."""
        name = element.get("class") or child_class
        if name not in self.classes:
            raise self.model.fail(f"<{element.tag}> has the class {show(name)}, which no <default> describes.")
        return {**self.classes[name].get(element.tag, {}), **element.attrib}

    def _followers(self) -> Iterator[tuple[str, tuple[str, float, float]]]:
        """Yield each joint that an equality makes follow another, and how."""
        for each in self.whole.iterfind("equality/joint"):
            if (leader := each.get("joint2")) and each.get("active") != "false":
                first = " ".join((each.get("polycoef") or "0 1").split()[:2])
                offset, factor = self.model.numbers(first, "polycoef", 2)
                yield each.get("joint1") or "", (leader, factor, offset)

    def _bodies(self, world: Element, pose: Matrix | None = None) -> Iterator[tuple[Element, Matrix]]:
        """Yield the bodies on an element, those in frames too, and the frame that each is in."""
        pose = np.eye(4) if pose is None else pose
        for child in world:
            if child.tag == "body":
                yield child, pose
            elif child.tag == "frame":
                yield from self._bodies(child, pose @ self._pose(child.attrib, "frame"))

    def _body(self, element: Element, parent: str, pose: Matrix, child_class: str, body: _Body) -> None:
        """Add a body with all that is on it; `pose` is its own in its parent's frame."""
        self.model.count("body")
        link = self._name(element, "body")
        child_class = element.get("childclass") or child_class
        fixed = True
        for joint in (each for each in element if each.tag in ("joint", "freejoint")):
            self.model.count("joint")
            moved = self._joint(joint, parent, pose, child_class)
            if moved is not None and parent is not ROOT:
                body.inner += 1
                body.joints.append(moved[0])
                parent, pose = moved[0].child, moved[1]
                fixed = bool(pose[:3, 3].any())
        if fixed:
            up = np.array([0.0, 0.0, 1.0])
            body.joints.append(RobotJoint(f"{link} (body)", parent, link, pose, "fixed", up, 0.0, 0.0))
        else:
            body.joints[-1] = replace(body.joints[-1], child=link)
        self._inside(element, link, np.eye(4), child_class, body)

    def _inside(self, element: Element, link: str, pose: Matrix, child_class: str, body: _Body) -> None:
        """Add the shapes and bodies on a body, or on a frame in it."""
        for child in element:
            if child.tag == "geom" and (points := self._points(self._of(child, child_class), pose)) is not None:
                body.clouds.setdefault(link, []).append(points)
            elif child.tag == "frame":
                further = pose @ self._pose(child.attrib, "frame")
                self._inside(child, link, further, child.get("childclass") or child_class, body)
            elif child.tag == "body":
                self._body(child, link, pose @ self._pose(child.attrib, "body"), child_class, body)

    def _name(self, element: Element, kind: str) -> str:
        name = element.get("name") or f"{kind} {len(self.names)}"
        if f"{kind} {name}" in self.names or name == ROOT:
            raise self.model.fail(f"has two of the name {show(name)} (<{kind}>); give each its own.")
        self.names.add(f"{kind} {name}")
        return name

    def _joint(self, element: Element, parent: str, pose: Matrix, child_class: str) -> tuple[RobotJoint, Matrix] | None:
        """Return what a joint moves, and the pose of its body in that; None for what is not moved by one value."""
        said = self._of(element, child_class)
        kind = "free" if element.tag == "freejoint" else said.get("type", "hinge")
        if kind not in SPACE:
            raise self.model.fail(f"joint type {show(kind)} is none; allowed are {', '.join(SPACE)}.")
        name = self._name(element, "joint")
        self.slots += [name] if SPACE[kind] == 1 else [None] * SPACE[kind]
        if SPACE[kind] > 1:
            return None
        where, turns = f"joint {show(name)}", kind == "hinge"
        axis = np.array(self.model.numbers(said.get("axis", "0 0 1"), f"{where}, axis", 3))
        axis = axis / (float(np.linalg.norm(axis)) or 1.0)
        unit = self.turn if turns else 1.0
        limited = said.get("limited", "auto")
        low, high = (-math.pi, math.pi) if turns else (0.0, 0.0)
        if limited == "true" or (limited == "auto" and self.limits and "range" in said):
            low, high = (unit * value for value in self.model.numbers(said.get("range"), f"{where}, range", 2))
        at = np.array(self.model.numbers(said.get("pos"), f"{where}, pos", 3))
        moves: Kind = "revolute" if turns else "prismatic"
        child, follows = f"{name} (joint)", self.follows.get(name)
        joint = RobotJoint(name, parent, child, pose @ transform(at), moves, axis, low, max(low, high), follows)
        if start := unit * self.model.numbers(said.get("ref", "0"), f"{where}, ref", 1)[0]:
            joint = replace(joint, origin=joint.motion(np.array([-start]))[0])
        return joint, transform(-at)

    def _pose(self, said: Attributes, where: str) -> Matrix:
        """Return the pose that attributes give."""
        return transform(self.model.numbers(said.get("pos"), f"{where}, pos", 3), self._rotation(said, where))

    def _rotation(self, said: Attributes, where: str) -> Rotation | None:
        """Return the rotation that attributes give in one of MuJoCo's five ways; None for none."""
        counts = {"quat": 4, "euler": 3, "axisangle": 4, "xyaxes": 6, "zaxis": 3}
        given = next((key for key in counts if key in said), None)
        if given is None:
            return None
        values = np.array(self.model.numbers(said[given], f"{where}, {given}", counts[given]))
        try:
            if given == "quat":
                return Rotation.from_quat(np.roll(values, -1))
            if given == "euler":
                found = Rotation.identity()
                for axis, angle in zip(self.sequence, values * self.turn, strict=True):
                    turn = Rotation.from_euler(axis.lower(), angle)  # capitals: about fixed axes
                    found = turn * found if axis.isupper() else found * turn
                return found
            if given == "axisangle":
                return Rotation.from_rotvec(values[:3] / np.linalg.norm(values[:3]) * values[3] * self.turn)
            if given == "zaxis":
                return _facing(values)
            x, z = values[:3], np.cross(values[:3], values[3:])
            return Rotation.from_matrix(np.column_stack([a / np.linalg.norm(a) for a in (x, np.cross(z, x), z)]))
        except ValueError as error:
            raise self.model.fail(f"{where}: {given} is no rotation ({error}).") from None

    def _points(self, said: Attributes, frame: Matrix) -> Matrix | None:
        """Return points (n, 3) on a shape in its link's frame; None for what is only seen and for endless planes."""
        self.model.count("geom")
        kind = "mesh" if "mesh" in said else said.get("type", "sphere")
        if (said.get("contype", "1") == "0" == said.get("conaffinity", "1")) or kind in ("plane", "hfield"):
            return None
        where = f"geom {show(said.get('name', kind))}"
        if kind == "mesh":
            return self.model.placed(self._mesh(said.get("mesh", ""), where), frame @ self._pose(said, where))
        counts = {"sphere": 1, "capsule": 2, "cylinder": 2, "ellipsoid": 3, "box": 3}
        if kind not in counts:
            raise self.model.fail(f"geom type {show(kind)} is not read; allowed are mesh, {', '.join(counts)}.")
        pose, half = self._pose(said, where), []
        count = counts[kind]
        if "fromto" in said:
            ends = np.array(self.model.numbers(said["fromto"], f"{where}, fromto", 6)).reshape(2, 3)
            pose = transform(ends.mean(axis=0), _facing(ends[0] - ends[1]))
            half, count = [float(np.linalg.norm(ends[0] - ends[1])) / 2], 1
        size = " ".join(said.get("size", "").split()[:count])
        sizes = [*self.model.sizes(size, f"{where}: size", count), *half]
        sizes = [sizes[0], *sizes] if half and counts[kind] == 3 else sizes
        if kind in ("capsule", "cylinder"):
            points = (capsule if kind == "capsule" else cylinder)(*sizes)
        else:
            points = box(sizes) if kind == "box" else ball(sizes if kind == "ellipsoid" else sizes * 3)
        return self.model.placed(points, frame @ pose)

    def _mesh(self, name: str, where: str) -> Matrix:
        """Return the vertices of an asset: moved into its frame, then scaled, as MuJoCo does."""
        if name not in self.meshes:
            raise self.model.fail(f"{where} has the mesh {show(name)}, which no <asset> describes.")
        said = self.meshes[name]
        if "file" in said:
            points = self.model.mesh(str(Path(self.folder) / said["file"]))
        else:
            text = said.get("vertex", "")
            points = np.array(self.model.numbers(text, f"mesh {show(name)}, vertex", len(text.split()))).reshape(-1, 3)
        frame = {key.removeprefix("ref"): value for key, value in said.items() if key in ("refpos", "refquat")}
        inverse = np.linalg.inv(self._pose(frame, f"mesh {show(name)}"))
        scale = self.model.numbers(said.get("scale", "1 1 1"), f"mesh {show(name)}, scale", 3)
        return (points @ inverse[:3, :3].T + inverse[:3, 3]) * np.array(scale)

    def _home(self) -> dict[str, float] | None:
        """Return the values of the joints in the keyframe in which it drives about."""
        keys = {key.get("name"): key.get("qpos") for key in self.whole.iterfind("keyframe/key")}
        text = next((keys[name] for name in STOWED if keys.get(name)), None)
        if text is None:
            return None
        values = self.model.numbers(text, "keyframe, qpos", len(self.slots))
        return {name: value for name, value in zip(self.slots, values, strict=True) if name is not None}


def _facing(z: Matrix) -> Rotation | None:
    """Return the smallest turn that brings the z axis to a direction; None where it has no length."""
    return Rotation.align_vectors([z], [[0.0, 0.0, 1.0]])[0] if np.linalg.norm(z) > 1e-12 else None
