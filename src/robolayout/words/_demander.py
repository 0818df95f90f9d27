"""From relations in words to demands: each word of the list has a method that says what it asks for."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from robolayout.constraints import AssetRef, PointRef, Relation, WallRef
from robolayout.constraints.between import BetweenTwo
from robolayout.scene import Scene
from robolayout.words import _ways as ways_of
from robolayout.words._places import AtPlaces, centre, corners_meant, rectangle, walls_meant
from robolayout.words._rows import ToldRows, alike, in_rows, neighbours, on_a_wall
from robolayout.words._said import Link, Mention, Place, Thing, mentions, named, place_in
from robolayout.words.demands import Demand, by_ways, single, stated


class Demander(AtPlaces):
    """Turns links into demands on a scene."""

    def __init__(self, scene: Scene, names: Mapping[Thing, tuple[str, ...]], links: Sequence[Link]) -> None:
        super().__init__(scene)
        self.names = names
        # of these only the first stands where they are put
        self.stacked = {thing for link in links if link.relation == "stacked" for thing in named(link.subjects)}
        self.manned = {  # desks with a seat behind them
            b
            for link in links
            if link.relation == "behind"
            for a, b in self._matched(self._others(link.subjects), link.objects)
            if self._sits_behind(a, b) and self._is(b, ("desk",))
        }
        self.told = ToldRows(scene, [(link, self._others(link.subjects), self._others(link.objects)) for link in links])

    def demands(self, link: Link) -> tuple[Demand, ...]:
        """Return what a link asks for; nothing where it cannot be said."""
        subjects = self._others(link.subjects)
        if link.relation != "stacked":
            piled = {name for thing in self.stacked for name in self.names.get(thing, ())[1:]}
            subjects = [name for name in subjects if name not in piled]
        if link.relation in ("open", "bare"):
            subjects = [asset.name for asset in self.scene.assets if asset.on_floor and not asset.is_flat]
        if not subjects:
            return ()
        if link.relation in ("apart", "bare"):
            return tuple(self._apart(subjects, link.objects, link.metres if any(link.metres) else ways_of.OFF_A_WALL))
        if link.relation in ways_of.ENDS and place_in(link.objects, "room"):
            return tuple(self._at_place(subjects, Place("side", (ways_of.ENDS[link.relation],))))
        at_place = tuple(self._there(link, subjects))
        if link.relation in ways_of.TO_ANOTHER:
            ahead = self._of_rows(subjects, link.objects) if link.relation in ways_of.ENDS else []
            to = mentions(link.objects)
            each = [self._named(item)[:1] for item in to] if len(subjects) == 1 and len(to) > 1 else []
            twos = [(*subjects, *name) for name in each if name] or self._matched(ahead or subjects, link.objects)
            return (*at_place, *(by_ways(self._ways(link.relation, a, b), a, b) for a, b in twos))
        if link.relation in ways_of.IN_A_CHAIN:
            return tuple(self._chained(subjects, link.relation))
        if link.relation in ways_of.BY_TWOS:
            return tuple(self._by_twos(subjects, link.relation))
        if link.relation in ("rows", "columns"):
            return tuple(self._rows(subjects, link))
        make = getattr(self, f"_{link.relation}", None)
        return (*at_place, *(make(subjects, link.objects) if make else ()))

    def _there(self, link: Link, subjects: Sequence[str]) -> Iterator[Demand]:
        """Yield that things stand at the place of the room to which their relation leads, if it does."""
        place = place_in(link.objects) if link.relation in ways_of.AT_PLACES else None
        if place is None:
            return
        if link.relation == "flank" and place.name in ("window", "door") and len(subjects) > 1:
            yield Demand(tuple(self._ways_flanking(subjects, place)))
            return
        on, share = link.relation in ("on", "wall", "hanging"), len(subjects) > 1 and link.relation != "flank"
        share = share or not self.manned.isdisjoint(subjects)  # somebody sits between
        yield from self._at_place(subjects, place, on=on, share=share)

    def _by_twos(self, subjects: Sequence[str], relation: str) -> Iterator[Demand]:
        """Yield what the second of every two is asked to be to the first; or how two rows of them are turned."""
        if self.told.in_rows(subjects):
            yield self.told.block(subjects)
            return
        desks = relation == "mutual" and self._is(subjects[0], ("desk",))  # who sits there looks over its back
        ways = ways_of.BY_TWOS["mutual desks" if desks else relation]
        yield from (by_ways(ways, b, a) for a, b in zip(subjects[::2], subjects[1::2], strict=False))

    def _named(self, mention: Mention) -> tuple[str, ...]:
        names = self.names.get(mention.thing, ())
        return names if mention.pick is None else names[mention.pick] or names[:1]

    def _others(self, objects: Sequence[Mention | Place]) -> list[str]:
        return [name for item in mentions(objects) for name in self._named(item)]

    def _matched(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[tuple[str, str]]:
        """Yield each subject with what it stands to: in equal shares where there are several."""
        others = self._others(objects)
        for i, name in enumerate(subjects):
            if others:
                other = others[i * len(others) // len(subjects)] if len(subjects) >= len(others) else others[i]
                if other != name:
                    yield name, other

    def _of_rows(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> list[str]:
        """Return the middle one of straight rows that all look at one thing, or stand before it."""
        rows = len(subjects) > 2 and self.told.in_rows(subjects) and len(self._others(objects)) < 2
        return [subjects[self.told.abreast[subjects[0]] // 2]] if rows else []

    def _on(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        for a, b in self._matched(subjects, objects):
            yield self._resting(a, b)

    _in = _on

    def _resting(self, a: str, b: str) -> Demand:
        """Return that a thing rests on another: a rug lies below what stands on it."""
        if self._asset(b).is_flat:
            return single(stated("under", AssetRef(b), (AssetRef(a),)))
        hung = self._asset(a).on_wall and not self._asset(a).on_object
        return single(stated("above" if hung else "on_top_of", AssetRef(a), AssetRef(b)))

    def _with(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """What a thing has: on it, if it can stand nowhere else, else at it."""
        for a, b in self._matched(subjects, objects):
            asset = self._asset(a)
            beside = asset.on_floor or self._is(b, ways_of.SLEPT_ON)
            if asset.on_object and (not beside or self._is(b, ways_of.TOPS)):
                yield self._resting(a, b)
            elif self._is(a, ways_of.SEATS) and self._is(b, ("desk", "counter", "island")):
                yield by_ways(ways_of.AT_A_DESK, a, b)
            elif beside or asset.on_wall:
                yield single(stated("near", AssetRef(a), AssetRef(b), ways_of.BESIDE if beside else ways_of.NEAR))

    def _far(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        x0, y0, x1, y1 = self.room.bounds
        least = round(max(ways_of.LEAST_FAR, ways_of.FAR_SHARE * max(x1 - x0, y1 - y0)), 2)
        place = place_in(objects)
        points = self._points(place) if place is not None else []
        to = [(a, point) for a in subjects for point in points]
        for a, b in (*to, *((a, AssetRef(b)) for a, b in self._matched(subjects, objects))):
            yield single(stated("distance_constraint", AssetRef(a), b, least))

    def _apart(
        self, subjects: Sequence[str], objects: Sequence[Mention | Place], metres: tuple[float, float]
    ) -> Iterator[Demand]:
        """So many metres between the edges of two things, or of a thing and a place; "at least" holds for each such place."""
        place = place_in(objects)
        twos = list(self._matched(subjects, objects)) if objects else list(pairwise(subjects))
        for a, b in twos:
            yield single(self._gap(a, AssetRef(b), *metres))
        if place is None:
            return
        for a in subjects:
            walls = place.name == "wall"
            points = [WallRef(wall.index) for wall in walls_meant(self.room, place)] if walls else self._points(place)
            gaps = [self._gap(a, point, *metres) for point in points]
            if metres[1] == math.inf:
                yield from map(single, gaps)
            elif gaps:
                yield Demand(tuple((gap,) for gap in gaps))

    def _gap(self, a: str, b: AssetRef | PointRef | WallRef, low: float, high: float) -> Relation:
        """Return that so many metres lie between edges: whichever of their sides these are, or surely on all of them."""
        sides = [self._asset(ref.name).size[:2] for ref in (AssetRef(a), b) if isinstance(ref, AssetRef)]
        short, long = (sum(pick(side) for side in sides) / 2 for pick in (min, max))
        if low == 0 and not isinstance(b, WallRef):
            return stated("near", AssetRef(a), b, high)
        bounds = (low + long, None) if high == math.inf else (low + short, high + long)
        return stated("distance_constraint", AssetRef(a), b, *bounds)

    def _flank(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """Left and right of a thing, in turn."""
        by: dict[str, list[str]] = {}
        for a, b in self._matched(subjects, objects):
            if self._is(b, ways_of.BEARING) and self._asset(a).on_object and not self._asset(a).on_floor:
                yield self._resting(a, b)
            else:
                by.setdefault(b, []).append(a)
        for b, items in by.items():
            ways = [[("left", "right")[(i + first) % 2] for i in range(len(items))] for first in (0, 1)]
            gap = ways_of.BESIDE if len(items) < 3 else ways_of.BESIDE * len(items)
            sided = ([*zip(items, way, strict=True)] for way in ways)
            yield Demand(tuple(tuple(stated("next_to", AssetRef(a), AssetRef(b), s, gap) for a, s in w) for w in sided))

    def _otherside(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """On the other side of the first of some things than the rest of them."""
        b, *there = self._others(objects)
        sides = ("left_of", "right_of"), ("in_front_of", "behind")
        ways = [
            tuple(stated(side, AssetRef(a), AssetRef(b), 0.0, ways_of.NEAR) for side, a in both)
            for one, other in (*sides, *(pair[::-1] for pair in sides))
            for both in [[*((one, a) for a in subjects), *((other, a) for a in there)]]
        ]
        yield Demand(tuple(ways))

    def _behind(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """Behind a thing; who sits behind a desk sits at the side from which it is used."""
        for a, b in self._matched(subjects, objects):
            gap = ways_of.BACK_WALL if self._only_wall(a) else ways_of.BACK  # "on the wall behind the counter"
            ways = [(stated("behind", AssetRef(a), AssetRef(b), 0.0, gap),)]
            if self._sits_behind(a, b):
                ways = [(stated("in_front_of", AssetRef(a), AssetRef(b), 0.0, ways_of.BACK),), *ways]
                ways = ways[:1] if b in self.manned else ways
            yield Demand(tuple(ways))

    def _sits_behind(self, a: str, b: str) -> bool:
        """Return whether who sits on a thing that is behind another uses that from there."""
        return self._is(a, ways_of.SEATS) and self._is(b, ("desk", "counter")) and not self._is(b, ("reception desk",))

    def _ways(self, relation: str, a: str, b: str) -> ways_of.Ways:
        """Return what a relation asks for; before a desk behind which somebody sits is the other side of it, where one looks at it."""
        if relation != "front" or b not in self.manned:
            return ways_of.TO_ANOTHER[relation]
        return (ways_of.ACROSS_A_DESK[0 if self._is(a, ways_of.SEATS) else 1],)

    def _around(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        for a, b in self._matched(subjects, objects):
            gap = ways_of.NEAR if self._is(a, ("armchair", "sofa", "bag")) else ways_of.BESIDE
            near = stated("near", AssetRef(a), AssetRef(b), gap)
            turns = not self._asset(a).is_flat and self._is(a, ways_of.SEATS)
            yield Demand(((near, stated("point_towards", AssetRef(a), AssetRef(b))) if turns else (near,),))

    def _opposite(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        place = place_in(objects)
        if place is not None and place.name == "room":
            yield from self._at_place(subjects, Place("side", ("far",)))
        elif place is not None:
            yield from self._facing(subjects, [place])
        for a, b in self._matched(subjects, objects):
            yield single(stated("in_front_of", AssetRef(a), AssetRef(b), 0.0, ways_of.ACROSS))

    def _facing(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """Looking at a thing, a door or a window; a desk faces what one sees who sits at it."""
        place = place_in(objects)
        others = self._others(objects)
        if one := self._of_rows(subjects, objects):  # the others look as it does
            yield Demand((tuple(stated("align_with", AssetRef(a), AssetRef(*one)) for a in subjects if a not in one),))
            subjects = one
        for i, a in enumerate(subjects):
            points = self._points(place) if place is not None else []
            targets = [AssetRef(b) for b in others if b != a] if others else points
            if len(others) == len(subjects):
                targets = [AssetRef(others[i])]
            angles = (180.0, 0.0) if self._is(a, ("desk", "table")) else (0.0,)
            angles = angles[:1] if a in self.manned else angles
            ways = [(stated("point_towards", AssetRef(a), b, angle),) for b in targets for angle in angles]
            if len(others) == len(subjects) > 1 and self._is(a, ways_of.SEATS) and self._is(others[i], ("mirror",)):
                ways = [(*way, stated("in_front_of", AssetRef(a), AssetRef(others[i]), *ways_of.INTO)) for way in ways]
            if ways:
                yield Demand(tuple(ways))

    def _turnedfrom(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """Looking away from a thing, a wall, a door or a window; a desk as one does who sits at it."""
        place = place_in(objects)
        for a in subjects:
            points = [*map(AssetRef, self._others(objects)), *(self._points(place) if place is not None else ())]
            angle = 0.0 if self._is(a, ("desk", "table")) else 180.0
            yield from (single(stated("point_towards", AssetRef(a), point, angle)) for point in points)

    def _diagonal(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """Turned by an eighth or three eighths from a wall."""
        for a in subjects:
            angles = (45.0, 135.0, 225.0, 315.0)
            yield Demand(tuple((stated("align_with", AssetRef(a), WallRef(0), angle),) for angle in angles))

    def _mirrored(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        others = self._others(objects)
        for a, b in zip(subjects[::2], subjects[1::2], strict=False):
            yield from [single(stated("symmetric_pair", AssetRef(a), AssetRef(b), AssetRef(c))) for c in others[:1]]

    def _lit(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """In daylight: not far from a window."""
        for a in subjects:
            ways = [(stated("near", AssetRef(a), point, ways_of.DAYLIGHT),) for point in self._points(Place("window"))]
            yield from [Demand(tuple(ways))] if ways else []

    def _open(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """The middle of the room stays free: each thing stands in one of the four strips around it."""
        x0, y0, x1, y1 = self.room.bounds
        x, y = centre(self.room)
        half = max(ways_of.LEAST_MIDDLE, ways_of.OPEN_SHARE * min(x1 - x0, y1 - y0))
        strips = ((x0, y0, x - half, y1), (x + half, y0, x1, y1), (x0, y0, x1, y - half), (x0, y + half, x1, y1))
        for a in subjects:
            yield Demand(tuple((stated("zone", AssetRef(a), rectangle(*strip)),) for strip in strips))

    def _row(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """Side by side: alike things in one line, others each at a side of the one before, turned the same way."""
        if alike(self.scene, subjects) and not self.told.flanked & {*subjects}:
            yield in_rows(subjects, 1)
            return
        if not any(self._asset(a).on_floor for a in subjects):
            yield from self._huddle(subjects, objects)
        for before, a in pairwise(subjects):
            if self._asset(a).on_floor:
                yield by_ways(((("next_to", "beside", ways_of.BACK), ("align_with",)),), a, before)

    def _chained(self, subjects: Sequence[str], relation: str) -> Iterator[Demand]:
        """Each to the one before it; mats side by side are a row, which nothing else keeps from lying on each other."""
        if relation == "abreast" and alike(self.scene, subjects) and self._asset(subjects[0]).is_flat:
            yield in_rows(subjects, 1)
            return
        if relation == "stacked" and all(map(self._only_wall, subjects)):
            relation = "tiered"  # pictures on top of each other
        apart = relation == "abreast" and self.told.flanked & {*subjects}
        ways = ways_of.IN_A_CHAIN["abreast apart" if apart else relation]
        yield from (by_ways(ways, b, a) for a, b in pairwise(subjects))

    def _rows(self, subjects: Sequence[str], link: Link) -> Iterator[Demand]:
        """Like things stand in a block, in so many rows if that is said; others near each other."""
        if not alike(self.scene, subjects):
            yield from self._huddle(subjects, link.objects)
            return
        yield self.told.block(subjects)

    def _huddle(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """Each near another one; what hangs on walls, on one of them."""
        if all(map(self._only_wall, subjects)):
            yield from on_a_wall(subjects, self.room)
            return
        for number, a in enumerate(subjects[1:], 1):
            beside = [*reversed(subjects[:number]), *subjects[number + 1 :]]
            if self._asset(a).on_floor or not self._asset(a).on_object:
                yield Demand(tuple((stated("near", AssetRef(a), AssetRef(b), ways_of.BACK),) for b in beside))

    def _seen(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        others = self._others(objects)
        for i, b in enumerate(others):  # "visible from the bed and from the sofa"
            yield single(stated("point_towards", AssetRef(b), AssetRef(subjects[i * len(subjects) // len(others)])))

    def _under(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """A rug below others; furniture below a window, a picture, a lamp; what stands on the floor cannot stand inside another."""
        others = self._others(objects)
        for a in subjects:
            if self._asset(a).is_flat and others:
                yield single(stated("under", AssetRef(a), tuple(AssetRef(b) for b in others if b != a)))
        for a, b in self._matched(subjects, objects):
            below = self._asset(b).on_wall or self._asset(b).on_ceiling
            if below and not self._asset(b).on_floor:
                yield single(stated("above", AssetRef(b), AssetRef(a)))
            elif not self._asset(a).is_flat:
                yield single(stated("near", AssetRef(a), AssetRef(b), ways_of.AT_TABLE))

    def _above(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """Over a thing, on the wall where it hangs there, or on it."""
        for a, b in self._matched(subjects, objects):
            ways, asset = [(stated("above", AssetRef(a), AssetRef(b)),)], self._asset(a)
            if asset.on_object:
                hung = [(stated("mounted_on", AssetRef(a)), *ways[0])] if asset.on_wall else ways
                ways = [*hung, (stated("on_top_of", AssetRef(a), AssetRef(b)),)]
            yield Demand(tuple(ways))

    def _amid(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        """Between two things, or a thing and a place: near both, and on the line between them."""
        ends: list[AssetRef | PointRef] = [AssetRef(name) for name in self._others(objects) if name not in subjects]
        place = place_in(objects)
        ends += self._points(place)[: 1 + place.plural] if place is not None else []
        for a in subjects if len(ends) > 1 else ():
            wide = self.told.abreast.get(self._others(objects)[0], 0) if place is None else 0
            across = ends[wide // 2 :: wide] if wide and len(ends) > 2 else ends  # between two rows
            groups = [self._named(item) for item in mentions(objects)]
            if not wide and len(groups) == 2 and len(ends) > 2:  # "between the sinks and the shower"
                across = [AssetRef(groups[0][-1]), AssetRef(groups[1][0])]
            pairs = [(across[0], across[1])] if len(across) == 2 else neighbours(ends, len(subjects))
            one, two = pairs[subjects.index(a) % len(pairs)]
            near = tuple(stated("near", AssetRef(a), end, self._within(a, end)) for end in (one, two))
            yield Demand((near,), BetweenTwo(AssetRef(a), one, two))

    def _within(self, a: str, end: AssetRef | PointRef) -> float:
        """Return how far from an end a thing between two stands: what is narrower than itself flanks it."""
        if isinstance(end, AssetRef) and end.name not in self.told.abreast:
            return ways_of.BESIDE if self._asset(end.name).size[1] < self._asset(a).size[1] else ways_of.AHEAD
        return ways_of.AHEAD

    def _corner(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        yield from self._at_place(subjects, Place("corner"))

    def _middle(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        if wall := place_in(objects, "wall"):
            yield from self._at_place(subjects, replace(wall, words=(*wall.words, "middle")))
            return
        for a, b in self._matched(subjects, objects):
            on = self._asset(a).on_object or self._asset(b).is_flat
            yield self._resting(a, b) if on else single(stated("near", AssetRef(a), AssetRef(b), ways_of.BESIDE))
        if not self._others(objects):
            yield from self._at_place(subjects, Place("middle"), share=len(subjects) > 1)

    def _at_place(
        self, subjects: Sequence[str], place: Place, *, on: bool = False, share: bool = False
    ) -> Iterator[Demand]:
        """Yield that things stand at a place of the room; where several share it, each somewhat farther from its middle."""
        together = "same" in place.words or (place.plural and "opposite" in place.words)
        corners = corners_meant(self.room, place) if place.name == "corner" else []
        if place.name == "wall" and together and len(subjects) > 1 and "middle" not in place.words:
            half = (len(subjects) + 1) // 2  # at one wall, or one half at each of two
            yield Demand(tuple(self._at_walls(subjects[half:], subjects[:half], place, on=on)))
        elif len(corners) == len(subjects) > 1:
            yield from (single(stated("corner", AssetRef(a), i)) for a, i in zip(subjects, corners, strict=True))
        else:
            found = (tuple(self._ways_at(a, place, on=on, share=share)) for a in subjects)
            yield from (Demand(ways) for ways in found if ways)

    def _atwalls(self, subjects: Sequence[str], objects: Sequence[Mention | Place]) -> Iterator[Demand]:
        place = place_in(objects)
        if place is not None:
            yield Demand(tuple(self._at_walls(subjects, self._others(objects), place, on=True)))
