"""Use: sides, reach in plan and height, room to open; each worked out by hand."""

from __future__ import annotations

from dataclasses import replace

import pytest
from verify_rooms import DISC, furnished, on_floor, square, thing

from robolayout.scene import Agent, Asset, Layout, Pose, Scene
from robolayout.verify import navigation, usage, verify
from robolayout.verify.use import horizontal_reach

ARM = replace(DISC, reach_distance=0.6, reach_low=0.4, reach_high=1.2)
WARDROBE = thing("wardrobe-0", (0.6, 1.2, 2.1), "wardrobe")
SHELF = thing("bookshelf-0", (0.3, 1.0, 1.8), "bookshelf")
LAMP = thing("lamp-0", (0.2, 0.2, 0.4), "table lamp", on_floor=False, on_object=True)
TABLE = thing("table-0", (0.8, 0.8, 0.7), "dining table")


@pytest.mark.parametrize(("degrees", "usable"), [(0, True), (180, False), (90, True)])
def test_an_asset_is_used_from_its_side(degrees: float, usable: bool):
    """A bookshelf at the left wall: facing the room, facing the wall, facing along the wall."""
    scene, layout = furnished(square(), (SHELF, on_floor(SHELF, 0.15 if degrees != 90 else 0.5, 2.5, degrees)))
    judged = usage(scene, layout)
    assert judged.usable["bookshelf-0"] is usable
    assert judged.uses["bookshelf-0"].side == ("front" if usable else "")


def test_sides_can_be_overridden():
    scene, layout = furnished(square(), (SHELF, on_floor(SHELF, 0.15, 2.5, 180)))
    assert not usage(scene, layout).usable["bookshelf-0"]
    both = replace(SHELF, use_sides=("back", "front"))
    assert usage(*furnished(square(), (both, on_floor(both, 0.15, 2.5, 180)))).usable["bookshelf-0"]
    none = replace(SHELF, use_sides=())
    assert usage(*furnished(square(), (none, on_floor(none, 0.15, 2.5, 180)))).usable["bookshelf-0"]


def test_left_is_plus_y_at_zero_rotation():
    """Only the named side is free: a bed that touches the upper wall with its left side (+y)."""
    for side, usable in (("left", False), ("right", True)):
        bed = thing("bed-0", (2.0, 1.4, 0.5), "bed", use_sides=(side,))
        scene, layout = furnished(square(), (bed, on_floor(bed, 2.9, 3.3)))
        assert usage(scene, layout).usable["bed-0"] is usable


def test_nobody_reaches_a_side_through_the_asset():
    """The front is 0.2 m from the wall: nobody stands there, though an arm could reach the edge from behind."""
    scene, layout = furnished(square(), (SHELF, on_floor(SHELF, 0.35, 2.0, 180)))
    judged = usage(scene, layout, replace(ARM, reach_distance=1.0))
    assert not judged.usable["bookshelf-0"]
    assert judged.uses["bookshelf-0"].reason == "there is no place to stand at its front"


def test_the_standing_place_is_within_reach_and_in_the_main_component():
    scene, layout = furnished(square(), (SHELF, on_floor(SHELF, 0.15, 2.5)))
    use = usage(scene, layout).uses["bookshelf-0"]
    assert use.stand == pytest.approx((0.6, 2.5), abs=2e-3)


@pytest.mark.parametrize(("bottom", "usable"), [(0.45, True), (1.15, True), (1.25, False)])
def test_height_counts_for_a_body_with_an_arm(bottom: float, usable: bool):
    picture = thing("picture-0", (0.04, 0.6, 0.5), "mirror", on_floor=False, on_wall=True, use_sides=("front",))
    scene, layout = furnished(square(), (picture, Pose(0.02, 2.5, bottom + 0.25, 0.0)))
    judged = usage(scene, layout, ARM)
    assert judged.usable["picture-0"] is usable
    if not usable:
        assert judged.uses["picture-0"].reason == "it begins 1.25 m high, reach ends at 1.20 m: 0.05 m too high"
    assert usage(scene, layout, DISC).usable["picture-0"]


def test_low_things_are_below_reach():
    box = thing("box-0", (0.4, 0.4, 0.3), "storage box")
    judged = usage(*furnished(square(), (box, on_floor(box, 2.5, 2.5))), ARM)
    assert judged.uses["box-0"].reason == "it ends 0.30 m high, reach begins at 0.40 m: 0.10 m too low"


