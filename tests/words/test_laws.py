"""Laws of the reader: random sentences with known demands; each is read as it was made, or given back as not understood."""

from __future__ import annotations

import random
import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from robolayout.words import Lexicon, Mention, _function_words, read_rooms, read_text

LEXICON = Lexicon(read_rooms())
THINGS = [
    "sofa",
    "armchair",
    "desk",
    "wardrobe",
    "dresser",
    "cabinet",
    "bench",
    "piano",
    "sideboard",
    "fridge",
    "recliner",
]
SMALL = ["vase", "laptop", "printer", "candle", "bowl", "globe", "statue", "tray"]
NUMBERS = {2: "two", 3: "three", 4: "four"}
ADJECTIVES = ("", "", "huge ", "wooden ", "blue ", "old ", "2 m wide ", "modern white ")
RELATIONS = {
    "next to": "next", "near": "near", "in front of": "front", "behind": "behind", "to the left of": "left",
    "on the right side of": "right", "opposite": "opposite", "across from": "opposite", "far from": "far", "beside": "next",
}  # fmt: skip
PLACES = {
    "against the north wall": "wall", "in the corner": "corner", "by the window": "window", "near the door": "door",
    "in the middle of the room": "room",
}  # fmt: skip
ONE = (  # one thing each; {a}, {b}, {c} are things, {s} and {t} small ones, {r} relates a to b, {p} is where a stands
    ("{A} is {r} {b}.", "a r b"),
    ("There is {a} {p}. It is {r} the {b_}.", "a p, a r b"),
    ("{R} the {b_} stands {a}.", "a r b"),
    ("The {a_}, which is {p}, stands {r} {b}.", "a p, a r b"),
    ("{A} is {p}; behind it stands {b}.", "a p, b behind a"),
    ("{A} stands between the {b_} and the {c_}.", "a amid b, a amid c"),
    ("There is {b} and {c} with {a} between them.", "a amid b, a amid c"),
    ("{A} with {s} and {t} on it and {b} {r} the {a_}.", "b r a, s on a, t on a"),
    ("{A} is {r} {b} and {p}.", "a r b, a p"),
    ("The {b_} has {a} to its left and {c} to its right.", "a left b, c right b"),
    ("To the left of the {b_} place {a}, to the right {c}.", "a left b, c right b"),
    ("{B} with {a} on one side and {c} on the other.", "a oneside b, c otherside b"),
    ("There is {a} along with {b} and {c}.", ""),
    ("Put the {a_} {p} and place {b} {r2} it.", "a p, b r2 a"),
    ("{A} is {p}, on which sits {s}.", "a p, s on a"),
    ("{A}, {b} and {c}; the {a_} is {p}.", "a p"),
    ("The {a_} and the {b_} are {p} and {p2} respectively.", "a p, b p2"),
    ("{A} (2 m long) and {b}. The former is {p}, the latter is {p2}.", "a p, b p2"),
    ("{A} stands at the {b_}'s left.", "a left b"),
    ("{A} is on the right of the {b_}, {c} on its left.", "a right b, c left b"),
    ("{A} and {b} face the {c_}.", "a facing c, b facing c"),
    ("{A} is {p}; next to that, {b}.", "a p, b next a"),
    ("{A} (with {s} on it) is {p}.", "s on a, a p"),
    ("- {a} {p}\n- {b} {r} the {a_}\n- {c} {p2}\n", "a p, b r a, c p2"),
    ("{A} separates the {b_} from the {c_}.", "a amid b, a amid c"),
    ("There is {a} {p}, and so is {b}.", "a p, b p"),
    ("There ought to be {a} {r} {b} as well as {c} {p}.", "a r b, c p"),
    ("{A} goes {p}, with {b} {r} it and {c} {r2} the {b_}.", "a p, b r a, c r2 b"),
    ("On top of the {a_} that is {p} sit {s} and {t}.", "a p, s on a, t on a"),
    ("{A} stands {p}. It, in turn, is {r} {b}.", "a p, a r b"),
    ("{A} {p} and, {r} it, {b}.", "a p, b r a"),
    ("Both the {a_} and the {b_} are {p}.", "a p, b p"),
    ("{A} has {s} on it, {b} {r} it and {c} {r2} it.", "s on a, b r a, c r2 a"),
    ("{A} must be {r} {b}, but {r2} {c}.", "a r b, a r2 c"),
    ("{A}, {b} and {c} stand {p}.", "a p, b p, c p"),
    ("{A} {p}, {b} {r} it, {c} {r2} that.", "a p, b r a, c r2 b"),
    ("{A} should not be near the door; put it {p} instead.", "a p"),
    ("If possible, {a} {p}. {B} too.", "a p, b p"),
    ("{A} flanked by {b} and {c}.", "b flank a, c flank a"),
    ("{A} and, to its left, {b}.", "b left a"),
    ("There is {a} and {b} {p}.", "a p, b p"),
    ("Put the {a_}, the {b_} and the {c_} {p}.", "a p, b p, c p"),
    ("{S} and {t} on the {a_}, {b} {p}.", "s on a, t on a, b p"),
    ("{A} and {b} {r} the {c_}.", "a r c, b r c"),
    ("Neither the {a_} nor the {b_} should be near the window.", "a apart window, b apart window"),
    ("{A} and {b} on either side of the {c_}.", "a flank c, b flank c"),
    ("{A} and {b} beneath.", "b under a"),
    ("{A} beside which stands {b}.", "b next a"),
    ("There is {a} with {s} on it {p}.", "s on a, a p"),
    ("{A}, {b} behind it and {c} beside it.", "b behind a, c next a"),
    ("Between the {a_} and the {b_}, {p}, stands {c}.", "c amid a, c amid b, c p"),
    ("A sleeping area on the left. The sleeping area has {a} and {b}.", "a in side, b in side"),
)
MANY = (  # {n} of {a}s; the counts of others follow
    ("There are {n} {a_}s, each with {b} and {s}.", "", "b s"),
    ("There are {n} {a_}s. Each {a_} has {s} on it and {b}.", "s on a", "b s"),
    ("{N} {a_}s {p}, {s} on each {a_}.", "a p", "s"),
    ("Next to each of the {n} {a_}s is {b}.", "b next a", "b"),
    ("There are {n} {a_}s with {s} on each.", "s on a", "s"),
    ("{N} {a_}s are {r} the {b_}.", "a r b", ""),
    ("There are {n} {a_}s: one is {p}, the others {p2}.", "a p, a p2", ""),
    ("{N} {a_}s, each of which has {s}.", "", "s"),
    ("{A_}s ({d}), {b} {p}.", "b p", ""),
    ("{N} {a_}s are arranged around the {b_}.", "a around b", ""),
    ("Each of the {n} {a_}s has {b} {r} it.", "b r a", "b"),
    ("There is {b} for every one of the {n} {a_}s.", "", "b"),
    ("{d}x {a_}, {b} {p}.", "b p", ""),
    ("All {n} {a_}s are {p}.", "a p", ""),
    ("{N} {a_}s are {p}; they face {b}.", "a p, a facing b", ""),
    ("{N} {a_}s are {p}. Each faces {b}.", "a p, a facing b", "b"),
    ("The {a_}s ({n} in total) are {p}.", "a p", ""),
    ("{N} {a_}s {p}, one with {s} on it.", "a p, s on a", ""),
    ("One of the {n} {a_}s is {p}, with {b} {r} it.", "a p, b r a", ""),
    ("The room has {n} {a_}s; one of these is {r} {b}.", "a r b", ""),
    ("{N} {a_}s in a row {p}, {s} on every {a_}.", "s on a", "s"),
    ("{N} {a_}s. Most of the {a_}s are {p}.", "a p", ""),
    ("{N} {a_}s. None of the {a_}s is near the window.", "a apart window", ""),
    ("{N} {a_}s, all but one {p}.", "a p", ""),
    ("{N} {a_}s surround {b}.", "a around b", ""),
    ("{N} {a_}s in a row with {b} at the end of the row.", "b end a", ""),
    ("{N} {a_}s, each with {s}, {t} and {b} in front.", "b front a", "s t b"),
)


