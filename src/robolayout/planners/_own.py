"""What a user's own file adds to the catalogue: kinds of things, each like a built-in one, and room types."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from robolayout._errors import SceneError
from robolayout.assets import CATALOGUE, Category
from robolayout.assets.category import PLACES, SIDES
from robolayout.planners._shapes import among, build, table
from robolayout.scene import agent_names
from robolayout.words.rooms import RoomType

MOST = 200  # things of one kind that a room type may have
OWN = "your own file"  # where the size of an own category comes from


@dataclass(frozen=True)
class _Thing:
    """One record of an own file; what it does not say is as in the category that it is like."""

    name: str
    like: str
    role: str = ""
    parts: str = ""
    synonyms: tuple[str, ...] = ()
    words: tuple[str, ...] = ()
    size: tuple[float, float, float] = (0.0, 0.0, 0.0)
    place: tuple[str, ...] = ()
    use_sides: tuple[str, ...] = ()


def own_thing(entry: Mapping[str, object], group: str) -> Category:
    """Return one record of a file, with its name, as a category of a group."""
    where = f"the thing {entry.get('name', 'without a name')!r}"
    thing = build(_Thing, entry, where)
    among(f"category in {where}: like", [thing.like], CATALOGUE)
    among(f"place in {where}:", thing.place, PLACES)
    among(f"side in {where}:", thing.use_sides, SIDES)
    if "size" in entry and not all(0.0 < side <= 100.0 for side in thing.size):
        raise SceneError(f"{where}: size is {list(thing.size)}; depth, width and height are metres, from 0 to 100.")
    given: dict[str, Any] = {key: getattr(thing, key) for key in ("size", "use_sides") if key in entry}
    given |= {"source": OWN} if "size" in entry else {}
    given |= {f"on_{place}": place in thing.place for place in PLACES} if "place" in entry else {}
    own = {"name": thing.name, "like": thing.like, "role": thing.role, "parts": thing.parts, "group": group}
    found = replace(CATALOGUE[thing.like], synonyms=(*thing.synonyms, *thing.words), **own, **given)
    if thing.parts:
        from robolayout.assets.rows import check_rows

        check_rows(thing.parts, where, found.size)
    return found


def own_sides(category: Category) -> tuple[str, ...] | None:
    """Return the sides from which one of the user's own things is used, where they differ from what it is like."""
    return None if category.use_sides == CATALOGUE[category.like].use_sides else category.use_sides


def own_rooms(entries: object, things: Mapping[str, Category]) -> tuple[RoomType, ...]:
    """Return the room types of a file from its `[rooms.NAME]` tables; they may name the user's own things."""
    given = table(entries, 'rooms (such as [rooms."music room"])')
    return tuple(_room(name, table(entry, f"the room {name!r}"), things) for name, entry in given.items())


def _room(name: str, entry: Mapping[str, object], things: Mapping[str, Category]) -> RoomType:
    where = f"the room {name!r}"
    empty: dict[str, int] = {}
    room = build(RoomType, {"base": empty, "extras": empty, "words": [name], **entry, "name": name}, where)
    known = {*CATALOGUE, *things}
    among(f"category in {where}:", [*room.base, *room.extras, *room.person], known)
    among(f"table in {where}:", [room.tables] if room.tables else [], known)
    among(f"body in {where}:", [room.agent] if room.agent else [], agent_names())
    if not all(1.0 <= side <= 100.0 for side in room.size):
        raise SceneError(f"{where}: size is {list(room.size)}; width and depth are metres, from 1 to 100.")
    for name, count in (*room.base.items(), *room.extras.items(), *room.person.items()):
        if not 0 <= count <= MOST:
            raise SceneError(f"{where}: it has {count:.3g} of {name!r}; a room holds from 0 to {MOST} of a kind.")
    return room
