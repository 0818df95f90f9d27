"""Who makes the rooms: processes of this machine, or tasks of a Ray cluster; both run one function and know nothing of the set.

A worker that is killed, hangs or runs out of memory costs the room that it was at, which is told as `None`; another takes
its place. Never more than `slots` rooms are under way, so that what is made never waits in memory.
"""

from __future__ import annotations

import faulthandler
import logging
import os
import signal
import socket
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from importlib.util import find_spec
from multiprocessing import connection, get_context
from multiprocessing.process import BaseProcess
from pathlib import Path
from tempfile import mkdtemp
from typing import Any, cast

from robolayout._errors import InputError, MissingExtraError
from robolayout._files import write_atomic
from robolayout.many.room import Made, make
from robolayout.many.spec import Ready


@dataclass(frozen=True)
class WorkerConfig:
    """How long workers are waited for and kept."""

    ahead: int = 2  # rooms under way for each processor of a cluster: one that is made, one that waits for it
    answer: float = 10.0  # seconds in which a cluster must answer
    patience: int = 10  # seconds by the clock for each CPU second that a room may take
    # rooms after which a worker makes way for another: caches and compiled programs add some megabytes a dozen rooms
    renewed: int = 100
    tick: float = 0.2  # seconds to wait for a worker before something else is looked at
    # workers that one try at a room may cost before it counts as failed: somebody else may have ended them
    deaths: int = 5


WORKERS = WorkerConfig()


@dataclass(frozen=True)
class Task:
    """One try at a room."""

    index: int  # number of the room
    attempt: int  # number of the try


@dataclass
class _Process:
    """One worker of this machine."""

    process: BaseProcess
    pipe: connection.Connection
    task: Task | None = None
    made: int = 0  # rooms that it has made


@dataclass
class Local:
    """Processes of this machine, started afresh (nothing is forked) and kept for `WORKERS.renewed` rooms: each loads programs once."""

    ready: Ready  # what is asked for
    meshes: Path  # folder of the meshes of the catalogues
    slots: int  # number of processes
    _all: list[_Process] = field(default_factory=list[_Process])

    def send(self, task: Task) -> None:
        """Give a try to an idle process, or to a new one; the caller keeps within `slots`."""
        free = next((one for one in self._all if one.task is None), None)
        if free is None:
            context = get_context("spawn")
            here, there = context.Pipe()
            process = context.Process(target=_serve, args=(there, self.ready, self.meshes), daemon=True)
            process.start()
            there.close()
            free = _Process(process, here)
            self._all.append(free)
        free.task = task
        with suppress(OSError):  # it has ended; `done` says so
            free.pipe.send(task)

    def done(self) -> Iterator[tuple[Task, Made | None]]:
        """Yield what processes have made, and None for the tries of those that have ended; after a moment, with or without any."""
        busy = [one for one in self._all if one.task is not None]
        heard = connection.wait([*(one.pipe for one in busy), *(one.process.sentinel for one in busy)], WORKERS.tick)
        for one in busy:
            if one.pipe in heard or one.process.sentinel in heard:
                task, one.task = cast(Task, one.task), None
                try:
                    made = cast(Made, one.pipe.recv())
                except (EOFError, OSError):
                    made = None
                one.made += 1
                if made is None or one.made == WORKERS.renewed:
                    self._all.remove(one)
                    one.process.kill()
                    one.process.join()
                    one.pipe.close()
                yield task, made

    def close(self) -> None:
        """End all processes."""
        for one in self._all:
            one.process.kill()
        for one in self._all:
            one.process.join()
            one.pipe.close()
        self._all.clear()


