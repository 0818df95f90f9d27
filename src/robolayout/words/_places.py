"""Where in the room a place is, and how a thing can be there: at walls, corners, doors and windows, in the middle, in a half."""

from __future__ import annotations

import math
import operator
from collections.abc import Iterable, Iterator, Sequence, Set
from dataclasses import dataclass, replace
from itertools import combinations, permutations, product

from robolayout.constraints import AssetRef, PointRef, Relation, WallRef
from robolayout.constraints.corner import convex_corners
from robolayout.scene import Asset, Opening, Scene
from robolayout.words import _function_words as small
from robolayout.words import _ways as ways_of
from robolayout.words._halves import floor_point, half_aside, half_at, halves_meant, rectangle
from robolayout.words._lexicon import grammar
from robolayout.words._rows import ToldRows, alike, in_rows
from robolayout.words._said import Place
from robolayout.words._walls import (
    across,
    centre,
    corner_of,
    corners_meant,
    meet,
    openings,
    openings_meant,
    walls_meant,
)
from robolayout.words.demands import Demand, Way, single, stated


@dataclass(frozen=True)
class Asked:
    """Of which assets a relation asks something."""

    subjects: Sequence[str]  # what stands so
    groups: Sequence[Sequence[str]] = ()  # what it stands to, by the thing that was named
    places: Sequence[Place] = ()  # the places of the room to which it leads
    sided: str = ""  # at which sides of a table: "each", "long" or "end", if that is said
    kinds: Sequence[Sequence[str]] = ()  # what stands so, by the thing that was named
    metres: tuple[float, float] = (0.0, 0.0)  # least and most that are told

    @property
    def place(self) -> Place | None:
        """The first place of the room to which it leads, if it leads to one."""
        return self.places[0] if self.places else None

    @property
    def others(self) -> list[str]:
        """Everything that it stands to."""
        return [name for group in self.groups for name in group]

    @property
    def twos(self) -> list[tuple[str, str]]:
        """Each subject with what it stands to: in equal shares where there are several, of each kind where it has so many."""
        others, twos = self.others, list[tuple[str, str]]()
        kinds = [[name for name in kind if name in self.subjects] for kind in self.kinds]
        each = others and all(kind and len(kind) % len(others) == 0 for kind in kinds)
        for names in kinds if kinds and each else [self.subjects]:
            many = len(names)
            shares = (i * len(others) // many if many >= len(others) else i for i in range(many if others else 0))
            twos += [(name, others[share]) for name, share in zip(names, shares, strict=False)]
        return [(a, b) for a, b in twos if a != b]


class AtPlaces:
    """Says in which ways things can be at the places of a scene's room."""

    told: ToldRows
    """What is said of rows and shapes."""

    central: Set[str]
    """What is asked to be in the middle of the room."""

    def __init__(self, scene: Scene) -> None:
        self.scene, self.room = scene, scene.room
        self.cornered = dict[str, str]()  # what is asked to be in a corner, perhaps one by a window, and what is across
        self.between = dict[str, float]()  # what has something between it and others, with the metres that this takes
        self.amid_lit = frozenset[str]()  # what has between it and others what is asked to be at a window
        self.backed = frozenset[str]()  # what has furniture behind it
        self.hosting = set[str]()  # desks with seats on both sides, no reception desks
        self.surrounded = frozenset[str]()  # what touches no wall: seats are all around it, or something is behind it

    def _asset(self, name: str) -> Asset:
        return self.scene.by_name[name]

    def _is(self, name: str, words: Iterable[str]) -> bool:
        asset = self._asset(name)
        return any(text.endswith(word) for text in (asset.category, asset.like) for word in words)

    def _looks(self, name: str) -> tuple[float, ...]:
        """Return degrees from the front of a thing to where it looks, best first: who sits at a desk looks over its back."""
        return (180.0, 0.0) if ways_of.looks_over(self._asset(name)) else (0.0,)

    def _only_wall(self, name: str) -> bool:
        asset = self._asset(name)
        return asset.on_wall and not asset.on_floor and not asset.on_object

    def _held(self, name: str, on: bool) -> str:
        """Return the statement that says that a thing is at a wall: hung on it, or standing against it."""
        hung = on and self._asset(name).on_wall and not self._asset(name).on_floor
        return "mounted_on" if hung or self._only_wall(name) else "against_wall"

    def _at_walls(self, subjects: Sequence[str], there: Sequence[str], place: Place, *, on: bool) -> Iterator[Way]:
        """Yield the ways in which things are at the wall where others are, or at the one across from it."""
        meeting = not small.ADJOINING.isdisjoint(place.words)
        fits = operator.is_ if "same" in place.words else meet if meeting else across
        for one in self.room.walls:
            for two in self.room.walls:
                if fits(one, two):
                    both = [*((a, one) for a in there), *((a, two) for a in subjects)]
                    yield tuple(stated(self._held(a, on), AssetRef(a), WallRef(wall.index)) for a, wall in both)

    def _beds_along(self, beds: Sequence[str], half: int) -> Iterator[Way]:
        """Yield the ways in which beds are along two opposite walls, half of them at each, headed alike.

        With something between them at a window they are at its wall, too, with their heads or a side.
        """
        if not all(self._is(a, small.SLEPT_ON) for a in beds):
            return
        lit = [self.room.walls[i] for i in sorted({one.wall for one in openings(self.room, "window")})]
        for one, two in ((one, two) for one, two in permutations(self.room.walls, 2) if across(one, two)):
            at = [(a, WallRef((one if i < half else two).index), i < half) for i, a in enumerate(beds)]
            along = [
                [said for a, wall, first in at for said in self._lengthwise(a, wall, turn if first else 360.0 - turn)]
                for turn in (90.0, 270.0)
            ]
            for light in lit if self.amid_lit >= {*beds} else ():
                if meet(light, one) and meet(light, two):
                    by = WallRef(light.index)
                    heads = [stated("against_wall", AssetRef(a), by) for a in beds]
                    ends = [corner_of(light, wall) for wall in (one, two)]
                    yield (*heads, *(stated("corner", AssetRef(a), i) for a, i in zip(beds, ends, strict=False)))
                    backs = [stated("against_wall", AssetRef(a), wall) for a, wall, _ in at]
                    if light.length > ways_of.ACROSS_BEDS + sum(sorted(self._asset(a).size[0] for a in beds)[-2:]):
                        yield (*backs, *(self._lengthwise(a, by, 0.0)[1] for a in beds))
            yield from map(tuple, () if self.amid_lit >= {*beds} else along)

    def _lengthwise(self, a: str, wall: WallRef, angle: float) -> Way:
        """Return that a thing has one of its long sides at a wall, turned so from it."""
        side = round(min(self._asset(a).size[:2]) / 2 + ways_of.TOUCHING, 3)
        return (
            stated("align_with", AssetRef(a), wall, angle),
            stated("distance_constraint", AssetRef(a), wall, None, side),
        )

    def _at_place(
        self, subjects: Sequence[str], place: Place, *, on: bool = False, share: bool = False, under: bool = False
    ) -> Iterator[Demand]:
        """Yield that things stand at a place of the room; where several share it, each somewhat farther from its middle."""
        opposite = "opposite" in place.words or (place.det == "both" and not place.words)  # "benches along both walls"
        together = "same" in place.words or (place.plural and (opposite or not small.ADJOINING.isdisjoint(place.words)))
        corners = corners_meant(self.room, place) if place.name == "corner" else []
        every = place.det in ("each", "both", "all")
        if place.name == "wall" and together and len(subjects) > 1 and "middle" not in place.words:
            half = (len(subjects) + 1) // 2  # at one wall, or one half at each of two
            along = [*self._beds_along(subjects, half)] if opposite else []
            ways = self._at_walls(subjects[half:], subjects[:half], place, on=on)
            yield Demand((*along,) if along and self.amid_lit >= {*subjects} else (*ways, *along))
        elif place.name == "side" and {"opposite", "opposing"} & {*place.words} and len(subjects) > 1:
            half = (len(subjects) + 1) // 2  # one half of them in each half of the room
            yield Demand(
                tuple(
                    tuple(stated("zone", AssetRef(a), sides[i >= half]) for i, a in enumerate(subjects))
                    for one, other in (("left", "right"), ("right", "left"), ("front", "back"), ("back", "front"))
                    for sides in [[next(halves_meant(self.room, Place("side", (end,)))) for end in (one, other)]]
                )
            )
        elif corners and len(subjects) > 1 and not (place.plural or place.number or every):
            wide = max(self._asset(a).size[1] for a in subjects)
            ways = list[Way]()
            for a in (a for a in subjects if self._asset(a).size[1] == wide):  # "two armchairs in the corner"
                gap = ways_of.BESIDE + self.between.get(a, 0.0)  # "with a table between them"
                near = [stated("near", AssetRef(b), AssetRef(a), gap) for b in subjects if b != a]
                ways += [(*way, *near) for way in self._ways_at(a, place, on=on, share=share)]
            yield Demand(tuple(ways))
        elif len(corners) == len(subjects) > 1:
            yield from (single(stated("corner", AssetRef(a), i)) for a, i in zip(subjects, corners, strict=True))
        elif place.name == "window" and self._too_many(subjects, place, on=on, under=under):
            yield from (Demand(tuple(self._ways_along_windows(a, place, under=under))) for a in subjects)
        elif place.at_one_wall and len(subjects) > 1 and len(told := walls_meant(self.room, place)) > 1:
            at = [[stated(self._held(a, on), AssetRef(a), WallRef(w.index)) for a in subjects] for w in told]
            yield Demand(tuple(map(tuple, at)))  # "mirrors on the long wall": all at the same of them
            row = len(subjects) > 2 and alike(self.scene, subjects)
            yield from [in_rows(subjects, 1, gap=self.told.apart.get(subjects[0], 0.0))] if row else []
        else:
            each = every and place.name in ("window", "door") and len(openings_meant(self.room, place)) == len(subjects)
            walls = place.apart
            many = len(subjects) if place.name == "wall" and len(subjects) >= len(walls) else 0
            to = [walls[i * len(walls) // many] if many else place for i in range(len(subjects))]
            pairs = zip(subjects, to, strict=True)  # "shelves on the left and right walls"
            found = [tuple(self._ways_at(a, at, on=on, share=share and not each, under=under)) for a, at in pairs]
            found = [ways[i : i + 1] for i, ways in enumerate(found)] if each else found
            some, asked = self._shared_by_walls(subjects, place, on=on, every=every)
            yield from asked
            found = [ways for a, ways in zip(subjects, found, strict=True) if a not in some]
            yield from (Demand(ways) for ways in found if ways)

    def _shared_by_walls(
        self, subjects: Sequence[str], place: Place, *, on: bool, every: bool
    ) -> tuple[Sequence[str], list[Demand]]:
        """Return which things are at several walls, and that they are: some at each, all of them where they are alike.

        So are "shelves on both long walls", "beds along the side walls", "eight chairs along two walls".
        """
        told = walls_meant(self.room, place) if place.name == "wall" else []
        two = place.plural and {"long", "short", "side"} & {grammar().walls.get(word) for word in place.words}
        few = len(told) if two or every else place.number or 0
        if not 1 < few <= min(len(subjects), len(told)):
            return (), []
        same = len({self._asset(a).size for a in subjects}) == 1
        some = subjects if same else subjects[:: len(subjects) // few][:few]
        shares = [i * few // len(some) for i in range(len(some))]
        doors = {one.wall for one in openings(self.room, "door")}
        chosen = sorted(combinations(told, few), key=lambda walls: sum(wall.index in doors for wall in walls))
        shared = [*zip(some, shares, strict=True)]
        ways = tuple(
            tuple(stated(self._held(a, on), AssetRef(a), WallRef(walls[i].index)) for a, i in shared)
            for walls in chosen
        )
        lines = [[a for a, i in shared if i == k] for k in range(few)]
        rows = [in_rows(line, 1) for line in lines if len(line) >= ways_of.CROWD and alike(self.scene, line)]
        return some, [Demand(ways), *rows]

    def _ways_at(self, a: str, place: Place, *, on: bool, share: bool, under: bool = False) -> Iterator[Way]:
        """Yield the ways in which one thing can be at a place of the room; `under` a window it stands at its wall."""
        ref, wider = AssetRef(a), 1.5 if share else 1.0
        if place.name == "wall":
            yield from self._ways_at_a_wall(a, place, on=on)
        elif place.name == "corner":
            for vertex in corners_meant(self.room, place):
                yield (self._in_corner(a, vertex), *self._across_from(vertex, self.cornered.get(a, "")))
        elif place.name in ("window", "door"):
            gap = (ways_of.AT_WINDOW if place.name == "window" else ways_of.AT_DOOR) * wider
            gap = max(gap, ways_of.NEAR) if a in self.surrounded else round(gap, 2)  # seats are between it and there
            under = under and self._asset(a).on_floor and not self._asset(a).is_flat
            for opening, point in zip(openings_meant(self.room, place), self._points(place), strict=True):
                held = (stated("against_wall", ref, WallRef(opening.wall)),) if under else ()
                further = 0.0 if place.name == "window" else ways_of.beyond_jambs(opening.width)
                yield (stated("near", ref, point, round(gap + further, 2)), *held)
            for opening in openings_meant(self.room, place) if a in self.cornered else ():
                ends = (opening.offset, opening.offset + opening.width)
                points = (floor_point(self.room.walls[opening.wall].point(end)) for end in ends)
                yield from ((stated("near", ref, point, ways_of.CORNER_BY),) for point in points)
                beside = corners_meant(self.room, Place("corner", by=("near", place)))  # however far that is
                yield from ((self._in_corner(a, vertex),) for vertex in beside)
        elif place.name == "middle":
            x0, y0, x1, y1 = self.room.bounds
            most = max(ways_of.LEAST_MIDDLE, ways_of.MIDDLE_SHARE * min(x1 - x0, y1 - y0)) * wider
            most = ways_of.EXACT if "exact" in place.words else round(most, 2)
            yield (stated("distance_constraint", ref, PointRef(*centre(self.room)), None, most),)
        elif place.name == "side":
            yield from self._ways_on_a_side(a, place)

    def _ways_on_a_side(self, a: str, place: Place) -> Iterator[Way]:
        """Yield the ways in which one thing is in a half of the room: before the board at the front, on its wall if it hangs."""
        boards = [one.name for one in self.scene.assets if self._is(one.name, small.BOARDS)]
        if "front" in place.words and boards and not self._only_wall(a):  # where all look, not the wall of the door
            aside = [word for word in ("left", "right") if word in place.words]
            yield from self._ways_at_the_front(AssetRef(a), boards, aside)
        elif boards[:1] and place.words in (("back",), ("rear",)) and not self._only_wall(a):
            for wall in self.room.walls:  # behind those who look there
                at = stated(self._held(boards[0], on=True), AssetRef(boards[0]), WallRef(wall.index))
                yield (at, stated("zone", AssetRef(a), half_aside(self.room, wall, "back")))
        elif self._only_wall(a) and len(place.words) == 1 and place.words[0] in grammar().walls:
            yield from self._ways_at_a_wall(a, replace(place, name="wall"), on=True)  # "a pegboard at the back"
        else:
            yield from ((stated("zone", AssetRef(a), half),) for half in halves_meant(self.room, place))

    def _in_corner(self, a: str, vertex: int) -> Relation:
        """Return that a thing is in a corner, about there where nothing of it can touch a wall."""
        if a in self.surrounded:
            return stated("near", AssetRef(a), floor_point(self.room.vertices[vertex]), ways_of.FREE_IN_CORNER)
        return stated("corner", AssetRef(a), vertex)

    def _across_from(self, vertex: int, other: str) -> Way:
        """Return that another thing, if there is one, is in the corner that is farthest from this one."""
        at = self.room.vertices
        far = max(convex_corners(self.room), key=lambda i: math.dist(at[i], at[vertex]))
        return (stated("corner", AssetRef(other), far),) if other else ()

    def _ways_at_the_front(self, ref: AssetRef, boards: Sequence[str], aside: Sequence[str]) -> Iterator[Way]:
        """Yield the ways in which a thing is before a board, and `aside` as seen by who looks at that."""
        for b in boards:
            before = stated("in_front_of", ref, AssetRef(b), 0.0, ways_of.AT_THE_FRONT)
            if not aside:
                yield (before,)
            for side, wall in product(aside, self.room.walls):
                at = stated(self._held(b, on=True), AssetRef(b), WallRef(wall.index))
                yield (before, at, stated("zone", ref, half_aside(self.room, wall, side)))

    def _too_many(self, subjects: Sequence[str], place: Place, *, on: bool, under: bool) -> bool:
        """Return whether things do not all have room under windows, or tables before those that they are along."""
        windows = openings_meant(self.room, place)
        wide = sum(self._asset(a).size[1] for a in subjects) > sum(window.width for window in windows) > 0
        many = len(subjects) > len(windows) > 0 and self._is(subjects[0], ("table",))
        return (under and wide) or (on and many)

    def _ways_along_windows(self, a: str, place: Place, *, under: bool) -> Iterator[Way]:
        """Yield the walls of windows, or strips of floor along them, for what is too much to stand before each."""
        for index in sorted({opening.wall for opening in openings_meant(self.room, place)}):
            wall = self.room.walls[index]
            inside = [wall.point(t, ways_of.ALONG) for t in (wall.length, 0.0)]
            strip = tuple(floor_point(at) for at in (wall.point(0.0), wall.point(wall.length), *inside))
            at = stated(self._held(a, on=False), AssetRef(a), WallRef(index))
            yield (at if under else stated("zone", AssetRef(a), strip),)

    def _ways_at_a_wall(self, a: str, place: Place, *, on: bool) -> Iterator[Way]:
        """Yield the ways in which a thing is at one of the walls that are meant and long enough, or in the middle of one."""
        backed = a in self.backed and self._is(a, ("counter",))  # "a bar on the left wall, with shelves behind it"
        if backed or self._is(a, ("reception desk",)) or a in self.hosting:  # with room for who sits behind it
            yield from self._ways_before_a_wall(a, place)
            return
        middle = "middle" in place.words
        hangs = self._held(a, on and not middle)
        walls = [wall for wall in walls_meant(self.room, place) if self._asset(a).size[1] <= wall.length]
        if len(walls) == len(self.room.walls) and not middle:
            yield (stated(hangs, AssetRef(a)),)
            return
        for wall in (WallRef(wall.index) for wall in walls):
            at = stated(hangs, AssetRef(a), wall)
            yield (at, stated("centered_on", AssetRef(a), wall)) if middle else (at,)

    def _ways_before_a_wall(self, a: str, place: Place) -> Iterator[Way]:
        """Yield the ways in which who sits at a thing has the back to a wall: behind a counter, before a desk's front."""
        angle = 270.0 if a in self.hosting else 90.0
        ref, most = AssetRef(a), round(self._asset(a).size[0] / 2 + ways_of.SEAT_BEHIND, 2)
        for wall in (WallRef(wall.index) for wall in walls_meant(self.room, place)):
            yield (stated("distance_constraint", ref, wall, None, most), stated("align_with", ref, wall, angle))

    def _ways_flanking(self, subjects: Sequence[str], place: Place) -> Iterator[Way]:
        """Yield the ways in which things are at both sides of a door or window, in turn."""
        for opening in openings_meant(self.room, place):
            at_wall = [stated(self._held(a, on=True), AssetRef(a), WallRef(opening.wall)) for a in subjects]
            for first in (0, 1):
                sides = (self._at_a_side(a, opening, i + first) for i, a in enumerate(subjects))
                yield tuple(said for held, at in zip(at_wall, sides, strict=True) for said in (held, *at))

    def _ways_beside(self, a: str, place: Place, side: str, more: float) -> Iterator[Way]:
        """Yield the ways in which a thing is to the left or right of a door or window, as one sees it from inside."""
        for opening in openings_meant(self.room, place):
            yield self._at_a_side(a, opening, ("left", "right").index(side), more)

    def _at_a_side(self, a: str, opening: Opening, side: int, more: float = 0.0) -> Way:
        """Return that a thing is near a door or window, or in a corner at its wall, in the half at its left or (odd numbers) its right."""
        wall, far = self.room.walls[opening.wall], sum(one.length for one in self.room.walls)
        (x, y), (dx, dy), (nx, ny) = wall.point(opening.center), wall.direction, wall.normal
        middle, (u, v), to = floor_point((x, y)), (x + far * nx, y + far * ny), -far if side % 2 else far
        half = (middle, *(PointRef(p + to * dx, q + to * dy) for p, q in ((x, y), (u, v))), PointRef(u, v))
        ref, most = AssetRef(a), round(opening.width / 2 + ways_of.BESIDE + more, 3)
        at_it = stated("near", ref, middle, most)
        there = stated("against_wall", ref, WallRef(opening.wall)) if a in self.cornered else at_it
        return (there, stated("zone", ref, half))

    def _ways_amidst(self, b: str, items: Sequence[str]) -> tuple[Way, ...]:
        """Return the ways in which something is between two that are deeper, at their wall, or hangs between two that stand."""
        shallow = self._asset(b).size[0] < min(self._asset(a).size[0] for a in items) / 2
        shallow = shallow and self._is(b, (*small.WATCHED, "console table")) and not self._only_wall(b)
        if any(map(self._only_wall, items)) or not (shallow or self._only_wall(b)):
            return ()
        one, two, amid = (AssetRef(name) for name in (*items, b))
        gap = ways_of.NEAR if self._is(items[0], small.SEATS) else ways_of.BESIDE
        said = (stated("near", one, amid, gap), stated("near", two, amid, gap), stated("between", amid, one, two))
        if not shallow:
            return (said,)  # plants on both sides of a painting
        walls = (WallRef(wall.index) for wall in self.room.walls)  # armchairs on both sides of a fireplace
        return tuple((*(stated("against_wall", a, w) for a in (amid, one, two)), *said) for w in walls)

    def _ways_amid(self, a: str, places: Sequence[Place]) -> Iterator[Way]:
        """Yield the ways in which a thing is between two doors or windows: at their wall, where some are in one wall."""
        both = [openings_meant(self.room, place) for place in places]
        pairs = list(product(*both)) if both[1:] else list(combinations(both[0], 2))
        beside = [(one, two) for one, two in pairs if one.wall == two.wall and one != two]
        for one, two in beside or pairs:
            ends = (floor_point(self.room.walls[opening.wall].point(opening.center)) for opening in (one, two))
            between = stated("between", AssetRef(a), *ends)
            held = () if self._asset(a).is_flat or self._asset(a).on_object else (self._held(a, on=True),)
            yield (between, *(stated(how, AssetRef(a), WallRef(one.wall)) for how in held if beside))

    def _points(self, place: Place | None) -> list[PointRef]:
        """Return the middles of doors, windows or walls on the floor, corners, or the middle of the room; none of no place."""
        if place is None or place.name in ("middle", "room"):
            return [PointRef(*centre(self.room))] * (place is not None)
        if place.name == "corner":
            found = [self.room.vertices[vertex] for vertex in corners_meant(self.room, place)]
        elif place.name in ("door", "window"):
            found = [self.room.walls[o.wall].point(o.center) for o in openings_meant(self.room, place)]
        else:
            found = [wall.midpoint for wall in walls_meant(self.room, place)] if place.name == "wall" else []
        return [floor_point(point) for point in found]

    def _turnedfrom(self, it: Asked) -> Iterator[Demand]:
        """Looking away from a thing, a wall, a door or a window; a desk as one does who sits at it."""
        block = len(it.others) > 2 and alike(self.scene, it.others)
        others = it.others[len(it.others) // 2 :][:1] if block else it.others  # "a desk facing away from the racks"
        for a in it.subjects:
            angle = 180.0 - self._looks(a)[0]
            square = tuple(self._squarely(a, it.place, [angle], free=True))
            for point in (*map(AssetRef, others), *self._points(it.place)):
                ways = [*square, (stated("point_towards", AssetRef(a), point, angle),)]
                if isinstance(point, AssetRef):  # somewhere behind who sits there
                    behind = "in_front_of" if ways_of.looks_over(self._asset(a)) else "behind"
                    ways.append((stated(behind, point, AssetRef(a), 0.0, ways_of.ACROSS),))
                yield Demand(tuple(ways))

    def _squarely(self, a: str, place: Place | None, angles: Sequence[float], *, free: bool = False) -> Iterator[Way]:
        """Yield how a thing, if not `free` in the middle or a corner, faces a door or window: straight to its wall, not askew.

        What faces the room looks straight from the wall in whose half of the room it stands.
        """
        for wall in self.room.walls if place is not None and place.name == "room" else ():
            half = stated("zone", AssetRef(a), half_at(self.room, wall))
            yield from (
                (stated("align_with", AssetRef(a), WallRef(wall.index), (90.0 + one) % 360.0), half) for one in angles
            )
        openings = openings_meant(self.room, place) if place is not None and place.name in ("door", "window") else ()
        for opening in openings if free or a in self.central or a in self.cornered else ():
            yield from (
                (stated("align_with", AssetRef(a), WallRef(opening.wall), (270.0 + one) % 360.0),) for one in angles
            )

    def _diagonal(self, it: Asked) -> Iterator[Demand]:
        """Turned by an eighth or three eighths from a wall."""
        for a in it.subjects:
            yield single(*(stated("align_with", AssetRef(a), WallRef(0), angle) for angle in ways_of.ASKEW))

    def _open(self, it: Asked) -> Iterator[Demand]:
        """The middle of the room stays free: each thing stands in one of the four strips around it."""
        x0, y0, x1, y1 = self.room.bounds
        x, y = centre(self.room)
        half = it.metres[0] or max(ways_of.LEAST_MIDDLE, ways_of.OPEN_SHARE * min(x1 - x0, y1 - y0))
        strips = ((x0, y0, x - half, y1), (x + half, y0, x1, y1), (x0, y0, x1, y - half), (x0, y + half, x1, y1))
        for a in it.subjects:
            yield single(*(stated("zone", AssetRef(a), rectangle(*strip)) for strip in strips))

    def _corner(self, it: Asked) -> Iterator[Demand]:
        yield from self._at_place(it.subjects, Place("corner"))

    def _middle(self, it: Asked) -> Iterator[Demand]:
        if it.place is not None and it.place.name == "wall":
            yield from self._at_place(it.subjects, replace(it.place, words=(*it.place.words, "middle")))
        elif not it.others:
            yield from self._at_place(it.subjects, Place("middle", (it.sided,)), share=len(it.subjects) > 1)

    def _atwalls(self, it: Asked) -> Iterator[Demand]:
        if it.place is not None:
            yield Demand(tuple(self._at_walls(it.subjects, it.others, it.place, on=True)))
