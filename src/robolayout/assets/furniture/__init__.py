"""The furniture that no rows can say: books and goods by chance, leaves, cloth, cycles; one function a kind of thing."""

from __future__ import annotations

from robolayout.assets.furniture import home, plants, shelves, shops, warehouse
from robolayout.assets.furniture._common import Builder

__all__ = ["BUILDERS", "Builder"]

BUILDERS: dict[str, Builder] = {
    name: build for group in (home, plants, shelves, shops, warehouse) for name, build in group.BUILDERS.items()
}
"""Builders by category name: each draws the whole thing, or what its record's `parts` leave out."""
