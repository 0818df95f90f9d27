"""Proofs and remedies: each claim is confirmed by hand or by trying everything."""

from __future__ import annotations

import itertools
from dataclasses import replace

import pytest
from verify_rooms import DISC, DOOR, furnished, on_floor, square, thing

from robolayout import generate, load_agent, load_scene
from robolayout._errors import SceneError
from robolayout.scene import Layout, Opening, Room, Scene
from robolayout.verify import navigation, usage, verify
from robolayout.verify.proofs import exempt_from_reach, exempt_from_use, impossible, kept_out, overfull, remedies

ARM = replace(DISC, name="arm", reach_distance=0.6, reach_low=0.4, reach_high=1.2)
BOX = thing("box-0", (0.5, 1.0, 0.8))


def barrier(*lengths: float):
    """Shelves 0.4 m deep in a row at y = 2, from the left wall on, and a box behind them."""
    placed, at = [(BOX, on_floor(BOX, 2, 3.4))], 0.0
    for i, length in enumerate(lengths):
        shelf = thing(f"shelf-{i}", (length, 0.4, 1.8))
        placed.append((shelf, on_floor(shelf, at + length / 2, 2.0)))
        at += length
    return furnished(square(), *placed)


def test_one_shelf_of_two_in_a_row_stands_in_the_way():
    found = remedies(navigation(*barrier(2.0, 1.9)))
    assert found.removals == {"box-0": (("shelf-0",), ("shelf-1",))}
    assert found.sentences(DISC)[0] == "disc would reach box-0 without shelf-0, or without shelf-1."
    (pair, missing), *others = found.gaps.items()
    assert (pair, others) == (("shelf-1", "wall 1"), [])
    assert missing == pytest.approx(0.5, abs=0.011)
    assert f"shelf-1 and wall 1 stand {missing:.2f} m too close together for disc." in found.sentences(DISC)
    assert found.largest_disc == pytest.approx(0.1, abs=0.011)
    assert found.margin == pytest.approx(0.5, abs=0.011)


def test_two_rows_need_two_removals():
    scene, layout = barrier(4.0)
    second = thing("row-0", (4.0, 0.1, 1.8))
    poses = {**layout, "row-0": on_floor(second, 2, 2.6)}
    found = remedies(navigation(Scene(scene.room, (*scene.assets, second)), Layout(poses), DISC))
    assert found.removals["box-0"] == (("shelf-0", "row-0"),)
    assert found.removals["row-0"] == (("shelf-0",),)


def test_removals_agree_with_trying_every_set():
    scene, layout = barrier(1.3, 0.3, 2.2)
    nav = navigation(scene, layout)

    def reached_without(*names: str) -> bool:
        kept = [asset for asset in scene.assets if asset.name not in names]
        return navigation(replace(scene, assets=tuple(kept)), layout).reached["box-0"]

    others = [asset.name for asset in scene.assets if asset.name != "box-0"]
    sizes = [[s for s in itertools.combinations(others, size) if reached_without(*s)] for size in (1, 2)]
    assert remedies(nav).removals["box-0"] == tuple(next(found for found in sizes if found))


def test_what_stands_on_a_removed_asset_goes_with_it():
    scene, layout = barrier(4.0)
    lamp = thing("lamp-0", (0.3, 0.3, 0.5), on_floor=False, on_object=True)
    tall = replace(DISC, height=2.0)
    poses = {**layout, "lamp-0": on_floor(lamp, 2, 2, bottom=1.8)}
    found = remedies(navigation(Scene(scene.room, (*scene.assets, lamp)), Layout(poses), tall))
    assert found.removals["box-0"] == (("shelf-0",),)


def test_where_all_is_reached_there_is_nothing_to_mend():
    found = remedies(navigation(*furnished(square(), (BOX, on_floor(BOX, 2, 3)))))
    assert (found.removals, found.sentences(DISC)) == ({}, ())


