"""The ledger of wishes: every phrase of the user as a row that is met, unmet, not judged or not understood."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from functools import partial
from types import MappingProxyType

from shapely import LineString
from shapely.geometry.base import BaseGeometry

from robolayout.assets import category_of
from robolayout.assets.lexicon import singular
from robolayout.constraints import AssetRef, Relation
from robolayout.constraints._exact import footprint
from robolayout.program import Program
from robolayout.scene import Asset, Layout, Scene
from robolayout.words import _judged as as_row
from robolayout.words._chunk import Chunk
from robolayout.words._demander import Demander
from robolayout.words._function_words import KIN
from robolayout.words._judged import Finding, Furnished, Unjudged, Verdict, met
from robolayout.words._lexicon import Lexicon, grammar, plain, words_for
from robolayout.words._said import Link, NamedThing, Place, mentions, named, place_in
from robolayout.words._tokens import Measure
from robolayout.words._walls import is_framed, openings, walls_meant
from robolayout.words.demands import Demand
from robolayout.words.reading import Reading, read_text
from robolayout.words.rooms import read_rooms


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


@dataclass(frozen=True)
class Wishes:
    """Everything that a scene's words ask for."""

    rows: tuple[Unjudged, ...] = ()  # one row for each phrase

    @property
    def demands(self) -> tuple[Demand, ...]:
        """What must hold about where things stand."""
        return tuple(demand for row in self.rows for demand in row.demands)

    @property
    def said(self) -> dict[Relation, str]:
        """The phrases by the statements that they ask for, every way of each."""
        return {said: row.words for row in self.rows for said in row.said}

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
        """Return every row with its verdict in a layout, with where the body gets to, and what unmet statements lost to."""
        found: list[AskedRow] = []
        room = Furnished(scene, layout, walked)
        for row in self.rows:
            reasons = dict.fromkeys(against[said] for said in row.said if said in against)
            missing = [name for name in row.things if name not in layout]
            verdict, value = met(False, f"{' and '.join(missing)} not placed") if missing else row.judge(room)
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
    return Wishes(tuple(_RowMaker(scene, read_text(text, lexicon)).rows()))


