"""What is said of the floor between things, of doors, windows and walls: aisles, gaps and free floor, what a wall has."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations, takewhile

from robolayout.words import _function_words as small
from robolayout.words._about import About
from robolayout.words._chunk import Chunk
from robolayout.words._lexicon import grammar
from robolayout.words._said import Item, Link, Mention, Place, mentions, place_in, place_of, sides
from robolayout.words._tokens import Measure
from robolayout.words._ways import CROWD, KEPT_OFF, MIDDLE_AISLE

ENDS_OF_TOPS = {"leftend": "left", "rightend": "right"}
"""Relations to the ends of a thing, by those to its sides that they are where nothing lies on it."""

BEARERS = frozenset((*small.TOPS, *small.BEARING, "workbench"))
"""Last words of what has a top."""


class Spaces(About):
    """Reads what is free or parts things, and what walls, doors and windows are said to be like or to have."""

    def _free_space(self, chunk: Chunk, measure: Measure) -> bool:
        """Note floor that is to stay free at a side of a thing: "1.5 m of free space on the left of the bed"."""
        ahead = list(takewhile(lambda c: c.kind in ("filler", "function", "part", "style"), self.chunks[self.at :]))
        led, after = self._ahead(len(ahead)), self._ahead(len(ahead) + 1)
        # "1.5 m of free space beside the bed and 1.2 m in front of it"
        also = self.said.last.relation == "cleared" and self.said.last.start >= self.began
        told = {word for c in ahead for word in (c.value, *c.adjectives)} & {*small.FREE, "space"}
        # "with 90 cm on each side of the bed"
        free = also or told or (led.value == "flank" and self._ahead(-2).kind == "with")
        its, following = led.det == "its", after.kind in ("thing", "pron")  # "1 m of clear space on its right"
        # "80 cm free on both sides", "90 cm free on left side"
        both = bool(self.group) and led.value in small.FREED and not (its or following)
        every = (led.value, after.value, after.det) == ("on", "side", "all")
        of = [c.kind for c in self.chunks[self.at + len(ahead) + 2 :][:2]] == ["filler", "thing"]
        whole = every and of  # "on all sides of the table"
        every = every and (whole or bool(self.group))
        known = both or every or (led.value in (*small.FREED, "amid") and (its or following))
        if measure.kind != "length" or not (free and known):
            return False
        own = after.value == "it" and [c.kind for c in self.chunks[self.at - 3 : self.at - 1]] == ["thing", "with"]
        self._understood(*ahead)
        self.at += len(ahead) + 1 + (every or own) + whole
        end = self._ahead(-1).end
        self.about = []  # floor, no thing
        before = both or own or (every and not whole)  # "a window and a table with 1 m of free space around it"
        whose = self.group[-1:] if before else self._meant("it", led.value) if its else self._objects(led)
        about = mentions(whose)
        sides = [Place("side", (side,)) for side in small.FREED.get("around" if every else led.value, ())]
        how, on, to = ("cleared", about, sides) if sides else ("apart", about[:1], about[1:])  # "between the two"
        self.said.links.append(Link(how, (*on,), (*to,), chunk.start, end, (measure.values[0], math.inf)))
        return True

    def _hung_at(self, chunk: Chunk, measure: Measure) -> bool:
        """Note how high the middle, or the lower edge, of a thing is that hangs on a wall: "a mirror 1.5 m above the floor"."""
        last = (self.acted or self.group)[-1:]
        said = (last, self.holder if self.having else [])  # "shelves with toys at child height"
        found = ([one for one in there if one.walled or one.thing.noun.said == "shelf"] for there in said)
        hung = next((there for there in found if there), [])
        if self._ahead().value != "aloft" or not hung:
            return False
        by_edge = "edge" in self._ahead().adjectives
        self.at += 1
        if not any("wall" in kind.places for one in hung for kind in one.thing.noun.categories):
            self.said.missed.append(chunk)  # "toy shelves at child height"
            return True
        metres = (measure.values[0], 0.0 if by_edge else 0.5)
        self.said.links.append(Link("aloft", (*hung,), (Place("wall"),), chunk.start, self._ahead(-1).end, metres))
        return True

    def _aisles(self, chunk: Chunk, measure: Measure) -> bool:
        """Note how far rows are apart, or how wide ways are, by what is between: "aisles 1.5 m wide", "with 2 m aisles"."""
        said = self._here if self.group or self.subject else self.said.links  # "The aisles between them are 2 m wide."
        rows = [link for link in said if link.relation == "rows"]
        follows = self._ahead().value in ("aisle", "aisles")
        # "a 1.2 m aisle between them"
        amid = follows and (self._ahead(1).value, self._ahead(2).kind) == ("amid", "pron")
        here = self._ahead(0 if follows else -2)
        if not (here.value == "aisles" or (rows and amid)):
            return False
        led = self.chunks[self.at : self.at + (3 if amid else follows)]
        self._understood(*led)
        self.at += len(led)
        self._parted(rows[-1:], here, (min(chunk.start, here.start), max(chunk.end, here.end)), measure.values[0])
        self.having, self.holder = False, []  # "racks with 1.2 m aisles and a desk near the entrance"
        return True

    def _along_an_aisle(self, chunk: Chunk) -> bool:
        """Note what an aisle parts: two rows, or two columns of benches: "five pews on each side of an aisle" are ten."""
        said = self._here if self.group or self.subject else self.said.links  # "There is an aisle down the middle."
        rows = [link for link in said if link.relation in ("rows", "columns")]
        middle = chunk.value == "middle" or (chunk.value, self._ahead().value) == ("in", "middle")
        if rows and (middle or chunk.value == "amid") and self._ahead(-2).value == "aisle":
            first, _ = self.at - 2, self._objects(chunk)
            columns = rows[-1].relation == "columns" and rows[-1].rows == 2
            if columns:  # "two columns of six with an aisle between them"
                many = sum(m.count for m in rows[-1].subjects) // 2
                index = self.said.links.index(rows[-1])
                self.said.links[index] = rows[-1] = replace(rows[-1], relation="rows", rows=many)
            if columns or (middle and (rows[-1].rows != 2 or all(m.sat_on for m in rows[-1].subjects))):
                self._understood(*self.chunks[first : self.at])  # "six rows of chairs with an aisle in the middle"
                self.said.links[self.said.links.index(rows[-1])] = replace(rows[-1], sided="aisle")
            else:  # "two rows with an aisle between them"
                aisle = self.chunks[first]
                self._parted(rows, aisle, (aisle.start, self._ahead(-1).end), MIDDLE_AISLE)
            return True
        benches = [mention.thing for mention in self.group[-1:] if mention.thing.head in ("pew", "bench")]
        ends = self._ahead().kind in ("", "stop") and [thing.head for thing in self.said.things] == ["pew"]
        if chunk.value != "flank" or not benches or not (ends or self._ahead().value == "aisle"):
            return self._at_both_sides(chunk)
        benches[0].number = benches[0].count * 2 if {"each", "either"} & {*chunk.adjectives} else benches[0].number
        on, width = tuple(self.group[-1:]), (MIDDLE_AISLE, math.inf)
        self.said.links.append(Link("columns", on, (), chunk.start, chunk.end, width, rows=2))
        return True

    def _parted(self, rows: Sequence[Link], aisle: Chunk, span: tuple[int, int], metres: float) -> None:
        """Note how many metres rows are apart at least, by the aisle that is said to be between them; without rows all ways."""
        self._understood(aisle)
        self.said.facts[:] = [fact for fact in self.said.facts if fact is not aisle]
        how, about = ("apart", rows[-1].subjects) if rows else ("way", ())
        self.said.links.append(Link(how, about, (), *span, (metres, math.inf)))

    def _at_both_sides(self, chunk: Chunk) -> bool:
        """Note two opposite walls for what is at the sides of nothing else: "a galley kitchen with counters on both sides"."""
        things = [mention.thing for mention in self.group]
        alone = things == self.said.things and not (things[1:] or self.said.links)
        ends = self._ahead().kind in ("", "stop", "comma")
        if chunk.value != "flank" or not (things and alone and ends and things[0].category.on_floor):
            return False
        if {"each", "either"} & {*chunk.adjectives} and things[0] not in self.dealt:
            things[0].number = 2 * (things[0].number or 1)
        walls = Place("wall", ("opposite",), plural=True)
        self.said.links.append(Link("wall", tuple(self.group), (walls,), chunk.start, chunk.end))
        return True

    def _in_turn(self, chunk: Chunk, objects: list[Item]) -> bool:
        """Link each of several things to its own: "next to the window and the door, respectively"."""
        rest = takewhile(lambda other: other.kind != "stop", self.chunks[self.at :])
        if all(other.value != "respectively" for other in rest):
            return False
        own = self.subject if len(self.subject) > 1 else self.group
        own = own if len(own) > 1 else [Mention(m.thing, slice(i, i + 1)) for m in own for i in range(m.thing.count)]
        to: list[tuple[Chunk, Item]] = []
        for item in objects:
            to += [(chunk, one) for one in (item.apart if isinstance(item, Place) else [item])]
        while len(to) < len(own) and self._ahead().kind in ("and", "comma", "rel"):
            chunk = self._ahead() if self._ahead().kind == "rel" else chunk
            self.at += 1
            to += [(chunk, item) for item in [self._object(chunk)] if item is not None]
        for one, (how, item) in zip(own, to, strict=False):
            self._link(how, [one], [item])
        self.acted = own
        return len(own) == len(to)

    def _far_apart(self, chunk: Chunk) -> bool:
        """Note that each of several things is far from each other one: "a bed, a desk and a sofa, but not near each other"."""
        who = list(self.group or self.subject or self.before)
        one = who[0].thing if len(who) == 1 and who[0].several and who[0].pick is None else None
        who = [Mention(one, slice(i, i + 1)) for i in range(one.count)] if one is not None else who
        kept = chunk.value == "far" or (self.refusing and chunk.value in small.NEARNESS)
        if not kept or self._ahead().value not in ("each other", "one another") or not 1 < len(who) <= CROWD:
            return False
        self.refusing, self.at = False, self.at + 1
        pairs = combinations(who, 2)
        self.said.links += [Link("far", (b,), (a,), chunk.start, self._ahead(-1).end) for a, b in pairs]
        return True

    def _keep_empty(self, chunk: Chunk, objects: Sequence[Item]) -> None:
        """Note that nothing is to stand at a place."""
        gap = (0.0, 0.0) if place_in(objects[:1], "wall") else (KEPT_OFF, math.inf)
        self.said.links.append(Link("bare", (), tuple(objects), chunk.start, chunk.end, gap))

    def _on_opening(self, chunk: Chunk) -> None:
        """A door or window: it is asked for where a wall is told, or a number, or "a"."""
        if self.refusing and chunk.value == "window":
            if self._ahead().kind != "rel":  # "a bedroom with no windows", but not "no window on the north wall"
                self._understood(self._ahead(-2))
                self.said.openings.append((replace(place_of(chunk), number=0), (chunk.start, chunk.end)))
            return
        at = self.fronted[1][:1] if self.fronted is not None and not self.group else []
        wall = self._opening_wall() or place_in(at, "wall") or Place("wall", sides(chunk))
        if wall.words or wall.by or self.holder or chunk.number or chunk.det == "a" or chunk.opening is not None:
            place = replace(place_of(chunk), words=wall.words, by=wall.by)
            self.opening = self.opening if self.group or self.subject else place
            self.said.openings.append((place, (chunk.start, self._ahead(-1).end)))

    def _on_surface(self, chunk: Chunk) -> None:
        """A wall or the floor: how it looks, that it stays free, what it has ("the north wall has a sofa")."""
        free = next((c for c in (self._ahead(), self._ahead(1)) if c.value in small.FREE), None)
        coloured = bool(set(chunk.adjectives) - set(grammar().walls))
        if coloured:
            self.said.facts.append(Chunk("style", chunk.start, chunk.end, " ".join((*chunk.adjectives, chunk.value))))
        if chunk.value == "floor":
            return
        if free is not None:
            self.said.links.append(Link("bare", (), (place_of(chunk),), chunk.start, free.end))
            return
        wall = self._which_wall(place_of(chunk))
        starts = self._previous(chunk) in ("", ".", ";", "\n")  # "North wall: a sofa"
        follows = self._ahead()
        if follows.kind in (("with", "colon") if starts else ("with",)):
            self.at += 1
            self.fronted, self.group = (Chunk("rel", chunk.start, follows.end, "on"), [wall]), []
            self._understood(chunk, follows)
        elif (follows.kind, self._ahead(1).kind) == ("verb", "style"):  # "the walls are white"
            self._understood(chunk)
        elif not coloured:
            self.said.missed.append(chunk)

    def _opening_wall(self) -> Place | None:
        """Return the wall that a door or window is in, if it is said: "in the south wall", "to the south", "opposite the door"."""
        more = 0
        while self._ahead(more).kind in ("verb", "filler", "rel"):
            more += 1
        at, how = self._ahead(more), self._ahead(more - 1).value
        if how in ("left", "right") and at.kind not in ("thing", "part", "pron"):
            self.at += more
            return Place("wall", (how,))
        across = how == "opposite" and at.value in ("window", "door")
        if not (across or (more and (at.value == "wall" or (at.value == "side" and sides(at))))):
            return None
        self.at += more + 1
        return Place("wall", by=(how, place_of(at))) if across else self._which_wall(place_of(at))

    def _on_a_top(self, chunk: Chunk, subjects: Sequence[Mention], objects: list[Item]) -> tuple[Chunk, list[Item]]:
        """Return how and on what things stand that are said to be at an end, on one side or in the middle of a top; else what is given."""
        laid, top = False, list[Item]()
        if chunk.value in ENDS_OF_TOPS:  # "a lamp at the right end of the desk"
            top += [m for m in mentions(objects) if m.thing.head in BEARERS]
            laid = bool(top) and all(m.thing.category.on_object for m in subjects)
            chunk = replace(chunk, value=ENDS_OF_TOPS[chunk.value])
        top = top if laid else self._on_what(chunk, subjects, objects)
        half = (f"{chunk.value} half", tuple(subjects), tuple(top), chunk.start, chunk.end)
        self.said.links += [Link(*half)] * bool(top and chunk.value != "middle")
        return (replace(chunk, value="on"), top) if top else (chunk, objects)

    def _on_what(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Item]) -> list[Item]:
        """Return the top whose left, right or middle is meant: "a desk with a lamp on the left and a computer in the middle".

        What can stand nowhere but on something is on what it is said to be to the left of: "a vise at the right end of the bench".
        """
        if objects:
            tops = [one for one in mentions(objects) if one.thing.head in BEARERS]
            only = [one for one in subjects if one.thing.places == ("object",) and not one.thing.noun.others]
            there = chunk.value in ("left", "right") and chunk.det != "its" and len(only) == len(subjects) > 0
            may = all(m.thing.category.on_object and "wall" not in m.thing.places for m in subjects)
            may = may and all(m.thing.noun.said not in small.LIGHTS for m in subjects)
            return [*tops] if there or (chunk.value == "end" and subjects and may) else []
        here = self._here
        halved = any(link.relation.endswith(" half") for link in here)
        before = here[-1].objects if here and here[-1].relation == "on" else ()
        last = self.holder if self.having else self.every[0] if self.every else mentions(before)
        top = [m for m in last if m.thing.head in BEARERS]
        sided = chunk.value in ("left", "right") or (chunk.value == "middle" and halved)
        return [*top] if sided and subjects and all(m.thing.category.on_object for m in subjects) else []

    def _across_from_its_wall(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Item]) -> None:
        """Note that things are at the wall across from that of others: "a dresser is against the wall opposite the beds"."""
        last, to = self.said.last, mentions(objects)
        wall = place_in(last.objects[:1], "wall")
        told = wall is None or wall.words or wall.by or wall.plural or chunk.start - last.end > len(("the", "wall"))
        walled = all((one.walled and not one.sat_on) or one.thing.head in small.SLEPT_ON for one in to)
        if chunk.value == "opposite" and to and walled and not told and list(last.subjects) == list(subjects):
            across = Place("wall", ("opposite",))
            self.said.links[-1] = replace(last, relation="atwalls", objects=(across, *to))
