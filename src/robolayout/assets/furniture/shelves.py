"""Shelves and tables with what lies on them, mixed by each asset's own seed."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, books, four, open_case
from robolayout.assets.palette import BRIGHT, PLAIN, SPINES, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, slab


def shoe_rack(p: Piece) -> Iterator[Part]:
    """Yield slatted shelves with pairs of shoes."""
    rows = levels(p, 0.24, foot=0.08)
    for y0 in (p.y[0], p.y[1] - 0.025):
        yield box("side", p.wood, p.x, (y0, y0 + 0.025), p.z)
    inner = (p.y[0] + 0.025, p.y[1] - 0.025)
    rng = p.rng()
    for low in rows:
        for i in range(4):
            x = p.x[0] + 0.01 + i * (p.d - 0.02) / 4
            yield box("slat", p.wood, (x, x + 0.18 * p.d), inner, (low - 0.016, low - 0.002))
        if low > 0.95 * p.h:
            continue
        for j in range(max(1, round(p.w / 0.26))):
            y = inner[0] + (j + 0.5) * (inner[1] - inner[0]) / max(1, round(p.w / 0.26))
            shoe = rng.choice(SPINES)
            for side in (-0.055, 0.055):
                yield slab(
                    "shoe",
                    shoe,
                    (p.x[0] + 0.02, p.x[1] - 0.02),
                    (y + side - 0.04, y + side + 0.04),
                    (low, low + 0.09),
                    top=(0.6, 0.8),
                )


def clothes_rack(p: Piece) -> Iterator[Part]:
    """Yield a rail with hanging clothes."""
    rail = p.h - 0.03
    for y0 in (p.y[0] + 0.02, p.y[1] - 0.045):
        yield box("post", p.metal, (-0.0125, 0.0125), (y0, y0 + 0.025), (0.03, rail))
        yield box("foot", p.metal, p.x, (y0 - 0.008, y0 + 0.033), (0.0, 0.03))
    yield cylinder("rail", p.metal, (rail + 0.015, 0.0), 0.015, p.y, axis="y", sides=8)
    rng = p.rng()
    count = max(4, round((p.w - 0.16) / 0.085))
    colors = (p.fabric, p.accent, p.bedding, *p.palette.fabrics, *p.palette.accents)
    for i in range(count):
        y = p.y[0] + 0.08 + (i + 0.5) * (p.w - 0.16) / count
        low = rail - min(0.9, 0.62 * p.h) * rng.uniform(0.7, 1.0)
        yield box("hanger", p.metal, (-0.006, 0.006), (y - 0.004, y + 0.004), (rail - 0.07, rail))
        yield slab(
            "garment",
            rng.choice(colors),
            (-0.36 * p.d, 0.36 * p.d),
            (y - 0.03, y + 0.03),
            (low, rail - 0.07),
            top=(0.4, 0.9),
        )


def levels(p: Piece, pitch: float, *, foot: float = 0.08) -> list[float]:
    """Return the heights of the upper faces of shelves, from `foot` to the top, about `pitch` metres apart."""
    count = max(1, round((p.h - foot) / pitch))
    return [foot + i * (p.h - foot) / count for i in range(count)] + [p.h - 0.001]


def bookshelf(p: Piece) -> Iterator[Part]:
    """Yield a bookcase with books and a few objects."""
    t = 0.022
    rows = levels(p, 0.34)
    yield from open_case(p, p.wood, rows, t)
    yield box("plinth", p.wood, (p.x[1] - 0.03, p.x[1] - 0.01), (p.y[0] + t, p.y[1] - t), (0.0, rows[0] - t))
    rng = p.rng()
    for i, low in enumerate(rows[:-1]):
        room = rows[i + 1] - low - t
        inner = (p.y[0] + t, p.y[1] - t)
        width = inner[1] - inner[0]
        if rng.random() < 0.35 and room > 0.2 and width > 0.5:
            split = inner[0] + width * rng.uniform(0.5, 0.7)
            yield from books(p, (inner[0], split), low, room, salt=str(i))
            at = (split + inner[1]) / 2
            yield cylinder("vase", p.accent, (0.0, at), (0.05, 0.035), (low, low + 0.55 * room), sides=12)
        else:
            yield from books(p, inner, low, room, salt=str(i))


def shelving(p: Piece) -> Iterator[Part]:
    """Yield an open shelf of boards on posts with baskets, boxes and books."""
    t = p.thin(0.03)
    rows = levels(p, 0.42, foot=0.12)
    for x0 in (p.x[0], p.x[1] - t):
        for y0 in (p.y[0], p.y[1] - t):
            yield box("post", p.metal, (x0, x0 + t), (y0, y0 + t), (0.0, p.h))
    inner = (p.y[0] + t + 0.001, p.y[1] - t - 0.001)
    for level in rows:
        yield box("shelf", p.wood, (p.x[0] + 0.004, p.x[1] - 0.004), inner, (level - 0.025, level))
    yield from _filled(p, rows, inner)


def _filled(p: Piece, rows: list[float], inner: tuple[float, float]) -> Iterator[Part]:
    """Yield baskets, boxes, plants and books on the shelves, mixed by the asset's own seed."""
    rng = p.rng()
    depth = (p.x[0] + 0.03, p.x[1] - 0.03)
    for i, low in enumerate(rows[:-1]):
        room = rows[i + 1] - low - 0.03
        count = max(1, round((inner[1] - inner[0]) / 0.45))
        for j in range(count):
            y0 = inner[0] + j * (inner[1] - inner[0]) / count
            y1 = inner[0] + (j + 1) * (inner[1] - inner[0]) / count
            what = rng.random()
            if what < 0.35:
                yield slab(
                    "basket", PLAIN["wicker"], depth, (y0 + 0.03, y1 - 0.03), (low, low + 0.6 * room), top=(1.0, 1.06)
                )
            elif what < 0.6:
                yield box(
                    "box",
                    rng.choice((PLAIN["cardboard"], p.fabric, p.accent)),
                    depth,
                    (y0 + 0.04, y1 - 0.04),
                    (low, low + rng.uniform(0.4, 0.7) * room),
                )
            elif what < 0.72:
                yield cylinder("pot", p.accent, (0.0, (y0 + y1) / 2), (0.05, 0.065), (low, low + 0.35 * room), sides=12)
                wide = min(0.13, 0.45 * p.d)
                middle = (y0 + y1) / 2
                yield ball(
                    "leaves",
                    PLAIN["leaf"],
                    (-wide, wide),
                    (middle - wide, middle + wide),
                    (low + 0.3 * room, low + 0.9 * room),
                    rings=3,
                    sides=8,
                )
            else:
                yield from books(p, (y0 + 0.02, y1 - 0.02), low, room, salt=f"{i}/{j}")


