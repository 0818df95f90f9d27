"""Which things go onto the shelves of others: what is said to be in them, or on what is called a shelf, as long as there is room."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from robolayout.assets.surfaces import Surface, open_shelves, slots
from robolayout.scene import Asset
from robolayout.words._places import Asked
from robolayout.words._said import Link


def shelved(assets: Mapping[str, Asset], asked: Iterable[tuple[Link, Asked]]) -> Iterator[tuple[tuple[str, str], str]]:
    """Yield what is put onto shelves and that of which they are, with the name of the shelf that is meant ("" for any).

    Where not all that words put onto some shelves has a place there, nothing is, unless they say which shelf.
    """
    held: dict[tuple[str, int], list[str]] = {}
    for a, b, level in ((*two, link.level) for link, it in asked if link.shelves for two in it.twos):
        if assets[a].on_object and a not in held.setdefault((b, level), []):
            held[b, level].append(a)
    for (b, level), names in held.items():
        shelves = _meant(open_shelves(assets[b]), level)
        room = [sum(slots(shelf, assets[a].size) for shelf in shelves) for a in names]
        if (level and shelves) or (all(room) and sum(1 / many for many in room) <= 1.0):
            yield from (((a, b), shelves[0].name if level else "") for a in names)


def _meant(shelves: tuple[Surface, ...], level: int) -> tuple[Surface, ...]:
    """Return the shelf of a level, counted from below or -1 for the highest one; all for 0."""
    if not level:
        return shelves
    return shelves[-1:] if level < 0 else shelves[level - 1 : level]
