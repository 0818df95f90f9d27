"""What a text asks of a new room, in kinds of the catalogue: counts, sizes by word, and the nearest room type."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from robolayout._errors import SceneError
from robolayout._reading import LIMITS
from robolayout.assets import CATALOGUE, Category
from robolayout.assets.palette import LOOKS
from robolayout.scene import FLAT_HEIGHT
from robolayout.words import (
    COMPASS,
    Lexicon,
    Link,
    Measure,
    Mention,
    Place,
    Reading,
    Rooms,
    RoomType,
    Thing,
    grammar,
    read_text,
    sized,
)

GENERAL = ("desk", "bed", "table", "chair", "seat", "shelf", "sink", "counter", "mat", "monitor", "scale")
"""Nouns that mean what is usual in a room: a desk of a classroom is a student desk."""

LACKING, LIKELY = 0.6, 0.9
"""What a room loses by each thing that it always has and that is not named, and what makes it likely, in things that belong there."""

CARRIED = 0.5
"""Square metres of floor that a thing takes at the most to be put on another, where it is asked to stand there."""

FOOTLESS = 0.09
"""Metres that a thing stands out from a wall at the most where it hangs there instead of standing on its foot."""

SIZE_WORDS = {"small", "large", "big", "little"}


APART = 0.25
"""Metres between things that lie on a rug or sit in a line."""

LONGEST = 50.0
"""Metres of the longest thing that a room is furnished with."""

ELBOWS = 0.6
"""Metres of a table's edge for who sits there."""

SEATS, AT_A_LINE = ("stool", "chair"), ("front", "by", "with", "wall", "next", "around")
"""Last words of what sits before a counter, and relations that say so."""


@dataclass(frozen=True)
class Wishes:
    """What a text asks of a new room."""

    reading: Reading  # what it says
    room: RoomType  # the room type: as named, else the nearest one
    things: Mapping[str, int]  # what is wished, and how many
    # kinds that are not in the catalogue as they were asked for: other words, other sizes
    named: Mapping[str, Category]
    looks: Mapping[str, str]  # what is said of the looks of things, by category
    sizes: Mapping[str, Sequence[Measure]]  # what is said of their sizes in figures
    guesses: tuple[str, ...]  # what was guessed, one sentence each

    @property
    def general(self) -> frozenset[str]:
        """Nouns that say no more than one word ("lamp"): nothing more of that name is added."""
        said = self.reading.parsed.things
        return frozenset(t.noun.said for t in said if " " not in t.noun.said and not t.adjectives)

    @property
    def seats(self) -> int:
        """Seats that are promised: at each of "five tables for four", at all "tables for 14 people" together."""
        return round(sum(_promised(thing) * thing.count for thing in self.reading.parsed.things))

    def held(self, kinds: Mapping[str, Category], least: float = 0.0) -> frozenset[str]:
        """Return the walls, by compass, at which something is asked to stand; with a height what is lower counts only if it hangs."""
        walls = grammar().walls
        return frozenset(
            walls[word]
            for link in self.reading.parsed.links
            for place in link.objects
            if isinstance(place, Place) and place.name == "wall"
            for kind in (kinds[mention.thing.noun.kind] for mention in link.subjects)
            if (kind.on_floor and kind.size[2] >= least) or (least and kind.on_wall)
            for word in place.words
            if walls.get(word) in COMPASS
        )

    def corners(self, kinds: Mapping[str, Category]) -> tuple[frozenset[str], ...]:
        """Return the corners, by the compass of their walls, in which something on the floor is asked to stand."""
        walls = grammar().walls
        told = [
            frozenset(walls[word] for word in place.words if walls.get(word) in COMPASS)
            for link in self.reading.parsed.links
            for place in link.objects
            if isinstance(place, Place) and place.name == "corner"
            if any(kinds[mention.thing.noun.kind].on_floor for mention in link.subjects)
        ]
        return tuple(words for words in told if len(words) == 2)

    @property
    def ignored(self) -> tuple[str, ...]:
        """Words without a meaning here."""
        parsed = self.reading.parsed
        spoken = [(chunk.start, chunk.end) for chunk in parsed.missed]
        unknown = [thing for thing in parsed.things if thing.noun.kind.startswith("unknown")]
        spoken += [(t.spans[0][1] - len(t.noun.said.split()), t.spans[0][1]) for t in unknown]
        return tuple(self.reading.span(*span) for span in sorted(spoken))


