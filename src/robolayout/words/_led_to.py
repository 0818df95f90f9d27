"""What a relation leads to where other words tell it: the other side, each its own, the wall of another thing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

from robolayout.words import _function_words as small
from robolayout.words._chunk import Chunk
from robolayout.words._references import References
from robolayout.words._said import Mention, Place, laid, mentions, named, place_of, several
from robolayout.words._ways import OTHER_SIDE

CORNERS, WALLS = ("near", "far"), ("facing", "behind", "by", "with")
"""Relations by which a door or window tells a corner or a wall from the others."""


class LedTo(References):
    """Reads what relations lead to."""

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
            two = chunk.value in ("amid", "between", "separates") and len(found) < 2
            plural = several(item) or (isinstance(item, Place) and item.plural)
            wants = two and (self._ahead().value == "from" or not (plural or pronoun))
            both = chunk.value in ("amid", "facing", "under", "around", "near", "next", "on", "seen")
            both = both or (isinstance(item, Mention) and item.det == "both")
            if not (wants or (both and self._plain_pair(found, chunk))):
                break
            self.at = min(self.at + 1, len(self.chunks))
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

    def _object(self, chunk: Chunk) -> Mention | Place | None:
        """Return the thing or place at the head of what follows, and go past it."""
        following = self._ahead()
        if following.kind == "thing":
            self.at += 1
            members = self._members(following)
            self._understood(*[following] * bool(members))
            mention, *self.pending = members or [self._mention(following, target=True)]
            self.targets += [mention, *self.pending]
            return mention
        if following.kind == "part":
            self.at += 1
            return self._place_of(following)
        clause = following.kind == "people" and self._ahead(-1).kind == "filler"  # "in front, so that people see it"
        if following.kind in ("room", "function", "people") and not clause:
            self.at += 1
            ends = following.value.endswith(("head", "foot")) or chunk.value in ("opposite", "facing", "near", "next")
            if ends and self._of_a_thing(following):
                return self._object(chunk)
            self._understood(following)
            if following.kind != "people":
                self.said.facts.append(following)
            return Place("room")
        return self._pronoun(following, chunk) if following.kind == "pron" else None

    def _pronoun(self, word: Chunk, chunk: Chunk) -> Mention | None:
        """Return what a pronoun after a relation stands for; "which" only where a verb follows ("on which sits a lamp")."""
        following = self._ahead(1).kind
        which = word.value == "which" and following in ("verb", "thing")
        that = word.value == "that" and following in ("comma", "stop", "verb", "")
        if word.value in ("that", "which", "both") and not which and not that:
            return None
        self.at += 1
        own, meant = named(self.about), (self.acted or self.group)[-1:]
        if not which:
            others = [m for m in self.recent or self.before if m.thing not in own][-1:]
            meant = others if that else self._standing(self._meant(word.value, chunk.value), chunk)
        if word.value in small.SEVERAL:
            meant = [Mention(mention.thing, mention.pick) for mention in meant]
        self.pending = meant[1:]
        if word.value.startswith(("each", "every")) and meant:
            return Mention(meant[0].thing, None, "each")
        return meant[0] if meant else None

    def _standing(self, meant: list[Mention], chunk: Chunk) -> list[Mention]:
        """Return what bears a small thing where furniture is said to stand beside it: "a globe is on the desk and a bin beside it"."""
        stands = chunk.value == "behind" or not any("object" in mention.thing.places for mention in self.about)
        if len(meant) != 1 or not (laid(meant[0]) and stands and chunk.value in small.STANDING):
            return meant
        on = [k.objects for k in self.said.links if k.relation == "on" and meant[0].thing in named(k.subjects)]
        return mentions(on[-1]) or meant if on else meant

    def _of_a_thing(self, part: Chunk) -> bool:
        """Return whether a part is one of a thing that follows, and go there: "opposite the foot of the bed"."""
        if part.kind != "function" or self._ahead().value != "of" or self._ahead(1).kind not in ("thing", "pron"):
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
        most = corner and bool(small.MOST & {*following[0].adjectives})  # "nearest the window"
        if most != corner or how not in ("opposite", *(CORNERS if corner else WALLS)):
            return wall
        self.at += 2
        self._understood(*following)
        return replace(wall, by=(how, place_of(following[1])))

    def _in_turn(self, chunk: Chunk, objects: list[Mention | Place]) -> bool:
        """Link each of several things to its own: "next to the window and the door, respectively"."""
        rest = takewhile(lambda other: other.kind != "stop", self.chunks[self.at :])
        if all(other.value != "respectively" for other in rest):
            return False
        own = self.subject if len(self.subject) > 1 else self.group
        own = own if len(own) > 1 else [Mention(m.thing, slice(i, i + 1)) for m in own for i in range(m.thing.count)]
        to: list[tuple[Chunk, Mention | Place]] = []
        for item in objects:
            walls = item.words if isinstance(item, Place) and "and" in item.words else ()
            to += [(chunk, replace(item, words=(word,))) for word in walls if word != "and"] or [(chunk, item)]
        while len(to) < len(own) and self._ahead().kind in ("and", "comma", "rel"):
            chunk = self._ahead() if self._ahead().kind == "rel" else chunk
            self.at += 1
            to += [(chunk, item) for item in [self._object(chunk)] if item is not None]
        for one, (how, item) in zip(own, to, strict=False):
            self._link(how, [one], [item])
        self.acted = own
        return len(own) == len(to)

    def _other_side(self, chunk: Chunk, objects: list[Mention | Place]) -> tuple[Chunk, list[Mention | Place]]:
        """Return a relation and what it leads to, where "on the other side" is the other side of what was spoken of."""
        place = objects[0] if objects and isinstance(objects[0], Place) else None
        if chunk.value == "opposite" and "other" in chunk.adjectives:  # "on the other side of the bed"
            said = [k for k in self.said.links if named(objects) & named(k.objects)]
            sides = [k for k in said if k.relation in OTHER_SIDE][-1:]
            there = [m for k in sides if OTHER_SIDE[k.relation] == "otherside" for m in k.subjects]
            return (replace(chunk, value=OTHER_SIDE[sides[0].relation]) if sides else chunk), [*objects, *there]
        if place is not None and place.name == "room" and chunk.value in ("amid", "separates") and not objects[1:]:
            return replace(chunk, value="middle"), objects  # "a screen dividing the room"
        if place is not None and place.name == "room" and chunk.value in ("oneside", "end"):
            one = "one" in chunk.adjectives  # "at one end of the room"
            return replace(chunk, value="on"), [Place("side", () if one else ("far",), det="one" if one else "")]
        sided = [link for link in self.said.links if link.relation in OTHER_SIDE and link.objects][-1:]
        if place is None or not sided or (place.name, place.det) != ("side", "other"):
            return chunk, objects
        there = sided[0].subjects if OTHER_SIDE[sided[0].relation] == "otherside" else ()
        return replace(chunk, value=OTHER_SIDE[sided[0].relation]), [*sided[0].objects, *there]

    def _walls(self, subjects: list[Mention], place: Place) -> list[Mention]:
        """Return what stands at the wall by which another is told: "the same wall as the crib", "the opposite wall"."""
        if place.name != "wall" or place.plural or place.by is not None:
            return []
        if "same" in place.words and self._ahead().value == "as":
            self.at += 1
            item = self._object(self._ahead(-1))
            return mentions([item] if item is not None else [])
        at = [k for k in self.said.links if k.relation in ("wall", "on", "by") and k.subjects and k.objects]
        at = [k for k in at if isinstance(k.objects[0], Place) and k.objects[0].name == "wall"][-1:]
        there = [m for k in at for m in k.subjects if m.thing not in named(subjects)]
        return there if {"opposite", "opposing"} & {*place.words} else []

    def _turned_round(self, first: int, index: int) -> bool:
        """Return whether what follows the object of a relation is what it is about: "and on it stands a lamp"."""
        end, verb = index, False
        aside = self.chunks[first - 1].det == "its" or [c.kind for c in self.chunks[index - 1 : index]] == ["pron"]
        if aside and [c.kind for c in self.chunks[index : index + 2]] == ["comma", "thing"] and first > 1:
            return self.chunks[first - 2].kind == "comma"  # "a sofa and, next to it, a lamp"
        while index < len(self.chunks) and self.chunks[index].kind in ("verb", "filler", "style", "pron"):
            verb = verb or self.chunks[index].kind == "verb"
            index += 1
        if index >= len(self.chunks) or self.chunks[index].kind != "thing":
            return False
        starts = self.chunks[first - 2].kind in ("and", "comma", "stop", "colon") if first >= 2 else True
        starts = starts or self.chunks[end - 1].value == "which"  # "a rack beside which hangs a mirror"
        return starts and (verb or (index == end and self.chunks[index].det != "the"))
