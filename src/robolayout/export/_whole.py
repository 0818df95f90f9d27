"""A robot's whole model in MJCF: what its URDF or MJCF file says, in the pose in which it drives about, each joint held there.

MuJoCo reads the file. The pose is made the model's own, so that it stands in it from the start; every hinge and slide that
follows no other joint gets an actuator whose control is how far it is to be from that. It collides with the room, not with
itself, and is not pulled down.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from robolayout._reading import show
from robolayout.assets.shapes import wrapped
from robolayout.export._bodies import BODIES
from robolayout.export._mesh import FloatArray, numbers, obj
from robolayout.export._mujoco import simulator
from robolayout.export.mjcf import section
from robolayout.scene import Agent, Figure
from robolayout.scene._model import Model

PACE = 18.0  # radians per second at which a held joint swings back, without swinging over (that of the base)

MESHES, PICTURES = (".stl", ".obj", ".msh"), (".png",)  # kinds of file that MuJoCo reads

THICK = 5e-4 * np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
"""Metres by which the corners of a flat mesh are moved."""

ITS_OWN = ("compiler", "option", "size", "statistic", "visual", "worldbody", "keyframe", "sensor")
"""Sections of a robot's model that a room has its own of."""

INERTIA = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
FOLDER = "models/agent"
BOUNDS = {"boundmass": "1e-4", "boundinertia": "1e-7", "balanceinertia": "true"}
COMPILER = {"fusestatic": "false", "discardvisual": "true", "strippath": "false", **BOUNDS}


Whole = tuple[list[ET.Element], ET.Element, list[float], Mapping[str, bytes]]
"""Sections whose elements are to be added to a model, the body that stands on the base, values of its joints, files by path."""


def whole(agent: Agent, figure: Figure, own: str) -> Whole:
    """Return the model of a robot whose names begin with `own`."""
    mujoco, model = simulator(), Model(figure.path)
    files: dict[str, bytes] = {}
    try:
        shell, compiled = _shell(mujoco, model, own, files, figure)
    except ValueError as error:
        raise model.fail(f"MuJoCo does not read it: {show(str(error))}; --body base does.") from None
    data = mujoco.MjData(compiled)
    for joint in range(compiled.njnt):
        said = figure.pose.get(compiled.joint(joint).name.removeprefix(f"{own}/"), 0.0)
        if compiled.jnt_type[joint] >= int(mujoco.mjtJoint.mjJNT_SLIDE):
            data.qpos[compiled.jnt_qposadr[joint]] = said
    mujoco.mj_forward(compiled, data)
    root = ET.fromstring(shell.to_xml())
    for body in root.iter("body"):
        _posed(compiled, data, body)
    for foot in _feet(compiled, data, agent.step):
        ET.SubElement(section(root, "contact"), "exclude", body1="world", body2=foot)
    _hold(mujoco, compiled, data, section(root, "actuator"))
    added = [part for part in root if part.tag not in ITS_OWN]
    return added, next(root.iter("body")), data.qpos.tolist(), files


def _feet(compiled: Any, data: Any, step: float) -> list[str]:
    """Return the names of the bodies with shapes that are as low as what the robot drives over: the base carries it, not they."""
    turns = data.geom_xmat[:, 6:]
    boxes = compiled.geom_aabb
    low = data.geom_xpos[:, 2] + (turns * boxes[:, :3]).sum(axis=1) - (np.abs(turns) * boxes[:, 3:]).sum(axis=1)
    touching = (low < step) & (compiled.geom_contype > 0)
    return [compiled.body(body).name for body in np.unique(compiled.geom_bodyid[touching])]


def _shell(mujoco: Any, model: Model, own: str, files: dict[str, bytes], figure: Figure) -> tuple[Any, Any]:
    """Return a model that holds the robot alone, and that compiled."""
    robot = _read(mujoco, model, files)
    shell = mujoco.MjSpec()
    for name in (name for name in dir(robot.option) if not name.startswith("_")):
        setattr(shell.option, name, getattr(robot.option, name))
    shell.compiler.boundmass, shell.compiler.boundinertia = 1e-4, 1e-7
    frame = shell.worldbody.add_frame()
    frame.attach_body(_top(robot), f"{own}/", "")
    for actuator in list(shell.actuators):
        shell.delete(actuator)
    for joint in list(shell.joints):
        if joint.type == mujoco.mjtJoint.mjJNT_FREE:
            shell.delete(joint)
    for kind, parts in (("body", shell.bodies[1:]), ("joint", shell.joints), ("geom", shell.geoms)):
        for number, part in enumerate(parts):
            part.name = part.name or f"{own}/{kind} {number}"
    for body in shell.bodies[1:]:
        body.gravcomp = 1.0
    for geom in shell.geoms:
        if geom.contype or geom.conaffinity:
            geom.contype, geom.conaffinity = 2, 1
    shell.bodies[1].pos = [-value for value in figure.foot]
    shell.assets = files
    return shell, shell.compile()


def _top(robot: Any) -> Any:
    """Return the body in a model's world that is the robot: that with the most joints in it."""
    bodies, body = list[Any](), robot.worldbody.first_body()
    while body is not None:
        bodies.append(body)
        body = robot.worldbody.next_body(body)
    return max(bodies, key=lambda top: len(top.find_all("joint")))


