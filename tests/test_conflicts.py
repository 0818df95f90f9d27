"""What an unmet statement lost to is named."""

from __future__ import annotations

import math
from typing import Any

import robolayout as rl
from robolayout.run.conflicts import conflicts
from robolayout.scene import Layout, Pose
from robolayout.solve import compile_problem

SCENE: dict[str, Any] = {
    "task_description": "Two wardrobes.",
    "boundary": {"floor_vertices": [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], "wall_height": 2.6},
    "doors": [{"wall": 2, "offset": 1.5, "width": 0.9, "height": 2.05}],
    "assets": {
        f"wardrobe-{i}": {
            "category": "wardrobe",
            "onFloor": True,
            "assetMetadata": {"boundingBox": {"x": 0.6, "y": 2.4, "z": 2.1}},
        }
        for i in range(2)
    },
}
BOTH_AT_ONE_WALL = "solver.against_wall(wardrobe[0], walls[0])\nsolver.against_wall(wardrobe[1], walls[0])\n"


def test_a_wall_that_holds_only_one_of_two_names_the_other() -> None:
    result = rl.generate(SCENE, program=BOTH_AT_ONE_WALL)
    (lost,) = [item for item in result.report.statements if not item.met]
    other = next(name for name in ("wardrobe-0", "wardrobe-1") if f"({name}" not in lost.sentence)
    assert other in lost.lost_to
    assert result.report.figures["collision_free_share"] == 1.0, "hard demands win"
    assert any(f"it lost to {lost.lost_to}" in sentence for sentence in result.report.violations)
    assert result.report.to_dict()["statements"][lost.number - 1]["lost_to"] == lost.lost_to


def test_what_meeting_a_statement_would_cost_is_named() -> None:
    made = rl.generate(SCENE, program="solver.against_wall(wardrobe[0], walls[0])")
    poses = {"wardrobe-0": Pose(2.0, 2.0, 1.05, 1.57), "wardrobe-1": Pose(2.0, 0.3, 1.05, 1.57)}
    lost = conflicts(made.scene, made.reconciled, Layout(poses), {})
    assert lost[1].startswith("wardrobe-0 and wardrobe-1 overlap")


def test_what_the_filter_changed_is_put_down_to_the_filter() -> None:
    text = (
        "solver.distance_constraint(wardrobe[0], wardrobe[1], None, 1.2)\n"
        "solver.distance_constraint(wardrobe[1], wardrobe[0], 2.5, None)\n"
    )
    result = rl.generate(SCENE, program=text)
    (lost,) = [item for item in result.report.statements if not item.met]
    assert lost.number == 2
    assert lost.lost_to.startswith("the filter, ")


def test_what_is_met_lost_to_nothing() -> None:
    result = rl.generate(SCENE, program="solver.against_wall(wardrobe[0], walls[0])")
    assert all(item.met and not item.lost_to and not item.complaint for item in result.report.statements)


def test_the_same_seed_tells_the_same() -> None:
    first, second = (rl.generate(SCENE, program=BOTH_AT_ONE_WALL, seed=3).report.violations for _ in "ab")
    assert first == second


KITCHEN: dict[str, Any] = SCENE | {
    "task_description": "A kitchen.",
    "assets": {
        "stove-0": {
            "category": "stove",
            "onFloor": True,
            "assetMetadata": {"boundingBox": {"x": 0.6, "y": 0.6, "z": 0.9}},
        },
        "hood-0": {
            "category": "range hood",
            "onWall": True,
            "assetMetadata": {"boundingBox": {"x": 0.45, "y": 0.6, "z": 0.4}},
        },
        "clock-0": {
            "category": "clock",
            "onWall": True,
            "assetMetadata": {"boundingBox": {"x": 0.05, "y": 0.9, "z": 0.4}},
        },
    },
}
OVER_THE_STOVE = "solver.against_wall(stove[0], walls[0])\nsolver.above(hood[0], stove[0])\n"


def test_what_hangs_at_a_wall_is_tried_at_the_wall_behind_what_it_shall_hang_above() -> None:
    """Not in the air before it, where it lost to that; what hangs there already is named."""
    scene = rl.scene_from_dict(KITCHEN)
    reconciled = rl.reconcile(rl.read_program(OVER_THE_STOVE, scene), scene)
    half, stove = math.pi / 2, Pose(2.0, 0.3, 0.45, math.pi / 2)
    poses = {"stove-0": stove, "hood-0": Pose(0.225, 3.0, 1.5, 0.0), "clock-0": Pose(3.0, 0.025, 1.5, half)}
    assert conflicts(scene, reconciled, Layout(poses), {})[2].startswith("nothing that was found")
    taken = poses | {"clock-0": Pose(2.0, 0.025, 1.5, half)}
    assert conflicts(scene, reconciled, Layout(taken), {})[2].startswith("hood-0 and clock-0 overlap")


def test_what_hangs_above_a_thing_at_a_wall_is_held_at_that_wall() -> None:
    scene = rl.scene_from_dict(KITCHEN)
    guess = "hood[0].position = [0.225, 3.0, 1.5]\nclock[0].position = [0.025, 1.0, 1.5]\n"
    problem = compile_problem(scene, rl.read_program(guess + OVER_THE_STOVE, scene))
    assert {str(row.a): str(row.b) for row in problem.wall_terms} == {"hood-0": "walls[0]", "clock-0": "walls[3]"}
