"""The tasks of `examples/tasks/`, each for the default disc, a wheelchair user and the room's own body, three seeds."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from benchmarks.examples import DISC, ROOT
from benchmarks.measures import generated
from benchmarks.store import Row
from benchmarks.tables import HEADS, Rows, mean, shares, table

FOLDER = ROOT / "examples" / "tasks"
SEEDS = range(3)


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case per task, body and seed; all tasks with the first seed come first."""
    files = sorted(FOLDER.glob("*.json"))
    for seed in SEEDS[:1] if quick else SEEDS:
        for file in files[:2] if quick else files:
            bodies: dict[str, object] = {"disc 0.30": DISC, "wheelchair": "wheelchair"}
            own = json.loads(file.read_text(encoding="utf-8")).get("agent")
            if own is not None and own != "wheelchair":
                bodies["its own"] = None
            for body, agent in bodies.items():
                yield f"{file.stem}/{body}/{seed}", partial(generated, file, agent=agent, seed=seed)


def section(rows: Rows, images: Path) -> str:
    """Return one line per task: all bodies and seeds together, with the bodies that are short of something."""
    groups: dict[str, dict[str, Row]] = {}
    for key, row in rows.items():
        groups.setdefault(key.split("/")[0], {})[key.partition("/")[2]] = row
    lines: list[list[str]] = []
    for task, runs in groups.items():
        found = list(runs.values())
        short = ", ".join(key.replace("/", " seed ") for key, row in runs.items() if not row["ok"])
        met = f"{sum(row['ok'] for row in found)} of {len(found)}"
        seconds = f"{mean(found, 'cpu'):.1f}"
        lines.append([task.replace("_", " "), str(found[0]["assets"]), met, *shares(found), seconds, short or "-"])
    heads = ["task", "assets", "all demands met", *HEADS, "CPU s", "not all met for"]
    intro = (
        "Each for the disc of 0.30 m, a wheelchair user, and the body that the task names, if it names one; up to three "
        "seeds. Reachable and usable count what no layout brings within reach, too.\n"
    )
    return f"## The tasks\n\n{intro}\n{table(heads, lines)}"
