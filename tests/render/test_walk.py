"""The agent on its round: it goes everywhere, cuts corners only across free space, and keeps clear of things."""

import math
from itertools import pairwise

import numpy as np
import pytest
import shapely
from film_frames import frames

from robolayout._errors import InputError
from robolayout.render import PlanMarks, walk_gif
from robolayout.render._style import FILM
from robolayout.render.animation import tour
from robolayout.scene import Agent, Layout

SQUARE = ((0.0, 0.0), (6.0, 0.0), (6.0, 4.0), (0.0, 4.0))
BLOCK = ((2.0, 1.0), (4.0, 1.0), (4.0, 4.0), (2.0, 4.0))
ROUTES = {
    "a-0": ((3.0, 0.2), (1.8, 0.9), (1.0, 3.5)),
    "b-0": ((3.0, 0.2), (4.2, 0.9), (5.0, 3.5)),
    "b-1": ((3.0, 0.2), (4.2, 0.9), (5.1, 3.4)),
    "c-0": ((3.0, 0.2), (1.8, 0.9), (0.5, 2.0)),
}


def test_a_round_visits_everything_once_and_comes_back():
    legs = tour(ROUTES, [(SQUARE, BLOCK)])
    assert not any(leg.line[:, 2].any() for leg in legs)
    assert sorted(name for leg in legs for name in leg.names) == sorted(ROUTES)
    assert [leg.names for leg in legs if "b-0" in leg.names] == [("b-0", "b-1")]
    assert legs[0].line[0].tolist() == legs[-1].line[-1].tolist() == [3.0, 0.2, 0.0]
    assert legs[-1].names == ()
    for one, other in pairwise(legs):
        assert math.dist(one.line[-1], other.line[0]) < 1e-9


def test_a_round_stays_in_the_free_space_and_is_short():
    free = shapely.Polygon(SQUARE, [BLOCK])
    legs = tour(ROUTES, [(SQUARE, BLOCK)])
    for leg in legs:
        assert free.buffer(2 * FILM.slack).covers(shapely.LineString(leg.line[:, :2]))
    there_and_back = 2 * sum(shapely.LineString(line).length for line in ROUTES.values())
    assert sum(leg.length for leg in legs) < 0.7 * there_and_back
    near = next(leg for leg in legs if leg.names in (("a-0",), ("c-0",)) and leg.line[0, 0] != 3.0)
    assert near.length == pytest.approx(math.dist((1.0, 3.5), (0.5, 2.0)), abs=0.01)


def test_without_free_space_a_round_goes_back_to_the_door():
    legs = tour({"a-0": ROUTES["a-0"], "b-0": ROUTES["b-0"]}, [])
    assert [3.0, 0.2, 0.0] in legs[1].line.tolist()


def test_a_body_with_a_heading_goes_back_to_where_its_ways_part():
    trunk = [(3.0, 0.2, 1.5), (3.0, 2.0, 1.5)]
    ways = {"a-0": [*trunk, (3.0, 2.0, 3.0), (1.0, 2.0, 3.0)], "b-0": [*trunk, (3.0, 2.0, 0.0), (5.0, 2.0, 0.0)]}
    _, across, back = tour(ways, ())
    assert across.line[:, 1].min() == pytest.approx(2.0)
    assert set(np.round(across.line[:, 2], 6)) >= {3.0, 1.5, 0.0}
    for leg in (across, back):
        still = np.hypot(*np.diff(leg.line[:, :2], axis=0).T) < 1e-9
        assert (still | (np.diff(leg.line[:, 2]) == 0)).all(), "it moves or turns, never both"


@pytest.mark.parametrize("body", [None, Agent("long", 0.4, 1.0, length=0.8, width=0.4)])
def test_the_agent_moves_on_its_round(bedroom, layout, marks, body):
    data = walk_gif(bedroom, layout, marks, agent=body, size=240)
    shown = frames(data)
    assert 6 <= len(shown) <= 120
    assert len(data) < 2_000_000
    assert max(np.abs(a - b).mean() for (a, _), (b, _) in pairwise(shown)) > 0.2
    assert shown[-1][1] > shown[0][1], "the end is held"
    assert data == walk_gif(bedroom, layout, marks, agent=body, size=240)


def test_few_frames_are_enough(bedroom, layout, marks):
    assert len(frames(walk_gif(bedroom, layout, marks, size=240, frames=5))) <= 5


def test_without_routes_there_is_no_walk(bedroom):
    with pytest.raises(InputError, match="walk_gif has nothing to show"):
        walk_gif(bedroom, Layout({}), PlanMarks())
