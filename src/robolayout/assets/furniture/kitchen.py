"""Kitchen units and machines."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import DOOR, KNOB, Builder, board, carcass, doors, drawers
from robolayout.assets.palette import (
    BLACK,
    BRIGHT,
    CERAMIC,
    CHROME,
    COFFEE,
    DARK,
    GLASS,
    GLOW,
    LEAF,
    PAPER,
    SPINES,
    STEEL,
    STONE,
    WHITE,
    YELLOW,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, sheared, slab, soft


def base(p: Piece, *, top: float | None = None) -> Iterator[Part]:
    """Yield a base unit: plinth, body, fronts in a mix of drawers and doors, worktop."""
    high = top or p.h
    yield box("plinth", DARK, (p.x[0] + 0.03, p.x[1] - 0.08), (p.y[0] + 0.01, p.y[1] - 0.01), (0.0, 0.1))
    yield carcass(p, p.front, (0.1, high - 0.041))
    yield board(p, STONE if p.variant % 2 else p.wood, (high - 0.04, high))
    count = max(1, round(p.w / 0.6))
    step = p.w / count
    for i in range(count):
        y = (p.y[0] + i * step, p.y[0] + (i + 1) * step)
        if i % 3 == 1:
            yield from drawers(p, p.front, y, (0.1, high - 0.041), rows=3)
        else:
            yield from drawers(p, p.front, y, (high - 0.2, high - 0.041), rows=1)
            yield from doors(p, p.front, y, (0.1, high - 0.2), count=1)


def kitchen_cabinet(p: Piece) -> Iterator[Part]:
    """Yield a base unit with two doors below a drawer."""
    yield from base(p)


def kitchen_counter(p: Piece) -> Iterator[Part]:
    """Yield a worktop over units."""
    yield from base(p)


def wall_cabinet(p: Piece) -> Iterator[Part]:
    """Yield a hanging cabinet with doors."""
    yield carcass(p, p.front, (0.0, p.h))
    yield from doors(p, p.front, p.y, (0.0, p.h), count=max(1, round(p.w / 0.45)))


def island(p: Piece) -> Iterator[Part]:
    """Yield an island: units in front, a breakfast overhang behind."""
    body = Piece(0.72 * p.d, p.w - 0.06, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    for part in base(body):
        if part.name != "top":
            part.vertices[:, 0] += 0.13 * p.d
            yield part
    yield box("worktop", STONE if p.variant % 2 else p.wood, p.x, p.y, (p.h - 0.04, p.h))


def kitchen_sink(p: Piece) -> Iterator[Part]:
    """Yield a unit with a steel basin and a tap."""
    top = p.h - 0.26 if p.h > 1.05 else p.h - 0.035
    yield from base(p, top=top)
    y = (-0.3 * p.w, 0.16 * p.w)
    x = (p.x[0] + 0.16 * p.d, p.x[1] - 0.14 * p.d)
    yield box("rim", STEEL, (x[0] - 0.02, x[1] + 0.02), (y[0] - 0.02, y[1] + 0.02), (top, top + 0.004))
    yield box("basin", DARK, x, y, (top + 0.004, top + 0.006))
    for i in range(5):
        z = 0.24 * p.w + 0.045 * i
        yield box("groove", STEEL, x, (z, z + 0.012), (top, top + 0.005))
    yield cylinder("tap", CHROME, (p.x[0] + 0.08, -0.07 * p.w), 0.014, (top + 0.002, p.h), sides=8)
    yield box(
        "spout",
        CHROME,
        (p.x[0] + 0.08, p.x[0] + 0.24),
        (-0.07 * p.w - 0.011, -0.07 * p.w + 0.011),
        (p.h - 0.024, p.h - 0.002),
    )


def fridge(p: Piece) -> Iterator[Part]:
    """Yield a fridge with a freezer below, or two doors side by side where it is wide."""
    skin = STEEL if p.variant % 2 else WHITE
    yield box("plinth", BLACK, (p.x[0], p.x[1] - 0.06), p.y, (0.0, 0.04))
    yield box("body", skin, (p.x[0], p.x[1] - 0.072), p.y, (0.04, p.h))
    face = p.x[1] - 0.03
    split = 0.36 * p.h if p.h > 1.2 else 0.0
    if p.w > 0.85 and p.h > 1.2:
        panels = [((p.y[0], 0.0), (0.04, p.h)), ((0.0, p.y[1]), (0.04, p.h))]
    elif split:
        panels = [(p.y, (0.04, split)), (p.y, (split, p.h))]
    else:
        panels = [(p.y, (0.04, p.h))]
    for i, ((y0, y1), (z0, z1)) in enumerate(panels):
        yield soft("door", skin, (p.x[1] - 0.07, face), (y0 + 0.002, y1 - 0.002), (z0 + 0.004, z1 - 0.002), bevel=0.008)
        at = y0 + 0.05 if i else y1 - 0.05
        z = (z0 + 0.3 * (z1 - z0), z0 + 0.8 * (z1 - z0))
        yield box("handle", CHROME if skin is WHITE else DARK, (face, p.x[1]), (at - 0.01, at + 0.01), z)


def freezer(p: Piece) -> Iterator[Part]:
    """Yield a chest freezer with a lid."""
    yield box("body", WHITE, (p.x[0], p.x[1] - 0.02), (p.y[0] + 0.004, p.y[1] - 0.004), (0.03, 0.86 * p.h))
    yield box("foot", BLACK, (p.x[0] + 0.02, p.x[1] - 0.05), (p.y[0] + 0.03, p.y[1] - 0.03), (0.0, 0.03))
    yield soft("lid", WHITE, (p.x[0], p.x[1] - 0.01), p.y, (0.865 * p.h, p.h), bevel=0.02)
    yield box("handle", DARK, (p.x[1] - 0.02, p.x[1]), (-0.1, 0.1), (0.8 * p.h, 0.84 * p.h))
    yield box("vent", DARK, (p.x[1] - 0.022, p.x[1] - 0.016), (0.2 * p.w, 0.42 * p.w), (0.08 * p.h, 0.24 * p.h))


def stove(p: Piece) -> Iterator[Part]:
    """Yield a cooker with four plates, knobs and an oven window."""
    skin = STEEL if p.variant % 2 else WHITE
    yield box("plinth", BLACK, (p.x[0], p.x[1] - 0.06), (p.y[0] + 0.01, p.y[1] - 0.01), (0.0, 0.06))
    yield box("body", skin, (p.x[0], p.x[1] - 0.06), p.y, (0.06, p.h - 0.03))
    yield box("hob", BLACK, (p.x[0], p.x[1] - 0.03), p.y, (p.h - 0.03, p.h - 0.008))
    for x in (-0.24, 0.2):
        for y in (-0.24, 0.24):
            r = 0.16 * min(p.d, p.w) * (1.0 if x * y > 0 else 0.75)
            yield cylinder("plate", DARK, (x * p.d, y * p.w), r, (p.h - 0.008, p.h), sides=18)
    face = p.x[1] - 0.035
    yield box("panel", skin, (p.x[1] - 0.058, face), p.y, (0.84 * p.h, p.h - 0.031))
    for i in range(5):
        y = p.y[0] + (i + 0.5) * p.w / 5
        yield cylinder("knob", DARK, (y, 0.9 * p.h), 0.022, (face, p.x[1]), axis="x", sides=12)
    yield box("oven door", skin, (p.x[1] - 0.058, face), (p.y[0] + 0.003, p.y[1] - 0.003), (0.22 * p.h, 0.83 * p.h))
    yield box("window", BLACK, (face, face + 0.003), (-0.34 * p.w, 0.34 * p.w), (0.32 * p.h, 0.66 * p.h))
    yield box("handle", CHROME, (face, p.x[1] - 0.005), (-0.38 * p.w, 0.38 * p.w), (0.75 * p.h, 0.78 * p.h))
    yield box("drawer", skin, (p.x[1] - 0.058, face), (p.y[0] + 0.003, p.y[1] - 0.003), (0.07, 0.21 * p.h))


def microwave(p: Piece) -> Iterator[Part]:
    """Yield a microwave oven."""
    yield soft("casing", STEEL if p.variant % 2 else WHITE, (p.x[0], p.x[1] - 0.02), p.y, p.z, bevel=0.012)
    yield box("window", BLACK, (p.x[1] - 0.02, p.x[1] - 0.012), (p.y[0] + 0.02, 0.2 * p.w), (0.12 * p.h, 0.9 * p.h))
    yield box("panel", DARK, (p.x[1] - 0.02, p.x[1] - 0.012), (0.24 * p.w, p.y[1] - 0.02), (0.12 * p.h, 0.9 * p.h))
    yield box("time", GLOW, (p.x[1] - 0.012, p.x[1] - 0.009), (0.28 * p.w, 0.44 * p.w), (0.72 * p.h, 0.84 * p.h))
    yield box("handle", CHROME, (p.x[1] - 0.012, p.x[1]), (0.17 * p.w, 0.19 * p.w), (0.2 * p.h, 0.82 * p.h))
    yield cylinder(
        "dial", CHROME, (0.36 * p.w, 0.34 * p.h), 0.09 * p.h, (p.x[1] - 0.012, p.x[1] - 0.002), axis="x", sides=12
    )


def dishwasher(p: Piece) -> Iterator[Part]:
    """Yield a dishwasher: one front with a control strip."""
    skin = STEEL if p.variant % 2 else WHITE
    yield box("body", skin, (p.x[0], p.x[1] - KNOB - DOOR - 0.002), p.y, (0.08, p.h - 0.026))
    yield box("plinth", BLACK, (p.x[0], p.x[1] - 0.08), (p.y[0] + 0.01, p.y[1] - 0.01), (0.0, 0.08))
    yield board(p, skin, (p.h - 0.025, p.h))
    face = p.x[1] - KNOB
    yield box("door", skin, (face - DOOR, face), (p.y[0] + 0.004, p.y[1] - 0.004), (0.09, 0.82 * p.h))
    yield box("controls", DARK, (face - DOOR, face), (p.y[0] + 0.004, p.y[1] - 0.004), (0.83 * p.h, p.h - 0.03))
    yield box("display", GLOW, (face, face + 0.003), (-0.06, 0.06), (0.88 * p.h, 0.92 * p.h))
    yield box("handle", CHROME, (face, p.x[1]), (-0.34 * p.w, 0.34 * p.w), (0.74 * p.h, 0.77 * p.h))


def range_hood(p: Piece) -> Iterator[Part]:
    """Yield a hood: canopy and chimney."""
    yield box("rim", STEEL, p.x, p.y, (0.0, 0.09 * p.h))
    yield slab("canopy", STEEL, p.x, p.y, (0.09 * p.h, 0.42 * p.h), top=(0.5, 0.4))
    yield box("chimney", STEEL, (-0.24 * p.d, 0.24 * p.d), (-0.19 * p.w, 0.19 * p.w), (0.42 * p.h, p.h))
    yield box("light", GLOW, (p.x[1], p.x[1] + 0.004), (-0.1 * p.w, 0.1 * p.w), (0.02 * p.h, 0.07 * p.h))


def toaster(p: Piece) -> Iterator[Part]:
    """Yield a toaster with two slices."""
    yield soft(
        "casing",
        p.accent if p.variant % 2 else STEEL,
        (p.x[0], p.x[1] - 0.012),
        p.y,
        (0.04 * p.h, 0.86 * p.h),
        bevel=0.03,
    )
    yield box("foot", BLACK, (0.8 * p.x[0], 0.7 * p.x[1]), (0.9 * p.y[0], 0.9 * p.y[1]), (0.0, 0.05 * p.h))
    for x in (-0.2 * p.d, 0.16 * p.d):
        yield box("slice", YELLOW, (x - 0.06 * p.d, x + 0.06 * p.d), (-0.26 * p.w, 0.26 * p.w), (0.84 * p.h, p.h))
    yield box("lever", BLACK, (p.x[1] - 0.014, p.x[1]), (0.26 * p.w, 0.36 * p.w), (0.5 * p.h, 0.58 * p.h))


def coffee_machine(p: Piece) -> Iterator[Part]:
    """Yield an espresso machine with a spout and a cup."""
    skin = STEEL if p.variant % 2 else DARK
    yield box("foot", DARK, (p.x[0], p.x[1]), p.y, (0.0, 0.12 * p.h))
    yield box("grid", STEEL, (0.02 * p.d, p.x[1] - 0.01), (0.9 * p.y[0], 0.9 * p.y[1]), (0.12 * p.h, 0.14 * p.h))
    yield box("body", skin, (p.x[0] + 0.002, -0.02 * p.d), (0.98 * p.y[0], 0.98 * p.y[1]), (0.12 * p.h, 0.62 * p.h))
    yield soft("head", skin, (p.x[0], p.x[1] - 0.06 * p.d), p.y, (0.62 * p.h, 0.92 * p.h), bevel=0.02)
    yield box("warmer", STEEL, (0.9 * p.x[0], 0.5 * p.x[1]), (0.9 * p.y[0], 0.9 * p.y[1]), (0.92 * p.h, 0.95 * p.h))
    for y in (-0.24, 0.0, 0.24):
        yield cylinder("cup", CERAMIC, (-0.1 * p.d, y * p.w), (0.06 * p.w, 0.09 * p.w), (0.95 * p.h, p.h), sides=10)
    yield box("spout", CHROME, (0.14 * p.d, 0.24 * p.d), (-0.09 * p.w, 0.09 * p.w), (0.5 * p.h, 0.62 * p.h))
    yield cylinder("mug", CERAMIC, (0.2 * p.d, 0.0), (0.1 * p.w, 0.13 * p.w), (0.14 * p.h, 0.34 * p.h), sides=12)
    yield cylinder("coffee", COFFEE, (0.2 * p.d, 0.0), 0.11 * p.w, (0.34 * p.h, 0.345 * p.h), sides=12)
    yield box(
        "display", GLOW, (p.x[1] - 0.06 * p.d, p.x[1] - 0.05 * p.d), (-0.2 * p.w, 0.2 * p.w), (0.74 * p.h, 0.84 * p.h)
    )


def blender(p: Piece) -> Iterator[Part]:
    """Yield a blender: motor base, glass jug, lid."""
    yield cylinder("base", STEEL, (0.0, 0.0), (p.d / 2, 0.36 * p.d), (0.0, 0.34 * p.h), sides=16)
    yield cylinder("dial", BLACK, (0.0, 0.14 * p.h), 0.05 * p.h, (0.42 * p.d, 0.5 * p.d), axis="x", sides=12)
    yield cylinder("jug", GLASS, (0.0, 0.0), (0.3 * p.d, 0.42 * p.d), (0.34 * p.h, 0.92 * p.h), sides=14)
    yield cylinder("smoothie", p.accent, (0.0, 0.0), (0.27 * p.d, 0.33 * p.d), (0.35 * p.h, 0.68 * p.h), sides=14)
    yield cylinder("lid", BLACK, (0.0, 0.0), (0.44 * p.d, 0.2 * p.d), (0.92 * p.h, p.h), sides=14)
    yield box("handle", BLACK, (-0.05 * p.d, 0.05 * p.d), (0.4 * p.w, 0.5 * p.w), (0.42 * p.h, 0.86 * p.h))


def rice_cooker(p: Piece) -> Iterator[Part]:
    """Yield a round cooker with a lid and a panel."""
    yield cylinder("body", WHITE, (0.0, 0.0), (0.88 * p.d / 2, 0.97 * p.d / 2), (0.0, 0.66 * p.h), sides=20)
    yield cylinder("lid", p.accent, (0.0, 0.0), (0.97 * p.d / 2, 0.3 * p.d), (0.66 * p.h, 0.9 * p.h), sides=20)
    yield box("handle", BLACK, (-0.1 * p.d, 0.1 * p.d), (-0.16 * p.w, 0.16 * p.w), (0.88 * p.h, p.h))
    yield box("panel", DARK, (0.4 * p.d, p.x[1]), (-0.16 * p.w, 0.16 * p.w), (0.2 * p.h, 0.5 * p.h))


def pot(p: Piece) -> Iterator[Part]:
    """Yield a pot with a lid and two handles at its sides."""
    r = min(p.d, 0.8 * p.w) / 2
    skin = (STEEL, SPINES[0], DARK)[p.variant % 3]
    yield cylinder("pot", skin, (0.0, 0.0), (0.94 * r, r), (0.0, 0.74 * p.h), sides=20)
    yield cylinder("lid", skin, (0.0, 0.0), (1.02 * r, 0.5 * r), (0.74 * p.h, 0.88 * p.h), sides=20)
    yield cylinder("knob", BLACK, (0.0, 0.0), 0.14 * r, (0.86 * p.h, p.h), sides=8)
    for y in ((p.y[0], -0.94 * r), (0.94 * r, p.y[1])):
        yield box("handle", BLACK, (-0.2 * r, 0.2 * r), y, (0.54 * p.h, 0.64 * p.h))


def pan(p: Piece) -> Iterator[Part]:
    """Yield a frying pan; its handle points forward."""
    r = p.w / 2
    middle = p.x[0] + r
    yield cylinder("pan", DARK, (middle, 0.0), (0.82 * r, r), (0.0, 0.7 * p.h), sides=22)
    yield cylinder("bottom", BLACK, (middle, 0.0), 0.8 * r, (0.7 * p.h, 0.74 * p.h), sides=22)
    yield box("handle", p.wood, (middle + 0.9 * r, p.x[1]), (-0.07 * p.w, 0.07 * p.w), (0.5 * p.h, p.h))


def cutting_board(p: Piece) -> Iterator[Part]:
    """Yield a wooden board with a groove and a hole."""
    yield soft("board", p.wood, p.x, p.y, (0.0, 0.9 * p.h), bevel=0.008)
    yield box("mark", p.dark, (0.84 * p.x[0], 0.84 * p.x[1]), (0.9 * p.y[0], 0.7 * p.y[1]), (0.9 * p.h, 0.94 * p.h))
    yield box("field", p.wood, (0.8 * p.x[0], 0.8 * p.x[1]), (0.87 * p.y[0], 0.67 * p.y[1]), (0.94 * p.h, p.h))
    yield cylinder("hole", DARK, (0.0, 0.86 * p.y[1]), 0.04 * p.w, (0.9 * p.h, 0.94 * p.h), sides=10)


def knife_block(p: Piece) -> Iterator[Part]:
    """Yield a slanted block with knife handles."""
    yield sheared("block", p.wood, (-0.1 * p.d, p.x[1]), p.y, (0.0, 0.66 * p.h), lean=(-0.4 * p.d, 0.0))
    for i in range(4):
        for x in (-0.36, -0.16):
            y = p.y[0] + (i + 0.5) * p.w / 4
            z = (0.62 * p.h, p.h - 0.06 * p.h * ((i + (x < -0.2)) % 3))
            yield sheared(
                "handle",
                BLACK,
                (x * p.d, (x + 0.1) * p.d),
                (y - 0.06 * p.w, y + 0.06 * p.w),
                z,
                lean=(-0.14 * p.d, 0.0),
            )


def dish_rack(p: Piece) -> Iterator[Part]:
    """Yield a rack with plates drying in it."""
    yield box("tray", STEEL, p.x, p.y, (0.0, 0.1 * p.h))
    for y0 in (p.y[0], p.y[1] - 0.012):
        yield box("rail", STEEL, (p.x[0] + 0.001, p.x[1] - 0.001), (y0, y0 + 0.012), (0.1 * p.h, 0.5 * p.h))
    for i in range(6):
        y = p.y[0] + (i + 1) * p.w / 8
        r = 0.44 * min(p.h * 0.95, p.d)
        yield cylinder(
            "plate", CERAMIC if i % 3 else p.accent, (0.1 * p.h + r, 0.0), r, (y - 0.006, y + 0.006), axis="y", sides=16
        )
    yield cylinder("glass", GLASS, (0.0, 0.4 * p.w), 0.06 * p.w, (0.1 * p.h, p.h), sides=10)


def spice_rack(p: Piece) -> Iterator[Part]:
    """Yield a small rack of jars."""
    rows = max(1, round(p.h / 0.14))
    for y0 in (p.y[0], p.y[1] - 0.012):
        yield box("side", p.wood, p.x, (y0, y0 + 0.012), p.z)
    inner = (p.y[0] + 0.012, p.y[1] - 0.012)
    for i in range(rows):
        z = i * p.h / rows
        yield box("shelf", p.wood, p.x, inner, (z, z + 0.01))
        for j in range(n := max(2, round(p.w / 0.065))):
            y = inner[0] + (j + 0.5) * (inner[1] - inner[0]) / n
            r = min(0.02, 0.4 * p.d)
            tone = (*BRIGHT, COFFEE)[(i * 3 + j * 2) % 7]
            yield cylinder("jar", tone, (0.0, y), r, (z + 0.01, z + 0.01 + 0.55 * p.h / rows), sides=10)
            yield cylinder(
                "lid", DARK, (0.0, y), r, (z + 0.01 + 0.55 * p.h / rows, z + 0.01 + 0.65 * p.h / rows), sides=10
            )


def paper_towel(p: Piece) -> Iterator[Part]:
    """Yield a roll on a holder."""
    yield cylinder("foot", p.wood, (0.0, 0.0), p.d / 2, (0.0, 0.05 * p.h), sides=18)
    yield cylinder("roll", PAPER, (0.0, 0.0), 0.46 * p.d, (0.05 * p.h, 0.86 * p.h), sides=18)
    yield cylinder("pin", p.wood, (0.0, 0.0), 0.08 * p.d, (0.86 * p.h, p.h), sides=8)


def scale(p: Piece) -> Iterator[Part]:
    """Yield flat scales with a display in front."""
    yield soft("base", WHITE if p.variant % 2 else DARK, p.x, p.y, (0.0, 0.7 * p.h), bevel=0.01)
    yield box("plate", STEEL, (0.9 * p.x[0], 0.5 * p.x[1]), (0.9 * p.y[0], 0.9 * p.y[1]), (0.7 * p.h, p.h))
    yield box("display", GLOW, (0.6 * p.x[1], 0.85 * p.x[1]), (0.4 * p.y[0], 0.4 * p.y[1]), (0.7 * p.h, 0.74 * p.h))


def sponge(p: Piece) -> Iterator[Part]:
    """Yield a two-coloured sponge."""
    yield soft("sponge", YELLOW, p.x, p.y, (0.0, 0.7 * p.h), bevel=0.004)
    yield box("scourer", LEAF, p.x, p.y, (0.701 * p.h, p.h))


BUILDERS: dict[str, Builder] = {
    "kitchen cabinet": kitchen_cabinet,
    "kitchen counter": kitchen_counter,
    "wall cabinet": wall_cabinet,
    "kitchen island": island,
    "kitchen sink": kitchen_sink,
    "fridge": fridge,
    "mini fridge": fridge,
    "freezer": freezer,
    "stove": stove,
    "microwave": microwave,
    "dishwasher": dishwasher,
    "range hood": range_hood,
    "toaster": toaster,
    "coffee machine": coffee_machine,
    "blender": blender,
    "rice cooker": rice_cooker,
    "pot": pot,
    "pan": pan,
    "cutting board": cutting_board,
    "knife block": knife_block,
    "dish rack": dish_rack,
    "spice rack": spice_rack,
    "paper towel": paper_towel,
    "kitchen scale": scale,
    "bathroom scale": scale,
    "sponge": sponge,
}
