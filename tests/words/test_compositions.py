"""Composed sentences whose things, counts and relations are known: every one of these is read, and nothing else.

A form says what it asks for: "t at p, s on t" is that the thing in {T} (or {t}) is at the place in {p}, and the one in {S} on it.
Which things, places and verbs fill a form is drawn from one seed; the relations come from the form and never from the reader.
"""

from __future__ import annotations

import random
from collections import Counter

import pytest

from robolayout.words import Lexicon, Mention, read_rooms, read_text

FURNITURE = ("sofa", "armchair", "wardrobe", "bench", "piano", "fridge", "chest", "bookcase")
TOPS = ("desk", "sideboard", "dresser", "workbench", "cabinet")
BESIDE = ("plant", "floor lamp", "trash can", "stool", "basket")
SMALL = ("vase", "laptop", "candle", "bowl", "kettle", "toaster", "phone", "notebook", "printer")
PLACES = {
    "against the north wall": "wall",
    "in the corner": "corner",
    "by the window": "window",
    "near the door": "door",
    "in the middle of the room": "room",
}
SIDES = {
    "next to": "next",
    "behind": "behind",
    "in front of": "front",
    "to the left of": "left",
    "to the right of": "right",
    "opposite": "opposite",
}
SLOTS = {"a": FURNITURE, "b": FURNITURE, "e": FURNITURE, "t": TOPS, "m": BESIDE, "n": BESIDE, "s": SMALL, "u": SMALL}
STANDS = (
    "stands",
    "is",
    "should go",
    "must be",
    "belongs",
    "has to stand",
    "could be",
    "has been put",
    "finds its place",
)
ASIDES = (
    "",
    "",
    "",
    "My sister visits us every Sunday. ",
    "The old one was far too small. ",
    "We have just moved in. ",
)
REASONS = ("", "", " because it is quiet there", ", which my husband loves", " since I work at home")

