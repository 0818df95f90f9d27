"""What tests at the top share: the command line as a function, and what one run of it left."""

from __future__ import annotations

import sys
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from io import StringIO
from pathlib import Path
from typing import Any
from unittest.mock import patch

import pytest

ROOT = Path(__file__).parents[1]


def slow(*values: object) -> Any:
    """Return a case that takes seconds: `make test` leaves it to `make test-all`."""
    return pytest.param(*values, marks=pytest.mark.slow)


@dataclass(frozen=True)
class Ran:
    """What a command did."""

    code: int
    out: str
    err: str


def run_command(*words: object) -> Ran:
    """Run `robolayout <words>` in this process, as its entry point does."""
    from robolayout.cli import main

    out, err = StringIO(), StringIO()
    with patch.object(sys, "argv", ["robolayout", *map(str, words)]), redirect_stdout(out), redirect_stderr(err):
        try:
            main()
            code = 0
        except SystemExit as stop:
            code = stop.code if isinstance(stop.code, int) else 1 if stop.code else 0
    return Ran(code, out.getvalue(), err.getvalue())


@dataclass(frozen=True)
class Furnished:
    """The output folder of one run of `generate` on the bedroom, and what it printed."""

    folder: Path
    scene: Path
    code: int
    printed: dict[str, Any]
