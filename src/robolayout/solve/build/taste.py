"""What makes one free place better than another: costs between 0 and about 6 per wish, smaller is better."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout.constraints.at_window import AtWindow
from robolayout.constraints.by_door import doorways
from robolayout.constraints.corner import Corner
from robolayout.scene import Room
from robolayout.solve.build.form import corners_of
from robolayout.solve.build.member import box_of
from robolayout.solve.build.places import Places, targets
from robolayout.solve.build.site import AT_WALL, NARROW, Site, Spot

Cost = NDArray[np.float64]

BLOCKED_WINDOW = 5.0
"""Cost of a tall thing that hides a whole window or a board."""

HIDDEN = 0.75
"""Cost of something in between a seat and its screen."""

OPPOSITE = 0.5
"""Cost of heading the other way than what it is wished to be straight to, as a share of that of being across to it."""

LOW = 0.65
"""Metres of height of what one looks over."""


def taste(site: Site, batch: Places, weights: Mapping[str, float]) -> Cost:
    """Return the cost (n,) of a batch of places for the wishes of its anchor."""
    name = batch.cluster.anchor
    cost = wished(site, name, batch.poses[:, :2], weights) + _facing(site, name, batch.poses)
    for other, weight in site.wants[name].straight:
        if other in site.spots:
            turn = batch.poses[:, 2] - site.spots[other].member.yaw
            cost += weight * (np.abs(np.sin(turn)) + OPPOSITE * (1.0 - np.cos(turn)) / 2.0)
    for point, weight in site.wants[name].points:
        dx, dy, turn = point.x - batch.poses[:, 0], point.y - batch.poses[:, 1], batch.poses[:, 2]
        away = np.maximum(np.hypot(dx, dy), 1e-6)
        cost += weight * (1.0 - (dx * np.cos(turn) + dy * np.sin(turn)) / away)
    return cost + _along_walls(site, batch, weights) if batch.mode in ("wall", "corner") else cost


def wished(site: Site, name: str, xy: NDArray[np.float64], weights: Mapping[str, float]) -> Cost:
    """Return the cost (n,) of places (n, 2) of a thing by how near it wishes to be to doors, corners, windows, others and the middle."""
    cost, spread = np.zeros(len(xy)), math.sqrt(site.room.area)
    if weights.get("by_door") and site.room.doors:
        away = np.min([np.hypot(xy[:, 0] - d.x, xy[:, 1] - d.y) for d in doorways(site.scene)], axis=0) / spread
        weight = weights["by_door"]
        cost += -weight * np.maximum(0.0, 1.0 - away) if weight < 0 else weight * np.minimum(away, 1.5)
    if weights.get("middle"):
        x, y = site.floor.middle
        cost += weights["middle"] * np.hypot(xy[:, 0] - x, xy[:, 1] - y) / spread
    for one, weight in site.wants[name].numbered:
        for x, y in _where(site.room, one):
            cost += weight * np.hypot(xy[:, 0] - x, xy[:, 1] - y) / spread
    for names, weight in site.wants[name].near:
        cost += weight * _nearness(site, xy, names, far=weight < 0)
    return cost


def _where(room: Room, one: Corner | AtWindow) -> Iterator[tuple[float, float]]:
    """Yield the corner, or the middle of the window, of which a wish gives the number."""
    if isinstance(one, Corner) and one.vertex is not None:
        yield room.vertices[one.vertex]
    elif isinstance(one, AtWindow) and one.window is not None:
        window = room.windows[one.window]
        yield room.walls[window.wall].point(window.offset + window.width / 2)


def looks(site: Site) -> float:
    """Return how badly everything that is placed looks at what it should face, whichever was placed first."""
    standing = [(name, spot.member) for name, spot in site.spots.items() if spot.mode not in ("hang", "join")]
    return sum(float(_facing(site, name, np.array([[m.x, m.y, m.yaw]]))[0]) for name, m in standing)


def _along_walls(site: Site, batch: Places, weights: Mapping[str, float]) -> Cost:
    """Return the cost of where on its wall a thing stands and what it hides there, and what goes by it has behind it."""
    _, width, _ = site.size(batch.cluster.anchor)
    standing = [m for m in batch.cluster.members if not m.bottom]
    boxes = [(box_of(m, site.size(m.name)), m.name) for m in standing]
    beside = [(y0, y1, name) for (x0, y0, _, y1), name in boxes if x0 <= boxes[0][0][0] + AT_WALL and y1 - y0 > NARROW]
    shades = {m.name: max(0.0, -site.wants[m.name].weights.get("at_window", 0.0)) for m in standing[1:]}
    crown = max(member.bottom + site.size(member.name)[2] for member in batch.cluster.members)
    wished = site.wants[batch.cluster.anchor].walls
    elsewhere = max(wished.values(), default=0.0)
    cost = np.zeros(len(batch.poses))
    for wall in site.room.walls:
        rows = batch.walls == wall.index
        if not rows.any():
            continue
        along = (batch.poses[rows, :2] - np.asarray(wall.start)) @ np.asarray(wall.direction)
        half, span = width / 2, max(wall.length - width, 0.05)
        part = weights.get("mid_wall", 0.0) * np.abs(along - wall.length / 2) / (span / 2)
        part += weights.get("corner", 0.0) * np.minimum(along - half, wall.length - half - along) / (span / 2)
        part += elsewhere - wished.get(wall.index, 0.0)
        lit = np.zeros(len(along))
        hidden = np.zeros(len(along))
        for (start, low, end, high), kind in site.wall_takers(wall):
            cover = np.clip(np.minimum(along + half, end) - np.maximum(along - half, start), 0.0, None)
            if kind == "window":
                lit = np.maximum(lit, cover / width)
                for right, left, name in beside:  # a wall goes to the right of what has its back to it
                    before = np.maximum(np.minimum(along - right, end) - np.maximum(along - left, start), 0.0)
                    tall = min(1.0, max(0.0, site.size(name)[2] - low) / (0.6 * max(high - low, 0.1)))
                    hidden += tall * before / (end - start)
                    part += shades.get(name, 0.0) * np.minimum(before / (left - right) * 1.5, 1.0)
            elif kind != "door" and 0.1 < low < crown:
                hidden += cover / (end - start)
        window = weights.get("at_window", 0.0)
        part += window * (1 - np.minimum(lit * 1.5, 1.0)) if window > 0 else -window * np.minimum(lit * 1.5, 1.0)
        cost[rows] = part + BLOCKED_WINDOW * np.minimum(hidden, 1.0)
    return cost + weights.get("snug", 0.0) * _loose_ends(site, batch, width)


def _loose_ends(site: Site, batch: Places, width: float) -> Cost:
    """Return how many of the two sides of a thing at a wall have an open gap beside them (0 to 1)."""
    taken = site.floor.maps().taken
    sides = [np.array([(0.0, y)]) for y in (width / 2 + 0.12, -width / 2 - 0.12)]
    return 1.0 - np.mean([taken[site.floor.under(side, batch.poses)][:, 0] for side in sides], axis=0)


def _nearness(site: Site, xy: NDArray[np.float64], names: Sequence[str], *, far: bool = False) -> Cost:
    """Return the distance to the nearest of some things as a share of the room, or how much it lacks to be `far`, below 0."""
    there = [site.spots[name].member for name in names if name in site.spots]
    if not there:
        return np.zeros(len(xy))
    away = np.min([np.hypot(xy[:, 0] - m.x, xy[:, 1] - m.y) for m in there], axis=0) / math.sqrt(site.room.area)
    return -np.maximum(0.0, 1.0 - away) if far else away


def _facing(site: Site, anchor: str, poses: NDArray[np.float64]) -> Cost:
    """Return how badly a thing, and the screen that stands on it, looks at (or away from) what it should face."""
    carried = [item.name for item in site.wants.values() if item.anchor == anchor]
    return sum((_looking(site, name, anchor, poses) for name in (anchor, *carried)), np.zeros(len(poses)))


def _looking(site: Site, name: str, anchor: str, poses: NDArray[np.float64]) -> Cost:
    """Return how badly a thing would face what its role faces, if its anchor were at these places."""
    face = site.wants[name].face
    names = targets(site, name)
    if face is None or not names:
        return np.zeros(len(poses))
    costs: list[Cost] = []
    low, high = face.distance
    for other in names:
        target = site.spots[other].member
        dx, dy = target.x - poses[:, 0], target.y - poses[:, 1]
        away = np.hypot(dx, dy)
        turn = poses[:, 2] + (math.pi if face.away else 0.0)
        ahead = (dx * np.cos(turn) + dy * np.sin(turn)) / np.maximum(away, 1e-6)
        seen = -(dx * math.cos(target.yaw) + dy * math.sin(target.yaw)) / np.maximum(away, 1e-6)
        outside = np.maximum(low - away, 0.0) + np.maximum(away - high, 0.0)
        cost = 1.5 * (1 - ahead) + 1.5 * (1 - seen) + 2.0 * np.minimum(outside, 2.0)
        if not face.away:
            cost += HIDDEN * _hidden(site, {anchor, name}, site.spots[other], poses)
        costs.append(cost)
    return face.weight * np.min(costs, axis=0)


def keep_sight(site: Site, name: str) -> None:
    """Ask that nothing is put between a seat that was placed and the screen that it looks at."""
    face, there = site.wants[name].face, targets(site, name)
    if site.trial or face is None or face.away or not there:
        return
    here, target = site.spots[name].member, site.spots[there[0]].member
    away = math.hypot(target.x - here.x, target.y - here.y)
    line = np.linspace((here.x, here.y), (target.x, target.y), 2 + int(away / 0.15))
    site.floor.want(np.concatenate([line, line + np.array((0.2, 0.0)), line + np.array((0.0, 0.2))]), 1.0)


def _hidden(site: Site, own: Collection[str], target: Spot, poses: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return whether something higher than a low table stands between places and what they look at."""
    member = target.member
    between = [
        corners_of(spot.member, site.size(name))
        for name, spot in site.spots.items()
        if name not in own and name != member.name and site.on_floor(spot.member) and site.size(name)[2] >= LOW
    ]
    if not between:
        return np.zeros(len(poses), np.bool_)
    ends = np.stack([np.broadcast_to((member.x, member.y), (len(poses), 2)), poses[:, :2]], axis=1)
    return np.asarray(shapely.intersects(shapely.linestrings(ends), shapely.union_all(shapely.polygons(between))))
