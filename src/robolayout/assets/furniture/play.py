"""Children's rooms and game rooms."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import KNOB, Builder, board, carcass, doors, drawers
from robolayout.assets.palette import (
    BLACK,
    BLUE,
    BRIGHT,
    LINEN,
    PINE,
    RED,
    RUBBER,
    STEEL,
    WHITE,
    YELLOW,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, oval, prism, sheared, slab, soft


def toy(p: Piece) -> Iterator[Part]:
    """Yield a toy: a tower of blocks or a wooden car."""
    if p.variant % 2:
        for i, (y, z) in enumerate(((-0.5, 0.0), (0.0, 0.0), (-0.25, 0.5))):
            yield box(
                "block",
                BRIGHT[(p.variant + i) % 6],
                (0.9 * p.x[0], 0.9 * p.x[1]),
                (y * p.w + 0.01, (y + 0.5) * p.w - 0.01),
                (z * p.h, (z + 0.5) * p.h - 0.001),
            )
        yield box("base", BRIGHT[p.variant % 3], p.x, (p.y[0] + 0.005, p.y[1] - 0.005), (-0.02 * p.h, -0.001))
        return
    yield soft("car", BRIGHT[p.variant % 6], p.x, (0.8 * p.y[0], 0.8 * p.y[1]), (0.16 * p.h, 0.6 * p.h), bevel=0.02)
    yield slab(
        "roof",
        BRIGHT[(p.variant + 3) % 6],
        (-0.3 * p.d, 0.2 * p.d),
        (0.7 * p.y[0], 0.7 * p.y[1]),
        (0.6 * p.h, p.h),
        top=(0.7, 0.8),
    )
    for x in (-0.28 * p.d, 0.28 * p.d):
        for y0, y1 in ((p.y[0], 0.8 * p.y[0]), (0.8 * p.y[1], p.y[1])):
            yield cylinder("wheel", RUBBER, (0.2 * p.h, x), 0.2 * p.h, (y0, y1), axis="y", sides=12)


def teddy_bear(p: Piece) -> Iterator[Part]:
    """Yield a sitting bear."""
    fur, light = p.dark, p.wood
    d, w, h = p.d, p.w, p.h
    yield ball("body", fur, (-0.36 * d, 0.2 * d), (-0.28 * w, 0.28 * w), (0.0, 0.62 * h))
    yield ball("belly", light, (0.0, 0.24 * d), (-0.18 * w, 0.18 * w), (0.1 * h, 0.5 * h), rings=4)
    yield ball("head", fur, (-0.3 * d, 0.24 * d), (-0.26 * w, 0.26 * w), (0.52 * h, 0.94 * h))
    yield ball("muzzle", light, (0.1 * d, 0.34 * d), (-0.1 * w, 0.1 * w), (0.58 * h, 0.74 * h), rings=4, sides=8)
    yield ball("nose", BLACK, (0.3 * d, 0.38 * d), (-0.04 * w, 0.04 * w), (0.67 * h, 0.73 * h), rings=3, sides=6)
    for side in (-1, 1):
        yield ball(
            "ear",
            fur,
            (-0.12 * d, 0.04 * d),
            (side * 0.24 * w - 0.09 * w, side * 0.24 * w + 0.09 * w),
            (0.82 * h, h),
            rings=3,
            sides=8,
        )
        yield ball(
            "eye",
            BLACK,
            (0.18 * d, 0.24 * d),
            (side * 0.1 * w - 0.025 * w, side * 0.1 * w + 0.025 * w),
            (0.74 * h, 0.79 * h),
            rings=3,
            sides=6,
        )
        yield ball(
            "arm",
            fur,
            (-0.12 * d, 0.2 * d),
            (side * 0.36 * w - 0.13 * w, side * 0.36 * w + 0.13 * w),
            (0.24 * h, 0.54 * h),
            rings=4,
            sides=8,
        )
        yield ball(
            "leg",
            fur,
            (-0.06 * d, 0.5 * d),
            (side * 0.26 * w - 0.13 * w, side * 0.26 * w + 0.13 * w),
            (0.0, 0.26 * h),
            rings=4,
            sides=8,
        )


def rocking_horse(p: Piece) -> Iterator[Part]:
    """Yield a wooden horse on runners; its head looks to +x."""
    d, w, h = p.d, p.w, p.h
    for side in (-1, 1):
        y = (side * 0.42 * w - 0.03, side * 0.42 * w + 0.03)
        for i, (a, b) in enumerate(((0.1, 0.02), (0.02, 0.0), (0.0, 0.02), (0.02, 0.1))):
            part = box("runner", p.dark, (p.x[0] + i * d / 4, p.x[0] + (i + 1) * d / 4), y, (0.0, 0.04))
            far = part.vertices[:, 0] > p.x[0] + (i + 0.5) * d / 4
            part.vertices[~far, 2] += a * h
            part.vertices[far, 2] += b * h
            yield part
        for x in (-0.22 * d, 0.18 * d):
            yield sheared("leg", p.wood, (x - 0.035, x + 0.035), y, (0.06, 0.5 * h), lean=(-0.2 * x, -side * 0.16 * w))
    yield soft("body", p.wood, (-0.32 * d, 0.28 * d), (-0.3 * w, 0.3 * w), (0.44 * h, 0.66 * h), bevel=0.05)
    yield soft("saddle", RED, (-0.16 * d, 0.1 * d), (-0.32 * w, 0.32 * w), (0.6 * h, 0.7 * h), bevel=0.02)
    yield sheared("neck", p.wood, (0.16 * d, 0.3 * d), (-0.16 * w, 0.16 * w), (0.6 * h, 0.92 * h), lean=(0.1 * d, 0.0))
    yield soft("head", p.wood, (0.24 * d, 0.5 * d), (-0.17 * w, 0.17 * w), (0.78 * h, 0.96 * h), bevel=0.03)
    yield sheared("mane", p.dark, (0.13 * d, 0.17 * d), (-0.1 * w, 0.1 * w), (0.66 * h, h), lean=(0.12 * d, 0.0))
    yield cylinder("handle", p.dark, (0.82 * h, 0.3 * d), 0.014, (-0.5 * w, 0.5 * w), axis="y", sides=8)
    yield sheared(
        "tail", p.dark, (-0.42 * d, -0.36 * d), (-0.06 * w, 0.06 * w), (0.36 * h, 0.62 * h), lean=(0.06 * d, 0.0)
    )


def doll_house(p: Piece) -> Iterator[Part]:
    """Yield a doll's house, open at the front, with a red roof."""
    wall, eaves = 0.02, 0.68 * p.h
    for y0 in (p.y[0] + 0.03, p.y[1] - 0.03 - wall):
        yield box("wall", WHITE, (p.x[0] + 0.02, p.x[1] - 0.02), (y0, y0 + wall), (0.0, eaves))
    inner = (p.y[0] + 0.03 + wall, p.y[1] - 0.03 - wall)
    yield box("back", p.accent, (p.x[0] + 0.02, p.x[0] + 0.03), inner, (0.0, eaves))
    for z in (0.0, 0.34 * p.h, eaves - 0.02):
        yield box("floor", p.wood, (p.x[0] + 0.03, p.x[1] - 0.022), inner, (z, z + 0.02))
    for z in (0.02, 0.34 * p.h + 0.02):
        yield box("partition", WHITE, (p.x[0] + 0.03, p.x[1] - 0.03), (-0.01, 0.01), (z, z + 0.29 * p.h))
        yield box(
            "toy bed", BLUE, (p.x[0] + 0.05, 0.1 * p.d), (0.5 * p.y[0] - 0.06, 0.5 * p.y[0] + 0.06), (z, z + 0.06)
        )
        yield box("toy table", PINE, (-0.1 * p.d, 0.2 * p.d), (0.5 * p.y[1] - 0.05, 0.5 * p.y[1] + 0.05), (z, z + 0.08))
    roof = [(p.y[0], eaves + 0.001), (p.y[1], eaves + 0.001), (0.0, p.h)]
    yield prism("roof", RED, roof, p.x, axis="x")


