"""What the checks in MuJoCo share: loading a model, moving its base, and saying what touches."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np

from robolayout._errors import MissingExtraError
from robolayout.export._bodies import BODIES
from robolayout.export._mesh import FloatArray as FloatArray
from robolayout.export.mjcf import BASE
from robolayout.scene import Agent

ROOM_BODY = 1  # the room's body in a model: the first after the world


def simulator() -> Any:
    """Return MuJoCo's module, which has no types; raise MissingExtraError where it is not installed."""
    if find_spec("mujoco") is None:
        raise MissingExtraError("the physics check", "sim")
    return import_module("mujoco")


def load(made: tuple[bytes, dict[str, bytes]], *, dozing: bool = False) -> tuple[Any, Any]:
    """Return MuJoCo's model and state for a model's text and meshes; what dozes takes no time until something moves it."""
    mujoco, (text, meshes) = simulator(), made
    model = mujoco.MjModel.from_xml_string(text.decode(), meshes)
    if dozing:
        model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_SLEEP
    return model, mujoco.MjData(model)


def smaller(agent: Agent, *, disc: bool) -> Agent:
    """Return a body as it is moved: its rectangle, or its disc if that is asked for or all that it has.

    What is just as high as it steps over, or as it is, does not touch it.
    """
    body = replace(agent, step=agent.step + BODIES.thinnest, height=agent.height - BODIES.thinnest)
    if disc or agent.length is None or agent.width is None:
        return replace(body, radius=agent.radius - BASE.margin, length=None, width=None)
    return replace(body, length=agent.length - 2 * BASE.margin, width=agent.width - 2 * BASE.margin)


def base(model: Any) -> tuple[int, list[int]]:
    """Return the body of the base, and where its x, y and yaw are among all positions."""
    joints = model.actuator_trnid[:3, 0]
    return int(model.jnt_bodyid[joints[0]]), [int(model.jnt_qposadr[joint]) for joint in joints]


def controls(model: Any, wanted: FloatArray) -> FloatArray:
    """Return what the base's actuators are told so that it is at these poses (n, 3), a step each: speed and push fed forward."""
    step = float(model.opt.timestep)
    rates = np.gradient(wanted, step, axis=0)
    push = np.gradient(rates, step, axis=0) * np.array([BASE.mass, BASE.mass, 0.0])
    return wanted - model.key_qpos[0, -3:] + rates * (BASE.damping / BASE.stiffness) + push / BASE.stiffness


def touched(model: Any, data: Any, body: int) -> set[str]:
    """Return the names of what a body touches now: assets, and parts of the room."""
    if not data.ncon:
        return set()
    pairs = data.contact.geom[: data.ncon]
    own = model.geom_bodyid[pairs] == body
    met = {str(model.geom(geom).name) for geom in pairs[~own & own.any(axis=1, keepdims=True)].tolist()}
    sized = {str(model.numeric(number).name) for number in range(model.nnumeric if met else 0)}
    owners = (name.rsplit("/", 2) for name in met)  # a thing, its part and a number; the floor has none
    return {thing if f"size/{thing}" in sized else part for thing, part, *_ in owners}
