"""What can be true in a room at all, whatever the layout: heights, distances, and which way statements turn things.

The filter may only mend what is impossible, never fit a statement to a guess; so everything here follows from the room,
the sizes and who stands on whom. A box of half-sides (p, q) holds the disc of radius r = min(p, q) at any heading. Two
boxes at one height are therefore at least r1 + r2 apart, and, as both discs lie in a room of diameter D, at most
D - r1 - r2.

A heading is known in the frame of the room where a wall gives it, or of the asset at the end of a chain of `align_with`. Where a
thing shall look at another, both need a first guess: what a statement asks is compared with that, never fitted to it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

from shapely import Point, Polygon

from robolayout.assets import resting_place
from robolayout.constraints import TOLERANCE, AssetRef, PointRef, Ref, Relation, WallRef
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.facing_pair import FacingPair
from robolayout.constraints.mounted_on import EYE_HEIGHT, MountedOn
from robolayout.constraints.point_towards import PointTowards
from robolayout.constraints.row import Row
from robolayout.scene import Asset, Scene

if TYPE_CHECKING:
    from robolayout.program._rules import Accepted

Span = tuple[float, float]
ROOM = ""  # stands for the frame of the room


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


class Heading(NamedTuple):
    """A yaw in radians in the frame of the room or of an asset."""

    frame: str
    yaw: float
    slack: float = 0.0  # by how much it may be off either way: a front that shall hit something has a choice


def heading_gap(known: Accepted, relation: Relation, name: str) -> float | None:
    """Return by how many degrees a relation would turn a thing away from its first heading; None if nobody can tell."""
    first = heading_of(known, name)
    if isinstance(relation, FacingPair):
        other = relation.b if relation.a.name == name else relation.a
        relation = PointTowards(AssetRef(name), other)
    wanted = _implied(known, relation, ())
    if wanted is None or wanted.frame != first.frame:
        return None
    off = abs(math.remainder(wanted.yaw - first.yaw, math.tau))
    return 0.0 if off <= wanted.slack + first.slack else math.degrees(off)


def heading_of(known: Accepted, name: str, above: tuple[str, ...] = ()) -> Heading:
    """Return how the first statement about it turns a thing: at least in its own frame."""
    earlier = known.headings.get(name) if name not in above else None
    found = _implied(known, earlier.relation, (*above, name)) if earlier else None
    return found or Heading(name, 0.0)


def _implied(known: Accepted, relation: Relation, above: tuple[str, ...]) -> Heading | None:
    """Return the heading that a relation asks for."""
    if isinstance(relation, AgainstWall | MountedOn | Row) and relation.wall is not None:
        return Heading(ROOM, _yaw(known.scene.room.walls[relation.wall.index].normal))
    if isinstance(relation, AlignWith) and relation.b is not None:
        if isinstance(relation.b, WallRef):
            base = Heading(ROOM, _yaw(known.scene.room.walls[relation.b.index].direction))
        else:
            base = heading_of(known, relation.b.name, above)
        return base._replace(yaw=base.yaw + math.radians(relation.angle))
    if isinstance(relation, PointTowards):
        here = _place(known, relation.a)
        seen = _seen(known, here, relation.b) if here else None
        return seen and seen._replace(yaw=seen.yaw + math.radians(relation.angle))
    return None


def _seen(known: Accepted, here: tuple[float, float], ref: Ref) -> Heading | None:
    """Return at which headings a front hits something from a place: a wall, or the disc that a thing covers whatever its heading."""
    if isinstance(ref, WallRef):
        wall = known.scene.room.walls[ref.index]
        first, second = (_yaw((x - here[0], y - here[1])) for x, y in (wall.start, wall.end))
        half = math.remainder(second - first, math.tau) / 2
        return Heading(ROOM, first + half, abs(half))
    there = _place(known, ref)
    if there is None or there == here:
        return None
    radius = inner_radius(known.scene.by_name[ref.name]) if isinstance(ref, AssetRef) else 0.0
    half = math.asin(min(radius / math.dist(here, there), 1.0))
    return Heading(ROOM, _yaw((there[0] - here[0], there[1] - here[1])), half)


def _place(known: Accepted, ref: AssetRef | PointRef) -> tuple[float, float] | None:
    """Return where something is: a point, a thing's first guess."""
    if isinstance(ref, PointRef):
        return (ref.x, ref.y)
    return known.program.place(ref.name)


def _yaw(direction: tuple[float, float]) -> float:
    return math.atan2(direction[1], direction[0])
