"""Rooms of sentences that say what looks where, what stands how far apart, and whose a thing is: judged by poses and sizes alone."""

from __future__ import annotations

import math
from itertools import combinations, pairwise

import pytest
from said_rooms import made, of

from robolayout.run.result import Result
from robolayout.scene.room import Wall
from running import slow


def cosine(result: Result, name: str, at: tuple[float, float]) -> float:
    """Return how much the front of a thing looks at a point: 1 right at it, -1 right away from it."""
    pose = result.layout[name]
    dx, dy = at[0] - pose.x, at[1] - pose.y
    return (dx * pose.forward[0] + dy * pose.forward[1]) / math.hypot(dx, dy)


def towards(result: Result, name: str, wall: Wall) -> float:
    """Return how squarely the front of a thing looks at a wall: 1 squarely, -1 right away from it."""
    forward = result.layout[name].forward
    return -(forward[0] * wall.normal[0] + forward[1] * wall.normal[1])


def gap(result: Result, a: str, b: str) -> float:
    """Return the metres between two things that stand square to each other and side by side, or one before the other."""
    x, y = result.layout[a].seen(result.layout[b].at)
    turned = abs(math.sin(result.layout[a].yaw - result.layout[b].yaw)) > 0.7
    (da, wa, _), (db, wb, _) = result.scene.by_name[a].size, result.scene.by_name[b].size
    return max(abs(x) - (da + (wb if turned else db)) / 2, abs(y) - (wa + (db if turned else wb)) / 2)


@pytest.mark.slow
def test_two_desks_that_face_the_window_stand_side_by_side_before_it() -> None:
    result = made("an office with two desks facing the window and a sofa behind them")
    assert result.report.ok
    room = result.scene.room
    wall = max(room.walls, key=lambda one: -towards(result, "desk-0", one))
    assert wall.index in {window.wall for window in room.windows}  # over its back looks who sits there
    assert min(-towards(result, name, wall) for name in of(result, "desk")) > 0.95
    assert gap(result, "desk-0", "desk-1") < 0.6
    assert cosine(result, "desk-0", result.layout["sofa-0"].at) > 0.5
    assert gap(result, "desk-0", "sofa-0") > 0.6  # the chair is between


@pytest.mark.slow
def test_shelves_behind_a_desk_that_faces_the_door_are_behind_who_sits_there() -> None:
    result = made("a study with a desk in the middle of the room facing the door and two bookshelves behind it")
    assert result.report.ok
    door = result.scene.room.doors[0]
    assert cosine(result, "desk-0", result.scene.room.walls[door.wall].point(door.center)) < -0.7, (
        "straight at its wall"
    )
    assert cosine(result, "desk-0", result.layout["bookshelf-0"].at) > 0.7
    assert gap(result, "bookshelf-0", "bookshelf-1") < 0.6


@pytest.mark.slow
def test_who_sits_behind_a_reception_desk_looks_at_the_door_across_it() -> None:
    result = made("a reception with a desk facing the door and three chairs behind it")
    door = result.scene.room.doors[0]
    at = result.scene.room.walls[door.wall].point(door.center)
    assert cosine(result, "reception_desk-0", at) > 0.95
    for name in of(result, "chair")[:3]:
        assert math.dist(result.layout[name].at, at) > math.dist(result.layout["reception_desk-0"].at, at)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "kind", "rows", "metres"),
    [
        ("a warehouse with four rows of racks, aisles 1.5 m wide", "pallet_rack", 4, 1.5),
        slow("a library with bookshelves in three rows, 1.2 m apart", "bookshelf", 3, 1.2),
        slow("an office with twelve desks in three rows at least 1.5 m apart", "desk", 3, 1.5),
    ],
)
def test_rows_are_as_far_apart_as_is_said(text: str, kind: str, rows: int, metres: float) -> None:
    result = made(text)
    assert result.report.ok
    names = of(result, kind)
    first = result.layout[names[0]]
    lines = sorted({round(first.seen(result.layout[name].at)[0], 1) for name in names})
    lines = [x for i, x in enumerate(lines) if i == 0 or x - lines[i - 1] > 0.15]
    assert len(lines) == rows
    depth = result.scene.by_name[names[0]].size[0]
    assert min(b - a for a, b in pairwise(lines)) - depth > metres - 0.15


