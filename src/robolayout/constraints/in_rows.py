"""`in_rows`: equal things stand in a block of straight rows."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise

from robolayout.constraints._exact import TOLERANCE, angle_between, frame, half_size
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class InRows(Relation):
    """The `items` stand in `rows` (None: any), `aisle` to `widest` m apart, `gap` beside, `central` amid; `backs`: "paired", "facing"."""

    name = "in_rows"
    moves = ("items",)
    surrogate = True  # each keeps the row that it is in, where the check takes any row
    example = "solver.in_rows([desk[0], desk[1], desk[2], desk[3]], aisle=1.2, gap=0.6)"

    items: tuple[AssetRef, ...] = argument("asset", many=True)
    aisle: float = argument("number", unit="m", default=1.0)
    gap: float = argument("number", unit="m", default=0.0)
    backs: str = argument("text", choices=("alike", "paired", "facing"), default="alike")
    rows: int | None = argument("integer", "none", default=None)
    widest: float | None = argument("number", "none", unit="m", default=None)
    central: float = argument("number", unit="m", default=0.0)

    def fault(self, scene: Scene) -> str:
        """Refuse no rows, more rows than things, and aisles that are at most narrower than they are at least."""
        if self.widest is not None and self.widest < self.aisle:
            return f"aisles are at least {self.aisle:g} m wide, so not at most {self.widest:g} m"
        if self.rows is not None and not 1 <= self.rows <= len(self.items):
            return f"{len(self.items)} things stand in 1 to {len(self.items)} rows, not in {self.rows}"
        return ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row for each but the first: where it is in the line that it is near, as far from the next as is asked."""
        first, here = self.items[0], frame(scene, near, self.items[0])
        seen = {item: here.seen(near[item.name].at) for item in self.items}
        ahead = {item: math.cos(near[item.name].yaw - here.yaw) > 0 for item in self.items}
        half, lines = {item: half_size(scene, item) for item in self.items}, self._lines(scene, seen)
        base = next(k for k, line in enumerate(lines) if first in line)
        middles = [0.0 if k == base else seen[line[len(line) // 2]][0] for k, line in enumerate(lines)]
        apart = [
            sum(max(half[item][0] for item in line) for line in two)
            + self.aisle * (self.backs == "alike" or ahead[two[0][0]] or not ahead[two[1][0]])
            for two in pairwise(lines)
        ]
        along = _spread(middles, apart, base)
        across: list[list[float]] = []
        for line in lines:
            line.sort(key=lambda one: seen[one][1])
        longest = max(lines, key=len)
        inner = longest[(len(longest) - 1) // 2 :][:2]
        amid = sum(seen[one][1] for one in inner) / len(inner)
        for line in lines:
            beside = [
                half[one][1] + half[two][1] + max(self.gap, self.central * (seen[one][1] < amid <= seen[two][1]))
                for one, two in pairwise(line)
            ]
            across.append(
                _spread([seen[one][1] for one in line], beside, line.index(first) if first in line else len(line) // 2)
            )
        ends = [(v[0] - half[line[0]][1], v[-1] + half[line[-1]][1]) for v, line in zip(across, lines, strict=True)]
        aside, rows = _aside(ends), list[Term]()
        for u, line, places, off in zip(along, lines, across, aside, strict=True):
            for item, place in zip(line, places, strict=True):
                turned, v = 0.0 if ahead[item] else math.pi, place - off + aside[base]
                term = FrameTerm(item, first, along=Interval(u, u), across=Interval(v, v), heading=turned, moves="both")
                rows += [term] if item != first else []
        return tuple(rows)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Along one line within 10 degrees, by turns with `backs`; straight rows (5 cm) behind each other, as many and as far as asked."""
        here = frame(scene, layout, self.items[0])
        seen = {item: here.seen(layout[item.name].at) for item in self.items}
        apart = [angle_between(layout[item.name].yaw, here.yaw) for item in self.items]
        turned = max(min(off, 180.0 - off) for off in apart)
        lines = self._lines(scene, seen)
        ahead = [{math.cos(layout[item.name].yaw - here.yaw) > 0 for item in line} for line in lines]
        off = max(seen[line[-1]][0] - seen[line[0]][0] for line in lines)
        longest = max(map(len, lines))
        even = len(lines) == (self.rows or len(lines))
        even = even and longest <= math.ceil(len(self.items) / (self.rows or min(len(lines), 2)))
        even = even and (longest == 1 or sum(len(line) == 1 for line in lines) < 2)  # strays are no rows
        turns = [[{(k % 2 == first) == (self.backs == "facing")} for k in range(len(lines))] for first in (0, 1)]
        by_turns = self.backs == "alike" or ahead in turns[: 1 + len(lines) % 2]  # one row of three is by itself
        close, aside, aisles = self._measured(scene, seen, lines, ahead)
        central = self._central(scene, seen) if self.central else 0.0
        met = off <= 2 * TOLERANCE.gap and turned <= TOLERANCE.angle and even and by_turns
        text = f"{len(lines)} rows of at most {longest}, up to {off:.2f} m out of line, {turned:.0f} deg off"
        text += f", {min(aisles):.2f} m apart" if aisles else ""
        text += f", one {aside:.2f} m beside the others" if aside > TOLERANCE.gap else ""
        text += f", {central:.2f} m of aisle through them" if self.central else ""
        met = met and max(close, aside, self.central - central) <= TOLERANCE.gap
        return Outcome(met, max(off, close, aside), 2 * TOLERANCE.gap, "m", text)

    def _lines(self, scene: Scene, seen: Mapping[AssetRef, tuple[float, float]]) -> list[list[AssetRef]]:
        """Return the rows, from the back to the front of the first one, where each is as seen from there."""
        lines: list[list[AssetRef]] = []
        for item in sorted(self.items, key=lambda one: (seen[one], one)):
            if not lines or seen[item][0] - seen[lines[-1][0]][0] >= half_size(scene, self.items[0])[0]:
                lines.append([])
            lines[-1].append(item)
        return lines

    def _central(self, scene: Scene, seen: Mapping[AssetRef, tuple[float, float]]) -> float:
        """Return how wide the widest straight way between all of them is that leaves at least a third of them on each side, in metres."""
        spans = sorted((seen[i][1] - half_size(scene, i)[1], seen[i][1] + half_size(scene, i)[1]) for i in self.items)
        ends = list(accumulate((end for _, end in spans), max))
        few = range(math.ceil(len(spans) / 3), len(spans) - math.ceil(len(spans) / 3) + 1)
        return max((spans[k][0] - ends[k - 1] for k in few if k < len(spans)), default=0.0)

    def _measured(
        self,
        scene: Scene,
        seen: Mapping[AssetRef, tuple[float, float]],
        lines: Sequence[Sequence[AssetRef]],
        ahead: Sequence[set[bool]],
    ) -> tuple[float, float, list[float]]:
        """Return how much too close (or far) two are, how far a row is beside the longest one, and the widths of the aisles, in metres."""
        half = {item: half_size(scene, item) for item in self.items}
        ends = [[[seen[i][k] + sign * half[i][k] for i in line for sign in (-1, 1)] for line in lines] for k in (0, 1)]
        aisles = [
            min(two) - max(one)
            for (one, two), ways in zip(pairwise(ends[0]), pairwise(ahead), strict=True)
            if self.backs == "alike" or ways != ({False}, {True})
        ]
        places = [sorted(zip(line[::2], line[1::2], strict=True)) for line in ends[1]]
        gaps = [two[0] - one[1] for line in places for one, two in pairwise(line)]
        close = max(self.aisle - min(aisles, default=math.inf), self.gap - min(gaps, default=math.inf))
        close = max(close, max(aisles, default=0.0) - (math.inf if self.widest is None else self.widest))
        aside = _aside([(min(line), max(line)) for line in ends[1]])
        return close, max(map(abs, aside)), aisles


def _aside(rows: Sequence[tuple[float, float]]) -> list[float]:
    """Return by how many metres the middle of each row lies beside the longest one, to the left of it if positive."""
    low, high = max(rows, key=lambda row: round(row[1] - row[0], 3))  # of equals the first
    middles = [(start + end) / 2 for start, end in rows]
    return [max(middle - high, 0.0) - max(low - middle, 0.0) for middle in middles]


def _spread(places: Sequence[float], apart: Sequence[float], fixed: int) -> list[float]:
    """Return places in order, each at least so far from the next, the one that is fixed where it is."""
    found = list(places)
    for k in range(fixed + 1, len(found)):
        found[k] = max(found[k], found[k - 1] + apart[k - 1])
    for k in range(fixed - 1, -1, -1):
        found[k] = min(found[k], found[k + 1] - apart[k])
    return found
