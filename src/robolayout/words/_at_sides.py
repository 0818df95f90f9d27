"""What stands on one side of a thing: any side, the other one, all seats at one side of a table."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from robolayout.constraints import AssetRef, Relation
from robolayout.words import _function_words as small
from robolayout.words import _ways as ways_of
from robolayout.words._places import Asked, AtPlaces
from robolayout.words._rows import ToldRows
from robolayout.words.demands import Demand, by_ways, single, stated

SIDES_OF_A_LOUNGE = ("behind", "left_of", "right_of", "in_front_of")
"""Sides of a low table at which sofas stand that are around it, in their order."""


class AtSides(AtPlaces):
    """Says what it asks for to be at a side of a thing."""

    opposed: Sequence[tuple[str, str]]
    """Each two that are asked to face each other."""

    lounging: Mapping[str, tuple[str, tuple[float, float]]]
    """Several sofas, with armchairs, that are around a low table: at which side of it, and how far from it, each is."""

    told: ToldRows
    """What is said of rows and shapes."""

    def _front(self, it: Asked) -> tuple[Demand, ...]:
        """A shape before something is open to it; two that face each other before a fireplace stand on both sides of its middle."""
        if {*it.subjects} <= {*self.told.shape}:
            return tuple(self.told.opening(it.subjects, [AssetRef(b) for b in it.others]))
        pairs = [two for two in self.opposed if {*two} <= {*it.subjects}]
        if len(it.others) != 1 or 2 * len(pairs) != len(it.subjects) or not self._is(it.others[0], small.WATCHED):
            return ()
        (b,) = map(AssetRef, it.others)
        return tuple(
            single(stated(*one))
            for first, second in (map(AssetRef, two) for two in pairs)
            for one in (("symmetric_pair", first, second, b), ("near", first, b, ways_of.LOOKING))
        )

    def _lounging(self, around: Iterable[Asked]) -> dict[str, tuple[str, tuple[float, float]]]:
        """Return at which side of what they are around, and how far from it, sofas and their armchairs are: in a U, or all round."""
        found = dict[str, tuple[str, tuple[float, float]]]()
        for it in around:
            sofas, armchairs = ([a for a in it.subjects if self._is(a, (head,))] for head in ("sofa", "armchair"))
            seats = [*sofas, *armchairs]
            if len(sofas) > 1 and len(seats) <= len(SIDES_OF_A_LOUNGE) and len(it.others) == 1:
                gaps = ways_of.AT_A_LOUNGE if len(seats) < len(SIDES_OF_A_LOUNGE) else ways_of.AROUND_A_LOUNGE
                found |= {a: (side, gaps) for a, side in zip(seats, SIDES_OF_A_LOUNGE, strict=False)}
        return found

    def _around_each(self, a: str, b: str) -> Demand:
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
        yield Demand(tuple(self._at_side(side, it.subjects, b) for side, _ in self._sides_of(b)))

    def _otherside(self, it: Asked) -> Iterator[Demand]:
        """On the other side of the first of some things than the rest of them."""
        b, *there = it.others
        sides = self._sides_of(b)
        yield Demand(
            tuple((*self._at_side(one, it.subjects, b), *self._at_side(other, there, b)) for one, other in sides)
        )

    def _sides_of(self, b: str) -> Iterator[tuple[str, str]]:
        """Yield each side of a thing with the one across, the longer ones first."""
        depth, width, _ = self._asset(b).size
        pairs = ("left_of", "right_of"), ("in_front_of", "behind")
        for one, other in pairs if depth > width else pairs[::-1]:
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