def test_an_arm_too_short_is_not_helped_by_removals():
    table, cup = thing("table-0", (2.0, 2.0, 0.7)), thing("cup-0", (0.1, 0.1, 0.1), on_floor=False, on_object=True)
    nav = navigation(
        *furnished(square(5.0), (table, on_floor(table, 2.5, 2.5)), (cup, on_floor(cup, 2.5, 2.5, bottom=0.7))), ARM
    )
    (first, *_) = remedies(nav).sentences(ARM)
    assert first == "arm would reach cup-0 only if it stood elsewhere, by more than two removals or a longer reach."


def test_what_itself_blocks_the_door_is_said_to_belong_elsewhere():
    room = square(4.0, doors=(Opening(0, 1.5, 0.9, 2.0),))
    bed = thing("bed-0", (2.0, 2.0, 0.5))
    nav = navigation(*furnished(room, (bed, on_floor(bed, 2.0, 1.05))), ARM)
    (first, *_) = remedies(nav).sentences(ARM)
    assert first == "arm would reach bed-0 only if it stood elsewhere, by more than two removals or a longer reach."


def test_a_body_without_an_arm_is_not_asked_to_reach_what_stands_on_things():
    lamp = thing("lamp-0", (0.2, 0.2, 0.4), on_floor=False, on_object=True)
    rug = thing("rug-0", (1.0, 1.0, 0.02))
    scene = Scene(square(), (BOX, lamp, rug))
    assert exempt_from_reach(scene, DISC) == {"lamp-0": "disc has no arm and lamp-0 does not stand on the floor"}
    assert exempt_from_reach(scene, ARM) == {}


def test_what_ends_below_reach_on_the_floor_need_not_be_used():
    low = thing("low-0", (0.5, 0.5, 0.3))
    movable = thing("book-0", (0.2, 0.2, 0.1), on_object=True)
    scene = Scene(square(), (BOX, low, movable))
    assert exempt_from_use(scene, ARM) == {"low-0": "low-0 ends 0.30 m high and arm reaches down to 0.40 m"}


@pytest.mark.parametrize("body", ["child_6", "wheelchair", "turtlebot4"])
def test_a_report_excuses_what_is_excused_in_any_layout(body: str):
    result = generate(load_scene("examples/bedroom.json").with_agents(load_agent(body)))
    (report,) = result.report.agents
    assert dict(report.exempt) == exempt_from_use(result.scene, report.agent)
    asked = result.scene.by_name.keys() - report.exempt.keys()
    reached, usable = report.navigation.reached, report.usage.usable
    assert set(report.short) == {name for name in asked if not (reached[name] and usable[name])}


def test_a_body_wider_or_higher_than_the_door_or_the_room():
    scene = Scene(square(), ())
    assert impossible(scene, DISC) == ()
    assert impossible(scene, replace(DISC, radius=0.5)) == (
        "Door 0 is 0.90 m wide, disc needs 1.00 m: it cannot come in.",
    )
    assert impossible(scene, replace(DISC, length=1.2, width=0.92))[0].startswith(
        "Door 0 is 0.90 m wide, disc needs 0.92"
    )
    assert impossible(scene, replace(DISC, radius=0.5, length=1.2, width=0.8)) == ()
    assert impossible(scene, replace(DISC, height=2.3)) == (
        "Door 0 is 2.05 m high, disc is 2.30 m: it cannot come in.",
    )
    assert "The room is 2.60 m high, disc is 3.00 m: it cannot stand in it." in impossible(
        scene, replace(DISC, height=3.0)
    )


def test_a_room_too_small_for_the_body():
    narrow = Scene(square(1.0, doors=(Opening(0, 0.1, 0.8, 2.05),)), ())
    assert impossible(narrow, replace(DISC, radius=0.6, width=0.5, length=1.0)) == (
        "disc needs 1.20 m; the largest disc that fits into the empty room is 1.00 m wide.",
    )


def test_a_floor_too_small_for_its_furniture():
    big = [thing(f"big-{i}", (2.0, 2.0, 0.8)) for i in range(4)]
    assert impossible(Scene(square(doors=()), tuple(big)), DISC) == ()
    assert impossible(Scene(square(doors=(DOOR,)), tuple(big)), DISC) == (
        "The 4 assets that stand on the floor cover 16.00 m2, the floor outside door landings has 15.19 m2: they cannot all "
        "stand apart. Most is taken by 4 x thing (16.00 m2). Leave out big-0, or give the room 16.9 m2 or more.",
    )


