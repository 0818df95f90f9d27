"""Which place of the room is meant: the long wall, the north one, the one opposite the door, a corner, a half."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.constraints import PointRef
from robolayout.constraints.corner import convex_corners
from robolayout.scene import Scene, Wall
from robolayout.words._lexicon import grammar
from robolayout.words._said import Place

COMPASS = {"north": (0.0, -1.0), "south": (0.0, 1.0), "east": (-1.0, 0.0), "west": (1.0, 0.0)}
"""Inward normals of walls by name, as on a plan: north is up."""

SAME = 0.05
"""Metres by which walls that count as equally long may differ."""


def walls_meant(scene: Scene, place: Place) -> list[Wall]:
    """Return the walls that the words may mean, all walls where nothing tells them apart."""
    walls: list[Wall] = []
    for words in " ".join(place.words).split(" and "):
        meant = list(scene.room.walls)
        for word in words.split():
            meant = _told(meant, grammar().walls.get(word, ""), scene) or meant
        walls += [wall for wall in meant if wall not in walls]
    if place.by is not None:
        walls = _by_opening(scene, walls, *place.by) or walls
    return walls


def _told(walls: list[Wall], word: str, scene: Scene) -> list[Wall]:
    """Return the walls of which an adjective is true."""
    if word in ("long", "short"):
        lengths = [wall.length for wall in scene.room.walls]
        wanted = max(lengths) if word == "long" else min(lengths)
        return [wall for wall in walls if abs(wall.length - wanted) <= SAME]
    if word in COMPASS:
        nx, ny = COMPASS[word]
        return [wall for wall in walls if wall.normal[0] * nx + wall.normal[1] * ny > math.sqrt(0.5)]
    return []


def _by_opening(scene: Scene, walls: list[Wall], how: str, by: Place) -> list[Wall]:
    """Return the walls that a door or window tells: its own, or the one that it looks at."""
    if by.name not in ("door", "window"):
        return []
    openings = scene.room.doors if by.name == "door" else scene.room.windows
    own = {opening.wall for opening in openings}
    if how == "with":
        return [wall for wall in walls if wall.index in own]
    return [wall for wall in walls if any(_across(wall, scene.room.walls[index]) for index in own)]


def wall_pairs(scene: Scene, *, same: bool) -> list[tuple[Wall, Wall]]:
    """Return each wall twice, or each two walls that face each other, in both orders."""
    pairs = [(one, two) for one in scene.room.walls for two in scene.room.walls]
    return [(one, two) for one, two in pairs if (one is two if same else _across(one, two))]


def _across(one: Wall, two: Wall) -> bool:
    return one.normal[0] * two.normal[0] + one.normal[1] * two.normal[1] < -math.sqrt(0.5)


def corners_meant(scene: Scene, place: Place) -> list[int]:
    """Return the corners that the words mean, all where nothing tells them apart."""
    x, y = centre(scene)
    normals = [COMPASS[wall] for word in place.words if (wall := grammar().walls.get(word, "")) in COMPASS]
    found = list(convex_corners(scene.room))
    meant = [
        i
        for i in found
        for vx, vy in [scene.room.vertices[i]]
        if all((vx - x) * nx + (vy - y) * ny < 0 for nx, ny in normals)
    ]
    if place.by is not None:
        how, by = place.by
        walls, openings = scene.room.walls, scene.room.doors if by.name == "door" else scene.room.windows
        away = {
            i: min((math.dist(scene.room.vertices[i], walls[o.wall].point(o.center)) for o in openings), default=0.0)
            for i in meant or found
        }
        return [(min if how == "near" else max)(away, key=lambda i: away[i])]
    return meant or found


def halves_meant(scene: Scene, place: Place) -> Iterator[tuple[PointRef, ...]]:
    """Yield the half of the room that the words name, as seen on the plan."""
    x0, y0, x1, y1 = scene.room.bounds
    x, y = (x0 + x1) / 2, (y0 + y1) / 2
    back = (x0, y, x1, y1)
    halves = {"left": (x0, y0, x, y1), "right": (x, y0, x1, y1), "back": back, "rear": back, "front": (x0, y0, x1, y)}
    if scene.room.doors:  # what is across the room from who comes in
        nx, ny = scene.room.walls[scene.room.doors[0].wall].normal
        halves["far"] = halves[("left", "right")[nx > 0] if abs(nx) > abs(ny) else ("front", "back")[ny > 0]]
    ends = ("left", "right") if x1 - x0 >= y1 - y0 else ("front", "back")
    told = (ends[place.det == "other"],) if place.det in ("one", "other") or place.number == 1 else ()
    for word in place.words or told:
        if word in halves:
            yield rectangle(*halves[word])


def rectangle(x0: float, y0: float, x1: float, y1: float) -> tuple[PointRef, ...]:
    """Return the corners of a rectangle as points of the floor."""
    corners = ((x0, y0), (x1, y0), (x1, y1), (x0, y1))
    return tuple(PointRef(round(x, 3), round(y, 3)) for x, y in corners)


def centre(scene: Scene) -> tuple[float, float]:
    """Return the middle of the room's bounds in metres."""
    x0, y0, x1, y1 = scene.room.bounds
    return (round((x0 + x1) / 2, 3), round((y0 + y1) / 2, 3))
