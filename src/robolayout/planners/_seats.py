"""How many are said to sit at a thing, and what is side by side at one."""

from __future__ import annotations

import math
from collections.abc import Sequence

from robolayout.planners._knowledge import DATA
from robolayout.words import TABLEWARE, Link, NamedThing

AT_ONE = 10  # seats up to which "tables for six" is said of each of them
PLATE, SETTING = 0.32, 0.42  # metres from the edge of a table to the inner end of a plate, and across plate and cutlery
OVAL_ENDS = 0.45  # metres that an oval table is longer than a round one for as many: plates at its ends need room
SEATS, AT_A_LINE = ((*DATA["nouns"][name],) for name in ("seats", "at_a_line"))


def seats_of(thing: NamedThing, links: Sequence[Link]) -> float:
    """Return the seats that each of a thing is said to have: "for ten", "with six chairs", "ten chairs around it"."""
    if thing.people:
        return promised(thing)
    others = dict.fromkeys(one.thing for k in links if k.relation in ("with", "around") for one in k.subjects)
    return sum(other.count for other in others if other.noun.kind.endswith(SEATS)) / thing.count


def promised(thing: NamedThing) -> float:
    """Return the seats at each of a thing that "for ten" promises; tables of which no number is said share what more than one seats."""
    return thing.people / (thing.count if thing.plural and thing.number is None and thing.people > AT_ONE else 1)


def sit_in_a_line(thing: NamedThing, relation: str, kind: str, each: float) -> bool:
    """Return whether so many of a kind are side by side at a thing: stools at a counter, tables at a bench, two at a desk."""
    if thing.noun.kind.endswith("counter"):
        return relation in AT_A_LINE and kind.endswith(SEATS)
    at_desk = relation == "with" and thing.noun.said == "desk" and kind.endswith("chair")
    return each > 1 and (at_desk or (relation == "front" and thing.head == "bench" and kind.endswith("table")))


def laid_across(links: Sequence[Link], seats: int) -> float:
    """Return the metres across a round table that links lay for so many, so that no plate meets the next; 0 if they lay nothing."""
    laid = any(one.thing.head in TABLEWARE for k in links if k.relation in ("with", "on") for one in k.subjects)
    return round(2 * PLATE + seats * SETTING / math.pi, 2) if laid else 0.0
