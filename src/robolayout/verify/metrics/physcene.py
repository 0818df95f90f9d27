"""PhyScene's metrics: Col_obj, Col_scene, R_out, R_walkable, R_reach.

Objects are the placed assets, each by its box, rugs included, as published. A box's contour, drawn as thick as the robot is
wide, blocks every pixel within half that width of the box.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robolayout._grid import Mask, components, window_count
from robolayout.scene import Layout, Room, Scene
from robolayout.verify._boxes import boxes
from robolayout.verify.metrics._raster import Raster


@dataclass(frozen=True)
class PhySceneConfig:
    """The figures of PhyScene's code."""

    robot_width: float = 0.3  # metres of the robot's width
    high: float = 1.5  # metres of box-centre height from which an object is no obstacle
    margin: float = 0.2  # metres around the room in the picture
    # metres and square metres that boxes may share by rounding: what stands on something only touches it
    rounding: float = 1e-9


PHYSCENE = PhySceneConfig()


def physcene(scene: Scene, layout: Layout) -> dict[str, float]:
    """Measure a layout by PhyScene's rules.

    Col_obj and R_out are shares of objects, Col_scene is 1 if any box overlaps another (its mean over scenes is the published
    rate), R_walkable the share of free pixels in the component at the doors (without a door in the largest), R_reach that of
    the objects next to a component, weighted by the component's share of the free floor.
    """
    found = boxes(scene, layout)
    rows = np.flatnonzero(found.placed)
    hit = np.isin(rows, found.overlapping(rows, PHYSCENE.rounding, PHYSCENE.rounding))
    picture = Raster(scene.room, PHYSCENE.margin)
    outside = [bool((picture.mask(found.footprints[row]) & ~picture.floor).any()) for row in rows]
    blocking = rows[(found.bottom[rows] + found.top[rows]) / 2 < PHYSCENE.high]
    free, masks = picture.free(PHYSCENE.robot_width, found.footprints[blocking])
    numbered, counts = components(free)
    return {
        "Col_obj": float(hit.mean()) if len(hit) else 0.0,
        "Col_scene": float(hit.any()),
        "R_out": float(np.mean(outside)) if outside else 0.0,
        "R_walkable": _walkable(scene.room, picture, numbered, counts),
        "R_reach": _reach(masks, numbered, counts),
    }


def _walkable(room: Room, picture: Raster, numbered: NDArray[np.int32], counts: NDArray[np.intp]) -> float:
    if not len(counts):
        return 0.0
    if not room.doors:
        return float(counts.max() / counts.sum())
    ys, xs = np.nonzero(numbered)
    shares: list[float] = []
    for door in room.doors:
        x, y = room.walls[door.wall].point(door.center)
        away = np.hypot(picture.x[xs] - x, picture.y[ys] - y)
        nearest = int(np.argmin(away))
        near = away[nearest] / picture.pixel <= PHYSCENE.robot_width / picture.pixel + 1
        shares.append(float(counts[numbered[ys[nearest], xs[nearest]] - 1] / counts.sum()) if near else 0.0)
    return float(np.mean(shares))


def _reach(masks: list[Mask], numbered: NDArray[np.int32], counts: NDArray[np.intp]) -> float:
    if not masks or not len(counts):
        return 0.0
    touched = np.zeros(len(counts) + 1)
    for mask in masks:
        touched += np.bincount(numbered[window_count(mask, 3) > 0], minlength=len(touched)) > 0
    return float((touched[1:] / len(masks) * counts / counts.sum()).sum())
