"""Workshops and garages."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, carcass, drawers, four
from robolayout.assets.furniture.care import castors, wheel
from robolayout.assets.palette import (
    BLACK,
    BLUE,
    BRIGHT,
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
from robolayout.assets.part import Material, Part
from robolayout.assets.shapes import box, cylinder, sheared, slab, soft

Span = tuple[float, float]


def workbench(p: Piece) -> Iterator[Part]:
    """Yield a solid bench with drawers, a vise at its front edge and a tool box below."""
    top = p.h
    yield box("top", p.wood, p.x, p.y, (top - 0.06, top))
    yield from four(p, p.dark, top - 0.06, thick=0.09, inset=0.02)
    yield box("shelf", p.wood, (0.84 * p.x[0], 0.84 * p.x[1]), (p.y[0] + 0.12, p.y[1] - 0.12), (0.16 * p.h, 0.19 * p.h))
    yield box("drawers", p.front, (0.84 * p.x[0], 0.86 * p.x[1]), (0.1 * p.w, p.y[1] - 0.13), (top - 0.3, top - 0.061))
    for i in range(2):
        z = top - 0.28 + 0.11 * i
        yield box("drawer", p.front, (0.86 * p.x[1], 0.9 * p.x[1]), (0.1 * p.w + 0.01, p.y[1] - 0.14), (z, z + 0.1))
        yield box("handle", DARK, (0.9 * p.x[1], 0.94 * p.x[1]), (0.22 * p.w, 0.3 * p.w), (z + 0.045, z + 0.06))
    yield box("vise", BLUE, (p.x[1] - 0.02, p.x[1] + 0.03), (-0.4 * p.w, -0.26 * p.w), (p.h - 0.16, p.h - 0.02))
    yield box("vise jaw", BLUE, (p.x[1] + 0.05, p.x[1] + 0.08), (-0.4 * p.w, -0.26 * p.w), (p.h - 0.16, p.h - 0.02))
    yield cylinder("screw", STEEL, (-0.33 * p.w, p.h - 0.11), 0.012, (p.x[1] + 0.03, p.x[1] + 0.12), axis="x", sides=8)
    yield box("tool box", RED, (-0.2 * p.d, 0.14 * p.d), (-0.3 * p.w, -0.02 * p.w), (0.19 * p.h, 0.4 * p.h))
    yield box("tool box handle", DARK, (-0.05 * p.d, -0.01 * p.d), (-0.22 * p.w, -0.1 * p.w), (0.4 * p.h, 0.44 * p.h))


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
            yield box(
                "grip",
                (RED, YELLOW, BLUE, BLACK)[(i + row) % 4],
                (face, p.x[1]),
                (y - 0.018, y + 0.018),
                (z - long, z - 0.5 * long),
            )
            if (i + row) % 3:
                yield box("blade", STEEL, (face, face + 0.3 * p.d), (y - 0.01, y + 0.01), (z - 0.5 * long, z))
            else:
                yield box(
                    "head", IRON, (face, face + 0.5 * p.d), (y - 0.05, y + 0.05), (z - 0.5 * long, z - 0.35 * long)
                )


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
        lever = box(
            "lever",
            BLACK,
            (0.15 * p.d, 0.18 * p.d),
            (0.7 * p.y[1] - 0.002 * i, p.y[1] - 0.002 * i),
            (0.82 * p.h + 0.002 * i, 0.835 * p.h + 0.002 * i),
        )
        lever.vertices[lever.vertices[:, 1] > 0.9 * p.y[1], 0] += 0.14 * p.d * math.cos(turn)
        lever.vertices[lever.vertices[:, 1] > 0.9 * p.y[1], 2] += 0.14 * p.d * math.sin(turn)
        yield lever


def table_saw(p: Piece) -> Iterator[Part]:
    """Yield a table saw with a blade, a fence and a board."""
    top = p.h - 0.09
    yield slab(
        "base", GREEN, (0.76 * p.x[0], 0.76 * p.x[1]), (0.6 * p.y[0], 0.6 * p.y[1]), (0.0, top - 0.04), top=(1.1, 1.1)
    )
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
    yield soft(
        "housing",
        WHITE,
        (p.x[0] + 0.002, 0.84 * p.x[1]),
        (0.99 * p.y[0], 0.99 * p.y[1]),
        (0.1 * p.h, 0.94 * p.h),
        bevel=0.05,
    )
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
    yield cylinder(
        "handle", STEEL, (0.54 * p.h, p.x[1] - 0.04 * p.d), 0.03 * p.h, (-0.44 * p.w, 0.44 * p.w), axis="y", sides=8
    )


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
    yield soft(
        "motor", BLACK, (-0.3 * p.d, 0.3 * p.d), (-0.26 * p.w, 0.1 * p.w), (middle + 0.8 * r, 0.94 * p.h), bevel=0.03
    )
    yield cylinder("filter", STEEL, (0.0, 0.24 * p.w), 0.06, (middle + 0.8 * r, p.h), sides=12)


def welding_machine(p: Piece) -> Iterator[Part]:
    """Yield a welding machine on a cart with a gas bottle."""
    yield from castors(p, 0.06)
    yield box("deck", DARK, p.x, p.y, (0.12, 0.16))
    yield soft(
        "casing", ORANGE, (-0.1 * p.d, p.x[1] - 0.02), (0.9 * p.y[0], 0.9 * p.y[1]), (0.16, 0.66 * p.h), bevel=0.02
    )
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
            yield sheared(
                "leg",
                PINE,
                (x - 0.025, x + 0.025),
                (y - 0.03, y + 0.03),
                (0.0, p.h - 0.08),
                lean=(-way * (p.d / 2 - 0.06), 0.0),
            )
        yield box("brace", PINE, (-0.28 * p.d, 0.28 * p.d), (y - 0.02, y + 0.02), (0.42 * p.h, 0.5 * p.h))


def lumber_rack(p: Piece) -> Iterator[Part]:
    """Yield a cantilever rack with planks; its lowest arms are its feet."""
    for i in range(n := max(2, round(p.w / 0.9))):
        y = p.y[0] + 0.06 + i * (p.w - 0.12) / (n - 1)
        yield box("post", BLUE, (p.x[0], p.x[0] + 0.08), (y - 0.04, y + 0.04), (0.0, p.h))
        for k in range(4):
            z = (0.06 + 0.25 * k) * p.h
            low = z - 0.04 if k else 0.0
            yield box("arm" if k else "foot", BLUE, (p.x[0] + 0.08, p.x[1]), (y - 0.03, y + 0.03), (low, z))
    for k in range(4):
        z = (0.06 + 0.25 * k) * p.h
        for i in range(3):
            x = p.x[0] + 0.1 + i * (p.d - 0.12) / 3
            for layer in range(1 + (i + k) % 3):
                yield box(
                    "plank",
                    (PINE, p.wood, p.dark)[(i + k) % 3],
                    (x, x + 0.26 * p.d),
                    p.y,
                    (z + 0.032 * layer, z + 0.032 * layer + 0.03),
                )


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
    yield soft(
        "pillar", WHITE, (0.8 * p.x[0], 0.6 * p.x[1]), (0.22 * p.w, 0.46 * p.w), (0.2 * p.h, 0.9 * p.h), bevel=0.02
    )
    yield soft(
        "arm", WHITE, (0.7 * p.x[0], 0.5 * p.x[1]), (-0.42 * p.w, 0.24 * p.w), (0.62 * p.h, 0.9 * p.h), bevel=0.02
    )
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
    yield sheared(
        "seat tube", frame, (-0.13 * p.d, -0.1 * p.d), (-0.016, 0.016), (0.3 * p.h, 0.82 * p.h), lean=(-0.06 * p.d, 0.0)
    )
    yield sheared("fork", frame, (front - 0.02, front + 0.02), (-0.03, 0.03), (r, 0.84 * p.h), lean=(-0.1 * p.d, 0.0))
    yield bar(frame, (-0.15 * p.d, 0.24 * p.d), (0.7 * p.h, 0.74 * p.h), 0.017)
    yield bar(frame, (-0.12 * p.d, 0.26 * p.d), (0.32 * p.h, 0.68 * p.h), 0.014)
    yield bar(frame, (rear, -0.12 * p.d), (r, 0.32 * p.h), 0.010)
    yield bar(frame, (rear + 0.005, -0.17 * p.d), (r, 0.7 * p.h), 0.0125)
    yield soft("saddle", BLACK, (-0.25 * p.d, -0.1 * p.d), (-0.07, 0.07), (0.82 * p.h, 0.88 * p.h), bevel=0.02)
    yield box("stem", STEEL, (front - 0.12 * p.d, front - 0.09 * p.d), (-0.02, 0.02), (0.84 * p.h, 0.96 * p.h))
    yield cylinder("handle bar", BLACK, (0.98 * p.h, front - 0.11 * p.d), 0.02 * p.h, p.y, axis="y", sides=8)
    yield cylinder("chain ring", STEEL, (0.3 * p.h, -0.11 * p.d), 0.09 * p.h, (-0.05, -0.04), axis="y", sides=16)
    for side in (-1, 1):
        yield box(
            "pedal",
            DARK,
            (-0.11 * p.d - 0.05, -0.11 * p.d + 0.05),
            (side * 0.11 - 0.05, side * 0.11 + 0.05),
            (0.3 * p.h + side * 0.13, 0.3 * p.h + side * 0.13 + 0.02),
        )


def bar(tone: Material, x: Span, z: Span, half: float = 0.015) -> Part:
    """Return a slim tube of a frame from (x[0], z[0]) to (x[1], z[1]), `half` as wide."""
    part = box("tube", tone, x, (-half, half), (-0.016, 0.016))
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
    yield sheared(
        "jack", DARK, (p.x[0] + 0.1, p.x[0] + 0.16), (-0.03, 0.03), (0.4 * p.h, 0.86 * p.h), lean=(0.26 * p.d, 0.0)
    )
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
    yield soft(
        "bag", DARK, (-0.32 * p.d, -0.12 * p.d - 0.002), (0.7 * p.y[0], 0.7 * p.y[1]), (0.14, 0.42 * p.h), bevel=0.04
    )
    for y in (0.7 * p.y[0], 0.7 * p.y[1]):
        yield sheared(
            "pole",
            STEEL,
            (-0.1 * p.d, -0.08 * p.d),
            (y - 0.012, y + 0.012),
            (0.24 * p.h, p.h - 0.03),
            lean=(-0.38 * p.d, 0.0),
        )
    yield box("handle", BLACK, (p.x[0], p.x[0] + 0.05), (0.76 * p.y[0], 0.76 * p.y[1]), (p.h - 0.04, p.h))


BUILDERS: dict[str, Builder] = {
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
}
