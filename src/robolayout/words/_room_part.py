"""A part of the room by what one does there, by its name or its place: what stands in it, and what stands for it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from robolayout.words import _function_words as small
from robolayout.words._chunk import Chunk
from robolayout.words._said import Item, Link, Mention, NamedThing, Parsed, named, place_in, take


@dataclass(eq=False)
class RoomPart:
    """A part of the room."""

    things: list[Mention] = field(default_factory=list[Mention])  # what was first named as being there
    half: bool = False  # whether it is a half of the room by its name
    place: tuple[Chunk, Sequence[Item]] | None = None  # where it is, if that is said: a relation, and to what
    area: Chunk | None = None  # what names it by what one does there, or as a further room
    first: NamedThing | None = None  # what stands for it where a relation leads to it

    def links(self, said: Parsed) -> Iterator[Link]:
        """Yield where its things stand, given what is said of them: all in a half of the room, else the first at the place."""
        if self.area is not None:
            yield from self._furnished(self.area, said)
            yield from self._together(self.area, said)
        if self.place is None:
            return
        chunk, objects = self.place
        placed = {thing for k in said.links if place_in(k.objects) for thing in named(k.subjects)}
        free = [m for m in self.things if m.thing.category.on_floor and m.thing not in placed]
        if free:
            lined = self.area is not None and self.area.value == "kitchen" and place_in(objects, "wall")
            about = tuple(free if lined or place_in(objects, "side") else free[:1])
            low, high = chunk.measure.values if chunk.measure else (0.0, 0.0)
            yield Link(chunk.value, about, tuple(objects), chunk.start, chunk.end, (low, high))

    def _furnished(self, area: Chunk, said: Parsed) -> Iterator[Link]:
        """Add what belongs there where nothing is said to stand there, and yield that it stands together."""
        rooms = [fact for fact in said.facts if fact.kind == "room"]
        usual = not (self.place or self.first) and area in rooms[:1]
        kinds = small.AREAS[area.value]
        seat = next(iter(kinds)).split()[-1] in small.SEATS
        own = [m for m in self.things if m.thing.category.on_floor and not m.flat and (seat or not m.sat_on)]
        cushions = any(m.thing.head in ("cushion", "pillow") for m in self.things)
        own = own or [m for m in self.things if m.flat and cushions]  # "a reading corner with a rug and cushions"
        named_here = [thing for thing in said.things if not thing.implied]
        stood_for = self.first.noun.kind if self.first is not None else ""  # "facing the dining area, a table for six"
        own = own or [Mention(thing) for thing in named_here if thing.noun.kind == stood_for]
        if own and self.first is not None:
            said.instead(self.first, own[0])
        if own or (area.kind == "room" and (usual or len(rooms) < 2)):
            return
        times = area.number or 1 + area.plural  # "two sitting areas"
        there = {thing.noun.kind for thing in named_here} | {m.thing.head for m in self.things}
        there |= small.SEATS if any(m.sat_on for m in self.things) else set[str]()
        there |= {word for noun, _ in said.refused for word in (noun.kind, noun.said.split()[-1])}
        # elsewhere than what is told, where the part of the room has its own place
        told = {thing for k in said.links for thing in named(k.subjects) if self.place}
        made = list[Mention]()
        for number, (kind, count) in enumerate(kinds.items()):
            alike = [t for t in named_here if t.noun.kind == kind and t not in told] if number == 0 else []
            alike = [self.first] if number == 0 and self.first is not None else alike
            refused = any(noun.kind == kind for noun, _ in said.refused)
            if not alike and not refused and (number == 0 or not {kind, kind.split()[-1]} & there):
                alike = [said.implied(kind, count * times, area)]
            made += [Mention(thing) for thing in alike[:1]]
        self.things[:0] = made
        standing = [m for m in self.things if m.thing.category.on_floor and not m.flat]
        if not standing:
            return
        first, *others = standing
        alone = area.value != "kitchen" and times == 1
        near = [m for m in others if alone and not m.sat_on]
        yield from (Link("near", (other,), (first,), area.start, area.end) for other in near[:1])

    def _together(self, area: Chunk, said: Parsed) -> Iterator[Link]:
        """Yield that what is named as being there, and of which nothing else is said, is near what stands for it."""
        # all are in that half of the room
        halved = self.place is not None and place_in(self.place[1], "side") is not None
        if halved or area.value not in small.GATHERED or (area.number or 1 + area.plural) > 1:
            return
        standing = [m for m in self.things if m.thing.category.on_floor and not m.thing.implied]
        standing.sort(key=lambda m: m.flat)
        told = {thing for k in said.links for thing in (*named(k.subjects), *named(k.objects))}
        if not standing:
            return
        first, *others = standing
        for thing in (m.thing for m in others if first.thing.head in small.LOUNGE and not m.thing.promising):
            if thing.noun.kind == "round table":  # one does not eat at it
                take(thing, "side table")
        yield from (Link("near", (m,), (first,), area.start, area.end) for m in others if m.thing not in told)
