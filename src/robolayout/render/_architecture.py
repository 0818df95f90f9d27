"""Walls, doors and windows of a plan, drawn the way architects do."""

from __future__ import annotations

import math
from collections.abc import Callable

import shapely

from robolayout.render._drawing import Drawing, Point
from robolayout.render._style import PLAN
from robolayout.render.palette import FLOOR, PAPER, QUIET, WALL
from robolayout.scene import Opening, Room, Wall

Place = Callable[[float, float], Point]


def placing(room: Room, k: float, left: float, top: float) -> Place:
    """Return where points of a room land: `k` millimetres to a metre, the corner of its bounds at (left, top)."""
    x0, _, _, y1 = room.bounds
    return lambda x, y: (left + (x - x0) * k, top + (y1 - y) * k)


def draw_floor(sheet: Drawing, room: Room, place: Place) -> None:
    """Draw the floor."""
    sheet.polygon([[place(x, y) for x, y in room.vertices]], FLOOR)


def draw_walls(sheet: Drawing, room: Room, place: Place) -> None:
    """Draw walls in solid section, doors with leaf and swing, windows with their panes."""
    inner = shapely.Polygon(room.vertices)
    solid = inner.buffer(PLAN.wall, join_style="mitre").difference(inner)
    gaps = [_gap(room, opening) for opening in (*room.doors, *room.windows)]
    solid = solid.difference(shapely.union_all(gaps)) if gaps else solid
    for piece in shapely.get_parts(solid):
        if piece.geom_type == "Polygon" and piece.area > 1e-6:
            rings = [piece.exterior, *piece.interiors]
            sheet.polygon([[place(x, y) for x, y in ring.coords[:-1]] for ring in rings], WALL)
    for window in room.windows:
        _draw_window(sheet, room, window, place)
    for door in room.doors:
        _draw_door(sheet, room, door, place)


def _gap(room: Room, opening: Opening) -> shapely.Polygon:
    """Return the hole that an opening leaves in its wall."""
    wall = room.walls[opening.wall]
    start, end, outer = opening.offset, opening.offset + opening.width, -2 * PLAN.wall
    corners = ((start, 0.01), (end, 0.01), (end, outer), (start, outer))
    return shapely.Polygon([wall.point(along, depth) for along, depth in corners])


def _draw_window(sheet: Drawing, room: Room, window: Opening, place: Place) -> None:
    """Draw the sill's two edges and the pane between them."""
    wall = room.walls[window.wall]
    start, end = window.offset, window.offset + window.width
    frame = [wall.point(s, d) for s, d in ((start, 0), (end, 0), (end, -PLAN.wall), (start, -PLAN.wall))]
    sheet.polygon([[place(*p) for p in frame]], PAPER, stroke=WALL, width=0.18)
    for depth in (0.42, 0.58):
        pane = (wall.point(start, -depth * PLAN.wall), wall.point(end, -depth * PLAN.wall))
        sheet.line([place(*p) for p in pane], WALL, width=0.13)


def _draw_door(sheet: Drawing, room: Room, door: Opening, place: Place) -> None:
    """Draw the threshold, the open leaf and its swing into the room; the hinge is nearer to the wall's end."""
    wall = room.walls[door.wall]
    start, end = door.offset, door.offset + door.width
    for depth in (0.0, -PLAN.wall):
        edge = [place(*wall.point(along, depth)) for along in (start, end)]
        sheet.line(edge, QUIET, width=0.1, dash=(0.6, 0.5))
    for hinge, sign, radius in _leaves(room, door):
        sheet.line([place(*p) for p in _swing(wall, hinge, sign, radius)], QUIET, width=0.13)
        leaf = [(hinge, 0), (hinge + sign * 0.04, 0), (hinge + sign * 0.04, radius), (hinge, radius)]
        sheet.polygon([[place(*wall.point(s, d)) for s, d in leaf]], PAPER, stroke=WALL, width=0.16)


def swings(room: Room) -> tuple[tuple[Point, ...], ...]:
    """Return the open leaf of each door and the arc of its edge as one line, metres."""
    return tuple(
        (room.walls[door.wall].point(hinge), *reversed(_swing(room.walls[door.wall], hinge, sign, radius)))
        for door in room.doors
        for hinge, sign, radius in _leaves(room, door)
    )


def _leaves(room: Room, door: Opening) -> list[tuple[float, int, float]]:
    """Return for each leaf of a door its hinge along the wall, which way it opens from there, and its width, metres."""
    start, end = door.offset, door.offset + door.width
    if door.width > 1.2:
        return [(start, 1, door.width / 2), (end, -1, door.width / 2)]
    at_start = door.offset < room.walls[door.wall].length - end
    return [(start, 1, door.width)] if at_start else [(end, -1, door.width)]


def _swing(wall: Wall, hinge: float, sign: int, radius: float) -> list[Point]:
    """Return the arc of a leaf's edge, from the wall to where it stands open, metres."""
    angles = [math.pi / 2 * k / 16 for k in range(17)]
    return [wall.point(hinge + sign * radius * math.cos(a), radius * math.sin(a)) for a in angles]
