"""The exact verifier as an order on layouts, handed to the solver."""

from __future__ import annotations

from dataclasses import replace

from robolayout.program import Program
from robolayout.scene import Agent, Layout, Scene, vertical_span
from robolayout.scene.agent import horizontal_reach
from robolayout.solve import Enough, Judge, Verdict, never
from robolayout.verify import judge_agent, kept_out, physics

WALKABLE = 0.98
"""Share of the free space that the solver wants connected to the door; the report demands 0.95."""


def make_judge(scene: Scene, program: Program) -> Judge:
    """Return the exact verifier as an order on (partial) layouts: what is not placed yet is not counted.

    A body that cannot come in whatever is done has no say. What is cheap is looked at first.
    """
    statements = [(s.relation, frozenset(s.relation.asset_names())) for s in program.statements]
    bodies = [agent for agent in scene.agents if not kept_out(scene, agent)]

    def judge(layout: Layout, enough: Enough = never, /) -> Verdict:
        placed = set(layout)
        failing = [name for name in physics(scene, layout).failing if name in placed]
        found = Verdict(float(len(failing)), 0.0, 0.0, tuple(failing))
        if enough(found):
            return found
        soft, unmet = 0.0, list[str]()
        for relation, names in statements:
            if names <= placed and not relation.check(scene, layout).met:
                soft += float(getattr(relation, "weight", 1.0))
                unmet += relation.asset_names()
        access, blamed = 0.0, list[str]()
        for agent in bodies:
            if enough(replace(found, access=access, soft=soft)):
                break
            missing, to_move = _access(scene, layout, agent)
            access += missing
            blamed += to_move
        return Verdict(found.hard, access, soft, tuple(dict.fromkeys([*failing, *blamed, *unmet])))

    return judge


def _access(scene: Scene, layout: Layout, agent: Agent) -> tuple[float, list[str]]:
    """Return how much an agent cannot get to (in assets; a door counts as one) and which assets to move for it."""
    found = judge_agent(scene, layout, agent)
    nav = found.navigation
    fixable = [
        name
        for name in found.short
        if name in layout and (not nav.reached[name] or _in_height(scene, layout, agent, name))
    ]
    unreached = sum(not nav.reached[name] for name in fixable)
    cut_off = max(0.0, WALKABLE - nav.walkable_ratio) if nav.free.area > 0 else 0.0
    blamed = [*fixable, *(other for name in fixable for other in found.usage.shutting(name))]
    blamed += nav.dividing if cut_off else ()
    blamed += [name for door in nav.shut_doors for name in nav.shutting(door)]
    return unreached + 0.5 * (len(fixable) - unreached) + cut_off + len(nav.shut_doors), blamed


def _in_height(scene: Scene, layout: Layout, agent: Agent, name: str) -> bool:
    """Return whether moving an asset about could ever bring it into the agent's reach."""
    return horizontal_reach(agent, *vertical_span(scene.by_name[name], layout[name])) is not None
