"""What words put close together is joined: the program says how, and the layout has it so."""

from __future__ import annotations

import math

import pytest

import robolayout as rl
from robolayout.planners import OfflinePlanner, PlanRequest, scene_from_sentence
from robolayout.words import read_words


def program(text: str) -> str:
    scene, _ = scene_from_sentence(text)
    return OfflinePlanner().plan(PlanRequest(scene, asked=read_words(scene).demands))


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (
            "a hotel room with two queen beds and a nightstand between them",
            ("wish.left_of(night_stand[0], bed[0]", "wish.left_of(bed[1], night_stand[0]"),
        ),
        (
            "two single beds parallel to each other with a nightstand between them, and a dresser facing the beds",
            ("wish.left_of(night_stand[0], single_bed[0]", "wish.left_of(single_bed[1], night_stand[0]"),
        ),
        (
            "a bedroom with a desk and a TV mounted above it",
            (
                "solver.mounted_on(television[0]), solver.above(television[0], desk[0])",
                "solver.wish.mounted_on(television[0]",
            ),
        ),
        (
            "a laundry room with a washer and a dryer side by side",
            (
                "solver.next_to(washing_machine[0], clothes_dryer[0], max_gap=0.5)",
                "align_with(washing_machine[0], clothes_dryer[0])",
            ),
        ),
        (
            "a dining room with two benches facing each other across a long table",
            ("solver.around([bench[0], bench[1]], dining_table[0]",),
        ),
        (
            "a library with two rows of three bookshelves facing each other",
            ('aisle=1.2, backs="facing", rows=2)',),
        ),
        (
            "an office with six desks in two rows facing each other",
            ('backs="paired", rows=2)',),
        ),
        (
            "a bedroom with a bed between two bookshelves",
            ("wish.next_to(bookshelf[0], bed[0]", "wish.next_to(bookshelf[1], bed[0]", "against_wall(bookshelf[0]"),
        ),
        (
            "a bedroom with two single beds and a folding screen between them",
            ("wish.left_of(room_divider[0], single_bed[0]", "wish.align_with(room_divider[0], single_bed[0], 90)"),
        ),
        (
            "a playroom with a round table and four small chairs",
            ("solver.around([kids_chair[0], kids_chair[1], kids_chair[2], kids_chair[3]], round_table[0]",),
        ),
        (
            "a living room with two armchairs facing each other and a small table between them",
            ("solver.in_front_of(armchair[1], armchair[0]", "solver.facing_pair(armchair[1], armchair[0])"),
        ),
        (
            "a nurse station with a reception desk and two office chairs behind it",
            (
                "wish.behind(office_chair[0], reception_desk[0], -0.2, 0.3",
                "align_with(office_chair[0], reception_desk[0], 0)",
            ),
        ),
        (
            "a den with a TV and two recliners in front of it",
            ("wish.in_front_of(recliner[1], tv_stand[0], 1.", "align_with(recliner[1], tv_stand[0], 180)"),
        ),
        ("a waiting room with ten chairs, a table with four small chairs", ("wish.against_wall(chair[9]",)),
        ("a bakery with a counter and a shelf behind it", ("wish.behind(", ", 0.7, 0.85)")),
        (
            "a bathroom with a shelf above the washing machine",
            ("against_wall(washing_machine[0])", "wish.at_window(washing_machine[0], weight=-3)"),
        ),
        (
            "a waiting room with a plant in each corner",
            tuple(f"solver.corner(plant[{i}], vertex={i})" for i in range(4)),
        ),
    ],
)
def test_the_program_joins_what_words_put_together(text: str, lines: tuple[str, ...]) -> None:
    said = program(text)
    for line in lines:
        assert line in said, said


