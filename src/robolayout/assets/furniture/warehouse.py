"""Warehouses, workshops, garages, and fixed parts of a building."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, carcass, drawers, four
from robolayout.assets.furniture.care import castors, wheel
from robolayout.assets.palette import (
    BLACK, BLUE, BRIGHT, CARDBOARD, CONCRETE, DARK, GLASS, GLOW, GREEN, GREY, IRON, LIGHT_GREY, MIRROR, ORANGE, PINE, RED, RUBBER, STEEL, WHITE, YELLOW, Piece,
)  # fmt: skip
from robolayout.assets.part import Material, Part
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
    layers, columns, rows = max(1, round((z[1] - z[0]) / 0.38)), max(1, round((y[1] - y[0]) / 0.5)), max(1, round((x[1] - x[0]) / 0.5))
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
            yield from stack(p, (0.9 * p.x[0], 0.9 * p.x[1]), (inner[0] + 0.02, inner[1] - 0.02), (low + 0.145, low + 0.145 + (0.6 + 0.2 * ((i + j) % 2)) * (room - 0.145)), 10 * i + j)


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
    yield slab("bin", tone, (0.9 * p.x[0], 0.9 * p.x[1]), (0.93 * p.y[0], 0.93 * p.y[1]), (0.0, 0.88 * p.h), top=(1.05, 1.03))
    yield box("rim", tone, p.x, p.y, (0.88 * p.h, 0.96 * p.h))
    yield box("content", DARK, (0.86 * p.x[0], 0.86 * p.x[1]), (0.9 * p.y[0], 0.9 * p.y[1]), (0.96 * p.h, p.h))


def barrel(p: Piece) -> Iterator[Part]:
    """Yield a barrel: wooden with hoops, or a steel drum."""
    r = min(p.d, p.w) / 2
    wood = p.variant % 2
    tone, ring = (p.wood, IRON) if wood else (BLUE, DARK)
    yield cylinder("staves", tone, (0.0, 0.0), (0.82 * r if wood else 0.96 * r, 0.97 * r), (0.0, 0.5 * p.h), sides=20)
    yield cylinder("staves", tone, (0.0, 0.0), (0.97 * r, 0.82 * r if wood else 0.96 * r), (0.5 * p.h, 0.97 * p.h), sides=20)
    for z, share in ((0.3, 0.94), (0.66, 0.95)):
        yield cylinder("hoop", ring, (0.0, 0.0), (share + 0.05) * r, (z * p.h, (z + 0.04) * p.h), sides=20)
    yield cylinder("lid", p.dark if wood else DARK, (0.0, 0.0), 0.76 * r, (0.97 * p.h, p.h), sides=20)


def hand_truck(p: Piece) -> Iterator[Part]:
    """Yield a sack truck with a toe plate."""
    r = 0.1 * p.h
    for side in (-1, 1):
        yield cylinder("wheel", RUBBER, (r, p.x[0] + r), r, (side * 0.42 * p.w - 0.03, side * 0.42 * p.w + 0.03), axis="y", sides=16)
        y = side * 0.28 * p.w
        yield sheared("rail", RED, (-0.02, 0.02), (y - 0.016, y + 0.016), (0.02, p.h - 0.03), lean=(-0.24 * p.d, 0.0))
    for i in range(4):
        z = (0.25 + 0.18 * i) * p.h
        x = -0.24 * p.d * z / p.h
        yield box("rung", RED, (x - 0.014, x + 0.014), (-0.25 * p.w, 0.25 * p.w), (z, z + 0.03))
    yield box("toe plate", STEEL, (0.0, p.x[1]), (-0.44 * p.w, 0.44 * p.w), (0.0, 0.02))
    yield box("handle", BLACK, (-0.3 * p.d, -0.18 * p.d), (-0.4 * p.w, 0.4 * p.w), (p.h - 0.04, p.h))
    yield box("axle", STEEL, (p.x[0] + r - 0.012, p.x[0] + r + 0.012), (-0.42 * p.w + 0.03, 0.42 * p.w - 0.03), (r - 0.012, r + 0.012))


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
    yield sheared("tiller", YELLOW, (-0.39 * p.d, -0.36 * p.d), (-0.025, 0.025), (0.4 * p.h, 0.92 * p.h), lean=(-0.09 * p.d, 0.0))
    yield box("grip", BLACK, (p.x[0], -0.42 * p.d), (-0.3 * p.w, 0.3 * p.w), (0.92 * p.h, p.h))


def forklift(p: Piece) -> Iterator[Part]:
    """Yield a forklift truck; its forks point to +x."""
    for x in (-0.32 * p.d, 0.14 * p.d):
        for side in (-1, 1):
            yield cylinder("wheel", RUBBER, (0.22, x), 0.22, (side * 0.42 * p.w - 0.08, side * 0.42 * p.w + 0.08), axis="y", sides=18)
    yield soft("counterweight", YELLOW, (p.x[0], -0.2 * p.d), (0.84 * p.y[0], 0.84 * p.y[1]), (0.14, 0.5 * p.h), bevel=0.06)
    yield box("chassis", DARK, (-0.2 * p.d, 0.2 * p.d), (0.7 * p.y[0], 0.7 * p.y[1]), (0.14, 0.3 * p.h))
    yield soft("seat", BLACK, (-0.18 * p.d, 0.0), (-0.25, 0.25), (0.5 * p.h, 0.56 * p.h), bevel=0.03)
    yield box("seat box", YELLOW, (-0.19 * p.d, 0.0), (0.6 * p.y[0], 0.6 * p.y[1]), (0.3 * p.h, 0.5 * p.h))
    for x, lean in ((-0.22 * p.d, 0.04), (0.14 * p.d, -0.03)):
        for y in (-0.36 * p.w, 0.36 * p.w):
            yield sheared("guard post", DARK, (x, x + 0.05), (y - 0.025, y + 0.025), (0.3 * p.h, 0.97 * p.h), lean=(lean * p.d, 0.0))
    yield box("roof", DARK, (-0.2 * p.d, 0.15 * p.d), (-0.4 * p.w, 0.4 * p.w), (0.97 * p.h, p.h))
    for y in (-0.28 * p.w, 0.28 * p.w):
        yield box("mast", GREY, (0.2 * p.d + 0.001, 0.24 * p.d), (y - 0.04, y + 0.04), (0.06, 0.98 * p.h))
        yield box("fork", STEEL, (0.24 * p.d + 0.03, p.x[1]), (y - 0.06, y + 0.06), (0.0, 0.05))
    yield box("carriage", GREY, (0.24 * p.d, 0.24 * p.d + 0.03), (-0.42 * p.w, 0.42 * p.w), (0.02, 0.24 * p.h))
    yield sheared("wheel post", BLACK, (0.1 * p.d, 0.12 * p.d), (-0.02, 0.02), (0.3 * p.h, 0.56 * p.h), lean=(-0.04 * p.d, 0.0))
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
    top = min(0.92, 0.62 * p.h)
    yield box("top", p.wood, p.x, p.y, (top - 0.04, top))
    yield from four(p, GREY, top - 0.04, thick=0.06, inset=0.01)
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
            yield box("bar", STEEL, (p.x[0] + 0.016, p.x[1] - 0.016 if z < 0.9 * p.h else p.x[1]), (y0 + 0.002, y0 + 0.014), (z, z + 0.03 if z > 0.9 * p.h else z + 0.016))
    yield box("bar", STEEL, (p.x[0] + 0.001, p.x[0] + 0.015), (p.y[0] + 0.016, p.y[1] - 0.016), (p.h - 0.03, p.h))
    yield from stack(p, (0.86 * p.x[0], 0.86 * p.x[1]), (0.88 * p.y[0], 0.88 * p.y[1]), (0.17, 0.72 * p.h), 2)


def ladder(p: Piece) -> Iterator[Part]:
    """Yield a step ladder; its steps face +x."""
    for side in (-1, 1):
        y = side * (p.w / 2 - 0.02)
        yield sheared("rail", STEEL, (p.x[1] - 0.05, p.x[1]), (y - 0.018, y + 0.018), (0.0, p.h - 0.05), lean=(-0.52 * p.d, -side * 0.12 * p.w))
        yield sheared("rear leg", STEEL, (p.x[0], p.x[0] + 0.03), (y - 0.016, y + 0.016), (0.0, p.h - 0.06), lean=(0.32 * p.d, -side * 0.12 * p.w))
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
        yield cylinder("button", tone, (0.48 * p.y[1], (0.73 + 0.07 * i) * p.h), min(0.02, 0.08 * p.w), (p.x[1] - 0.012, p.x[1]), axis="x", sides=10)


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
    yield box("bracket", DARK, (p.x[0], -0.9 * r), (-0.06, 0.06), (0.3 * p.h, 0.6 * p.h))


def bollard(p: Piece) -> Iterator[Part]:
    """Yield a striped post on a plate."""
    r = 0.36 * min(p.d, p.w)
    yield box("plate", DARK, p.x, p.y, (0.0, 0.015))
    for i in range(5):
        yield cylinder("stripe", (YELLOW, BLACK)[i % 2], (0.0, 0.0), r, (0.015 + i * (p.h - 0.04) / 5, 0.015 + (i + 1) * (p.h - 0.04) / 5), sides=14)
    yield cylinder("cap", BLACK, (0.0, 0.0), (r, 0.6 * r), (p.h - 0.025, p.h), sides=14)


def workbench(p: Piece) -> Iterator[Part]:
    """Yield a solid bench with drawers, a vise and tools."""
    top = p.h - 0.1
    yield box("top", p.wood, p.x, p.y, (top - 0.06, top))
    yield from four(p, p.dark, top - 0.06, thick=0.09, inset=0.02)
    yield box("shelf", p.wood, (0.84 * p.x[0], 0.84 * p.x[1]), (p.y[0] + 0.12, p.y[1] - 0.12), (0.16 * p.h, 0.19 * p.h))
    yield box("drawers", p.front, (0.84 * p.x[0], 0.86 * p.x[1]), (0.1 * p.w, p.y[1] - 0.13), (top - 0.3, top - 0.061))
    for i in range(2):
        z = top - 0.28 + 0.11 * i
        yield box("drawer", p.front, (0.86 * p.x[1], 0.9 * p.x[1]), (0.1 * p.w + 0.01, p.y[1] - 0.14), (z, z + 0.1))
        yield box("handle", DARK, (0.9 * p.x[1], 0.94 * p.x[1]), (0.22 * p.w, 0.3 * p.w), (z + 0.045, z + 0.06))
    yield box("vise", BLUE, (p.x[1] - 0.12, p.x[1]), (-0.38 * p.w, -0.26 * p.w), (top, p.h))
    yield cylinder("screw", STEEL, (-0.32 * p.w, top - 0.1), 0.015, (p.x[1] - 0.1, p.x[1] + 0.08), axis="x", sides=8)
    yield box("tool box", RED, (-0.3 * p.d, 0.0), (0.12 * p.w, 0.32 * p.w), (top, p.h - 0.01))
    yield box("hammer", p.dark, (0.1 * p.d, 0.13 * p.d), (-0.12 * p.w, 0.06 * p.w), (top, top + 0.02))
    yield box("hammer head", IRON, (0.04 * p.d, 0.19 * p.d), (0.06 * p.w, 0.09 * p.w), (top, top + 0.03))


def tool_chest(p: Piece) -> Iterator[Part]:
    """Yield a roller cabinet with shallow drawers."""
    yield from castors(p, 0.06)
    tone = (RED, BLUE, p.accent)[p.variant % 3]
    yield carcass(p, tone, (0.13, p.h - 0.03))
    yield box("mat", RUBBER, (p.x[0], p.x[1] - 0.02), p.y, (p.h - 0.03, p.h))
    yield from drawers(p, tone, p.y, (0.14, p.h - 0.03), rows=max(3, round(p.h / 0.14)))


def tool_box(p: Piece) -> Iterator[Part]:
    """Yield a tool box with a handle."""
    tone = (RED, BLUE, YELLOW)[p.variant % 3]
    yield box("box", tone, (0.94 * p.x[0], 0.9 * p.x[1]), (0.97 * p.y[0], 0.97 * p.y[1]), (0.0, 0.56 * p.h))
    yield slab("lid", tone, (p.x[0], 0.96 * p.x[1]), p.y, (0.57 * p.h, 0.84 * p.h), top=(0.7, 0.94))
    yield box("handle", BLACK, (-0.08 * p.d, 0.08 * p.d), (-0.26 * p.w, 0.26 * p.w), (0.94 * p.h, p.h))
    for y in (-0.26 * p.w, 0.22 * p.w):
        yield box("handle post", BLACK, (-0.07 * p.d, 0.07 * p.d), (y, y + 0.04 * p.w), (0.84 * p.h, 0.94 * p.h))
        yield box("latch", STEEL, (0.9 * p.x[1], p.x[1]), (y, y + 0.06 * p.w), (0.46 * p.h, 0.66 * p.h))


def pegboard(p: Piece) -> Iterator[Part]:
    """Yield a wall board with hanging tools."""
    face = p.x[0] + 0.3 * p.d
    yield box("board", p.wood, (p.x[0], face), p.y, p.z)
    rng = p.rng()
    columns = max(3, round(p.w / 0.17))
    for i in range(columns):
        y = p.y[0] + (i + 0.5) * p.w / columns
        for row, top in enumerate((0.92, 0.48)):
            long = rng.uniform(0.18, 0.32) * p.h
            z = top * p.h
            yield box("grip", (RED, YELLOW, BLUE, BLACK)[(i + row) % 4], (face, p.x[1]), (y - 0.018, y + 0.018), (z - long, z - 0.5 * long))
            if (i + row) % 3:
                yield box("blade", STEEL, (face, face + 0.3 * p.d), (y - 0.01, y + 0.01), (z - 0.5 * long, z))
            else:
                yield box("head", IRON, (face, face + 0.5 * p.d), (y - 0.05, y + 0.05), (z - 0.5 * long, z - 0.35 * long))


def drill_press(p: Piece) -> Iterator[Part]:
    """Yield a pillar drill."""
    yield box("foot", IRON, p.x, (0.8 * p.y[0], 0.8 * p.y[1]), (0.0, 0.05))
    yield cylinder("column", STEEL, (-0.28 * p.d, 0.0), 0.045, (0.05, 0.92 * p.h), sides=12)
    yield box("table", IRON, (-0.2 * p.d, 0.4 * p.d), (0.7 * p.y[0], 0.7 * p.y[1]), (0.5 * p.h, 0.53 * p.h))
    yield soft("head", GREEN, (p.x[0], 0.4 * p.d), (0.7 * p.y[0], 0.7 * p.y[1]), (0.74 * p.h, p.h), bevel=0.03)
    yield cylinder("chuck", STEEL, (0.2 * p.d, 0.0), (0.02, 0.04), (0.64 * p.h, 0.74 * p.h), sides=12)
    yield cylinder("bit", STEEL, (0.2 * p.d, 0.0), 0.008, (0.57 * p.h, 0.64 * p.h), sides=6)
    for i in range(3):
        turn = 2 * math.pi * i / 3
        lever = box("lever", BLACK, (0.15 * p.d, 0.18 * p.d), (0.7 * p.y[1], p.y[1]), (0.82 * p.h, 0.835 * p.h))
        lever.vertices[lever.vertices[:, 1] > 0.9 * p.y[1], 0] += 0.14 * p.d * math.cos(turn)
        lever.vertices[lever.vertices[:, 1] > 0.9 * p.y[1], 2] += 0.14 * p.d * math.sin(turn)
        yield lever


def table_saw(p: Piece) -> Iterator[Part]:
    """Yield a table saw with a blade, a fence and a board."""
    top = p.h - 0.09
    yield slab("base", GREEN, (0.76 * p.x[0], 0.76 * p.x[1]), (0.6 * p.y[0], 0.6 * p.y[1]), (0.0, top - 0.04), top=(1.1, 1.1))
    yield box("table", STEEL, p.x, p.y, (top - 0.04, top))
    yield cylinder("blade", LIGHT_GREY, (top, 0.0), 0.09, (-0.003, 0.003), axis="y", sides=20)
    yield box("fence", DARK, (0.98 * p.x[0], 0.98 * p.x[1]), (0.2 * p.w, 0.24 * p.w), (top, top + 0.06))
    yield box("board", PINE, (-0.44 * p.d, 0.2 * p.d), (0.02 * p.w, 0.19 * p.w), (top, top + 0.022))
    yield cylinder("wheel", DARK, (0.0, 0.5 * top), 0.08, (0.4 * p.d, 0.44 * p.d), axis="x", sides=14)


def band_saw(p: Piece) -> Iterator[Part]:
    """Yield a band saw: cabinet, table, wheel housing."""
    yield box("cabinet", GREEN, (0.8 * p.x[0], 0.8 * p.x[1]), (0.8 * p.y[0], 0.8 * p.y[1]), (0.0, 0.46 * p.h))
    yield box("table", STEEL, p.x, (0.9 * p.y[0], p.y[1]), (0.52 * p.h, 0.55 * p.h))
    yield box("neck", GREEN, (-0.2 * p.d, 0.2 * p.d), (p.y[0], 0.7 * p.y[0]), (0.3 * p.h, 0.8 * p.h))
    yield cylinder("housing", GREEN, (0.0, 0.84 * p.h), 0.16 * p.h, (-0.26 * p.d, 0.26 * p.d), axis="x", sides=22)
    yield box("guide", DARK, (-0.04 * p.d, 0.04 * p.d), (0.3 * p.y[1], 0.42 * p.y[1]), (0.62 * p.h, 0.76 * p.h))
    yield box("blade", LIGHT_GREY, (-0.02 * p.d, 0.02 * p.d), (0.34 * p.y[1], 0.36 * p.y[1]), (0.55 * p.h, 0.62 * p.h))
    yield box("support", DARK, (-0.2 * p.d, 0.2 * p.d), (-0.14, 0.14), (0.46 * p.h, 0.52 * p.h))


def lathe(p: Piece) -> Iterator[Part]:
    """Yield a lathe: stand, bed, headstock at the left end, tailstock, workpiece."""
    bed = 0.62 * p.h
    for y0, y1 in ((p.y[0], p.y[0] + 0.26 * p.w), (p.y[1] - 0.26 * p.w, p.y[1])):
        yield box("stand", GREEN, (0.7 * p.x[0], 0.7 * p.x[1]), (y0, y1), (0.0, bed - 0.1))
    yield box("tray", GREY, p.x, p.y, (bed - 0.1, bed - 0.06))
    yield box("bed", IRON, (-0.2 * p.d, 0.2 * p.d), (0.98 * p.y[0], 0.98 * p.y[1]), (bed - 0.06, bed + 0.05))
    yield box("headstock", GREEN, (-0.34 * p.d, 0.34 * p.d), (p.y[0] + 0.001, p.y[0] + 0.28 * p.w), (bed + 0.05, p.h))
    axis = bed + 0.2
    yield cylinder("chuck", STEEL, (axis, 0.0), 0.1, (p.y[0] + 0.28 * p.w, p.y[0] + 0.34 * p.w), axis="y", sides=16)
    yield cylinder("workpiece", PINE, (axis, 0.0), 0.04, (p.y[0] + 0.34 * p.w, 0.24 * p.w), axis="y", sides=12)
    yield box("tailstock", GREEN, (-0.16 * p.d, 0.16 * p.d), (0.26 * p.w, 0.4 * p.w), (bed + 0.05, axis + 0.07))
    yield box("carriage", STEEL, (-0.3 * p.d, 0.4 * p.d), (-0.06 * p.w, 0.08 * p.w), (bed + 0.05, axis - 0.06))
    yield cylinder("hand wheel", DARK, (0.0, bed), 0.08, (0.42 * p.d, 0.46 * p.d), axis="x", sides=14)


def milling_machine(p: Piece) -> Iterator[Part]:
    """Yield an enclosed machine tool with a window and a control panel."""
    yield box("base", DARK, (p.x[0], 0.9 * p.x[1]), p.y, (0.0, 0.1 * p.h))
    yield soft("housing", WHITE, (p.x[0] + 0.002, 0.84 * p.x[1]), (0.99 * p.y[0], 0.99 * p.y[1]), (0.1 * p.h, 0.94 * p.h), bevel=0.05)
    yield box("door", GREY, (0.84 * p.x[1], 0.88 * p.x[1]), (0.86 * p.y[0], 0.36 * p.y[1]), (0.36 * p.h, 0.88 * p.h))
    yield box("window", BLACK, (0.88 * p.x[1], 0.89 * p.x[1]), (0.7 * p.y[0], 0.2 * p.y[1]), (0.5 * p.h, 0.82 * p.h))
    yield box("handle", STEEL, (0.88 * p.x[1], 0.95 * p.x[1]), (0.24 * p.y[1], 0.28 * p.y[1]), (0.5 * p.h, 0.74 * p.h))
    yield box("panel", DARK, (0.84 * p.x[1], p.x[1]), (0.5 * p.y[1], 0.9 * p.y[1]), (0.5 * p.h, 0.84 * p.h))
    yield box("screen", GLOW, (p.x[1], p.x[1] + 0.006), (0.54 * p.y[1], 0.86 * p.y[1]), (0.66 * p.h, 0.82 * p.h))
    yield box("stripe", p.accent, (0.84 * p.x[1], 0.86 * p.x[1]), (0.9 * p.y[0], 0.9 * p.y[1]), (0.2 * p.h, 0.26 * p.h))
    yield cylinder("lamp", GREEN, (-0.3 * p.d, 0.36 * p.w), 0.04, (0.94 * p.h, p.h), sides=12)


def bench_grinder(p: Piece) -> Iterator[Part]:
    """Yield a motor with two stones."""
    yield box("foot", IRON, (0.7 * p.x[0], 0.7 * p.x[1]), (-0.2 * p.w, 0.2 * p.w), (0.0, 0.3 * p.h))
    z = 0.56 * p.h
    yield cylinder("motor", BLUE, (z, 0.0), 0.3 * p.h, (-0.26 * p.w, 0.26 * p.w), axis="y", sides=16)
    for y in ((p.y[0], -0.36 * p.w), (0.36 * p.w, p.y[1])):
        yield cylinder("stone", LIGHT_GREY, (z, 0.0), 0.44 * p.h, y, axis="y", sides=18)
    yield cylinder("shaft", STEEL, (z, 0.0), 0.05 * p.h, (-0.36 * p.w, 0.36 * p.w), axis="y", sides=8)


def vise(p: Piece) -> Iterator[Part]:
    """Yield a bench vise."""
    yield cylinder("foot", BLUE, (-0.14 * p.d, 0.0), (0.3 * p.d, 0.24 * p.d), (0.0, 0.3 * p.h), sides=14)
    yield box("body", BLUE, (p.x[0], 0.0), (-0.3 * p.w, 0.3 * p.w), (0.3 * p.h, 0.7 * p.h))
    for x in ((-0.1 * p.d, -0.001), (0.1 * p.d, 0.22 * p.d)):
        yield box("jaw", IRON, x, p.y, (0.7 * p.h, p.h))
    yield box("slide", BLUE, (0.001, 0.24 * p.d), (-0.2 * p.w, 0.2 * p.w), (0.4 * p.h, 0.7 * p.h))
    yield cylinder("screw", STEEL, (0.0, 0.54 * p.h), 0.06 * p.h, (0.24 * p.d, p.x[1]), axis="x", sides=8)
    yield cylinder("handle", STEEL, (0.54 * p.h, p.x[1] - 0.04 * p.d), 0.03 * p.h, (-0.44 * p.w, 0.44 * p.w), axis="y", sides=8)


def compressor(p: Piece) -> Iterator[Part]:
    """Yield an air compressor: tank along y, motor on top, two wheels."""
    r = 0.28 * p.h
    middle = 0.42 * p.h
    yield cylinder("tank", RED, (middle, 0.0), r, (0.9 * p.y[0], 0.9 * p.y[1]), axis="y", sides=20)
    for y in ((p.y[0], 0.9 * p.y[0]), (0.9 * p.y[1], p.y[1])):
        radii = (0.6 * r, r) if y[0] < 0 else (r, 0.6 * r)
        yield cylinder("cap", RED, (middle, 0.0), radii, y, axis="y", sides=20)
    for x in (p.x[0] + 0.02, p.x[1] - 0.02):
        yield cylinder("wheel", RUBBER, (-0.3 * p.w, 0.12), 0.12, (x - 0.02, x + 0.02), axis="x", sides=14)
    yield box("axle", STEEL, (0.9 * p.x[0], 0.9 * p.x[1]), (-0.31 * p.w, -0.29 * p.w), (0.11, 0.13))
    yield box("foot", DARK, (-0.1, 0.1), (0.3 * p.w, 0.34 * p.w), (0.0, middle - 0.8 * r))
    yield soft("motor", BLACK, (-0.3 * p.d, 0.3 * p.d), (-0.26 * p.w, 0.1 * p.w), (middle + 0.8 * r, 0.94 * p.h), bevel=0.03)
    yield cylinder("filter", STEEL, (0.0, 0.24 * p.w), 0.06, (middle + 0.8 * r, p.h), sides=12)


def welding_machine(p: Piece) -> Iterator[Part]:
    """Yield a welding machine on a cart with a gas bottle."""
    yield from castors(p, 0.06)
    yield box("deck", DARK, p.x, p.y, (0.12, 0.16))
    yield soft("casing", ORANGE, (-0.1 * p.d, p.x[1] - 0.02), (0.9 * p.y[0], 0.9 * p.y[1]), (0.16, 0.66 * p.h), bevel=0.02)
    yield box("panel", BLACK, (p.x[1] - 0.02, p.x[1] - 0.01), (0.7 * p.y[0], 0.7 * p.y[1]), (0.36 * p.h, 0.6 * p.h))
    yield cylinder("dial", STEEL, (0.0, 0.48 * p.h), 0.03, (p.x[1] - 0.01, p.x[1]), axis="x", sides=12)
    r = min(0.1, 0.3 * p.w)
    yield cylinder("bottle", GREEN, (p.x[0] + r + 0.02, 0.0), r, (0.16, 0.86 * p.h), sides=14)
    yield cylinder("valve", STEEL, (p.x[0] + r + 0.02, 0.0), (0.7 * r, 0.2 * r), (0.86 * p.h, p.h), sides=14)
    yield box("handle", STEEL, (-0.14 * p.d, 0.3 * p.d), (-0.02, 0.02), (0.72 * p.h, 0.76 * p.h))
    for x in (-0.08 * p.d, 0.26 * p.d):
        yield box("handle post", STEEL, (x, x + 0.02), (-0.018, 0.018), (0.66 * p.h, 0.72 * p.h))


def sawhorse(p: Piece) -> Iterator[Part]:
    """Yield a trestle."""
    yield box("beam", PINE, (-0.06, 0.06), p.y, (p.h - 0.08, p.h))
    for y in (0.86 * p.y[0], 0.86 * p.y[1]):
        for way in (-1, 1):
            x = way * (p.d / 2 - 0.025)
            yield sheared("leg", PINE, (x - 0.025, x + 0.025), (y - 0.03, y + 0.03), (0.0, p.h - 0.08), lean=(-way * (p.d / 2 - 0.06), 0.0))
        yield box("brace", PINE, (-0.28 * p.d, 0.28 * p.d), (y - 0.02, y + 0.02), (0.42 * p.h, 0.5 * p.h))


def lumber_rack(p: Piece) -> Iterator[Part]:
    """Yield a cantilever rack with planks."""
    for i in range(n := max(2, round(p.w / 0.9))):
        y = p.y[0] + 0.06 + i * (p.w - 0.12) / (n - 1)
        yield box("post", BLUE, (p.x[0], p.x[0] + 0.08), (y - 0.04, y + 0.04), (0.0, p.h))
        for k in range(4):
            z = (0.06 + 0.25 * k) * p.h
            yield box("arm", BLUE, (p.x[0] + 0.08, p.x[1]), (y - 0.03, y + 0.03), (z - 0.04, z))
    for k in range(4):
        z = (0.06 + 0.25 * k) * p.h
        for i in range(3):
            x = p.x[0] + 0.1 + i * (p.d - 0.12) / 3
            for layer in range(1 + (i + k) % 3):
                yield box("plank", (PINE, p.wood, p.dark)[(i + k) % 3], (x, x + 0.26 * p.d), p.y, (z + 0.032 * layer, z + 0.032 * layer + 0.03))


def printer_3d(p: Piece) -> Iterator[Part]:
    """Yield a 3D printer: frame, bed, gantry, a printed thing."""
    t = 0.05 * p.w
    yield box("base", DARK, p.x, p.y, (0.0, 0.12 * p.h))
    for y in (p.y[0], p.y[1] - t):
        for x in (p.x[0], p.x[1] - t):
            yield box("post", BLACK, (x, x + t), (y, y + t), (0.12 * p.h, p.h - 0.06 * p.h))
    yield box("top", BLACK, p.x, p.y, (0.94 * p.h, p.h))
    yield box("bed", STEEL, (0.7 * p.x[0], 0.7 * p.x[1]), (0.7 * p.y[0], 0.7 * p.y[1]), (0.16 * p.h, 0.19 * p.h))
    yield cylinder("print", ORANGE, (0.0, 0.0), (0.14 * p.d, 0.06 * p.d), (0.19 * p.h, 0.46 * p.h), sides=12)
    yield box("gantry", STEEL, (-0.03 * p.d, 0.03 * p.d), (p.y[0] + t, p.y[1] - t), (0.56 * p.h, 0.6 * p.h))
    yield box("head", ORANGE, (-0.1 * p.d, 0.1 * p.d), (-0.1 * p.w, 0.1 * p.w), (0.48 * p.h, 0.68 * p.h))


def sewing_machine(p: Piece) -> Iterator[Part]:
    """Yield a sewing machine; the sewer sits at +x."""
    yield soft("bed", WHITE, p.x, p.y, (0.0, 0.2 * p.h), bevel=0.012)
    yield soft("pillar", WHITE, (0.8 * p.x[0], 0.6 * p.x[1]), (0.22 * p.w, 0.46 * p.w), (0.2 * p.h, 0.9 * p.h), bevel=0.02)
    yield soft("arm", WHITE, (0.7 * p.x[0], 0.5 * p.x[1]), (-0.42 * p.w, 0.24 * p.w), (0.62 * p.h, 0.9 * p.h), bevel=0.02)
    yield box("head", WHITE, (0.56 * p.x[0], 0.4 * p.x[1]), (-0.4 * p.w, -0.22 * p.w), (0.46 * p.h, 0.63 * p.h))
    yield cylinder("needle", STEEL, (-0.02, -0.31 * p.w), 0.006, (0.2 * p.h, 0.46 * p.h), sides=6)
    yield cylinder("wheel", p.accent, (0.74 * p.h, 0.0), 0.14 * p.h, (0.46 * p.w, p.y[1]), axis="y", sides=14)
    yield cylinder("thread", p.accent, (-0.02, 0.1 * p.w), 0.03, (0.9 * p.h, p.h), sides=10)


def bicycle(p: Piece) -> Iterator[Part]:
    """Yield a bicycle that faces +x."""
    r = 0.32 * p.h
    rear, front = p.x[0] + r, p.x[1] - r
    for x in (rear, front):
        yield from wheel(p, x, 0.0, r, wide=0.035)
    frame = p.accent
    yield sheared("seat tube", frame, (-0.13 * p.d, -0.1 * p.d), (-0.016, 0.016), (0.3 * p.h, 0.82 * p.h), lean=(-0.06 * p.d, 0.0))
    yield sheared("fork", frame, (front - 0.02, front + 0.02), (-0.03, 0.03), (r, 0.84 * p.h), lean=(-0.1 * p.d, 0.0))
    yield bar(frame, (-0.15 * p.d, 0.24 * p.d), (0.7 * p.h, 0.74 * p.h))
    yield bar(frame, (-0.12 * p.d, 0.26 * p.d), (0.32 * p.h, 0.68 * p.h))
    yield bar(frame, (rear, -0.12 * p.d), (r, 0.32 * p.h))
    yield bar(frame, (rear, -0.17 * p.d), (r, 0.7 * p.h))
    yield soft("saddle", BLACK, (-0.25 * p.d, -0.1 * p.d), (-0.07, 0.07), (0.82 * p.h, 0.88 * p.h), bevel=0.02)
    yield box("stem", STEEL, (front - 0.12 * p.d, front - 0.09 * p.d), (-0.02, 0.02), (0.84 * p.h, 0.96 * p.h))
    yield cylinder("handle bar", BLACK, (0.98 * p.h, front - 0.11 * p.d), 0.02 * p.h, p.y, axis="y", sides=8)
    yield cylinder("chain ring", STEEL, (0.3 * p.h, -0.11 * p.d), 0.09 * p.h, (-0.05, -0.04), axis="y", sides=16)
    for side in (-1, 1):
        yield box("pedal", DARK, (-0.11 * p.d - 0.05, -0.11 * p.d + 0.05), (side * 0.11 - 0.05, side * 0.11 + 0.05), (0.3 * p.h + side * 0.13, 0.3 * p.h + side * 0.13 + 0.02))


def bar(tone: Material, x: Span, z: Span) -> Part:
    """Return a slim tube of a frame from (x[0], z[0]) to (x[1], z[1])."""
    part = box("tube", tone, x, (-0.015, 0.015), (-0.016, 0.016))
    part.vertices[:, 2] += z[0] + (part.vertices[:, 0] - x[0]) / (x[1] - x[0]) * (z[1] - z[0])
    return part


def bike_rack(p: Piece) -> Iterator[Part]:
    """Yield hoops on two rails."""
    for x in (p.x[0], p.x[1] - 0.04):
        yield box("rail", STEEL, (x, x + 0.04), p.y, (0.0, 0.03))
    for i in range(n := max(2, round(p.w / 0.35))):
        y = p.y[0] + (i + 0.5) * p.w / n
        for x in (p.x[0] + 0.005, p.x[1] - 0.035):
            yield box("hoop", STEEL, (x, x + 0.03), (y - 0.015, y + 0.015), (0.03, p.h - 0.03))
        yield box("hoop", STEEL, (p.x[0] + 0.005, p.x[1] - 0.005), (y - 0.015, y + 0.015), (p.h - 0.03, p.h))


def paint_can(p: Piece) -> Iterator[Part]:
    """Yield a paint can with a coloured label."""
    r = min(p.d, p.w) / 2
    yield cylinder("can", STEEL, (0.0, 0.0), 0.96 * r, (0.0, 0.94 * p.h), sides=20)
    yield cylinder("label", BRIGHT[p.variant % 6], (0.0, 0.0), r, (0.14 * p.h, 0.8 * p.h), sides=20)
    yield cylinder("lid", LIGHT_GREY, (0.0, 0.0), 0.86 * r, (0.94 * p.h, p.h), sides=20)


def tire_rack(p: Piece) -> Iterator[Part]:
    """Yield a rack with two rows of tyres."""
    for y in (p.y[0], p.y[1] - 0.05):
        for x in (p.x[0], p.x[1] - 0.05):
            yield box("post", BLUE, (x, x + 0.05), (y, y + 0.05), (0.0, p.h))
    for level in (0.1, 0.58):
        for x in (0.5 * p.x[0], 0.4 * p.x[1]):
            yield box("rail", BLUE, (x, x + 0.04), (p.y[0] + 0.05, p.y[1] - 0.05), (level * p.h, level * p.h + 0.04))
        r = min(0.2 * p.h, 0.48 * p.d)
        for i in range(n := max(2, round((p.w - 0.1) / 0.26))):
            y = p.y[0] + 0.05 + (i + 0.5) * (p.w - 0.1) / n
            z = level * p.h + 0.01 + r
            yield cylinder("tyre", RUBBER, (z, 0.0), r, (y - 0.1, y + 0.1), axis="y", sides=20)
            yield cylinder("rim", STEEL, (z, 0.0), 0.6 * r, (y - 0.104, y + 0.104), axis="y", sides=16)


def engine_hoist(p: Piece) -> Iterator[Part]:
    """Yield a shop crane on castors."""
    yield from castors(p, 0.05, inset=0.03)
    for y0 in (p.y[0], p.y[1] - 0.08):
        yield box("leg", RED, p.x, (y0, y0 + 0.08), (0.06, 0.14))
    yield box("cross bar", RED, (p.x[0], p.x[0] + 0.1), (p.y[0] + 0.08, p.y[1] - 0.08), (0.06, 0.14))
    yield box("mast", RED, (p.x[0] + 0.02, p.x[0] + 0.1), (-0.04, 0.04), (0.14, 0.86 * p.h))
    boom = box("boom", RED, (p.x[0] + 0.02, 0.4 * p.d), (-0.035, 0.035), (0.86 * p.h, 0.92 * p.h))
    boom.vertices[boom.vertices[:, 0] > 0, 2] += 0.08 * p.h
    yield boom
    yield sheared("jack", DARK, (p.x[0] + 0.1, p.x[0] + 0.16), (-0.03, 0.03), (0.4 * p.h, 0.86 * p.h), lean=(0.26 * p.d, 0.0))
    yield cylinder("chain", STEEL, (0.37 * p.d, 0.0), 0.01, (0.62 * p.h, 0.94 * p.h), sides=6)
    yield box("hook", STEEL, (0.35 * p.d, 0.39 * p.d), (-0.02, 0.02), (0.56 * p.h, 0.62 * p.h))


def lawn_mower(p: Piece) -> Iterator[Part]:
    """Yield a lawn mower; it is pushed from behind."""
    r = 0.1 * p.h + 0.02
    for x in (-0.04 * p.d, 0.4 * p.d):
        for y in (p.y[0] + 0.03, p.y[1] - 0.03):
            yield cylinder("wheel", RUBBER, (r, x), r, (y - 0.025, y + 0.025), axis="y", sides=14)
    yield soft("deck", GREEN, (-0.12 * p.d, p.x[1]), (0.84 * p.y[0], 0.84 * p.y[1]), (0.08, 0.26 * p.h), bevel=0.04)
    yield soft("motor", BLACK, (0.04 * p.d, 0.3 * p.d), (-0.22 * p.w, 0.22 * p.w), (0.26 * p.h, 0.44 * p.h), bevel=0.03)
    yield soft("bag", DARK, (-0.32 * p.d, -0.12 * p.d - 0.002), (0.7 * p.y[0], 0.7 * p.y[1]), (0.14, 0.42 * p.h), bevel=0.04)
    for y in (0.7 * p.y[0], 0.7 * p.y[1]):
        yield sheared("pole", STEEL, (-0.1 * p.d, -0.08 * p.d), (y - 0.012, y + 0.012), (0.24 * p.h, p.h - 0.03), lean=(-0.38 * p.d, 0.0))
    yield box("handle", BLACK, (p.x[0], p.x[0] + 0.05), (0.76 * p.y[0], 0.76 * p.y[1]), (p.h - 0.04, p.h))


def stairs(p: Piece) -> Iterator[Part]:
    """Yield a flight of stairs that rises towards the back, with a handrail."""
    climb = p.h - 0.9 if p.h > 1.6 else p.h
    count = max(3, round(climb / 0.19))
    rise = climb / count
    for i in range(count):
        x = (p.x[1] - (i + 1) * p.d / count, p.x[1] - i * p.d / count)
        yield box("step", p.wood, x, p.y, (max(0.0, i * rise - 0.12), (i + 1) * rise))
    if p.h > 1.6:
        rail = box("hand rail", p.dark, p.x, (p.y[1] - 0.05, p.y[1] - 0.005), (0.0, 0.05))
        rail.vertices[:, 2] += 0.85 + (p.x[1] - rail.vertices[:, 0]) / p.d * (p.h - 0.9)
        yield rail
        for i in range(0, count, 2):
            x = p.x[1] - (i + 0.5) * p.d / count
            low = (i + 1) * rise
            yield box("baluster", p.metal, (x - 0.012, x + 0.012), (p.y[1] - 0.04, p.y[1] - 0.016), (low, 0.86 + (p.x[1] - x) / p.d * (p.h - 0.9)))


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
    """Yield a stone table with a cloth and two candles."""
    top = 0.82 * p.h
    yield box("base", CONCRETE, (0.8 * p.x[0], 0.8 * p.x[1]), (0.84 * p.y[0], 0.84 * p.y[1]), (0.0, top - 0.06))
    yield box("top", CONCRETE, p.x, p.y, (top - 0.06, top))
    yield box("cloth", WHITE, (0.96 * p.x[0], 0.96 * p.x[1]), (0.5 * p.y[0], 0.5 * p.y[1]), (top, top + 0.004))
    for y in (-0.36 * p.w, 0.36 * p.w):
        yield cylinder("candle", WHITE, (0.0, y), 0.03, (top, p.h), sides=10)


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
    yield slab("chest", p.dark, (0.9 * p.x[0], 0.9 * p.x[1]), (0.95 * p.y[0], 0.95 * p.y[1]), (0.0, 0.6 * p.h), top=(1.08, 1.04))
    yield slab("lid", p.dark, p.x, p.y, (0.602 * p.h, p.h), top=(0.5, 0.84))
    for y in (-0.3 * p.w, 0.0, 0.3 * p.w):
        yield box("handle", STEEL, (0.46 * p.d, 0.5 * p.d), (y - 0.1, y + 0.1), (0.4 * p.h, 0.44 * p.h))


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
    "workbench": workbench,
    "tool chest": tool_chest,
    "tool box": tool_box,
    "pegboard": pegboard,
    "drill press": drill_press,
    "table saw": table_saw,
    "band saw": band_saw,
    "lathe": lathe,
    "milling machine": milling_machine,
    "bench grinder": bench_grinder,
    "vise": vise,
    "air compressor": compressor,
    "welding machine": welding_machine,
    "sawhorse": sawhorse,
    "lumber rack": lumber_rack,
    "3d printer": printer_3d,
    "sewing machine": sewing_machine,
    "bicycle": bicycle,
    "bike rack": bike_rack,
    "paint can": paint_can,
    "tire rack": tire_rack,
    "engine hoist": engine_hoist,
    "lawn mower": lawn_mower,
    "stairs": stairs,
    "column post": column,
    "elevator": elevator,
    "radiator cover": radiator_cover,
    "altar": altar,
    "sauna": sauna,
    "coffin": coffin,
}
