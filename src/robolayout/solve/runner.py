"""Runs the compiled search and keeps the record of it."""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

import numpy as np

from robolayout.floor import Plan
from robolayout.scene import Scene, Trace
from robolayout.solve import programs
from robolayout.solve.arrays import HISTORY, SNAPSHOTS, Found, Losses, Routes, Schedule
from robolayout.solve.compile import Floats, Problem
from robolayout.solve.config import SearchConfig, SolverConfig
from robolayout.solve.solution import snapshot
from robolayout.solve.stage import Stage, no_routes, sizes_of
from robolayout.solve.terms import hard_part

STILL = SearchConfig(steps=0, rate=0.0, final_rate=0.0)
"""A phase without a step: only the objective is evaluated."""

PROGRAM = "search:advance"
"""What all phases run."""

PROCESSORS = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
"""Processors that this process may use."""

BATCH = 4
"""Starts that run at once; more run in several batches side by side, so that one compiled program serves them all."""


class Run(NamedTuple):
    """What one run of the search left."""

    world: Floats  # (K, n, 4) poses
    energy: Floats  # (K,) objective at full weights
    hard: Floats  # (K,) hard part of it

    def joined(self, other: Run) -> Run:
        """Return both runs as one."""
        return Run(*map(np.concatenate, zip(self, other, strict=True)))

    def ranked(self) -> Floats:
        """Return the poses (K, n, 4), best first."""
        return self.world[self.order()]

    def best(self, count: int) -> Run:
        """Return its best starts, best first."""
        first = self.order()[:count]
        return Run(*(field[first] for field in self))

    def order(self) -> list[int]:
        """Return the starts, best first: hard part to 1e-3, then the whole."""
        return [int(k) for k in np.lexsort((self.energy, np.round(self.hard, 3)))]


class Runner:
    """Calls the compiled search with a configuration and records what happened."""

    def __init__(self, config: SolverConfig) -> None:
        self.config = config
        self._losses: list[dict[str, float]] = []
        self._shots: list[tuple[int, str, Floats]] = []

    def advance(
        self,
        stage: Stage,
        world: Floats,
        phase: SearchConfig,
        label: str,
        *,
        plans: Sequence[Plan] = (),
    ) -> Run:
        """Run one phase from world poses (K, n, 4), in batches side by side; `plans` are the routes of each."""

        def run(part: slice) -> Found:
            arguments = _arguments(stage, world[part], phase, plans[part])
            local, after, *terms, history, shots = programs.call(PROGRAM, *arguments, weights=self.config.weights)
            return Found(local, after, Losses(*terms), history, shots)

        parts = [slice(begin, begin + BATCH) for begin in range(0, len(world), BATCH)]
        with ThreadPoolExecutor(PROCESSORS) as pool:
            results = list(pool.map(run, parts))
        runs = [self._run(stage, world[part], found) for part, found in zip(parts, results, strict=True)]
        if self.config.trace and label:
            self._record(stage, label, phase.steps, results[0])
        return Run(*map(np.concatenate, zip(*runs, strict=True)))

    def _run(self, stage: Stage, world: Floats, found: Found) -> Run:
        count = len(stage.problem.names)
        result = self._settled(stage, world, np.asarray(found.world, np.float64)[: len(world), :count])
        parts = Losses(*(np.asarray(part, np.float64)[: len(world)] for part in found.losses))
        hard = hard_part(parts, self.config.weights)
        return Run(result, hard + parts.statements, hard)

    def _settled(self, stage: Stage, before: Floats, after: Floats) -> Floats:
        """Return poses with exact unit headings; what the stage does not move or carry stays bit for bit."""
        world = before.copy()
        carried = {i for i in range(after.shape[1]) if stage.arrays.carrier[i] >= 0}
        moved = sorted(carried | set(stage.moving))
        world[:, moved] = after[:, moved]
        norm = np.hypot(world[..., 2], world[..., 3])
        world[..., 2:] /= norm[..., None]
        return world

    def _record(self, stage: Stage, label: str, steps: int, found: Found) -> None:
        """Keep the losses of the best start of a batch, and its poses at 20 moments; at one where nothing moved."""
        history, shots = np.asarray(found.history), np.asarray(found.shots)[:, : len(stage.problem.names)]
        begin = len(self._losses)
        weights = self.config.weights
        factors = (weights.overlap, weights.inside, weights.clear, 1.0, weights.routes)
        for row in history[: min(max(steps, 1), HISTORY)]:
            terms = {name: float(value) * f for name, value, f in zip(Losses._fields, row, factors, strict=True)}
            self._losses.append(terms | {"total": sum(terms.values())})
        stride = max(1, SNAPSHOTS // 20)
        for i in range(0, SNAPSHOTS if steps else 1, stride):
            self._shots.append((begin + i * steps // SNAPSHOTS, label, shots[i]))

    def trace(self, problem: Problem) -> Trace:
        """Return the record of all runs."""
        shots = ((step, label, problem.layout(poses)) for step, label, poses in self._shots)
        return Trace(tuple(self._losses), tuple(snapshot(*shot) for shot in shots))


def _arguments(stage: Stage, world: Floats, phase: SearchConfig, plans: Sequence[Plan] = ()) -> tuple[Any, ...]:
    """Return what the program takes for one batch, filled up by repeating the last start."""
    fill = np.minimum(np.arange(BATCH), len(world) - 1)
    routes = _packed([plans[k] for k in fill] if plans else [], 8 * stage.slots)
    schedule = Schedule(np.int32(phase.steps), np.float32(phase.rate), np.float32(phase.final_rate))
    return stage.local(world[fill]).astype(np.float32), stage.arrays, routes, schedule


def _packed(plans: Sequence[Plan], size: int) -> Routes:
    """Return what each start of a batch demands as padded arrays of `size` rows, of more than that an even choice."""
    packed = no_routes(BATCH, size)
    for k, plan in enumerate(plans):
        rows = plan.demands
        if len(rows) > size:
            rows = rows[np.linspace(0, len(rows) - 1, size).astype(int)]
        packed.point[k, : len(rows)] = rows[:, :2]
        packed.slot[k, : len(rows)] = rows[:, 2]
        packed.need[k, : len(rows)] = rows[:, 3]
    return packed


def warm_up(scene: Scene, config: SolverConfig | None = None, *, missing_only: bool = False) -> None:
    """Start to load or compile in the background what solving a scene will need; `missing_only` leaves the cache alone."""
    if scene.assets:
        stage, weights = sizes_of(scene), (config or SolverConfig()).weights
        arguments = _arguments(stage, stage.world[None], STILL)
        programs.prepare(PROGRAM, *arguments, missing_only=missing_only, weights=weights)
