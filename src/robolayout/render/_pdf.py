"""A drawing as a one-page PDF with real lines and text, written by hand (PDF 1.4).

The fonts that measure a text are those that draw it: the used glyphs of Pillow's own font and of DejaVu Sans go into the
file. Chinese, Japanese and Korean characters, which neither has, are left to the reader's own fonts for them.
"""

from __future__ import annotations

import io
import math
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import groupby
from typing import Any

from PIL.ImageColor import getrgb

from robolayout.render._drawing import Drawing, Shape, Text, font, is_latin, printable, text_width
from robolayout.render.palette import PAPER

POINT = 72 / 25.4  # PDF points per millimetre
READERS = {"GB1": ("STSong-Light", "UniGB-UCS2-H"), "Korea1": ("HYSMyeongJo-Medium", "UniKS-UCS2-H")}
"""Fonts that a PDF reader brings along, by character collection, with their encoding (PDF 1.4, section 5.6.3)."""


@dataclass(frozen=True)
class _Font:
    """The glyphs of one font that a drawing uses: their numbers and widths, and the font file with nothing else."""

    name: str
    glyphs: dict[str, int]
    widths: dict[str, int]
    data: bytes


def draw_pdf(drawing: Drawing) -> bytes:
    """Return the drawing as PDF bytes, to scale."""
    width, height = drawing.width * POINT, drawing.height * POINT
    states = sorted({item.opacity for item in drawing.items if isinstance(item, Shape)} | {1.0})
    fonts = _fonts([printable(item.text) for item in drawing.items if isinstance(item, Text)])
    commands = [f"{POINT:.6f} 0 0 {-POINT:.6f} 0 {height:.3f} cm", "1 J 1 j"]
    commands.append(f"{_color(PAPER)} rg 0 0 {drawing.width:.3f} {drawing.height:.3f} re f")
    for item in drawing.items:
        commands.append(_text(item, fonts) if isinstance(item, Text) else _shape(item, states.index(item.opacity)))
    graphics = " ".join(f"/G{k} << /ca {value:.3f} >>" for k, value in enumerate(states))
    objects = [
        b"<< /Type /Catalog /Pages 2 0 R >>",
        b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        b"",
        _stream("\n".join(commands).encode("ascii")),
    ]
    names, written = list[str](), " ".join(commands)
    makers = {key: partial(_embedded, found) for key, found in fonts.items()}
    makers |= {key: partial(_reader_font, key, *how) for key, how in READERS.items() if f"/{key} " in written}
    for key, made in makers.items():
        names.append(f"/{key} {len(objects) + 1} 0 R")
        objects += made(len(objects) + 1)
    objects[2] = (
        f"<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {width:.3f} {height:.3f}] /Contents 4 0 R /Resources "
        f"<< /Font << {' '.join(names)} >> /ExtGState << {graphics} >> >> >>"
    ).encode()
    return _file(objects)


def _fonts(texts: Sequence[str]) -> dict[str, _Font]:
    """Return the fonts that these texts are written in, each with the glyphs that they need."""
    found: dict[str, _Font] = {}
    for key, plain in (("Plain", True), ("Wide", False)):
        characters = "".join(sorted({c for text in texts if is_latin(text) is plain for c in text}))
        if characters:
            found[key] = _subset(characters, plain)
    return found


def _subset(characters: str, plain: bool) -> _Font:
    """Return a font with nothing but the glyphs of these characters."""
    from fontTools.subset import Options, Subsetter
    from fontTools.ttLib import TTFont

    face: Any = font(100, plain)
    source = io.BytesIO(face.font_bytes) if isinstance(face.path, io.BytesIO) else face.path
    whole: Any = TTFont(source, recalcTimestamp=False)
    options = Options(hinting=False, layout_features=[], notdef_outline=True, name_IDs=[6])
    options.drop_tables = [*options.drop_tables, "FFTM", "GDEF", "GPOS", "GSUB", "kern", "gasp"]
    cutter = Subsetter(options)
    cutter.populate(text=characters)
    cutter.subset(whole)
    stream = io.BytesIO()
    whole.save(stream)
    unit = whole["head"].unitsPerEm
    cmap = {chr(code): name for code, name in whole.getBestCmap().items()}
    glyphs = {c: whole.getGlyphID(name) for c, name in cmap.items()}
    widths = {c: round(1000 * whole["hmtx"][name][0] / unit) for c, name in cmap.items()}
    return _Font("Aileron" if plain else "DejaVuSans", glyphs, widths, stream.getvalue())


