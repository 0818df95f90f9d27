"""The ledger: rows are judged by the layout alone, and every kind of row can be met and unmet."""

from __future__ import annotations

import math
import re
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import Polygon

from robolayout.planners import scene_from_sentence
from robolayout.program import read_program
from robolayout.run.flow import generate
from robolayout.run.result import judge
from robolayout.scene import Asset, Layout, Opening, Pose, Room, Scene
from robolayout.words import AskedRow, read_words

ROOM = Room(
    ((0, 0), (5, 0), (5, 4), (0, 4)),
    2.6,
    doors=(Opening(0, 0.3, 0.9, 2.05),),
    windows=(Opening(2, 1.8, 1.4, 1.3, 0.9),),
)
BED = Asset("bed-0", "double bed", (2.0, 1.6, 0.5))
STANDS = tuple(Asset(f"night_stand-{i}", "night stand", (0.4, 0.45, 0.5)) for i in range(2))
LAMP = Asset("lamp-0", "table lamp", (0.2, 0.2, 0.4), on_floor=False, on_object=True)
DESK = Asset("desk-0", "desk", (0.7, 1.2, 0.75))
PLACED = Layout(
    {
        "bed-0": Pose(1.02, 2.0, 0.25, 0.0),
        "night_stand-0": Pose(0.25, 3.06, 0.25, 0.0),
        "night_stand-1": Pose(0.25, 0.94, 0.25, 0.0),
        "lamp-0": Pose(0.25, 3.06, 0.7, 0.0),
        "desk-0": Pose(2.5, 3.62, 0.375, -1.5708),
    }
)


def judged(text: str, layout: Layout = PLACED, **scene: object) -> list[AskedRow]:
    given = Scene(ROOM, (BED, *STANDS, LAMP, DESK), text)
    return list(read_words(replace(given, **scene)).judged(given, layout))


def verdict(text: str, kind: str, layout: Layout = PLACED) -> str:
    rows = [row for row in judged(text, layout) if row.kind == kind]
    assert len(rows) == 1, [(row.kind, row.words) for row in judged(text, layout)]
    return rows[0].verdict


@pytest.mark.parametrize(
    ("text", "met"),
    [
        ("The bed is against the wall.", True),
        ("The bed is against the east wall.", False),
        ("The bed is against the west wall.", True),
        ("The desk is under the window.", True),
        ("The bed is under the window.", False),
        ("The lamp is on the night stand.", True),
        ("The lamp is on the desk.", False),
        ("There are two night stands on both sides of the bed.", True),
        ("The desk is in the corner.", False),
        ("The desk is far from the door.", True),
        ("The bed faces the desk.", False),
        ("The bed is between the night stands.", True),
        ("The desk is between the night stands.", False),
        ("The bed is in the left half.", True),
        ("The desk is in the front half of the room.", False),
        ("There is daylight at the desk.", True),
        ("The night stands are in pairs.", False),
        ("The night stands are parallel to each other.", True),
        ("The bed stands at a right angle to the desk.", True),
        ("The bed is parallel to the desk.", False),
        ("The bed stands diagonally.", False),
        ("The two night stands stand back to back.", False),
        ("The night stands are stacked.", False),
        ("The two night stands stand symmetrically on both sides of the bed.", True),
        ("The room is open in the middle.", False),
        ("The night stands stand in a row.", True),
        ("Keep the north wall free.", False),
        ("Keep the east wall free.", True),
        ("The desk is no closer than 1 m to the bed.", False),
        ("The desk is no closer than 1 m to the door.", True),
        ("The bed is at one end.", True),
        ("The desk is at the other end.", False),
    ],
)
def test_relations_are_measured_in_the_layout(text: str, met: bool) -> None:
    assert verdict(text, "relation") == ("met" if met else "unmet")


