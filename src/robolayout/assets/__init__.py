"""What furniture is: categories with typical sizes, free words to category, parametric meshes, own meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from robolayout._lazy import loader
from robolayout.assets.category import CATALOGUE, Category
from robolayout.assets.lexicon import category_of, find_category, place_of, unknown_kinds

if TYPE_CHECKING:
    from robolayout.assets.catalogue import own_assets, own_kinds
    from robolayout.assets.folder import import_folder
    from robolayout.assets.joints import Sweep, sweeps_of, turned
    from robolayout.assets.meshes import parts
    from robolayout.assets.own import check_meshes, load_mesh_parts
    from robolayout.assets.part import Joint, Material, Part
    from robolayout.assets.prisms import Prism, prisms_of
    from robolayout.assets.rooms import RoomStyle, room_parts, room_style
    from robolayout.assets.surfaces import Surface, resting_place, surfaces_of

__all__ = [
    "CATALOGUE", "Category", "Joint", "Material", "Part", "Prism", "RoomStyle", "Surface", "Sweep", "category_of",
    "check_meshes", "find_category", "import_folder", "load_mesh_parts", "own_assets", "own_kinds", "parts", "place_of", "prisms_of",
    "resting_place", "room_parts", "room_style", "surfaces_of", "sweeps_of", "turned", "unknown_kinds",
]  # fmt: skip
__getattr__ = loader(__name__, __file__)  # loads the names that need array libraries when they are first used
