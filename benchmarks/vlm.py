"""What the parts of planning with a model are worth, on six rooms with recorded answers: modes, filter, samples, retries."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import nullcontext
from functools import partial
from pathlib import Path
from typing import Any
from unittest.mock import patch

import robolayout as rl
from benchmarks.examples import ROOT
from benchmarks.measures import figures, watch
from benchmarks.store import Row
from benchmarks.tables import HEADS, Rows, mean, select, summary, table
from robolayout.planners import ModelPlanner, PlanRequest
from robolayout.program import Decision, Program, Reconciled

RECORDINGS = ROOT / "tests" / "planners" / "recordings"
ROOMS = ("bedroom", "bookstore", "buffet_restaurant", "computer_room", "game_room", "living_room")
MODES = ("one_shot", "grouped")
SAMPLES = 4
WAYS: dict[str, dict[str, Any]] = {
    "as it is": {},
    "no filter": {"filtered": False},
    "no retries": {"retries": 0},
    "no filter, no retries": {"filtered": False, "retries": 0},
    "each of 4 samples alone": {"alone": True},
    "each of 4 samples alone, no filter": {"alone": True, "filtered": False},
    "4 samples": {"samples": 4},
    "4 samples, no retries": {"samples": 4, "retries": 0},
}
"""What differs from one sample, three retries, and the filter."""


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield every way of asking for every room; only one_shot was recorded with four samples."""
    for way, options in list(WAYS.items())[:2] if quick else WAYS.items():
        for mode in MODES:
            for room in ROOMS[4:5] if quick else ROOMS:
                if "alone" in options and mode == "one_shot":
                    for sample in range(SAMPLES):
                        yield (
                            f"{way}/{mode}/{room}/{sample}",
                            partial(alone, room, sample, options.get("filtered", True)),
                        )
                elif mode == "one_shot" or not {"samples", "alone"} & set(options):
                    yield f"{way}/{mode}/{room}", partial(replayed, room, mode, **options)


def alone(room: str, number: int, filtered: bool) -> Row:
    """Solve one of the four recorded samples as if it were the only one, without asking again."""
    scene = rl.load_scene(RECORDINGS / room / "scene.json")
    planner = ModelPlanner(replay=RECORDINGS / room / "one_shot", mode="one_shot")
    (group,) = planner.group(scene)
    text = planner.plan_many(PlanRequest(scene, group), SAMPLES)[number]
    return measured(lambda: rl.generate(scene, program=text), filtered)


def replayed(room: str, mode: Any, *, filtered: bool = True, samples: int = 1, retries: int = 3) -> Row:
    """Answer from the recording and measure what comes of it."""
    scene = rl.load_scene(RECORDINGS / room / "scene.json")

    def run() -> rl.Result:
        recording = RECORDINGS / room / mode
        return rl.generate(scene, planner=ModelPlanner(replay=recording, mode=mode, samples=samples, retries=retries))

    return measured(run, filtered)


def measured(run: Callable[[], rl.Result], filtered: bool) -> Row:
    """Run twice; return figures, seconds of the solver when warm, and what became of the answers."""
    with nullcontext() if filtered else patch("robolayout.run.flow.reconcile", unfiltered):
        run()
        with watch() as spent:
            result = run()
    solve = result.report.timing["solve"]
    first = [sample for sample in result.samples if sample.attempt == 1]
    return figures(result.report) | {
        "wall": spent.wall,
        "cpu": spent.cpu,
        "solve_wall": solve["wall"],
        "solve_cpu": solve["cpu"],
        "answers": max(1, len(result.samples)),
        "unreadable": sum(sample.score is None for sample in result.samples),
        "asked_again": len(result.samples) - len(first),
        "taken_over": len(result.report.planner.get("taken_over", ())),
        "stated": len(result.program.statements),
    }


def unfiltered(program: Program, scene: rl.Scene, *, paper: bool = False) -> Reconciled:
    """Stand in for the filter: accept every statement."""
    return Reconciled(program, tuple(Decision(s, "accepted", "not filtered") for s in program.statements))


def section(rows: Rows, images: Path) -> str:
    """Return the table of what the parts of planning with a model are worth, and what four samples cost the solver."""
    groups = {
        f"{mode}, {way}": found
        for mode in MODES
        for way in WAYS
        if (found := select(rows, lambda key, way=way, mode=mode: key[:2] == [way, mode]))
    }
    heads = ["mode, and what is different", "runs", "hard demands met", "all demands met", *HEADS]
    lines = [
        [
            name,
            *summary(found),
            *(f"{sum(row[n] for row in found)}" for n in ("answers", "unreadable", "asked_again", "taken_over")),
            *(f"{mean(found, n):.1f}" for n in ("solve_wall", "solve_cpu")),
        ]
        for name, found in groups.items()
    ]
    heads += ["answers", "unreadable", "asked again", "taken over", "solver wall s", "solver CPU s"]
    intro = (
        "Six rooms with recorded answers (`tests/planners/recordings`): programs as a strong model writes them, with the faults "
        "of such models. *as it is*: one sample, at most three retries, with the filter. *asked again*: answers to a question "
        "that told what was wrong before. *taken over*: groups for which the offline planner stood in. Means over the runs, "
        "sums of the answers; four samples were recorded for one_shot only. A statement that the filter rejects counts as unmet "
        "unless the layout meets it all the same. *each alone*: every recorded program solved by itself, without asking "
        "again; *4 samples* solves them together and keeps the best, for about the CPU time of one. Others used "
        "the machine meanwhile: its CPU seconds compare, its wall seconds do not.\n"
    )
    return f"## Planning with a model\n\n{intro}\n{table(heads, lines)}"