def _embedded(used: _Font, first: int) -> list[bytes]:
    """Return the five objects of a font in the file, the first of which has the number `first`."""
    tag = f"ROBOLA+{used.name}"
    order = sorted(used.glyphs, key=lambda c: used.glyphs[c])
    widths = " ".join(f"{used.glyphs[c]} [{used.widths[c]}]" for c in order)
    pairs = [f"<{used.glyphs[c]:04x}> <{c.encode('utf-16-be').hex()}>\n" for c in order]
    groups = [pairs[k : k + 100] for k in range(0, len(pairs), 100)]  # as many as the format wants at once
    codes = "\n".join(f"{len(group)} beginbfchar\n{''.join(group)}endbfchar" for group in groups)
    unicode = (
        "/CIDInit /ProcSet findresource begin 12 dict begin begincmap /CMapName /Used def /CMapType 2 def\n"
        f"1 begincodespacerange <0000> <ffff> endcodespacerange\n{codes}\nendcmap end end"
    )
    return [
        f"<< /Type /Font /Subtype /Type0 /BaseFont /{tag} /Encoding /Identity-H /DescendantFonts [{first + 1} 0 R] "
        f"/ToUnicode {first + 4} 0 R >>".encode(),
        f"<< /Type /Font /Subtype /CIDFontType2 /BaseFont /{tag} /CIDSystemInfo << /Registry (Adobe) /Ordering (Identity) "
        f"/Supplement 0 >> /FontDescriptor {first + 2} 0 R /CIDToGIDMap /Identity /W [{widths}] >>".encode(),
        f"<< /Type /FontDescriptor /FontName /{tag} /Flags 4 /FontBBox [-200 -300 1200 1000] /ItalicAngle 0 /Ascent 800 "
        f"/Descent -200 /CapHeight 720 /StemV 80 /FontFile2 {first + 3} 0 R >>".encode(),
        _stream(used.data, f"/Length1 {len(used.data)} "),
        _stream(unicode.encode()),
    ]


def _reader_font(collection: str, name: str, encoding: str, first: int) -> list[bytes]:
    """Return the three objects of a font that the reader of the file brings along."""
    return [
        f"<< /Type /Font /Subtype /Type0 /BaseFont /{name} /Encoding /{encoding} /DescendantFonts "
        f"[{first + 1} 0 R] >>".encode(),
        f"<< /Type /Font /Subtype /CIDFontType0 /BaseFont /{name} /CIDSystemInfo << /Registry (Adobe) "
        f"/Ordering ({collection}) /Supplement 0 >> /DW 1000 /FontDescriptor {first + 2} 0 R >>".encode(),
        f"<< /Type /FontDescriptor /FontName /{name} /Flags 4 /FontBBox [-25 -254 1000 880] /ItalicAngle 0 /Ascent 752 "
        "/Descent -271 /CapHeight 737 /StemV 58 >>".encode(),
    ]


def _stream(data: bytes, more: str = "") -> bytes:
    packed = zlib.compress(data, 9)
    head = f"<< {more}/Length {len(packed)} /Filter /FlateDecode >>"
    return head.encode() + b"\nstream\n" + packed + b"\nendstream"


def _file(objects: list[bytes]) -> bytes:
    """Return a PDF file with these objects, the first one the catalogue."""
    body = b"%PDF-1.4\n"
    offsets: list[int] = []
    for number, content in enumerate(objects, start=1):
        offsets.append(len(body))
        body += b"%d 0 obj\n%s\nendobj\n" % (number, content)
    table = b"".join(b"%010d 00000 n \n" % offset for offset in offsets)
    count = len(objects) + 1
    end = b"trailer\n<< /Size %d /Root 1 0 R >>\nstartxref\n%d\n%%%%EOF\n" % (count, len(body))
    return body + b"xref\n0 %d\n0000000000 65535 f \n" % count + table + end


def _shape(item: Shape, state: int) -> str:
    """Return the operators of one shape."""
    path = " ".join(
        " ".join(f"{x:.3f} {y:.3f} {'l' if k else 'm'}" for k, (x, y) in enumerate(ring))
        + (" h" if item.closed else "")
        for ring in item.rings
    )
    parts = [f"/G{state} gs"]
    if item.fill:
        parts.append(f"{_color(item.fill)} rg {path} f*")
    if item.stroke:
        dash = f"[{item.dash[0]:.3f} {item.dash[1]:.3f}] 0 d" if item.dash else "[] 0 d"
        parts.append(f"{_color(item.stroke)} RG {item.width:.3f} w {dash} {path} S")
    return " ".join(parts)


def _text(item: Text, fonts: dict[str, _Font]) -> str:
    """Return the operators of one line of text."""
    words = printable(item.text)
    width = text_width(item.text, item.size)
    shift = {"start": 0.0, "middle": -width / 2, "end": -width}[item.anchor]
    c, s = math.cos(math.radians(item.angle)), math.sin(math.radians(item.angle))
    drop = 0.36 * item.size
    x = item.at[0] + c * shift + s * drop
    y = item.at[1] - s * shift + c * drop
    place = f"{c:.5f} {-s:.5f} {-s:.5f} {-c:.5f} {x:.3f} {y:.3f} Tm"
    runs = (f"/{key} {item.size:.3f} Tf <{code}> Tj" for key, code in _runs(words, fonts))
    show = f"{place} {' '.join(runs)}"
    halo = f"q {_color(item.halo)} RG {0.28 * item.size:.3f} w [] 0 d BT 1 Tr {show} ET Q " if item.halo else ""
    return f"{halo}{_color(item.color)} rg BT 0 Tr {show} ET"


def _runs(words: str, fonts: dict[str, _Font]) -> Iterator[tuple[str, str]]:
    """Yield the pieces of a line that are written in one font each, and their codes in it."""
    key = "Plain" if is_latin(words) else "Wide"

    def chosen(c: str) -> str:
        if c in fonts[key].glyphs or c > "\uffff":
            return key
        return "Korea1" if "\uac00" <= c <= "\ud7a3" else "GB1"

    for name, run in groupby(words, chosen):
        if name == key:
            yield name, "".join(f"{fonts[key].glyphs.get(c, 0):04x}" for c in run)
        else:
            yield name, "".join(run).encode("utf-16-be").hex()


def _color(color: str) -> str:
    """Return red, green and blue from 0 to 1."""
    return " ".join(f"{channel / 255:.3f}" for channel in getrgb(color))
