"""The whole objective, with routes, carried things and saturating statements, against finite differences."""

from __future__ import annotations

from functools import partial

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from solve_rooms import BED, FURNISHED, L_SHAPED, LAMP, PICTURE, RUG, STANDS, problem_of, room_of, scattered

from robolayout._geometry import FrameRow
from robolayout.solve import Problem, Weights
from robolayout.solve.arrays import Arrays
from robolayout.solve.search import Losses, losses, total
from robolayout.solve.search import everything as all_pairs
from robolayout.solve.stage import make_stage

STARTS = 3


def parts(poses: jax.Array, arrays: Arrays, routes: jax.Array, weights: Weights = Weights()) -> Losses:  # noqa: B008
    x, y, yaw = (poses[..., i] for i in range(3))
    local = jnp.stack([x, y, jnp.cos(yaw), jnp.sin(yaw)], axis=-1)
    return losses(local, arrays, routes, all_pairs(arrays), weights)


def value(poses: jax.Array, arrays: Arrays, routes: jax.Array, weights: Weights) -> jax.Array:
    return jnp.sum(total(parts(poses, arrays, routes, weights), weights, 0.7))


_SAID = Weights(overlap=0.0, inside=0.0, clear=0.0, routes=0.0)
_compiled = partial(jax.jit, compiler_options={"xla_backend_optimization_level": "0"})
_gradient, _gradient_said = (_compiled(jax.value_and_grad(partial(value, weights=w))) for w in (Weights(), _SAID))
_parts = _compiled(parts)


def doubled(fields: Arrays) -> Arrays:
    return Arrays(*(f.astype(np.float64) if f.dtype.kind == "f" else f for f in fields))


@pytest.fixture(scope="module")
def problem() -> Problem:
    return problem_of(room_of(BED, *STANDS, LAMP, RUG, PICTURE, room=L_SHAPED), FURNISHED)


@pytest.fixture(scope="module")
def everything(problem: Problem) -> tuple[np.ndarray, Arrays, np.ndarray]:
    """Return poses (starts, slots, 3), arrays and routes, at which every term is at work."""
    rng = np.random.default_rng(4)
    worlds = np.stack([scattered(problem, rng) for _ in range(STARTS)])
    worlds[:, 2, :2] = worlds[:, 0, :2] + 0.2  # one thing inside another
    stage = make_stage(problem, 0, worlds[0])
    local = stage.local(worlds)
    poses = np.concatenate([local[..., :2], np.arctan2(local[..., 3:], local[..., 2:3])], axis=-1)
    points = worlds[:, [0, 1], :2] + 0.1
    routes = np.concatenate([points, np.tile([[0.0, 0.4], [1.0, 0.4]], (STARTS, 1, 1))], axis=-1)
    return poses, doubled(stage.arrays), routes


def test_every_term_is_at_work(everything: tuple[np.ndarray, Arrays, np.ndarray]) -> None:
    with jax.enable_x64(True):
        found = _parts(*everything)
    assert all((np.asarray(term) > 0).any() for term in found), found


@pytest.mark.slow
def test_the_gradient_of_the_objective_is_that_of_finite_differences(
    problem: Problem, everything: tuple[np.ndarray, Arrays, np.ndarray]
) -> None:
    """Of two things only one yields by rule; for differences to exist, here both do, and the mirror's axis is left out.

    Hard demands move things and do not turn them: headings follow the statements alone (what carries another turns its place).
    """
    poses, arrays, routes = everything
    rows = FrameRow(*arrays.frame_row.T)
    yielding = rows._replace(move_a=np.ones_like(rows.move_a), move_b=np.ones_like(rows.move_b))
    arrays = arrays._replace(frame_row=np.stack(yielding, axis=-1))
    step = 1e-6
    with jax.enable_x64(True):
        gradient = np.asarray(_gradient(poses, arrays, routes)[1])
        for slot, name in enumerate(problem.names):
            for axis in range(0 if name == "bed-0" else 2 if slot in problem.parent else 3):
                slope = _gradient if axis < 2 else _gradient_said
                up, down = poses.copy(), poses.copy()
                up[0, slot, axis] += step
                down[0, slot, axis] -= step
                first, second = (float(slope(p, arrays, routes)[0]) for p in (up, down))
                assert gradient[0, slot, axis] == pytest.approx((first - second) / (2 * step), rel=1e-4, abs=1e-5)
    assert not gradient[:, len(problem.names) :].any(), "padding is pulled"


def test_what_stands_on_a_thing_pulls_at_it(everything: tuple[np.ndarray, Arrays, np.ndarray]) -> None:
    """A lamp that is outside the room takes its night stand back in."""
    poses, arrays, routes = everything
    only = arrays._replace(inside=np.eye(8)[3], frame_row=0 * arrays.frame_row, mirror_weight=0 * arrays.mirror_weight)
    only = only._replace(pairs=0 * arrays.pairs, clear_weight=0 * arrays.clear_weight)
    away = poses.copy()
    away[:, 1, :2], away[:, 3, :2] = (-9.0, 0.0), 0.0
    with jax.enable_x64(True):
        gradient = np.asarray(_gradient(away, only, routes * (1, 1, 1, 0) - (0, 0, 0, 9))[1])
    assert (gradient[:, 1, 0] < 0).all(), "the night stand is pulled towards the room"
    assert not gradient[:, [0, 2, 4, 5]].any()


def test_statements_saturate_and_hard_demands_do_not(everything: tuple[np.ndarray, Arrays, np.ndarray]) -> None:
    """A statement that cannot be met fades; what stands outside the room is pulled the more, the farther it is."""
    poses, arrays, routes = everything
    pulls = []
    for away in (20.0, 200.0):
        moved = poses.copy()
        moved[:, :, 0] += away
        with jax.enable_x64(True):
            found = _parts(moved, arrays, routes)
        pulls.append((float(found.statements[0]) / away, float(found.boundary[0]) / away))
    assert pulls[1][0] < pulls[0][0] / 3
    assert pulls[1][1] > pulls[0][1] * 5
