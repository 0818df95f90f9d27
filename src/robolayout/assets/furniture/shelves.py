"""Shelves and tables with what lies on them, mixed by each asset's own seed."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise, product

from robolayout.assets.furniture._common import books
from robolayout.assets.palette import BRIGHT, PLAIN, SPINES, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, slab


def shoe_rack(p: Piece) -> Iterator[Part]:
    """Yield pairs of shoes."""
    rng, n, wide = p.rng(), max(1, round(p.w / 0.26)), p.w - 0.05
    for low in (low for low in _levels(p, 0.24) if low <= 0.95 * p.h):
        for j in range(n):
            y, shoe = p.y[0] + 0.025 + (j + 0.5) * wide / n, rng.choice(SPINES)
            for at in (y - 0.055, y + 0.055):
                reach = ((p.x[0] + 0.02, p.x[1] - 0.02), (at - 0.04, at + 0.04), (low, low + 0.09))
                yield slab("shoe", shoe, *reach, top=(0.6, 0.8))


def clothes_rack(p: Piece) -> Iterator[Part]:
    """Yield hanging clothes."""
    rng, rail = p.rng(), p.h - 0.03
    count = max(4, round((p.w - 0.16) / 0.085))
    colors = (p.fabric, p.accent, p.bedding, *p.palette.fabrics, *p.palette.accents)
    for i in range(count):
        y = p.y[0] + 0.08 + (i + 0.5) * (p.w - 0.16) / count
        low = rail - min(0.9, 0.62 * p.h) * rng.uniform(0.7, 1.0)
        reach = ((-0.36 * p.d, 0.36 * p.d), (y - 0.03, y + 0.03), (low, rail - 0.07))
        yield slab("garment", rng.choice(colors), *reach, top=(0.4, 0.9))


def _levels(p: Piece, pitch: float, *, foot: float = 0.08) -> list[float]:
    """Return the heights of the upper faces of shelves, from `foot` to the top, about `pitch` metres apart."""
    count = max(1, round((p.h - foot) / pitch))
    return [foot + i * (p.h - foot) / count for i in range(count)] + [p.h - 0.001]


def bookshelf(p: Piece) -> Iterator[Part]:
    """Yield books and a few objects."""
    rng, inner = p.rng(), (p.y[0] + 0.022, p.y[1] - 0.022)
    for i, (low, high) in enumerate(pairwise(_levels(p, 0.34))):
        room, end, width = high - low - 0.022, inner[1], inner[1] - inner[0]
        if rng.random() < 0.35 and room > 0.2 and width > 0.5:
            end = inner[0] + width * rng.uniform(0.5, 0.7)
            at = (0.0, (end + inner[1]) / 2)
            yield cylinder("vase", p.accent, at, (0.05, 0.035), (low, low + 0.55 * room), sides=12)
        yield from books(p, (inner[0], end), low, room, salt=str(i))


def shelving_unit(p: Piece) -> Iterator[Part]:
    """Yield baskets, boxes, plants and books on the shelves, mixed by the asset's own seed."""
    rng, inner = p.rng(), min(0.03, 0.12 * min(p.d, p.w, p.h)) + 0.001
    depth, wide = (p.x[0] + 0.03, p.x[1] - 0.03), p.w - 2 * inner
    count = max(1, round(wide / 0.45))
    for (i, (low, high)), j in product(enumerate(pairwise(_levels(p, 0.42, foot=0.12))), range(count)):
        room = high - low - 0.03
        y0, y1 = (p.y[0] + inner + k * wide / count for k in (j, j + 1))
        middle, what = (y0 + y1) / 2, rng.random()
        if what < 0.35:
            reach = (depth, (y0 + 0.03, y1 - 0.03), (low, low + 0.6 * room))
            yield slab("basket", PLAIN["wicker"], *reach, top=(1.0, 1.06))
        elif what < 0.6:
            tone = rng.choice((PLAIN["cardboard"], p.fabric, p.accent))
            yield box("box", tone, depth, (y0 + 0.04, y1 - 0.04), (low, low + rng.uniform(0.4, 0.7) * room))
        elif what < 0.72:
            yield cylinder("pot", p.accent, (0.0, middle), (0.05, 0.065), (low, low + 0.35 * room), sides=12)
            r = min(0.13, 0.45 * p.d)
            reach = ((-r, r), (middle - r, middle + r), (low + 0.3 * room, low + 0.9 * room))
            yield ball("leaves", PLAIN["leaf"], *reach, rings=3, sides=8)
        else:
            yield from books(p, (y0 + 0.02, y1 - 0.02), low, room, salt=f"{i}/{j}")


