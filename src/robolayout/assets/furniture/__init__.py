"""The parametric furniture: one file per functional group, one function per kind of thing."""

from __future__ import annotations

from robolayout.assets.category import Category
from robolayout.assets.furniture import bathroom, care, decoration, kitchen, media, plain, play, retail, seating, sleeping, storage, tables, tableware, warehouse, work
from robolayout.assets.furniture._common import Builder

GROUPS = (sleeping, seating, tables, tableware, storage, media, decoration, kitchen, bathroom, work, play, retail, care, warehouse)
BUILDERS: dict[str, Builder] = {name: build for group in GROUPS for name, build in group.BUILDERS.items()}
"""Builders by category name."""


def builder_for(category: Category) -> Builder:
    """Return the builder of a category; a plain one by its placement where it has none of its own."""
    return BUILDERS.get(category.name) or plain.plain_for(category)
