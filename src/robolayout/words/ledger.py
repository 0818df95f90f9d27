"""The ledger of wishes: every phrase of the user as a row that is met, unmet, not judged or not understood."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Literal

from shapely import LineString
from shapely.geometry.base import BaseGeometry

from robolayout.assets import category_of
from robolayout.constraints import AssetRef, Relation
from robolayout.constraints._exact import footprint
from robolayout.program import Program
from robolayout.scene import Layout, Opening, Scene
from robolayout.words._demander import Demander
from robolayout.words._lexicon import Lexicon, grammar
from robolayout.words._match import fits, stand_ins
from robolayout.words._said import Link, Mention, Place, Thing
from robolayout.words._tokens import Measure
from robolayout.words._ways import SEATS
from robolayout.words.demands import Demand
from robolayout.words.reading import Reading, read_text
from robolayout.words.rooms import read_rooms

Verdict = Literal["met", "unmet", "not judged", "not understood"]

SIZE_OFF, AREA_OFF = 0.1, 0.03
"""Metres by which the sides and the height of a room, and share by which its area, may differ from what was asked."""


@dataclass(frozen=True)
class AskedRow:
    """One phrase of the user, judged."""

    words: str  # the phrase as it stands in the text
    kind: str  # "count", "relation", "room type", "room size", "opening", "body", "refusal", "style"
    understanding: str  # how it was understood
    things: tuple[str, ...]  # names of the assets that stand for it
    verdict: Verdict  # "met", "unmet", "not judged" (a matter of taste) or "not understood"
    value: str  # what was measured, in words

    def to_dict(self) -> dict[str, object]:
        """Return plain data."""
        return {**vars(self), "things": list(self.things)}


Finding = tuple[Verdict, str]

AIRY = 0.3
"""Share of the floor that furniture takes at the most in an airy room; usual rooms have a quarter to two fifths."""

SEAT = 0.5
"""Metres of a bench or sofa that one person takes."""

UP_TO = 0.5
"""Metres between a body's edge and what a way leads up to."""


@dataclass(frozen=True)
class _Furnished:
    """What rows are judged by: a scene, a layout of it, and where the centre of its first body gets to from the door."""

    scene: Scene
    layout: Layout
    walked: BaseGeometry | None = None


@dataclass(frozen=True)
class _Row:
    """A phrase before a layout is known: `judge` says how it stands in one."""

    words: str
    kind: str
    understanding: str
    judge: Callable[[_Furnished], Finding]
    things: tuple[str, ...] = ()
    demands: tuple[Demand, ...] = ()


@dataclass(frozen=True)
class Wishes:
    """Everything that a scene's words ask for."""

    rows: tuple[_Row, ...] = field(default=())  # one row for each phrase

    @property
    def demands(self) -> tuple[Demand, ...]:
        """What must hold about where things stand."""
        return tuple(demand for row in self.rows for demand in row.demands)

    @property
    def said(self) -> dict[Relation, str]:
        """The phrases by the statements that they ask for, every way of each."""
        return {said: row.words for row in self.rows for d in row.demands for way in d.ways for said in way}

    def marked(self, program: Program) -> Program:
        """Return a program whose statements say which of them the user asks for."""
        said = self.said
        statements = (replace(s, by="user") if s.relation in said else s for s in program.statements)
        return replace(program, statements=tuple(statements)) if said else program

    def judged(
        self,
        scene: Scene,
        layout: Layout,
        walked: BaseGeometry | None = None,
        against: Mapping[Relation, str] = MappingProxyType({}),
    ) -> tuple[AskedRow, ...]:
        """Return every row with its verdict in a layout; what is not placed meets nothing.

        Args:
            scene: The scene.
            layout: Where things stand.
            walked: Where the centre of the first body gets to from the door; None leaves ways unjudged.
            against: What unmet statements lost to, in words.
        """
        found: list[AskedRow] = []
        room = _Furnished(scene, layout, walked)
        for row in self.rows:
            stated = [said for demand in row.demands for way in demand.ways for said in way]
            reasons = dict.fromkeys(against[said] for said in stated if said in against)
            missing = [name for name in row.things if name not in layout]
            lost: Finding = ("unmet", f"{' and '.join(missing)} not placed")
            verdict, value = lost if missing else row.judge(room)
            if verdict == "unmet" and reasons:
                value += f"; against it: {' and '.join(reasons)}"
            found.append(AskedRow(row.words, row.kind, row.understanding, row.things, verdict, value))
        return tuple(found)


