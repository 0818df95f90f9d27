"""Hospitals, care homes, and sport indoors."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, carcass, drawers, four
from robolayout.assets.palette import (
    BLACK,
    BLUE,
    BRIGHT,
    CERAMIC,
    DARK,
    GLOW,
    GREY,
    LIGHT_GREY,
    LINEN,
    RED,
    RUBBER,
    STEEL,
    WATER,
    WHITE,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, moved, oval, sheared, slab, soft


def castors(p: Piece, r: float, *, inset: float = 0.04) -> Iterator[Part]:
    """Yield four wheels of radius `r` under the corners."""
    for x in (p.x[0] + r + inset, p.x[1] - r - inset):
        for y in (p.y[0] + inset, p.y[1] - inset):
            yield cylinder("castor", RUBBER, (r, x), r, (y - 0.018, y + 0.018), axis="y", sides=12)


def wheel(p: Piece, x: float, y: float, r: float, *, wide: float = 0.03) -> Iterator[Part]:
    """Yield a large spoked wheel: tyre disc, lighter inside, hub."""
    yield cylinder("tyre", RUBBER, (r, x), r, (y - wide / 2, y + wide / 2), axis="y", sides=24)
    yield cylinder(
        "spokes", LIGHT_GREY, (r, x), 0.86 * r, (y - wide / 2 - 0.002, y + wide / 2 + 0.002), axis="y", sides=24
    )
    yield cylinder("hub", DARK, (r, x), 0.2 * r, (y - wide / 2 - 0.006, y + wide / 2 + 0.006), axis="y", sides=12)


def hospital_bed(p: Piece) -> Iterator[Part]:
    """Yield a hospital bed on castors, its head part raised, with side rails."""
    low, top = 0.36 * p.h, 0.58 * p.h
    yield from castors(p, 0.07, inset=0.06)
    yield box("chassis", LIGHT_GREY, (0.86 * p.x[0], 0.86 * p.x[1]), (0.7 * p.y[0], 0.7 * p.y[1]), (0.12, 0.18))
    for x in (-0.3 * p.d, 0.3 * p.d):
        yield box("lift", GREY, (x - 0.06, x + 0.06), (-0.16, 0.16), (0.18, low))
    yield box("frame", LIGHT_GREY, (0.95 * p.x[0], 0.95 * p.x[1]), (0.92 * p.y[0], 0.92 * p.y[1]), (low, low + 0.06))
    knee = -0.12 * p.d
    inner = (0.88 * p.y[0], 0.88 * p.y[1])
    yield soft("mattress", p.bedding, (knee, 0.94 * p.x[1]), inner, (low + 0.06, top), bevel=0.03)
    back = soft("mattress", p.bedding, (0.94 * p.x[0], knee - 0.004), inner, (low + 0.06, top), bevel=0.03)
    back.vertices[:, 2] += (knee - back.vertices[:, 0]) * 0.3
    yield back
    pillow = soft("pillow", LINEN, (0.9 * p.x[0], 0.9 * p.x[0] + 0.34), (-0.3, 0.3), (top, top + 0.1), bevel=0.04)
    pillow.vertices[:, 2] += (knee - pillow.vertices[:, 0]) * 0.3
    yield pillow
    yield soft(
        "blanket", p.accent, (0.0, 0.945 * p.x[1]), (0.89 * p.y[0], 0.89 * p.y[1]), (low + 0.1, top + 0.03), bevel=0.03
    )
    for x, tall in ((p.x[0], p.h), (p.x[1] - 0.04, 0.86 * p.h)):
        yield soft("end board", p.wood, (x, x + 0.04), (0.96 * p.y[0], 0.96 * p.y[1]), (low - 0.04, tall), bevel=0.015)
    for y0 in (p.y[0], p.y[1] - 0.025):
        for z in (0.62 * p.h, 0.74 * p.h):
            yield box("rail", LIGHT_GREY, (-0.3 * p.d, 0.2 * p.d), (y0, y0 + 0.025), (z, z + 0.04))
        for x in (-0.28 * p.d, 0.16 * p.d):
            yield box("rail post", LIGHT_GREY, (x, x + 0.03), (y0 + 0.004, y0 + 0.021), (low, 0.62 * p.h))


def overbed_table(p: Piece) -> Iterator[Part]:
    """Yield a C-shaped table on castors."""
    yield from castors(p, 0.03, inset=0.02)
    yield box("foot", LIGHT_GREY, p.x, (p.y[0], p.y[0] + 0.06), (0.05, 0.09))
    for x in (p.x[0], p.x[1] - 0.05):
        yield box("foot", LIGHT_GREY, (x, x + 0.05), (p.y[0] + 0.06, p.y[1]), (0.05, 0.088))
    yield box("column", STEEL, (-0.04, 0.04), (p.y[0] + 0.005, p.y[0] + 0.055), (0.09, p.h - 0.03))
    yield soft("top", p.wood, p.x, p.y, (p.h - 0.03, p.h), bevel=0.008)


def wheelchair(p: Piece) -> Iterator[Part]:
    """Yield a wheelchair that faces +x."""
    r = 0.33 * p.h
    for side in (-1, 1):
        yield from wheel(p, -0.14 * p.d, side * (p.w / 2 - 0.025), r)
        yield cylinder(
            "castor",
            RUBBER,
            (0.09, 0.28 * p.d),
            0.09,
            (side * 0.36 * p.w - 0.015, side * 0.36 * p.w + 0.015),
            axis="y",
            sides=14,
        )
        y = side * 0.38 * p.w
        yield box("fork", STEEL, (0.26 * p.d, 0.3 * p.d), (y - 0.012, y + 0.012), (0.17, 0.36 * p.h))
        yield box("frame", STEEL, (-0.3 * p.d, 0.3 * p.d), (y - 0.013, y + 0.013), (0.36 * p.h, 0.4 * p.h))
        yield sheared(
            "push pole",
            STEEL,
            (-0.3 * p.d, -0.3 * p.d + 0.03),
            (y - 0.014, y + 0.014),
            (0.4 * p.h, 0.97 * p.h),
            lean=(-0.1 * p.d, 0.0),
        )
        yield box("grip", BLACK, (p.x[0], -0.36 * p.d), (y - 0.018, y + 0.018), (0.95 * p.h, p.h))
        yield soft(
            "arm rest", BLACK, (-0.26 * p.d, 0.14 * p.d), (y - 0.03, y + 0.03), (0.7 * p.h, 0.74 * p.h), bevel=0.01
        )
        yield box("arm post", STEEL, (0.08 * p.d, 0.11 * p.d), (y - 0.011, y + 0.011), (0.4 * p.h, 0.7 * p.h))
        yield sheared(
            "leg pole",
            STEEL,
            (0.28 * p.d, 0.31 * p.d),
            (0.7 * y - 0.011, 0.7 * y + 0.011),
            (0.12, 0.4 * p.h),
            lean=(-0.06 * p.d, 0.0),
        )
        yield box("foot plate", DARK, (0.28 * p.d, p.x[1]), (0.7 * y - 0.08, 0.7 * y + 0.08), (0.1, 0.12))
    yield soft(
        "seat", p.fabric, (-0.28 * p.d, 0.22 * p.d), (-0.35 * p.w, 0.35 * p.w), (0.46 * p.h, 0.54 * p.h), bevel=0.02
    )
    back = soft(
        "back", p.fabric, (-0.3 * p.d, -0.26 * p.d), (-0.34 * p.w, 0.34 * p.w), (0.55 * p.h, 0.92 * p.h), bevel=0.012
    )
    back.vertices[:, 0] -= 0.09 * p.d * (back.vertices[:, 2] / p.h - 0.5)
    yield back


def walker(p: Piece) -> Iterator[Part]:
    """Yield a rollator: four wheels, a seat, two grips; the walker stands behind it."""
    r = 0.11 * p.h
    for side in (-1, 1):
        y = side * (p.w / 2 - 0.03)
        for x in (p.x[0] + r, p.x[1] - r):
            yield cylinder("wheel", RUBBER, (r, x), r, (y - 0.016, y + 0.016), axis="y", sides=16)
        yield sheared(
            "front pole",
            STEEL,
            (p.x[1] - r - 0.014, p.x[1] - r + 0.014),
            (y - 0.013, y + 0.013),
            (r, 0.94 * p.h),
            lean=(-0.5 * p.d, 0.0),
        )
        yield sheared(
            "rear pole",
            STEEL,
            (p.x[0] + r - 0.014, p.x[0] + r + 0.014),
            (y - 0.012, y + 0.012),
            (r, 0.6 * p.h),
            lean=(0.3 * p.d, 0.0),
        )
        yield box("grip", BLACK, (-0.34 * p.d, 0.0), (y - 0.02, y + 0.02), (0.94 * p.h, p.h))
    yield soft(
        "seat",
        p.fabric,
        (-0.26 * p.d, 0.16 * p.d),
        (0.84 * p.y[0], 0.84 * p.y[1]),
        (0.6 * p.h, 0.65 * p.h),
        bevel=0.012,
    )
    yield slab("basket", DARK, (0.1 * p.d, 0.4 * p.d), (0.6 * p.y[0], 0.6 * p.y[1]), (0.36 * p.h, 0.56 * p.h))


def iv_stand(p: Piece) -> Iterator[Part]:
    """Yield a drip stand with a bag and a pump."""
    reach = min(p.d, p.w) / 2
    for i in range(5):
        turn = 2 * math.pi * i / 5
        yield moved(box("spoke", STEEL, (0.02, reach - 0.02), (-0.012, 0.012), (0.05, 0.08)), turn=turn)
        x, y = (reach - 0.025) * math.cos(turn), (reach - 0.025) * math.sin(turn)
        yield ball("castor", RUBBER, (x - 0.025, x + 0.025), (y - 0.025, y + 0.025), (0.0, 0.05), rings=3, sides=8)
    yield cylinder("pole", STEEL, (0.0, 0.0), 0.012, (0.085, p.h - 0.02), sides=8)
    yield cylinder("hub", STEEL, (0.0, 0.0), 0.03, (0.049, 0.085), sides=10)
    yield box("hooks", STEEL, (-0.01, 0.01), (-0.16, 0.16), (p.h - 0.02, p.h))
    yield soft("bag", WATER, (-0.015, 0.02), (0.05, 0.17), (0.82 * p.h, p.h - 0.03), bevel=0.01)
    yield box("pump", LIGHT_GREY, (0.012, 0.12), (-0.07, 0.07), (0.55 * p.h, 0.68 * p.h))
    yield box("display", GLOW, (0.12, 0.124), (-0.05, 0.05), (0.61 * p.h, 0.66 * p.h))


def patient_lift(p: Piece) -> Iterator[Part]:
    """Yield a hoist with a boom and a sling bar."""
    yield from castors(p, 0.04, inset=0.03)
    for y0 in (p.y[0], p.y[1] - 0.06):
        yield box("leg", BLUE, p.x, (y0, y0 + 0.06), (0.05, 0.11))
    yield box("cross bar", BLUE, (p.x[0], p.x[0] + 0.1), (p.y[0] + 0.06, p.y[1] - 0.06), (0.05, 0.11))
    yield box("mast", WHITE, (p.x[0] + 0.02, p.x[0] + 0.1), (-0.04, 0.04), (0.11, 0.92 * p.h))
    boom = box("boom", WHITE, (p.x[0] + 0.02, 0.3 * p.d), (-0.035, 0.035), (0.92 * p.h, 0.97 * p.h))
    yield boom
    yield box("cap", DARK, (p.x[0], p.x[0] + 0.12), (-0.05, 0.05), (0.97 * p.h, p.h))
    yield cylinder("strap", DARK, (0.28 * p.d, 0.0), 0.012, (0.78 * p.h, 0.92 * p.h), sides=8)
    yield box("sling bar", DARK, (0.26 * p.d, 0.3 * p.d), (-0.36 * p.w, 0.36 * p.w), (0.75 * p.h, 0.78 * p.h))
    yield soft(
        "sling", p.fabric, (0.22 * p.d, 0.34 * p.d), (-0.3 * p.w, 0.3 * p.w), (0.46 * p.h, 0.74 * p.h), bevel=0.04
    )


def commode_chair(p: Piece) -> Iterator[Part]:
    """Yield a chair with a hole and arms."""
    seat = 0.5 * p.h
    yield from four(p, LIGHT_GREY, seat, thick=0.03, inset=0.02, round_=True)
    yield box("seat", WHITE, (0.9 * p.x[0], 0.9 * p.x[1]), (0.9 * p.y[0], 0.9 * p.y[1]), (seat, seat + 0.04))
    yield oval(
        "opening", DARK, (0.06 * p.d, 0.0), ((0.24 * p.d, 0.22 * p.w),) * 2, (seat + 0.04, seat + 0.043), sides=20
    )
    yield soft("back", p.fabric, (p.x[0], p.x[0] + 0.06), (0.8 * p.y[0], 0.8 * p.y[1]), (seat + 0.1, p.h), bevel=0.02)
    for y0 in (p.y[0], p.y[1] - 0.05):
        yield soft("arm", DARK, (0.8 * p.x[0], 0.6 * p.x[1]), (y0, y0 + 0.05), (0.7 * p.h, 0.74 * p.h), bevel=0.01)
        for x in (-0.36 * p.d, 0.22 * p.d):
            yield box("arm post", LIGHT_GREY, (x, x + 0.025), (y0 + 0.012, y0 + 0.038), (seat - 0.01, 0.7 * p.h))


def couch(p: Piece) -> Iterator[Part]:
    """Yield an examination couch, a massage table or a stretcher with a raised head."""
    low, top = 0.72 * p.h, 0.86 * p.h
    if p.kind == "stretcher":
        yield from castors(p, 0.08, inset=0.05)
        yield box("chassis", LIGHT_GREY, (0.8 * p.x[0], 0.8 * p.x[1]), (0.8 * p.y[0], 0.8 * p.y[1]), (0.13, 0.2))
        for x in (-0.3 * p.d, 0.3 * p.d):
            yield box("column", STEEL, (x - 0.05, x + 0.05), (-0.08, 0.08), (0.2, low))
    else:
        yield from four(p, p.wood, low, thick=0.06, inset=0.06)
        yield box(
            "shelf", p.wood, (0.84 * p.x[0], 0.84 * p.x[1]), (0.78 * p.y[0], 0.78 * p.y[1]), (0.2 * p.h, 0.23 * p.h)
        )
    yield box("frame", LIGHT_GREY, (0.98 * p.x[0], 0.98 * p.x[1]), (0.96 * p.y[0], 0.96 * p.y[1]), (low, low + 0.03))
    knee = -0.2 * p.d
    yield soft("pad", p.fabric, (knee, p.x[1]), p.y, (low + 0.03, top), bevel=0.03)
    head = soft("pad", p.fabric, (p.x[0], knee - 0.004), p.y, (low + 0.03, top), bevel=0.03)
    head.vertices[:, 2] += (knee - head.vertices[:, 0]) * 0.2
    yield head
    yield box("paper", WHITE, (knee, 0.98 * p.x[1]), (0.7 * p.y[0], 0.7 * p.y[1]), (top, top + 0.003))


def treatment_chair(p: Piece) -> Iterator[Part]:
    """Yield a dentist's chair: base, seat, leaning back, lamp on an arm."""
    yield oval("foot", LIGHT_GREY, (0.0, 0.0), ((0.24 * p.d, 0.44 * p.w),) * 2, (0.0, 0.05), sides=20)
    yield box("column", LIGHT_GREY, (-0.12, 0.12), (-0.12, 0.12), (0.05, 0.34 * p.h))
    yield soft(
        "seat", p.fabric, (-0.16 * p.d, 0.26 * p.d), (-0.36 * p.w, 0.36 * p.w), (0.34 * p.h, 0.44 * p.h), bevel=0.04
    )
    legs = soft(
        "leg rest", p.fabric, (0.24 * p.d, p.x[1]), (-0.3 * p.w, 0.3 * p.w), (0.34 * p.h, 0.42 * p.h), bevel=0.03
    )
    legs.vertices[:, 2] -= (legs.vertices[:, 0] - 0.24 * p.d) * 0.25
    yield legs
    back = soft(
        "back", p.fabric, (-0.46 * p.d, -0.14 * p.d), (-0.34 * p.w, 0.34 * p.w), (0.36 * p.h, 0.45 * p.h), bevel=0.04
    )
    back.vertices[:, 2] += (-0.14 * p.d - back.vertices[:, 0]) * 0.7
    yield back
    for y in (-0.42 * p.w, 0.42 * p.w):
        yield soft(
            "arm", LIGHT_GREY, (-0.14 * p.d, 0.12 * p.d), (y - 0.04, y + 0.04), (0.54 * p.h, 0.58 * p.h), bevel=0.012
        )
        yield box("arm post", LIGHT_GREY, (-0.04, 0.02), (y - 0.02, y + 0.02), (0.38 * p.h, 0.54 * p.h))
    yield cylinder("lamp pole", STEEL, (-0.1 * p.d, p.y[1] - 0.03), 0.02, (0.05, 0.97 * p.h), sides=8)
    yield box("lamp arm", STEEL, (-0.11 * p.d, -0.09 * p.d), (0.0, p.y[1] - 0.02), (0.95 * p.h, 0.98 * p.h))
    yield cylinder("lamp", WHITE, (-0.1 * p.d, 0.0), (0.1, 0.05), (0.9 * p.h, p.h), sides=14)


