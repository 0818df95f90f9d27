"""What belongs in a room besides what was asked for: what goes along with it, what is usual, and zones where it is large."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from robolayout.assets import Category
from robolayout.planners._knowledge import Role
from robolayout.planners._wishes import Wishes
from robolayout.scene import Agent
from robolayout.words import KIN, visits

COMFORT, AIRY = 0.26, 0.15
"""Shares of the floor up to which further things are added: usually, and in a room that is to be airy."""

BASIC = 0.38  # share of the floor up to which what such a room always has is added

LARGER, LARGEST = 1.6, 8.0
"""How many times as large as usual a room is from which on it has more zones and people, and up to which their number grows."""

LIT = 22.0  # square metres that one ceiling lamp lights
SPARE = 0.02  # metres between the top of a thing and the ceiling
SEATS = {"bench", "stool", "pew", "floor cushion"}  # what people sit on at tables in place of chairs
VAGUE = ("stand", "rack", "machine", "board")  # last words that do not say what a thing is for

IN_PLACE_OF = {
    "bathroom vanity": "washbasin",
    "bathtub": "shower",
    "blackboard": "whiteboard",
    "projection screen": "television",
    "rocking chair": "armchair",
    "hanging chair": "armchair",
}
"""What is not added where something else does its work."""


def head(name: str) -> str:
    """Return the word that says what a thing is: "bed" for a bunk bed."""
    last = name.split()[-1]
    return KIN.get(name, IN_PLACE_OF.get(name, name if last in VAGUE else last))


@dataclass(frozen=True)
class Known:
    """The built-in categories and their roles, with those of the user's own."""

    kinds: Mapping[str, Category]
    roles: Mapping[str, Role]

    def _role(self, name: str) -> Role | None:
        return self.roles.get(self.kinds[name].like or name)

    def useless(self, name: str, present: Collection[str]) -> bool:
        """Return whether a thing belongs at others of which none is there: a chair without a table, a candlestick without a top."""
        tops = (role for other in present if (role := self._role(other)) is not None and role.top)
        if self.kinds[name].places == ("object",) and next(tops, None) is None:
            return True
        role = self._role(name)
        wanted = {other for join in role.joins if not join.loose for other in join.of} if role else set[str]()
        there = {self.roles[other].name for other in present if other in self.roles}
        return bool(wanted) and "*" not in wanted and not wanted & there

    def too_high(self, name: str, agents: Iterable[Agent]) -> bool:
        """Return whether a thing that is opened hangs above what one of the bodies reaches: a wall cabinet for a child."""
        kind, role = self.kinds[name], self._role(name)
        if kind.on_floor or kind.open_depth <= 0 or role is None or not role.height:
            return False
        bottom = role.height - kind.size[2] / 2
        return any(agent.reach_distance is not None and bottom > agent.reach_high for agent in agents)

    def head(self, name: str) -> str:
        """Return the word that says what a thing is, by what it is like."""
        return head(self.kinds[name].like or name)

    def floor_area(self, things: Mapping[str, int]) -> float:
        """Return the floor in m2 that things take."""
        kinds = ((self.kinds[name], count) for name, count in things.items())
        standing = (pair for pair in kinds if pair[0].on_floor and pair[0].size[2] > 0.03)
        return sum(kind.size[0] * kind.size[1] * count for kind, count in standing)


def times_usual(wishes: Wishes) -> float:
    """Return how many times as large as usual a room is said to be, 1 where nothing is said."""
    width, depth = wishes.room.size
    size, area = wishes.reading.size, wishes.reading.measure("area")
    asked = math.prod(size) if size else area[0] if area else wishes.reading.scale * width * depth
    return min(asked / (width * depth), LARGEST)


def floor(wishes: Wishes, size: tuple[float, float]) -> float:
    """Return the floor in m2 of a room of a width and depth in metres."""
    return size[0] * size[1] * (0.75 if wishes.reading.shape == "L-shaped" else 1.0)


