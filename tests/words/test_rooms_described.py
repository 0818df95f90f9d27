"""Rooms as people describe them: by the fire, with an aisle through the rows, each employee with a desk."""

from __future__ import annotations

from collections import Counter

import pytest

from robolayout.planners.sentence import scene_from_sentence
from robolayout.words import read_words
from robolayout.words._judged import Unjudged


def rows(text: str) -> list[Unjudged]:
    scene, _ = scene_from_sentence(text)
    return [row for row in read_words(scene).rows if row.kind in ("relation", "way", "not understood")]


def kinds(text: str) -> Counter[str]:
    return Counter(one.category for one in scene_from_sentence(text)[0].assets)


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("a living room with two armchairs by the fireplace", "symmetric_pair(armchair-0, armchair-1, fireplace-0); near"),
        ("a den with an armchair by the fire and a sofa", "in_front_of(armchair-0, fire-0, max_gap=1.5), point_towards"),
        ("a bedroom where each window has a curtain and a bed", "near(curtain-0, ("),
        ("a library with reading tables along the window side", "near(dining_table-0, ("),
        ("a craft room with a cutting table one can walk around, a stool", "keep_clear(wrapping_table-0"),
        ("a games room with a pool table with space to play all around", "keep_clear(pool_table-0"),
        ("a warehouse with a packing station near the loading dock", "near(packing_table-0, ("),
        ("a balcony with a bench against the railing", "against_wall(bench-0)"),
        ("a balcony with a bench and planters on both ends", "next_to(planter-0, bench-0, left"),
        ("a lounge with a sofa, a lamp behind it and a side table within reach", "near(side_table-0, sofa-0"),
        ("a server room with two rows of racks and a desk facing away from the racks", "point_towards(desk-0, server_rack-3)"),
        ("a dorm room with two loft beds with desks underneath, on opposite walls", "against_wall(loft_bed-0, walls["),
        ("a living room with a sofa in the middle of the room with its back to the door", "align_with(sofa-0, walls["),
        ("a living room with a sofa opposite the TV at a distance of 3 meters", "sofa-0 3 to 3.3 m from television-0"),
        ("a den with an armchair facing the fireplace at about 2 m", "armchair-0 2 to 2.3 m from fireplace-0"),
        ("a ward. The window is opposite the door, and a table with two chairs stands under it", "near(dining_table-0, ("),
        ("a garage with a pegboard. To the left of it is a shelf with boxes, to the right a tool cabinet", "left_of(tool_chest-0"),
        ("a bathroom with a toilet and a shower in the corner behind the door", "corner(shower-0, "),
        ("a bedroom with a bed and an armchair in the corner next to the window", "near(armchair-0, "),
        ("a lab with two long benches, stools along both sides of each bench", "in_front_of(stool-0, lab_bench-0"),
        ("a kitchen where the robot can bring dishes from the table to the dishwasher", "a way for the body"),
        ("two desks facing each other in the middle of the office with a plant at one end", "next_to(plant-0, desk-0"),
        ("a playroom with a reading nook in the corner by the window", "corner(armchair-0, "),
    ],
)  # fmt: skip
def test_a_phrase_asks_for_what_it_says(text: str, meant: str) -> None:
    assert any(row.understanding.startswith(meant) for row in rows(text)), [row.understanding for row in rows(text)]
    assert not any(row.kind == "not understood" for row in rows(text))


@pytest.mark.parametrize(
    ("text", "things"),
    [
        ("a lab with 12 computers on tables along three walls", {"computer": 12, "desk": 12, "dining table": 0}),
        ("an office with four clusters of four desks, each cluster with a plant at its end", {"desk": 16, "plant": 4}),
        ("a waiting room with six chairs in the middle and more chairs along the walls", {"chair": 10}),
        ("an office for three employees. Each employee has a desk and a chair", {"desk": 3, "office chair": 3, "employee": 0}),
        ("a lobby with four groups of two armchairs around small tables", {"armchair": 8, "coffee table": 4}),
        ("a hall with six rows of chairs facing a stage. Each row has eight chairs.", {"chair": 48}),
        ("a kitchen with a dining area. A table with four chairs is in the middle of the room.", {"dining table": 1}),
        ("a laundromat with a folding table down the center", {"packing table": 1, "dining table": 0}),
        ("a studio with the kitchen counter and the bed that I can reach in my wheelchair", {"wheelchair": 0}),
        ("a library with low shelves in a semicircle around a rug", {"bookshelf": 6}),
        ("a library with bookshelves on the wall opposite the window", {"bookshelf": 6}),
    ],
)  # fmt: skip
def test_as_many_of_each_are_there_as_are_meant(text: str, things: dict[str, int]) -> None:
    found = kinds(text)
    assert {kind: found[kind] for kind in things} == things


