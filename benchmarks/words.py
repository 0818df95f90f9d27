"""Prompts in other people's manner, each with the demands that a person reads in it, checked by plain geometry.

The prompts and their demands are in `benchmarks/prompts/`: `open.txt` is what the reader is developed with, `held.txt` is looked at
only for the figures. After a prompt ("@ ...") come its demands, separated by semicolons:

    bed 1; plant >=2; coffee table 0       how many there are ("a|b": either word)
    on lamp, desk; between a, b, c         how things stand to each other, or (wall sofa) to the room
    half left table; path sofa; daylight desk; openmiddle     half of the room, way from a door, window near, middle free
    room office; size 5 x 4; area 20; height 3; body cat; windows 2; doors 1; shape L

Nothing here uses the package's reader, statements or checks: it looks at the dictionaries of `scene.json` and `layout.json`.
"""

from __future__ import annotations

import json
import re
import statistics
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from shapely import Polygon

from benchmarks.seen import PAIRS, WHOLE, Room, at_place, between, in_half, open_middle, turned_to
from benchmarks.store import Row
from benchmarks.tables import Rows, of, select, table

FOLDER = Path(__file__).parent / "prompts"
FILES = ("held", "open")
FACTS = {
    "room": ("room type",), "size": ("room size",), "area": ("room area",), "height": ("room height",), "body": ("body",),
    "windows": ("opening",), "doors": ("opening",), "shape": ("room type",),
}  # fmt: skip
"""What a demand can say of the room itself, and the kinds of rows of the ledger that do."""
RELATIONS = (
    "on", "next", "near", "far", "front", "behind", "left", "right", "between", "around", "facing", "opposite", "above", "under",
    "wall", "corner", "atwindow", "atdoor", "middle", "row", "stacked", "pairs", "diagonal", "half", "daylight", "path", "openmiddle",
)  # fmt: skip
PLACES = RELATIONS[14:]


@dataclass(frozen=True)
class Demand:
    """One demand of a prompt: "count", a relation or a fact, and what it is about."""

    kind: str
    about: tuple[str, ...]
    how: str = ""
    number: int = 0


@dataclass(frozen=True)
class Prompt:
    """A text and its demands."""

    text: str
    demands: tuple[Demand, ...]


