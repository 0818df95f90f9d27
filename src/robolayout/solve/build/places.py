"""Places where a cluster could stand: along walls, in corners, on the open floor, before what it faces, on a wall, overhead."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from robolayout.constraints.corner import convex_corners
from robolayout.scene import Pose, Wall
from robolayout.solve.build.cluster import Cluster
from robolayout.solve.build.member import Member, Poses
from robolayout.solve.build.site import AT_WALL, Site

WALL_STEP = 0.1
"""Metres between places tried along a wall."""

WALL_STEPS = 300
"""Most such places of one wall: from 30 m on they lie further apart."""

WALL_GAP = 0.01
"""Metres left between a back and its wall."""

ALONG = 0.1
"""Metres of a side along which a thing beside it stands at least."""

DOOR_MARGIN = 0.05
"""Metres left beside a door."""


@dataclass(frozen=True)
class Places:
    """Places of one kind for one cluster."""

    mode: str  # how the anchor stands there
    cluster: Cluster  # the cluster, perhaps mirrored
    poses: Poses  # (n, 3) metres and radians, of the anchor
    walls: NDArray[np.int64]  # index of the wall of each place, or -1


def batches(site: Site, cluster: Cluster, modes: Iterable[str]) -> list[Places]:
    """Return all places for a floor cluster, for it and its mirror image if nothing says which side is which."""
    found: list[Places] = []
    joins = [site.wants[member.name].join for member in cluster.members[1:]]
    sided = any(join and (join.side or join.slot == "under") for join in joins)  # drawers of desks are at one side
    lopsided = any(abs(m.y) > 0.02 for m in cluster.members) and not sided
    for variant in (cluster, cluster.mirrored()) if lopsided else (cluster,):
        for mode in modes:
            poses, walls = _PLACES[mode](site, variant)
            if len(poses):
                found.append(Places(mode, variant, np.array(poses), np.broadcast_to(walls, len(poses))))
    return found


def close(batch: Places, row: int, other: Places, at: int, limit: float) -> bool:
    """Whether two places are less than so many metres apart and face the same way."""
    step = np.abs(batch.poses[row] - other.poses[at])
    return batch.cluster == other.cluster and bool(step[:2].max() < limit and step[2] < 0.1)


Found = tuple[Sequence[tuple[float, float, float]] | Poses, Sequence[int] | int]
"""Places, and the index of the wall of each; -1 where they are at none."""


def wall_yaw(wall: Wall) -> float:
    """Return the heading of a thing whose back is at the wall, radians."""
    return math.atan2(wall.normal[1], wall.normal[0])


def _offsets(site: Site, wall: Wall, width: float) -> list[float]:
    """Return places along a wall for a thing of that width: both ends, the middle, beside what stands there, and steps."""
    low, high = width / 2 + WALL_GAP, wall.length - width / 2 - WALL_GAP
    if high < low:
        return []
    marks = [low, high, wall.length / 2]
    for span in site.spans:
        if span.wall == wall.index and span.depth <= AT_WALL and span.rect[1] < 0.01:
            marks += [span.rect[0] - width / 2 - 0.02, span.rect[2] + width / 2 + 0.02]
    for opening in (*site.room.doors, *site.room.windows):
        if opening.wall == wall.index:
            ends = (opening.offset - DOOR_MARGIN, opening.offset + opening.width + DOOR_MARGIN)
            marks += [ends[0] - width / 2, ends[1] + width / 2, opening.center]
    marks += list(np.arange(low, high, max(WALL_STEP, wall.length / WALL_STEPS)))
    return sorted({round(float(t), 3) for t in marks if low - 1e-6 <= t <= high + 1e-6})


def _at_walls(site: Site, cluster: Cluster) -> Found:
    depth, width, _ = site.size(cluster.anchor)
    back = max(depth / 2, *(-site.behind(member) for member in cluster.members))
    poses, walls = list[tuple[float, float, float]](), list[int]()
    for wall in site.room.walls:
        yaw, offsets = wall_yaw(wall), _offsets(site, wall, width)
        poses += [(*wall.point(t, back + WALL_GAP), yaw) for t in offsets]
        walls += [wall.index] * len(offsets)
    return poses, walls


def walled(site: Site, cluster: Cluster) -> list[Member]:
    """Return what goes by an anchor, turned, and is demanded to be at a wall: a bookcase behind the chair of a desk."""
    turned = ((member, site.wants[member.name].stands.keys()) for member in cluster.members if abs(member.yaw) > 0.1)
    return [member for member, stands in turned if stands and stands <= {"wall", "corner"}]


def _by_its_followers(site: Site, cluster: Cluster) -> Found:
    """Return places in which what goes by the anchor has its back at a wall."""
    poses = list[tuple[float, float, float]]()
    for member in walled(site, cluster):
        there, _ = _at_walls(site, Cluster(member.name, (Member(member.name),)))
        x, y = Pose(member.x, member.y, 0.0, member.yaw).seen((0.0, 0.0))
        own = Member(cluster.anchor, x, y, -member.yaw)
        poses += [(at.x, at.y, at.yaw) for at in (own.moved(*back) for back in there)]
    return poses, -1


def _in_corners(site: Site, cluster: Cluster) -> Found:
    depth, width, _ = site.size(cluster.anchor)
    poses, walls = list[tuple[float, float, float]](), list[int]()
    corners, count = set(convex_corners(site.room)), len(site.room.walls)
    for wall in site.room.walls:
        for t, vertex in ((width / 2 + 0.04, wall.index), (wall.length - width / 2 - 0.04, (wall.index + 1) % count)):
            if width < wall.length and vertex in corners:
                poses.append((*wall.point(t, depth / 2 + 0.04), wall_yaw(wall)))
                walls.append(wall.index)
    return poses, walls


def room_yaws(site: Site) -> list[float]:
    """Return the four headings along and across the longest wall."""
    longest = max(site.room.walls, key=lambda wall: (wall.length, -wall.index))
    base = wall_yaw(longest)
    return [base + k * math.pi / 2 for k in range(4)]


def _in_the_middle(site: Site, cluster: Cluster) -> Found:
    left, bottom, right, top = site.room.bounds
    step = max(0.15, math.sqrt((right - left) * (top - bottom)) / 30)
    xs, ys = np.arange(left + 0.3, right - 0.29, step), np.arange(bottom + 0.3, top - 0.29, step)
    grid = np.stack(np.meshgrid(xs, ys, indexing="ij"), -1).reshape(-1, 2)
    grid = np.concatenate([grid, [site.floor.middle]])
    frames = np.column_stack([grid, np.zeros(len(grid))])
    blocked = site.floor.maps().barred[site.floor.under(np.zeros((1, 2)), frames)][:, 0] > 0
    free = grid[~blocked]
    poses = np.concatenate([np.column_stack([free, np.full(len(free), yaw)]) for yaw in room_yaws(site)])
    return poses, -1


def _before_what_it_faces(site: Site, cluster: Cluster) -> Found:
    face = site.wants[cluster.anchor].face
    poses: list[tuple[float, float, float]] = []
    for name in targets(site, cluster.anchor):
        target = site.spots[name].member
        if face is None:
            break
        turn = 0.0 if face.away else math.pi
        low, high = face.distance
        for distance in np.arange(low, min(high, 8.0) + 0.01, 0.1):
            x = target.x + float(distance) * math.cos(target.yaw)
            y = target.y + float(distance) * math.sin(target.yaw)
            poses.append((x, y, target.yaw + turn))
    return poses, -1


def _in_its_slot(site: Site, cluster: Cluster) -> Found:
    """Return the places at what a thing joins that are its own or another's of those that join it, and their mirror images."""
    anchor = site.wants[cluster.anchor].anchor or ""
    slots = [member for member in site.clusters.build(anchor).members[1:] if member.bottom == 0.0]
    return _at(site, anchor, [place for slot in slots for place in (slot, slot.mirrored())])


