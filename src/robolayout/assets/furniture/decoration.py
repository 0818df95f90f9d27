"""Lamps, plants, rugs, pictures, curtains and small things to look at."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, carcass, doors
from robolayout.assets.palette import (
    BLACK, BRASS, BRIGHT, BRICK, CERAMIC, DARK, EMBER, GLASS, GREEN, IVORY, LAMPSHADE, LEAF, LEAF_DARK, LEAF_LIGHT, LIGHT_GREY,
    LINEN, MIRROR, ORANGE, PAPER, PINK, SOIL, SPINES, STEEL, STONE, TERRACOTTA, WATER, WHITE, YELLOW, Piece,
)  # fmt: skip
from robolayout.assets.part import Material, Part
from robolayout.assets.shapes import ball, box, cylinder, moved, oval, prism, slab, soft

Span = tuple[float, float]


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
    yield oval("shade", LAMPSHADE, (0.0, 0.0), ((p.d / 2, p.w / 2), (0.36 * p.d, 0.36 * p.w)), (0.78 * p.h, p.h), sides=20)


def table_lamp(p: Piece) -> Iterator[Part]:
    """Yield a lamp with a ceramic or turned base and a shade."""
    if p.variant % 2:
        yield ball("base", p.accent, (-0.3 * p.d, 0.3 * p.d), (-0.3 * p.w, 0.3 * p.w), (0.0, 0.46 * p.h), rings=6)
    else:
        yield cylinder("base", p.wood, (0.0, 0.0), (0.3 * p.d, 0.12 * p.d), (0.0, 0.44 * p.h), sides=14)
    yield cylinder("neck", BRASS, (0.0, 0.0), 0.012, (0.42 * p.h, 0.56 * p.h), sides=6)
    yield oval("shade", LAMPSHADE, (0.0, 0.0), ((p.d / 2, p.w / 2), (0.32 * p.d, 0.32 * p.w)), (0.52 * p.h, p.h), sides=20)


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
    yield ball("bulb", LAMPSHADE, (-0.16 * p.d, 0.16 * p.d), (-0.16 * p.w, 0.16 * p.w), (0.0, 0.3 * shade), rings=4, sides=10)


def chandelier(p: Piece) -> Iterator[Part]:
    """Yield a ring of arms with candles under a rose."""
    yield cylinder("rose", BRASS, (0.0, 0.0), 0.06, (p.h - 0.03, p.h), sides=14)
    yield cylinder("stem", BRASS, (0.0, 0.0), 0.014, (0.2 * p.h, p.h - 0.03), sides=8)
    yield ball("hub", BRASS, (-0.07, 0.07), (-0.07, 0.07), (0.04 * p.h, 0.3 * p.h), rings=4)
    yield ball("drop", GLASS, (-0.03, 0.03), (-0.03, 0.03), (0.0, 0.07 * p.h), rings=3, sides=8)
    for i in range(8):
        turn = 2 * math.pi * i / 8
        x, y = 0.42 * p.d * math.cos(turn), 0.42 * p.w * math.sin(turn)
        arm = box("arm", BRASS, (-0.009, 0.009), (-0.009, 0.009), (0.16 * p.h, 0.19 * p.h))
        far = arm.vertices[:, 0] * math.cos(turn) + arm.vertices[:, 1] * math.sin(turn) > 0
        arm.vertices[far] += (x, y, 0.16 * p.h)
        yield arm
        yield cylinder("cup", BRASS, (x, y), (0.02, 0.035), (0.34 * p.h, 0.39 * p.h), sides=10)
        yield cylinder("candle", IVORY, (x, y), 0.015, (0.39 * p.h, 0.55 * p.h), sides=8)
        yield ball("flame", LAMPSHADE, (x - 0.014, x + 0.014), (y - 0.014, y + 0.014), (0.54 * p.h, 0.64 * p.h), rings=3, sides=6)


def ceiling_lamp(p: Piece) -> Iterator[Part]:
    """Yield a flat bowl of milky glass under a metal rim."""
    yield oval("rim", p.metal, (0.0, 0.0), ((p.d / 2, p.w / 2), (p.d / 2, p.w / 2)), (0.7 * p.h, p.h), sides=28)
    yield oval("glass", LAMPSHADE, (0.0, 0.0), ((0.3 * p.d, 0.3 * p.w), (0.46 * p.d, 0.46 * p.w)), (0.0, 0.7 * p.h), sides=28)


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
    yield box("arm", BRASS, (p.x[0] + 0.02, 0.1 * p.d), (-0.01, 0.01), (0.3 * p.h, 0.36 * p.h))
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
    yield ball("flame", EMBER, (-0.08 * p.d, 0.08 * p.d), (-0.08 * p.w, 0.08 * p.w), (0.42 * p.h, 0.56 * p.h), rings=3, sides=8)


def picture(p: Piece) -> Iterator[Part]:
    """Yield a framed picture: an abstract landscape in the room's colours."""
    b = min(0.03, 0.08 * min(p.w, p.h))
    frame = (p.wood, BLACK, p.dark, WHITE)[p.variant % 4]
    back = p.x[0] + 0.55 * p.d
    for y in ((p.y[0], p.y[0] + b), (p.y[1] - b, p.y[1])):
        yield box("frame", frame, p.x, y, p.z)
    for z in ((0.0, b), (p.h - b, p.h)):
        yield box("frame", frame, p.x, (p.y[0] + b, p.y[1] - b), z)
    inner, level = (p.y[0] + b, p.y[1] - b), (b, p.h - b)
    yield box("mount", PAPER, (p.x[0], back), inner, level)
    m = 0.12 * min(p.w, p.h)
    yield from _artwork(p, (inner[0] + m, inner[1] - m), (level[0] + m, level[1] - m), back)


def _artwork(p: Piece, y: Span, z: Span, x: float) -> Iterator[Part]:
    """Yield sky, hills and a sun, or bands of colour, in thin layers."""
    rng = p.rng()
    w, h = y[1] - y[0], z[1] - z[0]
    step = 0.06 * p.d
    tones = [*p.palette.accents, *p.palette.fabrics]
    rng.shuffle(tones)
    yield box("sky", tones[0], (x, x + step), y, z)
    cut = z[0] + h * rng.uniform(0.3, 0.5)
    hill = [(y[0], z[0]), (y[1], z[0]), (y[1], cut), (y[0] + 0.6 * w, cut + 0.2 * h), (y[0], cut - 0.1 * h)]
    yield prism("hill", tones[1], hill, (x + step, x + 2 * step), axis="x")
    near = [(y[0], z[0]), (y[1], z[0]), (y[1], z[0] + 0.12 * h), (y[0] + 0.3 * w, z[0] + 0.3 * h), (y[0], z[0] + 0.28 * h)]
    yield prism("field", tones[2], near, (x + 2 * step, x + 3 * step), axis="x")
    r = 0.12 * min(w, h)
    at = (y[0] + w * rng.uniform(0.2, 0.75), z[1] - 1.9 * r)
    yield cylinder("sun", tones[3], at, r, (x + step, x + 2 * step), axis="x", sides=18)


