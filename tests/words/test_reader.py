"""What is read in sentences: things with counts, relations between them, and what becomes of every word."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from robolayout._errors import SceneError
from robolayout.words import Lexicon, Mention, Place, Reading, read_rooms, read_text

LEXICON = Lexicon(read_rooms())


def read(text: str) -> Reading:
    return read_text(text, LEXICON)


def things(text: str) -> dict[str, int]:
    return {thing.noun.words: thing.count for thing in read(text).parsed.things}


def links(text: str) -> set[tuple[str, ...]]:
    """Return (relation, subject, object) for everything that is said."""
    found: set[tuple[str, ...]] = set()
    for link in read(text).parsed.links:
        to = [o.thing.noun.words if isinstance(o, Mention) else o.name for o in link.objects] or [""]
        found |= {(link.relation, subject.thing.noun.words, other) for subject in link.subjects for other in to}
    return found


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        ("a room with two sofas and a pair of lamps", {"sofa": 2, "table lamp": 2}),
        ("twenty desks and chairs", {"desk": 20, "chair": 20}),
        ("two desks, each with a monitor and an office chair", {"desk": 2, "monitor": 2, "office chair": 2}),
        ("four round tables with four chairs each", {"round table": 4, "chair": 16}),
        ("eight round tables and eight chairs around each table", {"round table": 8, "chair": 64}),
        ("a bed with a nightstand on each side", {"bed": 1, "night stand": 2}),
        ("a table, four chairs on each long side and one at each end", {"dining table": 1, "chair": 10}),
        ("a table. Three chairs on each side of the table and one at the head", {"dining table": 1, "chair": 7}),
        ("a table with eight chairs: three per long side and one at either end", {"dining table": 1, "chair": 8}),
        ("three kids. Each child needs a bed and a chair. Twenty-four books (x3)", {"bed": 3, "chair": 3, "book": 24}),
        ("cabinets (x3), plates (five in total) and a glass", {"cabinet": 3, "plate": 5, "glass": 1}),
        (
            "a bed flanked by two nightstands; each of them carries a lamp",
            {"bed": 1, "night stand": 2, "table lamp": 2},
        ),
        ("an office for four: desks in pairs, each desk has a monitor", {"desk": 4, "monitor": 4}),
        ("The first sofa is at the north wall, the second one at the east wall.", {"sofa": 2}),
        (
            "a table, a high chair at one end and chairs along the sides",
            {"dining table": 1, "high chair": 1, "chair": 2},
        ),
        (
            "four tables along the windows, two tables in the middle. Each table has a candle.",
            {"dining table": 2, "candle": 6},
        ),
        ("a table displaying sweaters", {"dining table": 1, "clothes": 2}),
        ("bookshelves line two walls", {"bookshelf": 4}),
        ("a desk for the therapist and a mirror", {"desk": 1, "mirror": 1}),
        ("a square table with one chair on each side", {"dining table": 1, "chair": 4}),
        ("a long table, five chairs per side", {"dining table": 1, "chair": 10}),
        (
            "a table with six chairs, three on each side, and a bed with two nightstands on each side",
            {"dining table": 1, "chair": 6, "bed": 1, "night stand": 2},
        ),
        ("a worktable with six stools and shelves along the wall", {"dining table": 1, "stool": 6, "shelving unit": 2}),
        ("two nightstands and a lamp on each nightstand", {"night stand": 2, "table lamp": 2}),
        ("at least three shelves and at most two plants", {"shelving unit": 3, "plant": 2}),
        ("a plant in each corner", {"plant": 4}),
        ("a bed. The bed is brown. Keep the bed near the window.", {"bed": 1}),
        ("three rows of four student desks", {"student desk": 12}),
        ("a media console with a 65-inch TV above it", {"tv stand": 1, "television": 1}),
        ("3 bookcases. No bookcase blocks the door.", {"bookshelf": 3}),
        ("three chairs, each facing its own mirror", {"chair": 3, "mirror": 3}),
        ("a two-seater sofa, a four-poster bed and a trash can", {"sofa": 1, "bed": 1, "trash can": 1}),
        ("a plant stands on the TV stand", {"potted plant": 1, "tv stand": 1}),
        ("a shop with flower stands", {"plant stand": 2}),
        ("a dresser in the middle as an island", {"dresser": 1}),
        ("two desks, one chair per desk", {"desk": 2, "chair": 2}),
        ("an office for three people. Each person has a desk and a monitor.", {"desk": 3, "monitor": 3}),
        ("two floor lamps, one in each corner", {"floor lamp": 2}),
        ("a pool table at least 1.5 m from every wall", {"pool table": 1}),
        ("a rack for shoes by the door", {"shelving unit": 1}),
        ("four pairs of shoes on a rack, two pairs of armchairs", {"shoes": 4, "shelving unit": 1, "armchair": 4}),
        ("three chairs in a semicircle", {"chair": 3}),
        ("two people watch films on a sofa", {"sofa": 1}),
        ("a watch on the desk", {"jewelry box": 1, "desk": 1}),
        ("twelve student desks in 3 rows and 4 columns", {"student desk": 12}),
        ("a round table for four. A cabinet is behind the chairs.", {"round table": 1, "cabinet": 1, "chair": 4}),
        ("a theater with 30 seats in 5 rows of 6", {"seat": 30}),
        ("three chairs. The second chair is red. The third one is blue.", {"chair": 3}),
        ("four tables, each surrounded by six chairs", {"dining table": 4, "chair": 24}),
        ("four rows of racks and two pairs of armchairs", {"shelving unit": 12, "armchair": 4}),
        ("a slide in one corner and a bed in another", {"slide": 1, "bed": 1}),
        (
            "four square tables and four round tables; the round ones stand at the window",
            {"dining table": 4, "round table": 4},
        ),
        ("a chest of drawers and a sideboard with three drawers", {"dresser": 1, "sideboard": 1}),
        ("a chair for the doctor and a bed for my daughter", {"chair": 1, "bed": 1}),
        (
            "six workstations, each consisting of a desk, an office chair, and a monitor",
            {"desk": 6, "office chair": 6, "monitor": 6},
        ),
        ("1 sofa, 1 television. Layout: sofa opposite television", {"sofa": 1, "television": 1}),
        ("A classroom with twelve desks. The teacher's desk is by the door.", {"desk": 12, "teacher desk": 1}),
        ("a toilet, a washbasin and a shower are lined up", {"toilet": 1, "washbasin": 1, "shower": 1}),
        ("two windows in the north wall. In front of each window is an armchair", {"armchair": 2}),
        (
            "3 lamps and 2 sofas. One lamp should be next to each sofa and the third one on the table.",
            {"floor lamp": 3, "sofa": 2, "dining table": 1},
        ),
        ("a bed in the middle of the wall and a window on each side of it", {"bed": 1}),
        ("six tables for two near the window", {"dining table": 6}),
        ("a bed and two nightstands. Both nightstands have a lamp.", {"bed": 1, "night stand": 2, "table lamp": 2}),
        ("four tables. Each table has a board on it and two chairs.", {"dining table": 4, "board": 4, "chair": 8}),
        ("chairs (4), lamps: 2, a 2 x 3 m rug and sofas x 2", {"chair": 4, "table lamp": 2, "rug": 1, "sofa": 2}),
        (
            "two dressers. Both dressers have a lamp. It should have two sofas.",
            {"dresser": 2, "table lamp": 2, "sofa": 2},
        ),
        ("two desks, each one with a lamp, along with a sofa", {"desk": 2, "table lamp": 2, "sofa": 1}),
        ("four beds, each of which has a curtain and a cabinet", {"bed": 4, "curtain": 4, "cabinet": 4}),
        (
            "a lamp on the left nightstand and a clock on the right nightstand",
            {"table lamp": 1, "alarm clock": 1, "night stand": 2},
        ),
        ("a bed and a TV that I can watch from bed", {"bed": 1, "television": 1}),
        ("a desk with two chairs in front of it and one behind it", {"desk": 1, "chair": 3}),
        ("an arcade cabinet in each of the back corners", {"arcade machine": 2}),
        (
            "two nightstands, each of them holding a lamp and a clock",
            {"night stand": 2, "table lamp": 2, "alarm clock": 2},
        ),
        (
            "four armchairs; each armchair faces the table. A rug lies underneath all of them.",
            {"armchair": 4, "dining table": 1, "rug": 1},
        ),
        ("five tables. Three of them are square and seat four, the remaining two are round.", {"dining table": 5}),
    ],
)
def test_counts(text: str, counts: dict[str, int]) -> None:
    assert things(text) == counts


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("a desk under the window with a chair in front of it", {("under", "desk", "window"), ("front", "chair", "desk")}),
        ("On the desk is a laptop.", {("on", "laptop", "desk")}),
        ("Next to the sofa is a side table and on it stands a lamp.", {("next", "side table", "sofa"), ("on", "table lamp", "side table")}),
        ("a sofa against the wall, a coffee table in front of it", {("wall", "sofa", "wall"), ("front", "coffee table", "sofa")}),
        ("There is a lamp and a book on the desk.", {("on", "table lamp", "desk"), ("on", "book", "desk")}),
        ("The armchair is in the corner and faces the desk.", {("in", "armchair", "corner"), ("facing", "armchair", "desk")}),
        ("a sofa, a piano and a rug between them", {("amid", "rug", "piano"), ("amid", "rug", "sofa")}),
        (
            "a sofa facing the TV, a rug between them and a plant in each corner",
            {("facing", "sofa", "television"), ("amid", "rug", "sofa"), ("amid", "rug", "television"), ("in", "plant", "corner")},
        ),
        (
            "two armchairs with a side table between them and a lamp on it",
            {("amid", "side table", "armchair"), ("on", "table lamp", "side table")},
        ),
        ("tables in rows, guests are received near the door", {("rows", "dining table", "")}),
        ("three stacked crates in the corner", {("stacked", "crate", ""), ("in", "crate", "corner")}),
        ("an armchair with a table to its right", {("right", "dining table", "armchair")}),
        (
            "an armchair by the window, a lamp behind the armchair, a small table with a cup and a book to its right",
            {
                ("by", "armchair", "window"),
                ("behind", "floor lamp", "armchair"),
                ("with", "cup", "side table"),
                ("with", "book", "side table"),
                ("right", "side table", "armchair"),
            },
        ),
        ("a round table with two stools by the window", {("with", "stool", "round table"), ("by", "round table", "window")}),
        ("a sofa facing a TV on a stand", {("facing", "sofa", "television"), ("on", "television", "tv stand")}),
        ("Two nightstands are placed on either side of the bed.", {("flank", "night stand", "bed")}),
        ("a desk with a computer near the door", {("with", "computer", "desk"), ("near", "desk", "door")}),
        ("a laptop and a mug are on the desk", {("on", "laptop", "desk"), ("on", "mug", "desk")}),
        ("a hood over the stove", {("above", "hood", "stove")}),
        ("a table with chairs around it and a bowl on top", {("around", "chair", "dining table"), ("on", "bowl", "dining table")}),
        (
            "a table with four chairs stands in the center, and an armchair with a floor lamp sits in a corner",
            {
                ("with", "chair", "dining table"),
                ("middle", "dining table", ""),
                ("with", "floor lamp", "armchair"),
                ("in", "armchair", "corner"),
            },
        ),
        ("a bed with a headboard against the east wall", {("wall", "bed", "wall")}),
        ("a vanity with two mirrors above", {("above", "mirror", "vanity")}),
        ("a worktable with six stools and shelves along the wall", {("with", "stool", "dining table"), ("wall", "shelving unit", "wall")}),
        ("a sofa flanked by two lamps", {("flank", "floor lamp", "sofa")}),
        ("a lamp on the nightstand by the bed", {("on", "table lamp", "night stand"), ("by", "night stand", "bed")}),
        ("a table and ten chairs: four on each long side and one at each end", {("around", "chair", "dining table")}),
        ("The bed should not be under the window.", {("apart", "bed", "window")}),
        ("Do not put the desk in front of the door.", {("apart", "desk", "door")}),
        ("a bed and no rug under the table", set()),
        ("Two side tables flank the sofa.", {("flank", "side table", "sofa")}),
        ("two beds separated by a curtain", {("amid", "privacy screen", "bed")}),
        ("The bed's headboard is against the south wall.", {("wall", "bed", "wall")}),
        (
            "a shelf with bottles behind the counter",
            {("with", "bottle", "shelving unit"), ("behind", "shelving unit", "kitchen counter")},
        ),
        (
            "Behind the desk is a bookcase, to its left a plant.",
            {("behind", "bookshelf", "desk"), ("left", "plant", "bookshelf")},
        ),
        (
            "Next to the sofa is a table, and a lamp stands against the wall.",
            {("next", "dining table", "sofa"), ("wall", "floor lamp", "wall")},
        ),
        (
            "a sofa facing a television with speakers on either side of it",
            {("facing", "sofa", "television"), ("flank", "speaker", "television")},
        ),
        (
            "a television on the wall opposite the sofa",
            {("on", "television", "wall"), ("opposite", "television", "sofa")},
        ),
        ("a kitchenette along the wall and a bed by the window", {("by", "bed", "window")}),
        ("A globe sits on top of the shelf.", {("on", "globe", "shelving unit")}),
        (
            "Two nightstands are on either side of the bed, each with a lamp on it.",
            {("flank", "night stand", "bed"), ("on", "table lamp", "night stand")},
        ),
        (
            "a bed with a nightstand to its right, and a small desk to its left",
            {("right", "night stand", "bed"), ("left", "desk", "bed")},
        ),
        (
            "A desk is next to the bed. On it is a lamp, a bin stands beneath it, a chair stands in front of it.",
            {("next", "desk", "bed"), ("on", "table lamp", "desk"), ("under", "trash can", "desk"), ("front", "chair", "desk")},
        ),
        (
            "On the left of the desk is a cabinet, and on its right a plant.",
            {("left", "cabinet", "desk"), ("right", "plant", "desk")},
        ),
        (
            "three monitors on the desk, and a computer tower under it",
            {("on", "monitor", "desk"), ("under", "computer tower", "desk")},
        ),
        (
            "A wardrobe is near the bed, and next to it is a mirror.",
            {("near", "wardrobe", "bed"), ("next", "floor mirror", "wardrobe")},
        ),
        (
            "a workbench along the wall, bicycles hung on the north wall",
            {("wall", "workbench", "wall"), ("on", "bicycle", "wall")},
        ),
        (
            "A table surrounded by five chairs, with a lamp hanging directly over it.",
            {("around", "chair", "dining table"), ("above", "pendant lamp", "dining table")},
        ),
        (
            "a counter near the door, and a reading corner with two armchairs and a floor lamp between them",
            {("near", "kitchen counter", "door"), ("amid", "floor lamp", "armchair")},
        ),
        (
            "To the left of the sofa is a shelf. On the other side stands a plant.",
            {("left", "shelving unit", "sofa"), ("right", "plant", "sofa")},
        ),
        (
            "A sofa faces a TV stand. On the TV stand is a TV. A desk sits between them.",
            {("facing", "sofa", "tv stand"), ("on", "television", "tv stand"), ("amid", "desk", "sofa"), ("amid", "desk", "tv stand")},
        ),
        ("a table with six chairs: two on each long side and one at each end", {("around", "chair", "dining table")}),
        (
            "There is a table. Six chairs are round it, three along each long side. A lamp hangs above it.",
            {("around", "chair", "dining table"), ("above", "pendant lamp", "dining table")},
        ),
        ("a table 40 cm in front of the sofa", {("front", "dining table", "sofa"), ("apart", "dining table", "sofa")}),
        ("toys in a box under the window", {("in", "toy", "storage box"), ("under", "storage box", "window")}),
        ("a sofa in the cornor", {("in", "sofa", "corner")}),
        ("a sink with knee space under it", set()),
        ("nightstand on left side of bed", {("left", "night stand", "bed")}),
        (
            "a TV stand with a TV on it. The sofa is 2.5 m from the TV, facing it.",
            {("on", "television", "tv stand"), ("apart", "sofa", "television"), ("facing", "sofa", "television")},
        ),
        (
            "four stools on one side of the island, on the other is the stove.",
            {("oneside", "bar stool", "kitchen island"), ("otherside", "stove", "kitchen island"), ("otherside", "stove", "bar stool")},
        ),
        ("ten chairs lined up along two opposite walls", {("wall", "chair", "wall")}),
        ("On the desk in the corner stands a lamp.", {("in", "desk", "corner"), ("on", "table lamp", "desk")}),
        ("The stove has a hood above it and the sink is under the window.", {("above", "hood", "stove"), ("under", "washbasin", "window")}),
        (
            "The fridge is to the left of the sink, which is under the window.",
            {("left", "fridge", "washbasin"), ("under", "washbasin", "window")},
        ),
        ("dumbbells on a rack along the wall", {("on", "dumbbell", "shelving unit"), ("wall", "shelving unit", "wall")}),
        ("a console table with two lamps, one on each end", {("flank", "floor lamp", "console table")}),
        ("The north wall has a sofa.", {("on", "sofa", "wall")}),
        ("a rack of dumbbells against the wall", {("on", "dumbbell", "shelving unit"), ("wall", "shelving unit", "wall")}),
        ("a rug beneath the sofa and coffee table", {("under", "rug", "sofa"), ("under", "rug", "coffee table")}),
        ("There must be at least 1 m between the bed and the wardrobe.", {("apart", "bed", "wardrobe")}),
        ("three desks, each with a chair, in a row", {("with", "chair", "desk"), ("row", "desk", "")}),
        (
            "A table. A bench on one side and three chairs on the other, with two lamps above it.",
            {
                ("oneside", "bench", "dining table"),
                ("otherside", "chair", "dining table"),
                ("otherside", "chair", "bench"),
                ("above", "pendant lamp", "dining table"),
            },
        ),
        (
            "A sofa and a lamp. The sofa and the lamp are by the window and the door respectively.",
            {("by", "sofa", "window"), ("by", "floor lamp", "door")},
        ),
        (
            "A sofa and an armchair. The former is by the window, the latter is in the corner.",
            {("by", "sofa", "window"), ("in", "armchair", "corner")},
        ),
        (
            "On the left of the bench stands a table, on the right a lamp.",
            {("left", "dining table", "bench"), ("right", "floor lamp", "bench")},
        ),
        ("A desk is near the door, on which sits a lamp.", {("near", "desk", "door"), ("on", "table lamp", "desk")}),
        (
            "There is a sofa and a bench with a table between them.",
            {("amid", "dining table", "sofa"), ("amid", "dining table", "bench")},
        ),
        ("Between the sofa and the plant stands a desk.", {("amid", "desk", "sofa"), ("amid", "desk", "plant")}),
        ("North wall: a bed. South wall: a desk with a chair.", {("on", "bed", "wall"), ("on", "desk", "wall"), ("with", "chair", "desk")}),
        ("In the corner near the window is a plant.", {("in", "plant", "corner"), ("near", "plant", "window")}),
        ("The bed doesn't touch any wall.", {("apart", "bed", "wall")}),
        (
            "Two bookshelves and a reading table with four chairs in front of them.",
            {("front", "dining table", "bookshelf"), ("with", "chair", "dining table")},
        ),
        ("Two sofas on opposite sides of a coffee table", {("flank", "sofa", "coffee table")}),
        ("Three tables with two chairs at opposite ends of each table", {("around", "chair", "dining table")}),
        ("A sofa and a desk on opposite sides of the room", {("on", "sofa", "side"), ("on", "desk", "side")}),
        ("A vanity table with a stool opposite the bed", {("opposite", "vanity table", "bed"), ("with", "stool", "vanity table")}),
        ("A coffee table with two armchairs opposite the sofa", {("opposite", "armchair", "sofa"), ("with", "armchair", "coffee table")}),
        ("A table with two chairs on a rug", {("on", "dining table", "rug"), ("with", "chair", "dining table")}),
        ("A sofa with a coffee table on a rug", {("on", "coffee table", "rug")}),
        ("A table with six chairs under a pendant lamp", {("under", "dining table", "pendant lamp"), ("with", "chair", "dining table")}),
        (
            "A bed against the wall and a TV on the opposite wall",
            {("wall", "bed", "wall"), ("atwalls", "television", "wall"), ("atwalls", "television", "bed")},
        ),
        ("A crib. A bench along the same wall as the crib", {("atwalls", "bench", "wall"), ("atwalls", "bench", "crib")}),
        (
            "A stove stands left of a sink. Both face the door.",
            {("left", "stove", "washbasin"), ("facing", "stove", "door"), ("facing", "washbasin", "door")},
        ),
        ("There's a rug, on which a low coffee table stands.", {("on", "coffee table", "rug")}),
        (
            "On the left side of the bed is a desk. On the other side of the bed there is a plant.",
            {("left", "desk", "bed"), ("right", "plant", "bed")},
        ),
        ("a globe on the corner of the desk", {("on", "globe", "desk")}),
        (
            "A mannequin stands to the left of the table; to the right of it is a shelf.",
            {("left", "mannequin", "dining table"), ("right", "shelving unit", "dining table")},
        ),
        (
            "A bed with a lamp on the nightstand to its right",
            {("on", "table lamp", "night stand"), ("right", "night stand", "bed")},
        ),
        ("a sofa with the TV on the wall in front of it", {("on", "television", "wall"), ("front", "television", "sofa")}),
        ("The treadmill and the bike face the mirror.", {("facing", "treadmill", "mirror"), ("facing", "bicycle", "mirror")}),
        ("a lamp at the armchair's right", {("right", "floor lamp", "armchair")}),
        ("two chairs that face away from the window", {("turnedfrom", "chair", "window")}),
        ("a sofa with its back to the door", {("turnedfrom", "sofa", "door")}),
        ("an aquarium separates the table from the sofa", {("amid", "aquarium", "dining table"), ("amid", "aquarium", "sofa")}),
        (
            "a bed and two nightstands with lamps on either side",
            {("with", "table lamp", "night stand"), ("flank", "night stand", "bed")},
        ),
        ("a table under a lamp", {("under", "dining table", "pendant lamp")}),
        ("Every table has a candle in its center.", {("middle", "candle", "dining table")}),
    ],
)  # fmt: skip
def test_relations(text: str, said: set[tuple[str, ...]]) -> None:
    assert links(text) == said


@pytest.mark.parametrize(
    ("text", "picked"),
    [
        (
            "Two sofas. One of the sofas is against the wall. A lamp stands behind the other.",
            [("sofa", 0), ("sofa", 1)],
        ),
        ("Two beds. One is against the left wall, the other against the right wall.", [("bed", 0), ("bed", 1)]),
        ("Two whiteboards, one beside the other", [("whiteboard", 0), ("whiteboard", 1)]),
        ("three chairs. The second is in the corner. The last one faces the window.", [("chair", 1), ("chair", 2)]),
        ("two plants, one left of the sofa, another right of it", [("plant", 0), ("plant", 1)]),
        (
            "Two nightstands. The one on the right holds a book. The left one holds a clock.",
            [("night stand", 1), ("night stand", 0)],
        ),
    ],
)
def test_one_of_several_is_picked(text: str, picked: list[tuple[str, int]]) -> None:
    found = [
        item
        for link in read(text).parsed.links
        for item in (*link.subjects, *link.objects)
        if isinstance(item, Mention)
    ]
    assert [(item.thing.noun.words, item.pick.start) for item in found if item.pick] == picked


def test_what_a_thing_is_made_of_is_nothing_of_the_room() -> None:
    said = read("A bedroom with two windows in the south wall and a wardrobe with two sliding doors.").parsed
    assert [place.name for place, _ in said.openings] == ["window"]
    assert [place.words for place, _ in read("On the south wall there are two windows.").parsed.openings] == [
        ("south",)
    ]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("a lamp above the dining table", "pendant lamp"),
        ("a lamp on the desk", "table lamp"),
        ("a cabinet above the bathtub", "wall cabinet"),
        ("a lamp in the corner", "floor lamp"),
        ("a coffeetable", "coffee table"),
        ("a bistro table", "round table"),
        ("a wardrob", "wardrobe"),
        ("a karaoke machine", "vending machine"),
        ("a screen on the wall", "projection screen"),
        ("a floor lamp above the sofa", "floor lamp"),
    ],
)
def test_a_noun_takes_the_kind_that_fits(text: str, kind: str) -> None:
    assert read(text).parsed.things[0].noun.kind == kind


def test_refusals_end_where_the_next_wish_begins() -> None:
    said = read("a bedroom without a wardrobe but with a desk, no rug or mirror, and a chair").parsed
    assert [noun.words for noun, _ in said.refused] == ["wardrobe", "rug", "mirror"]
    assert [thing.noun.words for thing in said.things] == ["desk", "chair"]


def test_a_body_is_who_the_room_is_for_and_a_thing_is_what_stands_there() -> None:
    assert read("a bathroom for a wheelchair user").agent == "wheelchair"
    assert read("a wheelchair user's bathroom").agent == "wheelchair"
    hospital = read("a hospital room with a wheelchair")
    assert hospital.agent is None
    assert [thing.noun.words for thing in hospital.parsed.things] == ["wheelchair"]


@pytest.mark.parametrize(
    ("text", "body"),
    [
        ("a wheelchair-accessible bathroom with a shower", "wheelchair"),
        ("a small accessible bathroom", "wheelchair"),
        ("a barrier-free kitchen", "wheelchair"),
        ("a bedroom, wheelchair accessible, with a desk", "wheelchair"),
        ("a bathroom for a disabled person", "wheelchair"),
        ("a senior-friendly bedroom", "elder_walker"),
        ("a cosy cat-friendly living room", "cat"),
        ("a child-friendly living room", "child_6"),
        ("a step-free bathroom", "wheelchair"),
        ("a bedroom for a wheelchair-bound man", "wheelchair"),
        ("a bedroom for my elderly mother", "elder_walker"),
        ("a bedroom for an old woman", "elder_walker"),
        ("a bedroom with an accessible shelf", None),
        ("a bedroom in which everything is easily accessible", None),
    ],
)
def test_what_is_said_of_a_room_tells_its_body(text: str, body: str | None) -> None:
    assert read(text).agent == body


@pytest.mark.parametrize(
    ("text", "body"),
    [
        ("a workshop for a Spot", "spot"),
        ("a laboratory for a Stretch", "stretch3"),
        ("a laboratory for a Unitree G1", "unitree_g1"),
        ("a warehouse for a forklift", "forklift"),
        ("a living room where a Roomba can drive", "robot_vacuum"),
        ("a room for an adult", "adult"),
    ],
)
def test_a_body_called_by_its_name_is_no_thing(text: str, body: str) -> None:
    assert read(text).agent == body
    assert things(text) == {}


def test_a_name_of_a_body_may_be_another_word() -> None:
    assert read("a warehouse with a forklift").agent is None
    assert read("a living room with a reading lamp for a spot near the window").agent is None


def test_pets_of_somebody_live_there_too() -> None:
    assert read("a living room for a researcher who has a cat").agent is None
    assert read("a living room for two cats").agent == "cat"


@pytest.mark.parametrize(
    ("text", "sizes"),
    [
        ("a 2.2 m wide sofa", [("wide", (2.2,))]),
        ("a room of 5 x 4 m with a desk (160 x 80 cm)", [("size", (1.6, 0.8))]),
        ("a wooden 6-foot table", [("length", (1.829,))]),
        ("a wardrobe that is 1 m wide and 2.2 m tall", [("wide", (1.0,)), ("height", (2.2,))]),
        ("a 55-inch TV in a room 2.8 m high", [("diagonal", (1.397,))]),
        ("a bedroom with a bed, 4 x 5 m", []),
    ],
)
def test_figures_are_of_the_thing_that_they_stand_at(text: str, sizes: list[tuple[str, tuple[float, ...]]]) -> None:
    assert [(said.kind, said.values) for thing in read(text).parsed.things for said in thing.sizes] == sizes


def test_a_room_is_known_in_spite_of_a_slip() -> None:
    assert read("A bedrom with a bed.").room == "bedroom"


def test_every_word_is_part_of_something() -> None:
    text = "A bedroom with a glorp, shimmering in violet, next to a bed."
    said = read(text).parsed
    missed = [read(text).span(chunk.start, chunk.end) for chunk in said.missed]
    assert missed == ["A bedroom with a glorp, shimmering in violet"]
    assert [thing.noun.words for thing in said.things] == ["glorp", "bed"]
    assert said.things[0].noun.guessed


def test_a_wall_is_kept_free_coloured_or_not_understood() -> None:
    assert ("bare", "wall") in {
        (link.relation, link.objects[0].name)
        for link in read("Leave the north wall free.").parsed.links
        if isinstance(link.objects[0], Place)
    }
    assert "white wall" in read("a room with white walls").words_of_taste
    assert [chunk.value for chunk in read("A bedroom with a bed. The north wall.").parsed.missed] == ["wall"]


def test_words_before_nouns_that_say_nothing_are_named() -> None:
    assert read("a queen-size bed and two large wooden stacked crates").unknown == []
    assert read("a frilly blue bed").unknown == ["frilly"]
    assert read("Une chambre avec une armoire").unknown == ["une", "chambre", "avec"]


def test_only_so_much_is_read_and_the_rest_is_counted() -> None:
    assert read("a bedroom " + "with a bed " * 10_000).unread > 100_000


@settings(max_examples=60, deadline=None)
@given(st.text(max_size=120))
def test_any_text_is_read_or_refused(text: str) -> None:
    try:
        reading = read(text)
    except SceneError as error:
        assert str(error)
    else:
        assert all(0 <= chunk.start < chunk.end <= len(reading.words) for chunk in reading.parsed.missed)


def test_any_text_at_all_is_read() -> None:
    """A number of nothing in particular, with no relation before it, was an IndexError."""
    assert things(
        "The floor is left to walk on while a room is built, against a flood from every cell and a look at every place."
    )


@pytest.mark.parametrize(
    ("word", "kind", "ending"), [("foodcart", "bar cart", "cart"), ("streetart", "picture", "art")]
)
def test_a_joined_word_is_taken_by_its_longest_known_ending(word: str, kind: str, ending: str) -> None:
    noun = LEXICON.guess([word])
    assert (noun.kind, noun.guessed) == (kind, f"by its last word, {ending!r}")
