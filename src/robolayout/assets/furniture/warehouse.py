"""Racks, loads and machines: rows whose number follows the size."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout._text import utf8
from robolayout.assets.furniture._common import Builder
from robolayout.assets.palette import PLAIN, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import box

Span = tuple[float, float]


def pallet_at(x: Span, y: Span, low: float, tall: float = 0.144) -> Iterator[Part]:
    """Yield a wooden pallet over two ranges."""
    t = 0.15 * tall
    for i in range(3):
        a = x[0] + i * (x[1] - x[0] - 0.1) / 2
        yield box("runner", PLAIN["pine"], (a, a + 0.1), y, (low, low + tall - 2 * t))
    yield box("cross", PLAIN["pine"], x, (y[0] + 0.002, y[1] - 0.002), (low + tall - 2 * t, low + tall - t))
    for i in range(5):
        b = y[0] + i * (y[1] - y[0]) / 5 + 0.006
        yield box("deck", PLAIN["pine"], (x[0], x[1]), (b, b + (y[1] - y[0]) / 5 - 0.012), (low + tall - t, low + tall))


def stack(p: Piece, x: Span, y: Span, z: Span, salt: int) -> Iterator[Part]:
    """Yield cartons stacked in two or three layers."""
    rng = p.rng()
    rng.seed(utf8(f"{p.key}/{salt}"))
    layers, columns, rows = (
        max(1, round((z[1] - z[0]) / 0.38)),
        max(1, round((y[1] - y[0]) / 0.5)),
        max(1, round((x[1] - x[0]) / 0.5)),
    )
    for k in range(layers):
        for i in range(rows):
            for j in range(columns):
                if k == layers - 1 and layers > 1 and rng.random() < 0.25:
                    continue
                a = (x[0] + i * (x[1] - x[0]) / rows + 0.004, x[0] + (i + 1) * (x[1] - x[0]) / rows - 0.004)
                b = (y[0] + j * (y[1] - y[0]) / columns + 0.004, y[0] + (j + 1) * (y[1] - y[0]) / columns - 0.004)
                c = (z[0] + k * (z[1] - z[0]) / layers, z[0] + (k + 1) * (z[1] - z[0]) / layers - 0.003)
                yield box("carton", PLAIN["cardboard"] if rng.random() < 0.75 else PLAIN["pine"], a, b, c)


def loaded_pallet(p: Piece) -> Iterator[Part]:
    """Yield a pallet with cartons and a strap."""
    yield from pallet_at(p.x, p.y, 0.0)
    yield from stack(p, (0.98 * p.x[0], 0.98 * p.x[1]), (0.98 * p.y[0], 0.98 * p.y[1]), (0.145, p.h), 0)
    for y in (-0.2 * p.w, 0.2 * p.w):
        yield box("strap", PLAIN["blue"], (p.x[1] - 0.001, p.x[1] + 0.002), (y - 0.01, y + 0.01), (0.145, 0.6 * p.h))


def pallet_rack(p: Piece) -> Iterator[Part]:
    """Yield a bay of pallet racking with loads on every level."""
    t = 0.08
    for x in (p.x[0], p.x[1] - t):
        for y in (p.y[0], p.y[1] - t):
            yield box("upright", PLAIN["blue"], (x, x + t), (y, y + t), (0.0, p.h))
    for y in (p.y[0], p.y[1] - t):
        for i in range(n := max(2, round(p.h / 0.9))):
            z = (i + 0.3) * p.h / n
            yield box("brace", PLAIN["blue"], (p.x[0] + t, p.x[1] - t), (y + 0.02, y + t - 0.02), (z, z + 0.03))
    levels = max(2, round(p.h / 1.4))
    bays = max(1, round(p.w / 1.3))
    for i in range(levels):
        low = i * p.h / levels + (0.02 if i == 0 else 0.0)
        if i:
            for x in (p.x[0] + 0.004, p.x[1] - t + 0.004):
                yield box("beam", PLAIN["orange"], (x, x + t - 0.008), (p.y[0] + t, p.y[1] - t), (low - 0.1, low))
        room = p.h / levels - 0.2
        for j in range(bays):
            inner = (p.y[0] + t + j * (p.w - 2 * t) / bays + 0.06, p.y[0] + t + (j + 1) * (p.w - 2 * t) / bays - 0.06)
            x = (0.92 * p.x[0], 0.92 * p.x[1])
            yield from pallet_at(x, inner, low)
            yield from stack(
                p,
                (0.9 * p.x[0], 0.9 * p.x[1]),
                (inner[0] + 0.02, inner[1] - 0.02),
                (low + 0.145, low + 0.145 + (0.6 + 0.2 * ((i + j) % 2)) * (room - 0.145)),
                10 * i + j,
            )


def platform_cart(p: Piece) -> Iterator[Part]:
    """Yield cartons on a flat cart."""
    yield from stack(p, (0.8 * p.x[0], 0.8 * p.x[1]), (-0.3 * p.w, 0.44 * p.w), (0.2, 0.62 * p.h), 3)


def packing_table(p: Piece) -> Iterator[Part]:
    """Yield cartons on the shelf above a table, where it has one."""
    if p.h > 1.15:
        y = (p.y[0] + 0.1, 0.1 * p.w)
        yield from stack(p, (p.x[0] + 0.02, p.x[0] + 0.36 * p.d), y, (p.h - 0.21, p.h - 0.02), 1)


def roll_cage(p: Piece) -> Iterator[Part]:
    """Yield parcels in a wire trolley."""
    yield from stack(p, (0.86 * p.x[0], 0.86 * p.x[1]), (0.88 * p.y[0], 0.88 * p.y[1]), (0.17, 0.72 * p.h), 2)


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


BUILDERS: dict[str, Builder] = {
    "loaded pallet": loaded_pallet,
    "pallet rack": pallet_rack,
    "platform cart": platform_cart,
    "packing table": packing_table,
    "roll cage": roll_cage,
    "pegboard": pegboard,
}
