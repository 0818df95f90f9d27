"""Loads exported rooms in Drake and PyBullet as their users do, and lets them rest."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

Spot = tuple[float, float, float, float]
"""Place in metres and yaw in radians."""

STEP = 0.002
"""Seconds of one step."""

AREAS = {"compliance_type": "compliant", "hydroelastic_modulus": 1e7, "resolution_hint": 0.05, "slab_thickness": 0.05}
"""How Drake is asked to work out contact over areas, for shapes that do not ask for it: pascals, metres."""


@dataclass(frozen=True)
class Rested:
    """What a simulator made of a room.

    Attributes:
        poses: Where each asset was when it was loaded.
        moved: Metres between there and where it was in the end.
        masses: Kilograms of the assets that are free.
        joints: How many hinges and slides there are.
    """

    poses: Mapping[str, Spot]
    moved: Mapping[str, float]
    masses: Mapping[str, float]
    joints: int


def in_drake(path: Path, seconds: float) -> Rested:
    """Return what Drake makes of an MJCF model, an SDF world or a URDF with its robots."""
    plants: Any = import_module("pydrake.multibody.plant")
    builder = import_module("pydrake.systems.framework").DiagramBuilder()
    plant, geometry = plants.AddMultibodyPlantSceneGraph(builder, STEP)
    if path.suffix == ".xml":  # MJCF has no word for what SDF and URDF say themselves: contact over areas
        shapes: Any = import_module("pydrake.geometry")
        geometry.set_config(
            shapes.SceneGraphConfig(default_proximity_properties=shapes.DefaultProximityProperties(**AREAS))
        )
    parser = import_module("pydrake.multibody.parsing").Parser(plant, geometry)
    parser.package_map().Add("models", str(path.parent / "models"))
    parser.SetAutoRenaming(True)
    bodies: dict[str, Any] = {}
    if path.suffix == ".sdf":
        parser.AddModels(str(path))
        for name, include in _included(path):
            model = plant.GetModelInstanceByName(include.findtext("name", ""))
            bodies[name] = plant.get_body(plant.GetBodyIndices(model)[0])
    elif path.suffix == ".xml":
        (room,) = parser.AddModels(str(path))
        names = [body.attrib["name"] for body in ET.parse(path).getroot().findall("worldbody/body")]
        bodies = {name: plant.GetBodyByName(name, room) for name in names[1:]}  # the room comes first
    else:
        (room,) = parser.AddModels(str(path))
        for place in ET.parse(path).getroot().iter("place"):
            bodies[place.attrib["name"]] = _drake_body(plant, parser, room, path.parent, place)
    plant.Finalize()
    diagram = builder.Build()
    simulator = import_module("pydrake.systems.analysis").Simulator(diagram)
    context = plant.GetMyContextFromRoot(simulator.get_context())

    def spots() -> dict[str, Spot]:
        found = {name: plant.EvalBodyPoseInWorld(context, body) for name, body in bodies.items()}
        return {n: (*x.translation(), math.atan2(*x.rotation().matrix()[[1, 0], [0, 0]])) for n, x in found.items()}

    start = spots()
    simulator.AdvanceTo(seconds)
    free = {name: body for name, body in bodies.items() if body.is_floating_base_body()}
    masses = {name: _drake_mass(plant, body, alone=path.suffix != ".xml") for name, body in free.items()}
    joints = sum(plant.get_joint(index).num_positions() == 1 for index in plant.GetJointIndices())
    return Rested(start, _moved(start, spots()), masses, joints)


def _drake_mass(plant: Any, body: Any, *, alone: bool) -> float:
    """Return the kilograms of a body with its links, of all of its model where it is alone in that."""
    links = [plant.get_body(index) for index in plant.GetBodyIndices(body.model_instance())]
    return sum(link.default_mass() for link in links if alone or link.name().partition("/")[0] == body.name())


def _drake_body(plant: Any, parser: Any, room: Any, folder: Path, place: ET.Element) -> Any:
    """Return the body of an asset of a URDF, loaded where it is a robot of its own."""
    if "file" not in place.attrib:
        return plant.GetBodyByName(place.attrib["name"], room)
    (model,) = parser.AddModels(str(folder / place.attrib["file"]))
    body = plant.get_body(plant.GetBodyIndices(model)[0])
    maths: Any = import_module("pydrake.math")
    x, y, z, roll, pitch, yaw = _numbers(f"{place.attrib['xyz']} {place.attrib['rpy']}")
    plant.SetDefaultFloatingBaseBodyPose(body, maths.RigidTransform(maths.RollPitchYaw(roll, pitch, yaw), [x, y, z]))
    return body


def in_bullet(path: Path, seconds: float) -> Rested:
    """Return what PyBullet makes of an SDF world or a URDF with its robots."""
    bullet: Any = import_module("pybullet")
    bullet.connect(bullet.DIRECT)
    bullet.setGravity(0, 0, -9.81)
    bullet.setTimeStep(STEP)
    try:
        load = _bullet_sdf if path.suffix == ".sdf" else _bullet_urdf
        return _bullet_rests(bullet, dict(load(bullet, path)), seconds)
    finally:
        bullet.disconnect()


def _bullet_sdf(bullet: Any, path: Path) -> Iterator[tuple[str, tuple[int, int]]]:
    """Yield every asset's body and link of an SDF world; PyBullet reads no includes, so each is put where the world says."""
    world = ET.parse(path).getroot()
    welded = {joint.findtext("child", "").partition("::")[0] for joint in world.iter("joint")}
    kept = dict(map(reversed, ((name, include.findtext("name")) for name, include in _included(path))))
    for include in world.iter("include"):
        own = include.findtext("name", "")
        (body,) = bullet.loadSDF(str(path.parent / include.findtext("uri", "").removeprefix("model://") / "model.sdf"))
        *at, roll, pitch, yaw = _numbers(include.findtext("pose", ""))
        _, _, _, middle, turn, *_ = bullet.getDynamicsInfo(body, -1)
        place = bullet.multiplyTransforms(at, bullet.getQuaternionFromEuler([roll, pitch, yaw]), middle, turn)
        bullet.resetBasePositionAndOrientation(body, *place)
        if own in welded:
            bullet.changeDynamics(body, -1, mass=0)
        if own in kept:
            yield kept[own], (body, -1)
        else:
            yield "", (body, -1)


