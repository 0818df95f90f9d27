"""Sport indoors."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder
from robolayout.assets.palette import (
    BLACK,
    DARK,
    GLOW,
    GREY,
    LIGHT_GREY,
    RED,
    STEEL,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, sheared, soft


def treadmill(p: Piece) -> Iterator[Part]:
    """Yield a treadmill; the runner looks to +x."""
    yield box("deck", DARK, p.x, (0.86 * p.y[0], 0.86 * p.y[1]), (0.0, 0.14))
    yield box("belt", BLACK, (0.97 * p.x[0], 0.56 * p.x[1]), (0.62 * p.y[0], 0.62 * p.y[1]), (0.14, 0.15))
    yield soft(
        "motor", LIGHT_GREY, (0.56 * p.x[1], 0.98 * p.x[1]), (0.84 * p.y[0], 0.84 * p.y[1]), (0.14, 0.26), bevel=0.03
    )
    for y0 in (p.y[0], p.y[1] - 0.06):
        yield sheared(
            "post",
            LIGHT_GREY,
            (0.7 * p.x[1], 0.7 * p.x[1] + 0.07),
            (y0, y0 + 0.06),
            (0.1, p.h - 0.1),
            lean=(-0.06 * p.d, 0.0),
        )
        yield box("arm", DARK, (0.14 * p.x[1], 0.66 * p.x[1]), (y0 + 0.002, y0 + 0.058), (0.74 * p.h, 0.78 * p.h))
    yield sheared(
        "console",
        DARK,
        (0.5 * p.x[1], 0.56 * p.x[1]),
        (0.84 * p.y[0], 0.84 * p.y[1]),
        (0.78 * p.h, p.h),
        lean=(0.1, 0.0),
    )
    yield sheared(
        "screen",
        GLOW,
        (0.485 * p.x[1], 0.5 * p.x[1] - 0.001),
        (0.5 * p.y[0], 0.5 * p.y[1]),
        (0.84 * p.h, 0.97 * p.h),
        lean=(0.06, 0.0),
    )


def exercise_bike(p: Piece) -> Iterator[Part]:
    """Yield a stationary bicycle that faces +x."""
    for x in (0.84 * p.x[0], 0.8 * p.x[1]):
        yield box("foot", DARK, (x - 0.04, x + 0.04), p.y, (0.0, 0.06))
    yield box("beam", DARK, (0.84 * p.x[0] + 0.04, 0.8 * p.x[1] - 0.04), (-0.04, 0.04), (0.04, 0.1))
    yield cylinder("flywheel", STEEL, (0.32 * p.h, 0.28 * p.d), 0.2 * p.h, (-0.04, 0.04), axis="y", sides=22)
    yield sheared(
        "front post",
        p.accent,
        (0.26 * p.d, 0.33 * p.d),
        (-0.03, 0.03),
        (0.46 * p.h, 0.86 * p.h),
        lean=(0.06 * p.d, 0.0),
    )
    yield sheared(
        "seat post", p.accent, (-0.16 * p.d, -0.1 * p.d), (-0.028, 0.028), (0.1, 0.68 * p.h), lean=(-0.08 * p.d, 0.0)
    )
    yield sheared(
        "frame", p.accent, (-0.1 * p.d, -0.02 * p.d), (-0.026, 0.026), (0.1, 0.5 * p.h), lean=(0.3 * p.d, 0.0)
    )
    yield soft(
        "saddle",
        BLACK,
        (p.x[0] + 0.12 * p.d, -0.08 * p.d),
        (-0.28 * p.w, 0.28 * p.w),
        (0.68 * p.h, 0.74 * p.h),
        bevel=0.03,
    )
    yield box("handle bar", BLACK, (0.22 * p.d, 0.44 * p.d), (0.86 * p.y[0], 0.86 * p.y[1]), (0.86 * p.h, 0.89 * p.h))
    yield sheared(
        "screen", GLOW, (0.36 * p.d, 0.39 * p.d), (-0.24 * p.w, 0.24 * p.w), (0.89 * p.h, p.h), lean=(0.05, 0.0)
    )
    for side in (-1, 1):
        yield box("crank", STEEL, (-0.02, 0.02), (side * 0.08 - 0.012, side * 0.08 + 0.012), (0.2 * p.h, 0.38 * p.h))
        z = 0.2 * p.h - 0.004 if side > 0 else 0.34 * p.h
        yield box("pedal", DARK, (-0.05, 0.05), (side * 0.14 - 0.05, side * 0.14 + 0.05), (z, z + 0.025))


def elliptical(p: Piece) -> Iterator[Part]:
    """Yield a cross trainer."""
    yield box("beam", DARK, (0.9 * p.x[0], 0.9 * p.x[1]), (-0.05, 0.05), (0.02, 0.1))
    for x in (0.9 * p.x[0], 0.84 * p.x[1]):
        yield box("foot", DARK, (x - 0.05, x + 0.05), p.y, (0.0, 0.06))
    yield cylinder("flywheel", p.accent, (0.28 * p.h, 0.28 * p.d), 0.2 * p.h, (-0.06, 0.06), axis="y", sides=22)
    yield sheared(
        "mast", LIGHT_GREY, (0.24 * p.d, 0.3 * p.d), (-0.04, 0.04), (0.46 * p.h, 0.9 * p.h), lean=(0.02 * p.d, 0.0)
    )
    yield box("screen", GLOW, (0.22 * p.d, 0.25 * p.d), (-0.14, 0.14), (0.86 * p.h, 0.98 * p.h))
    for side in (-1, 1):
        y = side * 0.32 * p.w
        rail = box("rail", STEEL, (-0.42 * p.d, 0.28 * p.d), (y - 0.02, y + 0.02), (0.12 * p.h, 0.15 * p.h))
        rail.vertices[rail.vertices[:, 0] > 0, 2] += (0.1 + 0.08 * side) * p.h
        yield rail
        yield soft(
            "pedal", BLACK, (-0.28 * p.d, -0.04 * p.d), (y - 0.07, y + 0.07), (0.2 * p.h, 0.235 * p.h), bevel=0.01
        )
        yield sheared(
            "lever",
            STEEL,
            (0.2 * p.d, 0.23 * p.d),
            (y - 0.016, y + 0.016),
            (0.3 * p.h, p.h),
            lean=(-0.06 * p.d - 0.05 * side * p.d, 0.0),
        )


def rowing(p: Piece) -> Iterator[Part]:
    """Yield a rowing machine: rail, sliding seat, fan."""
    yield box("rail", STEEL, (p.x[0], 0.2 * p.d), (-0.05, 0.05), (0.5 * p.h, 0.62 * p.h))
    for x in (0.94 * p.x[0], 0.24 * p.d):
        yield box("foot", DARK, (x - 0.04, x + 0.04), (0.8 * p.y[0], 0.8 * p.y[1]), (0.0, 0.08 * p.h))
        yield box("post", DARK, (x - 0.03, x + 0.03), (-0.04, 0.04), (0.08 * p.h, 0.5 * p.h))
    yield soft("seat", BLACK, (-0.2 * p.d, -0.06 * p.d), (-0.3 * p.w, 0.3 * p.w), (0.66 * p.h, 0.8 * p.h), bevel=0.03)
    yield box("carriage", DARK, (-0.17 * p.d, -0.09 * p.d), (-0.07, 0.07), (0.621 * p.h, 0.67 * p.h))
    yield cylinder(
        "fan", DARK, (0.5 * p.h, p.x[1] - 0.46 * p.h), 0.46 * p.h, (-0.36 * p.w, 0.36 * p.w), axis="y", sides=22
    )
    for y in (-0.34 * p.w, 0.34 * p.w):
        yield sheared(
            "foot plate",
            p.accent,
            (0.2 * p.d, 0.23 * p.d),
            (y - 0.06, y + 0.06),
            (0.3 * p.h, 0.76 * p.h),
            lean=(0.06, 0.0),
        )
    yield cylinder("handle", BLACK, (0.86 * p.h, 0.2 * p.d), 0.018, p.y, axis="y", sides=8)
    yield box("arm", DARK, (0.3 * p.d, 0.32 * p.d), (-0.02, 0.02), (0.8 * p.h, p.h))


def weights(p: Piece, y: float, x: float, z: float, r: float) -> Iterator[Part]:
    """Yield two discs on a bar's end; y is the inner side."""
    way = 1 if y > 0 else -1
    for i, share in enumerate((1.0, 0.8)):
        a = y + way * i * 0.05
        yield cylinder(
            "plate",
            (DARK, p.accent)[i],
            (z, x),
            share * r,
            (min(a, a + way * 0.045), max(a, a + way * 0.045)),
            axis="y",
            sides=20,
        )