def play_kitchen(p: Piece) -> Iterator[Part]:
    """Yield a small kitchen with hob, sink, oven and a rack."""
    top = 0.56 * p.h
    yield carcass(p, p.front, (0.0, top - 0.02))
    yield board(p, p.wood, (top - 0.019, top))
    yield from doors(p, p.accent, (p.y[0], 0.0), (0.0, top - 0.02), count=1)
    yield box("oven", BLACK, (p.x[1] - 0.04, p.x[1] - KNOB), (0.03, p.y[1] - 0.03), (0.1, 0.4 * p.h))
    for y in (-0.36, -0.16):
        yield cylinder("plate", BLACK, (0.05, y * p.w), 0.06, (top, top + 0.004), sides=14)
    yield oval("sink", STEEL, (0.03, 0.24 * p.w), ((0.09, 0.12),) * 2, (top, top + 0.004), sides=16)
    yield box("back", p.front, (p.x[0], p.x[0] + 0.02), p.y, (top, p.h))
    yield box("rack", p.wood, (p.x[0] + 0.02, p.x[0] + 0.14), (0.96 * p.y[0], 0.96 * p.y[1]), (0.84 * p.h, 0.86 * p.h))
    for i in range(4):
        yield cylinder(
            "cup",
            BRIGHT[i],
            (p.x[0] + 0.08, (-0.33 + 0.22 * i) * p.w),
            (0.03, 0.04),
            (0.86 * p.h, 0.94 * p.h),
            sides=10,
        )