@dataclass
class Said:
    """A text and what it asks for."""

    text: str = ""
    counts: dict[str, int] = field(default_factory=dict[str, int])
    relations: list[tuple[str, str, str]] = field(default_factory=list[tuple[str, str, str]])


def sentences(seed: int) -> Said:
    """Return up to three random sentences and what they ask for."""
    draw = random.Random(seed)
    big, small, said = draw.sample(THINGS, 9), draw.sample(SMALL, 6), Said()
    for _ in range(draw.randint(1, 3)):
        names = dict(zip("abcst", [big.pop(), big.pop(), big.pop(), small.pop(), small.pop()], strict=True))
        many = draw.random() < 0.4
        form, asked, *counts = draw.choice(MANY if many else ONE)
        number, (r, r2), (p, p2) = draw.randint(2, 4), draw.sample(list(RELATIONS), 2), draw.sample(list(PLACES), 2)
        shown: dict[str, str] = {"n": NUMBERS[number], "N": NUMBERS[number].capitalize(), "d": str(number)}
        shown |= {"r": r, "R": r.capitalize(), "r2": r2, "p": p, "p2": p2}
        for key, name in names.items():
            phrase = f"a {draw.choice(ADJECTIVES)}{name}".replace("a o", "an o").replace("a a", "an a")
            shown |= {
                key: phrase,
                key.upper(): phrase.capitalize(),
                f"{key}_": name,
                f"{key.upper()}_": name.capitalize(),
            }
        said.text += form.format(**shown) + draw.choice([" ", "\n"])
        for key, name in names.items():
            if any(f"{{{mark}}}" in form for mark in (key, key.upper(), f"{key}_", f"{key.upper()}_")):
                of_each = many and (key == "a" or key in counts[0].split())
                said.counts[name] = number if of_each else 1
        words = names | {"r": RELATIONS[r], "r2": RELATIONS[r2], "p": f"at {PLACES[p]}", "p2": f"at {PLACES[p2]}"}
        for part in filter(None, asked.split(", ")):
            a, how, *to = (words.get(word, word) for word in part.split())
            relation, place = (how, to[0]) if to else how.split()
            said.relations.append((a, relation, place))
    return said


