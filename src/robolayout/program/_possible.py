"""What can be true in a room at all, whatever the layout: heights, free wall, nearest and farthest distances.

The filter may only mend what is impossible, never fit a statement to a guess; so everything here follows from the room,
the sizes and who stands on whom. A box of half-sides (p, q) holds the disc of radius r = min(p, q) at any heading. Two
boxes at one height are therefore at least r1 + r2 apart, and, as both discs lie in a room of diameter D, at most
D - r1 - r2.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

from shapely import Point, Polygon

from robolayout.assets import resting_place
from robolayout.constraints import TOLERANCE, AssetRef, Ref, WallRef
from robolayout.constraints.mounted_on import EYE_HEIGHT
from robolayout.scene import OPENINGS, Asset, Room, Scene, Wall

Span = tuple[float, float]


def hangs(asset: Asset) -> bool:
    """Return whether an asset can only hang from the ceiling."""
    return asset.on_ceiling and not (asset.on_floor or asset.on_object or asset.on_wall)


def is_fixed_to_wall(asset: Asset) -> bool:
    """Return whether an asset can only hang at a wall."""
    return asset.on_wall and not (asset.on_floor or asset.on_object or asset.on_ceiling)


def height_span(scene: Scene, name: str, parents: Mapping[str, str], mounted: Mapping[str, float]) -> Span:
    """Return the heights of bottom and top in metres: on floor or carriers, at the wall (its middle as `mounted`) or the ceiling."""
    asset, ceiling = scene.by_name[name], scene.room.wall_height
    height = asset.size[2]
    if name in parents:
        bottom = height_span(scene, parents[name], parents, mounted)[0]
        bottom += resting_place(scene.by_name[parents[name]], asset).height
    elif asset.on_ceiling and not asset.on_floor:
        bottom = ceiling - height
    elif asset.on_wall and not asset.on_floor:
        bottom = min(max(mounted.get(name, EYE_HEIGHT) - height / 2, 0.0), ceiling - height)
    else:
        bottom = 0.0
    return (bottom, bottom + height)


def share_height(first: Span, second: Span) -> bool:
    """Return whether two things are somewhere at the same height."""
    return min(first[1], second[1]) - max(first[0], second[0]) > TOLERANCE.height


def inner_radius(asset: Asset) -> float:
    """Return the radius in metres of the largest disc in its footprint."""
    return min(asset.size[:2]) / 2


def free_intervals(room: Room, wall: Wall, span: Span) -> list[Span]:
    """Return the parts of a wall, in metres from its start, where something of that height does not stand in a door."""
    doors = sorted((d.offset, d.offset + d.width) for d in room.doors if d.wall == wall.index)
    free: list[Span] = []
    start = 0.0
    for near, far in doors if span[0] < OPENINGS.landing_height else ():
        free.append((start, near))
        start = max(start, far)
    free.append((start, wall.length))
    return [(near, far) for near, far in free if far > near]


def longest(intervals: Iterable[Span]) -> float:
    """Return the length in metres of the longest interval."""
    return max((far - near for near, far in intervals), default=0.0)


def distance_range(scene: Scene, asset: Asset, other: Ref, *, collide: bool) -> Span:
    """Return the smallest and the largest distance in metres that an asset can have from something in this room.

    Args:
        other: An asset (centre to centre), a wall (centre to segment) or a point.
        collide: Whether the two cannot be in the same place in plan.
    """
    corners = scene.room.vertices
    radius = inner_radius(asset)
    if isinstance(other, AssetRef):
        farthest = max(math.dist(p, q) for p in corners for q in corners)
        both = radius + inner_radius(scene.by_name[other.name])
        return (both if collide else 0.0, max(farthest - both, 0.0))
    if isinstance(other, WallRef):
        wall = scene.room.walls[other.index]
        return (radius, max(max(map(wall.distance, corners)) - radius, 0.0))
    outside = Polygon(corners).distance(Point(other.x, other.y))
    farthest = max(math.dist(corner, (other.x, other.y)) for corner in corners)
    return (outside + radius if outside > 0 else 0.0, max(farthest - radius, 0.0))
