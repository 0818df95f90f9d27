"""Bodies in MuJoCo: each driven to all that it uses, and pulling open each door and drawer by its handle.

The four examples laid out for each of the 15 bodies, and every example and task for its own.
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
from robolayout.scene import agent_names

OWN = "its own"


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case per room and body; rooms for their own bodies first."""
    examples = [ROOT / "examples" / f"{room}.json" for room in ROOMS]
    tasks = sorted((ROOT / "examples" / "tasks").glob("*.json"))
    for room in examples[:1] if quick else [*examples, *tasks]:
        yield f"{OWN}/{room.stem}", partial(measured, room, None)
    for body in () if quick else agent_names():
        for room in examples:
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
    return {
        "ok": result.report.ok,
        "ways": len(driven.drives),
        "touching": list(driven.violations),
        "undriven": len(report.undriven),
        "off_mm": 1000 * max((way.error for way in driven.drives.values()), default=0.0),
        "joints": len(holds),
        "opened": sum(pulled.ok for pulled in opened.joints.values()),
        "grazing": sum(pulled.ok and bool(pulled.contacts) for pulled in opened.joints.values()),
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
    heads = ["body", "rooms", "ways", "with contacts", "undriven", "doors and drawers", "opened, nothing touched"]
    heads += ["touching at their stop", "something moved aside", "stepping back", "N at most"]
    lines: list[list[str]] = []
    for body, rooms in groups.items():
        found = rooms.values()
        total = {n: sum(row[n] for row in found) for n in ("ways", "undriven", "joints", "opened")}
        touching = sum(len(row["touching"]) for row in found)
        lines.append(
            [body.replace("_", " "), str(len(rooms)), str(total["ways"]), str(touching), str(total["undriven"])]
        )
        lines[-1] += [str(total["joints"]), of(total["opened"], total["joints"])]
        lines[-1] += [str(sum(row[n] for row in found)) for n in ("grazing", "aside", "stepping")]
        lines[-1] += [f"{max(row['newtons'] for row in found):.0f}"]
    told = "".join(f"- {key}: {text}\n" for key, row in rows.items() for text in row["touching"] + row["shut"])
    intro = (
        "Each body's footprint is driven to all that it uses (*undriven*: it would use it and finds no way that it can "
        "drive), the room's doors open. Then each door and drawer, of what it uses, whose handle it reaches in height is "
        "pulled by a force at the handle, the body standing where the report says and all that can move free. It is opened "
        "if neither leaf nor body touches anything else before 95 % of its range (*touching at their stop*: they do after "
        "that, a handle the wall beside it). *Something moved aside*: what people move in daily use stood in the way. "
        "*Stepping back*: no place is clear of all that the leaf sweeps.\n"
    )
    return f"## Ways driven, doors and drawers opened\n\n{intro}\n{table(heads, lines)}\n{told}"
