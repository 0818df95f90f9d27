"""Laws of goals: what the solver's grid counts as within reach is what the judge grants, within a cell, chairs moved away."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from test_use_laws import dining

from robolayout._grid import components
from robolayout.floor.goals import missed
from robolayout.floor.ground import Ground, clearance, make_ground
from robolayout.scene import Agent, Layout, Scene, load_agent, vertical_span
from robolayout.scene.agent import BODY
from robolayout.solve import compile_problem
from robolayout.verify import navigation, usage
from robolayout.verify._boxes import boxes
from robolayout.verify.use import horizontal_reach

SEEDS = st.integers(min_value=0, max_value=10**6)
CELL = 0.05
BODIES = ("disc", "wheelchair", "unitree_g1", "child_6", "elder_walker", "spot", "forklift")


def disc_of(name: str) -> Agent:
    """A body as the grid sees it: a disc, here with an arm that gets two cells farther than a touch, at any height without one."""
    agent = Agent("disc", 0.25, 1.5, reach_distance=0.5) if name == "disc" else load_agent(name)
    if agent.reach_distance is None:
        agent = replace(agent, reach_low=-1.0, reach_high=9.0)
    radius = min(agent.radius, 0.5)
    arm = max(agent.reach_distance or 0.0, radius + BODY.touch + 2 * CELL)
    return replace(agent, length=None, width=None, turning_diameter=None, radius=radius, reach_distance=arm)


def wider(agent: Agent, by: float) -> Agent:
    """The same body so much wider, with so much less reach."""
    return replace(agent, radius=agent.radius + by, reach_distance=agent.reach - by)


def ungranted(scene: Scene, layout: Layout, agent: Agent) -> tuple[set[str], shapely.Polygon]:
    """Names that the judge says a body does not reach, or not use although their height is no bar; and where it gets to."""
    nav = navigation(scene, layout, agent)
    judged = usage(scene, layout, agent, nav=nav)
    high = {n for n in layout if horizontal_reach(agent, *vertical_span(scene.by_name[n], layout[n])) is None}
    return {n for n in layout if not (nav.reached[n] and (judged.usable[n] or n in high))}, nav.main


def missing(scene: Scene, layout: Layout, agent: Agent) -> tuple[set[str], Ground]:
    """Names that the solver would plan a way to, and its grid."""
    parent = tuple(boxes(scene, layout).carriers.tolist())
    problem = replace(compile_problem(scene, built=layout), guess=layout, parent=parent)
    world = np.array([(p.x, p.y, math.cos(p.yaw), math.sin(p.yaw)) for p in (layout[n] for n in problem.names)])
    ground = make_ground(problem.contents, agent, CELL)
    passable = ground.passable(clearance(ground, world, ground.obstacles))
    regions, _ = components(passable)
    home = (regions == regions[ground.start]) & passable
    rows = missed(ground, world, home)
    return {problem.names[slot] for slot in ground.targets.slots[rows]}, ground


def shunned(scene: Scene, layout: Layout, agent: Agent) -> set[str]:
    """Names that the law does not speak of: the grid knows neither doors to open nor places nearer than touching distance."""
    found: set[str] = set()
    for name, pose in layout.items():
        span = vertical_span(scene.by_name[name], pose)
        reach = [horizontal_reach(wider(agent, by), *span) for by in (-CELL, 0.0, CELL)]
        known = [r for r in reach if r is not None]
        if len(known) not in (0, 3) or any(r < agent.radius + BODY.touch + CELL for r in known):
            found.add(name)
    uses = usage(scene, layout, agent).uses.values()
    return found | {use.asset for use in uses if "to open" in use.reason}


@pytest.mark.parametrize("body", BODIES)
@settings(max_examples=25, deadline=None, derandomize=True)
@given(SEEDS)
def test_the_solvers_goals_are_what_the_judge_does_not_grant(body: str, seed: int):
    """A body a cell wider with a cell less reach is granted no more than the grid grants, one a cell narrower no less."""
    scene, layout = dining(seed)
    agent = disc_of(body)
    goals, ground = missing(scene, layout, agent)
    if ground.start is None:
        return
    spot = shapely.Point(ground.xs[ground.start[0]], ground.ys[ground.start[1]])
    aside = shunned(scene, layout, agent)
    strict, inner = ungranted(scene, layout, wider(agent, CELL))
    if inner.intersects(spot):
        assert goals - aside <= strict
    lenient, outer = ungranted(scene, layout, wider(agent, -CELL))
    if outer.intersects(spot):
        assert lenient - aside <= goals


def test_nobody_without_an_arm_moves_chairs():
    assert not len(
        make_ground(compile_problem(dining(3)[0], built=dining(3)[1]).contents, load_agent("spot"), CELL).targets.chairs
    )
    assert len(
        make_ground(
            compile_problem(dining(3)[0], built=dining(3)[1]).contents, load_agent("wheelchair"), CELL
        ).targets.chairs
    )