@pytest.mark.parametrize(
    "text",
    [
        "a church with eight rows of chairs with an aisle down the middle, facing a lectern",
        "a classroom with 24 desks in four rows with a central aisle facing the board",
    ],
)
def test_an_aisle_in_the_middle_goes_through_all_rows(text: str) -> None:
    found = [one for row in rows(text) for demand in row.demands for one in demand.ways[0] if one.name == "in_rows"]
    assert {one.central for one in found} == {1.2}
    assert not any(row.kind == "not understood" for row in rows(text))


def test_two_rows_of_racks_have_the_aisle_between_them() -> None:
    found = rows("a warehouse with two rows of racks and an aisle in the middle")
    assert any("aisle=1.2" in row.understanding and "central" not in row.understanding for row in found)


def test_a_room_is_as_long_as_what_stands_along_a_side_of_it_and_deep_enough_for_what_is_in_its_middle() -> None:
    laundry, _ = scene_from_sentence("a laundromat with nine washing machines along the left wall")
    office, _ = scene_from_sentence(
        "a small office with the desk in the middle, a sideboard behind it and two guest chairs in front"
    )
    assert laundry.room.bounds[3] > 5.4
    assert min(office.room.bounds[2:]) > 3.5


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("need a bedroom w/ a queen bed, closet opp bed", "in_front_of(wardrobe-0, bed-0"),
        ("living rm: sofa, tv across from it, rug under coffee tbl", "under(rug-0, [coffee_table-0])"),
        ("kitchen: galley layout, fridge by door", "against_wall(kitchen_counter-0, walls[0]), against_wall(kitchen_counter-1"),
        ("Classroom 6x8m. 12 desks in 3 rows, teacher desk front right corner", "corner(teacher_desk-0, 3)"),
        ("a classroom with 12 desks, whiteboard front wall", "mounted_on(whiteboard-0, walls[2])"),
        ("workshop: table saw in center with 1m clearance all around", "keep_clear(table_saw-0, depth=1)"),
        ("Dentist: chair in middle, light above chair", "above(pendant_lamp-0, chair-0)"),
        ("lab with 3 benches, stools both sides", "in_front_of(stool-0, lab_bench-0"),
        ("bedroom with a bed and a dresser, transfer space left of the bed", "keep_clear(bed-0, left"),
        ("bedroom with a bed and a wardrobe with space in front", "keep_clear(wardrobe-0"),
        ("a den in which no furniture blocks the fireplace", "keep_clear(fireplace-0"),
        ("a study with bookshelves and a ladder leaning on them", "near(ladder-0, bookshelf-0"),
        ("a bedroom with a wardrobe that hides behind the door", "near(wardrobe-0, ("),
        ("an armchair that is turned toward the window but can also see the TV", "point_towards(armchair-0, television-0) or one"),
        ("a bedroom with a bed, TV above dresser across from bed", "in_front_of(television-0, bed-0"),
        ("an office where the desk has its back to the bookshelf", "point_towards(desk-0, bookshelf-0) or one of 1 other"),
    ],
)  # fmt: skip
def test_notes_in_few_words_ask_for_what_they_say(text: str, meant: str) -> None:
    assert any(row.understanding.startswith(meant) for row in rows(text)), [row.understanding for row in rows(text)]
    assert not any(row.kind == "not understood" for row in rows(text))


def test_racks_and_shelves_of_one_sentence_are_both_there() -> None:
    store = kinds("Retail store: 4 racks in center, shelves along walls")
    assert store["shelving unit"] == 4 and store["shop shelf"] > 1


def test_a_thing_used_as_another_is_one_thing() -> None:
    nursery = [row for row in rows("a nursery with a crib, a dresser used as a changing table across from it")]
    assert [row.things for row in nursery] == [("crib-0", "dresser-0")]


