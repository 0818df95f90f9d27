"""Runs the compiled search and keeps the record of it."""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import astuple
from typing import Any, NamedTuple

import numpy as np

from robolayout.floor import RoutePlan
from robolayout.scene import Scene, Snapshot, Trace
from robolayout.solve import programs
from robolayout.solve.arrays import HISTORY, SNAPSHOTS, Losses, hard_part
from robolayout.solve.compile import Floats
from robolayout.solve.config import SearchConfig, SolverConfig
from robolayout.solve.solution import snapshot
from robolayout.solve.stage import Stage, no_routes, sizes_of

STILL = SearchConfig(steps=0, rate=0.0, final_rate=0.0)
"""A phase without a step: only the objective is evaluated."""

PROGRAM = "search:advance"
"""What all phases run."""

PROCESSORS = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
"""Processors that this process may use."""

BATCH = 4
"""Starts that run at once; more run in several batches side by side, so that one compiled program serves them all."""


class SearchRun(NamedTuple):
    """What one run of the search left."""

    world: Floats  # (K, n, 4) poses
    energy: Floats  # (K,) objective at full weights
    hard: Floats  # (K,) hard part of it

    def joined(self, other: SearchRun) -> SearchRun:
        """Return both runs as one."""
        return SearchRun(*map(np.concatenate, zip(self, other, strict=True)))

    def ranked(self) -> Floats:
        """Return the poses (K, n, 4), best first."""
        return self.best(len(self.world)).world

    def best(self, count: int) -> SearchRun:
        """Return its best starts, best first: hard part to 1e-3, then the whole."""
        first = np.lexsort((self.energy, np.round(self.hard, 3)))[:count]
        return SearchRun(*(field[first] for field in self))


class Runner:
    """Calls the compiled search with a configuration and records what happened."""

    def __init__(self, config: SolverConfig) -> None:
        self.config = config
        self._losses: list[dict[str, float]] = []
        self._shots: list[Snapshot] = []

    def advance(
        self,
        stage: Stage,
        world: Floats,
        phase: SearchConfig,
        label: str,
        *,
        plans: Sequence[RoutePlan] = (),
    ) -> SearchRun:
        """Run one phase from world poses (K, n, 4), in batches side by side; `plans` are the routes of each."""

        def run(part: slice) -> list[Any]:
            arguments = _arguments(stage, world[part], phase, plans[part])
            return programs.call(PROGRAM, *arguments, weights=self.config.weights)

        parts = [slice(begin, begin + BATCH) for begin in range(0, len(world), BATCH)]
        with ThreadPoolExecutor(PROCESSORS) as pool:
            results = list(pool.map(run, parts))
        runs = [self._run(stage, world[part], *found[1:-2]) for part, found in zip(parts, results, strict=True)]
        if self.config.trace and label:
            self._record(stage, label, phase.steps, *results[0][-2:])
        return SearchRun(*map(np.concatenate, zip(*runs, strict=True)))

    def _run(self, stage: Stage, world: Floats, after: Floats, *parts: Floats) -> SearchRun:
        """Return what became of a batch, headings of exact length 1; what the stage does not move or carry stays bit for bit."""
        result, count = world.copy(), len(world)
        moved = sorted({*np.flatnonzero(stage.arrays.carrier >= 0).tolist(), *stage.moving})
        result[:, moved] = after[:count, moved]
        result[..., 2:] /= np.hypot(result[..., 2], result[..., 3])[..., None]
        losses = Losses(*(part[:count].astype(np.float64) for part in parts))
        hard = hard_part(losses, self.config.weights)
        return SearchRun(result, hard + losses.statements, hard)

    def _record(self, stage: Stage, label: str, steps: int, history: Floats, shots: Floats) -> None:
        """Keep the losses of the best start of a batch, and its poses at 20 moments; at one where nothing moved."""
        begin, weights, problem = len(self._losses), self.config.weights, stage.problem
        factors = (weights.overlap, weights.inside, weights.clear, 1.0, weights.routes)
        for row in history[: min(max(steps, 1), HISTORY)]:
            terms = {name: float(value) * f for name, value, f in zip(Losses._fields, row, factors, strict=True)}
            self._losses.append(terms | {"total": sum(terms.values())})
        for i in range(0, SNAPSHOTS if steps else 1, SNAPSHOTS // 20):
            layout = problem.layout(shots[i, : len(problem.names)])
            self._shots.append(snapshot(begin + i * steps // SNAPSHOTS, label, layout))

    def trace(self) -> Trace:
        """Return the record of all runs."""
        return Trace(tuple(self._losses), tuple(self._shots))


def _arguments(stage: Stage, world: Floats, phase: SearchConfig, plans: Sequence[RoutePlan] = ()) -> tuple[Any, ...]:
    """Return what the program takes for one batch, filled up by repeating the last start; of too many demands an even choice."""
    fill, size = np.minimum(np.arange(BATCH), len(world) - 1), 8 * stage.slots
    routes = no_routes(BATCH, size)
    for start, k in zip(routes, fill if plans else [], strict=False):
        rows = plans[k].demands
        chosen = np.linspace(0, len(rows) - 1, size).astype(int) if len(rows) > size else slice(None)
        start[: len(rows)] = rows[chosen]
    return stage.local(world[fill]).astype(np.float32), stage.arrays, routes, np.array(astuple(phase), np.float32)


def warm_up(scene: Scene, config: SolverConfig | None = None, *, missing_only: bool = False) -> None:
    """Start to load or compile in the background what solving a scene will need; `missing_only` leaves the cache alone."""
    if scene.assets:
        stage, weights = sizes_of(scene), (config or SolverConfig()).weights
        arguments = _arguments(stage, stage.world[None], STILL)
        known = programs.programs()
        prepare = known.compile_missing if missing_only else known.future
        prepare(PROGRAM, arguments, {"weights": weights})
