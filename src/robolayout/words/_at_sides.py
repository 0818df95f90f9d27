"""What stands on one side of a thing or under it: any side, the other one, all seats at one side of a table, so far off it."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import replace
from functools import partialmethod
from itertools import pairwise

from robolayout.assets import category_of
from robolayout.assets.beneath import places_beneath
from robolayout.constraints import AssetRef, PointRef, Relation, WallRef
from robolayout.constraints.around import Around
from robolayout.scene import Room, Wall
from robolayout.words import _function_words as small
from robolayout.words import _ways as ways_of
from robolayout.words._gaps import HowFar
from robolayout.words._places import Asked
from robolayout.words._rows import alike
from robolayout.words._said import Link, Place, place_in
from robolayout.words._walls import COMPASS, openings_meant, opposed, walls_meant
from robolayout.words.demands import Demand, FreeDisc, Way, by_ways, single, stated

SIDE_RELATIONS = {"front": "in_front_of", "left": "left_of", "back": "behind", "right": "right_of"}
"""How something is to another thing that is at one of its sides."""

SIDES_OF_A_LOUNGE = ("behind", "left_of", "right_of", "in_front_of")
"""Sides of a low table at which sofas stand that are around it, in their order."""


def on_walls_beside(asked: Iterable[tuple[Link, Asked]]) -> dict[tuple[str, str], tuple[float, float]]:
    """Return how far things are from others at whose side their wall is: "on the wall to the right of the bed"."""
    found: dict[tuple[str, str], tuple[float, float]] = {}
    for (at, it), (side, to) in pairwise(asked):
        named_by = side.relation in ("left", "right", "behind") and side.start - at.end <= len(("the", "wall"))
        if named_by and place_in(at.objects, "wall") and list(it.subjects) == list(to.subjects):
            found |= dict.fromkeys(to.twos, (0.0, ways_of.LOOKING if side.relation == "behind" else ways_of.ACROSS))
    return found


LOOKS_ALONG = {"left": 180.0, "right": 0.0}
"""Degrees by which what is on one side of a door is turned from its wall to look at who comes in there."""


def beside_doors(asked: Iterable[tuple[Link, Asked]]) -> dict[str, float]:
    """Return what is asked to the left or right of a door, with how it is turned from its wall to look there."""
    there = [(LOOKS_ALONG[link.relation], it) for link, it in asked if link.relation in LOOKS_ALONG]
    return {a: turn for turn, it in there if place_in(it.places, "door") for a in it.subjects}


def by_doors(asked: Iterable[tuple[Link, Asked]]) -> dict[str, Place]:
    """Return what is asked to be near a door, with which one."""
    doors = ((it.subjects, it.place) for link, it in asked if link.relation in small.NEARBY and it.place)
    return {name: place for names, place in doors if place.name == "door" for name in names}


def parted(asked: Iterable[tuple[Link, Asked]]) -> frozenset[str]:
    """Return what is asked to opposite walls: what is between that may be far from both."""
    walls = ((it.subjects, it.place) for _, it in asked if it.place is not None and it.place.name == "wall")
    return frozenset(name for names, at in walls if at.plural and "opposite" in at.words for name in names)


def _looks(normal: tuple[float, float]) -> dict[str, tuple[float, float]]:
    """Return whither the sides of a thing look that has its back to a wall with a normal."""
    x, y = normal
    return {"front": (x, y), "left": (-y, x), "back": (-x, -y), "right": (y, -x)}


def on_one_wall(asked: Iterable[tuple[Link, Asked]], room: Room) -> dict[str, int]:
    """Return what is asked to be on a wall that is told from the others, with the number of that wall."""
    walls = ((it.subjects, walls_meant(room, it.place)) for _, it in asked if it.place and it.place.name == "wall")
    return {name: told[0].index for names, told in walls if len(told) == 1 for name in names}


def lit_between(asked: Iterable[tuple[Link, Asked]]) -> frozenset[str]:
    """Return what has between it and others what is asked to be at a window."""
    lit = {name for _, it in asked if it.place is not None and it.place.name == "window" for name in it.subjects}
    return frozenset(b for link, it in asked if link.relation == "amid" and lit & {*it.subjects} for b in it.others)


def in_corners(asked: Iterable[tuple[Link, Asked]]) -> dict[str, str]:
    """Return what is asked to be in a corner, with what is across from it: "a bed in one corner, a desk in the opposite one"."""
    found = dict[str, str]()
    for subjects, place in ((it.subjects, it.place) for _, it in asked if it.place is not None):
        across = place.name == "corner" and "opposite" in place.words
        if across and place.plural and len(subjects) == 2:  # "two plants in opposite corners"
            found |= {subjects[0]: "", subjects[1]: subjects[0]}
        elif place.name == "corner":
            found |= dict.fromkeys(subjects, next(reversed(found), "") if across else "")
    return found


class AtSides(HowFar):
    """Says what it asks for to be at a side of a thing."""

    opposed: Sequence[tuple[str, str]]
    """Each two that are asked to face each other."""

    put: Set[str]
    beside: Mapping[str, float]
    """What is beside a door, with how it is turned from its wall to look there."""

    lounging: Mapping[str, tuple[str, tuple[float, float]]]
    """Several sofas, with armchairs, that are around a low table: at which side of it, and how far from it, each is."""

    parted: frozenset[str]
    """What is asked to opposite walls."""

    hung: Mapping[str, int]
    """What is asked onto one wall, with its number."""

    near_doors: Mapping[str, Place]
    """What is asked to be near a door, with which one."""

    def _cleared(self, subjects: Sequence[str], place: str, metres: float) -> Iterator[Demand]:
        """Yield that so much floor, or what the body needs, is free at one of some sides of things: no thing stands there, and no wall."""
        free, sides = metres or round(2 * self.scene.agents[0].radius, 2), place.split(" or ")
        for a in (a for a in subjects if self._asset(a).on_floor):
            besides = tuple(map(AssetRef, self._at_home_at(a)))
            clear = [stated("keep_clear", AssetRef(a), side, free, besides) for side in sides]
            ways = [[*self._off_walls(a, side, free)] for side in sides]
            if len(sides) > 1:
                yield Demand(tuple((one, *way) for one, off in zip(clear, ways, strict=True) for way in off))
            else:
                yield from (single(*clear), Demand(tuple(ways[0])))

    def _at_home_at(self, a: str) -> Iterator[str]:
        """Yield what stands at a thing though the floor there is asked to be free: night stands by a bed, chairs at a table or desk."""
        bed = self._is(a, ("bed",))
        for one in self.scene.assets if bed or self._is(a, ("table", "desk")) else ():
            seat = category_of(one).movable and self._is(one.name, small.SEATS)
            if one.on_floor and one.name != a and (self._is(one.name, ("night stand",)) if bed else seat):
                yield one.name

    def _under(self, it: Asked) -> Iterator[Demand]:
        """A rug below others."""
        for a in it.subjects if it.others else ():
            if self._asset(a).is_flat:
                yield single(stated("under", AssetRef(a), tuple(AssetRef(b) for b in it.others if b != a)))

    def _under_each(self, a: str, b: str) -> Demand | None:
        """Furniture below a window, a picture, a lamp; what stands on the floor below what has room for it, near what has none."""
        below = self._asset(b).on_wall or self._asset(b).on_ceiling
        if below and not self._asset(b).on_floor:
            at = [stated("against_wall", AssetRef(a), WallRef(self.hung[b]))] if b in self.hung else []
            at += [stated("near", AssetRef(a), to, ways_of.AT_DOOR) for to in self._points(self.near_doors.get(b))[:1]]
            return Demand(((stated("above", AssetRef(b), AssetRef(a)), *at * self._asset(a).on_floor),))
        if self._asset(a).is_flat:
            return None
        near = stated("near", AssetRef(a), AssetRef(b), ways_of.AT_TABLE)
        if self._is(a, small.SEATS) or not (self._asset(a).on_floor and self._asset(b).on_floor):
            return single(near)
        under = stated("under", AssetRef(a), (AssetRef(b),))
        return Demand(((under,) if places_beneath(self._asset(b), self._asset(a)) else (under, near),))

    def _the_other_way_round(self, it: Asked, relation: str) -> tuple[Asked, str]:
        """Return what a relation asks, of several under one thing that hangs as of that over them: "beds under a picture"."""
        if relation in ("by", "near") and it.others and all(self._is(b, ("fireplace",)) for b in it.others):
            return it, "fireside"
        if relation != "under" or len(it.others) != 1 or len(it.subjects) < 2 or not self._only_wall(it.others[0]):
            return it, relation
        return replace(it, subjects=it.others, groups=[it.subjects]), "above"

    def _above(self, it: Asked) -> Iterator[Demand]:
        """Over a thing, on the wall where it hangs there, or on it; one thing over the middle of several, else over one of them.

        What hangs over a thing that is too narrow for all of them hangs in rows, one over the other.
        """
        if len(it.subjects) == 1 and len(it.others) > 1 and not self._asset(it.subjects[0]).on_object:
            over = tuple(stated("above", AssetRef(it.subjects[0]), AssetRef(b)) for b in it.others)
            yield Demand((over, *((one,) for one in over)))
            return
        hung, many = dict[str, list[str]](), Counter(b for _, b in it.twos)
        for a, b in it.twos:
            if self._only_wall(a) and b in self.surrounded and self._is(b, ("table",)):  # on the wall by its seats
                near = stated("near", AssetRef(a), AssetRef(b), ways_of.NEAR)
                yield Demand(((stated("mounted_on", AssetRef(a)), near),))
                continue
            row, fit = hung.setdefault(b, []), many[b]
            if self._only_wall(a):
                rows = math.ceil(many[b] / math.ceil(self._asset(b).size[1] / self._asset(a).size[1]))
                fit = math.ceil(many[b] / rows)
            below = row[-fit] if len(row) >= fit else b
            row.append(a)
            above, on_top = (stated(how, AssetRef(a), AssetRef(below)) for how in ("above", "on_top_of"))
            at_wall = (stated("mounted_on", AssetRef(a)),) if self._asset(a).on_wall else ()
            yield Demand(((*at_wall, above), (on_top,))) if self._asset(a).on_object else single(above)

    def _aloft(self, it: Asked) -> Iterator[Demand]:
        """Hung on a wall, its middle so many metres above the floor, or its lower edge: what is told of is that share of its height up."""
        height, share = it.metres
        for a in it.subjects:
            if self._asset(a).on_wall:
                middle = round(height + (0.5 - share) * self._asset(a).size[2], 3)
                yield single(stated("mounted_on", AssetRef(a), None, middle))

    def _across_a_top(self, b: str, items: Sequence[str], sided: str) -> Iterator[Way]:
        """Yield how two who sit at a table or desk look at each other over it: who has a manicure, and who gives it."""
        sat_at = sided and self._is(b, ("table", "desk", "lab bench")) and not self._is(b, tuple(small.LOW_TABLES))
        if len(items) == 2 and sat_at and all(self._is(a, small.SEATS) for a in items):
            for order in (items, items[::-1]):
                yield from self._in_shares(b, order, sided)

    def _turning(self, it: Asked) -> Iterator[Demand]:
        """A free disc on which the body turns: before one of the larger things, or all around the middle of the room."""
        wide, near = it.metres[0], tuple(self._points(it.place))
        within = max(ways_of.LEAST_MIDDLE, wide / 2) if near else 0.0
        disc = FreeDisc(wide, near, within)
        if it.place is not None and it.place.name in ("middle", "room"):
            x0, y0, x1, y1 = self.room.bounds
            turned = wide <= ways_of.TURNED_IN  # no "3 x 3 m free area in the middle"
            spare = min(x1 - x0, y1 - y0) / 2 - ways_of.DEEP  # the disc may be aside where the room is small
            half = min(max(ways_of.LEAST_DISC * wide, spare), wide / 2) if turned else wide / 2
            around = self._open(replace(it, metres=(half, half)))
            yield from (replace(demand, exact=disc if turned else None) for demand in around)
        fronts = sorted(it.subjects, key=lambda a: -self._asset(a).size[1])
        ways = tuple((stated("keep_clear", AssetRef(a), "front", wide),) for a in fronts)
        yield Demand(ways, disc)

    def _not_turned(self, it: Asked, back: float) -> Iterator[Demand]:
        """Not looking at a thing, a wall, or the wall of a door or window, or not with its back to it: turned by a right angle or two."""
        for a in it.subjects:
            looks = self._looks(a)[0] + back
            yield from (
                single(
                    *(stated("point_towards", AssetRef(a), AssetRef(b), angle) for angle in (90.0, 180.0 - back, 270.0))
                )
                for b in it.others
            )
            walls = [wall for place in it.places for wall in self._walls_at(place)]
            for wall in walls[:1]:
                (dx, dy), (nx, ny) = wall.direction, wall.normal
                square = {0.0: (dx, dy), 90.0: (nx, ny), 180.0: (-dx, -dy), 270.0: (-nx, -ny)}
                to = ((angle, square[(angle + looks) % 360.0]) for angle in square)
                free = [angle for angle, way in to if not any(opposed(one.normal, way) for one in walls)]
                if free:
                    yield single(*(stated("align_with", AssetRef(a), WallRef(wall.index), angle) for angle in free))

    _averted = partialmethod(_not_turned, back=0.0)
    _faced = partialmethod(_not_turned, back=180.0)

    def _walls_at(self, place: Place) -> list[Wall]:
        """Return the walls that a place is or is in."""
        if place.name in ("door", "window"):
            return [self.room.walls[opening.wall] for opening in openings_meant(self.room, place)]
        return walls_meant(self.room, place) if place.name == "wall" else []

    def _off_walls(self, a: str, side: str, metres: float) -> Iterator[Way]:
        """Yield the ways in which a side of a thing, which stands at a wall or free, is so far from the wall that it looks at."""
        half = self._asset(a).size[side in ("left", "right")] / 2
        for wall in self.room.walls:  # at its back
            ahead = [one for one in self.room.walls if opposed(one.normal, _looks(wall.normal)[side])]
            far = (stated("distance_constraint", AssetRef(a), WallRef(w.index), round(half + metres, 3)) for w in ahead)
            yield (stated("align_with", AssetRef(a), WallRef(wall.index), 90.0), *far)

    def _seated_around(self, names: Iterable[str]) -> set[str]:
        """Return which of some tables have more usual chairs than sit at two sides of them."""
        every = [one.name for one in self.scene.assets]
        tables = [name for name in every if self._is(name, ("table",)) and not self._is(name, small.LOW_TABLES)]
        chairs = sum(self._is(name, ("chair",)) for name in every)
        return {*names}.intersection(tables) if chairs > 3 * len(tables) else set()

    def _front(self, it: Asked) -> tuple[Demand, ...]:
        """A shape before something is open to it; two that face each other before a fireplace stand on both sides of its middle."""
        if {*it.subjects} <= {*self.told.shape}:
            return tuple(self.told.opening(it.subjects, [AssetRef(b) for b in it.others]))
        if all(self._is(a, small.WATCHED) for a in it.subjects) and all(self._is(b, small.SEATS) for b in it.others):
            return tuple(by_ways(ways_of.OPPOSITE, a, b) for a, b in it.twos)  # a television in front of the sofa
        pairs = [two for two in self.opposed if {*two} <= {*it.subjects}]
        if len(it.others) != 1 or 2 * len(pairs) != len(it.subjects) or not self._is(it.others[0], small.WATCHED):
            return ()
        (b,) = map(AssetRef, it.others)
        return tuple(
            single(stated(*one))
            for first, second in (map(AssetRef, two) for two in pairs)
            for one in (("symmetric_pair", first, second, b), ("near", first, b, ways_of.LOOKING))
        )

    def _fireside(self, it: Asked) -> Iterator[Demand]:
        """By a fire: two like seats before it, facing each other; others beside it or where one sees it."""
        pair = len(it.subjects) == 2 and alike(self.scene, it.subjects) and self._is(it.subjects[0], small.SEATS)
        if pair and len(it.others) == 1:
            one, two, fire = (AssetRef(name) for name in (*it.subjects, *it.others))
            yield single(stated("symmetric_pair", one, two, fire))
            yield single(stated("near", one, fire, ways_of.AHEAD))
            yield single(stated("facing_pair", one, two))
            return
        for a, b in it.twos:
            yield by_ways(ways_of.BY_A_FIRE if self._is(a, small.SEATS) else ways_of.TO_ANOTHER["by"], a, b)

    def _lounging(self, around: Iterable[Asked]) -> dict[str, tuple[str, tuple[float, float]]]:
        """Return at which side of what they are around, and how far from it, sofas and their armchairs are: in a U, or all round."""
        found = dict[str, tuple[str, tuple[float, float]]]()
        for it in around:
            sofas, armchairs = ([a for a in it.subjects if self._is(a, (head,))] for head in ("sofa", "armchair"))
            seats = [*sofas, *armchairs]
            if len(sofas) > 1 and len(seats) <= len(SIDES_OF_A_LOUNGE) and len(it.others) == 1:
                gaps = ways_of.AT_A_LOUNGE if len(seats) < len(SIDES_OF_A_LOUNGE) else ways_of.AROUND_A_LOUNGE
                across = any({*two} <= {*sofas[:2]} for two in self.opposed)
                sides = sorted(SIDES_OF_A_LOUNGE, key=lambda side: side in ("left_of", "right_of") if across else 0)
                found |= {a: (side, gaps) for a, side in zip(seats, sides, strict=False)}
        return found

    def _around(self, it: Asked) -> Iterator[Demand]:
        """At the sides of a table that are told, else somewhere around each: chairs not all at one side."""
        if it.sided and all(self._is(b, small.BEARING) for b in it.others):
            yield from self._sided(it)
            return
        chairs = [a for a in it.subjects if self._is(a, ("chair",)) and not self._is(a, ("armchair",))]
        at = {b: [AssetRef(a) for a, to in it.twos if to == b and a in chairs] for b in it.others}
        for a, b in it.twos:
            whole = at[b][2:] and at[b][-1].name == a and self._is(b, ("table",)) and a not in self.lounging
            demand = self._seat_around(a, b)
            yield replace(demand, exact=Around(tuple(at[b]), AssetRef(b))) if whole else demand

    def _seat_around(self, a: str, b: str) -> Demand:
        """Near it and turned to it; several sofas each at a side of their table: in an L, a U or all round."""
        if self._is(b, small.WATCHED) and self._is(a, small.SEATS):
            return by_ways(ways_of.AROUND_WATCHED, a, b)
        if a in self.lounging:
            side, gaps = self.lounging[a]
            return Demand((self._at_side(side, [a], b, gaps),))
        gap = ways_of.NEAR if self._is(a, ("armchair", "sofa", "bag")) else ways_of.BESIDE
        near = stated("near", AssetRef(a), AssetRef(b), gap)
        turns = not self._asset(a).is_flat and self._is(a, small.SEATS)
        return Demand(((near, stated("point_towards", AssetRef(a), AssetRef(b))) if turns else (near,),))

    def _oneside(self, it: Asked) -> Iterator[Demand]:
        """At a side of a thing, whichever; seats all at one side of a table, the longer ones first."""
        seats = all(self._is(a, small.SEATS) for a in it.subjects)
        if not (seats and len(it.others) == 1 and self._is(it.others[0], small.BEARING)):
            yield from (single(stated("near", AssetRef(a), AssetRef(b), ways_of.BESIDE)) for a, b in it.twos)
            return
        (b,) = it.others
        yield Demand(tuple(self._at_side(side, it.subjects, b) for side, _ in self._sides_of(b, it.sided)))

    def _otherside(self, it: Asked) -> Iterator[Demand]:
        """On the other side of the first of some things than the rest of them."""
        holders = it.groups[0] if it.groups and len(it.subjects) % len(it.groups[0]) == 0 else it.others[:1]
        there = [name for name in it.others if name not in holders]
        for i, b in enumerate(holders):  # "four desks, each with a chair on one side and a stool on the other"
            own, rest = it.subjects[i :: len(holders)], there[i :: len(holders)]
            sides = self._sides_of(b)
            yield Demand(tuple((*self._at_side(one, own, b), *self._at_side(other, rest, b)) for one, other in sides))

    def _towards(self, way: str, a: str, b: str) -> Demand | None:
        """Return that one thing is north, or so, of another, which may stand with its back to any wall."""
        found = dict[tuple[float, float], Way]()
        for wall in self.room.walls:
            back = stated("align_with", AssetRef(b), WallRef(wall.index), 90.0)
            for side, to in _looks(wall.normal).items():
                if opposed(COMPASS[way], to):  # as the wall there looks inward
                    at = stated(SIDE_RELATIONS[side], AssetRef(a), AssetRef(b), 0.0, ways_of.NEAR)
                    found.setdefault(wall.normal, (back, at))
        return Demand(tuple(found.values())) if found else None

    _northwards_each = partialmethod(_towards, "north")
    _southwards_each = partialmethod(_towards, "south")
    _eastwards_each = partialmethod(_towards, "east")
    _westwards_each = partialmethod(_towards, "west")

    def _outside(self, it: Asked) -> Demand:
        """Half of some things at one end of a row, half at the other: which end is which, the row tells."""
        half, ends = -(-len(it.subjects) // 2), (it.others[0], it.others[-1])
        ways = list[Way]()
        for left, right in (ends, ends[::-1]):
            at = [("left", a, left) for a in it.subjects[:half]] + [("right", a, right) for a in it.subjects[half:]]
            ways.append(tuple(stated("next_to", AssetRef(a), AssetRef(b), s, ways_of.BESIDE) for s, a, b in at))
        return Demand(tuple(ways))

    def _mirrored(self, it: Asked) -> Iterator[Demand]:
        """Each two as mirror images about a thing."""
        for a, b in zip(it.subjects[::2], it.subjects[1::2], strict=False):
            yield from (single(stated("symmetric_pair", *map(AssetRef, (a, b, c)))) for c in it.others[:1])

    def _sided(self, it: Asked) -> Iterator[Demand]:
        """The seats of each table in equal shares at its sides."""
        for b in dict.fromkeys(b for _, b in it.twos):
            yield Demand(tuple(self._in_shares(b, [a for a, to in it.twos if to == b], it.sided)))

    def _in_shares(self, b: str, seats: Sequence[str], sided: str) -> Iterator[Way]:
        """Yield half of the seats at one side of a table and half across, at the longer ones, the ends or either; one at each of four."""
        pairs, (deep, wide, _) = list(self._sides_of(b, sided))[::2], self._asset(b).size
        all_four = wide == deep and len(seats) == len(SIDES_OF_A_LOUNGE)
        for way in [[*pairs[0], *pairs[1]]] if all_four else pairs:
            many = -(-len(seats) // len(way))
            parts = ((side, seats[i * many : (i + 1) * many]) for i, side in enumerate(way))
            yield tuple(said for side, part in parts for said in self._at_side(side, part, b))

    def _sides_of(self, b: str, sided: str = "") -> Iterator[tuple[str, str]]:
        """Yield each side of a thing with the one across, the longer ones first; only these, or the ends, if that is said."""
        depth, width, _ = self._asset(b).size
        pairs = [("left_of", "right_of"), ("in_front_of", "behind")][:: 1 if depth > width else -1]
        if depth != width and sided in ("long", "end"):
            pairs = pairs[:1] if sided == "long" else pairs[1:]
        for one, other in pairs:
            yield from ((one, other), (other, one))

    def _at_side(
        self, side: str, subjects: Sequence[str], b: str, gaps: tuple[float, float] | None = None
    ) -> tuple[Relation, ...]:
        """Return that things stand at a side of another one, so far from it; seats look at it, under a table if nothing is said."""
        at, found = gaps is not None or self._is(b, small.BEARING), list[Relation]()
        for a in subjects:
            sat_on = at and self._is(a, small.SEATS)
            low, high = gaps or (-ways_of.BESIDE if sat_on else 0.0, ways_of.NEAR)
            found.append(stated(side, AssetRef(a), AssetRef(b), low, high))
            found += [stated("align_with", AssetRef(a), AssetRef(b), ways_of.TOWARDS[side])] * sat_on
        return tuple(found)

    def _ways_turned(self, a: str, place: Place, relation: str) -> Iterator[Way]:
        """Yield how a thing has its longer side along a wall, or that of a window or door, or square to it, or has it at a hand."""
        depth, width, _ = self._asset(a).size
        openings = openings_meant(self.room, place) if place.name != "wall" else ()
        gap = ways_of.DAYLIGHT if relation in ways_of.AT_HAND else ways_of.AT_DOOR
        near = [stated("near", AssetRef(a), point, gap) for point in self._points(place)[: len(openings)]]
        angles = (0.0, 180.0) if (depth < width) == (relation == "square") else (90.0, 270.0)
        if relation in ways_of.AT_HAND:  # of who sits at it
            angles = ((ways_of.AT_HAND[relation] + self._looks(a)[0]) % 360.0,)
        at_walls = place.name == "wall"
        walls = [w.index for w in walls_meant(self.room, place)] if at_walls else [one.wall for one in openings]
        for number, wall in enumerate(walls):
            held = near[number : number + 1]
            for angle in angles:
                turned, *touching = self._lengthwise(a, WallRef(wall), angle)
                yield (turned, *held, *touching) if relation == "sidelong" else (turned, *held)

    def _to_openings(self, a: str, place: Place | None, angles: Sequence[float]) -> Iterator[Way]:
        """Yield how a thing looks straight at a door from beside it, along its wall, or at a window, too, from the middle or a corner."""
        turn = (self.beside.get(a, 0.0) + angles[0]) % 360.0
        doors = openings_meant(self.room, place) if place is not None and place.name == "door" else ()
        for opening in doors if a in self.beside else ():
            yield (stated("align_with", AssetRef(a), WallRef(opening.wall), turn),)
        yield from self._squarely(a, place, angles)

    def _within(self, a: str, end: AssetRef | PointRef) -> float:
        """Return how far from an end a thing between two stands: what is narrower than itself flanks it."""
        if isinstance(end, AssetRef) and (self._only_wall(end.name) or end.name in self.parted):
            return ways_of.ACROSS  # "a TV on the opposite wall and a table in between"
        if isinstance(end, AssetRef) and end.name not in self.told.abreast:
            return ways_of.BESIDE if self._asset(end.name).size[1] < self._asset(a).size[1] else ways_of.AHEAD
        return ways_of.AHEAD
