"""Cloth, pictures and what is written or pinned on boards."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from robolayout.assets.palette import PLAIN, Piece
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, prism, sheared

Span = tuple[float, float]


def bulletin_board(p: Piece) -> Iterator[Part]:
    """Yield notes pinned on cork."""
    rng, face = p.rng(), p.x[0] + 0.4 * p.d
    columns = max(2, round(p.w / 0.24))
    for i in range(columns):
        y, z = p.y[0] + (i + 0.5) * p.w / columns, p.h * rng.uniform(0.35, 0.62)
        tone = PLAIN[("paper", "yellow", "blue", "paper", "green")[i % 5]]
        yield box("note", tone, (face, face + 0.1 * p.d), (y - 0.07, y + 0.07), (z - 0.1, z + 0.1))
        yield box("pin", PLAIN["red"], (face + 0.1 * p.d, p.x[1]), (y - 0.008, y + 0.008), (z + 0.07, z + 0.086))


def whiteboard(p: Piece) -> Iterator[Part]:
    """Yield lines of writing on a board."""
    rng, face, y = p.rng(), p.x[0] + 0.4 * p.d, -0.36 * p.w
    for i, pen in enumerate(("blue", "red", "blue", "green")):
        z, tone = p.h * (0.78 - 0.13 * i), PLAIN["ivory" if p.kind == "blackboard" else pen]
        line = (y, y + p.w * rng.uniform(0.2, 0.42))
        yield box("writing", tone, (face, face + 0.001 + 0.01 * p.d), line, (z, z + 0.018))


blackboard = whiteboard


def play_tent(p: Piece) -> Iterator[Part]:
    """Yield the poles and the cloth of a tipi with an opening at the front."""
    x, y, tilt = 0.5 * p.d, 0.5 * p.w, 0.86 * p.h
    for sx, sy in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        a, b, thick = sx * 0.48 * p.d, sy * 0.48 * p.w, 0.017 + 0.001 * sx + 0.002 * sy
        reach = ((a - thick, a + thick), (b - thick, b + thick), (0.0, p.h - 0.002 * sx - 0.004 * sy))
        yield sheared("pole", p.palette.wood, *reach, lean=(-a * 1.16, -b * 1.16))
    walls = (((-x, -y), (-x, y)), ((-x, y), (x, y)), ((x, -y), (-x, -y)))
    for ends in (*walls, ((x, y), (x, 0.16 * p.w)), ((x, -0.16 * p.w), (x, -y))):
        yield _cloth(ends, 0.06, tilt)


def _cloth(ends: tuple[Span, Span], high: float, top: float) -> Part:
    """Return a thin panel from two floor points to a small line near the top."""
    part = box("cloth", PLAIN["linen"], (0.0, 1.0), (0.0, 1.0), (0.0, top))
    share, inner, upper = part.vertices[:, 1].copy(), part.vertices[:, 0] > 0.5, part.vertices[:, 2] > 0
    for i in range(2):
        line = ends[0][i] + (ends[1][i] - ends[0][i]) * share
        part.vertices[:, i] = line * (1.0 - 0.02 * inner) * (1.0 - (1.0 - high / 0.5) * upper)
    inside_out = ends[0][0] * ends[1][1] > ends[0][1] * ends[1][0]
    return replace(part, faces=part.faces[:, ::-1].copy()) if inside_out else part


def picture(p: Piece) -> Iterator[Part]:
    """Yield sky, hills and a sun in thin layers, on the mount of a picture."""
    rng = p.rng()
    edge = min(0.03, 0.08 * min(p.w, p.h)) + 0.12 * min(p.w, p.h)
    y, z, x = (p.y[0] + edge, p.y[1] - edge), (edge, p.h - edge), p.x[0] + 0.55 * p.d
    w, h = y[1] - y[0], z[1] - z[0]
    step = 0.06 * p.d
    tones = [*p.palette.accents, *p.palette.fabrics]
    rng.shuffle(tones)
    yield box("sky", tones[0], (x, x + step), y, z)
    cut = z[0] + h * rng.uniform(0.3, 0.5)
    hill = [(y[0], z[0]), (y[1], z[0]), (y[1], cut), (y[0] + 0.6 * w, cut + 0.2 * h), (y[0], cut - 0.1 * h)]
    yield prism("hill", tones[1], hill, (x + step, x + 2 * step), axis="x")
    near = ((0.0, 0.0), (1.0, 0.0), (1.0, 0.12), (0.3, 0.3), (0.0, 0.28))
    outline = [(y[0] + a * w, z[0] + b * h) for a, b in near]
    yield prism("field", tones[2], outline, (x + 2 * step, x + 3 * step), axis="x")
    r = 0.12 * min(w, h)
    at = (y[0] + w * rng.uniform(0.2, 0.75), z[1] - 1.9 * r)
    yield cylinder("sun", tones[3], at, r, (x + step, x + 1.5 * step), axis="x", sides=18)


def photo_frame(p: Piece) -> Iterator[Part]:
    """Yield the picture in a small frame that leans back."""
    for part in picture(replace(p, d=0.02)):
        part.vertices[:, 0] += p.x[1] - 0.02 - (p.d - 0.03) * part.vertices[:, 2] / p.h * 0.5
        yield part