def _read(mujoco: Any, model: Model, files: dict[str, bytes]) -> Any:
    """Return MuJoCo's form of the file; what it refers to is taken from the file's own folder or package alone."""
    root, _ = model.root(model.path)
    if root.tag == "robot":
        return mujoco.MjSpec.from_string(_urdf(root, model, files), assets=files)
    robot = mujoco.MjSpec.from_file(str(model.path))
    for things, folder, kinds in ((robot.meshes, robot.meshdir, MESHES), (robot.textures, robot.texturedir, PICTURES)):
        for number, thing in enumerate(things):
            if thing.file:
                path = model.find(str(Path(folder) / thing.file), "file", kinds)
                thing.name = thing.name or path.stem
                thing.file = f"{FOLDER}/{number}-{path.name}"
                files[thing.file] = path.read_bytes()
    robot.meshdir = robot.texturedir = ""
    robot.assets = files
    return robot


def _urdf(root: ET.Element, model: Model, files: dict[str, bytes]) -> str:
    """Return a URDF as MuJoCo reads it: what collides, its meshes by their hulls."""
    for link in root.iter("link"):
        for look in link.findall("visual"):
            link.remove(look)
    paths: dict[str, str] = {}
    for mesh in root.iter("mesh"):
        name = mesh.get("filename") or ""
        if name not in paths:
            paths[name] = f"{FOLDER}/{len(paths)}-{Path(name).stem}.obj"
            files[paths[name]] = _hull(model.mesh(name))
        mesh.set("filename", paths[name])
    for inertial in root.iter("inertial"):
        _weigh(inertial, model)
    for old in root.findall("mujoco"):
        root.remove(old)
    ET.SubElement(ET.SubElement(root, "mujoco"), "compiler", COMPILER)
    return ET.tostring(root, encoding="unicode")


def _weigh(inertial: ET.Element, model: Model) -> None:
    """Give a link whose inertia no thing can have (real files say zeros) that of a ball of a centimetre."""
    inertia, mass = inertial.find("inertia"), inertial.find("mass")
    if inertia is None or mass is None:
        return
    said = {key: model.numbers(inertia.get(key), f"<inertia>, {key}", 1)[0] for key in INERTIA}
    (weight,) = model.numbers(mass.get("value"), "<mass>", 1)
    rows = np.array([said[key] for key in ("ixx", "ixy", "ixz", "ixy", "iyy", "iyz", "ixz", "iyz", "izz")])
    if np.linalg.eigvalsh(rows.reshape(3, 3))[0] <= 0:
        ball = f"{0.4 * max(weight, BODIES.lightest) * 0.01**2:.9g}"
        inertia.attrib.update({key: ball if key[1] == key[2] else "0" for key in INERTIA})


def _hull(points: FloatArray) -> bytes:
    """Return the convex hull of points (n, 3) as a Wavefront OBJ file; what is flat gets a millimetre of thickness."""
    from scipy.spatial import QhullError

    try:
        faces = wrapped(points)
    except QhullError:
        points = np.concatenate([points + offset for offset in THICK])
        faces = wrapped(points)
    corners, places = np.unique(faces, return_inverse=True)
    return obj(points[corners], places.reshape(-1, 3).astype(np.int32))


def _posed(compiled: Any, data: Any, body: ET.Element) -> None:
    """Make the pose that a body has now that of the model, its joints at the values that they have now."""
    which = compiled.body(body.get("name"))
    own, above = which.id, which.parentid[0]
    frame, outer = data.xmat[own].reshape(3, 3), data.xmat[above].reshape(3, 3)
    turn = np.zeros(4)
    simulator().mju_mat2Quat(turn, (outer.T @ frame).ravel())
    for key in ("euler", "axisangle", "xyaxes", "zaxis"):
        body.attrib.pop(key, None)
    body.set("pos", numbers((outer.T @ (data.xpos[own] - data.xpos[above])).tolist()))
    body.set("quat", numbers(turn.tolist()))
    for joint in body.findall("joint"):
        number = compiled.joint(joint.get("name")).id
        joint.set("pos", numbers((frame.T @ (data.xanchor[number] - data.xpos[own])).tolist()))
        if joint.get("type") != "ball":
            joint.set("axis", numbers((frame.T @ data.xaxis[number]).tolist()))
            value = float(data.qpos[compiled.jnt_qposadr[number]])
            joint.set("ref", repr(value))
            if compiled.jnt_limited[number]:  # what follows another joint may do so beyond its own limits (PR2)
                low, high = compiled.jnt_range[number].tolist()
                joint.set("range", f"{min(low, value)!r} {max(high, value)!r}")


def _hold(mujoco: Any, compiled: Any, data: Any, actuators: ET.Element) -> None:
    """Add an actuator for each hinge and slide that follows no other one, which holds it where it is now."""
    follows = (compiled.eq_type == int(mujoco.mjtEq.mjEQ_JOINT)) & (compiled.eq_obj2id >= 0)
    led = set(compiled.eq_obj1id[follows].tolist())
    for number in range(compiled.njnt):
        if number in led or compiled.jnt_type[number] < int(mujoco.mjtJoint.mjJNT_SLIDE):
            continue
        name, value = compiled.joint(number).name, float(data.qpos[compiled.jnt_qposadr[number]])
        weight = max(float(compiled.dof_M0[compiled.jnt_dofadr[number]]), BODIES.lightest)
        stiff, damping = weight * PACE**2, 2 * weight * PACE
        bias = f"{stiff * value:.17g} {-stiff:.17g} {-damping:.17g}"
        drive = {"gaintype": "fixed", "biastype": "affine", "gainprm": f"{stiff:.17g}", "biasprm": bias}
        ET.SubElement(actuators, "general", {"name": name, "joint": name, **drive})