def test_the_reach_is_a_sphere_around_the_shoulder():
    """Shoulder at 1.0 m, reach 0.5 m: at 1.3 m it is sqrt(0.25 - 0.09) = 0.4 m, at 1.5 m nothing, at 1.0 m all of it."""
    body = Agent("body", 0.2, 1.5, reach_distance=0.5, reach_low=0.0, reach_high=2.0, shoulder_height=1.0)
    assert horizontal_reach(body, 1.3, 1.5) == pytest.approx(0.4)
    assert horizontal_reach(body, 0.0, 0.7) == pytest.approx(0.4)
    assert horizontal_reach(body, 0.8, 1.2) == pytest.approx(0.5)
    assert horizontal_reach(body, 1.51, 1.8) is None
    assert horizontal_reach(replace(body, shoulder_height=None), 1.3, 1.5) == 0.5
    assert horizontal_reach(replace(body, reach_distance=None), 3.0, 4.0) == pytest.approx(0.3)


@pytest.mark.parametrize(("x", "usable"), [(2.5, False), (2.75, True)])
def test_what_stands_on_something_is_reached_over_its_edge(x: float, usable: bool):
    """Reach 0.55 less the disc's 0.3: the lamp's edge must be within 0.25 m of the table's edge at x = 2.9."""
    table = replace(TABLE, size=(0.9, 0.9, 0.7))
    scene, layout = furnished(
        square(5.0), (table, on_floor(table, 2.45, 2.5)), (LAMP, on_floor(LAMP, x, 2.5, bottom=0.7))
    )
    judged = usage(scene, layout, replace(ARM, reach_distance=0.55))
    assert judged.usable["lamp-0"] is usable
    if not usable:
        assert judged.uses["lamp-0"].reason == (
            "the nearest place to stand is 0.60 m from its edge, reach is 0.55 m at that height"
        )


def test_doors_need_room_to_open():
    """A wardrobe needs 0.6 m in front: a table 0.5 m away stands in it, a chair may be moved, a rug lies flat."""
    wardrobe = (WARDROBE, on_floor(WARDROBE, 0.3, 2.5))
    for gap, usable in ((0.5, False), (0.65, True)):
        scene, layout = furnished(square(6.0), wardrobe, (TABLE, on_floor(TABLE, 1.0 + gap, 2.2)))
        judged = usage(scene, layout, replace(ARM, reach_distance=0.9))
        assert judged.usable["wardrobe-0"] is usable
        if not usable:
            assert judged.uses["wardrobe-0"].reason == "its front has no room to open: table-0 in the way"
        assert judged.shutting("wardrobe-0") == (() if usable else ("table-0",))
    chair, rug = thing("chair-0", (0.5, 0.45, 0.9), "chair"), thing("rug-0", (1.5, 1.5, 0.02), "rug")
    for item in (chair, rug):
        scene, layout = furnished(square(6.0), wardrobe, (item, on_floor(item, 1.0, 2.9)))
        assert usage(scene, layout, replace(ARM, reach_distance=0.9)).usable["wardrobe-0"]


def test_a_wall_in_front_leaves_no_room_to_open():
    scene, layout = furnished(square(), (WARDROBE, on_floor(WARDROBE, 3.3, 2.5)))
    assert usage(scene, layout).uses["wardrobe-0"].reason == "its front has no room to open: the wall in the way"
    assert usage(scene, layout).shutting("wardrobe-0") == (), "nobody moves a wall"


def test_a_chair_is_taken_from_any_side():
    chair = thing("chair-0", (0.5, 0.45, 0.9), "chair")
    desk = thing("desk-0", (0.6, 1.4, 0.75), "desk")
    scene, layout = furnished(square(), (desk, on_floor(desk, 0.3, 2.5)), (chair, on_floor(chair, 0.9, 2.5, 180)))
    assert usage(scene, layout).usable == {"desk-0": True, "chair-0": True}


CHAIR = thing("dining_chair-0", (0.5, 0.5, 0.9), "dining chair")
PLATE = thing("plate-0", (0.2, 0.2, 0.03), "plate", on_floor=False, on_object=True)
SEAT = replace(ARM, reach_distance=0.55, reach_low=0.0)


def place_setting(*more: tuple[Asset, Pose | None], chair: Asset = CHAIR) -> tuple[Scene, Layout]:
    """A table across the room, a chair 5 cm before it in a gap of 0.7 m between two shelves, a plate behind the chair."""
    table = thing("dining_table-0", (0.8, 4.0, 0.75), "dining table")
    shelves = [(thing(f"shelf-{i}", (0.6, 1.65, 1.8)), x) for i, x in enumerate((0.825, 3.175))]
    sides = [(shelf, on_floor(shelf, x, 2.7, 90)) for shelf, x in shelves]
    top = (table, on_floor(table, 2.0, 3.6, 90))
    return furnished(
        square(),
        top,
        (chair, on_floor(chair, 2.0, 2.9, 90)),
        (PLATE, on_floor(PLATE, 2.0, 3.35, bottom=0.75)),
        *sides,
        *more,
    )


