"""How people put it: shares of several things, one word for several kinds, parts of the room, what is left out."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

import robolayout as rl
from robolayout.constraints import WallRef
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.mounted_on import MountedOn
from robolayout.constraints.zone import Zone
from robolayout.planners import scene_from_sentence
from robolayout.scene import Asset, Room, Scene
from robolayout.words import Lexicon, Mention, read_rooms, read_text, read_words
from robolayout.words._halves import halves_meant
from robolayout.words._said import Place

LEXICON = Lexicon(read_rooms())


def links(text: str) -> set[tuple[str, ...]]:
    """Return (relation, subject, object) for everything that is said."""
    found: set[tuple[str, ...]] = set()
    for link in read_text(text, LEXICON).parsed.links:
        to = [o.thing.noun.said if isinstance(o, Mention) else o.name for o in link.objects] or [""]
        found |= {(link.relation, subject.thing.noun.said, other) for subject in link.subjects for other in to}
    return found


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        ("Four chairs are at a desk. One more chair is in the corner, another two by the door.", {"chair": 7, "desk": 1}),
        ("Two plants flank the door and a third stands in the corner.", {"plant": 3}),
        ("twelve desks. Every other desk has a monitor.", {"desk": 12, "monitor": 6}),
        ("six chairs. Half of the chairs have a cushion.", {"chair": 6, "cushion": 3}),
        ("a washer and a dryer. The machines are under a shelf.", {"washer": 1, "dryer": 1, "shelf": 1}),
        ("a cup of tea on a table. It seats six, two chairs on each side and one at each end.", {"cup": 1, "table": 1, "chair": 6}),
        ("three desks, each with a monitor, a keyboard and a chair in front", {"desk": 3, "monitor": 3, "keyboard": 3, "chair": 3}),
        ("two students; each student has a bed, a desk with a lamp, and a chair", {"bed": 2, "desk": 2, "lamp": 2, "chair": 2}),
        ("ten mats face the instructor's mat", {"mat": 11}),
        ("six beds, three along each long wall, and a curtain between each two beds", {"bed": 6, "curtain": 4}),
        ("two columns of six pews and a trio of candles", {"pew": 12, "candle": 3}),
        ("six groups of four desks, a string of lights", {"desk": 24, "light": 2}),
        ("three easels, each holding a vase", {"easel": 3, "vase": 3}),
        ("a table for six with plates and glasses for everyone", {"table": 1, "plate": 6, "glass": 6}),
        ("four boxes as obstacles in the middle", {"box": 4}),
        ("a student desk, four chairs and two tables with chairs", {"student desk": 1, "chair": 6, "table": 2}),
        ("a seating group of two sofas, a shelf with two bottles of detergent", {"sofa": 2, "shelf": 1, "bottle": 2}),
        ("a cabinet in each corner opposite the door and a plant in each corner", {"cabinet": 2, "plant": 4}),
        ("four desks, each with a chair on both sides", {"desk": 4, "chair": 8}),
        ("a hall where the walls are lined with benches", {"bench": 4}),
        ("Books and plants stand along the walls.", {"book": 2, "plant": 2}),
        ("a bedroom for two children with a desk each", {"desk": 2}),
        ("a bedroom with a desk each for three children", {"desk": 3}),
        ("a pantry with shelves on three walls", {"shelf": 3}),
        ("A judge's bench at the front, and three rows of benches at the back.", {"bench": 10}),
        ("five tables with 2-4 chairs each, two or three plants", {"table": 5, "chair": 20, "plant": 3}),
        ("3 pcs desk, 3 pcs chair", {"desk": 3, "chair": 3}),
        ("sofa/armchair/coffee table w/o tv", {"sofa": 1, "armchair": 1, "coffee table": 1}),
        ("bed (double), wardrobe (3 doors), sofa (3-seater), chairs (4)", {"bed": 1, "wardrobe": 1, "sofa": 1, "chair": 4}),
        ("a bar counter w/ 5 stools, 4 round tables each w/ 4 chairs", {"bar counter": 1, "stool": 5, "round table": 4, "chair": 16}),
        ("4 bed hospital ward, each bed with a cabinet", {"bed": 4, "cabinet": 4}),
        ("a table with benches instead of chairs and a lamp", {"table": 1, "bench": 2, "lamp": 1}),
        ("a table with 6 chairs instead of 4", {"table": 1, "chair": 6}),
        ("kitchen with island. Island has 3 stools.", {"island": 1, "stool": 3}),
        ("Move the cup to the sink. Kitchen with sink, fridge and stove", {"cup": 1, "sink": 1, "fridge": 1, "stove": 1}),
        ("a bedroom for my grandma, sink at a good height", {"sink": 1}),
        ("a library with 6 shelves (3 on each side)", {"shelf": 6}),
        ("a table, two chairs at the short sides of it, four at the long sides", {"table": 1, "chair": 6}),
        ("a bed. Nightstand both sides.", {"bed": 1, "nightstand": 2}),
        ("bed, wardrope on left wall, dumbell rack, coffee table", {"bed": 1, "wardrope": 1, "dumbell rack": 1, "coffee table": 1}),
    ],
)  # fmt: skip
def test_counts(text: str, counts: dict[str, int]) -> None:
    found: Counter[str] = Counter()
    for thing in read_text(text, LEXICON).parsed.things:
        found[thing.noun.said] += thing.count
    assert found == counts


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Six chairs surround the table.", {("around", "chair", "table")}),
        ("a loft bed and a desk underneath", {("under", "desk", "loft bed")}),
        ("A towel rack beside which hangs a mirror.", {("next", "mirror", "towel rack")}),
        ("a desk with a lamp on and a chair in front of it", {("on", "lamp", "desk"), ("front", "chair", "desk")}),
        ("There is a rug with a table on it in front of the sofa.", {("on", "table", "rug"), ("front", "rug", "sofa")}),
        ("A bed flanked by a nightstand on the left and a lamp on the right.", {("left", "nightstand", "bed"), ("right", "lamp", "bed")}),
        ("Two sofas facing each other across a table.", {("mutual", "sofa", ""), ("amid", "table", "sofa")}),
        (
            "A counter with a kettle is at the wall, and three stools are lined up in front of it.",
            {("with", "kettle", "counter"), ("by", "counter", "wall"), ("row", "stool", ""), ("front", "stool", "counter")},
        ),
        ("an armchair, a lamp behind it and a table beside it", {("behind", "lamp", "armchair"), ("next", "table", "armchair")}),
        ("None of the beds is under the window.", {("apart", "bed", "window")}),
        ("twenty desks and a teacher's desk in front of a whiteboard", {("front", "teacher desk", "whiteboard")}),
        ("a class with twenty desks and a teacher's desk in front of a whiteboard", {("front", "teacher desk", "whiteboard")}),
        ("two desks and a table in front of a whiteboard", {("front", "desk", "whiteboard"), ("front", "table", "whiteboard")}),
        ("a cafe with two tables with four chairs each and a bar along the wall", {("with", "chair", "table"), ("wall", "bar", "wall")}),
        ("a table and four chairs by the window", {("by", "table", "window")}),
        ("a desk and chair in the left corner", {("in", "desk", "corner")}),
        ("a desk by the window and two shelves on the opposite wall", {("by", "desk", "window"), ("on", "shelf", "wall")}),
        (
            "a sofa, two armchairs facing it and a table in between",
            {("facing", "armchair", "sofa"), ("amid", "table", "armchair"), ("amid", "table", "sofa")},
        ),
        ("two sofas with a table in between", {("amid", "table", "sofa")}),
        ("a wall of bookshelves", {("wall", "bookshelf", "wall")}),
        ("a wall-mounted TV", {("on", "wallmounted tv", "wall")}),
        ("On the left a desk, on the right a bed.", {("in", "desk", "side"), ("in", "bed", "side")}),
        (
            "A sofa is in the middle. On the left stands a lamp, on the right a plant.",
            {("middle", "sofa", ""), ("left", "lamp", "sofa"), ("right", "plant", "sofa")},
        ),
        ("A sleeping area on the left. The sleeping area has a bed and a wardrobe.", {("in", "bed", "side"), ("in", "wardrobe", "side")}),
        ("A reading nook by the window with an armchair and a lamp.", {("by", "armchair", "window")}),
        (
            "The front half of the room is a play area with a rug.",
            {*(("in", thing, "side") for thing in ("rug", "toy box", "play mat", "kids table")), ("near", "kids table", "toy box")},
        ),
        ("two armchairs and a sofa. All the seats face the door.", {("facing", "armchair", "door"), ("facing", "sofa", "door")}),
        ("a bed and a desk. The furniture stands along the walls.", {("wall", "bed", "wall"), ("wall", "desk", "wall")}),
        ("Along one wall: a sofa and a desk.", {("wall", "sofa", "wall"), ("wall", "desk", "wall")}),
        ("The left desk holds a lamp, the right one a vase.", {("on", "lamp", "desk"), ("on", "vase", "desk")}),
        ("three chairs in a row with a lamp at the end of the row", {("row", "chair", ""), ("end", "lamp", "chair")}),
        (
            "A sofa and a bench; between them, under the window, is a table.",
            {("amid", "table", "sofa"), ("amid", "table", "bench"), ("under", "table", "window")},
        ),
        (
            "On the desk are a lamp and a cup. Under it is a bin, and next to it a cabinet.",
            {("on", "lamp", "desk"), ("on", "cup", "desk"), ("under", "bin", "desk"), ("next", "cabinet", "desk")},
        ),
        ("The TV is visible from both the bed and the sofa.", {("seen", "tv", "bed"), ("seen", "tv", "sofa")}),
        ("a mirror above a desk, and chairs around it", {("above", "mirror", "desk"), ("around", "chair", "desk")}),
        ("a sofa at one end of the room", {("on", "sofa", "side")}),
        ("A bed is near a desk, both against the wall.", {("near", "bed", "desk"), ("wall", "bed", "wall"), ("wall", "desk", "wall")}),
        ("The shelf holds five books, and a plant is on top.", {("on", "book", "shelf"), ("on", "plant", "shelf")}),
        ("A bowl is on the table, with a candle in the middle.", {("on", "bowl", "table"), ("middle", "candle", "table")}),
        ("bottles on the shelves behind the counter", {("on", "bottle", "shelf"), ("behind", "shelf", "counter")}),
        ("A sink and a shower. A bed in the center against the wall.", {("wall", "bed", "wall")}),
        ("two tables with six chairs each by the window", {("with", "chair", "table"), ("by", "table", "window")}),
        ("a screen dividing the room", {("middle", "screen", "room")}),
        ("three pictures one above the other on the wall", {("tiered", "picture", ""), ("on", "picture", "wall")}),
        ("Two lamps frame the fireplace.", {("flank", "lamp", "fireplace")}),
        ("A plant flanks the door on each side.", {("flank", "plant", "door")}),
        ("a loft bed, a desk tucked under the bed", {("under", "desk", "loft bed")}),
        ("A dog bed lies at the foot of the bed.", {("foot", "dog bed", "bed")}),
        ("a studio with a small kitchen in one corner", {("in", "kitchen", "corner")}),
        ("a double bed with a bench at the foot", {("foot", "bench", "double bed")}),
        ("two beds, a wardrobe opposite the beds and a rug at their feet", {("opposite", "wardrobe", "bed"), ("foot", "rug", "bed")}),
        ("The walls are lined with bookshelves, two chairs face each other.", {("wall", "bookshelf", "wall"), ("mutual", "chair", "")}),
        ("a chair by the window with a lamp behind it", {("by", "chair", "window"), ("behind", "lamp", "chair")}),
        ("a sofa and a TV on the wall opposite", {("on", "tv", "wall"), ("opposite", "tv", "sofa")}),
        ("a desk she can roll under and a bed by the door", {("by", "bed", "door")}),
        ("A sink and a window above the sink.", {("under", "sink", "window")}),
        ("a table with six chairs near the bar", {("with", "chair", "table"), ("near", "table", "bar")}),
        ("a bed, a sofa, a shelf with cups above them", {("with", "cup", "shelf"), ("above", "shelf", "bed"), ("above", "shelf", "sofa")}),
        ("a table with magazines between two chairs", {("with", "magazine", "table"), ("amid", "table", "chair")}),
        ("twin beds sharing one nightstand", {("amid", "nightstand", "twin bed")}),
        ("two beds with a gap of 80 cm between them", {("apart", "bed", "")}),
        ("1. sofa\n2. tv opposite the sofa", {("opposite", "tv", "sofa")}),
        ("a desk infront of the window, a lamp besides the desk", {("front", "desk", "window"), ("next", "lamp", "desk")}),
        ("a bench in front of the bed, and in front of that a rug", {("front", "bench", "bed"), ("front", "rug", "bench")}),
        ("a bed pushed into the corner", {("in", "bed", "corner")}),
        ("a bed to the right of the door, a desk to the left", {("right", "bed", "door"), ("left", "desk", "door")}),
        (
            "a TV, a shelf to the left of it and a plant to the right",
            {("left", "shelf", "tv"), ("right", "plant", "tv")},
        ),
        (
            "a sofa on one end, a table with six chairs on the other end",
            {("on", "sofa", "side"), ("with", "chair", "table"), ("on", "table", "side")},
        ),
        ("a bed, a desk & chair opposite the bed", {("opposite", "desk", "bed"), ("opposite", "chair", "bed")}),
        ("a bed and a shelf above the headboard", {("above", "shelf", "bed")}),
        ("a desk by the door, a carpet corner with bean bags", {("by", "desk", "door"), ("in", "bean bag", "corner")}),
        ("a bathroom: toilet with 90cm free on left side", {("cleared", "toilet", "side")}),
        ("a bed. Nightstands left & right.", {("flank", "nightstand", "bed")}),
        ("a bed. At its foot a bench. Opposite, a dresser.", {("foot", "bench", "bed"), ("opposite", "dresser", "bed")}),
        ("The window is in the north wall. Under it is a desk.", {("under", "desk", "window")}),
        ("The door is in the south wall. A shelf is next to it. A box is on it.", {("next", "shelf", "door"), ("on", "box", "shelf")}),
        ("a bed, a desk and a sofa, but not near each other", {("far", "desk", "bed"), ("far", "sofa", "bed"), ("far", "sofa", "desk")}),
        ("three chairs far from each other", {("far", "chair", "chair")}),
        ("a bench by the door and a table with gizmos on it", {("by", "bench", "door")}),
        ("two guitars on stands by the wall", {("by", "guitar", "wall")}),
        ("two bikes on repair stands in the middle", {("middle", "bike", "")}),
        ("a china cabinet fills the corner", {("in", "china cabinet", "corner")}),
        ("a desk, and a conveyor passes in front of it", {("front", "conveyor", "desk")}),
        ("two curved rows of three desks", {("rows", "desk", "")}),
        ("a shelf with books on the wall", {("on", "shelf", "wall"), ("with", "book", "shelf")}),
        ("a desk, a shelf with books above it", {("above", "shelf", "desk"), ("with", "book", "shelf")}),
        ("a table with a lamp above it", {("above", "lamp", "table")}),
        ("three parallel shelves with 1.4 m between them", {("rows", "shelf", ""), ("apart", "shelf", "")}),
        ("four desks in a 2 by 2 block", {("rows", "desk", "")}),
        ("a bench in the middle with a rack along the wall", {("middle", "bench", ""), ("wall", "rack", "wall")}),
    ],
)  # fmt: skip
def test_relations(text: str, said: set[tuple[str, ...]]) -> None:
    assert links(text) == said


@pytest.mark.parametrize(
    ("text", "picked"),
    [
        ("Eight chairs. Half of the chairs are at the wall, the other half by the door.", [range(4), range(4, 8)]),
        ("six chairs. All but one face the door.", [range(5)]),
        ("Ten chairs. Most of the chairs face the door.", [range(7)]),
        ("Two sofas. One of the sofas is by the door, another is by the window.", [range(1), range(1, 2)]),
    ],
)
def test_some_of_several_are_picked(text: str, picked: list[range]) -> None:
    said = [item for link in read_text(text, LEXICON).parsed.links for item in link.subjects]
    assert [range(item.pick.start, item.pick.stop) for item in said if item.pick is not None] == picked


def test_a_thing_that_a_row_leaves_out_of_its_relation_is_given_back() -> None:
    scene, _ = scene_from_sentence("A bed, a wardrobe and a laptop. The bed, the wardrobe and the laptop are in a row.")
    rows = read_words(scene).rows
    (related,) = [row for row in rows if row.kind == "relation"]
    assert "laptop-0" not in related.things
    assert any(row.kind == "not understood" and row.words.startswith("laptop: ") for row in rows)


def test_pictures_in_a_row_hang_on_one_wall() -> None:
    scene, _ = scene_from_sentence("A living room with three pictures in a row.")
    (row,) = [row for row in read_words(scene).rows if row.kind == "relation"]
    assert len(row.demands) == 2
    assert {said.name for demand in row.demands for way in demand.ways for said in way} == {"near", "mounted_on"}


def walls_of(text: str) -> list[set[int]]:
    """Return the walls that each way of what is asked of walls names."""
    demands = [d for row in read_words(scene_from_sentence(text)[0]).rows for d in row.demands]
    found = [
        [[one for one in way if isinstance(one, AgainstWall | MountedOn)] for way in demand.ways] for demand in demands
    ]
    return [{one.wall.index for one in way if one.wall is not None} for ways in found for way in ways if way]


def test_both_walls_and_each_wall_have_some() -> None:
    assert walls_of("a storage room of 6 x 4 m with shelves on both long walls") == [{0, 2}]
    assert walls_of("a gallery with a painting on each wall") == [{0, 1, 2, 3}]
    assert walls_of("a pantry with six shelves on three walls") == [
        {1, 2, 3},
        {0, 1, 2},
        {0, 1, 3},
        {0, 2, 3},
    ]
    assert walls_of("a hall with benches along both walls") == [{0, 2}, {1, 3}, {0, 2}, {1, 3}]


@pytest.mark.parametrize(
    "text",
    [
        "a classroom with twenty desks and a teacher's desk, a globe on it and a bookshelf on the opposite wall",
        "two beds and a crib between them, each with a lamp on either side, one of them red and the other blue",
        "a bar with eight stools lined up in front of the counter, half of them high, and booths along both walls",
        "a desk each for two children, side by side under the window, with a shelf above each in between",
    ],
)
def test_a_text_may_end_after_any_word(text: str) -> None:
    """A list of which the last thing was the last word of all ended in an IndexError."""
    words = text.replace(",", " ,").split()
    for end in range(1, len(words) + 1):
        assert read_text(" ".join(words[:end]), LEXICON).words


def kinds(text: str) -> set[str]:
    return {thing.noun.kind for thing in read_text(text, LEXICON).parsed.things}


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("bedroom 10'6\" x 12' with a bed", (3.2, 3.66)),
        ("bedroom 10'6\" x 12' queen bed", (3.2, 3.66)),
        ("a room of 10 ft 6 in x 12 ft", (3.2, 3.66)),
        ("room 400x500 with a sofa", (4.0, 5.0)),
        ("room 4000 x 5000 with a sofa", (4.0, 5.0)),
        ("hall 30 x 40 with a sofa", (30.0, 40.0)),
    ],
)
def test_sizes_in_feet_and_inches_and_without_a_unit(text: str, size: tuple[float, float]) -> None:
    assert read_text(text, LEXICON).size == size


def test_a_size_in_brackets_is_that_of_the_thing() -> None:
    reading = read_text("bed, desk (120x60), chair", LEXICON)
    assert reading.size is None
    assert [measure.values for thing in reading.parsed.things for measure in thing.sizes] == [(1.2, 0.6)]


@pytest.mark.parametrize(
    "text",
    [
        "a room with a bed, a chair, nothing else",
        "a room with nothing but a bed and a chair",
        "only a bed and a chair. Nothing else.",
    ],
)
def test_nothing_is_added_where_nothing_else_is_wanted(text: str) -> None:
    scene, _ = scene_from_sentence(text)
    assert sorted(asset.name for asset in scene.assets) == ["bed-0", "chair-0"]
    assert {row.kind for row in read_words(scene).rows} == {"count", "refusal"}


@pytest.mark.parametrize(
    ("text", "refused"),
    [
        ("a living room with everything except a tv", ["television"]),
        ("a table with benches instead of chairs", ["chair"]),
        ("a bathroom with a shower rather than a bathtub", ["bathtub"]),
    ],
)
def test_what_is_replaced_or_excepted_is_not_there(text: str, refused: list[str]) -> None:
    scene, _ = scene_from_sentence(text)
    assert [noun.kind for noun, _ in read_text(text, LEXICON).parsed.refused] == refused
    assert not {asset.name.rsplit("-", 1)[0] for asset in scene.assets} & {*refused}


@pytest.mark.parametrize(
    ("text", "room"),
    [
        ("a dentist's surgery", "exam room"),
        ("doctors surgery: exam couch along the wall", "exam room"),
        ("a nail bar with four manicure tables", "salon"),
        ("a therapist's room: two armchairs", "therapy room"),
        ("baby room - crib, rug", "nursery"),
        ("Bedroom/office combo, desk by the window", "bedroom"),
        ("bedroom twin beds pushed together", "bedroom"),
    ],
)
def test_rooms_by_other_names(text: str, room: str) -> None:
    assert read_text(text, LEXICON).room == room


def test_a_room_where_children_sleep_is_theirs() -> None:
    scene, _ = scene_from_sentence("I want a room where two kids can sleep and do homework")
    assert Counter(asset.category for asset in scene.assets)["single bed"] == 2


def test_people_are_counted_in_the_name_of_a_room() -> None:
    assert read_text("a 3-person office", LEXICON).people == 3
    assert read_text("a 12 seat conference room", LEXICON).people == 12


def test_a_shelf_above_a_desk_hangs_where_others_stand_in_such_a_room() -> None:
    scene, _ = scene_from_sentence("a children's room with a shelf above the desk")
    assert "wall shelf" in {asset.category for asset in scene.assets}


def test_slips_of_spelling_are_named_by_what_they_mean() -> None:
    assert kinds("bed, wardrope on left wall, dumbell rack") == {"bed", "wardrobe", "dumbbell rack"}
    scene, _ = scene_from_sentence("bed, wardrope on left wall")
    assert "wardrobe-0" in {asset.name for asset in scene.assets}


def test_what_stands_at_stations_is_there_once() -> None:
    scene, _ = scene_from_sentence("a hair salon with 3 stations each with a mirror and a chair")
    counts = Counter(asset.category for asset in scene.assets)
    assert (counts["mirror"], counts["salon chair"]) == (3, 3)
    assert (counts["vanity table"], counts["chair"]) == (3, 0)


def test_company_tells_what_a_noun_means() -> None:
    assert kinds("a kitchen with a breakfast bar and four stools") == {"kitchen island", "bar stool"}
    assert kinds("a room with a counter, a table and four stools") >= {"stool"}
    assert kinds("a bathroom with a double sink") == {"bathroom vanity"}
    assert kinds("a kitchen with a double sink") == {"kitchen sink"}


def test_rows_name_things_as_they_were_said() -> None:
    scene, _ = scene_from_sentence("A hall with a tall vase in the corner.")
    (row,) = [row for row in read_words(scene).rows if row.kind == "relation"]
    assert row.words == "vase in corner"


def test_who_sits_behind_a_desk_has_the_others_across_it() -> None:
    text = (
        "An office with a desk facing the door, an office chair behind it and two visitor chairs in front of the desk."
    )
    rows = {row.words: row.understanding for row in read_words(scene_from_sentence(text)[0]).rows}
    assert rows["office chair behind desk"] == "in_front_of(office_chair-0, desk-0, min_gap=-0.6, max_gap=1.2)"
    assert "angle=180" in rows["desk facing door"] and "other ways" not in rows["desk facing door"]
    assert "behind(visitor_chair-0, desk-0" in rows["visitor chair in front of desk"]


def test_what_flanks_a_door_is_at_its_wall_one_on_each_side() -> None:
    scene, _ = scene_from_sentence("A hall with a bookcase on either side of the door.")
    (row,) = [row for row in read_words(scene).rows if row.kind == "relation"]
    (wall,) = [door.wall for door in scene.room.doors]
    (demand,) = row.demands
    assert len(demand.ways) == 2
    for way in demand.ways:
        assert [one.name for one in way] == ["against_wall", "near", "zone"] * 2
        assert {one.wall for one in way if isinstance(one, AgainstWall)} == {WallRef(wall)}
        assert len({one.polygon for one in way if isinstance(one, Zone)}) == 2


def test_the_seats_of_a_scene_are_all_that_it_has() -> None:
    table, chair = Asset("dining_table-0", "dining table", (0.9, 1.6, 0.75)), (0.5, 0.5, 0.9)
    chairs = [Asset(f"dining_chair-{i}", "dining chair", chair) for i in range(2)]
    plates = [Asset(f"plate-{i}", "plate", (0.2, 0.2, 0.02), on_floor=False, on_object=True) for i in range(2)]
    rest = [Asset(f"armchair-{i}", "armchair", (0.8, 0.8, 0.9)) for i in range(2)]
    text = "A table with two armchairs for afterwards. Plates before the seats."
    scene = Scene(Room(((0, 0), (5, 0), (5, 4), (0, 4)), 2.6), (table, *chairs, *plates, *rest), task_description=text)
    (row,) = [row for row in read_words(scene).rows if "plate" in row.words.lower() and row.kind == "relation"]
    assert {name.split("-")[0] for name in row.things} == {"plate", "dining_chair"}


def test_visitors_sit_across_a_desk_whose_owner_gets_a_chair() -> None:
    scene, understood = scene_from_sentence("A consulting room with a desk with two visitor chairs.")
    assert understood.added["office chair"] == 1
    rows = {row.words: row.understanding for row in read_words(scene).rows}
    assert "behind(visitor_chair-0, desk-0" in rows["desk with two visitor chairs"]


@pytest.mark.parametrize("desk", ["gaming desk", "executive desk", "desk"])
def test_a_desk_of_any_name_has_a_chair(desk: str) -> None:
    assert scene_from_sentence(f"A bedroom with a bed and a {desk}.")[1].added["office chair"] == 1


def test_four_things_back_to_back_are_two_rows() -> None:
    scene, _ = scene_from_sentence("A library with four bookshelves back to back in the centre.")
    (row,) = [row for row in read_words(scene).rows if "back to back" in row.words]
    assert "aisle=0.6, paired, 2)" in row.understanding


def test_floor_things_on_both_sides_of_what_hangs_have_it_between_them() -> None:
    scene, _ = scene_from_sentence("A hall with a mirror on the wall flanked by two benches.")
    understood = [row.understanding for row in read_words(scene).rows if "bench" in row.words]
    assert any("between(mirror-0, bench-0, bench-1)" in text for text in understood)


@pytest.mark.parametrize(
    ("text", "table", "said"),
    [
        ("A room with a bed and a table with four chairs in the corner.", "dining_table", "near("),
        ("A room with a bed and a table in the corner.", "dining_table", "near("),  # it has four chairs
        ("A kitchen with a table for two in the corner.", "dining_table", "corner("),
        ("An office with a desk in the corner facing the door.", "desk", "near("),
        ("An office with a desk in the corner and a bookshelf behind the desk.", "desk", "near("),
    ],
)
def test_what_can_touch_no_wall_is_near_its_corner(text: str, table: str, said: str) -> None:
    scene, _ = scene_from_sentence(text)
    (row,) = [row for row in read_words(scene).rows if "corner" in row.words and row.kind == "relation"]
    assert row.understanding.startswith(f"{said}{table}-0")


def test_a_stand_is_for_what_stands_on_it() -> None:
    assert "tv stand" in scene_from_sentence("A living room with a television on a stand.")[1].wished


def test_standing_free_in_the_middle_is_about_who_stands_there() -> None:
    assert links("A dining room. The table stands free in the middle with its chairs around it.") >= {
        ("middle", "table", "")
    }


@pytest.mark.parametrize(
    "text", ["a living room with a {} in the corner", "a hall with a bed and a {}", "two {}s at the window"]
)
def test_relations_know_the_kinds_of_ones_own(text: str, tmp_path: Path) -> None:
    file = tmp_path / "own.toml"
    wheel = '["spinning wheel"]\nlike = "easel"\nsize = [0.8, 0.45, 1.0]\nplace = ["floor"]\nrole = "statue"\n'
    file.write_text(wheel + '[group]\nlabel = "crafts"\nwhy = "For the light."\n', encoding="utf-8")
    scene, understood = scene_from_sentence(text.format("spinning wheel"), knowledge=[file])
    assert understood.wished["spinning wheel"] >= 1 and read_words(scene).rows


def test_word_salad_is_read() -> None:
    scene, _ = scene_from_sentence("room height between under them, the window, is a table")
    assert any(row.words == "a table" for row in read_words(scene).rows)


@pytest.mark.parametrize(
    "text",
    [
        "A studio with a desk and a small table with two chairs",
        "A living room with a sofa and a table with two chairs",
        "A living room with a sofa. Two chairs stand around a small table.",
    ],
)
def test_a_table_that_has_chairs_is_no_coffee_table(text: str) -> None:
    wished = scene_from_sentence(text)[1].wished
    assert wished["chair"] == 2 and {"dining table", "round table"} & wished.keys()


def said(text: str) -> set[tuple[str, str]]:
    """Return the words of every row about where things stand, with how each was understood."""
    rows = read_words(scene_from_sentence(text)[0]).rows
    return {(row.words, row.understanding) for row in rows if row.kind in ("relation", "not understood")}


@pytest.mark.parametrize(
    ("text", "above"),
    [
        (
            "A kitchen with a counter along the back wall with pans hanging above it.",
            ["above(pan-0, kitchen_counter-0)"],
        ),
        (
            "A garage with a car in the middle and a workbench with a pegboard hanging above it.",
            ["above(pegboard-0, workbench-0)"],
        ),
    ],
)
def test_what_hangs_over_what_has_it_is_not_on_that(text: str, above: list[str]) -> None:
    rows = said(text)
    found = [how for _, how in rows if how.startswith("above")]
    assert len(found) == 1 and all(one in found[0] for one in above)
    assert not [how for _, how in rows if how.startswith(("on_top_of", "near")) or "no word" in how]


def test_front_left_is_left_of_who_looks_at_the_board() -> None:
    (_, how), *others = said("A classroom with a board and the teacher's desk at the front left.")
    assert (
        not others and how.startswith("in_front_of(teacher_desk-0, board-0") and "mounted_on(board-0, walls[0])" in how
    )
    scene = scene_from_sentence("An office with a plant at the back right of the room.")[0]
    (row,) = (row for row in read_words(scene).rows if row.kind == "relation")
    x0, y0, x1, y1 = scene.room.bounds
    zone = row.demands[0].ways[0][0]
    assert isinstance(zone, Zone)
    assert {(p.x, p.y) for p in zone.polygon} == {
        (round(x, 3), round(y, 3)) for x in ((x0 + x1) / 2, x1) for y in ((y0 + y1) / 2, y1)
    }


def test_pupils_in_rows_have_their_desks_in_rows() -> None:
    rows = said("A classroom for sixteen pupils in four rows, with the teacher's desk at the front.")
    (how,) = (how for _, how in rows if how.startswith("in_rows"))
    assert "student_desk-15" in how and how.endswith("4)") and "teacher_desk" not in how


def test_who_gets_into_a_bed_from_both_sides_has_free_floor_there() -> None:
    (_, how), *others = said("A bedroom with a bed she can get into from both sides.")
    assert not others and "keep_clear(bed-0, left)" in how


def test_an_aisle_between_columns_is_no_column_and_a_station_is_what_the_room_has() -> None:
    pews = said("A church hall with ten pews in two columns, with an aisle of 1.5 m between the columns.")
    assert not [how for _, how in pews if "column_post" in how]
    racks = said("A warehouse with four pallet racks in two rows back to back and a forklift aisle of 3 m.")
    assert racks and all("aisle=3" in how for _, how in racks)
    salon = said("A hair salon with three stations along the right wall.")
    assert [how for _, how in salon if how.startswith("against_wall(vanity_table-0")]


def test_two_halves_that_share_nothing_are_two_ways() -> None:
    room = scene_from_sentence("An office of 4 x 3 m.")[0].room
    left, right = halves_meant(room, Place("side", ("left", "right")))
    assert {point.x for point in (*left, *right)} == {0.0, 2.0, 4.0}
    (corner,) = halves_meant(room, Place("side", ("back", "left")))
    assert {(point.x, point.y) for point in corner} == {(x, y) for x in (0.0, 2.0) for y in (1.5, 3.0)}


@pytest.mark.parametrize(
    ("text", "meant", "not_meant"),
    [
        (
            "An armchair by the window with a lamp behind it, a side table with a book to its right and a bookcase to its left.",
            {("right", "side table", "armchair"), ("left", "bookcase", "armchair")},
            {("right", "book", "side table"), ("left", "bookcase", "side table")},
        ),
        (
            "Eight tables along the windows, a bar with six stools opposite and a host stand near the door.",
            {("opposite", "bar", "table")},
            {("opposite", "stool", "bar")},
        ),
        ("A desk with a chair opposite.", {("opposite", "chair", "desk")}, set()),
        (
            "A desk in the corner, a printer on a low cabinet next to it.",
            {("next", "cabinet", "desk"), ("on", "printer", "cabinet")},
            {("next", "cabinet", "printer")},
        ),
        (
            "The sofa faces the fireplace, an armchair on either side of the fireplace, and a coffee table in between.",
            {("amid", "coffee table", "sofa"), ("amid", "coffee table", "fireplace")},
            {("amid", "coffee table", "armchair")},
        ),
        (
            "A desk in front of the window, a leather chair behind it.",
            {("behind", "chair", "desk")},
            {("behind", "chair", "window")},
        ),
        (
            "Two armchairs with a side table between them on the left and a plant on the right.",
            {("in", "armchair", "side"), ("in", "plant", "side"), ("amid", "side table", "armchair")},
            {("left", "side table", "armchair")},
        ),
        (
            "A studio of 5 by 6 m with a sleeping area behind a bookcase, a kitchenette along the left wall and a sofa.",
            {("behind", "bed", "bookcase"), ("wall", "kitchenette", "wall")},
            {("behind", "kitchenette", "bookcase")},
        ),
        (
            "A robot vacuum should get under the bed in this studio of 5 by 6 m with a sofa and a bed.",
            set(),
            {("with", "sofa", "bed")},
        ),
        ("A bookcase anchored to the wall.", {("on", "bookcase", "wall")}, set()),
    ],
)
def test_what_a_side_is_of(text: str, meant: set[tuple[str, ...]], not_meant: set[tuple[str, ...]]) -> None:
    found = links(text)
    assert meant <= found and not not_meant & found


def test_a_thing_on_the_table_before_each_chair_is_there_for_each_and_the_table_once() -> None:
    rows = said("A dining room with a table, six chairs and a plate on the table in front of each chair.")
    assert [how for _, how in rows if "plate-5" in how or how.endswith("...")]
    assert not [how for _, how in rows if "dining_table-1" in how]


@pytest.mark.parametrize(
    ("text", "starts"),
    [
        ("A warehouse with six pallet racks in three double rows and 2.5 m aisles.", "in_rows("),
        ("A laboratory with four workbenches in a square and 1.2 m of free floor around the benches.", "in_rows("),
        ("A bedroom with a bed with space on both sides.", "keep_clear(bed-0, left"),
        ("A dorm with two single beds along the side walls.", "against_wall(single_bed-0, walls[1]), against_wall(single_bed-1, walls[3])"),
        ("A study with a desk, a chair behind it and an armchair facing the desk.", "behind(armchair-0, desk-0"),
        ("A kitchen with a microwave above the stove.", "above(microwave-0, stove-0)"),
        ("A clinic with an exam table so the doctor can walk around it.", "keep_clear(examination_table-0"),
        ("A ward with two beds and a small table on wheels over the bed.", "near(overbed_table-0"),
        ("A bathroom with a shower, a toilet with free space at its left and a basin.", "keep_clear(toilet-0, left"),
        ("A laboratory with a fume hood against the back wall and nothing in front of the fume hood.", "keep_clear(fume_hood-0"),
        ("A guest room with a sofa bed and enough room to open the sofa bed.", "keep_clear(sofa_bed-0"),
        ("A hotel room with a desk by the window with its chair facing the view.", "point_towards(desk-0"),
        ("An armchair, a side table at its right with a lamp, a bookshelf behind it.", "behind(bookshelf-0, armchair-0"),
        ("A workshop with two workbenches back to back in the middle.", "in_rows([workbench-0, workbench-1], aisle=0.6, paired, 2)"),
        ("A nursery with two cribs side by side with a rug between them.", "next_to(crib-0, crib-1, max_gap=0.5), align_with"),
        ("An office with eight desks in two groups of four, a plant between the groups.", "plant-0 between desk-2 and desk-6"),
        ("A therapy room with two armchairs at an angle of 90 degrees to each other.", "near(armchair-1, armchair-0, max_gap=1.2), align"),
        ("A shop with a workbench along the left wall with tools above it.", "above(pegboard-0, workbench-0)"),
        ("A playroom with as much free floor in the middle as possible.", "zone("),
        ("A meeting room with a U-shaped arrangement of tables for twelve, open towards the screen.", "align_with(conference_table"),
    ],
)  # fmt: skip
def test_phrases_that_people_use(text: str, starts: str) -> None:
    rows = said(text)
    assert [how for _, how in rows if how.startswith(starts)], rows
    assert not [words for words, how in rows if "no word" in how]


def test_double_rows_stand_back_to_back_and_benches_with_floor_around_apart() -> None:
    (double, *_) = (how for _, how in said("A warehouse with six pallet racks in three double rows and 2.5 m aisles."))
    assert double.endswith("aisle=2.5, paired, 6)")
    text = "A laboratory with four workbenches in a square and 1.2 m of free floor around the benches."
    (square,) = (how for _, how in said(text) if how.startswith("in_rows"))
    assert square.endswith("aisle=1.2, gap=1.2, 2)")


def test_a_galley_kitchen_says_its_counters_once() -> None:
    told = scene_from_sentence("A galley kitchen with counters along both long walls.")[0]
    bare = scene_from_sentence("A galley kitchen with a fridge.")[0]
    for scene in (told, bare):
        assert sum(asset.category == "kitchen counter" for asset in scene.assets) == 2


def test_what_is_kept_out_is_not_there() -> None:
    scene, _ = scene_from_sentence("A living room with a sofa and an armchair. Keep the TV out of it.")
    assert not [one.name for one in scene.assets if one.category in ("television", "tv stand")]


def test_a_robot_that_patrols_an_office_is_its_body() -> None:
    reading = read_text("A quadruped robot patrols this office with six desks along the walls.", LEXICON)
    assert reading.agent == "spot"


def test_benches_are_as_long_as_those_who_sit_there_and_take_the_place_of_chairs() -> None:
    scene, _ = scene_from_sentence("A dining room with a table for ten with benches on both sides.")
    kinds = [asset.category for asset in scene.assets]
    assert "chair" not in kinds and kinds.count("bench") == 2
    assert all(asset.size[1] >= 3.0 for asset in scene.assets if asset.category == "bench")


def test_what_is_said_of_a_table_later_is_its_shape_and_what_hangs_over_a_minibar_needs_no_stand() -> None:
    scene, _ = scene_from_sentence("A living room with a sofa and a coffee table. The coffee table is round.")
    table = scene.by_name["coffee_table-0"]
    assert table.size[0] == pytest.approx(table.size[1], abs=0.01)
    scene, _ = scene_from_sentence("A hotel room with a bed facing the TV and a minibar under the TV.")
    assert "tv stand" not in [asset.category for asset in scene.assets]
    hood = "range hood"
    cooks = (scene_from_sentence(f"A kitchen with a {what}.")[0] for what in ("microwave above the stove", "stove"))
    assert [hood in [asset.category for asset in kitchen.assets] for kitchen in cooks] == [False, True]


def test_what_is_put_in_a_room_is_in_no_wardrobe_and_the_window_is_across_from_the_door() -> None:
    text = "My bedroom is 3.2 by 4.1 m. The door is in the south wall, the window is opposite. Put a bed, a wardrobe and a desk in it."
    scene, _ = scene_from_sentence(text)
    assert not [words for words, how in said(text) if "wardrobe" in words and "on_top" in how]
    assert scene.room.doors[0].wall == 0 and scene.room.windows[0].wall == 2


def test_what_is_no_higher_than_another_thing_does_not_refuse_that() -> None:
    scene, _ = scene_from_sentence("A living room with a sofa and a bookcase no higher than the sofa.")
    assert "sofa" in [asset.category for asset in scene.assets]


def test_pupils_in_pairs_have_desks_in_pairs_and_four_corners_four_things() -> None:
    scene, _ = scene_from_sentence("A classroom for eight pupils in pairs, a teacher's desk and a whiteboard.")
    assert sum(asset.category == "student desk" for asset in scene.assets) == 8
    scene, _ = scene_from_sentence("A library with shelves no higher than 1.2 m along the walls.")
    assert {asset.size[2] for asset in scene.assets if asset.category == "bookshelf"} == {1.2}
    scene, _ = scene_from_sentence("A home cinema with a sofa and speakers in the four corners.")
    assert sum(asset.category == "speaker" for asset in scene.assets) == 4


def test_the_arms_of_an_l_are_where_it_has_them() -> None:
    text = "An L-shaped living room with the dining table in the short arm and a sofa in the longer arm of the L."
    scene, _ = scene_from_sentence(text)
    zones = [how for _, how in said(text) if how.startswith("zone(")]
    assert len(zones) == 2
    x0, y0, x1, y1 = scene.room.bounds
    for long, room in ((False, scene.room), (True, Room(tuple((y, x) for x, y in reversed(scene.room.vertices)), 2.6))):
        (arm,) = halves_meant(room, Place("side", ("greater" if long else "lesser", "arm")))
        xs, ys = [point.x for point in arm], [point.y for point in arm]
        area = (max(xs) - min(xs)) * (max(ys) - min(ys))
        assert area == pytest.approx((x1 - x0) * (y1 - y0) / (2 if long else 4), rel=0.01)
    assert not [*halves_meant(Room(((0, 0), (4, 0), (4, 3), (0, 3)), 2.6), Place("side", ("lesser", "arm")))]


def test_a_mat_under_what_hangs_is_no_rug_of_the_table() -> None:
    result = rl.generate(
        "A playroom with wall bars, a soft mat under them and a low table with four small chairs.", dress="none"
    )
    assert result.report.ok, result.report.violations
