"""The furniture that no rows can say: books and goods by chance, leaves, cloth, cycles; one function a kind of thing."""

from __future__ import annotations

from robolayout.assets.furniture import home, plants, shelves, shops, warehouse
from robolayout.assets.furniture._common import Builder as Builder

BUILDERS: dict[str, Builder] = {
    name.replace("_", " "): build
    for group in (home, plants, shelves, shops, warehouse)
    for name, build in vars(group).items()
    if not name.startswith("_") and getattr(build, "__module__", "") == group.__name__
}
"""Builders by category name, that of the function: each draws the whole thing, or what its record's `parts` leave out."""
