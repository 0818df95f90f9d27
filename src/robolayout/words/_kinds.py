"""Which of several kinds a noun means: a lamp on a table is a table lamp, one above it hangs from the ceiling."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import replace

from robolayout.assets import CATALOGUE
from robolayout.assets.lexicon import phrase_index
from robolayout.scene import FLAT_HEIGHT
from robolayout.words import _function_words as small
from robolayout.words._chunk import Chunk
from robolayout.words._lexicon import grammar
from robolayout.words._said import Link, Mention, NamedThing, Parsed, Place, mentions, named, place_in, take


def settle_kinds(parsed: Parsed) -> None:
    """Give things whose noun means several kinds the first kind that can be where they are asked to be."""
    heads = {thing.head for thing in parsed.things if thing.noun.kind != "side table"}
    alone = "chair" in heads and not heads & {"table", "desk"}
    for link in parsed.links:
        if link.relation in ("with", "around") and any(m.thing.head in ("chair", "stool") for m in link.subjects):
            for mention in mentions(link.objects):
                mention.thing.sat_at = True
    music = bool({thing.noun.kind for thing in parsed.things} & small.INSTRUMENTS) and not heads & {"desk", "computer"}
    _settle_by_company(parsed, heads)
    _settle_visitors(parsed)
    _settle_drawn(parsed)
    _settle_beside_on_tops(parsed)
    _settle_on_stands(parsed)
    for thing in parsed.things:
        if thing.noun.said == "keyboard" and music:
            take(thing, "digital piano")
        _settle_table(thing, heads, alone=alone)
    _settle_front_and_back(parsed)
    stored = not small.STORES.isdisjoint(chunk.value for chunk in parsed.facts if chunk.kind == "room")
    _settle_behind_and_below(parsed)
    # "with" says least of where a lamp is, "above" most
    for link in sorted(parsed.links, key=lambda link: (link.relation == "with", link.relation != "above")):
        _settle_by_others(link)
        _settle_by_place(link)
        at = place_in(link.objects[:1], "wall")
        aloft, on = link.relation == "aloft", link.relation == "on" and not stored
        for thing in (one.thing for one in link.subjects if at and not (at.words or at.by or at.plural)):
            if (aloft or on) and thing.noun.said == "shelf":
                take(thing, "wall shelf")  # "a shelf on the wall", but "shelves on the left wall" stand there


def _settle_front_and_back(parsed: Parsed) -> None:
    """Take the wall of a board that is told by the compass for the front of the room: "a blackboard on the north wall"."""
    watched = [thing for thing in parsed.things if thing.noun.kind in small.BOARDS]
    for i, link in enumerate(parsed.links):  # "seats facing the front, a screen on the front wall"
        front = link.relation == "facing" and (side := place_in(link.objects, "side")) and side.words == ("front",)
        parsed.links[i] = replace(link, objects=(Mention(watched[0]),)) if front and watched else link
    boards = [k for k in parsed.links if any(m.thing.noun.kind in small.BOARDS for m in k.subjects)]
    walls = {wall.words for k in boards if (wall := place_in(k.objects[:1], "wall")) is not None}
    (front,) = walls.pop() if len(walls) == 1 and len(next(iter(walls))) == 1 else ("",)
    if front not in small.COMPASS:
        return
    meant = {"front": front, "back": small.ACROSS[front], "rear": small.ACROSS[front]}
    for i, link in enumerate(parsed.links):
        told = (
            replace(item, words=tuple(meant.get(word, word) for word in item.words))
            if isinstance(item, Place) and item.name in ("wall", "side")
            else item
            for item in link.objects
        )
        parsed.links[i] = replace(link, objects=(*told,))


def _settle_table(thing: NamedThing, heads: Set[str], *, alone: bool) -> None:
    """Take small tables for those to eat at where chairs go with them, for side tables by armchairs; round ones for round ones."""
    if thing.noun.said == "table" and {"small", "little"} & {*thing.adjectives}:  # "a small wooden table"
        thing.adjectives = tuple(word for word in thing.adjectives if word not in ("small", "little"))
        _mean(thing, "small table", "small table")
    noun = thing.noun
    if noun.said == "small table" and (alone or thing.promising):
        take(thing, "round table" if alone else "dining table")
        thing.adjectives = (*thing.adjectives, "small")
    if "low" in thing.adjectives and noun.kind in ("round table", "dining table") and heads & small.LOUNGE:
        take(thing, "coffee table")  # "four armchairs around a low round table"
    seated = heads & small.LOUNGE and not (heads & {"chair", "stool", "desk"} or thing.promising)
    if seated and noun.kind == "round table" and {"small", "little"} & {*thing.adjectives}:
        take(thing, "side table")  # "two armchairs and a small round table"
    rounded = f"round {'table' if noun.kind in (*small.TABLES, 'conference table') else noun.kind}"
    if small.ROUND & {*thing.of_all} and rounded in CATALOGUE:
        take(thing, rounded)


def _mean(thing: NamedThing, phrase: str, said: str) -> None:
    """Take a thing for what a phrase means, one of several kinds, whatever was said."""
    kind, *others = phrase_index()[phrase]
    thing.noun = replace(thing.noun, words=kind, kind=kind, said=said, others=tuple(others))


def _settle_by_company(parsed: Parsed, heads: Set[str]) -> None:
    """Take stools for high ones where there is a bar and no table, the double sink of a bathroom for a vanity, a cat's bed for one."""
    rooms = {chunk.value for chunk in parsed.facts if chunk.kind == "room"}
    lives = {(chunk.kind, chunk.value) for chunk in parsed.facts if chunk.kind in ("body", "people")}
    pets = bool(lives) and not rooms and all(kind == "body" and body in small.PETS for kind, body in lives)
    kinds, taken = {thing.noun.kind for thing in parsed.things}, dict[str, str]()
    bar = kinds & small.COUNTERS and not heads & {"table", "desk", "piano", "bench"}
    played = kinds & small.INSTRUMENTS and not heads & {"table", "desk"}
    for thing in parsed.things:
        if thing.noun.said == "bench" and played and thing.count == 1:
            thing.noun = replace(thing.noun, kind="stool", others=())  # a piano's bench
        elif thing.noun.said == "cushion" and not heads & {*small.LOUNGE, *small.SLEPT_ON, "chair", "bench", "seat"}:
            take(thing, "floor cushion")  # "a reading corner with a rug and cushions"
        elif thing.noun.words == "stool" and bar:
            take(thing, "bar stool")
        elif thing.noun.kind == "waiting bench" and thing.noun.said.endswith("chair") and thing.count > 1:
            take(thing, "chair")  # "five linked chairs"
        elif (
            thing.noun.kind == "cabinet" and rooms == {"kitchen"} and thing.count > 1 and "tall" not in thing.adjectives
        ):
            _mean(thing, "kitchen cabinet", thing.noun.said)
        elif thing.noun.kind == "kitchen sink" and "bathroom" in rooms:
            take(thing, "bathroom vanity")
        elif meant := small.OF_ROOMS.get(thing.noun.said, {}).keys() & rooms:
            kind = small.OF_ROOMS[thing.noun.said][min(meant)]
            # "a bench and a workbench", "a counter and two desks" in a bank
            other = kind in kinds or taken.setdefault(kind, thing.noun.said) != thing.noun.said
            take(thing, thing.noun.kind if other else kind)
        elif thing.noun.said in small.OF_PETS and (pets or thing.of_pet):
            take(thing, f"pet {thing.noun.said}")
            thing.of_pet = True