def weight_bench(p: Piece) -> Iterator[Part]:
    """Yield a bench with a barbell on its rack; the head is at the back."""
    seat = 0.42 * p.h
    yield soft("bench", BLACK, (p.x[0] + 0.16, p.x[1]), (-0.24 * p.w, 0.24 * p.w), (seat - 0.07, seat), bevel=0.025)
    yield box("spine", p.accent, (p.x[0] + 0.1, p.x[1] - 0.1), (-0.03, 0.03), (seat - 0.12, seat - 0.071))
    for x in (p.x[0] + 0.1, p.x[1] - 0.14):
        yield box("foot", DARK, (x - 0.03, x + 0.03), (-0.36 * p.w, 0.36 * p.w), (0.0, 0.05))
        yield box("post", DARK, (x - 0.025, x + 0.025), (-0.03, 0.03), (0.05, seat - 0.12))
    for y in (-0.34 * p.w, 0.34 * p.w):
        yield box("rack", p.accent, (p.x[0] + 0.08, p.x[0] + 0.12), (y - 0.025, y + 0.025), (0.05, 0.86 * p.h))
    r = 0.14 * p.h
    z = p.h - r
    yield cylinder("bar", STEEL, (z, p.x[0] + 0.14), 0.014, p.y, axis="y", sides=8)
    for side in (-1, 1):
        yield from weights(p, side * 0.38 * p.w, p.x[0] + 0.14, z, r)


