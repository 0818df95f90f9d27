"""From chunks to what they say: things with counts, and relations between them.

A relation belongs to the thing before it; after "is", "are", "stands" to the subject of the clause; after a comma or "and" to
what the last relation was about; at the head of a clause to what follows ("on the desk is a lamp"). "It" is the subject of the
clause before, or what stands before "with". A noun with "the" that was named before is that thing; other nouns are new ones.
"""

from __future__ import annotations

from collections.abc import Sequence

from robolayout.words._chunks import Chunk
from robolayout.words._references import References
from robolayout.words._said import (
    Link,
    Mention,
    Parsed,
    Place,
    count_of,
    place_of,
    several,
    topped,
)

REVERSED = {"flanked": "flank", "surrounded": "around", "holds": "on"}
"""Relations that are said from the other side."""

AIDS = {"wheelchair": "wheelchair", "walker": "elder_walker"}
"""Bodies by what they use; what a room is to contain is a thing."""

_ALONE = "next row pairs backs stacked diagonal lit parallel mutual abreast middle flank left right front near under"
ALONE = frozenset(_ALONE.split())
"""Relations that may stand without an object."""

SAID_OF = {"stacked": "stacked", "piled": "stacked", "diagonal": "diagonal", "angled": "diagonal"}
"""Relations that stand before a noun."""