def play_tent(p: Piece) -> Iterator[Part]:
    """Yield a tipi with an opening at the front, poles and a flag line."""
    low, high = 0.5, 0.06
    tilt = 0.86 * p.h

    def corner(sx: int, sy: int) -> tuple[float, float]:
        return (sx * (low - 0.02) * p.d, sy * (low - 0.02) * p.w)

    for sx, sy in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        x, y = corner(sx, sy)
        lean, thick = (-x * 1.16, -y * 1.16), 0.017 + 0.001 * sx + 0.002 * sy
        yield sheared(
            "pole",
            p.wood,
            (x - thick, x + thick),
            (y - thick, y + thick),
            (0.0, p.h - 0.002 * sx - 0.004 * sy),
            lean=lean,
        )
    for axis in (0, 1, 2):
        rows = {
            0: ((-low * p.d, -low * p.w), (-low * p.d, low * p.w)),
            1: ((-low * p.d, low * p.w), (low * p.d, low * p.w)),
            2: ((low * p.d, -low * p.w), (-low * p.d, -low * p.w)),
        }[axis]
        yield _cloth(p, rows, high, tilt)
    flap = ((low * p.d, low * p.w), (low * p.d, 0.16 * p.w))
    yield _cloth(p, flap, high, tilt)
    yield _cloth(p, ((low * p.d, -0.16 * p.w), (low * p.d, -low * p.w)), high, tilt)
    yield cylinder("cushion", p.accent, (0.0, 0.0), 0.26 * p.d, (0.0, 0.06), sides=16)


def _cloth(p: Piece, ends: tuple[tuple[float, float], tuple[float, float]], high: float, top: float) -> Part:
    """Return a thin panel from two floor points to a small line near the top."""
    part = box("cloth", LINEN, (0.0, 1.0), (0.0, 1.0), (0.0, top))
    share, inner, upper = part.vertices[:, 1].copy(), part.vertices[:, 0] > 0.5, part.vertices[:, 2] > 0
    for i in range(2):
        line = ends[0][i] + (ends[1][i] - ends[0][i]) * share
        part.vertices[:, i] = line * (1.0 - 0.02 * inner) * (1.0 - (1.0 - high / 0.5) * upper)
    if (ends[0][0] * ends[1][1] - ends[0][1] * ends[1][0]) > 0:
        return Part(part.name, part.vertices, part.faces[:, ::-1].copy(), part.material)
    return part


