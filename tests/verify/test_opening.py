"""Opening: doors need the room that they sweep, and a body that reaches a handle from beside the open leaf."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import dist

import numpy as np
import pytest
from shapely import GeometryCollection, LineString, Point, Polygon, box
from verify_rooms import DISC, furnished, on_floor, square, thing

from robolayout.scene import Agent, Asset
from robolayout.verify import usage
from robolayout.verify._approaches import swept
from robolayout.verify._boxes import boxes
from robolayout.verify._space import areas
from robolayout.verify.heading import rectangle
from robolayout.verify.holds import STRIDES

ARM = replace(DISC, reach_distance=0.9, reach_low=0.2, reach_high=1.8)
WARDROBE = thing("wardrobe-0", (0.6, 1.0, 2.0), "wardrobe")
FRIDGE = thing("fridge-0", (0.7, 0.75, 0.84), "mini fridge")


def used(*things: tuple[Asset, object], agent: Agent = ARM) -> bool:
    scene, layout = furnished(square(5.0), *things)
    return usage(scene, layout, agent).usable[scene.assets[0].name]


def test_what_a_leaf_does_not_sweep_may_be_taken() -> None:
    """A wardrobe's two leaves of 0.5 m sweep less than its whole front: its middle line is free beyond 0.5 m."""
    near, far = thing("plant-0", (0.2, 0.2, 1.0), "bookshelf"), thing("plant-0", (0.2, 0.2, 1.0), "bookshelf")
    wardrobe = (WARDROBE, on_floor(WARDROBE, 0.3, 2.5))
    assert not used(wardrobe, (near, on_floor(near, 0.85, 2.2)))
    assert used(wardrobe, (far, on_floor(far, 0.6 + 0.47 + 0.12, 2.5)))


def test_what_stands_below_a_door_is_not_in_its_way() -> None:
    wardrobe = (WARDROBE, on_floor(WARDROBE, 0.3, 2.5))
    plinth = thing("box-0", (0.2, 0.2, 0.05), "bookshelf")
    assert used(wardrobe, (plinth, on_floor(plinth, 0.85, 2.2)))


def test_a_handle_must_be_within_reach() -> None:
    """The handles of a wardrobe 2 m high are near 1 m: a body that reaches from 1.3 m on cannot open it, its sides or not."""
    wardrobe = (WARDROBE, on_floor(WARDROBE, 0.3, 2.5))
    assert used(wardrobe, agent=replace(ARM, reach_low=0.9, reach_high=1.1))
    high = replace(ARM, reach_low=1.3, reach_high=1.8)
    assert not used(wardrobe, agent=high)
    scene, layout = furnished(square(5.0), wardrobe)
    reason = usage(scene, layout, high).uses["wardrobe-0"].reason
    assert reason.startswith("its handles lie 0.9") and reason.endswith("m high, reach is from 1.30 to 1.80 m")


def test_a_body_stands_beside_the_open_leaf() -> None:
    scene, layout = furnished(square(5.0), (WARDROBE, on_floor(WARDROBE, 0.3, 2.5)))
    use = usage(scene, layout, ARM).uses["wardrobe-0"]
    assert use.opens in ("door 0", "door 1") and use.stand is not None
    assert all(isinstance(zone, Polygon) for zone in swept(boxes(scene, layout), [0])[1])
    leaves = (
        Polygon(((0.6, y), (1.1, y), (1.1, y + s * 0.018), (0.6, y + s * 0.018))) for y, s in ((2.0, 1), (3.0, -1))
    )
    assert max(leaf.distance(Point(use.stand)) for leaf in leaves) >= ARM.radius - 1e-6


@pytest.mark.parametrize("degrees", [0, 90, 200])
def test_turning_the_room_changes_nothing(degrees: float) -> None:
    fridge = (FRIDGE, on_floor(FRIDGE, 2.5, 2.5, degrees))
    assert used(fridge)
    scene, layout = furnished(square(5.0), fridge)
    assert usage(scene, layout, ARM).uses["fridge-0"].opens == "door 0"


