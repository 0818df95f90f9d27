"""`around`: seats stand around a table and face it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations

from shapely import MultiPoint, Polygon

from robolayout.assets.surfaces import surfaces_of
from robolayout.constraints._exact import TOLERANCE, facing_error, footprint, frame, half_size
from robolayout.constraints._overlap import prisms_meet
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Asset, Layout, Pose, Scene

Slot = tuple[float, float, float]
"""Place of a seat's centre in the table's frame (metres) and its heading there (radians)."""


@dataclass(frozen=True)
class Seating:
    """Where people leave seats at a table, in metres."""

    slack: float = 0.03  # metres by which a seat may stand beside its slot
    usual: float = 0.05  # metres from the edge at which a seat stands that does not go under
    # metres by which people leave a seat under a table, the first that is free
    tucked: tuple[float, float, float] = (0.18, 0.12, 0.06)
    even: float = 1.15  # how many times as long as the other a side of a square or round table is at the most
    round: float = 0.85  # share of its box that a round top fills at the most
    beyond: float = 0.9  # share of a table's half from which on a seat is at that side of it
    spare: float = 0.02  # metres that stay free above and beside a seat that is left under a table


SEATING = Seating()


def left_gap(scene: Scene, items: Sequence[AssetRef], b: AssetRef, slots: Callable[[float], Sequence[Slot]]) -> float:
    """Return the gap at which people leave seats at a table: less than 0 where they go under, `SEATING.usual` where they do not."""
    seats, table = [scene.by_name[item.name] for item in items], scene.by_name[b.name]
    for tuck in SEATING.tucked:
        places = list(zip(seats, slots(-tuck), strict=False))
        if not any(_meeting(table, places, lift) for lift in (0.0, SEATING.spare)):
            return -tuck
    return SEATING.usual


def _meeting(table: Asset, places: Sequence[tuple[Asset, Slot]], lift: float) -> bool:
    """Whether seats that are lifted by so many metres, so that room is left above them, meet the table or each other."""
    there = [(table, Pose(0.0, 0.0, table.size[2] / 2, 0.0))]
    there += [(seat, Pose(x, y, seat.size[2] / 2 + lift, yaw)) for seat, (x, y, yaw) in places]
    return any(prisms_meet(one, other, SEATING.spare) for one, other in combinations(there, 2))


def _is_round(table: Asset) -> bool:
    """Return whether a table is as wide as deep, and its top a circle: pi / 4 of its box."""
    top, (depth, width, _) = max(surfaces_of(table), key=lambda surface: surface.height), table.size
    even = max(depth, width) < SEATING.even * min(depth, width)
    return even and top.region.area < SEATING.round * depth * width


def _side_slots(count: int, side: str, table: tuple[float, float], depth: float, gap: float) -> list[Slot]:
    """Return evenly spaced slots along one side of the table."""
    hx, hy = table
    run, reach = (hy, hx) if side in ("front", "back") else (hx, hy)
    places = [run * (2 * (i + 0.5) / count - 1) for i in range(count)]
    out = reach + gap + depth / 2
    yaw = {"front": math.pi, "back": 0.0, "left": -math.pi / 2, "right": math.pi / 2}[side]
    sign = 1.0 if side in ("front", "left") else -1.0
    return [(sign * out, p, yaw) if side in ("front", "back") else (p, sign * out, yaw) for p in places]


def shares(count: int, table: tuple[float, float], width: float) -> dict[str, int]:
    """Return how many seats go to each side: long sides first in pairs, then the heads, then whatever is left evenly."""
    hx, hy = table
    long, short = (("front", "back"), ("left", "right")) if hy >= hx else (("left", "right"), ("front", "back"))
    room_long = _seats_along(2 * max(hx, hy), max(width, 0.4))
    square = max(hx, hy) < SEATING.even * min(hx, hy)
    if square and count <= 4:
        order = (*long, *short)
        return {side: int(i < count) for i, side in enumerate(order)}
    per_long = min(room_long, (count + 1) // 2)
    heads = 2 if count - 2 * per_long >= 1 or (count >= 6 and count % 2 == 0 and count // 2 - 1 >= 1) else 0
    heads = 1 if count % 2 and 5 <= count <= 2 * room_long + 1 and not square else heads
    rest = max(count - heads, 0)
    result = {long[0]: (rest + 1) // 2, long[1]: rest // 2, short[0]: 0, short[1]: 0}
    for i in range(min(heads, count)):
        result[short[i % 2]] += 1
    return result


def _seats_along(side: float, width: float) -> int:
    return max(1, int(side / width + 1e-6))


def most_seats(table: Asset, seat: Asset) -> int:
    """Return how many seats of a width stand around a table: side by side at its long sides, and one at each end."""
    depth, width, _ = table.size
    if _is_round(table):
        return int(math.pi * (max(depth, width) + seat.size[0]) / seat.size[1])
    return 2 * _seats_along(max(depth, width), seat.size[1]) + 2


@dataclass(frozen=True)
class Around(Relation):
    """The `items` stand evenly around `b`, `gap` m from its edge (None: as people leave them, under it), each facing it."""

    name = "around"
    moves = ("items",)
    orients = True
    surrogate = True  # each at a place of its own, where the check takes any that is even
    example = "solver.around([chair[0], chair[1], chair[2], chair[3]], dining_table[0])"

    items: tuple[AssetRef, ...] = argument("asset", many=True)
    b: AssetRef = argument("asset")
    gap: float | None = argument("number", "none", unit="m", default=None)

    def slots(self, scene: Scene) -> tuple[Slot, ...]:
        """Return the place and heading of each item in b's frame."""
        gap = left_gap(scene, self.items, self.b, lambda gap: self._slots(scene, gap)) if self.gap is None else self.gap
        return self._slots(scene, gap)

    def _slots(self, scene: Scene, gap: float) -> tuple[Slot, ...]:
        table = half_size(scene, self.b)
        sizes = [scene.by_name[item.name].size for item in self.items]
        depth, width = max(s[0] for s in sizes), max(s[1] for s in sizes)
        if _is_round(scene.by_name[self.b.name]):
            out, turns = max(table) + gap + depth / 2, [math.tau * i / len(self.items) for i in range(len(self.items))]
            return tuple((out * math.cos(turn), out * math.sin(turn), turn + math.pi) for turn in turns)
        slots: list[Slot] = []
        for side, count in shares(len(self.items), table, width).items():
            slots += _side_slots(count, side, table, depth, gap)
        return tuple(slots)

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row per item that pins it to the slot that is nearest to its guess."""
        slots = self.slots(scene)
        table = frame(scene, near, self.b)
        here = [table.seen(near[item.name].at) for item in self.items]
        chosen = assignment([[math.dist(spot, slot[:2]) for slot in slots] for spot in here])
        return tuple(
            FrameTerm(
                item,
                self.b,
                along=Interval(x - SEATING.slack, x + SEATING.slack),
                across=Interval(y - SEATING.slack, y + SEATING.slack),
                heading=yaw,
            )
            for item, (x, y, yaw) in zip(self.items, (slots[k] for k in chosen), strict=True)
        )

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Each faces b, at most gap (0.05 if None) + 0.35 m from its edge; opposite sides hold as many within one, walls aside."""
        table = footprint(scene, layout, self.b)
        limit = (SEATING.usual if self.gap is None else self.gap) + 0.30
        gaps = [table.distance(footprint(scene, layout, item)) for item in self.items]
        turned = max(facing_error(scene, layout, item, self.b) for item in self.items)
        uneven = self._uneven(scene, layout)
        met = max(gaps) <= limit + TOLERANCE.gap and turned <= TOLERANCE.angle and uneven <= 1
        text = f"up to {max(gaps):.2f} m from {self.b}, up to {turned:.0f} deg off"
        text += f", {uneven} more at one side than opposite" if uneven > 1 else ""
        return Outcome(met, max(gaps), limit, "m", text)

    def _uneven(self, scene: Scene, layout: Layout) -> int:
        """Return by how many like seats there are more at one side of b than opposite, where the room leaves both sides free."""
        if len({scene.by_name[item.name].size for item in self.items}) > 1:
            return 0  # a bench is opposite three chairs
        here, room = frame(scene, layout, self.b), Polygon(scene.room.vertices)
        seen = [here.seen(layout[item.name].at) for item in self.items]
        depth, uneven = max(scene.by_name[item.name].size[0] for item in self.items), 0
        for axis, half in enumerate(half_size(scene, self.b)):
            ends = [here.point(*((out, 0.0) if axis == 0 else (0.0, out))) for out in (half + depth, -half - depth)]
            if room.contains(MultiPoint(ends)):
                beyond = [at[axis] for at in seen if abs(at[axis]) > SEATING.beyond * half]
                uneven = max(uneven, abs(sum(1 if x > 0 else -1 for x in beyond)))
        return uneven


