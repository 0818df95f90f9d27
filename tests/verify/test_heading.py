"""Rectangular bodies: where they stand, pass and turn, on rooms whose figures can be worked out on paper."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from verify_rooms import furnished, on_floor, square, thing

from robolayout.scene import Agent, Layout, Opening, Room, Scene, load_agent
from robolayout.verify import judge_agent, navigation
from robolayout.verify.heading import grown, heading_space, rectangle

CART = Agent(name="cart", radius=0.4, height=1.0, length=1.2, width=0.6)


def test_the_minkowski_sum_of_two_rectangles():
    box = np.array([[(0, 0), (2, 0), (2, 1), (0, 1)]], dtype=float)
    (result,) = grown(box, rectangle(CART, 0.0))
    assert result.equals(shapely.box(-0.6, -0.3, 2.6, 1.3))
    (turned,) = grown(box, rectangle(CART, math.radians(45)))
    perimeter_term = 2 * (1.2 + 0.6) / math.sqrt(2) * 0.5 * (2 + 1) * 2 / 2
    assert turned.area == pytest.approx(2 * 1 + 1.2 * 0.6 + perimeter_term)


def test_an_empty_room_is_the_room_less_half_a_body_on_each_side():
    """The door's normal is +y: length along y, so centres keep 0.3 m from the side walls and 0.6 m from the others."""
    space = heading_space(*furnished(square(), agents=(CART,)), CART)
    assert space.headings[0] == pytest.approx(math.pi / 2)
    assert space.standing[0].symmetric_difference(shapely.box(0.3, 0.6, 3.7, 3.4)).area < 1e-9
    assert space.standing[4].area == pytest.approx(2.8 * 3.4)
    reach = 4 - 2 * CART.circumradius
    assert space.turning.area == pytest.approx(reach**2)


def corridor(width: float, body: Agent = CART) -> tuple[Scene, Layout]:
    """A 4 x 4 m room whose upper part is left open; below it, two blocks leave a corridor straight in from the door."""
    side = 1.45 - width / 2
    left, right = thing("left-0", (side, 2.4, 1.0)), thing("right-0", (4 - width - side, 2.4, 1.0))
    return furnished(
        square(),
        (left, on_floor(left, side / 2, 1.2)),
        (right, on_floor(right, side + width + (4 - width - side) / 2, 1.2)),
        agents=(body,),
    )


@pytest.mark.parametrize("name", ["wheelchair", "spot"])
@pytest.mark.parametrize(("left", "enters"), [(1.3, False), (2.0, True)])
def test_a_rectangle_comes_in_straight_by_the_door_itself(name: str, left: float, enters: bool):
    """A shelf 0.92 m behind the right part of a door from x = 1.0 to 1.9: beside the door would be room for it, too."""
    body, shelf = load_agent(name), thing("shelf-0", (0.3, 1.9, 1.8), "bookshelf")
    report = judge_agent(*furnished(square(), (shelf, on_floor(shelf, left + 0.95, 1.07, 90)), agents=(body,)), body)
    assert bool(report.headings.pieces) is enters
    assert report.usage.usable["shelf-0"] is enters
    if not enters:
        reason = "it cannot come in straight by door 0: shelf-0 in the way"
        assert report.usage.uses["shelf-0"].reason == reason
        assert report.usage.shutting("shelf-0") == ("shelf-0",)


@pytest.mark.parametrize(("width", "passes"), [(0.62, True), (0.58, False)])
def test_a_straight_corridor_needs_the_width_only(width: float, passes: bool):
    space = heading_space(*corridor(width), CART)
    assert bool(space.standing[0].intersects(shapely.Point(1.8, 3.2))) is passes


@pytest.mark.parametrize("width", [0.68, 0.71, 0.77, 0.79])
def test_a_corridor_just_as_wide_as_the_body_is_none(width: float):
    """Rounding leaves a sliver of free space in these, through which no way could be planned: drives cut across what stands there."""
    body = replace(CART, width=width)
    space = heading_space(*corridor(width, body), body)
    assert not space.standing[0].intersects(shapely.Point(1.8, 3.2))


def bend(width: float) -> Room:
    """An L of two corridors; the door is at the lower end of the upright one."""
    return Room(
        ((0, 0), (width, 0), (width, 4 - width), (4, 4 - width), (4, 4), (0, 4)), 2.6, (Opening(0, 0.0, width, 2.05),)
    )


@pytest.mark.parametrize(("width", "turns"), [(1.4, True), (1.1, True), (0.75, False)])
def test_a_bend_needs_room_to_turn(width: float, turns: bool):
    """A rectangle 1.2 x 0.6 turned by 45 degrees needs (1.2 / 2 + 0.6) / sqrt(2) = 0.85 m of both corridors."""
    scene = Scene(bend(width), (), agents=(CART,))
    space = heading_space(scene, Layout({}), CART)
    assert bool(space.standing[4].intersects(shapely.Point(3.3, 4 - width / 2))) is turns


