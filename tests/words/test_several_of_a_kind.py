"""Several things of one kind in one sentence, each as it is said to be: coordinate adjectives, appositions, "both"."""

from __future__ import annotations

import pytest

from robolayout.planners.sentence import scene_from_sentence
from robolayout.words import Lexicon, Mention, Place, Reading, place_in, read_rooms, read_text, read_words

LEXICON = Lexicon(read_rooms())

Told = list[tuple[int, str, str]]
"""Counts, adjectives and nouns, in the order in which they are said."""


def read(text: str) -> Reading:
    return read_text(text, LEXICON)


def told(text: str) -> Told:
    return [(t.count, " ".join(t.adjectives), t.noun.words) for t in read(text).parsed.things]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a blue and a red chair", [(1, "blue", "chair"), (1, "red", "chair")]),
        ("a red, a blue, and a green chair", [(1, "red", "chair"), (1, "blue", "chair"), (1, "green", "chair")]),
        ("one large and two small desks", [(1, "large", "desk"), (2, "small", "desk")]),
        ("the big and the small wardrobe", [(1, "big", "wardrobe"), (1, "small", "wardrobe")]),
        ("a round and a square table", [(1, "", "round table"), (1, "", "dining table")]),
        ("a round table and a square one", [(1, "", "round table"), (1, "square", "dining table")]),
        ("a single and a double bed", [(1, "", "single bed"), (1, "", "bed")]),
        ("a cafe with tables for two and one sofa", [(2, "", "dining table"), (1, "", "sofa")]),
        ("a light and a table", [(1, "", "ceiling lamp"), (1, "", "dining table")]),
        ("a black and white rug", [(1, "black and white", "rug")]),
        ("both a round and a rectangular table", [(1, "", "round table"), (1, "rectangular", "dining table")]),
        ("a king and a twin bed", [(1, "", "bed"), (1, "", "twin bed")]),
        ("a tall narrow dresser and a low wide one", [(1, "tall narrow", "dresser"), (1, "low wide", "dresser")]),
        ("a rug in the corner and a table", [(1, "", "rug"), (1, "", "dining table")]),
    ],
)
def test_adjectives_that_share_a_noun_are_each_of_a_thing_of_its_own(text: str, said: Told) -> None:
    assert told(text) == said


def test_measures_that_share_a_noun_are_each_of_a_thing_of_its_own() -> None:
    things = read("a 90 cm wide and a 160 cm wide desk").parsed.things
    assert [[size.values for size in thing.sizes] for thing in things] == [[(0.9,)], [(1.6,)]]


@pytest.mark.parametrize(
    ("text", "index"),
    [
        ("a red chair and a blue chair. The red chair is by the window.", 0),
        ("a red and a blue chair. The red one is by the window.", 0),
        ("a tall lamp and a lamp. The tall lamp is by the window.", 0),
        ("a large desk. The small desk is by the window.", 1),
    ],
)
def test_what_is_named_again_is_what_looks_as_it_is_said(text: str, index: int) -> None:
    parsed = read(text).parsed
    assert [parsed.things.index(subject.thing) for subject in parsed.links[0].subjects] == [index]


