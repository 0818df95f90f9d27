"""The room while it is being furnished: what stands where, and what a new cluster at a given place would cost.

All costs are plain sums. One square metre of conflict between bodies costs 100; everything else is a matter of taste between 0 and
about 6, so that a clash is only ever accepted where nothing else is left.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray

from robolayout.assets.obstacles import only_seen
from robolayout.floor import (
    FLOOR,
    Cells,
    Floor,
    Shadow,
    Standing,
    placed,
    rect_points,
    standing,
    turning_radius,
    use_cells,
)
from robolayout.program import Program
from robolayout.scene import Room, Scene, Wall
from robolayout.solve.build.cluster import Cluster, ClusterBuilder
from robolayout.solve.build.form import Forms, at, corners_of, side_rect
from robolayout.solve.build.member import Member, Poses, Rect, box_of, overlaps
from robolayout.solve.build.said import Said, rugs_first
from robolayout.solve.build.wants import Want, late

CLASH = 100.0
"""Cost of a square metre of clash."""

HAIR = 0.002
"""Metres that two things stand apart at least, so that rounding does not make them touch."""

NEAR_WALL = 0.6
"""Metres from a wall within which a thing stands before it."""

AT_WALL, NARROW = 0.35, 0.4
"""Metres from a wall within which a thing covers it, and metres of width up to which it hides little of what hangs behind it."""


@dataclass(frozen=True)
class Spot:
    """Where one asset was put, and why."""

    member: Member  # the asset in the world frame; `bottom` is its height above the floor
    mode: str  # how it stands ("wall", "led", "corner", "middle", "facing", "grid", "hang", "ceiling", "rug", "join", "given")
    wall: int | None = None  # index of its wall
    anchor: str | None = None  # the asset it joins or hangs over


@dataclass(frozen=True)
class Span:
    """What a placed thing covers of a wall close to it."""

    name: str  # the thing
    wall: int  # index of the wall
    depth: float  # metres between its nearest corner and the wall
    rect: Rect  # start and bottom, end and top, in metres along and up the wall


@dataclass(frozen=True, eq=False)
class Claim:
    """What a thing asks of the floor."""

    cells: Cells  # its own cells, to which an agent should get
    # the cells, by agent, from which it uses the thing; None where that is not asked of it
    uses: tuple[Cells | None, ...]
    shadow: Shadow | None  # what it takes of the floor, if it stands there
    foot: shapely.Polygon  # its footprint


@dataclass
class Site:
    """The state of the search."""

    scene: Scene
    wants: Mapping[str, Want]  # what is said of every asset
    floor: Floor  # the grid
    forms: Forms  # what clusters fill and want clear
    corridor: float  # metres that the agent needs to pass
    said: Said  # what statements ask of places
    clusters: ClusterBuilder  # lays out what joins what
    covers: Mapping[str, Sequence[str]]  # what lies under things or hangs over them
    spots: dict[str, Spot] = field(default_factory=dict[str, Spot])  # what is placed, by name, in the order of placing
    spans: list[Span] = field(default_factory=list["Span"])  # what the placed things cover of the walls
    standings: tuple[Standing, ...] = ()  # where each agent gets to, once the floor is furnished
    # exact footprints of what stands on the floor, and the door landings
    solids: list[shapely.Polygon] = field(default_factory=list["shapely.Polygon"])
    # exact footprints of what does not make way for an opening door
    fixed: list[shapely.Polygon] = field(default_factory=list["shapely.Polygon"])
    # exact strips that doors and drawers open into
    openings: list[shapely.Polygon] = field(default_factory=list["shapely.Polygon"])
    # what is asked of the floor by everything that an agent should get to
    claims: dict[str, Claim] = field(default_factory=dict[str, "Claim"])
    # what things in places that were settled before ask of it; shared by all copies
    known: dict[tuple[Member, str], Claim] = field(default_factory=dict[tuple[Member, str], "Claim"])
    late: frozenset[str] = frozenset()  # what is hung and laid once the floor is furnished
    first: frozenset[str] = frozenset()  # rugs that lie where they are asked before things stand on them
    trial: bool = False  # whether this is only to find out what is reached: nothing else is recorded

    @staticmethod
    def of(scene: Scene, wants: Mapping[str, Want], program: Program) -> Site:
        """Return the empty site of a scene, with what a program says of it."""
        corridor = max(0.6, 2 * max(agent.radius for agent in scene.agents) + 0.1)
        floor = Floor.of(scene.room, corridor, max(turning_radius(agent) for agent in scene.agents))
        forms, clusters = Forms(scene, wants, corridor), ClusterBuilder(scene, wants)
        behind = {name for name, want in wants.items() if want.join is not None and want.join.slot == "behind"}
        first = rugs_first(scene, program)
        said = Said.of(scene, program, behind, first)
        covers: dict[str, list[str]] = {}
        for want in wants.values():
            if want.over and (want.asset.is_flat or want.overhead):
                covers.setdefault(want.over[0], []).append(want.name)
        site = Site(
            scene,
            wants,
            floor,
            forms,
            corridor,
            said,
            clusters,
            covers,
            late=frozenset(late(wants)) - first,
            first=first,
        )
        site.solids += [shapely.Polygon(scene.room.landing(door)) for door in scene.room.doors]
        return site

    def copy(self, *, trial: bool = False) -> Site:
        """Return an independent copy; one for a `trial` only tells what is reached."""
        return replace(
            self,
            trial=trial,
            floor=self.floor.copy(),
            spots=dict(self.spots),
            spans=list(self.spans),
            solids=list(self.solids),
            fixed=list(self.fixed),
            openings=list(self.openings),
            claims=dict(self.claims),
        )

    def missed(self, members: Sequence[Member], poses: Poses) -> Poses:
        """Return the cost (n,) of places of things in one frame by what is said and they, or what goes under or over them, miss."""
        placed = {name: spot.member for name, spot in self.spots.items()}
        there, own = {one.name: one for one in members}, list[Member]()
        under = [(one, flat) for one in members for flat in self.covers.get(one.name, ()) if flat not in placed]
        for one, flat in under:
            amid = [there[owner] for owner in self.wants[flat].over if owner in there]
            x, y = (sum(getattr(owner, axis) for owner in amid) / len(amid) for axis in "xy")
            own.append(replace(one, name=flat, x=x, y=y))
        return self.said.missed([*members, *own], poses, placed)

    @property
    def room(self) -> Room:
        """The room."""
        return self.scene.room

    def size(self, name: str) -> tuple[float, float, float]:
        """Return an asset's size."""
        return self.scene.by_name[name].size

    @property
    def cut_off(self) -> float:
        """Share of the free floor that the worst agent cannot get to."""
        return max(found.cut_off for found in self.standings)

    def survey(self) -> None:
        """Find out where the agents get to over the floor as it is furnished now."""
        self.standings = tuple(standing(self.floor, agent) for agent in self.scene.agents)

    def unreached(self, known: Sequence[str] = (), most: float = math.inf) -> list[str]:
        """Return the assets that some agent cannot get to or cannot use since the last `survey`, moving chairs away where it has an arm.

        Args:
            known: Some that were so before more was put down: they are so still.
            most: How many may be so; of more than that no further ones are looked for.
        """
        short = [name for name, claim in self.claims.items() if name not in known and not self.serves(claim)]
        chairs = [name for name in self.claims if self._is_chair(name)] if short else []
        feet = np.array([self.claims[name].foot for name in chairs], dtype=object)
        found = [*known]
        for name in short:
            if len(found) > most:
                break
            found += [name] * (not self._makes_way(name, chairs, feet))
        return found

    def serves(self, claim: Claim) -> bool:
        """Whether every agent gets to a thing and stands on some of the cells from which it uses it."""
        return all(found.serves(claim.cells, use) for found, use in zip(self.standings, claim.uses, strict=True))

    def _makes_way(self, name: str, chairs: Sequence[str], feet: NDArray[np.object_]) -> bool:
        """Whether every agent uses a thing once it has moved away the chairs that stand at it or at what carries it."""
        if self._is_chair(name):
            return False
        claim, carrier = self.claims[name], self.spots[name].anchor
        at = carrier if claim.shadow is None and carrier in self.claims else name
        near = shapely.dwithin(feet, self.claims[at].foot, FLOOR.chair_at)
        moved = [self.claims[chair].shadow for chair, at_it in zip(chairs, near, strict=True) if at_it]
        away = [shadow for shadow in moved if shadow is not None]
        return all(
            found.serves(claim.cells, use) or (use is not None and found.makes_way(use, away))
            for found, use in zip(self.standings, claim.uses, strict=True)
        )

    def _is_chair(self, name: str) -> bool:
        """Whether it stands on the floor and is moved aside in daily use."""
        return self.wants[name].category.movable and self.claims[name].shadow is not None

    def foot(self, name: str) -> shapely.Polygon:
        """Return the footprint of what has a place."""
        return self.outline(self.spots[name].member)

    def outline(self, member: Member) -> shapely.Polygon:
        """Return the footprint of a member where it is."""
        return shapely.Polygon(corners_of(member, self.size(member.name)))

    def claim(self, spot: Spot) -> Claim:
        """Return what a thing would ask of the floor there."""
        member = spot.member
        found = self.known.get((member, spot.mode))
        if found is None:
            depth, width, _ = self.size(member.name)
            points = rect_points((-depth / 2, -width / 2, depth / 2, width / 2), 0.0)
            asset, carried = self.scene.by_name[member.name], spot.mode == "join" and member.bottom > 0.01
            place = (member.x, member.y, member.yaw)
            uses = [use_cells(self.floor, asset, a, place, member.bottom, carried=carried) for a in self.scene.agents]
            corners, flat = corners_of(member, asset.size), asset.is_flat
            shadow = self.floor.shadow(corners, flat=flat) if self._takes_floor(spot) else None
            cells, _ = self.floor.flat(placed(points, *place))
            found = Claim(cells, tuple(uses), shadow, self.outline(member))
            if not self.trial:
                self.known[member, spot.mode] = found
        return found

    def _takes_floor(self, spot: Spot) -> bool:
        return self.on_floor(spot.member) and spot.mode not in ("ceiling", "rug")

    def on_floor(self, member: Member) -> bool:
        """Whether a member takes floor space."""
        return self.forms.on_floor(member)

    def behind(self, member: Member) -> float:
        """Return the smallest x of a floor member in its cluster's frame, metres; 0 for what is on a top."""
        return box_of(member, self.size(member.name))[0] if self.on_floor(member) else 0.0

    def backed(self, cluster: Cluster) -> bool:
        """Return whether something stands behind a cluster's anchor: desks that face each other."""
        return min(map(self.behind, cluster.members)) < self.behind(cluster.members[0])

    def clash(self, cluster: Cluster, poses: Poses, limit: float = math.inf) -> NDArray[np.float64]:
        """Return the cost (n,) of standing on other things, outside the room or in a landing.

        Of places that clash more than `limit` only that is known.
        """
        barred, total, left = self.floor.maps().barred, np.zeros(len(poses)), np.arange(len(poses))
        for points, area in self.forms.bodies(cluster):
            total[left] += CLASH * area * barred[self.floor.under(points, poses[left])].mean(axis=1)
            left = left[total[left] <= limit]
        return total

    def base_cost(
        self, cluster: Cluster, poses: Poses, clash: NDArray[np.float64] | None = None
    ) -> NDArray[np.float64]:
        """Return the cost (n,) of clashes (known already or not), of standing where others want room, and of having no room before it.

        Places that clash much more than the best one are given up early, at the price of their clash.
        """
        total, maps = self.clash(cluster, poses) if clash is None else clash, self.floor.maps()
        good = total <= total.min() + 4.0
        cost, here = total[good], poses[good]
        for points, area in self.forms.bodies(cluster):
            under = self.floor.under(points, here)
            cost += 4.0 * math.sqrt(area) * maps.wanted[under].mean(axis=1)
        strips: dict[tuple[str, str], list[NDArray[np.float32]]] = {}
        for strip in self.forms.strips(cluster):
            blocked = maps.taken[self.floor.under(strip.points, here)].mean(axis=1)
            strips.setdefault(strip.group, []).append(blocked)
        for values in strips.values():
            stack = np.stack(values)
            cost += 6.0 * stack.min(0) + 1.0 * stack.mean(0)
        total[good] = cost
        total[~good] += 12.0
        return total

    def fault(self, cluster: Cluster, pose: NDArray[np.float64]) -> str:
        """Return what is wrong with a cluster at a pose, to the millimetre: "touches", "shut" (a door) or nothing.

        It touches things, a landing or the walls.
        """
        x, y, yaw = (float(value) for value in pose)
        members = [m for m in cluster.members if self.on_floor(m)]
        corners = np.array([corners_of(m.moved(x, y, yaw), _grown(self.size(m.name))) for m in members])
        bodies = np.asarray(shapely.polygons(corners))
        if not shapely.covers(_walls_of(self.room), bodies).all():
            return "touches"
        if _touch(bodies, self.solids) or any(
            _touch(np.array([body]), self._hung_below(m.bottom + self.size(m.name)[2]))
            for body, m in zip(bodies, members, strict=True)
        ):
            return "touches"
        return "" if self._opens(members, bodies, pose) else "shut"

    def _hung_below(self, height: float) -> list[shapely.Polygon]:
        """Return the footprints of what hangs on the walls and begins below a height in metres."""
        return [self.foot(n) for n, s in self.spots.items() if s.mode == "hang" and s.member.bottom < height]

    def _opens(self, members: Sequence[Member], bodies: NDArray[np.object_], pose: NDArray[np.float64]) -> bool:
        """Whether doors and drawers of floor members open, and those of what stands there already."""
        fixed = [body for body, m in zip(bodies, members, strict=True) if not self.wants[m.name].category.movable]
        if _touch(np.array(fixed), self.openings):
            return False
        x, y, yaw = (float(value) for value in pose)
        strips = [strip for m in members if (strip := self.opening(m.moved(x, y, yaw))) is not None]
        inside = bool(shapely.covers(_walls_of(self.room), strips).all())
        return inside and not _touch(np.array(strips), [*self.fixed, *fixed])

    def opening(self, member: Member) -> shapely.Polygon | None:
        """Return the strip that the doors or drawers of a floor thing open into, or None."""
        item = self.wants[member.name]
        if item.category.open_depth <= 0 or "front" not in (item.asset.use_sides or item.category.use_sides):
            return None
        left, bottom, right, top = side_rect(self.size(member.name), "front", item.category.open_depth)
        inner = np.array([(left + 0.01, bottom), (right, bottom), (right, top), (left + 0.01, top)])
        return shapely.Polygon(at(member, inner))

    def put(self, cluster: Cluster, pose: NDArray[np.float64], mode: str, wall: int | None = None) -> None:
        """Place a cluster: record its members and mark the floor, also what it wants clear unless this is a `trial`."""
        x, y, yaw = (float(value) for value in pose)
        rear = min(self.behind(member) for member in cluster.members)
        for member in cluster.members:
            first, at_wall = member.name == cluster.anchor, self.behind(member) < rear + 0.02 and abs(member.yaw) < 0.01
            own = mode if not first or at_wall or mode != "wall" else "middle"
            here, anchor = member.moved(x, y, yaw), self.wants[member.name].anchor
            self.settle(member.name, Spot(here, own if first else "join", wall if at_wall else None, anchor))
        for strip in () if self.trial else self.forms.strips(cluster):
            self.floor.want(placed(strip.points, x, y, yaw), 1.0 if strip.group[1] != "any" else 0.5)

    def settle(self, name: str, spot: Spot) -> None:
        """Record where one asset is, the floor that it takes and the walls that it covers."""
        self.spots[name] = spot
        if spot.mode not in ("ceiling", "rug"):
            claim = self.claim(spot)
            if not only_seen(self.scene.by_name[name]):
                self.claims[name] = claim
            if claim.shadow is not None:
                self.floor.take(claim.shadow)
            if not self.trial:
                self._record(name, spot)

    def _record(self, name: str, spot: Spot) -> None:
        """Record exactly what one asset fills and what it covers of the walls."""
        if self._takes_floor(spot):
            self.solids.append(self.foot(name))
            if not self.wants[name].category.movable:
                self.fixed.append(self.solids[-1])
            strip = self.opening(spot.member)
            self.openings += [strip] if strip is not None else []
        for wall in self.room.walls:
            span = along_wall(spot.member, self.size(name), wall)
            if span is not None:
                top = spot.member.bottom + self.size(name)[2]
                self.spans.append(Span(name, wall.index, span[2], (span[0], spot.member.bottom, span[1], top)))

    def wall_takers(self, wall: Wall, depth: float = math.inf) -> list[tuple[Rect, str]]:
        """Return what covers a wall: (start, low, end, high) along it and up it, in metres, with a name each.

        What is to hang over something, so many metres deep, may hang behind a vase that stands there.
        """
        takers: list[tuple[Rect, str]] = []
        for kind, openings in (("door", self.room.doors), ("window", self.room.windows)):
            here = (o for o in openings if o.wall == wall.index)
            takers += [((o.offset, o.sill, o.offset + o.width, o.sill + o.height), kind) for o in here]
        near = (span for span in self.spans if span.wall == wall.index and span.depth <= AT_WALL)
        return [*takers, *((span.rect, span.name) for span in near if not self._before(span, depth))]

    def _before(self, span: Span, depth: float) -> bool:
        """Whether a thing is narrow, stands on another and leaves so many metres to the wall behind it."""
        narrow = span.rect[2] - span.rect[0] <= NARROW and self.spots[span.name].mode == "join"
        return narrow and span.rect[1] > 0.0 and span.depth > depth + HAIR

    def wall_conflict(self, rect: Rect, takers: Sequence[tuple[Rect, str]], margin: float = 0.05) -> float:
        """Return the share of a rectangle on a wall that something else covers, at most 1."""
        area = max((rect[2] - rect[0]) * (rect[3] - rect[1]), 1e-6)
        total = 0.0
        for other, _ in takers:
            if overlaps(rect, other, margin):
                wide = min(rect[2], other[2]) - max(rect[0], other[0]) + margin
                high = min(rect[3], other[3]) - max(rect[1], other[1]) + margin
                total += wide * high / area
        return min(total, 1.0)


