"""Phrases in which people ask for a place: by the compass, by who looks or reaches, for a robot that carries."""

from __future__ import annotations

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
        ("a classroom with a teacher's desk and a whiteboard behind the teacher", "behind(whiteboard-0, teacher_desk-0"),
        ("a bedroom with two single beds half a metre apart", "single_bed-0 0.5 to 0.8 m from single_bed-1"),
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
        ("a kitchen with the knives out of reach of children and a fridge", "out of reach of children"),
        ("a studio with a bed by the window and a desk in the opposite corner", "the opposite corner"),
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
