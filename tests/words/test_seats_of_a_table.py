"""Seats of a table of which one is told where it is: at the head, at the ends, on both sides; the others leave it its place."""

from __future__ import annotations

import math
from collections import Counter

import pytest

import robolayout as rl
from robolayout.planners import scene_from_sentence


def counts(text: str) -> Counter[str]:
    return Counter(asset.category for asset in scene_from_sentence(text)[0].assets)


def at_sides(result: rl.Result, table: str) -> Counter[str]:
    """Return how many seats are nearest to each side of a table, in its own frame."""
    at, size = result.layout[table], result.scene.by_name[table].size
    found: Counter[str] = Counter()
    for asset in result.scene.assets:
        if asset.category.endswith("chair"):
            pose = result.layout[asset.name]
            dx, dy = pose.x - at.x, pose.y - at.y
            ahead = math.cos(at.yaw) * dx + math.sin(at.yaw) * dy
            left = math.cos(at.yaw) * dy - math.sin(at.yaw) * dx
            end = abs(left) / size[1] > abs(ahead) / size[0]
            found[("left" if left > 0 else "right") if end else ("front" if ahead > 0 else "back")] += 1
    return found


@pytest.mark.parametrize(
    ("text", "table", "sides"),
    [
        ("A dining room with a table and six chairs, one at the head of the table.", "dining_table-0", (2, 2, 1, 1)),
        ("A kitchen with a table with four chairs and a high chair at the head of the table.", "dining_table-0", (2, 2, 0, 1)),
        ("A dining room with a table with eight chairs, two armchairs at the ends of the table.", "dining_table-0", (4, 4, 1, 1)),
        ("A conference table with chairs around it and the chairman's chair at the head of the table.", "conference_table-0", (4, 4, 0, 1)),
    ],
)  # fmt: skip
def test_who_sits_at_the_head_has_the_place_there_alone(text: str, table: str, sides: tuple[int, ...]) -> None:
    result = rl.generate(text, dress="none")
    assert result.report.ok, result.report.violations
    found = at_sides(result, table)
    long, ends = sorted((found["front"], found["back"])), sorted((found["left"], found["right"]))
    assert (*long, *ends) == sides


def test_a_chair_that_is_somebodys_is_one_more_and_the_others_stay_around_the_table() -> None:
    found = counts("A conference table with chairs around it and the chairman's chair at the head of the table.")
    assert (found["office chair"], found["chair"]) == (8, 1)
    assert counts("A dining room with a table for six, the host's chair at the head of it.")["chair"] == 6


def test_two_on_both_sides_of_tables_in_a_row_sit_before_and_behind_them() -> None:
    text = "A nail salon with three manicure tables in a row, each with a chair on both sides."
    result = rl.generate(text, dress="none")
    assert result.report.ok, result.report.violations
    rows = [row.understanding for row in result.report.asked if row.words.startswith("chair on both sides")]
    assert rows and "in_front_of(chair-0, manicure_table-0" in rows[0] and "behind(chair-1" in rows[0]


def test_what_each_seat_has_lies_on_the_table_before_it() -> None:
    text = "A meeting room with a table, six chairs and a laptop for each of them."
    scene = scene_from_sentence(text)[0]
    assert sum(asset.category == "laptop" for asset in scene.assets) == 6
    result = rl.generate(scene, dress="none")
    assert result.report.ok, result.report.violations
