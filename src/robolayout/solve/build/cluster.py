"""Things that stand together, laid out around the one they join: a bed with its night stands and their lamps.

A cluster lives in the frame of its anchor: origin at the anchor's centre, x along its front, metres and radians.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from robolayout.assets import Surface, resting_place
from robolayout.assets.beneath import places_beneath
from robolayout.assets.surfaces import slots
from robolayout.constraints import AssetRef
from robolayout.constraints.around import Around, Slot, left_gap
from robolayout.scene import FLAT_HEIGHT, Scene
from robolayout.solve.build.joining import AIM, BELOW
from robolayout.solve.build.member import MARGIN, Member, Size, box_of, overlaps
from robolayout.solve.build.tops import Top
from robolayout.solve.build.wants import Want

PLACE = 0.6
"""Metres of a table's side that one seat takes: a bench takes several."""

ASIDE = 0.05
"""Metres by which seats are tried farther aside of what stands under the same thing."""

LEVEL = 1e-6
"""Metres by which heights of one place differ at the most."""


@dataclass(frozen=True)
class Cluster:
    """Assets placed as one."""

    anchor: str  # name of the asset whose frame it is
    members: tuple[Member, ...]  # all assets, the anchor first

    def mirrored(self) -> Cluster:
        """Return its image left to right."""
        return replace(self, members=tuple(member.mirrored() for member in self.members))