def _serve(pipe: connection.Connection, ready: Ready, meshes: Path) -> None:
    """Make what is asked for until the other end is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # an interrupt is for the process that gives the orders
    with suppress(EOFError, OSError):
        while True:
            task = cast(Task, pipe.recv())
            pipe.send(bounded(ready, task, meshes))


def bounded(ready: Ready, task: Task, meshes: Path) -> Made:
    """Return one try at a room, made within bounds of time and memory; the process ends where it takes too long.

    Time is counted in CPU seconds, lest a busy machine lose rooms; one that only waits has `WORKERS.patience` times as long.
    """
    with suppress(ImportError, AttributeError, ValueError, OSError):  # not every system can refuse a process more
        import resource

        most = int(ready.spec.memory * 1e9)
        resource.setrlimit(resource.RLIMIT_DATA, (most, resource.getrlimit(resource.RLIMIT_DATA)[1]))
    with open(os.devnull, "w") as nowhere:
        faulthandler.dump_traceback_later(WORKERS.patience * ready.spec.seconds, exit=True, file=nowhere)
        signal.setitimer(signal.ITIMER_PROF, ready.spec.seconds)  # its signal ends a process that does not expect it
        try:
            return make(ready, task.index, task.attempt, meshes)
        except MemoryError:
            return Made(f"took more than {ready.spec.memory:g} GB of memory")
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
            faulthandler.cancel_dump_traceback_later()


class Ray:
    """Tasks of a Ray cluster.

    Args:
        address: Of the cluster; "local" starts one on this machine that ends with it.
        most: Most tasks under way; as many as the cluster has processors if None.
    """

    def __init__(self, ready: Ready, address: str, most: int | None = None) -> None:
        import ray

        self.ray: Any = ray
        self.mine = not ray.is_initialized()
        if self.mine:
            given: dict[str, Any] = {"address": address} if address != "local" else {"num_cpus": most}
            try:
                ray.init(**given, include_dashboard=False, log_to_driver=False, logging_level=logging.ERROR)
            except (ConnectionError, ValueError, RuntimeError) as error:
                raise InputError(f"there is no Ray cluster at {address!r}: {str(error).splitlines()[0]}") from None
        processors = int(ray.cluster_resources().get("CPU", 1))
        self.slots = WORKERS.ahead * min(most or processors, processors)
        meshes = {name: path.read_bytes() for name, path in ready.meshes.items()}
        self.given = (ray.put(ready), [ray.put(meshes)])
        self.function: Any = ray.remote(num_cpus=1, max_retries=0, max_calls=WORKERS.renewed)(_task)
        self.waiting: dict[Any, Task] = {}

    def send(self, task: Task) -> None:
        """Submit a try."""
        self.waiting[self.function.remote(*self.given, task)] = task

    def done(self) -> Iterator[tuple[Task, Made | None]]:
        """Yield what tasks have made, and the tries of those whose process or node has ended."""
        found, _ = self.ray.wait(list(self.waiting), timeout=WORKERS.tick) if self.waiting else ([], [])
        for reference in found:
            task = self.waiting.pop(reference)
            try:
                yield task, cast(Made, self.ray.get(reference))
            except self.ray.exceptions.RayTaskError as error:  # a mistake of ours is not hidden
                raise error.as_instanceof_cause() from None
            except self.ray.exceptions.RayError:
                yield task, None

    def close(self) -> None:
        """Take back what is not done, and leave the cluster."""
        for reference in self.waiting:
            self.ray.cancel(reference, force=True)
        if self.mine:
            self.ray.shutdown()


Workers = Local | Ray
"""Who makes rooms: `send` begins a try, `done` yields what has become of tries, `close` ends everything."""


def check_cluster(address: str) -> None:
    """Refuse, before any work, an address at which nobody answers; Ray itself would wait many minutes and end the program."""
    if find_spec("ray") is None:
        raise MissingExtraError("--cluster ray", "ray")
    host, _, port = address.removeprefix("ray://").rpartition(":")
    if not host:
        return
    try:
        socket.create_connection((host, int(port)), WORKERS.answer).close()
    except (OSError, ValueError, OverflowError) as error:
        raise InputError(
            f"there is no Ray cluster at {address!r}: {error}; give HOST:PORT of its head, or local."
        ) from None


def _task(ready: Ready, meshes: list[Any], task: Task) -> Made:
    """Make one try at a room on a node of a cluster."""
    return bounded(ready, task, _shelf(meshes[0]))


@cache
def _shelf(reference: Any) -> Path:
    """Return a folder of this process with the meshes of a batch."""
    import ray

    folder = Path(mkdtemp(prefix="robolayout-meshes-"))
    for name, data in cast("Mapping[str, bytes]", ray.get(reference)).items():
        write_atomic(folder / name, data)
    return folder
