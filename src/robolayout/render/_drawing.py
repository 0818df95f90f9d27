"""A drawing on paper as a list of commands, and its three forms: SVG, Pillow picture, PDF.

Lengths are paper millimetres, x to the right and y down. The commands are few (shapes and text), so that all three
forms show the same drawing.
"""

from __future__ import annotations

import io
import math
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from functools import lru_cache
from importlib.util import find_spec
from itertools import pairwise
from pathlib import Path
from typing import Any, Literal
from unicodedata import east_asian_width

from PIL import Image, ImageChops, ImageDraw, ImageFont
from PIL.ImageColor import getrgb

from robolayout._text import html, printable
from robolayout.render._style import PLAN
from robolayout.render.palette import PAPER

Point = tuple[float, float]
Anchor = Literal["start", "middle", "end"]

BEYOND_ASCII = "\u00a9\u00ab\u00b0\u00b1\u00b4\u00b7\u00bb\u2018\u2019\u201c\u201d\u2026\u2039\u203a\u2044\u2122"
"""Characters of Pillow's own font beside ASCII."""


@dataclass(frozen=True)
class Shape:
    """Rings or lines with one style."""

    # point lists in millimetres; of a filled shape, later rings may be holes (even-odd rule)
    rings: tuple[tuple[Point, ...], ...]
    fill: str | None = None  # sRGB hex colour, or None
    stroke: str | None = None  # sRGB hex colour, or None
    width: float = 0.18  # line width, millimetres
    dash: tuple[float, float] | None = None  # lengths of dash and gap in millimetres, or None
    opacity: float = 1.0  # opacity of the fill
    closed: bool = True  # whether the rings are closed
    title: str = ""  # shown when the pointer rests on it (SVG)


@dataclass(frozen=True)
class Text:
    """One line of text."""

    at: Point  # millimetres; the anchor horizontally, the middle of the capitals vertically
    text: str  # the words
    size: float  # font size, millimetres
    color: str = "#222222"  # sRGB hex colour
    anchor: Anchor = "middle"  # which end is at the point
    angle: float = 0.0  # degrees counter-clockwise
    halo: str | None = None  # colour of the outline that keeps it readable, or None


Item = Shape | Text


@dataclass
class Drawing:
    """A sheet and what is drawn on it, from back to front."""

    width: float  # millimetres
    height: float  # millimetres
    items: list[Shape | Text] = field(default_factory=list[Shape | Text])  # shapes and texts

    def polygon(self, rings: Iterable[Iterable[Point]], fill: str | None, **style: object) -> None:
        """Add a closed shape."""
        self.items.append(Shape(_rings(rings), fill=fill, **style))  # type: ignore[arg-type]

    def line(self, points: Iterable[Point], stroke: str, **style: object) -> None:
        """Add an open line."""
        self.items.append(Shape(_rings([points]), stroke=stroke, closed=False, **style))  # type: ignore[arg-type]

    def words(self, at: Point, text: str, size: float, **style: object) -> None:
        """Add a line of text."""
        self.items.append(Text(at, text, size, **style))  # type: ignore[arg-type]

    def svg(self) -> str:
        """Return the drawing as SVG text, to scale in millimetres."""
        w, h = _number(self.width), _number(self.height)
        rows = [
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}mm" height="{h}mm" viewBox="0 0 {w} {h}"'
            " font-family=\"Helvetica, Arial, 'Liberation Sans', 'DejaVu Sans', sans-serif\">",
            f'<rect width="{w}" height="{h}" fill="{PAPER}"/>',
            *(_svg_text(item) if isinstance(item, Text) else _svg_shape(item) for item in self.items),
        ]
        return "\n".join([*rows, "</svg>", ""])

    def pdf(self) -> bytes:
        """Return the drawing as a PDF page of its own size, to scale."""
        from robolayout.render._pdf import draw_pdf

        return draw_pdf(self)

    def image(self, width: int = 1200) -> Image.Image:
        """Return the drawing as an RGB picture `width` pixels wide."""
        scale = width / self.width
        size = (width, max(1, round(self.height * scale)))
        big = Image.new("RGB", (size[0] * PLAN.samples, size[1] * PLAN.samples), PAPER)
        paint(big, self.items, scale * PLAN.samples)
        return big.reduce(PLAN.samples)

    def file(self, suffix: str, width: int = 1200) -> bytes:
        """Return the content of a file that ends in ".svg", ".pdf" or ".png"; the last is `width` pixels wide."""
        if suffix == ".svg":
            return self.svg().encode()
        return self.pdf() if suffix == ".pdf" else png_bytes(self.image(width))

    def moved(self, dx: float, dy: float) -> list[Shape | Text]:
        """Return the items moved by millimetres, to be put on another sheet."""

        def shift(p: Point) -> Point:
            return (p[0] + dx, p[1] + dy)

        return [
            replace(item, at=shift(item.at))
            if isinstance(item, Text)
            else replace(item, rings=tuple(tuple(map(shift, ring)) for ring in item.rings))
            for item in self.items
        ]