def test_only_what_must_stand_on_the_floor_is_counted():
    flags = ({"on_object": True}, {"on_wall": True}, {"on_ceiling": True})
    others = [thing(f"other-{i}", (3.0, 3.0, 0.5), **flag) for i, flag in enumerate(flags)]
    rugs = [thing(f"rug-{i}", (3.0, 3.0, 0.01), "rug") for i in range(5)]
    assert overfull(Scene(square(), (*others, *rugs))) == ()


def test_what_to_leave_out_of_an_overfull_room_is_as_little_as_will_do():
    tables = [thing(f"table-{i}", (1.0, 1.6, 0.75), "dining table") for i in range(25)]
    chairs = [thing(f"chair-{i}", (0.5, 0.5, 0.9), "chair") for i in range(4)]
    scene = Scene(square(), (*chairs, *tables))
    (sentence,) = overfull(scene)
    assert "25 x dining table (40.00 m2), 4 x chair (0.14 m2)" in sentence
    assert "Leave out table-0, table-1, table-2 and 13 more, or give the room 41.0 m2 or more." in sentence
    assert overfull(Scene(square(), (*chairs, *tables[16:]))) == ()
    assert overfull(Scene(square(), (*chairs, *tables[15:]))) != ()


def test_an_overfull_room_is_refused_before_any_search():
    tables = tuple(thing(f"table-{i}", (1.0, 1.6, 0.75), "dining table") for i in range(25))
    with pytest.raises(SceneError, match=r"25 assets that stand on the floor cover 40.00 m2, .* has 15.19 m2"):
        generate(Scene(square(), tables))


def test_a_body_that_passes_the_door_but_not_the_wall_behind_it():
    """A closet 0.5 m deep behind the door: the rest of the room lies round the corner."""
    room = Room(
        ((0, 0), (4, 0), (4, 5), (2, 5), (2, 0.5), (0, 0.5)),
        2.6,
        (Opening(wall=0, offset=0.1, width=0.9, height=2.05),),
    )
    scene = Scene(room, (BOX,), agents=(DISC,))
    (sentence,) = impossible(scene, DISC)
    assert sentence.startswith(
        "Even in the empty room disc cannot come in by door 0: the room leaves a disc of 0.50 m "
    )
    assert kept_out(scene, replace(DISC, radius=0.24)) == ()
    report = verify(scene, Layout({"box-0": on_floor(BOX, 3, 3)}))
    assert report.violations[0] == sentence
    assert not any("landing of door 0 is blocked" in said or "0%" in said for said in report.violations)


def test_an_arm_at_the_shoulder_is_not_asked_for_what_ends_below_it():
    """Shoulder at 1.0 m, reach 0.45 m: the arm ends at 0.55 m, whatever reach_low says."""
    body = replace(ARM, reach_distance=0.45, shoulder_height=1.0, reach_low=0.3)
    low = thing("low-0", (0.5, 0.5, 0.5))
    scene, layout = furnished(square(), (low, on_floor(low, 2, 2)), agents=(body,))
    assert exempt_from_use(scene, body) == {"low-0": "low-0 ends 0.50 m high and arm reaches down to 0.55 m"}
    reason = usage(scene, layout).uses["low-0"].reason
    assert reason == "it is 0.50 m below the shoulder at 1.00 m, reach is 0.45 m: 0.05 m too low"


def test_a_body_that_cannot_come_in_is_not_helped_by_removing_furniture():
    shelf = thing("bookshelf-0", (0.3, 1.0, 1.8), "bookshelf")
    scene, layout = furnished(square(), (shelf, on_floor(shelf, 0.15, 2.5)))
    report = verify(scene, layout, agent="forklift")
    assert any("it cannot come in" in sentence for sentence in report.violations)
    assert report.agents[0].remedies.removals == {} and "What would help" not in report.to_markdown()
