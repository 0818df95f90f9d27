"""`in_rows`: equal things stand in a block of straight rows."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from robolayout.constraints._exact import TOLERANCE, angle_between, frame
from robolayout.constraints._refs import AssetRef
from robolayout.constraints._relation import FrameTerm, Interval, Outcome, Relation, Term, argument
from robolayout.scene import Layout, Scene


@dataclass(frozen=True)
class InRows(Relation):
    """The `items` stand in straight, even `rows` (None: any), at least `aisle` m apart, `gap` m beside; `backs`: "paired" or "facing"."""

    name = "in_rows"
    moves = ("items",)
    surrogate = True  # each keeps the row that it is in, where the check takes any row
    example = "solver.in_rows([desk[0], desk[1], desk[2], desk[3]], aisle=1.2, gap=0.6)"

    items: tuple[AssetRef, ...] = argument("asset", many=True)
    aisle: float = argument("number", unit="m", default=1.0)
    gap: float = argument("number", unit="m", default=0.0)
    backs: str = argument("text", choices=("alike", "paired", "facing"), default="alike")
    rows: int | None = argument("integer", "none", default=None)

    def fault(self, scene: Scene) -> str:
        """Refuse no rows, and more rows than things."""
        if self.rows is not None and not 1 <= self.rows <= len(self.items):
            return f"{len(self.items)} things stand in 1 to {len(self.items)} rows, not in {self.rows}"
        return ""

    def terms(self, scene: Scene, near: Layout) -> tuple[Term, ...]:
        """Return one row for each but the first: where it is in the line that it is near, as far from the next as is asked."""
        first, here = self.items[0], frame(scene, near, self.items[0])
        depth, width, _ = scene.by_name[first.name].size
        seen = {item: here.seen(near[item.name].at) for item in self.items}
        ahead = {item: math.cos(near[item.name].yaw - here.yaw) > 0 for item in self.items}
        lines: list[list[AssetRef]] = []
        for item in sorted(self.items, key=lambda one: seen[one]):
            if not lines or seen[item][0] - seen[lines[-1][0]][0] >= depth / 2:
                lines.append([])
            lines[-1].append(item)
        base = next(k for k, line in enumerate(lines) if first in line)
        close = [self.backs != "alike" and not ahead[a[0]] and ahead[b[0]] for a, b in pairwise(lines)]
        middles = [0.0 if k == base else seen[line[len(line) // 2]][0] for k, line in enumerate(lines)]
        along = _spread(middles, [depth + self.aisle * (not backs) for backs in close], base)
        rows: list[Term] = []
        for u, line in zip(along, lines, strict=True):
            line.sort(key=lambda one: seen[one][1])
            fixed = line.index(first) if first in line else len(line) // 2
            across = _spread([seen[one][1] for one in line], [width + self.gap] * (len(line) - 1), fixed)
            for item, v in zip(line, across, strict=True):
                turned = 0.0 if ahead[item] else math.pi
                term = FrameTerm(item, first, along=Interval(u, u), across=Interval(v, v), heading=turned, moves="both")
                rows += [term] if item != first else []
        return tuple(rows)

    def check(self, scene: Scene, layout: Layout) -> Outcome:
        """Along one line within 10 degrees, by turns with `backs`; rows straight within 5 cm, as many and as far apart as asked."""
        here = frame(scene, layout, self.items[0])
        apart = [angle_between(layout[item.name].yaw, here.yaw) for item in self.items]
        turned = max(min(off, 180.0 - off) for off in apart)
        depth, width, _ = scene.by_name[self.items[0].name].size
        lines: list[list[tuple[float, float]]] = []
        ahead: list[set[bool]] = []
        for (u, v), item in sorted((here.seen(layout[item.name].at), item) for item in self.items):
            if not lines or u - lines[-1][0][0] >= depth / 2:
                lines.append([])
                ahead.append(set())
            lines[-1].append((u, v))
            ahead[-1].add(math.cos(layout[item.name].yaw - here.yaw) > 0)
        off = max(line[-1][0] - line[0][0] for line in lines)
        longest = max(map(len, lines))
        even = self.rows is None or (len(lines) == self.rows and longest <= math.ceil(len(self.items) / self.rows))
        turns = [[{(k % 2 == first) == (self.backs == "facing")} for k in range(len(lines))] for first in (0, 1)]
        aisles = [
            two[0][0] - one[-1][0] - depth
            for (one, two), ways in zip(pairwise(lines), pairwise(ahead), strict=True)
            if self.backs == "alike" or ways != ({False}, {True})
        ]
        gaps = [b - a - width for line in lines for a, b in pairwise(sorted(v for _, v in line))]
        close = max(self.aisle - min(aisles, default=math.inf), self.gap - min(gaps, default=math.inf))
        met = (
            off <= 2 * TOLERANCE.gap
            and turned <= TOLERANCE.angle
            and even
            and (self.backs == "alike" or ahead in turns[: 1 + len(lines) % 2])  # one row of three is by itself
            and close <= TOLERANCE.gap
        )
        text = f"{len(lines)} rows of at most {longest}, up to {off:.2f} m out of line, {turned:.0f} deg off"
        text += f", {min(aisles):.2f} m apart" if aisles else ""
        return Outcome(met, max(off, close), 2 * TOLERANCE.gap, "m", text)


def _spread(places: Sequence[float], apart: Sequence[float], fixed: int) -> list[float]:
    """Return places in order, each at least so far from the next, the one that is fixed where it is."""
    found = list(places)
    for k in range(fixed + 1, len(found)):
        found[k] = max(found[k], found[k - 1] + apart[k - 1])
    for k in range(fixed - 1, -1, -1):
        found[k] = min(found[k], found[k + 1] - apart[k])
    return found
