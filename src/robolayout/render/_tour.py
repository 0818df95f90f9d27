"""One round through a room: from the door to every asset that the agent gets to, and back.

Routes lead from the door to each asset. Between two of them the agent goes back along the one until it can cut straight
across free space to the other; which one comes next is chosen so that the round is short.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout.render.marks import Point, Rings

TOGETHER = 0.3
"""Metres: assets whose routes end as close as this are visited at once."""

SPACING = 0.15
"""Metres between the points of a route at which the agent may leave it."""

SLACK = 1e-3
"""Metres by which a straight way may leave the free space, for rounding."""

Line = NDArray[np.float64]


@dataclass(frozen=True)
class Leg:
    """A way to one stop."""

    names: tuple[str, ...]  # assets that are reached at its end; empty for the way back to the door
    line: tuple[Point, ...]  # the way, metres

    @property
    def length(self) -> float:
        """Metres."""
        return sum(math.dist(a, b) for a, b in pairwise(self.line))


def tour(routes: Mapping[str, Sequence[Point]], free: Sequence[Rings]) -> tuple[Leg, ...]:
    """Return the legs of a round over all routes, the way back to their common start last.

    Args:
        routes: Polyline from the door to each asset, metres, by name.
        free: Polygons of the free space of the agent's centre, as rings; without them every leg starts at the door.
    """
    space = shapely.union_all([shapely.Polygon(rings[0], rings[1:]) for rings in free if rings])
    space = shapely.buffer(space, SLACK)
    shapely.prepare(space)
    stops = _stops(routes)
    lines = [_dense(np.array(routes[names[0]], dtype=np.float64)) for names in stops]
    legs: list[Leg] = []
    before = lines[0][:1]
    for k in _order(lines, space):
        legs.append(Leg(stops[k], _points(_between(before, lines[k], space))))
        before = lines[k]
    legs.append(Leg((), _points(before[::-1])))
    return tuple(legs)


def _stops(routes: Mapping[str, Sequence[Point]]) -> list[tuple[str, ...]]:
    """Return the names of the assets in groups that are visited at once."""
    groups: list[list[str]] = []
    for name, line in sorted(routes.items()):
        near = [g for g in groups if math.dist(routes[g[0]][-1], line[-1]) <= TOGETHER]
        if near:
            near[0].append(name)
        else:
            groups.append([name])
    return [tuple(group) for group in groups]


def _dense(line: Line) -> Line:
    """Return a line with a point at least every `SPACING` metres."""
    pieces = [line[:1]]
    for a, b in pairwise(line):
        count = max(1, math.ceil(math.dist(a, b) / SPACING))
        pieces.append(a + (b - a) * (np.arange(1, count + 1) / count)[:, None])
    return np.concatenate(pieces)


def _ways(line: Line) -> NDArray[np.float64]:
    """Return the way from a line's start to each of its points, metres."""
    return np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])


def _order(lines: Sequence[Line], space: shapely.Geometry) -> list[int]:
    """Return in which order to visit the ends of the lines: always the nearest next, then uncrossed."""
    ends = np.array([lines[0][0], *(line[-1] for line in lines)])
    cost = _distances(lines, ends, space)
    order, left = [0], set(range(1, len(ends)))
    while left:
        order.append(min(left, key=lambda k: (cost[order[-1], k], k)))
        left.remove(order[-1])
    order.append(0)
    improved = True
    while improved:
        improved = False
        for i in range(1, len(order) - 2):
            for j in range(i + 1, len(order) - 1):
                a, b, c, d = order[i - 1], order[i], order[j], order[j + 1]
                if cost[a, c] + cost[b, d] < cost[a, b] + cost[c, d] - 1e-9:
                    order[i : j + 1] = order[i : j + 1][::-1]
                    improved = True
    return [k - 1 for k in order[1:-1]]


def _distances(lines: Sequence[Line], ends: Line, space: shapely.Geometry) -> NDArray[np.float64]:
    """Return about how far it is between any two ends: straight where nothing is between, else along the routes."""
    lengths = np.array([0.0, *(float(_ways(line)[-1]) for line in lines)])
    shared = np.zeros((len(ends), len(ends)))
    for i, one in enumerate(lines, 1):
        for j, other in enumerate(lines[: i - 1], 1):
            count = min(len(one), len(other))
            apart = np.linalg.norm(one[:count] - other[:count], axis=1) > TOGETHER
            shared[i, j] = shared[j, i] = SPACING * (int(np.argmax(apart)) if apart.any() else count)
    along = np.maximum(lengths[:, None] + lengths[None, :] - 2 * shared, 0.0)
    rows, columns = np.triu_indices(len(ends), 1)
    straight = shapely.linestrings(np.stack([ends[rows], ends[columns]], axis=1))
    seen = np.asarray(shapely.covers(space, straight), dtype=np.bool_)
    direct = np.linalg.norm(ends[rows] - ends[columns], axis=1)
    for i, j, open_, metres in zip(rows, columns, seen, direct, strict=True):
        if open_:
            along[i, j] = along[j, i] = metres
        else:
            along[i, j] = along[j, i] = max(along[i, j], metres)
    return along


def _between(one: Line, other: Line, space: shapely.Geometry) -> Line:
    """Return the shortest way from the end of one route to the end of another: back, across, and on."""
    back, on = _ways(one)[-1] - _ways(one), _ways(other)[-1] - _ways(other)
    across = np.linalg.norm(one[:, None] - other[None], axis=2)
    total = back[:, None] + across + on[None]
    order = np.argsort(total, axis=None, kind="stable")
    for some in np.array_split(order, max(1, len(order) // 24)):
        i, j = np.unravel_index(some, total.shape)
        chords = shapely.linestrings(np.stack([one[i], other[j]], axis=1))
        fits = shapely.covers(space, chords) | (across[i, j] < SLACK)
        if fits.any():
            k = int(np.argmax(fits))
            return np.concatenate([one[i[k] :][::-1], other[j[k] :]])
    return np.concatenate([one[::-1], other])


def _points(line: Line) -> tuple[Point, ...]:
    return tuple((float(x), float(y)) for x, y in line)