def _settle_visitors(parsed: Parsed) -> None:
    """Take chairs before a desk that faces the room or its door for those of visitors."""
    facing = [link for link in parsed.links if link.relation == "facing" and place_in(link.objects, "room", "door")]
    hosts = {one.thing for link in facing for one in link.subjects if one.thing.head == "desk"}
    for link in parsed.links:
        if link.relation == "front" and hosts & {one.thing for one in mentions(link.objects)}:
            for thing in (one.thing for one in link.subjects if one.thing.noun.said == "chair"):
                thing.noun = replace(thing.noun, words="visitor chair", said="visitor chair", others=())


def _settle_behind_and_below(parsed: Parsed) -> None:
    """Take tables on which several computers are for desks, and a curtain behind which furniture is for a screen."""
    for link in parsed.links:
        worked_at = [m.count for m in link.subjects if link.relation == "on" and m.thing.noun.said in small.WORKED_AT]
        for thing in named(link.objects) if worked_at and worked_at[0] > 1 else ():
            if thing.noun.said == "table":
                take(thing, "desk")
        behind = link.relation == "behind" and all(m.thing.category.on_floor for m in link.subjects)
        for thing in (one for one in named(link.objects) if behind and one.noun.kind == "curtain"):
            take(thing, "privacy screen")


