"""The room's own parts: floor area, walls outside and cut around openings, concave and slanted rooms, bounded size."""

import math
from dataclasses import replace

import numpy as np
import pytest
from geometry_laws import bounds, dent, flicker, is_closed, normals
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import Point, Polygon

from robolayout.assets import Part, room_parts, room_style
from robolayout.assets.rooms import FLOORS, SHELL, STYLES
from robolayout.scene import Opening, Room

RECTANGLE = Room(
    ((0, 0), (5, 0), (5, 4), (0, 4)), 2.6, (Opening(0, 3.5, 0.9, 2.05),), (Opening(2, 1.0, 1.6, 1.3, 0.9),)
)
L_SHAPE = Room(
    ((0, 0), (6, 0), (6, 3), (3, 3), (3, 5.5), (0, 5.5)),
    2.6,
    (Opening(0, 0.5, 0.9, 2.05), Opening(5, 1.0, 0.9, 2.05)),
    (Opening(1, 1.0, 1.2, 1.2, 0.9),),
)
SLANTED = Room(((0, 0), (4, -1), (6, 2), (3, 5), (0, 3.5)), 3.0, (Opening(4, 0.5, 0.9, 2.05),))
ROOMS = pytest.mark.parametrize("room", [RECTANGLE, L_SHAPE, SLANTED], ids=["rectangle", "L", "slanted"])


def _volume(part: Part) -> float:
    t = part.vertices[part.faces]
    return float(np.einsum("ij,ij->i", t[:, 0], np.cross(t[:, 1], t[:, 2])).sum() / 6)


@ROOMS
def test_the_floor_covers_the_room_and_nothing_else(room: Room) -> None:
    for seed in range(len(STYLES)):
        floor = [part for part in room_parts(room, seed=seed) if part.name == "floor"]
        slab, *sheets = floor
        assert _volume(slab) == pytest.approx(room.area * 0.059)
        covered = sum(float(normals(sheet)[:, 2].sum()) / 2 for sheet in sheets)
        assert 0.95 * room.area < covered <= room.area + 1e-9
        assert sum(len(part.faces) for part in floor) < 400


@ROOMS
def test_walls_stand_outside_and_leave_their_openings_free(room: Room) -> None:
    outline = Polygon(room.vertices)
    built = room_parts(room)
    for i, wall in enumerate(room.walls):
        blocks = [part for part in built if part.name == f"wall-{i}"]
        for part in blocks:
            assert is_closed(part)
            assert dent(part) < 1e-6
            middle = part.vertices.mean(axis=0)
            assert not outline.contains(Point(middle[:2]))
        holes = [o for o in (*room.doors, *room.windows) if o.wall == i]
        inner = sum(_face_area(part, wall.normal, wall.start) for part in blocks)
        assert inner == pytest.approx(wall.length * room.wall_height - sum(o.width * o.height for o in holes))


def _face_area(part: Part, normal, start) -> float:
    """Area of the faces that lie in the wall's inner plane and look into the room."""
    total = 0.0
    for n, t in zip(normals(part), part.vertices[part.faces], strict=True):
        size = float(np.linalg.norm(n))
        inside = abs((t[0][0] - start[0]) * normal[0] + (t[0][1] - start[1]) * normal[1]) < 1e-9
        if size > 1e-12 and inside and (n[0] * normal[0] + n[1] * normal[1]) / size > 0.999:
            total += size / 2
    return total


@ROOMS
def test_doors_windows_and_skirting_are_closed_convex_and_named(room: Room) -> None:
    built = room_parts(room)
    names = {part.name for part in built}
    assert {f"door-{i}" for i in range(len(room.doors))} <= names
    assert {f"window-{i}" for i in range(len(room.windows))} <= names
    for part in built:
        if not part.name.startswith("floor"):
            assert is_closed(part) and dent(part) < 1e-6, part.name


@ROOMS
def test_nothing_flickers(room: Room) -> None:
    assert [row for row in flicker(room_parts(room)) if row[2] > 4e-4] == []


@ROOMS
def test_nothing_but_the_skirting_reaches_into_the_room(room: Room) -> None:
    outline = Polygon(room.vertices).buffer(-1e-6)
    for part in room_parts(room):
        if not part.name.startswith(("floor", "skirting")):
            assert not any(outline.contains(Point(v[:2])) for v in part.vertices), part.name
        elif part.name.startswith("skirting"):
            assert all(outline.exterior.distance(Point(v[:2])) < 0.03 for v in part.vertices)


def test_seed_and_style_choose_the_look() -> None:
    assert room_style(0) != room_style(1)
    chosen = room_parts(RECTANGLE, style=STYLES[3], seed=1)
    assert any(part.material == STYLES[3].wall for part in chosen)


def test_openings_past_the_wall_or_on_top_of_each_other_do_no_harm() -> None:
    room = Room(
        RECTANGLE.vertices,
        2.0,
        (Opening(0, 4.5, 0.9, 2.4), Opening(0, 4.0, 0.8, 2.0)),
        (Opening(0, 3.9, 1.0, 1.0, 0.5),),
    )
    built = room_parts(room)
    assert bounds(part for part in built if part.name.startswith("wall")).max() < 5 + 3 * SHELL.thickness


@settings(max_examples=25, deadline=None)
@given(st.lists(st.floats(2.0, 12.0), min_size=3, max_size=9), st.integers(0, 9))
def test_any_star_shaped_room_works(radii: list[float], seed: int) -> None:
    turn = [2 * math.pi * i / len(radii) for i in range(len(radii))]
    room = Room(tuple((r * math.cos(t), r * math.sin(t)) for r, t in zip(radii, turn, strict=True)), 2.5)
    built = room_parts(room, seed=seed)
    assert _volume(built[0]) == pytest.approx(room.area * 0.059)
    assert all(np.isfinite(part.vertices).all() for part in built)
    assert sum(len(part.faces) for part in built if part.name == "floor") < 900


@pytest.mark.parametrize("name", sorted(FLOORS))
def test_a_floor_that_is_named_lies_there_whatever_the_seed(name: str) -> None:
    room = replace(RECTANGLE, floor=name)
    looks = {seed: {part.material for part in room_parts(room, seed=seed) if part.name == "floor"} for seed in (0, 1)}
    assert looks[0] == looks[1] and looks[0] & set(FLOORS[name].tones)


def test_a_floor_that_nobody_knows_is_left_to_the_seed() -> None:
    assert room_style(2, "lava") is room_style(2) is STYLES[2]


def test_curtains_hang_in_the_reveal_of_windows_whose_style_has_them() -> None:
    for style in (STYLES[0], STYLES[3]):
        cloth = [part for part in room_parts(RECTANGLE, style=style) if part.material == style.curtain]
        assert bool(cloth) == (style.curtain is not None)
        for part in cloth:
            wall = RECTANGLE.walls[RECTANGLE.windows[int(part.name.removeprefix("window-"))].wall]
            depths = (part.vertices[:, :2] - wall.start) @ wall.normal
            assert depths.max() < 0.0 and depths.min() > -SHELL.thickness
