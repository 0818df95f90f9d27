"""Doors and windows of a room that is made from words: those that are asked for, else what is usual."""

from __future__ import annotations

import math
from collections.abc import Sequence, Set
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from robolayout.words import COMPASS, WantedOpening

Outline = list[tuple[float, float]]


@dataclass(frozen=True)
class Openings:
    """How doors and windows are made."""

    aside: float = 0.3
    flanked: float = 1.2
    """Metres between a door and the nearer end of its wall: usually, and where things are to stand on both sides of it."""
    large: tuple[float, float] = (2.2, 1.5)
    usual: tuple[float, float] = (1.8, 1.3)
    """Width and height in metres of a large window and of a usual one."""
    window_each: float = 12.0
    door_each: float = 90.0
    """Square metres of floor for each window and door of a room of which neither is said: the usual one aside, so many more."""
    most_windows: int = 6
    most_doors: int = 2
    """How many windows and doors there are at the most where nothing is said."""
    lintel: float = 0.05  # metres at the least between the top of a door or window and the ceiling
    most_of_a_wall: float = 0.45  # share of its wall that one window takes at the most


OPENINGS = Openings()


@dataclass(frozen=True)
class Told:
    """What words say of a room's doors and windows."""

    wanted: Sequence[WantedOpening] = ()  # such as are asked for
    doors: tuple[int, int] = (1, OPENINGS.most_doors)
    windows: tuple[int, int] = (1, OPENINGS.most_windows)
    """How few and how many there are at the most where no number is asked for."""
    flanked: bool = False  # whether things are to stand on both sides of a door
    # walls, by compass, at which things are to stand, and such at which high ones are: no door and no window is made in these
    # where another wall can have it
    held: Set[str] = frozenset()
    high: Set[str] = frozenset()
    corners: Sequence[
        Set[str]
    ] = ()  # by the compass of their two walls, those where things are to stand: no door is beside one


Opening = dict[str, float]


def openings(
    outline: Outline,
    wide: float,
    told: Told,
    rng: np.random.Generator,
    height: float = 2.6,
    *,
    varied: bool = False,
) -> tuple[list[Opening], list[Opening]]:
    """Return doors near the ends of long walls (varied: somewhere in any wall), and windows in other walls.

    Args:
        outline: Corners of the floor, metres.
        wide: Width of a door in metres.
        told: What is asked for.
        rng: Settles what is not.
        height: Height of the walls in metres; doors and windows are lower.
        varied: Whether doors may be where they are less usual.
    """
    lengths = [math.dist(a, b) for a, b in zip(outline, outline[1:] + outline[:1], strict=True)]
    order = sorted(range(len(lengths)), key=lambda i: -lengths[i])
    usual = order[int(rng.integers(0, len(order) if varied else min(2, len(order))))]
    along = float(rng.random()) if varied else float(rng.random() < 0.5)
    corners = [*outline, outline[0]]
    area = abs(sum(ax * by - bx * ay for (ax, ay), (bx, by) in pairwise(corners))) / 2
    asked = [item for item in told.wanted if item.kind == "door"]
    asked = asked or [WantedOpening("door", _within(told.doors, 1 + int(area / OPENINGS.door_each)))]
    full, high = ({i for word in words for i in _meant(outline, word)} for words in (told.held, told.high))
    doors: list[Opening] = []
    for number, item in enumerate(i for i in asked for _ in range(i.count)):
        fits = [i for i in order if lengths[i] > wide and i not in {d["wall"] for d in doors}] or order
        fits = [i for i in fits if i not in full] or fits
        start = fits.index(usual) if usual in fits and not number else 0
        wall = _wall(outline, item.wall, fits[start:] + fits[:start])
        first = min(OPENINGS.flanked if told.flanked else OPENINGS.aside, (lengths[wall] - wide) / 2)
        offset = first + (1.0 - _aside(outline, wall, along, told.corners, full)) * (lengths[wall] - wide - 2 * first)
        doors.append(
            {
                "wall": wall,
                "offset": round(max(offset, 0.0), 2),
                "width": min(wide, lengths[wall]),
                "height": min(2.05, height - OPENINGS.lintel),
            }
        )
    more = _within(told.windows, max(1 + int(rng.integers(0, 2)), int(area / OPENINGS.window_each)))
    windows = [item for item in told.wanted if item.kind == "window"] or [WantedOpening("window", more)]
    taken = {int(d["wall"]) for d in doors}
    taken |= high if len(taken | high) < len(lengths) else set[int]()
    return doors, _windows(outline, lengths, taken, windows, rng, height)


