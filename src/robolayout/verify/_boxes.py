"""All assets of a scene as arrays, ready for vectorised Shapely."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Polygon, STRtree
from shapely.affinity import affine_transform

from robolayout.assets import category_of, prisms_of, surfaces_of
from robolayout.assets.mass import centre_of_mass
from robolayout.scene import Asset, Layout, Room, Scene
from robolayout.scene.asset import FLAT_HEIGHT
from robolayout.verify.limits import JUDGE

Place = tuple[float, float, float, float]  # x, y, z in metres and yaw in radians


@dataclass(frozen=True, eq=False)
class Boxes:
    """The boxes of all assets, in the order of the scene; one row each, placed or not."""

    assets: tuple[Asset, ...]
    names: tuple[str, ...]  # asset names
    poses: NDArray[np.float64]  # (n, 4) x, y, z in metres and yaw in radians; NaN where unplaced
    placed: NDArray[np.bool_]  # (n,) whether it has a pose of finite numbers
    footprints: NDArray[np.object_]  # (n,) Shapely polygons in the world frame; empty where unplaced
    bottom: NDArray[np.float64]  # (n,) metres; NaN where unplaced
    top: NDArray[np.float64]  # (n,) metres; NaN where unplaced
    flat: NDArray[np.bool_]  # (n,) whether it is a rug
    ceiling: NDArray[np.bool_]  # (n,) whether it hangs from the ceiling
    needs_no_reach: NDArray[np.bool_]  # (n,) whether nobody needs to get to it: a rug, a lamp on the ceiling, a picture
    movable: NDArray[np.bool_]  # (n,) whether a person moves it in daily use, as a chair

    @cached_property
    def carriers(self) -> NDArray[np.intp]:
        """(n,) row that carries each asset, rugs aside; -1 where none."""
        return self.held_by(~self.flat)

    def pairs(self, rows: NDArray[np.intp]) -> NDArray[np.intp]:
        """Return the pairs (m, 2) of some rows whose footprints meet, the lower row first, in order."""
        footprints = self.footprints[rows]
        found = STRtree(footprints).query(footprints, predicate="intersects").T
        return rows[np.unique(found[found[:, 0] < found[:, 1]], axis=0)]

    def overlapping(self, rows: NDArray[np.intp], area: float, height: float) -> NDArray[np.intp]:
        """Return the pairs (m, 2) of some rows whose boxes share more square metres in plan and metres of height than these."""
        found = self.pairs(rows)
        found = found[self.top[found].min(axis=1) - self.bottom[found].max(axis=1) > height]
        return found[shared_area(*self.footprints[found.T]) > area]

    @property
    def carried(self) -> dict[str, str]:
        """Which asset carries which, rugs aside: by the name of what is carried."""
        return {self.names[row]: self.names[under] for row, under in enumerate(self.carriers) if under >= 0}

    def chain(self, row: int) -> set[int]:
        """Return an asset's row and the rows of everything that carries it."""
        chain = {row}
        while (row := int(self.carriers[row])) >= 0 and row not in chain:
            chain.add(row)
        return chain

    @cached_property
    def chairs(self) -> NDArray[np.bool_]:
        """(n,) whether it is moved away from what it stands at: it is movable, stands on the floor and carries nothing."""
        found = self.movable & ~self.flat & (self.bottom <= JUDGE.carried + FLAT_HEIGHT)
        found[self.carriers[self.carriers >= 0]] = False
        return found

    @cached_property
    def _near_chairs(self) -> NDArray[np.bool_]:
        """(n, chairs) which chairs stand at which asset or at what carries it."""
        near = shapely.dwithin(self.footprints[:, None], self.footprints[self.chairs], JUDGE.at)
        carried = self.carriers >= 0
        near[carried] |= near[self.carriers[carried]]
        return near

    def chairs_at(self, row: int) -> frozenset[int]:
        """Return the chairs that stand at an asset or at what carries it; none for a chair itself."""
        return frozenset(() if self.chairs[row] else np.flatnonzero(self.chairs)[self._near_chairs[row]].tolist())

    def held_by(self, among: NDArray[np.bool_]) -> NDArray[np.intp]:
        """Return (n,) which of the assets `among` carries each, what lies under its middle first; -1 where it would fall."""
        result = np.full(len(self.names), -1, dtype=np.intp)
        for row in self.contacts:
            result[row] = self.carrier(row, among)
        return result

    def carrier(self, row: int, among: NDArray[np.bool_]) -> int:
        """Return which of the assets `among` carries one, what lies under its middle first; -1 where it would fall."""
        kept = {lower: area for lower, area in self.contacts.get(row, {}).items() if among[lower]}
        if not kept or self.overhang(row, kept) > 0.0:
            return -1
        return max(kept, key=lambda lower: (kept[lower].area, -lower))

    @cached_property
    def contacts(self) -> dict[int, dict[int, Any]]:
        """For each asset above the floor, where it lies on surfaces of others: their rows and the area in contact."""
        raised = np.flatnonzero(self.placed & (self.bottom > JUDGE.carried))
        found: dict[int, dict[int, Any]] = {row: {} for row in raised.tolist()}
        level = (self.bottom[raised] + [_lift(self.assets[row]) for row in found])[:, None]
        under = self.placed & (self.bottom < level - JUDGE.lower) & (self.top >= level - JUDGE.carried - 1e-9)
        uppers, lowers = raised[np.nonzero(under)[0]], np.nonzero(under)[1]
        meet = shapely.intersects(self.footprints[uppers], self.footprints[lowers])
        for upper, lower in zip(uppers[meet].tolist(), lowers[meet].tolist(), strict=True):
            area = _shared_base(*self.where(upper), *self.where(lower))
            if area.area > 0.0:
                found[upper][lower] = area
        return found

    def overhang(self, row: int, carriers: Iterable[int]) -> float:
        """Return by how many metres an asset's centre of mass lies too far out over what it lies on; 0 or less where it stands."""
        return _overhang(*self.where(row), tuple(map(self.where, carriers)))

    def by_name(self, values: NDArray[Any]) -> dict[str, Any]:
        """Return values (n,), one of each asset, by its name."""
        return dict(zip(self.names, values.tolist(), strict=True))

    def where(self, row: int) -> tuple[Asset, Place]:
        """Return an asset and where it stands."""
        x, y, z, yaw = self.poses[row].tolist()
        return self.assets[row], (x, y, z, yaw)

    def lies_in(self, row: int, lower: int, sunk: float) -> bool:
        """Return whether an asset hangs from another, or is wholly in the room over a surface of it, `sunk` metres in it at most,
        and below what covers that: on the surface, or on what lies there."""
        if _lift(self.assets[row]) > 0.0 and lower in self.contacts.get(row, ()):
            return True
        above, below = self.assets[row].size, self.assets[lower].size
        level = self.bottom[row] - self.bottom[lower]
        foot = out_of_room(self.footprints[row], self.poses[lower])
        return above[0] * above[1] <= below[0] * below[1] and any(
            level - place.height >= -sunk
            and level + above[2] <= place.height + place.free + JUDGE.carried
            and place.region.buffer(JUDGE.within).covers(foot)
            for place in surfaces_of(self.assets[lower])
        )


