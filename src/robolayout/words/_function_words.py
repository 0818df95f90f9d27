"""The small words of `function_words.toml`: articles, what joins, refuses and bounds, verbs, people, pronouns."""

from __future__ import annotations

import tomllib
from importlib.resources import files

_DATA = tomllib.loads((files("robolayout.words") / "function_words.toml").read_text("utf-8"))
DETERMINERS = {word: name for name, words in _DATA["determiners"].items() for word in words.split()}
BOUNDS = {tuple(phrase.split()): name for name, phrases in _DATA["bounds"].items() for phrase in phrases}
ORDINALS = ("first", "second", "third", "last")
HIGH, LATTER, LEAST_SAID = (tuple[str, ...](_DATA["rows"][name]) for name in ("high", "latter", "least_said"))
BORN = {"couple": 2, "twins": 2, "triplets": 3}
SHARES: dict[str, float] = _DATA["shares"]
LEVELS: dict[str, int] = _DATA["rows"]["levels"]
OF_ROOMS: dict[str, dict[str, str]] = _DATA["of_rooms"]
AREAS: dict[str, dict[str, int]] = {name: area["has"] for name, area in _DATA["areas"].items()}
DONE_THERE = {word: name for name, area in _DATA["areas"].items() for word in (name, *area.get("words", ()))}
AT_A_PLACE: dict[str, dict[str, str]] = _DATA["at_a_place"]
FREED: dict[str, list[str]] = _DATA["freed"]
_NAMES: dict[str, dict[str, str]] = _DATA
SAID_AS, KIN, HEAPS, SAID_OF = (_NAMES[name] for name in ("said_as", "kin", "heaps", "said_of"))
OF_A_SIDE, REVERSED, AIDS, AXES = (_NAMES[name] for name in ("of_a_side", "reversed", "aids", "axes"))
OTHER_SIDE, ACROSS, ENDS, SHAPES = (_NAMES[name] for name in ("other_side", "across", "ends", "shapes"))


def __getattr__(name: str) -> frozenset[str]:
    """Return a list of words or phrases by its name in the file, in capitals."""
    words = _DATA["rows"].get(name.lower(), _DATA.get(name.lower()))
    if not name.isupper() or not isinstance(words, str | list):
        raise AttributeError(f"function_words.toml has no list {name.lower()!r}.")
    globals()[name] = found = frozenset(words.split() if isinstance(words, str) else words)
    return found


REFUSING = __getattr__("NEGATING") | {"no", "without", "neither", "nor"}
REACHED_FROM = __getattr__("SEATS") | __getattr__("SLEPT_ON") | {"desk"}
AT_SIDES, COUNTERS, NEARBY, SPEAKING, WATCHING = map(
    __getattr__, ("AT_SIDES", "COUNTERS", "NEARBY", "SPEAKING", "WATCHING")
)
TABLEWARE = __getattr__("TABLEWARE")