def mirror(p: Piece) -> Iterator[Part]:
    """Yield a wall mirror: round where it is square, else with a frame."""
    if abs(p.w - p.h) < 0.1 * p.w:
        yield cylinder("frame", p.metal, (0.0, p.h / 2), p.w / 2, (p.x[0], p.x[1] - 0.2 * p.d), axis="x", sides=32)
        yield cylinder("mirror", MIRROR, (0.0, p.h / 2), 0.94 * p.w / 2, (p.x[1] - 0.2 * p.d, p.x[1]), axis="x", sides=32)
        return
    yield from _framed_mirror(p, p.x)


def _framed_mirror(p: Piece, x: Span) -> Iterator[Part]:
    """Yield a rectangular mirror with a wooden frame."""
    b, thick = 0.05 * min(p.w, p.h) + 0.012, x[1] - x[0]
    for y in ((p.y[0], p.y[0] + b), (p.y[1] - b, p.y[1])):
        yield box("frame", p.wood, x, y, p.z)
    for z in ((0.0, b), (p.h - b, p.h)):
        yield box("frame", p.wood, x, (p.y[0] + b, p.y[1] - b), z)
    yield box("mirror", MIRROR, (x[0], x[1] - 0.4 * thick), (p.y[0] + b, p.y[1] - b), (b, p.h - b))


def floor_mirror(p: Piece) -> Iterator[Part]:
    """Yield a leaning mirror with a stay behind it."""
    for part in _framed_mirror(p, (p.x[1] - 0.04, p.x[1])):
        part.vertices[:, 0] -= (0.6 * p.d) * part.vertices[:, 2] / p.h
        yield part
    for y in (-0.3 * p.w, 0.3 * p.w):
        stay = box("stay", p.wood, (p.x[0], p.x[0] + 0.03), (y - 0.012, y + 0.012), (0.0, 0.7 * p.h))
        stay.vertices[stay.vertices[:, 2] > 0.1, 0] += 0.4 * p.d
        yield stay


def wall_clock(p: Piece) -> Iterator[Part]:
    """Yield a round clock with hands and marks."""
    r, face = min(p.w, p.h) / 2, p.x[0] + 0.7 * p.d
    yield oval("case", p.dark, (0.0, p.h / 2), ((p.w / 2, p.h / 2), (p.w / 2, p.h / 2)), (p.x[0], face), axis="x", sides=28)
    yield cylinder("dial", PAPER, (0.0, p.h / 2), 0.9 * r, (face, face + 0.1 * p.d), axis="x", sides=28)
    for i in range(12):
        turn = math.pi * i / 6
        y, z = 0.78 * r * math.sin(turn), p.h / 2 + 0.78 * r * math.cos(turn)
        t = (0.05 if i % 3 == 0 else 0.03) * r
        yield box("mark", BLACK, (face + 0.1 * p.d, face + 0.15 * p.d), (y - t, y + t), (z - t, z + t))
    yield box("hour hand", BLACK, (face + 0.1 * p.d, face + 0.2 * p.d), (-0.04 * r, 0.04 * r), (p.h / 2, p.h / 2 + 0.45 * r))
    yield box("minute hand", BLACK, (face + 0.2 * p.d, p.x[1]), (-0.025 * r, 0.62 * r), (p.h / 2 - 0.025 * r, p.h / 2 + 0.025 * r))


def alarm_clock(p: Piece) -> Iterator[Part]:
    """Yield a small round clock on feet."""
    r = 0.44 * min(p.w, p.h)
    yield cylinder("case", p.accent, (0.0, 0.52 * p.h), (r, r), (p.x[0], p.x[1] - 0.1 * p.d), axis="x", sides=20)
    yield cylinder("dial", PAPER, (0.0, 0.52 * p.h), 0.86 * r, (p.x[1] - 0.1 * p.d, p.x[1] - 0.04 * p.d), axis="x", sides=20)
    yield box("hand", BLACK, (p.x[1] - 0.04 * p.d, p.x[1]), (-0.05 * r, 0.05 * r), (0.5 * p.h, 0.52 * p.h + 0.66 * r))
    yield box("hand", BLACK, (p.x[1] - 0.04 * p.d, p.x[1] - 0.01 * p.d), (0.05 * r, 0.5 * r), (0.5 * p.h, 0.54 * p.h))
    for y in (-0.5, 0.5):
        yield box("foot", BRASS, (-0.2 * p.d, 0.2 * p.d), ((y - 0.1) * p.w * 0.8, (y + 0.1) * p.w * 0.8), (0.0, 0.16 * p.h))
        yield ball("bell", BRASS, (-0.2 * p.d, 0.2 * p.d), (0.6 * y * p.w - 0.14 * p.w, 0.6 * y * p.w + 0.14 * p.w), (0.84 * p.h, p.h), rings=3, sides=8)


def grandfather_clock(p: Piece) -> Iterator[Part]:
    """Yield a tall clock with dial, glass and pendulum."""
    face = p.x[1] - 0.02
    yield box("base", p.dark, (p.x[0], face), p.y, (0.0, 0.2 * p.h))
    yield box("trunk", p.dark, (p.x[0] + 0.02, face - 0.02), (0.8 * p.y[0], 0.8 * p.y[1]), (0.2 * p.h, 0.72 * p.h))
    yield box("hood", p.dark, (p.x[0], face), p.y, (0.72 * p.h, 0.96 * p.h))
    yield slab("cornice", p.dark, (p.x[0], p.x[1]), p.y, (0.961 * p.h, p.h), top=(0.8, 0.8))
    yield cylinder("dial", PAPER, (0.0, 0.84 * p.h), 0.4 * p.w, (face, face + 0.008), axis="x", sides=24)
    yield box("hand", BLACK, (face + 0.008, p.x[1]), (-0.008, 0.008), (0.84 * p.h, 0.84 * p.h + 0.3 * p.w))
    yield box("hand", BLACK, (face + 0.008, p.x[1] - 0.002), (0.008, 0.2 * p.w), (0.84 * p.h - 0.008, 0.84 * p.h + 0.008))
    yield box("window", BLACK, (face - 0.02, face - 0.016), (-0.26 * p.w, 0.26 * p.w), (0.26 * p.h, 0.68 * p.h))
    yield box("rod", BRASS, (face - 0.016, face - 0.01), (-0.006, 0.006), (0.34 * p.h, 0.68 * p.h))
    yield cylinder("pendulum", BRASS, (0.0, 0.34 * p.h), 0.15 * p.w, (face - 0.016, face - 0.004), axis="x", sides=16)