@pytest.mark.parametrize(("circle", "turns"), [(1.6, True), (1.7, False)])
def test_a_turning_circle_must_be_free_as_a_whole(circle: float, turns: bool):
    """In the bend of two corridors 1.4 m wide the largest circle has the diameter 2 x 1.4 / (1 + 1 / sqrt(2)) = 1.64."""
    scene = Scene(bend(1.4), (), agents=(CART,))
    space = heading_space(scene, Layout({}), replace(CART, turning_diameter=circle))
    assert bool(space.standing[4].intersects(shapely.Point(3.0, 3.3))) is turns
    assert space.turning.is_empty is not turns


def test_a_body_longer_than_the_room_cannot_come_in():
    scene = Scene(square(), (), agents=(CART,))
    space = heading_space(scene, Layout({}), replace(CART, length=4.5))
    assert all(region.is_empty for region in space.standing)


def test_without_a_door_the_largest_group_counts():
    shelf = thing("shelf-0", (4.0, 0.4, 1.8))
    scene, layout = furnished(square(doors=()), (shelf, on_floor(shelf, 2.0, 1.2)), agents=(CART,))
    space = heading_space(scene, layout, CART)
    assert space.standing[0].bounds[1] > 1.4


def test_a_body_wider_than_the_door_gets_nowhere():
    for width, enters in ((0.89, True), (0.91, False)):
        body = replace(CART, width=width, radius=0.5)
        space = heading_space(Scene(square(6.0), (), agents=(body,)), Layout({}), body)
        assert space.standing[0].is_empty is not enters
        assert (space.start is not None) is enters


@pytest.mark.parametrize(("width", "turns"), [(1.25, False), (1.35, True)])
def test_a_wheelchair_needs_its_turning_circle_where_corridors_meet(width: float, turns: bool):
    """Two corridors of width w leave a circle of 2 w / (1 + 1 / sqrt(2)) in their bend: 1.525 m from w = 1.302 m on."""
    chair = load_agent("wheelchair")
    scene = Scene(bend(width), (), agents=(chair,))
    space = heading_space(scene, Layout({}), chair)
    assert space.turning.is_empty is not turns
    assert bool(space.standing[4].intersects(shapely.Point(3.3, 4 - width / 2))) is turns
    assert space.standing[0].intersects(shapely.Point(width / 2, 2.0)), "straight in it comes either way"


@pytest.mark.parametrize(("aisle", "gets_there"), [(3.4, False), (3.6, True)])
def test_a_forklift_needs_its_aisle(aisle: float, gets_there: bool):
    """Two rows of racks across a hall; what stands at the end of the aisle between them is reached or not."""
    forklift = load_agent("forklift")
    side, depth = 14.0, 1.2
    room = Room(((0, 0), (side, 0), (side, side), (0, side)), 6.0, (Opening(0, 5.0, 4.0, 4.5),))
    row = (side - aisle) / 2
    left, right = (thing(f"pallet_rack-{i}", (row, depth, 3.0), "box") for i in range(2))
    crate = thing("crate-0", (1.0, 1.0, 1.0), "box")
    scene, layout = furnished(
        room,
        (left, on_floor(left, row / 2, 8.0)),
        (right, on_floor(right, side - row / 2, 8.0)),
        (crate, on_floor(crate, 7.0, 13.0)),
        agents=(forklift,),
    )
    assert navigation(scene, layout).reached["crate-0"] is gets_there


@pytest.mark.parametrize("slides", [True, False])
def test_what_a_body_would_have_to_slide_to_sideways_is_not_usable(slides: bool):
    """A niche as wide as the body is long, too narrow to turn in; from outside it the crate at its back is 0.6 m away."""
    body = replace(CART, reach_distance=0.4, turning_radius=None if slides else 0.0)
    crate, left, right = (
        thing("crate-0", (1.2, 0.1, 1.0), "box"),
        thing("left-0", (1.3, 0.8, 1.0), "box"),
        thing("right-0", (1.4, 0.8, 1.0), "box"),
    )
    places = (on_floor(crate, 1.95, 3.95), on_floor(left, 0.65, 3.6), on_floor(right, 3.3, 3.6))
    report = judge_agent(*furnished(square(), *zip((crate, left, right), places, strict=True), agents=(body,)), body)
    assert report.usage.usable["crate-0"] is slides
    assert ("crate-0" in report.drives) is slides
    assert report.usage.undriven == (() if slides else ("crate-0",))
    if not slides:
        assert set(report.usage.shutting("crate-0")) == {"left-0", "right-0"}
        assert report.usage.uses["crate-0"].reason == (
            "it could stand at its edge, but finds no way to drive there: left-0 and right-0 leave no room to turn"
        )
        assert report.figures["usable_share"] == pytest.approx(2 / 3) and "crate-0" in report.short


def test_one_thing_alone_leaves_no_room_to_turn():
    body = replace(CART, reach_distance=0.4, turning_radius=0.0)
    crate, left = thing("crate-0", (1.2, 0.1, 1.0), "box"), thing("left-0", (1.3, 0.8, 1.0), "box")
    places = (on_floor(crate, 1.95, 2.55), on_floor(left, 0.65, 2.2))
    report = judge_agent(*furnished(square(2.6), *zip((crate, left), places, strict=True), agents=(body,)), body)
    assert report.usage.uses["crate-0"].reason == (
        "it could stand at its edge, but finds no way to drive there: left-0 leaves no room to turn"
    )
