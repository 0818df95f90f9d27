"""Doors and drawers with their handles, in a row or a grid."""

from __future__ import annotations

from collections.abc import Iterator

from robolayout.assets.part import Material, Part
from robolayout.assets.shapes import Range, box, cylinder

Face = tuple[Range, Range]
"""Where fronts lie: ends along y and z."""

GAP = 0.004
"""Metres between neighbouring fronts."""
DOOR = 0.018
"""Thickness of a front in metres."""
KNOB = 0.022
"""How far handles stand out, metres."""


def spread(span: Range, count: int, gap: float = GAP) -> list[Range]:
    """Return `count` equal ranges inside `span`, `gap` apart and from the ends."""
    step = (span[1] - span[0] - gap) / count
    return [(span[0] + gap + i * step, span[0] + (i + 1) * step) for i in range(count)]


def doors(front: Material, metal: Material, ahead: float, face: Face, *, count: int) -> Iterator[Part]:
    """Yield a row of doors with bar handles; the handles end at x = `ahead`."""
    (y, z), front_x = face, ahead - KNOB
    for i, (y0, y1) in enumerate(spread(y, count)):
        yield box("door", front, (front_x - DOOR, front_x), (y0, y1), (z[0] + GAP, z[1] - GAP))
        at = y1 - 0.045 if i % 2 == 0 and count > 1 else y0 + 0.045
        middle, half = (z[0] + z[1]) / 2, min(0.12, 0.2 * (z[1] - z[0]))
        yield box("handle", metal, (front_x, ahead), (at - 0.007, at + 0.007), (middle - half, middle + half))


def drawers(
    front: Material, metal: Material, ahead: float, face: Face, *, rows: int, columns: int = 1, knobs: int = 0
) -> Iterator[Part]:
    """Yield a grid of drawer fronts with handles or knobs that end at x = `ahead`."""
    (y, z), front_x = face, ahead - KNOB
    for y0, y1 in spread(y, columns):
        for z0, z1 in spread(z, rows):
            yield box("drawer", front, (front_x - DOOR, front_x), (y0, y1), (z0, z1))
            middle, level, half = (y0 + y1) / 2, (z0 + z1) / 2, min(0.07, 0.2 * (y1 - y0))
            if knobs:
                yield cylinder("knob", metal, (middle, level), (0.008, 0.013), (front_x, ahead), axis="x", sides=8)
            else:
                handle = ((middle - half, middle + half), (level - 0.006, level + 0.006))
                yield box("handle", metal, (front_x, ahead), *handle)
