"""What kinds of furniture there are: the catalogue, read from one data file per functional group."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from robolayout._errors import AssetError

DATA = Path(__file__).parent / "data"
ESTIMATE = "typical of common goods (estimate)"
PLACES = ("floor", "wall", "ceiling", "object")
SIDES = ("front", "back", "left", "right")


@dataclass(frozen=True)
class Category:
    """One kind of thing.

    Attributes:
        name: Its name ("night stand").
        synonyms: Other words for it.
        size: Typical depth, width and height in metres; it faces +x.
        on_floor: It may stand on the floor.
        on_wall: It may be fixed to a wall.
        on_ceiling: It may hang from the ceiling.
        on_object: It may stand on another asset.
        use_sides: Sides it is used from ("front", "back", "left", "right").
        open_depth: Clear depth in metres that it needs in front to be opened or used; 0 where none.
        movable: Whether a person pushes or carries it in daily use.
        mass: Typical mass in kg.
        friction: Friction coefficient against the floor; low for wheels.
        group: Functional group ("sleeping").
        source: Where the size comes from.
        like: Name of the built-in category that one of a user's own is drawn, opened and moved like.
    """

    name: str
    synonyms: tuple[str, ...]
    size: tuple[float, float, float]
    on_floor: bool
    on_wall: bool
    on_ceiling: bool
    on_object: bool
    use_sides: tuple[str, ...]
    open_depth: float = 0.0
    movable: bool = False
    mass: float = 10.0
    friction: float = 0.5
    group: str = "unknown"
    source: str = ESTIMATE
    like: str = ""

    @property
    def places(self) -> tuple[str, ...]:
        """Where it may be: some of "floor", "wall", "ceiling", "object"."""
        flags = (self.on_floor, self.on_wall, self.on_ceiling, self.on_object)
        return tuple(place for place, flag in zip(PLACES, flags, strict=True) if flag)


def read_categories(path: Path) -> tuple[Category, ...]:
    """Read one catalogue file; its stem is the functional group.

    Raises:
        AssetError: The file is not TOML, or an entry lacks a key or holds an impossible value.
    """
    try:
        table = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise AssetError(f"catalogue {path.name} cannot be read: {error}.") from error
    return tuple(_category(name, entry, path.stem) for name, entry in table.items())


def _category(name: str, entry: Any, group: str) -> Category:
    """Build one category from its table, naming what is wrong with it."""
    try:
        depth, width, height = (float(value) for value in entry["size"])
        place, sides = tuple(entry["place"]), tuple(entry["use_sides"])
        synonyms = tuple(str(word) for word in entry.get("synonyms", ()))
        rest = {key: entry[key] for key in ("open_depth", "movable", "mass", "friction", "source") if key in entry}
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise AssetError(
            f"category {name!r} in group {group!r} is incomplete: it needs size = [depth, width, height], place and "
            f"use_sides ({error!r})."
        ) from error
    if min(depth, width, height) <= 0 or not set(place) <= set(PLACES) or not set(sides) <= set(SIDES):
        raise AssetError(
            f"category {name!r} in group {group!r}: sizes must be positive, place some of {', '.join(PLACES)}, "
            f"use_sides some of {', '.join(SIDES)}."
        )
    flags = {f"on_{kind}": kind in place for kind in PLACES}
    return Category(name, synonyms, (depth, width, height), use_sides=sides, group=group, **flags, **rest)


@cache
def built_in_categories() -> Mapping[str, Category]:
    """Read all built-in categories by name, in the order of the files and their entries."""
    files = sorted((DATA / "categories").glob("*.toml"))
    return {category.name: category for path in files for category in read_categories(path)}


class Catalogue(Mapping[str, Category]):
    """The built-in categories by name; read from disk when first looked at."""

    def __getitem__(self, name: str) -> Category:
        return built_in_categories()[name]

    def __iter__(self) -> Iterator[str]:
        return iter(built_in_categories())

    def __len__(self) -> int:
        return len(built_in_categories())

    def __repr__(self) -> str:
        return f"<catalogue of {len(self)} categories>"


CATALOGUE: Mapping[str, Category] = Catalogue()
"""All built-in categories by name."""
