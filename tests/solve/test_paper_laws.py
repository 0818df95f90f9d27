"""What the paper's algorithm keeps in every room: feasible steps, projections that end inside, a refinement that cannot harm."""

from __future__ import annotations

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import Polygon

from robolayout._geometry import Body, intersection_over_union
from robolayout.scene import Asset
from robolayout.solve import Verdict, compile_problem
from robolayout.solve.paper.project import footprint, into_room, onto_carrier, outside, projected
from robolayout.solve.paper.solver import (
    PAPER,
    LossAt,
    PaperConfig,
    PaperSolver,
    adam,
    admissible,
    clipped,
    judged_step,
    paper_loss,
    random_start,
)
from solve.paper_rooms import L_SHAPED, PROGRAM, SQUARE, TRIANGLE, overlap_judge, problem

SHORT = PaperConfig(steps=40, refine_steps=10)
coordinates = st.floats(-3.0, 8.0)
angles = st.floats(-7.0, 7.0)


def pose(x: float, y: float, yaw: float) -> np.ndarray:
    return np.array([x, y, math.cos(yaw), math.sin(yaw)])


@given(st.integers(0, 2**32), st.floats(1e-3, 2.0), st.floats(1e-4, 5.0))
def test_every_step_is_feasible(seed, radius, length):
    rng = np.random.default_rng(seed)
    world = np.array([pose(*rng.uniform(0.0, 4.0, 2), rng.uniform(-7, 7)) for _ in range(5)])
    step = admissible(SQUARE, world, length * rng.standard_normal((5, 4)), radius)
    after = world + step
    assert np.linalg.norm(step) <= radius * (1 + 1e-9)
    assert np.all((after[:, :2] >= -1e-12) & (after[:, :2] <= 4.0 + 1e-12))
    np.testing.assert_allclose(np.hypot(after[:, 2], after[:, 3]), 1.0, atol=1e-12)


def test_a_feasible_step_passes_unchanged():
    world = np.array([pose(1.0, 1.0, 0.3)])
    turned = np.array([pose(1.1, 0.9, 0.4)])
    np.testing.assert_allclose(admissible(SQUARE, world, turned - world, 1.0), turned - world, atol=1e-12)


@given(st.integers(0, 2**32))
def test_clipping_shortens_and_keeps_the_direction(seed):
    gradient = np.random.default_rng(seed).standard_normal((4, 4)) * 20
    parts, shorter = gradient.reshape(4, 2, 2), clipped(gradient, 10.0).reshape(4, 2, 2)
    lengths = np.linalg.norm(parts, axis=-1)
    np.testing.assert_allclose(np.linalg.norm(shorter, axis=-1), np.minimum(lengths, 10.0), rtol=1e-12)
    np.testing.assert_allclose(np.sum(parts * shorter, axis=-1), lengths * np.minimum(lengths, 10.0), rtol=1e-12)
    assert not clipped(np.zeros((1, 4)), 10.0).any()


@pytest.mark.parametrize(
    ("gain", "verdict"),
    [(1.0, (True, 0.8)), (0.5, (True, 0.4)), (0.05, (False, 0.2)), (-1.0, (False, 0.2))],
)
def test_the_ratio_decides_on_a_step_and_on_the_radius(gain, verdict):
    step, gradient = np.array([[0.1, 0.0, 0.0, 0.0]]), np.array([[-10.0, 0.0, 0.0, 0.0]])
    before, after = LossAt(5.0, gradient, np.zeros(3)), LossAt(5.0 - gain, gradient, np.zeros(3))
    assert judged_step(before, after, step, 0.4) == verdict
    assert judged_step(before, after, -step, 0.4) == (False, 0.2)  # uphill is refused, whatever came of it
    assert judged_step(before, LossAt(0.0, gradient, np.zeros(3)), step, 1.0)[1] == PAPER.most_radius


def test_adam_steps_by_its_rate_against_a_steady_gradient():
    from robolayout.solve.paper.solver import Moments

    gradient, moments = np.array([[3.0, -0.5, 0.0, 1e-3]]), Moments.zero(np.zeros((1, 4)))
    for _ in range(5):
        moments, step = adam(moments, gradient, np.full(4, 0.1))
        np.testing.assert_allclose(step, [[-0.1, 0.1, 0.0, -0.1]], atol=1e-5)