@lru_cache(maxsize=16)
def _walls_of(room: Room) -> shapely.Polygon:
    """Return the floor of a room, 8 mm wider, so that rounding puts nothing outside."""
    return shapely.Polygon(room.vertices).buffer(0.008, join_style="mitre")


def _touch(bodies: NDArray[np.object_], others: Sequence[shapely.Polygon]) -> bool:
    """Whether any of these polygons shares more than a sliver with any of the others."""
    if not len(bodies) or not others:
        return False
    return bool((shapely.area(shapely.intersection(bodies[:, None], others)) >= 5e-5).any())


def _grown(size: tuple[float, float, float]) -> tuple[float, float, float]:
    """Return a size with `HAIR` on every side."""
    return (size[0] + 2 * HAIR, size[1] + 2 * HAIR, size[2])


def along_wall(member: Member, size: tuple[float, float, float], wall: Wall) -> tuple[float, float, float] | None:
    """Return start, end and depth in metres of what a thing within `NEAR_WALL` of a wall covers of it, or None."""
    (dx, dy), (nx, ny), (along, depth) = wall.direction, wall.normal, wall.place((member.x, member.y))
    c, s = math.cos(member.yaw), math.sin(member.yaw)
    half_along = (abs(c * dx + s * dy) * size[0] + abs(c * dy - s * dx) * size[1]) / 2
    half_depth = (abs(c * nx + s * ny) * size[0] + abs(c * ny - s * nx) * size[1]) / 2
    low, high = along - half_along, along + half_along
    if not -0.3 <= depth - half_depth <= NEAR_WALL or high < 0 or low > wall.length:
        return None
    return (low, high, depth - half_depth)
