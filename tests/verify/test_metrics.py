"""Published metrics on rooms whose figures can be worked out on paper; a pixel of a 4 m room is 1.6 to 1.7 cm."""

from __future__ import annotations

from dataclasses import replace

import pytest
from verify_rooms import DOOR, furnished, on_floor, square, thing

from robolayout.scene import Asset, Layout, Opening, Pose, Room
from robolayout.verify._boxes import boxes
from robolayout.verify.metrics import layoutvlm, physcene, published_metrics, sceneeval, scenesmith
from robolayout.verify.metrics.sceneeval import accessibility, occlusion

BOX = thing("box-0", (0.5, 1.0, 0.8))
PLATE = thing("plate-0", (0.26, 0.26, 0.02), "plate", on_floor=False, on_object=True)
SHELF = thing("bookshelf-0", (0.3, 1.0, 1.8), "bookshelf")


def divided(gap: float = 0.0, *, y: float = 2.0, room: Room | None = None, height: float = 1.0):
    shelf = thing("shelf-0", (4.0 - gap, 0.4, height))
    return furnished(room or square(), (shelf, on_floor(shelf, (4.0 - gap) / 2, y)))


@pytest.mark.parametrize(("gap", "expected"), [(0.0, 0.5), (0.15, 0.5), (0.3, 1.0)])
def test_sceneeval_nav_is_the_largest_of_the_free_pixels(gap: float, expected: float):
    assert sceneeval(*divided(gap))["NAV"] == pytest.approx(expected, abs=0.02)


def test_sceneeval_nav_has_no_doors_and_ignores_what_hangs_high():
    """Lower part: y from 0.1 to 0.9 less rounding; upper part: 1.5 to 3.9."""
    assert sceneeval(*divided(y=1.2))["NAV"] == pytest.approx(2.4 / 3.2, abs=0.01)
    assert sceneeval(*divided(height=2.0))["NAV"] == pytest.approx(0.5, abs=0.02)
    scene, layout = divided(height=0.8)
    high = {"shelf-0": replace(layout["shelf-0"], z=2.05)}
    assert sceneeval(scene, Layout(high))["NAV"] == 1.0
    full = thing("full-0", (4.0, 4.0, 1.0))
    assert sceneeval(*furnished(square(), (full, on_floor(full, 2, 2))))["NAV"] == 0.0


@pytest.mark.parametrize(("y", "free"), [(3.7, 1.0), (2.5, 0.5), (2.0, 0.0)])
def test_sceneeval_acc_is_the_free_share_in_front_of_a_side(y: float, free: float):
    """The shelf's rectangle is x from 0.35 to 0.55, y from 1.5 to 2.5; a box 1 m wide covers a part of it."""
    box = (BOX, on_floor(BOX, 0.6, y))
    scene, layout = furnished(square(), (SHELF, on_floor(SHELF, 0.15, 2.0)), box)
    scores = accessibility(scene, boxes(scene, layout))
    assert scores["bookshelf-0"] == pytest.approx(free, abs=0.02)


def test_sceneeval_acc_takes_the_best_side_and_leaves_objects_without_out():
    both = replace(SHELF, use_sides=("back", "front"))
    assert sceneeval(*furnished(square(), (both, on_floor(both, 0.15, 2.0))))["ACC"] == 1.0
    back = replace(SHELF, use_sides=("back",))
    assert sceneeval(*furnished(square(), (back, on_floor(back, 0.15, 2.0))))["ACC"] == 0.0
    none = replace(SHELF, use_sides=())
    assert sceneeval(*furnished(square(), (none, on_floor(none, 0.15, 2.0))))["ACC"] == 1.0


@pytest.mark.parametrize(("x", "out"), [(0.26, 0.0), (0.24, 1.0), (3.9, 1.0)])
def test_sceneeval_oob_allows_one_percent_of_the_surface(x: float, out: float):
    """One centimetre out puts a whole face of the box out of bounds."""
    assert sceneeval(*furnished(square(), (BOX, on_floor(BOX, x, 2))))["OOB"] == out


@pytest.mark.parametrize(("overlap", "share"), [(-0.1, 0.0), (0.003, 0.0), (0.02, 1.0)])
def test_sceneeval_col_forgives_what_five_millimetres_undo(overlap: float, share: float):
    other = replace(BOX, name="box-1")
    measured = sceneeval(*furnished(square(), (BOX, on_floor(BOX, 1, 2)), (other, on_floor(other, 1.5 - overlap, 2))))
    assert (measured["COL"], measured["COL_scene"]) == (share, share)