def _settle_drawn(parsed: Parsed) -> None:
    """Leave to things what is drawn on them: coats on a coat rack, and no things of their own."""
    found = list[NamedThing]()
    for link in (link for link in parsed.links if link.relation in ("on", "in", "with")):
        drawn = {kind for bearer in named(link.objects) for kind in grammar().drawn.get(bearer.noun.kind, ())}
        found += [one.thing for one in link.subjects if drawn & {one.thing.noun.kind, one.thing.noun.said}]
        if "bookshelf" in {bearer.noun.kind for bearer in named(link.objects)}:  # one "with five books" has these
            found = [thing for thing in found if thing.uncounted and link.relation == "with"]
    for thing in dict.fromkeys(found):
        parsed.things.remove(thing)
        parsed.facts += [Chunk("function", *span, thing.noun.said) for span in thing.spans]
        about = (replace(k, subjects=tuple(one for one in k.subjects if one.thing is not thing)) for k in parsed.links)
        parsed.links[:] = [link for link in about if link.subjects or link.relation in ("bare", "faced")]


def _settle_beside_on_tops(parsed: Parsed) -> None:
    """Put speakers onto the desk of the monitor at whose sides they are, and hang lamps that are on a wall above something there."""
    on = [link for link in parsed.links if link.relation == "on"]
    for link in [link for link in parsed.links if link.relation in small.AT_SIDES]:
        screens = {thing for thing in named(link.objects) if thing.head in small.WORKED_AT}
        tops = [k.objects for k in on if screens & named(k.subjects)]
        beside = tuple(m for m in link.subjects if m.thing.head == "speaker")
        if tops and beside:
            parsed.links.append(Link("on", beside, tops[0], link.start, link.end))
    walled = {thing for link in parsed.links if place_in(link.objects[:1], "wall") for thing in named(link.subjects)}
    for thing in {m.thing: 0 for link in parsed.links if link.relation == "above" for m in link.subjects}:
        if thing in walled and thing.noun.said in small.LIGHTS:
            take(thing, "wall lamp")


def _settle_on_stands(parsed: Parsed) -> None:
    """Say of the stand what is said of the one thing on it: "a camera on a tripod stands 2 m before a stool"."""
    borne = dict[NamedThing, Mention]()
    for link in (link for link in parsed.links if link.relation == "on"):
        stands = [m for m in mentions(link.objects) if m.thing.head in small.STANDS]
        borne |= {m.thing: stands[0] for m in link.subjects[:1] if stands and m.thing.category.on_object}
    bearing = {stand.thing for stand in borne.values()}
    for i, link in enumerate(parsed.links):
        if link.relation != "on" and not bearing & named(link.objects):
            subjects = tuple(borne.get(m.thing, m) for m in link.subjects)
            objects = tuple(borne.get(o.thing, o) if isinstance(o, Mention) else o for o in link.objects)
            parsed.links[i] = replace(link, subjects=subjects, objects=objects)


def _is_small_table(thing: NamedThing) -> bool:
    """Return whether a thing is a small table with no seats of its own: "a nursing chair with a small round table beside it"."""
    round_one = thing.noun.kind == "round table" and {"small", "little"} & {*thing.adjectives} and not thing.promising
    return bool(round_one) or (thing.noun.said == "small table" and bool(thing.noun.others))


def _settle_by_others(link: Link) -> None:
    """Take tables between lounge seats for low ones, stools at counters for high ones, what parts or is looked at for screens."""
    to = [item.thing for item in mentions(link.objects)]
    heads, amid, around = {thing.head for thing in to}, link.relation == "amid", link.relation == "around"
    at_tops = around or link.relation == "with"
    sat_on = link.relation in (*small.ORDERS, "facing")  # "eight cushions in two rows facing an altar"
    for thing in (mention.thing for mention in link.subjects if to or sat_on):
        if amid and heads <= small.LOUNGE and thing.noun.kind in small.TABLES and thing.noun.said != "dining table":
            take(thing, "coffee table" if "sofa" in heads else "side table")
        elif _is_small_table(thing) and link.relation in (*small.AT_SIDES, "front"):
            take(thing, "coffee table" if link.relation == "front" and heads <= small.LOUNGE else "side table")
        elif thing.noun.said == "sink" and heads & {"island", "counter"}:
            take(thing, "kitchen sink")
        elif thing.noun.words == "stool" and any(other.noun.kind.endswith(small.HIGH) for other in to):
            take(thing, "bar stool")
        elif thing.noun.kind == "cushion" and (sat_on or heads <= {"rug"} or (at_tops and heads & small.TOPS)):
            take(thing, "floor cushion")
        elif thing.noun.kind == "curtain" and (amid or around):
            take(thing, "privacy screen")
    looks = any(m.sat_on or m.thing.head == "projector" for m in link.subjects)
    for thing in to if looks and link.relation in small.WATCHING else ():
        if thing.noun.said == "screen":
            take(thing, "projection screen")


