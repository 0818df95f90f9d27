"""What relations lead back to where nothing is named, whose they are where a thing has others, and how they are noted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from robolayout.words import _function_words as small
from robolayout.words._chunk import ROWS, Chunk
from robolayout.words._naming import NamingThings
from robolayout.words._said import Item, Link, Mention, NamedThing, Place, mentions, named, place_in, places
from robolayout.words._tokens import about as about_so_far


class References(NamingThings):
    """Finds what relations lead back to, and notes them."""

    def _at_middle(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Item]) -> Sequence[Item]:
        """Return the middle of a wall where "in the middle" was said right before: "a bed in the centre against the wall"."""
        last, to = self.said.last, place_in(objects[:1], "wall")
        middle = [c.value for c in self.chunks if c.end == chunk.start] == ["middle"]
        same = middle and last.relation and last.subjects == tuple(subjects) and not mentions(last.objects)
        if chunk.value != "wall" or to is None or not same:
            return objects
        self.said.links.pop()
        self.said.read.update(range(last.start, last.end))
        return [replace(to, words=(*to.words, "middle"))]

    def _led_back(self, relation: str) -> Sequence[Item]:
        """Return what a relation leads to where nothing is named: "a loft bed with a desk underneath", "a bed on the left"."""
        if relation == "opposite":
            return self._faced()
        reach = self._ahead(-1).adjectives[-1:] == ("reach",)  # "a lamp and a side table within reach"
        heads = {"end": small.TOPS, "foot": small.SLEPT_ON, "near": small.REACHED_FROM if reach else ()}
        if relation in heads and (found := self._last_of(heads[relation], named(self.about))):
            return found  # "a table with ten chairs, a podium at the head"
        last = self.said.last
        if relation == "flank" and last.relation in ("left", "right") and last.start >= self.began and not self.holder:
            return mentions(last.objects)  # "a lectern to the right of the altar and candles on both sides"
        if relation == "above" and last.relation in ("abreast", "row") and last.start >= self.began:
            return [m for m in last.subjects if m.thing not in named(self.about)]  # "side by side, shelves above"
        side, of = self.contrast
        half = [Place("side", (relation,))] if self._of_the_other_half(relation) else []
        if told := of if side == relation and of else half:
            return told  # "to the left of the board is a shelf with boxes, to the right a cabinet"
        if self.holder or relation not in ("left", "right"):  # "a side table within reach and a lamp behind"
            same = self.led if not named(self.led) & named(self.about) else []
            return self.holder or same or self._meant("it", relation)
        alone = named(self.recent) <= named(self.about)
        if not (side == relation and of) and alone and len(self.before) == 1 and not self.before[0].several:
            of = self.before  # "A sofa is in the middle. On the left stands a lamp."
            self.contrast = (small.OTHER_SIDE[relation], of)
        elif side != relation:
            of = []
        if not of and all(mention.thing.noun.kind == "night stand" for mention in self.about):
            of = self._last_of(small.SLEPT_ON, named(self.about))  # "a bed, a desk, one night stand on the right"
        return of or [Place("side", (relation,))]

    def _faced(self) -> list[Mention]:
        """Return what a thing is opposite to where nothing is named: a single seat, bed or desk, "a mirror on the wall opposite"."""
        faced = self._last_of(("desk", "island", *small.SEATS, *small.SLEPT_ON, *small.WATCHED), named(self.about))
        foot = [k.objects for k in self.said.links if k.relation == "foot" and named(faced) & named(k.subjects)]
        faced = mentions(foot[-1]) if foot else faced  # a bench at the foot of a bed
        faced = [m for m in faced if not m.several]
        here = [k.subjects for k in self._here if k.relation != "with"][-1:]
        # "a washer and a dryer along a wall, an ironing board opposite"
        here = here or [self.before]  # "A sofa is at the wall. A desk is opposite."
        return faced or [m for each in here for m in each[:1] if m.thing not in named(self.about)]

    def _of_the_other_half(self, relation: str) -> bool:
        """Return whether a side is that of the room: "on the left a sofa with a table at each end, on the right a desk"."""
        other = (small.OTHER_SIDE.get(relation, ""),)
        return any(place.words == other for k in self.said.links for place in places(k.objects[:1], "side"))

    def _held_by(self, chunk: Chunk, subjects: list[Mention], objects: list[Item]) -> tuple[list[Mention], list[Item]]:
        """Return what a relation is about and leads to, where that is not what a thing has but the thing itself."""
        laid = bool(self.holder) and not self.holder[0].topped and all(m.topped for m in self.group)
        held = self.having and self.holder and (laid or not self.listed)  # "a desk with a laptop, a lamp and a mug"
        if chunk.value == "flank" and not objects and held and self.holder[0].thing.count == 2 and self.recent[2:]:
            own = {self.holder[0].thing, subjects[0].thing}  # "two nightstands with lamps on either side"
            return self.holder, [*[m for m in self.recent if m.thing not in own][:1]]
        if chunk.value == "opposite" and held and not objects and (across := self._across(subjects)):
            return self.holder, across
        hanging = any(kind.on_wall or kind.on_ceiling for one in subjects for kind in one.thing.noun.categories)
        hanging = hanging or any(c.value in small.HANGING for c in self.chunks if c.end == chunk.start)
        laid = chunk.value == "behind" and all(m.topped for m in subjects)  # "a shelf with bottles behind it"
        if (chunk.value == "above" or laid) and held and named(self.holder) & named(objects) and not hanging:
            own = named((*self.holder, *subjects))  # "a desk by the door, a shelf with books above it"
            floor = [m for m in self.recent if m.thing not in own and m.thing.category.on_floor]
            objects = list[Item](m for m in floor if not (laid and m.sat_on))[-1:]  # behind the counter, not its stools
            return (self.holder if objects else []), objects
        if chunk.value == "middle" and not objects and (of := self._middle_of(subjects, having=bool(held))) is not None:
            return subjects, of
        place = isinstance(objects[0], Place) if objects else chunk.value == "middle"
        laid = _of_what_bears(chunk.value, objects) and held and self.group[-1].topped and not self.holder[0].topped
        laid = laid and (chunk.value != "above" or len(objects) > 1)  # "a shelf with bottles above them"
        if laid and chunk.det == "its" and self.target is not None:
            return [self.target], list(self.holder)  # "a bed with a lamp on the nightstand to its right"
        if laid and chunk.det == "its":  # "an armchair by the window, a table with a cup to its right"
            own = named((*self.holder, *self.group))
            last = [mentions(k.objects) or k.subjects for k in self._here if k.relation != "with"][-1:]
            before = [m for said in (self.recent, *last) for m in said if m.thing not in own]
            objects, laid = list[Item](before[-1:]) or objects, bool(before)
        apart = [m for m in mentions(objects) if m.thing not in named(self.holder)]
        if laid and chunk.value == "amid" and sum(m.count for m in apart) > 1:
            objects, laid = list[Item](apart), not apart[0].topped  # "two beds, a table with a lamp between them"
        to_it = named(self.holder) & named(objects)
        laid = laid and not (to_it and chunk.det != "its")  # "a chair with a lamp behind it"
        low = held and not self.group[-1].topped and not self.holder[0].thing.category.on_floor
        sat = held and self.group[-1].sat_on and self.holder[0].thing.head in small.TOPS
        hung = place and not sat and chunk.value in ("on", "hanging") and not place_in(objects[:1], "side")  # a TV
        hung = hung and (hanging or not place_in(objects[:1], "wall"))  # "a shelf with books on the wall"
        sat = sat and (chunk.value != "opposite" or self.group[-1].thing.head not in small.LOUNGE)
        others = [m for m in apart if m.thing.count > 1]
        seated = sat and chunk.value in (*small.STANDING, "amid", "aligned", "square")
        if seated and others and self._ahead(-1).kind == "pron" and self.holder[0].thing.count == 1:
            objects = list[Item](others)  # "two shelves and a table with four chairs in front of them"
        to_it = named(self.holder) & named(objects)
        hangs = held and chunk.value == "above" and self._hangs(self.holder[0].thing)
        laid = laid or bool((seated or hangs) and objects and not to_it)
        seats = held and bool(objects) and self.group[-1].sat_on  # "a table with four chairs on a rug"
        laid = laid or (seats and _over_or_under(chunk.value, objects[0]) and not to_it)
        swapped = (place or laid) and held and not (hung or (low and not hangs)) and subjects == self.group[-1:]
        central = [k for k in self.said.links if k.relation == "middle" and named(self.holder) & named(k.subjects)]
        swapped = swapped and not (central and place_in(objects[:1], "wall", "corner", "window", "door"))
        low = chunk.value == "middle" and held and self.holder[0].sat_on and self.group[-1].thing.head in small.TOPS
        swapped = swapped and not low  # "chairs along the walls, with a table in the middle"
        swapped = swapped and small.FASTENED.isdisjoint(chunk.adjectives[:1])
        built = [m for m in self.group if m.thing.category.built_in and place_in(objects[:1], "wall")]
        return ([*self.holder, *built] if swapped else subjects), objects

    def _middle_of(self, subjects: Sequence[Mention], *, having: bool) -> list[Item] | None:
        """Return of what something is in the middle, where that is not said; None where it is of no thing."""
        if having and self.holder[0].topped:  # "plates on the table, with a candle in the middle"
            on = [list(k.objects) for k in self.said.links if k.relation == "on" and self.holder[0] in k.subjects]
            return on[-1] if on else []
        led = [before.kind for before, c in pairwise(self.chunks[: self.at]) if c.kind == "with"][-1:]
        one = led == ["comma"] or not any(m.several for m in subjects)  # a table with four magazines is there itself
        of = self.holder if having and one else self.every[0] if self.every else []
        # "a table by the wall, with a bowl in the middle"
        return list(of) if of and self.group[-1:] and self.group[-1].topped else None

    def _holders(self, subjects: list[Mention], *, every: bool) -> list[Mention]:
        """Return what of some things holds others: of "a bed and two stands, each" the last, and rather a top than a seat beside it."""
        last = self.said.last
        shelves = [m for m in last.subjects if last.relation == "above" and m.thing.noun.said.endswith("shelf")]
        if shelves and named(subjects) & named((*last.subjects, *last.objects)):
            subjects = shelves  # "a shelf above the toilet holding towels"
        elif len(subjects) == 1 and subjects[0] in last.objects and subjects[-1].sat_on:
            bears = any(mention.thing.head in (*small.TOPS, "stand", "shelf") for mention in last.subjects[:1])
            subjects = list(last.subjects) if bears else subjects
        own = subjects[-1:] if every and subjects and subjects[-1].thing.count > 1 else subjects
        return [Mention(mention.thing, mention.pick, "each") for mention in own] if every else subjects

    def _hangs(self, holder: NamedThing) -> bool:
        """Return whether what has other things hangs itself: a cabinet on the wall, "a shelf with towels above the tub"."""
        shelf = holder.noun.said == "shelf" and self.group[-1].thing.category.on_object
        return not {"floor", "object"} & {*holder.places} or (shelf and any(k.on_wall for k in holder.noun.categories))

    def _across(self, subjects: Sequence[Mention]) -> list[Item]:
        """Return what a thing is opposite with what it bears, or those who sit at it: "a bar with stools opposite"."""
        seats = self.group[-1].sat_on and self.holder[0].thing.head in small.TOPS
        self.about = [*subjects, *self.holder]
        return [*self._led_back("opposite")] if seats or self.group[-1].topped else []

    def _link(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Item]) -> None:
        """Note a relation; what stands at each of several things is as many times there."""
        at_bar = chunk.value in ("left", "right") and not objects and all(mention.sat_on for mention in subjects)
        if at_bar and [mention.thing.head for mention in self.holder] == ["counter"]:
            subjects, objects = self.holder, [Place("side", (chunk.value,))]  # "a bar with five stools on the left"
        self.about = list(subjects)
        led = objects or (self._led_back(chunk.value) if chunk.value in small.LED_BACK else [])
        # "a table with a lamp is in the middle"
        led = [] if chunk.value == "middle" and named(led) & named(subjects) else led
        there = [(b.thing, b.pick) for b in mentions(led)]  # "a stool and a lamp 1 m from the stool": the lamp
        others = [a for a in subjects if not any(a.thing is b and a.pick in (None, pick) for b, pick in there)]
        if (subjects and not others) or (chunk.value in ("above", "behind", "opposite") and not led):
            return  # nothing stands at itself, or behind nothing
        subjects, self.led = others, self.led if objects else mentions(led)
        if chunk.value == "rows" and not chunk.rows and all(m.several and m.thing.number is None for m in subjects):
            for mention in subjects:  # "a library with bookshelves in rows": however many rows these are
                mention.thing.rows = mention.thing.rows or ROWS
        worked_at = [m.count for m in subjects if chunk.value == "on" and m.thing.noun.said in small.WORKED_AT]
        for thing in (m.thing for m in mentions(objects) if worked_at and m.thing.uncounted):
            thing.number = worked_at[0]  # "twelve computers on tables"
        subjects = self._counted(chunk, subjects, objects)
        chunk = self._at_a_side(chunk, subjects, objects, led)
        objects = self._at_middle(chunk, subjects, led)
        if objects:  # "a bed with a lamp on either side": the lamps are not on the bed
            own, to = named(subjects), named(objects)
            over = chunk.value == "above" and not any(mention.laid for mention in mentions(objects))
            elsewhere = chunk.value in ("on", "flank") or self.aside or over
            self.said.links[:] = [k for k in self.said.links if not k.had(own, None if elsewhere else to)]
        low, high = chunk.measure.values if chunk.measure else (0.0, 0.0)
        about = (tuple(subjects), tuple(objects))
        lines = any(wall.plural for wall in places(objects, "wall")) or chunk.value == "rows"  # "lined up in two rows"
        for row in [k for k in self.said.links if lines and k.relation == "row" and k.subjects == about[0]]:
            self.said.links.remove(row)  # "lined up along two opposite walls": no one line
            self.said.read.update(range(row.start, row.end))
        told = (*about, chunk.start, chunk.end, (low, high), chunk.rows)
        topmost = not {"top", "atop"}.isdisjoint(chunk.adjectives)
        alone = chunk.value == "on" and [bearer.count for bearer in named(objects)] == [1]
        at = self._ahead(-1)
        level = chunk.level or at.level * alone  # "on the bottom shelf" of the one unit that was named
        all_of = alone and at.plural and at.noun is not None and at.noun.said == "shelf"  # "on the shelves" of it
        self.said.links.append(Link("in" if level or all_of else chunk.value, *told, chunk.sided, topmost, level))
        if self.gap is not None and chunk.value in ("above", "under"):
            self.said.missed.append(self.gap)  # heights are not told
            self.gap = None
        if self.gap is not None and self.gap.measure is not None:  # "40 cm in front of the sofa"
            low = self.gap.measure.values[0]
            self.said.links.append(Link("apart", *about, self.gap.start, chunk.end, (low, about_so_far(low))))
        self.gap = None

    def _at_a_side(
        self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Item], led: Sequence[Item]
    ) -> Chunk:
        """Return a relation to a side as it is meant: of seats at both sides or at an end of a table, or to a half of the room."""
        if chunk.value == "flank":
            return self._on_both_sides(chunk, subjects, objects)
        table = next((m.thing for m in mentions(led[:1]) if m.thing.has_sides), None)
        island = table is not None and table.head == "island" and sum(m.count for m in subjects) > 1
        if island and chunk.value in ("left", "right") and all(m.sat_on for m in subjects):
            return replace(chunk, value="oneside", adjectives=())  # more than its end holds
        if chunk.value == "end" and table is not None and all(m.sat_on for m in subjects):
            return replace(chunk, value="oneside", adjectives=("end",))
        half = chunk.value in ("left", "right") and place_in(led[:1], "side")
        return replace(chunk, value="in") if half else chunk

    def _other_side(self, chunk: Chunk, objects: list[Item]) -> tuple[Chunk, list[Item]]:
        """Return a relation and what it leads to, where "on the other side" is the other side of what was spoken of."""
        place = place_in(objects[:1])
        if chunk.value == "opposite" and "other" in chunk.adjectives:  # "on the other side of the bed"
            to = mentions(objects)
            tables = bool(to) and all(m.thing.head in small.TOPS and m.several for m in to)
            if tables and all(m.sat_on for m in self.about):
                return replace(chunk, value="around"), objects  # "a stool on the other side of each table"
            said = [k for k in self.said.links if named(objects) & named(k.objects)]
            sides = [k for k in said if k.relation in small.OTHER_SIDE][-1:]
            there = [m for k in sides if small.OTHER_SIDE[k.relation] == "otherside" for m in k.subjects]
            return (replace(chunk, value=small.OTHER_SIDE[sides[0].relation]) if sides else chunk), [*objects, *there]
        if place is not None and place.name == "room" and chunk.value in ("amid", "separates") and not objects[1:]:
            return replace(chunk, value="middle"), objects  # "a screen dividing the room"
        if place is not None and place.name == "room" and chunk.value in ("oneside", "end"):
            one = "one" in chunk.adjectives  # "at one end of the room"
            return replace(chunk, value="on"), [Place("side", () if one else ("far",), det="one" if one else "")]
        sided = [link for link in self.said.links if link.relation in small.OTHER_SIDE and link.objects][-1:]
        if place is None or not sided or (place.name, place.det) != ("side", "other"):
            return chunk, objects
        there = sided[0].subjects if small.OTHER_SIDE[sided[0].relation] == "otherside" else ()
        return replace(chunk, value=small.OTHER_SIDE[sided[0].relation]), [*sided[0].objects, *there]

    def _relative_to(self, bearer: Mention) -> bool:
        """Return whether a relative clause was about what is on the last thing named: "a TV, which stands on a stand ..."."""
        last, before = self.said.last, [k for k in self._here if bearer not in k.objects]
        return bool(before) and bearer in last.objects and named(last.subjects) <= named(before[-1].objects)

    def _looked_at_there(self) -> bool:
        """Return whether what something faces stands at the wall that follows: "a sofa facing a sideboard on the north wall"."""
        last = self.said.last
        walled = any(place_in(k.objects[:1], "wall") and named(k.subjects) & named(last.subjects) for k in self._here)
        looks = last.relation == "facing" and self.target in last.objects
        return looks and self.target is not None and (walled or self.target.walled or self.target.thing.head == "stand")

    def _plain_pair(self, found: Sequence[Item], chunk: Chunk) -> bool:
        """Return whether "and the ..." goes on with the same relation."""
        following = self.chunks[self.at : self.at + 3]
        kinds = [chunk.kind for chunk in following]
        lists = chunk.value in ("far", "apart")  # "away from the door, the window and the radiator"
        if kinds[:1] not in (["and"], ["comma"] * lists) or kinds[1:2] not in (["thing"], ["part"]):
            return False
        other, bare = following[1], ("", None, False)  # "the sofa and coffee table"
        if other.det != "the" and (other.det, other.number, other.plural) != bare:
            return False
        ends = {"stop", "comma", "with", *["and"] * lists, *["verb"] * (chunk.value == "amid" and len(found) < 2)}
        last, part = found[-1], lists or kinds[1] == "part"
        if isinstance(last, Place):
            meant = part and last.name in ("window", "door") and (lists or chunk.value in ("by", "near", "next"))
        else:
            meant = part or chunk.value != "by"
        return meant and (kinds[2:] or ["stop"])[0] in ends

    def _standing(self, meant: list[Mention], chunk: Chunk) -> list[Mention]:
        """Return what bears a small thing where furniture is said to stand beside it: "a globe is on the desk and a bin beside it"."""
        stands = chunk.value == "behind" or all(mention.thing.places[0] != "object" for mention in self.about)
        if len(meant) != 1 or not (meant[0].can_be_on_a_top and stands and chunk.value in (*small.STANDING, "under")):
            return meant
        on = [k.objects for k in self.said.links if k.relation == "on" and meant[0].thing in named(k.subjects)]
        return mentions(on[-1]) or meant if on else meant

    def _other_two(self) -> Mention | None:
        """Return the first of the two things that were named besides what is spoken of, and keep the second."""
        self.at += 1
        others = {m.thing: m for m in (*self.spoken, *self.recent) if m.thing not in named(self.about)}
        self.pending = [*others.values()][-1:]
        return next(iter([*others.values()][-2:-1]), None)


def _of_what_bears(relation: str, items: Sequence[Item]) -> bool:
    """Return whether a relation is about what small things are on: "a table with magazines in front of the sofa"."""
    there = mentions(items)
    standing = bool(there) and not any("object" in m.thing.places or m.det == "each" for m in there)
    return relation in small.LAID or (relation == "front" and standing)


def _over_or_under(relation: str, item: Item) -> bool:
    """Return whether something is a rug that things are on, or hangs from the ceiling over them."""
    below = relation == "under" and isinstance(item, Mention) and item.thing.places == ("ceiling",)
    return below or (relation in ("on", "middle") and isinstance(item, Mention) and item.flat)
