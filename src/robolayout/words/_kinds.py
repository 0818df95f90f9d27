"""Which of several kinds a noun means: a lamp on a table is a table lamp, one above it hangs from the ceiling."""

from __future__ import annotations

from dataclasses import replace

from robolayout.assets import CATALOGUE
from robolayout.words import _function_words as small
from robolayout.words._said import Link, Mention, Parsed, Place
from robolayout.words._ways import BEARING, SEATS, TOPS

PARTING = "privacy screen"
"""A curtain that hangs at no window."""

LOOKED_AT = "projection screen"
"""What a screen before seats is."""


def settle_kinds(parsed: Parsed) -> None:
    """Give things whose noun means several kinds the first kind that can be where they are asked to be."""
    heads = {thing.noun.kind.split()[-1] for thing in parsed.things if thing.noun.kind != "side table"}
    for thing in parsed.things:
        noun = thing.noun
        if noun.said == "small table" and "chair" in heads and not heads & {"table", "desk"}:
            thing.noun = replace(noun, words="round table", kind="round table", others=())
            thing.adjectives = (*thing.adjectives, "small")
        kind = "table" if noun.kind in small.TABLES else noun.kind
        rounded = f"round {kind}" if small.ROUND & {*thing.adjectives} else ""
        if rounded in CATALOGUE:
            thing.noun = replace(noun, words=rounded, kind=rounded, others=())
    for link in parsed.links:
        _settle_low_table(link)
        _settle_high_stool(link)
        _settle_screen(link)
        _settle_curtain(link)
        hung = [item for item in link.objects if link.relation == "under" and isinstance(item, Mention)]
        lit = [mention for mention in hung if mention.thing.noun.said in ("lamp", "light")]
        place = "ceiling" if lit else _where(link)
        for mention in lit or link.subjects:
            noun = mention.thing.noun
            for bearer in (item.thing for item in link.objects if isinstance(item, Mention)):
                own = f"{noun.said} stand"
                if link.relation == "on" and bearer.noun.said == "stand" and own in CATALOGUE:
                    bearer.noun = replace(bearer.noun, words=own, kind=own, guessed="")
            free = CATALOGUE[noun.kind].on_floor and noun.said not in ("lamp", "light", "screen")
            on_wall = f"wall {noun.kind.split()[-1].replace('bookshelf', 'shelf')}"
            standing = place == "wall" and free and link.relation != "above"
            hangs = place == "wall" and link.relation == "above" and not standing
            if hangs and on_wall in CATALOGUE and " " not in noun.said:
                mention.thing.noun = replace(noun, words=on_wall, kind=on_wall)
                continue
            kinds = () if standing or not place else (noun.kind, *noun.others)
            fits = [kind for kind in kinds if place in CATALOGUE[kind].places]
            if noun.others and fits and noun.words in (noun.kind, noun.said):
                words = fits[0] if noun.words == noun.kind else noun.words
                mention.thing.noun = replace(noun, words=words, kind=fits[0], others=())


def _settle_high_stool(link: Link) -> None:
    """Take stools at counters and islands for high ones."""
    if any(isinstance(item, Mention) and item.thing.noun.kind.endswith(small.HIGH) for item in link.objects):
        for thing in (mention.thing for mention in link.subjects if mention.thing.noun.words == "stool"):
            thing.noun = replace(thing.noun, words="bar stool", kind="bar stool", others=())


def _settle_screen(link: Link) -> None:
    """Take a screen that seats stand before for one that is looked at."""
    sat = any(mention.thing.noun.kind.split()[-1] in (*SEATS, "projector") for mention in link.subjects)
    for item in link.objects if sat and link.relation in ("front", "facing", "opposite", "around") else ():
        if isinstance(item, Mention) and item.thing.noun.said == "screen":
            item.thing.noun = replace(item.thing.noun, words=LOOKED_AT, kind=LOOKED_AT, others=())


def _settle_curtain(link: Link) -> None:
    """Take a curtain between things or around one for one that stands."""
    to = any(isinstance(item, Mention) for item in link.objects)
    for thing in (mention.thing for mention in link.subjects if to and link.relation in ("between", "amid", "around")):
        if thing.noun.kind == "curtain":
            thing.noun = replace(thing.noun, words=PARTING, kind=PARTING, others=())


def _settle_low_table(link: Link) -> None:
    """Take a table between armchairs and sofas for a low one."""
    seats = {item.thing.noun.kind.split()[-1] for item in link.objects if isinstance(item, Mention)}
    if link.relation in ("between", "amid") and seats and seats <= small.LOUNGE:
        low = "coffee table" if "sofa" in seats else "side table"
        for thing in (mention.thing for mention in link.subjects if mention.thing.noun.kind in small.TABLES):
            thing.noun = replace(thing.noun, words=low, kind=low, others=())


def _where(link: Link) -> str:
    """Return where a relation puts its subject: "floor", "wall", "ceiling", "object", or "" where it does not matter."""
    to = link.objects[0] if link.objects else None
    if isinstance(to, Place) and to.name in ("corner", "window", "door", "middle"):
        return "floor"
    if isinstance(to, Place) and to.name in ("wall", "ceiling"):
        hung = link.relation in ("on", "hanging", "in")
        return "ceiling" if to.name == "ceiling" else "wall" if hung else "floor" if link.relation == "wall" else ""
    if link.relation == "behind" and all(mention.thing.noun.said == "mirror" for mention in link.subjects):
        return "wall"
    if link.relation == "above":
        wall = isinstance(to, Mention) and to.thing.noun.kind.split()[-1] not in (*TOPS, "chair", "island")
        return "wall" if wall else "ceiling"
    if link.relation == "on" and isinstance(to, Mention):
        return "object" if not CATALOGUE[to.thing.noun.kind].size[2] < 0.03 else "floor"
    if link.relation == "with" and isinstance(to, Mention) and to.thing.noun.kind.split()[-1] in (*BEARING, "stand"):
        return "object"
    if link.relation == "flank" and isinstance(to, Mention) and to.thing.noun.kind.endswith("bed"):
        return ""  # on the night stands
    tiny = isinstance(to, Mention) and CATALOGUE[to.thing.noun.kind].places == ("object",)
    return "object" if tiny and link.relation in small.STANDING else "floor" if link.relation in small.STANDING else ""
