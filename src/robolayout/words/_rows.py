"""Straight rows, circles and the like of like things: how many lines are meant, and the statement that says it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from robolayout.constraints import AssetRef, PointRef, WallRef
from robolayout.constraints.in_rows import InRows
from robolayout.constraints.in_shape import InShape
from robolayout.scene import Asset, Room, Scene
from robolayout.words import _function_words as small
from robolayout.words._said import Link
from robolayout.words._ways import (
    ACROSS,
    AISLE,
    BACK,
    BESIDE,
    BETWEEN_BEDS,
    CROWD,
    IN_A_CHAIN,
    MIDDLE_AISLE,
    MORE,
    NEAR,
    Ways,
    looks_over,
    rows_of,
)
from robolayout.words.demands import Demand, single, stated

WIDER = 1.5
"""How many times as many things are abreast as there are rows, where neither is said."""

ASIDE = 1.25
"""How many times as wide as is said the aisle between rows is at the most that face each other across it."""

End = AssetRef | PointRef
"""What a thing can stand between."""


def usual_rows(count: int) -> int:
    """Return in how many rows so many things look somewhere, if nobody says."""
    return round(math.sqrt(count / WIDER))


def alike(scene: Scene, names: Sequence[str]) -> bool:
    """Return whether several things of one size stand on the floor."""
    things = [scene.by_name[name] for name in names]
    return len(things) > 1 and len({thing.size for thing in things}) == 1 and things[0].on_floor


def lines(scene: Scene, link: Link, names: Sequence[str]) -> int | None:
    """Return in how many lines like things stand: as many as are said, or files where such lines are longer than the room.

    Where neither how many things nor how many lines is said, and there are as many as are then taken, in as many as that.
    """
    things = [mention.thing for mention in link.subjects]
    usual = things[0].rows if [thing.count for thing in things if thing.number is None] == [len(names)] else 0
    rows = 1 if link.relation == "row" else link.rows or usual
    if not 0 < rows <= len(names):
        return None
    across = math.ceil(len(names) / rows)
    x0, y0, x1, y1 = scene.room.bounds
    long = rows > 1 and across * scene.by_name[names[0]].size[1] > max(x1 - x0, y1 - y0)
    return across if long or link.relation == "columns" else rows


def _takes_no_place(thing: Asset) -> bool:
    """Return whether a thing takes no place beside others: a rug lies before them as well, a soap dispenser on them."""
    return thing.is_flat or (thing.on_object and not thing.on_floor)


class ToldRows:
    """What is said of straight rows and shapes: how wide they are, how they are turned to each other, and what stands between them."""

    def __init__(self, scene: Scene, links: Sequence[tuple[Link, Sequence[str], Sequence[str]]]) -> None:
        self.scene, seats = scene, (*small.SEATS,)
        # beside these others stand, so that they are no unbroken row
        self.flanked = {
            name
            for link, about, to in links
            if link.relation in ("amid", "flank") or (link.relation in small.AT_SIDES and len(about) > 1)
            if not all(_takes_no_place(scene.by_name[one]) for one in about)
            if link.relation == "amid" or not all(scene.by_name[one].category.endswith(seats) for one in about)
            for name in to
        }
        # over the backs of desks look those who sit at them
        self.turned = {
            name: "facing" if link.relation == "mutual" and "desk" not in scene.by_name[name].category else "paired"
            for link, about, _ in links
            if link.relation in ("mutual", "backs")
            for name in about
        }
        told = [link for link in links if link[0].relation in ("row", "rows", "columns") and alike(scene, link[1])]
        spaced = (link for link in links if link[0].relation == "apart" and not (link[2] or link[0].objects))
        # how far apart things or their rows are
        self.apart = {name: link.metres[0] for link, named, _ in spaced for name in named}
        # "1.2 m of free floor around the benches" is between them, too
        all_sides = len(small.FREED["around"])
        around = (link for link in links if link[0].relation == "cleared" and len(link[0].objects) == all_sides)
        free = {name: link.metres[0] for link, named, _ in around for name in named}
        # how many of each stand together, apart from the others
        each = [(named, link.rows) for link, named, _ in links if link.relation == "groups"]
        shared = ((link, named) for link, named, _ in links if link.relation == "shares")
        each += [(named, math.ceil(len(named) / max(link.rows, 1))) for link, named in shared]
        self.each = {name: count for named, count in each for name in named}
        abreast = (named for link, named, _ in links if link.relation == "abreast" and alike(scene, named))
        # of those that are side by side, the one that tells how the others are turned
        self.middle = {name: named[len(named) // 2] for named in abreast for name in named}
        self.gap = {name: max(link.metres[0], free.get(name, 0.0)) for link, named, _ in told for name in named}
        self.aisle = free | self.apart
        self.central = {name: MIDDLE_AISLE for link, named, _ in told if link.sided == "aisle" for name in named}
        counted = [(named, lines(scene, link, named)) for link, named, _ in told]
        facing = {name for link, named, _ in links if link.relation == "facing" for name in named}
        # what stands in rows of which no number is said and looks somewhere: in about as many rows as are usual
        free = (named for named, count in counted if count is None and len(named) > 3)
        self.uncounted = {name: usual_rows(len(named)) for named in free for name in named if name in facing}
        self.count = {name: count for named, count in counted for name in named} | self.uncounted
        self.abreast = {name: math.ceil(len(named) / (self.count[name] or 1)) for _, named, _ in told for name in named}
        formed = ((link.relation, named) for link, named, _ in links if link.relation in small.SHAPES)
        # "tables in a U and two chairs behind each": who sits there looks into it
        behind = {b for link, _, to in links if link.relation == "behind" for b in to}
        desks = {one.name for one in scene.assets if one.category.endswith("desk")}
        out = {one.name for one in scene.assets if looks_over(one)} - (behind - desks)
        self.shape = {
            name: InShape(tuple(map(AssetRef, named)), small.SHAPES[relation], "out" if name in out else "in")
            for relation, named in formed
            if len(named) > 2 and alike(scene, named)
            for name in named
        }
        self.abreast |= {name: len(shape.items) for name, shape in self.shape.items()}

    def in_rows(self, names: Sequence[str]) -> bool:
        """Return whether all of some things stand in straight rows, or in a shape."""
        return {*names} <= {*self.abreast}

    def chained(self, relation: str, name: str) -> Ways:
        """Return what each of several is asked to be to the one before it: so many metres beside it, where that is said."""
        apart = self.aisle.get(name, 0.0)
        if apart and relation == "abreast":
            return ((("next_to", "beside", round(apart + MORE, 2), apart), ("align_with",)),)
        return IN_A_CHAIN[relation]

    def groups(self, names: Sequence[str]) -> list[Sequence[str]]:
        """Return things as the groups in which they stand."""
        count = max(self.each[names[0]], 1)
        return [names[i : i + count] for i in range(0, len(names), count)]

    def before(self, names: Sequence[str], others: Sequence[str] = (), *, facing: bool = False) -> list[str]:
        """Return the middle one of straight rows, or of several abreast, that look at another thing or stand before it.

        None where all of a row fit before it. A crowd of seats `facing` something is in rows, though nobody says so.
        """
        wide = sum(self.scene.by_name[name].size[1] for name in names)
        if len(names) < 2 or any(wide <= self.scene.by_name[other].size[1] for other in others):
            return []
        if len(names) > 2 and self.in_rows(names):
            return [names[self.abreast[names[0]] // 2]]
        sat_on = self.scene.by_name[names[0]].category.endswith((*small.SEATS, "floor cushion"))
        if facing and sat_on and len(names) >= CROWD and names[0] not in self.shape and alike(self.scene, names):
            return [names[math.ceil(len(names) / rows_of(len(names))) // 2]]
        middles = {self.middle.get(name) for name in names}
        return [name for name in names if middles == {name}]

    def block(self, names: Sequence[str]) -> Demand:
        """Return that such things stand in their rows, in any number of them where none is said, or in their shape."""
        if names[0] in self.shape:
            return single(self.shape[names[0]])
        turned, amid = self.turned.get(names[0], "alike"), names[0] in self.flanked
        gap, aisle = self.gap.get(names[0], 0.0), self.aisle.get(names[0], 0.0)
        count = self.count.get(names[0])
        gap, aisle = (max(gap, aisle), 0.0) if count == 1 else (gap, aisle)  # "in a row, 1.2 m apart"
        others = [k for k in range(2, len(names) // 2 + 1) if k != count] if names[0] in self.uncounted else []
        ways = [(k, turned) for k in (count, *others)]
        if self.scene.by_name[names[0]].category.endswith((*small.SLEPT_ON,)):
            gap, ways = gap or BETWEEN_BEDS, [(2, "facing")] * (ways == [(2, "alike")]) + ways  # heads at both walls
        central = self.central.get(names[0], 0.0)
        first, *also = (in_rows(names, k, how, amid=amid, gap=gap, aisle=aisle, central=central) for k, how in ways)
        return replace(first, also=tuple(way for block in also for way in block.ways))

    def opening(self, names: Sequence[str], to: Sequence[End]) -> Iterator[Demand]:
        """Yield that a shape is open to something that it stands before; a circle has it in its middle."""
        shape = self.shape[names[0]]
        for b in to:
            if isinstance(b, PointRef):
                yield self.block(names) if shape.shape == "circle" else single(stated("point_towards", shape.head, b))
            elif shape.shape == "circle":
                yield from (single(stated("point_towards", item, b)) for item in shape.items)
            else:
                turn = math.degrees(shape.slots(self.scene)[shape.head.name].yaw) + 180.0
                before = stated("in_front_of", shape.head, b, 0.0, ACROSS)
                yield Demand(((stated("align_with", shape.head, b, round(turn % 360.0, 3)), before),))


def in_rows(
    names: Sequence[str],
    rows: int | None,
    backs: str = "alike",
    *,
    amid: bool = False,
    gap: float = 0.0,
    aisle: float = 0.0,
    central: float = 0.0,
) -> Demand:
    """Return that things stand in a block of so many straight rows, any number for None; perhaps with something amid them."""
    items = tuple(AssetRef(name) for name in names)
    usual = {"facing": NEAR, "paired": BESIDE}.get(backs, 0.0)  # rows of which no more is said may stand back to back
    apart = aisle or (AISLE if amid and rows != 1 else usual)
    widest = round(ASIDE * aisle, 3) if aisle and backs == "facing" else None  # across that aisle, not across the room
    return single(InRows(items, apart, gap, backs, rows, widest, central))


def on_a_wall(names: Sequence[str], room: Room) -> Iterator[Demand]:
    """Yield that each of several things hangs near the one before it, on the same wall."""
    for one, two in pairwise(map(AssetRef, names)):
        near = stated("near", one, two, BACK)
        walls = [WallRef(wall.index) for wall in room.walls]
        yield Demand(tuple((near, stated("mounted_on", one, w), stated("mounted_on", two, w)) for w in walls))


def neighbours(items: Sequence[End], gaps: int) -> list[tuple[End, End]]:
    """Return each two that stand next to each other in rows that have so many gaps between them.

    >>> [(a.name, b.name) for a, b in neighbours([AssetRef(name) for name in "abcd"], 2)]
    [('a', 'b'), ('c', 'd')]
    """
    rows, pairs = len(items) - gaps, list(pairwise(items))
    if not 1 < rows < len(items) or len(items) % rows:
        return pairs
    return [two for i, two in enumerate(pairs, 1) if i % (len(items) // rows)]
