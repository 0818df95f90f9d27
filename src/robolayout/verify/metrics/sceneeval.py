"""SceneEval's metrics that need no language model: COL, NAV, ACC, OOB, SUP, opening clearance.

Objects are the placed assets. Where SceneEval uses an object's mesh, its shape (COL) or box (OOB) stands in: numbers compare with
boxes, not with scans. The functional sides that SceneEval asks a language model for are the asset's use sides.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from robolayout._grid import components
from robolayout.scene import Layout, Opening, Room, Scene
from robolayout.verify._approaches import use_sides
from robolayout.verify._boxes import Boxes, boxes, room_polygon, share
from robolayout.verify._sides import side_edge, strip
from robolayout.verify.metrics._raster import raster
from robolayout.verify.metrics.support import SUPPORT, supported


@dataclass(frozen=True)
class SceneEvalConfig:
    """The figures of SceneEval's code."""

    robot_width: float = 0.2  # metres of the robot's width
    high: float = 2.0  # metres of box-centre height above which an object is no obstacle
    nudge: float = 0.005  # metres that the other object is moved before a collision is tested again
    side_gap: float = 0.05  # metres between a functional side and the rectangle that must be free
    side_depth: float = 0.2  # metres that this rectangle is deep
    points_per_volume: int = 5000  # surface points per cubic metre of a box
    least_points: int = 1000  # least of them
    most_points: int = 200_000  # most of them; this bound is ours
    window_depth: float = 0.5  # metres that a window's clearance is deep; a door's is as deep as the door is wide


SCENEEVAL = SceneEvalConfig()


def sceneeval(scene: Scene, layout: Layout) -> dict[str, float]:
    """Return SceneEval's figures of a layout under their names.

    COL, OOB and SUP are shares of objects, NAV is the largest free component over all free pixels, ACC the mean over the objects
    that have a functional side, `opening_clearance` the share of doors and windows that nothing hides.
    """
    found = boxes(scene, layout)
    rows = np.flatnonzero(found.placed).tolist()
    hit, scores = colliding(found), accessibility(scene, found)
    hidden = [occlusion(scene.room, opening, found) for opening in (*scene.room.doors, *scene.room.windows)]
    return {
        "COL": len(hit) / len(rows) if rows else 0.0,
        "COL_scene": float(bool(hit)),
        "NAV": _nav(scene.room, found),
        "ACC": float(np.mean(list(scores.values()))) if scores else 1.0,
        "OOB": float(np.mean([out_of_bounds(scene, found, row) for row in rows])) if rows else 0.0,
        "SUP": share([supported(scene, found, row) for row in rows]),
        "opening_clearance": share([part == 0 for part in hidden]),
    }


def colliding(found: Boxes) -> set[str]:
    """Return objects whose prisms' surfaces still meet another's after that one is moved 5 mm off."""
    hit: set[str] = set()
    for a, b in zip(*(rows.tolist() for rows in found.pairs(np.flatnonzero(found.placed))), strict=True):
        if found.lies_in(a, b, SUPPORT.near) or found.lies_in(b, a, SUPPORT.near):
            continue
        contacts = _contacts(found, a, b, (0.0, 0.0, 0.0))
        if contacts and _contacts(found, a, b, _nudge(found, b, contacts)):
            hit |= {found.names[a], found.names[b]}
    return hit


def _contacts(found: Boxes, a: int, b: int, offset: tuple[float, float, float]) -> list[tuple[Any, float]]:
    """Return where surfaces of prisms meet when b is moved: area in plan and height; one wholly inside another does not count."""
    (ones, low, high), (still, bottom, top) = found.shape(a), found.shape(b)
    others = shapely.transform(still, lambda points: points + np.array(offset[:2]))
    bottom, top = bottom + offset[2], top + offset[2]
    start, end = np.maximum(low[:, None], bottom), np.minimum(high[:, None], top)
    i, j = np.nonzero((start <= end) & shapely.intersects(ones[:, None], others))
    in_a = shapely.contains_properly(ones[i], others[j]) & (low[i] < bottom[j]) & (top[j] < high[i])
    in_b = shapely.contains_properly(others[j], ones[i]) & (bottom[j] < low[i]) & (high[i] < top[j])
    meets = zip(i[~(in_a | in_b)].tolist(), j[~(in_a | in_b)].tolist(), strict=True)
    return [(shapely.intersection(ones[k], others[m]), float(start[k, m] + end[k, m]) / 2) for k, m in meets]


