"""What stands in a body's way: parts of furniture at its heights, worked out by hand or from the meshes themselves."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely
from verify_rooms import DISC, furnished, on_floor, square, thing

from robolayout.assets.meshes import parts
from robolayout.scene import Agent, Asset, Pose, load_agent
from robolayout.verify import Navigation, heading_space, navigation, usage
from robolayout.verify._boxes import boxes
from robolayout.verify._obstacles import obstacles, part_rectangles
from robolayout.verify.proofs import remedies

VACUUM, CAT, DOG, CHILD, WHEELCHAIR = map(load_agent, ("robot_vacuum", "cat", "dog_medium", "child_6", "wheelchair"))
BED = thing("bed-0", (2.15, 1.6, 1.0), "bed")
TABLE = thing("dining_table-0", (0.9, 1.6, 0.75), "dining table")
LOFT = thing("loft_bed-0", (2.05, 1.05, 1.9), "loft bed")


def nav_of(asset: Asset, agent: Agent, degrees: float = 0.0) -> Navigation:
    return navigation(*furnished(square(), (asset, on_floor(asset, 2, 2.4, degrees)), agents=(agent,)))


def middle_is_free(nav: Navigation) -> bool:
    return bool(nav.main.intersects(shapely.Point(2, 2.4)))


@pytest.mark.parametrize(
    ("asset", "agent", "passes"),
    [
        (BED, VACUUM, True),
        (BED, CAT, False),
        (BED, WHEELCHAIR, False),
        (TABLE, CAT, True),
        (TABLE, DOG, True),
        (TABLE, CHILD, False),
        (LOFT, DOG, True),
        (LOFT, WHEELCHAIR, False),
    ],
    ids=lambda value: getattr(value, "name", str(value)),
)
def test_who_passes_under_what(asset: Asset, agent: Agent, passes: bool):
    for degrees in (0.0, 33.0, 90.0):
        assert middle_is_free(nav_of(asset, agent, degrees)) is passes


def test_a_low_robot_passes_under_a_shelf_on_the_wall_and_a_tall_one_does_not():
    shelf = thing("shelf-0", (0.4, 3.9, 0.3), "wall shelf", on_floor=False, on_wall=True)
    box = thing("box-0", (0.3, 0.3, 0.3))
    for height, passes in ((1.1, True), (1.3, False)):
        agent = replace(DISC, height=height)
        scene, layout = furnished(square(), (shelf, Pose(2, 2, 1.35, math.pi / 2)), (box, on_floor(box, 2, 3.5)))
        assert navigation(scene, layout, agent).reached["box-0"] is passes


def test_legs_are_where_the_mesh_has_them():
    rectangles = part_rectangles(TABLE, 0.03, 0.30)
    legs = [part.vertices for part in parts(TABLE) if part.name == "leg"]
    assert rectangles is not None and len(rectangles) == len(legs) == 4
    expected = {tuple(np.round([*leg.min(axis=0)[:2], *leg.max(axis=0)[:2]], 9)) for leg in legs}
    assert {tuple(np.round(row, 9)) for row in rectangles} == expected


def test_the_free_space_under_a_table_is_the_floor_less_four_grown_legs():
    """Four legs 4.5 cm wide, 1 cm in from the edges; the cat's centre keeps 7.5 cm from each."""
    nav = nav_of(TABLE, CAT)
    legs = shapely.union_all([shapely.box(*row) for row in part_rectangles(TABLE, 0.03, 0.30)])
    placed = shapely.affinity.translate(legs, 2, 2.4).buffer(CAT.radius, quad_segs=64)
    expected = shapely.box(0.075, 0.075, 3.925, 3.925).difference(placed)
    assert nav.free.symmetric_difference(expected).area < 2e-4


def test_a_body_higher_than_a_thing_meets_its_box():
    for asset, height in ((TABLE, 0.76), (BED, 1.01)):
        found = obstacles(boxes(*furnished(square(), (asset, on_floor(asset, 2, 2)))), replace(DISC, height=height))
        assert len(found.shapes) == 1 and not found.partial.any() and not len(found.shelter)
        assert found.shapes[0].area == pytest.approx(asset.size[0] * asset.size[1])


def test_what_is_nearly_full_is_its_box():
    wardrobe = thing("wardrobe-0", (0.6, 1.2, 2.1), "wardrobe")
    assert part_rectangles(wardrobe, 0.03, 1.5) is None


def test_parts_below_the_step_and_above_the_head_do_not_count():
    lamp = thing("lamp-0", (0.4, 0.4, 1.6), "floor lamp")
    area = [_area(part_rectangles(lamp, low, high)) for low, high in ((0.0, 1.2), (0.0, 1.59))]
    assert area[0] < 0.9 * area[1]
    cart = thing("cart-0", (0.6, 0.9, 0.9), "platform cart")
    found = part_rectangles(cart, 0.3, 0.6)
    assert found is None or _area(found) < 0.9 * 0.6 * 0.9


def _area(rectangles: np.ndarray | None) -> float:
    return 0.16 if rectangles is None else shapely.union_all([shapely.box(*row) for row in rectangles]).area


def test_a_taller_body_meets_more_of_a_thing():
    for asset in (BED, TABLE, LOFT):
        heights = np.arange(0.05, asset.size[2], 0.1)
        shapes = [part_rectangles(asset, 0.02, float(h)) for h in heights]
        areas = [asset.size[0] * asset.size[1] if s is None else _area(s) for s in shapes]
        assert all(low <= high + 1e-9 for low, high in pairwise(areas))


