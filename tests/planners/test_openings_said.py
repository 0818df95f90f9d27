"""Doors and windows are made in the walls in which words put them."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import pytest

from robolayout.planners.sentence import scene_from_sentence
from robolayout.scene import Layout, Opening, Scene
from robolayout.words import COMPASS, read_words


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
