"""Which room type a text means: as named, else the nearest one, else the one that most of the things belong in."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce

from robolayout._errors import SceneError
from robolayout.assets import CATALOGUE
from robolayout.planners._knowledge import DATA
from robolayout.scene import FLAT_HEIGHT
from robolayout.words import AREAS, Reading, RoomType, RoomTypes

LACKING, LIKELY, TELLING = 0.6, 0.9, 6.0
"""What a room loses by each thing that it always has and that is not named, and what makes it likely, in things that belong there."""

LIKE: Mapping[str, str] = DATA["like"]
SLEPT_ON: tuple[str, ...] = tuple(DATA["nouns"]["slept_on"])


def room_meant(reading: Reading, rooms: RoomTypes) -> tuple[RoomType, list[str]]:
    """Return the room type: as named, else the nearest one, else the one that most of the things belong in."""
    if reading.room is not None and not (reading.guessed and reading.room == "room"):
        guess = [f"{reading.room_words!r} is no room type that is known: {reading.room} was taken."]
        room = reduce(RoomType.sharing, (rooms.rooms[name] for name in (reading.room, *reading.joined)))
        return room, guess if reading.guessed else []
    areas = (chunk.value for chunk in reading.parsed.facts if chunk.kind == "corner")
    kinds = {thing.noun.kind for thing in reading.parsed.things}.union(*(AREAS.get(area, ()) for area in areas))
    usual = {kind for room in rooms.rooms.values() if room.of != "bedroom" for kind in room.base}
    kinds |= {like for like, last in LIKE.items() if any(kind.endswith(last) for kind in kinds - usual - {"pet bed"})}
    if not kinds and not reading.parsed.facts:
        known = ", ".join(sorted(rooms.rooms))
        raise SceneError(f"the sentence names no room; known room types: {known}; words are read in English.")
    likely = {name: room for name, room in rooms.rooms.items() if not room.by_name or kinds & {*room.telling}}
    likely = _slept_in(likely, kinds) if not kinds.isdisjoint(SLEPT_ON) else likely
    scores = {name: _belongs(kinds, room) for name, room in likely.items()}
    best = max(scores, key=lambda name: (scores[name], name == "room"))
    best = best if scores[best] >= LIKELY else "room"
    best = "children's room" if reading.young and best in ("room", "office", "dining room") else best
    named = f"{reading.room_words!r} is no room type that is known" if reading.guessed else "No room was named"
    return rooms.rooms[best], [f"{named}: {best} was taken."]


def _slept_in(rooms: Mapping[str, RoomType], kinds: set[str]) -> dict[str, RoomType]:
    """Return the rooms in which somebody sleeps; a home of one room only where one lives or cooks there, too."""
    lived = {*rooms["studio"].base, *rooms["kitchen"].base} - {*rooms["bedroom"].base, "desk", "office chair", "chair"}
    found = {name: room for name, room in rooms.items() if {*SLEPT_ON} & {*room.base, *room.person}}
    return {name: room for name, room in found.items() if lived & kinds or name != "studio"}


def _belongs(kinds: set[str], room: RoomType) -> float:
    """Return how many of some kinds belong in a room; what always stands there counts double, and lacks where it is missing.

    What tells of such a room counts more than anything that it lacks.
    """
    if not kinds & {*room.base, *room.person, *room.telling} - {"chair"}:
        return 0.0
    found = len(kinds & room.base.keys()) + len(kinds & {*room.base, *room.extras, *room.person})
    missing = (CATALOGUE.get(name) for name in room.base.keys() - kinds)
    # lights, rugs and what hangs or stands on others say little
    slight = [k for k in missing if k and (k.size[2] < FLAT_HEIGHT or not k.on_floor)]
    told = TELLING * len(kinds & {*room.telling})
    return told + found - LACKING * (len(room.base.keys() - kinds) - len(slight))
