"""How far things are from where the program put them, and what each would violate there."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from robolayout._text import TOLD
from robolayout.scene import Agent, Layout, Pose, Scene
from robolayout.verify._boxes import boxes
from robolayout.verify.limits import JUDGE
from robolayout.verify.navigation import navigation
from robolayout.verify.physics import physics
from robolayout.verify.proofs import exempt_from_reach, exempt_from_use
from robolayout.verify.use import usage

if TYPE_CHECKING:
    from robolayout.program import Program


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
    if program is None or not (found := [move for move in _off(layout, program) if move.asset in scene.by_name]):
        return ()
    now = set(_wrong(scene, layout, program, agents))
    told: list[Move] = []
    for move in found:
        there = _wrong(scene, _back(scene, layout, program, move.asset), program, agents)
        told.append(replace(move, why=tuple(text for text in there if text not in now)))
    return tuple(sorted(told, key=lambda move: (-move.metres, -move.degrees, move.asset)))


def _off(layout: Layout, program: Program) -> list[Move]:
    """Return what is not where the program put it, without reasons."""
    found: list[Move] = []
    for name, guess in program.guesses.items():
        if guess.position is None or name not in layout:
            continue
        pose = layout[name]
        metres = math.dist((pose.x, pose.y), guess.position[:2])
        degrees = 0.0 if guess.yaw is None else abs(math.degrees(math.remainder(pose.yaw - guess.yaw, math.tau)))
        if metres > JUDGE.still or degrees > JUDGE.straight:
            found.append(Move(name, metres, degrees, ()))
    return found


def _back(scene: Scene, layout: Layout, program: Program, name: str) -> Layout:
    """Return the layout with one thing where the program put it, and what stands on it where it then is."""
    guess, here = program.guesses[name], layout[name]
    assert guess.position is not None
    there = Pose(*guess.position[:2], here.z, here.yaw if guess.yaw is None else guess.yaw)
    turn = there.yaw - here.yaw
    c, s = math.cos(turn), math.sin(turn)
    poses: dict[str, Pose] = {**layout, name: there}
    found = boxes(scene, layout)
    chains = {other: {found.names[row] for row in found.chain(at)} for at, other in enumerate(found.names)}
    for other in (other for other, chain in chains.items() if other != name and name in chain):
        dx, dy = layout[other].x - here.x, layout[other].y - here.y
        x, y = there.x + c * dx - s * dy, there.y + s * dx + c * dy
        poses[other] = Pose(x, y, layout[other].z, layout[other].yaw + turn)
    return Layout(poses)


def _wrong(scene: Scene, layout: Layout, program: Program, agents: tuple[Agent, ...]) -> list[str]:
    """Return what is wrong in a layout: physics, what bodies cannot reach or use, statements that do not hold."""
    found = list(physics(scene, layout).reasons)
    for agent in agents:
        nav = navigation(scene, layout, agent)
        used = usage(scene, layout, agent, nav=nav).usable
        reach, use = exempt_from_reach(scene, agent), exempt_from_use(scene, agent)
        found += [f"{agent.name} cannot reach {name}" for name, ok in nav.reached.items() if not (ok or name in reach)]
        unused = (name for name, ok in used.items() if nav.reached[name] and not (ok or name in use))
        found += [f"{agent.name} cannot use {name}" for name in unused]
    for statement in program.statements:
        relation = statement.relation
        if {*relation.asset_names()} <= {*layout} and not relation.check(scene, layout).met:
            found.append(f"statement {statement.number}, {relation.sentence()}, is not met")
    return found
