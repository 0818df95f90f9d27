"""Which walls, corners, doors and windows of a room words mean."""

from __future__ import annotations

import math

from robolayout.constraints.corner import convex_corners
from robolayout.scene import Opening, Room, Wall
from robolayout.words._chunk import Framed
from robolayout.words._lexicon import grammar
from robolayout.words._said import Place, sides

COMPASS = {"north": (0.0, -1.0), "south": (0.0, 1.0), "east": (-1.0, 0.0), "west": (1.0, 0.0)}
"""Inward normals of walls by name, as on a plan: north is up."""

SAME = 0.05
"""Metres by which walls that count as equally long may differ."""

FRAME, AMID, BY_AN_END = 0.02, 0.2, 1.0
"""Metres by which a door or window may be wider than is told, and off where it is told to be; and those between it and an end of its
wall that it is by."""


def walls_meant(room: Room, place: Place) -> list[Wall]:
    """Return the walls that the words may mean, all walls where nothing tells them apart."""
    walls: list[Wall] = []
    for one in place.apart:
        meant = list(room.walls)
        for word in sorted(one.words, key=lambda word: grammar().walls.get(word, "") not in COMPASS):
            meant = _told(meant, grammar().walls.get(word, word), room) or meant
        walls += [wall for wall in meant if wall not in walls]
    if place.by is None or place.by[1].name not in ("door", "window"):
        return walls
    how, by = place.by
    if how == "with":
        return _told(walls, by.name, room) or walls
    own = _told(list(room.walls), by.name, room)
    return [wall for wall in walls if any(across(wall, other) for other in own)] or walls


def _told(walls: list[Wall], word: str, room: Room) -> list[Wall]:
    """Return the walls of which an adjective is true, or that have an opening: "the window wall"."""
    if word in ("window", "door"):
        return [wall for wall in walls if wall.index in {opening.wall for opening in openings(room, word)}]
    if word in ("windowless", "doorless"):
        holes = room.windows if word == "windowless" else room.doors
        return [wall for wall in walls if wall.index not in {opening.wall for opening in holes}]
    if word in ("long", "short"):
        wanted = (max if word == "long" else min)(wall.length for wall in room.walls)
        return [wall for wall in walls if abs(wall.length - wanted) <= SAME]
    if word == "side":
        return [wall for wall in walls if abs(wall.normal[0]) > math.sqrt(0.5)]
    if word in COMPASS:
        nx, ny = COMPASS[word]
        return [wall for wall in walls if wall.normal[0] * nx + wall.normal[1] * ny > math.sqrt(0.5)]
    return []


def across(one: Wall, two: Wall) -> bool:
    """Return whether two walls face each other."""
    return opposed(one.normal, two.normal)


def opposed(one: tuple[float, float], two: tuple[float, float]) -> bool:
    """Return whether two unit vectors point more against than across each other."""
    return one[0] * two[0] + one[1] * two[1] < -math.sqrt(0.5)


def meet(one: Wall, two: Wall) -> bool:
    """Return whether two walls meet in a corner."""
    return one is not two and not {one.start, one.end}.isdisjoint((two.start, two.end))


def corner_of(one: Wall, two: Wall) -> int:
    """Return the vertex in which two walls meet."""
    return two.index if two.start == one.end else one.index


def corners_meant(room: Room, place: Place) -> list[int]:
    """Return the corners that the words mean, all where nothing tells them apart."""
    x, y = centre(room)
    normals = [COMPASS[wall] for word in place.words if (wall := grammar().walls.get(word, "")) in COMPASS]
    found, at = list(convex_corners(room)), room.vertices
    meant = [i for i in found if all((at[i][0] - x) * nx + (at[i][1] - y) * ny < 0 for nx, ny in normals)] or found
    if place.by is None:
        return meant
    how, by = place.by
    middles = [room.walls[opening.wall].point(opening.center) for opening in openings(room, by.name)]
    away = {i: min((math.dist(at[i], middle) for middle in middles), default=0.0) for i in meant}
    several = place.det == "each" or place.plural or how == "across"  # "in each corner opposite the door"
    return sorted(away, key=lambda i: away[i], reverse=how != "near")[: 1 + several]


def centre(room: Room) -> tuple[float, float]:
    """Return the middle of the room's bounds in metres."""
    x0, y0, x1, y1 = room.bounds
    return (round((x0 + x1) / 2, 3), round((y0 + y1) / 2, 3))


def openings_meant(room: Room, place: Place) -> tuple[Opening, ...]:
    """Return the doors or windows that words mean, all where nothing tells them apart."""
    found, walls = openings(room, place.name), walls_meant(room, Place("wall", sides(place)))
    return tuple(opening for opening in found if opening.wall in {wall.index for wall in walls}) or found


def ends_there(wall: Wall, word: str) -> bool:
    """Return whether a word for an end of a wall, as one faces it from within or by the compass, means its end, not its start."""
    if word in COMPASS:
        (dx, dy), (nx, ny) = wall.direction, COMPASS[word]
        return dx * nx + dy * ny < 0
    return word == "left"


def is_framed(room: Room, opening: Opening, told: Framed) -> bool:
    """Return whether a door or window is as wide and high as is told, and where along its wall."""
    wall = room.walls[opening.wall]
    before, after = opening.offset, wall.length - opening.offset - opening.width
    sizes = ((opening.width, told.width), (opening.height, told.height))
    if any(wanted and abs(own - wanted) > FRAME for own, wanted in sizes):
        return False
    if not told.along:
        return True
    if told.along == "middle":
        return abs(before - after) <= 2 * AMID
    near, far = (after, before) if ends_there(wall, told.along) else (before, after)
    return abs(near - told.off) <= AMID if told.off else near <= min(far, BY_AN_END)


def openings(room: Room, kind: str) -> tuple[Opening, ...]:
    """Return the doors or the windows of a room."""
    return room.doors if kind == "door" else room.windows