def _settle_by_place(link: Link) -> None:
    """Take what hangs, stands or lies where a relation puts it for a kind that can be there."""
    to = mentions(link.objects)
    lit = [m for m in to if link.relation == "under" and m.thing.noun.said in small.LIGHTS]
    sat = all(m.sat_on or m.thing.head in (*small.TOPS, *small.SLEPT_ON) for m in link.subjects)
    # "a desk under a shelf"
    over = [m for m in to if link.relation == "under" and m.thing.noun.said == "shelf" and sat]
    place = "ceiling" if lit else "wall" if over else _where(link)
    for thing in (mention.thing for mention in lit or over or link.subjects):
        noun = thing.noun
        for bearer in (mention.thing for mention in to):
            own = phrase_index().get(f"{noun.said} stand", ())[:1]
            if link.relation == "on" and bearer.noun.said == "stand" and own:
                bearer.noun = replace(bearer.noun, words=own[0], kind=own[0], guessed="")
            if link.relation == "on" and noun.kind == "television" and bearer.noun.kind == "cabinet":
                take(bearer, "tv stand")  # a cabinet is not as wide
        stands = thing.category.on_floor and noun.said not in (*small.LIGHTS, "screen")
        if place == "wall" and link.relation not in ("above", "under") and stands:
            continue
        fits = [kind.name for kind in noun.categories if place in kind.places]
        if not fits and link.relation == "above":  # "a shelf above the desk" hangs on the wall behind it
            fits = [kind.name for kind in noun.categories if "wall" in kind.places]
        if noun.others and fits and noun.words in (noun.kind, noun.said):
            words = fits[0] if noun.words == noun.kind else noun.words
            thing.noun = replace(noun, words=words, kind=fits[0], others=())


def _where(link: Link) -> str:
    """Return where a relation puts its subject: "floor", "wall", "ceiling", "object", or "" where it does not matter."""
    to = link.objects[0] if link.objects else None
    if isinstance(to, Place) and to.name in ("corner", "window", "door", "middle"):
        return "wall" if link.relation == "above" else "floor"  # "a clock above the door"
    if isinstance(to, Place) and to.name in ("wall", "ceiling"):
        hung = link.relation in ("on", "hanging", "in", "aloft")
        return "ceiling" if to.name == "ceiling" else "wall" if hung else "floor" if link.relation == "wall" else ""
    if link.relation == "behind" and all(mention.thing.noun.said == "mirror" for mention in link.subjects):
        return "wall"
    standing = "floor" if link.relation in (*small.STANDING, "amid") else ""
    if to is None or isinstance(to, Place):
        return "ceiling" if link.relation == "above" else standing
    bearer = to.thing
    if link.relation == "above":
        return "ceiling" if bearer.head in (*small.TOPS, "chair", "stool", "island") else "wall"
    if link.relation == "on" or link.level:
        return "floor" if bearer.category.size[2] < FLAT_HEIGHT else "object"
    if link.relation == "with" and bearer.head in (*small.BEARING, "stand"):
        return "object"
    lit = all(mention.thing.noun.said in small.LIGHTS for mention in link.subjects)
    if link.relation == "with" and bearer.head in small.SEATS and lit:
        return "floor"  # "an armchair with a lamp"
    if link.relation == "flank" and bearer.noun.kind.endswith("bed"):
        return ""  # on the night stands
    # "a mirror to the left of the hooks"
    same = bearer.places in (("object",), *[("wall",)] * (link.relation in ("left", "right")))
    return bearer.places[0] if standing and same else standing
