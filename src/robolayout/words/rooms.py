"""Room types as data: what belongs in a bedroom, an office, a shop."""

from __future__ import annotations

import math
import tomllib
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from importlib.resources import files

LISTS = ("words", "size", "floors", "zones", "telling")
"""Fields of a room type that are lists in the file."""

SHARED, OBLONG = 0.85, 1.35
"""Share of the floors of two rooms that one has which is both, and by how much it is longer than wide."""


@dataclass(frozen=True)
class RoomType:
    """One kind of room."""

    name: str  # its name ("bedroom")
    words: tuple[str, ...]  # words that name it in a sentence
    size: tuple[float, float]  # usual width and depth in metres
    base: Mapping[str, int]  # what always belongs in, with counts
    extras: Mapping[str, int]  # what may be added
    person: Mapping[str, int] = field(default_factory=dict[str, int])  # what each person brings along
    zones: tuple[Mapping[str, int], ...] = ()  # what a large room has besides, one group after the other
    of: str = ""  # the wider room type that it is counted as
    telling: tuple[str, ...] = ()  # things each of which says that such a room is meant where none is named
    by_name: bool = False  # whether only its name and what tells of it mean it, not what else is usual in it
    people: int = 0  # how many people there are if nobody says
    couple: bool = False  # whether two adults need nothing besides what always belongs in
    tables: str = ""  # the table that the chairs of this room stand at, if they need one
    agent: str | None = None  # the body that such a room is usually for
    height: float = 2.6  # usual wall height in metres
    floors: tuple[str, ...] = ("oak planks", "walnut planks", "pale ash planks")  # what may lie on the floor

    @property
    def at_table(self) -> int:
        """How many sit at each of its tables."""
        return 2 if self.tables == "round table" else 4

    def sharing(self, other: RoomType) -> RoomType:
        """Return it with what another room has, on one floor: an open plan kitchen and living room."""
        own = bool(self.person) and not self.people  # who sleeps there is nobody more than those who eat there
        brought = {name: count * other.people for name, count in other.person.items() if own}
        base = Counter(self.base) + Counter(other.base) + Counter(brought)
        extras = Counter(self.extras) | Counter(other.extras)
        area = SHARED * (math.prod(self.size) + math.prod(other.size))
        return replace(
            self,
            size=(math.sqrt(area * OBLONG), math.sqrt(area / OBLONG)),
            base=base,
            extras={name: count for name, count in extras.items() if name not in base},
            person={**self.person, **({} if own else other.person)},
            zones=(*self.zones, *other.zones),
            people=0 if own else max(self.people, other.people),
            tables=self.tables or other.tables,
        )


@dataclass(frozen=True)
class RoomTypes:
    """Everything in `rooms.toml`."""

    rooms: Mapping[str, RoomType]  # room types by name
    agents: Mapping[str, str]  # names of bodies by the words that mean them
    companions: Mapping[str, Mapping[str, int]]  # what a thing is of no use without


def read_rooms(own: Iterable[RoomType] = ()) -> RoomTypes:
    """Read the built-in room types, and let a user's own replace those of the same name."""
    built_in = _built_in()
    return replace(built_in, rooms={**built_in.rooms, **{room.name: room for room in own}})


@cache
def _built_in() -> RoomTypes:
    text = (files("robolayout.words") / "rooms.toml").read_text("utf-8")
    data = tomllib.loads(text)
    rooms = {
        name: RoomType(name, **(entry | {key: tuple(entry[key]) for key in LISTS if key in entry}))
        for name, entry in data["rooms"].items()
    }
    bodies = {word: body for body, words in data["agents"].items() for word in words}
    return RoomTypes(rooms, bodies, data["companions"])
