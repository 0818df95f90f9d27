"""Phrases in words that the parser knows: "a wheelchair can reach both sides of the bed" asks for free floor there."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import accumulate

from robolayout.words._tokens import Measure, Token, measures

METRES = {"WIDTH": 0.0, "TURNING": 1.5}
"""Metres of free floor by the word of a rule: as much as the body needs to pass (0), or a wheelchair to turn round (ISO 21542)."""

_MUST = r"(?:can|could|must|should|has to|have to|needs to)"
_PARTS = {
    "WIDE": "(?:(?:of |at )?(?:at least |no less than |about |a minimum of |minimum ))?(LENGTH)(?: wide| in width)?",
    "PATHS": "(?:FREE )?(?:main |central )?(?:path|walkway|way|passage|passageway|pathway|route|corridor)s?",
    "LEADS": r"(?:from|to|between)(?: (?!is|are|must|should)\w+){1,12}?",
    "SPINS": r"SPIN(?: (?:in|at|near|by|next to|close to|inside|before|in front of)(?= (?:the|its) (?:middle|cent|door|entrance|window)))?",
    "SPIN": "turning (?:circle|space|area)s?",
    "OPENS": r"ABLE (?:be opened|open)(?: (?:fully|freely|completely|wide))*(?: without \w+ing(?: into)? (?:the|my) \w+)?",
    "ABLE": rf"(?:{_MUST}(?: be able to)?|(?:is|are) able to)(?: (?:easily|always|still|also|safely))?",
    "BE": rf"(?:(?:is|are|stays?|remains?|{_MUST} be) (?:easily |always |still )?)?(?:reachable|reached|accessible|accessed)",
    "GO": r"(?:get|walk|drive|roll|move|go|come|pass|travel)(?: (?:freely|easily|straight|directly|right|over|up|all the way))*",
    "THING": r"ONE (?!door|window)(?:(?!of|from|to|in|on|and|with|is|are|can)\w+ ){0,3}?\w+",
    "SIDES": r"(?:both|each|either|all) sides?|(?:the|its) (?:left|right)(?: (?:hand )?side)?",
    "LENGTH": r"(?:\d[\d.]*|one|two|three|four|five) (?:m|cm|mm|met(?:re|er)s?|centimet(?:re|er)s?|feet|foot|ft|inch|inches)",
    "LEAVE": r"(?:leav(?:e|ing)|keep(?:ing)?|allow(?:ing)?|provid(?:e|ing)|needs?)(?: (?:me|at least|about|around|the|some|enough))*",
    "FREE": r"(?:free|clear|open|empty|unobstructed)",
    "SPACE": r"(?:space|room|floor|area)",
    "ENOUGH": r"(?:enough|plenty of|sufficient|adequate|some)",
    "PERSON": r"(?:i|we|you|he|she|they|one|people|someone|somebody)",
    "WHO": r"for (?:a|the|my|his|her|their) (?:\w+ )?\w+",
    "WORDS": r"(?:\w+ ){0,2}?\w+(?: (?:straight|directly))?",
    "MUSTS": rf"(?:(?:that|which) )?(?:is|are|being|stays?|remains?|{_MUST} (?:all )?be)",
    "MANY": r"(?:[3-9]|1\d|three|four|five|six|seven|eight|nine|ten|twelve)",
    "FEW": r"(?:\w+ ){0,2}\w+",
    "ROBOT": r"(?:\w+ ){0,2}(?:robot(?: dog| vacuum)?|roomba|amr|humanoid|quadruped|cleaner)",
    "WILL": rf"(?:will|shall|{_MUST}(?: be able to)?)",
    "END": r"(?= (?:[.,;:!?\n]|and|so)(?: |$)|$)",
}  # fmt: skip
_PARTS["AT"] = (
    rf"(?:in front of|behind|around|beside|alongside|next to|at the foot of|(?:on|at|to) (?:{_PARTS['SIDES']}) of)"
    r"(?= ONE (?!door|window)| it\b| them\b)"
)
_PARTS["ONE"] = r"(?:the|each|every|my|his|her|their|both|all|its)"
_GETS = "ABLE (?:reach|access|approach|use|GO to)"
_ROOM = "(?:ENOUGH )?(?:FREE )?SPACE"
_SAID = {
    r"(?:humanoid(?: robot)? \( )?unitree g 1(?: \))?": "humanoid robot",
    r"(room|dorm|dormitory|hall|hallway|corridor|cabin|pantry|office|closet|cellar|shop|store|warehouse|library|garage|lab|ward|barracks) "
    r"with (FEW) on one side and (FEW) on the other(?: side)?END": "{1} with {2} along one wall and {3} along the opposite wall",
    "under (?:the|a) (?:slop(?:ed|ing)|slant(?:ed|ing)|pitched) (?:ceiling|roof|wall)": "( unreadable )",
    "(in an? (?:u|horseshoe)(?: shape)?) ,(?: and)? ((?:the|a) FEW) (?:in|at) the opening(?: of the (?:u|horseshoe))?": "{1} facing {2}",
    "at (?:its|the) (left|right) end(?! of)": "to the {1} of it",
    "on its (bottom|lowest|lower|second|third|fourth|top|upper|highest) shelf": "on the {1} shelf of it",
    "on the top shelf": "on the highest shelf",
    "on its shelves": "on the shelves of it",
    "at (?:the|its) (left|right) end of": "to the {1} of",
    r"(speakers?|guitars?|violins?|cellos?|(?:mountain |road )?bikes?|bicycles?) on (?:an? |their |its )?(?:\w+ )?stands?(?! lamp)": "{1}",
    "(each|every) wall (?:except|but|apart from)(?: for| on)? (?:the )?(?:one|wall) with (?:the|a) (?:door|window)s?": (
        "{1} wall ( unreadable )"
    ),
    r"(MANY|two) (?:curved|staggered) rows of ((?:\w+ ){0,2}\w+s)": "{1} rows of {2} ( unreadable )",
    "(?:, )?(?:across|with|and|separated by) (?:an? )?(?:\\w+ )?aisle (?:of )?WIDE(?: between (?:the (?:two )?(?:columns|rows)|them))?": (
        ", with {1} aisles"
    ),
    "(?:a|the) dance floor in the (?:middle|center|centre)(?: of the (?:room|hall))?": "the middle of the room free",
    "(?:beside|next to|alongside) (THING) on (SIDES)": "on {2} of {1}",
    "WIDE between (THING) and the walls? on (SIDES)": "{1} of free space on {3} of {2}",
    rf"{_GETS} (SIDES) of": "can ; WIDTH of free space on {1} of",
    rf"{_GETS} (THING) from (SIDES)": "can ; WIDTH of free space on {2} of {1}",
    "ABLE get (?:in and )?out of (?:the )?bed (?:on|from|at) (SIDES)": "can ; WIDTH of free space on {1} of the bed",
    "BE from (SIDES)": "with WIDTH of free space on {1}",
    r"(?:(?:that|which) )?PERSON ABLE (?:get|climb) in(?:to)?(?: it)? (?:from|on|at) (SIDES)": "with WIDTH of free space on {1}",
    r"classroom for (FEW) (pupils|students|children) in (\w+) rows(?: ,)? with": "classroom for {1} {2} with {1} desks in {3} rows and",
    r"classroom for (FEW) (pupils|students|children) in (\w+) rows": "classroom for {1} {2} with {1} desks in {3} rows",
    "ABLE GO (from (?:the|my) WORDS) to": "can ; a way {1} to",
    "ABLE GO (around|behind)(?= THING)": "can ; WIDTH of free space {1}",
    r"(?:so (?:that )?)?(?:(?:the|a|an) \w+|PERSON) ABLE GO (around) (it|them)END": "with WIDTH of free space {1} {2}",
    "(?:(?:that|which) )?PERSON ABLE (?:reach|access|use|get to)END": "within reach of people",
    r"(?:keep|leave) (?:the |an? |any |all )?(\w+) out(?: of (?:it|here|there|(?:the|this) room))?END": "; no {1}",
    "(?:hand )?tools (?:(?:hanging|hung|arranged|organi[sz]ed|mounted) )?on (an?|the) (peg ?board|tool wall)": "{1} {2}",
    "(peg ?board|tool wall) (?:with|full of|for) (?:hand )?tools": "{1}",
    "forms? (?:a|the) (?:work(?:ing)? )?triangle(?: ,)?": "( unreadable ) ;",
    r"between (?:neighbou?ring|adjacent|adjoining) (\w+s)": "between each {1}",
    "on the outside(?: of (?:it|the u|the tables))?": "around them",
    "(?:,(?: and)? )?with the (?:back|rear|second) row (?:raised|elevated|on a (?:platform|riser))(?: and)?": "( unreadable ) ,",
    "with (?:some |enough |free |plenty of )?(?:space|room) on (SIDES)": "with WIDTH of free space on {1}",
    "(?:rolling )?table (?:on (?:wheels|casters) )?over (?:the|his|her) bed": "overbed table by the bed",
    "(shop|store) for (shoes|books|clothes|toys)(?= with)": "{2} {1}",
    "on the wall (?:to|on) the (left|right)(?! of)": "on the {1} wall",
    "(an? ROBOT) (?:WILL )?(?:patrols?|cleans?|works? in|moves? (?:around |freely )?in|navigates?|drives? (?:around|through)) "
    r"(?:this|the|an?|my|our) (\w+(?: room)?)(?= with)": "a {2} for {1}",
    "(?:two|2) double rows": "4 rows back to back in pairs",
    "(?:three|3) double rows": "6 rows back to back in pairs",
    "double rows": "rows back to back in pairs",
    "(?:four|4) (FEW) in a square(?! around)": "4 {1} in two rows",
    "ABLE (?:get|drive|go|fit|pass|move|clean|crawl) (?:under|underneath|beneath)(?= ONE )": "can ; way under",
    "ABLE turn(?: a?round)? (AT)": "can ; TURNING of free space {1}",
    f"{_GETS} (?:everything|every (?:piece of furniture|corner)|all (?:of )?(?:the )?furniture)": "can ; WIDTH path to ;",
    f"{_GETS}(?= ONE )": "can ; a way to",
    "ABLE (?:park|stop|stay|transfer) (AT)": "can ; WIDTH of free space {1}",
    "ABLE (?:reach|touch) from(?= THING)": "near",
    "ABLE (?:see|watch) ((?:the|my) WORDS) from ((?:the|my) WORDS)": "can ; {2} faces {1}",
    r"(?:an? |the )?\w+ sitting (?:on|in|at) ((?:the|my) WORDS) ABLE (?:see|watch) ((?:the|my) WORDS)": "; {1} faces {2}",
    "((?:the|my) (?:door|window|entrance)) (?:is|must be|should be) (?:visible|seen) from ((?:the|my) WORDS)": "; {2} faces {1}",
    r"no (?:\w+ ){1,3}(?:should|must|may) (?:have|sit with|stand with) (?:its|their) backs? (?:to|towards) the \w+": "unreadable",
    "leaving(?= (?:at least |about |around )?LENGTH between )": "with",
    "(?:that|which) (?:is|are) (?:reachable|accessible|usable) (?:by|to|for|with)(?= (?:a|an|the|my) )": "for",
    "(THING) BE from(?= the door)": "; a way to {1} from",
    "(THING) BE(?: (?:by|to|for|with)(?= (?:a|an|the|my) )|END)": "; a way to {1} ; for",
    "LEAVE (LENGTH)(?: (?:of|clearance|FREE|SPACE))* (AT THING)(?: FREE)?END": "; {1} of free space {2}",
    "(ONE WORDS) (?:doors?|drawers) OPENS": "; WIDTH of free space in front of {1}",
    "(?:the )?(?:doors?|drawers) of (THING) OPENS": "; WIDTH of free space in front of {1}",
    "LEAVE SPACE (AT THING) FREEEND": "; WIDTH of free space {1}",
    rf"{_ROOM} to turn(?: a?round)? (AT)": "TURNING of free space {1}",
    rf"{_ROOM} to (?:GO|stand|transfer|park)(?: \w+)? (AT)": "WIDTH of free space {1}",
    rf"{_ROOM} (WHO) (AT)": "{1} , WIDTH of free space {2}",
    "(?:ENOUGH (?:FREE )?|FREE )SPACE (AT)": "WIDTH of free space {1}",
    "(?:an? )?WIDE (?:of )?SPIN (AT)": "{1} of free space {2}",
    "(?:an? )?SPIN of WIDE (AT)": "{1} of free space {2}",
    "(?:an? |the )?SPIN (AT)": "TURNING of free space {1}",
    "(?:an? )?WIDE (?:of )?SPINS": ", {1} of floor to turn",
    "(?:an? )?SPIN (?:of|with) WIDE(?: (?:in )?diameter)?(?: in(?= the (?:middle|cent)))?": ", {1} of floor to turn",
    "(?:an? |the )?SPINS": ", TURNING of floor to turn",
    "(?:LEAVE )?(?:an? |the )?PATHS (?:of )?WIDE(?= (?:from|to|between) )": "; {1} path",
    "(?:an? |the |all |any )*PATHS (LEADS) MUSTS WIDE": "; {2} path {1}",
    "(?:LEAVE )?(?:an? )?WIDE PATHS(?= (?:from|to|between) )": "; {1} path",
    "(?:and )?(?:with )?(?:LEAVE )?(?:an? |all |the |any |every )*PATHS (?:MUSTS )?(?:of )?WIDE"
    "(?: (?:in between|between them))?(?:END|(?= for ))": "; {1} path to ;",
    "LEAVE WIDE to (?:walk|pass|get by|move|go|roll)(?: through| by| past| around)?END": "; {1} path to",
    "(?:LEAVE )?(?:an? )?WIDE PATHSEND": "; {1} path to",
    "(?:PATHS|aisles?) (?:(?:that|which) (?:is|are) )?wide enough for(?= (?:a|an|the|my) )": "; WIDTH path to ; for",
    r"(?:all |the )*aisles? (?:between (?:ONE )?(?:(?!must|should|are|is)\w+ )?\w+(?: MUSTS)?|MUSTS) WIDEEND": "{1} aisles",
    "(?:the |an? |my )?(?:(?:emergency|fire|main|front) )?((?:exit|door|entrance|doorway)s?)(?: door)? "
    "(?:must|should|has to|needs to) (?:always )?(?:stay|remain|be kept|be) (?:FREE|accessible)": "; nothing in front of the {1}",
    r"(?:turned|rotated|angled|tilted|swivelled)(?: by)?(?: \d+ degrees?)? (?:towards?|to face)": "facing",
    "at one end and ((?:a |an |the )?WORDS) at the (?:other|other end|opposite end)": "on the left and {1} on the right",
    "(in an? (?:u|horseshoe|semicircle|half circle)(?: shape| formation)?) open(?:ing)?(?: up)? (?:to|towards?)": "{1} facing",
    r"an? (?:second|third|fourth|further|additional|extra)(?= (?!of\b|floor|story|storey)\w)": "another",
    "(at|in|to) the (front|back|rear) (left|right)(?! (?:corner|wall|side|half|of (?!the room)))": "{1} the {3} {2}",
    "in the open (middle|center|centre)": "in the {1}",
    "the (?:far|farthest|furthest) (corner|wall|end) from(?= (?:the|my) (?:door|entrance|window))": "the {1} far from",
    r"an? (u|horseshoe) shaped (?:arrangement|layout|formation|set up|setup|configuration) of (FEW)(?= for |END)": "{2} in a {1}",
    "parallel(?= (?:rows|lines|columns) of )": "",
    "(MANY FEW) in parallel(?! (?:to|with) (?!each|one))(?: (?:to|with) (?:each other|one another))?": "{1} in rows",
    r"(MANY) parallel (\w+) with WIDE between them": "{1} {2} in {1} rows with {3} aisles",
    "(MANY) parallel (FEW)END": "{1} {2} in rows",
    "so (?:that )?an? WIDE (?:robot|cart|trolley|body) (?:can|could) (?:pass|fit|drive|get|move)"
    "(?: (?:through|by|past|between))?END": "; {1} path to",
    "as (?:obstacles|decorations?|seats|storage)(?= (?:in|on|at|near|by|along|and|,|[.])|$)": "",
    r"(; (?:a way|way under|\S+ path) [^.;]*?) and to(?= ONE )": "{1} and",
    r"(; (?:a way|way under|\S+ path) [^.;,]*?) ,(?= ONE (?:[^.;,]+ , ONE )*[^.;,]+ and ONE )": "{1} and",
}
"""Phrases, and what is said in their place; groups stay as they are."""


def _compiled(phrase: str) -> re.Pattern[str]:
    for name, part in _PARTS.items():
        phrase = phrase.replace(name, part)
    return re.compile(rf"(?<!\S)(?<!of ){phrase}(?!\S)")


_RULES = tuple(
    (_compiled(phrase), said.split(), "LENGTH" in phrase or "WIDE" in phrase) for phrase, said in _SAID.items()
)


def reworded(words: list[Token]) -> list[Token]:
    """Return the words of a text with such phrases as the parser knows them, each in the place of what it stands for."""
    for rule, said, figures in _RULES:
        starts = [0, *accumulate(len(word.text) + 1 for word in words)]
        for match in reversed([*rule.finditer(" ".join(word.text for word in words))]):
            spans = [slice(*(bisect_left(starts, at) for at in span)) for span in match.regs if span[0] >= 0]
            words = [*words[: spans[0].start], *_put(said, words, spans, figures=figures), *words[spans[0].stop :]]
    return words


def _put(said: Sequence[str], words: Sequence[Token], spans: Sequence[slice], *, figures: bool) -> Iterator[Token]:
    """Yield what is said instead of a phrase whose groups are at some places among the words.

    It stands for the whole phrase; where that has `figures`, which are found by their places, for nothing of it.
    """
    at, end = words[spans[0].start].start, words[spans[0].stop - 1].end
    last = max((i for i, word in enumerate(said) if word.startswith("{")), default=-1)
    for i, word in enumerate(said):
        if word.startswith("{"):
            group = words[spans[int(word[1])]]
            figured = figures and group[0].text not in ("the", "a")
            if figured and (told := measures(" ".join(one.text for one in group))):  # one token with its measure
                first, beyond = group[0], group[-1].end
                group = [replace(first, end=beyond, measure=replace(told[0], start=first.start, end=beyond))]
            yield from group
            at = group[-1].end if figures else at
        else:
            meant = Measure("length", (METRES[word],), at, at) if word in METRES else None
            there = (end, end) if figures and i > last >= 0 else (at, at if figures else end)
            yield Token(word.lower(), *there, meant)