@pytest.mark.slow
def test_desks_of_which_each_is_so_far_from_the_next_are_apart_on_all_sides() -> None:
    result = made("an exam hall with twenty desks, each 1.2 m from the next")
    assert result.report.ok
    desks = of(result, "desk")
    assert len(desks) == 20
    assert min(gap(result, a, b) for a, b in combinations(desks, 2)) > 1.1


@pytest.mark.parametrize(
    ("text", "name", "kind", "looks"),
    [
        ("a bedroom where the bed does not face the door", "bed-0", "doors", 1.0),
        slow("a living room with a sofa and a TV that does not face the window", "television-0", "windows", 1.0),
        slow("A bedroom with a bed and a desk, and the desk must not face the window.", "desk-0", "windows", -1.0),
    ],
)
def test_what_is_not_to_face_an_opening_looks_at_none_of_their_walls(
    text: str, name: str, kind: str, looks: float
) -> None:
    result = made(text)
    walls = [result.scene.room.walls[opening.wall] for opening in getattr(result.scene.room, kind)]
    assert walls != []
    assert max(looks * towards(result, name, wall) for wall in walls) < 0.5
    assert "not understood" not in {row["verdict"] for row in result.report.to_dict()["asked"]}


@pytest.mark.parametrize(
    ("text", "beds", "pets"),
    [
        ("a room for a cat with a scratching post near the window and two beds", 0, 2),
        slow("a bedroom with a bed for the dog at the foot of the bed", 1, 1),
        slow("a living room with a sofa, a TV and a bed for the dog next to the sofa", 0, 1),
    ],
)
def test_beds_of_pets_are_no_beds(text: str, beds: int, pets: int) -> None:
    result = made(text)
    assert (len(of(result, "bed")), len(of(result, "pet_bed"))) == (beds, pets)


def test_a_bed_between_two_windows_has_its_night_stands_beside_it() -> None:
    result = made("a bedroom with a king-size bed between two windows")
    for name in of(result, "night_stand"):
        assert gap(result, "bed-0", name) < 0.4


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        slow("a classroom with rows of desks", "student_desk", 12),
        ("a bar with six stools at the counter and three high tables each with four stools", "bar_stool", 18),
        slow("a game room with a pool table in the middle, at least 1.5 m free on all sides", "pool_table", 1),
        slow("a library with four armchairs in pairs and a small table between each pair", "side_table", 2),
        slow("a tiny 2.5 by 3 m bedroom with a single bed, a desk and a wardrobe", "table_lamp", 1),
    ],
)
def test_there_are_no_more_and_no_less(text: str, kind: str, count: int) -> None:
    assert len(of(made(text), kind)) == count


def test_chairs_around_a_grand_piano_are_not_all_before_its_keys() -> None:
    result = made("a music room with a grand piano and six chairs around it")
    piano, chairs = result.layout["grand_piano-0"], of(result, "chair")[:6]
    sides = {round(math.atan2(*reversed(piano.seen(result.layout[name].at))) / (math.pi / 2)) % 4 for name in chairs}
    assert len(sides) >= 3
    assert all(cosine(result, name, piano.at) > 0.9 for name in chairs)


@pytest.mark.slow
def test_floor_on_all_sides_of_a_table_is_free() -> None:
    result = made("a game room with a pool table in the middle, at least 1.5 m free on all sides")
    assert result.report.ok
    pose, (depth, width, _) = result.layout["pool_table-0"], result.scene.by_name["pool_table-0"].size
    for name, there in result.layout.items():
        asset = result.scene.by_name[name]
        if name == "pool_table-0" or not asset.on_floor or asset.is_flat:
            continue
        half = [min(asset.size[:2]) / 2] * 2
        x, y = pose.seen(there.at)
        before = abs(y) < width / 2 and abs(x) - half[0] < depth / 2 + 1.4
        beside = abs(x) < depth / 2 and abs(y) - half[1] < width / 2 + 1.4
        assert not (before or beside), name


@pytest.mark.slow
def test_a_teacher_at_the_front_looks_at_the_pupils_and_has_the_board_behind() -> None:
    result = made("a classroom with a teacher's desk at the front facing twelve student desks")
    assert result.report.ok
    board, desk = result.layout["whiteboard-0"], result.layout["teacher_desk-0"]
    pupils = [result.layout[name].at for name in of(result, "student_desk")]
    assert math.dist(desk.at, board.at) < min(math.dist(at, board.at) for at in pupils)
    middle = (sum(x for x, _ in pupils) / len(pupils), sum(y for _, y in pupils) / len(pupils))
    assert cosine(result, "teacher_desk-0", middle) < -0.9  # over its back


