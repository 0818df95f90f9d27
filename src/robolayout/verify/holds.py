"""Holds: where a body stands while it opens a door or drawer by its handle, clear of all that the leaf sweeps.

It takes the handle where that is shut and keeps it within reach until it is open. It stands still if there is a place for that;
else it steps back as the leaf comes: a place for each step of the leaf, found from the open one backwards.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from robolayout.assets import Joint, parts, turned
from robolayout.scene import Agent, Hold
from robolayout.verify._boxes import Boxes, in_room
from robolayout.verify._space import QUAD_SEGS
from robolayout.verify.drives import Pose
from robolayout.verify.heading import grown, rectangle

STEPS = 12  # steps of a leaf from shut to open
STRIDE = 0.10  # metres that a body may move while the leaf makes one of them
BERTHS = (0.04, 0.0)
"""Metres that it keeps from what it steps past, the first that leave it a way: strides are straight and would cut a corner by as much."""

Leaf = tuple[BaseGeometry, float, float]
"""A convex shape in plan, and between which heights in metres it lies."""

Stands = Iterable[tuple[float, BaseGeometry, tuple[str, ...]]]
"""Headings in radians, where the centre of a body gets to before a thing at each, and what is moved away for that."""


def find_hold(found: Boxes, agent: Agent, row: int, joint: Joint, reach: float, stands: Stands) -> Hold:
    """Return how a body opens something."""
    asset, place = found.where(row)
    far = np.linspace(0.0, joint.span[1], STEPS + 1).tolist()
    hands = [shapely.Point(turned(joint, np.array([joint.handle]), step)[0, :2]) for step in far]
    rings = [in_room(hand, place).buffer(reach, quad_segs=QUAD_SEGS) for hand in hands]
    swept = [_swept(found, row, joint, ends) for ends in pairwise(far)]
    aside = _aside(found, row, [leaf for step in swept for leaf in step])
    walk = Hold(asset.name, joint.name, ())
    for heading, region, chairs in stands:
        met = [_met(step, agent, heading) for step in swept]
        free = [
            (region & ring).difference(shapely.union_all(met[max(k - 1, 0) : k + 1])) for k, ring in enumerate(rings)
        ]
        still: Any = shapely.intersection_all(free)
        moved = tuple(dict.fromkeys(chairs + aside))
        if still.area > 0:
            x, y = shapely.get_coordinates(shapely.maximum_inscribed_circle(still))[0].tolist()
            return Hold(asset.name, joint.name, ((x, y, heading),), moved)
        for berth in () if walk.poses else BERTHS:
            if poses := _walk([places.buffer(-berth) for places in free], heading):
                walk = Hold(asset.name, joint.name, poses, moved)
                break
    return walk


def _swept(found: Boxes, row: int, joint: Joint, ends: tuple[float, float]) -> list[Leaf]:
    """Return what the parts of a leaf sweep between two steps."""
    asset, place = found.where(row)
    both = [
        np.concatenate([turned(joint, part.vertices, end) for end in ends])
        for part in parts(asset)
        if part.joint == joint
    ]
    return [
        (
            in_room(shapely.MultiPoint(points[:, :2]).convex_hull, place),
            place[2] + float(points[:, 2].min()),
            place[2] + float(points[:, 2].max()),
        )
        for points in both
    ]


def _aside(found: Boxes, row: int, leaves: Sequence[Leaf]) -> tuple[str, ...]:
    """Return what people move that stands where a leaf comes."""
    rows = np.flatnonzero(found.movable & found.placed & ~found.flat)
    met = [
        other
        for other in rows.tolist()
        if other != row
        and any(
            low < found.top[other] and high > found.bottom[other] and shape.intersects(found.footprints[other])
            for shape, low, high in leaves
        )
    ]
    return tuple(found.names[other] for other in met)


def _met(leaves: Sequence[Leaf], agent: Agent, heading: float) -> BaseGeometry:
    """Return where the centre of a body is while it meets what is swept at its heights."""
    shapes = [shape for shape, low, high in leaves if low < agent.height and high > agent.step]
    if agent.length is None or agent.width is None:
        return shapely.union_all([shape.buffer(agent.radius, quad_segs=QUAD_SEGS) for shape in shapes])
    body = rectangle(agent, heading)
    return shapely.union_all([grown(shapely.get_coordinates(shape)[None], body)[0] for shape in shapes])


def _walk(free: Sequence[BaseGeometry], heading: float) -> tuple[Pose, ...]:
    """Return a place in each of these regions, each within a stride of the one before; none where there is no such way."""
    ways = [free[-1]]
    for region in reversed(free[:-1]):
        ways.append(region.intersection(ways[-1].buffer(STRIDE)))
    if ways[-1].is_empty:
        return ()
    at = ways.pop().representative_point()
    poses = [(at.x, at.y, heading)]
    while ways:
        x, y = shapely.get_coordinates(shapely.shortest_line(ways.pop(), shapely.Point(poses[-1][:2])))[0].tolist()
        poses.append((x, y, heading))
    return tuple(poses)
