"""What poses of one thing cost, worked out by NumPy, against the objective that the compiled search follows."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from solve_rooms import BED, FURNISHED, L_SHAPED, LAMP, PICTURE, RUG, STANDS, problem_of, room_of, scattered

from robolayout.scene import Asset, Room
from robolayout.solve import Problem, Weights
from robolayout.solve.arrays import Arrays
from robolayout.solve.score import Score
from robolayout.solve.search import everything, losses, total
from robolayout.solve.stage import Stage, make_stage, no_routes
from robolayout.verify import physics
from running import slow

WARDROBE = Asset("wardrobe-0", "wardrobe", (0.6, 1.6, 2.1))
SLANTED = Room(((0, 0), (5, 0), (5, 3), (0, 4)), 2.5)
PLAIN = "solver.against_wall(wardrobe[0], walls[1])\nsolver.distance_constraint(bed[0], wardrobe[0], 0.5, 1.5)"
WEIGHTS = Weights()


def furnished() -> Problem:
    return problem_of(room_of(BED, *STANDS, LAMP, RUG, PICTURE, room=L_SHAPED), FURNISHED)


def compiled(stage: Stage, worlds: np.ndarray) -> np.ndarray:
    """Return the whole objective of layouts (k, n, 4) by the functions that the search compiles, in single precision."""
    arrays = Arrays(*(jnp.asarray(f) for f in stage.arrays))
    arrays = arrays._replace(inside=(arrays.half[:, 0] > 0.0) * 1.0)  # as boxes that nothing keeps in the room
    local = jnp.asarray(stage.local(worlds))
    free = no_routes(len(worlds), 8)
    return np.asarray(total(losses(local, arrays, free, everything(arrays), WEIGHTS), WEIGHTS))


@pytest.mark.parametrize(
    "problem",
    [furnished(), problem_of(room_of(BED, WARDROBE, *STANDS, room=SLANTED), PLAIN)],
    ids=["L", "slanted"],
)
@pytest.mark.parametrize("slot", [slow(0), slow(1), 2])
def test_the_cost_of_a_pose_is_what_it_adds_to_the_objective(problem: Problem, slot: int) -> None:
    """One cost: between two poses of a thing both differ by the same, whatever stands around it."""
    rng, settled = np.random.default_rng(slot), np.array([parent < 0 for parent in problem.parent])
    for _ in range(4):
        world = scattered(problem, rng)
        stage = make_stage(problem, 0, world)
        poses = np.array([scattered(problem, rng)[slot] for _ in range(6)])
        worlds = np.repeat(world[None], len(poses), axis=0)
        worlds[:, slot] = poses
        expected, score = compiled(stage, worlds), Score(stage, WEIGHTS)
        cost = score.hard(slot, poses, world, settled)[0] + score.statements(slot, poses, world, settled)
        assert cost - cost[0] == pytest.approx(expected - expected[0], rel=1e-4, abs=1e-3)


@pytest.mark.slow
@given(x=st.floats(0.6, 3.4), y=st.floats(0.6, 3.4), turn=st.floats(0.0, 6.28))
@settings(max_examples=40, deadline=None)
def test_broken_means_what_the_judge_means(x: float, y: float, turn: float) -> None:
    problem = problem_of(room_of(WARDROBE, BED))
    world = np.array([[1.0, 3.0, 1.0, 0.0], [x, y, np.cos(turn), np.sin(turn)]])
    score = Score(make_stage(problem, 0, world), WEIGHTS)
    _, broken = score.hard(1, world[[1]], world, np.ones(2, np.bool_))
    failing = physics(problem.scene, problem.layout(world)).failing
    assert ("bed-0" in failing) <= bool(broken[0]), failing
    assert ("wardrobe-0" in score.touched(1, world[[1]], world)) <= bool(broken[0])


def test_what_is_not_settled_counts_for_nothing() -> None:
    problem = problem_of(room_of(WARDROBE, BED), PLAIN)
    world = np.array([[2.0, 2.0, 1.0, 0.0]] * 2)
    score = Score(make_stage(problem, 0, world), WEIGHTS)
    alone = np.array([False, False])
    assert score.hard(1, world[[1]], world, alone)[1][0] == 0
    assert score.statements(1, world[[1]], world, alone)[0] == 0.0
    assert score.hard(1, world[[1]], world, ~alone)[1][0] > 0
    assert score.statements(1, world[[1]], world, ~alone)[0] > 0.0


def test_a_thing_on_a_route_costs_the_clearance_that_is_missing() -> None:
    problem = problem_of(room_of(BED))
    score = Score(make_stage(problem, 0, problem.start), WEIGHTS)
    poses = np.array([[2.0, 2.0, 1.0, 0.0], [2.0, 3.0, 1.0, 0.0]])
    half = BED.size[1] / 2
    demands = np.array([[2.0, 2.0 - half - 0.1, 0.0, 0.3]])
    cost = score.routes(0, poses, demands)
    assert cost[0] == pytest.approx(60.0 * (0.2**2 + 0.02 * 0.2), rel=1e-3)
    assert cost[1] == 0.0
