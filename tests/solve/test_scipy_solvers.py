"""SciPy's solvers on the paper's loss: constraint held, loss lowered, bounded, settled by the seed; and solvers by name."""

from __future__ import annotations

import warnings

import numpy as np
import pytest

from robolayout._errors import UnknownNameError
from robolayout.scene import Scene
from robolayout.solve import compile_problem, solve_with, solver_names
from robolayout.solve.paper.scipy_solvers import ScipyConfig, ScipySolver
from robolayout.solve.paper.solver import paper_loss
from solve.paper_rooms import BOXES, PROGRAM, SQUARE, overlap_judge, problem

QUICK = ScipyConfig(iterations=120, evaluations=400, rounds=20, polish=30)
METHODS = ("trust_constr", "dual_annealing")
TURNED = PROGRAM.replace("rotation = [0, 0, 0]", "rotation = [0, 0, 0.4]")


def run(method: str, of=None, seed: int = 0, config: ScipyConfig = QUICK):
    of = of or problem()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return getattr(ScipySolver(of, overlap_judge(of), seed=seed, config=config), method)()


def poses(of, layout) -> np.ndarray:
    return np.array([(p.x, p.y, np.cos(p.yaw), np.sin(p.yaw)) for p in (layout[name] for name in of.names)])


@pytest.mark.parametrize("method", METHODS)
def test_boxes_part_and_the_loss_falls(method):
    boxes = problem(TURNED)
    solution = run(method, boxes)
    loss = paper_loss(boxes)
    assert (solution.status, solution.message) == ("solved", "Every demand and every statement is met.")
    assert loss(poses(boxes, solution.layout)).value < 0.05 * loss(boxes.start).value
    assert solution.trace.losses[-1].keys() == {"overlap", "statements", "reachability", "total"}


@pytest.mark.parametrize("method", METHODS)
def test_same_seed_same_layout(method):
    free = problem("solver.distance_constraint(box[1], box[0], 1.5, 2)")
    first, again, other = (run(method, free, seed) for seed in (1, 1, 2))
    assert repr(first.layout) == repr(again.layout) != repr(other.layout)


@pytest.mark.parametrize("method", METHODS)
def test_pinned_things_stay_bit_for_bit(method):
    boxes = problem()
    held = boxes.guess["box-0"]
    one = compile_problem(boxes.scene, seed=0, pinned={"box-0": held})
    assert run(method, one).layout["box-0"] == held
    both = compile_problem(boxes.scene, seed=0, pinned=dict(boxes.guess))
    assert dict(run(method, both).layout) == dict(boxes.guess)


def test_headings_are_on_the_unit_circle_before_anything_is_mended(monkeypatch):
    solver = ScipySolver(problem(TURNED), overlap_judge(problem()), config=QUICK)
    ends: list[np.ndarray] = []
    monkeypatch.setattr(solver, "_concluded", ends.append)
    solver.trust_constr()
    headings = ends[0].reshape(-1, 4)[:, 2:]
    np.testing.assert_allclose(np.hypot(*headings.T), 1.0, atol=1e-6)


@pytest.mark.slow
def test_annealing_is_bounded_by_evaluations():
    counts: list[int] = []
    for evaluations in (100, 1000):
        solver = ScipySolver(
            problem(""), overlap_judge(problem()), config=ScipyConfig(evaluations=evaluations, rounds=1000, polish=1)
        )
        calls: list[int] = []
        loss = solver.loss
        solver.loss = lambda world, loss=loss, calls=calls: calls.append(1) or loss(world)
        solver.dual_annealing()
        counts.append(len(calls))
    assert 100 <= counts[0] < counts[1] < 2500


def test_solvers_by_name():
    assert solver_names() == ("default", "paper", "paper-unrefined", "trust-constr", "dual-annealing")
    boxes = problem()
    told: list[str] = []
    solution = solve_with("paper", boxes, overlap_judge(boxes), progress=told.append)
    assert solution.status == "solved"
    assert told[0] == "search"


def test_an_unknown_name_is_answered_with_the_known_ones():
    expected = r"unknown solver 'papr'. Did you mean 'paper'\? Known: default, dual-annealing, paper, paper-unrefined, trust-constr."
    with pytest.raises(UnknownNameError, match=expected):
        solve_with("papr", problem(), overlap_judge(problem()))


@pytest.mark.parametrize("name", ["default", "paper", "paper-unrefined", "trust-constr", "dual-annealing"])
def test_nothing_to_place_is_solved(name):
    nothing = compile_problem(Scene(SQUARE, ()))
    solution = solve_with(name, nothing, overlap_judge(nothing))
    assert (solution.status, dict(solution.layout)) == ("solved", {})


@pytest.mark.parametrize("name", ["paper", "trust-constr"])
def test_one_thing_alone_is_placed_inside(name):
    alone = problem("", BOXES[:1])
    (pose,) = solve_with(name, alone, overlap_judge(alone)).layout.values()
    assert 0.4 <= pose.x <= 3.6
    assert 0.4 <= pose.y <= 3.6