class ClusterBuilder:
    """Lays out what joins what.

    Args:
        scene: The scene.
        wants: What is said of every asset.
    """

    def __init__(self, scene: Scene, wants: Mapping[str, Want]) -> None:
        self.scene = scene
        self.wants = wants
        self.followers: dict[str, list[Want]] = {}
        for item in wants.values():
            if item.anchor is not None:
                self.followers.setdefault(item.anchor, []).append(item)
        self.reachable = max(0.05, scene.agent.reach - scene.agent.radius - 0.05)

    def build(self, name: str) -> Cluster:
        """Return the cluster of an asset and everything that joins it."""
        return Cluster(name, tuple(self._members(name)))

    def _members(self, name: str) -> list[Member]:
        """Return the asset at the origin and its followers around it, nearest kinds first."""
        anchor = self.wants[name]
        placed = [Member(name)]
        by_kind: dict[str, list[Want]] = {}
        for item in self.followers.get(name, ()):
            by_kind.setdefault(item.kind, []).append(item)
        slots: dict[str, Callable[[Want, Sequence[Want], Sequence[Member]], list[Member]]] = {
            "around": self._around,
            "under": self._under,
            "front": self._front,
            "behind": self._front,
            "beside": self._beside,
            "flank": self._flank,
            "setting": self._on,
            "on": self._on,
        }  # in the order in which they are filled
        order = [*slots]
        # what is told its side stands nearest
        for items in sorted(
            by_kind.values(), key=lambda one: (order.index(_slot(one)), not one[0].joined.side, one[0].turn)
        ):
            for member in slots[_slot(items)](anchor, items, placed):
                for part in self._members(member.name):
                    moved = part.moved(member.x, member.y, member.yaw)
                    side = member.side if part.name == member.name else part.side
                    placed.append(replace(moved, bottom=part.bottom + member.bottom, side=side))
        return placed

    def _beside(self, anchor: Want, items: Sequence[Want], placed: Sequence[Member]) -> list[Member]:
        """Left, right, left, ... with the backs in line, each outside of what stands there already."""
        bx, by = _half(anchor)
        reach = {"left": by, "right": by}
        for member in placed[1:]:
            if member.side in reach and member.bottom == 0.0 and self.wants[member.name].anchor == anchor.name:
                box = box_of(member, self.wants[member.name].asset.size)
                reach[member.side] = max(reach[member.side], box[3], -box[1])
        found: list[Member] = []
        for item in items:
            ax, _ = _half(item)
            side = item.joined.side or min(reach, key=lambda s: (round(reach[s], 6), s))
            inner, outer = self._aside(item)[:: 1 if side == "left" else -1]
            y = reach[side] + item.joined.gap + inner
            reach[side] = y + outer
            found.append(Member(item.name, ax - bx, y if side == "left" else -y, item.joined.yaw or 0.0, side=side))
        return found

    def _aside(self, item: Want) -> tuple[float, float]:
        """Return metres from a thing's middle to the ends of what stands at its right and its left, it itself among that."""
        _, half = _half(item)
        if item.joined.yaw:
            return half, half
        first, *others = self._members(item.name)
        own = (first, *(m for m in others if m.bottom == 0.0 and not self.wants[m.name].asset.is_flat))
        ends = [box_of(m, self.wants[m.name].asset.size) for m in own]
        return max(-box[1] for box in ends), max(box[3] for box in ends)

    def _flank(self, anchor: Want, items: Sequence[Want], placed: Sequence[Member]) -> list[Member]:
        """Left and right of the anchor, looking at it; further ones beside the first."""
        _, by = _half(anchor)
        sides = [item.joined.side or ("left", "right")[i % 2] for i, item in enumerate(items)]
        found: list[Member] = []
        for i, (item, side) in enumerate(zip(items, sides, strict=True)):
            ax, ay = _half(item)
            row = sides[:i].count(side) - (sides.count(side) - 1) / 2 * bool(item.joined.side)
            x, sign = row * (2 * ay + 0.1), 1.0 if side == "left" else -1.0
            at = partial(_farther, (x, sign * (by + ax)), (0.0, sign), -sign * math.pi / 2)
            gap = self._left_gap(anchor, item, at) if _seats(item) else item.joined.gap
            found.append(Member(item.name, *at(gap)[0], side=side))
        return found

    def _front(self, anchor: Want, items: Sequence[Want], placed: Sequence[Member]) -> list[Member]:
        """Side by side before the front (or behind the back), facing the anchor unless told otherwise.

        They stand beyond what is there already, or between if there is room: a coffee table between two sofas.
        """
        bx, _ = _half(anchor)
        sign = 1.0 if _slot(items) == "front" else -1.0
        side = "front" if sign > 0 else "back"
        boxes = (
            box_of(m, self.wants[m.name].asset.size)
            for m in placed[1:]
            if m.side == side and m.bottom == 0.0 and self.wants[m.name].anchor == anchor.name
        )
        taken = [(box[0], box[2]) if sign > 0 else (-box[2], -box[0]) for box in boxes]
        nearest = min((near for near, _ in taken), default=0.0)
        between = bx + max(item.joined.gap + item.asset.size[0] for item in items) <= nearest
        edge = bx if between else max([bx, *(far for _, far in taken)])
        width = sum(item.asset.size[1] + 0.12 for item in items) - 0.12
        y, found = width / 2, list[Member]()
        for item in items:
            yaw, gap = item.joined.yaw or 0.0, item.joined.gap
            across = abs(math.sin(yaw)) > math.sqrt(0.5)
            ax, ay = _half(item)[:: -1 if across else 1]
            y -= self._amid(item, yaw) if across else 0.0
            if _seats(item) and not taken:
                gap = self._left_gap(anchor, item, partial(_farther, (sign * (edge + ax), y - ay), (sign, 0.0), yaw))
            found.append(Member(item.name, sign * (edge + gap + ax), y - ay, yaw, side=side))
            y -= 2 * ay + 0.12
        return self._aside_of(anchor, placed, found)

    def _amid(self, item: Want, yaw: float) -> float:
        """Return how far aside the middle of what stands at a thing that is turned so is from its own: of two that face each other."""
        members = (m.moved(0.0, 0.0, yaw) for m in self._members(item.name) if m.bottom == 0.0)
        boxes = [box_of(m, size) for m in members if (size := self.wants[m.name].asset.size)[2] >= FLAT_HEIGHT]
        return (min(box[1] for box in boxes) + max(box[3] for box in boxes)) / 2

    def _aside_of(self, anchor: Want, placed: Sequence[Member], found: list[Member]) -> list[Member]:
        """Return seats before a thing as far aside as what stands under it leaves room for them, or where they are."""
        size = {m.name: self.wants[m.name].asset.size for m in (*placed, *found)}
        below = [box_of(m, size[m.name]) for m in placed[1:] if self.wants[m.name].join == BELOW]
        far = anchor.asset.size[1] / 2
        for off in sorted(np.arange(-far, far, ASIDE), key=abs) if below else ():
            moved = [replace(m, y=m.y + float(off)) for m in found]
            if not any(overlaps(box_of(m, size[m.name]), box, MARGIN) for m in moved for box in below):
                return moved
        return found

    def _left_gap(self, anchor: Want, item: Want, at: Callable[[float], Sequence[Slot]]) -> float:
        """Return how far from its anchor people leave a seat, no farther than is said."""
        return min(item.joined.gap, left_gap(self.scene, [AssetRef(item.name)], AssetRef(anchor.name), at))

    def _around(self, anchor: Want, items: Sequence[Want], placed: Sequence[Member]) -> list[Member]:
        """At the slots of the relation `around`; seats that are told to be at one side take the ones there."""
        sides = [(side, one) for one in self.followers[anchor.name] if (side := _told_side(one))]
        told = [side for side, one in sides for _ in range(max(1, round(one.asset.size[1] / PLACE)))]
        seats = tuple(AssetRef(item.name) for item in (*items, *[items[0]] * len(told)))
        gap = max(item.joined.gap for item in items)
        around = Around(seats, AssetRef(anchor.name), gap if gap > AIM else None)
        slots = [(slot, _side_of(slot[2])) for slot in around.slots(self.scene)]
        for side in told:
            slots.remove(([slot for slot in slots if slot[1] == side] or slots)[-1])
        there = zip(items, slots, strict=True)
        return [Member(item.name, x, y, yaw, side=side) for item, ((x, y, yaw), side) in there]

    def _under(self, anchor: Want, items: Sequence[Want], placed: Sequence[Member]) -> list[Member]:
        """Below the anchor, beside the seats that are pushed under it."""
        found: list[Member] = []
        for item in items:
            there = (m for m in (*placed[1:], *found) if m.bottom < item.asset.size[2])
            taken = [box_of(m, self.wants[m.name].asset.size) for m in there]
            places = [Member(item.name, *place) for place in places_beneath(anchor.asset, item.asset)]
            free = (m for m in places if not any(overlaps(box_of(m, item.asset.size), box) for box in taken))
            found.append(next(free, places[0]))
        return found

    def _on(self, anchor: Want, items: Sequence[Want], placed: Sequence[Member]) -> list[Member]:
        """On the anchor's tops: place settings before its seats, the rest where its kind belongs; what one cannot hold on the next."""
        sizes, found = {name: item.asset.size for name, item in self.wants.items()}, list[Member]()
        seated = {m.name for m in placed[1:] if m.bottom == 0.0 and _seats(self.wants[m.name])}
        for place, share in _dealt(anchor, items, [(member.bottom, sizes[member.name]) for member in placed[1:]]):
            oval = place.is_oval and bool(seated)
            x0, y0, x1, y1 = place.box if oval else place.rectangle
            middle = ((x0 + x1) / 2, (y0 + y1) / 2)
            there = [replace(member, x=member.x - middle[0], y=member.y - middle[1]) for member in placed[1:]]
            seats = {m.name: m for m in there if m.name in seated}
            size = (x1 - x0, y1 - y0, place.height)
            top = Top(size, sizes, there, self.reachable, list(seats.values()), oval=oval)
            put = top.put([(item.name, item.joined.at, seats.get(item.joined.seat)) for item in share])
            found += [replace(m, x=m.x + middle[0], y=m.y + middle[1], bottom=place.height) for m in put]
        return found


