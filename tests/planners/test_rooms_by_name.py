"""Rooms of which little more than a name or a thing is said, and seats for so many, measured on what stands there."""

from __future__ import annotations

import math
from collections import Counter

import pytest
from said_rooms import made, of

import robolayout as rl
from robolayout.words import read_rooms, read_words
from running import slow


def there(text: str) -> Counter[str]:
    scene, _ = rl.scene_from_sentence(text)
    return Counter(asset.name.rsplit("-", 1)[0] for asset in scene.assets)


@pytest.mark.parametrize(
    ("text", "things"),
    [
        ("a break room", {"dining_table": 1, "chair": 4, "fridge": 1, "kitchen_counter": 1}),
        ("a dorm room for two", {"single_bed": 2, "desk": 2}),
        ("a hostel room", {"bunk_bed": 2, "locker": 4}),
        ("a prison cell", {"single_bed": 1, "toilet": 1, "washbasin": 1}),
        ("a kindergarten", {"kids_table": 3, "kids_chair": 12}),
        ("an operating room", {"examination_table": 1, "patient_monitor": 1}),
        ("a laundromat", {"washing_machine": 5, "clothes_dryer": 4}),
        ("an art studio", {"easel": 2}),
        ("a recording studio", {"desk": 1, "speaker": 2}),
        ("a locker room", {"locker": 6, "bench": 2}),
        ("a wine cellar", {"wine_rack": 4}),
        ("a boutique", {"clothes_rack": 4, "mannequin": 2}),
        ("a therapy room", {"sofa": 1, "armchair": 1}),
        ("a call center", {"desk": 6, "office_chair": 6}),
    ],
)
def test_a_room_of_which_only_the_name_is_said_has_what_it_is_for(text: str, things: dict[str, int]) -> None:
    found = there(text)
    assert {kind: found[kind] for kind in things} == things


@pytest.mark.parametrize(
    ("text", "room"),
    [
        ("a bathtub", "bathroom"),
        ("a crib", "children's room"),
        ("a pool table", "game room"),
        ("a washing machine", "laundry room"),
        ("a desk with a lamp and a chair in front of it", "office"),  # a computer room with a server rack
        ("an armchair with a lamp", "living room"),  # a care home, for an older adult with a walker
        ("a hospital bed", "hospital room"),
        ("a plant", "room"),
        ("a mirror and a dresser", "bedroom"),  # a yoga studio
        ("lockers along the wall", "dressing room"),  # an open plan office
        ("a vending machine and a bench", "room"),
        ("a ballroom", "room"),  # a box of that name
    ],
)
def test_one_thing_tells_of_its_room(text: str, room: str) -> None:
    assert rl.scene_from_sentence(text)[1].room_type == room


def test_what_tells_of_a_room_tells_of_no_other_one() -> None:
    told = Counter(kind for room in read_rooms().rooms.values() for kind in room.telling)
    assert max(told.values()) == 1


@pytest.mark.parametrize(
    ("text", "things"),
    [
        ("a living room with seating for eight", {"sofa": 2, "armchair": 2}),
        (
            "a living room with a sofa and two armchairs, seating for six",
            {"sofa": 1, "armchair": 2, "chair": 0},
        ),  # and 12 chairs
        ("a kitchen with an island and seating for four", {"bar_stool": 4, "chair": 0}),
        ("a kitchen with an island with seating for four", {"bar_stool": 4, "chair": 0}),
        ("a kitchen for four", {"chair": 4, "dining_table": 1}),  # four chairs and no table
        ("a living room with a dining area", {"chair": 4, "dining_table": 1}),  # eight chairs
        (
            "a classroom with desks and chairs in rows",
            {"student_desk": 12, "chair": 12},
        ),  # 9 chairs, of which the rows were
        ("a restaurant with tables and chairs in rows", {"dining_table": 9, "chair": 36}),
        ("a library with tables and chairs", {"dining_table": 2, "chair": 8}),
        ("a classroom with a board", {"whiteboard": 0, "board": 1}),  # two boards
    ],
)
def test_there_are_seats_for_as_many_as_are_said_and_something_to_sit_at(text: str, things: dict[str, int]) -> None:
    found = there(text)
    assert {kind: found[kind] for kind in things} == things


def test_two_sofas_are_no_wider_for_seats_that_are_said_of_the_room() -> None:
    scene, _ = rl.scene_from_sentence("a living room with two sofas and seating for six")
    assert scene.by_name["sofa-0"].size[1] < 2.5