@pytest.mark.parametrize(
    ("text", "kind", "met"),
    [
        ("a bedroom of 5 x 4 m", "room size", True),
        ("a bedroom of 4.5 x 4 m", "room size", False),
        ("a bedroom of 20 m2", "room area", True),
        ("a bedroom with a 3 m ceiling", "room height", False),
        ("a bedroom with two windows", "opening", False),
        ("a bedroom with one door", "opening", True),
        ("no wardrobe", "refusal", True),
        ("no desk", "refusal", False),
        ("three night stands", "count", False),
        ("two night stands", "count", True),
        ("at most one night stand", "count", False),
    ],
)
def test_counts_and_the_room_are_measured(text: str, kind: str, met: bool) -> None:
    assert verdict(text, kind) == ("met" if met else "unmet")


def test_a_body_that_was_chosen_otherwise_is_not_judged() -> None:
    assert verdict("a bedroom for a wheelchair user", "body") == "not judged"


def test_what_is_not_placed_meets_nothing() -> None:
    without = Layout({name: pose for name, pose in PLACED.items() if name != "lamp-0"})
    rows = judged("The lamp is on the night stand.", without)
    assert {row.verdict for row in rows if row.kind == "relation"} == {"unmet"}
    assert "lamp-0 not placed" in [row.value for row in rows]


def test_nothing_is_dropped() -> None:
    rows = judged("A quiet bedroom where the bed gleams, stacked.")
    assert {row.verdict for row in rows} >= {"met", "not judged", "not understood"}
    assert "gleams" in [row.words for row in rows]


def test_a_way_ends_where_the_body_gets_to() -> None:
    text = "There is a clear path from the door to the desk."
    near, far = Polygon([(1, 0.4), (4, 0.4), (4, 3), (1, 3)]), Polygon([(0.4, 0.4), (1, 0.4), (1, 1), (0.4, 1)])
    given = Scene(ROOM, (BED, *STANDS, LAMP, DESK), text)
    found = [read_words(given).judged(given, PLACED, walked)[-1] for walked in (near, far, None)]
    assert [row.verdict for row in found] == ["met", "unmet", "not judged"]
    assert found[1].value == "the way ends 2.14 m before it"


def test_attributes_that_exclude_each_other_are_said() -> None:
    rows = [row for row in judged("A round square desk.") if row.kind == "attribute"]
    assert [(row.words, row.understanding, row.verdict) for row in rows] == [
        ("A round square desk", "round and square exclude each other", "unmet")
    ]


def test_a_place_where_nothing_stands_is_said() -> None:
    rows = judged("On the desk in the middle of the room. The bed is against the wall.")
    assert [row.words for row in rows if row.verdict == "not understood"] == ["On the desk in the middle of the room"]


def test_a_corner_is_told_by_the_door() -> None:
    there = Layout({**PLACED, "desk-0": Pose(4.4, 3.65, 0.375, -1.5708)})
    assert verdict("The desk is in the corner farthest from the door.", "relation", there) == "met"
    assert verdict("The desk is in the corner nearest the door.", "relation", there) == "unmet"


def test_two_things_are_on_opposite_sides_of_the_room() -> None:
    words = "The bed and the desk are on opposite sides of the room."
    assert verdict(words, "relation") == "unmet"
    there = Layout({**PLACED, "desk-0": Pose(4.62, 2.0, 0.375, 3.1416)})
    assert verdict(words, "relation", there) == "met"


def test_what_is_under_a_window_has_its_back_at_the_wall() -> None:
    free = Layout({**PLACED, "desk-0": Pose(2.5, 3.2, 0.375, -1.5708)})
    assert verdict("The desk is by the window.", "relation", free) == "met"
    assert verdict("The desk is under the window.", "relation", free) == "unmet"
    assert verdict("The desk is under the window.", "relation") == "met"


@pytest.mark.parametrize(("y", "met"), [(3.97, "unmet"), (0.5, "unmet"), (2.0, "met")])
def test_a_screen_at_one_end_of_a_table_hangs_where_that_is_long(y: float, met: str) -> None:
    table = Asset("table-0", "dining table", (2.2, 1.0, 0.75))
    screen = Asset("television-0", "television", (0.06, 1.2, 0.7), on_floor=False, on_wall=True)
    x, yaw = (2.5, -1.5708) if y > 3.0 else (4.97, 3.1416)
    layout = Layout({"table-0": Pose(2.5, 2.0, 0.375, 0.0), "television-0": Pose(x, y, 1.5, yaw)})
    scene = Scene(ROOM, (table, screen), "A TV on the wall at one end of the table.")
    rows = [row for row in read_words(scene).judged(scene, layout) if "end" in row.words]
    assert [row.verdict for row in rows] == [met]


