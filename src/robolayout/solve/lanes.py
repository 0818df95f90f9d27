"""Runs of several programs in shared batches: every batch has a few lanes, and each lane holds a few starts of one program."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

from robolayout.solve import programs
from robolayout.solve.arrays import Arrays, Found, Losses, Routes
from robolayout.solve.config import SearchConfig, SolverConfig, Weights
from robolayout.solve.runner import PROCESSORS, STILL, Piece, Runner, Singles, filled, noise, schedule_of
from robolayout.solve.stage import Stage, no_routes

PROGRAM = "search_many:advance_many"
"""What all lanes run."""

LANES, STARTS = 4, 2
"""Lanes of one compiled batch and starts in a lane; together as many starts as a batch of one program has."""

Lane = tuple[Singles, Arrays, Routes, Singles]
"""Variables, arrays, routes and noise of a few starts of one program."""


@dataclass(frozen=True, eq=False)
class Request:
    """What one program asks to be run."""

    phase: SearchConfig  # how the search goes
    label: str  # name of the phase
    lanes: tuple[Lane, ...]  # its starts


Send = Callable[[Request], list[Found]]
"""Runs a request and returns what each lane left."""


class LaneRunner(Runner):
    """Runs phases in lanes, wherever these are run, and keeps the record.

    Args:
        config: Constants.
        send: Who runs a request.
    """

    share = STARTS

    def __init__(self, config: SolverConfig, send: Send) -> None:
        super().__init__(config)
        self.send = send

    def _results(
        self, stage: Stage, pieces: Sequence[Piece], phase: SearchConfig, label: str, rng: np.random.Generator | None
    ) -> list[Found]:
        """Run pieces as lanes, wherever these are run."""
        lanes = tuple(_lane(stage, piece, rng) for piece in pieces)
        return self.send(Request(phase, label, lanes))


def run_together(requests: Sequence[Request], weights: Weights) -> list[list[Found]]:
    """Run requests, lanes of one size and phase in one batch, batches side by side; return what each lane left."""
    lanes = [(request.phase, lane) for request in requests for lane in request.lanes]
    alike: dict[Any, list[int]] = {}
    for i, (phase, lane) in enumerate(lanes):
        alike.setdefault((phase, *(leaf.shape for leaf in programs.leaves(lane))), []).append(i)
    batches = [same[begin : begin + LANES] for same in alike.values() for begin in range(0, len(same), LANES)]

    def run(batch: list[int]) -> list[Found]:
        arguments = batch_arguments([lanes[i][1] for i in batch], lanes[batch[0]][0])
        values = programs.call(PROGRAM, *arguments, weights=weights)
        return [_found([value[i] for value in values]) for i in range(len(batch))]

    if len(batches) == 1:
        results = [run(batches[0])]
    else:
        with ThreadPoolExecutor(min(len(batches), PROCESSORS)) as pool:
            results = list(pool.map(run, batches))
    found = {i: one for batch, ones in zip(batches, results, strict=True) for i, one in zip(batch, ones, strict=True)}
    ends = np.cumsum([len(request.lanes) for request in requests])
    return [[found[i] for i in range(end - len(r.lanes), end)] for r, end in zip(requests, ends, strict=True)]


def batch_arguments(lanes: Sequence[Lane], phase: SearchConfig) -> tuple[Any, ...]:
    """Return what the program takes for some lanes, filled up by repeating the last one."""
    columns = [programs.leaves(lanes[min(i, len(lanes) - 1)]) for i in range(LANES)]
    stacked = [np.stack(leaves) for leaves in zip(*columns, strict=True)]
    local, arrays, routes, noise = programs.rebuilt(lanes[0], stacked)
    return local, arrays, routes, schedule_of(phase), noise


def prepare(stage: Stage, weights: Weights) -> None:
    """Start to load or compile, in the background, what runs lanes of this size."""
    lane = _lane(stage, (stage.problem.start[None], lambda: no_routes(1, 8 * stage.slots)), None)
    programs.prepare(PROGRAM, *batch_arguments([lane], STILL), weights=weights)


def _lane(stage: Stage, piece: Piece, rng: np.random.Generator | None) -> Lane:
    """Return a few starts of a stage, filled up by repeating the last one."""
    local, routes = filled(stage, piece, STARTS)
    return local, stage.arrays, routes, noise(stage, STARTS, rng)


def _found(values: list[Any]) -> Found:
    local, world, *terms, history, shots = values
    return Found(local, world, Losses(*terms), history, shots)
