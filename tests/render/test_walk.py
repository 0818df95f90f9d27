"""The agent on its round: it goes everywhere, cuts corners only across free space, and keeps clear of things."""

import math
from itertools import pairwise

import numpy as np
import pytest
import shapely
from film_frames import frames

from robolayout._errors import InputError
from robolayout.render import PlanMarks, walk_gif
from robolayout.render import walk as film
from robolayout.render._tour import SLACK, tour
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
    assert sorted(name for leg in legs for name in leg.names) == sorted(ROUTES)
    assert [leg.names for leg in legs if "b-0" in leg.names] == [("b-0", "b-1")]
    assert legs[0].line[0] == legs[-1].line[-1] == (3.0, 0.2)
    assert legs[-1].names == ()
    for one, other in pairwise(legs):
        assert math.dist(one.line[-1], other.line[0]) < 1e-9


def test_a_round_stays_in_the_free_space_and_is_short():
    free = shapely.Polygon(SQUARE, [BLOCK])
    legs = tour(ROUTES, [(SQUARE, BLOCK)])
    for leg in legs:
        assert free.buffer(2 * SLACK).covers(shapely.LineString(leg.line))
    there_and_back = 2 * sum(shapely.LineString(line).length for line in ROUTES.values())
    assert sum(leg.length for leg in legs) < 0.7 * there_and_back
    near = next(leg for leg in legs if leg.names in (("a-0",), ("c-0",)) and leg.line[0] != (3.0, 0.2))
    assert near.length == pytest.approx(math.dist((1.0, 3.5), (0.5, 2.0)), abs=0.01)


def test_without_free_space_a_round_goes_back_to_the_door():
    legs = tour({"a-0": ROUTES["a-0"], "b-0": ROUTES["b-0"]}, [])
    assert (3.0, 0.2) in legs[1].line


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


def test_a_long_body_turns_only_where_it_has_room(bedroom, layout):
    body = Agent("long", 0.4, 1.0, length=1.6, width=0.5)
    places = np.array([(3.0, y) for y in np.linspace(1.0, 4.2, 20)])
    beside = np.array([(2.75, 2.6)])
    headings = film._headings(bedroom, layout, body, places)
    assert all(abs(math.sin(a)) > 0.9 for a in headings[2:-2]), "ahead, along the way"
    lattice = 2 * math.pi * np.arange(film.HEADINGS) / film.HEADINGS
    touches = film._touches(bedroom, layout, body, beside, lattice)[0]
    assert touches[0] and not touches[4], "between bed and wardrobe it fits lengthwise only"


def test_without_routes_there_is_no_walk(bedroom):
    with pytest.raises(InputError, match="walk_gif has nothing to show"):
        walk_gif(bedroom, Layout({}), PlanMarks())