@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        ("a dining room with a sofa, a coffee table and a dining table for six", "chair", 6),
        ("a dining room for six", "chair", 6),
        ("a meeting room for ten", "office chair", 10),
        ("a lecture hall with 60 seats", "theater seat", 60),
        ("a computer lab with 24 computers", "desk", 24),
        ("a shop with five rows of shelves", "shop shelf", 15),
    ],
)
def test_so_many_and_no_more_are_there(text: str, kind: str, count: int) -> None:
    scene, _ = scene_from_sentence(text)
    assert sum(asset.category == kind for asset in scene.assets) == count


@pytest.mark.parametrize(
    ("text", "least"), [("a dining room with a round table for eight", 1.5), ("an office with a table for two", 0.5)]
)
def test_a_table_is_as_large_as_its_seats_need(text: str, least: float) -> None:
    scene, _ = scene_from_sentence(text)
    table = next(asset for asset in scene.assets if asset.category.endswith("table"))
    assert least <= max(table.size[:2]) < least + 2.0


@pytest.mark.parametrize("text", ["a 0 m wide sofa", "an office with a 1000 m desk", "a dining table for 100000"])
def test_a_thing_of_no_size_that_can_be_is_refused_by_its_name(text: str) -> None:
    with pytest.raises(
        rl.InputError, match=r"(sofa|desk|table) of .* m cannot be placed; give it sides above 0 and at most 50 m"
    ):
        scene_from_sentence(text)


def test_generate_takes_words() -> None:
    result = rl.generate("a hotel room with two queen beds and a nightstand between them")
    assert result.report.ok
    first, last = result.layout["bed-0"], result.layout["bed-1"]
    assert math.cos(first.yaw - last.yaw) > 0.99
    across = (last.x - first.x) * -math.sin(first.yaw) + (last.y - first.y) * math.cos(first.yaw)
    assert abs(across) == pytest.approx(math.dist((first.x, first.y), (last.x, last.y)), abs=0.05)


def test_what_looks_like_a_file_is_no_sentence() -> None:
    with pytest.raises(rl.InputError, match="does not exist"):
        rl.generate("a bedrom.json")


@pytest.mark.parametrize("text", ["a bed flanked by two wardrobes", "a bed between two wardrobes"])
def test_what_is_broad_stands_at_a_bed_in_place_of_night_stands(text: str) -> None:
    """With them the wardrobes stood in the middle of the room, their doors to the wall."""
    result = rl.generate(f"A bedroom with {text}.")
    assert result.report.ok and not any(asset.category == "night stand" for asset in result.scene.assets)
    bed = result.layout["bed-0"]
    for i in range(2):
        assert abs(math.remainder(result.layout[f"wardrobe-{i}"].yaw - bed.yaw, math.tau)) < 0.02


def test_a_bed_between_night_stands_or_side_tables_keeps_them() -> None:
    scene, _ = scene_from_sentence("A bedroom with a bed between two night stands.")
    assert sum(asset.category == "night stand" for asset in scene.assets) == 2


@pytest.mark.slow
def test_two_sofas_that_face_each_other_stand_straight_with_room_for_the_coffee_table() -> None:
    """Room for knees was measured from the length of the sofas, which then stood askew and 1.6 m from where the planner had them."""
    result = rl.generate("A living room with two sofas facing each other.")
    assert result.report.ok and all(item.met for item in result.report.statements)
    one, other, table = (result.layout[name] for name in ("sofa-0", "sofa-1", "coffee_table-0"))
    assert abs(math.remainder(one.yaw - other.yaw - math.pi, math.tau)) < 0.02
    assert abs(math.remainder(one.yaw, math.pi / 2)) < 0.02
    depth = sum(asset.size[0] for asset in result.scene.assets if asset.name.startswith("sofa")) / 2
    assert 1.2 < math.dist(one.at, other.at) - depth < 1.8
    assert abs(math.dist(table.at, one.at) - math.dist(table.at, other.at)) < 0.3
    assert math.dist(table.at, result.layout["rug-0"].at) < 0.1, (
        "it was built behind the second sofa, and the rug stayed there"
    )