def play_gym(p: Piece) -> Iterator[Part]:
    """Yield a baby gym: a round mat under crossed arches with toys."""
    yield oval("mat", p.accent, (0.0, 0.0), ((p.d / 2, p.w / 2),) * 2, (0.0, 0.05 * p.h), sides=24)
    for way in (1, -1):
        for side in (1, -1):
            x, y = side * 0.33 * p.d, way * side * 0.33 * p.w
            lean = (-0.94 * x, -0.94 * y)
            yield sheared("arch", WHITE, (x - 0.014, x + 0.014), (y - 0.014, y + 0.014), (0.05 * p.h, p.h), lean=lean)
    for i, (x, y) in enumerate(((0.1, 0.1), (-0.1, 0.1), (0.1, -0.1), (-0.1, -0.1))):
        yield ball(
            "toy",
            BRIGHT[i],
            (x * p.d - 0.03, x * p.d + 0.03),
            (y * p.w - 0.03, y * p.w + 0.03),
            (0.56 * p.h, 0.56 * p.h + 0.06),
            rings=3,
            sides=8,
        )
        yield cylinder("string", LINEN, (x * p.d, y * p.w), 0.003, (0.56 * p.h + 0.05, 0.78 * p.h), sides=4)


def changing_table(p: Piece) -> Iterator[Part]:
    """Yield a chest with a padded tray on top."""
    top = p.h - 0.1
    yield carcass(p, p.wood, (0.03, top - 0.02))
    yield box("plinth", p.dark, (p.x[0] + 0.02, p.x[1] - 0.07), (p.y[0] + 0.02, p.y[1] - 0.02), (0.0, 0.03))
    yield board(p, p.wood, (top - 0.019, top))
    yield from drawers(p, p.front, p.y, (0.03, top - 0.02), rows=3, knobs=True)
    for y0 in (p.y[0], p.y[1] - 0.02):
        yield box("side", p.wood, p.x, (y0, y0 + 0.02), (top, p.h))
    yield box("back", p.wood, (p.x[0], p.x[0] + 0.02), (p.y[0] + 0.02, p.y[1] - 0.02), (top, p.h))
    yield soft(
        "pad",
        p.bedding,
        (p.x[0] + 0.025, p.x[1] - 0.01),
        (p.y[0] + 0.025, p.y[1] - 0.025),
        (top, top + 0.06),
        bevel=0.02,
    )


def playpen(p: Piece) -> Iterator[Part]:
    """Yield a pen with bars on four sides and a mat with toys."""
    yield box("mat", p.accent, (0.96 * p.x[0], 0.96 * p.x[1]), (0.96 * p.y[0], 0.96 * p.y[1]), (0.0, 0.03))
    for z in (0.03, p.h - 0.04):
        for y0 in (p.y[0], p.y[1] - 0.03):
            yield box("rail", p.wood, p.x, (y0, y0 + 0.03), (z, z + 0.04))
        for x0 in (p.x[0], p.x[1] - 0.03):
            yield box("rail", p.wood, (x0, x0 + 0.03), (p.y[0] + 0.03, p.y[1] - 0.03), (z, z + 0.04))
    for i in range(n := max(6, min(12, round(p.w / 0.11)))):
        share = (i + 0.5) / n
        for y in (p.y[0] + 0.015, p.y[1] - 0.015):
            yield cylinder("bar", p.wood, (p.x[0] + share * p.d, y), 0.008, (0.07, p.h - 0.04), sides=6)
        for x in (p.x[0] + 0.015, p.x[1] - 0.015):
            yield cylinder("bar", p.wood, (x, p.y[0] + share * p.w), 0.008, (0.07, p.h - 0.04), sides=6)
    yield ball("ball", BRIGHT[0], (0.0, 0.2), (0.05, 0.25), (0.03, 0.23))
    yield box("block", BRIGHT[4], (-0.2, -0.1), (-0.2, -0.1), (0.03, 0.13))