def _bullet_urdf(bullet: Any, path: Path) -> Iterator[tuple[str, tuple[int, int]]]:
    """Yield every asset's body and link of the room's robot and the others."""
    flags = bullet.URDF_USE_INERTIA_FROM_FILE
    room = bullet.loadURDF(str(path), flags=flags)
    joints = [bullet.getJointInfo(room, joint) for joint in range(bullet.getNumJoints(room))]
    links = {joint[12].decode(): joint[0] for joint in joints}
    for place in ET.parse(path).getroot().iter("place"):
        name = place.attrib["name"]
        if "file" in place.attrib:
            at, turn = _numbers(place.attrib["xyz"]), bullet.getQuaternionFromEuler(_numbers(place.attrib["rpy"]))
            yield name, (bullet.loadURDF(str(path.parent / place.attrib["file"]), at, turn, flags=flags), -1)
        else:
            yield name, (room, links[name])


def _bullet_rests(bullet: Any, bodies: dict[str, tuple[int, int]], seconds: float) -> Rested:
    every = {body for body, _ in bodies.values()}
    joints = [(b, j) for b in every for j in range(bullet.getNumJoints(b)) if bullet.getJointInfo(b, j)[2] != 4]
    for body, joint in joints:
        bullet.setJointMotorControl2(body, joint, bullet.VELOCITY_CONTROL, force=0)

    def spot(body: int, link: int) -> Spot:
        if link >= 0:
            at, turn = bullet.getLinkState(body, link)[4:6]
        else:
            inverse = bullet.invertTransform(*bullet.getDynamicsInfo(body, -1)[3:5])
            at, turn = bullet.multiplyTransforms(*bullet.getBasePositionAndOrientation(body), *inverse)
        return (*at, bullet.getEulerFromQuaternion(turn)[2])

    bodies = {name: where for name, where in bodies.items() if name}
    start = {name: spot(*where) for name, where in bodies.items()}
    for _ in range(math.ceil(seconds / STEP)):
        bullet.stepSimulation()
    weights = {name: _weight(bullet, body) for name, (body, link) in bodies.items() if link < 0}
    moved = _moved(start, {name: spot(*where) for name, where in bodies.items()})
    return Rested(start, moved, {name: weight for name, weight in weights.items() if weight}, len(joints))


def _weight(bullet: Any, body: int) -> float:
    """Return the mass of a body that is free, else 0."""
    base = bullet.getDynamicsInfo(body, -1)[0]
    return base and base + sum(bullet.getDynamicsInfo(body, j)[0] for j in range(bullet.getNumJoints(body)))


def _included(path: Path) -> Iterator[tuple[str, ET.Element]]:
    """Yield the assets of an SDF world."""
    for include in ET.parse(path).getroot().iter("include"):
        for child in include:
            if child.tag.endswith("}thing"):
                yield child.attrib["name"], include


def _numbers(text: str) -> list[float]:
    return [float(word) for word in text.split()]


def _moved(start: Mapping[str, Spot], end: Mapping[str, Spot]) -> dict[str, float]:
    return {name: math.dist(start[name][:3], end[name][:3]) for name in start}


SIMULATORS: Mapping[str, tuple[str, Callable[[Path, float], Rested]]] = {
    "Drake": ("pydrake", in_drake),
    "PyBullet": ("pybullet", in_bullet),
}
"""The package that each needs, and what loads a file in it."""
