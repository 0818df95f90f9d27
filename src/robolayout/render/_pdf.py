"""A drawing as a one-page PDF with real lines and text, written by hand (PDF 1.4, standard font Helvetica)."""

from __future__ import annotations

from robolayout.render._drawing import Drawing, Shape, Text, text_width

POINT = 72 / 25.4
"""PDF points per millimetre."""


def draw_pdf(drawing: Drawing) -> bytes:
    """Return the drawing as PDF bytes, to scale; characters outside Windows-1252 become question marks."""
    width, height = drawing.width * POINT, drawing.height * POINT
    states = sorted({item.opacity for item in drawing.items if isinstance(item, Shape)} | {1.0})
    commands = [f"{POINT:.6f} 0 0 {-POINT:.6f} 0 {height:.3f} cm", "1 J 1 j"]
    commands.append(f"{_color(drawing.background)} rg 0 0 {drawing.width:.3f} {drawing.height:.3f} re f")
    for item in drawing.items:
        commands.append(_text(item) if isinstance(item, Text) else _shape(item, states.index(item.opacity)))
    page = "\n".join(commands).encode("cp1252", "replace")
    graphics = " ".join(f"/G{k} << /ca {value:.3f} >>" for k, value in enumerate(states))
    objects = [
        b"<< /Type /Catalog /Pages 2 0 R >>",
        b"<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
        (
            f"<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {width:.3f} {height:.3f}] /Contents 4 0 R /Resources "
            f"<< /Font << /F 5 0 R >> /ExtGState << {graphics} >> >> >>"
        ).encode(),
        b"<< /Length %d >>\nstream\n%s\nendstream" % (len(page), page),
        b"<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
    ]
    return _file(objects)


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


def _text(item: Text) -> str:
    """Return the operators of one line of text."""
    import math

    width = text_width(item.text, item.size)
    shift = {"start": 0.0, "middle": -width / 2, "end": -width}[item.anchor]
    c, s = math.cos(math.radians(item.angle)), math.sin(math.radians(item.angle))
    drop = 0.36 * item.size
    x = item.at[0] + c * shift + s * drop
    y = item.at[1] - s * shift + c * drop
    place = f"{c:.5f} {-s:.5f} {-s:.5f} {-c:.5f} {x:.3f} {y:.3f} Tm"
    words = (
        item.text.replace("\\", "\\\\").replace("(", "\\(").replace(")", "\\)").replace("\r", " ").replace("\n", " ")
    )
    show = f"/F {item.size:.3f} Tf {place} ({words}) Tj"
    halo = f"q {_color(item.halo)} RG {0.28 * item.size:.3f} w [] 0 d BT 1 Tr {show} ET Q " if item.halo else ""
    return f"{halo}{_color(item.color)} rg BT 0 Tr {show} ET"


def _color(color: str) -> str:
    """Return red, green and blue from 0 to 1."""
    return " ".join(f"{int(color[k : k + 2], 16) / 255:.3f}" for k in (1, 3, 5))
