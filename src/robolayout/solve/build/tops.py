"""Small things on a top: place settings before seats, the rest where their kind belongs and a hand can get them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from robolayout.solve.build.member import MARGIN, Member, Rect, Size, box_of, outline_of, overlaps

STEP = 0.04
"""Metres between the places tried on a top."""

CLOSEST = 0.005
"""Metres of a top for each thing in a line that stay free at the least."""

AMID = 0.1
"""Metres between things in the middle of a top, if they are so narrow."""

ROUNDED = 1.08
"""How far out the corner of a thing on an oval may be, of the way to its edge: most things there are round themselves."""

ENDS = {"left end": 0.95, "right end": -0.95}
"""Share of the way from the middle to an end of a top at which stands what is said to be there."""

HAND = 0.32
"""Metres from the middle of a desk to where a right hand lies beside the keyboard, for who sits before its front."""


class Top:
    """The top of one asset and what stands on it.

    Args:
        size: Size of the asset below.
        sizes: Sizes of all assets by name.
        placed: What stands at or on the asset already, in its frame.
        reach: How far from the edge a thing may stand to be reached by the agent, metres.
        seats: Who sits at it.
        oval: Whether it is the ellipse in its box.
    """

    def __init__(
        self,
        size: Size,
        sizes: Mapping[str, Size],
        placed: Sequence[Member],
        reach: float,
        seats: Sequence[Member],
        *,
        oval: bool = False,
    ) -> None:
        self.half, self.oval = (size[0] / 2, size[1] / 2), oval
        self.sizes = sizes
        self.reach = reach
        self.seated, self.faced = len(seats) > 1, bool(seats)
        self.on_top = [member for member in placed if abs(member.bottom - size[2]) < 1e-6]
        self.taken: list[Rect] = [box_of(member, sizes[member.name]) for member in self.on_top]

    def put(self, items: Sequence[tuple[str, str, Member | None]]) -> list[Member]:
        """Place things given as (name, where, whose seat it is laid for) and return them."""
        found: list[Member] = []
        ends = any(at in ENDS for _, at, _ in items)
        in_line = {} if self.faced or ends else self._in_line(items)
        for i, (name, at, seat) in enumerate(items):
            if seat is not None:
                member = self._at_seat(name, at, seat)
                if not self._meets(member):
                    found.append(self._keep(member))
                    continue
            found.append(self._keep(in_line.get(name) or self._free(name, at, i, len(items))))
        return found

    def _in_line(self, items: Sequence[tuple[str, str, Member | None]]) -> dict[str, Member]:
        """Return places side by side for several things of one kind that fit so, straight or all turned, if the top is bare."""
        for turned in (False, True) if len(items) > 1 and not self.taken else ():
            sizes = [self.sizes[name][1::-1] if turned else self.sizes[name][:2] for name, *_ in items]
            spare = 2 * self.half[1] - sum(wide for _, wide in sizes)
            if spare < CLOSEST * len(items) or max(deep for deep, _ in sizes) > 2 * self.half[0]:
                continue
            y, found = -self.half[1], dict[str, Member]()
            for (name, at, _), (deep, wide) in zip(items, sizes, strict=True):
                y += spare / (2 * len(items)) + wide / 2
                x, _ = self._wanted(at, 0, 2, (max(self.half[0] - deep / 2, 0.0), 0.0))
                found[name] = Member(name, x, y, math.pi / 2 if turned else 0.0)
                y += spare / (2 * len(items)) + wide / 2
            return found
        return {}

    def _meets(self, member: Member) -> bool:
        """Return whether a thing meets another one there; around an oval they are turned against each other."""
        if not self.oval:
            return any(overlaps(box_of(member, self.sizes[member.name]), other) for other in self.taken)
        mine, *others = (outline_of(one, self.sizes[one.name]) for one in (member, *self.on_top))
        return any(mine.intersects(other) for other in others)

    def _keep(self, member: Member) -> Member:
        self.on_top.append(member)
        self.taken.append(box_of(member, self.sizes[member.name]))
        return member

    def _at_seat(self, name: str, at: str, seat: Member) -> Member:
        """Return where a plate, a glass or a fork belongs before a seat, heading as the guest looks."""
        plate = next((self.sizes[m.name] for m in self.on_top if m.side == seat.name), (0.26, 0.26, 0.02))
        ax, ay = self.sizes[name][0] / 2, self.sizes[name][1] / 2
        beside = plate[1] / 2 + MARGIN + ay
        inward, left = {
            "plate": (ax, 0.0),
            "left": (max(ax, plate[0] / 2), beside),
            "right": (max(ax, plate[0] / 2), -beside),
            "far left": (max(ax, plate[0] / 2), beside + 0.07),
            "far right": (max(ax, plate[0] / 2), -beside - 0.07),
            "glass": (max(ax, 0.2 * plate[0]), -beside - 0.08),
            "beyond": (plate[0] + MARGIN + ax, 0.0),
        }[at]
        inward += MARGIN
        if at == "glass" and self._inner(seat, left) > self.reach >= self._inner(seat, -left):
            left = -left  # a hand comes from the end of the table: nobody stands where the chair is
        (x, y), (c, s) = self._edge(seat, left)
        return Member(name, x + c * inward, y + s * inward, seat.yaw, side=seat.name)

    def _edge(self, seat: Member, left: float) -> tuple[tuple[float, float], tuple[float, float]]:
        """Return the point of the edge before a place so far to the left of a seat, and the direction in which the seat looks."""
        c, s = math.cos(seat.yaw), math.sin(seat.yaw)
        if self.oval:  # (p + t d) on the ellipse: a quadratic in t, whose smaller root is the near edge
            a, b = self.half
            px, py, dx, dy = (seat.x - s * left) / a, (seat.y + c * left) / b, c / a, s / b
            dd, pd = dx * dx + dy * dy, px * dx + py * dy
            root = max(pd * pd - dd * (px * px + py * py - 1.0), 0.0)
            t = (-pd - math.sqrt(root)) / dd
            return (seat.x - s * left + t * c, seat.y + c * left + t * s), (c, s)
        c, s = round(c), round(s)
        x, y = (-c * self.half[0], seat.y + c * left) if c else (seat.x - s * left, -s * self.half[1])
        return (x, y), (c, s)

    def _inner(self, seat: Member, left: float) -> float:
        """Return metres from a place so far to the left of a seat to the end of the table."""
        c, s = round(math.cos(seat.yaw)), round(math.sin(seat.yaw))
        return self.half[1] - abs(seat.y + c * left) if c else self.half[0] - abs(seat.x - s * left)

    def _free(self, name: str, at: str, i: int, count: int) -> Member:
        """Return the free place nearest to where the i-th of `count` such things belongs."""
        depth, width, _ = self.sizes[name]
        turned = (depth > 2 * self.half[0] or width > 2 * self.half[1]) and depth <= 2 * self.half[1]
        hx, hy = (width / 2, depth / 2) if turned else (depth / 2, width / 2)
        rx, ry = max(self.half[0] - hx, 0.0), max(self.half[1] - hy, 0.0)
        wx, wy = self._wanted(at, i, count, (rx, ry))
        if at not in ENDS and count > 1 and ry / count < hy + MARGIN / 2:
            wy = ry * (2 * i / (count - 1) - 1)  # from end to end: halves would leave too little room
        wx += max(0.0, hx - self.half[0])
        xs = [-rx + k * STEP for k in range(int(2 * rx / STEP) + 1)] + [wx]
        ys = [-ry + k * STEP for k in range(int(2 * ry / STEP) + 1)] + [wy]
        places = sorted((math.hypot(x - wx, y - wy), x, y) for x in xs for y in ys)
        for _, x, y in places:
            if self.oval and math.hypot((abs(x) + hx) / self.half[0], (abs(y) + hy) / self.half[1]) > ROUNDED:
                continue
            if not any(overlaps((x - hx, y - hy, x + hx, y + hy), other, MARGIN) for other in self.taken):
                return Member(name, x, y, math.pi / 2 if turned else 0.0)
        return Member(name, wx, wy, math.pi / 2 if turned else 0.0)

    def _wanted(self, at: str, i: int, count: int, room: tuple[float, float]) -> tuple[float, float]:
        """Return where the i-th of `count` things belongs on a top, within (+-room) of its middle."""
        rx, ry = room
        y = 0.0 if count == 1 else ry * (2 * (i + 0.5) / count - 1)
        if at == "middle":
            return (0.0, AMID * (i - (count - 1) / 2))
        if at in ENDS:
            return (0.0, ENDS[at] * ry)
        if at == "back":
            return (-rx if self.faced else max(-rx, rx - self.reach), y)
        if at == "front":
            return (max(0.0, rx - 0.03), y)
        if at == "front left":
            return (max(0.0, rx - 0.03), min(ry, HAND))
        if at == "left":
            return (0.0, ry * 0.85 if count == 1 else y)
        if self.seated:
            return (0.0, y if count > 1 else max(0.0, ry - self.reach + 0.05))
        return (0.0 if rx <= self.reach else max(0.0, rx - self.reach), y)
