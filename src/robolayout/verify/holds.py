"""Holds: where a body stands while it opens a door or drawer by its handle, clear of all that the leaf sweeps.

It takes the handle where that is shut and keeps it within reach until it is open. It stands still if there is a place for that;
else it steps back as the leaf comes: a place for each step of the leaf, found from the open one backwards.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from robolayout.assets import Joint, parts, turned
from robolayout.scene import Agent, Asset, Hold, Point
from robolayout.verify._boxes import Boxes, in_plan, out_of_room
from robolayout.verify._space import areas
from robolayout.verify.heading import grown, rectangle
from robolayout.verify.limits import FINE


@dataclass(frozen=True)
class StrideConfig:
    """How a body steps aside while it opens something."""

    steps: int = 12  # steps of a leaf from shut to open
    longest: float = 0.10  # metres that a body may move while the leaf makes one of them
    # metres kept from what it steps past, the first that leave a way: strides are straight, and cut corners by as much
    berths: tuple[float, float, float] = (0.04, 0.02, 0.0)
    graze: float = 0.005  # metres by which a stride may yet cut a corner


STRIDES = StrideConfig()


Stands = Iterable[tuple[float, BaseGeometry, tuple[str, ...]]]
"""Headings in radians, where the centre of a body gets to before a thing at each, and what is moved away for that."""


@dataclass(frozen=True, eq=False)
class _Leaf:
    """What the parts of a leaf sweep from each step to the next, in the frame of its thing: convex shapes in plan."""

    shapes: NDArray[np.object_]  # (steps, parts)
    corners: NDArray[np.float64]  # (steps * parts, corners, 2) their corners, the last one repeated
    low: NDArray[np.float64]  # (steps, parts) metres above the thing's middle
    high: NDArray[np.float64]  # (steps, parts)

    @cached_property
    def far(self) -> float:
        """Metres from the thing's middle to the farthest that is swept."""
        return float(np.hypot(*np.moveaxis(self.corners, -1, 0)).max())

    def meets(self, low: float, high: float) -> NDArray[np.bool_]:
        """Return (steps, parts) which of them come between two heights above the thing's middle."""
        return (self.low < high) & (self.high > low)


@dataclass(frozen=True, eq=False)
class _Opening:
    """What opening a door or drawer asks of a body at one heading, in the frame of the thing; one entry a step from shut to open."""

    met: NDArray[np.object_]  # where its centre is while it meets what the leaf sweeps up to the next step
    free: NDArray[np.object_]  # from where it reaches the handle, clear of the leaf before and after
    still: BaseGeometry  # from where it does all of it without a step


def find_hold(found: Boxes, agent: Agent, row: int, joint: Joint, reach: float, stands: Stands) -> Hold:
    """Return how a body that reaches so many metres at the height of a handle opens an asset by it; `stands` is in that one's frame."""
    asset, place = found.where(row)
    aside = _aside(found, row, joint)
    walk = Hold(asset.name, joint.name, ())
    for heading, region, chairs in stands:
        turn = round(math.remainder(heading, math.pi), 9)  # a rectangle is the same half a turn later
        asked = (asset, joint, round(place[2], 6), agent, turn, reach)
        places = _places(asked, region.wkb, walks=not walk.poses)
        if places:
            poses = tuple((*in_plan(np.array(at), place).tolist(), heading + place[3]) for at in places)
            walk = Hold(asset.name, joint.name, poses, tuple(dict.fromkeys(chairs + aside)))
        if len(places) == 1:
            break
    return walk


@lru_cache(maxsize=4096)  # while a layout is mended one thing moves: what most others leave free stays as it is
def _places(asked: tuple[Asset, Joint, float, Agent, float, float], stands: bytes, *, walks: bool) -> tuple[Point, ...]:
    """Return where a body that gets to some places, WKB, stands while it opens: one place, or one a step if it `walks`; see `_opening`."""
    region, opening = shapely.from_wkb(stands), _opening(*asked)
    still = areas(region & opening.still)
    if still.is_empty:
        return tuple(_walk(region, opening)) if walks else ()
    x, y = shapely.get_coordinates(shapely.maximum_inscribed_circle(still))[0].tolist()
    return ((x, y),)


@lru_cache(maxsize=4096)
def _opening(asset: Asset, joint: Joint, z: float, agent: Agent, heading: float, reach: float) -> _Opening:
    """Return what opening asks; the same in every layout in which the thing's middle is as high."""
    met = _met(_leaf(asset, joint), agent, heading, z)
    near: Any = shapely.buffer(_hands(joint), reach, quad_segs=FINE.quad_segs)
    free = [ring.difference(shapely.union_all(met[max(k - 1, 0) : k + 1])) for k, ring in enumerate(near)]
    return _Opening(met, np.array(free), areas(shapely.intersection_all(free)))


