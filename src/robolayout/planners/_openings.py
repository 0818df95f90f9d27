"""Doors and windows of a room that is made from words: those that are asked for, else what is usual."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence, Set
from dataclasses import dataclass, replace

import numpy as np

from robolayout.assets import Category
from robolayout.planners._room_size import depth_before_a_board
from robolayout.planners._wishes import RoomWishes
from robolayout.scene import Opening, Room
from robolayout.words import (
    AT_SIDES,
    COMPASS,
    NEARBY,
    Framed,
    Link,
    NamedThing,
    Place,
    Reading,
    ends_there,
    grammar,
    mentions,
    named,
    opposed,
    places,
    sides,
    walls_meant,
)


@dataclass(frozen=True)
class Openings:
    """How doors and windows are made."""

    aside: float = 0.3
    flanked: float = 1.8
    """Metres between a door and the nearer end of its wall: usually, and where things are to stand on both sides of it."""
    large: tuple[float, float] = (2.2, 1.5)
    usual: tuple[float, float] = (1.8, 1.3)
    """Width and height in metres of a large window and of a usual one."""
    window_each: float = 12.0
    door_each: float = 90.0
    """Square metres of floor for each window and door of a room of which neither is said: the usual one aside, so many more."""
    small: float = 10.0  # square metres of floor up to which one window is enough
    most_windows: int = 6
    most_doors: int = 2
    """How many windows and doors there are at the most where nothing is said."""
    lintel: float = 0.05  # metres at the least between the top of a door or window and the ceiling
    most_of_a_wall: float = 0.45  # share of its wall that one window takes at the most
    sill: float = 1.2  # metres from which height on what stands at a wall is high: no window is made behind it


OPENINGS = Openings()


ANY, UNTOLD = Place("wall"), Framed()
"""Any wall, and a door or window of which nothing more is said."""


@dataclass(frozen=True)
class Wanted:
    """Doors or windows that are asked for."""

    count: int  # how many
    wall: Place = ANY  # the walls that it may be in
    large: bool = False  # whether large ones are asked for
    framed: Framed = UNTOLD  # how wide, and where along their wall

    @property
    def told(self) -> bool:
        """Whether a wall is said."""
        return bool(self.wall.words or self.wall.by)


def with_openings(
    room: Room, wishes: RoomWishes, door: tuple[float, float], rng: np.random.Generator, *, varied: bool
) -> Room:
    """Return a room with doors near the ends of long walls (varied: somewhere in any wall), and windows in other walls.

    Where another wall can have it, no door is made at a wall or corner where things are to stand, and no window behind high ones.
    `door` is how many metres wide and high a door is.
    """
    wide, tall = door
    order = sorted(range(len(room.walls)), key=lambda i: -room.walls[i].length)
    usual = order[int(rng.integers(0, len(order) if varied else min(2, len(order))))]
    along = float(rng.random()) if varied else float(rng.random() < 0.5)
    asked = _wanted(wishes.reading, "door", 1 + int(room.area / OPENINGS.door_each), OPENINGS.most_doors)
    full, doors = _held(room, wishes, 0.0), list[Opening]()
    lit = {i for wanted in _wanted(wishes.reading, "window", 1, 1) if wanted.told for i in _meant(room, wanted.wall)}
    near = _near(room, wishes.reading)
    for number, item in enumerate(i for i in asked for _ in range(i.count)):
        fits = [i for i in order if room.walls[i].length > wide and i not in {d.wall for d in doors}] or order
        off = [full | lit | near, full | near, full]
        fits = next((free for taken in off if (free := [i for i in fits if i not in taken])), fits)
        start = fits.index(usual) if usual in fits and not number else 0
        wall = _wall(room, item.wall, fits[start:] + fits[:start])
        width = min(item.framed.width or wide, room.walls[wall].length)
        height = min(item.framed.height or tall, room.wall_height - OPENINGS.lintel)
        spare = room.walls[wall].length - width
        first = min(OPENINGS.flanked if wishes.reading.flanked_door else OPENINGS.aside, spare / 2)
        offset = first + (1.0 - _aside(room, wall, along, wishes, full)) * (spare - 2 * first)
        offset = offset if not item.framed.along else _along(room, wall, spare, item.framed)
        doors += _free_of(room, doors, Opening(wall, round(max(offset, 0.0), 2), width, height))
    more = max(1 + int(rng.integers(0, 2)), int(room.area / OPENINGS.window_each)) if room.area > OPENINGS.small else 1
    room, taken = replace(room, doors=tuple(doors)), {d.wall for d in doors}
    high = _held(room, wishes, OPENINGS.sill)
    taken |= high if len(taken | high) < len(order) else set[int]()
    lit_up = {m.thing.noun.kind for k in wishes.reading.parsed.links if places(k.objects, "window") for m in k.subjects}
    # no bed stands where another thing is by the window
    low = _held(room, wishes, 0.0, lit_up) if lit_up else set[int]()
    taken |= low if len(taken | low) < len(order) else set[int]()
    free = [i for i in order if i not in taken]
    asked, amid = _wanted(wishes.reading, "window", more, OPENINGS.most_windows), _amid(wishes.reading)
    if amid:
        free = [d.wall for d in doors] if "door" in amid else (_at_a_wall(room, wishes.reading) or free)[:1]
    return replace(room, windows=tuple(_windows(room, free, asked, rng, spread=bool(amid))))


def _wanted(reading: Reading, kind: str, usual: int, most: int) -> list[Wanted]:
    """Return the doors or windows that a text asks for, else as many as usual, as far as it speaks of "the" one or of several."""
    found = list[Wanted]()
    for place, span in (one for one in reading.parsed.openings if one[0].name == kind):
        walls = place.apart
        large = {"large", "big", "wide", "huge"} & set(reading.span(*span).lower().split())
        count = min(place.number or (2 if place.plural else 1), 8)
        for i, wall in enumerate(walls):  # "windows in the north and west walls"
            share = max(count * (i + 1) // len(walls) - count * i // len(walls), 1)
            found.append(Wanted(share * (place.number != 0), wall, bool(large), place.opening or UNTOLD))
    spots = [place for link in reading.parsed.links for place in places(link.objects)]
    objects = [*spots, *(place.by[1] for place in spots if place.by)]  # "the corner by the door"
    told = {(sides(o),): o for o in objects if o.name == kind and sides(o)}
    there = {word for wanted in found for word in wanted.wall.words}
    found += [Wanted(o.number or 1, o, framed=o.opening or UNTOLD) for o in told.values() if not {*sides(o)} & there]
    spoken = [o for o in objects if o.name == kind and not o.words]
    several = any(o.plural for o in spoken)
    if not found and any(o.det in ("each", "both", "all") for o in spoken):
        return [Wanted(2)]  # as many as the reader takes them for
    one = not several and any(o.det == "the" for o in spoken)
    return found or [Wanted(1 if one else min(max(usual, 1 + several), most))]


def _near(room: Room, reading: Reading) -> set[int]:
    """Return the walls that are not across from one that is told as the far one, and one that is told as the back one."""
    found = set[int]()
    for place in (place for link in reading.parsed.links for place in places(link.objects, "wall", "corner")):
        told = {*place.words} & {"far", "back", "rear"}
        there = [room.walls[i] for word in told for i in _meant(room, Place("wall", (word,)))]
        across = [w.index for w in room.walls if "far" in told and any(opposed(w.normal, one.normal) for one in there)]
        found |= {w.index for w in room.walls if w.index not in across} if across else {one.index for one in there}
    return found


def _amid(reading: Reading) -> set[str]:
    """Return what a thing is to stand between, if it is windows or a window and a door, which are then in one wall."""
    amid = [link.objects for link in reading.parsed.links if link.relation == "amid"]
    names = ([item.name if isinstance(item, Place) else "" for item in objects] for objects in amid)
    return next(({*found} for found in names if "window" in found and {*found} <= {"window", "door"}), set())


def _at_a_wall(room: Room, reading: Reading) -> list[int]:
    """Return the walls at which something is asked to be that is between windows: "a bed on the north wall between two windows"."""
    links = reading.parsed.links
    between = (link.subjects for link in links if link.relation == "amid" and places(link.objects, "window"))
    amid = {thing for subjects in between for thing in named(subjects)}
    return [wall for walls in _walls_told(room, reading, amid) for wall in walls]


def _walls_told(room: Room, reading: Reading, things: Set[NamedThing]) -> list[list[int]]:
    """Return the walls that are meant where one of some things is asked to be at a wall that is told."""
    about = (link for link in reading.parsed.links if things & named(link.subjects))
    return [_meant(room, at) for link in about for at in places(link.objects, "wall") if at.words]


def _placed(room: Room, wishes: RoomWishes, name: str) -> Iterator[tuple[list[list[int]], list[Category]]]:
    """Yield the walls that each word of a wall or corner means, and the kinds that are asked to stand there."""
    walls = grammar().walls
    for link in wishes.reading.parsed.links:
        there = [wishes.kinds[mention.thing.noun.kind] for mention in link.subjects]
        if name == "wall" and link.relation == "end":  # a screen at the head of a table
            yield [_meant(room, Place("wall", ("short",)))], there
        yield from _held_besides(room, wishes, link, there) if name == "wall" else ()
        for place in places(link.objects, name):
            known = {*COMPASS, "long", "short", "side"} if room.doors else {*COMPASS}
            words = {walls[word] for word in place.words if walls.get(word) in known}
            yield [_meant(room, Place("wall", (word,))) for word in words], there
            if room.doors and name == "wall" and place.by is not None and place.by[1].name == "door":
                yield [_meant(room, place)], there


def _held_besides(
    room: Room, wishes: RoomWishes, link: Link, there: list[Category]
) -> Iterator[tuple[list[list[int]], list[Category]]]:
    """Yield the walls that a link takes without naming them: the one opposite the door of a shop, a long one for what hangs there.

    That is a row of mirrors, hooks over a bench between two cabinets, a mirror over what is opposite the door, or a short
    wall for the board at which rows look that are deeper than the room is wide.
    """
    x0, y0, x1, y1 = room.bounds
    if room.doors and depth_before_a_board(wishes, link) > min(x1 - x0, y1 - y0):
        yield [_meant(room, Place("wall", ("short",)))[-1:]], [wishes.kinds["whiteboard"]]
    if not room.doors and any({"back", "rear"} & {*at.words} for at in places(link.objects, "side")):
        yield [_meant(room, Place("wall", ("back",)))], there
    sided = [at for at in places(link.objects, "side") if {"front", "back", "rear"} & {*at.words}]
    if room.doors and sided and all(kind.on_wall and not kind.on_floor for kind in there):  # "a board at the front"
        yield [_meant(room, replace(sided[0], name="wall"))], there
    mirrors = [wishes.kinds[m.thing.noun.kind] for m in mentions(link.objects) if m.thing.noun.kind == "mirror"]
    if mirrors and link.relation == "front" and sum(m.count for m in link.subjects) > 2:  # chairs, each before its own
        told = _walls_told(room, wishes.reading, named(link.subjects))
        yield told or [_meant(room, Place("wall", ("long",)))], mirrors
    ends, doors = mentions(link.objects), places(link.objects, "door")
    hung = [k for k in wishes.reading.parsed.links if k.relation == "above" and named(k.objects) & named(link.subjects)]
    if hung and link.relation == "amid" and ends and all(m.opens for m in ends):
        yield [_meant(room, Place("wall", ("long",)))], [wishes.kinds[m.thing.noun.kind] for m in ends]
    if hung and link.relation == "opposite" and doors and room.doors:
        # "a console opposite the door, a mirror above it"
        over = [wishes.kinds[m.thing.noun.kind] for k in hung for m in k.subjects]
        yield [_meant(room, Place("wall", by=("opposite", doors[0])))], over


def _held(room: Room, wishes: RoomWishes, least: float, but: Collection[str] = ()) -> set[int]:
    """Return the walls at which something but some kinds is asked to stand; with a height what is lower counts only if it hangs."""
    found = set[int]()
    for walls, kinds in _placed(room, wishes, "wall"):
        there = [kind for kind in kinds if kind.name not in but]
        if any((kind.on_floor and kind.size[2] >= least) or (least and kind.on_wall) for kind in there):
            found.update(*walls)
    return found


def _aside(room: Room, wall: int, along: float, wishes: RoomWishes, full: Set[int]) -> float:
    """Return where along a wall (1 at its start) a door is: at its other end, or in the middle, where its end is to be free.

    It is in the middle, too, where something is opposite to it at whose sides others stand, which have no room in a corner.
    """
    links = wishes.reading.parsed.links
    across = (link.subjects for link in links if link.relation == "opposite" and places(link.objects, "door"))
    middle = {thing for subjects in across for thing in named(subjects)}
    if any(middle & named(link.objects) for link in links if link.relation in AT_SIDES):
        return 0.5
    at = [k for k in links if k.relation in ("left", "right") and places(k.objects, "door")]
    stands = (m for k in at for m in k.subjects if m.thing.category.on_floor)
    wide = sum(m.count * wishes.kinds[wishes.kind(m.thing)].size[1] for m in stands)
    aside = {link.relation for link in at} if wide > OPENINGS.flanked else set[str]()
    if len(aside) == 1:  # most of the wall is on that side, seen from within
        return max(along, 1.0 - along) if aside == {"left"} else min(along, 1.0 - along)
    beside = ((wall - 1) % len(room.walls), (wall + 1) % len(room.walls))
    by_doors = {
        thing for k in links if k.relation in NEARBY and places(k.objects, "door") for thing in named(k.subjects)
    }
    told_walls = {wall for walls in _walls_told(room, wishes.reading, by_doors) for wall in walls}
    near = [to in told_walls for to in beside]
    if near[0] != near[1]:  # "a bookshelf on the left wall next to the door"
        return max(along, 1.0 - along) if near[0] else min(along, 1.0 - along)
    told = _placed(room, wishes, "corner")
    corners = ((walls, kinds) for walls, kinds in told if len(walls) == 2)
    # a printer, too, on what bears it
    meant = [walls for walls, kinds in corners if any({"floor", "object"} & {*kind.places} for kind in kinds)]
    start, end = (
        2 * any(all({wall, to} & {*walls} for walls in pair) for pair in meant) + (to in full) for to in beside
    )
    if start == end:
        return 0.5 if start > 1 else along
    return min(along, 1.0 - along) if start > end else max(along, 1.0 - along)


def _windows(
    room: Room, free: list[int], asked: Sequence[Wanted], rng: np.random.Generator, *, spread: bool
) -> Iterator[Opening]:
    """Yield the windows, in two of the free walls, which are outer ones, where no wall is said; `spread` with room beside them."""
    outer = (free[: int(rng.integers(1, 3))] if len(asked) == 1 and not asked[0].told else free) or [0]
    by_wall: dict[int, list[Wanted]] = {}
    for turn, wanted in enumerate(i for i in asked for _ in range(i.count)):
        by_wall.setdefault(_wall(room, wanted.wall, outer[turn % len(outer) :] + outer), []).append(wanted)
    for wall, items in by_wall.items():
        begin, end = _stretch(room, wall)
        share = (end - begin) / len(items)
        middle = float(rng.choice([0.35, 0.5, 0.65])) if len(items) == 1 and not items[0].told else 0.5
        middle = (0.9 if begin else 0.1) if spread and len(items) == 1 else middle
        for number, item in enumerate(items):
            width, height = OPENINGS.large if item.large else OPENINGS.usual
            sill = min(0.9, max(room.wall_height - height - OPENINGS.lintel, 0.0))
            height = round(min(height, room.wall_height - sill - OPENINGS.lintel), 2)
            width = min(width, share * (OPENINGS.most_of_a_wall if len(items) == 1 or spread else 0.7))
            width = round(min(item.framed.width or width, share), 2)
            height = min(item.framed.height or height, room.wall_height - sill - OPENINGS.lintel)
            first = begin + number * share + (share - width) * middle
            if item.framed.along:
                told = _along(room, wall, room.walls[wall].length - width, item.framed)
                first = min(max(told, begin + number * share), begin + (number + 1) * share - width)
            yield Opening(wall, round(first, 2), width, height, sill)


def _free_of(room: Room, doors: Sequence[Opening], door: Opening) -> list[Opening]:
    """Return a door where it is, or where on its wall it is beside the others; none where there is no room for it."""
    others = [one for one in doors if one.wall == door.wall]
    spare = room.walls[door.wall].length - door.width
    places = (door.offset, *(round(max(spare * share, 0.0), 2) for share in (0.1, 0.9, 0.5)))
    free = (at for at in places if all(at + door.width <= o.offset or o.offset + o.width <= at for o in others))
    return [replace(door, offset=at) for at in free][:1]


def _along(room: Room, wall: int, spare: float, told: Framed) -> float:
    """Return how many metres from the start of its wall something is told to be, which leaves so many metres of it."""
    if told.along == "middle":
        return spare / 2
    off = min(told.off, spare) if told.off else min(OPENINGS.aside, spare / 2)
    return spare - off if ends_there(room.walls[wall], told.along) else off


def _stretch(room: Room, wall: int) -> tuple[float, float]:
    """Return the ends of the longest part of a wall in which no door is."""
    doors = sorted(
        (d.offset - OPENINGS.aside, d.offset + d.width + OPENINGS.aside) for d in room.doors if d.wall == wall
    )
    ends = [0.0, *(end for door in doors for end in door), room.walls[wall].length]
    return max(zip(ends[::2], ends[1::2], strict=True), key=lambda part: part[1] - part[0])


def _wall(room: Room, place: Place, order: Sequence[int]) -> int:
    """Return the first of some walls that a place may mean; the first of all that it means where none of them is one."""
    meant = _meant(room, place)
    return next((i for i in order if i in meant), meant[0])


def _meant(room: Room, place: Place) -> list[int]:
    """Return the walls that a place means."""
    return [wall.index for wall in walls_meant(room, place)]
