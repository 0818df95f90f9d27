"""What an unmet statement lost to: the least that meeting it would break.

For every statement that does not hold, the thing that it is about is put where it would hold; the place at which least
breaks says what stands against it: a collision, a blocked way, another statement.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from robolayout.constraints import AssetRef, Relation
from robolayout.program import Program, Reconciled, Statement
from robolayout.scene import Layout, Scene
from robolayout.solve import Proposals, carry, compile_problem
from robolayout.verify import judge_agent, physics


@dataclass(frozen=True)
class ConflictConfig:
    """How long it is looked for what two statements leave no place for."""

    drawn: int = 96  # places drawn for each thing of an unmet statement
    looked_at: int = 10  # of the places at which the statement holds, so many are judged


CONFLICTS = ConflictConfig()


def conflicts(
    scene: Scene, reconciled: Reconciled, layout: Layout, said: Mapping[Relation, str], *, seed: int = 0
) -> dict[int, str]:
    """Return for each unmet statement, by its number, what it lost to; statements of `said` are called by the user's words."""
    found = {d.statement.number: f"the filter, {d.reason}" for d in reconciled.decisions if d.verdict != "accepted"}
    program = reconciled.program
    unmet = [s for s in program.statements if not s.relation.check(scene, layout).met]
    if unmet:
        looker = _Looker(scene, program, layout, said, np.random.default_rng(seed))
        for s in unmet:
            open_ways = "; other ways of what is left open were tried, the nearest to right first"
            found[s.number] = looker.against(s) + (open_ways if s.relation.ways(scene) else "")
    return found


@dataclass
class _Looker:
    """Tries places for the things of unmet statements."""

    scene: Scene
    program: Program
    layout: Layout
    said: Mapping[Relation, str]
    rng: np.random.Generator

    def __post_init__(self) -> None:
        self.problem = replace(compile_problem(self.scene, self.program, pinned=self.layout), pinned=frozenset())
        self.proposals = Proposals(self.problem)
        self.now = self._standing(self.layout)

    def against(self, statement: Statement) -> str:
        """Return what stands against one unmet statement."""
        tried: list[tuple[float, str]] = []
        for place in self._places(statement):
            wrong, short, unmet = (then - now for then, now in zip(self._standing(place), self.now, strict=True))
            others = [s for s in self.program.statements if s.number in unmet]
            weight = sum(float(getattr(s.relation, "weight", 1.0)) for s in others)
            cost = 100.0 * len(wrong) + 2.0 * len(short) + weight
            sentences = [*sorted(wrong), *(f"{name} out of reach" for name in sorted(short))]
            for s in others:
                words = self.said.get(s.relation)
                sentences.append(f"the wish {words!r}" if words else f"statement {s.number}, {s.relation.sentence()}")
            tried.append((cost, "; ".join(text.rstrip(".") for text in sentences[:3])))
        if not tried:
            return "the others: with everything else in place, no place was found where it holds"
        return min(tried, key=lambda t: t[0])[1] or "nothing that was found: more starts or another seed may meet it"

    def _places(self, statement: Statement) -> list[Layout]:
        """Return layouts in which the statement holds and one thing of it has moved."""
        found: list[Layout] = []
        for name in statement.relation.asset_names():
            slot = self.problem.slot[name]
            hung = any(row.a == AssetRef(name) for row in self.problem.wall_terms)
            for pose in self.proposals.draw(slot, self.problem.start, CONFLICTS.drawn, self.rng):
                world = self.problem.start.copy()
                carry(self.problem, world, slot, self._hung(slot, pose) if hung else pose)
                layout = self.problem.layout(world)
                if len(found) < CONFLICTS.looked_at and statement.relation.check(self.scene, layout).met:
                    found.append(layout)
        return found

    def _hung(self, slot: int, pose: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return a pose (4,) moved to the nearest wall, its back there: what hangs at walls holds nowhere else."""
        at = (float(pose[0]), float(pose[1]))
        wall = min(self.scene.room.walls, key=lambda wall: wall.distance(at))
        return np.array([*wall.point(wall.place(at)[0], self.problem.half[slot][0]), *wall.normal])

    def _standing(self, layout: Layout) -> tuple[set[Any], set[Any], set[Any]]:
        """Return what is wrong in a layout: sentences, names of what is out of reach, numbers of what is unmet."""
        bodies = [judge_agent(self.scene, layout, agent) for agent in self.scene.agents]
        short = {name for body in bodies for name in body.short}
        short |= {f"door {door.number}" for body in bodies for door in body.navigation.shut_doors}
        unmet = {s.number for s in self.program.statements if not s.relation.check(self.scene, layout).met}
        return set(physics(self.scene, layout).reasons), short, unmet
