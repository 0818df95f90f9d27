"""Each physical check on its own, on layouts made by hand."""

from __future__ import annotations

import math

import pytest
from verify_rooms import furnished, on_floor, square, thing

from robolayout.scene import Asset, Layout, Pose, Room
from robolayout.verify import physics

BOX = thing("box-0", (0.5, 1.0, 0.8))
OTHER = thing("box-1", (0.5, 1.0, 0.8))
RUG = thing("rug-0", (2.0, 2.0, 0.02))
LAMP = thing("lamp-0", (0.2, 0.2, 0.4), on_floor=False, on_object=True)
PICTURE = thing("picture-0", (0.04, 0.6, 0.5), on_floor=False, on_wall=True)
PENDANT = thing("pendant-0", (0.4, 0.4, 0.3), on_floor=False, on_ceiling=True)


def test_a_sound_layout_passes_everything():
    judged = physics(
        *furnished(
            square(),
            (BOX, on_floor(BOX, 3, 2)),
            (RUG, on_floor(RUG, 2, 2.5)),
            (LAMP, on_floor(LAMP, 3, 2, bottom=0.8)),
            (PICTURE, Pose(0.02, 3, 1.5, 0)),
            (PENDANT, on_floor(PENDANT, 2, 2, bottom=2.3)),
        )
    )
    assert judged.ok
    assert judged.shares == dict.fromkeys(judged.shares, 1.0)
    assert judged.reasons == ()


@pytest.mark.parametrize(("gap", "free"), [(0.0, True), (-0.00009, True), (-0.0002, False), (-0.2, False)])
def test_footprints_may_share_a_square_centimetre(gap: float, free: bool):
    judged = physics(*furnished(square(), (BOX, on_floor(BOX, 2, 2)), (OTHER, on_floor(OTHER, 2.5 + gap, 2))))
    assert all(judged.collision_free.values()) is free


def test_heights_may_share_a_centimetre():
    for bottom, free in ((0.795, True), (0.785, False)):
        judged = physics(*furnished(square(), (BOX, on_floor(BOX, 2, 2)), (LAMP, on_floor(LAMP, 2, 2, bottom=bottom))))
        assert judged.collision_free == {"box-0": free, "lamp-0": free}


def test_collision_is_measured():
    judged = physics(*furnished(square(), (BOX, on_floor(BOX, 2, 2)), (OTHER, on_floor(OTHER, 2.4, 2.2))))
    (pair,) = judged.collisions
    assert (pair.a, pair.b) == ("box-0", "box-1")
    assert pair.area == pytest.approx(0.1 * 0.8)
    assert pair.height == pytest.approx(0.8)
    assert judged.reasons == ("box-0 and box-1 overlap by 0.080 m2 in plan and 0.80 m in height.",)


def test_turned_boxes_collide_by_their_real_footprint():
    """Two 0.5 x 1 boxes, the second turned by 45 degrees: its half-diagonal along x is 0.75 / sqrt(2) = 0.530."""
    for x, free in ((2.25 + 0.531, True), (2.25 + 0.50, False)):
        judged = physics(*furnished(square(), (BOX, on_floor(BOX, 2, 2)), (OTHER, on_floor(OTHER, x, 2, 45))))
        assert all(judged.collision_free.values()) is free


def test_rugs_lie_under_furniture_and_each_other():
    second = thing("rug-1", (1.0, 1.0, 0.02))
    judged = physics(
        *furnished(square(), (BOX, on_floor(BOX, 3, 2)), (RUG, on_floor(RUG, 3, 2)), (second, on_floor(second, 2.5, 2)))
    )
    assert judged.ok


@pytest.mark.parametrize(("x", "inside"), [(0.25, True), (0.241, True), (0.23, False), (3.77, False), (-3.0, False)])
def test_the_room_is_grown_by_a_centimetre(x: float, inside: bool):
    judged = physics(*furnished(square(), (BOX, on_floor(BOX, x, 2))))
    assert judged.in_boundary["box-0"] is inside