def rectangle(left: float, top: float, right: float, bottom: float) -> tuple[Point, Point, Point, Point]:
    """Return the corners of a rectangle, clockwise on paper from the left upper one."""
    return ((left, top), (right, top), (right, bottom), (left, bottom))


def circle(center: Point, radius: float, sides: int = 40) -> list[Point]:
    """Return a circle as a polygon."""
    angles = [2 * math.pi * i / sides for i in range(sides)]
    return [(center[0] + radius * math.cos(a), center[1] + radius * math.sin(a)) for a in angles]


def _rings(rings: Iterable[Iterable[Point]]) -> tuple[tuple[Point, ...], ...]:
    return tuple(tuple((float(x), float(y)) for x, y in ring) for ring in rings)


@lru_cache(maxsize=64)
def font(pixels: int, latin: bool = True) -> ImageFont.FreeTypeFont:
    """Return the text font: Pillow's own for plain text, DejaVu Sans (from Matplotlib) for everything else."""
    if not latin:
        spec = find_spec("matplotlib")
        if spec is not None and spec.origin is not None:
            return ImageFont.truetype(Path(spec.origin).parent / "mpl-data/fonts/ttf/DejaVuSans.ttf", pixels)
    found = ImageFont.load_default(pixels)
    assert isinstance(found, ImageFont.FreeTypeFont)
    return found


def is_latin(text: str) -> bool:
    """Return whether the built-in font has every character."""
    return all(c < "\u007f" or c in BEYOND_ASCII for c in text)


@lru_cache(maxsize=4096)
def text_width(text: str, size: float) -> float:
    """Return the width of a line of text for a font size, in the unit of the size; ideographs are as wide as high."""
    text = printable(text)
    wide = [c for c in text if c > "\u1100" and east_asian_width(c) in "WF"]
    narrow = "".join(c for c in text if c not in wide) if wide else text
    return (font(100, is_latin(narrow)).getlength(narrow) / 100 + len(wide)) * size


def _svg_text(item: Text) -> str:
    x, y = _number(item.at[0]), _number(item.at[1])
    turn = f' transform="rotate({_number(-item.angle)} {x} {y})"' if item.angle else ""
    wide = _number(0.28 * item.size)
    edge = f' stroke="{item.halo}" stroke-width="{wide}" stroke-linejoin="round" paint-order="stroke"'
    anchor = "" if item.anchor == "start" else f' text-anchor="{item.anchor}"'
    width = text_width(item.text, item.size)
    fit = f' textLength="{_number(width)}" lengthAdjust="spacingAndGlyphs"' if len(item.text) > 2 else ""
    place = f'x="{x}" y="{y}" dy="0.35em" font-size="{_number(item.size)}" fill="{item.color}"'
    return f"<text {place}{anchor}{fit}{turn}{edge if item.halo else ''}>{html(item.text)}</text>"


def _svg_shape(item: Shape) -> str:
    lines = ("L".join(f"{_number(x)} {_number(y)}" for x, y in ring) for ring in item.rings)
    path = "".join(f"M{line}{'Z' if item.closed else ''}" for line in lines)
    style = f'fill="{item.fill or "none"}"' + (' fill-rule="evenodd"' if len(item.rings) > 1 else "")
    style += f' fill-opacity="{_number(item.opacity)}"' if item.opacity < 1 and item.fill else ""
    if item.stroke:
        style += f' stroke="{item.stroke}" stroke-width="{_number(item.width)}" stroke-linejoin="round" stroke-linecap="round"'
        style += f' stroke-dasharray="{_number(item.dash[0])} {_number(item.dash[1])}"' if item.dash else ""
    end = f"><title>{html(item.title)}</title></path>" if item.title else "/>"
    return f'<path d="{path}" {style}{end}'


