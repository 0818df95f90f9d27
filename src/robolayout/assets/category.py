"""What kinds of furniture there are: the catalogue, read from one data file per functional group."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

from robolayout._errors import AssetError

DATA = Path(__file__).parent / "data"
ESTIMATE = "typical of common goods (estimate)"
PLACES = ("floor", "wall", "ceiling", "object")
SIDES = ("front", "back", "left", "right")
HEADS = ("group", "role")  # tables of a data file that are no records: what the planner calls its group, and roles
NEEDED = ("size", "place", "use_sides", "synonyms")
FURTHER: Mapping[str, tuple[type, ...]] = {
    "open_depth": (float, int), "movable": (bool,), "mass": (float, int), "friction": (float, int), "role": (str,),
    "source": (str,), "parts": (str,), "joints": (str,), "hangs": (float,),
}  # fmt: skip
"""What else a record may say, and the kinds of value."""


@dataclass(frozen=True)
class Category:
    """One kind of thing."""

    name: str  # its name ("night stand")
    synonyms: tuple[str, ...]  # other words for it
    size: tuple[float, float, float]  # typical depth, width and height in metres; it faces +x
    on_floor: bool  # it may stand on the floor
    on_wall: bool  # it may be fixed to a wall
    on_ceiling: bool  # it may hang from the ceiling
    on_object: bool  # it may stand on another asset
    use_sides: tuple[str, ...]  # sides it is used from ("front", "back", "left", "right")
    open_depth: float = 0.0  # clear depth in metres that it needs in front to be opened or used; 0 where none
    movable: bool = False  # whether a person pushes or carries it in daily use
    mass: float = 10.0  # typical mass in kg
    friction: float = 0.5  # friction coefficient against the floor; low for wheels
    group: str = "unknown"  # functional group ("sleeping")
    source: str = ESTIMATE  # where the size comes from
    like: str = ""  # name of the built-in category that one of a user's own is drawn, opened and moved like
    role: str = ""  # what it is for in a room, by name; empty where size and placement decide
    # what it is made of, one row a part (docs/assets.md), or the name of the category that is drawn alike; empty where
    # a function draws it
    parts: str = ""
    joints: str = ""  # what of it moves, one row a joint (docs/assets.md); empty where doors and drawers move as usual
    hangs: float = 0.0  # metres from its top down to the hook that its middle hangs from; 0 where it stands

    @property
    def places(self) -> tuple[str, ...]:
        """Where it may be: some of "floor", "wall", "ceiling", "object"."""
        return tuple(place for place in PLACES if getattr(self, f"on_{place}"))

    @property
    def dresses_windows(self) -> bool:
        """Whether it hangs before windows: curtains, blinds."""
        return self.role == "window dressing"


def read_categories(path: Path) -> tuple[Category, ...]:
    """Read the records of one data file; its stem is the functional group."""
    return _categories(_data(path), path.stem)


def _data(path: Path) -> Mapping[str, Any]:
    """Read one file: its group, roles and records."""
    try:
        return tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise AssetError(f"catalogue {path.name} cannot be read: {error}.") from error


@cache
def read_data(name: str) -> Mapping[str, Any]:
    """Read one of the package's own data files."""
    return _data(DATA / name)


def _categories(data: Mapping[str, Any], group: str) -> tuple[Category, ...]:
    return tuple(_category(name, entry, group) for name, entry in data.items() if name not in HEADS)


def _category(name: str, entry: Any, group: str) -> Category:
    """Build one category from its record, naming what is wrong with it."""
    where = f"category {name!r} in group {group!r}"
    try:
        depth, width, height = (float(value) for value in entry["size"])
        place, sides = tuple(entry["place"]), tuple(entry["use_sides"])
        synonyms = tuple(str(word) for word in entry.get("synonyms", ()))
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise AssetError(
            f"{where} is incomplete: it needs size = [depth, width, height], place and use_sides ({error!r})."
        ) from error
    if min(depth, width, height) <= 0 or not set(place) <= set(PLACES) or not set(sides) <= set(SIDES):
        raise AssetError(
            f"{where}: sizes must be positive, place some of {', '.join(PLACES)}, use_sides some of {', '.join(SIDES)}."
        )
    rest = {key: value for key, value in entry.items() if key not in NEEDED}
    for key, value in rest.items():
        if type(value) not in FURTHER.get(key, ()):
            raise AssetError(f"{where}: {key} = {value!r} is not understood; besides {', '.join(NEEDED)} it may say "
                             f"{', '.join(FURTHER)}.")  # fmt: skip
    flags = {f"on_{kind}": kind in place for kind in PLACES}
    return Category(name, synonyms, (depth, width, height), use_sides=sides, group=group, **flags, **rest)


BUILT_IN = {path.stem: _data(path) for path in sorted((DATA / "things").glob("*.toml"))}
"""What the built-in data files say, by their stems: groups, roles and records."""
CATALOGUE: Mapping[str, Category] = MappingProxyType(
    {kind.name: kind for group, data in BUILT_IN.items() for kind in _categories(data, group)}
)
"""All built-in categories by name, in the order of the files and their records."""
