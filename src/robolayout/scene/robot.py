"""An agent from a robot's URDF or MJCF model: footprint and height of its collision geometry, how it drives, where its hand gets to.

Shapes become convex hulls in the frame of the root link (x ahead, z up). A body whose farthest point is hardly farther than
its sides is a disc, every other a rectangle. It drives about in the pose that is given, else in the one that the file names
(a keyframe `stow` or `home`), else with its arms folded.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from robolayout._errors import UnknownNameError
from robolayout._reading import show
from robolayout.scene._model import CHECK, Matrix, Model
from robolayout.scene.agent import BODY, Agent, Figure, Source
from robolayout.scene.kinematics import FOLDING, Robot
from robolayout.scene.mjcf import read_mjcf
from robolayout.scene.urdf import read_urdf


def load_robot(path: Path, pose: Mapping[str, float] | None = None) -> Agent:
    """Return the agent whose body is the collision geometry of a URDF or MJCF file, its joints at `pose` (radians, metres), else folded."""
    model = Model(path)
    root, text = model.root(path)
    if root.tag not in ("robot", "mujoco"):
        raise model.fail(f"starts with <{show(root.tag)}>, but a URDF starts with <robot> and an MJCF with <mujoco>.")
    kind = "URDF" if root.tag == "robot" else "MJCF"
    body = read_urdf(root, text, model) if kind == "URDF" else read_mjcf(root, model)
    if pose is not None:
        values, how = _given(body, pose, model), "in the pose given"
    elif body.home is not None:
        values, how = dict(body.home), "in its keyframe"
    else:
        values, how = body.folded(), "its arms folded" if body.arms else "joints at zero"
    points = body.points({name: np.array([value]) for name, value in values.items()})[0]
    agent = _agent(points, f"collision geometry of the {kind} model {body.name}, {how}", body)
    middle = np.zeros(2) if agent.length is None else (points.min(axis=0) + points.max(axis=0))[:2] / 2
    foot = (float(middle[0]), float(middle[1]), float(points[:, 2].min()))
    follow = ((joint.name, joint.mimics) for joint in body.joints if joint.mimics is not None)
    led = {name: by * values.get(leader, 0.0) + off for name, (leader, by, off) in follow}
    return replace(agent, figure=Figure(path, {**values, **led}, foot))


def _given(body: Robot, pose: Mapping[str, float], model: Model) -> dict[str, float]:
    """Return the pose that the user gives, checked."""
    movable = {joint.name: joint for joint in body.joints if joint.kind != "fixed" and joint.mimics is None}
    for name, value in pose.items():
        if name not in movable:
            raise UnknownNameError(f"joint of {model.path.name}", name[:100], movable)
        low, high = movable[name].low, movable[name].high
        where = f"pose of joint {show(name)} (radians or metres)"
        CHECK.number(value, where, least=low, most=high, is_length=False)
    return {**body.rest, **pose}


def _reach(body: Robot, floor: float, within: float, about: str) -> dict[str, Any]:
    """Return the figures of what its hand gets to: how far at every height at which it gets farther than the body, `within` metres."""
    bands = [band for band in body.reach(floor) if band[2] > within]
    if not bands:
        return {}
    source = Source(f"{FOLDING.poses} random poses of the arm to {body.hand}, {about}", verified=True)
    bands = tuple((low, high, math.floor(far * 1e3) / 1e3) for low, high, far in bands)
    figures = {"reach_distance": max(far for _, _, far in bands), "reach_low": bands[0][0], "reach_high": bands[-1][1]}
    return {**figures, "reach_bands": bands, "sources": dict.fromkeys(figures, source)}


def _agent(points: Matrix, about: str, body: Robot) -> Agent:
    """Return the agent that just holds the points, given in the frame of the root link."""
    low, high = points.min(axis=0), points.max(axis=0)
    size, name = high - low, body.name
    farthest = float(np.hypot(points[:, 0], points[:, 1]).max())
    reach = _reach(body, float(low[2]), farthest, about)
    known = Source(about, verified=True)
    figures = {"height": _round(size[2]), "radius": _round(farthest)}
    sources = {**reach.pop("sources", {}), **dict.fromkeys(figures, known)}
    sources["step"] = Source("not in a robot's model; the general default", verified=False)
    is_square = max(size[:2]) < 1.25 * min(size[:2])
    if not is_square or farthest > BODY.round * max(abs(low[0]), abs(low[1]), high[0], high[1]):
        length, width = _round(size[0]), _round(size[1])
        arc = body.turning()
        circle = _round(2 * math.hypot(arc + width / 2, length) if arc else 2 * farthest)
        figures |= {"length": length, "width": width, "radius": _round(width / 2 + BODY.clearance)}
        figures |= {"turning_diameter": circle} if circle > 1.05 * math.hypot(length, width) else {}
        figures |= {} if arc is None else {"turning_radius": _round(arc)}
        sources |= dict.fromkeys(("length", "width", "turning_diameter"), known)
        sources["turning_radius"] = Source(f"wheels of the model, {about}", verified=True)
        sources["radius"] = Source(f"half the width and {BODY.clearance} m, {about}", verified=False)
    return Agent(name, step=BODY.step, title=name, sources=sources, **figures, **reach)


def _round(value: float) -> float:
    """Return a length rounded up to a tenth of a millimetre."""
    return math.ceil(float(value) * 1e4 - 1e-6) / 1e4