def _lift(asset: Asset) -> float:
    """Return the metres above its bottom at which an asset is carried: 0, or the height of the loop that it hangs by."""
    drop = category_of(asset).hangs
    return asset.size[2] - drop if drop else 0.0


# Whoever judges many layouts asks for the same again and again: most things stand where they stood in the one before.


@lru_cache(maxsize=4096)
def prisms_at(asset: Asset, place: Place) -> tuple[NDArray[np.object_], NDArray[np.float64], NDArray[np.float64]]:
    """Return the prisms of a placed asset: outlines in plan, and between which heights each stands, metres."""
    ring, low, high = prism_table(asset)
    bottom = place[2] - asset.size[2] / 2
    return np.asarray(shapely.polygons(in_plan(ring, place)), dtype=object), low + bottom, high + bottom


@lru_cache(maxsize=4096)
def _base(asset: Asset, place: Place) -> Any:
    """Return the hull of a placed asset's lowest prisms, or of the loop that it hangs by."""
    ring, low, _ = prism_table(asset)
    if category_of(asset).hangs:
        x, y = JUDGE.loop
        return shapely.polygons(in_plan(np.array([(x, -y), (x, y), (-x, y), (-x, -y)]), place))
    return shapely.union_all(shapely.polygons(in_plan(ring[low <= low.min() + JUDGE.carried], place))).convex_hull


def in_plan(points: NDArray[np.float64], place: Place) -> NDArray[np.float64]:
    """Return points (..., 2) of an asset's frame where they are in the room."""
    x, y, _, yaw = place
    return points @ np.array([[math.cos(yaw), math.sin(yaw)], [-math.sin(yaw), math.cos(yaw)]]) + (x, y)


def in_room(shape: Any, place: Place) -> Any:
    """Return a shape of an asset's frame as it lies in the room."""
    x, y, _, yaw = place
    c, s = math.cos(yaw), math.sin(yaw)
    return affine_transform(shape, [c, -s, s, c, x, y])


def out_of_room(shape: Any, place: Place) -> Any:
    """Return a shape of the room as it lies in an asset's frame."""
    x, y, _, yaw = place
    c, s = math.cos(yaw), math.sin(yaw)
    return affine_transform(shape, [c, s, -s, c, -c * x - s * y, s * x - c * y])


@lru_cache(maxsize=4096)
def _overhang(upper: Asset, place: Place, carriers: tuple[tuple[Asset, Place], ...]) -> float:
    """Return by how many metres a placed asset's centre of mass lies too far out over what carries it."""
    hull = shapely.union_all([_shared_base(upper, place, *carrier) for carrier in carriers]).convex_hull
    u, v, _ = centre_of_mass(upper)
    middle, depth = shapely.Point(in_plan(np.array([u, v]), place)), min(upper.size[:2])
    inward = hull.boundary.distance(middle) if hull.covers(middle) else -hull.distance(middle)
    return min(JUDGE.steady[0], JUDGE.steady[1] * depth) - inward


