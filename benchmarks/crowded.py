"""Crowded rooms: how often is everything in, inside and clear, by how full the floor is, and how does time grow."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import robolayout as rl
from benchmarks.measures import generated
from benchmarks.rooms import Crowd, crowd
from benchmarks.store import Row
from benchmarks.tables import HEADS, Rows, mean, plot, sorted_groups, summary, table
from robolayout.solve import solver_names

FILLS = (0.30, 0.45, 0.60)
COUNTS = (10, 20, 40, 80, 120)
SEEDS = range(10)
BASELINE_COUNTS = (10, 20)
"""Sizes on which the solvers made for comparison are run; they take minutes on larger ones."""


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield the rooms for the default solver, planned and with a blind program, then for the solvers beside it."""
    for asked in crowds(quick):
        yield f"program/default/{asked.key}", partial(solved, asked)
        if not asked.contradictions:
            yield f"planned/default/{asked.key}", partial(planned, asked)
    for name in solver_names():
        for count in () if quick or name == "default" else BASELINE_COUNTS:
            for seed in range(3):
                asked = Crowd(count, 0.30, seed)
                yield f"program/{name}/{asked.key}", partial(solved, asked, solver=name)


def crowds(quick: bool) -> Iterator[Crowd]:
    """Yield what is asked of the generator."""
    for count in COUNTS[:1] if quick else COUNTS:
        for fill in FILLS[1:2] if quick else FILLS:
            for seed in SEEDS[:1] if quick else SEEDS:
                yield Crowd(count, fill, seed)
    for seed in SEEDS[: 1 if quick else 5]:
        yield Crowd(10 if quick else 20, 0.45, seed, concave=True)
        yield Crowd(10 if quick else 20, 0.30, seed, contradictions=10)


def solved(asked: Crowd, **options: object) -> Row:
    """Return what one program, blind guesses and all, becomes."""
    scene, program = crowd(asked)
    return generated(rl.scene_from_dict(scene), program=program, seed=asked.seed, **options)


def planned(asked: Crowd) -> Row:
    """Return what the offline planner and the solver make of the room."""
    return generated(rl.scene_from_dict(crowd(asked)[0]), seed=asked.seed)


def section(rows: Rows, images: Path) -> str:
    """Return the table of crowded rooms and draw how often all demands are met."""
    groups: dict[str, list[Row]] = {}
    for key, row in rows.items():
        groups.setdefault(key.rpartition("/")[0], []).append(row)
    heads = ["program / solver / room", "rooms", "hard demands met", "all demands met", *HEADS, "CPU s"]
    lines = [
        [name.replace("/", ", "), *summary(found), f"{mean(found, 'cpu'):.1f}"] for name, found in sorted_groups(groups)
    ]
    intro = (
        "Rooms made by rule (`benchmarks/rooms.py`), default disc of 0.30 m. *program*: a program with blind guesses, "
        "walls asked without thinking; *planned*: the offline planner writes it. "
        "Hard demands: placed, no collision, inside, supported, doors clear.\n"
    )
    curves: dict[str, list[tuple[float, float]]] = {}
    for name, found in groups.items():
        who, solver, size, fill, *extra = name.split("/")
        if not extra and solver == "default":
            curves.setdefault(f"{who}, {size}", []).append((float(fill.rstrip("%")), 100 * mean(found, "ok")))
    picture = plot(images / "benchmark-crowded.png", curves, ("floor filled, %", "rooms with all demands met, %"))
    return f"## Crowded rooms\n\n{intro}\n{table(heads, lines)}\n{picture}"
