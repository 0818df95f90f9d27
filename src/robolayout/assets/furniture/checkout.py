"""Tills, carts and what stands at the front of a shop."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, four
from robolayout.assets.palette import (
    BLACK,
    CHROME,
    DARK,
    GLOW,
    IVORY,
    LIGHT_GREY,
    PAPER,
    RED,
    SCREEN,
    SLATE,
    STEEL,
    YELLOW,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, sheared, slab, soft


def checkout(p: Piece) -> Iterator[Part]:
    """Yield a till counter with a belt and a scanner flush with its top; customers pass at +x."""
    yield box("plinth", DARK, (0.9 * p.x[0], 0.9 * p.x[1]), (0.96 * p.y[0], 0.96 * p.y[1]), (0.0, 0.08))
    yield box("body", p.front, (0.96 * p.x[0], 0.96 * p.x[1]), (0.98 * p.y[0], 0.98 * p.y[1]), (0.08, p.h - 0.04))
    yield box("band", p.accent, (0.96 * p.x[1], 0.975 * p.x[1]), (0.9 * p.y[0], 0.9 * p.y[1]), (0.5 * p.h, 0.66 * p.h))
    yield box("top", LIGHT_GREY, p.x, p.y, (p.h - 0.04, p.h - 0.003))
    yield box("belt", BLACK, (0.0, 0.86 * p.x[1]), (0.9 * p.y[0], 0.1 * p.y[1]), (p.h - 0.003, p.h))
    yield box("scanner", SCREEN, (0.1 * p.d, 0.36 * p.d), (0.14 * p.w, 0.3 * p.w), (p.h - 0.003, p.h - 0.001))
    yield box("staff shelf", p.wood, (p.x[0], 0.96 * p.x[0]), (0.9 * p.y[0], 0.9 * p.y[1]), (0.6 * p.h, 0.64 * p.h))


def kiosk(p: Piece) -> Iterator[Part]:
    """Yield a self-service machine: pedestal, tilted screen, card reader."""
    yield box("foot", DARK, p.x, (0.9 * p.y[0], 0.9 * p.y[1]), (0.0, 0.04))
    yield soft(
        "body",
        p.front if p.kind != "atm" else p.accent,
        (p.x[0] + 0.04, 0.24 * p.d),
        p.y,
        (0.04, 0.96 * p.h),
        bevel=0.03,
    )
    yield sheared(
        "panel",
        BLACK,
        (0.24 * p.d, 0.36 * p.d),
        (0.9 * p.y[0], 0.9 * p.y[1]),
        (0.56 * p.h, 0.92 * p.h),
        lean=(-0.1 * p.d, 0.0),
    )
    yield sheared(
        "screen",
        GLOW,
        (0.36 * p.d + 0.001, 0.375 * p.d),
        (0.8 * p.y[0], 0.8 * p.y[1]),
        (0.59 * p.h, 0.89 * p.h),
        lean=(-0.085 * p.d, 0.0),
    )
    yield box("keys", STEEL, (0.24 * p.d, 0.46 * p.d), (0.4 * p.y[0], 0.4 * p.y[1]), (0.5 * p.h, 0.53 * p.h))
    yield box("slot", DARK, (0.24 * p.d, 0.27 * p.d), (0.5 * p.y[0], 0.5 * p.y[1]), (0.38 * p.h, 0.44 * p.h))
    yield box("sign", p.accent, (-0.1 * p.d, 0.2 * p.d), (0.6 * p.y[0], 0.6 * p.y[1]), (0.96 * p.h, p.h))


def cash_register(p: Piece) -> Iterator[Part]:
    """Yield a cash register with keys and a display; the cashier is at +x."""
    yield box("drawer", DARK, p.x, p.y, (0.0, 0.28 * p.h))
    body = box(
        "body", LIGHT_GREY, (p.x[0] + 0.01, p.x[1] - 0.02), (0.94 * p.y[0], 0.94 * p.y[1]), (0.28 * p.h, 0.4 * p.h)
    )
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
        yield sheared(
            "post",
            CHROME,
            (0.8 * p.x[0], 0.8 * p.x[0] + 0.025),
            (y, y + 0.02),
            (0.15, p.h - 0.02),
            lean=(-0.08 * p.d, 0.0),
        )
    yield box("basket floor", STEEL, (0.78 * p.x[0], 0.92 * p.x[1]), (0.8 * p.y[0], 0.8 * p.y[1]), (low, low + 0.012))
    bars = 7
    for i in range(bars):
        share = i / (bars - 1)
        x = (0.78 * p.x[0]) + share * (0.92 * p.x[1] - 0.78 * p.x[0] - 0.012)
        for y0, way in ((0.8 * p.y[0], -1), (0.8 * p.y[1] - 0.01, 1)):
            yield sheared(
                "wire",
                CHROME,
                (x, x + 0.012),
                (y0, y0 + 0.01),
                (low + 0.012, high),
                lean=(0.06 * p.d * share, way * 0.1 * p.w),
            )
    for i in range(4):
        y = 0.7 * p.y[0] + i * 0.44 * p.w / 2 * 1.06
        yield sheared(
            "wire",
            CHROME,
            (0.92 * p.x[1] - 0.012, 0.92 * p.x[1]),
            (y, y + 0.01),
            (low + 0.012, high),
            lean=(0.06 * p.d, 0.0),
        )
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
        yield slab(
            "basket", p.accent, (0.92 * p.x[0], 0.92 * p.x[1]), (0.92 * p.y[0], 0.92 * p.y[1]), z, top=(1.085, 1.085)
        )
    for y in (0.3 * p.y[0], 0.26 * p.y[1]):
        yield box(
            "handle",
            BLACK,
            (0.6 * p.x[0], 0.6 * p.x[1]),
            (y, y + 0.02 * p.w),
            (0.9 * p.h * (count - 0.15) / count, p.h),
        )


def work_table(p: Piece) -> Iterator[Part]:
    """Yield a clear work table with rolls of paper or bowls on the shelf below it."""
    top = p.h
    steel = p.kind in {"prep table"}
    tone = STEEL if steel else p.wood
    yield box("top", tone, p.x, p.y, (top - 0.04, top))
    yield from four(p, STEEL if steel else p.dark, top - 0.04, thick=0.06, inset=0.02)
    yield box(
        "shelf", tone, (0.86 * p.x[0], 0.86 * p.x[1]), (p.y[0] + 0.09, p.y[1] - 0.09), (0.18 * p.h, 0.18 * p.h + 0.03)
    )
    low = 0.18 * p.h + 0.03
    for i in range(3):
        if steel:
            yield cylinder("bowl", STEEL, (0.0, (-0.3 + 0.2 * i) * p.w), (0.06, 0.11), (low, low + 0.1), sides=14)
        else:
            tint, at = (p.accent, PAPER, p.bedding)[i], (low + 0.05, -0.24 * p.d + 0.12 * i)
            yield cylinder("roll", tint, at, 0.05, (-0.36 * p.w, 0.1 * p.w), axis="y", sides=12)
    yield box("box", p.accent, (-0.2 * p.d, 0.2 * p.d), (0.2 * p.w, 0.36 * p.w), (low, low + 0.2 * p.h))


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


BUILDERS: dict[str, Builder] = {
    "checkout counter": checkout,
    "self checkout": kiosk,
    "atm": kiosk,
    "cash register": cash_register,
    "shopping cart": shopping_cart,
    "shopping baskets": basket_stack,
    "wrapping table": work_table,
    "prep table": work_table,
    "a frame sign": a_sign,
    "queue barrier": barrier,
    "meat slicer": slicer,
}