@given(coordinates, coordinates, angles, st.floats(0.1, 0.7), st.floats(0.1, 0.7))
def test_small_things_end_inside_a_convex_room(x, y, yaw, hx, hy):
    half = np.array([hx, hy])
    for room in (SQUARE, TRIANGLE):
        before = pose(x, y, yaw)
        after = into_room(room, before, half)
        assert not outside(room, footprint(after, half)).any()
        np.testing.assert_array_equal(after[2:], before[2:])


@given(st.floats(0.5, 1.5), st.floats(0.5, 4.5), angles)
def test_what_is_inside_stays_where_it_is(x, y, yaw):
    half = np.array([0.3, 0.3])
    before = pose(x, y, yaw)
    np.testing.assert_array_equal(into_room(L_SHAPED, before, half), before)


@given(coordinates, coordinates, angles, st.floats(0.0, 4.0), st.floats(0.0, 4.0), angles)
def test_a_carried_thing_ends_with_its_centre_over_its_carrier(x, y, yaw, cx, cy, cyaw):
    half = np.array([0.6, 0.4])
    after = onto_carrier(pose(x, y, yaw), pose(cx, cy, cyaw), half)
    top = Polygon(footprint(pose(cx, cy, cyaw), half))
    from shapely import Point

    assert top.distance(Point(after[:2])) < 1e-9
    assert Point(after[:2]).distance(Point(x, y)) == pytest.approx(top.distance(Point(x, y)), abs=1e-9)


def test_projection_brings_children_along_and_leaves_pinned_things_alone():
    lamp = Asset("lamp-0", "lamp", (0.2, 0.2, 0.3), on_floor=False, on_object=True)
    table = Asset("table-0", "table", (1.0, 1.0, 0.7))
    stacked = problem("solver.on_top_of(lamp[0], table[0])", (lamp, table))
    world = np.array([pose(3.0, 3.0, 0.0), pose(-0.2, 2.0, 0.0)])
    after = projected(stacked, world)
    assert after[1, 0] == pytest.approx(0.634323, abs=1e-6)
    np.testing.assert_allclose(after[0, :2], after[1, :2] + 0.5)  # the nearest corner of the top
    pinned = compile_problem(stacked.scene, seed=0, pinned=dict(stacked.layout(world)))
    np.testing.assert_array_equal(projected(pinned, world), world)


@pytest.mark.parametrize("room", [SQUARE, L_SHAPED, TRIANGLE])
def test_every_start_is_inside_the_room(room):
    free = problem("", room=room)
    for seed in range(20):
        world = random_start(free, np.random.default_rng(seed))
        for row, half in zip(world, free.half, strict=True):
            assert not outside(room, footprint(row, half)).any()


def test_the_programs_own_places_are_kept():
    boxes = problem()
    np.testing.assert_array_equal(random_start(boxes, np.random.default_rng(0)), boxes.start)


def test_same_seed_same_layout():
    free = problem("solver.distance_constraint(box[1], box[0], 1.5, 2)")
    runs = [PaperSolver(free, overlap_judge(free), seed=seed, config=SHORT).solve() for seed in (3, 3, 4)]
    assert repr(runs[0].layout) == repr(runs[1].layout) != repr(runs[2].layout)
    assert runs[0].trace == runs[1].trace


def test_two_boxes_part_and_meet_their_statement():
    boxes = problem()
    solution = PaperSolver(boxes, overlap_judge(boxes)).solve()
    assert (solution.status, solution.verdict.soft) == ("solved", 0.0)
    near, far = solution.layout["box-0"], solution.layout["box-1"]
    assert 0.98 <= math.hypot(near.x - far.x, near.y - far.y) <= 2.0
    assert len(solution.trace.losses) == PAPER.steps + 1
    assert solution.trace.losses[0]["total"] == pytest.approx(231.213142, abs=1e-6)
    assert solution.trace.losses[-1]["overlap"] == 0.0


def test_pinned_things_stay_bit_for_bit():
    boxes = problem()
    held = boxes.guess["box-0"]
    pinned = compile_problem(boxes.scene, seed=0, pinned={"box-0": held})
    solution = PaperSolver(pinned, overlap_judge(pinned), seed=1, config=SHORT).solve()
    assert solution.layout["box-0"] == held


def test_the_refinement_moves_the_problematic_only():
    boxes = problem(PROGRAM, (*problem().scene.assets, Asset("chair-0", "chair", (0.5, 0.5, 0.9))))
    solver = PaperSolver(boxes, overlap_judge(boxes), config=SHORT)
    world = boxes.start.copy()
    world[2] = pose(3.5, 3.5, 0.1)
    after = solver.refine(world, (0, 1))
    np.testing.assert_array_equal(after[2], world[2])
    np.testing.assert_allclose(np.abs(after - world)[:2, :2] > 0.05, True)


