"""What is said to be under a thing stands under it, and is unmet where there is no room; rows before mirrors; further things."""

from __future__ import annotations

import pytest
import shapely
from tests.planners.said_rooms import made, of

from robolayout.constraints._exact import footprint
from robolayout.constraints._refs import AssetRef
from robolayout.planners import scene_from_sentence
from robolayout.run.result import Result
from running import slow


def below(result: Result, low: str, high: str) -> float:
    """Return the share of a thing that is under another."""
    one, two = (footprint(result.scene, result.layout, AssetRef(name)) for name in (low, high))
    return shapely.intersection(one, two).area / one.area


@pytest.mark.parametrize(
    ("text", "pairs"),
    [
        slow("An office with a desk, a bin under the desk and a bookshelf.", [("trash_can-0", "desk-0")]),
        slow("A bedroom with a loft bed, a desk under the loft bed with a chair.", [("desk-0", "loft_bed-0")]),
        (
            "A laundry room with a washing machine and a dryer side by side under a counter.",
            [("washing_machine-0", "kitchen_counter-0"), ("clothes_dryer-0", "kitchen_counter-0")],
        ),
        slow("A hotel room with a desk and a minibar under the desk.", [("minibar-0", "desk-0")]),
        ("An entryway with a console table and a basket under the console table.", [("basket-0", "console_table-0")]),
    ],
)
def test_what_is_said_to_be_under_a_thing_stands_there(text: str, pairs: list[tuple[str, str]]) -> None:
    result = made(text)
    assert result.report.ok, result.report.violations
    for low, high in pairs:
        assert below(result, low, high) >= 0.5


@pytest.mark.slow
def test_what_has_no_room_under_a_thing_is_unmet_and_says_why() -> None:
    result = made("A bedroom with a bed and a storage box under the bed.")
    (row,) = [row for row in result.report.asked if row.kind == "relation"]
    assert row.verdict == "unmet" and "does not fit under bed-0: only things up to" in row.value
    assert not [name for name, good in result.report.physics.collision_free.items() if not good]


@pytest.mark.parametrize(
    "text",
    [
        "A barbershop with three barber chairs in a row, each facing a mirror on the wall, a waiting bench and a cash desk.",
        slow(
            "A hair salon with four styling chairs in a row, each in front of its own mirror, and two wash basins along the wall."
        ),
    ],
)
def test_a_row_of_chairs_has_a_row_of_mirrors(text: str) -> None:
    result = made(text)
    assert result.report.ok, result.report.violations
    assert len({round(result.layout[name].yaw, 3) for name in of(result, "mirror")}) == 1


@pytest.mark.parametrize(
    "text",
    [
        "A bedroom with a bed with 0.9 m free on both sides and a night stand with a lamp on it next to the bed.",
        slow("A hospital room with a bed that has 1 m of free space on each side and a bedside cabinet."),
    ],
)
def test_a_night_stand_may_stand_where_the_floor_beside_the_bed_is_free(text: str) -> None:
    result = made(text)
    assert result.report.ok, result.report.violations
    (bed,) = [name for name in result.layout if name.endswith("bed-0")]
    here, there = (footprint(result.scene, result.layout, AssetRef(name)) for name in (bed, "night_stand-0"))
    assert here.distance(there) < 0.4


@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        ("A living room with a sofa by the door and a second sofa by the window.", "sofa", 2),
        ("A living room with a shelf by the door and a second shelf by the window.", "shelving_unit", 2),
        ("A kitchen with a shelving unit: pots on the bottom shelf, plates on the second shelf.", "shelving_unit", 1),
        ("A meeting room with a U-shaped arrangement of tables for ten people.", "conference_table", 5),
        ("A meeting room with five tables for ten people.", "office_chair", 10),
        ("A cafe with four tables for two people.", "chair", 8),
        ("A dressing room with five makeup stations along the wall, each with a chair.", "stool", 0),
    ],
)
def test_so_many_are_meant(text: str, kind: str, count: int) -> None:
    scene, _ = scene_from_sentence(text)
    assert sum(asset.variable == kind for asset in scene.assets) == count


@pytest.mark.slow
def test_a_patient_monitor_hangs_by_the_bed_and_not_over_the_basin() -> None:
    result = made("A hospital room with a bed and a bedside cabinet.")
    monitor, bed = (result.layout[name].at for name in ("patient_monitor-0", "hospital_bed-0"))
    assert abs(monitor[0] - bed[0]) + abs(monitor[1] - bed[1]) < 2.5