class Parser(References):
    """Reads chunks from left to right."""

    def parse(self) -> Parsed:
        """Return what the chunks say."""
        while self.at < len(self.chunks):
            chunk = self.chunks[self.at]
            self.at += 1
            handler = getattr(self, f"_on_{chunk.kind}", None)
            if handler is not None:
                handler(chunk)
            elif chunk.kind == "other":
                self.said.missed.append(chunk)
            elif chunk.kind in ("room", "body", "people", "measure", "style", "function", "corner"):
                self._fact(chunk)
        return self.said

    def _fact(self, chunk: Chunk) -> None:
        self.said.facts.append(chunk)
        if chunk.kind == "people" and self.group and chunk.number and self._previous(chunk) == "for":
            self.group[-1].thing.people = chunk.number
        self.broken = True

    def _previous(self, chunk: Chunk) -> str:
        """Return the value of the chunk before this one."""
        index = self.chunks.index(chunk)
        return self.chunks[index - 1].value if index else ""

    def _on_stop(self, chunk: Chunk) -> None:
        self.before = self.subject or self.group or self.before
        self._new_sentence()

    def _on_colon(self, chunk: Chunk) -> None:
        self.broken = True

    def _on_comma(self, chunk: Chunk) -> None:
        self.refusing = False
        self.verb = self.relative = False
        self.broken = True
        self.having = self.having and not self.acted

    def _on_and(self, chunk: Chunk) -> None:
        self.refusing = self.refusing and chunk.value in ("or", "nor")
        self.verb = self.relative = False
        self.broken = True
        self.having = self.having and not self.acted

    def _on_verb(self, chunk: Chunk) -> None:
        self.verb = True

    def _on_not(self, chunk: Chunk) -> None:
        self.refusing = True

    def _on_filler(self, chunk: Chunk) -> None:
        if chunk.value in ("that", "which"):
            self.relative = True
        following = self.chunks[self.at] if self.at < len(self.chunks) else chunk
        if chunk.value == "for" and following.kind == "filler" and count_of(following.value) > 1:
            if self.group:
                self.group[-1].thing.people = count_of(following.value)
            else:
                self.said.people = count_of(following.value)

    def _on_with(self, chunk: Chunk) -> None:
        self.refusing = False
        if self.acted and not self.broken:
            self.holder = self.acted
        elif self.group:
            self.holder = [self.group[-1]]
        self.having = True
        self.verb = False
        self.broken = True

    def _on_each(self, chunk: Chunk) -> None:
        """After a thing it multiplies ("four chairs each"); before "with" it says that each one has them."""
        if self.at < len(self.chunks) and self.chunks[self.at].kind == "with":
            self.at += 1
            holder = self.group[-1:] or self.subject[-1:]
            self.holder = holder
            self._each_has(holder)
        elif self.group and self.holder and self.group[-1].thing is not self.holder[0].thing:
            self.group[-1].thing.times = self.holder[0].thing.count

    def _each_has(self, holder: list[Mention]) -> None:
        """Read what each of some things has, up to the end of the clause."""
        if not holder:
            return
        first = len(self.said.things)
        while self.at < len(self.chunks) and self.chunks[self.at].kind in ("thing", "and", "comma", "filler", "style"):
            chunk = self.chunks[self.at]
            following = self.chunks[self.at + 1 : self.at + 2]
            if chunk.kind == "comma" and first < len(self.said.things):
                break
            if chunk.kind == "and" and following and following[0].kind != "thing":
                break
            self.at += 1
            if chunk.kind == "thing":
                mention = self._mention(chunk)
                if mention.thing in self.said.things[first:]:
                    mention.thing.times = holder[0].thing.count
                    self.group = [mention]
                    self.said.links.append(Link("with", (mention,), tuple(holder), chunk.start, chunk.end))

    def _on_pron(self, chunk: Chunk) -> None:
        if chunk.value in ("that", "which"):
            self.relative = True
            return
        if chunk.value in ("each", "each of them", "all of them", "both"):
            following = self.chunks[self.at].kind if self.at < len(self.chunks) else "stop"
            if chunk.value.startswith("each") and following == "with":
                self._on_each(chunk)
                return
            if chunk.value == "each" and self.group and self.holder:
                self._on_each(chunk)
                return
        if self.before and not self.group:
            self.subject = list(self.before)
            self.group = list(self.before)

    def _on_thing(self, chunk: Chunk) -> None:
        if self.refusing or chunk.refused:
            if chunk.noun is not None:
                self.said.refused.append((chunk.noun, (chunk.start, chunk.end)))
            return
        if chunk.noun is not None and chunk.noun.kind in AIDS and self._previous(chunk) in ("use", "uses", "using"):
            self._fact(Chunk("body", chunk.start, chunk.end, AIDS[chunk.noun.kind]))
            return
        mention = self._mention(chunk)
        self.recent.append(mention)
        for word in set(SAID_OF) & set(chunk.adjectives):
            self.said.links.append(Link(SAID_OF[word], (mention,), (), chunk.start, chunk.end))
        if chunk.det == "each" and self.group and self._previous(chunk) == "for":
            self.group[-1].thing.times = mention.thing.count
            self._link(Chunk("rel", chunk.start, chunk.end, "with"), self.group[-1:], [mention])
            return
        if self.fronted is not None:
            self._link(self.fronted[0], [mention], self.fronted[1])
            self.group = [*self.group, mention] if self.group and not self.broken else [mention]
            self.acted = [mention]
            self.broken = False
            return
        if self.verb and not self.group and not self.subject:
            self.subject = []
        joined = self._joined()
        if self.having and self.holder and topped(mention) and not topped(self.holder[0]):
            self.said.links.append(Link("with", (mention,), tuple(self.holder), chunk.start, chunk.end))
        self.group = [*self.group, mention] if joined else [mention]
        if not self.subject or (not joined and not self.verb and not self.holder):
            self.subject = self.group
        self.acted = []
        self.verb = self.relative = self.broken = False

    def _on_part(self, chunk: Chunk) -> None:
        """A place of the room that no relation leads to: doors and windows that are asked for."""
        if chunk.value in ("window", "door") and (self.holder or chunk.number or chunk.det == "a"):
            place = place_of(chunk)
            walls = self._opening_walls()
            self.said.openings.append(
                (Place(place.name, walls, chunk.number, chunk.plural, chunk.det), (chunk.start, chunk.end))
            )
        elif chunk.value in ("window", "door"):
            walls = self._opening_walls()
            if walls:
                self.said.openings.append(
                    (Place(chunk.value, walls, chunk.number, chunk.plural, chunk.det), (chunk.start, chunk.end))
                )
        self.broken = True

    def _opening_walls(self) -> tuple[str, ...]:
        """Return the words of a wall that follows: "in the south wall"."""
        index = self.at
        while index < len(self.chunks) and self.chunks[index].kind in ("verb", "filler"):
            index += 1
        if index + 1 < len(self.chunks) and self.chunks[index].kind == "rel" and self.chunks[index + 1].value == "wall":
            self.at = index + 2
            return self.chunks[index + 1].adjectives
        return ()

    def _of_the_room(self, chunk: Chunk) -> bool:
        """Note what is asked of the room itself: an open middle, a way to something, daylight at it."""
        if chunk.value not in ("open", "way", "light"):
            return False
        found: list[Mention | Place] = []
        while chunk.value != "open" and self.at < len(self.chunks):
            following = self.chunks[self.at]
            after = self.chunks[self.at + 1 : self.at + 2]
            joins = following.kind == "and" and found and after and (after[0].kind == "part" or after[0].det == "the")
            if following.kind == "filler" or joins:
                self.at += 1
            elif (item := self._object(chunk)) is not None:
                found.append(item)
            else:
                break
        things = tuple(item for item in found if isinstance(item, Mention)) if chunk.value == "light" else ()
        named = {"light": "lit"}.get(chunk.value, chunk.value)
        self.said.links.append(Link(named, things, () if things else tuple(found), chunk.start, chunk.end))
        self.broken = True
        return True

    def _on_rel(self, chunk: Chunk) -> None:
        """A relation: find what it is about, then what it leads to."""
        if self._of_the_room(chunk):
            return
        if self._of_people():
            self._objects(chunk)
            self.said.missed.append(chunk)
            return
        subjects = self._subjects(chunk.value)
        if chunk.value == "holds" and not subjects:
            self._on_with(chunk)
            return
        first = self.at
        objects = self._objects(chunk)
        if (
            objects
            and isinstance(objects[0], Place)
            and objects[0].name == "side"
            and self._at_sides(chunk, subjects, objects[0])
        ):
            return
        if not objects and chunk.value not in ALONE:
            if chunk.value not in ("in", "by"):
                self.said.missed.append(chunk)
            return
        if objects and self._is_room(chunk, objects):
            self.broken = True
            return
        if chunk.value in REVERSED:
            self._reversed(chunk, subjects, objects)
            return
        if not subjects or self._turned_round(first, objects):
            self.fronted = (chunk, objects)
            self.group = []
            return
        self._link(chunk, subjects, objects)
        self.acted = subjects
        self.verb = False

    def _of_people(self) -> bool:
        """Return whether this clause is about somebody: "guests are received near the door" moves no furniture."""
        before = self.chunks[: self.at - 1]
        ends = [i for i, chunk in enumerate(before) if chunk.kind in ("comma", "and", "stop", "colon")]
        clause = [chunk for chunk in before[ends[-1] + 1 if ends else 0 :] if chunk.kind != "filler"]
        if len(clause) < 2 or any(chunk.kind in ("thing", "pron") for chunk in clause):
            return False
        who, does = clause[0], clause[1].kind in ("verb", "other")
        unknown = who.kind == "other" and who.value.endswith("s") and not who.value.endswith("ss")
        return does and (unknown or who.kind in ("function", "people", "body"))

    def _at_sides(self, chunk: Chunk, subjects: Sequence[Mention], side: Place) -> bool:
        """Seats on the sides or at the ends of a table stand around it; other things at a side are on top of it or beside it."""
        tables = [thing for thing in self.said.things if thing.noun.kind.split()[-1] in ("table", "counter", "island")]
        seats = [
            m for m in subjects if m.thing.noun.kind.split()[-1] in ("chair", "stool", "bench", "cushion", "armchair")
        ]
        if not tables or not seats or len(seats) < len(subjects):
            return False
        known = any(
            link.relation == "around" and link.subjects[0].thing is seats[0].thing
            for link in self.said.links
            if link.subjects
        )
        if not known:
            self._link(Chunk("rel", chunk.start, chunk.end, "around"), seats, [Mention(tables[-1])])
        return True

    def _is_room(self, chunk: Chunk, objects: Sequence[Mention | Place]) -> bool:
        """Return whether a relation only says that a thing is in the room."""
        place = objects[0]
        return isinstance(place, Place) and (
            place.name in ("room", "floor") and chunk.value in ("in", "on", "by", "around")
        )

    def _turned_round(self, first: int, objects: Sequence[Mention | Place]) -> bool:
        """Return whether what follows the object is what the relation is about: "and on it stands a lamp"."""
        if not objects or self.at >= len(self.chunks):
            return False
        index, verb = self.at, False
        while index < len(self.chunks) and self.chunks[index].kind in ("verb", "filler", "style", "pron"):
            verb = verb or self.chunks[index].kind == "verb"
            index += 1
        if index >= len(self.chunks) or self.chunks[index].kind != "thing":
            return False
        starts = self.chunks[first - 2].kind in ("and", "comma", "stop", "colon") if first >= 2 else True
        return starts and (verb or index == self.at) and self.chunks[index].det != "the"

    def _reversed(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Mention | Place]) -> None:
        """Link what is said from the other side: "flanked by two lamps"."""
        moved = [item for item in objects if isinstance(item, Mention)]
        while chunk.value == "holds" and self._another():
            following = self.chunks[self.at + 1]
            self.at += 2
            moved.append(self._mention(following))
        if moved and subjects:
            named = Chunk("rel", chunk.start, chunk.end, REVERSED[chunk.value])
            for mention in moved:
                if chunk.value == "holds" and len(subjects) == 1 and subjects[0].det == "each":
                    mention.thing.times = subjects[0].thing.count
            self._link(named, moved, list(subjects))
            self.group, self.acted = moved, moved

    def _another(self) -> bool:
        kinds = [chunk.kind for chunk in self.chunks[self.at : self.at + 2]]
        return kinds == ["and", "thing"]

    def _nearest(self, relation: str) -> list[Mention]:
        """Return what a relation right after a noun is about: small things "on" something all together, else the noun."""
        if self.target is not None and relation in ("by", "next", "near") and self.acted:
            return [self.target]
        last = self.group[-1:] or list(self.subject)
        if relation == "on" and last and topped(last[0]) and len(self.group) > 1:
            linked = {m for link in self.said.links if link.relation != "with" for m in link.subjects}
            return [m for m in self.group if topped(m) and m not in linked]
        return last

    def _subjects(self, relation: str) -> list[Mention]:
        """Return what a relation here is about."""
        previous = next((c for c in reversed(self.chunks[: self.at - 1]) if c.kind not in ("filler", "style")), None)
        if previous is None or previous.kind == "stop":
            return []
        if self.fronted is not None and previous.kind in ("and", "comma"):
            self.fronted = None
            return []
        if previous.kind == "verb" or self.verb:
            return self.group[-1:] if self.relative else list(self.subject or self.group)
        if previous.kind == "thing":
            return self._nearest(relation)
        if previous.kind == "pron" and not self.relative:
            return list(self.before or self.subject) if not self.group else list(self.group)
        if self.relative:
            return self.group[-1:]
        return list(self.acted or self.group[-1:] or self.subject)

    def _objects(self, chunk: Chunk) -> list[Mention | Place]:
        """Return what a relation leads to; "between" takes two, and a wall may be told by what it is opposite to."""
        found: list[Mention | Place] = []
        self.target = None
        while self.at < len(self.chunks):
            self._skip()
            item = self._object(chunk)
            if item is None:
                break
            found += [item, *self.pending]
            self.pending = []
            pronoun = self.chunks[self.at - 1].kind == "pron"
            wants = chunk.value == "amid" and len(found) < 2 and not several(item) and not pronoun
            both = chunk.value in ("amid", "facing", "under", "around", "near", "next", "on")
            if not (wants or (both and self._plain_pair(found))):
                break
            self.at += 1
        if found and isinstance(found[-1], Place) and found[-1].name == "wall":
            found[-1] = self._which_wall(found[-1])
        self.target = found[-1] if found and isinstance(found[-1], Mention) else None
        return found

    def _plain_pair(self, found: Sequence[Mention | Place]) -> bool:
        """Return whether "and the ..." goes on with the same relation."""
        following = self.chunks[self.at : self.at + 3]
        if (
            len(following) < 2
            or following[0].kind != "and"
            or following[1].kind != "thing"
            or following[1].det != "the"
        ):
            return False
        third = following[2].kind if len(following) > 2 else "stop"
        return third in ("stop", "comma", "with") and isinstance(found[-1], Mention)

    def _skip(self) -> None:
        while self.at < len(self.chunks) and self.chunks[self.at].kind in ("filler", "style"):
            self.at += 1

    def _link(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Mention | Place]) -> None:
        """Note a relation; what stands at each of several things is as many times there."""
        for item in objects:
            several = item.det == "each"
            if several and len(subjects) == 1 and subjects[0].thing.times == 1:
                count = item.thing.count if isinstance(item, Mention) else {"corner": 4}.get(item.name, 1)
                owned = isinstance(item, Mention) and item.thing is subjects[0].thing
                subjects[0].thing.times = 1 if owned or self._given(subjects[0]) else count
        if chunk.value == "flank" and len(subjects) == 1 and not self._given(subjects[0]):
            thing = subjects[0].thing
            if thing.number == 1 and thing.times == 1:
                around = objects[0] if objects else None
                thing.times = 2 * (
                    around.thing.count if isinstance(around, Mention) and around.det in ("each", "all") else 1
                )
        objects = objects or (
            self.holder if chunk.value in ("flank", "left", "right", "front", "near", "under") else []
        )
        self.said.links.append(Link(chunk.value, tuple(subjects), tuple(objects), chunk.start, chunk.end))
