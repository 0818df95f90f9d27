"""From where things are used: their sides and the handles of their doors, what these sweep, and where a body's centre is then."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from robolayout.assets import Joint, category_of, sweeps_of
from robolayout.scene import ROUNDING, Agent, Asset
from robolayout.scene.agent import BODY, horizontal_reach
from robolayout.verify._boxes import Boxes, in_room
from robolayout.verify.heading import grown
from robolayout.verify.limits import FINE, JUDGE

SIDES = ("front", "left", "back", "right")
"""Sides in counter-clockwise order, starting with the one that faces +x at zero rotation."""


def side_edge(footprint: Polygon, side: str) -> LineString:
    """Return a side's edge, counter-clockwise, so that outside is on its right."""
    ring = shapely.get_coordinates(footprint)
    at = SIDES.index(side)
    return LineString((ring[at], ring[at + 1]))


def strip(edge: LineString, depth: float) -> Polygon:
    """Return the rectangle `depth` metres deep on the right of an edge."""
    return strips(shapely.get_coordinates(edge)[None], depth)[0]


def strips(edges: NDArray[np.float64], depth: float, margin: float = 0.0) -> NDArray[np.object_]:
    """Return the rectangles on the right of edges (n, 2, 2): `depth` metres deep, `margin` longer at both ends."""
    along, outward = _axes(edges)
    a, b = edges[:, 0] - along * margin, edges[:, 1] + along * margin
    out = outward * depth
    return np.asarray(shapely.polygons(np.stack([a, a + out, b + out, b], axis=1)), dtype=object)


def within(edges: NDArray[np.float64], reach: NDArray[np.float64]) -> NDArray[np.object_]:
    """Return everything on the right of edges (n, 2, 2) that is no farther from them than `reach` (n,) metres."""
    along, outward = (axis[:, None] * reach[:, None, None] for axis in _axes(edges))
    turn = np.linspace(0.0, math.pi / 2, FINE.quad_segs + 1)[:, None]
    before = edges[:, :1] - along * np.cos(turn) + outward * np.sin(turn)
    after = edges[:, 1:] + outward * np.cos(turn) + along * np.sin(turn)
    return np.asarray(shapely.polygons(np.concatenate([before, after], axis=1)), dtype=object)


