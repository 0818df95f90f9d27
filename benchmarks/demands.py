"""Demands as a person writes them down under a prompt, and whether a furnished room meets them, by plain geometry.

After a prompt ("@ ...") come its demands, separated by semicolons:

    bed 1; plant >=2; coffee table 0       how many there are ("a|b": either word)
    on lamp, desk; between a, b, c         how things stand to each other, or (wall sofa) to the room
    on 2 lamp, desk; each on 1 lamp, desk  two of the lamps, else all of them; one on every desk
    half left table; atwall north bed; incorner southeast plant; free front 0.9 oven     a side of the room or of a thing
    wide 1.6 bed; high 2 bookcase; mounted 1.5 mirror; apart >=1 desk, bed; rows 3 desk  metres, rows
    path sofa; daylight desk; openmiddle   way from a door, window near, middle free
    room office; size 5 x 4; area 20; height 3; body cat; windows 2; doors 1; doorwall south; shape L
    other the doors of the closet open     what cannot be judged so: counted, not judged

Nothing here uses the package's reader, statements or checks: it looks at the dictionaries of `scene.json` and `layout.json`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from shapely import Polygon

from benchmarks import placed
from benchmarks.seen import PAIRS, SIDES, WHOLE, Room, at_place, between, in_half, open_middle

FOLDER = Path(__file__).parent / "prompts"
FACTS = {
    "room": ("room type",), "size": ("room size",), "area": ("room area",), "height": ("room height",), "body": ("body",),
    "windows": ("opening",), "doors": ("opening",), "shape": ("room type",), "doorwall": ("opening",), "windowwall": ("opening",),
}  # fmt: skip
"""What a demand can say of the room itself, and the kinds of rows of the ledger that do."""
PLACES = (
    "wall", "corner", "atwindow", "atdoor", "middle", "row", "stacked", "pairs", "diagonal", "half", "daylight", "path", "openmiddle",
    "atwall", "incorner", "rows", *placed.WHOLE, *placed.AT,
)  # fmt: skip
SIZES = ("wide", "deep", "high", "mounted", "free")
RELATIONS = (*PAIRS, "between", *placed.PAIRS, "apart", *PLACES, *SIZES)
SIDED = ("half", "atwall", "incorner", "free")
"""Kinds whose first word is a side."""

AUDIENCE = 4
"""So many things that look at one stand in straight rows: those that look the same way as one that faces it do, too."""


@dataclass(frozen=True)
class Demand:
    """One demand of a prompt.

    Args:
        kind: "count", a relation or a fact.
        about: The nouns; of a fact, its value.
        how: How a number is meant: "==", ">=", "<=".
        number: So many things, metres or rows.
        side: A side of the room or of a thing.
        many: Of so many things; 0 is of all.
        each: Whether every thing of the second noun has so many.
    """

    kind: str
    about: tuple[str, ...]
    how: str = ""
    number: float = 0
    side: str = ""
    many: int = 0
    each: bool = False


@dataclass(frozen=True)
class Prompt:
    """A text, its demands, and how many it has that are not judged."""

    text: str
    demands: tuple[Demand, ...]
    others: int = 0


def prompts(name: str) -> list[Prompt]:
    """Return the prompts of a file."""
    found: list[Prompt] = []
    for block in re.split(r"^@ ", (FOLDER / f"{name}.txt").read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
        text, _, rest = block.partition("\n")
        pieces = [piece.strip() for piece in re.split(r"[;\n]", rest) if piece.strip()]
        judged = tuple(demand(piece) for piece in pieces if not piece.startswith("other "))
        found.append(Prompt(text.strip(), judged, len(pieces) - len(judged)))
    return found


def demand(text: str) -> Demand:
    """Return a demand that is written so.

    Raises:
        ValueError: If it is none.
    """
    word, _, rest = text.partition(" ")
    if word in FACTS:
        return Demand(word, (rest.strip(),))
    if word == "each":
        inner = demand(rest)
        if inner.kind in RELATIONS and inner.many and len(inner.about) == 2:
            return replace(inner, each=True)
    elif counted := re.fullmatch(r"(.*?) ?(>=|<=)?(\d+)", text):
        return Demand("count", (counted[1].strip(),), counted[2] or "==", int(counted[3]))
    elif word in RELATIONS and (rest or word == "openmiddle"):
        side, rest = rest.split(" ", 1) if word in SIDED else ("", rest)
        measured = re.fullmatch(r"(>=|<=)?([\d.]+) (.+)", rest)
        if word in ("apart", "rows", *SIZES):
            if measured is None:
                raise ValueError(f"{text!r} has no number")
            return Demand(word, _nouns(measured[3]), measured[1] or "==", float(measured[2]), side)
        if measured is not None:
            return Demand(word, _nouns(measured[3]), side=side, many=int(measured[2]))
        return Demand(word, _nouns(rest), side=side)
    raise ValueError(f"{text!r} is no demand")


def _nouns(text: str) -> tuple[str, ...]:
    return tuple(part.strip() for part in text.split(","))


def verdicts(prompt: Prompt, room: Room, room_type: str) -> list[bool]:
    """Return for each demand of a prompt whether it is met."""
    counts = {demand.about[0]: int(demand.number) for demand in prompt.demands if demand.kind == "count"}
    found: list[bool] = []
    for one in prompt.demands:
        if one.kind == "count":
            found.append(counted(room, one))
        elif one.kind in FACTS:
            found.append(fact(room, one, room_type))
        elif one.each:
            found.append(_for_each(room, one))
        else:
            found.append(related(room, one, one.many or counts.get(one.about[0], 99)))
    return found


def _for_each(room: Room, one: Demand) -> bool:
    things, others = (room.find(noun) for noun in one.about)
    good = [[a for a in things if a != b and _pair(one)(room, a, b)] for b in others]
    return bool(others) and all(len(found) >= one.many for found in good)


def _pair(one: Demand) -> Callable[[Room, str, str], bool]:
    return (PAIRS | placed.PAIRS)[one.kind]


def related(room: Room, demand: Demand, wanted: int) -> bool:
    """Return whether at least `wanted` of the things of a relation stand as it says."""
    if demand.kind == "openmiddle":
        return open_middle(room)
    if demand.about[0] in placed.OPENINGS:
        return placed.opening_is(room, demand.about[0], demand.kind, demand.number, demand.side)
    things = room.find(demand.about[0])
    if not things:
        return False
    if whole := (WHOLE | placed.WHOLE).get(demand.kind):
        return len(things) > 1 and whole(room, things)
    if demand.kind == "rows":
        return placed.in_rows(room, things, int(demand.number))
    good = [a for a in things if _good(room, demand, a)]
    if demand.kind == "facing" and len(things) >= AUDIENCE:
        good = [a for a in things if any(placed.look_alike(room, a, b) for b in good)]
    return len(good) >= min(wanted, len(things)) > 0


def _good(room: Room, one: Demand, a: str) -> bool:
    """Return whether a thing stands as a demand says."""
    if one.kind in SIZES:
        return placed.measures(room, a, one.kind, one.number, one.side)
    if one.kind in SIDED:
        return {"half": in_half, "atwall": placed.at_side, "incorner": placed.in_corner}[one.kind](room, a, one.side)
    if one.kind in placed.AT:
        return placed.AT[one.kind](room, a)
    if one.kind in PLACES:
        return at_place(room, one.kind, a)
    if one.about[-1] in placed.OPENINGS and one.kind != "between":
        return placed.to_opening(room, a, one.kind, one.about[-1], (one.how, one.number))
    others = [name for noun in one.about[1:] for name in room.find(noun) if name != a]
    if one.kind == "between":
        return between(room, a, list(dict.fromkeys(others)))
    if one.kind == "apart":
        return placed.apart(room, a, others, one.how, one.number)
    return any(_pair(one)(room, a, b) for b in others)


def counted(room: Room, demand: Demand) -> bool:
    """Return whether as many are there as the demand says."""
    there = len(room.find(demand.about[0]))
    return {"==": there == demand.number, ">=": there >= demand.number, "<=": there <= demand.number}[demand.how]


def fact(room: Room, demand: Demand, room_type: str) -> bool:
    """Return whether something about the room itself is as the demand says."""
    (value,) = demand.about
    xs, ys = zip(*room.floor, strict=True)
    if demand.kind == "room":
        return room_type in value.split("|")
    if demand.kind == "size":
        asked = sorted(float(part) for part in value.split("x"))
        sides = sorted((max(xs) - min(xs), max(ys) - min(ys)))
        return all(abs(a - b) <= 0.1 for a, b in zip(asked, sides, strict=True))
    if demand.kind == "area":
        return abs(Polygon(room.floor).area - float(value)) <= 0.05 * float(value)
    if demand.kind == "height":
        return abs(room.height - float(value)) <= 0.05
    if demand.kind == "body":
        agent = room.scene.get("agent", "")
        return str(agent.get("name", "") if isinstance(agent, dict) else agent) in value.split("|")
    if demand.kind == "shape":
        return len(room.floor) == 6
    if demand.kind.endswith("wall"):
        walls = [item["wall"] for item in room.scene.get(f"{demand.kind.removesuffix('wall')}s", [])]
        return any(placed.side_of(room, wall) == SIDES[value] for wall in walls)
    there = len(room.scene.get(demand.kind, []))
    return there >= int(value[2:]) if value.startswith(">=") else there == int(value)


def class_of(demand: Demand) -> str:
    """Return the kind under which a demand is counted."""
    if demand.kind == "count":
        return "counts"
    if demand.kind in FACTS:
        return "room"
    return "places in the room" if demand.kind in PLACES else "relations" if demand.kind not in SIZES else "sizes"


def shown(demand: Demand) -> str:
    """Return a demand as a result file names it."""
    parts = (demand.kind, "each" * demand.each, demand.side, demand.many or "", ", ".join(demand.about))
    number = f"{demand.how.replace('==', '')}{demand.number:g}" if demand.how else ""
    return " ".join(str(part) for part in (*parts, number) if part)
