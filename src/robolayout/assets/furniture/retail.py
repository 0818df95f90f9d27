"""Shops, restaurants, cafes and bars."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder
from robolayout.assets.palette import (
    BLACK,
    BREAD,
    BRIGHT,
    CHROME,
    DARK,
    GLASS,
    GLOW,
    GREEN,
    IVORY,
    LEAF,
    LIGHT_GREY,
    ORANGE,
    RED,
    SLATE,
    SPINES,
    STEEL,
    WHITE,
    YELLOW,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, oval, sheared, soft


def goods(p: Piece, y: tuple[float, float], low: float, room: float, x: tuple[float, float]) -> Iterator[Part]:
    """Yield rows of packages, tins and bottles on one shelf."""
    rng = p.rng()
    rng.seed(f"{p.key}/{low:.4f}/{x[0]:.4f}")
    at = y[0] + 0.01
    while at < y[1] - 0.08:
        width = min(rng.choice((0.09, 0.13, 0.2)), y[1] - at - 0.01)
        tone = rng.choice((*BRIGHT, *SPINES, IVORY))
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
    yield box("back", LIGHT_GREY, (p.x[0], p.x[0] + 0.02), p.y, (0.0, p.h))
    yield box("base", LIGHT_GREY, (p.x[0] + 0.02, p.x[1]), p.y, (0.0, 0.12))
    for i in range(rows):
        low = 0.12 + i * (p.h - 0.14) / rows
        deep = p.x[1] - 0.01 - 0.06 * (i > 0)
        if i:
            yield box("shelf", WHITE, (p.x[0] + 0.02, deep), (p.y[0] + 0.005, p.y[1] - 0.005), (low - 0.02, low))
        yield box(
            "price rail", p.accent, (deep, deep + 0.008), (p.y[0] + 0.005, p.y[1] - 0.005), (low - 0.045, low - 0.003)
        )
        yield from goods(p, p.y, low, (p.h - 0.14) / rows - 0.02, (p.x[0] + 0.03, deep - 0.02))


def display_case(p: Piece) -> Iterator[Part]:
    """Yield a glass counter with goods inside; customers stand at +x."""
    low = 0.42 * p.h
    yield box("base", p.wood, p.x, p.y, (0.06, low))
    yield box("plinth", DARK, (p.x[0] + 0.03, p.x[1] - 0.03), (p.y[0] + 0.03, p.y[1] - 0.03), (0.0, 0.06))
    for z in (low, low + 0.28 * p.h):
        if z > low:
            yield box(
                "shelf", LIGHT_GREY, (p.x[0] + 0.04, p.x[1] - 0.06), (p.y[0] + 0.04, p.y[1] - 0.04), (z - 0.012, z)
            )
        yield from goods(p, (p.y[0] + 0.05, p.y[1] - 0.05), z, 0.18 * p.h, (p.x[0] + 0.1, p.x[1] - 0.12))
    for x0, y0 in ((p.x[0], p.y[0]), (p.x[0], p.y[1] - 0.02), (p.x[1] - 0.02, p.y[0]), (p.x[1] - 0.02, p.y[1] - 0.02)):
        yield box("post", STEEL, (x0, x0 + 0.02), (y0, y0 + 0.02), (low, p.h - 0.03))
    yield box(
        "front glass",
        GLASS,
        (p.x[1] - 0.012, p.x[1] - 0.006),
        (p.y[0] + 0.02, p.y[1] - 0.02),
        (low + 0.001, p.h - 0.03),
    )
    yield box("top", p.wood, p.x, p.y, (p.h - 0.03, p.h))


def mannequin(p: Piece) -> Iterator[Part]:
    """Yield a dressed shop dummy on a foot plate."""
    d, w, h = p.d, p.w, p.h
    yield cylinder("foot", STEEL, (0.0, 0.0), 0.46 * d, (0.0, 0.02), sides=20)
    for side in (-1, 1):
        yield cylinder(
            "leg",
            p.fabric,
            (0.0, side * 0.12 * w),
            (0.06, 0.085),
            (0.04 * h + 0.001 * side, 0.5 * h + 0.002 * side),
            sides=10,
        )
        yield box(
            "shoe", BLACK, (-0.06, 0.14), (side * 0.12 * w - 0.04, side * 0.12 * w + 0.04), (0.02, 0.045 * h + 0.02)
        )
        yield sheared(
            "arm",
            IVORY,
            (-0.034, 0.034),
            (side * 0.46 * w - 0.035, side * 0.46 * w + 0.035),
            (0.44 * h, 0.79 * h),
            lean=(0.0, -side * 0.12 * w),
        )
    yield oval(
        "hips", p.accent, (0.0, 0.0), ((0.26 * d, 0.3 * w), (0.21 * d, 0.242 * w)), (0.48 * h, 0.62 * h), sides=16
    )
    yield oval(
        "chest", p.accent, (0.0, 0.0), ((0.19 * d, 0.258 * w), (0.28 * d, 0.38 * w)), (0.62 * h, 0.8 * h), sides=16
    )
    yield oval(
        "shoulders", p.accent, (0.0, 0.0), ((0.28 * d, 0.38 * w), (0.11 * d, 0.149 * w)), (0.8 * h, 0.845 * h), sides=16
    )
    yield cylinder("neck", IVORY, (0.0, 0.0), 0.05, (0.84 * h, 0.89 * h), sides=10)
    yield ball("head", IVORY, (-0.09, 0.1), (-0.075, 0.075), (0.87 * h, h), rings=6)


def card_rack(p: Piece) -> Iterator[Part]:
    """Yield a turning rack with cards on four sides."""
    yield cylinder("foot", DARK, (0.0, 0.0), (0.5 * p.d, 0.46 * p.d), (0.0, 0.05), sides=20)
    yield cylinder("pole", STEEL, (0.0, 0.0), 0.03, (0.05, p.h), sides=10)
    rng = p.rng()
    side = 0.32 * min(p.d, p.w)
    yield box("core", LIGHT_GREY, (-side, side), (-side, side), (0.2 * p.h, 0.95 * p.h))
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
            yield box("rail", STEEL, (x0, x0 + 0.02), (-side, side), (z, z + 0.02))


def display_fridge(p: Piece) -> Iterator[Part]:
    """Yield a glass-door fridge full of bottles."""
    yield box("base", BLACK, (p.x[0], p.x[1] - 0.03), p.y, (0.0, 0.14))
    yield box("head", p.accent, p.x, p.y, (p.h - 0.16, p.h))
    for y0 in (p.y[0], p.y[1] - 0.03):
        yield box("side", DARK, (p.x[0], p.x[1] - 0.03), (y0, y0 + 0.03), (0.14, p.h - 0.16))
    inner = (p.y[0] + 0.03, p.y[1] - 0.03)
    yield box("back", LIGHT_GREY, (p.x[0], p.x[0] + 0.03), inner, (0.14, p.h - 0.16))
    rows = 5
    span = p.h - 0.3
    for i in range(rows):
        low = 0.15 + i * span / rows
        if i:
            yield box("shelf", STEEL, (p.x[0] + 0.03, p.x[1] - 0.07), inner, (low - 0.012, low))
        yield from bottles(p, inner, low, 0.7 * span / rows, p.x[1] - 0.16)
    for i in range(n := max(1, round(p.w / 0.62))):
        y0 = p.y[0] + i * p.w / n
        yield box(
            "door", GLASS, (p.x[1] - 0.026, p.x[1] - 0.02), (y0 + 0.004, y0 + p.w / n - 0.004), (0.145, p.h - 0.165)
        )
        yield box("handle", CHROME, (p.x[1] - 0.019, p.x[1] - 0.001), (y0 + 0.03, y0 + 0.05), (0.4 * p.h, 0.64 * p.h))


def bottles(p: Piece, y: tuple[float, float], low: float, tall: float, x: float) -> Iterator[Part]:
    """Yield one row of bottles or flowers in a cooler."""
    count = max(3, min(12, round((y[1] - y[0]) / 0.1)))
    for i in range(count):
        at = y[0] + (i + 0.5) * (y[1] - y[0]) / count
        tone = (*BRIGHT, *SPINES)[(3 * i + round(low * 10)) % 13]
        yield cylinder("bottle", tone, (x, at), (0.038, 0.018), (low, low + tall), sides=8)


def deli_counter(p: Piece) -> Iterator[Part]:
    """Yield a cooled counter with slanted glass and food; customers at +x, staff at -x."""
    bed = 0.62 * p.h
    yield box("plinth", DARK, (p.x[0] + 0.05, p.x[1] - 0.08), (p.y[0] + 0.02, p.y[1] - 0.02), (0.0, 0.1))
    yield box("body", p.front, (p.x[0], p.x[1] - 0.02), p.y, (0.1, bed))
    yield box("band", p.accent, (p.x[1] - 0.02, p.x[1]), (p.y[0] + 0.01, p.y[1] - 0.01), (0.56 * bed, 0.72 * bed))
    yield box("ice", WHITE, (-0.24 * p.d, 0.44 * p.d), (p.y[0] + 0.04, p.y[1] - 0.04), (bed, bed + 0.01))
    count = max(3, round(p.w / 0.32))
    tones = (RED, YELLOW, BREAD, IVORY, ORANGE, GREEN)
    for i in range(count):
        y = p.y[0] + 0.04 + (i + 0.5) * (p.w - 0.08) / count
        for x in (-0.06 * p.d, 0.26 * p.d):
            yield box("tray", STEEL, (x - 0.13 * p.d, x + 0.13 * p.d), (y - 0.12, y + 0.12), (bed + 0.01, bed + 0.03))
            yield soft(
                "food",
                tones[(2 * i + (x > 0)) % 6],
                (x - 0.11 * p.d, x + 0.11 * p.d),
                (y - 0.1, y + 0.1),
                (bed + 0.03, bed + 0.09),
                bevel=0.025,
            )
    for y0 in (p.y[0], p.y[1] - 0.02):
        yield sheared(
            "glass side",
            GLASS,
            (-0.24 * p.d, 0.46 * p.d),
            (y0, y0 + 0.008),
            (bed + 0.001, p.h - 0.03),
            lean=(-0.04, 0.0),
        )
    yield sheared(
        "glass",
        GLASS,
        (0.44 * p.d, 0.45 * p.d),
        (p.y[0] + 0.02, p.y[1] - 0.02),
        (bed + 0.001, p.h - 0.03),
        lean=(-0.18 * p.d, 0.0),
    )
    yield box("shelf", STEEL, (-0.3 * p.d, 0.28 * p.d), p.y, (p.h - 0.03, p.h))
    yield box("work top", STEEL, (p.x[0], -0.26 * p.d), (p.y[0] + 0.001, p.y[1] - 0.001), (bed, bed + 0.02))
    for y0 in (p.y[0] + 0.02, p.y[1] - 0.05):
        yield box("post", STEEL, (-0.28 * p.d, -0.25 * p.d), (y0, y0 + 0.03), (bed + 0.021, p.h - 0.03))


def produce_stand(p: Piece) -> Iterator[Part]:
    """Yield stepped crates of fruit and vegetables."""
    steps = 3
    tones = (RED, ORANGE, YELLOW, GREEN, LEAF, SPINES[0])
    for i in range(steps):
        x = (p.x[1] - (i + 1) * p.d / steps, p.x[1] - i * p.d / steps)
        level = (0.4 + 0.22 * i) * p.h
        yield box("step", p.wood, x, p.y, (0.0 if i == 2 else 0.1, level - 0.06))
        count = max(2, round(p.w / 0.42))
        for j in range(count):
            y = (p.y[0] + j * p.w / count + 0.01, p.y[0] + (j + 1) * p.w / count - 0.01)
            yield box("crate", p.dark, (x[0] + 0.01, x[1] - 0.01), y, (level - 0.06, level + 0.02))
            tone = tones[(i * 2 + j * 3) % 6]
            for k in range(6):
                a, b = x[0] + (0.28 + 0.44 * (k % 2)) * (x[1] - x[0]), y[0] + (0.2 + 0.3 * (k // 2)) * (y[1] - y[0])
                r = 0.16 * (y[1] - y[0])
                yield ball(
                    "fruit", tone, (a - r, a + r), (b - r, b + r), (level, min(level + 1.6 * r, p.h)), rings=3, sides=8
                )
    for x0 in (p.x[1] - 0.1, p.x[0] + 0.4 * p.d):
        for y0 in (p.y[0] + 0.03, p.y[1] - 0.08):
            yield box("leg", p.dark, (x0, x0 + 0.05), (y0, y0 + 0.05), (0.0, 0.1))
    yield box("sign", SLATE, (p.x[0], p.x[0] + 0.02), (0.5 * p.y[0], 0.5 * p.y[1]), (0.84 * p.h, p.h))


def vending_machine(p: Piece) -> Iterator[Part]:
    """Yield a vending machine with lit shelves of goods."""
    skin = (RED, p.accent, DARK)[p.variant % 3]
    yield box("body", skin, (p.x[0], p.x[1] - 0.12), p.y, (0.04, p.h))
    yield box("foot", BLACK, (p.x[0] + 0.03, p.x[1] - 0.1), (0.9 * p.y[0], 0.9 * p.y[1]), (0.0, 0.04))
    yield box("lower front", skin, (p.x[1] - 0.12, p.x[1] - 0.01), p.y, (0.04, 0.3 * p.h))
    yield box("hatch", BLACK, (p.x[1] - 0.01, p.x[1]), (0.8 * p.y[0], 0.2 * p.y[1]), (0.1 * p.h, 0.22 * p.h))
    yield box("panel", skin, (p.x[1] - 0.12, p.x[1] - 0.01), (0.44 * p.y[1], p.y[1]), (0.3 * p.h, p.h))
    yield box("screen", GLOW, (p.x[1] - 0.01, p.x[1] - 0.004), (0.55 * p.y[1], 0.9 * p.y[1]), (0.68 * p.h, 0.8 * p.h))
    yield box("coins", STEEL, (p.x[1] - 0.01, p.x[1] - 0.002), (0.6 * p.y[1], 0.85 * p.y[1]), (0.52 * p.h, 0.62 * p.h))
    inner = (p.y[0] + 0.02, 0.44 * p.y[1] - 0.02)
    for i in range(5):
        low = 0.31 * p.h + i * 0.132 * p.h
        yield box("shelf", STEEL, (p.x[1] - 0.12, p.x[1] - 0.03), inner, (low - 0.012, low))
        count = 5
        for j in range(count):
            y = inner[0] + (j + 0.5) * (inner[1] - inner[0]) / count
            yield box(
                "snack",
                (*BRIGHT, *SPINES)[(2 * i + 3 * j) % 13],
                (p.x[1] - 0.1, p.x[1] - 0.05),
                (y - 0.035, y + 0.035),
                (low, low + 0.1 * p.h),
            )
    yield box("header", YELLOW, (p.x[1] - 0.12, p.x[1] - 0.02), (p.y[0], 0.44 * p.y[1]), (0.965 * p.h, p.h))
    yield box(
        "glass",
        GLASS,
        (p.x[1] - 0.016, p.x[1] - 0.011),
        (p.y[0] + 0.01, 0.44 * p.y[1] - 0.004),
        (0.305 * p.h, 0.96 * p.h),
    )


def fitting_room(p: Piece) -> Iterator[Part]:
    """Yield a cubicle with a curtain and a mirror."""
    for y0 in (p.y[0], p.y[1] - 0.03):
        yield box("side", p.wood, p.x, (y0, y0 + 0.03), (0.0, p.h - 0.05))
    inner = (p.y[0] + 0.03, p.y[1] - 0.03)
    yield box("back", p.wood, (p.x[0], p.x[0] + 0.03), inner, (0.0, p.h - 0.05))
    yield box("mirror", GLOW, (p.x[0] + 0.03, p.x[0] + 0.04), (0.4 * p.y[0], 0.4 * p.y[1]), (0.2 * p.h, 0.86 * p.h))
    yield box("header", p.dark, (p.x[1] - 0.06, p.x[1]), p.y, (p.h - 0.05, p.h))
    for i in range(5):
        y = inner[0] + (i + 0.5) * 0.4 * p.w / 5
        yield oval("curtain", p.fabric, (p.x[1] - 0.04, y), ((0.04, 0.04 * p.w),) * 2, (0.05, p.h - 0.05), sides=8)
    yield box("seat", p.accent, (p.x[0] + 0.04, p.x[0] + 0.4), (inner[0], inner[0] + 0.35), (0.4, 0.46))


BUILDERS: dict[str, Builder] = {
    "shop shelf": shop_shelf,
    "display case": display_case,
    "mannequin": mannequin,
    "card rack": card_rack,
    "display fridge": display_fridge,
    "deli counter": deli_counter,
    "produce stand": produce_stand,
    "vending machine": vending_machine,
    "fitting room": fitting_room,
}
