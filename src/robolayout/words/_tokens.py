"""A text as words with their places, and the measures in it: sizes, areas, heights."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass

from robolayout._errors import SceneError

UNITS = {"": 1.0, "m": 1.0, "cm": 0.01, "ft": 0.3048, "in": 0.0254}
_NUMBER_WORDS = (
    "no zero, a an one, two both couple pair twin, three, four, five, six, seven, eight, nine, ten, eleven, twelve dozen, "
    "thirteen, fourteen, fifteen, sixteen, seventeen, eighteen, nineteen, twenty"
)
NUMBERS = {word: value for value, words in enumerate(_NUMBER_WORDS.split(", ")) for word in words.split()} | {
    "some": 2,
    "few": 3,
    "several": 3,
    "lots": 4,
    "many": 4,
    "thirty": 30,
    "forty": 40,
    "fifty": 50,
}
"""Counts by word; what says no exact number stands for a usual one."""

VAGUE = frozenset(("some", "few", "several", "lots", "many"))
"""Words that say no exact number."""

_WORDS = "|".join(word for word in NUMBERS if word not in ("a", "an", "no", *VAGUE))
_N = rf"(\d+(?:[.,]\d+)?|\b(?:{_WORDS})\b)"
_U = r"\s*(metres?|meters?|m\b|cm\b|centimet(?:re|er)s?|feet|foot|ft\b|inches|inch|in\b|['\"])?"
_SIZE = re.compile(rf"{_N}{_U}\s*(?:x|\u00d7|by|\*)\s*{_N}{_U}(?![\w\u00b2]|\s*grid)", re.IGNORECASE)
_SIDES = re.compile(
    rf"{_N}{_U}\s*(?:long|wide|deep)\s*(?:,|and|x|by)+\s*{_N}{_U}\s*(?:wide|long|deep)\b", re.IGNORECASE
)
_GRID = re.compile(
    rf"{_N}\s*(?:x|\u00d7|by)\s*{_N}\s*grid|{_N}\s+rows?\s+(?:and|of|by|x)\s+{_N}\s+columns?", re.IGNORECASE
)
_AREA = re.compile(
    rf"{_N}\s*(m2|m\u00b2|sqm|square met(?:re|er)s?|sq\.? ?m|square (?:feet|foot)|sq\.? ?ft|ft\u00b2|ft2)",
    re.IGNORECASE,
)
_HEIGHT = re.compile(rf"{_N}{_U}\s*(?:high|tall|ceilings?)\b|ceilings?\s*(?:of|at)?\s*{_N}{_U}", re.IGNORECASE)
_APART = re.compile(
    rf"(?:\b(?:(at least|no less than|more than|(?:no|not) (?:closer|nearer) than)|(at most|no more than|up to|less than|within))\s+)?"
    rf"{_N}{_U}\s*(?:apart|(?:away )?from|of|to|(?:of )?(?:(?:free|clear|empty) )?(?:space |distance )?between)\b",
    re.IGNORECASE,
)
APART = 0.3
"""Metres by which what lies between two things may differ from what is said."""

_TOKEN = re.compile(r"[a-z]+-(?:in|mounted|hung)\b|\d+(?:\.\d+)?|[^\W\d_]+(?:'[^\W\d_]+)*|[.;!?:\n]|,|[()]")


@dataclass(frozen=True)
class Measure:
    """A measure of the room."""

    kind: str  # "size", "area", "height", "grid" of things, "apart" or "between": what lies between two
    values: tuple[float, ...]  # metres, square metres, rows and columns, or the least and the most that lies between
    start: int  # first character
    end: int  # character after the last one


@dataclass(frozen=True)
class Token:
    """A word or a mark."""

    text: str  # in lower case, without apostrophes
    start: int  # first character in the text
    end: int  # character after the last one


def tokens(text: str) -> list[Token]:
    """Return the words and marks of a text; "king-size" is two words, "walk-in" is one."""
    lower = text.lower().replace("\u2019", "'")
    if len(lower) != len(text):  # a letter whose small form is longer: places would no longer fit
        lower = "".join(char.lower() if len(char.lower()) == 1 else char for char in text).replace("\u2019", "'")
    found = ((m.span(), re.sub(r"['-]", "", m.group())) for m in _TOKEN.finditer(lower))
    return [Token(word, *span) for span, said in found for word in (("for", "each") if said == "per" else (said,))]


def measures(text: str) -> list[Measure]:
    """Return the measures in a text.

    Raises:
        SceneError: A room of that size cannot be furnished.
    """
    found: list[Measure] = []
    for read in (_grids, _sizes, _areas, _heights, _gaps):
        for measure in read(text):
            if not any(measure.start < other.end and other.start < measure.end for other in found):
                found.append(measure)
    return sorted(found, key=lambda measure: measure.start)


def _grids(text: str) -> Iterator[Measure]:
    for match in _GRID.finditer(text):
        rows, columns = (_number(number) for number in match.groups() if number)
        yield Measure("grid", (rows, columns), match.start(), match.end())


def _sizes(text: str) -> Iterator[Measure]:
    for match in (*_SIZE.finditer(text), *_SIDES.finditer(text)):
        a, unit_a, b, unit_b = match.groups()
        if not (unit_a or unit_b or a[0].isdecimal()):
            continue  # "two by two" says how things stand
        size = (round(metres(a, unit_a, unit_b), 2), round(metres(b, unit_b, unit_a), 2))
        if min(size) < 1.0 or max(size) > 100.0:
            raise SceneError(
                f"a room of {size[0]:g} x {size[1]:g} m (from {match.group().strip()!r}) cannot be furnished; "
                "give 1 to 100 m on each side, for example 4 x 5 m or 13 x 16 ft."
            )
        yield Measure("size", size, match.start(), match.end())


def _areas(text: str) -> Iterator[Measure]:
    for match in _AREA.finditer(text):
        area = _number(match.group(1)) * (0.3048**2 if "f" in match.group(2).lower() else 1.0)
        if not 2.0 <= area <= 5000.0:
            raise SceneError(f"a floor of {area:g} m2 cannot be furnished; give 2 to 5000 m2.")
        yield Measure("area", (area,), match.start(), match.end())


def _heights(text: str) -> Iterator[Measure]:
    for match in _HEIGHT.finditer(text):
        number, unit = (match.group(1), match.group(2)) if match.group(1) else (match.group(3), match.group(4))
        if not unit and match.group(1):
            continue  # "two high tables"
        height = round(metres(number, unit), 2)
        if not 1.8 <= height <= 20.0:
            raise SceneError(f"a ceiling at {height:g} m (from {match.group().strip()!r}) is outside 1.8 to 20 m.")
        yield Measure("height", (height,), match.start(), match.end())


def _gaps(text: str) -> Iterator[Measure]:
    for match in _APART.finditer(text):
        least, most, number, unit = match.groups()
        closer = bool(least) and least.lower().startswith("no") and " than" in least and "less" not in least
        if unit and (most or not match.group().endswith("of")) and closer == match.group().endswith("to"):
            gap = round(metres(number, unit), 2)
            bounds = (0.0 if most else gap, math.inf if least else gap if most else gap + APART)
            kind = "between" if match.group().endswith("between") else "apart"
            yield Measure(kind, bounds, match.start(), match.end())


def metres(number: str, unit: str | None, fallback: str | None = None) -> float:
    """Return a length in metres; without a unit that of `fallback` counts, then metres."""
    word = (unit or fallback or "").lower()
    short = "ft" if word[:1] == "f" or word == "'" else "in" if word in ('"', "in", "inch", "inches") else word[:1]
    short = "cm" if word.startswith("c") else short
    return _number(number) * UNITS.get(short, 1.0)


def _number(text: str) -> float:
    return float(NUMBERS[text.lower()]) if text.lower() in NUMBERS else float(text.replace(",", "."))


def count_of(word: str) -> int | None:
    """Return the number that a word says, None if none."""
    return int(word) if word.isdecimal() else NUMBERS.get(word)
