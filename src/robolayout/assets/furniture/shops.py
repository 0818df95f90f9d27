"""Goods, dishes and kitchen units: rows whose pieces take turns."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout._text import utf8
from robolayout.assets.furniture._common import Builder, open_case
from robolayout.assets.palette import BRIGHT, PLAIN, SPINES, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, sheared, slab


def cash_register(p: Piece) -> Iterator[Part]:
    """Yield a cash register with keys and a display; the cashier is at +x."""
    yield box("drawer", PLAIN["anthracite"], p.x, p.y, (0.0, 0.28 * p.h))
    body = box(
        "body",
        PLAIN["light-grey"],
        (p.x[0] + 0.01, p.x[1] - 0.02),
        (0.94 * p.y[0], 0.94 * p.y[1]),
        (0.28 * p.h, 0.4 * p.h),
    )
    body.vertices[(body.vertices[:, 2] > 0.35 * p.h) & (body.vertices[:, 0] < 0), 2] += 0.24 * p.h
    yield body
    yield box("display", PLAIN["black"], (0.76 * p.x[0], 0.5 * p.x[0]), (0.7 * p.y[0], 0.7 * p.y[1]), (0.6 * p.h, p.h))
    yield box(
        "screen", PLAIN["glow"], (0.5 * p.x[0], 0.49 * p.x[0]), (0.6 * p.y[0], 0.6 * p.y[1]), (0.72 * p.h, 0.96 * p.h)
    )
    yield box("handle", PLAIN["steel"], (p.x[1] - 0.001, p.x[1] + 0.008), (-0.06, 0.06), (0.12 * p.h, 0.17 * p.h))


def _dishes(p: Piece, low: float, high: float) -> Iterator[Part]:
    """Yield serving dishes along a counter."""
    tones = (PLAIN["orange"], PLAIN["leaf"], PLAIN["bread"], PLAIN["yellow"], PLAIN["red"], PLAIN["ivory"])
    count = max(2, round(p.w / 0.42))
    for i in range(count):
        y = 0.9 * (p.y[0] + (i + 0.5) * p.w / count)
        half = min(0.17, 0.36 * p.w / count)
        if i % 3 == 1:
            yield cylinder("bowl", PLAIN["ceramic"], (0.0, y), (0.5 * half, half), (low, low + 0.09), sides=18)
            yield cylinder(
                "salad",
                tones[(i + p.variant) % 6],
                (0.0, y),
                (0.9 * half, 0.4 * half),
                (low + 0.09, low + 0.13),
                sides=18,
            )
        else:
            yield box("pan", PLAIN["steel"], (-0.14, 0.14), (y - half, y + half), (low, low + 0.09))
            yield box(
                "food",
                tones[(i + p.variant) % 6],
                (-0.125, 0.125),
                (y - 0.9 * half, y + 0.9 * half),
                (low + 0.09, low + 0.1),
            )
            if i % 2 == 0:
                yield slab(
                    "lid", PLAIN["chrome"], (-0.14, -0.02), (y - half, y + half), (low + 0.1, high), top=(0.6, 0.9)
                )


def buffet_counter(p: Piece) -> Iterator[Part]:
    """Yield a food counter with wells, a sneeze guard and a tray rail; guests at +x."""
    top = 0.66 * p.h
    rail = 0.22
    body = (p.x[0], p.x[1] - rail)
    yield box(
        "plinth", PLAIN["anthracite"], (body[0] + 0.04, body[1] - 0.04), (p.y[0] + 0.03, p.y[1] - 0.03), (0.0, 0.1)
    )
    yield box("body", p.wood, body, (p.y[0] + 0.01, p.y[1] - 0.01), (0.1, top - 0.03))
    yield box("band", p.accent, (body[1], body[1] + 0.012), (p.y[0] + 0.05, p.y[1] - 0.05), (0.3 * top, 0.7 * top))
    yield box("top", PLAIN["steel"], (body[0], body[1] + 0.02), p.y, (top - 0.029, top))
    for i in range(3):
        x = body[1] + 0.04 + 0.06 * i
        yield cylinder("tray rail", PLAIN["chrome"], (top - 0.06, x), 0.012, p.y, axis="y", sides=8)
    yield box("tray end", PLAIN["chrome"], (body[1] + 0.02, p.x[1]), (-0.01, 0.01), (top - 0.1, top - 0.075))
    moved_piece = Piece(p.d, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    for part in _dishes(moved_piece, top, top + 0.18):
        part.vertices[:, 0] += (body[0] + body[1]) / 2
        yield part
    for y in (p.y[0] + 0.04, p.y[1] - 0.06):
        yield box("post", PLAIN["chrome"], (body[1] - 0.16, body[1] - 0.14), (y, y + 0.02), (top, p.h - 0.03))
    yield sheared(
        "guard",
        PLAIN["glass"],
        (body[1] - 0.02, body[1] - 0.01),
        (p.y[0] + 0.03, p.y[1] - 0.03),
        (top + 0.2, p.h - 0.03),
        lean=(-0.12, 0.0),
    )
    yield box(
        "lamp bar", PLAIN["chrome"], (body[0] + 0.12, body[1] - 0.1), (p.y[0] + 0.02, p.y[1] - 0.02), (p.h - 0.029, p.h)
    )


def back_bar(p: Piece) -> Iterator[Part]:
    """Yield shelves of bottles above a cabinet."""
    low = 0.45 * p.h
    yield box("cabinet", p.dark, p.x, p.y, (0.0, low - 0.03))
    yield box("top", p.wood, p.x, p.y, (low - 0.029, low))
    back = Piece(0.5 * p.d, p.w - 0.04, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, 0, p.key)
    rows = [low + 0.002 + (p.h - low) * share for share in (0.34, 0.67, 0.999)]
    for part in open_case(back, p.wood, rows, 0.02, z=(low, p.h)):
        part.vertices[:, 0] -= 0.25 * p.d
        yield part
    for level in (low, *rows[:2]):
        yield from bottles(p, (p.y[0] + 0.06, p.y[1] - 0.06), level, 0.2 * (p.h - low), p.x[0] + 0.24 * p.d)


def spice_rack(p: Piece) -> Iterator[Part]:
    """Yield a small rack of jars."""
    rows = max(1, round(p.h / 0.14))
    for y0 in (p.y[0], p.y[1] - 0.012):
        yield box("side", p.wood, p.x, (y0, y0 + 0.012), p.z)
    inner = (p.y[0] + 0.012, p.y[1] - 0.012)
    for i in range(rows):
        z = i * p.h / rows
        yield box("shelf", p.wood, p.x, inner, (z, z + 0.01))
        for j in range(n := max(2, round(p.w / 0.065))):
            y = inner[0] + (j + 0.5) * (inner[1] - inner[0]) / n
            r = min(0.02, 0.4 * p.d)
            tone = (*BRIGHT, PLAIN["coffee"])[(i * 3 + j * 2) % 7]
            yield cylinder("jar", tone, (0.0, y), r, (z + 0.01, z + 0.01 + 0.55 * p.h / rows), sides=10)
            yield cylinder(
                "lid",
                PLAIN["anthracite"],
                (0.0, y),
                r,
                (z + 0.01 + 0.55 * p.h / rows, z + 0.01 + 0.65 * p.h / rows),
                sides=10,
            )


def goods(p: Piece, y: tuple[float, float], low: float, room: float, x: tuple[float, float]) -> Iterator[Part]:
    """Yield rows of packages, tins and bottles on one shelf."""
    rng = p.rng()
    rng.seed(utf8(f"{p.key}/{low:.4f}/{x[0]:.4f}"))
    at = y[0] + 0.01
    while at < y[1] - 0.08:
        width = min(rng.choice((0.09, 0.13, 0.2)), y[1] - at - 0.01)
        tone = rng.choice((*BRIGHT, *SPINES, PLAIN["ivory"]))
        tall = room * rng.uniform(0.45, 0.85)
        if rng.random() < 0.3:
            r = min(0.45 * width, 0.3 * (x[1] - x[0]), 0.05)
            yield cylinder(
                "bottle", tone, ((x[0] + x[1]) / 2, at + width / 2), (r, 0.6 * r), (low, low + tall), sides=8
            )
        else:
            yield box("goods", tone, (x[0], x[1] - 0.02 * rng.random()), (at, at + width - 0.012), (low, low + tall))
        at += width


def shop_shelf(p: Piece) -> Iterator[Part]:
    """Yield a shop shelf with goods on four or five levels."""
    rows = max(2, round(p.h / 0.36))
    yield box("back", PLAIN["light-grey"], (p.x[0], p.x[0] + 0.02), p.y, (0.0, p.h))
    yield box("base", PLAIN["light-grey"], (p.x[0] + 0.02, p.x[1]), p.y, (0.0, 0.12))
    for i in range(rows):
        low = 0.12 + i * (p.h - 0.14) / rows
        deep = p.x[1] - 0.01 - 0.06 * (i > 0)
        if i:
            yield box(
                "shelf", PLAIN["white"], (p.x[0] + 0.02, deep), (p.y[0] + 0.005, p.y[1] - 0.005), (low - 0.02, low)
            )
        yield box(
            "price rail", p.accent, (deep, deep + 0.008), (p.y[0] + 0.005, p.y[1] - 0.005), (low - 0.045, low - 0.003)
        )
        yield from goods(p, p.y, low, (p.h - 0.14) / rows - 0.02, (p.x[0] + 0.03, deep - 0.02))


def display_case(p: Piece) -> Iterator[Part]:
    """Yield a glass counter with goods inside; customers stand at +x."""
    low = 0.42 * p.h
    yield box("base", p.wood, p.x, p.y, (0.06, low))
    yield box(
        "plinth", PLAIN["anthracite"], (p.x[0] + 0.03, p.x[1] - 0.03), (p.y[0] + 0.03, p.y[1] - 0.03), (0.0, 0.06)
    )
    for z in (low, low + 0.28 * p.h):
        if z > low:
            yield box(
                "shelf",
                PLAIN["light-grey"],
                (p.x[0] + 0.04, p.x[1] - 0.06),
                (p.y[0] + 0.04, p.y[1] - 0.04),
                (z - 0.012, z),
            )
        yield from goods(p, (p.y[0] + 0.05, p.y[1] - 0.05), z, 0.18 * p.h, (p.x[0] + 0.1, p.x[1] - 0.12))
    for x0, y0 in ((p.x[0], p.y[0]), (p.x[0], p.y[1] - 0.02), (p.x[1] - 0.02, p.y[0]), (p.x[1] - 0.02, p.y[1] - 0.02)):
        yield box("post", PLAIN["steel"], (x0, x0 + 0.02), (y0, y0 + 0.02), (low, p.h - 0.03))
    yield box(
        "front glass",
        PLAIN["glass"],
        (p.x[1] - 0.012, p.x[1] - 0.006),
        (p.y[0] + 0.02, p.y[1] - 0.02),
        (low + 0.001, p.h - 0.03),
    )
    yield box("top", p.wood, p.x, p.y, (p.h - 0.03, p.h))


def card_rack(p: Piece) -> Iterator[Part]:
    """Yield a turning rack with cards on four sides."""
    yield cylinder("foot", PLAIN["anthracite"], (0.0, 0.0), (0.5 * p.d, 0.46 * p.d), (0.0, 0.05), sides=20)
    yield cylinder("pole", PLAIN["steel"], (0.0, 0.0), 0.03, (0.05, p.h), sides=10)
    rng = p.rng()
    side = 0.32 * min(p.d, p.w)
    yield box("core", PLAIN["light-grey"], (-side, side), (-side, side), (0.2 * p.h, 0.95 * p.h))
    rows = 5
    for i in range(rows):
        z = (0.22 + 0.146 * i) * p.h
        for j in range(3):
            y = (-0.66 + 0.66 * j) * side
            for way in (-1, 1):
                face = (side, side + 0.012) if way > 0 else (-side - 0.012, -side)
                size = 0.28 * side
                yield box("card", rng.choice((*BRIGHT, *SPINES)), face, (y - size, y + size), (z, z + 0.12 * p.h))
                yield box("card", rng.choice((*BRIGHT, *SPINES)), (y - size, y + size), face, (z, z + 0.12 * p.h))
        for x0 in (-side - 0.05, side + 0.03):
            yield box("rail", PLAIN["steel"], (x0, x0 + 0.02), (-side, side), (z, z + 0.02))


def display_fridge(p: Piece) -> Iterator[Part]:
    """Yield a glass-door fridge full of bottles."""
    yield box("base", PLAIN["black"], (p.x[0], p.x[1] - 0.03), p.y, (0.0, 0.14))
    yield box("head", p.accent, p.x, p.y, (p.h - 0.16, p.h))
    for y0 in (p.y[0], p.y[1] - 0.03):
        yield box("side", PLAIN["anthracite"], (p.x[0], p.x[1] - 0.03), (y0, y0 + 0.03), (0.14, p.h - 0.16))
    inner = (p.y[0] + 0.03, p.y[1] - 0.03)
    yield box("back", PLAIN["light-grey"], (p.x[0], p.x[0] + 0.03), inner, (0.14, p.h - 0.16))
    rows = 5
    span = p.h - 0.3
    for i in range(rows):
        low = 0.15 + i * span / rows
        if i:
            yield box("shelf", PLAIN["steel"], (p.x[0] + 0.03, p.x[1] - 0.07), inner, (low - 0.012, low))
        yield from bottles(p, inner, low, 0.7 * span / rows, p.x[1] - 0.16)
    for i in range(n := max(1, round(p.w / 0.62))):
        y0 = p.y[0] + i * p.w / n
        yield box(
            "door",
            PLAIN["glass"],
            (p.x[1] - 0.026, p.x[1] - 0.02),
            (y0 + 0.004, y0 + p.w / n - 0.004),
            (0.145, p.h - 0.165),
        )
        yield box(
            "handle", PLAIN["chrome"], (p.x[1] - 0.019, p.x[1] - 0.001), (y0 + 0.03, y0 + 0.05), (0.4 * p.h, 0.64 * p.h)
        )


def bottles(p: Piece, y: tuple[float, float], low: float, tall: float, x: float) -> Iterator[Part]:
    """Yield one row of bottles or flowers in a cooler."""
    count = max(3, min(12, round((y[1] - y[0]) / 0.1)))
    for i in range(count):
        at = y[0] + (i + 0.5) * (y[1] - y[0]) / count
        tone = (*BRIGHT, *SPINES)[(3 * i + round(low * 10)) % 13]
        yield cylinder("bottle", tone, (x, at), (0.038, 0.018), (low, low + tall), sides=8)


BUILDERS: dict[str, Builder] = {
    "cash register": cash_register,
    "buffet counter": buffet_counter,
    "back bar": back_bar,
    "spice rack": spice_rack,
    "shop shelf": shop_shelf,
    "display case": display_case,
    "card rack": card_rack,
    "display fridge": display_fridge,
}
