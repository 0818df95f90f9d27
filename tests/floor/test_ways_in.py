"""By which cells bodies come in, which region of the floor a door leads to, and that every door is one to get to."""

from __future__ import annotations

import math

import numpy as np
import pytest

from robolayout._grid import components
from robolayout.floor import RoomContents, make_ground, plan_routes
from robolayout.floor.cells import cells_of, entered, entries
from robolayout.floor.furnished import Floor
from robolayout.floor.standing import standing
from robolayout.scene import Agent, Asset, Opening, Room, Scene, load_agent

DOORS = (Opening(0, 0.6, 0.9, 2.05), Opening(2, 0.6, 0.9, 2.05))
ROOM = Room(((0, 0), (5, 0), (5, 4), (0, 4)), 2.5, doors=DOORS)
BOX = Asset("box-0", "box", (0.9, 0.9, 0.8))
DISC = Agent("disc", radius=0.3, height=1.5, reach_distance=0.7)


def ground_of(room: Room, agent: Agent = DISC):
    scene = Scene(room, (BOX,), agents=(agent,))
    contents = RoomContents(scene, (-1,), np.array([0.4]), np.array([[0.45, 0.45]]))
    return make_ground(contents, agent, 0.05)


@pytest.mark.parametrize("radius", [0.2, 0.45, 0.9])
def test_a_body_comes_in_by_the_free_cell_nearest_to_the_middle_of_each_landing(radius: float) -> None:
    xs, ys, _ = cells_of(ROOM, 0.05, 10_000)
    x, y = np.meshgrid(xs, ys, indexing="ij")
    free = (x > radius) & (x < 5 - radius) & (y > radius) & (y < 4 - radius)
    found = entries(ROOM, xs, ys, free)
    assert len(found) == len(DOORS)
    for (i, j), door in zip(found.tolist(), DOORS, strict=True):
        middle = np.mean(ROOM.landing(door), axis=0)
        assert free[i, j]
        assert math.dist((xs[i], ys[j]), middle) == pytest.approx(np.hypot(x - middle[0], y - middle[1])[free].min())
    assert not len(entries(ROOM, xs, ys, np.zeros_like(free)))


@pytest.mark.parametrize("most", [100, 3_000, 10**6])
def test_cells_fill_the_room_and_are_no_more_than_allowed(most: int) -> None:
    xs, ys, cell = cells_of(ROOM, 0.05, most)
    assert cell >= 0.05
    assert len(xs) * len(ys) <= 1.2 * most
    assert 0 < xs[0] < cell and 5 - cell <= xs[-1] < 5 and 0 < ys[0] < cell and 4 - cell <= ys[-1] < 4


def test_the_landing_decides_which_region_is_entered() -> None:
    mask, landing = np.ones((6, 9), np.bool_), np.zeros((6, 9), np.bool_)
    mask[:, 3] = False
    landing[:2, :5] = True  # three columns of the smaller region, one of the larger
    labels, sizes = components(mask)
    assert sizes.tolist() == [18, 30]
    assert entered(labels, sizes, landing) == 1
    assert entered(labels, sizes, None) == 2, "without a door the largest counts"
    assert entered(labels, sizes, np.zeros_like(landing)) == 0
    assert entered(*components(np.zeros_like(mask)), None) == 0


def test_every_door_is_one_to_get_to() -> None:
    ground = ground_of(ROOM)
    away, before_the_second = np.array([[4.0, 2.0, 1.0, 0.0]]), np.array([[3.95, 3.55, 1.0, 0.0]])
    assert plan_routes(ground, away).blocked == 0
    shut = plan_routes(ground, before_the_second)
    assert (shut.blocked, {*shut.demands[:, 2]}) == (1, {0})
    assert ground.doors.shape == (2, 2) and ground.start == tuple(ground.doors[0].tolist())


def test_without_a_door_bodies_start_where_there_is_most_room() -> None:
    ground = ground_of(Room(((0, 0), (5, 0), (5, 4), (0, 4)), 2.5))
    assert ground.start is not None
    assert ground.wall_distance[ground.start] == ground.wall_distance.max()
    nowhere = ground_of(ROOM, Agent("giant", radius=2.5, height=2.0))
    assert nowhere.start is None and not plan_routes(nowhere, np.array([[4.0, 2.0, 1.0, 0.0]])).blocked


@pytest.mark.parametrize("name", ["turtlebot4", "wheelchair", "forklift"])
def test_every_body_gets_into_an_empty_hall(name: str) -> None:
    """A forklift cannot stand in a landing of 0.9 m: it was thought cut off from every room."""
    hall = Room(((0, 0), (16, 0), (16, 12), (0, 12)), 4.0, doors=(Opening(0, 0.3, 3.0, 2.3),))
    body = load_agent(name)
    assert standing(Floor.of(hall, 1.0, body.radius), body).cut_off == 0.0