FORMS = [
    ("The {a} {stands} {p}{why}.", "a at p"),
    ("The {a} {stands} {p}{why}, and {B} {stands} {r} it.", "a at p, b r a"),
    ("{A} {stands} {p}, while {B} is {r} the {a}.", "a at p, b r a"),
    ("{A} is {p}, {B} {r} it and {M} {q}.", "a at p, b r a, m at q"),
    ("{p} {stands} {A}, {r} it {M}.", "a at p, m r a"),
    ("{A} {stands} {p}. It faces {B}. {r} it stands {M}.", "a at p, a facing b, m r a"),
    ("{A} {stands} {p}; {M} is {r} it, and {N} {q}.", "a at p, m r a, n at q"),
    ("{A} {stands} {p}, with {M} to its left and {N} to its right.", "a at p, m left a, n right a"),
    ("{A} {stands} {p}, flanked by {M} and {N}.", "a at p, m flank a, n flank a"),
    (
        "{A} and {B} stand side by side against the north wall with {M} in between.",
        "a at wall, b at wall, m amid a, m amid b",
    ),
    ("Both the {a} and the {b} stand {p}.", "a at p, b at p"),
    ("{A} {stands} {p}, as does {B}.", "a at p, b at p"),
    ("{A} {stands} {p}. The same goes for the {b}.", "a at p, b at p"),
    ("{A}, {B} and {E} are lined up along the north wall{why}.", "a at wall, b at wall, e at wall"),
    ("{A} stands against the east wall; opposite it is {B}, and {E} is {p}.", "a at wall, b opposite a, e at p"),
    ("{A} stands {r} {T} that {stands} {p}.", "a r t, t at p"),
    ("The {a}, which is {r} the {b}, {stands} {p}.", "a at p, a r b"),
    ("Put {A} {p}, {B} {r} it and {M} {q}.", "a at p, b r a, m at q"),
    ("I'd like the {a} to stand {p} and the {b} to be {r} it.", "a at p, b r a"),
    ("Make sure that the {a} stands {p} and the {b} is {r} it.", "a at p, b r a"),
    ("Can you put {A} {p} and {B} {r} it?", "a at p, b r a"),
    ("No {e}, please. {A} stands {p}.", "a at p, no e"),
    ("There are two {m}s, one {p} and the other {q}.", "m at p, m at q, 2 m"),
    ("On the {t}: {S} and {U}. {r} the {t}: {M}.", "s on t, u on t, m r t"),
    ("{T} with {S} and {U} on it {stands} {p}{why}.", "t at p, s on t, u on t"),
    ("The {t}, with {S} and two {u}s on top, {stands} {p}.", "t at p, s on t, u on t, 2 u"),
    ("The {t}, on which {S} and {U} stand, is {p}.", "t at p, s on t, u on t"),
    (
        "{T} {stands} {p}, and on it are {S}, a tray with four cups and {U}.",
        "t at p, s on t, u on t, tray on t, cup on tray, 4 cup",
    ),
    (
        "There is {T} {p}. It holds a tray with two glasses and a jug on it, {S} and {U}.",
        "t at p, s on t, u on t, tray on t, glass on tray, jug on tray, 2 glass",
    ),
    ("{T} {stands} {p}; it carries {S} and {U}, and {M} stands to its left.", "t at p, s on t, u on t, m left t"),
    ("{A} stands {r} {T}, which has {S} and {U} on it.", "a r t, s on t, u on t"),
    (
        "{S}, {U} and two candlesticks live on the {t}, which {stands} {p}.",
        "t at p, s on t, u on t, candlestick on t, 2 candlestick",
    ),
    ("On the {t} {p} I keep {S} and {U}.", "t at p, s on t, u on t"),
    ("{A} {stands} {p}. {r} it is {T}, and on that {S}.", "a at p, t r a, s on t"),
    ("A picture hangs above the {t}, on which one sees {S} and {U}.", "picture above t, s on t, u on t"),
    ("{T} {stands} {p}, with a mirror hanging above it and {S} on it.", "t at p, mirror above t, s on t"),
    ("Two {t}s stand against the north wall, each with {S} and {U} on it.", "t at wall, s on t, u on t, 2 t, 2 s, 2 u"),
    ("Against the north wall stand three {t}s, each of which has {S} on it.", "t at wall, s on t, 3 t, 3 s"),
    (
        "Three {t}s stand against the north wall. In front of each {t} is a chair, and every {t} has {S} on it.",
        "t at wall, chair front t, s on t, 3 t, 3 chair, 3 s",
    ),
    (
        "Two {t}s stand along the east wall. One {t} holds {S}, the other {U} and three jars.",
        "t at wall, s on t, u on t, jar on t, 2 t, 3 jar",
    ),
    (
        "A table with four chairs around it, {S} and two {u}s {stands} {p}.",
        "table at p, chair around table, s on table, u on table, 4 chair, 2 u",
    ),
    (
        "{p} there is a table with four chairs around it, and {S} on it.",
        "table at p, chair around table, s on table, 4 chair",
    ),
    ("Between the {a} and the {t} there is {M}, and on the {t} stands {S}.", "m amid a, m amid t, s on t"),
    ("A rug lies in front of the {a}; on it stands {B}.", "rug front a, b on rug"),
    ("{A} is {p}. On the right-hand side of the room, two {m}s stand.", "a at p, m at side, 2 m"),
    (
        "Two beds stand against the north wall, and each has a nightstand beside it with {S} on it.",
        "bed at wall, nightstand with bed, s on nightstand, 2 bed, 2 nightstand, 2 s",
    ),
    ("{A} is {p}, with {M} in front of it and a music stand beside it.", "a at p, m front a, music_stand next a"),
    ("{A} stands on a rug {p}, with {M} next to it.", "a on rug, m next a"),
    ("{A} {stands} {p}, and {r} it stands {M} {q}.", "a at p, m r a, m at q"),
    ("The {t} holds {S}, {U} and nothing else. {A} is {p}.", "s on t, u on t, a at p"),
    ("{S}, {U} and a jar stand on the {t}. {A} is {p}.", "s on t, u on t, jar on t, a at p"),
    ("{p} there is {A}, followed by {M} and {N}.", "a at p, m next a, n next m"),
    ("The {a} {p} has {M} {r} it and {N} in front of it.", "a at p, m r a, n front a"),
    ("The {t} is {p}. There are three things on it: {S}, {U} and a jar.", "t at p, s on t, u on t, jar on t"),
    ("The {a} should be near the {b} but not touching it. {M} is {p}.", "a near b, m at p"),
    ("Against the north wall, from left to right: {A}, {M} and {B}.", "a at wall, m at wall, b at wall"),
    ("{A} and {B} face each other, with {M} in between; {N} is {p}.", "m amid a, m amid b, n at p"),
    ("{A} is sandwiched between {M} and {N}.", "a amid m, a amid n"),
    ("Place {A} {p}. Next, put {M} {r} it. Finally, add {N} {q}.", "a at p, m r a, n at q"),
    ("Instead of {E}, there is {A} {p}.", "a at p, no e"),
    ("{A} goes {p}; the {m} and the {n} go {q}.", "a at p, m at q, n at q"),
]