def dumbbell(p: Piece) -> Iterator[Part]:
    """Yield a dumbbell along x."""
    r = min(p.w, p.h) / 2
    yield cylinder("grip", STEEL, (0.0, r), 0.3 * r, (-0.3 * p.d, 0.3 * p.d), axis="x", sides=10)
    for x in ((p.x[0], -0.24 * p.d), (0.24 * p.d, p.x[1])):
        yield cylinder("head", DARK, (0.0, r), r, x, axis="x", sides=8)


def dumbbell_rack(p: Piece) -> Iterator[Part]:
    """Yield two or three shelves of dumbbells."""
    rows = max(2, round(p.h / 0.4))
    for y0 in (p.y[0], p.y[1] - 0.05):
        yield box("side", DARK, (p.x[0], p.x[0] + 0.06), (y0, y0 + 0.05), (0.05, p.h))
        yield box("foot", DARK, p.x, (y0, y0 + 0.05), (0.0, 0.05))
    for i in range(rows):
        z = 0.2 * p.h + i * 0.7 * p.h / rows
        x = (p.x[0] + 0.02 + 0.0, p.x[1] - 0.12 * i)
        shelf = box("shelf", GREY, (x[0] + 0.04, x[1]), (p.y[0] + 0.05, p.y[1] - 0.05), (z - 0.02, z))
        yield shelf
        count = max(3, round(p.w / 0.16))
        for j in range(count):
            y = p.y[0] + 0.05 + (j + 0.5) * (p.w - 0.1) / count
            r = 0.045 + 0.02 * j / count
            yield cylinder("grip", STEEL, (y, z + r), 0.018, (x[0] + 0.12, x[1] - 0.1), axis="x", sides=8)
            for a in ((x[0] + 0.06, x[0] + 0.15), (x[1] - 0.13, x[1] - 0.03)):
                yield cylinder("head", (DARK, p.accent)[j % 2], (y, z + r), r, a, axis="x", sides=8)


