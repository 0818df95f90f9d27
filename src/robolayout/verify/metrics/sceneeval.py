"""SceneEval's metrics that need no language model: COL, NAV, ACC, OOB, SUP, opening clearance.

Objects are the placed assets. Where SceneEval uses an object's mesh, its shape (COL) or box (OOB) stands in: numbers compare with
boxes, not with scans. What SceneEval asks a language model for is taken from the asset: its use sides are the functional ones, its
flags and its height say what should hold it (SUP). There the surfaces of what carries it stand in for that one's mesh, and an
even lattice of points on the face that is held for random ones.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, MultiPoint, Polygon

from robolayout._grid import components
from robolayout.scene import Layout, Opening, Room, Scene
from robolayout.verify._approaches import side_edge, strip, use_sides
from robolayout.verify._boxes import Boxes, boxes, prisms_at, room_polygon, share
from robolayout.verify.metrics._raster import Raster


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


@dataclass(frozen=True)
class SupportConfig:
    """The figures of SceneEval's support rule."""

    back: float = 0.005  # metres that an object is moved away from what holds it before rays are cast
    near: float = 0.01  # metres within which a ray must hit
    points_per_area: int = 256  # points per square metre of the face that is held
    least: int = 32  # least of them
    most: int = 100_000  # most of them
    # contacts that something needs which rests on the ground or on an object; one is enough at a wall or a ceiling
    resting: int = 4


SUPPORT = SupportConfig()


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
        "OOB": float(np.mean([_out_of_bounds(scene, found, row) for row in rows])) if rows else 0.0,
        "SUP": share([_supported(scene, found, row) for row in rows]),
        "opening_clearance": share([part == 0 for part in hidden]),
    }


def colliding(found: Boxes) -> set[str]:
    """Return objects whose prisms' surfaces still meet another's after that one is moved 5 mm off."""
    hit: set[str] = set()
    for a, b in found.pairs(np.flatnonzero(found.placed)).tolist():
        if found.lies_in(a, b, SUPPORT.near) or found.lies_in(b, a, SUPPORT.near):
            continue
        contacts = _contacts(found, a, b, np.zeros(3))
        if contacts and _contacts(found, a, b, _nudge(found, b, contacts)):
            hit |= {found.names[a], found.names[b]}
    return hit


def _contacts(found: Boxes, a: int, b: int, offset: NDArray[np.float64]) -> list[tuple[Any, float]]:
    """Return where surfaces of prisms meet when b is moved: area in plan and height; one wholly inside another does not count."""
    (ones, low, high), (still, bottom, top) = prisms_at(*found.where(a)), prisms_at(*found.where(b))
    others = shapely.transform(still, lambda points: points + offset[:2])
    bottom, top = bottom + offset[2], top + offset[2]
    start, end = np.maximum(low[:, None], bottom), np.minimum(high[:, None], top)
    i, j = np.nonzero((start <= end) & shapely.intersects(ones[:, None], others))
    in_a = shapely.contains_properly(ones[i], others[j]) & (low[i] < bottom[j]) & (top[j] < high[i])
    in_b = shapely.contains_properly(others[j], ones[i]) & (bottom[j] < low[i]) & (high[i] < top[j])
    meets = zip(i[~(in_a | in_b)].tolist(), j[~(in_a | in_b)].tolist(), strict=True)
    return [(shapely.intersection(ones[k], others[m]), float(start[k, m] + end[k, m]) / 2) for k, m in meets]


def _nudge(found: Boxes, b: int, contacts: list[tuple[Any, float]]) -> NDArray[np.float64]:
    """Return 5 mm from the middle of the contacts towards the middle of b."""
    contact = shapely.union_all([place for place, _ in contacts]).centroid
    away = found.poses[b, :3] - (contact.x, contact.y, float(np.mean([level for _, level in contacts])))
    length = float(np.linalg.norm(away))
    return SCENEEVAL.nudge * (away / length if length > 0 else np.array([0.0, 0.0, 1.0]))


def _nav(room: Room, found: Boxes) -> float:
    free, _ = Raster(room, 0.2).free(SCENEEVAL.robot_width, found.footprints[_obstacles(found)])
    _, counts = components(free)
    return float(counts.max() / counts.sum()) if len(counts) else 0.0


