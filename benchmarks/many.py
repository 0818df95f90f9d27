"""Many rooms: how fast with 1, 2 and 4 processes and on a local Ray cluster, side by side, and what a set of them is like."""

from __future__ import annotations

import csv
import statistics
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from benchmarks.store import Row
from robolayout.many import batch
from robolayout.many.dataset import STATIONS

KINDS = (
    "bedroom",
    "living room",
    "kitchen",
    "bathroom",
    "office",
    "dining room",
    "classroom",
    "cafe",
    "shop",
    "library",
)
SPEC = {
    "rooms": KINDS,
    "bodies": ["adult", "wheelchair", "stretch3", "robot_vacuum", "child_6", "turtlebot4"],
    "seed": 7,
}
WORKERS = {"1 process": (1, None), "2 processes": (2, None), "4 processes": (4, None), "Ray, 2 tasks": (2, "local")}
ROOMS, ENOUGH = 20, 1000
"""Rooms of a set whose making is timed, and of the set whose memory and variety are looked at."""


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield the ways to make one small set, then a large one."""
    for name, (workers, cluster) in list(WORKERS.items())[: 1 if quick else None]:
        yield f"workers/{name}", partial(made, 4 if quick else ROOMS, workers, cluster)
    if not quick:
        yield "large/2 processes", partial(made, ENOUGH, 2, None)


def made(count: int, workers: int, cluster: str | None) -> Row:
    """Make a set and return how long that took, by the clock and in CPU seconds of the rooms, and what it is like."""
    with tempfile.TemporaryDirectory() as folder:
        since = time.perf_counter()
        found = batch({**SPEC, "count": count}, folder, workers=workers, cluster=cluster)
        wall = time.perf_counter() - since
        with Path(folder, "timing.csv").open(encoding="utf-8") as file:
            return summary(list(csv.DictReader(file))) | {
                "rooms": count,
                "wall": wall,
                "met": found.met,
                "missing": len(found.missing),
                "near": found.replaced.get("near-duplicate of room #", 0),
                "least": found.least,
                "mb": sum(path.stat().st_size for path in Path(folder).rglob("*") if path.is_file()) / 1e6,
            }


def summary(times: list[dict[str, str]]) -> Row:
    """Return what `timing.csv` says: CPU seconds a room by station, memory of the first and the last hundred tries."""
    rooms = len({row["room"] for row in times})
    row: Row = {name: sum(float(one[name]) for one in times) / rooms for name in STATIONS}
    row["cpu"] = row["draw"] + row["generate"] + row["write"]
    memory = [float(one["memory_mb"]) for one in times]
    return row | {"first": statistics.fmean(memory[:100]), "last": statistics.fmean(memory[-100:]), "tries": len(times)}
