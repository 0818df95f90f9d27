"""`python -m benchmarks [--section NAME] [--case TEXT] [--quick] [--fresh] [--page]`: measure, and write the page.

Every case is saved when it is measured; a second call goes on where the first one stopped.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Callable, Mapping
from pathlib import Path

from benchmarks import (
    ablation,
    bodies,
    crowded,
    dressed,
    examples,
    exports,
    fuzz,
    laws,
    lists,
    many,
    opening,
    page,
    paper,
    pictures,
    rough,
    shapes,
    simulated,
    speed,
    tasks,
    vlm,
    words,
)
from benchmarks.store import Row, Store

MODULES = (
    examples,
    bodies,
    tasks,
    speed,
    crowded,
    shapes,
    ablation,
    rough,
    laws,
    paper,
    many,
    vlm,
    pictures,
    exports,
    simulated,
    dressed,
    opening,
    fuzz,
    words,
    lists,
)
SECTIONS = {module.__name__.rpartition(".")[2]: module for module in MODULES}
"""Each has `cases`, what it measures, and `section`, its part of the page; in the order of the page."""


def main() -> None:
    """Run the sections asked for and write the page."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__.splitlines()[0])
    parser.add_argument("--section", action="append", choices=sorted(SECTIONS), help="only this one; may be repeated")
    parser.add_argument("--case", default="", help="only cases whose names hold this")
    parser.add_argument("--quick", action="store_true", help="a few small cases, kept apart from the real results")
    parser.add_argument("--fresh", action="store_true", help="measure again what is there already")
    parser.add_argument("--page", action="store_true", help="only write the page from the results that are there")
    given = parser.parse_args()
    results = Path(tempfile.gettempdir(), "robolayout-bench-quick") if given.quick else page.RESULTS
    if not given.page:
        for name in given.section or SECTIONS:
            cases = {key: run for key, run in SECTIONS[name].cases(given.quick) if given.case in key}
            measure(name, cases, Store(results / f"{name}.json"), fresh=given.fresh)
    target = results / "benchmarks.md" if given.quick else page.PAGE
    page.write(results, target, {name: module.section for name, module in SECTIONS.items()})
    sys.stdout.write(f"{target}\n")


def measure(name: str, cases: Mapping[str, Callable[[], Row]], store: Store, *, fresh: bool) -> None:
    """Measure every case of a section that has no result yet."""
    for key, run in cases.items():
        if key in store.rows and not fresh:
            continue
        wall, cpu = time.perf_counter(), time.process_time()
        store.save(key, run())
        spent = f"{time.perf_counter() - wall:6.1f} s, {time.process_time() - cpu:6.1f} s CPU"
        sys.stdout.write(f"{name:9} {key:44} {spent}\n")
        sys.stdout.flush()


if __name__ == "__main__":
    os.environ.setdefault("JAX_PLATFORMS", "cpu")
    main()
