"""Opening in MuJoCo: do doors and drawers open by their handles, and what do leaf and body touch meanwhile.

The body stands where it is said to, and steps back as it is said to. Its hand is a force at the handle along the way that the
joint leaves it, no larger than `PULL`, which follows an even motion from shut to open.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from robolayout.export._exporter import Options, check_layout, is_movable
from robolayout.export._mujoco import FloatArray, base, controls, load, simulator, smaller, touched
from robolayout.export.mjcf import build
from robolayout.scene import Agent, Layout, Scene

PULL = 160.0
"""Newtons at the most: heavy lids are lifted with two hands (judgement)."""

SPEED = 0.25
"""Metres per second of the handle."""

GRIP, EASE = 2_000.0, 200.0
"""What the hand pulls with: newtons for each metre that the handle is behind, and for each metre per second."""

LINGER = 0.5
"""Seconds that the hand stays where the leaf is to be open."""

OPEN = 0.95
"""Share of its range from which a door or drawer is open; a handle may meet the wall beside it after that."""

ASIDE = 100.0
"""Metres to which what is moved away is moved."""


class Hold(Protocol):
    """How a body opens a door or drawer; `Usage.holds` of a report has them."""

    @property
    def asset(self) -> str:
        """The name of the thing."""
        ...

    @property
    def joint(self) -> str:
        """The name of what moves."""
        ...

    @property
    def poses(self) -> Sequence[tuple[float, float, float]]:
        """Where the body is (x, y, heading) at even steps from shut to open; nowhere if it finds no place."""
        ...

    @property
    def moved(self) -> Sequence[str]:
        """What is moved away before."""
        ...


@dataclass(frozen=True)
class Pulled:
    """How one door or drawer went."""

    share: float  # how far it opened in the end, as a share of its range
    free: float  # how far it had opened when the leaf or the body first touched something; `share` if they touched nothing
    contacts: tuple[str, ...]  # names of what they touched (assets, "wall-0"), sorted
    force: float  # newtons that the hand pulled with at most

    @property
    def ok(self) -> bool:
        """Whether it opened before anything was touched."""
        return self.free >= OPEN


@dataclass(frozen=True)
class Opened:
    """How a body's doors and drawers went."""

    agent: str  # name of the agent
    joints: Mapping[str, Pulled]  # by name of the thing and its joint

    @property
    def violations(self) -> tuple[str, ...]:
        """One sentence for each door or drawer that did not open freely."""
        return tuple(
            f"{self.agent} opens {name} by {pulled.free:.0%} of its range"
            f"{', then ' + ', '.join(pulled.contacts) + ' is touched' if pulled.contacts else ''}."
            for name, pulled in self.joints.items()
            if not pulled.ok
        )


def pull_open(scene: Scene, layout: Layout, agent: Agent, holds: Iterable[Hold]) -> Opened:
    """Open doors and drawers by their handles, each from the layout as it is, and report what is touched.

    Args:
        scene: The scene.
        layout: Where everything stands; movable furniture is free to be dragged along.
        agent: The body.
        holds: Where it stands for each, and what is moved away; what it finds no place for stays shut.

    Raises:
        LayoutError: The layout does not fit the scene.
        MissingExtraError: MuJoCo is not installed.
    """
    check_layout(scene, layout, partial=True)
    options = Options(agent=smaller(agent, disc=False), leaves="open")
    model, data = load(build(scene, layout, options, free=is_movable))
    shut = Pulled(0.0, 0.0, (), 0.0)
    found = {f"{h.asset}/{h.joint}": _pulled(model, data, h) if h.poses else shut for h in holds}
    return Opened(agent.name, found)


def _pulled(model: Any, data: Any, hold: Hold) -> Pulled:
    """Open one joint from shut to open."""
    mujoco, step, poses = simulator(), float(model.opt.timestep), np.array(hold.poses)
    hand = _Hand(model, f"{hold.asset}/{hold.joint}")
    mujoco.mj_resetDataKeyframe(model, data, 0)
    for name in hold.moved:
        data.qpos[model.joint(name).qposadr[0]] += ASIDE
    mujoco.mj_forward(model, data)
    seconds = hand.span * float(np.linalg.norm(hand.way(data))) / SPEED
    shares = np.minimum(np.arange(0.0, seconds + LINGER, step) / seconds, 1.0)
    wanted = np.stack(
        [np.interp(shares * (len(poses) - 1), np.arange(len(poses)), column) for column in poses.T], axis=1
    )
    body, places = base(model)
    data.qpos[places] = wanted[0]
    met, most, free = set[str](), 0.0, 0.0
    for order, share in zip(controls(model, wanted), shares, strict=True):
        data.ctrl[:] = order
        most = max(most, abs(hand.pull(data, float(share), seconds)))
        mujoco.mj_step(model, data)
        met |= touched(model, data, [body]) | touched(model, data, [hand.leaf])
        free = free if met else max(free, hand.opened(data))
    return Pulled(hand.opened(data), free, tuple(sorted(met)), most)


class _Hand:
    """A hand at the handle of a joint."""

    def __init__(self, model: Any, name: str) -> None:
        joint = model.joint(name)
        self._model, self._site, self._joint = model, model.site(f"{name}/handle").id, int(joint.id)
        self._speed, self._place = int(joint.dofadr[0]), int(joint.qposadr[0])
        self.leaf, self.span = int(joint.bodyid[0]), float(joint.range[1])
        self._slides = int(joint.type[0]) == int(simulator().mjtJoint.mjJNT_SLIDE)

    def way(self, data: Any) -> FloatArray:
        """Return how the handle moves in metres for each radian or metre that the joint opens."""
        axis = data.xaxis[self._joint]
        return axis if self._slides else np.cross(axis, data.site_xpos[self._site] - data.xanchor[self._joint])

    def opened(self, data: Any) -> float:
        """Return how far it is open, as a share of its range."""
        return float(data.qpos[self._place]) / self.span

    def pull(self, data: Any, share: float, seconds: float) -> float:
        """Pull towards a share of the range, of which all is to be open after so many seconds; return with what force."""
        way = self.way(data)
        lever = float(np.linalg.norm(way))
        behind = (share * self.span - float(data.qpos[self._place])) * lever
        slower = ((self.span / seconds if share < 1.0 else 0.0) - float(data.qvel[self._speed])) * lever
        force = float(np.clip(GRIP * behind + EASE * slower, -PULL, PULL))
        data.qfrc_applied[:] = 0.0
        simulator().mj_applyFT(
            self._model,
            data,
            force * way / lever,
            np.zeros(3),
            data.site_xpos[self._site],
            self.leaf,
            data.qfrc_applied,
        )
        return force