def read_words(scene: Scene) -> Wishes:
    """Return what the task description and the layout criteria of a scene ask for."""
    text = "\n".join(part for part in (scene.task_description, scene.layout_criteria) if part.strip())
    if not text.strip():
        return Wishes()
    lexicon = Lexicon(read_rooms(), scene=scene)
    return Wishes(tuple(_Rows(scene, read_text(text, lexicon)).rows()))


class _Rows:
    """Makes the rows of a text for a scene."""

    def __init__(self, scene: Scene, reading: Reading) -> None:
        self.scene, self.reading = scene, reading
        self.names = stand_ins(scene, reading.parsed.things)
        self.demander = Demander(scene, self.names, reading.parsed.links)

    def rows(self) -> Iterator[_Row]:
        """Yield facts about the room, counts, relations, refusals, and what was not understood."""
        yield from self._facts()
        parsed = self.reading.parsed
        looks = {word for thing in parsed.things for word in thing.look}
        for word in self.reading.words_of_taste:
            yield from [] if word in looks else [self._taste(word)]
        for thing in parsed.things:
            yield from [self._look(thing)] if thing.look else []
        for thing in parsed.things:
            yield from self._contradiction(thing)
            yield from (self._size(thing, measure) for measure in thing.sizes)
        for place, span in parsed.openings:
            yield self._opening(place, self.reading.span(*span))
        for thing in parsed.things:
            yield self._count(thing)
        for link in parsed.links:
            yield self._relation(link)
        for noun, span in parsed.refused:
            yield self._refusal(noun.words, noun.kind, self.reading.span(*span))
        yield from self._unread()

    def _unread(self) -> Iterator[_Row]:
        """Yield what was not understood."""
        missed = [self.reading.span(chunk.start, chunk.end) for chunk in self.reading.parsed.missed]
        for words in (*missed, *self.reading.unknown):
            yield _unread(words, "no word list has it")
        if self.reading.unread:
            yield _unread("...", f"{self.reading.unread} further characters were not read")

    def _facts(self) -> Iterator[_Row]:
        for chunk in self.reading.parsed.facts:
            words = self.reading.span(chunk.start, chunk.end)
            if chunk.kind == "room" and chunk.det == "a" and chunk.value not in ("room", self.reading.room):
                yield _unread(words, f"one room is laid out, the {self.reading.room}")
            elif chunk.kind == "room":
                nearest = (
                    f"the nearest room type to it, {chunk.value}"
                    if self.reading.guessed and chunk is self.reading.placed
                    else chunk.value
                )
                yield _Row(words, "room type", f"a {nearest}" if nearest == chunk.value else nearest, _as_given)
            elif chunk.measure is not None:
                yield _of_the_room(words, chunk.measure)
            elif chunk.kind == "body":
                yield _Row(words, "body", f"for {chunk.value}", _for_body(chunk.value))
            elif chunk.kind == "seats":
                yield _Row(words, "count", f"chairs or other seats for {chunk.number}", _seats_for(chunk.number or 0))
            elif chunk.kind in ("people", "users"):
                yield _Row(words, "people", "who uses the room", _as_given)
            elif chunk.kind == "corner":
                yield _Row(words, "relation", f"what belongs to a {chunk.value}", _as_given)
            elif chunk.kind != "style":
                yield _Row(words, chunk.kind, "what it is good for or made of", _taste)

    def _taste(self, word: str) -> _Row:
        """Return the row of a word of taste: some can be measured, some drawn, of the others nothing is known."""
        if word == self.reading.style:
            return _Row(word, "style", "colours and materials of the whole room", _as_given)
        if word.endswith(" floor") and self.reading.floor:
            floor = self.reading.floor
            return _Row(
                word, "style", floor, lambda room: _found(room.scene.room.floor == floor, room.scene.room.floor)
            )
        return _mood(word)

    def _look(self, thing: Thing) -> _Row:
        """Return the row of how a thing is to look."""
        names = self.names.get(thing, ())

        def judge(room: _Furnished) -> Finding:
            said = [str(room.scene.by_name[name].metadata.get("look", "")) for name in names]
            alike = bool(said) and all(word in look.split(", ") for look in said for word in thing.look)
            return _found(alike, "; ".join(dict.fromkeys(said)))

        return _Row(f"{' '.join(thing.look)} {thing.noun.words}", "style", "how it looks", judge)

    def _size(self, thing: Thing, measure: Measure) -> _Row:
        """Return the row of what is said of a thing's size in figures."""

        def judge(room: _Furnished) -> Finding:
            sizes = [room.scene.by_name[name].size for name in self.names.get(thing, ())]
            off = [abs(a - b) for size in sizes for a, b in zip(size, measure.on(size), strict=True)]
            shown = "; ".join(dict.fromkeys(" x ".join(f"{side:.2f}" for side in size) for size in sizes))
            return ("met" if off and max(off) <= SIZE_OFF else "unmet"), f"{shown} m"

        words = f"{thing.noun.words} {self.reading.text[measure.start : measure.end]}"
        return _Row(words, "attribute", f"{measure.kind} {measure.shown}", judge, self.names.get(thing, ()))

    def _contradiction(self, thing: Thing) -> Iterator[_Row]:
        """Yield a row that cannot be met where two attributes of a thing exclude each other."""
        for group in grammar().exclusive:
            said = [word for word in (*thing.adjectives, *thing.noun.said.split()) if word in group]
            if len(set(said)) > 1:
                words = self.reading.span(*thing.spans[0])
                why = f"{' and '.join(dict.fromkeys(said))} exclude each other"
                yield _Row(words, "attribute", why, lambda room: ("unmet", "a thing has one of these"))

    def _opening(self, place: Place, words: str) -> _Row:
        wanted = place.number or (2 if place.plural else 1)

        def judge(room: _Furnished) -> Finding:
            there = len(room.scene.room.windows if place.name == "window" else room.scene.room.doors)
            enough = there == wanted if place.number else there >= wanted
            return ("met" if enough else "unmet"), f"{there} there"

        return _Row(words, "opening", f"{wanted} {place.name}", judge)

    def _count(self, thing: Thing) -> _Row:
        """Return the row of a thing: as many as are asked for, those that stand for another thing aside."""
        others = {name for other, names in self.names.items() if other is not thing for name in names}
        own, wanted = self.names.get(thing, ()), thing.count
        nearest = f" ({thing.noun.kind}, {thing.noun.guessed})" if thing.noun.guessed else ""
        bound = {"least": "at least ", "more": "at least ", "most": "at most ", "vague": "some, "}.get(thing.bound, "")

        def judge(room: _Furnished) -> Finding:
            alike = [a.name for a in room.scene.assets if a.name in own or (a.name not in others and fits(a, thing))]
            there = sum(name in room.layout for name in alike)
            least = 1 if thing.number is None else wanted  # "shelves" are some, however many
            enough = there <= wanted if thing.bound == "most" else there >= min(least, wanted)
            if not alike:
                return "not understood", "nothing of that name is there"
            if thing.noun.kind.startswith("unknown"):
                return "not understood", f"no such kind is known; {there} boxes of a usual size stand for it"
            return ("met" if enough else "unmet"), f"{there} there"

        words = self.reading.span(*thing.spans[0])
        return _Row(words, "count", f"{bound}{wanted} {thing.noun.words}{nearest}", judge)

    def _relation(self, link: Link) -> _Row:
        """Return the row of a relation."""
        words = self.reading.span(link.start, link.end)
        if link.relation == "way":
            return self._way(link, words)
        about = ", ".join(_shown(mention) for mention in link.subjects)
        to = " and ".join(_shown(item) for item in link.objects)
        said = [about, words, to] if about not in words.lower() else [to, "with", words] if to else [words]
        understanding = " ".join(said).strip()
        demands = self.demander.demands(link)
        hung = [item for item in link.objects if isinstance(item, Place) and item.name == "ceiling"]
        if not demands and hung and link.subjects:
            things = tuple(name for mention in link.subjects for name in self.names.get(mention.thing, ()))
            return _Row(understanding, "relation", "hangs from the ceiling", _hangs(things), things)
        if not demands:
            return _unread(understanding, "nothing that the vocabulary can say")

        def judge(room: _Furnished) -> Finding:
            placed = set(room.layout)
            outcomes = [d.measure(room.scene, room.layout) if d.names() <= placed else None for d in demands]
            bad = [outcome for outcome in outcomes if outcome is None or not outcome.met]
            shown = next((outcome for outcome in bad or outcomes if outcome is not None), None)
            text = shown.text if shown is not None else "not placed"
            return ("unmet" if bad else "met"), text if len(
                outcomes
            ) == 1 else f"{len(outcomes) - len(bad)} of {len(outcomes)}: {text}"

        things = tuple(dict.fromkeys(name for demand in demands for name in sorted(demand.names())))
        said = "; ".join(dict.fromkeys(_said(demand) for demand in demands[:2])) + (" ..." if len(demands) > 2 else "")
        return _Row(understanding, "relation", said, judge, things, demands)

    def _way(self, link: Link, words: str) -> _Row:
        """Return the row of a way: the body gets up to each of the things and places that are named."""
        to = " and ".join(_shown(item) for item in link.objects)
        named = [self.names.get(item.thing, ()) for item in link.objects if isinstance(item, Mention)]
        things = tuple(name for names in named for name in names)
        room = self.scene.room
        openings: dict[str, tuple[Opening, ...]] = {"door": room.doors, "window": room.windows}
        places = [openings[item.name] for item in link.objects if isinstance(item, Place) and item.name in openings]
        if not things and not any(places):
            return _unread(f"{words} {to}".strip(), "nothing that a way can lead to")

        def judge(furnished: _Furnished) -> Finding:
            if furnished.walked is None:
                return "not judged", ""
            radius = furnished.scene.agents[0].radius
            away = [
                footprint(furnished.scene, furnished.layout, AssetRef(n)).distance(furnished.walked) for n in things
            ]
            for found in places:
                lines = [
                    LineString([room.walls[o.wall].point(o.offset + part * o.width) for part in (0, 1)]) for o in found
                ]
                away += [min(line.distance(furnished.walked) for line in lines)] if lines else []
            ends = max(0.0, max(away) - radius)
            return ("met" if ends <= UP_TO else "unmet"), f"the way ends {ends:.2f} m before it"

        return _Row(f"{words} {to}".strip(), "way", "a way for the body", judge, things)

    def _refusal(self, noun: str, kind: str, words: str) -> _Row:
        def judge(room: _Furnished) -> Finding:
            there = [asset.name for asset in room.scene.assets if category_of(asset).name == kind]
            return ("unmet" if there else "met"), f"{', '.join(there) or 'none'} there"

        return _Row(words, "refusal", f"no {noun}", judge)


