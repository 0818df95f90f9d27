"""Holds: where a body stands while it opens a door or drawer by its handle, clear of all that the leaf sweeps.

It takes the handle where that is shut and keeps it within reach until it is open. It stands still if there is a place for that;
else it steps back as the leaf comes: a place for each step of the leaf, found from the open one backwards.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from robolayout.assets import Joint, parts, turned
from robolayout.scene import Agent, Asset, Hold, Point
from robolayout.verify._boxes import Boxes, Place, in_plan, out_of_room
from robolayout.verify._space import QUAD_SEGS
from robolayout.verify.drives import Pose
from robolayout.verify.heading import grown, rectangle

STEPS = 12  # steps of a leaf from shut to open
STRIDE = 0.10  # metres that a body may move while the leaf makes one of them
BERTHS = (0.04, 0.02, 0.0)
"""Metres that it keeps from what it steps past, the first that leave it a way: strides are straight and would cut a corner by as much."""
GRAZE = 0.005  # metres by which a stride may yet cut a corner

Leaf = tuple[BaseGeometry, float, float]
"""A convex shape in plan, and between which heights above its thing's middle it lies, metres."""

Stands = Iterable[tuple[float, BaseGeometry, tuple[str, ...]]]
"""Headings in radians, where the centre of a body gets to before a thing at each, and what is moved away for that."""


@dataclass(frozen=True, eq=False)
class _Opening:
    """What opening a door or drawer asks of a body at one heading, in the frame of the thing; one entry a step from shut to open."""

    met: NDArray[np.object_]  # where its centre is while it meets what the leaf sweeps up to the next step
    free: NDArray[np.object_]  # from where it reaches the handle, clear of the leaf before and after
    still: BaseGeometry  # from where it does all of it without a step
    about: BaseGeometry  # a rectangle around all of this


def find_hold(found: Boxes, agent: Agent, row: int, joint: Joint, reach: float, stands: Stands) -> Hold:
    """Return how a body opens something.

    Args:
        found: The boxes.
        agent: The body.
        row: The asset.
        joint: What of it moves.
        reach: How far the body reaches at the height of its handle, metres.
        stands: Where the body can be, in the asset's frame.
    """
    asset, place = found.where(row)
    aside = _aside(found, row, joint)
    walk = Hold(asset.name, joint.name, ())
    for heading, region, chairs in stands:
        asked = _opening(asset, joint, round(place[2], 6), agent, round(heading, 9), reach)
        still: Any = region & asked.still
        moved = tuple(dict.fromkeys(chairs + aside))
        if still.area > 0:
            x, y = shapely.get_coordinates(shapely.maximum_inscribed_circle(still))[0].tolist()
            return Hold(asset.name, joint.name, _in_room([(x, y, heading)], place), moved)
        if not walk.poses and (places := _walk(region, asked)):
            walk = Hold(asset.name, joint.name, _in_room([(x, y, heading) for x, y in places], place), moved)
    return walk


def _in_room(poses: Iterable[Pose], place: Place) -> tuple[Pose, ...]:
    """Return poses of an asset's frame in the room."""
    return tuple((*in_plan(np.array([x, y]), place).tolist(), heading + place[3]) for x, y, heading in poses)


@lru_cache(maxsize=4096)
def _opening(asset: Asset, joint: Joint, z: float, agent: Agent, heading: float, reach: float) -> _Opening:
    """Return what opening asks; the same in every layout in which the thing's middle is as high."""
    leaves = _leaves(asset, joint)
    met = [_met(step, agent, heading, z) for step in leaves]
    hands = [shapely.Point(turned(joint, np.array([joint.handle]), far)[0, :2]) for far in _steps(joint)]
    near: Any = shapely.buffer(hands, reach, quad_segs=QUAD_SEGS)
    free = [ring.difference(shapely.union_all(met[max(k - 1, 0) : k + 1])) for k, ring in enumerate(near)]
    about = shapely.box(*shapely.total_bounds(near))
    return _Opening(np.array(met), np.array(free), shapely.intersection_all(free), about)


def _steps(joint: Joint) -> list[float]:
    """Return how far a joint is open at each step, radians or metres."""
    return np.linspace(0.0, joint.span[1], STEPS + 1).tolist()


@lru_cache(maxsize=2048)
def _leaves(asset: Asset, joint: Joint) -> list[list[Leaf]]:
    """Return what the parts of a leaf sweep between each two steps, in the asset's frame."""
    moving = [part.vertices for part in parts(asset) if part.joint == joint]
    swept = [
        [np.concatenate([turned(joint, points, end) for end in ends]) for points in moving]
        for ends in pairwise(_steps(joint))
    ]
    return [
        [
            (shapely.MultiPoint(points[:, :2]).convex_hull, float(points[:, 2].min()), float(points[:, 2].max()))
            for points in step
        ]
        for step in swept
    ]


def _aside(found: Boxes, row: int, joint: Joint) -> tuple[str, ...]:
    """Return what people move that stands where a leaf comes."""
    (asset, place), rows = found.where(row), np.flatnonzero(found.movable & found.placed & ~found.flat)
    others = [other for other in rows.tolist() if other != row]
    if not others:
        return ()
    leaves = [leaf for step in _leaves(asset, joint) for leaf in step]
    shapes, low, high = (np.array(column) for column in zip(*leaves, strict=True))
    met = [
        other
        for other in others
        if (
            (low + place[2] < found.top[other])
            & (high + place[2] > found.bottom[other])
            & shapely.intersects(shapes, out_of_room(found.footprints[other], place))
        ).any()
    ]
    return tuple(found.names[other] for other in met)


def _met(leaves: Sequence[Leaf], agent: Agent, heading: float, z: float) -> BaseGeometry:
    """Return where the centre of a body is while it meets what is swept at its heights."""
    shapes = [shape for shape, low, high in leaves if z + low < agent.height and z + high > agent.step]
    if agent.length is None or agent.width is None:
        return shapely.union_all([shape.buffer(agent.radius, quad_segs=QUAD_SEGS) for shape in shapes])
    body = rectangle(agent, heading)
    return shapely.union_all([grown(shapely.get_coordinates(shape)[None], body)[0] for shape in shapes])


def _walk(region: BaseGeometry, asked: _Opening) -> list[Point]:
    """Return a place for each step, each within a stride of the one before and the way there clear; none where there is no such way."""
    region = region & asked.about
    if not shapely.intersects(region, asked.free).all():
        return []
    free = shapely.intersection(region, asked.free)
    clear = shapely.buffer(shapely.difference(region, asked.met), GRAZE)
    for berth in BERTHS:
        found = _steps_through(shapely.buffer(free, -berth))
        if found and shapely.covers(clear, [shapely.LineString(ends) for ends in pairwise(found)]).all():
            return found
    return []


def _steps_through(free: NDArray[np.object_]) -> list[Point]:
    """Return a place in each of some regions, each within a stride of the one before; none where there is no such way."""
    ways: list[BaseGeometry] = [free[-1]]
    for places in free[-2::-1]:
        ways.append(places.intersection(ways[-1].buffer(STRIDE)))
    if ways[-1].is_empty:
        return []
    at = ways.pop().representative_point()
    found = [(at.x, at.y)]
    while ways:
        x, y = shapely.get_coordinates(shapely.shortest_line(ways.pop(), shapely.Point(found[-1])))[0].tolist()
        found.append((x, y))
    return found