def test_an_arm_moves_the_chair_away_that_stands_before_a_plate():
    """The chair's near edge is at 2.65, the plate's at 3.25: from 0.3 m before the chair it is 0.90 m to the plate."""
    scene, layout = place_setting()
    judged, nav = usage(scene, layout, SEAT), navigation(scene, layout, SEAT)
    assert nav.reached["plate-0"] and judged.usable["plate-0"]
    assert judged.uses["plate-0"].moved == ("dining_chair-0",)
    assert judged.uses["plate-0"].stand == pytest.approx((2.0, 2.9), abs=1e-3)
    bare = Layout({name: pose for name, pose in layout.items() if name != "dining_chair-0"})
    assert nav.main.area < navigation(scene, bare, SEAT).main.area, "to walk, the chair is in the way"
    assert "yes, dining_chair-0 moved" in verify(scene, layout, agent=SEAT).to_markdown()
    assert verify(scene, layout, agent=SEAT).agents[0].to_dict()["moved"]["plate-0"] == ["dining_chair-0"]


def test_nobody_without_an_arm_moves_a_chair_and_a_cabinet_stays():
    for agent, item in (
        (replace(SEAT, reach_distance=None, radius=0.3), CHAIR),
        (SEAT, replace(CHAIR, category="cabinet")),
    ):
        scene, layout = place_setting(chair=item)
        assert not navigation(scene, layout, agent).reached["plate-0"]
        assert not usage(scene, layout, agent).usable["plate-0"]


def test_a_chair_that_carries_something_stays():
    box = thing("book-0", (0.2, 0.2, 0.1), "book", on_floor=False, on_object=True)
    scene, layout = place_setting((box, on_floor(box, 2.0, 2.9, bottom=0.459)))
    assert not navigation(scene, layout, SEAT).reached["plate-0"]


def test_a_barrier_of_boxes_away_from_what_is_used_stays_a_barrier():
    boxes = [thing(f"storage_box-{i}", (0.4, 1.0, 0.4), "storage box") for i in range(4)]
    barrier = [(box, on_floor(box, 0.5 + i, 2.0, 90)) for i, box in enumerate(boxes)]
    for y, reached in ((3.8, False), (2.6, True)):
        shelf = (SHELF, on_floor(SHELF, 2.0, y, -90))
        judged = navigation(*furnished(square(), *barrier, shelf), replace(ARM, reach_distance=0.5))
        assert judged.reached["bookshelf-0"] is reached


@pytest.mark.parametrize("heading", [0, 90])
def test_a_long_body_without_an_arm_touches_things_head_on(heading: float):
    """1.1 x 0.5 m with a disc of 0.3 m, in a corridor 0.9 m wide: its nose comes within 5 cm of the box at the end."""
    spot = Agent("spot", 0.3, 0.8, length=1.1, width=0.5)
    side, box = thing("shelf-0", (3.1, 2.5, 1.8)), thing("box-0", (0.6, 0.6, 0.6), "box")
    scene, layout = furnished(square(), (side, on_floor(side, 2.45, 2.75)), (box, on_floor(box, 0.45, 3.5, heading)))
    assert usage(scene, layout, spot).usable["box-0"]
    stand = usage(scene, layout, spot).uses["box-0"].stand
    assert stand is not None and 3.2 - stand[1] <= 0.55 + 0.10 + 1e-4
    assert not usage(scene, layout, replace(spot, length=4.5, radius=0.3)).usable["box-0"]


def test_what_stands_on_a_rug_is_used_from_its_own_sides():
    rug = thing("rug-0", (3.0, 3.0, 0.02), "rug")
    scene, layout = furnished(square(), (rug, on_floor(rug, 2, 2)), (SHELF, on_floor(SHELF, 0.15, 2.5, 180)))
    assert not usage(scene, layout).usable["bookshelf-0"]


def test_unplaced_assets_are_not_usable_and_lamps_and_rugs_need_no_use():
    rug = thing("rug-0", (1.5, 1.5, 0.02), "rug")
    pendant = thing("pendant-0", (0.4, 0.4, 0.3), "pendant lamp", on_floor=False, on_ceiling=True)
    scene, layout = furnished(
        square(), (rug, on_floor(rug, 2, 2)), (pendant, on_floor(pendant, 2, 2, bottom=2.3)), (SHELF, None)
    )
    judged = usage(scene, layout)
    assert judged.usable == {"rug-0": True, "pendant-0": True, "bookshelf-0": False}
    assert judged.usable_share == pytest.approx(2 / 3)
    assert set(judged.uses) == {"rug-0", "pendant-0"}


def test_nothing_is_usable_from_a_blocked_door():
    block = thing("block-0", (1.6, 1.4, 1.0))
    scene, layout = furnished(square(), (block, on_floor(block, 1.45, 0.7)), (SHELF, on_floor(SHELF, 0.15, 2.5)))
    assert usage(scene, layout).usable_share == 0.0
