"""Bodies in MuJoCo: each driven to all that it uses, and pulling open each door and drawer by its handle.

Every example and task laid out for its own body, and for each of the 15 bodies; small rooms first.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import robolayout as rl
from benchmarks.examples import ROOMS, ROOT
from benchmarks.measures import watch
from benchmarks.store import Row
from benchmarks.tables import Rows, of, table
from robolayout.export import drive, pull_open
from robolayout.scene import agent_names, load_scene

OWN = "its own"


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case per room and body; rooms for their own bodies first."""
    examples = [ROOT / "examples" / f"{room}.json" for room in ROOMS]
    tasks = sorted((ROOT / "examples" / "tasks").glob("*.json"))
    for room in examples[:1] if quick else [*examples, *tasks]:
        yield f"{OWN}/{room.stem}", partial(measured, room, None)
    for room in () if quick else sorted([*examples, *tasks], key=lambda room: len(load_scene(room).assets)):
        for body in agent_names():
            yield f"{body}/{room.stem}", partial(measured, room, body)


def measured(room: Path, body: str | None) -> Row:
    """Return what a body touches on its ways, and while it opens what it opens."""
    result = rl.generate(room, seed=0, agent=body)
    report = result.report.agents[0]
    with watch() as driving:
        driven = drive(result.scene, result.layout, report.agent, report.ways)
    holds = report.usage.holds
    with watch() as pulling:
        opened = pull_open(result.scene, result.layout, report.agent, holds)
    free = [pulled.ok for pulled in opened.joints.values()]  # furniture first
    return {
        "ok": result.report.ok,
        "short": list(report.short),
        "impossible": list(report.impossible),
        "ways": len(driven.drives),
        "touching": list(driven.violations),
        "undriven": len(report.usage.undriven),
        "off_mm": 1000 * max((way.error for way in driven.drives.values()), default=0.0),
        "joints": len(holds),
        "opened": sum(free[: len(holds)]),
        "leaves": len(free) - len(holds),
        "leaves_opened": sum(free[len(holds) :]),
        "aside": sum(bool(hold.moved) for hold in holds),
        "stepping": sum(len(hold.poses) > 1 for hold in holds),
        "shut": list(opened.violations),
        "newtons": max((pulled.force for pulled in opened.joints.values()), default=0.0),
        "drive_cpu": driving.cpu,
        "pull_cpu": pulling.cpu,
    }


def section(rows: Rows, images: Path) -> str:
    """Return one line per body, and what was touched."""
    groups: dict[str, dict[str, Row]] = {}
    for key, row in rows.items():
        body, _, room = key.partition("/")
        groups.setdefault(body, {})[room] = row
    heads = ["body", "rooms", "all demands met", "ways", "with contacts", "undriven", "doors and drawers"]
    heads += ["opened, nothing touched", "leaves of room doors", "something moved aside", "stepping back", "N at most"]
    lines: list[list[str]] = []
    for body, rooms in groups.items():
        found = rooms.values()
        names = ("ways", "undriven", "joints", "opened", "leaves", "leaves_opened", "aside", "stepping")
        total = {n: sum(row[n] for row in found) for n in names}
        touching = sum(len(row["touching"]) for row in found)
        possible = [row for row in found if not row["impossible"]]
        met = of(sum(row["ok"] for row in possible), len(possible))
        line = [len(rooms), met, total["ways"], touching, total["undriven"], total["joints"]]
        shares = [of(total["opened"], total["joints"]), of(total["leaves_opened"], total["leaves"])]
        rest = [total["aside"], total["stepping"], round(max(row["newtons"] for row in found))]
        lines.append([body.replace("_", " "), *map(str, [*line, *shares, *rest])])
    told = "".join(f"- {key}: {text}\n" for key, row in rows.items() for text in row["touching"] + row["shut"])
    lacking = "".join(
        f"- {key}: {', '.join(row['short'])} out of reach or use.\n"
        for key, row in rows.items()
        if row["short"] and not row["impossible"]
    )
    pairs, everything = (sum(not key.startswith(f"{OWN}/") for key in keys) for keys in (rows, dict(cases(False))))
    intro = (
        f"Measured so far: {pairs} of {everything} pairs of a built-in body and a room, the rooms with the fewest things first. "
        "Each body's footprint is driven to all that it uses (*undriven*: it could stand at it and finds no way that it can "
        "drive), the room's doors open. *All demands met*: of the rooms that are possible for the body. "
        "Then each door and drawer, of what it uses, whose handle it reaches in height is "
        "pulled by a force at the handle, the body standing where the report says and all that can move free, and so is each "
        "leaf of the room's own doors, as by one who comes in. It is opened if it gets to its stop and neither leaf nor body "
        "touches anything else. *Something moved aside*: what people move in daily use stood in the way. "
        "*Stepping back*: no place is clear of all that the leaf sweeps.\n"
    )
    return f"## Ways driven, doors and drawers opened\n\n{intro}\n{table(heads, lines)}\n{told}{lacking}"
