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
