"""Passages: how wide is the narrowest place on the widest way to each asset?

The clear width to an asset is defined by the very check that it explains: the diameter of the largest disc that, in
this layout, comes in by the door and reaches the asset (same heights, same reach). It is found by bisection over radii
on a lattice of 5 mm; the place is where the widest disc's way is cut when the disc grows by one more step.
"""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial

import numpy as np
import shapely
from shapely import LineString, Polygon

from robolayout.scene import ROUNDING, Agent, Point, Room
from robolayout.verify._boxes import Boxes
from robolayout.verify._obstacles import Obstacles
from robolayout.verify._space import Space, disc_space, further_doors, reached_by
from robolayout.verify.limits import FINE, JUDGE
from robolayout.verify.routes import find_routes


@dataclass(frozen=True)
class Passage:
    """The narrowest place on the widest way to an asset."""

    asset: str  # where the way leads
    # clear width in metres, to 1 cm; 0 if not even a disc of 1 cm gets there, `JUDGE.wide` stands for that or more
    width: float
    # where it is, metres; None where no passage limits the way (open floor, ample width, or an arm too short)
    point: Point | None
    # What stands left and right of it: asset names or "wall 2"; empty where there is no such place. One name twice
    # where the passage leads between two parts of it (the legs of a bed).
    between: tuple[str, ...]
    cut_off: bool = False  # whether one could stand near enough to it, but no disc however small gets there
    # where what stands left and right of it is nearest, metres; one point for each of `between`
    ends: tuple[Point, ...] = ()

    @property
    def sides(self) -> str:
        """What stands left and right of it in words: "bed-0 and wall 1", "parts of bed-0"."""
        if len(self.between) == 2 and self.between[0] == self.between[1]:
            return f"parts of {self.between[0]}"
        return " and ".join(self.between)

    @property
    def shown(self) -> str:
        """The width in words: "0.62 m", "1.50 m or more", "none"."""
        if self.width == 0:
            return "none"
        return f"{self.width:.2f} m" + (" or more" if self.width >= JUDGE.wide - 1e-9 else "")


def largest(holds: Callable[[int], bool], top: int) -> int:
    """Return the largest step in 1..top for which a falling property holds; 0 if none."""
    return top - bisect_left(range(top, 0, -1), True, key=holds)


class Passages:
    """The narrowest passages of one layout; the free space of each radius is worked out once."""

    def __init__(self, room: Room, found: Boxes, blocking: Obstacles, agent: Agent) -> None:
        self._room, self._found, self._obstacles, self._agent = room, found, blocking, agent
        self._space = cache(self._free)

    def to_assets(self, names: Sequence[str]) -> dict[str, Passage]:
        """Return the narrowest passage on the way to each of these placed assets."""
        rows = {name: self._found.names.index(name) for name in names}
        feet = {name: self._found.footprints[row] for name, row in rows.items()}
        found = self._to({name: (feet[name], partial(self._reached, row)) for name, row in rows.items()})
        return {n: replace(p, cut_off=self._stands_near(feet[n])) if p.width == 0 else p for n, p in found.items()}

    def to_doors(self, numbers: Sequence[int]) -> dict[int, Passage]:
        """Return the narrowest passage on the way from the first door to the landing of each of these."""
        thresholds = {n: Polygon(self._room.landing(self._room.doors[n], FINE.step)) for n in numbers}
        found = self._to({f"door {n}": (goal, partial(self._enters, n)) for n, goal in thresholds.items()})
        return {n: replace(p, cut_off=p.width == 0) for n, p in zip(numbers, found.values(), strict=True)}

    def _to(self, goals: Mapping[str, tuple[Polygon, Callable[[int], bool]]]) -> dict[str, Passage]:
        """Return the narrowest passage to each goal: its outline, and whether a disc of so many steps gets there."""
        radius = self._agent.radius
        top = max(math.ceil(JUDGE.wide / 2 / FINE.step), math.floor(radius / FINE.step) + 1)
        widest = {name: largest(holds, top) for name, (_, holds) in goals.items()}
        result = {name: Passage(name, 2 * FINE.step * min(step, top), None, ()) for name, step in widest.items()}
        located = min(top, math.ceil((radius + FINE.located / 2) / FINE.step))
        for step in sorted({step for step in widest.values() if 0 < step < located}):
            group = {name: goals[name][0] for name, found in widest.items() if found == step}
            for name, place in self._necks(step, group).items():
                between, ends = self._neighbours(place, step * FINE.step)
                if len(ends) < 2 or math.dist(*ends) >= 2 * (step - 1) * FINE.step:  # else it stops before these
                    result[name] = replace(result[name], point=place, between=between, ends=ends)
        return result

    def _free(self, step: int) -> tuple[Space, list[bool]]:
        """Return the free space of a disc of `step` lattice steps and what it reaches."""
        radius = step * FINE.step
        space = disc_space(self._room, self._obstacles, radius)
        return space, reached_by(self._found, space, replace(self._agent, radius=radius).reach).tolist()

    def _reached(self, row: int, step: int) -> bool:
        return self._space(step)[1][row]

    def _enters(self, number: int, step: int) -> bool:
        zone = further_doors(self._room, step * FINE.step).get(number)
        return zone is not None and self._space(step)[0].main.intersection(zone).area > JUDGE.sliver

    def _stands_near(self, footprint: Polygon) -> bool:
        """Tell whether the smallest disc could stand within reach of an asset, wherever it came from."""
        free = self._space(1)[0].free
        reach = replace(self._agent, radius=FINE.step).reach
        return not free.is_empty and free.distance(footprint) <= reach + ROUNDING

    def _necks(self, step: int, goals: Mapping[str, Polygon]) -> dict[str, Point]:
        """Return where the ways of the widest disc are cut when it grows by one step."""
        space, grown = self._space(step)[0], self._space(step + 1)[0]
        reopened = grown.free.buffer(1.5 * FINE.step)
        result: dict[str, Point] = {}
        for name, route in find_routes(self._room, space, goals).items():
            cut = shapely.get_parts(route.line.difference(reopened))
            cut = [part for part in cut if isinstance(part, LineString) and part.length > 0]
            if cut:
                middle = max(cut, key=lambda part: part.length).interpolate(0.5, normalized=True)
                result[name] = (float(middle.x), float(middle.y))
        return result

    def _neighbours(self, place: Point, radius: float) -> tuple[tuple[str, ...], tuple[Point, ...]]:
        """Return what touches a disc at a place, the nearest thing and the nearest one across from it, and where."""
        spot = shapely.Point(place)
        names = [f"wall {wall.index}" for wall in self._room.walls]
        names += [self._found.names[row] for row in self._obstacles.rows]
        shapes = [LineString((wall.start, wall.end)) for wall in self._room.walls]
        shapes += list(self._obstacles.shapes)
        feet = shapely.get_coordinates(shapely.shortest_line(spot, np.array(shapes, dtype=object)))[1::2]
        offsets = feet - np.array(place)
        distance = np.hypot(offsets[:, 0], offsets[:, 1])
        first = int(np.argmin(distance))
        across = np.flatnonzero((offsets @ offsets[first] < 0) & (distance <= 2 * radius + 0.05))
        found = [first, *across[np.argsort(distance[across], kind="stable")][:1].tolist()]
        return tuple(names[i] for i in found), tuple((float(x), float(y)) for x, y in feet[found])
