"""So many metres between edges, left and right of doors and windows, measured on poses by Shapely alone."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from said_rooms import made, of
from shapely import LineString, Polygon

import robolayout as rl
from robolayout.run.result import Result
from robolayout.words import read_words
from running import slow


def plan(result: Result, name: str) -> Polygon:
    return Polygon(result.layout[name].corners(result.scene.by_name[name].size))


@pytest.mark.parametrize(
    ("text", "kinds", "low", "high"),
    [
        ("a bedroom with twin beds 80 cm apart", ("twin_bed", "twin_bed"), 0.8, 1.04),
        slow("a bedroom with two beds 1 m apart and a rug between them", ("bed", "bed"), 1.0, 1.3),
        ("a living room with an armchair 30 cm from the bookshelf", ("armchair", "bookshelf"), 0.3, 0.39),
        slow("a living room with an armchair 50 cm to the left of the sofa", ("armchair", "sofa"), 0.5, 0.8),
        slow("a bedroom with a bed and a desk 1.8 m to the right of the bed", ("desk", "bed"), 1.8, 2.1),
        ("an office with a desk and a bookshelf 2 m behind it", ("bookshelf", "desk"), 2.0, 2.3),
        slow("a living room with a TV unit and a sofa 2.5 m in front of it", ("sofa", "tv_stand"), 2.5, 2.8),
        ("a room with two armchairs facing each other 1.5 m apart", ("armchair", "armchair"), 1.5, 1.8),
        ("a bedroom with a crib within 1 m of the bed", ("crib", "bed"), 0.0, 1.0),
        ("a bedroom with a wardrobe at least 1 m away from the bed", ("wardrobe", "bed"), 1.0, math.inf),
        slow("a bedroom with a 1.2 m gap between the bed and the wardrobe", ("bed", "wardrobe"), 1.2, 1.5),
    ],
)
def test_so_many_metres_lie_between_edges(text: str, kinds: tuple[str, str], low: float, high: float) -> None:
    result = made(text)
    one, two = (of(result, kinds[0])[0], of(result, kinds[1])[-1])
    assert low - 0.051 <= plan(result, one).distance(plan(result, two)) <= high + 0.051
    assert result.report.ok and all(row.verdict == "met" for row in result.report.asked if row.kind == "relation")


@pytest.mark.parametrize(("metres", "verdict"), [(0.7, "unmet"), (0.82, "met"), (1.0, "met"), (1.73, "unmet")])
def test_the_row_of_a_gap_is_met_by_that_gap_and_no_other(metres: float, verdict: str) -> None:
    scene, _ = rl.scene_from_sentence("a bedroom with twin beds 80 cm apart")
    layout = made("a bedroom with twin beds 80 cm apart").layout
    one, two = (name for name in layout if name.startswith("twin_bed"))
    wide, here = scene.by_name[one].size[1], layout[one]
    left = (-math.sin(here.yaw) * (wide + metres), math.cos(here.yaw) * (wide + metres))
    moved = replace(layout[two], x=here.x + left[0], y=here.y + left[1], yaw=here.yaw)
    rows = read_words(scene).judged(scene, rl.Layout({**layout, two: moved}))
    (row,) = (row for row in rows if "apart" in row.words)
    assert row.verdict == verdict and f"{metres:.2f} m between, asked 0.8 to 1.04 m" in row.value


@pytest.mark.parametrize(
    ("text", "kind", "nearest"),
    [
        slow("a living room with a sofa 50 cm away from the wall and a bookshelf behind it", "sofa", True),
        slow("a dining room with the table 1 m from the wall", "dining_table", True),
        ("a bedroom with 60 cm between the bed and the wall", "bed", False),  # its head may be at another one
    ],
)
def test_so_many_metres_off_a_wall(text: str, kind: str, nearest: bool) -> None:
    result = made(text)
    low = {"sofa": 0.5, "dining_table": 1.0, "bed": 0.6}[kind]
    gaps = [
        LineString([wall.start, wall.end]).distance(plan(result, of(result, kind)[0]))
        for wall in result.scene.room.walls
    ]
    fits = [low - 0.051 <= gap <= low + 0.351 for gap in ([min(gaps)] if nearest else gaps)]
    assert any(fits) and result.report.ok


@pytest.mark.parametrize(
    ("text", "kind", "opening", "side"),
    [
        ("a room with a desk left of the window and an armchair right of the window", "desk", "windows", "left"),
        ("a room with a desk left of the window and an armchair right of the window", "armchair", "windows", "right"),
        ("a bedroom with the bed to the left of the door", "bed", "doors", "left"),
        ("a bathroom with the toilet to the right of the door", "toilet", "doors", "right"),
    ],
)
def test_what_is_left_of_a_door_or_window_is_there_as_one_sees_it_from_inside(
    text: str, kind: str, opening: str, side: str
) -> None:
    result = made(text)
    room = result.scene.room
    one = getattr(room, opening)[0]
    wall = room.walls[one.wall]
    x, y = wall.point(one.center)
    here = result.layout[of(result, kind)[0]]
    outward = (-wall.normal[0], -wall.normal[1])
    across = outward[0] * (here.y - y) - outward[1] * (here.x - x)  # above 0 at the left hand of who looks out
    assert (across > 0.0) == (side == "left") and result.report.ok


def test_a_shelf_above_a_desk_hangs_there() -> None:
    result = made("an office with a desk and a shelf above it")
    (shelf,), (desk,) = of(result, "wall_shelf"), of(result, "desk")
    assert result.layout[shelf].z > result.layout[desk].z + 0.5
    assert plan(result, shelf).distance(plan(result, desk)) < 0.05


@pytest.mark.parametrize(
    ("text", "counts"),
    [
        ("a living room with two sofas at a right angle and a coffee table in front of both", {"coffee_table": 1}),
        ("a living room with a sofa and an armchair on either side of the fireplace", {"sofa": 1, "armchair": 1}),
        ("a bed with a lamp on both nightstands", {"table_lamp": 2}),
    ],
)
def test_both_share_what_stands_before_them_and_have_their_own_on_them(text: str, counts: dict[str, int]) -> None:
    scene, _ = rl.scene_from_sentence(text)
    assert {kind: sum(name.startswith(f"{kind}-") for name in scene.by_name) for kind in counts} == counts


def test_the_size_of_a_room_that_stands_askew_is_that_of_its_sides() -> None:
    scene, _ = rl.scene_from_sentence("a bedroom of 5 x 4 m")
    c, s = math.cos(0.6), math.sin(0.6)
    turned = tuple((c * x - s * y, s * x + c * y) for x, y in scene.room.vertices)
    askew = replace(scene, room=replace(scene.room, vertices=turned))
    rows = [row for row in read_words(askew).judged(askew, rl.Layout({})) if row.kind == "room size"]
    assert [row.verdict for row in rows] == ["met"]
