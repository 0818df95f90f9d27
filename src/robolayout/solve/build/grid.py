"""Equal things in rows and columns: shelves with aisles, pupils before a board, tables of a cafe."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout.constraints.in_rows import InRows
from robolayout.constraints.in_shape import SHAPES, InShape
from robolayout.solve.build.cluster import Cluster
from robolayout.solve.build.member import GridPlan, Member, Rect, box_of
from robolayout.solve.build.places import WALL_GAP, Places, room_yaws, targets
from robolayout.solve.build.site import Site

BACKS = 0.03
"""Metres between rows that stand back to back."""

ENTERED = 0.35
WIDER = 0.15
"""Metres between seats of a circle that one squeezes through, and by which what turns to its middle leaves more than a corridor."""

AISLES = ((1.0, 1.0), (1.0, 0.1), (1.35, 1.0), (1.35, 0.1), (1.8, 1.8))
"""By how much aisles are wider than they must be, and gaps wider or closer than is told, in the arrangements that are tried."""

AT_BACK = 0.15
"""Metres between a wall and the back of what stands at it, at most: a chair beside a bed may stand a little behind its head."""

LYING = 0.3
"""Metres between rows of mats where there is no room for a way between them."""

TIGHTEST = 0.5
"""Metres between things in a row up to which these may stand closer where there is no room for it."""


def grid_batches(site: Site, clusters: Sequence[Cluster]) -> Iterator[tuple[GridPlan, Places]]:
    """Yield every arrangement of equal clusters in a grid, with the places for its middle."""
    want = site.wants[clusters[0].anchor]
    if want.shape is not None:
        yield from _shaped(site, clusters, want.shape)
        return
    rows = want.rows
    if rows is None:
        return
    extent = _extent(site, clusters[0])
    size = site.size(clusters[0].anchor)
    between = (extent[2] - extent[0] - size[0], extent[3] - extent[1] - size[1])
    aisle0, gap0 = max(rows.aisle, site.corridor), rows.gap
    names = tuple(cluster.anchor for cluster in clusters)
    backs = "alike" if site.backed(clusters[0]) else rows.backs  # of desks that face each other no backs are left
    wide = math.ceil(max(len(rows.items), len(names)) / (rows.rows or 1))  # of fewer there are fewer rows
    for columns in range(1, len(names) + 1):
        count = math.ceil(len(names) / columns)
        if columns * (count - 1) >= len(names) or (rows.rows and columns != wide):
            continue
        both = 1 if backs == "alike" else 2  # chairs of both rows stand in the aisle
        aisles = [(between[0] * both + aisle0 * wider, closer) for wider, closer in AISLES]
        aisles += [(max(rows.aisle, LYING), 0.1)] if want.asset.is_flat else []  # one steps over mats
        walled = (
            [*_walled(site, size[0] / 2 - extent[0], aisles[0][0])]
            if backs == "facing" and count == 2 and rows.widest is None
            else []
        )
        for aisle, closer in (*walled, *aisles):
            if closer < 1.0 and gap0 > max(TIGHTEST, between[1]):
                continue
            gap = round(between[1] + gap0 * (closer if gap0 > 0.3 else 1.0), 2)
            central = max(rows.central, site.corridor) if rows.central else 0.0
            plan = GridPlan(names, count, columns, round(aisle, 2), gap, backs, closer < 1.0, central)
            cluster = _cluster(clusters, plan, size)
            poses = _poses(site, cluster, _yaws(site, cluster))
            if len(poses):
                yield plan, Places("grid", cluster, poses, np.full(len(poses), -1))


def _walled(site: Site, deep: float, least: float) -> Iterator[tuple[float, float]]:
    """Yield how wide the aisle is between two rows, each so deep, with their backs to opposite walls, and by how much gaps are closer."""
    left, bottom, right, top = site.room.bounds
    aisles = (side - 2 * (deep + WALL_GAP) for side in (right - left, top - bottom))
    yield from ((aisle, closer) for aisle in aisles if aisle >= least for closer in (1.0, 0.1))


def off_walls(site: Site, plan: GridPlan, batch: Places) -> NDArray[np.bool_]:
    """Return (n,) whether rows that face each other have not both their backs at walls, where such things usually do."""
    rows = site.wants[plan.names[0]].rows
    told = rows is not None and rows.widest is not None
    if plan.backs != "facing" or told or next(iter(site.wants[plan.names[0]].stands), "") != "wall":
        return np.zeros(len(batch.poses), np.bool_)
    size, walls = site.size(plan.names[0]), shapely.LinearRing(site.room.vertices)
    there = np.array([Member("", *cell_poses(plan, size)[k]).everywhere(batch.poses) for k in (0, -1)])
    backs = there[..., :2] - size[0] / 2 * np.stack([np.cos(there[..., 2]), np.sin(there[..., 2])], axis=-1)
    away = np.asarray(shapely.distance(shapely.points(backs), walls))
    return np.any(away > AT_BACK, axis=0)


def _shaped(site: Site, clusters: Sequence[Cluster], shape: InShape) -> Iterator[tuple[GridPlan, Places]]:
    """Yield a circle, half circle or U of all of its things, open to each side of the room."""
    names = tuple(cluster.anchor for cluster in clusters)
    wide = {"circle": (site.corridor + WIDER, ENTERED), "half circle": (ENTERED,)}.get(shape.shape, ())
    if {*names} != {*shape.asset_names()}:
        return
    wide = wide if site.covers.keys().isdisjoint(names) else ()  # all of them are on their rug
    yaws = [yaw + shape.slots(site.scene)[names[0]].yaw for yaw in room_yaws(site)]
    for gap in (*wide, *SHAPES.gap[:1]):
        plan = shaped_plan(site, names, shape, gap)
        tight = replace(plan, tight=bool(wide) and gap == SHAPES.gap[0])
        cluster = _cluster(clusters, plan, site.size(names[0]))
        poses = _poses(site, cluster, yaws)
        if len(poses):
            yield tight, Places("grid", cluster, poses, np.full(len(poses), -1))


def shaped_plan(site: Site, names: tuple[str, ...], shape: InShape, gap: float) -> GridPlan:
    """Return how all of a circle, half circle or U stand, seen from the first of some names, so many metres apart."""
    there = shape.slots(site.scene, gap)
    first = there[names[0]]
    cells = tuple((*first.seen(there[name].at), there[name].yaw - first.yaw) for name in names)
    return GridPlan(names, 1, len(names), 0.0, 0.0, cells=cells)


def in_one_row(site: Site, clusters: Sequence[Cluster]) -> Cluster | None:
    """Return the clusters of a row that is told as one, None where more rows are told or one of it belongs elsewhere."""
    rows = site.wants[clusters[0].anchor].rows
    shaped = site.wants[clusters[0].anchor].shape is not None
    if shaped or rows is None or rows.rows != 1 or any(site.wants[one.name].anchor is not None for one in rows.items):
        return None
    return side_by_side(site, clusters, rows)


def side_by_side(site: Site, clusters: Sequence[Cluster], rows: InRows | None = None) -> Cluster:
    """Return clusters in a row as one: as far apart as is told, or with a way between them."""
    extent, size = _extent(site, clusters[0]), site.size(clusters[0].anchor)
    between = extent[3] - extent[1] - size[1]
    gap = round(max(between, site.corridor) if rows is None else between + rows.gap, 2)
    backs, central = ("alike", 0.0) if rows is None else (rows.backs, rows.central)
    names = tuple(one.anchor for one in clusters)
    return _cluster(clusters, GridPlan(names, 1, len(names), 0.0, gap, backs, False, central), size)


def _extent(site: Site, cluster: Cluster) -> Rect:
    boxes = [box_of(m, site.size(m.name)) for m in cluster.members if site.on_floor(m)]
    x0, y0, x1, y1 = zip(*boxes, strict=True)
    return (min(x0), min(y0), max(x1), max(y1))


def _cluster(clusters: Sequence[Cluster], plan: GridPlan, size: tuple[float, float, float]) -> Cluster:
    """Return all clusters as one, in the frame of the first: rows go backwards, columns to the right."""
    members = [
        member.moved(x, y, yaw)
        for cluster, (x, y, yaw) in zip(clusters, cell_poses(plan, size), strict=True)
        for member in cluster.members
    ]
    return Cluster(plan.names[0], tuple(members))


def cell_poses(plan: GridPlan, size: tuple[float, float, float]) -> list[tuple[float, float, float]]:
    """Return the place of each anchor in the frame of the first: rows behind it, or before it where they face each other."""
    if plan.cells:
        return [*plan.cells]
    found: list[tuple[float, float, float]] = []
    x, ahead = 0.0, 1.0 if plan.backs == "facing" else -1.0
    for row in range(plan.rows):
        turned = plan.backs != "alike" and row % 2 == 1
        if row:
            close = plan.backs != "alike" and turned is (plan.backs == "paired")
            x += ahead * (size[0] + (BACKS if close else plan.aisle))
        for column in range(plan.columns):
            if len(found) < len(plan.names):
                beyond = max(0.0, plan.central - plan.gap) * (2 * column >= plan.columns)
                found.append((x, -column * (size[1] + plan.gap) - beyond, math.pi if turned else 0.0))
    return found


def last_cell(site: Site, plan: GridPlan, batch: Places) -> Places:
    """Return the places of the last anchor of a grid in place of those of its first."""
    x, y, _ = cell_poses(plan, site.size(plan.names[0]))[-1]
    return replace(batch, poses=Member("", x, y).everywhere(batch.poses))


def put_grid(site: Site, clusters: Sequence[Cluster], plan: GridPlan, frame: NDArray[np.float64]) -> None:
    """Put equal clusters into the cells of a grid whose first cell is at `frame`."""
    x, y, yaw = frame.tolist()
    for cluster, cell in zip(clusters, cell_poses(plan, site.size(plan.names[0])), strict=True):
        pose = Member("", *cell).moved(x, y, yaw)
        site.put(cluster, np.array([pose.x, pose.y, pose.yaw]), "grid")


def _poses(site: Site, cluster: Cluster, yaws: Sequence[float]) -> NDArray[np.float64]:
    """Return places (n, 3) of the first anchor such that the whole block lies within the room's bounds."""
    left, bottom, right, top = site.room.bounds
    found, looks = list[tuple[float, float, float]](), _looks(site, cluster)
    for yaw in yaws:
        turned = replace(cluster, members=tuple(member.moved(0.0, 0.0, yaw) for member in cluster.members))
        x0, y0, x1, y1 = _extent(site, turned)
        middle, before = ((x0 + x1) / 2, (y0 + y1) / 2), list[tuple[float, float]]()
        for mine, seen in looks:
            at = mine.moved(0.0, 0.0, yaw)
            before.append((seen.x - at.x + middle[0], seen.y - at.y + middle[1]))
        for x in _steps(left + (x1 - x0) / 2, right - (x1 - x0) / 2, site.corridor, [x for x, _ in before]):
            for y in _steps(bottom + (y1 - y0) / 2, top - (y1 - y0) / 2, site.corridor, [y for _, y in before]):
                found.append((x - middle[0], y - middle[1], yaw))
    return np.array(found).reshape(-1, 3)


def _steps(low: float, high: float, corridor: float, before: Sequence[float]) -> list[float]:
    """Return places between two ends, those that leave just a corridor between the block and either end, and some right before things."""
    if high < low:
        return []
    count = max(2, min(7, math.ceil((high - low) / 0.3) + 1))
    marks = [*np.linspace(low, high, count), low + corridor, high - corridor, *before]
    return sorted({round(float(v), 4) for v in marks if low <= v <= high})


def _looks(site: Site, cluster: Cluster) -> list[tuple[Member, Member]]:
    """Return the first of a block's things that has something to face, with that; none where there is none yet."""
    faced = ((member, targets(site, member.name)) for member in cluster.members if site.wants[member.name].face)
    return [(member, site.spots[there[0]].member) for member, there in faced if there][:1]


def _yaws(site: Site, cluster: Cluster) -> list[float]:
    """Return the headings to try: one if one of a block's things has something to face, else along and across the room."""
    for mine, seen in _looks(site, cluster):
        face = site.wants[mine.name].face
        return [seen.yaw + (0.0 if face and face.away else math.pi)]
    return room_yaws(site)