def _hands(joint: Joint) -> list[shapely.Point]:
    """Return where the handle of a joint is at each step."""
    return [shapely.Point(turned(joint, np.array([joint.handle]), far)[0, :2]) for far in _steps(joint)]


@lru_cache(maxsize=2048)
def within_reach(hands: tuple[tuple[Joint, float], ...]) -> BaseGeometry:
    """Return a rectangle, in the frame of a thing, around all from where its handles are within so many metres while they move."""
    near = [shapely.box(*shapely.total_bounds(_hands(joint))).buffer(reach) for joint, reach in hands]
    return shapely.box(*shapely.total_bounds(near))


def _steps(joint: Joint) -> list[float]:
    """Return how far a joint is open at each step, radians or metres."""
    return np.linspace(0.0, joint.span[1], STRIDES.steps + 1).tolist()


@lru_cache(maxsize=2048)
def _leaf(asset: Asset, joint: Joint) -> _Leaf:
    """Return what the parts of a leaf sweep."""
    moving = [part.vertices for part in parts(asset) if part.joint == joint]
    steps = pairwise(_steps(joint))
    swept = [[np.concatenate([turned(joint, points, end) for end in ends]) for points in moving] for ends in steps]
    shapes = np.array([[shapely.MultiPoint(points[:, :2]).convex_hull for points in step] for step in swept])
    low, high = (np.array([[pick(points[:, 2]) for points in step] for step in swept]) for pick in (np.min, np.max))
    rings = [shapely.get_coordinates(shape) for shape in shapes.ravel()]
    most = max(map(len, rings))
    corners = np.array([np.pad(ring, ((0, most - len(ring)), (0, 0)), mode="edge") for ring in rings])
    return _Leaf(shapes, corners, low, high)


def _aside(found: Boxes, row: int, joint: Joint) -> tuple[str, ...]:
    """Return what people move that stands where a leaf comes."""
    asset, place = found.where(row)
    leaf = _leaf(asset, joint)
    others = np.flatnonzero(found.movable & found.placed & ~found.flat)
    near = shapely.dwithin(found.footprints[others], shapely.Point(place[:2]), leaf.far)
    met: list[str] = []
    for other in others[near & (others != row)].tolist():
        level = leaf.meets(float(found.bottom[other]) - place[2], float(found.top[other]) - place[2])
        if (level & shapely.intersects(leaf.shapes, out_of_room(found.footprints[other], place))).any():
            met.append(found.names[other])
    return tuple(met)


def _met(leaf: _Leaf, agent: Agent, heading: float, z: float) -> NDArray[np.object_]:
    """Return where the centre of a body is while it meets what is swept at its heights in each step."""
    if agent.length is None or agent.width is None:
        larger = shapely.buffer(leaf.shapes, agent.radius, quad_segs=FINE.quad_segs)
    else:
        larger = grown(leaf.corners, rectangle(agent, heading)).reshape(leaf.shapes.shape)
    larger[~leaf.meets(agent.step - z, agent.height - z)] = shapely.Polygon()
    return np.asarray(shapely.union_all(larger, axis=1), dtype=object)


def _walk(region: BaseGeometry, asked: _Opening) -> list[Point]:
    """Return a place for each step, each within a stride of the one before and the way there clear; none where there is no such way."""
    if not shapely.intersects(region, asked.free).all():
        return []
    free = shapely.intersection(region, asked.free)
    for berth in STRIDES.berths:
        if found := _steps_through(shapely.buffer(free, -berth)):
            clear = shapely.buffer(shapely.difference(region, asked.met), STRIDES.graze)
            if shapely.covers(clear, [shapely.LineString(ends) for ends in pairwise(found)]).all():
                return found
    return []


def _steps_through(free: NDArray[np.object_]) -> list[Point]:
    """Return a place in each of some regions, each within a stride of the one before; none where there is no such way."""
    ways: list[BaseGeometry] = [free[-1]]
    for places in free[-2::-1]:
        ways.append(places.intersection(ways[-1].buffer(STRIDES.longest)))
        if ways[-1].is_empty:
            return []
    at = ways.pop().representative_point()
    found = [(at.x, at.y)]
    while ways:
        x, y = shapely.get_coordinates(shapely.shortest_line(ways.pop(), shapely.Point(found[-1])))[0].tolist()
        found.append((x, y))
    return found
