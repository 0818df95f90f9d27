"""The shape of a thing: at most eight upright prisms that hold all its parts.

A prism is a rectangle in plan, its corners cut off alike where nothing reaches them (a round top is an octagon), over an
interval of heights. Each convex part is one to begin with, and each slice of a user's own mesh a few; then those two are
made one again and again that add the least empty room. Chairs so keep their backs, tables the room for knees.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout._errors import AssetError
from robolayout.assets.lexicon import category_of
from robolayout.assets.part import Part
from robolayout.scene import Asset


@dataclass(frozen=True)
class PrismConfig:
    """How the shape of a thing becomes few upright prisms."""

    most: int = 8  # prisms of one thing (DESIGN section 6)
    small: float = 0.35  # metres below which all edges of a thing lie whose shape is its box
    spare: float = 0.02  # share of a thing's box that two prisms may waste when they needlessly become one
    floorward: tuple[float, float] = (0.3, 6.0)  # metres of height below which room counts so many times
    slices: int = 16  # slices that a user's own mesh is looked at in, beside those between its level tops
    cells: int = 24  # cells along an edge of a slice of a user's own mesh
    rectangles: int = 6  # rectangles by which a slice of a user's own mesh is covered
    flat: float = 0.99  # least cosine between up and the normal of a face of a user's own mesh that lies level
    top: tuple[float, float] = (0.01, 0.01)  # metres within which faces are one top, and m2 of one that ends a slice
    thin: float = 1e-3  # least metres along each edge of what is cut from a user's own mesh
    least_cut: float = 0.05  # share of the shorter half side below which a corner is not cut off


PRISMS = PrismConfig()

Array = NDArray[np.float64]
Spans = NDArray[np.float64]
"""(n, 10): least and greatest x, y, z, x + y and x - y of the points of a piece; metres, z from the bottom of the thing."""


@dataclass(frozen=True)
class Prism:
    """An upright prism in the frame of a thing: origin in the middle of its box in plan, front along +x; metres."""

    x: float  # middle of the rectangle
    y: float  # middle of the rectangle
    hx: float  # half its depth
    hy: float  # half its width
    cut: float  # how much of either side each cut corner takes
    low: float  # metres above the bottom of the thing where it begins
    high: float  # metres above the bottom of the thing where it ends

    @cached_property
    def outline(self) -> tuple[tuple[float, float], ...]:
        """Its eight corners, counter-clockwise from the front right one."""
        u, v = self.hx - self.cut, self.hy - self.cut
        ring = ((self.hx, -v), (self.hx, v), (u, self.hy), (-u, self.hy))
        return tuple((self.x + sign * a, self.y + sign * b) for sign in (1, -1) for a, b in ring)

    def within(self, other: Prism) -> bool:
        """Return whether it lies in another one in plan; a cut corner of the other that it does not share says no."""
        x, y = abs(self.x - other.x) + self.hx, abs(self.y - other.y) + self.hy
        inside = x <= other.hx + 1e-6 and y <= other.hy + 1e-6
        return inside and (not other.cut or x + y - self.cut <= other.hx + other.hy - other.cut + 1e-6)


@lru_cache(maxsize=4096)
def prisms_of(asset: Asset) -> tuple[Prism, ...]:
    """Return the prisms of a thing, the lowest first; its box where it is small, or nobody knows what it looks like."""
    depth, width, height = asset.size
    box = (Prism(0.0, 0.0, depth / 2, width / 2, 0.0, 0.0, height),)
    drawn = asset.path is not None or asset.parts or category_of(asset).group != "unknown"
    if asset.is_flat or max(asset.size) < PRISMS.small or not drawn:
        return box
    try:
        spans = piece_spans(asset, shut=True) if asset.path is None else piece_spans(asset)
    except AssetError:
        return box
    merged = _merged(spans, PRISMS.spare * depth * width * height)
    rows = zip(merged.tolist(), *(half.tolist() for half in _halves(merged)), strict=True)
    found = (Prism((s[0] + s[1]) / 2, (s[2] + s[3]) / 2, hx, hy, cut, s[4], s[5]) for s, hx, hy, cut in rows)
    return tuple(sorted(found, key=lambda p: (p.low, p.high, p.x, p.y, p.hx, p.hy))) or box


@lru_cache(maxsize=256)
def piece_spans(asset: Asset, *, shut: bool = False) -> Spans:
    """Return what the pieces of a thing span: one row a convex part, some rows a slice of a user's own mesh."""
    from robolayout.assets.meshes import parts

    level = asset.size[2] / 2
    rows: list[Array] = []
    for part in parts(asset, shut=shut):
        rows += [_span(part.vertices)] if part.convex else list(_slices(part))
    spans = np.array(rows).reshape(-1, 10)
    spans[:, 4:6] += level
    return spans if asset.path is None else _thick(spans, asset.size)


