"""What the offline planner knows about rooms, read from the records of things (`assets/data/things/`).

Each file is one functional group and lists roles beside its records: where such a thing stands by itself (`stands`), what it
joins if that is there (`joins`), what it prefers (`prefer`), and which statements follow (`say`); a record names the role that
it plays. The meaning of every key is written in docs/planner.md.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache, cached_property
from importlib.resources import files
from pathlib import Path
from typing import Any

from robolayout._errors import InputError, SceneError, among
from robolayout._reading import Checker
from robolayout._reading.syntax import toml_value
from robolayout.assets import CATALOGUE, Category, find_category
from robolayout.assets.category import BUILT_IN, HEADS, PLACES, SIDES
from robolayout.assets.lexicon import place_of
from robolayout.constraints import RELATIONS
from robolayout.planners._shapes import build, table, tables
from robolayout.scene import Asset, agent_names
from robolayout.words.rooms import RoomType

DATA: Mapping[str, Any] = tomllib.loads((files("robolayout.planners") / "knowledge" / "_slots.toml").read_text("utf-8"))
"""What is said by how things stand, by what roles prefer, and what stands for what."""
SLOTS: Mapping[str, str] = DATA["words"]  # ways of standing at something else, in words
STANDS = tuple(slot for slot in DATA["slots"] if slot not in SLOTS)  # ways of standing by itself
GROUP_KEYS = ("label", "order", "why")  # what the head of a file says
TOP_KEYS = (*HEADS, *GROUP_KEYS, "thing", "rooms")
"""What a file may hold at its top, beside records; `label`, `order`, `why` and `thing` are the older form."""
OWN = "own things"  # label of the group of a file that names none
MAX_BYTES = 1_000_000  # largest knowledge file in bytes; the built-in ones have at most 12,000
MOST = 200  # things of one kind that a room type may have
_CHECK = Checker(SceneError)


@dataclass(frozen=True)
class Join:
    """How a role stands at another thing."""

    slot: str  # one of `SLOTS`
    of: tuple[str, ...]  # roles of the thing it joins, best first
    most: int = 99  # how many may join one such thing
    gap: float = 0.05  # metres between the two boxes
    # where in the slot ("back", "middle", "front", "hand" (the right one, at a desk) of a top; "left", "right" of a
    # plate)
    at: str = ""
    faces: str = ""  # "anchor", "same" or "away"
    say: tuple[str, ...] = ()  # statements for each one
    pair: tuple[str, ...] = ()  # statements for two that flank the same thing
    all: tuple[str, ...] = ()  # statements for all that join the same thing together
    loose: bool = False  # whether it may stand by itself if there is no room for it there
    gather: bool = False  # whether they stand together on one thing rather than one on each

    @property
    def on_top(self) -> bool:
        """Whether it stands on the other thing."""
        return self.slot in ("on", "setting")


ALONE, ON_ANY = Join("", ()), Join("on", ("*",), say=("on_top_of({a}, {b})",))
"""How what joins nothing stands, and what can stand nowhere but on some thing."""


@dataclass(frozen=True)
class Face:
    """What a role should have in front of it."""

    roles: tuple[str, ...]  # roles of the thing it faces, best first
    how: str = "toward"  # "toward" (its front looks there) or "away" (its back looks there)
    distance: tuple[float, float] = (0.0, 20.0)  # lowest and highest distance of centres in metres
    weight: float = 2.0  # how much it matters
    say: tuple[str, ...] = ()  # statements that follow once it is placed so


@dataclass(frozen=True)
class Role:
    """What a kind of asset is for in a room."""

    name: str  # name of the role ("bed")
    group: str  # label of its functional group ("sleeping")
    rank: int  # when it is placed; low first
    names: tuple[str, ...] = ()  # what plays it: the categories whose records say so, and other words for things
    words: tuple[str, ...] = ()  # words in an asset's category that also give it this role
    stands: tuple[str, ...] = ("wall",)  # ways of standing by itself, best first
    joins: tuple[Join, ...] = ()  # ways of joining something else, tried first
    # weights: centre, corner, door, window, middle, tuck, alone
    prefer: Mapping[str, float] = field(default_factory=dict[str, float])
    # metres kept free on some sides ({"front": 1.2}); sides not named follow the category
    clear: Mapping[str, float] = field(default_factory=dict[str, float])
    face: Face = Face(())  # what it has in front of it
    height: float = 0.0  # height in metres of the centre of a hung asset; 0 lets size decide
    rim: float = 0.0  # height in metres of its upper edge instead, of what may also stand: a basin, a toilet
    above: tuple[str, ...] = ()  # roles over which a hung asset is centred
    # statements by way of standing
    say: Mapping[str, tuple[str, ...]] = field(default_factory=dict[str, tuple[str, ...]])
    top: bool = False  # whether small things may stand on it

    @property
    def in_a_ring(self) -> bool:
        """Whether several of it stand in a ring where they are asked onto a rug."""
        return self.name.endswith((*DATA["nouns"]["in_a_ring"],))

    def hung(self, height: float) -> float:
        """Return how high in metres the centre of a hung thing is that is so high itself; 0 lets its size decide."""
        return max(self.rim - height / 2, height / 2) if self.rim else self.height

    def stands_beside(self, role: str, slot: str = "beside") -> bool:
        """Return whether it usually stands beside a thing of some role, or at another side of it."""
        return any(join.slot == slot and role in join.of for join in self.joins)


@dataclass(frozen=True)
class Head:
    """The head of a file: its group, the place of that group, structural first, and why things stand as they do."""

    label: str
    order: int = 50
    why: str = ""


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


class Knowledge:
    """All roles and groups; those of the user's own take the place of built-in ones of the same name."""

    def __init__(self) -> None:
        self.roles: dict[str, Role] = {}
        self.groups: dict[str, Head] = {}
        self.things: dict[str, Category] = {}  # categories of the user's own
        self.rooms: dict[str, RoomType] = {}  # room types of the user's own
        self._files: dict[tuple[str, str], str] = {}  # which of the user's own files says what

    @cached_property
    def playing(self) -> Mapping[str, Role]:
        """Roles by the names of what plays them."""
        return {name: role for role in self.roles.values() for name in role.names}

    @cached_property
    def by_word(self) -> Mapping[str, Role]:
        """Roles by the words that name what plays them, also at the end of a longer name."""
        return {word: role for role in self.roles.values() for word in role.words}

    def recognised(self, asset: Asset) -> Category | None:
        """Return which of the user's own categories an asset is, if any."""
        own, words = tuple(self.things.values()), asset.description
        found = find_category(asset.category, description=words, size=asset.size, place=place_of(asset), own=own)
        return found if found in own else None

    def cast(self, thing: Category) -> None:
        """Let a thing play the role that its record names."""
        if thing.role:
            among(f"role of {thing.name!r}:", [thing.role], self.roles)
            role = self.roles[thing.role]
            self.roles[thing.role] = replace(role, names=(*role.names, thing.name))

    def add(self, data: Mapping[str, Any], file: str = "") -> None:
        """Read one file, by its name where it is one of the user's own."""
        records = {key: value for key, value in data.items() if key not in TOP_KEYS and isinstance(value, Mapping)}
        among("key", [key for key in data if key not in records], TOP_KEYS)
        head = data.get("group") or ({"label": OWN} if data else {}) | {
            key: data[key] for key in GROUP_KEYS if key in data
        }
        group = build(Head, head, "its group" if "group" in data else "its top")
        self.groups[group.label] = group
        roles = [_role(entry, group) for entry in _named(data.get("role", []), "role")]
        self.roles |= {role.name: role for role in roles}
        entries = [*_named(data.get("thing", []), "thing"), *_named(records, "thing")]
        things = [_thing(entry, group.label) for entry in entries]
        for thing in things:
            self.things[thing.name] = thing
            self.cast(thing)
        given = table(data.get("rooms", {}), 'rooms (such as [rooms."music room"])')
        rooms = [_room(name, entry, self.things) for name, entry in given.items()]
        self.rooms |= {room.name: room for room in rooms}
        for kind, said in (("role", roles), ("thing", things), ("room type", rooms)) if file else ():
            for entry in said:
                if (other := self._files.setdefault((kind, entry.name), file)) != file:
                    raise SceneError(f"the {kind} {entry.name!r} is in {other} too; rename one, or leave one file out.")