def _nudge(found: Boxes, b: int, contacts: list[tuple[BaseGeometry, float]]) -> tuple[float, float, float]:
    """Return 5 mm from the middle of the contacts towards the middle of b."""
    contact = shapely.union_all([place for place, _ in contacts]).centroid
    height = float(np.mean([level for _, level in contacts]))
    middle = (*found.centers[b], (found.bottom[b] + found.top[b]) / 2)
    away = np.array(middle) - (contact.x, contact.y, height)
    length = float(np.linalg.norm(away))
    unit = away / length if length > 0 else np.array([0.0, 0.0, 1.0])
    return (SCENEEVAL.nudge * float(unit[0]), SCENEEVAL.nudge * float(unit[1]), SCENEEVAL.nudge * float(unit[2]))


def _nav(room: Room, found: Boxes) -> float:
    picture = raster(room, 0.2)
    free = picture.eroded_floor(SCENEEVAL.robot_width)
    for row in map(int, _obstacles(found)):
        free &= ~picture.mask(found.footprints[row].buffer(SCENEEVAL.robot_width / 2))
    _, counts = components(free)
    return float(counts.max() / counts.sum()) if len(counts) else 0.0


def _obstacles(found: Boxes) -> NDArray[np.intp]:
    return np.flatnonzero(found.placed & ((found.bottom + found.top) / 2 <= SCENEEVAL.high))


def accessibility(scene: Scene, found: Boxes) -> dict[str, float]:
    """Return for each placed object with a functional side the best free share of the rectangles in front of those."""
    picture = raster(scene.room, 0.0)
    covered = {row: picture.mask(found.footprints[row]) for row in map(int, _obstacles(found))}
    count = np.sum(list(covered.values()), axis=0) if covered else np.zeros_like(picture.floor, dtype=int)
    scores: dict[str, float] = {}
    for row in np.flatnonzero(found.placed).tolist():
        free = picture.floor & (count - covered.get(row, 0) == 0)
        zones = [picture.mask(_side_zone(found.footprints[row], side)) for side in use_sides(found.assets)[row]]
        if zones:
            scores[found.names[row]] = max(float(free[zone].mean()) if zone.any() else 0.0 for zone in zones)
    return scores


def _side_zone(footprint: Polygon, side: str) -> BaseGeometry:
    edge = side_edge(footprint, side)
    return strip(edge, SCENEEVAL.side_gap + SCENEEVAL.side_depth).difference(
        strip(edge, SCENEEVAL.side_gap).buffer(1e-12, cap_style="flat")
    )


def out_of_bounds(scene: Scene, found: Boxes, row: int) -> bool:
    """Tell whether less than 99 % of random points on an object's box lie above the floor."""
    depth, width, height = scene.assets[row].size
    wanted = max(SCENEEVAL.points_per_volume * depth * width * height, SCENEEVAL.least_points)
    count = int(min(wanted, SCENEEVAL.most_points))
    rng = np.random.default_rng(0)
    areas = np.array([width * height, depth * height, depth * width])
    axis = rng.choice(3, size=count, p=areas / areas.sum())
    points = rng.uniform(-0.5, 0.5, (count, 3))
    points[np.arange(count), axis] = np.where(rng.random(count) < 0.5, -0.5, 0.5)
    ring = shapely.get_coordinates(found.footprints[row])
    plan = found.centers[row] + points[:, :1] * (ring[0] - ring[3]) + points[:, 1:2] * (ring[1] - ring[0])
    above = points[:, 2] * height + (found.bottom[row] + found.top[row]) / 2 >= -1e-9
    inside = above & np.asarray(shapely.intersects_xy(room_polygon(scene.room), plan[:, 0], plan[:, 1]))
    return float(inside.mean()) < 0.99


def occlusion(room: Room, opening: Opening, found: Boxes) -> float:
    """Return the share of an opening that objects in its clearance hide, seen along the wall's normal."""
    wall = room.walls[opening.wall]
    depth = SCENEEVAL.window_depth if opening.sill > 0 else opening.width
    zone = Polygon(
        [wall.point(opening.offset + u, v) for u, v in ((0, 0), (opening.width, 0), (opening.width, depth), (0, depth))]
    )
    low, high = opening.sill, opening.sill + opening.height
    shades: list[Polygon] = []
    for row in np.flatnonzero(found.placed & (found.bottom < high) & (found.top > low)).tolist():
        inside = found.footprints[row].intersection(zone)
        if inside.area > 0:
            along = (shapely.get_coordinates(inside) - np.array(wall.start)) @ np.array(wall.direction)
            shades.append(shapely.box(along.min(), max(found.bottom[row], low), along.max(), min(found.top[row], high)))
    return float(shapely.union_all(shades).area / (opening.width * opening.height))
