"""Who uses a room, and what they bring along besides what is named: chairs, desks, beds, seats for a crowd."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from robolayout.planners._added import LARGER, no_chairs
from robolayout.planners._knowledge import DATA
from robolayout.planners._room_size import SIZES
from robolayout.planners._wishes import LOW, RoomWishes, head
from robolayout.words import ABREAST, COUNTERS, SHAPES, Link, NamedThing, named, visits

LOUNGE = {*DATA["nouns"]["lounge"]}
ON_A_SOFA, AT_ONE_SOFA = 3, 5
"""People on a sofa, and with the armchairs that go with it."""


def wished_things(wishes: RoomWishes) -> dict[str, int]:
    """Return what was asked for, with what the people in the sentence bring along."""
    room, wished = wishes.room, Counter(wishes.things)
    benches = _on_benches(wishes)
    people = _people(wishes, wished, benches)
    heads = {head(name) for name in wished}
    heads |= {"chair"} if no_chairs(wished) and "table" in heads else set()
    heads |= {"chair"} if "stool" in heads and _at_a_counter(wished) else set()
    heads |= (
        {"chair"} if room.tables and _count(wished, "stool") >= people else set()
    )  # all sit at the bar and at high tables
    heads |= {"laptop"} if heads & {"monitor", "computer"} else set()
    heads |= {"seat"} if heads & (LOUNGE | {"chair"}) else set()
    links = wishes.reading.parsed.links
    bare = {one.head for link in links if link.relation == "bare" for one in named(link.objects)}
    # "nothing on the desk"
    heads |= {head(name) for name in room.person if "desk" in bare and wishes.kinds[name].places == ("object",)}
    formed = (link for link in links if link.relation == "rows" or link.relation in SHAPES)
    rows = {head(one.noun.kind) for one in {m.thing for link in formed for m in link.subjects} | wishes.audience}
    if (rows & {"chair", "seat", "pew"} or "seat" in map(head, wished)) and "desk" not in heads:
        heads |= {"desk", "chair"}  # an audience sits before a board, at no desks
    about = (link for link in links if link.relation in ("with", "around", "by", "behind", "front", "oneside"))
    sat = _at_tables(about)
    if 2 * sum(thing.count for thing in sat if head(thing.noun.kind) in ("chair", "stool")) >= room.people:
        at_benches = {"desk", "chair"} if any(head(thing.noun.kind) == "stool" for thing in sat) else {"desk"}
        heads |= at_benches if "student desk" in room.person else set()  # the pupils sit at tables, or on stools
    seated = "table" in heads if room.tables else heads & LOUNGE
    if seated and not wishes.reading.people and wishes.useless("chair", {**wished, **room.base}):
        heads.add("chair")  # who is here sits elsewhere: on sofas, or on stools at high tables
    for name, count in room.person.items():
        # "a room for two with a bed, nothing else"
        promised = wishes.reading.people or wishes.seats or not wishes.things
        spared = wishes.reading.only and not (promised and wishes.kinds[name].on_floor)
        if people and head(name) not in heads and not spared and name not in wishes.reading.unwanted:
            own = people - wished["laptop"] * (name in ("monitor", "keyboard"))  # who has a laptop needs none
            own -= benches * (head(name) == "chair")  # who sits on them needs none
            wished[_chair(wishes) if head(name) == "chair" else name] += count * max(own, 0)
            if wishes.seats and head(name) == "desk":
                wished[_chair(wishes)] += count * people  # besides those at the table
    chairs = _count(wished, "chair")
    tables = any(head(name) == "table" for name in wished if "buffet" not in name)
    if room.tables and not tables and not rows & {"chair", "desk"}:
        wished[room.tables] = math.ceil(chairs / room.at_table)
    elif chairs and not tables and "dining table" in room.extras and not _at_a_counter(wished):
        wished["dining table"] = 1
    lounge = _lounge(wishes, wished)
    for name, count in wishes.implied.items():  # besides what is named, but not besides what is usual
        new = max(0, count - benches * (head(name) == "chair") - (wished[name] - wishes.things.get(name, 0)))
        wished[name] += new
        wished["office chair"] += new * (head(name) == "desk" and "office chair" in wished)
    wished["office chair"] += _at_meeting_tables(wishes, wished) + _unseated(wishes, wished)
    wished["side table"] += _without_a_top(wishes, {**wished, **room.base})
    return dict(+wished) | lounge


def _count(wished: Mapping[str, int], word: str) -> int:
    """Return how many things there are whose kind ends in a word."""
    return sum(count for name, count in wished.items() if head(name) == word)


def _without_a_top(wishes: RoomWishes, present: Mapping[str, int]) -> bool:
    """Return whether something can only stand on others of which none is there, nor asked to bear it: "a room with a vase"."""
    links = (k for k in wishes.reading.parsed.links if k.relation == "stacked" or named(k.objects))
    laid = {thing for link in links for thing in named(link.subjects)}
    alone = (kind.name for thing, kind in wishes.asked.items() if kind.places == ("object",) and thing not in laid)
    playing = wishes.playing(present)
    there = {role.name for role in playing.values()}
    joins = {name: {to for join in role.joins for to in join.of} for name, role in playing.items()}
    return not any(role.top for role in playing.values()) and any(not joins.get(name, set()) & there for name in alone)


def _unseated(wishes: RoomWishes, wished: Mapping[str, int]) -> int:
    """Return how many desks have no chair yet where others are said to have one: "each with a chair", besides a manager's desk."""
    links = (k for k in wishes.reading.parsed.links if any(head(m.thing.noun.kind) == "chair" for m in k.subjects))
    seated = {thing for k in links if k.relation == "with" for thing in named(k.objects) if thing.head == "desk"}
    alone = sum(thing.count for thing in wishes.asked if thing.head == "desk" and thing not in seated)
    desks, chairs = (sum(n for name, n in wished.items() if head(name) == what) for what in ("desk", "chair"))
    return min(alone, max(desks - chairs, 0)) if seated else 0


