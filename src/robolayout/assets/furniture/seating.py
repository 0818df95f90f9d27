"""Things to sit on; all face +x, with their backs at -x."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from robolayout.assets.furniture._common import Builder, four
from robolayout.assets.palette import DARK, STEEL, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, moved, oval, sheared, soft


def sofa(p: Piece) -> Iterator[Part]:
    """Yield a sofa or armchair: base, arms, seat and back cushions on short feet."""
    arm = min(0.22, 0.14 * p.w + 0.04)
    foot, seat = 0.12 * p.h, 0.5 * p.h
    back = p.x[0] + 0.24 * p.d
    inner = (p.y[0] + arm, p.y[1] - arm)
    yield from four(p, p.dark, foot, thick=0.05, inset=0.05, round_=True)
    yield box("base", p.fabric, (p.x[0] + 0.01, p.x[1] - 0.015), (p.y[0] + 0.01, p.y[1] - 0.01), (foot, 0.34 * p.h))
    for y0, y1 in ((p.y[0], p.y[0] + arm - 0.003), (p.y[1] - arm + 0.003, p.y[1])):
        yield soft("arm", p.fabric, (p.x[0] + 0.02, p.x[1]), (y0, y1), (foot + 0.005, 0.7 * p.h), bevel=0.04)
    yield soft(
        "backrest",
        p.fabric,
        (p.x[0], back - 0.02),
        (p.y[0] + 0.02, p.y[1] - 0.02),
        (foot + 0.012, p.h - 0.02),
        bevel=0.045,
    )
    count = max(1, round((inner[1] - inner[0]) / 0.72))
    step = (inner[1] - inner[0]) / count
    for i in range(count):
        y = (inner[0] + i * step + 0.003, inner[0] + (i + 1) * step - 0.003)
        yield soft("seat cushion", p.fabric, (back - 0.02, p.x[1] - 0.004), y, (0.34 * p.h, seat), bevel=0.035)
        yield sheared_cushion(p, y, (back - 0.04, back + 0.13), (seat - 0.01, p.h))
    if p.w > 1.3:
        for side in (-1, 1):
            y = side * (inner[1] - 0.26)
            yield soft(
                "throw pillow",
                p.accent,
                (back + 0.12, back + 0.25),
                (y - 0.2, y + 0.2),
                (seat, seat + 0.36),
                bevel=0.06,
            )


def sheared_cushion(p: Piece, y: tuple[float, float], x: tuple[float, float], z: tuple[float, float]) -> Part:
    """Return a back cushion that leans on the backrest."""
    part = soft("back cushion", p.fabric, x, y, z, bevel=0.05)
    lift = (part.vertices[:, 2] - z[0]) / (z[1] - z[0])
    part.vertices[:, 0] -= 0.04 * lift
    return part


def sectional(p: Piece) -> Iterator[Part]:
    """Yield an L-shaped sofa: a sofa along the back with a chaise on its left side."""
    deep = min(0.95, 0.56 * p.d)
    along = Piece(deep, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    for part in sofa(along):
        yield moved(part, offset=(p.x[0] + deep / 2, 0.0, 0.0))
    wide = min(0.95, 0.42 * p.w)
    y = (p.y[1] - wide, p.y[1] - 0.001)
    front = p.x[0] + deep + 0.004
    yield box("chaise base", p.fabric, (front, p.x[1]), y, (0.12 * p.h, 0.34 * p.h))
    yield soft(
        "chaise cushion",
        p.fabric,
        (front, p.x[1] - 0.01),
        (y[0] + 0.01, y[1] - 0.01),
        (0.34 * p.h, 0.5 * p.h),
        bevel=0.04,
    )
    for y0 in (y[0] + 0.04, y[1] - 0.09):
        yield box("foot", p.dark, (p.x[1] - 0.1, p.x[1] - 0.05), (y0, y0 + 0.05), (0.0, 0.12 * p.h))


def recliner(p: Piece) -> Iterator[Part]:
    """Yield a wide armchair with a raised footrest in front."""
    body = Piece(0.86 * p.d, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    for part in sofa(body):
        yield moved(part, offset=(-0.07 * p.d, 0.0, 0.0))
    yield soft(
        "footrest",
        p.fabric,
        (p.x[1] - 0.14 * p.d, p.x[1]),
        (-0.3 * p.w, 0.3 * p.w),
        (0.16 * p.h, 0.4 * p.h),
        bevel=0.03,
    )


def chaise_longue(p: Piece) -> Iterator[Part]:
    """Yield a long upholstered seat with a raised end at the back."""
    seat = 0.46 * p.h
    yield from four(p, p.dark, 0.16 * p.h, thick=0.05, inset=0.06, round_=True)
    yield box("base", p.fabric, (p.x[0] + 0.04, p.x[1] - 0.01), (p.y[0] + 0.01, p.y[1] - 0.01), (0.16 * p.h, 0.3 * p.h))
    yield soft("seat", p.fabric, (p.x[0] + 0.1, p.x[1]), p.y, (0.3 * p.h, seat), bevel=0.04)
    back = soft(
        "back", p.fabric, (p.x[0] + 0.1, p.x[0] + 0.24), (p.y[0] + 0.02, p.y[1] - 0.02), (0.25 * p.h, p.h), bevel=0.05
    )
    back.vertices[:, 0] -= 0.24 * (back.vertices[:, 2] / p.h - 0.25)
    yield back
    yield soft("cushion", p.accent, (p.x[0] + 0.2, p.x[0] + 0.36), (-0.22, 0.22), (seat, seat + 0.3), bevel=0.06)


def ottoman(p: Piece) -> Iterator[Part]:
    """Yield a padded block on short feet, or a round one where depth equals width."""
    foot = 0.14 * p.h
    if abs(p.d - p.w) < 0.03 and p.variant % 2:
        yield cylinder("body", p.fabric, (0.0, 0.0), p.d / 2, (0.0, 0.7 * p.h), sides=20)
        yield cylinder("cushion", p.fabric, (0.0, 0.0), (p.d / 2 - 0.005, p.d / 2 - 0.05), (0.7 * p.h, p.h), sides=20)
        return
    yield from four(p, p.dark, foot, thick=0.045, inset=0.04, round_=True)
    yield soft(
        "body",
        p.fabric,
        (p.x[0] + 0.01, p.x[1] - 0.01),
        (p.y[0] + 0.01, p.y[1] - 0.01),
        (foot, 0.68 * p.h),
        bevel=0.015,
    )
    yield soft("cushion", p.fabric, p.x, p.y, (0.68 * p.h, p.h), bevel=0.05)


def bean_bag(p: Piece) -> Iterator[Part]:
    """Yield a slumped sack whose top leans back."""
    rows = ((0.4, 0.5, 0.0, 0.3), (0.5, 0.42, 0.3, 0.56), (0.42, 0.26, 0.56, 0.82), (0.26, 0.06, 0.82, 1.0))
    for a, b, low, high in rows:
        part = oval(
            "sack", p.fabric, (0.0, 0.0), ((a * p.d, a * p.w), (b * p.d, b * p.w)), (low * p.h, high * p.h), sides=18
        )
        part.vertices[:, 0] -= 0.3 * p.d * np.maximum(part.vertices[:, 2] / p.h - 0.3, 0.0)
        yield part


def bench(p: Piece) -> Iterator[Part]:
    """Yield a bench: a plank with a cushion on four legs."""
    yield from four(p, p.dark, 0.8 * p.h, thick=0.05, inset=0.03)
    yield box("seat", p.wood, p.x, p.y, (0.8 * p.h, 0.88 * p.h))
    yield soft(
        "cushion",
        p.fabric,
        (p.x[0] + 0.012, p.x[1] - 0.012),
        (p.y[0] + 0.012, p.y[1] - 0.012),
        (0.88 * p.h, p.h),
        bevel=0.02,
    )


def pew(p: Piece) -> Iterator[Part]:
    """Yield a wooden bench with a straight back and end panels."""
    seat = 0.48 * p.h
    for y0 in (p.y[0], p.y[1] - 0.04):
        yield box("end", p.dark, (p.x[0] + 0.002, p.x[1]), (y0, y0 + 0.04), (0.0, 0.72 * p.h))
    inner = (p.y[0] + 0.04, p.y[1] - 0.04)
    yield box("seat", p.wood, (p.x[0] + 0.08, p.x[1] - 0.02), inner, (seat - 0.04, seat))
    yield sheared("back", p.wood, (p.x[0] + 0.06, p.x[0] + 0.09), inner, (0.2 * p.h, p.h), lean=(-0.06, 0.0))


def booth(p: Piece) -> Iterator[Part]:
    """Yield an upholstered diner bench with a high, channelled back."""
    seat = 0.42 * p.h
    yield box("plinth", DARK, (p.x[0] + 0.02, p.x[1] - 0.08), (p.y[0] + 0.01, p.y[1] - 0.01), (0.0, 0.12 * p.h))
    yield box(
        "base", p.wood, (p.x[0] + 0.01, p.x[1] - 0.02), (p.y[0] + 0.003, p.y[1] - 0.003), (0.12 * p.h, 0.28 * p.h)
    )
    yield soft("seat", p.fabric, (p.x[0] + 0.16, p.x[1]), p.y, (0.28 * p.h, seat), bevel=0.04)
    count = max(2, round(p.w / 0.26))
    for i in range(count):
        y0, y1 = p.y[0] + i * p.w / count, p.y[0] + (i + 1) * p.w / count
        yield soft(
            "back",
            p.fabric,
            (p.x[0] + 0.03, p.x[0] + 0.16),
            (y0 + 0.002, y1 - 0.002),
            (0.28 * p.h, p.h - 0.03),
            bevel=0.03,
        )
    yield box("back board", p.wood, (p.x[0], p.x[0] + 0.03), (p.y[0] + 0.001, p.y[1] - 0.001), (0.28 * p.h, p.h))


def waiting_bench(p: Piece) -> Iterator[Part]:
    """Yield several shell seats on one beam."""
    count, seat = max(2, round(p.w / 0.55)), 0.54 * p.h
    yield box("beam", STEEL, (-0.04, 0.02), p.y, (seat - 0.14, seat - 0.08))
    for y in (p.y[0] + 0.18 * p.w, p.y[1] - 0.18 * p.w):
        yield box("stand", STEEL, (-0.03, 0.01), (y - 0.03, y + 0.03), (0.03, seat - 0.14))
        yield box("foot", STEEL, (p.x[0] + 0.06, p.x[1] - 0.06), (y - 0.03, y + 0.03), (0.0, 0.03))
    for i in range(count):
        y = (p.y[0] + i * p.w / count + 0.02, p.y[0] + (i + 1) * p.w / count - 0.02)
        yield soft("seat", p.fabric, (p.x[0] + 0.12, p.x[1]), y, (seat - 0.06, seat), bevel=0.02)
        back = soft("back", p.fabric, (p.x[0] + 0.1, p.x[0] + 0.15), y, (seat + 0.02, p.h), bevel=0.02)
        back.vertices[:, 0] -= 0.1 * (back.vertices[:, 2] - seat) / (p.h - seat)
        yield back


def hanging_chair(p: Piece) -> Iterator[Part]:
    """Yield an egg-shaped basket, open at the front, that hangs from a stand."""
    yield cylinder("foot", p.metal, (0.0, 0.0), 0.45 * min(p.d, p.w), (0.0, 0.03), sides=20)
    yield box("mast", p.metal, (p.x[0], p.x[0] + 0.05), (-0.025, 0.025), (0.03, p.h))
    yield box("foot bar", p.metal, (p.x[0] + 0.05, 0.0), (-0.024, 0.024), (0.031, 0.06))
    yield box("jib", p.metal, (p.x[0] + 0.05, 0.0), (-0.02, 0.02), (p.h - 0.04, p.h - 0.002))
    yield cylinder("chain", p.metal, (-0.04, 0.0), 0.008, (0.88 * p.h, p.h - 0.04), sides=6)
    yield ball("back shell", p.wood, (p.x[0] + 0.1, 0.02 * p.d), p.y, (0.24 * p.h, 0.9 * p.h), rings=6)
    yield ball(
        "seat shell", p.wood, (p.x[0] + 0.14, p.x[1]), (0.96 * p.y[0], 0.96 * p.y[1]), (0.2 * p.h, 0.46 * p.h), rings=5
    )
    yield ball(
        "seat cushion", p.fabric, (-0.3 * p.d, 0.46 * p.d), (-0.4 * p.w, 0.4 * p.w), (0.3 * p.h, 0.49 * p.h), rings=4
    )
    yield ball(
        "back cushion", p.fabric, (-0.2 * p.d, 0.1 * p.d), (-0.36 * p.w, 0.36 * p.w), (0.42 * p.h, 0.78 * p.h), rings=4
    )


BUILDERS: dict[str, Builder] = {
    "sofa": sofa,
    "loveseat": sofa,
    "sofa bed": sofa,
    "armchair": sofa,
    "sectional sofa": sectional,
    "recliner": recliner,
    "chaise longue": chaise_longue,
    "ottoman": ottoman,
    "footstool": ottoman,
    "bean bag": bean_bag,
    "bench": bench,
    "window seat": bench,
    "pew": pew,
    "booth": booth,
    "waiting bench": waiting_bench,
    "hanging chair": hanging_chair,
}
