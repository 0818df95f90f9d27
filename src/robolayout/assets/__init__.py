"""What furniture is: categories with typical sizes, free words to category, parametric meshes, own meshes."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

from robolayout.assets.category import CATALOGUE, Category, read_categories
from robolayout.assets.lexicon import category_of, find_category, unknown_kinds

if TYPE_CHECKING:
    from robolayout.assets.folder import import_folder
    from robolayout.assets.joints import turned
    from robolayout.assets.meshes import parts
    from robolayout.assets.own import check_meshes, load_mesh_parts
    from robolayout.assets.part import Joint, Material, Part
    from robolayout.assets.prisms import Prism, prisms_of
    from robolayout.assets.rooms import RoomStyle, room_parts, room_style
    from robolayout.assets.surfaces import Surface, resting_place, surfaces_of
    from robolayout.assets.sweeps import Sweep, sweeps_of

__all__ = [
    "CATALOGUE",
    "Category",
    "Joint",
    "Material",
    "Part",
    "Prism",
    "RoomStyle",
    "Surface",
    "Sweep",
    "category_of",
    "check_meshes",
    "find_category",
    "import_folder",
    "load_mesh_parts",
    "parts",
    "prisms_of",
    "read_categories",
    "resting_place",
    "room_parts",
    "room_style",
    "surfaces_of",
    "sweeps_of",
    "turned",
    "unknown_kinds",
]

_LAZY = {
    "Joint": "part",
    "Material": "part",
    "Part": "part",
    "Prism": "prisms",
    "RoomStyle": "rooms",
    "Surface": "surfaces",
    "Sweep": "sweeps",
    "check_meshes": "own",
    "import_folder": "folder",
    "load_mesh_parts": "own",
    "parts": "meshes",
    "prisms_of": "prisms",
    "resting_place": "surfaces",
    "room_parts": "rooms",
    "room_style": "rooms",
    "surfaces_of": "surfaces",
    "sweeps_of": "sweeps",
    "turned": "joints",
}
"""Names that need numpy or shapely, and the module that holds each."""


def __getattr__(name: str) -> object:
    """Load the names that need array libraries when they are first used."""
    if name not in _LAZY:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_LAZY[name]}"), name)
