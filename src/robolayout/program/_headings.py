"""Which way statements turn things, as far as walls, other headings and first guesses of places tell.

A heading is known in the frame of the room where a wall gives it, or of the asset at the end of a chain of `align_with`. Where a
thing shall look at another, both need a first guess: what a statement asks is compared with that, never fitted to it.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple

from shapely import LineString, Point
from shapely.geometry.base import BaseGeometry

from robolayout.constraints import AssetRef, PointRef, Ref, Relation, WallRef
from robolayout.constraints.against_wall import AgainstWall
from robolayout.constraints.align_with import AlignWith
from robolayout.constraints.facing_pair import FacingPair
from robolayout.constraints.mounted_on import MountedOn
from robolayout.constraints.point_towards import PointTowards
from robolayout.constraints.row import Row
from robolayout.program._possible import inner_radius

if TYPE_CHECKING:
    from robolayout.program._rules import Accepted

ROOM = ""  # stands for the frame of the room


class Heading(NamedTuple):
    """A yaw in radians in the frame of the room or of an asset."""

    frame: str
    yaw: float


def heading_gap(known: Accepted, relation: Relation, name: str) -> float | None:
    """Return by how many degrees a relation would turn a thing away from its first heading; None if nobody can tell."""
    first = heading_of(known, name)
    if isinstance(relation, FacingPair):
        other = relation.b if relation.a.name == name else relation.a
        relation = PointTowards(AssetRef(name), other)
    wanted = _implied(known, relation, ())
    if wanted is None or wanted.frame != first.frame:
        return None
    if isinstance(relation, PointTowards) and _looks_at(known, relation, first.yaw):
        return 0.0
    return abs(math.degrees(math.remainder(wanted.yaw - first.yaw, math.tau)))


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
        here, there = _place(known, relation.a), _place(known, relation.b)
        if here and there and here != there:
            return Heading(ROOM, _yaw((there[0] - here[0], there[1] - here[1])) + math.radians(relation.angle))
    return None


def _looks_at(known: Accepted, relation: PointTowards, yaw: float) -> bool:
    """Return whether the front of a thing with that yaw, turned back by the angle, hits what it shall look at."""
    x, y = _place(known, relation.a) or (0.0, 0.0)
    yaw, (x0, y0, x1, y1) = yaw - math.radians(relation.angle), known.scene.room.bounds
    far = math.hypot(x1 - x0, y1 - y0) + math.hypot(x - x0, y - y0)
    ray = LineString([(x, y), (x + far * math.cos(yaw), y + far * math.sin(yaw))])
    return ray.intersects(_shape(known, relation.b))


def _shape(known: Accepted, ref: Ref) -> BaseGeometry:
    """Return a wall's segment, or the disc that a thing covers whatever its heading, where it is first guessed."""
    if isinstance(ref, WallRef):
        wall = known.scene.room.walls[ref.index]
        return LineString([wall.start, wall.end])
    place = _place(known, ref)
    radius = inner_radius(known.scene.by_name[ref.name]) if isinstance(ref, AssetRef) else 0.0
    return Point(place).buffer(radius) if place else Point()


def _place(known: Accepted, ref: Ref) -> tuple[float, float] | None:
    """Return where something is: a wall's middle, a point, a thing's first guess."""
    if isinstance(ref, WallRef):
        return known.scene.room.walls[ref.index].midpoint
    if isinstance(ref, PointRef):
        return (ref.x, ref.y)
    return known.program.place(ref.name)


def _yaw(direction: tuple[float, float]) -> float:
    return math.atan2(direction[1], direction[0])
