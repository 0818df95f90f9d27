"""Cloth, pictures, keys and toys whose pieces are no plain blocks."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder, four
from robolayout.assets.palette import BRIGHT, PLAIN, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, prism, sheared

Span = tuple[float, float]


def whiteboard(p: Piece) -> Iterator[Part]:
    """Yield a board with frame, tray and some writing: white, black or cork."""
    dark, cork = p.kind == "blackboard", p.kind == "bulletin board"
    field = PLAIN["slate"] if dark else PLAIN["cork"] if cork else PLAIN["white"]
    frame = p.wood if dark or cork else PLAIN["steel"]
    back, b = p.x[0] + 0.4 * p.d, 0.03
    yield box("board", field, (p.x[0], back), (p.y[0] + b, p.y[1] - b), (b, p.h - b))
    for y in ((p.y[0], p.y[0] + b), (p.y[1] - b, p.y[1])):
        yield box("frame", frame, (p.x[0], back + 0.004), y, p.z)
    for z in ((0.0, b), (p.h - b, p.h)):
        yield box("frame", frame, (p.x[0], back + 0.004), (p.y[0] + b, p.y[1] - b), z)
    if not cork:
        yield box("tray", frame, (back + 0.004, p.x[1]), (-0.3 * p.w, 0.3 * p.w), (0.004, 0.02))
    yield from _notes(p, back, cork, dark)


def _notes(p: Piece, face: float, cork: bool, dark: bool) -> Iterator[Part]:
    """Yield notes pinned on cork, or lines of writing."""
    rng = p.rng()
    if cork:
        columns = max(2, round(p.w / 0.24))
        for i in range(columns):
            y, z = p.y[0] + (i + 0.5) * p.w / columns, p.h * rng.uniform(0.35, 0.62)
            tone = (PLAIN["paper"], PLAIN["yellow"], PLAIN["blue"], PLAIN["paper"], PLAIN["green"])[i % 5]
            yield box("note", tone, (face, face + 0.1 * p.d), (y - 0.07, y + 0.07), (z - 0.1, z + 0.1))
            yield box("pin", PLAIN["red"], (face + 0.1 * p.d, p.x[1]), (y - 0.008, y + 0.008), (z + 0.07, z + 0.086))
        return
    for i in range(4):
        z = p.h * (0.78 - 0.13 * i)
        y0 = -0.36 * p.w
        yield box(
            "writing",
            PLAIN["ivory"] if dark else (PLAIN["blue"], PLAIN["red"], PLAIN["blue"], PLAIN["green"])[i],
            (face, face + 0.001 + 0.01 * p.d),
            (y0, y0 + p.w * rng.uniform(0.2, 0.42)),
            (z, z + 0.018),
        )


def pinball(p: Piece) -> Iterator[Part]:
    """Yield a pinball machine with a slanted field and a back box."""
    d, h = p.d, p.h
    low = 0.4 * h
    cabinet = box("cabinet", p.accent, (p.x[0] + 0.02, p.x[1] - 0.03), p.y, (low, 0.5 * h))
    rise = cabinet.vertices[:, 2] > 0.45 * h
    cabinet.vertices[rise, 2] += (p.x[1] - cabinet.vertices[rise, 0]) / d * 0.1 * h
    yield cabinet
    field = box(
        "field",
        PLAIN["glow"],
        (p.x[0] + 0.22 * d, p.x[1] - 0.08),
        (0.86 * p.y[0], 0.86 * p.y[1]),
        (0.5 * h, 0.5 * h + 0.004),
    )
    field.vertices[:, 2] += (p.x[1] - field.vertices[:, 0]) / d * 0.1 * h + 0.001
    yield field
    for i in range(5):
        x, y = (-0.2 + 0.11 * i) * d, (-0.25, 0.2, 0.0, -0.2, 0.25)[i] * p.w
        z = 0.5 * h + (p.x[1] - x) / d * 0.1 * h
        yield cylinder("bumper", BRIGHT[i], (x, y), 0.035, (z, z + 0.04), sides=12)
    yield box("back box", PLAIN["anthracite"], (p.x[0], p.x[0] + 0.18 * d), p.y, (0.62 * h, h))
    yield box(
        "picture",
        PLAIN["orange"],
        (p.x[0] + 0.18 * d, p.x[0] + 0.185 * d),
        (0.9 * p.y[0], 0.9 * p.y[1]),
        (0.7 * h, 0.98 * h),
    )
    yield box(
        "score",
        PLAIN["screen"],
        (p.x[0] + 0.18 * d, p.x[0] + 0.186 * d),
        (0.7 * p.y[0], 0.7 * p.y[1]),
        (0.64 * h, 0.69 * h),
    )
    yield box("plunger", PLAIN["steel"], (p.x[1] - 0.03, p.x[1]), (0.36 * p.w, 0.4 * p.w), (0.46 * h, 0.48 * h))
    yield from four(
        Piece(0.94 * d, p.w, h, p.palette, p.fabric, p.accent, p.bedding, p.kind, 0, p.key),
        PLAIN["steel"],
        low,
        thick=0.05,
    )


def play_tent(p: Piece) -> Iterator[Part]:
    """Yield a tipi with an opening at the front, poles and a flag line."""
    low, high = 0.5, 0.06
    tilt = 0.86 * p.h

    def corner(sx: int, sy: int) -> tuple[float, float]:
        return (sx * (low - 0.02) * p.d, sy * (low - 0.02) * p.w)

    for sx, sy in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        x, y = corner(sx, sy)
        lean, thick = (-x * 1.16, -y * 1.16), 0.017 + 0.001 * sx + 0.002 * sy
        yield sheared(
            "pole",
            p.wood,
            (x - thick, x + thick),
            (y - thick, y + thick),
            (0.0, p.h - 0.002 * sx - 0.004 * sy),
            lean=lean,
        )
    for axis in (0, 1, 2):
        rows = {
            0: ((-low * p.d, -low * p.w), (-low * p.d, low * p.w)),
            1: ((-low * p.d, low * p.w), (low * p.d, low * p.w)),
            2: ((low * p.d, -low * p.w), (-low * p.d, -low * p.w)),
        }[axis]
        yield _cloth(p, rows, high, tilt)
    flap = ((low * p.d, low * p.w), (low * p.d, 0.16 * p.w))
    yield _cloth(p, flap, high, tilt)
    yield _cloth(p, ((low * p.d, -0.16 * p.w), (low * p.d, -low * p.w)), high, tilt)
    yield cylinder("cushion", p.accent, (0.0, 0.0), 0.26 * p.d, (0.0, 0.06), sides=16)


def _cloth(p: Piece, ends: tuple[tuple[float, float], tuple[float, float]], high: float, top: float) -> Part:
    """Return a thin panel from two floor points to a small line near the top."""
    part = box("cloth", PLAIN["linen"], (0.0, 1.0), (0.0, 1.0), (0.0, top))
    share, inner, upper = part.vertices[:, 1].copy(), part.vertices[:, 0] > 0.5, part.vertices[:, 2] > 0
    for i in range(2):
        line = ends[0][i] + (ends[1][i] - ends[0][i]) * share
        part.vertices[:, i] = line * (1.0 - 0.02 * inner) * (1.0 - (1.0 - high / 0.5) * upper)
    if (ends[0][0] * ends[1][1] - ends[0][1] * ends[1][0]) > 0:
        return Part(part.name, part.vertices, part.faces[:, ::-1].copy(), part.material)
    return part


def stairs(p: Piece) -> Iterator[Part]:
    """Yield a flight of stairs that rises towards the back, with a handrail."""
    climb = p.h - 0.9 if p.h > 1.6 else p.h
    count = max(3, round(climb / 0.19))
    rise = climb / count
    for i in range(count):
        x = (p.x[1] - (i + 1) * p.d / count, p.x[1] - i * p.d / count)
        yield box("step", p.wood, x, p.y, (max(0.0, i * rise - 0.12), (i + 1) * rise))
    post = min(0.1, p.d / count, 0.2 * p.w)
    for side in (p.y[0], p.y[1] - post):
        top = (count - 1) * rise - 0.12
        yield box("post", p.wood, (p.x[0], p.x[0] + post), (side, side + post), (0.0, max(top, 0.01)))
    if p.h > 1.6:
        rail = box("hand rail", p.dark, p.x, (p.y[1] - 0.05, p.y[1] - 0.005), (0.0, 0.05))
        rail.vertices[:, 2] += 0.85 + (p.x[1] - rail.vertices[:, 0]) / p.d * (p.h - 0.9)
        yield rail
        for i in range(0, count, 2):
            x = p.x[1] - (i + 0.5) * p.d / count
            low = (i + 1) * rise
            yield box(
                "baluster",
                p.metal,
                (x - 0.012, x + 0.012),
                (p.y[1] - 0.04, p.y[1] - 0.016),
                (low, 0.86 + (p.x[1] - x) / p.d * (p.h - 0.9)),
            )


def rug(p: Piece) -> Iterator[Part]:
    """Yield a rug: border, field, and a pattern; round where depth and width are equal."""
    t = p.h
    if abs(p.d - p.w) < 0.05 and p.variant % 2:
        for i, tone in enumerate((p.fabric, p.bedding, p.accent)):
            yield cylinder(
                "ring",
                tone,
                (0.0, 0.0),
                (1.0 - 0.28 * i) * p.d / 2,
                ((0.0, 0.72, 0.86)[i] * t, (0.72 + 0.14 * i) * t),
                sides=40,
            )
        return
    yield box("border", p.fabric, p.x, p.y, (0.0, 0.6 * t))
    b = 0.08 * min(p.d, p.w)
    yield box("field", p.bedding, (p.x[0] + b, p.x[1] - b), (p.y[0] + b, p.y[1] - b), (0.6 * t, 0.75 * t))
    yield from _pattern(p, 1.6 * b)


def _pattern(p: Piece, inset: float) -> Iterator[Part]:
    """Yield stripes, diamonds or an inner frame on a rug."""
    z = (0.75 * p.h, p.h)
    style = p.variant % 3
    if style == 0:
        for i in range(7):
            y = p.y[0] + inset + (i + 0.5) * (p.w - 2 * inset) / 7
            yield box(
                "stripe",
                (p.accent, p.fabric)[i % 2],
                (p.x[0] + inset, p.x[1] - inset),
                (y - 0.02 * p.w, y + 0.02 * p.w),
                z,
            )
        return
    if style == 1:
        for i in range(n := max(2, round(p.w / p.d * 2))):
            y, r = p.y[0] + (i + 0.5) * p.w / n, 0.3 * p.w / n
            yield prism(
                "diamond", (p.accent, p.fabric)[i % 2], [(0.3 * p.d, y), (0.0, y + r), (-0.3 * p.d, y), (0.0, y - r)], z
            )
        return
    yield box(
        "inner", p.accent, (p.x[0] + inset, p.x[1] - inset), (p.y[0] + inset, p.y[1] - inset), (0.75 * p.h, 0.88 * p.h)
    )
    far = inset + 0.04 * min(p.d, p.w)
    yield box("centre", p.bedding, (p.x[0] + far, p.x[1] - far), (p.y[0] + far, p.y[1] - far), (0.88 * p.h, p.h))


def picture(p: Piece) -> Iterator[Part]:
    """Yield a framed picture: an abstract landscape in the room's colours."""
    b = min(0.03, 0.08 * min(p.w, p.h))
    frame = (p.wood, PLAIN["black"], p.dark, PLAIN["white"])[p.variant % 4]
    back = p.x[0] + 0.55 * p.d
    for y in ((p.y[0], p.y[0] + b), (p.y[1] - b, p.y[1])):
        yield box("frame", frame, p.x, y, p.z)
    for z in ((0.0, b), (p.h - b, p.h)):
        yield box("frame", frame, p.x, (p.y[0] + b, p.y[1] - b), z)
    inner, level = (p.y[0] + b, p.y[1] - b), (b, p.h - b)
    yield box("mount", PLAIN["paper"], (p.x[0], back), inner, level)
    m = 0.12 * min(p.w, p.h)
    yield from _artwork(p, (inner[0] + m, inner[1] - m), (level[0] + m, level[1] - m), back)


