"""How several things stand in order: in rows, circles, groups and chains, and by twos."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence, Set
from itertools import pairwise

from robolayout.assets import category_of
from robolayout.constraints import AssetRef
from robolayout.constraints.in_shape import InShape
from robolayout.words import _function_words as small
from robolayout.words import _ways as ways_of
from robolayout.words._at_sides import AtSides
from robolayout.words._places import Asked
from robolayout.words._rows import alike, in_rows, on_a_wall
from robolayout.words.demands import Demand, by_ways, single, stated


class InOrder(AtSides):
    """Says what it asks of several things to stand in some order."""

    at_side: Mapping[str, str]
    """At which side of a thing something else is."""

    huddled: Set[str]
    """What is asked to stand together."""

    borne: Mapping[str, str]
    """On what things are asked to be."""

    tucked: Set[str]
    """What has a table to sit at between it and others."""

    def _by_twos(self, it: Asked, relation: str) -> Iterator[Demand]:
        """Yield what the second of every two is asked to be to the first; or how two rows of them are turned."""
        if self.told.in_rows(it.subjects):
            yield self.told.block(it.subjects)
            return
        desks = relation == "mutual" and self._is(it.subjects[0], ("desk",))  # who sits there looks over its back
        # "a cluster of desks facing each other"
        backs = relation == "backs" or (desks and self.huddled >= {*it.subjects})
        if backs and len(it.subjects) % 2 == 0 and alike(self.scene, it.subjects):
            yield in_rows(it.subjects, 2, "paired")  # pairs one before the other would have no room before them
            return
        for a, b in zip(it.subjects[::2], it.subjects[1::2], strict=False):
            amid = self.between.get(a, 0.0)
            far = (("behind", amid, amid + ways_of.BESIDE), ("align_with", 180.0))
            demand = by_ways((far,) if desks and amid else ways_of.BY_TWOS["mutual desks" if desks else relation], b, a)
            deep = sum(self._asset(name).size[0] for name in (a, b)) / 2  # their fronts are the sides that meet
            knees = (stated("distance_constraint", AssetRef(b), AssetRef(a), round(ways_of.KNEES + deep + amid, 3)),)
            knees *= relation == "mutual" and self._is(a, small.SEATS) and a not in self.tucked
            yield Demand(tuple((*way, *knees) for way in demand.ways))
            opens = category_of(self._asset(a)).open_depth > 0 and not self._is(a, small.TOPS)
            if relation == "mutual" and opens:  # wardrobes have their backs to walls
                yield from (single(stated("against_wall", AssetRef(name))) for name in (a, b))

    def _opposed(self, names: Sequence[str]) -> bool:
        """Return whether two of some things are asked to face each other."""
        return any({*two} <= {*names} for two in self.opposed)

    def _row(self, it: Asked) -> Iterator[Demand]:
        """Side by side: alike things in one line, others each at a side of the one before, turned the same way."""
        if alike(self.scene, it.subjects) and not self.told.flanked & {*it.subjects}:
            yield self.told.block(it.subjects)
            return
        hung = all(map(self._only_wall, it.subjects)) and len({self._asset(a).size for a in it.subjects}) == 1
        if hung and it.sided == "exact":  # "evenly spaced along the west wall"
            yield in_rows(it.subjects, 1, gap=self._even_gap(it.subjects))
            return
        if not any(self._asset(a).on_floor for a in it.subjects):
            yield from self._huddle(it)
        for before, a in pairwise(it.subjects):
            if self._asset(a).on_floor and self._asset(before).on_floor:
                yield by_ways(((("next_to", it.sided or "beside", ways_of.BACK), ("align_with",)),), a, before)
            elif it.sided and self._asset(a).on_object and self._asset(before).on_object:
                yield by_ways((((f"{it.sided}_of", 0.0, ways_of.NEAR), ("align_with",)),), a, before)
        tops = {self.borne.get(a, "") for a in it.subjects}
        if it.sided and len(tops) == 1 and all(tops):  # "on the desk, from left to right: ..."
            ends = [self._left_half_each, self._right_half_each][:: 1 if it.sided == "left" else -1]
            yield from (end(it.subjects[at], *tops) for end, at in zip(ends, (0, -1), strict=True))

    def _even_gap(self, names: Sequence[str]) -> float:
        """Return how many metres lie between things that are spread over the longest stretch of their wall without a door or window."""
        walls = [self.room.walls[self.hung[a]] for a in names if a in self.hung]
        if not walls:
            return 0.0
        there = [o for o in (*self.room.doors, *self.room.windows) if o.wall == walls[0].index]
        ends = sorted((0.0, walls[0].length, *(end for o in there for end in (o.offset, o.offset + o.width))))
        longest = max(after - before for before, after in zip(ends[::2], ends[1::2], strict=True))
        wide = sum(self._asset(a).size[1] for a in names)
        return math.floor(max(0.0, longest - wide) / (len(names) + 1) * 20) / 20

    def _chained(self, it: Asked, relation: str) -> Iterator[Demand]:
        """Each to the one before it; mats side by side are a row, which nothing else keeps from lying on each other."""
        same = alike(self.scene, it.subjects) and self._asset(it.subjects[0]).on_floor
        if relation == "abreast" and same and self._asset(it.subjects[0]).is_flat:
            yield in_rows(it.subjects, 1)
            return
        if relation == "stacked" and all(map(self._only_wall, it.subjects)):
            relation = "tiered"  # pictures on top of each other
        elif relation == "crossed" and self._is(it.subjects[0], small.SEATS):
            relation = "ell"  # two sofas at a right angle belong together
        elif relation == "abreast" and self.told.flanked & {*it.subjects}:
            relation = "abreast apart"
        elif relation == "abreast" and not all(
            self._asset(a).on_floor and not self._asset(a).is_flat for a in it.subjects
        ):
            relation = "together"
        unlike = relation == "together" or (relation == "abreast" and not same)
        two = (it.subjects, it.subjects[::-1]) if unlike and len(it.subjects) == 2 else ()
        if told := [(a, b) for a, b in two if b in self.at_side]:  # a washer by a dryer that has a sink to its right
            free = ("next_to", small.OTHER_SIDE[self.at_side[told[0][1]]], ways_of.AT_TABLE)
            yield by_ways(((free,), *ways_of.IN_A_CHAIN[relation]), *told[0])
            return
        ways, middle = self.told.chained(relation, it.subjects[0]), len(it.subjects) // 2
        chains = (it.subjects[middle::-1], it.subjects[middle:]) if relation == "abreast" else (it.subjects,)
        yield from (by_ways(ways, b, a) for chain in chains for a, b in pairwise(chain))

    def _rows(self, it: Asked) -> Iterator[Demand]:
        """Like things stand in a block, in so many rows if that is said; others near each other."""
        yield from [self.told.block(it.subjects)] if alike(self.scene, it.subjects) else self._huddle(it)

    _columns = _rows

    def _circle(self, it: Asked) -> Iterator[Demand]:
        """At least three like things stand in a circle, a half circle or a U; others near each other."""
        yield from [self.told.block(it.subjects)] if {*it.subjects} <= {*self.told.shape} else self._huddle(it)

    _halfcircle = _ushape = _circle

    def _groups(self, it: Asked) -> Iterator[Demand]:
        """Some here, some there: desks with their backs to each other, seats in circles, others near each other."""
        for part in self.told.groups(it.subjects):
            if self._is(part[0], small.SEATS) and len(part) > 2 and alike(self.scene, part):
                yield single(InShape(tuple(map(AssetRef, part)), "circle"))
            else:
                yield from self._huddle(Asked(part))

    _shares = _groups

    def _huddle(self, it: Asked) -> Iterator[Demand]:
        """Each near another one; what hangs on walls, on one of them; desks as an island."""
        if all(map(self._only_wall, it.subjects)):
            yield from on_a_wall(it.subjects, self.room)
        elif self._is(it.subjects[0], ("desk",)) and alike(self.scene, it.subjects):
            yield in_rows(it.subjects, min(2, len(it.subjects) // 2), "paired")
        else:
            for number, a in enumerate(it.subjects[1:], 1):
                beside = [*reversed(it.subjects[:number]), *it.subjects[number + 1 :]]
                if self._asset(a).on_floor or not self._asset(a).on_object:
                    yield single(*(stated("near", AssetRef(a), AssetRef(b), ways_of.BACK) for b in beside))
