"""Where the names on a plan go: inside the footprint if they fit, else beside it, never on top of each other."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout.render._drawing import Point, text_width
from robolayout.render._style import LABELS

Box = tuple[float, float, float, float]


@dataclass(frozen=True)
class Tag:
    """A name to be placed."""

    text: str  # the name
    outline: tuple[Point, ...]  # corners of the footprint, millimetres
    beside: bool  # whether the name may stand beside the footprint
    # corners of what lies on top of the footprint and should stay free of text
    covers: tuple[tuple[Point, ...], ...] = ()
    outward: Point | None = None  # direction in which a name beside the footprint stands best, or None
    halo: bool = False  # whether the name needs a light edge, because lines run under it
    quiet: bool = False  # whether it is written in grey, since the thing hangs above
    # corners of what hangs above the footprint; the name keeps off their edges if it can
    shuns: tuple[tuple[Point, ...], ...] = ()
    short: str = ""  # what is written where the name finds no place, if need be over what lies on top; or nothing


@dataclass(frozen=True)
class Label:
    """A placed name."""

    lines: tuple[str, ...]  # one or two lines, top first
    at: Point  # middle of the text block, millimetres
    size: float  # font size, millimetres
    angle: float = 0.0  # degrees counter-clockwise in which the text runs
    leader: Point | None = None  # point of the footprint that a thin line leads to, for names that stand beside it
    halo: bool = False  # whether it needs a light edge
    quiet: bool = False  # whether it is written in grey

    @property
    def extent(self) -> Point:
        """Length along the text and height across it, millimetres."""
        length = max(text_width(line, self.size) for line in self.lines)
        return (length, self.size * (0.82 + LABELS.line * (len(self.lines) - 1)))

    @property
    def corners(self) -> tuple[Point, ...]:
        """The four corners of the text block, millimetres."""
        w, h = self.extent
        return tuple(self.point(x, y) for x, y in ((-w / 2, -h / 2), (w / 2, -h / 2), (w / 2, h / 2), (-w / 2, h / 2)))

    @property
    def box(self) -> Box:
        """Left, upper, right and lower edge in millimetres."""
        xs, ys = zip(*self.corners, strict=True)
        return (min(xs), min(ys), max(xs), max(ys))

    def point(self, along: float, across: float) -> Point:
        """Return the point so far along the text and below its middle, millimetres on the sheet."""
        c, s = math.cos(math.radians(self.angle)), math.sin(math.radians(self.angle))
        return (self.at[0] + c * along + s * across, self.at[1] - s * along + c * across)


def place_labels(
    tags: Iterable[Tag],
    obstacles: Sequence[Sequence[Point]],
    sheet: Box,
    sizes: Sequence[float] = LABELS.sizes,
    lines: Sequence[Sequence[Point]] = (),
) -> list[Label]:
    """Return the labels that find a place, biggest footprints first; a name without a place is left out.

    `obstacles` are outlines that a name beside its footprint should not cover (other footprints, walls), `sheet` is the
    paper, `sizes` are the font sizes to try, `lines` are routes and the like, which a name crosses only if it must; all
    in millimetres.
    """
    strokes = np.array([shapely.LineString(line) for line in lines if len(line) > 1], dtype=object)
    solids = np.array([shapely.Polygon(o) for o in obstacles], dtype=object)
    placed: list[Label] = []
    taken: list[Box] = []
    for tag in sorted(tags, key=lambda tag: -shapely.Polygon(tag.outline).area):
        soft = _soft(tag, strokes)
        label = None
        for text in (tag.text, tag.short) if tag.short else (tag.text,):
            named = replace(tag, text=text)
            label = label or (_first_inside(named, taken, sizes[: LABELS.eager], soft) if len(soft) else None)
            label = label or _first_inside(replace(named, halo=tag.halo or len(soft) > 0), taken, sizes)
        if label is None and tag.beside:
            beside = replace(tag, text=tag.short or tag.text)
            clear = np.concatenate([solids, strokes])
            label = _first_beside(beside, taken, clear, sheet, sizes[-2])
            label = label or _first_beside(beside, taken, solids, sheet, sizes[-2])
        if label is None and tag.short:
            label = _first_inside(replace(tag, text=tag.short, covers=(), halo=True), taken, sizes)
        if label is not None:
            placed.append(label)
            taken.append(label.box)
    return placed


def _soft(tag: Tag, strokes: NDArray[np.object_]) -> NDArray[np.object_]:
    """Return the lines over a footprint that its name should not cross."""
    edges = [shapely.LinearRing(corners) for corners in tag.shuns]
    found = np.array([*strokes, *edges], dtype=object)
    return found[shapely.intersects(found, shapely.Polygon(tag.outline))] if len(found) else found


def _first_inside(
    tag: Tag, taken: Sequence[Box], sizes: Sequence[float], soft: NDArray[np.object_] | None = None
) -> Label | None:
    """Return the largest label inside the footprint that meets no other, covers nothing on top and crosses no `soft` line."""
    inner = shapely.Polygon(tag.outline).buffer(-LABELS.margin, join_style="mitre")
    shapely.prepare(inner)
    covers = np.array([shapely.Polygon(c) for c in tag.covers], dtype=object)
    covers = covers if soft is None else np.concatenate([covers, soft])
    for label in _inside(tag, sizes):
        block = shapely.Polygon(label.corners)
        clear = inner.covers(block) and not any(_meet(label.box, other) for other in taken)
        if clear and not shapely.intersects(covers, block).any():
            return label
    return None


def _inside(tag: Tag, sizes: Sequence[float]) -> Iterator[Label]:
    """Yield labels inside the footprint, best first: large, in one line, level, in the middle."""
    corners = np.array(tag.outline, dtype=np.float64)
    middle, extent = corners.mean(axis=0), np.ptp(corners, axis=0)
    shifts = [(0.0, 0.0), (0, 0.28), (0, -0.28), (0.28, 0), (-0.28, 0), (0, 0.38), (0, -0.38), (0.36, 0), (-0.36, 0)]
    shifts += [(dx, dy) for dy in (0.4, -0.4) for dx in (0.3, -0.3)]
    edges = np.roll(corners, -1, axis=0) - corners
    dx, dy = edges[int(np.argmax(np.round(np.linalg.norm(edges, axis=1), 6)))]
    along = upright(math.degrees(math.atan2(-dy, dx)))
    for size in sizes:
        for lines in _splits(tag.text):
            turns: list[float] = list(dict.fromkeys([0.0, along, *([90.0] if extent[1] > extent[0] else [])]))
            middle_first = [(shifts[0], angle) for angle in turns] + list(product(shifts[1:], turns))
            if max(extent) < LABELS.squarish * min(extent):
                middle_first = [(shift, angle) for angle in turns for shift in shifts]
            for (dx, dy), angle in middle_first:
                at = (float(middle[0] + dx * extent[0]), float(middle[1] + dy * extent[1]))
                yield Label(lines, at, size, angle, halo=tag.halo, quiet=tag.quiet)


def upright(angle: float) -> float:
    """Return an angle in degrees at which text is not upside down; along uprights it is read from the right."""
    return round((angle + 89.999) % 180.0 - 89.999, 3)


def _first_beside(tag: Tag, taken: Sequence[Box], solids: NDArray[np.object_], sheet: Box, size: float) -> Label | None:
    """Return the nearest label outside the footprint that meets nothing."""
    corners = np.array(tag.outline)
    low, high = corners.min(axis=0), corners.max(axis=0)
    middle = (low + high) / 2
    own = shapely.Polygon(tag.outline)
    compass = ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, 1), (1, -1), (-1, -1))
    gaps = [(gap, way) for gap in (0.8, 2.0, 3.5) for way in compass]
    if tag.outward is not None:
        gaps = [(gap, tag.outward) for gap in (0.5, 1.5, 2.5, 3.0, 3.5, 4.0)] + gaps
    for gap, (dx, dy) in gaps:
        for lines in _splits(tag.text):
            upright = bool(dx) and not dy and tag.outward is not None and high[1] - low[1] > high[0] - low[0]
            left, up, right, down = Label(lines, (0, 0), size, 90.0 * upright).box
            x = middle[0] + dx * ((high[0] - low[0] + right - left) / 2 + gap)
            y = middle[1] + dy * ((high[1] - low[1] + down - up) / 2 + gap)
            near = shapely.shortest_line(own, shapely.Point(x, y)).coords[0]
            leader = (near[0], near[1]) if gap > 1 and (dx, dy) != tag.outward else None
            label = Label(lines, (float(x), float(y)), size, 90.0 * upright, leader, leader is not None, tag.quiet)
            box = label.box
            free = box[0] > sheet[0] and box[1] > sheet[1] and box[2] < sheet[2] and box[3] < sheet[3]
            free = free and not any(_meet(box, other) for other in taken)
            if free and not shapely.intersects(solids, shapely.box(*box)).any():
                return label
    return None


def _splits(text: str) -> list[tuple[str, ...]]:
    """Return the text in one line and, if it has a space, in two lines of similar length."""
    words = text.split(" ")
    halves = [(" ".join(words[:k]), " ".join(words[k:])) for k in range(1, len(words))]
    return [(text,), *sorted(halves, key=lambda pair: abs(len(pair[0]) - len(pair[1])))[:1]]


def _meet(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]
