"""What a text asks of a new room, in kinds of the catalogue: counts, sizes by word, and the nearest room type."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import product

from robolayout._errors import SceneError
from robolayout._reading import LIMITS
from robolayout.assets import CATALOGUE, Category
from robolayout.assets.palette import LOOKS
from robolayout.constraints.in_shape import circle_across
from robolayout.planners._knowledge import DATA, Knowledge, Role
from robolayout.planners._room_type import room_meant
from robolayout.planners._seats import AT_ONE, OVAL_ENDS, SEATS, laid_across, promised, seats_of, sit_in_a_line
from robolayout.scene import FLAT_HEIGHT
from robolayout.words import (
    CROWD,
    KIN,
    OF_ROOMS,
    SHAPES,
    Lexicon,
    Link,
    NamedThing,
    Place,
    Reading,
    RoomType,
    RoomTypes,
    grammar,
    mentions,
    named,
    place_in,
    read_rooms,
    read_text,
    sized,
)

CARRIED = 0.5  # square metres of floor up to which a thing is put on another, where it is asked to stand there
FOOTLESS = 0.09  # metres up to which a thing stands out from a wall where it hangs there, not on its foot

Size = tuple[float, float, float]

UNITS, ONE_LOCKER = 4, 0.45  # lockers up to which each is a unit of several; metres of width of one alone
APART = 0.25  # metres between things that lie on a rug or sit in a line
LONGEST = 50.0  # metres of the longest thing that a room is furnished with
ELBOWS = 0.6  # metres of a table's edge for who sits there
ENDS = 2  # seats at the ends of a table, which stay free where all sit at its longer sides
APART_AT_TABLE = 0.03  # metres between seats that are wider
FOR_TWO = 0.8  # metres of a table for two
LEAST_HUNG, HUNG_APART = 0.4, 0.06  # metres that several things over one are wide at least, and between them
BESIDE_A_DOOR = 1.5  # metres of a wall that are left of it where things of which no number is said stand along it
LIKE = ({"chair", "theater seat"}, {"shelving unit", "pallet rack"}, {"computer", "monitor"})
"""Kinds that stand for each other where nothing says how many there are: chairs in an auditorium are as many as its seats."""
BENCHES = 2  # benches of a table where neither is counted
IN_A_SHAPE = 6  # things in a circle, a half circle or a U of which no number is said

LARGEST = 8.0  # how many times as large as usual a room is up to which the number of its zones and people grows
INSTEAD: Mapping[str, str] = DATA["instead"]
LOW, SMALL, GENERAL, SIZE_WORDS, VAGUE = (
    (*DATA["nouns"][name],) for name in ("low", "small", "general", "sizes", "vague")
)


def head(name: str) -> str:
    """Return the word that says what a thing is: "bed" for a bunk bed."""
    last = name.split()[-1]
    return KIN.get(name, INSTEAD.get(name, name if last in VAGUE else last))


@dataclass(frozen=True)
class RoomWishes:
    """What a text asks of a new room."""

    reading: Reading  # what it says
    room: RoomType  # the room type: as named, else the nearest one
    guesses: tuple[str, ...]  # what was guessed, one sentence each
    rooms: RoomTypes  # the room types and bodies that are known
    lexicon: Lexicon  # the kinds of things that are known
    roles: Mapping[str, Role]  # what things are for, by the names of things
    meshes: Collection[str] = ()  # names of the kinds of which there is a mesh of the user's own, which keeps its size

    @property
    def agent(self) -> str | None:
        """The body that is said, else the one that is usual in such a room; None for the default disc."""
        return self.reading.agent or self.room.agent

    @cached_property
    def things(self) -> Mapping[str, int]:
        """What is wished, and how many."""
        wished, cosy = self._counted(implied=False), grammar().cosy
        if set(self.reading.words_of_taste) & set(cosy["words"]):  # something soft, a warm light
            rows = [row for row in (cosy["soft"], cosy["warm"]) if not set(wished) & set(row)]
            wished.update(kind for row in rows for kind in [k for k in row if k not in self.reading.unwanted][:1])
        return dict(wished)

    @property
    def implied(self) -> Mapping[str, int]:
        """What belongs in parts of the room that are named, and how many: of what is usual, as many as are usual."""
        found = self._counted(implied=True)
        return {name: max(count, self.room.base.get(name, 0)) for name, count in found.items()}

    def _counted(self, *, implied: bool) -> Counter[str]:
        wished = Counter[str]()
        for thing in (one for one in self.reading.parsed.things if one.implied == implied):
            wished[self._shown(thing)] += thing.count
        return wished

    @cached_property
    def kinds(self) -> Mapping[str, Category]:
        """All kinds of things, those of the user's own too, as they were first asked for: other words, other sizes."""
        shared = (self.lexicon.kinds[name] for name in self.room.base if self._shared(name) and name not in self.meshes)
        people = self.reading.people
        usual = {kind.name: replace(kind, size=self._seating(kind.name, kind.size, people)) for kind in shared}
        return {**self.lexicon.kinds, **usual, **{kind.name: kind for kind in reversed(self.asked.values())}}

    @cached_property
    def asked(self) -> dict[NamedThing, Category]:
        """The kind of each thing that is named, with its name and size, and as it is where it is asked to be."""
        return {thing: self._as_wished(thing) for thing in self.reading.parsed.things}

    @property
    def times_usual(self) -> float:
        """How many times as large as usual the room is said to be, 1 where nothing is said."""
        usual, area = math.prod(self.room.size), self.reading.measure("area")
        asked = math.prod(self.reading.size) if self.reading.size else area[0] if area else self.reading.scale * usual
        return min(asked / usual, LARGEST)

    def floor(self, size: tuple[float, float]) -> float:
        """Return the floor in m2 of the room with a width and depth in metres."""
        return size[0] * size[1] * (0.75 if self.reading.shape == "L-shaped" else 1.0)

    def floor_area(self, things: Mapping[str, int]) -> float:
        """Return the floor in m2 that things take."""
        kinds = ((self.kinds[name], count) for name, count in things.items())
        standing = (pair for pair in kinds if pair[0].on_floor and pair[0].size[2] > 0.03)
        return sum(kind.size[0] * kind.size[1] * count for kind, count in standing)

    def head(self, name: str) -> str:
        """Return the word that says what a thing is, by what it is like."""
        return head(self.kinds[name].like or name)

    def role(self, name: str) -> Role | None:
        """Return what a thing is for, None where no role says so."""
        return self.roles.get(self.kinds[name].like or name)

    def playing(self, names: Iterable[str]) -> dict[str, Role]:
        """Return what things are for, those of which no role says so aside."""
        return {name: role for name in names if (role := self.role(name)) is not None}

    def useless(self, name: str, present: Collection[str]) -> bool:
        """Return whether a thing belongs at others of which none is there: a chair without a table, a candlestick without a top."""
        borne = self.kinds[name].places == ("object",)
        if borne and not any(role.top for role in self.playing(present).values()):
            return True
        role = self.role(name)
        wanted = {other for join in role.joins if not join.loose for other in join.of} if role else set[str]()
        there = {self.roles[other].name for other in present if other in self.roles}
        return bool(wanted - {"*"}) and (borne or "*" not in wanted) and not wanted & there

    def told(self, name: str) -> list[NamedThing]:
        """Return what was asked for of a category, once for each of it: "a low table and two high ones" are three."""
        return [thing for thing, kind in self.asked.items() if kind.name == name for _ in range(thing.count)]

    def placed(self, thing: NamedThing) -> bool:
        """Return whether a thing is asked to be at a place of the room."""
        links = (k for k in self.reading.parsed.links if thing in named(k.subjects) and k.relation != "cleared")
        return any(isinstance(item, Place) for link in links for item in link.objects)

    @cached_property
    def audience(self) -> set[NamedThing]:
        """The seats of which a crowd looks at something, and nothing else is told than its rows."""
        links = self.reading.parsed.links
        facing = (k for k in links if k.relation == "facing" and not any(to.several for to in mentions(k.objects)))
        looking = {one.thing for k in facing for one in k.subjects if one.sat_on}
        told = {thing for k in links if k.relation not in ("facing", "rows") for thing in named(k.subjects)}
        return {thing for thing in looking - told if thing.count >= CROWD}

    @property
    def general(self) -> frozenset[str]:
        """Nouns that say no more than one word ("lamp"): nothing more of that name is added."""
        said = [thing for thing in self.reading.parsed.things if not thing.implied]
        return frozenset(t.noun.said for t in said if " " not in t.noun.said and not (t.adjectives or t.of_pet))

    @property
    def seats(self) -> int:
        """Seats that are promised: at each of "five tables for four", at all "tables for 14 people" together."""
        return round(sum(promised(thing) * thing.count for thing in self.reading.parsed.things))

    @property
    def ignored(self) -> tuple[str, ...]:
        """Words without a meaning here."""
        parsed = self.reading.parsed
        spoken = [(chunk.start, chunk.end) for chunk in parsed.missed]
        unknown = [thing for thing in parsed.things if thing.noun.kind.startswith("unknown")]
        spoken += [(t.spans[0][1] - len(t.noun.said.split()), t.spans[0][1]) for t in unknown]
        return tuple(self.reading.span(*span) for span in sorted(spoken))

    def kind(self, thing: NamedThing) -> str:
        """Return which kind a thing is: where its one word is general, what is usual in the room.

        A desk of a classroom is a student desk. A chair at a table, at a wall or by the door is only what people there sit on.
        """
        said = [word for word in thing.noun.said.split() if word not in SIZE_WORDS]
        room, kind = self.room, thing.noun.kind
        told = {*thing.adjectives}.difference(SIZE_WORDS, LOOKS, grammar().sizes)
        if len(said) != 1 or said[0] not in GENERAL or thing.noun.guessed or told or _rounded(thing):
            return kind
        (word,), links = said, self.reading.parsed.links
        at = [item for link in links if thing in named(link.subjects) for item in link.objects]
        nouns = [item.thing.noun for item in mentions(at)]  # the station of a salon is no table to sit at
        tables = {word.split()[-1] for n in nouns for word in (n.said, n.said if n.said in OF_ROOMS else n.kind)}
        elsewhere = "table" in tables or len(nouns) < len(at)
        usual = () if word == "chair" and elsewhere else (*room.base, *room.extras)
        items = [*([room.tables] if room.tables else []), *room.person, *usual]
        if word in items or (word in CATALOGUE and kind != word):
            alone = thing.times > 1 or {*DATA["nouns"]["young"]} & {word.text for word in self.reading.words}
            return "single bed" if kind == "bed" and alone else kind  # "two children, each with a bed"
        low = LOW if thing.sat_at or thing.people else ()
        fits = [name for name in items if name.split()[-1] == word and name.split()[0] != word and name not in low]
        others = {one.noun.kind for one in self.reading.parsed.things if one is not thing}
        fits = [name for name in fits if name not in others or word != "desk"]  # "a counter, and two desks" in a bank
        if thing.noun.said == "small table":  # in a game room no pool table, beside a sofa no coffee table
            fits = [name for name in fits if name in (*LOW, *SMALL) and (thing.noun.others or kind not in LOW)]
            fits = fits or [name for name in (room.tables,) if name in SMALL and not nouns]  # in a cafe, by the window
        # a shelf above a desk is none that stands
        hung = frozenset[str]() if thing.category.on_floor else {*thing.category.places}
        return next((name for name in fits if not hung or hung & {*self.lexicon.kinds[name].places}), kind)

    def _shown(self, thing: NamedThing) -> str:
        """Return the category under which a thing stands in the scene: its own words where no kind of that name is known."""
        name = self.kind(thing)
        return thing.noun.words if thing.noun.kind == name and thing.noun.words not in self.lexicon.kinds else name

    def _as_wished(self, thing: NamedThing) -> Category:
        """Return the kind of a thing with its name and size, and as it is where it is asked to be."""
        name, shown = self.kind(thing), self._shown(thing)
        kind = self.lexicon.kinds[name]
        told = {"square", *(SIZE_WORDS if name != thing.noun.kind else ())} & {*thing.noun.said.split()}
        on = (k.objects for k in self.reading.parsed.links if k.relation == "on" and thing in named(k.subjects))
        told |= {"tabletop" for to in on for at in mentions(to) if not at.flat}
        if name in self.meshes:
            size = sized(kind, (), thing.sizes)
        else:
            said = (*thing.of_all, *told)
            size = self._large_enough(thing, sized(kind, said, thing.sizes, thing.noun.said))
            size = size if thing.sizes else self._side_by_side(thing, size)
        if not all(0.0 < side <= LONGEST for side in size):
            shape = f"{' x '.join(f'{side:g}' for side in size)} m"
            raise SceneError(f"a {shown} of {shape} cannot be placed; give it sides above 0 and at most {LONGEST:g} m.")
        like = name if shown != name else ""
        return self._as_placed(thing, replace(kind, name=shown, like=kind.like or like, size=size))

    def _as_placed(self, thing: NamedThing, kind: Category) -> Category:
        """Return a kind as it is where it is asked to be: on a thing, under the ceiling, flat on a wall, on one of its own."""
        for link in self.reading.parsed.links:
            if thing not in named(link.subjects):
                continue
            to = [self.lexicon.kinds[at.thing.noun.kind] for at in mentions(link.objects[:1])]
            places = {item.name for item in link.objects if isinstance(item, Place)}
            built = kind.built_in and any(at.name.endswith(("counter", "island")) for at in to)
            small = kind.size[0] * kind.size[1] < CARRIED and not built
            if link.relation == "on" and small and any(bearer.size[2] >= FLAT_HEIGHT for bearer in to):
                kind = replace(kind, on_object=True, on_wall=False, on_ceiling=False, on_floor=False)
            if link.relation == "on" and to and all(bearer.size[2] < FLAT_HEIGHT for bearer in to) and kind.on_object:
                kind = replace(kind, on_floor=True, on_object=False)  # toys on a rug
            if "ceiling" in places and not kind.on_ceiling:
                kind = replace(kind, on_ceiling=True, on_floor=False, on_wall=False, on_object=False)
            if link.relation in ("on", "atwalls") and "wall" in places and kind.on_wall and kind.on_object:
                kind = replace(kind, on_object=False, size=(min(kind.size[0], FOOTLESS), *kind.size[1:]))
            if link.relation == "stacked":
                kind = replace(kind, on_object=True)
        return kind

    def _side_by_side(self, thing: NamedThing, size: Size) -> Size:
        """Return the size of one of several that hang over a thing, narrow enough for all of them in a row or two."""
        links = (k for k in self.reading.parsed.links if k.relation == "above" and thing in named(k.subjects))
        over = [self.lexicon.kinds[at.thing.noun.kind].size[1] for k in links for at in mentions(k.objects[:1])]
        if not over or "wall" not in thing.places or thing.count < 2:
            return size
        in_a_row = sorted({thing.count, max(2, math.ceil(thing.count / 2))}, reverse=True)
        shares = (min(over) / count - HUNG_APART for count in in_a_row)
        share = next((share for share in shares if share >= LEAST_HUNG), size[1])
        return (size[0], round(min(size[1], share), 2), size[2])

    def _large_enough(self, thing: NamedThing, size: Size) -> Size:
        """Return the size of a thing with room for what is to lie on it, where it is a rug, or to sit before it in a line."""
        depth, width, height = size
        said = self.reading.parsed
        links = [link for link in said.links if thing in named(link.objects)]
        led = {one for link in said.links for one in named(link.subjects)}
        loose = [("with", one) for one in said.things if one.noun.kind == "bar stool" and one not in led]
        for relation, other in [*((link.relation, one.thing) for link in links for one in link.subjects), *loose]:
            kind, each = other.noun.kind, other.count / thing.count
            own = self.lexicon.kinds[self.kind(other)].size
            across = self.ring(other, thing) if relation == "on" else 0.0
            if across:
                depth, width = max(depth, across), max(width, across)
            elif relation == "on" and height < FLAT_HEIGHT:
                times = math.sqrt(max(1.0, each * (max(own[:2]) + APART) ** 2 / (depth * width)))
                depth, width = round(depth * times, 2), round(width * times, 2)
            elif sit_in_a_line(thing, relation, kind, each):
                width = round(max(width, each * (own[1] + (APART if kind.endswith(SEATS) else APART / 2))), 2)
        width = min(width, ONE_LOCKER) if thing.head == "locker" and thing.count > UNITS else width
        if thing.sizes or not thing.noun.kind.endswith("table"):
            return depth, width, height
        name = thing.noun.said if "oval" in thing.noun.said else thing.noun.kind
        seats = math.ceil(seats_of(thing, links)) or self._everyone(thing, links)
        sided = {link.sided for link in links} - {""}
        seats += ENDS if sided and "end" not in sided and thing.sides == 2 else 0
        told = {*thing.adjectives} & {*grammar().sizes}  # a long table for two stays long
        return size if told and seats <= 2 else self._seating(name, size, seats, laid_across(links, seats))

    def ring(self, seat: NamedThing, rug: NamedThing) -> float:
        """Return the metres across a ring of seats on each rug; 0 for fewer than three, and for what stands in none."""
        role, each = self.roles.get(seat.noun.kind), math.ceil(seat.count / rug.count)
        if role is None or not role.in_a_ring or each < 3 or rug.category.size[2] >= FLAT_HEIGHT:
            return 0.0
        depth, width, _ = self.lexicon.kinds[seat.noun.kind].size
        return round(circle_across(each, depth, width) + max(depth, width), 2)

    def rings(self, links: Iterable[Link]) -> list[float]:
        """Return the metres across all rings of seats that links put on rugs."""
        on = (link for link in links if link.relation == "on")
        pairs = (pair for link in on for pair in product(named(link.subjects), named(link.objects)))
        return [across for seat, rug in pairs if (across := self.ring(seat, rug))]

    def _everyone(self, thing: NamedThing, links: Sequence[Link]) -> int:
        """Return how many sit at the only table that is named: all who are in the room, or as many as have a chair."""
        things = self.reading.parsed.things
        heads = [head(one.noun.kind) for one in things]
        low = thing.noun.kind in LOW
        if low or thing.count > 1 or heads.count("table") > 1 or {"desk", "counter", "island"} & {*heads}:
            return 0
        chairs = [one for one in things if head(one.noun.kind) == "chair"]
        seated = {one for link in links for one in named(link.subjects)}  # others in rows look at a lectern
        there = sum(one.count for one in chairs if one in seated or not one.rows)
        return (self.reading.people if self._shared(self.kind(thing)) else 0) or there

    def _seating(self, name: str, size: Size, seats: int, across: float = 0.0) -> Size:
        """Return the size of a table with a place for so many: a larger one that is as deep as wide, else a longer one.

        A round one is so many metres `across` at least.
        """
        depth, width, height = size
        if 0 < seats <= 2 and name == "dining table" and depth != width:
            return depth, min(width, FOR_TWO), height
        chairs = [self.lexicon.kinds[one].size[1] for one in self.room.person if head(one) == "chair"]
        elbows = max([ELBOWS, *(chair + APART_AT_TABLE for chair in chairs)])
        if seats and depth == width and "oval" not in name:
            depth = width = max(depth, round(seats * elbows / math.pi, 2), across)
            if name == "round table":
                return depth, width, height
        width = max(width, across + OVAL_ENDS) if across and "oval" in name else width
        while 2 * int(width / elbows) + 2 * min(int(depth / elbows), 1 if depth != width else seats) < seats:
            width = round(width + elbows / 2, 2)
        return depth, width, height

    def _shared(self, name: str) -> bool:
        """Return whether all who are in the room sit at such a table: it has one, and seats but no desks of their own."""
        own = {head(one) for one in self.room.person}
        return name.endswith("table") and name in self.room.base and own == {"chair"} and not self.room.tables


