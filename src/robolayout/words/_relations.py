"""Relations in words: what they are about, what they lead to, and what says no more than where the room is."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

from robolayout.words import _function_words as small
from robolayout.words._chunk import Chunk
from robolayout.words._holding import Holding
from robolayout.words._lexicon import Noun
from robolayout.words._said import Item, Link, Mention, NamedThing, Place, mentions, named, place_in, place_of
from robolayout.words._tokens import ROOMS, Measure
from robolayout.words._ways import KEPT_OFF

LIKELY = (0.5, 1.6)
"""Least and most by which a thing differs from usual whose size is said after it, where the room could be meant as well."""

SIDES = ("long", "wide", "deep", "across", "diagonal")
"""Measures that are of one side of a thing."""


class Relating(Holding):
    """Reads relations; the parser reads the rest."""

    def _fact(self, chunk: Chunk) -> None:
        if chunk.measure is not None and chunk.measure.kind == "size" and chunk.measure.values[2:]:
            *sides, height = chunk.measure.values  # "4 x 5 x 2.7 m"
            self._fact(replace(chunk, measure=replace(chunk.measure, kind="height", values=(height,))))
            chunk = replace(chunk, measure=replace(chunk.measure, values=tuple(sides)))
        further = chunk.kind == "corner" or any(fact.kind == "room" for fact in self.said.facts)
        if (
            self.refusing and further and chunk.kind in ("room", "corner") and chunk.value in small.AREAS
        ):  # "no sitting area": none of what it has first
            kind = next(iter(small.AREAS[chunk.value]))
            if all(thing.noun.kind != kind for thing in self.said.things):
                self.said.refused.append((Noun(kind, kind, kind), (chunk.start, chunk.end)))
            self._understood(chunk)
            return
        self.said.facts.append(chunk)
        if chunk.kind in ("people", "body") and chunk.det == "each" and self._previous(chunk) == "for" and self.group:
            thing = self.group[-1].thing  # "a wardrobe for each patient"
            thing.number, thing.everyones = thing.number or 1, True
        if chunk.kind in ("room", "corner"):
            self._new_zone(chunk)
        if "windowless" in chunk.adjectives:
            self.said.openings.append((Place("window", number=0), (chunk.start, chunk.end)))
        for mention in self.subject or self.group if chunk.kind == "style" and self.verb else ():
            mention.thing.told.append(chunk.value)  # "the bed is brown"
        if chunk.measure is not None and chunk.measure.kind == "grid" and self.group:
            rows = int(chunk.measure.values[0])
            self.said.links.append(Link("rows", (self.group[-1],), (), chunk.start, chunk.end, rows=rows))
        by = ("for", "of") if self._sat_at() else ("for",)  # "tables of six people", but no pictures of them
        told = chunk.kind == "people" and chunk.number and self._previous(chunk) in by
        if told and self._promised(chunk.number or 0, -3):
            self.said.facts[-1:] = [chunk, replace(chunk, kind="seats")]

    def _of_the_subject(self, measure: Measure) -> bool:
        """Note a height that no room has as that of what the sentence is about: "the table, where I fold, should be 0.9 m high"."""
        about = (self.subject or self.group)[:1]
        own = measure.kind == "height" and measure.values[0] < ROOMS["height"][0] and bool(about)
        it = any(chunk.value == "it" and chunk.start >= self.began for chunk in self.chunks[: self.at])
        own = own or (measure.kind in SIDES and it and bool(about))  # "It should be 2 m in length."
        if own and measure.fits(about[0].thing.category.size):
            about[0].thing.sizes.append(measure)
            return True
        return False

    def _on_measure(self, chunk: Chunk) -> None:
        """A measure of the thing before it, where it can be one ("a desk that is 1.6 m wide"); else of the room."""
        assert chunk.measure is not None
        if any(read(chunk, chunk.measure) for read in (self._free_space, self._aisles, self._hung_at)):
            return
        before = self.chunks[: self.at - 1]
        while before and (before[-1].kind in ("filler", "verb", "pron", "and", "measure") or before[-1].value == "("):
            before.pop()
        apposed = before[-1:] != [] and before[-1].kind == "comma"
        while apposed and before and before[-1].kind in ("comma", "filler"):  # "a table for four, 1.4 by 0.8 m"
            before.pop()
        spans = [(before[-1].start, before[-1].end)] if before and before[-1].kind == "thing" else []
        thing = next((thing for thing in self.said.things if thing.spans[-1:] == spans), None)
        own = thing is not None and (not apposed or self._its_own(thing, chunk.measure))
        if thing is not None and chunk.measure.kind == "length" and self._ahead().kind == "rel":
            self.gap = chunk  # "a table 40 cm in front of the sofa"
        elif thing is not None and own and chunk.measure.fits(thing.category.size):
            thing.sizes.append(chunk.measure)
            self._understood(chunk)
        elif self._of_the_subject(chunk.measure):
            self._understood(chunk)
        elif chunk.measure.kind in ("size", "area", "height", "grid"):
            chunk.measure.of_a_room()
            self._fact(chunk)
        else:
            self.said.missed.append(chunk)

    def _its_own(self, thing: NamedThing, measure: Measure) -> bool:
        """Return whether a measure after a thing and a comma is of that, not of the room: "a desk, 1.6 by 0.8 m, stands ..."."""
        before = self.chunks[: self.at - 1]
        if any(c.kind == "pron" for c in takewhile(lambda c: c.kind != "comma", reversed(before))):
            return True  # "three bookcases, all of them 2 m tall"
        if measure.kind not in ROOMS:
            return measure.kind in SIDES and self._ahead().kind not in ("thing", "part")
        usual = thing.category.size
        likely = all(LIKELY[0] <= new / old <= LIKELY[1] for new, old in zip(measure.on(usual), usual, strict=True))
        told = any(c.measure and c.measure.kind == measure.kind and c.measure != measure for c in self.chunks)
        after = self._ahead(self._ahead().kind == "comma").kind in ("verb", "rel")
        return min(measure.values) < ROOMS[measure.kind][0] or likely or told or after

    def _on_with(self, chunk: Chunk) -> None:
        self.refusing = False
        self.fronted = None if self.acted else self.fronted
        who = self._ahead(-2)
        if self._in_an_aid("with"):
            return
        before = [c for c in self.chunks[: self.at - 1] if c.kind not in ("measure", "filler", "style")]
        # "two sofas in a lounge with a piano against the wall"
        if [(c.kind == "room", c.value == "in") for c in before[:-3:-1]] == [(True, False), (False, True)]:
            self.group, self.subject, self.holder, self.target = [], [], [], None
        if who.kind in ("people", "body") and who.det == "each":
            self._each_has([], self._people() or 1)
            return
        which = self.relative and who.value in ("which", "that")
        each = [m for m in mentions(self.said.last.objects) if m.det == "each" and self.said.last.relation == "on"]
        if who.kind == "and" and each:
            self.holder = each  # "every desk holds a lamp and has a chair in front of it"
        elif self.target is not None and self.target.det == "a" and (who.kind == "thing" or which):
            self.holder = [self.target]  # "facing a television with speakers", "a bench, which has a vase on it"
        elif self.group:
            clause = who.kind == "comma" and self.acted and len(self.subject) == 1
            last = self.said.last
            around = last.relation == "around" and who.kind == "comma" and last.start >= self.began
            self.holder = mentions(last.objects)[:1] if around else []  # "a table, a chair at each end, with a vase"
            self.holder = self.holder or [self.subject[0] if clause else self.group[-1]]
        self.having, self.aside = True, who.kind == "comma"
        self.verb = self.listed = False
        head = self.holder[0] if self.holder else None
        if head is not None and head.det in ("each", "both", "all", *small.SHARES) and head.thing.count > 1:
            if head.pick is None:
                alike = [thing for thing in self.said.things if thing.noun.said == head.thing.noun.said]
                self.holder = [Mention(thing, None, head.det) for thing in alike]
            self._each_has(self.holder, sum(mention.count for mention in self.holder))
        # "next to each bed stands a table with a lamp"
        elif head is not None and head.det == "a" and head.thing.times > 1:
            self._each_has([Mention(head.thing, None, "each")], head.thing.count)

    def _each_has(self, holder: list[Mention], times: int) -> None:
        """Read what each of some things or people has, up to the end of the clause."""
        self.every = (holder, times)
        first, had, closed, inner = len(self.said.things), 0, False, list[Mention]()
        while (chunk := self._ahead()).kind in ("thing", "and", "comma", "filler", "style", "with"):
            # "each has a desk with a lamp, and a chair"
            led, also = chunk.kind == "with", self._ahead(-1).kind == "and"  # "a chair, and has a lamp on it"
            inner = self.group[-1:] if led and had else inner if chunk.kind != "comma" else []
            if led and (not inner or self._ahead(1).kind != "thing"):
                break
            self.at += led
            chunk = self._ahead()
            if chunk.kind == "comma" and first < len(self.said.things) and (closed or not self._list_goes_on(had)):
                break
            self.at, had, closed = self.at + 1, had + (chunk.kind == "thing"), closed or chunk.kind == "and"
            own = holder and chunk.noun is not None and chunk.noun.kind == holder[0].thing.noun.kind
            self._understood(*[chunk] * bool(own))  # "six workstations, each consisting of a desk and a chair"
            if chunk.kind == "thing" and self._previous(chunk) == "of":
                self._fact(replace(chunk, kind="function"))  # "a box of slides"
            elif chunk.kind == "thing" and not own:
                mention = self._mention(chunk)
                if mention.thing in self.said.things[first:]:
                    one = holder and holder[0].det != "each" and mention.thing.number is None  # "both have lamps"
                    mention.thing.times, mention.thing.number = times, 1 if one else mention.thing.number
                    self.group = [mention]
                to = inner if led or (mention.topped and self._on_it_follows()) else []
                if (to or holder) and mention.thing in self.said.things[first:]:
                    self.said.links.append(Link("with", (mention,), tuple(to or holder), chunk.start, chunk.end))
                if to and not also and [self._ahead().value, self._ahead(1).value] == ["on", "it"]:
                    self._understood(self._ahead(), self._ahead(1))  # "each has a desk with a lamp on it"
                    self.at += 2

    def _of_the_room(self, chunk: Chunk) -> bool:
        """Note what is asked of the room itself: an open middle, a way to something, room to turn, daylight at it."""
        if chunk.value not in ("open", "way", "beneath", "turning", "light"):
            return False
        told = self.chunks[: self.at - 1]
        while told and told[-1].kind == "filler":
            told.pop()
        wide = told[-1].measure if told and chunk.value in ("way", "turning") else None  # "a 90 cm way"
        self.said.missed[:] = [other for other in self.said.missed if wide is None or other is not told[-1]]
        self._understood(*told[-1:] * (wide is not None))
        found: list[Item] = []
        while chunk.value != "open" and self.at < len(self.chunks):
            following, after = self._ahead(), self._ahead(1)
            joins = following.kind == "and" and found and (after.kind == "part" or after.det == "the")
            if following.kind == "filler" or joins:
                self.at += 1
            elif (item := self._object(chunk)) is not None:
                found.append(item)
            else:
                break
        if chunk.value == "way" and not found and self._ahead(-1).kind == "pron":
            found = [*self.acted]  # "counters along both walls with a walkway between them"
        things = tuple(mentions(found)) if chunk.value == "light" else ()
        if self._ahead().kind == "rel" and mentions(found[-1:]):
            self.group = mentions(found[-1:])  # "a way to the desk by the bed"
        named = {"light": "lit"}.get(chunk.value, chunk.value)
        metres = (wide.values[0], math.inf) if wide is not None else (0.0, 0.0)
        first = told[-1].start if wide is not None else chunk.start
        self.said.links.append(Link(named, things, () if things else tuple(found), first, chunk.end, metres))
        return True

    def _on_rel(self, chunk: Chunk) -> None:
        """A relation: find what it is about, then what it leads to."""
        if chunk.value == "open" and self.verb and self.subject:  # "the table stands free in the middle"
            chunk = replace(chunk, value="middle")
        aided = self._parted_from(chunk) or self._far_apart(chunk) or self._in_an_aid(chunk.value)
        if aided or self._of_the_room(chunk) or self._of_a_place(chunk, self.at - 2) or self._along_an_aisle(chunk):
            return
        if self._of_people() or self._of_what_is_unknown():
            self._objects(chunk)
            led = (self._ahead(-1).kind, self._ahead(-2).kind) == ("rel", "function")
            self._understood(*[chunk] * led)  # "an aisle down the middle"
            return
        every = self._ahead(-2).value in small.EVERY
        subjects = self._subjects(chunk.value)
        in_reach = chunk.value == "near" and chunk.adjectives[-2:] == ("reach", "of")
        if in_reach and self._ahead().kind in ("body", "people"):  # "within reach of a child"
            self.said.links.append(Link("way", (), tuple(subjects), chunk.start, chunk.end))
            return
        if chunk.value == "holds":
            subjects = self._holders(subjects, every=every)
        if chunk.value == "holds" and not subjects:
            self._understood(chunk)
            self._on_with(chunk)
            return
        beyond = self._ahead()
        laid = chunk.value == "on" and any(mention.topped for mention in subjects)  # "a globe on the desk's left side"
        if beyond.kind == "thing" and beyond.value and chunk.value in ("on", "by") and not laid:
            chunk = replace(chunk, value=beyond.value)
        first, its = self.at, chunk.det == "its"
        self.about = [] if chunk.value == "between" or self._turned_round(first, self.at + (not its)) else subjects
        of_it = its and not {"its", "their"} & {*chunk.adjectives}  # "on the right a bed"
        whose = "them" if "their" in chunk.adjectives else "it"
        it = self._led_back(chunk.value) if of_it else self._meant(whose, chunk.value)
        meant = list[Item](it if place_in(it[:1]) else self._standing(mentions(it), chunk))
        objects = meant if its else self._objects(chunk)
        if chunk.value == "amid" and self._ahead(-1).value == "them":
            facing = self._between_the_last()  # "two armchairs opposite the sofa with a table between them"
            two = sum(one.count for one in mentions(facing)) == 2  # "a sofa opposite the TV, a table between them"
            objects = facing if facing and (two or all(one.sat_on for one in mentions(facing))) else objects
        fronted = not subjects or (not self.about and chunk.value != "between")
        self._keep(chunk.value, objects, pronoun=its or self._ahead(-1).kind == "pron", fronted=fronted)
        if not self._in_turn(chunk, objects):
            self._relate_to(chunk, subjects, objects, first, every=every)

    def _one_for_each_pair(self, between: Sequence[Mention], pairs: int) -> None:
        """Note that there are as many things as pairs, if that is said: "each pair facing each other across a small table"."""
        told = any(chunk.value == "each pair" and chunk.start >= self.began for chunk in self.chunks[: self.at])
        for mention in between if told else ():
            mention.thing.times = pairs

    def _of_a_place(self, chunk: Chunk, first: int) -> bool:
        """Note what is at a place of which that is said: "a window above the sink", "the walls are lined with bookshelves"."""
        while first > 0 and self.chunks[first].kind in ("verb", "filler", "style"):
            first -= 1
        place, led = self.chunks[first], first > 0 and self.chunks[first - 1].kind == "rel"
        at = small.AT_A_PLACE.get(place.value, {}).get(chunk.value)
        if at is None or led or place.kind == "rel" or self._ahead().kind != "thing":
            return False
        self._understood(place)
        self.said.missed[:] = [other for other in self.said.missed if other is not place]
        self.group = self.acted = mentions(self._objects(chunk))  # "..., between which a mirror hangs"
        self._link(replace(chunk, value=at), self.group, [place_of(place)])
        return True

    def _relate_to(
        self, chunk: Chunk, subjects: list[Mention], objects: list[Item], first: int, *, every: bool
    ) -> None:
        """Settle what a relation is about and leads to, and note what it says."""
        bare = chunk.value == "on" and not objects and self._ahead().kind in ("and", "comma", "stop", "")
        if chunk.value == "ontop" or bare:  # "a desk with a lamp on"
            on = [k.objects[:1] for k in self._here if k.relation == "on"]
            held = self.holder or [m for m in self.subject if m not in subjects] or list(on[-1] if on else self.subject)
            chunk, objects = replace(chunk, value="on"), objects or list(held)
        chunk, objects = self._other_side(chunk, objects)
        at_a_side = [c.value for c in self.chunks[self.at - 3 : self.at - 1]] == ["side", "of"]
        if chunk.value == "on" and at_a_side and mentions(objects):  # "on all four sides of the table"
            chunk = replace(chunk, value="around" if all(one.sat_on for one in subjects) else "next")
        place = place_in(objects[:1])
        sides = place.name == "side" if place else chunk.value in ("flank", "oneside", "end") and not objects
        last = self.said.last
        if self._said_again(chunk, subjects, objects) or (sides and self._at_sides(chunk, subjects, place)):
            self._understood(chunk)
            return
        backs = chunk.value == "wall" and {"back", "backs"} & {*chunk.adjectives} and not place_in(objects[:1], "wall")
        if chunk.value == "separates" or backs:  # "with its back to the window"
            chunk = replace(chunk, value="turnedfrom" if backs else "amid")
        if "across" in chunk.adjectives and (last.relation, last.end) == ("mutual", chunk.start):
            chunk = replace(chunk, value="amid")  # "two sofas facing each other across a table"
            subjects, objects = mentions(objects), list(last.subjects)
            self._one_for_each_pair(subjects, last.subjects[0].thing.count // 2)
        if chunk.value == "between":  # "1 m between the bed and the wardrobe"
            chunk, subjects = replace(chunk, value="apart"), mentions(objects)[:1]
            objects = [item for item in objects if item not in subjects]
        chunk, objects = self._on_a_top(chunk, subjects, objects)
        if not objects and self._between_two(chunk, last):
            chunk, subjects, objects = replace(chunk, value="in"), self.holder, [Place("side", (chunk.value,))]
            self.holder = []
        subjects, objects = self._held_by(chunk, subjects, objects)
        if chunk.det == "its" and subjects == self.holder:  # "a table with a book to its right and a plant to its left"
            self.holder = []
            self._keep(chunk.value, objects, pronoun=False, fronted=False)
        self._as_many(chunk, subjects, objects, every=every)
        self._relate(chunk, subjects, objects, first)

    def _said_again(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Item]) -> bool:
        """Return whether a relation says no more than the last one: "a plant flanks the door on each side", "back to back in pairs"."""
        last = self.said.last
        if {last.relation, chunk.value} == {"backs", "pairs"} and named(last.subjects) == named(subjects):
            self.said.links[-1] = replace(last, relation="backs")
            return True
        return last.relation == chunk.value == "flank" and last.subjects == tuple(self.acted) and not objects

    def _between_two(self, chunk: Chunk, last: Link) -> bool:
        """Return whether two things are on a side of the room with what is between them: "chairs with a table between them on the left"."""
        held = self.having and last.relation == "amid" and named(last.objects) == named(self.holder)
        return held and chunk.value in ("left", "right")

    def _as_many(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Item], *, every: bool) -> None:
        """Count what each of some things has: "each facing a mirror", "four chairs facing mirrors"."""
        if chunk.number and subjects and subjects[0].thing.number is None:
            subjects[0].thing.number = chunk.number  # "in four rows of six"
        for item in mentions(objects) if subjects else ():
            thing = item.thing
            told = chunk.value in small.REVERSED and item.det != "the"  # "each surrounded by six chairs"
            if every and (item.det == "a" or told or "own" in thing.adjectives) and thing.times == 1:
                thing.times = subjects[0].thing.count
            if subjects[0].thing.times > 1 == thing.times and item.det == "a" and chunk.value in ("front", "next"):
                thing.times = subjects[0].thing.times  # "each with a chair in front of a mirror"
            bare = thing.head == "mirror" and thing.number is None and thing.plural
            if bare and not item.det and chunk.value in ("facing", "front") and subjects[0].several:
                thing.number = subjects[0].count

    def _refused(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Item]) -> None:
        """Note what must not be so: where nearness is refused, a gap is asked for; of what must not be there nothing is."""
        place = place_in(objects[:1])
        barred = chunk.value in ("blocks", "wall")
        if place and place.name == "floor":  # "no rugs on the floor"
            self._understood(chunk)
        elif self.empty and chunk.value == "turnedfrom" and objects:  # "nobody sits with the back to the door"
            self.said.links.append(Link("faced", (), tuple(objects), chunk.start, chunk.end))
        elif self.empty and (place or (chunk.value == "on" and objects)):
            own = chunk.value == "on" and place and place.name in small.OPENINGS_AND_CORNERS
            self._keep_empty(chunk, self.about if own else objects)  # "a desk by the window with nothing on it"
        elif self.negated and subjects and (chunk.value in small.NEARNESS or (barred and place)):
            gap = Measure("apart", (KEPT_OFF, math.inf), 0, 0)
            self._link(replace(chunk, value="apart", measure=gap), subjects, objects)
        elif self.negated and subjects and objects and chunk.value in ("facing", "opposite", "turnedfrom"):
            self._link(replace(chunk, value="faced" if chunk.value == "turnedfrom" else "averted"), subjects, objects)
        self.refusing = False

    def _relate(self, chunk: Chunk, subjects: list[Mention], objects: Sequence[Item], first: int) -> None:
        """Note what a relation says."""
        if self.refusing:
            self._refused(chunk, subjects, objects)
            return
        if chunk.value == "amid" and not objects:
            objects = self._between_the_last() or self._meant("them", chunk.value)
        in_the_room = chunk.value in ("in", "on", "by", "around", "flank") and place_in(objects[:1], "room", "floor")
        if not objects and chunk.value not in small.ALONE:
            self._understood(*[chunk] * (chunk.value in ("in", "by") and self._ahead().kind in small.OF_THE_ROOM))
        elif in_the_room or (chunk.value == "stacked" and [m.count for m in subjects] == [1]):
            self._understood(chunk)
        elif chunk.value in small.REVERSED:
            self._reversed(chunk, subjects, objects)
        elif not subjects and self.fronted is not None and not self.group and (led := mentions(self.fronted[1][:1])):
            self._link(chunk, led, objects)  # "on the desk in the corner stands a lamp"
        elif not subjects and self._of_a_zone(first - 1):
            self._put_zone(chunk, objects)
        elif not subjects or (objects and self._turned_round(first, self.at)):
            place = place_in(self.fronted[1][:1]) if self.fronted is not None else None
            self.also = None if self.group else self.fronted if place else self.also
            self.fronted = (chunk, [*self._across_the_room(objects)])
            self.outer = mentions(objects) if self._ahead(-1).value == "which" else []
            self.group, self.acted = [], []
        elif subjects:
            subjects = self._listed_with(chunk.value, subjects, objects)
            objects = self._across_the_room(objects)
            self._across_from_its_wall(chunk, subjects, objects)
            there = self._walls(subjects, place) if (place := place_in(objects[:1])) else []
            subjects = subjects if there or place is None else self._at_a_place(chunk, subjects, place)
            self._link(replace(chunk, value="atwalls") if there else chunk, subjects, [*objects, *there])
            self.acted = subjects
            self.verb = False

    def _between_the_last(self) -> list[Item]:
        """Return what faces another thing, and that, where it was said last: "two armchairs facing it and a table in between"."""
        own = named(self.about)
        here = [k for k in reversed(self._here) if k.relation != "with" and not named(k.subjects) <= own]
        last = next((link for link in here if link.relation not in ("flank", "around")), None)
        if last is None or last.relation not in ("facing", "opposite"):
            return []
        # "a sofa facing the fireplace, an armchair on each side of the fireplace and a table in between"
        both = named((*last.subjects, *last.objects))
        if any(not named(link.objects) & both for link in here[: here.index(last)]):
            return []
        return [*last.subjects, *last.objects] if mentions(last.objects) else []

    def _of_a_zone(self, index: int) -> bool:
        """Return whether a relation is about a part of the room, so that no thing stands there: "a kitchenette along the wall"."""
        while index > 1 and self.chunks[index - 1].kind in ("verb", "filler"):
            index -= 1
        before = [chunk.kind for chunk in self.chunks[max(index - 2, 0) : index]]
        return self.fronted is None and before[-1:] != [] and before[-1] in small.ZONES and before[0] != "rel"

    def _put_zone(self, chunk: Chunk, objects: Sequence[Item]) -> None:
        """Note where the part of the room is that was named last: "a sleeping area on the left"."""
        side = not objects and chunk.value in ("left", "right")
        place = (replace(chunk, value="in"), [Place("side", (chunk.value,))]) if side else (chunk, objects)
        if self.zone is not None and self.zone.place is None:
            self.zone.place = place
        elif self.zone is not None and self.zone.place is not None and self.zone.place[1] == place[1]:
            self._understood(chunk)  # said again

    def _in_an_aid(self, how: str) -> bool:
        """Note the body of "a person in a wheelchair", "an elderly person with a walker", "accessible by wheelchair"."""
        following, who = self._ahead(), self._ahead(-2)
        moved = (how == "by" and not following.det) or (how == "in" and not self.group)  # "one in a wheelchair"
        moved |= how in ("in", "with") and (who.kind in ("people", "body") or who.value in small.WALKING)
        if following.noun is None or following.noun.kind not in small.AIDS or not moved:
            return False
        self._understood(self._ahead(-1))
        self.at += 1
        self._fact(Chunk("body", following.start, following.end, small.AIDS[following.noun.kind]))
        return True
