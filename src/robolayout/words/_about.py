"""What a relation in words is about (the thing before it, all of a list, the subject of its clause) and what it leads to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

from robolayout.scene import FLAT_HEIGHT
from robolayout.words import _function_words as small
from robolayout.words._appositions import LISTED
from robolayout.words._chunk import Chunk, opening_before
from robolayout.words._references import References
from robolayout.words._said import Item, Mention, Place, mentions, named, of_the_plan, place_in, place_of, sides
from robolayout.words._spoken import across
from robolayout.words._ways import CROWD


class About(References):
    """Finds what relations are about and what they lead to."""

    def _objects(self, chunk: Chunk) -> list[Item]:
        """Return what a relation leads to; "between" takes two, and a wall may be told by what it is opposite to."""
        found: list[Item] = []
        while self.at < len(self.chunks):
            first = self.at
            while self._ahead().kind in ("filler", "style"):
                self.at += 1
            item = self._object(chunk)
            if item is None:
                self.at = first if [c.value for c in self.chunks[first : first + 1]] == ["for"] else self.at
                break  # "in a U for twelve"
            found += [item, *self.pending]
            self.pending = []
            pronoun = self.chunks[self.at - 1].kind == "pron"
            two = chunk.value in ("amid", "between", "separates") and len(found) < 2
            many = item.several if isinstance(item, Mention) else item.plural
            wants = two and (self._ahead().value == "from" or not (many or pronoun))
            both = chunk.value in small.TO_SEVERAL
            both = both or (isinstance(item, Mention) and item.det == "both")
            if not (wants or (both and self._plain_pair(found, chunk))):
                break
            self.at = min(self.at + 1, len(self.chunks))
        if wall := place_in(found[-1:], "wall", "corner"):
            found[-1] = self._which_wall(self._opposite_corner(wall))
        self.target = found[-1] if found and isinstance(found[-1], Mention) else None
        return found

    def _object(self, chunk: Chunk) -> Item | None:
        """Return the thing or place at the head of what follows, and go past it."""
        following = self._ahead()
        if (following.value, chunk.value) == ("it", self.contrast[0]) and place_in(self.contrast[1]):
            self.at += 1
            return self.contrast[1][0]  # "a wardrobe to the left of the door and a mirror to the right of it"
        if following.kind == "thing":
            self.at += 1
            members = self._members(following)
            self._understood(*[following] * bool(members))
            mention, *self.pending = members or [self._mention(following, target=True)]
            self.targets += [mention, *self.pending]
            return mention
        if following.kind == "part":
            self.at += 1
            beds = self._last_of(small.SLEPT_ON, named(self.about)) if "headboard" in following.adjectives else []
            if beds and chunk.value in ("above", "behind", "on"):  # "a shelf above the headboard"
                self._understood(following)
                return beds[0]
            return self._place_of(following)
        clause = following.kind == "people" and self._ahead(-1).kind == "filler"  # "in front, so that people see it"
        whole = chunk.value in ("in", "on", "around", "flank")  # "in the kitchen", "around the room"
        if following.kind == "corner" and chunk.value == "in":  # "a piano in the music corner"
            self._part_of_room(following).things += self.about
        meant = None if whole else self._stands_for(following)
        if meant is not None:
            self.at += 1
            self.said.facts.append(following)
            return meant
        if following.kind in ("room", "function", "people") and not clause:
            self.at += 1
            ends = following.value.endswith(("head", "foot")) or chunk.value in ("opposite", "facing", "near", "next")
            if ends and self._of_a_thing(following):
                return self._object(chunk)
            self._understood(following)
            if following.kind != "people":
                self.said.facts.append(following)
            return Place("room")
        two = following.value == "the other two"
        return self._other_two() if two else self._pronoun(following, chunk) if following.kind == "pron" else None

    def _pronoun(self, word: Chunk, chunk: Chunk) -> Item | None:
        """Return what a pronoun after a relation stands for; "which" only where a verb follows ("on which sits a lamp")."""
        following = self._ahead(1).kind
        which = word.value == "which" and following in ("verb", "thing")
        that = word.value == "that" and following in ("comma", "stop", "verb", "", "thing")
        both = word.value == "both" and following in ("and", "comma", "stop", "")  # "with a lamp on both"
        if word.value in ("that", "which", "both") and not (which or that or both):
            return None
        self.at += 1
        own = named(self.about)
        own |= {m.thing for k in self._here if k.relation == "with" and named(k.objects) & own for m in k.subjects}
        if word.value == "it" and self.opening is not None and {m.thing for m in self.recent} <= own:
            return self.opening  # "The window is in the north wall. Under it is a desk with a chair."
        told = self.said.last.relation == "flank" or (chunk.value[:3], self.said.last.relation) == ("far", "near")
        if word.value == "it" and told and (place := place_in(self.said.last.objects, "door", "window")):
            return place  # "the fridge close to the door and the stove far from it"; what flanks a window is no "it"
        opening = opening_before(self.chunks[: self.at - 2]) if word.value == "it" and chunk.value != "on" else None
        if opening is not None:
            return place_of(opening)
        own, meant = named(self.about), (self.acted or self.group)[-1:]
        right_before = self.target is not None and self.target.thing.spans[-1][1] == self._ahead(-3).start
        if which and right_before and self.target is not None and not self.target.sat_on:
            meant = [self.target]  # "a bench next to the dresser, on which there is a vase"
        if not which:
            others = [m for m in self.recent or self.before if m.thing not in own][-1:]
            meant = others if that else self._standing(self._meant(word.value, chunk.value), chunk)
        last = self.said.last
        there = {m.thing for m in meant if m.thing.spans[-1][0] >= last.start}  # said since
        lone = word.value == "it" and there <= own and named(last.subjects) <= own
        if lone and (place := place_in(last.objects, "door", "window")):
            return place  # "a chair by the window, facing it"
        if word.value in small.SEVERAL:
            meant = [Mention(mention.thing, mention.pick) for mention in meant]
        self.pending = meant[1:]
        one = any((m.thing.number, m.det) == (1, "") for m in self.about)  # "one mirror above both"
        shared = word.value.startswith("both") and (one or chunk.value in ("front", "facing", "opposite", "amid"))
        if word.value.startswith(("each", "every", "both")) and meant and not shared:
            return Mention(meant[0].thing, None, "each")
        return meant[0] if meant else None

    def _place_of(self, chunk: Chunk) -> Item:
        """Return a place of the room, or the thing whose side it is ("the foot of the bed")."""
        following = self.chunks[self.at : self.at + 2]
        self._understood(chunk)
        if chunk.value in ("window", "door") and chunk.number:  # "a desk under two windows"
            told = any((place.name, place.number) == (chunk.value, chunk.number) for place, _ in self.said.openings)
            if chunk.number > 1 and not told:
                self.said.openings.append((place_of(chunk), (chunk.start, chunk.end)))
        on_a_wall = [c.value for c in following] in (["on", "wall"], ["in", "wall"]) and of_the_plan(following[1])
        if chunk.value in ("window", "door") and on_a_wall and not sides(chunk):  # "facing the window on the east wall"
            self.at += 2
            self._understood(*following)
            return replace(place_of(chunk), words=on_a_wall)
        if chunk.value in ("side", "middle", "corner") and len(following) == 2 and following[0].value == "of":
            if following[1].kind in ("thing", "pron"):
                self.at += 1
                return self._object(chunk) or place_of(chunk)
            if following[1].kind in ("part", "room"):
                self.at += 2
                self._understood(*following)
                if following[1].kind == "room":
                    self.said.facts.append(following[1])
                if chunk.value == "corner":  # "in the left corner of the back wall"
                    return replace(place_of(chunk), words=(*chunk.adjectives, *following[1].adjectives))
                if (chunk.value, following[1].value) == ("middle", "wall"):  # "against the center of the far wall"
                    return replace(place_of(following[1]), words=(*following[1].adjectives, "middle"))
        return self._side_or_wall(chunk)

    def _which_wall(self, wall: Place) -> Place:
        """Return a wall or corner with the door or window that tells it from the others."""
        following = self.chunks[self.at : self.at + 2]
        if "same" in wall.words and [c.value for c in following] in (["as", "door"], ["as", "window"]):
            following[0] = replace(following[0], kind="with")
        if len(following) < 2 or following[1].kind != "part" or (wall.name, following[1].value) == ("corner", "room"):
            return wall
        how = following[0].value if following[0].kind == "rel" else following[0].kind
        corner = wall.name == "corner" and following[1].value in ("door", "window")
        most = corner and bool(small.MOST & {*following[0].adjectives})  # "nearest the window"
        if most != corner or how not in ("opposite", *(small.TELLING_CORNERS if corner else small.TELLING_WALLS)):
            return wall
        self.at += 2
        self._understood(*following)
        return replace(wall, by=(how, place_of(following[1])))

    def _at_sides(self, chunk: Chunk, subjects: Sequence[Mention], place: Place | None) -> bool:
        """Seats on the sides or at the ends of a table stand around it; other things at a side are on top of it or beside it."""
        held = [m.thing for m in self.holder if m.thing.head == "table"]  # "a table by a bar, with seats at the ends"
        tables = held or [thing for thing in self.said.things if thing.has_sides or thing.head == "counter"]
        around = ("chair", "stool", "bench", "cushion", "armchair")
        seats = [m for m in subjects if m.thing.head in around]
        if not tables or not seats or named(subjects) - named(seats) - {tables[-1]}:
            return False
        if chunk.value == "flank" and tables[-1].noun.kind in small.LOW_TABLES:
            return False  # "a console table and two chairs on either side"
        if place is not None and {"back", "front", "rear"} & {*place.words}:
            return False  # of the room
        if place is not None and place.det == "other" and any(place_in(link.objects, "side") for link in self._here):
            return False  # "a sofa at one end, a table with chairs at the other end"
        for seat in seats:
            if seat.per_side(chunk, place, own=seat.det == "a") and seat.thing not in self.dealt:
                seat.thing.number = tables[-1].sides * (seat.thing.number or 1)
            elif place is not None and place.det == "all" and seat.thing.plural and seat.thing.number is None:
                seat.thing.number = 4  # "chairs on all sides"
        self.acted = list(seats)
        at = [k for k in self.said.links if k.relation in ("around", "oneside") and tables[-1] in named(k.objects)]
        one = chunk.value in ("oneside", "end") or (place is not None and place.number == 1 and not place.plural)
        if not any(m.thing is seats[0].thing and m.pick in (None, seats[0].pick) for k in at for m in k.subjects):
            how = "oneside" if one else "around"
            told = chunk.adjectives if place is None else (*place.words, place.det, *["sides"] * place.plural)
            self._link(Chunk("rel", chunk.start, chunk.end, how, adjectives=told), seats, [Mention(tables[-1])])
            self.targets.append(Mention(tables[-1]))
        return True

    def _across_the_room(self, objects: Sequence[Item]) -> Sequence[Item]:
        """Return what a relation leads to, the opposite wall told by the wall, door or window of before: "a desk by the window, ..."."""
        wall = place_in(objects[:1], "wall")
        if wall is None or wall.by or wall.plural or wall.words not in (("opposite",), ("opposing",)):
            return objects
        here = self._here
        far = here[-1:] if any(place_in(k.objects[:1], "wall") for k in here) else here[::-1]
        said = (place_in(k.objects[:1], "window", "door") for k in (*far, *self.said.links[::-1]))
        at = [place for place in said if place is not None]
        there = (place_in(k.objects[:1], "wall", "window", "door") for k in self.said.links[::-1])
        last = next(filter(None, there), wall)
        if last.name == "wall" and (words := across(last.words)):
            return [replace(wall, words=words), *objects[1:]]
        return [replace(wall, words=(), by=("opposite", at[0])), *objects[1:]] if at else objects

    def _walls(self, subjects: list[Mention], place: Place) -> list[Mention]:
        """Return what stands at the wall by which another is told: "the same wall as the crib", "the opposite wall"."""
        if place.name != "wall" or place.plural or place.by is not None:
            return []
        if "same" in place.words and self._ahead().value == "as":
            self.at += 1
            item = self._object(self._ahead(-1))
            return mentions([item] if item is not None else [])
        walled = (k for k in self.said.links if k.relation in ("wall", "on", "by"))
        at = [k for k in walled if k.subjects and place_in(k.objects[:1], "wall")][-1:]
        there = [m for k in at for m in k.subjects if m.thing not in named(subjects)]
        if not {"opposite", "opposing"} & {*place.words}:
            return []
        spoken = (*self.spoken, *self.targets, *self.recent, *self.group)
        there = there or [m for m in spoken if m.walled and m.thing not in named(subjects)][-1:]
        self.said.missed += [] if there else [self._ahead(-1)]
        return there

    def _nearest(self, relation: str) -> list[Mention]:
        """Return what a relation right after a noun is about: small things "on" something all together, else the noun."""
        if holder := self._holder_meant(relation):
            return holder
        relative = self.relative and self.said.last.start >= self.began
        if relative and self.target is not None and self._relative_to(self.target):
            # "a TV that stands on a cabinet by the wall"
            return [self.target] if not self.target.flat else [*self.said.last.subjects]
        following = self._ahead().value
        others = [m for m in self.group if self._ahead().det != "the" or not m.thing.same(self._ahead())]
        self.group = others if others[1:] else self.group  # "a bed, a desk and a chair opposite the bed"
        noun = self.target.thing.noun if self.target is not None else None
        hung = noun is not None and (noun.kind == "fireplace" or any("wall" in kind.places for kind in noun.categories))
        several = self.target is not None and self.target.several and not any(one.several for one in self.group)
        told = relation in ("by", "next", "near", "holds", *(("on", "wall") if following == "wall" and hung else ()))
        told = told and not (hung and self.said.last.relation == "under")  # "a chest under the pegboard by the bench"
        told = told or (following == "wall" and relation in ("on", "wall") and self._looked_at_there())
        borne = self.said.last.relation == "on" and self.target is not None and self.target.several and bool(self.group)
        borne = borne and self.group[-1].several and relation in small.ORDERS  # "computers on desks in three rows"
        told = told or borne or (relation == "rows" and several)  # "a lectern facing chairs in two rows"
        last = self.group[-1:] or list(self.subject or ([self.target] if self.target is not None else []))
        does = {*self._ahead(-1).adjectives} & small.PLURAL_DOES and not self.relative  # "a sofa and a chair face it"
        heads = [mention.thing.head for mention in self.group[-2:]]
        seated = len(heads) > 1 and heads[0] in small.TOPS and heads[1] in ("chair", "stool")
        lined = seated and relation in ("rows", "columns") and self.group[-2].several  # "desks and chairs in rows"
        laid = self._laid(relation, last)
        several = len(self.group) > 1
        had_so, free = self._had_so(relation) if several else None, relation == "on" or not laid
        shared = several and self._shared(relation) and free if had_so is None else had_so
        if several and (lined or does or shared):
            own = seated and (lined or (self._ahead().kind == "part" and following != "side"))
            return self.group[-2 if lined else 0 : len(self.group) - own]  # "a table and four chairs by the window"
        on_tops = self.target is not None and self.target.thing.category.on_object
        if self.target is not None and relation == "on" and following != "wall" and last:
            told = on_tops and not last[0].thing.category.on_object  # "a sofa facing a TV on a stand"
        place = self._ahead().kind == "part"
        if self.target is not None and place and last and relation not in ("on", "facing"):
            told = told or (last[0].thing.category.on_object and not on_tops)  # "a laptop on the desk under the window"
            crowd = relation == "front" and last[0].count >= CROWD
            told = told or (crowd and not self.target.several)  # "twelve desks facing a desk in front of the board"
        to = self._ahead().noun
        if self.target is not None and to is not None and last and relation in small.STANDING:  # "jars on shelves by"
            one = self.target.det == "the" and self._ahead().det == "each"  # "a plate on the table before each chair"
            told = told or (last[0].topped and not (one or self.target.topped or to.category.on_object))
        flanked = (place or relation == "middle") and self.said.last.relation in ("flank", "around")
        told = told or flanked or (relation == "above" and hung)  # "books on a shelf above", "lamps flanking a sofa by"
        if self.target is not None and relation == "amid" and self._ahead().kind == "pron" and last:
            told = told or (last[0].laid and not self.target.laid)  # "tissues on a small table between them"
        flat = self.target is not None and self.target.flat  # "two armchairs on a rug in front of the fireplace"
        flat = flat and (len(self.group) > 1 or any(one.several for one in last))
        told = (told and self.acted) or (flat and relation in (*small.STANDING, "middle"))
        if self.target is not None and (told or (place and self.said.last.relation == "in")):
            return [self.target]  # "toys in a box under the window"
        if relation in small.ORDERS and last and last[0].thing.count == 1:
            several = any(one.several for one in self.acted)  # "three stools at it in a row"
            return list(self.acted if several else self.group or self.subject)  # "fridge, stove and sink in a row"
        return laid or self._both_at_each(relation) or last

    def _both_at_each(self, relation: str) -> list[Mention]:
        """Return two things of which there is one at each of others: "a chair and a monitor at each"."""
        to = self._ahead()
        each = to.det == "each" if to.kind == "thing" else to.value in small.EVERY
        two = [c.kind for c in self.chunks[self.at - 4 : self.at - 1]] == ["thing", "and", "thing"]
        several = [m.several for m in self.group] == [True] * (len(self.group) - 2) + [False] * 2
        return self.group[-2:] if relation in ("by", "next", "near") and each and two and several else []

    def _holder_meant(self, relation: str) -> list[Mention]:
        """Return what bears or has the things before a relation, if that is what it is about."""
        rel, last = self._ahead(-1), self.said.last
        verb = {"form", *small.PLURAL_DOES} & {*rel.adjectives} and not self.relative
        ordered = relation in small.ORDERS and bool(self.group) and self.group[0].thing.number == 1
        if (verb or ordered) and self.every and len(self.group) == 1 and self._previous(rel) != ",":
            return list(self.every[0])  # "chairs, each with a stand, form a circle"
        looks = {"faces", "overlooks"} & {*rel.adjectives} and self._previous(rel) != ","
        if looks and self.having and self.holder and not self.relative:
            return list(self.holder)  # "a chair with a footstool faces the crib"
        if relation == "under" and last.relation == "on" and self.acted == [*last.subjects] and self.target is not None:
            return [self.target] * (not self.target.topped)  # "weights on a rack under the mirror"
        table, laid = self.group[-2:] if len(self.group) > 1 else (None, None)
        if relation != "amid" or table is None or laid is None or not laid.topped:
            return []
        if table.several or table.thing.head not in small.TOPS:
            return []
        self._link(replace(rel, value="on"), [laid], [table])
        return [table]  # "two chairs with a table and a tissue box between them"

    def _had_so(self, relation: str) -> bool | None:
        """Return whether all that something has is so to it ("a basin with a mirror and a shelf above it"), None if it has nothing."""
        to_it = self._ahead().kind == "pron" and self.having and bool(self.holder)
        if not to_it or relation not in (*small.STANDING, "above", "under"):
            return None
        things = [mention.thing for mention in self.group]
        return all(thing.hangs if relation == "above" else thing.places == ("floor",) for thing in things)

    def _shared(self, relation: str) -> bool:
        """Return whether a relation after a list is about all of it: "a sofa and an armchair in the corner".

        Not where it leads back to the list, where one of it has a relation of its own or cannot stand so; of what a room or a
        thing has, and of three things that do not belong together, only the last one stands at a place.
        """
        *earlier, last = (mention.thing for mention in self.group)
        if self.group[-1].sat_on and earlier[-1].people not in (0, last.count):
            return False  # "a table for six and two chairs by the window"
        to = next((c for c in self.chunks[self.at :] if c.kind not in ("filler", "style")), Chunk("", 0, 0))
        again = to.kind == "pron" or any(thing.same(to) for thing in (*earlier, last))
        ends = to.kind in ("", "and", "comma", "stop")  # "a bed, a desk beneath"
        among = ends and relation == "middle" and last.head in small.TOPS and {a.head for a in earlier} <= small.LOUNGE
        if relation == "around" or among:
            return not among and all(one.sat_on for one in self.group)  # "two sofas and a table in the middle"
        whole = len(self.group) == len(self.said.things)  # "a bed and a night stand on each side"
        by = relation in small.NEARNESS or last.noun.kind == "night stand"
        again = again or (ends and (by or (whole and relation in ("flank", "behind"))))
        begun = next(i for i, c in enumerate(self.chunks) if c.end == last.spans[-1][1])
        closed = self.chunks[begun - 1].kind == "and"
        across = closed and to.value in ("wall", "corner") and to.plural and "opposite" in to.adjectives
        if (self.chunks[begun - 1].value == LISTED or across) and not again:
            return True  # "two shelves, a low one and a tall one, by the door", "a bed and a desk on opposite walls"
        had = "with" if relation == "flank" else ""
        own = (k for k in self._here if k.relation != had)
        if again or not closed or self.target is not None or {m.thing for k in own for m in k.subjects} & {*earlier}:
            return False
        where, many = _where(relation, to), relation == "flank" and any(mention.several for mention in self.group)
        kinds = (thing.noun.categories for thing in earlier)
        barred = bool(where) and not all({*where} & {at for kind in any_of for at in kind.places} for any_of in kinds)
        if many or barred or relation not in small.SHARED:
            return False
        if relation in ("wall", "flank") or where == ("object",):
            return True
        unit = self.chunks[begun]  # "an armchair and ottoman"
        if not (unit.det or unit.plural or unit.number is not None or earlier[1:]):
            return True
        if earlier[0].count >= CROWD > last.count:
            return False  # "twenty desks and a teacher's desk in front of the board"
        alike = all(mention.thing.head in (*small.SEATS, *small.TOPS) for mention in self.group)
        had = [c.kind for c in self.chunks[:begun] if c.start >= self.began]
        goes_on = [c.kind for c in takewhile(lambda c: c.kind != "stop", self.chunks[self.at :])]
        # "bars along a wall, a ball and a roller in the corner, a stool ..."
        amid = "rel" in had and "thing" in goes_on[1:]
        if {"room", "with", "colon"} & {*had} and not (amid and len(earlier) == 1):
            return alike and not earlier[1:]
        return alike or not earlier[1:] or all(thing.definite for thing in earlier) or to.kind == "thing"

    def _subjects(self, relation: str) -> list[Mention]:
        """Return what a relation here is about."""
        previous = next((c for c in reversed(self.chunks[: self.at - 1]) if c.kind not in ("filler", "style")), None)
        opening = previous is not None and previous.value in ("window", "door")
        if previous is None or previous.kind == "stop" or (opening and previous.det == "a"):
            return []  # "a window on each side of it"
        if relation in small.ORDERS and (led := self._all_led(previous)):
            return led  # "along the wall run the counter, the oven and the dishwasher, from left to right"
        if self.fronted is not None and previous.kind in ("and", "comma"):
            self.also = self.fronted if not self.group else None  # "between them, under the window, is a table"
            self.fronted = None
            return []
        verb = previous.kind == "verb" or self.verb
        if self._of_the_noun() or (previous.kind == "thing" and not verb):
            return self._nearest(relation)
        which = previous.value == "which" and not {*self._ahead(-1).adjectives} & small.PLURAL_DOES
        if which or (verb and self.relative):
            return self._right_before()  # "a sofa faces the TV, which hangs on the wall"
        if verb:
            return list(self.subject or self.group)
        if held := self._holder_of_it(previous):
            return held
        if previous.kind == "pron" and not self.relative:
            return list(self.before or self.subject) if not self.group else list(self.group)
        if previous.kind == "comma" and self.holder and not self.acted and self._ahead().kind != "pron":
            return list(self.holder)  # "three desks, each with a chair, in a row"
        ordered = relation in small.ORDERS and len(self.group) > 1 and not self.acted
        return list(self.group if ordered else self.acted or self.group[-1:] or self.subject)

    def _holder_of_it(self, previous: Chunk) -> list[Mention]:
        """Return what has other things, where a relation comes right after what is said of these: "a rug with a table on it in ..."."""
        if previous.kind == "comma" and self._ahead(-3).kind == "measure" and self.group:
            return self.group[-1:]  # "a bookshelf, 80 cm high, within reach"
        of_it = previous.kind == "pron" and self.having and self.holder and not self.verb
        if of_it and [*self.said.last.objects] == self.holder:
            return list(self.holder)  # "a rug with a table on it in front of the sofa"
        back = self._ahead(-3)  # "bunk beds with desks underneath, on opposite walls"
        past = (
            previous.kind == "comma" and (back.kind == "pron" or back.value == "under") and self._ahead().kind != "pron"
        )
        if past and self.holder and named(self.said.last.objects) == named(self.holder):
            return list(self.holder)  # "a vanity with a mirror above it, opposite the door"
        return []

    def _of_the_noun(self) -> bool:
        """Return whether a participle leads from the noun before it to a relation: "..., a lamp hanging over it"."""
        index, chunks = self.at - 2, self.chunks
        while index > 0 and chunks[index].kind in ("verb", "filler") and chunks[index].value not in small.FINITE:
            index -= 1
        return index < self.at - 2 and chunks[index].kind == "thing"


def _where(relation: str, to: Chunk) -> tuple[str, ...]:
    """Return where a thing must be able to be that stands so to something: one stands also "on" a wall told from the others."""
    flat = to.noun is not None and to.noun.category.size[2] < FLAT_HEIGHT
    if relation == "on" and to.value == "wall":
        return ("wall", "floor") if to.adjectives else ("wall",)
    if relation == "above":
        return ("wall", "ceiling")
    if relation in ("on", "in") and to.kind == "thing" and not flat:
        return ("object",)
    return ("floor",) if relation in ("on", "in", "wall", "under") else ()
