"""What noun phrases name: a thing named before or a new one, some of several, the next of a list, the beginning of a clause."""

from __future__ import annotations

from itertools import dropwhile

from robolayout.words import _function_words as small
from robolayout.words._chunk import NOTHING, Chunk
from robolayout.words._counting import Counting
from robolayout.words._lexicon import grammar
from robolayout.words._said import Link, Mention, NamedThing, named


class NamingThings(Counting):
    """Finds what noun phrases name."""

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
        for held in chunk.held:
            inner = self._mention(held)
            inner.thing.within = made
            self.said.links.append(Link("with", (inner,), (Mention(made, None, chunk.det),), held.start, held.end))
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
        first = next((i for i in range(self.at - 2, -1, -1) if not joins[i]), -1)
        contents = first > 1 and self.chunks[first].kind in ("other", "thing")
        if contents and [self.chunks[first - 2].kind, self.chunks[first - 1].value] == ["thing", "of"]:
            first -= 2  # "a box of pegs and a jar"
        if first < 0 or self.chunks[first].kind != "thing" or not self.group or self.acted:
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
        plural = again and following.kind == "verb" and following.value in small.FINITE | small.MODAL
        stood = self._ahead(len(self.chunks[self.at :]) - len(rest) + 2 + 2 * among).value  # what follows the verb
        on_it = among and self._ahead().value == "on" and mention.can_be_on_a_top
        had = not joined and (self.said.last.relation, self.said.last.subjects) == ("with", (mention,))
        if self.having and had and self._ahead(-2).kind == "comma":
            return False  # "a table with chairs around it, a jug and a bowl is ..."
        if joined and self.having and (on_it or (mention.laid and stood in ("opposite", "wall"))):
            return False  # "a counter with a kettle and a toaster is opposite", "a desk with a lamp and a statue on it is ..."
        alone = following.value in small.ALONE_DOES and (mention.thing.count == 1 if joined else starts)
        other = (
            bool(self.group)
            and mention.det in ("the", "both", "all")
            and self.group[-1].det not in ("the", "both", "all")
        )
        apart = [c.kind for c in self.chunks[self.at - 3 : self.at - 1]] == ["comma", "and"]
        other = apart and (other or (self._ahead().kind == "and" and following.value not in small.ALONE_DOES))
        again = following.kind == "verb" and following.value in small.FINITE
        alone = (
            alone or (plural and starts) or (other and again)
        )  # "a desk with a lamp and a tray, and both chairs are ..."
        self.subject, self.acted = ([], []) if alone else (self.subject, self.acted)
        return alone
