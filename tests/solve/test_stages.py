"""What the solver is told: heights, supports, pairs, buckets of sizes. No program is compiled here."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from solve_rooms import BED, L_SHAPED, LAMP, PENDANT, PICTURE, RUG, SQUARE, STANDS, TABLE, problem_of, room_of

from robolayout.scene import Asset, Pose, Scene
from robolayout.solve.arrays import Arrays
from robolayout.solve.stage import make_stage, no_routes, relative, stages


def height(scene: Scene, text: str, name: str) -> float:
    return problem_of(scene, text).guess[name].z


def arrays_of(scene: Scene, text: str = "", number: int = 0) -> Arrays:
    problem = problem_of(scene, text)
    return make_stage(problem, number, problem.start).arrays


def pairs_of(scene: Scene, text: str = "", number: int = 0) -> set[tuple[str, str]]:
    arrays, names = arrays_of(scene, text, number), [asset.name for asset in scene.assets]
    slot = arrays.prism_slot
    return {(names[slot[a]], names[slot[b]]) for a, b in arrays.pairs if a != b}


def test_ceiling_things_hang_from_the_ceiling_of_this_room() -> None:
    """In the published code lamps hang at 3 m whatever the room."""
    assert height(room_of(PENDANT), "", "pendant-0") == pytest.approx(2.2 - 0.25)
    tall = room_of(PENDANT, room=replace(SQUARE, wall_height=3.4))
    assert height(tall, "", "pendant-0") == pytest.approx(3.4 - 0.25)


def test_wall_things_stay_at_their_height() -> None:
    """In the published code everything on a wall falls to the floor."""
    scene = room_of(PICTURE, BED)
    assert height(scene, "", "picture-0") == pytest.approx(1.5)
    assert height(scene, "picture[0].position = [1, 1, 1.2]", "picture-0") == pytest.approx(1.2)
    assert height(scene, "solver.mounted_on(picture[0], walls[1], height=1.7)", "picture-0") == pytest.approx(1.7)
    assert height(scene, "solver.mounted_on(picture[0], walls[1], height=9)", "picture-0") == pytest.approx(2.2 - 0.3)


def test_things_stand_on_the_floor_or_on_what_carries_them() -> None:
    scene = room_of(TABLE, LAMP, STANDS[0])
    assert height(scene, "", "table-0") == pytest.approx(0.375)
    assert height(scene, "solver.on_top_of(lamp[0], table[0])", "lamp-0") == pytest.approx(0.75 + 0.2)
    assert height(scene, "solver.on_top_of(lamp[0], night_stand[0])", "lamp-0") == pytest.approx(0.5 + 0.2)
    assert height(scene, "", "lamp-0") > 0.6, "what only stands on things is given one"
    tower = "solver.on_top_of(night_stand[0], table[0])\nsolver.on_top_of(lamp[0], night_stand[0])"
    carried = room_of(TABLE, LAMP, replace(STANDS[0], on_object=True))
    assert height(carried, tower, "lamp-0") == pytest.approx(0.75 + 0.5 + 0.2)
    assert list(stages(problem_of(carried, tower))) == [0, 1, 2]


def test_rugs_and_other_heights_are_no_obstacles() -> None:
    scene = room_of(BED, RUG, PICTURE, PENDANT, TABLE)
    assert pairs_of(scene) == {("bed-0", "table-0"), ("picture-0", "pendant-0")}
    shelf = replace(PICTURE, size=(0.3, 0.8, 1.5))
    assert ("bed-0", "picture-0") not in pairs_of(room_of(BED, shelf)), "it hangs above the bed"
    low = "solver.mounted_on(picture[0], walls[0], height=0.8)"
    assert ("bed-0", "picture-0") in pairs_of(room_of(BED, shelf), low)


def test_siblings_on_one_top_must_not_overlap_and_parent_and_child_may() -> None:
    lamps = tuple(replace(LAMP, name=f"lamp-{i}") for i in range(3))
    scene = room_of(TABLE, *lamps)
    text = "for l in lamp:\n    solver.on_top_of(l, table[0])"
    assert pairs_of(scene, text, 1) == {("lamp-0", "lamp-1"), ("lamp-0", "lamp-2"), ("lamp-1", "lamp-2")}
    assert pairs_of(scene, text, 0) == set()


def test_what_stands_on_a_thing_is_carried_while_that_moves() -> None:
    problem = problem_of(room_of(TABLE, LAMP), "solver.on_top_of(lamp[0], table[0])")
    stage = make_stage(problem, 0, problem.start)
    assert stage.moving == (0,)
    assert list(stage.arrays.carrier[:2]) == [-1, 0]
    upper = make_stage(problem, 1, problem.start)
    assert upper.moving == (1,)
    assert upper.arrays.anchor[1] == pytest.approx(problem.start[0], abs=1e-6)
    back = upper.local(problem.start)[1]
    assert back == pytest.approx(relative(problem.start[0], problem.start[1]), abs=1e-6)


def test_every_room_of_a_size_is_of_one_shape() -> None:
    """So one compiled program serves them all; two where many prisms may meet."""
    chairs = tuple(Asset(f"chair-{i}", "chair", (0.5, 0.5, 0.9)) for i in range(4))
    rooms = [
        arrays_of(room_of(BED)),
        arrays_of(room_of(TABLE, *chairs, room=L_SHAPED), "solver.around(chair, table[0])"),
        arrays_of(room_of(BED, *STANDS, RUG, LAMP), "solver.symmetric_pair(night_stand[0], night_stand[1], bed[0])"),
        arrays_of(room_of(TABLE, LAMP), "solver.on_top_of(lamp[0], table[0])", 1),
    ]
    shapes = {
        tuple((field.shape, field.dtype.str) for field in arrays._replace(pairs=arrays.pairs[:1])) for arrays in rooms
    }
    assert len(shapes) == 1
    assert len({len(arrays.pairs) for arrays in rooms}) <= 2
    assert all(np.isfinite(field).all() for arrays in rooms for field in arrays)


def test_padding_asks_for_nothing() -> None:
    arrays = arrays_of(room_of(BED))
    assert not arrays.frame_row[:, -1].any() and not arrays.mirror_weight.any() and not arrays.pairs.any()
    assert arrays.free.tolist() == [[1.0, 1.0, 0.0]] + [[0.0] * 3] * 7
    assert (no_routes(2, 3)[..., 3] < 0).all()


def test_only_what_the_rectangle_around_the_room_does_not_hold_is_asked_to_stay_inside() -> None:
    assert not arrays_of(room_of(BED)).inside.any()
    assert arrays_of(room_of(BED, room=L_SHAPED)).inside.tolist() == [1.0] + [0.0] * 7
    long = replace(BED, size=(4.5, 0.5, 0.5))  # fits into 4 m x 4 m only askew
    assert arrays_of(room_of(long)).inside.tolist() == [1.0] + [0.0] * 7


def test_free_ways_ask_for_nothing() -> None:
    assert (no_routes(2, 3)[..., 3] < 0).all()


def test_a_fixed_point_is_kept() -> None:
    """The published code drops fixed points silently."""
    arrays = arrays_of(room_of(BED), "solver.distance_constraint(bed[0], AssetInstance(position=[1, 2, 0]), 0, 0.5)")
    a, b = arrays.frame_index[0]
    assert a == 0 and b >= 8
    assert arrays.fixed[b - 8, :2].tolist() == [1.0, 2.0]


def test_what_is_pinned_does_not_move() -> None:
    problem = problem_of(room_of(BED, TABLE), pinned={"bed-0": Pose(1.0, 1.0, 0.25, 0.5)})
    assert problem.guess["bed-0"] == Pose(1.0, 1.0, 0.25, 0.5)
    assert make_stage(problem, 0, problem.start).moving == (1,)


def test_a_guess_is_taken_and_the_rest_is_built_around_it() -> None:
    scene = room_of(BED, TABLE)
    text = "bed[0].position = [1.5, 2, 0.25]\nbed[0].rotation = [0, 0, pi]"
    first, again = (problem_of(scene, text, seed=seed) for seed in (1, 1))
    assert (first.guess["bed-0"].x, first.guess["bed-0"].yaw) == (1.5, pytest.approx(np.pi))
    assert first.guess == again.guess


def test_a_wall_thing_without_a_wall_is_held_at_the_nearest_one() -> None:
    arrays = arrays_of(room_of(PICTURE), "picture[0].position = [3.8, 2, 1.5]")
    held = [index for index, row in zip(arrays.frame_index, arrays.frame_row, strict=True) if row[-1] > 1.0]
    assert [list(index) for index in held] == [[0, 8 + 1]]


def test_a_room_without_guesses_is_not_turned_by_gradients() -> None:
    scene = room_of(BED, TABLE, PICTURE)
    text = "solver.point_towards(table[0], bed[0])"
    names = [asset.name for asset in scene.assets]
    turning = arrays_of(scene, text).free[: len(names), 2]
    assert [name for name, turns in zip(names, turning, strict=True) if turns] == ["table-0"]
    assert arrays_of(scene, "bed[0].position = [1, 1, 0.3]").free[:2, 2].all()
