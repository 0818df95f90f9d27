"""A text as words with their places, and the measures in it: sizes, areas, heights."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass

from robolayout._errors import SceneError

UNITS = {"": 1.0, "m": 1.0, "cm": 0.01, "ce": 0.01, "mm": 0.001, "ft": 0.3048, "in": 0.0254}
_SPELT = [
    "no zero", "a an one", "two both couple pair twin", "three trio", "four", "five", "six", "seven", "eight", "nine", "ten",
    "eleven", "twelve dozen", "thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen", "twenty",
]  # fmt: skip
_TENS = ["thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety", "hundred"]
NUMBERS = (
    {word: value for value, words in enumerate(_SPELT) for word in words.split()}
    | {"some": 2, "few": 3, "several": 3, "lots": 4, "many": 4}
    | {word: 10 * tens for tens, word in enumerate(_TENS, 3)}
)
"""Counts by word; what says no exact number stands for a usual one."""

_MEASURED: Mapping[str, float] = {**NUMBERS, "half a": 0.5, "a couple of": 2.0}
"""The same with what is only said of metres."""

MARKS = {":": "colon", **dict.fromkeys(".;!?\n", "stop"), **dict.fromkeys(",()", "comma")}
"""Kinds of phrases that are marks."""

VAGUE = frozenset(("some", "few", "several", "lots", "many"))
"""Words that say no exact number."""

GROWN, ADULT = 12, 20
CHILDREN = ("child", "kid", "boy", "girl", "son", "daughter")
AFTER_AN_AGE = ("with", "and", "who", "that", "in", "to", "should", "is")
"""Years up to which somebody is a child, and from which on an adult; who is "of six"; words before which an age stands by itself."""

_WORDS = "|".join(word for word in NUMBERS if word not in ("a", "an", "no", *VAGUE))
_N = rf"(\d+(?:[.,]\d+)?|\b(?:{_WORDS})\b|\b(?:(?:half )?an?|a couple of)(?= met(?:re|er)s?\b| foot (?:from|away)\b))"
_INCHES = r"(?:feet|foot|ft|')[ -]?\d+(?:\.\d+)?\s?(?:inches|inch|in\b|''|\")|'\d{1,2}(?!\d)"
_LENGTHS = rf"{_INCHES}|metres?|meters?|m\b|cm\b|mm\b|centimet(?:re|er)s?|feet|foot|ft\b|inches|inch|['\"]"
_U = rf"[\s-]*({_LENGTHS}|in\b)?"
_BY = r"\s*(?:x|\u00d7|by|\*)\s*"
_BLOCK = r"\s*(?:grid|block|formation|arrangement|array|matrix)"
_SIZE = re.compile(rf"{_N}{_U}{_BY}{_N}{_U}(?:{_BY}{_N}{_U})?(?![\w\u00b2]|{_BLOCK})", re.IGNORECASE)
_ACROSS = (
    r"(?:long|wide|deep|across|in (?:length|width|depth)|from (?:front to back|side to side|wall to wall|end to end))"
)
_SIDES = re.compile(rf"{_N}{_U}\s*{_ACROSS}\s*(?:,|and|x|by)+\s*{_N}{_U}\s*{_ACROSS}(?!\w)", re.IGNORECASE)
_GRID = re.compile(
    rf"{_N}\s*(?:x|\u00d7|by)\s*{_N}{_BLOCK}|{_N}\s+rows?\s+(?:and|of|by|x)\s+{_N}\s+columns?", re.IGNORECASE
)
_AREA = re.compile(
    rf"{_N}\s*(m2|m\u00b2|sqm|square met(?:re|er)s?|sq\.? ?m|square (?:feet|foot)|sq\.? ?ft|ft\u00b2|ft2)",
    re.IGNORECASE,
)
_HEIGHT = re.compile(
    rf"{_N}{_U}[\s-]*(?:high|tall|in height|ceilings?)\b|(?:ceilings?(?: height)?|height)\s*(?:of|at|is|:)?\s*{_N}{_U}"
    rf"|(?:no|not) (?:higher|taller) than {_N}{_U}",
    re.IGNORECASE,
)
_HOW = r"[\s-]*(?:in\s+)?(long|wide|deep|across|diameter|(?<=in )(?:length|width|breadth|depth))\b"
_SAME = {"diameter": "across", "length": "long", "width": "wide", "breadth": "wide", "depth": "deep"}
_FLAT = r"(?=\s+(?:\w+\s+)?(?:tv|television|monitor|screen))"
_LENGTH = re.compile(rf"{_N}[\s-]*(?:({_LENGTHS}|in(?={_HOW}|{_FLAT}))(?:{_HOW}|({_FLAT}))?)", re.IGNORECASE)
_APART = re.compile(
    rf"(?:\b(?:(at least|(?:no|not) less than|more than|(?:no|not|none)(?: of them)? (?:closer|nearer) than)"
    r"|(at most|no more than|up to|less than|within))\s+)?"
    rf"(?:(?:between\s+)?{_N}{_U}\s*(?:to|and|or|-|\u2013)\s*)?"
    rf"{_N}{_U}\s*(?:or (more|less)\s+)?(?:(?:of )?(?:(?:free|clear|empty) )?"
    r"(?:space |floor |distance |gap |passage |clearance )?(?:left |kept )?between|"
    r"apart|from (?:each other|one another)|(?:away )?from|off|of|to)\b",
    re.IGNORECASE,
)
Size = tuple[float, float, float]
"""Depth, width and height in metres."""

Said = tuple[str, tuple[float, ...]] | None
"""Kind and values of a measure; None for what is none."""

USUAL = (0.25, 4.0)
"""Least and most by which a thing may be larger than usual."""

APART = 0.3
"""Metres by which what lies between two things may differ from what is said; below a metre that share of it."""

_ITEM = re.compile(
    rf"^[ \t]*\d{{1,2}}[.)](?=\s)|\b\d{{1,2}} ?[-\u2013] ?(?=\d{{1,2}} [a-z]{{3}})"
    rf"|\b(?:\d{{1,2}}|{_WORDS}) (?:to|or) (?=(?:\d{{1,2}}|{_WORDS}) [a-z]{{3}})",
    re.MULTILINE,
)
"""Numbers that count no things: those of a list, and the lesser of two ("2-4 chairs")."""

_TOKEN = re.compile(
    rf"w/o\b|(?:twenty|{'|'.join(_TENS[:-1])})[- ](?:{_WORDS})\b"
    r"|(?:north|south|east|west)[- ]facing(?= (?:\w+ )?(?:window|door|wall))"
    r"|[^\W\d_]+(?='s (?:size|dimensions|measurements|footprint|floor area|floor plan)\b)"  # "the bedroom's size is"
    r"|[a-z]+-(?:in|mounted|hung)\b|\d+(?:\.\d+)?|[^\W\d_]+(?:'[^\W\d_]+)*|[.;!?:\n]|,|[()&+]"
    r"|(?<=\S[ \t])[-\u2013](?= \D)|\u2014|(?<=\w)/(?=\w)|(?<= )/(?= )"
)


_METRES, _FEET = r"met(?:re|er)s?", "feet|foot"
_PARTS = re.compile(
    rf"\b(?:(?P<n>{_WORDS}|\d+) and a half (?P<u>{_METRES}|{_FEET}|m)|(?P<m>an?|{_WORDS}) (?P<v>{_METRES}|{_FEET}) and a half"
    rf"|(?P<k>an?|{_WORDS}|\d+) (?P<w>{_METRES}) (?P<more>ten|twenty|{'|'.join(_TENS[:-1])}|\d\d)"
    r"(?=\s*(?:high|tall|wide|long|deep|across|apart|in\b|off|above|from|of\b|between|[.,;]|$)))(?!\w)",
    re.IGNORECASE,
)
"""Lengths of several words: "one and a half metres", "a metre and a half", "two metres eighty long"."""


@dataclass(frozen=True)
class Measure:
    """A measure of the room or of a thing."""

    # "size", "area", "height"; of a thing "long", "wide", "deep", "across", "diagonal" or "length", where nothing says which;
    # "grid" of things; "apart" or "between": what lies between two
    kind: str
    values: tuple[float, ...]  # metres, square metres, rows and columns, or the least and the most that lies between
    start: int  # first character
    end: int  # character after the last one

    @property
    def shown(self) -> str:
        """The values with their unit."""
        return " x ".join(f"{v:g}" for v in self.values) + {"area": " m2", "grid": ""}.get(self.kind, " m")

    def on(self, size: Size) -> Size:
        """Return the size of a thing with this: along its longest side where nothing says along which.

        >>> Measure("size", (1.6, 0.8), 0, 0).on((0.9, 2.1, 0.8))
        (0.8, 1.6, 0.8)
        """
        depth, width, height = size
        if self.kind == "size":
            low, high = sorted(self.values[:2])
            return (*((high, low) if depth > width else (low, high)), (*self.values, height)[2])
        if self.kind == "diagonal":  # of a screen of 16 to 9
            return depth, round(0.87 * self.values[0], 3), round(0.49 * self.values[0], 3)
        # of what is as deep as wide the width: "an oval table, 3 m long"
        longest = 1 if self.kind == "long" and depth == width else size.index(max(size[: 2 + (self.kind != "long")]))
        axes = {"deep": (0,), "wide": (1,), "height": (2,), "across": (0, 1)}.get(self.kind, (longest,))
        d, w, h = (self.values[0] if axis in axes else side for axis, side in enumerate(size))
        return d, w, h

    def fits(self, size: Size) -> bool:
        """Return whether a thing of a usual size may be so large."""
        return all(USUAL[0] <= new / old <= USUAL[1] for new, old in zip(self.on(size), size, strict=True))

    def of_a_room(self) -> None:
        """Refuse what no room has.

        Raises:
            SceneError: A room of that size cannot be furnished.
        """
        least, most, what, allowed = ROOMS.get(self.kind, (0.0, math.inf, "", ""))
        if not least <= min(self.values) <= max(self.values) <= most:
            raise SceneError(f"{what} {self.shown} {allowed}.")


ROOMS = {
    "size": (1.0, 100.0, "a room of", "cannot be furnished; give 1 to 100 m on each side, for example 4 x 5 m or 13 x 16 ft"),
    "area": (2.0, 5000.0, "a floor of", "cannot be furnished; give 2 to 5000 m2"),
    "height": (1.8, 20.0, "a ceiling at", "is too low or too high; give 1.8 to 20 m")
}  # fmt: skip
"""Least and most that a measure of a room may be, and what is said of others."""


_marks = {"-": ",", "\u2013": ",", "\u2014": ",", "&": "and", "+": "and", "w/o": "without", "apiece": "each"}
_marks |= {"opp": "opposite", "rm": "room", "tbl": "table", "btw": "between", "bdrm": "bedroom", "lg": "large"}
_written = {"per": ("for", "each")} | {
    f"{ns}{ew}": (ns, ew) for ns in ("north", "south") for ew in ("east", "west")
} | {mark: (word,) for mark, word in _marks.items()} | {
    f"{ten}{mark}{one}": (str(NUMBERS[ten] + NUMBERS[one]),)
    for ten in ("twenty", *_TENS[:-1]) for one in _WORDS.split("|") for mark in "- "
} | {f"{who}'{will}": (who, does) for who in ("we", "you", "they") for will, does in (("ll", "will"), ("re", "are"))}  # fmt: skip
"""What some words are read as."""


@dataclass(frozen=True)
class Token:
    """A word or a mark."""

    text: str  # in lower case, without apostrophes
    start: int  # first character in the text
    end: int  # character after the last one
    measure: Measure | None = None  # the length that it stands for, where the text has no figure


def _in_figures(text: str) -> str:
    """Return a text with lengths of several words in figures, in the same places.

    >>> _in_figures("a metre and a half apart").split()
    ['1.5', 'm', 'apart']
    """
    return _PARTS.sub(lambda match: _figures(match).ljust(len(match.group())), text)


def _figures(match: re.Match[str]) -> str:
    number, unit = next((match[n], match[u]) for n, u in ("nu", "mv", "kw") if match[n])
    more = _number(match["more"]) / 100.0 if match["more"] else 0.5
    return f"{_number(number) + more:g} {'ft' if unit.lower().startswith('f') else 'm'}"


def tokens(text: str) -> list[Token]:
    """Return the words and marks of a text; "king-size" is two words, "walk-in" is one."""
    lower = text.lower().replace("\u2019", "'")
    if len(lower) != len(text):  # a letter whose small form is longer: places would no longer fit
        lower = "".join(char.lower() if len(char.lower()) == 1 else char for char in text).replace("\u2019", "'")
    lower = _ITEM.sub(lambda match: " " * len(match.group()), _in_figures(lower))
    found = ((m.span(), _written.get(m.group(), (re.sub("[' -]", "", m.group()),))) for m in _TOKEN.finditer(lower))
    return _counted([Token(word, *span) for span, said in found for word in said])


def _counted(words: list[Token]) -> list[Token]:
    """Return the words of a text with numbers of several words in one: "half a dozen", "a family of four", "seating ten"."""
    found, at = list[Token](), 0
    while at < len(words):
        text = [word.text for word in words[at : at + 4]] + [""] * 4
        first, second = (count_of(word) for word in text[:2])
        more: tuple[int, list[str]] = (1, text[:1])
        if text[:3] == ["half", "a", "dozen"]:
            more = (3, ["6"])
        elif text[1] == "dozen" and first:
            more = (2, [str(12 * first)])
        elif text[:3] == ["a", "family", "of"] and count_of(text[3]):
            more = (4, [text[3], "people"])
        elif text[0] == "seating" and second:
            more = (1, ["for"])
        elif first and text[0].isdecimal() and text[1] in ("seat", "seater") and first < len(_SPELT):
            more = (2, [_SPELT[first].split()[0], "seater"])  # "a 3 seat sofa"
        elif text[0] == "/" and found and text[1] and found[-1].end < words[at].start < words[at + 1].start - 1:
            more = (1, [";"])  # "bed under window / desk right of bed"
        elif text[0] == "/":  # "sofa/armchair/lamp", but "a sofa/bed"
            more = (1, ["and"] if len(found) < 2 or found[-2].text not in ("a", "an", "the", "one", "/") else [])
        elif (aged := _aged(text)) is not None:
            more = aged
        start, end = words[at].start, words[at + more[0] - 1].end
        found += [Token(word, start, end) for word in more[1]]
        at += more[0]
    return found


def _aged(text: list[str]) -> tuple[int, list[str]] | None:
    """Return how many of some words say how old somebody is, and who is: "six-year-old", "a boy of six", "aged 9"; None if none do."""
    first, second, third = (count_of(word) or 0 for word in text[:3])
    if first and text[1:3] == ["year", "old"]:  # "for a six-year-old", "for a 70-year-old woman"
        alone = not text[3].isalpha() or text[3] in AFTER_AN_AGE
        return 3, ["child" if first <= GROWN else "teenager" if first < ADULT else "person"] * alone
    if text[0] in ("age", "aged") and 0 < second < ADULT:  # "for my son, aged 9"
        return 2, [",", "child" if second <= GROWN else "teenager", ","]
    return (3, [text[0]]) if text[0] in CHILDREN and text[1] == "of" and 0 < third <= GROWN else None


def measures(text: str) -> list[Measure]:
    """Return the measures in a text; of those that overlap the first that is looked for."""
    found, text = list[Measure](), _in_figures(text)
    for pattern, read in _READERS:
        for match in pattern.finditer(text):
            start, end = match.span()
            if (said := read(match)) and not any(start < other.end and other.start < end for other in found):
                found.append(Measure(*said, start, end))
    return sorted(found, key=lambda measure: measure.start)


def _grid(match: re.Match[str]) -> Said:
    rows, columns = (_number(number) for number in match.groups() if number)
    return "grid", (rows, columns)


def _size(match: re.Match[str]) -> Said:
    said = [(match.group(i), match.group(i + 1)) for i in range(1, len(match.groups()), 2) if match.group(i)]
    unit = next((unit for _, unit in reversed(said) if unit), None)
    if not unit and not said[0][0][0].isdecimal():
        return None  # "two by two" says how things stand
    if not unit:  # "a desk (120x60)"
        largest = max(_number(number) for number, _ in said)
        unit = next((short for least, short in BARE if largest >= least), "m")
    return "size", tuple(round(metres(number, own, unit), 2) for number, own in said)


def _area(match: re.Match[str]) -> Said:
    return "area", (_number(match.group(1)) * (0.3048**2 if "f" in match.group(2).lower() else 1.0),)


def _height(match: re.Match[str]) -> Said:
    number, unit = next(match.group(i, i + 1) for i in (1, 3, 5) if match.group(i))
    plain = match.group(1) and not unit  # "two high tables"
    return None if plain else ("height", (round(metres(number, unit), 2),))


def _length(match: re.Match[str]) -> Said:
    number, unit, _, how, flat = match.groups()
    kind = "diagonal" if flat is not None else _SAME.get(how.lower(), how.lower()) if how else "length"
    return kind, (round(metres(number, unit), 3),)


def _gap(match: re.Match[str]) -> Said:
    least, most, first, own, number, unit, over = match.groups()
    least, most = least or ("at least" if over == "more" else None), most or ("at most" if over == "less" else None)
    closer = bool(least) and least.lower().startswith("no") and " than" in least and "less" not in least
    if not unit or (not most and match.group().endswith("of")) or closer != match.group().endswith("to"):
        return None
    gap = round(metres(number, unit), 2)
    low = round(metres(first, own, unit), 2) if first else 0.0 if most else gap
    bounds = (low, math.inf if least else gap if most or first else about(gap))
    return "between" if match.group().endswith("between") else "apart", bounds


def about(gap: float) -> float:
    """Return the most metres that lie between two things of which so many are said."""
    return round(gap + APART * min(gap, 1.0), 2)


BARE = ((1000.0, "mm"), (100.0, "cm"))
"""From which figure on a size without a unit is one in millimetres, and in centimetres."""

_READERS = (
    (_GRID, _grid), (_SIZE, _size), (_SIDES, _size), (_AREA, _area), (_HEIGHT, _height), (_APART, _gap), (_LENGTH, _length),
)  # fmt: skip
"""What measures look like, and how each is read."""


def metres(number: str, unit: str | None, fallback: str | None = None) -> float:
    """Return a length in metres; without a unit that of `fallback` counts, then metres."""
    word = (unit or fallback or "").lower()
    if (more := re.match(r"(?:f\w+|')[ -]?([\d.]+)", word)) and unit:  # 10'6"
        return metres(number, "ft") + metres(more.group(1), "in")
    short = "ft" if word[:1] == "f" or word == "'" else "in" if word in ('"', "in", "inch", "inches") else word[:1]
    short = word[:2] if word.startswith(("c", "mm")) else short
    return _number(number) * UNITS.get(short, 1.0)


def _number(text: str) -> float:
    known = _MEASURED.get(text.lower())
    return float(text.replace(",", ".")) if known is None else float(known)


def count_of(word: str) -> int | None:
    """Return the number that a word says, None if none."""
    return int(word) if word.isdecimal() else NUMBERS.get(word)
