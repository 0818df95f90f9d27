"""Phrases in which people ask for a place: by the compass, by who looks or reaches, for a robot that carries."""

from __future__ import annotations

from collections import Counter

import pytest

from robolayout.planners.sentence import scene_from_sentence
from robolayout.words import read_words
from robolayout.words._judged import Unjudged


def rows(text: str) -> list[Unjudged]:
    scene, _ = scene_from_sentence(text)
    return [row for row in read_words(scene).rows if row.kind in ("relation", "way", "not understood")]


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("a bedroom with a single bed she can get out of on the right side", "keep_clear(single_bed-0, right"),
        ("a living room with a sofa watching the TV", "point_towards(sofa-0, television-0)"),
        ("a bedroom where I can lie in bed and watch the TV on the opposite wall", "point_towards(bed-0, television-0)"),
        ("an office with two armchairs and a clock the client can see from the armchair", "point_towards(armchair-0, "),
        ("a living room where the TV can be watched from the dining table", "point_towards(dining_table-0, television-0)"),
        ("a bedroom with a bed in an alcove between two wardrobes", "bed-0 between wardrobe-0 and wardrobe-1"),
        ("a cafe with a counter and a queue space of 1.5 m in front of the counter", "keep_clear(bar_counter-0, depth=1.5)"),
        ("a garage with a car and 0.8 m between the car and everything else", "keep_clear(car-0, depth=0.8)"),
        ("a living room with two sofas and a coffee table in the corner between them", "coffee_table-0 between sofa-0 and sofa-1"),
        ("a bedroom with a desk on the north side of the room", "zone(desk-0, "),
        ("an office with a cabinet along the windowless wall", "against_wall(cabinet-0, walls["),
        ("a classroom with a teacher's desk and a whiteboard behind the teacher", "in_front_of(whiteboard-0, teacher_desk-0"),
        ("an office with a desk with a chair behind it and a bookcase behind the lawyer", "behind(bookshelf-0, office_chair-0"),
        ("a doctor's office with a desk, the doctor's chair behind it and a chair for the patient at its side", "near(chair-1, chair-0"),
        ("a lounge with a side table, a sofa opposite the TV, a table on a rug between them", "coffee_table-0 between sofa-0 and tele"),
        ("a lounge with a sofa under the window, a TV on a low cabinet, a coffee table halfway", "on_top_of(television-0, tv_stand-0)"),
        ("a classroom with a lectern facing the class and 20 chairs in rows", "align_with(lectern-0, chair-0, angle=180)"),
        ("a bathroom with a bathtub and a shelf with towels above the tub", "on_top_of(towel-0, wall_shelf-0)"),
        ("a bathroom with three sinks with mirrors on the right wall", "against_wall(washbasin-0, walls[3])"),
        ("a kitchen with counters with a sink, a stove and an oven along the back wall", "against_wall(kitchen_counter-0, walls[2])"),
        ("a craft room with two sewing machines on tables, each with a chair", "on_top_of(sewing_machine-0, dining_table-0)"),
        ("a lounge with a sectional sofa in the corner facing a screen", "corner(sectional_sofa-0, 0)"),
        ("a cafe with three tables along a bench and a stool on the other side of each table", "near(stool-0, "),
        ("a laboratory with two workbenches in the middle with an aisle of 1.2 m between them", "in_rows([workbench-0, workbench-1]"),
        ("a gym with a rack with dumbbells along the mirrored wall", "near(shelving_unit-0, mirrored_wall-0"),
        ("a workshop with a tool wall at the back", "mounted_on(pegboard-0, walls[2])"),
        ("a gallery with three paintings on each side wall", "mounted_on(picture-0, walls[1]), mounted_on(picture-1, walls[1])"),
        ("a barbershop with three barber chairs along the left wall, each facing a mirror", "mounted_on(mirror-0, walls[1]), "),
        ("a lounge with a sofa with its back toward the dining table", "point_towards(sofa-0, dining_table-0, angle=180)"),
        ("a waiting room with eight chairs along two walls", "against_wall(chair-0, walls[1]), against_wall(chair-1, walls[1]), "),
        ("a bedroom with two single beds half a metre apart", "single_bed-0 0.5 to 0.65 m from single_bed-1"),
        ("a study with a desk a metre from the window", "desk-0 1 to 1.3 m from ("),
        ("a pharmacy with three shelves in parallel", "in_rows([shop_shelf-0, shop_shelf-1, shop_shelf-2], aisle=0, 3)"),
        ("a hallway with a bench and a coat rack above the bench", "above(wall_hooks-0, bench-0)"),
        ("a kitchen with a table, I can get to all sides of the table", "keep_clear(dining_table-0, [chair-0"),
        ("a bathroom with two sinks under a wide mirror, a large tub by the window", "above(mirror-0, washbasin-0)"),
        ("a sofa in the corner of the living room with the TV", "point_towards(sofa-0, television-0)"),
        ("a ballet studio with a mirror wall and a barre on the opposite wall", "mounted_on(mirror_wall-0, walls[0]), "),
        ("a bedroom with a bed and a wardrobe on the opposite wall", "against_wall(bed-0, walls[0]), against_wall(wardrobe-0, walls[2])"),
        ("a bedroom with a bed and a desk and 0.9 m of free space on all sides of the bed", "keep_clear(bed-0, depth=0.9)"),
        ("a bathroom with a vanity and a mirror above it", "above(mirror-0, bathroom_vanity-0)"),
        ("a hallway with a console table and two chairs on either side", "next_to(chair-0, console_table-0, left"),
        ("a bedroom with a bed that can be reached from both sides", "keep_clear(bed-0, left"),
        ("a bedroom with a wardrobe with clear space in front and a bed", "keep_clear(wardrobe-0"),
        ("a barbershop with four barber chairs in a row facing the mirrors", "point_towards(salon_chair-0, mirror-0), "),
        ("a cinema with two rows of three seats, the second row 1.2 m behind the first", "in_rows([theater_seat-0, "),
        ("two armchairs, a table between them and a bookcase behind one of them", "behind(bookshelf-0, armchair-0"),
        ("an office with eight desks in two clusters of four and a plant between the clusters", "plant-0 between desk-2 and desk-6"),
        ("a hallway with a bench, hooks above the bench and a shoe rack below it", "under(shoe_rack-0, [bench-0])"),
        ("a study with a desk facing the door and a whiteboard on the wall behind me", "in_front_of(whiteboard-0, desk-0"),
        ("two single beds with their heads to the same wall in a bedroom", "against_wall(single_bed-0, walls[0]), "),
        ("a music room with a grand piano in the center, its keyboard facing the window", "align_with(grand_piano-0, walls["),
        ("a server room with two rows of four racks, fronts facing each other across a cold aisle", "in_rows([server_rack-0"),
        ("a clinic with a desk with a chair for the doctor and two for patients", "behind(visitor_chair-0, desk-0"),
        ("a living room with a sofa, a lamp to the left and a table to the right of the sofa", "left_of(floor_lamp-0, sofa-0"),
        ("a bedroom with a bed under the window and a desk in the opposite corner", "corner(desk-0, "),
        ("six chairs in a circle with a low table in its center", "near(chair-0, low_table-0"),
        ("a laundry room with a washer, shelves above it and an ironing board on the opposite wall", "against_wall(washing_machine-0"),
        ("a one-wall kitchen on the left wall", "against_wall(kitchen_counter-0, walls[3]); against_wall(kitchen_sink-0, walls[3])"),
        ("a kitchen with all cabinets on the left wall", "against_wall(kitchen_counter-0, walls[3]); against_wall(kitchen_sink-0"),
        ("a kitchen with a sink under a window in the north wall", "near(kitchen_sink-0, ("),
        ("a lobby with a plant at either side of the entrance", "against_wall(plant-0, walls["),
        ("a library with low shelves around the walls", "against_wall(bookshelf-0); against_wall(bookshelf-1)"),
        ("an office with three desks each facing a different wall", "against_wall(desk-0, walls[0]), against_wall(desk-1, walls[1]), "),
        ("a boardroom table with ten chairs, a podium at the head", "in_front_of(lectern-0, conference_table-0"),
        ("a room with a sofa in the middle, behind it a table with four chairs, in front of it a rug", "in_front_of(rug-0, sofa-0"),
        ("a living room with a rug in front of the fireplace, bookcases left and right of it", "next_to(bookshelf-0, fireplace-0, left"),
        ("a bar with a wine fridge next to the bar and a pendant light over it", "above(pendant_lamp-0, bar_counter-0)"),
        ("a bar with a wine fridge next to the bar and a shelf behind it", "behind(shelving_unit-0, bar_counter-0"),
        ("a study with the desk in the middle of the room facing the door", "align_with(desk-0, walls["),
        ("a living room with a TV in front of the sofa", "in_front_of(television-0, sofa-0, max_gap=12)"),
        ("a cafe with a cup on the table and a chair in front of it", "in_front_of(chair-0, round_table-0"),
        ("a kitchen with a fridge opposite the stove and a table between them", "dining_table-0 between fridge-0 and stove-0"),
        ("a computer lab with 12 computers on desks in 3 rows", "in_rows([desk-0"),
        ("an office with two desks looking out of the window", "point_towards(desk-0, ("),
        ("a bed and nightstands; on the left nightstand is a lamp, on the right one a clock", "on_top_of(alarm_clock-0, night_stand-1)"),
        ("two armchairs flanking a fireplace, facing each other", "symmetric_pair(armchair-0, armchair-1, fireplace-0"),
        ("a living room with a sofa and a screen on the opposite wall from the sofa", "in_front_of(screen-0, sofa-0, max_gap=12)"),
        ("a bedroom with the bed, nightstand and dresser all on the same wall", "against_wall(bed-0, walls[0]), against_wall(night_stand"),
        ("a bedroom with a large window and a desk under it", "near(desk-0, ("),
        ("a room with a door in the west wall and a desk facing it", "point_towards(desk-0, ("),
        ("a workshop with a bench by the door and a workbench at the window", "near(bench-0, ("),
        ("a bedroom with the headboard against the wall opposite the window", "against_wall(bed-0, walls["),
        ("a store with three rows of racks, aisles at least 1.2 m wide", "in_rows([shelving_unit-0"),
        ("a lounge with six armchairs and a TV that is visible from the armchairs", "point_towards(armchair-0, television-0) or one of 4"),
    ],
)  # fmt: skip
def test_a_phrase_asks_for_what_it_says(text: str, meant: str) -> None:
    assert any(row.understanding.startswith(meant) for row in rows(text)), [row.understanding for row in rows(text)]


