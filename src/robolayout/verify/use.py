"""Use: can the agent stand where each asset can be used?

An asset is used from its sides (a wardrobe from the front, a bed from left or right). The agent can use it when its
centre can stand in the main component, beyond that side's edge, within horizontal and vertical reach, and when what
must be opened has room to open. What stands on something is reached over the edge of its carrier, and what a person
moves in daily use (a chair) is taken hold of from any side.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
import shapely
from shapely import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from robolayout.assets import category_of
from robolayout.scene import Agent, Layout, Point, Scene
from robolayout.verify._boxes import AREA_TOLERANCE, Boxes, boxes, room_polygon, share, shared_area
from robolayout.verify._space import QUAD_SEGS, REACH_SLACK
from robolayout.verify.navigation import navigation

SIDES = ("front", "left", "back", "right")
"""Sides in counter-clockwise order, starting with the one that faces +x at zero rotation."""

FAR = 3.0
"""Metres from a side beyond which no place to stand is looked for."""


@dataclass(frozen=True)
class Use:
    """Whether and how an asset can be used.

    Attributes:
        asset: Its name.
        usable: The verdict.
        side: The side it is used from; empty where any side will do.
        stand: A place for the agent's centre, metres; None where it is not usable or needs no use.
        reason: Why it cannot be used, as the end of a sentence; empty if it can.
    """

    asset: str
    usable: bool
    side: str
    stand: Point | None
    reason: str


@dataclass(frozen=True, eq=False)
class Usage:
    """Which assets an agent can use; details are worked out when first asked for.

    Attributes:
        agent: The body.
        usable: Verdict per asset.
    """

    agent: Agent
    usable: Mapping[str, bool]
    _judge: _Judge = field(repr=False)

    @property
    def usable_share(self) -> float:
        """Share of all assets that can be used."""
        return share(list(self.usable.values()))

    @cached_property
    def uses(self) -> Mapping[str, Use]:
        """How each placed asset is used, or why not."""
        return {name: self._judge.explain(row) for row, name in enumerate(self.usable) if self._judge.found.placed[row]}


def usage(
    scene: Scene, layout: Layout, agent: Agent | None = None, *, standing: Sequence[BaseGeometry] | None = None
) -> Usage:
    """Judge what an agent can use.

    Args:
        scene: The scene.
        layout: The layout.
        agent: The body; the scene's first one if None.
        standing: Where its centre can stand, one region per heading; the disc's main component if None.
    """
    agent = agent or scene.agent
    regions = [navigation(scene, layout, agent).main] if standing is None else list(standing)
    judge = _Judge(scene, boxes(scene, layout), agent, [region for region in regions if not region.is_empty])
    return Usage(agent, {name: judge.usable(row) for row, name in enumerate(judge.found.names)}, judge)


def horizontal_reach(agent: Agent, bottom: float, top: float) -> float | None:
    """Return the horizontal reach in metres to something between two heights; None if it is out of reach in height.

    An agent without a reach distance only gets to things, whatever their height. With a shoulder height the reach is a
    sphere around the shoulder, otherwise a cylinder between the lowest and the highest height it reaches.
    """
    if agent.reach_distance is None:
        return agent.reach
    low, high = max(bottom, agent.reach_low), min(top, agent.reach_high)
    if low > high + REACH_SLACK:
        return None
    if agent.shoulder_height is None:
        return agent.reach
    height = abs(min(max(agent.shoulder_height, low), high) - agent.shoulder_height)
    return math.sqrt(agent.reach**2 - height**2) if height <= agent.reach else None


class _Judge:
    """Looks at one asset after the other."""

    def __init__(self, scene: Scene, found: Boxes, agent: Agent, standing: Sequence[BaseGeometry]) -> None:
        self.scene, self.found, self.agent, self.standing = scene, found, agent, standing
        self.room = room_polygon(scene.room)
        for region in standing:
            shapely.prepare(region)

    def usable(self, row: int) -> bool:
        if not self.found.placed[row]:
            return False
        return self._needs_no_use(row) or next(self._ways(row), None) is not None

    def _needs_no_use(self, row: int) -> bool:
        return bool(self.found.flat[row] or self.found.ceiling[row]) or self._sides(row) == ()

    def _sides(self, row: int) -> tuple[str, ...]:
        asset = self.scene.assets[row]
        return tuple(category_of(asset).use_sides if asset.use_sides is None else asset.use_sides)

    def _approaches(self, row: int) -> dict[str, BaseGeometry]:
        """Return, by side, what must come within reach: edges, or the footprint of what is carried or movable."""
        if self.found.carrier(row) is not None or category_of(self.scene.assets[row]).movable:
            return {"": self.found.footprints[row]}
        return {side: side_edge(self.found.footprints[row], side) for side in self._sides(row)}

    def _ways(self, row: int) -> Iterator[tuple[str, BaseGeometry, BaseGeometry]]:
        """Yield sides that the agent can use an asset from, with the zone within reach and where it stands there."""
        reach = horizontal_reach(self.agent, self.found.bottom[row], self.found.top[row])
        if reach is None:
            return
        for side, target in self._approaches(row).items():
            zone = self._zone(row, target, reach + REACH_SLACK)
            region = next((region for region in self.standing if region.intersects(zone)), None)
            if region is not None and not self.opening_blockers(row, side):
                yield side, zone, region

    def _zone(self, row: int, target: BaseGeometry, reach: float) -> BaseGeometry:
        """Return from where a side or a footprint is within reach; never from under the asset that carries it."""
        zone, carrier = _within(target, reach), self.found.carrier(row)
        if carrier is None or self.found.top[carrier] <= self.agent.height:
            return zone
        return zone.difference(self.found.footprints[carrier])

    def opening_blockers(self, row: int, side: str) -> tuple[str, ...]:
        """Return what stands in the depth that an asset needs in front to be opened: names, or "the wall"."""
        depth = category_of(self.scene.assets[row]).open_depth if side == "front" else 0.0
        if depth <= 0:
            return ()
        zone = strip(side_edge(self.found.footprints[row], side), depth)
        names = ["the wall"] if zone.difference(self.room).area > AREA_TOLERANCE else []
        found = self.found
        shared = np.minimum(found.top, found.top[row]) - np.maximum(found.bottom, found.bottom[row]) > 0.01
        rows = np.flatnonzero(found.placed & ~found.flat & shared & (np.arange(len(found.names)) != row))
        area = shared_area(found.footprints[rows], zone)
        names += [
            found.names[other]
            for other, taken in zip(rows, area, strict=True)
            if taken > AREA_TOLERANCE and not category_of(self.scene.assets[other]).movable
        ]
        return tuple(names)

    def explain(self, row: int) -> Use:
        name = self.found.names[row]
        if self._needs_no_use(row):
            return Use(name, True, "", None, "")
        way = next(self._ways(row), None)
        if way is None:
            return Use(name, False, "", None, self._reason(row))
        side, zone, region = way
        target = self._approaches(row)[side].centroid
        spot = shapely.get_coordinates(shapely.shortest_line(region.intersection(zone), target))[0]
        return Use(name, True, side, (float(spot[0]), float(spot[1])), "")

    def _reason(self, row: int) -> str:
        agent, found = self.agent, self.found
        bottom, top = float(found.bottom[row]), float(found.top[row])
        reach = horizontal_reach(agent, bottom, top)
        if reach is None:
            return _height_reason(agent, bottom, top)
        approaches = self._approaches(row)
        blockers = [name for side in approaches for name in self.opening_blockers(row, side)]
        if blockers:
            return f"its front has no room to open: {' and '.join(blockers)} in the way"
        sides = " or ".join(side for side in approaches if side) or "edge"
        away = min((self._nearest(row, target) for target in approaches.values()), default=math.inf)
        if away > FAR:
            return f"there is no place to stand at its {sides}"
        return f"the nearest place to stand is {away:.2f} m from its {sides}, reach is {reach:.2f} m at that height"

    def _nearest(self, row: int, target: BaseGeometry) -> float:
        """Return metres from an edge or a footprint to the nearest place to stand beyond it."""
        zone = self._zone(row, target, FAR)
        places = [place for region in self.standing if not (place := region.intersection(zone)).is_empty]
        return min((place.distance(target) for place in places), default=math.inf)


def _height_reason(agent: Agent, bottom: float, top: float) -> str:
    if bottom > agent.reach_high:
        return f"it begins {bottom:.2f} m high, reach ends at {agent.reach_high:.2f} m: {bottom - agent.reach_high:.2f} m too high"
    if top < agent.reach_low:
        return (
            f"it ends {top:.2f} m high, reach begins at {agent.reach_low:.2f} m: {agent.reach_low - top:.2f} m too low"
        )
    shoulder = agent.shoulder_height or 0.0
    away = bottom - shoulder if bottom > shoulder else shoulder - top
    return (
        f"it is {away:.2f} m {'above' if bottom > shoulder else 'below'} the shoulder at {shoulder:.2f} m, reach is "
        f"{agent.reach:.2f} m: {away - agent.reach:.2f} m too {'high' if bottom > shoulder else 'low'}"
    )


def side_edge(footprint: Polygon, side: str) -> LineString:
    """Return a side's edge, counter-clockwise, so that outside is on its right."""
    ring = shapely.get_coordinates(footprint)
    at = SIDES.index(side)
    return LineString((ring[at], ring[at + 1]))


def _within(target: BaseGeometry, reach: float) -> BaseGeometry:
    """Return everything within `reach` of a footprint, or of an edge on its right-hand (outer) side."""
    near = target.buffer(reach, quad_segs=QUAD_SEGS)
    return near.intersection(strip(target, reach, margin=reach)) if isinstance(target, LineString) else near


def strip(edge: LineString, depth: float, margin: float = 0.0) -> Polygon:
    """Return the rectangle `depth` metres deep on the right of an edge, `margin` metres longer at both ends."""
    (ax, ay), (bx, by) = edge.coords
    length = math.hypot(bx - ax, by - ay)
    dx, dy = (bx - ax) / length, (by - ay) / length
    ax, ay, bx, by = ax - dx * margin, ay - dy * margin, bx + dx * margin, by + dy * margin
    return Polygon(((ax, ay), (ax + dy * depth, ay - dx * depth), (bx + dy * depth, by - dx * depth), (bx, by)))