def medical_cart(p: Piece) -> Iterator[Part]:
    """Yield a trolley with drawers, a side rail and castors."""
    yield from castors(p, 0.05)
    top = p.h
    yield carcass(p, WHITE, (0.11, top - 0.021), y=(p.y[0] + 0.02, p.y[1] - 0.02))
    yield from drawers(p, p.accent, (p.y[0] + 0.02, p.y[1] - 0.02), (0.12, top - 0.021), rows=5)
    yield box("top", LIGHT_GREY, p.x, p.y, (top - 0.02, top))
    yield cylinder(
        "push bar", STEEL, (0.86 * p.h, p.x[1] - 0.02), 0.014, (p.y[1] - 0.02, p.y[1] + 0.05), axis="y", sides=8
    )
    yield box(
        "push bar", STEEL, (0.7 * p.x[0], p.x[1] - 0.004), (p.y[1] + 0.05, p.y[1] + 0.075), (0.84 * p.h, 0.88 * p.h)
    )
    for x in (0.66 * p.x[0], 0.6 * p.x[1]):
        yield box("bracket", STEEL, (x, x + 0.02), (p.y[1] - 0.02, p.y[1] + 0.05), (0.85 * p.h, 0.87 * p.h))


def gas_bottle(p: Piece) -> Iterator[Part]:
    """Yield a gas cylinder with a valve."""
    r = min(p.d, p.w) / 2
    yield cylinder("body", p.accent, (0.0, 0.0), r, (0.0, 0.78 * p.h), sides=18)
    yield cylinder("shoulder", WHITE, (0.0, 0.0), (r, 0.34 * r), (0.78 * p.h, 0.9 * p.h), sides=18)
    yield cylinder("valve", STEEL, (0.0, 0.0), 0.2 * r, (0.9 * p.h, 0.97 * p.h), sides=8)
    yield box("wheel", DARK, (-0.4 * r, 0.4 * r), (-0.4 * r, 0.4 * r), (0.97 * p.h, p.h))