def read_wishes(text: str, own: Knowledge, meshes: Mapping[str, Category]) -> RoomWishes:
    """Return what a text asks of a new room; one that is empty, or names neither a room nor a thing, is refused.

    `meshes` are the kinds of which there is a mesh of the user's own, by name.
    """
    if not text.strip():
        raise SceneError('the sentence is empty; say for example "a bedroom for two with a desk, 4 x 5 m".')
    if len(text) > LIMITS.text:
        raise SceneError(f"the sentence has {len(text)} characters; say it in at most {LIMITS.text}.")
    rooms = read_rooms(own.rooms.values())
    lexicon = Lexicon(rooms, (*meshes.values(), *own.things.values()))
    reading = read_text(text, lexicon)
    room, guesses = room_meant(reading, rooms)
    guesses += [
        f"{thing.noun.words!r} was taken as {thing.noun.kind}, {thing.noun.guessed}."
        for thing in reading.parsed.things
        if thing.noun.guessed and not thing.noun.kind.startswith("unknown")
    ]
    wishes = RoomWishes(reading, room, tuple(guesses), rooms, lexicon, own.playing, meshes.keys() - own.things.keys())
    things = reading.parsed.things
    sat_on = [one for one in things if one.head in ("chair", "bench") and one.plural]
    chairs = [one for one in sat_on if one.number is None and not one.bound]
    for thing in things:
        _settle_number(thing, wishes)
    _settle_seats(chairs, wishes)
    return wishes


