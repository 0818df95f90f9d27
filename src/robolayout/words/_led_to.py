"""What a relation leads to where other words tell it: the other side, each its own, the wall of another thing."""

from __future__ import annotations

from dataclasses import replace
from itertools import takewhile

from robolayout.words._chunk import Chunk
from robolayout.words._references import References
from robolayout.words._said import Mention, Place
from robolayout.words._ways import OTHER_SIDE


class LedTo(References):
    """Reads what relations lead to."""

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
        while len(to) < len(own) and self.chunks[self.at].kind in ("and", "comma", "rel"):
            chunk = self.chunks[self.at] if self.chunks[self.at].kind == "rel" else chunk
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
            to = {item.thing for item in objects if isinstance(item, Mention)}
            said = [k for k in self.said.links if to & {m.thing for m in k.objects if isinstance(m, Mention)}]
            sides = [k.relation for k in said if k.relation in ("left", "right")]
            return (replace(chunk, value=OTHER_SIDE[sides[-1]]) if sides else chunk), objects
        if place is not None and (chunk.value, place.name) == ("oneside", "room"):
            return replace(chunk, value="on"), [Place("side", det="one")]
        sided = [link for link in self.said.links if link.relation in OTHER_SIDE and link.objects][-1:]
        if place is None or not sided or (place.name, place.det) != ("side", "other"):
            return chunk, objects
        there = sided[0].subjects if sided[0].relation == "oneside" else ()
        return replace(chunk, value=OTHER_SIDE[sided[0].relation]), [*sided[0].objects, *there]

    def _walls(self, subjects: list[Mention], place: Place) -> list[Mention]:
        """Return what stands at the wall by which another is told: "the same wall as the crib", "the opposite wall"."""
        if place.name != "wall" or place.plural or place.by is not None:
            return []
        following = self.chunks[self.at : self.at + 2]
        if "same" in place.words and [(c.kind, c.value) for c in following[:1]] == [("and", "as")]:
            self.at += 1
            return [item for item in [self._object(following[0])] if isinstance(item, Mention)]
        at = [k for k in self.said.links if k.relation in ("wall", "on", "by") and k.subjects and k.objects]
        at = [k for k in at if isinstance(k.objects[0], Place) and k.objects[0].name == "wall"][-1:]
        there = [m for k in at for m in k.subjects if m.thing not in {own.thing for own in subjects}]
        return there if {"opposite", "opposing"} & {*place.words} else []

    def _turned_round(self, first: int, index: int) -> bool:
        """Return whether what follows the object of a relation is what it is about: "and on it stands a lamp"."""
        end, verb = index, False
        while index < len(self.chunks) and self.chunks[index].kind in ("verb", "filler", "style", "pron"):
            verb = verb or self.chunks[index].kind == "verb"
            index += 1
        if index >= len(self.chunks) or self.chunks[index].kind != "thing":
            return False
        starts = self.chunks[first - 2].kind in ("and", "comma", "stop", "colon") if first >= 2 else True
        return starts and (verb or (index == end and self.chunks[index].det != "the"))