def column_scale(p: Piece) -> Iterator[Part]:
    """Yield scales with a column and a display."""
    yield soft("plate", LIGHT_GREY, p.x, p.y, (0.0, 0.06), bevel=0.012)
    yield box("mat", RUBBER, (0.8 * p.x[0], 0.86 * p.x[1]), (0.84 * p.y[0], 0.84 * p.y[1]), (0.06, 0.066))
    yield box("column", WHITE, (p.x[0], p.x[0] + 0.05), (-0.04, 0.04), (0.05, 0.94 * p.h))
    yield soft("head", WHITE, (p.x[0] + 0.002, p.x[0] + 0.1), (-0.16, 0.16), (0.9 * p.h, p.h), bevel=0.015)
    yield box("display", GLOW, (p.x[0] + 0.1, p.x[0] + 0.104), (-0.12, 0.12), (0.93 * p.h, 0.985 * p.h))


def first_aid(p: Piece) -> Iterator[Part]:
    """Yield a case with a cross."""
    yield soft("case", RED, (p.x[0], p.x[1] - 0.008), p.y, (0.0, 0.9 * p.h), bevel=0.02)
    half, arm = 0.06 * p.w, 0.2 * p.w
    face = (p.x[1] - 0.008, p.x[1])
    yield box("cross", WHITE, face, (-arm, arm), (0.45 * p.h - half, 0.45 * p.h + half))
    for z in ((0.45 * p.h - arm, 0.45 * p.h - half), (0.45 * p.h + half, 0.45 * p.h + arm)):
        yield box("cross", WHITE, face, (-half, half), z)
    yield box("handle", WHITE, (-0.1 * p.d, 0.1 * p.d), (-0.14 * p.w, 0.14 * p.w), (0.9 * p.h, p.h))