@pytest.mark.parametrize("first", range(0, 400, 50))
def test_random_sentences_are_read_as_they_were_made(first: int) -> None:
    for seed in range(first, first + 50):
        said = sentences(seed)
        reading = read_text(said.text, LEXICON)
        things = {thing.noun.said: thing.count for thing in reading.parsed.things}
        assert things == said.counts, said.text
        assert not reading.parsed.missed, said.text
        read = {
            (mention.thing.noun.said, how, item.thing.noun.said if isinstance(item, Mention) else item.name)
            for link in reading.parsed.links
            for mention in link.subjects
            for item in link.objects
            for how in (link.relation, "at", *(["on"] if link.relation == "with" else []))
        }
        assert set(said.relations) <= read, said.text


def test_each_list_of_small_words_has_a_reader_and_each_reader_its_list() -> None:
    folder = Path(_function_words.__file__).parent
    data = tomllib.loads((folder / "function_words.toml").read_text("utf-8"))
    text = "\n".join(path.read_text("utf-8") for path in folder.glob("*.py"))
    imported = ",".join(re.findall(r"_function_words import ([A-Z_, ]+)\n", text)).replace(" ", "")
    named = {*re.findall(r"\bsmall\.([A-Z_]+)", text), *imported.split(",")}
    assert all(getattr(_function_words, name) for name in named)
    assert {name for name in (*data, *data["rows"]) if name != "rows"} <= {name.lower() for name in named}
    with pytest.raises(AttributeError, match="has no list 'no_such_list'"):
        _ = _function_words.NO_SUCH_LIST
