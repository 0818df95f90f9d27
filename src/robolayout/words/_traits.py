"""What adjectives settle: the size of a thing, the wall and width of a window."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from robolayout.assets import Category
from robolayout.words._lexicon import grammar
from robolayout.words._said import Place
from robolayout.words._tokens import Measure, Size
from robolayout.words.reading import Reading


@dataclass(frozen=True)
class WantedOpening:
    """Doors or windows that are asked for."""

    kind: str  # "door" or "window"
    count: int = 1  # how many
    wall: str = ""  # "north", "south", "east", "west", or "" where it does not matter
    large: bool = False  # whether large ones are asked for


def sized(kind: Category, adjectives: Sequence[str], measures: Sequence[Measure] = ()) -> Size:
    """Return depth, width and height in metres of a kind of thing with such adjectives and measures.

    >>> from robolayout.assets import CATALOGUE
    >>> sized(CATALOGUE["bed"], ("king", "size"))
    (2.1, 1.95, 1.0)
    """
    lists = grammar()
    said = " ".join(word for word in adjectives if word not in ("size", "sized"))
    depth, width, height = lists.models.get(f"{said} {kind.name}") or kind.size
    for word in dict.fromkeys(adjectives) if (depth, width, height) == kind.size else ():
        d, w, h = lists.sizes.get(word, (1.0, 1.0, 1.0))
        depth, width, height = depth * d, width * w, height * h
    size = (round(depth, 3), round(width, 3), round(height, 3))
    for measure in measures:
        size = measure.on(size)
    return size


def wanted_openings(reading: Reading) -> tuple[WantedOpening, ...]:
    """Return the doors and windows that a text asks for."""
    found: list[WantedOpening] = []
    walls = grammar().walls
    for place, (start, end) in reading.parsed.openings:
        wall = next((walls[word] for word in place.words if walls.get(word) in ("north", "south", "east", "west")), "")
        large = {"large", "big", "wide", "huge"} & set(reading.span(start, end).lower().split())
        count = place.number or (2 if place.plural else 1)
        found.append(WantedOpening(place.name, min(count, 8), wall, bool(large)))
    return tuple(found)


def spoken_openings(reading: Reading, kind: str, most: int) -> tuple[int, int]:
    """Return how few and how many doors or windows a text takes a room to have: "under the window" means that it has one."""
    objects = [o for link in reading.parsed.links for o in link.objects if isinstance(o, Place)]
    named = [o for o in (*objects, *(o.by[1] for o in objects if o.by)) if o.name == kind and not o.words]
    if any(o.plural for o in named):
        return min(2, most), most
    return 1, 1 if any(o.det == "the" for o in named) else most
