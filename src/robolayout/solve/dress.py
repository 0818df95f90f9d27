"""Dressing: the small things that people leave about, put on and into the surfaces of a finished room.

What lies where is data (`assets/data/dressing.toml`): rules by the kind of thing that carries, its surface and the room. Every
thing lies wholly on its surface, a margin from the edge, upright, below what covers it, and clear of everything else there;
whatever finds no such place is left out. The room itself is not touched.
"""

from __future__ import annotations

import math
import random
import zlib
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import count, product
from typing import Any

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from robolayout._text import utf8
from robolayout.assets import CATALOGUE, Surface, category_of, surfaces_of
from robolayout.assets.category import read_data
from robolayout.assets.prisms import piece_spans, prisms_of
from robolayout.assets.surfaces import SURFACES, hung_from
from robolayout.scene import DRESSINGS, Asset, Layout, Pose, Scene, variable_name
from robolayout.scene.asset import LIES_ABOUT

Rule = Mapping[str, Any]
"""A table of the data: what lies on which surfaces, and how."""

Spot = tuple[float, float, float]
"""Metres ahead and to the left of the carrier's middle, and the angle by which a thing is turned there."""

AMOUNTS: Mapping[str, float] = dict(zip(DRESSINGS, (0.0, 0.4, 1.0), strict=True))
"""How much lies about: which share of the surfaces, and of what fits on them."""


@dataclass(frozen=True)
class DressConfig:
    """Numbers of dressing; metres."""

    edge: float = 0.015  # how far things stay from the edge of their surface
    gap: float = 0.012  # how far they stay from each other, at least
    air: float = 0.02  # free height above them in a shelf, at least
    most: int = 150  # things that are added at the most
    tries: int = 24  # places that are tried for a thing that may lie anywhere
    vary: float = 0.1  # share by which sizes vary
    turn: float = 6.0  # degrees by which things on shelves and counters are askew
    close: float = 0.002  # how far apart books stand
    loose: tuple[float, float] = (0.0, 0.03)  # least and greatest gap in a row
    # least and greatest gap between things at a back edge, before there are more or fewer of them
    spread: tuple[float, float] = (0.03, 0.25)
    seat: float = 0.7  # how far ahead of a seat the table begins that belongs to it
    above: float = 0.5  # height above an open surface that its things may take up
    # how far before the back edge a thing is tried, one after the other
    ahead: tuple[float, ...] = (0.0, 0.03, 0.08, 0.14)
    level: float = 0.002  # most by which the tops under one thing may differ in height
    sunk: float = 0.0105  # most by which a thing may lie below its surface, whose parts are level within little more
    slack: float = 1e-5  # rounding: what ends on the edge of a region lies in it
    # how far above what carries it a thing lies: where meshes touch, collision checks find a collision
    lift: float = 0.0002


DRESS = DressConfig()

AROUND = 0.9 * DRESS.gap
"""Metres that are kept free about a thing, unless it stands close to others."""


@dataclass(frozen=True)
class Dressed:
    """A room with small things in it."""

    scene: Scene  # the scene with them
    layout: Layout  # the layout with them
    names: tuple[str, ...]  # their names


def dress(scene: Scene, layout: Layout, amount: str = "full", *, seed: int = 0) -> Dressed:
    """Return a room with small things on its surfaces.

    Args:
        scene: The scene.
        layout: Where everything stands; what is not placed carries nothing.
        amount: One of `DRESSINGS`.
        seed: Settles what lies where.
    """
    if not AMOUNTS[amount]:
        return Dressed(scene, layout, ())
    return _Dresser(scene, layout, AMOUNTS[amount], seed).run()


@dataclass
class _Place:
    """A surface that is being dressed, in the frame of its carrier."""

    carrier: Asset
    pose: Pose
    surface: Surface
    free: BaseGeometry
    rng: random.Random