def level_tops(part: Part, thick: float) -> Iterator[tuple[float, Any]]:
    """Yield the level tops of a part: height in the part's frame and outline; a user's own mesh has one every `thick` metres."""
    if part.convex:
        z = part.vertices[:, 2]
        level = part.vertices[z >= z.max() - 1e-4, :2]
        if len(level) > 2:
            yield float(z.max()), shapely.convex_hull(shapely.multipoints(level))
        return
    corners = part.vertices[part.faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    up = normal[:, 2] > PRISMS.flat * np.maximum(np.linalg.norm(normal, axis=1), 1e-12)
    bins = np.round(corners[up][:, :, 2].mean(axis=1) / thick)
    for number in np.unique(bins):
        some = corners[up][bins == number]
        yield float(some[:, :, 2].max()), shapely.union_all(shapely.polygons(some[:, :, :2]), grid_size=1e-5)


def _thick(spans: Spans, size: tuple[float, float, float]) -> Spans:
    """Return what faces without a thickness span once they have the least one, within the box of their thing."""
    low, high = spans[:, 0:6:2], spans[:, 1:6:2]
    more = np.maximum(np.minimum(PRISMS.thin, size) - (high - low), 0.0)
    down = np.clip(low - (-size[0] / 2, -size[1] / 2, 0.0), 0.0, more)
    (dx, dy, dz), (ux, uy, uz) = down.T, (more - down).T
    return spans + np.stack([-dx, ux, -dy, uy, -dz, uz, -dx - dy, ux + uy, -dx - uy, ux + dy], axis=1)


def _span(points: Array) -> Array:
    x, y, z = points.T
    return np.array([f(a) for a in (x, y, z, x + y, x - y) for f in (np.min, np.max)])


def _volumes(spans: Spans) -> Array:
    """Return the volumes of prisms around spans, what is near the floor weighing more."""
    hx, hy, cut = _halves(spans)
    return (4.0 * hx * hy - 2.0 * cut * cut) * (_raised(spans[..., 5]) - _raised(spans[..., 4]))


def _raised(z: Array) -> Array:
    """Return heights where those below `FLOORWARD[0]` are stretched."""
    return z + (PRISMS.floorward[1] - 1.0) * np.minimum(z, PRISMS.floorward[0])


def _halves(spans: Spans) -> tuple[Array, Array, Array]:
    """Return half sides of prisms around spans, and by how much their corners are cut."""
    hx, hy = (spans[..., 1] - spans[..., 0]) / 2, (spans[..., 3] - spans[..., 2]) / 2
    x, y = (spans[..., 1] + spans[..., 0]) / 2, (spans[..., 3] + spans[..., 2]) / 2
    far = [spans[..., 7] - x - y, x + y - spans[..., 6], spans[..., 9] - x + y, x - y - spans[..., 8]]
    cut = np.clip(hx + hy - np.max(far, axis=0), 0.0, np.minimum(hx, hy))
    return hx, hy, np.where(cut < PRISMS.least_cut * np.minimum(hx, hy), 0.0, cut)


def _joined(first: Spans, second: Spans) -> Spans:
    """Return what pairs of pieces span together."""
    return np.where(np.arange(10) % 2 == 0, np.minimum(first, second), np.maximum(first, second))


def _merged(spans: Spans, spare: float) -> Spans:
    """Return at most `PRISMS.most` spans that hold all of them, made one where that wastes the least, or less than `spare` m3."""
    spans = np.unique(np.round(spans, 6), axis=0)
    volumes = _volumes(spans)
    waste = np.full((len(spans), len(spans)), np.inf)
    alive = np.ones(len(spans), dtype=bool)

    def update(i: int) -> None:
        others = np.flatnonzero(alive)
        low, high = (f(spans[i, 0:6], spans[others, 0:6]) for f in (np.maximum, np.minimum))
        both = np.maximum(high[:, 1:4:2] - low[:, 0:4:2], 0.0)
        rise = np.maximum(_raised(high[:, 5]) - _raised(low[:, 4]), 0.0)
        added = _volumes(_joined(spans[i], spans[others])) - volumes[i] - volumes[others] + both.prod(axis=1) * rise
        waste[i, others] = waste[others, i] = added
        waste[i, i] = np.inf

    for i in range(len(spans)):
        update(i)
    while (count := int(alive.sum())) > 1:
        i, j = divmod(int(np.argmin(waste)), len(spans))
        if count <= PRISMS.most and waste[i, j] > spare:
            break
        spans[i] = _joined(spans[i], spans[j])
        volumes[i] = _volumes(spans[i])
        alive[j] = False
        waste[j, :] = waste[:, j] = np.inf
        update(i)
    return spans[alive]


def _slices(part: Part) -> Iterator[Array]:
    """Yield what rectangles span that cover a mesh, slice by slice; its level tops end slices."""
    z = part.vertices[:, 2]
    tops = [height for height, area in level_tops(part, PRISMS.top[0]) if area.area > PRISMS.top[1]]
    edges = np.unique(np.round([*np.linspace(z.min(), z.max(), PRISMS.slices + 1), *tops[: PRISMS.slices]], 4))
    edges = edges[np.concatenate([[True], np.diff(edges) > 1e-3])]
    edges[-1] = max(edges[-1], z.max())
    triangles = part.vertices[part.faces]
    step = max(np.ptp(part.vertices[:, :2], axis=0).max() / PRISMS.cells, 1e-3)
    for low, high in pairwise(edges.tolist()):
        met = triangles[(triangles[:, :, 2].max(axis=1) > low + 1e-6) & (triangles[:, :, 2].min(axis=1) < high - 1e-6)]
        if len(met):
            whole = (met[:, :, 2] >= low).all(axis=1) & (met[:, :, 2] <= high).all(axis=1)
            whole &= np.ptp(met[:, :, :2], axis=1).max(axis=1) < step  # of these nothing but their corners is needed
            cut = [points.reshape(-1, 3) for points in clipped(met[~whole], low, high, step)]
            yield from _covers(np.concatenate([met[whole].reshape(-1, 3), *cut]), step)


def clipped(triangles: Array, low: float, high: float, step: float) -> Iterator[Array]:
    """Yield points (n, m, 3) over what of triangles lies between two heights, at most about `step` apart, corners among them."""
    for above in _kept(triangles, low, 1.0):
        for polygons in _kept(above, high, -1.0):
            middle = polygons.mean(axis=1)[:, None]
            after = np.roll(polygons, -1, axis=1)
            counts = 1 + (np.ptp(polygons, axis=1)[:, :2].max(axis=1) / step).astype(int)
            for count in np.unique(counts).tolist():
                some = polygons[counts == count]
                if count > 1:
                    share = np.linspace(0.0, 1.0, count + 1)[:, None, None, None]
                    rim = some + share * (after[counts == count] - some)
                    some = np.moveaxis(rim + share[:, None] * (middle[counts == count] - rim), 2, 0)
                yield some.reshape(len(some), -1, 3)


def _kept(polygons: Array, level: float, sign: float) -> Iterator[Array]:
    """Yield what of convex polygons (n, m, 3) lies above a level (sign 1) or below it (-1), by their number of corners."""
    above = sign * (polygons[:, :, 2] - level)
    sides, which = np.unique(np.sign(above).astype(int), axis=0, return_inverse=True)
    for number, side in enumerate(sides.tolist()):
        some, far = polygons[which.ravel() == number], above[which.ravel() == number]
        corners = list[Array]()
        for i, j in zip(range(len(side)), [*range(1, len(side)), 0], strict=True):
            if side[i] >= 0:
                corners.append(some[:, i])
            if side[i] * side[j] < 0:
                share = (far[:, i] / (far[:, i] - far[:, j]))[:, None]
                corners.append(some[:, i] + share * (some[:, j] - some[:, i]))
        if corners:
            yield np.stack(corners, axis=1)


def _covers(points: Array, step: float) -> Iterator[Array]:
    """Yield what rectangles span that cover points and what these enclose in plan."""
    from scipy.ndimage import binary_fill_holes

    cells = np.floor((points[:, :2] - points[:, :2].min(axis=0)) / step).astype(np.intp)
    mask = np.zeros(cells.max(axis=0) + 1, dtype=bool)
    mask[cells[:, 0], cells[:, 1]] = True
    full = np.asarray(binary_fill_holes(mask))
    left = mask.copy()
    for number in range(PRISMS.rectangles):
        if not left.any():
            return
        last = number == PRISMS.rectangles - 1
        i, j, k, m = (0, full.shape[0], 0, full.shape[1]) if last else largest_block(full, left.astype(float))
        inside = (cells[:, 0] >= i) & (cells[:, 0] < j) & (cells[:, 1] >= k) & (cells[:, 1] < m)
        inside &= left[cells[:, 0], cells[:, 1]] | (not last)
        yield _span(points[inside])
        left[i:j, k:m] = False


def largest_block(full: NDArray[np.bool_], weight: Array) -> tuple[int, int, int, int]:
    """Return between which rows and columns the rectangle of full cells lies that weighs the most; zeros where none is full."""
    best, found = 0.0, (0, 0, 0, 0)
    count = np.pad(weight.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    rows, columns = full.shape
    for i in range(rows):
        kept = np.zeros(columns + 2, dtype=bool)  # columns that are full from row i on, and none on either side
        kept[1:-1] = True
        for j in range(i + 1, rows + 1):
            kept[1:-1] &= full[j - 1]
            ends = np.flatnonzero(kept[1:] != kept[:-1]).tolist()
            if not ends:
                break
            for k, m in zip(ends[::2], ends[1::2], strict=True):
                held = float(count[j, m] - count[i, m] - count[j, k] + count[i, k])
                if held > best + 1e-9:
                    best, found = held, (i, j, k, m)
    return found
