"""Rugs, mats, curtains."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.furniture._common import Builder
from robolayout.assets.palette import (
    DARK,
    LINEN,
    WHITE,
    Piece,
)  # fmt: skip
from robolayout.assets.part import Part
from robolayout.assets.shapes import box, cylinder, oval, prism

Span = tuple[float, float]


def tapestry(p: Piece) -> Iterator[Part]:
    """Yield a cloth with bands that hangs from a rod, with tassels."""
    yield cylinder("rod", p.wood, (p.h - 0.5 * p.d, 0.0), p.d / 2, p.y, axis="y", sides=8)
    bands = 6
    low = 0.08 * p.h
    for i in range(bands):
        z = (low + i * (p.h - p.d - low) / bands, low + (i + 1) * (p.h - p.d - low) / bands)
        yield box(
            "band", (p.accent, p.bedding, p.fabric)[i % 3], (-0.3 * p.d, 0.3 * p.d), (0.96 * p.y[0], 0.96 * p.y[1]), z
        )
    for i in range(n := max(5, round(p.w / 0.12))):
        y = 0.92 * p.y[0] + i * 0.92 * p.w / (n - 1)
        yield box("tassel", p.bedding, (-0.2 * p.d, 0.2 * p.d), (y - 0.012, y + 0.012), (0.0, low))


def curtain(p: Piece) -> Iterator[Part]:
    """Yield a pair of curtains in folds on a rod, drawn aside."""
    yield cylinder("rod", p.metal, (p.h - 0.02, 0.0), 0.015, p.y, axis="y", sides=8)
    wide = 0.26 * p.w
    for y0 in (p.y[0] + 0.03, p.y[1] - 0.03 - wide):
        folds = max(4, round(wide / 0.07))
        for i in range(folds):
            y = y0 + (i + 0.5) * wide / folds
            yield oval(
                "fold",
                p.bedding,
                (0.0, y),
                ((p.d / 2, 0.5 * wide / folds), (0.34 * p.d, 0.34 * wide / folds)),
                (0.0, p.h - 0.035),
                sides=8,
            )


def blinds(p: Piece) -> Iterator[Part]:
    """Yield slats under a head rail."""
    yield box("head rail", WHITE, p.x, p.y, (p.h - 0.05, p.h))
    for i in range(n := max(6, min(24, round((p.h - 0.07) / 0.055)))):
        z = 0.03 + i * (p.h - 0.09) / n
        slat = box("slat", LINEN, (p.x[0] + 0.008, p.x[1] - 0.008), (p.y[0] + 0.01, p.y[1] - 0.01), (z, z + 0.006))
        slat.vertices[slat.vertices[:, 0] < 0, 2] += 0.02
        yield slat
    yield box("bottom rail", WHITE, (p.x[0] + 0.01, p.x[1] - 0.01), (p.y[0] + 0.01, p.y[1] - 0.01), (0.0, 0.02))


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


def mat(p: Piece) -> Iterator[Part]:
    """Yield a plain mat with a darker border."""
    yield box("border", p.fabric if p.kind != "door mat" else DARK, p.x, p.y, (0.0, 0.8 * p.h))
    b = 0.06 * min(p.d, p.w)
    tone = p.accent if p.kind != "door mat" else p.wood
    yield box("field", tone, (p.x[0] + b, p.x[1] - b), (p.y[0] + b, p.y[1] - b), (0.8 * p.h, p.h))


BUILDERS: dict[str, Builder] = {
    "tapestry": tapestry,
    "curtain": curtain,
    "shower curtain": curtain,
    "blinds": blinds,
    "rug": rug,
    "unknown floor covering": rug,
    "door mat": mat,
    "bath mat": mat,
    "play mat": rug,
    "yoga mat": mat,
    "anti fatigue mat": mat,
}
