"""From free words to a category: "a squashy old couch" is a sofa.

The words are looked up as phrases, longest first; the last one before the first preposition is the head noun and wins
("table lamp with a glass plate" is a lamp, not a plate). Where a word names several things ("cot", "lamp"), placement
flags and then the size decide. What no word explains is sorted by flags and size alone.
"""

from __future__ import annotations

import math
import re
import unicodedata
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache, lru_cache

from robolayout._reading import LIMITS
from robolayout.assets.category import CATALOGUE, PLACES, Category, read_data
from robolayout.scene import FLAT_HEIGHT, Asset

Size = tuple[float, float, float]

LONGEST_PHRASE = 5
ODD_SIZE = math.log(4.0)
"""A word whose typical size differs by more than this factor in its longest edge yields to another word."""
ENGLISH = read_data("english.toml")
BREAKS = frozenset(ENGLISH["breaks"])  # words after which no head noun is expected
PLAIN = re.compile(r"[a-z0-9]+(?: [a-z0-9]+)*")  # a phrase that is spelled as the index spells it already


def find_category(
    text: str,
    *,
    description: str = "",
    size: Size | None = None,
    place: str | None = None,
    own: tuple[Category, ...] = (),
) -> Category:
    """Return the category that fits the words best; never fails.

    Args:
        text: The category in words ("night stand", "Scandinavian_sofa_3seater").
        description: Free words, looked at where `text` says nothing.
        size: Depth, width, height in metres, if known.
        place: "floor", "wall", "ceiling" or "object", if known.
        own: Further categories; their words come before the built-in ones.

    >>> find_category("squashy old couch").name
    'sofa'
    """
    for words in (text, description):
        category = _from_words(words, size, place, own)
        if category is not None:
            return category
    return _from_size(size, place)


@lru_cache(maxsize=8192)
def category_of(asset: Asset) -> Category:
    """Return the category of an asset, from its category, description, placement flags and size."""
    words = asset.like or asset.category
    return find_category(words, description=asset.description, size=asset.size, place=place_of(asset))


def unknown_kinds(assets: Iterable[Asset]) -> tuple[str, ...]:
    """Return one sentence for each category that no word explains: an asset of it, and what it is taken for."""
    groups: dict[tuple[str, str], list[str]] = {}
    for asset in assets:
        found = category_of(asset)
        if found.group == "unknown":
            groups.setdefault((asset.like or asset.category, found.name), []).append(asset.name)
    return tuple(
        f"asset {names[0]!r}{f' and {len(names) - 1} more' if len(names) > 1 else ''}: the category {words!r} is not known; "
        f'from its size and place it is taken for {taken!r}. Say in "like" what it is like, such as "chair".'
        for (words, taken), names in groups.items()
    )


def place_of(asset: Asset) -> str | None:
    """Return the one place where the asset may be; None where the flags leave a choice of several."""
    places = [place for place in PLACES if getattr(asset, f"on_{place}")]
    return places[0] if len(places) == 1 else None


def _from_words(text: str, size: Size | None, place: str | None, own: tuple[Category, ...]) -> Category | None:
    """Return the category of the best phrase in `text`, or None."""
    catalogue = {**CATALOGUE, **{category.name: category for category in own}}
    matches = sorted(_matches(_segments(text), _index_of(own)))
    found = [_choose([catalogue[name] for name in names], size, place) for *_, names in matches]
    fitting = [kind for kind in found if not size or abs(math.log(max(kind.size) / max(size))) < ODD_SIZE]
    return next(iter(fitting or found), None)


def _segments(text: str) -> list[list[str]]:
    """Split a text into lower-case words, in segments that end at punctuation; "NightStand" is two words."""
    text = text[: LIMITS.looked_at]
    if not re.search(r"\s", text):
        text = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text)
    text = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode().lower()
    text = re.sub(r"(?<=\w)'s?\b", "", text)
    pieces = re.split(r"[,;:()/\[\]|\n]+|\.\s| - ", text)
    segments = [re.findall(r"[a-z0-9]+", re.sub(r"[_\-]", " ", piece)) for piece in pieces]
    return [segment for segment in segments if segment]


