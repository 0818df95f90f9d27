"""Which things go onto the shelves of others: what is said to be in them, or on what is called a shelf, as long as there is room."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from robolayout.assets.surfaces import open_shelves, slots
from robolayout.scene import Asset
from robolayout.words._places import Asked
from robolayout.words._said import Link


def shelved(assets: Mapping[str, Asset], asked: Iterable[tuple[Link, Asked]]) -> Iterator[tuple[str, str]]:
    """Yield what is put onto shelves, with that of which they are, where all that words put there has a place."""
    held: dict[str, list[str]] = {}
    for a, b in (two for link, it in asked if link.shelves for two in it.twos):
        if assets[a].on_object and a not in held.setdefault(b, []):
            held[b].append(a)
    for b, names in held.items():
        shelves = open_shelves(assets[b])
        room = [sum(slots(shelf, assets[a].size) for shelf in shelves) for a in names]
        if all(room) and sum(1 / many for many in room) <= 1.0:
            yield from ((a, b) for a in names)
