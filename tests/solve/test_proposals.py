"""Places that are drawn for things: inside the room, and where their statements want them."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely import Point, Polygon
from solve_rooms import BED, L_SHAPED, LAMP, SQUARE, STANDS, TABLE, TRIANGLE, problem_of, room_of, scattered

from robolayout.constraints import FAR, FrameTerm, WallRef
from robolayout.scene import Asset, Room
from robolayout.solve import Problem
from robolayout.solve.construct import Builder
from robolayout.solve.proposals import Proposals, frame_of
from robolayout.solve.stage import make_stage, relative

ROOMS = pytest.mark.parametrize("room", [SQUARE, L_SHAPED, TRIANGLE], ids=["square", "L", "triangle"])
CHAIRS = tuple(Asset(f"chair-{i}", "chair", (0.5, 0.5, 0.9)) for i in range(3))

STATEMENTS = [
    "against_wall(bed[0], walls[1])",
    "next_to(bed[0], table[0])",
    'next_to(bed[0], table[0], "front", 0.2)',
    "in_front_of(bed[0], table[0], 0.3, 0.6)",
    "behind(bed[0], table[0])",
    "left_of(bed[0], table[0])",
    "right_of(bed[0], table[0])",
    "distance_constraint(bed[0], table[0], 1.0, 1.5)",
    "distance_constraint(bed[0], [2, 2], 0.5, None)",
    "distance_constraint(bed[0], walls[0], 1.0, 1.2)",
    "distance_constraint(bed[0], walls[2], 1.0, 1.2)",
    "corner(bed[0])",
    "centered_on(bed[0])",
    "centered_on(bed[0], walls[1])",
    "align_with(bed[0], table[0], 90)",
    "zone(bed[0], [(0, 0), (4, 0), (4, 4), (0, 4)])",
    "around([bed[0]], table[0])",
]


def every_kind(problem: Problem, world: np.ndarray, moving: tuple[int, ...], count: int) -> np.ndarray:
    """Return starts: half of them near the guess, half built."""
    builder = Builder(make_stage(problem, 0, problem.start), np.random.default_rng(0))
    built = np.array([builder.build(world, moving) for _ in range(count // 2)])
    builder.proposals.bring_in(built, moving)
    return np.concatenate([builder.proposals.near(world, moving, count // 2, builder.rng), built])


@ROOMS
def test_every_start_is_inside_the_room(room: Room) -> None:
    """DESIGN section 11: random feasible placement."""
    problem = problem_of(room_of(BED, TABLE, *CHAIRS, room=room), "solver.next_to(bed[0], table[0])", seed=3)
    starts = every_kind(problem, problem.start, (0, 1, 2, 3, 4), 32)
    floor = Polygon(room.vertices).buffer(1e-9)
    assert all(floor.covers(Point(x, y)) for x, y in starts[:, :, :2].reshape(-1, 2))
    assert np.hypot(starts[..., 2], starts[..., 3]) == pytest.approx(1.0)


def test_the_first_start_is_the_guess() -> None:
    problem = problem_of(room_of(BED, TABLE), "bed[0].position = [1.5, 2, 0.25]")
    world = problem.start.copy()
    world[1, :2] = 1.0, 3.0
    starts = every_kind(problem, world, (0, 1), 8)
    assert (starts[0] == world).all()
    assert len({start.tobytes() for start in starts}) == 8


def test_what_does_not_move_stays_in_every_start() -> None:
    problem = problem_of(room_of(BED, TABLE))
    starts = every_kind(problem, problem.start, (1,), 8)
    assert (starts[:, 0] == problem.start[0]).all()


def missed(problem: Problem, term: FrameTerm, world: np.ndarray) -> float:
    """Return by how many metres a row's place is missed, from its definition (DESIGN section 4), without the solver."""
    frame = frame_of(problem, term.b, world)
    slot = problem.slot[term.a.name]
    u, v, c, s = relative(frame, world[slot])
    hx, hy = problem.half[slot]
    eu, ev = abs(c) * hx + abs(s) * hy, abs(s) * hx + abs(c) * hy
    v = abs(v) if term.fold else v
    core = problem.scene.room.walls[term.b.index].length / 2 if isinstance(term.b, WallRef) else 0.0
    away = math.hypot(max(abs(u) - core, 0.0), v)
    return max(
        term.along.low - (u - term.along.low_extent * eu),
        u + term.along.high_extent * eu - term.along.high,
        term.across.low - (v - term.across.low_extent * ev),
        v + term.across.high_extent * ev - term.across.high,
        term.distance[0] - away,
        away - term.distance[1],
    )