def _dealt(
    anchor: Want, items: Sequence[Want], there: Sequence[tuple[float, Size]]
) -> Iterator[tuple[Surface, Sequence[Want]]]:
    """Yield the places of a thing with those of some like things that are put there: as many as stand on each side by side.

    Of what is `there` already the height of its bottom and its size are known.
    """
    *tops, last = items[0].joined.tops or (resting_place(anchor.asset, items[0].asset),)
    largest = max((item.asset.size for item in items), key=lambda size: size[0] * size[1])
    for top in tops:
        taken = sum(1 / max(slots(top, size), 1) for bottom, size in there if abs(bottom - top.height) < LEVEL)
        count = int(slots(top, largest) * (1.0 - taken) + LEVEL) if taken < 1.0 else 0
        if items[:count]:
            yield top, items[:count]
        items = items[count:]
    if items:
        yield last, items


def _seats(want: Want) -> bool:
    """Whether somebody sits there who pushes it under a top on leaving."""
    return want.category.movable and want.asset.on_floor


def _farther(at: tuple[float, float], out: tuple[float, float], yaw: float, gap: float) -> list[Slot]:
    """Return the place of a seat `gap` metres farther out than a point."""
    return [(at[0] + out[0] * gap, at[1] + out[1] * gap, yaw)]


def _slot(items: Sequence[Want]) -> str:
    return items[0].joined.slot


def _half(item: Want) -> tuple[float, float]:
    return (item.asset.size[0] / 2, item.asset.size[1] / 2)


def _told_side(want: Want) -> str:
    """Return the side of a table at which a seat is told to be, and an armchair at its end; none for what is around it."""
    seat = {"front": "front", "behind": "back"}.get(want.joined.slot, "") if _seats(want) else ""
    return want.joined.side if want.joined.slot == "flank" else seat


def _side_of(yaw: float) -> str:
    """Return the side of a table on which a seat with that heading stands."""
    return ("back", "right", "front", "left")[round(yaw / (math.pi / 2)) % 4]