def read_wishes(text: str, rooms: Rooms, own: tuple[Category, ...] = ()) -> Wishes:
    """Return what a text asks of a new room.

    Args:
        text: One or several sentences.
        rooms: The room types, bodies and corners that are known.
        own: Categories of the user's own.

    Raises:
        SceneError: It is empty, names neither a room nor a thing, or its figures make no sense.
    """
    if not text.strip():
        raise SceneError('the sentence is empty; say for example "a bedroom for two with a desk, 4 x 5 m".')
    if len(text) > LIMITS.text:
        raise SceneError(f"the sentence has {len(text)} characters; say it in at most {LIMITS.text}.")
    lexicon = Lexicon(rooms, own)
    reading = read_text(text, lexicon)
    room, guesses = _room(reading, rooms)
    things, named = _things(reading, lexicon, rooms, room)
    if set(reading.words_of_taste) & set(grammar().cosy["words"]):
        things |= _cosy(things, reading.unwanted)
    said = reading.parsed.things
    guesses += [
        f"{thing.noun.words!r} was taken as {thing.noun.kind}, {thing.noun.guessed}."
        for thing in said
        if thing.noun.guessed and not thing.noun.kind.startswith("unknown")
    ]
    links = reading.parsed.links
    shown = {thing: _shown(thing, room, lexicon, links) for thing in said}
    looks = {shown[thing]: ", ".join(thing.look) for thing in said if thing.look}
    sizes = {shown[thing]: thing.sizes for thing in said if thing.sizes}
    return Wishes(reading, room, things, named, looks, sizes, tuple(guesses))


def _room(reading: Reading, rooms: Rooms) -> tuple[RoomType, list[str]]:
    """Return the room type: as named, else the nearest one, else the one that most of the things belong in."""
    if reading.room is not None and not (reading.guessed and reading.room == "room"):
        guess = [f"{reading.room_words!r} is no room type that is known: {reading.room} was taken."]
        return rooms.rooms[reading.room], guess if reading.guessed else []
    kinds = {thing.noun.kind for thing in reading.parsed.things}
    usual = {kind for room in rooms.rooms.values() for kind in room.base}
    kinds |= {"single bed"} if any(kind.endswith(" bed") for kind in kinds - usual) else set()
    if not kinds and not reading.parsed.facts:
        known = ", ".join(sorted(rooms.rooms))
        raise SceneError(f"the sentence names no room; known room types: {known}; words are read in English.")
    scores = {name: _belongs(kinds, room) for name, room in rooms.rooms.items()}
    best = max(scores, key=lambda name: (scores[name], name == "room"))
    best = best if scores[best] >= LIKELY else "room"
    named = f"{reading.room_words!r} is no room type that is known" if reading.guessed else "No room was named"
    return rooms.rooms[best], [f"{named}: {best} was taken."]


def _cosy(things: Mapping[str, int], unwanted: frozenset[str]) -> dict[str, int]:
    """Return what makes a room cosy and is not among the things: something soft, a warm light."""
    rows = [grammar().cosy[row] for row in ("soft", "warm")]
    return {kind: 1 for row in rows if not set(things) & set(row) for kind in [k for k in row if k not in unwanted][:1]}


def _belongs(kinds: set[str], room: RoomType) -> float:
    """Return how many of some kinds belong in a room; what always stands there counts double, and lacks where it is missing."""
    usual = {*room.extras, *room.person}
    found = sum(2.0 if kind in room.base else 1.0 for kind in kinds if kind in room.base or kind in usual)
    lights_and_rugs = {
        kind.name
        for kind in CATALOGUE.values()
        if kind.size[2] < FLAT_HEIGHT or (kind.on_ceiling and not kind.on_floor)
    }
    return found - LACKING * len({*room.base} - kinds - lights_and_rugs)


def _things(
    reading: Reading, lexicon: Lexicon, rooms: Rooms, room: RoomType
) -> tuple[dict[str, int], dict[str, Category]]:
    """Return what is wished, and the kinds of it that are not in the catalogue as they stand."""
    wished: dict[str, int] = {}
    named: dict[str, Category] = {}
    for thing in reading.parsed.things:
        links = reading.parsed.links
        name, shown = usual_there(thing, room, links) or thing.noun.kind, _shown(thing, room, lexicon, links)
        kind = lexicon.kinds[name]
        like = kind.like or (name if shown != name else "")
        size = _large_enough(thing, sized(kind, thing.adjectives, thing.sizes), links, lexicon)
        if not all(0.0 < side <= LONGEST for side in size):
            shape = f"{' x '.join(f'{side:g}' for side in size)} m"
            raise SceneError(f"a {shown} of {shape} cannot be placed; give it sides above 0 and at most {LONGEST:g} m.")
        kind = _as_placed(thing, replace(kind, name=shown, like=like, size=size), links, lexicon)
        if kind != lexicon.kinds[name] and wished.get(shown, 0) == 0:
            named[shown] = kind
        wished[shown] = wished.get(shown, 0) + thing.count
    present = {name.split()[-1] for name in wished}
    for chunk in reading.parsed.facts:
        if chunk.kind == "corner":
            for name, count in rooms.corners[chunk.value].items():
                if name.split()[-1] not in present:
                    wished[name] = wished.get(name, 0) + count
    return wished, named


