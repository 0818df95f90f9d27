"""What a text says, before any scene: the room, its size and openings, the body, the people, the things."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, pairwise

from robolayout._errors import SceneError
from robolayout.assets import Category
from robolayout.assets.palette import STYLED, WOODS
from robolayout.words import _function_words as small
from robolayout.words._acting import acted
from robolayout.words._appositions import described
from robolayout.words._chunk import Chunk
from robolayout.words._chunks import Chunker
from robolayout.words._contents import contained
from robolayout.words._counting import one_for_each
from robolayout.words._framed import framed
from robolayout.words._kinds import settle_kinds
from robolayout.words._lexicon import Lexicon, Noun, grammar
from robolayout.words._parse import Parser
from robolayout.words._reworded import reworded
from robolayout.words._said import Link, Mention, NamedThing, Parsed, mentions, named, place_in, places
from robolayout.words._tokens import Measure, Size, Token, count_of, measures, tokens

LONGEST = 4000
"""Characters of a text that are read."""

ABREAST = 0.6
"""Metres of a bench that each is given who sits on it (the judge counts a seat from less)."""

AT_A_TABLE = 8
"""People for whom one of several tables is at the most; more are at all of them together."""

AT_A_DESK = 4
"""Most people that sit at one desk."""

LEAST_SHAPED = 5
"""Tables of which no number is said that stand in a U: one across and two on each side."""

MOST_OF_A_KIND = 200
"""Largest count that is furnished for."""

_ALONG = re.compile(r"counters? (?:running )?(?:along|on|against|lining|at) ")


@dataclass(frozen=True, eq=False)
class Reading:
    """What a text says."""

    text: str  # the text, as far as it is read
    words: Sequence[Token]
    parsed: Parsed  # things, relations, openings and facts
    placed: Chunk | None  # the phrase that names the room, if one does
    guessed: bool  # whether its room type is only the nearest one
    agent: str | None  # name of the body, None if none is named
    people: int  # number of people, 0 if none is given
    young: bool  # whether these are children
    only: bool  # whether nothing else is wanted
    unread: int = 0  # how many further characters there were

    def span(self, start: int, end: int) -> str:
        """Return the words of the text from one token to another, as they stand there, without a mark before them."""
        found = self.text[self.words[start].start : self.words[end - 1].end] if end > start else ""
        return found.lstrip(",; ") or found

    @property
    def room(self) -> str | None:
        """Name of the room type; None if none is named."""
        return self.placed.value if self.placed is not None else None

    @property
    def room_words(self) -> str:
        """The words that name the room."""
        return _words(self.placed, self.words) if self.placed is not None else ""

    @property
    def joined(self) -> list[str]:
        """Rooms that share the floor of the one that is named: "an open plan kitchen and living room", "with a dining area"."""
        rooms = [chunk for chunk in self.parsed.facts if chunk.kind == "room"]
        first = [at for at, chunk in enumerate(rooms) if chunk is self.placed and chunk.value in small.SHARING][:1]
        if not first:
            return []
        found, last = [f"{word} room" for word in rooms[first[0]].adjectives], rooms[first[0]]
        for chunk in rooms[first[0] + 1 :]:
            between = {word.text for word in self.words[last.end : chunk.start]}
            opened = between <= small.OPENING and not between.isdisjoint(("open", "opening", "opens"))
            told = chunk.det == "the" and last is self.placed and "with" not in between
            if not opened and (not between <= small.BETWEEN_ROOMS or told):
                break
            found, last = [*found, chunk.value], chunk
        return list(dict.fromkeys(name for name in found if name in small.SHARING and name != self.room))

    def measure(self, kind: str) -> tuple[float, ...] | None:
        """Return the values of the first measure of a kind, None if none is given."""
        facts = [chunk.measure for chunk in self.parsed.facts if chunk.measure is not None]
        return next((measure.values for measure in facts if measure.kind == kind), None)

    @property
    def size(self) -> tuple[float, float] | None:
        """Width and depth of the room in metres, if given."""
        found = self.measure("size")
        return (found[0], found[1]) if found else None

    @property
    def way(self) -> float:
        """Metres that ways are asked to be wide; 0 if nothing is said."""
        return max((link.metres[0] for link in self.parsed.links if link.relation == "way"), default=0.0)

    @property
    def unwanted(self) -> frozenset[str]:
        """Kinds that must not be there."""
        return frozenset(kind for noun, _ in self.parsed.refused for kind in self.refused(noun))

    def refused(self, noun: Noun) -> set[str]:
        """Return the kinds that are refused with a noun: with chairs office chairs, too, but not what is asked for."""
        asked = {kind for thing in self.parsed.things for kind in (thing.noun.kind, *thing.noun.others)}
        alike = noun.said == noun.kind and not noun.guessed
        further = {kind for kind in noun.kinds if alike and kind.split()[1:] and kind.split()[-1] == noun.kind}
        return {noun.kind, *(further - asked)}

    @property
    def airy(self) -> bool:
        """Whether the floor is to stay largely free."""
        return bool(set(self.words_of_taste) & grammar().airy)

    @property
    def words_of_taste(self) -> list[str]:
        """All words of taste, those before nouns too."""
        styles = grammar().styles
        said = [chunk.adjectives for chunk in self.parsed.facts] + [thing.adjectives for thing in self.parsed.things]
        alone = [chunk.value for chunk in self.parsed.facts if chunk.kind == "style"]
        return list(dict.fromkeys([*alone, *(word for words in said for word in words if word in styles)]))

    @property
    def flanked_door(self) -> bool:
        """Whether things are to stand on both sides of the door, in every corner or in the one by it, so that it stands off its own."""
        by_door = {m.thing for link in self.parsed.links if place_in(link.objects, "door") for m in link.subjects}
        cornered = {m.thing for link in self.parsed.links if place_in(link.objects, "corner") for m in link.subjects}
        return bool(by_door & cornered) or any(
            (item.name == "corner" and (item.det == "each" or item.plural or (item.by and item.by[1].name == "door")))
            or (item.name == "door" and link.relation in ("flank", "left", "right"))
            for link in self.parsed.links
            for item in places(link.objects)
        )

    @property
    def unknown(self) -> list[str]:
        """Words before nouns of which nothing is known ("a frilly bed"), in order."""
        said = dict.fromkeys(word for thing in self.parsed.things for word in thing.adjectives)
        new = [word for word in said if word not in grammar().adjectives and count_of(word) is None]
        return [word for word in new if word.removesuffix("s") not in small.PEOPLE]  # not "the doctor's chair"

    @property
    def style(self) -> str:
        """The style of the room, in a word that can be drawn; empty if none is said."""
        own = {word for thing in self.parsed.things for word in thing.look}
        return next((word for word in self.words_of_taste if word in STYLED and word not in own | set(WOODS)), "")

    @property
    def floor(self) -> str:
        """What lies on the floor, as it is said or as the style has it; empty if neither is."""
        floors = grammar().floors
        said = [c.value.removesuffix(" floor").split()[-1] for c in self.parsed.facts if c.value.endswith(" floor")]
        return next((floors[word] for word in (*said, self.style) if word in floors), "")

    @property
    def shape(self) -> str:
        """Shape of the room: "rectangular" or "L-shaped"."""
        rooms = [chunk.adjectives for chunk in self.parsed.facts if chunk.kind == "room"]
        lower = self.text.lower().replace("-", " ")
        said = any(f"l shaped {noun}" in lower for noun in ("room", "layout", "space", "floor"))
        said = said or any("l" in words and {"shaped", "shape"} & {*words} for words in rooms if self.room != "kitchen")
        return "L-shaped" if said else "rectangular"

    @property
    def scale(self) -> float:
        """By how much the floor is larger or smaller than usual, as far as words say it."""
        return self._of_the_room(grammar().rooms) or 1.0

    @property
    def ratio(self) -> float | None:
        """How many times as long as wide a room is to be ("a square room", "a narrow kitchen"), None if nobody says."""
        return self._of_the_room(grammar().ratios)

    def _of_the_room(self, known: Mapping[str, float]) -> float | None:
        """Return what the first known adjective of the room says, None if none is known."""
        said = [word for chunk in self.parsed.facts if chunk.kind == "room" for word in chunk.adjectives]
        return next((known[word] for word in said if word in known), None)


def read_text(text: str, lexicon: Lexicon) -> Reading:
    """Return what a text says.

    Args:
        text: One or several sentences.
        lexicon: The nouns that are known.

    Raises:
        SceneError: Its figures make no sense.
    """
    read = text[:LONGEST]
    words = _said_besides(reworded(tokens(read)))
    chunks = contained(described(framed(acted(Chunker(words, measures(read), lexicon).chunks()))))
    named = _place_named(chunks, words)
    if named is not None:
        chunks[named[0]] = named[1]
    parsed = Parser(chunks).parse()
    _for_children(parsed.facts)
    guessed = named is not None and named[1].kind == "room"
    rooms = [chunk for chunk in parsed.facts if chunk.kind == "room"]
    bodies = [chunk.value for chunk in parsed.facts if chunk.kind == "body"]
    people = [c for c in parsed.facts if c.kind == "people"]
    whose = (chunk.adjectives for chunk in (*rooms, *people))
    for said in whose:  # "a small barrier-free bathroom", "my elderly mother"
        runs = (" ".join(said[begin:end]) for begin, end in combinations(range(len(said) + 1), 2))
        names = (who for run in runs for who in (run, run.removesuffix("s")))
        bodies += [lexicon.bodies[who] for who in names if who in lexicon.bodies][:1]
    bodies.sort(key=lambda body: small.LEAST_SAID.index(body) if body in small.LEAST_SAID else -1)
    siblings = [c.number or 1 for c in people if c.value.removesuffix("s") in small.SIBLINGS]
    counts = [sum(siblings)] * (len(siblings) > 1)  # "for a boy and a girl"
    counts += [c.number for c in parsed.facts if c.kind in ("people", "body") and c.number]
    sized = [pair for room in rooms for pair in pairwise(room.adjectives)]  # "a 3-person office"
    counts += [count for said, of in sized if of in ("person", "seat", "seater") and (count := count_of(said))]
    counts += [small.BORN[c.value] for c in people if c.value in small.BORN] + [parsed.people]
    young = "child_6" in bodies or len(siblings) > 1 or any(c.value in small.YOUNG for c in people)
    settle_kinds(parsed)
    _at_tables(parsed.links)
    parsed.links[:] = _had_nearby(parsed.links)
    shared = _shared_out(parsed.things, _shaped(parsed.links, bounded(counts[0], "people")))
    number = _at_one_desk(parsed, shared)
    seats = number or next((thing.people * thing.count for thing in parsed.things if thing.people), 0)
    for thing in parsed.things:
        if seats and thing.plural and thing.number is None and thing.head in small.ONE_EACH:
            thing.number = max(seats // thing.times, 1)  # "for ten people, with chairs"
        if thing.everyones:
            thing.times = max(number or seats or _theirs(parsed.things, thing), 1)
        bounded(thing.count, thing.noun.words)
    one_for_each(parsed.links)
    return Reading(
        text=read,
        words=words,
        parsed=parsed,
        placed=named[1] if named is not None and guessed else next(iter(rooms), None),
        guessed=guessed,
        agent=bodies[0] if bodies else "child_6" if young else None,
        people=number,
        young=young,
        only=any(word.text == "only" for word in words) or any(chunk.kind == "alone" for chunk in parsed.facts),
        unread=len(text) - len(read),
    )


def _for_children(facts: list[Chunk]) -> None:
    """Let a bedroom that is for children alone be their room, or that of a baby a nursery."""
    users = [chunk.value.split()[-1] for chunk in facts if chunk.kind in ("people", "body")]
    words = [who.removesuffix("s") for who in users]
    for young, room in ((small.SIBLINGS | {"child_6", "toddler"}, "children's room"), ({"baby", "infant"}, "nursery")):
        alone = bool(words) and young.issuperset(words)
        facts[:] = [replace(c, value=room) if alone and (c.kind, c.value) == ("room", "bedroom") else c for c in facts]


def _at_tables(links: Sequence[Link]) -> None:
    """Settle how much several tables have of what no number is said: "three high tables with stools", "set for six with plates"."""
    for link in (link for link in links if link.relation in ("with", "on")):
        for table, thing in ((m.thing, one.thing) for m in mentions(link.objects) for one in link.subjects):
            laid = table.people if thing.head in small.TABLEWARE else 0
            each = 2 if thing.head == "stool" and table.count > 1 else laid
            each = each or int(link.relation == "on" and table.head in small.TOPS)  # "crates on four tables"
            thing.number = max(each * table.count, 2) if each and thing.uncounted else thing.number
    _long_benches(links)


def _long_benches(links: Sequence[Link]) -> None:
    """Settle how long benches are that stand along a table for so many people, with chairs at its ends or without."""
    at = [k for k in links if k.relation in ("around", "with", "oneside", "otherside")]
    around = [(link.subjects, table.thing) for link in at for table in mentions(link.objects)]
    for subjects, table in around:
        chairs = sum(one.count for other, to in around if to is table for one in other if one.thing.head == "chair")
        for bench in (one.thing for one in subjects if one.thing.head == "bench" and not one.thing.sizes):
            most = min(table.people - chairs, math.ceil(table.people / 2) * bench.count)  # half of them at one side
            wide = round(math.ceil(most / bench.count) * ABREAST, 2)
            bench.sizes += [Measure("wide", (wide,), 0, 0)] * (wide > bench.category.size[1])


def _theirs(things: Sequence[NamedThing], given: NamedThing) -> int:
    """Return for how many people a room is by its beds, or by its desks; 0 if it has none: "a wardrobe for each patient"."""
    own = (thing for heads in (small.SLEPT_ON, ("desk", "workstation")) for thing in things if thing.head in heads)
    return next((thing.count for thing in own if thing is not given), 0)


def _shaped(links: Sequence[Link], number: int) -> int:
    """Settle how many tables of which no number is said stand in a shape, one for every two people; return for how many the room is."""
    for thing in (one.thing for link in links if link.relation in small.SHAPES for one in link.subjects):
        if thing.uncounted and thing.head in ("table", "desk"):
            number, thing.people = number or bounded(thing.people, "people"), 0
            thing.number = max(LEAST_SHAPED, math.ceil(number / 2))
    return number


def _had_nearby(links: Sequence[Link]) -> list[Link]:
    """Return links without those that give to what is in the middle of the room what is asked to a wall."""
    at = [(link.relation == "middle", link) for link in links if link.relation in ("middle", "wall", "corner")]
    middle, walled = ({m.thing for amid, link in at if amid == which for m in link.subjects} for which in (True, False))
    walled |= {m.thing for link in links if place_in(link.objects, "wall", "corner") for m in link.subjects}
    return [
        k for k in links if k.relation != "with" or not (named(k.objects) <= middle and named(k.subjects) <= walled)
    ]


def _shared_out(things: Sequence[NamedThing], number: int) -> int:
    """Settle how many there are of what is for so many people ("desks for twenty", "pews for sixty"); return for how many the room is."""
    for thing in (one for one in things if one.people and one.head in (*small.OWN, *small.BENCHES)):
        uncounted, wide = thing.plural and thing.number is None, thing.category.size[1]
        if thing.head in small.OWN and not uncounted:
            continue
        if thing.head in small.OWN:
            thing.number = number = number or bounded(thing.people, "people")
        elif uncounted:
            thing.number = math.ceil(thing.people / max(int(wide / ABREAST), 1))
        elif thing.people * ABREAST > wide and not thing.sizes:
            thing.sizes.append(Measure("wide", (round(thing.people * ABREAST, 2),), 0, 0))
        thing.people = 0  # they have their seats
    for thing in (one for one in things if one.head == "table" and one.people > AT_A_TABLE and (one.number or 1) > 1):
        # "three tables for twelve people" have twelve seats together
        number = number or bounded(thing.people, "people")
        thing.people = math.ceil(thing.people / thing.count)
    return number


def _at_one_desk(parsed: Parsed, number: int) -> int:
    """Give each of several desks as many chairs as it is for ("double desks", "24 pupils with twelve desks"); return how many sit there."""
    desks = [thing for thing in parsed.things if thing.noun.kind in ("desk", "student desk") and thing.count > 1]
    if len(desks) != 1 or any(thing.head in small.SEATS and thing.count > 1 for thing in parsed.things):
        return number
    desk, (start, end) = desks[0], desks[0].spans[0]
    double = small.DOUBLE & {*desk.adjectives}
    each = desk.people or (2 if double else number // desk.count if number % desk.count == 0 else 0)
    if not 1 < each <= AT_A_DESK:
        return number
    desk.people, desk.adjectives = 0, tuple(word for word in desk.adjectives if word not in double)
    chairs = parsed.implied("chair", each, Chunk("thing", start, end))
    chairs.times = desk.count
    parsed.links.append(Link("with", (Mention(chairs),), (Mention(desk, None, "each"),), start, end))
    return number or bounded(each * desk.count, "people")


def _said_besides(words: list[Token]) -> list[Token]:
    """Return the words of a text with a sentence more for each name of an arrangement in it ("a galley kitchen"), in that place."""
    text = [word.text for word in words]
    for phrase, said in small.SAID_AS.items():
        size = len(named := phrase.split())
        known = {"table", "tables"} & {*text} and "table" in said  # "a kitchen-diner with a table for six"
        known = known or ("counters" in said and _ALONG.search(" ".join(text)))
        for at in (at for at in range(len(text) - size + 1) if text[at : at + size] == named and not known):
            start, end = words[at].start, words[at + size - 1].end
            # "a galley kitchen with white counters"
            meant = re.sub(r"^\w+ (?=counters)", "the ", said) if "counters" in text else said
            words = [*words, *(Token(word.text, start, end) for word in tokens(f". {meant}"))]
    return words


def bounded(count: int, what: str) -> int:
    """Return a count, or refuse one that no room is for."""
    if count > MOST_OF_A_KIND:
        raise SceneError(f"{count} x {what} is more than one room is for; ask for at most {MOST_OF_A_KIND}.")
    return count


def _place_named(chunks: Sequence[Chunk], words: Sequence[Token]) -> tuple[int, Chunk] | None:
    """Return the phrase of a place that the list of rooms does not have ("a sushi bar") and where it stands, if one is named.

    Only the first phrase of a text can be such a place, and only where what follows says what is in it.
    """
    places = grammar().places
    for i, chunk in enumerate(chunks):
        if chunk.kind == "other" and chunk.value in places:  # "Dental clinic: ..."
            return i, replace(chunk, kind="room", value=places[chunk.value])
        if chunk.kind in small.BEFORE_A_PLACE and chunk.value not in small.PLACING:  # not "place a bar at the back"
            continue
        if chunk.kind not in ("thing", "part", "corner"):
            return None
        said = _words(chunk, words)
        *more, last = said.split()
        last = more[-1] if last in ("interior", "room", "space") and more[-1:] and more[-1] in places else last
        part = chunk.kind == "part" and not (chunk.value == "door" and last in places and _furnished(chunks[i:]))
        if chunk.kind == "corner" and not said.endswith("space"):  # "an office space"
            return None
        other = part and (chunk.value not in ("room", "corner", "middle") or said == last)
        follows = chunks[i + 1].kind if i + 1 < len(chunks) else "stop"
        listed = follows == "comma" and chunk.noun is not None and not chunk.noun.guessed  # "a toilet, a sink"
        unknown = chunk.noun is not None and chunk.noun.kind.startswith("unknown")
        last = next((place for place in places if unknown and last.endswith(place)), last)  # "a ballroom"
        unknown = unknown and follows in ("with", "colon")
        wrong = other or listed or (chunk.number or 1) > 1 or follows not in small.AFTER_A_PLACE
        if wrong or not (last in places or unknown):
            return None
        later = [
            before.kind
            for before, c in pairwise(chunks[i:])
            if c.kind == "room" and c.value not in ("room", places.get(last))
        ]
        if {*later} - {"with"}:  # not "a break room with a kitchenette"
            if chunk.noun is not None and chunk.noun.said == said and not chunk.noun.guessed:
                return None  # "a breakfast bar with stools overlooking the living room"
            return i, Chunk("function", chunk.start, chunk.end, last)
        return i, Chunk("room", chunk.start, chunk.end, places.get(last, "room"), adjectives=chunk.adjectives)
    return None


def _furnished(chunks: Sequence[Chunk]) -> bool:
    """Return whether an entryway is a room: "an entryway", "the entryway is narrow", but not "the entryway is on the left"."""
    follows = [chunk.kind for chunk in chunks[1:3]]
    return chunks[0].det in ("a", "") or "rel" not in follows


def _words(chunk: Chunk, words: Sequence[Token]) -> str:
    """Return the words of a phrase without its article."""
    said = " ".join(word.text for word in words[chunk.start : chunk.end])
    return said.removeprefix("a ").removeprefix("an ").removeprefix("the ")


def sized(kind: Category, adjectives: Sequence[str], measures: Sequence[Measure] = (), noun: str = "") -> Size:
    """Return depth, width and height in metres of a kind of thing with such adjectives and measures, said as such a noun.

    >>> from robolayout.assets import CATALOGUE
    >>> sized(CATALOGUE["bed"], ("king", "size"))
    (2.1, 1.95, 1.0)
    """
    lists = grammar()
    said = ([*adjectives, kind.name], [*noun.removesuffix(kind.name).split(), kind.name])
    models = [" ".join(word for word in words if word not in ("size", "sized")) for words in said]
    model = next((lists.models[name] for name in models if name in lists.models), None)
    depth, width, height = model or kind.size
    for word in dict.fromkeys(adjectives) if (depth, width, height) == kind.size else ():
        d, w, h = lists.sizes.get(word, (1.0, 1.0, 1.0))
        depth, width, height = depth * d, width * w, height * h
    if kind.name.startswith("round ") or ("square" in adjectives and model is None):
        depth = width = min(depth, width)
    elif small.ROUND & {*adjectives}:
        depth = width = math.sqrt(depth * width)
    size = (round(depth, 3), round(width, 3), round(height, 3))
    for measure in measures:
        size = measure.on(size)
    return size
