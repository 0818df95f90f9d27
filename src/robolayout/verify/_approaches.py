"""Approaches: what must come within a body's reach for it to use an asset, and where its centre is then."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString
from shapely.geometry.base import BaseGeometry

from robolayout.assets import category_of
from robolayout.scene import ROUNDING, Agent, Asset
from robolayout.scene.agent import BODY, horizontal_reach
from robolayout.verify._boxes import Boxes
from robolayout.verify._sides import SIDES, strips, within
from robolayout.verify._swept import handle_reach, opening_zone, opens
from robolayout.verify.heading import grown
from robolayout.verify.limits import FINE


@dataclass(frozen=True, eq=False)
class Approaches:
    """One row for each side that an asset is used from, in the order of the scene."""

    found: Boxes  # the assets' boxes
    agent: Agent  # the body
    rows: NDArray[np.intp]  # (m,) the assets
    sides: tuple[str, ...]  # the sides; empty for the whole footprint of what is carried or movable
    edges: NDArray[np.float64]  # (m, 2, 2) the ends of the sides; of a footprint, those of its front
    reach: NDArray[np.float64]  # (m,) metres within which the body's centre has them in plan

    @cached_property
    def zones(self) -> NDArray[np.object_]:
        """(m,) where the body's centre has it within reach: beyond the edge, never under what carries the asset."""
        zones = self._within(np.arange(len(self.rows)), self.reach)
        for number, (row, side) in enumerate(zip(self.rows.tolist(), self.sides, strict=True)):
            if side == "front" and opens(self.found, self.agent, row):
                zones[number] = opening_zone(self.found, self.agent, row)
        return zones

    def of(self, row: int) -> list[int]:
        """Return the numbers of an asset's approaches."""
        return np.flatnonzero(self.rows == row).tolist()

    def target(self, number: int) -> BaseGeometry:
        """Return an approach's edge or footprint."""
        if self.sides[number]:
            return LineString(self.edges[number])
        return self.found.footprints[int(self.rows[number])]

    def zone(self, number: int, reach: float) -> BaseGeometry:
        """Return from where an approach is within some other reach in metres."""
        return self._within(np.array([number]), np.array([reach]))[0]

    def _within(self, some: NDArray[np.intp], reach: NDArray[np.float64]) -> NDArray[np.object_]:
        """Return from where the edges, or whole footprints, of some approaches are within reach."""
        zones, whole = np.empty(len(some), dtype=object), self._whole[some]
        zones[~whole] = within(self.edges[some][~whole], reach[~whole])
        feet = self.found.footprints[self.rows[some]][whole]
        zones[whole] = shapely.buffer(feet, reach[whole], quad_segs=FINE.quad_segs)
        return self._not_under(some, zones)

    def _not_under(self, some: NDArray[np.intp], zones: NDArray[np.object_]) -> NDArray[np.object_]:
        """Return zones of some approaches without what lies under a higher asset that carries the one in question."""
        found, below = self.found, self.found.carriers[self.rows[some]]
        under = np.flatnonzero(self._whole[some] & (below >= 0))
        under = under[found.top[below[under]] > self.agent.height]
        zones[under] = shapely.difference(zones[under], found.footprints[below[under]])
        return zones

    def touching(self, body: NDArray[np.float64]) -> NDArray[np.object_]:
        """Return (m,) from where a rectangular body with these corners (4, 2) around its centre touches each approach."""
        size = float(np.hypot(*body.T).max()) + BODY.touch
        near = shapely.buffer(self.swept(body), BODY.touch + ROUNDING, quad_segs=FINE.quad_segs)
        edge = ~self._whole
        beyond = strips(self.edges[edge], np.full(int(edge.sum()), size), size)
        near[edge] = shapely.intersection(near[edge], beyond)
        return self._not_under(np.arange(len(self.rows)), near)

    def swept(self, body: NDArray[np.float64]) -> NDArray[np.object_]:
        """Return (m,) where the centre of a body with these corners is while it overlaps each approach's target."""
        result = np.empty(len(self.rows), dtype=object)
        whole = self._whole
        result[~whole] = grown(self.edges[~whole], body)
        feet = shapely.get_coordinates(self.found.footprints[self.rows[whole]]).reshape(-1, 5, 2)[:, :4]
        result[whole] = grown(feet, body)
        return result

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
            if side == "front" and opens(found, agent, row):
                far = handle_reach(found, agent, row)
            if far is not None:
                items.append((row, side, far + ROUNDING))
    rows = np.array([row for row, _, _ in items], dtype=np.intp)
    at = np.array([SIDES.index(side or "front") for _, side, _ in items], dtype=np.intp)
    corners, each = shapely.get_coordinates(found.footprints[rows]).reshape(-1, 5, 2), np.arange(len(at))
    edges = np.stack([corners[each, at], corners[each, at + 1]], axis=1)
    return Approaches(
        found, agent, rows, tuple(side for _, side, _ in items), edges, np.array([far for *_, far in items])
    )


@lru_cache(maxsize=32)
def use_sides(assets: tuple[Asset, ...]) -> tuple[tuple[str, ...], ...]:
    """Return the sides that each asset is used from: its own, else its category's."""
    return tuple(tuple(category_of(a).use_sides if a.use_sides is None else a.use_sides) for a in assets)


def needs_no_use(found: Boxes) -> NDArray[np.bool_]:
    """Return (n,) what nobody needs to get to: rugs, ceiling lamps, what is used from no side."""
    idle = np.array([not sides for sides in use_sides(found.assets)], dtype=bool)
    return found.flat | found.ceiling | idle
