"""One program and what came of it, the record of several searches as one, and the clock of a run."""

from __future__ import annotations

import time
from collections.abc import Callable, Generator, Iterable, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace

from robolayout.program import Program, Reconciled
from robolayout.scene import Snapshot, Trace
from robolayout.solve import Solution

Progress = Callable[[str], None]  # told the name of each phase as it begins


@dataclass(frozen=True)
class Attempt:
    """One program and what came of it."""

    asked: Program  # the program as the planner wrote it
    reconciled: Reconciled  # the same after the filter
    solution: Solution  # what the solver made of it


def joined_traces(traces: Iterable[Trace]) -> Trace:
    """Return the record of searches that followed each other."""
    losses: list[Mapping[str, float]] = []
    snapshots: list[Snapshot] = []
    for trace in traces:
        snapshots += [replace(snapshot, step=snapshot.step + len(losses)) for snapshot in trace.snapshots]
        losses += trace.losses
    return Trace(tuple(losses), tuple(snapshots))


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
