"""Laws of every relation: gradients, residual against check, moves of the whole scene, batches, awkward points, words."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from relation_scenes import (
    PARTS,
    ROOMS,
    SLOTS,
    STARTS,
    STATED,
    Case,
    anywhere,
    case,
    descend,
    flat_problem,
    measure,
    moved_layout,
    moved_relation,
    moved_scene,
    scene_of,
    stage_arrays,
    vary,
)

from robolayout.constraints import RELATIONS, ClearTerm
from robolayout.program import Program, Statement, read_program
from robolayout.scene import Asset, Room, Scene
from robolayout.solve.stage import make_stage
from robolayout.verify.physics import Physics, physics

ZERO = 1e-3
"""Residual (metres plus 1 - cos) below which a statement counts as satisfied."""

ALLOWANCE = 0.15
"""Most residual per row of terms that a check may let pass: 5 cm along two axes and 10 degrees, or 15 cm."""

VARIANTS = range(len(ROOMS))
each = pytest.mark.parametrize("name", list(RELATIONS))


def differences(poses: np.ndarray, case_arrays, parts: tuple[str, ...], count: int) -> np.ndarray:
    """Return central differences (count, 3) of the chosen parts at one layout (slots, 3)."""
    step = 1e-6
    probes = np.repeat(poses[None], 6 * count, axis=0)
    for i in range(3 * count):
        probes[2 * i, i // 3, i % 3] += step
        probes[2 * i + 1, i // 3, i % 3] -= step
    values = np.concatenate([measure(batch, case_arrays, parts)[0] for batch in batches(probes)])[: len(probes)]
    return ((values[0::2] - values[1::2]) / (2 * step)).reshape(count, 3)


def batches(poses: np.ndarray) -> list[np.ndarray]:
    """Return layouts in batches of the one size that is compiled; the last is filled up with its own last layout."""
    missing = -len(poses) % STARTS
    return list(np.concatenate([poses, np.repeat(poses[-1:], missing, axis=0)]).reshape(-1, STARTS, SLOTS, 3))


def shaken(found: Case, sigma: float) -> np.ndarray:
    """Return the satisfied layouts of a case, moved by some sigma metres and turned by some 2 sigma radians."""
    noise = np.random.default_rng(7).normal(0.0, sigma, found.satisfied.shape)
    return found.satisfied + noise * (1.0, 1.0, 2.0)


@each
def test_the_gradient_is_that_of_finite_differences(name: str) -> None:
    for variant in VARIANTS:
        found = case(name, variant)
        count = len(found.scene.assets)
        for poses in (found.random, shaken(found, 0.1)):
            _, gradient = measure(poses, found.arrays)
            expected = differences(poses[0], found.arrays, STATED, count)
            clears = any(isinstance(t, ClearTerm) for t in found.relation.terms(found.scene, found.near))
            moves = [clears or asset.name in found.movers for asset in found.scene.assets]
            assert gradient[0, :count][moves] == pytest.approx(expected[moves], rel=1e-4, abs=1e-5)
            assert not gradient[0, :count][np.logical_not(moves)].any(), "pulls at what it does not move"
            assert not gradient[:, count:].any()


@each
def test_no_residual_means_that_the_check_passes(name: str) -> None:
    for variant in VARIANTS:
        found = case(name, variant)
        residual, _ = measure(found.satisfied, found.arrays)
        assert (residual < ZERO).any(), f"{found.relation.sentence()}: no layout satisfies it"
        for poses in found.satisfied[residual < ZERO]:
            outcome = found.relation.check(found.scene, found.layout(poses))
            assert outcome.met, f"{found.relation.sentence()}: {outcome.text}"


@each
def test_a_passed_check_means_little_residual(name: str) -> None:
    passed = 0
    for variant in VARIANTS:
        found = case(name, variant)
        for sigma in (0.005, 0.02, 0.06, 0.15):
            for poses in shaken(found, sigma):
                layout = found.layout(poses)
                if not found.relation.check(found.scene, layout).met:
                    continue
                passed += 1
                if not found.relation.surrogate:
                    assert residual_of(found, poses) <= ALLOWANCE * found.rows, found.relation.sentence()
    assert passed > 10


def residual_of(found: Case, poses: np.ndarray) -> float:
    """Return the residual of one layout, with the rows that the relation picks near to that very layout."""
    layout, arrays = found.layout(poses), found.arrays
    if found.relation.terms(found.scene, layout) != found.relation.terms(found.scene, found.near):
        arrays = stage_arrays(replace(flat_problem(found.scene, found.relation), guess=layout))
    return measure(np.repeat(poses[None], STARTS, axis=0), arrays)[0][0]


@each
def test_nothing_changes_when_the_whole_scene_moves(name: str) -> None:
    angle, shift = 2.1, (-4.0, 1.5)
    for variant in VARIANTS:
        found = case(name, variant)
        scene, relation = moved_scene(found.scene, angle, shift), moved_relation(found.relation, angle, shift)
        problem = replace(flat_problem(scene, relation), guess=moved_layout(found.near, angle, shift))
        arrays = stage_arrays(problem)
        for poses in (found.random, shaken(found, 0.05)):
            layouts = [moved_layout(found.layout(start), angle, shift) for start in poses]
            moved = np.zeros_like(poses)
            for k, layout in enumerate(layouts):
                for i, asset in enumerate(scene.assets):
                    moved[k, i] = (layout[asset.name].x, layout[asset.name].y, layout[asset.name].yaw)
            before, after = measure(poses, found.arrays)[0], measure(moved, arrays)[0]
            assert after == pytest.approx(before, rel=1e-4, abs=1e-4), relation.sentence()
            for start, layout in zip(poses, layouts, strict=True):
                here, there = found.relation.check(found.scene, found.layout(start)), relation.check(scene, layout)
                assert there.value == pytest.approx(here.value, abs=1e-4), relation.sentence()


@each
def test_a_batch_is_as_good_as_one_at_a_time(name: str) -> None:
    found = case(name, 1)
    together, gradient = measure(found.random, found.arrays)
    for k in (0, STARTS - 1):
        alone, own = measure(np.repeat(found.random[k : k + 1], STARTS, axis=0), found.arrays)
        assert alone == pytest.approx(together[k], abs=1e-9)
        assert own[0] == pytest.approx(gradient[k], abs=1e-9)


@each
def test_statements_of_one_problem_add_up(name: str) -> None:
    found = case(name, 1)
    other = vary(found.relation, found.scene, np.random.default_rng(5))
    first, second, both = (
        measure(found.random, stage_arrays(replace(flat_problem(found.scene, *relations), guess=found.near)))[0]
        for relations in ((found.relation,), (other,), (found.relation, other))
    )
    assert both == pytest.approx(first + second, rel=1e-6, abs=1e-6)


def awkward(scene: Scene) -> np.ndarray:
    """Return layouts (STARTS, SLOTS, 3) at which something is exactly zero, opposite, touching or on a line."""
    poses = np.zeros((STARTS, SLOTS, 3))
    start, end = np.array(scene.room.walls[0].start), np.array(scene.room.walls[0].end)
    poses[1, :, 2] = np.arange(SLOTS) * math.pi  # opposite headings in one place
    poses[2, :, 2] = np.arange(SLOTS) * math.pi / 2
    poses[3, :, :2] = (start + end) / 2  # all in the middle of a wall
    poses[4, :, :2] = start  # all in one corner of the room
    poses[5, :, :2] = np.linspace(start, end, SLOTS)  # in a line on a wall
    edge = 0.0
    for i, asset in enumerate(scene.assets):  # side by side, exactly touching
        poses[6, i, 0] = edge + asset.size[0] / 2
        edge += asset.size[0]
    poses[7, :, :2] = scene.room.walls[0].point(scene.room.walls[0].length / 2, scene.assets[0].size[0] / 2)
    poses[8:, :, 0] = 1e4 * np.arange(STARTS - 8)[:, None]  # far away
    return poses


@each
@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_value_and_gradient_are_finite_at_awkward_points(name: str, kind: type) -> None:
    for variant in VARIANTS:
        found = case(name, variant)
        for parts in (STATED, PARTS):
            value, gradient = measure(awkward(found.scene), found.arrays, parts, kind)
            assert np.isfinite(value).all()
            assert np.isfinite(gradient).all(), found.relation.sentence()
        for poses in awkward(found.scene):
            assert math.isfinite(found.relation.check(found.scene, found.layout(poses)).value)


@each
def test_its_words_explain_it(name: str) -> None:
    relation = RELATIONS[name]
    meaning = relation.meaning()
    assert relation.name == name
    assert meaning[0] in "`TAE" and meaning.endswith("."), "the first line of the docstring is a sentence"
    for field in relation.arguments():
        assert f"`{field.name}`" in meaning, f"{name} does not explain {field.name}"
    assert relation.check.__doc__, "the docstring of check states the tolerance"
    if relation.__module__.startswith("robolayout."):
        assert relation.__module__ == f"robolayout.constraints.{name}"


@each
def test_its_example_can_be_read_and_written(name: str) -> None:
    scene = scene_of(RELATIONS[name].example, np.random.default_rng(0))
    program = read_program(RELATIONS[name].example, scene)
    (statement,) = program.statements
    assert type(statement.relation) is RELATIONS[name]
    assert set(statement.relation.asset_names()) <= set(scene.by_name)
    assert read_program(program.to_text(), scene).statements[0].relation == statement.relation
    assert statement.relation.sentence().startswith(f"{name}(")


JUDGED: dict[str, Callable[[Physics], bool]] = {
    "overlap": lambda found: not found.collisions,
    "inside": lambda found: all(found.in_boundary.values()),
    "clear": lambda found: found.door_clear,
}
"""What the judge says of each part that belongs to every program."""

by_room = pytest.mark.parametrize("room", list(ROOMS))


def implicit_case(room: str) -> Case:
    """Return some furniture in a room, with the terms of what belongs to every program and no statement."""
    rng = np.random.default_rng(len(room))
    scene = scene_of("f(sofa[0], desk[0], rug[0], floor_lamp[0], bed[0])", rng, room)
    problem = flat_problem(scene)
    arrays = make_stage(problem, 0, problem.start).arrays
    arrays = arrays._replace(inside=arrays.free[:, 0])  # in a rectangle the projection alone holds them
    random = anywhere(scene, rng)
    nothing = RELATIONS["any_of"](())
    return Case(scene, nothing, problem.guess, arrays, random, random)


@by_room
@pytest.mark.parametrize("part", JUDGED)
def test_what_is_implicit_obeys_the_same_laws(part: str, room: str) -> None:
    found = implicit_case(room)
    count = len(found.scene.assets)
    _, gradient = measure(found.random, found.arrays, (part,))
    for k in (0, 1):
        expected = differences(found.random[k], found.arrays, (part,), count)
        assert gradient[k, :count, :2] == pytest.approx(expected[:, :2], rel=1e-4, abs=1e-6)
        assert not gradient[k, :count, 2].any(), (
            "headings follow the statements: what is implicit moves things and does not turn them"
        )
    calm = descend(found.random, found.arrays, part, steps=60)
    assert (measure(calm, found.arrays, (part,))[0] < 1e-9).any()
    for poses in (calm, found.random):
        values, _ = measure(poses, found.arrays, (part,))
        for value, start in zip(values, poses, strict=True):
            met = JUDGED[part](physics(found.scene, found.layout(start)))
            assert met or value > 0.0, "the terms miss what the judge sees"
            assert value < 0.05 or not met, "the terms see what the judge does not"


def test_one_asset_and_no_statements_have_finite_terms() -> None:
    room = Room(((0, 0), (3, 0), (0, 3)), 2.5)
    scene = Scene(room, (Asset("chair-0", "chair", (0.5, 0.5, 0.9)),))
    value, gradient = measure(awkward(scene), stage_arrays(flat_problem(scene)), PARTS)
    assert np.isfinite(value).all() and np.isfinite(gradient).all()
    assert not stage_arrays(flat_problem(scene)).frame_row[:, -1].any()


@pytest.mark.slow
def test_one_hundred_and_twenty_assets_have_finite_terms() -> None:
    room = Room(((0, 0), (20, 0), (20, 20), (0, 20)), 3.0)
    shelves = tuple(Asset(f"shelf-{i}", "shelving unit", (0.4, 0.9, 1.8)) for i in range(120))
    scene = Scene(room, shelves)
    row = read_program("solver.row(shelf, walls[0], gap=0.1)\nsolver.grid(shelf, 10, 12)", scene)
    problem = flat_problem(scene, *(statement.relation for statement in row.statements))
    arrays = stage_arrays(problem)
    poses = np.random.default_rng(0).uniform(0, 20, (2, arrays.half.shape[0], 3))
    poses[1] = poses[1, :1]
    value, gradient = measure(poses, arrays, PARTS, np.float32)
    assert np.isfinite(value).all() and np.isfinite(gradient).all()


def test_the_generator_reaches_every_kind_of_argument() -> None:
    sentences = " ".join(case(name, variant).relation.sentence() for name in RELATIONS for variant in VARIANTS)
    for word in ("walls[", "angle=", "[(", "-0, (", "min_gap="):
        assert word in sentences, f"no case with {word}"


def test_a_program_of_all_statements_is_written_and_read_back() -> None:
    found = case("distance_constraint", 1)
    rng = np.random.default_rng(1)
    relations = [vary(found.relation, found.scene, rng) for _ in range(20)]
    program = Program(statements=tuple(Statement(relation) for relation in relations))
    back = read_program(program.to_text(), found.scene)
    assert [statement.relation for statement in back.statements] == relations


def test_a_check_of_something_else_breaks_the_law() -> None:
    found = case("left_of", 0)
    swapped = RELATIONS["right_of"](*(getattr(found.relation, f.name) for f in found.relation.arguments()))
    residual, _ = measure(found.satisfied, found.arrays)
    assert not any(swapped.check(found.scene, found.layout(p)).met for p in found.satisfied[residual < ZERO])
