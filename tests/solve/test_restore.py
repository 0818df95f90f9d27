"""What the search moved without need goes back: never a worse layout, and all of it where nothing was wrong."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

import robolayout as rl
from robolayout.planners import OfflinePlanner, PlanRequest
from robolayout.program import read_program, reconcile
from robolayout.run.flow import make_judge
from robolayout.solve.compile import Floats, Problem, compile_problem
from robolayout.solve.proposals import Proposals, carry, compose
from robolayout.solve.restore import once_more, restored, squared
from robolayout.solve.stage import relative

TRIALS = 64


def planned(name: str) -> tuple[Problem, Callable[[Floats], float]]:
    """Return a room with a guess as it is built from the offline planner's program, and how bad poses in it are."""
    scene = rl.load_scene(f"examples/{name}.json")
    program = reconcile(read_program(OfflinePlanner().plan(PlanRequest(scene)), scene), scene).program
    problem = compile_problem(scene, program)
    problem = replace(problem, guessed=problem.names)
    judge = make_judge(scene, program)
    return problem, lambda world: judge(problem.layout(world)).merit


@pytest.mark.parametrize("name", ["bedroom", "dining_room"])
def test_a_room_that_was_shaken_for_nothing_is_as_it_was(name: str) -> None:
    problem, merit = planned(name)
    target = problem.start
    assert merit(target) == 0.0
    shaken = target.copy()
    shaken[:, :2] += np.random.default_rng(0).normal(0.0, 0.3, shaken[:, :2].shape)
    assert restored(problem, shaken, lambda world: merit(world) == 0.0, TRIALS) == pytest.approx(target)


@pytest.mark.parametrize("seed", range(4))
def test_what_had_to_move_stays_and_the_rest_goes_back(seed: int) -> None:
    problem, _ = planned("bedroom")
    target = problem.start
    rng = np.random.default_rng(seed)
    forbidden = problem.slot[str(rng.choice([n for n in problem.guessed if problem.parent[problem.slot[n]] < 0]))]
    shaken = target + rng.normal(0.0, 0.3, target.shape)
    asked: list[Floats] = []

    def no_worse(world: Floats) -> bool:
        asked.append(world)
        return np.array_equal(world[forbidden], shaken[forbidden])

    found = restored(problem, shaken, no_worse, TRIALS)
    assert len(asked) <= TRIALS + 6 * len(target)
    assert np.array_equal(found[forbidden], shaken[forbidden])
    still = [i for i in range(len(found)) if not np.array_equal(found[i], target[i])]
    assert len(still) < len(target) / 2


def test_what_may_not_go_back_whole_goes_back_along_the_axis_that_it_may() -> None:
    problem, _ = planned("bedroom")
    target, slot = problem.start, problem.slot["double_bed-0"]
    front = target[slot, 2:]
    shaken = target.copy()
    shaken[slot, :2] += 0.4 * front + 0.3 * np.array([-front[1], front[0]])

    def no_worse(world: Floats) -> bool:
        return float((world[slot, :2] - target[slot, :2]) @ front) > 0.39

    found = restored(problem, shaken, no_worse, TRIALS)
    assert found[slot, :2] == pytest.approx(target[slot, :2] + 0.4 * front)


def test_a_table_that_may_not_go_back_alone_takes_its_chairs_along() -> None:
    problem, _ = planned("dining_room")
    table, groups = problem.slot["dining_table-0"], Proposals(problem).followers
    chairs = [slot for slot, name in enumerate(problem.names) if name.startswith("dining_chair")]
    assert {*chairs} <= groups[table]
    shaken = problem.start + np.array([0.0, 0.5, 0.0, 0.0])

    def no_worse(world: Floats) -> bool:
        by_it = world[chairs] - world[table] - problem.start[chairs] + problem.start[table]
        return bool(np.abs(by_it).max() < 1e-9 and world[table, 1] > problem.start[table, 1] + 0.2)

    assert restored(problem, shaken, no_worse, TRIALS)[table] == pytest.approx(shaken[table])
    found = restored(problem, shaken, no_worse, TRIALS, groups)
    assert found[[table, *chairs], 1] == pytest.approx(problem.start[[table, *chairs], 1] + 0.3)