def squat_rack(p: Piece) -> Iterator[Part]:
    """Yield a cage with a loaded barbell."""
    half = 0.36 * p.w
    for x in (p.x[0], p.x[1] - 0.07):
        for y in (-half, half - 0.07):
            yield box("post", DARK, (x, x + 0.07), (y, y + 0.07), (0.0, p.h))
        for z in (0.02, p.h - 0.07):
            yield box("cross bar", DARK, (x + 0.002, x + 0.068), (-half + 0.07, half - 0.07), (z, z + 0.06))
    for y in (-half, half - 0.07):
        for z in (0.02, p.h - 0.07):
            yield box("side bar", p.accent, (p.x[0] + 0.07, p.x[1] - 0.07), (y + 0.002, y + 0.068), (z, z + 0.06))
    z, x = 0.66 * p.h, p.x[1] - 0.02
    yield cylinder("bar", STEEL, (z, x - 0.1), 0.016, p.y, axis="y", sides=8)
    for side in (-1, 1):
        yield box(
            "hook",
            STEEL,
            (x - 0.13, x - 0.051),
            (side * (half - 0.035) - 0.03, side * (half - 0.035) + 0.03),
            (z - 0.05, z - 0.017),
        )
        yield from weights(p, side * 0.4 * p.w, x - 0.1, z, 0.2)


def weight_machine(p: Piece) -> Iterator[Part]:
    """Yield a multi-gym: weight stack, seat, pull bar."""
    yield box("base", DARK, p.x, (0.7 * p.y[0], 0.7 * p.y[1]), (0.0, 0.06))
    for y in (-0.24, 0.24):
        yield box("post", p.accent, (p.x[0] + 0.04, p.x[0] + 0.12), (y - 0.04, y + 0.04), (0.06, p.h - 0.06))
    yield box("beam", p.accent, (p.x[0], 0.24 * p.d), (-0.28, 0.28), (p.h - 0.06, p.h))
    for i in range(9):
        z = 0.1 + i * 0.06
        yield box("weight", DARK, (p.x[0] + 0.02, p.x[0] + 0.16), (-0.18, 0.18), (z, z + 0.054))
    yield box("rod", STEEL, (p.x[0] + 0.08, p.x[0] + 0.1), (-0.012, 0.012), (0.64, p.h - 0.06))
    yield soft("seat", BLACK, (-0.02 * p.d, 0.3 * p.d), (-0.2, 0.2), (0.44, 0.52), bevel=0.02)
    yield box("seat post", DARK, (0.1 * p.d, 0.16 * p.d), (-0.04, 0.04), (0.06, 0.44))
    yield soft("back", BLACK, (-0.14 * p.d, -0.08 * p.d), (-0.18, 0.18), (0.56, 1.2), bevel=0.02)
    yield box("back post", DARK, (p.x[0] + 0.16, -0.14 * p.d), (-0.04, 0.04), (0.9, 0.98))
    yield cylinder("cable", STEEL, (0.2 * p.d, 0.0), 0.006, (0.84 * p.h, p.h - 0.06), sides=5)
    yield cylinder("pull bar", BLACK, (0.84 * p.h, 0.2 * p.d), 0.016, p.y, axis="y", sides=8)
    for y in (-0.36 * p.w, 0.36 * p.w):
        yield box("press arm", STEEL, (-0.1 * p.d, 0.2 * p.d), (y - 0.02, y + 0.02), (0.98, 1.02))
    yield box("press bar", STEEL, (-0.11 * p.d, -0.1 * p.d), (-0.38 * p.w, 0.38 * p.w), (0.97, 1.03))