def _obstacles(found: Boxes) -> NDArray[np.intp]:
    return np.flatnonzero(found.placed & ((found.bottom + found.top) / 2 <= SCENEEVAL.high))


def accessibility(scene: Scene, found: Boxes) -> dict[str, float]:
    """Return for each placed object with a functional side the best free share of the rectangles in front of those."""
    picture = Raster(scene.room, 0.0)
    covered = {row: picture.mask(found.footprints[row]) for row in map(int, _obstacles(found))}
    count = np.sum(list(covered.values()), axis=0) if covered else np.zeros_like(picture.floor, dtype=int)
    scores: dict[str, float] = {}
    for row in np.flatnonzero(found.placed).tolist():
        free = picture.floor & (count - covered.get(row, 0) == 0)
        zones = [picture.mask(_side_zone(found.footprints[row], side)) for side in use_sides(found.assets)[row]]
        if zones:
            scores[found.names[row]] = max(float(free[zone].mean()) if zone.any() else 0.0 for zone in zones)
    return scores


def _side_zone(footprint: Polygon, side: str) -> Polygon:
    gap = shapely.get_coordinates(strip(side_edge(footprint, side), SCENEEVAL.side_gap))
    return strip(LineString(gap[1:3]), SCENEEVAL.side_depth)


def _out_of_bounds(scene: Scene, found: Boxes, row: int) -> bool:
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
    plan = found.poses[row, :2] + points[:, :1] * (ring[0] - ring[3]) + points[:, 1:2] * (ring[1] - ring[0])
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


def _supported(scene: Scene, found: Boxes, row: int) -> bool:
    """Tell whether a placed object is held, by SceneEval's rule: its flags say whether at ceiling, wall, object or ground."""
    asset, points = scene.assets[row], _lattice(found, row)
    touching = np.asarray(shapely.intersects_xy(room_polygon(scene.room), *points.T))
    if asset.on_ceiling and not asset.on_floor:
        gap = scene.room.wall_height - (found.top[row] - SUPPORT.back)
        return bool(0.0 <= gap < SUPPORT.near and touching.any())
    if asset.on_wall and not (asset.on_floor or asset.on_object):
        return _at_wall(scene, found, row)
    if asset.on_object and (not asset.on_floor or found.bottom[row] > SUPPORT.near):
        below = shapely.union_all(list(found.contacts.get(row, {}).values()))
        touching = np.asarray(shapely.intersects_xy(below, *points.T))
    elif not 0.0 <= found.bottom[row] + SUPPORT.back < SUPPORT.near:
        return False
    hull = MultiPoint(points[touching]).convex_hull
    balanced = hull.area > 0 and hull.intersects(shapely.Point(found.poses[row, :2]))
    return bool(balanced and touching.sum() >= SUPPORT.resting)


def _lattice(found: Boxes, row: int) -> NDArray[np.float64]:
    """Return points (n, 2) in plan over an object's footprint, its corners among them."""
    ring = shapely.get_coordinates(found.footprints[row])[:4]
    area = float(found.footprints[row].area)
    side = math.ceil(math.sqrt(min(max(SUPPORT.points_per_area * area, SUPPORT.least), SUPPORT.most)))
    u, v = np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side))
    return ring[0] + u.reshape(-1, 1) * (ring[1] - ring[0]) + v.reshape(-1, 1) * (ring[3] - ring[0])


def _at_wall(scene: Scene, found: Boxes, row: int) -> bool:
    """Tell whether a ray from an object's back, moved 5 mm forward, hits a wall within 1 cm."""
    ring = shapely.get_coordinates(found.footprints[row])[:4]
    forward = (ring[0] - ring[3]) / np.linalg.norm(ring[0] - ring[3])
    starts = np.linspace(ring[2], ring[3], 9) + SUPPORT.back * forward
    rays = shapely.linestrings(np.stack([starts, starts - SUPPORT.near * forward], axis=1))
    low, high = max(found.bottom[row], 0.0), min(found.top[row], scene.room.wall_height)
    return bool(high > low and shapely.intersects(rays, room_polygon(scene.room).exterior).any())
