"""Physics checks in MuJoCo: does the furniture stay where it stands, and does the agent's base get through.

Both build the MJCF model in memory. `settle` lets gravity work on everything that stands; `drive` holds the furniture still and
moves the base along its planned routes.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from robolayout.constraints import hangs
from robolayout.export._exporter import Options
from robolayout.export._mujoco import FloatArray, base, controls, load, simulator, smaller, touched
from robolayout.export.mjcf import build
from robolayout.scene import Agent, Asset, Layout, Scene, check_layout


@dataclass(frozen=True)
class MotionConfig:
    """When a thing counts as still, and how a body drives."""

    still: float = 0.01  # metres by which a stable asset moves at the most
    upright: float = math.radians(2.0)  # radians by which it tilts at the most
    acceleration: float = 0.5  # metres per second squared
    slowest: float = 0.05  # metres per second around a sharp corner
    turn_rate: float = 1.0  # radians per second of a long body that turns on the spot
    spacing: float = 0.01  # metres between the points of a driven line
    settling: float = 0.3  # seconds of standing still at the end of a way


MOTION = MotionConfig()


Ways = Mapping[str, Sequence[Sequence[float]]]
"""Places or poses on the way to each asset, by asset name."""


@dataclass(frozen=True)
class Motion:
    """How far one asset moved."""

    # metres between where its centre was and where it came to rest, or one of its handles if that is more
    displacement: float
    tilt: float  # radians between its upright axis and the vertical

    @property
    def stable(self) -> bool:
        """Whether it moved by less than 1 cm and tilted by less than 2 degrees."""
        return self.displacement < MOTION.still and self.tilt < MOTION.upright


@dataclass(frozen=True)
class Settled:
    """What gravity did to a layout."""

    seconds: float  # simulated time
    # how far each placed asset moved; what hangs on walls or the ceiling is held and does not
    motions: Mapping[str, Motion]
    unplaced: tuple[str, ...] = ()  # names of the assets without a pose; they count as not stable

    @property
    def stable_share(self) -> float:
        """Share of all assets that stayed where they are; 1 for an empty scene."""
        total = len(self.motions) + len(self.unplaced)
        return sum(motion.stable for motion in self.motions.values()) / total if total else 1.0

    @property
    def violations(self) -> tuple[str, ...]:
        """One sentence for each asset that did not stay."""
        return tuple(
            f"{name} does not stay: it moved {motion.displacement * 100:.1f} cm and tilts {math.degrees(motion.tilt):.1f} "
            f"degrees after {self.seconds:g} s of gravity."
            for name, motion in self.motions.items()
            if not motion.stable
        )

    def to_dict(self) -> dict[str, object]:
        """Return the figures in metres and degrees."""
        rows = {
            name: {
                "displacement": round(motion.displacement, 5) if math.isfinite(motion.displacement) else None,
                "tilt": round(math.degrees(motion.tilt), 3),
                "stable": motion.stable,
            }
            for name, motion in self.motions.items()
        }
        return {
            "seconds": self.seconds,
            "stable_share": self.stable_share,
            "assets": rows,
            "unplaced": [*self.unplaced],
            "violations": [*self.violations],
        }


@dataclass(frozen=True)
class DrivenRoute:
    """How one route went."""

    contacts: tuple[str, ...]  # names of what the base touched (assets, "wall-0", "door-0"), sorted
    error: float  # largest distance in metres between the planned and the driven position
    length: float  # length of the route in metres
    seconds: float  # time it took


@dataclass(frozen=True)
class Driven:
    """How an agent's routes went."""

    agent: str  # name of the agent
    drives: Mapping[str, DrivenRoute]  # one drive for each asset with a route

    @property
    def contacts(self) -> Mapping[str, tuple[str, ...]]:
        """What was touched on the way to each asset, where anything was."""
        return {name: drive.contacts for name, drive in self.drives.items() if drive.contacts}

    @property
    def violations(self) -> tuple[str, ...]:
        """One sentence for each route on which something was touched."""
        return tuple(
            f"{self.agent} touches {', '.join(names)} on its way to {target}."
            for target, names in self.contacts.items()
        )

    def to_dict(self) -> dict[str, object]:
        """Return the figures in metres and seconds."""
        rows = {
            name: {
                "contacts": [*drive.contacts],
                "error": round(drive.error, 4),
                "length": round(drive.length, 3),
                "seconds": round(drive.seconds, 2),
            }
            for name, drive in self.drives.items()
        }
        return {"agent": self.agent, "routes": rows, "violations": [*self.violations]}


def _stands(asset: Asset, scene: Scene, layout: Layout) -> bool:
    """Return whether gravity may move an asset: all but rugs and what is fixed to walls or the ceiling."""
    return not asset.is_flat and not hangs(asset, scene, layout)


def settle(scene: Scene, layout: Layout, seconds: float = 5.0, *, seed: int = 0) -> Settled:
    """Let gravity work on a layout and measure what moves.

    Everything that stands is free, built-in furniture too: a wardrobe that would fall over is found. Assets without a pose
    count as not stable. `seed` is that of the parametric meshes.

    Raises:
        LayoutError: The layout names an asset that the scene does not have, or holds a pose that is not finite.
        MissingExtraError: MuJoCo is not installed.
    """
    check_layout(scene, layout, partial=True)
    mujoco = simulator()
    model, data = load(build(scene, layout, Options(seed=seed), free=_stands))
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_AUTORESET
    mujoco.mj_forward(model, data)
    names = [asset.name for asset in scene.assets if asset.name in layout]
    before = {name: data.body(name).xpos.copy() for name in names}
    handles, held = data.site_xpos.copy(), [str(model.body(root).name) for root in model.body_rootid[model.site_bodyid]]
    for _ in range(math.ceil(seconds / model.opt.timestep)):
        mujoco.mj_step(model, data)
    mujoco.mj_forward(model, data)
    motions = {name: _motion(before[name], data.body(name).xpos, data.body(name).xmat) for name in names}
    for name, moved in zip(held, np.linalg.norm(data.site_xpos - handles, axis=1).tolist(), strict=True):
        if name in motions and moved > motions[name].displacement:
            motions[name] = replace(motions[name], displacement=moved)
    unplaced = tuple(asset.name for asset in scene.assets if asset.name not in layout)
    return Settled(seconds, motions, unplaced)


