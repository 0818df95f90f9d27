"""Goods, dishes and kitchen units: rows whose pieces take turns."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from robolayout._text import utf8
from robolayout.assets.palette import BRIGHT, PLAIN, SPINES, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, slab


def buffet_counter(p: Piece) -> Iterator[Part]:
    """Yield serving dishes along a counter."""
    tones = tuple(PLAIN[name] for name in ("orange", "leaf", "bread", "yellow", "red", "ivory"))
    count, low = max(2, round(p.w / 0.42)), 0.66 * p.h
    for i in range(count):
        y, half = 0.9 * (p.y[0] + (i + 0.5) * p.w / count), min(0.17, 0.36 * p.w / count)
        tone, at = tones[(i + p.variant) % 6], (-0.11, y)
        if i % 3 == 1:
            yield cylinder("bowl", PLAIN["ceramic"], at, (0.5 * half, half), (low, low + 0.09), sides=18)
            yield cylinder("salad", tone, at, (0.9 * half, 0.4 * half), (low + 0.09, low + 0.13), sides=18)
            continue
        side, inner = (y - half, y + half), (y - 0.9 * half, y + 0.9 * half)
        yield box("pan", PLAIN["steel"], (-0.25, 0.03), side, (low, low + 0.09))
        yield box("food", tone, (-0.235, 0.015), inner, (low + 0.09, low + 0.1))
        if i % 2 == 0:
            yield slab("lid", PLAIN["chrome"], (-0.25, -0.13), side, (low + 0.1, low + 0.18), top=(0.6, 0.9))


def back_bar(p: Piece) -> Iterator[Part]:
    """Yield rows of bottles above a cabinet."""
    low = 0.45 * p.h
    for level in (low, *(low + 0.002 + (p.h - low) * share for share in (0.34, 0.67))):
        yield from _bottles((p.y[0] + 0.06, p.y[1] - 0.06), level, 0.2 * (p.h - low), p.x[0] + 0.24 * p.d)


def spice_rack(p: Piece) -> Iterator[Part]:
    """Yield jars with lids."""
    step = p.h / max(1, round(p.h / 0.14))
    r, n = min(0.02, 0.4 * p.d), max(2, round(p.w / 0.065))
    for i, j in product(range(round(p.h / step)), range(n)):
        at, z = (0.0, p.y[0] + 0.012 + (j + 0.5) * (p.w - 0.024) / n), i * step + 0.01
        tone = (*BRIGHT, PLAIN["coffee"])[(i * 3 + j * 2) % 7]
        yield cylinder("jar", tone, at, r, (z, z + 0.55 * step), sides=10)
        yield cylinder("lid", PLAIN["anthracite"], at, r, (z + 0.55 * step, z + 0.65 * step), sides=10)


def _goods(p: Piece, y: tuple[float, float], low: float, room: float, x: tuple[float, float]) -> Iterator[Part]:
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
    """Yield goods on all levels of a shop shelf."""
    rows = max(2, round(p.h / 0.36))
    step = (p.h - 0.14) / rows
    for i in range(rows):
        deep = p.x[1] - 0.01 - 0.06 * (i > 0)
        yield from _goods(p, p.y, 0.12 + i * step, step - 0.02, (p.x[0] + 0.03, deep - 0.02))


def display_case(p: Piece) -> Iterator[Part]:
    """Yield goods on two levels behind glass."""
    low = 0.42 * p.h
    for z in (low, low + 0.28 * p.h):
        yield from _goods(p, (p.y[0] + 0.05, p.y[1] - 0.05), z, 0.18 * p.h, (p.x[0] + 0.1, p.x[1] - 0.12))


def card_rack(p: Piece) -> Iterator[Part]:
    """Yield cards on the four sides of a rack."""
    rng, side = p.rng(), 0.32 * min(p.d, p.w)
    size = 0.28 * side
    for i, j, way in product(range(5), range(3), (-1, 1)):
        z, y = (0.22 + 0.146 * i) * p.h, (-0.66 + 0.66 * j) * side
        face = (side, side + 0.012) if way > 0 else (-side - 0.012, -side)
        yield box("card", rng.choice((*BRIGHT, *SPINES)), face, (y - size, y + size), (z, z + 0.12 * p.h))
        yield box("card", rng.choice((*BRIGHT, *SPINES)), (y - size, y + size), face, (z, z + 0.12 * p.h))


def display_fridge(p: Piece) -> Iterator[Part]:
    """Yield five rows of bottles."""
    span = p.h - 0.3
    for i in range(5):
        yield from _bottles((p.y[0] + 0.03, p.y[1] - 0.03), 0.15 + i * span / 5, 0.7 * span / 5, p.x[1] - 0.16)


def _bottles(y: tuple[float, float], low: float, tall: float, x: float) -> Iterator[Part]:
    """Yield one row of bottles or flowers in a cooler."""
    count = max(3, min(12, round((y[1] - y[0]) / 0.1)))
    for i in range(count):
        at = y[0] + (i + 0.5) * (y[1] - y[0]) / count
        tone = (*BRIGHT, *SPINES)[(3 * i + round(low * 10)) % 13]
        yield cylinder("bottle", tone, (x, at), (0.038, 0.018), (low, low + tall), sides=8)
