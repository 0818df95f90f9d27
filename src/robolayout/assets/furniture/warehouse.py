"""Warehouses: pallets, racks, carts and machines."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, four
from robolayout.assets.furniture.care import castors
from robolayout.assets.palette import (
    BLACK,
    BLUE,
    CARDBOARD,
    DARK,
    GLOW,
    GREEN,
    GREY,
    IRON,
    LIGHT_GREY,
    ORANGE,
    PINE,
    RED,
    RUBBER,
    STEEL,
    WHITE,
    YELLOW,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, sheared, slab, soft

Span = tuple[float, float]


def pallet_at(x: Span, y: Span, low: float, tall: float = 0.144) -> Iterator[Part]:
    """Yield a wooden pallet over two ranges."""
    t = 0.15 * tall
    for i in range(3):
        a = x[0] + i * (x[1] - x[0] - 0.1) / 2
        yield box("runner", PINE, (a, a + 0.1), y, (low, low + tall - 2 * t))
    yield box("cross", PINE, x, (y[0] + 0.002, y[1] - 0.002), (low + tall - 2 * t, low + tall - t))
    for i in range(5):
        b = y[0] + i * (y[1] - y[0]) / 5 + 0.006
        yield box("deck", PINE, (x[0], x[1]), (b, b + (y[1] - y[0]) / 5 - 0.012), (low + tall - t, low + tall))


def stack(p: Piece, x: Span, y: Span, z: Span, salt: int) -> Iterator[Part]:
    """Yield cartons stacked in two or three layers."""
    rng = p.rng()
    rng.seed(f"{p.key}/{salt}")
    layers, columns, rows = (
        max(1, round((z[1] - z[0]) / 0.38)),
        max(1, round((y[1] - y[0]) / 0.5)),
        max(1, round((x[1] - x[0]) / 0.5)),
    )
    for k in range(layers):
        for i in range(rows):
            for j in range(columns):
                if k == layers - 1 and layers > 1 and rng.random() < 0.25:
                    continue
                a = (x[0] + i * (x[1] - x[0]) / rows + 0.004, x[0] + (i + 1) * (x[1] - x[0]) / rows - 0.004)
                b = (y[0] + j * (y[1] - y[0]) / columns + 0.004, y[0] + (j + 1) * (y[1] - y[0]) / columns - 0.004)
                c = (z[0] + k * (z[1] - z[0]) / layers, z[0] + (k + 1) * (z[1] - z[0]) / layers - 0.003)
                yield box("carton", CARDBOARD if rng.random() < 0.75 else PINE, a, b, c)


def pallet(p: Piece) -> Iterator[Part]:
    """Yield an empty pallet."""
    yield from pallet_at(p.x, p.y, 0.0, p.h)


def loaded_pallet(p: Piece) -> Iterator[Part]:
    """Yield a pallet with cartons and a strap."""
    yield from pallet_at(p.x, p.y, 0.0)
    yield from stack(p, (0.98 * p.x[0], 0.98 * p.x[1]), (0.98 * p.y[0], 0.98 * p.y[1]), (0.145, p.h), 0)
    for y in (-0.2 * p.w, 0.2 * p.w):
        yield box("strap", BLUE, (p.x[1] - 0.001, p.x[1] + 0.002), (y - 0.01, y + 0.01), (0.145, 0.6 * p.h))


def pallet_rack(p: Piece) -> Iterator[Part]:
    """Yield a bay of pallet racking with loads on every level."""
    t = 0.08
    for x in (p.x[0], p.x[1] - t):
        for y in (p.y[0], p.y[1] - t):
            yield box("upright", BLUE, (x, x + t), (y, y + t), (0.0, p.h))
    for y in (p.y[0], p.y[1] - t):
        for i in range(n := max(2, round(p.h / 0.9))):
            z = (i + 0.3) * p.h / n
            yield box("brace", BLUE, (p.x[0] + t, p.x[1] - t), (y + 0.02, y + t - 0.02), (z, z + 0.03))
    levels = max(2, round(p.h / 1.4))
    bays = max(1, round(p.w / 1.3))
    for i in range(levels):
        low = i * p.h / levels + (0.02 if i == 0 else 0.0)
        if i:
            for x in (p.x[0] + 0.004, p.x[1] - t + 0.004):
                yield box("beam", ORANGE, (x, x + t - 0.008), (p.y[0] + t, p.y[1] - t), (low - 0.1, low))
        room = p.h / levels - 0.2
        for j in range(bays):
            inner = (p.y[0] + t + j * (p.w - 2 * t) / bays + 0.06, p.y[0] + t + (j + 1) * (p.w - 2 * t) / bays - 0.06)
            x = (0.92 * p.x[0], 0.92 * p.x[1])
            yield from pallet_at(x, inner, low)
            yield from stack(
                p,
                (0.9 * p.x[0], 0.9 * p.x[1]),
                (inner[0] + 0.02, inner[1] - 0.02),
                (low + 0.145, low + 0.145 + (0.6 + 0.2 * ((i + j) % 2)) * (room - 0.145)),
                10 * i + j,
            )


def cardboard_box(p: Piece) -> Iterator[Part]:
    """Yield a closed carton with tape and a label."""
    yield box("carton", CARDBOARD, (p.x[0], p.x[1] - 0.002), p.y, (0.0, p.h - 0.002))
    yield box("tape", PINE, (0.97 * p.x[0], 0.97 * p.x[1]), (-0.03 * p.w - 0.01, 0.03 * p.w + 0.01), (p.h - 0.002, p.h))
    yield box("label", WHITE, (p.x[1] - 0.002, p.x[1]), (0.1 * p.w, 0.36 * p.w), (0.5 * p.h, 0.8 * p.h))


def crate(p: Piece) -> Iterator[Part]:
    """Yield a wooden crate of slats with corner posts."""
    t = min(0.03, 0.08 * min(p.d, p.w))
    yield box("inside", p.dark, (p.x[0] + t, p.x[1] - t), (p.y[0] + t, p.y[1] - t), (0.01, 0.9 * p.h))
    rows = max(2, min(5, round(p.h / 0.14)))
    for i in range(rows):
        z = (i * p.h / rows, (i + 0.86) * p.h / rows if i < rows - 1 else p.h)
        for x0 in (p.x[0], p.x[1] - t):
            yield box("slat", PINE, (x0, x0 + t), p.y, z)
        for y0 in (p.y[0], p.y[1] - t):
            yield box("slat", PINE, (p.x[0] + t, p.x[1] - t), (y0, y0 + t), z)


def storage_bin(p: Piece) -> Iterator[Part]:
    """Yield a plastic container with a rim and grips."""
    tone = (BLUE, GREY, GREEN, RED)[p.variant % 4]
    yield slab(
        "bin", tone, (0.9 * p.x[0], 0.9 * p.x[1]), (0.93 * p.y[0], 0.93 * p.y[1]), (0.0, 0.88 * p.h), top=(1.05, 1.03)
    )
    yield box("rim", tone, p.x, p.y, (0.88 * p.h, 0.96 * p.h))
    yield box("content", DARK, (0.86 * p.x[0], 0.86 * p.x[1]), (0.9 * p.y[0], 0.9 * p.y[1]), (0.96 * p.h, p.h))


def barrel(p: Piece) -> Iterator[Part]:
    """Yield a barrel: wooden with hoops, or a steel drum."""
    r = min(p.d, p.w) / 2
    wood = p.variant % 2
    tone, ring = (p.wood, IRON) if wood else (BLUE, DARK)
    yield cylinder("staves", tone, (0.0, 0.0), (0.82 * r if wood else 0.96 * r, 0.97 * r), (0.0, 0.5 * p.h), sides=20)
    yield cylinder(
        "staves", tone, (0.0, 0.0), (0.97 * r, 0.82 * r if wood else 0.96 * r), (0.5 * p.h, 0.97 * p.h), sides=20
    )
    for z, share in ((0.3, 0.94), (0.66, 0.95)):
        yield cylinder("hoop", ring, (0.0, 0.0), (share + 0.05) * r, (z * p.h, (z + 0.04) * p.h), sides=20)
    yield cylinder("lid", p.dark if wood else DARK, (0.0, 0.0), 0.76 * r, (0.97 * p.h, p.h), sides=20)


def hand_truck(p: Piece) -> Iterator[Part]:
    """Yield a sack truck with a toe plate."""
    r = 0.1 * p.h
    for side in (-1, 1):
        yield cylinder(
            "wheel",
            RUBBER,
            (r, p.x[0] + r),
            r,
            (side * 0.42 * p.w - 0.03, side * 0.42 * p.w + 0.03),
            axis="y",
            sides=16,
        )
        y = side * 0.28 * p.w
        yield sheared("rail", RED, (-0.02, 0.02), (y - 0.016, y + 0.016), (0.02, p.h - 0.03), lean=(-0.24 * p.d, 0.0))
    for i in range(4):
        z = (0.25 + 0.18 * i) * p.h
        x = -0.24 * p.d * z / p.h
        yield box("rung", RED, (x - 0.014, x + 0.014), (-0.25 * p.w, 0.25 * p.w), (z, z + 0.03))
    yield box("toe plate", STEEL, (0.0, p.x[1]), (-0.44 * p.w, 0.44 * p.w), (0.0, 0.02))
    yield box("handle", BLACK, (-0.3 * p.d, -0.18 * p.d), (-0.4 * p.w, 0.4 * p.w), (p.h - 0.04, p.h))
    yield box(
        "axle",
        STEEL,
        (p.x[0] + r - 0.012, p.x[0] + r + 0.012),
        (-0.42 * p.w + 0.03, 0.42 * p.w - 0.03),
        (r - 0.012, r + 0.012),
    )


def platform_cart(p: Piece) -> Iterator[Part]:
    """Yield a flat cart with cartons; it is pushed at its left end."""
    yield from castors(p, 0.07, inset=0.05)
    yield box("deck", p.wood, p.x, p.y, (0.15, 0.2))
    for x in (0.86 * p.x[0], 0.8 * p.x[1]):
        yield box("post", STEEL, (x, x + 0.03), (p.y[0] + 0.02, p.y[0] + 0.05), (0.2, p.h - 0.03))
    yield box("handle", STEEL, (0.9 * p.x[0], 0.9 * p.x[1]), (p.y[0] + 0.019, p.y[0] + 0.051), (p.h - 0.03, p.h))
    yield from stack(p, (0.8 * p.x[0], 0.8 * p.x[1]), (-0.3 * p.w, 0.44 * p.w), (0.2, 0.62 * p.h), 3)


def pallet_jack(p: Piece) -> Iterator[Part]:
    """Yield a pallet truck; its forks point to +x."""
    for y in (-0.3 * p.w, 0.3 * p.w):
        yield box("fork", YELLOW, (-0.22 * p.d, p.x[1]), (y - 0.08, y + 0.08), (0.06, 0.11))
        yield cylinder("roller", RUBBER, (0.04, p.x[1] - 0.12), 0.04, (y - 0.05, y + 0.05), axis="y", sides=12)
    yield box("body", YELLOW, (-0.34 * p.d, -0.22 * p.d - 0.001), p.y, (0.06, 0.34 * p.h))
    yield cylinder("wheel", RUBBER, (0.1, -0.4 * p.d), 0.1, (-0.06, 0.06), axis="y", sides=16)
    yield cylinder("pump", DARK, (-0.38 * p.d, 0.0), 0.07, (0.2, 0.4 * p.h), sides=12)
    yield sheared(
        "tiller", YELLOW, (-0.39 * p.d, -0.36 * p.d), (-0.025, 0.025), (0.4 * p.h, 0.92 * p.h), lean=(-0.09 * p.d, 0.0)
    )
    yield box("grip", BLACK, (p.x[0], -0.42 * p.d), (-0.3 * p.w, 0.3 * p.w), (0.92 * p.h, p.h))


def forklift(p: Piece) -> Iterator[Part]:
    """Yield a forklift truck; its forks point to +x."""
    for x in (-0.32 * p.d, 0.14 * p.d):
        for side in (-1, 1):
            yield cylinder(
                "wheel",
                RUBBER,
                (0.22, x),
                0.22,
                (side * 0.42 * p.w - 0.08, side * 0.42 * p.w + 0.08),
                axis="y",
                sides=18,
            )
    yield soft(
        "counterweight", YELLOW, (p.x[0], -0.2 * p.d), (0.84 * p.y[0], 0.84 * p.y[1]), (0.14, 0.5 * p.h), bevel=0.06
    )
    yield box("chassis", DARK, (-0.2 * p.d, 0.2 * p.d), (0.7 * p.y[0], 0.7 * p.y[1]), (0.14, 0.3 * p.h))
    yield soft("seat", BLACK, (-0.18 * p.d, 0.0), (-0.25, 0.25), (0.5 * p.h, 0.56 * p.h), bevel=0.03)
    yield box("seat box", YELLOW, (-0.19 * p.d, 0.0), (0.6 * p.y[0], 0.6 * p.y[1]), (0.3 * p.h, 0.5 * p.h))
    for x, lean in ((-0.22 * p.d, 0.04), (0.14 * p.d, -0.03)):
        for y in (-0.36 * p.w, 0.36 * p.w):
            yield sheared(
                "guard post",
                DARK,
                (x, x + 0.05),
                (y - 0.025, y + 0.025),
                (0.3 * p.h, 0.97 * p.h),
                lean=(lean * p.d, 0.0),
            )
    yield box("roof", DARK, (-0.2 * p.d, 0.15 * p.d), (-0.4 * p.w, 0.4 * p.w), (0.97 * p.h, p.h))
    for y in (-0.28 * p.w, 0.28 * p.w):
        yield box("mast", GREY, (0.2 * p.d + 0.001, 0.24 * p.d), (y - 0.04, y + 0.04), (0.06, 0.98 * p.h))
        yield box("fork", STEEL, (0.24 * p.d + 0.03, p.x[1]), (y - 0.06, y + 0.06), (0.0, 0.05))
    yield box("carriage", GREY, (0.24 * p.d, 0.24 * p.d + 0.03), (-0.42 * p.w, 0.42 * p.w), (0.02, 0.24 * p.h))
    yield sheared(
        "wheel post", BLACK, (0.1 * p.d, 0.12 * p.d), (-0.02, 0.02), (0.3 * p.h, 0.56 * p.h), lean=(-0.04 * p.d, 0.0)
    )
    yield cylinder("steering wheel", BLACK, (0.07 * p.d, 0.0), 0.16, (0.56 * p.h, 0.575 * p.h), sides=16)


def conveyor(p: Piece) -> Iterator[Part]:
    """Yield a belt on legs with parcels; it runs along its width."""
    top = p.h - 0.22 if p.h > 0.6 else 0.7 * p.h
    for x0 in (p.x[0], p.x[1] - 0.05):
        yield box("rail", YELLOW, (x0, x0 + 0.05), p.y, (top - 0.12, top + 0.03))
    yield box("belt", BLACK, (p.x[0] + 0.05, p.x[1] - 0.05), p.y, (top - 0.06, top))
    for i in range(n := max(2, round(p.w / 1.2))):
        y = p.y[0] + 0.1 + i * (p.w - 0.2) / (n - 1)
        for x in (0.84 * p.x[0], 0.72 * p.x[1]):
            yield box("leg", GREY, (x, x + 0.05), (y - 0.03, y + 0.03), (0.0, top - 0.06))
    for i in range(3):
        y = (-0.32 + 0.3 * i) * p.w
        tall = (0.22, 0.14, 0.18)[i] if top < p.h - 0.2 else 0.2 * p.h
        yield box("parcel", CARDBOARD, (-0.22 * p.d, 0.22 * p.d), (y - 0.16, y + 0.16), (top, top + tall))


def packing_table(p: Piece) -> Iterator[Part]:
    """Yield a work table with a shelf, cartons and a roll of paper above it."""
    top = min(0.92, 0.62 * p.h) if p.h > 1.15 else p.h
    yield box("top", p.wood, p.x, p.y, (top - 0.04, top))
    yield from four(p, GREY, top - 0.04, thick=0.06, inset=0.01)
    if top == p.h:
        return
    for y in (p.y[0], p.y[1] - 0.05):
        yield box("post", GREY, (p.x[0], p.x[0] + 0.05), (y, y + 0.05), (top, p.h))
    inner = (p.y[0] + 0.05, p.y[1] - 0.05)
    yield box("shelf", p.wood, (p.x[0] + 0.001, p.x[0] + 0.4 * p.d), inner, (p.h - 0.24, p.h - 0.21))
    yield from stack(p, (p.x[0] + 0.02, p.x[0] + 0.36 * p.d), (inner[0] + 0.05, 0.1 * p.w), (p.h - 0.21, p.h - 0.02), 1)
    yield cylinder("paper roll", PINE, (top + 0.2, p.x[0] + 0.14), 0.08, (-0.3 * p.w, 0.24 * p.w), axis="y", sides=14)
    yield box("carton", CARDBOARD, (-0.06 * p.d, 0.3 * p.d), (-0.12 * p.w, 0.1 * p.w), (top, top + 0.18))
    yield box("scale", LIGHT_GREY, (-0.1 * p.d, 0.26 * p.d), (0.2 * p.w, 0.36 * p.w), (top, top + 0.06))


def roll_cage(p: Piece) -> Iterator[Part]:
    """Yield a wire trolley with parcels."""
    yield from castors(p, 0.06)
    yield box("deck", GREY, p.x, p.y, (0.13, 0.17))
    for i in range(7):
        y = p.y[0] + i * (p.w - 0.016) / 6
        yield box("wire", STEEL, (p.x[0], p.x[0] + 0.016), (y, y + 0.016), (0.17, p.h - 0.03))
    for y0 in (p.y[0], p.y[1] - 0.016):
        for i in range(1, 6):
            x = p.x[0] + i * (p.d - 0.016) / 5
            yield box("wire", STEEL, (x, x + 0.016), (y0, y0 + 0.016), (0.17, p.h - 0.03))
        for z in (0.4 * p.h, 0.7 * p.h, p.h - 0.03):
            yield box(
                "bar",
                STEEL,
                (p.x[0] + 0.016, p.x[1] - 0.016 if z < 0.9 * p.h else p.x[1]),
                (y0 + 0.002, y0 + 0.014),
                (z, z + 0.03 if z > 0.9 * p.h else z + 0.016),
            )
    yield box("bar", STEEL, (p.x[0] + 0.001, p.x[0] + 0.015), (p.y[0] + 0.016, p.y[1] - 0.016), (p.h - 0.03, p.h))
    yield from stack(p, (0.86 * p.x[0], 0.86 * p.x[1]), (0.88 * p.y[0], 0.88 * p.y[1]), (0.17, 0.72 * p.h), 2)


def ladder(p: Piece) -> Iterator[Part]:
    """Yield a step ladder; its steps face +x."""
    for side in (-1, 1):
        y = side * (p.w / 2 - 0.02)
        yield sheared(
            "rail",
            STEEL,
            (p.x[1] - 0.05, p.x[1]),
            (y - 0.018, y + 0.018),
            (0.0, p.h - 0.05),
            lean=(-0.52 * p.d, -side * 0.12 * p.w),
        )
        yield sheared(
            "rear leg",
            STEEL,
            (p.x[0], p.x[0] + 0.03),
            (y - 0.016, y + 0.016),
            (0.0, p.h - 0.06),
            lean=(0.32 * p.d, -side * 0.12 * p.w),
        )
    count = max(2, round(p.h / 0.26)) - 1
    for i in range(count):
        z = (i + 1) * (p.h - 0.04) / (count + 1)
        x = p.x[1] - 0.03 - 0.52 * p.d * z / p.h
        half = (0.46 - 0.12 * z / p.h) * p.w
        yield box("step", p.accent, (x - 0.06, x + 0.03), (-half, half), (z - 0.015, z + 0.012))
    yield box("platform", DARK, (-0.2 * p.d, 0.02 * p.d), (-0.38 * p.w, 0.38 * p.w), (p.h - 0.05, p.h))


def step_stool(p: Piece) -> Iterator[Part]:
    """Yield two steps."""
    for y0 in (p.y[0], p.y[1] - 0.025):
        yield box("side", p.wood, (p.x[0], 0.0), (y0, y0 + 0.025), (0.0, p.h - 0.02))
        yield box("side", p.wood, (0.0, p.x[1]), (y0, y0 + 0.025), (0.0, 0.5 * p.h - 0.02))
    yield box("step", p.accent, (p.x[0], 0.0), p.y, (p.h - 0.02, p.h))
    yield box("step", p.accent, (0.001, p.x[1]), p.y, (0.5 * p.h - 0.02, 0.5 * p.h))


def cabinet_machine(p: Piece) -> Iterator[Part]:
    """Yield a steel cabinet with a panel, lights and vents: chargers, controls, unknown machines."""
    yield box("plinth", DARK, (p.x[0], p.x[1] - 0.03), (0.94 * p.y[0], 0.94 * p.y[1]), (0.0, 0.06))
    yield soft("body", LIGHT_GREY, (p.x[0], p.x[1] - 0.02), p.y, (0.06, p.h), bevel=0.015)
    face = (p.x[1] - 0.02, p.x[1] - 0.012)
    yield box("door", p.accent, face, (0.88 * p.y[0], 0.88 * p.y[1]), (0.12, 0.6 * p.h))
    yield box("panel", DARK, face, (0.7 * p.y[0], 0.7 * p.y[1]), (0.68 * p.h, 0.92 * p.h))
    yield box("screen", GLOW, (p.x[1] - 0.012, p.x[1] - 0.008), (0.6 * p.y[0], 0.1 * p.y[1]), (0.74 * p.h, 0.88 * p.h))
    for i, tone in enumerate((GREEN, YELLOW, RED)):
        yield cylinder(
            "button",
            tone,
            (0.48 * p.y[1], (0.73 + 0.07 * i) * p.h),
            min(0.02, 0.08 * p.w),
            (p.x[1] - 0.012, p.x[1]),
            axis="x",
            sides=10,
        )


def fire_extinguisher(p: Piece) -> Iterator[Part]:
    """Yield a red extinguisher with a hose."""
    r = 0.42 * min(p.d, p.w)
    yield cylinder("body", RED, (0.0, 0.0), r, (0.0, 0.7 * p.h), sides=18)
    yield cylinder("shoulder", RED, (0.0, 0.0), (r, 0.3 * r), (0.7 * p.h, 0.82 * p.h), sides=18)
    yield cylinder("label", WHITE, (0.0, 0.0), r + 0.002, (0.3 * p.h, 0.5 * p.h), sides=18)
    yield box("valve", BLACK, (-0.2 * r, 0.2 * r), (-0.2 * r, 0.2 * r), (0.82 * p.h, 0.92 * p.h))
    yield box("lever", BLACK, (-0.16 * p.d, p.x[1]), (-0.02, 0.02), (0.92 * p.h, p.h))
    yield box("hose", BLACK, (-0.015, 0.015), (r + 0.002, p.y[1]), (0.2 * p.h, 0.86 * p.h))
    yield box("hose", BLACK, (-0.014, 0.014), (0.2 * r, r + 0.002), (0.83 * p.h, 0.86 * p.h))
    yield box("bracket", DARK, (p.x[0] - 0.004, -0.9 * r), (-0.06, 0.06), (0.26 * p.h, 0.6 * p.h))


def bollard(p: Piece) -> Iterator[Part]:
    """Yield a striped post on a plate."""
    r = 0.36 * min(p.d, p.w)
    yield box("plate", DARK, p.x, p.y, (0.0, 0.015))
    for i in range(5):
        yield cylinder(
            "stripe",
            (YELLOW, BLACK)[i % 2],
            (0.0, 0.0),
            r,
            (0.015 + i * (p.h - 0.04) / 5, 0.015 + (i + 1) * (p.h - 0.04) / 5),
            sides=14,
        )
    yield cylinder("cap", BLACK, (0.0, 0.0), (r, 0.6 * r), (p.h - 0.025, p.h), sides=14)


BUILDERS: dict[str, Builder] = {
    "pallet": pallet,
    "loaded pallet": loaded_pallet,
    "pallet rack": pallet_rack,
    "cardboard box": cardboard_box,
    "crate": crate,
    "storage bin": storage_bin,
    "barrel": barrel,
    "hand truck": hand_truck,
    "platform cart": platform_cart,
    "pallet jack": pallet_jack,
    "forklift": forklift,
    "conveyor belt": conveyor,
    "packing table": packing_table,
    "roll cage": roll_cage,
    "ladder": ladder,
    "step stool": step_stool,
    "charging station": cabinet_machine,
    "strapping machine": cabinet_machine,
    "fire extinguisher": fire_extinguisher,
    "safety bollard": bollard,
}
