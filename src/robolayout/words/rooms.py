"""Room types as data: what belongs in a bedroom, an office, a shop."""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from importlib.resources import files

LISTS = ("words", "size", "floors", "zones")
"""Fields of a room type that are lists in the file."""


@dataclass(frozen=True)
class RoomType:
    """One kind of room.

    Attributes:
        name: Its name ("bedroom").
        words: Words that name it in a sentence.
        size: Usual width and depth in metres.
        base: What always belongs in, with counts.
        extras: What may be added.
        person: What each person brings along.
        zones: What a large room has besides, one group after the other.
        people: How many people there are if nobody says.
        couple: Whether two adults need nothing besides what always belongs in.
        tables: The table that the chairs of this room stand at, if they need one.
        agent: The body that such a room is usually for.
        height: Usual wall height in metres.
        floors: What may lie on the floor.
    """

    name: str
    words: tuple[str, ...]
    size: tuple[float, float]
    base: Mapping[str, int]
    extras: Mapping[str, int]
    person: Mapping[str, int] = field(default_factory=dict[str, int])
    zones: tuple[Mapping[str, int], ...] = ()
    people: int = 0
    couple: bool = False
    tables: str = ""
    agent: str | None = None
    height: float = 2.6
    floors: tuple[str, ...] = ("oak planks", "walnut planks", "pale ash planks")


@dataclass(frozen=True)
class Rooms:
    """Everything in `rooms.toml`.

    Attributes:
        rooms: Room types by name.
        corners: What a "reading corner" and the like consist of.
        agents: Names of bodies by the words that mean them.
        companions: What a thing is of no use without.
    """

    rooms: Mapping[str, RoomType]
    corners: Mapping[str, Mapping[str, int]]
    agents: Mapping[str, str]
    companions: Mapping[str, Mapping[str, int]]


def read_rooms(own: Iterable[RoomType] = ()) -> Rooms:
    """Read the built-in room types, and let a user's own replace those of the same name."""
    built_in = _built_in()
    return replace(built_in, rooms={**built_in.rooms, **{room.name: room for room in own}})


@cache
def _built_in() -> Rooms:
    text = (files("robolayout.words") / "rooms.toml").read_text("utf-8")
    data = tomllib.loads(text)
    rooms = {
        name: RoomType(name, **(entry | {key: tuple(entry[key]) for key in LISTS if key in entry}))
        for name, entry in data["rooms"].items()
    }
    return Rooms(rooms, data["corners"], data["agents"], data["companions"])
