"""Tables, sideboards and what is laid on them."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import DOOR, KNOB, Builder, board, carcass, doors, drawers, four, open_case
from robolayout.assets.palette import GLASS, IRON, SPINES, STEEL, WHITE, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, oval, prism, sheared


def table(p: Piece) -> Iterator[Part]:
    """Yield a rectangular table: legs in the corners, or two trestles, or a round one on a pedestal."""
    if p.variant % 3 == 2 and p.w > 1.2:
        yield from trestle_table(p)
        return
    thick = min(0.04, 0.12 * p.h)
    frame = p.wood if p.variant % 2 else p.dark
    yield box("top", p.wood, p.x, p.y, (p.h - thick, p.h))
    yield from four(p, frame, p.h - thick, thick=0.065, inset=0.03)
    apron = (p.h - thick - min(0.09, 0.16 * p.h), p.h - thick)
    for y0 in (p.y[0] + 0.045, p.y[1] - 0.065):
        yield box("apron", frame, (p.x[0] + 0.095, p.x[1] - 0.095), (y0, y0 + 0.02), apron)
    for x0 in (p.x[0] + 0.045, p.x[1] - 0.065):
        yield box("apron", frame, (x0, x0 + 0.02), (p.y[0] + 0.095, p.y[1] - 0.095), apron)


def trestle_table(p: Piece) -> Iterator[Part]:
    """Yield a table on two A-shaped trestles."""
    thick = 0.04
    yield box("top", p.wood, p.x, p.y, (p.h - thick, p.h))
    lean = 0.22 * p.d
    for y0 in (p.y[0] + 0.14 * p.w, p.y[1] - 0.14 * p.w - 0.05):
        for x0, way in ((p.x[0] + 0.08, 1), (p.x[1] - 0.14, -1)):
            yield sheared("leg", p.dark, (x0, x0 + 0.06), (y0, y0 + 0.05), (0.0, p.h - thick), lean=(way * lean, 0.0))
        yield box(
            "cross bar",
            p.dark,
            (p.x[0] + 0.2 * p.d, p.x[1] - 0.2 * p.d),
            (y0 + 0.01, y0 + 0.04),
            (0.2 * p.h, 0.27 * p.h),
        )
    yield box("stretcher", p.dark, (-0.02, 0.02), (p.y[0] + 0.14 * p.w, p.y[1] - 0.14 * p.w), (0.22 * p.h, 0.25 * p.h))


def round_table(p: Piece) -> Iterator[Part]:
    """Yield a round or oval table on a pedestal."""
    thick = min(0.035, 0.1 * p.h)
    yield oval("top", p.wood, (0.0, 0.0), ((p.d / 2, p.w / 2), (p.d / 2, p.w / 2)), (p.h - thick, p.h), sides=32)
    r = 0.24 * min(p.d, p.w)
    yield cylinder("column", p.dark, (0.0, 0.0), (0.3 * r, 0.2 * r), (0.04, p.h - 0.12), sides=14)
    yield cylinder("collar", p.dark, (0.0, 0.0), (0.21 * r, 0.7 * r), (p.h - 0.12, p.h - thick), sides=14)
    yield cylinder("foot", p.dark, (0.0, 0.0), (1.15 * r, 0.9 * r), (0.0, 0.04), sides=24)


def bar_table(p: Piece) -> Iterator[Part]:
    """Yield a high table on a thin steel column."""
    yield cylinder("top", p.wood, (0.0, 0.0), min(p.d, p.w) / 2, (p.h - 0.03, p.h), sides=28)
    yield cylinder("column", STEEL, (0.0, 0.0), 0.035, (0.025, p.h - 0.03), sides=12)
    yield cylinder("foot", STEEL, (0.0, 0.0), 0.34 * min(p.d, p.w), (0.0, 0.025), sides=24)


def coffee_table(p: Piece) -> Iterator[Part]:
    """Yield a low table with a shelf, or with a glass top, or a round one where it is square."""
    if abs(p.d - p.w) < 0.12:
        yield oval("top", p.wood, (0.0, 0.0), ((p.d / 2, p.w / 2), (p.d / 2, p.w / 2)), (p.h - 0.03, p.h), sides=28)
        small = Piece(0.72 * p.d, 0.72 * p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
        yield from four(small, p.dark, p.h - 0.03, thick=0.04, round_=True)
        return
    thick = 0.03
    top = GLASS if p.variant % 4 == 0 else p.wood
    frame = p.metal if top is GLASS else p.dark
    yield box("top", top, p.x, p.y, (p.h - thick, p.h))
    yield from four(p, frame, p.h - thick - (0.002 if top is GLASS else 0.0), thick=0.045, inset=0.02)
    shelf = 0.3 * p.h
    yield box("shelf", p.wood, (p.x[0] + 0.03, p.x[1] - 0.03), (p.y[0] + 0.067, p.y[1] - 0.067), (shelf - 0.02, shelf))
    rng = p.rng()
    y = rng.uniform(-0.2, 0.1) * p.w
    for i in range(3):
        z = shelf + 0.022 * i
        cover = (-0.13 + 0.01 * i, 0.1 + 0.005 * i)
        yield box("book", rng.choice(SPINES), cover, (y, y + 0.2 - 0.012 * i), (z, z + 0.02))


def side_table(p: Piece) -> Iterator[Part]:
    """Yield a small table: round on three legs, or square with a shelf."""
    if p.variant % 2 == 0:
        yield oval("top", p.wood, (0.0, 0.0), ((p.d / 2, p.w / 2), (p.d / 2, p.w / 2)), (p.h - 0.022, p.h), sides=24)
        yield oval(
            "shelf", p.wood, (0.0, 0.0), ((0.3 * p.d, 0.3 * p.w),) * 2, (0.26 * p.h, 0.26 * p.h + 0.016), sides=20
        )
        small = Piece(0.74 * p.d, 0.74 * p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
        yield from four(small, p.metal, p.h - 0.022, thick=0.025)
        return
    yield board(p, p.wood, (p.h - 0.025, p.h))
    yield from four(p, p.dark, p.h - 0.025, thick=0.04, inset=0.015)
    yield box(
        "shelf",
        p.wood,
        (p.x[0] + 0.02, p.x[1] - 0.02),
        (p.y[0] + 0.057, p.y[1] - 0.057),
        (0.25 * p.h, 0.25 * p.h + 0.018),
    )


def console_table(p: Piece) -> Iterator[Part]:
    """Yield a narrow table with two drawers under its top."""
    apron = p.h - min(0.16, 0.2 * p.h)
    yield from four(p, p.dark, apron, thick=0.045, inset=0.015)
    yield board(p, p.wood, (p.h - 0.022, p.h))
    yield carcass(p, p.wood, (apron, p.h - 0.023), y=(p.y[0] + 0.01, p.y[1] - 0.01))
    yield from drawers(p, p.front, (p.y[0] + 0.01, p.y[1] - 0.01), (apron, p.h - 0.023), rows=1, columns=2, knobs=True)


def sideboard(p: Piece) -> Iterator[Part]:
    """Yield a long low cabinet: doors outside, drawers in the middle, on legs."""
    leg = 0.16 * p.h
    yield from four(p, p.dark, leg, thick=0.04, inset=0.04, round_=True)
    yield board(p, p.wood, (p.h - 0.025, p.h))
    yield carcass(p, p.wood, (leg, p.h - 0.026))
    third = p.w / 3
    z = (leg, p.h - 0.026)
    yield from doors(p, p.front, (p.y[0], p.y[0] + third), z, count=1)
    yield from drawers(p, p.front, (-third / 2, third / 2), z, rows=3)
    yield from doors(p, p.front, (p.y[1] - third, p.y[1]), z, count=1)


def china_cabinet(p: Piece) -> Iterator[Part]:
    """Yield a cupboard with a glazed upper half and plates behind the glass."""
    split = 0.44 * p.h
    yield carcass(p, p.wood, (0.0, split - 0.026))
    yield from doors(p, p.front, p.y, (0.06, split - 0.026), count=2)
    yield board(p, p.wood, (split - 0.025, split))
    upper = Piece(p.d - 0.03, p.w - 0.02, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    levels = (split + 0.02, split + 0.2 * p.h, split + 0.38 * p.h, p.h - 0.025)
    for part in open_case(upper, p.wood, levels, 0.018, z=(split, p.h - 0.026)):
        part.vertices[:, 0] -= 0.015
        yield part
    yield board(p, p.wood, (p.h - 0.024, p.h))
    for level in levels[:3]:
        for y in (-0.26 * p.w, 0.0, 0.26 * p.w):
            yield cylinder(
                "plate", WHITE, (y, level + 0.085), 0.08, (p.x[0] + 0.04, p.x[0] + 0.055), axis="x", sides=14
            )
    for y0, y1 in ((p.y[0] + 0.03, -0.003), (0.003, p.y[1] - 0.03)):
        yield box("glass door", GLASS, (p.x[1] - 0.028, p.x[1] - 0.022), (y0, y1), (split + 0.004, p.h - 0.03))


def bar_cart(p: Piece) -> Iterator[Part]:
    """Yield a trolley with two trays, bottles and wheels."""
    low, high = 0.24 * p.h, p.h
    for z in (low, high):
        yield box("tray", p.wood, (p.x[0] + 0.016, p.x[1] - 0.016), (p.y[0] + 0.016, p.y[1] - 0.016), (z - 0.02, z))
    for x in (p.x[0] + 0.008, p.x[1] - 0.008):
        for y in (p.y[0] + 0.008, p.y[1] - 0.008):
            yield cylinder("post", p.metal, (x, y), 0.008, (0.06, p.h - 0.021), sides=6)
            yield cylinder("wheel", IRON, (0.03, x), 0.03, (y - 0.008, y + 0.008), axis="y", sides=10)
    rng = p.rng()
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


def picnic_table(p: Piece) -> Iterator[Part]:
    """Yield a table with two fixed benches, long in y."""
    for i in range(5):
        x = -0.28 * p.d + i * 0.112 * p.d
        yield box("plank", p.wood, (x, x + 0.108 * p.d), (p.y[0] + 0.02, p.y[1] - 0.02), (p.h - 0.04, p.h))
    for x0, x1 in ((p.x[0], p.x[0] + 0.26), (p.x[1] - 0.26, p.x[1])):
        yield box("bench", p.wood, (x0, x1), p.y, (0.58 * p.h, 0.63 * p.h))
    for y in (p.y[0] + 0.16 * p.w, p.y[1] - 0.16 * p.w):
        yield box("beam", p.dark, (p.x[0] + 0.02, p.x[1] - 0.02), (y - 0.02, y + 0.02), (0.5 * p.h, 0.58 * p.h))
        for x0, way in ((-0.3 * p.d, 1), (0.24 * p.d, -1)):
            yield sheared(
                "leg", p.dark, (x0, x0 + 0.08), (y + 0.021, y + 0.06), (0.0, p.h - 0.04), lean=(way * 0.12 * p.d, 0.0)
            )


def conference_table(p: Piece) -> Iterator[Part]:
    """Yield a long table with rounded ends on two panels."""
    points = [(p.d / 2 * a, p.w / 2 * b) for a, b in ((0.82, -1.0), (1.0, -0.5), (1.0, 0.5), (0.82, 1.0))]
    outline = points + [(-x, -y) for x, y in points]
    yield prism("top", p.wood, outline, (p.h - 0.04, p.h))
    for y in (-0.3 * p.w, 0.3 * p.w):
        yield box("panel", p.dark, (-0.3 * p.d, 0.3 * p.d), (y - 0.03, y + 0.03), (0.02, p.h - 0.04))
        yield box("foot", p.dark, (-0.36 * p.d, 0.36 * p.d), (y - 0.05, y + 0.05), (0.0, 0.02))
    yield box("beam", p.dark, (-0.02, 0.02), (-0.3 * p.w + 0.03, 0.3 * p.w - 0.03), (0.35 * p.h, 0.5 * p.h))


def bar_cabinet(p: Piece) -> Iterator[Part]:
    """Yield a cabinet with an open bottle niche above two doors."""
    split = 0.6 * p.h
    yield carcass(p, p.wood, (0.05, split))
    yield box("plinth", p.dark, (p.x[0] + 0.01, p.x[1] - 0.06), (p.y[0] + 0.02, p.y[1] - 0.02), (0.0, 0.05))
    yield from doors(p, p.front, p.y, (0.05, split), count=2)
    inset = KNOB + DOOR + 0.002
    for y0 in (p.y[0], p.y[1] - 0.02):
        yield box("side", p.wood, (p.x[0], p.x[1] - inset), (y0, y0 + 0.02), (split, p.h - 0.025))
    yield box("back", p.wood, (p.x[0], p.x[0] + 0.015), (p.y[0] + 0.02, p.y[1] - 0.02), (split, p.h - 0.025))
    yield board(p, p.wood, (p.h - 0.025, p.h))
    for i in range(5):
        y = p.y[0] + (i + 1) * p.w / 6
        yield cylinder(
            "bottle", SPINES[i % len(SPINES)], (0.0, y), (0.036, 0.018), (split, split + 0.3 * p.h), sides=10
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
    "dining table": table,
    "round table": round_table,
    "bar table": bar_table,
    "coffee table": coffee_table,
    "side table": side_table,
    "console table": console_table,
    "sideboard": sideboard,
    "china cabinet": china_cabinet,
    "bar cart": bar_cart,
    "wine rack": wine_rack,
    "picnic table": picnic_table,
    "conference table": conference_table,
    "bar cabinet": bar_cabinet,
    "display table": display_table,
    "unknown surface": table,
    "kids table": table,
}
