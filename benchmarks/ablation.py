"""What each part of the solver is worth: the same rooms without it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial

import robolayout as rl
from benchmarks.examples import ROOT
from benchmarks.measures import generated
from benchmarks.rooms import Crowd, crowd
from benchmarks.rough import rough
from benchmarks.store import Row
from robolayout.planners import OfflinePlanner, PlanRequest
from robolayout.solve import Effort, SolverConfig
from robolayout.solve.runner import STILL

DEFAULT = SolverConfig()
CONFIGS: dict[str, SolverConfig] = {
    "default": DEFAULT,
    "no gradient steps": replace(DEFAULT, search=STILL, tops=STILL, polish=STILL, reroute=STILL),
    "no polishing": replace(DEFAULT, polish=replace(DEFAULT.polish, steps=0)),
    "no routes": replace(DEFAULT, route_rounds=0),
    "no construction": replace(DEFAULT, effort=replace(DEFAULT.effort, built=0, mendings=0)),
    "no repair": replace(DEFAULT, effort=Effort(repair_rounds=0)),
    "overlap by IoU": replace(DEFAULT, weights=replace(DEFAULT.weights, iou=1000.0 / DEFAULT.weights.overlap)),
    "no noise": replace(DEFAULT, search=replace(DEFAULT.search, noise=0.0)),
    **{f"{n} starts": replace(DEFAULT, starts=n, kept=min(n, DEFAULT.kept)) for n in (1, 4, 64)},
    "gradients alone": replace(
        DEFAULT,
        route_rounds=0,
        effort=Effort(repair_rounds=0),
        search=replace(DEFAULT.search, noise=0.0),
        starts=1,
        kept=1,
    ),
}
CONFIGS["gradients alone, by IoU"] = replace(CONFIGS["gradients alone"], weights=CONFIGS["overlap by IoU"].weights)
SEEDS = range(3)
EXAMPLES = ("bedroom", "living_room")
ROUGH = ("deli_small", "bedroom_medium", "kitchen", "office")
"""Tasks whose rough programs are solved."""


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield every configuration on crowded rooms with blind guesses, two examples without guesses, four with rough ones."""
    for name, config in list(CONFIGS.items())[:2] if quick else CONFIGS.items():
        for seed in SEEDS[:1] if quick else SEEDS:
            crowds = (Crowd(10, 0.45, seed),) if quick else (Crowd(20, 0.30, seed), Crowd(20, 0.45, seed))
            for asked in crowds:
                yield f"{name}/{asked.key}", partial(blind, asked, config)
            for room in () if quick else EXAMPLES:
                yield f"{name}/{room}/{seed}", partial(unguided, room, seed, config)
            for task in () if quick or seed else ROUGH:
                yield f"{name}/rough {task}/{seed}", partial(guided, task, seed, config)


def blind(asked: Crowd, config: SolverConfig) -> Row:
    """Solve a crowded room once, whatever comes out."""
    scene, program = crowd(asked)
    return generated(rl.scene_from_dict(scene), program=program, seed=asked.seed, config=config)


def guided(task: str, seed: int, config: SolverConfig) -> Row:
    """Solve a task by a program with a model's rough guess."""
    given = rough(task, seed)
    return generated(given.scene, program=given.text, seed=seed, config=config)


def unguided(room: str, seed: int, config: SolverConfig) -> Row:
    """Solve an example for a wheelchair with the planner's statements but without its guesses."""
    scene = rl.load_scene(ROOT / "examples" / f"{room}.json").with_agents(rl.load_agent("wheelchair"))
    text = OfflinePlanner().plan(PlanRequest(scene, seed=seed))
    kept = [line for line in text.splitlines() if ".position = " not in line and ".rotation = " not in line]
    return generated(scene, program="\n".join(kept), seed=seed, config=config)
