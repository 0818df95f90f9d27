"""Rugs under or beside what they belong to, and mats of their own side by side on free floor."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import shapely

from robolayout.floor import rect_points
from robolayout.solve.build.form import corners_of
from robolayout.solve.build.grid import cell_poses, shaped_plan
from robolayout.solve.build.member import GridPlan, Member, Poses
from robolayout.solve.build.places import room_yaws
from robolayout.solve.build.site import Site, Spot

Pose = tuple[float, float, float]


@dataclass(frozen=True)
class Laying:
    """How rugs and mats lie."""

    under_bed: float = 0.25  # metres by which a rug beside a narrow bed lies under it
    foot: float = 0.3  # part of a thing's depth by which a rug lies before its middle, if it is to lie toward its front
    stood_at: float = 0.7  # metres of depth up to which a thing is stood at: its mat lies before it
    under_edge: float = 0.1  # metres by which that mat lies under it
    least_under: float = 0.01  # square metres of a rug that lie under its owner at the least
    between: float = 0.4  # metres between two mats
    landing: float = 0.8  # metres before a door in the middle of which its mat lies
    wanted: float = 0.3  # weight of floor that others are used from, against that of floor which is covered
    on_others: float = 20.0  # cost of a mat that lies wholly on another one, by the root of the share that does
    most_covered: float = 0.02  # share of a block of mats that may lie under things before they are laid one by one


LAYING = Laying()


def lay_rugs(site: Site, names: Sequence[str]) -> None:
    """Lay each rug where it belongs, moved and turned so that it fits the room, and mats of one size in a block."""
    free: dict[tuple[float, float, float], list[str]] = {}
    for name in names:
        owners = [n for n in site.wants[name].over if n in site.spots]
        if not owners:
            free.setdefault(site.size(name), []).append(name)
        else:
            pose = _at_owner(site, name, owners[0]) if len(owners) == 1 else _amid(site, name, owners)
            site.settle(name, Spot(_fitted(site, name, pose, owners[0]), "rug"))
    for equal in free.values():
        if len(equal) == 1 and site.room.doors and site.wants[equal[0]].weights.get("by_door", 0.0) > 0.0:
            site.settle(equal[0], Spot(_fitted(site, equal[0], _in_a_door(site)), "rug"))
        else:
            _lay_free(site, equal)


def _in_a_door(site: Site) -> Pose:
    """Return where a mat lies before the first door, along it."""
    door = site.room.doors[0]
    x, y = np.mean(site.room.landing(door, LAYING.landing), axis=0).tolist()
    ahead, aside = site.room.walls[door.wall].normal
    return x, y, math.atan2(aside, ahead)


def _at_owner(site: Site, name: str, owner: str) -> Pose:
    """Return where a rug belongs: under a thing, toward the side that is said, or beside it."""
    there, (depth, width, _), join = site.spots[owner].member, site.size(owner), site.wants[name].join
    if join is None or join.slot != "beside":
        before = depth / 2 + site.size(name)[0] / 2 - LAYING.under_edge
        ahead = 0.0 if join is None else before if depth <= LAYING.stood_at else LAYING.foot * depth
        return _pose(Member(name, ahead, 0.0, 0.0).moved(there.x, there.y, there.yaw))
    rug, short = site.size(name), min(site.size(name)[:2])
    aside = width / 2 + short / 2 - LAYING.under_bed
    turn = 0.0 if rug[1] == short else math.pi / 2
    sides = [Member(name, 0.0, y, turn).moved(there.x, there.y, there.yaw) for y in (aside, -aside)]
    covered = _covered(site, rug, np.array([_pose(side) for side in sides]))
    return _pose(sides[int(np.argmin(covered))])


def _amid(site: Site, name: str, owners: Sequence[str]) -> Pose:
    """Return where a rug lies in the middle of several things, turned so that most of them is on it."""
    feet = shapely.union_all([site.foot(owner) for owner in owners])
    x, y = np.mean([(site.spots[owner].member.x, site.spots[owner].member.y) for owner in owners], axis=0).tolist()
    ways = [Member(name, x, y, site.spots[owners[0]].member.yaw + turn) for turn in (0.0, math.pi / 2)]
    return _pose(max(ways, key=lambda way: shapely.area(shapely.intersection(site.outline(way), feet))))


def _pose(member: Member) -> Pose:
    return (member.x, member.y, member.yaw)


def _covered(site: Site, size: tuple[float, float, float], poses: Poses, wanted: float = 0.0) -> Poses:
    """Return the share (n,) of a flat thing that is under others, outside the room, in a landing, or `wanted` by others."""
    points = rect_points((-size[0] / 2, -size[1] / 2, size[0] / 2, size[1] / 2), 0.0, 0.15)
    maps, under = site.floor.maps(), site.floor.under(points, poses)
    return maps.barred[under].mean(axis=1) + wanted * maps.wanted[under].mean(axis=1)


def _lay_free(site: Site, names: Sequence[str]) -> None:
    """Lay equal mats in rows on free floor, near the middle; one by one where no such block is free."""
    count = len(names)
    asked = site.wants[names[0]].rows
    rows = [k for k in range(1, count + 1) if count % k == 0 and (asked is None or asked.rows in (None, k))] or [count]
    plans = [GridPlan(tuple(names), k, count // k, LAYING.between, LAYING.between) for k in rows]
    shape = site.wants[names[0]].shape
    if shape is not None and {*shape.asset_names()} == {*names}:
        plans = [shaped_plan(site, tuple(names), shape, LAYING.between)]
    (_, pose), plan = min(((_free_floor(site, plan), plan) for plan in plans), key=lambda entry: entry[0][0])
    cells = [Member(n, *c).moved(*pose) for n, c in zip(names, cell_poses(plan, site.size(names[0])), strict=True)]
    covered = _covered(site, site.size(names[0]), np.array([_pose(cell) for cell in cells]))
    if count > 1 and covered.max() > LAYING.most_covered:
        for name in names:
            _lay_free(site, [name])
        return
    for cell in cells:
        fitted = _fitted(site, cell.name, _pose(cell)) if count == 1 else cell
        site.settle(cell.name, Spot(fitted, "rug"))


def _free_floor(site: Site, plan: GridPlan) -> tuple[float, Pose]:
    """Return cost and place of the first mat for the best place of a block: free floor, off other mats, near the middle."""
    left, bottom, right, top = site.room.bounds
    xs, ys = np.arange(left, right, 0.2), np.arange(bottom, top, 0.2)
    size, middle = site.size(plan.names[0]), site.floor.middle
    cells = [Member(name, *cell) for name, cell in zip(plan.names, cell_poses(plan, size), strict=True)]
    centre = (np.mean([cell.x for cell in cells]), np.mean([cell.y for cell in cells]))
    cells = [replace(cell, x=cell.x - centre[0], y=cell.y - centre[1]) for cell in cells]
    poses = np.array([(x, y, yaw) for yaw in room_yaws(site)[: 4 if len(cells) > 1 else 2] for x in xs for y in ys])
    cost = 0.3 * np.hypot(poses[:, 0] - middle[0], poses[:, 1] - middle[1])
    others = [spot.member for spot in site.spots.values() if spot.mode == "rug"]
    for cell in cells:
        there = cell.everywhere(poses)
        cost += 6.0 * _covered(site, size, there, LAYING.wanted)
        for other in others:
            away = np.hypot(there[:, 0] - other.x, there[:, 1] - other.y) / ((size[0] + size[1]) / 2)
            cost += 4.0 * np.maximum(0.0, 1.0 - away) + LAYING.on_others * np.sqrt(
                _shared(there, size, other, site.size(other.name))
            )
    cost += site.missed(cells, poses)
    best = int(np.argmin(cost))
    first = cells[0].moved(*(float(value) for value in poses[best]))
    return float(cost[best]), _pose(first)


def _shared(poses: Poses, size: tuple[float, float, float], other: Member, its: tuple[float, float, float]) -> Poses:
    """Return the share (n,) of a mat that lies on another one, both along the room or across it."""
    dx, dy, turn = poses[:, 0] - other.x, poses[:, 1] - other.y, poses[:, 2] - other.yaw
    c, s = math.cos(other.yaw), math.sin(other.yaw)
    along, across = np.abs(np.cos(turn)), np.abs(np.sin(turn))
    deep = (along * size[0] + across * size[1] + its[0]) / 2 - np.abs(c * dx + s * dy)
    wide = (across * size[0] + along * size[1] + its[1]) / 2 - np.abs(c * dy - s * dx)
    return np.clip(deep, 0.0, None) * np.clip(wide, 0.0, None) / (size[0] * size[1])


def _fitted(site: Site, name: str, pose: Pose, owner: str | None = None) -> Member:
    """Return the place nearest to `pose`, turned by a right angle if need be, where a flat thing is inside the room.

    Where it lies under an owner it stays under it.
    """
    shifts = [0.1 * k for k in range(-8, 9)]
    options = sorted(
        (abs(dx) + abs(dy) + (0.3 if turn else 0.0), turn, dx, dy)
        for turn in (0.0, math.pi / 2)
        for dx in shifts
        for dy in shifts
    )
    poses = np.array([(pose[0] + dx, pose[1] + dy, pose[2] + turn) for _, turn, dx, dy in options])
    room = shapely.Polygon(site.room.vertices).buffer(0.005, join_style="mitre")
    outlines = shapely.polygons([corners_of(Member(name, *pose), site.size(name)) for pose in poses.tolist()])
    cost = np.round(shapely.area(shapely.difference(outlines, room)), 4)
    if owner is not None:
        shared = shapely.area(shapely.intersection(outlines, site.foot(owner)))
        cost += shapely.area(outlines) * (shared < LAYING.least_under)
    best = int(np.argmin(cost))
    x, y, yaw = poses[best].tolist()
    return Member(name, x, y, yaw)