def caddy(p: Piece) -> Iterator[Part]:
    """Yield a hanging pocket with a book and a bottle."""
    yield box("back", p.fabric, (p.x[0], p.x[0] + 0.08 * p.d), p.y, (0.0, 0.8 * p.h))
    yield box("pocket", p.accent, (p.x[0] + 0.3 * p.d, p.x[1]), p.y, (0.0, 0.6 * p.h))
    yield box(
        "book", BRIGHT[p.variant % 6], (p.x[0] + 0.09 * p.d, p.x[0] + 0.28 * p.d), (0.7 * p.y[0], 0.0), (0.02, p.h)
    )
    yield cylinder("bottle", CERAMIC, (p.x[0] + 0.18 * p.d, 0.25 * p.w), 0.08 * p.d, (0.02, 0.9 * p.h), sides=8)


BUILDERS: dict[str, Builder] = {
    "hospital bed": hospital_bed,
    "overbed table": overbed_table,
    "wheelchair": wheelchair,
    "walker": walker,
    "iv stand": iv_stand,
    "patient lift": patient_lift,
    "commode chair": commode_chair,
    "examination table": couch,
    "stretcher": couch,
    "dentist chair": treatment_chair,
    "medical cart": medical_cart,
    "oxygen cylinder": gas_bottle,
    "physician scale": column_scale,
    "weighing platform": column_scale,
    "first aid kit": first_aid,
    "bedside caddy": caddy,
}
