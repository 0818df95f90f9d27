"""Results on disk: one JSON file per section, one row per case, written after every case."""

from __future__ import annotations

import json
import os
import platform
from pathlib import Path
from typing import Any

from robolayout import __version__
from robolayout._files import write_atomic

Row = dict[str, Any]
"""Figures of one case by name."""


class Store:
    """The rows of one section.

    Args:
        path: Its file.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.rows: dict[str, Row] = {}
        if path.exists():
            self.rows = json.loads(path.read_text(encoding="utf-8"))["rows"]

    def save(self, key: str, row: Row) -> None:
        """Keep a row, its figures rounded to five digits."""
        self.rows[key] = {name: _short(value) for name, value in row.items()}
        machine = f"{os.cpu_count()} cores ({platform.machine()}), Python {platform.python_version()}"
        lines = [f"  {json.dumps(k)}: {json.dumps(v)}" for k, v in sorted(self.rows.items())]
        head = f'{{"version": {json.dumps(__version__)}, "machine": {json.dumps(machine)}, "rows": {{\n'
        write_atomic(self.path, head + ",\n".join(lines) + "\n}}\n")


def _short(value: Any) -> Any:
    return float(f"{value:.5g}") if isinstance(value, float) else value