def test_what_a_relation_leads_to_is_another_thing_where_its_look_excludes_the_first() -> None:
    (link,) = read("a rug between a red chair and a blue chair").parsed.links
    assert [item.thing.look for item in link.objects if isinstance(item, Mention)] == [("red",), ("blue",)]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("two bookshelves, a tall one and a low one, side by side", [(1, "tall", "bookshelf"), (1, "low", "bookshelf")]),
        ("two chairs: one red and one blue", [(1, "red", "chair"), (1, "blue", "chair")]),
        ("two blue chairs, one large and the other small", [(1, "large blue", "chair"), (1, "small blue", "chair")]),
        ("Two chairs stand by the window. One is red, the other is blue.", [(1, "red", "chair"), (1, "blue", "chair")]),
        ("three desks: two small ones and a large one", [(2, "small", "desk"), (1, "large", "desk")]),
        ("three shelves (one tall, two low)", [(1, "tall", "shelving unit"), (2, "low", "shelving unit")]),
        ("chairs, two red ones and a blue one", [(2, "red", "chair"), (1, "blue", "chair")]),
        ("two beds: a crib and a bunk bed", [(1, "", "crib"), (1, "", "bunk bed")]),
        ("four seats: a sofa, two armchairs and a bench", [(1, "", "sofa"), (2, "", "armchair"), (1, "", "bench")]),
        ("two armchairs, one of them red", [(1, "", "armchair"), (1, "red", "armchair")]),
        ("six armchairs, half of them blue", [(3, "", "armchair"), (3, "blue", "armchair")]),
        ("two sofas, one by the window and one by the door", [(2, "", "sofa")]),
        ("two chairs, an office chair and an armchair", [(2, "", "chair"), (1, "", "office chair"), (1, "", "armchair")]),
        ("two shelves: a vase and a clock", [(2, "", "shelving unit"), (1, "", "vase"), (1, "", "wall clock")]),
    ],
)  # fmt: skip
def test_what_lists_as_many_as_were_counted_says_what_each_of_them_is(text: str, said: Told) -> None:
    assert told(text) == said


def test_each_of_what_is_listed_stands_where_it_is_said_to() -> None:
    parsed = read("two desks, a large one by the window with a lamp on it and a small one in the corner").parsed
    at = [(k.relation, k.subjects[0].thing.noun.words, k.subjects[0].thing.adjectives) for k in parsed.links]
    assert at == [("by", "desk", ("large",)), ("on", "table lamp", ()), ("in", "desk", ("small",))]


def test_where_several_stand_is_true_of_all_that_are_told_apart_later() -> None:
    (link,) = read("Two chairs stand by the window. One is red and the other is blue.").parsed.links
    assert [mention.thing.look for mention in link.subjects] == [("red",), ("blue",)]


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("curtains on both windows", 2),
        ("blinds on all windows", 2),
        ("three windows and curtains on all windows", 3),
        ("a plant at each window", 2),
        ("a plant in both corners", 2),
        ("a lamp on both nightstands", 2),
        ("two nightstands with a lamp on both", 2),
        ("four desks and monitors on all desks", 4),
        ("a rug under both armchairs", 1),
        ("a table between both sofas", 1),
        ("a sofa facing both windows", 1),
    ],
)
def test_what_is_on_or_at_both_or_all_of_several_things_is_on_or_at_each(text: str, count: int) -> None:
    (link,) = (link for link in read(text).parsed.links if link.relation != "with")
    assert [mention.count for mention in link.subjects] == [count]


def test_what_is_said_after_a_list_of_what_was_counted_is_about_all_of_it() -> None:
    for text in (
        "two monitors, one large and one small, on the desk",
        "a room with two chairs, a red one and a blue one, by the door",
    ):
        (link,) = read(text).parsed.links
        assert len(link.subjects) == 2


def test_the_first_two_and_the_others_are_of_those_that_were_counted() -> None:
    parsed = read("four desks, the first two facing the window and the others facing the door").parsed
    assert [thing.count for thing in parsed.things] == [4]
    assert [link.subjects[0].pick for link in parsed.links] == [slice(0, 2), slice(2, 4)]


def test_how_many_each_row_has_counts_them() -> None:
    assert told("three rows of desks, two desks in each row") == [(6, "", "desk")]


@pytest.mark.parametrize("text", ["a sofa and two chairs, all grey", "two armchairs, both grey"])
def test_a_look_of_all_is_that_of_each(text: str) -> None:
    assert {thing.look for thing in read(text).parsed.things} == {("grey",)}


def test_the_left_and_right_walls_are_two_walls() -> None:
    (link,) = read("shelves on the left and right walls").parsed.links
    assert [(item.name, item.words) for item in link.objects if isinstance(item, Place)] == [
        ("wall", ("left", "and", "right"))
    ]


def test_a_lamp_between_seats_or_beds_stands_on_the_floor() -> None:
    assert told("two beds with a lamp between them")[1] == (1, "", "floor lamp")


def test_two_monitors_on_a_desk_are_of_one_person() -> None:
    scene, _ = scene_from_sentence("An office with two monitors, one large and one small, on the desk.")
    names = [asset.category for asset in scene.assets]
    assert (names.count("monitor"), names.count("desk"), names.count("office chair")) == (2, 1, 1)


