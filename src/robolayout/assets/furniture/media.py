"""Television, sound and music."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, doors, four
from robolayout.assets.palette import BLACK, BRASS, CERAMIC, DARK, GLOW, IVORY, RED, SCREEN, STEEL, WHITE, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import ball, box, cylinder, prism, sheared, soft


def television(p: Piece) -> Iterator[Part]:
    """Yield a flat screen: with two feet where the box is deep enough to stand, else flat on the wall."""
    thin = min(0.045, 0.8 * p.d)
    stands = p.d > 0.12
    low = 0.08 * p.h if stands else 0.0
    x = (-thin / 2, thin / 2) if stands else (p.x[0] + 0.3 * p.d, p.x[1])
    yield soft("casing", BLACK, (x[0], x[1] - 0.004), p.y, (low, p.h), bevel=0.008)
    b = 0.015
    yield box("screen", SCREEN, (x[1] - 0.004, x[1]), (p.y[0] + b, p.y[1] - b), (low + b, p.h - b))
    if not stands:
        yield box("mount", DARK, (p.x[0], x[0]), (-0.2 * p.w, 0.2 * p.w), (0.3 * p.h, 0.7 * p.h))
        return
    for y in (-0.3 * p.w, 0.3 * p.w):
        yield box("foot", DARK, p.x, (y - 0.012, y + 0.012), (0.0, 0.012))
        yield box("neck", DARK, (-0.012, 0.012), (y - 0.011, y + 0.011), (0.012, low + 0.006))


def monitor(p: Piece) -> Iterator[Part]:
    """Yield a computer monitor on a stand."""
    low = 0.24 * p.h
    yield box("foot", DARK, (p.x[0], p.x[1]), (-0.2 * p.w, 0.2 * p.w), (0.0, 0.012))
    yield box("neck", STEEL, (-0.3 * p.d, -0.18 * p.d), (-0.03, 0.03), (0.012, 0.62 * p.h))
    yield soft("casing", DARK, (-0.18 * p.d, 0.02 * p.d), p.y, (low, p.h), bevel=0.008)
    b = 0.012
    yield box("screen", GLOW, (0.02 * p.d, 0.04 * p.d), (p.y[0] + b, p.y[1] - b), (low + b, p.h - b))


def tv_stand(p: Piece) -> Iterator[Part]:
    """Yield a low board: doors outside, an open compartment with a box in the middle."""
    leg = 0.2 * p.h
    yield from four(p, p.dark, leg, thick=0.04, inset=0.05, round_=True)
    yield box("top", p.wood, p.x, p.y, (p.h - 0.025, p.h))
    yield box("bottom", p.wood, (p.x[0], p.x[1] - 0.022), p.y, (leg, leg + 0.022))
    third, z = p.w / 3, (leg + 0.022, p.h - 0.026)
    inset = 0.042
    for y in ((p.y[0], p.y[0] + third), (p.y[1] - third, p.y[1])):
        yield box("body", p.wood, (p.x[0], p.x[1] - inset), y, z)
        yield from doors(p, p.front, y, z, count=1)
    yield box("back", p.wood, (p.x[0], p.x[0] + 0.012), (-third / 2, third / 2), z)
    yield soft(
        "player", BLACK, (p.x[0] + 0.06, p.x[1] - 0.08), (-0.18, 0.18), (z[0], z[0] + min(0.06, 0.3 * p.h)), bevel=0.006
    )


def speaker(p: Piece) -> Iterator[Part]:
    """Yield a loudspeaker with two or three cones."""
    yield box("cabinet", p.wood, (p.x[0], p.x[1] - 0.02), p.y, (0.02, p.h))
    yield box("foot", BLACK, (p.x[0] + 0.01, p.x[1] - 0.03), (p.y[0] + 0.01, p.y[1] - 0.01), (0.0, 0.02))
    yield box("front", DARK, (p.x[1] - 0.02, p.x[1] - 0.008), (p.y[0] + 0.008, p.y[1] - 0.008), (0.03, p.h - 0.01))
    for share, r in ((0.86, 0.16), (0.62, 0.34), (0.3, 0.38)):
        radius = min(r * p.w, 0.12 * p.h)
        yield cylinder(
            "cone",
            STEEL if share > 0.8 else BLACK,
            (0.0, share * p.h),
            (radius, 0.9 * radius),
            (p.x[1] - 0.008, p.x[1]),
            axis="x",
        )


def soundbar(p: Piece) -> Iterator[Part]:
    """Yield a long low loudspeaker."""
    yield soft("bar", DARK, (p.x[0], p.x[1] - 0.006), p.y, p.z, bevel=0.012)
    yield box("grille", BLACK, (p.x[1] - 0.006, p.x[1]), (p.y[0] + 0.02, p.y[1] - 0.02), (0.15 * p.h, 0.85 * p.h))


def slim_box(p: Piece) -> Iterator[Part]:
    """Yield a flat electronic box with a light."""
    colour = WHITE if p.variant % 2 else DARK
    yield soft("casing", colour, (p.x[0], p.x[1] - 0.002), p.y, p.z, bevel=0.15 * p.h)
    yield box("slot", BLACK, (p.x[1] - 0.004, p.x[1] - 0.001), (-0.35 * p.w, 0.1 * p.w), (0.45 * p.h, 0.6 * p.h))
    yield box("light", GLOW, (p.x[1] - 0.004, p.x[1]), (0.25 * p.w, 0.3 * p.w), (0.45 * p.h, 0.6 * p.h))


def record_player(p: Piece) -> Iterator[Part]:
    """Yield a turntable with a record and an arm."""
    yield soft("plinth", p.wood, p.x, p.y, (0.0, 0.6 * p.h), bevel=0.008)
    r = 0.42 * min(p.d, p.w)
    yield cylinder("platter", DARK, (0.0, -0.06 * p.w), r, (0.6 * p.h, 0.72 * p.h), sides=24)
    yield cylinder("record", BLACK, (0.0, -0.06 * p.w), 0.96 * r, (0.72 * p.h, 0.76 * p.h), sides=24)
    yield cylinder("label", RED, (0.0, -0.06 * p.w), 0.3 * r, (0.76 * p.h, 0.78 * p.h), sides=14)
    yield cylinder("pivot", STEEL, (-0.34 * p.d, 0.4 * p.w), 0.02, (0.6 * p.h, p.h), sides=8)
    yield box("arm", STEEL, (-0.34 * p.d, 0.16 * p.d), (0.36 * p.w, 0.38 * p.w), (0.86 * p.h, 0.92 * p.h))


def radio(p: Piece) -> Iterator[Part]:
    """Yield a table radio with a grille and two dials."""
    yield soft("case", p.wood, (p.x[0], p.x[1] - 0.01), p.y, (0.0, 0.92 * p.h), bevel=0.02)
    yield box("grille", p.bedding, (p.x[1] - 0.01, p.x[1] - 0.004), (p.y[0] + 0.03, 0.1 * p.w), (0.12 * p.h, 0.8 * p.h))
    for z in (0.28, 0.62):
        yield cylinder("dial", IVORY, (0.3 * p.w, z * p.h), 0.1 * p.h, (p.x[1] - 0.01, p.x[1]), axis="x", sides=12)
    yield box("handle", p.metal, (-0.012, 0.012), (-0.3 * p.w, 0.3 * p.w), (0.93 * p.h, p.h))


def projector(p: Piece) -> Iterator[Part]:
    """Yield a projector: a low casing with a lens, on a ceiling plate."""
    yield soft("casing", WHITE, (p.x[0], p.x[1] - 0.03), p.y, (0.0, 0.75 * p.h), bevel=0.02)
    yield cylinder("lens", BLACK, (0.22 * p.w, 0.38 * p.h), (0.26 * p.h, 0.22 * p.h), (p.x[1] - 0.03, p.x[1]), axis="x")
    yield cylinder("mount", STEEL, (0.0, 0.0), 0.03, (0.75 * p.h, 0.94 * p.h), sides=10)
    yield box("plate", STEEL, (-0.07, 0.07), (-0.07, 0.07), (0.94 * p.h, p.h))


def projection_screen(p: Piece) -> Iterator[Part]:
    """Yield a rolled-down screen in its case."""
    case = min(0.09, 0.1 * p.h)
    yield soft("case", WHITE, p.x, p.y, (p.h - case, p.h), bevel=0.015)
    yield box("border", BLACK, (-0.004, 0.0), (p.y[0] + 0.03, p.y[1] - 0.03), (0.02, p.h - case))
    yield box("cloth", WHITE, (0.0, 0.004), (p.y[0] + 0.07, p.y[1] - 0.07), (0.06, p.h - case - 0.05))
    yield cylinder("weight", DARK, (0.01, 0.0), 0.01, (p.y[0] + 0.03, p.y[1] - 0.03), axis="y", sides=8)


def _keys(p: Piece, x: tuple[float, float], half: float, z: float) -> Iterator[Part]:
    """Yield a keyboard: one white bed, black keys in groups."""
    yield box("white keys", IVORY, x, (-half, half), (z, z + 0.015))
    count = int(2 * half / 0.024)
    for i in range(count):
        if i % 7 not in (2, 6):
            y = -half + (i + 1) * 0.024
            yield box(
                "black key", BLACK, (x[0], x[0] + 0.6 * (x[1] - x[0])), (y - 0.006, y + 0.006), (z + 0.015, z + 0.024)
            )


def piano(p: Piece) -> Iterator[Part]:
    """Yield an upright piano; its keys face +x."""
    wood = p.dark if p.variant % 2 else BLACK
    key = 0.58 * p.h
    body = p.x[0] + 0.52 * p.d
    yield box("body", wood, (p.x[0] + 0.001, body), (p.y[0] + 0.02, p.y[1] - 0.02), (0.06, p.h - 0.03))
    yield box("lid", wood, (p.x[0], body + 0.01), p.y, (p.h - 0.029, p.h))
    for y0 in (p.y[0] + 0.001, p.y[1] - 0.051):
        yield box("cheek", wood, (body + 0.001, p.x[1] - 0.01), (y0, y0 + 0.05), (key - 0.06, key + 0.1))
        yield box("leg", wood, (p.x[1] - 0.09, p.x[1] - 0.03), (y0 + 0.002, y0 + 0.048), (0.06, key - 0.06))
        yield box("foot", wood, (p.x[0] + 0.02, p.x[1]), (y0 + 0.001, y0 + 0.049), (0.0, 0.058))
    yield box("key bed", wood, (body + 0.001, p.x[1] - 0.005), (p.y[0] + 0.052, p.y[1] - 0.052), (key - 0.06, key))
    yield from _keys(p, (body + 0.03, p.x[1] - 0.02), p.w / 2 - 0.08, key)
    yield box("music rest", p.wood, (body + 0.002, body + 0.02), (-0.3, 0.3), (key + 0.12, min(key + 0.34, p.h - 0.05)))
    for i in range(2):
        yield box("pedal", BRASS, (body + 0.001, body + 0.09), (-0.07 + 0.1 * i, -0.04 + 0.1 * i), (0.05, 0.065))


def grand_piano(p: Piece) -> Iterator[Part]:
    """Yield a grand piano; its keys face +x, its lid is open."""
    low, top = 0.58 * p.h, 0.86 * p.h
    d, w = p.d, p.w
    outline = [
        (0.28 * d, -0.5 * w),
        (0.28 * d, 0.5 * w),
        (-0.1 * d, 0.48 * w),
        (-0.4 * d, 0.14 * w),
        (-0.5 * d, -0.2 * w),
        (-0.46 * d, -0.5 * w),
    ]
    inner = [(0.9 * x, 0.94 * y) for x, y in outline]
    yield prism("case", BLACK, outline, (low, top - 0.004))
    yield prism("strings", BRASS, inner, (top - 0.004, top))
    yield box("key bed", BLACK, (0.281 * d, p.x[1]), (-0.5 * w, 0.5 * w), (low, low + 0.07))
    yield from _keys(p, (0.33 * d, 0.48 * d), 0.44 * w, low + 0.07)
    lid = prism("lid", BLACK, outline, (top + 0.004, top + 0.03))
    lid.vertices[:, 2] += (lid.vertices[:, 1] + 0.5 * w) / w * (p.h - top - 0.03)
    yield lid
    for x, y in ((0.22 * d, -0.42 * w), (0.22 * d, 0.42 * w), (-0.38 * d, -0.24 * w)):
        yield cylinder("leg", BLACK, (x, y), (0.03, 0.05), (0.0, low), sides=10)


def digital_piano(p: Piece) -> Iterator[Part]:
    """Yield an electronic keyboard on a crossed stand."""
    top = p.h - 0.1
    for y in (-0.3 * p.w, 0.3 * p.w):
        for way in (1, -1):
            yield sheared(
                "strut",
                DARK,
                (-way * 0.4 * p.d, -way * 0.4 * p.d + 0.03),
                (y + way * 0.016 - 0.015, y + way * 0.016 + 0.014),
                (0.0, top),
                lean=(way * 0.7 * p.d, 0.0),
            )
    yield soft("casing", DARK, p.x, p.y, (top, top + 0.07), bevel=0.015)
    yield from _keys(p, (0.02 * p.d, 0.46 * p.d), 0.46 * p.w, top + 0.07)
    yield box("panel", GLOW, (-0.3 * p.d, -0.14 * p.d), (-0.1, 0.1), (top + 0.07, top + 0.075))
    yield box("rest", BLACK, (-0.44 * p.d, -0.42 * p.d), (-0.2, 0.2), (top + 0.069, p.h))


def guitar(p: Piece) -> Iterator[Part]:
    """Yield a guitar that leans on a small stand."""
    for low, tall, half in ((0.06, 0.3, 0.5), (0.26, 0.5, 0.38)):
        yield cylinder(
            "body",
            p.wood,
            (0.0, (low + tall) / 2 * p.h),
            (half * p.w, half * p.w * 0.98),
            (-(0.6 - low) * 0.26 * p.d, (0.6 - low) * 0.26 * p.d),
            axis="x",
            sides=18,
        )
    yield cylinder("hole", BLACK, (0.0, 0.36 * p.h), 0.12 * p.w, (0.14 * p.d, 0.15 * p.d), axis="x", sides=14)
    yield box("neck", p.dark, (0.152 * p.d, 0.2 * p.d), (-0.06 * p.w, 0.06 * p.w), (0.42 * p.h, 0.9 * p.h))
    yield box("head", p.dark, (0.14 * p.d, 0.2 * p.d), (-0.1 * p.w, 0.1 * p.w), (0.9 * p.h, p.h))
    for y in (-0.2 * p.w, 0.2 * p.w):
        yield sheared(
            "stand", p.metal, (p.x[1] - 0.02, p.x[1]), (y - 0.01, y + 0.01), (0.0, 0.5 * p.h), lean=(-(p.d - 0.04), 0.0)
        )


def drum_set(p: Piece) -> Iterator[Part]:
    """Yield a drum kit: bass, toms, snare, two cymbals; it is played from the back."""
    shell = p.accent
    r = 0.26 * p.w
    yield cylinder("bass drum", shell, (0.0, r), r, (-0.02 * p.d, 0.38 * p.d), axis="x", sides=24)
    yield cylinder("bass head", IVORY, (0.0, r), 0.92 * r, (0.38 * p.d, 0.39 * p.d), axis="x", sides=24)
    for x, y, size, low, high in (
        (0.12, -0.16, 0.11, 0.52, 0.66),
        (0.12, 0.16, 0.11, 0.52, 0.66),
        (-0.2, 0.3, 0.13, 0.4, 0.52),
        (-0.2, -0.3, 0.14, 0.22, 0.5),
    ):
        at = (x * p.d, y * p.w)
        yield cylinder("drum", shell, at, size * p.w, (low * p.h, high * p.h), sides=20)
        yield cylinder("head", IVORY, at, 0.94 * size * p.w, (high * p.h, high * p.h + 0.01), sides=20)
        yield cylinder("stand", STEEL, at, 0.015, (0.0, low * p.h), sides=6)
    for y in (-0.36 * p.w, 0.36 * p.w):
        yield cylinder("stand", STEEL, (0.24 * p.d, y), 0.012, (0.0, 0.95 * p.h), sides=6)
        yield cylinder("cymbal", BRASS, (0.24 * p.d, y), (0.14 * p.w, 0.02), (0.95 * p.h, p.h), sides=20)
    yield cylinder("throne", BLACK, (-0.4 * p.d, 0.0), 0.1 * p.d, (0.34 * p.h, 0.4 * p.h), sides=16)
    yield cylinder("throne leg", STEEL, (-0.4 * p.d, 0.0), 0.02, (0.0, 0.34 * p.h), sides=6)


def music_stand(p: Piece) -> Iterator[Part]:
    """Yield a music stand with a sheet."""
    for x, y in ((0.5, 0.0), (-0.5, 0.5), (-0.5, -0.5)):
        yield sheared(
            "foot",
            BLACK,
            (x * (p.d - 0.02) - 0.01, x * (p.d - 0.02) + 0.01),
            (y * (p.w - 0.02) - 0.01, y * (p.w - 0.02) + 0.01),
            (0.0, 0.25 * p.h + 0.004 * (y + 2 * x)),
            lean=(-x * (p.d - 0.03), -y * (p.w - 0.03)),
        )
    yield cylinder("column", BLACK, (0.0, 0.0), 0.011, (0.22 * p.h, 0.74 * p.h), sides=8)
    yield sheared("desk", DARK, (0.03, 0.04), (-0.46 * p.w, 0.46 * p.w), (0.7 * p.h, p.h), lean=(0.1, 0.0))
    yield sheared("sheet", WHITE, (0.041, 0.044), (-0.3 * p.w, 0.3 * p.w), (0.74 * p.h, 0.97 * p.h), lean=(0.078, 0.0))


def remote(p: Piece) -> Iterator[Part]:
    """Yield a remote control."""
    yield soft("casing", BLACK, p.x, p.y, (0.0, 0.8 * p.h), bevel=0.006)
    for i in range(4):
        x = p.x[0] + (i + 0.8) * p.d / 5
        yield box(
            "button", (RED, DARK, DARK, STEEL)[i], (x - 0.008, x + 0.008), (-0.25 * p.w, 0.25 * p.w), (0.8 * p.h, p.h)
        )


def phone(p: Piece) -> Iterator[Part]:
    """Yield a flat device with a screen."""
    yield soft("casing", DARK, p.x, p.y, (0.0, 0.85 * p.h), bevel=0.003)
    yield box(
        "screen",
        GLOW,
        (p.x[0] + 0.06 * p.d, p.x[1] - 0.06 * p.d),
        (p.y[0] + 0.06 * p.w, p.y[1] - 0.06 * p.w),
        (0.85 * p.h, p.h),
    )


def globe(p: Piece) -> Iterator[Part]:
    """Yield a globe on a foot."""
    yield cylinder("foot", p.wood, (0.0, 0.0), (0.36 * p.d, 0.3 * p.d), (0.0, 0.06 * p.h), sides=18)
    yield cylinder("stem", BRASS, (0.0, 0.0), 0.03 * p.d, (0.06 * p.h, 0.3 * p.h), sides=8)
    r = min(p.d, p.w, 0.84 * p.h) / 2
    yield ball("globe", p.bedding, (-r, r), (-r, r), (p.h - 2 * r, p.h), rings=6, sides=14)
    yield box("meridian", BRASS, (-0.01, 0.01), (p.y[0] - 0.002, p.y[1] + 0.002), (p.h - r - 0.006, p.h - r + 0.006))
    yield box("axis", BRASS, p.x, (-0.009, 0.009), (p.h - r - 0.005, p.h - r + 0.005))


def jukebox(p: Piece) -> Iterator[Part]:
    """Yield a jukebox with a rounded, lit top."""
    yield box("body", p.dark, (p.x[0], p.x[1] - 0.06), p.y, (0.0, 0.62 * p.h))
    yield cylinder(
        "arch",
        p.dark,
        (0.0, 0.62 * p.h),
        (p.w / 2 - 0.002, p.w / 2 - 0.002),
        (p.x[0] + 0.002, p.x[1] - 0.062),
        axis="x",
        sides=24,
    )
    yield cylinder("window", GLOW, (0.0, 0.64 * p.h), 0.36 * p.w, (p.x[1] - 0.061, p.x[1] - 0.02), axis="x", sides=24)
    for y, tone in ((-0.4 * p.w, RED), (0.4 * p.w, RED)):
        yield box("light", tone, (p.x[1] - 0.06, p.x[1]), (y - 0.05, y + 0.05), (0.04, 0.6 * p.h))
    yield box("grille", BRASS, (p.x[1] - 0.06, p.x[1] - 0.01), (-0.3 * p.w, 0.3 * p.w), (0.06, 0.36 * p.h))
    yield box("keys", CERAMIC, (p.x[1] - 0.06, p.x[1] - 0.005), (-0.28 * p.w, 0.28 * p.w), (0.4 * p.h, 0.46 * p.h))


BUILDERS: dict[str, Builder] = {
    "television": television,
    "monitor": monitor,
    "patient monitor": monitor,
    "tv stand": tv_stand,
    "speaker": speaker,
    "soundbar": soundbar,
    "game console": slim_box,
    "router": slim_box,
    "record player": record_player,
    "radio": radio,
    "projector": projector,
    "projection screen": projection_screen,
    "piano": piano,
    "grand piano": grand_piano,
    "digital piano": digital_piano,
    "guitar": guitar,
    "drum set": drum_set,
    "music stand": music_stand,
    "remote control": remote,
    "cell phone": phone,
    "tablet computer": phone,
    "globe": globe,
    "jukebox": jukebox,
}
