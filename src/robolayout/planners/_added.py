"""What belongs in a room besides what was asked for: what goes along with it, what is usual, and zones where it is large."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain

import numpy as np

from robolayout.planners._knowledge import DATA
from robolayout.planners._roles import TOP_SHARE, stands_free
from robolayout.planners._room_size import SIZES
from robolayout.planners._wishes import INSTEAD, LOW, RoomWishes, head
from robolayout.scene import FLAT_HEIGHT, Agent
from robolayout.words import SHAPES, WATCHING, Link, NamedThing, mentions, named, place_in, visits

COMFORT, AIRY = 0.26, 0.15
"""Shares of the floor up to which further things are added: usually, and in a room that is to be airy."""

BASIC = 0.38  # share of the floor up to which what such a room always has is added

ON_TOPS = 0.4  # share of all tops up to which things that stand on some are added

LARGER = 1.6  # how many times as large as usual a room is from which on it has more zones and people

LIT = 22.0  # square metres that one ceiling lamp lights
SPARE = 0.02  # metres between the top of a thing and the ceiling
LOFTY = 1.8  # metres of height of a bed from which on nothing stands beside it
BROAD = 0.6  # metres of width from which on what flanks a thing takes the place of what usually stands there
ON_A_RUG = 4  # seats of one kind that may stand around one rug

STOOD_AT = ("garage", "laboratory", "lecture hall", "workshop")
"""Rooms at whose tables nobody sits, unless that is said."""
SEATS, ALONE_ON_A_RUG = ({*DATA["nouns"][name]} for name in ("instead_of_chairs", "alone_on_a_rug"))


@dataclass
class Added:
    """What belongs in a room and was not named."""

    wishes: RoomWishes  # what was asked for
    wished: Mapping[str, int]  # the things of it, with what people bring along
    floor: float  # floor of the room in m2
    fill: float  # share of the floor up to which further things are added
    agents: Sequence[Agent]  # the bodies of the room; nothing is added that one cannot open wherever it hangs

    def __post_init__(self) -> None:
        """Note what the words leave no room for."""
        wishes = self.wishes
        self.room = wishes.room
        self.fill = AIRY if wishes.reading.airy else self.fill
        self.asked = {*map(wishes.head, wishes.things), *({"bed"} & {*map(wishes.head, self.wished)})}
        self.lasts = {name.split()[-1] for name in wishes.things if INSTEAD.get(name) != name} | wishes.general
        said = wishes.reading.parsed.links
        links = [link for link in said if link.relation in ("on", "above", "atwalls")]
        laid = {mention.thing.noun.kind for link in links for mention in link.subjects}
        under = [link for link in said if link.relation == "under" and not any(one.flat for one in link.subjects)]
        below = [link for link in under if any(one.laid for one in link.subjects)]
        low = [link for link in under if link not in below]  # a TV with a minibar under it hangs there
        laid |= {to.thing.noun.kind for link in low for to in mentions(link.objects)}
        # a soundbar under a TV on the wall stands on what the TV has
        laid -= {to.thing.noun.kind for link in below for to in mentions(link.objects)}
        borne = {kind for kind in laid if "floor" not in wishes.kinds[kind].places}
        unwanted = wishes.reading.unwanted
        alone = (*borne, *(unwanted & wishes.kinds.keys()))  # their bearer is said, or nobody wants them
        self.spared = unwanted.union(*map(self._companions, alone))
        self.spared |= self._unseen() | self._crowded_out()
        formed = [mention for link in said if link.relation in SHAPES for mention in link.subjects]
        if formed:  # the middle of the room is theirs, and seats in a circle are at no desk
            instead = ("desk", "pew", "sofa", "armchair", "rug") if any(mention.sat_on for mention in formed) else ()
            usual = (*wishes.room.base, *wishes.room.extras)
            self.spared |= {name for name in usual if name.endswith((*instead, "conference table", "dining table"))}
        self.spared |= {"pew", "conference table"} if wishes.audience else set()
        sofas = sum(count for name, count in self.wished.items() if wishes.head(name) == "sofa")
        self.spared |= {"armchair"} if sofas > 1 else set()  # who is here sits there
        high = self._roles_of(thing for link in said if link.relation == "above" for thing in named(link.objects))
        of_things = (k for k in said if k.relation in ("on", "in", "with"))
        island = (k for k in of_things if any(m.thing.head == "island" for m in mentions(k.objects)))
        high |= self._roles_of(thing for link in island for thing in named(link.subjects))  # no wall is behind these
        single = wishes.playing(name for name, count in self.room.base.items() if count == 1)
        # a hood, where a microwave is above the stove
        self.spared |= {name for name, role in single.items() if "hang" in role.stands and high & {*role.above[:1]}}
        shelves = [m for link in said if link.relation == "above" for m in link.subjects if m.thing.head == "shelf"]
        self.spared |= {"wall cabinet"} if shelves and high & {"counter"} else set()
        kept = self._roles_of(thing for k in said if k.relation == "bare" for thing in named(k.objects))
        usual = wishes.playing((*wishes.room.base, *wishes.room.extras)).items()
        on = {name: {one for join in role.joins if join.on_top for one in join.of} for name, role in usual}
        self.spared |= {name for name in on if on[name] & kept and wishes.kinds[name].places == ("object",)}
        self.named = self.spared | self.wished.keys()
        corners = [
            k for k in said if k.relation in ("corner", "cleared", "sidelong") or place_in(k.objects[:1], "corner")
        ]
        bare = [link for link in corners if link.relation == "cleared" and link.objects[1:]]
        self.cornered, self.bared = (
            self._roles_of(m.thing for k in links for m in k.subjects) for links in (corners, bare)
        )
        # a bed with a crib beside it
        next_to = (link for link in said if link.relation in ("next", "left", "right"))
        beside = (link.objects for link in next_to if any(map(self._broad, named(link.subjects))))
        self.cornered |= self._roles_of(thing for to in beside for thing in named(to))
        # floor that stays free all around something
        self.freed = sum(self._strip(link) for link in bare)
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
            owners = {other for other in self.room.base if head(name) == "chair" and name in self._companions(other)}
            owned = not owners or owners & {*self.wished, *self.found}
            if owned and not self._named(name) and name not in self.found and not self._of_one(name):
                self._add(name, self._at_open_sides(name, self._borne(name, most)))
        self._zones()
        if "ceiling lamp" in self.found:
            self.found["ceiling lamp"] = max(self.found["ceiling lamp"], round(self.floor / LIT))
        for name in [*self.found]:
            self.found[name] = max(self.found[name], self._belongs_to(name, "ceiling")[1])  # a lamp for each table
        return self.found

    def _named(self, name: str) -> bool:
        """Whether a thing was named, like it or not."""
        return name in self.named or name.split()[-1] in self.lasts or self.wishes.head(name) in self.asked

    def _unseen(self) -> set[str]:
        """Return what nobody looks at where seats face another such thing, or seats: a television where the sofa faces the fireplace."""
        wishes, usual = self.wishes, [*self.room.base, *self.room.extras]
        links = [link for link in wishes.reading.parsed.links if link.relation in (*WATCHING, "mutual")]
        on = [k for k in wishes.reading.parsed.links if k.relation == "on" and any(one.sat_on for one in k.subjects)]
        seats_on = {thing for link in on for thing in named(link.objects)}  # a rug with armchairs, before the fireplace
        pairs = [(m, link.objects) for link in links for m in link.subjects if m.sat_on or m.thing in seats_on]
        watched, playing = self._roles_of(to.thing for _, seen in pairs for to in mentions(seen)), wishes.playing(usual)
        faced = {one for role in playing.values() if watched & {*role.face.roles} for one in role.face.roles}
        met = {wishes.kind(one.thing) for one, seen in pairs if all([to.sat_on for to in mentions(seen)] or [not seen])}
        across = [k for k in links if k.relation in ("opposite", "facing") and named(k.objects)]
        seats = [[*k.subjects, *mentions(k.objects)] for k in across if any(m.several for m in k.subjects)]
        # a sofa and two armchairs opposite it
        met |= {wishes.kind(m.thing) for each in seats for m in each if all(one.sat_on for one in each)}
        faced |= {one for role in wishes.playing(met).values() for one in role.face.roles}
        seated = [
            link.objects for link in links if link.relation == "around" and any(one.sat_on for one in link.subjects)
        ]
        low = {wishes.kind(to.thing) for seen in seated for to in mentions(seen)} & {*LOW}
        turned = {
            m for k in wishes.reading.parsed.links if k.relation in ("facing", "diagonal") for m in named(k.subjects)
        }
        lone = (m for m, seen in pairs if seen and m.several and m.thing in turned)
        lounge = any(head(m.thing.noun.kind) == "armchair" for m in lone) and watched
        screens = {*wishes.roles["sofa"].face.roles}
        if "sofa" not in self.asked and (low or wishes.rings(on)):
            faced |= {"sofa", *screens}  # all sit around a coffee table, or on a rug
        faced |= {"sofa"} if "sofa" not in self.asked and lounge else set()  # in the armchairs that look at something
        named_too = screens & {role.name for role in wishes.playing(self.wished).values()}
        thrown = any(wishes.kind(to.thing) == "projection screen" for _, seen in pairs for to in mentions(seen))
        # a TV may have its stand, a projector's picture has none
        faced |= screens if thrown or (named_too and "television" not in self.asked) else set()
        borne = chain(*(self._companions(wishes.kind(to.thing)) for _, seen in pairs for to in mentions(seen)))
        unseen = {name for name, role in playing.items() if role.name in faced} - {*borne}  # the stand of the TV
        return unseen | {name for name in usual if unseen & self._companions(name).keys()}

    def _broad(self, thing: NamedThing) -> bool:
        """Whether a thing takes the place of what usually stands beside another one."""
        kind = self.wishes.kinds[self.wishes.kind(thing)]
        return kind.on_floor and kind.size[1] > BROAD and kind.size[2] > FLAT_HEIGHT

    def _crowded_out(self) -> set[str]:
        """Return what usually stands where something broad is said to: night stands beside a bed that wardrobes flank."""
        wishes, usual = self.wishes, {*self.room.base, *self.room.extras, *chain(*map(self._companions, self.wished))}
        high = {name for name in self.wished if head(name) == "bed" and wishes.kinds[name].size[2] > LOFTY}
        sides = {role.name for role in wishes.playing(high).values()}  # nobody reaches a night stand from a loft bed
        for link in wishes.reading.parsed.links:
            pair = (link.subjects, link.objects) if link.relation == "flank" else (link.objects, link.subjects)
            beside, middle = (named(items) for items in pair)
            broad = beside and all(wishes.kinds[wishes.kind(thing)].size[1] > BROAD for thing in beside)
            if broad and link.relation in ("flank", "amid"):
                sides |= self._roles_of(middle)
        cleared = (link for link in wishes.reading.parsed.links if link.relation == "cleared")
        free = [k for k in cleared if (at := place_in(k.objects)) and "front" in at.words]
        before = self._roles_of(m.thing for k in free for m in k.subjects)
        # two bean bags between the sofa and the TV take the place of a coffee table
        amid = (k for k in wishes.reading.parsed.links if k.relation == "amid")
        full = (k for k in amid if any(thing.count > 1 and self._broad(thing) for thing in named(k.subjects)))
        before |= self._roles_of(m.thing for k in full for m in mentions(k.objects) if m.thing.head == "sofa")
        roles = wishes.playing(usual).items()
        found = {name for name, role in roles if any(map(role.stands_beside, sides))}
        low = [(name, role) for name, role in roles if head(name) == "table"]  # a coffee table before a sofa
        return found | {name for name, role in low if any(role.stands_beside(one, "front") for one in before)}

    def _fits(self, group: Mapping[str, int], limit: float) -> bool:
        low = all(self.wishes.kinds[name].size[2] + SPARE <= self.ceiling for name in group)
        if not low or any(map(self._too_high, group)):
            return False
        kinds = self.wishes.kinds
        if any(kinds[name].places == ("object",) for name in group) and not self._room_on_tops(group):
            return False
        taken = self.wishes.floor_area(both(self.wished, self.found, group))
        return self.wishes.floor_area(group) == 0 or taken <= limit * max(self.floor - self.freed, 0.0)

    def _strip(self, link: Link) -> float:
        """Return how many square metres are asked to stay free all around some things; where no metres are said as a body needs."""
        beyond = 2 * (link.metres[0] or SIZES.way)
        sizes = (self.wishes.kinds[self.wishes.kind(m.thing)].size[:2] for m in link.subjects)
        return sum((deep + beyond) * (wide + beyond) - deep * wide for deep, wide in sizes)

    def _of_one(self, name: str) -> bool:
        """Return whether a thing would lie under one of several alike: a rug under the first of three tables."""
        over, count = self._belongs_to(name, "rug")
        return count > (1 if over in ALONE_ON_A_RUG else ON_A_RUG)

    def _belongs_to(self, name: str, stands: str) -> tuple[str, int]:
        """Return the role of what a thing that only stands so lies under or hangs over, and how many of them there are."""
        role, counts = self.wishes.role(name), Counter[str]()
        if role is None or role.stands != (stands,):
            return "", 0
        there = both(self.wished, self.found)
        for other, bearer in self.wishes.playing(there).items():
            counts[bearer.name] += there[other]
        over = next((kind for kind in role.above if counts[kind]), "")
        return over, counts[over]

    def _room_on_tops(self, group: Mapping[str, int]) -> bool:
        """Whether tops have room for everything that is added and can stand on some."""
        added, kinds = both(self.found, group), self.wishes.kinds
        area = {name: count * math.prod(kinds[name].size[:2]) for name, count in both(self.wished, added).items()}
        tops = sum(area[name] for name, role in self.wishes.playing(area).items() if role.top)
        carried = (added[name] * math.prod(kinds[name].size[:2]) for name in added if "object" in kinds[name].places)
        return sum(carried) <= ON_TOPS * tops

    def _too_high(self, name: str) -> bool:
        """Whether a thing that is opened, or a hood, hangs above what one of the bodies reaches: a wall cabinet for a child."""
        kind, role = self.wishes.kinds[name], self.wishes.role(name)
        used = kind.open_depth > 0 or (role is not None and role.name == "hood")
        if role is None or kind.on_floor or not used or not role.hung(kind.size[2]):
            return False
        bottom = role.hung(kind.size[2]) - kind.size[2] / 2
        return any(agent.reach_distance is not None and bottom > agent.reach_high for agent in self.agents)

    def _companions(self, name: str) -> Mapping[str, int]:
        """Return what a thing is of no use without, by its own name or by what it is like."""
        table = self.wishes.rooms.companions
        return table.get(name) or table.get(self.wishes.kinds[name].like or "", {})

    def _go_along(self, name: str, count: int) -> None:
        """Add what a wished thing is of no use without; benches and stools are seats of tables, too."""
        others = {other for other in self.wished if self._of_another(other, name)}
        there = {self.wishes.head(other) for other in self.wished.keys() - others if not visits(other)}
        there |= self.wishes.general - {self.wishes.head(other) for other in others}
        # "a table for six and two chairs by the fire": it has its own
        promised = self.wishes.seats and "chair" in self.asked
        stood_at = self.room.name in STOOD_AT or promised or no_chairs(self.wished)
        there |= {"chair"} if head(name) == "table" and stood_at else set()
        there |= SEATS if self._seated(name) else set()  # a stool, beside the chair of a vanity
        if self.room.tables and head(name) == "desk" and "chair" not in map(head, self.wishes.things):
            there.discard("chair")  # those that are there are of the tables
        for other, each in self._companions(name).items():
            if other not in self.spared and head(other) not in there:
                most = self._sitting_at(name, each) if head(other) == "chair" else each
                self.found[other] = self.found.get(other, 0) + count * self._at_open_sides(other, most)

    def _seated(self, name: str) -> bool:
        """Return whether a thing is said to have seats: "a vanity with a chair"."""
        links = (k for k in self.wishes.reading.parsed.links if k.relation in ("with", "around"))
        own = (k for k in links if name in map(self.wishes.kind, named(k.objects)))
        return any(head(self.wishes.kind(one)) in ("chair", *SEATS) for k in own for one in named(k.subjects))

    def _sitting_at(self, name: str, each: int) -> int:
        """Return how many chairs a thing has of its usual ones, by what is said to be on it: one at a computer, nobody at a printer."""
        links = [link for link in self.wishes.reading.parsed.links if link.relation == "on"]
        on = (m.thing for k in links if name in map(self.wishes.kind, named(k.objects)) for m in k.subjects)
        roles = self.wishes.playing(map(self.wishes.kind, on)).values()
        first = {role.joins[0].of[0] for role in roles if role.joins}
        if first == {"office storage"} and name not in self.room.base:
            return 0
        return 1 if "desk" in first else each

    def _at_open_sides(self, name: str, most: int) -> int:
        """Return how many of a thing are added: one where it usually stands beside what is asked into a corner, none beside free floor."""
        role = self.wishes.role(name)
        if role is None or not any(map(role.stands_beside, self.cornered)):
            return most
        return int(not any(map(role.stands_beside, self.bared)))

    def _borne(self, name: str, most: int) -> int:
        """Return how many of a thing are added: no two lamps on one desk."""
        role = self.wishes.role(name)
        join = next((join for join in role.joins if join.on_top), None) if role else None
        if join is None or self.wishes.kinds[name].places != ("object",):
            return most
        there = both(self.wished, self.found)
        bearers = {one: there[one] for one, other in self.wishes.playing(there).items() if other.name in join.of}
        free = {one: count for one, count in bearers.items() if self._has_room(one, count, name)}
        return 0 if bearers and not free else min(most, max(join.most * sum(free.values()), 1))

    def _has_room(self, bearer: str, count: int, name: str) -> bool:
        """Return whether a thing still fits on tops beside what the words put there."""
        links = [link for link in self.wishes.reading.parsed.links if link.relation == "on"]
        laid = (m for k in links if bearer in map(self.wishes.kind, named(k.objects)) for m in k.subjects)
        sizes = [(self.wishes.kinds[self.wishes.kind(m.thing)].size, m.count) for m in laid]
        top, own = self.wishes.kinds[bearer].size, self.wishes.kinds[name].size
        taken = sum(size[0] * size[1] * number for size, number in sizes) / count + own[0] * own[1]
        free = stands_free(own, top, [size for size, _ in sizes])
        return not sizes or (free and taken <= TOP_SHARE * top[0] * top[1])

    def _roles_of(self, things: Iterable[NamedThing]) -> set[str]:
        """Return the names of the roles of things that are named."""
        return {role.name for role in self.wishes.playing(map(self.wishes.kind, things)).values()}

    def _of_another(self, name: str, owner: str) -> bool:
        """Return whether a thing is said to be around, or with, other things than its owner alone: the chairs of a table."""
        links = [link for link in self.wishes.reading.parsed.links if link.relation in ("with", "around")]
        named_so = [thing for thing, kind in self.wishes.asked.items() if kind.name == name]
        own = [[link for link in links if thing in named(link.subjects)] for thing in named_so]
        had = [(self.wishes.kind(to.thing), link) for link in links for to in mentions(link.objects)]
        owners = {kind for kind, link in had if any(link in each for each in own)}
        mates = {kind for kind, link in had if owner in map(self.wishes.kind, named(link.subjects))}
        names = (owner, self.wishes.kinds[owner].like or owner, *mates)  # "a mirror and a chair at each station"
        return all(own) and bool(owners) and not any(one.endswith(tuple(owners)) for one in names)

    def _add(self, name: str, most: int) -> None:
        """Add a thing with what it needs, as many times as there is room for."""
        present = {self.wishes.head(other) for other in (*self.wished, *self.found)}
        # chairs are there, and nothing that they stand at
        tops = {self.wishes.head(other) for other in (*self.wished, *self.found) if other not in LOW}
        waiting = "chair" in present and not {"table", "desk"} & tops
        needs = {
            other: each
            for other, each in self._companions(name).items()
            if (head(other) == "chair" and not waiting) or (head(other) not in present and other not in self.room.base)
        }
        limit = BASIC if name in self.room.base and self.fill > AIRY else self.fill
        for count in range(most, 0, -1):
            group = {other: count * each for other, each in {name: 1, **needs}.items()}
            if self._fits(group, limit):
                if not self.wishes.useless(name, {**self.wished, **self.found, **group}):
                    self.found |= group
                return

    def _zones(self) -> None:
        """Add one group after the other to a large room; where some are said, the others are not as many more."""
        times = self.wishes.times_usual
        zones = [zone for zone in self.room.zones if not any(self._named(name) for name in zone)]
        turns = math.ceil(round(2 * times) * len(zones) / len(self.room.zones)) if zones and times >= LARGER else 0
        for turn in range(turns):
            zone = zones[turn % len(zones)]
            self.found = both(self.found, zone) if self._fits(zone, self.fill) else self.found


def no_chairs(wished: Mapping[str, int]) -> bool:
    """Return whether other seats are at tables in place of chairs; a single bench is at one side, chairs are at the others."""
    seats = {name: count for name, count in wished.items() if name in SEATS and count}
    return bool(seats) and seats != {"bench": 1}


def both(*lists: Mapping[str, int]) -> dict[str, int]:
    """Return what several lists hold together."""
    return {name: sum(other.get(name, 0) for other in lists) for one in lists for name in one}