def test_things_at_two_walls_are_in_equal_shares_at_each() -> None:
    scene, _ = scene_from_sentence("A gallery with four pictures on the east and west walls.")
    walls = [str(relation).rpartition("index=")[2] for relation in read_words(scene).said]
    assert walls[0] == walls[1] != walls[2] == walls[3]


@pytest.mark.parametrize(
    ("text", "least", "most"),
    [
        ("a king bed", 1.85, 2.1), ("a king size bed", 1.85, 2.1), ("a king-sized bed", 1.85, 2.1),
        ("a queen bed", 1.6, 1.75), ("a double bed", 1.4, 1.6), ("a 1.2 m wide double bed", 1.2, 1.2),
    ],
)  # fmt: skip
def test_a_bed_is_as_wide_as_its_mattress_size_says(text: str, least: float, most: float) -> None:
    """ "King size bed" is a word of the catalogue, and was as wide as any double bed; "king-sized" was not."""
    scene, _ = scene_from_sentence(f"A bedroom with {text}.")
    (width,) = (asset.size[1] for asset in scene.assets if asset.category == "bed")
    assert least <= width <= most


@pytest.mark.parametrize(
    ("text", "chairs"),
    [("a cafe with five tables of four chairs", 20), ("a classroom with six group tables of four chairs each", 24)],
)
def test_tables_of_so_many_chairs_have_them_each(text: str, chairs: int) -> None:
    assert [thing.count for thing in read(text).parsed.things if thing.head == "chair"] == [chairs]


@pytest.mark.parametrize(
    ("text", "link"),
    [
        ("two armchairs facing each other, a side table with tissues between them", ("amid", "side table", "armchair")),
        ("a desk with two monitors and a lamp between them", ("amid", "table lamp", "monitor")),
        ("a table with 12 chairs around the outside of it", ("around", "chair", "dining table")),
    ],
)
def test_what_has_something_on_it_stands_between_others_and_what_lies_between_what_lies_there(
    text: str, link: tuple[str, str, str]
) -> None:
    found = [
        (one.relation, a.thing.noun.kind, b.thing.noun.kind)
        for one in read(text).parsed.links
        for a in one.subjects
        for b in one.objects
        if isinstance(b, Mention)
    ]
    assert link in found


def test_a_bar_with_stools_on_a_wall_is_there_itself() -> None:
    links = read(
        "a restaurant with tables along the windows and a bar with six stools on the opposite wall"
    ).parsed.links
    on = [mention.thing.noun.kind for link in links if link.relation == "on" for mention in link.subjects]
    assert on == ["bar counter"]


@pytest.mark.parametrize(
    ("text", "subject", "relation", "to"),
    [
        ("books on a shelf above the desk", "wall shelf", "above", "desk"),
        ("tools on a pegboard above the workbench", "pegboard", "above", "workbench"),
        ("a sofa facing the fireplace with the TV above the fireplace", "television", "above", "fireplace"),
        ("a desk with a lamp on the left of the desk", "floor lamp", "left", "desk"),
        ("a bed, a desk and one nightstand on the right", "night stand", "right", "bed"),
        ("a rug centered under the dining table", "rug", "under", "dining table"),
        ("two lamps flanking a sofa by the armchair", "floor lamp", "flank", "sofa"),
        ("an L-shaped sofa with a floor lamp at its end", "floor lamp", "end", "sectional sofa"),
    ],
)
def test_what_stands_to_what(text: str, subject: str, relation: str, to: str) -> None:
    links = read(text).parsed.links
    found = [
        (k.subjects[0].thing.noun.kind, k.relation, [o.thing.noun.kind for o in k.objects if isinstance(o, Mention)])
        for k in links
        if k.subjects
    ]
    assert (subject, relation, [to]) in found
    assert not [k for k in links if k.relation == "with" and k.subjects[0].thing.noun.kind == subject]


