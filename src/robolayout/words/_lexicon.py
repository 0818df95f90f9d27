"""The words that the reader knows: the closed lists of `grammar.toml`, room types, bodies, and nouns of furniture."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from functools import cache, cached_property, lru_cache
from importlib.resources import files
from typing import Any

from robolayout.assets import CATALOGUE, Category, category_of, find_category
from robolayout.assets.lexicon import phrase_index, singular
from robolayout.assets.palette import LOOKS
from robolayout.scene import Asset, Scene
from robolayout.words._function_words import ALIKE, BEFORE_NOUNS, INSTEAD, JOINED, SPARING
from robolayout.words._speech import is_english
from robolayout.words.rooms import RoomTypes

LONGEST = 8
"""Most words of a phrase."""

SIMILAR, ALIKE_PARTS = 0.86, 0.83
"""Likeness from which on a word is taken for a misspelt one: a thing or room, and a place of the room."""


@dataclass(frozen=True)
class Grammar:
    """The closed word lists."""

    phrases: Mapping[str, tuple[str, str]]  # what a phrase is: its class ("rel", "verb", "pron", ...) and its value
    fillers: frozenset[str]  # words that ask for nothing
    styles: frozenset[str]  # words of taste
    functions: frozenset[str]  # words for what a room is to be good for
    parts: Mapping[str, str]  # names of places of the room by noun
    walls: Mapping[str, str]  # names of walls by adjective
    sizes: Mapping[str, tuple[float, float, float]]  # factors on depth, width and height by adjective
    rooms: Mapping[str, float]  # factors on the floor of a room by adjective
    ratios: Mapping[str, float]  # how many times as long as wide a room is by adjective
    models: Mapping[str, tuple[float, float, float]]  # sizes in metres by adjective and kind ("king bed")
    kinds: Mapping[str, str]  # nearest kinds of nouns that the catalogue does not have
    groups: Mapping[str, tuple[str, ...]]  # last words of the kinds that nouns for several of them mean
    drawn: Mapping[str, tuple[str, ...]]  # what is drawn on a thing of a kind, and no thing of its own there
    heads: Mapping[str, str]  # nearest kinds by last word
    places: Mapping[str, str]  # nearest room types of places by last word
    airy: frozenset[str]  # words of rooms whose floor stays largely free
    # words of rooms with something soft and a warm light, and which things are that
    cosy: Mapping[str, tuple[str, ...]]
    exclusive: tuple[frozenset[str], ...]  # attributes of which a thing has one
    floors: Mapping[str, str]  # names of floors by what is said of them, or of the style of the room
    dress: Mapping[str, tuple[str, ...]]  # phrases that say how much is to lie about, by how much

    @cached_property
    def adjectives(self) -> frozenset[str]:
        """All words before nouns that mean something or ask for nothing."""
        lists = (
            self.styles,
            self.sizes,
            self.walls,
            self.fillers,
            self.rooms,
            self.ratios,
            LOOKS,
            self.functions,
            self.parts,
        )
        heads = {model.split()[-1] for model in self.models}
        models = (word for model in self.models for word in model.split() if word not in heads)
        return frozenset(word for words in (*lists, models, BEFORE_NOUNS) for word in words)


@cache
def grammar() -> Grammar:
    """Read the word lists."""
    data = tomllib.loads((files("robolayout.words") / "grammar.toml").read_text("utf-8"))
    phrases = {plain(word): ("verb", word) for word in data["verbs"]["words"]}
    phrases |= {word: ("pron", word) for word in data["pronouns"]["words"]}
    phrases |= {phrase: ("and", phrase) for phrase in (*JOINED, *ALIKE)}
    phrases |= {phrase: ("alone", phrase) for phrase in SPARING} | {phrase: ("not", phrase) for phrase in INSTEAD}
    phrases |= {phrase: ("rel", name) for name, given in data["relations"].items() for phrase in given}
    phrases = {phrase.replace(" the ", " "): named for phrase, named in phrases.items()} | phrases  # "on left side of"
    lists: dict[str, Any] = {name: data[name] for name in ("rooms", "ratios")}
    for name in ("fillers", "styles", "functions", "airy"):
        lists[name] = frozenset(map(plain, data[name]["words"]))
    for name in ("parts", "walls", "kinds", "heads", "places", "floors"):
        lists[name] = {word: key for key, words in data[name].items() for word in words}
    for name in ("sizes", "models", "groups", "drawn", "cosy", "dress"):
        lists[name] = {key: tuple(row) for key, row in data[name].items()}
    lists["sizes"] |= dict.fromkeys((*data["exclusive"]["shape"], "circular", "medium"), (1.0, 1.0, 1.0))
    return Grammar(phrases=phrases, exclusive=tuple(map(frozenset, data["exclusive"].values())), **lists)


def dressing(text: str) -> str:
    """Return how much is to lie about in a room that somebody describes: "none", "some" or "full"."""
    said = f" {re.sub('[^a-z]+', ' ', text.lower())} "
    said = said.replace(" set for ", " for ")  # what is laid there are things of their own
    known = grammar().dress.items()
    return next((amount for amount, phrases in known if any(f" {phrase} " in said for phrase in phrases)), "none")


@dataclass(frozen=True)
class Noun:
    """What a noun means."""

    words: str  # the noun in the singular ("bistro table")
    kind: str  # the nearest kind of the catalogue
    said: str  # the noun as it was said, in the singular ("table" where a dining table is meant)
    guessed: str = ""  # how it was found, where the catalogue does not have the word; empty where it has it
    others: tuple[str, ...] = ()  # further kinds that the noun may mean; where the thing stands decides
    kinds: Mapping[str, Category] = field(default_factory=lambda: CATALOGUE, repr=False, compare=False)

    @property
    def category(self) -> Category:
        """Its kind, of the catalogue or of the user's own."""
        return self.kinds[self.kind]

    @property
    def categories(self) -> tuple[Category, ...]:
        """All kinds that it may mean."""
        return tuple(self.kinds[kind] for kind in (self.kind, *self.others))


