"""The words that join: articles, "and", "with", "no", numbers' bounds, and words for people."""

from __future__ import annotations

DETERMINERS = {
    word: name
    for name, words in {
        "a": "a an any",
        "the": "the this that its their his her my these those",
        "each": "each every",
        "all": "all",
        "both": "both",
        "new": "another",
        "other": "other",
        "first": "first",
        "second": "second",
        "third": "third",
        "last": "last",
    }.items()
    for word in words.split()
}
"""Articles by word."""
ORDINALS = ("first", "second", "third", "last")
"""Words that pick one of several by its number."""
JOINING = frozenset(["and", "plus", "as", "or", "also", "then", "but", "while", "whereas", "where", "&", "+"])
"""Words that join phrases."""
JOINED = (
    "in which",
    "as well as",
    "along with",
    "together with",
    "in addition to",
    "accompanied by",
    "complemented by",
)
"""Phrases that join."""
_WITH = "with w consisting comprising has have having contains contain containing includes include featuring including"
WITH = frozenset(_WITH.split())
"""Words after which comes what something has."""
_NEGATING = "not dont avoid never doesnt isnt arent shouldnt mustnt cant cannot wont"
NEGATING = frozenset(_NEGATING.split())
"""Words that refuse what a clause says."""
REFUSING = NEGATING | {"no", "without", "neither", "nor"}
"""Words that refuse what follows."""
BREAKING = frozenset(
    [
        "for",
        "of",
        "to",
        "from",
        "that",
        "which",
        "who",
        "so",
        "than",
        "when",
        "whose",
        "whom",
        "if",
        "does",
        "do",
        "x",
        "except",
    ]
)
"""Words that end a noun phrase."""
_PEOPLE = """
people persons guests pupils students children kids patients colleagues employees players adults friends workers visitors
person child teenager user users owner man woman couple family guest student patient teacher nurse baby toddler
daughter son girl boy mother father parents grandparents grandmother grandfather sister brother siblings twins roommate roommates
researcher musician artist writer designer programmer engineer scientist professor doctor lawyer gamer collector chef photographer
customers diners staff clients tenant freelancer blogger retiree newlyweds
"""
PEOPLE = frozenset(_PEOPLE.split())
"""Words for who uses a room."""
_LED = "aligned centered centred faced form forming forms leaning lined oriented spread suspended surround surrounds"
LED = frozenset(_LED.split())
"""Verbs that ask for nothing only where a relation follows."""
YOUNG = frozenset(["children", "kids", "child", "kid"])
"""Words for people that are children."""
BOUNDS = {
    tuple(phrase.split()): name
    for name, phrases in {
        "least": ("at least", "no less than", "no fewer than", "a minimum of", "minimum"),
        "more": ("more than",),
        "most": ("at most", "up to", "no more than", "not more than", "a maximum of", "maximum"),
    }.items()
    for phrase in phrases
}
"""Bounds on a count by phrase."""
SETS = frozenset(["pair", "set", "couple", "group", "row", "stack", "bunch", "number", "line", "pile", "selection"])
"""Words before "of" that only say that there are several."""
