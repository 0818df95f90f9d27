"""Leaves and piles: what grows or lies around a middle."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder
from robolayout.assets.palette import PLAIN, SPINES, Piece
from robolayout.assets.part import Material, Part
from robolayout.assets.shapes import ball, box, cylinder, moved, oval, prism

Span = tuple[float, float]


def book(p: Piece) -> Iterator[Part]:
    """Yield a closed book; its spine is at the back."""
    cover = p.rng().choice(SPINES)
    t = 0.12 * p.h
    yield box("cover", cover, p.x, p.y, (0.0, t))
    yield box("pages", PLAIN["paper"], (p.x[0] + 0.004, p.x[1] - 0.004), (p.y[0] + 0.004, p.y[1] - 0.004), (t, p.h - t))
    yield box("cover", cover, p.x, p.y, (p.h - t, p.h))


def book_stack(p: Piece) -> Iterator[Part]:
    """Yield a pile of books, each turned a little."""
    rng = p.rng()
    count = max(2, round(p.h / 0.032))
    for i in range(count):
        shrink = rng.uniform(0.8, 0.96) if i else 1.0
        z = i * p.h / count
        one = Piece(
            shrink * p.d * 0.95,
            shrink * p.w * 0.95,
            p.h / count,
            p.palette,
            p.fabric,
            p.accent,
            p.bedding,
            p.kind,
            i,
            f"{p.key}/{i}",
        )
        turn = rng.uniform(-0.12, 0.12) if i else 0.0
        yield from (moved(part, turn=turn, offset=(0.0, 0.0, z)) for part in book(one))


def vase(p: Piece) -> Iterator[Part]:
    """Yield a vase with flowers."""
    belly = 0.5 * p.h
    yield disc(p, "foot", p.accent, (0.42, 0.6), (0.0, 0.25))
    yield disc(p, "belly", p.accent, (0.6, 0.3), (0.25, 0.44))
    yield disc(p, "neck", p.accent, (0.3, 0.42), (0.44, 0.5))
    yield from bunch(p, belly, (PLAIN["pink"], PLAIN["yellow"], p.bedding, PLAIN["white"]))


def disc(p: Piece, name: str, tone: Material, radii: Span, z: Span, *, sides: int = 16) -> Part:
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
        stem = box("stem", PLAIN["leaf"], (-0.003, 0.003), (-0.003, 0.003), (low - 0.02 - 0.001 * i, top - size))
        upper = stem.vertices[:, 2] > low
        stem.vertices[upper, 0] += x
        stem.vertices[upper, 1] += y
        yield stem
        yield ball(
            "blossom",
            tones[i % len(tones)],
            (x - size, x + size),
            (y - size, y + size),
            (top - 1.5 * size, top),
            rings=3,
            sides=8,
        )
    yield ball(
        "leaves",
        PLAIN["leaf"],
        (-0.3 * p.d, 0.3 * p.d),
        (-0.3 * p.w, 0.3 * p.w),
        (low - 0.01, low + 0.4 * (p.h - low)),
        rings=3,
        sides=8,
    )


def plant(p: Piece) -> Iterator[Part]:
    """Yield a leafy plant in a pot: big leaves on stems, or blades."""
    pot, r = 0.26 * p.h, 0.26 * min(p.d, p.w)
    yield cylinder(
        "pot",
        (PLAIN["terracotta"], p.accent, PLAIN["ceramic"])[p.variant % 3],
        (0.0, 0.0),
        (0.75 * r, r),
        (0.0, pot),
        sides=18,
    )
    yield cylinder("soil", PLAIN["soil"], (0.0, 0.0), 0.9 * r, (pot, pot + 0.006), sides=18)
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
        stem = box("stem", PLAIN["leaf-dark"], (-0.006, 0.006), (-0.006, 0.006), (pot - 0.001 * (i + 1), z - 0.01))
        upper = stem.vertices[:, 2] > pot + 1e-6
        stem.vertices[upper, 0] += 0.8 * x
        stem.vertices[upper, 1] += 0.8 * y
        yield stem
        tone = (PLAIN["leaf"], PLAIN["leaf-light"], PLAIN["leaf-dark"])[i % 3]
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
        blade = prism(
            "blade",
            (PLAIN["leaf"], PLAIN["leaf-light"], PLAIN["leaf-dark"])[i % 3],
            [(-0.01, -wide), (0.01, -wide), (0.01, wide), (-0.01, wide)],
            (low - 0.001 * (i + 1), top),
        )
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
    yield cylinder(
        "pot",
        (PLAIN["ceramic"], PLAIN["terracotta"], p.accent)[p.variant % 3],
        (0.0, 0.0),
        (0.75 * r, r),
        (0.0, pot),
        sides=16,
    )
    yield cylinder("soil", PLAIN["soil"], (0.0, 0.0), 0.88 * r, (pot, pot + 0.003), sides=16)
    for i in range(12):
        turn, rise = 2.4 * i, (i + 1) / 12
        size = 0.2 * min(p.d, p.w)
        out = 1.0 - 0.85 * rise
        x, y = (0.5 * p.d - size) * out * math.cos(turn), (0.5 * p.w - size) * out * math.sin(turn)
        z = pot + (p.h - pot) * (0.2 + 0.7 * rise)
        yield leaf(
            (PLAIN["leaf"], PLAIN["leaf-light"], PLAIN["leaf-dark"])[i % 3], (x, y, z), turn, size, droop=-0.7 * rise
        )
    yield cylinder("stem", PLAIN["leaf-dark"], (0.0, 0.0), 0.06 * p.d, (pot + 0.001, p.h - 0.1 * p.h), sides=7)


def hanging_plant(p: Piece) -> Iterator[Part]:
    """Yield a pot on cords with trailing leaves."""
    low, high = 0.38 * p.h, 0.6 * p.h
    r = 0.28 * min(p.d, p.w)
    yield cylinder("pot", p.accent, (0.0, 0.0), (0.7 * r, r), (low, high), sides=16)
    for i in range(3):
        turn = 2 * math.pi * i / 3
        cord = box("cord", PLAIN["linen"], (-0.003, 0.003), (-0.003, 0.003), (high, p.h - 0.001 * i))
        below = cord.vertices[:, 2] < high + 0.01
        cord.vertices[below, 0] += 0.95 * r * math.cos(turn)
        cord.vertices[below, 1] += 0.95 * r * math.sin(turn)
        yield cord
    yield ball(
        "leaves",
        PLAIN["leaf"],
        (-1.1 * r, 1.1 * r),
        (-1.1 * r, 1.1 * r),
        (high - 0.04, high + 0.16 * p.h),
        rings=3,
        sides=9,
    )
    for i in range(14):
        turn, fall = 2.4 * i, (i % 5) / 4
        size = 0.13 * min(p.d, p.w)
        x, y = (0.5 * p.d - size) * math.cos(turn), (0.5 * p.w - size) * math.sin(turn)
        z = high + 0.02 - fall * (high - 0.06)
        yield leaf(
            (PLAIN["leaf"], PLAIN["leaf-light"], PLAIN["leaf-dark"])[i % 3],
            (0.9 * x, 0.9 * y, max(z, 0.05)),
            turn,
            size,
            droop=0.8,
        )


def plant_stand(p: Piece) -> Iterator[Part]:
    """Yield a stepped rack with pots on it."""
    steps = 3
    rng = p.rng()
    for i in range(steps):
        x = (p.x[0] + (steps - 1 - i) * p.d / steps, p.x[0] + (steps - i) * p.d / steps)
        level = (0.28 + 0.22 * i) * p.h
        yield box("step", p.wood, x, (p.y[0], p.y[1]), (level - 0.02, level))
        for y0 in (p.y[0] + 0.02, p.y[1] - 0.05):
            yield box("leg", p.dark, (x[0] + 0.01, x[0] + 0.04), (y0, y0 + 0.03), (0.0, level - 0.02))
        for j in range(n := max(2, round(p.w / 0.24))):
            y = p.y[0] + (j + 0.5) * p.w / n
            r = min(0.42 * p.d / steps, 0.3 * p.w / n)
            middle = (x[0] + x[1]) / 2
            yield cylinder(
                "pot",
                rng.choice((PLAIN["terracotta"], PLAIN["ceramic"], p.accent)),
                (middle, y),
                (0.8 * r, r),
                (level, level + 0.13 * p.h),
                sides=10,
            )
            tone = rng.choice((PLAIN["leaf"], PLAIN["leaf-light"], PLAIN["leaf-dark"], PLAIN["pink"], PLAIN["yellow"]))
            yield ball(
                "bush",
                tone,
                (middle - 1.3 * r, middle + 1.3 * r),
                (y - 1.5 * r, y + 1.5 * r),
                (level + 0.11 * p.h, min(level + 0.28 * p.h, p.h)),
                rings=3,
                sides=8,
            )


def flower_bucket(p: Piece) -> Iterator[Part]:
    """Yield a zinc bucket full of cut flowers."""
    top = 0.5 * p.h
    yield disc(p, "bucket", PLAIN["steel"], (0.64, 0.82), (0.0, 0.5), sides=18)
    tones = (PLAIN["pink"], PLAIN["yellow"], PLAIN["white"], PLAIN["orange"], p.accent)
    start = p.variant % len(tones)
    yield from bunch(p, top, tones[start:] + tones[:start][:1])


def green_wall(p: Piece) -> Iterator[Part]:
    """Yield a panel covered with tufts of leaves."""
    yield box("panel", p.dark, (p.x[0], p.x[0] + 0.3 * p.d), p.y, p.z)
    columns, rows = max(2, min(8, round(p.w / 0.26))), max(2, min(8, round(p.h / 0.26)))
    for i in range(columns):
        for j in range(rows):
            y, z = p.y[0] + (i + 0.5) * p.w / columns, (j + 0.5) * p.h / rows
            a, b = 0.5 * p.w / columns, 0.5 * p.h / rows
            tone = (PLAIN["leaf"], PLAIN["leaf-light"], PLAIN["leaf-dark"], PLAIN["green"])[
                (3 * i + 5 * j + p.variant) % 4
            ]
            yield ball(
                "tuft",
                tone,
                (p.x[0] + 0.2 * p.d, p.x[1] - 0.1 * p.d * ((i + j) % 3)),
                (y - a, y + a),
                (z - b, z + b),
                rings=3,
                sides=8,
            )


BUILDERS: dict[str, Builder] = {
    "book stack": book_stack,
    "vase": vase,
    "unknown decor": vase,
    "plant": plant,
    "potted plant": potted_plant,
    "hanging plant": hanging_plant,
    "plant stand": plant_stand,
    "flower bucket": flower_bucket,
    "green wall": green_wall,
}
