"""Beds and what stands beside them."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import DOOR, KNOB, Builder, board, carcass, doors, drawers, four, plinth
from robolayout.assets.palette import LINEN, MIRROR, WHITE, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, slab, soft


def _bedding(p: Piece, x0: float, x1: float, low: float, high: float, *, inset: float = 0.0) -> Iterator[Part]:
    """Yield mattress, duvet and pillows; the head is at x0."""
    half = p.w / 2 - inset
    mattress = low + 0.72 * (high - low)
    yield soft("mattress", WHITE, (x0 + 0.004, x1 - 0.012), (-half + 0.02, half - 0.02), (low, mattress), bevel=0.03)
    fold = x0 + 0.36 * (x1 - x0)
    yield soft("duvet", p.bedding, (fold, x1), (-half + 0.002, half - 0.002), (low + 0.02, mattress + 0.05), bevel=0.04)
    cuff = (fold - 0.02, fold + 0.14 * (x1 - x0))
    yield soft("cuff", LINEN, cuff, (-half, half), (low + 0.08, mattress + 0.06), bevel=0.03)
    count = 2 if half > 0.6 else 1
    wide = min(0.62, (2 * half - 0.1) / count - 0.04)
    for i in range(count):
        middle = (i - (count - 1) / 2) * (wide + 0.06)
        span = (x0 + 0.03, min(x0 + 0.42, fold - 0.03))
        yield soft("pillow", LINEN, span, (middle - wide / 2, middle + wide / 2), (mattress - 0.005, high), bevel=0.06)


def bed(p: Piece) -> Iterator[Part]:
    """Yield a bed with headboard; its head is at the back."""
    tall = p.h > 0.62
    top = min(0.62, 0.68 * p.h) if tall else p.h
    board_x = p.x[0] + (0.07 if tall else 0.02)
    upholstered = p.variant % 3 == 0
    frame = p.fabric if upholstered else p.wood
    if tall:
        if upholstered:
            for i in range(n := max(2, round(p.w / 0.4))):
                y0, y1 = p.y[0] + i * p.w / n, p.y[0] + (i + 1) * p.w / n
                yield soft("headboard", frame, (p.x[0], board_x), (y0 + 0.002, y1 - 0.002), (0.1, p.h), bevel=0.02)
        else:
            yield box("headboard", frame, (p.x[0], board_x - 0.02), (p.y[0] + 0.03, p.y[1] - 0.03), (0.2, p.h - 0.03))
            yield box("rail", p.dark, (p.x[0] + 0.001, board_x), p.y, (p.h - 0.05, p.h))
            for y0 in (p.y[0], p.y[1] - 0.05):
                yield box("post", p.dark, (p.x[0] + 0.003, board_x - 0.002), (y0, y0 + 0.05), (0.0, p.h - 0.05))
    low = 0.42 * top
    under = 0.5 * low  # what a vacuum cleaner needs to drive beneath
    yield box("frame", frame, (board_x, p.x[1]), p.y, (under, low))
    for x in (board_x + 0.08, p.x[1] - 0.12):
        for y in (p.y[0] + 0.06, p.y[1] - 0.1):
            yield box("leg", p.dark, (x, x + 0.05), (y, y + 0.05), (0.0, under))
    yield from _bedding(p, board_x, p.x[1] - 0.02, low, top, inset=0.012)


def bunk_bed(p: Piece) -> Iterator[Part]:
    """Yield two beds above each other with a ladder at the right front."""
    t = 0.06
    for x0 in (p.x[0], p.x[1] - t):
        for y0 in (p.y[0], p.y[1] - t):
            yield box("post", p.wood, (x0, x0 + t), (y0, y0 + t), (0.0, p.h))
    for low in (0.16 * p.h, 0.62 * p.h):
        yield box("frame", p.wood, (p.x[0] + 0.003, p.x[1] - 0.003), (p.y[0] + 0.003, p.y[1] - 0.003), (low, low + 0.1))
        yield from _bedding(p, p.x[0] + t, p.x[1] - t, low + 0.1, low + 0.1 + min(0.24, 0.16 * p.h), inset=0.06)
    rail = (0.82 * p.h, 0.87 * p.h)
    yield box("guard", p.wood, (p.x[0] + t, p.x[1] - t), (p.y[0] + 0.004, p.y[0] + 0.024), rail)
    yield box("guard", p.wood, (p.x[0] + t, p.x[1] - 0.6), (p.y[1] - 0.024, p.y[1] - 0.004), rail)
    for y0 in (p.y[1] - 0.05,):
        for i in range(5):
            z = 0.1 * p.h + i * 0.16 * p.h
            yield box("rung", p.dark, (p.x[1] - 0.5, p.x[1] - 0.1), (y0 + 0.054, y0 + 0.085), (z, z + 0.03))
    for x0 in (p.x[1] - 0.53, p.x[1] - 0.1):
        yield box("ladder", p.dark, (x0, x0 + 0.03), (p.y[1] + 0.002, p.y[1] + 0.037), (0.0, 0.9 * p.h))


def loft_bed(p: Piece) -> Iterator[Part]:
    """Yield a high bed with a desk below."""
    t = 0.07
    for x0 in (p.x[0], p.x[1] - t):
        for y0 in (p.y[0], p.y[1] - t):
            yield box("post", p.wood, (x0, x0 + t), (y0, y0 + t), (0.0, p.h))
    low = 0.72 * p.h
    yield box("frame", p.wood, (p.x[0] + 0.003, p.x[1] - 0.003), (p.y[0] + 0.003, p.y[1] - 0.003), (low, low + 0.1))
    yield from _bedding(p, p.x[0] + t, p.x[1] - t, low + 0.1, low + 0.3, inset=0.06)
    desk = 0.39 * p.h
    yield box(
        "desk top", p.dark, (p.x[0] + 0.08, p.x[1] - 0.3), (p.y[0] + 0.01, p.y[0] + 0.6 * p.w), (desk - 0.03, desk)
    )
    for z in (0.86 * p.h, 0.94 * p.h):
        for y0 in (p.y[0] + 0.004, p.y[1] - 0.024):
            yield box("guard", p.wood, (p.x[0] + t, p.x[1] - t), (y0, y0 + 0.02), (z, z + 0.04))


def crib(p: Piece) -> Iterator[Part]:
    """Yield a cot with bars on both long sides."""
    t, low, high = 0.045, 0.25 * p.h, 0.9 * p.h
    for x0 in (p.x[0], p.x[1] - t):
        for y0 in (p.y[0], p.y[1] - t):
            yield box("post", p.front, (x0, x0 + t), (y0, y0 + t), (0.0, p.h))
        yield box("end", p.front, (x0 + 0.01, x0 + t - 0.01), (p.y[0] + t, p.y[1] - t), (low, high + 0.03))
    count = max(5, int((p.d - 2 * t) / 0.1))
    for y0 in (p.y[0] + 0.01, p.y[1] - t + 0.01):
        for z in (low, high):
            yield box("rail", p.wood, (p.x[0] + t, p.x[1] - t), (y0, y0 + 0.025), (z, z + 0.035))
        for i in range(1, count):
            x = p.x[0] + t + i * (p.d - 2 * t) / count
            yield box("bar", p.wood, (x - 0.008, x + 0.008), (y0 + 0.005, y0 + 0.02), (low + 0.035, high))
    yield box("base", p.wood, (p.x[0] + t, p.x[1] - t), (p.y[0] + t, p.y[1] - t), (low - 0.02, low + 0.03))
    inner = (p.y[0] + t + 0.01, p.y[1] - t - 0.01)
    yield soft("mattress", WHITE, (p.x[0] + t + 0.01, p.x[1] - t - 0.01), inner, (low + 0.03, low + 0.15))
    blanket = (p.x[0] + 0.45 * p.d, p.x[1] - t - 0.012)
    yield soft("blanket", p.accent, blanket, (inner[0] + 0.003, inner[1] - 0.003), (low + 0.1, low + 0.18))
    pillow = (p.x[0] + t + 0.04, p.x[0] + t + 0.26)
    yield soft("pillow", LINEN, pillow, (-0.16, 0.16), (low + 0.149, low + 0.2), bevel=0.02)


def cradle(p: Piece) -> Iterator[Part]:
    """Yield a basket on a stand."""
    mid = 0.42 * p.h
    yield slab(
        "basket",
        p.wood,
        (p.x[0] + 0.06, p.x[1] - 0.06),
        (p.y[0] + 0.06, p.y[1] - 0.06),
        (mid, 0.82 * p.h),
        top=(1.12, 1.2),
    )
    yield soft(
        "blanket",
        p.accent,
        (p.x[0] + 0.3 * p.d, p.x[1] - 0.06),
        (p.y[0] + 0.05, p.y[1] - 0.05),
        (0.8 * p.h, 0.87 * p.h),
    )
    yield soft(
        "pillow", LINEN, (p.x[0] + 0.08, p.x[0] + 0.26 * p.d), (-0.13, 0.13), (0.81 * p.h, 0.88 * p.h), bevel=0.02
    )
    yield slab("hood", p.fabric, (p.x[0], p.x[0] + 0.2 * p.d), p.y, (0.83 * p.h, p.h), top=(0.7, 0.8))
    yield from four(p, p.dark, mid, thick=0.04, round_=True, inset=0.03)


def camp_bed(p: Piece) -> Iterator[Part]:
    """Yield a folding bed with a thin mattress."""
    yield from four(p, p.metal, 0.6 * p.h, thick=0.035, round_=True)
    yield box("frame", p.metal, p.x, p.y, (0.6 * p.h, 0.68 * p.h))
    yield soft(
        "mattress", p.fabric, (p.x[0] + 0.01, p.x[1] - 0.01), (p.y[0] + 0.01, p.y[1] - 0.01), (0.68 * p.h, 0.9 * p.h)
    )
    yield soft(
        "pillow", LINEN, (p.x[0] + 0.04, p.x[0] + 0.36), (p.y[0] + 0.1, p.y[1] - 0.1), (0.9 * p.h, p.h), bevel=0.03
    )


def day_bed(p: Piece) -> Iterator[Part]:
    """Yield a sofa-like bed that faces forward, with a low back and arms."""
    seat = 0.5 * p.h
    yield box("back", p.wood, (p.x[0], p.x[0] + 0.05), (p.y[0] + 0.05, p.y[1] - 0.05), (0.15, p.h))
    for y0 in (p.y[0], p.y[1] - 0.05):
        yield box("arm", p.wood, p.x, (y0, y0 + 0.05), (0.0, 0.9 * p.h))
    inner = (p.y[0] + 0.052, p.y[1] - 0.052)
    yield box("frame", p.wood, (p.x[0] + 0.052, p.x[1] - 0.01), inner, (0.15 * p.h, 0.3 * p.h))
    yield soft("mattress", p.fabric, (p.x[0] + 0.052, p.x[1]), inner, (0.3 * p.h, seat), bevel=0.04)
    for i in range(3):
        y = inner[0] + (i + 0.5) * (inner[1] - inner[0]) / 3
        yield soft(
            "cushion",
            (p.accent, p.bedding, p.accent)[i],
            (p.x[0] + 0.06, p.x[0] + 0.24),
            (y - 0.24, y + 0.24),
            (seat, p.h - 0.02),
            bevel=0.06,
        )


def mattress(p: Piece) -> Iterator[Part]:
    """Yield a mattress with a pillow and a folded blanket."""
    top = 0.78 * p.h
    yield soft("mattress", WHITE, p.x, p.y, (0.0, top), bevel=0.04)
    yield soft("pillow", LINEN, (p.x[0] + 0.05, p.x[0] + 0.4), (p.y[0] + 0.12, p.y[1] - 0.12), (top, p.h), bevel=0.05)
    yield soft(
        "blanket",
        p.bedding,
        (p.x[1] - 0.5, p.x[1] - 0.1),
        (p.y[0] + 0.05, p.y[1] - 0.05),
        (top, top + 0.15 * p.h),
        bevel=0.02,
    )


def night_stand(p: Piece) -> Iterator[Part]:
    """Yield a small chest with two drawers, or one above an open compartment, on short legs."""
    leg = 0.2 * p.h
    yield from four(p, p.dark, leg, thick=0.035, inset=0.025, round_=True)
    yield board(p, p.wood, (p.h - 0.02, p.h))
    if p.variant % 2:
        yield carcass(p, p.wood, (leg, p.h - 0.021))
        yield from drawers(p, p.front, p.y, (leg, p.h - 0.021), rows=2, knobs=True)
        return
    middle = leg + 0.5 * (p.h - leg)
    for y0, y1 in ((p.y[0], p.y[0] + 0.018), (p.y[1] - 0.018, p.y[1])):
        yield box("side", p.wood, (p.x[0] + 0.002, p.x[1] - KNOB), (y0, y1), (leg, p.h - 0.02))
    inner = (p.y[0] + 0.018, p.y[1] - 0.018)
    yield box("back", p.wood, (p.x[0] + 0.002, p.x[0] + 0.012), inner, (leg, p.h - 0.02))
    yield box("shelf", p.wood, (p.x[0] + 0.012, p.x[1] - KNOB - 0.002), inner, (leg, leg + 0.018))
    yield box("drawer box", p.wood, (p.x[0] + 0.012, p.x[1] - KNOB - DOOR - 0.002), inner, (middle, p.h - 0.021))
    yield from drawers(p, p.front, inner, (middle, p.h - 0.021), rows=1, knobs=True)


def dresser(p: Piece) -> Iterator[Part]:
    """Yield a chest of drawers on short legs."""
    leg = 0.1 * p.h
    rows, columns = max(2, round((p.h - leg) / 0.24)), (2 if p.w > 0.95 else 1)
    yield from four(p, p.dark, leg, thick=0.045, inset=0.03)
    yield carcass(p, p.wood, (leg, p.h - 0.025))
    yield board(p, p.wood, (p.h - 0.024, p.h))
    yield from drawers(p, p.front, p.y, (leg, p.h - 0.026), rows=rows, columns=columns, knobs=p.variant % 2 == 0)


def vanity_table(p: Piece) -> Iterator[Part]:
    """Yield a dressing table with a mirror above its back edge."""
    top = min(0.76, 0.56 * p.h)
    yield from four(p, p.dark, top - 0.14, thick=0.04, inset=0.015, round_=True)
    yield carcass(p, p.wood, (top - 0.14, top - 0.021))
    yield from drawers(p, p.front, p.y, (top - 0.14, top - 0.021), rows=1, columns=2, knobs=True)
    yield board(p, p.wood, (top - 0.02, top))
    yield cylinder(
        "mirror frame",
        p.metal,
        (0.0, (top + p.h) / 2),
        (p.h - top) / 2,
        (p.x[0] + 0.03, p.x[0] + 0.05),
        axis="x",
        sides=24,
    )
    yield cylinder(
        "mirror",
        MIRROR,
        (0.0, (top + p.h) / 2),
        (p.h - top) / 2 - 0.02,
        (p.x[0] + 0.05, p.x[0] + 0.053),
        axis="x",
        sides=24,
    )


def wardrobe(p: Piece) -> Iterator[Part]:
    """Yield a tall cupboard with doors, a plinth and a cornice."""
    yield plinth(p, p.dark, 0.07)
    yield carcass(p, p.wood, (0.07, p.h - 0.03))
    yield board(p, p.wood, (p.h - 0.029, p.h))
    count = max(1, round(p.w / 0.5))
    if p.variant % 3 == 0 and p.w > 0.9:
        split = 0.07 + 0.28 * p.h
        yield from doors(p, p.front, p.y, (split, p.h - 0.03), count=count)
        yield from drawers(p, p.front, p.y, (0.07, split), rows=2, columns=max(1, count // 2))
        return
    yield from doors(p, p.front, p.y, (0.07, p.h - 0.03), count=count)


def pillow(p: Piece) -> Iterator[Part]:
    """Yield one pillow or cushion."""
    yield soft("pillow", p.accent if p.kind != "pillow" else LINEN, p.x, p.y, p.z, bevel=0.4 * min(p.d, p.w, p.h))


def blanket(p: Piece) -> Iterator[Part]:
    """Yield a folded blanket or towel: three layers."""
    for i in range(3):
        z = (i * p.h / 3, (i + 1) * p.h / 3 - 0.001)
        slip = 0.004 * i
        yield soft(
            "fold",
            (p.fabric, p.accent, p.fabric)[i],
            (p.x[0] + slip, p.x[1] - slip),
            (p.y[0], p.y[1] - slip),
            z,
            bevel=0.2 * p.h,
        )


BUILDERS: dict[str, Builder] = {
    "bed": bed,
    "single bed": bed,
    "bunk bed": bunk_bed,
    "loft bed": loft_bed,
    "crib": crib,
    "cradle": cradle,
    "camp bed": camp_bed,
    "day bed": day_bed,
    "mattress": mattress,
    "night stand": night_stand,
    "dresser": dresser,
    "vanity table": vanity_table,
    "wardrobe": wardrobe,
    "pillow": pillow,
    "cushion": pillow,
    "floor cushion": pillow,
    "blanket": blanket,
    "towel": blanket,
    "clothes": blanket,
}