def prompts(name: str) -> list[Prompt]:
    """Return the prompts of a file."""
    found: list[Prompt] = []
    for block in re.split(r"^@ ", (FOLDER / f"{name}.txt").read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
        text, _, rest = block.partition("\n")
        pieces = [piece.strip() for piece in re.split(r"[;\n]", rest) if piece.strip()]
        found.append(Prompt(text.strip(), tuple(_demand(piece) for piece in pieces)))
    return found


def _demand(text: str) -> Demand:
    word, _, rest = text.partition(" ")
    counted = re.fullmatch(r"(.*?) ?(>=|<=)?(\d+)", text)
    if counted is not None and word not in FACTS:
        return Demand("count", (counted.group(1).strip(),), counted.group(2) or "==", int(counted.group(3)))
    if word in FACTS:
        return Demand(word, (rest.strip(),))
    if word in RELATIONS:
        return Demand(word, tuple(part.strip() for part in rest.split(",")))
    raise ValueError(f"{text!r} is no demand")


def related(room: Room, demand: Demand, wanted: int) -> bool:
    """Return whether at least `wanted` of the things of a relation stand as it says."""
    if demand.kind == "openmiddle":
        return open_middle(room)
    side, _, half = demand.about[0].partition(" ")
    things = room.find(half if demand.kind == "half" else demand.about[0])
    if not things:
        return False
    if demand.kind in WHOLE:
        return len(things) > 1 and WHOLE[demand.kind](room, things)
    if demand.kind == "half":
        good = [a for a in things if in_half(room, a, side)]
    elif demand.kind in PLACES:
        good = [a for a in things if at_place(room, demand.kind, a)]
    elif demand.kind == "between":
        ends = list(dict.fromkeys(name for word in demand.about[1:] for name in room.find(word)))
        good = [a for a in things if between(room, a, [end for end in ends if end != a])]
    elif demand.kind == "facing" and demand.about[1] in ("door", "window"):
        lines = room.openings(f"{demand.about[1]}s")
        good = [a for a in things if any(turned_to(room, a, line) for line in lines)]
    else:
        others = room.find(demand.about[1])
        test = PAIRS[demand.kind]
        good = [a for a in things if any(test(room, a, b) for b in others if b != a)]
    return len(good) >= min(wanted, len(things)) > 0


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
        return str(agent.get("name", "") if isinstance(agent, dict) else agent) == value
    if demand.kind == "shape":
        return len(room.floor) == 6
    return len(room.scene.get(demand.kind, [])) == int(value)


def verdicts(prompt: Prompt, room: Room, room_type: str) -> list[bool]:
    """Return for each demand of a prompt whether it is met."""
    counts = {demand.about[0]: demand.number for demand in prompt.demands if demand.kind == "count"}
    found: list[bool] = []
    for demand in prompt.demands:
        if demand.kind == "count":
            found.append(counted(room, demand))
        elif demand.kind in FACTS:
            found.append(fact(room, demand, room_type))
        else:
            found.append(related(room, demand, counts.get(demand.about[0], 99)))
    return found


def class_of(demand: Demand) -> str:
    """Return the kind under which a demand is counted."""
    if demand.kind == "count":
        return "counts"
    if demand.kind in FACTS:
        return "room"
    return "places in the room" if demand.kind in PLACES else "relations"


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case for each prompt."""
    for file in FILES:
        given = prompts(file)
        for number, prompt in enumerate(given[:2] if quick else given):
            yield f"{file}/{number:03}", partial(measured, prompt)


def measured(prompt: Prompt) -> Row:
    """Return how many demands of each kind a prompt has and how many are met, and what the ledger says of them."""
    import robolayout as rl

    start = time.process_time()
    try:
        scene, understood = rl.scene_from_sentence(prompt.text)
        result = rl.generate(scene)
    except rl.RoboLayoutError as error:
        row: Row = {"refused": str(error)[:160], "seconds": time.process_time() - start}
        for demand in prompt.demands:
            row[f"{class_of(demand)} asked"] = row.get(f"{class_of(demand)} asked", 0) + 1
        return row
    from robolayout.scene import scene_to_dict

    room = Room(json.loads(json.dumps(scene_to_dict(result.scene))), result.layout.to_dict())
    met = verdicts(prompt, room, understood.room_type)
    row = {"ok": result.report.ok, "seconds": time.process_time() - start}
    for demand, good in zip(prompt.demands, met, strict=True):
        for key in ("asked", *(["met"] if good else [])):
            row[f"{class_of(demand)} {key}"] = row.get(f"{class_of(demand)} {key}", 0) + 1
    ledger = result.report.asked
    agreed = list(_agreement(prompt, met, room, ledger))
    row |= {
        "unmet": "; ".join(shown(demand) for demand, good in zip(prompt.demands, met, strict=True) if not good),
        "dropped": len(dropped(prompt, met, room, ledger)),
        "compared": len(agreed),
        "agreed": sum(agreed),
        "rows": len(ledger),
        "rows unmet": sum(r.verdict == "unmet" for r in ledger),
        "rows not understood": sum(r.verdict == "not understood" for r in ledger),
    }
    return row


def shown(demand: Demand) -> str:
    """Return a demand as a result file names it."""
    return f"{demand.kind} {', '.join(demand.about)} {demand.number or ''}".strip()


def dropped(prompt: Prompt, met: list[bool], room: Room, ledger: Any) -> list[Demand]:
    """Return the demands that are unmet while no row of the ledger is about them, whatever its verdict."""
    lost = (demand for demand, good in zip(prompt.demands, met, strict=True) if not good)
    return [demand for demand in lost if not any(_covers(row, demand, room) for row in ledger)]


def _covers(row: Any, demand: Demand, room: Room) -> bool:
    """Return whether a row, or words given back as not understood, is about the things and the place of a demand."""
    words = row.words.lower()
    if demand.kind in FACTS:
        return row.kind in FACTS[demand.kind] or any(value in words for value in demand.about[0].split("|"))
    nouns = demand.about[0].split(" ", 1)[1:] if demand.kind == "half" else [noun for noun in demand.about if noun]
    said, things = f"{words} {row.understanding}", set(row.things)
    named = all(
        any(word.split()[-1] in said for word in noun.split("|")) or things & set(room.find(noun)) for noun in nouns
    )
    if demand.kind == "count":
        return named and row.kind in ("count", "refusal", "not understood")
    return named and row.kind != "count" and (len(nouns) > 1 or _same_word(demand, words))


def _agreement(prompt: Prompt, met: list[bool], room: Room, ledger: Any) -> Iterator[bool]:
    """Yield for each demand that has a row of the ledger whether both say the same."""
    for demand, good in zip(prompt.demands, met, strict=True):
        if demand.kind in FACTS:
            continue
        names = [set(room.find(word)) for word in demand.about if word not in ("door", "window")]
        for row in ledger:
            if row.verdict not in ("met", "unmet"):
                continue
            if demand.kind == "count":
                fits = row.kind == "count" and any(
                    word.split()[-1] in row.words.lower() for word in demand.about[0].split("|")
                )
            else:
                fits = row.kind == "relation" and all(found & set(row.things) for found in names)
                fits = fits and len(row.things) >= len(names) and _same_word(demand, row.words)
            if fits:
                yield (row.verdict == "met") == good
                break


WORDS = {
    "next": ("next", "beside", "side"),
    "atwindow": ("window",),
    "atdoor": ("door", "entrance", "exit"),
    "front": ("front", "foot"),
    "wall": ("wall",),
    "row": ("row", "line"),
    "middle": ("middle", "cent"),
    "above": ("above", "over", "under"),
    "under": ("under", "beneath", "on"),
    "opposite": ("opposite", "across"),
    "stacked": ("stack",),
    "pairs": ("pair",),
    "path": ("path", "way"),
    "daylight": ("light",),
    "half": ("half", "side"),
    "openmiddle": ("middle", "cent"),
    "on": (" on", "with", "hold", "top"),
    "facing": ("fac", "seen"),
    "near": ("near", "close", "at", "by", "with", "next"),
}
"""Words by which a row of the ledger says a relation; the others say their own name."""


def _same_word(demand: Demand, words: str) -> bool:
    """Return whether a row says a relation, by its words besides those for the things: a "side table" is not beside one."""
    for noun in demand.about:
        words = words.replace(noun, "")
    return any(word in words for word in WORDS.get(demand.kind, (demand.kind,)))


def section(rows: Rows, images: Path) -> str:
    """Return the demands met by kind, for the prompts set aside and those of development, and how the ledger agrees."""
    kinds = ("counts", "relations", "places in the room", "room")
    lines: list[list[str]] = []
    for file, shown in (("held", "set aside"), ("open", "of development")):
        found = select(rows, lambda key, file=file: key[0] == file)
        totals = {
            key: sum(int(row.get(key, 0)) for row in found)
            for kind in kinds
            for key in (f"{kind} met", f"{kind} asked")
        }
        cells = [of(totals[f"{kind} met"], totals[f"{kind} asked"]) for kind in kinds]
        met, asked = (sum(totals[f"{kind} {word}"] for kind in kinds) for word in ("met", "asked"))
        compared, agreed = (sum(int(row.get(word, 0)) for row in found) for word in ("compared", "agreed"))
        lost, refused = str(sum(row.get("dropped", 0) for row in found)), str(sum("refused" in row for row in found))
        if found:
            seconds = f"{statistics.median(row['seconds'] for row in found):.1f}"
            lines.append(
                [f"{len(found)} {shown}", of(met, asked), *cells, of(agreed, compared), lost, refused, seconds]
            )
    heads = ["prompts", "all demands", *kinds, "ledger agrees", "dropped", "refused", "CPU s, median"]
    intro = (
        "Prompts of our own in the manner of published ones, with the demands that a person reads in them "
        "(`benchmarks/prompts/`), checked by a script that knows nothing of the reader. *Ledger agrees*: of the demands "
        "that have a row of the ledger, those to which both give the same verdict. *Dropped*: demands that are unmet while "
        "no row of the ledger, whatever its verdict, is about their things or place.\n"
    )
    return f"## Words\n\n{intro}\n{table(heads, lines)}\n{_words_by_kind(rows)}"


def _words_by_kind(rows: Rows) -> str:
    """Return how many demands of each single kind are met."""
    asked: dict[str, list[int]] = {}
    for column, file in enumerate(FILES):
        for number, prompt in enumerate(prompts(file)):
            row = rows.get(f"{file}/{number:03}")
            if row is None:
                continue
            unmet = [text.split()[0] for text in str(row.get("unmet", "")).split("; ") if text]
            for demand in prompt.demands:
                counts = asked.setdefault(demand.kind, [0, 0, 0, 0])
                counts[2 * column + 1] += 1
                lost = "refused" in row or demand.kind in unmet
                counts[2 * column] += not lost
                if lost and demand.kind in unmet:
                    unmet.remove(demand.kind)
    lines = [[kind, of(*asked[kind][:2]), of(*asked[kind][2:])] for kind in ("count", *RELATIONS) if kind in asked]
    return table(["demand", "set aside", "of development"], lines)
