"""Prompts in plain language, each with the demands that a person reads in it, checked by plain geometry.

The prompts and their demands are in `benchmarks/prompts/`, in the form that `benchmarks/demands.py` describes: `open.txt` and
`strangers_open.txt` are what the reader is developed with, `held.txt` and `strangers.txt` are looked at only for the figures.
The strangers saw neither the code nor any of our texts; they wrote paragraphs and their demands.

Nothing here uses the package's reader, statements or checks: it looks at the dictionaries of `scene.json` and `layout.json`.
"""

from __future__ import annotations

import json
import statistics
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from benchmarks.demands import FACTS, RELATIONS, SIZES, Demand, Prompt, class_of, prompts, shown, verdicts
from benchmarks.seen import Room
from benchmarks.store import Row
from benchmarks.tables import Rows, of, select, table

FILES = {
    "held": "of our own, set aside",
    "open": "of our own, of development",
    "strangers": "of strangers, set aside",
    "strangers_open": "of strangers, of development",
}
"""The files of prompts, and what they are."""


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
    row = {"ok": result.report.ok, "right": all(met), "seconds": time.process_time() - start}
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


def dropped(prompt: Prompt, met: list[bool], room: Room, ledger: Any) -> list[Demand]:
    """Return the demands that are unmet while no row of the ledger is about them, whatever its verdict."""
    lost = (demand for demand, good in zip(prompt.demands, met, strict=True) if not good)
    return [demand for demand in lost if not any(_covers(row, demand, room) for row in ledger)]


def _covers(row: Any, demand: Demand, room: Room) -> bool:
    """Return whether a row, or words given back as not understood, is about the things and the place of a demand."""
    words = row.words.lower()
    if demand.kind in FACTS:
        return row.kind in FACTS[demand.kind] or any(value in words for value in demand.about[0].split("|"))
    nouns = [noun for noun in demand.about if noun]
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
        if demand.kind in (*FACTS, *SIZES):
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
    """Return the demands met by kind for the prompts of each file, how many are wholly right, and how the ledger agrees."""
    kinds = ("counts", "relations", "places in the room", "sizes", "room")
    lines = [_line(shown, select(rows, lambda key, file=file: key[0] == file), kinds) for file, shown in FILES.items()]
    heads = ["prompts", "wholly right", "right, says the report", "all demands", *kinds, "ledger agrees", "dropped"]
    intro = (
        "Prompts with the demands that a person reads in them (`benchmarks/prompts/`), checked by a script that knows nothing of "
        "the reader. *Of our own*: written by us in the manner of published ones, and worked on for months. *Of strangers*: "
        "paragraphs and demands by testers who saw neither code nor texts of ours; those set aside are looked at for these figures "
        "only. *Wholly right*: every demand is met, by this script. *Right, says the report*: "
        "`ok` and no row unmet or not understood; in brackets how many of these are wholly right. *Ledger agrees*: of the "
        "demands that have a row of the ledger, those to which both give the same verdict. *Dropped*: demands that are unmet while "
        "no row of the ledger, whatever its verdict, is about their things or place.\n"
    )
    other = {file: sum(prompt.others for prompt in prompts(file)) for file in FILES}
    left = f"Not judged, as the script has no words for them: {', '.join(f'{n} {FILES[file]}' for file, n in other.items() if n)}.\n"
    table_of_kinds = _words_by_kind(rows)
    return f"## Words\n\n{intro}\n{table([*heads, 'refused', 'CPU s, median'], filter(None, lines))}\n{left}\n{table_of_kinds}"


def _line(shown: str, found: list[Row], kinds: Sequence[str]) -> list[str]:
    """Return the cells of the prompts of a file."""
    if not found:
        return []
    totals = {
        word: [sum(int(row.get(f"{kind} {word}", 0)) for row in found) for kind in kinds] for word in ("met", "asked")
    }
    pairs = [*zip(totals["met"], totals["asked"], strict=True)]
    fine = [row for row in found if row.get("ok") and not row["rows unmet"] + row["rows not understood"]]
    right = sum(bool(row.get("right")) for row in found)
    compared, agreed = (sum(int(row.get(word, 0)) for row in found) for word in ("compared", "agreed"))
    return [
        f"{len(found)} {shown}", of(right, len(found)), f"{len(fine)} ({sum(row['right'] for row in fine)})",
        of(sum(totals["met"]), sum(totals["asked"])), *(of(*pair) for pair in pairs), of(agreed, compared),
        str(sum(row.get("dropped", 0) for row in found)), str(sum("refused" in row for row in found)),
        f"{statistics.median(row['seconds'] for row in found):.1f}",
    ]  # fmt: skip


def _words_by_kind(rows: Rows) -> str:
    """Return how many demands of each single kind are met."""
    asked: dict[str, list[list[int]]] = {}
    for column, file in enumerate(FILES):
        for number, prompt in enumerate(prompts(file)):
            row = rows.get(f"{file}/{number:03}")
            if row is None:
                continue
            unmet = [text.split()[0] for text in str(row.get("unmet", "")).split("; ") if text]
            for demand in prompt.demands:
                counts = asked.setdefault(demand.kind, [[0, 0] for _ in FILES])[column]
                lost = "refused" in row or demand.kind in unmet
                counts[0] += not lost
                counts[1] += 1
                if lost and demand.kind in unmet:
                    unmet.remove(demand.kind)
    lines = [[kind, *(of(*counts) for counts in asked[kind])] for kind in ("count", *RELATIONS) if kind in asked]
    return table(["demand", *FILES.values()], lines)
