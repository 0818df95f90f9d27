"""From chunks to what they say: things with counts, and relations between them.

A relation belongs to the thing before it; after "is", "are", "stands" to the subject of the clause; after a comma or "and" to
what the last relation was about; at the head of a clause to what follows ("on the desk is a lamp"). "It" is the subject of the
clause before, or what stands before "with". A noun with "the" that was named before is that thing; other nouns are new ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import dropwhile, takewhile

from robolayout.words import _function_words as small
from robolayout.words._chunk import NOTHING, ROWS, SOME, Chunk
from robolayout.words._holding import is_accessory
from robolayout.words._leftover import asides, leftover, unasked
from robolayout.words._relations import Relating
from robolayout.words._said import Link, Mention, NamedThing, Parsed, Place, mentions, named, place_in, place_of
from robolayout.words._tokens import count_of


class Parser(Relating):
    """Reads chunks from left to right."""

    def parse(self) -> Parsed:
        """Return what the chunks say."""
        while self.at < len(self.chunks):
            chunk = self._ahead()
            self.at += 1
            handler = getattr(self, f"_on_{chunk.kind}", None)
            if handler is not None:
                handler(chunk)
            elif chunk.kind == "other" and (self._ahead(-3).kind, self._ahead(-2).value) == ("thing", "of"):
                self._fact(replace(chunk, kind="function"))  # "a cup of coffee"
            elif chunk.kind == "other":
                self.said.missed.append(chunk)
            else:
                self._fact(chunk)
        self._on_stop(None)
        for zone in self.zones.values():  # one after the other: what stands in one part is of no other
            self.said.links += [*zone.links(self.said)]
        aside = asides(self.chunks)
        self.said.facts += aside
        for thing in unasked(aside, self.said):
            self.said.things.remove(thing)
        spoken = [other for other in self.said.missed if not any(a.start <= other.start < a.end for a in aside)]
        self.said.missed = leftover(self.chunks, replace(self.said, missed=spoken))
        return self.said

    def _on_stop(self, chunk: Chunk | None) -> None:
        if self.fronted is not None and self.empty and place_in(self.fronted[1][:1]):
            self._keep_empty(*self.fronted)  # "South wall: nothing."
        at = [place for place, (start, _) in self.said.openings if start >= self.began]
        self.opening = at[0] if len(at) == 1 and not (self.subject or self.group) else None
        self.spoken = list({mention.thing: mention for mention in (*self.recent, *self.targets)}.values())
        self.before = self.subject or (self.recent if self.fronted else self.group) or self.before
        self._new_sentence()

    def _on_comma(self, chunk: Chunk) -> None:
        self._on_and(chunk)
        self.listed = True

    def _on_and(self, chunk: Chunk) -> None:
        self.refusing = self.refusing and chunk.value in ("or", "nor")
        self.verb = self.relative = False
        self.having = self.having and (not self.acted or self._has_more()) and self._previous(chunk) != "each"

    def _on_verb(self, chunk: Chunk) -> None:
        self.verb = True
        who = self._ahead(-2)
        if self.outer and who.kind == "comma" and chunk.value in small.FINITE:
            self.subject = self.group = self.outer  # "the desk, on which a lamp stands, is by the window"
            self.acted, self.fronted, self.holder, self.outer = [], None, [], []
        if chunk.value in ("needs", "gets") and who.kind in ("people", "body", "thing") and who.det == "each":
            self._on_with(chunk)

    def _on_not(self, chunk: Chunk) -> None:
        self.empty = chunk.value == "nothing"
        the = self._ahead().det == "the"  # "neither the bed nor the desk"
        self.refusing, self.negated = True, chunk.value in small.NEGATING or (the and chunk.value in ("neither", "nor"))

    def _on_filler(self, chunk: Chunk) -> None:
        following = self._ahead()
        if chunk.value == "for" and self._bears(following):
            self._on_with(chunk)  # "a low cupboard for the coffee machine under the window"
        tops = chunk.value == "of" and any(m.thing.head in small.TOPS for m in self.group[-1:])  # "six tables of four"
        count = count_of(following.value) or 0
        if (chunk.value == "for" or tops) and following.kind == "filler" and count > 1:
            kind = "seats" if self._promised(count, -2) else "users"  # "a table for six"
            self.said.facts.append(Chunk(kind, chunk.start, following.end, number=count))
        if chunk.value == "for" and following.value in ("everyone", "everybody"):  # "plates and glasses for everyone"
            for thing in (one.thing for one in self.group if one.thing.number is None):
                thing.number, thing.everyones = 1, True
            self._understood(chunk, following)
        if chunk.value == "all" and self._ahead().kind == "style" and self.recent:
            self.subject, self.verb = list(self.recent), True  # "a sofa and two chairs, all grey"
        if chunk.value == "all" and self._ahead().kind == "rel" and self.recent:  # "two chairs, all on a rug"
            self._these([m for m in self.recent if not m.topped])
            self.acted, self.holder = self.group, []
        last = self.said.last
        if chunk.value == "too" and last.relation and self.group and not self.acted and last.start < self.began:
            self.said.links.append(replace(last, subjects=tuple(self.group)))  # "a sofa by the window. A desk, too"
        share, index = count_of(chunk.value), self.at  # "one of them is against the wall"
        while (led := self._ahead(index - self.at)).kind in ("verb", "pron") or led.value == "of":
            index += 1
        if share and self._previous(chunk) != "for" and led.kind in ("rel", "with"):
            self._deal(share, index)

    def _bears(self, what: Chunk) -> bool:
        """Return whether the thing right before "for" stands on the floor and can have on it the one that follows."""
        one = what.noun is not None and what.det in ("the", "a") and "floor" not in what.noun.category.places
        bearer = self.group[-1].thing if self.group and self._ahead(-2).kind == "thing" else None
        return one and bearer is not None and bearer.category.on_floor and not self.group[-1].sat_on

    def _deal(self, share: int, index: int) -> None:
        """Let so many of the things named last be what the relation there is about: "two at one wall and two at the other"."""
        each = bool({"each", "either"} & {*self.chunks[index].adjectives})  # "two lamps, one on each end"
        each = each or any(chunk.det == "each" for chunk in self.chunks[index + 1 : index + 2])
        led = [chunk.value for chunk in self.chunks[index : index + 2]]
        at_sides = each and (led[0] == "flank" or led[1:] == ["side"])
        sides = max((thing.sides for thing in self.said.things if thing.has_sides), default=2)
        many = share * sides if at_sides else share
        last = (self.group or self.before)[-1:]
        # "two tables, each with six chairs, three on each side"
        many *= last[0].thing.times if at_sides and last else 1
        begins = "comma" if last and share > last[0].thing.count else "and"  # "two at the ends, four at the sides"
        more = self.chunks[self.at - 2].kind == begins and last == self.acted and last[:1] and last[0].pick is None
        told = (last[0].thing.number or int(last[0].thing.count == 1)) if more else 0
        if told and self.said.links and last[0].thing not in self.dealt:
            k = self.said.links[-1]  # "two before it and one behind it", "a lamp on the left and one on the right"
            self.dealt[last[0].thing] = last[0].thing.number = told
            own = Mention(last[0].thing, slice(0, told))
            apart = k.subjects == tuple(last) and (k.relation != "around" or k.sided)
            self.said.links[-1] = replace(k, subjects=(own,)) if apart else k
            last[0].thing.number += many if at_sides else share * (2 if each else 1)
        if last and share >= last[0].thing.count:  # "a bed flanked by two lamps; one is ..."
            last = [m for m in self.spoken if m.several and share < m.count][-1:] or last
        first = self.dealt.get(last[0].thing, 0) if last else 0
        if not last or first + share > last[0].thing.count:
            return
        self._understood(self.chunks[self.at - 1])
        if share < last[0].thing.count:
            self.dealt[last[0].thing] = first + many
            pick = slice(first, min(first + many, last[0].thing.count)) if at_sides or not each else None
            self.subject = self.group = self.acted = [Mention(last[0].thing, pick)]

    def _on_body(self, chunk: Chunk) -> None:
        """Who the room is laid out for; pets of somebody who was named live there, too."""
        people = [c for c in self.said.facts if c.kind == "people" and c.start >= self.began]
        lives = people or (chunk.det == "the" and self._previous(chunk) != "for")  # "so that the cat can look out"
        if chunk.value in small.PETS and self._previous(chunk) == "for" and self.group:  # "a bed for the cat"
            self.group[-1].thing.of_pet = self.group[-1].thing.noun.said in small.OF_PETS
        self._fact(replace(chunk, kind="users") if lives and chunk.value in small.PETS else chunk)

    def _on_pron(self, chunk: Chunk) -> None:
        """What was named before; "each" multiplies what it follows ("four chairs each"), or says what each one has."""
        if chunk.value in ("that", "which"):
            self.relative = True
            return
        if chunk.value.startswith("the row"):
            self._these(self._meant(chunk.value))
            return
        if chunk.value.endswith("furniture"):
            clause = takewhile(lambda other: other.kind not in ("stop", "thing"), self.chunks[self.at :])
            placed = any(other.kind == "rel" for other in clause)  # not "the furniture is white"
            self._these([Mention(t) for t in self.said.things if placed and t.category.on_floor])
            return
        if chunk.value == "both" and self._ahead().kind == "style":  # "two armchairs, both red"
            self.subject, self.verb = [m for m in self.recent if m.several][-1:] or self.recent[-2:], True
            return
        room = chunk.value == "it" and self.before[:1] and self.before[0].det in ("both", "all")
        begins = not self.group or self._previous(chunk) in ("and", ",")
        several_meant, each = chunk.value in small.SEVERAL and begins, chunk.value == "each" and begins
        last, every = self.group or self.before, begins and chunk.value in (*small.EVERY, "they")
        if every and (meant := self._every_one(chunk, last)):
            self.subject = self.group = meant
        elif each and self.group and self.group[-1].several and self._ahead().kind in ("with", "rel"):
            # "two cups, and two tables, each with ..."
            alike = [m for m in self.group if m.topped == self.group[-1].topped]
            self.subject = self.group = [m for m in alike if m.several]  # "a desk and three tables, each with ..."
            self.holder, self.having = [], False
        elif several_meant and (self.before or len([*self.recent, *self.targets]) > 1):
            # "..., and both of them face it"
            self.subject = self.group = self._several_meant("", self.recent, self.targets)
        elif self.before and not self.group and not room:
            self.subject, self.group = list(self.before), list(self.before)
        own = chunk.value == "each" and (self.holder or self._ahead().kind not in ("rel", "verb"))
        if not self._all_have(chunk) and own and self.group:
            self._one_each(self.group[-1].thing)

    def _every_one(self, chunk: Chunk, last: Sequence[Mention]) -> list[Mention]:
        """Return what "each" means that is not what was named last, or not that alone."""
        many = [m for m in (*self.spoken, *self.recent, *self.targets) if m.several]
        if many and len(last) == 1 and not last[0].several and chunk.value != "both":
            return many[-1:]  # "two beds parted by a curtain, each with a lamp"
        alike = {m.thing: m for m in self.recent if last and not many and m.thing.noun == last[-1].thing.noun}
        if len(alike) < 2:
            return []
        self.holder, self.having = [], False
        return [*alike.values()]  # "one desk under the window and another by the door, each with a chair"

    def _all_have(self, chunk: Chunk) -> bool:
        """Read what all of some things or people have: "each with a lamp"; "for two children, each with a bed"."""
        groups = [c.number for c in self.chunks[max(self.at - 4, 0) : self.at - 1] if c.kind == "function" and c.number]
        people = groups[-1] if groups else self._people()  # "two seating groups, each with a sofa"
        if chunk.value not in small.EVERY or not (self.group or people > 1):
            return False
        if self._ahead(-2).kind == "thing" and self.group[-1:] and self.group[-1].several:
            self.group = self.group[-1:]  # "a bar with stools, four tables each with four chairs"
        if self.group and self._ahead().kind == "with":
            self.group = self._bearing(self._ahead(1)) or self.group
            self.at += 1
            det = "each" if chunk.value.startswith(("each", "every")) else "all"
            self.holder = [Mention(m.thing, None, det) for m in self.group]
            self._each_has(self.holder, sum(m.thing.count for m in self.group))
            return True
        does = self._ahead().kind == "with" or (self._ahead().value == "by" and self._ahead(1).kind == "thing")
        if self.group or not does:
            return False
        self._understood(*[self._ahead()] * (self._ahead().kind == "rel"))  # "four people, each at a desk"
        self.said.missed[:] = [c for c in self.said.missed if c.value.removesuffix("s") not in small.GROUPS]
        self.at += 1
        self._each_has([], people)
        return True

    def _bearing(self, has: Chunk) -> list[Mention]:
        """Return what bears the things before, where each of them has a seat: "two machines on tables, each with a chair"."""
        on = [k for k in self._here if k.relation == "on" and k.subjects == tuple(self.group)]
        seat = has.noun is not None and has.noun.kind.split()[-1] in small.SEATS
        return mentions(on[-1].objects) if on and seat else []

    def _one_each(self, thing: NamedThing) -> None:
        """What each of the things before has, or each of those for whom the room is: "two tables with four chairs each"."""
        if not self.holder:
            thing.everyones = True
        elif thing is not self.holder[0].thing:
            thing.times = self.holder[0].thing.count

    def _on_thing(self, chunk: Chunk) -> None:
        chunk = self._none_of(chunk)
        if members := self._members(chunk):
            self._understood(chunk)
            self._these(members)
            return
        if self._no_thing(chunk) or self._also_each(chunk) or self._per_row(chunk):
            return
        mention = self._mention(chunk)
        self.recent.append(mention)
        self._into_the_zone(chunk, mention)
        self.target = None
        self._note(chunk, mention)
        if chunk.det == "each" and self.group and self._previous(chunk) == "for":
            self._link(Chunk("rel", chunk.start, chunk.end, "with"), self.group[-1:], [mention])
            return
        if self._led(mention) or self._elided(chunk, mention):
            return
        joined = self._joined()
        if self.having and self.holder and self._put_on(mention, self.holder[0], joined=joined):
            on_a_stand = mention.topped and self.group[-1].thing.head == "stand"  # "a bed with night stands and lamps"
            borne = joined and on_a_stand and self.holder[0].thing.head in small.SLEPT_ON
            bearers = self.group[-1:] if borne else self.holder
            self.said.links.append(Link("with", (mention,), tuple(bearers), chunk.start, chunk.end))
        elif joined and not is_accessory(mention):
            self.listed = True  # "a table with six stools and shelves along the wall"
        elif joined and self.having and mention.thing.category.built_in:
            self.listed = False  # "counters with a sink, a stove and an oven along the wall"
        joined = not self._alone(mention, joined=joined) and joined
        together = joined and self.subject == self.group
        self.group = [*self.group, mention] if joined else [mention]
        if not self.subject or together or (not joined and not self.verb and not self.holder):
            self.subject = self.group
        self.acted, self.verb, self.relative = [], False, False

    def _these(self, members: list[Mention]) -> None:
        """Go on with several things that were named before: "The machines stand side by side"."""
        self.recent += members
        if self.fronted is not None:
            self._link(self.fronted[0], members, self.fronted[1])
        self.subject = self.group = members
        self.target, self.acted = None, []
        self.verb = self.relative = False

    def _note(self, chunk: Chunk, mention: Mention) -> None:
        """Note what a noun phrase itself says of how its thing stands."""
        if chunk.rows and mention.thing.count > 1:
            order = "groups" if chunk.rows < SOME else "rows"
            mention.thing.rows = ROWS if chunk.rows == SOME and chunk.number is None else mention.thing.rows
            count = -chunk.rows if order == "groups" else max(chunk.rows, 0)
            self.said.links.append(Link(order, (mention,), (), chunk.start, chunk.end, rows=count))
        noun = chunk.noun.said.split() if chunk.noun is not None else []
        for word in (word for word in small.SAID_OF if word in (*chunk.adjectives, *noun)):
            to = next(((Place(name),) for name in ("wall", "ceiling") if word.startswith(name)), ())
            self.said.links.append(Link(small.SAID_OF[word], (mention,), to, chunk.start, chunk.end))
        last = self.said.last
        bare = self._previous(chunk) == "and" and not chunk.det  # "a stacked washer and dryer"
        if bare and last.relation == "stacked" and [m.count for m in last.subjects] == [1]:
            self.said.links[-1] = replace(last, subjects=(*last.subjects, mention))
        like = [k for k in self.said.links if mention.laid or not any(subject.laid for subject in k.subjects)][-1:]
        if self._previous(chunk) in small.ALIKE and like:  # "a sofa is by the window, and so is a desk"
            self.said.links.append(replace(like[0], subjects=(mention,)))

    def _none_of(self, chunk: Chunk) -> Chunk:
        """Return all of what was named before, where none of it is to stand as a relation says: "no bookcase blocks the door"."""
        again = any(thing.same(chunk) for thing in self.said.things)
        if not (self.refusing and self._ahead().kind == "rel" and again):
            return chunk
        self.negated = True
        self.chunks[self.at - 1] = replace(chunk, det="the", number=None)
        return self.chunks[self.at - 1]

    def _no_thing(self, chunk: Chunk) -> bool:
        """Return whether a noun names what is not to be there, what somebody moves with, or what a thing is for."""
        assert chunk.noun is not None
        noun, before = chunk.noun, self._previous(chunk)
        several, strange = chunk.plural or noun.words.endswith("s"), noun.kind.startswith("unknown")
        alone, named = not chunk.det and chunk.number is None, self.group or self._ahead(-3).kind == "room"
        aid = small.AIDS.get(noun.said if noun.guessed and not self.group else noun.kind)
        held = self.group[-1:] if self._ahead(-3).kind == "thing" and not chunk.det else []
        held = held if alone or (before == "of" and held and held[0].thing.head in small.CONTAINERS) else []
        narrow = bool(held) and held[0].thing.head in small.NARROW
        alike = bool(held) and noun.kind == held[0].thing.noun.kind
        if self.refusing and not (self.negated and chunk.det == "the"):
            self.said.refused.append((noun, (chunk.start, chunk.end)))
            self.refusing = before not in small.INSTEAD  # "instead of a bathtub a shower"
        elif aid and (before in small.USING or self._ahead().value in small.ABLE):
            self._fact(Chunk("body", chunk.start, chunk.end, aid))
        elif (alike or narrow) and (before == "of" or self._ahead(-2).kind == "with"):
            # "a bottle of detergent", "a vase with flowers", "a jar of brushes"
            self._fact(replace(chunk, kind="function"))
        elif held and before == "of" and noun.kind.split()[-1] == held[0].thing.head:
            held[0].thing.noun = noun  # "a box of tissues" is a tissue box
            self._understood(chunk)
        elif held and before == "of":  # "a rack of dumbbells"
            mention = self._mention(chunk)
            container = held[0].thing.head in small.CONTAINERS or not held[0].thing.category.on_object
            if mention.thing.category.on_object and container:
                self.said.links.append(Link("on", (mention,), tuple(held), chunk.start, chunk.end))
        elif strange and chunk.det == "a" and before in small.BEING:
            self._fact(replace(chunk, kind="people", value="person"))  # "I am a painter"
        elif before == "for" and ((named and several and alone) or strange):
            self._fact(replace(chunk, kind="function"))  # "a rack for shoes", "a desk for the therapist"
        else:
            return False
        return True

    def _led(self, mention: Mention) -> bool:
        """Return whether a thing stands where the head of its clause says: "on the desk is a lamp"."""
        if self.fronted is None:
            return False
        # "behind it a clock, four armchairs around a table"
        other = self._ahead().kind == "rel" and self.fronted[0].value != "on"
        ordered = self._ahead(-2).kind == "and" and mention.count == 1 and self._ahead().value in small.ORDERS
        other = (other and not ordered) or self._placed(mention)  # not "a fridge and a stove in a row"
        laid = self.fronted[0].value == "on" and mention.can_be_on_a_top  # "on which a cup and a jar stand"
        closes = laid and self._ahead().value in small.FINITE - small.ALONE_DOES and self._ahead(-2).kind == "and"
        ends = self._ahead().value in small.FINITE and not closes
        if self.acted and (other or ends or (not closes and self._alone(mention, joined=True))):
            self.fronted = None
            return False
        for led in (self.also, self.fronted) if self.also is not None else (self.fronted,):
            self._link(led[0], [mention], led[1])
        self.group = self.acted = [mention]
        inverted = self._ahead(-2).kind == "verb" and bool(self.subject)  # "next to it stands a plant by the window"
        self.verb = self.verb and not inverted and self._ahead().value != "holds"
        # "a sideboard, on which a vase stands between two candlesticks"
        rest = [*dropwhile(lambda c: c.kind in small.OF_A_NOUN, self.chunks[self.at :]), NOTHING]
        self.subject = self.group if rest[0].value in small.FINITE else self.subject
        return True

    def _placed(self, mention: Mention) -> bool:
        """Return whether a place of its own follows a thing: "..., and a bench with a stool against the wall", "the lamp can go on it"."""
        rest = [*dropwhile(lambda c: c.kind in ("with", "thing", "style"), self.chunks[self.at :])]
        had = self._ahead().kind == "with" and not mention.topped and [c.kind for c in rest[:2]] == ["rel", "part"]
        at_a_place = had and rest[1].value in ("wall", *small.OPENINGS_AND_CORNERS)
        return at_a_place or self._ahead().value in small.MODAL

    def _elided(self, chunk: Chunk, mention: Mention) -> bool:
        """Return whether two things follow each other as the last two did: "the left desk has a lamp, the right one a vase"."""
        last = next((link for link in reversed(self.said.links) if link.start < chunk.start), None)
        if last is not None and last.subjects == tuple(self.group) and self._joined() and last.elided:
            self.said.links[-1] = replace(last, subjects=(*last.subjects, mention))  # "the other a vase and a bowl"
            self.group = [*self.group, mention]
            return True
        before = self.recent[-2:-1]
        if last is None or not before or before[0].pick is None or self._ahead(-2).kind != "thing":
            return False
        if [to.thing for to in mentions(last.objects) if to.pick is not None][:1] != [before[0].thing]:
            return False
        self._link(Chunk("rel", chunk.start, chunk.end, last.relation), [mention], before)
        self.said.links[-1] = replace(self.said.links[-1], elided=True)
        self.group, self.subject, self.acted = [mention], before, []
        return True

    def _per_row(self, chunk: Chunk) -> bool:
        """Return whether a noun says how many of a thing each of its rows has: "three rows of desks, four desks in each row"."""
        rows = next((thing for thing in reversed(self.said.things) if thing.rows > 0 and thing.same(chunk)), None)
        if rows is None or not chunk.number or (self._ahead().value, self._ahead(1).value) != ("in", "each row"):
            return False
        rows.number = rows.rows * chunk.number
        self._understood(chunk, self._ahead(), self._ahead(1))
        self.at += 2
        return True

    def _also_each(self, chunk: Chunk) -> bool:
        """Read what else each has, after what stands at it: "each table has a board on it and two chairs"."""
        after_it = [c.kind for c in self.chunks[self.at - 3 : self.at - 1]] == ["pron", "comma"]
        small_one = chunk.noun is not None and chunk.noun.category.on_object
        listed = after_it and small_one  # "a chair behind it, a lamp and a mug"
        joined = (self._ahead(-2).kind == "and" or listed) and chunk.det != "the"
        own = joined and self.acted and (self._ahead().kind != "rel" or self._ahead(1).kind in small.ALONE_AFTER)
        if not (own and self.every and all(mention.thing.times == self.every[1] > 1 for mention in self.acted)):
            return False
        if named(self.acted) <= named(self.every[0]):  # "next to each bed a table with a lamp, and a wardrobe"
            return False
        self.at -= 1
        self._each_has(*self.every)
        self.target, self.acted = None, []
        return True

    def _on_part(self, chunk: Chunk) -> None:
        """A place of the room that no relation leads to: what it has, doors and windows that are asked for."""
        corner = (chunk.value, chunk.det, self._ahead().kind) == ("corner", "a", "with")  # "a carpet corner with mats"
        if chunk.value == "room" or corner or (chunk.value == "side" and self._is_zone(chunk)):
            self._new_zone(chunk)
            self._understood(*[chunk] * (chunk.value != "room"))
        if self._ahead(-3).kind == "thing" and (self._ahead(-2).kind == "with" or self._ahead(-2).value == "("):
            self._fact(replace(chunk, kind="function"))  # "a wardrobe with two sliding doors"
            return
        if chunk.value in ("window", "door"):
            self._on_opening(chunk)
        elif chunk.value == "side" and chunk.det == "each" and self.group and self._previous(chunk) == "for":
            if self._ahead(-3).kind == "filler":  # "ten chairs, five per side"
                self._understood(self._ahead(-3))
                self.dealt.setdefault(self.group[-1].thing, 0)
            flank = Chunk("rel", chunk.start, chunk.end, "flank", adjectives=("each",))
            if not self._at_sides(flank, self.group[-1:], None):
                self._link(flank, self.group, self._meant("it"))
        elif chunk.value == "ceiling" and self.group and self._previous(chunk) == "from":
            self.acted, self.verb = self.group[-1:], False
            self._link(Chunk("rel", chunk.start, chunk.end, "hanging"), self.acted, [place_of(chunk)])
        elif chunk.value in ("floor", "wall"):
            self._on_surface(chunk)