def test_how_far_it_sticks_out_is_said():
    judged = physics(*furnished(square(), (BOX, on_floor(BOX, 0.1, 2))))
    assert judged.reasons == ("box-0 sticks 0.15 m out of the room (0.150 m2 of its footprint).",)


def test_a_corner_that_points_into_the_room_counts():
    room = Room(((0, 0), (4, 0), (4, 4), (2, 4), (2, 2), (0, 2)), 2.6)
    straddling = physics(*furnished(room, (BOX, on_floor(BOX, 2.0, 2.0))))
    assert not straddling.in_boundary["box-0"]
    beside = physics(*furnished(room, (BOX, on_floor(BOX, 2.25, 2.0))))
    assert beside.in_boundary["box-0"]


def test_heights_stay_between_floor_and_ceiling():
    tall = thing("tall-0", (0.5, 0.5, 2.605))
    assert physics(*furnished(square(), (tall, on_floor(tall, 2, 2)))).in_boundary["tall-0"]
    taller = thing("tall-0", (0.5, 0.5, 2.7))
    judged = physics(*furnished(square(), (taller, on_floor(taller, 2, 2))))
    assert judged.reasons == ("tall-0 reaches 0.10 m above the ceiling.",)
    sunk = physics(*furnished(square(), (BOX, on_floor(BOX, 2, 2, bottom=-0.05))))
    assert "box-0 reaches 0.05 m below the floor." in sunk.reasons


@pytest.mark.parametrize(("bottom", "held"), [(0.0, True), (0.019, True), (0.03, False)])
def test_things_stand_on_the_floor_within_two_centimetres(bottom: float, held: bool):
    assert physics(*furnished(square(), (BOX, on_floor(BOX, 2, 2, bottom=bottom)))).supported["box-0"] is held


@pytest.mark.parametrize(
    ("x", "bottom", "held"), [(2.2, 0.8, True), (2.26, 0.8, False), (2.0, 0.83, False), (2.0, 0.782, True)]
)
def test_things_stand_on_things_with_their_centre_over_them(x: float, bottom: float, held: bool):
    judged = physics(*furnished(square(), (BOX, on_floor(BOX, 2, 2)), (LAMP, on_floor(LAMP, x, 2, bottom=bottom))))
    assert judged.supported["lamp-0"] is held


def test_what_floats_is_told_with_what_is_below():
    judged = physics(*furnished(square(), (BOX, on_floor(BOX, 2, 2)), (LAMP, on_floor(LAMP, 2, 2, bottom=1.0))))
    assert judged.reasons == ("lamp-0 is not supported: its bottom is at 1.00 m, the top of box-0 at 0.80 m.",)


def plate(name: str) -> Asset:
    return thing(name, (0.3, 0.3, 0.008), "plate", on_floor=False, on_object=True)


def test_two_plates_in_mid_air_do_not_hold_each_other_up():
    a, b = plate("plate-0"), plate("plate-1")
    judged = physics(*furnished(square(), (a, on_floor(a, 2, 2, bottom=1.0)), (b, on_floor(b, 2, 2, bottom=1.008))))
    assert judged.supported == {"plate-0": False, "plate-1": False}
    assert judged.reasons == (
        "plate-0 is not supported: its bottom is at 1.00 m, the floor at 0.00 m.",
        "plate-1 is not supported: it stands on plate-0, which nothing holds.",
    )


def test_support_is_a_tree_that_ends_at_floor_wall_or_ceiling():
    shelf = thing("shelf-0", (0.3, 1.0, 0.05), "wall shelf", on_floor=False, on_wall=True)
    stack = [plate(f"plate-{i}") for i in range(4)]
    for shelf_x, held in ((0.15, True), (0.5, False)):
        room = furnished(
            square(),
            *((one, on_floor(one, shelf_x, 2, bottom=1.05 + 0.008 * i)) for i, one in reversed([*enumerate(stack)])),
            (shelf, on_floor(shelf, shelf_x, 2, bottom=1.0)),
        )
        assert set(physics(*room).supported.values()) == {held}


