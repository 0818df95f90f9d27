"""The small words of `function_words.toml`: articles, what joins, refuses and bounds, verbs, people, pronouns."""

from __future__ import annotations

import tomllib
from importlib.resources import files

_DATA = tomllib.loads((files("robolayout.words") / "function_words.toml").read_text("utf-8"))
_WORDS = {name: frozenset(words.split()) for name, words in _DATA.items() if isinstance(words, str)}
_ROWS = {name: tuple(phrases) for name, phrases in _DATA["rows"].items()}

DETERMINERS = {word: name for name, words in _DATA["determiners"].items() for word in words.split()}
BOUNDS = {tuple(phrase.split()): name for name, phrases in _DATA["bounds"].items() for phrase in phrases}
ORDINALS = ("first", "second", "third", "last")
JOINING, WITH, NEGATING, BREAKING = (_WORDS[name] for name in ("joining", "with", "negating", "breaking"))
REFUSING = NEGATING | {"no", "without", "neither", "nor"}
LED, FINITE, PLURAL_DOES, ALONE_DOES, LED_BACK, MODAL, USING, REACHED, ABLE = (
    _WORDS[name]
    for name in ("led", "finite", "plural_does", "alone_does", "led_back", "modal", "using", "reached", "able")
)
PEOPLE, YOUNG, SEATED, LEADING = (_WORDS[name] for name in ("people", "young", "seated", "leading"))
SIBLINGS, BORN = _WORDS["siblings"], {"couple": 2, "twins": 2, "triplets": 3}
SETS, SCALES, COMPARING, FREE = (_WORDS[name] for name in ("sets", "scales", "comparing", "free"))
PICKING, RELATING, NAMED = (_WORDS[name] for name in ("picking", "relating", "named"))
JOINED, ALIKE, EVERY, SEVERAL = (_ROWS[name] for name in ("joined", "alike", "every", "several"))
SHARES: dict[str, float] = _DATA["shares"]
OF_ROOMS: dict[str, dict[str, str]] = _DATA["of_rooms"]
AREAS: dict[str, dict[str, int]] = {name: area["has"] for name, area in _DATA["areas"].items()}
AREA_NOUNS, SHARING = _WORDS["area_nouns"], _ROWS["sharing"]
DONE_THERE = {word: name for name, area in _DATA["areas"].items() for word in (name, *area.get("words", ()))}
SAID_AS: dict[str, str] = _DATA["said_as"]
ADDING, ROUND_IT = _WORDS["adding"], _WORDS["round_it"]
NEARNESS, LAID, ZONES, OF_THE_ROOM = (_WORDS[name] for name in ("nearness", "laid", "zones", "of_the_room"))
ORDERS, ALONE, CLOSE, SHARED = (_WORDS[name] for name in ("orders", "alone", "close", "shared"))
PETS, OF_PETS = _WORDS["pets"], _WORDS["of_pets"]
AT_FIRST, AT_LAST, KEPT_AWAY = (_WORDS[name] for name in ("at_first", "at_last", "kept_away"))
SHARED_OUT, SELLING, GROUPS, NO_THINGS = (_WORDS[name] for name in ("shared_out", "selling", "groups", "no_things"))
MOST, STANDING, ROUND, LOUNGE = (_WORDS[name] for name in ("most", "standing", "round", "lounge"))
NAMING, SILENT, OF_A_THING, BEFORE_NOUNS = (_WORDS[name] for name in ("naming", "silent", "of_a_thing", "before_nouns"))
HALVES, COMPASS, REST, AFTER_A_PLACE = (_WORDS[name] for name in ("halves", "compass", "rest", "after_a_place"))
TABLES, HIGH, LATTER, LEAST_SAID = (_ROWS[name] for name in ("tables", "high", "latter", "least_said"))
INSTRUMENTS = {*_ROWS["instruments"]}
