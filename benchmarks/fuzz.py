"""What readers make of spoiled files: how many they take and refuse, the slowest, and the memory (tests/fuzz)."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path

from benchmarks.examples import ROOT
from benchmarks.store import Row
from benchmarks.tables import Rows, table

INPUTS = 100_000
"""Spoiled files for all readers together, unless `ROBOLAYOUT_FUZZ` says otherwise."""
QUICK = 500
TESTS = ROOT / "tests" / "fuzz"


def cases(quick: bool) -> Iterator[tuple[str, Callable[[], Row]]]:
    """Yield one case a reader."""
    sys.path[:0] = [str(TESTS), str(TESTS.parent)]
    from fuzz_readers import READERS

    for name in READERS:
        yield name, lambda name=name: _row(name, quick)


def _row(name: str, quick: bool) -> Row:
    """Fuzz one reader in a process of its own; a defect ends the benchmark with the test's words."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "row.json"
        count = QUICK if quick else os.environ.get("ROBOLAYOUT_FUZZ", INPUTS)
        environment = {
            **os.environ,
            "ROBOLAYOUT_FUZZ": str(count),
            "ROBOLAYOUT_FUZZ_OUT": str(out),
            "OMP_NUM_THREADS": "1",
        }
        test = f"{TESTS / 'test_fuzz.py'}::test_a_spoiled_file_is_read_or_refused_in_one_sentence[{name}]"
        subprocess.run([sys.executable, "-m", "pytest", "-q", test], env=environment, cwd=ROOT, check=True)
        return json.loads(out.read_text(encoding="utf-8"))


def section(rows: Rows, images: Path) -> str:
    """Return what each reader made of spoiled files."""
    lines = [
        [
            name,
            *(str(row[key]) for key in ("inputs", "accepted", "refused")),
            f"{1000 * row['slowest']:.0f} ms",
            f"{row['memory_mb']:.0f} MB",
        ]
        for name, row in sorted(rows.items())
    ]
    total = [str(sum(row[key] for row in rows.values())) for key in ("inputs", "accepted", "refused")]
    worst = max(row["slowest"] for row in rows.values()), max(row["memory_mb"] for row in rows.values())
    lines.append(["all", *total, f"{1000 * worst[0]:.0f} ms", f"{worst[1]:.0f} MB"])
    heads = ["reader", "inputs", "accepted", "refused in a sentence", "slowest (CPU)", "memory of the process"]
    intro = (
        "Good files of every kind with values, types, names, nesting, numbers and bytes spoiled, the same in every run "
        "(`tests/fuzz`, `make fuzz`). Each is read or refused in one sentence; another error, 10 s or 1 GB would end the "
        "measurement.\n"
    )
    return f"## Spoiled files\n\n{intro}\n{table(heads, lines)}"