def test_what_stands_on_a_floating_table_floats():
    lamp = thing("lamp-0", (0.2, 0.2, 0.4), "table lamp", on_floor=False, on_object=True)
    judged = physics(
        *furnished(square(), (BOX, on_floor(BOX, 2, 2, bottom=0.5)), (lamp, on_floor(lamp, 2, 2, bottom=1.3)))
    )
    assert judged.supported == {"box-0": False, "lamp-0": False}
    assert judged.reasons[1] == "lamp-0 is not supported: it stands on box-0, which nothing holds."


def test_wall_assets_touch_a_wall_and_nothing_else_will_do():
    for x, held in ((0.02, True), (0.04, True), (0.05, False), (2.0, False)):
        assert physics(*furnished(square(), (PICTURE, Pose(x, 3, 1.5, 0)))).supported["picture-0"] is held
    judged = physics(*furnished(square(), (PICTURE, Pose(0.52, 3, 1.5, 0))))
    assert judged.reasons == ("picture-0 should hang on a wall but its back is 0.50 m from the nearest one.",)
    assert not physics(*furnished(square(), (PICTURE, on_floor(PICTURE, 2, 3)))).supported["picture-0"]


@pytest.mark.parametrize(
    "pose", [Pose(0.02, 3, 1.5, math.pi), Pose(0.3, 3, 1.5, math.pi / 2), Pose(0.3, 3, 1.5, -math.pi / 2)]
)
def test_what_faces_its_wall_or_touches_it_edge_on_does_not_hang_there(pose):
    assert not physics(*furnished(square(), (PICTURE, pose))).supported["picture-0"]


def test_ceiling_assets_hang_at_this_rooms_ceiling():
    for height in (2.4, 3.2):
        room = square(height=height)
        hung = physics(*furnished(room, (PENDANT, on_floor(PENDANT, 2, 2, bottom=height - 0.3))))
        assert hung.supported["pendant-0"]
        low = physics(*furnished(room, (PENDANT, on_floor(PENDANT, 2, 2, bottom=height - 0.4))))
        assert low.reasons == ("pendant-0 hangs 0.10 m below the ceiling instead of from it.",)


def test_nothing_below_two_metres_stands_in_the_landing():
    """The door is from x = 1.0 to 1.9 in the lower wall; its landing ends at y = 0.9."""
    for y, clear in ((1.4, True), (1.39, False)):
        assert physics(*furnished(square(), (BOX, on_floor(BOX, 1.5, y)))).door_clear is clear
    assert physics(*furnished(square(), (BOX, on_floor(BOX, 2.15, 0.5)))).door_clear
    judged = physics(*furnished(square(), (BOX, on_floor(BOX, 1.95, 0.5))))
    assert judged.reasons == ("box-0 takes 0.18 m2 of the landing of door 0.",)
    assert physics(*furnished(square(), (RUG, on_floor(RUG, 1.5, 1)))).door_clear
    high = thing("shelf-0", (0.3, 1.0, 0.3), on_floor=False, on_wall=True)
    assert physics(*furnished(square(), (high, Pose(1.5, 0.15, 2.2, math.pi / 2)))).door_clear
    assert not physics(*furnished(square(), (high, Pose(1.5, 0.15, 2.1, math.pi / 2)))).door_clear


def test_every_unplaced_asset_fails_every_share():
    scene, layout = furnished(square(), (BOX, on_floor(BOX, 3, 2)), (OTHER, None))
    judged = physics(scene, layout)
    assert judged.shares == dict.fromkeys(judged.shares, 0.5)
    assert judged.reasons == ("box-1 is not placed.",)
    nowhere = Layout({**layout, "box-1": Pose(math.nan, 1, 1, 0)})
    assert physics(scene, nowhere).shares == judged.shares


def test_names_that_the_scene_does_not_have_are_ignored():
    scene, layout = furnished(square(), (BOX, on_floor(BOX, 3, 2)))
    assert physics(scene, Layout({**layout, "ghost-0": Pose(3, 2, 0.4, 0)})).ok


def test_an_empty_room_is_sound():
    assert physics(*furnished(square())).ok