class _RowMaker:
    """Makes the rows of a text for a scene."""

    def __init__(self, scene: Scene, reading: Reading) -> None:
        self.scene, self.reading = scene, reading
        self.names = stand_ins(scene, reading.parsed.things)
        self.demander = Demander(scene, self.names, reading.parsed.links)

    def rows(self) -> Iterator[Unjudged]:
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
        lacking = {thing for thing in parsed.things if thing.implied and not self.names.get(thing)}
        for thing in parsed.things:
            yield from [] if thing in lacking else [self._count(thing)]
        for link in parsed.links:
            if lacking & named(link.subjects):
                said = [] if link.subjects[0].thing.spans == [(link.start, link.end)] else [link]
                yield from (
                    as_row.unread(self.reading.span(k.start, k.end), "nothing of that part is there") for k in said
                )
                continue
            row = self._relation(link)
            yield row
            yield from self._left_out(link, row)
        for noun, span in parsed.refused:
            yield self._refusal(noun.words, self.reading.refused(noun), self.reading.span(*span))
        yield from self._unread()

    def _unread(self) -> Iterator[Unjudged]:
        """Yield what was not understood."""
        for chunk in self.reading.parsed.missed:
            yield as_row.unread(self.reading.span(chunk.start, chunk.end), "no word list has it")
        for word in self.reading.unknown:
            yield Unjudged(word, "style", "said of a thing that is known; no word list has it", as_row.taste)
        if self.reading.unread:
            yield as_row.unread("...", f"{self.reading.unread} further characters were not read")

    def _facts(self) -> Iterator[Unjudged]:
        furnished = {thing.spans[0] for thing in self.reading.parsed.things if thing.implied and self.names.get(thing)}
        furnished -= {(at.start, at.end) for at in [self.reading.placed] if at is not None}
        for chunk in (fact for fact in self.reading.parsed.facts if (fact.start, fact.end) not in furnished):
            words = self.reading.span(chunk.start, chunk.end)
            if chunk.kind == "room":
                yield self._room(chunk, words)
            elif chunk.measure is not None:
                kind, judge = chunk.measure.kind, partial(as_row.measured, chunk.measure)
                named = "style" if kind == "grid" else f"room {kind}"
                yield Unjudged(words, named, f"{kind} {chunk.measure.shown}", judge)
            elif chunk.kind == "body":
                yield Unjudged(words, "body", f"for {chunk.value}", partial(as_row.bodied, chunk.value))
            elif chunk.kind == "seats":
                people = chunk.number or 0
                yield Unjudged(words, "count", f"chairs or other seats for {people}", partial(as_row.seated, people))
            elif chunk.kind in ("people", "users"):
                yield Unjudged(words, "people", "who uses the room", as_row.as_given)
            elif chunk.kind == "alone":
                yield Unjudged(words, "refusal", "nothing that is not named", self._nothing_else)
            elif chunk.kind in ("corner", "aside"):
                said = "a part of the room" if chunk.kind == "corner" else "nothing that is asked of a room"
                yield Unjudged(words, "function", said, as_row.taste)
            elif chunk.kind != "style":
                yield Unjudged(words, chunk.kind, "what it is good for or made of", as_row.taste)

    def _room(self, chunk: Chunk, words: str) -> Unjudged:
        """Return the row of a room, or of a part of the one that is laid out."""
        if words.lower().endswith(as_row.ZONES):
            return Unjudged(words, "function", "a part of the room", as_row.taste)
        # "a deli ... in the middle of the shop"
        same = chunk.det == "the" and words.split()[-1].lower() in grammar().parts
        if not same and chunk.value not in ("room", self.reading.room, *self.reading.joined):
            return as_row.unread(words, f"one room is laid out, the {self.reading.room}")
        guessed = self.reading.guessed and chunk is self.reading.placed
        article = "an" if chunk.value[0] in "aeio" else "a"
        nearest = "the nearest room type to it," if guessed else article
        return Unjudged(words, "room type", f"{nearest} {chunk.value}", as_row.as_given)

    def _taste(self, word: str) -> Unjudged:
        """Return the row of a word of taste: some can be measured, some drawn, of the others nothing is known."""
        if word == self.reading.style:
            return Unjudged(word, "style", "colours and materials of the whole room", as_row.as_given)
        if word.endswith(" floor") and self.reading.floor:
            floor = self.reading.floor
            return Unjudged(
                word, "style", floor, lambda it: as_row.found(it.scene.room.floor == floor, it.scene.room.floor)
            )
        return as_row.mood(word)

    def _look(self, thing: NamedThing) -> Unjudged:
        """Return the row of how a thing is to look."""
        names = self.names.get(thing, ())

        def judge(room: Furnished) -> Finding:
            said = [str(room.scene.by_name[name].metadata.get("look", "")) for name in names]
            alike = bool(said) and all(word in look.split(", ") for look in said for word in thing.look)
            return as_row.found(alike, "; ".join(dict.fromkeys(said)))

        return Unjudged(f"{' '.join(thing.look)} {thing.noun.words}", "style", "how it looks", judge)

    def _size(self, thing: NamedThing, measure: Measure) -> Unjudged:
        """Return the row of what is said of a thing's size in figures."""

        def judge(room: Furnished) -> Finding:
            sizes = [room.scene.by_name[name].size for name in self.names.get(thing, ())]
            off = [abs(a - b) for size in sizes for a, b in zip(size, measure.on(size), strict=True)]
            shown = "; ".join(dict.fromkeys(" x ".join(f"{side:.2f}" for side in size) for size in sizes))
            return met(bool(off) and max(off) <= as_row.SIZE_OFF, f"{shown} m")

        words = f"{thing.noun.words} {self.reading.text[measure.start : measure.end]}"
        return Unjudged(words, "attribute", f"{measure.kind} {measure.shown}", judge, self.names.get(thing, ()))

    def _contradiction(self, thing: NamedThing) -> Iterator[Unjudged]:
        """Yield a row that cannot be met where two attributes of a thing exclude each other."""
        for group in grammar().exclusive:
            said = [word for word in (*thing.adjectives, *thing.noun.said.split()) if word in group]
            if len(set(said)) > 1:
                words = self.reading.span(*thing.spans[0])
                why = f"{' and '.join(dict.fromkeys(said))} exclude each other"
                yield Unjudged(words, "attribute", why, lambda room: met(False, "a thing has one of these"))

    def _opening(self, place: Place, words: str) -> Unjudged:
        wanted = place.number if place.number is not None else 2 if place.plural else 1

        def judge(room: Furnished) -> Finding:
            walls = {wall.index for wall in walls_meant(room.scene.room, place)}
            own = (one for one in openings(room.scene.room, place.name) if one.wall in walls)
            there = sum(place.opening is None or is_framed(room.scene.room, one, place.opening) for one in own)
            return met(there == wanted if place.number is not None else there >= wanted, f"{there} there")

        said = f", {place.opening}" if place.opening is not None else ""
        return Unjudged(words, "opening", f"{wanted} {as_row.shown(place)}{said}", judge)

    def _count(self, thing: NamedThing) -> Unjudged:
        """Return the row of a thing: as many as are asked for, those that stand for another thing aside."""
        others = {name for other, names in self.names.items() if other is not thing for name in names}
        own, wanted = self.names.get(thing, ()), thing.count
        nearest = f" ({thing.noun.kind}, {thing.noun.guessed})" if thing.noun.guessed else ""
        bound = {"least": "at least ", "more": "at least ", "most": "at most ", "vague": "some, "}.get(thing.bound, "")

        def judge(room: Furnished) -> Finding:
            free = (a for a in room.scene.assets if a.name not in others)
            alike = [a.name for a in free if a.name in own or any(fits(a, thing) for fits in TIERS)]
            there = sum(name in room.layout for name in alike)
            least = 1 if thing.number is None else wanted  # "shelves" are some, however many
            if not alike:
                return "not understood", "nothing of that name is there"
            if thing.noun.kind.startswith("unknown") and any(_is_box(room.scene.by_name[name]) for name in alike):
                return "not understood", f"no such kind is known; {there} boxes of a usual size stand for it"
            return met(there <= wanted if thing.bound == "most" else there >= min(least, wanted), f"{there} there")

        words = self.reading.span(*thing.spans[0])
        made = {category_of(self.scene.by_name[name]).name for name in own}
        as_said = nearest or made <= {thing.noun.kind}
        named = thing.noun.words if as_said else f"{thing.noun.said} ({', '.join(sorted(made))})"
        sizes = "".join(f", {word}" for word in thing.adjectives if word in grammar().sizes)
        return Unjudged(words, "count", f"{bound}{wanted} {named}{sizes}{nearest}", judge)

    def _relation(self, link: Link) -> Unjudged:
        """Return the row of a relation."""
        words = self.reading.span(link.start, link.end)
        if link.relation == "way":
            return self._way(link, words)
        if link.relation == "beneath":
            return self._beneath(link, words)
        if link.relation == "bare" and mentions(link.objects):
            tops = tuple(name for to in mentions(link.objects) for name in self.names.get(to.thing, ()))
            words = words if " " in words else f"nothing {words} {as_row.shown(link.objects[0])}"
            return Unjudged(words, "refusal", "nothing on top", partial(as_row.bared, tops), tops)
        about = ", ".join(as_row.shown(mention) for mention in link.subjects)
        to = " and ".join(as_row.shown(item) for item in link.objects if link.relation != "aloft")
        own, led = about in words.lower(), not to or to in words.lower()  # as in phrases that stand for others
        said = [*[about] * (not own), words, *[to] * (not led)]
        said = [to, "with", words] if own and not led and link.relation == "with" else said
        said = [words, about] if link.relation == "cleared" else said
        implied = [mention for mention in link.subjects if mention.thing.implied]
        said = [words] if implied and implied[0].thing.spans == [(link.start, link.end)] else said
        understanding = " ".join(said).strip()
        demands = self.demander.demands(link)
        if not demands and place_in(link.objects, "ceiling") and link.subjects:
            things = tuple(name for mention in link.subjects for name in self.names.get(mention.thing, ()))
            return Unjudged(understanding, "relation", "hangs from the ceiling", partial(as_row.hung, things), things)
        if not demands:
            return as_row.unread(understanding, "nothing that the vocabulary can say")

        def judge(room: Furnished) -> Finding:
            placed = set(room.layout)
            outcomes = [d.measure(room.scene, room.layout) if d.names() <= placed else None for d in demands]
            bad = [outcome for outcome in outcomes if outcome is None or not outcome.met]
            shown = next((outcome for outcome in bad or outcomes if outcome is not None), None)
            text = shown.text if shown is not None else "not placed"
            share = f"{len(outcomes) - len(bad)} of {len(outcomes)}: " if len(outcomes) > 1 else ""
            return met(not bad, share + text)

        things = tuple(dict.fromkeys(name for demand in demands for name in sorted(demand.names())))
        said = "; ".join(dict.fromkeys(as_row.said(demand) for demand in demands[:2]))
        return Unjudged(understanding, "relation", said + " ..." * (len(demands) > 2), judge, things, demands)

    def _left_out(self, link: Link, row: Unjudged) -> Iterator[Unjudged]:
        """Yield the things of a relation that its row asks nothing of, while it does of others, or of some in line with them."""
        others = (k for k in self.reading.parsed.links if k is not link and k.relation in ("abreast", "row"))
        lines = [named(k.subjects) for k in others]
        about = {thing for thing, names in self.names.items() if {*names} & {*row.things}}
        lined = {thing for line in lines if line & about for thing in line}
        for item in mentions((*link.subjects, *link.objects)) if row.demands else ():
            if self.names.get(item.thing) and item.thing not in about | lined:
                yield as_row.unread(f"{as_row.shown(item)}: {row.words}", "nothing is asked of it there")

    def _way(self, link: Link, words: str) -> Unjudged:
        """Return the row of a way: the body, or a disc of the width that is told, gets up to all that is named, or to everything."""
        wide = link.metres[0]
        to = " and ".join(as_row.shown(item) for item in link.objects)
        things = tuple(name for item in mentions(link.objects) for name in self.names.get(item.thing, ()))
        if link.metres[1] and not link.objects:
            on_floor = (one for one in self.scene.assets if one.on_floor)
            things = tuple(one.name for one in on_floor if not (one.is_flat or one.lies_about))
        room = self.scene.room
        there = (place_in([item], "door", "window") for item in link.objects)
        places = [openings(room, place.name) for place in there if place is not None]
        if not things and not any(places):
            return as_row.unread(f"{words} {to}".strip(), "nothing that a way can lead to")

        def judge(furnished: Furnished) -> Finding:
            walked = furnished.walked_by(wide)
            if walked is None:
                return "not judged", ""
            if walked.is_empty:
                return met(False, "there is none")
            ends: list[list[BaseGeometry]] = [
                [footprint(furnished.scene, furnished.layout, AssetRef(name))] for name in things
            ]
            for found in filter(None, places):
                sills = (
                    (room.walls[o.wall].point(o.offset), room.walls[o.wall].point(o.offset + o.width)) for o in found
                )
                ends.append([LineString(sill) for sill in sills])
            away = max(min(end.distance(walked) for end in nearest) for nearest in ends)
            left = max(0.0, away - max(wide / 2, furnished.scene.agents[0].radius))
            return met(left <= as_row.UP_TO, f"the way ends {left:.2f} m before it")

        meant = f"a way {wide:g} m wide" if wide else "a way for the body"
        return Unjudged(f"{words or 'a way to'} {to}".strip(), "way", meant, judge, things)

    def _beneath(self, link: Link, words: str) -> Unjudged:
        """Return the row of what a body gets under: its middle does."""
        things = tuple(name for item in mentions(link.objects) for name in self.names.get(item.thing, ()))
        said = f"{words} {' and '.join(as_row.shown(item) for item in link.objects)}"
        if not things:
            return as_row.unread(said, "under no thing")

        def judge(room: Furnished) -> Finding:
            if room.walked is None:
                return "not judged", ""
            feet = [footprint(room.scene, room.layout, AssetRef(name)) for name in things]
            least = min(room.walked.intersection(foot).area for foot in feet)
            return met(least > as_row.UNDER, f"its middle gets under {least:.2f} m2 of it")

        return Unjudged(said, "way", "the body gets under it", judge, things)

    def _nothing_else(self, room: Furnished) -> Finding:
        """Judge that nothing is there but what was named."""
        added = room.layout.keys() - {name for names in self.names.values() for name in names}
        return met(not added, f"{', '.join(sorted(added)) or 'nothing else'} there")

    def _refusal(self, noun: str, kinds: Set[str], words: str) -> Unjudged:
        def judge(room: Furnished) -> Finding:
            there = [asset.name for asset in room.scene.assets if category_of(asset).name in kinds]
            return met(not there, f"{', '.join(there) or 'none'} there")

        return Unjudged(words, "refusal", f"no {noun}", judge)


