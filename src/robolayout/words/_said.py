"""What a text says, as the parser notes it: things, mentions of them, places of the room, relations."""

from __future__ import annotations

from collections.abc import Iterable, Sequence, Set
from dataclasses import dataclass, field, replace

from robolayout.assets import Category
from robolayout.assets.palette import COLORS, LOOKS
from robolayout.scene import FLAT_HEIGHT
from robolayout.words import _function_words as small
from robolayout.words._chunk import Chunk, Framed
from robolayout.words._function_words import COMPASS, IN_PAIRS
from robolayout.words._lexicon import Noun, grammar
from robolayout.words._tokens import Measure

LONG = 3
"""Things of a row of which no number is said."""

SEATED = 6
"""Seats of each of more rows than that of which no number is said."""

PARTITIONS = ("partition", "privacy screen", "room divider", "curtain")
"""What parts one place from the next."""


@dataclass(eq=False)
class NamedThing:
    """One kind of thing that is named, and how many of it."""

    noun: Noun  # what it is
    number: int | None = None  # its count, if one is said
    bound: str = ""  # "", "least", "most", "more" or "vague"
    plural: bool = False  # whether it is named in the plural
    adjectives: tuple[str, ...] = ()  # words that were said of it
    spans: list[tuple[int, int]] = field(default_factory=list[tuple[int, int]])  # token spans in which it is named
    times: int = 1  # how many times over it is asked for ("each with")
    rows: int = 0  # rows that it stands in, 0 if none are said
    definite: bool = False  # whether it was first named with "the"
    people: int = 0  # seats that its words promise ("for six")
    everyones: bool = False  # whether each of the people there has as many ("for two children with a desk each")
    of_pet: bool = False  # whether it is said to be for one ("a bed for the cat")
    implied: bool = False  # whether only the part of the room is named to which it belongs ("a reading corner")
    sat_at: bool = False  # whether it is said to have chairs, or these to be around it
    sizes: list[Measure] = field(default_factory=list[Measure])  # what is said of its size in figures
    told: list[str] = field(default_factory=list[str])  # words of taste that were said of it later ("the bed is brown")
    within: NamedThing | None = None  # what it was named with as what that has in it

    @property
    def promising(self) -> bool:
        """Whether it is said to have seats around it."""
        return self.sat_at or self.people > 0

    @property
    def head(self) -> str:
        """The last word of its kind: "table" of a coffee table."""
        return self.noun.kind.split()[-1]

    @property
    def category(self) -> Category:
        """Its kind, of the catalogue or of the user's own."""
        return self.noun.category

    @property
    def places(self) -> tuple[str, ...]:
        """Where it can be: some of "floor", "wall", "ceiling", "object"."""
        return self.category.places

    @property
    def hangs(self) -> bool:
        """Whether some kind that its noun means hangs."""
        return any(kind.on_wall or kind.on_ceiling for kind in self.noun.categories)

    @property
    def look(self) -> tuple[str, ...]:
        """What is said of its colour, material and style, in words that can be drawn."""
        return tuple(word for word in (*self.adjectives, *self.told) if word in LOOKS)

    @property
    def phrase(self) -> tuple[str, ...]:
        """The words of the noun phrase that named it."""
        return (*self.adjectives, *self.noun.said.split())

    @property
    def of_all(self) -> tuple[str, ...]:
        """What is said of all of it: before its noun, or later if it is one ("the coffee table should be round")."""
        return (*self.adjectives, *(self.told if self.count == 1 else ()))

    @property
    def count(self) -> int:
        """How many are asked for: as said, else two for a plural, so many for each row that is told, else one; so many times over."""
        row = SEATED if self.rows > LONG and self.head in ("chair", "seat") else LONG
        alone = {self.noun.kind, self.noun.said} & IN_PAIRS
        usual = max(2, row * self.rows) if self.plural and not alone else 1
        one = usual if self.number is None else self.number + (self.bound == "more")
        return one * self.times

    @property
    def has_sides(self) -> bool:
        """Whether it is a table with people on each side of it."""
        return self.head in ("table", "island") and not self.noun.kind.endswith(tuple(small.LOW_TABLES))

    @property
    def uncounted(self) -> bool:
        """Whether there are several and nothing says how many."""
        return self.plural and self.number is None and self.times == 1

    @property
    def parts_uncounted(self) -> bool:
        """Whether it is what parts one place from the next, and no number of it is said."""
        return self.uncounted and self.noun.kind in PARTITIONS

    @property
    def sides(self) -> int:
        """At how many sides of it "each side" is: of a square table at all four."""
        return 4 if "square" in self.phrase else 2

    def same(self, chunk: Chunk) -> bool:
        """Return whether a noun phrase may mean this thing, which was named before."""
        if chunk.noun is None:
            return False
        old, new = self.noun.said.split(), chunk.noun.said.split()
        if old == new:
            return True
        if chunk.plural and not chunk.det and old[-1] != new[-1]:
            return False  # "four racks in the middle, shelves along the walls"
        if old[-1] == new[-1]:
            return len(new) == 1 or len(old) == 1 or self.noun.kind == chunk.noun.kind
        if old[-1].endswith(new[-1]) and len(new) == 1:
            return True  # "the board" of a whiteboard, but an ironing board is no cupboard
        return self.noun.kind == chunk.noun.kind

    def same_words(self, chunk: Chunk) -> bool:
        """Return whether a noun phrase has the very noun of this thing."""
        return chunk.noun is not None and self.noun.said == chunk.noun.said

    def differs(self, chunk: Chunk) -> bool:
        """Return whether a colour or a size of a noun phrase excludes that of this thing: "the red chair" is no blue one."""
        said, new, sizes = {*self.adjectives, *self.told}, {*chunk.adjectives}, grammar().sizes
        sized = (zip(sizes[a], sizes[b], strict=True) for a in said & sizes.keys() for b in new & sizes.keys())
        opposed = any((a - 1) * (b - 1) < 0 for pair in sized for a, b in pair)
        return opposed or bool(said & COLORS.keys() and new & COLORS.keys() and not said & new)


