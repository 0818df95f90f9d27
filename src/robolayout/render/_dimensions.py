"""Dimension lines outside a room's walls: openings, walls, and the whole length, each a chain of its own.

Where every wall runs along an axis, the chains of a side stand on one line beyond the room's farthest wall, as on an
architect's drawing; walls at other angles carry their own.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import shapely

from robolayout.render._drawing import Drawing, Point, text_width
from robolayout.render._labels import Label, upright
from robolayout.render._style import PLAN, SHEET
from robolayout.render.contents import Place
from robolayout.render.palette import INK, QUIET
from robolayout.scene import Room, Wall

Outline = tuple[Point, ...]


@dataclass(frozen=True)
class Chain:
    """Lengths along one line."""

    origin: Point  # where the line is measured from, metres: a point on the walls' inner face
    direction: Point  # unit vector along the line
    out: Point  # unit vector out of the room
    marks: tuple[float, ...]  # distances from the origin at which a length ends, metres, rising
    depths: tuple[float, ...]  # for each mark, how far the wall it belongs to stands back from the origin, metres
    level: int  # its place outwards, from 0
    swept: float  # metres out of the origin's wall that leaves of doors sweep

    def point(self, along: float, outward: float) -> Point:
        """Return the point so far along the line and out of the room, metres."""
        (x, y), (dx, dy), (ox, oy) = self.origin, self.direction, self.out
        return (x + dx * along + ox * outward, y + dy * along + oy * outward)


def chains(room: Room) -> tuple[Chain, ...]:
    """Return all dimension lines of a room."""
    return tuple(chain for walls in _sides(room) for chain in _chains(room, walls))


def chained(room: Room, k: float) -> tuple[float, float, float, float]:
    """Return the bounds in metres of a room with its dimension lines and their lengths, at `k` millimetres to a metre."""
    ends = [
        chain.point(at, _off(chain, k) + 4.0 / k) for chain in chains(room) for at in (chain.marks[0], chain.marks[-1])
    ]
    return shapely.MultiPoint(ends).bounds


def _off(chain: Chain, k: float) -> float:
    """Return how far a line stands out of its origin's inner face, beyond leaves that swing out, metres."""
    return max(SHEET.beside / k, chain.swept + SHEET.past / k) + SHEET.step * chain.level / k + PLAN.wall


def _sides(room: Room) -> list[list[Wall]]:
    """Return the walls that share dimension lines: those of one side if all run along the axes, else each its own."""
    if any(min(map(abs, wall.normal)) >= SHEET.same for wall in room.walls):
        return [[wall] for wall in room.walls]
    sides: list[list[Wall]] = []
    for turn in range(4):
        out = (round(math.cos(turn * math.pi / 2)), round(math.sin(turn * math.pi / 2)))
        walls = [w for w in room.walls if round(w.normal[0]) == -out[0] and round(w.normal[1]) == -out[1]]
        walls.sort(key=lambda wall: _along(wall.start, wall.direction))
        ends = [(_along(w.start, w.direction), _along(w.end, w.direction)) for w in walls]
        clear = all(a[1] <= b[0] + SHEET.same for a, b in pairwise(ends))
        sides += [walls] if clear else [[wall] for wall in walls]
    return sides


def _chains(room: Room, walls: Sequence[Wall]) -> Iterator[Chain]:
    """Yield the chains of walls that share a line: openings, walls, the whole."""
    first = walls[0]
    out = (-first.normal[0], -first.normal[1])
    far = max(walls, key=lambda wall: _along(wall.start, out))
    start = _along(first.start, first.direction)
    shift = start - _along(far.start, first.direction)
    origin = far.point(shift)
    openings: list[tuple[float, float]] = []
    ends: list[tuple[float, float]] = []
    swept = 0.0
    for wall in walls:
        begin = _along(wall.start, first.direction) - start
        back = _along(origin, out) - _along(wall.start, out)
        ends += [(begin, back), (begin + wall.length, back)]
        swept = max([swept, *(door.outward - back for door in room.doors if door.wall == wall.index)])
        for opening in (*room.doors, *room.windows):
            if opening.wall == wall.index:
                openings += [(begin + opening.offset, back), (begin + opening.offset + opening.width, back)]
    rows = [sorted([*ends, *openings])] if openings else []
    rows.append(sorted(ends))
    rows += [[min(ends), max(ends)]] if len(walls) > 1 else []
    for level, row in enumerate(rows):
        kept = [row[0], *(b for a, b in pairwise(row) if b[0] - a[0] > SHEET.same)]
        marks, depths = zip(*kept, strict=True)
        yield Chain(origin, first.direction, out, marks, depths, level, swept)


def _along(point: Point, direction: Point) -> float:
    return point[0] * direction[0] + point[1] * direction[1]


def draw_chains(sheet: Drawing, room: Room, place: Place, k: float, names: Sequence[Outline]) -> list[Outline]:
    """Draw the dimension lines of a room, `k` millimetres to a metre; return the outlines of their lengths and of `names`."""
    lengths: list[tuple[Point, Point, str]] = []
    for chain in chains(room):
        off = _off(chain, k)
        stops = [place(*chain.point(at, off)) for at in chain.marks]
        sheet.line([stops[0], stops[-1]], QUIET, width=0.13)
        for at, back, (x, y) in zip(chain.marks, chain.depths, stops, strict=True):
            near = PLAN.wall - back + 1.2 / k if chain.level == 0 else off - 1.6 / k
            sheet.line([place(*chain.point(at, near)), place(*chain.point(at, off + 1.0 / k))], QUIET, width=0.09)
            sheet.line([(x - 0.7, y + 0.7), (x + 0.7, y - 0.7)], INK, width=0.25)
        words = (f"{b - a:.2f}" for a, b in pairwise(chain.marks))
        lengths += [(a, b, text) for (a, b), text in zip(pairwise(stops), words, strict=True)]
    taken = list(names)
    for a, b, text in sorted(
        lengths, key=lambda row: text_width(row[2], SHEET.lengths[0]) > math.dist(*row[:2]) - SHEET.room
    ):
        spot = _free_spot(a, b, text, taken)
        sheet.words(spot.at, text, spot.size, color=INK, angle=spot.angle)
        taken.append(spot.corners)
    return taken


def _free_spot(a: Point, b: Point, words: str, taken: Sequence[Outline]) -> Label:
    """Return where a length is written: beside its line, where it meets no other, as large as may be."""
    others = [shapely.Polygon(outline) for outline in taken]

    def lost(spot: Label) -> float:
        box = shapely.Polygon(spot.corners).buffer(0.25)
        return round(sum(box.intersection(other).area for other in others), 6)

    return min(_spots(a, b, words), key=lost)


def _spots(a: Point, b: Point, words: str) -> Iterator[Label]:
    """Yield where a length may be written, best first: above its line, below it, past its ends."""
    length = math.dist(a, b)
    angle = upright(math.degrees(math.atan2(a[1] - b[1], b[0] - a[0])))
    ux, uy = math.cos(math.radians(angle)), -math.sin(math.radians(angle))
    for size in SHEET.lengths:
        half, high = text_width(words, size) / 2, 0.42 * size
        middle = [(0.0, 1), (0.0, -1)] if 2 * half < length - SHEET.room else []
        for slide, side in (*middle, (1.0, 1), (-1.0, 1), (1.0, -1), (-1.0, -1)):
            along, across = slide * (half + length / 2 + 0.5), side * (high + 0.7)
            x, y = (a[0] + b[0]) / 2 + ux * along + uy * across, (a[1] + b[1]) / 2 + uy * along - ux * across
            yield Label((words,), (x, y), size, angle)
