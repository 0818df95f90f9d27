"""Which part of the room words mean: a half of it as seen on the plan, or by who looks at a wall."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.constraints import PointRef
from robolayout.constraints.corner import convex_corners
from robolayout.scene import Room, Wall
from robolayout.words._said import Place


def halves_meant(room: Room, place: Place) -> Iterator[tuple[PointRef, ...]]:
    """Yield the half of the room that words name, as seen on the plan; of two what these share ("back left"), else each of them."""
    x0, y0, x1, y1 = room.bounds
    halves = _halves(room)
    if room.doors:  # what is across the room from who comes in
        x, y = room.walls[room.doors[0].wall].normal
        ways = {"far": (x, y), "doorward": (-x, -y), "portside": (-y, x), "starboard": (y, -x)}
        halves |= {name: halves[_towards(way)] for name, way in ways.items()}
    ends = ("left", "right") if x1 - x0 >= y1 - y0 else ("front", "back")
    told = (ends[place.det == "other"],) if place.det in ("one", "other") or place.number == 1 else ()
    end = ("far",) if "end" in place.words else ()  # "a nurse's desk at the end"
    if "arm" in place.words:  # of an L-shaped room
        yield from (rectangle(*arm) for arm in _arms(room)["lesser" in place.words :][:1])
        return
    found = [halves[word] for word in [w for w in place.words if w != "end"] or told or end if word in halves]
    if found:
        left, bottom, right, top = zip(*found, strict=True)
        x0, y0, x1, y1 = max(left), max(bottom), min(right), min(top)
        yield from (rectangle(*half) for half in ([(x0, y0, x1, y1)] if x0 < x1 and y0 < y1 else found))


def half_aside(room: Room, wall: Wall, side: str) -> tuple[PointRef, ...]:
    """Return the "left" or the "right" half of the room of who looks at a wall, or what is at their "back"."""
    nx, ny = wall.normal
    ways = {"left": (ny, -nx), "right": (-ny, nx), "back": (nx, ny)}
    return rectangle(*_halves(room)[_towards(ways[side])])


def half_at(room: Room, wall: Wall) -> tuple[PointRef, ...]:
    """Return the half of the room along a wall."""
    nx, ny = wall.normal
    return rectangle(*_halves(room)[_towards((-nx, -ny))])


def _halves(room: Room) -> dict[str, tuple[float, float, float, float]]:
    """Return the halves of the room's bounds by their names on the plan, on which north is up."""
    x0, y0, x1, y1 = room.bounds
    x, y = (x0 + x1) / 2, (y0 + y1) / 2
    back = (x0, y, x1, y1)
    halves = {"left": (x0, y0, x, y1), "right": (x, y0, x1, y1), "back": back, "rear": back, "front": (x0, y0, x1, y)}
    ways = {"north": "back", "south": "front", "west": "left", "east": "right"}
    return halves | {name + end: halves[half] for name, half in ways.items() for end in ("", "ern")}


def _arms(room: Room) -> tuple[tuple[float, float, float, float], ...]:
    """Return the long arm of an L-shaped room and what is left of the other one; nothing for other rooms."""
    x0, y0, x1, y1 = room.bounds
    corners = [(x, y) for x in (x0, x1) for y in (y0, y1)]
    convex = convex_corners(room)
    missing = [at for at in corners if at not in room.vertices]
    inner = [at for i, at in enumerate(room.vertices) if i not in convex]
    if len(missing) != 1 or len(inner) != 1:
        return ()
    ((mx, my),), ((x, y),) = missing, inner
    left, right = sorted((x, x0 + x1 - mx))
    low, high = sorted((y, y0 + y1 - my))
    across, along = (x0, low, x1, high), (left, y0, right, y1)
    rest = (left, min(y, my), right, max(y, my)), (min(x, mx), low, max(x, mx), high)
    return (across, rest[0]) if x1 - x0 >= y1 - y0 else (along, rest[1])


def _towards(way: tuple[float, float]) -> str:
    """Return the name of the half in a direction on the plan."""
    x, y = way
    return ("left", "right")[x > 0] if abs(x) > abs(y) else ("front", "back")[y > 0]


def rectangle(x0: float, y0: float, x1: float, y1: float) -> tuple[PointRef, ...]:
    """Return the corners of a rectangle as points of the floor."""
    return tuple(floor_point(corner) for corner in ((x0, y0), (x1, y0), (x1, y1), (x0, y1)))


def floor_point(at: tuple[float, float]) -> PointRef:
    """Return a point of the floor to the millimetre."""
    return PointRef(round(at[0], 3), round(at[1], 3))
