"""The parametric furniture: one file per functional group, one function per kind of thing."""

from __future__ import annotations

from robolayout.assets.category import Category
from robolayout.assets.furniture import (
    bathroom,
    care,
    chairs,
    checkout,
    classroom,
    decoration,
    entrance,
    games,
    gym,
    hospitality,
    kitchen,
    lighting,
    media,
    plain,
    plants,
    play,
    retail,
    seating,
    sleeping,
    storage,
    structure,
    tables,
    tableware,
    textiles,
    wall,
    warehouse,
    work,
    workshop,
)
from robolayout.assets.furniture._common import Builder

GROUPS = (
    bathroom,
    care,
    chairs,
    checkout,
    classroom,
    decoration,
    entrance,
    games,
    gym,
    hospitality,
    kitchen,
    lighting,
    media,
    plants,
    play,
    retail,
    seating,
    sleeping,
    storage,
    structure,
    tables,
    tableware,
    textiles,
    wall,
    warehouse,
    work,
    workshop,
)
BUILDERS: dict[str, Builder] = {name: build for group in GROUPS for name, build in group.BUILDERS.items()}
"""Builders by category name."""


def builder_for(category: Category) -> Builder:
    """Return the builder of a category; a plain one by its placement where it has none of its own."""
    return BUILDERS.get(category.name) or plain.plain_for(category)
