"""A row of the ledger before a layout is known, and what its phrase is judged by."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

from shapely import Point, Polygon, get_parts
from shapely.geometry.base import BaseGeometry

from robolayout.assets import category_of
from robolayout.constraints import AssetRef, Relation
from robolayout.constraints._exact import footprint
from robolayout.constraints.between import BetweenTwo
from robolayout.scene import Layout, Room, Scene
from robolayout.words import _function_words as small
from robolayout.words._lexicon import grammar
from robolayout.words._said import Item, Place
from robolayout.words._tokens import Measure
from robolayout.words.demands import Demand

Verdict = Literal["met", "unmet", "not judged", "not understood"]

SIZE_OFF, AREA_OFF = 0.1, 0.03
"""Metres by which the sides and the height of a room, and share by which its area, may differ from what was asked."""

Finding = tuple[Verdict, str]

AIRY = 0.3
"""Share of the floor that furniture takes at the most in an airy room; usual rooms have a quarter to two fifths."""

SEAT = 0.5
"""Metres of a bench or sofa that one person takes."""

ZONES = (" area", " zone", " section", " space", " nook")
"""Ends of names of a part of a room."""

UP_TO = 0.5
"""Metres between a body's edge and what a way leads up to."""


LAID = 0.02
"""Metres by which the bottom of what stands on a top, or within it, is off that top or the floor."""

UNDER = 0.01
"""Square metres below a thing at which the middle of a body that gets under it can be."""


@dataclass(frozen=True)
class Furnished:
    """What rows are judged by: a scene, a layout of it, and where the centre of its first body gets to from the door."""

    scene: Scene
    layout: Layout
    walked: BaseGeometry | None = None

    def walked_by(self, wide: float) -> BaseGeometry | None:
        """Return where the middle of a disc so many metres wide gets to from the first door, wider than the body or as that."""
        further = wide / 2 - self.scene.agents[0].radius
        if self.walked is None or further <= 0.0:
            return self.walked
        parts, room = get_parts(self.walked.buffer(-further)).tolist(), self.scene.room
        inside = [Polygon(room.landing(door)) for door in room.doors[:1]] or [Polygon(room.vertices)]
        return min(parts, key=lambda part: part.distance(inside[0]), default=Polygon())


@dataclass(frozen=True)
class Unjudged:
    """A phrase before a layout is known: `judge` says how it stands in one."""

    words: str
    kind: str
    understanding: str
    judge: Callable[[Furnished], Finding]
    things: tuple[str, ...] = ()
    demands: tuple[Demand, ...] = ()

    @property
    def said(self) -> Iterator[Relation]:
        """The statements that it asks for, every way of each demand."""
        return (said for demand in self.demands for way in demand.ways for said in way)


def met(good: bool, value: str) -> Finding:
    """Return whether a phrase is met, with what was measured."""
    return ("met" if good else "unmet"), value


def said(demand: Demand) -> str:
    """Return a demand in words."""
    if isinstance(demand.exact, BetweenTwo):
        return f"{demand.exact.a} between {demand.exact.b} and {demand.exact.c}"
    if demand.exact is not None:
        return demand.exact.sentence()
    if demand.gap is not None:
        return f"{demand.gap.a} {demand.gap.asked} from {' or '.join(map(str, demand.gap.to))}"
    first = ", ".join(relation.sentence() for relation in demand.ways[0])
    return f"{first} or one of {len(demand.ways) - 1} other ways" if len(demand.ways) > 1 else first


def shown(item: Item) -> str:
    """Return a thing or place in words."""
    if isinstance(item, Place):
        return " ".join((*item.words, item.name, *((item.by[0], item.by[1].name) if item.by is not None else ())))
    return item.thing.noun.said


def unread(words: str, why: str) -> Unjudged:
    """Return the row of words that were not understood."""
    return Unjudged(words, "not understood", why, lambda room: ("not understood", ""))


def found(alike: bool, said: str) -> Finding:
    """Return what a look that was found says."""
    return ("met" if alike else "not judged"), said or "nothing is said of it"