def test_sceneeval_col_sees_surfaces_only():
    small = thing("small-0", (0.2, 0.2, 0.2))
    inside = furnished(square(), (BOX, on_floor(BOX, 2, 2)), (small, on_floor(small, 2, 2, bottom=0.3)))
    assert sceneeval(*inside)["COL"] == 0.0
    table = furnished(square(), (BOX, on_floor(BOX, 2, 2)), (PLATE, on_floor(PLATE, 2.1, 2, bottom=0.8)))
    assert sceneeval(*table)["COL"] == 0.0


def hidden(room: Room, *things: tuple[Asset, Pose]) -> float:
    """Return how much of the only opening is hidden."""
    scene, layout = furnished(room, *things)
    share = occlusion(room, (*room.doors, *room.windows)[0], boxes(scene, layout))
    assert sceneeval(scene, layout)["opening_clearance"] == float(share == 0)
    return share


def test_sceneeval_opening_clearance_is_seen_along_the_normal():
    """The door is 0.9 x 2.05 m from x = 1; the clearance is 0.9 m deep. The box hides 0.4 x 0.8 m of it."""
    box, tall = thing("box-0", (0.4, 0.5, 0.8)), thing("tall-0", (0.4, 0.5, 1.4))
    assert hidden(square(), (box, on_floor(box, 1.25, 0.6))) == pytest.approx(0.4 * 0.8 / (0.9 * 2.05))
    assert hidden(square(), (box, on_floor(box, 1.25, 1.2))) == 0.0
    window = replace(square(), doors=(), windows=(Opening(2, 1.0, 1.0, 1.0, 0.9),))
    assert hidden(window, (box, on_floor(box, 2.5, 3.7))) == 0.0
    assert hidden(window, (tall, on_floor(tall, 2.5, 3.7))) == pytest.approx(0.2)


@pytest.mark.parametrize(("bottom", "held"), [(0.0, 1.0), (0.004, 1.0), (0.006, 0.0), (-0.004, 1.0), (-0.006, 0.0)])
def test_sceneeval_sup_on_the_ground_allows_five_millimetres(bottom: float, held: float):
    assert sceneeval(*furnished(square(), (BOX, on_floor(BOX, 2, 2, bottom=bottom))))["SUP"] == held


@pytest.mark.parametrize(("x", "held"), [(2.0, 1.0), (2.2, 1.0), (2.26, 0.5)])
def test_sceneeval_sup_on_an_object_needs_the_centre_over_its_contacts(x: float, held: float):
    """A plate on a box whose front edge is at x = 2.25; both are objects."""
    scene, layout = furnished(square(), (BOX, on_floor(BOX, 2, 2)), (PLATE, on_floor(PLATE, x, 2, bottom=0.8)))
    assert sceneeval(scene, layout)["SUP"] == held


def test_sceneeval_sup_at_walls_and_ceilings_needs_one_contact():
    picture = thing("picture-0", (0.04, 0.6, 0.5), "picture", on_floor=False, on_wall=True)
    lamp = thing("lamp-0", (0.4, 0.4, 0.3), "ceiling lamp", on_floor=False, on_ceiling=True)
    for gap, held in ((0.0, 1.0), (0.004, 1.0), (0.006, 0.0)):
        scene, layout = furnished(
            square(),
            (picture, replace(on_floor(picture, 0.02 + gap, 2), z=1.5)),
            (lamp, on_floor(lamp, 2, 2, bottom=2.3 - gap)),
        )
        assert sceneeval(scene, layout)["SUP"] == held
    away = furnished(square(), (picture, replace(on_floor(picture, 0.02, 2, 180), z=1.5)))
    assert sceneeval(*away)["SUP"] == 0.0


def test_physcene_walkable_starts_at_each_door():
    """Robot 0.3 m: lower part y from 0.15 to 0.85, upper part 1.55 to 3.85."""
    assert physcene(*divided(y=1.2))["R_walkable"] == pytest.approx(0.7 / 3.0, abs=0.01)
    upper = Opening(2, 1.0, 0.9, 2.05)
    both = replace(square(), doors=(DOOR, upper))
    assert physcene(*divided(y=1.2, room=both))["R_walkable"] == pytest.approx(0.5, abs=0.01)
    blocked = thing("block-0", (1.6, 1.4, 1.0))
    assert physcene(*furnished(square(), (blocked, on_floor(blocked, 1.45, 0.7))))["R_walkable"] == 0.0