@pytest.mark.parametrize("kind", ["door", "window"])
def test_all_walls_but_one_are_those_without_its_door_or_window(kind: str) -> None:
    text = f"a library with bookshelves along all walls except the one with the {kind}"
    scene, _ = scene_from_sentence(text)
    holes = {opening.wall for opening in (scene.room.doors if kind == "door" else scene.room.windows)}
    (row,) = rows(text)
    walls = {int(said.sentence().split("walls[")[1][0]) for said in row.said}
    assert walls == {wall.index for wall in scene.room.walls} - holes


def test_openings_leave_room_for_what_the_words_put_there() -> None:
    """A counter at the back of a shop stood by its door; a bed in the middle of a wall before the window of the chair."""
    shop, _ = scene_from_sentence("a boutique with a checkout counter at the back")
    bedroom, _ = scene_from_sentence(
        "a bedroom with a bed centered on the wall opposite the door and a reading chair by the window"
    )
    assert shop.room.walls[shop.room.doors[0].wall].normal != (0.0, -1.0)
    (bed,) = [row for row in rows(bedroom.task_description) if row.things == ("bed-0",)]
    held = {int(said.sentence().split("walls[")[1][0]) for said in bed.said}
    assert held.isdisjoint(opening.wall for opening in bedroom.room.windows)


