"""Offices and classrooms."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, board, four
from robolayout.assets.palette import (
    BLACK,
    BLUE,
    BRIGHT,
    DARK,
    GLASS,
    GLOW,
    GREEN,
    IVORY,
    LIGHT_GREY,
    PAPER,
    RED,
    STEEL,
    WHITE,
    YELLOW,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, sheared, slab, soft


def desk(p: Piece) -> Iterator[Part]:
    """Yield a desk; the person sits at +x. Drawers on one side where it is wide enough."""
    thick = 0.03
    yield board(p, p.wood, (p.h - thick, p.h))
    low = p.h - thick
    if p.w > 1.05 and p.variant % 3:
        y = (p.y[1] - 0.42, p.y[1] - 0.02) if p.variant % 2 else (p.y[0] + 0.02, p.y[0] + 0.42)
        yield box("pedestal", p.front, (p.x[0] + 0.06, p.x[1] - 0.06), y, (0.0, low - 0.002))
        for i in range(3):
            z = (0.04 + i * (low - 0.06) / 3, 0.03 + (i + 1) * (low - 0.06) / 3)
            yield box("drawer", p.front, (p.x[1] - 0.06, p.x[1] - 0.042), (y[0] + 0.004, y[1] - 0.004), z)
            middle = (y[0] + y[1]) / 2
            yield box(
                "handle",
                p.metal,
                (p.x[1] - 0.042, p.x[1] - 0.02),
                (middle - 0.07, middle + 0.07),
                (z[1] - 0.05, z[1] - 0.038),
            )
        far = p.y[0] + 0.02 if p.variant % 2 else p.y[1] - 0.07
        for x in (p.x[0] + 0.02, p.x[1] - 0.07):
            yield box("leg", p.dark, (x, x + 0.05), (far, far + 0.05), (0.0, low))
    else:
        yield from four(p, p.metal if p.variant % 2 else p.dark, low, thick=0.05, inset=0.02)
    yield box(
        "modesty panel", p.wood, (p.x[0] + 0.03, p.x[0] + 0.045), (p.y[0] + 0.08, p.y[1] - 0.08), (0.5 * p.h, low)
    )


def standing_desk(p: Piece) -> Iterator[Part]:
    """Yield a desk on two lifting columns."""
    yield board(p, p.wood, (p.h - 0.03, p.h))
    for y in (p.y[0] + 0.18 * p.w, p.y[1] - 0.18 * p.w):
        yield box("foot", DARK, (p.x[0] + 0.04, p.x[1] - 0.04), (y - 0.035, y + 0.035), (0.0, 0.025))
        yield box("column", DARK, (-0.04, 0.04), (y - 0.03, y + 0.03), (0.025, 0.6 * p.h))
        yield box("rod", STEEL, (-0.03, 0.03), (y - 0.022, y + 0.022), (0.6 * p.h, p.h - 0.03))
    yield box(
        "beam",
        DARK,
        (-0.035, 0.035),
        (p.y[0] + 0.18 * p.w + 0.022, p.y[1] - 0.18 * p.w - 0.022),
        (p.h - 0.09, p.h - 0.031),
    )


def corner_desk(p: Piece) -> Iterator[Part]:
    """Yield an L-shaped desk with its corner at the back right."""
    deep = min(0.7, 0.5 * min(p.d, p.w))
    low = p.h - 0.03
    yield box("top", p.wood, (p.x[0], p.x[0] + deep), p.y, (low, p.h))
    yield box("top", p.wood, (p.x[0] + deep, p.x[1]), (p.y[0], p.y[0] + deep), (low, p.h))
    for x, y in ((p.x[0] + 0.02, p.y[0] + 0.02), (p.x[0] + 0.02, p.y[1] - 0.07), (p.x[0] + deep - 0.07, p.y[1] - 0.07),
                 (p.x[1] - 0.07, p.y[0] + 0.02), (p.x[1] - 0.07, p.y[0] + deep - 0.07)):  # fmt: skip
        yield box("leg", p.dark, (x, x + 0.05), (y, y + 0.05), (0.0, low))


def executive_desk(p: Piece) -> Iterator[Part]:
    """Yield a heavy desk with two pedestals and a closed front."""
    low = p.h - 0.04
    yield board(p, p.dark, (low, p.h))
    for y in ((p.y[0] + 0.03, p.y[0] + 0.48), (p.y[1] - 0.48, p.y[1] - 0.03)):
        yield box("pedestal", p.wood, (p.x[0] + 0.05, p.x[1] - 0.08), y, (0.0, low))
        for i in range(3):
            z = (0.05 + i * (low - 0.07) / 3, 0.04 + (i + 1) * (low - 0.07) / 3)
            yield box("drawer", p.wood, (p.x[1] - 0.08, p.x[1] - 0.06), (y[0] + 0.02, y[1] - 0.02), z)
            middle = (y[0] + y[1]) / 2
            yield box(
                "handle",
                p.metal,
                (p.x[1] - 0.06, p.x[1] - 0.04),
                (middle - 0.06, middle + 0.06),
                (z[1] - 0.06, z[1] - 0.048),
            )
    yield box("front", p.wood, (p.x[0] + 0.07, p.x[0] + 0.09), (p.y[0] + 0.48, p.y[1] - 0.48), (0.1, low))


def reception_desk(p: Piece) -> Iterator[Part]:
    """Yield a counter: visitors stand at +x; a lower desk behind it."""
    wall = 0.42 * p.d
    yield box("front", p.wood, (p.x[1] - wall, p.x[1] - 0.06), (p.y[0] + 0.02, p.y[1] - 0.02), (0.08, p.h - 0.04))
    yield box("plinth", DARK, (p.x[1] - wall, p.x[1] - 0.1), (p.y[0] + 0.05, p.y[1] - 0.05), (0.0, 0.08))
    yield box("counter", p.front, (p.x[1] - wall - 0.02, p.x[1]), p.y, (p.h - 0.04, p.h))
    yield box("band", p.accent, (p.x[1] - 0.06, p.x[1] - 0.045), (p.y[0] + 0.1, p.y[1] - 0.1), (0.5 * p.h, 0.64 * p.h))
    desk_z = 0.66 * p.h
    yield box("desk", p.front, (p.x[0], p.x[1] - wall - 0.021), (p.y[0] + 0.03, p.y[1] - 0.03), (desk_z - 0.03, desk_z))
    for y0 in (p.y[0] + 0.03, p.y[1] - 0.06):
        yield box("side", p.wood, (p.x[0] + 0.02, p.x[1] - wall - 0.001), (y0, y0 + 0.03), (0.0, desk_z - 0.03))
    yield box(
        "screen", DARK, (p.x[1] - wall - 0.1, p.x[1] - wall - 0.08), (-0.24, 0.24), (desk_z + 0.06, p.h + 0.02 - 0.061)
    )


def printer(p: Piece) -> Iterator[Part]:
    """Yield a printer with paper trays."""
    yield soft(
        "casing",
        WHITE if p.variant % 2 else LIGHT_GREY,
        (p.x[0], p.x[1] - 0.08 * p.d),
        p.y,
        (0.0, 0.86 * p.h),
        bevel=0.02,
    )
    yield box("scanner", DARK, (p.x[0] + 0.02, p.x[1] - 0.12 * p.d), (0.94 * p.y[0], 0.94 * p.y[1]), (0.86 * p.h, p.h))
    yield box(
        "slot", BLACK, (p.x[1] - 0.08 * p.d, p.x[1] - 0.06 * p.d), (-0.36 * p.w, 0.36 * p.w), (0.42 * p.h, 0.6 * p.h)
    )
    yield box("paper", PAPER, (p.x[1] - 0.06 * p.d, p.x[1]), (-0.28 * p.w, 0.28 * p.w), (0.44 * p.h, 0.46 * p.h))
    yield box(
        "drawer",
        LIGHT_GREY,
        (p.x[1] - 0.08 * p.d, p.x[1] - 0.05 * p.d),
        (-0.4 * p.w, 0.4 * p.w),
        (0.08 * p.h, 0.34 * p.h),
    )
    yield box(
        "display", GLOW, (p.x[1] - 0.08 * p.d, p.x[1] - 0.06 * p.d), (0.2 * p.w, 0.42 * p.w), (0.66 * p.h, 0.8 * p.h)
    )


def photocopier(p: Piece) -> Iterator[Part]:
    """Yield an office copier with drawers and a panel."""
    yield box("body", LIGHT_GREY, (p.x[0], p.x[1] - 0.06), (0.94 * p.y[0], 0.94 * p.y[1]), (0.04, 0.72 * p.h))
    for i in range(4):
        z = (0.06 + i * 0.13 * p.h, 0.05 + (i + 1) * 0.13 * p.h)
        yield box("drawer", WHITE, (p.x[1] - 0.06, p.x[1] - 0.04), (0.92 * p.y[0], 0.92 * p.y[1]), z)
        yield box("grip", DARK, (p.x[1] - 0.04, p.x[1] - 0.034), (-0.12, 0.12), (z[1] - 0.03, z[1] - 0.015))
    yield box("output", DARK, (p.x[0] + 0.02, p.x[1] - 0.1), (0.9 * p.y[0], 0.9 * p.y[1]), (0.72 * p.h, 0.82 * p.h))
    yield soft("scanner", LIGHT_GREY, (p.x[0], p.x[1] - 0.08), p.y, (0.82 * p.h, 0.93 * p.h), bevel=0.015)
    yield box("feeder", WHITE, (p.x[0] + 0.04, p.x[1] - 0.2), (0.9 * p.y[0], 0.6 * p.y[1]), (0.93 * p.h, p.h))
    yield sheared(
        "panel", DARK, (p.x[1] - 0.08, p.x[1]), (-0.2 * p.w, 0.3 * p.w), (0.86 * p.h, 0.9 * p.h), lean=(-0.02, 0.0)
    )
    yield box("wheels", BLACK, (p.x[0] + 0.05, p.x[1] - 0.12), (0.8 * p.y[0], 0.8 * p.y[1]), (0.0, 0.04))


def computer_tower(p: Piece) -> Iterator[Part]:
    """Yield a computer case."""
    yield soft("case", DARK if p.variant % 2 else LIGHT_GREY, (p.x[0], p.x[1] - 0.012), p.y, (0.015, p.h), bevel=0.01)
    yield box("foot", BLACK, (0.8 * p.x[0], 0.8 * p.x[1]), (0.8 * p.y[0], 0.8 * p.y[1]), (0.0, 0.016))
    yield box("front", BLACK, (p.x[1] - 0.012, p.x[1] - 0.004), (0.8 * p.y[0], 0.8 * p.y[1]), (0.06 * p.h, 0.96 * p.h))
    yield box("drive", LIGHT_GREY, (p.x[1] - 0.004, p.x[1]), (0.7 * p.y[0], 0.7 * p.y[1]), (0.86 * p.h, 0.9 * p.h))
    yield cylinder("power", GLOW, (0.0, 0.78 * p.h), 0.016, (p.x[1] - 0.004, p.x[1]), axis="x", sides=12)


def keyboard(p: Piece) -> Iterator[Part]:
    """Yield a keyboard: rows of keys as bars."""
    yield soft("base", DARK if p.variant % 2 else WHITE, p.x, p.y, (0.0, 0.6 * p.h), bevel=0.004)
    tone = LIGHT_GREY if p.variant % 2 else DARK
    for i in range(5):
        x = p.x[0] + (i + 0.6) * p.d / 5.4
        for j in range(11):
            y = p.y[0] + (j + 0.6) * p.w / 11.4
            if i != 4 or j in (0, 1, 9, 10):
                yield box(
                    "key",
                    tone,
                    (x - 0.065 * p.d, x + 0.065 * p.d),
                    (y - 0.034 * p.w, y + 0.034 * p.w),
                    (0.6 * p.h, p.h),
                )
    yield box(
        "space bar",
        tone,
        (p.x[0] + 4.6 * p.d / 5.4 - 0.065 * p.d, p.x[0] + 4.6 * p.d / 5.4 + 0.065 * p.d),
        (-0.26 * p.w, 0.2 * p.w),
        (0.6 * p.h, p.h),
    )


def mouse(p: Piece) -> Iterator[Part]:
    """Yield a computer mouse."""
    yield ball("mouse", DARK, p.x, p.y, (-0.6 * p.h, p.h), rings=5)
    yield box("wheel", LIGHT_GREY, (-0.28 * p.d, -0.1 * p.d), (-0.05 * p.w, 0.05 * p.w), (0.6 * p.h, 0.98 * p.h))


def laptop(p: Piece) -> Iterator[Part]:
    """Yield an open laptop; its screen faces +x."""
    t = min(0.018, 0.1 * p.h)
    hinge = p.x[0] + 0.16 * p.d
    yield soft("base", STEEL, (hinge, p.x[1]), p.y, (0.0, t), bevel=0.004)
    yield box("keys", DARK, (hinge + 0.08 * p.d, hinge + 0.42 * p.d), (0.9 * p.y[0], 0.9 * p.y[1]), (t, t + 0.002))
    yield box("pad", LIGHT_GREY, (hinge + 0.5 * p.d, p.x[1] - 0.06 * p.d), (-0.16 * p.w, 0.16 * p.w), (t, t + 0.0015))
    lean = -(hinge - p.x[0]) + 0.008
    yield sheared("lid", STEEL, (hinge, hinge + 0.008), p.y, (t, p.h), lean=(lean, 0.0))
    yield sheared(
        "screen",
        GLOW,
        (hinge + 0.008, hinge + 0.0095),
        (0.95 * p.y[0], 0.95 * p.y[1]),
        (t + 0.012, p.h - 0.008),
        lean=(0.93 * lean, 0.0),
    )


def telephone(p: Piece) -> Iterator[Part]:
    """Yield a desk telephone with its handset."""
    yield slab("base", DARK, p.x, p.y, (0.0, 0.6 * p.h), top=(0.8, 0.9))
    yield box("keys", LIGHT_GREY, (-0.1 * p.d, 0.34 * p.d), (0.0, 0.4 * p.w), (0.6 * p.h, 0.64 * p.h))
    for x in (-0.4 * p.d, 0.24 * p.d):
        yield box("ear", BLACK, (x, x + 0.16 * p.d), (-0.44 * p.w, -0.14 * p.w), (0.6 * p.h, 0.82 * p.h))
    yield box("handset", BLACK, (-0.4 * p.d, 0.4 * p.d), (-0.4 * p.w, -0.18 * p.w), (0.82 * p.h, p.h))


def desk_organizer(p: Piece) -> Iterator[Part]:
    """Yield a pot of pens beside a tray."""
    r = min(0.45 * p.d, 0.24 * p.w)
    yield cylinder("pot", p.accent, (0.0, p.y[0] + r), r, (0.0, 0.66 * p.h), sides=14)
    for i in range(4):
        y = p.y[0] + r + (0.4, -0.4, 0.1, -0.1)[i] * r
        x = (0.3, 0.2, -0.4, 0.0)[i] * r
        yield cylinder("pen", BRIGHT[i], (x, y), 0.004, (0.6 * p.h, p.h * (1.0, 0.9, 0.95, 0.85)[i]), sides=6)
    yield box("tray", p.wood, p.x, (p.y[0] + 2 * r + 0.005, p.y[1]), (0.0, 0.3 * p.h))
    yield box(
        "notes", YELLOW, (-0.3 * p.d, 0.3 * p.d), (p.y[0] + 2 * r + 0.02, p.y[1] - 0.015), (0.3 * p.h, 0.36 * p.h)
    )


def paper_tray(p: Piece) -> Iterator[Part]:
    """Yield stacked letter trays with paper."""
    count = max(1, round(p.h / 0.07))
    for i in range(count):
        z = i * p.h / count
        yield box("tray", DARK, p.x, p.y, (z, z + 0.006))
        yield box(
            "paper",
            PAPER,
            (0.92 * p.x[0], 0.94 * p.x[1]),
            (0.9 * p.y[0], 0.9 * p.y[1]),
            (z + 0.006, z + 0.006 + 0.4 * p.h / count),
        )
        for y0 in (p.y[0], p.y[1] - 0.008):
            yield box("side", DARK, (p.x[0] + 0.001, 0.6 * p.x[1]), (y0, y0 + 0.008), (z + 0.006, z + p.h / count))


def server_rack(p: Piece) -> Iterator[Part]:
    """Yield a rack of servers with lights."""
    yield box("cabinet", BLACK, (p.x[0], p.x[1] - 0.04), p.y, p.z)
    count = max(4, min(20, round(p.h / 0.11)))
    for i in range(count):
        z = (0.06 + i * (p.h - 0.1) / count, 0.05 + (i + 1) * (p.h - 0.1) / count)
        yield box(
            "server", DARK if i % 4 else LIGHT_GREY, (p.x[1] - 0.04, p.x[1] - 0.01), (0.84 * p.y[0], 0.84 * p.y[1]), z
        )
        for j in range(3):
            y = 0.5 * p.y[1] + 0.03 * j
            yield box(
                "light",
                (GREEN, GLOW, YELLOW)[(i + j) % 3],
                (p.x[1] - 0.01, p.x[1]),
                (y, y + 0.012),
                (z[0] + 0.02, z[0] + 0.032),
            )


def water_dispenser(p: Piece) -> Iterator[Part]:
    """Yield a dispenser with a bottle on top."""
    low = 0.68 * p.h
    yield soft("body", WHITE, (p.x[0], p.x[1] - 0.02), p.y, (0.0, low), bevel=0.02)
    yield box("niche", DARK, (p.x[1] - 0.02, p.x[1] - 0.015), (-0.34 * p.w, 0.34 * p.w), (0.5 * low, 0.86 * low))
    for y, tone in ((-0.12 * p.w, BLUE), (0.12 * p.w, RED)):
        yield box("tap", tone, (p.x[1] - 0.015, p.x[1]), (y - 0.02, y + 0.02), (0.74 * low, 0.82 * low))
    r = 0.4 * min(p.d, p.w)
    yield cylinder("neck", GLASS, (0.0, 0.0), (0.4 * r, r), (low, low + 0.08 * p.h), sides=16)
    yield cylinder("bottle", GLASS, (0.0, 0.0), r, (low + 0.08 * p.h, p.h), sides=16)


def shredder(p: Piece) -> Iterator[Part]:
    """Yield a paper shredder on its bin."""
    yield slab(
        "bin", DARK, (0.94 * p.x[0], 0.94 * p.x[1]), (0.94 * p.y[0], 0.94 * p.y[1]), (0.0, 0.76 * p.h), top=(1.04, 1.04)
    )
    yield soft("head", LIGHT_GREY, p.x, p.y, (0.765 * p.h, 0.98 * p.h), bevel=0.015)
    yield box("slot", BLACK, (-0.05 * p.d, 0.05 * p.d), (-0.36 * p.w, 0.36 * p.w), (0.98 * p.h, p.h))
    yield box("window", GLASS, (0.47 * p.d, 0.475 * p.d), (-0.2 * p.w, 0.2 * p.w), (0.2 * p.h, 0.6 * p.h))


def partition(p: Piece) -> Iterator[Part]:
    """Yield a fabric screen in a metal frame on two feet."""
    for y0 in (p.y[0], p.y[1] - 0.03):
        yield box("post", STEEL, (-0.015, 0.015), (y0, y0 + 0.03), (0.02, p.h))
        yield box("foot", STEEL, p.x, (y0, y0 + 0.03), (0.0, 0.02))
    inner = (p.y[0] + 0.03, p.y[1] - 0.03)
    t = min(0.012, 0.3 * p.d)
    yield box("panel", p.fabric, (-t, t), inner, (0.08, 0.7 * p.h))
    yield box("upper panel", p.bedding, (-0.9 * t, 0.9 * t), inner, (0.7 * p.h, p.h - 0.02))
    yield box("rail", STEEL, (-0.013, 0.013), inner, (p.h - 0.02, p.h - 0.001))


def safe(p: Piece) -> Iterator[Part]:
    """Yield a safe with a dial and a handle."""
    yield soft("body", DARK, (p.x[0], p.x[1] - 0.05), p.y, p.z, bevel=0.012)
    yield box(
        "door",
        IVORY if p.variant % 2 else LIGHT_GREY,
        (p.x[1] - 0.05, p.x[1] - 0.035),
        (0.86 * p.y[0], 0.86 * p.y[1]),
        (0.08 * p.h, 0.92 * p.h),
    )
    yield cylinder(
        "dial", BLACK, (-0.08 * p.w, 0.55 * p.h), 0.12 * p.h, (p.x[1] - 0.035, p.x[1] - 0.005), axis="x", sides=16
    )
    yield box("handle", STEEL, (p.x[1] - 0.035, p.x[1]), (0.14 * p.w, 0.34 * p.w), (0.52 * p.h, 0.58 * p.h))


def drafting_table(p: Piece) -> Iterator[Part]:
    """Yield a tilted board on a frame with a sheet of paper."""
    for y0 in (p.y[0] + 0.06, p.y[1] - 0.1):
        yield box("foot", p.metal, (0.9 * p.x[0], 0.9 * p.x[1]), (y0, y0 + 0.04), (0.0, 0.04))
        yield box("post", p.metal, (-0.02, 0.02), (y0 + 0.001, y0 + 0.039), (0.04, 0.76 * p.h))
    for name, tone, inset, lift in (("board", p.wood, 0.0, 0.0), ("sheet", PAPER, 0.1, 0.026)):
        part = box(
            name,
            tone,
            (p.x[0] + inset, p.x[1] - inset),
            (p.y[0] + inset, p.y[1] - inset),
            (0.0, 0.025 if not inset else 0.003),
        )
        part.vertices[:, 2] += 0.66 * p.h + lift + (p.x[1] - part.vertices[:, 0]) / p.d * 0.3 * p.h
        yield part


def pen(p: Piece) -> Iterator[Part]:
    """Yield a pen."""
    r = min(p.w, p.h) / 2
    yield cylinder("barrel", BRIGHT[p.variant % 5], (0.0, r), r, (p.x[0], 0.36 * p.d), axis="x", sides=8)
    yield cylinder("tip", IVORY, (0.0, r), (r, 0.2 * r), (0.36 * p.d, p.x[1]), axis="x", sides=8)


def calculator(p: Piece) -> Iterator[Part]:
    """Yield a calculator with keys."""
    yield soft("case", DARK, p.x, p.y, (0.0, 0.7 * p.h), bevel=0.006)
    yield box("display", GREEN, (0.84 * p.x[0], 0.5 * p.x[0]), (0.8 * p.y[0], 0.8 * p.y[1]), (0.7 * p.h, 0.8 * p.h))
    for i in range(4):
        for j in range(4):
            x, y = (-0.16 + 0.17 * i) * p.d, (-0.3 + 0.2 * j) * p.w
            yield box(
                "key",
                IVORY if j < 3 else RED,
                (x - 0.05 * p.d, x + 0.05 * p.d),
                (y - 0.07 * p.w, y + 0.07 * p.w),
                (0.7 * p.h, p.h),
            )


def stapler(p: Piece) -> Iterator[Part]:
    """Yield a stapler."""
    yield box("foot", DARK, p.x, p.y, (0.0, 0.2 * p.h))
    part = soft(
        "arm", RED, (p.x[0] + 0.002, p.x[1] - 0.004), (0.9 * p.y[0], 0.9 * p.y[1]), (0.24 * p.h, 0.7 * p.h), bevel=0.006
    )
    part.vertices[:, 2] += (part.vertices[:, 0] - p.x[0]) / p.d * 0.3 * p.h
    yield part


def webcam(p: Piece) -> Iterator[Part]:
    """Yield a small camera on a foot."""
    yield cylinder("foot", BLACK, (0.0, 0.0), 0.45 * p.d, (0.0, 0.12 * p.h), sides=12)
    yield cylinder("neck", STEEL, (0.0, 0.0), 0.1 * p.d, (0.12 * p.h, 0.5 * p.h), sides=8)
    yield soft("camera", DARK, (p.x[0], 0.36 * p.d), p.y, (0.46 * p.h, p.h), bevel=0.01)
    yield cylinder("lens", BLACK, (0.0, 0.73 * p.h), 0.18 * p.h, (0.36 * p.d, p.x[1]), axis="x", sides=12)


BUILDERS: dict[str, Builder] = {
    "desk": desk,
    "teacher desk": desk,
    "standing desk": standing_desk,
    "corner desk": corner_desk,
    "executive desk": executive_desk,
    "reception desk": reception_desk,
    "nurse station": reception_desk,
    "printer": printer,
    "photocopier": photocopier,
    "computer tower": computer_tower,
    "keyboard": keyboard,
    "computer mouse": mouse,
    "laptop": laptop,
    "telephone": telephone,
    "desk organizer": desk_organizer,
    "paper tray": paper_tray,
    "server rack": server_rack,
    "water dispenser": water_dispenser,
    "paper shredder": shredder,
    "partition": partition,
    "privacy screen": partition,
    "safe": safe,
    "drafting table": drafting_table,
    "pen": pen,
    "calculator": calculator,
    "stapler": stapler,
    "webcam": webcam,
}