def slide(p: Piece) -> Iterator[Part]:
    """Yield a slide: ladder at the back, chute to the front."""
    top = 0.72 * p.h
    half = 0.42 * p.w
    for y in (-half, half - 0.03):
        yield box("post", BLUE, (p.x[0], p.x[0] + 0.04), (y, y + 0.03), (0.0, p.h))
        yield box("post", BLUE, (p.x[0] + 0.3 * p.d - 0.04, p.x[0] + 0.3 * p.d), (y, y + 0.03), (0.0, top - 0.03))
        rail = box("rail", RED, (p.x[0] + 0.3 * p.d, p.x[1]), (y, y + 0.03), (-0.02, 0.1))
        rail.vertices[:, 2] += 0.03 + (p.x[1] - rail.vertices[:, 0]) / (0.7 * p.d) * (top - 0.03)
        yield rail
        yield box("guard", BLUE, (p.x[0] + 0.04, p.x[0] + 0.3 * p.d), (y, y + 0.03), (p.h - 0.04, p.h))
    for i in range(1, 4):
        z = i * top / 4
        yield box("rung", YELLOW, (p.x[0] + 0.004, p.x[0] + 0.036), (-half + 0.03, half - 0.03), (z - 0.02, z + 0.02))
    yield box("deck", YELLOW, (p.x[0] + 0.002, p.x[0] + 0.3 * p.d - 0.002), p.y, (top - 0.034, top))
    chute = box("chute", YELLOW, (p.x[0] + 0.3 * p.d + 0.001, p.x[1]), (-half + 0.03, half - 0.03), (0.0, 0.02))
    chute.vertices[:, 2] += 0.01 + (p.x[1] - chute.vertices[:, 0]) / (0.7 * p.d) * (top - 0.03)
    yield chute


def trampoline(p: Piece) -> Iterator[Part]:
    """Yield a small round trampoline."""
    for i in range(6):
        turn = 2 * math.pi * i / 6
        yield cylinder(
            "leg", STEEL, (0.44 * p.d * math.cos(turn), 0.44 * p.w * math.sin(turn)), 0.018, (0.0, 0.78 * p.h), sides=8
        )
    yield oval("pad", p.accent, (0.0, 0.0), ((p.d / 2, p.w / 2),) * 2, (0.78 * p.h, 0.97 * p.h), sides=28)
    yield oval("mat", BLACK, (0.0, 0.0), ((0.38 * p.d, 0.38 * p.w),) * 2, (0.97 * p.h, p.h), sides=28)


def easel(p: Piece) -> Iterator[Part]:
    """Yield an easel with a painting."""
    for y in (-0.42 * p.w, 0.42 * p.w):
        yield sheared(
            "leg", p.wood, (p.x[1] - 0.03, p.x[1]), (y - 0.015, y + 0.015), (0.0, p.h), lean=(-0.4 * p.d, -0.6 * y)
        )
    yield sheared("stay", p.wood, (p.x[0], p.x[0] + 0.03), (-0.015, 0.015), (0.0, 0.9 * p.h), lean=(0.5 * p.d, 0.0))
    yield box("ledge", p.wood, (0.16 * p.d, 0.4 * p.d), p.y, (0.36 * p.h, 0.39 * p.h))
    for name, tone, inset, x in (("canvas", WHITE, 0.0, 0.3), ("paint", p.accent, 0.08, 0.345)):
        part = box(
            name,
            tone,
            (x * p.d, x * p.d + 0.02),
            (0.9 * p.y[0] + inset, 0.9 * p.y[1] - inset),
            (0.39 * p.h + inset, 0.92 * p.h - inset),
        )
        part.vertices[:, 0] -= 0.4 * p.d * (part.vertices[:, 2] / p.h - 0.39)
        yield part