def png_bytes(image: Image.Image) -> bytes:
    """Return a picture as PNG bytes."""
    stream = io.BytesIO()
    image.save(stream, "PNG", compress_level=3)
    return stream.getvalue()


def paint(image: Image.Image, items: Iterable[Shape | Text], scale: float) -> None:
    """Paint items onto an RGB picture, `scale` pixels per millimetre."""
    pen = ImageDraw.Draw(image, "RGBA")
    for item in items:
        if isinstance(item, Text):
            _paint_text(image, item, scale)
            continue
        rings = [[(x * scale, y * scale) for x, y in ring] for ring in item.rings]
        if item.fill:
            color = (*getrgb(item.fill), round(255 * item.opacity))
            if len(rings) == 1:
                pen.polygon(rings[0], fill=color)
            else:
                _paint_holes(image, rings, color)
        if item.stroke:
            width = max(1, round(item.width * scale))
            for ring in rings:
                points = [*ring, ring[0], ring[1]] if item.closed and len(ring) > 1 else ring
                for piece in _dashed(points, item.dash, scale):
                    joint = "curve" if width > 2 and len(piece) < 80 else None
                    pen.line(piece, fill=item.stroke, width=width, joint=joint)


def _paint_holes(image: Image.Image, rings: list[list[Point]], color: tuple[int, ...]) -> None:
    """Fill rings by the even-odd rule."""
    mask = Image.new("1", image.size)
    for ring in rings:
        one = Image.new("1", image.size)
        ImageDraw.Draw(one).polygon(ring, fill=1)
        mask = ImageChops.logical_xor(mask, one)
    image.paste(color[:3], (0, 0), mask.convert("L").point([v * color[3] // 255 for v in range(256)]))


def _paint_text(image: Image.Image, item: Text, scale: float) -> None:
    """Paint one line of text, turned if need be."""
    text = printable(item.text)
    pixels = max(4, round(item.size * scale))
    face = font(pixels, is_latin(text))
    edge = round(0.14 * pixels) if item.halo else 0
    anchor = {"start": "l", "middle": "m", "end": "r"}[item.anchor]
    x, y = item.at[0] * scale, item.at[1] * scale
    lift = 0.36 * pixels
    style: dict[str, Any] = {"fill": item.color, "font": face, "anchor": anchor + "s"}
    style |= {"stroke_width": edge, "stroke_fill": item.halo}
    if not item.angle:
        ImageDraw.Draw(image).text((x, y + lift), text, **style)
        return
    side = 2 * (int(face.getlength(text)) + pixels)
    layer = Image.new("RGBA", (side, side), (*getrgb(item.halo or item.color), 0))
    ImageDraw.Draw(layer).text((side / 2, side / 2 + lift), text, **style)
    layer = layer.rotate(item.angle, Image.Resampling.BICUBIC)
    image.paste(layer, (round(x - side / 2), round(y - side / 2)), layer)


def _dashed(points: list[Point], dash: tuple[float, float] | None, scale: float) -> list[list[Point]]:
    """Return the pieces of a line that are drawn."""
    if dash is None:
        return [points]
    on, off = dash[0] * scale, dash[1] * scale
    pieces: list[list[Point]] = []
    left, drawing, piece = on, True, [points[0]]
    for a, b in pairwise(points):
        length = max(((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2) ** 0.5, 1e-9)
        done = 0.0
        while done + left < length:
            done += left
            at = (a[0] + (b[0] - a[0]) * done / length, a[1] + (b[1] - a[1]) * done / length)
            if drawing:
                pieces.append([*piece, at])
            drawing, left, piece = not drawing, off if drawing else on, [at]
        left -= length - done
        piece.append(b)
    return [*pieces, piece] if drawing else pieces


def _number(value: float) -> str:
    """Return a number with at most three decimals and no trailing zeros."""
    return f"{round(value, 3) + 0.0:.3f}".rstrip("0").rstrip(".")