def wall_shelf(p: Piece) -> Iterator[Part]:
    """Yield a board on the wall with a few things on it, or a bare ledge where it is flat."""
    if p.h < 0.1:
        yield box("board", p.wood, p.x, p.y, p.z)
        return
    t = min(0.03, 0.2 * p.h)
    yield box("board", p.wood, p.x, p.y, (0.0, t))
    yield from books(p, (p.y[0] + 0.03, p.y[0] + 0.55 * p.w), t, p.h - t, x=(p.x[0] + 0.01, p.x[1] - 0.02))
    y = p.y[0] + 0.75 * p.w
    r = min(0.3 * p.d, 0.1 * p.w)
    yield cylinder("vase", p.accent, (0.0, y), (r, 0.6 * r), (t, p.h), sides=12)


def display_cabinet(p: Piece) -> Iterator[Part]:
    """Yield a glazed cabinet with lit shelves and objects."""
    t = 0.025
    rows = levels(p, 0.38)
    yield from open_case(
        Piece(p.d - 0.01, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key), p.dark, rows, t
    )
    rng = p.rng()
    for low in rows[:-1]:
        for share in (0.25, 0.5, 0.75):
            y, tall = p.y[0] + share * p.w, rng.uniform(0.1, 0.24)
            yield cylinder(
                "object",
                rng.choice((p.accent, p.bedding, *SPINES[3:5])),
                (-0.02, y),
                (0.05, 0.03),
                (low, low + tall),
                sides=10,
            )
    yield box(
        "glass", PLAIN["glass"], (p.x[1] - 0.004, p.x[1]), (p.y[0] + 0.004, p.y[1] - 0.004), (rows[0], p.h - 0.02)
    )