def tapestry(p: Piece) -> Iterator[Part]:
    """Yield a cloth with bands that hangs from a rod, with tassels."""
    yield cylinder("rod", p.wood, (p.h - 0.5 * p.d, 0.0), p.d / 2, p.y, axis="y", sides=8)
    bands = 6
    low = 0.08 * p.h
    for i in range(bands):
        z = (low + i * (p.h - p.d - low) / bands, low + (i + 1) * (p.h - p.d - low) / bands)
        yield box("band", (p.accent, p.bedding, p.fabric)[i % 3], (-0.3 * p.d, 0.3 * p.d), (0.96 * p.y[0], 0.96 * p.y[1]), z)
    for i in range(n := max(5, round(p.w / 0.12))):
        y = 0.92 * p.y[0] + i * 0.92 * p.w / (n - 1)
        yield box("tassel", p.bedding, (-0.2 * p.d, 0.2 * p.d), (y - 0.012, y + 0.012), (0.0, low))


def photo_frame(p: Piece) -> Iterator[Part]:
    """Yield a small standing picture."""
    small = Piece(0.02, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    for part in picture(small):
        part.vertices[:, 0] += p.x[1] - 0.02 - (p.d - 0.03) * part.vertices[:, 2] / p.h * 0.5
        yield part
    yield box("stay", DARK, (p.x[0], p.x[1] - 0.04), (-0.01, 0.01), (0.0, 0.3 * p.h))


def vase(p: Piece) -> Iterator[Part]:
    """Yield a vase with flowers."""
    belly = 0.5 * p.h
    yield _disc(p, "foot", p.accent, (0.42, 0.6), (0.0, 0.25))
    yield _disc(p, "belly", p.accent, (0.6, 0.3), (0.25, 0.44))
    yield _disc(p, "neck", p.accent, (0.3, 0.42), (0.44, 0.5))
    yield from bunch(p, belly, (PINK, YELLOW, p.bedding, WHITE))


def _disc(p: Piece, name: str, tone: Material, radii: Span, z: Span, *, sides: int = 16) -> Part:
    """Return an elliptic frustum in shares of the box."""
    (a, b), (low, high) = radii, z
    rows = ((a * p.d / 2, a * p.w / 2), (b * p.d / 2, b * p.w / 2))
    return oval(name, tone, (0.0, 0.0), rows, (low * p.h, high * p.h), sides=sides)


def bunch(p: Piece, low: float, tones: tuple[Material, ...]) -> Iterator[Part]:
    """Yield stems and blossoms from height `low` up to the top."""
    rng = p.rng()
    for i in range(9):
        turn, out = 2.4 * i, math.sqrt((i + 0.5) / 9)
        size = 0.17 * min(p.d, p.w)
        x, y = (0.5 * p.d - size) * out * math.cos(turn), (0.5 * p.w - size) * out * math.sin(turn)
        top = p.h - (p.h - low) * 0.45 * out * rng.uniform(0.6, 1.0)
        stem = box("stem", LEAF, (-0.003, 0.003), (-0.003, 0.003), (low - 0.02, top - size))
        upper = stem.vertices[:, 2] > low
        stem.vertices[upper, 0] += x
        stem.vertices[upper, 1] += y
        yield stem
        yield ball("blossom", tones[i % len(tones)], (x - size, x + size), (y - size, y + size), (top - 1.5 * size, top), rings=3, sides=8)
    yield ball("leaves", LEAF, (-0.3 * p.d, 0.3 * p.d), (-0.3 * p.w, 0.3 * p.w), (low - 0.01, low + 0.4 * (p.h - low)), rings=3, sides=8)


def statue(p: Piece) -> Iterator[Part]:
    """Yield a stylised bust on a block."""
    tone = (STONE, BRASS, p.dark, WHITE)[p.variant % 4]
    yield box("block", p.dark if tone is not p.dark else STONE, p.x, p.y, (0.0, 0.2 * p.h))
    yield slab("chest", tone, (-0.36 * p.d, 0.36 * p.d), (-0.46 * p.w, 0.46 * p.w), (0.2 * p.h, 0.5 * p.h), top=(0.5, 0.36))
    yield cylinder("neck", tone, (0.0, 0.0), 0.12 * min(p.d, p.w), (0.48 * p.h, 0.66 * p.h), sides=12)
    yield ball("head", tone, (-0.26 * p.d, 0.28 * p.d), (-0.22 * p.w, 0.22 * p.w), (0.6 * p.h, p.h), rings=6)


def floor_sculpture(p: Piece) -> Iterator[Part]:
    """Yield stacked rounded stones on a plinth."""
    yield box("plinth", WHITE, p.x, p.y, (0.0, 0.4 * p.h))
    low = 0.4 * p.h
    for i, share in enumerate((0.44, 0.34, 0.24)):
        tall = (0.26, 0.2, 0.14)[i] * p.h
        yield ball("stone", (STONE, p.accent, STONE)[i], (-share * p.d, share * p.d), (-share * p.w, share * p.w), (low, low + tall), rings=5)
        low += tall - 0.01


def trophy(p: Piece) -> Iterator[Part]:
    """Yield a golden cup on a block."""
    yield box("block", BLACK, (-0.3 * p.d, 0.3 * p.d), (-0.24 * p.w, 0.24 * p.w), (0.0, 0.22 * p.h))
    yield cylinder("stem", BRASS, (0.0, 0.0), (0.24 * p.d, 0.08 * p.d), (0.22 * p.h, 0.5 * p.h), sides=12)
    yield cylinder("cup", BRASS, (0.0, 0.0), (0.22 * p.d, p.d / 2), (0.5 * p.h, p.h), sides=16)
    for y in (p.y[0], p.y[1] - 0.08 * p.w):
        yield box("handle", BRASS, (-0.01, 0.01), (y, y + 0.08 * p.w), (0.62 * p.h, 0.92 * p.h))
        inner = (y + 0.08 * p.w, -0.2 * p.w) if y < 0 else (0.2 * p.w, y)
        yield box("handle", BRASS, (-0.009, 0.009), inner, (0.84 * p.h, 0.9 * p.h))


def book(p: Piece) -> Iterator[Part]:
    """Yield a closed book; its spine is at the back."""
    cover = p.rng().choice(SPINES)
    t = 0.12 * p.h
    yield box("cover", cover, p.x, p.y, (0.0, t))
    yield box("pages", PAPER, (p.x[0] + 0.004, p.x[1] - 0.004), (p.y[0] + 0.004, p.y[1] - 0.004), (t, p.h - t))
    yield box("cover", cover, p.x, p.y, (p.h - t, p.h))


def book_stack(p: Piece) -> Iterator[Part]:
    """Yield a pile of books, each turned a little."""
    rng = p.rng()
    count = max(2, round(p.h / 0.032))
    for i in range(count):
        shrink = rng.uniform(0.8, 0.96) if i else 1.0
        z = i * p.h / count
        one = Piece(shrink * p.d * 0.95, shrink * p.w * 0.95, p.h / count, p.palette, p.fabric, p.accent, p.bedding, p.kind, i, f"{p.key}/{i}")
        turn = rng.uniform(-0.12, 0.12) if i else 0.0
        yield from (moved(part, turn=turn, offset=(0.0, 0.0, z)) for part in book(one))


def magazine(p: Piece) -> Iterator[Part]:
    """Yield a magazine with a cover picture."""
    yield box("pages", PAPER, p.x, p.y, (0.0, 0.7 * p.h))
    yield box("cover", p.accent, (p.x[0] + 0.004, p.x[1] - 0.002), (p.y[0] + 0.002, p.y[1] - 0.002), (0.7 * p.h, 0.9 * p.h))
    yield box("title", WHITE, (p.x[0] + 0.02, p.x[0] + 0.2 * p.d), (0.8 * p.y[0], 0.8 * p.y[1]), (0.9 * p.h, p.h))


def fireplace(p: Piece) -> Iterator[Part]:
    """Yield a mantelpiece around a hearth with logs and fire."""
    shelf = p.h - 0.06
    jamb = 0.2 * p.w
    for y in ((p.y[0] + 0.03, p.y[0] + 0.03 + jamb), (p.y[1] - 0.03 - jamb, p.y[1] - 0.03)):
        yield box("jamb", p.front, (p.x[0], p.x[1] - 0.06), y, (0.04, shelf))
    inner = (p.y[0] + 0.03 + jamb, p.y[1] - 0.03 - jamb)
    yield box("lintel", p.front, (p.x[0], p.x[1] - 0.062), inner, (0.62 * p.h, shelf))
    yield box("mantel", p.wood, (p.x[0], p.x[1] - 0.02), p.y, (shelf, p.h))
    yield box("hearth", STONE, p.x, (p.y[0] + 0.02, p.y[1] - 0.02), (0.0, 0.04))
    yield box("firebox", BLACK, (p.x[0], p.x[0] + 0.05), inner, (0.04, 0.62 * p.h))
    for y in ((inner[0], inner[0] + 0.03), (inner[1] - 0.03, inner[1])):
        yield box("brick", BRICK, (p.x[0] + 0.05, p.x[1] - 0.07), y, (0.04, 0.62 * p.h - 0.002))
    for i, y in enumerate((-0.07, 0.0, 0.07)):
        yield cylinder("log", p.dark, (0.09 if i != 1 else 0.16, -0.02 + 0.03 * i), 0.035, (-0.34 * (inner[1] - inner[0]) + y, 0.34 * (inner[1] - inner[0]) + y), axis="y", sides=8)
    for i, y in enumerate((-0.1, 0.0, 0.1)):
        tall = (0.3, 0.4, 0.26)[i] * p.h * 0.6
        yield cylinder("flame", (ORANGE, YELLOW, EMBER)[i], (-0.01, y), (0.05, 0.005), (0.12, 0.12 + tall), sides=7)


def aquarium(p: Piece) -> Iterator[Part]:
    """Yield a fish tank with gravel, plants and fish, on a cabinet where it is high."""
    low = 0.55 * p.h if p.h > 0.8 else 0.0
    if low:
        yield carcass(p, p.wood, (0.0, low))
        yield from doors(p, p.front, p.y, (0.0, low), count=2)
    yield box("rim", BLACK, p.x, p.y, (low, low + 0.03))
    yield box("gravel", STONE, (p.x[0] + 0.01, p.x[1] - 0.01), (p.y[0] + 0.01, p.y[1] - 0.01), (low + 0.03, low + 0.07))
    for i in range(4):
        y = p.y[0] + (i + 0.6) * p.w / 4.4
        yield ball("weed", (LEAF, LEAF_LIGHT)[i % 2], (-0.06, 0.02), (y - 0.03, y + 0.03), (low + 0.06, low + 0.06 + (0.22, 0.14, 0.26, 0.16)[i]), rings=3, sides=6)
    for i in range(3):
        y, z = (-0.25 + 0.24 * i) * p.w, low + (0.2, 0.3, 0.16)[i]
        yield ball("fish", (ORANGE, YELLOW, PINK)[i], (0.0, 0.03), (y - 0.04, y + 0.04), (z - 0.02, z + 0.02), rings=3, sides=8)
    yield box("water", WATER, (p.x[0] + 0.005, p.x[1] - 0.005), (p.y[0] + 0.005, p.y[1] - 0.005), (low + 0.031, p.h - 0.05))
    yield box("lid", BLACK, p.x, p.y, (p.h - 0.04, p.h))


def curtain(p: Piece) -> Iterator[Part]:
    """Yield a pair of curtains in folds on a rod, drawn aside."""
    yield cylinder("rod", p.metal, (p.h - 0.02, 0.0), 0.015, p.y, axis="y", sides=8)
    wide = 0.26 * p.w
    for y0 in (p.y[0] + 0.03, p.y[1] - 0.03 - wide):
        folds = max(4, round(wide / 0.07))
        for i in range(folds):
            y = y0 + (i + 0.5) * wide / folds
            yield oval("fold", p.bedding, (0.0, y), ((p.d / 2, 0.5 * wide / folds), (0.34 * p.d, 0.5 * wide / folds)), (0.0, p.h - 0.035), sides=8)


def blinds(p: Piece) -> Iterator[Part]:
    """Yield slats under a head rail."""
    yield box("head rail", WHITE, p.x, p.y, (p.h - 0.05, p.h))
    for i in range(n := max(6, min(24, round((p.h - 0.07) / 0.055)))):
        z = 0.03 + i * (p.h - 0.09) / n
        slat = box("slat", LINEN, (p.x[0] + 0.008, p.x[1] - 0.008), (p.y[0] + 0.01, p.y[1] - 0.01), (z, z + 0.006))
        slat.vertices[slat.vertices[:, 0] < 0, 2] += 0.02
        yield slat
    yield box("bottom rail", WHITE, (p.x[0] + 0.01, p.x[1] - 0.01), (p.y[0] + 0.01, p.y[1] - 0.01), (0.0, 0.02))


def christmas_tree(p: Piece) -> Iterator[Part]:
    """Yield a fir with balls and a star."""
    yield cylinder("pot", p.accent, (0.0, 0.0), (0.14 * p.d, 0.18 * p.d), (0.0, 0.12 * p.h), sides=14)
    yield cylinder("trunk", p.dark, (0.0, 0.0), 0.03, (0.12 * p.h, 0.2 * p.h), sides=8)
    for i, (low, high, r) in enumerate(((0.17, 0.52, 0.5), (0.38, 0.72, 0.38), (0.6, 0.95, 0.26))):
        rows = ((r * p.d, r * p.w), (0.02, 0.02))
        yield oval("branches", (LEAF_DARK, GREEN, LEAF_DARK)[i], (0.0, 0.0), rows, (low * p.h, high * p.h), sides=16)
        for j in range(6):
            turn = 2 * math.pi * j / 6 + i
            x, y = 0.8 * r * p.d * math.cos(turn), 0.8 * r * p.w * math.sin(turn)
            z = (low + 0.07) * p.h
            yield ball("bauble", BRIGHT[(i + j) % 3], (x - 0.03, x + 0.03), (y - 0.03, y + 0.03), (z - 0.03, z + 0.03), rings=3, sides=8)
    yield ball("star", YELLOW, (-0.04, 0.04), (-0.05, 0.05), (0.94 * p.h, p.h), rings=1, sides=5)


def plant(p: Piece) -> Iterator[Part]:
    """Yield a leafy plant in a pot: big leaves on stems, or blades."""
    pot, r = 0.26 * p.h, 0.26 * min(p.d, p.w)
    yield cylinder("pot", (TERRACOTTA, p.accent, CERAMIC)[p.variant % 3], (0.0, 0.0), (0.75 * r, r), (0.0, pot), sides=18)
    yield cylinder("soil", SOIL, (0.0, 0.0), 0.9 * r, (pot, pot + 0.006), sides=18)
    rng = p.rng()
    if p.variant % 4 == 1:
        yield from _blades(p, pot, r)
        return
    for i in range(15):
        turn, rise = 2.4 * i, (i + 1) / 15
        out = math.sin(math.pi * (0.25 + 0.6 * rise))
        size = 0.17 * min(p.d, p.w) * rng.uniform(0.9, 1.2)
        x, y = (0.5 * p.d - size) * out * math.cos(turn), (0.5 * p.w - size) * out * math.sin(turn)
        z = pot + (p.h - pot) * (0.16 + 0.78 * rise)
        stem = box("stem", LEAF_DARK, (-0.006, 0.006), (-0.006, 0.006), (pot, z - 0.01))
        upper = stem.vertices[:, 2] > pot + 1e-6
        stem.vertices[upper, 0] += 0.8 * x
        stem.vertices[upper, 1] += 0.8 * y
        yield stem
        tone = (LEAF, LEAF_LIGHT, LEAF_DARK)[i % 3]
        yield leaf(tone, (x, y, z), turn, size, droop=0.5)


def leaf(tone: Material, at: tuple[float, float, float], turn: float, size: float, *, droop: float) -> Part:
    """Return a pointed leaf of length 2 x `size` about `at`, pointing outwards, its tip lower by `droop` sizes."""
    outline = [(-1.0, 0.0), (-0.4, -0.55), (0.3, -0.5), (1.0, 0.0), (0.3, 0.5), (-0.4, 0.55)]
    part = prism("leaf", tone, [(size * x, size * y) for x, y in outline], (-0.02 * size, 0.06 * size))
    part.vertices[:, 2] += at[2] - droop * part.vertices[:, 0] * 0.6
    c, s = math.cos(turn), math.sin(turn)
    x, y = part.vertices[:, 0].copy(), part.vertices[:, 1].copy()
    part.vertices[:, 0], part.vertices[:, 1] = at[0] + c * x - s * y, at[1] + s * x + c * y
    return part


def _blades(p: Piece, low: float, r: float) -> Iterator[Part]:
    """Yield upright blades that fan out: a snake plant or a palm."""
    rng = p.rng()
    for i in range(13):
        turn, out = 2.4 * i, (i + 0.5) / 13
        x, y = 0.5 * r * math.cos(turn), 0.5 * r * math.sin(turn)
        top = p.h - (p.h - low) * 0.5 * out * rng.uniform(0.5, 1.0)
        wide = 0.08 * min(p.d, p.w)
        blade = prism("blade", (LEAF, LEAF_LIGHT, LEAF_DARK)[i % 3], [(-0.01, -wide), (0.01, -wide), (0.01, wide), (-0.01, wide)], (low, top))
        upper = blade.vertices[:, 2] > low + 1e-6
        blade.vertices[upper, 1] *= 0.15
        bx, by = blade.vertices[:, 0].copy(), blade.vertices[:, 1].copy()
        blade.vertices[:, 0] = x + math.cos(turn) * bx - math.sin(turn) * by
        blade.vertices[:, 1] = y + math.sin(turn) * bx + math.cos(turn) * by
        blade.vertices[upper, 0] += (0.46 * p.d - abs(x)) * out * math.cos(turn)
        blade.vertices[upper, 1] += (0.46 * p.w - abs(y)) * out * math.sin(turn)
        yield blade


def potted_plant(p: Piece) -> Iterator[Part]:
    """Yield a small plant: succulent rosette, cactus or herb."""
    pot, r = 0.42 * p.h, 0.36 * min(p.d, p.w)
    yield cylinder("pot", (CERAMIC, TERRACOTTA, p.accent)[p.variant % 3], (0.0, 0.0), (0.75 * r, r), (0.0, pot), sides=16)
    yield cylinder("soil", SOIL, (0.0, 0.0), 0.88 * r, (pot, pot + 0.003), sides=16)
    for i in range(12):
        turn, rise = 2.4 * i, (i + 1) / 12
        size = 0.2 * min(p.d, p.w)
        out = 1.0 - 0.85 * rise
        x, y = (0.5 * p.d - size) * out * math.cos(turn), (0.5 * p.w - size) * out * math.sin(turn)
        z = pot + (p.h - pot) * (0.2 + 0.7 * rise)
        yield leaf((LEAF, LEAF_LIGHT, LEAF_DARK)[i % 3], (x, y, z), turn, size, droop=-0.7 * rise)
    yield cylinder("stem", LEAF_DARK, (0.0, 0.0), 0.06 * p.d, (pot, p.h - 0.1 * p.h), sides=7)


def tree(p: Piece) -> Iterator[Part]:
    """Yield a small tree with a round crown in a large pot."""
    pot = 0.2 * p.h
    r = 0.22 * min(p.d, p.w)
    yield cylinder("pot", (p.accent, TERRACOTTA, CERAMIC)[p.variant % 3], (0.0, 0.0), (0.8 * r, r), (0.0, pot), sides=20)
    yield cylinder("soil", SOIL, (0.0, 0.0), 0.9 * r, (pot, pot + 0.01), sides=20)
    yield cylinder("trunk", p.dark, (0.0, 0.0), (0.04, 0.025), (pot, 0.6 * p.h), sides=8)
    for i, (x, y, z, s) in enumerate(((0.0, 0.0, 0.78, 0.3), (0.18, 0.12, 0.66, 0.24), (-0.2, 0.1, 0.64, 0.24), (0.02, -0.22, 0.66, 0.24), (0.0, 0.04, 0.58, 0.28))):
        span = ((x - s) * p.d, (x + s) * p.d), ((y - s) * p.w, (y + s) * p.w)
        tall = 0.2 if i == 0 else 0.14
        yield ball("crown", (LEAF, LEAF_DARK, LEAF_LIGHT)[i % 3], *span, ((z - tall) * p.h, min(z + tall, 1.0) * p.h), rings=4, sides=10)


def hanging_plant(p: Piece) -> Iterator[Part]:
    """Yield a pot on cords with trailing leaves."""
    low, high = 0.38 * p.h, 0.6 * p.h
    r = 0.28 * min(p.d, p.w)
    yield cylinder("pot", p.accent, (0.0, 0.0), (0.7 * r, r), (low, high), sides=16)
    for i in range(3):
        turn = 2 * math.pi * i / 3
        cord = box("cord", LINEN, (-0.003, 0.003), (-0.003, 0.003), (high, p.h))
        below = cord.vertices[:, 2] < high + 0.01
        cord.vertices[below, 0] += 0.95 * r * math.cos(turn)
        cord.vertices[below, 1] += 0.95 * r * math.sin(turn)
        yield cord
    yield ball("leaves", LEAF, (-1.1 * r, 1.1 * r), (-1.1 * r, 1.1 * r), (high - 0.04, high + 0.16 * p.h), rings=3, sides=9)
    for i in range(14):
        turn, fall = 2.4 * i, (i % 5) / 4
        size = 0.13 * min(p.d, p.w)
        x, y = (0.5 * p.d - size) * math.cos(turn), (0.5 * p.w - size) * math.sin(turn)
        z = high + 0.02 - fall * (high - 0.06)
        yield leaf((LEAF, LEAF_LIGHT, LEAF_DARK)[i % 3], (0.9 * x, 0.9 * y, max(z, 0.05)), turn, size, droop=0.8)


def planter(p: Piece) -> Iterator[Part]:
    """Yield a long box full of plants."""
    pot = 0.5 * p.h
    yield box("box", p.wood, p.x, p.y, (0.0, pot))
    yield box("soil", SOIL, (p.x[0] + 0.02, p.x[1] - 0.02), (p.y[0] + 0.02, p.y[1] - 0.02), (pot, pot + 0.004))
    count = max(2, round(p.w / (0.7 * p.d)))
    for i in range(count):
        y, half = p.y[0] + (i + 0.5) * p.w / count, 0.5 * p.w / count
        yield ball("shrub", (LEAF, LEAF_DARK, LEAF_LIGHT)[i % 3], (0.96 * p.x[0], 0.96 * p.x[1]), (y - half, y + half), (pot - 0.02, p.h - 0.06 * p.h * (i % 2)), rings=4, sides=9)


def plant_stand(p: Piece) -> Iterator[Part]:
    """Yield a stepped rack with pots on it."""
    steps = 3
    rng = p.rng()
    for i in range(steps):
        x = (p.x[0] + (steps - 1 - i) * p.d / steps, p.x[0] + (steps - i) * p.d / steps)
        level = (0.16 + 0.2 * i) * p.h
        yield box("step", p.wood, x, (p.y[0], p.y[1]), (level - 0.02, level))
        for y0 in (p.y[0] + 0.02, p.y[1] - 0.05):
            yield box("leg", p.dark, (x[0] + 0.01, x[0] + 0.04), (y0, y0 + 0.03), (0.0, level - 0.02))
        for j in range(n := max(2, round(p.w / 0.24))):
            y = p.y[0] + (j + 0.5) * p.w / n
            r = 0.3 * p.d / steps
            middle = (x[0] + x[1]) / 2
            yield cylinder("pot", rng.choice((TERRACOTTA, CERAMIC, p.accent)), (middle, y), (0.8 * r, r), (level, level + 0.13 * p.h), sides=10)
            tone = rng.choice((LEAF, LEAF_LIGHT, LEAF_DARK, PINK, YELLOW))
            yield ball("bush", tone, (middle - 1.3 * r, middle + 1.3 * r), (y - 1.5 * r, y + 1.5 * r), (level + 0.11 * p.h, level + 0.42 * p.h), rings=3, sides=8)


def flower_bucket(p: Piece) -> Iterator[Part]:
    """Yield a zinc bucket full of cut flowers."""
    top = 0.5 * p.h
    yield _disc(p, "bucket", STEEL, (0.64, 0.82), (0.0, 0.5), sides=18)
    tones = (PINK, YELLOW, WHITE, ORANGE, p.accent)
    start = p.variant % len(tones)
    yield from bunch(p, top, tones[start:] + tones[:start][:1])


def wreath(p: Piece) -> Iterator[Part]:
    """Yield a ring of leaves with berries."""
    for i in range(16):
        turn = 2 * math.pi * i / 16
        y, z = 0.4 * p.w * math.cos(turn), p.h / 2 + 0.4 * p.h * math.sin(turn)
        r = 0.1 * min(p.w, p.h)
        yield ball("tuft", (LEAF, LEAF_DARK)[i % 2], p.x, (y - r, y + r), (z - r, z + r), rings=3, sides=8)
        if i % 4 == 0:
            yield ball("berry", BRIGHT[0], (0.2 * p.d, p.x[1] + 0.1 * p.d), (y - 0.3 * r, y + 0.3 * r), (z - 0.3 * r, z + 0.3 * r), rings=2, sides=6)


def green_wall(p: Piece) -> Iterator[Part]:
    """Yield a panel covered with tufts of leaves."""
    yield box("panel", p.dark, (p.x[0], p.x[0] + 0.3 * p.d), p.y, p.z)
    columns, rows = max(2, min(8, round(p.w / 0.26))), max(2, min(8, round(p.h / 0.26)))
    for i in range(columns):
        for j in range(rows):
            y, z = p.y[0] + (i + 0.5) * p.w / columns, (j + 0.5) * p.h / rows
            a, b = 0.5 * p.w / columns, 0.5 * p.h / rows
            tone = (LEAF, LEAF_LIGHT, LEAF_DARK, GREEN)[(3 * i + 5 * j + p.variant) % 4]
            yield ball("tuft", tone, (p.x[0] + 0.2 * p.d, p.x[1] - 0.1 * p.d * ((i + j) % 3)), (y - a, y + a), (z - b, z + b), rings=3, sides=8)


def rug(p: Piece) -> Iterator[Part]:
    """Yield a rug: border, field, and a pattern; round where depth and width are equal."""
    t = p.h
    if abs(p.d - p.w) < 0.05 and p.variant % 2:
        for i, tone in enumerate((p.fabric, p.bedding, p.accent)):
            yield cylinder("ring", tone, (0.0, 0.0), (1.0 - 0.28 * i) * p.d / 2, (0.0, (0.72 + 0.14 * i) * t), sides=40)
        return
    yield box("border", p.fabric, p.x, p.y, (0.0, 0.72 * t))
    b = 0.08 * min(p.d, p.w)
    yield box("field", p.bedding, (p.x[0] + b, p.x[1] - b), (p.y[0] + b, p.y[1] - b), (0.0, 0.86 * t))
    yield from _pattern(p, 1.6 * b)


def _pattern(p: Piece, inset: float) -> Iterator[Part]:
    """Yield stripes, diamonds or an inner frame on a rug."""
    z = (0.1 * p.h, p.h)
    style = p.variant % 3
    if style == 0:
        for i in range(7):
            y = p.y[0] + inset + (i + 0.5) * (p.w - 2 * inset) / 7
            yield box("stripe", (p.accent, p.fabric)[i % 2], (p.x[0] + inset, p.x[1] - inset), (y - 0.02 * p.w, y + 0.02 * p.w), z)
        return
    if style == 1:
        for i in range(n := max(2, round(p.w / p.d * 2))):
            y, r = p.y[0] + (i + 0.5) * p.w / n, 0.3 * p.w / n
            yield prism("diamond", (p.accent, p.fabric)[i % 2], [(0.3 * p.d, y), (0.0, y + r), (-0.3 * p.d, y), (0.0, y - r)], z)
        return
    yield box("inner", p.accent, (p.x[0] + inset, p.x[1] - inset), (p.y[0] + inset, p.y[1] - inset), (0.0, 0.93 * p.h))
    far = inset + 0.04 * min(p.d, p.w)
    yield box("centre", p.bedding, (p.x[0] + far, p.x[1] - far), (p.y[0] + far, p.y[1] - far), (0.0, p.h))


def mat(p: Piece) -> Iterator[Part]:
    """Yield a plain mat with a darker border."""
    yield box("border", p.fabric if p.kind != "door mat" else DARK, p.x, p.y, (0.0, 0.8 * p.h))
    b = 0.06 * min(p.d, p.w)
    tone = p.accent if p.kind != "door mat" else p.wood
    yield box("field", tone, (p.x[0] + b, p.x[1] - b), (p.y[0] + b, p.y[1] - b), (0.0, p.h))


def tissue_box(p: Piece) -> Iterator[Part]:
    """Yield a box with a tissue that looks out."""
    yield box("box", p.accent, p.x, p.y, (0.0, 0.78 * p.h))
    yield slab("tissue", WHITE, (-0.18 * p.d, 0.18 * p.d), (-0.24 * p.w, 0.24 * p.w), (0.78 * p.h, p.h), top=(0.2, 0.9))


def bird_cage(p: Piece) -> Iterator[Part]:
    """Yield a wire cage on a stand with a bird."""
    low = 0.45 * p.h if p.h > 0.8 else 0.0
    r = min(p.d, p.w) / 2
    if low:
        yield cylinder("foot", p.metal, (0.0, 0.0), (0.7 * r, 0.5 * r), (0.0, 0.03), sides=18)
        yield cylinder("pole", p.metal, (0.0, 0.0), 0.016, (0.03, low), sides=8)
    yield cylinder("floor", p.metal, (0.0, 0.0), r, (low, low + 0.04), sides=18)
    for i in range(14):
        turn = 2 * math.pi * i / 14
        yield cylinder("wire", p.metal, (0.96 * r * math.cos(turn), 0.96 * r * math.sin(turn)), 0.004, (low + 0.04, 0.88 * p.h), sides=4)
    yield cylinder("roof", p.metal, (0.0, 0.0), (r, 0.1 * r), (0.88 * p.h, p.h), sides=18)
    middle = (low + p.h) / 2
    yield cylinder("perch", p.wood, (middle - 0.05, 0.0), 0.008, (-0.9 * r, 0.9 * r), axis="y", sides=6)
    yield ball("bird", YELLOW, (-0.03, 0.04), (-0.03, 0.03), (middle - 0.04, middle + 0.06), rings=4, sides=8)


def pet_bed(p: Piece) -> Iterator[Part]:
    """Yield an oval cushion in a padded ring."""
    yield oval("ring", p.fabric, (0.0, 0.0), ((p.d / 2, p.w / 2), (0.46 * p.d, 0.46 * p.w)), (0.0, 0.85 * p.h), sides=24)
    yield oval("cushion", p.bedding, (0.0, 0.0), ((0.38 * p.d, 0.38 * p.w), (0.34 * p.d, 0.34 * p.w)), (0.5 * p.h, p.h), sides=24)


def cat_tree(p: Piece) -> Iterator[Part]:
    """Yield posts with platforms, a house and a ball."""
    yield box("base", p.fabric, p.x, p.y, (0.0, 0.04))
    for x, y, top in ((-0.28, -0.28, 0.96), (0.24, 0.26, 0.62)):
        yield cylinder("post", p.wood, (x * p.d, y * p.w), 0.045, (0.04, top * p.h), sides=10)
    yield box("house", p.fabric, (-0.44 * p.d, 0.1 * p.d), (-0.1 * p.w, 0.44 * p.w), (0.3 * p.h, 0.5 * p.h))
    yield cylinder("door", BLACK, (0.17 * p.w, 0.4 * p.h), 0.08, (0.1 * p.d, 0.11 * p.d), axis="x", sides=14)
    yield box("platform", p.bedding, (-0.02 * p.d, p.x[1]), (0.02 * p.w, p.y[1]), (0.62 * p.h, 0.65 * p.h))
    yield soft("bed", p.bedding, (p.x[0], 0.1 * p.d), (p.y[0], 0.1 * p.w), (0.94 * p.h, p.h), bevel=0.02)


def radiator(p: Piece) -> Iterator[Part]:
    """Yield a ribbed radiator."""
    count = max(4, min(24, round(p.w / 0.07)))
    for i in range(count):
        y = p.y[0] + (i + 0.5) * p.w / count
        yield soft("rib", WHITE, p.x, (y - 0.4 * p.w / count, y + 0.4 * p.w / count), (0.06 * p.h, p.h), bevel=0.015)
    for z in (0.14 * p.h, 0.88 * p.h):
        yield box("pipe", LIGHT_GREY, (-0.2 * p.d, 0.2 * p.d), (0.98 * p.y[0], 0.98 * p.y[1]), (z - 0.02, z + 0.02))
    for y in (-0.36 * p.w, 0.36 * p.w):
        yield box("foot", LIGHT_GREY, (-0.3 * p.d, 0.3 * p.d), (y - 0.02, y + 0.02), (0.0, 0.08 * p.h))


def air_box(p: Piece) -> Iterator[Part]:
    """Yield a heater, purifier or air conditioner: a rounded white casing with slots."""
    yield soft("casing", WHITE, (p.x[0], p.x[1] - 0.01), p.y, p.z, bevel=0.03)
    span = (p.y[0] + 0.12 * p.w, p.y[1] - 0.12 * p.w)
    for i in range(5):
        z = (0.14 + 0.05 * i) * p.h if p.w > p.h else (0.2 + 0.12 * i) * p.h
        yield box("slot", DARK, (p.x[1] - 0.012, p.x[1] - 0.006), span, (z, z + 0.02 * p.h + 0.003))
    yield box("light", EMBER if p.kind == "space heater" else GREEN, (p.x[1] - 0.012, p.x[1]), (-0.02, 0.02), (0.86 * p.h, 0.86 * p.h + 0.012))


def fan(p: Piece) -> Iterator[Part]:
    """Yield a standing fan with a grille."""
    r = min(0.48 * p.w, 0.3 * p.h)
    middle = p.h - r
    yield cylinder("foot", p.metal, (0.0, 0.0), (0.48 * p.d, 0.44 * p.d), (0.0, 0.03), sides=20)
    yield cylinder("pole", p.metal, (-0.1 * p.d, 0.0), 0.016, (0.03, middle), sides=8)
    yield cylinder("motor", p.metal, (0.0, middle), (0.08, 0.1), (-0.26 * p.d, 0.0), axis="x", sides=12)
    yield cylinder("rim", STEEL, (0.0, middle), r, (0.0, 0.06), axis="x", sides=24)
    yield cylinder("shade", DARK, (0.0, middle), 0.94 * r, (0.06, 0.064), axis="x", sides=24)
    for i in range(4):
        turn = math.pi * i / 2 + 0.5
        y, z = 0.46 * r * math.cos(turn), middle + 0.46 * r * math.sin(turn)
        yield cylinder("blade", p.accent, (y, z), 0.34 * r, (0.064, 0.075), axis="x", sides=10)
    yield cylinder("hub", STEEL, (0.0, middle), 0.2 * r, (0.064, 0.09), axis="x", sides=12)


def backpack(p: Piece) -> Iterator[Part]:
    """Yield a bag with a pocket and a loop."""
    yield soft("bag", p.fabric, (p.x[0], 0.24 * p.d), p.y, (0.0, 0.94 * p.h), bevel=0.06)
    yield soft("pocket", p.accent, (0.2 * p.d, p.x[1]), (-0.34 * p.w, 0.34 * p.w), (0.06 * p.h, 0.5 * p.h), bevel=0.03)
    yield box("flap", p.accent, (0.24 * p.d, 0.28 * p.d), (-0.36 * p.w, 0.36 * p.w), (0.6 * p.h, 0.82 * p.h))
    yield box("loop", DARK, (-0.2 * p.d, -0.12 * p.d), (-0.12 * p.w, 0.12 * p.w), (0.93 * p.h, p.h))


def shoes(p: Piece) -> Iterator[Part]:
    """Yield a pair of shoes."""
    tone = p.rng().choice(SPINES)
    for y in (-0.26 * p.w, 0.26 * p.w):
        yield box("sole", BLACK, p.x, (y - 0.2 * p.w, y + 0.2 * p.w), (0.0, 0.14 * p.h))
        yield slab("toe", tone, (-0.1 * p.d, 0.48 * p.d), (y - 0.19 * p.w, y + 0.19 * p.w), (0.14 * p.h, 0.6 * p.h), top=(0.7, 0.7))
        yield slab("heel", tone, (-0.49 * p.d, 0.0), (y - 0.18 * p.w, y + 0.18 * p.w), (0.14 * p.h, p.h), top=(0.8, 0.8))


def trash_can(p: Piece) -> Iterator[Part]:
    """Yield a bin with a lid and a pedal."""
    tone = STEEL if p.variant % 2 else DARK
    if abs(p.d - p.w) < 0.06:
        yield _disc(p, "bin", tone, (0.86, 0.96), (0.0, 0.88), sides=20)
        yield _disc(p, "lid", BLACK if tone is DARK else DARK, (1.0, 0.84), (0.88, 1.0), sides=20)
        return
    yield slab("bin", tone, (p.x[0] + 0.01, p.x[1] - 0.02), (p.y[0] + 0.01, p.y[1] - 0.01), (0.0, 0.86 * p.h))
    yield slab("lid", p.accent, p.x, p.y, (0.862 * p.h, p.h), top=(0.86, 0.86))


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
    "picture": picture,
    "unknown wall decor": picture,
    "mirror": mirror,
    "floor mirror": floor_mirror,
    "wall clock": wall_clock,
    "alarm clock": alarm_clock,
    "grandfather clock": grandfather_clock,
    "tapestry": tapestry,
    "photo frame": photo_frame,
    "vase": vase,
    "unknown decor": vase,
    "statue": statue,
    "floor sculpture": floor_sculpture,
    "unknown floor decor": floor_sculpture,
    "trophy": trophy,
    "book": book,
    "book stack": book_stack,
    "magazine": magazine,
    "fireplace": fireplace,
    "aquarium": aquarium,
    "curtain": curtain,
    "shower curtain": curtain,
    "blinds": blinds,
    "christmas tree": christmas_tree,
    "plant": plant,
    "potted plant": potted_plant,
    "indoor tree": tree,
    "hanging plant": hanging_plant,
    "planter": planter,
    "plant stand": plant_stand,
    "flower bucket": flower_bucket,
    "wreath": wreath,
    "green wall": green_wall,
    "rug": rug,
    "unknown floor covering": rug,
    "door mat": mat,
    "bath mat": mat,
    "play mat": rug,
    "yoga mat": mat,
    "anti fatigue mat": mat,
    "tissue box": tissue_box,
    "bird cage": bird_cage,
    "pet bed": pet_bed,
    "cat tree": cat_tree,
    "radiator": radiator,
    "space heater": air_box,
    "air conditioner": air_box,
    "air purifier": air_box,
    "fan": fan,
    "backpack": backpack,
    "shoes": shoes,
    "trash can": trash_can,
}
