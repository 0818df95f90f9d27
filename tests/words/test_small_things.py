"""What lies, stands and hangs on tables, shelves and hooks: who has it, how many there are, and where it is."""

from __future__ import annotations

from collections import Counter

import pytest

from robolayout.planners.sentence import scene_from_sentence
from robolayout.words import read_words


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (
            "An office with four desks, each with a monitor, a keyboard and a chair, and a printer in the corner",
            {"keyboard": 4, "office chair": 4, "printer": 1},
        ),
        (
            "a cafe with three round tables, each with two chairs, a bowl, and a menu, and a counter with a till",
            {"bowl": 3, "magazine": 3, "bar counter": 1},
        ),
        ("a dining room with a table set for six", {"chair": 6, "place setting": 6}),
        ("a banquet hall with six round tables, each set for eight", {"chair": 48, "place setting": 48}),
        ("a dining room with a table set for six with plates and wine glasses", {"plate": 6, "wine glass": 6}),
        (
            "a dining room with a round table set for four: at each seat a plate, a fork and a glass",
            {"chair": 4, "seat": 0, "plate": 4, "fork": 4, "glass": 4},
        ),
        ("a bathroom with a double vanity and a mirror above each sink", {"bathroom vanity": 2, "washbasin": 0}),
        ("a record shop with crates on four tables", {"crate": 4}),
        ("a cloakroom with twenty hooks on the wall", {"wall hooks": 1}),
        ("a study with two bookshelves with books", {"bookshelf": 2, "book": 0}),
        ("a study with a bookshelf with five books", {"book": 5}),
        ("a flower shop with buckets of roses and a cooler with bouquets", {"vase": 0}),
        ("a hobby room with a sewing machine on a table", {"dining table": 1, "pool table": 0}),
        ("a potter's studio with two pottery wheels", {"bed": 0}),
        ("a living room with a side table with a lamp on each side of the sofa", {"side table": 2, "table lamp": 2}),
        ("a bedroom with a bed and nothing on the walls", {"picture": 0, "mirror": 0}),
        (
            "a lab with three tables, each with two microscopes, a box of slides and two stools",
            {"microscope": 6, "storage box": 3, "stool": 6, "slide": 0},
        ),
        ("a pantry with a row of jars on the shelf", {"jar": 2}),
        ("a kids' bedroom with two beds, each with a teddy bear on the pillow", {"teddy bear": 2, "pillow": 0}),
    ],
)
def test_small_things_are_as_many_as_they_are_for(text: str, count: dict[str, int]) -> None:
    """Of a list that "each" has the last things were one, tables "set for" somebody bare, a double vanity had one basin."""
    scene, _ = scene_from_sentence(text)
    there = Counter(asset.category for asset in scene.assets)
    assert {kind: there[kind] for kind in count} == count
    assert not [row for row in read_words(scene).rows if row.kind == "not understood"]


@pytest.mark.parametrize(
    ("text", "meant", "never"),
    [
        (
            "a laundry room with a washer and a dryer side by side, a basket of laundry on the dryer and a shelf above them",
            "above(wall_shelf-0, washing_machine-0), above(wall_shelf-0, clothes_dryer-0)",
            "on_top_of(washing_machine-0",
        ),
        (
            "a laundry room with a shelf with two bottles, and an ironing board in the corner",
            "corner(ironing_board-0",
            "corner(wall_shelf",
        ),
        ("a room with a desk with a laptop, a lamp and a mug in the corner", "corner(desk-0", "corner(mug"),
        (
            "a dining table with plates, glasses and a bowl in the middle",
            "centered_on(bowl-0, dining_table-0)",
            "distance_constraint(bowl",
        ),
        (
            "a bathroom with a shelf above the toilet holding two towels",
            "on_top_of(towel-0, wall_shelf-0)",
            "on_top_of(towel-0, toilet",
        ),
        (
            "a dining room with a sideboard holding a bowl, two candles and a clock",
            "on_top_of(bowl-0, sideboard-0); on_top_of(candle-0, sideboard-0)",
            "near(candle",
        ),
        (
            "a living room with two armchairs and a small table with a teapot and two cups between them",
            "side_table-0 between armchair-0 and armchair-1",
            "between armchair-1 and teapot",
        ),
        (
            "a recording studio with a mixing desk, two monitors and two speakers on it",
            "on_top_of(monitor-0, mixing_desk-0)",
            "near(monitor",
        ),
        (
            "a workshop with a workbench with a vise on the left end and a lamp on the right end",
            "toward(vise-0, workbench-0, right, off=",
            "zone(workbench",
        ),
        (
            "a lobby with a reception desk with a bell and a computer, a vase on a round table in the middle",
            "on_top_of(computer-0, reception_desk-0)",
            "on_top_of(computer-0, round_table",
        ),
        (
            "a dining room with a table for four, each place has a plate, a fork on its left and a knife on its right",
            "left_of(fork-0, plate-0",
            "left_of(fork-0, dining_table",
        ),
    ],
)
def test_small_things_are_where_they_are_said_to_be(text: str, meant: str, never: str) -> None:
    scene, _ = scene_from_sentence(text)
    said = " | ".join(row.understanding for row in read_words(scene).rows)
    assert meant in said
    assert never not in said
