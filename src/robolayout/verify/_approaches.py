"""Approaches: what must come within a body's reach for it to use an asset, and where its centre is then."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

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
    # (m,) where the body's centre has it within reach: beyond the edge, never under what carries the asset
    zones: NDArray[np.object_]

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
        some = np.array([number])
        return _zones(self.found, self.agent, self.rows[some], self.edges[some], np.array([reach]), self._whole[some])[
            0
        ]

    def touching(self, body: NDArray[np.float64]) -> NDArray[np.object_]:
        """Return (m,) from where a rectangular body with these corners (4, 2) around its centre touches each approach."""
        size = float(np.hypot(*body.T).max()) + BODY.touch
        near = shapely.buffer(self.swept(body), BODY.touch + ROUNDING, quad_segs=FINE.quad_segs)
        edge = ~self._whole
        beyond = strips(self.edges[edge], np.full(int(edge.sum()), size), size)
        near[edge] = shapely.intersection(near[edge], beyond)
        return _not_under(self.found, self.agent, self.rows, near, self._whole)

    def swept(self, body: NDArray[np.float64]) -> NDArray[np.object_]:
        """Return (m,) where the centre of a body with these corners is while it overlaps each approach's target."""
        result = np.empty(len(self.rows), dtype=object)
        whole = self._whole
        result[~whole] = grown(self.edges[~whole], body)
        feet = shapely.get_coordinates(self.found.footprints[self.rows[whole]]).reshape(-1, 5, 2)[:, :4]
        result[whole] = grown(feet, body)
        return result

    @property
    def _whole(self) -> NDArray[np.bool_]:
        return np.array([not side for side in self.sides], dtype=bool)


def approaches(found: Boxes, agent: Agent) -> Approaches:
    """Return how assets can be used by a body as far as heights tell; none of what needs no use."""
    rows: list[int] = []
    sides: list[str] = []
    reach: list[float] = []
    asked = use_sides(found.assets)
    for row in np.flatnonzero(found.placed & ~needs_no_use(found)).tolist():
        for side in ("",) if found.carriers[row] >= 0 or found.movable[row] else asked[row]:
            far = horizontal_reach(agent, float(found.bottom[row]), float(found.top[row]))
            if side == "front" and opens(found, agent, row):
                far = handle_reach(found, agent, row)
            if far is not None:
                rows.append(row)
                sides.append(side)
                reach.append(far + ROUNDING)
    index, at = np.array(rows, dtype=np.intp), np.array([SIDES.index(side or "front") for side in sides], dtype=np.intp)
    corners = shapely.get_coordinates(found.footprints[index]).reshape(-1, 5, 2)
    edges = np.stack([corners[np.arange(len(at)), at], corners[np.arange(len(at)), at + 1]], axis=1)
    whole = np.array([not side for side in sides], dtype=bool)
    zones = _zones(found, agent, index, edges, np.array(reach), whole)
    for number in range(len(rows)):
        if sides[number] == "front" and opens(found, agent, rows[number]):
            zones[number] = opening_zone(found, agent, rows[number])
    return Approaches(found, agent, index, tuple(sides), edges, zones)


def _zones(
    found: Boxes,
    agent: Agent,
    rows: NDArray[np.intp],
    edges: NDArray[np.float64],
    reach: NDArray[np.float64],
    whole: NDArray[np.bool_],
) -> NDArray[np.object_]:
    """Return from where edges, or whole footprints, are within reach."""
    zones = np.empty(len(rows), dtype=object)
    zones[~whole] = within(edges[~whole], reach[~whole])
    zones[whole] = shapely.buffer(found.footprints[rows[whole]], reach[whole], quad_segs=FINE.quad_segs)
    return _not_under(found, agent, rows, zones, whole)


def _not_under(
    found: Boxes, agent: Agent, rows: NDArray[np.intp], zones: NDArray[np.object_], whole: NDArray[np.bool_]
) -> NDArray[np.object_]:
    """Return zones without what lies under a higher asset that carries the one in question."""
    below = found.carriers[rows]
    under = np.flatnonzero(whole & (below >= 0))
    under = under[found.top[below[under]] > agent.height]
    zones[under] = shapely.difference(zones[under], found.footprints[below[under]])
    return zones


@lru_cache(maxsize=32)
def use_sides(assets: tuple[Asset, ...]) -> tuple[tuple[str, ...], ...]:
    """Return the sides that each asset is used from: its own, else its category's."""
    return tuple(tuple(category_of(a).use_sides if a.use_sides is None else a.use_sides) for a in assets)


def needs_no_use(found: Boxes) -> NDArray[np.bool_]:
    """Return (n,) what nobody needs to get to: rugs, ceiling lamps, what is used from no side."""
    idle = np.array([not sides for sides in use_sides(found.assets)], dtype=bool)
    return found.flat | found.ceiling | idle