@dataclass
class _Dresser:
    """Puts things down, surface by surface."""

    scene: Scene
    layout: Layout
    amount: float
    seed: int

    def __post_init__(self) -> None:
        self._data: Rule = read_data("dressing.toml")
        self._standing = [(a, self.layout[a.name]) for a in self.scene.assets if a.name in self.layout]
        self._had = {category_of(asset).name for asset in self.scene.assets} & set(self._data["once"])
        self._without: dict[str, tuple[str, ...]] = {}
        self._lists: dict[str, Iterator[int]] = {}
        self._count: Counter[str] = Counter()

    def run(self) -> Dressed:
        ranked = sorted(self._standing, key=lambda one: zlib.crc32(utf8(f"{self.seed}/{one[0].name}")))
        ruled = [(asset, self._rules(asset)) for asset, _ in ranked if not asset.is_flat]
        had = len(self._standing)
        # tops before insides; shelves last: those for which nothing is left keep what is drawn on them
        for covered, (asset, rules) in product((False, True, None), ruled):
            clears = tuple(dict.fromkeys(part for rule in rules for part in rule.get("clears", ())))
            if bool(clears) == (covered is None) and len(self._standing) < had + DRESS.most:
                self._asset(asset, rules, clears, covered)
        laid = self._standing[had : had + DRESS.most]
        bare = tuple(replace(a, without=self._without.get(a.name, a.without)) for a in self.scene.assets)
        scene = replace(self.scene, assets=(*bare, *(asset for asset, _ in laid)))
        layout = Layout({**self.layout, **{asset.name: pose for asset, pose in laid}})
        return Dressed(scene, layout, tuple(asset.name for asset, _ in laid))

    def _rules(self, asset: Asset) -> list[Rule]:
        """Return the rules for a carrier in this room."""
        words = f"{self.scene.name} {self.scene.task_description}".lower().replace("_", " ")
        mine = [rule for rule in self._data["rule"] if category_of(asset).name in rule["on"]]
        return [rule for rule in mine if any(word in words for word in rule.get("rooms", [""]))]

    def _asset(self, asset: Asset, rules: list[Rule], clears: tuple[str, ...], covered: bool | None) -> None:
        """Dress one thing, only what is covered or open of it, or all: it is cleared of what is drawn on it, then filled."""
        rng = random.Random(utf8(f"{self.seed}/{asset.name}"))
        if clears and rng.random() > self.amount:
            return  # it stays as it is drawn
        if clears and asset.path is None:
            self._without[asset.name] = (*asset.without, *clears)
            asset = replace(asset, without=self._without[asset.name])
        for surface in surfaces_of(asset):
            word = surface.name.split()[0]
            rule = next((rule for rule in rules if rule["where"] in (word, "any")), None)
            meant = covered is None or covered == surface.covered
            if rule is not None and meant and (rng.random() < self.amount or clears or rule["put"] == "places"):
                place = _Place(asset, self.layout[asset.name], surface, self._free(asset, surface), rng)
                for part in () if place.free.is_empty else (rule, *rule.get("also", ())):
                    if rng.random() < part.get("chance", 1.0):
                        getattr(self, f"_{part['put']}")(place, part)  # one of the methods below

    def _free(self, asset: Asset, surface: Surface) -> BaseGeometry:
        """Return what of a surface may be taken, in the carrier's frame: not its edge, nor where something stands already."""
        inner, pose = surface.region, self.layout[asset.name]
        if not surface.is_hook:
            inner = inner.buffer(DRESS.slack - DRESS.edge, join_style="mitre")
        level = pose.z - asset.size[2] / 2 + surface.height
        top, near = level + min(surface.free, DRESS.above), math.hypot(*asset.size[:2]) / 2
        corners = [
            np.array([(c, s), (-s, c)]).T @ np.array(prism.outline).T + [[place.x], [place.y]]
            for other, place in self._standing
            if other.name != asset.name and math.dist(place.at, pose.at) < near + math.hypot(*other.size[:2]) / 2
            for (c, s), bottom in [(place.forward, place.z - other.size[2] / 2)]
            for prism in prisms_of(other)
            if bottom + prism.high > level + 1e-6 and bottom + prism.low < top
        ]
        if not corners:
            return inner
        (c, s), middle = pose.forward, pose.at
        own = (np.array(corners).transpose(0, 2, 1) - middle) @ np.array([[c, -s], [s, c]])
        return inner.difference(shapely.union_all(shapely.buffer(shapely.polygons(own), DRESS.gap, join_style="mitre")))

    def _kind(self, place: _Place, things: Mapping[str, float], wide: float = math.inf) -> Asset | None:
        """Return one of the things that fit under what covers a surface, and into a width one way round or the other, in a size
        of its own; None where none does."""
        room, least = place.surface.free - DRESS.air, 1 - DRESS.vary
        sizes = {kind: CATALOGUE[kind].size for kind in things if kind not in self._had}
        fit = [kind for kind, size in sizes.items() if size[2] * least <= room and min(size[:2]) * least <= wide]
        if not fit:
            return None
        kind = place.rng.choices(fit, [things[kind] for kind in fit])[0]
        depth, width, height = sizes[kind]
        narrow = width if width * least <= wide else min(depth, width)
        scale = min(place.rng.uniform(least, 2 - least), (wide - 10 * DRESS.slack) / narrow)
        tall = min(height * place.rng.uniform(least, 2 - least), room)
        return Asset("", kind, (round(depth * scale, 4), round(width * scale, 4), round(tall, 4)))

    def _row(self, place: _Place, rule: Rule) -> None:
        """Stand things side by side along the front edge, runs of one kind; those of `tight` close, each in its own size."""
        y, ahead, end = (place.surface.rectangle[i] + sign * DRESS.edge for i, sign in ((1, 1), (2, -1), (3, -1)))
        while (thing := self._kind(place, rule["things"], end - y)) is not None:
            tight = thing.category in rule.get("tight", ())
            runs = place.rng.randint(1, rule["run"]) if "run" in rule and (tight or "tight" not in rule) else 1
            if place.rng.random() > rule["fill"] * (0.5 + 0.5 * self.amount):
                y += place.rng.uniform(*DRESS.spread)
            own, gap = self._variable(thing.category), DRESS.close if tight else DRESS.gap
            turn = math.pi / 2 if thing.size[1] > end - y >= thing.size[0] else 0.0  # what is too wide lies lengthwise
            for _ in range(runs):
                deep, across = thing.size[1::-1] if turn else thing.size[:2]
                spot = (ahead - deep / 2, y + across / 2, turn)
                if not self._put(place, thing, spot, own, rule, DRESS.close if tight else AROUND):
                    y += across / 2
                    break
                y += across + gap
                thing = (self._kind(place, {thing.category: 1}) if tight else thing) or thing
            y += place.rng.uniform(*DRESS.loose)

    def _back(self, place: _Place, rule: Rule) -> None:
        """Stand things along the back edge, with room between them."""
        behind, y, _, end = place.surface.rectangle
        y += place.rng.uniform(*DRESS.spread)
        last = ""
        while y < end:
            choice = {kind: weight for kind, weight in rule["things"].items() if kind != last} or rule["things"]
            thing = self._kind(place, choice)
            if thing is None:
                return
            last = thing.category
            askew = math.radians(place.rng.uniform(-DRESS.turn, DRESS.turn))
            half = (thing.size[1] * math.cos(askew) + thing.size[0] * abs(math.sin(askew))) / 2
            deep = (thing.size[0] * math.cos(askew) + thing.size[1] * abs(math.sin(askew))) / 2
            own = self._variable(thing.category)
            x = behind + DRESS.edge + deep + place.rng.uniform(*DRESS.loose)
            for ahead in DRESS.ahead:  # a mirror on the wall, a lamp, or a screen may stand behind
                if self._put(place, thing, (x + ahead, y + half, askew), own, rule):
                    break
            share = max(rule.get("fill", 0.5) * (0.4 + 0.6 * self.amount), 0.05)
            y += 2 * half + place.rng.uniform(*DRESS.spread) / share / 2

    def _middle(self, place: _Place, rule: Rule) -> None:
        """Stand one thing in the middle."""
        thing = self._kind(place, rule["things"])
        if thing is not None:
            middle = place.surface.region.centroid
            self._put(place, thing, (middle.x, middle.y, 0.0), self._variable(thing.category), rule)

    def _about(self, place: _Place, rule: Rule) -> None:
        """Put things down anywhere."""
        x0, y0, x1, y1 = place.surface.region.bounds
        for _ in range(max(1, round(rule["fill"] * self.amount * place.rng.uniform(0.6, 1.2)))):
            for number in range(DRESS.tries):
                thing = self._kind(place, rule["things"])
                if thing is None:
                    return
                loose = 3 * DRESS.turn * (1 - number / DRESS.tries)  # a tight place wants it straight
                turn = math.radians(place.rng.gauss(0, loose))
                half = np.abs(Pose(0.0, 0.0, 0.0, turn).corners(thing.size)).max(axis=0) + DRESS.edge
                (dx, dy), at = half.tolist(), place.rng.uniform
                x, y = at(x0 + dx, max(x1 - dx, x0 + dx)), at(y0 + dy, max(y1 - dy, y0 + dy))
                if self._put(place, thing, (x, y, turn), self._variable(thing.category), rule):
                    break

    def _places(self, place: _Place, rule: Rule) -> None:
        """Put a set before every seat that faces the surface: first the plates of all, then what lies beside them."""
        seats = [seat for seat in self._seats(place) if place.rng.random() <= 0.5 + 0.5 * self.amount]
        parts = self._data["sets"][rule["set"]]
        for kind, ahead, aside, turn in parts:
            thing, served = Asset("", kind, CATALOGUE[kind].size), list[Pose]()
            for seat in seats:
                x, y = seat.point(ahead + thing.size[0] / 2, -aside)
                at = (x, y, seat.yaw + math.pi + math.radians(turn))
                if self._put(place, thing, at, self._variable(kind), rule) or self._lies(place, kind, (x, y)):
                    served.append(seat)
            if kind == parts[0][0]:
                seats = served  # where something else lies already, nothing is set

    def _lies(self, place: _Place, kind: str, at: tuple[float, float]) -> bool:
        """Return whether a thing of a kind stands within its own size of a point of a surface."""
        point, near = place.pose.point(*at), max(CATALOGUE[kind].size[:2])
        same = (its for other, its in self._standing if category_of(other).name == kind)
        return any(math.dist(point, its.at) < near for its in same)

    def _seats(self, place: _Place) -> Iterator[Pose]:
        """Yield where the edge of a surface is before each seat, facing as the seat does, in the carrier's frame."""
        pose, outline = place.pose, place.surface.region.exterior
        for seat, at in self._standing:
            sat_on = category_of(seat).movable and any(surface.is_seat for surface in surfaces_of(seat))
            if not sat_on or seat.name == place.carrier.name:
                continue
            x, y = pose.seen(at.at)
            here, reach = Pose(x, y, 0.0, at.yaw - pose.yaw), seat.size[0] / 2 + DRESS.seat
            back = here.point(-1.0, 0.0)
            ray = shapely.LineString([back, here.point(reach, 0.0)])
            met = shapely.get_coordinates(ray.intersection(outline)).tolist()
            first = min(met, key=lambda point: math.dist(point, back), default=None)
            if first is not None and math.dist(first, (x, y)) <= reach:
                yield replace(here, x=first[0], y=first[1])

    def _variable(self, kind: str) -> str:
        """Return the list that a thing, or a run of equal ones, belongs to: those of one list look alike."""
        stem = variable_name(kind)
        names = (f"{stem}_{number}" for number in self._lists.setdefault(stem, count(1)))
        return next(name for name in names if name not in self.scene.variables)

    def _height(self, place: _Place, shape: Polygon) -> float | None:
        """Return the height on which a thing lies level; None where it would lie on an edge."""
        x, y = np.array(shape.exterior.coords).T
        low, high = (np.array([f(u) for u in (x, y, x + y, x - y)]) for f in (np.min, np.max))
        spans = piece_spans(place.carrier)
        top, least, most = spans[:, 5], spans[:, [0, 2, 6, 8]], spans[:, [1, 3, 7, 9]]
        height, slack = place.surface.height, DRESS.level
        tops = (top <= height + slack) & (top > height - SURFACES.level - slack)
        under = tops & (least < high).all(axis=1) & (most > low).all(axis=1)
        if not under.any():
            return height  # a mesh of the user's own
        level = top[under].max()
        if height - level > DRESS.sunk:
            return None
        whole = under & (least <= low).all(axis=1) & (most >= high).all(axis=1) & (top > level - slack)
        return float(level) if whole.any() or level - top[under].min() < slack else None

    def _put(self, place: _Place, thing: Asset, at: Spot, variable: str, rule: Rule, around: float = AROUND) -> bool:
        """Put a thing down, `around` metres free about it, and more on it as its rule's `stack` has it; return whether it lies.

        It lies free and wholly on its surface, or not at all.
        """
        x, y, turn = at
        if thing.size[2] + DRESS.air > place.surface.free:
            return False
        shape = Polygon(Pose(x, y, 0.0, turn).corners(thing.size))
        height = self._height(place, shape) if place.free.covers(shape) else None
        if height is None:
            return False
        place.free = place.free.difference(shape.buffer(around, join_style="mitre"))
        pose, rise = place.pose, thing.size[2] + DRESS.lift
        level = pose.z - place.carrier.size[2] / 2 + height + DRESS.lift + thing.size[2] / 2
        most = min(rule.get("stack", {}).get(thing.category, 1), (place.surface.free - DRESS.air) // rise)
        for i in range(place.rng.randint(int(most + 1) // 2, int(most)) if most > 1 else 1):
            self._lay(thing, Pose(*pose.point(x, y), level + i * rise, pose.yaw + turn), variable)
        return True

    def _lay(self, thing: Asset, pose: Pose, variable: str) -> None:
        """Add a thing to the room."""
        name = f"{variable}-{self._count[variable]}"
        self._count[variable] += 1
        made = replace(thing, name=name, on_floor=False, on_object=True, metadata={LIES_ABOUT: True})
        self._standing.append((made, pose))
        self._had |= {thing.category} & set(self._data["once"])

    def _hang(self, place: _Place, rule: Rule) -> None:
        """Hang a thing from a hook, if nothing else is where it would hang."""
        thing = self._kind(place, rule["things"])
        if thing is None or place.rng.random() > rule["fill"] * (0.5 + 0.5 * self.amount):
            return
        pose = place.pose
        spot = hung_from(place.surface, thing)
        level = pose.z - place.carrier.size[2] / 2 + spot.height + DRESS.lift + thing.size[2] / 2
        yaw = pose.yaw + math.atan2(spot.out[1], spot.out[0])
        at = Pose(*pose.point(*spot.region.centroid.coords[0]), level, yaw)
        shape = Polygon(at.corners(thing.size))
        others = [(other, its) for other, its in self._standing if other.name != place.carrier.name]
        beside = [(other, its) for other, its in others if abs(its.z - level) < (other.size[2] + thing.size[2]) / 2]
        if level > thing.size[2] and not any(shape.intersects(Polygon(its.corners(o.size))) for o, its in beside):
            self._lay(thing, at, self._variable(thing.category))