def stand_ins(scene: Scene, things: Sequence[NamedThing]) -> dict[NamedThing, tuple[str, ...]]:
    """Return the names of the assets that stand for each thing; one asset stands for one thing only.

    The same words come first, then the same kind, then the same last word ("bed" for a single bed). A plural without a number
    takes all that are left; where there are not so many of a kind, another one of which there are.
    """
    free = [asset for asset in scene.assets]
    found: dict[NamedThing, tuple[str, ...]] = {}
    for tier in TIERS:
        for thing in things:
            have = found.get(thing, ())
            short = thing.count - len(have)
            if short <= 0 or (have and tier is _same_head):
                continue
            fits = [asset for asset in free if tier(asset, thing)]
            if not have and len(fits) < short:
                alike = Counter(asset.category for asset in free if _same_head(asset, thing))
                if short <= max(alike.values(), default=0):
                    continue  # the chairs of the desks are meant, and not the few of a table
            others = any(other.noun.kind == thing.noun.kind for other in things if other is not thing)
            taken = fits if thing.uncounted and not others else fits[:short]
            free = [asset for asset in free if asset not in taken]
            found[thing] = (*have, *(asset.name for asset in taken))
    for thing in (one for one in found if one.uncounted and found[one]):
        others = [other for other in things if other is not thing and other.noun.kind == thing.noun.kind]
        if others and not any(other.plural for other in others):  # "chairs, and the host's chair at the head"
            more = [asset for asset in free if asset.category == scene.by_name[found[thing][0]].category]
            free = [asset for asset in free if asset not in more]
            found[thing] += tuple(asset.name for asset in more)
    return found