def test_a_thing_in_the_corner_by_a_window_is_by_the_window() -> None:
    by, away = (Layout({**PLACED, "desk-0": Pose(4.4, y, 0.375, yaw)}) for y, yaw in ((3.65, -1.5708), (0.35, 1.5708)))
    for layout, verdicts in ((by, ["met", "met"]), (away, ["met", "unmet"])):
        rows = judged("The desk is in the corner by the window.", layout)
        assert [row.verdict for row in rows if row.kind == "relation"] == verdicts


@pytest.mark.parametrize(("words", "met"), [("opposite walls", (True, False)), ("the same wall", (False, False))])
def test_two_things_are_at_walls_together(words: str, met: tuple[bool, bool]) -> None:
    text = f"The bed and the desk are against {words}."
    across = Layout({**PLACED, "desk-0": Pose(4.64, 2.0, 0.375, 3.14159)})
    assert tuple(verdict(text, "relation", layout) == "met" for layout in (across, PLACED)) == met
    beside = Layout({**PLACED, "desk-0": Pose(0.36, 3.3, 0.375, 0.0)})
    assert (verdict(text, "relation", beside) == "met") == (words == "the same wall")


WORDS = {
    "thing": ("lamp", "two plants", "large desk", "bed", "glorps"),
    "verb": ("stands", "is", "should be", "leans", "must not be"),
    "where": (
        "on",
        "opposite",
        "beside",
        "in",
        "under",
        "halfway up",
        "kittycorner to",
        "symmetrically at",
        "half above",
    ),
    "place": ("window", "corner", "ceiling", "east wall", "left side", "bench", "three windows", "sofa"),
}
SMALL = frozenset(["not", "a", "the", "is", "stands", "should", "be", "leans", "must", "to", "up"])


@settings(max_examples=150, deadline=None)
@given(st.tuples(*(st.sampled_from(WORDS[part]) for part in ("thing", "verb", "where", "place", "where", "place"))))
def test_each_word_that_says_something_is_in_a_row(said: tuple[str, ...]) -> None:
    thing, verb, where, place, second, other = said
    text = f"The {thing} {verb} {where} the {place} and {second} the {other}."
    rows = " ".join(f"{row.words} {row.understanding}" for row in judged(text)).lower()
    known = set(re.findall("[a-z]+", rows)) | {word + "s" for word in re.findall("[a-z]+", rows)}
    lost = [word for word in re.findall("[a-z]+", text.lower()) if word not in known | SMALL | {"and"}]
    assert not lost, (text, lost)


@pytest.mark.parametrize(
    ("text", "quoted"),
    [
        ("The desk is centered.", "The desk is centered"),
        ("Hardly any of the night stands are by the bed.", "Hardly"),
        ("A bed. Hang the lamp symmetrically.", "symmetrically"),
        ("A bed, no desk in the corner.", "no desk in the corner"),
        ("A bed and a desk. The three desks are by the window.", "The three desks are by the window"),
        ("Keep the corner by the window free.", "Keep the corner by the window free"),
        ("A bed and a desk. A lamp stands where the desk meets the bed.", "A lamp stands where the desk meets the bed"),
    ],
)
def test_what_no_row_is_about_is_quoted(text: str, quoted: str) -> None:
    assert quoted in [row.words for row in judged(text) if row.kind == "not understood"]


def test_a_table_for_so_many_asks_for_seats() -> None:
    (row,) = [row for row in judged("a dining table for six") if "seats" in row.understanding]
    assert (row.words, row.verdict, row.value) == ("for six", "unmet", "0 seats there")
    chairs = [Asset(f"chair-{i}", "chair", (0.5, 0.5, 0.9)) for i in range(6)]
    placed = Layout({chair.name: Pose(1.0, 1.0, 0.45, 0.0) for chair in chairs})
    scene = Scene(ROOM, tuple(chairs), "a dining table for six")
    rows = read_words(scene).judged(scene, placed)
    assert [row.verdict for row in rows if "seats" in row.understanding] == ["met"]