@pytest.mark.parametrize("text", STATEMENTS)
def test_a_draw_satisfies_the_row_that_it_is_drawn_from(text: str) -> None:
    large = Room(((0, 0), (9, 0), (9, 8), (7, 8), (7, 6), (0, 6)), 2.4)
    problem = problem_of(room_of(BED, TABLE, room=large), f"solver.{text}")
    rng = np.random.default_rng(1)
    proposals = Proposals(problem)
    assert proposals.frames[0]
    for _ in range(40):
        world = scattered(problem, rng)
        for term in proposals.frames[0]:
            world[0] = proposals.placed(0, term, world, 1, rng)[0]
            assert missed(problem, term, world) < 1e-9
            if term.heading is not None:
                frame = frame_of(problem, term.b, world)
                _, _, c, s = relative(frame, world[0])
                assert (c, s) == pytest.approx((math.cos(term.heading), math.sin(term.heading)), abs=1e-9)


def test_draws_for_a_statement_satisfy_it_far_more_often_than_chance() -> None:
    scene = room_of(BED, TABLE, room=Room(((0, 0), (9, 0), (9, 8), (0, 8)), 2.4))
    problem = problem_of(scene, "solver.against_wall(bed[0], walls[1])")
    rng = np.random.default_rng(0)
    (relation,) = problem.relations
    world = scattered(problem, rng)
    drawn = Proposals(problem).draw(0, world, 200, rng)
    met = 0
    for pose in drawn:
        world[0] = pose
        met += relation.check(scene, problem.layout(world)).met
    assert met > 80


def test_a_twin_is_proposed_at_the_mirror_image() -> None:
    text = "solver.symmetric_pair(night_stand[0], night_stand[1], bed[0])"
    problem = problem_of(room_of(BED, *STANDS), text)
    rng = np.random.default_rng(2)
    world = scattered(problem, rng)
    proposals = Proposals(problem)
    (row,) = proposals.mirrors[1]
    world[1] = proposals.image(row, 1, world)
    outcome = problem.relations[0].check(problem.scene, problem.layout(world))
    assert outcome.value < 1e-9
    about_wall = problem_of(room_of(BED, *STANDS), "solver.symmetric_pair(night_stand[0], night_stand[1], walls[2])")
    proposals = Proposals(about_wall)
    world[1] = proposals.image(proposals.mirrors[1][0], 1, world)
    assert about_wall.relations[0].check(about_wall.scene, about_wall.layout(world)).value < 1e-9


def test_a_child_is_proposed_on_its_top() -> None:
    problem = problem_of(room_of(TABLE, LAMP), "solver.on_top_of(lamp[0], table[0])")
    rng = np.random.default_rng(0)
    world = scattered(problem, rng)
    for _ in range(50):
        world[1] = Proposals(problem)._anywhere(1, world, 1, rng)[0]
        assert problem.relations[0].check(problem.scene, problem.layout(world)).met


def test_open_ends_do_not_reach_beyond_the_room() -> None:
    problem = problem_of(room_of(BED, TABLE), "solver.distance_constraint(bed[0], table[0], 1.0, None)")
    drawn = Proposals(problem).draw(0, problem.start, 100, np.random.default_rng(0))
    assert np.abs(drawn[:, :2]).max() < 12 < FAR