def _said(demand: Demand) -> str:
    if demand.exact is not None:
        return f"{demand.exact.a} between {demand.exact.b} and {demand.exact.c}"
    first = ", ".join(relation.sentence() for relation in demand.ways[0])
    return f"{first} or one of {len(demand.ways) - 1} other ways" if len(demand.ways) > 1 else first


def _shown(item: Mention | Place) -> str:
    if isinstance(item, Place):
        return " ".join((*item.words, item.name, *((item.by[0], item.by[1].name) if item.by is not None else ())))
    return item.thing.noun.words


def _unread(words: str, why: str) -> _Row:
    return _Row(words, "not understood", why, lambda room: ("not understood", ""))


def _found(alike: bool, said: str) -> Finding:
    return ("met" if alike else "not judged"), said or "nothing is said of it"


def _mood(word: str) -> _Row:
    """Return the row of a word of taste: two moods can be judged, the others cannot."""
    lists = grammar()
    if word.lower() in lists.airy:
        return _Row(word, "style", f"furniture takes at most {AIRY:.0%} of the floor", _airy)
    if word.lower() in lists.cosy["words"]:
        return _Row(word, "style", "something soft and a warm light", _cosy)
    return _Row(word, "style", "a matter of taste", _taste)


def _airy(room: _Furnished) -> Finding:
    sizes = [asset.size for asset in room.scene.assets if asset.on_floor and not asset.is_flat]
    share = sum(depth * width for depth, width, _ in sizes) / room.scene.room.area
    return ("met" if share <= AIRY else "unmet"), f"it takes {share:.0%}"


