"""What so many metres between things, or between a thing and a wall or an opening, ask for."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import replace
from functools import partialmethod
from itertools import pairwise, product

from robolayout.assets import category_of
from robolayout.constraints import AssetRef, PointRef, Relation, WallRef
from robolayout.scene import ROUNDING
from robolayout.words import _function_words as small
from robolayout.words import _ways as ways_of
from robolayout.words._places import Asked, AtPlaces
from robolayout.words._rows import alike, in_rows
from robolayout.words._said import Place
from robolayout.words._walls import openings_meant, walls_meant
from robolayout.words.demands import Demand, EdgeGap, Way, single, stated


class HowFar(AtPlaces):
    """Says how far apart things are to stand."""

    lined: Set[str]
    """What stands in one line."""

    metres: Mapping[tuple[str, str], tuple[float, float]]
    """Least and most metres that are told to lie between two things."""

    def _told(self, a: str, b: str) -> float:
        """Return the most metres that are told to lie between two things, 0 where none are."""
        return min(self.metres.get((a, b), (0.0, 0.0))[1], ways_of.ACROSS)

    def _sits_behind(self, a: str, b: str) -> bool:
        """Return whether who sits on a thing that is behind another uses that from there."""
        return self._is(a, small.SEATS) and self._is(b, ("desk", "counter")) and not self._is(b, ("reception desk",))

    def _apart(self, it: Asked, metres: tuple[float, float]) -> Iterator[Demand]:
        """So many metres between the edges of two things, or of a thing and a place; "at least" holds for each such place."""
        by_themselves = not (it.groups or it.place)
        if by_themselves and self.told.in_rows(it.subjects):
            yield self.told.block(it.subjects)
            return
        if by_themselves and len(it.subjects) >= ways_of.CROWD and alike(self.scene, it.subjects):
            lined = {*it.subjects} <= self.lined
            yield in_rows(it.subjects, 1 if lined else None, gap=metres[0], aisle=0.0 if lined else metres[0])
            return
        twos = [two for group in it.groups for two in replace(it, groups=[group]).twos]
        for a, b in pairwise(it.subjects) if by_themselves else twos:
            yield self._gap(a, (AssetRef(b),), *metres)
        for a, place in product(it.subjects, it.places):
            walls = place.name == "wall" and walls_meant(self.room, place)
            to = [WallRef(wall.index) for wall in walls] if walls else self._points(place)
            every = metres[1] == math.inf or place.det == "all"
            for ends in [(end,) for end in to] if every else [tuple(to)] * bool(to):
                yield self._gap(a, ends, *metres)

    def _gap(self, a: str, to: tuple[AssetRef | PointRef | WallRef, ...], low: float, high: float) -> Demand:
        """Return that so many metres lie between a thing and the nearest of some others; a bed may have another wall at its head."""
        ways = tuple(way for end in to for way in self._ways_apart(a, end, low, high, to))
        return Demand(ways, gap=EdgeGap(AssetRef(a), to, low, high, nearest=not self._is(a, small.SLEPT_ON)))

    def _ways_apart(
        self,
        a: str,
        b: AssetRef | PointRef | WallRef,
        low: float,
        high: float,
        to: Sequence[AssetRef | PointRef | WallRef],
    ) -> Iterator[Way]:
        """Yield the ways in which so many metres lie between edges: at each side of a thing, with each side to a wall."""
        ref = AssetRef(a)
        if isinstance(b, WallRef) and high < math.inf:
            yield from self._ways_off_a_wall(ref, b, low, high, [w for w in to if isinstance(w, WallRef) and w != b])
            return
        if low == 0 and not isinstance(b, WallRef):
            yield (stated("near", ref, b, high),)
            return
        if isinstance(b, AssetRef):
            beds = self._is(a, small.SLEPT_ON) and self._is(b.name, small.SLEPT_ON)  # they stand side by side
            for side in ("left_of", "right_of") if beds else ("left_of", "right_of", "in_front_of", "behind"):
                apart = stated(side, ref, b, low, min(high, ways_of.FAR_APART))
                yield (apart, stated("align_with", ref, b)) if beds else (apart,)
        if high == math.inf:
            longest = sum(max(self._asset(one.name).size[:2]) for one in (ref, b) if isinstance(one, AssetRef))
            yield (stated("distance_constraint", ref, b, round(longest / 2 + low, 3), None),)
        elif isinstance(b, PointRef):
            yield from self._ways_off_an_opening(ref, b, low, high)

    def _ways_off_an_opening(self, ref: AssetRef, point: PointRef, low: float, high: float) -> Iterator[Way]:
        """Yield the ways in which a thing is so many metres off the middle of a door or window, or off another point."""
        openings = ((o.wall, self.room.walls[o.wall].point(o.center)) for o in (*self.room.doors, *self.room.windows))
        walls = [WallRef(wall) for wall, at in openings if math.dist(at, (point.x, point.y)) < ROUNDING]
        for angle, half, _ in self._turns(ref):
            least, most = round(half + low, 3), round(half + high, 3)
            ahead = ((stated("align_with", ref, w, angle), stated("distance_constraint", ref, w, least)) for w in walls)
            yield (stated("distance_constraint", ref, point, least, most), *next(ahead, ()))
        half = self._asset(ref.name).size[1] / 2
        beside = stated("distance_constraint", ref, point, round(half + low, 3), round(half + high, 3))
        yield from ((stated("against_wall", ref, wall), beside) for wall in walls[:1])

    def _ways_off_a_wall(
        self, ref: AssetRef, wall: WallRef, low: float, high: float, others: Sequence[WallRef]
    ) -> Iterator[Way]:
        """Yield the ways in which a thing stands so many metres off a wall, with one of its sides to it; no nearer to others."""
        x, y = self.room.walls[wall.index].normal
        for angle, half, other in self._turns(ref):
            apart = stated("distance_constraint", ref, wall, round(half + low, 3), round(half + high, 3))
            far = list[Relation]()
            for one in others if not self._is(ref.name, small.SLEPT_ON) else ():
                u, v = self.room.walls[one.index].normal
                deep = half if abs(x * u + y * v) > math.sqrt(0.5) else other
                far.append(stated("distance_constraint", ref, one, round(deep + low, 3)))
            yield (stated("align_with", ref, wall, angle), apart, *far)

    def _turns(self, ref: AssetRef) -> Iterator[tuple[float, float, float]]:
        """Yield degrees by which a thing is turned from a wall, and half of how deep it then is before it, and along it, in metres."""
        depth, width, _ = self._asset(ref.name).size
        for angle in (90.0, 270.0, 0.0, 180.0):
            yield (angle, depth / 2, width / 2) if angle in (90.0, 270.0) else (angle, width / 2, depth / 2)

    def _far(self, it: Asked) -> Iterator[Demand]:
        x0, y0, x1, y1 = self.room.bounds
        least = max(ways_of.LEAST_FAR, ways_of.FAR_SHARE * max(x1 - x0, y1 - y0))
        yield from self._off(it, dict.fromkeys(it.subjects, least))

    def _farthest(self, it: Asked) -> Iterator[Demand]:
        """As far from a thing as at least one corner of the room is, wherever that thing stands."""
        x0, y0, x1, y1 = self.room.bounds
        across = {a: math.hypot(x1 - x0, y1 - y0) - math.hypot(*self._asset(a).size[:2]) for a in it.subjects}
        yield from self._off(it, {a: max(ways_of.LEAST_FAR, metres / 2) for a, metres in across.items()})

    def _off(self, it: Asked, least: Mapping[str, float]) -> Iterator[Demand]:
        """Yield that each thing is at least so far from every place and thing that it is said to be far from."""
        to = [(a, point) for a in it.subjects for place in it.places for point in self._points(place)]
        for a, b in (*to, *((a, AssetRef(b)) for a in it.subjects for b in it.others if a != b)):
            yield single(stated("distance_constraint", AssetRef(a), b, round(least[a], 2)))

    def _end_of_a_top(self, side: str, a: str, b: str) -> Demand:
        """At one end of a top, as who sits at it has it on the left or right; at any of both if no side is said."""
        wide, own = self._asset(b).size[1], self._asset(a).size[1]
        off = round(max(min(ways_of.END_OF_A_TOP * wide, (wide - own) / 2), 0.0), 3)
        way, other = ((stated("toward", AssetRef(a), AssetRef(b), end, off),) for end in (side or "left", "right"))
        return Demand((way,), also=() if side else (other,))

    _left_half_each = partialmethod(_end_of_a_top, "right")
    _right_half_each = partialmethod(_end_of_a_top, "left")
    _end_half_each = partialmethod(_end_of_a_top, "")

    def _hangs_over(self, a: str) -> bool:
        """Return whether a thing hangs above an opening where it is said to be: no curtain, which hangs before a window."""
        asset = self._asset(a)
        return asset.on_wall and not asset.on_floor and not category_of(asset).dresses_windows

    def _ways_over(self, a: str, place: Place, many: int) -> Iterator[Way]:
        """Yield the ways in which what hangs on walls is over the middle of a door or window, where the wall goes on there."""
        half, aside = self._asset(a).size[2] / 2, self._asset(a).size[1] * (many - 1) / 2  # "two signs above the door"
        for opening, point in zip(openings_meant(self.room, place), self._points(place), strict=True):
            low, high = opening.sill + opening.height + half, self.room.wall_height - half
            if low + ways_of.OVER[0] < high:
                hung = stated(
                    "mounted_on", AssetRef(a), WallRef(opening.wall), round(min(low + ways_of.OVER[1], high), 2)
                )
                yield (hung, stated("distance_constraint", AssetRef(a), point, None, round(ways_of.OVER[2] + aside, 2)))

    def _lit(self, it: Asked) -> Iterator[Demand]:
        """In daylight: not far from a window."""
        windows = self._points(Place("window"))
        for a in it.subjects if windows else ():
            yield single(*(stated("near", AssetRef(a), point, ways_of.DAYLIGHT) for point in windows))