def toy_shelf(p: Piece) -> Iterator[Part]:
    """Yield a low shelf of cubes with coloured boxes."""
    columns, rows = max(2, round(p.w / 0.36)), max(1, round(p.h / 0.36))
    t = 0.018
    yield from open_case(p, p.wood, [t + i * (p.h - t) / rows for i in range(rows + 1)], t)
    rng = p.rng()
    for j in range(1, columns):
        y = p.y[0] + j * p.w / columns
        for i in range(rows):
            z0 = t + i * (p.h - t) / rows
            yield box(
                "wall", p.wood, (p.x[0] + 0.01, p.x[1] - 0.004), (y - t / 2, y + t / 2), (z0, z0 + (p.h - t) / rows - t)
            )
    for i in range(rows):
        for j in range(columns):
            y0, z0 = p.y[0] + j * p.w / columns + 0.03, t + i * (p.h - t) / rows
            span = (y0, y0 + p.w / columns - 0.06)
            if rng.random() < 0.7:
                yield box(
                    "bin", rng.choice(BRIGHT), (p.x[0] + 0.02, p.x[1] - 0.012), span, (z0, z0 + 0.7 * (p.h - t) / rows)
                )
            else:
                yield from books(p, span, z0, (p.h - t) / rows - t, salt=f"{i}{j}")


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
    """Yield an open rack with bottles lying in it."""
    rows, columns = max(2, round(p.h / 0.16)), max(2, round(p.w / 0.13))
    yield from open_case(p, p.wood, [0.03 + i * (p.h - 0.03) / rows for i in range(rows)] + [p.h], 0.015)
    for i in range(rows):
        for j in range(columns):
            if (i * 7 + j * 5 + p.variant) % 4:
                y = p.y[0] + 0.03 + (j + 0.5) * (p.w - 0.06) / columns
                z = 0.03 + i * (p.h - 0.03) / rows + 0.042
                yield cylinder(
                    "bottle",
                    SPINES[(i + j) % 3],
                    (y, z),
                    (0.04, 0.02),
                    (p.x[0] + 0.02, p.x[1] - 0.01),
                    axis="x",
                    sides=8,
                )


def display_table(p: Piece) -> Iterator[Part]:
    """Yield a clear table with rows of books on the shelf below it."""
    yield box("top", p.wood, p.x, p.y, (p.h - 0.05, p.h))
    yield from four(p, p.dark, p.h - 0.05, thick=0.07, inset=0.02)
    shelf = 0.42 * p.h
    yield box("shelf", p.wood, (p.x[0] + 0.03, p.x[1] - 0.03), (p.y[0] + 0.1, p.y[1] - 0.1), (shelf - 0.03, shelf))
    rng = p.rng()
    rows, columns = max(2, round(p.d / 0.3)), max(2, round((p.w - 0.2) / 0.24))
    for i in range(rows):
        for j in range(columns):
            x = p.x[0] + 0.05 + (i + 0.5) * (p.d - 0.1) / rows
            y = p.y[0] + 0.1 + (j + 0.5) * (p.w - 0.2) / columns
            half = (0.4 * (p.d - 0.1) / rows, 0.36 * (p.w - 0.2) / columns)
            tall = rng.choice((0.1, 0.2, 0.3, 0.4)) * (p.h - 0.05 - shelf)
            yield box(
                "books",
                rng.choice(SPINES),
                (x - half[0], x + half[0]),
                (y - half[1], y + half[1]),
                (shelf, shelf + tall),
            )


BUILDERS: dict[str, Builder] = {
    "shoe rack": shoe_rack,
    "clothes rack": clothes_rack,
    "clothing stand": clothes_rack,
    "bookshelf": bookshelf,
    "shelving unit": shelving,
    "industrial shelf": shelving,
    "wall shelf": wall_shelf,
    "display cabinet": display_cabinet,
    "toy shelf": toy_shelf,
    "coffee table": coffee_table,
    "bar cart": bar_cart,
    "wine rack": wine_rack,
    "display table": display_table,
}
