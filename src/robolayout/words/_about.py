"""What a relation in words is about: the thing before it, all of a list, the subject of its clause."""

from __future__ import annotations

from robolayout.assets import CATALOGUE
from robolayout.words import _function_words as small
from robolayout.words._chunk import Chunk
from robolayout.words._led_to import LedTo
from robolayout.words._said import Mention, Thing, laid, same, several, topped
from robolayout.words._ways import SEATS, TOPS


class About(LedTo):
    """Finds what relations are about."""

    def _nearest(self, relation: str) -> list[Mention]:
        """Return what a relation right after a noun is about: small things "on" something all together, else the noun."""
        following = self._ahead().value
        noun = self.target.thing.noun if self.target is not None else None
        hung = noun is not None and any("wall" in CATALOGUE[kind].places for kind in (noun.kind, *noun.others))
        told = relation in ("by", "next", "near", "holds", *(("on", "wall") if following == "wall" and hung else ()))
        last = self.group[-1:] or list(self.subject or ([self.target] if self.target is not None else []))
        does = {*self._ahead(-1).adjectives} & small.PLURAL_DOES and not self.relative  # "a sofa and a chair face it"
        if len(self.group) > 1 and (does or self._shared(relation)):
            return list(self.group)
        if self.target is not None and relation == "on" and following != "wall" and last:
            told = _on_tops(self.target) and not _on_tops(last[0])  # "a sofa facing a TV on a stand"
        place = self._ahead().kind == "part"
        if self.target is not None and place and last and relation not in ("on", "facing"):
            told = told or (_on_tops(last[0]) and not _on_tops(self.target))  # "a laptop on the desk under the window"
        to = self._ahead().noun
        if self.target is not None and to is not None and last and relation in small.STANDING:
            held = topped(last[0]) and not topped(self.target) and not CATALOGUE[to.kind].on_object
            told = told or held  # "bottles on the shelves behind the counter"
        if self.target is not None and told and self.acted:
            return [self.target]
        if self.target is not None and self.said.links and self.said.links[-1].relation == "in" and place:
            return [self.target]  # "toys in a box under the window"
        if relation in small.ORDERS and last and last[0].thing.count == 1:
            return list(self.group or self.subject)  # "fridge, stove and sink in a row"
        if relation == "on" and last and laid(last[0]) and len(self.group) > 1:
            it = self._ahead().kind == "pron"
            linked = {m for link in self.said.links if not it or link.relation != "with" for m in link.subjects}
            linked -= {last[0]}
            return [m for m in self.group if m.thing.category.on_object and m not in linked]
        return last

    def _shared(self, relation: str) -> bool:
        """Return whether a relation after a list is about all of it: "a sofa and an armchair in the corner".

        Not where it leads back to the list, where one of it has a relation of its own or cannot stand so; of what a room or a
        thing has, and of three things that do not belong together, only the last one stands at a place.
        """
        *earlier, last = (mention.thing for mention in self.group)
        if relation == "around":
            return all(map(sat_on, self.group))
        to = next((c for c in self.chunks[self.at :] if c.kind not in ("filler", "style")), Chunk("", 0, 0))
        again = to.kind == "pron" or any(same(thing, to) for thing in (*earlier, last))
        again = again or (
            to.kind in ("", "and", "comma", "stop") and relation in small.NEARNESS
        )  # "a bed, a desk beneath"
        begun = next(i for i, c in enumerate(self.chunks) if c.end == last.spans[-1][1])
        closed = self.chunks[begun - 1].kind == "and"
        had = "with" if relation == "flank" else ""
        own = (k for k in self.said.links if k.start >= self.began and k.relation != had)
        if again or not closed or self.target is not None or {m.thing for k in own for m in k.subjects} & {*earlier}:
            return False
        where = _where(relation, to)
        if (
            (relation == "flank" and any(map(several, self.group)))
            or relation not in small.SHARED
            or (where and not all({*where} & _places(thing) for thing in earlier))
        ):
            return False
        if relation in ("wall", "flank") or where == ("object",):
            return True
        unit = self.chunks[begun]  # "an armchair and ottoman"
        if not (unit.det or unit.plural or unit.number is not None or earlier[1:]):
            return True
        alike = all(map(_sat_at, self.group))
        if any(c.kind in ("room", "with", "colon") and c.start >= self.began for c in self.chunks[:begun]):
            return alike and not earlier[1:]
        return alike or not earlier[1:] or all(thing.definite for thing in earlier) or to.kind == "thing"

    def _subjects(self, relation: str) -> list[Mention]:
        """Return what a relation here is about."""
        previous = next((c for c in reversed(self.chunks[: self.at - 1]) if c.kind not in ("filler", "style")), None)
        opening = previous is not None and previous.value in ("window", "door")
        if previous is None or previous.kind == "stop" or (opening and previous.det == "a"):
            return []  # "a window on each side of it"
        if self.fronted is not None and previous.kind in ("and", "comma"):
            self.also = self.fronted if not self.group else None  # "between them, under the window, is a table"
            self.fronted = None
            return []
        if self._of_the_noun():
            return self._nearest(relation)
        if previous.kind == "verb" or self.verb:
            told = self.group[-1:] if self.target is None else [self.target]  # "the sink, which is under ..."
            return told if self.relative else list(self.subject or self.group)
        if previous.kind == "thing":
            return self._nearest(relation)
        last = self.said.links[-1] if self.said.links else None
        of_it = previous.kind == "pron" and self.having and self.holder and not self.verb
        if of_it and last and [*last.objects] == self.holder:
            return list(self.holder)  # "a rug with a table on it in front of the sofa"
        if previous.kind == "pron" and not self.relative:
            return list(self.before or self.subject) if not self.group else list(self.group)
        if self.relative:
            return self.group[-1:]
        if previous.kind == "comma" and self.holder and not self.acted and self._ahead().kind != "pron":
            return list(self.holder)  # "three desks, each with a chair, in a row"
        ordered = relation in small.ORDERS and len(self.group) > 1 and not self.acted
        return list(self.group if ordered else self.acted or self.group[-1:] or self.subject)

    def _of_the_noun(self) -> bool:
        """Return whether a participle leads from the noun before it to a relation: "..., a lamp hanging over it"."""
        index = self.at - 2
        while (
            index > 0 and self.chunks[index].kind in ("verb", "filler") and self.chunks[index].value not in small.FINITE
        ):
            index -= 1
        return index < self.at - 2 and self.chunks[index].kind == "thing"


def _where(relation: str, to: Chunk) -> tuple[str, ...]:
    """Return where a thing must be able to be that stands so to something: one stands also "on" a wall told from the others."""
    flat = to.noun is not None and CATALOGUE[to.noun.kind].size[2] < 0.03
    if relation == "on" and to.value == "wall":
        return ("wall", "floor") if to.adjectives else ("wall",)
    if relation == "above":
        return ("wall", "ceiling")
    if relation in ("on", "in") and to.kind == "thing" and not flat:
        return ("object",)
    return ("floor",) if relation in ("on", "in", "wall", "under") else ()


def _places(thing: Thing) -> set[str]:
    """Return where things of any kind that a noun means can be."""
    return {place for kind in (thing.noun.kind, *thing.noun.others) for place in CATALOGUE[kind].places}


def _sat_at(mention: Mention) -> bool:
    """Return whether a thing is a seat or what one sits at."""
    return sat_on(mention) or mention.thing.head in TOPS


def sat_on(mention: Mention) -> bool:
    """Return whether one sits on a thing."""
    return mention.thing.head in SEATS


def _on_tops(mention: Mention) -> bool:
    """Return whether a thing can stand on another."""
    return mention.thing.category.on_object
