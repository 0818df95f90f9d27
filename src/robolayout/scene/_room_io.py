"""Reads and writes the room of a scene file: corners, wall height, doors and windows."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from itertools import combinations
from numbers import Integral
from typing import Any

from robolayout._errors import SceneError
from robolayout._reading import LIMITS, Checker, misspelt
from robolayout.scene.room import OPENINGS, ROUNDING, Opening, Point, Room, Wall

PLACE = ("wall", "offset", "width", "height")  # what a file always says of a door or window
LEAF = ("hinge", "swing", "open")  # what a door may say of its leaf
_HANGS = {"hinge": ("left", "right"), "swing": ("in", "out")}

_CHECK = Checker(SceneError)


def read_room(data: Mapping[str, object], warnings: list[str]) -> Room:
    """Return the room of a scene file; a clockwise one is turned around, with a warning."""
    boundary = _CHECK.inner(data, "boundary", "the scene", "boundary")
    vertices = _vertices(_CHECK.required(boundary, "floor_vertices", "boundary"))
    given = _CHECK.required(boundary, "wall_height", "boundary")
    height = _CHECK.number(given, "boundary.wall_height", above=0.0, most=100.0)
    room = Room(vertices, height, floor=_CHECK.text(boundary.get("floor", ""), "boundary.floor", most=40))
    _check_shape(room)
    _check_units(room, warnings)
    named = {key: _openings(data, key, room, warnings) for key in ("doors", "windows")}
    for (name_a, a), (name_b, b) in combinations([*named["doors"].items(), *named["windows"].items()], 2):
        along = min(a.offset + a.width, b.offset + b.width) - max(a.offset, b.offset)
        upwards = min(a.sill + a.height, b.sill + b.height) - max(a.sill, b.sill)
        if a.wall == b.wall and along > ROUNDING and upwards > ROUNDING:
            raise SceneError(f"{name_a} and {name_b} overlap by {along:.3f} m on wall {a.wall}; move one of them.")
    room = replace(room, **{key: tuple(found.values()) for key, found in named.items()})
    if room.area > 0:
        return room
    warnings.append("the room's corners ran clockwise and were turned around; doors and windows stay where they were.")
    return _turned(room)


def write_room(room: Room) -> dict[str, object]:
    """Return the keys "boundary", "doors" and "windows" of a scene file."""
    return {
        "boundary": {"floor_vertices": [[x, y, 0.0] for x, y in room.vertices], "wall_height": room.wall_height}
        | ({"floor": room.floor} if room.floor else {}),
        "doors": [
            {key: getattr(d, key) for key in PLACE}
            | {key: value for key in ("sill", *LEAF) if (value := getattr(d, key)) != getattr(Opening, key)}
            for d in room.doors
        ],
        "windows": [{key: getattr(w, key) for key in (*PLACE, "sill")} for w in room.windows],
    }


def _vertices(value: object) -> tuple[Point, ...]:
    corners: list[Point] = []
    for i, entry in enumerate(_CHECK.sequence(value, "boundary.floor_vertices", most=LIMITS.corners)):
        where = f"boundary.floor_vertices[{i}]"
        point = _CHECK.numbers(entry, where, (2, 3))
        if any(abs(number) > LIMITS.length for number in point):
            raise SceneError(f"{where} lies more than {LIMITS.length:g} m from the origin; coordinates are in metres.")
        if len(point) == 3 and abs(point[2]) > ROUNDING:
            raise SceneError(f"{where} has height {point[2]:g}; the floor lies at z = 0.")
        corners.append((point[0], point[1]))
    if len(corners) > 1 and math.dist(corners[0], corners[-1]) < ROUNDING:
        corners.pop()
    if len(corners) < 3:
        raise SceneError(f"boundary.floor_vertices has {len(corners)} different corners; a room needs at least 3.")
    return tuple(corners)


def _check_shape(room: Room) -> None:
    for wall in room.walls:
        if wall.length < ROUNDING:
            following = (wall.index + 1) % len(room.walls)
            raise SceneError(f"boundary.floor_vertices {wall.index} and {following} are the same point; drop one.")
    first = max(room.walls, key=lambda wall: wall.length)
    if all(abs(first.place(corner)[1]) < ROUNDING for corner in room.vertices):
        raise SceneError("the room has no area: all its corners lie on one line.")
    for a, b in combinations(room.walls, 2):
        if _touching(a, b, room):
            raise SceneError(
                f"the room's walls {a.index} and {b.index} cross or touch; list the corners in order around the room."
            )
    if abs(room.area) < LIMITS.least_area:
        raise SceneError(
            f"the room's area is {abs(room.area):.4f} m2; at least {LIMITS.least_area} m2 are needed (in metres)."
        )


def _check_units(room: Room, warnings: list[str]) -> None:
    """Ask about a room that is so large that it was perhaps drawn in centimetres."""
    low_x, low_y, high_x, high_y = room.bounds
    width, depth = high_x - low_x, high_y - low_y
    if max(width, depth) <= LIMITS.room_asked:
        return
    asks = (
        f"the room is {width:g} x {depth:g} m: was it drawn in centimetres? Lengths are in metres; "
        f"divide them by 100 for one of {width / 100:g} x {depth / 100:g} m"
    )
    if max(width, depth) > LIMITS.room_side:
        raise SceneError(f"{asks}. At most {LIMITS.room_side:g} m are read.")
    warnings.append(f"{asks}, or leave them if it is that large.")


def _touching(a: Wall, b: Wall, room: Room) -> bool:
    """Return whether two walls cross or touch elsewhere than at the corner they share."""
    count = len(room.walls)
    if b.index - a.index == 1:
        return a.distance(b.end) < ROUNDING or b.distance(a.start) < ROUNDING
    if (b.index + 1) % count == a.index:
        return a.distance(b.start) < ROUNDING or b.distance(a.end) < ROUNDING
    ends = [a.distance(b.start), a.distance(b.end), b.distance(a.start), b.distance(a.end)]
    crossing = all((p.place(q.start)[1] > 0) != (p.place(q.end)[1] > 0) for p, q in ((a, b), (b, a)))
    return crossing or min(ends) < ROUNDING


def _openings(data: Mapping[str, object], key: str, room: Room, warnings: list[str]) -> dict[str, Opening]:
    entries = enumerate(_CHECK.sequence(data.get(key, []), key, most=LIMITS.openings))
    return {(where := f"{key}[{i}]"): _opening(entry, where, room, warnings) for i, entry in entries}


def _opening(value: object, where: str, room: Room, warnings: list[str]) -> Opening:
    data = _CHECK.mapping(value, where)
    warnings += misspelt(data, (*PLACE, "sill", *LEAF), where)
    index, count = _CHECK.required(data, "wall", where), len(room.walls)
    if isinstance(index, bool) or not isinstance(index, Integral) or not 0 <= int(index) < count:
        raise SceneError(f"{where}.wall must be a whole number from 0 to {count - 1}, but is {index!r:.60}.")
    index = int(index)
    window = where.startswith("windows")
    offset = _CHECK.number(_CHECK.required(data, "offset", where), f"{where}.offset", least=-ROUNDING)
    width = _CHECK.number(_CHECK.required(data, "width", where), f"{where}.width", above=0.0)
    usual = (OPENINGS.window_height, OPENINGS.window_sill) if window else (OPENINGS.door_height, 0.0)
    height = _CHECK.number(data.get("height", usual[0]), f"{where}.height", above=0.0, most=100.0)
    sill = _CHECK.number(data.get("sill", usual[1]), f"{where}.sill", least=0.0, most=100.0)
    length = room.walls[index].length
    if offset + width > length + ROUNDING:
        raise SceneError(
            f"{where} ends at {offset + width:.3f} m, past the end of wall {index}, which is {length:.3f} m long."
        )
    if sill + height > room.wall_height + ROUNDING:
        above = f"{where} ends {sill + height:.3f} m above the floor; the walls are {room.wall_height:g} m high"
        if room.wall_height - sill < OPENINGS.least_height:
            raise SceneError(f"{above}: lower its sill, which is at {sill:g} m, or raise boundary.wall_height.")
        height = room.wall_height - sill
        warnings.append(f"{above}, so it was made {height:.3g} m high.")
    return Opening(index, max(offset, 0.0), width, height, sill, **({} if window else _leaf(data, where)))


def _leaf(data: Mapping[str, object], where: str) -> dict[str, Any]:
    """Return how a door's leaf hangs, where that is said."""
    leaf: dict[str, Any] = {key: data[key] for key in LEAF if key in data}
    for key in _HANGS.keys() & leaf.keys():
        if leaf[key] not in _HANGS[key]:
            raise SceneError(f"{where}.{key} must be {' or '.join(map(repr, _HANGS[key]))}, but is {leaf[key]!r:.60}.")
    if "open" in leaf:
        leaf["open"] = _CHECK.flag(leaf["open"], f"{where}.open")
    return leaf


def _turned(room: Room) -> Room:
    """Return the same room with its corners in the other direction; vertex 0 stays, wall i becomes wall n - 1 - i."""
    count = len(room.vertices)

    def moved(opening: Opening) -> Opening:
        length = room.walls[opening.wall].length
        offset = max(length - opening.offset - opening.width, 0.0)
        return replace(opening, wall=count - 1 - opening.wall, offset=offset)

    vertices = (room.vertices[0], *reversed(room.vertices[1:]))
    return replace(
        room, vertices=vertices, doors=tuple(map(moved, room.doors)), windows=tuple(map(moved, room.windows))
    )
