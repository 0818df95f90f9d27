"""A law of the reader: where a thing stands is understood in whatever words of a pattern it is told."""

from __future__ import annotations

from itertools import product

import pytest

from robolayout.planners import OfflinePlanner
from robolayout.run.given import as_scene
from robolayout.words import read_words

CORNERS = (
    *("left", "right", "far", "far left", "far right", "near left", "back right", "front left"),
    *("north east", "north-west", "top left", "bottom right", "nearest"),
)
WALLS = ("left", "right", "back", "front", "far", "north", "south", "long", "short", "window", "side", "longest")
NEARNESS = ("near", "next to", "by", "close to", "beside", "right next to", "closest to")
TURNED = ("across from", "opposite", "facing", "with its back to", "away from", "far from", "in front of")
THINGS = ("window", "door", "bed", "wardrobe")
PATTERNS = (
    ("in the {} corner", CORNERS),
    ("at an angle in the {} corner", CORNERS[:6]),
    ("against the {} wall", WALLS),
    ("flush against the {} wall", WALLS[:8]),
    ("in the middle of the {} wall", WALLS[:8]),
    ("on the {} side of the room", ("left", "right", "far", "back", "north", "window", "door")),
    ("at the {} end of the room", ("left", "right", "far", "near", "back")),
    ("{} the {}", NEARNESS, THINGS),
    ("{} the {}", TURNED, THINGS),
    ("to the {} of the {}", ("left", "right", "immediate left"), THINGS),
)
SAID = (
    "A bedroom with a bed, a wardrobe and a dresser {}",
    "A bedroom with a bed and a wardrobe. Put a dresser {}, please",
    "A bedroom with a bed and a wardrobe. The dresser stands {}",
)


def phrases() -> list[str]:
    """Return every pattern with each of its words."""
    return [pattern.format(*words) for pattern, *of in PATTERNS for words in product(*of)]


@pytest.mark.parametrize("turn", range(len(SAID)))
def test_where_a_thing_stands_is_understood(turn: int) -> None:
    """The far left corner once was none."""
    missed = list[str]()
    for phrase in phrases()[turn :: len(SAID)]:
        scene = as_scene(SAID[turn].format(phrase), OfflinePlanner(), None, seed=0, dress="none")
        rows = read_words(scene).rows
        about = any(row.kind == "relation" and any("dresser" in name for name in row.things) for row in rows)
        missed += [phrase] * (not about or any(row.kind == "not understood" for row in rows))
    assert not missed