@pytest.mark.parametrize(
    ("text", "seats"),
    [
        ("a living room where nobody sits with their back to the door: a sofa and an armchair", 2),
        ("an office with three desks, no chair with its back to the door", 3),
        ("a living room with a sofa and two armchairs; no one should have the back to the TV", 3),
        ("a study with a desk; the desk must not have its back to the door", 1),
    ],
)
def test_no_back_to_something_leaves_every_other_heading(text: str, seats: int) -> None:
    """It was read as what it refuses: the back to the door."""
    (row,) = rows(text)
    assert [len(demand.ways) for demand in row.demands] == [3] * seats
    angles = {getattr(part, "angle", None) for way in row.demands[0].ways for (part,) in [way]}
    assert len(angles) == 3 and ("TV" not in text or 180.0 not in angles)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a bedroom with a bed in an alcove and a desk", "in an alcove"),
        ("a showroom with a car in the centre turned 30 degrees", "turned 30 degrees"),
        ("a game room with a pool table, cues on the wall", "cues on the wall"),
        ("a bathroom with a sink I can roll under and a shower", "I can roll under"),
        ("a kitchen with the knives out of reach of children and a fridge", "out of reach of children"),
        ("a studio with a round table and a desk in the opposite corner", "the opposite corner"),
    ],
)
def test_what_cannot_be_said_is_given_back(text: str, words: str) -> None:
    assert any(row.kind == "not understood" and words in row.words for row in rows(text))


def test_a_robot_that_fetches_gets_to_where_it_takes_and_puts() -> None:
    told = rows(
        "a living room where a mobile manipulator can pick cups off the coffee table and put them on the counter"
    )
    scene, understanding = scene_from_sentence("a kitchen where a mobile manipulator can work")
    assert understanding.agent == "fetch" and scene.agents[0].name == "fetch"
    assert [row.kind for row in told] == ["relation", "way"]
    assert told[0].understanding.startswith("on_top_of(cup-0, coffee_table-0)")