def load_knowledge(extra: Iterable[Path] = ()) -> Knowledge:
    """Read the built-in files and then `extra` ones, whose names replace built-in ones but not each other's."""
    return _parse(tuple((str(path), _CHECK.read_text(path, "the knowledge file", MAX_BYTES)) for path in extra))


def usual_say(slot: str) -> tuple[str, ...]:
    """Return what is said of a thing by its slot at another, where its role says nothing else."""
    return tuple(DATA["slots"][slot]["say"])


@cache
def _parse(texts: tuple[tuple[str, str], ...]) -> Knowledge:
    found = Knowledge()
    for data in BUILT_IN.values():
        if "group" in data:
            found.add({key: data[key] for key in HEADS if key in data})
    for category in CATALOGUE.values():
        found.cast(category)
    for name, text in texts:
        data = _CHECK.parse(toml_value, text, f"the knowledge file {name}")
        try:
            found.add(data, name)
        except InputError as error:
            raise SceneError(f"the knowledge file {name}: {error}") from None
    for role in found.roles.values():
        _check(role, found.roles)
    return found


def _named(entries: object, where: str) -> list[dict[str, Any]]:
    """Return tables that say their names, from such ("[[role]]") or from a table of tables ("[role.bed]")."""
    if isinstance(entries, Mapping):
        named = zip(entries, tables([*entries.values()], where), strict=True)
        return [{"name": name, **entry} for name, entry in named]
    return tables(entries, where)


