"""Repair: who makes way when a single thing is placed anew, and which starts a guess gets."""

from __future__ import annotations

import numpy as np
import pytest
from solve_rooms import BED, LAMP, QUICK, STANDS, TABLE, problem_of, room_of

from robolayout._geometry import compose
from robolayout.run.flow import solve
from robolayout.scene import Asset, Pose
from robolayout.solve import Problem
from robolayout.solve.repair import MENDING, Repair, _on_its_top
from robolayout.solve.runner import Runner, SearchRun
from robolayout.solve.stage import make_stage, relative, stages
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
    repair = Repair(
        [make_stage(problem, n, problem.start) for n in stages(problem)],
        Runner(QUICK),
        QUICK,
        np.random.default_rng(way),
    )
    return [repair.mended(world, 0, way) for _ in range(count)]


def at_wall(problem: Problem, world: np.ndarray) -> bool:
    return problem.relations[0].check(problem.scene, problem.layout(world)).met


def overlapping(problem: Problem, world: np.ndarray) -> bool:
    return "wardrobe-0" in physics(problem.scene, problem.layout(world)).failing


@pytest.mark.parametrize("way", range(MENDING.ways))
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
    for way in range(MENDING.ways):
        assert all((one[2:] == world[2:]).all() for one in mended(problem, world, way))


def test_a_guess_is_polished_first_and_a_room_without_one_is_built(monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[str] = []
    real = Runner.advance

    def advance(
        self: Runner, stage: object, poses: np.ndarray, phase: object, label: str, **options: object
    ) -> SearchRun:
        seen.append(label)
        return real(self, stage, poses, phase, label, **options)  # type: ignore[arg-type]

    monkeypatch.setattr(Runner, "advance", advance)
    scene = room_of(WARDROBE, BED, *BOXES)
    names = ("wardrobe[0]", "bed[0]", *(f"storage_box[{i}]" for i in range(4)))
    heap = AT_WALL + "".join(f"\n{name}.position = [2, 2, 0.5]" for name in names)
    for text, first in ((heap, "polish"), (AT_WALL, None)):
        seen.clear()
        solution = solve(scene, text, config=QUICK)
        assert not solution.verdict.hard + solution.verdict.access
        assert (seen[0] if seen else None) == first
        assert solution.phase != "guess"


def test_the_phase_that_made_the_layout_is_told() -> None:
    scene = room_of(WARDROBE)
    right = "wardrobe[0].position = [2, 3.7, 1.05]\nwardrobe[0].rotation = [-90]\n" + AT_WALL
    assert solve(scene, right, config=QUICK).phase == "guess"
    assert solve(scene, right.replace("3.7", "3.4").replace("-90", "90"), config=QUICK).phase == "push"


def test_the_phase_of_the_floor_is_told_where_things_stand_on_tops() -> None:
    scene = room_of(WARDROBE, STANDS[0], LAMP)
    text = (
        AT_WALL
        + """
wardrobe[0].position = [2, 3.4, 1.05]
wardrobe[0].rotation = [90]
night_stand[0].position = [0.5, 0.5, 0.25]
solver.on_top_of(lamp[0], night_stand[0])
"""
    )
    assert solve(scene, text, config=QUICK).phase == "push"


def test_what_stands_on_a_thing_to_blame_stays_on_it_and_both_go_elsewhere() -> None:
    side = Asset("side_table-0", "side table", (0.42, 0.42, 0.5))
    scene = room_of(TABLE, side, LAMP)
    text = """
table[0].position = [2.0, 2.0, 0.375]
side_table[0].position = [2.1, 2.1, 0.25]
lamp[0].position = [2.1, 2.1, 0.7]
solver.on_top_of(lamp[0], side_table[0])
"""
    layout = solve(scene, text, config=QUICK).layout
    assert not physics(scene, layout).failing
    assert (
        abs(layout["lamp-0"].x - layout["side_table-0"].x) < 0.21 > abs(layout["lamp-0"].y - layout["side_table-0"].y)
    )


def test_what_overhangs_its_top_a_little_may_stay_so_and_what_is_beside_it_comes_back() -> None:
    """A meat slicer that a walker reaches only at the very edge of its counter was kept in the middle."""
    problem = problem_of(room_of(TABLE, LAMP), "solver.on_top_of(lamp[0], table[0])")
    lamp, table = problem.slot["lamp-0"], problem.slot["table-0"]
    hx, _ = problem.half[table]
    at = np.array([[hx - 0.01, 0.0, 1.0, 0.0], [hx + 0.5, 0.0, 1.0, 0.0]])
    found = _on_its_top(problem, lamp, compose(problem.start[table], at), problem.start)
    kept, back, *others = relative(problem.start[table], found)
    assert kept == pytest.approx(at[0])
    assert back[0] == pytest.approx(hx - problem.half[lamp][0]) == max(x for x, *_ in others)