def assignment(costs: Sequence[Sequence[float]]) -> list[int]:
    """Return a column for each row, no column twice, so that the sum of the costs is smallest.

    The shortest augmenting path algorithm: rows come one by one, and each takes the cheapest chain of exchanges. For the few
    seats of a table this is done before SciPy, which has the same, is even imported. The costs (things, places) are finite, and
    there are at least as many places as things.
    """
    places = len(costs[0]) if costs else 0
    price, worth = [0.0] * places, [0.0] * len(costs)
    taker = [-1] * places
    for row in range(len(costs)):
        best, before, seen = [math.inf] * places, [-1] * places, [False] * places
        here, place = row, -1
        while True:
            for j in range(places):
                extra = costs[here][j] - worth[here] - price[j] + (0.0 if place < 0 else best[place])
                if not seen[j] and extra < best[j]:
                    best[j], before[j] = extra, place
            place = min((j for j in range(places) if not seen[j]), key=best.__getitem__)
            seen[place] = True
            if taker[place] < 0:
                break
            here = taker[place]
        shortest = best[place]
        worth[row] += shortest
        for j in range(places):
            if seen[j] and taker[j] >= 0:
                worth[taker[j]] += shortest - best[j]
            if seen[j]:
                price[j] -= shortest - best[j]
        while place >= 0:
            taker[place] = row if before[place] < 0 else taker[before[place]]
            place = before[place]
    return [taker.index(row) for row in range(len(costs))]
