"""Parametric furniture: an asset's parts, built for its category and fitted exactly into its box."""

from __future__ import annotations

from functools import lru_cache

from robolayout.assets.category import CATALOGUE, Category
from robolayout.assets.drawing import PartDrawing
from robolayout.assets.fronts import hollowed
from robolayout.assets.joints import JointRule, jointed, read_joints
from robolayout.assets.lexicon import category_of
from robolayout.assets.palette import make_piece
from robolayout.assets.part import Part, fit
from robolayout.assets.rows import read_rows
from robolayout.scene import Asset


def parts(asset: Asset, seed: int = 0, *, shut: bool = False) -> tuple[Part, ...]:
    """Return the parts of an asset in its own frame: origin in the middle of its box, front along +x.

    The parts together fill the box exactly; each parametric part is convex. The same asset and seed give the same bytes.
    A `path` is loaded instead where the asset has one, and its own `parts` come before its category's.

    Args:
        shut: Whether bodies are solid behind drawers, as whoever cannot open them meets them.
    """
    said = {key: value for key, value in asset.metadata.items() if isinstance(value, str)}
    if asset.path is not None:
        from robolayout.assets.own import load_mesh_parts

        return load_mesh_parts(asset.path, asset.size, up=said.get("up"), front=said.get("front"))
    made = _drawn(asset, seed, said.get("look", ""), shut)
    return tuple(part for part in made if part.name not in asset.without) if asset.without else made


@lru_cache(maxsize=512)  # of a room of some hundred things; prisms, surfaces, doors and pictures all ask for them
def _drawn(asset: Asset, seed: int, look: str, shut: bool) -> tuple[Part, ...]:
    """Return the parts of an asset without a mesh of its own."""
    if not shut:
        return hollowed(_drawn(asset, seed, look, shut=True))
    category = category_of(asset)
    piece = make_piece(category.name, asset.variable or asset.name, asset.name, asset.size, seed, look)
    build = read_rows(asset.parts, f"asset {asset.name!r}") if asset.parts else builder_for(category)
    return jointed(fit(build(piece), asset.size), joints_of(category), asset.size)


def joints_of(category: Category) -> tuple[JointRule, ...]:
    """Return how parts of a category move: what its record says, or that which it is drawn alike."""
    alike = CATALOGUE.get(category.parts) or CATALOGUE.get(category.like)
    if not category.joints and alike is not None:
        return joints_of(alike)
    return read_joints(category.joints)


def builder_for(category: Category) -> PartDrawing:
    """Return what draws a category: the rows of its record, or of the record that it names or is like."""
    alike = CATALOGUE.get(category.parts or category.like)
    if alike is not None:
        return builder_for(alike)
    return read_rows(category.parts, f"{category.name!r} in group {category.group!r}")
