"""What is said of doors and windows: how wide they are, where along their walls, in which wall, and that they stay free."""

from __future__ import annotations

from dataclasses import replace

import pytest

from robolayout.planners.sentence import scene_from_sentence
from robolayout.scene import Layout, Opening, Room, Scene
from robolayout.words import read_words

WALLS = {"south": 0, "east": 1, "north": 2, "west": 3}


def scene_of(text: str) -> Scene:
    return scene_from_sentence(text)[0]


def rows(text: str, kind: str) -> list[str]:
    return [row.understanding for row in read_words(scene_of(text)).rows if row.kind == kind]


@pytest.mark.parametrize(
    ("text", "doors", "windows"),
    [
        ("a bedroom. The door is in the east wall, 80 cm wide, and a window, 2 m wide, is in the south wall", 0.8, 2.0),
        (
            "a bedroom. The door (90 cm wide) is on the west wall. There is a window 1.2 m wide on the north wall",
            0.9,
            1.2,
        ),
        ("a bedroom with an 80 cm wide door on the east wall and a 1.6 m wide window on the south wall", 0.8, 1.6),
        ("a bedroom with a door, which is 1 m wide, and two windows, each 1.1 m wide, in the east wall", 1.0, 1.1),
    ],
)
def test_doors_and_windows_are_as_wide_as_is_said(text: str, doors: float, windows: float) -> None:
    scene = scene_of(text)
    assert {opening.width for opening in scene.room.doors} == {doors}
    assert {opening.width for opening in scene.room.windows} == {windows}
    assert not rows(text, "not understood")


def before_and_after(room: Room, opening: Opening) -> tuple[float, float]:
    return opening.offset, room.walls[opening.wall].length - opening.offset - opening.width


@pytest.mark.parametrize(
    ("text", "wall", "where"),
    [
        ("a bedroom with a door in the middle of the south wall", "south", "middle"),
        ("a bedroom. The door is in the middle of the west wall, the window in the center of the east wall", "west", "middle"),
        ("a bedroom with the door on the north wall near the east corner", "north", "start"),
        ("a bedroom. The door is at the west end of the south wall", "south", "start"),
        ("a bedroom. The door is in the left corner of the south wall", "south", "end"),
        ("a bedroom with the door on the left side of the south wall", "south", "end"),
        ("a bedroom with a desk in the corner farthest from the door, which is in the middle of the short south wall",
         "south", "middle"),
        ("a bedroom with a door in the north-west corner", "north", "end"),
        ("a bedroom. The door is on the west wall close to the south-west corner", "west", "end"),
    ],
)  # fmt: skip
def test_doors_are_where_along_their_walls_they_are_said_to_be(text: str, wall: str, where: str) -> None:
    room = scene_of(text).room
    (door,) = room.doors
    before, after = before_and_after(room, door)
    assert door.wall == WALLS[wall]
    if where == "middle":
        assert before == pytest.approx(after, abs=0.02)
    else:
        assert (before if where == "start" else after) == pytest.approx(0.3)


def test_a_door_is_so_far_from_a_corner() -> None:
    room = scene_of("a bedroom. The door is on the south wall, 90 cm wide, 1 m from the west corner").room
    (door,) = room.doors
    assert (door.wall, door.width, door.offset) == (0, 0.9, 1.0)


@pytest.mark.parametrize(
    ("text", "openings"),
    [
        ("a bedroom. Door: south wall. Window: east wall.", ["1 south door", "1 east window"]),
        ("a bedroom with the door to the hall on the east side", ["1 east door"]),
        ("a living room with a sofa. The windows are both on the south wall", ["2 south window"]),
        ("a study with two doors, one in the north wall and one in the south wall", ["1 north door", "1 south door"]),
    ],
)
def test_short_ways_to_say_where_doors_are(text: str, openings: list[str]) -> None:
    assert rows(text, "opening") == openings
    assert not rows(text, "not understood")


@pytest.mark.parametrize(
    ("text", "door", "relation"),
    [
        ("a study with a desk opposite the door, which is on the west wall", "west", "desk opposite west door"),
        ("a kitchen with a round table near the door, which is in the south wall", "south", "round table near south door"),
        ("a lobby with a desk facing the entrance, which is on the north wall", "north", "desk facing north door"),
    ],
)  # fmt: skip
def test_a_clause_after_a_door_is_about_the_door(text: str, door: str, relation: str) -> None:
    scene = scene_of(text)
    assert [one.wall for one in scene.room.doors] == [WALLS[door]]
    said = [row.words for row in read_words(scene).rows if row.kind == "relation"]
    assert said == [relation]


@pytest.mark.parametrize(
    "said",
    [
        "Please leave the window free",
        "The window must stay free",
        "Please don't put anything in front of the window",
        "Avoid placing furniture in front of the window",
    ],
)
def test_windows_are_kept_free(said: str) -> None:
    (kept,) = rows(f"A bedroom with a bed. {said}.", "relation")
    assert kept.startswith("bed-0 at least 0.6 m from")


def test_two_doors_are_never_in_one_place_and_those_of_a_wardrobe_are_its_own() -> None:
    room = scene_of("a library with a door in the middle of the south wall and another door in the south wall").room
    one, other = sorted(room.doors, key=lambda door: door.offset)
    assert one.wall == other.wall == 0
    assert one.offset + one.width <= other.offset
    text = "a bedroom with a door on the east wall. A wardrobe stands in the northwest corner, its doors facing east"
    assert len(scene_of(text).room.doors) == 1
    assert rows(text, "relation")[0].startswith("corner(wardrobe-0")


def test_what_stands_at_a_wall_without_doors_and_windows_is_at_one() -> None:
    text = "a dining room with a sideboard against the wall that has no door or window"
    room = scene_of(text).room
    free = {wall.index for wall in room.walls} - {one.wall for one in (*room.doors, *room.windows)}
    assert rows(text, "relation") == [f"against_wall(sideboard-0, walls[{wall}])" for wall in free]


def test_a_door_elsewhere_or_narrower_than_is_said_is_not_what_was_asked() -> None:
    scene = scene_of("a bedroom with an 80 cm wide door in the middle of the south wall")
    asked = read_words(scene)
    (door,) = scene.room.doors

    def verdict(offset: float, width: float) -> str:
        other = replace(door, offset=offset, width=width)
        room = replace(scene.room, doors=(other,))
        judged = asked.judged(replace(scene, room=room), Layout({}))
        return next(row.verdict for row in judged if row.kind == "opening")

    assert verdict(door.offset, door.width) == "met"
    assert verdict(0.3, door.width) == "unmet"
    assert verdict(door.offset, 1.1) == "unmet"
