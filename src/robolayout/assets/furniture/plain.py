"""Plain but neat stand-ins for what has no builder of its own."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.category import Category
from robolayout.assets.furniture._common import Builder, board, carcass, doors, four
from robolayout.assets.palette import Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, soft


def plain_for(category: Category) -> Builder:
    """Return a plain builder: a panel on walls, a casing on tops, a cabinet on the floor."""
    if not category.on_floor:
        return panel if category.on_wall else casing
    return unit if category.size[2] > 0.35 else casing


def unit(p: Piece) -> Iterator[Part]:
    """Yield a body with two fronts on short legs."""
    leg = min(0.08, 0.1 * p.h)
    yield from four(p, p.dark, leg, thick=0.04, inset=0.03)
    yield carcass(p, p.wood, (leg, p.h - 0.021))
    yield board(p, p.wood, (p.h - 0.02, p.h))
    yield from doors(p, p.front, p.y, (leg, p.h - 0.021), count=max(1, round(p.w / 0.5)))


def casing(p: Piece) -> Iterator[Part]:
    """Yield a bevelled casing with a coloured front."""
    yield soft("casing", p.fabric, (p.x[0], p.x[1] - 0.03 * p.d), p.y, p.z, bevel=0.12 * min(p.d, p.w, p.h))
    yield box("front", p.accent, (p.x[1] - 0.03 * p.d, p.x[1]), (0.8 * p.y[0], 0.8 * p.y[1]), (0.14 * p.h, 0.86 * p.h))


def panel(p: Piece) -> Iterator[Part]:
    """Yield a framed panel."""
    b = 0.06 * min(p.w, p.h)
    yield box("panel", p.wood, (p.x[0], p.x[1] - 0.2 * p.d), p.y, p.z)
    yield box("field", p.accent, (p.x[1] - 0.2 * p.d, p.x[1]), (p.y[0] + b, p.y[1] - b), (b, p.h - b))
