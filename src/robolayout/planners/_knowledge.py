"""What the offline planner knows about rooms, read from the files in `knowledge/`.

Each file is one functional group and lists roles: which categories play the role, where such a thing stands by itself
(`stands`), what it joins if that is there (`joins`), what it prefers (`prefer`), and which statements follow (`say`). The
meaning of every key is written in docs/planner.md.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from robolayout._errors import InputError, SceneError
from robolayout.assets import Category, find_category
from robolayout.assets.lexicon import place_of
from robolayout.constraints import RELATIONS
from robolayout.planners._own import own_rooms, own_things
from robolayout.planners._shapes import among, build, tables
from robolayout.scene import Asset
from robolayout.words.rooms import RoomType

SLOTS = ("beside", "front", "flank", "opposite", "behind", "around", "on", "setting", "near")
"""Ways of standing at something else."""
STANDS = ("wall", "corner", "middle", "facing", "grid", "hang", "ceiling", "rug")
"""Ways of standing by itself."""
TOP_KEYS = ("label", "order", "why", "role", "thing", "rooms", "slots")
"""What a file may hold at its top."""
_VALUES = (
    "a, a2, b, wall, bwall, side, gap, least, most, near, far, angle, height, seat, straight, vertex, depth, items, "
    "ahead low, ahead high"
)
PLACEHOLDERS = frozenset(_VALUES.split(", "))
"""What a statement may name in braces."""


@dataclass(frozen=True)
class Join:
    """How a role stands at another thing.

    Attributes:
        slot: One of `SLOTS`.
        of: Roles of the thing it joins, best first.
        most: How many may join one such thing.
        gap: Metres between the two boxes.
        at: Where in the slot ("back", "middle", "front", "hand" (the right one, at a desk) of a top; "left", "right" of a plate).
        faces: "anchor", "same" or "away".
        say: Statements for each one.
        pair: Statements for two that flank the same thing.
        all: Statements for all that join the same thing together.
        loose: Whether it may stand by itself if there is no room for it there.
        gather: Whether they stand together on one thing rather than one on each.
    """

    slot: str
    of: tuple[str, ...]
    most: int = 99
    gap: float = 0.05
    at: str = ""
    faces: str = ""
    say: tuple[str, ...] = ()
    pair: tuple[str, ...] = ()
    all: tuple[str, ...] = ()
    loose: bool = False
    gather: bool = False


@dataclass(frozen=True)
class Face:
    """What a role should have in front of it.

    Attributes:
        roles: Roles of the thing it faces, best first.
        how: "toward" (its front looks there) or "away" (its back looks there).
        distance: Lowest and highest distance of centres in metres.
        weight: How much it matters.
        say: Statements that follow once it is placed so.
    """

    roles: tuple[str, ...]
    how: str = "toward"
    distance: tuple[float, float] = (0.0, 20.0)
    weight: float = 2.0
    say: tuple[str, ...] = ()


@dataclass(frozen=True)
class Role:
    """What a kind of asset is for in a room.

    Attributes:
        name: Name of the role ("bed").
        group: Label of its functional group ("sleeping").
        order: Place of the group, structural first.
        rank: When it is placed; low first.
        names: Categories that play it.
        words: Words in an asset's category that also give it this role.
        stands: Ways of standing by itself, best first.
        joins: Ways of joining something else, tried first.
        prefer: Weights: centre, corner, door, window, middle, tuck, alone.
        clear: Metres kept free on some sides ({"front": 1.2}); sides not named follow the category.
        face: What it has in front of it.
        height: Height in metres of the centre of a hung asset; 0 lets size decide.
        above: Roles over which a hung asset is centred.
        say: Statements by way of standing.
        top: Whether small things may stand on it.
    """

    name: str
    group: str
    order: int
    rank: int
    names: tuple[str, ...] = ()
    words: tuple[str, ...] = ()
    stands: tuple[str, ...] = ("wall",)
    joins: tuple[Join, ...] = ()
    prefer: Mapping[str, float] = field(default_factory=dict[str, float])
    clear: Mapping[str, float] = field(default_factory=dict[str, float])
    face: Face | None = None
    height: float = 0.0
    above: tuple[str, ...] = ()
    say: Mapping[str, tuple[str, ...]] = field(default_factory=dict[str, tuple[str, ...]])
    top: bool = False


@dataclass(frozen=True)
class Knowledge:
    """All roles, with the sentence of each group.

    Attributes:
        roles: Roles by name.
        reasons: Rationale by group label.
        orders: Place by group label.
        things: Categories of the user's own.
        rooms: Room types of the user's own.
    """

    roles: Mapping[str, Role]
    reasons: Mapping[str, str]
    orders: Mapping[str, int]
    things: tuple[Category, ...] = ()
    rooms: tuple[RoomType, ...] = ()

    def recognised(self, asset: Asset) -> Category | None:
        """Return which of the user's own categories an asset is, if any."""
        if not self.things:
            return None
        found = find_category(
            asset.category, description=asset.description, size=asset.size, place=place_of(asset), own=self.things
        )
        return found if found in self.things else None


@dataclass(frozen=True)
class _Group:
    """The head of a file: the name of its group, its place among them, and why things stand as they do."""

    label: str
    order: int = 50
    why: str = ""


