"""Pictures, mirrors and clocks."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder
from robolayout.assets.palette import (
    BLACK,
    BRASS,
    DARK,
    MIRROR,
    PAPER,
    WHITE,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, oval, prism, slab

Span = tuple[float, float]


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
    near = [
        (y[0], z[0]),
        (y[1], z[0]),
        (y[1], z[0] + 0.12 * h),
        (y[0] + 0.3 * w, z[0] + 0.3 * h),
        (y[0], z[0] + 0.28 * h),
    ]
    yield prism("field", tones[2], near, (x + 2 * step, x + 3 * step), axis="x")
    r = 0.12 * min(w, h)
    at = (y[0] + w * rng.uniform(0.2, 0.75), z[1] - 1.9 * r)
    yield cylinder("sun", tones[3], at, r, (x + step, x + 1.5 * step), axis="x", sides=18)


def mirror(p: Piece) -> Iterator[Part]:
    """Yield a wall mirror: round where it is square, else with a frame."""
    if abs(p.w - p.h) < 0.1 * p.w:
        yield cylinder("frame", p.metal, (0.0, p.h / 2), p.w / 2, (p.x[0], p.x[1] - 0.2 * p.d), axis="x", sides=32)
        yield cylinder(
            "mirror", MIRROR, (0.0, p.h / 2), 0.94 * p.w / 2, (p.x[1] - 0.2 * p.d, p.x[1]), axis="x", sides=32
        )
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
    yield oval(
        "case", p.dark, (0.0, p.h / 2), ((p.w / 2, p.h / 2), (p.w / 2, p.h / 2)), (p.x[0], face), axis="x", sides=28
    )
    yield cylinder("dial", PAPER, (0.0, p.h / 2), 0.9 * r, (face, face + 0.1 * p.d), axis="x", sides=28)
    for i in range(12):
        turn = math.pi * i / 6
        y, z = 0.78 * r * math.sin(turn), p.h / 2 + 0.78 * r * math.cos(turn)
        t = (0.05 if i % 3 == 0 else 0.03) * r
        yield box("mark", BLACK, (face + 0.1 * p.d, face + 0.15 * p.d), (y - t, y + t), (z - t, z + t))
    yield box(
        "hour hand", BLACK, (face + 0.1 * p.d, face + 0.2 * p.d), (-0.04 * r, 0.04 * r), (p.h / 2, p.h / 2 + 0.45 * r)
    )
    yield box(
        "minute hand",
        BLACK,
        (face + 0.2 * p.d, p.x[1]),
        (-0.025 * r, 0.62 * r),
        (p.h / 2 - 0.025 * r, p.h / 2 + 0.025 * r),
    )


def alarm_clock(p: Piece) -> Iterator[Part]:
    """Yield a small round clock on feet."""
    r = 0.44 * min(p.w, p.h)
    yield cylinder("case", p.accent, (0.0, 0.52 * p.h), (r, r), (p.x[0], p.x[1] - 0.1 * p.d), axis="x", sides=20)
    yield cylinder(
        "dial", PAPER, (0.0, 0.52 * p.h), 0.86 * r, (p.x[1] - 0.1 * p.d, p.x[1] - 0.04 * p.d), axis="x", sides=20
    )
    yield box("hand", BLACK, (p.x[1] - 0.04 * p.d, p.x[1]), (-0.05 * r, 0.05 * r), (0.5 * p.h, 0.52 * p.h + 0.66 * r))
    yield box("hand", BLACK, (p.x[1] - 0.04 * p.d, p.x[1] - 0.01 * p.d), (0.05 * r, 0.5 * r), (0.5 * p.h, 0.54 * p.h))
    for y in (-0.5, 0.5):
        yield box(
            "foot", BRASS, (-0.2 * p.d, 0.2 * p.d), ((y - 0.1) * p.w * 0.8, (y + 0.1) * p.w * 0.8), (0.0, 0.16 * p.h)
        )
        yield ball(
            "bell",
            BRASS,
            (-0.2 * p.d, 0.2 * p.d),
            (0.6 * y * p.w - 0.14 * p.w, 0.6 * y * p.w + 0.14 * p.w),
            (0.84 * p.h, p.h),
            rings=3,
            sides=8,
        )


def grandfather_clock(p: Piece) -> Iterator[Part]:
    """Yield a tall clock with dial, glass and pendulum."""
    face = p.x[1] - 0.02
    yield box("base", p.dark, (p.x[0], face), p.y, (0.0, 0.2 * p.h))
    yield box("trunk", p.dark, (p.x[0] + 0.02, face - 0.02), (0.8 * p.y[0], 0.8 * p.y[1]), (0.2 * p.h, 0.72 * p.h))
    yield box("hood", p.dark, (p.x[0], face), p.y, (0.72 * p.h, 0.96 * p.h))
    yield slab("cornice", p.dark, (p.x[0], p.x[1]), p.y, (0.961 * p.h, p.h), top=(0.8, 0.8))
    yield cylinder("dial", PAPER, (0.0, 0.84 * p.h), 0.4 * p.w, (face, face + 0.008), axis="x", sides=24)
    yield box("hand", BLACK, (face + 0.008, p.x[1]), (-0.008, 0.008), (0.84 * p.h, 0.84 * p.h + 0.3 * p.w))
    yield box(
        "hand", BLACK, (face + 0.008, p.x[1] - 0.002), (0.008, 0.2 * p.w), (0.84 * p.h - 0.008, 0.84 * p.h + 0.008)
    )
    yield box("window", BLACK, (face - 0.02, face - 0.016), (-0.26 * p.w, 0.26 * p.w), (0.26 * p.h, 0.68 * p.h))
    yield box("rod", BRASS, (face - 0.015, face - 0.01), (-0.006, 0.006), (0.34 * p.h, 0.68 * p.h))
    yield cylinder("pendulum", BRASS, (0.0, 0.34 * p.h), 0.15 * p.w, (face - 0.016, face - 0.004), axis="x", sides=16)


def photo_frame(p: Piece) -> Iterator[Part]:
    """Yield a small standing picture."""
    small = Piece(0.02, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    for part in picture(small):
        part.vertices[:, 0] += p.x[1] - 0.02 - (p.d - 0.03) * part.vertices[:, 2] / p.h * 0.5
        yield part
    yield box("stay", DARK, (p.x[0], p.x[1] - 0.04), (-0.01, 0.01), (0.0, 0.3 * p.h))


BUILDERS: dict[str, Builder] = {
    "picture": picture,
    "unknown wall decor": picture,
    "mirror": mirror,
    "floor mirror": floor_mirror,
    "wall clock": wall_clock,
    "alarm clock": alarm_clock,
    "grandfather clock": grandfather_clock,
    "photo frame": photo_frame,
}