def test_a_circle_of_chairs_is_one() -> None:
    result = made("a circle of ten chairs")
    places = [result.layout[name] for name in of(result, "chair")]
    x, y = (sum(values) / 10 for values in zip(*((pose.x, pose.y) for pose in places), strict=True))
    away = [math.dist((x, y), (pose.x, pose.y)) for pose in places]
    assert len(places) == 10 and min(away) > 1.0 and max(away) - min(away) < 0.3


@pytest.mark.parametrize(
    "text", [slow("a sofa with a rug in front of it"), "a sofa with a rug and coffee table in front of it"]
)
def test_a_rug_before_a_sofa_lies_under_its_table(text: str) -> None:
    result = made(text)
    rug, table = (result.layout[name] for name in ("rug-0", "coffee_table-0"))
    assert result.report.ok and math.dist((rug.x, rug.y), (table.x, table.y)) < 0.4


@pytest.mark.slow
def test_what_is_beside_a_seat_stands_there_and_not_on_it() -> None:
    result = made("a sofa with a lamp and a plant beside it")
    sofa = result.layout["sofa-0"]
    places = [result.layout[name] for name in ("floor_lamp-0", "plant-0")]
    assert result.report.ok and all(math.dist((at.x, at.y), (sofa.x, sofa.y)) < 2.2 for at in places)


def test_a_door_mat_lies_before_the_door() -> None:
    result = made("a hallway with a door mat")
    room, mat = result.scene.room, result.layout["door_mat-0"]
    at = room.walls[room.doors[0].wall].point(room.doors[0].center)
    assert math.dist(at, (mat.x, mat.y)) < 0.6


@pytest.mark.parametrize(
    ("text", "kind", "walls"),
    [
        slow("a library with four tables and bookshelves along all walls", "bookshelf", 4),  # two at one wall, met
        ("a waiting room with chairs on two sides and a reception desk opposite the door", "chair", 2),
    ],
)
def test_things_stand_at_as_many_walls_as_are_said(text: str, kind: str, walls: int) -> None:
    result = made(text)
    at = {round(result.layout[name].yaw / (math.pi / 2)) % 4 for name in of(result, kind)}  # backs to walls
    assert result.report.ok and len(at) == walls


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        slow("a room with three sofas around a coffee table", ("sofa",)),  # askew, one behind the other
        ("four sofas in a square around a coffee table", ("sofa",)),
        slow("a lounge with two sofas and two armchairs around a coffee table", ("sofa", "armchair")),
    ],
)
def test_sofas_around_a_table_are_each_at_a_side_of_it_and_look_there(text: str, kinds: tuple[str, ...]) -> None:
    result = made(text)
    table = result.layout["coffee_table-0"]
    seats = [result.layout[name] for kind in kinds for name in of(result, kind)]
    sides = {round(math.atan2(*reversed(table.seen(seat.at))) / (math.pi / 2)) % 4 for seat in seats}
    turns = [abs(math.remainder(seat.yaw - math.atan2(table.y - seat.y, table.x - seat.x), math.tau)) for seat in seats]
    assert result.report.ok and len(sides) == len(seats) and max(turns) < math.radians(40)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        slow("a kitchen with an island in the middle", "kitchen_island-0"),
        ("a workshop with a workbench in the middle of the room", "workbench-0"),
    ],
)
def test_what_is_asked_into_the_middle_stands_right_there_where_it_can(text: str, name: str) -> None:
    result = made(text)
    x0, y0, x1, y1 = result.scene.room.bounds
    assert math.dist(result.layout[name].at[:2], ((x0 + x1) / 2, (y0 + y1) / 2)) < 0.5


def test_a_desk_on_the_opposite_side_stands_at_the_wall_across_from_that_of_the_bed() -> None:
    result = made("a bedroom with the bed against the left wall and a desk on the opposite side")
    x0, _, x1, _ = result.scene.room.bounds
    assert result.report.ok and result.layout["bed-0"].x < (x0 + x1) / 2 and x1 - result.layout["desk-0"].x < 0.6


def test_one_on_the_other_side_of_a_table_is_no_chair_on_another() -> None:
    result = made("a police interview room with a table, two chairs on one side and one on the other")
    table = result.layout["dining_table-0"]
    at = [table.seen(result.layout[name].at) for name in of(result, "chair")]
    sides = [
        min(sum(x > 0 for x, _ in at), sum(x < 0 for x, _ in at)),
        min(sum(y > 0.3 for _, y in at), sum(y < -0.3 for _, y in at)),
    ]
    assert result.report.ok and len(at) == 3 and 1 in sides
    assert all(result.layout[name].z < 0.6 for name in of(result, "chair"))