def _as_placed(thing: Thing, kind: Category, links: Sequence[Link], lexicon: Lexicon) -> Category:
    """Return a kind as it is where it is asked to be: on a thing, under the ceiling, flat on a wall, on one of its own."""
    for link in links:
        if all(mention.thing is not thing for mention in link.subjects):
            continue
        to = [lexicon.kinds[item.thing.noun.kind] for item in link.objects[:1] if isinstance(item, Mention)]
        places = {item.name for item in link.objects if isinstance(item, Place)}
        small = kind.size[0] * kind.size[1] < CARRIED
        if link.relation == "on" and small and any(bearer.size[2] >= FLAT_HEIGHT for bearer in to):
            kind = replace(kind, on_object=True, on_wall=False, on_ceiling=False, on_floor=False)
        if "ceiling" in places and not kind.on_ceiling:
            kind = replace(kind, on_ceiling=True, on_floor=False, on_wall=False, on_object=False)
        if link.relation == "on" and "wall" in places and kind.on_wall and kind.on_object:
            kind = replace(kind, on_object=False, size=(min(kind.size[0], FOOTLESS), *kind.size[1:]))
        if link.relation == "stacked":
            kind = replace(kind, on_object=True)
    return kind


def _large_enough(
    thing: Thing, size: tuple[float, float, float], links: Sequence[Link], lexicon: Lexicon
) -> tuple[float, float, float]:
    """Return the size of a thing with room for what is to lie on it, where it is a rug, or to sit before it in a line."""
    depth, width, height = size
    for link in links:
        to = [item.thing for item in link.objects if isinstance(item, Mention)]
        if thing not in to:
            continue
        for mention in link.subjects:
            kind, each = mention.thing.noun.kind, mention.thing.count / thing.count
            own = lexicon.kinds[kind].size
            if link.relation == "on" and height < FLAT_HEIGHT:
                times = math.sqrt(max(1.0, each * (max(own[:2]) + APART) ** 2 / (depth * width)))
                depth, width = round(depth * times, 2), round(width * times, 2)
            elif link.relation in AT_A_LINE and thing.noun.kind.endswith("counter") and kind.endswith(SEATS):
                width = round(max(width, each * (own[1] + APART)), 2)
    seats = 0 if thing.sizes else math.ceil(_seats(thing, links))
    if seats and thing.noun.kind.endswith("table"):
        if depth == width and "oval" not in thing.noun.said:
            depth = width = max(depth, round(seats * ELBOWS / math.pi, 2))
        while 2 * int(width / ELBOWS) + 2 * int(depth / ELBOWS) < seats:
            width = round(width + ELBOWS / 2, 2)
    return depth, width, height


def _seats(thing: Thing, links: Sequence[Link]) -> float:
    """Return the seats that each of a thing is said to have: "for ten", "with six chairs", "ten chairs around it"."""
    if thing.people:
        return _promised(thing)
    chairs = [
        mention.thing.count
        for link in links
        if link.relation in ("with", "around") and thing in [m.thing for m in link.objects if isinstance(m, Mention)]
        for mention in link.subjects
        if mention.thing.noun.kind.endswith(SEATS)
    ]
    return sum(chairs) / thing.count


def _promised(thing: Thing) -> float:
    """Return the seats at each of a thing that "for ten" promises; tables of which no number is said share them."""
    return thing.people / (thing.count if thing.plural and thing.number is None else 1)


def _shown(thing: Thing, room: RoomType, lexicon: Lexicon, links: Sequence[Link]) -> str:
    """Return the category under which a thing stands in the scene: its own words where no kind of that name is known."""
    name = usual_there(thing, room, links) or thing.noun.kind
    return thing.noun.words if thing.noun.kind == name and thing.noun.words not in lexicon.kinds else name


def usual_there(thing: Thing, room: RoomType, links: Sequence[Link]) -> str | None:
    """Return what a single general word means in a room: a desk of a classroom is a student desk.

    A chair at a table, at a wall or by the door is what people there sit on, and nothing else that stands in such a room.
    """
    said = [word for word in thing.noun.said.split() if word not in SIZE_WORDS]
    if len(said) != 1 or said[0] not in GENERAL or thing.noun.guessed or set(thing.adjectives) - SIZE_WORDS - LOOKS:
        return None
    at = [item for k in links if any(m.thing is thing for m in k.subjects) for item in k.objects]
    elsewhere = any(isinstance(item, Place) or item.thing.noun.kind.endswith("table") for item in at)
    usual = () if said[0] == "chair" and elsewhere else (*room.base, *room.extras)
    items = [*([room.tables] if room.tables else []), *room.person, *usual]
    word = said[0] if said else ""
    if word in items or (word in CATALOGUE and thing.noun.kind != word):
        return None
    return next((name for name in items if name.split()[-1] == word and name.split()[0] != word), None)
