"""Navigation by the definitions of DESIGN section 8, on rooms whose figures can be worked out on paper."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import pytest
import shapely
from verify_rooms import DISC, DOOR, furnished, on_floor, square, thing

from robolayout.scene import Agent, Opening, Pose, Room
from robolayout.verify import navigation

BOX = thing("box-0", (0.5, 1.0, 0.8))


def divided(gap: float, *more, agent: Agent = DISC, height: float = 1.8):
    """A 4 x 4 m room cut in two by a shelf 0.4 m deep at y = 2 that leaves a gap at the right wall."""
    shelf = thing("shelf-0", (4.0 - gap, 0.4, height))
    return furnished(square(), (shelf, on_floor(shelf, (4.0 - gap) / 2, 2.0)), *more, agents=(agent,))


def behind() -> tuple:
    return (BOX, on_floor(BOX, 2, 3.4))


def test_the_free_space_of_an_empty_room_is_the_room_shrunk():
    nav = navigation(*furnished(square()))
    assert nav.free.area == pytest.approx(3.4 * 3.4)
    assert (nav.walkable_ratio, nav.reachable_share) == (1.0, 1.0)


def test_the_free_space_around_a_box_is_exact_to_the_chords():
    nav = navigation(*furnished(square(), (BOX, on_floor(BOX, 2, 2))))
    grown = 0.5 * 1.0 + 2 * 0.3 * 1.5 + math.pi * 0.09
    assert nav.free.area == pytest.approx(3.4 * 3.4 - grown, abs=math.pi * 0.09 * 0.002)
    assert nav.free.area > 3.4 * 3.4 - grown


@pytest.mark.parametrize(("gap", "open_"), [(0.61, True), (0.59, False), (0.0, False)])
def test_a_gap_is_passed_if_it_is_wider_than_the_disc(gap: float, open_: bool):
    nav = navigation(*divided(gap, behind()))
    assert nav.reached == {"shelf-0": True, "box-0": open_}
    assert nav.walkable_ratio == pytest.approx(1.0) if open_ else nav.walkable_ratio < 0.6


def test_a_room_cut_in_two_halves_is_half_walkable():
    nav = navigation(*divided(0.0))
    assert nav.walkable_ratio == pytest.approx(0.5)
    assert nav.main.bounds == pytest.approx((0.3, 0.3, 3.7, 1.5))


def test_the_main_component_is_the_one_at_the_first_door_however_small():
    shelf = thing("shelf-0", (4.0, 0.4, 1.8))
    placed = (shelf, on_floor(shelf, 2.0, 1.2))
    nav = navigation(*furnished(square(), placed))
    assert nav.main.area == pytest.approx(3.4 * 0.4)
    upper = Opening(wall=2, offset=1.0, width=0.9, height=2.05)
    assert navigation(*furnished(square(doors=(upper, DOOR)), placed)).main.area == pytest.approx(3.4 * 2.0)


def test_without_a_door_the_main_component_is_the_largest():
    shelf = thing("shelf-0", (4.0, 0.4, 1.8))
    nav = navigation(*furnished(square(doors=()), (shelf, on_floor(shelf, 2.0, 1.2))))
    assert nav.main.area == pytest.approx(3.4 * 2.0)
    assert nav.entry == pytest.approx((2.0, 2.0))


def test_a_blocked_door_lets_nobody_in():
    block = thing("block-0", (1.6, 1.4, 1.0))
    nav = navigation(*furnished(square(), (block, on_floor(block, 1.45, 0.7)), behind()))
    assert nav.main.is_empty
    assert nav.entry is None
    assert (nav.walkable_ratio, nav.reachable_share) == (0.0, 0.0)
    assert nav.routes == {}
    assert nav.distances["box-0"] == math.inf


def test_a_disc_too_wide_for_a_landing_still_comes_in():
    """A disc of radius 1 m cannot stand in a landing 0.9 m deep even in an empty room."""
    nav = navigation(*furnished(square(6.0)), replace(DISC, radius=1.0))
    assert nav.main.area == pytest.approx(4.0 * 4.0)


def test_a_body_larger_than_the_room_is_nowhere():
    nav = navigation(*furnished(square(), (BOX, on_floor(BOX, 2, 2))), replace(DISC, radius=2.5))
    assert (nav.walkable_ratio, nav.reachable_share) == (0.0, 0.0)


@pytest.mark.parametrize(
    ("height", "step", "bottom", "blocks"),
    [(1.5, 0.03, 0.0, True), (0.09, 0.02, 0.1, False), (0.11, 0.02, 0.1, True), (1.5, 0.5, -0.35, False)],
)
def test_obstacles_are_what_meets_the_bodys_heights(height: float, step: float, bottom: float, blocks: bool):
    agent = Agent(name="body", radius=0.2, height=height, step=step)
    scene, layout = furnished(square(), (BOX, on_floor(BOX, 2, 2, bottom=bottom)), agents=(agent,))
    assert navigation(scene, layout).obstacles == (("box-0",) if blocks else ())


def test_rugs_never_stand_in_the_way_and_need_no_reaching():
    rug = thing("rug-0", (3.9, 3.9, 0.029))
    nav = navigation(*furnished(square(), (rug, on_floor(rug, 2, 2))), replace(DISC, step=0.0))
    assert (nav.obstacles, nav.reached) == ((), {"rug-0": True})


def test_ceiling_assets_need_no_reaching_but_unplaced_ones_fail():
    lamp = thing("lamp-0", (0.4, 0.4, 0.3), on_floor=False, on_ceiling=True)
    nav = navigation(*furnished(square(), (lamp, on_floor(lamp, 3.8, 3.8, bottom=2.3)), (BOX, None)))
    assert nav.reached == {"lamp-0": True, "box-0": False}
    assert nav.unreached == ()
    assert nav.reachable_share == 0.5


@pytest.mark.parametrize(
    ("category", "flags", "reached"),
    [
        ("picture", {}, True),
        ("wall clock", {}, True),
        ("mirror", {}, False),  # somebody stands before it
        ("wall shelf", {}, False),
        ("picture", {"use_sides": ("front",)}, False),  # a map with buttons
        ("picture", {"on_floor": True}, False),  # leans on the wall
    ],
)
def test_nobody_needs_to_get_to_what_hangs_on_a_wall_to_be_looked_at(
    category: str, flags: dict[str, Any], reached: bool
):
    table = thing("table-0", (2.0, 2.0, 0.7))
    hung = thing("hung-0", (0.03, 0.6, 0.4), category, **({"on_floor": False, "on_wall": True} | flags))
    scene, layout = furnished(
        square(), (table, on_floor(table, 1.0, 2.5)), (hung, on_floor(hung, 0.015, 2.5, bottom=1.4))
    )
    nav = navigation(scene, layout, DISC)
    assert nav.reached["hung-0"] is reached
    assert ("hung-0" in nav.passages) is not reached


@pytest.mark.parametrize(("reach", "reached"), [(None, False), (0.79, False), (0.81, True)])
def test_reach_is_measured_in_plan_from_the_centre(reach: float | None, reached: bool):
    """A cup in the middle of a table 1.1 m across: its edge is 0.5 m from the table's, so 0.8 m from the disc's centre."""
    table, cup = thing("table-0", (1.1, 1.1, 0.7)), thing("cup-0", (0.1, 0.1, 0.1), on_floor=False, on_object=True)
    scene, layout = furnished(square(), (table, on_floor(table, 2.5, 2.5)), (cup, on_floor(cup, 2.5, 2.5, bottom=0.7)))
    nav = navigation(scene, layout, replace(DISC, reach_distance=reach))
    assert nav.distances["cup-0"] == pytest.approx(0.8, abs=1e-3)
    assert nav.reached["cup-0"] is reached


def test_touching_is_ten_centimetres_beyond_the_disc():
    assert navigation(*furnished(square(), (BOX, on_floor(BOX, 3, 3)))).reached["box-0"]
    ledge, cup = thing("ledge-0", (0.2, 4.0, 0.7)), thing("cup-0", (0.05, 0.05, 0.1), on_floor=False, on_object=True)
    for x, reached in ((3.92, True), (3.93, False)):
        scene, layout = furnished(square(), (ledge, on_floor(ledge, 3.9, 2)), (cup, on_floor(cup, x, 2, bottom=0.7)))
        assert navigation(scene, layout).reached["cup-0"] is reached


def test_routes_lead_from_the_door_to_touching_distance():
    """From (1.45, 0.3), straight up to 0.4 m in front of a box whose lower edge is at y = 2.9."""
    nav = navigation(*furnished(square(), (BOX, on_floor(BOX, 1.45, 3.4))))
    route = nav.routes["box-0"]
    assert nav.entry == pytest.approx((1.45, 0.3))
    assert route.points[0] == pytest.approx((1.45, 0.3))
    assert route.length == pytest.approx(2.2, abs=0.02)


def test_routes_round_corners_on_the_shortest_side():
    """Through the gap at the right wall: straight to the corner's arc, up past it, and back to the box."""
    nav = navigation(*divided(1.0, behind()))
    route = nav.routes["box-0"]
    assert nav.main.buffer(1e-6).covers(route.line)
    assert math.dist(route.points[0], (3.0, 1.8)) + 0.4 + 0.4 < route.length < 4.2
    assert route.line.distance(shapely.Point(3.0, 2.0)) == pytest.approx(0.3, abs=2e-3)


