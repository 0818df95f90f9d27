"""Reads the words of a sentence: room, size, body, things and counts."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from robolayout._errors import SceneError
from robolayout.assets import CATALOGUE, Category, find_category
from robolayout.assets.lexicon import singular
from robolayout.words.rooms import Rooms, RoomType

LONGEST = 2000
"""Characters of a sentence that are read."""

MOST_OF_A_KIND = 200
"""Largest count that is furnished for."""

UNITS = {"": 1.0, "m": 1.0, "cm": 0.01, "ft": 0.3048, "in": 0.0254}
_NUMBER_WORDS = (
    "no, a an one, two both couple pair, three, four, five, six, seven, eight, nine, ten, eleven, twelve dozen, thirteen, "
    "fourteen, fifteen, sixteen, seventeen, eighteen, nineteen, twenty"
)
NUMBERS = {word: value for value, words in enumerate(_NUMBER_WORDS.split(", ")) for word in words.split()} | {
    "some": 2,
    "few": 3,
    "several": 3,
    "lots": 4,
    "many": 4,
    "thirty": 30,
}
PEOPLE = "people persons guests pupils students children kids patients colleagues employees players adults friends workers visitors"
YOUNG = ("children", "kids")
_ANY_NUMBER, _ANY_PEOPLE = "|".join(NUMBERS), PEOPLE.replace(" ", "|")
FILLERS = frozenset(
    [
        "a",
        "an",
        "the",
        "for",
        "with",
        "and",
        "or",
        "of",
        "in",
        "on",
        "at",
        "to",
        "by",
        "is",
        "are",
        "it",
        "that",
        "which",
        "where",
        "who",
        "from",
        "into",
        "small",
        "large",
        "big",
        "tiny",
        "huge",
        "cosy",
        "cozy",
        "modern",
        "bright",
        "calm",
        "quiet",
        "room",
        "please",
        "make",
        "me",
        "i",
        "we",
        "want",
        "would",
        "like",
        "need",
        "there",
        "should",
        "be",
        "has",
        "have",
        "my",
        "our",
        "some",
        "user",
        "users",
        "used",
        "square",
        "long",
        "narrow",
        "nice",
        "simple",
        "comfortable",
        "shaped",
        "shape",
        "l",
        "plus",
        "also",
        "as",
        "one",
        "person",
        "per",
        "each",
        "their",
        "his",
        "her",
        "its",
        "high",
        "ceiling",
        "by",
        "wide",
        "deep",
        "meters",
        "metres",
        "feet",
        "family",
        "open-plan",
        "s",
    ]
)
_NUMBER = r"(\d+(?:[.,]\d+)?)"
_UNIT = r"\s*(metres?|meters?|m|cm|centimet(?:re|er)s?|feet|foot|ft|inches|inch|in|['\"])?"
_SIZE = re.compile(rf"{_NUMBER}{_UNIT}\s*(?:x|\u00d7|by|\*)\s*{_NUMBER}{_UNIT}(?![\w²])", re.IGNORECASE)
_AREA = re.compile(
    rf"{_NUMBER}\s*(m2|m²|sqm|square met(?:re|er)s?|sq\.? ?m|square (?:feet|foot)|sq\.? ?ft|ft²|ft2)", re.IGNORECASE
)
_HEIGHT = re.compile(
    rf"{_NUMBER}{_UNIT}\s*(?:high|tall|ceilings?)|ceilings?\s*(?:of|at)?\s*{_NUMBER}{_UNIT}", re.IGNORECASE
)


@dataclass(frozen=True)
class Wish:
    """One kind of thing that was asked for."""

    category: str
    count: int


@dataclass(frozen=True)
class Wishes:
    """What a sentence says.

    Attributes:
        room_type: Name of the room type.
        size: Width and depth in metres, if given.
        area: Floor area in m2, if given.
        height: Wall height in metres, if given.
        shape: "rectangular" or "L-shaped".
        square: Whether it asks for a square room.
        agent: Name of the body, if one is named.
        people: Number of people, 0 if none is given.
        children: Whether these are children.
        seats: Seats at each table, 0 if none are given.
        things: What is wished.
        unwanted: Categories that must not be added.
        ignored: Words without a meaning here.
    """

    room_type: str
    size: tuple[float, float] | None
    area: float | None
    height: float | None
    shape: str
    square: bool
    agent: str | None
    people: int
    children: bool
    seats: int
    things: tuple[Wish, ...]
    unwanted: frozenset[str]
    ignored: tuple[str, ...]


def read_wishes(text: str, rooms: Rooms, own: tuple[Category, ...] = ()) -> Wishes:
    """Return what a sentence says.

    Args:
        text: The sentence.
        rooms: The room types, bodies and corners that are known.
        own: Categories of the user's own.

    Raises:
        SceneError: It is empty, names no room type, or its figures make no sense.
    """
    if not text.strip():
        raise SceneError('the sentence is empty; say for example "a bedroom for two with a desk, 4 x 5 m".')
    rest = " " + " ".join(text[:LONGEST].lower().replace("\u2019", "'").replace("\u201d", '"').split()) + " "
    size, rest = _read_size(rest)
    area, rest = _read_area(rest)
    height, rest = _read_height(rest)
    shape = "L-shaped" if re.search(r"\bl[- ]?shaped?\b", rest) else "rectangular"
    square = bool(re.search(r"\bsquare\b", rest))
    rest = re.sub(r"\bl[- ]?shaped?\b", " ", rest)
    room, rest = _read_room(rest, rooms.rooms)
    seats, rest = _read_seats(rest)
    people, rest = _read_people(rest)
    agent, rest = _read_agent(rest, people, rooms.agents)
    rest, corners = _read_corners(rest, rooms.corners)
    things, unwanted, ignored = _read_things(rest, rooms.rooms[room], own)
    return Wishes(
        room_type=room,
        size=size,
        area=area,
        height=height,
        shape=shape,
        square=square,
        agent=agent,
        people=people[0],
        children=people[1] in YOUNG,
        seats=seats,
        things=(*corners, *things),
        unwanted=frozenset(unwanted),
        ignored=tuple(ignored),
    )


def _metres(number: str, unit: str | None, fallback: str | None = None) -> float:
    word = (unit or fallback or "").lower()
    short = "ft" if word[:1] == "f" or word in ("'",) else "in" if word in ('"', "in", "inch", "inches") else word[:1]
    short = "cm" if word.startswith("c") else short
    return float(number.replace(",", ".")) * UNITS.get(short, 1.0)


def _read_size(text: str) -> tuple[tuple[float, float] | None, str]:
    match = _SIZE.search(text)
    if match is None:
        return None, text
    a, unit_a, b, unit_b = match.groups()
    size = (round(_metres(a, unit_a, unit_b), 2), round(_metres(b, unit_b, unit_a), 2))
    if min(size) < 1.0 or max(size) > 100.0:
        raise SceneError(
            f"a room of {size[0]:g} x {size[1]:g} m (from {match.group().strip()!r}) cannot be furnished; "
            "give 1 to 100 m on each side, for example 4 x 5 m or 13 x 16 ft."
        )
    return size, text[: match.start()] + " , " + text[match.end() :]


def _read_area(text: str) -> tuple[float | None, str]:
    match = _AREA.search(text)
    if match is None:
        return None, text
    feet = "f" in match.group(2).lower()
    area = float(match.group(1).replace(",", ".")) * (0.3048**2 if feet else 1.0)
    if not 2.0 <= area <= 5000.0:
        raise SceneError(f"a floor of {area:g} m2 cannot be furnished; give 2 to 5000 m2.")
    return area, text[: match.start()] + " , " + text[match.end() :]


def _read_height(text: str) -> tuple[float | None, str]:
    match = _HEIGHT.search(text)
    if match is None:
        return None, text
    number, unit = (match.group(1), match.group(2)) if match.group(1) else (match.group(3), match.group(4))
    height = round(_metres(number, unit), 2)
    if not 1.8 <= height <= 20.0:
        raise SceneError(f"a ceiling at {height:g} m (from {match.group().strip()!r}) is outside 1.8 to 20 m.")
    return height, text[: match.start()] + " , " + text[match.end() :]


def _read_room(text: str, rooms: Mapping[str, RoomType]) -> tuple[str, str]:
    words = sorted(((word, name) for name, room in rooms.items() for word in room.words), key=lambda w: -len(w[0]))
    found = [(match.start(), -len(word), word, name) for word, name in words if (match := _find(word, text))]
    if not found:
        raise SceneError(f"the sentence names no room; known room types: {', '.join(sorted(rooms))}.")
    whole = [entry for entry in found if not any(o is not entry and entry[2] in o[2] for o in found)]
    _, _, word, name = min(whole)
    return name, _cut(text, word)


def _find(word: str, text: str) -> re.Match[str] | None:
    return re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", text)


def _cut(text: str, word: str) -> str:
    return re.sub(rf"(?<![\w-]){re.escape(word)}(?![\w-])", " , ", text)


def _count(word: str) -> int | None:
    return int(word) if word.isdecimal() else NUMBERS.get(word)


def _read_seats(text: str) -> tuple[int, str]:
    """Return how many sit at each table ("six tables for two"), and the text without that."""
    match = re.search(rf"(\btables?) (?:for|seating) (\d+|{_ANY_NUMBER})\b(?: (?:{_ANY_PEOPLE})\b)?", text)
    if match is None:
        return 0, text
    return _bounded(_count(match.group(2)) or 0, "seats"), text[: match.end(1)] + " , " + text[match.end() :]


def _read_people(text: str) -> tuple[tuple[int, str], str]:
    """Return how many people of which kind, and the text without them."""
    for pattern, kind in (
        (rf"\b(\d+|{_ANY_NUMBER})\s+(?:\w+\s+)?({_ANY_PEOPLE})\b", ""),
        (rf"\bfamily of (\d+|{_ANY_NUMBER})\b", "people"),
        (r"\bfor a (couple)\b", "people"),
        (rf"\bfor (\d+|{_ANY_NUMBER})\b(?=\s*(?:[,;.!?]|with\b|and\b|in\b|$))", "people"),
    ):
        match = re.search(pattern, text)
        if match is not None:
            kind = kind or match.group(2)
            count = _bounded(_count(match.group(1)) or 0, kind)
            return (count, kind), text[: match.start()] + " , " + text[match.end() :]
    return (0, "people"), text


def _bounded(count: int, what: str) -> int:
    """Return a count, or refuse one that no room is for."""
    if count > MOST_OF_A_KIND:
        raise SceneError(f"{count} x {what} is more than one room is for; ask for at most {MOST_OF_A_KIND}.")
    return count


def _read_agent(text: str, people: tuple[int, str], agents: Mapping[str, str]) -> tuple[str | None, str]:
    for word in sorted(agents, key=lambda w: -len(w)):
        if _find(word, text):
            return agents[word], _cut(text, word)
    return ("child_6" if people[1] in YOUNG else None), text


def _read_things(text: str, room: RoomType, own: tuple[Category, ...]) -> tuple[list[Wish], set[str], list[str]]:
    """Return wishes, unwanted categories and ignored words of what is left of a sentence."""
    things: list[Wish] = []
    unwanted: set[str] = set()
    ignored: list[str] = []
    for part in re.split(r"[,;.!?]|\band\b|\bwith\b(?!out)|\bplus\b|\bnext to\b|\bnear\b|\bfor\b", text):
        refused = re.search(r"\b(no|without)\b", part) is not None
        words = re.findall(r"[0-9]+|[^\W\d_]+(?:['-][^\W\d_]+)*", part)
        counts = [n for word in words if (n := _count(word))]
        phrase = " ".join(w for w in words if _count(w) is None and w not in ("of", "without", "no"))
        told = [word for word in phrase.split() if word not in FILLERS]
        if not told:
            continue
        name = _usual_there(told, room) or find_category(phrase, own=own).name
        if name.startswith("unknown"):
            ignored.append(phrase)
        elif refused:
            unwanted.add(name)
        else:
            things.append(Wish(name, _bounded(max(counts), name) if counts else _plural(phrase)))
    return things, unwanted, ignored


def _read_corners(text: str, corners: Mapping[str, Mapping[str, int]]) -> tuple[str, list[Wish]]:
    found: list[Wish] = []
    for word, contents in corners.items():
        if _find(word, text):
            found += [Wish(name, count) for name, count in contents.items()]
            text = _cut(text, word)
    return text, found


def _usual_there(words: list[str], room: RoomType) -> str | None:
    """Return what a single general word means in a room: a desk of a classroom is a student desk."""
    items = [*([room.tables] if room.tables else []), *room.person, *room.base, *room.extras]
    word = singular(words[0])
    if len(words) > 1 or word in items:
        return None
    return next((name for name in items if name.split()[-1] == word and name.split()[0] != word), None)


def _plural(phrase: str) -> int:
    """Return 2 for a plural without a number ("desks"), else 1."""
    last = phrase.split()[-1]
    return 2 if last.endswith("s") and not last.endswith(("ss", "us", "is")) and last[:-1] + "s" not in CATALOGUE else 1
