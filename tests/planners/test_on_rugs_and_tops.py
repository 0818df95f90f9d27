"""What is asked onto rugs and tops, several of a kind in rows and rings: it stands there, all of it, and looks like it."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest
import shapely
import shapely.affinity
from tests.planners.said_rooms import made, of
from tests.words.test_several_of_a_kind import LEXICON

import robolayout as rl
from robolayout.planners import scene_from_sentence
from robolayout.run.result import Result
from robolayout.words import read_text, read_words
from running import slow


def foot(result: Result, name: str) -> shapely.Polygon:
    pose, (depth, width, _) = result.layout[name], result.scene.by_name[name].size
    box = shapely.affinity.rotate(shapely.box(-depth / 2, -width / 2, depth / 2, width / 2), pose.yaw, (0, 0), True)
    return shapely.affinity.translate(box, pose.x, pose.y)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "kind", "rug"),
    [
        slow("a library with a reading rug in the middle and five floor cushions on it", "floor_cushion", "rug-0"),
        slow("a kindergarten with a round rug and twelve floor cushions on it", "floor_cushion", "round_rug-0"),
        ("a playroom with four bean bags on a rug", "bean_bag", "rug-0"),
    ],
)
def test_seats_on_a_rug_stand_in_a_ring_on_it(text: str, kind: str, rug: str) -> None:
    result = made(text)
    names = of(result, kind)[: {"bean_bag": 4}.get(kind)]
    middle = shapely.MultiPoint([result.layout[name].at for name in names]).centroid
    away = [middle.distance(shapely.Point(result.layout[name].at)) for name in names]
    assert result.report.ok and max(away) - min(away) < 0.3
    assert all(
        foot(result, name).intersection(foot(result, rug)).area > 0.6 * foot(result, name).area for name in names
    )


@pytest.mark.slow
def test_armchairs_on_a_rug_are_around_the_coffee_table_without_a_sofa_that_nobody_asked_for() -> None:
    result = made("a lounge with four armchairs on a round rug by the window")
    table = shapely.Point(result.layout["coffee_table-0"].at)
    assert not of(result, "sofa") and result.report.ok
    assert all(table.distance(foot(result, name)) < 1.2 for name in of(result, "armchair"))


def test_what_follows_a_rug_with_several_on_it_is_about_the_rug() -> None:
    links = read_text("a sofa and two armchairs on a large rug in front of the fireplace", LEXICON).parsed.links
    assert [(link.relation, [m.thing.noun.kind for m in link.subjects]) for link in links] == [
        ("on", ["sofa", "armchair"]),
        ("front", ["rug"]),
    ]


def test_of_two_kinds_on_each_of_several_each_has_one_of_both() -> None:
    scene, _ = scene_from_sentence("a computer lab with six desks, a monitor and a keyboard on each desk")
    found = [one for row in read_words(scene).rows for demand in row.demands for way in demand.ways for one in way]
    on = [one.asset_names() for one in found if one.name == "on_top_of"]
    for desk in (f"desk-{i}" for i in range(6)):
        assert sorted(a.rsplit("-", 1)[0] for a, b in on if b == desk) == ["keyboard", "monitor"]


@pytest.mark.slow
def test_all_of_a_row_that_fits_before_a_counter_are_before_it() -> None:
    result = made("a sushi bar with a counter and eight stools lined up in front of the counter")
    counter = result.layout["kitchen_counter-0"]
    seen = [counter.seen(result.layout[name].at) for name in of(result, "bar_stool")]
    assert len(seen) == 8 and all(
        x > 0 and abs(y) < result.scene.by_name["kitchen_counter-0"].size[1] / 2 for x, y in seen
    )


@pytest.mark.slow
def test_a_loveseat_at_a_right_angle_shares_the_coffee_table_that_is_in_the_middle_of_both() -> None:
    result = made(
        "a living room with a TV, a sofa opposite the TV, a loveseat at a right angle to the sofa "
        "and a coffee table in the middle of them"
    )
    table = foot(result, "coffee_table-0")
    turned = math.degrees(result.layout["loveseat-0"].yaw - result.layout["sofa-0"].yaw) % 180.0
    assert turned == pytest.approx(90.0, abs=10.0) and not [row for row in result.report.asked if row.verdict != "met"]
    assert max(table.distance(foot(result, name)) for name in ("sofa-0", "loveseat-0")) <= 0.6


@pytest.mark.parametrize(
    "text",
    [
        "a storage room with three shelves along the wall and six cardboard boxes on the shelves",
        slow("a toy store with ten shelves in rows and three teddy bears on one of the shelves"),
        slow(
            "two armchairs before a fireplace with a small side table between them, a book stack and a cup on the side table"
        ),
    ],
)
def test_several_on_a_top_that_holds_them_stand_side_by_side(text: str) -> None:
    assert made(text).report.ok


@pytest.mark.slow
def test_shelves_in_rows_are_rows_and_no_strays() -> None:
    result = made("a toy store with ten shelves in rows")
    first = result.layout["shop_shelf-0"]
    ahead = [round(first.seen(result.layout[name].at)[0], 1) for name in of(result, "shop_shelf")]
    assert min(ahead.count(x) for x in ahead) > 1


def test_who_has_a_laptop_has_no_monitor_besides() -> None:
    alone, _ = scene_from_sentence("a laptop and a mug are on the desk")
    two, _ = scene_from_sentence("an office for two with a laptop on one of the desks")
    kinds = [[asset.category for asset in scene.assets] for scene in (alone, two)]
    assert [found.count("monitor") for found in kinds] == [found.count("keyboard") for found in kinds] == [0, 1]


@pytest.mark.parametrize("seed", [0, slow(1), slow(2)])
def test_no_window_is_where_a_screen_hangs_at_the_head_of_a_table(seed: int) -> None:
    result = rl.generate("a boardroom, 8 x 5 m, with a TV on the wall at the head of the table", seed=seed)
    room = result.scene.room
    assert {room.walls[one.wall].length for one in room.windows} == {8.0} and result.report.ok


@pytest.mark.slow
def test_a_coffee_table_in_the_middle_of_the_room_keeps_its_sofa_before_it() -> None:
    run = rl.generate("A living room with a sofa and a coffee table in the middle of the room", seed=0)
    sofa, table = run.layout["sofa-0"], run.layout["coffee_table-0"]
    dx, dy = table.x - sofa.x, table.y - sofa.y
    ahead, aside = (
        dx * math.cos(sofa.yaw) + dy * math.sin(sofa.yaw),
        -dx * math.sin(sofa.yaw) + dy * math.cos(sofa.yaw),
    )
    assert 0.8 < ahead < 1.6 and abs(aside) < 0.3
    (row,) = [row for row in run.report.asked if row.kind == "relation"]
    assert row.verdict == "met"


@pytest.mark.slow
def test_a_rug_in_the_middle_of_the_room_lies_under_its_coffee_table() -> None:
    run = rl.generate("A living room with a rug in the middle of the room", seed=0)
    assert foot(run, "coffee_table-0").difference(foot(run, "rug-0")).area < 0.05


@pytest.mark.slow
def test_a_television_in_the_corner_lets_its_sofa_stand_off_its_middle() -> None:
    run = rl.generate("A living room with the TV in the corner", seed=0)
    sofa, screen = run.layout["sofa-0"], run.layout["television-0"]
    ahead = (screen.x - sofa.x) * math.cos(sofa.yaw) + (screen.y - sofa.y) * math.sin(sofa.yaw)
    assert run.report.ok and ahead > 1.0


def test_a_table_with_chairs_all_around_is_near_its_corner() -> None:
    run = rl.generate("A dining room with the table in the corner", seed=0)
    corners = [math.dist(at, run.layout["dining_table-0"].at) for at in run.scene.room.vertices]
    assert min(corners) < 2.2 and {row.verdict for row in run.report.asked} == {"met"}


def test_a_sofa_at_the_foot_of_a_bed_looks_away_from_it() -> None:
    run = rl.generate("A bedroom with a sofa at the foot of the bed", seed=0)
    assert math.cos(run.layout["sofa-0"].yaw - run.layout["bed-0"].yaw) > 0.99


def test_what_is_before_each_seat_stands_on_the_table_of_that_seat() -> None:
    run = rl.generate(
        "A podcast room with a table, four chairs around the table and a microphone in front of every chair"
    )
    table = foot(run, "dining_table-0")
    assert all(table.contains(foot(run, f"microphone-{i}")) for i in range(4)) and run.report.ok


@pytest.mark.slow
def test_a_camera_stands_on_a_tripod() -> None:
    run = rl.generate("A photo studio with an armchair and a camera on a tripod in front of the armchair")
    assert run.report.ok and foot(run, "tripod-0").contains(foot(run, "camera-0"))


def test_a_table_is_not_as_long_as_chairs_in_rows_need() -> None:
    scene, _ = rl.scene_from_sentence("three rows of five chairs facing a lectern and a table near the door")
    assert max(scene.by_name["dining_table-0"].size) < 2.0


@pytest.mark.slow
def test_desks_in_a_row_have_room_for_the_partitions_between_them() -> None:
    run = rl.generate("An office with four desks in a row with partitions between them")
    assert {row.verdict for row in run.report.asked} == {"met"}
    assert len({round(run.layout[f"desk-{i}"].yaw, 2) for i in range(4)}) == 1


@pytest.mark.parametrize(
    "text",
    [
        slow("a dumbbell rack and dumbbells on the dumbbell rack"),
        slow("a lectern and a laptop on the lectern"),
        slow("a host stand and a lamp on the host stand"),
        slow("a plant stand and potted plants on the plant stand"),
        slow("a plant stand and flower buckets on the plant stand"),
        "a produce stand and fruit on the produce stand",
        slow("a pallet rack and boxes on the pallet rack"),
        slow("a grand piano and a vase on the grand piano"),
        "a radiator and a vase on the radiator",
        slow("a cabinet and a fish tank on the cabinet"),
    ],
)
def test_what_is_drawn_on_a_thing_makes_room_for_what_is_put_there(text: str) -> None:
    run = rl.generate(f"A room with {text}", seed=0)
    assert run.report.ok and {row.verdict for row in run.report.asked} == {"met"}


@pytest.mark.parametrize(
    ("text", "drawn"),
    [
        ("a clothes rack with shirts", "clothes"),
        ("a coat rack with coats on it", "clothes"),
        ("towels on the towel rack", "towel"),
        ("an easel with a painting on it", "picture"),
        ("a music stand with sheet music", "blanket"),
    ],
)
def test_what_is_drawn_on_a_thing_is_no_thing_of_its_own(text: str, drawn: str) -> None:
    scene, found = scene_from_sentence(f"A shop with {text}")
    assert drawn not in found.wished and len(scene.assets) > 1


def test_a_vase_alone_gets_a_table() -> None:
    run = rl.generate("A room with a vase", seed=0)
    assert foot(run, "side_table-0").contains(foot(run, "vase-0").centroid) and run.report.ok


@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        ("a storage room with three crates stacked in the corner", "crate", 3),
        slow("a warehouse with a stack of four pallets in the corner", "pallet", 4),
        ("a walk-in wardrobe with two suitcases stacked in the corner", "suitcase", 2),
    ],
)
def test_what_is_piled_stands_on_each_other_and_nothing_between(text: str, kind: str, count: int) -> None:
    result = made(text)
    pile = sorted(of(result, kind), key=lambda name: result.layout[name].z)
    assert result.report.ok
    assert len(pile) == count
    for below, above in pairwise(pile):
        assert math.dist(result.layout[below].at, result.layout[above].at) < 0.11
        assert result.layout[above].z > result.layout[below].z


@pytest.mark.slow
def test_a_soundbar_under_a_television_on_the_wall_stands_on_what_is_below_that() -> None:
    result = made("a living room with a TV on the wall and a soundbar under the TV")
    bar, screen, stand = (result.layout[name] for name in ("soundbar-0", "television-0", "tv_stand-0"))
    assert result.report.ok
    assert bar.z < screen.z
    assert math.dist(bar.at, screen.at) < 0.5
    assert math.dist(bar.at, stand.at) < 0.4


@pytest.mark.slow
def test_a_projector_that_is_said_to_hang_hangs_from_the_ceiling() -> None:
    result = made("a classroom with ten desks and a projector hanging from the ceiling")
    (name,) = of(result, "projector")
    room, height = result.scene.room, result.scene.by_name[name].size[2]
    assert result.report.ok
    assert result.layout[name].z + height / 2 == pytest.approx(room.wall_height, abs=0.05)


@pytest.mark.slow
def test_a_reception_desk_along_a_wall_leaves_room_for_who_sits_behind_it() -> None:
    result = made("a lobby with a reception desk along the back wall with two computers on it")
    desk = result.layout["reception_desk-0"]
    (wall,) = [one for one in result.scene.room.walls if one.normal[1] < -0.9]  # north is the back
    x, y = wall.start
    away = (desk.x - x) * wall.normal[0] + (desk.y - y) * wall.normal[1]
    assert result.report.ok
    assert 0.8 < away < 2.1
    assert desk.forward[1] == pytest.approx(-1.0, abs=0.1)