def _within(limits: tuple[int, int], number: int) -> int:
    return min(max(number, limits[0]), limits[1])


def _aside(outline: Outline, wall: int, along: float, corners: Sequence[Set[str]], full: Set[int]) -> float:
    """Return where along a wall (1 at its start) a door is: at its other end, or in the middle, where its end is to be free."""
    meant = [[set(_meant(outline, word)) for word in words] for words in corners]
    beside = ((wall - 1) % len(outline), (wall + 1) % len(outline))
    start, end = (2 * any(all({wall, to} & walls for walls in pair) for pair in meant) + (to in full) for to in beside)
    if start == end:
        return 0.5 if start > 1 else along
    return min(along, 1.0 - along) if start > end else max(along, 1.0 - along)


def _windows(
    outline: Outline,
    lengths: Sequence[float],
    taken: set[int],
    asked: Sequence[WantedOpening],
    rng: np.random.Generator,
    ceiling: float,
) -> list[Opening]:
    """Return the windows, in two outer walls where no wall is said."""
    free = [i for i in sorted(range(len(lengths)), key=lambda i: -lengths[i]) if i not in taken]
    outer = free[: int(rng.integers(1, 3))] if len(asked) == 1 and not asked[0].wall else free
    by_wall: dict[int, list[WantedOpening]] = {}
    for turn, wanted_one in enumerate(i for i in asked for _ in range(i.count)):
        order = outer[turn % len(outer) :] + outer[: turn % len(outer)] if outer else [0]
        by_wall.setdefault(_wall(outline, wanted_one.wall, order), []).append(wanted_one)
    found: list[Opening] = []
    for wall, items in by_wall.items():
        share = lengths[wall] / len(items)
        middle = float(rng.choice([0.35, 0.5, 0.65])) if len(items) == 1 and not items[0].wall else 0.5
        for number, item in enumerate(items):
            width, height = OPENINGS.large if item.large else OPENINGS.usual
            sill = min(0.9, ceiling - height - OPENINGS.lintel) if ceiling - height > OPENINGS.lintel else 0.0
            height = round(min(height, ceiling - sill - OPENINGS.lintel), 2)
            width = round(min(width, share * OPENINGS.most_of_a_wall if len(items) == 1 else share * 0.7), 2)
            start = round(number * share + (share - width) * middle, 2)
            found.append({"wall": wall, "offset": start, "width": width, "height": height, "sill": sill})
    return found


def _wall(outline: Outline, word: str, order: Sequence[int]) -> int:
    """Return the first of some walls that is meant by a word; the first of all that it means where none of them is."""
    meant = _meant(outline, word)
    return next((i for i in order if i in meant), [*meant, order[0]][0])


def _meant(outline: Outline, word: str) -> list[int]:
    """Return the walls that a word of the compass means, none for other words."""
    ring = list(zip(outline, outline[1:] + outline[:1], strict=True))
    nx, ny = COMPASS.get(word, (0.0, 0.0))
    return [
        i
        for i, ((ax, ay), (bx, by)) in enumerate(ring)
        if (-(by - ay) * nx + (bx - ax) * ny) / math.dist(*ring[i]) > math.sqrt(0.5)
    ]