def _at_its_anchor(site: Site, cluster: Cluster) -> Found:
    """Return places all along the four sides of what a thing joins."""
    want = site.wants[cluster.anchor]
    anchor = want.anchor or ""
    hx, hy = (side / 2 for side in site.size(anchor)[:2])
    depth, width, _ = site.size(cluster.anchor)
    found: list[Member] = []
    for k, (out, half) in enumerate(((hx, hy), (hy, hx), (hx, hy), (hy, hx))):
        for turn in range(4):
            reach, wide = (depth, width) if (k + turn) % 2 == 0 else (width, depth)
            ends = half + wide / 2 - ALONG
            for aside in np.linspace(-ends, ends, 2 * math.ceil(ends / WALL_STEP / 2) + 1).tolist():
                away = out + want.joined.gap + reach / 2
                found.append(Member("", away, aside, turn * math.pi / 2).moved(0.0, 0.0, k * math.pi / 2))
    return _at(site, anchor, found)


def _at(site: Site, anchor: str, places: Iterable[Member]) -> Found:
    """Return places in the frame of a thing that has its own."""
    if anchor not in site.spots:
        return [], -1
    here = site.spots[anchor].member
    return [(m.x, m.y, m.yaw) for m in (place.moved(here.x, here.y, here.yaw) for place in places)], -1


def targets(site: Site, name: str) -> list[str]:
    """Return the placed assets that an asset should face."""
    face = site.wants[name].face
    return [other for other in face.names if other in site.spots] if face else []


_PLACES = {
    "wall": _at_walls,
    "led": _by_its_followers,
    "corner": _in_corners,
    "middle": _in_the_middle,
    "facing": _before_what_it_faces,
    "slot": _in_its_slot,
    "join": _at_its_anchor,
}
