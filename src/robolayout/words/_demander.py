"""From relations in words to demands: each word of the list has a method that says what it asks for, of all or of each two."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

from robolayout.assets import category_of
from robolayout.constraints import AssetRef, PointRef, WallRef
from robolayout.constraints.between import BetweenTwo
from robolayout.scene import Scene
from robolayout.words import _function_words as small
from robolayout.words import _ways as ways_of
from robolayout.words._at_sides import (
    beside_doors,
    by_doors,
    in_corners,
    lit_between,
    on_one_wall,
    on_walls_beside,
    parted,
)
from robolayout.words._in_order import InOrder
from robolayout.words._places import Asked
from robolayout.words._rows import ToldRows, alike, neighbours
from robolayout.words._said import Link, Mention, NamedThing, Place, mentions, named, place_in, places
from robolayout.words._shelves import shelved
from robolayout.words._walls import walls_meant
from robolayout.words.demands import Demand, Way, by_ways, single, stated


class Demander(InOrder):
    """Turns links into demands on a scene."""

    def __init__(self, scene: Scene, names: Mapping[NamedThing, tuple[str, ...]], links: Sequence[Link]) -> None:
        super().__init__(scene)
        self.names = names
        # of these only the first stands where they are put
        self.stacked = {thing for link in links if link.relation == "stacked" for thing in named(link.subjects)}
        asked = [(link, self._asked(link)) for link in links]
        self.shelved = dict(shelved(scene.by_name, asked))
        self.parted, self.amid_lit = parted(asked), lit_between(asked)
        self.cornered, self.beside, self.hung = in_corners(asked), beside_doors(asked), on_one_wall(asked, self.room)
        self.near_doors = by_doors(asked)
        # at the same wall
        self.lined = {a for _, it in asked if it.place and it.place.at_one_wall for a in it.subjects}
        self.askew = {name for link, it in asked if link.relation == "diagonal" for name in it.subjects}
        twos = [(link.relation, *two) for link, it in asked for two in it.twos]
        self.mirrors = {a: b for how, a, b in twos if how == "front" and self._into_a_mirror(a, b)}
        self.huddled = {name for link, it in asked if link.relation == "huddle" for name in it.subjects}
        self.put = {a for _, a, _ in twos}  # what stands at another thing
        self.borne = {a: b for how, a, b in twos if how in ("on", "in")}
        self.placed = self.put.union(a for _, it in asked if it.place is not None for a in it.subjects)
        self.below = {a: b for how, a, b in twos if how == "above" and self._is(a, small.WATCHED)}
        self.across = {frozenset((a, b)) for how, a, b in twos if how == "opposite"}
        self.at_side = {b: how for how, _, b in twos if how in ("left", "right")}
        sat_on = {a for a in self.put if self._is(a, small.SEATS)}
        seats = Counter(b for how, a, b in twos if how in ("with", "around") and a in sat_on)
        on_floor = [(how, a, b) for how, a, b in twos if self._asset(a).on_floor]
        self.backed = frozenset(b for how, a, b in on_floor if how == "behind" and a not in sat_on)
        backed = self.backed.union(b for how, _, b in on_floor if how == "flank")
        self.surrounded = frozenset(backed.union(name for name, count in seats.items() if count > 2))
        self.surrounded |= self._seated_around(self.cornered) | (self.askew & self.cornered.keys())
        hosted = any(self._is(one.name, small.SEATS) and not ways_of.visits(one.category) for one in scene.assets)
        # desks with a seat behind them
        at = [(how, a, b) for how, a, b in twos if self._is(b, ("desk",)) and self._sits_behind(a, b)]
        visited = {b for _, a, b in at if hosted and ways_of.visits(self._asset(a).category)}
        self.manning = {(a, b) for how, a, b in at if how == "behind"}
        self.hosting = {b for _, b in self.manning if b in visited and not self._is(b, ("reception desk",))}
        self.manned = visited.union(b for _, b in self.manning)
        # desks at which somebody looks at what is told; of these, those that look at who comes in
        turned = [(name, it) for link, it in asked if link.relation == "facing" for name in it.subjects]
        turned = [(name, it) for name, it in turned if self._looks(name)[1:] and self._is(name, ("desk",))]
        self.looking = self.manned.union(name for name, _ in turned)
        behind = {name for name, it in turned if it.place is not None and it.place.name in ("room", "door")}
        cornered = ((name, it.others) for name, it in turned if name in self.cornered)
        behind |= {name for name, others in cornered if any(self._is(b, ("desk",)) for b in others)}
        self.manned, self.surrounded = self.manned | behind, self.surrounded | behind
        self.metres = {
            two: link.metres for link, it in asked if link.relation == "apart" for two in it.twos
        } | on_walls_beside(asked)
        amid = [it for link, it in asked if link.relation == "amid"]  # with the metres that things between others take
        self.between = {b: min(self._asset(a).size[:2]) for it in amid for a in it.subjects for b in it.others}
        tables = [it for it in amid if any(self._asset(a).size[2] >= ways_of.SAT_AT for a in it.subjects)]
        self.tucked = {b for it in tables for b in it.others}
        mutual = [it.subjects for link, it in asked if link.relation == "mutual"]
        self.opposed = [two for names in mutual for two in zip(names[::2], names[1::2], strict=False)]
        alone = [({link.relation, *(place.name for place in it.places[:1])}, it) for link, it in asked if not it.others]
        self.central = {name for where, it in alone if "middle" in where for name in it.subjects}
        self.at_places = self.central.union(name for _, it in alone if it.place for name in it.subjects)
        self.lounging = self._lounging(it for link, it in asked if link.relation == "around")
        self.told = ToldRows(scene, [(link, it.subjects, it.others) for link, it in asked])

    def demands(self, link: Link) -> tuple[Demand, ...]:
        """Return what a link asks for; nothing where it cannot be said."""
        it, relation = self._the_other_way_round(self._asked(link), link.relation)
        if relation != "stacked":
            piled = {name for thing in self.stacked for name in self.names.get(thing, ())[1:]}
            it = replace(it, subjects=[name for name in it.subjects if name not in piled])
        if relation in ("open", "bare", "turning") or (relation == "faced" and not link.subjects):
            seats = small.SEATS if relation == "faced" else ()
            there = (one for one in self.scene.assets if one.on_floor and not one.is_flat)
            it = replace(it, subjects=[one.name for one in there if not seats or self._is(one.name, seats)])
        if not it.subjects:
            return ()
        if relation == "cleared":
            return tuple(one for at in it.places for one in self._cleared(it.subjects, at.words[0], it.metres[0]))
        if relation in ("apart", "bare"):
            return tuple(self._apart(it, it.metres if any(it.metres) else ways_of.OFF_A_WALL))
        if relation in small.ENDS and place_in(link.objects, "room"):
            return tuple(self._at_place(it.subjects, Place("side", (small.ENDS[relation],))))
        if relation in ways_of.IN_A_CHAIN:
            return tuple(self._chained(it, relation))
        if relation in ways_of.BY_TWOS:
            return tuple(self._by_twos(it, relation))
        name = relation.replace(" ", "_")
        of_all, of_two = (getattr(self, f"_{name}{end}", None) for end in ("", "_each"))
        found = [*self._there(relation, it), *(of_all(it) if of_all else ())]
        if relation in ways_of.TO_ANOTHER:
            found += (by_ways(self._ways(relation, a, b), a, b) for a, b in self._to_another(relation, it))
        twos = self._to_another(relation, it) if relation == "middle" else it.twos  # "in the middle of them"
        return (*found, *(demand for a, b in twos if of_two and (demand := of_two(a, b)) is not None))

    def _asked(self, link: Link) -> Asked:
        """Return of which assets a link asks something."""
        kinds = [self._named(mention) for mention in link.subjects]
        subjects = [name for kind in kinds for name in kind]
        others = [self._named(item) for item in mentions(link.objects)]
        return Asked(subjects, others, places(link.objects), link.sided, kinds, link.metres)

    def _named(self, mention: Mention) -> tuple[str, ...]:
        names = self.names.get(mention.thing, ())
        return names if mention.pick is None else names[mention.pick] or names[:1]

    def _there(self, relation: str, it: Asked) -> Iterator[Demand]:
        """Yield that things stand at the place of the room to which their relation leads, if it does."""
        if it.place is None or relation not in ways_of.AT_PLACES:
            return
        if relation == "flank" and it.place.name in ("window", "door") and len(it.subjects) > 1:
            yield from [Demand(ways)] if (ways := tuple(self._ways_flanking(it.subjects, it.place))) else []
            return
        if relation in ("left", "right") and it.place.name in ("window", "door"):
            wide = sum(self._asset(a).size[1] for a in it.subjects if self._asset(a).on_floor)
            for a in it.subjects:  # "shelves to the right of the door": one beyond the other
                more = max(0.0, wide - self._asset(a).size[1])
                yield from [Demand(ways)] if (ways := tuple(self._ways_beside(a, it.place, relation, more))) else []
            return
        if relation in ways_of.TURNED and it.place.name in ("window", "door", "wall"):
            found = [tuple(self._ways_turned(a, it.place, relation)) for a in it.subjects]
            yield from (Demand(ways) for ways in found if ways)
            return
        if relation == "above" and it.place.name in ("window", "door") and all(map(self._hangs_over, it.subjects)):
            over = [tuple(self._ways_over(a, it.place, len(it.subjects))) for a in it.subjects]
            if all(over):
                yield from map(Demand, over)
                return
        on, share = relation in ("on", "wall", "hanging"), len(it.subjects) > 1 and relation != "flank"
        share = share or not self.manned.isdisjoint(it.subjects)  # somebody sits between
        along = relation == "wall" and len(it.subjects) == 1  # "a bar along the window"
        under = (relation == "under" or along) and it.place.name == "window"
        if it.place.name == "wall" and self.mirrors.keys() >= {*it.subjects}:
            yield from self._before_mirrors(it.subjects, it.place)
            return
        for place in it.places if relation in small.NEARBY else [it.place]:
            yield from self._at_place(it.subjects, place, on=on, share=share, under=under)

    def _to_another(self, relation: str, it: Asked) -> list[tuple[str, str]]:
        """Return each two of which the second says where the first stands: one thing to several, the middle one of a row."""
        if relation == "front" and self._front(it):
            return []
        each = [(it.subjects[0], group[0]) for group in it.groups if group]
        if len(it.subjects) == 1 and len(it.groups) > 1 and each:
            return each
        groups = (
            self.told.groups(it.others) if relation == "end" and it.others and it.others[0] in self.told.each else []
        )
        if len(groups) == len(it.subjects):
            return [(a, group[-1]) for a, group in zip(it.subjects, groups, strict=True)]
        of_rows = relation in small.ENDS and len(it.others) < 2
        return (replace(it, subjects=self.told.before(it.subjects, it.others) or it.subjects) if of_rows else it).twos

    def _on_each(self, a: str, b: str) -> Demand:
        """A thing rests on another: a rug lies below what stands on it; what stands on the floor is flush with a counter that it is in."""
        if self._asset(b).is_flat:
            (long, short), own = sorted(self._asset(b).size[:2], reverse=True), max(self._asset(a).size[:2])
            # of a sofa on a rug the front legs are, a rug of which no more is said lies at what it belongs to, and several make a ring
            alike = sum(one.category == self._asset(a).category for one in self.scene.assets)
            share = ways_of.SMALL_ON_A_RUG if b in self.at_places else ways_of.TOY_ON_A_RUG
            wholly = own <= share * short and alike == 1
            return self._over_rug(a, b, round((long + short) / 4, 2) if wholly else None)
        built = self._asset(a).on_floor and not self._asset(a).on_object and category_of(self._asset(a)).built_in
        if built and self._is(b, ("counter", "island")):
            return by_ways(ways_of.FLUSH, a, b)  # "a sink in an island", "the stove on one counter"
        hung = self._asset(a).on_wall and not self._asset(a).on_object
        if (shelf := self.shelved.get((a, b))) is not None:
            return single(stated("inside", AssetRef(a), AssetRef(b), shelf))
        return single(stated("above" if hung else "on_top_of", AssetRef(a), AssetRef(b)))

    _in_each = _on_each

    def _over_rug(self, a: str, b: str, most: float | None) -> Demand:
        """A thing stands on a rug, its middle so far from that of the rug at the most."""
        under = stated("under", AssetRef(b), (AssetRef(a),))
        near = () if most is None else (stated("distance_constraint", AssetRef(a), AssetRef(b), None, most),)
        return Demand(((under, *near),))

    def _with_each(self, a: str, b: str) -> Demand | None:
        """What a thing has: on it, if it can stand nowhere else, else at it."""
        if self._is(a, small.WATCHED) and self._is(b, (*small.SEATS, *small.SLEPT_ON)):  # "a sofa with a TV"
            return single(stated("point_towards", AssetRef(b), AssetRef(a)))
        asset = self._asset(a)
        beside = asset.on_floor or self._is(b, small.SLEPT_ON)
        if asset.on_object and (not beside or (a, b) in self.shelved or self._is(b, (*small.TOPS, "wall shelf"))):
            return self._on_each(a, b)
        if self._is(a, small.SEATS) and self._is(b, ("desk", "counter", "island")):
            across = (b in self.manned and ways_of.visits(asset.category)) or any(a == two for _, two in self.opposed)
            return by_ways(ways_of.ACROSS_A_DESK[:1] if across else ways_of.AT_A_DESK, a, b)
        if self._is(a, ("chair",)) and self._is(b, ("table",)) and not self._is(a, ("armchair",)):
            return self._seat_around(a, b)
        if beside or asset.on_wall:
            return single(stated("near", AssetRef(a), AssetRef(b), ways_of.BESIDE if beside else ways_of.NEAR))
        return None

    def _flank(self, it: Asked) -> Iterator[Demand]:
        """Left and right of a thing, in turn; at the ends of a row."""
        if it.sided == "outer" and it.others[1:]:
            yield self._outside(it)
            return
        if self._opposed(it.subjects) and (before := self._front(it)):
            yield from before  # "two armchairs flanking a fireplace, facing each other"
            return
        by, on = dict[str, list[str]](), dict[str, list[str]]()
        for a, b in it.twos:
            if self._is(b, small.BEARING) and self._asset(a).on_object and not self._asset(a).on_floor:
                ends = on.setdefault(b, [])
                end = (self._right_half_each if len(ends) % 2 else self._left_half_each)(a, b)
                ends.append(a)
                yield self._on_each(a, b)
                yield from [end] * (len(it.twos) > len({b for _, b in it.twos}))
            else:
                by.setdefault(b, []).append(a)
        for b, items in by.items():
            ways = [[("left", "right")[(i + first) % 2] for i in range(len(items))] for first in (0, 1)]
            gap = ways_of.BESIDE if len(items) < 3 else ways_of.BESIDE * len(items)
            if len(items) == 2 and (amid := self._ways_amidst(b, items)):
                yield Demand(amid)
                continue
            sided = ([*zip(items, way, strict=True)] for way in ways)
            beside = (tuple(stated("next_to", AssetRef(a), AssetRef(b), s, gap) for a, s in way) for way in sided)
            yield Demand((*self._across_a_top(b, items, it.sided), *beside))

    def _behind(self, it: Asked) -> Iterator[Demand]:
        """Behind a thing; behind a desk at which somebody looks somewhere is behind who sits there, where it is used from."""
        last: dict[str, str] = {}
        for a, b in it.twos:
            gap = max(self._told(a, b), ways_of.BACK_WALL if self._only_wall(a) else ways_of.BACK)
            sat_on = self._is(a, ("chair", "stool")) and not self._is(a, ("armchair",))
            seated = self._sits_behind(a, b)
            low = -ways_of.BESIDE if seated and sat_on else 0.0  # it may be under the desk
            past = (low, gap) if sat_on or self._only_wall(a) else ways_of.PAST_A_SEAT
            back = stated("behind", AssetRef(a), AssetRef(b), 0.0, gap)
            used = stated("in_front_of", AssetRef(a), AssetRef(b), *past)
            taught = self._is(b, ("teacher desk",)) and self._is(a, small.BOARDS)
            demand = single(*([used] if b in self.looking or taught else [used, back] if seated else [back]))
            yield self._or_abreast(a, last.get(b), demand)
            last[b] = a

    def _or_abreast(self, a: str, before: str | None, demand: Demand) -> Demand:
        """Return a demand that is met, too, where a thing stands side by side with one like it of which the same is asked."""
        if before is None or not alike(self.scene, [before, a]):
            return demand
        return Demand((*by_ways(ways_of.ABREAST, a, before).ways, *demand.ways))

    def _ways(self, relation: str, a: str, b: str) -> ways_of.Ways:
        """Return what a relation asks for; before a desk behind which somebody sits is the other side of it, where one looks at it."""
        if relation in ("end", "foot") and self._only_wall(a):  # "a screen on the wall at one end of the table"
            depth, width, _ = self._asset(b).size
            return ways_of.END_WALLS[relation == "end" and width >= depth][: 1 if relation == "foot" else 2]
        if relation in ("left", "right"):
            if self._only_wall(b) or self._is(b, small.WATCHED | small.SCREENS):
                relation = small.OTHER_SIDE[relation]  # as one sees it who looks at it
            (((how, least, most),),) = ways_of.TO_ANOTHER[relation]
            return (((how, least, max(most, self._told(a, b))),),)  # "a plant 2 m to the left of it"
        if relation == "end" and not self._is(b, ("table", *small.SLEPT_ON)):
            return ways_of.TO_ANOTHER["end"][1:]  # "a fridge at the end of the counter"
        if relation == "front" and self._told(a, b) > ways_of.AHEAD:  # "2.5 m in front of it"
            looks = self._is(a, small.SEATS) and self._is(b, (*small.WATCHED, "stand"))
            return ((("in_front_of", 0.0, self._told(a, b)), *((("point_towards",),) * looks)),)
        watching = self._is(a, small.SEATS) and self._is(b, small.WATCHED) and a not in self.askew
        if relation == "front" and watching and self._asset(b).category != "backdrop":
            return ways_of.BEFORE_WATCHED
        if relation == "front" and self._into_a_mirror(a, b):
            return ways_of.BEFORE_A_MIRROR
        if relation != "front" or b not in self.manned:
            return ways_of.TO_ANOTHER[relation]
        return (ways_of.ACROSS_A_DESK[0 if self._is(a, small.SEATS) else 1],)

    def _into_a_mirror(self, a: str, b: str) -> bool:
        return self._is(a, (*small.SEATS, "treadmill")) and self._is(b, ("mirror",))

    def _before_mirrors(self, subjects: Sequence[str], place: Place) -> Iterator[Demand]:
        """Yield that chairs are near the wall on which their mirrors hang: "along the wall, each in front of a mirror"."""
        walls = [WallRef(wall.index) for wall in walls_meant(self.room, place)]
        for a in subjects:
            ref, most = AssetRef(a), round(ways_of.INTO[1] + self._asset(a).size[0], 2)
            hung = [stated("mounted_on", AssetRef(self.mirrors[a]), wall) for wall in walls]
            near = [stated("distance_constraint", ref, wall, None, most) for wall in walls]
            yield Demand(tuple(zip(hung, near, strict=True)))

    def _opposite(self, it: Asked) -> Iterator[Demand]:
        """Across from a thing, seats that look there side by side; from a place, looking at it."""
        if it.place and it.place.name == "room":
            yield from self._at_place(it.subjects, Place("side", ("far",)))
        elif it.place is not None:
            yield from self._facing(replace(it, groups=()))
        last: dict[str, str] = {}
        for a, b in (across := self._seats_opposite(it)) or it.twos:
            sat_on = self._is(a, small.SEATS) and a not in self.askew
            across_from = ways_of.OPPOSITE_HUNG if self._only_wall(b) else ways_of.OPPOSITE
            demand = by_ways(ways_of.OPPOSITE_SEATS if sat_on else across_from, a, b)
            yield self._or_abreast(a, last.get(b) if sat_on and not across else None, demand)
            if (low := self.below.get(a)) is not None and low != b:  # "a TV above the dresser, across from the bed"
                yield by_ways(ways_of.OPPOSITE, low, b)
            last[b] = a

    def _seats_opposite(self, it: Asked) -> list[tuple[str, str]]:
        """Return which seats are across from which where one is from several alike: "two armchairs and a sofa across from them"."""
        one, few = it.subjects[0], it.others if len(it.subjects) == 1 and len(it.others) < ways_of.CROWD else []
        seats = alike(self.scene, few) and all(self._is(name, small.SEATS) for name in (one, *few))
        return [(one, b) if b in self.placed else (b, one) for b in few] if seats else []

    def _facing(self, it: Asked) -> Iterator[Demand]:
        """Looking at a thing, a door or a window; a desk faces what one sees who sits at it."""
        others, subjects = it.others, it.subjects
        if told := self._visiting_or_open(it):
            yield from told
            return
        if len(others) < 2 and (one := self.told.before(subjects, facing=True)):  # the others look as it does
            yield Demand((tuple(stated("align_with", AssetRef(a), AssetRef(*one)) for a in subjects if a not in one),))
            subjects = one
        elif len(subjects) >= ways_of.CROWD and 0 < len(others) < len(subjects) and alike(self.scene, subjects):
            across = 180.0 * (self._is(others[0], ("teacher desk",)) and others[0] not in self.put)
            turn = (180.0 + across - self._looks(subjects[0])[0]) % 360.0  # a crowd looks one way
            yield from (single(stated("align_with", AssetRef(a), AssetRef(others[0]), turn)) for a in subjects)
            return
        flat = [b for b in others if len(others) == 1 < len(it.subjects) and self._asset(b).is_flat]
        for i, a in enumerate(subjects):
            meant = [others[i]] if len(others) == len(subjects) else others
            targets = [AssetRef(b) for b in meant if b != a] if others else self._points(it.place)
            angles = self._looks(a)[: 1 if a in self.looking else 2]
            # straight before the middle of rows that lie there
            before = [stated("in_front_of", AssetRef(b), AssetRef(a), 0.0, ways_of.AT_THE_FRONT) for b in flat]
            before += [stated("centered_on", AssetRef(b), AssetRef(a), "side") for b in flat]
            looks = ((stated("point_towards", AssetRef(a), b, angle), *before) for b in targets for angle in angles)
            ways = [*self._straight(subjects, others), *self._to_openings(a, it.place, angles), *looks]
            if len(others) == len(subjects) > 1 and self._into_a_mirror(a, others[i]):
                ways = [*by_ways(ways_of.BEFORE_A_MIRROR, a, others[i]).ways]
            if len(others) >= ways_of.CROWD and alike(self.scene, others):
                ways = [self._against(a, others[0]), *ways]  # opposite to all of a crowd
            if i and ways and not others:  # side by side before one window
                ways = [*by_ways(ways_of.ABREAST, a, subjects[0]).ways, *ways]
            beds = len(subjects) > 1 and self._is(a, small.SLEPT_ON)  # two beds side by side, and a dresser
            walled = a in self.hung and category_of(self._asset(a)).open_depth > 0  # it looks straight from its wall
            if len(others) == 1 and (beds or walled):
                ways.append((stated("align_with", AssetRef(a), AssetRef(others[0]), 180.0),))
            if ways:
                yield Demand(tuple(ways))

    def _straight(self, subjects: Sequence[str], others: Sequence[str]) -> Iterator[Way]:
        """Yield how one seat is opposite several that have their place, or from its corner a TV: "a sofa facing them"."""
        placed = len(others) > len(subjects) == 1 and others[0] in self.put
        cornered = len(others) == 1 and subjects[0] in self.cornered and self._is(others[0], small.WATCHED)
        seats = cornered or (placed and all(self._is(name, small.SEATS) for name in others))
        for b in others if seats and self._is(subjects[0], small.SEATS) else ():
            yield from by_ways(ways_of.OPPOSITE_SEATS[:1], subjects[0], b).ways

    def _against(self, a: str, b: str) -> Way:
        """Return that a thing looks against where another one looks."""
        turn = (180.0 + self._looks(a)[0] + self._looks(b)[0]) % 360.0
        return (stated("align_with", AssetRef(a), AssetRef(b), turn),)

    def _class_of(self, a: str) -> list[str]:
        """Return the seats or desks of those to whom somebody speaks at a thing; nothing where it is none, or they are few."""
        rows = (names for thing, names in self.names.items() if thing.head in small.OWN and len(names) >= ways_of.CROWD)
        crowd = next((names for names in rows if a not in names and alike(self.scene, names)), [])
        return [*crowd] if self._is(a, ("teacher desk", *small.SPOKEN_FROM)) else []

    def _visiting_or_open(self, it: Asked) -> list[Demand]:
        """Return where seats stand that face a desk at which somebody sits, that a shape is open to what it faces, who the class."""
        a, to_all = it.subjects[0], it.place is not None and it.place.name == "room"
        if to_all and (crowd := self._class_of(a)):
            return [Demand((self._against(a, crowd[0]),))]
        if len(it.others) == 1 and it.others[0] in self.manned and all(self._is(a, small.SEATS) for a in it.subjects):
            visiting = [one for one in it.subjects if (one, it.others[0]) not in self.manning]
            return [by_ways(ways_of.VISITING, one, it.others[0]) for one in visiting]
        if {*it.subjects} <= {*self.told.shape}:
            to = [AssetRef(b) for b in it.others] or self._points(it.place)
            return [*self.told.opening(it.subjects, to)]
        return []

    def _seen(self, it: Asked) -> Iterator[Demand]:
        for i, b in enumerate(it.others):  # "visible from the bed and from the sofa"
            seen = it.subjects[i * len(it.subjects) // len(it.others)]
            yield single(*(stated("point_towards", AssetRef(b), AssetRef(seen), angle) for angle in ways_of.SEEN))

    def _amid(self, it: Asked) -> Iterator[Demand]:
        """Between two things, or a thing and a place: near both, and on the line between them."""
        if it.places and not it.others and {place.name for place in it.places} <= {"window", "door"}:
            yield from (Demand(ways) for a in it.subjects if (ways := tuple(self._ways_amid(a, it.places))))
            return
        ends: list[AssetRef | PointRef] = [AssetRef(name) for name in it.others if name not in it.subjects]
        # "between the cribs and the window"
        ends = ends[: 1 if it.place and it.place.name in ("window", "door") and len(it.groups) == 1 else None]
        ends += self._points(it.place)[: 1 + it.place.plural] if it.place is not None else []
        wide = self.told.abreast.get(it.others[0], 0) if it.others and it.place is None else 0
        for a in it.subjects if len(ends) > 1 and not (wide and self._only_wall(it.subjects[0])) else ():
            across = ends[wide // 2 :: wide] if wide and len(ends) > 2 else ends  # between two rows
            lines = not wide and len(it.groups) == 2 and len(ends) > 2  # "between the sinks and the shower"
            # "two groups of four desks with a plant between them"
            groups = self.told.groups(it.others) if it.others and it.others[0] in self.told.each else ()
            if lines or len(groups) == 2:
                across = [AssetRef(group[len(group) // 2]) for group in (groups or it.groups)]
            rows = 1 < len(across) < len(ends) - len(it.subjects) or len(across) == 2  # "a table between the rows"
            pairs = [*pairwise(across)] if rows else neighbours(ends, len(it.subjects))
            one, two = pairs[it.subjects.index(a) % len(pairs)]
            far = lines and all(len(group) > 2 for group in it.groups)  # rows along walls
            far = far or frozenset(getattr(end, "name", "") for end in (one, two)) in self.across
            near = tuple(
                stated("near", AssetRef(a), end, ways_of.ACROSS if far else self._within(a, end)) for end in (one, two)
            )
            yield Demand((near,), BetweenTwo(AssetRef(a), one, two))
            if self._is(a, small.PARTING) and self._asset(a).on_floor:  # "a curtain between the beds"
                yield single(*(stated("point_towards", AssetRef(a), one, angle) for angle in (0.0, 180.0)))
            beds = all(isinstance(end, AssetRef) and self._is(end.name, small.SLEPT_ON) for end in (one, two))
            headed = beds and self._is(a, ("night stand",)) and not self.parted & {*it.others}  # by their heads
            walled = category_of(self._asset(a)).built_in and a not in self.borne  # "the stove between sink and fridge"
            if headed or (walled and not self._asset(a).on_object):
                yield single(stated("against_wall", AssetRef(a)))

    def _middle_each(self, a: str, b: str) -> Demand:
        if not (self._asset(a).on_object or self._asset(b).is_flat):
            return single(stated("near", AssetRef(a), AssetRef(b), ways_of.BESIDE))
        if self._asset(b).is_flat:
            return self._over_rug(a, b, ways_of.MIDDLE_OF_A_RUG if b in self.at_places else None)
        return Demand(
            tuple((*way, stated("centered_on", AssetRef(a), AssetRef(b))) for way in self._on_each(a, b).ways)
        )
