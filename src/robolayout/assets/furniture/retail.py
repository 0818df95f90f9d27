"""Shops, restaurants, cafes and bars."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, board, four, open_case
from robolayout.assets.palette import (
    BLACK, BREAD, BRICK, BRIGHT, CERAMIC, CHROME, DARK, EMBER, GLASS, GLOW, GREEN, IVORY, LEAF, LIGHT_GREY, ORANGE, PAPER, RED, SLATE,
    SPINES, STEEL, WHITE, YELLOW, Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, oval, sheared, slab, soft


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
            yield cylinder("bottle", tone, ((x[0] + x[1]) / 2, at + width / 2), (r, 0.6 * r), (low, low + tall), sides=8)
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
        yield box("price rail", p.accent, (deep, deep + 0.008), (p.y[0] + 0.005, p.y[1] - 0.005), (low - 0.045, low - 0.003))
        yield from goods(p, p.y, low, (p.h - 0.14) / rows - 0.02, (p.x[0] + 0.03, deep - 0.02))


def display_case(p: Piece) -> Iterator[Part]:
    """Yield a glass counter with goods inside; customers stand at +x."""
    low = 0.42 * p.h
    yield box("base", p.wood, p.x, p.y, (0.06, low))
    yield box("plinth", DARK, (p.x[0] + 0.03, p.x[1] - 0.03), (p.y[0] + 0.03, p.y[1] - 0.03), (0.0, 0.06))
    for z in (low, low + 0.28 * p.h):
        if z > low:
            yield box("shelf", LIGHT_GREY, (p.x[0] + 0.04, p.x[1] - 0.06), (p.y[0] + 0.04, p.y[1] - 0.04), (z - 0.012, z))
        yield from goods(p, (p.y[0] + 0.05, p.y[1] - 0.05), z, 0.18 * p.h, (p.x[0] + 0.1, p.x[1] - 0.12))
    for x0, y0 in ((p.x[0], p.y[0]), (p.x[0], p.y[1] - 0.02), (p.x[1] - 0.02, p.y[0]), (p.x[1] - 0.02, p.y[1] - 0.02)):
        yield box("post", STEEL, (x0, x0 + 0.02), (y0, y0 + 0.02), (low, p.h - 0.03))
    yield box("front glass", GLASS, (p.x[1] - 0.012, p.x[1] - 0.006), (p.y[0] + 0.02, p.y[1] - 0.02), (low + 0.001, p.h - 0.03))
    yield box("top", p.wood, p.x, p.y, (p.h - 0.03, p.h))


def checkout(p: Piece) -> Iterator[Part]:
    """Yield a till counter with a belt, a scanner and a register; customers pass at +x."""
    top = 0.86 * p.h
    yield box("plinth", DARK, (0.9 * p.x[0], 0.9 * p.x[1]), (0.96 * p.y[0], 0.96 * p.y[1]), (0.0, 0.08))
    yield box("body", p.front, (0.96 * p.x[0], 0.96 * p.x[1]), (0.98 * p.y[0], 0.98 * p.y[1]), (0.08, top - 0.04))
    yield box("band", p.accent, (0.96 * p.x[1], 0.975 * p.x[1]), (0.9 * p.y[0], 0.9 * p.y[1]), (0.5 * top, 0.68 * top))
    yield box("top", LIGHT_GREY, p.x, p.y, (top - 0.04, top))
    yield box("belt", BLACK, (0.0, 0.86 * p.x[1]), (0.9 * p.y[0], 0.1 * p.y[1]), (top, top + 0.008))
    yield box("scanner", GLASS, (0.1 * p.d, 0.36 * p.d), (0.14 * p.w, 0.3 * p.w), (top + 0.001, top + 0.005))
    for i in range(3):
        y = (-0.36 + 0.13 * i) * p.w
        yield box("goods", BRIGHT[i], (0.12 * p.d, 0.28 * p.d), (y, y + 0.12), (top + 0.008, top + 0.08 + 0.02 * i))
    yield box("register", DARK, (-0.4 * p.d, -0.1 * p.d), (0.16 * p.w, 0.36 * p.w), (top, top + 0.06))
    yield sheared("display", BLACK, (-0.2 * p.d, -0.17 * p.d), (0.18 * p.w, 0.34 * p.w), (top + 0.06, p.h), lean=(0.03, 0.0))
    yield sheared("screen", GLOW, (-0.212 * p.d, -0.2 * p.d - 0.001), (0.19 * p.w, 0.33 * p.w), (top + 0.07, p.h - 0.005), lean=(0.028, 0.0))


def kiosk(p: Piece) -> Iterator[Part]:
    """Yield a self-service machine: pedestal, tilted screen, card reader."""
    yield box("foot", DARK, p.x, (0.9 * p.y[0], 0.9 * p.y[1]), (0.0, 0.04))
    yield soft("body", p.front if p.kind != "atm" else p.accent, (p.x[0] + 0.04, 0.24 * p.d), p.y, (0.04, 0.96 * p.h), bevel=0.03)
    yield sheared("panel", BLACK, (0.24 * p.d, 0.36 * p.d), (0.9 * p.y[0], 0.9 * p.y[1]), (0.56 * p.h, 0.92 * p.h), lean=(-0.1 * p.d, 0.0))
    yield sheared("screen", GLOW, (0.36 * p.d + 0.001, 0.375 * p.d), (0.8 * p.y[0], 0.8 * p.y[1]), (0.59 * p.h, 0.89 * p.h), lean=(-0.085 * p.d, 0.0))
    yield box("keys", STEEL, (0.24 * p.d, 0.46 * p.d), (0.4 * p.y[0], 0.4 * p.y[1]), (0.5 * p.h, 0.53 * p.h))
    yield box("slot", DARK, (0.24 * p.d, 0.27 * p.d), (0.5 * p.y[0], 0.5 * p.y[1]), (0.38 * p.h, 0.44 * p.h))
    yield box("sign", p.accent, (-0.1 * p.d, 0.2 * p.d), (0.6 * p.y[0], 0.6 * p.y[1]), (0.96 * p.h, p.h))


def cash_register(p: Piece) -> Iterator[Part]:
    """Yield a cash register with keys and a display; the cashier is at +x."""
    yield box("drawer", DARK, p.x, p.y, (0.0, 0.28 * p.h))
    body = box("body", LIGHT_GREY, (p.x[0] + 0.01, p.x[1] - 0.02), (0.94 * p.y[0], 0.94 * p.y[1]), (0.28 * p.h, 0.4 * p.h))
    body.vertices[(body.vertices[:, 2] > 0.35 * p.h) & (body.vertices[:, 0] < 0), 2] += 0.24 * p.h
    yield body
    yield box("display", BLACK, (0.76 * p.x[0], 0.5 * p.x[0]), (0.7 * p.y[0], 0.7 * p.y[1]), (0.6 * p.h, p.h))
    yield box("screen", GLOW, (0.5 * p.x[0], 0.49 * p.x[0]), (0.6 * p.y[0], 0.6 * p.y[1]), (0.72 * p.h, 0.96 * p.h))
    yield box("handle", STEEL, (p.x[1] - 0.001, p.x[1] + 0.008), (-0.06, 0.06), (0.12 * p.h, 0.17 * p.h))


def shopping_cart(p: Piece) -> Iterator[Part]:
    """Yield a trolley with a wire basket; it is pushed from behind."""
    low, high = 0.46 * p.h, 0.9 * p.h
    for x in (0.76 * p.x[0], 0.76 * p.x[1]):
        for y in (0.7 * p.y[0], 0.7 * p.y[1]):
            yield cylinder("wheel", BLACK, (0.06, x), 0.06, (y - 0.016, y + 0.016), axis="y", sides=12)
    yield box("frame", CHROME, (0.84 * p.x[0], 0.84 * p.x[1]), (0.74 * p.y[0], 0.74 * p.y[1]), (0.12, 0.15))
    for y in (0.7 * p.y[0], 0.66 * p.y[1]):
        yield sheared("post", CHROME, (0.8 * p.x[0], 0.8 * p.x[0] + 0.025), (y, y + 0.02), (0.15, p.h - 0.02), lean=(-0.08 * p.d, 0.0))
    yield box("basket floor", STEEL, (0.78 * p.x[0], 0.92 * p.x[1]), (0.8 * p.y[0], 0.8 * p.y[1]), (low, low + 0.012))
    bars = 7
    for i in range(bars):
        share = i / (bars - 1)
        x = (0.78 * p.x[0]) + share * (0.92 * p.x[1] - 0.78 * p.x[0] - 0.012)
        for y0, way in ((0.8 * p.y[0], -1), (0.8 * p.y[1] - 0.01, 1)):
            yield sheared("wire", CHROME, (x, x + 0.012), (y0, y0 + 0.01), (low + 0.012, high), lean=(0.06 * p.d * share, way * 0.1 * p.w))
    for i in range(4):
        y = 0.7 * p.y[0] + i * 0.44 * p.w / 2 * 1.06
        yield sheared("wire", CHROME, (0.92 * p.x[1] - 0.012, 0.92 * p.x[1]), (y, y + 0.01), (low + 0.012, high), lean=(0.06 * p.d, 0.0))
    for y in ((p.y[0], p.y[0] + 0.02), (p.y[1] - 0.02, p.y[1])):
        yield box("rim", CHROME, (0.9 * p.x[0], p.x[1]), y, (high, high + 0.018))
    yield box("rim", CHROME, (p.x[1] - 0.02, p.x[1]), (p.y[0] + 0.02, p.y[1] - 0.02), (high, high + 0.018))
    yield box("handle", RED, (p.x[0], p.x[0] + 0.04), p.y, (p.h - 0.035, p.h))
    yield box("goods", YELLOW, (-0.1 * p.d, 0.2 * p.d), (-0.2 * p.w, 0.1 * p.w), (low + 0.012, low + 0.2))


def basket_stack(p: Piece) -> Iterator[Part]:
    """Yield stacked hand baskets."""
    count = max(2, round(p.h / 0.1))
    for i in range(count):
        z = (i * 0.9 * p.h / count, (i + 0.85) * 0.9 * p.h / count)
        yield slab("basket", p.accent, (0.92 * p.x[0], 0.92 * p.x[1]), (0.92 * p.y[0], 0.92 * p.y[1]), z, top=(1.085, 1.085))
    for y in (0.3 * p.y[0], 0.26 * p.y[1]):
        yield box("handle", BLACK, (0.6 * p.x[0], 0.6 * p.x[1]), (y, y + 0.02 * p.w), (0.9 * p.h * (count - 0.15) / count, p.h))


def mannequin(p: Piece) -> Iterator[Part]:
    """Yield a dressed shop dummy on a foot plate."""
    d, w, h = p.d, p.w, p.h
    yield cylinder("foot", STEEL, (0.0, 0.0), 0.46 * d, (0.0, 0.02), sides=20)
    for side in (-1, 1):
        yield cylinder("leg", p.fabric, (0.0, side * 0.12 * w), (0.06, 0.085), (0.04 * h, 0.5 * h), sides=10)
        yield box("shoe", BLACK, (-0.06, 0.14), (side * 0.12 * w - 0.04, side * 0.12 * w + 0.04), (0.02, 0.045 * h + 0.02))
        yield sheared("arm", IVORY, (-0.04, 0.04), (side * 0.46 * w - 0.035, side * 0.46 * w + 0.035), (0.44 * h, 0.8 * h), lean=(0.0, -side * 0.12 * w))
    yield oval("hips", p.accent, (0.0, 0.0), ((0.26 * d, 0.32 * w), (0.22 * d, 0.24 * w)), (0.48 * h, 0.62 * h), sides=16)
    yield oval("chest", p.accent, (0.0, 0.0), ((0.22 * d, 0.24 * w), (0.28 * d, 0.38 * w)), (0.62 * h, 0.8 * h), sides=16)
    yield oval("shoulders", p.accent, (0.0, 0.0), ((0.28 * d, 0.38 * w), (0.12 * d, 0.14 * w)), (0.8 * h, 0.845 * h), sides=16)
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
        yield from _bottles(p, inner, low, 0.7 * span / rows, p.x[1] - 0.16)
    for i in range(n := max(1, round(p.w / 0.62))):
        y0 = p.y[0] + i * p.w / n
        yield box("door", GLASS, (p.x[1] - 0.026, p.x[1] - 0.02), (y0 + 0.004, y0 + p.w / n - 0.004), (0.145, p.h - 0.165))
        yield box("handle", CHROME, (p.x[1] - 0.019, p.x[1] - 0.001), (y0 + 0.03, y0 + 0.05), (0.4 * p.h, 0.64 * p.h))


def _bottles(p: Piece, y: tuple[float, float], low: float, tall: float, x: float) -> Iterator[Part]:
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
            yield soft("food", tones[(2 * i + (x > 0)) % 6], (x - 0.11 * p.d, x + 0.11 * p.d), (y - 0.1, y + 0.1), (bed + 0.03, bed + 0.09), bevel=0.025)
    for y0 in (p.y[0], p.y[1] - 0.02):
        yield sheared("glass side", GLASS, (-0.24 * p.d, 0.46 * p.d), (y0, y0 + 0.008), (bed + 0.001, p.h - 0.03), lean=(-0.04, 0.0))
    yield sheared("glass", GLASS, (0.44 * p.d, 0.45 * p.d), (p.y[0] + 0.02, p.y[1] - 0.02), (bed + 0.001, p.h - 0.03), lean=(-0.18 * p.d, 0.0))
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
                yield ball("fruit", tone, (a - r, a + r), (b - r, b + r), (level, min(level + 1.6 * r, p.h)), rings=3, sides=8)
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
            yield box("snack", (*BRIGHT, *SPINES)[(2 * i + 3 * j) % 13], (p.x[1] - 0.1, p.x[1] - 0.05), (y - 0.035, y + 0.035), (low, low + 0.1 * p.h))
    yield box("header", YELLOW, (p.x[1] - 0.12, p.x[1] - 0.02), (p.y[0], 0.44 * p.y[1]), (0.965 * p.h, p.h))
    yield box("glass", GLASS, (p.x[1] - 0.016, p.x[1] - 0.011), (p.y[0] + 0.01, 0.44 * p.y[1] - 0.004), (0.305 * p.h, 0.96 * p.h))


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


def work_table(p: Piece) -> Iterator[Part]:
    """Yield a work table with rolls of paper and tools on it."""
    top = p.h - 0.16
    steel = p.kind in {"prep table"}
    tone = STEEL if steel else p.wood
    yield box("top", tone, p.x, p.y, (top - 0.04, top))
    yield from four(p, STEEL if steel else p.dark, top - 0.04, thick=0.06, inset=0.02)
    yield box("shelf", tone, (0.86 * p.x[0], 0.86 * p.x[1]), (p.y[0] + 0.09, p.y[1] - 0.09), (0.18 * p.h, 0.18 * p.h + 0.03))
    for i in range(3):
        y = (-0.34 + 0.1 * i) * p.w
        if steel:
            yield cylinder("bowl", STEEL, (0.06, y * 1.2), (0.05, 0.09), (top, top + 0.08), sides=14)
        else:
            yield cylinder("roll", (p.accent, PAPER, p.bedding)[i], (top + 0.045, -0.3 * p.d + 0.1 * i), 0.045, (-0.44 * p.w, 0.06 * p.w), axis="y", sides=12)
    yield box("box", p.accent, (-0.1 * p.d, 0.2 * p.d), (0.22 * p.w, 0.38 * p.w), (top, p.h))


def a_sign(p: Piece) -> Iterator[Part]:
    """Yield a folding sign with chalk writing on both sides."""
    for way in (1, -1):
        x0 = p.x[1] - 0.03 if way > 0 else p.x[0]
        lean = (-way * (p.d / 2 - 0.03), 0.0)
        yield sheared("frame", p.wood, (x0, x0 + 0.03), p.y, (0.0, p.h), lean=lean)
        face = (x0 + 0.031, x0 + 0.036) if way > 0 else (x0 - 0.006, x0 - 0.001)
        part = box("board", SLATE, face, (0.88 * p.y[0], 0.88 * p.y[1]), (0.14 * p.h, 0.94 * p.h))
        part.vertices[:, 0] -= way * (p.d / 2 - 0.03) * part.vertices[:, 2] / p.h
        yield part
        for i in range(4):
            z = (0.76 - 0.15 * i) * p.h
            line = (face[0] + 0.006 * way, face[1] + 0.006 * way)
            text = box("writing", IVORY, line, ((-0.3 + 0.04 * i) * p.w, (0.3 - 0.05 * i) * p.w), (z, z + 0.03 * p.h))
            text.vertices[:, 0] -= way * (p.d / 2 - 0.03) * text.vertices[:, 2] / p.h
            yield text


def menu_board(p: Piece) -> Iterator[Part]:
    """Yield a wall menu in three columns."""
    yield box("frame", p.dark, (p.x[0], p.x[0] + 0.5 * p.d), p.y, p.z)
    yield box("board", SLATE, (p.x[0] + 0.5 * p.d, p.x[0] + 0.8 * p.d), (0.95 * p.y[0], 0.95 * p.y[1]), (0.05 * p.h, 0.95 * p.h))
    for j in range(3):
        y = (-0.44 + 0.3 * j) * p.w
        for i in range(6):
            z = (0.72 - 0.11 * i) * p.h
            yield box("text", YELLOW if i == 0 else IVORY, (p.x[0] + 0.8 * p.d, p.x[1]), (y, y + (0.24 - 0.03 * ((i + j) % 3)) * p.w), (z, z + 0.04 * p.h))
    yield box("title", ORANGE, (p.x[0] + 0.8 * p.d, p.x[1]), (-0.2 * p.w, 0.2 * p.w), (0.83 * p.h, 0.9 * p.h))


def barrier(p: Piece) -> Iterator[Part]:
    """Yield two posts with a belt between them."""
    r = p.d / 2
    for y in (p.y[0] + r, p.y[1] - r):
        yield cylinder("foot", CHROME, (0.0, y), (r, 0.9 * r), (0.0, 0.03), sides=20)
        yield cylinder("post", CHROME, (0.0, y), 0.03, (0.03, 0.97 * p.h), sides=12)
        yield cylinder("cap", BLACK, (0.0, y), 0.04, (0.97 * p.h, p.h), sides=12)
    yield box("belt", RED, (-0.004, 0.004), (p.y[0] + r + 0.03, p.y[1] - r - 0.03), (0.86 * p.h, 0.93 * p.h))


def slicer(p: Piece) -> Iterator[Part]:
    """Yield a slicing machine with a round blade."""
    yield soft("base", STEEL, p.x, p.y, (0.0, 0.24 * p.h), bevel=0.02)
    yield cylinder("blade", CHROME, (0.58 * p.h, 0.06 * p.d), 0.36 * p.h, (-0.02 * p.w, 0.02 * p.w), axis="y", sides=22)
    yield box("housing", STEEL, (-0.3 * p.d, 0.1 * p.d), (-0.24 * p.w, -0.03 * p.w), (0.24 * p.h, p.h))
    yield box("carriage", STEEL, (-0.3 * p.d, 0.36 * p.d), (0.1 * p.w, 0.44 * p.w), (0.3 * p.h, 0.34 * p.h))
    yield soft("ham", RED, (-0.16 * p.d, 0.2 * p.d), (0.06 * p.w, 0.4 * p.w), (0.34 * p.h, 0.62 * p.h), bevel=0.05)


def buffet(p: Piece) -> Iterator[Part]:
    """Yield a clothed table with chafing dishes and bowls."""
    top = p.h - 0.2
    yield slab("cloth", p.bedding, p.x, p.y, (0.0, top), top=(0.96, 0.985))
    yield board(Piece(p.d * 0.955, p.w * 0.983, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, 0, p.key), p.accent, (top + 0.001, top + 0.006))
    yield from _dishes(p, top + 0.006, p.h)


def _dishes(p: Piece, low: float, high: float) -> Iterator[Part]:
    """Yield serving dishes along a counter."""
    tones = (ORANGE, LEAF, BREAD, YELLOW, RED, IVORY)
    count = max(2, round(p.w / 0.42))
    for i in range(count):
        y = 0.9 * (p.y[0] + (i + 0.5) * p.w / count)
        half = min(0.17, 0.36 * p.w / count)
        if i % 3 == 1:
            yield cylinder("bowl", CERAMIC, (0.0, y), (0.5 * half, half), (low, low + 0.09), sides=18)
            yield cylinder("salad", tones[(i + p.variant) % 6], (0.0, y), (0.9 * half, 0.4 * half), (low + 0.09, low + 0.13), sides=18)
        else:
            yield box("pan", STEEL, (-0.14, 0.14), (y - half, y + half), (low, low + 0.09))
            yield box("food", tones[(i + p.variant) % 6], (-0.125, 0.125), (y - 0.9 * half, y + 0.9 * half), (low + 0.09, low + 0.1))
            if i % 2 == 0:
                yield slab("lid", CHROME, (-0.14, -0.02), (y - half, y + half), (low + 0.1, high), top=(0.6, 0.9))


def buffet_counter(p: Piece) -> Iterator[Part]:
    """Yield a food counter with wells, a sneeze guard and a tray rail; guests at +x."""
    top = 0.66 * p.h
    rail = 0.22
    body = (p.x[0], p.x[1] - rail)
    yield box("plinth", DARK, (body[0] + 0.04, body[1] - 0.04), (p.y[0] + 0.03, p.y[1] - 0.03), (0.0, 0.1))
    yield box("body", p.wood, body, (p.y[0] + 0.01, p.y[1] - 0.01), (0.1, top - 0.03))
    yield box("band", p.accent, (body[1], body[1] + 0.012), (p.y[0] + 0.05, p.y[1] - 0.05), (0.3 * top, 0.7 * top))
    yield box("top", STEEL, (body[0], body[1] + 0.02), p.y, (top - 0.029, top))
    for i in range(3):
        x = body[1] + 0.04 + 0.06 * i
        yield cylinder("tray rail", CHROME, (top - 0.06, x), 0.012, p.y, axis="y", sides=8)
    yield box("tray end", CHROME, (body[1] + 0.02, p.x[1]), (-0.01, 0.01), (top - 0.1, top - 0.075))
    moved_piece = Piece(p.d, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    for part in _dishes(moved_piece, top, top + 0.18):
        part.vertices[:, 0] += (body[0] + body[1]) / 2
        yield part
    for y in (p.y[0] + 0.04, p.y[1] - 0.06):
        yield box("post", CHROME, (body[1] - 0.16, body[1] - 0.14), (y, y + 0.02), (top, p.h - 0.03))
    yield sheared("guard", GLASS, (body[1] - 0.02, body[1] - 0.01), (p.y[0] + 0.03, p.y[1] - 0.03), (top + 0.2, p.h - 0.03), lean=(-0.12, 0.0))
    yield box("lamp bar", CHROME, (body[0] + 0.12, body[1] - 0.1), (p.y[0] + 0.02, p.y[1] - 0.02), (p.h - 0.029, p.h))


def bar_counter(p: Piece) -> Iterator[Part]:
    """Yield a bar with panels, a foot rail, a tap and glasses; guests at +x."""
    top = p.h - 0.2
    yield box("body", p.dark, (p.x[0] + 0.04, p.x[1] - 0.16), (p.y[0] + 0.02, p.y[1] - 0.02), (0.0, top - 0.05))
    yield box("top", p.wood, p.x, p.y, (top - 0.049, top))
    count = max(2, round(p.w / 0.5))
    for i in range(count):
        y = (p.y[0] + 0.04 + i * (p.w - 0.08) / count + 0.03, p.y[0] + 0.04 + (i + 1) * (p.w - 0.08) / count - 0.03)
        yield box("panel", p.wood, (p.x[1] - 0.16, p.x[1] - 0.145), y, (0.2 * top, 0.88 * top))
    yield cylinder("foot rail", CHROME, (0.16, p.x[1] - 0.08), 0.02, (p.y[0] + 0.05, p.y[1] - 0.05), axis="y", sides=10)
    yield cylinder("tap", CHROME, (-0.1 * p.d, 0.2 * p.w), 0.03, (top, p.h), sides=12)
    yield box("tap head", CHROME, (-0.1 * p.d - 0.02, -0.1 * p.d + 0.02), (0.2 * p.w - 0.12, 0.2 * p.w + 0.12), (p.h - 0.05, p.h - 0.01))
    for i in range(3):
        yield cylinder("glass", GLASS, (0.1 * p.d, (-0.3 + 0.05 * i) * p.w), (0.026, 0.034), (top + 0.001, top + 0.13), sides=10)
    for i in range(3):
        yield cylinder("bottle", SPINES[i], (-0.2 * p.d, (-0.1 + 0.05 * i) * p.w), (0.036, 0.015), (top, p.h - 0.01), sides=10)


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
        yield from _bottles(p, (p.y[0] + 0.06, p.y[1] - 0.06), level, 0.2 * (p.h - low), p.x[0] + 0.24 * p.d)


def chafing_dish(p: Piece) -> Iterator[Part]:
    """Yield a chafing dish with an open lid."""
    low = 0.4 * p.h
    yield from four(p, CHROME, low, thick=0.03, inset=0.02)
    yield box("pan", CHROME, p.x, p.y, (low, 0.62 * p.h))
    yield box("food", ORANGE, (0.9 * p.x[0], 0.9 * p.x[1]), (0.92 * p.y[0], 0.92 * p.y[1]), (0.62 * p.h, 0.66 * p.h))
    yield slab("lid", CHROME, (0.94 * p.x[0], 0.0), (0.96 * p.y[0], 0.96 * p.y[1]), (0.661 * p.h, p.h), top=(0.6, 0.84))
    for y in (-0.22 * p.w, 0.22 * p.w):
        yield cylinder("burner", EMBER, (0.0, y), 0.04, (0.0, 0.14 * p.h), sides=12)


def dispenser(p: Piece) -> Iterator[Part]:
    """Yield a drinks dispenser: two tanks over taps."""
    yield soft("base", STEEL, p.x, p.y, (0.0, 0.12 * p.h), bevel=0.01)
    yield box("body", DARK, (p.x[0] + 0.01, 0.2 * p.d), (0.94 * p.y[0], 0.94 * p.y[1]), (0.12 * p.h, 0.46 * p.h))
    for i, y in enumerate((-0.24 * p.w, 0.24 * p.w)):
        yield box("juice", (ORANGE, RED)[i], (-0.36 * p.d, 0.3 * p.d), (y - 0.18 * p.w, y + 0.18 * p.w), (0.46 * p.h, 0.8 * p.h))
        yield box("tank", GLASS, (-0.38 * p.d, 0.32 * p.d), (y - 0.2 * p.w, y + 0.2 * p.w), (0.465 * p.h, 0.92 * p.h))
        yield box("lid", BLACK, (-0.4 * p.d, 0.34 * p.d), (y - 0.21 * p.w, y + 0.21 * p.w), (0.92 * p.h, p.h))
        yield box("tap", CHROME, (0.2 * p.d, 0.34 * p.d), (y - 0.03, y + 0.03), (0.3 * p.h, 0.36 * p.h))


def tray_cart(p: Piece) -> Iterator[Part]:
    """Yield a rack of trays on castors."""
    for x0 in (p.x[0], p.x[1] - 0.03):
        for y0 in (p.y[0], p.y[1] - 0.03):
            yield box("post", STEEL, (x0, x0 + 0.03), (y0, y0 + 0.03), (0.1, p.h))
            yield cylinder("castor", BLACK, (0.05, x0 + 0.015), 0.05, (y0, y0 + 0.03), axis="y", sides=10)
    count = max(4, min(12, round(p.h / 0.15)))
    for i in range(count):
        z = 0.14 + i * (p.h - 0.18) / count
        yield box("tray", p.accent if i % 2 else p.bedding, (0.94 * p.x[0], 0.94 * p.x[1]), (p.y[0] + 0.035, p.y[1] - 0.035), (z, z + 0.02))
        if i % 3 == 0:
            yield cylinder("plate", CERAMIC, (0.0, -0.1 * p.w), 0.12, (z + 0.02, z + 0.035), sides=16)
    yield box("roof", STEEL, (p.x[0] + 0.001, p.x[1] - 0.001), (p.y[0] + 0.03, p.y[1] - 0.03), (p.h - 0.02, p.h))


def oven(p: Piece) -> Iterator[Part]:
    """Yield a pizza oven: a brick dome on a stand with a fire."""
    low = 0.5 * p.h
    yield box("stand", p.dark, (0.94 * p.x[0], 0.94 * p.x[1]), (0.94 * p.y[0], 0.94 * p.y[1]), (0.0, low - 0.05))
    yield box("slab", LIGHT_GREY, p.x, p.y, (low - 0.05, low))
    yield oval("dome", BRICK, (-0.04 * p.d, 0.0), ((0.44 * p.d, 0.46 * p.w), (0.4 * p.d, 0.42 * p.w)), (low, 0.72 * p.h), sides=20)
    yield oval("dome", BRICK, (-0.04 * p.d, 0.0), ((0.4 * p.d, 0.42 * p.w), (0.14 * p.d, 0.16 * p.w)), (0.72 * p.h, 0.88 * p.h), sides=20)
    yield cylinder("chimney", STEEL, (0.1 * p.d, 0.0), 0.07, (0.8 * p.h, p.h), sides=12)
    yield box("mouth", BRICK, (0.2 * p.d, 0.44 * p.d), (-0.28 * p.w, 0.28 * p.w), (low, 0.7 * p.h))
    yield box("opening", BLACK, (0.44 * p.d, 0.445 * p.d), (-0.2 * p.w, 0.2 * p.w), (low + 0.01, 0.66 * p.h))
    yield ball("fire", EMBER, (0.443 * p.d, 0.46 * p.d), (-0.1 * p.w, 0.1 * p.w), (low + 0.01, low + 0.09), rings=3, sides=8)


def grill(p: Piece) -> Iterator[Part]:
    """Yield a barbecue on a cart with a lid."""
    low = 0.62 * p.h
    yield from four(p, DARK, low, thick=0.05, inset=0.03)
    yield box("shelf", p.wood, (0.8 * p.x[0], 0.8 * p.x[1]), (0.84 * p.y[0], 0.84 * p.y[1]), (0.2 * p.h, 0.23 * p.h))
    yield box("bowl", BLACK, (0.9 * p.x[0], 0.9 * p.x[1]), (-0.32 * p.w, 0.32 * p.w), (low, 0.76 * p.h))
    yield slab("lid", BLACK, (0.9 * p.x[0], 0.9 * p.x[1]), (-0.32 * p.w, 0.32 * p.w), (0.762 * p.h, p.h), top=(0.6, 0.9))
    yield box("handle", CHROME, (0.84 * p.x[1], p.x[1]), (-0.2 * p.w, 0.2 * p.w), (0.82 * p.h, 0.85 * p.h))
    for y in ((p.y[0], -0.33 * p.w), (0.33 * p.w, p.y[1])):
        yield box("side table", p.wood, (0.8 * p.x[0], 0.8 * p.x[1]), y, (0.72 * p.h, 0.75 * p.h))


BUILDERS: dict[str, Builder] = {
    "shop shelf": shop_shelf,
    "display case": display_case,
    "checkout counter": checkout,
    "self checkout": kiosk,
    "atm": kiosk,
    "cash register": cash_register,
    "shopping cart": shopping_cart,
    "shopping baskets": basket_stack,
    "mannequin": mannequin,
    "card rack": card_rack,
    "display fridge": display_fridge,
    "deli counter": deli_counter,
    "produce stand": produce_stand,
    "vending machine": vending_machine,
    "fitting room": fitting_room,
    "wrapping table": work_table,
    "prep table": work_table,
    "a frame sign": a_sign,
    "menu board": menu_board,
    "queue barrier": barrier,
    "meat slicer": slicer,
    "buffet table": buffet,
    "buffet counter": buffet_counter,
    "bar counter": bar_counter,
    "back bar": back_bar,
    "chafing dish": chafing_dish,
    "beverage dispenser": dispenser,
    "tray return": tray_cart,
    "pizza oven": oven,
    "grill": grill,
}