def test_a_refinement_that_harms_is_not_kept():
    boxes = problem()
    asked: list[object] = []

    def judge(layout) -> Verdict:
        asked.append(layout)
        return Verdict(0.0, 0.0, float(len(asked)))  # the later, the worse

    still = PaperConfig(steps=0)
    solution = PaperSolver(boxes, judge, config=still).solve()
    assert len(asked) == 2
    assert solution.layout == asked[0] != asked[1]


def boxes_at_random(count: int, seed: int) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    half = rng.uniform(0.1, 1.5, (count, 2))
    grid = rng.random(count) < 0.4  # upright boxes whose edges meet
    half[grid] = np.round(half[grid] * 2 + 0.5) / 2
    place, yaw = rng.uniform(-1, 1, (count, 2)), rng.uniform(-7, 7, count)
    place[grid], yaw[grid] = np.round(place[grid] * 2) / 2, np.round(yaw[grid]) * math.pi / 2
    return np.array([pose(*p, a) for p, a in zip(place, yaw, strict=True)]), half


def bodies(poses, half):
    columns = [*jnp.asarray(poses).T, *jnp.asarray(half).T, jnp.zeros(len(half))]
    return Body(*columns)


@pytest.mark.slow
def test_intersection_over_union_is_shapelys_and_its_gradient_is_right():
    (pa, ha), (pb, hb) = boxes_at_random(400, 0), boxes_at_random(400, 1)
    shapes = [(Polygon(footprint(pa[i], ha[i])), Polygon(footprint(pb[i], hb[i]))) for i in range(len(pa))]
    exact = [a.intersection(b).area / a.union(b).area for a, b in shapes]
    with jax.enable_x64(True):
        evaluate = jax.jit(lambda p: intersection_over_union(bodies(pa, ha), bodies(p, hb)))
        np.testing.assert_allclose(evaluate(pb), exact, atol=1e-9)
        np.testing.assert_allclose(jax.jit(lambda p: intersection_over_union(bodies(p, ha), bodies(p, ha)))(pa), 1.0)
        slope = jax.jit(jax.grad(lambda p: jnp.sum(intersection_over_union(bodies(pa, ha), bodies(p, hb)))))(pb)
        between = np.sum(pa[:, 2:] * pb[:, 2:], axis=1), pa[:, 2] * pb[:, 3] - pa[:, 3] * pb[:, 2]
        tilted = np.min(np.abs(between), axis=0) > 1e-3  # edges that run alongside have kinks
        for axis in range(4):
            shift = np.eye(4)[axis] * 1e-6
            difference = (evaluate(pb + shift) - evaluate(pb - shift)) / 2e-6
            np.testing.assert_allclose(np.asarray(slope)[tilted, axis], difference[tilted], atol=1e-4)
        assert np.isfinite(slope).all()


@pytest.mark.slow
@settings(max_examples=15, deadline=None)
@given(st.integers(0, 2**32))
def test_the_gradient_of_the_whole_loss(seed):
    lamp = Asset("lamp-0", "lamp", (0.5, 0.4, 0.4), on_floor=False, on_object=True)
    stacked = problem(
        "solver.on_top_of(lamp[0], box[0])\nsolver.against_wall(box[1], walls[2])\nsolver.symmetric_pair(box[0], box[1], walls[0])",
        (*problem().scene.assets, lamp),
    )
    rng = np.random.default_rng(seed)
    world = np.array([pose(*rng.uniform(0.5, 3.5, 2), rng.uniform(-7, 7)) for _ in range(3)])
    loss = paper_loss(stacked)
    gradient = loss(world).gradient
    for i, axis in np.ndindex(3, 4):
        shift = np.zeros((3, 4))
        shift[i, axis] = 1e-6
        difference = (loss(world + shift).value - loss(world - shift).value) / 2e-6
        assert gradient[i, axis] == pytest.approx(difference, abs=1e-3, rel=1e-4)


def test_no_gradient_is_lost_where_things_coincide():
    boxes = problem()
    world = np.repeat(boxes.start[:1], 2, axis=0)
    found = paper_loss(boxes)(world)
    assert np.isfinite(found.gradient).all()
    assert found.terms[0] == pytest.approx(1000.0)
