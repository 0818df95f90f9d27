"""Where the centre of a disc may be: the room shrunk by its radius, minus the obstacles grown by it.

Arcs are drawn with 16 chords a quarter turn, which lie inside the true arc by at most 0.12 % of the radius (0.5 mm for
a wheelchair): the free space is exact along every straight edge and larger than the true one by that much at corners.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry

from robolayout.scene import LANDING_DEPTH, Room
from robolayout.verify._boxes import Boxes, landings, room_polygon
from robolayout.verify._obstacles import Obstacles

QUAD_SEGS = 16
"""Chords per quarter turn in every round corner."""
SLIVER = 1e-8
"""Square metres below which a piece of free space is numerical dust."""
REACH_SLACK = 1e-6
"""Metres of rounding that a distance may be above the reach."""


@dataclass(frozen=True, eq=False)
class Space:
    """Free space of a disc.

    Attributes:
        radius: Radius of the disc in metres.
        free: Where its centre may be.
        main: The part of it that the agent comes into; empty if it cannot come in.
        door: Where it comes in: the landing of the first door; None without a door.
    """

    radius: float
    free: MultiPolygon
    main: Polygon
    door: Polygon | None

    @property
    def walkable_ratio(self) -> float:
        """Area of the main component over all free area; 0 if there is none."""
        return float(self.main.area / self.free.area) if self.free.area > 0 else 0.0


def disc_space(room: Room, obstacles: Obstacles, radius: float) -> Space:
    """Return the free space of a disc among obstacles.

    Pockets under or inside furniture that no way leads to are not free.

    The main component is the one with the largest intersection with the first door's landing; without a door, the
    largest. Where furniture fills the whole landing nothing can be entered, and it is empty. A disc too wide to stand
    in an empty landing of 0.9 m gets one as deep as its diameter.
    """
    floor = room_polygon(room)
    eroded = floor.buffer(-radius, quad_segs=QUAD_SEGS)
    grown = shapely.buffer(obstacles.shapes, radius, quad_segs=QUAD_SEGS)
    free = eroded.difference(shapely.union_all(grown)) if len(grown) else eroded
    parts = components(free)
    main, zone = _entered(room, parts, eroded, radius)
    if len(obstacles.shelter) and len(parts) > 1:
        hidden = shapely.union_all(obstacles.shelter)
        shapely.prepare(hidden)
        parts = parts[~shapely.covers(hidden, parts) | shapely.equals(parts, main)]
    return Space(radius, MultiPolygon(list(parts)), main, zone)


def components(space: BaseGeometry) -> NDArray[np.object_]:
    """Return the polygons of a free space, largest first, dust left out."""
    parts = shapely.get_parts(space)
    parts = parts[(shapely.get_type_id(parts) == shapely.GeometryType.POLYGON) & (shapely.area(parts) > SLIVER)]
    return parts[np.argsort(-shapely.area(parts), kind="stable")]


def entry_zone(room: Room, eroded: BaseGeometry, radius: float) -> Polygon | None:
    """Return the landing through which a disc comes in, deeper than 0.9 m if it could not stand in that at all."""
    if not room.doors:
        return None
    landing: Polygon = landings(room)[0]
    if eroded.intersection(landing).area > SLIVER:
        return landing
    return Polygon(room.landing(room.doors[0], max(LANDING_DEPTH, 2 * radius)))


def _entered(
    room: Room, parts: NDArray[np.object_], eroded: BaseGeometry, radius: float
) -> tuple[Polygon, Polygon | None]:
    zone = entry_zone(room, eroded, radius)
    if not len(parts):
        return Polygon(), zone
    if zone is None:
        return parts[0], None
    shared = shapely.area(shapely.intersection(parts, zone))
    best = int(np.argmax(shared))
    return (parts[best] if shared[best] > 0 else Polygon()), zone


def plan_distances(found: Boxes, main: Polygon) -> NDArray[np.float64]:
    """Return metres from each footprint to the main component; infinite if that is empty, NaN where unplaced."""
    if main.is_empty:
        return np.where(found.placed, np.inf, np.nan)
    shapely.prepare(main)
    return shapely.distance(main, found.footprints)


def reached_rows(found: Boxes, distances: NDArray[np.float64], reach: float) -> NDArray[np.bool_]:
    """Return which assets are reached from the main component; ceiling assets and rugs need no reaching."""
    return found.placed & (found.flat | found.ceiling | (distances <= reach + REACH_SLACK))
