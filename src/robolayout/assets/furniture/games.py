"""Game rooms."""

from __future__ import annotations

import math
from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, four
from robolayout.assets.palette import (
    BLACK,
    BLUE,
    BRIGHT,
    CERAMIC,
    DARK,
    FELT,
    GLOW,
    GREEN,
    IVORY,
    LINEN,
    ORANGE,
    RED,
    SCREEN,
    STEEL,
    WHITE,
    YELLOW,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, oval, prism, sheared, slab, soft


def pool_table(p: Piece) -> Iterator[Part]:
    """Yield a billiard table: cloth, cushions, pockets, balls and a cue."""
    bed, rail = p.h - 0.05, min(0.13, 0.12 * p.d)
    yield box("slate", FELT, (p.x[0] + rail, p.x[1] - rail), (p.y[0] + rail, p.y[1] - rail), (bed - 0.05, bed))
    for x0 in (p.x[0], p.x[1] - rail):
        yield box("rail", p.dark, (x0, x0 + rail), p.y, (bed - 0.12, p.h - 0.002))
    for y0 in (p.y[0], p.y[1] - rail):
        yield box("rail", p.dark, (p.x[0] + rail, p.x[1] - rail), (y0, y0 + rail), (bed - 0.12, p.h - 0.002))
    yield box("apron", p.dark, (p.x[0] + 0.04, p.x[1] - 0.04), (p.y[0] + 0.04, p.y[1] - 0.04), (0.62 * p.h, bed - 0.12))
    for x in (p.x[0] + rail, p.x[1] - rail):
        for y in (p.y[0] + rail, 0.0, p.y[1] - rail):
            yield cylinder("pocket", BLACK, (x, y), 0.055, (p.h - 0.03, p.h), sides=14)
    legs = Piece(p.d - 0.1, p.w - 0.1, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, 0, p.key)
    yield from four(legs, p.dark, 0.62 * p.h, thick=0.16)
    for row in range(4):
        for i in range(row + 1):
            x, y = (i - row / 2) * 0.058, 0.2 * p.w + row * 0.05
            tone = (*BRIGHT, BLACK, WHITE)[(row * 3 + i) % 8]
            yield ball(
                "ball", tone, (x - 0.028, x + 0.028), (y - 0.028, y + 0.028), (bed, bed + 0.056), rings=3, sides=8
            )
    yield ball(
        "cue ball", WHITE, (0.05, 0.106), (-0.26 * p.w, -0.26 * p.w + 0.056), (bed, bed + 0.056), rings=3, sides=8
    )


def tennis_table(p: Piece) -> Iterator[Part]:
    """Yield a table-tennis table with a net across its middle."""
    net = 0.153
    top = p.h - net
    yield box("top", BLUE, p.x, p.y, (top - 0.03, top))
    line = (top, top + 0.0015)
    for x0 in (p.x[0], p.x[1] - 0.02):
        yield box("line", WHITE, (x0, x0 + 0.02), p.y, line)
    for y0 in (p.y[0], p.y[1] - 0.02):
        yield box("line", WHITE, (p.x[0] + 0.02, p.x[1] - 0.02), (y0, y0 + 0.02), line)
    for y in ((p.y[0] + 0.02, -0.004), (0.004, p.y[1] - 0.02)):
        yield box("line", WHITE, (-0.003, 0.003), y, line)
    yield box("net", DARK, (0.99 * p.x[0], 0.99 * p.x[1]), (-0.003, 0.003), (top + 0.002, p.h - 0.012))
    yield box("net tape", WHITE, p.x, (-0.004, 0.004), (p.h - 0.012, p.h))
    for y in (0.6 * p.y[0], 0.6 * p.y[1]):
        for x in (0.76 * p.x[0], 0.76 * p.x[1]):
            yield box("leg", DARK, (x - 0.025, x + 0.025), (y - 0.025, y + 0.025), (0.0, top - 0.03))
        yield box(
            "stretcher",
            DARK,
            (0.76 * p.x[0] + 0.025, 0.76 * p.x[1] - 0.025),
            (y - 0.015, y + 0.015),
            (0.3 * top, 0.3 * top + 0.04),
        )
    yield cylinder("bat", RED, (0.2 * p.d, 0.3 * p.w), 0.08, (top + 0.002, top + 0.014), sides=16)
    yield ball("ball", ORANGE, (0.0, 0.04), (0.24 * p.w, 0.24 * p.w + 0.04), (top, top + 0.04), rings=3, sides=8)


def foosball(p: Piece) -> Iterator[Part]:
    """Yield a football table; players stand at +x and -x."""
    d, w, h = 0.7 * p.d, p.w, p.h
    low, bed = 0.72 * h, 0.86 * h
    yield box("box", p.wood, (-d / 2, d / 2), p.y, (low, bed))
    yield box("pitch", GREEN, (-d / 2 + 0.04, d / 2 - 0.04), (p.y[0] + 0.05, p.y[1] - 0.05), (bed, bed + 0.003))
    for x0 in (-d / 2, d / 2 - 0.035):
        yield box("side", p.wood, (x0, x0 + 0.035), p.y, (bed, h))
    for y0 in (p.y[0], p.y[1] - 0.045):
        yield box("end", p.wood, (-d / 2 + 0.035, d / 2 - 0.035), (y0, y0 + 0.045), (bed, h - 0.002))
    legs = Piece(d, w, h, p.palette, p.fabric, p.accent, p.bedding, p.kind, 0, p.key)
    yield from four(legs, p.dark, low, thick=0.1, inset=0.03)
    for i in range(8):
        y = p.y[0] + (i + 1) * w / 9
        way = 1 if i % 2 else -1
        z = h - 0.03
        yield cylinder(
            "rod",
            STEEL,
            (y, z),
            0.008,
            (-d / 2 - 0.02 if way < 0 else 0.01 - d / 2, d / 2 - 0.01 if way < 0 else d / 2 + 0.02),
            axis="x",
            sides=6,
        )
        grip = (d / 2 + 0.02, p.x[1]) if way > 0 else (p.x[0], -d / 2 - 0.02)
        yield cylinder("grip", BLACK, (y, z), 0.016, grip, axis="x", sides=8)
        for x in (-0.2 * d, 0.0, 0.2 * d):
            yield box(
                "player",
                RED if way > 0 else BLUE,
                (x - 0.014, x + 0.014),
                (y - 0.012, y + 0.012),
                (bed + 0.02, h - 0.005),
            )


def air_hockey(p: Piece) -> Iterator[Part]:
    """Yield an air-hockey table."""
    bed = 0.94 * p.h
    yield box("surface", WHITE, (0.9 * p.x[0], 0.9 * p.x[1]), (0.95 * p.y[0], 0.95 * p.y[1]), (0.7 * p.h, bed))
    for x0, x1 in ((p.x[0], 0.9 * p.x[0]), (0.9 * p.x[1], p.x[1])):
        yield box("rail", p.accent, (x0, x1), p.y, (0.66 * p.h, p.h))
    for y0, y1 in ((p.y[0], 0.95 * p.y[0]), (0.95 * p.y[1], p.y[1])):
        yield box("rail", p.accent, (0.9 * p.x[0], 0.9 * p.x[1]), (y0, y1), (0.66 * p.h, p.h))
    yield box("line", RED, (0.9 * p.x[0], 0.9 * p.x[1]), (-0.012, 0.012), (bed + 0.001, bed + 0.003))
    yield cylinder("circle", BLUE, (0.0, 0.0), 0.14 * p.d, (bed + 0.0001, bed + 0.001), sides=20)
    for y in (0.6 * p.y[0], 0.5 * p.y[1]):
        yield cylinder("mallet", RED, (0.1 * p.d, y), (0.05, 0.02), (bed, bed + 0.05), sides=14)
    yield cylinder("puck", BLACK, (-0.14 * p.d, 0.1 * p.w), 0.04, (bed, bed + 0.008), sides=14)
    for y in (0.74 * p.y[0], 0.74 * p.y[1]):
        yield slab("leg", DARK, (0.7 * p.x[0], 0.7 * p.x[1]), (y - 0.12, y + 0.12), (0.0, 0.7 * p.h), top=(1.0, 0.6))


def arcade(p: Piece) -> Iterator[Part]:
    """Yield an arcade cabinet: side panels, screen, controls, lit sign."""
    d, h = p.d, p.h
    side = [
        (p.x[0], 0.0),
        (0.5 * d, 0.0),
        (0.5 * d, 0.5 * h),
        (0.1 * d, 0.62 * h),
        (0.0, 0.82 * h),
        (0.22 * d, h),
        (p.x[0], h),
    ]
    for y0 in (p.y[0], p.y[1] - 0.02):
        for points in (
            [*side[:4], (p.x[0], 0.62 * h)],
            [(p.x[0], 0.62 * h), (0.1 * d, 0.62 * h), (0.0, 0.82 * h), (p.x[0], 0.82 * h)],
            [(p.x[0], 0.82 * h), (0.0, 0.82 * h), (0.22 * d, h), (p.x[0], h)],
        ):
            turned = [(z, x) for x, z in points][::-1]
            yield prism("side", p.accent, turned, (y0, y0 + 0.02), axis="y")
    inner = (p.y[0] + 0.02, p.y[1] - 0.02)
    yield box("base", BLACK, (p.x[0] + 0.01, 0.46 * d), inner, (0.0, 0.48 * h))
    yield box("door", DARK, (0.46 * d, 0.465 * d), (0.5 * p.y[0], 0.5 * p.y[1]), (0.12 * h, 0.4 * h))
    controls = box("controls", DARK, (0.08 * d, 0.5 * d), inner, (0.48 * h, 0.52 * h))
    controls.vertices[:, 2] += (0.5 * d - controls.vertices[:, 0]) / d * 0.18 * h
    yield controls
    yield cylinder("stick", RED, (0.3 * d, -0.2 * p.w), 0.014, (0.54 * h, 0.61 * h), sides=8)
    for i in range(4):
        yield cylinder(
            "button",
            BRIGHT[i],
            ((0.24 + 0.08 * (i // 2)) * d, (0.06 + 0.14 * (i % 2)) * p.w),
            0.022,
            (0.54 * h, 0.575 * h),
            sides=10,
        )
    yield box("cabinet", BLACK, (p.x[0] + 0.01, -0.06 * d), inner, (0.48 * h, 0.82 * h))
    yield sheared(
        "screen", GLOW, (0.04 * d, 0.06 * d), (0.78 * p.y[0], 0.78 * p.y[1]), (0.63 * h, 0.81 * h), lean=(-0.1 * d, 0.0)
    )
    yield box("hood", BLACK, (p.x[0] + 0.01, 0.0), inner, (0.82 * h, 0.99 * h))
    yield sheared("sign", YELLOW, (0.0, 0.02), inner, (0.84 * h, 0.98 * h), lean=(0.18 * d, 0.0))


def pinball(p: Piece) -> Iterator[Part]:
    """Yield a pinball machine with a slanted field and a back box."""
    d, h = p.d, p.h
    low = 0.4 * h
    cabinet = box("cabinet", p.accent, (p.x[0] + 0.02, p.x[1] - 0.03), p.y, (low, 0.5 * h))
    rise = cabinet.vertices[:, 2] > 0.45 * h
    cabinet.vertices[rise, 2] += (p.x[1] - cabinet.vertices[rise, 0]) / d * 0.1 * h
    yield cabinet
    field = box(
        "field", GLOW, (p.x[0] + 0.22 * d, p.x[1] - 0.08), (0.86 * p.y[0], 0.86 * p.y[1]), (0.5 * h, 0.5 * h + 0.004)
    )
    field.vertices[:, 2] += (p.x[1] - field.vertices[:, 0]) / d * 0.1 * h + 0.001
    yield field
    for i in range(5):
        x, y = (-0.2 + 0.11 * i) * d, (-0.25, 0.2, 0.0, -0.2, 0.25)[i] * p.w
        z = 0.5 * h + (p.x[1] - x) / d * 0.1 * h
        yield cylinder("bumper", BRIGHT[i], (x, y), 0.035, (z, z + 0.04), sides=12)
    yield box("back box", DARK, (p.x[0], p.x[0] + 0.18 * d), p.y, (0.62 * h, h))
    yield box(
        "picture", ORANGE, (p.x[0] + 0.18 * d, p.x[0] + 0.185 * d), (0.9 * p.y[0], 0.9 * p.y[1]), (0.7 * h, 0.98 * h)
    )
    yield box(
        "score", SCREEN, (p.x[0] + 0.18 * d, p.x[0] + 0.186 * d), (0.7 * p.y[0], 0.7 * p.y[1]), (0.64 * h, 0.69 * h)
    )
    yield box("plunger", STEEL, (p.x[1] - 0.03, p.x[1]), (0.36 * p.w, 0.4 * p.w), (0.46 * h, 0.48 * h))
    yield from four(
        Piece(0.94 * d, p.w, h, p.palette, p.fabric, p.accent, p.bedding, p.kind, 0, p.key), STEEL, low, thick=0.05
    )


def poker_table(p: Piece) -> Iterator[Part]:
    """Yield an oval card table with a padded rim and a place for cards at each seat."""
    top = p.h - 0.002
    yield oval("rim", BLACK, (0.0, 0.0), ((p.d / 2, p.w / 2),) * 2, (top - 0.08, top - 0.01), sides=32)
    yield oval("cloth", FELT, (0.0, 0.0), ((0.41 * p.d, 0.44 * p.w),) * 2, (top - 0.01, p.h), sides=32)
    for y in (-0.24 * p.w, 0.24 * p.w):
        yield cylinder("leg", p.dark, (0.0, y), (0.22 * p.d, 0.1 * p.d), (0.0, top - 0.08), sides=14)
    for i in range(6):
        turn = 2 * math.pi * i / 6
        x, y = 0.26 * p.d * math.cos(turn), 0.3 * p.w * math.sin(turn)
        yield box("place", IVORY, (x - 0.04, x + 0.04), (y - 0.06, y + 0.06), (p.h, p.h + 0.0015))


def chess_table(p: Piece) -> Iterator[Part]:
    """Yield a small table with a chess board in its top."""
    top = p.h - 0.0015
    yield box("top", p.dark, p.x, p.y, (top - 0.03, top))
    yield from four(p, p.dark, top - 0.03, thick=0.05, inset=0.03)
    yield from _squares(0.78 * min(p.d, p.w), top, p.h)


def chess_set(p: Piece) -> Iterator[Part]:
    """Yield a chess board with pieces."""
    board_z = 0.25 * p.h
    yield box("board", p.dark, p.x, p.y, (0.0, board_z))
    yield from _chess(0.9 * min(p.d, p.w), board_z, p.h)


def _squares(side: float, low: float, high: float) -> Iterator[Part]:
    """Yield the light squares of a board."""
    step = side / 8
    for i in range(8):
        for j in range(8):
            if (i + j) % 2 == 0:
                x, y = -side / 2 + i * step, -side / 2 + j * step
                yield box("square", IVORY, (x, x + step), (y, y + step), (low, high))


def _chess(side: float, low: float, high: float) -> Iterator[Part]:
    """Yield light squares and two ranks of men."""
    step = side / 8
    thin = low + 0.0015
    yield from _squares(side, low, thin)
    for i, tone in ((0, BLACK), (1, BLACK), (6, IVORY), (7, IVORY)):
        for j in range(8):
            if (i in (1, 6) and j % 2) or (i in (0, 7) and j % 3 == 2):
                continue
            x, y = -side / 2 + (i + 0.5) * step, -side / 2 + (j + 0.5) * step
            tall = 1.0 if i in (0, 7) and j in (3, 4) else 0.7 if i in (0, 7) else 0.5
            yield cylinder(
                "man", tone, (x, y), (0.34 * step, 0.12 * step), (thin, thin + tall * (high - thin)), sides=8
            )


def dart_board(p: Piece) -> Iterator[Part]:
    """Yield a dart board with rings."""
    r = min(p.w, p.h) / 2
    rows = ((1.0, BLACK), (0.8, IVORY), (0.62, RED), (0.56, IVORY), (0.3, GREEN), (0.12, RED))
    for i, (share, tone) in enumerate(rows):
        x = (p.x[0] + (0.5 * p.d if i else 0.0) + 0.04 * (i - 1) * p.d * (i > 0), p.x[0] + (0.5 + 0.04 * i) * p.d)
        yield cylinder("ring", tone, (0.0, p.h / 2), share * r, x, axis="x", sides=28)
    for y, z in ((0.1, 0.12), (-0.16, 0.05), (0.04, -0.2)):
        yield cylinder(
            "dart", YELLOW, (y * p.w, (0.5 + z) * p.h), (0.004, 0.012), (p.x[0] + 0.6 * p.d, p.x[1]), axis="x", sides=6
        )


def basketball_hoop(p: Piece) -> Iterator[Part]:
    """Yield a hoop with a board on a post."""
    yield box("foot", DARK, (p.x[0], 0.1 * p.d), (0.7 * p.y[0], 0.7 * p.y[1]), (0.0, 0.12))
    yield box("post", STEEL, (p.x[0] + 0.08, p.x[0] + 0.15), (-0.035, 0.035), (0.12, 0.94 * p.h))
    yield box("board", WHITE, (p.x[0] + 0.16, p.x[0] + 0.19), p.y, (0.74 * p.h, p.h))
    yield box("mark", RED, (p.x[0] + 0.19, p.x[0] + 0.193), (-0.16, 0.16), (0.8 * p.h, 0.92 * p.h))
    ring = min(0.22, 0.4 * (p.d - 0.2))
    x = p.x[1] - ring
    for i in range(12):
        turn = 2 * math.pi * i / 12
        at = (x + 0.95 * ring * math.cos(turn), 0.95 * ring * math.sin(turn))
        yield cylinder(
            "ring", ORANGE, at, 0.05 * ring + 0.02, (0.78 * p.h - 0.001 * (i % 2), 0.8 * p.h - 0.001 * (i % 2)), sides=6
        )
        yield cylinder("net", LINEN, (x + (at[0] - x) * 0.9, at[1] * 0.9), 0.005, (0.6 * p.h, 0.78 * p.h), sides=4)
    yield box("bracket", ORANGE, (p.x[0] + 0.19, x - 0.8 * ring), (-0.04, 0.04), (0.775 * p.h, 0.795 * p.h))


def vr_station(p: Piece) -> Iterator[Part]:
    """Yield a computer stand with a screen and a headset."""
    yield box("foot", DARK, p.x, p.y, (0.0, 0.03))
    yield box("column", DARK, (p.x[0] + 0.1, p.x[0] + 0.3), (-0.2, 0.2), (0.03, 0.62 * p.h))
    yield box("shelf", p.wood, (p.x[0] + 0.06, 0.2 * p.d), (0.8 * p.y[0], 0.8 * p.y[1]), (0.62 * p.h, 0.645 * p.h))
    yield box("casing", BLACK, (p.x[0] + 0.12, p.x[0] + 0.15), (0.9 * p.y[0], 0.9 * p.y[1]), (0.7 * p.h, p.h))
    yield box("screen", GLOW, (p.x[0] + 0.15, p.x[0] + 0.153), (0.86 * p.y[0], 0.86 * p.y[1]), (0.72 * p.h, 0.98 * p.h))
    yield box("mount", DARK, (p.x[0] + 0.11, p.x[0] + 0.14), (-0.04, 0.04), (0.645 * p.h, 0.7 * p.h))
    yield soft("headset", CERAMIC, (0.0, 0.14), (-0.1, 0.1), (0.645 * p.h, 0.645 * p.h + 0.1), bevel=0.03)


def cue_rack(p: Piece) -> Iterator[Part]:
    """Yield a rack with billiard cues."""
    for z in (0.06, 0.7):
        yield box("rail", p.dark, p.x, p.y, (z * p.h, z * p.h + 0.06 * p.h))
    yield box("back", p.dark, (p.x[0], p.x[0] + 0.2 * p.d), (0.3 * p.y[0], 0.3 * p.y[1]), (0.12 * p.h, 0.7 * p.h))
    for i in range(6):
        y = p.y[0] + (i + 0.5) * p.w / 6
        for z in ((0.0, 0.06), (0.12, 0.7), (0.76, 1.0)):
            yield cylinder(
                "cue",
                p.wood,
                (0.1 * p.d, y),
                (0.011 - 0.004 * z[0], 0.011 - 0.004 * z[1]),
                (z[0] * p.h, z[1] * p.h),
                sides=8,
            )


BUILDERS: dict[str, Builder] = {
    "pool table": pool_table,
    "table tennis table": tennis_table,
    "foosball table": foosball,
    "air hockey table": air_hockey,
    "arcade machine": arcade,
    "pinball machine": pinball,
    "poker table": poker_table,
    "chess table": chess_table,
    "chess set": chess_set,
    "dart board": dart_board,
    "basketball hoop": basketball_hoop,
    "vr station": vr_station,
    "cue rack": cue_rack,
}