@dataclass
class Added:
    """What belongs in a room and was not named."""

    wishes: Wishes  # what was asked for
    wished: Mapping[str, int]  # the things of it, with what people bring along
    floor: float  # floor of the room in m2
    known: Known
    fill: float  # share of the floor up to which further things are added
    agents: Sequence[Agent]  # the bodies of the room; nothing is added that one cannot open wherever it hangs

    def __post_init__(self) -> None:
        """Note what the words leave no room for."""
        wishes, known = self.wishes, self.known
        self.room = wishes.room
        self.fill = AIRY if wishes.reading.airy else self.fill
        self.asked = {known.head(name) for name in wishes.things} | (
            {"bed"} & {known.head(name) for name in self.wished}
        )
        self.lasts = {name.split()[-1] for name in wishes.things} | wishes.general
        links = [link for link in wishes.reading.parsed.links if link.relation in ("on", "above")]
        laid = {mention.thing.noun.kind for link in links for mention in link.subjects}
        borne = {kind for kind in laid if "floor" not in known.kinds[kind].places}
        self.spared = {other for name in borne for other in self._companions(name)}  # their bearer is said
        self.ceiling = (wishes.reading.measure("height") or (math.inf,))[0]
        self.found: dict[str, int] = {}

    def things(self, rng: np.random.Generator) -> dict[str, int]:
        """Return what goes with the wished things, what is usual, extras in random order, and zones where the room is large."""
        if self.wishes.reading.only:
            return {}
        for name, count in self.wished.items():
            self._go_along(name, count)
        extras = list(self.room.extras.items())
        for name, most in [*self.room.base.items(), *(extras[i] for i in rng.permutation(len(extras)))]:
            if not self._named(name) and name not in self.found:
                self._add(name, most)
        self._zones()
        if "ceiling lamp" in self.found:
            self.found["ceiling lamp"] = max(self.found["ceiling lamp"], round(self.floor / LIT))
        return self.found

    def _named(self, name: str) -> bool:
        """Whether a thing was named, like it or not."""
        last, wishes = name.split()[-1], self.wishes
        return (
            name in wishes.reading.unwanted
            or name in self.spared
            or last in self.lasts
            or self.known.head(name) in self.asked
            or name in self.wished
        )

    def _fits(self, group: Mapping[str, int], limit: float) -> bool:
        low = all(self.known.kinds[name].size[2] + SPARE <= self.ceiling for name in group)
        if not low or any(self.known.too_high(name, self.agents) for name in group):
            return False
        taken = self.known.floor_area(both(self.wished, self.found, group))
        return self.known.floor_area(group) == 0 or taken <= limit * self.floor

    def _companions(self, name: str) -> Mapping[str, int]:
        """Return what a thing is of no use without, by its own name or by what it is like."""
        table = self.wishes.rooms.companions
        return table.get(name) or table.get(self.known.kinds[name].like or "", {})

    def _go_along(self, name: str, count: int) -> None:
        """Add what a wished thing is of no use without; benches and stools are seats of tables, too."""
        there = {self.known.head(other) for other in self.wished if not visits(other)}
        there |= {"chair"} if head(name) == "table" and SEATS & {*self.wished} else set()
        for other, each in self._companions(name).items():
            spared = other in self.spared or other in self.wishes.reading.unwanted
            if not spared and head(other) not in there | self.wishes.general:
                self.found[other] = self.found.get(other, 0) + count * each

    def _add(self, name: str, most: int) -> None:
        """Add a thing with what it needs, as many times as there is room for."""
        present = {self.known.head(other) for other in (*self.wished, *self.found)}
        # chairs are there, and nothing that they stand at
        waiting = "chair" in present and not {"table", "desk"} & present
        needs = {
            other: each
            for other, each in self._companions(name).items()
            if (head(other) == "chair" and not waiting) or (head(other) not in present and other not in self.room.base)
        }
        limit = BASIC if name in self.room.base and self.fill > AIRY else self.fill
        for count in range(most, 0, -1):
            group = {other: count * each for other, each in {name: 1, **needs}.items()}
            if self._fits(group, limit):
                if not self.known.useless(name, {**self.wished, **self.found, **group}):
                    self.found |= group
                return

    def _zones(self) -> None:
        """Add one group after the other to a large room."""
        times = times_usual(self.wishes)
        zones = [zone for zone in self.room.zones if not any(self._named(name) for name in zone)]
        for turn in range(round(2 * times) if zones and times >= LARGER else 0):
            zone = zones[turn % len(zones)]
            self.found = both(self.found, zone) if self._fits(zone, self.fill) else self.found


def both(*lists: Mapping[str, int]) -> dict[str, int]:
    """Return what several lists hold together."""
    total = Counter[str]()
    for one in lists:
        total.update(one)
    return dict(total)
