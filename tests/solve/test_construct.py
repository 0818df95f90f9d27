"""Starts that are built one thing after the other."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely import Point, Polygon
from solve_rooms import BED, STANDS, TABLE, problem_of, room_of

from robolayout.scene import Asset, Opening, Room
from robolayout.solve import Problem
from robolayout.solve.construct import Builder
from robolayout.solve.stage import make_stage
from robolayout.verify import navigation, physics

SHELVES = tuple(Asset(f"bookshelf-{i}", "bookshelf", (0.35, 1.0, 1.9)) for i in range(8))


def shared(problem: Problem, world: np.ndarray) -> float:
    """Return the floor that things share, in square metres."""
    layout = problem.layout(world)
    shapes = [Polygon(layout[a.name].corners(a.size)) for a in problem.scene.assets]
    return sum(a.intersection(b).area for i, a in enumerate(shapes) for b in shapes[:i])


def crowded() -> Problem:
    return problem_of(room_of(BED, TABLE, *SHELVES, room=Room(((0, 0), (5, 0), (5, 4), (0, 4)), 2.6)), seed=5)


def test_built_rooms_overlap_far_less_than_blind_ones() -> None:
    problem = crowded()
    builder = Builder(make_stage(problem, 0, problem.start), np.random.default_rng(0))
    heap = problem.start.copy()
    heap[:, :2] = np.random.default_rng(1).uniform((0.5, 0.5), (4.5, 3.5), (len(heap), 2))
    built = [shared(problem, builder.build(heap)) for _ in range(8)]
    assert max(built) < 0.2 * shared(problem, heap)


def test_what_is_not_asked_for_stays_bit_for_bit() -> None:
    problem = crowded()
    built = Builder(make_stage(problem, 0, problem.start), np.random.default_rng(0)).build(problem.start, {3, 4})
    same = (built == problem.start).all(axis=1)
    assert same[[0, 1, 2, 5, 6, 7, 8, 9]].all()
    assert not same[[3, 4]].all()


def test_what_stands_on_a_thing_moves_with_it() -> None:
    lamp = Asset("lamp-0", "table lamp", (0.2, 0.2, 0.4), on_floor=False, on_object=True)
    problem = problem_of(room_of(STANDS[0], lamp), "solver.on_top_of(lamp[0], night_stand[0])")
    world = problem.start.copy()
    world[1, :2] = world[0, :2]
    built = Builder(make_stage(problem, 0, problem.start), np.random.default_rng(0)).build(world)
    assert np.allclose(built[0, :2], built[1, :2])


def test_things_used_from_the_front_stand_with_their_backs_to_walls() -> None:
    problem = problem_of(room_of(*SHELVES[:2]), seed=1)
    built = Builder(make_stage(problem, 0, problem.start), np.random.default_rng(0)).build(problem.start)
    layout = problem.layout(built)
    outline = Polygon(problem.scene.room.vertices).exterior
    for asset in problem.scene.assets:
        pose = layout[asset.name]
        back = Point(pose.x - 0.175 * math.cos(pose.yaw), pose.y - 0.175 * math.sin(pose.yaw))
        assert outline.distance(back) < 0.05


def test_a_thing_leaves_room_to_what_goes_by_it() -> None:
    text = """
solver.against_wall(bed[0], walls[2])
solver.symmetric_pair(night_stand[0], night_stand[1], bed[0])
solver.next_to(night_stand[0], bed[0], "left")
"""
    problem = problem_of(room_of(BED, *STANDS), text, seed=6)
    builder = Builder(make_stage(problem, 0, problem.start), np.random.default_rng(0))
    layouts = [problem.layout(builder.build(problem.start)) for _ in range(8)]
    beside = [problem.relations[2].check(problem.scene, layout).met for layout in layouts]
    assert sum(beside) >= 7, "the bed stands where its night stand finds a place"
    twins = [problem.relations[1].check(problem.scene, layout).value for layout in layouts]
    assert sum(value < 0.6 for value in twins) >= 7, "and its twin one on the other side"


def test_the_same_seed_builds_the_same_room() -> None:
    problem = crowded()
    first, second = (
        Builder(make_stage(problem, 0, problem.start), np.random.default_rng(7)).build(problem.start) for _ in "ab"
    )
    assert first.tobytes() == second.tobytes()


def test_what_goes_by_a_thing_is_placed_right_after_it() -> None:
    text = "solver.distance_constraint(chair[0], table[0], 0.6, 0.9)\nsolver.against_wall(wardrobe[0], walls[1])\n"
    chair, wardrobe = Asset("chair-0", "chair", (0.5, 0.5, 0.9)), Asset("wardrobe-0", "wardrobe", (0.6, 1.6, 2.1))
    problem = problem_of(room_of(BED, TABLE, chair, wardrobe), text)
    builder = Builder(make_stage(problem, 0, problem.start), np.random.default_rng(0))
    assert builder._in_turn([3, 0, 1, 2]) == [3, 0, 1, 2]
    assert builder._in_turn([1, 0, 3, 2]) == [1, 2, 0, 3], "the chair gets its place before the bed takes it"
    assert builder._in_turn([2, 3]) == [2, 3], "nobody waits for what stays where it is"


@pytest.mark.slow
def test_rooms_45_percent_full_are_built_without_an_overlap() -> None:
    built = [(problem, one) for problem in map(half_full, range(4)) for one in builds(problem, 4)]
    layouts = [(problem.scene, problem.layout(one)) for problem, one in built]
    right = [not physics(scene, layout).failing for scene, layout in layouts]
    assert all(right)
    reached = [navigation(scene, layout).reachable_share for scene, layout in layouts]
    assert np.mean(reached) > 0.95


def half_full(seed: int) -> Problem:
    """Return a room of 15 cupboards and boxes that take 45 % of its floor."""
    rng = np.random.default_rng(seed)
    kinds = (("cabinet", 0.4, 0.8, 0.9), ("storage box", 0.4, 0.6, 0.4), ("armchair", 0.8, 0.75, 0.85))
    things = [
        Asset(f"{kind.replace(' ', '_')}-{i}", kind, (d * scale, w * scale, h))
        for i, ((kind, d, w, h), scale) in enumerate(zip(kinds * 5, rng.uniform(0.85, 1.15, 15), strict=True))
    ]
    side = math.sqrt(sum(a.size[0] * a.size[1] for a in things) / 0.45)
    room = Room(((0, 0), (side, 0), (side, side), (0, side)), 2.6, doors=(Opening(0, 0.3, 0.9, 2.05),))
    return problem_of(room_of(*things, room=room), seed=seed)


def builds(problem: Problem, count: int) -> list[np.ndarray]:
    builder = Builder(make_stage(problem, 0, problem.start), np.random.default_rng(1))
    return [builder.build(problem.start) for _ in range(count)]
