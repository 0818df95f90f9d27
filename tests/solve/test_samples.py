"""Several programs of one scene, solved together: as good as alone where it counts, and hardly dearer than one."""

from __future__ import annotations

import threading
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import Any
from unittest.mock import patch

import numpy as np
import pytest
from solve_rooms import BED, LAMP, QUICK, STANDS, TABLE, room_of

from robolayout.program import Program, read_program, reconcile
from robolayout.run.flow import Run, make_judge, solve
from robolayout.run.result import Clock
from robolayout.scene import Layout, Pose, Scene
from robolayout.solve import Solution, SolverConfig, Verdict, compile_problem, programs, silent, solve_samples

ROOM = room_of(BED, *STANDS, LAMP, TABLE)
GOOD = """
solver.against_wall(bed[0], walls[2])
solver.next_to(night_stand[0], bed[0], "left")
solver.align_with(night_stand[0], bed[0])
solver.on_top_of(lamp[0], night_stand[0])
"""
OTHER = GOOD.replace("walls[2]", "walls[3]") + "solver.corner(table[0])\n"
CONTRARY = (
    GOOD
    + "solver.distance_constraint(night_stand[1], bed[0], 6.0)\nsolver.distance_constraint(table[0], bed[0], 6.0)\n"
)
TEXTS = (GOOD, CONTRARY, OTHER, "solver.corner(table[0])\nsolver.on_top_of(lamp[0], table[0])\n")
THOROUGH = replace(QUICK, starts=16)


def read(scene: Scene, *texts: str) -> list[Program]:
    return [reconcile(read_program(text, scene), scene).program for text in texts]


def solve_many(
    scene: Scene,
    asked: Sequence[Program],
    *,
    config: SolverConfig,
    seed: int = 0,
    pinned: Mapping[str, Pose] | None = None,
) -> list[Solution]:
    run = Run(scene, seed, "default", config, Clock(), silent)
    return [attempt.solution for attempt in run.finished(asked, scene, pinned or {})]


@contextmanager
def counted() -> Iterator[dict[str, int]]:
    """Count the steps that all starts make in compiled programs, and the calls by program."""
    found = {"steps": 0}
    real = programs.call

    def call(target: str, local: Any, arrays: Any, routes: Any, schedule: Any, *rest: Any, **constants: Any) -> Any:
        found["steps"] += int(schedule[0]) * int(np.prod(local.shape[:-2]))
        found[target] = found.get(target, 0) + 1
        return real(target, local, arrays, routes, schedule, *rest, **constants)

    with patch.object(programs, "call", call):
        yield found


def test_every_program_gets_a_layout_that_its_own_judge_measured() -> None:
    asked = read(ROOM, *TEXTS)
    solutions = solve_many(ROOM, asked, config=QUICK)
    assert len(solutions) == 4
    for program, solution in zip(asked, solutions, strict=True):
        assert set(solution.layout) == set(ROOM.by_name)
        assert make_judge(ROOM, program)(solution.layout).merit == solution.verdict.merit
    assert any(solution.verdict.ok for solution in solutions)
    assert solutions[1].verdict.merit > 0.0


@pytest.mark.slow
@pytest.mark.parametrize("config", [THOROUGH, SolverConfig()])
def test_four_programs_cost_no_more_than_one_with_its_other_ways(config: SolverConfig) -> None:
    """A program that cannot be met is searched in several ways; four of them are polished, the best is searched, without these."""
    names = ("bed[0]", "table[0]", "night_stand[0]", "night_stand[1]")
    walls = [f"solver.against_wall({name}, walls[2])\n" for name in names]
    corners = [f"solver.corner({name})\n" for name in names]
    texts = ["".join([*walls, *corners[k:], *corners[:k]]) for k in range(4)]
    with counted() as one:
        solve(ROOM, read(ROOM, texts[0])[0], config=config)
    with counted() as four:
        solve_many(ROOM, read(ROOM, *texts), config=config)
    assert four["steps"] <= one["steps"]


@pytest.mark.slow
def test_four_programs_cost_at_most_twice_one_that_is_done_at_once() -> None:
    for config in (THOROUGH, SolverConfig()):
        with counted() as one:
            solve(ROOM, read(ROOM, GOOD)[0], config=config)
        with counted() as four:
            solve_many(ROOM, read(ROOM, *TEXTS), config=config)
        assert four["steps"] <= 2 * one["steps"]


@pytest.mark.slow
def test_the_best_of_four_is_as_good_as_each_alone() -> None:
    asked = read(ROOM, *TEXTS)
    alone = min(solve(ROOM, program, config=QUICK).verdict.merit for program in asked)
    together = min(solution.verdict.merit for solution in solve_many(ROOM, asked, config=QUICK))
    assert together <= alone


def test_same_programs_same_layouts() -> None:
    first, second = (solve_many(ROOM, read(ROOM, *TEXTS[:3]), config=QUICK, seed=5) for _ in range(2))
    assert [s.layout.to_dict() for s in first] == [s.layout.to_dict() for s in second]


@pytest.mark.parametrize("count", [2, 3, 5])
def test_any_number_of_programs(count: int) -> None:
    solutions = solve_many(ROOM, read(ROOM, *([*TEXTS, *TEXTS][:count])), config=QUICK)
    assert len(solutions) == count and min(s.verdict.hard for s in solutions) == 0.0


def test_a_single_program_takes_the_way_of_always() -> None:
    program = read(ROOM, GOOD)[0]
    (found,) = solve_many(ROOM, [program], config=QUICK, seed=2)
    assert found.layout.to_dict() == solve(ROOM, program, config=QUICK, seed=2).layout.to_dict()


def test_what_is_pinned_stays_in_every_sample() -> None:
    pinned = {"bed-0": Pose(1.0, 2.0, 0.25, 0.0)}
    for solution in solve_many(ROOM, read(ROOM, *TEXTS), config=QUICK, pinned=pinned):
        assert solution.layout["bed-0"] == pinned["bed-0"]


def test_an_empty_room_and_no_program() -> None:
    nothing = room_of()
    assert solve_many(ROOM, [], config=QUICK) == []
    assert [len(s.layout) for s in solve_many(nothing, read(nothing, "", ""), config=QUICK)] == [0, 0]


def test_a_solver_that_breaks_down_breaks_the_run_and_hangs_nobody() -> None:
    heap = Layout({asset.name: Pose(1.0, 1.0, asset.size[2] / 2, 0.0) for asset in ROOM.assets})  # wants a search
    problems = [compile_problem(ROOM, program, built=heap) for program in read(ROOM, *TEXTS)]
    judges = [make_judge(ROOM, program) for program in read(ROOM, *TEXTS)]

    def broken(layout: Layout, enough: object = None, /) -> Verdict:
        raise ZeroDivisionError

    before = threading.active_count()
    with pytest.raises(ZeroDivisionError):
        solve_samples(problems, [*judges[:3], broken], config=QUICK)
    with patch.object(programs, "call", side_effect=MemoryError), pytest.raises(MemoryError):
        solve_samples(problems, judges, config=QUICK)
    assert threading.active_count() <= before + 2