def test_physcene_walkable_without_doors_takes_the_largest():
    scene, layout = divided(y=1.2, room=square(doors=()))
    assert physcene(scene, layout)["R_walkable"] == pytest.approx(2.3 / 3.0, abs=0.01)


def test_physcene_reach_weighs_components():
    """The shelf touches both parts, the box only the upper one."""
    shelf = thing("shelf-0", (4.0, 0.4, 1.0))
    scene, layout = furnished(square(), (shelf, on_floor(shelf, 2, 1.2)), (BOX, on_floor(BOX, 2, 3)))
    measured = physcene(scene, layout)
    assert measured["R_reach"] == pytest.approx(1 - 0.5 * measured["R_walkable"])
    assert physcene(*divided())["R_reach"] == pytest.approx(1.0)


def test_physcene_counts_any_overlap_and_any_pixel():
    other = replace(BOX, name="box-1")
    far = replace(BOX, name="box-2")
    apart = furnished(square(), (BOX, on_floor(BOX, 1, 2)), (other, on_floor(other, 1.5, 2)))
    assert (physcene(*apart)["Col_obj"], physcene(*apart)["Col_scene"]) == (0.0, 0.0)
    touching = furnished(
        square(), (BOX, on_floor(BOX, 1, 2)), (other, on_floor(other, 1.499, 2)), (far, on_floor(far, 3.8, 3))
    )
    measured = physcene(*touching)
    assert measured["Col_obj"] == pytest.approx(2 / 3)
    assert measured["Col_scene"] == 1.0
    assert measured["R_out"] == pytest.approx(1 / 3)


def test_layoutvlm_counts_in_percent():
    other, out = replace(BOX, name="box-1"), replace(BOX, name="box-2")
    scene, layout = furnished(
        square(), (BOX, on_floor(BOX, 1, 2)), (other, on_floor(other, 1.2, 2)), (out, on_floor(out, 3.9, 3))
    )
    assert layoutvlm(scene, layout) == {"CF": pytest.approx(100 / 3), "IB": pytest.approx(200 / 3)}


@pytest.mark.parametrize(("gap", "regions", "ratio"), [(0.0, 2, 0.5), (0.25, 2, 0.5), (0.35, 1, 1.0)])
def test_scenesmith_counts_regions_for_a_disc_of_30_cm(gap: float, regions: int, ratio: float):
    measured = scenesmith(*divided(gap))
    assert (measured["regions"], measured["reachability_ratio"]) == (regions, pytest.approx(ratio))
    assert measured["blocking"] == (["shelf-0"] if regions == 2 else [])


def test_only_what_is_placed_is_seen():
    scene, layout = furnished(square(), (BOX, on_floor(BOX, 2, 2)), (PLATE, None))
    alone = furnished(square(), (BOX, on_floor(BOX, 2, 2)))
    assert published_metrics(scene, layout) == published_metrics(*alone)


def test_an_empty_layout_has_figures_too():
    figures = published_metrics(*furnished(square(), (BOX, None)))
    assert figures["SceneEval"]["NAV"] == 1.0
    assert figures["PhyScene"]["R_reach"] == 0.0
    assert figures["LayoutVLM"] == {"CF": 100.0, "IB": 100.0}


def test_metrics_that_count_rugs_say_so_and_are_given_without_them():
    rug, table = thing("rug-0", (2.0, 2.0, 0.01), "rug"), thing("table-0", (1.0, 1.0, 0.7))
    bare = furnished(square(), (table, on_floor(table, 2, 2.5)))
    with_rug = furnished(square(), (table, on_floor(table, 2, 2.5)), (rug, on_floor(rug, 2, 2.5)))
    alone, found = published_metrics(*bare), published_metrics(*with_rug)
    assert set(alone) == {"SceneEval", "PhyScene", "LayoutVLM", "SceneSmith"}
    assert "rugs" not in alone["SceneEval"]
    assert found["PhyScene"]["Col_obj"] == 1.0
    assert found["PhyScene"]["rugs"] == "count as obstacles in Col_obj, Col_scene, R_walkable, R_reach, as published"
    assert found["PhyScene_without_rugs"]["Col_obj"] == 0.0
    for benchmark in ("SceneEval", "PhyScene"):
        without = found[f"{benchmark}_without_rugs"]
        assert without == {name: alone[benchmark][name] for name in without}
