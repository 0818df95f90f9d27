"""What furniture is: categories with typical sizes, free words to category, parametric meshes, own meshes."""

from robolayout.assets.category import CATALOGUE, Category, read_categories
from robolayout.assets.lexicon import category_of, find_category
from robolayout.assets.obstacles import blocks
from robolayout.assets.meshes import parts
from robolayout.assets.part import Material, Part

__all__ = [
    "CATALOGUE",
    "Category",
    "Material",
    "Part",
    "blocks",
    "category_of",
    "find_category",
    "parts",
    "read_categories",
]