def _settle_seats(chairs: Sequence[NamedThing], wishes: RoomWishes) -> None:
    """Settle how many chairs there are that are only named: "desks and chairs" are one for each desk, as many as sit at each table."""
    things, room = wishes.reading.parsed.things, wishes.room
    tops = [one for one in things if one.head == "desk" or one.noun.kind in SMALL]
    tops = [one for one in tops if one.plural or (room.tables and one.head == "table")]
    for thing in chairs if len(tops) == 1 else ():
        each = 1 if tops[0].head == "desk" else BENCHES if thing.head == "bench" else room.at_table
        usual = tops[0].count * each
        thing.number = max(1, usual // thing.times) if usual > 1 and not wishes.placed(thing) else thing.number


def _settle_number(thing: NamedThing, wishes: RoomWishes) -> None:
    """Settle how many there are where a plural says no number: what the people of such a room usually have, no table for a crowd."""
    if not thing.uncounted or thing.bound:
        return
    name, room, people = wishes.kind(thing), wishes.room, wishes.reading.people or wishes.room.people
    if thing.people > AT_ONE:  # "tables for twenty": small ones in a cafe, large ones elsewhere
        thing.number = math.ceil(thing.people / (room.at_table if name == room.tables else AT_ONE))
        thing.people = math.ceil(thing.people / thing.number)
        return
    at_tables = name == room.tables or (room.tables and {name, room.tables} <= {*SMALL})
    brought = math.ceil(people / (thing.people or room.at_table)) if at_tables else _usual(name, room.person) * people
    # "chairs along the wall" of a classroom are some of them
    some = wishes.placed(thing) and len(room.person) > 1 and name.endswith(SEATS)
    brought = 0 if some else brought
    about = [link for link in wishes.reading.parsed.links if thing in named(link.subjects)]
    round_it = [link for link in about if link.relation == "around" and not any(one.sat_on for one in link.subjects)]
    formed = [IN_A_SHAPE for link in about if link.relation in SHAPES or link in round_it]
    formed += [2 * link.rows for link in about if link.relation == "groups"]  # "armchairs in groups of three"
    walls = [to for link in about if (to := place_in(link.objects, "wall")) is not None and to.at_one_wall]
    usual = max(brought, *(formed or [_usual(name, room.base)]))
    usual = min(usual, int((max(room.size) - BESIDE_A_DOOR) / wishes.kinds[name].size[1])) if walls else usual
    thing.number = usual if usual > thing.count and usual % max(thing.rows, 1) == 0 else None


def _usual(name: str, counts: Mapping[str, int]) -> int:
    """Return how many there usually are of a kind, or of the one that stands for it."""
    return max((counts.get(kind, 0) for kind in next((like for like in LIKE if name in like), {name})), default=0)


def _rounded(thing: NamedThing) -> bool:
    """Return whether a thing is said to be round, and is of a kind that is: "a round wooden table"."""
    return "round" in thing.of_all and thing.noun.kind.startswith("round")