def test_pockets_inside_furniture_are_no_floor_that_is_cut_off():
    """A dog cannot get between the bars of a playpen; what is inside counts as the playpen's, not as floor."""
    pen = thing("playpen-0", (1.4, 1.4, 0.75), "playpen")
    nav = nav_of(pen, replace(DOG, length=None, width=None, radius=0.15))
    assert not middle_is_free(nav)
    assert nav.walkable_ratio == 1.0


def test_floor_behind_furniture_that_is_cut_off_still_counts():
    shelf = thing("shelf-0", (4.0, 0.4, 1.8), "bookshelf")
    nav = navigation(*furnished(square(), (shelf, on_floor(shelf, 2.0, 2.0))), VACUUM)
    assert nav.walkable_ratio == pytest.approx(0.5, abs=0.01)


def test_a_passage_between_two_legs_names_the_thing_once():
    """Two shelves leave 0.55 m, which a table fills: the way leads between its legs."""
    table, box = thing("dining_table-0", (0.4, 0.55, 0.7), "dining table"), thing("box-0", (0.3, 0.3, 0.3))
    left, right = (thing(f"shelf-{i}", (1.725, 0.4, 1.8)) for i in range(2))
    scene, layout = furnished(
        square(),
        (left, on_floor(left, 0.8625, 2.0)),
        (right, on_floor(right, 4 - 0.8625, 2.0)),
        (table, on_floor(table, 2.0, 2.0, 90)),
        (box, on_floor(box, 2.0, 3.4)),
    )
    legs = part_rectangles(table, 0.03, 0.30)
    apart = 2 * legs[legs[:, 1] > 0, 1].min()
    nav = navigation(scene, layout, CAT)
    passage = nav.passages["box-0"]
    assert nav.reached["box-0"] and passage.width == pytest.approx(apart, abs=0.0101)
    assert passage.between == ("dining_table-0", "dining_table-0")
    assert passage.sides == "parts of dining_table-0"
    assert math.dist(*passage.ends) == pytest.approx(apart, abs=0.011)
    wide = replace(CAT, radius=0.25)
    found = remedies(navigation(scene, layout, wide))
    assert ("dining_table-0",) in found.removals["box-0"]
    assert not any(len(set(pair)) == 1 for pair in found.gaps)


def test_nobody_takes_a_cup_from_under_its_table():
    """An arm of 0.5 m at 0.7 m height would reach a cup in the middle through the top; over the edge it does not."""
    table = thing("dining_table-0", (1.6, 1.6, 0.75), "dining table")
    cup = thing("cup-0", (0.1, 0.1, 0.1), "cup", on_floor=False, on_object=True)
    low = Agent("low", 0.2, 0.6, reach_distance=0.5, reach_low=0.0, reach_high=1.0)
    for x, usable in ((2.0, False), (1.4, True)):
        scene, layout = furnished(square(), (table, on_floor(table, 2, 2.4)), (cup, on_floor(cup, x, 2.4, bottom=0.75)))
        judged = usage(scene, layout, low)
        assert judged.usable["cup-0"] is usable
        if usable:
            assert judged.uses["cup-0"].stand[0] <= 1.2 + 1e-6


def test_a_rectangular_body_drives_between_legs_it_fits_between():
    """A dog 0.30 m wide between the legs of a table, not between those of a stool."""
    for size, passes in (((0.9, 1.6, 0.75), True), ((0.36, 0.36, 0.75), False)):
        table = thing("dining_table-0", size, "dining table")
        scene, layout = furnished(square(), (table, on_floor(table, 1.45, 2.4)), agents=(DOG,))
        space = heading_space(scene, layout, DOG)
        assert any(region.intersects(shapely.Point(1.45, 2.4)) for region in space.standing) is passes


def mesh_table(path: Path, *, joined: bool) -> Path:
    """A table 1.2 x 0.8 x 0.7 m, y up as in a GLB: as one mesh or as five."""
    import trimesh

    boxes_ = [trimesh.creation.box((1.2, 0.05, 0.8), trimesh.transformations.translation_matrix((0, 0.675, 0)))]
    for x in (-0.57, 0.57):
        for z in (-0.37, 0.37):
            boxes_.append(
                trimesh.creation.box((0.06, 0.65, 0.06), trimesh.transformations.translation_matrix((x, 0.325, z)))
            )
    made = trimesh.util.concatenate(boxes_) if joined else trimesh.Scene(boxes_)
    made.export(path)
    return path


@pytest.mark.parametrize("joined", [True, False])
def test_an_own_mesh_has_legs_too(tmp_path: Path, joined: bool):
    table = replace(TABLE, size=(0.8, 1.2, 0.7), path=mesh_table(tmp_path / "table.glb", joined=joined))
    rectangles = part_rectangles(table, 0.03, 0.30)
    assert rectangles is not None and len(rectangles) == 4
    assert np.ptp(rectangles.reshape(-1, 2, 2), axis=1) == pytest.approx(0.06, abs=1e-3)
    assert np.abs(rectangles).max(axis=0) == pytest.approx((0.4, 0.6, 0.4, 0.6), abs=1e-3)
    assert middle_is_free(nav_of(table, CAT)) and not middle_is_free(nav_of(table, CHILD))


def test_a_mesh_that_cannot_be_read_stands_as_its_box(tmp_path: Path):
    (tmp_path / "broken.glb").write_bytes(b"no mesh")
    table = replace(TABLE, path=tmp_path / "broken.glb")
    assert part_rectangles(table, 0.03, 0.30) is None