def compose(form: tuple[str, str], seed: int) -> tuple[str, Counter[str], set[tuple[str, str, str]]]:
    """Return a text, how many of what it names, and which relations."""
    draw = random.Random(f"{form[0]} {seed}")
    words: dict[str, str] = {}
    for slot, kinds in SLOTS.items():
        words[slot] = draw.choice([kind for kind in kinds if kind not in words.values()])
    (p, place), (q, other) = draw.sample([*PLACES.items()], 2)
    r, side = draw.choice([*SIDES.items()])
    named = words | {"p": place, "q": other, "r": side}
    articles = {slot.upper(): f"{'an' if kind[0] in 'aeiou' else 'a'} {kind}" for slot, kind in words.items()}
    counts, relations, absent = Counter[str](), set[tuple[str, str, str]](), set[str]()
    for said in form[1].split(", "):
        first, *rest = (word.replace("_", " ") for word in said.split(" "))
        if first == "no":
            absent.add(named[rest[0]])
        elif first.isdigit():
            counts[named.get(rest[0], rest[0])] = int(first)
        else:
            relation, last = rest
            relations.add((named.get(first, first), named.get(relation, relation), named.get(last, last)))
    places = {"wall", "side", *PLACES.values()}
    for one, _, to in relations:
        for name in {one, to} - places - absent:
            counts[name] = counts[name] or 1
    slots = {**words, **articles, "p": p, "q": q, "r": r, "why": draw.choice(REASONS)}
    text = form[0]
    while "{stands}" in text:
        text = text.replace("{stands}", draw.choice(STANDS), 1)
    sentences = (one[:1].upper() + one[1:] for one in text.format_map(slots).split(". "))
    return draw.choice(ASIDES) + ". ".join(sentences), counts, relations


@pytest.mark.parametrize("form", FORMS, ids=[form[0] for form in FORMS])
def test_what_is_composed_is_read(form: tuple[str, str]) -> None:
    lexicon = Lexicon(read_rooms())
    for seed in range(12):
        text, counts, relations = compose(form, seed)
        said = read_text(f"A room. {text}", lexicon).parsed
        read = set[tuple[str, str, str]]()
        for link in said.links:
            ends = [item.thing.noun.said if isinstance(item, Mention) else item.name for item in link.objects]
            how = {link.relation, "at", *(["on"] if link.relation in ("with", "in") else [])}
            read |= {(m.thing.noun.said, one, end) for m in link.subjects for end in ends for one in how}
        there = Counter[str]()
        for thing in said.things:
            there[thing.noun.said] += thing.count
        assert there == counts, text
        assert relations <= read, text
        assert not said.missed, text
