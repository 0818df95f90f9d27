"""Doors and windows are made in the walls in which words put them."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import pytest
from shapely import LineString

import robolayout as rl
from robolayout.constraints import AssetRef
from robolayout.constraints._exact import footprint
from robolayout.constraints.mounted_on import MountedOn
from robolayout.planners.sentence import scene_from_sentence
from robolayout.scene import Layout, Opening, Scene
from robolayout.words import COMPASS, read_words
from running import slow


def sides(scene: Scene, openings: tuple[Opening, ...]) -> list[str]:
    """Return the names of the walls that some openings are in."""
    names = {normal: name for name, normal in COMPASS.items()}
    normals = [scene.room.walls[opening.wall].normal for opening in openings]
    return sorted(names[round(x) + 0.0, round(y) + 0.0] for x, y in normals)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(
    ("text", "windows", "doors"),
    [
        ("A study with a north window.", ["north"], None),
        ("A study with a desk under the north window.", ["north"], None),
        ("A study with a desk under the north window and a bed under the south window.", ["north", "south"], None),
        ("A study with a south-facing window.", ["south"], None),
        ("A study with a large window to the east.", ["east"], None),
        ("A study with a door on the east side and a window on the west side.", ["west"], ["east"]),
        ("A study with windows on the north and west walls.", ["north", "west"], None),
        ("A study with a door in the north wall and a window in the north wall.", ["north"], ["north"]),
        ("A study with two windows facing south and a door on the left.", ["south", "south"], ["west"]),
        ("A study with a door to the north and another door to the south.", None, ["north", "south"]),
        ("A study with a door in the west wall and a window opposite the door.", ["east"], ["west"]),
        ("A study with two doors, one in the north wall and one in the south wall.", None, ["north", "south"]),
        ("A study with two windows: one in the west wall and one above the desk.", None, None),
    ],
)
def test_doors_and_windows_are_in_the_walls_in_which_they_are_said_to_be(
    text: str, windows: list[str] | None, doors: list[str] | None, seed: int
) -> None:
    scene, _ = scene_from_sentence(text, seed=seed)
    assert windows in (None, sides(scene, scene.room.windows))
    assert doors in (None, sides(scene, scene.room.doors))
    assert not [row for row in read_words(scene).rows if row.kind == "not understood"]
    for wall in range(4):
        ends = sorted(
            (o.offset, o.offset + o.width) for o in (*scene.room.doors, *scene.room.windows) if o.wall == wall
        )
        assert all(one[1] <= two[0] for one, two in pairwise(ends))


def test_a_window_in_another_wall_than_the_one_asked_for_is_not_met() -> None:
    scene, _ = scene_from_sentence("A study with a window.")
    there = sides(scene, scene.room.windows)
    for side in COMPASS:
        asked = replace(scene, task_description=f"A study with a {side} window.")
        rows = read_words(asked).judged(asked, Layout({}))
        assert [row.verdict == "met" for row in rows if row.kind == "opening"] == [side in there]


@pytest.mark.parametrize("seed", range(6))
def test_no_window_is_where_a_board_of_a_short_wall_is_to_hang(seed: int) -> None:
    text = "A meeting room for ten with a screen on the short wall and a whiteboard on the opposite wall."
    room = scene_from_sentence(text, seed=seed)[0].room
    assert room.windows
    assert {room.walls[window.wall].length for window in room.windows} == {max(wall.length for wall in room.walls)}


@pytest.mark.parametrize(
    ("text", "name"),
    [
        slow("An office with a filing cabinet between the window and the door.", "filing_cabinet-0"),
        ("A bedroom with a bed against the wall between the two windows.", "bed-0"),
        ("A lounge with a picture between the windows.", "picture-0"),
    ],
)
def test_what_is_between_a_window_and_another_opening_is_at_their_wall(text: str, name: str) -> None:
    scene, _ = scene_from_sentence(text)
    result = rl.generate(scene)
    (row,) = [row for row in result.report.asked if row.kind == "relation" and "between" in row.understanding]
    assert row.verdict == "met"
    (wall,) = {opening.wall for opening in scene.room.windows}
    side = LineString([scene.room.walls[wall].start, scene.room.walls[wall].end])
    assert side.distance(footprint(scene, result.layout, AssetRef(name))) < 0.1


def test_what_is_between_openings_in_two_walls_is_between_them_in_the_room() -> None:
    scene, _ = scene_from_sentence(
        "A study with a window in the north wall, a door in the east wall and a plant between the door and the window."
    )
    (demand,) = read_words(scene).demands
    assert [[relation.name for relation in way] for way in demand.ways] == [["between"]]


@pytest.mark.slow
@pytest.mark.parametrize(
    "text", ["A lounge with curtains on both windows.", slow("A lounge with a plant at each window.")]
)
def test_each_window_has_its_own(text: str) -> None:
    scene, _ = scene_from_sentence(text)
    demands, middles = read_words(scene).demands, [scene.room.walls[o.wall].point(o.center) for o in scene.room.windows]
    assert [relation.asset_names()[0][-1] for demand in demands for way in demand.ways for relation in way] == [
        "0",
        "1",
    ]
    assert len(middles) == 2 and rl.generate(scene).report.ok


def test_a_door_is_in_the_middle_of_its_wall_where_a_counter_with_neighbours_is_opposite_to_it() -> None:
    text = "a deli shop with the deli counter opposite the entrance and a display fridge to the left of the counter"
    scene, _ = scene_from_sentence(text)
    (door,) = scene.room.doors
    assert abs(door.center - scene.room.walls[door.wall].length / 2) < 0.02


def test_a_board_at_the_front_hangs_on_a_wall_that_holds_it() -> None:
    """Two windows were in that wall, and no room between them."""
    scene, _ = scene_from_sentence("a physics lab with four benches in two rows and a whiteboard at the front")
    said = [one for demand in read_words(scene).demands for way in demand.ways for one in way]
    (board,) = {one for one in said if isinstance(one, MountedOn)}
    assert board.wall is not None
    assert board.wall.index not in {window.wall for window in scene.room.windows}
