"""Leaves and piles: what grows or lies around a middle."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from itertools import product

from robolayout.assets.palette import PLAIN, SPINES, Piece
from robolayout.assets.part import Material, Part
from robolayout.assets.shapes import ball, box, cylinder, moved, prism

Span = tuple[float, float]
GREENS = (PLAIN["leaf"], PLAIN["leaf-light"], PLAIN["leaf-dark"])  # what leaves look like, in turn


def _book(p: Piece) -> Iterator[Part]:
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
        size = 0.95 * (rng.uniform(0.8, 0.96) if i else 1.0)
        one = replace(p, d=size * p.d, w=size * p.w, h=p.h / count, variant=i, key=f"{p.key}/{i}")
        turn = rng.uniform(-0.12, 0.12) if i else 0.0
        yield from (moved(part, turn=turn, offset=(0.0, 0.0, i * p.h / count)) for part in _book(one))


def vase(p: Piece) -> Iterator[Part]:
    """Yield the flowers in a vase."""
    yield from _bunch(p, 0.5 * p.h, (PLAIN["pink"], PLAIN["yellow"], p.bedding, PLAIN["white"]))


def _bunch(p: Piece, low: float, tones: tuple[Material, ...]) -> Iterator[Part]:
    """Yield stems and blossoms from height `low` up to the top."""
    rng, size = p.rng(), 0.17 * min(p.d, p.w)
    for i, (x, y, out) in enumerate(_around(p, 9, size)):
        top = p.h - (p.h - low) * 0.45 * out * rng.uniform(0.6, 1.0)
        yield _stem(PLAIN["leaf"], 0.003, (low - 0.02 - 0.001 * i, top - size), low, (x, y))
        reach = ((x - size, x + size), (y - size, y + size), (top - 1.5 * size, top))
        yield ball("blossom", tones[i % len(tones)], *reach, rings=3, sides=8)
    reach = ((-0.3 * p.d, 0.3 * p.d), (-0.3 * p.w, 0.3 * p.w), (low - 0.01, low + 0.4 * (p.h - low)))
    yield ball("leaves", PLAIN["leaf"], *reach, rings=3, sides=8)


def _around(p: Piece, count: int, size: float) -> Iterator[tuple[float, float, float]]:
    """Yield places spread over a box like seeds over a sunflower, `size` from its sides, and how far out each is."""
    for i in range(count):
        turn, out = 2.4 * i, math.sqrt((i + 0.5) / count)
        yield (0.5 * p.d - size) * out * math.cos(turn), (0.5 * p.w - size) * out * math.sin(turn), out


def _stem(tone: Material, half: float, z: Span, above: float, lean: Span) -> Part:
    """Return a thin bar whose end above a height is moved."""
    part = box("stem", tone, (-half, half), (-half, half), z)
    part.vertices[part.vertices[:, 2] > above, :2] += lean
    return part


def plant(p: Piece) -> Iterator[Part]:
    """Yield the leaves of a plant: big ones on stems, or blades."""
    pot, rng, least = 0.26 * p.h, p.rng(), min(p.d, p.w)
    if p.variant % 4 == 1:
        yield from _blades(p, pot, 0.26 * least)
        return
    for i in range(15):
        turn, rise = 2.4 * i, (i + 1) / 15
        out, size = math.sin(math.pi * (0.25 + 0.6 * rise)), 0.17 * least * rng.uniform(0.9, 1.2)
        x, y = (0.5 * p.d - size) * out * math.cos(turn), (0.5 * p.w - size) * out * math.sin(turn)
        z = pot + (p.h - pot) * (0.16 + 0.78 * rise)
        span, lean = (pot - 0.001 * (i + 1), z - 0.01), (0.8 * x, 0.8 * y)
        yield _stem(PLAIN["leaf-dark"], 0.006, span, pot + 1e-6, lean)
        yield _leaf(GREENS[i % 3], (x, y, z), turn, size, droop=0.5)


def _leaf(tone: Material, at: tuple[float, float, float], turn: float, size: float, *, droop: float) -> Part:
    """Return a pointed leaf of length 2 x `size` about `at`, pointing outwards, its tip lower by `droop` sizes."""
    outline = [(-1.0, 0.0), (-0.4, -0.55), (0.3, -0.5), (1.0, 0.0), (0.3, 0.5), (-0.4, 0.55)]
    part = prism("leaf", tone, [(size * x, size * y) for x, y in outline], (-0.02 * size, 0.06 * size))
    part.vertices[:, 2] -= droop * part.vertices[:, 0] * 0.6
    return moved(part, turn=turn, offset=at)


def _blades(p: Piece, low: float, r: float) -> Iterator[Part]:
    """Yield upright blades that fan out: a snake plant or a palm."""
    rng, wide = p.rng(), 0.08 * min(p.d, p.w)
    for i in range(13):
        turn, out = 2.4 * i, (i + 0.5) / 13
        x, y = 0.5 * r * math.cos(turn), 0.5 * r * math.sin(turn)
        top = p.h - (p.h - low) * 0.5 * out * rng.uniform(0.5, 1.0)
        outline = [(-0.01, -wide), (0.01, -wide), (0.01, wide), (-0.01, wide)]
        blade = prism("blade", GREENS[i % 3], outline, (low - 0.001 * (i + 1), top))
        upper = blade.vertices[:, 2] > low + 1e-6
        blade.vertices[upper, 1] *= 0.15
        blade = moved(blade, turn=turn, offset=(x, y, 0.0))
        blade.vertices[upper, 0] += (0.46 * p.d - abs(x)) * out * math.cos(turn)
        blade.vertices[upper, 1] += (0.46 * p.w - abs(y)) * out * math.sin(turn)
        yield blade


def potted_plant(p: Piece) -> Iterator[Part]:
    """Yield the rosette of a succulent."""
    pot, size = 0.42 * p.h, 0.2 * min(p.d, p.w)
    for i in range(12):
        turn, rise = 2.4 * i, (i + 1) / 12
        out, z = 1.0 - 0.85 * rise, pot + (p.h - pot) * (0.2 + 0.7 * rise)
        x, y = (0.5 * p.d - size) * out * math.cos(turn), (0.5 * p.w - size) * out * math.sin(turn)
        yield _leaf(GREENS[i % 3], (x, y, z), turn, size, droop=-0.7 * rise)


def hanging_plant(p: Piece) -> Iterator[Part]:
    """Yield the cords of a hanging pot, and trailing leaves."""
    high, r, size = 0.6 * p.h, 0.28 * min(p.d, p.w), 0.13 * min(p.d, p.w)
    for i in range(3):
        turn = 2 * math.pi * i / 3
        cord = box("cord", PLAIN["linen"], (-0.003, 0.003), (-0.003, 0.003), (high, p.h - 0.001 * i))
        cord.vertices[cord.vertices[:, 2] < high + 0.01, :2] += (0.95 * r * math.cos(turn), 0.95 * r * math.sin(turn))
        yield cord
    for i in range(14):
        turn, fall = 2.4 * i, (i % 5) / 4
        x, y = (0.5 * p.d - size) * math.cos(turn), (0.5 * p.w - size) * math.sin(turn)
        z = high + 0.02 - fall * (high - 0.06)
        yield _leaf(GREENS[i % 3], (0.9 * x, 0.9 * y, max(z, 0.05)), turn, size, droop=0.8)


def plant_stand(p: Piece) -> Iterator[Part]:
    """Yield pots on the steps of a rack."""
    rng, n = p.rng(), max(2, round(p.w / 0.24))
    tones = (*GREENS, PLAIN["pink"], PLAIN["yellow"])
    r = min(0.42 * p.d / 3, 0.3 * p.w / n)
    for i, j in product(range(3), range(n)):
        x, y, level = p.x[0] + (2.5 - i) * p.d / 3, p.y[0] + (j + 0.5) * p.w / n, (0.28 + 0.22 * i) * p.h
        pot = rng.choice((PLAIN["terracotta"], PLAIN["ceramic"], p.accent))
        yield cylinder("pot", pot, (x, y), (0.8 * r, r), (level, level + 0.13 * p.h), sides=10)
        tone, z = rng.choice(tones), (level + 0.11 * p.h, min(level + 0.28 * p.h, p.h))
        yield ball("bush", tone, (x - 1.3 * r, x + 1.3 * r), (y - 1.5 * r, y + 1.5 * r), z, rings=3, sides=8)


def flower_bucket(p: Piece) -> Iterator[Part]:
    """Yield a bucket's cut flowers."""
    tones = (PLAIN["pink"], PLAIN["yellow"], PLAIN["white"], PLAIN["orange"], p.accent)
    start = p.variant % len(tones)
    yield from _bunch(p, 0.5 * p.h, tones[start:] + tones[:start][:1])


def green_wall(p: Piece) -> Iterator[Part]:
    """Yield tufts of leaves."""
    columns, rows = max(2, min(8, round(p.w / 0.26))), max(2, min(8, round(p.h / 0.26)))
    a, b = 0.5 * p.w / columns, 0.5 * p.h / rows
    for i, j in product(range(columns), range(rows)):
        y, z = p.y[0] + (2 * i + 1) * a, (2 * j + 1) * b
        tone = (*GREENS, PLAIN["green"])[(3 * i + 5 * j + p.variant) % 4]
        x = (p.x[0] + 0.2 * p.d, p.x[1] - 0.1 * p.d * ((i + j) % 3))
        yield ball("tuft", tone, x, (y - a, y + a), (z - b, z + b), rings=3, sides=8)
