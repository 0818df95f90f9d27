"""Doors and drawers of what stands in a room: where they sweep, and from where a body takes hold of them."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from robolayout.assets import Joint, sweeps_of
from robolayout.scene import ROUNDING, Agent, Asset, Point
from robolayout.scene.agent import horizontal_reach
from robolayout.verify._boxes import Boxes, in_room
from robolayout.verify._sides import within
from robolayout.verify.limits import FINE


def swept(found: Boxes, rows: Iterable[int]) -> tuple[NDArray[np.intp], NDArray[np.object_], NDArray[np.float64]]:
    """Return what placed assets sweep beyond their fronts: their rows (m,), the zones (m,) in the room, and heights (m, 2) in metres."""
    items = [(row, sweep) for row in dict.fromkeys(rows) for sweep in sweeps_of(found.assets[row])]
    zones = np.empty(len(items), dtype=object)
    zones[:] = [in_room(sweep.region, found.where(row)[1]) for row, sweep in items]
    levels = np.array([found.poses[row, 2] + np.array(sweep.heights) for row, sweep in items]).reshape(-1, 2)
    return np.array([row for row, _ in items], dtype=np.intp), zones, levels


def by_hand(found: Boxes, agent: Agent, row: int) -> list[tuple[Joint, float]]:
    """Return what of an asset a body opens by a handle at a height that it reaches, and how far it reaches there in metres."""
    far = [(joint, _reach(found, agent, row, joint)) for joint in opens(found, agent, row)]
    return [(joint, reach) for joint, reach in far if reach is not None]


def opens(found: Boxes, agent: Agent, row: int) -> list[Joint]:
    """Return what of an asset a body with an arm opens by a handle; nothing where the record only asks for room.

    Nothing either where all handles are too low or too high for it and its top is not: it uses that.
    """
    if agent.reach_distance is None:
        return []
    joints = [sweep.joint for sweep in sweeps_of(found.assets[row]) if sweep.joint is not None]
    top = float(found.top[row])
    by_hand = any(_reach(found, agent, row, joint) is not None for joint in joints)
    return joints if by_hand or horizontal_reach(agent, top, top) is None else []


def handle_near(found: Boxes, agent: Agent, row: int, place: Point) -> str:
    """Return the name of the joint whose handle is nearest to a place; empty where nothing is opened."""
    far = {
        joint.name: in_room(shapely.Point(joint.handle[:2]), found.where(row)[1]).distance(shapely.Point(place))
        for joint, _ in by_hand(found, agent, row)
    }
    return min(far, key=lambda name: (far[name], name), default="")


def handle_heights(found: Boxes, agent: Agent, row: int) -> tuple[float, float]:
    """Return between which heights in metres the handles of an asset lie."""
    held = [joint.hold for joint in opens(found, agent, row)]
    z = float(found.poses[row, 2])
    return z + min(low for low, _ in held), z + max(high for _, high in held)


def handle_reach(found: Boxes, agent: Agent, row: int) -> float | None:
    """Return the horizontal reach in metres to the handle that is easiest to get to; None if all are too high or too low."""
    return max((reach for _, reach in by_hand(found, agent, row)), default=None)


def _reach(found: Boxes, agent: Agent, row: int, joint: Joint) -> float | None:
    low, high = joint.hold
    return horizontal_reach(agent, float(found.poses[row, 2]) + low, float(found.poses[row, 2]) + high)


def opening_zone(found: Boxes, agent: Agent, row: int) -> BaseGeometry:
    """Return from where a body opens an asset: one of its handles within reach, and room for the body's disc beside the open leaf."""
    asset = found.assets[row]
    far = tuple(_reach(found, agent, row, sweep.joint) if sweep.joint else None for sweep in sweeps_of(asset))
    return in_room(_before(asset, agent.radius, far), found.where(row)[1])


@lru_cache(maxsize=4096)
def _before(asset: Asset, radius: float, far: tuple[float | None, ...]) -> BaseGeometry:
    """Return the same in the asset's frame, for the reach to each of its handles."""
    x, y = asset.size[0] / 2, asset.size[1] / 2
    most = max(reach for reach in far if reach is not None) + ROUNDING
    beyond = within(np.array([[(x, -y), (x, y)]]), np.array([most]))[0]
    zones: list[BaseGeometry] = []
    for sweep, reach in zip(sweeps_of(asset), far, strict=True):
        if sweep.joint is not None and reach is not None:
            handle = shapely.Point(sweep.joint.handle[:2]).buffer(reach + ROUNDING, quad_segs=FINE.quad_segs)
            leaf = sweep.leaf.buffer(radius, quad_segs=FINE.quad_segs)
            zones.append(beyond.intersection(handle).difference(leaf))
    return shapely.union_all(zones)