def load_knowledge(extra: Iterable[Path] = ()) -> Knowledge:
    """Read the built-in files and then `extra` ones, whose roles replace built-in roles of the same name.

    Raises:
        SceneError: A file is missing, broken, or says what cannot be.
    """
    return _parse((*_built_in(), *((str(path), _read(path)) for path in extra)))


def _read(path: Path) -> str:
    try:
        return path.read_text("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = error.strerror if isinstance(error, OSError) else "it is no UTF-8 text"
        raise SceneError(f"the knowledge file {path} cannot be read ({reason}); name a TOML file.") from None


@cache
def _built_in() -> tuple[tuple[str, str], ...]:
    folder = files("robolayout.planners") / "knowledge"
    found = sorted((item for item in folder.iterdir() if item.name.endswith(".toml")), key=lambda item: item.name)
    return tuple((item.name, item.read_text("utf-8")) for item in found if item.name != "_rooms.toml")


@cache
def _parse(texts: tuple[tuple[str, str], ...]) -> Knowledge:
    reading = _Reading()
    for name, text in texts:
        try:
            reading.add(tomllib.loads(text))
        except tomllib.TOMLDecodeError as error:
            raise SceneError(f"the knowledge file {name} is not TOML: {error}. Correct it or leave it out.") from None
        except InputError as error:
            raise SceneError(f"the knowledge file {name}: {error}") from None
    return reading.knowledge()


class _Reading:
    """Collects what one file after the other says; later ones replace earlier ones."""

    def __init__(self) -> None:
        self.roles: dict[str, Role] = {}
        self.groups: dict[str, _Group] = {}
        self.things: dict[str, Category] = {}
        self.rooms: dict[str, RoomType] = {}
        self.slots: dict[str, Any] = {}

    def add(self, data: Mapping[str, Any]) -> None:
        """Read one file."""
        among("key", data, TOP_KEYS)
        self.slots.update(data.get("slots", {}))
        if set(data) == {"slots"}:
            return
        group = build(_Group, {key: data[key] for key in ("label", "order", "why") if key in data}, "its top")
        self.groups[group.label] = group
        found = [_role(entry, group, self.slots) for entry in tables(data.get("role", []), "role")]
        self.roles |= {role.name: role for role in found}
        self.things |= {thing.name: thing for thing in own_things(data.get("thing", []), group.label)}
        self.rooms |= {room.name: room for room in own_rooms(data.get("rooms", {}), self.things)}

    def knowledge(self) -> Knowledge:
        """Return everything that was read, once its roles are known to fit together."""
        for role in self.roles.values():
            _check(role, self.roles)
        reasons = {label: group.why for label, group in self.groups.items()}
        orders = {label: group.order for label, group in self.groups.items()}
        return Knowledge(self.roles, reasons, orders, tuple(self.things.values()), tuple(self.rooms.values()))


def _role(entry: dict[str, Any], group: _Group, slots: Mapping[str, Any]) -> Role:
    where = f"the role {entry.get('name', 'without a name')!r}"
    stands = entry.get("stands", ["wall"])
    said = {mode: tuple(slots.get(mode, {}).get("say", ())) for mode in STANDS} | entry.get("say", {})
    fixed: dict[str, Any] = {
        "group": group.label,
        "order": group.order,
        "rank": entry.get("rank", group.order),
        "stands": stands,
        "joins": tuple(_join(item, where, slots) for item in tables(entry.get("joins", []), f"{where}: joins")),
        "face": build(Face, entry["face"], f"{where}: face") if "face" in entry else None,
        "say": said,
    }
    role = build(Role, {**entry, **fixed}, where)
    among(f"way of standing in {where}:", role.stands, STANDS)
    return role


def _join(item: dict[str, Any], where: str, slots: Mapping[str, Any]) -> Join:
    among(f"slot in {where}:", [str(item.get("slot", ""))], SLOTS)
    return build(Join, {**slots.get(item["slot"], {}), **item}, f"{where}: joins")


def _check(role: Role, roles: Mapping[str, Role]) -> None:
    """Refuse a role that names unknown roles or statements."""
    where = f"the role {role.name!r}"
    wanted = [name for join in role.joins for name in join.of if name != "*"] + [*role.above]
    wanted += [key.split(" ", 1)[1] for key in role.prefer if key.startswith(("near ", "far "))]
    among(f"role in {where}:", [*wanted, *(role.face.roles if role.face else ())], roles)
    lines = [line for said in role.say.values() for line in said] + list(role.face.say if role.face else ())
    lines += [line for join in role.joins for line in (*join.say, *join.pair, *join.all)]
    for line in lines:
        text = line.removeprefix("else ")
        among(f"statement in {where}:", [text.split("(")[0]], RELATIONS)
        among(f"placeholder in {where}:", re.findall(r"\{(.*?)\}", text), PLACEHOLDERS)
        if not text.endswith(")") or re.search(r"[{}]", re.sub(r"\{[\w ]+\}", "", text)):
            raise SceneError(f"{where} says {line!r}; write it as a call, such as 'next_to({{a}}, {{b}})'.")
