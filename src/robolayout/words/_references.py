"""What words refer to: a thing named before, a share of several, what a relation without an object leads back to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import dropwhile, pairwise

from robolayout.words import _function_words as small
from robolayout.words._chunk import NOTHING, ROWS, Chunk
from robolayout.words._counting import Counting
from robolayout.words._lexicon import grammar
from robolayout.words._said import Item, Link, Mention, NamedThing, Place, mentions, named, place_in, places
from robolayout.words._tokens import about as about_so_far


class References(Counting):
    """Finds what noun phrases name and notes relations."""

    def _mention(self, chunk: Chunk, *, target: bool = False) -> Mention:
        """Return the thing that a noun phrase names: one named before, or a new one."""
        assert chunk.noun is not None
        known = self._known(chunk, target=target)
        had = chunk.plural and not chunk.det and chunk.number is None and self._ahead(-2).kind == "with"
        if known is not None and not had:  # "four armchairs, two tables with chairs"
            sides = [{"left", "right"} & {*words} for words in (known.adjectives, chunk.adjectives)]
            if known.count == 1 and all(sides) and sides[0] != sides[1]:
                known.number = 2  # "on the left nightstand ... on the right nightstand"
            known.spans.append((chunk.start, chunk.end))
            pick = self._pick(chunk, known.count, self.dealt.get(known), target=target)
            one_by_one = chunk.det in ("new", "one", *small.SHARES) or (chunk.det == "first" and chunk.number)
            one_by_one = one_by_one or (chunk.number == 1 and not chunk.det and self._others_follow(chunk))
            if pick is not None and one_by_one:
                self.dealt[known] = pick.stop
            return Mention(known, pick, chunk.det)
        number = 1 if chunk.number is None and chunk.det in ("a", "new", "one") and not chunk.plural else chunk.number
        if chunk.det == "both" and number is None:
            number = 2
        bare = number is None and chunk.plural and not chunk.det
        if bare and not target and self._ahead().kind != "rel" and self._joined():
            before = self.group[-1].thing.number
            number = before if before and before > 1 else None
        if number is None and chunk.plural and chunk.noun.kind in small.ONE_EACH and not self.said.things:
            number = self._people() or None  # "an office for four: desks ..."
        if number is None and chunk.det == "each" and chunk.noun.kind in small.ONE_EACH:  # "in front of each chair"
            number = self._people() or self._sitting("desk")
        definite = chunk.det in ("the", "each", "all", "first", *small.SHARES)
        some = chunk.det == "one"  # "one of the two beds"
        seats = self._sitting() if some and chunk.noun.kind in small.ONE_EACH else None  # "a table for four"
        number, number_of = (chunk.total or seats, number) if some else (number, None)
        plural = chunk.plural or (chunk.det == "each" and number is None)
        made = NamedThing(chunk.noun, number, chunk.bound, plural, chunk.adjectives, [(chunk.start, chunk.end)])
        made.rows, made.definite = chunk.rows, definite
        made.sizes += chunk.sizes
        self.said.things.append(made)
        first = (chunk.det == "first" or {"left", "right"} & {*chunk.adjectives}) and made.count == 1
        if chunk.det in small.SHARES:
            return Mention(made, self._pick(chunk, made.count, None, target=target), chunk.det)
        return Mention(made, slice(0, number_of or 1) if first or (some and made.count > 1) else None, chunk.det)

    def _members(self, chunk: Chunk) -> list[Mention]:
        """Return the things of several kinds named before that one noun means: "the appliances", "both lamps"."""
        several = chunk.plural and chunk.det in ("the", "all", "both")
        if chunk.noun is None or not (several or chunk.det == "each"):
            return []
        ends = grammar().groups.get(chunk.noun.said, ())
        found = [t for t in self.said.things if t.same(chunk) or t.head in ends]
        count = sum(thing.count for thing in found)
        again = any(thing.same_words(chunk) for thing in found) or (len(found) == 1 and found[0].same(chunk))
        told = chunk.number or (2 if chunk.det == "both" else count)
        more = {kind for kind in chunk.noun.others if kind.split()[-1] in ends} - {thing.noun.kind for thing in found}
        again = again or bool(more)
        return [] if again or count < 2 or count != told else [Mention(thing, None, chunk.det) for thing in found]

    def _sitting(self, head: str = "") -> int | None:
        """Return how many sit at what is for so many, or at each thing with some last word; None if nobody said."""
        sat_at = (max(t.people, 1) * t.count for t in self.said.things if t.people or t.head == head)
        return next(sat_at, None)

    def _people(self) -> int:
        """Return how many people the room was said to be for, 0 if nobody said."""
        named = (c.number for c in self.said.facts if c.kind in ("people", "body") and c.number)
        return next(named, self.said.people)

    def _pick(self, chunk: Chunk, count: int, dealt: int | None, *, target: bool) -> slice | None:
        """Return which of several things a noun phrase means, None for all of them."""
        first, many = dealt or 0, chunk.number or 1
        if count == 1:
            return None
        if chunk.det in small.SHARES:
            return slice(first, first + max(int(count * small.SHARES[chunk.det]), 1))
        if many < 0:
            return slice(0, count + many)  # "all but one"
        if chunk.det in ("other", "new"):
            first = (count - many if chunk.number else 1) if dealt is None else dealt
            return slice(first, count if chunk.plural else first + 1)
        if chunk.det == "one" or (chunk.number == 1 and not chunk.det and not target):
            return slice(first, first + many) if first + many <= count else slice(0, many)
        places = {"second": 1, "third": 2, "middle": count // 2}
        places |= dict.fromkeys(small.AT_FIRST, 0) | dict.fromkeys(small.AT_LAST, count - 1)
        told = [places[word] for word in (chunk.det, *chunk.adjectives) if word in places]
        told += [0] if chunk.number == 1 and not chunk.plural and target else []
        if told and chunk.det in ("first", "last"):  # "the first two"
            return slice(0, many) if chunk.det == "first" else slice(count - many, count)
        return slice(told[0], told[0] + 1) if told else None

    def _known(self, chunk: Chunk, *, target: bool) -> NamedThing | None:
        """Return the thing named before that a noun phrase means; the one named last where several fit."""
        assert chunk.noun is not None
        bare = not chunk.det and chunk.number is None
        own = named(self.about if target else ())
        # nothing stands at itself: "a dog bed at the foot of the bed"
        other = [t for t in own if t.of_pet or not t.same_words(chunk)]
        fits = [t for t in self.said.things if t.same(chunk) and t not in other]
        more = [t for t in fits if bare and chunk.plural and t.count == 1]  # "a high chair and chairs"
        fits = [t for t in fits if not (chunk.rows and t in more)]
        fits = [t for t in fits if t.same_words(chunk)] or [t for t in fits if t not in more]
        fits = [t for t in fits if not t.differs(chunk)]
        fits = [t for t in fits if {*chunk.adjectives} & {*t.adjectives, *t.told}] or fits
        single = chunk.det == "the" and not chunk.plural and chunk.number is None
        fits = [t for t in fits if single and t.count == 1] or fits  # "an office chair and two guest chairs: the chair"
        last, number = fits[-1] if fits else None, chunk.number
        if last is not None and chunk.level and chunk.det != "a" and last.count == 1 and not last.definite:
            return last  # "the second shelf" of the one unit
        if last is None or not self._has_so_many(last, chunk.det):
            return None
        other_kind = last.noun.kind != chunk.noun.kind and self._ahead(-2).kind == "with" and chunk.det == "the"
        if other_kind and any(last in named((*k.subjects, *k.objects)) for k in self.said.links):
            return None  # "two armchairs by the window, a desk with its chair"
        said = {word.removesuffix("s") for word in (*chunk.adjectives, *chunk.noun.said.split())}
        alike, one = last.same_words(chunk), number == 1 and not chunk.det
        owned = {word.removesuffix("s") for word in chunk.adjectives} if alike else said
        if last.count > 1 and not chunk.plural and owned & small.PEOPLE:
            return None  # "the teacher's desk"
        theirs = {word.removesuffix("s") for word in last.adjectives} & small.PEOPLE - said  # "the doctor's chair"
        if theirs and said - {word.removesuffix("s") for word in last.phrase}:
            return None  # "the therapist's chair and the client's chair"
        told = number is not None and not (target and one)
        if told and last.definite and last.number is None and last.plural and alike:
            last.number = number  # "facing the mirrors, three mirrors on the wall"
            return last
        follows = self._ahead().kind
        earlier = last not in named(self.recent)
        others = last.count > 1 and self._others_follow(chunk)  # "two chairs, one chair on the left, the other ..."
        if one and (others or (follows == "verb" and earlier) or (target and last.count > 1)):
            return last  # "three lamps. One lamp should be next to the sofa"
        if bare and not chunk.plural and not target:
            # "1 bed, 1 desk: desk near bed", "watch it from bed"
            again = earlier and last.count == 1 and (last.definite or (not self.group and follows in ("with", "verb")))
            return last if alike and (again or follows == "rel" or self._previous(chunk) == "from") else None
        if chunk.det == "a":
            more = last.definite and not target and not theirs and self._told_more(last, chunk)
            again = more or (alike and (target or (last.definite and not theirs)))
            last.definite = last.definite and target
            return last if again else None
        new = chunk.det == "new" and not 0 < self.dealt.get(last, 0) < last.count
        new = new or (chunk.det == "other" and last.number == 1 and self._counted_one(last))
        new = new or (chunk.det == "other" and (number or 0) >= last.count)  # "a desk at the door and 15 other desks"
        return None if new or (told and chunk.det not in small.NAMED) else last

    def _has_so_many(self, thing: NamedThing, det: str) -> bool:
        """Return whether there is a thing of a number; what begins with "the first sofa" goes on with "the second"."""
        index = small.ORDINALS.index(det) % 3 if det in small.ORDINALS else 0
        if index and thing.definite and thing.number is None and not thing.plural:
            thing.number = index + 1
        return thing.count > index

    def _joined(self) -> bool:
        """Return whether the last chunk only joins this thing to those before it."""
        joins = [c.kind in ("and", "comma", "filler", "style") or c.value == "nor" for c in self.chunks[: self.at - 1]]
        first = next((i for i in range(self.at - 2, -1, -1) if not joins[i]), None)
        if first is None or self.chunks[first].kind != "thing" or not self.group or self.acted:
            return False
        return any(c.kind in ("and", "comma", "not") for c in self.chunks[first + 1 : self.at - 1])

    def _alone(self, mention: Mention, *, joined: bool) -> bool:
        """Return whether a new clause begins with a thing: "..., and a rack stands at the wall"."""
        rest = [*dropwhile(lambda c: c.kind in small.OF_A_NOUN, self.chunks[self.at :]), NOTHING]
        among = [c.kind for c in rest[:2]] == ["rel", "pron"]  # "two chairs with a table between them sit in a corner"
        following = rest[2 * among]  # "..., and a table with a lamp stands at the wall"
        starts = self._ahead(-2).kind in ("and", "comma")
        last = (*self.group[-1:], mention)  # "..., and the desk and the bed should be near the window"
        again = [bool(one.thing.spans[1:]) for one in last] == [False, True] or not joined
        plural = again and following.kind == "verb" and following.value in small.FINITE
        stood = self._ahead(len(self.chunks[self.at :]) - len(rest) + 2 + 2 * among).value  # what follows the verb
        if joined and self.having and mention.topped and stood in ("opposite", "wall"):
            return False  # "a counter with a kettle and a toaster is opposite"
        alone = following.value in small.ALONE_DOES and (mention.thing.count == 1 if joined else starts)
        alone = alone or (plural and starts)
        self.subject, self.acted = ([], []) if alone else (self.subject, self.acted)
        return alone

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
        middle = chunk.value == "middle" and not objects
        if middle and held and self.holder[0].topped:  # "plates on the table, with a candle in the middle"
            on = [list(k.objects) for k in self.said.links if k.relation == "on" and self.holder[0] in k.subjects]
            return subjects, on[-1] if on else objects
        led = [before.kind for before, c in pairwise(self.chunks[: self.at]) if c.kind == "with"][-1:]
        one = led == ["comma"] or not any(m.several for m in subjects)  # a table with four magazines is there itself
        on = self.holder if held and one else self.every[0] if self.every else []
        if middle and on and self.group[-1:] and self.group[-1].topped:
            return subjects, list(on)  # "a table by the wall, with a bowl in the middle"
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
        built = [m for m in self.group if m.thing.category.built_in and place_in(objects[:1], "wall")]
        return ([*self.holder, *built] if swapped else subjects), objects

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


def _of_what_bears(relation: str, items: Sequence[Item]) -> bool:
    """Return whether a relation is about what small things are on: "a table with magazines in front of the sofa"."""
    there = mentions(items)
    standing = bool(there) and not any("object" in m.thing.places or m.det == "each" for m in there)
    return relation in small.LAID or (relation == "front" and standing)


def _over_or_under(relation: str, item: Item) -> bool:
    """Return whether something is a rug that things are on, or hangs from the ceiling over them."""
    below = relation == "under" and isinstance(item, Mention) and item.thing.places == ("ceiling",)
    return below or (relation in ("on", "middle") and isinstance(item, Mention) and item.flat)