def test_a_route_needs_no_grid_to_find_a_slit():
    nav = navigation(*divided(0.602, behind()))
    assert nav.reached["box-0"]
    assert nav.routes["box-0"].line.distance(shapely.Point(3.7, 2.0)) < 0.01


@pytest.mark.parametrize("gap", [0.4, 0.52])
def test_the_narrowest_passage_on_the_way_to_what_is_not_reached(gap: float):
    passage = navigation(*divided(gap, behind())).passages["box-0"]
    assert passage.width == pytest.approx(gap, abs=0.0101)
    assert passage.width <= gap
    assert set(passage.between) == {"shelf-0", "wall 1"}
    assert passage.point == pytest.approx((4.0 - gap / 2, 2.0), abs=0.25)
    assert passage.shown == f"{passage.width:.2f} m"


def test_the_narrowest_passage_on_the_way_to_what_is_reached():
    passage = navigation(*divided(0.95, behind())).passages["box-0"]
    assert 0.94 <= passage.width <= 0.95
    assert set(passage.between) == {"shelf-0", "wall 1"}


def test_the_widest_of_two_ways_counts():
    """A shelf with 0.5 m left of it and 0.9 m right of it."""
    shelf = thing("shelf-0", (2.6, 0.4, 1.8))
    scene, layout = furnished(square(), (shelf, on_floor(shelf, 1.8, 2.0)), behind())
    passage = navigation(scene, layout).passages["box-0"]
    assert passage.width == pytest.approx(0.9, abs=0.0101)
    assert set(passage.between) == {"shelf-0", "wall 1"}