def test_a_reading_nook_is_in_no_bookshop() -> None:
    assert "checkout counter" not in kinds("Reading nook: chair, lamp, side table, bookshelf behind chair")


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("a kitchen where the fridge is close to the door and the stove as far as possible from it", "distance_constraint(stove-0, ("),
        ("a dining room with a rug that extends under all chairs", "under(rug-0, ["),
        ("a bedroom in which each side of the bed has a nightstand with a lamp", "on_top_of(table_lamp-0, night_stand-0); on_top"),
        ("a waiting room with seats along the walls so that the middle is empty", "zone(seat-0"),
        ("a workshop with workbenches around the edge", "against_wall(workbench-0"),
        ("a bathroom with two sinks, one mirror above both", "above(mirror-0, washbasin-0), above(mirror-0, washbasin-1)"),
        ("a bedroom with a gap of 0.8 m between the bed and the wall on the window side", "bed-0 0.8 to 1.04 m from walls"),
        ("a store room with a shelf with books on the top shelf and boxes on the bottom", "inside(storage_box-0, shelving_unit-0, shelf 1"),
        ("a server room with racks in two rows, cold aisle 1.2 m wide between them", "in_rows([server_rack-0, server_rack-1"),
        ("a bedroom with two wardrobes facing each other", "facing_pair(wardrobe-1, wardrobe-0); against_wall(wardrobe-0)"),
        ("a music room with the piano in the corner so that the pianist faces the room", "align_with(piano-0, walls["),
    ],
)  # fmt: skip
def test_clauses_about_a_room_are_read(text: str, meant: str) -> None:
    assert any(row.understanding.startswith(meant) for row in rows(text)), [row.understanding for row in rows(text)]
    assert not any(row.kind == "not understood" for row in rows(text))


def test_what_everything_but_one_thing_is_asked_of_leaves_that_thing_there() -> None:
    """The shower was refused."""
    assert kinds("A small bathroom with everything along one wall except the shower")["shower"] == 1


def test_a_room_that_is_designed_for_something_is_no_thing() -> None:
    lounge = kinds("A living room designed for conversation: four armchairs around a low round table, no TV")
    assert (lounge["coffee table"], lounge["chair"], lounge["armchair"]) == (1, 0, 4)
    assert len(lounge) < 12


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("a lab with a 3 x 3 m free area in the middle and two desks", "zone(desk-0"),
        ("a bar: counter with three stools, shelf with bottles behind it", "behind(shelving_unit-0, bar_counter-0"),
        ("a mudroom with a bench, a tray under the bench and hooks above it", "above(wall_hooks-0, bench-0)"),
        ("a kitchen with two counters facing each other with 1.2 m in between", "kitchen_counter-0 1.2 to 1.5 m from kitchen_counter-1"),
        ("a ward with a bed with 1.5 m turning space on its left side", "keep_clear(hospital_bed-0, left, depth=1.5"),
        ("a nursery with two cribs and a glider between the cribs and the window", "rocking_chair-0 between crib-0 and ("),
        ("a data center with four rows of six racks with 1.2 m aisles and a desk near the entrance", "near(desk-0, ("),
        ("a clinic with an examination couch behind a curtain", "behind(examination_couch-0, privacy_screen-0"),
        ("a kitchen with a stove on the island", "next_to(stove-0, kitchen_island-0"),
        ("a sofa and two armchairs form a U around the coffee table", "near(sofa-0, coffee_table-0"),
    ],
)  # fmt: skip
def test_who_and_what_is_meant_in_longer_sentences(text: str, meant: str) -> None:
    assert any(row.understanding.startswith(meant) for row in rows(text)), [row.understanding for row in rows(text)]
    assert not any(row.kind == "not understood" for row in rows(text))


def test_free_floor_is_no_size_of_the_room() -> None:
    scene, _ = scene_from_sentence("A robot lab: a 3 x 3 m free area in the middle, two desks along the back wall")
    assert min(scene.room.bounds[2:]) > 4


def test_a_stove_of_an_island_is_no_box_on_it_and_has_no_hood_at_a_wall() -> None:
    found = kinds("A kitchen with a stove on the island")
    assert (found["stove"], found["range hood"]) == (1, 0)


@pytest.mark.parametrize(
    "text",
    [
        "A living room with a sofa facing away from the dining area, which has a table for four",
        "A living room: a sofa facing the dining area, a table for four by the window",
        "A living room where the sofa backs onto the dining area, with a table for four behind it",
        "A living room where the sofa turns its back to the dining table for four",
    ],
)
def test_the_table_of_a_dining_area_is_that_which_is_named_and_is_for_those_it_is_said_to_be(text: str) -> None:
    """There were two tables, and the sofa was as long as four people need."""
    found = kinds(text)
    assert (found["dining table"], found["chair"]) == (1, 4)
    assert not any(row.kind in ("attribute", "not understood") for row in rows(text))


