"""One round through a room: from the door to every thing that the agent gets to, and back.

Ways lead from the door to each thing. Between two of them the agent goes back along the one until they part, or until it can cut
straight across free space to the other; what is nearest then comes next.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout.render._style import FILM
from robolayout.render.marks import Rings

Line = NDArray[np.float64]  # (n, 3): x and y in metres and heading in radians; 0 where the agent just looks ahead


@dataclass(frozen=True, eq=False)
class Leg:
    """A way to one stop."""

    names: tuple[str, ...]  # assets that are reached at its end; empty for the way back to the door
    line: Line  # the way

    @property
    def length(self) -> float:
        """Metres, turns counted."""
        return float(spent(self.line)[-1])


def tour(ways: Mapping[str, Sequence[tuple[float, ...]]], free: Sequence[Rings]) -> tuple[Leg, ...]:
    """Return the legs of a round over all ways, the way back to their common start last.

    Args:
        ways: Way from the door to each asset by name: x and y in metres and, where it is given, the heading in radians.
        free: Polygons of the free space of the agent's centre, as rings; without them it only goes along ways.
    """
    space = shapely.union_all([shapely.Polygon(rings[0], rings[1:]) for rings in free if rings])
    space = shapely.buffer(space, FILM.slack)
    shapely.prepare(space)
    lines = {names: _dense(np.array(ways[names[0]], dtype=np.float64)) for names in _stops(ways)}
    legs: list[Leg] = []
    before = next(iter(lines.values()))[:1]
    while lines:
        near = sorted(lines, key=lambda names: math.dist(lines[names][-1, :2], before[-1, :2]))[: FILM.nearest]
        legs.append(min((Leg(n, _between(before, lines[n], space)) for n in near), key=lambda leg: leg.length))
        before = lines.pop(legs[-1].names)
    return (*legs, Leg((), before[::-1]))


def _stops(ways: Mapping[str, Sequence[tuple[float, ...]]]) -> list[tuple[str, ...]]:
    """Return the names of the assets in groups that are visited at once."""
    groups: list[list[str]] = []
    for name, line in sorted(ways.items()):
        near = [g for g in groups if math.dist(ways[g[0]][-1][:2], line[-1][:2]) <= FILM.together]
        if near:
            near[0].append(name)
        else:
            groups.append([name])
    return [tuple(group) for group in groups]


def spent(line: Line) -> NDArray[np.float64]:
    """Return the way from a line's start to each of its points, metres, turns counted."""
    moved = np.abs(np.diff(line, axis=0))
    return np.concatenate([[0.0], np.cumsum(np.hypot(moved[:, 0], moved[:, 1]) + FILM.turn * moved[:, 2])])


def _dense(line: Line) -> Line:
    """Return a line with a point at least every `FILM.spacing` metres, from one without headings one with none."""
    line = np.pad(line, ((0, 0), (0, 3 - line.shape[1])))
    pieces = [line[:1]]
    for a, b, far in zip(line, line[1:], np.diff(spent(line)), strict=False):
        count = max(1, math.ceil(far / FILM.spacing))
        pieces.append(a + (b - a) * (np.arange(1, count + 1) / count)[:, None])
    return np.concatenate(pieces)


def _between(one: Line, other: Line, space: shapely.Geometry) -> Line:
    """Return the shortest way from the end of one line to the end of another: back, across, and on."""
    back, on = spent(one)[-1] - spent(one), spent(other)[-1] - spent(other)
    across = np.linalg.norm(one[:, None] - other[None], axis=2)
    total = back[:, None] + across + on[None]
    order = np.argsort(total, axis=None, kind="stable")
    for some in np.array_split(order, max(1, len(order) // 24)):
        i, j = np.unravel_index(some, total.shape)
        chords = shapely.linestrings(np.stack([one[i, :2], other[j, :2]], axis=1))
        fits = shapely.covers(space, chords) | (across[i, j] < FILM.slack)
        if fits.any():
            k = int(np.argmax(fits))
            return np.concatenate([one[i[k] :][::-1], other[j[k] :]])
    return np.concatenate([one[::-1], other])
