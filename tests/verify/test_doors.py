"""Every door counts: which are asked for, what cuts them off, and what is said of it."""

from __future__ import annotations

from dataclasses import replace

import pytest
from verify_rooms import DISC, DOOR, furnished, on_floor, square, thing

from robolayout.program import Program
from robolayout.run.flow import make_judge
from robolayout.scene import Layout, Opening, Scene
from robolayout.verify import judge_agent, verify

BACK = Opening(wall=2, offset=2.1, width=0.9, height=2.05)
"""In the wall across, at the same x as the first door."""
ARM = replace(DISC, name="arm", reach_distance=0.6)


def divided(gap: float, *, doors: tuple[Opening, ...] = (DOOR, BACK), behind: bool = True) -> tuple[Scene, Layout]:
    """A room that a shelf divides but for a gap, with a box in the back half."""
    shelf, box = thing("shelf-0", (4.0 - gap, 0.4, 1.8), "bookshelf"), thing("box-0", (0.5, 0.5, 0.8))
    placed = [(shelf, on_floor(shelf, (4.0 - gap) / 2, 2.0))]
    return furnished(square(doors=doors), *placed, *([(box, on_floor(box, 3.7, 3.7))] if behind else []), agents=(ARM,))


def test_a_door_behind_a_shelf_is_cut_off_and_the_report_says_by_what_and_what_lies_there():
    report = verify(*divided(0.5))
    assert report.figures["doors_reached"] is False
    assert "doors_reached" in report.unmet
    (sentence,) = [s for s in report.violations if s.startswith("Door 1")]
    head, _, tail = sentence.partition("wall 1. ")
    assert head in (
        f"Door 1 in wall 2 cannot be reached by arm: narrowest passage {width} m, needs 0.60 m, between shelf-0 and "
        for width in ("0.49", "0.50")
    )
    area = float(tail.split()[0])
    assert area == pytest.approx(4.0 * 1.8 - 0.25, abs=0.3)  # the back half without the box, its corners aside
    assert tail == f"{area:.1f} m2 of floor and box-0 can then be reached only from there."
    data = report.to_dict()["agents"]["arm"]["shut_doors"]["1"]
    assert (data["between"], data["only_behind"]) == (["shelf-0"], ["box-0"])


def test_a_door_that_is_reached_is_no_violation():
    report = verify(*divided(0.7))
    assert report.figures["doors_reached"] is True
    assert report.ok


def test_a_cut_off_door_fails_the_report_even_if_nothing_lies_behind_it():
    """A cupboard of floor behind the second door: too little for the walkable ratio to notice."""
    near = Opening(wall=1, offset=3.05, width=0.9, height=2.05)
    left, low = (thing(f"shelf-{i}", size, use_sides=()) for i, size in enumerate([(0.2, 1.05, 1.8), (1.05, 0.1, 1.8)]))
    scene, layout = furnished(
        square(doors=(DOOR, near)),
        (left, on_floor(left, 2.85, 3.475)),
        (low, on_floor(low, 3.475, 2.99)),
        agents=(replace(DISC, reach_distance=1.2),),
    )
    report = verify(scene, layout)
    assert report.figures["walkable_ratio"] > 0.95
    assert report.unmet == ("doors_reached",)
    assert not report.ok
    (sentence,) = report.violations
    assert sentence.startswith(
        "Door 1 in wall 1 cannot be reached by disc: no way to it, not even for a disc of 1 cm, needs 0.60 m"
    )
    assert sentence.endswith("m2 of floor can then be reached only from there.")


def test_a_landing_without_room_to_stand_is_cut_off_too():
    box = thing("box-0", (1.4, 0.8, 0.8))
    report = verify(*furnished(square(doors=(DOOR, BACK)), (box, on_floor(box, 1.45, 3.6)), agents=(ARM,)))
    (sentence,) = [s for s in report.violations if s.startswith("Door 1")]
    assert sentence.endswith("Its landing leaves arm no place to stand.")
    assert "box-0" in sentence


@pytest.mark.parametrize("door", [replace(BACK, width=0.55, offset=2.2), replace(BACK, height=1.4)])
def test_a_door_that_the_body_does_not_fit_through_is_not_asked_for(door: Opening):
    report = verify(*divided(0.5, doors=(DOOR, door)))
    assert report.figures["doors_reached"] is True


def test_a_door_that_is_out_of_the_way_in_the_empty_room_is_not_asked_for():
    from robolayout.scene import Room

    neck = Room(
        (
            (0, 0),
            (3, 0),
            (3, 1.3),
            (3.5, 1.3),
            (3.5, 0),
            (6.5, 0),
            (6.5, 3),
            (3.5, 3),
            (3.5, 1.7),
            (3, 1.7),
            (3, 3),
            (0, 3),
        ),
        2.6,
        (DOOR, Opening(4, 1.0, 0.9, 2.05)),
    )
    assert verify(*furnished(neck, agents=(ARM,))).figures["doors_reached"] is True
    slim = replace(ARM, radius=0.15)
    assert verify(*furnished(neck, agents=(slim,))).figures["doors_reached"] is True
    plug = thing("box-0", (0.4, 0.4, 1.0))
    assert verify(*furnished(neck, (plug, on_floor(plug, 3.25, 1.5)), agents=(slim,))).figures["doors_reached"] is False


def test_the_solvers_judge_counts_a_cut_off_door_and_blames_what_stands_between():
    scene, layout = divided(0.5, behind=False)
    program = Program()
    verdict = make_judge(scene, program)(layout)
    assert verdict.access >= 1.0
    assert "shelf-0" in verdict.culprits
    assert make_judge(*(divided(0.7, behind=False)[0], program))(divided(0.7, behind=False)[1]).access == 0.0


def test_the_page_and_the_table_show_it():
    report = verify(*divided(0.5))
    assert ("doors reached", "no", False) in report.rows()
    assert "| doors reached | no | **short** |" in report.to_markdown()
    assert judge_agent(*divided(0.7), ARM).doors_reached


def test_what_is_reached_with_chairs_aside_is_told_apart_from_what_is_reached_as_it_stands():
    """A table in a corner whose free sides chairs take: nobody gets near it before a chair is moved."""
    table, lamp = (
        thing("table-0", (1.0, 1.0, 0.7), "dining table"),
        thing("cup-0", (0.1, 0.1, 0.1), "cup", on_floor=False, on_object=True),
    )
    chairs = [thing(f"chair-{i}", (0.5, 0.5, 0.9), "dining chair") for i in range(4)]
    spots = ((3.5, 2.7), (2.7, 3.5), (2.7, 2.7), (3.1, 2.2))
    scene, layout = furnished(
        square(),
        (table, on_floor(table, 3.5, 3.5)),
        (lamp, on_floor(lamp, 3.6, 3.6, bottom=0.7)),
        *((chair, on_floor(chair, x, y)) for chair, (x, y) in zip(chairs, spots, strict=True)),
        agents=(replace(DISC, name="arm", reach_distance=1.2),),
    )
    report = verify(scene, layout)
    figures = report.figures
    assert figures["reachable_share"] == pytest.approx(5 / 6)
    assert figures["reachable_share_chairs_aside"] == 1.0
    assert "reachable_share" not in report.unmet
    assert "As it stands, no chair is moved" in report.to_markdown()
