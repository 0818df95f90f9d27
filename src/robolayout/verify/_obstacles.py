"""What stands in a body's way: the rectangles around the parts of assets that meet its heights.

An asset that ends below the body's height is in the way with its whole box. Of a higher one only the parts count that meet
[step, height]: four legs for a vacuum cleaner under a bed, the post of a lamp for a child. Each part counts with the
rectangle around it, in the asset's own frame; where these fill nearly the whole box, the box is taken. What a person moves
in daily use (a chair) stands in the way of walking, but a body with an arm moves it away from what it stands at.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout._errors import AssetError
from robolayout.scene import Agent, Asset
from robolayout.verify._boxes import Boxes, corners

FILLED = 0.9
"""Share of a box's footprint from which on its parts count as the whole box."""
MOST = 64
"""Rectangles of one asset beyond which the whole box is taken."""
ROUNDING = 1e-6
"""Metres of height that may be shared by rounding."""
WELDED = 1e-4
"""Metres within which corners of a user's own mesh are one."""

Rectangles = NDArray[np.float64]
"""(m, 4): least x, least y, greatest x, greatest y in metres, in the frame of an asset."""


@dataclass(frozen=True, eq=False)
class Obstacles:
    """What stands in a body's way.

    Attributes:
        rows: (m,) which asset each shape belongs to.
        shapes: (m,) Shapely rectangles in the world frame.
        partial: (m,) whether a shape is a part of an asset that the body may come under or into, not a whole box.
        movable: (m,) whether this body moves it away to use what it stands at.
        shelter: (k,) boxes of the assets that the body may come under or into.
    """

    rows: NDArray[np.intp]
    shapes: NDArray[np.object_]
    partial: NDArray[np.bool_]
    movable: NDArray[np.bool_]
    shelter: NDArray[np.object_]

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
        return found.chairs_at(row) & self.movables if self.movables else self.movables


_NO_SHAPES = np.empty(0, dtype=np.object_)
_NO_FLAGS = np.empty(0, dtype=np.bool_)
NOTHING = Obstacles(np.empty(0, dtype=np.intp), _NO_SHAPES, _NO_FLAGS, _NO_FLAGS, _NO_SHAPES)
"""No obstacle at all: the empty room."""


def obstacles(found: Boxes, agent: Agent) -> Obstacles:
    """Return what stands in a body's way among the placed assets; rugs never do."""
    met = found.meeting(agent.step, agent.height)
    whole: list[int] = []
    rows: list[int] = []
    rectangles: list[Rectangles] = []
    shelter: list[int] = []
    for row in met.tolist():
        low, high = agent.step - float(found.bottom[row]), agent.height - float(found.bottom[row])
        open_ = found.top[row] > agent.height + ROUNDING
        pieces = part_rectangles(found.assets[row], round(low, 6), round(high, 6)) if open_ else None
        if pieces is None:
            whole.append(row)
        else:
            rows += [row] * len(pieces)
            rectangles.append(pieces)
            shelter.append(row)
    shapes = found.footprints[whole]
    if rows:
        shapes = np.concatenate([shapes, _placed(found.poses[rows], np.concatenate(rectangles))])
    every = np.array(whole + rows, dtype=np.intp)
    partial = np.arange(len(shapes)) >= len(whole)
    movable = found.chairs[every] & (agent.reach_distance is not None)
    return Obstacles(every, shapes, partial, movable, found.footprints[shelter])


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
    """Return the rectangles around an asset's parts between two heights; None where they make up its whole box.

    Args:
        asset: The asset.
        low: Metres above its own bottom.
        high: Metres above its own bottom.
    """
    from robolayout.assets.meshes import parts

    try:
        pieces = parts(asset)
    except AssetError:
        return None
    level = -asset.size[2] / 2
    around: list[tuple[float, ...]] = []
    for part in pieces:
        if part.convex:
            least, most = part.vertices.min(axis=0), part.vertices.max(axis=0)
            if most[2] - level > low + ROUNDING and least[2] - level < high - ROUNDING:
                around.append((*least[:2], *most[:2]))
        else:
            around += _pieces_between(part.vertices, part.faces, low + level, high + level)
    kept = _outermost(np.array(around).reshape(-1, 4))
    covered = shapely.union_all(shapely.box(*kept.T)).area
    return None if len(kept) > MOST or covered >= FILLED * asset.size[0] * asset.size[1] else kept


def _outermost(rectangles: Rectangles) -> Rectangles:
    """Return the rectangles that lie in no other one."""
    rectangles = np.array(sorted(set(map(tuple, rectangles.tolist())))).reshape(-1, 4)
    inside = (rectangles[:, None, :2] >= rectangles[None, :, :2]) & (rectangles[:, None, 2:] <= rectangles[None, :, 2:])
    return rectangles[inside.all(axis=2).sum(axis=1) == 1]


def _pieces_between(
    vertices: NDArray[np.float64], faces: NDArray[np.int32], low: float, high: float
) -> list[tuple[float, ...]]:
    """Return the rectangle around each connected piece of a closed surface between two heights."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    z = vertices[faces][:, :, 2]
    cut = faces[(z.max(axis=1) > low + ROUNDING) & (z.min(axis=1) < high - ROUNDING)]
    if not len(cut):
        return []
    _, welded = np.unique(np.round(vertices / WELDED), axis=0, return_inverse=True)
    edges = welded.reshape(-1)[cut][:, [0, 1, 1, 2]].reshape(-1, 2)
    size = int(edges.max()) + 1
    _, label = connected_components(coo_array((np.ones(len(edges)), edges.T), shape=(size, size)), directed=False)
    piece = label[welded.reshape(-1)[cut[:, 0]]]
    found: list[tuple[float, ...]] = []
    for number in sorted(set(piece.tolist())):
        points = _between(vertices[cut[piece == number]], low, high)
        found.append((*points.min(axis=0), *points.max(axis=0)))
    return found


def _between(triangles: NDArray[np.float64], low: float, high: float) -> NDArray[np.float64]:
    """Return the corners (n, 2) in plan of triangles cut off below one height and above another."""
    start, end = triangles.reshape(-1, 3), np.roll(triangles, -1, axis=1).reshape(-1, 3)
    found = [start[(start[:, 2] >= low) & (start[:, 2] <= high), :2]]
    for level in (low, high):
        crossing = (start[:, 2] < level) != (end[:, 2] < level)
        a, b = start[crossing], end[crossing]
        share = ((level - a[:, 2]) / (b[:, 2] - a[:, 2]))[:, None]
        found.append(a[:, :2] + share * (b[:, :2] - a[:, :2]))
    return np.concatenate(found)