def take(thing: NamedThing, kind: str) -> None:
    """Take a thing for one of a kind, whatever else its noun means."""
    thing.noun = replace(thing.noun, words=kind, kind=kind, others=())


@dataclass(frozen=True, eq=False)
class Mention:
    """A thing where it is named."""

    thing: NamedThing
    pick: slice | None = None  # which of several; None is all of them
    det: str = ""  # the article

    @property
    def count(self) -> int:
        """How many are meant."""
        return self.thing.count if self.pick is None else self.pick.stop - self.pick.start

    @property
    def one(self) -> bool:
        """Whether "it" can stand for this: one thing, said in the singular ("hooks" are several)."""
        hooks = self.thing.plural or (not self.det and self.thing.noun.kind.endswith("hooks"))
        return self.thing.count == 1 and not hooks

    @property
    def several(self) -> bool:
        """Whether more than one is meant."""
        return self.count > 1

    @property
    def walled(self) -> bool:
        """Whether it stands at a wall, as people furnish, or hangs on one."""
        return self.thing.head in small.AT_WALLS or self.opens or self.thing.places == ("wall",)

    def admits(self, relation: str, about: Sequence[Mention]) -> bool:
        """Return whether people put something so to it: nothing behind a fridge or beside a rug, lamps over tables alone."""
        bears = self.thing.head in (*small.TOPS, *small.BEARING)
        if about and all(one.thing.places == ("ceiling",) for one in about):
            return bears
        beside = relation in (*small.AT_SIDES, "behind")
        under = relation == "under" and self.thing.head in small.SEATS
        # "a tray under the bench and hooks above it", "a floor lamp beside the sofa and a painting above it"
        under = under or (relation == "above" and (self.topped or self.slender))
        return not (under or (beside and self.flat) or (relation == "behind" and self.opens and not bears))

    @property
    def opens(self) -> bool:
        """Whether it has doors or drawers, so that it stands at a wall."""
        return self.thing.category.open_depth > 0

    @property
    def flat(self) -> bool:
        """Whether it lies on the floor and others stand on it."""
        return self.thing.category.size[2] < FLAT_HEIGHT

    @property
    def slender(self) -> bool:
        """Whether it stands on the floor, more than twice as high as it is wide, and stores nothing: nothing hangs above a floor lamp."""
        kind = self.thing.category
        return kind.places == ("floor",) and not self.opens and kind.size[2] > 2 * max(kind.size[:2])

    @property
    def laid(self) -> bool:
        """Whether it can stand on another thing and not on the floor."""
        return "object" in self.thing.places and "floor" not in self.thing.places

    @property
    def topped(self) -> bool:
        """Whether it can stand nowhere but on another thing."""
        return self.thing.places == ("object",)

    @property
    def can_be_on_a_top(self) -> bool:
        """Whether some kind that its noun means can stand on another thing: a clock, a statue."""
        return any(kind.on_object for kind in self.thing.noun.categories)

    @property
    def sat_on(self) -> bool:
        """Whether one sits on it."""
        return self.thing.head in small.SEATS

    @property
    def at_a_table(self) -> bool:
        """Whether it is a seat of which several stand at one side of a table."""
        return self.thing.head in ("chair", "stool", "bench", "seat")

    def per_side(self, chunk: Chunk, place: Place | None = None, *, own: bool = False) -> bool:
        """Return whether a number is said of one side: "four chairs on each side", while "two lamps on each side" are two.

        It is also where each of several has its `own`: "four desks, each with a chair on both sides".
        """
        each = place.det == "each" if place else "each" in chunk.adjectives
        one = (self.thing.number or 1 + self.thing.plural) == 1 and chunk.value == "flank"
        each = each or ("either" in chunk.adjectives and (self.thing.number or 0) > 2)
        told = one or (each and self.at_a_table and self.thing.number is not None)
        return told and (self.thing.times == 1 or own) and self.pick is None

    def widened(self, count: int) -> Mention:
        """Return one of several things as so many of them: "one lamp is next to each sofa"."""
        if self.pick is None or self.pick.start + count > self.thing.count:
            return self
        return Mention(self.thing, slice(self.pick.start, self.pick.start + count), self.det)


