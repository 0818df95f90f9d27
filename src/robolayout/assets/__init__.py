"""What furniture is: categories with typical sizes, free words to category, parametric meshes, own meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from robolayout._lazy import loader
from robolayout.assets.category import CATALOGUE as CATALOGUE
from robolayout.assets.category import Category as Category
from robolayout.assets.category import read_categories as read_categories
from robolayout.assets.lexicon import category_of as category_of
from robolayout.assets.lexicon import find_category as find_category
from robolayout.assets.lexicon import unknown_kinds as unknown_kinds

if TYPE_CHECKING:
    from robolayout.assets.folder import import_folder as import_folder
    from robolayout.assets.joints import turned as turned
    from robolayout.assets.meshes import parts as parts
    from robolayout.assets.own import check_meshes as check_meshes
    from robolayout.assets.own import load_mesh_parts as load_mesh_parts
    from robolayout.assets.part import Joint as Joint
    from robolayout.assets.part import Material as Material
    from robolayout.assets.part import Part as Part
    from robolayout.assets.prisms import Prism as Prism
    from robolayout.assets.prisms import prisms_of as prisms_of
    from robolayout.assets.rooms import RoomStyle as RoomStyle
    from robolayout.assets.rooms import room_parts as room_parts
    from robolayout.assets.rooms import room_style as room_style
    from robolayout.assets.surfaces import Surface as Surface
    from robolayout.assets.surfaces import resting_place as resting_place
    from robolayout.assets.surfaces import surfaces_of as surfaces_of
    from robolayout.assets.sweeps import Sweep as Sweep
    from robolayout.assets.sweeps import sweeps_of as sweeps_of

__getattr__ = loader(__name__, __file__)  # loads the names that need array libraries when they are first used
