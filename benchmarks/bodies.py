"""Every built-in body in the four examples and in a crowded room, and what the ways to mind reach are worth."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import robolayout as rl
from benchmarks.examples import ROOMS, ROOT
from benchmarks.measures import figures, generated, watch
from benchmarks.rooms import Crowd, crowd
from benchmarks.store import Row
from robolayout.planners import OfflinePlanner, PlanRequest
from robolayout.scene import agent_names

SEEDS = range(5)
CROWDED = "crowded"
"""Name of the room that is made by rule: 10 assets on 40 % of the floor."""
MOVERS = ("stretch3", "robot_vacuum", "adult", "child_6", "wheelchair", "spot")
"""Bodies for which the ways to mind reach are compared."""
WAYS: dict[str, tuple[str, bool]] = {
    "the paper's solver, no reach": ("paper", False),
    "the paper's solver, pairwise reach": ("paper", True),
    "our solver, no reach": ("default", False),
    "our solver, routes": ("default", True),
}
"""Solver, and whether it knows the body; without, it lays out for a body so small that nothing is in its way.

They are compared where it matters: on programs without guesses, in the bedroom and on 40 % of the floor.
"""
NOBODY = {"name": "nobody", "radius": 0.001, "height": 0.05, "step": 0.03, "reach": 20.0, "reach_high": 20.0}


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield every body in every room, then every way to mind reach for six bodies in two rooms."""
    for body in agent_names():
        for room in (*ROOMS, CROWDED):
            for seed in SEEDS[: 1 if quick else None]:
                yield f"shares/{body}/{room}/{seed}", partial(shares, body, room, seed)
    for way in WAYS:
        for body in MOVERS[4:5] if quick else MOVERS:
            for room in ROOMS[:1] if quick else (ROOMS[0], CROWDED):
                for seed in SEEDS[: 1 if quick else 3]:
                    yield f"reach/{way}/{body}/{room}/{seed}", partial(reach, way, body, room, seed)


def scene_for(room: str, seed: int, body: str) -> rl.Scene:
    """Return an example, or the crowded room, for a body."""
    made = room == CROWDED
    given = rl.scene_from_dict(crowd(Crowd(10, 0.40, seed))[0]) if made else rl.load_scene(_file(room))
    return given.with_agents(rl.load_agent(body))


def _file(room: str) -> Path:
    return ROOT / "examples" / f"{room}.json"


def shares(body: str, room: str, seed: int) -> Row:
    """Return what the whole program makes of a room for a body."""
    return generated(scene_for(room, seed, body), seed=seed)


def reach(way: str, body: str, room: str, seed: int) -> Row:
    """Return what a solver makes of the planner's statements, without its guesses, and what this is worth for the body."""
    solver, knows = WAYS[way]
    scene = scene_for(room, seed, body)
    text = OfflinePlanner().plan(PlanRequest(scene, seed=seed))
    program = "\n".join(line for line in text.splitlines() if ".position = " not in line and ".rotation = " not in line)
    seen: Any = scene if knows else replace(scene, agents=(rl.load_agent(NOBODY),))
    with watch() as spent:
        found = rl.solve(seen, program, seed=seed, solver=solver)
    report = rl.verify(scene, found.layout, rl.read_program(program, scene))
    return figures(report) | {"wall": spent.wall, "cpu": spent.cpu, "assets": len(scene.assets)}
