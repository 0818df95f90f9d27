"""`verify`: judge a finished layout, whoever made it."""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from robolayout.constraints import Outcome
from robolayout.scene import Agent, Layout, Scene, load_agents
from robolayout.verify.agent_report import AgentReport
from robolayout.verify.limits import Demands
from robolayout.verify.navigation import navigation
from robolayout.verify.physics import physics
from robolayout.verify.report import Report, StatementResult
from robolayout.verify.use import usage

if TYPE_CHECKING:
    from robolayout.program import Program, Statement

AgentSpec = Agent | str | Path | Mapping[str, Any]


def verify(
    scene: Scene,
    layout: Layout,
    program: Program | None = None,
    *,
    agent: AgentSpec | Iterable[AgentSpec] | None = None,
    demands: Demands | None = None,
) -> Report:
    """Judge a layout: physics, navigation and use for each agent, and every statement as asked.

    Args:
        scene: What was given.
        layout: Poses; assets without one fail every share.
        program: The statements as asked; None leaves semantics out.
        agent: One body or several: an `Agent`, names of profiles ("wheelchair,child_6"), a file, a mapping as in a
            scene file, or a list of those; the scene's own if None.
        demands: What the layout must achieve for `Report.ok`.
    """
    wall, cpu = time.perf_counter(), time.process_time()
    placed = {name for name, pose in layout.items() if pose.is_finite}
    demands, bodies = demands or Demands(), scene.agents if agent is None else load_agents(agent)
    reports = tuple(judge_agent(scene, layout, body, demands) for body in bodies)
    statements = () if program is None else tuple(_measure(scene, layout, s, placed) for s in program.statements)
    judged = physics(scene, layout)
    timing = {"verify": {"wall": time.perf_counter() - wall, "cpu": time.process_time() - cpu}}
    return Report(scene, layout, judged, reports, statements, demands, timing, program=program)


def judge_agent(scene: Scene, layout: Layout, agent: Agent, demands: Demands | None = None) -> AgentReport:
    """Judge what one agent can get to and use; its sentences complain of what falls short of the demands."""
    nav = navigation(scene, layout, agent)
    return AgentReport(agent, nav, usage(scene, layout, agent, nav=nav), demands or Demands())


def _measure(scene: Scene, layout: Layout, statement: Statement, placed: set[str]) -> StatementResult:
    """Measure one statement; it fails if one of its assets is unplaced."""
    relation = statement.relation
    missing = [name for name in relation.asset_names() if name not in placed]
    unplaced = Outcome(False, math.nan, math.nan, "", f"{' and '.join(missing)} not placed")
    found = vars(unplaced if missing else relation.check(scene, layout))
    return StatementResult(
        statement.number, statement.line, statement.source, relation.sentence(), **found, by=statement.by
    )
