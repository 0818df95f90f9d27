"""How far things are from where the program put them, and what each would violate there."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from robolayout._text import TOLD
from robolayout.scene import Agent, Layout, Pose, Scene
from robolayout.verify._boxes import boxes, in_plan
from robolayout.verify.agent_report import judge_agent
from robolayout.verify.limits import JUDGE
from robolayout.verify.physics import physics

if TYPE_CHECKING:
    from robolayout.program import Guess, Program


@dataclass(frozen=True)
class Move:
    """One thing that is not where the program put it."""

    asset: str  # its name
    metres: float  # how far it was moved, in plan
    degrees: float  # by how much it was turned, without sign
    # what would be violated if it stood there and everything else as it is, in words; empty if nothing would
    why: tuple[str, ...]

    @property
    def sentence(self) -> str:
        """The same in a sentence."""
        turned = f" and turned by {self.degrees:.0f} degrees" if self.degrees > JUDGE.straight else ""
        why = "; ".join(text.rstrip(".") for text in self.why[: TOLD.named])
        there = why or "nothing would be violated by it alone"
        return f"{self.asset} was moved by {self.metres:.2f} m{turned}. Where the program put it: {there}."

    def to_dict(self) -> dict[str, Any]:
        """Return plain data."""
        return vars(self) | {"why": list(self.why)}


def moves(scene: Scene, layout: Layout, program: Program | None, agents: tuple[Agent, ...]) -> tuple[Move, ...]:
    """Return what was moved from a program's guess, the farthest first."""
    guesses = {} if program is None else {name: program.guesses[name] for name in program.guesses if name in layout}
    off = {name: _off(layout[name], guess) for name, guess in guesses.items() if name in scene.by_name}
    off = {name: far for name, far in off.items() if far[0] > JUDGE.still or far[1] > JUDGE.straight}
    if program is None or not off:
        return ()
    now = set(_wrong(scene, layout, program, agents))
    there = {name: _wrong(scene, _back(scene, layout, name, guesses[name]), program, agents) for name in off}
    told = [Move(name, *far, tuple(text for text in there[name] if text not in now)) for name, far in off.items()]
    return tuple(sorted(told, key=lambda move: (-move.metres, -move.degrees, move.asset)))


def _off(pose: Pose, guess: Guess) -> tuple[float, float]:
    """Return how many metres and degrees a thing is from where the program put it, if it did."""
    if guess.position is None:
        return 0.0, 0.0
    turned = 0.0 if guess.yaw is None else math.remainder(pose.yaw - guess.yaw, math.tau)
    return math.dist((pose.x, pose.y), guess.position[:2]), abs(math.degrees(turned))


def _back(scene: Scene, layout: Layout, name: str, guess: Guess) -> Layout:
    """Return the layout with one thing where the program put it, and what stands on it where it then is."""
    here, found = layout[name], boxes(scene, layout)
    assert guess.position is not None
    there = Pose(*guess.position[:2], here.z, here.yaw if guess.yaw is None else guess.yaw)
    turn = there.yaw - here.yaw
    poses: dict[str, Pose] = {**layout, name: there}
    for row, other in enumerate(found.names):
        if other != name and found.names.index(name) in found.chain(row):
            pose = layout[other]
            x, y = in_plan(np.array([pose.x - here.x, pose.y - here.y]), (there.x, there.y, 0.0, turn)).tolist()
            poses[other] = Pose(x, y, pose.z, pose.yaw + turn)
    return Layout(poses)


def _wrong(scene: Scene, layout: Layout, program: Program, agents: tuple[Agent, ...]) -> list[str]:
    """Return what is wrong in a layout: physics, what bodies cannot reach or use, statements that do not hold."""
    found = list(physics(scene, layout).reasons)
    for agent in agents:
        body = judge_agent(scene, layout, agent)
        reached = body.navigation.reached
        short = sorted(body.short, key=lambda name: reached[name])
        found += [f"{agent.name} cannot {'use' if reached[name] else 'reach'} {name}" for name in short]
    for statement in program.statements:
        relation = statement.relation
        if {*relation.asset_names()} <= {*layout} and not relation.check(scene, layout).met:
            found.append(f"statement {statement.number}, {relation.sentence()}, is not met")
    return found