@dataclass(frozen=True)
class Place:
    """A place of the room where it is named: a wall, a corner, a window, a door, the middle."""

    name: str  # which kind of place
    words: tuple[str, ...] = ()  # words that say which one
    number: int | None = None  # how many, if said
    plural: bool = False  # whether several are meant
    det: str = ""  # the article
    by: tuple[str, Place] | None = None  # for a wall: what says which one ("opposite the door"), with the relation
    opening: Framed | None = None  # what is said of a door or window besides its wall

    @property
    def apart(self) -> list[Place]:
        """Return it once for each of several that are named: "the north and west walls" are two."""
        return [replace(self, words=(*words.split(),)) for words in " ".join(self.words).split(" and ")]

    @property
    def at_one_wall(self) -> bool:
        """Whether all of several things are at one wall, whichever it is: "one wall", "the long wall"."""
        one = len(self.apart) == 1 and self.det in ("a", "the", "one") and not self.plural
        return self.name == "wall" and (
            self.number == 1 or (one and (self.by is not None or not {*self.words} <= {"middle"}))
        )


Item = Mention | Place
"""What a relation is about or leads to."""


@dataclass(frozen=True, eq=False)
class Link:
    """A relation that is asked for."""

    relation: str  # its name in the word list
    subjects: tuple[Mention, ...]  # what stands so
    objects: tuple[Item, ...]  # what it stands to
    start: int  # first token
    end: int  # token after the last one
    # least and most metres that lie between, where that is said
    metres: tuple[float, float] = (0.0, 0.0)
    rows: int = 0  # rows or columns that are said, 0 if none are
    sided: str = ""  # at which sides of a table seats are in equal shares: "each", "long" or "end", if that is said
    topmost: bool = False  # whether it is said of the top of a thing, not of its shelves
    level: int = 0  # which of its shelves that is, from below, or -1 for the highest one; 0 for any
    elided: bool = False  # whether the words leave it out: "the left desk has a lamp, the right one a vase"

    @property
    def shelves(self) -> bool:
        """Whether what it puts somewhere goes onto the shelves there: into a thing, or on what is called a shelf."""
        bearers = named(self.objects)
        shelf = all(bearer.noun.said.split()[-1] in small.SHELVES for bearer in bearers)
        within = self.relation == "in" and all(bearer.head not in small.SEATS for bearer in bearers)
        within = within or (self.relation == "with" and {bearer.noun.kind for bearer in bearers} == {"bookshelf"})
        return (within or (self.relation in ("on", "with") and shelf)) and not self.topmost

    def had(self, own: Set[NamedThing], to: Set[NamedThing] | None) -> bool:
        """Return whether it only says that one of some things has a thing (any, for None)."""
        has = to is None or bool(named(self.objects) & to)
        return has and self.relation == "with" and self.subjects[0].thing in own


