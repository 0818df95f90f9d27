"""Moves of a body that cannot slide: where what they sweep meets a thing, against shapely's own answer."""

import math
from itertools import product

import numpy as np
import pytest
import shapely
from shapely.affinity import translate

import robolayout as rl
from robolayout.verify import driving, judge_agent


@pytest.mark.parametrize("name", ["wheelchair", "forklift"])
@pytest.mark.parametrize("yaw", [0.0, 0.4, math.pi / 4])
def test_moves_are_barred_where_what_they_sweep_meets_a_thing(name: str, yaw: float):
    agent, cell, heading = rl.load_agent(name), 0.1, 0.3
    sweeps = driving._swept(agent, heading, cell)
    grid = driving._Grid((0.05, -0.02), heading, cell, (-30, -30), (60, 60))
    c, s = math.cos(yaw), math.sin(yaw)
    ring = np.array([(0.5, -0.3), (0.5, 0.3), (-0.5, 0.3), (-0.5, -0.3)]) @ np.array([(c, s), (-s, c)])
    met = np.zeros((len(sweeps.shapes), len(grid.places)), bool)
    met.flat[driving._met(grid, sweeps, ring.tobytes())] = True
    thing, rng = shapely.Polygon(ring), np.random.default_rng(0)
    both = list[bool]()
    for place in rng.choice(len(grid.places), 60, replace=False):
        for number, shape in enumerate(sweeps.shapes):
            gap = thing.distance(translate(shapely.Polygon(shape), *grid.places[place]))
            both.append(gap == 0.0)
            if not 0.0 < gap < 1e-9:
                assert met[number, place] == (gap == 0.0)
    assert any(both) and not all(both)


def test_a_move_and_its_way_back_sweep_one_shape():
    sweeps = driving._swept(rl.load_agent("forklift"), 0.0, 0.1)
    every = [number for numbers in sweeps.of for number, _ in numbers]
    assert sorted(set(every)) == list(range(len(sweeps.shapes)))
    assert len(every) == 2 * len(sweeps.shapes)


@pytest.mark.parametrize("body", ["wheelchair", "elder_walker", "amr"])
def test_a_body_drives_to_what_it_is_said_to_get_to(body: str):
    scene = rl.load_scene("examples/bedroom.json")
    layout = rl.generate(scene, agent=body).layout
    for name in (None, "double_bed-0", "wardrobe-0"):
        moved = layout if name is None else layout.moved(name, by=(0.35, -0.25))
        usage = judge_agent(scene, moved, rl.load_agent(body)).usage
        assert usage.drives is not None and usage._lattice is not None
        assert set(usage.drives) == usage._lattice.reached(usage._places)


@pytest.mark.slow
def test_what_is_used_is_never_more_than_what_is_got_to_nor_that_than_where_it_stands():
    scene = rl.load_scene("examples/bedroom.json")
    layout, less = rl.generate(scene).layout, list[bool]()
    for name, side in product(scene.by_name, (0.4, -0.4)):
        usage = judge_agent(scene, layout.moved(name, by=(side, 0.4)), rl.load_agent("wheelchair")).usage
        for each in layout:
            assert usage.standing[each] >= usage.got_to[each] >= usage.usable[each]
        less.append(sum(usage.standing.values()) > sum(usage.usable.values()))
    assert any(less)