def test_two_moods_are_measured_and_the_others_are_not() -> None:
    rows = {row.words: (row.verdict, row.value) for row in judged("An airy, cosy, quiet bedroom.")}
    assert rows["airy"] == ("met", "it takes 22%")
    assert rows["cosy"] == ("unmet", "none and table lamp")
    assert rows["quiet"][0] == "not judged"


def test_what_stands_against_a_wish_is_named() -> None:
    given = Scene(ROOM, (BED, *STANDS, LAMP, DESK), "The bed is against the east wall. The desk is against the wall.")
    wishes = read_words(given)
    (bed, *_) = wishes.said
    (row,) = [
        row
        for row in wishes.judged(given, PLACED, against={bed: "the wish 'desk against wall'"})
        if row.verdict == "unmet"
    ]
    assert row.value.endswith("; against it: the wish 'desk against wall'")


def test_statements_say_who_asks_for_them() -> None:
    given = Scene(ROOM, (BED, *STANDS, LAMP, DESK), "The bed is against the west wall.")
    program = read_program("solver.against_wall(bed[0], walls[3])\nsolver.against_wall(desk[0], walls[2])", given)
    assert [statement.by for statement in read_words(given).marked(program).statements] == ["user", "plan"]


def test_no_words_no_rows() -> None:
    assert judged("") == []


def test_rows_are_as_many_as_are_said() -> None:
    """Two rows of mats are a block of two rows, and no row of five with one beside it."""
    scene, _ = scene_from_sentence("A yoga studio 8 x 6 m with six yoga mats in two rows")
    result = generate(scene)
    (row,) = [one for one in result.report.asked if one.words == "yoga mat in two rows"]
    assert row.verdict == "met" and row.value.startswith("2 rows")
    turned = result.layout.moved("yoga_mat-0", by=(0.0, -1.5))
    (row,) = [one for one in judge(scene, turned).report.asked if one.words == "yoga mat in two rows"]
    assert row.verdict == "unmet"


def test_rows_longer_than_the_room_are_files_and_look_one_way() -> None:
    text = "A chapel of 8 x 8 m with an altar and ten pews in two rows facing the altar"
    scene, _ = scene_from_sentence(text)
    said = {row.words: row.understanding for row in read_words(scene).rows}
    assert said["pew in two rows"].endswith("aisle=0, 5)")  # five pews abreast are 9.5 m
    assert "point_towards(pew-1, altar-0)" in said["pew facing altar"] and "align_with" in said["pew facing altar"]


def test_a_row_is_straight() -> None:
    moved = PLACED.moved("night_stand-1", by=(0.3, 0.0))
    assert verdict("The two night stands stand in a row.", "relation", moved) == "unmet"


def test_of_a_stack_the_lowest_stands_in_the_corner() -> None:
    scene, _ = scene_from_sentence("A garage with a stack of four pallets in the corner")
    (row,) = [row for row in read_words(scene).rows if row.words == "pallet in corner"]
    assert row.things == ("pallet-0",)


def test_what_is_to_hold_others_is_large_enough() -> None:
    def size(text: str, category: str) -> tuple[float, ...]:
        return next(asset.size for asset in scene_from_sentence(text)[0].assets if asset.category == category)

    rug = size("A library with a rug and eight floor cushions on the rug", "rug")
    assert rug[0] * rug[1] > 8 * 0.6**2
    assert size("A bar with eight stools in front of the bar counter", "bar counter")[1] > 8 * 0.5


def test_a_second_room_is_a_thing_or_not_understood() -> None:
    _, found = scene_from_sentence("A studio with a sofa bed, a kitchenette and a table")
    assert found.room_type == "studio" and found.wished["kitchenette"] == 1
    assert {"kitchen sink", "stove", "fridge"} <= found.added.keys()
    scene, _ = scene_from_sentence("A bedroom with a bed and a bathroom")
    rows = {row.words: row.understanding for row in read_words(scene).rows}
    assert rows["a bathroom"] == "one room is laid out, the bedroom"