def mood(word: str) -> Unjudged:
    """Return the row of a word of taste: two moods can be judged, the others cannot."""
    lists = grammar()
    if word.lower() in lists.airy:
        return Unjudged(word, "style", f"furniture takes at most {AIRY:.0%} of the floor", airy)
    if word.lower() in lists.cosy["words"]:
        return Unjudged(word, "style", "something soft and a warm light", cosy)
    return Unjudged(word, "style", "a matter of taste", taste)


def airy(room: Furnished) -> Finding:
    """Judge how much of the floor furniture takes."""
    sizes = [asset.size for asset in room.scene.assets if asset.on_floor and not asset.is_flat]
    share = sum(depth * width for depth, width, _ in sizes) / room.scene.room.area
    return met(share <= AIRY, f"it takes {share:.0%}")


def cosy(room: Furnished) -> Finding:
    """Judge whether something soft and a warm light are there."""
    there = {category_of(room.scene.by_name[name]).name for name in room.layout if name in room.scene.by_name}
    found = [next((kind for kind in grammar().cosy[row] if kind in there), "") for row in ("soft", "warm")]
    return met(all(found), " and ".join(kind or "none" for kind in found))


def as_given(room: Furnished) -> Finding:
    """Take what the scene was made from."""
    return "met", "as given"


def taste(room: Furnished) -> Finding:
    """Judge nothing."""
    return "not judged", ""


def seated(people: int, room: Furnished) -> Finding:
    """Judge whether there are seats for so many."""
    there = [asset for asset in room.scene.assets if asset.name in room.layout]
    wide = [(category_of(asset).name.split()[-1], max(int(asset.size[1] // SEAT), 1)) for asset in there]
    seats = sum(many if kind in ("sofa", "bench") else 1 for kind, many in wide if kind in small.SEATS)
    return met(seats >= people, f"{seats} seats there")


def hung(things: Sequence[str], room: Furnished) -> Finding:
    """Judge how far below the ceiling things hang."""
    tops = [room.layout[name].z + room.scene.by_name[name].size[2] / 2 for name in things]
    off = max((room.scene.room.wall_height - top for top in tops), default=0.0)
    return met(off <= SIZE_OFF, f"{off:.2f} m below the ceiling")


def bared(tops: Sequence[str], room: Furnished) -> Finding:
    """Judge whether nothing stands or lies on some things, or within them."""
    laid = [asset for asset in room.scene.assets if asset.on_object and asset.name in room.layout]
    there = list[str]()
    for top in map(room.scene.by_name.__getitem__, tops):
        over = footprint(room.scene, room.layout, AssetRef(top.name))
        for asset in laid:
            at = room.layout[asset.name]
            bottom = at.z - asset.size[2] / 2
            within = LAID < bottom < room.layout[top.name].z + top.size[2] / 2 + LAID
            there += [asset.name] * (asset is not top and within and over.covers(Point(at.at)))
    return met(not there, f"{', '.join(there) or 'nothing'} there")


def bodied(name: str, room: Furnished) -> Finding:
    """Judge whether the room is laid out for a body."""
    bodies = ", ".join(agent.name for agent in room.scene.agents)
    return ("met" if name in bodies else "not judged"), f"laid out for {bodies}"


def _sides(room: Room) -> list[float]:
    """Return the sides in metres of the smallest rectangle along a wall that holds a room, also of one that stands askew."""
    found = list[list[float]]()
    for dx, dy in (wall.direction for wall in room.walls):
        spans = ([x * u + y * v for x, y in room.vertices] for u, v in ((dx, dy), (-dy, dx)))
        found.append(sorted(max(span) - min(span) for span in spans))
    return min(found, key=math.prod)


def measured(measure: Measure, room: Furnished) -> Finding:
    """Judge a measure of the room."""
    kind, given = measure.kind, room.scene.room
    there = {"size": _sides(given), "area": [given.area], "height": [given.wall_height]}.get(kind)
    if there is None:
        return "not judged", ""
    off = max(abs(a - b) for a, b in zip(there, sorted(measure.values), strict=True))
    good = off <= (AREA_OFF * measure.values[0] if kind == "area" else SIZE_OFF)
    shown = " x ".join(f"{value:.2f}" for value in there)
    return met(good, f"{shown} {'m2' if kind == 'area' else 'm'}")
