"""What the offline planner knows about rooms, read from the files in `knowledge/`.

Each file is one functional group and lists roles: which categories play the role, where such a thing stands by itself
(`stands`), what it joins if that is there (`joins`), what it prefers (`prefer`), and which statements follow (`say`). The
meaning of every key is written in docs/planner.md.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any, TypeVar

from robolayout._errors import SceneError, UnknownNameError

SLOTS = ("beside", "front", "flank", "opposite", "behind", "around", "on", "setting", "near")
"""Ways of standing at something else."""
STANDS = ("wall", "corner", "middle", "facing", "grid", "hang", "ceiling", "rug")
"""Ways of standing by itself."""


@dataclass(frozen=True)
class Join:
    """How a role stands at another thing.

    Attributes:
        slot: One of `SLOTS`.
        of: Roles of the thing it joins, best first.
        most: How many may join one such thing.
        gap: Metres between the two boxes.
        at: Where in the slot ("back", "middle", "front" of a top; "left", "right" of a plate).
        faces: "anchor", "same" or "away".
        say: Statements for each one.
        pair: Statements for two that flank the same thing.
        all: Statements for all that join the same thing together.
        loose: Whether it may stand by itself if there is no room for it there.
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
    """

    roles: Mapping[str, Role]
    reasons: Mapping[str, str]
    orders: Mapping[str, int]


def load_knowledge(extra: Iterable[Path] = ()) -> Knowledge:
    """Read the built-in files and then `extra` ones, whose roles replace built-in roles of the same name."""
    texts = [(path.name, path.read_text("utf-8")) for path in extra]
    return _parse((*_built_in(), *texts))


@cache
def _built_in() -> tuple[tuple[str, str], ...]:
    folder = files("robolayout.planners") / "knowledge"
    found = sorted((item for item in folder.iterdir() if item.name.endswith(".toml")), key=lambda item: item.name)
    return tuple((item.name, item.read_text("utf-8")) for item in found)


@cache
def _parse(texts: tuple[tuple[str, str], ...]) -> Knowledge:
    roles: dict[str, Role] = {}
    reasons: dict[str, str] = {}
    orders: dict[str, int] = {}
    defaults: dict[str, Any] = {}
    for name, text in texts:
        try:
            data = tomllib.loads(text)
        except tomllib.TOMLDecodeError as error:
            raise SceneError(f"the knowledge file {name} is not TOML: {error}. Correct it or leave it out.") from None
        defaults.update(data.get("slots", {}))
        if "label" not in data:
            continue
        label, order = str(data["label"]), int(data.get("order", 50))
        reasons[label], orders[label] = str(data.get("why", "")), order
        for entry in data.get("role", []):
            role = _role(dict(entry), label, order, defaults)
            roles[role.name] = role
    return Knowledge(roles, reasons, orders)


def _role(entry: dict[str, Any], label: str, order: int, defaults: Mapping[str, Any]) -> Role:
    name = str(entry.get("name", "without a name"))
    joins = tuple(_join(dict(item), name, defaults) for item in entry.pop("joins", ()))
    face = entry.pop("face", None)
    stands = tuple(entry.pop("stands", ("wall",)))
    for mode in stands:
        if mode not in STANDS:
            raise UnknownNameError("way of standing", str(mode), STANDS)
    said = {mode: tuple(defaults.get(mode, {}).get("say", ())) for mode in STANDS}
    said |= {mode: tuple(lines) for mode, lines in entry.pop("say", {}).items()}
    rank = int(entry.pop("rank", order))
    facing = _build(Face, dict(face), name) if face else None
    fixed = {
        "group": label,
        "order": order,
        "rank": rank,
        "stands": stands,
        "joins": joins,
        "face": facing,
        "say": said,
    }
    return _build(Role, {**entry, **fixed}, name)


def _join(item: dict[str, Any], role: str, defaults: Mapping[str, Any]) -> Join:
    slot = str(item.get("slot", ""))
    if slot not in SLOTS:
        raise UnknownNameError("slot", slot, SLOTS)
    return _build(Join, {**defaults.get(slot, {}), **item}, role)


Kind = TypeVar("Kind", Role, Join, Face)


def _build(kind: type[Kind], entry: dict[str, Any], role: str) -> Kind:
    """Return an entry as its class; lists become tuples, unknown keys are refused with the known ones."""
    known = {field.name for field in fields(kind)}
    for key in entry:
        if key not in known:
            raise UnknownNameError(f"key in the role {role!r}", key, known)
    values: dict[str, Any] = {key: tuple(item) if isinstance(item, list) else item for key, item in entry.items()}
    try:
        return kind(**values)
    except TypeError:
        raise SceneError(f"the role {role!r} lacks a key; a role needs a name, a join needs slot and of.") from None