def _artwork(p: Piece, y: Span, z: Span, x: float) -> Iterator[Part]:
    """Yield sky, hills and a sun, or bands of colour, in thin layers."""
    rng = p.rng()
    w, h = y[1] - y[0], z[1] - z[0]
    step = 0.06 * p.d
    tones = [*p.palette.accents, *p.palette.fabrics]
    rng.shuffle(tones)
    yield box("sky", tones[0], (x, x + step), y, z)
    cut = z[0] + h * rng.uniform(0.3, 0.5)
    hill = [(y[0], z[0]), (y[1], z[0]), (y[1], cut), (y[0] + 0.6 * w, cut + 0.2 * h), (y[0], cut - 0.1 * h)]
    yield prism("hill", tones[1], hill, (x + step, x + 2 * step), axis="x")
    near = [
        (y[0], z[0]),
        (y[1], z[0]),
        (y[1], z[0] + 0.12 * h),
        (y[0] + 0.3 * w, z[0] + 0.3 * h),
        (y[0], z[0] + 0.28 * h),
    ]
    yield prism("field", tones[2], near, (x + 2 * step, x + 3 * step), axis="x")
    r = 0.12 * min(w, h)
    at = (y[0] + w * rng.uniform(0.2, 0.75), z[1] - 1.9 * r)
    yield cylinder("sun", tones[3], at, r, (x + step, x + 1.5 * step), axis="x", sides=18)


def photo_frame(p: Piece) -> Iterator[Part]:
    """Yield a small standing picture."""
    small = Piece(0.02, p.w, p.h, p.palette, p.fabric, p.accent, p.bedding, p.kind, p.variant, p.key)
    for part in picture(small):
        part.vertices[:, 0] += p.x[1] - 0.02 - (p.d - 0.03) * part.vertices[:, 2] / p.h * 0.5
        yield part
    yield box("stay", PLAIN["anthracite"], (p.x[0], p.x[1] - 0.04), (-0.01, 0.01), (0.0, 0.3 * p.h))


BUILDERS: dict[str, Builder] = {
    "whiteboard": whiteboard,
    "blackboard": whiteboard,
    "bulletin board": whiteboard,
    "pinball machine": pinball,
    "play tent": play_tent,
    "stairs": stairs,
    "rug": rug,
    "unknown floor covering": rug,
    "play mat": rug,
    "picture": picture,
    "unknown wall decor": picture,
    "photo frame": photo_frame,
}