@pytest.mark.slow
def test_a_sofa_opposite_looks_at_what_was_named_before() -> None:
    result = made("a living room with the TV above the fireplace and a sofa opposite")
    assert cosine(result, "sofa-0", result.layout["fireplace-0"].at) > 0.95


@pytest.mark.slow
def test_mats_of_a_yoga_studio_lie_beside_each_other() -> None:
    result = made("a yoga studio with nine mats in three rows and an instructor's mat facing them")
    mats = of(result, "yoga_mat")
    assert len(mats) == 10
    assert min(gap(result, a, b) for a, b in combinations(mats, 2)) > 0.0


def test_a_desk_before_the_window_that_faces_the_room_has_its_own_seat_behind_and_visitors_before_it() -> None:
    result = made("an office with a desk in front of the window facing the room and two chairs in front of the desk")
    assert result.report.ok
    seat, visitors = of(result, "office_chair"), of(result, "visitor_chair")
    assert (len(seat), len(visitors), len(of(result, "monitor"))) == (1, 2, 1)
    assert cosine(result, "desk-0", result.layout[seat[0]].at) > 0.7
    assert max(cosine(result, "desk-0", result.layout[name].at) for name in visitors) < -0.7


@pytest.mark.slow
def test_each_pair_that_faces_each_other_has_its_table_between() -> None:
    result = made("a hotel lobby with three pairs of armchairs, each pair facing each other across a small table")
    assert result.report.ok
    seats, tables = of(result, "armchair"), of(result, "side_table")
    assert len(tables) == 3
    for one, other, table in zip(seats[::2], seats[1::2], tables, strict=False):
        (x0, y0), (x1, y1), (x, y) = (result.layout[name].at for name in (one, other, table))
        assert math.dist((x, y), ((x0 + x1) / 2, (y0 + y1) / 2)) < 0.35


@pytest.mark.slow
def test_racks_with_an_aisle_between_them_face_each_other_across_it() -> None:
    result = made("a server room with two rows of four racks facing each other with a 1.2 m aisle between them")
    assert result.report.ok
    racks = of(result, "server_rack")
    across = [result.layout[racks[0]].seen(result.layout[name].at)[0] for name in racks]
    apart = [abs(x) - result.scene.by_name[racks[0]].size[0] for x in across if abs(x) > 0.1]
    assert len(apart) == 4
    assert min(apart) > 1.15
    assert {round(math.cos(result.layout[a].yaw - result.layout[racks[0]].yaw)) for a in racks} == {1, -1}


@pytest.mark.parametrize(
    ("text", "to"),
    [
        ("A chapel with an altar and fifteen chairs facing the altar", "altar"),
        ("A room with a projection screen and ten chairs facing the screen", "projection_screen"),
        slow("A classroom with a teacher desk and twelve chairs facing it", "teacher_desk"),
    ],
)
def test_a_crowd_that_faces_something_sits_in_rows_before_it(text: str, to: str) -> None:
    run = made(text)
    seats = [pose for name, pose in run.layout.items() if name.startswith("chair-")]
    yaw, thing = seats[0].yaw, run.layout[f"{to}-0"]
    ahead = {round(pose.x * math.cos(yaw) + pose.y * math.sin(yaw), 1) for pose in seats}
    assert len(ahead) == max(2, math.isqrt(len(seats))) and run.report.ok
    assert max(ahead) < thing.x * math.cos(yaw) + thing.y * math.sin(yaw)
    assert "pew-0" not in run.layout


@pytest.mark.slow
def test_pupils_look_at_their_teacher() -> None:
    run = made("a classroom with ten desks facing the teacher's desk")
    turn = run.layout["student_desk-0"].yaw - run.layout["teacher_desk-0"].yaw
    assert math.cos(turn) < -0.99 and run.report.ok


@pytest.mark.parametrize(
    "text",
    [
        slow("a living room with a sofa and a TV on the wall"),
        "a living room with a sofa, two armchairs facing the sofa, a coffee table between them and a TV on the wall",
    ],
)
def test_a_sofa_looks_at_a_television_on_the_wall(text: str) -> None:
    result = made(text)
    assert cosine(result, "sofa-0", result.layout["television-0"].at) > 0.9