def _matches(
    segments: Sequence[Sequence[str]], own: Mapping[str, tuple[str, ...]]
) -> Iterator[tuple[int, int, tuple[str, ...]]]:
    """Yield known phrases, maximal ones only: the segment (0 before the first preposition), minus the end, the categories."""
    number = offset = 0
    for tokens in segments:
        covered = 0
        for start, token in enumerate(tokens):
            if token in BREAKS and start >= covered:
                number += 1
            for end in range(min(len(tokens), start + LONGEST_PHRASE), start, -1):
                names = _lookup(tokens[start:end], own)
                if names and end > covered:
                    yield number, -offset - end, names
                    covered = end
                    break
        number, offset = number + 1, offset + len(tokens)


def _lookup(tokens: Sequence[str], own: Mapping[str, tuple[str, ...]]) -> tuple[str, ...]:
    """Return the categories of a phrase, as it stands or in the singular; the user's own words come first."""
    raw = " ".join(tokens)
    single = singular(raw)
    index = phrase_index()
    return own.get(raw) or own.get(single) or index.get(raw) or index.get(single) or ()


def _choose(candidates: list[Category], size: Size | None, place: str | None) -> Category:
    """Return the candidate that fits the place, then the size; the first where nothing decides."""
    if place is not None:
        candidates = [c for c in candidates if place in c.places] or candidates
    if size is None:
        return candidates[0]
    d, w, h = size

    def apart(category: Category) -> float:
        a, b, c = category.size  # a sum of log ratios; depth and width may swap
        flat = min(abs(math.log(a / d)) + abs(math.log(b / w)), abs(math.log(b / d)) + abs(math.log(a / w)))
        return flat + abs(math.log(c / h))

    return min(candidates, key=apart)


def _from_size(size: Size | None, place: str | None) -> Category:
    """Return the category of a thing that no word explains, from where it goes and how large it is."""
    fixed = {"wall": "unknown wall decor", "ceiling": "unknown ceiling item"}
    if place in fixed or size is None:
        return CATALOGUE[fixed.get(place or "", "unknown furniture")]
    depth, width, height = size
    across, tallest = max(depth, width), max(size)
    rules = (
        (height < FLAT_HEIGHT and across > 0.6, "unknown floor covering"),
        (tallest < 0.45, "unknown decor"),
        (height >= 1.2 and across >= 0.5, "unknown storage"),
        (across < 0.5 and height >= 0.45, "unknown floor decor"),
        (0.35 <= height <= 1.15 and across >= 0.9, "unknown surface"),
        (0.4 <= across <= 0.9 and 0.4 <= height <= 1.2, "unknown seat"),
    )
    return CATALOGUE[next((name for holds, name in rules if holds), "unknown furniture")]


def singular(phrase: str) -> str:
    """Return a phrase with each plural word made singular, by spelling alone."""
    return " ".join(map(_singular, phrase.split()))


def _singular(word: str) -> str:
    if word in ENGLISH["irregular"]:
        return ENGLISH["irregular"][word]
    if len(word) <= 3 or not word.endswith("s") or word.endswith(tuple(ENGLISH["keeps_s"])):
        return word
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    return word[:-2] if word.endswith(tuple(ENGLISH["loses_es"])) else word[:-1]


def normalise(phrase: str) -> str:
    """Return a phrase as the index spells it: lower case, plain letters, single spaces."""
    if PLAIN.fullmatch(phrase):
        return phrase
    return " ".join(token for segment in _segments(phrase) for token in segment)


@lru_cache(maxsize=16)
def _index_of(own: tuple[Category, ...]) -> dict[str, tuple[str, ...]]:
    """Build the phrase table of a user's own categories."""
    return _index([(word, (category.name,)) for category in own for word in (category.name, *category.synonyms)])


@cache
def phrase_index() -> dict[str, tuple[str, ...]]:
    """Build the phrase table: ambiguous words, then names, synonyms and WordNet's words; earlier entries win."""
    known = [(word, tuple(names)) for word, names in read_data("ambiguous.toml").items()]
    known += [(name, (name,)) for name in CATALOGUE if not name.startswith("unknown ")]
    known += [(word, (category.name,)) for category in CATALOGUE.values() for word in category.synonyms]
    known += [(word, (name,)) for name, entry in read_data("wordnet.toml").items() for word in entry["words"]]
    return _index(known)


def _index(known: Sequence[tuple[str, tuple[str, ...]]]) -> dict[str, tuple[str, ...]]:
    """Return categories by word, as it stands and in the singular; earlier entries win."""
    index: dict[str, tuple[str, ...]] = {}
    for word, names in known:
        index.setdefault(normalise(word), names)
    for word, names in known:
        index.setdefault(singular(normalise(word)), names)
    return index
