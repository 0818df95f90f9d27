"""The exact check of what is drawn: it finds what it must, and generated rooms pass it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from benchmarks.triangles import penetrations

import robolayout as rl
from robolayout.assets import resting_place
from robolayout.scene import Asset, Layout, Pose, Room, Scene
from running import slow

ROOT = Path(__file__).parents[1]
TABLE = Asset("table-0", "dining table", (0.9, 1.6, 0.75))
CHAIR = Asset("chair-0", "dining chair", (0.5, 0.5, 0.9))
PLATE = Asset("plate-0", "plate", (0.26, 0.26, 0.025), on_floor=False, on_object=True)
ROOM = Room(((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)), 2.6)


def through(*placed: tuple[Asset, float, float]) -> list[tuple[str, str, float]]:
    layout = Layout({a.name: Pose(x, 2.0, bottom + a.size[2] / 2, 0.0) for a, x, bottom in placed})
    found = penetrations(Scene(ROOM, tuple(a for a, _, _ in placed)), layout)
    return [(item.a, item.b, round(item.depth, 3)) for item in found]


def test_what_goes_through_another_thing_is_found_to_the_millimetre() -> None:
    other = replace(TABLE, name="table-1")
    assert through((TABLE, 1.0, 0.0), (other, 1.9, 0.0)) == []
    assert through((TABLE, 1.0, 0.0), (other, 1.88, 0.0)) == [("table-0", "table-1", 0.02)]
    assert through((TABLE, 1.0, 0.0), (PLATE, 1.0, 0.749)) == []
    assert through((TABLE, 1.0, 0.0), (PLATE, 1.0, 0.745)) == [("table-0", "plate-0", 0.005)]


def test_a_chair_goes_under_a_table_as_far_as_its_back() -> None:
    assert through((TABLE, 1.0, 0.0), (CHAIR, 1.0 - 0.45 - 0.25 + 0.18, 0.0)) == []
    assert through((TABLE, 1.0, 0.0), (CHAIR, 1.0 - 0.45 - 0.25 + 0.48, 0.0))


def test_a_cushion_lies_on_the_seat() -> None:
    sofa = Asset("sofa-0", "sofa", (0.93, 2.1, 0.85))
    cushion = Asset("cushion-0", "cushion", (0.4, 0.4, 0.15), on_floor=False, on_object=True)
    place = resting_place(sofa, cushion)
    assert through((sofa, 1.0, 0.0), (cushion, 1.2, place.height))[1:] == []


@pytest.mark.parametrize("name", ["tasks/dining_room_small", slow("tasks/office")])
def test_rooms_are_free_of_it_dressed_in_full(name: str) -> None:
    result = rl.generate(ROOT / f"examples/{name}.json", dress="full")
    assert len(result.scene.assets) > 40
    assert result.report.physics.ok
    assert penetrations(result.scene, result.layout) == []