@pytest.mark.parametrize(
    "text",
    [
        "The sofa backs onto the dining table and faces the TV",
        "The sofa has the dining table behind it and faces the TV",
    ],
)
def test_what_has_something_behind_it_is_what_faces_something(text: str) -> None:
    """The table was to face the television."""
    understood = [row.understanding for row in rows(text)]
    assert "behind(dining_table-0, sofa-0, max_gap=1.2)" in understood
    assert "point_towards(sofa-0, television-0)" in understood


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("A shop with a display case on the counter", "on_top_of(display_case-0, "),
        ("A kitchen with a dishwasher in the counter", "next_to(dishwasher-0, kitchen_counter-0"),
    ],
)
def test_only_what_is_built_into_counters_is_beside_the_one_it_is_on(text: str, meant: str) -> None:
    assert any(row.understanding.startswith(meant) for row in rows(text)), [row.understanding for row in rows(text)]


@pytest.mark.parametrize(
    "text",
    [
        "A kids bedroom with two beds, one on each side of the window, and a shared desk under it",
        "A bedroom with two beds on either side of the window and a desk under it",
    ],
)
def test_what_several_flank_is_what_it_stands_for(text: str) -> None:
    """The desk was to stand under a bed."""
    assert not any(row.understanding.startswith("under(") for row in rows(text))
    assert any("desk" in row.words and row.kind == "relation" for row in rows(text))


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("A bedroom with a desk in the far left corner", "corner(desk-0, 3)"),
        ("A bedroom with a desk in the back right corner and a bed by the window", "corner(desk-0, 2)"),
        ("A bedroom with a desk in the front right corner", "corner(desk-0, 1)"),
        ("A bedroom with a lamp in the near right corner", "corner(floor_lamp-0, 1)"),
        ("A room with a bed in the top left corner", "corner(bed-0, 3)"),
        ("A bedroom with a dresser on the far left wall", "against_wall(dresser-0, walls[2])"),
        ("A bedroom with a dresser to the immediate left of the bed", "left_of(dresser-0, bed-0, max_gap=1.2)"),
        ("A living room with an armchair looking out the window", "point_towards(armchair-0, (3.24, 0, 0))"),
        (
            "I want a kids room; the bookcase goes facing inwards please",
            "align_with(bookshelf-0, walls[0], angle=90), "
            "zone(bookshelf-0, [(0, 0, 0), (3.8, 0, 0), (3.8, 2.1, 0), (0, 2.1, 0)]) or one of 4 other ways",
        ),
    ],
)
def test_where_a_thing_is_said_to_be_is_understood(text: str, meant: str) -> None:
    """The first of its words was taken for the name of a thing."""
    assert next(row.understanding for row in rows(text) if row.kind in ("relation", "not understood")) == meant
    assert not any(row.kind == "not understood" for row in rows(text))


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        (
            "A living room with a sofa near the window, facing away from it",
            "align_with(sofa-0, walls[0], angle=90) or one of 1 other ways",
        ),
        ("A home office with two plants in opposite corners", "corner(plant-1, 0), corner(plant-0, 2)"),
        ("A bedroom with a bed and a desk in opposite corners", "corner(desk-0, 0), corner(bed-0, 2)"),
        (
            "A bedroom with a bed and a dresser on the door side of the room",
            "zone(dresser-0, [(0, 0, 0), (2.245, 0, 0)",
        ),
        ("A home office featuring a bookcase as you enter on the left", "zone(bookshelf-0, [(2.3, 0, 0)"),
        ("A living room. On the right as you come in, there is a sofa.", "zone(sofa-0, [(0, 0, 0), (2.7, 0, 0)"),
        ("A living room with a sofa pulled away from the wall and a rug", "sofa-0 at least 0.6 m from walls[0]"),
        ("A living room with a sofa so that a wheelchair can pass behind it", "keep_clear(sofa-0, back)"),
        ("A home office with a bookcase with nothing in front of it", "keep_clear(bookshelf-0)"),
    ],
)
def test_places_that_people_tell_are_understood(text: str, meant: str) -> None:
    found = rows(text)
    assert any(meant in row.understanding for row in found), [row.understanding for row in found]
    assert not any(row.kind == "not understood" for row in found)
