"""docs/benchmarks.md, from the results on disk."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path

from benchmarks.examples import ROOT
from benchmarks.tables import Rows
from robolayout._files import write_atomic

RESULTS = ROOT / "benchmarks" / "results"
PAGE = ROOT / "docs" / "benchmarks.md"


def write(results: Path, target: Path, sections: Mapping[str, Callable[[Rows, Path], str]]) -> None:
    """Write the page and its plots from whatever results there are."""
    parts = [
        "# Benchmarks\n\nWritten by `python -m benchmarks` (`make bench`) from `benchmarks/results/`; do not edit. "
        "Shares are means; what they mean is on the page about [the report](report.md).\n"
        "Each section is measured on its own and may be older than the last change of the code: "
        "the history of its file in `benchmarks/results/` tells, and `--fresh` measures it again.\n"
    ]
    for name, section in sections.items():
        file = results / f"{name}.json"
        if file.exists():
            data = json.loads(file.read_text(encoding="utf-8"))
            parts += [
                section(data["rows"], target.parent / "images"),
                f"*{data['machine']}, version {data['version']}.*\n",
            ]
        else:
            parts.append(f"*Section {name!r} has not been measured: `python -m benchmarks --section {name}`.*\n")
    write_atomic(target, "\n".join(parts))