def test_what_moved_by_millimetres_alone_goes_back_whole() -> None:
    """Things 4 mm off for no reason stayed so: putting one back had to be worth a centimetre."""
    problem, _ = planned("bedroom")
    shaken = problem.start + np.array([0.004, 0.0, 0.0, 0.0])
    assert restored(problem, shaken, lambda _world: True, 0) == pytest.approx(problem.start, abs=1e-12)


def test_what_no_program_places_goes_back_where_it_was_built() -> None:
    scene = rl.load_scene("examples/bedroom.json")
    problem = compile_problem(scene, read_program("", scene))
    world = problem.start + 0.1
    assert problem.moved(world) == 0.0 < problem.away(world)
    assert np.array_equal(restored(problem, world, lambda _world: True, TRIALS), problem.start)


@pytest.mark.parametrize("angle", [0.1, 0.7])
def test_what_came_to_stand_askew_is_squared_and_what_is_meant_so_stays(angle: float) -> None:
    problem, _ = planned("bedroom")
    slots = [slot for slot in range(len(problem.names)) if problem.parent[slot] < 0]
    askew = problem.start.copy()
    for slot in slots:
        carry(problem, askew, slot, compose(askew[slot], np.array([0.0, 0.0, np.cos(angle), np.sin(angle)])))
    free = replace(problem, guessed=())
    found = squared(free, askew, lambda world: True)
    assert found[slots] == pytest.approx(problem.start[slots])
    meant = replace(problem, guess=problem.layout(askew))
    assert squared(meant, askew, lambda world: True) == pytest.approx(askew)
    assert squared(free, askew, lambda world: False) == pytest.approx(askew)


def test_two_that_face_each_other_are_squared_together() -> None:
    """Alone, each would look past the other: sofas of a lobby stood askew by 33 degrees."""
    problem, _ = planned("living_room")
    problem = replace(problem, guessed=())
    pair = [problem.slot["sofa-0"], problem.slot["tv_stand-0"]]
    askew, middle = problem.start.copy(), np.array([*problem.start[pair, :2].mean(axis=0), 1.0, 0.0])
    turned = compose(middle, np.array([0.0, 0.0, np.cos(0.5), np.sin(0.5)]))
    for slot in pair:
        carry(problem, askew, slot, compose(turned, relative(middle, askew[slot])))

    def no_worse(world: Floats) -> bool:
        one, other = relative(askew[pair[0]], askew[pair[1]]), relative(world[pair[0]], world[pair[1]])
        return bool(np.allclose(one, other, atol=1e-6))

    found = squared(problem, askew, no_worse)
    assert found[pair] == pytest.approx(problem.start[pair])


def test_a_rug_comes_along_with_what_would_leave_it_once_it_is_square() -> None:
    problem, _ = planned("living_room")
    problem = replace(problem, guessed=())
    table, rug = problem.slot["coffee_table-0"], problem.slot["rug-0"]
    askew = problem.start.copy()
    askew[rug, 0] += 0.5
    carry(problem, askew, table, compose(askew[table], np.array([0.0, 0.0, np.cos(0.1), np.sin(0.1)])))

    def apart(world: Floats) -> float:
        return float(np.hypot(*(world[table] - world[rug])[:2]))

    found = squared(problem, askew, lambda world: apart(world) < apart(askew) - 0.04)
    assert found[table] == pytest.approx(problem.start[table])
    assert apart(found) == pytest.approx(apart(askew) - 0.05)


def test_what_finds_room_only_late_goes_back_all_the_same() -> None:
    problem, _ = planned("bedroom")
    late, first = (problem.slot[name] for name in ("armchair-0", "wardrobe-0"))
    shaken = problem.start.copy()
    shaken[late, :2] += 0.5
    shaken[first, :2] += 0.2

    def no_worse(world: Floats) -> bool:
        back = np.isclose(world, problem.start).all(axis=1)
        return bool(back[first] or not back[late])

    assert once_more(problem, shaken, no_worse) == pytest.approx(problem.start)


def test_a_thing_goes_back_under_what_stands_on_it_and_is_where_it_belongs() -> None:
    problem, merit = planned("bedroom")
    target, slot = problem.start, problem.slot["night_stand-0"]
    lamp = next(i for i, parent in enumerate(problem.parent) if parent == slot)
    moved = target.copy()
    moved[slot, :2] += 0.06 * target[slot, 2:]  # the lamp stays over it
    found = once_more(problem, moved, lambda world: bool((world[lamp] == target[lamp]).all() and merit(world) == 0.0))
    assert found == pytest.approx(target)
