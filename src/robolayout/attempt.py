"""One program and what came of it, and the clock of a run."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass

from robolayout.program import Program, Reconciled
from robolayout.solve import Solution

Progress = Callable[[str], None]
"""Told the name of each phase as it begins."""


@dataclass(frozen=True)
class Attempt:
    """One program and what came of it.

    Attributes:
        asked: The program as the planner wrote it.
        reconciled: The same after the filter.
        solution: What the solver made of it.
    """

    asked: Program
    reconciled: Reconciled
    solution: Solution


class Clock:
    """Collects wall and CPU seconds by station."""

    def __init__(self) -> None:
        self.seconds: dict[str, dict[str, float]] = {}

    @contextmanager
    def station(self, name: str) -> Generator[None]:
        """Add the seconds of a block to a station."""
        wall, cpu = time.perf_counter(), time.process_time()
        try:
            yield
        finally:
            spent = self.seconds.setdefault(name, {"wall": 0.0, "cpu": 0.0})
            spent["wall"] += time.perf_counter() - wall
            spent["cpu"] += time.process_time() - cpu
