"""Opening in MuJoCo: do doors and drawers open by their handles, and what do leaf and body touch meanwhile.

The body stands where it is said to, and steps back as it is said to. Its hand is a force at the handle along the way that the
joint leaves it, no larger than `PULL.most`, which follows an even motion from shut to open.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from robolayout.export._exporter import Options, is_movable
from robolayout.export._mujoco import ROOM_BODY, FloatArray, base, controls, load, simulator, smaller, touched
from robolayout.export.mjcf import build
from robolayout.scene import Agent, Hold, Layout, Scene, check_layout


@dataclass(frozen=True)
class PullConfig:
    """How a hand pulls a door or drawer open."""

    most: float = 160.0  # newtons at the most: heavy lids are lifted with two hands (judgement)
    speed: float = 0.25  # metres per second of the handle
    grip: float = 2_000.0  # newtons with which the hand pulls for each metre that the handle is behind
    ease: float = 200.0  # newtons for each metre per second
    linger: float = 0.5  # seconds that the hand stays where the leaf is to be open
    stop: float = 1.02  # share of its range to where the hand pulls, against the stop
    open: float = 0.99  # share from where a door or drawer is open
    aside: float = 100.0  # metres to which what is moved away is moved


PULL = PullConfig()


@dataclass(frozen=True)
class Pulled:
    """How one door or drawer went."""

    share: float  # how far it opened in the end, as a share of its range
    contacts: tuple[str, ...]  # names of what the leaf or the body touched (assets, "wall-0"), sorted
    force: float  # newtons that the hand pulled with at most

    @property
    def ok(self) -> bool:
        """Whether it opened to its stop and nothing was touched."""
        return self.share >= PULL.open and not self.contacts


@dataclass(frozen=True)
class Opened:
    """How a body's doors and drawers went."""

    agent: str  # name of the agent
    joints: Mapping[str, Pulled]  # by name of the thing and its joint

    @property
    def violations(self) -> tuple[str, ...]:
        """One sentence for each door or drawer that did not open freely."""
        return tuple(
            f"{self.agent} opens {name} by {pulled.share:.0%} of its range"
            f"{' and touches ' + ', '.join(pulled.contacts) if pulled.contacts else ''}."
            for name, pulled in self.joints.items()
            if not pulled.ok
        )


def pull_open(scene: Scene, layout: Layout, agent: Agent, holds: Iterable[Hold]) -> Opened:
    """Open doors and drawers by their handles, each from the layout as it is, and report what is touched.

    The doors of the room are pulled too, as by one who comes in: nobody is in the room. Movable furniture is free to be dragged
    along. What the body finds no place to stand for (`holds`) stays shut.

    Raises:
        LayoutError: The layout does not fit the scene.
        MissingExtraError: MuJoCo is not installed.
    """
    check_layout(scene, layout, partial=True)
    model, data = load(build(scene, layout, Options(agent=smaller(agent, disc=False)), free=is_movable), dozing=True)
    doors = [_Hand(model, int(joint)) for joint in np.flatnonzero(model.body_rootid[model.jnt_bodyid] == ROOM_BODY)]
    found: dict[str, Pulled] = {}
    for hold in holds:
        hand = _Hand(model, int(model.joint(f"{hold.asset}/{hold.joint}").id))
        found[hand.name] = _pulled(model, data, hand, doors, hold) if hold.poses else Pulled(0.0, (), 0.0)
    return Opened(agent.name, found | {hand.name: _pulled(model, data, hand, doors) for hand in doors})


def _pulled(model: Any, data: Any, hand: _Hand, doors: Iterable[_Hand], hold: Hold | None = None) -> Pulled:
    """Open one joint from shut to open, the room's other doors being open."""
    mujoco, step = simulator(), float(model.opt.timestep)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    for name in hold.moved if hold else ():
        data.qpos[model.joint(name).qposadr[0]] += PULL.aside
    for door in doors:
        data.qpos[door.place] = door.ends[1]
    data.qpos[hand.place] = hand.ends[0]
    mujoco.mj_forward(model, data)
    seconds = hand.span * float(np.linalg.norm(hand.way(data))) / PULL.speed
    shares = np.minimum(np.arange(0.0, seconds + PULL.linger, step) / seconds, PULL.stop)
    poses = np.array(hold.poses if hold else [(PULL.aside, PULL.aside, 0.0)])
    wanted = np.stack(
        [np.interp(shares * (len(poses) - 1), np.arange(len(poses)), column) for column in poses.T], axis=1
    )
    body, places = base(model)
    data.qpos[places] = wanted[0]
    met, most = set[str](), 0.0
    for order, share in zip(controls(model, wanted), shares, strict=True):
        data.ctrl[:] = order
        most = max(most, abs(hand.pull(data, float(share), seconds)))
        mujoco.mj_step(model, data)
        met |= touched(model, data, body) | touched(model, data, hand.leaf)
    return Pulled(hand.opened(data), tuple(sorted(met)), most)


class _Hand:
    """A hand at the handle of a joint."""

    def __init__(self, model: Any, number: int) -> None:
        joint = model.joint(number)
        self.name = str(joint.name)
        self._model, self._site, self._joint = model, model.site(f"{self.name}/handle").id, number
        self._speed, self.place = int(joint.dofadr[0]), int(joint.qposadr[0])
        self.leaf, self.ends = int(joint.bodyid[0]), joint.range.tolist()
        self.span = self.ends[1] - self.ends[0]
        self._slides = int(joint.type[0]) == int(simulator().mjtJoint.mjJNT_SLIDE)

    def way(self, data: Any) -> FloatArray:
        """Return how the handle moves in metres for each radian or metre that the joint opens."""
        axis = data.xaxis[self._joint]
        return axis if self._slides else np.cross(axis, data.site_xpos[self._site] - data.xanchor[self._joint])

    def opened(self, data: Any) -> float:
        """Return how far it is open, as a share of its range."""
        return (float(data.qpos[self.place]) - self.ends[0]) / self.span

    def pull(self, data: Any, share: float, seconds: float) -> float:
        """Pull towards a share of the range, of which all is to be open after so many seconds; return with what force."""
        way = self.way(data)
        lever = float(np.linalg.norm(way))
        behind = (share - self.opened(data)) * self.span * lever
        slower = ((self.span / seconds if share < PULL.stop else 0.0) - float(data.qvel[self._speed])) * lever
        force = float(np.clip(PULL.grip * behind + PULL.ease * slower, -PULL.most, PULL.most))
        data.qfrc_applied[:] = 0.0
        push, place = force * way / lever, data.site_xpos[self._site]
        simulator().mj_applyFT(self._model, data, push, np.zeros(3), place, self.leaf, data.qfrc_applied)
        return force
