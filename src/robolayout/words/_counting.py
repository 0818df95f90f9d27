"""How many things are asked for that stand at each of several others, at both sides of something, at walls or in rows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

from robolayout.words import _function_words as small
from robolayout.words._chunk import Chunk
from robolayout.words._said import Item, Link, Mention, NamedThing, mentions, named, place_in, places
from robolayout.words._spoken import Spoken


class Counting(Spoken):
    """Counts what relations ask for."""

    def _others_follow(self, chunk: Chunk) -> bool:
        """Return whether this sentence goes on with the other ones of some things: "one chair on the left, the other on the right"."""
        rest = takewhile(lambda c: c.kind != "stop", self.chunks[self.at :])
        return any(c.det in ("other", "new") and c.noun == chunk.noun for c in rest)

    def _counted_one(self, thing: NamedThing) -> bool:
        """Return whether a thing was first named as one of a number: "one armchair is on the left, the other on the right"."""
        first = next(c for c in self.chunks if c.start == thing.spans[0][0])
        return (first.number, first.det) == (1, "")

    def _told_more(self, thing: NamedThing, chunk: Chunk) -> bool:
        """Return whether a phrase says more of the one thing that was named bare: "I see the TV from the bed. Put a double bed ..."."""
        assert chunk.noun is not None
        bare = not thing.adjectives and len(thing.noun.said.split()) == 1 and thing.count == 1
        if not bare or thing.noun.kind != chunk.noun.kind:
            return False
        thing.noun, thing.adjectives = chunk.noun, chunk.adjectives
        thing.sizes += chunk.sizes
        return True

    def _on_both_sides(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Item]) -> Chunk:
        """Count what stands at each side of something; return the relation, which is "around" for several seats at a table."""
        tables = [to.thing for to in mentions(objects) or self.holder if to.thing.has_sides]
        each = (self.having and self.holder) or "each" in chunk.adjectives  # "a sofa and a chair on either side of it"
        for mention in subjects if each else subjects[: len(subjects) == 1]:
            thing = mention.thing
            own = not objects and mention.det == "a"
            if not mention.per_side(chunk, own=own) or thing in self.dealt:
                continue
            thing.number = (tables[0].sides if tables and "side" in chunk.adjectives else 2) * (thing.number or 1)
            around = [to for to in mentions(objects[:1]) if to.det in ("each", "all")]
            thing.times = around[0].thing.count if around else thing.times if own else 1
        several = bool(tables) and all(mention.at_a_table and mention.several for mention in subjects)
        return replace(chunk, value="around") if several else chunk

    def _counted(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Item]) -> Sequence[Mention]:
        """Settle how many things are asked for that stand at each of several, at walls or in rows; return them."""
        shared = chunk.value in small.SHARED_OUT and all(m.thing.number in (None, 1) for m in subjects)
        one_each = ("each", "both", "all") if shared else ("each",) if chunk.value not in ("apart", "far") else ()
        each = [item for item in objects if item.det in one_each]
        for mention in subjects if each and each[0].det != "each" else ():
            mention.thing.number = 1  # "lamps on both nightstands"
        for item in each[:1]:  # "on every table", of which there are square and round ones
            count = sum(self._gaps(one) if chunk.value == "amid" else self._number_of(one) for one in each)
            subjects = [mention.widened(count) for mention in subjects]
            for mention in subjects:
                owned = isinstance(item, Mention) and item.thing is mention.thing
                dealt = mention.thing in self.dealt or mention.pick is not None  # "two lamps, one in each corner"
                one = mention.thing.head in small.OWN_ONE or place_in([item], "corner")  # "plants in every corner"
                if mention.thing.uncounted and one and item.det == "each":
                    mention.thing.number = 1  # "beds with desks at the foot of each"
                if mention.thing.times == 1 and not owned and not dealt:
                    mention.thing.times = count * (2 if mention.per_side(chunk) else 1)
                    self._counted_on(mention.thing)
        self._counted_at_walls(chunk, subjects, objects)
        corners = next((to.number for to in places(objects, "corner")), None)
        for thing in (mention.thing for mention in subjects if corners and mention.thing.uncounted):
            thing.number = corners  # "cat trees in three corners"
        for mention in subjects if chunk.value == "rows" else ():
            mention.thing.rows = mention.thing.rows or chunk.rows  # "clothing racks in three rows"
        for thing in (m.thing for m in subjects if chunk.value == "columns" and m.thing.rows and m.thing.uncounted):
            thing.number = thing.rows * (chunk.rows or 1)  # "six rows of pews in two columns"
        return subjects

    def _counted_on(self, thing: NamedThing) -> None:
        """Count what each of some things has: "a nightstand with a lamp next to each bed"."""
        had = [k.subjects for k in self._here if k.relation == "with" and named(k.objects) == {thing}]
        for one in (m.thing for subjects in had for m in subjects if m.det != "the" and m.thing.times == 1):
            one.times = thing.times

    def _counted_at_walls(self, chunk: Chunk, subjects: Sequence[Mention], objects: Sequence[Item]) -> None:
        """Settle how many of what no number is said stand at several walls, or between others."""
        lined = places(objects, "wall") if chunk.value in ("wall", "on") else []
        several = not {"line", "lines", "lined", "lining"}.isdisjoint(chunk.adjectives)  # not "along the walls"
        walls = next((to.number or 2 * (to.plural and several) for to in lined if to.det != "all"), 0)
        walls = next((self._number_of(to) for to in lined if to.det == "all"), walls)
        apart = [m for m in mentions(objects) if m.count > 2] if chunk.value == "amid" else []
        for thing in (mention.thing for mention in subjects):
            ell = any(k.relation == "ell" and thing in named(k.subjects) for k in self.said.links)
            if walls and thing.plural and thing.number is None and not ell:
                at_each = 2 if several or chunk.value == "wall" or thing.head in small.SEATS else 1
                thing.number = walls * at_each  # "bookshelves line two walls"
            elif apart and thing.parts_uncounted:
                thing.number = self._gaps(apart[0])  # "partitions between the desks"


def one_for_each(links: Sequence[Link]) -> None:
    """Let what is at or in each of things that everybody has be as many as these: "each gets a bed; beside each bed is a lamp"."""
    for link in links:
        for thing in (m.thing for m in link.subjects if m.thing.within in named(link.objects)):
            thing.times = thing.within.times if thing.within else 1
        own = [m.thing.times for m in mentions(link.objects) if m.det == "each" and m.thing.everyones]
        for thing in (m.thing for m in link.subjects if own and m.thing.times == 1 and not m.thing.everyones):
            thing.times = own[0]
