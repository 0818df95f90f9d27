"""What stands in a body's way: the rectangles around the prisms of assets that meet its heights.

Of an asset only the prisms count that meet [step, height]: four legs for a vacuum cleaner under a bed, the post of a lamp for
a child, both arms of a corner sofa but not the floor between them. Where these fill nearly the whole box, the box is taken.
What a person moves in daily use (a chair) stands in the way of walking, but a body with an arm moves it away from what it
stands at.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout.assets import prisms_of
from robolayout.assets.obstacles import SOLID
from robolayout.scene import ROUNDING, Agent, Asset
from robolayout.verify._boxes import Boxes, corners

Rectangles = NDArray[np.float64]  # (m, 4): least x, least y, greatest x, greatest y in metres, in the frame of an asset


@dataclass(frozen=True, eq=False)
class Obstacles:
    """What stands in a body's way."""

    rows: NDArray[np.intp]  # (m,) which asset each shape belongs to
    shapes: NDArray[np.object_]  # (m,) Shapely rectangles in the world frame
    # (m,) whether a shape is a part of an asset that the body may come under or into, not a whole box
    partial: NDArray[np.bool_]
    movable: NDArray[np.bool_]  # (m,) whether this body moves it away to use what it stands at
    shelter: NDArray[np.object_]  # (k,) boxes of the assets that the body may come under or into

    def of(self, rows: set[int] | frozenset[int]) -> Obstacles:
        """Return what is left when only these assets are there; the shelter stays."""
        kept = np.isin(self.rows, list(rows))
        return Obstacles(self.rows[kept], self.shapes[kept], self.partial[kept], self.movable[kept], self.shelter)

    @cached_property
    def movables(self) -> frozenset[int]:
        """The assets in its way that this body moves away from what they stand at."""
        return frozenset(self.rows[self.movable].tolist())

    def moved_for(self, found: Boxes, row: int) -> frozenset[int]:
        """Return which of them are moved away to use an asset."""
        return found.chairs_at(row) & self.movables


_NO_SHAPES = np.empty(0, dtype=np.object_)
_NO_FLAGS = np.empty(0, dtype=np.bool_)
NOTHING = Obstacles(np.empty(0, dtype=np.intp), _NO_SHAPES, _NO_FLAGS, _NO_FLAGS, _NO_SHAPES)
"""No obstacle at all: the empty room."""


def obstacles(found: Boxes, agent: Agent) -> Obstacles:
    """Return what stands in a body's way among the placed assets; rugs never do."""
    at_height = (found.top > agent.step + 1e-9) & (found.bottom < agent.height - 1e-9)
    met = np.flatnonzero(found.placed & ~found.flat & at_height)
    spans = [(round(agent.step - z, 6), round(agent.height - z, 6)) for z in found.bottom[met].tolist()]
    pieces = [part_rectangles(found.assets[row], *span) for row, span in zip(met, spans, strict=True)]
    inner = [rectangles for rectangles in pieces if rectangles is not None]
    is_whole = np.array([rectangles is None for rectangles in pieces], dtype=bool)
    shelter = met[~is_whole]
    rows = np.concatenate([met[is_whole], np.repeat(shelter, [len(rectangles) for rectangles in inner])])
    whole = int(is_whole.sum())
    shapes = found.footprints[rows]
    if inner:
        shapes[whole:] = _placed(found.poses[rows[whole:]], np.concatenate(inner))
    movable = found.chairs[rows] & (agent.reach_distance is not None)
    return Obstacles(rows, shapes, np.arange(len(rows)) >= whole, movable, found.footprints[shelter])


def _placed(poses: NDArray[np.float64], rectangles: Rectangles) -> NDArray[np.object_]:
    """Return rectangles in the frames of poses (x, y, z, yaw) as polygons in the world frame."""
    middle = (rectangles[:, :2] + rectangles[:, 2:]) / 2
    c, s = np.cos(poses[:, 3]), np.sin(poses[:, 3])
    moved = poses.copy()
    moved[:, 0] += c * middle[:, 0] - s * middle[:, 1]
    moved[:, 1] += s * middle[:, 0] + c * middle[:, 1]
    return np.asarray(shapely.polygons(corners(moved, rectangles[:, 2:] - rectangles[:, :2])), dtype=object)


@lru_cache(maxsize=8192)
def part_rectangles(asset: Asset, low: float, high: float) -> Rectangles | None:
    """Return the rectangles around an asset's prisms between two heights; None where they make up its whole box."""
    met = [p for p in prisms_of(asset) if p.high > low + ROUNDING and p.low < high - ROUNDING]
    rectangles = np.array(sorted({(p.x - p.hx, p.y - p.hy, p.x + p.hx, p.y + p.hy) for p in met})).reshape(-1, 4)
    low_in, high_in = (rectangles[:, None, :2] >= rectangles[:, :2]), (rectangles[:, None, 2:] <= rectangles[:, 2:])
    kept = rectangles[(low_in & high_in).all(axis=2).sum(axis=1) == 1]  # those that lie in no other one
    covered = shapely.union_all(shapely.box(*kept.T)).area
    return None if covered >= SOLID * asset.size[0] * asset.size[1] else kept