@lru_cache(maxsize=4096)
def _shared_base(upper: Asset, place: Place, lower: Asset, under: Place) -> Any:
    """Return where a placed asset's base lies on surfaces of another."""
    level = (place[2] - upper.size[2] / 2 + _lift(upper)) - (under[2] - lower.size[2] / 2)
    hangs = _lift(upper) > 0.0
    near = (s for s in surfaces_of(lower) if abs(s.height - level) <= JUDGE.carried + 1e-9)
    regions = [surface.region for surface in near if surface.is_hook == hangs]
    if not regions:
        return Polygon()
    return shapely.union_all([in_room(region, under) for region in regions]).intersection(_base(upper, place))


@lru_cache(maxsize=1024)
def prism_table(asset: Asset) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return the outlines (k, 8, 2) of an asset's prisms in its frame, and where they begin and end above its bottom."""
    shape = prisms_of(asset)
    ends = np.array([(prism.low, prism.high) for prism in shape])
    return np.array([prism.outline for prism in shape]), ends[:, 0], ends[:, 1]


def _only_seen(asset: Asset) -> bool:
    hung = (asset.on_wall, asset.on_floor, asset.on_object) == (True, False, False)
    return hung and not asset.use_sides and category_of(asset).only_seen


@lru_cache(maxsize=32)
def _fixed(assets: tuple[Asset, ...]) -> tuple[NDArray[np.float64], dict[str, Any]]:
    """Return what does not depend on where assets stand: their sizes (n, 3), and fields of `Boxes`."""
    return np.array([asset.size for asset in assets], dtype=float).reshape(len(assets), 3), {
        "assets": assets,
        "names": tuple(asset.name for asset in assets),
        "flat": np.array([asset.is_flat for asset in assets], dtype=bool),
        "ceiling": np.array([asset.on_ceiling for asset in assets], dtype=bool),
        "needs_no_reach": np.array([a.is_flat or a.on_ceiling or _only_seen(a) for a in assets], dtype=bool),
        "movable": np.array([category_of(asset).movable for asset in assets], dtype=bool),
    }


def boxes(scene: Scene, layout: Layout) -> Boxes:
    """Return the boxes of all assets; poses of names that the scene does not have are ignored."""
    sizes, fixed = _fixed(tuple(scene.assets))
    there = (layout.get(name) for name in fixed["names"])
    poses = np.array(
        [(pose.x, pose.y, pose.z, pose.yaw) if pose else (math.nan,) * 4 for pose in there], dtype=float
    ).reshape(-1, 4)
    placed = np.asarray(np.isfinite(poses).all(axis=1))
    poses[~placed] = np.nan
    footprints = np.full(len(sizes), Polygon(), dtype=object)
    footprints[placed] = shapely.polygons(corners(poses[placed], sizes[placed]))
    return Boxes(
        poses=poses,
        placed=placed,
        footprints=footprints,
        bottom=poses[:, 2] - sizes[:, 2] / 2,
        top=poses[:, 2] + sizes[:, 2] / 2,
        **fixed,
    )


def corners(poses: NDArray[np.float64], sizes: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (n, 4, 2) footprint corners of boxes at (n, 4) poses x, y, z, yaw.

    Counter-clockwise from the front right one, so that the edges are front, left, back, right.
    """
    forward = np.stack([np.cos(poses[:, 3]), np.sin(poses[:, 3])], axis=1)
    left = np.stack([-forward[:, 1], forward[:, 0]], axis=1)
    half_depth, half_width = forward * sizes[:, :1] / 2, left * sizes[:, 1:2] / 2
    center = poses[:, :2]
    ring = (half_depth - half_width, half_depth + half_width, half_width - half_depth, -half_depth - half_width)
    return np.stack([center + corner for corner in ring], axis=1)


@lru_cache(maxsize=32)
def room_polygon(room: Room) -> Polygon:
    """Return the floor as a Shapely polygon."""
    return Polygon(room.vertices)


@lru_cache(maxsize=32)
def landings(room: Room) -> NDArray[np.object_]:
    """Return the landing polygons of all doors (DESIGN section 4)."""
    return np.array([Polygon(room.landing(door)) for door in room.doors], dtype=object)


def shared_area(first: Any, second: Any) -> NDArray[np.float64]:
    """Return the area in square metres that polygons share, pair by pair.

    Where plain intersection finds the whole of one, it is measured again on a grid of 1e-9 m: GEOS returns a whole polygon for
    some pairs that only touch (16 of 100,000 exact touches at multiples of 90 degrees with GEOS 3.14).
    """
    first, second = np.broadcast_arrays(first, second)
    area, meet = np.zeros(first.shape), shapely.intersects(first, second)
    one, other = first[meet], second[meet]
    found = shapely.area(shapely.intersection(one, other))
    whole = found > 0.999 * np.minimum(shapely.area(one), shapely.area(other))
    found[whole] = shapely.area(shapely.intersection(one[whole], other[whole], grid_size=1e-9))
    area[meet] = found
    return area


def share(flags: Any) -> float:
    """Return the share of true values; 1 for none at all."""
    values = np.asarray(flags, dtype=bool)
    return float(values.mean()) if values.size else 1.0
