"""What hangs on the walls hangs where it is reached, and at the height of its kind."""

from __future__ import annotations

from itertools import pairwise

import pytest
from said_rooms import made, of

import robolayout as rl
from robolayout.planners.sentence import scene_from_sentence
from robolayout.scene import Asset, Opening, Room, Scene
from running import slow

SENTENCE = "a bedroom for two children with a bunk bed, desks and a reading corner, 4 x 5 m, for a wheelchair user"


@pytest.mark.slow
def test_mirror_and_picture_both_hang_where_a_wheelchair_user_gets_to_them() -> None:
    scene, _ = scene_from_sentence(SENTENCE)
    report = rl.generate(scene).report
    assert report.ok, report.violations


ROOM = Room(((0, 0), (4, 0), (4, 3), (0, 3)), 2.6, (Opening(0, 0.5, 0.9, 2.05),))


@pytest.mark.parametrize(
    ("category", "size", "bottom"),
    [
        ("washbasin", (0.48, 0.6, 0.86), 0.0),  # measured with its pedestal: it stands on the floor
        ("washbasin", (0.4, 0.5, 0.18), 0.68),  # the bowl alone: its rim is 0.86 m high
        ("toilet", (0.55, 0.36, 0.4), 0.05),
        ("urinal", (0.35, 0.36, 0.6), 0.5),
        ("radiator", (0.12, 1.0, 0.6), 0.1),
        ("air conditioner", (0.25, 0.85, 0.3), 2.05),
    ],
)
@pytest.mark.parametrize("agent", ["adult", "wheelchair"])
def test_what_hangs_low_or_high_hangs_there(
    category: str, size: tuple[float, float, float], bottom: float, agent: str
) -> None:
    scene = Scene(ROOM, (Asset("it", category, size, on_floor=False, on_wall=True),))
    result = rl.generate(scene, agent=agent)
    assert result.report.ok, result.report.violations
    assert result.layout["it"].z - size[2] / 2 == pytest.approx(bottom, abs=0.011)


def test_a_basin_does_not_hang_over_what_stands_at_the_wall() -> None:
    """Four beds along the walls leave free wall by the door: a basin over a bed, 1.1 m high at its foot, was thought cheaper."""
    room = Room(((0, 0), (6.4, 0), (6.4, 5), (0, 5)), 2.7, (Opening(0, 2.7, 1.1, 2.05),), (Opening(2, 1, 2, 1.2, 0.9),))
    beds = (Asset(f"bed-{i}", "hospital bed", (2.1, 0.95, 0.9)) for i in range(4))
    stands = (Asset(f"stand-{i}", "night stand", (0.45, 0.45, 0.85)) for i in range(4))
    basin = Asset("basin-0", "washbasin", (0.5, 0.6, 0.85), on_floor=False, on_wall=True)
    layout = rl.generate(Scene(room, (*beds, *stands, basin)), agent="adult").layout
    assert layout["basin-0"].z == pytest.approx(0.435, abs=0.011)


def test_a_column_is_a_part_of_the_house_that_nobody_uses() -> None:
    column = Asset("column-0", "column", (0.35, 0.35, 2.6))
    bed = Asset("bed-0", "bed", (2.0, 1.6, 0.5))
    report = rl.generate(Scene(ROOM, (column, bed), task_description="a bedroom with a column"), agent="adult").report
    assert ("a column", "met") in {(row.words, row.verdict) for row in report.asked}
    assert report.agents[0].usage.uses["column-0"].stand is None


@pytest.mark.slow
def test_a_screen_hangs_high_enough_for_what_is_asked_to_stand_under_it() -> None:
    text = (
        "A meeting room for ten with a screen on the short wall and a sideboard under it, whiteboard on the other wall."
    )
    result = rl.generate(text)
    screen, board = (result.scene.by_name[name] for name in ("projection_screen-0", "sideboard-0"))
    assert result.report.ok, result.report.violations
    assert result.layout[screen.name].z - screen.size[2] / 2 >= board.size[2]
    assert result.solution.phase == "built"


@pytest.mark.parametrize(
    ("text", "kind", "below", "many"),
    [
        ("a living room with two shelves above the TV", "wall_shelf", "television", 2),
        slow("a kitchen with two shelves above the counter", "wall_shelf", "kitchen_counter", 2),
        slow("a living room with three pictures above the sofa", "picture", "sofa", 3),
    ],
)
def test_several_over_one_thing_hang_side_by_side_over_its_width(text: str, kind: str, below: str, many: int) -> None:
    result = made(text)
    assert result.report.ok, result.report.violations
    (low,) = of(result, below)
    half = result.scene.by_name[low].size[1] / 2
    across = sorted(result.layout[low].seen(result.layout[name].at)[1] for name in of(result, kind))
    near = [y for y in across if abs(y) <= half + 0.05]
    wide = max(result.scene.by_name[name].size[1] for name in of(result, kind))
    assert len(near) == many
    assert all(b - a > wide for a, b in pairwise(near))


def test_shelves_over_what_is_too_narrow_for_two_hang_one_over_the_other() -> None:
    result = made("a bathroom with a sink and two shelves above the sink")
    assert result.report.ok, result.report.violations
    first, second = (result.layout[name] for name in of(result, "wall_shelf"))
    assert second.z - first.z > result.scene.by_name["wall_shelf-0"].size[2]
    assert abs(first.x - second.x) + abs(first.y - second.y) < result.scene.by_name["wall_shelf-0"].size[1]


def test_shelves_over_a_counter_are_there_in_place_of_wall_cabinets() -> None:
    scene, _ = scene_from_sentence("a kitchen with two shelves above the counter")
    assert not any(one.category == "wall cabinet" for one in scene.assets)


def test_pictures_over_a_sofa_are_narrow_enough_for_all_of_them() -> None:
    scene, _ = scene_from_sentence("a living room with three pictures above the sofa")
    sofa = scene.by_name["sofa-0"].size[1]
    assert sum(one.size[1] for one in scene.assets if one.category == "picture") < sofa


@pytest.mark.parametrize(
    ("text", "below", "columns", "rows"),
    [
        ("a living room with three pictures above the sofa", "sofa", 3, 1),
        ("a living room with six photos above the sofa", "sofa", 3, 2),
        slow("a bedroom with four framed prints above the bed", "bed", 2, 2),
    ],
)
def test_pictures_over_a_thing_hang_in_straight_rows_and_columns(
    text: str, below: str, columns: int, rows: int
) -> None:
    """A body gets to none of them over a deep sofa: they are there to be looked at."""
    result = made(text)
    assert result.report.ok, result.report.violations
    (low,) = of(result, below)
    poses = [result.layout[name] for name in of(result, "picture")][: columns * rows]
    across = {round(result.layout[low].seen(pose.at)[1], 2) for pose in poses}
    assert (len(across), len({round(pose.z, 2) for pose in poses})) == (columns, rows)
    assert sum(across) == pytest.approx(0.0, abs=0.05)


def test_each_of_two_over_a_night_stand_hangs_over_the_other() -> None:
    result = made("a bedroom with two pictures above each night stand")
    assert result.report.ok, result.report.violations


def test_the_usual_picture_of_a_bedroom_hangs_over_the_middle_of_its_bed() -> None:
    result = made("a bedroom with a double bed and two night stands")
    (bed,) = of(result, "bed")
    across = [abs(result.layout[bed].seen(result.layout[name].at)[1]) for name in of(result, "picture")]
    assert min(across) < 0.05