def _role(entry: dict[str, Any], group: Head) -> Role:
    where = f"the role {entry.get('name', 'without a name')!r}"
    usual = {mode: usual_say(mode) for mode in STANDS}
    fixed: dict[str, Any] = {
        "group": group.label,
        "rank": entry.get("rank", group.order),
        "joins": tuple(_join(item, where) for item in tables(entry.get("joins", []), f"{where}: joins")),
        "face": build(Face, entry.get("face", {"roles": ()}), f"{where}: face"),
        "say": usual | table(entry.get("say", {}), f"{where}: say"),
    }
    role = build(Role, {**entry, **fixed}, where)
    among(f"way of standing in {where}:", role.stands, STANDS)
    return role


def _join(item: dict[str, Any], where: str) -> Join:
    among(f"slot in {where}:", [str(item.get("slot", ""))], SLOTS)
    return build(Join, {**DATA["slots"][item["slot"]], **item}, f"{where}: joins")


def _check(role: Role, roles: Mapping[str, Role]) -> None:
    """Refuse a role that names unknown roles or statements."""
    where = f"the role {role.name!r}"
    wanted = [name for join in role.joins for name in join.of if name != "*"] + [*role.above]
    wanted += [key.split(" ", 1)[1] for key in role.prefer if key.startswith(("near ", "far "))]
    among(f"role in {where}:", [*wanted, *role.face.roles], roles)
    lines = [line for said in role.say.values() for line in said] + [*role.face.say]
    lines += [line for join in role.joins for line in (*join.say, *join.pair, *join.all)]
    for line in lines:
        text = line.removeprefix("else ")
        among(f"statement in {where}:", [text.split("(")[0]], RELATIONS)
        among(f"placeholder in {where}:", re.findall(r"\{(.*?)\}", text), DATA["placeholders"])
        if not text.endswith(")") or re.search(r"[{}]", re.sub(r"\{[\w ]+\}", "", text)):
            raise SceneError(f"{where} says {line!r}; write it as a call, such as 'next_to({{a}}, {{b}})'.")


def _thing(entry: Mapping[str, object], group: str) -> Category:
    """Return one record of a file, with its name, as a category of a group."""
    where = f"the thing {entry.get('name', 'without a name')!r}"
    thing = build(_Thing, entry, where)
    among(f"category in {where}: like", [thing.like], CATALOGUE)
    among(f"place in {where}:", thing.place, PLACES)
    among(f"side in {where}:", thing.use_sides, SIDES)
    if "size" in entry and not all(0.0 < side <= 100.0 for side in thing.size):
        raise SceneError(f"{where}: size is {list(thing.size)}; depth, width and height are metres, from 0 to 100.")
    given: dict[str, Any] = {key: getattr(thing, key) for key in ("size", "use_sides") if key in entry}
    given |= {f"on_{place}": place in thing.place for place in PLACES} if "place" in entry else {}
    own = {"name": thing.name, "like": thing.like, "role": thing.role, "parts": thing.parts, "group": group}
    found = replace(CATALOGUE[thing.like], synonyms=(*thing.synonyms, *thing.words), **own, **given)
    if thing.parts:
        from robolayout.assets.rows import check_rows

        check_rows(thing.parts, where, found.size)
    return found


def _room(name: str, entry: object, things: Mapping[str, Category]) -> RoomType:
    where = f"the room {name!r}"
    usual = {"base": dict[str, int](), "extras": dict[str, int](), "words": [name]}
    room = build(RoomType, {**usual, **table(entry, where), "name": name}, where)
    known = {*CATALOGUE, *things}
    among(f"category in {where}:", [*room.base, *room.extras, *room.person], known)
    among(f"table in {where}:", filter(None, [room.tables]), known)
    among(f"body in {where}:", filter(None, [room.agent]), agent_names())
    if not all(1.0 <= side <= 100.0 for side in room.size):
        raise SceneError(f"{where}: size is {list(room.size)}; width and depth are metres, from 1 to 100.")
    for thing, count in (*room.base.items(), *room.extras.items(), *room.person.items()):
        if not 0 <= count <= MOST:
            raise SceneError(f"{where}: it has {count:.3g} of {thing!r}; a room holds from 0 to {MOST} of a kind.")
    return room
