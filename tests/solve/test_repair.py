"""Repair: who makes way when a single thing is placed anew, and which starts a guess gets."""

from __future__ import annotations

import numpy as np
import pytest
from solve_rooms import BED, QUICK, problem_of, room_of, scattered

from robolayout.program import read_program, reconcile
from robolayout.run.flow import make_judge
from robolayout.scene import Asset, Pose
from robolayout.solve import Problem, Solver
from robolayout.solve.construct import Builder
from robolayout.solve.repair import WAYS, Repair
from robolayout.solve.runner import Run, Runner
from robolayout.verify import physics

WARDROBE = Asset("wardrobe-0", "wardrobe", (0.6, 1.6, 2.1))
BOXES = tuple(Asset(f"storage_box-{i}", "storage box", (0.5, 0.9, 0.4)) for i in range(4))
AT_WALL = "solver.against_wall(wardrobe[0], walls[2])"


def taken(**options: object) -> tuple[Problem, np.ndarray]:
    """Return a room in which boxes stand along the wall that the wardrobe wants, and its poses."""
    problem = problem_of(room_of(WARDROBE, BED, *BOXES), AT_WALL, **options)
    world = np.array([[2.0, 2.4, 0.0, -1.0], [1.1, 1.0, 1.0, 0.0]] + [[0.5 + i, 3.72, 0.0, -1.0] for i in range(4)])
    return problem, world


def mended(problem: Problem, world: np.ndarray, way: int, count: int = 12) -> list[np.ndarray]:
    repair = Repair(problem, Runner(QUICK), QUICK, Builder(problem, np.random.default_rng(way)))
    return [repair.mended(world, 0, way) for _ in range(count)]


def at_wall(problem: Problem, world: np.ndarray) -> bool:
    return problem.relations[0].check(problem.scene, problem.layout(world)).met


def overlapping(problem: Problem, world: np.ndarray) -> bool:
    return "wardrobe-0" in physics(problem.scene, problem.layout(world)).failing


@pytest.mark.parametrize("way", range(WAYS))
def test_a_wardrobe_gets_its_wall_only_if_boxes_make_way(way: int) -> None:
    problem, world = taken()
    found = mended(problem, world, way)
    right = [one for one in found if at_wall(problem, one) and not overlapping(problem, one)]
    assert bool(right) == (way > 0)
    for one in found:
        assert way in (1, 3) or (one[1] == world[1]).all(), "the bed is in the way only of what is put down blindly"
        assert way > 0 or (one[2:] == world[2:]).all()
        assert np.hypot(one[:, 2], one[:, 3]) == pytest.approx(1.0)


def test_what_is_pinned_makes_no_way() -> None:
    pinned = {f"storage_box-{i}": Pose(0.5 + i, 3.72, 0.2, -np.pi / 2) for i in range(4)}
    problem, world = taken(pinned=pinned)
    for way in range(WAYS):
        assert all((one[2:] == world[2:]).all() for one in mended(problem, world, way))


def test_a_blind_guess_is_built_anew_and_a_good_one_is_started_from(monkeypatch: pytest.MonkeyPatch) -> None:
    problem, world = taken()
    seen: list[tuple[str, np.ndarray]] = []
    real = Runner.advance

    def advance(self: Runner, stage: object, poses: np.ndarray, phase: object, label: str, **options: object) -> Run:
        seen.append((label, poses))
        return real(self, stage, poses, phase, label, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(Runner, "advance", advance)
    program = reconcile(read_program(AT_WALL, problem.scene), problem.scene).program
    judge = make_judge(problem.scene, program)
    for start, blind in ((world, False), (scattered(problem, np.random.default_rng(3)), True)):
        seen.clear()
        problem.__dict__["start"] = start
        Solver(problem, judge, QUICK).solve()
        polished = any((one == start).all() for _, poses in seen for one in poses)
        assert polished != blind
        assert not blind or "search" not in {label for label, _ in seen}
