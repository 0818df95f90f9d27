"""Lamps."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder
from robolayout.assets.palette import (
    BLACK,
    BRASS,
    EMBER,
    GLASS,
    IVORY,
    LAMPSHADE,
    STEEL,
    WHITE,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, moved, oval, slab

Span = tuple[float, float]

LONG = 1.8
"""Ratio of its sides from which on a ceiling lamp is a bar instead of a bowl."""


def floor_lamp(p: Piece) -> Iterator[Part]:
    """Yield a standing lamp: foot, pole, fabric shade."""
    r = min(p.d, p.w) / 2
    if p.variant % 3 == 0:
        for i in range(3):
            turn = 2 * math.pi * i / 3
            leg = box("leg", p.wood, (-0.014, 0.014), (-0.014, 0.014), (0.0, 0.78 * p.h))
            low = leg.vertices[:, 2] < 0.1
            leg.vertices[low, 0] += 0.88 * r * math.cos(turn)
            leg.vertices[low, 1] += 0.88 * r * math.sin(turn)
            yield leg
    else:
        yield cylinder("foot", p.metal, (0.0, 0.0), (0.62 * r, 0.58 * r), (0.0, 0.025), sides=20)
        yield cylinder("pole", p.metal, (0.0, 0.0), 0.014, (0.025, 0.8 * p.h), sides=8)
    yield oval(
        "shade", LAMPSHADE, (0.0, 0.0), ((p.d / 2, p.w / 2), (0.36 * p.d, 0.36 * p.w)), (0.78 * p.h, p.h), sides=20
    )


def table_lamp(p: Piece) -> Iterator[Part]:
    """Yield a lamp with a ceramic or turned base and a shade."""
    if p.variant % 2:
        yield ball("base", p.accent, (-0.3 * p.d, 0.3 * p.d), (-0.3 * p.w, 0.3 * p.w), (0.0, 0.46 * p.h), rings=6)
    else:
        yield cylinder("base", p.wood, (0.0, 0.0), (0.3 * p.d, 0.12 * p.d), (0.0, 0.44 * p.h), sides=14)
    yield cylinder("neck", BRASS, (0.0, 0.0), 0.012, (0.42 * p.h, 0.56 * p.h), sides=6)
    yield oval(
        "shade", LAMPSHADE, (0.0, 0.0), ((p.d / 2, p.w / 2), (0.32 * p.d, 0.32 * p.w)), (0.52 * p.h, p.h), sides=20
    )


def desk_lamp(p: Piece) -> Iterator[Part]:
    """Yield a jointed lamp that looks forward."""
    foot, r = p.x[0] + 0.26 * p.d, 0.26 * p.d
    yield cylinder("foot", p.metal, (foot, 0.0), (r, 0.9 * r), (0.0, 0.04 * p.h), sides=16)
    lower = box("arm", p.metal, (foot - 0.008, foot + 0.008), (-0.008, 0.008), (0.04 * p.h, 0.6 * p.h))
    lower.vertices[lower.vertices[:, 2] > 0.3 * p.h, 0] -= 0.16 * p.d
    yield lower
    start = foot - 0.16 * p.d
    upper = box("arm", p.metal, (start - 0.007, start + 0.007), (-0.007, 0.007), (0.59 * p.h, 0.94 * p.h))
    upper.vertices[upper.vertices[:, 2] > 0.7 * p.h, 0] += 0.5 * p.d
    yield upper
    head = cylinder("head", p.accent, (0.0, 0.0), (p.w / 2, 0.2 * p.w), (0.72 * p.h, p.h), sides=16)
    head.vertices[:, 0] += p.x[1] - p.w / 2
    yield head


def pendant(p: Piece) -> Iterator[Part]:
    """Yield a lamp on a cord from the ceiling."""
    shade = min(0.6 * p.h, 0.7 * min(p.d, p.w))
    yield cylinder("rose", p.metal, (0.0, 0.0), 0.05, (p.h - 0.025, p.h), sides=14)
    yield cylinder("cord", BLACK, (0.0, 0.0), 0.004, (shade, p.h - 0.025), sides=5)
    tone = (p.accent, p.metal, LAMPSHADE)[p.variant % 3]
    yield oval("shade", tone, (0.0, 0.0), ((p.d / 2, p.w / 2), (0.2 * p.d, 0.2 * p.w)), (0.12 * shade, shade), sides=24)
    yield ball(
        "bulb", LAMPSHADE, (-0.16 * p.d, 0.16 * p.d), (-0.16 * p.w, 0.16 * p.w), (0.0, 0.3 * shade), rings=4, sides=10
    )


def chandelier(p: Piece) -> Iterator[Part]:
    """Yield a ring of arms with candles under a rose."""
    yield cylinder("rose", BRASS, (0.0, 0.0), 0.06, (p.h - 0.03, p.h), sides=14)
    yield cylinder("stem", BRASS, (0.0, 0.0), 0.014, (0.2 * p.h, p.h - 0.03), sides=8)
    yield ball("hub", BRASS, (-0.07, 0.07), (-0.07, 0.07), (0.04 * p.h, 0.3 * p.h), rings=4)
    yield ball("drop", GLASS, (-0.03, 0.03), (-0.03, 0.03), (0.0, 0.07 * p.h), rings=3, sides=8)
    for i in range(8):
        turn = 2 * math.pi * i / 8
        x, y = 0.42 * min(p.d, p.w) * math.cos(turn), 0.42 * min(p.d, p.w) * math.sin(turn)
        arm = box("arm", BRASS, (0.04, 0.42 * min(p.d, p.w)), (-0.009, 0.009), (0.16 * p.h, 0.19 * p.h))
        arm.vertices[arm.vertices[:, 0] > 0.1, 2] += 0.16 * p.h
        yield moved(arm, turn=turn)
        yield cylinder("cup", BRASS, (x, y), (0.02, 0.035), (0.34 * p.h, 0.39 * p.h), sides=10)
        yield cylinder("candle", IVORY, (x, y), 0.015, (0.39 * p.h, 0.55 * p.h), sides=8)
        yield ball(
            "flame",
            LAMPSHADE,
            (x - 0.014, x + 0.014),
            (y - 0.014, y + 0.014),
            (0.54 * p.h, 0.64 * p.h),
            rings=3,
            sides=6,
        )


def ceiling_lamp(p: Piece) -> Iterator[Part]:
    """Yield a flat bowl of milky glass under a metal rim; a long one is a bar."""
    if max(p.d, p.w) > LONG * min(p.d, p.w):
        x, y = (0.36 * p.d, 0.36 * p.w)
        yield box("mount", STEEL, (-x, x), (-y, y), (0.8 * p.h, p.h))
        yield slab("housing", WHITE, p.x, p.y, (0.35 * p.h, 0.8 * p.h), top=(0.92, 0.96))
        yield slab("diffuser", LAMPSHADE, (-0.46 * p.d, 0.46 * p.d), (-0.47 * p.w, 0.47 * p.w), (0.0, 0.35 * p.h))
        return
    r = (p.d / 2, p.w / 2)
    yield oval("rose", STEEL, (0.0, 0.0), ((0.55 * r[0], 0.55 * r[1]), (0.5 * r[0], 0.5 * r[1])), (0.85 * p.h, p.h))
    yield oval("rim", WHITE, (0.0, 0.0), (r, (0.94 * r[0], 0.94 * r[1])), (0.6 * p.h, 0.85 * p.h), sides=28)
    yield oval(
        "glass", LAMPSHADE, (0.0, 0.0), ((0.3 * p.d, 0.3 * p.w), (0.46 * p.d, 0.46 * p.w)), (0.0, 0.6 * p.h), sides=28
    )


def ceiling_fan(p: Piece) -> Iterator[Part]:
    """Yield a fan with five blades and a lamp."""
    hub = 0.42 * p.h
    yield cylinder("rose", p.metal, (0.0, 0.0), 0.07, (0.92 * p.h, p.h), sides=14)
    yield cylinder("rod", p.metal, (0.0, 0.0), 0.015, (0.6 * p.h, 0.92 * p.h), sides=8)
    yield cylinder("motor", p.metal, (0.0, 0.0), 0.11, (hub - 0.05, 0.6 * p.h), sides=18)
    yield ball("lamp", LAMPSHADE, (-0.1, 0.1), (-0.1, 0.1), (0.0, hub), rings=4)
    for i in range(5):
        blade = slab("blade", p.wood, (0.12, min(p.d, p.w) / 2), (-0.065, 0.065), (hub, hub + 0.012))
        yield moved(blade, turn=2 * math.pi * i / 5)


def wall_lamp(p: Piece) -> Iterator[Part]:
    """Yield a sconce: plate, arm, shade."""
    yield box("plate", BRASS, (p.x[0], p.x[0] + 0.02), (-0.3 * p.w, 0.3 * p.w), (0.1 * p.h, 0.6 * p.h))
    yield box("arm", BRASS, (p.x[0] + 0.02, 0.1 * p.d), (-0.01, 0.01), (0.29 * p.h, 0.35 * p.h))
    shade = cylinder("shade", LAMPSHADE, (0.0, 0.0), (p.w / 2, 0.34 * p.w), (0.36 * p.h, p.h), sides=18)
    shade.vertices[:, 0] += p.x[1] - p.w / 2
    yield shade
    yield cylinder("cup", BRASS, (p.x[1] - p.w / 2, 0.0), (0.02, 0.03), (0.0, 0.36 * p.h), sides=8)


def lantern(p: Piece) -> Iterator[Part]:
    """Yield a lantern with a candle."""
    t = 0.08 * p.d
    yield box("foot", p.metal, p.x, p.y, (0.0, 0.06 * p.h))
    for x0 in (p.x[0], p.x[1] - t):
        for y0 in (p.y[0], p.y[1] - t):
            yield box("post", p.metal, (x0, x0 + t), (y0, y0 + t), (0.06 * p.h, 0.72 * p.h))
    yield slab("roof", p.metal, p.x, p.y, (0.72 * p.h, 0.9 * p.h), top=(0.25, 0.25))
    yield cylinder("ring", p.metal, (0.0, 0.0), 0.1 * p.d, (0.9 * p.h, p.h), sides=8)
    yield cylinder("candle", IVORY, (0.0, 0.0), 0.22 * p.d, (0.06 * p.h, 0.42 * p.h), sides=12)
    yield ball(
        "flame", EMBER, (-0.08 * p.d, 0.08 * p.d), (-0.08 * p.w, 0.08 * p.w), (0.42 * p.h, 0.56 * p.h), rings=3, sides=8
    )


BUILDERS: dict[str, Builder] = {
    "floor lamp": floor_lamp,
    "table lamp": table_lamp,
    "desk lamp": desk_lamp,
    "pendant lamp": pendant,
    "unknown ceiling item": pendant,
    "chandelier": chandelier,
    "ceiling lamp": ceiling_lamp,
    "ceiling fan": ceiling_fan,
    "wall lamp": wall_lamp,
    "lantern": lantern,
}