@pytest.mark.parametrize("agent", [ARM, replace(ARM, length=0.7, width=0.5, reach_distance=1.1)])
def test_a_body_holds_every_door_clear_of_what_it_sweeps(agent: Agent) -> None:
    scene, layout = furnished(square(5.0), (WARDROBE, on_floor(WARDROBE, 0.3, 2.5)))
    for hold, side in zip(usage(scene, layout, agent).holds, (-1, 1), strict=True):
        ((x, y, heading),) = hold.poses
        body = (
            Point(x, y).buffer(agent.radius)
            if agent is ARM
            else Polygon(rectangle(agent, heading) + np.array(hold.poses[0][:2]))
        )
        quarter = Point(0.6, 2.5 + side * 0.5).buffer(0.5).intersection(box(0.6, 2.0, 2.0, 3.0))
        assert body.distance(quarter) >= 0.0 and body.intersection(quarter).area < 1e-3
        assert Point(x, y).distance(Point(0.6, 2.5)) <= agent.reach
        assert hold.moved == ()


def test_where_it_cannot_stand_clear_a_body_steps_back() -> None:
    """It reaches 0.6 m: standing beyond what a leaf of 0.5 m sweeps, its disc of 0.3 m does not get to the handle."""
    near = replace(ARM, radius=0.3, reach_distance=0.55)
    scene, layout = furnished(square(5.0), (WARDROBE, on_floor(WARDROBE, 0.3, 0.9)))
    hold = usage(scene, layout, near).holds[0]
    steps = [dist(a, b) for a, b in pairwise(pose[:2] for pose in hold.poses)]
    assert len(steps) == STRIDES.steps and 0.0 < max(steps) <= STRIDES.longest + 1e-9


def test_what_people_move_is_moved_out_of_the_way_of_a_leaf() -> None:
    lamp = thing("lamp-0", (0.3, 0.3, 1.5), "floor lamp")
    wardrobe, spot = (WARDROBE, on_floor(WARDROBE, 0.3, 2.5)), on_floor(lamp, 0.85, 2.2)
    scene, layout = furnished(square(5.0), wardrobe, (lamp, spot))
    assert {hold.moved for hold in usage(scene, layout, ARM).holds} == {("lamp-0",), ()}


def test_what_no_place_lets_a_body_open_is_not_usable() -> None:
    """Its drawers come out by 0.36 m: a body 0.6 m wide needs 0.96 m before them, whatever it reaches from nearer."""
    chest, wall = thing("chest-0", (0.6, 1.2, 0.9), "dresser"), thing("wall-0", (0.1, 5.0, 2.0), "bookshelf")
    short = replace(ARM, radius=0.3, reach_distance=0.5)
    for gap, opens in ((0.8, False), (1.0, True)):
        scene, layout = furnished(
            square(5.0), (chest, on_floor(chest, 0.3, 2.5)), (wall, on_floor(wall, 0.65 + gap, 2.5))
        )
        found = usage(scene, layout, short)
        assert found.standing["chest-0"] and found.usable["chest-0"] == opens == bool(found.holds)
        assert "no place from which it could hold any" in found.uses["chest-0"].reason or opens
        assert found.shutting("chest-0") == (() if opens else ("wall-0",))


def test_where_shapes_only_touch_there_is_no_place_to_stand() -> None:
    """GEOS refused to intersect a region with what two rings of reach had left: an area and a line."""
    found = areas(GeometryCollection([LineString([(2, 0), (3, 0)]), box(0, 0, 1, 1)]))
    assert found.geom_type == "MultiPolygon" and found.equals(box(0, 0, 1, 1))


def test_a_handle_within_its_own_footprint_is_out_of_reach() -> None:
    """Its shoulder is at 1.5 m: at the lower drawers its hand does not get beyond the 0.3 m of its disc."""
    chest = thing("chest-0", (0.5, 0.8, 1.2), "dresser")
    body = replace(ARM, radius=0.3, reach_distance=0.8, shoulder_height=1.5)
    scene, layout = furnished(square(5.0), (chest, on_floor(chest, 0.25, 2.5)))
    assert 0 < len(usage(scene, layout, body).holds) < len(usage(scene, layout, ARM).holds)
