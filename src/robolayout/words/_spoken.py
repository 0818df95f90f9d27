"""What was spoken of in a text so far, and what "it", "them" and "the row" stand for."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from robolayout.words import _function_words as small
from robolayout.words._chunk import NOTHING, Chunk
from robolayout.words._lexicon import grammar
from robolayout.words._room_part import RoomPart
from robolayout.words._said import (
    Item,
    Link,
    Mention,
    NamedThing,
    Parsed,
    Place,
    mentions,
    named,
    place_in,
    place_of,
    places,
)


def across(words: Sequence[str]) -> tuple[str, ...]:
    """Return the words that tell the wall or corner across the room from one that some words tell."""
    return tuple(small.ACROSS[word] for word in words if word in small.ACROSS)


class Spoken:
    """What was named so far in a text, and in its last sentence."""

    def __init__(self, chunks: Sequence[Chunk]) -> None:
        self.chunks = list(chunks)
        self.said = Parsed()
        self.zones: dict[str, RoomPart] = {}
        self.zone: RoomPart | None = None  # the part of the room that this sentence is about
        self.at = 0
        self.before: list[Mention] = []
        self.opening: Place | None = None  # the door or window that the last sentence was about
        self.spoken: list[Mention] = []  # all that the last sentence named
        self.pending: list[Mention] = []
        self.dealt: dict[NamedThing, int] = {}
        self.about: list[Mention] = []  # what the relation that is being read is about
        self.kept: list[Mention] = []  # what the last "it" stood for, or the head of the sentence led to
        self.contrast: tuple[str, Sequence[Item]] = ("", [])  # the other side than the last one, and of what
        self.axis = ""  # along which line of it, where no "it" was said
        self.other: list[Mention] = []  # what was said since, by a noun
        self.by_it = False  # whether an "it" at the head of a clause was the last one
        self.gap: Chunk | None = None  # a measure right before a relation
        self.told = 0  # where that was said
        self.began = 0
        self._new_sentence()

    def _on_colon(self, _: Chunk) -> None:
        """End what is refused: "a room without a desk: a bed, a chair"."""
        self.refusing = self.negated = False

    def _new_sentence(self) -> None:
        if self.told < self.began:  # of the sentence before the last one
            self.contrast, self.kept = ("", []), []
        self.began = self.chunks[self.at - 1].start if self.at else 0
        self.zone = None
        self.group: list[Mention] = []
        self.subject: list[Mention] = []
        self.acted: list[Mention] = []
        self.holder: list[Mention] = []
        self.fronted: tuple[Chunk, list[Item]] | None = None
        self.also: tuple[Chunk, list[Item]] | None = None  # "in the corner nearest the window stands a lamp"
        self.led: list[Mention] = []  # what a relation led back to
        self.outer: list[Mention] = []  # what "on which" is said of, which the clause after the next comma goes on with
        self.refusing = self.negated = self.empty = self.verb = False
        self.aside = False  # whether what is had was said after a comma: "a toilet at a wall, with a basin opposite it"
        self.relative = self.having = self.listed = False
        self.recent: list[Mention] = []
        self.targets: list[Mention] = []
        self.target: Mention | None = None
        self.every: tuple[list[Mention], int] | None = None  # what each has that is spoken of, and how many there are

    def _part_of_room(self, chunk: Chunk) -> RoomPart:
        """Return the part of the room that a phrase names."""
        told = chunk.adjectives if chunk.kind == "part" or chunk.value == "room" else ()
        part = self.zones.setdefault(" ".join((*told, chunk.value)).split()[0], RoomPart())
        if chunk.kind in ("room", "corner") and chunk.value in small.AREAS:
            part.area = part.area or chunk
        return part

    def _stands_for(self, chunk: Chunk) -> Mention | None:
        """Return what stands for a part of the room, where that is not all of it, or a person: "near the kitchen", "behind the teacher"."""
        if chunk.kind == "people":  # "the teacher's desk and a board behind the teacher"
            own = [t for t in self.said.things if chunk.value in {w.removesuffix("s") for w in t.phrase}]
            return Mention(own[-1]) if own else self._seat_of(chunk)
        if chunk.kind not in ("room", "corner"):
            return None
        others = [fact for fact in self.said.facts if fact.kind == "room" and fact.value != chunk.value]
        if chunk.value not in small.AREAS or (chunk.kind == "room" and not others):
            return None
        part = self._part_of_room(chunk)
        if chunk.kind == "corner" and chunk.det == "the" and chunk.value in ("seating", "lounge") and not part.things:
            part.things += self._last_of(small.LOUNGE, set())[-1:]  # "two sofas ... near the seating group"
        if not part.things and part.first is None:
            kind, count = next(iter(small.AREAS[chunk.value].items()))
            part.first = self.said.implied(kind, count, chunk)
        thing = part.things[0].thing if part.things else part.first
        return Mention(thing, slice(0, 1) if thing.count > 1 else None) if thing is not None else None

    def _seat_of(self, who: Chunk) -> Mention | None:
        """Return the one seat at a desk, or the desk, of somebody: "a desk with a chair behind it, a bookcase behind the lawyer"."""
        if who.det != "the" or who.value.endswith("s") or who.value in ("people", "children", "men", "women"):
            return None
        seats = [k.subjects[0] for k in self.said.links if k.relation in ("behind", "by", "with") and k.subjects]
        seats = [m for m in seats if m.sat_on and m.count == 1]
        there = [m for m in (*seats, *self._last_of(("desk",), set())) if m.thing not in named(self.about)]
        return next(iter(there), None)

    def _new_zone(self, chunk: Chunk) -> None:
        """Forget what was spoken of: what a part of the room has belongs to no thing before it."""
        half = chunk.value == "side" and bool({*chunk.adjectives} & {*grammar().walls})
        if half or self.zone is None or not self.zone.half:  # "the front half is a play area with a rug"
            self.zone = self._part_of_room(chunk)
        elif chunk.kind == "corner":
            self.zone.area = self.zone.area or chunk
        if half or (chunk.kind, chunk.value) == ("part", "corner"):
            self.zone.half, self.zone.place = half, (replace(chunk, kind="rel", value="in"), [place_of(chunk)])
        self.fronted = None if self.group else self.fronted
        self.group, self.subject, self.acted, self.holder = [], [], [], []
        self.having = False

    def _into_the_zone(self, chunk: Chunk, mention: Mention) -> None:
        """Note that a thing is in the part of the room that is spoken of; "the kitchen at the back and the sofa" leaves that."""
        zone, before = self.zone, self._previous(chunk)
        if zone is not None and not zone.things:
            # "a kitchen along the wall, a sofa facing the television"
            other = zone.area is not None and zone.area.value == "kitchen" != mention.thing.category.group
            placed = self._ahead().kind == "rel" and self._ahead(1).kind == "part"  # "..., a sofa along the left wall"
            listed = before == "," and (other or (zone.area and (placed or not zone.place)))
            self.zone = None if listed or (before == "and" and (zone.place or zone.area)) else zone
        if self.zone is not None and not mention.thing.spans[1:]:
            self.zone.things.append(mention)
            area = self.zone.area
            if area is not None and area.number and mention.thing.times == 1:
                each = any(c.value == "each" and c.start >= area.end for c in self.chunks[: self.at])
                mention.thing.times = area.number if each else 1  # "two seating groups, each with two armchairs"

    def _is_zone(self, chunk: Chunk) -> bool:
        """Return whether a side is a part of the room by what one does there: "the living part is on the left"."""
        if [c.kind for c in self.chunks[self.at : self.at + 2]] in (["filler", "room"], ["filler", "part"]):
            self.at += 2  # "the front half of the room"
        told = chunk.det in ("the", "a") and len(chunk.adjectives) == 1
        told = told and not {*chunk.adjectives} & {"headboard", *grammar().sizes}
        return bool(told) and not self.group and self._ahead().kind in ("verb", "rel", "with")

    @property
    def _here(self) -> list[Link]:
        """The relations of this sentence."""
        return [link for link in self.said.links if link.start >= self.began]

    def _ahead(self, more: int = 0) -> Chunk:
        """Return the chunk that follows, or one so many further on; before the one that is read is -2."""
        at = self.at + more
        return self.chunks[at] if 0 <= at < len(self.chunks) else NOTHING

    def _understood(self, *chunks: Chunk) -> None:
        """Note chunks that are understood with what stands before them."""
        self.said.read.update(token for chunk in chunks for token in range(chunk.start, chunk.end))

    def _previous(self, chunk: Chunk) -> str:
        """Return the value of the chunk before this one."""
        index = self.chunks.index(chunk)
        return self.chunks[index - 1].value if index else ""

    def _sat_at(self, *last: Mention) -> bool:
        """Return whether one sits on a thing, or at it: what was named last."""
        return any(m.thing.head in (*small.TOPS, *small.SEATS, "island") for m in last or self.group[-1:])

    def _promised(self, people: int, back: int) -> bool:
        """Note for how many the thing named last is, or the room ("two armchairs, and seating for six"); return whether they sit there."""
        seating = self._ahead(back).value
        own = (self._ahead(back - 1).kind, self._ahead(back - 2).kind) == ("with", "thing")
        if self.group and (own or seating != "seating"):
            to = [m for m in [self.target] if m is not None and m.thing.spans[-1][0] == self._ahead(back).start]
            last = (to or self.group)[-1]  # "a sofa beside a table for four"
            last.thing.people = people
            return self._sat_at(last)
        self.said.people = people
        return seating in small.SEATED

    def _turned_round(self, first: int, index: int) -> bool:
        """Return whether what follows the object of a relation is what it is about: "and on it stands a lamp"."""
        end, verb = index, False
        aside = self.chunks[first - 1].det == "its" or [c.kind for c in self.chunks[index - 1 : index]] == ["pron"]
        if aside and [c.kind for c in self.chunks[index : index + 2]] == ["comma", "thing"] and first > 1:
            return self.chunks[first - 2].kind == "comma"  # "a sofa and, next to it, a lamp"
        while index < len(self.chunks) and self.chunks[index].kind in ("verb", "filler", "style", "pron"):
            verb = verb or self.chunks[index].kind == "verb" or self.chunks[index].value in small.SPEAKING
            index += 1
        if index >= len(self.chunks) or self.chunks[index].kind != "thing":
            return False
        starts = self.chunks[first - 2].kind in ("and", "comma", "stop", "colon") if first >= 2 else True
        starts = starts or self.chunks[end - 1].value == "which"  # "a rack beside which hangs a mirror"
        return starts and (verb or (index == end and self.chunks[index].det != "the"))

    def _meant(self, word: str, relation: str = "") -> list[Mention]:
        """Return what a pronoun stands for.

        That is what stands before "with"; what the last "it" stood for ("a lamp behind it, a table to the left of it"); what was
        named last before; what the last relation led to, where that is one and the other is several; the subject before.
        """
        own = named(self.about)
        on = [(named(k.subjects), named(k.objects)) for k in self.said.links if k.relation == "on"]
        # "a camera on a tripod before it", "a printer on a cabinet next to it"
        own = own.union(*(top for laid, top in on if own & laid), *(laid for laid, top in on if own & top))
        aside, of = self.contrast[0], mentions(self.contrast[1])
        if word == "it" and not self.about and relation == aside and of:
            return of  # "behind it a table with four chairs, in front of it a rug"
        if relation == "foot" and (bed := self._last_of(small.SLEPT_ON, own)):
            return bed  # "a wardrobe opposite the beds and a rug at their feet"
        if word.startswith("the row"):
            return next((list(k.subjects) for k in reversed(self.said.links) if k.relation in small.ORDERS), [])
        holder = self.holder[0] if self.holder else None
        earlier, to = ([m for m in given if m.thing not in own] for given in (self.recent, self.targets))
        many = holder is not None and holder.several and holder.det != "each"
        one = not many if word == "it" else many or word not in small.SEVERAL or len(earlier) < 2
        one = one and not (word in small.SEVERAL and self._all_of_before(earlier))
        each = word in small.EVERY and word not in small.SEVERAL and not many
        if each and (led := [m for m in earlier if m.several]):
            return led[-1:]  # "a sofa with a table at each end and a lamp on each of them"
        if holder is not None and holder.thing not in own and one:
            # "an armchair, at its right a table with a lamp, a bookshelf behind it"
            whole = relation == "behind" and [m.topped for m in self.recent[-2:]] == [True, False]
            whole = whole and [c.kind for c in self.chunks[max(self.at - 4, 0) : self.at]][:1] == ["comma"]
            return (whole and self._kept(word, relation, own)) or self.holder
        amid = mentions(self.said.last.objects) if self.said.last.relation == "amid" else []
        beside = relation in (*small.AT_SIDES, "behind", "front")
        if word in small.SEVERAL and len(amid) == 1 and amid[0].several and beside:
            return amid  # "two armchairs, a table between them and a bookcase behind one of them"
        if word in small.SEVERAL:
            held = [m for m in earlier if holder is None or many or m.thing is not holder.thing]
            return self._several_meant(relation, held if len(held) > 1 else earlier, to)
        meant = self._kept(word, relation, own) or self._last(word, relation, earlier, to)
        worked_at = relation == "on" and any(m.thing.head in small.WORKED_AT for m in self.about)
        seat = worked_at and bool(meant) and meant[0].sat_on  # "a chair stands behind the desk; a laptop is on it"
        return (self._last_of(small.TOPS, own) if seat else []) or meant

    def _at_a_place(self, chunk: Chunk, subjects: list[Mention], place: Place) -> list[Mention]:
        """Return which of some things are at a place of the room: no tables with seats around them, and both that share a wall."""
        if chunk.value == "wall":  # "two tables for eight and shelves along the walls"
            free = place.plural and subjects[-1].thing.head != "table"
            seated = [m for m in subjects if m.thing.head in small.TOPS and m.thing.promising]
            off = [m for m in subjects if m.thing.head == "table"] if free else seated
            subjects = [m for m in subjects if m not in off] or subjects
        if chunk.value == "on" and place.name == "wall":  # "a rack, magazines and a TV on the wall"
            subjects = [m for m in subjects if m.thing.places != ("object",)] or subjects
        alone = "same" in place.words and len(subjects) == 1 and not subjects[0].several
        every = any(c.value == "all" or c.det == "all" for c in self.chunks[max(self.at - 4, 0) : self.at - 1])
        last = [*{m.thing: m for m in self.recent}.values()][-2 * (not every) :]
        return last if alone else subjects  # "a wardrobe and a dresser on the same wall"

    def _of_a_thing(self, part: Chunk) -> bool:
        """Return whether a part is one of a thing that follows, and go there: "opposite the foot of the bed"."""
        if part.kind != "function" or self._ahead().value != "of" or self._ahead(1).kind not in ("thing", "pron"):
            return False
        self._understood(part)
        self.at += 1
        return True

    def _side_or_wall(self, chunk: Chunk) -> Place:
        """Return a place of the room; a long or short side is a wall, as are three sides, unless they are those of a table or bed."""
        long = bool({"long", "short"} & {grammar().walls.get(word) for word in chunk.adjectives})
        free = self._ahead(-3).value in small.FREE  # "the saw free on all sides"
        several = ((chunk.number or 0) > 1 or chunk.det == "all") and not free
        # "the bed against a wall and a desk on the opposite side"
        across = {"opposite", "opposing", "other"} & {*chunk.adjectives} and place_in(self.said.last.objects, "wall")
        sided = any(thing.head in (*small.TOPS, "bed", "island") for thing in self.said.things)
        own = any(m.sat_on for m in self.about) if long else sided
        wall = across or ((long or several) and (not own or self._ahead(-1).kind == "room"))
        return replace(place_of(chunk), name="wall") if chunk.value == "side" and wall else place_of(chunk)

    def _opposite_corner(self, place: Place) -> Place:
        """Return the corner across from that of before: "the bed in the north-west corner, the desk in the opposite one"."""
        before = [at.words for link in self.said.links for at in places(link.objects, "corner")][-1:]
        if place.name != "corner" or place.by or not {"opposite", "opposing", "diagonal"} & {*place.words}:
            return place
        at = [opening for link in self._here if (opening := place_in(link.objects[:1], "window", "door"))][-1:]
        if at and not before:  # "the bed under the window, the desk in the opposite corner"
            return replace(place, words=(), by=("across", at[0]))
        told = across(before[0] if before else ())
        self.said.missed += [] if before or place.plural else [self._ahead(-1)]  # "two plants in opposite corners"
        return replace(place, words=told or ("opposite",))

    def _number_of(self, item: Item) -> int:
        """Return how many there are of a thing, of corners or walls, of doors or windows that are asked for."""
        if isinstance(item, Mention):
            return item.thing.count
        asked = sum(place.number or 0 for place, _ in self.said.openings if place.name == item.name)
        # "in each of the back corners", "in each corner opposite the door"
        sides = len({*item.words} & {*grammar().walls}) or (item.by is not None)
        corners = 4 if not sides or item.name == "wall" else 2 // sides
        halved = item.name == "wall" and {"long", "short", "side", "opposite"} & {*item.words}
        corners = 2 if halved or item.det == "both" else corners
        usual = 2 if item.det in ("each", "both", "all") else 1
        return item.number or (corners if item.name in ("corner", "wall") else asked or usual)

    def _gaps(self, item: Item) -> int:
        """Return how many gaps there are between neighbours of several things that stand in rows, in pairs or along walls."""
        if any(link.relation == "pairs" and named((item,)) & named(link.subjects) for link in self.said.links):
            return max(self._number_of(item) // 2, 1)
        if isinstance(item, Place):
            return max(self._number_of(item) - 1, 1)
        at = [to for link in self.said.links if item.thing in named(link.subjects) for to in link.objects]
        walls = places(at, "wall")
        rows = (self._number_of(wall) if wall.det in ("each", "both") else wall.number or 1 for wall in walls)
        return max(self._number_of(item) - max(item.thing.rows, *rows, 1), 1)

    def _laid(self, relation: str, last: list[Mention]) -> list[Mention]:
        """Return all that was just named and is laid on something: "plates and glasses on the table", "... before each chair"."""
        to = self._ahead()
        if not last or len(self.group) < 2:
            return []
        at_each = relation in ("front", "by") and to.det == "each" and last[0].topped
        if not (last[0].thing.category.on_object if relation == "on" else at_each):
            return []
        held = "with" if to.det == "each" or to.kind == "pron" else ""
        linked = {m for link in self.said.links if link.relation != held for m in link.subjects}
        return [m for m in self.group if m.thing.category.on_object and m not in linked - {last[0]}]

    def _listed_with(self, relation: str, subjects: list[Mention], objects: Sequence[Item]) -> list[Mention]:
        """Return what is at one side of what has it: "a sofa with a rug and a table in front of it"; chairs are around theirs."""
        last = self.said.last
        its = self.having and self._ahead(-1).kind == "pron" and named(objects) == named(self.holder)
        if not its or last.relation != "with" or named(last.objects) != named(self.holder):
            return subjects
        beside, bears = relation in ("next", "left", "right"), self.holder[0].thing.head in small.TOPS
        also = [m for m in last.subjects if m.thing.count == 1 and m.thing not in named(subjects)]
        also = [m for m in also if any(kind.on_floor for kind in m.thing.noun.categories)]
        also = [m for m in also if not (bears and any(kind.on_object for kind in m.thing.noun.categories))]  # lamps
        also = [m for m in also if beside or m.flat]
        return [*also, *subjects] if beside or relation in ("front", "foot") else subjects

    def _last_of(self, heads: Collection[str], own: set[NamedThing]) -> list[Mention]:
        """Return what was named last of things with some last words, `own` aside; nothing where there is none."""
        return [Mention(thing) for thing in self.said.things if thing.head in heads and thing not in own][-1:]

    def _kept(self, word: str, relation: str, own: set[NamedThing]) -> list[Mention]:
        """Return what the last "it" stood for where this one stands for the same."""
        side, of = self.contrast[0], mentions(self.contrast[1])
        if word == "it" and relation == side and of and of[0].thing not in own:
            return of  # "a lamp to the left of the sofa; to the right of it a plant"
        again = [c.kind for c in self.chunks[max(self.at - 5, 0) : self.at]] == ["pron", "and", "thing", "rel", "pron"]
        again = again and relation != "on"  # "an armchair, a lamp behind it and a table beside it"
        again = again or (self.by_it and not self.about)  # "Under it is a bin, and next to it a cabinet."
        keeps = self.axis == small.AXES.get(relation) if self.axis else relation not in (*small.CLOSE, "")
        kept = self.kept if (again or keeps) and named(self.other) <= own else []
        return [m for m in kept if m.thing not in own]

    def _last(self, word: str, relation: str, earlier: list[Mention], to: list[Mention]) -> list[Mention]:
        """Return what was named last in this sentence, by itself or as what a relation led to, else in the one before."""
        free = [[m for m in given if m.admits(relation, self.about)] for given in (earlier, to)]
        if any(free) and free[0][-1:] != earlier[-1:]:  # "a wine fridge next to the bar, a shelf behind it"
            earlier, to = free[1] or free[0], free[1]
        if relation in small.ROUND_IT:  # "a lamp over a table, and chairs around it"
            off = {"wall", "ceiling", *(("object",) if relation == "around" else ())}
            there = [[m for m in given if {*m.thing.places} - off] for given in (earlier, to)]
            earlier, to = there if any(m.thing.count == 1 for given in there for m in given) else (earlier, to)
        if self.about and all(m.sat_on for m in self.about) and earlier and earlier[-1].laid:
            sat_at = [m for m in (*earlier, *to) if m.thing.head in small.TOPS]
            earlier = sat_at or earlier  # "a vise on the bench and a stool in front of it"
        single, led = ([m for m in given if m.one] for given in (earlier, to))
        if word == "it" and earlier and not earlier[-1].one:  # "hooks above the bench, a rack below it"
            earlier = led or single or earlier
        before = self.before[:1]
        if word == "it" and before and before[0].several:  # "Six chairs are around it. A lamp hangs above it."
            before = [m for m in (*self.spoken, *self.kept) if m.thing.count == 1][-1:] or before
        if word == "it" and len(self.before) > 1:  # "On the desk are a lamp and a cup. Under it is a bin."
            on = [k.objects for k in self.said.links if before[0].thing in named(k.subjects)]
            before = [o for to in on for o in mentions(to) if not o.several][-1:] or before
        return earlier[-1:] or to[-1:] or before or self.group[:1]

    def _several_meant(self, relation: str, earlier: list[Mention], to: list[Mention]) -> list[Mention]:
        """Return what "them" stands for: several things named at once, or the last two."""
        own = named(self.about)
        had = {thing for k in self.said.links if named(self.holder) & named(k.objects) for thing in named(k.subjects)}
        others = [m for m in earlier if m.thing not in had]  # "two armchairs and a table with two cups between them"
        earlier = others if others and others[-1].several and self.group[-1:] and self.group[-1].topped else earlier
        on = {thing for k in self.said.links if own & named(k.objects) for thing in named(k.subjects)}
        again = (m.pick is None and m.thing in named(earlier[i:]) for i, m in enumerate(earlier, 1))  # "each desk"
        earlier = [
            m for m, said in zip(earlier, again, strict=True) if not said and (m.thing not in on or not m.topped)
        ]
        borne = {thing for k in self._here if k.relation == "on" for thing in named(k.subjects)}
        # "a washer, a dryer, a basket on it and a shelf above them"
        below = [m for m in earlier if m.thing not in borne]
        earlier = below if relation == "above" and len(below) > 1 else earlier
        several = [m for m in earlier if m.thing.count > 1]
        if several and earlier[-1:] == several[-1:]:
            lines = relation == "amid" and [m.count > 2 for m in several[-2:]] == [True, True]
            return several[-2:] if lines else several[-1:]  # "three beds along a wall, three lockers along another"
        if len(earlier) == 1:  # "a sofa facing the TV and a table between them"
            earlier += [m for m in to[-1:] if m.thing is not earlier[0].thing]
        before = self.before
        if len(before) == 1 and before[0].thing.count == 1:
            two = ([*k.subjects, *k.objects] for k in reversed(self.said.links) if k.relation != "on" and k.objects)
            standing = ([m for m in mentions(both) if not m.topped] for both in two)
            last = [m for m in self.spoken if not m.topped]  # "One bed is here and one bed there. Between them ..."
            before = next((both for both in standing if len(both) > 1), last[-2:] if len(last) > 1 else before)
        return self._all_of_before(earlier) or earlier[-2:] or before

    def _all_led(self, previous: Chunk) -> list[Mention]:
        """Return the several things that stand where the head of the clause says: "at the wall are two desks, side by side"."""
        if previous.kind == "comma" and self.fronted is not None and any(m.several for m in self.acted):
            return list(self.acted)
        led = self.fronted[1] if self.fronted is not None else []
        one = led and self.group[-1:] and not self.group[-1].several  # not "a desk and three chairs in a row"
        found = [m for k in self._here if one and list(k.objects) == led for m in k.subjects]
        return found if len(found) > 1 else []

    def _right_before(self) -> list[Mention]:
        """Return what a relative clause is about, the noun right before it: "the sink, which is under the window"."""
        return self.group[-1:] if self.target is None else [self.target]

    def _all_of_before(self, earlier: Sequence[Mention]) -> list[Mention]:
        """Return the several things of the sentence before, where one alone was named since: "A table with magazines is before them."."""
        one = [m.several for m in earlier] == [False] and not self.targets
        return list(self.before) if one and [m.several for m in self.before[-1:]] == [True] else []

    def _keep(self, relation: str, objects: Sequence[Item], *, pronoun: bool, fronted: bool) -> None:
        """Note what a relation led to, so that a later "it" can mean the same."""
        if not objects:
            return
        self.told, self.by_it = self._ahead(-1).start, pronoun and fronted
        things = [item for item in mentions(objects) if item.thing.count == 1]
        if not pronoun or fronted or relation in small.OF_A_SIDE:
            aside = relation in ("left", "right")  # "a desk before the window, a chair behind it" is behind the desk
            side = things[:1] or [item for item in objects[:1] if aside and place_in([item], "door", "window")]
            told = (small.OTHER_SIDE[relation], side) if relation in small.OTHER_SIDE else ("", [])
            kept = not told[0] and (relation == "on" or place_in(objects[:1], "wall", "corner") is not None)
            self.contrast = self.contrast if kept else told
        if things and (pronoun or (fronted and relation in small.AXES)):
            self.kept, self.axis, self.other = things[:1], "" if pronoun else small.AXES[relation], []
        elif not pronoun:
            self.kept, self.other = [] if fronted or mentions(objects) else self.kept, list(self.about)
