"""What words refer to: a thing named before, "it", "the other one", a wall that something else tells."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from robolayout.words._chunk import Chunk
from robolayout.words._function_words import ORDINALS, PEOPLE
from robolayout.words._lexicon import grammar
from robolayout.words._said import Link, Mention, Parsed, Place, Thing, place_of, same, same_words, several, topped
from robolayout.words._ways import OTHER_SIDE

AXES = {"left": "across", "right": "across", "front": "along", "behind": "along", "foot": "along"}
"""Lines through a thing by the relations that say on which side of it another one stands."""

CLOSE = frozenset(("next", "near", "by", "in", "on", "ontop", ""))
"""Relations by which things follow each other, so that "it" is the last one."""


MOST = frozenset(["nearest", "closest", "farthest", "furthest", "opposite"])
"""Words that tell one corner from the others by a door or window."""

EVERY = (
    "each",
    "each one",
    "each of them",
    "each one of them",
    "all of them",
    "both",
    "both of them",
    "each of which",
    "both of which",
    "all of which",
)
"""Words for every one of several things."""

SEVERAL = ("them", "they", "both", "both of them", "all of them", "the two", "these", "those")
"""Words for several things that were named."""


class References:
    """What was named so far in a text, and in its last sentence.

    Args:
        chunks: The chunks of the text.
        given: Things that are there already.
    """

    def __init__(self, chunks: Sequence[Chunk], given: Sequence[Thing] = ()) -> None:
        self.chunks = list(chunks)
        self.said = Parsed()
        self.given = list(given)
        self.at = 0
        self.before: list[Mention] = []
        self.pending: list[Mention] = []
        self.dealt: dict[Thing, int] = {}
        self.about: list[Mention] = []  # what the relation that is being read is about
        self.kept: list[Mention] = []  # what the last "it" stood for, or the head of the sentence led to
        self.contrast: tuple[str, list[Mention]] = ("", [])  # the other side than the last one, and of what
        self.axis = ""  # along which line of it, where no "it" was said
        self.other: list[Mention] = []  # what was said since, by a noun
        self._new_sentence()

    def _new_sentence(self) -> None:
        self.began = self.chunks[self.at - 1].start if self.at else 0
        self.group: list[Mention] = []
        self.subject: list[Mention] = []
        self.acted: list[Mention] = []
        self.holder: list[Mention] = []
        self.fronted: tuple[Chunk, list[Mention | Place]] | None = None
        self.also: tuple[Chunk, list[Mention | Place]] | None = None  # "in the corner nearest the window stands a lamp"
        self.refusing = self.negated = False
        self.verb = False
        self.relative = False
        self.broken = self.having = self.listed = False
        self.recent: list[Mention] = []
        self.targets: list[Mention] = []
        self.target: Mention | None = None
        self.every: tuple[list[Mention], int] | None = None  # what each has that is spoken of, and how many there are

    def _new_zone(self) -> None:
        """Forget what was spoken of: what a part of the room has belongs to no thing before it."""
        self.group, self.subject, self.acted, self.holder = [], [], [], []
        self.having = False

    def _understood(self, *chunks: Chunk) -> None:
        """Note chunks that are understood with what stands before them."""
        self.said.read.update(token for chunk in chunks for token in range(chunk.start, chunk.end))

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
            wants = chunk.value in ("amid", "between") and len(found) < 2 and not several(item) and not pronoun
            both = chunk.value in ("amid", "facing", "under", "around", "near", "next", "on")
            if not (wants or (both and self._plain_pair(found, chunk))):
                break
            self.at += 1
        if found and isinstance(found[-1], Place) and found[-1].name in ("wall", "corner"):
            found[-1] = self._which_wall(found[-1])
        self.target = found[-1] if found and isinstance(found[-1], Mention) else None
        return found

    def _plain_pair(self, found: Sequence[Mention | Place], chunk: Chunk) -> bool:
        """Return whether "and the ..." goes on with the same relation."""
        following = self.chunks[self.at : self.at + 3]
        kinds = [chunk.kind for chunk in following]
        if kinds[:1] != ["and"] or kinds[1:2] not in (["thing"], ["part"]):
            return False
        other = following[1]
        if other.det != "the" and (
            other.det or other.plural or other.number is not None
        ):  # "the sofa and coffee table"
            return False
        third = following[2].kind if len(following) > 2 else "stop"
        ends = ("stop", "comma", "with", *(["verb"] if chunk.value == "amid" and len(found) < 2 else []))
        return third in ends and isinstance(found[-1], Mention)

    def _previous(self, chunk: Chunk) -> str:
        """Return the value of the chunk before this one."""
        index = self.chunks.index(chunk)
        return self.chunks[index - 1].value if index else ""

    def _skip(self) -> None:
        while self.at < len(self.chunks) and self.chunks[self.at].kind in ("filler", "style"):
            self.at += 1

    def _object(self, chunk: Chunk) -> Mention | Place | None:
        """Return the thing or place at the head of what follows, and go past it."""
        if self.at >= len(self.chunks):
            return None
        following = self.chunks[self.at]
        if following.kind == "thing":
            self.at += 1
            mention = self._mention(following, target=True)
            self.targets.append(mention)
            return mention
        if following.kind == "part":
            self.at += 1
            return self._place_of(following)
        if following.kind in ("room", "function", "people"):
            self.at += 1
            if chunk.value in ("opposite", "facing", "near", "next") and self._of_a_thing(following):
                return self._object(chunk)
            self._understood(following)
            if following.kind != "people":
                self.said.facts.append(following)
            return Place("room")
        return self._pronoun(following, chunk) if following.kind == "pron" else None

    def _pronoun(self, word: Chunk, chunk: Chunk) -> Mention | None:
        """Return what a pronoun after a relation stands for; "which" only where a verb follows ("on which sits a lamp")."""
        which = word.value == "which" and [c.kind for c in self.chunks[self.at + 1 : self.at + 2]] in (
            ["verb"],
            ["thing"],
        )
        if word.value in ("that", "which", "both") and not which:
            return None
        self.at += 1
        meant = (self.acted or self.group)[-1:] if which else self._meant(word.value, chunk.value)
        if word.value in SEVERAL:
            meant = [Mention(mention.thing, mention.pick) for mention in meant]
        self.pending = meant[1:]
        if word.value.startswith("each") and meant:
            return Mention(meant[0].thing, None, "each")
        return meant[0] if meant else None

    def _of_a_thing(self, part: Chunk) -> bool:
        """Return whether a part is one of a thing that follows, and go there: "opposite the foot of the bed"."""
        of = [(c.kind, c.value) for c in self.chunks[self.at : self.at + 2]]
        if part.kind != "function" or of[:1] != [("filler", "of")] or of[1:] == [] or of[1][0] not in ("thing", "pron"):
            return False
        self._understood(part)
        self.at += 1
        return True

    def _place_of(self, chunk: Chunk) -> Mention | Place:
        """Return a place of the room, or the thing whose side it is ("the foot of the bed")."""
        following = self.chunks[self.at : self.at + 2]
        self._understood(chunk)
        if chunk.value in ("window", "door") and chunk.number:  # "a desk under two windows"
            told = any((place.name, place.number) == (chunk.value, chunk.number) for place, _ in self.said.openings)
            if chunk.number > 1 and not told:
                self.said.openings.append((place_of(chunk), (chunk.start, chunk.end)))
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
        return place_of(chunk)

    def _which_wall(self, wall: Place) -> Place:
        """Return a wall or corner with the door or window that tells it from the others."""
        following = self.chunks[self.at : self.at + 2]
        if "same" in wall.words and [c.value for c in following] in (["as", "door"], ["as", "window"]):
            following[0] = replace(following[0], kind="with")
        if len(following) < 2 or following[1].kind != "part":
            return wall
        how = following[0].value if following[0].kind == "rel" else following[0].kind
        corner = wall.name == "corner" and following[1].value in ("door", "window")
        most = corner and following[0].kind == "rel" and bool(MOST & {*following[0].adjectives})  # "nearest the window"
        if most != corner or how not in (
            "opposite",
            *(("near", "far") if corner else ("facing", "behind", "by", "with")),
        ):
            return wall
        self.at += 2
        self._understood(*following)
        return replace(wall, by=(how, place_of(following[1])))

    def _meant(self, word: str, relation: str = "") -> list[Mention]:
        """Return what a pronoun stands for.

        That is what stands before "with"; what the last "it" stood for ("a lamp behind it, a table to the left of it"); what was
        named last before; what the last relation led to, where that is one and the other is several; the subject before.
        """
        own = {m.thing for m in self.about}
        holder = self.holder[0] if self.holder else None
        earlier, to = ([m for m in given if m.thing not in own] for given in (self.recent, self.targets))
        many = holder is not None and holder.thing.count > 1 and holder.det != "each"
        one = not many if word == "it" else many or word not in SEVERAL or len(earlier) < 2
        if holder is not None and holder.thing not in own and one:
            return self.holder
        if word in SEVERAL:
            return self._several_meant(earlier, to)
        if word == "it" and relation == self.contrast[0] and self.contrast[1] and self.contrast[1][0].thing not in own:
            return self.contrast[1]  # "a lamp to the left of the sofa; to the right of it a plant"
        kept = self.kept if self._keeps(relation) and {m.thing for m in self.other} <= own else []
        if kept and kept[0].thing not in own:
            return kept
        single, led = ([m for m in given if m.thing.count == 1] for given in (earlier, to))
        if word == "it" and earlier and earlier[-1].thing.count > 1:
            earlier = led or single or earlier
        return earlier[-1:] or to[-1:] or self.before[:1] or self.group[:1]

    def _several_meant(self, earlier: list[Mention], to: list[Mention]) -> list[Mention]:
        """Return what "them" stands for: several things named at once, or the last two."""
        own = {m.thing for m in self.about}
        on = {
            m.thing
            for k in self.said.links
            for m in k.subjects
            for o in k.objects
            if isinstance(o, Mention) and o.thing in own
        }
        earlier = [m for m in earlier if m.thing not in on or not topped(m)]
        several = [m for m in earlier if m.thing.count > 1]
        if several and earlier[-1:] == several[-1:]:
            return several[-1:]
        if len(earlier) == 1:  # "a sofa facing the TV and a table between them"
            earlier += [m for m in to[-1:] if m.thing is not earlier[0].thing]
        before = self.before
        if len(before) == 1 and before[0].thing.count == 1:
            two = ([*k.subjects, *k.objects] for k in reversed(self.said.links) if k.relation != "on" and k.objects)
            standing = ([m for m in both if isinstance(m, Mention) and not topped(m)] for both in two)
            before = next((both for both in standing if len(both) > 1), before)
        return earlier[-2:] or before

    def _keeps(self, relation: str) -> bool:
        """Return whether "it" still means here what it meant before."""
        return bool(self.axis and self.axis == AXES.get(relation)) or (not self.axis and relation not in CLOSE)

    def _keep(self, relation: str, objects: Sequence[Mention | Place], *, pronoun: bool, fronted: bool) -> None:
        """Note what a relation led to, so that a later "it" can mean the same."""
        things = [item for item in objects if isinstance(item, Mention) and item.thing.count == 1]
        if not pronoun:
            self.contrast = (OTHER_SIDE[relation], things[:1]) if relation in ("left", "right") else ("", [])
        if things and (pronoun or (fronted and relation in AXES)):
            self.kept, self.axis, self.other = things[:1], "" if pronoun else AXES[relation], []
        elif not pronoun:
            led = any(isinstance(item, Mention) for item in objects)
            self.kept, self.other = [] if fronted or led else self.kept, list(self.about)

    def _mention(self, chunk: Chunk, *, target: bool = False) -> Mention:
        """Return the thing that a noun phrase names: one named before, or a new one."""
        assert chunk.noun is not None
        known = self._known(chunk, target=target)
        if known is not None:
            sides = [{"left", "right"} & {*words} for words in (known.adjectives, chunk.adjectives)]
            if known.count == 1 and all(sides) and sides[0] != sides[1]:
                known.number = 2  # "on the left nightstand ... on the right nightstand"
            known.spans.append((chunk.start, chunk.end))
            return Mention(known, self._pick(chunk, known.count, self.dealt.get(known), target=target), chunk.det)
        number = 1 if chunk.number is None and chunk.det in ("a", "new", "one") and not chunk.plural else chunk.number
        if chunk.det == "both" and number is None:
            number = 2
        leads = [other.kind for other in self.chunks[self.at : self.at + 1]] == ["rel"]
        if number is None and chunk.plural and self._joined() and not target and not leads:
            before = self.group[-1].thing.number
            number = before if before and before > 1 else None
        definite = chunk.det in ("the", "each", "all")
        made = Thing(chunk.noun, number, chunk.bound, chunk.plural, chunk.adjectives, [(chunk.start, chunk.end)])
        made.rows, made.definite = chunk.rows, definite
        made.sizes += chunk.sizes
        self.said.things.append(made)
        first = {"left", "right"} & {*chunk.adjectives} and made.count == 1
        return Mention(made, slice(0, 1) if first else None, chunk.det)

    def _pick(self, chunk: Chunk, count: int, dealt: int | None, *, target: bool) -> slice | None:
        """Return which of several things a noun phrase means, None for all of them."""
        first, many = dealt or 0, chunk.number or 1
        if count == 1:
            return None
        if chunk.det in ("other", "new"):
            first = (count - many if chunk.number else 1) if dealt is None else dealt
            return slice(first, count if chunk.plural else first + 1)
        if chunk.det == "one" or (chunk.number == 1 and not chunk.det and not target):
            return slice(first, first + many) if first + many <= count else slice(0, many)
        places = {
            "left": 0,
            "first": 0,
            "second": 1,
            "third": 2,
            "middle": count // 2,
            "right": count - 1,
            "last": count - 1,
        }
        told = [places[word] for word in (chunk.det, *chunk.adjectives) if word in places]
        told += [0] if chunk.number == 1 and not chunk.plural and target else []
        return slice(told[0], told[0] + 1) if told else None

    def _known(self, chunk: Chunk, *, target: bool) -> Thing | None:
        """Return the thing named before that a noun phrase means; the one named last where several fit."""
        fits = [t for t in [*self.given, *self.said.things] if same(t, chunk)]
        fits = [t for t in fits if same_words(t, chunk)] or fits
        if not fits or (chunk.det in ORDINALS and fits[-1].count <= ORDINALS.index(chunk.det) % 3):
            return None
        said = {
            word.removesuffix("s") for word in (*chunk.adjectives, *(chunk.noun.said.split() if chunk.noun else ()))
        }
        if fits[-1].count > 1 and not chunk.plural and said & PEOPLE and not same_words(fits[-1], chunk):
            return None  # "the teacher's desk"
        one = target and chunk.number == 1 and chunk.det == ""
        new = (chunk.det == "new" and not any(0 < self.dealt.get(thing, 0) < thing.count for thing in fits[-1:])) or (
            chunk.number is not None and not one and chunk.det not in ("the", "all", "both", "one", "each", "other")
        )
        told = chunk.number is not None and not one and fits[-1].definite and fits[-1].number is None
        if told and fits[-1].plural and same_words(fits[-1], chunk):
            fits[-1].number = chunk.number  # "facing the mirrors, three mirrors on the wall"
            return fits[-1]
        says = [other.kind for other in self.chunks[self.at : self.at + 1]] == ["verb"]
        earlier = fits[-1] not in [mention.thing for mention in self.recent]
        if (fits[-1] in self.given and chunk.det != "new") or (
            chunk.number == 1 and not chunk.det and says and earlier
        ):
            return fits[-1]  # "three lamps. One lamp should be next to the sofa"
        if one and fits[-1].count > 1:
            return fits[-1]
        bare = not chunk.det and chunk.number is None
        if bare and not chunk.plural and not target:
            follows = [other.kind for other in self.chunks[self.at : self.at + 1]] == ["rel"]
            again = follows or self._previous(chunk) == "from"  # "1 bed, 1 desk: desk near bed", "watch it from bed"
            return fits[-1] if again and same_words(fits[-1], chunk) else None
        if chunk.det == "a" and not target and fits[-1].definite and same_words(fits[-1], chunk):
            fits[-1].definite = False
            return fits[-1]
        if chunk.det == "a" and not (target and same_words(fits[-1], chunk)):
            return None
        return None if new else fits[-1]

    def _joined(self) -> bool:
        """Return whether the last chunk only joins this thing to those before it."""
        index = self.at - 2
        seen = False
        while index >= 0 and self.chunks[index].kind in ("and", "comma", "filler", "style"):
            seen = seen or self.chunks[index].kind in ("and", "comma")
            index -= 1
        return seen and index >= 0 and self.chunks[index].kind == "thing" and bool(self.group) and not self.acted

    def _given(self, mention: Mention) -> bool:
        return mention.thing in self.given

    def _number_of(self, item: Mention | Place) -> int:
        """Return how many there are of a thing, of corners or walls, of doors or windows that are asked for."""
        if isinstance(item, Mention):
            return item.thing.count
        asked = sum(place.number or 0 for place, _ in self.said.openings if place.name == item.name)
        sides = len({*item.words} & {*grammar().walls})  # "in each of the back corners"
        corners = 4 if not sides or item.name == "wall" else 2 // sides
        return item.number or (corners if item.name in ("corner", "wall") else asked or 1)

    def _on_both_sides(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Mention | Place]) -> Chunk:
        """Count what stands at each side of something; return the relation, which is "around" for several seats."""
        thing = subjects[0].thing
        if len(subjects) == 1 and subjects[0].per_side(chunk) and thing not in (*self.given, *self.dealt):
            thing.number = 2 * (thing.number or 1)
            around = [to for to in objects[:1] if isinstance(to, Mention) and to.det in ("each", "all")]
            thing.times = around[0].thing.count if around else 1
        several = all(mention.at_a_table and (mention.thing.number or 0) > 2 for mention in subjects)
        return replace(chunk, value="around") if several else chunk

    def _link(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Mention | Place]) -> None:
        """Note a relation; what stands at each of several things is as many times there."""
        led = objects or (
            self.holder or (self._meant("it") if chunk.value == "oneside" else [])
            if chunk.value in ("next", "oneside", "flank", "left", "right", "front", "near", "under", "above", "behind")
            else []
        )
        if (chunk.value in ("above", "behind") and not led) or any(
            a.thing is b.thing and a.pick in (None, b.pick) for a in subjects for b in led if isinstance(b, Mention)
        ):
            self.said.missed.append(chunk)  # nothing stands at itself, or behind nothing
            return
        each = [item for item in objects if item.det == "each" and chunk.value not in ("apart", "far")]
        for item in each:
            count = self._number_of(item)
            subjects = [mention.widened(count) for mention in subjects]
            for mention in subjects:
                owned = isinstance(item, Mention) and item.thing is mention.thing
                dealt = mention.thing in self.dealt or mention.pick is not None  # "two lamps, one in each corner"
                if mention.thing.times == 1 and not owned and not dealt and not self._given(mention):
                    mention.thing.times = count * (2 if chunk.value == "flank" and mention.thing.number == 1 else 1)
        if chunk.value == "flank":
            chunk = self._on_both_sides(chunk, subjects, objects)
        objects = led
        if objects:  # "a bed with a lamp on either side": the lamps are not on the bed
            own, to = {m.thing for m in subjects}, {m.thing for m in objects if isinstance(m, Mention)}
            elsewhere = chunk.value in ("on", "flank")
            self.said.links[:] = [k for k in self.said.links if not k.had(own, None if elsewhere else to)]
        low, high = chunk.measure.values if chunk.measure else (0.0, 0.0)
        about = (tuple(subjects), tuple(objects))
        walls = any(isinstance(item, Place) and item.name == "wall" and item.plural for item in objects)
        for row in [k for k in self.said.links if walls and k.relation == "row" and k.subjects == about[0]]:
            self.said.links.remove(row)  # "lined up along two opposite walls": no one line
            self.said.read.update(range(row.start, row.end))
        self.said.links.append(Link(chunk.value, *about, chunk.start, chunk.end, (low, high), chunk.rows))
