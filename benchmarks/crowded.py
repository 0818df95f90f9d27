"""Crowded rooms: how often is everything in, inside and clear, by how full the floor is, and how does time grow."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import robolayout as rl
from benchmarks.measures import generated
from benchmarks.rooms import Crowd, crowd
from benchmarks.store import Row
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