def _is_box(asset: Asset) -> bool:
    return asset.path is None and not asset.parts


def _same_words(asset: Asset, thing: NamedThing) -> bool:
    words = words_for(asset)
    return thing.noun.words in words or (thing.noun.said in words and not thing.of_pet)


def _same_kind(asset: Asset, thing: NamedThing) -> bool:
    if thing.noun.kind.startswith("unknown"):
        return thing.noun.said in singular(plain(asset.description))
    return category_of(asset).name == thing.noun.kind


def _same_head(asset: Asset, thing: NamedThing) -> bool:
    category = singular(plain(asset.category)).split()
    said = [word for word in thing.noun.said.split() if word not in grammar().sizes]
    if thing.of_pet or not category:
        return False
    if len(said) != 1:
        return thing.head == category[-1] and len(category) == 1
    return category[-1] == said[0] or {**KIN, "blackboard": "board"}.get(category[-1]) == said[0]


TIERS = (_same_words, _same_kind, _same_head)
"""How assets are found to be what was named, the likeliest first."""


def share_met(rows: tuple[AskedRow, ...]) -> float:
    """Return the share of the understood rows that are met; 1 where there are none."""
    judged = [row.verdict == "met" for row in rows if row.verdict in ("met", "unmet")]
    return sum(judged) / len(judged) if judged else 1.0
