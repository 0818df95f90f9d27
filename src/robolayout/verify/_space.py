"""Where the centre of a disc may be: the room shrunk by its radius, minus the obstacles grown by it.

Arcs are drawn with 16 chords a quarter turn, which lie inside the true arc by at most 0.12 % of the radius (0.5 mm for
a wheelchair): the free space is exact along every straight edge and larger than the true one by that much at corners.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry

from robolayout.scene import OPENINGS, ROUNDING, Room
from robolayout.verify._boxes import Boxes, landings, room_polygon
from robolayout.verify._obstacles import Obstacles
from robolayout.verify.limits import FINE, JUDGE

_NONE = np.empty(0, dtype=np.object_)


@dataclass(frozen=True, eq=False)
class Space:
    """Free space of a disc."""

    radius: float  # radius of the disc in metres
    free: MultiPolygon  # where its centre may be
    main: Polygon  # the part of it that the agent comes into; empty if it cannot come in
    door: Polygon | None  # where it comes in: the landing of the first door; None without a door
    empty: BaseGeometry  # where its centre may be in the empty room
    blocking: Obstacles  # what stands in its way

    @cached_property
    def opened(self) -> Callable[[frozenset[int]], NDArray[np.object_]]:
        """Returns what the agent gets to beyond the main component once some assets are moved away."""

        def grown(shapes: NDArray[np.object_], more: float) -> NDArray[np.object_]:
            return shapely.buffer(shapes, self.radius + more, quad_segs=FINE.quad_segs)

        def beyond(rows: frozenset[int]) -> NDArray[np.object_]:
            return opened(self.blocking, rows, (self.empty, self.free, self.main), grown, self.radius)

        return cache(beyond)


def disc_space(room: Room, obstacles: Obstacles, radius: float) -> Space:
    """Return the free space of a disc among obstacles.

    Pockets under or inside furniture that no way leads to are not free.

    The main component is the one with the largest intersection with the first door's landing; without a door, the
    largest. Where furniture fills the whole landing nothing can be entered, and it is empty. A disc too wide to stand
    in an empty landing of 0.9 m gets one as deep as its diameter.
    """
    eroded = _eroded(room, radius)
    free = all_free(room, obstacles, radius)
    parts = components(free)
    zone = entry_zone(room, 0, eroded, radius) if room.doors else None
    main = met(parts, zone)
    if len(obstacles.shelter) and len(parts) > 1:
        hidden = shapely.union_all(obstacles.shelter)
        shapely.prepare(hidden)
        parts = parts[~shapely.covers(hidden, parts) | shapely.equals(parts, main)]
    return Space(radius, MultiPolygon(list(parts)), main, zone, eroded, obstacles)


@lru_cache(maxsize=1024)
def _eroded(room: Room, radius: float) -> BaseGeometry:
    """Return where the centre of a disc may be in the empty room; the same for every layout of it."""
    return room_polygon(room).buffer(-radius, quad_segs=FINE.quad_segs)


def all_free(room: Room, obstacles: Obstacles, radius: float) -> BaseGeometry:
    """Return where the centre of a disc may be, hidden pockets included."""
    if not len(obstacles.shapes):
        return _eroded(room, radius)
    together: Any = shapely.multipolygons(obstacles.shapes)  # grown in one go: half the time of one by one
    return _eroded(room, radius).difference(together.buffer(radius, quad_segs=FINE.quad_segs))


Grow = Callable[[NDArray[np.object_], float], NDArray[np.object_]]
"""Returns convex shapes grown by a body, and by so many metres more."""


def opened(
    obstacles: Obstacles,
    rows: frozenset[int],
    spaces: tuple[BaseGeometry, BaseGeometry, BaseGeometry],
    grow: Grow,
    size: float,
) -> NDArray[np.object_]:
    """Return what a body gets to beyond where it is once some obstacles are moved away, as polygons.

    `spaces` are where its centre may be in the empty room, where as things stand, and where it gets to as things stand; `size` is
    the radius in metres of a disc that holds the body.
    """
    empty, free, main = spaces
    gone = np.isin(obstacles.rows, list(rows))
    shapes, others = obstacles.shapes[gone], obstacles.shapes[~gone]
    if main.is_empty or not shapely.dwithin(main, shapes, size + 2 * ROUNDING).any():
        return _NONE
    near = others[(shapely.distance(shapes[:, None], others) <= 2 * size + 2 * ROUNDING).any(axis=0)]
    place = empty.intersection(shapely.union_all(grow(shapes, ROUNDING)))
    parts = components(place.difference(shapely.union_all(grow(near, 0.0))) if len(near) else place)
    pieces = shapely.get_parts(free)
    shapely.prepare(main)
    beyond = ~shapely.intersects(main, shapely.point_on_surface(pieces))  # `main` consists of whole pieces
    waiting = np.concatenate([parts, pieces[beyond]])
    found = np.array([main], dtype=object)
    last = found
    while len(last):
        joined = shapely.intersects(waiting[:, None], last).any(axis=1)
        last, waiting = waiting[joined], waiting[~joined]
        found = np.concatenate([found, last])
    return found[1:]


def components(space: BaseGeometry) -> NDArray[np.object_]:
    """Return the polygons of a free space, largest first, dust left out."""
    parts = shapely.get_parts(space)
    parts = parts[(shapely.get_type_id(parts) == shapely.GeometryType.POLYGON) & (shapely.area(parts) > JUDGE.sliver)]
    return parts[np.argsort(-shapely.area(parts), kind="stable")]


def areas(space: BaseGeometry) -> MultiPolygon:
    """Return what of a free space has an area: where shapes only touch, their intersection holds lines, too, which GEOS may refuse."""
    return MultiPolygon(list(components(space)))


def entry_zone(room: Room, number: int, eroded: BaseGeometry, radius: float) -> Polygon:
    """Return the landing through which a disc comes in by a door, deeper than 0.9 m if it could not stand in that at all."""
    landing: Polygon = landings(room)[number]
    if eroded.intersection(landing).area > JUDGE.sliver:
        return landing
    return Polygon(room.landing(room.doors[number], max(OPENINGS.landing_depth, 2 * radius)))


def met(parts: NDArray[np.object_], zone: Polygon | None) -> Polygon:
    """Return the polygon that shares most with a zone (None: the first); an empty one where none shares anything with it."""
    if zone is None or not len(parts):
        return parts[0] if len(parts) else Polygon()
    shared = shapely.area(shapely.intersection(parts, zone))
    best = int(np.argmax(shared))
    return parts[best] if shared[best] > 0 else Polygon()


@lru_cache(maxsize=1024)
def further_doors(room: Room, radius: float) -> Mapping[int, Polygon]:
    """Return the landings of the doors after the first that a disc gets to from that one in the empty room, by number."""
    eroded = _eroded(room, radius)
    zones = {number: entry_zone(room, number, eroded, radius) for number in range(len(room.doors))}
    main = met(components(eroded), zones[0]) if zones else Polygon()
    return {number: zone for number, zone in zones.items() if number and main.intersection(zone).area > JUDGE.sliver}


def standing_distances(found: Boxes, space: Space) -> NDArray[np.float64]:
    """Return metres from each footprint to the main component, no chair moved; infinite where that is empty, NaN where unplaced."""
    if space.main.is_empty:
        return np.where(found.placed, np.inf, np.nan)
    shapely.prepare(space.main)
    return shapely.distance(space.main, found.footprints)


def plan_distances(found: Boxes, space: Space, reach: float) -> NDArray[np.float64]:
    """Return metres from each footprint to where a disc can be; infinite if it cannot come in, NaN where unplaced."""
    distances = standing_distances(found, space)
    if space.blocking.movables and not space.main.is_empty:
        asked = found.placed & ~found.needs_no_reach
        for row in np.flatnonzero(asked & (distances > reach + ROUNDING)).tolist():
            moved = space.blocking.moved_for(found, row)
            beyond = shapely.distance(space.opened(moved), found.footprints[row]) if moved else ()
            distances[row] = min((distances[row], *beyond))
    return distances


def reached_rows(found: Boxes, distances: NDArray[np.float64], reach: float) -> NDArray[np.bool_]:
    """Return which assets are reached from where the agent can be; rugs, pictures and what hangs from the ceiling need no reaching."""
    return found.placed & (found.needs_no_reach | (distances <= reach + ROUNDING))


def reached_by(found: Boxes, space: Space, reach: float) -> NDArray[np.bool_]:
    """Return which assets a disc reaches, chairs moved away."""
    return reached_rows(found, plan_distances(found, space, reach), reach)
