"""Racks, loads and machines: rows whose number follows the size."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from robolayout._text import utf8
from robolayout.assets.palette import PLAIN, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import box

Span = tuple[float, float]


def _stack(p: Piece, x: Span, y: Span, z: Span, salt: int) -> Iterator[Part]:
    """Yield cartons stacked in two or three layers."""
    rng = p.rng()
    rng.seed(utf8(f"{p.key}/{salt}"))
    spans = (z, x, y)
    counts = [max(1, round((b - a) / edge)) for (a, b), edge in zip(spans, (0.38, 0.5, 0.5), strict=True)]
    for cell in product(*map(range, counts)):
        if cell[0] == counts[0] - 1 and counts[0] > 1 and rng.random() < 0.25:
            continue
        c, a, b = (
            (low + i * (high - low) / n + gap, low + (i + 1) * (high - low) / n - (gap or 0.003))
            for (low, high), i, n, gap in zip(spans, cell, counts, (0.0, 0.004, 0.004), strict=True)
        )
        yield box("carton", PLAIN["cardboard"] if rng.random() < 0.75 else PLAIN["pine"], a, b, c)


def loaded_pallet(p: Piece) -> Iterator[Part]:
    """Yield the cartons on a pallet."""
    yield from _stack(p, (0.98 * p.x[0], 0.98 * p.x[1]), (0.98 * p.y[0], 0.98 * p.y[1]), (0.145, p.h), 0)


def pallet_rack(p: Piece) -> Iterator[Part]:
    """Yield the loads on every pallet of a rack."""
    levels, bays = max(2, round(p.h / 1.4)), max(1, round(p.w / 1.3))
    wide, x = (p.w - 0.16) / bays, (0.9 * p.x[0], 0.9 * p.x[1])
    for i, j in product(range(levels), range(bays)):
        low, y = i * p.h / levels + (0.0 if i else 0.02) + 0.145, p.y[0] + 0.16 + j * wide
        high = low + (0.6 + 0.2 * ((i + j) % 2)) * (p.h / levels - 0.345)
        yield from _stack(p, x, (y, y + wide - 0.16), (low, high), 10 * i + j)


def platform_cart(p: Piece) -> Iterator[Part]:
    """Yield cartons on a flat cart."""
    yield from _stack(p, (0.8 * p.x[0], 0.8 * p.x[1]), (-0.3 * p.w, 0.44 * p.w), (0.2, 0.62 * p.h), 3)


def packing_table(p: Piece) -> Iterator[Part]:
    """Yield cartons on the shelf above a table, where it has one."""
    if p.h > 1.15:
        y = (p.y[0] + 0.1, 0.1 * p.w)
        yield from _stack(p, (p.x[0] + 0.02, p.x[0] + 0.36 * p.d), y, (p.h - 0.21, p.h - 0.02), 1)


def roll_cage(p: Piece) -> Iterator[Part]:
    """Yield parcels in a wire trolley."""
    yield from _stack(p, (0.86 * p.x[0], 0.86 * p.x[1]), (0.88 * p.y[0], 0.88 * p.y[1]), (0.17, 0.72 * p.h), 2)


def pegboard(p: Piece) -> Iterator[Part]:
    """Yield a wall board with hanging tools."""
    face = p.x[0] + 0.3 * p.d
    rng = p.rng()
    columns = max(3, round(p.w / 0.17))
    for i in range(columns):
        y = p.y[0] + (i + 0.5) * p.w / columns
        for row, top in enumerate((0.92, 0.48)):
            long = rng.uniform(0.18, 0.32) * p.h
            z = top * p.h
            yield box(
                "grip",
                (PLAIN["red"], PLAIN["yellow"], PLAIN["blue"], PLAIN["black"])[(i + row) % 4],
                (face, p.x[1]),
                (y - 0.018, y + 0.018),
                (z - long, z - 0.5 * long),
            )
            if (i + row) % 3:
                yield box("blade", PLAIN["steel"], (face, face + 0.3 * p.d), (y - 0.01, y + 0.01), (z - 0.5 * long, z))
            else:
                yield box(
                    "head",
                    PLAIN["iron"],
                    (face, face + 0.5 * p.d),
                    (y - 0.05, y + 0.05),
                    (z - 0.5 * long, z - 0.35 * long),
                )
