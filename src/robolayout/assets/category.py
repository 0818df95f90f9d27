"""What kinds of furniture there are: the catalogue, read from one data file per functional group."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

DATA = Path(__file__).parent / "data"
ESTIMATE = "typical of common goods (estimate)"
PLACES = ("floor", "wall", "ceiling", "object")
SIDES = ("front", "back", "left", "right")
ONLY_SEEN = ("picture", "wall clock", "air conditioner", "shop wall sign")  # roles of what is there to be looked at
BUILT_INTO = ("kitchen", "bathroom")  # groups of what is as one with a counter that it is "on"
BUILT_IN_FROM = 0.6  # metres of height from which on it is so
HEADS = ("group", "role")  # tables of a data file that are no records: what the planner calls its group, and roles


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

    @property
    def only_seen(self) -> bool:
        """Whether nobody needs to get to it where it hangs on a wall: pictures, clocks; a mirror is stood before."""
        return self.role in ONLY_SEEN and not self.use_sides

    @property
    def built_in(self) -> bool:
        """Whether it is as one with a counter that it is "on", as a stove is."""
        return self.group in BUILT_INTO and self.size[2] > BUILT_IN_FROM and not self.movable


@cache
def read_data(name: str) -> Mapping[str, Any]:
    """Read one of the package's own data files."""
    return tomllib.loads((DATA / name).read_text(encoding="utf-8"))


def _category(name: str, entry: Mapping[str, Any], group: str) -> Category:
    """Build one category from its record."""
    said = {key: value for key, value in entry.items() if key != "place"}
    said |= {f"on_{kind}": kind in entry["place"] for kind in PLACES}
    said["size"] = tuple(float(edge) for edge in entry["size"])
    said["use_sides"], said["synonyms"] = tuple(entry["use_sides"]), tuple(entry.get("synonyms", ()))
    return Category(name, group=group, **said)


BUILT_IN = {path.stem: read_data(f"things/{path.name}") for path in sorted((DATA / "things").glob("*.toml"))}
"""What the built-in data files say, by their stems: groups, roles and records."""
CATALOGUE: Mapping[str, Category] = MappingProxyType(
    {
        name: _category(name, entry, group)
        for group, data in BUILT_IN.items()
        for name, entry in data.items()
        if name not in HEADS
    }
)
"""All built-in categories by name, in the order of the files and their records."""