def wall_shelf(p: Piece) -> Iterator[Part]:
    """Yield books, unless it is a bare ledge."""
    t = min(0.03, 0.2 * p.h)
    if p.h >= 0.1:
        yield from books(p, (p.y[0] + 0.03, p.y[0] + 0.55 * p.w), t, p.h - t, x=(p.x[0] + 0.01, p.x[1] - 0.02))


def display_cabinet(p: Piece) -> Iterator[Part]:
    """Yield objects on the shelves."""
    rng = p.rng()
    for low, share in product(_levels(p, 0.38)[:-1], (0.25, 0.5, 0.75)):
        at, tall = (-0.02, p.y[0] + share * p.w), rng.uniform(0.1, 0.24)
        tone = rng.choice((p.accent, p.bedding, *SPINES[3:5]))
        yield cylinder("object", tone, at, (0.05, 0.03), (low, low + tall), sides=10)


def toy_shelf(p: Piece) -> Iterator[Part]:
    """Yield coloured boxes and books in cubes."""
    rng, t = p.rng(), 0.018
    columns, rows = max(2, round(p.w / 0.36)), max(1, round(p.h / 0.36))
    step = (p.h - t) / rows
    for i, j in product(range(rows), range(columns)):
        y, z = p.y[0] + j * p.w / columns + 0.03, t + i * step
        span = (y, y + p.w / columns - 0.06)
        if rng.random() < 0.7:
            yield box("bin", rng.choice(BRIGHT), (p.x[0] + 0.02, p.x[1] - 0.012), span, (z, z + 0.7 * step))
        else:
            yield from books(p, span, z, step - t, salt=f"{i}{j}")


def coffee_table(p: Piece) -> Iterator[Part]:
    """Yield books on the shelf, where the table has one."""
    if abs(p.d - p.w) < 0.12:
        return
    rng = p.rng()
    y = rng.uniform(-0.2, 0.1) * p.w
    for i in range(3):
        z = 0.3 * p.h + 0.022 * i
        cover = (-0.13 + 0.01 * i, 0.1 + 0.005 * i)
        yield box("book", rng.choice(SPINES), cover, (y, y + 0.2 - 0.012 * i), (z, z + 0.02))


def bar_cart(p: Piece) -> Iterator[Part]:
    """Yield bottles on the lower tray."""
    rng, low = p.rng(), 0.24 * p.h
    for i in range(4):
        y, tall = p.y[0] + (i + 0.7) * p.w / 4.6, rng.uniform(0.3, 0.45) * p.h
        yield cylinder("bottle", rng.choice(SPINES), (0.02, y), (0.035, 0.02), (low, low + tall), sides=10)


def wine_rack(p: Piece) -> Iterator[Part]:
    """Yield lying bottles."""
    rows, columns = max(2, round(p.h / 0.16)), max(2, round(p.w / 0.13))
    reach = (p.x[0] + 0.02, p.x[1] - 0.01)
    for i, j in product(range(rows), range(columns)):
        if (i * 7 + j * 5 + p.variant) % 4:
            at = (p.y[0] + 0.03 + (j + 0.5) * (p.w - 0.06) / columns, 0.03 + i * (p.h - 0.03) / rows + 0.042)
            yield cylinder("bottle", SPINES[(i + j) % 3], at, (0.04, 0.02), reach, axis="x", sides=8)


def display_table(p: Piece) -> Iterator[Part]:
    """Yield rows of books on the shelf below the top."""
    rng, shelf = p.rng(), 0.42 * p.h
    rows, columns = max(2, round(p.d / 0.3)), max(2, round((p.w - 0.2) / 0.24))
    deep, wide = (p.d - 0.1) / rows, (p.w - 0.2) / columns
    for i, j in product(range(rows), range(columns)):
        x, y = p.x[0] + 0.05 + (i + 0.5) * deep, p.y[0] + 0.1 + (j + 0.5) * wide
        tall = rng.choice((0.1, 0.2, 0.3, 0.4)) * (p.h - 0.05 - shelf)
        reach = ((x - 0.4 * deep, x + 0.4 * deep), (y - 0.36 * wide, y + 0.36 * wide), (shelf, shelf + tall))
        yield box("books", rng.choice(SPINES), *reach)