def punching_bag(p: Piece) -> Iterator[Part]:
    """Yield a boxing bag on a round foot, or hanging from chains."""
    r = min(p.d, p.w) / 2
    yield cylinder("foot", DARK, (0.0, 0.0), (r, 0.8 * r), (0.0, 0.12 * p.h), sides=20)
    yield cylinder("spring", STEEL, (0.0, 0.0), 0.3 * r, (0.12 * p.h, 0.26 * p.h), sides=12)
    yield cylinder("bag", RED, (0.0, 0.0), 0.8 * r, (0.26 * p.h, 0.94 * p.h), sides=18)
    yield cylinder("band", BLACK, (0.0, 0.0), 0.82 * r, (0.62 * p.h, 0.68 * p.h), sides=18)
    yield cylinder("top", BLACK, (0.0, 0.0), (0.8 * r, 0.5 * r), (0.94 * p.h, p.h), sides=18)


def wall_bars(p: Piece) -> Iterator[Part]:
    """Yield gymnastics bars."""
    for y0 in (p.y[0], p.y[1] - 0.04):
        yield box("post", p.wood, p.x, (y0, y0 + 0.04), p.z)
    count = max(4, min(16, round(p.h / 0.16)))
    for i in range(count):
        z = (i + 0.5) * p.h / count
        yield cylinder("bar", p.wood, (z, p.x[1] - 0.03), 0.018, (p.y[0] + 0.04, p.y[1] - 0.04), axis="y", sides=8)


def plyo_box(p: Piece) -> Iterator[Part]:
    """Yield a jump box with a grip hole."""
    yield box("box", p.wood, (p.x[0], p.x[1] - 0.003), p.y, p.z)
    yield soft("hole", BLACK, (p.x[1] - 0.01, p.x[1]), (-0.12 * p.w, 0.12 * p.w), (0.68 * p.h, 0.74 * p.h), bevel=0.012)


def sit_up_bench(p: Piece) -> Iterator[Part]:
    """Yield a slanted bench with foot rollers."""
    seat = soft("bench", BLACK, (p.x[0], 0.3 * p.d), (-0.3 * p.w, 0.3 * p.w), (0.3 * p.h, 0.4 * p.h), bevel=0.03)
    seat.vertices[:, 2] += (seat.vertices[:, 0] - p.x[0]) / p.d * 0.4 * p.h
    yield seat
    for x, tall in ((0.8 * p.x[0], 0.32 * p.h), (0.2 * p.d, 0.56 * p.h)):
        yield box("foot", DARK, (x - 0.03, x + 0.03), p.y, (0.0, 0.05))
        yield box("post", p.accent, (x - 0.025, x + 0.025), (-0.03, 0.03), (0.05, tall))
    yield box("arm", p.accent, (0.3 * p.d, 0.44 * p.d), (-0.03, 0.03), (0.6 * p.h, 0.66 * p.h))
    yield box("post", p.accent, (0.4 * p.d, 0.44 * p.d), (-0.029, 0.029), (0.661 * p.h, 0.92 * p.h))
    for z in (0.74, 0.92):
        yield cylinder(
            "roller", BLACK, (z * p.h, 0.44 * p.d), 0.06 * p.h, (-0.36 * p.w, 0.36 * p.w), axis="y", sides=12
        )


BUILDERS: dict[str, Builder] = {
    "treadmill": treadmill,
    "exercise bike": exercise_bike,
    "elliptical trainer": elliptical,
    "rowing machine": rowing,
    "weight bench": weight_bench,
    "dumbbell": dumbbell,
    "dumbbell rack": dumbbell_rack,
    "squat rack": squat_rack,
    "weight machine": weight_machine,
    "punching bag": punching_bag,
    "wall bars": wall_bars,
    "plyo box": plyo_box,
    "hyperextension bench": sit_up_bench,
}
