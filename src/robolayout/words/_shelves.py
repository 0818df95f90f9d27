"""Which things go onto the shelves of others: what is said to be in them, or on what is called a shelf, as long as there is room."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from robolayout.assets.surfaces import Surface, hold_all, open_shelves, slots
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
        if level and shelves:
            yield from (((a, b), shelf) for a, shelf in _dealt([assets[a] for a in names], shelves))
        elif hold_all(shelves, [assets[a].size for a in names]):
            yield from (((a, b), "") for a in names)


def _meant(shelves: tuple[Surface, ...], level: int) -> tuple[Surface, ...]:
    """Return the shelves, side by side, of a level that is counted from below, or -1 for the highest one; all for 0."""
    heights = sorted({round(shelf.height, 3) for shelf in shelves})
    meant = heights[-1:] if level < 0 else heights[level - 1 : level]
    return tuple(shelf for shelf in shelves if not level or round(shelf.height, 3) in meant)


def _dealt(things: Iterable[Asset], shelves: tuple[Surface, ...]) -> Iterator[tuple[str, str]]:
    """Yield things by name with the name of the shelf that each gets: the first one with room, else the first one of all."""
    taken = dict.fromkeys(shelves, Fraction(0))
    for thing in things:
        room = {shelf: slots(shelf, thing.size) for shelf in shelves}
        shelf = next((one for one, many in room.items() if many and taken[one] + Fraction(1, many) <= 1), shelves[0])
        taken[shelf] += Fraction(1, max(room[shelf], 1))
        yield thing.name, shelf.name
