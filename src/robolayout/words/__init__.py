"""Sentences and criteria as rows: what is asked, what it asks of a scene, and whether a layout meets it."""

from robolayout.words._function_words import COUNTERS, KIN, SHAPES, WATCHING
from robolayout.words._lexicon import Lexicon, dressing, grammar
from robolayout.words._places import COMPASS, walls_meant
from robolayout.words._said import Link, Mention, NamedThing, Place, mentions, named, place_in, places, sides
from robolayout.words._tokens import Measure
from robolayout.words._ways import CROWD, visits
from robolayout.words.demands import Demand
from robolayout.words.ledger import AskedRow, Wishes, read_words, share_met
from robolayout.words.reading import Reading, read_text, sized
from robolayout.words.rooms import RoomType, RoomTypes, read_rooms

__all__ = [
    "COMPASS",
    "COUNTERS",
    "CROWD",
    "KIN",
    "SHAPES",
    "WATCHING",
    "AskedRow",
    "Demand",
    "Lexicon",
    "Link",
    "Measure",
    "Mention",
    "NamedThing",
    "Place",
    "Reading",
    "RoomType",
    "RoomTypes",
    "Wishes",
    "dressing",
    "grammar",
    "mentions",
    "named",
    "place_in",
    "places",
    "read_rooms",
    "read_text",
    "read_words",
    "share_met",
    "sides",
    "sized",
    "visits",
    "walls_meant",
]