def test_the_other_side_of_a_door_is_of_the_door() -> None:
    links = read("a wardrobe to the left of the door and a mirror to the right of it").parsed.links
    assert [(k.relation, [o.name for o in k.objects if isinstance(o, Place)]) for k in links] == [
        ("left", ["door"]),
        ("right", ["door"]),
    ]


def test_metres_from_several_places_are_from_each() -> None:
    scene, _ = scene_from_sentence("A nursery with a crib at least 1 m away from the window and the radiator")
    (row,) = [row for row in read_words(scene).rows if row.kind == "relation"]
    assert "radiator-0" in row.things
    assert len(row.demands) == 1 + len(scene.room.windows)


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        (
            "three workbenches, each with a stool in front and a lamp above",
            {"workbench": 3, "stool": 3, "wall lamp": 3},
        ),
        ("a cafe with three high tables with stools", {"bar table": 3, "bar stool": 6}),
        ("two single beds pushed together to make a double bed", {"single bed": 2}),
        ("a kitchen with a breakfast bar and three stools", {"kitchen island": 1, "bar stool": 3}),
        ("A breakfast bar with three stools overlooking the living room", {"kitchen island": 1, "bar stool": 3}),
        ("a meditation room with eight cushions in two rows", {"floor cushion": 8}),
        ("a litter box in the corner", {"litter box": 1}),
        ("a table for six and a plate in front of each chair", {"dining table": 1, "plate": 6, "chair": 6}),
        ("ten desks and a book in front of each chair", {"desk": 10, "book": 10, "chair": 10}),
        ("four beds with curtains between the beds", {"bed": 4, "privacy screen": 3}),
        ("ten desks in pairs with partitions between the desks", {"desk": 10, "partition": 5}),
    ],
)
def test_how_many_of_what(text: str, counts: dict[str, int]) -> None:
    assert {thing.noun.kind: thing.count for thing in read(text).parsed.things} == counts


def test_windows_are_beside_what_is_asked_between_them_at_a_wall() -> None:
    scene, _ = scene_from_sentence("A bedroom with a bed on the north wall between two windows")
    (north,) = (wall.index for wall in scene.room.walls if wall.normal[1] < -0.9)
    assert [window.wall for window in scene.room.windows] == [north, north]


def test_ages_say_who_the_room_is_for() -> None:
    for text in ("a bedroom for a girl aged 7", "a bedroom for my son, age 9"):
        scene, _ = scene_from_sentence(text)
        assert [agent.name for agent in scene.agents] == ["child_6"]
        assert not [asset.name for asset in scene.assets if "girl" in asset.name or "aged" in asset.name]


def test_a_room_by_a_name_with_room_is_that_room() -> None:
    assert read("a kindergarten room with four round tables").room == "kindergarten"
    assert read("a U of desks in an office room").room == "office"


def test_a_right_angle_in_degrees_is_no_thing() -> None:
    reading = read("two armchairs at a 90 degree angle and a small table between them")
    assert [thing.noun.kind for thing in reading.parsed.things] == ["armchair", "side table"]
    assert [link.relation for link in reading.parsed.links] == ["crossed", "amid"]


def test_the_opposite_corner_is_across_the_room() -> None:
    links = read("the bed in the north-west corner and the desk in the opposite corner").parsed.links
    assert [o.words for link in links for o in link.objects if isinstance(o, Place)] == [
        ("north", "west"),
        ("south", "east"),
    ]
    far = [
        place_in(link.objects, "corner")
        for link in read("a plant by the window, a lamp in the opposite corner").parsed.links
    ]
    assert [(at.by[0], at.by[1].name) for at in far if at is not None and at.by] == [("across", "window")]
    unknown = read("a round table and a lamp in the opposite corner")
    assert [unknown.span(c.start, c.end) for c in unknown.parsed.missed] == ["the opposite corner"]


def test_a_corner_opposite_one_that_is_not_told_is_that_across_from_what_is_there() -> None:
    scene, _ = scene_from_sentence("a room with a plant in one corner and a lamp in the opposite corner")
    (row,) = [row for row in read_words(scene).rows if "opposite" in row.words]
    corners = [[relation.vertex for relation in way] for way in row.demands[0].ways]
    assert corners == [[0, 2], [1, 3], [2, 0], [3, 1]]


