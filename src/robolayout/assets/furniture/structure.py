"""Fixed parts of a building that stand in a room."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder
from robolayout.assets.palette import (
    BLACK,
    CONCRETE,
    DARK,
    GLASS,
    GLOW,
    LIGHT_GREY,
    MIRROR,
    PINE,
    STEEL,
    WHITE,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, slab

Span = tuple[float, float]


def stairs(p: Piece) -> Iterator[Part]:
    """Yield a flight of stairs that rises towards the back, with a handrail."""
    climb = p.h - 0.9 if p.h > 1.6 else p.h
    count = max(3, round(climb / 0.19))
    rise = climb / count
    for i in range(count):
        x = (p.x[1] - (i + 1) * p.d / count, p.x[1] - i * p.d / count)
        yield box("step", p.wood, x, p.y, (max(0.0, i * rise - 0.12), (i + 1) * rise))
    post = min(0.1, p.d / count, 0.2 * p.w)
    for side in (p.y[0], p.y[1] - post):
        top = (count - 1) * rise - 0.12
        yield box("post", p.wood, (p.x[0], p.x[0] + post), (side, side + post), (0.0, max(top, 0.01)))
    if p.h > 1.6:
        rail = box("hand rail", p.dark, p.x, (p.y[1] - 0.05, p.y[1] - 0.005), (0.0, 0.05))
        rail.vertices[:, 2] += 0.85 + (p.x[1] - rail.vertices[:, 0]) / p.d * (p.h - 0.9)
        yield rail
        for i in range(0, count, 2):
            x = p.x[1] - (i + 0.5) * p.d / count
            low = (i + 1) * rise
            yield box(
                "baluster",
                p.metal,
                (x - 0.012, x + 0.012),
                (p.y[1] - 0.04, p.y[1] - 0.016),
                (low, 0.86 + (p.x[1] - x) / p.d * (p.h - 0.9)),
            )


def column(p: Piece) -> Iterator[Part]:
    """Yield a concrete column."""
    yield box("shaft", CONCRETE, (0.92 * p.x[0], 0.92 * p.x[1]), (0.92 * p.y[0], 0.92 * p.y[1]), (0.1, p.h - 0.1))
    for z in ((0.0, 0.1), (p.h - 0.1, p.h)):
        yield box("base", CONCRETE, p.x, p.y, z)


def elevator(p: Piece) -> Iterator[Part]:
    """Yield a lift with sliding doors, a display and a button."""
    yield box("shaft", LIGHT_GREY, (p.x[0], p.x[1] - 0.06), p.y, p.z)
    for y in ((-0.34 * p.w, -0.003), (0.003, 0.34 * p.w)):
        yield box("door", STEEL, (p.x[1] - 0.06, p.x[1] - 0.03), y, (0.0, 0.9 * p.h))
    for y in ((-0.4 * p.w, -0.34 * p.w), (0.34 * p.w, 0.4 * p.w)):
        yield box("frame", DARK, (p.x[1] - 0.06, p.x[1]), y, (0.0, 0.94 * p.h))
    yield box("head", DARK, (p.x[1] - 0.06, p.x[1]), (-0.34 * p.w, 0.34 * p.w), (0.9 * p.h, 0.94 * p.h))
    yield box("display", GLOW, (p.x[1], p.x[1] + 0.004), (-0.1, 0.1), (0.905 * p.h, 0.935 * p.h))
    yield cylinder("button", MIRROR, (0.45 * p.w, 0.5 * p.h), 0.03, (p.x[1] - 0.06, p.x[1] - 0.04), axis="x", sides=12)


def radiator_cover(p: Piece) -> Iterator[Part]:
    """Yield a shelf over a slatted front."""
    yield box("top", WHITE, p.x, p.y, (p.h - 0.025, p.h))
    for y0 in (p.y[0] + 0.02, p.y[1] - 0.06):
        yield box("post", WHITE, (p.x[0], p.x[1] - 0.02), (y0, y0 + 0.04), (0.0, p.h - 0.025))
    inner = (p.y[0] + 0.06, p.y[1] - 0.06)
    yield box("dark", DARK, (p.x[0] + 0.02, p.x[1] - 0.06), inner, (0.08, p.h - 0.1))
    for i in range(n := max(4, min(30, round(p.w / 0.06)))):
        y = inner[0] + (i + 0.5) * (inner[1] - inner[0]) / n
        yield box("slat", WHITE, (p.x[1] - 0.04, p.x[1] - 0.025), (y - 0.012, y + 0.012), (0.08, p.h - 0.1))
    for z in ((0.04, 0.08), (p.h - 0.1, p.h - 0.026)):
        yield box("rail", WHITE, (p.x[1] - 0.045, p.x[1] - 0.02), inner, z)


def altar(p: Piece) -> Iterator[Part]:
    """Yield a stone table with a cloth."""
    top = p.h - 0.003
    yield box("base", CONCRETE, (0.8 * p.x[0], 0.8 * p.x[1]), (0.84 * p.y[0], 0.84 * p.y[1]), (0.0, top - 0.08))
    yield box("top", CONCRETE, p.x, p.y, (top - 0.08, top))
    yield box("cloth", WHITE, (0.9 * p.x[0], 0.9 * p.x[1]), (0.5 * p.y[0], 0.5 * p.y[1]), (top, p.h))
    yield box("cloth front", WHITE, (p.x[1], p.x[1] + 0.004), (0.5 * p.y[0], 0.5 * p.y[1]), (0.6 * p.h, top - 0.001))


def sauna(p: Piece) -> Iterator[Part]:
    """Yield a wooden cabin with a glass door."""
    yield box("cabin", PINE, (p.x[0], p.x[1] - 0.05), p.y, (0.04, p.h - 0.05))
    yield box("floor", p.dark, (p.x[0] + 0.002, p.x[1] - 0.02), (0.99 * p.y[0], 0.99 * p.y[1]), (0.0, 0.04))
    yield box("roof", p.dark, p.x, p.y, (p.h - 0.05, p.h))
    for y in ((p.y[0], -0.25 * p.w), (0.25 * p.w, p.y[1])):
        for i in range(6):
            z = (0.04 + i * (p.h - 0.09) / 6 + 0.004, 0.04 + (i + 1) * (p.h - 0.09) / 6 - 0.004)
            yield box("board", PINE, (p.x[1] - 0.05, p.x[1] - 0.02), y, z)
    yield box("dark", BLACK, (p.x[1] - 0.05, p.x[1] - 0.046), (-0.24 * p.w, 0.24 * p.w), (0.06, 0.9 * p.h))
    yield box("glass door", GLASS, (p.x[1] - 0.035, p.x[1] - 0.028), (-0.24 * p.w, 0.24 * p.w), (0.06, 0.9 * p.h))
    yield box("handle", p.dark, (p.x[1] - 0.027, p.x[1]), (0.16 * p.w, 0.2 * p.w), (0.44 * p.h, 0.58 * p.h))


def coffin(p: Piece) -> Iterator[Part]:
    """Yield a long chest with handles."""
    yield slab(
        "chest",
        p.dark,
        (0.9 * p.x[0], 0.9 * p.x[1]),
        (0.95 * p.y[0], 0.95 * p.y[1]),
        (0.0, 0.6 * p.h),
        top=(1.08, 1.04),
    )
    yield slab("lid", p.dark, p.x, p.y, (0.602 * p.h, p.h), top=(0.5, 0.84))
    for y in (-0.3 * p.w, 0.0, 0.3 * p.w):
        yield box("handle", STEEL, (0.46 * p.d, 0.5 * p.d), (y - 0.1, y + 0.1), (0.4 * p.h, 0.44 * p.h))


BUILDERS: dict[str, Builder] = {
    "stairs": stairs,
    "column post": column,
    "elevator": elevator,
    "radiator cover": radiator_cover,
    "altar": altar,
    "sauna": sauna,
    "coffin": coffin,
}
