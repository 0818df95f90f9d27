"""Kills a batch at steps that change a disk, each time in a process of its own, and lets the same call go on.

Called as `python killed.py BASE TIMES`: BASE/whole is the undisturbed set, BASE/<step> one that was killed at that step and
gone on with. Rooms are made once, for real, and handed out again, so that what is tried is what keeps them. The number of all
steps is printed.
"""

from __future__ import annotations

import os
import random
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parents[1]))

import pyarrow

from robolayout.many import batch, dataset, read_spec
from robolayout.many.room import Made, make
from robolayout.many.workers import Task
from robolayout.run import folder
from stopped import Step, told
from tiny_sets import tiny_spec

SEED, ROOMS = 0, 5


class Again:
    """Hands out rooms that are made once."""

    slots = 2

    def __init__(self, ready: Any, *_: Any) -> None:
        self.ready, self.tasks = ready, list[Task]()

    def send(self, task: Task) -> None:
        self.tasks.append(task)

    def done(self) -> Iterator[tuple[Task, Made]]:
        task = self.tasks.pop()
        yield task, made(task)

    def close(self) -> None: ...


def main(base: Path, times: int) -> None:
    """Count the steps of a whole run, then stop so many runs at steps that a seed chooses."""
    os.fsync = lambda descriptor: None  # a process that ends takes nothing with it that the system has
    folder.exchange = told
    dataset.Local = Again  # type: ignore[assignment, misc]
    pyarrow.set_cpu_count(1)
    table = tiny_spec(base, count=ROOMS, tries=2)
    steps = ran(base / "whole", table, 10**9)
    for step in sorted(random.Random(SEED).sample(range(1, steps), times)):
        assert ran(base / str(step), table, step) is None, "it was to be killed"
        assert ran(base / str(step), table, 10**9) is not None
    sys.stdout.write(f"{steps}\n")


@cache
def made(task: Task) -> Made:
    """Return a room; two of the five are alike, so that one is replaced."""
    found = make(READY[0], task.index, task.attempt)
    alike = (("desk", 0.0, 0.0, 0.0),) if task in (Task(0, 0), Task(3, 0)) else found.things
    return Made(found.why, found.row, alike, found.files)


READY: list[Any] = []


def ran(out: Path, table: dict[str, Any], step: int) -> int | None:
    """Run a batch in a process that ends at a step, and return how many steps it took; None if it was killed."""
    if not READY:
        READY.append(read_spec(table))
        for index in range(ROOMS):
            made(Task(index, 0)), made(Task(index, 1))
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        counter = Step(step, "kill")
        sys.addaudithook(counter)
        batch(READY[0], out)
        os.write(writing, str(step - counter.left).encode())
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as pipe:
        text = pipe.read()
    os.waitpid(child, 0)
    return int(text) if text else None


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]))