def _axes(edges: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return unit vectors (n, 2) along edges and outward from them."""
    along = edges[:, 1] - edges[:, 0]
    along = along / np.linalg.norm(along, axis=1, keepdims=True)
    return along, np.stack([along[:, 1], -along[:, 0]], axis=1)


def swept(found: Boxes, rows: Iterable[int]) -> tuple[NDArray[np.intp], NDArray[np.object_], NDArray[np.float64]]:
    """Return what placed assets sweep beyond their fronts: their rows (m,), the zones (m,) in the room, and heights (m, 2) in metres."""
    items = [(row, sweep) for row in dict.fromkeys(rows) for sweep in sweeps_of(found.assets[row])]
    zones = np.empty(len(items), dtype=object)
    zones[:] = [in_room(sweep.region, found.where(row)[1]) for row, sweep in items]
    levels = np.array([found.poses[row, 2] + np.array(sweep.heights) for row, sweep in items]).reshape(-1, 2)
    return np.array([row for row, _ in items], dtype=np.intp), zones, levels


def handles(found: Boxes, agent: Agent, row: int) -> list[tuple[Joint, float | None]]:
    """Return what of an asset a body with an arm opens by a handle, and its reach there in metres; None where that is too low or high.

    Nothing where the record only asks for room, nor where it reaches no handle and yet the top: it uses that.
    """
    if agent.reach_distance is None:
        return []
    joints = [sweep.joint for sweep in sweeps_of(found.assets[row]) if sweep.joint is not None]
    z, top = float(found.poses[row, 2]), float(found.top[row])
    far = [(joint, horizontal_reach(agent, z + joint.hold[0], z + joint.hold[1])) for joint in joints]
    by_hand = any(reach is not None for _, reach in far)
    return far if by_hand or horizontal_reach(agent, top, top) is None else []


def by_hand(found: Boxes, agent: Agent, row: int) -> tuple[tuple[Joint, float], ...]:
    """Return what of an asset a body opens by a handle at a height that it reaches, and how far it reaches there in metres."""
    return tuple((joint, reach) for joint, reach in handles(found, agent, row) if reach is not None)


@lru_cache(maxsize=4096)
def _opening_zone(asset: Asset, radius: float, far: tuple[tuple[Joint, float], ...]) -> BaseGeometry:
    """Return from where, in the asset's frame, a body opens it: a handle within its reach, and room for its disc beside the leaf."""
    x, y = asset.size[0] / 2, asset.size[1] / 2
    beyond = within(np.array([[(x, -y), (x, y)]]), np.array([max(reach for _, reach in far) + ROUNDING]))[0]
    leaves = {sweep.joint: sweep.leaf.buffer(radius, quad_segs=FINE.quad_segs) for sweep in sweeps_of(asset)}
    near = [(j, shapely.Point(j.handle[:2]).buffer(reach + ROUNDING, quad_segs=FINE.quad_segs)) for j, reach in far]
    return shapely.union_all([beyond.intersection(hand).difference(leaves[joint]) for joint, hand in near])


@dataclass(frozen=True, eq=False)
class Approaches:
    """One row for each side that an asset is used from, in the order of the scene."""

    found: Boxes  # the assets' boxes
    agent: Agent  # the body
    rows: NDArray[np.intp]  # (m,) the assets
    sides: tuple[str, ...]  # the sides; empty for the whole footprint of what is carried or movable
    corners: NDArray[np.float64]  # (m, 4, 2) the corners of the footprint, or the ends of the side, there and back
    reach: NDArray[np.float64]  # (m,) metres within which the body's centre has them in plan

    @cached_property
    def zones(self) -> NDArray[np.object_]:
        """(m,) where the body's centre has it within reach: beyond the edge, never under what carries the asset."""
        zones = self._within(self.reach)
        for number, (row, side) in enumerate(zip(self.rows.tolist(), self.sides, strict=True)):
            if side == "front" and (hands := by_hand(self.found, self.agent, row)):
                zone = _opening_zone(self.found.assets[row], self.agent.radius, hands)
                zones[number] = in_room(zone, self.found.where(row)[1])
        return zones

    def of(self, row: int) -> list[int]:
        """Return the numbers of an asset's approaches."""
        return np.flatnonzero(self.rows == row).tolist()

    @property
    def edges(self) -> NDArray[np.float64]:
        """(m, 2, 2) the ends of the sides; of a footprint, those of its front."""
        return self.corners[:, :2]

    def target(self, number: int) -> BaseGeometry:
        """Return an approach's edge or footprint."""
        return LineString(self.edges[number]) if self.sides[number] else Polygon(self.corners[number])

    @cached_property
    def beyond(self) -> NDArray[np.object_]:
        """(m,) where a place to stand is looked for, however far the body reaches."""
        return self._within(np.full(len(self.rows), JUDGE.far))

    def _within(self, reach: NDArray[np.float64]) -> NDArray[np.object_]:
        """Return from where the edges, or whole footprints, are within reach."""
        zones, whole = within(self.edges, reach), self._whole
        feet = self.found.footprints[self.rows[whole]]
        zones[whole] = shapely.buffer(feet, reach[whole], quad_segs=FINE.quad_segs)
        return self._not_under(zones)

    def _not_under(self, zones: NDArray[np.object_]) -> NDArray[np.object_]:
        """Return zones without what lies under a higher asset that carries the one in question."""
        found, below = self.found, self.found.carriers[self.rows]
        under = np.flatnonzero(self._whole & (below >= 0))
        under = under[found.top[below[under]] > self.agent.height]
        zones[under] = shapely.difference(zones[under], found.footprints[below[under]])
        return zones

    def touching(self, body: NDArray[np.float64]) -> NDArray[np.object_]:
        """Return (m,) from where a rectangular body with these corners (4, 2) around its centre touches each approach."""
        size, edge = float(np.hypot(*body.T).max()) + BODY.touch, ~self._whole
        near = shapely.buffer(grown(self.corners, body), BODY.touch + ROUNDING, quad_segs=FINE.quad_segs)
        near[edge] = shapely.intersection(near[edge], strips(self.edges[edge], size, size))
        return self._not_under(near)

    @cached_property
    def _whole(self) -> NDArray[np.bool_]:
        return np.array([not side for side in self.sides], dtype=bool)


def approaches(found: Boxes, agent: Agent) -> Approaches:
    """Return how assets can be used by a body as far as heights tell; none of what needs no use."""
    items: list[tuple[int, str, float]] = []
    asked = use_sides(found.assets)
    for row in np.flatnonzero(found.placed & ~needs_no_use(found)).tolist():
        for side in ("",) if found.carriers[row] >= 0 or found.movable[row] else asked[row]:
            far = horizontal_reach(agent, float(found.bottom[row]), float(found.top[row]))
            if side == "front" and (hands := handles(found, agent, row)):
                far = max((reach for _, reach in hands if reach is not None), default=None)
            if far is not None:
                items.append((row, side, far + ROUNDING))
    rows = np.array([row for row, _, _ in items], dtype=np.intp)
    at = np.array([SIDES.index(side) if side else -1 for _, side, _ in items], dtype=np.intp)
    every = np.array([*((k, k + 1, k + 1, k) for k in range(4)), (0, 1, 2, 3)])[at]  # the last for whole footprints
    corners = shapely.get_coordinates(found.footprints[rows]).reshape(-1, 5, 2)[np.arange(len(at))[:, None], every]
    return Approaches(
        found, agent, rows, tuple(side for _, side, _ in items), corners, np.array([x for *_, x in items])
    )


@lru_cache(maxsize=32)
def use_sides(assets: tuple[Asset, ...]) -> tuple[tuple[str, ...], ...]:
    """Return the sides that each asset is used from: its own, else its category's."""
    return tuple(tuple(category_of(a).use_sides if a.use_sides is None else a.use_sides) for a in assets)


def needs_no_use(found: Boxes) -> NDArray[np.bool_]:
    """Return (n,) what nobody needs to get to: rugs, ceiling lamps, what is used from no side."""
    idle = np.array([not sides for sides in use_sides(found.assets)], dtype=bool)
    return found.needs_no_reach | idle