def test_what_is_in_the_middle_of_each_table_is_asked_there() -> None:
    scene, _ = scene_from_sentence("three tables, each with two chairs and a vase in the middle")
    (row,) = [row for row in read_words(scene).rows if row.kind == "relation" and "vase" in row.words]
    said = [[relation.name for relation in way] for demand in row.demands for way in demand.ways]
    assert said == [["on_top_of", "centered_on"]] * 3


def test_a_sink_in_an_island_stands_flush_beside_it() -> None:
    scene, _ = scene_from_sentence("A kitchen island with a sink in it and four stools on the far side")
    assert {"kitchen_sink-0", "kitchen_island-0", "stove-0"} <= {asset.name for asset in scene.assets}
    (row,) = [row for row in read_words(scene).rows if row.kind == "relation" and "sink" in row.words]
    assert [[relation.name for relation in way] for demand in row.demands for way in demand.ways] == [
        ["next_to", "align_with"]
    ]


@pytest.mark.parametrize(
    ("text", "asked"),
    [
        ("a living room with two sofas and a coffee table in the middle", ["coffee table"]),
        ("two sofas and a coffee table in the middle of the room", ["sofa", "coffee table"]),
        ("a table with four magazines in the middle", ["dining table"]),
        ("a table with a bowl in the middle", ["bowl"]),
    ],
)
def test_what_of_a_list_is_in_the_middle(text: str, asked: list[str]) -> None:
    (link,) = [link for link in read(text).parsed.links if link.relation == "middle"]
    assert [mention.thing.noun.kind for mention in link.subjects] == asked


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("A bedroom with a shelf on the wall", "wall shelf"),
        ("A bedroom with a shelf on the left wall", "shelving unit"),
        ("A library with shelves on the wall", "bookshelf"),
        ("A kids room with shelves on the wall", "toy shelf"),
    ],
)
def test_a_shelf_on_the_wall_hangs_where_shelves_do_not_stand(text: str, kind: str) -> None:
    scene, _ = scene_from_sentence(text)
    assert next(asset.category for asset in scene.assets if "shel" in asset.category) == kind


def test_a_bed_with_something_broad_beside_it_has_one_night_stand() -> None:
    for text, count in (("a crib next to the bed", 1), ("a rug next to the bed", 2)):
        scene, _ = scene_from_sentence(f"A bedroom with {text}")
        assert sum(asset.category == "night stand" for asset in scene.assets) == count


def test_a_meeting_table_in_an_office_has_chairs_besides_those_at_desks() -> None:
    for text, count in (("An office with a meeting table", 9), ("An office with a meeting table and four chairs", 4)):
        scene, _ = scene_from_sentence(text)
        assert sum(asset.category.endswith("chair") for asset in scene.assets) == count


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("an armchair turned 45 degrees toward the fireplace", ["armchair", "fireplace"]),
        ("a sofa rotated 30 degrees", ["sofa"]),
        ("a kitchen where two people can cook at the same time", []),
        ("a reception with a counter facing the door", ["reception desk"]),
        ("a living room. Keep the centre of the room empty.", []),
    ],
)
def test_degrees_times_and_places_are_no_things(text: str, kinds: list[str]) -> None:
    assert [thing.noun.kind for thing in read(text).parsed.things] == kinds


def test_what_is_flanked_is_what_stands_at_the_wall() -> None:
    links = read("armchairs around a coffee table in the middle").parsed.links
    assert [(link.relation, link.subjects[0].thing.noun.kind) for link in links] == [
        ("around", "armchair"),
        ("middle", "coffee table"),
    ]
    links = read("two night stands flanking a bed against the north wall").parsed.links
    assert [(link.relation, link.subjects[0].thing.noun.kind) for link in links] == [
        ("flank", "night stand"),
        ("wall", "bed"),
    ]


def test_what_lies_before_each_seat_is_all_that_was_listed() -> None:
    text = "A dining table with six chairs and a plate, a fork and a glass in front of each chair"
    link = read(text).parsed.links[-1]
    assert [mention.thing.noun.kind for mention in link.subjects] == ["plate", "fork", "glass"]
