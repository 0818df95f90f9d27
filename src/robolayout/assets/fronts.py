"""Doors and drawers with their handles, in a row or a grid."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from robolayout.assets.part import Material, Part
from robolayout.assets.shapes import Range, box, cylinder

Box = NDArray[np.float64]
Face = tuple[Range, Range]  # where fronts lie: ends along y and z


@dataclass(frozen=True)
class FrontConfig:
    """Doors and drawers of furniture, in metres unless said otherwise."""

    gap: float = 0.004  # metres between neighbouring fronts
    door: float = 0.018  # thickness of a front in metres
    knob: float = 0.022  # how far handles stand out, metres
    low: float = 0.03  # between a door's lower edge and a handle at its lower end
    # half-axes of a knob at its front and at its end
    knob_radii: tuple[tuple[float, float], tuple[float, float]] = ((0.008, 0.008), (0.013, 0.013))
    board: float = 0.016  # thickness of boards between drawers
    thin: float = 0.008  # thickness of the boards that drawers are made of
    ease: float = 0.002  # how loosely drawers run
    raised: float = 0.75  # share of its height to which a drawer's sides and back reach
    pitch: float = 0.34  # between shelves behind doors, about
    recess: float = 0.02  # how far back these lie
    shallow: float = 0.06  # no drawer is lower
    behind: float = 0.05  # what stands so far behind a front is its body


FRONTS = FrontConfig()

TRAY = "drawer floor"  # name of the part on which lies what is in a drawer
OPEN = (("drawer", 1.0, 0.0), ("door", 0.0, 0.0))
"""Names of fronts that have an inside, each with the x and y of the axis on which it moves: pulled out, or hung at its side."""


def spread(span: Range, count: int, gap: float = FRONTS.gap) -> list[Range]:
    """Return `count` equal ranges inside `span`, `gap` apart and from the ends."""
    step = (span[1] - span[0] - gap) / count
    return [(span[0] + gap + i * step, span[0] + (i + 1) * step) for i in range(count)]


def doors(front: Material, metal: Material, ahead: float, face: Face, *, count: int, low: int = 0) -> Iterator[Part]:
    """Yield a row of doors with bar handles, half way up or at their lower ends; the handles end at x = `ahead`."""
    (y, z), front_x = face, ahead - FRONTS.knob
    for i, (y0, y1) in enumerate(spread(y, count)):
        yield box("door", front, (front_x - FRONTS.door, front_x), (y0, y1), (z[0] + FRONTS.gap, z[1] - FRONTS.gap))
        at = y1 - 0.045 if i % 2 == 0 and count > 1 else y0 + 0.045
        half = min(0.12, 0.2 * (z[1] - z[0]))
        middle = z[0] + FRONTS.low + half if low else (z[0] + z[1]) / 2
        yield box("handle", metal, (front_x, ahead), (at - 0.007, at + 0.007), (middle - half, middle + half))


def drawers(
    front: Material, metal: Material, ahead: float, face: Face, *, rows: int, columns: int = 1, knobs: int = 0
) -> Iterator[Part]:
    """Yield a grid of drawer fronts with handles or knobs that end at x = `ahead`."""
    (y, z), front_x = face, ahead - FRONTS.knob
    for y0, y1 in spread(y, columns):
        for z0, z1 in spread(z, rows):
            yield box("drawer", front, (front_x - FRONTS.door, front_x), (y0, y1), (z0, z1))
            middle, level, half = (y0 + y1) / 2, (z0 + z1) / 2, min(0.07, 0.2 * (y1 - y0))
            if knobs:
                yield cylinder("knob", metal, (middle, level), FRONTS.knob_radii, (front_x, ahead), axis="x", sides=8)
            else:
                handle = ((middle - half, middle + half), (level - 0.006, level + 0.006))
                yield box("handle", metal, (front_x, ahead), *handle)


def hollowed(made: Sequence[Part]) -> tuple[Part, ...]:
    """Return the parts of a thing that has insides: the plain box behind each front is cut out, for a tray or for shelves."""
    out = list(made)
    for front in (part for part in made if part.joint is not None and (part.name, *part.joint.axis[:2]) in OPEN):
        low, high = front.ends
        behind = [part for part in made if part.joint is None and _meets(part, low - (FRONTS.behind, 0.0, 0.0), high)]
        back = min((part.vertices[:, 0].min() for part in behind), default=low[0]) + FRONTS.board
        inset = FRONTS.board / 2 if front.name == "drawer" else FRONTS.board
        hole = np.array([(back, *(low[1:] + inset)), (low[0], *(high[1:] - inset))])
        bodies = [part for part in out if _meets(part, *hole)]
        deep = (hole[1] - hole[0]).min() > FRONTS.shallow
        if bodies and deep and all(map(_is_block, (*behind, *bodies))):
            out = [piece for part in out for piece in (_cut(part, hole) if part in bodies else (part,))]
            within = _tray(front.material, hole) if front.name == "drawer" else _shelves(bodies[0].material, hole)
            out += [replace(part, joint=front.joint if front.name == "drawer" else None) for part in within]
    return tuple(out)


def _meets(part: Part, low: Box, high: Box) -> bool:
    """Return whether a part's box shares room with another one."""
    own = part.ends
    return bool((np.minimum(own[1], high) - np.maximum(own[0], low) > 1e-6).all())


def _is_block(part: Part) -> bool:
    """Return whether a part that stays where it is fills its box."""
    low, high = part.ends
    at_ends = np.isclose(part.vertices, low, atol=1e-6) | np.isclose(part.vertices, high, atol=1e-6)
    return part.joint is None and len(part.vertices) == 8 and bool(at_ends.all())


def _cut(part: Part, hole: Box) -> Iterator[Part]:
    """Yield the blocks that are left of one where a hole is cut into it."""
    rest = part.ends
    for axis, end in product(range(3), (0, 1)):
        piece = rest.copy()
        piece[1 - end, axis] = hole[end, axis]
        if piece[1, axis] - piece[0, axis] > 1e-6:
            rest[end, axis] = hole[end, axis]
            yield box(part.name, part.material, *piece.T.tolist())


def _tray(material: Material, hole: Box) -> Iterator[Part]:
    """Yield floor, back and sides of the drawer in a hole, whose front is there already."""
    (x0, y0, z0), (x1, y1, z1) = (hole + FRONTS.ease * np.array([[1.0, 1.0, 1.0], [0.0, -1.0, -1.0]])).tolist()
    top = z0 + FRONTS.raised * (z1 - z0)
    yield box(TRAY, material, (x0, x1), (y0, y1), (z0, z0 + FRONTS.thin))
    yield box("drawer back", material, (x0, x0 + FRONTS.thin), (y0, y1), (z0 + FRONTS.thin, top))
    for side in ((y0, y0 + FRONTS.thin), (y1 - FRONTS.thin, y1)):
        yield box("drawer side", material, (x0 + FRONTS.thin, x1), side, (z0 + FRONTS.thin, top))


def _shelves(material: Material, hole: Box) -> Iterator[Part]:
    """Yield shelves at even heights in a hole."""
    (x0, y0, z0), (x1, y1, z1) = hole.tolist()
    count = round((z1 - z0) / FRONTS.pitch)
    for level in np.linspace(z0, z1, max(count, 1) + 1)[1:-1].tolist():
        thick = (level - FRONTS.board / 2, level + FRONTS.board / 2)
        yield box("shelf", material, (x0, x1 - FRONTS.recess), (y0, y1), thick)