def test_where_there_is_no_way_the_width_is_zero():
    passage = navigation(*divided(0.0, behind())).passages["box-0"]
    assert (passage.width, passage.between, passage.shown, passage.cut_off) == (0.0, (), "none", True)


def test_open_floor_has_no_narrow_passage():
    passage = navigation(*furnished(square(6.0), (BOX, on_floor(BOX, 3, 3)))).passages["box-0"]
    assert (passage.shown, passage.between) == ("1.50 m or more", ())


def test_no_passage_is_said_to_be_wider_than_what_stands_beside_it_leaves():
    """A galley: the widest disc that reaches things from the door stops before fridge and counter, 0.956 m apart."""
    room = Room(((0, 0), (2.2, 0), (2.2, 3.4), (0, 3.4)), 2.5, (Opening(0, 0.7, 0.8, 2.05),))
    fridge, counter = thing("fridge-0", (0.65, 0.6, 1.85)), thing("counter-0", (0.6, 1.2, 0.9))
    across, sink = thing("counter-1", (0.6, 0.6, 0.9)), thing("sink-0", (0.6, 0.8, 0.9))
    stove = thing("stove-0", (0.6, 0.6, 0.9))
    nav = navigation(
        *furnished(
            room,
            (fridge, on_floor(fridge, 0.335, 0.31)),
            (counter, on_floor(counter, 0.31, 1.27)),
            (stove, on_floor(stove, 0.31, 2.23)),
            (across, on_floor(across, 1.89, 1.13, 180.0)),
            (sink, on_floor(sink, 1.89, 0.41, 180.0)),
        )
    )
    assert nav.passages["stove-0"].width == pytest.approx(0.98, abs=0.0101)
    for passage in nav.passages.values():
        assert len(passage.ends) < 2 or math.dist(*passage.ends) >= passage.width - 0.0101, passage


def test_an_l_shaped_room_is_walked_round_its_corner():
    room = Room(((0, 0), (5, 0), (5, 5), (4, 5), (4, 1), (0, 1)), 2.6, (Opening(5, 0.05, 0.9, 2.05),))
    picture = thing("picture-0", (0.04, 0.6, 0.5), on_floor=False, on_wall=True)
    nav = navigation(*furnished(room, (picture, Pose(4.5, 4.98, 1.2, -math.pi / 2))))
    assert nav.entry == pytest.approx((0.3, 0.5))
    across = math.hypot(3.7, 0.5)
    tangent, turn = math.sqrt(across**2 - 0.3**2), math.pi / 2 - math.atan2(0.5, 3.7) + math.asin(0.3 / across)
    assert nav.routes["picture-0"].length == pytest.approx(tangent + 0.3 * turn + 4.96 - 0.4 - 1.0, abs=0.005)
    assert nav.passages["picture-0"].width == pytest.approx(1.0, abs=0.0101)


def test_a_route_stays_clear_where_two_corners_of_the_free_space_differ_by_rounding():
    room = Room(((0.0, 0.0), (6.4, 0.0), (6.4, 3.2), (0.0, 3.2)), 2.6, doors=(Opening(1, 0.35, 0.95, 2.05),))
    half = math.pi / 2
    assets = {
        thing("desk-0", (0.65, 1.2, 0.74)): Pose(1.210002, 0.325, 0.37, half),
        thing("office_chair-0", (0.6, 0.6, 0.95)): Pose(1.210003, 1.020004, 0.475, 3 * half),
        thing("dining_table-0", (0.75, 0.75, 0.75)): Pose(2.780001, 1.749987, 0.375, half),
        thing("dining_chair-1", (0.46, 0.44, 0.82)): Pose(2.779998, 1.090004, 0.41, half),
        thing("bookshelf-0", (0.3, 0.8, 1.8)): Pose(5.990002, 0.15, 0.9, half),
    }
    nav = navigation(*furnished(room, *assets.items()))
    for route in nav.routes.values():
        assert len(route.points) < 2 or nav.main.buffer(1e-5).covers(shapely.LineString(route.points)), route.asset


def test_what_divides_a_room_is_named_nearest_first_and_only_that():
    assert navigation(*divided(0.59, behind())).dividing == ("shelf-0",)
    assert navigation(*divided(0.61, behind())).dividing == ()
