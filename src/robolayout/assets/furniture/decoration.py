"""Lamps, plants, rugs, pictures, curtains and small things to look at."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, carcass, doors
from robolayout.assets.furniture.plants import disc
from robolayout.assets.palette import (
    BLACK,
    BRASS,
    BRICK,
    DARK,
    EMBER,
    GREEN,
    LEAF,
    LEAF_LIGHT,
    LIGHT_GREY,
    ORANGE,
    PAPER,
    PINK,
    SPINES,
    STEEL,
    STONE,
    WATER,
    WHITE,
    YELLOW,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, moved, oval, slab, soft

Span = tuple[float, float]


def statue(p: Piece) -> Iterator[Part]:
    """Yield a stylised bust on a block."""
    tone = (STONE, BRASS, p.dark, WHITE)[p.variant % 4]
    yield box("block", p.dark if tone is not p.dark else STONE, p.x, p.y, (0.0, 0.2 * p.h))
    yield slab(
        "chest", tone, (-0.36 * p.d, 0.36 * p.d), (-0.46 * p.w, 0.46 * p.w), (0.2 * p.h, 0.5 * p.h), top=(0.5, 0.36)
    )
    yield cylinder("neck", tone, (0.0, 0.0), 0.12 * min(p.d, p.w), (0.48 * p.h, 0.66 * p.h), sides=12)
    yield ball("head", tone, (-0.26 * p.d, 0.28 * p.d), (-0.22 * p.w, 0.22 * p.w), (0.6 * p.h, p.h), rings=6)


def floor_sculpture(p: Piece) -> Iterator[Part]:
    """Yield stacked rounded stones on a plinth."""
    yield box("plinth", WHITE, p.x, p.y, (0.0, 0.4 * p.h))
    low = 0.4 * p.h
    for i, share in enumerate((0.44, 0.34, 0.24)):
        tall = (0.26, 0.2, 0.14)[i] * p.h
        yield ball(
            "stone",
            (STONE, p.accent, STONE)[i],
            (-share * p.d, share * p.d),
            (-share * p.w, share * p.w),
            (low, low + tall),
            rings=5,
        )
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


def magazine(p: Piece) -> Iterator[Part]:
    """Yield a magazine with a cover picture."""
    yield box("pages", PAPER, p.x, p.y, (0.0, 0.7 * p.h))
    yield box(
        "cover", p.accent, (p.x[0] + 0.004, p.x[1] - 0.002), (p.y[0] + 0.002, p.y[1] - 0.002), (0.7 * p.h, 0.9 * p.h)
    )
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
        yield cylinder(
            "log",
            p.dark,
            (0.09 if i != 1 else 0.16, -0.02 + 0.03 * i),
            0.035,
            (-0.34 * (inner[1] - inner[0]) + y, 0.34 * (inner[1] - inner[0]) + y),
            axis="y",
            sides=8,
        )
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
        yield ball(
            "weed",
            (LEAF, LEAF_LIGHT)[i % 2],
            (-0.06, 0.02),
            (y - 0.03, y + 0.03),
            (low + 0.06, low + 0.06 + (0.22, 0.14, 0.26, 0.16)[i]),
            rings=3,
            sides=6,
        )
    for i in range(3):
        y, z = (-0.25 + 0.24 * i) * p.w, low + (0.2, 0.3, 0.16)[i]
        yield ball(
            "fish", (ORANGE, YELLOW, PINK)[i], (0.0, 0.03), (y - 0.04, y + 0.04), (z - 0.02, z + 0.02), rings=3, sides=8
        )
    yield box(
        "water", WATER, (p.x[0] + 0.005, p.x[1] - 0.005), (p.y[0] + 0.005, p.y[1] - 0.005), (low + 0.031, p.h - 0.05)
    )
    yield box("lid", BLACK, p.x, p.y, (p.h - 0.04, p.h))


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
        yield cylinder(
            "wire",
            p.metal,
            (0.96 * r * math.cos(turn), 0.96 * r * math.sin(turn)),
            0.004,
            (low + 0.04, 0.88 * p.h),
            sides=4,
        )
    yield cylinder("roof", p.metal, (0.0, 0.0), (r, 0.1 * r), (0.88 * p.h, p.h), sides=18)
    middle = (low + p.h) / 2
    yield cylinder("perch", p.wood, (middle - 0.05, 0.0), 0.008, (-0.9 * r, 0.9 * r), axis="y", sides=6)
    yield ball("bird", YELLOW, (-0.03, 0.04), (-0.03, 0.03), (middle - 0.04, middle + 0.06), rings=4, sides=8)


def pet_bed(p: Piece) -> Iterator[Part]:
    """Yield an oval cushion in a padded ring."""
    yield oval(
        "ring", p.fabric, (0.0, 0.0), ((p.d / 2, p.w / 2), (0.46 * p.d, 0.46 * p.w)), (0.0, 0.85 * p.h), sides=24
    )
    yield oval(
        "cushion",
        p.bedding,
        (0.0, 0.0),
        ((0.38 * p.d, 0.38 * p.w), (0.34 * p.d, 0.34 * p.w)),
        (0.5 * p.h, p.h),
        sides=24,
    )


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
    yield box(
        "light",
        EMBER if p.kind == "space heater" else GREEN,
        (p.x[1] - 0.012, p.x[1]),
        (-0.02, 0.02),
        (0.86 * p.h, 0.86 * p.h + 0.012),
    )


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
        yield cylinder("blade", p.accent, (y, z), 0.34 * r, (0.064 + 0.002 * i, 0.075 + 0.002 * i), axis="x", sides=10)
    yield cylinder("hub", STEEL, (0.0, middle), 0.2 * r, (0.077, 0.09), axis="x", sides=12)


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
        yield slab(
            "toe",
            tone,
            (-0.1 * p.d, 0.48 * p.d),
            (y - 0.19 * p.w, y + 0.19 * p.w),
            (0.14 * p.h, 0.6 * p.h),
            top=(0.7, 0.7),
        )
        yield slab(
            "heel", tone, (-0.49 * p.d, 0.0), (y - 0.18 * p.w, y + 0.18 * p.w), (0.13 * p.h, p.h), top=(0.8, 0.8)
        )


def trash_can(p: Piece) -> Iterator[Part]:
    """Yield a bin with a lid and a pedal."""
    tone = STEEL if p.variant % 2 else DARK
    if abs(p.d - p.w) < 0.06:
        yield disc(p, "bin", tone, (0.86, 0.96), (0.0, 0.88), sides=20)
        yield disc(p, "lid", BLACK if tone is DARK else DARK, (1.0, 0.84), (0.88, 1.0), sides=20)
        return
    yield slab("bin", tone, (p.x[0] + 0.01, p.x[1] - 0.02), (p.y[0] + 0.01, p.y[1] - 0.01), (0.0, 0.86 * p.h))
    yield slab("lid", p.accent, p.x, p.y, (0.862 * p.h, p.h), top=(0.86, 0.86))


BUILDERS: dict[str, Builder] = {
    "statue": statue,
    "floor sculpture": floor_sculpture,
    "unknown floor decor": floor_sculpture,
    "trophy": trophy,
    "book": book,
    "book stack": book_stack,
    "magazine": magazine,
    "fireplace": fireplace,
    "aquarium": aquarium,
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