@dataclass(eq=False)
class Parsed:
    """Everything that a text says."""

    things: list[NamedThing] = field(default_factory=list[NamedThing])  # in the order in which they are named
    links: list[Link] = field(default_factory=list[Link])  # relations, in order
    # nouns that must not be there, with their spans
    refused: list[tuple[Noun, tuple[int, int]]] = field(default_factory=list[tuple[Noun, tuple[int, int]]])
    # doors and windows that are asked for: kind, count, wall words, span
    openings: list[tuple[Place, tuple[int, int]]] = field(default_factory=list[tuple[Place, tuple[int, int]]])
    facts: list[Chunk] = field(default_factory=list[Chunk])  # Rooms, bodies, people, measures, styles ... as chunks.
    missed: list[Chunk] = field(default_factory=list[Chunk])  # chunks that nothing is made of
    read: set[int] = field(default_factory=set[int])  # further tokens that are understood
    people: int = 0  # people that the room is for, where a bare number says it ("for ten"); 0 if none does

    @property
    def last(self) -> Link:
        """The relation that was noted last; one that says nothing where there is none."""
        return self.links[-1] if self.links else Link("", (), (), -1, -1)

    def implied(self, kind: str, count: int, area: Chunk) -> NamedThing:
        """Add and return what belongs to a part of the room."""
        self.things.append(NamedThing(Noun(kind, kind, kind), count, spans=[(area.start, area.end)], implied=True))
        return self.things[-1]

    def instead(self, thing: NamedThing, other: Mention) -> None:
        """Let relations lead to another thing than to one that only stood for it."""
        self.things.remove(thing)
        for i, link in enumerate(self.links):
            led = tuple(other if isinstance(item, Mention) and item.thing is thing else item for item in link.objects)
            self.links[i] = replace(link, objects=led)


def mentions(items: Iterable[Item]) -> list[Mention]:
    """Return what of some items are things."""
    return [item for item in items if isinstance(item, Mention)]


def named(items: Iterable[Item]) -> set[NamedThing]:
    """Return the things among some items."""
    return {item.thing for item in mentions(items)}


def place_in(items: Iterable[Item], *names: str) -> Place | None:
    """Return the first place among some items, one of these names if any are given."""
    return next(iter(places(items, *names)), None)


def places(items: Iterable[Item], *names: str) -> list[Place]:
    """Return the places among some items, those of these names if any are given."""
    return [item for item in items if isinstance(item, Place) and (not names or item.name in names)]


def place_of(chunk: Chunk) -> Place:
    """Return the place that a chunk names."""
    return Place(chunk.value, chunk.adjectives, chunk.number, chunk.plural, chunk.det, opening=chunk.opening)


def of_the_plan(wall: Chunk) -> tuple[str, ...]:
    """Return at which side of the plan a wall is that is told so: "the left wall" is the west one."""
    return tuple(side for word in wall.adjectives if (side := grammar().walls.get(word)) in COMPASS)


def sides(chunk: Chunk | Place) -> tuple[str, ...]:
    """Return the words of a door or window that say which wall it is in: "the north window", but not "the front door"."""
    words = chunk.adjectives if isinstance(chunk, Chunk) else chunk.words
    return tuple(grammar().walls[word] for word in words if word.startswith(tuple(COMPASS)))