def stroller(p: Piece) -> Iterator[Part]:
    """Yield a pram with a hood and four wheels; it is pushed from behind."""
    r = 0.14 * p.h
    for x in (-0.28 * p.d, 0.34 * p.d):
        for y in (p.y[0] + 0.03, p.y[1] - 0.03):
            yield cylinder("wheel", RUBBER, (r, x), r, (y - 0.02, y + 0.02), axis="y", sides=16)
        yield box("axle", STEEL, (x - 0.01, x + 0.01), (0.8 * p.y[0], 0.8 * p.y[1]), (r - 0.01, r + 0.01))
    for y in (0.62 * p.y[0], 0.62 * p.y[1]):
        yield sheared(
            "frame",
            STEEL,
            (0.34 * p.d - 0.014, 0.34 * p.d + 0.014),
            (y - 0.012, y + 0.012),
            (r, p.h - 0.02),
            lean=(-0.8 * p.d, 0.0),
        )
    yield box("handle", BLACK, (p.x[0], p.x[0] + 0.05), (0.7 * p.y[0], 0.7 * p.y[1]), (p.h - 0.04, p.h))
    yield slab(
        "cot",
        p.fabric,
        (-0.24 * p.d, 0.38 * p.d),
        (0.7 * p.y[0], 0.7 * p.y[1]),
        (0.36 * p.h, 0.62 * p.h),
        top=(1.2, 1.2),
    )
    yield soft("cover", p.accent, (0.0, 0.44 * p.d), (0.8 * p.y[0], 0.8 * p.y[1]), (0.6 * p.h, 0.67 * p.h), bevel=0.02)
    yield ball("hood", p.fabric, (-0.36 * p.d, 0.06 * p.d), (0.86 * p.y[0], 0.86 * p.y[1]), (0.5 * p.h, 0.96 * p.h))


def scooter(p: Piece) -> Iterator[Part]:
    """Yield a kick scooter."""
    r = 0.1 * p.h
    for x in (p.x[0] + r, p.x[1] - r):
        yield cylinder("wheel", RUBBER, (r, x), r, (-0.02, 0.02), axis="y", sides=14)
    yield box("deck", p.accent, (p.x[0] + 1.6 * r, p.x[1] - 2.6 * r), (-0.07, 0.07), (0.1 * p.h, 0.14 * p.h))
    yield sheared(
        "column",
        STEEL,
        (p.x[1] - r - 0.015, p.x[1] - r + 0.015),
        (-0.015, 0.015),
        (2 * r, p.h - 0.03),
        lean=(-0.1 * p.d, 0.0),
    )
    yield sheared(
        "fork", STEEL, (p.x[1] - 2.6 * r, p.x[1] - 2.2 * r), (-0.024, 0.024), (0.1 * p.h, 2.2 * r), lean=(1.2 * r, 0.0)
    )
    yield cylinder("handle bar", BLACK, (p.h - 0.02, p.x[1] - r - 0.1 * p.d), 0.02, p.y, axis="y", sides=8)


def swing(p: Piece) -> Iterator[Part]:
    """Yield a swing: a bar, two ropes and a seat."""
    yield cylinder("bar", p.metal, (p.h - 0.03, 0.0), 0.03, p.y, axis="y", sides=10)
    for y in (-0.36 * p.w, 0.36 * p.w):
        yield cylinder("rope", LINEN, (0.0, y), 0.01, (0.24 * p.h, p.h - 0.05), sides=6)
    yield soft(
        "seat",
        p.wood,
        (0.5 * p.x[0], 0.5 * p.x[1]),
        (0.84 * p.y[0], 0.84 * p.y[1]),
        (0.22 * p.h, 0.22 * p.h + 0.04),
        bevel=0.01,
    )
    for x in (p.x[0], p.x[1] - 0.04):
        for y in (p.y[0] + 0.001, p.y[1] - 0.041):
            lean = (-0.8 * x - (0.0 if x > 0 else 0.04 * 0.8), 0.0)
            yield sheared("leg", p.metal, (x, x + 0.04), (y, y + 0.04), (0.0, p.h - 0.03), lean=lean)


BUILDERS: dict[str, Builder] = {
    "toy": toy,
    "teddy bear": teddy_bear,
    "rocking horse": rocking_horse,
    "doll house": doll_house,
    "play kitchen": play_kitchen,
    "play tent": play_tent,
    "play gym": play_gym,
    "changing table": changing_table,
    "playpen": playpen,
    "slide": slide,
    "trampoline": trampoline,
    "easel": easel,
    "stroller": stroller,
    "scooter": scooter,
    "swing": swing,
}
