"""Bathroom, laundry and cleaning."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import KNOB, Builder, board, carcass, doors, four
from robolayout.assets.palette import (
    BLACK,
    BLUE,
    BRIGHT,
    CERAMIC,
    CHROME,
    DARK,
    GLASS,
    GLOW,
    LIGHT_GREY,
    LINEN,
    MIRROR,
    PAPER,
    STEEL,
    WATER,
    WHITE,
    YELLOW,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, oval, prism, sheared, slab, soft


def toilet(p: Piece) -> Iterator[Part]:
    """Yield a toilet: cistern at the back, bowl, seat and lid."""
    seat = min(0.42, 0.56 * p.h)
    back = p.x[0] + 0.28 * p.d
    yield soft("cistern", CERAMIC, (p.x[0], back), (-0.46 * p.w, 0.46 * p.w), (seat - 0.02, p.h - 0.03), bevel=0.02)
    yield soft("cistern lid", CERAMIC, (p.x[0], back + 0.008), p.y, (p.h - 0.03, p.h - 0.008), bevel=0.006)
    yield cylinder("button", CHROME, (p.x[0] + 0.13 * p.d, 0.0), 0.025, (p.h - 0.008, p.h), sides=12)
    yield slab(
        "foot",
        CERAMIC,
        (p.x[0] + 0.1 * p.d, p.x[1] - 0.2 * p.d),
        (-0.26 * p.w, 0.26 * p.w),
        (0.0, seat - 0.16),
        top=(1.1, 1.3),
    )
    middle, half = (back + p.x[1]) / 2, (p.x[1] - back) / 2
    yield oval(
        "bowl",
        CERAMIC,
        (middle, 0.0),
        ((0.7 * half, 0.36 * p.w), (half, 0.48 * p.w)),
        (seat - 0.2, seat - 0.03),
        sides=22,
    )
    yield oval("seat", WHITE, (middle, 0.0), ((half, p.w / 2),) * 2, (seat - 0.028, seat - 0.008), sides=22)
    yield oval(
        "lid",
        LIGHT_GREY,
        (middle, 0.0),
        ((0.97 * half, 0.47 * p.w), (0.9 * half, 0.44 * p.w)),
        (seat - 0.006, seat + 0.008),
        sides=22,
    )


def bidet(p: Piece) -> Iterator[Part]:
    """Yield a bidet with a tap at the back."""
    rim = 0.86 * p.h
    yield slab(
        "foot",
        CERAMIC,
        (p.x[0] + 0.04, p.x[1] - 0.16 * p.d),
        (-0.3 * p.w, 0.3 * p.w),
        (0.0, 0.5 * p.h),
        top=(1.08, 1.2),
    )
    yield oval("bowl", CERAMIC, (0.0, 0.0), ((0.4 * p.d, 0.4 * p.w), (p.d / 2, p.w / 2)), (0.45 * p.h, rim), sides=22)
    yield oval("water", WATER, (0.04 * p.d, 0.0), ((0.36 * p.d, 0.36 * p.w),) * 2, (rim + 0.001, rim + 0.004), sides=22)
    yield cylinder("tap", CHROME, (p.x[0] + 0.06 * p.d, 0.0), 0.016, (rim, p.h), sides=8)
    yield box("spout", CHROME, (p.x[0] + 0.06 * p.d, p.x[0] + 0.2 * p.d), (-0.011, 0.011), (p.h - 0.026, p.h - 0.004))


def urinal(p: Piece) -> Iterator[Part]:
    """Yield a wall urinal."""
    yield soft("back", CERAMIC, (p.x[0], p.x[0] + 0.3 * p.d), p.y, (0.05 * p.h, p.h), bevel=0.03)
    yield oval(
        "bowl", CERAMIC, (0.05 * p.d, 0.0), ((0.2 * p.d, 0.3 * p.w), (0.45 * p.d, p.w / 2)), (0.0, 0.5 * p.h), sides=18
    )
    yield oval(
        "inside", LIGHT_GREY, (0.08 * p.d, 0.0), ((0.32 * p.d, 0.38 * p.w),) * 2, (0.5 * p.h, 0.505 * p.h), sides=18
    )
    yield cylinder("valve", CHROME, (p.x[0] + 0.14 * p.d, 0.0), 0.02, (0.98 * p.h, p.h + 0.04), sides=8)


def bathtub(p: Piece) -> Iterator[Part]:
    """Yield a bathtub filled with water and a tap on its rim."""
    rim = p.h - 0.1
    t = 0.06
    free = p.variant % 2 == 0
    if free:
        yield oval("tub", CERAMIC, (0.0, 0.0), ((0.4 * p.d, 0.44 * p.w), (p.d / 2, p.w / 2)), (0.0, rim), sides=28)
        yield oval("water", WATER, (0.0, 0.0), ((p.d / 2 - t, p.w / 2 - t),) * 2, (rim + 0.001, rim + 0.004), sides=28)
    else:
        yield soft("tub", CERAMIC, p.x, p.y, (0.0, rim), bevel=0.015)
        yield oval("water", WATER, (0.0, 0.0), ((p.d / 2 - t, p.w / 2 - t),) * 2, (rim + 0.001, rim + 0.004), sides=28)
    x = p.x[0] + 0.05
    yield cylinder("tap", CHROME, (x, 0.0), 0.016, (rim - 0.02, p.h), sides=8)
    yield box("spout", CHROME, (x, x + 0.13), (-0.012, 0.012), (p.h - 0.03, p.h - 0.005))


def shower(p: Piece) -> Iterator[Part]:
    """Yield a tray with glass on two sides, a pole and a head."""
    yield box("tray", CERAMIC, p.x, p.y, (0.0, 0.06))
    yield cylinder("drain", CHROME, (0.0, 0.0), 0.05, (0.06, 0.063), sides=14)
    yield box("tiles", LIGHT_GREY, (p.x[0], p.x[0] + 0.02), p.y, (0.06, p.h - 0.02))
    for y0 in (p.y[0], p.y[1] - 0.02):
        yield box("post", CHROME, (p.x[1] - 0.02, p.x[1]), (y0, y0 + 0.02), (0.06, p.h - 0.02))
        yield box("glass", GLASS, (p.x[0] + 0.021, p.x[1] - 0.021), (y0 + 0.007, y0 + 0.013), (0.061, p.h - 0.021))
    yield box("door", GLASS, (p.x[1] - 0.013, p.x[1] - 0.007), (p.y[0] + 0.02, 0.02 * p.w), (0.065, p.h - 0.03))
    for y in ((p.y[0], p.y[0] + 0.02), (p.y[1] - 0.02, p.y[1])):
        yield box("top rail", CHROME, (p.x[0], p.x[1] - 0.021), y, (p.h - 0.02, p.h))
    yield box("top rail", CHROME, (p.x[1] - 0.02, p.x[1]), p.y, (p.h - 0.02, p.h))
    yield cylinder("pole", CHROME, (p.x[0] + 0.06, 0.0), 0.01, (0.9, 0.96 * p.h), sides=8)
    yield box("arm", CHROME, (p.x[0] + 0.052, 0.0), (-0.008, 0.008), (0.945 * p.h, 0.955 * p.h))
    yield cylinder("head", CHROME, (-0.03, 0.0), (0.1, 0.03), (0.92 * p.h, 0.945 * p.h), sides=16)
    yield box("mixer", CHROME, (p.x[0] + 0.02, p.x[0] + 0.074), (-0.09, 0.09), (0.86, 0.92))


def washbasin(p: Piece) -> Iterator[Part]:
    """Yield a basin on a pedestal, or one that hangs on the wall where it is low."""
    rim = p.h - 0.1
    if p.h > 0.5:
        yield cylinder(
            "pedestal", CERAMIC, (p.x[0] + 0.3 * p.d, 0.0), (0.16 * p.d, 0.22 * p.d), (0.0, rim - 0.16), sides=16
        )
    yield slab(
        "basin",
        CERAMIC,
        (-0.36 * p.d, 0.36 * p.d),
        (-0.36 * p.w, 0.36 * p.w),
        (rim - 0.16, rim - 0.03),
        top=(1.39, 1.39),
    )
    yield box("rim", CERAMIC, p.x, p.y, (rim - 0.03, rim))
    yield oval("water", WATER, (0.06 * p.d, 0.0), ((0.34 * p.d, 0.38 * p.w),) * 2, (rim + 0.001, rim + 0.003), sides=22)
    yield from _tap(p, rim)


def _tap(p: Piece, rim: float) -> Iterator[Part]:
    """Yield a mixer tap at the back of a basin."""
    x = p.x[0] + 0.1 * p.d
    yield cylinder("tap", CHROME, (x, 0.0), 0.017, (rim, p.h), sides=8)
    yield box("spout", CHROME, (x, x + 0.26 * p.d), (-0.012, 0.012), (p.h - 0.022, p.h - 0.006))


def vanity(p: Piece) -> Iterator[Part]:
    """Yield a cabinet with a basin on top."""
    top = p.h - 0.035
    yield box("plinth", DARK, (p.x[0], p.x[1] - 0.07), (p.y[0] + 0.02, p.y[1] - 0.02), (0.0, 0.08))
    yield carcass(p, p.wood, (0.08, top - 0.031))
    yield from doors(p, p.front, p.y, (0.08, top - 0.031), count=2)
    yield board(p, CERAMIC, (top - 0.03, top))
    yield oval(
        "basin",
        WATER,
        (0.04 * p.d, 0.0),
        ((0.32 * p.d, min(0.3, 0.36 * p.w)),) * 2,
        (top + 0.001, top + 0.003),
        sides=22,
    )
    yield from _tap(p, top)


def medicine_cabinet(p: Piece) -> Iterator[Part]:
    """Yield a mirrored wall cabinet."""
    yield box("body", WHITE, (p.x[0], p.x[1] - 0.012), p.y, p.z)
    for y in ((p.y[0] + 0.003, -0.002), (0.002, p.y[1] - 0.003)):
        yield box("mirror", MIRROR, (p.x[1] - 0.012, p.x[1]), y, (0.003, p.h - 0.003))


def towel_rack(p: Piece) -> Iterator[Part]:
    """Yield a rail with a hanging towel."""
    z = p.h - 0.02
    yield cylinder("rail", CHROME, (z, p.x[1] - 0.02), 0.012, p.y, axis="y", sides=8)
    for y in (p.y[0] + 0.02, p.y[1] - 0.05):
        yield box("mount", CHROME, (p.x[0], p.x[1] - 0.02), (y, y + 0.03), (z - 0.01, z + 0.01))
    yield box("towel", p.accent, (p.x[1] - 0.008, p.x[1]), (-0.34 * p.w, 0.34 * p.w), (0.0, p.h))
    yield box("towel", p.accent, (p.x[1] - 0.04, p.x[1] - 0.032), (-0.34 * p.w, 0.34 * p.w), (0.2 * p.h, p.h))


def roll_holder(p: Piece) -> Iterator[Part]:
    """Yield a paper roll on a bracket."""
    yield box("plate", CHROME, (p.x[0], p.x[0] + 0.1 * p.d), p.y, (0.7 * p.h, p.h))
    r = 0.36 * min(p.d, p.h)
    yield cylinder("roll", PAPER, (r, p.x[1] - r), r, (-0.36 * p.w, 0.36 * p.w), axis="y", sides=16)
    for y0 in (p.y[0], p.y[1] - 0.06 * p.w):
        yield box("arm", CHROME, (p.x[0] + 0.1 * p.d, p.x[1] - r), (y0, y0 + 0.06 * p.w), (0.3 * p.h, 0.5 * p.h))


def toilet_brush(p: Piece) -> Iterator[Part]:
    """Yield a brush in its pot."""
    yield cylinder("pot", STEEL, (0.0, 0.0), p.d / 2, (0.0, 0.34 * p.h), sides=14)
    yield cylinder("collar", DARK, (0.0, 0.0), (0.4 * p.d, 0.2 * p.d), (0.34 * p.h, 0.4 * p.h), sides=14)
    yield cylinder("handle", STEEL, (0.0, 0.0), 0.07 * p.d, (0.4 * p.h, p.h), sides=8)


def hand_dryer(p: Piece) -> Iterator[Part]:
    """Yield a wall dryer with a nozzle."""
    yield soft("casing", STEEL, p.x, p.y, (0.12 * p.h, p.h), bevel=0.04)
    yield box("nozzle", BLACK, (0.0, 0.3 * p.d), (-0.25 * p.w, 0.25 * p.w), (0.0, 0.13 * p.h))


def grab_bar(p: Piece) -> Iterator[Part]:
    """Yield a rail with two round plates."""
    yield cylinder(
        "rail", STEEL, (p.h / 2, p.x[1] - 0.3 * p.h), 0.3 * p.h, (p.y[0] + 0.02, p.y[1] - 0.02), axis="y", sides=10
    )
    for y in (p.y[0] + p.h / 2, p.y[1] - p.h / 2):
        yield cylinder("plate", STEEL, (y, p.h / 2), p.h / 2, (p.x[0], p.x[0] + 0.1 * p.d), axis="x", sides=14)
        yield cylinder(
            "post", STEEL, (y, p.h / 2), 0.24 * p.h, (p.x[0] + 0.1 * p.d, p.x[1] - 0.3 * p.h), axis="x", sides=10
        )


def washer(p: Piece) -> Iterator[Part]:
    """Yield a washing machine or dryer with a round window."""
    face = p.x[1] - KNOB
    yield soft("body", WHITE, (p.x[0], face), p.y, (0.02, p.h), bevel=0.012)
    yield box("foot", BLACK, (p.x[0] + 0.03, face - 0.03), (p.y[0] + 0.03, p.y[1] - 0.03), (0.0, 0.02))
    middle, r = 0.46 * p.h, 0.34 * min(p.w, p.h)
    yield cylinder(
        "ring",
        STEEL if p.kind == "washing machine" else DARK,
        (0.0, middle),
        (r, 0.94 * r),
        (face, p.x[1] - 0.006),
        axis="x",
        sides=24,
    )
    yield cylinder(
        "window",
        WATER if p.kind == "washing machine" else BLACK,
        (0.0, middle),
        0.72 * r,
        (p.x[1] - 0.006, p.x[1]),
        axis="x",
        sides=24,
    )
    yield box("panel", LIGHT_GREY, (face, face + 0.006), (p.y[0] + 0.02, p.y[1] - 0.02), (0.86 * p.h, 0.98 * p.h))
    yield box("display", GLOW, (face + 0.006, face + 0.009), (0.14 * p.w, 0.34 * p.w), (0.89 * p.h, 0.95 * p.h))
    yield cylinder("dial", CHROME, (0.0, 0.92 * p.h), 0.03, (face + 0.006, p.x[1]), axis="x", sides=14)
    yield box("drawer", WHITE, (face + 0.006, face + 0.012), (p.y[0] + 0.04, -0.14 * p.w), (0.88 * p.h, 0.96 * p.h))


def drying_rack(p: Piece) -> Iterator[Part]:
    """Yield a folding airer with laundry."""
    for y0 in (p.y[0] + 0.06, p.y[1] - 0.08):
        for way in (1, -1):
            shift = 0.0 if way > 0 else 0.021
            yield sheared(
                "leg",
                STEEL,
                (way * 0.46 * p.d - 0.01, way * 0.46 * p.d + 0.01),
                (y0 + shift, y0 + shift + 0.02),
                (0.0, 0.92 * p.h),
                lean=(-way * 0.9 * p.d, 0.0),
            )
    for i in range(7):
        x = p.x[0] + (i + 0.5) * p.d / 7
        yield cylinder("rod", STEEL, (0.94 * p.h, x), 0.006, p.y, axis="y", sides=6)
    colors = (p.accent, LINEN, p.fabric, BLUE, p.bedding)
    for i in range(5):
        y = p.y[0] + (0.12 + 0.17 * i) * p.w
        x = p.x[0] + ((2 * i) % 6 + 1.5) * p.d / 7
        yield box("laundry", colors[i], (x - 0.01, x + 0.01), (y, y + 0.15 * p.w), (0.5 * p.h, p.h - 0.004 * i))


def ironing_board(p: Piece) -> Iterator[Part]:
    """Yield an ironing board on crossed legs."""
    top = 0.96 * p.h
    for way in (1, -1):
        yield sheared(
            "leg",
            STEEL,
            (-0.2 * p.d + way * 0.02, -0.2 * p.d + way * 0.02 + 0.02),
            (way * 0.34 * p.w - 0.012, way * 0.34 * p.w + 0.012),
            (0.0, top),
            lean=(0.2 * p.d, -way * 0.6 * p.w),
        )
        yield box(
            "foot",
            STEEL,
            (-0.46 * p.d, 0.46 * p.d),
            (way * 0.34 * p.w - 0.014, way * 0.34 * p.w + 0.014),
            (-0.002, 0.02),
        )
    outline = [
        (-p.d / 2, -0.5 * p.w),
        (p.d / 2, -0.5 * p.w),
        (p.d / 2, 0.28 * p.w),
        (0.2 * p.d, 0.5 * p.w),
        (-0.2 * p.d, 0.5 * p.w),
        (-p.d / 2, 0.28 * p.w),
    ]
    yield prism("board", p.accent, outline, (top, p.h))


def iron(p: Piece) -> Iterator[Part]:
    """Yield a clothes iron; its tip points to +y."""
    outline = [(-p.d / 2, p.y[0]), (p.d / 2, p.y[0]), (p.d / 2, 0.1 * p.w), (0.0, p.y[1]), (-p.d / 2, 0.1 * p.w)]
    yield prism("sole", STEEL, outline, (0.0, 0.14 * p.h))
    yield prism("body", BLUE, [(0.86 * x, 0.9 * y) for x, y in outline], (0.14 * p.h, 0.5 * p.h))
    yield box("handle", DARK, (-0.14 * p.d, 0.14 * p.d), (-0.4 * p.w, 0.24 * p.w), (0.82 * p.h, p.h))
    for y in (-0.4 * p.w, 0.14 * p.w):
        yield box("post", DARK, (-0.13 * p.d, 0.13 * p.d), (y + 0.001, y + 0.1 * p.w), (0.5 * p.h, 0.82 * p.h))


def vacuum(p: Piece) -> Iterator[Part]:
    """Yield an upright vacuum cleaner."""
    yield soft("head", DARK, (0.1 * p.d, p.x[1]), p.y, (0.0, 0.08 * p.h), bevel=0.015)
    yield box("base", DARK, (-0.36 * p.d, 0.12 * p.d), (-0.28 * p.w, 0.28 * p.w), (0.0, 0.06 * p.h))
    yield sheared(
        "body",
        p.accent,
        (-0.1 * p.d, 0.3 * p.d),
        (-0.3 * p.w, 0.3 * p.w),
        (0.06 * p.h, 0.62 * p.h),
        lean=(-0.24 * p.d, 0.0),
    )
    yield sheared(
        "pole",
        STEEL,
        (-0.26 * p.d, -0.18 * p.d),
        (-0.05 * p.w, 0.05 * p.w),
        (0.6 * p.h, 0.95 * p.h),
        lean=(-0.2 * p.d, 0.0),
    )
    yield box("grip", DARK, (p.x[0], -0.2 * p.d), (-0.08 * p.w, 0.08 * p.w), (0.94 * p.h, p.h))


def robot_dock(p: Piece) -> Iterator[Part]:
    """Yield a charging dock with a round robot vacuum in it."""
    yield box("dock", WHITE, (p.x[0], p.x[0] + 0.12 * p.d), p.y, p.z)
    r = min(0.43 * p.d, 0.48 * p.w)
    yield cylinder("robot", DARK, (p.x[1] - r, 0.0), r, (0.06 * p.h, 0.66 * p.h), sides=24)
    yield cylinder("lid", LIGHT_GREY, (p.x[1] - r, 0.0), 0.7 * r, (0.66 * p.h, 0.7 * p.h), sides=24)
    yield cylinder("sensor", BLACK, (p.x[1] - r, 0.0), 0.2 * r, (0.7 * p.h, 0.86 * p.h), sides=14)
    yield box("wheels", BLACK, (p.x[1] - 1.4 * r, p.x[1] - 0.6 * r), (-0.7 * r, 0.7 * r), (0.0, 0.06 * p.h))


def broom(p: Piece) -> Iterator[Part]:
    """Yield a broom."""
    yield slab("bristles", YELLOW, p.x, p.y, (0.0, 0.14 * p.h), top=(0.7, 0.9))
    yield box("head", p.dark, (-0.36 * p.d, 0.36 * p.d), (0.92 * p.y[0], 0.92 * p.y[1]), (0.14 * p.h, 0.18 * p.h))
    yield cylinder("pole", p.wood, (0.0, 0.0), 0.014, (0.18 * p.h, p.h), sides=8)


def bucket(p: Piece) -> Iterator[Part]:
    """Yield a bucket with water and a handle."""
    tone = BRIGHT[p.variant % 5]
    yield cylinder("bucket", tone, (0.0, 0.0), (0.36 * p.d, 0.48 * p.d), (0.0, 0.74 * p.h), sides=20)
    yield cylinder("rim", tone, (0.0, 0.0), p.d / 2, (0.74 * p.h, 0.8 * p.h), sides=20)
    yield cylinder("water", WATER, (0.0, 0.0), 0.44 * p.d, (0.8 * p.h + 0.001, 0.8 * p.h + 0.003), sides=20)
    yield box("handle", STEEL, (-0.01, 0.01), (-0.4 * p.w, 0.4 * p.w), (0.96 * p.h, p.h))
    for y in (-0.4 * p.w, 0.38 * p.w):
        yield box("handle", STEEL, (-0.009, 0.009), (y, y + 0.02 * p.w), (0.8 * p.h + 0.004, 0.96 * p.h))


def cleaning_cart(p: Piece) -> Iterator[Part]:
    """Yield a trolley with a waste bag, shelves, bottles and wheels."""
    for x in (p.x[0] + 0.07, p.x[1] - 0.07):
        for y in (p.y[0] + 0.08, p.y[1] - 0.08):
            yield cylinder("wheel", BLACK, (0.05, x), 0.05, (y - 0.015, y + 0.015), axis="y", sides=12)
    yield box("deck", LIGHT_GREY, p.x, p.y, (0.1, 0.16))
    yield slab(
        "bag",
        YELLOW,
        (0.86 * p.x[0], 0.86 * p.x[1]),
        (p.y[0] + 0.03, p.y[0] + 0.38 * p.w),
        (0.16, 0.9 * p.h),
        top=(1.1, 1.1),
    )
    yield box("frame", BLUE, p.x, (p.y[0], p.y[0] + 0.4 * p.w), (0.9 * p.h, 0.94 * p.h))
    yield box("cabinet", LIGHT_GREY, (0.9 * p.x[0], 0.9 * p.x[1]), (0.0, p.y[1] - 0.1), (0.16, 0.62 * p.h))
    for i in range(4):
        x = p.x[0] + (i + 0.8) * p.d / 4.6
        yield cylinder("bottle", BRIGHT[i], (x, 0.22 * p.w), (0.035, 0.02), (0.62 * p.h, 0.84 * p.h), sides=10)
    yield box("handle", DARK, (0.7 * p.x[0], 0.7 * p.x[1]), (p.y[1] - 0.03, p.y[1]), (p.h - 0.03, p.h))
    for x in (0.68 * p.x[0], 0.62 * p.x[1]):
        yield box("post", DARK, (x, x + 0.025), (p.y[1] - 0.029, p.y[1] - 0.004), (0.16, p.h - 0.03))


def boiler(p: Piece) -> Iterator[Part]:
    """Yield a hot-water tank with pipes and a gauge."""
    yield cylinder("tank", WHITE, (0.0, 0.0), min(p.d, p.w) / 2, (0.08 * p.h, 0.92 * p.h), sides=22)
    yield cylinder(
        "dome", WHITE, (0.0, 0.0), (min(p.d, p.w) / 2 - 0.004, 0.2 * p.d), (0.92 * p.h, 0.97 * p.h), sides=22
    )
    yield from four(
        Piece(0.7 * p.d, 0.7 * p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, 0, p.key),
        DARK,
        0.08 * p.h,
        thick=0.05,
    )
    for y in (-0.12 * p.w, 0.12 * p.w):
        yield cylinder("pipe", CHROME, (0.0, y), 0.014, (0.96 * p.h, p.h), sides=8)
    yield cylinder("gauge", DARK, (0.0, 0.4 * p.h), 0.06, (0.46 * p.d, 0.51 * p.d), axis="x", sides=14)


def sphere(p: Piece) -> Iterator[Part]:
    """Yield one ball."""
    yield ball("ball", p.accent, p.x, p.y, p.z, rings=6, sides=14)


BUILDERS: dict[str, Builder] = {
    "toilet": toilet,
    "bidet": bidet,
    "urinal": urinal,
    "bathtub": bathtub,
    "shower": shower,
    "washbasin": washbasin,
    "bathroom vanity": vanity,
    "medicine cabinet": medicine_cabinet,
    "towel rack": towel_rack,
    "toilet paper holder": roll_holder,
    "toilet brush": toilet_brush,
    "hand dryer": hand_dryer,
    "grab bar": grab_bar,
    "washing machine": washer,
    "clothes dryer": washer,
    "drying rack": drying_rack,
    "ironing board": ironing_board,
    "iron": iron,
    "vacuum cleaner": vacuum,
    "robot vacuum dock": robot_dock,
    "broom": broom,
    "bucket": bucket,
    "cleaning cart": cleaning_cart,
    "water heater": boiler,
    "exercise ball": sphere,
    "ball": sphere,
}