class Lexicon:
    """All nouns of room types, bodies, own categories, and of what stands in a scene already."""

    def __init__(self, rooms: RoomTypes, own: tuple[Category, ...] = (), scene: Scene | None = None) -> None:
        self.own = {plain(word): thing.name for thing in own if thing.like for word in (thing.name, *thing.synonyms)}
        self.own |= {singular(word + end): name for word, name in self.own.items() for end in ("", "s", "es")}
        self.there: dict[str, str] = {}
        if scene is not None:
            self.there = {word: category_of(asset).name for asset in scene.assets for word in words_for(asset)}
        self.kinds: Mapping[str, Category] = {**CATALOGUE, **{thing.name: thing for thing in own}}
        named = {plain(word): name for name, room in rooms.rooms.items() for word in room.words}
        self.room_words = {f"{word} room": name for word, name in named.items() if not word.endswith("room")} | named
        self.bodies = {plain(word): name for word, name in rooms.agents.items()}

    def noun(self, words: Sequence[str]) -> Noun | None:
        """Return what a phrase names, as it stands or in the singular; None if it is not known."""
        single = singular(" ".join(words))
        if [*words[-1:]] == ["stands"] and singular(" ".join(words[:-1])) != " ".join(words[:-1]):
            return None  # "a table with magazines stands in the middle"
        for text in (single, " ".join(words)):
            kind = self._known(text)
            if kind:
                told = text in grammar().kinds or text in self.there
                others = tuple(kind.split("|")[1:]) if told or text in self.own else phrase_index().get(text, ())[1:]
                ends = grammar().groups.get(single, ())  # "the seats" of a scene are all that it has
                others = (*others, *dict.fromkeys(there for there in self.there.values() if there.split()[-1] in ends))
                return Noun(text if told else kind, kind.split("|")[0], single, "", others, self.kinds)
        return None

    def _known(self, text: str) -> str | None:
        """Return the kind of a phrase that is known as it stands."""
        listed = self.own.get(text) or self.there.get(text) or grammar().kinds.get(text)
        if listed:
            return listed
        names = phrase_index().get(text) or (_joined().get(text.replace(" ", "")) if len(text) > 3 else ())
        return names[0] if names else None

    def room_like(self, words: Sequence[str]) -> str | None:
        """Return the room type whose name is most like some words, None where none is."""
        near = get_close_matches(" ".join(words), self.room_words, n=1, cutoff=SIMILAR)
        return self.room_words[near[0]] if near else None

    def part_like(self, words: Sequence[str]) -> str | None:
        """Return the place of the room that the last of some words is a slip of, None where it is none."""
        if words[-1] in grammar().fillers:
            return None  # "evenly spaced" is no space
        near = get_close_matches(words[-1], grammar().parts, n=1, cutoff=ALIKE_PARTS)
        known = any(_misspelt(text.replace(" ", "")) for text in (" ".join(words), words[-1]))
        slip = bool(near) and len(words[-1]) > 4 and not known and not is_english(words[-1])
        return grammar().parts[near[0]] if slip else None

    def slip(self, words: Sequence[str]) -> Noun | None:
        """Return what some words are a slip of spelling of, None where they are none."""
        text = singular(" ".join(words))
        near = _misspelt(text.replace(" ", "")) if len(text) > 4 else None
        near = None if near and all(map(is_english, words)) else near
        return Noun(near, near, text, "by its spelling", kinds=self.kinds) if near else None

    def guess(self, words: Sequence[str]) -> Noun:
        """Return the nearest kind of a noun that nobody knows: by a slip of spelling, its last word, or any known word."""
        text = singular(" ".join(words))
        if near := self.slip(words):
            return near
        head = text.split()[-1]
        ending = max((known for known in grammar().heads if head.endswith(known)), key=len, default="")
        if ending:
            return Noun(text, grammar().heads[ending], text, f"by its last word, {ending!r}", kinds=self.kinds)
        found = find_category(text).name
        how = "as nothing that is known" if found.startswith("unknown") else "by one of its words"
        return Noun(text, found, text, how, kinds=self.kinds)


@cache
def _joined() -> dict[str, tuple[str, ...]]:
    """Return categories by phrase without spaces: "coffeetable"."""
    return {phrase.replace(" ", ""): names for phrase, names in phrase_index().items() if len(phrase) > 3}


@lru_cache(maxsize=4096)
def _misspelt(text: str) -> str | None:
    """Return the kind of the known phrase that is most like some letters, None where none is like them."""
    near = get_close_matches(text, _joined(), n=1, cutoff=SIMILAR)
    return _joined()[near[0]][0] if near else None


def words_for(asset: Asset) -> tuple[str, ...]:
    """Return the words by which an asset is named, in the singular."""
    return tuple(singular(plain(word)) for word in (asset.category, *asset.synonyms))


@lru_cache(maxsize=4096)
def plain(text: str) -> str:
    """Return a phrase as the reader sees it: lower case, without apostrophes, hyphens as spaces."""
    return " ".join(text.lower().replace("\u2019", "'").replace("'", "").replace("-", " ").split())
