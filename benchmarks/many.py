"""Many rooms: how fast with 1, 2 and 4 processes and on a local Ray cluster, side by side, and what a set of them is like.

python -m benchmarks --section many --case workers    24 rooms each way, side by side
python -m benchmarks --section many --case large      1,000 rooms in out/many; the same command goes on where it stopped
"""

from __future__ import annotations

import csv
import re
import statistics
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

from benchmarks.examples import ROOT
from benchmarks.store import Row
from benchmarks.tables import Rows, table
from robolayout.many import batch
from robolayout.many.dataset import STATIONS

KINDS = [
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
]
BODIES = ["adult", "wheelchair", "stretch3", "robot_vacuum", "child_6", "turtlebot4"]
SPEC = {"rooms": KINDS, "bodies": BODIES, "seed": 7}
WORKERS = {"1 process": (1, None), "2 processes": (2, None), "4 processes": (4, None), "Ray, 2 tasks": (2, "local")}
ROOMS, ENOUGH = 24, 1000
"""Rooms of a set whose making is timed, and of the set whose memory and variety are looked at."""
LARGE = ROOT / "out" / "many"
"""Where the large set is made; remove it to measure other code."""


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield the ways to make one small set, then a large one."""
    for name, (workers, cluster) in list(WORKERS.items())[: 1 if quick else None]:
        yield f"workers/{name}", partial(timed, 4 if quick else ROOMS, workers, cluster)
    if not quick:
        yield "large/2 processes", partial(made, LARGE, ENOUGH, 2)


def timed(count: int, workers: int, cluster: str | None) -> Row:
    """Make a set that is thrown away, and return how long that took by the clock and what it is like."""
    with tempfile.TemporaryDirectory() as folder:
        since = time.perf_counter()
        row = made(Path(folder), count, workers, cluster)
        return row | {"wall": time.perf_counter() - since}


def made(folder: Path, count: int, workers: int, cluster: str | None = None) -> Row:
    """Make a set, or go on with it, and return what it is like."""
    found = batch({**SPEC, "count": count}, folder, workers=workers, cluster=cluster)
    with (folder / "timing.csv").open(encoding="utf-8") as file:
        row = summary(list(csv.DictReader(file)))
    sizes = [path.stat().st_size for path in folder.rglob("*") if path.is_file()]
    near = found.replaced.get("near-duplicate of room #", 0)
    row |= {"rooms": count, "met": found.met, "missing": len(found.missing), "near": near, "least": found.least}
    return row | {"mb": sum(sizes) / 1e6, "files": len(sizes)}


def summary(times: list[dict[str, str]]) -> Row:
    """Return what `timing.csv` says: CPU seconds a room by station, memory of the first and the last hundred tries."""
    rooms = len({row["room"] for row in times})
    row: Row = {name: sum(float(one[name]) for one in times) / rooms for name in STATIONS}
    row["cpu"] = row["draw"] + row["generate"] + row["write"]
    laid_out = sorted(float(one["generate"]) for one in times)
    row |= {"median": statistics.median(laid_out), "tenth": laid_out[int(0.9 * len(laid_out))], "longest": laid_out[-1]}
    memory = [float(one["memory_mb"]) for one in times]
    return row | {"first": statistics.fmean(memory[:100]), "last": statistics.fmean(memory[-100:]), "tries": len(times)}


def section(rows: Rows, images: Path) -> str:
    """Return the table of how fast rooms are made side by side, and what a large set is like."""
    side = {key.partition("/")[2]: row for key, row in rows.items() if key.startswith("workers/")}
    alone = side.get("1 process")
    lines: list[list[str]] = []
    for name, row in side.items():
        rate = 60 * row["rooms"] / row["wall"]
        count = int(re.findall(r"\d+", name)[0])
        share = f"{rate / (count * 60 * alone['rooms'] / alone['wall']):.0%}" if alone else "-"
        cells = [f"{rate:.0f}", f"{60 / row['cpu']:.0f}", share, f"{row['cpu']:.2f}"]
        lines.append([name, str(row["rooms"]), *cells, *(f"{row[part]:.2f}" for part in ("draw", "generate", "write"))])
    heads = ["workers", "rooms", "rooms a minute", "a minute and core", "efficiency"]
    heads += ["CPU s a room", "drawing", "laying out", "writing"]
    parts = [
        "## Many rooms\n\nMixed rooms of ten kinds for six bodies, without pictures; start of the workers included.\n"
    ]
    parts.append(table(heads, lines))
    for key, row in rows.items():
        if key.startswith("large/"):
            near, memory = row["near"] / row["tries"], f"{row['first']:.0f} and {row['last']:.0f} MB"
            stations = {"drawing": ("draw",), "planning": ("plan", "program"), "solving": ("solve",)}
            stations |= {"judging": ("verify",), "writing": ("write",)}
            spent = ", ".join(f"{name} {sum(row[part] for part in found):.2f}" for name, found in stations.items())
            parts.append(
                f"{row['rooms']} rooms with {key.partition('/')[2]}: {row['met']} meet all demands, {row['missing']} were given up; "
                f"{row['tries'] - row['rooms']} tries were replaced, {near:.1%} of all as near-duplicates, and none is left (least "
                f"difference {row['least']:.2f}); {row['cpu']:.2f} CPU s a room ({spent}), {60 / row['cpu']:.0f} rooms a minute and core; "
                f"one room is laid out in {row['median']:.1f} s (median), nine of ten within {row['tenth']:.1f} s, the longest took "
                f"{row['longest']:.0f} s; memory of a process over the first and the last hundred {memory}; "
                f"{1000 * row['mb'] / row['rooms']:.0f} kB in {row['files'] / row['rooms']:.0f} files a room.\n"
            )
    return "\n".join(parts)
