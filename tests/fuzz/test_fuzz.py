"""Whatever a file holds, its reader takes it or says in one sentence why not: never another error, a hang, or much memory.

`ROBOLAYOUT_FUZZ` sets the number of inputs (2,000); with `ROBOLAYOUT_FUZZ_OUT` the counts of a reader are written there
(`make fuzz`). The inputs are the same in every run.
"""

from __future__ import annotations

import json
import os
import resource
import shutil
import time
from pathlib import Path

import pytest
from fuzz_mutations import Choice, spoiled
from fuzz_readers import READERS, Reader
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from robolayout._errors import ProgramError, RoboLayoutError

INPUTS = int(os.environ.get("ROBOLAYOUT_FUZZ", "2000"))
WEIGHT = sum(1 / reader.cost for reader in READERS.values())
SLOWEST = 10.0
"""CPU seconds that an input may take."""
MOST_MEMORY = 1_000_000
"""Kilobytes that a process which reads files of one kind may take."""
number = st.integers(0, 2**20)
choices = st.lists(st.tuples(st.integers(0, 167), number, number, number), min_size=1, max_size=4)


@pytest.mark.parametrize("name", READERS)
def test_a_spoiled_file_is_read_or_refused_in_one_sentence(name: str, tmp_path: Path) -> None:
    reader = READERS[name]
    seeds = reader.seeds()
    counts = {"inputs": 0, "accepted": 0, "refused": 0}
    slowest = 0.0

    @settings(
        max_examples=max(5, round(INPUTS / WEIGHT / reader.cost)),
        deadline=None,
        derandomize=True,
        database=None,
        phases=(Phase.explicit, Phase.generate, Phase.shrink),
        suppress_health_check=list(HealthCheck),
    )
    @given(st.integers(0, len(seeds) - 1), choices)
    def fuzz(seed: int, made: list[Choice]) -> None:
        nonlocal slowest
        spent = time.process_time()
        taken = read(reader, spoiled(seeds[seed], reader.write, made), tmp_path)
        spent = time.process_time() - spent
        assert spent < SLOWEST
        slowest = max(slowest, spent)
        counts["inputs"] += 1
        counts["accepted" if taken else "refused"] += 1

    fuzz()
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    if out := os.environ.get("ROBOLAYOUT_FUZZ_OUT"):
        assert memory < MOST_MEMORY
        Path(out).write_text(json.dumps({**counts, "slowest": slowest, "memory_mb": memory / 1000}))


@pytest.mark.parametrize("name", READERS)
def test_a_good_file_is_read(name: str, tmp_path: Path) -> None:
    reader = READERS[name]
    for seed in reader.seeds():
        assert read(reader, seed if reader.write is None else reader.write(seed), tmp_path)


def read(reader: Reader, data: bytes, folder: Path) -> bool:
    """Return whether the reader took a file; a refusal is one sentence on one line (a program's also shows the line)."""
    place = folder / "in" / "uid"
    place.mkdir(parents=True)
    path = place / f"file{reader.suffix}"
    path.write_bytes(data)
    try:
        reader.read(path)
    except ProgramError as error:
        assert str(error).strip() and len(str(error).splitlines()) <= 3
        return False
    except RoboLayoutError as error:
        text = str(error)
        assert text.strip() and len(text.splitlines()) == 1, text
        assert text.isprintable() and len(text) < 4000, text
        return False
    finally:
        shutil.rmtree(folder / "in")
    return True