def test_a_row_says_once_what_a_thing_has() -> None:
    rows = [
        row.words for row in judged("The desk has a table lamp. The bed is by the window.") if row.kind == "relation"
    ]
    assert rows == ["desk with a table lamp", "bed by window"]


def test_desks_that_face_each_other_stand_back_to_back() -> None:
    """Who sits at them look at each other: with their fronts together they would sit with their backs to each other."""
    scene, _ = scene_from_sentence("an office with two desks facing each other")
    result = generate(scene)
    (row,) = [one for one in result.report.asked if one.words == "desk facing each other"]
    assert row.verdict == "met"
    first, second = (result.layout[name] for name in ("desk-0", "desk-1"))
    size = scene.by_name["desk-0"].size
    assert math.dist((first.x, first.y), (second.x, second.y)) <= size[0] + 0.11
    assert abs(math.remainder(first.yaw - second.yaw, math.tau)) == pytest.approx(math.pi, abs=0.01)
    turned = replace(result.layout, poses={**result.layout.poses, "desk-0": replace(first, yaw=second.yaw)})
    (row,) = [one for one in judge(scene, turned).report.asked if one.words == "desk facing each other"]
    assert row.verdict == "unmet"


def test_who_looks_into_a_mirror_sits_before_it() -> None:
    """Each of the chairs has a mirror of its own, all side by side, and none is far from it."""
    scene, _ = scene_from_sentence("a salon with three chairs each facing a mirror")
    result = generate(scene)
    poses = result.layout.poses
    chairs, mirrors = (sorted(name for name in poses if name.startswith(kind)) for kind in ("salon_chair", "mirror"))
    gaps = [math.dist((poses[a].x, poses[a].y), (poses[b].x, poses[b].y)) for a, b in zip(chairs, mirrors, strict=True)]
    assert len(gaps) == 3 and max(gaps) < 1.5
    assert len({round(poses[name].yaw, 2) for name in mirrors}) == 1


def test_rows_that_face_each_other_are_turned_and_leave_an_aisle() -> None:
    text = "a library with two rows of three bookshelves facing each other and a bench between them"
    result = generate(scene_from_sentence(text)[0])
    words = ("bookshelf facing each other", "bench between bookshelf")
    assert {row.words: row.verdict for row in result.report.asked if row.words in words} == dict.fromkeys(words, "met")
    poses = dict(result.layout.poses)
    for name in (f"bookshelf-{i}" for i in range(3)):  # the first row looks away from the second
        poses[name] = replace(poses[name], yaw=poses[name].yaw + math.pi)
    rows = judge(result.scene, replace(result.layout, poses=poses)).report.asked
    assert next(row.verdict for row in rows if row.words == words[0]) == "unmet"


@pytest.mark.parametrize(
    ("text", "ways"),
    [
        (
            "a bedroom with a bed and two nightstands, each holding a lamp and a clock",
            {(f"{thing}-{i}", f"night_stand-{i}") for thing in ("table_lamp", "alarm_clock") for i in range(2)},
        ),
        (
            "an armchair with a small side table to the right of it holding a cup",
            {("side_table-0", "armchair-0"), ("cup-0", "side_table-0")},
        ),
        (
            "a bathroom for an elderly person with a walker, with a shower in the corner",
            {("shower-0",)},
        ),
        (
            "a bedroom with a bed and a nightstand with a reading lamp",
            {("desk_lamp-0", "night_stand-0")},
        ),
        (
            "a playroom with a bookshelf full of toys along the wall",
            {("toy-0", "bookshelf-0"), ("toy-1", "bookshelf-0"), ("bookshelf-0",)},
        ),
        (
            "a lobby with two sofas facing each other across a coffee table",
            {("sofa-1", "sofa-0"), ("coffee_table-0", "sofa-0"), ("coffee_table-0", "sofa-1")},
        ),
    ],
)
def test_what_is_held_and_what_is_between_is_shared_out(text: str, ways: set[tuple[str, ...]]) -> None:
    rows = read_words(scene_from_sentence(text)[0]).rows
    told = {
        one.asset_names() for row in rows if row.kind == "relation" for demand in row.demands for one in demand.ways[0]
    }
    assert told == ways