@pytest.mark.parametrize("way", ["north", "south", "east", "west"])
def test_the_compass_says_where_one_thing_is_of_another(way: str) -> None:
    text = f"a living room with an armchair {way} of the coffee table and a lamp on the {way} side of the sofa"
    first, second = rows(text)
    assert (
        first.understanding.endswith("or one of 3 other ways") and "armchair-0, coffee_table-0" in first.understanding
    )
    assert "table_lamp-0, sofa-0" in second.understanding


def test_stands_at_the_outer_sides_of_two_beds_are_at_the_ends_of_their_row() -> None:
    (row,) = [row for row in rows("a hotel room with two beds side by side and a night stand on the outer side of each")
              if "night" in row.words]  # fmt: skip
    ends = [[(relation.side, *relation.asset_names()) for relation in way] for way in row.demands[0].ways]
    assert ends == [
        [("left", "night_stand-0", "bed-0"), ("right", "night_stand-1", "bed-1")],
        [("left", "night_stand-0", "bed-1"), ("right", "night_stand-1", "bed-0")],
    ]


def test_rows_in_columns_are_so_many() -> None:
    scene, _ = scene_from_sentence("a chapel with six rows of pews in two columns")
    assert sum(one.category == "pew" for one in scene.assets) == 12


def test_what_is_refused_ends_at_a_colon() -> None:
    scene, _ = scene_from_sentence("a living room without a coffee table: a sofa 3 m in front of the TV")
    kinds = {one.category for one in scene.assets}
    assert "sofa" in kinds and "coffee table" not in kinds


def test_a_high_chair_is_one_more_at_the_table() -> None:
    for text in ("a dining room with a table and a high chair at one end", "a kitchen with a table and a high chair"):
        scene, _ = scene_from_sentence(text)
        assert sum(one.category == "chair" for one in scene.assets) >= 4, text


def test_pupils_with_two_chairs_behind_each_table_have_no_desks_besides() -> None:
    scene, _ = scene_from_sentence("a classroom with six tables in a U and two chairs behind each table")
    assert not any(one.category == "student desk" for one in scene.assets)


def test_what_takes_the_middle_between_sofa_and_screen_leaves_no_coffee_table() -> None:
    text = "a living room for movie nights: a sofa 3 m in front of the TV, two bean bags between the sofa and the TV"
    scene, _ = scene_from_sentence(text)
    assert not any(one.category == "coffee table" for one in scene.assets)
    assert not any(row.kind == "not understood" for row in rows(text))


def test_things_along_a_wall_that_are_told_to_be_apart_are_one_row_with_gaps() -> None:
    told = rows("a room with six charging docks along the long wall 0.8 m apart")
    blocks = {one for row in told for demand in row.demands for one in demand.ways[0] if one.name == "in_rows"}
    assert {(one.rows, one.gap) for one in blocks} == {(1, 0.8)}


def kinds(text: str) -> Counter[str]:
    return Counter(one.category for one in scene_from_sentence(text)[0].assets)


def test_what_is_between_groups_or_in_the_middle_of_each_is_so_many() -> None:
    """ "A printer between the clusters" was one in each gap between eight desks, which crashed; a table for each armchair."""
    office = kinds(
        "an office with eight desks in two clusters of four, each with a monitor, a printer between the clusters"
    )
    assert (office["printer"], office["monitor"]) == (1, 8)
    for told in ("and a coffee table in the middle of each group", "each group around a coffee table"):
        assert kinds(f"a lounge with eight armchairs in two groups of four, {told}")["coffee table"] == 2
    assert kinds("a bar with a counter in the middle and stools all around it")["bar stool"] == 6


def test_marks_and_corners_of_the_room_are_counted_as_said() -> None:
    """Of "sofa / armchair / lamp" the last one was left, of "in each corner of the room" one thing."""
    assert {"sofa", "armchair", "floor lamp"} <= kinds("a living room: sofa / armchair / floor lamp").keys()
    assert kinds("a hall with a floor lamp in each corner of the room")["floor lamp"] == 4
    (under,) = [row for row in rows("room: 4m x 4m / bed under window / desk right of bed") if "under" in row.words]
    assert under.things == ("bed-0",)


def test_a_few_on_one_side_and_others_on_the_other_are_all_of_them() -> None:
    """ "One on the other" was one of the two; the desks of five rows were one for each shelf."""
    assert kinds("an interview room with a table, two chairs on one side, one on the other")["chair"] == 3
    assert kinds("a library with five rows of bookshelves, a study table at the end of each row")["desk"] == 5


