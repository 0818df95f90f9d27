"""Coats, shoes and umbrellas."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder
from robolayout.assets.furniture.storage import levels
from robolayout.assets.palette import SPINES, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, slab, soft


def shoe_rack(p: Piece) -> Iterator[Part]:
    """Yield slatted shelves with pairs of shoes."""
    rows = levels(p, 0.24, foot=0.08)
    for y0 in (p.y[0], p.y[1] - 0.025):
        yield box("side", p.wood, p.x, (y0, y0 + 0.025), p.z)
    inner = (p.y[0] + 0.025, p.y[1] - 0.025)
    rng = p.rng()
    for low in rows:
        for i in range(4):
            x = p.x[0] + 0.01 + i * (p.d - 0.02) / 4
            yield box("slat", p.wood, (x, x + 0.18 * p.d), inner, (low - 0.016, low - 0.002))
        if low > 0.95 * p.h:
            continue
        for j in range(max(1, round(p.w / 0.26))):
            y = inner[0] + (j + 0.5) * (inner[1] - inner[0]) / max(1, round(p.w / 0.26))
            shoe = rng.choice(SPINES)
            for side in (-0.055, 0.055):
                yield slab(
                    "shoe",
                    shoe,
                    (p.x[0] + 0.02, p.x[1] - 0.02),
                    (y + side - 0.04, y + side + 0.04),
                    (low, low + 0.09),
                    top=(0.6, 0.8),
                )


def coat_rack(p: Piece) -> Iterator[Part]:
    """Yield a stand with hooks, a coat and a hat."""
    r = 0.45 * min(p.d, p.w)
    yield cylinder("foot", p.dark, (0.0, 0.0), (r, 0.9 * r), (0.0, 0.03), sides=20)
    yield cylinder("pole", p.dark, (0.0, 0.0), 0.022, (0.03, 0.97 * p.h), sides=10)
    yield ball("knob", p.dark, (-0.035, 0.035), (-0.035, 0.035), (0.95 * p.h, p.h), rings=3, sides=8)
    for x, y in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        base = box(
            "hook",
            p.dark,
            (-0.012, 0.012),
            (-0.012, 0.012),
            (0.8 * p.h + 0.002 * (x + 2 * y), 0.82 * p.h + 0.002 * (x + 2 * y)),
        )
        lift = (p.d / 2 - 0.012 if x else 0.0, p.w / 2 - 0.012 if y else 0.0)
        upper = base.vertices[:, 2] > 0.81 * p.h + 0.002 * (x + 2 * y)
        base.vertices[upper, 0] += x * lift[0]
        base.vertices[upper, 1] += y * lift[1]
        base.vertices[upper, 2] += 0.07 * p.h
        yield base
    yield slab("coat", p.fabric, (0.06, 0.2), (-0.17, 0.17), (0.36 * p.h, 0.84 * p.h), top=(0.5, 0.35))


def hall_tree(p: Piece) -> Iterator[Part]:
    """Yield a bench with a hook board above it."""
    seat = 0.25 * p.h
    yield box("bench", p.wood, p.x, p.y, (0.0, seat))
    yield soft(
        "cushion",
        p.fabric,
        (p.x[0] + 0.03, p.x[1] - 0.01),
        (p.y[0] + 0.01, p.y[1] - 0.01),
        (seat, seat + 0.05),
        bevel=0.02,
    )
    yield box("back", p.wood, (p.x[0], p.x[0] + 0.025), (p.y[0] + 0.001, p.y[1] - 0.001), (seat, p.h - 0.02))
    yield box("shelf", p.wood, (p.x[0], p.x[1] - 0.08), p.y, (p.h - 0.02, p.h))
    for i in range(n := max(3, round(p.w / 0.22))):
        y = p.y[0] + (i + 0.5) * p.w / n
        yield box("hook", p.metal, (p.x[0] + 0.025, p.x[0] + 0.08), (y - 0.01, y + 0.01), (0.78 * p.h, 0.8 * p.h))
    yield slab(
        "coat",
        p.accent,
        (p.x[0] + 0.09, p.x[0] + 0.2),
        (p.y[0] + 0.08, p.y[0] + 0.38),
        (0.4 * p.h, 0.8 * p.h),
        top=(0.5, 0.4),
    )


def clothes_rack(p: Piece) -> Iterator[Part]:
    """Yield a rail with hanging clothes."""
    rail = p.h - 0.03
    for y0 in (p.y[0] + 0.02, p.y[1] - 0.045):
        yield box("post", p.metal, (-0.0125, 0.0125), (y0, y0 + 0.025), (0.03, rail))
        yield box("foot", p.metal, p.x, (y0 - 0.008, y0 + 0.033), (0.0, 0.03))
    yield cylinder("rail", p.metal, (rail + 0.015, 0.0), 0.015, p.y, axis="y", sides=8)
    rng = p.rng()
    count = max(4, round((p.w - 0.16) / 0.085))
    colors = (p.fabric, p.accent, p.bedding, *p.palette.fabrics, *p.palette.accents)
    for i in range(count):
        y = p.y[0] + 0.08 + (i + 0.5) * (p.w - 0.16) / count
        low = rail - min(0.9, 0.62 * p.h) * rng.uniform(0.7, 1.0)
        yield box("hanger", p.metal, (-0.006, 0.006), (y - 0.004, y + 0.004), (rail - 0.07, rail))
        yield slab(
            "garment",
            rng.choice(colors),
            (-0.36 * p.d, 0.36 * p.d),
            (y - 0.03, y + 0.03),
            (low, rail - 0.07),
            top=(0.4, 0.9),
        )


def wall_hooks(p: Piece) -> Iterator[Part]:
    """Yield a board with hooks."""
    yield box("board", p.wood, (p.x[0], p.x[0] + 0.25 * p.d), p.y, (0.3 * p.h, p.h))
    for i in range(n := max(2, round(p.w / 0.14))):
        y = p.y[0] + (i + 0.5) * p.w / n
        yield box("peg", p.metal, (p.x[0] + 0.25 * p.d, p.x[1]), (y - 0.008, y + 0.008), (0.5 * p.h, 0.6 * p.h))
        yield box("tip", p.metal, (p.x[1] - 0.012, p.x[1] - 0.001), (y - 0.007, y + 0.007), (0.6 * p.h, 0.72 * p.h))
        yield box("lower", p.metal, (p.x[0] + 0.25 * p.d, p.x[0] + 0.5 * p.d), (y - 0.007, y + 0.007), (0.0, 0.3 * p.h))


def umbrella_stand(p: Piece) -> Iterator[Part]:
    """Yield a pot with two umbrellas."""
    yield cylinder("pot", p.metal, (0.0, 0.0), (0.8 * p.d / 2, p.d / 2), (0.0, 0.62 * p.h), sides=18)
    for i, (x, y) in enumerate(((0.12, 0.14), (-0.12, -0.1))):
        at = (x * p.d, y * p.w)
        yield cylinder(
            "umbrella", (p.accent, p.fabric)[i], at, (0.05, 0.02), (0.58 * p.h - 0.002 * i, 0.9 * p.h), sides=8
        )
        yield cylinder("handle", p.dark, at, 0.012, (0.9 * p.h, p.h - 0.02 * i), sides=6)


BUILDERS: dict[str, Builder] = {
    "shoe rack": shoe_rack,
    "coat rack": coat_rack,
    "hall tree": hall_tree,
    "clothes rack": clothes_rack,
    "clothing stand": clothes_rack,
    "wall hooks": wall_hooks,
    "umbrella stand": umbrella_stand,
}
