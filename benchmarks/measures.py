"""One measured run: figures of the report and the seconds that it took."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import robolayout as rl
from benchmarks.store import Row
from benchmarks.triangles import penetrations

HARD = ("placed_share", "collision_free_share", "in_boundary_share", "supported_share", "door_clear")
SHARES = (*HARD, "walkable_ratio", "reachable_share", "usable_share", "statements_met_share")


@dataclass
class Watch:
    """Seconds of a block.

    Attributes:
        wall: Of the clock.
        cpu: Of this process, all threads.
    """

    wall: float = 0.0
    cpu: float = 0.0


@contextmanager
def watch() -> Iterator[Watch]:
    """Time a block."""
    spent = Watch()
    wall, cpu = time.perf_counter(), time.process_time()
    yield spent
    spent.wall, spent.cpu = time.perf_counter() - wall, time.process_time() - cpu


def figures(report: rl.Report) -> Row:
    """Return the shares of a report, whether everything is met, and how much is impossible or not asked."""
    found = report.figures | {"reachable_share": report.figures["reachable_share_chairs_aside"]}  # what is demanded
    row: Row = {name: float(found[name]) for name in SHARES}
    asked = [(body, set(body.exempt)) for body in report.agents]
    return row | {
        "hard_ok": all(row[name] == 1.0 for name in HARD),
        "ok": report.ok,
        "short": sum(len(body.short) for body, _ in asked),
        "exempt": sum(len(names) for _, names in asked),
        "impossible": sum(len(body.impossible) for body, _ in asked),
    }


def generated(scene: Any, **options: Any) -> Row:
    """Generate once and return figures, things whose parts go through each other, and seconds, in all and by station."""
    with watch() as spent:
        result = rl.generate(scene, **options)
    through = penetrations(result.scene, result.layout)
    row = figures(result.report) | {"through": len(through)}
    row |= {"wall": spent.wall, "cpu": spent.cpu, "assets": len(result.scene.assets)}
    for station, seconds in result.report.timing.items():
        row |= {f"{station}_{kind}": value for kind, value in seconds.items()}
    return row


def warmed(scene: Any, **options: Any) -> tuple[rl.Result, Row]:
    """Generate once to load everything and once to measure; return the result with figures, statements met and seconds."""
    rl.generate(scene, **options)
    with watch() as spent:
        result = rl.generate(scene, **options)
    met = [item.met for item in result.report.statements]
    row = figures(result.report) | {"met": sum(met), "asked": len(met), "wall": spent.wall, "cpu": spent.cpu}
    return result, row