@pytest.mark.parametrize(
    ("text", "body"),
    [
        ("a warehouse where a Spot robot inspects three rows of racks", "spot"),
        ("a kitchen where a fetch robot loads the dishwasher from the table", "fetch"),
        ("a studio apartment with a bed and a table, all reachable in a wheelchair", "wheelchair"),
    ],
)
def test_who_works_in_a_room_is_its_body_and_no_thing(text: str, body: str) -> None:
    scene, _ = scene_from_sentence(text)
    assert [agent.name for agent in scene.agents] == [body]
    assert not any(one.category in ("wheelchair", "box") or "robot" in one.name for one in scene.assets)


def test_a_mirror_beside_what_hangs_hangs_too() -> None:
    """It stood in the middle of the hallway."""
    assert kinds("a hallway with a bench under a row of hooks and a mirror to the left of the hooks")["mirror"] == 1


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("a classroom with twelve double desks", {"student desk": 12, "chair": 24}),
        ("a classroom for 24 pupils with twelve desks", {"student desk": 12, "chair": 24}),
        ("a classroom with ten desks for two", {"student desk": 10, "chair": 20}),
        ("a classroom with twelve desks, two pupils at each desk", {"student desk": 12, "chair": 24}),
        ("an office with two desks back to back, a chair and a monitor at each", {"office chair": 2, "monitor": 2}),
        ("a hospital room with two beds, a wardrobe for each patient", {"wardrobe": 2}),
        ("a conference room with a U-shaped table arrangement for twelve", {"conference table": 6, "office chair": 12}),
        ("a warehouse with four rows of pallet racks, three in each row", {"pallet rack": 12}),
        ("a classroom with six workbenches for four pupils each", {"workbench": 6, "stool": 24}),
        ("a waiting area with three rows of five linked chairs", {"chair": 15}),
        ("a garage with a motorcycle and a bike", {"motorcycle": 1, "bicycle": 1}),
        ("a meeting room with a twelve-seat table", {"office chair": 12}),
        ("a kitchen with white cabinets along the back wall", {"kitchen cabinet": 2, "cabinet": 0}),
        ("a kitchen with a counter and two cabinets above it", {"wall cabinet": 2, "kitchen cabinet": 0}),
        ("a dining room with a round wooden table and five chairs", {"round table": 1, "chair": 5}),
        ("a cafe with a plant in each corner by the window", {"plant": 2}),
        (
            "a bathroom with a double vanity and a step stool in front of each sink",
            {"bathroom vanity": 2, "step stool": 2},
        ),
        ("an office with a phone booth in two corners", {"fitting room": 2}),
        (
            "a therapy room where the therapist's chair and the client's chair face each other",
            {"chair": 1, "client chair": 1},
        ),
        ("a studio for an online teacher: a desk with a bookshelf as backdrop behind it", {"bookshelf": 1, "bed": 0}),
    ],
)
def test_everyone_has_a_seat_and_what_is_for_each(text: str, count: dict[str, int]) -> None:
    """Of 24 chairs at twelve desks one dozen stood along the walls; "at each" was said of the last thing alone."""
    there = kinds(text)
    assert {kind: there[kind] for kind in count} == count
    assert not [row for row in rows(text) if row.kind == "not understood"]


def test_nobody_reaches_a_night_stand_from_a_loft_bed() -> None:
    assert not kinds("a bedroom with a loft bed above a desk")["night stand"]


def test_only_one_that_has_something_leaves_out_no_other_furniture() -> None:
    assert kinds("a bedroom with two nightstands, but only one has a lamp on it")["bed"] == 1


def test_a_bench_in_a_workshop_is_one_to_work_at() -> None:
    assert kinds("a garage workshop with a pegboard above the bench and a stool in front of it")["workbench"] == 1


def test_a_narrow_room_is_long_on_the_side_where_everything_stands() -> None:
    narrow, _ = scene_from_sentence("a narrow kitchen, all cabinets on the left wall")
    plain, _ = scene_from_sentence("a narrow hallway with a bench")
    assert narrow.room.bounds[3] > 1.5 * narrow.room.bounds[2]
    assert max(plain.room.bounds[2:]) > 1.5 * min(plain.room.bounds[2:])


def test_an_opposite_wall_that_nothing_tells_is_given_back() -> None:
    (row,) = [
        row
        for row in rows("a studio with a round rug and a mirror on the opposite wall")
        if row.kind == "not understood"
    ]
    assert row.words == "the opposite wall"