def _at_meeting_tables(wishes: RoomWishes, wished: Mapping[str, int]) -> int:
    """Return how many chairs are at meeting tables where the usual ones are at desks."""
    at_desks = "desk" in map(head, wished) and "chair" not in map(head, wishes.things)
    chairs = wishes.rooms.companions["conference table"]["office chair"]
    return chairs * wished.get("conference table", 0) * at_desks


def _lounge(wishes: RoomWishes, wished: Mapping[str, int]) -> dict[str, int]:
    """Return the sofas and armchairs of a room with seats for so many and no chairs for them; as many of them as are said stay."""
    people, other = wishes.reading.people, {head(name) for name in wished if name not in LOW} & {"chair", "table"}
    if other or people <= AT_ONE_SOFA or "sofa" not in wishes.room.base:
        return {}
    there = {kind: sum(n for name, n in wished.items() if head(name) == kind) for kind in ("sofa", "armchair")}
    sofas = there["sofa"] or math.ceil(people / AT_ONE_SOFA)
    armchairs = there["armchair"] or people - ON_A_SOFA * sofas
    added = {"sofa": sofas, "armchair": armchairs, "coffee table": sofas // 2}
    return {kind: n for kind, n in added.items() if n > 0 and not there.get(kind, 0)}


def usual_people(wishes: RoomWishes) -> int:
    """Return for how many such a room usually is; where each has a table of his own, for more in a larger one."""
    room, times = wishes.room, wishes.times_usual
    grows = times >= LARGER and (bool(room.tables) or len(room.person) > 1)
    return round(room.people * times) if grows else room.people


def _people(wishes: RoomWishes, wished: dict[str, int], benches: int) -> int:
    """Return for how many the room is: as said, else as many as have a seat, a desk or a bed; seats are wished for."""
    room = wishes.room
    if wishes.seats:
        adults = [name for name in wished if head(name) == "chair" and name != "kids chair"]
        chair = _chair(wishes)
        desks = sum(count for name, count in wished.items() if head(name) == "desk")
        elsewhere = sum(thing.count for thing in _elsewhere(wishes.reading.parsed.links))
        named = sum(wished[name] for name in adults)
        seats = max(wishes.seats - benches, 0)
        if named <= desks:  # what is asked for stands at the desks
            wished[chair] = max(wished.get(chair, 0), desks) + seats
        elif named == elsewhere:  # "a table for six and two chairs by the fire"
            wished[chair] += seats
        elif named == 1:  # "a table for six, the host's chair at its head"
            wished[chair] = max(wished.get(chair, 0), seats)
    if wishes.reading.people:
        return 0 if room.couple and wishes.reading.people == 2 and not wishes.reading.young else wishes.reading.people
    taken = {head(name) for name in room.person}
    taken |= {"computer"} if "desk" in taken else set()
    if "desk" in {head(name) for name in wished}:
        taken -= {"computer", "monitor"}  # two on a desk are of one person
    if "desk" in taken and (wishes.seats or any(head(name) == "desk" and not visits(name) for name in wished)):
        taken = {"desk"}  # who sits at the table also has a desk, and each of the other chairs is somebody else's
    tables = [(wishes.kinds[name], n) for name, n in wished.items() if room.tables and head(name) == "table"]
    seats = sum(count * (2 if max(kind.size[:2]) <= SIZES.for_two else 4) for kind, count in tables)
    own = [count for name, count in wished.items() if head(name) in taken and not visits(name)]
    return max(own, default=seats or usual_people(wishes))


def _on_benches(wishes: RoomWishes) -> int:
    """Return how many sit on benches that are long for it, or at tables: "a table for ten with benches on both sides"."""
    there = _at_tables(wishes.reading.parsed.links)
    benches = [(thing, kind.size[1]) for thing, kind in wishes.asked.items() if kind.name == "bench"]
    return sum(one.count * int(wide / ABREAST + 0.1) for one, wide in benches if one.sizes or one in there)


def _at_tables(links: Iterable[Link]) -> set[NamedThing]:
    """Return the seats that are asked to be at tables."""
    tables = ("table", "lab bench", "workbench")
    at = (k for k in links if any(to.noun.kind.endswith(tables) for to in named(k.objects)))
    return {mention.thing for link in at for mention in link.subjects if mention.sat_on}


def _elsewhere(links: Sequence[Link]) -> set[NamedThing]:
    """Return the chairs that are asked to be somewhere else than at tables."""
    there = {m.thing for k in links if k.relation != "with" and k.objects for m in k.subjects}
    return {thing for thing in there - _at_tables(links) if head(thing.noun.kind) == "chair"}


def _at_a_counter(wished: Mapping[str, int]) -> bool:
    """Return whether there is a high counter and nothing else that people would sit at."""
    return bool(COUNTERS & {*wished}) and not {"table", "desk", "chair"} & {*map(head, wished)}


def _chair(wishes: RoomWishes) -> str:
    """Return what one sits on in a room at a table, or at the high counter that stands there instead."""
    if _at_a_counter(wishes.things):
        return "bar stool"
    return next((name for name in wishes.room.person if head(name) == "chair"), "chair")
