"""Use: can the agent stand where each asset can be used?

An asset is used from its sides (a wardrobe from the front, a bed from left or right). The agent can use it when its
centre can stand in the main component, beyond that side's edge, within horizontal and vertical reach, and when what
must be opened has room to open. What stands on something is reached over the edge of its carrier, and what a person
moves in daily use (a chair) is taken hold of from any side. A body with an arm moves chairs away from what it uses: from
its place at a table it gets to what lies before it. A seated body works at a desk, table, basin or counter frontally only
where its knees and toes have room below, else from beside it. A body with a turning radius must find a way to drive there.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from typing import TYPE_CHECKING

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from robolayout.assets import sweeps_of
from robolayout.scene import ROUNDING, Agent, Asset, Hold, Layout, Point, Scene
from robolayout.scene.agent import BODY, horizontal_reach
from robolayout.verify._approaches import approaches, by_hand, handles, needs_no_use, swept
from robolayout.verify._boxes import in_room, out_of_room, room_polygon, share, shared_area
from robolayout.verify._knees import frontal, is_sat_at
from robolayout.verify._space import areas
from robolayout.verify.heading import Drive, Headings, HeadingSpace, Region, entry, grown, rectangle
from robolayout.verify.holds import find_hold, within_reach
from robolayout.verify.limits import JUDGE
from robolayout.verify.navigation import Navigation, height_reason, navigation

if TYPE_CHECKING:
    from robolayout.verify.driving import Lattice


@dataclass(frozen=True)
class Use:
    """Whether and how an asset can be used."""

    asset: str  # its name
    usable: bool  # the verdict
    side: str  # the side it is used from; empty where any side will do
    stand: Point | None  # A place for the agent's centre, metres; None where it is not usable or needs no use
    reason: str  # why it cannot be used, as the end of a sentence; empty if it can
    moved: tuple[str, ...] = ()  # what is moved away to stand there: chairs at a table
    opens: str = ""  # the door or drawer whose handle it takes hold of from there; empty where nothing is opened
    approach: str = ""  # "frontally" or "sideways" where a seated body works at it; empty for everything else


class Usage:
    """What an agent can use in a layout; details are worked out when first asked for."""

    def __init__(self, nav: Navigation) -> None:
        self.agent, self._nav, self._found = nav.agent, nav, nav.boxes
        self._ways, self._idle = approaches(nav.boxes, nav.agent), needs_no_use(nav.boxes)
        rectangular = self.agent.length is not None and self.agent.width is not None
        self._headings = Headings(nav.scene.room, nav.blocking, self.agent) if rectangular else None
        self._touches = self.agent.reach_distance is None and rectangular
        self._touching = cache(self._touched)
        self._held: dict[int, tuple[Hold, ...]] = {}
        self._used = cache(self._use)
        self._approach = self._approaches()

    @cached_property
    def usable(self) -> Mapping[str, bool]:
        """Verdict per asset."""
        *_, usable = self.narrowed()
        return usable

    def narrowed(self, first: Container[str] = ()) -> Iterator[Mapping[str, bool]]:
        """Yield the verdict each time that it cannot open another of what it gets to, and at the end; these names are looked at first."""
        usable = self._got_to.copy()
        for row in sorted(np.flatnonzero(usable).tolist(), key=lambda row: self._found.names[row] not in first):
            if self._shut(row):
                usable[row] = False
                yield self._found.by_name(usable)
        yield self._found.by_name(usable)

    @property
    def usable_share(self) -> float:
        """Share of all assets that can be used."""
        return share(list(self.usable.values()))

    @property
    def standing(self) -> Mapping[str, bool]:
        """By asset, whether it could stand where it uses it, however it drives there and whatever it opens."""
        return self._found.by_name(self._standing)

    @property
    def got_to(self) -> Mapping[str, bool]:
        """By asset, whether it gets to where it uses it, whatever it opens."""
        return self._found.by_name(self._got_to)

    @cached_property
    def undriven(self) -> tuple[str, ...]:
        """What a body with a turning radius could stand at, but finds no way to drive to."""
        unused = (row for row, usable in enumerate(self.usable.values()) if not usable)
        return tuple(self._found.names[row] for row in unused if self._stranded(row) is not None)

    @property
    def headings(self) -> HeadingSpace | None:
        """Where a rectangular body gets to and turns; None for a disc."""
        return self._headings and self._headings.space

    def shutting(self, name: str) -> tuple[str, ...]:
        """Return the assets that stand where a placed one needs room to open, or the body room to turn or to open it."""
        row = self._found.names.index(name)
        found = (*self._in_front.get(row, ()), *self._barring, *self._cramping(row), *self._crowding(row))
        return tuple(blocker for blocker in dict.fromkeys(found) if blocker in self._found.names)

    def too_high(self, name: str) -> bool:
        """Return whether nothing to take hold of is at a height that the agent reaches, wherever in the plan it stands."""
        return not self._ways.of(self._found.names.index(name))

    @cached_property
    def uses(self) -> Mapping[str, Use]:
        """How each placed asset is used, or why not."""
        return {self._found.names[row]: self._used(row) for row in np.flatnonzero(self._found.placed).tolist()}

    @cached_property
    def holds(self) -> tuple[Hold, ...]:
        """How the body opens each door and drawer, of what it uses from the front, whose handle is at a height that it reaches."""
        rows = np.unique([row for row, side in self._each if side == "front" and by_hand(self._found, self.agent, row)])
        return tuple(hold for row in rows.tolist() if self._used(row).opens for hold in self._holds(row))

    @cached_property
    def _standing(self) -> NDArray[np.bool_]:
        """(n,) what the body could stand at to use it."""
        return self._plain | self._aside(self._plain)

    @cached_property
    def _got_to(self) -> NDArray[np.bool_]:
        """(n,) what the body gets to where it uses it."""
        plain = self._plain & self._driven
        return plain | (self._standing if self._driven.all() else self._aside(plain))

    @cached_property
    def _able(self) -> NDArray[np.bool_]:
        """(m,) at which approaches nothing stands where something must open."""
        return np.array([side != "front" or not self._in_front.get(row) for row, side in self._each], dtype=bool)

    def _aside(self, usable: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """Return (n,) what a body can use once chairs are moved away, of what it cannot use yet."""
        found, rows = np.zeros(len(usable), dtype=bool), self._ways.rows
        for row in sorted(set(rows[self._able & ~usable[rows]].tolist())):
            of_row = np.flatnonzero(self._able & (rows == row))
            found[row] = any(
                shapely.intersects(region, self._ways.zones[of_row[self._faces(heading)[of_row]]]).any()
                for heading, region in self._opened(row)
            )
        return found

    def _shut(self, row: int) -> bool:
        """Return whether an asset is used by opening it, and the body can open nothing of it."""
        sides = [self._ways.sides[number] for number in self._ways.of(row)]
        by_hand = bool(sides) and set(sides) == {"front"} and bool(handles(self._found, self.agent, row))
        return by_hand and not any(hold.poses for hold in self._holds(row))

    @cached_property
    def _plain(self) -> NDArray[np.bool_]:
        """(n,) what the body could stand at to use it, no chair moved."""
        rows, headings = self._ways.rows, self._headings
        usable, able = self._found.placed & self._idle, self._able

        def waiting() -> NDArray[np.intp]:
            return np.flatnonzero(able & ~usable[rows])

        def stand(regions: Iterable[Region], touching: bool = False) -> None:
            for heading, region in regions:
                some, zones = waiting(), self._touching(heading) if touching else self._ways.zones
                some = some[self._faces(heading)[some]]
                shapely.prepare(region)
                usable[rows[some[shapely.intersects(region, zones[some])]]] = True

        if headings is not None:
            stand(headings.surely)
        if headings is None or shapely.intersects(headings.at_most, self._ways.zones[waiting()]).any():
            stand(self._everywhere)
        if self._touches and len(waiting()):
            stand(self._everywhere, touching=True)
        return usable

    @cached_property
    def _everywhere(self) -> tuple[Region, ...]:
        """Where the body gets to as things stand, by heading."""
        if self._headings is not None:
            return self._headings.space.regions
        return () if self._nav.main.is_empty else ((0.0, self._nav.main),)

    def _chairs(self, row: int) -> frozenset[int]:
        """Return which chairs are moved away to use an asset."""
        return self._nav.blocking.moved_for(self._found, row)

    def _opened(self, row: int) -> Iterable[Region]:
        """Return where a body gets to besides once the chairs of an asset are moved away."""
        moved = self._chairs(row)
        if not moved:
            return ()
        if self._headings is not None:
            return self._headings.opened(moved)
        return ((0.0, part) for part in self._nav.space.opened(moved))

    def _approaches(self) -> NDArray[np.object_]:
        """Return (m,) how a seated body works at each approach: "frontally" or "sideways"; empty where it is all one."""
        sits = self.agent.knee_height is not None and self._headings is not None

        def way(asset: Asset, side: str) -> str:
            if not (sits and side and is_sat_at(asset)):
                return ""
            return "frontally" if frontal(asset, side) else "sideways"

        return np.array([way(self._found.assets[row], side) for row, side in self._each], dtype=object)

    def _faces(self, heading: float) -> NDArray[np.bool_]:
        """Return (m,) which approaches a body may make at a heading in radians: sideways ones along their edge only."""
        sideways = self._approach == "sideways"
        if not sideways.any():
            return ~sideways
        along = self._ways.edges[:, 1] - self._ways.edges[:, 0]
        across = np.abs(along[:, 0] * math.sin(heading) - along[:, 1] * math.cos(heading)) / np.hypot(*along.T)
        return ~sideways | (across <= math.sin(JUDGE.along))

    @property
    def _each(self) -> Iterator[tuple[int, str]]:
        return zip(self._ways.rows.tolist(), self._ways.sides, strict=True)

    def _stands(self, row: int) -> Iterator[tuple[int, BaseGeometry, frozenset[int]]]:
        """Yield how an asset can be used: number of the approach, where the centre stands, what may have to be moved away."""
        able = [i for i in self._ways.of(row) if self._able[i]]
        for i in able:
            yield from ((i, places, frozenset()) for places in self._spots(i, self._everywhere))
        chairs = self._chairs(row)
        for i in able:
            yield from ((i, places, chairs) for places in self._spots(i, self._opened(row)))

    def _spots(self, number: int, regions: Iterable[Region]) -> Iterator[BaseGeometry]:
        """Yield where the centre stands at an approach, of these regions."""
        for heading, region in regions:
            if self._faces(heading)[number]:
                for zones in (self._ways.zones, self._touching(heading)) if self._touches else (self._ways.zones,):
                    yield region.intersection(zones[number])

    def _touched(self, heading: float) -> NDArray[np.object_]:
        """Return (m,) from where the body touches each approach at a heading in radians."""
        return self._ways.touching(rectangle(self.agent, heading))

    @cached_property
    def drives(self) -> Mapping[str, Drive] | None:
        """How a body with a turning radius drives to what it uses, no chair moved; None for one that slides sideways."""
        if not self._steers:
            return None
        return self._lattice.drives(self._places) if self._lattice else {}

    @property
    def _steers(self) -> bool:
        """Whether the body cannot slide sideways."""
        return self.agent.turning_radius is not None and self._headings is not None

    @cached_property
    def _lattice(self) -> Lattice | None:
        """Where a body that steers drives; None if it comes in nowhere."""
        from robolayout.verify.driving import Lattice

        room, agent, headings = self._nav.scene.room, self.agent, self._headings
        assert headings is not None
        if room.doors:  # where its centre comes in if nothing is in the way
            came_in = room.walls[room.doors[0].wall].point(room.doors[0].center, (agent.length or 0.0) / 2)
        elif headings.space.start is None:
            return None
        else:
            came_in = entry(room, headings.space.pieces[headings.space.start])
        return Lattice(room, self._nav.blocking, agent, came_in, headings.headings[0])

    @cached_property
    def _driven(self) -> NDArray[np.bool_]:
        """(n,) what the body gets to with its heading."""
        if not self._steers:
            return np.ones(len(self._found.names), dtype=bool)
        reached = self._lattice.reached(self._places) if self._lattice else set[str]()
        return self._idle | np.isin(self._found.names, list(reached))

    def _stranded(self, row: int) -> BaseGeometry | None:
        """Return from where a body would use an asset if it found a way to drive there; None where it does, or has no place."""
        stands = () if self._driven[row] else self._stands(row)
        return next((places for _, places, chairs in stands if not chairs and not places.is_empty), None)

    def _cramping(self, row: int) -> tuple[str, ...]:
        """Return what stands within the turning circle of a body that finds no way to where it would use an asset."""
        places, blocking = self._stranded(row), self._nav.blocking
        if places is None:
            return ()
        spot = shapely.get_point(shapely.shortest_line(places, self._found.footprints[row].centroid), 0)
        return self._others(row, shapely.distance(blocking.shapes, spot) < self.agent.turning_circle / 2)

    def _places(self, heading: float) -> Iterator[tuple[str, bytes]]:
        """Yield what the body may use at a heading in radians, and from where, as WKB."""
        keys = self._keys
        if self._touches:
            keys = np.asarray(shapely.to_wkb(shapely.union(self._ways.zones, self._touching(heading))), dtype=object)
        for number in np.flatnonzero(self._able & self._faces(heading)).tolist():
            yield self._found.names[int(self._ways.rows[number])], keys[number]

    @cached_property
    def _keys(self) -> NDArray[np.object_]:
        """(m,) from where each approach is made, as WKB."""
        return np.asarray(shapely.to_wkb(self._ways.zones), dtype=object)

    @cached_property
    def _in_front(self) -> Mapping[int, tuple[str, ...]]:
        """What keeps assets from being opened, by row."""
        found = self._found
        rows, zones, heights = swept(found, (row for row, side in self._each if side == "front"))
        shapely.prepare(zones)
        outside = shapely.area(shapely.difference(zones, room_polygon(self._nav.scene.room))) > JUDGE.area
        others = np.flatnonzero(found.placed & ~found.flat & ~found.movable)
        low, high = np.maximum(found.bottom[others], heights[:, :1]), np.minimum(found.top[others], heights[:, 1:])
        level = (high - low > 0.01) & (others != rows[:, None])
        at, what = np.nonzero(level & shapely.intersects(zones[:, None], found.footprints[others]))
        inside = shared_area(found.footprints[others[what]], zones[at]) > JUDGE.area
        met = [(k, "the wall") for k in np.flatnonzero(outside)]
        met += [(k, found.names[other]) for k, other in zip(at[inside], others[what[inside]], strict=True)]
        blockers = {row: list[str]() for row in rows.tolist()}
        for k, name in met:
            blockers[int(rows[k])].append(name)
        return {row: tuple(dict.fromkeys(names)) for row, names in blockers.items()}

    def _use(self, row: int) -> Use:
        name = self._found.names[row]
        if self._idle[row]:
            return Use(name, True, "", None, "")
        ways = (way for way in self._stands(row) if not way[1].is_empty and (way[2] or self._driven[row]))
        way = next(ways, None)
        if way is None or self._shut(row):
            return Use(name, False, "", None, self._reason(row))
        number, places, chairs = way
        side = self._ways.sides[number]
        spot = shapely.get_coordinates(shapely.shortest_line(places, self._ways.target(number).centroid))[0]
        near = shapely.Point(spot).buffer(self.agent.circumradius)
        moved = [i for i in sorted(chairs) if near.intersects(self._found.footprints[i])] or sorted(chairs)
        names = tuple(self._found.names[i] for i in moved)
        place = (float(spot[0]), float(spot[1]))
        hands = by_hand(self._found, self.agent, row) if side == "front" else ()
        frame, here = self._found.where(row)[1], shapely.Point(place)
        away = {joint.name: in_room(shapely.Point(joint.handle[:2]), frame).distance(here) for joint, _ in hands}
        nearest = min(away, key=lambda joint: (away[joint], joint), default="")
        return Use(name, True, side, place, "", names, nearest, self._approach[number])

    def _holds(self, row: int) -> tuple[Hold, ...]:
        """Return how the body opens each door and drawer whose handle is at a height that it reaches."""
        if row in self._held:
            return self._held[row]
        hands = by_hand(self._found, self.agent, row)
        hands = tuple((joint, reach + ROUNDING) for joint, reach in hands)
        regions = itertools.tee(self._before(row, within_reach(hands)), len(hands))
        self._held[row] = tuple(
            find_hold(self._found, self.agent, row, joint, reach, stands)
            for (joint, reach), stands in zip(hands, regions, strict=True)
        )
        return self._held[row]

    def _before(self, row: int, near: BaseGeometry) -> Iterator[tuple[float, BaseGeometry, tuple[str, ...]]]:
        """Yield from where a body opens an asset, in its frame, as far as that is `near`.

        These are headings, places before its front, and what is moved for them.
        """
        place = self._found.where(row)[1]
        front = next(i for i in self._ways.of(row) if self._ways.sides[i] == "front")
        before = self._ways.beyond[front].intersection(in_room(near, place))
        chairs = tuple(self._found.names[i] for i in sorted(self._chairs(row)))
        for moved in (False, True):
            for heading, region in self._opened(row) if moved else self._everywhere:
                yield heading - place[3], out_of_room(areas(region & before), place), chairs if moved else ()

    def _crowding(self, row: int) -> tuple[str, ...]:
        """Return what stands where a body would open what of an asset stays shut: as far ahead as that sweeps and it is wide."""
        if all(hold.poses for hold in self._held.get(row, ())):
            return ()
        asset, place = self._found.where(row)
        deep = max(sweep.region.bounds[2] for sweep in sweeps_of(asset)) + 2 * self.agent.radius
        strip = in_room(shapely.box(asset.size[0] / 2, -asset.size[1] / 2, deep, asset.size[1] / 2), place)
        return self._others(row, shapely.intersects(self._nav.blocking.shapes, strip))

    @cached_property
    def _barring(self) -> tuple[str, ...]:
        """The assets that stand where a rectangular body would come in by the first door; none where it comes in."""
        room = self._nav.scene.room
        if self._headings is None or self._headings.space.start is not None or not room.doors:
            return ()
        way = shapely.Polygon(room.landing(room.doors[0], self.agent.length))
        return self._others(-1, shapely.intersects(self._nav.blocking.shapes, way))

    def _others(self, row: int, near: NDArray[np.bool_]) -> tuple[str, ...]:
        """Return the assets, one aside, of which such obstacles are parts."""
        return tuple(self._found.names[other] for other in np.unique(self._nav.blocking.rows[near]) if other != row)

    def _reason(self, row: int) -> str:
        agent, found = self.agent, self._found
        bottom, top = float(found.bottom[row]), float(found.top[row])
        reach = horizontal_reach(agent, bottom, top)
        if reach is None:
            return height_reason(agent, bottom, top)
        numbers = self._ways.of(row)
        if not numbers:
            held = [joint.hold for joint, _ in handles(found, agent, row)]
            z = float(found.poses[row, 2])
            low, high = z + min(low for low, _ in held), z + max(high for _, high in held)
            return f"its handles lie {low:.2f} to {high:.2f} m high, reach is from {agent.reach_low:.2f} to {agent.reach_high:.2f} m"
        if blockers := self._barring or self._in_front.get(row):
            why = "it cannot come in straight by door 0" if self._barring else "its front has no room to open"
            return f"{why}: {' and '.join(blockers)} in the way"
        sides = " or ".join(self._ways.sides[i] for i in numbers if self._ways.sides[i]) or "edge"
        if self._stranded(row) is not None:
            near = self._cramping(row)
            why = f": {' and '.join(near)} leave{'s' * (len(near) == 1)} no room to turn" if near else ""
            return f"it could stand at its {sides}, but finds no way to drive there{why}"
        if row in self._held:
            return "there is no place from which it could hold any of its doors and drawers until that is open"
        away = min((self._nearest(row, i) for i in numbers), default=math.inf)
        if away > JUDGE.far:
            return f"there is no place to stand at its {sides}"
        if "sideways" in self._approach[numbers] and away <= reach:
            return f"it has no room for knees below its {sides}, and there is no place beside it"
        if self._touches:
            return f"the nearest that it gets to its {sides} is {away:.2f} m, touching distance is {BODY.touch:.2f} m"
        if away <= reach:
            return f"where it would reach its {sides}, what opens there is in its way"
        return f"the nearest place to stand is {away:.2f} m from its {sides}, reach is {reach:.2f} m at that height"

    def _nearest(self, row: int, number: int) -> float:
        """Return metres from an approach to the nearest place to stand beyond it (or to a body that only touches)."""
        target, away = self._ways.target(number), math.inf
        for heading, region in (*self._everywhere, *self._opened(row)):
            place = region.intersection(self._ways.beyond[number])
            if not place.is_empty:
                if self._touches:
                    (target,) = grown(self._ways.corners[[number]], rectangle(self.agent, heading))
                away = min(away, place.distance(target))
        return away


def usage(scene: Scene, layout: Layout, agent: Agent | None = None, *, nav: Navigation | None = None) -> Usage:
    """Judge what an agent can use."""
    return Usage(nav or navigation(scene, layout, agent))