def _cosy(room: _Furnished) -> Finding:
    there = {category_of(room.scene.by_name[name]).name for name in room.layout if name in room.scene.by_name}
    found = [next((kind for kind in grammar().cosy[row] if kind in there), "") for row in ("soft", "warm")]
    return ("met" if all(found) else "unmet"), " and ".join(kind or "none" for kind in found)


def _as_given(room: _Furnished) -> Finding:
    return "met", "as given"


def _taste(room: _Furnished) -> Finding:
    return "not judged", ""


def _seats_for(people: int) -> Callable[[_Furnished], Finding]:
    def judge(room: _Furnished) -> Finding:
        there = [asset for asset in room.scene.assets if asset.name in room.layout]
        kinds = [(category_of(asset).name.split()[-1], asset) for asset in there]
        seats = sum(
            int(asset.size[1] // SEAT) or 1 if kind in ("sofa", "bench") else 1
            for kind, asset in kinds
            if kind in SEATS
        )
        return ("met" if seats >= people else "unmet"), f"{seats} seats there"

    return judge


def _hangs(things: Sequence[str]) -> Callable[[_Furnished], Finding]:
    def judge(room: _Furnished) -> Finding:
        tops = [room.layout[name].z + room.scene.by_name[name].size[2] / 2 for name in things]
        off = max((room.scene.room.wall_height - top for top in tops), default=0.0)
        return ("met" if off <= SIZE_OFF else "unmet"), f"{off:.2f} m below the ceiling"

    return judge


def _for_body(name: str) -> Callable[[_Furnished], Finding]:
    def judge(room: _Furnished) -> Finding:
        bodies = ", ".join(agent.name for agent in room.scene.agents)
        return ("met" if name in bodies else "not judged"), f"laid out for {bodies}"

    return judge


def _of_the_room(words: str, measure: Measure) -> _Row:
    """Return the row of a measure of the room."""
    kind, values = measure.kind, measure.values

    def judge(room: _Furnished) -> Finding:
        given = room.scene.room
        x0, y0, x1, y1 = given.bounds
        there = {"size": sorted((x1 - x0, y1 - y0)), "area": [given.area], "height": [given.wall_height]}.get(kind)
        if there is None:
            return "not judged", ""
        off = max(abs(a - b) for a, b in zip(there, sorted(values), strict=True))
        good = off <= (AREA_OFF * values[0] if kind == "area" else SIZE_OFF)
        shown = " x ".join(f"{value:.2f}" for value in there)
        return ("met" if good else "unmet"), f"{shown} {'m2' if kind == 'area' else 'm'}"

    return _Row(words, f"room {kind}" if kind != "grid" else "style", f"{kind} {measure.shown}", judge)


def share_met(rows: tuple[AskedRow, ...]) -> float:
    """Return the share of the understood rows that are met; 1 where there are none."""
    judged = [row.verdict == "met" for row in rows if row.verdict in ("met", "unmet")]
    return sum(judged) / len(judged) if judged else 1.0
