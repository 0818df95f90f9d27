"""What each part of the solver is worth: the same rooms without it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache, partial
from hashlib import sha256
from pathlib import Path
from random import Random

import robolayout as rl
from benchmarks.examples import ROOT
from benchmarks.measures import figures, watch
from benchmarks.rooms import Crowd, crowd
from benchmarks.rough import TASKS, away, rough, said
from benchmarks.store import Row
from benchmarks.tables import Rows, mean, phases, summary, table
from robolayout.planners import OfflinePlanner, PlanRequest
from robolayout.solve import Effort, SolverConfig
from robolayout.solve.runner import STILL

DEFAULT = SolverConfig()
CONFIGS: dict[str, SolverConfig] = {
    "default": DEFAULT,
    "no gradient steps": replace(DEFAULT, polish=STILL, reroute=STILL),
    "no polishing": replace(DEFAULT, polish=STILL),
    "no construction": replace(DEFAULT, effort=replace(DEFAULT.effort, built=0, mendings=0)),
    "no mending, no repair": replace(DEFAULT, effort=Effort(nearby=0, mendings=0)),
    "no routes anywhere": replace(DEFAULT, route_rounds=0),
    **{f"{n} starts": replace(DEFAULT, starts=n, kept=min(n, DEFAULT.kept)) for n in (1, 4, 64)},
    "gradients alone": replace(
        DEFAULT,
        route_rounds=0,
        effort=Effort(nearby=0, mendings=0, built=0),
        starts=1,
    ),
}
"""What is left out. The default has 16 starts."""

CROWDS = (
    *(Crowd(count, 0.45, seed) for count in (10, 20) for seed in range(2)),
    *(Crowd(count, 0.30, 0) for count in (20, 40)),
)
"""Rooms that are solved by programs with blind guesses."""

EXAMPLES = ("bedroom", "tasks/bedroom_medium", "tasks/childrens_room_medium", "tasks/cafe")
"""Examples that are solved for a wheelchair from statements alone."""

ROUGH = TASKS[::3] + TASKS[1::3]
"""Tasks whose rough programs are solved: twelve of the eighteen."""


_rough = cache(rough)
_compiled = set[str]()


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield every configuration on crowded rooms with blind guesses, examples without guesses, tasks with rough ones."""
    for name, config in list(CONFIGS.items())[:2] if quick else CONFIGS.items():
        for asked in (Crowd(10, 0.45, 0),) if quick else CROWDS:
            yield f"{name}/crowded rooms/{asked.key}", partial(blind, asked, config)
        for room in () if quick else EXAMPLES:
            yield f"{name}/planner's statements/{room.rpartition('/')[2]}", partial(unguided, room, config)
        for task in () if quick else ROUGH:
            yield f"{name}/rough programs/{task}", partial(guided, task, config)


def blind(asked: Crowd, config: SolverConfig) -> Row:
    """Solve a crowded room once, whatever comes out."""
    scene, program = crowd(asked)
    return solved(rl.scene_from_dict(scene), program, config)


def guided(task: str, config: SolverConfig) -> Row:
    """Solve a task by a program with a model's rough guess."""
    given = _rough(task, 0)
    return solved(given.scene, given.text, config)


def unguided(room: str, config: SolverConfig) -> Row:
    """Solve an example for a wheelchair with the planner's statements but without its guesses.

    Nothing is placed before the search begins where building is left out: then things are thrown into the room blindly.
    """
    scene = rl.load_scene(ROOT / "examples" / f"{room}.json").with_agents(rl.load_agent("wheelchair"))
    text = OfflinePlanner().plan(PlanRequest(scene))
    kept = [line for line in text.splitlines() if ".position = " not in line and ".rotation = " not in line]
    thrown = () if config.effort.built else _thrown(scene, Random(room))
    return solved(scene, "\n".join([*thrown, *kept]), config)


def _thrown(scene: rl.Scene, rng: Random) -> Iterator[str]:
    """Yield the lines of guesses anywhere in the room, with headings along its axes."""
    x0, y0, x1, y1 = scene.room.bounds
    for asset in scene.assets:
        x, y, z = rng.uniform(x0, x1), rng.uniform(y0, y1), asset.size[2] / 2
        yield f"{said(scene, asset.name)}.position = [{x:.2f}, {y:.2f}, {z:.2f}]"
        yield f"{said(scene, asset.name)}.rotation = [{90 * rng.randrange(4)}]"


def solved(scene: rl.Scene, program: str, config: SolverConfig) -> Row:
    """Solve a program once it is compiled; say how far things went, which phase made the layout and which layout it is."""
    if program not in _compiled:
        rl.generate(scene, program=program, config=replace(config, effort=Effort(layouts=1)))
        _compiled.add(program)
    with watch() as spent:
        result = rl.generate(scene, program=program, config=config)
    gone = away(scene, result)
    named = sha256(repr(sorted(result.layout.to_dict().items())).encode()).hexdigest()[:12]
    return {
        **figures(result.report),
        "moved": sum(gone.values()) / len(gone) if ".position = " in program else None,
        "phase": result.solution.phase,
        "layout": named,
        "cpu": spent.cpu,
    }


def section(rows: Rows, images: Path) -> str:
    """Return the table of what each part is worth."""
    groups: dict[tuple[str, str], dict[str, Row]] = {}
    for key, row in rows.items():
        name, family, case = key.split("/", 2)
        groups.setdefault((family, name), {})[case] = row
    heads = ["family", "solver", "runs", "hard demands met", "all demands met", "reachable", "usable", "statements met"]
    heads += ["moved, m", "CPU s", "other layouts than the default's", "made by"]
    lines: list[list[str]] = []
    for (family, name), found in sorted(
        groups.items(), key=lambda item: (item[0][0], item[0][1] != "default", item[0])
    ):
        runs, plain = list(found.values()), groups[family, "default"]
        shares = [f"{mean(runs, n):.2f}" for n in ("reachable_share", "usable_share", "statements_met_share")]
        shares.append("-" if runs[0]["moved"] is None else f"{mean(runs, 'moved'):.2f}")
        other = sum(row["layout"] != plain[case]["layout"] for case, row in found.items())
        lines.append([family, name, *summary(runs)[:3], *shares, f"{mean(runs, 'cpu'):.1f}", str(other), phases(runs)])
    intro = (
        "The solver without one of its parts, or with other numbers of starts (the default has 16): crowded rooms with blind "
        "guesses, examples for a wheelchair with the planner's statements but no guesses (thrown in blindly where nothing is built), "
        "tasks with a model's rough guess (below); one attempt each. *Other layouts*: of so many runs the layout is not the default's; "
        "a row without any changes nothing in its family.\n"
    )
    return f"## What each part is worth\n\n{intro}\n{table(heads, lines)}"
