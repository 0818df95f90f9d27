"""SceneEval's SUP: does each object rest on, hang at or hang from what should hold it?

SceneEval asks a language model what holds an object; here its flags and its height say so. Its box stands in for its mesh, the
surfaces of what carries it for that one's, and an even lattice of points on the face that is held stands in for random ones.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import MultiPoint, Point

from robolayout.scene import Scene
from robolayout.verify._boxes import Boxes, room_polygon


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


def holder(scene: Scene, found: Boxes, row: int) -> str:
    """Return what should hold an object: "ceiling", "wall", "object" or "ground"."""
    asset = scene.assets[row]
    if asset.on_ceiling and not asset.on_floor:
        return "ceiling"
    if asset.on_wall and not (asset.on_floor or asset.on_object):
        return "wall"
    return "object" if asset.on_object and (not asset.on_floor or found.bottom[row] > SUPPORT.near) else "ground"


def supported(scene: Scene, found: Boxes, row: int) -> bool:
    """Tell whether a placed object is held, by SceneEval's rule."""
    kind = holder(scene, found, row)
    if kind == "wall":
        return bool(_at_wall(scene, found, row))
    points = _lattice(found, row)
    inside = np.asarray(shapely.intersects_xy(room_polygon(scene.room), points[:, 0], points[:, 1]))
    if kind == "ceiling":
        gap = scene.room.wall_height - (found.top[row] - SUPPORT.back)
        return bool(0.0 <= gap < SUPPORT.near and inside.any())
    if kind == "ground":
        gap = found.bottom[row] + SUPPORT.back
        touching = inside & bool(0.0 <= gap < SUPPORT.near)
    else:
        below = shapely.union_all([area for area in found.contacts.get(row, {}).values()])
        touching = np.asarray(shapely.intersects_xy(below, points[:, 0], points[:, 1]))
    return _balanced(points[touching], found.centers[row])


def _balanced(contacts: NDArray[np.float64], center: NDArray[np.float64]) -> bool:
    """Tell whether there are contacts enough and the centre lies within their hull."""
    if len(contacts) < SUPPORT.resting or len(set(map(tuple, contacts.tolist()))) < 3:
        return False
    hull = MultiPoint(contacts).convex_hull
    return bool(hull.area > 0 and hull.intersects(Point(center)))


def _lattice(found: Boxes, row: int) -> NDArray[np.float64]:
    """Return points (n, 2) in plan over an object's footprint, its corners among them."""
    ring = shapely.get_coordinates(found.footprints[row])[:4]
    area = float(found.footprints[row].area)
    side = math.ceil(math.sqrt(min(max(SUPPORT.points_per_area * area, SUPPORT.least), SUPPORT.most)))
    u, v = (grid.reshape(-1, 1) for grid in np.meshgrid(np.linspace(0, 1, side), np.linspace(0, 1, side)))
    return ring[0] + u * (ring[1] - ring[0]) + v * (ring[3] - ring[0])


def _at_wall(scene: Scene, found: Boxes, row: int) -> bool:
    """Tell whether a ray from an object's back, moved 5 mm forward, hits a wall within 1 cm."""
    ring = shapely.get_coordinates(found.footprints[row])[:4]
    forward = (ring[1] + ring[0] - ring[2] - ring[3]) / np.linalg.norm(ring[1] + ring[0] - ring[2] - ring[3])
    starts = np.linspace(ring[2], ring[3], 9) + SUPPORT.back * forward
    rays = shapely.linestrings(np.stack([starts, starts - SUPPORT.near * forward], axis=1))
    low, high = max(found.bottom[row], 0.0), min(found.top[row], scene.room.wall_height)
    return bool(high > low and shapely.intersects(rays, room_polygon(scene.room).exterior).any())