@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        ("a plant in the left corner and one in the right corner", "plant", 2),
        ("a desk near the window and one near the door", "desk", 2),
        ("a hotel lobby with armchairs in groups of three", "armchair", 6),
        ("an airport lounge with four groups of armchairs", "armchair", 12),  # four
        ("a shop with shelves along the walls", "shop_shelf", 4),
    ],
)
def test_as_many_are_there_as_the_words_tell_of(text: str, kind: str, count: int) -> None:
    assert there(text)[kind] == count


def test_groups_of_chairs_are_circles_apart_from_each_other() -> None:
    result = made("two groups of four chairs")
    places = [result.layout[name].at for name in sorted(of(result, "chair"))]
    middles = [tuple(sum(at[k] for at in part) / 4 for k in (0, 1)) for part in (places[:4], places[4:])]
    away = [
        math.dist(at[:2], middle) for part, middle in zip((places[:4], places[4:]), middles, strict=True) for at in part
    ]
    assert result.report.ok and math.dist(*middles) > 1.5 * max(away)


@pytest.mark.slow
def test_chairs_stay_at_their_desks_where_the_middle_is_to_be_open() -> None:
    result = made("an office with four desks along the walls and open space in the middle")
    desks = [result.layout[name].at[:2] for name in of(result, "desk")]
    away = [min(math.dist(result.layout[name].at[:2], at) for at in desks) for name in of(result, "office_chair")]
    assert len(away) == 4 and max(away) < 1.2


def test_what_goes_with_a_thing_that_is_refused_is_not_there() -> None:
    assert not there("a living room with no TV")["tv_stand"]


@pytest.mark.parametrize(
    ("task", "words", "understanding"),
    [
        ("classroom_medium", "the board", "1 board (blackboard)"),  # a bulletin board hangs there, too
        ("buffet_restaurant_medium", "table in rows", "aisle=0)"),  # three rows, said nobody
    ],
)
def test_what_given_scenes_are_said_to_be(task: str, words: str, understanding: str) -> None:
    rows = read_words(rl.load_scene(f"examples/tasks/{task}.json")).rows
    assert [row.understanding.endswith(understanding) for row in rows if row.words == words] == [True]


@pytest.mark.parametrize(
    "text", ["a workshop with a table saw free on all sides", "a classroom with a board. Everybody looks at the board."]
)
def test_what_says_no_place_puts_nothing_at_a_wall(text: str) -> None:
    scene, _ = rl.scene_from_sentence(text)
    rows = read_words(scene).rows
    assert not [row.words for row in rows if row.demands]
    assert [row for row in rows if row.kind == "not understood"]


@pytest.mark.slow
def test_a_screen_at_the_short_end_hangs_on_a_short_wall() -> None:
    result = made("a conference room with a table for twelve and a screen at the short end")
    (x0, y0, x1, y1), screen = result.scene.room.bounds, result.layout["projection_screen-0"]
    along, across = (x1 - x0, y1 - y0)
    ends = (screen.x - x0, x1 - screen.x) if along > across else (screen.y - y0, y1 - screen.y)
    assert result.report.ok and min(ends) < 0.2


def test_a_mirror_wall_is_a_large_mirror() -> None:
    scene, _ = rl.scene_from_sentence("a home gym with a treadmill facing a mirror wall")
    assert scene.by_name["mirror_wall-0"].size[1] == pytest.approx(3.0)


@pytest.mark.parametrize(
    ("text", "room", "bed"),
    [
        ("a bedroom for a child of six with a desk", "children's room", {"single_bed": 1}),
        ("a bedroom for a six-year-old", "children's room", {"single_bed": 1}),
        ("a bedroom for my son and my daughter", "children's room", {"single_bed": 2}),
        ("a bedroom for a baby", "children's room", {"crib": 1}),
        ("a bedroom for a couple and a baby", "bedroom", {"bed": 1}),
        ("a bedroom for a 70-year-old woman", "bedroom", {"bed": 1}),
    ],
)
def test_a_bedroom_for_children_alone_is_their_room(text: str, room: str, bed: dict[str, int]) -> None:
    scene, understood = rl.scene_from_sentence(text)
    beds = {kind: count for kind, count in there(text).items() if kind.endswith(("bed", "crib"))}
    assert (understood.room_type, beds) == (room, bed)
    assert all(row.kind != "not understood" for row in read_words(scene).rows)
