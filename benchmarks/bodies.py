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
from benchmarks.tables import HEADS, Rows, mean, summary, table
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


def section(rows: Rows, images: Path) -> str:
    """Return the table of all bodies and the table of what the ways to mind reach are worth."""
    groups: dict[str, list[Row]] = {}
    ways: dict[str, list[Row]] = {}
    for key, row in rows.items():
        kind, first, second, *_ = key.split("/")
        (groups if kind == "shares" else ways).setdefault(
            first if kind != "shares" else f"{first}/{second}", []
        ).append(row)
    names = ("walkable_ratio", "reachable_share", "usable_share")
    lines: list[list[str]] = []
    for key, found in groups.items():
        body, _, room = key.partition("/")
        met = f"{sum(row['ok'] for row in found)} of {len(found)}"
        why = f"{max(row['impossible'] for row in found)}"
        cells = [f"{mean(found, name):.2f}" for name in (*names, "exempt", "short")]
        lines.append(
            [f"{body.replace('_', ' ')}, {room.replace('_', ' ')}", met, *cells, why, f"{mean(found, 'wall'):.1f}"]
        )
    heads = [
        "body and room",
        "all demands met",
        "walkable",
        "reachable",
        "usable",
        "not asked",
        "short",
        "impossible",
        "s",
    ]
    intro = (
        "*Not asked*: assets that no layout brings within this body's reach; *short*: assets that it should reach or use "
        "and does not; *impossible*: what no layout could do (a forklift through a house door). *crowded*: 10 assets on "
        "40 % of the floor.\n"
    )
    text = f"## Fifteen bodies\n\n{intro}\n{table(heads, lines)}\n"
    if ways:
        heads = ["what minds the body", "runs", "hard demands met", "all demands met", *HEADS, "seconds"]
        cells = [[way, *summary(found), f"{mean(found, 'wall'):.1f}"] for way, found in ways.items()]
        text += (
            "The planner's statements without its guesses, solved once; *no reach*: the solver knows no body, its layout is "
            f"judged for one.\n\n{table(heads, cells)}\n{_by_body(rows)}"
        )
    return text


def _by_body(rows: Rows) -> str:
    """Return what each way to mind reach gives each body: walkable, reachable, usable."""
    cells: dict[str, dict[str, list[Row]]] = {}
    for key, row in rows.items():
        kind, way, body, *_ = key.split("/")
        if kind == "reach":
            cells.setdefault(body.replace("_", " "), {}).setdefault(way, []).append(row)
    ways = list(dict.fromkeys(way for found in cells.values() for way in found))
    names = ("walkable_ratio", "reachable_share", "usable_share")
    lines = [
        [
            body,
            *(" / ".join(f"{mean(found[way], name):.2f}" for name in names) if way in found else "-" for way in ways),
        ]
        for body, found in cells.items()
    ]
    return "Walkable / reachable / usable by body:\n\n" + table(["body", *ways], lines)