def _motion(before: FloatArray, after: FloatArray, axes: FloatArray) -> Motion:
    """Return how far a body moved; a simulation that broke down counts as infinitely far."""
    if not (np.isfinite(after).all() and np.isfinite(axes).all()):
        return Motion(math.inf, math.pi)
    tilt = math.acos(min(1.0, max(-1.0, float(axes[8]))))
    return Motion(float(np.linalg.norm(after - before)), tilt)


def drive(
    scene: Scene, layout: Layout, agent: Agent, ways: Ways, speed: float = 0.5, *, leaves: str = "open"
) -> Driven:
    """Drive an agent's footprint along its ways and report what it touches.

    The base follows each way with position and velocity fed forward, slowing down for corners; the furniture holds still.

    Args:
        ways: Places (x, y) of the middle of its disc on the way to each asset, metres, or (x, y, heading in radians) of its
            rectangular footprint, by asset name; ways of fewer than two places are skipped, since there is nothing to drive.
        speed: Metres per second.
        leaves: How the doors of the room stand, one of `LEAVES`; a body that comes in finds them open.

    Raises:
        LayoutError: The layout does not fit the scene.
        MissingExtraError: MuJoCo is not installed.
    """
    check_layout(scene, layout, partial=True)
    driven = {name: np.array(way, dtype=float) for name, way in ways.items() if len(way) > 1}
    body = smaller(agent, disc=any(way.shape[1] < 3 for way in driven.values()))
    model, data = load(build(scene, layout, Options(agent=body, leaves=leaves), free=None), dozing=True)
    return Driven(agent.name, {name: _drive(model, data, way, speed) for name, way in driven.items()})


def _drive(model: Any, data: Any, way: FloatArray, speed: float) -> DrivenRoute:
    """Drive one way from standstill to standstill."""
    mujoco, (times, path) = simulator(), timeline(way, speed)
    clock = np.arange(0.0, times[-1] + MOTION.settling, float(model.opt.timestep))
    wanted = np.stack([np.interp(clock, times, column) for column in path.T], axis=1)
    orders, (body, places) = controls(model, wanted), base(model)
    mujoco.mj_resetData(model, data)
    data.qpos[places] = wanted[0]
    met: set[str] = set()
    error = 0.0
    for goal, order in zip(wanted[1:], orders[:-1], strict=True):
        data.ctrl[:] = order
        mujoco.mj_step(model, data)
        error = max(error, math.dist(data.qpos[places[:2]], goal[:2]))
        met |= touched(model, data, body)
    length = float(np.hypot(*np.diff(way[:, :2], axis=0).T).sum())
    return DrivenRoute(tuple(sorted(met)), error, length, float(times[-1]))


def timeline(way: FloatArray, speed: float) -> tuple[FloatArray, FloatArray]:
    """Return when the base is where: times (n,) in seconds and poses (n, 3) as x, y, yaw.

    It starts and ends at rest, accelerates by no more than `MOTION.acceleration`, turns no faster than `MOTION.turn_rate` and slows down at
    corners: the cosine of the change of direction tells how much of the speed (m/s) is kept, so it stops to drive back. The way is
    (m, 2) places, on which the yaw stays 0, or (m, 3) poses, between which it turns evenly.
    """
    poses = np.pad(way, ((0, 0), (0, 3 - way.shape[1])))
    counts = [max(1, math.ceil(np.abs(step).max() / MOTION.spacing)) for step in np.diff(poses, axis=0)]
    fine = [np.linspace(a, b, n, endpoint=False) for a, b, n in zip(poses[:-1], poses[1:], counts, strict=True)]
    path = np.concatenate([*fine, poses[-1:]])
    path = path[np.append(np.abs(np.diff(path, axis=0)).max(axis=1) > 0.0, True)]
    steps = np.diff(path, axis=0)
    lengths, turned = np.hypot(steps[:, 0], steps[:, 1]), np.abs(steps[:, 2])
    kept = np.clip(np.cos(np.diff(np.arctan2(steps[:, 1], steps[:, 0]))), 0.0, 1.0) ** 2
    moving = (lengths[1:] > 0.0) & (lengths[:-1] > 0.0)
    rates = np.concatenate([[0.0], speed * kept * moving, [0.0]])[: len(path)]
    for order in (range(1, len(path)), range(len(path) - 2, -1, -1)):
        for i in order:
            before = i - order.step
            rates[i] = min(rates[i], math.sqrt(rates[before] ** 2 + 2 * MOTION.acceleration * lengths[min(i, before)]))
    spent = np.maximum(lengths / np.maximum((rates[1:] + rates[:-1]) / 2, MOTION.slowest), turned / MOTION.turn_rate)
    times = np.concatenate([[0.0], np.cumsum(spent)])
    return np.append(times, times[-1] + MOTION.spacing), np.concatenate([path, path[-1:]])
