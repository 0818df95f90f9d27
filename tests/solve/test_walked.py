"""The floor that is left to walk on while a room is built, against a flood from every cell and a look at every place."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import ndimage

from robolayout.floor import FLOOR, Walked
from robolayout.scene import Opening, Room

RADIUS = 0.2
GRID, MOST_CELLS, CUT, LOST = FLOOR.walked_cell, FLOOR.walked_cells, FLOOR.cut, FLOOR.lost
SQUARE = Room(((0, 0), (4, 0), (4, 3), (0, 3)), 2.5, doors=(Opening(0, 1.0, 0.9, 2.05),))
AXIS, SIDE = (st.integers(low, high).map(lambda k: 0.02 * k + 0.003) for low, high in ((0, 150), (5, 100)))
RECTS = st.lists(st.tuples(AXIS, AXIS, SIDE, SIDE), min_size=1, max_size=6)
"""No edge of a rectangle, grown or not, runs through the middle of a cell."""


def bounds(rects: list[tuple[float, float, float, float]]) -> np.ndarray:
    return np.array([(x, y, x + a, y + b) for x, y, a, b in rects])


def free(rects: np.ndarray) -> np.ndarray:
    """Return whether the middle of each cell is free for a disc, corners of what is in its way left square."""
    x, y = np.meshgrid(np.arange(GRID / 2, 4, GRID), np.arange(GRID / 2, 3, GRID), indexing="ij")
    found = (x > RADIUS) & (x < 4 - RADIUS) & (y > RADIUS) & (y < 3 - RADIUS)
    for x0, y0, x1, y1 in rects + np.array((-RADIUS, -RADIUS, RADIUS, RADIUS)):
        found &= ~((x >= x0) & (x <= x1) & (y >= y0) & (y <= y1))
    return found


def main(cells: np.ndarray) -> np.ndarray:
    """Return the piece that holds the cell where people come in, or the largest."""
    labels, count = ndimage.label(cells, np.ones((3, 3)))
    if not count:
        return cells
    everywhere = np.argwhere(free(np.empty((0, 4))))
    entry = everywhere[
        np.hypot(*((everywhere + 0.5) * GRID - np.mean(SQUARE.landing(SQUARE.doors[0]), axis=0)).T).argmin()
    ]
    here = labels[tuple(entry)] or np.bincount(labels[labels > 0]).argmax()
    return labels == here


def filled(rects: np.ndarray) -> Walked:
    walked = Walked(SQUARE, RADIUS)
    walked.take(walked.taken(rects))
    return walked


@given(RECTS)
@settings(max_examples=150, deadline=None)
def test_what_is_left_is_the_piece_behind_the_door(rects: list[tuple[float, float, float, float]]) -> None:
    taken = bounds(rects)
    one_by_one = Walked(SQUARE, RADIUS)
    one_by_one.take(one_by_one.taken(np.empty((0, 4))))
    for rect in taken:
        one_by_one.take(one_by_one.taken(rect[None]))
    expected = main(free(taken))
    assert (filled(taken)._free[1:-1, 1:-1] == expected).all()
    entry = tuple(one_by_one._entries[0] - 1)
    if expected[entry]:  # else it matters which piece was the largest when the door was shut
        assert (one_by_one._free[1:-1, 1:-1] == expected).all()


@given(RECTS)
@settings(max_examples=150, deadline=None)
def test_the_loss_of_a_place_is_what_a_flood_finds(rects: list[tuple[float, float, float, float]]) -> None:
    taken = bounds(rects)
    walked, before = filled(taken[1:]), main(free(taken[1:]))
    near = walked.cells(taken[1:] + np.array((-0.6, -0.6, 0.6, 0.6)))
    place = walked.taken(taken[:1])[0]
    rest = before & free(taken[:1])
    after = main(rest)
    reached = [
        (before[a - 1 : c - 1, b - 1 : d - 1].any(), after[a - 1 : c - 1, b - 1 : d - 1].any()) for a, b, c, d in near
    ]
    out = sum(was and not is_now for was, is_now in reached)
    ex, ey = walked._entries[0]
    shut = place[0] <= ex < place[2] and place[1] <= ey < place[3]
    cut_off = 1.0 - after.sum() / max(rest.sum(), 1) if rest.any() else 0.0
    expected = CUT * (shut + cut_off) + LOST * out
    near = near[[was for was, _ in reached]] if reached else near
    assert walked._loss(place, near) == pytest.approx(expected, abs=1e-9)


def test_the_cheapest_place_is_not_the_one_that_shuts_the_room() -> None:
    walked = Walked(SQUARE, RADIUS)
    across, aside = np.array([[0.0, 1.2, 4.0, 1.5], [3.0, 2.0, 4.0, 3.0]])
    shelf = walked.cells(np.array([[0.0, 1.6, 1.0, 3.0]]))
    cells, cost = walked.taken(np.array([across, aside])), np.array([0.0, 1.0])
    assert walked.cheapest(cells, cost, shelf, np.inf) == 1
    assert cost[0] == pytest.approx(LOST + CUT * 0.5, abs=CUT * 0.15), (
        "the shelf is out of reach, and about half of the floor"
    )
    assert walked.cheapest(cells, np.array([5.0, 6.0]), shelf, 2.0) == 0, "nobody looks at what is too dear anyway"


def test_a_hall_has_no_more_cells_than_a_large_room() -> None:
    hall = Room(((0, 0), (300, 0), (300, 200), (0, 200)), 8.0, doors=(Opening(0, 100.0, 4.0, 4.0),))
    walked = Walked(hall, RADIUS)
    assert walked._free.size < 1.05 * MOST_CELLS
    walked.take(walked.taken(np.array([[0.0, 60.0, 300.0, 70.0]])))
    assert walked._free.sum() == pytest.approx(0.3 * MOST_CELLS, rel=0.05), "only the part with the door is left"
